//! The lei for the neck: strung flowers, closed to a ring, or an open one whose ends hang.
//!
//! Makers give 35 to 40 inches for a ring, one and a quarter flowers to the inch, 50 plumeria for 40
//! inches. That the length follows the stature, and the length of an open one, are estimates.

use lole_language::words;

use super::accessory::{accessory, cord, counted};
use super::chosen::{Chosen, by_measure, choice, number};
use super::making::{cm, say, step, whole};
use super::shape::CM;
use super::{Choice, OptionRow, Options, Template};
use crate::pattern::NotionKind;
use crate::{DraftError, Measure, Measures, Pattern};

pub(super) const TEMPLATE: Template = Template {
    id: "lei",
    name: words("レイ", "lei"),
    about: words("首に掛ける花のレイ", "a lei of strung flowers for the neck"),
    options: OPTIONS,
    draft,
    worn: None,
};

const FORMS: &[Choice] = &[
    Choice {
        id: "closed",
        name: words("輪のレイ", "closed"),
    },
    Choice {
        id: "open",
        name: words("両端を垂らすレイ", "open, its ends hanging"),
    },
];

const OPTIONS: &[OptionRow] = &[
    choice("form", FORMS, words("レイの形", "form of the lei")),
    by_measure(
        "length_cm",
        [40.0, 300.0],
        words(
            "長さ。書かなければ輪は身長の 0.63 倍、垂らすものは 1.0 倍",
            "length; left out: 0.63 of the stature closed, 1.0 open",
        ),
    ),
    number(
        "flowers_per_cm_ratio",
        [0.1, 5.0],
        0.5,
        words("1 cm あたりの花の数", "flowers to a centimeter"),
    ),
];

/// Length over the stature: 1 m (40 inches) at 158 cm.
const CLOSED: f64 = 0.63;
const OPEN: f64 = 1.0;
/// Ribbon that hides the knot [m]. Estimated.
const RIBBON: f64 = 40.0 * CM;
/// String at each end, for the knot [m].
const END: f64 = 15.0 * CM;

fn draft(measures: &Measures, options: &Options) -> Result<Pattern, DraftError> {
    let chosen = Chosen::new(OPTIONS, options)?;
    measures.check(&[Measure::Stature, Measure::HeadGirth])?;
    let is_closed = chosen.choice("form") == "closed";
    let share = if is_closed { CLOSED } else { OPEN };
    let long = chosen.m_or("length_cm", share * measures.stature.to_m());
    let count = whole(long / CM * chosen.number("flowers_per_cm_ratio"));
    let string = long + 2.0 * END;
    let [long_cm, string_cm, ribbon_cm] = [long, string, RIBBON].map(cm);
    let close = if is_closed {
        say!(
            "{long_cm} cm になったら糸の両端を固く結び、{ribbon_cm} cm のリボンで隠します。",
            "When it measures {long_cm} cm tie both ends of the string firmly and hide the knot with {ribbon_cm} cm of ribbon."
        )
    } else {
        say!(
            "{long_cm} cm になったら両端の花を結び止めます。端は結び合わせずに垂らします。",
            "When it measures {long_cm} cm fasten the last flower at each end. The ends are not tied and hang."
        )
    };
    let steps = vec![
        step(
            words("花をつなぐ", "String the flowers"),
            say!(
                "{string_cm} cm の糸に針を付け、花を {count} 個、中心を通してつなぎます。",
                "Thread a needle with {string_cm} cm of string and string {count} flowers through their centers."
            ),
            [60.0, 60.0],
        ),
        step(words("仕上げる", "Finish"), close, [10.0, 10.0]),
    ];
    let mut notions = vec![
        counted(
            NotionKind::Flower,
            words("花（造花または生花）", "flowers, artificial or fresh"),
            count,
            say!(
                "プルメリアなら 1 m におよそ 50 個",
                "about 50 plumeria to a meter"
            ),
        ),
        cord(words("丈夫な糸", "strong string"), string),
    ];
    if is_closed {
        notions.push(cord(
            words("結び目を隠すリボン", "ribbon for the knot"),
            RIBBON,
        ));
    }
    let estimate = say!(
        "花の数と長さは目安です。花の大きさに合わせてください",
        "number of flowers and length are estimates; go by the size of your flowers"
    );
    let pattern = accessory(Vec::new(), notions, steps, estimate);
    let head = measures.head_girth.to_m();
    if is_closed && long < head + 4.0 * CM {
        let head_cm = cm(head);
        return Ok(pattern.warn(say!(
            "輪が {long_cm} cm では頭（{head_cm} cm）を通りません。長くするか、結ぶ形にしてください",
            "a ring of {long_cm} cm does not go over a head of {head_cm} cm; make it longer, or open"
        )));
    }
    Ok(pattern)
}
