//! Skills of the hand that steps ask for again and again, each drawn and said once at the end of the steps.
//!
//! A booklet has those that its own steps name, and no others.

mod drawings;

use lole_costume::order::DancerPlan;
use lole_language::{Language, Words, words};
use lole_pattern::pattern::Step;

use super::keep;
use super::style::{Illustrated, head};
use crate::canvas::Canvas;
use crate::pdf::Flow;

/// Size of a drawing [mm].
const DRAWING: [f64; 2] = [62.0, 34.0];

/// One skill.
pub(super) struct Technique {
    pub(super) title: Words,
    how: Words,
    /// A step in whose English words one of these begins a word asks for it.
    asked: &'static [&'static str],
    draw: fn(&mut Canvas<'_>),
}

/// All of them, in the order in which a garment is made.
const TECHNIQUES: &[Technique] = &[
    Technique {
        title: words("返し縫い", "Backstitch"),
        how: words(
            "針を一目先に出し、前の目の終わりに戻して入れます。ミシンの代わりになる丈夫な縫い目です。目は 3 mm にします。",
            "Bring the needle up one stitch ahead and put it down where the last stitch ends. It is as strong as a machine’s seam; stitches are 3 mm long.",
        ),
        asked: &["backstitch", "by hand"],
        draw: drawings::backstitch,
    },
    Technique {
        title: words("ダーツ", "A dart"),
        how: words(
            "中表に折り、二本の線を合わせます。幅の広いほうから先へ縫い、先では折り山すれすれに抜けます。先で返し縫いはせず、糸を結びます。",
            "Fold it with the right sides together so that both lines meet. Sew from the wide end to the tip and run off along the fold; at the tip tie the threads instead of sewing back.",
        ),
        asked: &["dart"],
        draw: drawings::dart,
    },
    Technique {
        title: words("ギャザーを寄せる", "Gathering"),
        how: words(
            "4 mm の粗い目で、できあがり線をはさんで二本縫い、糸を 10 cm 残します。二本の下糸をいっしょに引き、合印を先に合わせてから、ひだを均等にならします。",
            "Sew two rows of 4 mm stitches, one on either side of the seam line, and leave 10 cm of thread. Pull both bobbin threads together; match the marks first, then spread the folds evenly.",
        ),
        asked: &["gather"],
        draw: drawings::gathers,
    },
    Technique {
        title: words("縫い代を始末して割る", "Neatening and pressing open"),
        how: words(
            "縫い代の端をジグザグで縫い、ほつれを止めます。アイロンの先で縫い目を開き、左右に倒して押さえます。",
            "Sew over the raw edges with a zigzag stitch so that they do not fray. Open the seam with the tip of the iron and press its allowances to either side.",
        ),
        asked: &["neaten"],
        draw: drawings::pressed_open,
    },
    Technique {
        title: words("切り込みを入れる", "Clipping a curve"),
        how: words(
            "曲線や角では、縫い目の 2 mm 手前まで、縫い代だけに切り込みを入れます。縫い目は切りません。",
            "On curves and in corners cut into the allowance alone, to within 2 mm of the stitches and never through them.",
        ),
        asked: &["clip"],
        draw: drawings::clipped,
    },
    Technique {
        title: words("バイアスでくるむ", "Binding an edge"),
        how: words(
            "斜めに裁った布を中表に縫い付け、端をくるんで裏へ返し、縫い代を折り込んで、縫い目のきわをまつります。引っぱらずに置くと、曲線になじみます。",
            "Sew the strip on with the right sides together, take it over the raw edge to the wrong side, turn its own edge under and stitch it down. Cut on the bias and not stretched, it follows any curve.",
        ),
        asked: &["bias"],
        draw: drawings::bound,
    },
    Technique {
        title: words("三つ折りとまつり縫い", "A hem folded twice"),
        how: words(
            "アイロンで一度折り、もう一度折って端を中に入れ、折り山のきわを縫います。手縫いなら、表は織り糸を一、二本だけすくってまつります。",
            "Fold it once and once more with the iron, so that the raw edge lies inside, and sew along the inner fold. By hand catch only a thread or two of the outer cloth.",
        ),
        asked: &["hem", "blind-stitch"],
        draw: drawings::hem,
    },
    Technique {
        title: words("ゴムやひもを通す", "Threading a casing"),
        how: words(
            "先に安全ピンを付けて通します。もう一方の端は、口の外に留めておきます。通したら、ねじれていないか指でたどります。",
            "Put a safety pin through one end and work it along; pin the other end outside of the opening. When it is through, feel along it that it has not twisted.",
        ),
        asked: &["casing", "thread the elastic", "draw an elastic"],
        draw: drawings::threaded,
    },
    Technique {
        title: words("ゴムの端を重ねて縫う", "Joining elastic"),
        how: words(
            "縫う前に一度着て、きつさを確かめます。両端を平らに重ね、四角くジグザグで二度縫います。",
            "Try it on before it is sewn. Lay the ends flat over each other and sew a square of zigzag stitches twice.",
        ),
        asked: &["overlap"],
        draw: drawings::joined,
    },
    Technique {
        title: words("コの字とじ", "Ladder stitch"),
        how: words(
            "折り山どうしを突き合わせます。片方の折りの中を 4 mm すくい、真向かいの折りの中を 4 mm すくい、糸を引くと縫い目は見えません。",
            "Lay two folds against each other. Take 4 mm inside one fold, then 4 mm inside the other right across from it; drawn tight, the stitches disappear.",
        ),
        asked: &["ladder stitch"],
        draw: drawings::ladder,
    },
];

/// Those that steps ask for.
pub(super) fn asked<'a>(steps: impl Iterator<Item = &'a Step>) -> Vec<&'static Technique> {
    let said = |step: &Step| {
        let by_hand = step.by_hand.as_ref();
        // Whatever is sewn by hand instead is sewn in backstitches.
        let by_hand = by_hand.map_or_else(String::new, |it| format!(" by hand {}", it.english));
        format!(
            "{} {}{by_hand}",
            step.title.english, step.by_machine.english
        )
        .to_lowercase()
    };
    let said: Vec<String> = steps.map(said).collect();
    let is_asked = |technique: &&Technique| {
        let mut asked = technique.asked.iter();
        asked.any(|word| said.iter().any(|step| says(step, word)))
    };
    TECHNIQUES.iter().filter(is_asked).collect()
}

/// Whether a text has a word that begins so: "hem" and "hemmed", but not "them".
fn says(text: &str, begins: &str) -> bool {
    let mut found = text.match_indices(begins);
    found.any(|(at, _)| !text[..at].ends_with(char::is_alphabetic))
}

/// Draws those that the steps of a costume ask for; nothing where they ask for none.
pub(super) fn draw(flow: &mut Flow, plan: &DancerPlan, language: Language) {
    // Petals are gathered and leaves bound, too, but not with a needle and thread of cloth.
    let garments = plan
        .garments
        .iter()
        .filter(|garment| keep::is_sewn(garment));
    let steps = garments.flat_map(|garment| &garment.tailored.pattern.steps);
    let techniques = asked(steps);
    if techniques.is_empty() {
        return;
    }
    flow.space(4.0);
    flow.keep(DRAWING[1] + 22.0);
    head(flow, language.pick("縫い方の基本", "How it is done"));
    for technique in techniques {
        let said = Illustrated {
            title: technique.title.text(language),
            words: technique.how.text(language),
            drawing: DRAWING,
            free_lines: 0.0,
        };
        said.draw(flow, language, (technique.draw, |_, _| {}));
    }
}

#[cfg(test)]
mod tests {
    use lole_language::Sentence;
    use lole_pattern::pattern::StepFigure;

    use super::*;

    fn step(english: &str) -> Step {
        Step {
            title: words("", "Step"),
            by_machine: Sentence::new("", english),
            by_hand: None,
            figure: StepFigure::None,
            minutes: [0.0; 2],
            cuts: false,
        }
    }

    #[test]
    fn a_booklet_has_the_techniques_that_its_steps_name() {
        let titles = |steps: &[Step]| -> Vec<&str> {
            asked(steps.iter())
                .iter()
                .map(|it| it.title.english)
                .collect()
        };
        assert!(titles(&[]).is_empty());
        assert!(titles(&[step("Tie the leaves to the cord and spread them.")]).is_empty());
        assert_eq!(
            titles(&[step("Hemmed all around.")]),
            ["A hem folded twice"]
        );
        let sewn = [step("Sew the dart."), step("Gather the lower edge.")];
        assert_eq!(titles(&sewn), ["A dart", "Gathering"]);
        let by_hand = step("Sew it.").or_by_hand(Sentence::new("", "Sew it in small stitches."));
        assert_eq!(titles(&[by_hand]), ["Backstitch"]);
    }
}
