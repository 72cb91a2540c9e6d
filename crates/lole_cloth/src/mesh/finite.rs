//! Looks for the first thing that is no number, where a piece could not go on.

use glam::Vec3;
use lole_geom::Surfel;

use crate::lanes::{LANES, Points};
use crate::lost;
use crate::mesh::model::MeshModel;
use crate::{Lost, SolverConfig, StepInput};

/// What of the input is no finite number.
pub(crate) fn lost_in_input(
    model: &MeshModel,
    config: &SolverConfig,
    input: &StepInput<'_>,
    dt: f32,
) -> Option<Lost> {
    if !(dt.is_finite() && 0.0 < dt) {
        return Some(Lost::Duration { dt });
    }
    let settings = [
        ("air_velocity", input.air_velocity.is_finite()),
        ("gravity", config.gravity.is_finite()),
        ("contact_offset", config.contact_offset.is_finite()),
        (
            "depenetration_speed",
            config.depenetration_speed.is_finite(),
        ),
        (
            "tether_scale",
            config.tether_scale.is_none_or(f32::is_finite),
        ),
    ];
    if let Some(&(field, _)) = settings.iter().find(|(_, is_finite)| !is_finite) {
        return Some(Lost::Setting { field });
    }
    if let Err(lost) = lost::check_pins(model.pin_indices().len(), input.pin_targets) {
        return Some(lost);
    }
    let mut pins = model.pin_indices().iter().zip(input.pin_targets);
    if let Some((&particle, &target)) = pins.find(|(_, target)| !target.is_finite()) {
        return Some(Lost::PinTarget { particle, target });
    }
    let is_finite = |capsule: &lole_geom::Capsule| {
        capsule.ends.iter().all(|end| end.is_finite())
            && capsule.radii.iter().all(|radius| radius.is_finite())
    };
    let mut capsules = input.capsules.iter();
    if let Some(index) = capsules.position(|capsule| !is_finite(capsule)) {
        return Some(Lost::Capsule { index });
    }
    let is_nowhere = |surfel: &Surfel| !(surfel.position.is_finite() && surfel.normal.is_finite());
    let index = input.surfels.iter().position(is_nowhere)?;
    Some(Lost::Surfel { index })
}

/// The first particle with a place that is none, and that place.
pub(crate) fn first_lost(model: &MeshModel, at: impl Fn(usize) -> Vec3) -> Option<(u32, Vec3)> {
    let slots = (0_u32..).zip(&model.slots.of_particle);
    let mut places = slots.map(|(particle, &slot)| (particle, at(slot as usize)));
    places.find(|(_, place)| !place.is_finite())
}

/// Whether all of these are finite numbers.
pub(crate) fn all_finite(points: &[Points]) -> bool {
    // A number that is none, or infinite, times zero is none. Every lane has a sum of its own, so
    // that none waits for another.
    let mut sums = [0.0_f32; LANES];
    for points in points {
        for (lane, sum) in sums.iter_mut().enumerate() {
            let [x, y, z] = [points.x[lane], points.y[lane], points.z[lane]];
            *sum += (x * 0.0 + y * 0.0) + z * 0.0;
        }
    }
    sums.into_iter().all(|sum| sum == 0.0)
}

/// What a slot holds.
pub(crate) fn at(points: &[Points], slot: usize) -> Vec3 {
    points[slot / LANES].get(slot % LANES)
}
