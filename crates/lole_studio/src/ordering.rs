//! A group's order: the list of dancers, and the thread that cuts the costume for each of them.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use lole_costume::cost;
use lole_costume::document::{DancerDesign, Design};
use lole_costume::order::{self, Group, NotionTotal, PrintTotal, Settings};
use lole_costume::roster::{self, Roster};
use lole_export::order::{ORDER_JSON, OrderParts, left_behind, order_folder};
use lole_export::pdf::{EncodedPicture, Paper, printable};
use lole_geom::Length;
use lole_language::{Bilingual as _, Language, Sentence};

use lole_files as files;
use lole_picture::portrait::{self, PortraitError};
use lole_stage::Formation;

/// Everything behind the panel of orders.
#[derive(Debug, Clone, Default)]
pub struct OrderDesk {
    /// The list, with the file it was read from.
    pub list: Option<(PathBuf, Arc<Roster>)>,
    /// What the buyer decides.
    pub wishes: BuyerWishes,
    /// Who of the list was dressed, with what the design said of her then.
    pub dressed: Option<(String, DancerDesign)>,
    /// What is being done.
    pub progress: Option<Progress>,
    /// How they stand in the film of all.
    pub formation: Formation,
    /// What everybody needs, once it was worked out, with the design and wishes it is of.
    pub totals: Option<Arc<Totals>>,
}

/// What the buyer decides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BuyerWishes {
    /// Spare cloth [%].
    pub spare_percent: f64,
    /// Cloth on one bolt [m], where it is known.
    pub bolt_m: Option<f64>,
    /// What it is printed on.
    pub paper: Paper,
    /// Whether the order shows everybody in her costume, which takes a while.
    pub pictures: bool,
}

impl Default for BuyerWishes {
    fn default() -> Self {
        Self {
            spare_percent: 100.0 * Settings::default().spare_ratio,
            bolt_m: None,
            paper: Paper::A4,
            pictures: true,
        }
    }
}

impl BuyerWishes {
    fn settings(&self) -> Settings {
        Settings {
            spare_ratio: self.spare_percent / 100.0,
            bolt_length: self.bolt_m.map(Length::from_m),
        }
    }
}

/// How far an order has come.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Progress {
    /// Dancers who are cut for, or who are dressed for their pictures.
    pub done: usize,
    /// Of so many.
    pub of: usize,
}

/// What a group needs in all.
#[derive(Debug, Clone)]
pub struct Totals {
    /// The design that was cut.
    pub design: Design,
    /// What was decided.
    pub wishes: BuyerWishes,
    /// Everybody who can be cut for, and rows that cannot be used.
    pub group: Group,
    /// What is bought of each print.
    pub prints: Vec<PrintTotal>,
    /// What is bought beside cloth.
    pub notions: Vec<NotionTotal>,
    /// What all cost together.
    pub bill: cost::Bill,
}

/// What is to be done.
pub(crate) struct Job {
    pub(crate) design: Design,
    /// The list, with the file it was read from.
    pub(crate) list: (PathBuf, Arc<Roster>),
    pub(crate) wishes: BuyerWishes,
    /// Where the order is written; only worked out where there is none.
    pub(crate) folder: Option<PathBuf>,
    /// What the costume is called.
    pub(crate) title: String,
    pub(crate) language: Language,
}

/// What the thread tells.
pub(crate) enum OrderNews {
    Progress(Progress),
    /// It is done; with the folder where one was written.
    Done(Arc<Totals>, Option<PathBuf>),
    Failed(Sentence),
    CalledOff,
}

/// Reads a list of dancers.
///
/// # Errors
/// One sentence that names the file.
pub(crate) fn read_list(path: &Path) -> Result<Roster, Sentence> {
    let bytes = files::read_linked(path, "roster")?;
    let name = path.display();
    roster::read(&bytes).map_err(|error| {
        Sentence::new(
            format!("{name}: {}", error.japanese()),
            format!("{name}: {error}"),
        )
    })
}

/// How the thread of an order stays in touch with the window.
pub(crate) struct Line<'a> {
    pub(crate) called_off: &'a AtomicBool,
    pub(crate) tell: &'a dyn Fn(OrderNews),
}

impl Line<'_> {
    fn is_called_off(&self) -> bool {
        self.called_off.load(Ordering::Relaxed)
    }

    fn progress(&self, done: usize, of: usize) {
        (self.tell)(OrderNews::Progress(Progress { done, of }));
    }
}

/// Cuts for everybody, and writes the order where that was asked for.
pub(crate) fn run(job: &Job, line: &Line<'_>) -> Result<OrderNews, Sentence> {
    let mut group = Group::of(&job.list.1);
    let of = job.list.1.dancers.len();
    for (done, dancer) in job.list.1.dancers.iter().enumerate() {
        line.progress(done, of);
        if line.is_called_off() {
            return Ok(OrderNews::CalledOff);
        }
        group.add(dancer, &job.design, order::plan(dancer, &job.design));
    }
    if group.plans.is_empty() {
        let first = group.problems.first().cloned();
        return Err(first.unwrap_or_else(|| {
            Sentence::new("名簿に踊り手がいません", "the list has no dancers")
        }));
    }
    let folder = match &job.folder {
        Some(folder) => Some(write(job, &group, folder, line)?),
        None => None,
    };
    if line.is_called_off() && folder.is_none() && job.folder.is_some() {
        return Ok(OrderNews::CalledOff);
    }
    let prints = order::prints(&group.plans, &job.design, &job.wishes.settings());
    let totals = Totals {
        design: job.design.clone(),
        wishes: job.wishes,
        notions: order::notions(&group.plans, &job.wishes.settings()),
        bill: cost::group_bill(&job.design, &group.plans, &prints),
        prints,
        group,
    };
    Ok(match folder {
        Some(None) => OrderNews::CalledOff,
        Some(folder) => OrderNews::Done(Arc::new(totals), folder),
        None => OrderNews::Done(Arc::new(totals), None),
    })
}

/// Writes the order's files; `None` where it was called off, which leaves nothing behind.
fn write(
    job: &Job,
    group: &Group,
    folder: &Path,
    line: &Line<'_>,
) -> Result<Option<PathBuf>, Sentence> {
    let Some(pictures) = pictures(job, group, line) else {
        return Ok(None);
    };
    let parts = OrderParts {
        title: printable(&job.title),
        design: &job.design,
        group,
        pictures: &pictures,
        settings: &job.wishes.settings(),
        paper: job.wishes.paper,
        language: job.language,
        version: env!("CARGO_PKG_VERSION"),
        kept_files: &[],
    };
    let called_off = line.called_off;
    let goes_on = || !called_off.load(Ordering::Relaxed);
    let made = order_folder(&parts, &goes_on).map_err(|error| {
        Sentence::new(format!("注文書を作れません（{error}）"), error.to_string())
    })?;
    if line.is_called_off() {
        return Ok(None);
    }
    let earlier = std::fs::read_to_string(folder.join(ORDER_JSON)).unwrap_or_default();
    files::write_folder(folder, &made.files)?;
    for name in left_behind(&earlier, &made.json) {
        // An old file that stays does no harm to the new order.
        drop(std::fs::remove_file(folder.join(name)));
    }
    Ok(Some(folder.to_owned()))
}

/// Everybody in her costume, one after the other: the dance in the window goes on meanwhile. Who cannot
/// be dressed has no picture; `None` where it was called off.
fn pictures(job: &Job, group: &Group, line: &Line<'_>) -> Option<Vec<Option<EncodedPicture>>> {
    let of = group.designs.len();
    if !job.wishes.pictures {
        return Some(vec![None; of]);
    }
    let mut pictures = Vec::with_capacity(of);
    for (done, design) in group.designs.iter().enumerate() {
        line.progress(done, of);
        pictures.push(match portrait::standing(design, &|| line.is_called_off()) {
            Ok(bytes) => portrait::of_jpeg(bytes),
            Err(PortraitError::CalledOff) => return None,
            Err(_) => None,
        });
    }
    Some(pictures)
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    /// An order of a list as text, without pictures.
    pub(crate) fn job(list: &str, folder: Option<PathBuf>) -> Job {
        Job {
            design: Design::default(),
            list: (
                PathBuf::from("list.csv"),
                Arc::new(roster::read(list.as_bytes()).unwrap()),
            ),
            wishes: BuyerWishes {
                pictures: false,
                ..BuyerWishes::default()
            },
            folder,
            title: "Hau".to_owned(),
            language: Language::English,
        }
    }

    #[test]
    fn an_order_shows_everybody_in_her_costume() {
        let mut job = job("name,stature,hip\nNani,150,85\n", None);
        job.wishes.pictures = true;
        let mut group = Group::of(&job.list.1);
        let dancer = &job.list.1.dancers[0];
        group.add(dancer, &job.design, order::plan(dancer, &job.design));
        let called_off = AtomicBool::new(false);
        let line = Line {
            called_off: &called_off,
            tell: &|_| {},
        };
        let found = pictures(&job, &group, &line).unwrap();
        assert!(matches!(found[..], [Some(_)]));
        called_off.store(true, Ordering::Relaxed);
        assert!(pictures(&job, &group, &line).is_none());
    }
}
