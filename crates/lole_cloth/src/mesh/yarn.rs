//! Yarns on a surface that lies in no plane: where one leads that is laid straight on, over seams too.

use glam::DVec2;
use lole_geom::narrow;

use crate::mesh::rest::Welded;
use crate::mesh::stride::{REACH, SLANT_MAX};
use crate::mesh::topology::Topology;

/// Triangles that a yarn may cross on its way: dozens of times what a stride needs.
const CROSSED_MAX: usize = 256;

/// What lies along a yarn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Partner {
    pub(crate) particle: u32,
    /// The straight way there [m].
    pub(crate) length: f32,
    /// How far that is off the yarn, as a tangent.
    pub(crate) slant: f32,
}

/// The triangles that a yarn crosses, laid into one plane: the particle that it comes from is the origin,
/// and the yarn runs along `yarn`.
struct Strip {
    yarn: DVec2,
    reach: f64,
    /// Nearest bounds of what is seen from the origin without leaving the strip: right and left of the yarn.
    seen: [DVec2; 2],
    best: Option<(f64, Partner)>,
}

/// A surface that lies in no plane.
#[derive(Clone, Copy)]
pub(crate) struct WeldedSurface<'a> {
    pub(crate) topology: &'a Topology,
    pub(crate) welded: &'a Welded,
}

impl WeldedSurface<'_> {
    /// The particle nearest to the yarn about `reach` [m] from another, among those that are seen from there;
    /// `yarn` is a unit vector in every triangle as it lies by itself.
    pub(crate) fn partner(self, from: u32, yarn: DVec2, reach: f64) -> Option<Partner> {
        let Self { topology, welded } = self;
        let leaves = 0..welded.fans[from as usize].len();
        let (place, sides, [right, left]) = leaves.into_iter().find_map(|place| {
            let (sides, [at, right, left]) = welded.leaf(topology, from, place);
            let (right, left) = (right - at, left - at);
            let is_within = 0.0 <= right.perp_dot(yarn) && 0.0 < yarn.perp_dot(left);
            is_within.then_some((place, sides, [right, left]))
        })?;
        let mut strip = Strip {
            yarn,
            reach,
            seen: [right, left],
            best: None,
        };
        strip.meet(sides[0], right);
        strip.meet(sides[1], left);
        let mut triangle = welded.fans[from as usize][place].1;
        let (mut ends, mut edge) = (sides, [right, left]);
        for _ in 0..CROSSED_MAX {
            let Some((next, corner)) = welded.beyond(ends[0], ends[1], triangle) else {
                break;
            };
            let order = [ends[1], ends[0], corner];
            let at = welded.laid_beside(topology, (next, order), [edge[1], edge[0]]);
            strip.meet(corner, at);
            let side = usize::from(0.0 < yarn.perp_dot(at));
            (ends[side], edge[side]) = (corner, at);
            triangle = next;
            if edge
                .iter()
                .all(|end| f64::from(REACH[1]) * reach < end.dot(yarn))
            {
                break;
            }
        }
        strip.best.map(|(_, partner)| partner)
    }
}

impl Strip {
    /// Looks at a corner of the strip.
    fn meet(&mut self, particle: u32, at: DVec2) {
        let [right, left] = self.seen;
        let is_seen = 0.0 <= right.perp_dot(at) && 0.0 <= at.perp_dot(left);
        if !is_seen {
            return;
        }
        self.seen[usize::from(0.0 < self.yarn.perp_dot(at))] = at;
        let (along, off) = (at.dot(self.yarn), self.yarn.perp_dot(at).abs());
        let slant = off / along;
        let share = along / self.reach;
        let [least, most] = REACH.map(f64::from);
        let fits = least <= share && share <= most && slant <= f64::from(SLANT_MAX);
        // Among those on the yarn, what is nearest to the reach.
        let score = slant + 0.02 * (share - 1.0).abs();
        if fits && self.best.is_none_or(|(lowest, _)| score < lowest) {
            let partner = Partner {
                particle,
                length: narrow(at.length()),
                slant: narrow(slant),
            };
            self.best = Some((score, partner));
        }
    }
}
