//! The finished dancer measured as a tape measures: convex girths of the drawn surface, cut by
//! itself and not by what built it.

use std::collections::BTreeMap;

use glam::DVec2;
use lole_geom::Length;

use crate::given::Tapes;
use crate::{Bone, Dancer, Figure, Measure, Tape};

/// From the shoulder joint out to the shoulder point [m] at a stature of 158.5 cm.
const SHOULDER_POINT_OUT: f32 = 0.03;
/// From a man's shoulder joint out to his shoulder point [m] at a stature of 171 cm: 40 cm from point
/// to point (AIST), 19.6 cm from the middle to the joint of the measured body.
const SHOULDER_POINT_OUT_OF_MAN: f32 = 0.004;

/// One line of the tape: what was given and what the body has.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Taped {
    /// Which measure.
    pub measure: Measure,
    /// What the tailor wrote down; `None` where it is estimated.
    pub given: Option<Length>,
    /// What the finished surface has.
    pub on_body: Length,
}

impl Dancer {
    /// Every measure of the finished body beside what `tape` gave.
    #[must_use]
    pub fn taped(&self, tape: &Tape) -> [Taped; 14] {
        let triangles = self.skin.body_triangles();
        Measure::ALL.map(|measure| Taped {
            measure,
            given: measure.of(tape),
            on_body: Length::from_m(self.measure(measure, &triangles)),
        })
    }

    /// One measure of the finished body [m].
    fn measure(&self, measure: Measure, triangles: &[[u32; 3]]) -> f64 {
        let levels = &self.landmarks;
        let given = (self.skin.is_given()).then(|| Tapes::new(&self.skeleton, &self.skin));
        // The cuts of a given skin are not closed: its tape runs around all of them.
        let trunk = |height: f32| match &given {
            Some(tapes) => f64::from(tapes.trunk(height)),
            None => self.girth(triangles, height, Loop::Trunk),
        };
        let leg = |height: f32| match &given {
            Some(tapes) => f64::from(tapes.leg(height)),
            None => self.girth(triangles, height, Loop::LeftLeg),
        };
        let points = || {
            let vertices = triangles.iter().flatten();
            vertices.map(|&vertex| self.skin.positions[vertex as usize])
        };
        match measure {
            Measure::Stature => f64::from(points().map(|p| p.y).fold(0.0, f32::max)),
            Measure::Bust => trunk(levels.bust_height),
            Measure::Underbust => trunk(levels.underbust_height),
            Measure::Waist => trunk(levels.waist_height),
            Measure::HighHip => trunk(levels.high_hip_height),
            Measure::Hip => trunk(levels.hip_height),
            Measure::Thigh => leg(levels.thigh_height),
            Measure::Knee => leg(levels.knee_tape_height),
            Measure::Calf => leg(levels.calf_height),
            Measure::Ankle => leg(levels.ankle_tape_height),
            Measure::Inseam if given.is_some() => f64::from(levels.crotch_height),
            Measure::Inseam => {
                let middle = points().filter(|p| p.x == 0.0);
                f64::from(middle.map(|p| p.y).fold(f32::INFINITY, f32::min))
            }
            Measure::WaistHeight => f64::from(levels.waist_height),
            Measure::ShoulderBreadth => {
                let side = |bone| f64::from(self.skeleton.joint(bone).x);
                let joints = side(Bone::LeftUpperArm) - side(Bone::RightUpperArm);
                joints + 2.0 * f64::from(self.shoulder_point_out())
            }
            Measure::UpperArmLength => {
                let joint = self.skeleton.joint(Bone::LeftUpperArm);
                let x = joint.x + self.shoulder_point_out();
                let point = glam::Vec3::new(x, self.skin_above(triangles, x, joint.z), joint.z);
                f64::from(point.distance(self.skeleton.joint(Bone::LeftLowerArm)))
            }
        }
    }

    fn shoulder_point_out(&self) -> f32 {
        shoulder_point_out(self.measurements.figure, self.landmarks.crown_height)
    }

    /// Height of the highest skin over a point of the floor [m].
    fn skin_above(&self, triangles: &[[u32; 3]], x: f32, z: f32) -> f32 {
        // A large head of an avatar reaches over its shoulders.
        let is_head = |vertex: u32| {
            let joint = self.skin.joints[vertex as usize][0];
            usize::from(joint) == Bone::Head.index()
        };
        let shoulders = triangles.iter().copied();
        let shoulders = shoulders.filter(|&[a, b, c]| !(is_head(a) && is_head(b) && is_head(c)));
        highest_above(&self.skin.positions, shoulders, x, z)
    }

    /// Convex girth [m] of what is cut at `height` of the trunk or of the left leg; 0 where there
    /// is nothing.
    fn girth(&self, triangles: &[[u32; 3]], height: f32, wanted: Loop) -> f64 {
        let loops = cut_loops(&self.skin.positions, triangles, f64::from(height));
        match wanted {
            // The surface is mirrored, and a cut may fall apart into its halves.
            Loop::Trunk => {
                let touches_middle =
                    |points: &Vec<DVec2>| points.iter().any(|point| point.x.abs() < SEAM);
                let of_trunk = loops.into_iter().filter(touches_middle);
                hull_length(of_trunk.flatten().collect())
            }
            Loop::LeftLeg => {
                let is_left = |points: &Vec<DVec2>| {
                    let sum: f64 = points.iter().map(|point| point.x).sum();
                    0.01 < sum / points.len().max(1) as f64
                };
                let girths = loops.into_iter().filter(is_left).map(hull_length);
                girths.fold(0.0, f64::max)
            }
        }
    }
}

/// How far outside the shoulder joint the shoulder point lies [m].
pub(crate) fn shoulder_point_out(figure: Figure, stature: f32) -> f32 {
    let out = match figure {
        Figure::Man => SHOULDER_POINT_OUT_OF_MAN,
        Figure::OfStature | Figure::Woman | Figure::Child => SHOULDER_POINT_OUT,
    };
    out * stature / 1.585
}

/// Height of the highest triangle over a point of the floor; 0 where there is none.
pub(crate) fn highest_above(
    positions: &[glam::Vec3],
    triangles: impl Iterator<Item = [u32; 3]>,
    x: f32,
    z: f32,
) -> f32 {
    let mut highest = 0.0_f32;
    let at = glam::Vec2::new(x, z);
    for triangle in triangles {
        let [a, b, c] = triangle.map(|vertex| positions[vertex as usize]);
        let flat = [a, b, c].map(|p| glam::Vec2::new(p.x, p.z) - at);
        let shares = [
            flat[1].perp_dot(flat[2]),
            flat[2].perp_dot(flat[0]),
            flat[0].perp_dot(flat[1]),
        ];
        let sum: f32 = shares.iter().sum();
        let inside = shares.iter().all(|share| share * sum >= 0.0);
        if inside && sum.abs() > 1.0e-12 {
            let height = (shares[0] * a.y + shares[1] * b.y + shares[2] * c.y) / sum;
            highest = highest.max(height);
        }
    }
    highest
}

/// A cut that comes nearer than this to the middle plane [m] is of the trunk.
const SEAM: f64 = 0.001;

/// Which closed cut is measured.
#[derive(Debug, Clone, Copy)]
enum Loop {
    Trunk,
    LeftLeg,
}

/// The closed cuts of a mesh by the plane `y = height`, each as its points `(x, z)` [m]: cut edges
/// that share a triangle belong together.
fn cut_loops(positions: &[glam::Vec3], triangles: &[[u32; 3]], height: f64) -> Vec<Vec<DVec2>> {
    let is_under = |vertex: u32| f64::from(positions[vertex as usize].y) < height;
    let mut index_of = BTreeMap::new();
    let mut points: Vec<DVec2> = Vec::new();
    let mut parent: Vec<usize> = Vec::new();
    for &[a, b, c] in triangles {
        let mut first = None;
        for (u, v) in [(a, b), (b, c), (c, a)] {
            if is_under(u) == is_under(v) {
                continue;
            }
            let (u, v) = (u.min(v), u.max(v));
            let index = *index_of.entry((u, v)).or_insert_with(|| {
                let [from, to] = [u, v].map(|vertex| positions[vertex as usize].as_dvec3());
                let point = from.lerp(to, (height - from.y) / (to.y - from.y));
                points.push(DVec2::new(point.x, point.z));
                parent.push(parent.len());
                parent.len() - 1
            });
            match first {
                None => first = Some(index),
                Some(other) => {
                    let [from, to] = [root(&mut parent, other), root(&mut parent, index)];
                    parent[from] = to;
                }
            }
        }
    }
    let mut loops: BTreeMap<usize, Vec<DVec2>> = BTreeMap::new();
    for (index, &point) in points.iter().enumerate() {
        loops
            .entry(root(&mut parent, index))
            .or_default()
            .push(point);
    }
    loops.into_values().collect()
}

/// The representative of a set, with the way to it shortened.
fn root(parent: &mut [usize], mut index: usize) -> usize {
    while parent[index] != index {
        parent[index] = parent[parent[index]];
        index = parent[index];
    }
    index
}

/// Length of the convex hull of points, by its two monotone chains.
fn hull_length(mut points: Vec<DVec2>) -> f64 {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    let chain = |points: &mut dyn Iterator<Item = DVec2>| {
        let mut chain: Vec<DVec2> = Vec::new();
        for point in points {
            while let [.., a, b] = chain[..]
                && (b - a).perp_dot(point - b) <= 0.0
            {
                chain.pop();
            }
            chain.push(point);
        }
        let pairs = chain.windows(2);
        pairs.map(|pair| pair[0].distance(pair[1])).sum::<f64>()
    };
    chain(&mut points.iter().copied()) + chain(&mut points.iter().rev().copied())
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::*;

    /// An upright tube of `count` sides around `(x, 0)`, open at both ends.
    fn tube(x: f32, radius: f32, count: u32) -> (Vec<Vec3>, Vec<[u32; 3]>) {
        let mut positions = Vec::new();
        let mut triangles = Vec::new();
        for side in 0..count {
            let angle = std::f32::consts::TAU * side as f32 / count as f32;
            let (sin, cos) = lole_geom::trig::sin_cos(angle);
            for y in [0.0, 1.0] {
                positions.push(Vec3::new(x + radius * cos, y, radius * sin));
            }
            let [a, b] = [2 * side, 2 * ((side + 1) % count)];
            triangles.extend([[a, a + 1, b], [b, a + 1, b + 1]]);
        }
        (positions, triangles)
    }

    #[test]
    fn the_girth_of_a_tube_is_its_circumference() {
        let (positions, triangles) = tube(0.0, 0.1, 720);
        let loops = cut_loops(&positions, &triangles, 0.4);
        assert_eq!(loops.len(), 1);
        let girth = hull_length(loops[0].clone());
        assert!(
            (girth - std::f64::consts::TAU * 0.1).abs() < 1e-5,
            "{girth}"
        );
    }

    #[test]
    fn two_tubes_are_two_loops() {
        let (mut positions, mut triangles) = tube(-0.2, 0.1, 60);
        let (others, more) = tube(0.2, 0.05, 60);
        triangles.extend(more.iter().map(|t| t.map(|vertex| vertex + 120)));
        positions.extend(others);
        let loops = cut_loops(&positions, &triangles, 0.5);
        assert_eq!(loops.len(), 2);
        assert!(hull_length(loops[0].clone()) > hull_length(loops[1].clone()));
    }

    #[test]
    fn the_highest_triangle_over_a_point_is_found() {
        let positions = [
            Vec3::new(0.0, 1.0, 0.0),
            Vec3::new(1.0, 2.0, 0.0),
            Vec3::new(0.0, 1.0, 1.0),
        ];
        let found = highest_above(&positions, std::iter::once([0, 1, 2]), 0.25, 0.25);
        assert!((found - 1.25).abs() < 1e-6, "{found}");
    }
}
