//! A garment as its maker decided it.

use lole_cloth::Fabric;
use lole_pattern::{Alterations, DraftError, Pattern, TailorTape};

use crate::fitting::Fitting;
use crate::given::Given;
use crate::template::{Options, Template};

/// One garment as it is ordered: what it is, how it is cut, and what of.
#[derive(Debug, Clone, Copy)]
pub struct GarmentSpec<'a> {
    /// What it is.
    pub template: &'static Template,
    /// What was decided, one value for each option of the template.
    pub options: &'a Options,
    /// Its cloth in SI units.
    pub fabric: Fabric,
    /// Its colors.
    pub colors: Colors,
    /// How it is altered where it is fitted.
    pub alterations: Alterations,
    /// What was taken of her for it, in the place of what her body has.
    pub tailor_tape: TailorTape,
    /// The pieces that it is cut after where a file has them.
    pub given: Option<&'a Given>,
}

/// Colors of a print, or of what is made of leaves and flowers; sRGB.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Colors {
    /// What lies behind.
    pub ground: [u8; 3],
    /// Flowers and feathers.
    pub flower: [u8; 3],
    /// Leaves.
    pub leaf: [u8; 3],
    /// Hearts and what else sets off.
    pub shadow: [u8; 3],
}

impl GarmentSpec<'_> {
    /// Drafts it.
    ///
    /// # Errors
    /// Measures or options that it cannot be drafted from.
    pub fn pattern(&self, fitting: &Fitting<'_>) -> Result<Pattern, DraftError> {
        match self.given {
            Some(given) => Ok(given.pattern_for(fitting, self.options)),
            None => (self.template.draft)(fitting, self.options),
        }
    }
}
