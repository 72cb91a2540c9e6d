//! The edges of the leotard are smooth lines on a dancer with raised arms.

use std::collections::BTreeMap;

use glam::{Quat, Vec3};
use lole_body::{Appearance, Bone, Dancer, Measurements, PartKind, Pose, SkinnedMesh, Tape};
use lole_geom::Length;

/// Along the edge, directions so far before and after a place are compared [m].
const AROUND: f32 = 0.008;

/// Closed lines between leotard and skin, by vertices.
fn edges(mesh: &SkinnedMesh) -> Vec<Vec<u32>> {
    let of = |kind: PartKind| {
        let parts = mesh.parts.iter().filter(move |part| part.kind == kind);
        let triangles = parts.flat_map(|part| &part.triangles);
        triangles.flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
    };
    let leotard: BTreeMap<[u32; 2], ()> = of(PartKind::Leotard).map(|edge| (edge, ())).collect();
    let shared = of(PartKind::Skin).filter(|[a, b]| leotard.contains_key(&[*b, *a]));
    let mut next: BTreeMap<u32, u32> = shared.map(|[a, b]| (a, b)).collect();
    let mut lines = Vec::new();
    while let Some((&first, _)) = next.iter().next() {
        let mut line = Vec::new();
        let mut at = first;
        while let Some(after) = next.remove(&at) {
            line.push(at);
            at = after;
        }
        lines.push(line);
    }
    lines
}

/// The sharpest turn [°] of any line on a posed mesh.
fn sharpest(mesh: &SkinnedMesh, positions: &[Vec3]) -> f32 {
    let mut sharpest = 0.0_f32;
    for line in edges(mesh).iter().filter(|line| line.len() > 8) {
        let places: Vec<Vec3> = line.iter().map(|&it| positions[it as usize]).collect();
        let along = |from: usize, step: usize| {
            let mut way = 0.0;
            let mut at = from;
            while way < AROUND {
                let next = (at + step) % places.len();
                way += places[at].distance(places[next]);
                at = next;
            }
            places[at] - places[from]
        };
        for place in 0..places.len() {
            let [before, after] = [places.len() - 1, 1].map(|step| along(place, step));
            sharpest = sharpest.max((-before).angle_between(after).to_degrees());
        }
    }
    sharpest
}

#[test]
fn the_leotard_has_smooth_edges_when_arms_are_raised() {
    for (stature, hip) in [(112.0, 62.0), (150.0, 84.0), (158.5, 91.0), (172.0, 118.0)] {
        let tape = Tape {
            stature: Some(Length::from_cm(stature)),
            hip_girth: Some(Length::from_cm(hip)),
            ..Tape::default()
        };
        let measurements = Measurements::from_tape(&tape).unwrap();
        let dancer = Dancer::with_appearance(&measurements, &Appearance::default()).unwrap();
        let skeleton = &dancer.skeleton;
        for towards in [
            Vec3::new(0.9, 0.0, 0.4),
            Vec3::new(0.8, -0.3, 0.5),
            Vec3::new(0.8, 0.4, 0.4),
        ] {
            let mut pose = Pose::default();
            for (upper, lower, side) in [
                (Bone::LeftUpperArm, Bone::LeftLowerArm, 1.0),
                (Bone::RightUpperArm, Bone::RightLowerArm, -1.0),
            ] {
                let along = (skeleton.joint(lower) - skeleton.joint(upper)).normalize_or_zero();
                let towards = (towards * Vec3::new(side, 1.0, 1.0)).normalize_or_zero();
                pose.rotate(upper, Quat::from_rotation_arc(along, towards));
            }
            let bones = skeleton.world_from_bind(&pose);
            let mesh = dancer.drawn();
            let (mut positions, mut normals) = (Vec::new(), Vec::new());
            mesh.pose(&bones, &mut positions, &mut normals);
            let turn = sharpest(mesh, &positions);
            assert!(turn < 60.0, "{stature} cm, {towards}: {turn}°");
        }
    }
}
