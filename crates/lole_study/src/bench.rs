//! What a frame costs, scene by scene, with the quality it buys.

mod engine;
pub mod pareto;
mod phases;
mod roofline;
mod row;
mod stage;

use lole_cloth::InstructionSet;
use lole_cloth::scenes::{ClothScene, SCENES, SIZES};

use crate::{Clock, StudyError};
pub(crate) use engine::pins;
pub use phases::PhaseTime;
pub use roofline::SpringRoofline;
pub use row::BenchRow;

/// The scene of the reference row.
const REFERENCE: &str = "skirt";

/// What holds for every scene.
#[derive(Clone, Copy)]
pub struct BenchSettings<'a> {
    /// Vector instructions of the engine.
    pub instruction_set: InstructionSet,
    /// Whether the springs are held against the best that this machine can do.
    pub roofline: bool,
    /// What times the frames.
    pub clock: &'a dyn Clock,
}

/// A scene of the table.
type Measure = Box<dyn Fn(BenchSettings<'_>) -> Result<BenchRow, StudyError> + Send + Sync>;

/// A row of the table that can be asked for.
pub struct Entry {
    /// Name of the scene.
    pub scene: &'static str,
    /// Name of the method.
    pub method: &'static str,
    measure: Measure,
}

impl Entry {
    /// Runs the scene and measures it.
    ///
    /// # Errors
    /// A scene that cannot be built.
    pub fn measure(&self, settings: BenchSettings<'_>) -> Result<BenchRow, StudyError> {
        (self.measure)(settings)
    }
}

/// A scene of the engine by one of its methods, from its own start with its own settings.
fn entry(scene: &'static ClothScene, method: engine::Method) -> Entry {
    Entry {
        scene: scene.name,
        method: method.id(),
        measure: Box::new(move |settings| {
            Ok(engine::measure((scene, method), (scene.build)(), settings)?)
        }),
    }
}

/// Every scene by every method that can run it: those of the engine, then those with a dancer.
#[must_use]
pub fn entries() -> Vec<Entry> {
    let engine = SCENES.iter().flat_map(|scene| {
        let methods = engine::Method::of(scene).into_iter();
        methods.map(move |method| entry(scene, method))
    });
    let stage = stage::SCENES.iter().map(|scene| {
        let measure: Measure =
            Box::new(|settings| Ok(stage::measure(scene, (&(scene.designs)(), None), settings)?));
        Entry {
            scene: scene.name,
            method: scene.method(),
            measure,
        }
    });
    engine.chain(stage).collect()
}

/// The row that others are held against in the same run, because machines differ and are noisy: the skirt by FB
/// Euler on vectors, a method that does not change.
#[must_use]
pub fn reference() -> Entry {
    entry(scene(REFERENCE), engine::Method::ExplicitRows)
}

/// The same square at several sizes, by every method of the engine.
#[must_use]
pub fn sizes() -> Vec<Entry> {
    let methods = [engine::Method::Xpbd, engine::Method::ExplicitRows];
    let sizes = methods
        .into_iter()
        .flat_map(|method| SIZES.iter().map(move |scene| entry(scene, method)));
    sizes.collect()
}

/// A scene of the engine.
pub(crate) fn scene(name: &str) -> &'static ClothScene {
    let scene = SCENES.iter().find(|scene| scene.name == name);
    scene.expect("one of the table")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::clock::TestClock;
    use serde_json::Value;

    #[test]
    fn a_row_has_its_keys_and_nulls_where_there_is_nothing_to_count() {
        let settings = BenchSettings {
            instruction_set: InstructionSet::Detected,
            roofline: true,
            clock: &TestClock::start(),
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
