//! The pāʻū skirt with a ruffle: a deep one above the elastic, a flounce at the hem, or a short second
//! layer that falls from the band.
//!
//! Makers describe "a ruffle on top" and "a second, larger ruffle layer"; how deep and how full these are
//! is an estimate and an option.

use kurbo::Point;
use lole_geom::Length;
use lole_language::words;
use lole_pattern::design::Sewn;
use lole_pattern::design::pau_skirt::{
    ElasticRow, PauDraft, PauMeasurements, PauOptions, draft_pau_skirt,
};
use lole_pattern::pattern::{NotionKind, Seam, SeamKind, Step, StepFigure, matched_parts};
use lole_pattern::piece::{CutCount, Finish, LineKind, Mark, Piece};
use lole_pattern::{DraftError, GatherRatio, Pattern, Yardage};

use super::pau_skirt::{GATHERS, HEM, HEM_HEIGHT, UNKNOWN_WIDTH, WORN_HEIGHT, worn};
use crate::drafting::chosen::{Chosen, by_measure, choice, count, number};
use crate::drafting::making::{
    cm, edges_of, folds, gathered, hem_in_section, pattern, plain, say, side, step,
};
use crate::drafting::shape::{AROUND, CM, Label, at, beside, marked, notch, rectangle};
use crate::drafting::work::{Work, minutes};
use crate::fitting::Fitting;
use crate::sketch::{Sketch, Tone};
use crate::template::{
    Choice, Fineness, Gathered, GatheredRow, OptionRow, Options, Shelf, Template, Wear, WornPlace,
    WornRuffle,
};

pub(crate) static TEMPLATE: Template = Template {
    id: "pau-ruffle",
    name: words("フリルのパウスカート", "pāʻū skirt with a ruffle"),
    about: words(
        "上、裾、または重ねのフリルが付いたパウスカート",
        "a pāʻū skirt with a ruffle above the band, at the hem, or as a second layer",
    ),
    shelf: Shelf::Skirts,
    options: OPTIONS,
    draft,
    worn: Wear::Gathered(GatheredRow {
        count: carried,
        draft: as_worn,
        fineness: Fineness::OF_SKIRT,
        second: None,
    }),
    chest_room_deg: 0.0,
    natural: None,
    sketch,
};

fn sketch(pen: &mut Sketch) {
    pen.skirt(0.74);
    let ruffle = [[0.17, 0.72], [0.83, 0.72], [0.96, 0.92], [0.04, 0.92]];
    pen.patch(&ruffle, Tone::Cloth);
    pen.fan([0.74, 0.92], [0.3, 0.42], 9);
}

const PLACES: &[Choice] = &[
    Choice {
        id: "hem",
        name: words("裾のフリル", "flounce at the hem"),
    },
    Choice {
        id: "layer",
        name: words("上に重なる短いフリル", "second layer from the band"),
    },
    Choice {
        id: "header",
        name: words("ゴムの上の深いフリル", "deep ruffle above the elastic"),
    },
];

const OPTIONS: &[OptionRow] = &[
    choice(
        "ruffle",
        PLACES,
        words("フリルの場所", "where the ruffle is"),
    ),
    by_measure(
        "ruffle_depth_cm",
        [2.0, 60.0],
        words(
            "フリルの丈。書かなければ裾は 15、重ねは 25、上は 6",
            "depth of the ruffle; left out: 15 at the hem, 25 as a layer, 6 above",
        ),
    ),
    number(
        "ruffle_ratio",
        [1.0, 3.0],
        1.5,
        words(
            "フリルの長さ÷付ける所の長さ",
            "ruffle over what it is sewn to",
        ),
    ),
    number("hem_height_cm", [0.0, 100.0], 22.0, HEM_HEIGHT),
    by_measure("worn_height_cm", [40.0, 130.0], WORN_HEIGHT),
    number("gather_ratio", [1.0, 5.0], 3.0, GATHERS),
    count(
        "elastic_row_count",
        [1, 6],
        3,
        words("ゴムの段数", "rows of elastic"),
    ),
    number("hem_allowance_cm", [0.0, 30.0], 3.0, HEM),
];

/// Allowance of the seams [m].
const SEAM: f64 = 1.0 * CM;
/// Gathers are run this far inside the stitching line, in the allowance [m].
const GATHER_INSET: f64 = -0.3 * CM;

/// A second layer is carried by itself; a flounce hangs on the skirt, and a header is part of it.
fn carried(options: &Options) -> usize {
    let chosen = Chosen::new(OPTIONS, options);
    1 + usize::from(chosen.is_ok_and(|chosen| chosen.choice("ruffle") == "layer"))
}

/// How deep the ruffle is [m].
fn depth(chosen: &Chosen<'_>) -> f64 {
    let usual_cm = usual_depth_cm(chosen.choice("ruffle"));
    chosen.m_or("ruffle_depth_cm", usual_cm * CM)
}

/// The skirt and its ruffle, as they are worn; a deep ruffle above the elastic is part of the skirt.
fn as_worn(fitting: &Fitting<'_>, options: &Options) -> Result<Gathered, DraftError> {
    let chosen = Chosen::new(OPTIONS, options)?;
    let worn = worn(fitting, &chosen)?;
    let cut = cut(&chosen)?;
    let draft = draft_pau_skirt(&worn, &cut)?;
    let place = chosen.choice("ruffle");
    let ruffle = Ruffle::of(&draft, &chosen);
    let on_paper = |edge| ruffle.as_draft(edge);
    Ok(Gathered {
        ruffle: match place {
            "hem" => Some(WornRuffle::Flounce(on_paper(Vec::new()))),
            "layer" => {
                let edge_height = worn.worn_height - cut.casing;
                let edge = ElasticRow {
                    from_fold: Length::ZERO,
                    cut_length: Length::ZERO,
                    ring_length: worn.worn_girth,
                };
                let girth = fitting.girth_at(edge_height.to_m_f32());
                Some(WornRuffle::Layer {
                    draft: on_paper(vec![edge]),
                    worn: PauMeasurements {
                        worn_girth: girth.unwrap_or(worn.worn_girth),
                        worn_height: edge_height,
                        ..worn
                    },
                })
            }
            _ => None,
        },
        draft,
        worn,
        place: WornPlace::Hips,
        is_open: false,
    })
}

fn cut(chosen: &Chosen<'_>) -> Result<PauOptions, DraftError> {
    let place = chosen.choice("ruffle");
    let depth = depth(chosen);
    let m = |key| Length::from_m(chosen.m(key));
    let usual = PauOptions::default();
    let flounce = place == "hem";
    Ok(PauOptions {
        gather_ratio: GatherRatio::new(chosen.number("gather_ratio"))?,
        hem_height: m("hem_height_cm") + Length::from_m(if flounce { depth } else { 0.0 }),
        elastic_row_count: chosen.count("elastic_row_count"),
        header: if place == "header" {
            Length::from_m(depth)
        } else {
            usual.header
        },
        hem: if flounce {
            Length::from_m(SEAM)
        } else {
            m("hem_allowance_cm")
        },
        fabric_width: UNKNOWN_WIDTH,
        ..usual
    })
}

fn draft(fitting: &Fitting<'_>, options: &Options) -> Result<Pattern, DraftError> {
    let chosen = Chosen::new(OPTIONS, options)?;
    let (place, depth) = (chosen.choice("ruffle"), depth(&chosen));
    let flounce = place == "hem";
    let cut = cut(&chosen)?;
    let skirt = as_worn(fitting, options)?.draft;
    if place == "header" {
        return Ok(skirt.pattern(TEMPLATE.name));
    }
    let ruffle = Ruffle::of(&skirt, &chosen);
    // Just under the lowest elastic, so that the band stays smooth above it.
    let lowest = skirt.elastic_rows.last();
    let under_band = lowest.map_or(Length::ZERO, |row| row.from_fold) + cut.casing;
    let raw_edge = skirt.cut_height - skirt.hem_depth - skirt.finished_length;
    let base = skirt.pattern_with(
        TEMPLATE.name,
        Some(Sewn {
            steps: ruffle.steps(place),
            placement: (!flounce).then_some(raw_edge + under_band),
            below: Length::from_m(if flounce { depth } else { 0.0 }),
        }),
    );
    let Pattern {
        mut pieces,
        seams: mut joined,
        drawn_in: _,
        notions,
        steps,
        warnings,
        mut finished,
    } = base;
    let notions = notions
        .into_iter()
        .filter(|one| one.kind != NotionKind::Thread);
    joined.extend(ruffle.ring(1));
    if flounce {
        let panel = &mut pieces[0];
        panel.edges[0].finish = Finish::Seam;
        panel.marks.retain(|mark| {
            !matches!(
                mark,
                Mark::Line {
                    kind: LineKind::HemFold,
                    ..
                }
            )
        });
        joined.extend(ruffle.on_hem(1));
        // Its lowest edge is the ruffle's.
        let around = finished.iter_mut().filter(|row| row.name == PauDraft::HEM);
        around.for_each(|row| row.garment = Length::from_m(ruffle.ring));
    } else {
        let y = (skirt.finished_length - under_band).to_m();
        pieces[0].marks.push(ruffle.placement(y));
    }
    pieces.push(ruffle.piece());
    let mut pattern = pattern(pieces, joined, notions.collect(), steps);
    pattern.warnings = warnings;
    pattern.finished = finished;
    Ok(pattern.warn(say!(
        "フリルの丈と寄せ方は目安です",
        "depth and fullness of the ruffle are estimates"
    )))
}

/// The ruffle: strips that are joined to a ring.
#[derive(Debug, Clone, Copy)]
struct Ruffle {
    /// Strips.
    count: u32,
    /// Length of one strip and of the whole ring [m].
    strip: f64,
    ring: f64,
    /// What it is sewn to [m].
    flat: f64,
    depth: f64,
    hem: f64,
    /// What becomes of its upper edge: a layer's is turned under and stitched onto the skirt.
    top: Finish,
}

impl Ruffle {
    /// Strips that are no longer than the skirt's own piece, so that the same cloth takes them.
    fn of(skirt: &PauDraft, chosen: &Chosen<'_>) -> Self {
        let (depth, ratio) = (depth(chosen), chosen.number("ruffle_ratio"));
        let hem = chosen.m("hem_allowance_cm");
        let flounce = chosen.choice("ruffle") == "hem";
        let flat = skirt.flat_length.to_m();
        let mut count = 1;
        while f64::from(count) < ratio - 1.0e-9 {
            count += 1;
        }
        let exact = flat * ratio / f64::from(count);
        // What is gathered is cut to a whole millimeter, so that plan and steps say the same.
        let strip = if 1.0 < ratio {
            (1000.0 * exact).round() / 1000.0
        } else {
            exact
        };
        Self {
            count,
            strip,
            ring: strip * f64::from(count),
            flat,
            depth,
            hem,
            top: if flounce { Finish::Seam } else { Finish::Hem },
        }
    }

    /// The ring as a gathered rectangle, carried along `edge`.
    fn as_draft(&self, edge: Vec<ElasticRow>) -> PauDraft {
        let m = Length::from_m;
        let cut_length = m(self.ring + 2.0 * SEAM * f64::from(self.count));
        PauDraft {
            flat_length: m(self.ring),
            finished_length: m(self.depth),
            cut_length,
            cut_height: m(self.depth + self.hem + SEAM),
            fold_depth: Length::ZERO,
            hem_depth: m(self.hem),
            band_row_count: 0,
            elastic_rows: edge,
            elastic_total: Length::ZERO,
            lines: Vec::new(),
            yardage: Yardage::for_gathered(cut_length),
            thread: Length::ZERO,
            warnings: Vec::new(),
        }
    }

    fn piece(&self) -> Piece {
        let sides = [
            ("hem", Finish::Hem, self.hem),
            ("left_end", Finish::Seam, SEAM),
            ("top", self.top, SEAM),
            ("right_end", Finish::Seam, SEAM),
        ];
        let label = Label::main(
            "ruffle",
            words("フリル", "ruffle"),
            CutCount::Alike(self.count),
        );
        let mut piece = rectangle(label, [self.strip, self.depth], sides, AROUND);
        let top = &piece.edges[2];
        let gathers = beside(LineKind::Gather, top, GATHER_INSET, [0.0, self.strip]);
        piece.marks.push(gathers);
        if self.top == Finish::Hem {
            // No seam of two edges marks what is laid onto a line.
            let parts = self.parts();
            let part = self.strip / f64::from(parts);
            let marks = (1..parts).map(|index| notch(2, f64::from(index) * part));
            piece.marks.extend(marks);
        }
        piece
    }

    /// Equal parts that a strip and what it is sewn to are marked at.
    fn parts(&self) -> u32 {
        matched_parts(self.kind(), self.flat / f64::from(self.count))
    }

    /// Whether there is anything to gather.
    fn kind(&self) -> SeamKind {
        if self.ring <= self.flat * (1.0 + 1.0e-9) {
            SeamKind::Plain
        } else {
            SeamKind::Gathered
        }
    }

    /// The line that a layer is laid onto, with a short stroke across it at every mark of the strips.
    fn placement(&self, y: f64) -> Mark {
        /// How far the strokes reach to both sides [m].
        const STROKE: f64 = 0.7 * CM;
        let parts = self.count * self.parts();
        let strokes = (1..parts).flat_map(|index| {
            let x = self.flat * f64::from(index) / f64::from(parts);
            [0.0, STROKE, -STROKE, 0.0].map(|over| at(x, y + over))
        });
        let ends = [at(0.0, y), at(self.flat, y)];
        let points: Vec<Point> = std::iter::once(ends[0])
            .chain(strokes)
            .chain([ends[1]])
            .collect();
        marked(LineKind::Placement, &points)
    }

    /// Strip to strip, and the last one to the first.
    fn ring(&self, piece: usize) -> Vec<Seam> {
        (0..self.count)
            .map(|copy| {
                let next = (copy + 1) % self.count;
                plain(side(piece, copy, 1), side(piece, next, 3).back())
            })
            .collect()
    }

    /// The upper edges to the lower edge of the skirt. That runs to the wearer's left, theirs back.
    fn on_hem(&self, piece: usize) -> Vec<Seam> {
        let share = 1.0 / f64::from(self.count);
        (0..self.count)
            .map(|copy| {
                let from = f64::from(copy) * share;
                let flat = side(0, 0, 0).between(from, (from + share).min(1.0));
                let full = side(piece, copy, 2).back();
                match self.kind() {
                    SeamKind::Gathered => gathered(flat, full),
                    SeamKind::Plain | SeamKind::Eased => plain(flat, full),
                }
            })
            .collect()
    }

    fn steps(&self, place: &str) -> Vec<Step> {
        let [strip_cm, ring_cm, flat_cm] = [self.strip + 2.0 * SEAM, self.ring, self.flat].map(cm);
        let [turn_cm, rest_cm] = folds(self.hem);
        let (height_cm, seam_cm) = (cm(self.depth + self.hem + SEAM), cm(SEAM));
        let count = self.count;
        let flounce = place == "hem";
        let parts = count * self.parts();
        let [each_cm, onto_cm] = [self.ring, self.flat].map(|way| cm(way / f64::from(parts)));
        let onto = if flounce {
            say!(
                "フリルの上端に {each_cm} cm ごと、スカートの下端に {onto_cm} cm ごとに合印を付けます（全体を {parts} 等分）。フリルを {flat_cm} cm まで寄せ、合印を合わせて中表に置き、縫い代 1 cm で縫います。縫い代の端をいっしょにジグザグミシンで始末し、上へ倒します。",
                "Notch the ruffle's upper edge every {each_cm} cm and the skirt's lower edge every {onto_cm} cm ({parts} equal parts of each). Gather the ruffle to {flat_cm} cm, match the notches, and sew the two right sides together with 1 cm of allowance. Neaten both allowances as one and press them up."
            )
        } else {
            say!(
                "フリルの上端に {each_cm} cm ごとに合印を、付け位置の線に {onto_cm} cm ごとにしるしを付けます（全体を {parts} 等分）。フリルの上端の縫い代を裏へ折り、{flat_cm} cm まで寄せ、合印としるしを合わせて付け位置に縫い付けます。",
                "Notch the ruffle's upper edge every {each_cm} cm and mark the placement line every {onto_cm} cm ({parts} equal parts of each). Fold the ruffle's upper allowance under, gather it to {flat_cm} cm, match the marks and stitch it onto the line."
            )
        };
        let figure = if flounce {
            StepFigure::Seams(vec![1 + count as usize])
        } else {
            edges_of(1, &[2])
        };
        vec![
            step(
                words("フリルを裁って輪にする", "Cut the ruffle and close it"),
                say!(
                    "{strip_cm} cm × {height_cm} cm の布を {count} 枚裁ち、端どうしを縫い代 {seam_cm} cm で縫って {ring_cm} cm の輪にします。",
                    "Cut {count} of {strip_cm} cm by {height_cm} cm and join their ends with {seam_cm} cm of allowance to a ring of {ring_cm} cm."
                ),
                minutes(&[
                    (Work::Piece, f64::from(self.count)),
                    (Work::Seam, f64::from(self.count) * self.depth),
                ]),
            )
            .shown(edges_of(1, &[1, 3])),
            step(
                words("フリルの裾を上げる", "Hem the ruffle"),
                say!(
                    "下端を裏へ {turn_cm} cm、さらに {rest_cm} cm 折って縫います。",
                    "Fold the lower edge to the wrong side by {turn_cm} cm and again by {rest_cm} cm, and stitch."
                ),
                minutes(&[(Work::Hem, self.ring)]),
            )
            .shown(hem_in_section(1)),
            step(
                words("フリルを寄せて付ける", "Gather the ruffle and sew it on"),
                onto,
                minutes(&[(Work::Gathers, self.ring)]),
            )
            .or_by_hand(say!(
                "上端をぐし縫いで 2 本縫って寄せ、半返し縫いで付けます。",
                "Run two rows of small stitches, pull them up, and sew with half back stitches."
            ))
            .shown(figure),
        ]
    }
}

/// Depth of a ruffle that was not decided [cm].
fn usual_depth_cm(place: &str) -> f64 {
    match place {
        "hem" => 15.0,
        "layer" => 25.0,
        _ => 6.0,
    }
}
