//! Numbers that hold for every substep of one step, worked out of fabric and settings.

use glam::Vec3;
use lole_geom::trig;

use crate::collision::response::ContactLaw;
use crate::step::{GridStep, StepOf};

/// Numbers that hold for every substep of one step.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Substep {
    /// Duration [s].
    pub(super) h: f32,
    pub(super) count: u32,
    /// What gravity adds to a velocity [m/s].
    pub(super) gravity_gain: Vec3,
    pub(super) air_velocity: Vec3,
    /// What drag leaves of a velocity relative to the air: `exp(-drag_rate h)`.
    pub(super) drag_kept: f32,
    pub(super) contact: ContactLaw,
}

impl Substep {
    /// Of a step that is cut into `count` substeps.
    pub(super) fn new(step: GridStep<'_>, count: u32) -> Self {
        let StepOf {
            model,
            config,
            input,
            dt,
        } = step;
        #[expect(clippy::cast_precision_loss, reason = "substeps are few")]
        let h = dt / count as f32;
        let spec = model.spec();
        Self {
            h,
            count,
            gravity_gain: config.gravity * h,
            air_velocity: input.air_velocity,
            drag_kept: trig::exp(-spec.fabric.drag_rate * h),
            contact: ContactLaw {
                friction: spec.fabric.friction,
                depenetration: config.depenetration_speed * h,
            },
        }
    }
}
