//! A surface drawn twice as fine: every triangle becomes four, rounded as its normals say.
//!
//! The new points are those of Phong tessellation (Boubekeur and Alexa 2008): between the middle of an edge and the
//! middle of where the planes at its two ends have it. Free edges of the surface are curves of their own, on which
//! what alternates from point to point is halved; corners, where they end, stay.

use std::collections::BTreeMap;

use glam::Vec3;

/// How far from its flat middle the point of an edge goes towards the planes at its ends.
const ROUNDNESS: f32 = 0.75;
/// Cosine of the angle between the normals at the ends of an edge up to which it is a crease and stays one, and from
/// which on it is all round.
const CREASE: [f32; 2] = [0.55, 0.85];
/// Share of the way to the middle of its neighbors that a point of a free edge goes, as in a cubic B-spline.
const SMOOTHING: f32 = 0.25;
/// Farthest that a point of a free edge is moved [m].
const FARTHEST: f32 = 0.003;

/// How a surface of given triangles is made finer, whatever its places are.
#[derive(Debug, Clone, PartialEq)]
pub struct Finer {
    /// Points of the surface as it is.
    count: usize,
    /// Edges whose points come after those, as they come.
    edges: Vec<Edge>,
    /// Points of free edges that have one neighbor on each side along it.
    smoothed: Vec<(u32, [u32; 2])>,
    /// The triangles of the finer surface.
    pub triangles: Vec<[u32; 3]>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct Edge {
    ends: [u32; 2],
    /// What follows beyond its ends along a free edge of the surface; `None` of an inner edge.
    beyond: Option<[u32; 2]>,
}

impl Finer {
    /// Triangles that come out of each, next to each other.
    pub const TIMES: usize = 4;

    /// That of triangles; `welded` tells, by point, the first of the points that are always at the same place.
    #[must_use]
    pub fn new(triangles: &[[u32; 3]], welded: &[u32]) -> Self {
        let weld = |point: u32| welded.get(point as usize).copied().unwrap_or(point);
        let key = |[a, b]: [u32; 2]| [a.min(b), a.max(b)];
        let sides = |&[a, b, c]: &[u32; 3]| [[a, b], [b, c], [c, a]];
        let mut met: BTreeMap<[u32; 2], u32> = BTreeMap::new();
        for side in triangles.iter().flat_map(sides) {
            *met.entry(key(side.map(weld))).or_default() += 1;
        }
        let is_free = |side: [u32; 2]| met.get(&key(side.map(weld))) == Some(&1);
        // Along the free edges, by what is welded.
        let mut beside: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
        for [a, b] in triangles.iter().flat_map(sides).filter(|&it| is_free(it)) {
            beside.entry(weld(a)).or_default().push(b);
            beside.entry(weld(b)).or_default().push(a);
        }
        // What belongs to one triangle alone is a corner of the surface, which stays one.
        let mut corners: BTreeMap<u32, u32> = BTreeMap::new();
        for &corner in triangles.iter().flatten() {
            *corners.entry(weld(corner)).or_default() += 1;
        }
        let neighbors = |point: u32| match beside.get(&weld(point)).map(Vec::as_slice) {
            Some(&[a, b]) if 1 < corners[&weld(point)] => Some([a, b]),
            _ => None,
        };
        let after = |point: u32, before: u32| {
            let both = neighbors(point)?;
            both.into_iter().find(|&it| weld(it) != weld(before))
        };
        let mut edges: Vec<Edge> = Vec::new();
        let mut places: BTreeMap<[u32; 2], u32> = BTreeMap::new();
        let count = welded.len();
        let mut point = |side: [u32; 2]| {
            *places.entry(key(side)).or_insert_with(|| {
                let ends = key(side);
                let [a, b] = ends;
                let beyond = is_free(ends).then(|| {
                    // Where the free edge ends, it goes on as if it were straight.
                    [
                        after(a, b).unwrap_or(u32::MAX),
                        after(b, a).unwrap_or(u32::MAX),
                    ]
                });
                edges.push(Edge { ends, beyond });
                number(count + edges.len() - 1)
            })
        };
        let finer = triangles.iter().flat_map(|triangle| {
            let [ab, bc, ca] = sides(triangle).map(&mut point);
            let [a, b, c] = *triangle;
            [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
        });
        let triangles = finer.collect();
        let smoothed = (0..number(count)).filter_map(|point| Some((point, neighbors(point)?)));
        Self {
            count,
            smoothed: smoothed.collect(),
            edges,
            triangles,
        }
    }

    /// Number of points of the finer surface.
    #[must_use]
    pub const fn count(&self) -> usize {
        self.count + self.edges.len()
    }

    /// Places [m] and unit normals of the finer surface, of those of the surface as it is.
    #[must_use]
    pub fn rounded(&self, [places, normals]: [&[Vec3]; 2]) -> [Vec<Vec3>; 2] {
        let mut finer = places.to_vec();
        for &(point, ends) in &self.smoothed {
            let [a, b] = ends.map(|end| places[end as usize]);
            let here = places[point as usize];
            let by = (a.midpoint(b) - here) * SMOOTHING;
            finer[point as usize] = here + by.clamp_length_max(FARTHEST);
        }
        let along = finer.clone();
        let at = |point: u32| along[point as usize];
        let points = self.edges.iter().map(|edge| {
            let [a, b] = edge.ends;
            let middle = at(a).midpoint(at(b));
            match edge.beyond {
                Some(beyond) => {
                    let straight = [at(a) * 2.0 - at(b), at(b) * 2.0 - at(a)];
                    let [before, after] = [0, 1].map(|end| {
                        let next = along.get(beyond[end] as usize).copied();
                        next.unwrap_or(straight[end])
                    });
                    middle + (middle - before.midpoint(after)) * 0.125
                }
                None => {
                    let on_plane = |end: u32| {
                        let normal = normals[end as usize];
                        middle - normal * (middle - at(end)).dot(normal)
                    };
                    let [one, other] = [a, b].map(|end| normals[end as usize]);
                    let share =
                        ((one.dot(other) - CREASE[0]) / (CREASE[1] - CREASE[0])).clamp(0.0, 1.0);
                    middle.lerp(on_plane(a).midpoint(on_plane(b)), ROUNDNESS * share)
                }
            }
        });
        finer.extend(points);
        let mut finer_normals = normals.to_vec();
        finer_normals.extend(self.edges.iter().map(|edge| {
            let [a, b] = edge.ends.map(|end| normals[end as usize]);
            (a + b).normalize_or(a)
        }));
        [finer, finer_normals]
    }

    /// Values of the finer surface that lie evenly between those of the surface as it is; none where it has none.
    #[must_use]
    pub fn spread<T>(&self, values: &[T]) -> Vec<T>
    where
        T: Copy + std::ops::Add<Output = T> + std::ops::Mul<f32, Output = T>,
    {
        if values.is_empty() {
            return Vec::new();
        }
        let between = self.edges.iter().map(|edge| {
            let [a, b] = edge.ends.map(|end| values[end as usize]);
            (a + b) * 0.5
        });
        values.iter().copied().chain(between).collect()
    }
}

fn number(count: usize) -> u32 {
    u32::try_from(count).unwrap_or(u32::MAX)
}

#[cfg(test)]
mod tests {
    use glam::Vec2;

    use super::*;
    use crate::trig;

    const SIDE: u32 = 9;

    /// A sheet of cells of 2 cm, cut into triangles, two of whose columns are sewn together where `seam` says.
    fn sheet(seam: Option<u32>) -> (Vec<[u32; 3]>, Vec<u32>, Vec<[u32; 2]>) {
        let mut places: Vec<[u32; 2]> = (0..SIDE)
            .flat_map(|row| (0..SIDE).map(move |column| [row, column]))
            .collect();
        let mut welded: Vec<u32> = (0..SIDE * SIDE).collect();
        let mut twin = BTreeMap::new();
        if let Some(seam) = seam {
            for row in 0..SIDE {
                twin.insert(row * SIDE + seam, number(places.len()));
                welded.push(row * SIDE + seam);
                places.push([row, seam]);
            }
        }
        let cells = (0..SIDE - 1).flat_map(|row| (0..SIDE - 1).map(move |column| [row, column]));
        let halves = cells.flat_map(|[row, column]| {
            let [a, b] = [row * SIDE + column, (row + 1) * SIDE + column];
            [[a, b, a + 1], [a + 1, b, b + 1]].map(|corners| {
                corners.map(|corner| match seam {
                    // The part to the right of the seam has points of its own there.
                    Some(seam) if seam <= column => *twin.get(&corner).unwrap_or(&corner),
                    _ => corner,
                })
            })
        });
        (halves.collect(), welded, places)
    }

    fn at(places: &[[u32; 2]], height: impl Fn(f32, f32) -> f32) -> Vec<Vec3> {
        let place = |&[row, column]: &[u32; 2]| {
            let [x, z] = [column, row].map(|it| 0.02 * it as f32);
            Vec3::new(x, height(x, z), z)
        };
        places.iter().map(place).collect()
    }

    #[test]
    fn what_is_flat_stays_flat_and_as_large() {
        let (triangles, welded, places) = sheet(Some(4));
        let finer = Finer::new(&triangles, &welded);
        assert_eq!(finer.triangles.len(), 4 * triangles.len());
        let flat = at(&places, |_, _| 0.0);
        let up = vec![Vec3::Y; flat.len()];
        let [rounded, normals] = finer.rounded([&flat, &up]);
        assert_eq!([rounded.len(), normals.len()], [finer.count(); 2]);
        assert!(rounded.iter().all(|place| place.y == 0.0));
        let area = |places: &[Vec3], triangles: &[[u32; 3]]| -> f32 {
            let doubled = triangles.iter().map(|it| {
                let [a, b, c] = it.map(|corner| places[corner as usize]);
                (b - a).cross(c - a).y
            });
            doubled.sum::<f32>() / 2.0
        };
        let [before, after] = [area(&flat, &triangles), area(&rounded, &finer.triangles)];
        assert!((after / before - 1.0).abs() < 0.002, "{before} {after}");
    }

    /// Both sides of a seam have its points at the same places, whatever the surface does.
    #[test]
    fn seams_stay_closed() {
        let (triangles, welded, places) = sheet(Some(4));
        let finer = Finer::new(&triangles, &welded);
        let wavy = |x: f32, z: f32| 0.01 * trig::sin(90.0 * x) * trig::cos(70.0 * z + 20.0 * x);
        let before = at(&places, wavy);
        let normals: Vec<Vec3> = (before.iter())
            .map(|place| Vec3::new(trig::sin(50.0 * place.x), 2.0, trig::cos(40.0 * place.z)))
            .map(Vec3::normalize_or_zero)
            .collect();
        let [rounded, _] = finer.rounded([&before, &normals]);
        let mut met: BTreeMap<[[i64; 3]; 2], u32> = BTreeMap::new();
        for &[a, b, c] in &finer.triangles {
            for side in [[a, b], [b, c], [c, a]] {
                #[expect(clippy::cast_possible_truncation, reason = "micrometers of a sheet")]
                let place = |end: u32| {
                    let place = rounded[end as usize] * 1.0e6;
                    place.to_array().map(|it| it.round() as i64)
                };
                let mut ends = side.map(place);
                ends.sort_unstable();
                *met.entry(ends).or_default() += 1;
            }
        }
        let free = met.values().filter(|count| **count == 1).count();
        assert_eq!(
            free,
            8 * (SIDE as usize - 1),
            "only the rim of the sheet is free"
        );
        assert!(met.values().all(|count| *count <= 2));
    }

    /// On a bowl the new points lie nearer to its sphere than the middles of the edges.
    #[test]
    fn what_is_round_becomes_rounder() {
        let (triangles, welded, places) = sheet(None);
        let finer = Finer::new(&triangles, &welded);
        let (radius, middle) = (0.15_f32, Vec3::new(0.08, 0.0, 0.08));
        let dome = |x: f32, z: f32| {
            let out = Vec2::new(x - middle.x, z - middle.z);
            (radius * radius - out.length_squared()).sqrt()
        };
        let before = at(&places, dome);
        let normals: Vec<Vec3> = before
            .iter()
            .map(|place| (place - middle) / radius)
            .collect();
        let [rounded, _] = finer.rounded([&before, &normals]);
        let inner = finer
            .edges
            .iter()
            .enumerate()
            .filter(|(_, edge)| edge.beyond.is_none());
        for (index, edge) in inner {
            let [a, b] = edge.ends.map(|end| before[end as usize]);
            let off = |place: Vec3| (place.distance(middle) - radius).abs();
            let now = off(rounded[finer.count + index]);
            assert!(now < 0.55 * off(a.midpoint(b)), "{a} {b}: {now}");
        }
    }

    /// Teeth along a hem are halved and rounded; its corners stay, and so does a straight hem.
    #[test]
    fn teeth_of_a_hem_are_rounded_and_its_corners_stay() {
        let (triangles, welded, places) = sheet(None);
        let finer = Finer::new(&triangles, &welded);
        let mut before = at(&places, |_, _| 0.0);
        let up = vec![Vec3::Y; before.len()];
        for (index, place) in before.iter_mut().take(SIDE as usize).enumerate() {
            place.z += if index % 2 == 0 { 0.004 } else { -0.004 };
        }
        let [rounded, _] = finer.rounded([&before, &up]);
        for place in &rounded[2..SIDE as usize - 2] {
            assert!((place.z.abs() - 0.002).abs() < 1.0e-3, "{place}");
        }
        let last = (SIDE * SIDE - 1) as usize;
        // One triangle alone has it, as it is cut.
        assert_eq!(before[last], rounded[last]);
        let straight = (SIDE * (SIDE - 1)) as usize + 3;
        assert!(before[straight].distance(rounded[straight]) < 1.0e-6);
    }
}
