//! The 3D file, and the dance that film and 3D file show: the dance of the design once more from its beginning, at its own pace, so that what
//! is written does not depend on how fast this machine shows it.

use lole_picture::baked::{self, Keys};
use lole_picture::studio::PhotoStudio;
use lole_stage::{FRAMES_PER_SECOND, Performance, Production};

use super::paper::said;
use super::{Line, Unmade, Wish, flew_apart};
use crate::platform;

/// The dancer with her dance as the bytes of a GLB.
pub(super) fn model(wish: &Wish, line: &Line<'_>) -> Result<Vec<u8>, Unmade> {
    let mut performance = performance(wish)?;
    let photo = PhotoStudio::new(&performance).map_err(|error| Unmade::of(&error))?;
    let mut keys = Keys::default();
    let every = FRAMES_PER_SECOND / baked::key_rate(danced(&performance));
    dance(&mut performance, line, |performance, frame| {
        if !frame.is_multiple_of(every) {
            return Ok(());
        }
        performance.pose_body();
        let kept = keys.keep(performance);
        kept.map_err(|error| Unmade::of(&error))
    })?;
    let file = baked::dancer_glb(&performance, &keys, photo.covers());
    file.map(|file| file.bytes)
        .map_err(|error| Unmade::of(&error))
}

/// Simulated frames of the dance.
pub(crate) fn danced(performance: &Performance) -> u32 {
    let design = &performance.production().design;
    let whole = (performance.production().dance).whole(design.motion.repeat);
    frame_count(design.duration_s(whole))
}

/// What is performed, before its first frame.
pub(crate) fn performance(wish: &Wish) -> Result<Performance, Unmade> {
    let production = Production::new(&wish.design).map_err(|error| said(&error))?;
    Performance::new(production).map_err(|error| said(&error))
}

/// Lets the cloth come to rest and dances the whole dance; `look` is called before every frame of it, with its
/// number.
pub(crate) fn dance(
    performance: &mut Performance,
    line: &Line<'_>,
    mut look: impl FnMut(&mut Performance, u32) -> Result<(), Unmade>,
) -> Result<(), Unmade> {
    // Half of the processor: the window dances on.
    let pool = platform::pool((platform::cores() / 2).max(1));
    let danced = danced(performance);
    let settled = Performance::settle_frame_count();
    let all = (settled + danced).max(1) as f32;
    for frame in 0..settled + danced {
        line.goes_on(frame as f32 / all)?;
        if let Some(danced) = frame.checked_sub(settled) {
            look(performance, danced)?;
        }
        let advanced = match &pool {
            Some(pool) => pool.install(|| performance.advance()),
            None => performance.advance(),
        };
        advanced.map_err(|found| Unmade::Failed(flew_apart(Some(found.time))))?;
    }
    performance.pose_body();
    Ok(())
}

/// Frames of a dance of `seconds`.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a document allows minutes, not years"
)]
fn frame_count(seconds: f64) -> u32 {
    (seconds * f64::from(FRAMES_PER_SECOND)).round() as u32
}
