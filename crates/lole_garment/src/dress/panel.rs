//! Outlines of the pieces of cloth that a garment is sewn from, point by point, and which points meet.
//!
//! Both sides of a seam get points at the same shares of their length, so that every point of the flat
//! side has one on the fuller side to be sewn to. A side that is gathered gets more of them in between,
//! which pucker.

use std::collections::BTreeMap;

use glam::DVec2;
use kurbo::{ParamCurve as _, PathEl, Point};
use lole_pattern::Pattern;
use lole_pattern::pattern::SeamSide;
use lole_pattern::piece::{CutCount, Edge, Finish, LineKind, Mark, Piece};

/// Fuller sides up to this ratio are eased in, and above it gathered.
const EASED: f64 = 1.12;
/// Points along each segment of an edge from which lengths are taken.
const FINE: u32 = 96;
/// Shares of an edge nearer than this are the same place.
const SAME: f64 = 1.0e-6;

/// A stretch of an edge: piece, copy, edge, and which stretch of it from its beginning.
type StretchKey = (usize, u32, usize, usize);

/// One piece of cloth.
#[derive(Debug, Clone)]
pub(super) struct Panel {
    /// Index into the pattern's pieces.
    pub(super) piece: usize,
    /// Which of the pieces of cloth it is.
    pub(super) copy: u32,
    /// Whether it is the wearer's right one of a pair, mirrored.
    pub(super) is_mirrored: bool,
    /// Its border, counterclockwise and closed, in the plane of the piece [m].
    pub(super) border: Vec<DVec2>,
}

/// Panels of a garment, and points of their borders that are sewn together, by panel and place in the
/// border.
#[derive(Debug, Clone, Default)]
pub(super) struct Panels {
    pub(super) panels: Vec<Panel>,
    pub(super) stitches: Vec<[(usize, usize); 2]>,
    /// Points of fuller sides between two that are sewn, and where they lie in the seam.
    pub(super) puckers: Vec<Pucker>,
    /// By line asked for, its points in order.
    pub(super) lines: Vec<Vec<(usize, usize)>>,
}

/// A point of a gathered edge, the two points of the other side between which it lies, and its share of
/// the way between them.
pub(super) type Pucker = ((usize, usize), [(usize, usize); 2], f64);

/// What becomes of a stretch of an edge.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Fate {
    /// Nothing is sewn to it.
    Free,
    /// It is the mouth of a dart with this apex.
    Dart(DVec2),
    /// One side of a seam.
    Sewn,
}

#[derive(Debug, Clone, Copy)]
struct Stretch {
    between: [f64; 2],
    segment_count: usize,
    fate: Fate,
}

/// A polyline with lengths.
struct Way {
    points: Vec<DVec2>,
    lengths: Vec<f64>,
}

impl Way {
    fn of(edge: &Edge) -> Self {
        let mut points: Vec<DVec2> = Vec::new();
        for segment in &edge.segments {
            let steps = (0..=FINE).map(|step| f64::from(step) / f64::from(FINE));
            let skipped = usize::from(!points.is_empty());
            points.extend(steps.skip(skipped).map(|t| plane(segment.eval(t))));
        }
        let mut lengths = vec![0.0];
        let mut sum = 0.0;
        for pair in points.windows(2) {
            sum += pair[0].distance(pair[1]);
            lengths.push(sum);
        }
        Self { points, lengths }
    }

    fn length(&self) -> f64 {
        self.lengths.last().copied().unwrap_or(0.0)
    }

    fn at(&self, share: f64) -> DVec2 {
        let wanted = share.clamp(0.0, 1.0) * self.length();
        let after = self.lengths.partition_point(|&length| length < wanted);
        let after = after.clamp(1, self.points.len() - 1);
        let [from, to] = [self.lengths[after - 1], self.lengths[after]];
        let part = if from < to {
            (wanted - from) / (to - from)
        } else {
            0.0
        };
        self.points[after - 1].lerp(self.points[after], part)
    }

    /// The share of the way that is nearest to a point, and how far it is from it [m].
    fn nearest(&self, point: DVec2) -> (f64, f64) {
        let mut best = (0.0, f64::INFINITY);
        for (at, &length) in self.points.iter().zip(&self.lengths) {
            let distance = at.distance(point);
            if distance < best.1 {
                best = (length / self.length().max(SAME), distance);
            }
        }
        best
    }
}

fn plane(point: Point) -> DVec2 {
    DVec2::new(point.x, point.y)
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "an edge is some hundreds of spacings long"
)]
fn count(length: f64, spacing: f64) -> usize {
    (length / spacing).round().clamp(1.0, 4096.0) as usize
}

fn ratio(part: usize, whole: usize) -> f64 {
    part as f64 / whole as f64
}

/// The panels of a pattern, their points about `spacing` [m] apart, without the pieces that `is_left_out`
/// names; `lines` are stretches of edges whose points are asked for.
pub(super) fn panels(
    pattern: &Pattern,
    spacing: f64,
    is_left_out: impl Fn(&Piece) -> bool,
    lines: &[SeamSide],
) -> Panels {
    let is_kept: Vec<bool> = pattern.pieces.iter().map(|p| !is_left_out(p)).collect();
    let mut cutter = Cutter {
        pattern,
        spacing,
        ways: (pattern.pieces.iter())
            .map(|piece| piece.edges.iter().map(Way::of).collect())
            .collect(),
        stretches: BTreeMap::new(),
        points: BTreeMap::new(),
        out: Panels::default(),
    };
    cutter.plan_seams(&is_kept);
    for (piece, _) in is_kept.iter().enumerate().filter(|(_, kept)| **kept) {
        cutter.plan_rest(piece);
        cutter.cut(piece);
    }
    cutter.sew(&is_kept);
    let found = lines.iter().map(|line| cutter.line(line));
    let found = found.collect();
    let mut out = cutter.out;
    out.lines = found;
    out
}

struct Cutter<'a> {
    pattern: &'a Pattern,
    spacing: f64,
    ways: Vec<Vec<Way>>,
    /// By piece, copy and edge, in order along it.
    stretches: BTreeMap<(usize, u32, usize), Vec<Stretch>>,
    /// Points of every stretch, from its beginning as the edge is drawn.
    points: BTreeMap<StretchKey, Vec<(usize, usize)>>,
    out: Panels,
}

impl Cutter<'_> {
    fn side_length(&self, side: &SeamSide) -> f64 {
        let [from, to] = side.between;
        self.ways[side.piece][side.edge].length() * (to - from).abs()
    }

    /// Stretches that are sewn to another, equally divided.
    fn plan_seams(&mut self, is_kept: &[bool]) {
        for seam in &self.pattern.seams {
            let sides = [seam.flat, seam.full];
            if !sides.iter().all(|side| is_kept[side.piece]) {
                continue;
            }
            let [flat, full] = sides.map(|side| self.side_length(&side));
            let flat_count = count(flat.min(full), self.spacing);
            let more = |length: f64, other: f64| {
                if length <= EASED * other {
                    1
                } else {
                    count(length / other.max(SAME), 1.0).max(2)
                }
            };
            let counts = [flat_count * more(flat, full), flat_count * more(full, flat)];
            for (side, segment_count) in sides.iter().zip(counts) {
                let [from, to] = side.between;
                let stretch = Stretch {
                    between: [from.min(to), from.max(to)],
                    segment_count,
                    fate: Fate::Sewn,
                };
                let key = (side.piece, side.copy, side.edge);
                self.stretches.entry(key).or_default().push(stretch);
            }
        }
    }

    /// Darts and free stretches of a piece's edges, between those that are sewn.
    fn plan_rest(&mut self, piece: usize) {
        let darts = self.darts(piece);
        for copy in 0..copies(&self.pattern.pieces[piece]) {
            for edge in 0..self.pattern.pieces[piece].edges.len() {
                let length = self.ways[piece][edge].length();
                let stretches = self.stretches.entry((piece, copy, edge)).or_default();
                let own = darts.iter().filter(|dart| dart.0 == edge);
                stretches.extend(own.map(|dart| dart.1));
                stretches.sort_by(|a, b| a.between[0].total_cmp(&b.between[0]));
                *stretches = filled(stretches, (length, self.spacing));
            }
        }
    }

    /// Darts that open at an edge: the edge, and the stretch that is their mouth.
    fn darts(&self, piece: usize) -> Vec<(usize, Stretch)> {
        let legs: Vec<[DVec2; 2]> = (self.pattern.pieces[piece].marks.iter())
            .filter_map(dart_leg)
            .collect();
        let mut darts = Vec::new();
        for pair in legs.windows(2) {
            if SAME < pair[0][1].distance(pair[1][1]) {
                continue;
            }
            for (edge, way) in self.ways[piece].iter().enumerate() {
                let [first, second] = [pair[0], pair[1]].map(|leg| way.nearest(leg[0]));
                if first.1.max(second.1) < 2.0e-3 && SAME < (first.0 - second.0).abs() {
                    let leg = pair[0][0].distance(pair[0][1]);
                    darts.push((
                        edge,
                        Stretch {
                            between: [first.0.min(second.0), first.0.max(second.0)],
                            segment_count: count(leg, self.spacing),
                            fate: Fate::Dart(pair[0][1]),
                        },
                    ));
                }
            }
        }
        darts
    }

    /// Cuts a piece as often as it says.
    fn cut(&mut self, piece: usize) {
        let drawn = &self.pattern.pieces[piece];
        let fold = (drawn.edges.iter()).position(|edge| edge.finish == Finish::Fold);
        let edge_count = drawn.edges.len();
        if let Some(fold) = fold {
            let way = &self.ways[piece][fold];
            let axis = [way.at(0.0), way.at(1.0)];
            let half: Vec<usize> = (1..edge_count)
                .map(|step| (fold + step) % edge_count)
                .collect();
            let mut border = Vec::new();
            for &edge in &half {
                self.walk((piece, 0, edge), None, &mut border);
            }
            for &edge in half.iter().rev() {
                self.walk((piece, 1, edge), Some(axis), &mut border);
            }
            self.close((piece, 0), border);
            return;
        }
        let upright = [DVec2::ZERO, DVec2::Y];
        for copy in 0..copies(drawn) {
            let is_mirrored = is_mirrored(drawn, copy);
            let mut border = Vec::new();
            for step in 0..edge_count {
                if is_mirrored {
                    self.walk(
                        (piece, copy, edge_count - 1 - step),
                        Some(upright),
                        &mut border,
                    );
                } else {
                    self.walk((piece, copy, step), None, &mut border);
                }
            }
            self.close((piece, copy), border);
        }
    }

    fn close(&mut self, (piece, copy): (usize, u32), border: Vec<DVec2>) {
        let panel = self.out.panels.len();
        let len = border.len();
        for points in self.points.values_mut() {
            for point in points.iter_mut().filter(|point| point.0 == panel) {
                point.1 %= len;
            }
        }
        self.out.panels.push(Panel {
            piece,
            copy,
            is_mirrored: is_mirrored(&self.pattern.pieces[piece], copy),
            border,
        });
    }

    /// Walks along an edge, backwards where it is mirrored at an axis; the last point is the next edge's
    /// first one.
    fn walk(
        &mut self,
        (piece, copy, edge): (usize, u32, usize),
        mirror: Option<[DVec2; 2]>,
        border: &mut Vec<DVec2>,
    ) {
        let panel = self.out.panels.len();
        let way = &self.ways[piece][edge];
        let stretches = self.stretches.get(&(piece, copy, edge));
        let stretches: Vec<Stretch> = stretches.cloned().unwrap_or_default();
        let place = |point: DVec2| match mirror {
            Some(axis) => mirrored(point, axis),
            None => point,
        };
        let numbers: Vec<usize> = if mirror.is_some() {
            (0..stretches.len()).rev().collect()
        } else {
            (0..stretches.len()).collect()
        };
        for number in numbers {
            let mut along = along(way, &stretches[number]);
            if mirror.is_some() {
                along.reverse();
            }
            let first = border.len();
            let len = along.len();
            border.extend(along[..len - 1].iter().map(|&point| place(point)));
            let mut points: Vec<(usize, usize)> =
                (first..first + len).map(|at| (panel, at)).collect();
            if mirror.is_some() {
                points.reverse();
            }
            self.points.insert((piece, copy, edge, number), points);
        }
    }

    /// Pairs the points of seams and darts.
    fn sew(&mut self, is_kept: &[bool]) {
        let mut stitches = Vec::new();
        let mut puckers = Vec::new();
        for seam in &self.pattern.seams {
            if ![seam.flat, seam.full]
                .iter()
                .all(|side| is_kept[side.piece])
            {
                continue;
            }
            let [flat, full] = [seam.flat, seam.full].map(|side| self.line(&side));
            if flat.len() < 2 || full.len() < 2 {
                continue;
            }
            let least = flat.len().min(full.len()) - 1;
            let [flat_step, full_step] = [flat.len(), full.len()].map(|len| (len - 1) / least);
            for step in 0..=least {
                stitches.push([flat[step * flat_step], full[step * full_step]]);
            }
            for step in 0..least {
                let ends = [flat[step * flat_step], flat[(step + 1) * flat_step]];
                let between = (1..full_step).map(|part| {
                    let share = ratio(part, full_step);
                    (full[step * full_step + part], ends, share)
                });
                puckers.extend(between);
            }
        }
        for (key, stretches) in &self.stretches {
            for (number, stretch) in stretches.iter().enumerate() {
                let points = self.points.get(&(key.0, key.1, key.2, number));
                if let (Fate::Dart(_), Some(points)) = (stretch.fate, points) {
                    let last = points.len() - 1;
                    let legs = (0..last / 2).map(|step| [points[step], points[last - step]]);
                    stitches.extend(legs);
                }
            }
        }
        self.out.stitches = stitches;
        self.out.puckers = puckers;
    }

    /// Points of a stretch of an edge in the order in which it is walked.
    fn line(&self, side: &SeamSide) -> Vec<(usize, usize)> {
        let [from, to] = side.between;
        let [low, high] = [from.min(to) - 1.0e-4, from.max(to) + 1.0e-4];
        let key = (side.piece, side.copy, side.edge);
        let mut line: Vec<(usize, usize)> = Vec::new();
        for (number, stretch) in self.stretches.get(&key).into_iter().flatten().enumerate() {
            if stretch.between[0] < low || high < stretch.between[1] {
                continue;
            }
            let points = self.points.get(&(key.0, key.1, key.2, number));
            for &point in points.into_iter().flatten() {
                if line.last() != Some(&point) {
                    line.push(point);
                }
            }
        }
        if to < from {
            line.reverse();
        }
        line
    }
}

/// Stretches of an edge of this length [m], in order, with free ones between them.
fn filled(stretches: &[Stretch], (length, spacing): (f64, f64)) -> Vec<Stretch> {
    let mut filled: Vec<Stretch> = Vec::new();
    let mut passed = 0.0;
    let end = Stretch {
        between: [1.0, 1.0],
        segment_count: 0,
        fate: Fate::Free,
    };
    for &stretch in stretches.iter().chain([&end]) {
        let [from, to] = stretch.between;
        // What overlaps a stretch before it cannot be sewn twice.
        if from + 1.0e-4 < passed {
            continue;
        }
        if passed + 1.0e-4 < from {
            filled.push(Stretch {
                between: [passed, from],
                segment_count: count((from - passed) * length, spacing),
                fate: Fate::Free,
            });
        }
        if 0 < stretch.segment_count {
            filled.push(stretch);
            passed = to;
        }
    }
    filled
}

/// Copies that seams tell apart.
fn copies(piece: &Piece) -> u32 {
    if piece.edges.iter().any(|edge| edge.finish == Finish::Fold) {
        2
    } else {
        piece.cut.pieces()
    }
}

/// Whether a piece of cloth is the right one of a pair.
const fn is_mirrored(piece: &Piece, copy: u32) -> bool {
    matches!(piece.cut, CutCount::Pairs(_)) && !copy.is_multiple_of(2)
}

/// Points of a stretch from its beginning to its end; those of a dart run along its legs.
fn along(way: &Way, stretch: &Stretch) -> Vec<DVec2> {
    let [from, to] = stretch.between;
    let steps = stretch.segment_count;
    if let Fate::Dart(apex) = stretch.fate {
        let [first, last] = [from, to].map(|share| way.at(share));
        let down = (0..steps).map(|step| first.lerp(apex, ratio(step, steps)));
        let up = (0..=steps).map(|step| apex.lerp(last, ratio(step, steps)));
        return down.chain(up).collect();
    }
    (0..=steps)
        .map(|step| way.at(from + (to - from) * ratio(step, steps)))
        .collect()
}

/// From the edge to the apex.
fn dart_leg(mark: &Mark) -> Option<[DVec2; 2]> {
    let Mark::Line {
        kind: LineKind::Dart,
        path,
    } = mark
    else {
        return None;
    };
    match path.elements() {
        [PathEl::MoveTo(from), PathEl::LineTo(to)] => Some([plane(*from), plane(*to)]),
        _ => None,
    }
}

fn mirrored(point: DVec2, [a, b]: [DVec2; 2]) -> DVec2 {
    let along = (b - a).normalize_or_zero();
    let arm = point - a;
    a + along * (2.0 * along.dot(arm)) - arm
}
