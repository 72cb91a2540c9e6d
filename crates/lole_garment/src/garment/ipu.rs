//! The ipu and the ipu heke: one gourd, or two that are glued mouth to mouth, beaten with the hand.
//!
//! No source gives sizes: heights here are estimates that follow the length of the arm, since the drum is
//! lifted and beaten.

use lole_language::words;
use lole_pattern::pattern::NotionKind;
use lole_pattern::{DraftError, Measure, Pattern};

use crate::drafting::accessory::{accessory, cord, counted};
use crate::drafting::chosen::{Chosen, by_measure, choice};
use crate::drafting::making::{cm, say, step};
use crate::fitting::Fitting;
use crate::sketch::{Sketch, Tone};
use crate::template::{BesideRow, Choice, OptionRow, Options, Shelf, Template, Wear};

pub(crate) static TEMPLATE: Template = Template {
    id: "ipu",
    name: words("イプ", "ipu"),
    about: words(
        "手でたたくひょうたんの太鼓",
        "a gourd drum, beaten with the hand",
    ),
    shelf: Shelf::Implements,
    options: OPTIONS,
    draft,
    worn: Wear::Beside(BesideRow {
        make: worn::make,
        replaces_flower: |_| false,
    }),
    chest_room_deg: 0.0,
    natural: Some([0x9c6a3a, 0xe0b060, 0x3e7a2c, 0x5c3616]),
    sketch,
};

fn sketch(pen: &mut Sketch) {
    let gourd = Tone::Rgb([214, 180, 130]);
    pen.disc([0.5, 0.66], 0.26, gourd);
    pen.disc([0.5, 0.29], 0.18, gourd);
    pen.line(&[[0.44, 0.12], [0.56, 0.12]]);
}

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
const CORD: f64 = 60.0 * crate::drafting::shape::CM;
/// The lower gourd over the height of an ipu heke. Estimated.
const LOWER: f64 = 0.62;

fn draft(fitting: &Fitting<'_>, options: &Options) -> Result<Pattern, DraftError> {
    let measures = fitting.measures;
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

mod worn {
    //! The ipu: a gourd, or two mouth to mouth, held at the side by the left hand.

    use glam::Vec3;
    use lole_body::{Bone, Side};
    use lole_pattern::DraftError;

    use crate::GarmentSpec;
    use crate::adorn::body::bone_alone;
    use crate::adorn::chosen::Chosen;
    use crate::adorn::grip::{Grip, Palm};
    use crate::adorn::shape::{Shape, affine};
    use crate::adorn::{AdornmentFinish, Made, Wearer};

    /// Height over the length of the arm, greatest width over the height, and the lower gourd over the
    /// height, as the template has them.
    const SINGLE: [f64; 2] = [0.55, 0.72];
    const HEKE: [f64; 2] = [1.2, 0.48];
    const LOWER: f32 = 0.62;
    /// Half the flesh of the mean woman's palm [m].
    const HALF_PALM: f32 = 0.014;
    /// Where upper arm and forearm of the left point, in the directions of the chest.
    const UPPER_ARM: Vec3 = Vec3::new(0.42, -0.88, -0.10);
    const FOREARM: Vec3 = Vec3::new(0.30, -0.62, 0.72);

    /// One gourd or two.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    enum Form {
        Single,
        Heke,
    }

    pub(super) fn make(spec: &GarmentSpec<'_>, wearer: &Wearer<'_>) -> Result<Made, DraftError> {
        let chosen = Chosen::new(spec)?;
        let skeleton = &wearer.dancer.skeleton;
        let form = match chosen.choice("form") {
            "heke" => Form::Heke,
            _ => Form::Single,
        };
        let [share, wide] = match form {
            Form::Single => SINGLE,
            Form::Heke => HEKE,
        };
        let height = chosen.m("height_cm", share * wearer.measures.arm_length.to_m());
        #[expect(clippy::cast_possible_truncation, reason = "a share")]
        let radius = 0.5 * height * wide as f32;
        let size = (wearer.dancer.landmarks.crown_height / 1.58).clamp(0.6, 1.25);
        let (profile, neck) = profile(&chosen, form, height, radius);
        let gourd = Shape::turned(32, &rounded(&profile));
        let side = Side::Left;
        let palm = Palm::new(skeleton, side, HALF_PALM * size);
        let grip = Grip {
            side,
            thickness: 2.0 * neck.x,
            facing: None,
            arm: Some([UPPER_ARM, FOREARM]),
        };
        // Upright in the world while the arm is held: the hand turns as the grip turns it.
        let mut held = lole_body::Pose::default();
        grip.apply(skeleton, &mut held);
        let world_from_bind = skeleton.world_from_bind(&held)[Bone::LeftHand.index()];
        let bind_from_world = world_from_bind.inverse();
        let [up, out] = [Vec3::Y, world_from_bind.transform_vector3(palm.out)];
        let out = out.with_y(0.0).normalize_or(Vec3::X);
        let place = world_from_bind.transform_point3(palm.center) + out * neck.x - up * neck.y;
        let world = affine([up.cross(out), up, out], place);
        let mut shape = Shape::default();
        shape.add(&gourd, &(bind_from_world * world));
        Ok(Made {
            surfaces: vec![shape.ridden(AdornmentFinish::Wood, bone_alone(palm.hand))],
            grips: vec![grip],
            ..Made::default()
        })
    }

    /// A curve through the points of an outline (Catmull and Rom 1974), three pieces for each of theirs.
    fn rounded(profile: &[([f32; 2], Vec3)]) -> Vec<([f32; 2], Vec3)> {
        let last = profile.len() - 1;
        let mut curve = Vec::with_capacity(3 * last + 1);
        for from in 0..last {
            let at = |k: usize| glam::Vec2::from(profile[k.min(last)].0);
            let [before, a, b, after] = [
                at(from.saturating_sub(1)),
                at(from),
                at(from + 1),
                at(from + 2),
            ];
            for part in 0..3_u8 {
                let t = f32::from(part) / 3.0;
                let place = (a * 2.0
                    + (b - before) * t
                    + (before * 2.0 - a * 5.0 + b * 4.0 - after) * (t * t)
                    + (a * 3.0 - before - b * 3.0 + after) * (t * t * t))
                    * 0.5;
                let color = profile[from].1.lerp(profile[from + 1].1, t);
                curve.push(([place.x.max(0.0), place.y], color));
            }
        }
        curve.push(profile[last]);
        curve
    }

    /// The gourd's outline from below to above, and radius and height of the place where a hand holds it.
    fn profile(
        chosen: &Chosen<'_>,
        form: Form,
        height: f32,
        radius: f32,
    ) -> (Vec<([f32; 2], Vec3)>, glam::Vec2) {
        let skin = chosen.ground();
        let row = |share: f32, wide: f32| {
            let shade = 0.9 + 0.1 * lole_geom::trig::sin(9.0 * share);
            ([radius * wide, height * share], skin * shade)
        };
        if form == Form::Single {
            let shares = [
                (0.0, 0.0),
                (0.01, 0.30),
                (0.08, 0.66),
                (0.20, 0.92),
                (0.34, 1.0),
                (0.48, 0.93),
                (0.62, 0.70),
                (0.74, 0.48),
                (0.86, 0.38),
                (0.97, 0.40),
                (1.0, 0.42),
            ];
            let mut rows: Vec<_> = shares.map(|(share, wide)| row(share, wide)).to_vec();
            // The cut mouth, dark inside.
            rows.push(([radius * 0.36, height], skin * 0.35));
            rows.push(([radius * 0.30, height * 0.8], skin * 0.12));
            return (rows, glam::Vec2::new(radius * 0.38, height * 0.86));
        }
        let lower = [
            (0.0, 0.0),
            (0.01, 0.32),
            (0.09, 0.70),
            (0.24, 0.95),
            (0.42, 1.0),
            (0.60, 0.92),
            (0.78, 0.66),
            (0.92, 0.42),
            (1.0, 0.34),
        ];
        let upper = [
            (0.02, 0.37),
            (0.06, 0.34),
            (0.22, 0.56),
            (0.46, 0.74),
            (0.68, 0.74),
            (0.86, 0.56),
            (0.97, 0.34),
            (1.0, 0.32),
        ];
        let mut rows: Vec<_> = (lower.iter())
            .map(|&(share, wide)| row(LOWER * share, wide))
            .collect();
        rows.extend(
            upper
                .iter()
                .map(|&(share, wide)| row(LOWER + (1.0 - LOWER) * share, wide)),
        );
        rows.push(([radius * 0.27, height], skin * 0.35));
        rows.push(([radius * 0.22, height * 0.9], skin * 0.12));
        (rows, glam::Vec2::new(radius * 0.35, height * LOWER))
    }
}
