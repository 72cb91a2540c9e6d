//! A sweep that lies in a file, and a folder of results: the steps that the command and whoever has a queue or a
//! cluster take in any order, on any number of machines.
//!
//! The manifest is the file of the sweep. A run is its number in it; performing and keeping it twice changes
//! nothing.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use lole_files::{RunFolder, read_document, read_linked_files, runs::linked_hash};
use lole_language::Sentence;

use crate::perform::{self, Performed};
use crate::plan::{Plan, Run};
use crate::record::Record;
use crate::sweep::{FileKind, Sweep};
use crate::table::Table;

/// A sweep with its design and what that names.
#[derive(Debug, Clone)]
pub struct Batch {
    plan: Plan,
    /// Where the design lies, whose files are named from there.
    document: PathBuf,
    linked: u64,
}

/// What the folder does not hold yet.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Missing {
    /// Numbers of the runs, ascending.
    pub runs: Vec<u64>,
}

impl Missing {
    /// How many runs are missing, the first of them, and what to do.
    #[must_use]
    pub fn sentence(&self, all: u64) -> Sentence {
        let count = self.runs.len();
        let first = self.runs.first().copied().unwrap_or(0);
        Sentence::new(
            format!(
                "{all} 回のうち {count} 回がまだです（最初は {first} 番）。lole batch をもう一度実行するか、--from でほかのフォルダーを加えてください"
            ),
            format!(
                "{count} of {all} runs are missing, the first is run {first}; run lole batch again, or add their folders with --from"
            ),
        )
    }
}

impl Batch {
    /// Reads a sweep, its design and the files that it may name.
    ///
    /// # Errors
    /// One sentence: a file that cannot be read, or the first thing that is wrong in one.
    pub fn open(path: &Path) -> Result<Self, Sentence> {
        let name = path.display().to_string();
        let sweep = Sweep::read(&text(path)?, &name).map_err(|error| error.0)?;
        let (document, design) = match &sweep.design {
            None => (path.to_owned(), "lole = 1\n".to_owned()),
            Some(design) => {
                let document = path.with_file_name(design);
                let design = text(&document).map_err(|why| {
                    Sentence::new(
                        format!("{}（{name} の design）", why.japanese),
                        format!("{} (design of {name})", why.english),
                    )
                })?;
                (document, design)
            }
        };
        let plan = Plan::new(sweep, &design, &document.display().to_string());
        let plan = plan.map_err(|error| {
            // A mistake of the design has its own file and line.
            let Sentence { japanese, english } = error.0;
            if english.starts_with('[') {
                Sentence::new(format!("{name}: {japanese}"), format!("{name}: {english}"))
            } else {
                Sentence { japanese, english }
            }
        })?;
        let linked = linked_hash(&plan.designs(), &document)?;
        Ok(Self {
            plan,
            document,
            linked,
        })
    }

    /// The runs.
    #[must_use]
    pub const fn plan(&self) -> &Plan {
        &self.plan
    }

    /// The run of a number, counted from 0.
    ///
    /// # Panics
    /// Where there is no such run.
    #[must_use]
    pub fn run(&self, number: u64) -> Run {
        self.plan.run(number, self.linked)
    }

    /// The record of a run, where it has ended.
    #[must_use]
    pub fn record(&self, folder: &RunFolder, run: &Run) -> Option<Record> {
        Record::read(&folder.record(&run.id)?, &run.document)
    }

    /// Numbers of the runs of a share, as in `(2, 8)` for the second of eight, that are to be performed: they have
    /// not ended, and of runs that are the same only the first counts.
    #[must_use]
    pub fn due(&self, folder: &RunFolder, (share, shares): (u64, u64)) -> Vec<u64> {
        let mut seen = BTreeSet::new();
        let numbers = (0..self.plan.run_count()).filter(|number| number % shares == share - 1);
        let is_due = |number: &u64| {
            let run = self.run(*number);
            self.record(folder, &run).is_none() && seen.insert(run.id)
        };
        numbers.filter(is_due).collect()
    }

    /// Dances a run; see [`perform::perform`]. `None` where it was called off.
    #[must_use]
    pub fn perform(&self, run: &Run, goes_on: &dyn Fn() -> bool) -> Option<Performed> {
        let design = perform::design(run).and_then(|mut design| {
            read_linked_files(&mut design, &self.document)?;
            Ok(design)
        });
        let files: Vec<FileKind> = self.plan.sweep().files.iter().copied().collect();
        perform::perform(run, design.as_ref().map_err(Clone::clone), &files, goes_on)
    }

    /// Keeps what a run left behind.
    ///
    /// # Errors
    /// One sentence that names the file that cannot be written.
    pub fn keep(&self, folder: &RunFolder, run: &Run, done: &Performed) -> Result<(), Sentence> {
        let files = done.files.iter();
        let files: Vec<(&str, Vec<u8>)> = files
            .map(|(kind, bytes)| (kind.ending(), bytes.clone()))
            .collect();
        folder.keep(&run.id, done.record.to_json().as_bytes(), &files)
    }

    /// Takes over what other folders hold and this one does not; how many runs that were.
    ///
    /// # Errors
    /// One sentence that names a file.
    pub fn gather(&self, folder: &RunFolder, others: &[RunFolder]) -> Result<u64, Sentence> {
        let endings = self.plan.sweep().files.iter().map(|kind| kind.ending());
        let endings: Vec<&str> = endings.collect();
        let mut count = 0;
        for number in 0..self.plan.run_count() {
            let run = self.run(number);
            if self.record(folder, &run).is_some() {
                continue;
            }
            let holder = others.iter().find(|it| self.record(it, &run).is_some());
            if let Some(holder) = holder {
                folder.take(holder, &run.id, &endings)?;
                count += 1;
            }
        }
        Ok(count)
    }

    /// The table of all runs and what each cost [s of processor time].
    ///
    /// # Errors
    /// The runs that are missing.
    pub fn table(&self, folder: &RunFolder) -> Result<(Table, Vec<f64>), Missing> {
        let (mut rows, mut runs) = (Vec::new(), Vec::new());
        for number in 0..self.plan.run_count() {
            let mut run = self.run(number);
            let Some(mut record) = self.record(folder, &run) else {
                runs.push(number);
                continue;
            };
            // A hundred thousand documents need not be in memory at once.
            (run.document, record.document) = Default::default();
            rows.push((run, record));
        }
        if !runs.is_empty() {
            return Err(Missing { runs });
        }
        let costs = rows.iter().map(|(_, record)| record.process_seconds);
        Ok((Table::new(&self.plan, &rows), costs.collect()))
    }
}

fn text(path: &Path) -> Result<String, Sentence> {
    String::from_utf8(read_document(path)?).map_err(|_| {
        let name = path.display();
        Sentence::new(
            format!("{name}: UTF-8 の文章ではありません。UTF-8 で保存し直してください"),
            format!("{name}: the text is not UTF-8; save it again as UTF-8"),
        )
    })
}
