//! A step whose phases are done one after the other, so that each can be timed.

use super::schedule::{Part, Schedule, Stage, set_schedules};
use super::{SubstepNow, begin_observed, end, keep_guards, solve_cloth_contacts};
use crate::ClothState;
use crate::phase::Phase;
use crate::step::GridStep;

/// Moves the cloth on as [`super::advance`] does, bit for bit, and calls `passed` at the end of every
/// phase.
pub(crate) fn advance(step: GridStep<'_>, state: &mut ClothState, passed: &mut dyn FnMut(Phase)) {
    passed(Phase::Outside);
    let plan = &begin_observed(step, state, Some(&mut *passed));
    for index in 0..plan.substep.count {
        let now = SubstepNow { step, plan, index };
        now.start(state);
        passed(Phase::FindBody);
        if !now.meets_itself(state) {
            now.run_apart(Part::Whole, state, passed);
            continue;
        }
        now.run_apart(Part::BeforeContact, state, passed);
        if let Some(law) = plan.law(index) {
            solve_cloth_contacts(law, state);
        }
        keep_guards(plan, state);
        passed(Phase::SelfContact);
        now.run_apart(Part::AfterContact, state, passed);
    }
    end(step, state);
    passed(Phase::Crossings);
}

impl SubstepNow<'_> {
    /// A part of the substep, one stage after the other over the whole cloth.
    fn run_apart(self, part: Part, state: &mut ClothState, passed: &mut dyn FnMut(Phase)) {
        let whole = state.scratch.schedules.of(part).clone();
        for stage in whole.stages() {
            // The code that runs a whole schedule runs one of a single stage: no second copy of it.
            *state.scratch.schedules.of_mut(part) = Schedule::of(stage);
            self.run(part, state);
            passed(phase_of(stage));
        }
        set_schedules(self.step.model, self.step.config, state);
    }
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
