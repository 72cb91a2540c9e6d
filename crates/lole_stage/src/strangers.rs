//! Bodies and dances that nobody designed for, drawn from a seed: what "on any body, in any dance" is
//! held against.
//!
//! A stranger is a built body that is given away: its skin is dressed in closed shells as game
//! characters are (trousers, shoes, coats, wide sleeves), thinned, doubled, turned inside out or torn,
//! or it is put together of boxes. She dances a step at any tempo, or as recordings go: walks, twists,
//! leaps, hands in her hips, and frames that jump.

mod bodies;
mod dances;

use lole_costume::document::Design;
use lole_geom::Chance;

use crate::{Production, StageError};

/// Somebody that nobody designed for, dressed and about to dance.
pub struct Stranger {
    /// What repeats her.
    pub seed: u64,
    /// What is odd about her body.
    pub body: String,
    /// What she dances.
    pub dance: String,
    /// She in her costume.
    pub production: Production,
}

impl Stranger {
    /// Draws the stranger of a seed, who wears what `design` has. Same seed, same bits.
    ///
    /// # Errors
    /// A design whose parts do not fit together on her.
    pub fn draw(seed: u64, design: &Design) -> Result<Self, StageError> {
        let mut chance = Chance::new(seed);
        let mut design = design.clone();
        let (dancer, body) = bodies::draw(&mut chance, &mut design)?;
        let dance = dances::draw(&mut chance, &mut design, &dancer)?;
        let (danced, dance) = dance;
        let production = Production::of(&design, dancer, danced)?;
        Ok(Self {
            seed,
            body,
            dance,
            production,
        })
    }
}
