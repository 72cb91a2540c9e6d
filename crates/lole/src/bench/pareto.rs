//! Quality against time: every scene with coarser and finer settings, and which of them no other
//! beats.
//!
//! The explicit method chooses its substeps by its bound, so it has one point. The paper's methods
//! in `f64` do the same work as it on one particle at a time: they would lie far to its right.

use std::num::NonZeroU32;

use lole_cloth::scenes::{ClothScene, SCENES, Setup};
use lole_export::report::Remark;
use lole_export::trade_off::{TradeOff, TradeOffPoint, TradeOffReport, trade_off_html};
use lole_language::Language;
use serde::Serialize;

use super::engine::{self, Method};
use super::row::BenchRow;
use super::stage::{self, StageScene};
use super::{Settings, WantedName};
use crate::args::BenchArgs;
use crate::output::OutputFolder;
use crate::patience::{check, stop_flag};
use crate::{Failure, summary};

/// Substeps and sweeps over the structural springs that are tried with each other.
const SUBSTEP_COUNTS: [u32; 6] = [2, 4, 8, 12, 16, 24];
const SWEEP_COUNTS: [u32; 4] = [1, 2, 4, 6];

/// Substeps that are tried on a dancer, beside the design's own.
const STAGE_SUBSTEP_COUNTS: [u32; 5] = [6, 8, 11, 18, 24];

/// A scene and a method, with every setting that is tried.
struct Case {
    scene: &'static str,
    about: &'static str,
    method: &'static str,
    variants: Vec<Variant>,
}

/// One setting.
struct Variant {
    sweeps: Option<u32>,
    is_own: bool,
    run: Box<dyn Fn(Settings) -> Result<BenchRow, Failure>>,
}

/// A setting of a method for a scene, and what it gives.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct ParetoPoint {
    /// Sweeps over the structural springs in a substep; left out where the method has none.
    pub(crate) sweeps: Option<u32>,
    /// Whether these are the scene's own settings.
    pub(crate) is_own: bool,
    /// Whether no other point of the scene is as fast and as good.
    pub(crate) on_front: bool,
    /// The phase that takes most of the time.
    pub(crate) longest_phase: Option<&'static str>,
    #[serde(flatten)]
    pub(crate) row: BenchRow,
}

impl ParetoPoint {
    /// Time of a frame [ms] and strain, the 99th percentile at its worst [%]; of cloth that is not
    /// finite, nothing is good.
    const fn cost_and_strain(&self) -> [f64; 2] {
        let strain = self.row.strain_worst_pct.p99;
        let strain = if self.row.finite {
            strain
        } else {
            f64::INFINITY
        };
        [self.row.frame_ms.median, strain]
    }
}

/// Measures every setting of every scene, or of the one that was named.
pub(super) fn run(args: &BenchArgs, settings: Settings, language: Language) -> Result<(), Failure> {
    let mut cases = cases();
    WantedName::scene(args).keep(&mut cases, |case| case.scene)?;
    WantedName::method(args).keep(&mut cases, |case| case.method)?;
    let output = (args.out.as_deref())
        .map(OutputFolder::create)
        .transpose()
        .map_err(Failure::Usage)?;
    let stop = stop_flag().map_err(Failure::Run)?;
    let mut points: Vec<ParetoPoint> = Vec::new();
    let abouts: Vec<_> = (cases.iter())
        .map(|case| (case.scene, case.about))
        .collect();
    for of_scene in cases.chunk_by(|one, next| one.scene == next.scene) {
        let mut found = Vec::new();
        for variant in of_scene.iter().flat_map(|case| &case.variants) {
            check(&stop)?;
            let row = (variant.run)(settings)?;
            found.push(ParetoPoint {
                sweeps: variant.sweeps,
                is_own: variant.is_own,
                on_front: false,
                longest_phase: row.longest_phase(),
                row,
            });
        }
        mark_front(&mut found);
        if !args.json {
            summary::print_pareto(&found, language);
        }
        points.append(&mut found);
    }
    let json = serde_json::to_string_pretty(&points).map_err(Failure::error)? + "\n";
    if args.json {
        summary::print_json(&json);
    }
    if let Some(mut output) = output {
        let page = trade_off_html(&report(&points, &abouts));
        (output.write("bench.html", page.as_bytes()))
            .and_then(|()| output.write("bench.json", json.as_bytes()))
            .map_err(Failure::Run)?;
        let paths = output.finish().map_err(Failure::Run)?;
        if !args.json {
            summary::print_files(&paths, language);
        }
    }
    Ok(())
}

/// Every scene, each with the methods that can run it.
fn cases() -> Vec<Case> {
    let engine = (SCENES.iter()).flat_map(|scene| {
        let methods = Method::of(scene).into_iter();
        methods.map(move |method| Case {
            scene: scene.name,
            about: scene.about,
            method: method.id(),
            variants: engine_variants(scene, method),
        })
    });
    let stage = (stage::SCENES.iter()).map(|scene| Case {
        scene: scene.name,
        about: scene.about,
        method: scene.method(),
        variants: stage_variants(scene),
    });
    engine.chain(stage).collect()
}

/// Every setting of a method for a scene of the engine.
fn engine_variants(scene: &'static ClothScene, method: Method) -> Vec<Variant> {
    let own = (scene.build)().config;
    let own = [own.substep_count, own.structural_sweep_count].map(NonZeroU32::get);
    let mut pairs: Vec<[u32; 2]> = match method {
        Method::ExplicitRows => Vec::new(),
        Method::Xpbd => (SUBSTEP_COUNTS.into_iter())
            .flat_map(|substeps| SWEEP_COUNTS.map(|sweeps| [substeps, sweeps]))
            .collect(),
    };
    if !pairs.contains(&own) {
        pairs.push(own);
    }
    let variant = |pair: [u32; 2]| Variant {
        sweeps: (method == Method::Xpbd).then_some(pair[1]),
        is_own: pair == own,
        run: Box::new(move |settings| {
            let mut setup: Setup = (scene.build)();
            let [substeps, sweeps] =
                pair.map(|count| NonZeroU32::new(count).unwrap_or(NonZeroU32::MIN));
            setup.config.substep_count = substeps;
            setup.config.structural_sweep_count = sweeps;
            engine::measure((scene, method), setup, settings).map_err(Failure::error)
        }),
    };
    pairs.into_iter().map(variant).collect()
}

/// Every setting for a scene with a dancer.
fn stage_variants(scene: &'static StageScene) -> Vec<Variant> {
    let counts = STAGE_SUBSTEP_COUNTS.map(Some).into_iter().chain([None]);
    let variant = |count: Option<u32>| Variant {
        sweeps: None,
        is_own: count.is_none(),
        run: Box::new(move |settings| {
            let mut design = (scene.design)();
            design.method.substep_count = count.or(design.method.substep_count);
            stage::measure(scene, &design, settings).map_err(Failure::error)
        }),
    };
    counts.map(variant).collect()
}

/// Marks the points that no other beats in one of time and strain without losing in the other.
fn mark_front(points: &mut [ParetoPoint]) {
    let values: Vec<[f64; 2]> = points.iter().map(ParetoPoint::cost_and_strain).collect();
    for (index, point) in points.iter_mut().enumerate() {
        let beaten = values.iter().any(|&other| beats(other, values[index]));
        point.on_front = point.row.finite && !beaten;
    }
}

/// Whether the first is no worse in both, and better in one.
fn beats(one: [f64; 2], other: [f64; 2]) -> bool {
    one[0] <= other[0] && one[1] <= other[1] && one != other
}

/// What the page shows.
fn report(points: &[ParetoPoint], abouts: &[(&str, &str)]) -> TradeOffReport {
    let of_scene = points.chunk_by(|one, next| one.row.scene == next.row.scene);
    let scene = |points: &[ParetoPoint]| {
        let name = points[0].row.scene;
        let about = abouts.iter().find(|(scene, _)| *scene == name);
        TradeOff {
            scene: name.to_owned(),
            about: about.map_or_else(String::new, |(_, about)| (*about).to_owned()),
            points: points.iter().map(entry).collect(),
        }
    };
    TradeOffReport {
        lole: env!("CARGO_PKG_VERSION").to_owned(),
        scenes: of_scene.map(scene).collect(),
    }
}

fn entry(point: &ParetoPoint) -> TradeOffPoint {
    let substeps = point.row.substeps;
    let sweeps = |word: &str| {
        (point.sweeps).map_or_else(String::new, |sweeps| format!(" × {sweeps} {word}"))
    };
    TradeOffPoint {
        method: point.row.method.to_owned(),
        settings: Remark {
            sentence: format!("{substeps} substeps{}", sweeps("sweeps")),
            sentence_ja: format!("{substeps} 分割{}", sweeps("回の繰り返し")),
        },
        is_own: point.is_own,
        frame_ms: point.row.frame_ms.median,
        strain_p99_pct: point.row.strain_worst_pct.p99,
        strain_max_pct: point.row.strain_worst_pct.max,
        longest_phase: point.longest_phase.map(str::to_owned),
        on_front: point.on_front,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lole_cloth::InstructionSet;

    #[test]
    fn the_front_is_what_nothing_beats() {
        let points = [[1.0, 5.0], [2.0, 3.0], [2.0, 4.0], [3.0, 3.0], [4.0, 1.0]];
        let front = points.map(|point| !points.iter().any(|&other| beats(other, point)));
        assert_eq!(front, [true, true, false, false, true]);
        assert!(
            !beats([1.0, 1.0], [1.0, 1.0]),
            "equals do not beat each other"
        );
        assert!(!beats([0.1, f64::INFINITY], [1.0, 1.0]));
    }

    #[test]
    fn every_setting_is_tried_once_and_the_scene_s_own_is_among_them() {
        for case in cases() {
            let own = case.variants.iter().filter(|variant| variant.is_own);
            assert_eq!(own.count(), 1, "{} {}", case.scene, case.method);
        }
        for scene in SCENES {
            let tried = engine_variants(scene, Method::Xpbd).len();
            assert!(SUBSTEP_COUNTS.len() * SWEEP_COUNTS.len() <= tried);
            assert_eq!(engine_variants(scene, Method::ExplicitRows).len(), 1);
        }
    }

    #[test]
    fn more_substeps_cost_more_and_strain_less() {
        let scene = ClothScene {
            frame_count: 60,
            ..*super::super::scene("hang-64")
        };
        let settings = Settings {
            instruction_set: InstructionSet::Detected,
            roofline: false,
        };
        let point = |substeps: u32| {
            let mut setup = (scene.build)();
            setup.config.substep_count = NonZeroU32::new(substeps).unwrap();
            engine::measure((&scene, Method::Xpbd), setup, settings).unwrap()
        };
        let (coarse, fine) = (point(2), point(16));
        assert!(coarse.frame_ms.median < fine.frame_ms.median);
        assert!(fine.strain_worst_pct.p99 < coarse.strain_worst_pct.p99);
    }
}
