//! `lole batch`: runs by the thousand, one on a core each, and one table.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::Duration;

use lole_batch::plan::Run;
use lole_batch::{Batch, Performed, Record};
use lole_files::{OutputFolder, RunFolder};
use lole_language::{Language, Sentence};

use crate::args::BatchArgs;
use crate::patience::{check, progress_bar, stop_flag};
use crate::{Failure, clock, output, summary};

/// Runs the command.
pub(crate) fn run(args: &BatchArgs, language: Language) -> Result<(), Failure> {
    let batch = Batch::open(&args.sweep).map_err(Failure::usage)?;
    let others = others(args)?;
    let folder = RunFolder::create(&args.out).map_err(Failure::usage)?;
    batch.gather(&folder, &others).map_err(Failure::error)?;
    let stop = stop_flag().map_err(Failure::error)?;
    let performed = if args.merge {
        0
    } else {
        let due = batch.due(&folder, args.shard.unwrap_or((1, 1)));
        perform_all(&batch, &folder, (&due, args.threads), (&stop, language))?;
        check(&stop)?;
        due.len()
    };
    if args.shard.is_some() {
        told(args, (performed, None), language);
        return Ok(());
    }
    let output = output::create(&args.out).map_err(Failure::Usage)?;
    write_table(args, &batch, (&folder, output, performed), language)
}

/// The folders of `--from`.
fn others(args: &BatchArgs) -> Result<Vec<RunFolder>, Failure> {
    let all = args.from.iter().map(|path| {
        if path.is_dir() {
            return Ok(RunFolder::at(path));
        }
        let name = path.display();
        Err(Failure::usage(Sentence::new(
            format!("{name}: フォルダーがありません。場所を確かめてください（--from）"),
            format!("{name}: there is no such folder; check the path (--from)"),
        )))
    });
    all.collect()
}

/// Performs runs on so many threads, each run on one of them from its first to its last frame.
fn perform_all(
    batch: &Batch,
    folder: &RunFolder,
    (due, threads): (&[u64], Option<u16>),
    (stop, language): (&AtomicBool, Language),
) -> Result<(), Failure> {
    let cores = || std::thread::available_parallelism().map_or(1, usize::from);
    let threads = threads.map_or_else(cores, usize::from).min(due.len());
    let length = u32::try_from(due.len()).unwrap_or(u32::MAX);
    let bar = progress_bar(length, language.pick("踊らせる", "runs"));
    let (next, failed) = (AtomicUsize::new(0), Mutex::new(None));
    let has_failed = AtomicBool::new(false);
    let goes_on = || !stop.load(Ordering::Relaxed) && !has_failed.load(Ordering::Relaxed);
    let work = || -> Result<(), Failure> {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
        let pool = pool.map_err(Failure::error)?;
        while let Some(&number) = due.get(next.fetch_add(1, Ordering::Relaxed)) {
            let run = batch.run(number);
            let Some(done) = pool.install(|| perform(batch, &run, &goes_on)) else {
                break;
            };
            batch.keep(folder, &run, &done).map_err(Failure::error)?;
            bar.inc(1);
        }
        Ok(())
    };
    let worker = || {
        let Err(failure) = work() else {
            return;
        };
        has_failed.store(true, Ordering::Relaxed);
        if let Ok(mut failed) = failed.lock() {
            failed.get_or_insert(failure);
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(worker);
        }
    });
    bar.finish_and_clear();
    failed.into_inner().ok().flatten().map_or(Ok(()), Err)
}

/// One run with what it costs. A fault of this program ends its run and no other.
fn perform(batch: &Batch, run: &Run, goes_on: &dyn Fn() -> bool) -> Option<Performed> {
    let started = clock::of_thread();
    let result = catch_unwind(AssertUnwindSafe(|| batch.perform(run, goes_on)));
    let mut done = result.unwrap_or_else(|_| Some(fault(run)))?;
    let spent = clock::of_thread().saturating_sub(started);
    done.record.process_seconds = Duration::as_secs_f64(&spent);
    Some(done)
}

fn fault(run: &Run) -> Performed {
    let why = Sentence::new(
        "このプログラムの誤りで止まりました。お知らせください",
        "stopped by a fault of this program; please report it",
    );
    Performed {
        record: Record {
            lole: env!("CARGO_PKG_VERSION").to_owned(),
            document: run.document.clone(),
            figures: None,
            error: Some(why.into()),
            process_seconds: 0.0,
        },
        files: Vec::new(),
    }
}

/// Writes the table, what the runs cost, and the sweep itself.
fn write_table(
    args: &BatchArgs,
    batch: &Batch,
    (folder, mut output, performed): (&RunFolder, OutputFolder, usize),
    language: Language,
) -> Result<(), Failure> {
    let all = batch.plan().run_count();
    let table = batch.table(folder);
    let (table, costs) = table.map_err(|missing| Failure::error(missing.sentence(all)))?;
    let parquet = table.to_parquet().map_err(Failure::error)?;
    let costs = costs.iter().enumerate();
    let costs = costs.map(|(run, seconds)| format!("{run},{seconds}\r\n"));
    let costs = "run,process_s\r\n".to_owned() + &costs.collect::<String>();
    let files = [
        ("runs.csv", table.to_csv().as_bytes()),
        ("runs.parquet", parquet.as_slice()),
        ("costs.csv", costs.as_bytes()),
    ]
    .map(|(name, bytes)| output.write(name, bytes));
    for written in files {
        written.map_err(Failure::error)?;
    }
    let paths = output.finish().map_err(Failure::error)?;
    told(args, (performed, Some(table.failed_count())), language);
    if !args.json {
        summary::print_files(&paths, language);
    }
    Ok(())
}

/// Says how many runs were made, and how many of all have failed.
fn told(args: &BatchArgs, (performed, failed): (usize, Option<usize>), language: Language) {
    if args.json {
        let json = serde_json::json!({ "performed": performed, "failed": failed });
        summary::print_json(&format!("{json:#}\n"));
        return;
    }
    let mut lines = vec![Sentence::new(
        format!("踊った回数: {performed}"),
        format!("runs performed now: {performed}"),
    )];
    if let Some(failed) = failed.filter(|&failed| 0 < failed) {
        lines.push(Sentence::new(
            format!("最後まで行かなかった回数: {failed}（表の error の列に理由）"),
            format!("runs of all that failed: {failed} (why stands in the column error)"),
        ));
    }
    summary::print_lines(&lines, language);
}
