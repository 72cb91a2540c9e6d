//! Frames along strands, by which what is drawn follows them.

use glam::{Quat, Vec3};
use lole_cloth::strands::Ring;

use super::OnStrand;

/// Place and directions at one particle of a strand.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Where it is [m].
    pub position: Vec3,
    /// Unit direction in its flat, across it.
    pub across: Vec3,
    /// Unit direction out of its flat.
    pub outward: Vec3,
    /// Unit direction along it.
    pub along: Vec3,
}

/// The frames of one strand, whose particles are `positions` [m]. Its flat faces `outward` at the first
/// particle and is carried along without turning about the strand (Bishop 1975, "There is more than one
/// way to frame a curve").
#[must_use]
pub fn frames(positions: &[Vec3], ring: Ring, outward: Vec3) -> Vec<Frame> {
    let count = positions.len();
    let tangent = |particle: usize| {
        let (before, after) = match ring {
            Ring::Closed => ((particle + count - 1) % count, (particle + 1) % count),
            Ring::Open => (particle.saturating_sub(1), (particle + 1).min(count - 1)),
        };
        (positions[after] - positions[before]).normalize_or(Vec3::NEG_Y)
    };
    let mut frames: Vec<Frame> = Vec::with_capacity(count);
    for (particle, &position) in positions.iter().enumerate() {
        let along = tangent(particle);
        let carried = match frames.last() {
            Some(last) => Quat::from_rotation_arc(last.along, along) * last.outward,
            None => outward,
        };
        let square = carried - along * carried.dot(along);
        let outward = square
            .try_normalize()
            .unwrap_or_else(|| along.any_orthonormal_vector());
        frames.push(Frame {
            position,
            across: outward.cross(along),
            outward,
            along,
        });
    }
    if ring == Ring::Closed
        && let Some(&first) = frames.first()
    {
        frames.push(first);
    }
    frames
}

/// Where a vertex on a strand with these frames is [m], and its normal. Between particles the middle of
/// the strand is a curve through them (Catmull and Rom 1974).
pub(crate) fn on_strand(frames: &[Frame], vertex: &OnStrand) -> [Vec3; 2] {
    let Some(last) = frames.len().checked_sub(1) else {
        return [Vec3::ZERO, Vec3::Y];
    };
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a place along a strand of tens of particles"
    )]
    let from = (vertex.along.max(0.0) as usize).min(last);
    let to = (from + 1).min(last);
    #[expect(clippy::cast_precision_loss, reason = "a strand has tens of particles")]
    let share = vertex.along - from as f32;
    let place = |particle: usize| frames[particle].position;
    let [before, a, b, after] = [
        place(from.saturating_sub(1)),
        place(from),
        place(to),
        place((to + 1).min(last)),
    ];
    let (t, t2, t3) = (share, share * share, share * share * share);
    let middle = if to == from {
        a + frames[from].along * 0.0
    } else {
        (a * 2.0
            + (b - before) * t
            + (before * 2.0 - a * 5.0 + b * 4.0 - after) * t2
            + (a * 3.0 - before - b * 3.0 + after) * t3)
            * 0.5
    };
    let blend = |direction: fn(&Frame) -> Vec3| {
        direction(&frames[from])
            .lerp(direction(&frames[to]), share.clamp(0.0, 1.0))
            .normalize_or_zero()
    };
    let axes = [
        blend(|frame| frame.across),
        blend(|frame| frame.outward),
        blend(|frame| frame.along),
    ];
    let turned = |v: Vec3| axes[0] * v.x + axes[1] * v.y + axes[2] * v.z;
    [
        middle + turned(vertex.offset),
        turned(vertex.normal).normalize_or_zero(),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_are_square_and_turn_no_more_than_the_strand_bends() {
        let place = |k: u16| {
            let angle = f32::from(k) * 0.2;
            let (sin, cos) = lole_geom::trig::sin_cos(angle);
            Vec3::new(cos, -0.3 * angle, sin) * 0.2
        };
        let positions: Vec<Vec3> = (0..20).map(place).collect();
        let frames = frames(&positions, Ring::Open, Vec3::X);
        for pair in frames.windows(2) {
            let [a, b] = [pair[0], pair[1]];
            assert!(a.outward.dot(a.along).abs() < 1e-5);
            assert!((a.across.length() - 1.0).abs() < 1e-5);
            let bend = lole_geom::trig::acos(a.along.dot(b.along));
            let turn = lole_geom::trig::acos(a.outward.dot(b.outward));
            assert!(turn <= bend + 1e-3, "{turn} over {bend}");
        }
    }

    #[test]
    fn a_straight_strand_carries_vertices_straight() {
        let positions: Vec<Vec3> = (0..5_u8).map(|k| Vec3::NEG_Y * f32::from(k)).collect();
        let frames = frames(&positions, Ring::Open, Vec3::Z);
        let vertex = OnStrand {
            strand: 0,
            along: 2.5,
            offset: Vec3::new(0.1, 0.2, 0.0),
            normal: Vec3::Y,
        };
        let [place, normal] = on_strand(&frames, &vertex);
        assert!((place.y + 2.5).abs() < 1e-5, "{place}");
        assert!((place.z - 0.2).abs() < 1e-5, "{place}");
        assert!((normal - Vec3::Z).length() < 1e-5, "{normal}");
    }
}
