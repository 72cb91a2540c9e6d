//! What is danced: a step of hula, or a recording.

mod breath;

use std::sync::Arc;

use glam::Vec2;
use lole_avatar::{AvatarError, ReadDance, read_clip};
use lole_body::{Dancer, Pose};
use lole_costume::document::{Design, MotionDrift, MotionRepeat};
use lole_hula::Dance;
use lole_motion::{Clip, ClipSettings, Drift, Repeat};

use crate::StageError;

/// A dance on one skeleton, ready to be asked for poses.
#[derive(Debug, Clone)]
pub enum Danced {
    /// A step of hula, over and over.
    Step(Box<Dance>),
    /// Somebody's recording.
    Recording(Arc<Clip>),
}

impl Danced {
    /// The dance of a design on its dancer.
    ///
    /// # Errors
    /// A step that cannot be danced; a recording that was not read, is broken, or is no person's.
    pub fn new(design: &Design, dancer: &Dancer) -> Result<Self, StageError> {
        let motion = &design.motion;
        let Some(file) = &motion.file else {
            let dance = Dance::new(&dancer.skeleton, &design.motion_settings())?;
            return Ok(Self::Step(Box::new(dance)));
        };
        let named = |error: AvatarError| StageError::Recording {
            file: file.name.clone(),
            error: Box::new(error),
        };
        let bytes = file
            .bytes
            .as_ref()
            .ok_or_else(|| StageError::RecordingNotRead {
                file: file.name.clone(),
            })?;
        let ReadDance { recording, map } = read_clip(bytes, &motion.clip).map_err(named)?;
        let settings = ClipSettings {
            repeat: match motion.repeat {
                MotionRepeat::Once => Repeat::Once,
                MotionRepeat::Loop => Repeat::Loop,
            },
            drift: match motion.drift {
                MotionDrift::Keep => Drift::Keep,
                MotionDrift::Remove => Drift::Remove,
            },
        };
        let clip = Clip::retarget(&recording, &map, &dancer.skeleton, settings);
        let mut clip = clip.map_err(|error| named(AvatarError::Recording(error)))?;
        if design.skirt.is_worn {
            clip = clip.clear_of_skirt(dancer);
        }
        Ok(Self::Recording(Arc::new(clip)))
    }

    /// The same steps of a design's choreography on its dancer, who in every part gets so much farther [m], to her
    /// left and ahead as she faces the front.
    ///
    /// # Errors
    /// A way that the feet do not carry her in a part.
    pub fn walking(design: &Design, dancer: &Dancer, ways: &[Vec2]) -> Result<Self, StageError> {
        let mut settings = design.motion_settings();
        let stature = Dance::new(&dancer.skeleton, &settings)?.stature();
        for (part, way) in settings.parts.iter_mut().zip(ways) {
            part.travel = (*way / stature).to_array();
        }
        let dance = Dance::new(&dancer.skeleton, &settings)?;
        Ok(Self::Step(Box::new(dance)))
    }

    /// Pose at `time` [s]; the first one up to 0. Who dances a step breathes.
    #[must_use]
    pub fn pose_at(&self, time: f32) -> Pose {
        match self {
            Self::Step(dance) => {
                let mut pose = dance.pose_at(time);
                breath::breathe(&mut pose, time, [dance.lead_in(), dance.period()]);
                pose
            }
            Self::Recording(clip) => clip.pose_at(time),
        }
    }

    /// Duration of the whole dance [s]; `None` for what is repeated for ever.
    #[must_use]
    pub fn whole(&self, repeat: MotionRepeat) -> Option<f64> {
        match self {
            Self::Step(dance) => dance.duration(),
            Self::Recording(clip) => {
                (repeat == MotionRepeat::Once).then(|| f64::from(clip.duration()))
            }
        }
    }

    /// Counts of the music at `time` [s]; a recording has none.
    #[must_use]
    pub fn beat_at(&self, time: f64) -> Option<f64> {
        match self {
            Self::Step(dance) => Some(dance.beat_at(time)),
            Self::Recording(_) => None,
        }
    }

    /// Time until the dance is at its own speed [s].
    #[must_use]
    pub fn lead_in(&self) -> f32 {
        match self {
            Self::Step(dance) => dance.lead_in(),
            Self::Recording(clip) => clip.lead_in(),
        }
    }

    /// Duration of one round of the step, or of the recording [s].
    #[must_use]
    pub fn period(&self) -> f32 {
        match self {
            Self::Step(dance) => dance.period(),
            Self::Recording(clip) => clip.duration(),
        }
    }
}

#[cfg(test)]
mod tests {
    use lole_body::Measurements;
    use lole_costume::document::{LinkedFile, PartDesign};

    use super::*;

    #[test]
    fn a_recording_that_is_missing_or_broken_is_refused_by_name() {
        let dancer = Dancer::new(&Measurements::woman()).unwrap();
        let mut design = Design::default();
        let said = |design: &Design| Danced::new(design, &dancer).unwrap_err().to_string();
        design.motion.file = Some(LinkedFile::named("a.bvh"));
        assert_eq!(said(&design), "the recording a.bvh was not read");
        let bytes: &[u8] = b"HIERARCHY\nROOT a\n{\nOFFSET 0 0";
        design.motion.file = Some(LinkedFile {
            bytes: Some(bytes.into()),
            ..LinkedFile::named("a.bvh")
        });
        assert_eq!(
            said(&design),
            "a.bvh: line 4: OFFSET takes three numbers, and here are 2"
        );
    }

    #[test]
    fn whoever_walks_is_where_she_should_be_at_the_end_of_each_part() {
        let dancer = Dancer::new(&Measurements::woman()).unwrap();
        let mut design = Design::default();
        design.motion.parts = [16, 8, 16]
            .map(|beat_count| PartDesign {
                beat_count,
                ..PartDesign::default()
            })
            .to_vec();
        let stays = Danced::new(&design, &dancer).unwrap();
        let ways = [Vec2::new(0.5, -0.4), Vec2::ZERO, Vec2::new(-0.7, 0.2)];
        let walks = Danced::walking(&design, &dancer, &ways).unwrap();
        let beat = 60.0 / 80.0;
        let mut been = Vec2::ZERO;
        for (way, counts) in ways.into_iter().zip([18.5_f32, 26.5, 43.0]) {
            been += way;
            let at = |danced: &Danced| danced.pose_at(counts * beat).hips_translation;
            let away = at(&walks) - at(&stays);
            assert!(
                Vec2::new(away.x, away.z).distance(been) < 0.02,
                "{away} {been}"
            );
            assert!(away.y.abs() < 0.01, "{away}");
        }
        assert!(Danced::walking(&design, &dancer, &[Vec2::new(9.0, 0.0)]).is_err());
    }
}
