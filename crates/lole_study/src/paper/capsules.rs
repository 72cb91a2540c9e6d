//! How many capsules a body needs: the paper's "13, so that the collision is right and the speed
//! not too slow", as a curve.

use lole_cloth::method::reference::ReferenceModel;
use lole_costume::document::{BodyShapes, Design, MethodName};
use lole_export::study::{CapsulesEntry, SkirtOfStudy};

use super::runs::Runner;
use crate::figures::median_and_p99;
use crate::{Stopwatch, StudyError};

/// The bodies that are compared.
pub(super) const BODIES: [Body; 8] = [
    (BodyShapes::Capsules, 1),
    (BodyShapes::TwoCylinders, 2),
    (BodyShapes::Capsules, 4),
    (BodyShapes::Capsules, 8),
    (BodyShapes::Capsules, 13),
    (BodyShapes::Capsules, 20),
    (BodyShapes::Capsules, 40),
    (BodyShapes::Skin, 0),
];

/// What the cloth meets, and how many of it.
pub(super) type Body = (BodyShapes, u32);

/// Frames from one look at the skin to the next.
const FRAMES_PER_LOOK: u32 = 4;

/// A gathered skirt fine enough that what shows is the body's fault, not the grid's.
fn design((body, count): Body) -> Design {
    let mut design = Design::default();
    design.skirt.gather_ratio = 2.0;
    design.skirt.column_count = 96;
    design.skirt.row_count = 36;
    design.method.name = MethodName::Xpbd;
    design.method.body = body;
    if body == BodyShapes::Capsules {
        design.method.capsule_count = count;
    }
    design
}

/// Dances `frame_count` frames on one body.
pub(super) fn measure(
    runner: &Runner<'_>,
    body: Body,
    frame_count: u32,
) -> Result<(CapsulesEntry, SkirtOfStudy), StudyError> {
    let mut performance = runner.settled(&design(body))?;
    let mut frame_ms = Vec::new();
    let (mut depths, mut wrong_vertices) = (Vec::new(), 0);
    for frame in 0..frame_count {
        runner.check_stop()?;
        let watch = Stopwatch::start(runner.clock);
        let advanced = runner.pool.install(|| performance.advance());
        frame_ms.push(1e3 * watch.read().process_seconds);
        if advanced.is_err() {
            break;
        }
        if frame % FRAMES_PER_LOOK == 0 {
            performance.pose_body();
            let skin = performance.measure().skin;
            depths.push(1e3 * f64::from(skin.worst_depth));
            let wrong = skin.sunken_cloth_vertices + skin.showing_body_vertices;
            wrong_vertices = wrong_vertices.max(wrong);
        }
    }
    let production = performance.production();
    let entry = CapsulesEntry {
        body: body.0.id().to_owned(),
        count: body.1 as usize,
        skin_mm: depths.iter().copied().fold(0.0, f64::max),
        skin_mean_mm: depths.iter().sum::<f64>() / depths.len().max(1) as f64,
        wrong_vertices,
        frame_ms: median_and_p99(&frame_ms),
    };
    let worn = production.skirt();
    let worn = worn.ok_or(StudyError::NoSkirt)?;
    let model = ReferenceModel::new(&worn.sewn.spec)?;
    let skirt = SkirtOfStudy {
        particles: worn.sewn.spec.grid.particle_count(),
        springs: performance.spring_count(),
        damping_per_s: f64::from(worn.fabric.drag_rate),
        highest_frequency_rad_per_s: model.largest_frequency_bound(),
    };
    Ok((entry, skirt))
}
