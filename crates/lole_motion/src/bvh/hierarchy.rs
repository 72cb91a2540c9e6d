//! The part of a BVH file that says how joints hang together.

use glam::{Quat, Vec3};

use super::lines::{Lines, shortened};
use super::{Channel, DEEPEST, MOST_JOINTS};
use crate::{Joint, RecordingError};

/// Joints, and the channels of each in the order of the file.
pub(super) struct Skeleton {
    pub(super) joints: Vec<Joint>,
    pub(super) channels: Vec<Vec<Channel>>,
}

impl Skeleton {
    pub(super) fn channel_count(&self) -> usize {
        self.channels.iter().map(Vec::len).sum()
    }
}

/// Reads up to the line `MOTION`, which is consumed.
pub(super) fn read(lines: &mut Lines<'_>) -> Result<Skeleton, RecordingError> {
    let first = lines.expect("HIERARCHY")?;
    if !first.eq_ignore_ascii_case("HIERARCHY") {
        return Err(lines.error(
            "BVH ファイルではありません。HIERARCHY で始まるはずです",
            "this is no BVH file, which begins with HIERARCHY",
        ));
    }
    let mut reader = Reader {
        skeleton: Skeleton {
            joints: Vec::new(),
            channels: Vec::new(),
        },
        open: Vec::new(),
        named: None,
    };
    loop {
        let line = lines.expect("MOTION")?;
        if reader.open.is_empty() && reader.named.is_none() && is_motion(line) {
            break;
        }
        reader.read_line(line, lines)?;
    }
    if reader.skeleton.joints.is_empty() {
        return Err(lines.error("ROOT がありません", "there is no ROOT before MOTION"));
    }
    Ok(reader.skeleton)
}

fn is_motion(line: &str) -> bool {
    line.trim_end_matches(':').eq_ignore_ascii_case("MOTION")
}

struct Reader {
    skeleton: Skeleton,
    /// Joints whose braces are open.
    open: Vec<usize>,
    /// A joint that was named and whose brace has not come yet.
    named: Option<usize>,
}

impl Reader {
    /// Reads one line, which may hold braces beside a keyword.
    fn read_line(&mut self, line: &str, lines: &Lines<'_>) -> Result<(), RecordingError> {
        let mut rest = line;
        while !rest.is_empty() {
            let end = match rest.find(['{', '}']) {
                Some(0) => {
                    if rest.starts_with('{') {
                        self.open(lines)?;
                    } else {
                        self.close(lines)?;
                    }
                    1
                }
                found => {
                    let end = found.unwrap_or(rest.len());
                    self.statement(rest[..end].trim(), lines)?;
                    end
                }
            };
            rest = rest[end..].trim_start();
        }
        Ok(())
    }

    fn open(&mut self, lines: &Lines<'_>) -> Result<(), RecordingError> {
        let named = self.named.take();
        let named = named
            .ok_or_else(|| lines.error("関節の名前のない { です", "this { belongs to no joint"))?;
        self.open.push(named);
        if DEEPEST < self.open.len() {
            return Err(RecordingError::TooLarge {
                what: "levels of joints",
                count: self.open.len(),
                limit: DEEPEST,
            });
        }
        Ok(())
    }

    fn close(&mut self, lines: &Lines<'_>) -> Result<(), RecordingError> {
        if self.named.is_some() || self.open.pop().is_none() {
            return Err(lines.error("対応する { のない } です", "this } closes nothing"));
        }
        Ok(())
    }

    fn statement(&mut self, text: &str, lines: &Lines<'_>) -> Result<(), RecordingError> {
        let (keyword, rest) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
        if self.named.is_some() {
            return Err(lines.error("{ が抜けています", "a { is missing before this"));
        }
        match keyword.to_ascii_uppercase().as_str() {
            "ROOT" => self.joint(rest.trim(), None, lines),
            "JOINT" => {
                let parent = self.innermost(lines)?;
                self.joint(rest.trim(), Some(parent), lines)
            }
            "END" => {
                let parent = self.innermost(lines)?;
                self.joint("", Some(parent), lines)
            }
            "OFFSET" => self.offset(rest, lines),
            "CHANNELS" => self.channels(rest, lines),
            _ => {
                let word = shortened(keyword);
                Err(lines.error(
                    format!("「{word}」はここに書けません。JOINT, End Site, OFFSET, CHANNELS, MOTION のどれかです"),
                    format!("\"{word}\" cannot stand here; JOINT, End Site, OFFSET, CHANNELS or MOTION can"),
                ))
            }
        }
    }

    /// The joint whose braces are open.
    fn innermost(&self, lines: &Lines<'_>) -> Result<usize, RecordingError> {
        let innermost = self.open.last().copied();
        innermost.ok_or_else(|| {
            lines.error(
                "関節の { } の外です",
                "this stands outside the braces of any joint",
            )
        })
    }

    fn joint(
        &mut self,
        name: &str,
        parent: Option<usize>,
        lines: &Lines<'_>,
    ) -> Result<(), RecordingError> {
        if parent.is_none() && !self.open.is_empty() {
            return Err(lines.error(
                "ROOT が関節の中にあります。} が抜けています",
                "a ROOT stands within a joint; a } is missing before it",
            ));
        }
        let count = self.skeleton.joints.len();
        if MOST_JOINTS <= count {
            return Err(RecordingError::TooLarge {
                what: "joints",
                count: count + 1,
                limit: MOST_JOINTS,
            });
        }
        self.named = Some(count);
        self.skeleton.channels.push(Vec::new());
        self.skeleton.joints.push(Joint {
            name: name.to_owned(),
            parent,
            translation: Vec3::ZERO,
            rotation: Quat::IDENTITY,
            channel_count: 0,
        });
        Ok(())
    }

    #[expect(
        clippy::cast_possible_truncation,
        reason = "numbers are bounded where they are read"
    )]
    fn offset(&mut self, rest: &str, lines: &Lines<'_>) -> Result<(), RecordingError> {
        let joint = self.innermost(lines)?;
        let numbers: Vec<f64> = rest
            .split_whitespace()
            .map(|word| lines.number(word))
            .collect::<Result<_, _>>()?;
        let [x, y, z] = numbers[..] else {
            return Err(lines.error(
                format!("OFFSET には数が3つ要りますが、{} つです", numbers.len()),
                format!("OFFSET takes three numbers, and here are {}", numbers.len()),
            ));
        };
        self.skeleton.joints[joint].translation = Vec3::new(x as f32, y as f32, z as f32);
        Ok(())
    }

    fn channels(&mut self, rest: &str, lines: &Lines<'_>) -> Result<(), RecordingError> {
        let joint = self.innermost(lines)?;
        let mut words = rest.split_whitespace();
        let count = words.next().and_then(|word| word.parse::<u8>().ok());
        let channels: Vec<Channel> = words
            .map(|word| channel(word, lines))
            .collect::<Result<_, _>>()?;
        let twice = (1..channels.len()).any(|i| channels[..i].contains(&channels[i]));
        let known = &mut self.skeleton.channels[joint];
        if !known.is_empty() || twice {
            return Err(lines.error(
                "同じチャンネルが2度書かれています",
                "a channel of this joint stands there twice",
            ));
        }
        let written = count.filter(|&count| usize::from(count) == channels.len());
        let Some(written) = written else {
            return Err(lines.error(
                "CHANNELS の数と、続く名前の数が違います",
                "the number after CHANNELS is not that of the names that follow",
            ));
        };
        *known = channels;
        self.skeleton.joints[joint].channel_count = written;
        Ok(())
    }
}

fn channel(word: &str, lines: &Lines<'_>) -> Result<Channel, RecordingError> {
    let name = word.to_ascii_lowercase();
    let axis = match name.as_bytes().first() {
        Some(b'x') => Some(0),
        Some(b'y') => Some(1),
        Some(b'z') => Some(2),
        _ => None,
    };
    match (axis, name.get(1..)) {
        (Some(axis), Some("position")) => Ok(Channel::Position(axis)),
        (Some(axis), Some("rotation")) => Ok(Channel::Rotation(axis)),
        _ => {
            let word = shortened(word);
            Err(lines.error(
                format!("「{word}」というチャンネルはありません。Xposition や Zrotation のように書きます"),
                format!("there is no channel \"{word}\"; channels are such as Xposition or Zrotation"),
            ))
        }
    }
}
