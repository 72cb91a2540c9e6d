//! Sewing on a thread of its own, while another skirt dances on.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::Sender;
use std::thread::{self, JoinHandle};

use lole_costume::document::Design;

use crate::sim::sewing::{Entrance, Sewn, sew};
use crate::sim::{Input, Outbox};

/// A sewing thread.
pub(crate) struct Sewing {
    call_off: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl Sewing {
    /// Begins; the result goes to `inputs`.
    #[expect(
        clippy::unnecessary_wraps,
        reason = "a page may leave the work to somebody else"
    )]
    pub(crate) fn begin(
        (design, entrance): (Design, Entrance),
        _on_stage: Option<&Design>,
        inputs: &Sender<Input>,
        _outbox: &dyn Outbox,
    ) -> Option<Self> {
        let call_off = Arc::new(AtomicBool::new(false));
        let stop = Arc::clone(&call_off);
        let inputs = inputs.clone();
        let thread = thread::Builder::new()
            .name("sewing".to_owned())
            .spawn(move || {
                let show = sew(&design, entrance, &stop);
                let sewn = Box::new(Sewn { design, show });
                // Nobody waits for it only while the window closes.
                drop(inputs.send(Input::Sewn(sewn)));
            })
            .ok();
        Some(Self { call_off, thread })
    }

    /// Calls the work off; its result, if any, is of no use.
    pub(crate) fn call_off(&self) {
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
