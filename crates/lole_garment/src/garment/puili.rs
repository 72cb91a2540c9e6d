//! Pūʻili: split bamboo that rustles when it is struck, held in the hand.
//!
//! Makers give 20 inches of length, 1.5 to 2 inches of diameter and a handle of 5 inches. The width of the
//! strips is an estimate.

use lole_language::words;
use lole_pattern::pattern::NotionKind;
use lole_pattern::{DraftError, Pattern};

use crate::drafting::accessory::{accessory, cord, counted};
use crate::drafting::chosen::{Chosen, count, number};
use crate::drafting::making::{cm, say, step, whole};
use crate::fitting::Fitting;
use crate::sketch::{Sketch, Tone};
use crate::template::{BesideRow, OptionRow, Options, Shelf, Template, Wear};

pub(crate) static TEMPLATE: Template = Template {
    id: "puili",
    name: words("プイリ", "pūʻili"),
    about: words("先を細く裂いた竹の楽器", "sticks of split bamboo"),
    shelf: Shelf::Implements,
    options: OPTIONS,
    draft,
    worn: Wear::Beside(BesideRow {
        make: worn::make,
        replaces_flower: |_| false,
    }),
    chest_room_deg: 0.0,
    natural: Some([0xd8b878, 0xf2dfae, 0x3e7a2c, 0x8a6a3a]),
    sketch,
};

fn sketch(pen: &mut Sketch) {
    for x in [0.34, 0.6] {
        pen.patch(
            &[[x, 0.1], [x + 0.1, 0.1], [x + 0.1, 0.92], [x, 0.92]],
            Tone::Leaf,
        );
        for step in [0.03, 0.05, 0.07] {
            pen.line(&[[x + step, 0.1], [x + step, 0.66]]);
        }
    }
}

const OPTIONS: &[OptionRow] = &[
    count("stick_count", [1, 2], 2, words("本数", "how many")),
    number("length_cm", [25.0, 70.0], 50.8, words("長さ", "length")),
    number(
        "diameter_cm",
        [2.0, 8.0],
        4.4,
        words("竹の太さ", "diameter of the bamboo"),
    ),
    number(
        "handle_cm",
        [8.0, 20.0],
        12.7,
        words("持ち手の長さ", "length of the handle"),
    ),
    number(
        "strip_cm",
        [0.3, 2.0],
        0.6,
        words("裂いた竹の幅", "width of a strip"),
    ),
];

/// Turns of tape around the end of a handle. Estimated.
const TAPE_TURNS: f64 = 4.0;

fn draft(_: &Fitting<'_>, options: &Options) -> Result<Pattern, DraftError> {
    let chosen = Chosen::new(OPTIONS, options)?;
    let sticks = chosen.count("stick_count");
    let [long, handle] = ["length_cm", "handle_cm"].map(|key| chosen.m(key));
    let around = std::f64::consts::PI * chosen.m("diameter_cm");
    let strips = whole(around / chosen.m("strip_cm"));
    let [long_cm, handle_cm, slit_cm] = [long, handle, long - handle].map(cm);
    let [wide_cm, strip_cm] = [chosen.m("diameter_cm"), chosen.m("strip_cm")].map(cm);
    let steps = vec![
        step(
            words("竹を切る", "Cut the bamboo"),
            say!(
                "太さ {wide_cm} cm の竹を {sticks} 本、節を持ち手の側に残して {long_cm} cm に切ります。",
                "Cut {sticks} pieces of {long_cm} cm from bamboo {wide_cm} cm thick, a node at the handle's end."
            ),
            [20.0, 20.0],
        ),
        step(
            words("先を裂く", "Split the end"),
            say!(
                "持ち手の {handle_cm} cm を残し、{slit_cm} cm を {strip_cm} cm ごとに {strips} 本に切り込みます。一本おきに取り除くとよく鳴ります。",
                "Leave {handle_cm} cm for the handle and slit the other {slit_cm} cm every {strip_cm} cm into {strips} strips. Every other one taken out makes it rustle."
            ),
            [90.0, 90.0],
        ),
        step(
            words("磨く", "Smooth it"),
            say!(
                "切り口を紙やすりで磨き、持ち手の端をテープで巻きます。",
                "Sand all edges and wind tape around the end of the handle."
            ),
            [30.0, 30.0],
        ),
    ];
    let tape = f64::from(sticks) * TAPE_TURNS * around;
    let notions = vec![
        counted(
            NotionKind::Bamboo,
            words("竹", "bamboo"),
            sticks,
            say!(
                "太さ {wide_cm} cm、長さ {long_cm} cm",
                "{wide_cm} cm thick, {long_cm} cm long"
            ),
        ),
        cord(words("持ち手に巻くテープ", "tape for the handles"), tape),
    ];
    let estimate = say!(
        "裂く幅は目安です。踊り手の人数分は同じ店で買うと音がそろいます",
        "the width of the strips is an estimate; bought in one shop, those of a group sound alike"
    );
    Ok(accessory(Vec::new(), notions, steps, estimate))
}

mod worn {
    //! Pūʻili: bamboo split into strips beyond the handle, one in each hand.

    use std::f32::consts::TAU;

    use glam::Vec3;
    use lole_body::Side;
    use lole_geom::trig;
    use lole_pattern::DraftError;

    use crate::GarmentSpec;
    use crate::adorn::body::bone_alone;
    use crate::adorn::chosen::{Chosen, chance, real, whole};
    use crate::adorn::grip::{Grip, Palm};
    use crate::adorn::shape::{Shape, affine};
    use crate::adorn::{AdornmentFinish, Made, Wearer};

    /// Half the flesh of the mean woman's palm [m].
    const HALF_PALM: f32 = 0.014;
    /// Where sticks point: up and away from her, so that none goes through her.
    const AWAY: Vec3 = Vec3::new(0.0, 0.5, 0.85);
    /// How far the strips spread at their ends, over the radius.
    const SPREAD: f32 = 0.22;

    pub(super) fn make(spec: &GarmentSpec<'_>, wearer: &Wearer<'_>) -> Result<Made, DraftError> {
        let chosen = Chosen::new(spec)?;
        let skeleton = &wearer.dancer.skeleton;
        let size = (wearer.dancer.landmarks.crown_height / 1.58).clamp(0.6, 1.25);
        let sides: &[Side] = if chosen.count("stick_count") < 2 {
            &[Side::Right]
        } else {
            &[Side::Right, Side::Left]
        };
        let thickness = chosen.m("diameter_cm", 0.044);
        let stick = stick(&chosen, thickness);
        let mut made = Made::default();
        for &side in sides {
            let palm = Palm::new(skeleton, side, HALF_PALM * size);
            // It leaves the fist beside the index finger, leaning towards the fingertips.
            let up = (-palm.to_little + palm.along * 0.45).normalize_or(Vec3::Y);
            let across = (palm.along - up * palm.along.dot(up)).normalize_or(Vec3::X);
            let place = affine(
                [across, up, across.cross(up)],
                palm.center + palm.out * (0.45 * thickness),
            );
            let mut held = Shape::default();
            held.add(&stick, &place);
            made.surfaces
                .push(held.ridden(AdornmentFinish::Wood, bone_alone(palm.hand)));
            made.grips.push(Grip {
                side,
                thickness,
                facing: Some(AWAY),
                arm: None,
            });
        }
        Ok(made)
    }

    /// The stick, upright about the middle of its handle.
    fn stick(chosen: &Chosen<'_>, thickness: f32) -> Shape {
        let [length, handle] =
            [("length_cm", 0.508), ("handle_cm", 0.127)].map(|(key, usual)| chosen.m(key, usual));
        let radius = 0.5 * thickness;
        let around = f64::from(TAU * radius);
        let strips = whole(around / f64::from(chosen.m("strip_cm", 0.006).max(1e-3))).clamp(5, 60);
        let bamboo = chosen.ground();
        let (low, node) = (-0.5 * handle, 0.5 * handle);
        let mut shape = Shape::turned(
            18,
            &[
                ([0.0, low], bamboo * 0.7),
                ([radius, low], bamboo * 0.8),
                ([radius, low + 0.004], bamboo),
                ([radius, node - 0.006], bamboo),
                ([radius * 1.07, node - 0.002], bamboo * 0.75),
                ([radius * 1.07, node + 0.002], bamboo * 0.75),
                ([radius, node + 0.006], bamboo),
            ],
        );
        let top = low + length;
        for one in 0..strips {
            let angle = TAU * real(one) / real(strips);
            let half = 0.36 * TAU / real(strips);
            let splay = SPREAD * (1.0 + 0.6 * chance(one, 81));
            let sway = 0.10 * chance(one, 82);
            let end = top - 0.02 * length * (1.0 + chance(one, 83));
            let light = 1.0 + 0.10 * chance(one, 84);
            // A strip with its two narrow sides, bent outwards towards its end.
            let strip = Shape::sheet([5, 3], |along, across| {
                let out = 1.0 + splay * along * along;
                let inside = if !(0.1..=0.9).contains(&across) {
                    0.82
                } else {
                    1.0
                };
                let side = if across < 0.5 { -half } else { half };
                let (sin, cos) = trig::sin_cos(angle + side + sway * along * along);
                let reach = radius * out * inside;
                let place = Vec3::new(reach * sin, node + (end - node) * along, reach * cos);
                let shade = if inside < 1.0 { 0.62 } else { light };
                (place, (bamboo * shade).clamp(Vec3::ZERO, Vec3::ONE))
            });
            shape.add(&strip, &glam::Affine3A::IDENTITY);
        }
        shape
    }
}
