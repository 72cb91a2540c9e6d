//! The page is opened, and a worker of it.

use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::sync::{Arc, Mutex};

use eframe::egui::{FontData, FontDefinitions, FontFamily};
use eframe::egui_wgpu::{WgpuConfiguration, WgpuSetup, WgpuSetupCreateNew};
use lole_costume::document::Design;
use lole_files::shelf;
use lole_language::{Bilingual as _, Language, Sentence};
use lole_render::wgpu;
use web_sys::HtmlCanvasElement;

use super::Keeping;
use crate::Studio;
use crate::app::{App, Rescued};

/// What the page opens with.
pub struct PageOpening {
    /// Where the studio is drawn.
    pub canvas: HtmlCanvasElement,
    /// The browser's language, as `ja` or `ja-JP`.
    pub locale: Option<String>,
    /// Faces of letters that the built-in ones lack, the first before the others, as OpenType files.
    pub faces: Vec<Vec<u8>>,
    /// Files that were kept from the last visit.
    pub files: Vec<(String, Vec<u8>)>,
}

/// Opens the studio in a page and lets it run.
///
/// # Errors
/// One sentence, in the page's language: there is no graphics.
pub async fn open_page(opening: PageOpening) -> Result<(), String> {
    for (name, bytes) in opening.files {
        shelf::lay(Path::new(&name), bytes);
    }
    let language = Language::of_locale(opening.locale.as_deref());
    let mut keeping = Keeping::begin();
    let memory = keeping.memory();
    let language = memory.language.unwrap_or(language);
    let mut studio = Studio::new(language, Design::default(), None);
    studio.memory = memory;
    match keeping.take_found() {
        Some(work) => studio.resume(work),
        None => studio.starts = true,
    }
    let options = eframe::WebOptions {
        wgpu_options: WgpuConfiguration {
            wgpu_setup: WgpuSetup::CreateNew(setup()),
            ..WgpuConfiguration::default()
        },
        // Plain colors need none.
        dithering: false,
        ..eframe::WebOptions::default()
    };
    let (fonts, work) = (fonts(opening.faces), Rescued { studio, keeping });
    let runner = eframe::WebRunner::new();
    let run = runner.start(
        opening.canvas,
        options,
        Box::new(move |creation| {
            creation.egui_ctx.set_fonts(fonts);
            let is_lost = Arc::new(AtomicBool::new(false));
            Ok(Box::new(App::new(
                work,
                creation,
                is_lost,
                Arc::new(Mutex::new(None)),
            )))
        }),
    );
    run.await.map_err(|error| {
        let reason = format!("{error:?}");
        let sentence = Sentence::new(
            format!(
                "このブラウザーでは絵を描けません（{reason}）。ほかのブラウザーでお試しください。"
            ),
            format!("This browser cannot draw the dancer ({reason}); try another one."),
        );
        sentence.text(language)
    })
}

/// Works in a worker as what the page calls `role`.
pub fn serve(role: &str) {
    match role {
        super::sim::ROLE => super::sim::serve(),
        super::light::ROLE => super::light::serve(),
        super::maker::ROLE => super::maker::serve(),
        super::order::ROLE => super::order::serve(),
        _ => {}
    }
}

/// WebGL 2, which every browser has; pictures are read back from it at once, as WebGPU does not allow.
fn setup() -> WgpuSetupCreateNew {
    let mut setup = WgpuSetupCreateNew::without_display_handle();
    setup.instance_descriptor.backends = wgpu::Backends::GL;
    setup.device_descriptor = Arc::new(|adapter| {
        let limits = wgpu::Limits::downlevel_webgl2_defaults().using_resolution(adapter.limits());
        wgpu::DeviceDescriptor {
            label: Some("lole page"),
            required_limits: limits,
            ..wgpu::DeviceDescriptor::default()
        }
    });
    setup
}

/// The built-in faces, and after them those that the page brought.
fn fonts(faces: Vec<Vec<u8>>) -> FontDefinitions {
    let mut fonts = FontDefinitions::default();
    for (number, face) in faces.into_iter().enumerate() {
        let name = format!("face-{number}");
        let data = Arc::new(FontData::from_owned(face));
        fonts.font_data.insert(name.clone(), data);
        for family in [FontFamily::Proportional, FontFamily::Monospace] {
            fonts.families.entry(family).or_default().push(name.clone());
        }
    }
    fonts
}
