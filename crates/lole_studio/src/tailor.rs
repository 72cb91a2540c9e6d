//! Drafting what was asked for last: whoever turns a knob never waits for the cut plan.

use lole_body::Dancer;
use lole_costume::document::{DancerDesign, Design};

use crate::paper::{Cutting, DrawnPrints, PaperDesign};

/// What is kept from one paper to the next.
#[derive(Default)]
pub(crate) struct Bench {
    measured: Option<(DancerDesign, Option<Dancer>)>,
    prints: DrawnPrints,
    number: u64,
}

impl Bench {
    /// The paper of a design; `None` where it cannot be danced, which is told beside its tape.
    pub(crate) fn paper(&mut self, design: &Design, cutting: Cutting) -> Option<PaperDesign> {
        let is_known = (self.measured.as_ref()).is_some_and(|(tape, _)| *tape == design.dancer);
        if !is_known {
            // Why a tape makes no body is told beside the tape.
            let dancer = lole_stage::dancer(design).ok().map(|(dancer, _)| dancer);
            self.measured = Some((design.dancer.clone(), dancer));
        }
        let dancer = self.measured.as_ref()?.1.as_ref()?;
        design.check("").ok()?;
        self.number += 1;
        let paper = PaperDesign::drawn(design, cutting, dancer, &mut self.prints);
        Some(PaperDesign {
            number: self.number,
            ..paper
        })
    }
}
