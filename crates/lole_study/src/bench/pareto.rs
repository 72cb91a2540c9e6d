//! Quality against time: every scene with coarser and finer settings, and which of them no other
//! beats.
//!
//! The explicit method chooses its substeps by its bound, so it has one point. The paper's methods
//! in `f64` do the same work as it on one particle at a time: they would lie far to its right.

use std::num::NonZeroU32;

use lole_cloth::scenes::{ClothScene, SCENES, Setup};
use lole_export::report::Remark;
use lole_export::trade_off::{TradeOff, TradeOffPoint, TradeOffReport};
use serde::Serialize;

use super::engine::{self, Method};
use super::row::BenchRow;
use super::stage::{self, StageScene};
use super::{BenchSettings, Measure};
use crate::StudyError;

/// Substeps and sweeps over the structural springs that are tried with each other.
const SUBSTEP_COUNTS: [u32; 6] = [2, 4, 8, 12, 16, 24];
const SWEEP_COUNTS: [u32; 4] = [1, 2, 4, 6];

/// Substeps that are tried of gathered cloth on a dancer, and of garments of triangles, beside their own.
const STAGE_SUBSTEP_COUNTS: [u32; 5] = [6, 8, 11, 18, 24];
const GARMENT_SUBSTEP_COUNTS: [u32; 5] = [12, 24, 36, 64, 96];

/// A scene and a method, with every setting that is tried.
pub struct Case {
    /// Name of the scene.
    pub scene: &'static str,
    /// What is in it.
    pub about: &'static str,
    /// Name of the method.
    pub method: &'static str,
    variants: Vec<Variant>,
}

/// One setting.
struct Variant {
    sweeps: Option<u32>,
    is_own: bool,
    run: Measure,
}

/// A setting of a method for a scene, and what it gives.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ParetoPoint {
    /// Sweeps over the structural springs in a substep; left out where the method has none.
    pub sweeps: Option<u32>,
    /// Whether these are the scene's own settings.
    pub is_own: bool,
    /// Whether no other point of the scene is as fast and as good.
    pub on_front: bool,
    /// The phase that takes most of the time.
    pub longest_phase: Option<&'static str>,
    #[serde(flatten)]
    /// What was measured.
    pub row: BenchRow,
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

/// Measures every setting of the cases of one scene, for as long as `goes_on` says, and marks the front.
///
/// # Errors
/// A scene that cannot be built, or that it was called off.
pub fn points(
    of_scene: &[Case],
    settings: BenchSettings<'_>,
    goes_on: &dyn Fn() -> bool,
) -> Result<Vec<ParetoPoint>, StudyError> {
    let mut found = Vec::new();
    for variant in of_scene.iter().flat_map(|case| &case.variants) {
        if !goes_on() {
            return Err(StudyError::CalledOff);
        }
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
    Ok(found)
}

/// Every scene, each with the methods that can run it.
#[must_use]
pub fn cases() -> Vec<Case> {
    let engine = (SCENES.iter()).flat_map(|scene| {
        let methods = Method::of(scene).into_iter();
        methods.map(move |method| Case {
            scene: scene.name,
            about: scene.about,
            method: method.id(),
            variants: engine_variants(scene, method),
        })
    });
    let stage = stage::SCENES.iter().map(|scene| Case {
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
            Ok(engine::measure((scene, method), setup, settings)?)
        }),
    };
    pairs.into_iter().map(variant).collect()
}

/// Every setting for a scene with a dancer.
fn stage_variants(scene: &'static StageScene) -> Vec<Variant> {
    let has_triangles = scene.has_triangles();
    let counts = if has_triangles {
        GARMENT_SUBSTEP_COUNTS
    } else {
        STAGE_SUBSTEP_COUNTS
    };
    let counts = counts.map(Some).into_iter().chain([None]);
    let variant = |count: Option<u32>| Variant {
        sweeps: None,
        is_own: count.is_none(),
        run: Box::new(move |settings| {
            let mut designs = (scene.designs)();
            if has_triangles {
                let count = count.and_then(NonZeroU32::new);
                return Ok(stage::measure(scene, (&designs, count), settings)?);
            }
            for design in &mut designs {
                design.method.substep_count = count.or(design.method.substep_count);
            }
            Ok(stage::measure(scene, (&designs, None), settings)?)
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

/// What the page shows of the points of those cases.
#[must_use]
pub fn report(points: &[ParetoPoint], cases: &[Case]) -> TradeOffReport {
    let of_scene = points.chunk_by(|one, next| one.row.scene == next.row.scene);
    let scene = |points: &[ParetoPoint]| {
        let name = points[0].row.scene;
        let about = cases.iter().find(|case| case.scene == name);
        TradeOff {
            scene: name.to_owned(),
            about: about.map_or_else(String::new, |case| case.about.to_owned()),
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
    use crate::clock::TestClock;
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
        let settings = BenchSettings {
            instruction_set: InstructionSet::Detected,
            roofline: false,
            clock: &TestClock::start(),
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
