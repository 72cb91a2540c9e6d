//! The muʻumuʻu: a wide dress that hangs in gathers from a yoke, with short sleeves and a ruffle.
//!
//! Folkwear's pattern 160 and circular 351 of the University of Hawaiʻi describe it: gathers to a yoke,
//! room for every figure. Yoke and armholes come from the bodice [block](crate::drafting::block); the dart of the
//! front is opened into the gathers. How full and how deep things are is an estimate and an option.

use kurbo::{Affine, ParamCurve as _, Vec2};
use lole_geom::Length;
use lole_language::words;
use lole_pattern::pattern::{Amount, FinishedMeasure, Notion, NotionKind, Seam, Step};
use lole_pattern::piece::{CutCount, Edge, Finish, LineKind, Piece};
use lole_pattern::{DraftError, Measure, Measures, Pattern};

use super::blouse::{
    ARM_EASE, BUST_EASE, NECK_LOWER, NECK_LOWER_KEY, NECK_WIDER, PUFF, SLEEVE_CASING, flat_front,
    set_in, sleeve_elastic, sleeve_steps,
};
use super::pau_skirt::HEM_HEIGHT;
use crate::drafting::altered::altered;
use crate::drafting::block::{Block, Fit};
use crate::drafting::chosen::{Chosen, choice, number};
use crate::drafting::fitted::{
    FITTED_SEAM, binding, binding_seams, binding_step, closing_step, cutting_step, hem_fullness,
    hem_step, place, shown,
};
use crate::drafting::making::{
    both_sides, cm, eased, gathered, notion, pattern, plain, say, sewn, side, step,
};
use crate::drafting::shape::{
    AROUND, CM, DOWN, Label, at, back_notch, beside, curve, edge, line, marked, notch, rectangle,
};
use crate::drafting::sleeve::{ArmholePart, Sleeve, SleeveFit};
use crate::drafting::work::{Work, minutes};
use crate::drafting::yoke::{Yoked, opened_armhole};
use crate::fitting::Fitting;
use crate::sketch::Sketch;
use crate::template::{Choice, OptionRow, Options, Shelf, Template, Wear};

pub(crate) static TEMPLATE: Template = Template {
    id: "muumuu",
    name: words("ムームー", "muʻumuʻu"),
    about: words(
        "ヨークからギャザーで広がるゆったりしたドレス",
        "a wide dress that falls in gathers from a yoke",
    ),
    shelf: Shelf::Dresses,
    options: OPTIONS,
    draft,
    worn: Wear::Sewn(worn::ROW),
    chest_room_deg: 10.0,
    natural: None,
    sketch,
};

fn sketch(pen: &mut Sketch) {
    pen.dress(0.2, 0.32);
    pen.line(&[[0.34, 0.24], [0.66, 0.24]]);
}

pub(crate) const SLEEVES: &[Choice] = &[
    Choice {
        id: "puff",
        name: words("ふくらんだ袖", "puffed"),
    },
    Choice {
        id: "plain",
        name: words("ふつうの半袖", "plain"),
    },
];

const OPTIONS: &[OptionRow] = &[
    number("hem_height_cm", [0.0, 110.0], 15.0, HEM_HEIGHT),
    number("bust_ease_cm", [4.0, 30.0], 10.0, BUST_EASE),
    number(
        "gather_ratio",
        [1.2, 3.0],
        1.6,
        words(
            "ヨークに付く布÷ヨーク",
            "cloth over the yoke that it is gathered to",
        ),
    ),
    number(
        "flare_cm",
        [0.0, 40.0],
        12.0,
        words("脇の裾の広がり", "how far each side goes out to the hem"),
    ),
    number("neck_wider_cm", [0.0, 8.0], 2.5, NECK_WIDER),
    number(NECK_LOWER_KEY, [0.0, 10.0], 3.0, NECK_LOWER),
    choice("sleeve", SLEEVES, words("袖の形", "shape of the sleeves")),
    number("puff_ratio", [1.1, 2.2], 1.4, PUFF),
    number(
        "ruffle_cm",
        [0.0, 60.0],
        22.0,
        words(
            "裾のフリルの丈。2 より短ければなし",
            "ruffle at the hem; none where it is under 2",
        ),
    ),
    number(
        "ruffle_ratio",
        [1.1, 3.0],
        1.5,
        words("フリルの長さ÷裾", "ruffle over the edge that it is sewn to"),
    ),
    number(
        "hem_allowance_cm",
        [0.5, 15.0],
        3.0,
        words("裾上げの分", "cloth for the hem"),
    ),
];

/// What a neckline must be longer than a head to go over it [m].
const OVER_HEAD: f64 = 2.0 * CM;
/// Sleeves over the length of the upper arm.
const SLEEVE_SHARE: f64 = 0.75;
/// The sleeve's elastic over the arm.
const ARM_ELASTIC: f64 = 1.0;

/// Pieces, in their order.
const FRONT: usize = 0;
const BACK: usize = 1;
const FRONT_YOKE: usize = 2;
const BACK_YOKE: usize = 3;
const SLEEVE: usize = 4;
const BINDING: usize = 5;
const RUFFLE: usize = 6;

/// The armhole among the edges of front and back.
const ARMHOLE: usize = 2;

fn draft(fitting: &Fitting<'_>, options: &Options) -> Result<Pattern, DraftError> {
    altered(fitting, |fitting| drafted(fitting, options))
}

fn drafted(fitting: &Fitting<'_>, options: &Options) -> Result<Pattern, DraftError> {
    let measures = fitting.measures;
    let chosen = Chosen::new(OPTIONS, options)?;
    measures.check(&[Measure::HeadGirth, Measure::UpperArmLength])?;
    let lower = chosen.m(NECK_LOWER_KEY);
    let block = Block::new(
        measures,
        &Fit {
            bust_ease: chosen.m("bust_ease_cm"),
            neck_widened: chosen.m("neck_wider_cm"),
            neck_dropped: [lower, 0.25 * lower],
            armhole_dropped: 1.0 * CM,
            alterations: fitting.alterations,
        },
    )?;
    let yokes = Yoked::both(&block, &chosen)?;
    let sleeve = sleeve(fitting, (&block, &yokes), &chosen)?;
    let skirt = Skirt::new(measures, &block, &chosen)?;
    let neckline = block.neckline_length();
    let slit = 0.5 * (measures.head_girth.to_m() + OVER_HEAD - neckline).max(0.0);
    let ends = if 0.0 < slit {
        Finish::Hem
    } else {
        Finish::Seam
    };
    let front_label = Label::main(
        "front_yoke",
        words("前ヨーク", "front yoke"),
        CutCount::Alike(1),
    );
    let back_label = Label::main(
        "back_yoke",
        words("後ろヨーク", "back yoke"),
        CutCount::Alike(1),
    );
    let mut back_yoke = yokes[1].piece(
        &block.back,
        back_label,
        ("center_back", Finish::Fold),
        back_notch,
    );
    let lowest = block.back.center.y - yokes[1].level - 1.0 * CM;
    let slit = slit.min(lowest.max(0.0));
    if 0.0 < slit {
        let from = block.back.center;
        let to = from - Vec2::new(0.0, slit);
        back_yoke
            .marks
            .insert(0, marked(LineKind::Slit, &[from, to]));
    }
    let mut pieces = vec![
        skirt.front(&yokes[0], &block),
        skirt.back(&yokes[1]),
        yokes[0].piece(
            &block.front,
            front_label,
            ("center_front", Finish::Fold),
            notch,
        ),
        back_yoke,
        sleeve.piece.clone(),
        binding(neckline, ends),
    ];
    if 0.0 < skirt.ruffle {
        pieces.push(skirt.ruffle(&pieces));
    }
    let arm = fitting.arm() * ARM_ELASTIC;
    let worn = (measures, &skirt, arm);
    Ok(finish(pieces, worn, (&sleeve, &yokes, slit)))
}

fn sleeve(
    fitting: &Fitting<'_>,
    (block, yokes): (&Block, &[Yoked; 2]),
    chosen: &Chosen<'_>,
) -> Result<Sleeve, DraftError> {
    let is_puff = chosen.choice("sleeve") == "puff";
    let measures = fitting.measures;
    let long = SLEEVE_SHARE * measures.upper_arm_length.to_m();
    Sleeve::new(
        measures,
        (block, Some(yokes)),
        &SleeveFit {
            length: long + if is_puff { 2.0 * CM } else { 0.0 },
            arm_ease: ARM_EASE + 2.0 * CM,
            cap_ratio: if is_puff {
                chosen.number("puff_ratio")
            } else {
                1.02
            },
            crown_raised: if is_puff { 2.0 * CM } else { 0.0 },
            hem_width: None,
            hem: SLEEVE_CASING,
            cap_height: if is_puff { 0.75 } else { 0.66 },
            widened: fitting.widened_sleeve(),
        },
    )
}

/// The two parts that hang from the yokes.
#[derive(Debug, Clone, Copy)]
struct Skirt {
    ratio: f64,
    flare: f64,
    hem_y: f64,
    hem: f64,
    bust_line: f64,
    flat_front: f64,
    back: f64,
    ruffle: f64,
    ruffle_ratio: f64,
}

/// Allowance of seams within the dress [m].
const SEAM: f64 = 1.0 * CM;
/// A shorter ruffle is none [m].
const LEAST_RUFFLE: f64 = 2.0 * CM;
/// A skirt from underarm to hem, at least [m].
const LEAST_SKIRT: f64 = 20.0 * CM;

impl Skirt {
    fn new(measures: &Measures, block: &Block, chosen: &Chosen<'_>) -> Result<Self, DraftError> {
        let asked = chosen.m("ruffle_cm");
        let ruffle = if asked < LEAST_RUFFLE { 0.0 } else { asked };
        let hem_height = chosen.m("hem_height_cm");
        let hem_y = hem_height - measures.waist_height.to_m() + ruffle;
        if block.bust_line < hem_y + LEAST_SKIRT {
            return Err(DraftError::TooShort {
                hem_cm: hem_height / CM,
                finished_cm: (block.bust_line - hem_y + ruffle) / CM,
                band_cm: (LEAST_SKIRT + ruffle) / CM,
            });
        }
        Ok(Self {
            ratio: chosen.number("gather_ratio"),
            flare: chosen.m("flare_cm"),
            hem_y,
            hem: if 0.0 < ruffle {
                SEAM
            } else {
                chosen.m("hem_allowance_cm")
            },
            bust_line: block.bust_line,
            flat_front: flat_front(block),
            back: block.back.underarm.x,
            ruffle,
            ruffle_ratio: chosen.number("ruffle_ratio"),
        })
    }

    /// Cloth that is added at the fold, so that the upper edge is `ratio` times the yoke.
    fn spread(&self, yoked: &Yoked) -> f64 {
        (self.ratio - 1.0) * yoked.end.x
    }

    fn front(&self, yoked: &Yoked, block: &Block) -> Piece {
        let spread = self.spread(yoked);
        let armhole = opened_armhole(yoked, block, spread);
        let label = Label::main("front", words("前スカート", "front"), CutCount::Alike(1));
        let x = self.flat_front + spread;
        let mut piece = self.piece(label, (armhole, yoked.level), x, "center_front");
        piece.marks.extend(yoked.notch_below(ARMHOLE, notch));
        piece
    }

    fn back(&self, yoked: &Yoked) -> Piece {
        let spread = self.spread(yoked);
        let moved = Affine::translate((spread, 0.0));
        let way = yoked.lower.iter().map(|segment| moved * *segment).collect();
        let armhole = edge("armhole", way, Finish::Seam, SEAM);
        let label = Label::main("back", words("後ろスカート", "back"), CutCount::Alike(1));
        let x = self.back + spread;
        let mut piece = self.piece(label, (armhole, yoked.level), x, "center_back");
        piece.marks.extend(yoked.notch_below(ARMHOLE, back_notch));
        piece
    }

    /// `level` is the yoke line's at the middle, `x` the underarm's.
    fn piece(
        &self,
        label: Label,
        (armhole, level): (Edge, f64),
        x: f64,
        center: &'static str,
    ) -> Piece {
        let underarm = armhole.segments[0].start();
        let end = armhole
            .segments
            .last()
            .map_or(underarm, kurbo::PathSeg::end);
        debug_assert!(
            (underarm.x - x).abs() < 1.0e-6 && (underarm.y - self.bust_line).abs() < 1.0e-6
        );
        let hem_end = at(x + self.flare, self.hem_y);
        let foot = at(0.0, self.hem_y);
        let top = at(0.0, level);
        // The upper edge leaves the fold level and comes to the armhole square to it, or nearly.
        let run = end.x - top.x;
        let towards_middle = Vec2::new(-0.35 * run, (level - end.y).max(0.0) * 0.5);
        let upper = curve(end, towards_middle, Vec2::new(-0.35 * run, 0.0), top);
        // The hem rises to the sides, so that it hangs level: square to the side.
        let rise = self.side_rise();
        let hem_side = at(hem_end.x, hem_end.y + rise);
        // A parabola from the fold, level there.
        let third = hem_side.x / 3.0;
        let (level_out, rising) = (Vec2::new(third, 0.0), Vec2::new(third, 2.0 * rise / 3.0));
        let level_hem = curve(foot, level_out, rising, hem_side);
        let hem_finish = if 0.0 < self.ruffle {
            Finish::Seam
        } else {
            Finish::Hem
        };
        let edges = vec![
            edge("hem", vec![level_hem], hem_finish, self.hem),
            edge(
                "side",
                vec![line(hem_side, underarm)],
                Finish::Seam,
                FITTED_SEAM,
            ),
            armhole,
            edge("yoke", vec![upper], Finish::Seam, SEAM),
            edge(center, vec![line(top, foot)], Finish::Fold, 0.0),
        ];
        let gathers = beside(
            LineKind::Gather,
            &edges[3],
            -0.4 * CM,
            [0.0, edges[3].length()],
        );
        label.piece(edges, DOWN, vec![gathers])
    }

    /// How much shorter the side is cut, so that it is as long as the middle: it leans.
    fn side_rise(&self) -> f64 {
        let height = self.bust_line - self.hem_y;
        ((height * height + self.flare * self.flare).sqrt() - height).min(0.3 * height)
    }

    fn ruffle(&self, pieces: &[Piece]) -> Piece {
        let around: f64 = [FRONT, BACK]
            .map(|piece| pieces[piece].edges[0].length())
            .iter()
            .sum();
        let long = around * self.ruffle_ratio;
        let sides = [
            ("hem", Finish::Hem, 3.0 * CM),
            ("left_end", Finish::Seam, SEAM),
            ("top", Finish::Seam, SEAM),
            ("right_end", Finish::Seam, SEAM),
        ];
        let label = Label::main("ruffle", words("裾のフリル", "ruffle"), CutCount::Pairs(1));
        let mut piece = rectangle(label, [long, self.ruffle], sides, AROUND);
        let gathers = beside(LineKind::Gather, &piece.edges[2], -0.4 * CM, [0.0, long]);
        piece.marks.push(gathers);
        piece
    }
}

fn finish(
    pieces: Vec<Piece>,
    (measures, skirt, arm): (&Measures, &Skirt, f64),
    (sleeve, yokes, slit): (&Sleeve, &[Yoked; 2], f64),
) -> Pattern {
    let of = |piece: usize, id: &str| place(&pieces[piece], id);
    let whole = |piece: usize, id: &str| side(piece, 0, of(piece, id));
    let mut seams: Vec<Seam> = Vec::new();
    for (body, yoke) in [(FRONT, FRONT_YOKE), (BACK, BACK_YOKE)] {
        // The yoke's edge runs to the side, the skirt's back to the middle.
        let onto = gathered(whole(yoke, "yoke"), whole(body, "yoke").back());
        seams.extend(both_sides(onto));
    }
    let of_yokes: Vec<usize> = (0..seams.len()).collect();
    let shoulders = eased(whole(FRONT_YOKE, "shoulder"), whole(BACK_YOKE, "shoulder"));
    seams.extend(both_sides(shoulders));
    seams.extend(both_sides(plain(whole(BACK, "side"), whole(FRONT, "side"))));
    let closing: Vec<usize> = (of_yokes.len()..seams.len()).collect();
    let first = seams.len();
    let parts = |body: usize, yoke: usize, cut: &Yoked| {
        let part = |piece, share| ArmholePart {
            piece,
            edge: of(piece, "armhole"),
            share,
        };
        let lower = cut.lower_share();
        [part(body, lower), part(yoke, 1.0 - lower)]
    };
    let [front, back] = yokes;
    let armholes = [
        parts(BACK, BACK_YOKE, back),
        parts(FRONT, FRONT_YOKE, front),
    ];
    seams.extend(sleeve.seams(SLEEVE, [&armholes[0], &armholes[1]]));
    let of_sleeve = set_in(&seams, first);
    let necklines = [
        (BACK_YOKE, of(BACK_YOKE, "neckline")),
        (FRONT_YOKE, of(FRONT_YOKE, "neckline")),
    ];
    seams.extend(binding_seams(&pieces, BINDING, necklines));
    let has_ruffle = 0.0 < skirt.ruffle;
    if has_ruffle {
        seams.extend(ruffle_seams(&pieces));
    }
    // The last four are those onto the hem: the first of the front, and the first of the back.
    let onto_hem = vec![seams.len().saturating_sub(4), seams.len().saturating_sub(2)];
    let notions = notions(arm, slit);
    let mut steps = vec![cutting_step(&pieces)];
    steps.push(yoke_step(&pieces, of_yokes));
    let meters = 2.0 * pieces[FRONT].edges[1].length() + 4.0 * 0.12;
    let shoulder =
        [FRONT_YOKE, BACK_YOKE].map(|yoke| pieces[yoke].edges[of(yoke, "shoulder")].length());
    steps.push(closing_step(
        words("肩と脇を縫う", "Sew shoulders and sides"),
        (meters, shoulder),
        closing,
    ));
    steps.extend((0.0 < slit).then(|| slit_step(slit)));
    let neckline = pieces[BINDING].edges[0].length();
    steps.push(binding_step(
        neckline,
        shown(&pieces, FRONT_YOKE, &["neckline"]),
    ));
    steps.extend(sleeve_steps(sleeve, arm, (SLEEVE, of_sleeve)));
    if has_ruffle {
        steps.push(ruffle_step(&pieces, onto_hem));
    }
    let hem = hem_around(&pieces);
    steps.push(lowest_step(&pieces, skirt, hem));
    let finished = finished(measures, skirt, (sleeve, arm), hem);
    pattern(pieces, seams, notions, steps)
        .measuring(finished)
        .drawn_in(SLEEVE, crate::drafting::sleeve::HEM, Length::from_m(arm))
}

/// How the lowest edge is hemmed: that of the ruffle, where there is one.
fn lowest_step(pieces: &[Piece], skirt: &Skirt, around: f64) -> Step {
    let (last, depth) = if 0.0 < skirt.ruffle {
        (RUFFLE, 3.0 * CM)
    } else {
        (FRONT, skirt.hem)
    };
    let edge = &pieces[last].edges[place(&pieces[last], "hem")];
    let full = (depth, hem_fullness(edge, depth));
    hem_step(full, around, shown(pieces, last, &["hem"]))
}

/// What a tape says of the dress: it hangs from the yoke, wide everywhere below.
fn finished(
    measures: &Measures,
    skirt: &Skirt,
    (sleeve, arm): (&Sleeve, f64),
    hem: f64,
) -> Vec<FinishedMeasure> {
    let yoked = 2.0 * (skirt.flat_front + skirt.back);
    vec![
        sewn(
            words(
                "バスト（ヨークの下のギャザーを除く）",
                "bust, without the gathers below the yoke",
            ),
            Some(measures.bust_girth),
            yoked,
        ),
        sewn(
            words("袖口（ゴム）", "edge of the sleeve, elastic"),
            Some(measures.upper_arm_girth),
            arm,
        ),
        sewn(
            words("袖下の長さ", "underarm seam of the sleeve"),
            None,
            sleeve.underarm(),
        ),
        sewn(words("裾まわり", "around the hem"), None, hem),
        sewn(
            words("ウエストから裾まで", "from the waist to the hem"),
            None,
            skirt.ruffle - skirt.hem_y,
        ),
    ]
}

/// Around the lowest edge [m].
fn hem_around(pieces: &[Piece]) -> f64 {
    pieces.get(RUFFLE).map_or_else(
        || 2.0 * (pieces[FRONT].edges[0].length() + pieces[BACK].edges[0].length()),
        |ruffle| 2.0 * ruffle.edges[0].length(),
    )
}

/// Strips to a ring, and their upper edges to the hem: the first from the middle of the front over the
/// wearer's left to the middle of the back, the second over her right.
fn ruffle_seams(pieces: &[Piece]) -> Vec<Seam> {
    let [front, back] = [FRONT, BACK].map(|piece| pieces[piece].edges[0].length());
    let share = front / (front + back);
    let mut seams = vec![
        plain(side(RUFFLE, 0, 1), side(RUFFLE, 1, 1)),
        plain(side(RUFFLE, 0, 3), side(RUFFLE, 1, 3)),
    ];
    // The ruffle's upper edge runs back to where its strip begins: its end lies at the front.
    let onto = |piece: usize, [from, to]: [f64; 2]| {
        gathered(side(piece, 0, 0), side(RUFFLE, 0, 2).between(from, to))
    };
    seams.extend(both_sides(onto(FRONT, [1.0, 1.0 - share])));
    seams.extend(both_sides(onto(BACK, [0.0, 1.0 - share])));
    seams
}

fn button() -> Notion {
    notion(
        NotionKind::Button,
        words("後ろあきのボタン", "button for the back opening"),
        Amount::Count(1),
    )
}

fn yoke_step(pieces: &[Piece], seams: Vec<usize>) -> Step {
    let of = |piece: usize| 2.0 * pieces[piece].edges[place(&pieces[piece], "yoke")].length();
    let [front_cm, front_to_cm] = [FRONT, FRONT_YOKE].map(|piece| cm(of(piece)));
    let [back_cm, back_to_cm] = [BACK, BACK_YOKE].map(|piece| cm(of(piece)));
    step(
        words("ギャザーを寄せてヨークに付ける", "Gather the skirts onto the yokes"),
        say!(
            "前スカートの上端 {front_cm} cm を {front_to_cm} cm に、後ろの {back_cm} cm を {back_to_cm} cm に寄せ、中心と 4 等分の合印を合わせて、それぞれのヨークに中表に縫います。縫い代はヨークの方へ倒します。",
            "Gather the front's upper edge of {front_cm} cm to {front_to_cm} cm and the back's {back_cm} cm to {back_to_cm} cm, match the notches at the middle and the quarters, and sew each to its yoke, right sides together. Press the allowances into the yokes."
        ),
        minutes(&[(Work::Gathers, of(FRONT) + of(BACK))]),
    )
    .or_by_hand(say!(
        "ぐし縫い 2 本で寄せ、半返し縫いで付けます。",
        "Gather with two rows of running stitches and sew with half back stitches."
    ))
    .shown(lole_pattern::pattern::StepFigure::Seams(seams))
}

/// Of the strip that binds the slit, for its ends and the loop [m].
const LOOP: f64 = 8.0 * CM;

fn slit_step(slit: f64) -> Step {
    let [slit_cm, strip_cm] = [slit, 2.0 * slit + LOOP].map(cm);
    step(
        words("後ろあきを作る", "Make the back opening"),
        say!(
            "後ろヨークの中心に {slit_cm} cm の切り込みを入れます。残り布から斜めに裁った幅 2.5 cm、長さ {strip_cm} cm のバイアス布で、切り込みをくるみ、余りでループを作ります。上にループとボタンを付けます。",
            "Slit the middle of the back yoke for {slit_cm} cm. Bind the slit with a strip cut on the bias from what is left of the cloth, 2.5 cm by {strip_cm} cm, make a loop of the rest, and close the top with loop and button."
        ),
        minutes(&[(Work::Slit, 1.0)]),
    )
    .shown(lole_pattern::pattern::StepFigure::Piece {
        piece: BACK_YOKE,
        edges: Vec::new(),
        marks: vec![0],
    })
}

fn ruffle_step(pieces: &[Piece], onto_hem: Vec<usize>) -> Step {
    let long = pieces[RUFFLE].edges[0].length();
    let around = 2.0 * (pieces[FRONT].edges[0].length() + pieces[BACK].edges[0].length());
    let [ring_cm, around_cm] = [2.0 * long, around].map(cm);
    step(
        words("フリルを付ける", "Sew on the ruffle"),
        say!(
            "フリル 2 枚を輪に縫い、上端 {ring_cm} cm を {around_cm} cm に寄せ、合印どうしを合わせて裾に中表に縫います。縫い目は前と後ろの中心に来ます。縫い代は上へ倒します。",
            "Join the two strips to a ring, gather its {ring_cm} cm to {around_cm} cm, match the notches and sew it to the lower edge, right sides together; its seams come to the middles of front and back. Press the allowances up."
        ),
        minutes(&[(Work::Gathers, 2.0 * long), (Work::Seam, 0.5)]),
    )
    .shown(lole_pattern::pattern::StepFigure::Seams(onto_hem))
}

fn notions(arm: f64, slit: f64) -> Vec<Notion> {
    let mut notions = vec![sleeve_elastic(arm)];
    notions.extend((0.0 < slit).then(button));
    notions
}

mod worn {
    //! The muʻumuʻu: yokes over the shoulders, skirts gathered to them, a ruffle at the hem.

    use crate::dress::Way;
    use crate::dress::bodice::Covered;
    use crate::template::{MANY_SUBSTEPS, SewnRow};

    pub(super) const ROW: SewnRow = SewnRow {
        way: Way::Fitted(&[
            ("front", Covered::Front),
            ("back", Covered::Back),
            ("front_yoke", Covered::Front),
            ("back_yoke", Covered::Back),
            ("sleeve", Covered::Sleeve),
            ("ruffle", Covered::Ruffle),
        ]),
        particle_count: 6000.0,
        substep_counts: MANY_SUBSTEPS,
    };
}
