//! The ipu and the ipu heke: one gourd, or two that are glued mouth to mouth, beaten with the hand.
//!
//! No source gives sizes: heights here are estimates that follow the length of the arm, since the drum is
//! lifted and beaten.

use lole_language::words;

use super::accessory::{accessory, cord, counted};
use super::chosen::{Chosen, by_measure, choice};
use super::making::{cm, say, step};
use super::{Choice, OptionRow, Options, Template};
use crate::pattern::NotionKind;
use crate::{DraftError, Measure, Measures, Pattern};

pub(super) const TEMPLATE: Template = Template {
    id: "ipu",
    name: words("イプ", "ipu"),
    about: words(
        "手でたたくひょうたんの太鼓",
        "a gourd drum, beaten with the hand",
    ),
    options: OPTIONS,
    draft,
    worn: None,
};

const FORMS: &[Choice] = &[
    Choice {
        id: "single",
        name: words("イプ（一つのひょうたん）", "ipu: one gourd"),
    },
    Choice {
        id: "heke",
        name: words("イプ・ヘケ（二つを重ねたもの）", "ipu heke: two gourds"),
    },
];

const OPTIONS: &[OptionRow] = &[
    choice("form", FORMS, words("イプの形", "form of the ipu")),
    by_measure(
        "height_cm",
        [15.0, 100.0],
        words(
            "高さ。書かなければ一つは腕の長さの 0.55 倍、ヘケは 1.2 倍",
            "height; left out: 0.55 of the arm's length, 1.2 for a heke",
        ),
    ),
];

/// Height over the length of the arm. Estimated.
const SINGLE: f64 = 0.55;
const HEKE: f64 = 1.2;
/// Greatest width over the height. Estimated.
const WIDE: f64 = 0.72;
const HEKE_WIDE: f64 = 0.48;
/// Cord for neck and wrist [m]. Estimated.
const CORD: f64 = 60.0 * super::shape::CM;
/// The lower gourd over the height of an ipu heke. Estimated.
const LOWER: f64 = 0.62;

fn draft(measures: &Measures, options: &Options) -> Result<Pattern, DraftError> {
    let chosen = Chosen::new(OPTIONS, options)?;
    measures.check(&[Measure::ArmLength])?;
    let is_heke = chosen.choice("form") == "heke";
    let arm = measures.arm_length.to_m();
    let (share, wide) = if is_heke {
        (HEKE, HEKE_WIDE)
    } else {
        (SINGLE, WIDE)
    };
    let height = chosen.m_or("height_cm", share * arm);
    let [height_cm, wide_cm] = [height, wide * height].map(cm);
    let [lower_cm, upper_cm] = [LOWER * height, (1.0 - LOWER) * height].map(cm);
    let cord_cm = cm(CORD);
    let gourds = if is_heke { 2 } else { 1 };
    let cut = if is_heke {
        say!(
            "乾いたひょうたんの首を切り、下を {lower_cm} cm、上を {upper_cm} cm にします。中の種とわたを取り出して洗い、よく乾かします。",
            "Cut the necks off two dry gourds, the lower one to {lower_cm} cm and the upper one to {upper_cm} cm. Clean out seeds and pith, wash and dry them well."
        )
    } else {
        say!(
            "乾いたひょうたんの首を切って高さ {height_cm} cm にし、中の種とわたを取り出して洗い、よく乾かします。",
            "Cut the neck off a dry gourd to a height of {height_cm} cm, clean out seeds and pith, wash and dry it well."
        )
    };
    let mut steps = vec![step(
        words("ひょうたんを切る", "Cut the gourd"),
        cut,
        [120.0, 120.0],
    )];
    if is_heke {
        steps.push(step(
            words("二つを付ける", "Join them"),
            say!(
                "切り口を平らに磨いて合わせ、接着剤で付けます。高さ {height_cm} cm になります。",
                "Sand the mouths flat, set one on the other and glue them, to a height of {height_cm} cm."
            ),
            [60.0, 60.0],
        ));
    }
    steps.push(step(
        words("磨いてひもを付ける", "Polish it and tie a cord on"),
        say!(
            "口と表面を紙やすりで磨き、手首に掛ける {cord_cm} cm のひもを首に結びます。",
            "Sand mouth and skin and tie a cord of {cord_cm} cm around the neck, for the wrist."
        ),
        [45.0, 45.0],
    ));
    let mut notions = vec![counted(
        NotionKind::Gourd,
        words("乾いたひょうたん", "dry gourds"),
        gourds,
        say!(
            "できあがりは高さ {height_cm} cm、太さ {wide_cm} cm ほど",
            "finished about {height_cm} cm high and {wide_cm} cm wide"
        ),
    )];
    if is_heke {
        notions.push(counted(
            NotionKind::Glue,
            words("木工用接着剤", "wood glue"),
            1,
            say!("つなぎ目に", "for the joint"),
        ));
    }
    notions.push(cord(words("手首に掛けるひも", "cord for the wrist"), CORD));
    let estimate = say!(
        "イプの大きさは目安です。買うときは音を聞いて、クムに相談してください",
        "the size of the ipu is an estimate; to buy one, listen to it and ask your kumu"
    );
    Ok(accessory(Vec::new(), notions, steps, estimate))
}
