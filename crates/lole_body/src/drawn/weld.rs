//! Sewing a part to the body: the body is cut along a plane, the part's rim is drawn to the cut, and the strip
//! between them is closed.

use std::collections::{BTreeMap, BTreeSet};

use glam::Vec3;
use lole_geom::mesh::vertex_normals;

use crate::parts::Part;
use crate::skin_build::Half;
use crate::surface::half::{Neighbors, is_on_plane};
use crate::surface::warp::smooth_step;

/// How far before the part's rim the body is cut [m].
const BEFORE: f32 = 0.002;
/// How far into the part its rim's way to the body fades [m].
const FADE: f32 = 0.04;
/// How far into the part the light on the body goes over into its own [m].
const LIGHT_FADE: f32 = 0.015;
/// Least height above the plane [m] that counts.
const LEAST: f32 = 1.0e-7;

/// Where a part meets the body: a plane whose normal points into the part.
pub(super) struct Seam {
    center: Vec3,
    normal: Vec3,
}

impl Seam {
    pub(super) fn of(part: &Part) -> Self {
        let rim: Vec<Vec3> = (part.rim.iter())
            .map(|&point| part.positions[point as usize])
            .collect();
        let mean = |places: &[Vec3]| places.iter().sum::<Vec3>() / places.len().max(1) as f32;
        let center = mean(&rim);
        // Of a half rim the mirror image counts too: both ends lie on the mirror plane.
        let whole: Vec<Vec3> = if rim.first().is_some_and(|&end| is_on_plane(end)) {
            let other = rim
                .iter()
                .rev()
                .map(|place| *place * Vec3::new(-1.0, 1.0, 1.0));
            rim.iter().copied().chain(other).collect()
        } else {
            rim
        };
        let next = whole.iter().cycle().skip(1);
        let area: Vec3 = (whole.iter().zip(next))
            .map(|(&one, &next)| (one - center).cross(next - center))
            .sum();
        let normal = area.normalize_or(Vec3::Y);
        let is_inward = (mean(&part.positions) - center).dot(normal) < 0.0;
        Self {
            center,
            normal: if is_inward { -normal } else { normal },
        }
    }

    fn height(&self, place: Vec3) -> f32 {
        (place - self.center).dot(self.normal) + BEFORE
    }
}

/// Cuts off what is beyond the seam around `tip`; the cut's points in order, as the triangles that are left run
/// along it: closed, or from one point of the mirror plane to another.
pub(super) fn cut(half: &mut Half, seam: &Seam, tip: Vec3) -> Vec<u32> {
    let heights = beyond(half, seam, tip);
    let mut cuts: BTreeMap<[u32; 2], u32> = BTreeMap::new();
    let mut along: BTreeMap<u32, u32> = BTreeMap::new();
    let (mut triangles, mut kinds) = (Vec::new(), Vec::new());
    let (olds, old_kinds) = (
        std::mem::take(&mut half.triangles),
        std::mem::take(&mut half.kinds),
    );
    for (triangle, kind) in olds.into_iter().zip(old_kinds) {
        let is_kept = triangle.map(|corner| heights[corner as usize] < 0.0);
        let turned = |from: usize| [0, 1, 2].map(|step| triangle[(from + step) % 3]);
        let mut point = |a: u32, b: u32| {
            let key = [a.min(b), a.max(b)];
            *cuts.entry(key).or_insert_with(|| half.split(key, &heights))
        };
        match is_kept.iter().filter(|kept| **kept).count() {
            3 => triangles.push(triangle),
            2 => {
                let out = is_kept.iter().position(|kept| !kept).unwrap_or(0);
                let [a, b, c] = turned(out);
                let (x, y) = (point(a, b), point(a, c));
                triangles.extend([[x, b, c], [x, c, y]]);
                along.insert(y, x);
                kinds.push(kind);
            }
            1 => {
                let only = is_kept.iter().position(|kept| *kept).unwrap_or(0);
                let [a, b, c] = turned(only);
                let (x, y) = (point(a, b), point(a, c));
                triangles.push([a, x, y]);
                along.insert(x, y);
            }
            _ => continue,
        }
        kinds.push(kind);
    }
    (half.triangles, half.kinds) = (triangles, kinds);
    chain(&along)
}

/// Heights above the plane, where a vertex hangs together with `tip` beyond it; below zero elsewhere.
fn beyond(half: &Half, seam: &Seam, tip: Vec3) -> Vec<f32> {
    let mut heights: Vec<f32> = (half.positions.iter())
        .map(|&place| seam.height(place))
        .collect();
    let over = |heights: &[f32], vertex: usize| LEAST < heights[vertex];
    let seed = (0..heights.len())
        .filter(|&vertex| over(&heights, vertex))
        .min_by(|&a, &b| {
            let [a, b] = [a, b].map(|vertex| half.positions[vertex].distance_squared(tip));
            a.total_cmp(&b)
        });
    let neighbors = Neighbors::new(heights.len(), &half.triangles);
    let mut is_beyond = vec![false; heights.len()];
    let mut open: Vec<usize> = seed.into_iter().collect();
    while let Some(vertex) = open.pop() {
        if !std::mem::replace(&mut is_beyond[vertex], true) {
            let around = neighbors.of(vertex).iter().map(|&next| next as usize);
            open.extend(around.filter(|&next| over(&heights, next) && !is_beyond[next]));
        }
    }
    for (height, beyond) in heights.iter_mut().zip(is_beyond) {
        if !beyond {
            // On the plane, or beyond it elsewhere on the body, it stays as what is before it does.
            *height = height.min(-LEAST);
        }
    }
    heights
}

/// Points in the order in which each leads to the next.
fn chain(along: &BTreeMap<u32, u32>) -> Vec<u32> {
    let ends: BTreeSet<u32> = along.values().copied().collect();
    let first = (along.keys()).find(|point| !ends.contains(point));
    let Some(&first) = first.or_else(|| along.keys().next()) else {
        return Vec::new();
    };
    let mut points = vec![first];
    let mut last = first;
    while let Some(&next) = along.get(&last) {
        if next == first || along.len() < points.len() {
            break;
        }
        points.push(next);
        last = next;
    }
    points
}

/// Draws the part's rim to the body's border, and what is near it less and less.
pub(super) fn fit(part: &mut Part, seam: &Seam, (positions, border): (&[Vec3], &[u32])) {
    let mut border: Vec<Vec3> = (border.iter())
        .map(|&point| positions[point as usize])
        .collect();
    let rim: Vec<Vec3> = (part.rim.iter())
        .map(|&point| part.positions[point as usize])
        .collect();
    if rim.first().is_some_and(|&end| !is_on_plane(end)) {
        border.extend(border.first().copied());
    }
    let ways: Vec<Vec3> = (rim.iter())
        .map(|&place| {
            let way = nearest_on(&border, place) - place;
            let mut way = way - seam.normal * way.dot(seam.normal);
            if is_on_plane(place) {
                way.x = 0.0;
            }
            way
        })
        .collect();
    for place in &mut part.positions {
        let (mut sum, mut total, mut least) = (Vec3::ZERO, 0.0, f32::INFINITY);
        for (end, way) in rim.iter().zip(&ways) {
            let apart = place.distance(*end);
            let near = (apart + 1.0e-4).recip();
            let weight = near * near * near;
            sum += *way * weight;
            total += weight;
            least = least.min(apart);
        }
        let mut moved = *place + sum / total * smooth_step(1.0 - least / FADE);
        if is_on_plane(*place) {
            moved.x = 0.0;
        }
        *place = moved;
    }
}

/// The nearest point of a line of points.
fn nearest_on(line: &[Vec3], place: Vec3) -> Vec3 {
    let pairs = line.windows(2).map(|pair| [pair[0], pair[1]]);
    let found = pairs.map(|[a, b]| {
        let way = b - a;
        let share = (place - a).dot(way) / way.length_squared().max(1.0e-12);
        a + way * share.clamp(0.0, 1.0)
    });
    let nearest = found.min_by(|a, b| {
        let [a, b] = [a, b].map(|it| it.distance_squared(place));
        a.total_cmp(&b)
    });
    nearest.unwrap_or(place)
}

/// Normals of a part; near its rim those of the body around it.
pub(super) fn normals(part: &Part, around: &[Vec3]) -> Vec<Vec3> {
    let own = vertex_normals(&part.positions, &part.triangles);
    // Nails lie on points of their own, which no triangle of the skin has.
    let own = own
        .into_iter()
        .zip(around)
        .map(|(own, &around)| own.try_normalize().unwrap_or(around));
    let rim: Vec<Vec3> = (part.rim.iter())
        .map(|&point| part.positions[point as usize])
        .collect();
    let normals = part.positions.iter().zip(own).zip(around);
    let normals = normals.map(|((&place, own), &around)| {
        let apart = rim.iter().map(|end| end.distance(place));
        let least = apart.fold(f32::INFINITY, f32::min);
        let mut normal = around.lerp(own, smooth_step(least / LIGHT_FADE));
        if is_on_plane(place) {
            normal.x = 0.0;
        }
        normal.normalize_or(own)
    });
    normals.collect()
}

/// Triangles between the body's border and a part's rim, which run the same way.
pub(super) fn zip(positions: &[Vec3], border: &[u32], rim: &[u32]) -> Vec<[u32; 3]> {
    let at = |point: u32| positions[point as usize];
    let (Some(&start), Some(&end)) = (border.first(), rim.first()) else {
        return Vec::new();
    };
    let mut other = rim.to_vec();
    let mut one = border.to_vec();
    if !is_on_plane(at(end)) {
        let apart = |point: &u32| at(*point).distance_squared(at(start));
        let nearest =
            (0..other.len()).min_by(|&a, &b| apart(&other[a]).total_cmp(&apart(&other[b])));
        other.rotate_left(nearest.unwrap_or(0));
        one.push(one[0]);
        other.push(other[0]);
    }
    let (mut i, mut j) = (0, 0);
    let mut triangles = Vec::new();
    while i + 1 < one.len() || j + 1 < other.len() {
        let far = f32::INFINITY;
        let gap = |a: Option<&u32>, b: Option<&u32>| match (a, b) {
            (Some(&a), Some(&b)) => at(a).distance_squared(at(b)),
            _ => far,
        };
        let on = gap(one.get(i + 1), other.get(j));
        let over = gap(one.get(i), other.get(j + 1));
        if on < over {
            triangles.push([one[i + 1], one[i], other[j]]);
            i += 1;
        } else {
            triangles.push([one[i], other[j], other[j + 1]]);
            j += 1;
        }
    }
    triangles
}
