//! How cloth moves by and large: the motion that is left of a step when what is finer than a hand is
//! averaged out.
//!
//! Folds that are pressed through each other do not know where to go, but where the whole of them goes is
//! known: with the limb that presses. Moved by a field that hardly bends over the length of an edge, layers
//! keep to their sides of each other however fine they are, and whatever is held back by the same field does
//! not cross what else is. The motion is spread on a lattice and read back by quadratic B-splines, as in the
//! material point method (Steffen, Kirby and Berzins 2008, "Analysis and reduction of quadrature errors in
//! the material point method").
//!
//! Where one part of the cloth goes to and the other fro, farther than they are apart, such a field would
//! fold. So it is flowed along in parts that are too short for that: a flow never folds.

use glam::{IVec3, Vec3};

use crate::collision::impact_zone::Rigid;

/// Distance of the lattice's points [m]: a hand's breadth, which is more than folds of a gathered skirt and
/// less than a limb.
const SPACING: f32 = 0.08;

/// Most points of the lattice along an axis: of a cloth that is larger than five meters more is averaged.
const POINTS_MAX: f32 = 64.0;

/// How much more what is pinned says about the motion than what is free.
const PINNED_WEIGHT: f32 = 8.0;

/// How much longer or shorter a part of the flow makes what lies along it, at most: far from folding.
const FLOW_STRAIN: f32 = 0.25;

/// Most parts of the flow.
const PARTS_MAX: f32 = 16.0;

/// Weight of no motion beside that of the cloth as a whole, for where there is hardly any cloth.
const LEAST_WEIGHT: f32 = 1.0e-3;

/// A motion of the space around a cloth in one step.
#[derive(Debug, Clone, Default)]
pub(crate) struct Drift {
    /// Of the cloth as a whole; `None` before the first.
    whole: Option<Rigid>,
    /// Place of the lattice's first point [m], and the distance to the next.
    low: Vec3,
    spacing: f32,
    counts: IVec3,
    /// By point of the lattice, what the cloth does there before that [m], and the weight of it.
    points: Vec<(Vec3, f32)>,
    /// Parts in which that is done.
    part_count: f32,
}

impl Drift {
    /// Memory that it holds [byte].
    pub(crate) const fn byte_count(&self) -> usize {
        size_of_val(self.points.as_slice())
    }

    /// Takes the motion of cloth as a whole that goes from `starts` to `goals` [m], all finite; what is pinned
    /// says more.
    pub(crate) fn fit_whole(
        &mut self,
        starts: &[Vec3],
        goals: &[Vec3],
        is_pinned: impl Fn(u32) -> bool,
    ) {
        self.whole = Some(Rigid::fit(weighed(starts, goals, &is_pinned)));
        self.points.clear();
    }

    /// Takes the motion of cloth that goes from `starts` to `goals` [m], all finite: that of it as a whole,
    /// and what it does beside that by and large.
    pub(crate) fn fit(&mut self, starts: &[Vec3], goals: &[Vec3], is_pinned: impl Fn(u32) -> bool) {
        let moved = weighed(starts, goals, &is_pinned);
        let whole = Rigid::fit(moved.clone());
        self.lay(starts);
        for (weight, start, goal) in moved {
            let beside = whole.unapply(goal) - start;
            for (point, share) in self.shares(start) {
                let sum = &mut self.points[point];
                sum.0 += beside * (weight * share);
                sum.1 += weight * share;
            }
        }
        for (sum, weight) in &mut self.points {
            *sum /= *weight + LEAST_WEIGHT;
        }
        self.whole = Some(whole);
        let parts = self.steepness() / (FLOW_STRAIN * self.spacing);
        self.part_count = parts.ceil().clamp(1.0, PARTS_MAX);
    }

    /// Most that the motion differs between points of the lattice that follow each other [m].
    fn steepness(&self) -> f32 {
        let [x, y, z] = self
            .counts
            .to_array()
            .map(|count| usize::try_from(count).unwrap_or(0));
        let along = |step: usize| {
            let pairs = self.points.iter().zip(self.points.iter().skip(step));
            let pairs = pairs.filter(|((_, one), (_, other))| 0.0 < *one && 0.0 < *other);
            pairs.fold(0.0_f32, |most, ((one, _), (other, _))| {
                most.max(one.distance(*other))
            })
        };
        if z == 0 {
            return 0.0;
        }
        along(1).max(along(x)).max(along(x * y))
    }

    /// Lays the lattice around the cloth.
    fn lay(&mut self, starts: &[Vec3]) {
        let low = starts.iter().copied().fold(Vec3::INFINITY, Vec3::min);
        let high = starts.iter().copied().fold(Vec3::NEG_INFINITY, Vec3::max);
        let size = (high - low).max(Vec3::ZERO);
        self.spacing = SPACING.max(size.max_element() / POINTS_MAX);
        self.low = low - Vec3::splat(self.spacing);
        self.counts = (size / self.spacing).as_ivec3() + IVec3::splat(4);
        let [x, y, z] = self.counts.to_array().map(usize::try_from);
        let count = x.unwrap_or(0) * y.unwrap_or(0) * z.unwrap_or(0);
        self.points.clear();
        self.points.resize(count, (Vec3::ZERO, 0.0));
    }

    /// The lattice's points around a place of the cloth, and their shares of it, which sum up to 1.
    fn shares(&self, at: Vec3) -> impl Iterator<Item = (usize, f32)> + use<> {
        let place = (at - self.low) / self.spacing;
        let nearest = (place + Vec3::splat(0.5)).floor();
        // From the nearest point, -0.5 to 0.5.
        let off = place - nearest;
        let sides = |off: f32| {
            let (below, above) = (0.5 - off, 0.5 + off);
            [0.5 * below * below, 0.75 - off * off, 0.5 * above * above]
        };
        let [x, y, z] = off.to_array().map(sides);
        let (nearest, counts) = (nearest.as_ivec3(), self.counts);
        (0..27_i32).map(move |part| {
            let [i, j, k] = [part % 3, part / 3 % 3, part / 9];
            let at = nearest + IVec3::new(i, j, k) - IVec3::ONE;
            let at = at.clamp(IVec3::ZERO, counts - IVec3::ONE);
            let index = (at.z * counts.y + at.y) * counts.x + at.x;
            let [i, j, k] = [i, j, k].map(|it| usize::try_from(it).unwrap_or(0));
            (usize::try_from(index).unwrap_or(0), x[i] * y[j] * z[k])
        })
    }

    /// Where it brings cloth that starts at a place [m].
    pub(crate) fn apply(&self, start: Vec3) -> Vec3 {
        let Some(whole) = self.whole else {
            return start;
        };
        if self.points.is_empty() {
            return whole.apply(start);
        }
        let beside = |at: Vec3| -> Vec3 {
            let shares = self.shares(at);
            shares
                .map(|(point, share)| self.points[point].0 * share)
                .sum()
        };
        let mut at = start;
        let mut left = self.part_count;
        while 0.5 < left {
            at += beside(at) / self.part_count;
            left -= 1.0;
        }
        whole.apply(at)
    }
}

/// What each particle says about the motion from `starts` to `goals`, and from where to where it goes [m].
fn weighed(
    starts: &[Vec3],
    goals: &[Vec3],
    is_pinned: &impl Fn(u32) -> bool,
) -> impl Iterator<Item = (f32, Vec3, Vec3)> + Clone {
    let moved = (0_u32..).zip(starts).zip(goals);
    moved.map(move |((particle, &start), &goal)| {
        let weight = if is_pinned(particle) {
            PINNED_WEIGHT
        } else {
            1.0
        };
        (weight, start, goal)
    })
}

#[cfg(test)]
mod tests {
    use glam::Quat;
    use lole_geom::Chance;

    use super::*;

    /// Cloth of three layers that lie a millimeter apart in a square of half a meter.
    fn layers() -> Vec<Vec3> {
        let columns = (0..50_u8).flat_map(|x| (0..50_u8).map(move |z| (x, z)));
        let place = |(x, z): (u8, u8), layer: u8| {
            Vec3::new(f32::from(x), 0.1 * f32::from(layer), f32::from(z)) * 0.01
        };
        (0..3)
            .flat_map(|layer| columns.clone().map(move |at| place(at, layer)))
            .collect()
    }

    #[test]
    fn a_rigid_motion_is_taken_as_it_is() {
        let starts = layers();
        let turn = Quat::from_rotation_z(0.3) * Quat::from_rotation_x(-0.1);
        let goals: Vec<Vec3> = starts.iter().map(|&at| turn * at + Vec3::Y).collect();
        let mut drift = Drift::default();
        assert_eq!(drift.apply(Vec3::X), Vec3::X, "nothing is known yet");
        drift.fit(&starts, &goals, |particle| particle < 3);
        for (&start, &goal) in starts.iter().zip(&goals) {
            assert!(drift.apply(start).distance(goal) < 1.0e-5);
        }
    }

    #[test]
    fn layers_that_are_thrown_through_each_other_keep_apart_and_go_where_all_of_them_go() {
        let starts = layers();
        let mut chance = Chance::new(3);
        let goals: Vec<Vec3> = (starts.iter())
            .map(|&at| {
                let noise = Vec3::from_array([(); 3].map(|()| chance.between(-0.02, 0.02)));
                // One half is pushed up by a hand, the other lies.
                let pushed = ((at.x - 0.2) / 0.1).clamp(0.0, 1.0);
                at + Vec3::Y * (0.05 * pushed) + noise
            })
            .collect();
        let mut drift = Drift::default();
        drift.fit(&starts, &goals, |_| false);
        let moved: Vec<Vec3> = starts.iter().map(|&at| drift.apply(at)).collect();
        let count = starts.len() / 3;
        for (index, pair) in (0..count).map(|it| (it, [it, it + count])) {
            let gap = moved[pair[1]].y - moved[pair[0]].y;
            assert!((0.7e-3..1.3e-3).contains(&gap), "{gap}");
            let rise = moved[index].y - starts[index].y;
            let expected = 0.05 * ((starts[index].x - 0.2) / 0.1).clamp(0.0, 1.0);
            assert!((rise - expected).abs() < 0.015, "{rise} {expected}");
        }
    }
}
