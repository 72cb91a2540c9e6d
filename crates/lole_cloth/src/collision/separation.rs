//! A plane that kept an edge and a triangle apart, and how they are brought back to their sides.

use glam::{DVec3, Vec3};

/// Nearer than this [m] an edge and a triangle have no plane between them.
const DEGENERATE_DISTANCE: f64 = 1.0e-10;

/// An edge and a triangle, with the normal of a plane that parted them at the start of the step.
///
/// Both are convex, so as long as the ends of the edge lie beyond the corners of the triangle along
/// that normal, they cannot cross; how they move along the plane is free.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Separation {
    pub(crate) ends: [u32; 2],
    pub(crate) corners: [u32; 3],
    /// Unit vector from the triangle to the edge.
    pub(crate) normal: Vec3,
}

impl Separation {
    /// The plane between `ends` and `corners` at `positions`; `None` where they touch.
    pub(crate) fn between(ends: [u32; 2], corners: [u32; 3], positions: &[Vec3]) -> Option<Self> {
        let segment = ends.map(|end| positions[end as usize].as_dvec3());
        let triangle = corners.map(|corner| positions[corner as usize].as_dvec3());
        let gap = gap(segment, triangle);
        let distance = gap.length();
        (DEGENERATE_DISTANCE < distance).then(|| Self {
            ends,
            corners,
            normal: (gap / distance).as_vec3(),
        })
    }

    /// How far `ends` and `corners` are apart at `positions` [m].
    pub(crate) fn distance(ends: [u32; 2], corners: [u32; 3], positions: &[Vec3]) -> f32 {
        let segment = ends.map(|end| positions[end as usize].as_dvec3());
        let triangle = corners.map(|corner| positions[corner as usize].as_dvec3());
        gap(segment, triangle).as_vec3().length()
    }

    /// The end that lies lowest along the normal, the corner that lies highest, and by how much the
    /// end is above the corner [m].
    pub(crate) fn closest(&self, positions: &[Vec3]) -> (u32, u32, f32) {
        let along = |particle: u32| positions[particle as usize].dot(self.normal);
        let [one, other] = self.ends.map(along);
        let (end, low) = if other < one {
            (self.ends[1], other)
        } else {
            (self.ends[0], one)
        };
        let (mut corner, mut high) = (self.corners[0], along(self.corners[0]));
        for &candidate in &self.corners[1..] {
            let height = along(candidate);
            if high < height {
                (corner, high) = (candidate, height);
            }
        }
        (end, corner, low - high)
    }
}

/// From the nearest point of a triangle to that of a segment, which do not cross.
///
/// In `f64`: folds come nearer to each other than `f32` has bits for a direction between them.
fn gap(segment: [DVec3; 2], triangle: [DVec3; 3]) -> DVec3 {
    let mut nearest = DVec3::INFINITY;
    let mut consider = |gap: DVec3| {
        if gap.length_squared() < nearest.length_squared() {
            nearest = gap;
        }
    };
    for side in 0..3 {
        consider(segment_gap(
            [triangle[side], triangle[(side + 1) % 3]],
            segment,
        ));
    }
    for end in segment {
        if let Some(gap) = face_gap(end, triangle) {
            consider(gap);
        }
    }
    nearest
}

/// From the foot of a point on the plane of a triangle to the point, where the foot lies inside.
fn face_gap(point: DVec3, [a, b, c]: [DVec3; 3]) -> Option<DVec3> {
    let normal = (b - a).cross(c - a);
    let squared = normal.length_squared();
    let is_inside = |from: DVec3, to: DVec3| 0.0 <= (to - from).cross(point - from).dot(normal);
    (0.0 < squared && is_inside(a, b) && is_inside(b, c) && is_inside(c, a))
        .then(|| normal * ((point - a).dot(normal) / squared))
}

/// From the nearest point of the first segment to that of the second (Ericson, "Real-Time
/// Collision Detection", section 5.1.9).
fn segment_gap([a, b]: [DVec3; 2], [c, d]: [DVec3; 2]) -> DVec3 {
    let (one, other, from) = (b - a, d - c, a - c);
    let (squared_one, squared_other) = (one.length_squared(), other.length_squared());
    let (along_one, along_other, across) = (one.dot(from), other.dot(from), one.dot(other));
    let share = |part: f64, whole: f64| {
        if 0.0 < whole {
            (part / whole).clamp(0.0, 1.0)
        } else {
            0.0
        }
    };
    let mut s = share(
        across * along_other - along_one * squared_other,
        squared_one * squared_other - across * across,
    );
    let reach = across * s + along_other;
    let t = share(reach, squared_other);
    if reach < 0.0 {
        s = share(-along_one, squared_one);
    } else if squared_other < reach {
        s = share(across - along_one, squared_one);
    }
    (c + other * t) - (a + one * s)
}
