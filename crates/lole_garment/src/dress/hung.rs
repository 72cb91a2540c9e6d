//! How cloth hangs that is wrapped around the trunk: straight down from where it is widest above.

use std::f32::consts::TAU;

use glam::{Vec2, Vec3};
use lole_body::Dancer;

/// Distance of levels [m].
const STEP: f32 = 0.02;

/// The trunk as wrapped cloth meets it, in the bind pose and so in every pose that moves the arms alone.
#[derive(Debug, Clone)]
pub(crate) struct Hung {
    top: f32,
    rings: Vec<Ring>,
}

/// One level: a convex way around the trunk.
#[derive(Debug, Clone)]
struct Ring {
    /// Corners `(x, z)` [m], from the middle of the back over the left side, and again the first.
    corners: Vec<Vec2>,
    /// Unit directions outward there.
    outward: Vec<Vec2>,
    /// Length of the way to each [m].
    passed: Vec<f32>,
}

impl Hung {
    /// Of cloth that is wrapped at a height and hangs down to another [m]; `None` where there is no trunk.
    pub(crate) fn new(dancer: &Dancer, [top, lowest]: [f32; 2]) -> Option<Self> {
        let rings = dancer.hung_rings([top, lowest], STEP);
        let rings: Vec<Ring> = rings.into_iter().map(Ring::new).collect::<Option<_>>()?;
        (!rings.is_empty()).then_some(Self { top, rings })
    }

    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "clamped to the levels"
    )]
    fn between(&self, height: f32) -> ([&Ring; 2], f32) {
        let last = self.rings.len() - 1;
        let level = ((self.top - height) / STEP).clamp(0.0, last as f32);
        let above = level as usize;
        let below = (above + 1).min(last);
        (
            [&self.rings[above], &self.rings[below]],
            level - above as f32,
        )
    }

    /// Length of cloth once around at a height, so far out of the skin [m].
    pub(crate) fn girth(&self, height: f32, gap: f32) -> f32 {
        let ([above, below], share) = self.between(height);
        let [above, below] = [above, below].map(Ring::girth);
        above + (below - above) * share + TAU * gap
    }

    /// A place at a height, a share of the way around from the middle of the back over her left, and so far
    /// out of the skin [m].
    pub(crate) fn place(&self, height: f32, turn: f32, gap: f32) -> Vec3 {
        let ([above, below], share) = self.between(height);
        let [above, below] = [above, below].map(|ring| ring.place(turn, gap));
        let place = above.lerp(below, share);
        Vec3::new(place.x, height, place.y)
    }
}

impl Ring {
    fn new(mut corners: Vec<Vec2>) -> Option<Self> {
        let count = corners.len();
        if count < 3 {
            return None;
        }
        let outward = (0..=count).map(|index| {
            let [before, here, after] =
                [index + count - 1, index, index + 1].map(|at| corners[at % count]);
            let along = (here - before).normalize_or_zero() + (after - here).normalize_or_zero();
            Vec2::new(along.y, -along.x).normalize_or_zero()
        });
        let outward = outward.collect();
        corners.push(corners[0]);
        let mut passed = vec![0.0];
        for pair in corners.windows(2) {
            passed.push(passed[passed.len() - 1] + pair[0].distance(pair[1]));
        }
        Some(Self {
            corners,
            outward,
            passed,
        })
    }

    fn girth(&self) -> f32 {
        self.passed[self.passed.len() - 1]
    }

    fn place(&self, turn: f32, gap: f32) -> Vec2 {
        // Cloth farther out goes the longer way around the corners.
        let wanted = (turn - turn.floor()) * (self.girth() + TAU * gap);
        let mut turned = 0.0;
        let count = self.corners.len() - 1;
        for index in 0..count {
            let [from, to] = [index, index + 1];
            let corner = self.outward[from].angle_to(self.outward[to]).abs();
            let [before, after] = [(from, turned), (to, turned + corner)]
                .map(|(at, turned)| self.passed[at] + turned * gap);
            if wanted <= after || to == count {
                let share = ((wanted - before) / (after - before).max(1.0e-6)).clamp(0.0, 1.0);
                let outward = self.outward[from].lerp(self.outward[to], share);
                return self.corners[from].lerp(self.corners[to], share)
                    + outward.normalize_or_zero() * gap;
            }
            turned += corner;
        }
        self.corners[0]
    }
}
