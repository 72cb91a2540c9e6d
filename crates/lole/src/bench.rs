//! `lole bench`: what a frame costs on this machine, scene by scene, with the quality it buys.

use std::sync::atomic::Ordering;

use lole_cloth::InstructionSet;
use lole_cloth::scenes::{ClothScene, SCENES};
use lole_export::trade_off::trade_off_html;
use lole_language::{Language, Sentence, Words, words};
use lole_study::bench::pareto::{self, ParetoPoint};
use lole_study::bench::{self, BenchSettings, Entry};
use lole_study::soak::{SoakSettings, soak};

use crate::args::{BenchArgs, Vectors};
use crate::clock::SystemClock;
use crate::output;
use crate::patience::{progress_bar, stop_flag};
use crate::{Failure, summary};

/// Keeps what has the name that was asked for, which must be one of them.
fn choose<T>(
    entries: &mut Vec<T>,
    (option, name): (&'static str, Option<&str>),
    what: Words,
    name_of: fn(&T) -> &'static str,
) -> Result<(), Failure> {
    let Some(name) = name else { return Ok(()) };
    let mut names: Vec<&str> = entries.iter().map(name_of).collect();
    names.dedup();
    if !names.contains(&name) {
        names.sort_unstable();
        names.dedup();
        return Err(crate::dance::unknown(option, name, what, &names));
    }
    entries.retain(|entry| name_of(entry) == name);
    Ok(())
}

/// Scenes of the engine, or the one that was named.
fn scenes_of_engine(args: &BenchArgs) -> Result<Vec<&'static ClothScene>, Failure> {
    let mut scenes: Vec<&ClothScene> = SCENES.iter().collect();
    let asked = ("--scene", args.scene.as_deref());
    choose(&mut scenes, asked, words("場面", "scene"), |scene| {
        scene.name
    })?;
    Ok(scenes)
}

/// What is asked of a bench.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Task {
    /// The table of scenes.
    Table,
    /// The same square at four sizes.
    Sizes,
    /// Quality against time.
    Pareto,
    /// So many frames of random motion of every scene, by a seed.
    Soak(u32, u64),
}

/// The task, where its options go together.
fn task(args: &BenchArgs) -> Result<Task, Failure> {
    let tasks = [
        args.sizes.then_some(("--sizes", Task::Sizes)),
        args.pareto.then_some(("--pareto", Task::Pareto)),
        (args.soak).map(|frames| ("--soak", Task::Soak(frames, args.seed.unwrap_or(1)))),
    ];
    let asked: Vec<_> = tasks.into_iter().flatten().collect();
    if let [(first, _), (second, _), ..] = asked[..] {
        return Err(Failure::usage(Sentence::new(
            format!("{second}: {first} と一緒には使えません。どちらか一つにしてください"),
            format!("{second}: it does not go with {first}; choose one of them"),
        )));
    }
    let (name, task) = asked.first().copied().unwrap_or(("", Task::Table));
    let without = |option: &str| {
        Failure::usage(Sentence::new(
            format!("{option}: {name} とは使えません。{option} を除いてください"),
            format!("{option}: {name} does not use it; leave it out"),
        ))
    };
    let only_with = |option: &str, needed: &str| {
        Failure::usage(Sentence::new(
            format!("{option}: {needed} と一緒に使ってください"),
            format!("{option}: it goes with {needed} only"),
        ))
    };
    match task {
        Task::Sizes if args.scene.is_some() => return Err(without("--scene")),
        Task::Soak(..) if args.method.is_some() => return Err(without("--method")),
        Task::Soak(..) | Task::Pareto if args.roofline => return Err(without("--roofline")),
        _ => {}
    }
    if args.seed.is_some() && !matches!(task, Task::Soak(..)) {
        return Err(only_with("--seed", "--soak"));
    }
    if args.out.is_some() && task != Task::Pareto {
        return Err(only_with("--out", "--pareto"));
    }
    Ok(task)
}

/// Runs the command.
pub(crate) fn run(args: &BenchArgs, language: Language) -> Result<(), Failure> {
    let task = task(args)?;
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(usize::from(args.threads))
        .build()
        .map_err(Failure::error)?;
    let clock = SystemClock::start();
    let settings = BenchSettings {
        clock: &clock,
        instruction_set: match args.vectors {
            Vectors::Detected => InstructionSet::Detected,
            Vectors::Wide => InstructionSet::Wide,
            Vectors::Baseline => InstructionSet::Baseline,
        },
        roofline: args.roofline,
    };
    pool.install(|| match task {
        Task::Table => table(bench::entries(), args, settings, language),
        Task::Sizes => table(bench::sizes(), args, settings, language),
        Task::Pareto => trade_off(args, settings, language),
        Task::Soak(frame_count, seed) => {
            let settings = SoakSettings {
                frame_count,
                seed,
                instruction_set: settings.instruction_set,
            };
            soak_all(args, settings, language)
        }
    })
}

/// Measures every entry, or those that were asked for.
fn table(
    mut chosen: Vec<Entry>,
    args: &BenchArgs,
    settings: BenchSettings<'_>,
    language: Language,
) -> Result<(), Failure> {
    let scene = ("--scene", args.scene.as_deref());
    choose(&mut chosen, scene, words("場面", "scene"), |entry| {
        entry.scene
    })?;
    let method = ("--method", args.method.as_deref());
    choose(&mut chosen, method, words("方法", "method"), |entry| {
        entry.method
    })?;
    let mut rows = Vec::new();
    if !args.json {
        summary::print_bench_head(language);
    }
    let reference = bench::reference().measure(settings)?;
    for entry in chosen {
        let mut row = if reference.is_of(&entry) {
            reference.clone()
        } else {
            entry.measure(settings)?
        };
        row.compare(&reference);
        if !args.json {
            summary::print_bench_row(&row, language);
        }
        rows.push(row);
    }
    if args.json {
        summary::print_json(&serde_json::to_string_pretty(&rows).map_err(Failure::error)?);
    } else if args.sizes {
        summary::print_size_costs(&rows, language);
    }
    Ok(())
}

/// Measures every setting of every scene, or of the one that was named.
fn trade_off(
    args: &BenchArgs,
    settings: BenchSettings<'_>,
    language: Language,
) -> Result<(), Failure> {
    let mut cases = pareto::cases();
    let scene = ("--scene", args.scene.as_deref());
    choose(&mut cases, scene, words("場面", "scene"), |case| {
        case.scene
    })?;
    let method = ("--method", args.method.as_deref());
    choose(&mut cases, method, words("方法", "method"), |case| {
        case.method
    })?;
    let mut output = (args.out.as_deref())
        .map(output::create)
        .transpose()
        .map_err(Failure::Usage)?;
    let stop = stop_flag().map_err(Failure::error)?;
    let goes_on = || !stop.load(Ordering::Relaxed);
    let mut points: Vec<ParetoPoint> = Vec::new();
    for of_scene in cases.chunk_by(|one, next| one.scene == next.scene) {
        let mut found = pareto::points(of_scene, settings, &goes_on)?;
        if !args.json {
            summary::print_pareto(&found, language);
        }
        points.append(&mut found);
    }
    let json = serde_json::to_string_pretty(&points).map_err(Failure::error)? + "\n";
    if args.json {
        summary::print_json(&json);
    }
    if let Some(output) = &mut output {
        let page = trade_off_html(&pareto::report(&points, &cases));
        (output.write("bench.html", page.as_bytes()))
            .and_then(|()| output.write("bench.json", json.as_bytes()))
            .map_err(Failure::error)?;
    }
    if let Some(output) = output {
        let paths = output.finish().map_err(Failure::error)?;
        if !args.json {
            summary::print_files(&paths, language);
        }
    }
    Ok(())
}

/// Soaks every scene of the engine, or the one that was named.
fn soak_all(args: &BenchArgs, settings: SoakSettings, language: Language) -> Result<(), Failure> {
    let scenes = scenes_of_engine(args)?;
    let stop = stop_flag().map_err(Failure::error)?;
    let is_stopped = || stop.load(Ordering::Relaxed);
    let mut rows = Vec::new();
    for scene in scenes {
        let bar = progress_bar(settings.frame_count, scene.name);
        let mut go_on = |frame: u32| {
            bar.set_position(u64::from(frame));
            !is_stopped()
        };
        let row = soak(scene, settings, &mut go_on).map_err(Failure::error)?;
        bar.finish_and_clear();
        if !args.json {
            summary::print_soak(&row, language);
        }
        rows.push(row);
        if is_stopped() {
            break;
        }
    }
    if args.json {
        summary::print_json(&serde_json::to_string_pretty(&rows).map_err(Failure::error)?);
    }
    if is_stopped() {
        return Err(Failure::Interrupted);
    }
    let broken: usize = rows.iter().map(|row| row.violations.len()).sum();
    if broken == 0 {
        return Ok(());
    }
    let sentence = Sentence::new(
        format!("{broken} 件の法則が破れました。上の行をご覧ください"),
        format!("{broken} laws did not hold; see the rows above"),
    );
    Err(Failure::Run(sentence.into()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::args::{Cli, Command};
    use clap::Parser as _;

    fn asked(words: &[&str]) -> Result<Task, String> {
        let words = ["lole", "bench"].iter().chain(words);
        let Command::Bench(args) = Cli::try_parse_from(words).unwrap().command else {
            panic!("bench was asked for");
        };
        task(&args).map_err(|failure| match failure {
            Failure::Usage(error) => error.to_string(),
            _ => panic!("a wrong option is wrong usage"),
        })
    }

    #[test]
    fn options_that_do_not_go_together_are_refused_in_one_sentence() {
        assert_eq!(asked(&[]), Ok(Task::Table));
        assert_eq!(asked(&["--sizes", "--roofline"]), Ok(Task::Sizes));
        assert_eq!(asked(&["--pareto", "--out", "d"]), Ok(Task::Pareto));
        let soak = ["--soak", "9", "--seed", "4", "--scene", "skirt"];
        assert_eq!(asked(&soak), Ok(Task::Soak(9, 4)));
        for (words, sentence) in [
            (
                ["--pareto", "--sizes"].as_slice(),
                "--pareto: it does not go with --sizes; choose one of them",
            ),
            (&["--seed", "4"], "--seed: it goes with --soak only"),
            (&["--out", "d"], "--out: it goes with --pareto only"),
            (
                &["--soak", "9", "--method", "xpbd"],
                "--method: --soak does not use it; leave it out",
            ),
            (
                &["--sizes", "--scene", "skirt"],
                "--scene: --sizes does not use it; leave it out",
            ),
            (
                &["--pareto", "--roofline"],
                "--roofline: --pareto does not use it; leave it out",
            ),
        ] {
            assert_eq!(asked(words), Err(sentence.to_owned()));
        }
    }
}
