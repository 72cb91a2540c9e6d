//! Scenes with a dancer: what a whole frame of the product costs.

use std::num::NonZeroU32;

use glam::Vec3;
use lole_cloth::diagnose::StrainSummary;
use lole_cloth::{Phase, diagnose};
use lole_costume::document::{Design, parse};
use lole_geom::fnv;
use lole_stage::{
    Division, Performance, Production, RunMetrics, StageError, double_pau, six_dancers,
};
use rayon::iter::{IntoParallelRefMutIterator as _, ParallelIterator as _};

use super::BenchSettings;
use super::phases::{PhaseClock, PhaseTime};
use super::row::{BenchRow, Crossings, Run};
use crate::Timing;

/// Dancers in what they wear.
pub(super) struct StageScene {
    pub(super) name: &'static str,
    /// What is in it.
    pub(super) about: &'static str,
    frame_count: u32,
    /// Of its garments of triangles.
    division: Division,
    /// By dancer.
    pub(super) designs: fn() -> Vec<Design>,
}

impl StageScene {
    /// The method that moves its cloth.
    pub(super) fn method(&self) -> &'static str {
        (self.designs)()
            .first()
            .map_or("", |design| design.method.name.id())
    }

    /// What a number of substeps that is asked for goes to: the garments of triangles where there are any, or the
    /// gathered cloth, whose own curve is that of a skirt alone.
    pub(super) fn has_triangles(&self) -> bool {
        let has_own = |design: &Design| {
            let mut garments = design.garments.iter();
            garments.any(|garment| garment.template.is_sewn())
        };
        (self.designs)().iter().any(has_own)
    }
}

/// Every scene with a dancer.
pub(super) const SCENES: &[StageScene] = &[
    StageScene {
        name: "pau-fine",
        about: "a pāʻū skirt of 28,160 particles on a dancer",
        frame_count: 300,
        division: Division::Full,
        designs: || vec![Design::default()],
    },
    StageScene {
        name: "pau-layers",
        about: "a double pāʻū and a top, 41,408 particles on a dancer",
        frame_count: 300,
        division: Division::Full,
        designs: || vec![double_pau()],
    },
    StageScene {
        name: "muumuu",
        about: "a muʻumuʻu and a lei on a dancer",
        frame_count: 150,
        division: Division::Full,
        designs: || vec![fitted("muumuu")],
    },
    StageScene {
        name: "holoku",
        about: "a holokū and a lei on a dancer",
        frame_count: 150,
        division: Division::Full,
        designs: || vec![fitted("holoku")],
    },
    StageScene {
        name: "kikepa",
        about: "a kīkepa and a lei on a dancer",
        frame_count: 150,
        division: Division::Full,
        designs: || vec![fitted("kikepa")],
    },
    StageScene {
        name: "muumuu-fine",
        about: "a muʻumuʻu of 1.2 cm triangles and a lei on a dancer",
        frame_count: 150,
        division: Division::Fine,
        designs: || vec![fitted("muumuu")],
    },
    StageScene {
        name: "holoku-fine",
        about: "a holokū of 1.2 cm triangles and a lei on a dancer",
        frame_count: 150,
        division: Division::Fine,
        designs: || vec![fitted("holoku")],
    },
    StageScene {
        name: "kikepa-fine",
        about: "a kīkepa of 1.2 cm triangles and a lei on a dancer",
        frame_count: 150,
        division: Division::Fine,
        designs: || vec![fitted("kikepa")],
    },
    StageScene {
        name: "blouse-pau",
        about: "a blouse, a pāʻū skirt and a lei on a dancer",
        frame_count: 150,
        division: Division::Full,
        designs: || vec![over_skirt("blouse")],
    },
    StageScene {
        name: "halau",
        about: "six dancers in pāʻū skirts, three of them far away with coarser cloth",
        frame_count: 100,
        division: Division::Full,
        designs: halau,
    },
];

/// A garment of triangles with a lei, and nothing else.
fn fitted(kind: &str) -> Design {
    let mut design = over_skirt(kind);
    design.skirt.is_worn = false;
    design
}

/// The same over the skirt.
fn over_skirt(kind: &str) -> Design {
    let garments = [kind, "lei"].map(|kind| format!("[[garment]]\nkind = \"{kind}\"\n"));
    let text = format!("lole = 1\n\n{}", garments.join("\n"));
    parse(&text, kind).expect("a document of its own")
}

/// Particles of a skirt that is seen from far away: by columns and rows.
const COARSE: (u32, u32) = (256, 32);

fn halau() -> Vec<Design> {
    let dancers = six_dancers().into_iter().enumerate();
    let designs = dancers.map(|(place, (_, dancer))| {
        let mut design = Design {
            dancer,
            ..Design::default()
        };
        if place % 2 == 1 {
            (design.skirt.column_count, design.skirt.row_count) = COARSE;
        }
        design
    });
    designs.collect()
}

/// A scene's dancers, settled and about to dance; garments of triangles with so many substeps, or their own.
fn settled(
    (scene, designs, garment_substeps): (&StageScene, &[Design], Option<NonZeroU32>),
    settings: BenchSettings<'_>,
) -> Result<Vec<Performance>, StageError> {
    let all = designs.iter().map(|design| {
        let mut production = Production::divided(design, scene.division)?;
        if let Some(count) = garment_substeps {
            production.set_garment_substep_count(count);
        }
        let mut performance = Performance::new(production)?;
        performance.set_instruction_set(settings.instruction_set);
        // What stops short is seen in the figures of the frames.
        while performance.time() < 0.0 && performance.advance().is_ok() {}
        Ok(performance)
    });
    all.collect()
}

/// Dances a scene twice with the same bits: once for its times, with nothing between the frames that
/// would empty the caches, and once for what the cloth does in every frame. Timed is all that a
/// frame needs before it can be drawn: pose, capsules, pins and cloth.
pub(super) fn measure(
    scene: &StageScene,
    (designs, garment_substeps): (&[Design], Option<NonZeroU32>),
    settings: BenchSettings<'_>,
) -> Result<BenchRow, StageError> {
    let all = (scene, designs, garment_substeps);
    let timed = time(scene, settled(all, settings)?, settings);
    let mut judged = settled(all, settings)?;
    let mut metrics = vec![Vec::new(); judged.len()];
    let mut crossings = Crossings::none();
    let mut inversions = 0;
    for _ in 0..scene.frame_count {
        let went_on = advance_all(&mut judged);
        for (metrics, performance) in metrics.iter_mut().zip(&mut judged) {
            performance.pose_body();
            metrics.push(performance.measure());
            inversions = inversions.max(performance.layer_inversions());
        }
        // A skirt that has settled crosses itself no more than one that dances.
        crossings.see(u32::MAX, || judged.iter().map(self_crossings).sum());
        if !went_on {
            break;
        }
    }
    let hash = hash_of(&judged);
    debug_assert_eq!(hash, timed.hash, "{}", scene.name);
    let found: Vec<RunMetrics> = metrics.iter().map(|it| RunMetrics::of(it)).collect();
    let worst = |strain: fn(&RunMetrics) -> StrainSummary| {
        let strains = found.iter().map(strain);
        strains.fold(StrainSummary::default(), |all, it| StrainSummary {
            mean: all.mean.max(it.mean),
            p99: all.p99.max(it.p99),
            max: all.max.max(it.max),
        })
    };
    let deepest = |depth: fn(&RunMetrics) -> f32| found.iter().map(depth).fold(0.0, f32::max);
    let skin = deepest(|it| it.skin.worst_depth);
    let gathers_only = judged.iter().all(|it| it.production().dressed.is_empty());
    let has_layers = judged.iter().any(|it| 1 < it.production().garments.len());
    let run = Run {
        scene: scene.name,
        method: scene.method(),
        particles: (judged.iter())
            .map(|it| it.production().moving_count())
            .sum(),
        substeps: judged
            .iter()
            .map(Performance::substep_count)
            .max()
            .unwrap_or(0),
        timings: timed.timings,
        phases: timed.phases,
        spring_roofline: None,
        finite: judged.iter().all(is_finite),
        strain_end: worst(|it| it.strain_end),
        strain_worst: worst(|it| it.strain),
        penetration: deepest(|it| it.capsule_penetration).max(skin),
        skin_penetration: Some(skin),
        crossings: Some(crossings),
        layer_inversions: has_layers.then_some(inversions),
        rms_speed: (judged.iter().filter(|_| gathers_only))
            .map(Performance::rms_speed)
            .reduce(f32::max),
        byte_count: gathers_only.then(|| judged.iter().map(Performance::byte_count).sum()),
        state_hash: hash,
    };
    Ok(run.row())
}

fn hash_of(performances: &[Performance]) -> u64 {
    let hashes = performances.iter().map(Performance::state_hash);
    hashes
        .reduce(|all, next| all.wrapping_mul(fnv::PRIME) ^ next)
        .unwrap_or(0)
}

fn is_finite(performance: &Performance) -> bool {
    let is_finite = |positions: &[Vec3]| diagnose::first_non_finite(positions).is_none();
    let mut dressed = 0..performance.production().dressed.len();
    is_finite(performance.cloth_positions())
        && dressed.all(|place| is_finite(performance.dressed_positions(place)))
}

/// Moves all dancers on by a frame, on as many threads as there are; whether all of them dance on.
fn advance_all(performances: &mut [Performance]) -> bool {
    match performances {
        [only] => only.advance().is_ok(),
        _ => {
            let went_on = performances.par_iter_mut().map(|it| it.advance().is_ok());
            went_on.reduce(|| true, |all, one| all && one)
        }
    }
}

/// What was timed of a scene: its frames, their phases, and the bits that it ended with.
struct Timed {
    timings: Vec<Timing>,
    phases: Option<Vec<PhaseTime>>,
    hash: u64,
}

fn time(
    scene: &StageScene,
    mut performances: Vec<Performance>,
    settings: BenchSettings<'_>,
) -> Timed {
    let (mut timings, mut clock) = (Vec::new(), PhaseClock::new(settings.clock));
    for frame in 0..scene.frame_count {
        if !advance(&mut performances, frame, &mut timings, &mut clock) {
            break;
        }
    }
    Timed {
        timings,
        phases: clock.times(),
        hash: hash_of(&performances),
    }
}

/// The next frame, timed or observed; whether the dance goes on. Phases are those of one dancer.
fn advance(
    performances: &mut [Performance],
    frame: u32,
    timings: &mut Vec<Timing>,
    clock: &mut PhaseClock<'_>,
) -> bool {
    if let [only] = performances
        && PhaseClock::observes(frame)
    {
        clock.begin_frame();
        let advanced = only.advance_observed(&mut |phase| clock.passed(phase));
        clock.passed(Phase::Outside);
        return advanced.is_ok();
    }
    let watch = clock.stopwatch();
    let went_on = advance_all(performances);
    timings.push(watch.read());
    went_on
}

/// Edges of a garment that cross a triangle of the same one, of all garments.
fn self_crossings(performance: &Performance) -> Option<usize> {
    let production = performance.production();
    let gathered = (production.garments.iter()).map(|garment| performance.self_crossings(garment));
    let dressed = production.dressed.iter().enumerate();
    let dressed = dressed
        .map(|(place, garment)| (garment.dressed).crossings(performance.dressed_positions(place)));
    gathered.chain(dressed).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_scene_has_dancers_in_what_it_is_named_for() {
        for scene in SCENES {
            let designs = (scene.designs)();
            let is_gathered = designs.iter().all(|design| design.skirt.is_worn);
            let is_named_for = |id: &str| scene.name.split('-').any(|word| word == id);
            let mut own = designs[0].garments.iter();
            let has_own = own.any(|it| it.template.is_sewn() && is_named_for(it.template.id));
            assert!(is_gathered || has_own, "{}", scene.name);
            assert_eq!(scene.has_triangles(), has_own, "{}", scene.name);
            assert_eq!(scene.method(), "xpbd");
        }
        let halau = halau();
        let counts: Vec<u32> = halau.iter().map(|it| it.skirt.column_count).collect();
        assert_eq!(counts.len(), 6);
        assert_eq!(counts.iter().filter(|&&it| it == COARSE.0).count(), 3);
    }
}
