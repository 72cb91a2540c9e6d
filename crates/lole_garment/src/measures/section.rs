//! Plane cuts of the skin, and taut tapes along them.

use glam::{Vec2, Vec3};
use lole_body::{Bone, SkinnedMesh};

/// A plane with two directions in it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Plane {
    origin: Vec3,
    normal: Vec3,
    first: Vec3,
    second: Vec3,
}

impl Plane {
    /// Across a limb.
    pub(super) fn across(origin: Vec3, normal: Vec3) -> Self {
        let first = normal.any_orthonormal_vector();
        Self {
            origin,
            normal,
            first,
            second: normal.cross(first),
        }
    }

    /// Upright and facing the side, `x` from the middle: points are `(z, y)`.
    pub(super) const fn upright(x: f32) -> Self {
        Self {
            origin: Vec3::new(x, 0.0, 0.0),
            normal: Vec3::X,
            first: Vec3::Z,
            second: Vec3::Y,
        }
    }
}

/// The closed surface of a body.
pub(super) struct Skin {
    positions: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
    /// Whether a vertex is carried by the head most.
    of_head: Vec<bool>,
    /// Whether a vertex is carried by the left arm, below its joint, more than by all else.
    of_left_arm: Vec<bool>,
}

impl Skin {
    pub(super) fn new(skin: &SkinnedMesh) -> Self {
        let is_head = |joints: &[u16; 4]| usize::from(joints[0]) == Bone::Head.index();
        let arm = Bone::LeftUpperArm.index()..=Bone::LeftLittleDistal.index();
        let of_left_arm = skin
            .joints
            .iter()
            .zip(&skin.weights)
            .map(|(joints, weights)| {
                let shares = joints.iter().zip(weights);
                let of_arm = shares.filter(|(joint, _)| arm.contains(&usize::from(**joint)));
                0.5 < of_arm.map(|(_, weight)| weight).sum::<f32>()
            });
        Self {
            positions: skin.positions.clone(),
            triangles: skin.body_triangles(),
            of_head: skin.joints.iter().map(is_head).collect(),
            of_left_arm: of_left_arm.collect(),
        }
    }

    /// Points where a plane cuts the skin of the left arm.
    pub(super) fn cut_left_arm(&self, plane: &Plane) -> Vec<Vec2> {
        let of_arm = |triangle: &&[u32; 3]| {
            let mut corners = triangle.iter();
            corners.all(|&vertex| self.of_left_arm[vertex as usize])
        };
        self.cut_of(self.triangles.iter().filter(of_arm), plane, |_| true)
    }

    /// Points where a plane cuts the skin's edges, those that are `wanted`, in the plane.
    pub(super) fn cut(&self, plane: &Plane, wanted: impl Fn(Vec3) -> bool) -> Vec<Vec2> {
        self.cut_of(self.triangles.iter(), plane, wanted)
    }

    fn cut_of<'a>(
        &self,
        triangles: impl Iterator<Item = &'a [u32; 3]>,
        plane: &Plane,
        wanted: impl Fn(Vec3) -> bool,
    ) -> Vec<Vec2> {
        let over = |vertex: u32| {
            let place = self.positions[vertex as usize];
            (place, (place - plane.origin).dot(plane.normal))
        };
        let mut points = Vec::new();
        for &[a, b, c] in triangles {
            for (from, to) in [(a, b), (b, c), (c, a)] {
                let ((from, before), (to, after)) = (over(from), over(to));
                if (before < 0.0) == (after < 0.0) {
                    continue;
                }
                let place = from.lerp(to, before / (before - after));
                if wanted(place) {
                    let out = place - plane.origin;
                    points.push(Vec2::new(out.dot(plane.first), out.dot(plane.second)));
                }
            }
        }
        points
    }

    /// Height of the highest skin over a point of the floor that is not the head's and lies below
    /// `ceiling`.
    pub(super) fn height_over(&self, x: f32, z: f32, ceiling: f32) -> Option<f32> {
        let at = Vec2::new(x, z);
        let mut highest: Option<f32> = None;
        for triangle in &self.triangles {
            if triangle.iter().all(|&vertex| self.of_head[vertex as usize]) {
                continue;
            }
            let corners = triangle.map(|vertex| self.positions[vertex as usize]);
            let flat = corners.map(|corner| Vec2::new(corner.x, corner.z) - at);
            let shares = [
                flat[1].perp_dot(flat[2]),
                flat[2].perp_dot(flat[0]),
                flat[0].perp_dot(flat[1]),
            ];
            let sum: f32 = shares.iter().sum();
            if sum.abs() < 1.0e-12 || shares.iter().any(|share| share * sum < 0.0) {
                continue;
            }
            let heights = corners.iter().zip(shares);
            let height = heights.map(|(corner, share)| corner.y * share).sum::<f32>() / sum;
            if height < ceiling && highest.is_none_or(|found| found < height) {
                highest = Some(height);
            }
        }
        highest
    }
}

/// Length of the convex hull of points, by its two monotone chains.
pub(super) fn hull_length(mut points: Vec<Vec2>) -> f32 {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    let forth = chain(points.iter().copied());
    let back = chain(points.iter().rev().copied());
    way(&forth) + way(&back)
}

/// Length of a tape that is drawn taut over points `(z, y)` on the side of `towards` (1 in front, -1 at
/// the back), from one height up to another; it ends upright where points end before.
pub(super) fn taut(mut points: Vec<Vec2>, towards: f32, [low, high]: [f32; 2]) -> f32 {
    points.sort_by(|a, b| a.y.total_cmp(&b.y).then(a.x.total_cmp(&b.x)));
    let (Some(first), Some(last)) = (points.first().copied(), points.last().copied()) else {
        return high - low;
    };
    // Up along the side of +x is counter-clockwise, down along that of -x.
    let hull = if 0.0 < towards {
        chain(points.into_iter())
    } else {
        chain(points.into_iter().rev())
    };
    way(&hull) + (first.y - low).max(0.0) + (high - last.y).max(0.0)
}

/// The half of a convex hull that turns left, of points in order.
fn chain(points: impl Iterator<Item = Vec2>) -> Vec<Vec2> {
    let mut chain: Vec<Vec2> = Vec::new();
    for point in points {
        while let [.., a, b] = chain[..]
            && (b - a).perp_dot(point - b) <= 0.0
        {
            chain.pop();
        }
        chain.push(point);
    }
    chain
}

fn way(points: &[Vec2]) -> f32 {
    let pairs = points.windows(2);
    pairs.map(|pair| pair[0].distance(pair[1])).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tape_is_taut_over_the_side_it_is_laid_on() {
        // A diamond: over either side the way from foot to top is twice a half diagonal.
        let points = || {
            [(0.0, 0.0), (1.0, 1.0), (-2.0, 1.0), (0.0, 2.0), (0.2, 1.0)]
                .map(|(x, y)| Vec2::new(x, y))
                .to_vec()
        };
        let front = taut(points(), 1.0, [0.0, 2.0]);
        let back = taut(points(), -1.0, [-0.5, 2.0]);
        assert!((front - 2.0 * 2.0_f32.sqrt()).abs() < 1e-6, "{front}");
        assert!((back - 2.0 * 5.0_f32.sqrt() - 0.5).abs() < 1e-6, "{back}");
        let girth = hull_length(points());
        assert!(
            (girth - front - 2.0 * 5.0_f32.sqrt()).abs() < 1e-6,
            "{girth}"
        );
    }
}
