//! How the panels of a file lie around its body: which cover an arm, and how much cloth goes around the trunk at
//! each level.

use glam::{DVec2, DVec3};
use kurbo::ParamCurve as _;
use lole_geom::trig64;

use super::{Given, Origin};

/// Points along each segment of an edge, from which widths are taken.
const FINE: u32 = 24;
/// Panels whose middle is farther from the plane between left and right than this, and above the waist, cover an
/// arm [m].
const BESIDE: f64 = 0.25;
/// Height of the waist of the formats' bodies, by where places are counted from [m]: 1.05 m above the floor on the
/// mean woman of `GarmentCode`, 5 cm below where the older generator counts from.
const WAISTS: [f64; 2] = [1.03, -0.05];
/// Panels that look the same way within this angle lie beside each other [rad].
const SAME_WAY: f64 = 0.27;
/// The upper edge of what is worn from a band ends within this of its highest level, and is held there [m].
pub(crate) const NEAR_TOP: f64 = 0.035;
/// A seam over the shoulder lies within this of the highest level [m].
const SHOULDER: f64 = 0.12;
/// A panel that lies flatter than this looks where it is: a cosine.
const FLAT: f64 = 0.3;

/// What a panel covers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Part {
    /// The trunk or the legs, with the panels of this side.
    Trunk(usize),
    /// An arm.
    Arm(Arm),
}

/// An arm, and whether a panel lies in front of it or behind it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Arm {
    pub(crate) is_left: bool,
    pub(crate) is_front: bool,
}

/// A panel of a file around its body.
#[derive(Debug, Clone)]
pub(crate) struct Lying {
    pub(crate) part: Part,
    /// Its border in the body's space [m].
    pub(crate) border: Vec<DVec3>,
}

/// A side of the trunk that panels look out from.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Side {
    /// From the front over her left [rad].
    pub(crate) turn: f64,
    /// Horizontal way along it, to her left in front.
    pub(crate) along: DVec2,
}

/// All panels of a file around its body.
#[derive(Debug, Clone)]
pub(crate) struct Around {
    pub(crate) panels: Vec<Lying>,
    pub(crate) sides: Vec<Side>,
}

/// Horizontal components, to her left and to her front.
fn flat(place: DVec3) -> DVec2 {
    DVec2::new(place.x, place.z)
}

/// Least angle between two directions [rad].
fn between(a: f64, b: f64) -> f64 {
    let turned = (a - b).rem_euclid(std::f64::consts::TAU);
    turned.min(std::f64::consts::TAU - turned)
}

impl Around {
    pub(crate) fn new(given: &Given) -> Self {
        let waist = WAISTS[usize::from(given.origin == Origin::Trunk)];
        let mut around = Self {
            panels: Vec::new(),
            sides: Vec::new(),
        };
        for (panel, piece) in given.panels.iter().zip(&given.pattern.pieces) {
            let segments = piece.edges.iter().flat_map(|edge| &edge.segments);
            let points = segments.flat_map(|segment| {
                let steps = (0..FINE).map(|step| f64::from(step) / f64::from(FINE));
                steps.map(|t| segment.eval(t))
            });
            let border: Vec<DVec3> = points
                .map(|point| panel.place(DVec2::new(point.x, point.y)))
                .collect();
            let middle = border.iter().sum::<DVec3>() / border.len().max(1) as f64;
            let part = if BESIDE < middle.x.abs() && waist < middle.y {
                Part::Arm(Arm {
                    is_left: 0.0 < middle.x,
                    is_front: 0.0 <= middle.z,
                })
            } else {
                Part::Trunk(around.side(panel.outward, middle))
            };
            around.panels.push(Lying { part, border });
        }
        around
    }

    /// The side that a panel looks out from, new where there is none like it.
    fn side(&mut self, outward: DVec3, middle: DVec3) -> usize {
        let out = if FLAT < flat(outward).length() {
            flat(outward)
        } else {
            flat(middle)
        };
        let turn = trig64::atan2(out.x, out.y);
        let found = (self.sides.iter()).position(|side| between(side.turn, turn) < SAME_WAY);
        found.unwrap_or_else(|| {
            let (sin, cos) = trig64::sin_cos(turn);
            let along = DVec2::new(cos, -sin);
            self.sides.push(Side { turn, along });
            self.sides.len() - 1
        })
    }

    /// Where a place of the file's body lies along a side of the trunk [m].
    pub(crate) fn along(&self, side: usize, place: DVec3) -> f64 {
        self.sides[side].along.dot(flat(place))
    }

    /// From where to where the cloth of a side reaches at a level of the file's body [m].
    pub(crate) fn span(&self, side: usize, level: f64) -> Option<[f64; 2]> {
        let own = (self.panels.iter()).filter(|panel| panel.part == Part::Trunk(side));
        let mut span = [f64::INFINITY, f64::NEG_INFINITY];
        for panel in own {
            let next = panel.border.iter().cycle().skip(1);
            for (a, b) in panel.border.iter().zip(next) {
                if (a.y <= level) == (b.y <= level) {
                    continue;
                }
                let place = a.lerp(*b, (level - a.y) / (b.y - a.y));
                let along = self.along(side, place);
                span = [span[0].min(along), span[1].max(along)];
            }
        }
        (span[0] <= span[1]).then_some(span)
    }

    /// Cloth around the trunk at a level of the file's body [m]; `None` where it does not go around.
    pub(crate) fn girth(&self, level: f64) -> Option<f64> {
        let (mut girth, mut faces) = (0.0, [false; 2]);
        for side in 0..self.sides.len() {
            if let Some([from, to]) = self.span(side, level) {
                girth += to - from;
                let cos = trig64::cos(self.sides[side].turn);
                faces = [faces[0] || 0.3 < cos, faces[1] || cos < -0.3];
            }
        }
        (faces == [true; 2]).then_some(girth)
    }

    /// Length of the edges on the trunk that end at the highest level and that nothing is sewn to [m]; `None`
    /// where there are none.
    pub(crate) fn upper_edge(&self, given: &Given, top: f64) -> Option<f64> {
        let mut length = 0.0;
        for (place, piece) in given.pattern.pieces.iter().enumerate() {
            for (number, edge) in piece.edges.iter().enumerate() {
                let is_free = given.sewn_to(place, number).is_none();
                let levels = self.levels_of(given, (place, number));
                let is_upper = levels.is_some_and(|[low, _]| top - NEAR_TOP < low);
                if is_free && is_upper {
                    length += edge.length();
                }
            }
        }
        (0.0 < length).then_some(length)
    }

    /// The highest level at which panels of two sides are sewn together beside her, and not over a shoulder; that
    /// of all cloth where they are nowhere.
    pub(crate) fn end_of_sides(&self, given: &Given, top: f64) -> f64 {
        let mut end = f64::NEG_INFINITY;
        for seam in &given.pattern.seams {
            let [one, other] = [seam.flat, seam.full].map(|side| self.panels[side.piece].part);
            let (Part::Trunk(first), Part::Trunk(second)) = (one, other) else {
                continue;
            };
            let levels = self.levels_of(given, (seam.flat.piece, seam.flat.edge));
            let Some([low, high]) = levels.filter(|_| first != second) else {
                continue;
            };
            if 0.5 * (low + high) < top - SHOULDER {
                end = end.max(high);
            }
        }
        if end.is_finite() { end } else { top }
    }

    /// Lower and higher level of the ends of an edge on the trunk [m]; `None` of another.
    fn levels_of(&self, given: &Given, (piece, edge): (usize, usize)) -> Option<[f64; 2]> {
        let is_on_trunk = matches!(self.panels[piece].part, Part::Trunk(_));
        let ends = given.pattern.pieces[piece].edges[edge].ends();
        let [from, to] = ends.map(|end| given.panels[piece].place(DVec2::new(end.x, end.y)).y);
        is_on_trunk.then(|| [from.min(to), from.max(to)])
    }

    /// Lowest and highest level of the cloth on the trunk [m]; `None` where there is none.
    pub(crate) fn levels(&self) -> Option<[f64; 2]> {
        let own = (self.panels.iter()).filter(|panel| matches!(panel.part, Part::Trunk(_)));
        let levels = own.flat_map(|panel| panel.border.iter().map(|place| place.y));
        let span = levels.fold([f64::INFINITY, f64::NEG_INFINITY], |span, level| {
            [span[0].min(level), span[1].max(level)]
        });
        (span[0] < span[1]).then_some(span)
    }
}
