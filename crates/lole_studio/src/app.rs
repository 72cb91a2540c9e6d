//! The window itself: panels, picture, simulation and files brought together.

mod products;

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::Receiver;
use std::sync::{Arc, Mutex, PoisonError};

use eframe::egui::{self, Context, Ui};
use lole_costume::document::{Design, LinkedFile, LinkedPicture, PhotoMarks};
use lole_files as files;
use lole_garment::template::PAU_SKIRT;
use lole_language::Sentence;
use lole_render::{Image, wgpu};

use crate::chooser::ends_with_one_of;
use crate::making::with_ending;
use crate::message::Message;
use crate::ordering::{self, Job, OrderNews};
use crate::platform::{self, Asking, Keeping, Maker, OrderWork, Sim, Tailor};
use crate::sim::News;
use crate::studio::{Purpose, Request, Tab};
use crate::viewport::Viewport;
use crate::{Studio, look, panel};

/// The running window.
pub(crate) struct App {
    pub(crate) studio: Studio,
    sim: Sim,
    tailor: Tailor,
    order: Option<OrderWork>,
    maker: Maker,
    pub(crate) asking: Asking,
    /// Folders that are being shown.
    reveals: Vec<Receiver<Sentence>>,
    /// The picture as it was when its button was pressed.
    taken: Option<Image>,
    viewport: Viewport,
    keeping: Keeping,
    pub(crate) context: Context,
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

impl App {
    pub(crate) fn new(
        work: Rescued,
        creation: &eframe::CreationContext<'_>,
        is_lost: Arc<AtomicBool>,
        shelf: Shelf,
    ) -> Self {
        let context = &creation.egui_ctx;
        look::apply(context);
        #[cfg(not(target_arch = "wasm32"))]
        look::bring_letters(context);
        if let Some(gpu) = &creation.wgpu_render_state {
            watch_device(&gpu.device, &is_lost, context);
        }
        let Rescued { studio, keeping } = work;
        if let Some(size) = studio.memory.size {
            context.set_zoom_factor(size);
        }
        let sim = start(studio.design().clone(), context);
        let [repaint, news] = [context.clone(), context.clone()];
        // Cards of a window before keep their numbers.
        let last_number = studio.making.last_number();
        let maker = Maker::start(last_number, move || news.request_repaint());
        let mut app = Self {
            keeping,
            studio,
            sim,
            tailor: Tailor::start(move || repaint.request_repaint()),
            order: None,
            maker,
            asking: Asking::default(),
            reveals: Vec::new(),
            taken: None,
            viewport: Viewport::new(),
            context: context.clone(),
            is_lost,
            shelf,
        };
        app.find_roster();
        app
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
                // Whoever starts the simulation has seen to it.
                News::Elsewhere(..) => {}
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
        self.receive_products();
        self.receive_answers();
    }

    /// A file that was dropped on the window is taken for what its name says.
    fn open_dropped(&mut self) {
        if let Some(path) = platform::take_dropped(&self.context) {
            let ends_with = |endings: &[&str]| ends_with_one_of(&path, endings);
            self.studio.starts = false;
            let request = if ends_with(&["bvh", "vrma"]) {
                Request::OpenRecording(path)
            } else if ends_with(Purpose::Roster.endings()) {
                self.studio.tab = Tab::Order;
                Request::OpenRoster(path)
            } else {
                Request::Open(path)
            };
            self.studio.request(request);
        }
    }

    fn serve(&mut self) {
        for request in self.studio.take_requests() {
            let answered = self.studio.answered.take();
            match answered {
                Some(question) if question.request().as_ref() == Some(&request) => {
                    self.find_out(question);
                }
                other => {
                    self.studio.answered = other;
                    self.follow(request);
                }
            }
        }
        self.keep();
        self.remember();
        self.tailor.ask(self.studio.design(), self.studio.cutting);
        for command in self.studio.take_commands() {
            self.sim.send(command);
        }
    }

    /// Does what was asked for.
    pub(crate) fn follow(&mut self, request: Request) {
        match request {
            Request::AskOpen => self.ask(Purpose::Open),
            Request::AskSave => self.ask(Purpose::Save),
            Request::AskRecording => self.ask(Purpose::Record),
            Request::Browse => self.browse(),
            Request::ListFolder(folder) => self.list_folder(folder),
            Request::Open(path) => self.open(&path),
            Request::Save(path) => self.save(&path),
            Request::OpenRecording(path) => self.open_recording(&path),
            Request::Resume => self.resume(),
            Request::Discard => self.discard(),
            Request::Picture => self.take_picture(),
            Request::SavePicture(path) => self.save_picture(&path),
            Request::AskMake(product) => self.ask(Purpose::Make(product)),
            Request::Make(product, path) => self.make(product, &path),
            Request::CallOff(number) => self.maker.call_off(number),
            Request::Reveal(path) => self.reveal(&path),
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

    fn open(&mut self, path: &Path) {
        if ends_with_one_of(path, Purpose::Print(None).endings()) {
            self.print(path);
            return;
        }
        match files::read_design(path) {
            Ok(design) => {
                self.studio.message = None;
                self.studio.opened(design, Some(path.to_owned()));
                let whole = std::fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
                self.studio.memory.note_design(&whole);
            }
            Err(sentence) => self.studio.message = Some(Message::trouble(&sentence)),
        }
    }

    /// A picture that was given as if it were a design is printed on what is worn.
    fn print(&mut self, path: &Path) {
        let Some(place) = panel::first_of_cloth(&self.studio) else {
            self.studio.message = Some(Message::trouble(&Sentence::new(
                "いま着ているものに布で作るものがないので、写真を柄にできません。",
                "Nothing that is worn is made of cloth, so the picture cannot be printed on it.",
            )));
            return;
        };
        let design = self.studio.design();
        let garment = place.map_or(PAU_SKIRT.name, |place| design.garments[place].name());
        self.studio.message = None;
        self.open_picture(place, path);
        if self.studio.message.is_none() {
            self.studio.starts = false;
            self.studio.tab = Tab::Cloth;
            let [japanese, english] = [garment.japanese, garment.english];
            self.studio.message = Some(Message::news(
                format!(
                    "写真を{japanese}の柄にしました。「布と柄」で大きさを合わせます。「元に戻す」でやめられます。"
                ),
                format!(
                    "The picture is printed on the {english} now; set its size under “Cloth”, or press Undo."
                ),
            ));
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
                self.studio.starts = false;
                self.studio.order.list = Some((path.to_owned(), Arc::new(list)));
                self.studio.memory.roster = std::fs::canonicalize(path).ok();
                self.studio.order.totals = None;
                self.begin_order(None);
            }
            Err(sentence) => self.studio.message = Some(Message::trouble(&sentence)),
        }
    }

    /// Cuts the design for everybody on the list, and writes the order where there is a folder.
    fn begin_order(&mut self, folder: Option<PathBuf>) {
        let Some(list) = self.studio.order.list.clone() else {
            return;
        };
        if let Err(error) = self.studio.check() {
            self.studio.message = Some(Message::trouble(&error));
            return;
        }
        let job = Job {
            design: self.studio.design().clone(),
            list,
            wishes: self.studio.order.wishes,
            folder,
            title: self.title(),
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
                        let news = Message::news(
                            format!(
                                "注文書を書きました: {name}（order.pdf を開いて印刷してください）"
                            ),
                            format!("The order is in {name}; open order.pdf to print it"),
                        );
                        self.studio.message = Some(news.at(&folder));
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
        if let Some(work) = self.keeping.take_found() {
            self.studio.resume(work);
        }
    }

    fn discard(&mut self) {
        self.studio.found = None;
        drop(self.keeping.take_found());
    }

    /// Keeps a copy of the work where it is in no file.
    fn keep(&mut self) {
        if let Some(sentence) = self.keeping.trouble() {
            self.studio.message = Some(Message::trouble(&sentence));
        }
        if let Some(work) = self.studio.take_work() {
            self.keeping.keep(work);
        }
    }

    /// Keeps for the next window what was chosen in this one.
    fn remember(&mut self) {
        let memory = &mut self.studio.memory;
        let size = self.context.zoom_factor();
        let is_usual = (size - 1.0).abs() < 1e-3;
        memory.size = (!is_usual || memory.size.is_some()).then_some(size);
        self.keeping.remember(memory);
    }

    fn save(&mut self, path: &Path) {
        let path = with_ending(path, "lole");
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
                self.studio.memory.note_design(&path);
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

/// A picture that took longer does not make what is seen again leap [s].
const LONGEST_PICTURE: f64 = 0.5;

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
        let seconds = f64::from(self.context.input(|input| input.stable_dt));
        if self.studio.replay_on(seconds.min(LONGEST_PICTURE)) {
            self.context.request_repaint();
        }
        let Self {
            studio, viewport, ..
        } = self;
        let gpu = frame.wgpu_render_state();
        panel::frame(ui, studio, |ui, studio| {
            let area = ui.max_rect();
            viewport.show(ui, studio, gpu);
            let mut over = ui.new_child(egui::UiBuilder::new().max_rect(area.shrink(4.0)));
            panel::notices(&mut over, studio);
        });
        panel::enlarged(ui, &mut self.studio);
        panel::start(ui, &mut self.studio);
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
