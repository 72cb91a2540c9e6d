//! How a gathered rectangle is sewn: the steps of a pāʻū skirt or top, with the draft's own numbers.
//!
//! Makers' published notes agree on the order: cut, mark, close the ring, fold and stitch the band,
//! hem, thread the elastics. Times are estimates, by the length of stitching: 34 m of it make a
//! machine-sewn skirt of two to three hours and a hand-sewn one of ten to fifteen.

use lole_geom::Length;
use lole_language::{Sentence, words};

use super::pau_skirt::{PauDraft, PauLine};
use crate::pattern::{Step, StepFigure};
use crate::piece::hem_turns;

/// Pinning and sewing a meter of straight seam with a machine, and by hand [min/m]. Estimates: makers
/// sew 1.5 to 4 m an hour by hand.
const MINUTES_PER_METER: [f64; 2] = [2.5, 24.0];

/// Indices of the piece and of its one seam in the pattern.
const PANEL: usize = 0;
const CLOSING: usize = 0;

/// What is sewn onto a skirt before its elastics are drawn in, and what that changes of its own steps.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Sewn {
    /// The steps.
    pub steps: Vec<Step>,
    /// Where on the skirt it is sewn, below the raw upper edge; its mark is the last of the piece. `None`
    /// where it is sewn to the lower edge, which is not hemmed then.
    pub placement: Option<Length>,
    /// How far it reaches below the lower edge of the skirt.
    pub below: Length,
}

/// The steps of a draft, in order, with what else is sewn on.
pub(super) fn steps(draft: &PauDraft, sewn: Option<Sewn>) -> Vec<Step> {
    let mut steps = vec![
        press(),
        cut(draft),
        mark(draft, sewn.as_ref()),
        close(draft),
        fold_band(draft),
        stitch_casings(draft),
    ];
    steps.extend(tape(draft));
    if sewn.as_ref().is_none_or(|sewn| sewn.placement.is_some()) {
        steps.push(hem(draft));
    }
    let below = sewn.as_ref().map_or(Length::ZERO, |sewn| sewn.below);
    steps.extend(sewn.into_iter().flat_map(|sewn| sewn.steps));
    steps.extend([thread_elastic(draft), finish(draft.finished_length + below)]);
    steps
}

fn cm(length: Length) -> String {
    format!("{:.1}", length.to_cm())
}

/// Times of `fixed` minutes and of stitching `length`.
fn minutes(fixed: f64, length: Length) -> [f64; 2] {
    MINUTES_PER_METER.map(|rate| fixed + rate * length.to_m())
}

fn press() -> Step {
    Step {
        title: words("布を整える", "Prepare the cloth"),
        by_machine: Sentence::new(
            "綿やレーヨンの布は、先に一度水に通して縮ませます。布目をまっすぐにして、裏からアイロンをかけます。",
            "Wash cotton and rayon once before cutting, so that they shrink now and not later. Pull the weave straight and press the cloth from the wrong side.",
        ),
        by_hand: None,
        figure: StepFigure::None,
        cuts: false,
        minutes: [20.0, 20.0],
    }
}

fn cut(draft: &PauDraft) -> Step {
    let (length, height) = (cm(draft.cut_length), cm(draft.cut_height));
    let [across, up] = [draft.cut_length, draft.cut_height];
    Step {
        title: words("裁つ", "Cut"),
        by_machine: Sentence::new(
            format!(
                "耳に沿って長さ {length} cm、耳と直角に高さ {height} cm の長方形を1枚裁ちます。耳に沿う方向が体をまわる方向、布幅の方向が丈になります。柄に上下があるときは、裾になる側をたしかめてから裁ちます。"
            ),
            format!(
                "Cut one rectangle, {length} cm along the selvage and {height} cm across the cloth. The direction along the selvage goes around the body, the width of the cloth becomes the height. If the print has a right way up, make sure which side becomes the hem before you cut."
            ),
        ),
        by_hand: None,
        figure: StepFigure::Piece {
            piece: PANEL,
            edges: vec![0, 1, 2, 3],
            marks: Vec::new(),
        },
        cuts: true,
        // Measuring and cutting go along the edge about as fast.
        minutes: [10.0 + 2.0 * (across + up).to_m(); 2],
    }
}

fn mark(draft: &PauDraft, sewn: Option<&Sewn>) -> Step {
    let placement = sewn.and_then(|sewn| sewn.placement);
    let is_hemmed = sewn.is_none() || placement.is_some();
    let count = draft.lines.len() - usize::from(!is_hemmed);
    let (hem, above) = match draft.lines[..count].split_last() {
        Some((last, above)) if is_hemmed => (Some(last.from_edge), above),
        _ => (None, &draft.lines[..count]),
    };
    // Casings of the band are drawn once it is folded: on the cloth they would lie under the fold.
    let (band, tapes) = (2, 2 + 2 * draft.band_row_count);
    let (head, taped) = (&above[..band.min(above.len())], above.get(tapes..));
    let taped = taped.unwrap_or_default();
    let distances: Vec<String> = (head.iter().chain(taped).map(|line| line.from_edge))
        .chain(placement)
        .chain(hem)
        .map(cm)
        .collect();
    let lines = |separator: &str| distances.join(separator);
    let names = [
        Some(words("折り代", "the turned edge")),
        Some(words("上の折り山", "the top fold")),
        (!taped.is_empty()).then_some(words("テープの縫い線", "the stitches of the tapes")),
        placement.map(|_| words("フリルの付け位置", "the line for the ruffle")),
        hem.map(|_| words("裾の折り線", "the hem fold")),
    ];
    let names: Vec<_> = names.into_iter().flatten().collect();
    let japanese: Vec<&str> = names.iter().map(|name| name.japanese).collect();
    let english: Vec<&str> = names.iter().map(|name| name.english).collect();
    let (japanese, english) = (japanese.join("、"), english.join(", "));
    let placement = placement.map(|_| draft.lines.len());
    Step {
        title: words("しるしをつける", "Mark"),
        by_machine: Sentence::new(
            format!(
                "布の裏に、上の切り口から {} cm のところへ、チャコで線を引きます。順に、{japanese}です。",
                lines("、")
            ),
            format!(
                "On the wrong side, draw chalk lines at {} cm from the upper raw edge. In this order they are {english}.",
                lines(", ")
            ),
        ),
        by_hand: None,
        figure: StepFigure::Piece {
            piece: PANEL,
            edges: Vec::new(),
            marks: (0..band).chain(tapes..count).chain(placement).collect(),
        },
        cuts: false,
        minutes: [20.0, 20.0],
    }
}

fn close(draft: &PauDraft) -> Step {
    let allowance = (draft.cut_length - draft.flat_length) * 0.5;
    let openings = openings(draft);
    let list = |separator: &str| {
        let ranges = openings
            .iter()
            .map(|&[from, to]| format!("{}–{} cm", cm(from), cm(to)));
        ranges.collect::<Vec<_>>().join(separator)
    };
    Step {
        title: words("輪に縫う", "Close the ring"),
        by_machine: Sentence::new(
            format!(
                "中表に合わせて両端をそろえ、縫い代 {} cm で縫います。ゴムを通す口として、上の切り口から測って {} の間は縫わずにあけ、前後を返し縫いします。縫い代の端をジグザグミシンで始末し、アイロンで割ります。",
                cm(allowance),
                list("、")
            ),
            format!(
                "Put the two ends together, right sides facing, and sew them with a seam allowance of {} cm. Leave the seam open, measured from the upper raw edge, at {}, for the elastic, and stitch back and forth at both ends of each gap. Neaten the allowances with a zigzag stitch and press them open.",
                cm(allowance),
                list(", ")
            ),
        ),
        by_hand: Some(Sentence::new(
            "半返し縫いで縫い、縫い代の端はかがり縫いで始末します。",
            "Sew the seam with half backstitches and overcast the raw edges.",
        )),
        figure: StepFigure::Seams(vec![CLOSING]),
        cuts: false,
        // The seam, and both of its edges neatened.
        minutes: minutes(10.0, draft.cut_height * 3.0),
    }
}

/// Stretches of the closing seam that stay open, from the raw upper edge: where the casings of the
/// band are on its inside, mirrored at the top fold.
fn openings(draft: &PauDraft) -> Vec<[Length; 2]> {
    let fold = from_edge(draft, PauLine::TopFold);
    let below = |kind| {
        let lines = draft.lines.iter().filter(move |line| line.kind == kind);
        lines.map(move |line| line.from_edge - fold)
    };
    below(PauLine::CasingTop)
        .zip(below(PauLine::CasingBottom))
        .take(draft.band_row_count)
        .map(|(top, bottom)| [fold - bottom, fold - top])
        .collect()
}

fn from_edge(draft: &PauDraft, kind: PauLine) -> Length {
    let line = draft.lines.iter().find(|line| line.kind == kind);
    line.map_or(Length::ZERO, |line| line.from_edge)
}

fn fold_band(draft: &PauDraft) -> Step {
    let (turn, depth) = (
        cm(from_edge(draft, PauLine::TurnUnder)),
        cm(draft.fold_depth),
    );
    Step {
        title: words("上を折る", "Fold the band"),
        by_machine: Sentence::new(
            format!(
                "上の切り口を裏へ {turn} cm 折ってアイロンをかけます。つぎに折り山で裏へ {depth} cm 折り、アイロンで折り目をつけ、まち針でとめます。"
            ),
            format!(
                "Press {turn} cm of the upper raw edge to the wrong side. Then fold {depth} cm to the wrong side at the top fold, press, and pin."
            ),
        ),
        by_hand: None,
        figure: StepFigure::Section {
            piece: PANEL,
            marks: vec![0, 1],
        },
        cuts: false,
        minutes: [20.0, 20.0],
    }
}

fn stitch_casings(draft: &PauDraft) -> Step {
    let count = draft.band_row_count;
    let fold = from_edge(draft, PauLine::TopFold);
    let lines = draft.lines.iter().skip(2).take(2 * count);
    let below: Vec<String> = lines.map(|line| cm(line.from_edge - fold)).collect();
    // The lowest one is not drawn: it follows the folded edge.
    let drawn = &below[..below.len().saturating_sub(1)];
    let (japanese, english) = (drawn.join("、"), drawn.join(", "));
    Step {
        title: words("ゴム通しを縫う", "Stitch the casings"),
        by_machine: Sentence::new(
            format!(
                "裏に出ている折り返しに、上の折り山から {japanese} cm の線をチャコで引き、ぐるりと縫います。いちばん下は、折った端から 0.2 cm 内側を縫います。ゴム通し {count} 段の上と下で {} 周です。縫い始めと終わりは返し縫いします。",
                2 * count
            ),
            format!(
                "On the folded band, which lies on the wrong side, draw chalk lines {english} cm below the top fold and sew all around along them. Sew the lowest round 0.2 cm inside the folded edge. One above and one below {} make {} rounds. Stitch back and forth where each round begins and ends.",
                if count == 1 {
                    "the casing".to_owned()
                } else {
                    format!("each of the {count} casings")
                },
                2 * count
            ),
        ),
        by_hand: Some(Sentence::new(
            "細かいぐし縫いで縫い、20 cm ごとに一針返します。",
            "Sew small running stitches, with one backstitch every 20 cm.",
        )),
        figure: StepFigure::Section {
            piece: PANEL,
            marks: (0..2 + 2 * count).collect(),
        },
        cuts: false,
        minutes: minutes(5.0, draft.flat_length * rounds(count)),
    }
}

fn rounds(row_count: usize) -> f64 {
    2.0 * f64::from(u32::try_from(row_count).unwrap_or(u32::MAX))
}

/// Casings below the band are tapes.
fn tape(draft: &PauDraft) -> Option<Step> {
    let count = draft.elastic_rows.len() - draft.band_row_count;
    if count == 0 {
        return None;
    }
    let first = 2 + 2 * draft.band_row_count;
    Some(Step {
        title: words("テープをつける", "Sew on the tape"),
        by_machine: Sentence::new(
            format!(
                "バストの下の線に、ゴム通しのテープ {count} 本を裏から当て、上下の端を縫います。端は 1 cm ずつ折って突き合わせ、ゴムを通す口にします。"
            ),
            format!(
                "Pin {} to the wrong side along the lines below the bust and sew both edges. Turn the ends under by 1 cm and let them meet: the elastic goes in there.",
                if count == 1 {
                    "a casing tape".to_owned()
                } else {
                    format!("{count} casing tapes")
                }
            ),
        ),
        by_hand: Some(Sentence::new(
            "テープの上下をまつり縫いします。",
            "Slip-stitch both edges of the tape.",
        )),
        figure: StepFigure::Piece {
            piece: PANEL,
            edges: Vec::new(),
            marks: (first..first + 2 * count).collect(),
        },
        cuts: false,
        minutes: minutes(10.0, draft.flat_length * rounds(count)),
    })
}

fn hem(draft: &PauDraft) -> Step {
    let [turn, rest] = hem_turns(draft.hem_depth).map(cm);
    Step {
        title: words("裾を上げる", "Hem"),
        by_machine: Sentence::new(
            format!(
                "裾を裏へ {turn} cm、さらに {rest} cm 折り、折った端から 0.2 cm のところをぐるりと縫います。"
            ),
            format!(
                "Fold the lower edge to the wrong side by {turn} cm and again by {rest} cm, and sew all around 0.2 cm from the folded edge."
            ),
        ),
        by_hand: Some(Sentence::new(
            "0.7 cm おきに、表に小さな針目が出るようにまつり縫いします。",
            "Slip-stitch every 0.7 cm, picking up only a thread or two of the right side.",
        )),
        figure: StepFigure::Section {
            piece: PANEL,
            marks: vec![draft.lines.len() - 1],
        },
        cuts: false,
        minutes: minutes(15.0, draft.flat_length),
    }
}

fn thread_elastic(draft: &PauDraft) -> Step {
    let rows = draft.elastic_rows.iter();
    let lengths: Vec<String> = rows.map(|row| cm(row.cut_length)).collect();
    let overlap = draft.elastic_rows.first();
    let overlap = overlap.map_or(Length::ZERO, |row| row.cut_length - row.ring_length);
    let (count, overlap) = (lengths.len(), cm(overlap));
    // Rows of one girth take equal pieces.
    let [japanese, english] = match lengths.split_first() {
        Some((first, rest)) if rest.iter().all(|length| length == first) => [
            format!(" {first} cm に {count} 本"),
            match count {
                1 => format!("Cut an elastic of {first} cm"),
                _ => format!("Cut {count} elastics of {first} cm each"),
            },
        ],
        _ => [
            format!("上の段から順に {} cm に", lengths.join("、")),
            format!(
                "Cut {count} elastics, from the top row down {} cm long",
                lengths.join(", ")
            ),
        ],
    };
    Step {
        title: words("ゴムを通す", "Thread the elastic"),
        by_machine: Sentence::new(
            format!(
                "ゴムを{japanese}切ります。ゴム通しで1本ずつ通し、端を {overlap} cm 重ねて、ジグザグに二度縫います。ねじれていないか、縫う前にたしかめます。口をコの字とじで閉じます。"
            ),
            format!(
                "{english}. Thread each with a bodkin, make sure that it is not twisted, overlap its ends by {overlap} cm and sew them together twice with a zigzag stitch. Close the gaps with ladder stitches."
            ),
        ),
        by_hand: Some(Sentence::new(
            "重ねたゴムは、四角に返し縫いしてとめます。",
            "Sew the overlapped ends together in a square of backstitches.",
        )),
        figure: StepFigure::Section {
            piece: PANEL,
            marks: (1..draft.lines.len() - 1).collect(),
        },
        cuts: false,
        minutes: [
            5.0 + 6.0 * rounds(count) * 0.5,
            5.0 + 12.0 * rounds(count) * 0.5,
        ],
    }
}

fn finish(length: Length) -> Step {
    let length = cm(length);
    Step {
        title: words("仕上げる", "Finish"),
        by_machine: Sentence::new(
            format!(
                "ギャザーを均等に寄せ、縫い目のところで各段のゴムを縫いとめて、回らないようにします。着てみて、裾が床と平行かを見ます。上の折り山から裾まで {length} cm です。"
            ),
            format!(
                "Spread the gathers evenly. Stitch through each elastic in the seam, so that it cannot turn. Put it on and look whether the hem is level. It is {length} cm from the top fold to the hem."
            ),
        ),
        by_hand: None,
        figure: StepFigure::None,
        cuts: false,
        minutes: [15.0, 15.0],
    }
}

#[cfg(test)]
mod tests {
    use super::super::pau_skirt::{PauMeasurements, PauOptions, draft_pau_skirt};
    use super::super::pau_top::{TopMeasurements, TopOptions, draft_pau_top};
    use super::*;

    fn skirt() -> PauDraft {
        let measurements = PauMeasurements {
            hip_girth: Length::from_cm(91.4),
            worn_girth: Length::from_cm(83.0),
            worn_height: Length::from_cm(85.0),
        };
        draft_pau_skirt(&measurements, &PauOptions::default()).unwrap()
    }

    fn top(lower_row_count: u32) -> PauDraft {
        let measurements = TopMeasurements {
            bust_girth: Length::from_cm(84.0),
            upper_girth: Length::from_cm(82.0),
            lowest: (Length::from_cm(72.0), Length::from_cm(108.0)),
            trunk: (0 < lower_row_count).then(|| Length::from_cm(11.0)),
        };
        let cut = PauOptions {
            hem_height: Length::from_cm(95.0),
            elastic_row_count: 1,
            ..PauOptions::default()
        };
        let options = TopOptions {
            cut,
            lower_row_count,
        };
        draft_pau_top(&measurements, &options).unwrap()
    }

    #[test]
    fn every_number_of_a_figure_exists() {
        for draft in [skirt(), top(0), top(2)] {
            let pattern = draft.pattern(words("パウ", "pāʻū"));
            assert!(8 < pattern.steps.len());
            for step in &pattern.steps {
                let (piece, edges, marks) = match &step.figure {
                    StepFigure::Piece {
                        piece,
                        edges,
                        marks,
                    } => (*piece, edges.clone(), marks.clone()),
                    StepFigure::Section { piece, marks } => (*piece, Vec::new(), marks.clone()),
                    StepFigure::Seams(seams) => {
                        assert!(seams.iter().all(|&seam| seam < pattern.seams.len()));
                        continue;
                    }
                    StepFigure::Wrapping(_) | StepFigure::Craft(_) | StepFigure::None => continue,
                };
                let piece = &pattern.pieces[piece];
                assert!(edges.iter().all(|&edge| edge < piece.edges.len()));
                assert!(marks.iter().all(|&mark| mark < piece.marks.len()));
            }
        }
    }

    #[test]
    fn gaps_for_the_elastic_lie_inside_the_band_and_face_their_casings() {
        let draft = skirt();
        let (fold, turn) = (12.5, 1.0);
        let gaps = openings(&draft);
        assert_eq!(gaps.len(), 3);
        for (gap, row) in gaps.iter().zip(&draft.elastic_rows) {
            let middle = 0.5 * (gap[0] + gap[1]).to_cm();
            assert!((fold - middle - row.from_fold.to_cm()).abs() < 1e-9);
            assert!(turn - 1e-9 <= gap[0].to_cm() && gap[1].to_cm() < fold);
        }
    }

    #[test]
    fn times_are_those_that_makers_tell() {
        let steps = steps(&skirt(), None);
        let hours = |which: usize| steps.iter().map(|step| step.minutes[which]).sum::<f64>() / 60.0;
        assert!((2.0..4.5).contains(&hours(0)), "{}", hours(0));
        assert!((9.0..23.0).contains(&hours(1)), "{}", hours(1));
    }

    #[test]
    fn only_a_top_with_lower_rows_needs_tape() {
        let titles = |draft: &PauDraft| {
            let steps = steps(draft, None);
            let has_tape = |step: &Step| step.title.english.contains("tape");
            steps.iter().filter(|step| has_tape(step)).count()
        };
        assert_eq!(
            [titles(&skirt()), titles(&top(0)), titles(&top(2))],
            [0, 0, 1]
        );
    }
}
