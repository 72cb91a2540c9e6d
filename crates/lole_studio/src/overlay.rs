//! Lines and dots over the picture: capsules, springs, bones, cloth below the skin.

use std::f32::consts::{PI, TAU};

use glam::Vec3;
use lole_geom::{Capsule, trig};
use lole_render::{Overlay, OverlayLine};

use crate::Snapshot;
use crate::snapshot::Net;
use crate::studio::Shows;

/// Corners of a circle.
const CORNERS: u16 = 24;
const CAPSULE: [u8; 4] = [0, 112, 122, 235];
const BONE: [u8; 4] = [205, 92, 0, 255];
const JOINT: [u8; 4] = [120, 48, 0, 255];
const SPRING: [u8; 4] = [20, 40, 90, 220];
const SUNKEN: [u8; 4] = [225, 0, 60, 255];
/// Springs are drawn no nearer to each other than this [point].
const SPRING_GAP: f32 = 3.5;

/// All lines of one picture.
#[derive(Debug, Default)]
pub(crate) struct Strokes {
    pub(crate) on_surfaces: Vec<OverlayLine>,
    pub(crate) through: Vec<OverlayLine>,
}

impl Strokes {
    /// The lines of a moment; `meters_per_pixel` where the dancer stands, `scale` pixels a point.
    /// The lines as the picture takes them.
    pub(crate) fn overlay(&self) -> Overlay<'_> {
        Overlay {
            on_surfaces: &self.on_surfaces,
            through: &self.through,
        }
    }

    pub(crate) fn of(snapshot: &Snapshot, shows: Shows, meters_per_pixel: f32, scale: f32) -> Self {
        let mut strokes = Self::default();
        let line = |color, width: f32| {
            move |[from, to]: [Vec3; 2]| OverlayLine {
                from,
                to,
                color,
                width: width * scale,
            }
        };
        if shows.springs {
            for net in &snapshot.wardrobe.nets {
                let stride = spring_stride(net.spacing, meters_per_pixel * scale);
                let springs = shown(net, &snapshot.particles, stride);
                strokes.on_surfaces.extend(springs.map(line(SPRING, 1.0)));
            }
        }
        if shows.capsules {
            for capsule in &snapshot.capsules {
                let outline = capsule_outline(capsule);
                strokes.through.extend(outline.map(line(CAPSULE, 1.6)));
            }
        }
        if shows.skeleton {
            let bones = &snapshot.bones;
            strokes
                .through
                .extend(bones.iter().copied().map(line(BONE, 3.0)));
            let joints = bones.iter().map(|&[_, joint]| [joint; 2]);
            strokes.through.extend(joints.map(line(JOINT, 6.0)));
        }
        if shows.sunken {
            let dots = snapshot.sunken.iter().map(|&place| [place; 2]);
            strokes.through.extend(dots.map(line(SUNKEN, 5.0)));
        }
        strokes
    }
}

/// Every how many rows and columns springs are drawn whose threads lie `spacing` apart [m], so that they can be
/// told apart.
fn spring_stride(spacing: f32, meters_per_point: f32) -> u32 {
    let mut stride = 1;
    if spacing <= 0.0 {
        return stride;
    }
    let finest = spacing.max(1.0e-4);
    // Gathered cloth lies about a quarter as wide as it is.
    while stride < 16 && 0.5 * finest * stride as f32 / meters_per_point < SPRING_GAP {
        stride *= 2;
    }
    stride
}

/// The lines of a net on every so manyth row and column.
fn shown(net: &Net, particles: &[Vec3], stride: u32) -> impl Iterator<Item = [Vec3; 2]> {
    let at = |particle: u32| particles.get(particle as usize).copied();
    let lines = (net.lines.iter()).filter(move |[.., thread]| thread % stride == 0);
    lines.filter_map(move |&[from, to, _]| Some([at(from)?, at(to)?]))
}

/// Rings around both ends, lines along the side, and a cap on each end.
fn capsule_outline(capsule: &Capsule) -> impl Iterator<Item = [Vec3; 2]> {
    let [a, b] = capsule.ends;
    let [radius_a, radius_b] = capsule.radii;
    let axis = (b - a).try_normalize().unwrap_or(Vec3::Y);
    let (right, up) = axis.any_orthonormal_pair();
    let around = move |angle: f32| {
        let (sin, cos) = trig::sin_cos(angle);
        right * cos + up * sin
    };
    let corner = |index: u16| TAU * f32::from(index) / f32::from(CORNERS);
    let ring = move |center: Vec3, radius: f32| {
        (0..CORNERS).map(move |index| {
            [index, index + 1].map(|index| center + around(corner(index)) * radius)
        })
    };
    let sides = (0..4_u16).map(move |quarter| {
        let out = around(TAU * f32::from(quarter) / 4.0);
        [a + out * radius_a, b + out * radius_b]
    });
    let cap = move |center: Vec3, radius: f32, end: Vec3, side: Vec3| {
        (0..CORNERS / 2).map(move |index| {
            [index, index + 1].map(|index| {
                let (sin, cos) = trig::sin_cos(PI * f32::from(index) / f32::from(CORNERS / 2));
                center + (side * cos + end * sin) * radius
            })
        })
    };
    ring(a, radius_a)
        .chain(ring(b, radius_b))
        .chain(sides)
        .chain(cap(a, radius_a, -axis, right))
        .chain(cap(a, radius_a, -axis, up))
        .chain(cap(b, radius_b, axis, right))
        .chain(cap(b, radius_b, axis, up))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_capsules_outline_lies_on_its_surface() {
        let capsule = Capsule {
            ends: [Vec3::new(0.1, 0.9, 0.0), Vec3::new(0.2, 0.4, 0.1)],
            radii: [0.12, 0.12],
        };
        for [from, to] in capsule_outline(&capsule) {
            for point in [from, to] {
                assert!(capsule.signed_distance(point).abs() < 1e-4, "{point}");
            }
        }
    }

    #[test]
    fn far_springs_are_thinned_and_near_ones_are_all_there() {
        assert_eq!(spring_stride(0.01, 0.0001), 1);
        assert!(4 <= spring_stride(0.01, 0.004));
        let net = Net {
            spacing: 0.01,
            lines: vec![[0, 1, 0], [1, 2, 1], [2, 3, 2]],
        };
        let particles = [Vec3::ZERO; 4];
        assert_eq!(shown(&net, &particles, 1).count(), 3);
        assert_eq!(shown(&net, &particles, 2).count(), 2);
        assert_eq!(shown(&net, &[], 1).count(), 0);
    }
}
