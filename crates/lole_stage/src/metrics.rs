//! What one frame is judged by, and the worst of a whole run.

use lole_cloth::diagnose::StrainSummary;

use crate::skin_check::SkinCheck;

/// One frame in numbers.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FrameMetrics {
    /// Time of the dance [s].
    pub time: f32,
    /// Absolute strain of the structural springs.
    pub strain: StrainSummary,
    /// Deepest free particle in a capsule that the cloth meets [m]; 0 where it meets the skin.
    pub capsule_penetration: f32,
    /// Cloth against the drawn body.
    pub skin: SkinCheck,
    /// Mean height of the skirt's hem above the floor [m].
    pub hem_height: f32,
}

impl FrameMetrics {
    /// Adds a garment that has this `share` of the particles: means are weighted, of the others the
    /// worst counts.
    pub(crate) fn add_strain(&mut self, strain: StrainSummary, share: f32) {
        self.strain = StrainSummary {
            mean: self.strain.mean + share * strain.mean,
            p99: self.strain.p99.max(strain.p99),
            max: self.strain.max.max(strain.max),
        };
    }
}

/// The worst of many frames.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RunMetrics {
    /// Largest of each strain figure over the run.
    pub strain: StrainSummary,
    /// Strain of the last frame.
    pub strain_end: StrainSummary,
    /// Deepest free particle in a capsule that the cloth meets [m]; 0 where it meets the skin.
    pub capsule_penetration: f32,
    /// Largest of each skin figure over the run.
    pub skin: SkinCheck,
    /// Lowest, mean and highest of the frames' mean hem heights [m].
    pub hem_height: [f32; 3],
}

impl RunMetrics {
    /// Gathers the frames of a run; zeros where there are none.
    #[must_use]
    pub fn of(frames: &[FrameMetrics]) -> Self {
        let Some(last) = frames.last() else {
            return Self::default();
        };
        let worst = |value: fn(&FrameMetrics) -> f32| frames.iter().map(value).fold(0.0, f32::max);
        let most = |value: fn(&FrameMetrics) -> u32| frames.iter().map(value).max().unwrap_or(0);
        let heights = || frames.iter().map(|frame| frame.hem_height);
        #[expect(clippy::cast_precision_loss, reason = "a run has thousands of frames")]
        let mean_height = heights().sum::<f32>() / frames.len() as f32;
        Self {
            strain: StrainSummary {
                mean: worst(|frame| frame.strain.mean),
                p99: worst(|frame| frame.strain.p99),
                max: worst(|frame| frame.strain.max),
            },
            strain_end: last.strain,
            capsule_penetration: worst(|frame| frame.capsule_penetration),
            skin: SkinCheck {
                worst_depth: worst(|frame| frame.skin.worst_depth),
                sunken_cloth_vertices: most(|frame| frame.skin.sunken_cloth_vertices),
                showing_body_vertices: most(|frame| frame.skin.showing_body_vertices),
            },
            hem_height: [
                heights().fold(f32::MAX, f32::min),
                mean_height,
                heights().fold(0.0, f32::max),
            ],
        }
    }
}
