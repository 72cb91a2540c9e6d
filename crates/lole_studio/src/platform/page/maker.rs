//! Products made one after the other in a worker, and handed out as downloads.

use std::collections::VecDeque;
use std::rc::Rc;
use std::sync::atomic::AtomicBool;

use lole_pattern::marker::Lay;

use super::worker::{Wake, Worker, answer, answer_written, hear, lay_written};
use crate::making::{Line, Piece, Product, Stage, Unmade, Wish, make, stopped_unexpectedly};
use crate::paper::Cutting;
use crate::platform::letters::{
    get_design, get_file, get_language, get_paper, get_sentence, put_design, put_language,
    put_paper, put_sentence,
};
use crate::platform::parcel::{Packer, Unpacker};

/// What the worker is called.
pub(super) const ROLE: &str = "maker";

const FILE: u8 = 0;
const WISH: u8 = 1;

/// First byte of what the worker sends.
mod told {
    pub(super) const WORKING: u8 = 0;
    /// All files follow.
    pub(super) const DONE: u8 = 1;
    pub(super) const FAILED: u8 = 2;
}

/// Whoever makes one thing after the other. A worker is started for each, and ended when it is called off.
pub(crate) struct Maker {
    waiting: VecDeque<(u64, Wish)>,
    at_work: Option<(u64, Worker)>,
    news: Vec<(u64, Stage)>,
    called_off: Vec<u64>,
    count: u64,
    wake: Wake,
}

impl Maker {
    /// Begins with nothing to do; `wake` is called when there is news. Pieces are numbered from the one after
    /// `last_number`.
    pub(crate) fn start(last_number: u64, wake: impl Fn() + Send + 'static) -> Self {
        Self {
            waiting: VecDeque::new(),
            at_work: None,
            news: Vec::new(),
            called_off: Vec::new(),
            count: last_number,
            wake: Rc::new(wake),
        }
    }

    /// Asks for a product; it is made when those before it are.
    pub(crate) fn ask(&mut self, wish: Wish) -> Piece {
        self.count += 1;
        let piece = Piece {
            number: self.count,
            product: wish.product,
            path: wish.path.clone(),
            stage: Stage::Waiting,
        };
        self.waiting.push_back((self.count, wish));
        (self.wake)();
        piece
    }

    /// Calls a product off, whether it waits or is being made.
    pub(crate) fn call_off(&mut self, number: u64) {
        self.called_off.push(number);
        (self.wake)();
    }

    /// What was told since the last time.
    pub(crate) fn news(&mut self) -> Vec<(u64, Stage)> {
        for number in std::mem::take(&mut self.called_off) {
            let before = self.waiting.len();
            self.waiting.retain(|(of, _)| *of != number);
            let was_at_work = self.at_work.take_if(|(of, _)| *of == number).is_some();
            if was_at_work || self.waiting.len() < before {
                self.news.push((number, Stage::CalledOff));
            }
        }
        if let Some((number, worker)) = &self.at_work {
            let end = receive(*number, worker, &mut self.news);
            if end {
                self.at_work = None;
            }
        }
        if self.at_work.is_none()
            && let Some((number, wish)) = self.waiting.pop_front()
        {
            match begin(&wish, &self.wake) {
                Some(worker) => self.at_work = Some((number, worker)),
                None => (self.news).push((number, Stage::Failed(stopped_unexpectedly()))),
            }
        }
        std::mem::take(&mut self.news)
    }
}

fn begin(wish: &Wish, wake: &Wake) -> Option<Worker> {
    let worker = Worker::start(ROLE, wake)?;
    worker.lay_linked(&wish.design, FILE);
    let mut parcel = Packer::default();
    parcel.put(WISH);
    put_wish(&mut parcel, wish);
    worker.post(&parcel);
    Some(worker)
}

/// Takes in what came; whether it has ended.
fn receive(number: u64, worker: &Worker, news: &mut Vec<(u64, Stage)>) -> bool {
    while let Some(parcel) = worker.receive() {
        let mut parcel = Unpacker(&parcel);
        let stage = match parcel.get::<u8>() {
            Some(told::WORKING) => Stage::Working(parcel.get().unwrap_or(0.0)),
            Some(told::DONE) => {
                lay_written(&mut parcel);
                Stage::Done
            }
            _ => Stage::Failed(get_sentence(&mut parcel).unwrap_or_else(stopped_unexpectedly)),
        };
        let ends = stage.is_end();
        news.push((number, stage));
        if ends {
            return true;
        }
    }
    if worker.has_failed() {
        news.push((number, Stage::Failed(stopped_unexpectedly())));
    }
    worker.has_failed()
}

fn put_wish(packer: &mut Packer, wish: &Wish) {
    packer.text(&wish.path.to_string_lossy());
    packer.count(wish.product as usize);
    put_paper(packer, wish.paper);
    packer.flag(wish.cutting.lay == Lay::Folded);
    packer.flag(wish.cutting.matches_print);
    put_language(packer, wish.language);
    packer.text(&wish.title);
    put_design(packer, &wish.design);
}

fn get_wish(unpacker: &mut Unpacker<'_>) -> Option<Wish> {
    Some(Wish {
        path: unpacker.text()?.into(),
        product: *Product::ALL.get(unpacker.count()?)?,
        paper: get_paper(unpacker)?,
        cutting: Cutting {
            lay: if unpacker.flag()? {
                Lay::Folded
            } else {
                Lay::Single
            },
            matches_print: unpacker.flag()?,
        },
        language: get_language(unpacker)?,
        title: unpacker.text()?,
        design: get_design(unpacker)?,
        // A page makes no film.
        group: None,
    })
}

/// Works as the maker of one product.
pub(super) fn serve() {
    hear(|parcel| {
        let mut parcel = Unpacker(parcel);
        match parcel.get::<u8>() {
            Some(FILE) => {
                // A parcel that is broken lays nothing down.
                get_file(&mut parcel);
            }
            Some(WISH) => {
                if let Some(wish) = get_wish(&mut parcel) {
                    work(&wish);
                }
            }
            _ => {}
        }
    });
}

fn work(wish: &Wish) {
    // What is called off here is ended as a whole.
    let line = Line {
        is_called_off: &AtomicBool::new(false),
        tell: &|share| {
            let mut parcel = Packer::default();
            parcel.put(told::WORKING);
            parcel.put(share);
            answer(&parcel);
        },
    };
    let made = make(wish, &line);
    let mut end = Packer::default();
    end.put(told::FAILED);
    match made {
        Ok(()) => return answer_written(told::DONE),
        Err(Unmade::Failed(sentence)) => put_sentence(&mut end, &sentence),
        Err(Unmade::CalledOff) => {}
    }
    answer(&end);
}
