//! Flesh gives way where cloth lies tight on it.
//!
//! The body that cloth meets is rigid under its bones, and cloth meets it by particles a centimeter or two
//! apart: over an elbow a taut triangle cuts the corner of the skin. Living skin is pressed in there. The
//! drawn skin is, too; what cloth meets and what [`crate::skin_check`] measures is not.

use glam::Vec3;
use lole_geom::triangle_grid::TriangleGrid;

use crate::production::Production;
use crate::skin_check::CheckedSurface;
use crate::{Vertices, WornSurface};

/// Pressed skin lies this far under the cloth [m].
const UNDER: f32 = 2.0e-3;
/// Skin is pressed in by this at most [m].
const DEEPEST: f32 = 0.015;
/// Edge of a cell [m].
const CELL: f32 = 0.02;

/// Presses the drawn body in where garments sewn from shaped pieces lie in it: `worn` are the vertices of all
/// that is worn as they are drawn, surface by surface as [`Production::surfaces`] has them, and `body` the
/// posed vertices and normals of the drawn body.
pub fn give_way(
    production: &Production,
    worn: &[Vertices],
    (positions, normals): (&mut [Vec3], &[Vec3]),
) {
    for (surface, [vertices, _]) in production.surfaces().zip(worn) {
        let WornSurface::Sewn(garment) = surface else {
            continue;
        };
        let cloth = CheckedSurface {
            positions: vertices,
            normals: &[],
            triangles: &garment.dressed.open_triangles,
        };
        press(&production.drawn_triangles, cloth, (positions, normals));
    }
}

fn press(
    body_triangles: &[[u32; 3]],
    cloth: CheckedSurface<'_>,
    (positions, normals): (&mut [Vec3], &[Vec3]),
) {
    let reach = Vec3::splat(UNDER + DEEPEST);
    let finite = cloth.positions.iter().filter(|place| place.is_finite());
    let (low, high) = finite.fold((Vec3::MAX, Vec3::MIN), |(low, high), &place| {
        (low.min(place), high.max(place))
    });
    let (low, high) = (low - reach, high + reach);
    let cloth_grid = TriangleGrid::new(cloth.positions, cloth.triangles, CELL);
    // How far under its skin a vertex meets the cloth, before any other has moved.
    let met: Vec<(usize, f32)> = (positions.iter().zip(normals).enumerate())
        .filter(|(_, (place, _))| place.cmpge(low).all() && place.cmple(high).all())
        .filter_map(|(vertex, (&place, &outward))| {
            let (start, end) = (place + outward * UNDER, place - outward * DEEPEST);
            let met = cloth_grid.first_crossing(start, end)?;
            Some((vertex, met * (UNDER + DEEPEST) - UNDER))
        })
        .collect();
    if met.is_empty() {
        return;
    }
    let before = positions.to_vec();
    let body_grid = TriangleGrid::new(&before, body_triangles, CELL);
    for (vertex, depth) in met {
        let (place, outward) = (before[vertex], normals[vertex]);
        // Cloth beyond the middle of a limb presses on its other side.
        let (start, end) = (place - outward * 0.5e-3, place - outward * (2.0 * DEEPEST));
        let is_beyond = |out: f32| out * 2.0 * DEEPEST < 2.0 * depth;
        if !body_grid.first_crossing(start, end).is_some_and(is_beyond) {
            positions[vertex] = place - outward * (depth + UNDER);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square of `2 × half` [m] at a height, its upper side outward.
    fn square(half: f32, height: f32) -> Vec<Vec3> {
        [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
            .map(|[x, z]: [f32; 2]| Vec3::new(half * x, height, half * z))
            .to_vec()
    }

    /// A slab `thickness` [m] thick below the level, and cloth at a height; returns how far the
    /// middles of its upper and its lower side have moved down.
    fn pressed(thickness: f32, cloth: f32) -> [f32; 2] {
        let mut positions = [square(0.1, 0.0), square(0.1, -thickness)].concat();
        positions.extend([Vec3::ZERO, Vec3::NEG_Y * thickness]);
        let mut normals = [[Vec3::Y; 4], [Vec3::NEG_Y; 4]].concat();
        normals.extend([Vec3::Y, Vec3::NEG_Y]);
        let fan = |first: u32, middle: u32| {
            (0..4).map(move |at| [first + at, first + (at + 1) % 4, middle])
        };
        let body: Vec<[u32; 3]> = fan(0, 8).chain(fan(4, 9)).collect();
        let vertices = square(0.05, cloth);
        let cloth = CheckedSurface {
            positions: &vertices,
            normals: &[],
            triangles: &[[0, 1, 2], [0, 2, 3]],
        };
        press(&body, cloth, (&mut positions, &normals));
        [-positions[8].y, -thickness - positions[9].y]
    }

    #[test]
    fn skin_lies_under_the_cloth_that_presses_it() {
        for cloth in [0.001, -0.001, -0.010] {
            let [upper, lower] = pressed(0.1, cloth);
            assert!((upper - (UNDER - cloth)).abs() < 1.0e-6, "{cloth}: {upper}");
            assert_eq!(lower, 0.0, "{cloth}");
        }
    }

    #[test]
    fn cloth_that_is_clear_or_too_deep_presses_nothing() {
        for cloth in [0.004, -0.016] {
            assert_eq!(pressed(0.1, cloth), [0.0; 2], "{cloth}");
        }
    }

    #[test]
    fn cloth_beyond_the_middle_presses_on_the_other_side() {
        let [upper, lower] = pressed(0.016, -0.012);
        assert_eq!(upper, 0.0);
        assert!((lower + 0.006).abs() < 1.0e-6, "{lower}");
    }
}
