//! Sewing: dancer, skirt and materials of a design, up to its first count.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use lole_costume::document::{Design, MethodName};
use lole_language::Sentence;
use lole_picture::Looks;
use lole_stage::{Production, Show, StageError};

use crate::snapshot::Wardrobe;

/// A show ready to be seen, or why there is none.
pub(crate) struct Sewn {
    /// What was sewn.
    pub(crate) design: Design,
    /// What came of it; `None` where it was called off.
    pub(crate) show: Result<Option<(Show, Arc<Wardrobe>)>, Sentence>,
}

/// When the new skirt is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Entrance {
    /// At once: it is seen settling.
    Settling,
    /// When it has settled, because another skirt is dancing meanwhile.
    Settled,
}

/// Sews, and lets it settle where it is shown only then; `stop` calls it off.
pub(crate) fn sew(
    design: &Design,
    entrance: Entrance,
    stop: &AtomicBool,
) -> Result<Option<(Show, Arc<Wardrobe>)>, Sentence> {
    let said = |error: StageError| Sentence::of(&error);
    // It settles by the quick method whatever it is danced by: how it hangs at rest is the same.
    let mut quick = design.clone();
    quick.method.name = MethodName::Xpbd;
    quick.method.substep_count = None;
    let called_off = || stop.load(Ordering::Relaxed);
    let production = Arc::new(Production::new(&quick).map_err(said)?);
    if called_off() {
        return Ok(None);
    }
    let wardrobe = wardrobe(design, &production)?;
    let mut show = Show::of(production).map_err(said)?;
    while entrance == Entrance::Settled && show.time() < 0.0 {
        if called_off() {
            return Ok(None);
        }
        // A skirt that flies apart says so on stage.
        if show.advance().is_err() {
            break;
        }
    }
    show.wish(design).map_err(said)?;
    Ok(Some((show, wardrobe)))
}

/// The materials of a design for a production.
pub(crate) fn wardrobe(
    design: &Design,
    production: &Production,
) -> Result<Arc<Wardrobe>, Sentence> {
    let looks = Looks::new(design, production).map_err(|error| {
        Sentence::new(format!("布の柄を描けません（{error}）"), error.to_string())
    })?;
    Ok(Arc::new(Wardrobe::new(production, looks)))
}
