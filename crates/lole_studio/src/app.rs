//! The window itself: panels, picture, simulation and files brought together.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, Receiver};
use std::sync::{Arc, Mutex, PoisonError};

use eframe::egui::{self, Context, Ui};
use lole_costume::document::{Design, LinkedFile, LinkedPicture, PhotoMarks};
use lole_export::{ImageView, still};
use lole_files as files;
use lole_language::Sentence;
use lole_render::wgpu;

use crate::journal::{self, Journal, Leftover};
use crate::message::Message;
use crate::ordering::{self, Job, OrderNews, OrderWork};
use crate::sim::{News, Sim};
use crate::studio::{Purpose, Question, Request};
use crate::tailor::Tailor;
use crate::viewport::Viewport;
use crate::{Studio, Work, look, panel};

/// Width of the left and of the right column [point].
const COLUMNS: [f32; 2] = [330.0, 272.0];
/// Narrower windows have one column [point].
const WIDE: f32 = 980.0;
/// And still narrower ones none beside the picture, but below it [point].
const NARROW: f32 = 640.0;

/// What files of recordings are called.
const RECORDING_ENDINGS: [&str; 8] = ["bvh", "BVH", "vrma", "VRMA", "glb", "gltf", "vrm", "VRM"];

/// The running window.
pub(crate) struct App {
    studio: Studio,
    sim: Sim,
    tailor: Tailor,
    order: Option<OrderWork>,
    viewport: Viewport,
    /// Answers of the system's file dialog.
    answers: Option<Receiver<Option<PathBuf>>>,
    keeping: Keeping,
    context: Context,
    /// Whether the graphics adapter was lost, and where the studio is put then.
    is_lost: Arc<AtomicBool>,
    shelf: Shelf,
}

/// What outlives a window.
pub(crate) struct Rescued {
    pub(crate) studio: Studio,
    pub(crate) keeping: Keeping,
}

/// Where it is put.
pub(crate) type Shelf = Arc<Mutex<Option<Rescued>>>;

/// The copy of the work that outlives a crash, and the one that another window left.
#[derive(Default)]
pub(crate) struct Keeping {
    journal: Option<Journal>,
    leftover: Option<Leftover>,
}

impl Keeping {
    pub(crate) fn begin() -> Self {
        let folder = journal::folder(|name| std::env::var_os(name));
        let (journal, leftover) = folder
            .and_then(|folder| Journal::open(&folder))
            .map_or((None, None), |(journal, left)| (Some(journal), left));
        Self { journal, leftover }
    }

    pub(crate) fn found(&self) -> Option<Work> {
        self.leftover.as_ref().map(|leftover| leftover.work.clone())
    }
}

impl App {
    pub(crate) fn new(
        work: Rescued,
        creation: &eframe::CreationContext<'_>,
        is_lost: Arc<AtomicBool>,
        shelf: Shelf,
    ) -> Self {
        let context = &creation.egui_ctx;
        look::apply(context);
        if let Some(gpu) = &creation.wgpu_render_state {
            watch_device(&gpu.device, &is_lost, context);
        }
        let Rescued { studio, keeping } = work;
        let sim = start(studio.design().clone(), context);
        let repaint = context.clone();
        Self {
            keeping,
            studio,
            sim,
            tailor: Tailor::start(move || repaint.request_repaint()),
            order: None,
            viewport: Viewport::new(),
            answers: None,
            context: context.clone(),
            is_lost,
            shelf,
        }
    }

    /// Whether the adapter is gone; asking lets the device tell.
    fn has_lost_device(&self, frame: &eframe::Frame) -> bool {
        if let Some(gpu) = frame.wgpu_render_state() {
            // A device that cannot be asked is lost, which its callback notes.
            drop(gpu.device.poll(wgpu::PollType::Poll));
        }
        self.is_lost.load(Ordering::Relaxed)
    }

    /// Everything that came from other threads since the last picture.
    fn receive(&mut self) {
        if let Some(snapshot) = self.sim.take() {
            self.studio.receive(snapshot);
        }
        let news: Vec<News> = self.sim.news().collect();
        for news in news {
            match news {
                News::Sewing => self.studio.sews = true,
                News::Sewn => self.studio.sews = false,
                News::Refused(sentence, kept) => self.studio.refused(sentence, *kept),
            }
        }
        if !self.sim.is_alive() {
            self.studio.message = Some(Message::trouble(&Sentence::new(
                "計算が止まってしまったので、最初から始めました。",
                "The simulation stopped unexpectedly; it was started anew.",
            )));
            self.sim = start(Design::default(), &self.context);
            self.studio.opened(Design::default(), None);
        }
        if let Some(paper) = self.tailor.take() {
            self.studio.paper = Some(paper);
        }
        self.receive_order();
        let answer = self.answers.as_ref().map(Receiver::try_recv);
        match answer {
            Some(Ok(path)) => {
                self.answers = None;
                self.answer(path);
            }
            Some(Err(mpsc::TryRecvError::Disconnected)) => self.answers = None,
            Some(Err(mpsc::TryRecvError::Empty)) | None => {}
        }
    }

    fn answer(&mut self, path: Option<PathBuf>) {
        if let (Some(path), Some(question)) = (path, &mut self.studio.question) {
            question.path = path.display().to_string();
        }
    }

    fn open_dropped(&mut self) {
        let dropped = self.context.input(|input| {
            let files = &input.raw.dropped_files;
            files.first().map(|file| file.path().to_owned())
        });
        if let Some(path) = dropped {
            let is_recording = path.extension().is_some_and(|extension| {
                ["bvh", "vrma"]
                    .iter()
                    .any(|known| extension.eq_ignore_ascii_case(known))
            });
            self.studio.request(if is_recording {
                Request::OpenRecording(path)
            } else {
                Request::Open(path)
            });
        }
    }

    fn serve(&mut self) {
        for request in self.studio.take_requests() {
            match request {
                Request::AskOpen => self.ask(Purpose::Open),
                Request::AskSave => self.ask(Purpose::Save),
                Request::AskRecording => self.ask(Purpose::Record),
                Request::Browse => self.browse(),
                Request::Open(path) => self.open(&path),
                Request::Save(path) => self.save(&path),
                Request::OpenRecording(path) => self.open_recording(&path),
                Request::Resume => self.resume(),
                Request::Discard => self.discard(),
                Request::Picture => self.take_picture(),
                Request::AskPicture(place) => self.ask(Purpose::Print(place)),
                Request::OpenPicture(place, path) => self.open_picture(place, &path),
                Request::AskRoster => self.ask(Purpose::Roster),
                Request::OpenRoster(path) => self.open_roster(&path),
                Request::WorkOutOrder => self.begin_order(None),
                Request::AskOrderFolder => self.ask(Purpose::Order),
                Request::MakeOrder(path) => self.begin_order(Some(path)),
                Request::CallOffOrder => {
                    if let Some(order) = &self.order {
                        order.call_off();
                    }
                }
            }
        }
        self.keep();
        self.tailor.ask(self.studio.design(), self.studio.cutting);
        for command in self.studio.take_commands() {
            self.sim.send(command);
        }
    }

    fn ask(&mut self, purpose: Purpose) {
        let folder = std::env::current_dir().unwrap_or_default();
        let path = match (self.studio.path(), purpose) {
            (Some(path), Purpose::Open | Purpose::Save) => path.to_owned(),
            (Some(path), Purpose::Order) => path.with_extension("").with_file_name("order"),
            (Some(path), _) => path.with_file_name(""),
            (None, Purpose::Save) => folder.join("design.lole"),
            (None, Purpose::Order) => folder.join("order"),
            (None, _) => folder.join(""),
        };
        self.studio.question = Some(Question {
            purpose,
            path: path.display().to_string(),
        });
    }

    /// The system's own dialog, on a thread of its own: the dance goes on behind it.
    fn browse(&mut self) {
        let Some(question) = &self.studio.question else {
            return;
        };
        if self.answers.is_some() {
            return;
        }
        let purpose = question.purpose;
        let (sender, answers) = mpsc::channel();
        let context = self.context.clone();
        let ask = move || {
            let dialog = rfd::FileDialog::new();
            let designs = |dialog: rfd::FileDialog| dialog.add_filter("Lole", &["lole"]);
            let path = match purpose {
                Purpose::Open => designs(dialog).pick_file(),
                Purpose::Save => designs(dialog).set_file_name("design.lole").save_file(),
                Purpose::Record => dialog
                    .add_filter("BVH, VRMA, glTF, VRM", &RECORDING_ENDINGS)
                    .pick_file(),
                Purpose::Print(_) => {
                    let kinds = ["png", "jpg", "jpeg", "svg", "PNG", "JPG", "JPEG", "SVG"];
                    dialog.add_filter("PNG, JPEG, SVG", &kinds).pick_file()
                }
                Purpose::Roster => dialog
                    .add_filter("CSV", &["csv", "CSV", "tsv", "txt"])
                    .pick_file(),
                Purpose::Order => dialog.pick_folder(),
            };
            // The window may have been closed meanwhile.
            drop(sender.send(path));
            context.request_repaint();
        };
        if cfg!(target_os = "macos") {
            // There, dialogs belong to the main thread.
            ask();
        } else {
            drop(
                std::thread::Builder::new()
                    .name("dialog".to_owned())
                    .spawn(ask),
            );
        }
        self.answers = Some(answers);
    }

    fn open(&mut self, path: &Path) {
        match files::read_design(path) {
            Ok(design) => {
                self.studio.message = None;
                self.studio.opened(design, Some(path.to_owned()));
            }
            Err(sentence) => self.studio.message = Some(Message::trouble(&sentence)),
        }
    }

    /// Dances a recording instead of the steps.
    fn open_recording(&mut self, path: &Path) {
        let name = files::recording_name(path, self.studio.path());
        match files::read_linked(path, "[motion] file") {
            Ok(bytes) => {
                self.studio.message = None;
                let bytes = Some(bytes);
                self.studio.change(|design| {
                    design.motion.file = Some(LinkedFile { name, bytes });
                    // The name of an animation belongs to its file.
                    design.motion.clip.clear();
                });
                self.studio.rest();
            }
            Err(sentence) => self.studio.message = Some(Message::trouble(&sentence)),
        }
    }

    /// Prints a picture on the skirt or on a garment of the list.
    fn open_picture(&mut self, place: Option<usize>, path: &Path) {
        let name = files::recording_name(path, self.studio.path());
        match files::read_picture(path, "[print] file") {
            Ok(picture) => {
                self.studio.message = None;
                let file = LinkedPicture {
                    name,
                    picture: Some(picture),
                };
                self.studio.change(|design| {
                    let print = match place {
                        Some(place) => design.garments.get_mut(place).map(|it| &mut it.print),
                        None => Some(&mut design.print),
                    };
                    if let Some(print) = print {
                        print.file = Some(file);
                        print.marks = PhotoMarks::default();
                    }
                });
                self.studio.rest();
            }
            Err(sentence) => self.studio.message = Some(Message::trouble(&sentence)),
        }
    }

    fn open_roster(&mut self, path: &Path) {
        match ordering::read_list(path) {
            Ok(list) => {
                self.studio.message = None;
                self.studio.order.list = Some((path.to_owned(), Arc::new(list)));
                self.studio.order.totals = None;
                self.begin_order(None);
            }
            Err(sentence) => self.studio.message = Some(Message::trouble(&sentence)),
        }
    }

    /// Cuts the design for everybody on the list, and writes the order where there is a folder.
    fn begin_order(&mut self, folder: Option<PathBuf>) {
        let Some((_, list)) = &self.studio.order.list else {
            return;
        };
        if let Err(error) = self.studio.check() {
            self.studio.message = Some(Message::trouble(&error));
            return;
        }
        let stem = self.studio.path().and_then(Path::file_stem);
        let title = stem.map_or_else(
            || "Pāʻū".to_owned(),
            |stem| lole_export::pdf::printable(&stem.to_string_lossy()),
        );
        let job = Job {
            design: self.studio.design().clone(),
            list: Arc::clone(list),
            wishes: self.studio.order.wishes,
            folder,
            title,
            language: self.studio.language,
        };
        let context = self.context.clone();
        // One that is still at work is called off and waited for, a moment at most.
        self.order = None;
        self.order = Some(OrderWork::begin(job, move || context.request_repaint()));
    }

    fn receive_order(&mut self) {
        let news: Vec<OrderNews> = self.order.iter().flat_map(OrderWork::news).collect();
        for news in news {
            let ends = !matches!(news, OrderNews::Progress(_));
            match news {
                OrderNews::Progress(progress) => self.studio.order.progress = Some(progress),
                OrderNews::Done(totals, folder) => {
                    self.studio.order.totals = Some(totals);
                    if let Some(folder) = folder {
                        let folder = std::fs::canonicalize(&folder).unwrap_or(folder);
                        let name = folder.display();
                        self.studio.message = Some(Message::news(
                            format!(
                                "注文書を書きました: {name}（order.pdf を開いて印刷してください）"
                            ),
                            format!("The order is in {name}; open order.pdf to print it"),
                        ));
                    }
                }
                OrderNews::Failed(sentence) => {
                    self.studio.message = Some(Message::trouble(&sentence));
                }
                OrderNews::CalledOff => {
                    self.studio.message = Some(Message::news(
                        "注文をやめました。何も書いていません。",
                        "The order was called off; nothing was written.",
                    ));
                }
            }
            if ends {
                self.studio.order.progress = None;
                self.order = None;
            }
        }
    }

    fn resume(&mut self) {
        self.studio.found = None;
        if let Some(leftover) = self.keeping.leftover.take() {
            self.studio.resume(leftover.work.clone());
            leftover.discard();
        }
    }

    fn discard(&mut self) {
        self.studio.found = None;
        if let Some(leftover) = self.keeping.leftover.take() {
            leftover.discard();
        }
    }

    /// Keeps a copy of the work where it is in no file.
    fn keep(&mut self) {
        let Some(journal) = &self.keeping.journal else {
            return;
        };
        if let Some(sentence) = journal.trouble() {
            self.studio.message = Some(Message::trouble(&sentence));
        }
        if let Some(work) = self.studio.take_work() {
            if work.is_unsaved() {
                journal.keep(work);
            } else {
                journal.clear();
            }
        }
    }

    fn save(&mut self, path: &Path) {
        let path = path.with_extension("lole");
        if let Err(error) = self.studio.check() {
            // It could not be opened again.
            self.studio.message = Some(Message::trouble(&error));
            return;
        }
        self.rename_linked(&path);
        match files::write_design(&path, self.studio.design()) {
            Ok(()) => {
                let path = std::fs::canonicalize(&path).unwrap_or(path);
                let name = path.display();
                self.studio.message = Some(Message::news(
                    format!("保存しました: {name}"),
                    format!("Saved: {name}"),
                ));
                self.studio.saved_at(path);
            }
            Err(sentence) => self.studio.message = Some(Message::trouble(&sentence)),
        }
    }

    /// Names recording and pictures as they are found from where the design is saved.
    fn rename_linked(&mut self, saved: &Path) {
        let from = self.studio.path().unwrap_or(Path::new("")).to_owned();
        self.studio.rename_linked(|name| {
            let place = from.with_file_name(name);
            files::recording_name(&place, Some(saved))
        });
    }

    fn take_picture(&mut self) {
        let Some(image) = self.viewport.picture() else {
            return;
        };
        let folder = std::env::current_dir().unwrap_or_default();
        let failed = |error: lole_render::RenderError| {
            let text = error.to_string();
            Sentence::new(format!("写真を撮れません（{text}）"), text)
        };
        let path = files::free_picture(&folder);
        let written = image.map_err(failed).and_then(|image| {
            files::write_whole(&path, &png(&image)?)?;
            Ok(std::fs::canonicalize(&path).unwrap_or(path))
        });
        self.studio.message = Some(match written {
            Ok(path) => {
                let name = path.display();
                Message::news(
                    format!("写真を書きました: {name}"),
                    format!("The picture is in {name}"),
                )
            }
            Err(sentence) => Message::trouble(&sentence),
        });
    }

    /// Takes steps back and does other things that have keys, unless something is being typed.
    fn follow_keys(&mut self) {
        if self.context.egui_wants_keyboard_input() {
            return;
        }
        let pressed =
            |modifiers, key| (self.context).input_mut(|input| input.consume_key(modifiers, key));
        let shifted = egui::Modifiers::COMMAND | egui::Modifiers::SHIFT;
        // The one with more keys first: it would also pass for the other.
        if pressed(shifted, egui::Key::Z) || pressed(egui::Modifiers::COMMAND, egui::Key::Y) {
            self.studio.redo();
        } else if pressed(egui::Modifiers::COMMAND, egui::Key::Z) {
            self.studio.undo();
        } else if pressed(egui::Modifiers::COMMAND, egui::Key::S) {
            self.studio.request_saving();
        } else if pressed(egui::Modifiers::COMMAND, egui::Key::O) {
            self.studio.request(Request::AskOpen);
        }
    }

    /// Sends what waited until the hand left the slider.
    fn rest(&mut self) {
        if !self.context.input(|input| input.pointer.any_down()) {
            self.studio.rest();
        }
    }

    fn columns(&mut self, ui: &mut Ui) {
        let width = ui.available_width();
        let side = egui::Frame::new().fill(look::PAPER).inner_margin(12);
        if width < NARROW {
            let height = 0.45 * ui.available_height();
            egui::Panel::bottom("all")
                .frame(side)
                .exact_size(height)
                .show(ui, |ui| panel::one_column(ui, &mut self.studio));
        } else if width < WIDE {
            egui::Panel::left("all")
                .frame(side)
                .exact_size(COLUMNS[0])
                .show(ui, |ui| panel::one_column(ui, &mut self.studio));
        } else {
            egui::Panel::left("left")
                .frame(side)
                .exact_size(COLUMNS[0])
                .show(ui, |ui| panel::left_column(ui, &mut self.studio));
            egui::Panel::right("right")
                .frame(side)
                .exact_size(COLUMNS[1])
                .show(ui, |ui| panel::right_column(ui, &mut self.studio));
        }
    }

    fn picture(&mut self, ui: &mut Ui, frame: &eframe::Frame) {
        let area = ui.max_rect();
        self.viewport
            .show(ui, &mut self.studio, frame.wgpu_render_state());
        let mut over = ui.new_child(egui::UiBuilder::new().max_rect(area.shrink(4.0)));
        panel::notices(&mut over, &mut self.studio);
    }
}

impl Drop for App {
    fn drop(&mut self) {
        // Closed without saving is not lost: the next window offers it.
        self.studio.rest();
        self.keep();
        if self.is_lost.load(Ordering::Relaxed) {
            let empty = Studio::new(self.studio.language, Design::default(), None);
            let rescued = Rescued {
                studio: std::mem::replace(&mut self.studio, empty).anew(),
                keeping: std::mem::take(&mut self.keeping),
            };
            *self.shelf.lock().unwrap_or_else(PoisonError::into_inner) = Some(rescued);
        }
    }
}

impl eframe::App for App {
    fn logic(&mut self, _context: &Context, _frame: &mut eframe::Frame) {
        self.receive();
    }

    fn ui(&mut self, ui: &mut Ui, frame: &mut eframe::Frame) {
        if self.has_lost_device(frame) {
            // Nothing more is drawn: egui's painter would panic.
            self.context.send_viewport_cmd(egui::ViewportCommand::Close);
            return;
        }
        self.open_dropped();
        self.follow_keys();
        let bar = egui::Frame::new().fill(look::CARD).inner_margin(8);
        egui::Panel::top("document")
            .frame(bar)
            .show(ui, |ui| panel::document_bar(ui, &mut self.studio));
        egui::Panel::bottom("status")
            .frame(bar.inner_margin(egui::Margin::symmetric(10, 4)))
            .show(ui, |ui| panel::status_bar(ui, &mut self.studio));
        self.columns(ui);
        egui::CentralPanel::default()
            .frame(egui::Frame::NONE)
            .show(ui, |ui| self.picture(ui, frame));
        panel::enlarged(ui, &mut self.studio);
        panel::question(ui, &mut self.studio);
        self.rest();
        self.serve();
    }

    fn clear_color(&self, _visuals: &egui::Visuals) -> [f32; 4] {
        look::PAPER.to_normalized_gamma_f32()
    }
}

/// Notes when the device is lost. Errors that nobody asked for are not the end of the program: the
/// picture is drawn again and again, and says what is wrong with it.
fn watch_device(device: &wgpu::Device, is_lost: &Arc<AtomicBool>, context: &Context) {
    device.on_uncaptured_error(Arc::new(|_| {}));
    let (is_lost, context) = (Arc::clone(is_lost), context.clone());
    device.set_device_lost_callback(move |_, _| {
        is_lost.store(true, Ordering::Relaxed);
        context.request_repaint();
    });
}

fn start(design: Design, context: &Context) -> Sim {
    let context = context.clone();
    Sim::start(design, Arc::new(move || context.request_repaint()))
}

/// A picture as the bytes of a PNG.
fn png(image: &lole_render::Image) -> Result<Vec<u8>, Sentence> {
    ImageView::new(image.width, image.height, &image.pixels)
        .and_then(still::encode_png)
        .map_err(|error| Sentence::new(format!("写真を作れません（{error}）"), error.to_string()))
}
