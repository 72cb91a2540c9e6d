//! Velocities of the cloth changed from outside the methods, as by a hand that pulls.

use glam::Vec3;

use super::Solver;

impl Solver {
    /// Changes the velocities [m/s], row-major.
    pub(crate) fn edit_velocities(&mut self, edit: impl FnOnce(&mut [Vec3])) {
        match self {
            Self::Xpbd(xpbd) => {
                let mut velocities = Vec::new();
                xpbd.state.copy_velocities(&xpbd.model, &mut velocities);
                edit(&mut velocities);
                xpbd.state.set_velocities(&xpbd.model, &velocities);
            }
            Self::Explicit(reference) => {
                let state = &mut reference.state;
                let mut velocities: Vec<Vec3> =
                    state.velocities.iter().map(|v| v.as_vec3()).collect();
                let before = velocities.clone();
                edit(&mut velocities);
                // What was not changed keeps its double precision.
                for ((kept, was), now) in state.velocities.iter_mut().zip(before).zip(velocities) {
                    if was != now {
                        *kept = now.as_dvec3();
                    }
                }
            }
        }
    }
}
