//! The blouse with puff sleeves: a front on the fold, a back with a zip, a bound round neckline.
//!
//! Drafted from the bodice [block](crate::drafting::block). The sides come in at the waist and go out to the hips
//! by the same amounts in front and at the back, so that both stay equally long. Ease of the bust: makers
//! of hula dresses in Japan give 3 to 4 cm to close dresses; a blouse with sleeves has the 12 cm of Bunka's
//! block. Depths of neckline and puff are estimates and options.

use kurbo::{PathSeg, Vec2};
use lole_geom::Length;
use lole_language::words;
use lole_pattern::pattern::{
    Amount, FinishedMeasure, Notion, NotionKind, Seam, SeamKind, Step, StepFigure,
};
use lole_pattern::piece::{CutCount, Finish, Piece};
use lole_pattern::{DraftError, Measure, Measures, Pattern};

use crate::drafting::altered::altered;
use crate::drafting::block::{Block, Fit};
use crate::drafting::chosen::{Chosen, by_measure, number};
use crate::drafting::fitted::{
    FITTED_SEAM, SideLine, binding, binding_seams, binding_step, center_edge, closing_step,
    cutting_step, dart_step, hem_fullness, hem_step, place, rising_hem, shown, upper_edges,
    zip_note,
};
use crate::drafting::making::{
    both_sides, cm, eased, elastic, notion, pattern, plain, say, sewn, side, step,
};
use crate::drafting::shape::{CM, DOWN, Label, at, back_notch, curve, edge, length, line, notch};
use crate::drafting::sleeve::{ArmholePart, Sleeve, SleeveFit, armhole_notch};
use crate::drafting::work::{Work, minutes};
use crate::fitting::Fitting;
use crate::sketch::{Sketch, Tone};
use crate::template::{OptionRow, Options, Shelf, Template, Wear};

pub(crate) static TEMPLATE: Template = Template {
    id: "blouse",
    name: words("パフスリーブのブラウス", "blouse with puff sleeves"),
    about: words(
        "丸い衿ぐりとふくらんだ半袖のブラウス",
        "a blouse with a round neckline and short puffed sleeves",
    ),
    shelf: Shelf::Tops,
    options: OPTIONS,
    draft,
    worn: Wear::Sewn(worn::ROW),
    chest_room_deg: 10.0,
    natural: None,
    sketch,
};

fn sketch(pen: &mut Sketch) {
    for side in [-1.0, 1.0] {
        pen.disc([0.5 + side * 0.24, 0.34], 0.11, Tone::Cloth);
    }
    let body = [
        [0.33, 0.2],
        [0.67, 0.2],
        [0.67, 0.5],
        [0.72, 0.82],
        [0.28, 0.82],
        [0.33, 0.5],
    ];
    pen.patch(&body, Tone::Cloth);
    pen.line(&[[0.4, 0.2], [0.44, 0.29], [0.56, 0.29], [0.6, 0.2]]);
}

const OPTIONS: &[OptionRow] = &[
    number("bust_ease_cm", [2.0, 30.0], 12.0, BUST_EASE),
    number(
        "waist_in_cm",
        [0.0, 4.0],
        1.5,
        words(
            "脇をウエストで入れる分",
            "how far each side comes in at the waist",
        ),
    ),
    number(
        "hip_ease_cm",
        [0.0, 40.0],
        6.0,
        words("ヒップのゆとり", "garment over the hip girth"),
    ),
    number(
        "below_waist_cm",
        [4.0, 40.0],
        16.0,
        words("ウエストから裾まで", "from the waist to the hem"),
    ),
    number("neck_wider_cm", [0.0, 8.0], 2.5, NECK_WIDER),
    number(NECK_LOWER_KEY, [0.0, 14.0], 5.0, NECK_LOWER),
    by_measure(
        "sleeve_length_cm",
        [8.0, 45.0],
        words(
            "袖丈。書かなければ肩先からひじまでの 7 割",
            "length of the sleeve; left out: 0.7 of the upper arm",
        ),
    ),
    number("puff_ratio", [1.1, 2.2], 1.5, PUFF),
    number(
        "puff_height_cm",
        [0.0, 8.0],
        2.5,
        words("袖山を高くする分", "how much the crown is raised"),
    ),
    number(
        "hem_allowance_cm",
        [0.5, 6.0],
        2.0,
        words("裾上げの分", "cloth for the hem"),
    ),
];

pub(crate) const BUST_EASE: lole_language::Words =
    words("バストのゆとり", "garment over the bust girth");
pub(crate) const NECK_WIDER: lole_language::Words = words(
    "衿ぐりを首の横から肩の方へ広げる分",
    "neckline from the side of the neck along the shoulder",
);
/// Key of the option that lowers the neckline in front.
pub(crate) const NECK_LOWER_KEY: &str = "neck_lower_cm";
pub(crate) const NECK_LOWER: lole_language::Words = words(
    "前の衿ぐりを下げる分",
    "front neckline below the pit of the neck",
);
pub(crate) const PUFF: lole_language::Words =
    words("袖山の長さ÷袖ぐり", "cap of the sleeve over the armhole");

/// Height of the cap over that of the armhole, before it is raised: lower than the five sixths of a coat, for
/// arms that dance.
const CAP_HEIGHT: f64 = 0.6;
/// Sleeve over the arm, before it is spread [m].
pub(crate) const ARM_EASE: f64 = 5.0 * CM;
/// The sleeve's elastic over the arm.
const ARM_ELASTIC: f64 = 0.95;
/// The dart lies this far below the underarm [m].
const DART_BELOW: f64 = 5.0 * CM;
/// Casing at the edge of the sleeve, with what is turned [m].
pub(crate) const SLEEVE_CASING: f64 = 2.0 * CM;
const OVERLAP: f64 = 2.0 * CM;

fn draft(fitting: &Fitting<'_>, options: &Options) -> Result<Pattern, DraftError> {
    altered(fitting, |fitting| drafted(fitting, options))
}

fn drafted(fitting: &Fitting<'_>, options: &Options) -> Result<Pattern, DraftError> {
    let measures = fitting.measures;
    let chosen = Chosen::new(OPTIONS, options)?;
    measures.check(&[
        Measure::HipGirth,
        Measure::HipHeight,
        Measure::UpperArmLength,
    ])?;
    let block = Block::new(
        measures,
        &Fit {
            bust_ease: chosen.m("bust_ease_cm"),
            neck_widened: chosen.m("neck_wider_cm"),
            neck_dropped: [chosen.m(NECK_LOWER_KEY), 0.25 * chosen.m(NECK_LOWER_KEY)],
            armhole_dropped: 0.0,
            alterations: fitting.alterations,
        },
    )?;
    let ratio = chosen.number("puff_ratio");
    let upper_arm = measures.upper_arm_length.to_m();
    let sleeve = Sleeve::new(
        measures,
        (&block, None),
        &SleeveFit {
            length: chosen.m_or("sleeve_length_cm", 0.7 * upper_arm) + chosen.m("puff_height_cm"),
            arm_ease: ARM_EASE,
            cap_ratio: ratio,
            crown_raised: chosen.m("puff_height_cm"),
            hem_width: None,
            hem: SLEEVE_CASING,
            cap_height: CAP_HEIGHT,
            widened: fitting.widened_sleeve(),
        },
    )?;
    let body = Body::new(measures, &block, &chosen);
    let front_side = SideLine::with_dart(&body.side(flat_front(&block)), &block, DART_BELOW);
    let back_side = SideLine::plain(body.side(block.back.underarm.x));
    let pieces = vec![
        body.piece(&block, &front_side, Part::Front),
        body.piece(&block, &back_side, Part::Back),
        sleeve.piece.clone(),
        binding(block.neckline_length(), Finish::Hem),
    ];
    let half_bust = block.back.underarm.x + flat_front(&block);
    let arm = fitting.arm() * ARM_ELASTIC;
    let finished = finished((measures, arm), (half_bust, &body), (&sleeve, &pieces));
    let pattern = finish(pieces, (&front_side, &sleeve), (arm, &body));
    Ok(pattern.measuring(finished))
}

/// What a tape says of the blouse.
fn finished(
    (measures, arm): (&Measures, f64),
    (half_bust, body): (f64, &Body),
    (sleeve, pieces): (&Sleeve, &[Piece]),
) -> Vec<FinishedMeasure> {
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
            2.0 * half_bust - 4.0 * body.waist_in,
        ),
        sewn(
            words("裾まわり", "around the hem"),
            None,
            2.0 * (hem[0] + hem[1]),
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
        sewn(
            words("後ろ中心の丈", "middle of the back"),
            None,
            pieces[BACK].edges[place(&pieces[BACK], "center_back")].length(),
        ),
    ]
}

/// Where the front's underarm lay before it was pivoted.
pub(crate) fn flat_front(block: &Block) -> f64 {
    use kurbo::Affine;
    let back = Affine::rotate_about(-block.dart_angle, block.bust_point);
    (back * block.front.underarm).x
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Part {
    Front,
    Back,
}

/// Where the sides go below the underarm [m].
#[derive(Debug, Clone, Copy)]
struct Body {
    bust_line: f64,
    waist_in: f64,
    /// From the bust's width to the hem's.
    hem_out: f64,
    hip_y: f64,
    hem_y: f64,
    hem: f64,
}

impl Body {
    fn new(measures: &Measures, block: &Block, chosen: &Chosen<'_>) -> Self {
        let half_bust = block.back.underarm.x + flat_front(block);
        let half_hip = 0.5 * (measures.hip_girth.to_m() + chosen.m("hip_ease_cm"));
        let hip_y = (measures.hip_height - measures.waist_height)
            .to_m()
            .min(-2.0 * CM);
        let hem_y = -chosen.m("below_waist_cm");
        // The hips' width is reached at the hips: a shorter blouse takes its share.
        let share = (hem_y / hip_y).min(1.0);
        let hip_out = 0.5 * (half_hip - half_bust);
        let waist_in = chosen.m("waist_in_cm");
        Self {
            bust_line: block.bust_line,
            waist_in,
            hem_out: hip_out.max(-waist_in) * share,
            hip_y,
            hem_y,
            hem: chosen.m("hem_allowance_cm"),
        }
    }

    /// From the hem over the waist up to the underarm, `x` of which is given.
    fn side(&self, x: f64) -> Vec<PathSeg> {
        let hem = at(x + self.hem_out, self.hem_y);
        let waist = at(x - self.waist_in, 0.0);
        let underarm = at(x, self.bust_line);
        let up = Vec2::new(0.0, 1.0);
        let to_underarm = (underarm - waist) / (underarm - waist).hypot();
        let lower = curve(
            hem,
            up * (0.4 * -self.hem_y),
            to_underarm * (0.35 * -self.hem_y),
            waist,
        );
        vec![lower, line(waist, underarm)]
    }

    fn piece(&self, block: &Block, side: &SideLine, part: Part) -> Piece {
        let half = match part {
            Part::Front => &block.front,
            Part::Back => &block.back,
        };
        let hem_end = side.way[0];
        let hem_end = kurbo::ParamCurve::start(&hem_end);
        let middle = match part {
            Part::Front => vec![line(half.center, at(0.0, self.hem_y))],
            Part::Back => {
                block.middle_of_back(half.center, self.hip_y, self.hem_y + block.folded_out)
            }
        };
        let center = middle.last().map_or(half.center, kurbo::ParamCurve::end);
        let hem = vec![rising_hem(center, hem_end)];
        let [armhole, shoulder, neckline] = upper_edges(half);
        let (label, finish, center_id) = match part {
            Part::Front => (
                Label::main("front", words("前身頃", "front"), CutCount::Alike(1)),
                Finish::Fold,
                "center_front",
            ),
            Part::Back => (
                Label::main("back", words("後ろ身頃", "back"), CutCount::Pairs(1)),
                Finish::Seam,
                "center_back",
            ),
        };
        let edges = vec![
            edge("hem", hem, Finish::Hem, self.hem),
            edge("side", side.way.clone(), Finish::Seam, FITTED_SEAM),
            armhole,
            shoulder,
            neckline,
            center_edge(center_id, middle, finish),
        ];
        let mut marks = side.marks();
        let at = armhole_notch(length(&half.armhole), None);
        marks.push(match part {
            Part::Front => notch(2, at),
            Part::Back => back_notch(2, at),
        });
        label.piece(edges, DOWN, marks)
    }
}

/// Pieces of the blouse, in their order.
const FRONT: usize = 0;
const BACK: usize = 1;
const SLEEVE: usize = 2;
const BINDING: usize = 3;

fn finish(
    pieces: Vec<Piece>,
    (front_side, sleeve): (&SideLine, &Sleeve),
    (arm, body): (f64, &Body),
) -> Pattern {
    let edge = |piece: usize, id: &str| place(&pieces[piece], id);
    let mut seams: Vec<Seam> = Vec::new();
    let center = edge(BACK, "center_back");
    seams.push(plain(side(BACK, 0, center), side(BACK, 1, center)));
    let shoulders = eased(
        side(FRONT, 0, edge(FRONT, "shoulder")),
        side(BACK, 0, edge(BACK, "shoulder")),
    );
    seams.extend(both_sides(shoulders));
    let sides = ((FRONT, edge(FRONT, "side")), (BACK, edge(BACK, "side")));
    seams.extend(front_side.seams(sides.0, sides.1));
    let closing: Vec<usize> = (1..seams.len()).collect();
    let whole = |piece| ArmholePart {
        piece,
        edge: edge(piece, "armhole"),
        share: 1.0,
    };
    let first_of_sleeve = seams.len();
    seams.extend(sleeve.seams(SLEEVE, [&[whole(BACK)], &[whole(FRONT)]]));
    let of_sleeve = set_in(&seams, first_of_sleeve);
    let necklines = [
        (BACK, edge(BACK, "neckline")),
        (FRONT, edge(FRONT, "neckline")),
    ];
    seams.extend(binding_seams(&pieces, BINDING, necklines));

    let zip = pieces[BACK].edges[center].length();
    let notions = vec![
        notion(
            NotionKind::Zip,
            words("コンシールファスナー", "invisible zip"),
            Amount::Length(Length::from_m(zip)),
        )
        .noted(zip_note(zip)),
        sleeve_elastic(arm),
    ];
    let hem_around = 2.0
        * [FRONT, BACK]
            .map(|piece| pieces[piece].edges[0].length())
            .iter()
            .sum::<f64>();
    let mut steps = vec![cutting_step(&pieces)];
    steps.extend(dart_step(FRONT, front_side, [0, 1]));
    steps.push(zip_step(zip, zip, (BACK, center)));
    let meters = 2.0 * (pieces[FRONT].edges[1].length() + pieces[FRONT].edges[3].length());
    let shoulder = [FRONT, BACK].map(|piece| pieces[piece].edges[edge(piece, "shoulder")].length());
    steps.push(closing_step(
        words("肩と脇を縫う", "Sew shoulders and sides"),
        (meters, shoulder),
        closing,
    ));
    let neckline = pieces[BINDING].edges[0].length();
    steps.push(binding_step(neckline, shown(&pieces, FRONT, &["neckline"])));
    steps.extend(sleeve_steps(sleeve, arm, (SLEEVE, of_sleeve)));
    let full = hem_fullness(&pieces[FRONT].edges[place(&pieces[FRONT], "hem")], body.hem);
    steps.push(hem_step(
        (body.hem, full),
        hem_around,
        shown(&pieces, FRONT, &["hem"]),
    ));
    pattern(pieces, seams, notions, steps).drawn_in(
        SLEEVE,
        crate::drafting::sleeve::HEM,
        Length::from_m(arm),
    )
}

/// Elastic of both sleeves; `arm` is the finished one [m].
pub(crate) fn sleeve_elastic(arm: f64) -> Notion {
    Notion {
        place: Some(words("袖口", "sleeves")),
        ..elastic(
            words(
                "6～8 mm 幅の平ゴム（袖口）",
                "flat elastic (6 to 8 mm, sleeves)",
            ),
            2,
            arm + OVERLAP,
        )
    }
}

/// How the back is closed: a zip of the length `zip`, in a seam of the length `center` [m].
pub(crate) fn zip_step(zip: f64, center: f64, (piece, edge): (usize, usize)) -> Step {
    let [zip_cm, below_cm] = [zip, center - zip].map(cm);
    let is_whole = center - zip < 0.5 * CM;
    let how = if is_whole {
        say!(
            "縫い代の端を先に始末します。後ろ中心の衿ぐりから裾の折り線まで、{zip_cm} cm のファスナーを付けます。",
            "Neaten the allowances at the middle of the back first. Set the zip of {zip_cm} cm in from the neckline down to the fold of the hem."
        )
    } else {
        say!(
            "縫い代の端を先に始末します。後ろ中心に {zip_cm} cm のファスナーを衿ぐりから二本の合印まで付け、その下の {below_cm} cm を縫い合わせます。",
            "Neaten the allowances at the middle of the back first. Set the zip of {zip_cm} cm in from the neckline down to the double notch and sew the {below_cm} cm below it closed."
        )
    };
    step(
        words("後ろにファスナーを付ける", "Set in the zip"),
        how,
        minutes(&[(Work::Zip, 1.0), (Work::Seam, center)]),
    )
    .or_by_hand(say!(
        "ファスナーは半返し縫いで付けます。",
        "Sew the zip in with half back stitches."
    ))
    .shown(crate::drafting::making::edges_of(piece, &[edge]))
}

/// The seams from `first` on by which sleeves are set in, without those of the sleeves themselves.
pub(crate) fn set_in(seams: &[Seam], first: usize) -> Vec<usize> {
    let is_own = |seam: &Seam| seam.flat.piece == seam.full.piece;
    let indices = first..seams.len();
    indices.filter(|&index| !is_own(&seams[index])).collect()
}

/// How puffed sleeves are made and set in; `arm` is the finished elastic.
pub(crate) fn sleeve_steps(
    sleeve: &Sleeve,
    arm: f64,
    (piece, seams): (usize, Vec<usize>),
) -> Vec<Step> {
    let [casing_cm, cut_cm, hem_cm] = [SLEEVE_CASING, arm + OVERLAP, sleeve.hem_width].map(cm);
    let [arm_cm, overlap_cm] = [arm, OVERLAP].map(cm);
    let [flat_cm, cap_cm] = sleeve.between_notches().map(cm);
    let set_in = match sleeve.kind {
        SeamKind::Gathered => say!(
            "袖山の前の合印（1 本）から後ろの合印（2 本）までに粗い縫い目を 2 本入れ、{cap_cm} cm を袖ぐりの合印の間の {flat_cm} cm に寄せます。山の合印を肩線に、前後の合印どうしを合わせ、袖を中表に縫い付けます。合印から袖下までは袖山と袖ぐりが同じ長さで、寄せません。",
            "Run two rows of long stitches along the cap from the single notch in front to the double one at the back and gather its {cap_cm} cm to the {flat_cm} cm between the notches of the armhole. Match the crown to the shoulder and the notches to each other and sew the sleeve in, right sides together. From the notches to the underarm both are equally long: do not gather there."
        ),
        SeamKind::Eased | SeamKind::Plain => say!(
            "山の合印を肩線に、前後の合印どうしを合わせ、合印の間の袖山 {cap_cm} cm を袖ぐり {flat_cm} cm にいせ込みながら、袖を中表に縫い付けます。合印から袖下まではいせません。",
            "Match the crown to the shoulder and the notches to each other, ease the {cap_cm} cm of the cap between its notches into the {flat_cm} cm of the armhole and sew the sleeve, right sides together. From the notches to the underarm nothing is eased."
        ),
    };
    vec![
        step(
            words("袖を作る", "Make the sleeves"),
            say!(
                "袖下を縫い、袖口を {casing_cm} cm 折ってゴム通しを縫います（一か所開ける）。{cut_cm} cm に切ったゴムを左右に 1 本ずつ通し、端を {overlap_cm} cm 重ねて縫い、{hem_cm} cm の袖口を {arm_cm} cm に寄せます。",
                "Sew the underarm seams, fold {casing_cm} cm at the lower edge for a casing and stitch it, leaving a gap. Draw an elastic of {cut_cm} cm into each, overlap its ends by {overlap_cm} cm and sew them: the edge of {hem_cm} cm is gathered to {arm_cm} cm."
            ),
            minutes(&[(Work::Seam, 2.0 * sleeve.underarm()), (Work::Hem, 2.0 * sleeve.hem_width)]),
        )
        .shown(crate::drafting::making::edges_of(piece, &[0, 1, 3])),
        step(words("袖を付ける", "Set in the sleeves"), set_in, minutes(&[(Work::Sleeve, 2.0)]))
            .shown(StepFigure::Seams(seams)),
    ]
}

mod worn {
    //! The blouse: front and back around the trunk, puffed sleeves around the arms.

    use crate::dress::Way;
    use crate::dress::bodice::Covered;
    use crate::template::{MANY_SUBSTEPS, SewnRow};

    pub(super) const ROW: SewnRow = SewnRow {
        way: Way::Fitted(&[
            ("front", Covered::Front),
            ("back", Covered::Back),
            ("sleeve", Covered::Sleeve),
        ]),
        particle_count: 3000.0,
        substep_counts: MANY_SUBSTEPS,
    };
}
