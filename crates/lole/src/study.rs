//! `lole study`: the paper's experiment with numbers.

use std::cell::RefCell;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use indicatif::ProgressBar;
use lole_export::still;
use lole_export::study::{study_csv, study_html, study_json};
use lole_language::{Language, Words};
use lole_study::Stopwatch;
use lole_study::paper::{self, Audience, Extent};

use crate::args::StudyArgs;
use crate::clock::SystemClock;
use crate::output;
use crate::patience::{progress_bar, stop_flag};
use crate::{Failure, summary};

/// Quality of the picture on the page, 1 to 100.
const PICTURE_QUALITY: u8 = 88;

/// Runs the command.
pub(crate) fn run(args: &StudyArgs, language: Language) -> Result<(), Failure> {
    let stop = stop_flag().map_err(Failure::error)?;
    let mut output = output::create(&args.out).map_err(Failure::Usage)?;
    let clock = SystemClock::start();
    let started = Stopwatch::start(&clock);
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let threads = args
        .threads
        .map_or_else(|| cores.min(paper::MOST_THREADS), usize::from);
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .map_err(Failure::error)?;
    let extent = if args.quick {
        Extent::Quick
    } else {
        Extent::Full
    };
    let terminal = Terminal {
        language,
        stop,
        bar: RefCell::new(None),
    };
    let (mut report, panels) = paper::perform(&pool, &terminal, &clock, extent)?;
    let bar = progress_bar(2, language.pick("描く", "drawing"));
    let picture = paper::draw(&panels)?;
    bar.inc(1);
    report.seconds = started.read().wall_seconds;
    let image = lole_export::ImageView::new(picture.width, picture.height, &picture.pixels)
        .map_err(Failure::error)?;
    let png = still::encode_png(image).map_err(Failure::error)?;
    let jpeg = still::encode_jpeg(image, PICTURE_QUALITY).map_err(Failure::error)?;
    let json = study_json(&report).map_err(Failure::error)?;
    let page = study_html(&report, &jpeg);
    let table = study_csv(&report);
    let files: [(&str, &[u8]); 4] = [
        ("study.html", page.as_bytes()),
        ("study.json", json.as_bytes()),
        ("study.csv", table.as_bytes()),
        ("study.png", &png),
    ];
    for (name, bytes) in files {
        output.write(name, bytes).map_err(Failure::error)?;
    }
    let paths = output.finish().map_err(Failure::error)?;
    bar.finish_and_clear();
    if args.json {
        summary::print_json(&json);
    } else {
        summary::print_study(&report, &paths, language);
    }
    Ok(())
}

/// Shows each part as a bar, and ends the study where the user does.
struct Terminal {
    language: Language,
    stop: Arc<AtomicBool>,
    /// The bar of the current part.
    bar: RefCell<Option<ProgressBar>>,
}

impl Audience for Terminal {
    fn begin(&self, part: Words, run_count: usize) {
        let length = u32::try_from(run_count).unwrap_or(u32::MAX);
        let bar = progress_bar(length, part.text(self.language));
        self.bar.replace(Some(bar));
    }

    fn advance(&self) {
        if let Some(bar) = &*self.bar.borrow() {
            bar.inc(1);
        }
    }

    fn end(&self) {
        if let Some(bar) = self.bar.take() {
            bar.finish_and_clear();
        }
    }

    fn waits(&self) -> bool {
        !self.stop.load(Ordering::Relaxed)
    }
}
