//! What outlives a page: the work as it is, in the browser's storage.

use std::cell::RefCell;
use std::path::Path;
use std::sync::Arc;

use lole_files::shelf;
use lole_language::Sentence;
use wasm_bindgen::prelude::wasm_bindgen;
use web_sys::Storage;

use crate::Work;
use crate::memory::Memory;

/// Where the work lies.
const WORK: &str = "lole.work";
/// Where what is remembered lies.
const MEMORY: &str = "lole.memory";

#[wasm_bindgen]
extern "C" {
    /// Keeps the bytes of a file for the next visit; given by the page's script.
    #[wasm_bindgen(js_namespace = globalThis, js_name = loleKeepFile, catch)]
    fn keep_for_next_visit(name: &str, bytes: &[u8]) -> Result<(), wasm_bindgen::JsValue>;
}

/// Keeps a file that was handed in.
pub(super) fn keep_file(path: &Path, bytes: &[u8]) {
    // A browser that keeps nothing still shows it.
    drop(keep_for_next_visit(&path.to_string_lossy(), bytes));
}

/// What the last visit left, and what this one leaves.
#[derive(Default)]
pub(crate) struct Keeping {
    found: Option<Work>,
    memory: Memory,
    trouble: RefCell<Option<Sentence>>,
}

impl Keeping {
    /// Looks for what the last visit left. Files that its designs name lie on the shelf already.
    pub(crate) fn begin() -> Self {
        let read = |key| storage()?.get_item(key).ok()?;
        let work = read(WORK).unwrap_or_default();
        let file = |path: &Path| -> Option<Arc<[u8]>> { shelf::find(path) };
        Self {
            found: Work::parse(work.as_bytes(), file),
            memory: Memory::parse(&read(MEMORY).unwrap_or_default()),
            trouble: RefCell::default(),
        }
    }

    /// What was remembered.
    pub(crate) fn memory(&self) -> Memory {
        // Designs lie in no folder.
        Memory {
            recent: Vec::new(),
            roster: None,
            ..self.memory.clone()
        }
    }

    /// Takes the work of the last visit.
    pub(crate) fn take_found(&mut self) -> Option<Work> {
        self.found.take()
    }

    /// Keeps the work, saved or not: a page is shut without a question.
    #[expect(clippy::needless_pass_by_value, reason = "as a window takes it")]
    pub(crate) fn keep(&self, work: Work) {
        let text = String::from_utf8(work.to_bytes()).unwrap_or_default();
        if !write(WORK, &text) {
            self.trouble.replace(Some(Sentence::new(
                "ブラウザーにデザインを残せません（空きがないか、止められています）。「保存」でファイルに残してください。",
                "The browser cannot keep the design: no room, or it is not allowed to. Press “Save” to keep a file.",
            )));
        }
    }

    /// Keeps what is remembered.
    pub(crate) fn remember(&mut self, memory: &Memory) {
        if *memory != self.memory {
            self.memory = memory.clone();
            write(MEMORY, &memory.to_text());
        }
    }

    /// Why the work could not be kept.
    pub(crate) fn trouble(&self) -> Option<Sentence> {
        self.trouble.take()
    }
}

fn storage() -> Option<Storage> {
    web_sys::window()?.local_storage().ok()?
}

/// Whether it could be written.
fn write(key: &str, text: &str) -> bool {
    storage().is_some_and(|storage| storage.set_item(key, text).is_ok())
}
