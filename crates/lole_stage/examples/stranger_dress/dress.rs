//! A dress spread over the bind pose: a little outside of trunk and upper arms, a cone from the hips down, cut
//! at neck, sleeves and hem, as it would come from a modelling program: one welded surface of triangles.
//!
//! The surface of a solid is walked cell by cell, one vertex in each (Gibson 1998, "Constrained Elastic Surface
//! Nets").

use glam::{IVec3, Vec3};
use lole_body::{Bone, Dancer};
use lole_geom::TriangleGrid;
use lole_geom::triangle_grid::blend;
use lole_geom::weld::{short_edges, weld};

/// How far outside of the skin it lies on the shoulders, and elsewhere [m]: woven cloth does not give way
/// where arms are raised, and a dress that fits like a skin cannot be danced in.
const EASE: [f32; 2] = [0.010, 0.035];

/// Farthest from the skin that is looked [m].
const REACH: f32 = 0.16;

/// How much wider the skirt becomes for every meter down, and its radius at the hips beyond them [m].
const FLARE: f32 = 0.5;

/// Smoothing of what meets [m].
const BLEND: f32 = 0.05;

/// Share of the upper arm that a sleeve covers.
const SLEEVE: f32 = 0.55;

/// Radius of the neckline's ball around the neck joint [m].
const NECKLINE: f32 = 0.095;

/// Edges shorter than this share of the others become one vertex.
const SHORT: f32 = 0.35;

struct Solid<'a> {
    dancer: &'a Dancer,
    triangles: &'a [[u32; 3]],
    grid: TriangleGrid<'a>,
    hem: f32,
    /// Middle of the hips, and the skirt's radius there [m].
    hips: Vec3,
    radius: f32,
}

impl Solid<'_> {
    /// Signed distance to the dress, roughly [m].
    fn distance(&self, at: Vec3) -> f32 {
        let skin = &self.dancer.skin;
        let body = self.grid.nearest(at, REACH).map_or(REACH, |nearest| {
            let corners = self.triangles[nearest.triangle as usize];
            let normals = corners.map(|corner| skin.normals[corner as usize]);
            let normal = blend(normals, nearest.barycentric).normalize_or_zero();
            let is_inside = (at - nearest.point).dot(normal) < 0.0;
            let [above, beside] = EASE;
            let ease = beside + (above - beside) * (1.5 * normal.y).clamp(0.0, 1.0);
            (if is_inside {
                -nearest.distance
            } else {
                nearest.distance
            }) - ease
        });
        let axis = (at - self.hips).with_y(0.0).length();
        let below = self.hips.y - at.y;
        let skirt = (axis - self.radius - FLARE * below).max(-below - 0.06);
        smooth_least(body, skirt)
    }

    /// Whether the dress has cloth here.
    fn has_cloth(&self, at: Vec3) -> bool {
        let skeleton = &self.dancer.skeleton;
        let neck = skeleton.joint(Bone::Neck);
        if at.y < self.hem || at.distance(neck) < NECKLINE || neck.y + 0.02 < at.y {
            return false;
        }
        let nearest = self.grid.nearest(at, REACH);
        let bone = nearest.map(|nearest| {
            let corner = self.triangles[nearest.triangle as usize][0];
            self.dancer.skin.strongest_bone(corner as usize)
        });
        let arms = [
            (Bone::LeftUpperArm, Bone::LeftLowerArm),
            (Bone::RightUpperArm, Bone::RightLowerArm),
        ];
        arms.into_iter().all(|(upper, lower)| {
            let is_arm = bone.is_some_and(|bone| bone.lineage().any(|it| it == upper));
            if !is_arm {
                return true;
            }
            let [shoulder, elbow] = [upper, lower].map(|bone| skeleton.joint(bone));
            let way = elbow - shoulder;
            let along = (at - shoulder).dot(way) / way.length_squared();
            along < SLEEVE
        })
    }
}

/// The lesser of two, with a round corner (Quilez 2013).
fn smooth_least(a: f32, b: f32) -> f32 {
    let share = (BLEND - (a - b).abs()).max(0.0) / BLEND;
    a.min(b) - share * share * BLEND * 0.25
}

/// Places [m] and triangles, edges about so long [m].
pub(crate) fn spread(dancer: &Dancer, edge: f32) -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let triangles = dancer.skin.body_triangles();
    let skeleton = &dancer.skeleton;
    let hip_height = dancer.landmarks.hip_height;
    let ring = dancer.tape_ring(hip_height, 64);
    let middle = ring.iter().map(|it| it.bind_position).sum::<Vec3>() / 64.0;
    let radii = ring
        .iter()
        .map(|it| (it.bind_position - middle).with_y(0.0).length());
    let solid = Solid {
        dancer,
        grid: TriangleGrid::new(&dancer.skin.positions, &triangles, 0.03),
        triangles: &triangles,
        hem: dancer.landmarks.knee_height - 0.08,
        hips: middle.with_y(hip_height),
        radius: radii.fold(0.0, f32::max) + EASE[1],
    };
    let (half, top) = (0.62, skeleton.joint(Bone::Neck).y + 0.1);
    let low = Vec3::new(-half, solid.hem - 2.0 * edge, -half);
    let high = Vec3::new(half, top, half);
    let (positions, quads) = surface_net(&solid, [low, high], edge);
    let (positions, triangles) = cut(&solid, positions, &quads);
    let mut mesh = (positions, triangles);
    loop {
        let short = short_edges((&mesh.0, &mesh.1), SHORT * edge);
        if short.is_empty() {
            return mesh;
        }
        let joined = weld((&mesh.0, &mesh.1), 0.0, &short);
        mesh = mended(joined.positions, joined.triangles);
    }
}

/// A vertex in every cell of this size [m] that the surface goes through, and four of them for every edge of
/// cells that it crosses, counterclockwise from outside.
fn surface_net(solid: &Solid<'_>, [low, high]: [Vec3; 2], size: f32) -> (Vec<Vec3>, Vec<[u32; 4]>) {
    let counts = ((high - low) / size).ceil().as_ivec3();
    let index = |cell: IVec3| ((cell.z * counts.y + cell.y) * counts.x + cell.x) as usize;
    let place = |cell: IVec3| low + cell.as_vec3() * size;
    let cells = |from: i32| {
        (from..counts.z).flat_map(move |z| {
            (from..counts.y).flat_map(move |y| (from..counts.x).map(move |x| IVec3::new(x, y, z)))
        })
    };
    let values: Vec<f32> = cells(0).map(|cell| solid.distance(place(cell))).collect();
    let value = |cell: IVec3| values[index(cell)];
    let corners = [0, 1, 2, 3, 4, 5, 6, 7].map(|it| IVec3::new(it & 1, it >> 1 & 1, it >> 2));
    let mut positions = Vec::new();
    let mut vertices = vec![u32::MAX; values.len()];
    for cell in cells(0).filter(|cell| cell.cmplt(counts - IVec3::ONE).all()) {
        let mut sum = (Vec3::ZERO, 0.0);
        for from in corners {
            for axis in IVec3::AXES.into_iter().filter(|&axis| from.dot(axis) == 0) {
                let ends = [cell + from, cell + from + axis];
                let [a, b] = ends.map(value);
                if (a < 0.0) != (b < 0.0) {
                    sum.0 += place(ends[0]).lerp(place(ends[1]), a / (a - b));
                    sum.1 += 1.0;
                }
            }
        }
        if 0.0 < sum.1 {
            vertices[index(cell)] = u32::try_from(positions.len()).expect("few vertices");
            positions.push(sum.0 / sum.1);
        }
    }
    let mut quads = Vec::new();
    for cell in cells(1).filter(|cell| cell.cmplt(counts - IVec3::ONE).all()) {
        for (axis, [u, v]) in [
            (IVec3::X, [IVec3::Y, IVec3::Z]),
            (IVec3::Y, [IVec3::Z, IVec3::X]),
            (IVec3::Z, [IVec3::X, IVec3::Y]),
        ] {
            let [a, b] = [cell, cell + axis].map(|it| value(it) < 0.0);
            let around = [cell - u - v, cell - v, cell, cell - u].map(|it| vertices[index(it)]);
            match (a, b) {
                (true, false) => quads.push(around),
                (false, true) => quads.push([around[3], around[2], around[1], around[0]]),
                _ => {}
            }
        }
    }
    (positions, quads)
}

/// The cloth of a surface: the largest part of what is left at neck, sleeves and hem.
fn cut(solid: &Solid<'_>, positions: Vec<Vec3>, quads: &[[u32; 4]]) -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let has_cloth: Vec<bool> = positions.iter().map(|&at| solid.has_cloth(at)).collect();
    let at = |corner: u32| positions[corner as usize];
    let mut triangles: Vec<[u32; 3]> = Vec::new();
    for &[a, b, c, d] in quads {
        if ![a, b, c, d]
            .iter()
            .all(|&corner| has_cloth[corner as usize])
        {
            continue;
        }
        if at(a).distance(at(c)) < at(b).distance(at(d)) {
            triangles.extend([[a, b, c], [a, c, d]]);
        } else {
            triangles.extend([[a, b, d], [b, c, d]]);
        }
    }
    mended(positions, triangles)
}

/// The largest part, without what is no surface.
fn mended(positions: Vec<Vec3>, mut triangles: Vec<[u32; 3]>) -> (Vec<Vec3>, Vec<[u32; 3]>) {
    loop {
        let before = triangles.len();
        triangles = largest_part(positions.len(), triangles);
        triangles = without_pinches(positions.len(), triangles);
        if triangles.len() == before {
            break;
        }
    }
    let whole = weld((&positions, &triangles), 0.0, &[]);
    (whole.positions, whole.triangles)
}

/// The triangles that hang together with most others.
fn largest_part(count: usize, triangles: Vec<[u32; 3]>) -> Vec<[u32; 3]> {
    let mut roots: Vec<usize> = (0..count).collect();
    fn root(roots: &mut [usize], mut it: usize) -> usize {
        while roots[it] != it {
            roots[it] = roots[roots[it]];
            it = roots[it];
        }
        it
    }
    for triangle in &triangles {
        let [a, b, c] = triangle.map(|corner| root(&mut roots, corner as usize));
        let least = a.min(b).min(c);
        for it in [a, b, c] {
            roots[it] = least;
        }
    }
    let mut sizes = vec![0; count];
    for triangle in &triangles {
        sizes[root(&mut roots, triangle[0] as usize)] += 1;
    }
    let most = (0..count).max_by_key(|&it| sizes[it]).unwrap_or(0);
    triangles
        .into_iter()
        .filter(|triangle| root(&mut roots, triangle[0] as usize) == most)
        .collect()
}

/// Without the triangles at places where parts touch in a corner only.
fn without_pinches(count: usize, triangles: Vec<[u32; 3]>) -> Vec<[u32; 3]> {
    let mut sides: Vec<[u32; 2]> = triangles
        .iter()
        .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
        .map(|[a, b]| [a.min(b), a.max(b)])
        .collect();
    sides.sort_unstable();
    let mut borders = vec![0; count];
    for same in sides.chunk_by(|a, b| a == b) {
        // An edge of many triangles is left out like a pinch.
        let weight = [0, 1, 0, 3, 3];
        for end in same[0] {
            borders[end as usize] += weight[same.len().min(4)];
        }
    }
    triangles
        .into_iter()
        .filter(|triangle| triangle.iter().all(|&corner| borders[corner as usize] <= 2))
        .collect()
}
