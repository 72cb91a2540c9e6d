//! Meshes made whole: vertices that lie in one place become one.

use glam::{IVec3, Vec3};

use crate::index;

/// A mesh whose vertices that lay together are one.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct WeldedMesh {
    /// Where the vertices are [m]: each where the first of those lay that became it.
    pub positions: Vec<Vec3>,
    /// Those that keep three corners.
    pub triangles: Vec<[u32; 3]>,
    /// By triangle that is kept, which it was.
    pub sources: Vec<usize>,
    /// By vertex that there was, which it became; nothing where no triangle that is kept has it.
    pub vertices: Vec<Option<u32>>,
}

/// Stands for a vertex that no triangle has.
const NONE: u32 = u32::MAX;

/// Makes vertices one that lie within `distance` [m] of one that comes before them, as the seams of a
/// garment do that was exported piece by piece; `joined` names pairs that become one wherever they lie.
///
/// Triangles of which two corners become one are left out, those that name a vertex that does not exist,
/// those whose corners are not finite, and all but the first of triangles with the same corners; vertices of
/// no triangle are too. Vertices keep their order.
#[must_use]
pub fn weld(
    (positions, triangles): (&[Vec3], &[[u32; 3]]),
    distance: f32,
    joined: &[[u32; 2]],
) -> WeldedMesh {
    let mut roots = firsts_near(positions, distance);
    for &pair in joined {
        let is_known = pair.iter().all(|&it| (it as usize) < positions.len());
        if is_known {
            let [one, other] = pair.map(|it| root(&roots, it));
            roots[one.max(other) as usize] = one.min(other);
        }
    }
    let is_whole = |triangle: &[u32; 3]| {
        triangle.iter().all(|&it| {
            let place = positions.get(it as usize);
            place.is_some_and(|place| place.is_finite())
        })
    };
    let mut kept: Vec<([u32; 3], usize)> = Vec::new();
    for (index, triangle) in triangles.iter().enumerate() {
        if is_whole(triangle) {
            let [a, b, c] = triangle.map(|it| root(&roots, it));
            if a != b && b != c && c != a {
                kept.push(([a, b, c], index));
            }
        }
    }
    let sorted = |&([a, b, c], index): &([u32; 3], usize)| {
        let mut corners = [a, b, c];
        corners.sort_unstable();
        (corners, index)
    };
    kept.sort_by_key(sorted);
    kept.dedup_by_key(|it| sorted(it).0);
    kept.sort_by_key(|&(_, index)| index);
    numbered(positions, &roots, kept)
}

/// Edges that are shorter than `length` [m], as [`weld`] joins them: meshes that were cut by planes or cells
/// have triangles of a hundredth of the others' size, which make cloth stiff and slow and show nothing.
#[must_use]
pub fn short_edges((positions, triangles): (&[Vec3], &[[u32; 3]]), length: f32) -> Vec<[u32; 2]> {
    let sides = triangles
        .iter()
        .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let is_short = |side: &[u32; 2]| {
        let ends = side.map(|it| positions.get(it as usize).copied().unwrap_or(Vec3::NAN));
        ends[0].distance(ends[1]) < length
    };
    let mut short: Vec<[u32; 2]> = sides
        .map(|[a, b]| [a.min(b), a.max(b)])
        .filter(is_short)
        .collect();
    short.sort_unstable();
    short.dedup();
    short
}

/// Numbers the vertices that are left.
fn numbered(positions: &[Vec3], roots: &[u32], kept: Vec<([u32; 3], usize)>) -> WeldedMesh {
    let mut numbers = vec![NONE; positions.len()];
    for vertex in kept.iter().flat_map(|(corners, _)| corners) {
        numbers[*vertex as usize] = 0;
    }
    let mut welded = WeldedMesh::default();
    for (number, &position) in numbers.iter_mut().zip(positions) {
        if *number != NONE {
            *number = index(welded.positions.len());
            welded.positions.push(position);
        }
    }
    let number = |vertex: u32| numbers[vertex as usize];
    let all = 0..index(positions.len());
    welded.vertices = all
        .map(|vertex| Some(number(root(roots, vertex))).filter(|&it| it != NONE))
        .collect();
    for (corners, source) in kept {
        welded.triangles.push(corners.map(number));
        welded.sources.push(source);
    }
    welded
}

/// The vertex that another became.
fn root(roots: &[u32], mut vertex: u32) -> u32 {
    while roots[vertex as usize] != vertex {
        vertex = roots[vertex as usize];
    }
    vertex
}

/// By vertex, the first of those before it that are their own and within `distance` [m], or itself.
fn firsts_near(positions: &[Vec3], distance: f32) -> Vec<u32> {
    let mut roots: Vec<u32> = (0..index(positions.len())).collect();
    if !(0.0..f32::INFINITY).contains(&distance) {
        return roots;
    }
    // Cells as wide as the distance, or as the places are apart in `f32`.
    let finite = positions.iter().filter(|it| it.is_finite());
    let largest = finite.fold(0.0_f32, |most, it| most.max(it.abs().max_element()));
    let size = distance.max(largest * 1.0e-6).max(f32::MIN_POSITIVE);
    let cell_of = |position: Vec3| (position / size).floor().as_ivec3();
    let mut cells: Vec<([i32; 3], u32)> = (0_u32..)
        .zip(positions)
        .filter(|(_, position)| position.is_finite())
        .map(|(vertex, &position)| (cell_of(position).to_array(), vertex))
        .collect();
    cells.sort_unstable();
    for vertex in 0..positions.len() {
        if !positions[vertex].is_finite() {
            continue;
        }
        let cell = cell_of(positions[vertex]);
        let around =
            (-1..=1).flat_map(|x| (-1..=1).flat_map(move |y| (-1..=1).map(move |z| [x, y, z])));
        let near = around.flat_map(|step| {
            let cell = cell.saturating_add(IVec3::from_array(step)).to_array();
            let first = cells.partition_point(|it| it.0 < cell);
            cells[first..].iter().take_while(move |it| it.0 == cell)
        });
        let is_near = |other: u32| {
            let other = other as usize;
            other < vertex
                && roots[other] as usize == other
                && positions[other].distance(positions[vertex]) <= distance
        };
        if let Some(first) = near.map(|it| it.1).filter(|&it| is_near(it)).min() {
            roots[vertex] = first;
        }
    }
    roots
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two squares side by side, each with corners of its own, a millimeter apart at most.
    fn squares() -> (Vec<Vec3>, Vec<[u32; 3]>) {
        let square = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)];
        let places = [0.0, 1.0]
            .into_iter()
            .flat_map(|across| square.map(|(x, y)| Vec3::new(x + across, y, 0.001 * across)));
        let sides = [[0, 1, 3], [0, 3, 2]];
        let triangles = [0, 4]
            .into_iter()
            .flat_map(|first| sides.map(|it| it.map(|k| first + k)));
        (places.collect(), triangles.collect())
    }

    #[test]
    fn what_lies_in_one_place_becomes_one_and_the_rest_stays() {
        let (positions, triangles) = squares();
        let mesh = (&positions[..], &triangles[..]);
        let welded = weld(mesh, 0.002, &[]);
        assert_eq!((welded.positions.len(), welded.triangles.len()), (6, 4));
        assert_eq!(welded.vertices[4], welded.vertices[1]);
        assert_eq!(welded.vertices[6], welded.vertices[3]);
        assert_eq!(welded.positions[1], positions[1]);
        assert_eq!(weld(mesh, 0.0005, &[]).positions.len(), 8);
        let sewn = weld(mesh, 0.0, &[[1, 4], [6, 3], [99, 0]]);
        assert_eq!(
            (&sewn.triangles, &sewn.vertices),
            (&welded.triangles, &welded.vertices)
        );
    }

    #[test]
    fn short_edges_join_and_their_triangles_go() {
        let (mut positions, triangles) = squares();
        positions[3] = positions[1] + Vec3::Y * 0.01;
        let mesh = (&positions[..], &triangles[..]);
        let short = short_edges(mesh, 0.02);
        assert_eq!(short, [[1, 3]]);
        let welded = weld(mesh, 0.0, &short);
        assert_eq!((welded.positions.len(), welded.sources), (7, vec![1, 2, 3]));
    }

    #[test]
    fn what_is_no_triangle_or_twice_there_is_left_out() {
        let (mut positions, mut triangles) = squares();
        positions.extend([Vec3::NAN, Vec3::X * 9.0]);
        triangles.extend([[0, 1, 8], [1, 4, 5], [3, 1, 0], [0, 1, 77]]);
        let welded = weld((&positions, &triangles), 0.002, &[]);
        assert_eq!(welded.sources, [0, 1, 2, 3]);
        assert_eq!((welded.vertices[8], welded.vertices[9]), (None, None));
        assert!(welded.positions.iter().all(|it| it.is_finite()));
        let nothing = weld((&[], &[]), 0.1, &[]);
        assert_eq!(nothing, WeldedMesh::default());
    }
}
