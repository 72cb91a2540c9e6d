//! A step whose phases are done one after the other, so that each can be timed.

use super::schedule::{Schedule, Stage};
use super::{
    Part, Plan, begin_observed, end, keep_guards, meets_itself, run, set_schedules,
    solve_cloth_contacts, start_substep,
};
use crate::phase::Phase;
use crate::{ClothModel, ClothState, SolverConfig, StepInput};

/// Moves the cloth on by `dt` as [`super::advance`] does, bit for bit, and calls `passed` at the
/// end of every phase.
pub(crate) fn advance(
    (model, config): (&ClothModel, &SolverConfig),
    (input, dt): (&StepInput<'_>, f32),
    state: &mut ClothState,
    passed: &mut dyn FnMut(Phase),
) {
    passed(Phase::Outside);
    let plan = begin_observed((model, config), (input, dt), state, Some(&mut *passed));
    for index in 0..plan.substep.count {
        start_substep((model, config, input), (&plan, index), state);
        passed(Phase::FindBody);
        if !meets_itself(&plan, index, state) {
            run_apart(
                (model, config),
                (&plan, index),
                (Part::Whole, state),
                passed,
            );
            continue;
        }
        let before = (Part::BeforeContact, &mut *state);
        run_apart((model, config), (&plan, index), before, passed);
        if let Some(law) = plan.law(index) {
            solve_cloth_contacts(law, state);
        }
        keep_guards(&plan, state);
        passed(Phase::SelfContact);
        let after = (Part::AfterContact, &mut *state);
        run_apart((model, config), (&plan, index), after, passed);
    }
    end((model, config), (input, dt), state);
    passed(Phase::Crossings);
}

/// A part of a substep, one stage after the other over the whole cloth.
fn run_apart(
    (model, config): (&ClothModel, &SolverConfig),
    (plan, index): (&Plan, u32),
    (part, state): (Part, &mut ClothState),
    passed: &mut dyn FnMut(Phase),
) {
    let whole = state.scratch.schedules.0[part as usize].clone();
    for stage in whole.stages() {
        // The code that runs a whole schedule runs one of a single stage: no second copy of it.
        state.scratch.schedules.0[part as usize] = Schedule::of(stage);
        let part = (part, plan.range(index), index);
        run((model, config, &plan.substep), part, state);
        passed(phase_of(stage));
    }
    set_schedules(model, config, state);
}

const fn phase_of(stage: Stage) -> Phase {
    match stage {
        Stage::Predict => Phase::Predict,
        Stage::Tether(_) => Phase::Tethers,
        Stage::ColumnStride(..) | Stage::RowStride(..) => Phase::Strides,
        Stage::BendAlong | Stage::BendDown => Phase::Bend,
        Stage::Cells => Phase::Cells,
        Stage::SpringsAlong | Stage::SpringsGathered | Stage::SpringsDown => Phase::Springs,
        Stage::Finish => Phase::BodyContact,
    }
}
