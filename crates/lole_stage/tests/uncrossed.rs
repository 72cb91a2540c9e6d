//! The promise on whole costumes, in every frame: what does not cross at the start never comes to cross,
//! by exact predicates and a search that share nothing with the engine. All dancers, steps and scenes are
//! run by `cargo run --release -p lole_stage --example uncrossed_dances`.

#[path = "../../lole_cloth/tests/exact_support/mod.rs"]
mod exact_support;
mod watch;

use std::thread;

use lole_costume::document::Design;
use lole_hula::DanceStep;
use lole_stage::{Performance, Production, six_dancers};
use watch::Watch;

/// The first and the last dancer, so that both sizes are there, and how long each dances [s].
const DANCERS: [usize; 2] = [0, 5];
const SECONDS: f32 = 1.0;

/// Dances a step at its fastest, in a skirt with less cloth than the film's; what the watches say
/// where the promise was broken.
fn danced(dancer: usize, step: DanceStep) -> Vec<String> {
    let (name, worn_by) = six_dancers()[dancer].clone();
    let mut design = Design {
        dancer: worn_by,
        ..Design::default()
    };
    design.skirt.gather_ratio = 2.0;
    (design.skirt.column_count, design.skirt.row_count) = (160, 40);
    design.motion.step = step;
    design.motion.tempo_bpm = f64::from(step.tempo()[1]);
    let production = Production::new(&design).expect("can be sewn");
    let mut performance = Performance::new(production).expect("she is on stage");
    let mut watches = Watch::all(&performance);
    while performance.time() < SECONDS {
        performance.advance().expect("the cloth is somewhere");
        Watch::look_at_all(&mut watches, &performance);
    }
    let broken = watches.iter().filter(|watch| !watch.broken.is_empty());
    broken
        .map(|watch| format!("{name}, {}: {watch}", step.id()))
        .collect()
}

#[test]
fn no_frame_of_a_fast_dance_begins_without_a_crossing_and_ends_with_one() {
    let danced = thread::scope(|scope| {
        let dances = DANCERS.map(|dancer| {
            let steps = [DanceStep::ALL[0], DanceStep::ALL[DanceStep::ALL.len() - 1]];
            scope.spawn(move || steps.map(|step| danced(dancer, step)).concat())
        });
        dances.map(|it| it.join().expect("she danced"))
    });
    assert_eq!(danced.concat(), Vec::<String>::new());
}
