//! The ʻuliʻuli: a rattle of a small gourd under a disc of cloth and feathers, held in the hand.
//!
//! A gourd with a feather disc, two of them in ʻauana. Sizes, feathers and seeds are estimates; halau buy
//! theirs or learn the making from their kumu.

use kurbo::Vec2;
use lole_language::words;
use lole_pattern::pattern::{Notion, NotionKind};
use lole_pattern::piece::{CutCount, Finish, Mark, Piece};
use lole_pattern::{DraftError, Pattern};

use crate::drafting::accessory::{accessory, counted};
use crate::drafting::chosen::{Chosen, count, number};
use crate::drafting::making::{cm, edges_of, say, step, stitching, whole};
use crate::drafting::shape::{CM, DOWN, Label, at, curve, edge};
use crate::fitting::Fitting;
use crate::sketch::{Sketch, Tone};
use crate::template::{BesideRow, OptionRow, Options, Shelf, Template, Wear};

pub(crate) static TEMPLATE: Template = Template {
    id: "uliuli",
    name: words("ウリウリ", "ʻuliʻuli"),
    about: words(
        "羽根の付いたひょうたんのがらがら",
        "a gourd rattle with a disc of feathers",
    ),
    shelf: Shelf::Implements,
    options: OPTIONS,
    draft,
    worn: Wear::Beside(BesideRow {
        make: worn::make,
        replaces_flower: |_| false,
    }),
    chest_room_deg: 0.0,
    natural: Some([0xc8102e, 0xf2c230, 0x3e7a2c, 0x7a4a22]),
    sketch,
};

fn sketch(pen: &mut Sketch) {
    pen.ring([0.5, 0.3], [0.26, 0.12], [14.0, 0.08]);
    pen.disc([0.5, 0.3], 0.16, Tone::Cloth);
    pen.patch(
        &[[0.46, 0.46], [0.54, 0.46], [0.54, 0.66], [0.46, 0.66]],
        Tone::Leaf,
    );
    pen.disc([0.5, 0.76], 0.14, Tone::Rgb([214, 180, 130]));
}

const OPTIONS: &[OptionRow] = &[
    count("rattle_count", [1, 2], 2, words("本数", "how many")),
    number(
        "disc_cm",
        [10.0, 45.0],
        25.0,
        words("布の円盤の直径", "across the cloth disc"),
    ),
    number(
        "gourd_cm",
        [5.0, 18.0],
        10.0,
        words("ひょうたんの直径", "across the gourd"),
    ),
];

/// The disc's rim takes a feather for each of these [m]. Estimated.
const FEATHER_SPACING: f64 = 0.8 * CM;
/// Allowance of the rim [m].
const RIM: f64 = 1.0 * CM;
/// Seeds in one gourd. Estimated: they are taken out and put in by the sound.
const SEEDS: u32 = 20;
/// Feathers lie in this many rings. Estimated.
const FEATHER_RINGS: f64 = 3.0;

fn draft(_: &Fitting<'_>, options: &Options) -> Result<Pattern, DraftError> {
    let chosen = Chosen::new(OPTIONS, options)?;
    let rattles = chosen.count("rattle_count");
    let (disc, gourd) = (chosen.m("disc_cm"), chosen.m("gourd_cm"));
    let feathers = whole(std::f64::consts::PI * disc / FEATHER_SPACING * FEATHER_RINGS) * rattles;
    let piece = circle(0.5 * disc, 2 * rattles);
    let [disc_cm, cut_cm, gourd_cm] = [disc, disc + 2.0 * RIM, gourd].map(cm);
    let rim_cm = cm(RIM);
    let discs = 2 * rattles;
    let steps = vec![
        step(
            words("ひょうたんを用意する", "Prepare the gourds"),
            say!(
                "直径 {gourd_cm} cm ほどの乾いたひょうたん {rattles} 個に種（アリイポエ）を入れ、口に持ち手を通して留めます。",
                "Put seeds (aliʻipoe) into {rattles} dry gourds of about {gourd_cm} cm and fasten a handle through the mouth of each."
            ),
            [60.0, 60.0],
        ),
        step(
            words("円盤を縫う", "Sew the discs"),
            say!(
                "縫い代 {rim_cm} cm を含めて直径 {cut_cm} cm の円を {discs} 枚裁ち、2 枚ずつ中表に縫い、返し口から表に返します。直径 {disc_cm} cm の厚紙の円を入れて閉じます。",
                "Cut {discs} rounds of {cut_cm} cm, {rim_cm} cm of allowance included, and sew them in twos, right sides together, but for a gap. Turn them, slip in a round of card of {disc_cm} cm and close them."
            ),
            stitching(std::f64::consts::PI * disc * f64::from(rattles)),
        )
        .shown(edges_of(0, &[0])),
        step(
            words("羽根を付ける", "Set on the feathers"),
            say!(
                "円盤のふちから内へ 3 周、羽根を全部で {feathers} 本縫い付け、中心を持ち手の上に留めます。",
                "Sew {feathers} feathers on in three rings from the rim inwards and fasten the middle of each disc to its handle."
            ),
            [180.0, 180.0],
        ),
    ];
    let notions = notions(rattles, feathers, &[disc_cm, gourd_cm]);
    let estimate = say!(
        "大きさと羽根の数は目安です。買うときはクムの薦める店のものを選んでください",
        "sizes and feathers are estimates; to buy them, ask your kumu where"
    );
    Ok(accessory(vec![piece], notions, steps, estimate))
}

/// What one or two rattles take beside cloth: feathers in all, and the diameters of disc and gourd [cm].
fn notions(rattles: u32, feathers: u32, [disc_cm, gourd_cm]: &[String; 2]) -> Vec<Notion> {
    vec![
        counted(
            NotionKind::Gourd,
            words("小さなひょうたん", "small gourds"),
            rattles,
            say!("直径 {gourd_cm} cm ほど", "about {gourd_cm} cm across"),
        ),
        counted(
            NotionKind::Seed,
            words("種（アリイポエ）", "seeds (aliʻipoe)"),
            SEEDS * rattles,
            say!(
                "一つに {SEEDS} 粒ほど。音を聞いて加減します",
                "about {SEEDS} in each; go by the sound"
            ),
        ),
        counted(
            NotionKind::Handle,
            words("持ち手", "handles"),
            rattles,
            say!(
                "木や籐で、手のひらに収まる太さのもの",
                "of wood or cane, as thick as your hand likes"
            ),
        ),
        counted(
            NotionKind::Card,
            words("厚紙", "sheets of card"),
            rattles,
            say!(
                "直径 {disc_cm} cm の円が取れる大きさ",
                "large enough for a round of {disc_cm} cm"
            ),
        ),
        counted(
            NotionKind::Feather,
            words("羽根", "feathers"),
            feathers,
            say!("ふちから 3 周分", "for three rings from the rim"),
        ),
    ]
}

/// A round of cloth, its middle marked.
fn circle(radius: f64, count: u32) -> Piece {
    /// Handle of a cubic that follows a quarter of a circle.
    const QUARTER: f64 = 0.552_284_749_830_793_4;
    let points = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)];
    let arc = |index: usize| {
        let (from, to) = (points[index], points[(index + 1) % 4]);
        let handle = |(x, y): (f64, f64)| Vec2::new(-y, x) * (QUARTER * radius);
        let place = |(x, y): (f64, f64)| at(x * radius, y * radius);
        curve(place(from), handle(from), handle(to), place(to))
    };
    let rim = edge("rim", (0..4).map(arc).collect(), Finish::Raw, RIM);
    let middle = Mark::Point {
        name: words("中心", "middle"),
        at: at(0.0, 0.0),
    };
    let label = Label::main("disc", words("円盤", "disc"), CutCount::Alike(count));
    label.piece(vec![rim], DOWN, vec![middle])
}

mod worn {
    //! The ʻuliʻuli: a gourd rattle under a disc of feathers, its handle in the fist.

    use std::f32::consts::TAU;

    use glam::{Affine3A, Quat, Vec3};
    use lole_body::Side;
    use lole_pattern::DraftError;

    use crate::GarmentSpec;
    use crate::adorn::blade::Petal;
    use crate::adorn::body::bone_alone;
    use crate::adorn::chosen::{Chosen, chance, real};
    use crate::adorn::grip::{Grip, Palm};
    use crate::adorn::shape::{Shape, affine};
    use crate::adorn::{AdornmentFinish, Made, Wearer};

    /// Half the flesh of a palm, thickness of the handle and room for the fist [m], of the mean woman.
    const HALF_PALM: f32 = 0.014;
    const HANDLE: f32 = 0.026;
    const FIST: f32 = 0.095;
    /// Length of a feather over the disc's radius, and feathers to a ring.
    const FEATHER: f32 = 0.50;
    const FEATHERS: usize = 38;

    /// Where the feathers look: to whoever watches, and a little up.
    const FEATHERS_FACE: Vec3 = Vec3::new(0.0, 0.5, 0.85);

    pub(super) fn make(spec: &GarmentSpec<'_>, wearer: &Wearer<'_>) -> Result<Made, DraftError> {
        let chosen = Chosen::new(spec)?;
        let skeleton = &wearer.dancer.skeleton;
        let size = (wearer.dancer.landmarks.crown_height / 1.58).clamp(0.6, 1.25);
        let sides: &[Side] = if chosen.count("rattle_count") < 2 {
            &[Side::Right]
        } else {
            &[Side::Right, Side::Left]
        };
        let [gourd, feathers] = rattle(&chosen, size);
        let mut made = Made::default();
        for &side in sides {
            let palm = Palm::new(skeleton, side, HALF_PALM * size);
            // The gourd lies beside the little finger, the feathers beyond the thumb.
            let up = -palm.to_little;
            let axes = [palm.along, up, palm.along.cross(up)];
            let place = affine(axes, palm.center + palm.out * (0.5 * HANDLE * size));
            let hand = bone_alone(palm.hand);
            for (shape, finish) in [
                (&gourd, AdornmentFinish::Wood),
                (&feathers, AdornmentFinish::Feather),
            ] {
                let mut held = Shape::default();
                held.add(shape, &place);
                made.surfaces.push(held.ridden(finish, hand));
            }
            made.grips.push(Grip {
                side,
                thickness: HANDLE * size,
                facing: Some(FEATHERS_FACE),
                arm: None,
            });
        }
        Ok(made)
    }

    /// Gourd with its handle, and the disc with its feathers, upright about the middle of the fist.
    fn rattle(chosen: &Chosen<'_>, size: f32) -> [Shape; 2] {
        let radius = 0.5 * chosen.m("gourd_cm", 0.10);
        let disc = 0.5 * chosen.m("disc_cm", 0.25);
        let (half, handle) = (0.5 * FIST * size, 0.5 * HANDLE * size);
        let wood = chosen.shadow();
        let below = -half - radius * 0.92;
        let mut profile = vec![([0.0, below - radius], wood * 0.9)];
        for k in 1..10_u8 {
            let (sin, cos) = lole_geom::trig::sin_cos(std::f32::consts::PI * f32::from(k) / 10.6);
            profile.push(([radius * sin, below - radius * cos], wood));
        }
        profile.push(([handle, -half], wood * 0.7));
        profile.push(([handle * 0.85, half], wood * 0.55));
        let gourd = Shape::turned(20, &profile);
        let mut feathers = Shape::turned(
            28,
            &[
                ([0.0, half], chosen.ground() * 0.8),
                ([disc * 0.92, half + 0.004], chosen.ground()),
                ([disc, half + 0.010], chosen.ground() * 0.9),
                ([disc * 0.9, half + 0.018], chosen.ground()),
                ([0.0, half + 0.022], chosen.ground()),
            ],
        );
        let length = FEATHER * disc;
        // From the rim inwards: each ring lies on the one outside it, its color in turn.
        for (ring, (seat, color)) in [
            (0.86, chosen.flower()),
            (0.58, chosen.ground()),
            (0.30, chosen.flower()),
            (0.06, chosen.ground()),
        ]
        .into_iter()
        .enumerate()
        {
            let count = FEATHERS - 8 * ring;
            for one in 0..count {
                let feather = Petal {
                    length: length * (1.0 + 0.10 * chance(one, 50 + ring)),
                    width: TAU * disc * (seat + 0.45) / real(count) * 1.25,
                    cup: 0.20 + 0.06 * chance(one, 60 + ring),
                    lean: 0.25,
                    ruffle: 0.02,
                    colors: [color * 0.6, color, color * (0.95 + 0.05 * chance(one, 70))],
                };
                let around = TAU * (real(one) + 0.5 * real(ring % 2)) / real(count);
                let place = Affine3A::from_quat(Quat::from_rotation_y(around))
                    * Affine3A::from_translation(Vec3::new(
                        0.0,
                        half + 0.016 + 0.008 * real(ring),
                        seat * disc,
                    ));
                feathers.add(&feather.shape([3, 2]), &place);
            }
        }
        [gourd, feathers]
    }
}
