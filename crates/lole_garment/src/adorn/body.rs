//! Where things sit on a dancer's body, in the bind pose.

use std::f32::consts::TAU;

use glam::Vec3;
use lole_body::{Bone, Dancer, PartKind, TapePoint};
use lole_geom::trig;

use super::chosen::real;
use super::{Carrier, Rider};

/// What one bone alone carries.
pub(crate) fn bone_alone(bone: Bone) -> Carrier {
    Carrier {
        joints: [u16::try_from(bone.index()).unwrap_or(0), 0, 0, 0],
        weights: [1.0, 0.0, 0.0, 0.0],
    }
}

/// A point of a tape as something that rides.
pub(crate) fn rider(point: &TapePoint) -> Rider {
    Rider {
        position: point.bind_position,
        outward: point.outward,
        carrier: Carrier {
            joints: point.joints,
            weights: point.weights,
        },
    }
}

/// A closed line around a limb or the head: its points from a direction on, against the clock seen from
/// the tip of the axis.
#[derive(Debug, Clone)]
pub(crate) struct Girdle {
    pub(crate) points: Vec<Vec3>,
    pub(crate) outwards: Vec<Vec3>,
    /// Along the axis.
    pub(crate) axis: Vec3,
}

/// Where a girdle is looked for.
pub(crate) struct Around {
    pub(crate) center: Vec3,
    /// Unit vector along the limb.
    pub(crate) axis: Vec3,
    /// Where it begins.
    pub(crate) front: Vec3,
    /// Half the height of the slice that is looked at [m].
    pub(crate) half_height: f32,
    /// Farthest from the axis that a vertex is part of the limb [m].
    pub(crate) reach: f32,
    pub(crate) parts: &'static [PartKind],
}

impl Girdle {
    /// The outermost of the skin around an axis, smoothed over its neighbors.
    pub(crate) fn new(dancer: &Dancer, around: &Around, count: usize) -> Self {
        let axis = around.axis.normalize_or(Vec3::Y);
        let front = (around.front - axis * around.front.dot(axis)).normalize_or(Vec3::Z);
        let side = axis.cross(front);
        let mut radii = vec![0.0_f32; count];
        for vertex in vertices(dancer, around.parts) {
            let from = vertex - around.center;
            let (x, z) = (from.dot(side), from.dot(front));
            let radius = (x * x + z * z).sqrt();
            if around.half_height < from.dot(axis).abs() || around.reach < radius {
                continue;
            }
            let turn = (trig::atan2(x, z) / TAU).rem_euclid(1.0);
            // Every vertex counts for the places near it, less and less.
            for (place, known) in radii.iter_mut().enumerate() {
                let apart = (real(place) / real(count) - turn + 0.5).rem_euclid(1.0) - 0.5;
                let cos = trig::cos(TAU * apart);
                if 0.94 < cos {
                    *known = known.max(radius * cos);
                }
            }
        }
        let smooth = smoothed(&radii, (count / 24).max(1));
        let direction = |place: usize| {
            let (sin, cos) = trig::sin_cos(TAU * real(place) / real(count));
            front * cos + side * sin
        };
        Self {
            points: (0..count)
                .map(|place| around.center + direction(place) * smooth[place])
                .collect(),
            outwards: (0..count).map(direction).collect(),
            axis,
        }
    }

    /// Its length [m].
    pub(crate) fn length(&self) -> f32 {
        let next = self.points.iter().cycle().skip(1);
        self.points
            .iter()
            .zip(next)
            .map(|(a, b)| a.distance(*b))
            .sum()
    }

    /// The point at a share of the way around, the direction out of the body and that of the line.
    pub(crate) fn at(&self, share: f32) -> [Vec3; 3] {
        let count = self.points.len().max(1);
        let place = share.rem_euclid(1.0) * real(count);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a share of the count"
        )]
        let (from, part) = ((place as usize) % count, place.fract());
        let to = (from + 1) % count;
        let along = (self.points[to] - self.points[from]).normalize_or_zero();
        [
            self.points[from].lerp(self.points[to], part),
            (self.outwards[from].lerp(self.outwards[to], part)).normalize_or_zero(),
            along,
        ]
    }
}

/// The mean over `reach` places to either side on a closed line.
fn smoothed(values: &[f32], reach: usize) -> Vec<f32> {
    let count = values.len();
    let near = |place: usize| (0..=2 * reach).map(move |k| (place + count + k - reach) % count);
    (0..count)
        .map(|place| near(place).map(|k| values[k]).sum::<f32>() / real(2 * reach + 1))
        .collect()
}

/// Vertices of some parts of a skin in the bind pose, and of all of a given body's; of all where none of
/// them is there.
pub(crate) fn vertices(dancer: &Dancer, parts: &'static [PartKind]) -> impl Iterator<Item = Vec3> {
    let skin = &dancer.skin;
    let has_any = skin.parts.iter().any(|part| parts.contains(&part.kind));
    let is_meant = move |kind: PartKind| parts.contains(&kind) || kind == PartKind::Given;
    let chosen = (skin.parts.iter()).filter(move |part| !has_any || is_meant(part.kind));
    let mut numbers: Vec<u32> = chosen
        .flat_map(|part| part.triangles.iter().flatten().copied())
        .collect();
    numbers.sort_unstable();
    numbers.dedup();
    numbers
        .into_iter()
        .map(|vertex| skin.positions[vertex as usize])
}

/// The farthest that a body reaches from a point in a direction [m], within a cone of this cosine.
pub(crate) fn farthest(
    dancer: &Dancer,
    (from, towards): (Vec3, Vec3),
    cosine: f32,
    parts: &'static [PartKind],
) -> f32 {
    vertices(dancer, parts)
        .filter_map(|vertex| {
            let way = vertex - from;
            let along = way.dot(towards);
            (cosine * way.length() < along).then_some(along)
        })
        .fold(0.0, f32::max)
}

/// What carries the skin about a point: the mean of its vertices within a distance [m].
pub(crate) fn carrier_at(dancer: &Dancer, place: Vec3, within: f32) -> Carrier {
    let skin = &dancer.skin;
    let mut shares = vec![0.0_f32; Bone::COUNT];
    let mut nearest = (f32::INFINITY, 0);
    for (vertex, position) in skin.positions.iter().enumerate() {
        let apart = position.distance(place);
        if apart < nearest.0 {
            nearest = (apart, vertex);
        }
        if apart < within {
            add_shares(dancer, vertex, &mut shares);
        }
    }
    if shares.iter().all(|&share| share == 0.0) {
        add_shares(dancer, nearest.1, &mut shares);
    }
    let mut order: Vec<usize> = (0..shares.len()).collect();
    order.sort_by(|&a, &b| shares[b].total_cmp(&shares[a]));
    let mut carrier = Carrier::default();
    let sum: f32 = order.iter().take(4).map(|&bone| shares[bone]).sum();
    for (slot, &bone) in order.iter().take(4).enumerate() {
        carrier.joints[slot] = u16::try_from(bone).unwrap_or(0);
        carrier.weights[slot] = if 0.0 < sum { shares[bone] / sum } else { 0.0 };
    }
    carrier
}

fn add_shares(dancer: &Dancer, vertex: usize, shares: &mut [f32]) {
    let skin = &dancer.skin;
    let (Some(joints), Some(weights)) = (skin.joints.get(vertex), skin.weights.get(vertex)) else {
        return;
    };
    for (&joint, &weight) in joints.iter().zip(weights) {
        shares[usize::from(joint)] += weight;
    }
}
