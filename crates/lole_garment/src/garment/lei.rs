//! The lei for the neck: strung flowers, closed to a ring, or an open one whose ends hang.
//!
//! Makers give 35 to 40 inches for a ring, one and a quarter flowers to the inch, 50 plumeria for 40
//! inches. That the length follows the stature, and the length of an open one, are estimates.

use lole_language::words;
use lole_pattern::pattern::NotionKind;
use lole_pattern::{DraftError, Measure, Pattern};

use crate::drafting::accessory::{accessory, cord, counted};
use crate::drafting::chosen::{Chosen, by_measure, choice, number};
use crate::drafting::making::{cm, say, step, whole};
use crate::drafting::shape::CM;
use crate::fitting::Fitting;
use crate::sketch::Sketch;
use crate::template::{BesideRow, Choice, OptionRow, Options, Shelf, Template, Wear};

pub(crate) static TEMPLATE: Template = Template {
    id: "lei",
    name: words("レイ", "lei"),
    about: words("首に掛ける花のレイ", "a lei of strung flowers for the neck"),
    shelf: Shelf::Adornments,
    options: OPTIONS,
    draft,
    worn: Wear::Beside(BesideRow {
        make: worn::make,
        replaces_flower: |_| false,
    }),
    chest_room_deg: worn::CHEST_ROOM_DEG,
    natural: Some([0xf7f1e3, 0xfbf3e4, 0x2f6a34, 0xf2c14e]),
    sketch,
};

fn sketch(pen: &mut Sketch) {
    pen.ring([0.5, 0.5], [0.26, 0.36], [20.0, 0.05]);
}

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

fn draft(fitting: &Fitting<'_>, options: &Options) -> Result<Pattern, DraftError> {
    let measures = fitting.measures;
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

mod worn {
    //! The lei: strung flowers, closed to a ring that lies on the shoulders and hangs before and behind, or
    //! an open one of leaves, as maile is worn, whose ends hang before the body.

    use std::f32::consts::{PI, TAU};

    use glam::{Affine3A, Quat, Vec3};
    use lole_body::{Bone, PartKind};
    use lole_cloth::strands::{Ring, Strand, StrandConfig, Tie};
    use lole_geom::trig;
    use lole_pattern::DraftError;

    use crate::GarmentSpec;
    use crate::adorn::blade::Blade;
    use crate::adorn::body::{carrier_at, vertices};
    use crate::adorn::chosen::{Chosen, chance, real, whole};
    use crate::adorn::shape::{OnStrands, Shape};
    use crate::adorn::{AdornmentFinish, HangingStrands, Made, Rider, Surface, Wearer, flower};

    /// Opening of an elbow whose hand would go through flowers on the chest [°].
    pub(super) const CHEST_ROOM_DEG: f32 = 10.0;
    /// Length over the stature, as the template has it.
    const CLOSED: f64 = 0.63;
    const OPEN: f64 = 1.0;
    /// Distance of particles [m].
    const SPACING: f32 = 0.016;
    /// Radius of a plumeria, and how far the string keeps from skin [m]: petals give.
    const FLOWER: f32 = 0.028;
    const FLOWER_OFFSET: f32 = 0.011;
    /// The same of leaves twisted on a vine.
    const LEAF: [f32; 2] = [0.052, 0.019];
    const LEAF_OFFSET: f32 = 0.008;
    /// Mass per length [kg/m]: 50 flowers of 2.5 g on a meter, leafy vine. Estimated.
    const DENSITIES: [f32; 2] = [0.125, 0.06];
    /// Bending stiffness [N·m²]: over the shoulder a string of flowers turns within 4 cm. Estimated.
    const STIFFNESSES: [f32; 2] = [8.0e-5, 4.0e-5];
    /// Part of a closed lei that hangs before the body.
    const BEFORE: f32 = 0.58;
    /// Where it lies on the shoulders: beside the neck, over half the breadth of the shoulders.
    const BESIDE_NECK: f32 = 0.46;
    /// Friction of petals on skin and cloth. Estimated.
    const FRICTION: f32 = 0.5;
    /// What holds it where it lies, beside friction [m/N]: a dancer pins her lei.
    const PINNED: f32 = 0.004;
    const TRUNK: &[PartKind] = &[PartKind::Skin, PartKind::Leotard];

    /// Where a lei lies on a dancer as she stands.
    struct Neck {
        /// On the left shoulder and the right one, and on the nape [m].
        shoulders: [Rider; 2],
        nape: Rider,
        /// Farthest that the trunk reaches to the front [m].
        front: f32,
        /// Downwards there.
        chest_height: f32,
    }

    impl Neck {
        fn new(wearer: &Wearer<'_>, offset: f32) -> Self {
            let dancer = wearer.dancer;
            let neck = dancer.skeleton.joint(Bone::Neck);
            let arm = dancer.skeleton.joint(Bone::LeftUpperArm);
            let x = BESIDE_NECK * arm.x;
            let root = wearer.measures.neck_height.to_m_f32();
            let on_shoulder = |side: f32| {
                // Jaw and ears are above it.
                let height = vertices(dancer, TRUNK)
                    .filter(|v| (v.x - side * x).abs() < 0.016 && (v.z - neck.z).abs() < 0.025)
                    .filter(|v| root - 0.08 < v.y && v.y < root + 0.012)
                    .map(|v| v.y)
                    .fold(f32::NEG_INFINITY, f32::max);
                let height = if height.is_finite() { height } else { root };
                Self::rider(wearer, Vec3::new(side * x, height + offset, neck.z))
            };
            let behind = vertices(dancer, TRUNK)
                .filter(|v| v.x.abs() < 0.02 && (v.y - neck.y).abs() < 0.02 && v.z < neck.z)
                .map(|v| v.z)
                .fold(neck.z - 0.03, f32::min);
            let bust = dancer.landmarks.bust_height;
            let front = vertices(dancer, TRUNK)
                .filter(|v| bust - 0.15 < v.y && v.y < neck.y && v.x.abs() < arm.x)
                .map(|v| v.z)
                .fold(0.0, f32::max);
            Self {
                shoulders: [on_shoulder(1.0), on_shoulder(-1.0)],
                nape: Self::rider(wearer, Vec3::new(0.0, neck.y + 0.01, behind - offset)),
                front,
                chest_height: bust,
            }
        }

        fn rider(wearer: &Wearer<'_>, position: Vec3) -> Rider {
            Rider {
                position,
                outward: Vec3::Y,
                carrier: carrier_at(wearer.dancer, position, 0.04),
            }
        }
    }

    pub(super) fn make(spec: &GarmentSpec<'_>, wearer: &Wearer<'_>) -> Result<Made, DraftError> {
        let chosen = Chosen::new(spec)?;
        let is_closed = chosen.choice("form") != "open";
        let kind = usize::from(!is_closed);
        let stature = wearer.measures.stature.to_m();
        let length = chosen.m("length_cm", [CLOSED, OPEN][kind] * stature);
        let offset = [FLOWER_OFFSET, LEAF_OFFSET][kind];
        let neck = Neck::new(wearer, offset);
        let path = if is_closed {
            closed_path(wearer, &neck, length)
        } else {
            open_path(wearer, &neck, length)
        };
        let ring = if is_closed { Ring::Closed } else { Ring::Open };
        let count = whole(f64::from(length / SPACING)).max(12);
        let (positions, spacing) = spread(&path, count, ring, length);
        let strand = Strand {
            spacing,
            ring,
            pinned: Vec::new(),
            linear_density: DENSITIES[kind],
            bend_stiffness: STIFFNESSES[kind],
            contact_offset: offset,
            positions,
        };
        let (ties, tie_riders) = ties(wearer, &neck, &strand);
        let surfaces = if is_closed {
            let per_cm = chosen.number("flowers_per_cm_ratio", 0.5);
            vec![flowers(
                &chosen,
                &strand,
                whole(f64::from(length) * 100.0 * per_cm),
            )]
        } else {
            vec![leaves(&chosen, &strand)]
        };
        Ok(Made {
            surfaces,
            strands: Some(HangingStrands {
                strands: vec![strand],
                ties,
                tie_riders,
                config: StrandConfig {
                    drag_rate: 1.6,
                    friction: FRICTION,
                    // One long line of many particles: half a percent of stretch.
                    substep_count: 24,
                    ..StrandConfig::default()
                },
                passes_arms: true,
                ..HangingStrands::default()
            }),
            ..Made::default()
        })
    }

    /// Where a closed lei is let down from: level over the shoulders, half an oval before the neck and a
    /// smaller one behind.
    fn closed_path(wearer: &Wearer<'_>, neck: &Neck, length: f32) -> Vec<Vec3> {
        let [left, right] = [0, 1].map(|side| neck.shoulders[side].posed(wearer.stance)[0]);
        let middle = (left + right) * 0.5;
        let half = left.distance(right) * 0.5;
        let oval = |part: f32, towards: f32| {
            // Half the perimeter of an ellipse is about π √((a² + b²) / 2).
            let arc = part * length / PI;
            let depth = (2.0 * arc * arc - half * half).max(half * half).sqrt();
            (0..=40_u8).map(move |k| {
                let (sin, cos) = trig::sin_cos(PI * f32::from(k) / 40.0);
                let across = left.lerp(right, 0.5 - 0.5 * cos) - middle;
                middle + across * towards + Vec3::Z * (depth * sin * towards)
            })
        };
        // From the left shoulder over the chest to the right one and back behind the neck.
        oval(BEFORE, 1.0).chain(oval(1.0 - BEFORE, -1.0)).collect()
    }

    /// Where an open lei is let down from: behind the neck, over the shoulders and down before the chest.
    fn open_path(wearer: &Wearer<'_>, neck: &Neck, length: f32) -> Vec<Vec3> {
        let nape = neck.nape.posed(wearer.stance)[0];
        let [left, right] = [0, 1].map(|side| neck.shoulders[side].posed(wearer.stance)[0]);
        let half = |shoulder: Vec3| {
            let aside = (shoulder - nape).with_y(0.0);
            let round = nape + aside * Vec3::new(0.75, 0.0, 0.1);
            let ahead = Vec3::new(shoulder.x, shoulder.y, neck.front + 0.05);
            vec![
                round,
                shoulder,
                ahead,
                ahead.with_y(neck.chest_height - length),
            ]
        };
        let mut path = half(left);
        path.reverse();
        path.push(nape);
        path.extend(half(right));
        path
    }

    /// Particles at even distances along a path, and that distance [m]: an open one is cut to `length` about
    /// its middle, a closed one is drawn out to it by the solver.
    fn spread(path: &[Vec3], count: usize, ring: Ring, length: f32) -> (Vec<Vec3>, f32) {
        let mut line = path.to_vec();
        if ring == Ring::Closed {
            line.extend(path.first());
        }
        let mut ways = vec![0.0];
        for pair in line.windows(2) {
            ways.push(ways[ways.len() - 1] + pair[0].distance(pair[1]));
        }
        let whole = ways[ways.len() - 1];
        let at = |way: f32| {
            let next = ways
                .partition_point(|&known| known < way)
                .clamp(1, line.len() - 1);
            let step = (ways[next] - ways[next - 1]).max(1e-6);
            line[next - 1].lerp(line[next], ((way - ways[next - 1]) / step).clamp(0.0, 1.0))
        };
        if ring == Ring::Closed {
            let places = (0..count).map(|k| at(whole * real(k) / real(count)));
            return (places.collect(), length / real(count));
        }
        let spacing = length / real(count - 1);
        let start = 0.5 * (whole - length);
        let places = (0..count).map(|k| at(start + spacing * real(k)));
        (places.collect(), spacing)
    }

    /// The particles nearest to shoulders and nape are drawn there.
    fn ties(wearer: &Wearer<'_>, neck: &Neck, strand: &Strand) -> (Vec<Tie>, Vec<Rider>) {
        let riders = match strand.ring {
            Ring::Closed => neck.shoulders.to_vec(),
            Ring::Open => vec![neck.nape, neck.shoulders[0], neck.shoulders[1]],
        };
        let tie = |rider: &Rider| {
            let place = rider.posed(wearer.stance)[0];
            let apart = |k: &usize| strand.positions[*k].distance_squared(place);
            let nearest = (0..strand.positions.len()).min_by(|a, b| apart(a).total_cmp(&apart(b)));
            Tie {
                particle: u32::try_from(nearest.unwrap_or(0)).unwrap_or(0),
                compliance: PINNED,
            }
        };
        (riders.iter().map(tie).collect(), riders)
    }

    /// Plumeria strung through their hearts, each turned a little further than the one before.
    fn flowers(chosen: &Chosen<'_>, strand: &Strand, count: usize) -> Surface {
        let shape = flower::plumeria(FLOWER, chosen.flower(), chosen.shadow());
        // Faces look along the string: +Y of the flower becomes +Z of the strand.
        let forward = Affine3A::from_quat(Quat::from_rotation_x(0.5 * PI));
        let mut on = OnStrands::default();
        let particles = real(strand.positions.len());
        for one in 0..count {
            let turn = Quat::from_rotation_z(TAU * 0.37 * real(one) + 0.3 * chance(one, 31));
            let tilt = Quat::from_rotation_x(0.22 * chance(one, 32));
            let mut placed = Shape::default();
            placed.add(&shape, &(Affine3A::from_quat(turn * tilt) * forward));
            let light = 0.95 + 0.05 * chance(one, 33);
            let along = particles * real(one) / real(count.max(1));
            on.add_whole(&placed.tinted(Vec3::splat(light)), (0, along));
        }
        on.surface(AdornmentFinish::Petal)
    }

    /// Pairs of leaves along a vine, pointing to its ends.
    fn leaves(chosen: &Chosen<'_>, strand: &Strand) -> Surface {
        let leaf = Blade {
            length: LEAF[0],
            width: LEAF[1],
            fold: 0.3,
            droop: 0.15,
            color: chosen.leaf(),
        };
        let mut on = OnStrands::default();
        let last = strand.positions.len() - 1;
        let vine = Shape::sheet([4 * last, 4], |along, across| {
            let (sin, cos) = trig::sin_cos(-TAU * across);
            let place = Vec3::new(
                0.003 * sin,
                0.003 * cos,
                along * real(last) * strand.spacing,
            );
            (place, leaf.color * 0.5)
        });
        on.add_bent(&vine, (0, strand.spacing));
        // Two leaves on each particle, every pair turned a third of the way around.
        for particle in 0..=last {
            let towards_end = if 2 * particle < last { PI } else { 0.0 };
            for side in 0..2 {
                let one = 2 * particle + side;
                let around = PI * real(side) + 2.1 * real(particle) + 0.3 * chance(one, 41);
                let open = Quat::from_rotation_x(-0.62 - 0.2 * chance(one, 42));
                let turn =
                    Quat::from_rotation_z(around) * Quat::from_rotation_y(towards_end) * open;
                let mut placed = Shape::default();
                placed.add(&leaf.varied(one).shape(3), &Affine3A::from_quat(turn));
                on.add_whole(&placed, (0, real(particle)));
            }
        }
        on.surface(AdornmentFinish::Leaf)
    }
}
