//! Specifications of GarmentCode, and of the older generator of garment patterns that it grew out of.
//!
//! Facts of the format, from its authors' code (`pygarment`, `pattern/core.py` and `garmentcode/`, MIT) and from
//! Korosteleva and Sorkine-Hornung, "GarmentCode: Programming Parametric Sewing Patterns" (2023):
//! - A panel has vertices in its own plane, edges between them in a closed loop, and lies in the space of a body
//!   by Euler angles about x, then y, then z [°] and a translation. The loop runs counterclockwise seen from
//!   outside of the body, so its direction says which side of the cloth is right.
//! - `units_in_meter` says how many units make a meter; it scales vertices and translations.
//! - Control points are relative to their edge: along it, and to its left, in its lengths. An arc has radius,
//!   whether it is the large one, and whether it bulges to the right.
//! - A stitch names two edges. Which of their ends meet is not said. Cloth stays a surface with one right side
//!   where the two edges run against each other; a third element, `"right_wrong"`, turns one of them.

mod edge;
mod place;
mod stitch;
pub mod write;

use glam::DVec2;
use kurbo::{ParamCurve as _, PathSeg, Vec2};
use lole_garment::given::{Given, GivenPanel, MOST_PANELS, Origin, number_words, panel_id};
use lole_geom::{Length, polygon};
use lole_language::{Sentence, Words, is_unseen, words};
use lole_pattern::Pattern;
use lole_pattern::pattern::Seam;
use lole_pattern::piece::{ClothRole, CutCount, Edge, Finish, Piece};
use serde_json::Value;

use crate::ExchangeError;
use crate::fields::{self, Fields};

pub use write::write;

/// What a file of this kind is called.
pub const WHAT: Words = words("GarmentCode の型紙", "a pattern of GarmentCode");

/// Bytes of a file, at most: a dress of forty panels has 120,000.
pub const MOST_BYTES: usize = 4 << 20;
/// Vertices of a panel, and edges, at most.
pub const MOST_EDGES: usize = 400;
/// Stitches of a file, at most.
pub const MOST_STITCHES: usize = 2000;
/// Letters of a panel's name, at most.
const MOST_LETTERS: usize = 100;
/// Farthest that anything lies from where places are counted [m].
const FARTHEST: f64 = 20.0;
/// Sizes of the largest panel that a garment has [m].
const SIZES: [f64; 2] = [0.05, 6.0];
/// Units in a meter, from kilometers to micrometers.
const UNITS: [f64; 2] = [1.0e-3, 1.0e6];
/// Shortest edge [m].
const SHORTEST: f64 = 1.0e-4;
/// A border is divided at this distance to see whether it crosses itself [m].
const COARSE: f64 = 0.1;
/// Points along each segment then.
const FINE: u32 = 8;
/// Cloth that is added outside of every edge, because no such file says how much.
const ALLOWANCE: Length = Length::from_cm(1.0);
/// A body whose places are counted from the floor has nothing below it but what a hem may [m].
const BELOW_FLOOR: f64 = -0.05;

/// A panel as it was read, before it is known what is sewn to it.
struct Panel {
    name: String,
    /// Edges in the order of the file, each in segments [m].
    edges: Vec<Vec<PathSeg>>,
    /// Whether the loop runs clockwise in its own plane.
    is_clockwise: bool,
    given: GivenPanel,
}

impl Panel {
    /// Place of an edge of the file among those of the piece, which run counterclockwise.
    fn edge_of_piece(&self, edge: usize) -> usize {
        if self.is_clockwise {
            self.edges.len() - 1 - edge
        } else {
            edge
        }
    }

    /// Segments of an edge of the piece.
    fn segments(&self, edge: usize) -> Vec<PathSeg> {
        let drawn = &self.edges[self.edge_of_piece(edge)];
        if self.is_clockwise {
            drawn.iter().rev().map(PathSeg::reverse).collect()
        } else {
            drawn.clone()
        }
    }
}

/// Reads a specification.
///
/// # Errors
/// The first thing that is wrong, in one sentence with its place in the file.
pub fn read(bytes: &[u8]) -> Result<Given, ExchangeError> {
    let bytes = fields::checked(bytes, WHAT, MOST_BYTES)?;
    let value: Value = serde_json::from_slice(bytes).map_err(|error| ExchangeError::NotJson {
        line: error.line(),
        column: error.column(),
    })?;
    let root = Fields::of(&value, "", WHAT)?;
    let pattern = root.object("pattern")?;
    let mut notes = Vec::new();
    let format = Format::read(&root, &mut notes)?;
    let panels = read_panels(&pattern, format)?;
    check_size(&panels)?;
    let (seams, told) = stitch::read(pattern.list("stitches")?, &panels)?;
    notes.extend(told);
    let lowest = lowest(&panels);
    let origin = if lowest < BELOW_FLOOR {
        notes.push(Sentence::new(
            "型紙の置き場所は、床からではなく胴の中ほどから数えられているものとしました",
            "the panels' places are taken as counted from within the trunk, not from the floor: some lie below 0",
        ));
        Origin::Trunk
    } else {
        Origin::Floor
    };
    Ok(Given {
        pattern: pattern_of(&panels, seams),
        panels: panels.into_iter().map(|panel| panel.given).collect(),
        origin,
        notes,
    })
}

/// Whether bytes begin as a specification does: for commands that take files of several kinds.
#[must_use]
pub fn is_specification(bytes: &[u8]) -> bool {
    // What is larger is none, and what it holds may take a hundred times as much once it is read.
    let Ok(bytes) = fields::checked(bytes, WHAT, MOST_BYTES) else {
        return false;
    };
    let value = serde_json::from_slice::<Value>(bytes).unwrap_or_default();
    value
        .get("pattern")
        .is_some_and(|pattern| pattern.get("panels").is_some())
}

/// What a file says about all its numbers.
#[derive(Debug, Clone, Copy)]
struct Format {
    /// Meters in a unit.
    unit: f64,
    /// Whether control points are places of the plane rather than of their edge.
    is_absolute: bool,
}

impl Format {
    fn read(root: &Fields<'_>, notes: &mut Vec<Sentence>) -> Result<Self, ExchangeError> {
        let properties = root.object("properties")?;
        let units = match properties.map.get("units_in_meter") {
            None => {
                notes.push(Sentence::new(
                    "ファイルに単位がないので、センチメートルとしました",
                    "the file names no unit; its numbers are taken as centimeters",
                ));
                100.0
            }
            Some(value) => {
                let place = properties.at("units_in_meter");
                let units = fields::number(value, &place)?;
                if !(UNITS[0]..=UNITS[1]).contains(&units) {
                    return Err(ExchangeError::wrong(
                        place,
                        &value.to_string(),
                        (
                            "1 m の単位の数（cm なら 100、mm なら 1000）",
                            "how many units make a meter: 100 for centimeters, 1000 for millimeters",
                        ),
                    ));
                }
                units
            }
        };
        let is_absolute = match properties.map.get("curvature_coords").map(Value::as_str) {
            None | Some(Some("relative")) => false,
            Some(Some("absolute")) => true,
            Some(_) => {
                return Err(ExchangeError::wrong(
                    properties.at("curvature_coords"),
                    &properties.map["curvature_coords"].to_string(),
                    (
                        "\"relative\" か \"absolute\"",
                        "\"relative\" or \"absolute\"",
                    ),
                ));
            }
        };
        Ok(Self {
            unit: units.recip(),
            is_absolute,
        })
    }
}

fn read_panels(pattern: &Fields<'_>, format: Format) -> Result<Vec<Panel>, ExchangeError> {
    let panels = pattern.object("panels")?;
    let count = panels.map.len();
    if count == 0 {
        return Err(ExchangeError::unsewable(
            "pattern.panels",
            "型紙が一枚もありません。服の入ったファイルを選んでください",
            "there is no panel; choose a file with a garment in it",
        ));
    }
    too_many(
        "pattern.panels",
        words("型紙", "panels"),
        (count, MOST_PANELS),
    )?;
    let read = panels.map.iter().map(|(name, value)| {
        let is_name = name.chars().nth(MOST_LETTERS).is_none() && !name.chars().any(is_unseen);
        if !is_name || name.is_empty() {
            return Err(ExchangeError::wrong(
                "pattern.panels",
                &lole_language::visible(name),
                (
                    "見える文字 1 字から 100 字までの型紙の名前",
                    "a panel's name of 1 to 100 letters that can be seen",
                ),
            ));
        }
        let fields = Fields::of(value, panels.at(name), WHAT)?;
        read_panel(name, &fields, format)
    });
    read.collect()
}

pub(crate) fn too_many(
    place: &str,
    what: Words,
    (count, most): (usize, usize),
) -> Result<(), ExchangeError> {
    if count <= most {
        return Ok(());
    }
    Err(ExchangeError::TooMany {
        place: place.to_owned(),
        what,
        count,
        most,
    })
}

fn read_panel(name: &str, fields: &Fields<'_>, format: Format) -> Result<Panel, ExchangeError> {
    let vertices = fields.list("vertices")?;
    let at = fields.at("vertices");
    too_many(&at, words("頂点", "vertices"), (vertices.len(), MOST_EDGES))?;
    let vertices: Vec<DVec2> = (0..)
        .zip(vertices)
        .map(|(index, value): (usize, _)| {
            let place = format!("{at}[{index}]");
            let point = DVec2::from(fields::numbers::<2>(value, &place)?) * format.unit;
            if FARTHEST < point.abs().max_element() {
                return Err(ExchangeError::wrong(
                    place,
                    &value.to_string(),
                    (
                        "服の中の場所（units_in_meter を確かめてください）",
                        "a place in a garment; check units_in_meter",
                    ),
                ));
            }
            Ok(point)
        })
        .collect::<Result<_, _>>()?;
    let edges = edge::read_loop(fields, (&vertices, format))?;
    let mut outline: Vec<DVec2> = Vec::new();
    for segment in edges.iter().flatten() {
        let steps = (0..FINE).map(|step| f64::from(step) / f64::from(FINE));
        outline.extend(steps.map(|t| plane(segment.eval(t))));
    }
    let area = signed_area(&outline);
    if polygon::divide(&counterclockwise(outline, area), COARSE).is_none() {
        return Err(ExchangeError::unsewable(
            fields.at("edges"),
            "輪郭が自分と交わるか触れています。交わらない型紙にしてください",
            "the outline crosses or touches itself; draw it so that it can be cut out",
        ));
    }
    let body_from_piece = place::read(fields, format.unit)?;
    Ok(Panel {
        name: name.to_owned(),
        edges,
        is_clockwise: area < 0.0,
        given: GivenPanel {
            name: name.to_owned(),
            outward: body_from_piece.matrix3.z_axis * if area < 0.0 { -1.0 } else { 1.0 },
            body_from_piece,
        },
    })
}

fn counterclockwise(mut outline: Vec<DVec2>, area: f64) -> Vec<DVec2> {
    if area < 0.0 {
        outline.reverse();
    }
    outline
}

fn signed_area(outline: &[DVec2]) -> f64 {
    let next = outline.iter().cycle().skip(1);
    let doubled: f64 = outline.iter().zip(next).map(|(a, b)| a.perp_dot(*b)).sum();
    0.5 * doubled
}

fn plane(point: kurbo::Point) -> DVec2 {
    DVec2::new(point.x, point.y)
}

/// A unit that is not the file's makes a garment for a doll or a giant.
fn check_size(panels: &[Panel]) -> Result<(), ExchangeError> {
    let sizes = panels.iter().map(|panel| {
        let points = panel.edges.iter().map(|edge| plane(edge[0].start()));
        let (low, high) = points.fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |span, point| {
            (span.0.min(point), span.1.max(point))
        });
        (high - low).max_element()
    });
    let largest = sizes.fold(0.0, f64::max);
    if (SIZES[0]..=SIZES[1]).contains(&largest) {
        return Ok(());
    }
    Err(ExchangeError::unsewable(
        "properties.units_in_meter",
        format!(
            "いちばん大きい型紙が {:.1} cm になります。単位を確かめてください",
            100.0 * largest
        ),
        format!(
            "the largest panel would be {:.1} cm long; check the unit",
            100.0 * largest
        ),
    ))
}

fn lowest(panels: &[Panel]) -> f64 {
    let points = panels.iter().flat_map(|panel| {
        let starts = panel.edges.iter().map(|edge| plane(edge[0].start()));
        starts.map(|point| panel.given.place(point).y)
    });
    points.fold(f64::INFINITY, f64::min)
}

/// The panels as pieces, each cut once.
fn pattern_of(panels: &[Panel], seams: Vec<Seam>) -> Pattern {
    let sewn: Vec<[usize; 2]> = (seams.iter())
        .flat_map(|seam| [seam.flat, seam.full])
        .map(|side| [side.piece, side.edge])
        .collect();
    let darts: Vec<[usize; 2]> = (seams.iter())
        .filter(|seam| seam.flat.piece == seam.full.piece)
        .flat_map(|seam| [seam.flat, seam.full])
        .map(|side| [side.piece, side.edge])
        .collect();
    let pieces = panels.iter().enumerate().map(|(place, panel)| {
        let edges = (0..panel.edges.len()).map(|edge| {
            let segments = panel.segments(edge);
            let is_sewn = sewn.contains(&[place, edge]);
            // Between the legs of a dart there is no room for allowances.
            let is_dart = darts.contains(&[place, edge]);
            Edge {
                id: "edge",
                segments,
                allowance: if is_dart { Length::ZERO } else { ALLOWANCE },
                finish: if is_sewn { Finish::Seam } else { Finish::Hem },
            }
        });
        Piece {
            id: panel_id(place),
            name: number_words(place),
            edges: edges.collect(),
            grain: Vec2::new(0.0, 1.0),
            marks: Vec::new(),
            cloth: ClothRole::Main,
            cut: CutCount::Alike(1),
        }
    });
    Pattern {
        pieces: pieces.collect(),
        seams,
        drawn_in: Vec::new(),
        notions: Vec::new(),
        steps: Vec::new(),
        finished: Vec::new(),
        warnings: vec![Sentence::new(
            "型紙のファイルに縫い代は書かれていません。ダーツのほかはどこも 1 cm 付けてあります",
            "the pattern's file says nothing of seam allowances: 1 cm is added everywhere but at darts",
        )],
    }
}
