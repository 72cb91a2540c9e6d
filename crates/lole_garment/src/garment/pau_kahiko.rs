//! The open tie-on pāʻū of kahiko: a rectangle on cords in casings, tied at the left side.
//!
//! Published sewing notes of hālau give 4 yards of muslin, four casings of 1 inch spaced 1.5 inches, cords
//! of half an inch and ends that are rolled and hemmed; the open side is worn on the left. How long the
//! ends of the cords hang is an estimate. A kumu's own rule comes first.

use lole_geom::Length;
use lole_language::words;
use lole_pattern::design::pau_skirt::{MarkedLine, PauDraft, PauOptions, draft_pau_skirt};
use lole_pattern::pattern::{Amount, Notion, NotionKind, Step, StepFigure};
use lole_pattern::piece::{Finish, LineKind, Mark, Piece};
use lole_pattern::{DraftError, GatherRatio, Pattern};

use super::pau_skirt::{
    CASING, GAP, GATHERS, HEADER, HEM, HEM_HEIGHT, UNKNOWN_WIDTH, WORN_HEIGHT, worn,
};
use crate::drafting::chosen::{Chosen, by_measure, count, number};
use crate::drafting::making::{cm, edges_of, notion, pattern, say, sewn, step, stitching};
use crate::drafting::work::{Work, minutes};
use crate::fitting::Fitting;
use crate::sketch::{Sketch, Tone};
use crate::template::{
    Fineness, Gathered, GatheredRow, OptionRow, Options, Shelf, Template, Wear, WornPlace,
};

pub(crate) static TEMPLATE: Template = Template {
    id: "pau-kahiko",
    name: words("カヒコの結ぶパウ", "tie-on pāʻū of kahiko"),
    about: words(
        "脇を縫い合わせず、通したひもを左の腰で結ぶカヒコのパウ",
        "an open pāʻū on cords that are tied at the left hip, for kahiko",
    ),
    shelf: Shelf::Skirts,
    options: OPTIONS,
    draft,
    worn: Wear::Gathered(GatheredRow {
        count: |_| 1,
        draft: as_worn,
        fineness: Fineness::OF_SKIRT,
        second: None,
    }),
    chest_room_deg: 0.0,
    natural: None,
    sketch,
};

fn sketch(pen: &mut Sketch) {
    pen.patch(
        &[[0.26, 0.2], [0.74, 0.2], [0.88, 0.8], [0.12, 0.8]],
        Tone::Cloth,
    );
    pen.patch(
        &[[0.24, 0.14], [0.76, 0.14], [0.78, 0.26], [0.22, 0.26]],
        Tone::Cloth,
    );
    pen.fan([0.28, 0.8], [0.2, 0.32], 6);
}

const OPTIONS: &[OptionRow] = &[
    number("hem_height_cm", [0.0, 100.0], 30.0, HEM_HEIGHT),
    by_measure("worn_height_cm", [40.0, 130.0], WORN_HEIGHT),
    number("gather_ratio", [1.0, 5.0], 4.0, GATHERS),
    count(
        "cord_row_count",
        [1, 6],
        4,
        words("ひもの段数", "rows of cord"),
    ),
    number("header_cm", [0.0, 15.0], 1.0, HEADER),
    number("casing_cm", [0.5, 10.0], 2.5, CASING),
    number("casing_gap_cm", [0.0, 15.0], 3.8, GAP),
    number("hem_allowance_cm", [0.0, 30.0], 3.0, HEM),
    number(
        "cord_end_cm",
        [10.0, 150.0],
        45.0,
        words(
            "結ぶために両端に残すひも",
            "cord left at each end for the knot",
        ),
    ),
];

/// Ends that are rolled and hemmed [m].
const END_HEM: f64 = 0.015;

/// Where the ends of the rectangle stand among its edges.
const ENDS: [usize; 2] = [1, 3];

/// The rectangle as it is worn, gathered on its cords.
fn as_worn(fitting: &Fitting<'_>, options: &Options) -> Result<Gathered, DraftError> {
    let chosen = Chosen::new(OPTIONS, options)?;
    let m = |key| Length::from_m(chosen.m(key));
    let worn = worn(fitting, &chosen)?;
    let cut = PauOptions {
        gather_ratio: GatherRatio::new(chosen.number("gather_ratio"))?,
        hem_height: m("hem_height_cm"),
        elastic_row_count: chosen.count("cord_row_count"),
        header: m("header_cm"),
        casing: m("casing_cm"),
        gap: m("casing_gap_cm"),
        hem: m("hem_allowance_cm"),
        seam_allowance: Length::from_m(END_HEM),
        fabric_width: UNKNOWN_WIDTH,
        ..PauOptions::default()
    };
    Ok(Gathered {
        draft: draft_pau_skirt(&worn, &cut)?,
        worn,
        place: WornPlace::Hips,
        is_open: true,
        ruffle: None,
    })
}

fn draft(fitting: &Fitting<'_>, options: &Options) -> Result<Pattern, DraftError> {
    let chosen = Chosen::new(OPTIONS, options)?;
    let row_count = chosen.count("cord_row_count");
    let Gathered { draft, worn, .. } = as_worn(fitting, options)?;
    let mut piece = draft
        .pattern_with(TEMPLATE.name, None)
        .pieces
        .swap_remove(0);
    for end in ENDS {
        piece.edges[end].finish = Finish::Hem;
    }
    let cord_cut = worn.worn_girth.to_m() + 2.0 * chosen.m("cord_end_cm");
    let each = cm(cord_cut);
    let cords = Notion {
        pieces: row_count,
        note: Some(say!(
            "{each} cm を {row_count} 本",
            "{row_count} of {each} cm"
        )),
        ..notion(
            NotionKind::Cord,
            words("太さ 1.2 cm ほどのひも", "cord about 1.2 cm thick"),
            Amount::Length(Length::from_m(cord_cut * f64::from(row_count))),
        )
    };
    let steps = steps(&piece, &draft, (cord_cut, row_count));
    let notions = vec![cords];
    let pattern = pattern(vec![piece], Vec::new(), notions, steps).measuring(vec![
        sewn(
            words("上の折り山から裾まで", "from the top fold to the hem"),
            None,
            draft.finished_length.to_m(),
        ),
        sewn(
            words("裾の長さ", "along the hem"),
            None,
            draft.flat_length.to_m(),
        ),
    ]);
    Ok(pattern.warn(say!(
        "ひもの長さと段数は目安です。ハーラウや曲の決まりがあれば、それに合わせてください",
        "length and number of the cords are estimates; the rule of your hālau comes first"
    )))
}

/// How the casings are stitched; `marks` are their lines.
fn casing_step(draft: &PauDraft, row_count: u32, marks: Vec<usize>) -> Step {
    let from_edge = draft.lines.iter().map(|line| line.from_edge.to_m());
    let from_edge: Vec<f64> = from_edge.collect();
    let fold = from_edge.get(1).copied().unwrap_or_default();
    let casings = from_edge
        .iter()
        .skip(2)
        .take(from_edge.len().saturating_sub(3));
    let casings: Vec<String> = casings.map(|at| cm(at - fold)).collect();
    let [casings_japanese, casings_english] = ["、", ", "].map(|comma| casings.join(comma));
    step(
            words("ひも通しを縫う", "Stitch the casings"),
            say!(
                "裏に出ている折り返しに、上の折り山から {casings_japanese} cm の線をチャコで引き、その線の上を端から端まで縫います。2 本ずつがひも通し {row_count} 段の上と下です。両端は開けておきます。",
                "On the folded edge, which lies on the wrong side, draw chalk lines {casings_english} cm below the top fold and stitch along them from end to end: two and two they are the upper and the lower side of {row_count} rows of casing. Leave their ends open."
            ),
            stitching(draft.flat_length.to_m() * f64::from(2 * row_count)),
        )
        .shown(StepFigure::Section { piece: 0, marks })
}

fn steps(piece: &Piece, draft: &PauDraft, (cord, row_count): (f64, u32)) -> Vec<Step> {
    let lines = |wanted: &[LineKind]| -> Vec<usize> {
        let marks = piece.marks.iter().enumerate();
        let found = marks
            .filter(|(_, mark)| matches!(mark, Mark::Line { kind, .. } if wanted.contains(kind)));
        found.map(|(index, _)| index).collect()
    };
    let section = |wanted: &[LineKind]| StepFigure::Section {
        piece: 0,
        marks: lines(wanted),
    };
    let width = draft.flat_length.to_m();
    let height = draft.cut_height.to_m();
    let [length_cm, height_cm] = [draft.cut_length.to_m(), height].map(cm);
    let [fold_cm, hem_cm, end_cm] =
        [draft.fold_depth.to_m(), draft.hem_depth.to_m(), END_HEM].map(cm);
    let (cord_cm, turn_cm) = (cm(cord), cm(0.01));
    let from_edge = |line: Option<&MarkedLine>| line.map_or(0.0, |line| line.from_edge.to_m());
    let fold_at_cm = cm(from_edge(draft.lines.get(1)));
    let hem_at_cm = cm(from_edge(draft.lines.last()));
    vec![
        step(
            words("布を裁つ", "Cut the cloth"),
            say!(
                "耳に沿って {length_cm} cm、幅の方向に {height_cm} cm の長方形を 1 枚裁ちます。布の裏に、上の切り口から {turn_cm} cm（折り代）、{fold_at_cm} cm（上の折り山）、{hem_at_cm} cm（裾の折り線）のところへ、チャコで線を引きます。",
                "Cut one rectangle of {length_cm} cm along the selvage and {height_cm} cm across it. On the wrong side, draw chalk lines at {turn_cm} cm (the turned edge), {fold_at_cm} cm (the top fold) and {hem_at_cm} cm (the hem fold) from the upper raw edge."
            ),
            [20.0, 20.0],
        )
        .cutting()
        .shown(edges_of(0, &[0, 1, 2, 3])),
        step(
            words("両端を始末する", "Hem both ends"),
            say!(
                "左右の端を {end_cm} cm、三つ折りにして縫います。脇は縫い合わせません。",
                "Roll {end_cm} cm of the left and right end to the inside and stitch. The side stays open."
            ),
            minutes(&[(Work::Hem, 2.0 * height)]),
        )
        .or_by_hand(say!("三つ折りにして、まつり縫いをします。", "Roll the ends and slip-stitch them."))
        .shown(edges_of(0, &ENDS)),
        step(
            words("裾を上げる", "Hem the lower edge"),
            say!(
                "裾を {hem_cm} cm 折り上げ、端を 1 cm 折り込んで縫います。",
                "Turn up {hem_cm} cm at the hem, its edge turned under by 1 cm, and stitch."
            ),
            minutes(&[(Work::Hem, width)]),
        )
        .shown(section(&[LineKind::HemFold])),
        step(
            words("上を折る", "Fold the upper edge"),
            say!(
                "上の端を {turn_cm} cm 折り、折り山の線で {fold_cm} cm を内側に折って、アイロンをかけます。",
                "Turn the raw upper edge under by {turn_cm} cm, then fold {fold_cm} cm to the inside along the top fold and press."
            ),
            [20.0, 20.0],
        )
        .shown(section(&[LineKind::TurnUnder, LineKind::TopFold])),
        casing_step(draft, row_count, lines(&[LineKind::CasingTop, LineKind::CasingBottom])),
        step(
            words("ひもを通す", "Draw in the cords"),
            say!(
                "{cord_cm} cm のひもを各段に 1 本ずつ通し、布を寄せます。端は結んでほつれを止めます。左の腰で結んではきます。",
                "Draw a cord of {cord_cm} cm through each casing and push the cloth together. Knot the cords' ends. Wear it tied at the left hip."
            ),
            [30.0, 30.0],
        ),
    ]
}
