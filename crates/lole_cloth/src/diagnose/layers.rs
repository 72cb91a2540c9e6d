//! Whether layers lie in their order.

use glam::Vec3;

use crate::collision::layer::{Layer, Orientation};

/// Particles at `outer` [m] that lie on the inward side of the `inner` layer: 0 where the order is
/// kept. A particle counts where the nearest point of the inner layer is at most `reach` [m] away
/// and not on its border; what lies on the layer to a tenth of a millimeter is on neither side.
#[must_use]
pub fn layer_inversions(inner: Layer<'_>, outer: &[Vec3], reach: f32) -> usize {
    /// A fabric is a few tenths of a millimeter thick [m].
    const ON_LAYER: f32 = 1.0e-4;
    let orientation = Orientation::new(inner);
    let is_inside = |point: &&Vec3| {
        let sight = orientation.sight(**point, reach);
        sight.is_some_and(|sight| sight.height < -ON_LAYER)
    };
    outer.iter().filter(is_inside).count()
}
