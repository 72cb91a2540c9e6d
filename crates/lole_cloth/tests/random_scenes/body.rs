//! What moves through the cloth.

use glam::Vec3;
use lole_geom::{Capsule, Chance, Surfel};

use super::drive::Way;
use crate::skin_support::sphere;

/// Capsules and surfels, each on its way.
pub(super) struct Body {
    /// By capsule: where it starts, and how it goes from there.
    capsules: Vec<(Capsule, Way)>,
    /// The surfels at their start, and how they go from there.
    skin: Option<(Vec<Surfel>, Way)>,
    /// The surfels now.
    pub(super) surfels: Vec<Surfel>,
}

impl Body {
    pub(super) fn draw(chance: &mut Chance, about: &mut String) -> Self {
        let (capsule_count, has_skin, words) = match chance.bits() % 6 {
            0 => (0, false, ""),
            1 | 2 => (1, false, ", a bar"),
            3 => (2, false, ", two bars"),
            4 => (0, true, ", a ball of surfels"),
            _ => (1, true, ", a bar and a ball of surfels"),
        };
        about.push_str(words);
        let capsule = |_| {
            let mut around =
                |reach: f32| Vec3::from_array([(); 3].map(|()| chance.between(-reach, reach)));
            let (middle, half) = (around(0.1) + Vec3::splat(0.08), around(0.25));
            let radius = chance.between(0.004, 0.03);
            let capsule = Capsule::uniform(middle - half, middle + half, radius);
            (capsule, Way::new(0.15, 4.0))
        };
        let capsules: Vec<_> = (0..capsule_count).map(capsule).collect();
        let skin = has_skin.then(|| {
            let low = [(); 3].map(|()| chance.between(-0.05, 0.15));
            let ball = sphere(Vec3::from_array(low), chance.between(0.03, 0.06));
            (ball, Way::new(0.15, 5.0))
        });
        Self {
            capsules,
            surfels: Vec::new(),
            skin,
        }
    }

    /// Moves on by a frame: the capsules, and the surfels beside.
    pub(super) fn move_on(&mut self, chance: &mut Chance) -> Vec<Capsule> {
        if let Some((start, way)) = &mut self.skin {
            let by = way.move_on(chance);
            self.surfels.clear();
            self.surfels.extend(start.iter().map(|surfel| Surfel {
                position: surfel.position + by,
                ..*surfel
            }));
        }
        let moved = self.capsules.iter_mut().map(|(capsule, way)| {
            let by = way.move_on(chance);
            Capsule {
                ends: capsule.ends.map(|end| end + by),
                ..*capsule
            }
        });
        moved.collect()
    }
}
