//! `lole bench`: what a frame costs on this machine, scene by scene, with the quality it buys.

mod engine;
mod pareto;
mod phases;
mod roofline;
mod row;
mod soak;
mod stage;

use lole_cloth::InstructionSet;
use lole_cloth::scenes::{ClothScene, SCENES, SIZES};
use lole_language::{Language, Sentence, Words, words};

use crate::args::{BenchArgs, Vectors};
use crate::{Failure, summary};
pub(crate) use pareto::ParetoPoint;
pub(crate) use row::BenchRow;
use soak::Soak;
pub(crate) use soak::{SoakRow, WorstAt};

/// What holds for every scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Settings {
    instruction_set: InstructionSet,
    /// Whether the springs are held against the best that this machine can do.
    roofline: bool,
}

impl Settings {
    const fn of(args: &BenchArgs) -> Self {
        Self {
            instruction_set: match args.vectors {
                Vectors::Detected => InstructionSet::Detected,
                Vectors::Wide => InstructionSet::Wide,
                Vectors::Baseline => InstructionSet::Baseline,
            },
            roofline: args.roofline,
        }
    }
}

/// A scene of the table.
type Measure = Box<dyn Fn(Settings) -> Result<BenchRow, Failure> + Send + Sync>;

/// A row of the table that can be asked for.
struct Entry {
    scene: &'static str,
    method: &'static str,
    measure: Measure,
}

/// A scene of the engine by one of its methods, from its own start with its own settings.
fn entry(scene: &'static ClothScene, method: engine::Method) -> Entry {
    Entry {
        scene: scene.name,
        method: method.id(),
        measure: Box::new(move |settings| {
            engine::measure((scene, method), (scene.build)(), settings).map_err(Failure::error)
        }),
    }
}

/// Every scene by every method that can run it: those of the engine, then those with a dancer.
fn entries() -> Vec<Entry> {
    let engine = SCENES.iter().flat_map(|scene| {
        let methods = engine::Method::of(scene).into_iter();
        methods.map(move |method| entry(scene, method))
    });
    let stage = stage::SCENES.iter().map(|scene| {
        let measure: Measure = Box::new(|settings| {
            stage::measure(scene, &(scene.design)(), settings).map_err(Failure::error)
        });
        Entry {
            scene: scene.name,
            method: scene.method(),
            measure,
        }
    });
    engine.chain(stage).collect()
}

/// A name that an option may ask for.
struct WantedName<'a> {
    option: &'static str,
    name: Option<&'a str>,
    /// What it is the name of.
    what: Words,
}

impl<'a> WantedName<'a> {
    fn scene(args: &'a BenchArgs) -> Self {
        Self {
            option: "--scene",
            name: args.scene.as_deref(),
            what: words("場面", "scene"),
        }
    }

    fn method(args: &'a BenchArgs) -> Self {
        Self {
            option: "--method",
            name: args.method.as_deref(),
            what: words("方法", "method"),
        }
    }

    /// Keeps what has the name that was asked for, which must be one of them.
    fn keep<T>(
        &self,
        entries: &mut Vec<T>,
        name_of: fn(&T) -> &'static str,
    ) -> Result<(), Failure> {
        let Some(name) = self.name else { return Ok(()) };
        let mut names: Vec<&str> = entries.iter().map(name_of).collect();
        if !names.contains(&name) {
            names.sort_unstable();
            names.dedup();
            return Err(crate::dance::unknown(self.option, name, self.what, &names));
        }
        entries.retain(|entry| name_of(entry) == name);
        Ok(())
    }
}

/// Scenes of the engine, or the one that was named.
fn scenes_of_engine(args: &BenchArgs) -> Result<Vec<&'static ClothScene>, Failure> {
    let mut scenes: Vec<&ClothScene> = SCENES.iter().collect();
    WantedName::scene(args).keep(&mut scenes, |scene| scene.name)?;
    Ok(scenes)
}

/// What is asked of a bench.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Task {
    /// The table of scenes.
    Table,
    /// One square at four sizes.
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
    let settings = Settings::of(args);
    pool.install(|| match task {
        Task::Table => table(entries(), args, settings, language),
        Task::Sizes => {
            let methods = [engine::Method::Xpbd, engine::Method::ExplicitRows];
            let sizes = methods
                .into_iter()
                .flat_map(|method| SIZES.iter().map(move |scene| entry(scene, method)));
            table(sizes.collect(), args, settings, language)
        }
        Task::Pareto => pareto::run(args, settings, language),
        Task::Soak(frame_count, seed) => {
            let soak = Soak {
                frame_count,
                seed,
                instruction_set: settings.instruction_set,
            };
            soak::run(args, soak, language)
        }
    })
}

/// Measures every entry, or those that were asked for.
fn table(
    mut chosen: Vec<Entry>,
    args: &BenchArgs,
    settings: Settings,
    language: Language,
) -> Result<(), Failure> {
    WantedName::scene(args).keep(&mut chosen, |entry| entry.scene)?;
    WantedName::method(args).keep(&mut chosen, |entry| entry.method)?;
    let mut rows = Vec::new();
    if !args.json {
        summary::print_bench_head(language);
    }
    for entry in chosen {
        let row = (entry.measure)(settings)?;
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

/// A scene of the engine.
#[cfg(test)]
fn scene(name: &str) -> &'static ClothScene {
    let scene = SCENES.iter().find(|scene| scene.name == name);
    scene.expect("one of the table")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::args::{Cli, Command};
    use clap::Parser as _;
    use serde_json::Value;

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

    #[test]
    fn a_row_has_its_keys_and_nulls_where_there_is_nothing_to_count() {
        let settings = Settings {
            instruction_set: InstructionSet::Detected,
            roofline: true,
        };
        let scene = ClothScene {
            frame_count: 10,
            ..*scene("hang-64")
        };
        let mut setup = (scene.build)();
        let row = engine::measure((&scene, engine::Method::Xpbd), setup.clone(), settings);
        let row = serde_json::to_value(row.unwrap()).unwrap();
        for path in [
            "/frame_ms/median",
            "/frame_ms/p99",
            "/strain_end_pct/mean",
            "/strain_end_pct/p99",
            "/strain_end_pct/max",
            "/strain_worst_pct/p99",
            "/penetration_mm/worst",
            "/bytes_per_particle",
            "/particle_substep_ns",
            "/spring_roofline/reached_pct",
        ] {
            let value = row.pointer(path).and_then(Value::as_f64);
            assert!(value.is_some_and(f64::is_finite), "{path}: {row}");
        }
        assert_eq!(row["scene"], "hang-64");
        assert_eq!(row["method"], "xpbd");
        assert_eq!(row["finite"], true);
        for key in ["self_crossings", "layer_inversions", "skin_penetration_mm"] {
            assert_eq!(row[key], Value::Null, "{key}");
        }
        let phases = row["phases"].as_array().unwrap().iter();
        let shares: f64 = phases
            .map(|phase| phase["share_pct"].as_f64().unwrap())
            .sum();
        assert!((shares - 100.0).abs() < 1e-6, "{row}");

        // A cloth that cannot be counted: its first particle is nowhere.
        let contact = (super::scene("skirt-self").build)().config.self_collision;
        setup.config.self_collision = contact;
        setup.positions[70].x = f32::NAN;
        let scene = ClothScene {
            frame_count: 40,
            ..scene
        };
        let row = engine::measure((&scene, engine::Method::Xpbd), setup, settings);
        let row = serde_json::to_value(row.unwrap()).unwrap();
        assert_eq!(row["finite"], false);
        assert_eq!(row["self_crossings"], Value::Null);
    }
}
