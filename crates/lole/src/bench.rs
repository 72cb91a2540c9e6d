//! `lole bench`: what a frame costs on this machine, scene by scene, with the quality it buys.

mod engine;
mod stage;

use lole_cloth::InstructionSet;
use lole_cloth::scenes::SCENES;
use lole_export::report::{MeanPercentileMax, MedianPercentile, Worst};
use lole_language::{Language, Words, words};
use serde::Serialize;

use crate::args::{BenchArgs, Vectors};
use crate::{Failure, summary};

/// Frame from which the cloth may not cross itself: some scenes start so tightly folded that it
/// does.
const CROSSINGS_FROM: u32 = 30;

/// One scene on this machine.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct BenchRow {
    pub(crate) scene: &'static str,
    pub(crate) method: &'static str,
    pub(crate) particles: usize,
    /// Substeps of a frame; the median where they follow the cloth.
    pub(crate) substeps: u32,
    pub(crate) threads: usize,
    /// Processor time of a frame, all threads [ms].
    pub(crate) frame_ms: MedianPercentile,
    /// Wall time of a frame [ms].
    pub(crate) frame_wall_ms: MedianPercentile,
    /// Processor time for one particle in one substep [ns].
    pub(crate) particle_substep_ns: f64,
    /// Absolute structural strain at the end [%].
    pub(crate) strain_end_pct: MeanPercentileMax,
    /// Its worst from the seventh frame on [%].
    pub(crate) strain_worst_pct: MeanPercentileMax,
    /// Deepest free particle, over the run, in the body that the cloth meets: capsules, or the skin.
    pub(crate) penetration_mm: Worst<f64>,
    /// Deepest particle below the drawn skin over the run; left out where there is no skin.
    pub(crate) skin_penetration_mm: Option<Worst<f64>>,
    /// Edges of the cloth that cross one of its triangles, most of any frame from
    /// [`CROSSINGS_FROM`] on; left out where the cloth may pass through itself.
    pub(crate) self_crossings: Option<usize>,
    /// Particles on the wrong side of the garment next to them, most of any frame; left out where
    /// one garment is worn.
    pub(crate) layer_inversions: Option<usize>,
    /// Root mean square of the particles' speeds at the end [m/s].
    pub(crate) rms_speed_m_per_s: f64,
    /// Memory of the prepared cloth and its state.
    pub(crate) bytes_per_particle: f64,
    /// All bits of the state at the end.
    pub(crate) state_hash: String,
}

/// A scene of the table.
type Measure = Box<dyn Fn(InstructionSet) -> Result<BenchRow, Failure> + Send + Sync>;

/// A row of the table that can be asked for.
struct Entry {
    scene: &'static str,
    method: &'static str,
    measure: Measure,
}

/// Every scene by every method that can run it: those of the engine, then those with a dancer.
fn entries() -> Vec<Entry> {
    let engine = SCENES.iter().flat_map(|scene| {
        engine::Method::of(scene).into_iter().map(move |method| {
            let measure: Measure =
                Box::new(move |set| engine::measure(scene, method, set).map_err(Failure::error));
            Entry {
                scene: scene.name,
                method: method.id(),
                measure,
            }
        })
    });
    let stage = stage::SCENES.iter().map(|scene| {
        let measure: Measure = Box::new(|set| stage::measure(scene, set).map_err(Failure::error));
        Entry {
            scene: scene.name,
            method: scene.method(),
            measure,
        }
    });
    engine.chain(stage).collect()
}

/// Keeps what has the name that was asked for, which must be one of them.
fn choose(
    entries: &mut Vec<Entry>,
    (option, name): (&'static str, Option<&str>),
    what: Words,
    name_of: fn(&Entry) -> &'static str,
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

/// Runs every scene, or the one that was named.
pub(crate) fn run(args: &BenchArgs, language: Language) -> Result<(), Failure> {
    let mut chosen = entries();
    let scene = ("--scene", args.scene.as_deref());
    choose(&mut chosen, scene, words("場面", "scene"), |entry| {
        entry.scene
    })?;
    let method = ("--method", args.method.as_deref());
    choose(&mut chosen, method, words("方法", "method"), |entry| {
        entry.method
    })?;
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(usize::from(args.threads))
        .build()
        .map_err(Failure::error)?;
    let set = match args.vectors {
        Vectors::Detected => InstructionSet::Detected,
        Vectors::Wide => InstructionSet::Wide,
        Vectors::Baseline => InstructionSet::Baseline,
    };
    let mut rows = Vec::new();
    if !args.json {
        summary::print_bench_head(language);
    }
    for entry in chosen {
        let row = pool.install(|| (entry.measure)(set))?;
        if !args.json {
            summary::print_bench_row(&row);
        }
        rows.push(row);
    }
    if args.json {
        summary::print_json(&serde_json::to_string_pretty(&rows).map_err(Failure::error)?);
    }
    Ok(())
}
