//! The ʻuliʻuli: a rattle of a small gourd under a disc of cloth and feathers, held in the hand.
//!
//! A gourd with a feather disc, two of them in ʻauana. Sizes, feathers and seeds are estimates; halau buy
//! theirs or learn the making from their kumu.

use kurbo::Vec2;
use lole_language::words;

use super::accessory::{accessory, counted};
use super::chosen::{Chosen, count, number};
use super::making::{cm, edges_of, say, step, stitching, whole};
use super::shape::{CM, DOWN, Label, at, curve, edge};
use super::{OptionRow, Options, Template};
use crate::pattern::{Notion, NotionKind};
use crate::piece::{CutCount, Finish, Mark, Piece};
use crate::{DraftError, Measures, Pattern};

pub(super) const TEMPLATE: Template = Template {
    id: "uliuli",
    name: words("ウリウリ", "ʻuliʻuli"),
    about: words(
        "羽根の付いたひょうたんのがらがら",
        "a gourd rattle with a disc of feathers",
    ),
    options: OPTIONS,
    draft,
    worn: None,
};

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

fn draft(_measures: &Measures, options: &Options) -> Result<Pattern, DraftError> {
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
