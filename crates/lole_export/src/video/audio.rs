//! A song for the film: the compressed sound of an MP4 file, taken over as it is.
//!
//! Nothing is decoded. AAC and Opus in MP4 (`.m4a`, `.mp4`, `.mov`) are what every player of an MP4
//! film plays; of a song in another form the error says how to make one.

use lole_language::Bilingual;
use mp4_atom::{
    Atom, Co64, Codec, Elst, Hdlr, Header, Mdhd, Mp4a, Opus, Stco, Stsc, Stsz, StszSamples, Stts,
    SttsEntry,
};

/// Sounds of a song at most: an hour of AAC has 170,000.
const MOST_SAMPLES: usize = 10_000_000;

/// Why a song cannot be put under a film.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum AudioError {
    /// The file is no MP4.
    #[error(
        "the song is not AAC or Opus in an MP4 file; make one with `ffmpeg -i SONG -vn -c:a aac song.m4a`"
    )]
    NotMp4,
    /// The file has no sound.
    #[error("the file has no sound; choose the song itself")]
    NoSound,
    /// The sound is coded in a way that players do not expect in a film.
    #[error(
        "the sound in the file is neither AAC nor Opus; make a song of it with `ffmpeg -i SONG -vn -c:a aac song.m4a`"
    )]
    Codec,
    /// The file ends early or contradicts itself.
    #[error("the song is damaged: {what}; copy the file again, or save it anew")]
    Damaged {
        /// What does not fit.
        what: &'static str,
    },
}

impl Bilingual for AudioError {
    fn japanese(&self) -> String {
        match self {
            Self::NotMp4 => "曲が MP4 の AAC・Opus ではありません。`ffmpeg -i 曲 -vn -c:a aac song.m4a` で作れます".to_owned(),
            Self::NoSound => "このファイルには音が入っていません。曲のファイルを選んでください".to_owned(),
            Self::Codec => "このファイルの音は AAC でも Opus でもありません。`ffmpeg -i 曲 -vn -c:a aac song.m4a` で作れます".to_owned(),
            Self::Damaged { .. } => "曲のファイルが壊れています。もう一度コピーするか、保存し直してください".to_owned(),
        }
    }
}

/// A song whose sound is still compressed.
#[derive(Debug, Clone, PartialEq)]
pub struct Song {
    /// How it is coded.
    pub(super) codec: Codec,
    /// Ticks a second.
    pub(super) timescale: u32,
    /// Ticks at the beginning that only prime the decoder and are not heard.
    pub(super) priming: u64,
    /// Duration of each sample [tick].
    pub(super) durations: Vec<u32>,
    /// Bytes of each sample.
    pub(super) sizes: Vec<u32>,
    /// The samples, one after the other.
    pub(super) data: Vec<u8>,
}

const DAMAGED_TABLE: AudioError = AudioError::Damaged {
    what: "its tables contradict each other",
};

impl Song {
    /// Reads the first sound of an MP4 file.
    ///
    /// # Errors
    /// What is wrong with the file, and what to do about it.
    pub fn read(file: &[u8]) -> Result<Self, AudioError> {
        // A box at the start of every MP4; QuickTime's older ones begin with another.
        if !matches!(file.get(4..8), Some(b"ftyp" | b"moov" | b"wide" | b"free")) {
            return Err(AudioError::NotMp4);
        }
        let movie = child(file, b"moov").ok_or(AudioError::Damaged {
            what: "it has no index",
        })?;
        let sound = children(movie)
            .filter(|(kind, _)| kind == b"trak")
            .find(|(_, track)| is_sound(track));
        let (_, track) = sound.ok_or(AudioError::NoSound)?;
        let table = path(track, &[b"mdia", b"minf", b"stbl"]).ok_or(DAMAGED_TABLE)?;
        let codec = codec(table)?;
        let media = child(track, b"mdia").ok_or(DAMAGED_TABLE)?;
        let timescale = read::<Mdhd>(media, b"mdhd")?.timescale;
        if timescale == 0 {
            return Err(DAMAGED_TABLE);
        }
        let sizes = sizes(table, file.len())?;
        let durations = durations(table, sizes.len())?;
        let data = gather(file, table, &sizes)?;
        Ok(Self {
            codec,
            timescale,
            priming: priming(track),
            durations,
            sizes,
            data,
        })
    }

    /// Its length that is heard [s].
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "a song has far fewer ticks")]
    pub fn seconds(&self) -> f64 {
        let ticks: u64 = self.durations.iter().copied().map(u64::from).sum();
        ticks.saturating_sub(self.priming) as f64 / f64::from(self.timescale)
    }

    /// Leaves out what begins after so many seconds.
    pub(super) fn cut(&mut self, seconds: f64) {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a film has seconds, at most hours"
        )]
        let end = (seconds.max(0.0) * f64::from(self.timescale)).ceil() as u64 + self.priming;
        let mut time = 0;
        let kept = (self.durations.iter())
            .take_while(|&&duration| {
                let begins = time;
                time += u64::from(duration);
                begins < end
            })
            .count();
        self.durations.truncate(kept);
        self.sizes.truncate(kept);
        let bytes: usize = self.sizes.iter().map(|&size| size as usize).sum();
        self.data.truncate(bytes);
    }

    /// How long each sample lasts, in runs of equal ones.
    pub(super) fn duration_runs(&self) -> Vec<SttsEntry> {
        (self.durations.chunk_by(|one, next| one == next))
            .map(|run| SttsEntry {
                sample_count: u32::try_from(run.len()).unwrap_or(u32::MAX),
                sample_delta: run[0],
            })
            .collect()
    }
}

/// The boxes in a box, each with its kind and what it holds; what is cut off ends them.
fn children(mut body: &[u8]) -> impl Iterator<Item = ([u8; 4], &[u8])> {
    use mp4_atom::DecodeMaybe as _;
    std::iter::from_fn(move || {
        let mut rest = body;
        let header = Header::decode_maybe(&mut rest).ok()??;
        let size = header.size.unwrap_or(rest.len());
        let inside = rest.get(..size)?;
        body = &rest[size..];
        Some((*header.kind.as_ref(), inside))
    })
}

fn child<'a>(body: &'a [u8], kind: &[u8; 4]) -> Option<&'a [u8]> {
    let mut found = children(body).filter(|(of_kind, _)| of_kind == kind);
    found.next().map(|(_, inside)| inside)
}

fn path<'a>(body: &'a [u8], kinds: &[&[u8; 4]]) -> Option<&'a [u8]> {
    kinds.iter().try_fold(body, |body, kind| child(body, kind))
}

/// A box of a known kind that is a list. Its entries have `least` bytes or more, which bounds how many
/// there are before any is made: the count alone is not to be trusted.
fn list<A: Atom>(body: &[u8], kind: &[u8; 4], least: usize) -> Result<A, AudioError> {
    let inside = child(body, kind).ok_or(DAMAGED_TABLE)?;
    // Version and flags stand before it.
    let count = inside.get(4..8).and_then(|count| count.try_into().ok());
    let count = count.map_or(u32::MAX, u32::from_be_bytes);
    if inside.len() / least < count as usize {
        return Err(DAMAGED_TABLE);
    }
    read(body, kind)
}

/// A box of a known kind.
fn read<A: Atom>(body: &[u8], kind: &[u8; 4]) -> Result<A, AudioError> {
    let mut inside = child(body, kind).ok_or(DAMAGED_TABLE)?;
    A::decode_body(&mut inside).map_err(|_| DAMAGED_TABLE)
}

fn is_sound(track: &[u8]) -> bool {
    let media = child(track, b"mdia");
    let handler = media.and_then(|media| read::<Hdlr>(media, b"hdlr").ok());
    handler.is_some_and(|handler| handler.handler == b"soun".into())
}

/// Where in the sound the song begins [tick].
fn priming(track: &[u8]) -> u64 {
    let edits = path(track, &[b"edts"]).and_then(|edits| list::<Elst>(edits, b"elst", 12).ok());
    let entries = edits.map(|edits| edits.entries).unwrap_or_default();
    let first = entries.iter().find_map(|entry| entry.media_time);
    first.unwrap_or(0)
}

/// How the sound is coded: the first entry of the list of codecs.
///
/// Only the boxes that belong there are read: in others, which nobody needs, the reader takes counts of
/// billions on trust.
fn codec(table: &[u8]) -> Result<Codec, AudioError> {
    const KNOWN: [&[u8; 4]; 5] = [b"esds", b"dOps", b"btrt", b"taic", b"wave"];
    let listed = child(table, b"stsd").and_then(|list| list.get(8..));
    let (kind, entry) = listed
        .and_then(|entries| children(entries).next())
        .ok_or(DAMAGED_TABLE)?;
    if !matches!(&kind, b"mp4a" | b"Opus") {
        return Err(AudioError::Codec);
    }
    // QuickTime's later versions say more before the boxes begin.
    let begin = match entry.get(8..10) {
        Some([0, 0]) => 28,
        Some([0, 1]) => 28 + 16,
        Some([0, 2]) => 28 + 36,
        _ => return Err(DAMAGED_TABLE),
    };
    let mut plain = entry.get(..begin).ok_or(DAMAGED_TABLE)?.to_vec();
    for (kind, inside) in children(&entry[begin..]) {
        if KNOWN.contains(&&kind) {
            let size = u32::try_from(8 + inside.len()).map_err(|_| DAMAGED_TABLE)?;
            plain.extend_from_slice(&size.to_be_bytes());
            plain.extend_from_slice(&kind);
            plain.extend_from_slice(inside);
        }
    }
    let mut plain = plain.as_slice();
    let codec = if &kind == b"mp4a" {
        Mp4a::decode_body(&mut plain).map(Codec::Mp4a)
    } else {
        Opus::decode_body(&mut plain).map(Codec::Opus)
    };
    codec.map_err(|_| DAMAGED_TABLE)
}

/// Bytes of each sample.
fn sizes(table: &[u8], file_len: usize) -> Result<Vec<u32>, AudioError> {
    // Every sample has a byte at least, and the list of equal ones is not written out in the file.
    let most = file_len.min(MOST_SAMPLES);
    match read::<Stsz>(table, b"stsz")?.samples {
        StszSamples::Identical { count, size } if 0 < size && count as usize <= most => {
            Ok(vec![size; count as usize])
        }
        StszSamples::Different { sizes } if sizes.len() <= most => Ok(sizes),
        _ => Err(DAMAGED_TABLE),
    }
}

/// Duration of each of `count` samples [tick].
fn durations(table: &[u8], count: usize) -> Result<Vec<u32>, AudioError> {
    let mut durations = Vec::new();
    for entry in list::<Stts>(table, b"stts", 8)?.entries {
        let room = count - durations.len();
        let run = (entry.sample_count as usize).min(room);
        durations.extend(std::iter::repeat_n(entry.sample_delta, run));
    }
    if durations.len() == count && 0 < count {
        Ok(durations)
    } else {
        Err(DAMAGED_TABLE)
    }
}

/// The samples, from where their chunks lie in the file.
fn gather(file: &[u8], table: &[u8], sizes: &[u32]) -> Result<Vec<u8>, AudioError> {
    let offsets: Vec<u64> = match list::<Stco>(table, b"stco", 4) {
        Ok(chunks) => chunks.entries.into_iter().map(u64::from).collect(),
        Err(_) => list::<Co64>(table, b"co64", 8)?.entries,
    };
    let runs = list::<Stsc>(table, b"stsc", 12)?.entries;
    let mut run = 0;
    let (mut sizes, mut data) = (sizes.iter(), Vec::new());
    for (number, &offset) in (1_u32..).zip(&offsets) {
        while runs
            .get(run + 1)
            .is_some_and(|next| next.first_chunk <= number)
        {
            run += 1;
        }
        let of_chunk = runs.get(run).ok_or(DAMAGED_TABLE)?.samples_per_chunk;
        let mut start = usize::try_from(offset).map_err(|_| DAMAGED_TABLE)?;
        for &size in sizes.by_ref().take(of_chunk as usize) {
            let end = start.checked_add(size as usize).ok_or(DAMAGED_TABLE)?;
            let cut_off = AudioError::Damaged {
                what: "it ends before its sound does",
            };
            data.extend_from_slice(file.get(start..end).ok_or(cut_off)?);
            start = end;
            // Chunks that lie on each other would make more of a file than there is.
            if file.len() < data.len() {
                return Err(DAMAGED_TABLE);
            }
        }
    }
    if sizes.next().is_none() {
        Ok(data)
    } else {
        Err(DAMAGED_TABLE)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::video::mp4::{Track, head};
    use mp4_atom::{Audio, FixedPoint, esds};

    fn song() -> Song {
        let codec = Codec::Mp4a(Mp4a {
            audio: Audio {
                data_reference_index: 1,
                channel_count: 2,
                sample_size: 16,
                sample_rate: FixedPoint::from(48_000),
            },
            esds: mp4_atom::Esds {
                es_desc: esds::EsDescriptor {
                    es_id: 2,
                    dec_config: esds::DecoderConfig {
                        object_type_indication: 0x40,
                        stream_type: 5,
                        dec_specific: Some(esds::DecoderSpecific {
                            profile: 2,
                            freq_index: 3,
                            chan_conf: 2,
                            raw: vec![0x11, 0x90],
                        }),
                        ..Default::default()
                    },
                    ..Default::default()
                },
            },
            btrt: None,
            taic: None,
        });
        let sizes: Vec<u32> = (0..94).map(|index| 3 + index % 5).collect();
        let total: u32 = sizes.iter().sum();
        Song {
            codec,
            timescale: 48_000,
            priming: 1024,
            durations: vec![1024; 94],
            data: (0..=255).cycle().take(total as usize).collect(),
            sizes,
        }
    }

    /// A film of a second and a half with the song under it.
    fn film(song: &Song) -> Vec<u8> {
        let track = Track {
            size: [64, 64],
            fps: 30,
            sequence_parameters: &[0x67, 66, 0, 30],
            picture_parameters: &[0x68],
            sample_sizes: &[2; 45],
            keyframes: &[0],
            song: Some(song),
        };
        let mut bytes = head(&track).unwrap();
        bytes.extend([7; 90]);
        bytes.extend(&song.data);
        bytes
    }

    #[test]
    fn a_song_comes_out_of_a_film_as_it_went_in() {
        let song = song();
        assert_eq!(Song::read(&film(&song)), Ok(song));
    }

    #[test]
    fn a_song_ends_with_the_film() {
        let mut song = song();
        assert!((song.seconds() - 93.0 * 1024.0 / 48_000.0).abs() < 1e-9);
        song.cut(1.5);
        // The last sound begins before the end.
        assert_eq!(song.durations.len(), 72);
        let bytes: u32 = song.sizes.iter().sum();
        assert_eq!(song.data.len(), bytes as usize);
        assert!(1.5 - 1024.0 / 48_000.0 <= song.seconds());
        let whole = song.clone();
        song.cut(1e9);
        assert_eq!(song, whole);
    }

    #[test]
    fn what_is_no_song_is_refused_in_a_sentence() {
        assert_eq!(Song::read(b"ID3 an MP3"), Err(AudioError::NotMp4));
        assert_eq!(Song::read(&[]), Err(AudioError::NotMp4));
        let file = film(&song());
        for end in (8..file.len()).step_by(7) {
            assert!(Song::read(&file[..end]).is_err(), "cut at {end}");
        }
    }

    #[test]
    fn a_changed_byte_never_breaks_the_reader() {
        let file = film(&song());
        for place in 0..file.len() {
            for value in [0, 1, 0x7f, 0xff] {
                let mut changed = file.clone();
                changed[place] = value;
                if let Ok(song) = Song::read(&changed) {
                    assert!(song.data.len() <= file.len());
                }
            }
        }
    }

    /// Found by fuzzing: groups of no length, billions of them, where a codec was expected took all
    /// memory; beside the codec's own boxes they are passed over.
    #[test]
    fn no_list_is_longer_than_its_box() {
        let file = film(&song());
        let at = |kind: &[u8; 4]| file.windows(4).rposition(|four| four == kind).unwrap();
        for (place, expected) in [
            (at(b"mp4a"), AudioError::Codec),
            (at(b"esds"), DAMAGED_TABLE),
        ] {
            let mut changed = file.clone();
            changed[place..place + 4].copy_from_slice(b"sgpd");
            changed[place + 4..place + 20].fill(0xea);
            assert_eq!(Song::read(&changed), Err(expected));
        }
        let mut changed = file.clone();
        let stts = at(b"stts");
        changed[stts + 8..stts + 12].fill(0xff);
        assert_eq!(Song::read(&changed), Err(DAMAGED_TABLE));
    }
}
