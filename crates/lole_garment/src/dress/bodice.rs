//! Where the pieces of fitted garments lie around trunk and arms before they are sewn.
//!
//! Levels of a piece are heights of the body by the landmarks it was drafted from; at each level the half
//! width of the piece is laid from the middle to her left side, or, beside an armhole, to the fold of the
//! arm. So seams of sides and shoulders nearly meet before anything is sewn.

use glam::{DVec2, Vec3};
use kurbo::{ParamCurve as _, PathSeg};
use lole_geom::narrow;
use lole_geom::trig;
use lole_pattern::piece::{Finish, Piece};
use lole_pattern::{Measures, Pattern};

use super::form::{Face, Form};
use crate::wave;

/// Points along each segment of an edge, from which widths are taken.
const FINE: u32 = 48;
/// Gap between skin and cloth that lies close [m].
const CLOSE: f32 = 0.010;
/// Farthest that wide cloth is laid from the trunk [m]: what is too much lies in folds.
const FARTHEST: f32 = 0.05;
/// How much farther than that it may be for each meter below the arms [m/m].
const FLARING: f32 = 0.09;
/// Where the arm's fold lies between the middle and the side of the trunk's tape, half way up the armhole,
/// and at the shoulder point.
const FOLD_OF_ARM: f64 = 0.80;
const SHOULDER_POINT: f64 = 0.97;
/// Cloth of one fold where there is more than room [m].
const FOLD: f32 = 0.14;
/// Cloth of one gather of a ruffle [m].
const GATHER: f32 = 0.08;
/// Below a gathered edge folds reach their depth within this [m].
const FOLD_BEGINS: f32 = 0.10;
/// Cloth over the shoulder is laid this far above it [m].
const OVER_SHOULDER: f32 = 0.012;
/// Cloth that is laid on the floor lies this far above it [m].
const FLOOR_GAP: f32 = 0.006;
/// How far a train spreads to her sides at the ends of the back, over how far it goes behind her.
const SPREADING: f32 = 0.4;

/// What a piece covers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Covered {
    /// The trunk in front, or part of it.
    Front,
    /// The trunk at the back, or part of it.
    Back,
    /// An arm; the drawn one is the left.
    Sleeve,
    /// Whatever one cloth is wrapped around.
    Wrap,
    /// The legs below the hem of front and back, half of it each.
    Ruffle,
}

/// Levels of a piece and the heights above the floor that they lie at, rising [m].
#[derive(Debug, Clone)]
struct Levels(Vec<[f64; 2]>);

impl Levels {
    fn height(&self, y: f64) -> f64 {
        let knots = &self.0;
        let after = knots
            .partition_point(|knot| knot[0] < y)
            .clamp(1, knots.len() - 1);
        let [a, b] = [knots[after - 1], knots[after]];
        let rise = b[0] - a[0];
        if rise < 1.0e-6 {
            return a[1] + y - a[0];
        }
        a[1] + (b[1] - a[1]) * (y - a[0]) / rise
    }
}

/// Landmarks of one face of the trunk, on its pieces.
#[derive(Debug, Clone)]
struct Half {
    levels: Levels,
    underarm: f64,
    tip: f64,
}

/// A fitted garment about to be laid around a form.
pub(crate) struct Bodice<'a> {
    pattern: &'a Pattern,
    front: Half,
    back: Half,
    /// Outlines as drawn, by piece.
    outlines: Vec<Vec<DVec2>>,
    parts: Vec<Option<Covered>>,
    /// Of front and back, where both have one.
    hems: Option<[Hem; 2]>,
}

/// Beginning of an edge of this name, and its end.
fn ends(piece: &Piece, id: &str) -> Option<[DVec2; 2]> {
    let edge = piece.edge(id)?;
    let (first, last) = (edge.segments.first()?, edge.segments.last()?);
    let plane = |point: kurbo::Point| DVec2::new(point.x, point.y);
    Some([plane(first.start()), plane(last.end())])
}

/// Points along a segment of an edge, without its end.
fn points_of(segment: &PathSeg) -> impl Iterator<Item = DVec2> {
    (0..FINE).map(|step| {
        let point = segment.eval(f64::from(step) / f64::from(FINE));
        DVec2::new(point.x, point.y)
    })
}

fn outline(piece: &Piece) -> Vec<DVec2> {
    let segments = piece.edges.iter().flat_map(|edge| &edge.segments);
    segments.flat_map(points_of).collect()
}

impl<'a> Bodice<'a> {
    /// Reads the landmarks of a garment whose pieces cover `parts`; `None` where it has no armhole.
    pub(crate) fn new(
        pattern: &'a Pattern,
        parts: Vec<Option<Covered>>,
        measures: &Measures,
    ) -> Option<Self> {
        let of = |part: Covered| {
            let pieces = pattern.pieces.iter().zip(&parts);
            pieces
                .filter(move |(_, found)| **found == Some(part))
                .map(|(piece, _)| piece)
        };
        let half = |part: Covered| {
            // From the lowest piece to the highest: a yoke goes on above what hangs from it.
            let underarm = of(part).find_map(|piece| Some(ends(piece, "armhole")?[0].y))?;
            let [tip, neck] = of(part).find_map(|piece| ends(piece, "shoulder"))?;
            let [waist, armpit, neck_side, drop] = [
                measures.waist_height,
                measures.armpit_height,
                measures.neck_height,
                measures.shoulder_drop,
            ]
            .map(lole_geom::Length::to_m);
            let levels = Levels(vec![
                [-waist, 0.0],
                [0.0, waist],
                [underarm, armpit.max(waist + 0.05) - 0.015],
                [tip.y, neck_side - drop],
                [neck.y.max(tip.y + 0.01), neck_side],
            ]);
            Some(Half {
                levels,
                underarm,
                tip: tip.y,
            })
        };
        let hem = |part: Covered| {
            let pieces = pattern.pieces.iter().enumerate();
            Hem::lowest(pieces.filter(|(piece, _)| parts[*piece] == Some(part)))
        };
        Some(Self {
            hems: hem(Covered::Front)
                .zip(hem(Covered::Back))
                .map(<[Hem; 2]>::from),
            front: half(Covered::Front)?,
            back: half(Covered::Back)?,
            outlines: pattern.pieces.iter().map(outline).collect(),
            pattern,
            parts,
        })
    }

    /// Where a point of a piece lies [m]; the right of a pair is given mirrored, as it was drawn.
    pub(crate) fn place(&self, form: &Form<'_>, piece: usize, point: DVec2) -> Option<Vec3> {
        let is_right = point.x < 0.0 && self.has_fold(piece);
        let drawn = if is_right {
            DVec2::new(-point.x, point.y)
        } else {
            point
        };
        let place = match self.parts[piece]? {
            Covered::Front => self.on_trunk(form, (piece, Face::Front), drawn),
            Covered::Back => self.on_trunk(form, (piece, Face::Back), drawn),
            Covered::Sleeve => Some(self.on_arm(form, piece, point)),
            Covered::Ruffle => self.below_hem(form, piece, point),
            Covered::Wrap => None,
        }?;
        Some(if is_right { mirrored(place) } else { place })
    }

    fn has_fold(&self, piece: usize) -> bool {
        let edges = &self.pattern.pieces[piece].edges;
        edges.iter().any(|edge| edge.finish == Finish::Fold)
    }

    /// Least and largest `x` of a piece at a level.
    fn across(&self, piece: usize, y: f64) -> Option<[f64; 2]> {
        let outline = &self.outlines[piece];
        let next = outline.iter().cycle().skip(1);
        let crossings = outline.iter().zip(next).filter_map(|(a, b)| {
            let is_crossed = (a.y <= y) != (b.y <= y);
            is_crossed.then(|| a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x))
        });
        let span = crossings.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| {
            [low.min(x), high.max(x)]
        });
        (span[0] <= span[1]).then_some(span)
    }

    /// The same at the nearest level that the piece has.
    fn across_near(&self, piece: usize, y: f64) -> [f64; 2] {
        let outline = &self.outlines[piece];
        let low = outline.iter().fold(f64::INFINITY, |low, p| low.min(p.y)) + 1.0e-4;
        let high = outline
            .iter()
            .fold(f64::NEG_INFINITY, |high, p| high.max(p.y))
            - 1.0e-4;
        self.across(piece, y.clamp(low, high.max(low)))
            .unwrap_or([0.0, 1.0])
    }

    /// Level at which the side seam of a piece ends; below all levels where it has none.
    fn end_of_sides(&self, piece: usize) -> f64 {
        let ends = ends(&self.pattern.pieces[piece], "side");
        ends.map_or(f64::NEG_INFINITY, |[first, last]| first.y.min(last.y))
    }

    /// Cloth around the trunk at a level below the arms [m].
    fn girth(&self, y: f64) -> f64 {
        let faces = [Covered::Front, Covered::Back];
        let widths = faces.map(|face| {
            let pieces = (0..self.parts.len()).filter(|&piece| self.parts[piece] == Some(face));
            let widths = pieces.filter_map(|piece| {
                let [low, high] = self.across(piece, y)?;
                Some(high - low)
            });
            widths.fold(0.0, f64::max)
        });
        2.0 * (widths[0] + widths[1])
    }

    fn half(&self, face: Face) -> &Half {
        match face {
            Face::Front => &self.front,
            Face::Back => &self.back,
        }
    }

    fn on_trunk(
        &self,
        form: &Form<'_>,
        (piece, face): (usize, Face),
        point: DVec2,
    ) -> Option<Vec3> {
        let half = self.half(face);
        // Below the sides a hem is cut round, and cloth hangs down from where it is whole.
        let whole = self.across_near(piece, point.y.max(self.end_of_sides(piece)));
        let width = (whole[1] - whole[0]).max(1.0e-3);
        let [low, _] = self.across_near(piece, point.y);
        let up = (point.y - half.underarm) / (half.tip - half.underarm).max(1.0e-3);
        let reach = if up <= 0.0 {
            1.0
        } else if up < 0.5 {
            1.0 + (FOLD_OF_ARM - 1.0) * smooth(2.0 * up)
        } else if up < 1.0 {
            FOLD_OF_ARM + (SHOULDER_POINT - FOLD_OF_ARM) * smooth(2.0 * up - 1.0)
        } else {
            1.0
        };
        let share = ((point.x - low) / width).clamp(-0.2, 1.2) * reach;
        let height = narrow(half.levels.height(point.y));
        let (place, outward) = form.on_trunk(height, face, narrow(share))?;
        let below = point.y.min(half.underarm).max(self.end_of_sides(piece));
        let girth = form.girth(narrow(half.levels.height(below)));
        let excess = (narrow(self.girth(below)) - girth) / std::f32::consts::TAU;
        let wide = excess.clamp(CLOSE, FARTHEST + FLARING * narrow(half.underarm - below));
        let up = narrow(up.clamp(0.0, 1.0));
        let room = girth + std::f32::consts::TAU * wide;
        let top = self.outlines[piece]
            .iter()
            .fold(f64::NEG_INFINITY, |top, p| top.max(p.y));
        let begun = (narrow(top - point.y) / FOLD_BEGINS).clamp(0.0, 1.0) * (1.0 - up);
        let fullness = narrow(self.girth(below)) / room.max(1.0e-3);
        let fold = begun * folds(fullness, narrow(width), narrow((point.x - low) / width));
        let gap = wide + (CLOSE - wide) * up + fold;
        let lift = Vec3::Y * (OVER_SHOULDER * up * up);
        Some(on_floor(place + outward * gap + lift, outward))
    }

    /// Around the left arm: the crown lies at the shoulder point, the seam below the arm.
    fn on_arm(&self, form: &Form<'_>, piece: usize, point: DVec2) -> Vec3 {
        let outline = &self.outlines[piece];
        let crown = outline
            .iter()
            .fold(f64::NEG_INFINITY, |high, p| high.max(p.y));
        let [back, front] = {
            let [low, high] = self.across_near(piece, point.y.min(0.0));
            [high, -low]
        };
        let half = if 0.0 < point.x { back } else { front };
        let turn = narrow((point.x / half.max(1.0e-3)).clamp(-1.0, 1.0));
        let radius = narrow(back + front) / std::f32::consts::TAU;
        let along = narrow(crown - point.y) - OVER_SHOULDER;
        let [center, over, forward] = form.in_arm(along);
        let (sin, cos) = trig::sin_cos(turn * std::f32::consts::PI);
        center + (over * cos - forward * sin) * radius
    }

    /// A ruffle gathered to the hem, hanging down from where that lies, in gathers of its own: `x` runs
    /// from the middle of the front over her left to the middle of the back.
    fn below_hem(&self, form: &Form<'_>, piece: usize, point: DVec2) -> Option<Vec3> {
        let outline = &self.outlines[piece];
        let [width, top] = outline.iter().fold([0.0_f64; 2], |[width, top], p| {
            [width.max(p.x), top.max(p.y)]
        });
        let hems = self.hems.as_ref()?;
        let length = hems[0].length() + hems[1].length();
        let along = point.x / width.max(1.0e-3) * length;
        let at = |along: f64| self.on_hem(form, hems, along);
        let tangent = (at(along + HEM_STEP)? - at(along - HEM_STEP)?).with_y(0.0);
        let outward = Vec3::Y.cross(tangent).normalize_or_zero();
        let below = narrow(top - point.y);
        let begun = (below / FOLD_BEGINS).clamp(0.0, 1.0);
        let turn = narrow(point.x / width.max(1.0e-3));
        let [_, out] = waves(narrow(width / length), narrow(width), (GATHER, turn));
        Some(at(along)? + outward * (begun * out) - Vec3::Y * below)
    }

    /// Where the hem of front and back lies, so far from the middle of the front over her left [m].
    fn on_hem(&self, form: &Form<'_>, [front, back]: &[Hem; 2], along: f64) -> Option<Vec3> {
        let whole = front.length() + back.length();
        let is_right = !(0.0..=whole).contains(&along);
        let along = if along < 0.0 {
            -along
        } else if whole < along {
            2.0 * whole - along
        } else {
            along
        };
        let (hem, face, along) = if along < front.length() {
            (front, Face::Front, along)
        } else {
            (back, Face::Back, whole - along)
        };
        let place = self.on_trunk(form, (hem.piece, face), hem.at(along))?;
        Some(if is_right { mirrored(place) } else { place })
    }
}

/// A lower edge, from the middle of the body to her side.
#[derive(Debug, Clone)]
struct Hem {
    piece: usize,
    points: Vec<DVec2>,
}

impl Hem {
    /// The hem of the lowest of these pieces.
    fn lowest<'a>(pieces: impl Iterator<Item = (usize, &'a Piece)>) -> Option<Self> {
        let hems = pieces.filter_map(|(piece, drawn)| {
            let edge = drawn.edge("hem")?;
            let mut points: Vec<DVec2> = edge.segments.iter().flat_map(points_of).collect();
            points.push(ends(drawn, "hem")?[1]);
            if points.last()?.x < points.first()?.x {
                points.reverse();
            }
            Some(Self { piece, points })
        });
        hems.min_by(|a, b| a.points[0].y.total_cmp(&b.points[0].y))
    }

    fn length(&self) -> f64 {
        self.points
            .windows(2)
            .map(|ends| ends[0].distance(ends[1]))
            .sum()
    }

    /// The point so far from the middle [m]; an end where that is beyond it.
    fn at(&self, along: f64) -> DVec2 {
        let mut left = along.max(0.0);
        for ends in self.points.windows(2) {
            let length = ends[0].distance(ends[1]);
            if left < length {
                return ends[0].lerp(ends[1], left / length);
            }
            left -= length;
        }
        self.points[self.points.len() - 1]
    }
}

/// The way along a hem is read over this [m].
const HEM_STEP: f64 = 0.01;

/// What would hang deeper than the floor lies on it, drawn out from under her: a train behind her, spread
/// no more than it is cut.
fn on_floor(place: Vec3, outward: Vec3) -> Vec3 {
    let deeper = FLOOR_GAP - place.y;
    if deeper <= 0.0 {
        return place;
    }
    let away = if outward.z < 0.0 { -Vec3::Z } else { Vec3::Z };
    let way = Vec3::new(SPREADING * outward.x, 0.0, away.z).normalize_or_zero();
    Vec3::new(place.x, FLOOR_GAP, place.z) + way * deeper
}

/// How far cloth stands out in folds [m], at a share of its `width` [m]: `fullness` is its length over the
/// room there is.
pub(crate) fn folds(fullness: f32, width: f32, share: f32) -> f32 {
    if fullness <= 1.0 {
        return 0.0;
    }
    let [middle, out] = waves(fullness, width, (FOLD, share));
    middle + out
}

/// Depth of waves of so much cloth each [m], and how far cloth stands out of their middle at a share of its
/// width [m].
fn waves(fullness: f32, width: f32, (cloth, share): (f32, f32)) -> [f32; 2] {
    let count = (width / cloth).round().max(1.0);
    let depth = wave::depth(width / (count * fullness), fullness);
    [
        depth,
        -depth * trig::cos(std::f32::consts::TAU * count * share),
    ]
}

fn smooth(share: f64) -> f64 {
    share * share * (3.0 - 2.0 * share)
}

/// The other side of the dancer.
pub(crate) fn mirrored(place: Vec3) -> Vec3 {
    Vec3::new(-place.x, place.y, place.z)
}
