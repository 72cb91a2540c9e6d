//! How far from where the camera looks the dance reaches.

use glam::Vec3;
use lole_geom::trig;

use super::{AROUND_COUNT, AROUND_SECONDS, Figures, LOOKS, Placed, moments, smoothed};

/// Looks at the dance in one slice of it, for which a camera of formations knows how far it reaches.
const IN_SLICE: usize = 16;
/// So many slices before and after one count for it: the camera goes away before anybody would leave the picture.
const WINDOW: usize = 5;

/// A direction, and the outermost place in it from where the camera looks [m].
type Outermost = Vec<(Vec3, Vec3)>;

/// The outermost places of a dance, from where the camera looks [m]: slice by slice, or for all of it.
pub(super) struct Reach(Vec<Vec<Vec3>>);

impl Reach {
    /// Of the lead-in and one round of the dance of a group.
    pub(super) fn of(group: &[Placed<'_>], skirts: &[f32]) -> Self {
        let [every, half] = [LOOKS, LOOKS * AROUND_COUNT].map(usize::from);
        // What the camera looks at lies before and after, too.
        let around = AROUND_SECONDS * f32::from(AROUND_COUNT);
        let figures: Vec<Figures> = moments(group, skirts, around).collect();
        let in_slice = if is_forming(group) {
            IN_SLICE
        } else {
            usize::MAX
        };
        let mut slices: Vec<Outermost> = Vec::new();
        for (look, moments) in figures.windows(2 * half + 1).enumerate() {
            if look % in_slice == 0 {
                slices.push(directions().map(|it| (it, Vec3::ZERO)).collect());
            }
            let middle = smoothed(moments.iter().step_by(every).map(Figures::middle));
            for (direction, farthest) in slices.last_mut().into_iter().flatten() {
                let away = moments[half].farthest(*direction) - middle;
                keep_farther(*direction, farthest, away);
            }
        }
        let widened = (0..slices.len()).map(|place| {
            let [first, end] = [place.saturating_sub(WINDOW), place + WINDOW + 1];
            seen(&slices[first..end.min(slices.len())])
        });
        Self(widened.collect())
    }

    /// What must be seen at a time of the dance [s], from where the camera looks [m].
    pub(super) fn at(&self, time: f32) -> Vec<Vec3> {
        let slice = AROUND_SECONDS / f32::from(LOOKS) * IN_SLICE as f32;
        let last = self.0.len().saturating_sub(1) as f32;
        let here = (time / slice - 0.5).clamp(0.0, last);
        // The mean of the slices around, each of which has room for this moment.
        let mut sum: Vec<Vec3> = Vec::new();
        let mut weights = 0.0;
        for (place, reach) in self.0.iter().enumerate() {
            let apart = (place as f32 - here).abs() / WINDOW as f32;
            if apart < 1.0 {
                let weight = 1.0 + trig::cos(std::f32::consts::PI * apart);
                sum.resize(reach.len(), Vec3::ZERO);
                for (sum, away) in sum.iter_mut().zip(reach) {
                    *sum += *away * weight;
                }
                weights += weight;
            }
        }
        sum.into_iter().map(|sum| sum / weights).collect()
    }
}

/// Whether the formation changes while they dance.
fn is_forming(group: &[Placed<'_>]) -> bool {
    let first = group.first().map(|it| it.performance.production());
    let mut parts = first.iter().flat_map(|it| &it.design.motion.parts);
    1 < group.len() && parts.any(|part| part.formation.is_some())
}

fn keep_farther(direction: Vec3, farthest: &mut Vec3, away: Vec3) {
    if farthest.dot(direction) < away.dot(direction) {
        *farthest = away;
    }
}

/// What must be seen of all of some slices.
fn seen(slices: &[Outermost]) -> Vec<Vec3> {
    let mut all = slices.first().cloned().unwrap_or_default();
    for slice in slices {
        for ((direction, farthest), (_, away)) in all.iter_mut().zip(slice) {
            keep_farther(*direction, farthest, *away);
        }
    }
    // The floor that she stands on is seen, wherever her feet are.
    let floor = all.iter().map(|(_, it)| Vec3::new(0.0, 0.0, it.z));
    let floor: Vec<Vec3> = floor.collect();
    all.into_iter().map(|(_, it)| it).chain(floor).collect()
}

/// Directions all around, 15° apart along the horizon.
fn directions() -> impl Iterator<Item = Vec3> {
    (-3_i8..=3).flat_map(|up| {
        let (sin_up, cos_up) = trig::sin_cos(f32::from(up) * std::f32::consts::FRAC_PI_6);
        (0_u8..24).map(move |turn| {
            let (sin, cos) = trig::sin_cos(f32::from(turn) * std::f32::consts::PI / 12.0);
            Vec3::new(cos_up * sin, sin_up, cos_up * cos)
        })
    })
}
