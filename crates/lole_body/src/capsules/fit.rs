//! Fitting the capsules: alternating assignment and damped Gauss–Newton, left half only.

mod start;

use glam::DVec3;

use super::{BodyCapsule, CapsuleLayout};
use crate::skin_weights::mirrored_bone;
use crate::{Bone, Landmarks, Skeleton, SkinnedMesh};

/// Capsules of the paper's body.
pub(super) const PAPER_COUNT: u32 = 13;
const PASSES: usize = 240;
/// Capsules aim this far outside the skin [m]: inside the band -8..+3 mm of skin against capsule.
const COVER: f64 = 0.0008;
/// A skin point outside its aim weighs up to this many times as much.
const OUTSIDE_WEIGHT: f64 = 10.0;
/// Over this distance [m] from the aim the outside weight grows from 1 to full.
const OUTSIDE_RAMP: f64 = 0.003;
/// Damping of every step against the mean weight of a capsule's points.
const DAMPING: f64 = 0.02;
const LEAST_RADIUS: f64 = 0.02;
/// Unknowns of one capsule: two ends and two radii.
const UNKNOWNS: usize = 8;

/// A capsule of the left half: on the left and mirrored, or lying crosswise through the middle.
#[derive(Debug, Clone, Copy)]
struct Part {
    names: [&'static str; 2],
    bones: [Bone; 2],
    ends: [DVec3; 2],
    radii: [f64; 2],
    is_crosswise: bool,
}

/// A skin point with the area it stands for [m²].
struct Sample {
    point: DVec3,
    area: f64,
}

/// The capsules of a body, top down, left before right.
pub(crate) fn fit_capsules(
    skin: &SkinnedMesh,
    skeleton: &Skeleton,
    landmarks: &Landmarks,
    layout: CapsuleLayout,
) -> Vec<BodyCapsule> {
    let mut parts = match layout {
        CapsuleLayout::Fitted(PAPER_COUNT) => start::of_paper(skeleton, landmarks),
        CapsuleLayout::Fitted(count) => start::by_count(skeleton, landmarks, count),
        CapsuleLayout::TwoCylinders => {
            return start::two_cylinders(skeleton, landmarks).both_sides();
        }
    };
    let mut samples = samples(skin, landmarks);
    if parts.iter().all(|part| part.is_crosswise) {
        // Nothing that could follow the legs: the trunk is covered well instead.
        samples.retain(|sample| sample.point.y > f64::from(landmarks.crotch_height));
    }
    for _ in 0..PASSES {
        improve(&mut parts, &samples);
    }
    parts.iter().flat_map(Part::both_sides).collect()
}

/// Skin of the left half from ankle to waist, without arms and feet.
fn samples(skin: &SkinnedMesh, landmarks: &Landmarks) -> Vec<Sample> {
    let mut areas = vec![0.0_f64; skin.positions.len()];
    for triangle in skin.body_triangles() {
        let [a, b, c] = triangle.map(|vertex| skin.positions[vertex as usize].as_dvec3());
        let area = (b - a).cross(c - a).length() / 6.0;
        for vertex in triangle {
            areas[vertex as usize] += area;
        }
    }
    (0..skin.positions.len())
        .filter(|&vertex| {
            let position = skin.positions[vertex];
            position.x >= 0.0
                && position.y > landmarks.ankle_height
                && position.y < landmarks.waist_height + 0.01
                && is_lower_body(usize::from(skin.joints[vertex][0]))
        })
        .map(|vertex| Sample {
            point: skin.positions[vertex].as_dvec3(),
            area: areas[vertex],
        })
        .collect()
}

/// Trunk, thigh or shank, by the bone that carries a point most; hands and feet are left out.
pub(super) fn is_lower_body(bone: usize) -> bool {
    const LEGS: [Bone; 4] = [
        Bone::LeftUpperLeg,
        Bone::LeftLowerLeg,
        Bone::RightUpperLeg,
        Bone::RightLowerLeg,
    ];
    bone <= Bone::Chest.index() || LEGS.iter().any(|leg| leg.index() == bone)
}

/// One assignment of points to capsules and one damped step of each capsule.
fn improve(parts: &mut [Part], samples: &[Sample]) {
    let mut systems = vec![System::default(); parts.len()];
    for sample in samples {
        let mut nearest = (0, f64::INFINITY);
        for (index, part) in parts.iter().enumerate() {
            let distance = part.distance(sample.point);
            if distance < nearest.1 {
                nearest = (index, distance);
            }
        }
        let index = nearest.0;
        let contact = parts[index].contact(sample.point);
        let error = contact.distance + COVER;
        let outside = (error / OUTSIDE_RAMP).clamp(0.0, 1.0);
        let weight = sample.area * (1.0 + (OUTSIDE_WEIGHT - 1.0) * outside);
        systems[index].add(&parts[index].slope(&contact), error, weight);
    }
    for (part, system) in parts.iter_mut().zip(systems) {
        if let Some(step) = system.solve() {
            part.step(&step);
        }
    }
}

/// Where a point meets a capsule.
#[derive(Debug, Clone, Copy)]
struct Contact {
    distance: f64,
    share: f64,
    normal: DVec3,
}

impl Part {
    /// Share of the way along the axis next to a point, and the way from there to it.
    fn foot(&self, point: DVec3) -> (f64, DVec3) {
        let axis = self.ends[1] - self.ends[0];
        let share =
            ((point - self.ends[0]).dot(axis) / axis.length_squared().max(1.0e-9)).clamp(0.0, 1.0);
        (share, point - (self.ends[0] + axis * share))
    }

    fn radius(&self, share: f64) -> f64 {
        self.radii[0] + (self.radii[1] - self.radii[0]) * share
    }

    fn distance(&self, point: DVec3) -> f64 {
        let (share, offset) = self.foot(point);
        offset.length() - self.radius(share)
    }

    fn contact(&self, point: DVec3) -> Contact {
        let (share, offset) = self.foot(point);
        Contact {
            distance: offset.length() - self.radius(share),
            share,
            normal: offset.normalize_or_zero(),
        }
    }

    /// Slope of the distance by the unknowns: both ends, both radii. Crosswise capsules have one
    /// end, mirrored, and one radius.
    fn slope(&self, contact: &Contact) -> [f64; UNKNOWNS] {
        let Contact { share, normal, .. } = *contact;
        if self.is_crosswise {
            let spread = 2.0 * share - 1.0;
            return [
                -normal.x * spread,
                -normal.y,
                -normal.z,
                0.0,
                0.0,
                0.0,
                -1.0,
                0.0,
            ];
        }
        let (first, second) = (normal * (share - 1.0), normal * -share);
        [
            first.x,
            first.y,
            first.z,
            second.x,
            second.y,
            second.z,
            share - 1.0,
            -share,
        ]
    }

    fn step(&mut self, step: &[f64; UNKNOWNS]) {
        let first = DVec3::new(step[0], step[1], step[2]);
        if self.is_crosswise {
            let end = self.ends[1] + first;
            self.ends = [end * DVec3::new(-1.0, 1.0, 1.0), end];
            self.radii = [(self.radii[0] + step[6]).max(LEAST_RADIUS); 2];
            return;
        }
        self.ends[0] += first;
        self.ends[1] += DVec3::new(step[3], step[4], step[5]);
        for (radius, step) in self.radii.iter_mut().zip(&step[6..]) {
            *radius = (*radius + step).max(LEAST_RADIUS);
        }
    }

    /// Itself, and its mirror image unless it lies crosswise.
    fn both_sides(&self) -> Vec<BodyCapsule> {
        #[expect(clippy::cast_possible_truncation, reason = "a radius to 0.1 µm")]
        let radii = self.radii.map(|radius| radius as f32);
        let [a, b] = self.ends.map(|end| end.as_vec3());
        let left = BodyCapsule {
            name: self.names[0],
            ends: [(self.bones[0], a), (self.bones[1], b)],
            radii,
        };
        if self.is_crosswise {
            return vec![left];
        }
        let right = BodyCapsule {
            name: self.names[1],
            ends: left
                .ends
                .map(|(bone, end)| (mirrored_bone(bone), end * glam::Vec3::new(-1.0, 1.0, 1.0))),
            radii,
        };
        vec![left, right]
    }
}

/// Normal equations of one capsule; of the symmetric matrix only the upper half is summed.
#[derive(Debug, Clone, Copy, Default)]
struct System {
    matrix: [[f64; UNKNOWNS]; UNKNOWNS],
    right: [f64; UNKNOWNS],
    weight: f64,
}

impl System {
    fn add(&mut self, slope: &[f64; UNKNOWNS], error: f64, weight: f64) {
        for row in 0..UNKNOWNS {
            for column in row..UNKNOWNS {
                self.matrix[row][column] += weight * slope[row] * slope[column];
            }
            self.right[row] -= weight * slope[row] * error;
        }
        self.weight += weight;
    }

    /// Solves the damped equations by elimination; the matrix is positive definite.
    fn solve(mut self) -> Option<[f64; UNKNOWNS]> {
        if self.weight <= 0.0 {
            return None;
        }
        for unknown in 0..UNKNOWNS {
            self.matrix[unknown][unknown] += DAMPING * self.weight;
            for column in 0..unknown {
                self.matrix[unknown][column] = self.matrix[column][unknown];
            }
        }
        for pivot in 0..UNKNOWNS {
            for row in pivot + 1..UNKNOWNS {
                let factor = self.matrix[row][pivot] / self.matrix[pivot][pivot];
                for column in pivot..UNKNOWNS {
                    self.matrix[row][column] -= factor * self.matrix[pivot][column];
                }
                self.right[row] -= factor * self.right[pivot];
            }
        }
        let mut solution = [0.0; UNKNOWNS];
        for row in (0..UNKNOWNS).rev() {
            let known: f64 = (row + 1..UNKNOWNS)
                .map(|column| self.matrix[row][column] * solution[column])
                .sum();
            solution[row] = (self.right[row] - known) / self.matrix[row][row];
        }
        Some(solution)
    }
}
