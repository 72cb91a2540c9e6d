//! Scenes by which a machine is held to the same bits as every other: the engine's, as its golden hashes are made,
//! and dances of the product. A browser runs them, and a processor of another kind.
//!
//! Whoever runs them brings the clock, since this crate has none.

use std::fmt::Write as _;

use lole_cloth::method::explicit_rows::{self, ExplicitModel};
use lole_cloth::scenes::{ClothScene, FRAME_DT, SCENES};
use lole_cloth::{BuildError, ClothModel, ClothState, SolverConfig, StepInput, state_hash, step};
use lole_costume::document::{Design, parse};

use crate::{FRAMES_PER_SECOND, Performance, Production};

/// Frames of a scene, as the golden hashes have them.
const FRAME_COUNT: u32 = 6;
/// Frames by FB Euler, which takes hundreds of substeps in each.
const FRAME_COUNT_OF_FB_EULER: u32 = 2;
/// What the scenes by FB Euler are called after their names.
const ROWS: &str = " rows";
/// The built-in skirt on its dancer, settled and danced for a second.
const DANCE: &str = "dance";
/// Its vertices around and down: a second of it takes some seconds in a page.
const DANCE_GRID: [u32; 2] = [288, 40];
/// A dress of triangles with a lei, sewn, settled and danced for a second.
const DRESS: &str = "dress";

/// Milliseconds since any moment.
pub type Clock<'a> = &'a dyn Fn() -> f64;

/// Names of all scenes.
#[must_use]
pub fn names() -> Vec<String> {
    let xpbd = SCENES.iter().map(|scene| scene.name.to_owned());
    // The largest takes minutes by FB Euler.
    let rows = SCENES.iter().filter(|scene| scene.name != "hang-256");
    let rows = rows.map(|scene| format!("{}{ROWS}", scene.name));
    xpbd.chain(rows)
        .chain([DANCE, DRESS].map(str::to_owned))
        .collect()
}

/// Runs a scene: its name, the hash of its last state, and the median time of a frame [ms], in one line. `None`
/// where there is no such scene or it cannot be built.
#[must_use]
pub fn run(name: &str, clock: Clock<'_>) -> Option<String> {
    match name {
        DANCE => return danced(name, &coarse_skirt(), clock),
        DRESS => return danced(name, &dress()?, clock),
        _ => {}
    }
    let is_by_rows = name.ends_with(ROWS);
    let of = name.strip_suffix(ROWS).unwrap_or(name);
    let scene = SCENES.iter().find(|scene| scene.name == of)?;
    let row = if is_by_rows {
        by_rows(name, scene, clock)
    } else {
        by_xpbd(name, scene, clock)
    };
    row.ok()
}

fn by_xpbd(name: &str, scene: &ClothScene, clock: Clock<'_>) -> Result<String, BuildError> {
    let model = ClothModel::new(&(scene.build)().spec)?;
    let frames = (name, scene, FRAME_COUNT);
    Ok(played(frames, (&model, clock), |config, input, state| {
        step(&model, config, input, state, FRAME_DT).is_ok()
    }))
}

fn by_rows(name: &str, scene: &ClothScene, clock: Clock<'_>) -> Result<String, BuildError> {
    let model = ExplicitModel::new(&(scene.build)().spec)?;
    let frames = (name, scene, FRAME_COUNT_OF_FB_EULER);
    let on = (model.cloth(), clock);
    Ok(played(frames, on, |config, input, state| {
        explicit_rows::step(&model, config, input, state, FRAME_DT).is_ok()
    }))
}

fn played(
    (name, scene, frame_count): (&str, &ClothScene, u32),
    (model, clock): (&ClothModel, Clock<'_>),
    advance: impl Fn(&SolverConfig, &StepInput<'_>, &mut ClothState) -> bool,
) -> String {
    let setup = (scene.build)();
    let pins = model.pin_indices().iter();
    let pins: Vec<_> = pins.map(|&pin| setup.positions[pin as usize]).collect();
    let mut state = ClothState::new(model, &setup.positions);
    let mut times = Vec::new();
    for frame in 0..frame_count {
        let capsules = (scene.capsules)(f64::from(frame + 1) * f64::from(FRAME_DT));
        let input = StepInput {
            pin_targets: &pins,
            capsules: &capsules,
            ..StepInput::default()
        };
        let mut moved = false;
        times.push(milliseconds(clock, || {
            moved = advance(&setup.config, &input, &mut state);
        }));
        debug_assert!(moved, "a target for every pin");
    }
    line(name, state_hash(&state), times)
}

/// The built-in design on a grid of [`DANCE_GRID`].
fn coarse_skirt() -> Design {
    let mut design = Design::default();
    [design.skirt.column_count, design.skirt.row_count] = DANCE_GRID;
    design
}

/// A muʻumuʻu and a lei.
fn dress() -> Option<Design> {
    let garments = ["muumuu", "lei"].map(|kind| format!("[[garment]]\nkind = \"{kind}\"\n"));
    let mut design = parse(&format!("lole = 1\n\n{}", garments.join("\n")), DRESS).ok()?;
    design.skirt.is_worn = false;
    Some(design)
}

/// Everything from the tape to the dance: body, draft, sewing, settling, one second of steps.
fn danced(name: &str, design: &Design, clock: Clock<'_>) -> Option<String> {
    let mut performance = Performance::new(Production::new(design).ok()?).ok()?;
    let mut times = Vec::new();
    for _ in 0..Performance::settle_frame_count() + FRAMES_PER_SECOND {
        let mut result = Ok(());
        times.push(milliseconds(clock, || {
            result = performance.advance().map(|_| ());
        }));
        result.ok()?;
    }
    Some(line(name, performance.state_hash(), times))
}

fn line(name: &str, hash: u64, mut times: Vec<f64>) -> String {
    times.sort_by(f64::total_cmp);
    let median = times.get(times.len() / 2).copied().unwrap_or(0.0);
    let mut line = String::new();
    // A string takes everything.
    write!(line, "{name:16} {hash:016x} {median:9.2} ms").unwrap_or_default();
    line
}

/// Milliseconds that something takes.
fn milliseconds(clock: Clock<'_>, work: impl FnOnce()) -> f64 {
    let start = clock();
    work();
    clock() - start
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scenes_come_to_the_hashes_that_the_engine_is_held_to() {
        let golden = include_str!("../../../tests/golden/lole_cloth/state_hashes.txt");
        for name in ["hang-64", "hang-64 rows", "skirt"] {
            let row = run(name, &|| 0.0).unwrap();
            let hash = row.split_whitespace().rev().nth(2).unwrap();
            let known = golden
                .lines()
                .any(|line| line.starts_with(name) && line.ends_with(hash));
            assert!(known, "{row}");
        }
        assert!(run("no such scene", &|| 0.0).is_none());
    }

    /// Dancer, draft, sewing and dance: whatever a processor does in another way shows in the last state.
    #[test]
    fn golden_dances_come_to_the_same_state_on_every_machine() {
        let hash = |name: &str| {
            let row = run(name, &|| 0.0).unwrap();
            let hash = row.split_whitespace().rev().nth(2);
            format!("{name:16} {}\n", hash.unwrap_or_default())
        };
        lole_golden::check("dances.txt", &[DANCE, DRESS].map(hash).concat());
    }
}
