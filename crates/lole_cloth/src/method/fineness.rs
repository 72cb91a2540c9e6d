//! Into how many substeps a step is cut: as many as usual, and more for a while where cloth is strained.
//!
//! A pass over the springs leaves a strain that grows with the pull and with the square of the substep: a
//! skirt that is whirled pulls at itself with several times its weight. Substeps are the cheapest way to
//! keep it whole (Macklin et al. 2019, "Small Steps in Physics Simulation"), and a calm dance shall not
//! pay for them.

use glam::Vec3;

use crate::{ClothModel, SolverConfig, diagnose};

/// Strain of an edge from which it counts as strained, and as not quite at rest.
const STRAINED: f32 = 0.06;
const UNEASY: f32 = 0.04;

/// One edge in so many may be strained.
const FEW: usize = 100;

/// Into how many substeps the next step is cut.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Fineness {
    /// None before the first step.
    count: u32,
    /// Row-major [m].
    pub(crate) positions: Vec<Vec3>,
}

impl Fineness {
    /// Substeps of the next step.
    pub(crate) fn substep_count(&self, config: &SolverConfig) -> u32 {
        let usual = config.substep_count.get();
        self.count
            .clamp(usual, usual.max(config.strained_substep_count.get()))
    }

    /// Looks at how strained the cloth came out of a step; `gather` puts its positions into a list.
    pub(crate) fn learn(
        &mut self,
        (model, config): (&ClothModel, &SolverConfig),
        gather: impl FnOnce(&mut Vec<Vec3>),
    ) {
        if config.strained_substep_count <= config.substep_count {
            return;
        }
        gather(&mut self.positions);
        let now = self.substep_count(config);
        let usual = config.substep_count.get();
        let [strained, uneasy] = many_strained(model, &self.positions);
        self.count = if strained {
            now.saturating_add(usual)
        } else if uneasy {
            now
        } else {
            now.saturating_sub(usual.div_ceil(4)).max(usual)
        };
    }
}

/// Whether more than a few edges are strained, and whether more than a few are uneasy.
fn many_strained(model: &ClothModel, positions: &[Vec3]) -> [bool; 2] {
    let spec = model.spec();
    let (mut all, mut beyond) = (0_usize, [0_usize; 2]);
    diagnose::each_structural_edge(spec, |[first, second], rest_length| {
        if spec.pinned[first] && spec.pinned[second] {
            return;
        }
        all += 1;
        let squared = positions[first].distance_squared(positions[second]);
        for (beyond, limit) in beyond.iter_mut().zip([STRAINED, UNEASY]) {
            let [short, long] = [1.0 - limit, 1.0 + limit].map(|share| share * rest_length);
            *beyond += usize::from(!(short * short..=long * long).contains(&squared));
        }
    });
    beyond.map(|beyond| all < FEW * beyond)
}
