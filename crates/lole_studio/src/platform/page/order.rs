//! An order: what all need is worked out by the page itself, between two pictures; its papers are made in a worker
//! and handed out as one archive.

use std::cell::{Cell, RefCell};
use std::path::PathBuf;
use std::rc::Rc;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use lole_files::shelf;
use lole_language::Sentence;

use super::worker::{Wake, Worker, answer, answer_written, hear, lay_written};
use crate::making::stopped_unexpectedly;
use crate::ordering::{BuyerWishes, Job, Line, OrderNews, Progress, read_list, run};
use crate::platform::letters::{
    get_design, get_file, get_language, get_paper, get_sentence, put_design, put_file,
    put_language, put_paper, put_sentence,
};
use crate::platform::parcel::{Packer, Unpacker};

/// What the worker is called.
pub(super) const ROLE: &str = "order";

const FILE: u8 = 0;
const JOB: u8 = 1;

/// First byte of what the worker sends.
mod told {
    pub(super) const PROGRESS: u8 = 0;
    /// All files follow.
    pub(super) const DONE: u8 = 1;
    pub(super) const FAILED: u8 = 2;
}

/// One order. Dropped, it ends at once.
pub(crate) struct OrderWork {
    job: RefCell<Option<Job>>,
    worker: RefCell<Option<Worker>>,
    is_called_off: Cell<bool>,
    wake: Wake,
}

impl OrderWork {
    /// Begins; `wake` is called when there is news.
    pub(crate) fn begin(job: Job, wake: impl Fn() + Send + 'static) -> Self {
        let wake: Wake = Rc::new(wake);
        wake();
        Self {
            worker: RefCell::new(job.folder.as_ref().and_then(|_| send(&job, &wake))),
            job: RefCell::new(Some(job)),
            is_called_off: Cell::default(),
            wake,
        }
    }

    /// Calls it off; nothing was handed out.
    pub(crate) fn call_off(&self) {
        self.is_called_off.set(true);
        (self.wake)();
    }

    /// What was told since the last time.
    pub(crate) fn news(&self) -> impl Iterator<Item = OrderNews> + '_ {
        let mut news = Vec::new();
        if self.is_called_off.get() {
            self.worker.take();
            news.extend(self.job.take().map(|_| OrderNews::CalledOff));
        } else if self.is_only_worked_out() {
            news.extend(self.job.take().map(|job| totals(job, None)));
        } else if self.job.borrow().is_some() {
            self.receive(&mut news);
        }
        news.into_iter()
    }

    fn is_only_worked_out(&self) -> bool {
        let job = self.job.borrow();
        job.as_ref().is_some_and(|job| job.folder.is_none())
    }

    /// Takes in what came from the worker.
    fn receive(&self, news: &mut Vec<OrderNews>) {
        let parcels: Vec<Vec<u8>> = match &*self.worker.borrow() {
            Some(worker) if !worker.has_failed() => {
                std::iter::from_fn(|| worker.receive()).collect()
            }
            _ => vec![vec![told::FAILED]],
        };
        for parcel in parcels {
            let mut parcel = Unpacker(&parcel);
            match parcel.get::<u8>() {
                Some(told::PROGRESS) => {
                    if let (Some(done), Some(of)) = (parcel.count(), parcel.count()) {
                        news.push(OrderNews::Progress(Progress { done, of }));
                    }
                    continue;
                }
                Some(told::DONE) => {
                    lay_written(&mut parcel);
                    let job = self.job.take();
                    news.extend(job.map(|job| {
                        let archive = job.folder.as_ref().map(|it| it.with_extension("zip"));
                        totals(job, archive)
                    }));
                }
                _ => {
                    self.job.take();
                    let sentence = get_sentence(&mut parcel).unwrap_or_else(stopped_unexpectedly);
                    news.push(OrderNews::Failed(sentence));
                }
            }
            self.worker.take();
            return;
        }
    }
}

/// What all need together, and where the papers are.
fn totals(job: Job, written: Option<PathBuf>) -> OrderNews {
    let job = Job {
        folder: None,
        ..job
    };
    match run(&job, &line(&|_| {}, &AtomicBool::new(false))) {
        Ok(OrderNews::Done(totals, _)) => OrderNews::Done(totals, written),
        Ok(news) => news,
        Err(sentence) => OrderNews::Failed(sentence),
    }
}

const fn line<'a>(tell: &'a dyn Fn(OrderNews), called_off: &'a AtomicBool) -> Line<'a> {
    Line { called_off, tell }
}

/// Starts a worker for the papers.
fn send(job: &Job, wake: &Wake) -> Option<Worker> {
    let worker = Worker::start(ROLE, wake)?;
    worker.lay_linked(&job.design, FILE);
    let mut parcel = Packer::default();
    parcel.put(FILE);
    let (list_file, _) = &job.list;
    let list_file_name = list_file.to_string_lossy();
    put_file(&mut parcel, &list_file_name, &shelf::find(list_file)?);
    worker.post(&parcel);
    let mut parcel = Packer::default();
    parcel.put(JOB);
    parcel.text(&list_file_name);
    parcel.text(&job.folder.as_ref()?.to_string_lossy());
    parcel.put(job.wishes.spare_percent);
    parcel.maybe(job.wishes.bolt_m, Packer::put);
    put_paper(&mut parcel, job.wishes.paper);
    parcel.flag(job.wishes.pictures);
    put_language(&mut parcel, job.language);
    parcel.text(&job.title);
    put_design(&mut parcel, &job.design);
    worker.post(&parcel);
    Some(worker)
}

fn get_job(unpacker: &mut Unpacker<'_>) -> Option<Result<Job, Sentence>> {
    let list_file = PathBuf::from(unpacker.text()?);
    let folder = Some(unpacker.text()?.into());
    let wishes = BuyerWishes {
        spare_percent: unpacker.get()?,
        bolt_m: unpacker.maybe(Unpacker::get)?,
        paper: get_paper(unpacker)?,
        pictures: unpacker.flag()?,
    };
    let language = get_language(unpacker)?;
    let title = unpacker.text()?;
    let design = get_design(unpacker)?;
    Some(read_list(&list_file).map(|list| Job {
        design,
        list: (list_file, Arc::new(list)),
        wishes,
        folder,
        title,
        language,
    }))
}

/// Works as whoever makes the papers of one order.
pub(super) fn serve() {
    hear(|parcel| {
        let mut parcel = Unpacker(parcel);
        match parcel.get::<u8>() {
            Some(FILE) => {
                // A parcel that is broken lays nothing down.
                get_file(&mut parcel);
            }
            Some(JOB) => match get_job(&mut parcel) {
                Some(Ok(job)) => work(&job),
                Some(Err(sentence)) => fail(&sentence),
                None => fail(&stopped_unexpectedly()),
            },
            _ => {}
        }
    });
}

fn work(job: &Job) {
    let tell = |news| {
        if let OrderNews::Progress(Progress { done, of }) = news {
            let mut parcel = Packer::default();
            parcel.put(told::PROGRESS);
            parcel.count(done);
            parcel.count(of);
            answer(&parcel);
        }
    };
    // What is called off here is ended as a whole.
    if let Err(sentence) = run(job, &line(&tell, &AtomicBool::new(false))) {
        fail(&sentence);
        return;
    }
    answer_written(told::DONE);
}

fn fail(sentence: &Sentence) {
    let mut parcel = Packer::default();
    parcel.put(told::FAILED);
    put_sentence(&mut parcel, sentence);
    answer(&parcel);
}
