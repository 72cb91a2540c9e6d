//! What the page's script calls.

use lole_stage::machine;
use lole_studio::PageOpening;
use wasm_bindgen::prelude::wasm_bindgen;
use web_sys::HtmlCanvasElement;
use web_time::Instant;

/// A page before it is opened.
#[wasm_bindgen]
pub struct Page {
    opening: PageOpening,
}

#[wasm_bindgen]
impl Page {
    /// A page that draws on a canvas, in the language of a locale such as `ja-JP`.
    #[wasm_bindgen(constructor)]
    #[must_use]
    pub fn new(canvas: HtmlCanvasElement, locale: Option<String>) -> Self {
        Self {
            opening: PageOpening {
                canvas,
                locale,
                faces: Vec::new(),
                files: Vec::new(),
            },
        }
    }

    /// Adds a face for letters that the built-in ones lack, as an OpenType file.
    pub fn face(&mut self, bytes: Vec<u8>) {
        self.opening.faces.push(bytes);
    }

    /// Lays down a file that was kept from the last visit.
    pub fn file(&mut self, name: String, bytes: Vec<u8>) {
        self.opening.files.push((name, bytes));
    }

    /// Opens it.
    ///
    /// # Errors
    /// One sentence in the page's language.
    pub async fn open(self) -> Result<(), String> {
        lole_studio::open_page(self.opening).await
    }
}

/// Gives a worker that makes paper its fonts, as OpenType files.
#[wasm_bindgen(js_name = giveFonts)]
pub fn give_fonts(regular: Vec<u8>, bold: Vec<u8>) {
    lole_studio::give_fonts([regular, bold]);
}

/// Works in a worker as what the page calls `role`.
#[wasm_bindgen]
pub fn serve(role: &str) {
    lole_studio::serve(role);
}

/// Names of the scenes of a machine, a line each.
#[wasm_bindgen]
#[must_use]
pub fn scenes() -> String {
    machine::names().join("\n")
}

/// Runs such a scene: its name, the hash of its last state, and the median time of a frame [ms].
#[wasm_bindgen]
#[must_use]
pub fn scene(name: &str) -> Option<String> {
    let start = Instant::now();
    machine::run(name, &|| start.elapsed().as_secs_f64() * 1e3)
}
