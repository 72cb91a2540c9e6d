//! What is worn already, as far as it stands out: what comes over it must be laid farther out.

use glam::Vec3;

/// Directions around the body that are told apart.
const SECTORS: usize = 144;
/// Heights that are told apart [m].
const LEVEL: f32 = 0.01;
/// Levels from the floor up: more than anyone is tall.
const LEVELS: usize = 240;
/// Room between two garments that are laid over each other [m].
const ROOM: f32 = 0.003;

/// How far garments stand out from the axis of the body, by height and direction, in the bind pose.
#[derive(Debug, Clone, PartialEq)]
pub struct Clothed {
    axis: Vec3,
    /// Farthest distance from the axis [m], 0 where nothing is worn; shape `[LEVELS, SECTORS]`.
    radii: Vec<f32>,
}

impl Clothed {
    /// Nothing worn yet; the upright `axis` [m] of the trunk.
    #[must_use]
    pub fn new(axis: Vec3) -> Self {
        Self {
            axis,
            radii: vec![0.0; LEVELS * SECTORS],
        }
    }

    /// Puts on what lies at `positions` [m].
    pub fn put_on(&mut self, positions: impl Iterator<Item = Vec3>) {
        for position in positions {
            let (level, sector) = self.bin(position);
            let radius = &mut self.radii[level * SECTORS + sector];
            *radius = radius.max(from_axis(position - self.axis));
        }
    }

    /// How far outside of everything worn a place is, less the room that garments need [m]; infinite
    /// where nothing is worn.
    pub(super) fn clearance(&self, place: Vec3) -> f32 {
        let (level, sector) = self.bin(place);
        let mut farthest = 0.0_f32;
        for level in level.saturating_sub(1)..=(level + 1).min(LEVELS - 1) {
            for sector in [sector + SECTORS - 1, sector, sector + 1] {
                farthest = farthest.max(self.radii[level * SECTORS + sector % SECTORS]);
            }
        }
        if farthest == 0.0 {
            f32::INFINITY
        } else {
            from_axis(place - self.axis) - farthest - ROOM
        }
    }

    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "clamped to the bins"
    )]
    fn bin(&self, place: Vec3) -> (usize, usize) {
        let arm = place - self.axis;
        let level = (place.y / LEVEL).clamp(0.0, (LEVELS - 1) as f32) as usize;
        // Once around in 0..4, evenly enough and without an angle.
        let share = arm.x / (arm.x.abs() + arm.z.abs()).max(1.0e-6);
        let around = if 0.0 <= arm.z {
            1.0 - share
        } else {
            3.0 + share
        };
        let sector = (around * (SECTORS / 4) as f32).max(0.0) as usize;
        (level, sector % SECTORS)
    }
}

fn from_axis(arm: Vec3) -> f32 {
    (arm.x * arm.x + arm.z * arm.z).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_is_as_far_outside_as_it_is_from_what_is_worn() {
        let axis = Vec3::new(0.01, 0.0, -0.02);
        let mut clothed = Clothed::new(axis);
        let place = |angle: f32, radius: f32, height: f32| {
            let (sin, cos) = lole_geom::trig::sin_cos(angle);
            axis + Vec3::new(radius * cos, height, radius * sin)
        };
        assert_eq!(clothed.clearance(place(1.0, 0.1, 0.9)), f32::INFINITY);
        let around = (0..628_u16).map(|step| f32::from(step) / 100.0);
        clothed.put_on(around.clone().map(|angle| place(angle, 0.2, 0.9)));
        for angle in around {
            let clearance = clothed.clearance(place(angle, 0.25, 0.905));
            assert!(
                (clearance - (0.05 - ROOM)).abs() < 1e-5,
                "{angle}: {clearance}"
            );
            assert_eq!(clothed.clearance(place(angle, 0.25, 0.95)), f32::INFINITY);
        }
    }
}
