//! The holokū: a long fitted dress with a yoke, long sleeves, and a train.
//!
//! Dictionaries call it a fitted long dress with a yoke and usually a train. It is drafted from the bodice
//! [block](crate::drafting::block): the front's dart lies at the side, two darts shape each half at the waist, and
//! the back falls from its middle into the train. Ease: makers of hula dresses in Japan give 3 to 4 cm at
//! the bust and 5 to 6 cm at the waist. Train, flare and depths are estimates and options.

use kurbo::{PathSeg, Vec2};
use lole_geom::Length;
use lole_language::words;
use lole_pattern::pattern::{Amount, FinishedMeasure, NotionKind, Seam, Step, StepFigure};
use lole_pattern::piece::{CutCount, Edge, Finish, LineKind, Mark, Piece};
use lole_pattern::{DraftError, Measure, Measures, Pattern};

use super::blouse::{
    BUST_EASE, NECK_LOWER, NECK_LOWER_KEY, NECK_WIDER, PUFF, flat_front, zip_step,
};
use crate::drafting::altered::altered;
use crate::drafting::block::{Block, Fit, NO_REMEDY, unfit};
use crate::drafting::chosen::{Chosen, by_measure, choice, number};
use crate::drafting::fitted::{
    FITTED_SEAM, SEAM, SideLine, binding, binding_seams, binding_step, closing_step, cutting_step,
    dart_step, hem_fullness, hem_step, place, shown, zip_note,
};
use crate::drafting::making::{
    both_sides, cm, eased, notion, pattern, plain, say, sewn, side, step,
};
use crate::drafting::shape::{CM, DOWN, Label, at, back_notch, curve, edge, line, marked, notch};
use crate::drafting::sleeve::{ArmholePart, Sleeve, SleeveFit};
use crate::drafting::work::{Work, minutes};
use crate::drafting::yoke::Yoked;
use crate::fitting::Fitting;
use crate::sketch::{Sketch, Tone};
use crate::template::{Choice, OptionRow, Options, Shelf, Template, Wear};

pub(crate) static TEMPLATE: Template = Template {
    id: "holoku",
    name: words("ホロクー", "holokū"),
    about: words(
        "ヨークと長い袖と引き裾のある、体に沿った長いドレス",
        "a long fitted dress with a yoke, long sleeves and a train",
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
    pen.dress(0.13, 0.24);
    pen.patch(&[[0.7, 0.82], [0.98, 0.96], [0.74, 0.94]], Tone::Cloth);
}

const SLEEVES: &[Choice] = &[
    Choice {
        id: "puff",
        name: words("袖山のふくらんだ長袖", "long, puffed at the shoulder"),
    },
    Choice {
        id: "plain",
        name: words("ふつうの長袖", "long and plain"),
    },
];

const OPTIONS: &[OptionRow] = &[
    number("bust_ease_cm", [2.0, 20.0], 12.0, BUST_EASE),
    number(
        "waist_ease_cm",
        [2.0, 30.0],
        6.0,
        words("ウエストのゆとり", "garment over the waist girth"),
    ),
    number(
        "hip_ease_cm",
        [2.0, 40.0],
        6.0,
        words("ヒップのゆとり", "garment over the hip girth"),
    ),
    number(
        "hem_height_cm",
        [0.0, 60.0],
        3.0,
        words("前の裾の床からの高さ", "hem above the floor in front"),
    ),
    by_measure(
        "train_cm",
        [0.0, 200.0],
        words(
            "床に引く裾の長さ。0 ならなし、書かなければ身長の 0.38 倍",
            "length of the train on the floor; 0: none; left out: 0.38 of the stature",
        ),
    ),
    number(
        "flare_cm",
        [0.0, 50.0],
        14.0,
        words(
            "脇の、ヒップから裾への広がり",
            "how far each side goes out from hips to hem",
        ),
    ),
    number("neck_wider_cm", [0.0, 6.0], 1.5, NECK_WIDER),
    number(NECK_LOWER_KEY, [0.0, 8.0], 2.0, NECK_LOWER),
    choice("sleeve", SLEEVES, words("袖の形", "shape of the sleeves")),
    number("puff_ratio", [1.1, 1.8], 1.25, PUFF),
    number(
        "hem_allowance_cm",
        [0.5, 10.0],
        3.0,
        words("裾上げの分", "cloth for the hem"),
    ),
];

/// Pieces, in their order.
const FRONT: usize = 0;
const BACK: usize = 1;
const FRONT_YOKE: usize = 2;
const BACK_YOKE: usize = 3;
const SLEEVE: usize = 4;
const BINDING: usize = 5;

/// The dart lies this far below the underarm [m].
const DART_BELOW: f64 = 4.0 * CM;
/// A side comes in this much at the waist, at most; darts take the rest [m].
const MOST_SIDE: f64 = 2.5 * CM;
/// Widest dart at the waist, and the narrowest that is sewn [m].
const WIDEST_DART: f64 = 5.0 * CM;
const NARROWEST_DART: f64 = 0.6 * CM;
/// Sleeve over the arm where it is close, and its edge over the wrist [m].
const ARM_EASE: f64 = 4.5 * CM;
const WRIST_EASE: f64 = 14.0 * CM;
/// As a shirt's, for arms that dance: the armhole lies lower than the block's [m], and the cap over its height
/// is flat.
const ARMHOLE_DROPPED: f64 = 2.0 * CM;
const CAP_HEIGHT: f64 = 0.3;
/// Train over the stature. Estimated.
const TRAIN: f64 = 0.38;
/// The zip ends this far over the hips [m].
const ZIP_OVER_HIPS: f64 = 4.0 * CM;

fn draft(fitting: &Fitting<'_>, options: &Options) -> Result<Pattern, DraftError> {
    altered(fitting, |fitting| drafted(fitting, options))
}

fn drafted(fitting: &Fitting<'_>, options: &Options) -> Result<Pattern, DraftError> {
    let measures = fitting.measures;
    let chosen = Chosen::new(OPTIONS, options)?;
    measures.check(&[
        Measure::Stature,
        Measure::HipGirth,
        Measure::HipHeight,
        Measure::WristGirth,
    ])?;
    let lower = chosen.m(NECK_LOWER_KEY);
    let block = Block::new(
        measures,
        &Fit {
            bust_ease: chosen.m("bust_ease_cm"),
            neck_widened: chosen.m("neck_wider_cm"),
            neck_dropped: [lower, 0.25 * lower],
            armhole_dropped: ARMHOLE_DROPPED,
            alterations: fitting.alterations,
        },
    )?;
    let yokes = Yoked::both(&block, &chosen)?;
    let sleeve = sleeve(fitting, (&block, &yokes), &chosen)?;
    let body = Body::new(measures, &block, &chosen)?;
    let front_side = SideLine::with_dart(&body.side(body.front), &block, DART_BELOW);
    let back_side = SideLine::plain(body.side(body.back));
    let front_label = Label::main(
        "front_yoke",
        words("前ヨーク", "front yoke"),
        CutCount::Alike(1),
    );
    let back_label = Label::main(
        "back_yoke",
        words("後ろヨーク", "back yoke"),
        CutCount::Pairs(1),
    );
    let pieces = vec![
        body.front_piece(&yokes[0], &front_side),
        body.back_piece(&block, &yokes[1], &back_side),
        yokes[0].piece(
            &block.front,
            front_label,
            ("center_front", Finish::Fold),
            notch,
        ),
        yokes[1].piece(
            &block.back,
            back_label,
            ("center_back", Finish::Seam),
            back_notch,
        ),
        sleeve.piece.clone(),
        binding(block.neckline_length(), Finish::Hem),
    ];
    let finished = finished(measures, &body, (&sleeve, &pieces));
    let pattern = finish(pieces, (&front_side, &yokes), (&sleeve, &body)).measuring(finished);
    Ok(pattern.warn(say!(
        "引き裾の長さと裾の広がりは目安です。仮縫いで確かめてください",
        "train and flare are estimates; try the dress on in basted cloth first"
    )))
}

/// What a tape says of the dress.
fn finished(
    measures: &Measures,
    body: &Body,
    (sleeve, pieces): (&Sleeve, &[Piece]),
) -> Vec<FinishedMeasure> {
    let half_bust = body.front + body.back;
    let darts = body.darts[0] + body.darts[1];
    let hem = [FRONT, BACK].map(|piece| pieces[piece].edges[0].length());
    vec![
        sewn(
            words("バスト", "bust"),
            Some(measures.bust_girth),
            2.0 * half_bust,
        ),
        sewn(
            words("ウエスト", "waist"),
            Some(measures.waist_girth),
            2.0 * (half_bust - 2.0 * body.waist_in - darts),
        ),
        sewn(
            words("ヒップ", "hips"),
            Some(measures.hip_girth),
            2.0 * (half_bust + 2.0 * body.hip_out),
        ),
        sewn(
            words("袖口", "edge of the sleeve"),
            Some(measures.wrist_girth),
            sleeve.hem_width,
        ),
        sewn(
            words("裾まわり", "around the hem"),
            None,
            2.0 * (hem[0] + hem[1]),
        ),
        sewn(
            words("引き裾（床から先）", "train beyond the hem in front"),
            None,
            body.train,
        ),
    ]
}

fn sleeve(
    fitting: &Fitting<'_>,
    (block, yokes): (&Block, &[Yoked; 2]),
    chosen: &Chosen<'_>,
) -> Result<Sleeve, DraftError> {
    let measures = fitting.measures;
    let is_puff = chosen.choice("sleeve") == "puff";
    let raised = if is_puff { 2.0 * CM } else { 0.0 };
    let mut sleeve = Sleeve::new(
        measures,
        (block, Some(yokes)),
        &SleeveFit {
            length: measures.arm_length.to_m() + raised,
            arm_ease: ARM_EASE,
            cap_ratio: if is_puff {
                chosen.number("puff_ratio")
            } else {
                1.03
            },
            crown_raised: raised,
            hem_width: Some(measures.wrist_girth.to_m() + WRIST_EASE),
            hem: 3.0 * CM,
            cap_height: CAP_HEIGHT,
            widened: fitting.widened_sleeve(),
        },
    )?;
    sleeve.piece.name = words("長袖", "long sleeve");
    Ok(sleeve)
}

/// The dress below the yoke.
#[derive(Debug, Clone, Copy)]
struct Body {
    bust_line: f64,
    hip_y: f64,
    hem_y: f64,
    hem: f64,
    /// Width at the bust of front and back, before the front is pivoted.
    front: f64,
    back: f64,
    waist_in: f64,
    hip_out: f64,
    flare: f64,
    train: f64,
    /// Darts at the waist: width of each half's in front and back, which may be 0.
    darts: [f64; 2],
    bust_point: kurbo::Point,
}

impl Body {
    fn new(measures: &Measures, block: &Block, chosen: &Chosen<'_>) -> Result<Self, DraftError> {
        let (front, back) = (flat_front(block), block.back.underarm.x);
        let half_waist = 0.5 * (measures.waist_girth.to_m() + chosen.m("waist_ease_cm"));
        let half_hip = 0.5 * (measures.hip_girth.to_m() + chosen.m("hip_ease_cm"));
        // What must go between bust and waist: sides first, then darts, four in all.
        let excess = front + back - half_waist;
        let waist_in = (0.25 * excess).clamp(-4.0 * CM, MOST_SIDE);
        let in_darts = (excess - 2.0 * waist_in).max(0.0);
        let widest = 2.0 * WIDEST_DART;
        if widest < in_darts {
            let least = measures.waist_girth.to_m() + 2.0 * (in_darts - widest);
            let band = [least, Measure::WaistGirth.band_cm()[1] * CM];
            return Err(unfit(Measure::WaistGirth, measures, band, NO_REMEDY));
        }
        let sewn = |width: f64| if width < NARROWEST_DART { 0.0 } else { width };
        // The back is the hollower one.
        let of_back = (0.56 * in_darts).min(WIDEST_DART);
        let hip_y = (measures.hip_height - measures.waist_height)
            .to_m()
            .min(-4.0 * CM);
        let floor = -measures.waist_height.to_m();
        let hem_y = floor + chosen.m("hem_height_cm");
        if hip_y < hem_y + 10.0 * CM {
            return Err(DraftError::TooShort {
                hem_cm: chosen.number("hem_height_cm"),
                finished_cm: -hem_y / CM,
                band_cm: (10.0 * CM - hip_y) / CM,
            });
        }
        Ok(Self {
            bust_line: block.bust_line,
            hip_y,
            hem_y,
            hem: chosen.m("hem_allowance_cm"),
            front,
            back,
            waist_in,
            hip_out: (0.5 * (half_hip - front - back)).max(-waist_in),
            flare: chosen.m("flare_cm"),
            train: chosen.m_or("train_cm", TRAIN * measures.stature.to_m()),
            darts: [sewn(in_darts - of_back), sewn(of_back)],
            bust_point: block.bust_point,
        })
    }

    /// From the hem over hips and waist up to the underarm, whose width is given.
    fn side(&self, x: f64) -> Vec<PathSeg> {
        let hem = at(x + self.hip_out + self.flare, self.hem_y + self.hem_rise());
        let hip = at(x + self.hip_out, self.hip_y);
        let waist = at(x - self.waist_in, 0.0);
        let underarm = at(x, self.bust_line);
        let along = |from: kurbo::Point, to: kurbo::Point| (to - from) / (to - from).hypot();
        let (up_flare, up_bust) = (along(hem, hip), along(waist, underarm));
        let reach = -self.hip_y;
        vec![
            line(hem, hip),
            curve(
                hip,
                up_flare * (0.35 * reach),
                up_bust * (0.35 * reach),
                waist,
            ),
            line(waist, underarm),
        ]
    }

    /// The side leans and would hang lower than the middle.
    fn hem_rise(&self) -> f64 {
        let height = self.hip_y - self.hem_y;
        ((height * height + self.flare * self.flare).sqrt() - height).min(0.3 * height)
    }

    /// A dart from over the waist to below it, at a distance from the middle.
    fn waist_dart(&self, x: f64, width: f64, [top, bottom]: [f64; 2]) -> Vec<Mark> {
        if width <= 0.0 {
            return Vec::new();
        }
        let (upper, lower) = (at(x, top), at(x, bottom));
        let leg = |sign: f64| {
            let waist = at(x + sign * 0.5 * width, 0.0);
            marked(LineKind::Dart, &[upper, waist, lower])
        };
        vec![leg(-1.0), leg(1.0)]
    }

    fn front_piece(&self, yoked: &Yoked, side: &SideLine) -> Piece {
        let label = Label::main("front", words("前身頃", "front"), CutCount::Alike(1));
        let foot = at(0.0, self.hem_y);
        let top = at(0.0, yoked.level);
        let hem = self.hem_edge(foot, side, 0.0);
        let center = edge("center_front", vec![line(top, foot)], Finish::Fold, 0.0);
        let edges = self.edges(hem, (side, yoked), center);
        let mut marks = side.marks();
        let dart_top = self.bust_point.y - 2.5 * CM;
        let bottom = 0.6 * self.hip_y;
        marks.extend(self.waist_dart(self.bust_point.x, self.darts[0], [dart_top, bottom]));
        marks.extend(yoked.notch_below(2, notch));
        label.piece(edges, DOWN, marks)
    }

    fn back_piece(&self, block: &Block, yoked: &Yoked, side: &SideLine) -> Piece {
        let label = Label::main("back", words("後ろ身頃", "back"), CutCount::Pairs(1));
        let top = at(0.0, yoked.level);
        let hip = at(0.0, self.hip_y);
        // The middle of the back leans out into the train.
        let lean = 0.25 * self.train;
        let foot = at(-lean, self.hem_y - self.train + block.folded_out);
        let hem = self.hem_edge(foot, side, self.train);
        let down = (foot - hip) / (foot - hip).hypot();
        let bend = curve(
            hip,
            Vec2::new(0.0, 0.3 * foot.y),
            down * (0.3 * (foot - hip).hypot()),
            foot,
        );
        let mut way = block.middle_of_back(top, self.hip_y, self.hip_y);
        way.push(bend);
        let center = edge("center_back", way, Finish::Seam, FITTED_SEAM);
        let edges = self.edges(hem, (side, yoked), center);
        let mut marks = side.marks();
        let x = 0.42 * self.back;
        let tops = [0.95 * self.bust_line.min(yoked.level), 0.75 * self.hip_y];
        marks.extend(self.waist_dart(x, self.darts[1], tops));
        marks.extend(yoked.notch_below(2, back_notch));
        label.piece(edges, DOWN, marks)
    }

    /// The lower edge, level at the middle and rising to the side; over a train it falls to the middle.
    fn hem_edge(&self, foot: kurbo::Point, side: &SideLine, train: f64) -> Edge {
        use kurbo::ParamCurve as _;
        let end = side.way.first().map_or(foot, PathSeg::start);
        let run = end.x - foot.x;
        let rise = end.y - foot.y;
        let way = if 0.0 < train {
            // Round the train: level at the middle, level again at the side.
            curve(
                foot,
                Vec2::new(0.5 * run, 0.0),
                Vec2::new(0.35 * run, 0.25 * rise),
                end,
            )
        } else {
            curve(
                foot,
                Vec2::new(run / 3.0, 0.0),
                Vec2::new(run / 3.0, rise / 1.5),
                end,
            )
        };
        edge("hem", vec![way], Finish::Hem, self.hem)
    }

    fn edges(&self, hem: Edge, (side, yoked): (&SideLine, &Yoked), center: Edge) -> Vec<Edge> {
        use kurbo::ParamCurve as _;
        let end = yoked.lower.last().map_or(yoked.end, PathSeg::end);
        let top = at(0.0, yoked.level);
        vec![
            hem,
            edge("side", side.way.clone(), Finish::Seam, FITTED_SEAM),
            edge("armhole", yoked.lower.clone(), Finish::Seam, SEAM),
            edge("yoke", vec![line(end, top)], Finish::Seam, SEAM),
            center,
        ]
    }
}

fn finish(
    mut pieces: Vec<Piece>,
    (front_side, yokes): (&SideLine, &[Yoked; 2]),
    (sleeve, body): (&Sleeve, &Body),
) -> Pattern {
    let of = |piece: usize, id: &str| place(&pieces[piece], id);
    let whole = |piece: usize, id: &str| side(piece, 0, of(piece, id));
    let mut seams: Vec<Seam> = Vec::new();
    for (lower, yoke) in [(FRONT, FRONT_YOKE), (BACK, BACK_YOKE)] {
        seams.extend(both_sides(plain(
            whole(yoke, "yoke"),
            whole(lower, "yoke").back(),
        )));
    }
    let of_yokes: Vec<usize> = (0..seams.len()).collect();
    for piece in [BACK, BACK_YOKE] {
        let center = of(piece, "center_back");
        seams.push(plain(side(piece, 0, center), side(piece, 1, center)));
    }
    let first = seams.len();
    let shoulders = eased(whole(FRONT_YOKE, "shoulder"), whole(BACK_YOKE, "shoulder"));
    seams.extend(both_sides(shoulders));
    seams.extend(front_side.seams((FRONT, of(FRONT, "side")), (BACK, of(BACK, "side"))));
    let closing: Vec<usize> = (first..seams.len()).collect();
    let first = seams.len();
    let parts = |lower: usize, yoke: usize, cut: &Yoked| {
        let part = |piece, share| ArmholePart {
            piece,
            edge: of(piece, "armhole"),
            share,
        };
        let share = cut.lower_share();
        [part(lower, share), part(yoke, 1.0 - share)]
    };
    let armholes = [
        parts(BACK, BACK_YOKE, &yokes[1]),
        parts(FRONT, FRONT_YOKE, &yokes[0]),
    ];
    seams.extend(sleeve.seams(SLEEVE, [&armholes[0], &armholes[1]]));
    let of_sleeve: Vec<usize> = (first..seams.len()).collect();
    let necklines = [
        (BACK_YOKE, of(BACK_YOKE, "neckline")),
        (FRONT_YOKE, of(FRONT_YOKE, "neckline")),
    ];
    seams.extend(binding_seams(&pieces, BINDING, necklines));

    let yoke_back = pieces[BACK_YOKE].edges[of(BACK_YOKE, "center_back")].length();
    let zip = yoke_back + (yokes[1].level - body.hip_y - ZIP_OVER_HIPS).max(10.0 * CM);
    let center = of(BACK, "center_back");
    let notions = fasteners(zip);
    // Where the zip ends, on both halves.
    pieces[BACK].marks.push(back_notch(center, zip - yoke_back));
    let hems = 2.0 * (pieces[FRONT].edges[0].length() + pieces[BACK].edges[0].length());
    let mut steps = vec![cutting_step(&pieces)];
    steps.extend(dart_step(FRONT, front_side, [0, 1]));
    steps.extend(waist_step(&pieces, body));
    steps.push(yoke_step(&pieces, of_yokes));
    let whole_back = yoke_back + pieces[BACK].edges[center].length();
    steps.push(zip_step(zip, whole_back, (BACK, center)));
    let meters = 2.0 * (pieces[FRONT].edges[1].length() + pieces[FRONT_YOKE].edges[2].length());
    let shoulder = [FRONT_YOKE, BACK_YOKE]
        .map(|piece| pieces[piece].edges[place(&pieces[piece], "shoulder")].length());
    steps.push(closing_step(
        words("肩と脇を縫う", "Sew shoulders and sides"),
        (meters, shoulder),
        closing,
    ));
    let neckline = pieces[BINDING].edges[0].length();
    steps.push(binding_step(
        neckline,
        shown(&pieces, FRONT_YOKE, &["neckline"]),
    ));
    steps.push(hook_step());
    steps.push(sleeve_step(sleeve, of_sleeve));
    let hem = &pieces[BACK].edges[place(&pieces[BACK], "hem")];
    let full = (body.hem, hem_fullness(hem, body.hem));
    steps.push(hem_step(full, hems, shown(&pieces, BACK, &["hem"])));
    pattern(pieces, seams, notions, steps)
}

/// How the darts at the waist are sewn; `None` where there are none.
fn waist_step(pieces: &[Piece], body: &Body) -> Option<Step> {
    let [front, back] = body.darts;
    let total = front + back;
    if total <= 0.0 {
        return None;
    }
    let is_dart = |mark: &Mark| {
        matches!(
            mark,
            Mark::Line {
                kind: LineKind::Dart,
                ..
            }
        )
    };
    let marks = pieces[BACK].marks.iter().enumerate();
    let marks: Vec<usize> = marks
        .filter(|(_, mark)| is_dart(mark))
        .map(|(index, _)| index)
        .collect();
    let wide = [
        (front, words("前", "in front")),
        (back, words("後ろ", "at the back")),
    ];
    let wide = wide.into_iter().filter(|(wide, _)| 0.0 < *wide);
    let (wide_japanese, wide_english): (Vec<String>, Vec<String>) = wide
        .map(|(wide, name)| {
            let wide = cm(wide);
            (
                format!("{} {wide} cm", name.japanese),
                format!("{wide} cm wide {}", name.english),
            )
        })
        .unzip();
    let darts = 2 * u32::try_from(wide_japanese.len()).unwrap_or(0);
    let (wide_japanese, wide_english) = (wide_japanese.join("、"), wide_english.join(" and "));
    let figure = StepFigure::Piece {
        piece: BACK,
        edges: Vec::new(),
        marks,
    };
    Some(
        step(
            words("ウエストのダーツを縫う", "Sew the waist darts"),
            say!(
                "ウエストのダーツを左右とも縫います。幅はウエストで{wide_japanese}です。中心へ倒し、ウエストに切り込みを入れます。",
                "Sew the darts at the waist on both sides: {wide_english} at the waist. Press them to the middle and clip them at the waist."
            ),
            minutes(&[(Work::Dart, f64::from(darts))]),
        )
        .shown(figure),
    )
}

fn yoke_step(pieces: &[Piece], seams: Vec<usize>) -> Step {
    let of = |piece: usize| 2.0 * pieces[piece].edges[place(&pieces[piece], "yoke")].length();
    let meters = of(FRONT_YOKE) + of(BACK_YOKE);
    let [front_cm, back_cm] = [FRONT_YOKE, BACK_YOKE].map(|piece| cm(of(piece)));
    step(
        words("ヨークを付ける", "Sew on the yokes"),
        say!(
            "身頃の上端に前ヨーク（{front_cm} cm）と後ろヨーク（合わせて {back_cm} cm）を合印どうしを合わせて中表に縫い、縫い代をヨークの方へ倒します。",
            "Sew the front yoke ({front_cm} cm) and the back yokes ({back_cm} cm together) to the upper edges, right sides together and notch on notch, and press the allowances into the yokes."
        ),
        minutes(&[(Work::Seam, meters)]),
    )
    .shown(StepFigure::Seams(seams))
}

fn sleeve_step(sleeve: &Sleeve, seams: Vec<usize>) -> Step {
    let [flat_cm, cap_cm] = sleeve.between_notches().map(cm);
    let wrist_cm = cm(sleeve.hem_width);
    step(
        words("袖を作って付ける", "Make the sleeves and set them in"),
        say!(
            "袖下を縫い、袖口（まわり {wrist_cm} cm）を 3 cm 折って始末します。袖山の合印の間の {cap_cm} cm を、袖ぐりの合印の間の {flat_cm} cm に縮めます。山を肩線に、合印どうしを合わせて縫い付けます。合印から袖下までは同じ長さで、縮めません。",
            "Sew the underarm seams and hem the wrists ({wrist_cm} cm around) by 3 cm. Draw the {cap_cm} cm of the cap between its notches in to the {flat_cm} cm between those of the armhole. Match the crown to the shoulder and the notches to each other and sew the sleeves in. From the notches to the underarm both are equally long: draw nothing in there."
        ),
        minutes(&[
            (Work::Sleeve, 2.0),
            (Work::Seam, 2.0 * sleeve.underarm()),
            (Work::Hem, 2.0 * sleeve.hem_width),
        ]),
    )
    .shown(StepFigure::Seams(seams))
}

/// The hook sits on the finished neckline.
fn hook_step() -> Step {
    step(
        words("ホックを付ける", "Sew on the hook"),
        say!(
            "ファスナーの上の端に、衿ぐりの内側からスプリングホックを左右に縫い付けます。",
            "Sew hook and eye to the two sides of the neckline, on the inside, above the end of the zip."
        ),
        [10.0, 10.0],
    )
}

fn fasteners(zip: f64) -> Vec<lole_pattern::pattern::Notion> {
    vec![
        notion(
            NotionKind::Zip,
            words("コンシールファスナー", "invisible zip"),
            Amount::Length(Length::from_m(zip)),
        )
        .noted(zip_note(zip)),
        notion(
            NotionKind::Hook,
            words("スプリングホック", "hook and eye"),
            Amount::Count(1),
        ),
    ]
}

mod worn {
    //! The holokū: a close dress from yokes, with long sleeves and a train.

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
        ]),
        particle_count: 5000.0,
        substep_counts: MANY_SUBSTEPS,
    };
}
