//! A worker: the same program a second time, with memory of its own. It is sent parcels and sends parcels back.

use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, VecDeque};
use std::path::Path;
use std::rc::Rc;
use std::sync::Arc;

use js_sys::{Array, Object, Reflect, Uint8Array};
use lole_costume::document::Design;
use lole_files::shelf;
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast as _, JsValue};
use web_sys::{DedicatedWorkerGlobalScope, Event, MessageEvent, WorkerOptions, WorkerType};

use crate::platform::letters::put_file;
use crate::platform::parcel::{Packer, Unpacker};

/// The script that a worker begins with.
const SCRIPT: &str = "./worker.js";

/// Calls for the next picture.
pub(super) type Wake = Rc<dyn Fn()>;

/// A worker as the page sees it. Dropped, it ends at once, whatever it does.
pub(super) struct Worker {
    worker: web_sys::Worker,
    inbox: Rc<RefCell<VecDeque<Vec<u8>>>>,
    failed: Rc<Cell<bool>>,
    /// Files that lie on its shelf.
    laid: RefCell<BTreeMap<String, Arc<[u8]>>>,
    _hears: Closure<dyn FnMut(MessageEvent)>,
    _fails: Closure<dyn FnMut(Event)>,
}

impl Worker {
    /// Starts one for a role; `wake` is called when something came from it. `None` where the browser has none.
    pub(super) fn start(role: &str, wake: &Wake) -> Option<Self> {
        let options = WorkerOptions::new();
        options.set_type(WorkerType::Module);
        let worker = web_sys::Worker::new_with_options(SCRIPT, &options).ok()?;
        let (inbox, failed) = (Rc::default(), Rc::new(Cell::new(false)));
        let (box_of_closure, woken): (Rc<RefCell<VecDeque<Vec<u8>>>>, Wake) =
            (Rc::clone(&inbox), Rc::clone(wake));
        let hears = Closure::<dyn FnMut(MessageEvent)>::new(move |event: MessageEvent| {
            let parcel = Uint8Array::new(&event.data()).to_vec();
            box_of_closure.borrow_mut().push_back(parcel);
            woken();
        });
        let (flag, woken) = (Rc::clone(&failed), Rc::clone(wake));
        let fails = Closure::<dyn FnMut(Event)>::new(move |_| {
            flag.set(true);
            woken();
        });
        worker.set_onmessage(Some(hears.as_ref().unchecked_ref()));
        worker.set_onerror(Some(fails.as_ref().unchecked_ref()));
        let first = Object::new();
        Reflect::set(&first, &"module".into(), &wasm_bindgen::module()).ok()?;
        Reflect::set(&first, &"role".into(), &role.into()).ok()?;
        worker.post_message(&first).ok()?;
        Some(Self {
            worker,
            inbox,
            failed,
            laid: RefCell::default(),
            _hears: hears,
            _fails: fails,
        })
    }

    /// Sends a parcel.
    pub(super) fn post(&self, parcel: &Packer) {
        post(&parcel.0, |message, transfer| {
            self.worker.post_message_with_transfer(message, transfer)
        });
    }

    /// Sends what a design needs and the worker has not got: a parcel of `head` and the file, for each.
    pub(super) fn lay_linked(&self, design: &Design, head: u8) {
        for name in design.linked_names() {
            let Some(bytes) = shelf::find(Path::new(name)) else {
                continue;
            };
            let mut laid = self.laid.borrow_mut();
            let known = laid.insert(name.to_owned(), Arc::clone(&bytes));
            if known.is_none_or(|known| known != bytes) {
                let mut parcel = Packer::default();
                parcel.put(head);
                put_file(&mut parcel, name, &bytes);
                self.post(&parcel);
            }
        }
    }

    /// The next parcel that came.
    pub(super) fn receive(&self) -> Option<Vec<u8>> {
        self.inbox.borrow_mut().pop_front()
    }

    /// Whether it broke down.
    pub(super) fn has_failed(&self) -> bool {
        self.failed.get()
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        self.worker.set_onmessage(None);
        self.worker.set_onerror(None);
        self.worker.terminate();
    }
}

/// Copies a parcel out of this program's memory and gives the copy away.
fn post(bytes: &[u8], send: impl FnOnce(&JsValue, &JsValue) -> Result<(), JsValue>) {
    let copy = Uint8Array::from(bytes);
    let transfer = Array::of1(&copy.buffer());
    // Whoever does not hear it has ended.
    drop(send(&copy, &transfer));
}

/// The program as a worker: what it is sent is handed to `hear`, one parcel after the other.
pub(super) fn hear(mut hear: impl FnMut(&[u8]) + 'static) {
    let closure = Closure::<dyn FnMut(MessageEvent)>::new(move |event: MessageEvent| {
        hear(&Uint8Array::new(&event.data()).to_vec());
    });
    scope().set_onmessage(Some(closure.as_ref().unchecked_ref()));
    // It hears as long as it lives.
    closure.forget();
}

/// Sends a parcel to the page.
pub(super) fn answer(parcel: &Packer) {
    post(&parcel.0, |message, transfer| {
        scope().post_message_with_transfer(message, transfer)
    });
}

/// Sends all files that were written, in one parcel that begins with `head`: some of them are no archive, and a
/// page hands out what it has.
pub(super) fn answer_written(head: u8) {
    let written = shelf::take_written();
    let mut parcel = Packer::default();
    parcel.put(head);
    parcel.count(written.len());
    for (path, bytes) in written {
        parcel.text(&path.to_string_lossy());
        parcel.list(&bytes);
    }
    answer(&parcel);
}

/// Writes what [`answer_written`] sent, after its head.
pub(super) fn lay_written(parcel: &mut Unpacker<'_>) {
    for _ in 0..parcel.count().unwrap_or(0) {
        let (Some(name), Some(bytes)) = (parcel.text(), parcel.list::<u8>()) else {
            return;
        };
        shelf::write(Path::new(&name), &bytes);
    }
}

/// The worker that this program is.
pub(super) fn scope() -> DedicatedWorkerGlobalScope {
    js_sys::global().unchecked_into()
}
