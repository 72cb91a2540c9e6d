//! The malo: a strip that is girded about the waist and between the legs, its ends hanging as flaps.
//!
//! A halau's instructions give strips of 3 to 6 yards, girded, with flaps (pola) in front and at the back.
//! The width is an estimate. The length here is the way it goes: two flaps, the crotch, and the turns
//! about the waist: derived.

use lole_language::words;

use super::chosen::{Chosen, by_measure, number};
use super::making::{NO_WORK, cm, edges_of, folds, hem_in_section, pattern, say, step};
use super::shape::{AROUND, CM, Label, rectangle};
use super::work::{Work, minutes};
use super::{OptionRow, Options, Template};
use crate::piece::{CutCount, Finish};
use crate::{DraftError, Measure, Measures, Pattern};

pub(super) const TEMPLATE: Template = Template {
    id: "malo",
    name: words("マロ", "malo"),
    about: words(
        "腰と股に巻き、端を前後に垂らす細長い布",
        "a strip girded about waist and legs, its ends hanging in front and at the back",
    ),
    options: OPTIONS,
    draft,
    worn: None,
};

const OPTIONS: &[OptionRow] = &[
    number(
        "width_cm",
        [12.0, 60.0],
        26.0,
        words("できあがりの幅", "finished width"),
    ),
    number(
        "turn_count_ratio",
        [1.0, 4.0],
        2.0,
        words(
            "腰に巻く長さ÷ウエスト",
            "length about the waist over the waist girth",
        ),
    ),
    by_measure(
        "flap_cm",
        [10.0, 100.0],
        words(
            "前後に垂れる布の長さ。書かなければひざの上まで",
            "length of each flap; left out: to above the knees",
        ),
    ),
    number(
        "hem_allowance_cm",
        [0.0, 5.0],
        1.5,
        words("まわりの縫い代", "cloth for the hems"),
    ),
];

/// The flaps end over the knees [m].
const OVER_KNEES: f64 = 3.0 * CM;

fn draft(measures: &Measures, options: &Options) -> Result<Pattern, DraftError> {
    let chosen = Chosen::new(OPTIONS, options)?;
    measures.check(&[
        Measure::WaistGirth,
        Measure::CrotchLength,
        Measure::WaistHeight,
        Measure::KneeHeight,
    ])?;
    let drop = measures.waist_height.to_m() - measures.knee_height.to_m() - OVER_KNEES;
    let flap = chosen.m_or("flap_cm", drop.clamp(10.0 * CM, 100.0 * CM));
    let turns = chosen.number("turn_count_ratio");
    let waist = measures.waist_girth.to_m();
    let length = 2.0 * flap + measures.crotch_length.to_m() + turns * waist;
    let (width, hem) = (chosen.m("width_cm"), chosen.m("hem_allowance_cm"));
    let sides = ["lower", "left_end", "upper", "right_end"].map(|id| (id, Finish::Hem, hem));
    let label = Label::main("strip", words("帯布", "strip"), CutCount::Alike(1));
    let piece = rectangle(label, [length, width], sides, AROUND);
    let [cut_length, cut_width] = [length, width].map(|side| cm(side + 2.0 * hem));
    let [turn_cm, rest_cm] = folds(hem);
    let [flap_cm, waist_cm] = [flap, waist].map(cm);
    let yards = (lole_geom::Length::from_m(length).to_yd() * 10.0).round() / 10.0;
    let steps = vec![
        step(
            words("布を裁つ", "Cut the strip"),
            say!(
                "耳に沿って {cut_length} cm（{yards} ヤード）、幅 {cut_width} cm の帯を裁ちます。",
                "Cut a strip of {cut_length} cm ({yards} yd) along the selvage, {cut_width} cm wide."
            ),
            [10.0, 10.0],
        )
        .shown(edges_of(0, &[0, 1, 2, 3])),
        step(
            words("まわりを始末する", "Hem all sides"),
            say!(
                "四辺を裏へ {turn_cm} cm、さらに {rest_cm} cm 折って縫います。",
                "Fold every side to the wrong side by {turn_cm} cm and again by {rest_cm} cm, and stitch."
            ),
            minutes(&[(Work::Hem, 2.0 * (length + width))]),
        )
        .or_by_hand(say!(
            "四辺を細く三つ折りにして、まつり縫いをします。",
            "Roll the four sides narrowly and slip-stitch them."
        ))
        .shown(hem_in_section(0)),
        step(
            words("締める", "Gird it"),
            say!(
                "端を {flap_cm} cm 前に残して股を通し、後ろから {waist_cm} cm の腰に {turns} 周巻き、巻いた布にくぐらせて、残りを後ろに垂らします。",
                "Leave {flap_cm} cm hanging in front, pass the strip between the legs, wind it {turns} times about the waist of {waist_cm} cm, draw it under itself and let the rest hang at the back."
            ),
            NO_WORK,
        ),
    ];
    Ok(
        pattern(vec![piece], Vec::new(), Vec::new(), steps).warn(say!(
            "マロの幅は目安です。締め方はクムに習ってください",
            "the width of the malo is an estimate; learn from your kumu how it is girded"
        )),
    )
}
