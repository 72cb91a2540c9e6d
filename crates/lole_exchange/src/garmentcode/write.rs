//! Specifications of GarmentCode, written: a garment of ours in the form that its programs open.
//!
//! The form has one curve to an edge, and sews whole edges to whole edges. So edges are cut where their segments
//! meet, where a seam begins or ends, and where the other side of the seam is cut.

use std::collections::BTreeMap;

use kurbo::{ParamCurve as _, ParamCurveArclen as _, PathSeg, Point};
use lole_pattern::Pattern;
use lole_pattern::pattern::SeamSide;
use lole_pattern::piece::{CutCount, Finish, Piece};
use serde_json::{Map, Value, json};

/// Centimeters in a meter: the unit of the file.
const CM: f64 = 100.0;
/// How exactly lengths are taken [m].
const EXACT: f64 = 1.0e-8;
/// Cuts of an edge nearer to each other than this share of it are one.
const SAME: f64 = 1.0e-4;
/// Passes in which cuts go from one side of a seam to the other.
const PASSES: usize = 4;
/// How far panels lie in front of the body and behind it [m].
const AWAY: f64 = 0.25;

/// An edge of a panel before it is cut: which edge of the piece it is, and of which of its copies.
type EdgeKey = (usize, u32, usize);

/// A panel that is written.
struct Sheet {
    name: String,
    is_back: bool,
    /// Edges counterclockwise: the key of each, its segments, and whether it runs against the piece's.
    edges: Vec<(EdgeKey, Vec<PathSeg>, bool)>,
}

/// A garment as a specification; `waist_height` [m] is where the level 0 of its pieces lies above the floor of the
/// body that they are laid around.
#[must_use]
pub fn write(pattern: &Pattern, waist_height: f64) -> String {
    let sheets: Vec<Sheet> = (pattern.pieces.iter().enumerate())
        .flat_map(|(place, piece)| sheets_of(place, piece))
        .collect();
    let mut cuts = Cuts::new(&sheets);
    cuts.meet(pattern);
    let mut panels = Map::new();
    let mut numbers: BTreeMap<(EdgeKey, usize), (String, usize)> = BTreeMap::new();
    for sheet in &sheets {
        let panel = cuts.panel(sheet, waist_height, &mut numbers);
        panels.insert(sheet.name.clone(), panel);
    }
    let stitches = pattern.seams.iter().flat_map(|seam| {
        let sides = [seam.flat, seam.full].map(|side| cuts.along(side));
        let numbers = &numbers;
        let [flat, full] = sides;
        flat.into_iter().zip(full).filter_map(move |(one, other)| {
            let [one, other] = [one, other].map(|part| numbers.get(&part));
            let side = |found: &(String, usize)| json!({"panel": found.0, "edge": found.1});
            Some(json!([side(one?), side(other?)]))
        })
    });
    let stitches: Vec<Value> = stitches.collect();
    let names: Vec<&str> = sheets.iter().map(|sheet| sheet.name.as_str()).collect();
    let whole = json!({
        "pattern": {"panels": panels, "stitches": stitches, "panel_order": names},
        "parameters": {},
        "parameter_order": [],
        "properties": {
            "curvature_coords": "relative",
            "normalize_panel_translation": false,
            "normalized_edge_loops": true,
            "units_in_meter": 100,
        },
    });
    serde_json::to_string_pretty(&whole).unwrap_or_default()
}

/// The panels that are cut of a piece.
fn sheets_of(place: usize, piece: &Piece) -> Vec<Sheet> {
    let count = piece.edges.len();
    let fold = piece
        .edges
        .iter()
        .position(|edge| edge.finish == Finish::Fold);
    let is_back = piece.id.contains("back");
    let name = |copy: u32, of: u32| {
        if of == 1 {
            piece.id.to_owned()
        } else if matches!(piece.cut, CutCount::Pairs(_)) {
            let side = if copy.is_multiple_of(2) {
                "left"
            } else {
                "right"
            };
            if of == 2 {
                format!("{side}_{}", piece.id)
            } else {
                format!("{side}_{}_{}", piece.id, copy / 2 + 1)
            }
        } else {
            format!("{}_{}", piece.id, copy + 1)
        }
    };
    let pieces = piece.cut.pieces();
    if let Some(fold) = fold {
        let half: Vec<usize> = (1..count).map(|step| (fold + step) % count).collect();
        let whole = piece.unfolded();
        return (0..pieces)
            .map(|copy| {
                let near = half.iter().map(|&edge| ((place, 2 * copy, edge), false));
                let far = half.iter().rev();
                let far = far.map(|&edge| ((place, 2 * copy + 1, edge), true));
                let edges = near.chain(far).zip(&whole.edges);
                Sheet {
                    name: name(copy, pieces),
                    is_back,
                    edges: edges
                        .map(|((key, is_turned), edge)| (key, edge.segments.clone(), is_turned))
                        .collect(),
                }
            })
            .collect();
    }
    (0..pieces)
        .map(|copy| {
            let is_mirrored = matches!(piece.cut, CutCount::Pairs(_)) && !copy.is_multiple_of(2);
            let drawn = if is_mirrored {
                piece.mirrored()
            } else {
                piece.clone()
            };
            let edges = drawn.edges.into_iter().enumerate().map(|(at, edge)| {
                let own = if is_mirrored { count - 1 - at } else { at };
                ((place, copy, own), edge.segments, is_mirrored)
            });
            Sheet {
                name: name(copy, pieces),
                is_back,
                edges: edges.collect(),
            }
        })
        .collect()
}

fn length(segments: &[PathSeg]) -> f64 {
    segments.iter().map(|segment| segment.arclen(EXACT)).sum()
}

/// Where every edge is cut: shares of its length from its beginning as the piece draws it, with both ends.
struct Cuts(BTreeMap<EdgeKey, Vec<f64>>);

impl Cuts {
    /// Cut where segments meet.
    fn new(sheets: &[Sheet]) -> Self {
        let mut cuts = BTreeMap::new();
        for (key, segments, is_turned) in sheets.iter().flat_map(|sheet| &sheet.edges) {
            let whole = length(segments).max(EXACT);
            let mut at = vec![0.0];
            let mut passed = 0.0;
            for segment in segments {
                passed += segment.arclen(EXACT);
                at.push(passed / whole);
            }
            if let Some(last) = at.last_mut() {
                *last = 1.0;
            }
            if *is_turned {
                at = at.iter().rev().map(|share| 1.0 - share).collect();
            }
            cuts.insert(*key, at);
        }
        Self(cuts)
    }

    fn add(&mut self, key: EdgeKey, share: f64) {
        let Some(cuts) = self.0.get_mut(&key) else {
            return;
        };
        let after = cuts.partition_point(|cut| *cut < share);
        let is_known = |cut: Option<&f64>| cut.is_some_and(|cut| (cut - share).abs() < SAME);
        if !is_known(cuts.get(after)) && !is_known(after.checked_sub(1).and_then(|at| cuts.get(at)))
        {
            cuts.insert(after, share);
        }
    }

    /// Cuts both sides of every seam at the same shares of it.
    fn meet(&mut self, pattern: &Pattern) {
        for _ in 0..PASSES {
            for seam in &pattern.seams {
                self.carry(seam.flat, seam.full);
                self.carry(seam.full, seam.flat);
            }
        }
    }

    /// Cuts the other side of a seam at its ends, and where one side is cut.
    fn carry(&mut self, one: SeamSide, other: SeamSide) {
        let [from, to] = one.between;
        let inside: Vec<f64> = (self.0.get(&key_of(one)).into_iter().flatten())
            .map(|cut| (cut - from) / (to - from))
            .filter(|share| (SAME..1.0 - SAME).contains(share))
            .collect();
        let [begin, end] = other.between;
        for share in [0.0, 1.0].into_iter().chain(inside) {
            self.add(key_of(other), begin + (end - begin) * share);
        }
    }

    /// Parts of an edge along a side of a seam, as it is walked: the edge, and which part from its beginning.
    fn along(&self, side: SeamSide) -> Vec<(EdgeKey, usize)> {
        let key = key_of(side);
        let [from, to] = side.between;
        let [low, high] = [from.min(to), from.max(to)];
        let cuts = self.0.get(&key).map_or(&[][..], Vec::as_slice);
        let inside = cuts.windows(2).enumerate();
        let inside = inside.filter(|(_, part)| low - SAME < part[0] && part[1] < high + SAME);
        let mut parts: Vec<(EdgeKey, usize)> = inside.map(|(part, _)| (key, part)).collect();
        if to < from {
            parts.reverse();
        }
        parts
    }

    /// A panel as it is written, and the numbers of its edges.
    fn panel(
        &self,
        sheet: &Sheet,
        waist_height: f64,
        numbers: &mut BTreeMap<(EdgeKey, usize), (String, usize)>,
    ) -> Value {
        let mut parts: Vec<((EdgeKey, usize), PathSeg)> = Vec::new();
        for (key, segments, is_turned) in &sheet.edges {
            let cuts = self.0.get(key).map_or(&[][..], Vec::as_slice);
            let last = cuts.len().saturating_sub(2);
            let own: Vec<f64> = if *is_turned {
                cuts.iter().rev().map(|share| 1.0 - share).collect()
            } else {
                cuts.to_vec()
            };
            for (at, part) in own.windows(2).enumerate() {
                let number = if *is_turned { last - at } else { at };
                parts.push(((*key, number), between(segments, [part[0], part[1]])));
            }
        }
        // Seen from outside of the body loops run counterclockwise: backs are drawn through her.
        if sheet.is_back {
            parts.reverse();
            for (_, part) in &mut parts {
                *part = part.reverse();
            }
        }
        let count = parts.len();
        let vertices = parts.iter().map(|(_, part)| {
            let start = part.start();
            [CM * start.x, CM * start.y]
        });
        let vertices: Vec<[f64; 2]> = vertices.collect();
        let edges = parts.iter().enumerate().map(|(at, (key, part))| {
            numbers.insert(*key, (sheet.name.clone(), at));
            edge(part, [at, (at + 1) % count])
        });
        let edges: Vec<Value> = edges.collect();
        let away = if sheet.is_back { -AWAY } else { AWAY };
        json!({
            "translation": [0.0, CM * waist_height, CM * away],
            "rotation": [0.0, 0.0, 0.0],
            "vertices": vertices,
            "edges": edges,
        })
    }
}

fn key_of(side: SeamSide) -> EdgeKey {
    (side.piece, side.copy, side.edge)
}

/// The part of an edge between two shares of its length, which lie on one segment.
fn between(segments: &[PathSeg], [from, to]: [f64; 2]) -> PathSeg {
    let whole = length(segments);
    let middle = 0.5 * (from + to) * whole;
    let mut passed = 0.0;
    for segment in segments {
        let own = segment.arclen(EXACT);
        if middle <= passed + own {
            let at = |share: f64| {
                let along = (share * whole - passed).clamp(0.0, own);
                // Ends stay where they are, to the bit.
                if along < SAME * own {
                    0.0
                } else if (1.0 - SAME) * own < along {
                    1.0
                } else {
                    segment.inv_arclen(along, EXACT)
                }
            };
            return segment.subsegment(at(from)..at(to));
        }
        passed += own;
    }
    segments[segments.len() - 1]
}

/// A curve between two vertices, its control points along the way and to its left.
fn edge(part: &PathSeg, endpoints: [usize; 2]) -> Value {
    let (start, along) = (part.start(), part.end() - part.start());
    let squared = along.hypot2().max(EXACT * EXACT);
    let relative = |point: Point| {
        let arm = point - start;
        [arm.dot(along) / squared, along.cross(arm) / squared]
    };
    match part {
        PathSeg::Line(_) => json!({"endpoints": endpoints}),
        PathSeg::Quad(quad) => json!({
            "endpoints": endpoints,
            "curvature": {"type": "quadratic", "params": [relative(quad.p1)]},
        }),
        PathSeg::Cubic(cubic) => json!({
            "endpoints": endpoints,
            "curvature": {"type": "cubic", "params": [relative(cubic.p1), relative(cubic.p2)]},
        }),
    }
}
