//! The simulation in a worker. What must be sewn is sewn by an understudy, a second worker, while the first
//! dances on; when it is dressed it takes the stage, and the first one ends.

use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, VecDeque};
use std::rc::Rc;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::sync::mpsc::{self, Receiver, Sender};

use lole_costume::document::Design;
use wasm_bindgen::JsCast as _;
use wasm_bindgen::closure::Closure;
use web_sys::MessageChannel;

use super::browser;
use super::worker::{Wake, Worker, answer, hear, scope};
use crate::command::Watch;
use crate::platform::fineness::danced;
use crate::platform::letters::{
    get_command, get_design, get_file, get_news, get_snapshot, get_wardrobe, put_command,
    put_design, put_news, put_snapshot, put_wardrobe,
};
use crate::platform::parcel::{Packer, Unpacker};
use crate::sim::sewing::{Entrance, Sewn, sew};
use crate::sim::stagehand::{Rest, Stagehand};
use crate::sim::{Input, News, Outbox};
use crate::snapshot::Wardrobe;
use crate::{Command, Snapshot};

/// What the worker is called.
pub(super) const ROLE: &str = "stage";

/// First byte of what the page sends.
mod asked {
    pub(super) const FILE: u8 = 0;
    pub(super) const SETTLING: u8 = 1;
    pub(super) const SETTLED: u8 = 2;
    pub(super) const COMMAND: u8 = 3;
    pub(super) const TAKEN: u8 = 4;
}

/// First byte of what the worker sends.
mod told {
    pub(super) const NEWS: u8 = 0;
    pub(super) const WARDROBE: u8 = 1;
    pub(super) const SNAPSHOT: u8 = 2;
}

/// Designs that are remembered as the studio has them: one on stage, one that is sewn, and wishes in between.
const MOST_SENT: usize = 16;

/// The simulation as the page sees it.
pub(crate) struct Sim(RefCell<Stage>);

struct Stage {
    wake: Wake,
    dancing: Option<Player>,
    understudy: Option<Player>,
    /// What goes on while the understudy sews.
    kept: Design,
    /// Designs that were sent, the newest last, as the studio has them.
    sent: VecDeque<Design>,
    news: VecDeque<News>,
    plays: bool,
    speed: f64,
    watch: Watch,
}

/// A worker with what came from it.
struct Player {
    worker: Worker,
    wardrobes: BTreeMap<u64, Arc<Wardrobe>>,
    snapshot: Option<Arc<Snapshot>>,
}

impl Player {
    fn start(design: &Design, entrance: u8, wake: &Wake) -> Option<Self> {
        let worker = Worker::start(ROLE, wake)?;
        worker.lay_linked(design, asked::FILE);
        let mut parcel = Packer::default();
        parcel.put(entrance);
        put_design(&mut parcel, design);
        worker.post(&parcel);
        Some(Self {
            worker,
            wardrobes: BTreeMap::new(),
            snapshot: None,
        })
    }

    fn send(&self, command: &Command) {
        if let Command::Wish(design) = command {
            self.worker.lay_linked(design, asked::FILE);
        }
        let mut parcel = Packer::default();
        parcel.put(asked::COMMAND);
        put_command(&mut parcel, command);
        self.worker.post(&parcel);
    }

    /// Takes in what came; the news.
    fn receive(&mut self) -> Vec<News> {
        let mut news = Vec::new();
        while let Some(parcel) = self.worker.receive() {
            let mut parcel = Unpacker(&parcel);
            match parcel.get::<u8>() {
                Some(told::NEWS) => news.extend(get_news(&mut parcel)),
                Some(told::WARDROBE) => {
                    if let Some(wardrobe) = get_wardrobe(&mut parcel) {
                        // The one before may still be in a snapshot; earlier ones are not.
                        while 1 < self.wardrobes.len() {
                            self.wardrobes.pop_first();
                        }
                        let named = Wardrobe {
                            id: fresh_id(),
                            ..wardrobe
                        };
                        self.wardrobes.insert(wardrobe.id, Arc::new(named));
                    }
                }
                Some(told::SNAPSHOT) => {
                    self.snapshot = get_snapshot(&mut parcel, &self.wardrobes).map(Arc::new);
                }
                _ => {}
            }
        }
        news
    }

    fn take(&mut self) -> Option<Arc<Snapshot>> {
        let snapshot = self.snapshot.take()?;
        browser::note(if snapshot.time < 0.0 {
            "settling"
        } else {
            "dancing"
        });
        let mut parcel = Packer::default();
        parcel.put(asked::TAKEN);
        self.worker.post(&parcel);
        Some(snapshot)
    }
}

/// A number that no other wardrobe of the page has: each worker counts its own.
fn fresh_id() -> u64 {
    thread_local!(static NEXT: Cell<u64> = const { Cell::new(1) });
    NEXT.replace(NEXT.get() + 1)
}

impl Sim {
    /// Starts the show of `design`; `wake` is called whenever there is something new.
    pub(crate) fn start(design: Design, wake: Arc<dyn Fn() + Send + Sync>) -> Self {
        let wake: Wake = Rc::new(move || wake());
        Self(RefCell::new(Stage {
            dancing: Player::start(&danced(&design), asked::SETTLING, &wake),
            wake,
            understudy: None,
            kept: design.clone(),
            sent: VecDeque::from([design]),
            news: VecDeque::new(),
            plays: true,
            speed: 1.0,
            watch: Watch::default(),
        }))
    }

    /// Sends a wish.
    pub(crate) fn send(&self, command: Command) {
        let mut stage = self.0.borrow_mut();
        let command = match command {
            Command::Wish(design) => {
                let quick = danced(&design);
                stage.note_sent(*design);
                Command::Wish(Box::new(quick))
            }
            command => command,
        };
        match &command {
            Command::Play => stage.plays = true,
            Command::Pause | Command::Step => stage.plays = false,
            Command::Speed(speed) => stage.speed = *speed,
            Command::Watch(watch) => stage.watch = *watch,
            // What is sewn is no longer what is wished.
            Command::Wish(_) if stage.understudy.take().is_some() => {
                stage.news.push_back(News::Sewn)
            }
            _ => {}
        }
        if let Some(player) = &stage.dancing {
            player.send(&command);
        }
    }

    /// The newest snapshot, if there is one that was not taken yet.
    pub(crate) fn take(&self) -> Option<Arc<Snapshot>> {
        let mut stage = self.0.borrow_mut();
        stage.receive();
        stage.dancing.as_mut()?.take()
    }

    /// What was said since the last time.
    pub(crate) fn news(&self) -> impl Iterator<Item = News> {
        std::mem::take(&mut self.0.borrow_mut().news).into_iter()
    }

    /// Whether it works.
    pub(crate) fn is_alive(&self) -> bool {
        let stage = self.0.borrow();
        (stage.dancing.as_ref()).is_some_and(|player| !player.worker.has_failed())
    }
}

impl Stage {
    fn receive(&mut self) {
        let said = self
            .dancing
            .as_mut()
            .map(Player::receive)
            .unwrap_or_default();
        for news in said {
            match news {
                News::Refused(sentence, kept) => {
                    let kept = Box::new(self.as_sent(*kept));
                    self.news.push_back(News::Refused(sentence, kept));
                }
                News::Elsewhere(wished, kept) => {
                    self.kept = self.as_sent(*kept);
                    self.understudy = Player::start(&wished, asked::SETTLED, &self.wake);
                }
                news => self.news.push_back(news),
            }
        }
        let said = self
            .understudy
            .as_mut()
            .map(Player::receive)
            .unwrap_or_default();
        for news in said {
            match news {
                News::Sewn => {
                    self.dancing = self.understudy.take();
                    self.instruct();
                    self.news.push_back(News::Sewn);
                }
                News::Refused(sentence, _) => {
                    self.understudy = None;
                    let kept = Box::new(self.kept.clone());
                    self.news.push_back(News::Refused(sentence, kept));
                }
                // That it sews was told by the one on stage.
                News::Sewing | News::Elsewhere(..) => {}
            }
        }
        if (self.understudy.as_ref()).is_some_and(|player| player.worker.has_failed()) {
            self.understudy = None;
            let kept = Box::new(self.kept.clone());
            let sentence = crate::making::stopped_unexpectedly();
            self.news.push_back(News::Refused(sentence, kept));
        }
    }

    fn note_sent(&mut self, design: Design) {
        self.sent.push_back(design);
        while MOST_SENT < self.sent.len() {
            self.sent.pop_front();
        }
    }

    /// The studio's design of one that a worker has.
    fn as_sent(&self, quick: Design) -> Design {
        let mut sent = self.sent.iter().rev();
        sent.find(|sent| danced(sent) == quick)
            .cloned()
            .unwrap_or(quick)
    }

    /// Tells whoever takes the stage what was asked of the one before.
    fn instruct(&self) {
        let Some(player) = &self.dancing else { return };
        player.send(&Command::Watch(self.watch));
        player.send(&Command::Speed(self.speed));
        if !self.plays {
            player.send(&Command::Pause);
        }
    }
}

/// Sewing in a worker: whoever has nothing on stage sews at once, and others leave it to an understudy.
pub(crate) struct Sewing;

impl Sewing {
    /// Sews, or says that somebody else must.
    pub(crate) fn begin(
        (design, entrance): (Design, Entrance),
        on_stage: Option<&Design>,
        inputs: &Sender<Input>,
        outbox: &dyn Outbox,
    ) -> Option<Self> {
        if let Some(kept) = on_stage {
            outbox.say(News::Elsewhere(Box::new(design), Box::new(kept.clone())));
            return None;
        }
        let show = sew(&design, entrance, &AtomicBool::new(false));
        // It is taken in before the next frame.
        drop(inputs.send(Input::Sewn(Box::new(Sewn { design, show }))));
        Some(Self)
    }

    /// Nothing: a worker that sews is ended as a whole.
    pub(crate) const fn call_off(&self) {}
}

/// Sends what there is to show to the page.
struct ToPage {
    is_taken: Rc<Cell<bool>>,
    wardrobe: Cell<u64>,
}

impl Outbox for ToPage {
    fn is_empty(&self) -> bool {
        self.is_taken.get()
    }

    fn post(&self, snapshot: Snapshot) {
        if self.wardrobe.replace(snapshot.wardrobe.id) != snapshot.wardrobe.id {
            let mut parcel = Packer::default();
            parcel.put(told::WARDROBE);
            put_wardrobe(&mut parcel, &snapshot.wardrobe);
            answer(&parcel);
        }
        let mut parcel = Packer::default();
        parcel.put(told::SNAPSHOT);
        put_snapshot(&mut parcel, &snapshot);
        self.is_taken.set(false);
        answer(&parcel);
    }

    fn say(&self, news: News) {
        let mut parcel = Packer::default();
        parcel.put(told::NEWS);
        put_news(&mut parcel, &news);
        answer(&parcel);
    }
}

/// The worker's own side.
struct Work {
    hand: RefCell<Option<Stagehand>>,
    inputs: Sender<Input>,
    received: Receiver<Input>,
    is_taken: Rc<Cell<bool>>,
    /// Its next turn, where one is waited for.
    timer: Cell<Option<i32>>,
    turns: MessageChannel,
    /// Whether a turn is on its way through the channel.
    is_due: Cell<bool>,
    ticks: RefCell<Option<Closure<dyn FnMut()>>>,
}

/// Works as the simulation until the page ends it.
pub(super) fn serve() {
    let Ok(turns) = MessageChannel::new() else {
        return;
    };
    let (inputs, received) = mpsc::channel();
    let work = Rc::new(Work {
        hand: RefCell::default(),
        inputs,
        received,
        is_taken: Rc::new(Cell::new(true)),
        timer: Cell::default(),
        turns,
        is_due: Cell::default(),
        ticks: RefCell::default(),
    });
    let own = Rc::clone(&work);
    let tick = Closure::<dyn FnMut()>::new(move || own.turn());
    work.turns
        .port2()
        .set_onmessage(Some(tick.as_ref().unchecked_ref()));
    *work.ticks.borrow_mut() = Some(tick);
    hear(move |parcel| work.hear(parcel));
}

impl Work {
    fn hear(&self, parcel: &[u8]) {
        let mut parcel = Unpacker(parcel);
        let head = parcel.get::<u8>();
        let begin = |parcel: &mut Unpacker<'_>, entrance| {
            let outbox = Box::new(ToPage {
                is_taken: Rc::clone(&self.is_taken),
                wardrobe: Cell::new(0),
            });
            let design = get_design(parcel)?;
            let hand = Stagehand::new(design, entrance, self.inputs.clone(), outbox);
            *self.hand.borrow_mut() = Some(hand);
            Some(())
        };
        let heard = match head {
            Some(asked::FILE) => {
                // A parcel that is broken lays nothing down.
                get_file(&mut parcel);
                None
            }
            Some(asked::SETTLING) => begin(&mut parcel, Entrance::Settling),
            Some(asked::SETTLED) => begin(&mut parcel, Entrance::Settled),
            Some(asked::COMMAND) => get_command(&mut parcel)
                .and_then(|command| self.inputs.send(Input::Wanted(command)).ok()),
            Some(asked::TAKEN) => {
                self.is_taken.set(true);
                Some(())
            }
            _ => None,
        };
        if heard.is_some() {
            self.call(None);
        }
    }

    /// Has the next turn taken in so many seconds, or as soon as what was sent meanwhile was heard.
    fn call(&self, seconds: Option<f64>) {
        if let Some(timer) = self.timer.take() {
            scope().clear_timeout_with_handle(timer);
        }
        let Some(seconds) = seconds else {
            if !self.is_due.replace(true) {
                // A channel has no least delay as timers have.
                drop(self.turns.port1().post_message(&0.into()));
            }
            return;
        };
        #[expect(
            clippy::cast_possible_truncation,
            reason = "a rest is shorter than a second"
        )]
        let milliseconds = (seconds * 1e3) as i32;
        let ticks = self.ticks.borrow();
        let Some(tick) = ticks.as_ref() else { return };
        let handler = tick.as_ref().unchecked_ref();
        let timer =
            scope().set_timeout_with_callback_and_timeout_and_arguments_0(handler, milliseconds);
        self.timer.set(timer.ok());
    }

    fn turn(&self) {
        self.is_due.set(false);
        self.timer.set(None);
        let mut hand = self.hand.borrow_mut();
        let Some(hand) = hand.as_mut() else { return };
        match hand.turn(&self.received) {
            Rest::None => self.call(None),
            Rest::Until(seconds) => self.call(Some(seconds)),
            Rest::Called => {}
            Rest::Ended => scope().close(),
        }
    }
}
