//! Sewing on a thread of its own: dancer, skirt and materials of a design, up to its first count.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::Sender;
use std::thread::{self, JoinHandle};

use lole_costume::document::{Design, MethodName};
use lole_language::Sentence;
use lole_picture::Looks;
use lole_stage::{Production, Show, StageError};

use super::Input;
use crate::snapshot::Wardrobe;

/// A show ready to be seen, or why there is none.
pub(super) struct Sewn {
    /// What was sewn.
    pub(super) design: Design,
    /// What came of it; `None` where it was called off.
    pub(super) show: Result<Option<(Show, Arc<Wardrobe>)>, Sentence>,
}

/// When the new skirt is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Entrance {
    /// At once: it is seen settling.
    Settling,
    /// When it has settled, because another skirt is dancing meanwhile.
    Settled,
}

/// A sewing thread.
pub(super) struct Sewing {
    call_off: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl Sewing {
    /// Begins; the result goes to `inputs`.
    pub(super) fn begin(design: Design, entrance: Entrance, inputs: Sender<Input>) -> Self {
        let call_off = Arc::new(AtomicBool::new(false));
        let stop = Arc::clone(&call_off);
        let thread = thread::Builder::new()
            .name("sewing".to_owned())
            .spawn(move || {
                let show = sew(&design, entrance, &stop);
                let sewn = Box::new(Sewn { design, show });
                // Nobody waits for it only while the window closes.
                drop(inputs.send(Input::Sewn(sewn)));
            })
            .ok();
        Self { call_off, thread }
    }

    /// Calls the work off; its result, if any, is of no use.
    pub(super) fn call_off(&self) {
        self.call_off.store(true, Ordering::Relaxed);
    }
}

impl Drop for Sewing {
    fn drop(&mut self) {
        self.call_off();
        if let Some(thread) = self.thread.take() {
            drop(thread.join());
        }
    }
}

fn sew(
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
    let wardrobe = wardrobe(design, Arc::clone(&production))?;
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
pub(super) fn wardrobe(
    design: &Design,
    production: Arc<Production>,
) -> Result<Arc<Wardrobe>, Sentence> {
    let looks = Looks::new(design, &production).map_err(|error| {
        Sentence::new(format!("布の柄を描けません（{error}）"), error.to_string())
    })?;
    Ok(Arc::new(Wardrobe::new(production, looks)))
}
