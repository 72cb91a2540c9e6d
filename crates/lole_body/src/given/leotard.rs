//! The leotard on a given body that is nothing but bare skin.
//!
//! A scanned body is one mesh of one plain color, and a dancer is always shown dressed: skin of such
//! a body that the built dancers' leotard would cover is drawn as leotard. Where that is follows from
//! the shoulder joints and the crotch, with the arms lowered as the built bodies hold theirs. A body
//! with a picture, or of several materials, has clothes of its own, or what its maker means by them; a
//! body of many pieces is a doll.

use glam::{Vec2, Vec3};

use crate::surface::regions::Regions;
use crate::surface::slice::{Cut, slice};
use crate::{Bone, Figure, Landmarks, MeshPart, PartKind, Skeleton, SkinnedMesh};

/// What a child's bare body is drawn in, linear: a plain mannequin.
const MANNEQUIN: [f32; 3] = [0.46, 0.43, 0.41];

/// Share of a body's triangles that hang together at least, if it is one piece of skin: eyes and teeth
/// are pieces of their own.
const ONE_PIECE: f32 = 0.8;

/// Draws the leotard on a body of one plain material and one piece, whose vertices with the arms lowered are given
/// [m], and a child as a mannequin that wears it.
pub(super) fn dress(
    skin: &mut SkinnedMesh,
    skeleton: &Skeleton,
    landmarks: &Landmarks,
    arms_lowered: &[Vec3],
) {
    let ([part], [look]) = (&skin.parts[..], &mut skin.looks[..]) else {
        return;
    };
    if look.picture.is_some() || largest_piece(&skin.surface, skin.positions.len()) < ONE_PIECE {
        return;
    }
    if f64::from(100.0 * landmarks.crown_height) < Figure::CHILD_BELOW_CM {
        look.base_color = MANNEQUIN;
    }
    let regions = Regions::of_given(skeleton, landmarks.crotch_height);
    let values: Vec<f32> = (arms_lowered.iter().enumerate())
        .map(|(vertex, &place)| {
            let beside_trunk = below_neck(skin, vertex);
            regions
                .leotard(place, arm_share(skin, vertex))
                .min(beside_trunk)
        })
        .collect();
    let sliced = slice(&part.triangles, &values);
    for cut in &sliced.vertices[values.len()..] {
        if let Cut::Between(from, to, share) = *cut {
            push_between(skin, [from as usize, to as usize], share);
        }
    }
    let of = |wanted: bool| -> Vec<[u32; 3]> {
        let pieces = sliced.triangles.iter().zip(&sliced.is_positive);
        pieces
            .filter(|(_, is_inside)| **is_inside == wanted)
            .map(|(triangle, _)| *triangle)
            .collect()
    };
    let (bare, leotard) = (of(false), of(true));
    if bare.is_empty() || leotard.is_empty() {
        return;
    }
    skin.parts[0].triangles = bare;
    skin.parts.push(MeshPart {
        kind: PartKind::Leotard,
        triangles: leotard,
    });
}

/// Share of the triangles in the largest piece that hangs together by its vertices.
fn largest_piece(triangles: &[[u32; 3]], vertex_count: usize) -> f32 {
    let mut above: Vec<u32> = (0..).take(vertex_count).collect();
    for &[a, b, c] in triangles {
        for (from, to) in [(a, b), (b, c)] {
            let (from, to) = (root(&mut above, from), root(&mut above, to));
            above[from.max(to) as usize] = from.min(to);
        }
    }
    let mut counts = vec![0.0_f32; vertex_count];
    for &[a, ..] in triangles {
        counts[root(&mut above, a) as usize] += 1.0;
    }
    let largest = counts.into_iter().fold(0.0, f32::max);
    largest / (triangles.len().max(1) as f32)
}

/// The least vertex of the piece of a vertex; ways to it are shortened.
fn root(above: &mut [u32], mut vertex: u32) -> u32 {
    while above[vertex as usize] != vertex {
        let next = above[above[vertex as usize] as usize];
        above[vertex as usize] = next;
        vertex = next;
    }
    vertex
}

/// How much of a vertex the arms carry.
fn arm_share(skin: &SkinnedMesh, vertex: usize) -> f32 {
    share(skin, vertex, |bone| {
        is_below(bone, Bone::LeftUpperArm) || is_below(bone, Bone::RightUpperArm)
    })
}

/// Negative where the head carries a vertex: hair that hangs down is none of the trunk's skin.
fn below_neck(skin: &SkinnedMesh, vertex: usize) -> f32 {
    0.5 - share(skin, vertex, |bone| is_below(bone, Bone::Head))
}

/// Whether a bone is another one or hangs on it.
fn is_below(bone: Bone, root: Bone) -> bool {
    bone.lineage().any(|bone| bone == root)
}

fn share(skin: &SkinnedMesh, vertex: usize, counts: impl Fn(Bone) -> bool) -> f32 {
    let shares = skin.joints[vertex].iter().zip(&skin.weights[vertex]);
    let counted = shares.filter(|(joint, _)| {
        let bone = Bone::ALL.get(usize::from(**joint));
        bone.is_some_and(|&bone| counts(bone))
    });
    counted.map(|(_, share)| share).sum()
}

/// A vertex a share of the way from one to another.
fn push_between(skin: &mut SkinnedMesh, [from, to]: [usize; 2], share: f32) {
    let position = skin.positions[from].lerp(skin.positions[to], share);
    let normal = skin.normals[from].lerp(skin.normals[to], share);
    let uv: Vec2 = skin.uvs[from].lerp(skin.uvs[to], share);
    let (joints, weights) = carried_between(skin, [from, to], share);
    skin.positions.push(position);
    skin.normals.push(normal.normalize_or_zero());
    skin.uvs.push(uv);
    skin.joints.push(joints);
    skin.weights.push(weights);
}

/// The four bones that carry a place between two vertices most, and their shares.
fn carried_between(skin: &SkinnedMesh, ends: [usize; 2], share: f32) -> ([u16; 4], [f32; 4]) {
    let mut carriers: Vec<(u16, f32)> = Vec::with_capacity(8);
    for (vertex, part) in ends.into_iter().zip([1.0 - share, share]) {
        for (&joint, weight) in skin.joints[vertex].iter().zip(skin.weights[vertex]) {
            match carriers.iter_mut().find(|(known, _)| *known == joint) {
                Some((_, sum)) => *sum += part * weight,
                None => carriers.push((joint, part * weight)),
            }
        }
    }
    carriers.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
    carriers.truncate(4);
    let sum: f32 = carriers.iter().map(|(_, weight)| weight).sum();
    let (mut joints, mut weights) = ([0; 4], [0.0; 4]);
    for (slot, (joint, weight)) in carriers.into_iter().enumerate() {
        joints[slot] = joint;
        weights[slot] = weight / sum.max(f32::MIN_POSITIVE);
    }
    (joints, weights)
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use lole_geom::Length;

    use super::*;
    use crate::{Dancer, Look, Measurements, SkinPicture, Tape};

    fn plain() -> Look {
        Look {
            name: String::new(),
            base_color: [0.8, 0.6, 0.5],
            picture: None,
            roughness: 0.6,
            is_two_sided: false,
        }
    }

    fn built(stature_cm: f64) -> Dancer {
        let tape = Tape {
            stature: Some(Length::from_cm(stature_cm)),
            ..Tape::default()
        };
        Dancer::new(&Measurements::from_tape(&tape).unwrap()).unwrap()
    }

    /// A built dancer's body as if it had been given, without her leotard.
    fn bare(built: &Dancer, look: Look) -> Dancer {
        let triangles = built.skin.body_triangles();
        let skin = SkinnedMesh {
            parts: vec![MeshPart {
                kind: PartKind::Given,
                triangles: triangles.clone(),
            }],
            surface: triangles,
            looks: vec![look],
            hinges: Vec::new(),
            turning: Vec::new(),
            ..built.skin.clone()
        };
        Dancer::of_skin(built.skeleton.clone(), skin).unwrap()
    }

    fn area(skin: &SkinnedMesh, kind: PartKind) -> f32 {
        let parts = skin.parts.iter().filter(|part| part.kind == kind);
        let triangles = parts.flat_map(|part| &part.triangles);
        let areas = triangles.map(|triangle| {
            let [a, b, c] = triangle.map(|vertex| skin.positions[vertex as usize]);
            0.5 * (b - a).cross(c - a).length()
        });
        areas.sum()
    }

    #[test]
    fn a_bare_body_is_drawn_in_the_leotard_that_the_same_body_is_built_in() {
        for stature_cm in [158.5, 172.0, 120.0] {
            let built = built(stature_cm);
            let given = bare(&built, plain());
            let [own, painted] = [&built, &given].map(|it| area(&it.skin, PartKind::Leotard));
            let ratio = painted / own;
            assert!((ratio - 1.0).abs() < 0.06, "{stature_cm}: {ratio}");
            // Nothing is lost or drawn twice, and what is measured is a part of what there was.
            let whole = area(&given.skin, PartKind::Given) + painted;
            let triangles = built.skin.body_triangles();
            let kinds = [PartKind::Skin, PartKind::Face, PartKind::Leotard];
            let before: f32 = kinds.iter().map(|&kind| area(&built.skin, kind)).sum();
            assert!((whole / before - 1.0).abs() < 1e-3, "{whole} {before}");
            let met = given.skin.body_triangles();
            let turned = met.iter().filter(|triangle| !triangles.contains(triangle));
            let (turned, count) = (turned.count() as f32, triangles.len() as f32);
            assert!(turned < 0.02 * count, "{turned} of {count} are turned");
            assert!(0.6 * count < met.len() as f32, "{} of {count}", met.len());
        }
    }

    #[test]
    fn no_skin_of_the_trunk_is_bare_from_the_high_hip_to_the_bust() {
        for stature_cm in [158.5, 120.0] {
            let given = bare(&built(stature_cm), plain());
            let (skin, marks) = (&given.skin, &given.landmarks);
            let covered = marks.high_hip_height..marks.bust_height;
            for vertex in skin.parts[0].triangles.iter().flatten() {
                let vertex = *vertex as usize;
                let place = skin.positions[vertex];
                let is_trunk = arm_share(skin, vertex) < 0.3 && place.x.abs() < 0.1;
                assert!(!(is_trunk && covered.contains(&place.y)), "{place}");
            }
        }
    }

    #[test]
    fn a_child_is_a_mannequin_and_who_has_clothes_keeps_them() {
        let child = bare(&built(120.0), plain());
        assert_eq!(child.skin.looks[0].base_color, MANNEQUIN);
        let woman = built(158.5);
        assert_eq!(
            bare(&woman, plain()).skin.looks[0].base_color,
            plain().base_color
        );
        let picture = SkinPicture {
            width: 1,
            height: 1,
            pixels: vec![255; 4],
        };
        let pictured = Look {
            picture: Some(Arc::new(picture)),
            ..plain()
        };
        assert_eq!(
            largest_piece(&[[0, 1, 2], [2, 3, 4], [5, 6, 7]], 8),
            2.0 / 3.0
        );
        let clothed = bare(&woman, pictured);
        assert_eq!(clothed.skin.parts.len(), 1);
        assert_eq!(clothed.skin.positions, woman.skin.positions);
    }
}
