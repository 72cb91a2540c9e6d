//! The hair flower: a hibiscus of cloth petals on a pin.
//!
//! Hibiscus has five petals; their size, a hand's breadth across the flower, is an estimate and an option.

use kurbo::Vec2;
use lole_language::words;
use lole_pattern::pattern::NotionKind;
use lole_pattern::piece::{CutCount, Finish, LineKind, Piece};
use lole_pattern::{DraftError, Pattern};

use crate::drafting::accessory::{accessory, counted};
use crate::drafting::chosen::{Chosen, choice, count, number};
use crate::drafting::making::{cm, edges_of, say, step, stitching};
use crate::drafting::shape::{CM, DOWN, Label, at, curve, edge, line};
use crate::fitting::Fitting;
use crate::sketch::{Sketch, Tone};
use crate::template::{BesideRow, Choice, OptionRow, Options, Shelf, Template, Wear};

pub(crate) static TEMPLATE: Template = Template {
    id: "hair-flower",
    name: words("髪飾りの花", "hair flower"),
    about: words(
        "布の花びらで作るハイビスカスの髪飾り",
        "a hibiscus of cloth petals for the hair",
    ),
    shelf: Shelf::Adornments,
    options: OPTIONS,
    draft,
    worn: Wear::Beside(BesideRow {
        make: worn::make,
        replaces_flower: worn::replaces_flower,
    }),
    chest_room_deg: 0.0,
    natural: Some([0xf4d35e, 0xd8263c, 0x2f6a34, 0x6d0f20]),
    sketch,
};

fn sketch(pen: &mut Sketch) {
    pen.ring([0.5, 0.5], [0.2, 0.2], [5.0, 0.17]);
    pen.disc([0.5, 0.5], 0.07, Tone::Rgb([240, 200, 60]));
}

const OPTIONS: &[OptionRow] = &[
    number(
        "diameter_cm",
        [4.0, 25.0],
        12.0,
        words("花の直径", "across the flower"),
    ),
    count("petal_count", [3, 12], 5, words("花びらの枚数", "petals")),
    count("flower_count", [1, 5], 1, words("花の数", "flowers")),
    choice(
        "side",
        SIDES,
        words("着ける側（その人から見て）", "side of the head, hers"),
    ),
];

const SIDES: &[Choice] = &[
    Choice {
        id: "left",
        name: words("左", "left"),
    },
    Choice {
        id: "right",
        name: words("右", "right"),
    },
];

/// Length of a petal over the flower's radius: the middle is drawn together.
const PETAL: f64 = 1.15;
/// Width of a petal over its length, and of its foot.
const WIDE: f64 = 0.86;
const FOOT: f64 = 0.30;

fn draft(_: &Fitting<'_>, options: &Options) -> Result<Pattern, DraftError> {
    let chosen = Chosen::new(OPTIONS, options)?;
    let long = 0.5 * chosen.m("diameter_cm") * PETAL;
    let [petals, flowers] = ["petal_count", "flower_count"].map(|key| chosen.count(key));
    let all = petals * flowers;
    let piece = petal(long, all);
    // What is cut, the foot's allowance included.
    let bounds = piece.cut_polygon(1e-4).bounds();
    let [long_cm, wide_cm] = [bounds.height(), bounds.width()].map(cm);
    let steps = vec![
        step(
            words("花びらを裁つ", "Cut the petals"),
            say!(
                "長さ {long_cm} cm、幅 {wide_cm} cm の花びらを {all} 枚裁ち、端にほつれ止めを塗ります。",
                "Cut {all} petals of {long_cm} by {wide_cm} cm and seal their edges against fraying."
            ),
            [20.0, 20.0],
        )
        .shown(edges_of(0, &[0, 1])),
        step(
            words("花びらを寄せる", "Gather the petals"),
            say!(
                "花びら {petals} 枚の根元を少しずつ重ねて並べ、続けてぐし縫いし、引き絞って輪にします。",
                "Lay the feet of {petals} petals over each other in a row, run a thread through all of them and draw them to a ring."
            ),
            stitching(f64::from(all) * FOOT * long),
        )
        .shown(edges_of(0, &[0])),
        step(
            words("仕上げる", "Finish"),
            say!(
                "中心にしべを付け、裏に丸い布を当ててヘアピンを縫い付けます。",
                "Set a pistil in the middle, cover the back with a round of cloth and sew a hair pin to it."
            ),
            [20.0, 20.0],
        ),
    ];
    let notions = vec![
        counted(
            NotionKind::HairPin,
            words("ヘアピンまたはクリップ", "hair pin or clip"),
            flowers,
            say!("花 1 つに 1 本", "one for each flower"),
        ),
        counted(
            NotionKind::Pistil,
            words("しべ（ペップ）", "pistil"),
            flowers,
            say!("花 1 つに 1 本", "one for each flower"),
        ),
    ];
    let estimate = say!(
        "花の大きさは目安です",
        "the size of the flower is an estimate"
    );
    Ok(accessory(vec![piece], notions, steps, estimate))
}

/// A petal, its foot below, its rim round with a shallow notch.
fn petal(long: f64, count: u32) -> Piece {
    let half = 0.5 * WIDE * long;
    let foot = 0.5 * FOOT * long;
    let [left_foot, right_foot] = [at(-foot, 0.0), at(foot, 0.0)];
    let widest = 0.66 * long;
    let (right, left) = (at(half, widest), at(-half, widest));
    let dip = at(0.0, 0.965 * long);
    let up = Vec2::new(0.0, 1.0);
    let side = |sign: f64| Vec2::new(sign * 0.45 * half, 0.5 * widest);
    let rim = vec![
        curve(right_foot, side(1.0) * 0.8, up * (0.35 * widest), right),
        curve(
            right,
            up * (0.62 * (long - widest)),
            Vec2::new(-0.55 * half, -0.06 * long),
            dip,
        ),
        curve(
            dip,
            Vec2::new(-0.55 * half, 0.06 * long),
            -up * (0.62 * (long - widest)),
            left,
        ),
        curve(left, -up * (0.35 * widest), -side(-1.0) * 0.8, left_foot),
    ];
    let foot_edge = edge(
        "foot",
        vec![line(left_foot, right_foot)],
        Finish::Raw,
        0.8 * CM,
    );
    let gathers = crate::drafting::shape::across(LineKind::Gather, 0.0, [-foot, foot]);
    let label = Label::main("petal", words("花びら", "petal"), CutCount::Alike(count));
    let rim = edge("rim", rim, Finish::Raw, 0.0);
    label.piece(vec![foot_edge, rim], DOWN, vec![gathers])
}

mod worn {
    //! The hair flower: a hibiscus beside an ear.

    use glam::{Affine3A, Quat, Vec3};
    use lole_body::{Bone, PartKind, Side};
    use lole_geom::trig;
    use lole_pattern::DraftError;

    use super::OPTIONS;
    use crate::GarmentSpec;
    use crate::adorn::blade::Blade;
    use crate::adorn::body::{bone_alone, farthest};
    use crate::adorn::chosen::{Chosen, real};
    use crate::adorn::shape::{Shape, affine, facing};
    use crate::adorn::{AdornmentFinish, Made, Wearer, flower};
    use crate::drafting::chosen::Chosen as Decided;
    use crate::template::Options;

    /// Longitude from the front towards the side, and latitude, of the first flower [°]; the others follow
    /// up and back.
    const PLACE: [f32; 2] = [74.0, 16.0];
    const NEXT: [f32; 2] = [30.0, 17.0];
    const HEAD: &[PartKind] = &[PartKind::Skin, PartKind::Face, PartKind::Hair];

    /// The side on which it is worn.
    fn side(options: &Options) -> Side {
        let chosen = Decided::new(OPTIONS, options);
        match chosen.map(|chosen| chosen.choice("side")) {
            Ok("right") => Side::Right,
            _ => Side::Left,
        }
    }

    /// Her own flower is on the left.
    pub(super) fn replaces_flower(options: &Options) -> bool {
        side(options) == Side::Left
    }

    pub(super) fn make(spec: &GarmentSpec<'_>, wearer: &Wearer<'_>) -> Result<Made, DraftError> {
        let chosen = Chosen::new(spec)?;
        let dancer = wearer.dancer;
        let joint = dancer.skeleton.joint(Bone::Head);
        let rise = dancer.landmarks.crown_height - joint.y;
        let center = joint + Vec3::new(0.0, 0.46 * rise, 0.08 * rise);
        let sign = match side(spec.options) {
            Side::Left => 1.0,
            Side::Right => -1.0,
        };
        let radius = 0.5 * chosen.m("diameter_cm", 0.12);
        let petals = chosen.count("petal_count");
        let colors = [chosen.flower(), chosen.shadow(), chosen.ground()];
        let one = flower::hibiscus(radius, petals, colors);
        let leaf = Blade {
            length: 1.15 * radius,
            width: 0.55 * radius,
            fold: 0.25,
            droop: 0.2,
            color: chosen.leaf(),
        };
        let mut flowers = Shape::default();
        let mut leaves = Shape::default();
        for number in 0..chosen.count("flower_count") {
            let [longitude, latitude] = [0, 1].map(|k| PLACE[k] + NEXT[k] * real(number));
            let (sin_lon, cos_lon) = trig::sin_cos(longitude.to_radians());
            let (sin_lat, cos_lat) = trig::sin_cos(latitude.min(70.0).to_radians());
            let towards = Vec3::new(sign * sin_lon * cos_lat, sin_lat, cos_lon * cos_lat);
            let reach = farthest(dancer, (center, towards), 0.985, HEAD);
            let seat = center + towards * (reach + 0.006);
            // It looks to the side and a little to the front.
            let face = (towards + Vec3::new(0.15 * sign, 0.05, 0.35)).normalize_or_zero();
            let axes = facing(Vec3::Y, face);
            let [x, y, z] = [axes[0], axes[1], axes[2]];
            let place = affine([x, y, z], seat);
            let spin = Quat::from_axis_angle(Vec3::Y, 0.9 * real(number));
            flowers.add(&one, &(place * Affine3A::from_quat(spin)));
            for (turn, down) in [(2.2_f32, 0.12_f32), (3.4, 0.16), (4.4, 0.12)] {
                let around = Quat::from_axis_angle(Vec3::Y, sign * turn);
                let under = Affine3A::from_translation(Vec3::NEG_Y * (down * radius))
                    * Affine3A::from_quat(around);
                leaves.add(&leaf.varied(number).shape(3), &(place * under));
            }
        }
        let head = bone_alone(Bone::Head);
        Ok(Made {
            surfaces: vec![
                flowers.ridden(AdornmentFinish::Petal, head),
                leaves.ridden(AdornmentFinish::Leaf, head),
            ],
            ..Made::default()
        })
    }
}
