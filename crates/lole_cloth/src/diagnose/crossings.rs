//! Where the cloth has gone through itself, exactly: by predicates that no rounding touches and a search that
//! is not the engine's.

use glam::Vec3;
use lole_geom::triangle_grid::TriangleGrid;

use crate::Grid;
use crate::collision::exact::goes_through;
use crate::lanes::narrow;

/// Cells of the search over the longer side of a cell of the cloth.
const SEARCH_CELL: f32 = 1.5;

/// Pairs of an edge and a triangle of the cloth that cross, and do not only touch, and share no particle: 0
/// where no fold has gone through another. Every cell is cut along its diagonal from upper left to lower right.
///
/// Where `positions` [m] are not all finite there is no answer.
#[must_use]
pub fn self_crossings(grid: &Grid, positions: &[Vec3]) -> Option<usize> {
    let triangles = grid.triangles();
    let size = grid.spacing[0].max(grid.spacing[1]);
    let mut edges = Vec::with_capacity(3 * positions.len());
    for_each_edge(grid, |ends| edges.push(ends));
    crossing_count((&triangles, edges.into_iter()), positions, size)
}

/// Pairs of an edge and a triangle that cross at `positions` [m] and share no particle; cells of the
/// cloth are about `size` [m] large. `None` where not all positions are finite.
#[must_use]
pub fn crossing_count(
    (triangles, edges): (&[[u32; 3]], impl Iterator<Item = [u32; 2]>),
    positions: &[Vec3],
    size: f32,
) -> Option<usize> {
    crossings((triangles, edges), positions, size).map(|pairs| pairs.len())
}

/// Pairs of an edge and a triangle that cross at `positions` [m] and share no particle, one by one: the ends of
/// the edge, and the number of the triangle. Cells of the cloth are about `size` [m] large; `None` where not all
/// positions are finite.
#[must_use]
pub fn crossings(
    (triangles, edges): (&[[u32; 3]], impl Iterator<Item = [u32; 2]>),
    positions: &[Vec3],
    size: f32,
) -> Option<Vec<([u32; 2], u32)>> {
    if !positions.iter().all(|position| position.is_finite()) {
        return None;
    }
    let search = TriangleGrid::new(positions, triangles, SEARCH_CELL * size);
    let mut pairs = Vec::new();
    let mut near = Vec::new();
    for ends in edges {
        let [start, end] = ends.map(|end| positions[end as usize]);
        search.near_segment(start, end, &mut near);
        let is_crossed = |triangle: &&u32| {
            let corners = triangles[**triangle as usize];
            !ends.iter().any(|end| corners.contains(end))
                && goes_through(
                    [start, end],
                    corners.map(|corner| positions[corner as usize]),
                )
        };
        pairs.extend(
            near.iter()
                .filter(is_crossed)
                .map(|&triangle| (ends, triangle)),
        );
    }
    Some(pairs)
}

fn for_each_edge(grid: &Grid, mut edge: impl FnMut([u32; 2])) {
    for row in 0..grid.row_count {
        for column in 0..grid.column_count {
            let particle = narrow(grid.index(row, column));
            if let Some(right) = grid.column_right(column, 1) {
                edge([particle, narrow(grid.index(row, right))]);
            }
            if row + 1 < grid.row_count {
                edge([particle, narrow(grid.index(row + 1, column))]);
            }
        }
    }
    for_each_cell(grid, |[a, _, _, d]| edge([a, d]));
}

/// Calls with the corners of every cell: upper left and right, lower left and right.
fn for_each_cell(grid: &Grid, mut cell: impl FnMut([u32; 4])) {
    for row in 0..grid.row_count.saturating_sub(1) {
        for column in 0..grid.column_count {
            if let Some(right) = grid.column_right(column, 1) {
                let corner = |row: u32, column: u32| narrow(grid.index(row, column));
                cell([
                    corner(row, column),
                    corner(row, right),
                    corner(row + 1, column),
                    corner(row + 1, right),
                ]);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Topology;

    /// A strip of 9 columns and 3 rows, folded back on itself by a turn that lies at `gap` above.
    fn folded(gap: f32) -> (Grid, Vec<Vec3>) {
        let grid = Grid {
            column_count: 9,
            row_count: 3,
            topology: Topology::Sheet,
            spacing: [0.01, 0.01],
            flounce: None,
            crimp: None,
        };
        let mut positions = Vec::new();
        for row in 0..3 {
            for column in 0..9_u8 {
                let x = 0.01 * f32::from(column.min(8 - column));
                let height = if column < 4 { 0.0 } else { gap };
                // The far end is turned a little, so that no edge lies in the other layer's plane.
                let tilt = 0.1 * gap * f32::from(column);
                positions.push(Vec3::new(x + tilt, height, 0.01 * row as f32 + tilt));
            }
        }
        (grid, positions)
    }

    #[test]
    fn a_fold_that_lies_on_itself_does_not_cross_and_one_that_dips_through_does() {
        let (grid, mut positions) = folded(0.002);
        assert_eq!(self_crossings(&grid, &positions), Some(0));
        // The middle of the upper layer is pushed below the lower one.
        let particle = grid.index(1, 6);
        positions[particle].y = -0.002;
        assert!(self_crossings(&grid, &positions).is_some_and(|count| 0 < count));
    }

    #[test]
    fn cloth_that_is_not_finite_has_no_answer() {
        let (grid, mut positions) = folded(0.002);
        positions[3].x = f32::NAN;
        assert_eq!(self_crossings(&grid, &positions), None);
    }
}
