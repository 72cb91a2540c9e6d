//! Horizontal cuts through a mesh, and the tape around them: the convex hull.

use glam::{Vec2, Vec3};

/// A point where the plane `y = height` cuts an edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct CutPoint {
    /// `(x, z)` [m].
    pub(crate) point: Vec2,
    /// Edge that is cut.
    pub(crate) edge: [u32; 2],
    /// Share of the way along it.
    pub(crate) share: f32,
}

/// All edges of `triangles` the plane `y = height` cuts.
pub(crate) fn cut_points(
    positions: &[Vec3],
    triangles: impl Iterator<Item = [u32; 3]>,
    height: f32,
) -> Vec<CutPoint> {
    let mut cuts = Vec::new();
    for [a, b, c] in triangles {
        for edge in [[a, b], [b, c], [c, a]] {
            let [from, to] = edge.map(|vertex| positions[vertex as usize]);
            if (from.y < height) != (to.y < height) {
                let share = (height - from.y) / (to.y - from.y);
                let point = from + (to - from) * share;
                cuts.push(CutPoint {
                    point: Vec2::new(point.x, point.z),
                    edge,
                    share,
                });
            }
        }
    }
    cuts
}

/// Convex hull (Andrew's monotone chain), counter-clockwise in `(x, z)`.
pub(crate) fn convex_hull(mut cuts: Vec<CutPoint>) -> Vec<CutPoint> {
    cuts.sort_by(|a, b| (a.point.x.total_cmp(&b.point.x)).then(a.point.y.total_cmp(&b.point.y)));
    cuts.dedup_by(|a, b| a.point == b.point);
    if cuts.len() < 3 {
        return cuts;
    }
    let mut hull: Vec<CutPoint> = Vec::with_capacity(cuts.len());
    let upper = cuts.iter().rev().skip(1);
    let mut least = 2;
    for (index, &cut) in cuts.iter().chain(upper).enumerate() {
        if index == cuts.len() {
            least = hull.len() + 1;
        }
        while hull.len() >= least && {
            let [a, b] = [hull[hull.len() - 2].point, hull[hull.len() - 1].point];
            (b - a).perp_dot(cut.point - b) <= 0.0
        } {
            hull.pop();
        }
        hull.push(cut);
    }
    hull.pop();
    hull
}

/// Length [m] of a closed polygon.
pub(crate) fn perimeter(polygon: &[CutPoint]) -> f32 {
    let next = polygon.iter().cycle().skip(1);
    polygon
        .iter()
        .zip(next)
        .map(|(a, b)| a.point.distance(b.point))
        .sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hull_of_a_square_with_inner_points_is_the_square() {
        let points = [
            [0., 0.],
            [1., 0.],
            [1., 1.],
            [0., 1.],
            [0.5, 0.5],
            [0.2, 0.9],
            [0.5, 0.],
        ];
        let cuts = points.map(|point| CutPoint {
            point: Vec2::from_array(point),
            edge: [0, 0],
            share: 0.0,
        });
        let hull = convex_hull(cuts.to_vec());
        assert_eq!(hull.len(), 4);
        assert!((perimeter(&hull) - 4.0).abs() < 1e-6);
    }
}
