//! The window is opened, and opened anew where its graphics adapter is lost.

use std::any::Any;
use std::panic::{AssertUnwindSafe, PanicHookInfo};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use eframe::egui;
use eframe::egui_wgpu::{WgpuConfiguration, WgpuSetup, WgpuSetupCreateNew};
use lole_costume::document::Design;
use lole_files as files;
use lole_language::{Language, Sentence};
use lole_render::wgpu;

use super::Keeping;
use crate::Studio;
use crate::app::{App, Rescued};
use crate::message::Message;

/// Size of a new window [point].
const WINDOW: [f32; 2] = [1280.0, 720.0];
/// Smallest size of the window [point].
const SMALLEST: [f32; 2] = [360.0, 260.0];
/// A window whose adapter is lost is opened again this often.
const MOST_REOPENINGS: u32 = 3;

/// Why a window ended that was in the middle of a picture.
const LOST: &str = "the graphics adapter was lost";

/// What the window opens with.
#[derive(Debug, Clone)]
pub struct Opening {
    /// Language of its words.
    pub language: Language,
    /// Design to open; the built-in one where there is none.
    pub document: Option<PathBuf>,
}

/// Why no window was opened, in one sentence.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Refusal {
    /// The document cannot be read.
    Document(Sentence),
    /// There is no display, or no graphics adapter for it.
    Window(Sentence),
}

/// Opens the window and waits until it is closed.
///
/// # Errors
/// A document that cannot be read; no display.
pub fn open(opening: &Opening) -> Result<(), Refusal> {
    let design = match &opening.document {
        Some(path) => files::read_design(path).map_err(Refusal::Document)?,
        None => Design::default(),
    };
    let mut work = Rescued {
        studio: Studio::new(opening.language, design, opening.document.clone()),
        keeping: Keeping::begin(),
    };
    work.studio.found = work.keeping.found();
    remember(&mut work, opening.document.as_deref());
    for _ in 0..=MOST_REOPENINGS {
        match show(work).map_err(Refusal::Window)? {
            Some(lost) => work = lost,
            None => return Ok(()),
        }
        work.studio.message = Some(Message::trouble(&Sentence::new(
            "グラフィックス装置がとぎれたので、窓を開き直しました。",
            "The graphics adapter was lost; the window was opened anew.",
        )));
    }
    Err(Refusal::Window(Sentence::new(
        "グラフィックス装置が何度もとぎれました。lole dance --out フォルダー なら装置がなくても書き出せます",
        "the graphics adapter was lost again and again; lole dance --out FOLDER works without one",
    )))
}

/// What the last window left: the language that was chosen, and recent designs. The list that was chosen
/// is read while the window is there already.
fn remember(work: &mut Rescued, document: Option<&Path>) {
    let memory = work.keeping.memory();
    let studio = &mut work.studio;
    studio.language = memory.language.unwrap_or(studio.language);
    studio.memory = memory;
    match document {
        Some(path) => {
            let path = std::fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
            studio.memory.note_design(&path);
        }
        // Work that was found is offered first.
        None => studio.starts = studio.found.is_none(),
    }
}

/// Shows the window until it is closed; gives the studio back where the graphics adapter was lost.
fn show(work: Rescued) -> Result<Option<Rescued>, Sentence> {
    let rescued = Arc::new(Mutex::new(None));
    let shelf = Arc::clone(&rescued);
    let options = eframe::NativeOptions {
        viewport: egui::ViewportBuilder::default()
            .with_title("Lole")
            .with_app_id("lole")
            .with_inner_size(WINDOW)
            .with_min_inner_size(SMALLEST)
            .with_drag_and_drop(true),
        wgpu_options: WgpuConfiguration {
            wgpu_setup: WgpuSetup::CreateNew(WgpuSetupCreateNew {
                device_descriptor: Arc::new(device_descriptor),
                ..WgpuSetupCreateNew::without_display_handle()
            }),
            ..WgpuConfiguration::default()
        },
        // Plain colors need none, and it costs each pixel of a driver on the processor dearly.
        dithering: false,
        ..eframe::NativeOptions::default()
    };
    let is_lost = Arc::new(AtomicBool::new(false));
    let watched = Arc::clone(&is_lost);
    let run = move || {
        eframe::run_native(
            "lole",
            options,
            Box::new(move |creation| Ok(Box::new(App::new(work, creation, watched, shelf)))),
        )
    };
    // Where the adapter is lost in the middle of a picture, egui's painter panics before the device
    // has told of its loss.
    let is_gone = Arc::new(AtomicBool::new(false));
    let result = quietly(&is_lost, &is_gone, run);
    let work = (rescued.lock().unwrap_or_else(PoisonError::into_inner)).take();
    match result {
        Ok(result) => result.map(|()| work).map_err(|error| no_window(&error)),
        Err(_) if work.is_some() => Err(no_window(&eframe::Error::AppCreation(LOST.into()))),
        Err(panic) if is_gone.load(Ordering::Relaxed) => Err(taken_away(&*panic)),
        Err(panic) => std::panic::resume_unwind(panic),
    }
}

/// Runs `run` and catches its panics. Those of the graphics crates mean that the adapter is lost,
/// those of the window's crate that the window is gone, as where another program takes it away; both
/// are told in a sentence instead of being printed.
fn quietly<R>(
    is_lost: &Arc<AtomicBool>,
    is_gone: &Arc<AtomicBool>,
    run: impl FnOnce() -> R,
) -> std::thread::Result<R> {
    let usual: Arc<dyn Fn(&PanicHookInfo<'_>) + Send + Sync> = Arc::from(std::panic::take_hook());
    let kept = Arc::clone(&usual);
    let causes =
        [("wgpu", is_lost), ("winit", is_gone)].map(|(name, flag)| (name, Arc::clone(flag)));
    std::panic::set_hook(Box::new(move |news| {
        let place = news.location().map_or("", |place| place.file());
        match causes.iter().find(|(name, _)| place.contains(name)) {
            Some((_, flag)) => flag.store(true, Ordering::Relaxed),
            None => kept(news),
        }
    }));
    let result = std::panic::catch_unwind(AssertUnwindSafe(run));
    std::panic::set_hook(Box::new(move |news| usual(news)));
    result
}

/// The limits of WebGL2, so that the same drawing runs everywhere, at this adapter's resolution.
fn device_descriptor(adapter: &wgpu::Adapter) -> wgpu::DeviceDescriptor<'static> {
    let limits = wgpu::Limits::downlevel_webgl2_defaults().using_resolution(adapter.limits());
    wgpu::DeviceDescriptor {
        label: Some("lole window"),
        required_limits: limits,
        ..wgpu::DeviceDescriptor::default()
    }
}

/// The window's crate gave up, and why.
fn taken_away(panic: &(dyn Any + Send)) -> Sentence {
    let reason = (panic.downcast_ref::<String>().map(String::as_str))
        .or_else(|| panic.downcast_ref::<&str>().copied())
        .unwrap_or("");
    Sentence::new(
        format!(
            "窓が外から閉じられました（{reason}）。もう一度 lole で開くと、保存していない変更から続けられます"
        ),
        format!(
            "the window was taken away ({reason}); run lole to open it again and go on with what was not saved"
        ),
    )
}

/// Variables that name a display, where a system has them.
const DISPLAYS: [&str; 3] = ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"];

fn no_window(error: &eframe::Error) -> Sentence {
    let is_named = |name| std::env::var_os(name).is_some_and(|it| !it.is_empty());
    let has_display = DISPLAYS.into_iter().any(is_named);
    let reason = match error {
        eframe::Error::Wgpu(_) | eframe::Error::AppCreation(_) => Sentence::new(
            "グラフィックス装置が使えません",
            "no graphics adapter can be used",
        ),
        // There is one, and something that it is reached by is not.
        error if has_display => Sentence::new(
            format!(
                "画面につながりません: {error}。X か Wayland のライブラリが足りないかもしれません"
            ),
            format!(
                "the display cannot be reached: {error}; a library of X or Wayland may be missing"
            ),
        ),
        _ => Sentence::new("画面がありません", "there is no display"),
    };
    Sentence::new(
        format!(
            "窓を開けません（{}）。画面がなくても lole dance --out フォルダー で動画と写真を書き出せます",
            reason.japanese
        ),
        format!(
            "no window can be opened ({}); lole dance --out FOLDER writes film and stills without one",
            reason.english
        ),
    )
}
