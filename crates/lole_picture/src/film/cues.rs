//! Light cues: the lamps of a theater change with the parts of a choreography.

use lole_costume::document::{StageMood, StageSet};
use lole_geom::narrow;
use lole_render::{Exposure, Image, RenderError, Size};
use lole_stage::{Danced, Production};

use crate::Scenery;

/// How long the lamps take from one mood to the next, about the first count of a part [s].
const FADE: f32 = 1.6;

/// When the lamps of a film change.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Cues {
    scenery: Scenery,
    /// Times of the changes [s], in their order, and the moods after them.
    changes: Vec<(f32, StageMood)>,
}

impl Cues {
    /// Those of a production; only a theater has lamps that change.
    pub(crate) fn of(production: &Production) -> Self {
        let (stage, motion) = (&production.design.stage, &production.design.motion);
        let mut changes = Vec::new();
        if let (StageSet::Theater, Danced::Step(dance)) = (stage.set, &production.dance) {
            let mut beat = dance.beat_at(f64::from(dance.lead_in()));
            let mut mood = stage.mood;
            for part in &motion.parts {
                let next = part.mood.unwrap_or(mood);
                if next != mood {
                    changes.push((narrow(dance.time_of_beat(beat)), next));
                }
                mood = next;
                beat += f64::from(part.beat_count);
            }
        }
        Self {
            scenery: Scenery::of(stage),
            changes,
        }
    }

    /// What is around her at a time [s], and what it goes over into, with its share.
    pub(crate) fn at(&self, time: f32) -> (Scenery, Option<(Scenery, f32)>) {
        let lit = |mood: StageMood| Scenery {
            mood,
            ..self.scenery
        };
        let mut now = (self.scenery, None);
        for &(change, mood) in &self.changes {
            let share = ((time - change) / FADE + 0.5).clamp(0.0, 1.0);
            if share <= 0.0 {
                break;
            }
            let settled = match now {
                (_, Some((next, _))) => next,
                (before, None) => before,
            };
            let eased = share * share * (3.0 - 2.0 * share);
            now = if 1.0 <= share {
                (lit(mood), None)
            } else {
                (settled, Some((lit(mood), eased)))
            };
        }
        now
    }
}

/// The picture of a film at a time [s]: while lamps go over into others, the light of both is mixed; `draw` draws what
/// is around her.
pub(crate) fn lit(
    (cues, time): (&Cues, f32),
    size: Size,
    mut draw: impl FnMut(Scenery) -> Result<Image, RenderError>,
) -> Result<Image, RenderError> {
    let (now, next) = cues.at(time);
    let Some((next, share)) = next else {
        return draw(now);
    };
    let mut exposure = Exposure::new(size);
    exposure.add(&draw(now)?, 1.0 - share);
    exposure.add(&draw(next)?, share);
    Ok(exposure.develop())
}

#[cfg(test)]
mod tests {
    use super::*;

    const CHANGES: [(f32, StageMood); 2] = [(4.0, StageMood::Sea), (9.0, StageMood::Solemn)];

    #[test]
    fn lamps_go_from_mood_to_mood_without_a_jump() {
        let cues = Cues {
            scenery: Scenery::default(),
            changes: CHANGES.to_vec(),
        };
        let share = |time: f32, mood: StageMood| {
            let (now, next) = cues.at(time);
            let goes = next.map_or(0.0, |(_, share)| share);
            let of = |scenery: Scenery, share: f32| if scenery.mood == mood { share } else { 0.0 };
            of(now, 1.0 - goes) + next.map_or(0.0, |(scenery, share)| of(scenery, share))
        };
        for mood in StageMood::ALL {
            let shares = (0..800_u16).map(|step| share(f32::from(step) / 60.0, mood));
            let shares: Vec<f32> = shares.collect();
            assert!(
                shares
                    .windows(2)
                    .all(|pair| (pair[1] - pair[0]).abs() < 0.02)
            );
        }
        for (time, mood) in [
            (3.0, StageMood::default()),
            (7.0, StageMood::Sea),
            (11.0, StageMood::Solemn),
        ] {
            assert!((share(time, mood) - 1.0).abs() < 1.0e-6, "{time} s");
        }
    }
}
