//! Laws of the dancer: a closed surface with the tape's girths, carried by bones without tears,
//! covered by 13 capsules.

#![expect(
    clippy::unwrap_used,
    reason = "helpers of tests; a failure is a failed test"
)]

use std::collections::BTreeMap;
use std::sync::OnceLock;

use glam::{Quat, Vec2, Vec3};
use lole_body::{
    Appearance, Bone, CapsuleLayout, Dancer, HairStyle, Measurements, PartKind, Pose, Tape,
};
use lole_geom::{Capsule, Length};

fn woman() -> &'static Dancer {
    static WOMAN: OnceLock<Dancer> = OnceLock::new();
    WOMAN.get_or_init(|| Dancer::new(&Measurements::woman()).unwrap())
}

fn dancer([stature, bust, waist, hip, inseam]: [f64; 5]) -> Dancer {
    let cm = |value| Some(Length::from_cm(value));
    let tape = Tape {
        stature: cm(stature),
        bust_girth: cm(bust),
        waist_girth: cm(waist),
        hip_girth: cm(hip),
        inseam_length: cm(inseam),
        ..Tape::default()
    };
    Dancer::new(&Measurements::from_tape(&tape).unwrap()).unwrap()
}

fn turn_z(degrees: f32) -> Quat {
    Quat::from_rotation_z(degrees.to_radians())
}

/// Arms down, feet together, knees bent by `knee` degrees.
fn standing(knee: f32) -> Pose {
    let turn_x = |degrees: f32| Quat::from_rotation_x(degrees.to_radians());
    let mut pose = Pose::default();
    for (side, arm, leg, shank, foot) in [
        (
            1.0,
            Bone::LeftUpperArm,
            Bone::LeftUpperLeg,
            Bone::LeftLowerLeg,
            Bone::LeftFoot,
        ),
        (
            -1.0,
            Bone::RightUpperArm,
            Bone::RightUpperLeg,
            Bone::RightLowerLeg,
            Bone::RightFoot,
        ),
    ] {
        pose.rotate(arm, turn_z(-33.0 * side));
        pose.rotate(leg, turn_x(-0.5 * knee) * turn_z(-7.8 * side));
        pose.rotate(shank, turn_x(knee));
        pose.rotate(foot, turn_x(-0.5 * knee) * turn_z(7.8 * side));
    }
    pose
}

fn posed(dancer: &Dancer, pose: &Pose) -> Vec<Vec3> {
    let (mut positions, mut normals) = (Vec::new(), Vec::new());
    let world_from_bind = dancer.skeleton.world_from_bind(pose);
    dancer
        .skin
        .pose(&world_from_bind, &mut positions, &mut normals);
    positions
}

fn volume(positions: &[Vec3], triangles: &[[u32; 3]]) -> f64 {
    (triangles.iter())
        .map(|triangle| {
            let [a, b, c] = triangle.map(|vertex| positions[vertex as usize].as_dvec3());
            a.dot(b.cross(c)) / 6.0
        })
        .sum()
}

/// Triangles on each directed edge.
fn directed_edges(triangles: &[[u32; 3]]) -> BTreeMap<[u32; 2], usize> {
    let mut edges = BTreeMap::new();
    for &[a, b, c] in triangles {
        for edge in [[a, b], [b, c], [c, a]] {
            *edges.entry(edge).or_insert(0) += 1;
        }
    }
    edges
}

fn assert_closed(triangles: &[[u32; 3]], euler_characteristic: i64) {
    let edges = directed_edges(triangles);
    for (&[a, b], &count) in &edges {
        assert_eq!(count, 1, "edge {a} {b}");
        assert!(edges.contains_key(&[b, a]), "edge {a} {b} is open");
    }
    let mut vertices: Vec<u32> = triangles.iter().flatten().copied().collect();
    vertices.sort_unstable();
    vertices.dedup();
    let count = |len: usize| i64::try_from(len).unwrap();
    let euler = count(vertices.len()) - count(edges.len()) / 2 + count(triangles.len());
    assert_eq!(euler, euler_characteristic);
}

/// Girth of the taut tape: perimeter of a fine tape ring.
fn girth(dancer: &Dancer, height: f32) -> f64 {
    let ring = dancer.tape_ring(height, 2048);
    let next = ring.iter().cycle().skip(1);
    (ring.iter().zip(next))
        .map(|(a, b)| f64::from(a.bind_position.distance(b.bind_position)))
        .sum()
}

fn assert_measures(dancer: &Dancer) {
    let m = &dancer.measurements;
    let l = &dancer.landmarks;
    for (name, height, wanted) in [
        ("bust", l.bust_height, m.bust_girth),
        ("waist", l.waist_height, m.waist_girth),
        ("hip", l.hip_height, m.hip_girth),
    ] {
        let error = girth(dancer, height) - wanted.to_m();
        assert!(error.abs() < 0.002, "{name} is {error} m off");
    }
    let body = dancer.skin.body_triangles();
    let heights = || {
        body.iter()
            .flatten()
            .map(|&v| dancer.skin.positions[v as usize])
    };
    let crown = heights().map(|p| p.y).fold(0.0, f32::max);
    let floor = heights().map(|p| p.y).fold(1.0, f32::min);
    let crotch = heights()
        .filter(|p| p.x == 0.0)
        .map(|p| p.y)
        .fold(1.0, f32::min);
    assert!(
        (f64::from(crown) - m.stature.to_m()).abs() < 0.002,
        "crown at {crown}"
    );
    assert!(
        (f64::from(crotch) - m.inseam_length.to_m()).abs() < 0.002,
        "crotch at {crotch}"
    );
    assert!(floor.abs() < 0.002, "floor at {floor}");
}

#[test]
fn the_surface_is_closed_and_of_genus_zero() {
    let skin = &woman().skin;
    let body = skin.body_triangles();
    assert!(
        (14_000..=18_000).contains(&body.len()),
        "{} triangles",
        body.len()
    );
    assert_closed(&body, 2);
    for part in skin.parts.iter().filter(|part| part.kind > PartKind::Face) {
        let solids = if part.kind == PartKind::Hair { 2 } else { 1 };
        assert_closed(&part.triangles, 2 * solids);
    }
    for triangle in &body {
        let [a, b, c] = triangle.map(|vertex| skin.positions[vertex as usize]);
        assert!(
            (b - a).cross(c - a).length() > 1.0e-9,
            "a triangle has no area"
        );
    }
}

#[test]
fn hair_is_closed_in_every_style_and_leaves_the_body_as_it_is() {
    for (hair, solids) in [
        (HairStyle::Bun, 2),
        (HairStyle::Long, 2),
        (HairStyle::Short, 1),
        (HairStyle::Bob, 1),
    ] {
        let appearance = Appearance {
            hair,
            ..Appearance::default()
        };
        let dancer = Dancer::with_appearance(&Measurements::woman(), &appearance).unwrap();
        let body = dancer.skin.body_triangles();
        assert_eq!(body, woman().skin.body_triangles());
        let count = body
            .iter()
            .flatten()
            .max()
            .map_or(0, |&last| last as usize + 1);
        assert_eq!(
            dancer.skin.positions[..count],
            woman().skin.positions[..count]
        );
        let part = (dancer.skin.parts.iter()).find(|part| part.kind == PartKind::Hair);
        assert_closed(&part.unwrap().triangles, 2 * solids);
    }
}

#[test]
fn left_and_right_are_mirror_images() {
    let skin = &woman().skin;
    let body = skin.body_triangles();
    let key = |p: Vec3| p.to_array().map(f32::to_bits);
    let all: std::collections::BTreeSet<[u32; 3]> = body
        .iter()
        .flatten()
        .map(|&v| key(skin.positions[v as usize]))
        .collect();
    for &vertex in body.iter().flatten() {
        let position = skin.positions[vertex as usize];
        let mirrored = if position.x == 0.0 { 0.0 } else { -position.x };
        assert!(all.contains(&key(Vec3::new(mirrored, position.y, position.z))));
    }
}

#[test]
fn normals_and_weights_are_whole() {
    let skin = &woman().skin;
    for (vertex, normal) in skin.normals.iter().enumerate() {
        assert!((normal.length() - 1.0).abs() < 1e-4, "normal {vertex}");
        let sum: f32 = skin.weights[vertex].iter().sum();
        assert!((sum - 1.0).abs() < 1e-5, "weights {vertex}");
        assert!(skin.weights[vertex].iter().all(|&weight| weight >= 0.0));
    }
    // Normals come from a finer surface: a handful of triangles in creases may lean over.
    let body = skin.body_triangles();
    let inward = body.iter().filter(|triangle| {
        let [a, b, c] = triangle.map(|vertex| skin.positions[vertex as usize]);
        let smooth: Vec3 = triangle
            .map(|vertex| skin.normals[vertex as usize])
            .into_iter()
            .sum();
        (b - a).cross(c - a).dot(smooth) <= 0.0
    });
    assert!(inward.count() < body.len() / 1000);
}

#[test]
fn the_default_woman_has_her_tape() {
    assert_measures(woman());
}

#[test]
fn a_large_dancer_has_her_tape_and_a_closed_skin() {
    let large = dancer([163.0, 102.0, 92.0, 108.0, 73.0]);
    assert_measures(&large);
    assert_closed(&large.skin.body_triangles(), 2);
}

#[test]
fn a_child_has_her_tape_and_a_closed_skin() {
    let child = dancer([132.0, 66.0, 57.0, 71.0, 59.0]);
    assert_measures(&child);
    assert_closed(&child.skin.body_triangles(), 2);
}

#[test]
fn the_same_tape_gives_the_same_bits() {
    let again = Dancer::new(&Measurements::woman()).unwrap();
    let bits = |dancer: &Dancer| -> Vec<u32> {
        (dancer.skin.positions.iter().chain(&dancer.skin.normals))
            .flat_map(|vector| vector.to_array().map(f32::to_bits))
            .chain(
                dancer
                    .capsules
                    .iter()
                    .flat_map(|capsule| capsule.radii.map(f32::to_bits)),
            )
            .collect()
    };
    assert_eq!(bits(woman()), bits(&again));
    let single = rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build()
        .unwrap();
    let alone = single.install(|| Dancer::new(&Measurements::woman()).unwrap());
    assert_eq!(bits(woman()), bits(&alone));
}

#[test]
fn arms_down_and_knees_bent_tear_nothing() {
    let woman = woman();
    let body = woman.skin.body_triangles();
    let bind = volume(&woman.skin.positions, &body);
    let armpit = woman.skeleton.joint(Bone::LeftUpperArm);
    for (knee, loss) in [(0.0, 0.03), (75.0, 0.04)] {
        let positions = posed(woman, &standing(knee));
        let share = volume(&positions, &body) / bind;
        assert!((share - 1.0).abs() < loss, "volume {share} at knee {knee}");
        for &[a, b] in directed_edges(&body).keys() {
            let [a, b] = [a, b].map(|vertex| vertex as usize);
            let from = woman.skin.positions[a];
            let side = Vec3::new(armpit.x.copysign(from.x), armpit.y - 0.06, armpit.z);
            let before = from.distance(woman.skin.positions[b]);
            let after = positions[a].distance(positions[b]);
            let allowed = if from.distance(side) < 0.08 { 6.0 } else { 3.0 };
            assert!(
                after < allowed * before + 1e-4,
                "edge at {from} grew {}",
                after / before
            );
        }
    }
}

/// Share of a vertex that the upper arms carry.
fn arm_weight(dancer: &Dancer, vertex: u32) -> f32 {
    let vertex = vertex as usize;
    let (joints, weights) = (dancer.skin.joints[vertex], dancer.skin.weights[vertex]);
    [Bone::LeftUpperArm, Bone::RightUpperArm]
        .iter()
        .map(|arm| {
            (joints.iter().zip(weights))
                .filter(|(joint, _)| usize::from(**joint) == arm.index())
                .map(|(_, weight)| weight)
                .sum::<f32>()
        })
        .sum()
}

/// The armholes stay armholes when the arms rise: little of the arm moves their edge, and no step
/// from vertex to vertex.
#[test]
fn armholes_hardly_follow_the_arms_and_evenly() {
    let dancer = woman();
    let part = (dancer.skin.parts.iter())
        .find(|part| part.kind == PartKind::Leotard)
        .unwrap();
    let edges = directed_edges(&part.triangles);
    let rim = (edges.keys()).filter(|[a, b]| !edges.contains_key(&[*b, *a]));
    let mut steepest = 0.0_f32;
    let mut most = 0.0_f32;
    for &[a, b] in rim {
        let [w, other] = [a, b].map(|vertex| arm_weight(dancer, vertex));
        let [p, q] = [a, b].map(|vertex| dancer.skin.positions[vertex as usize]);
        most = most.max(w);
        steepest = steepest.max(((w - other).abs() - 0.01) / p.distance(q).max(1.0e-3));
    }
    assert!(most < 0.42, "the arm carries {most} of the rim");
    assert!(
        steepest < 12.0,
        "the arm's share changes by {steepest} a meter"
    );
}

#[test]
fn thirteen_capsules_cover_the_skin_below_the_waist() {
    let woman = woman();
    assert_eq!(woman.capsules.len(), 13);
    let body = woman.skin.body_triangles();
    for (knee, least_share) in [(0.0, 0.84), (40.0, 0.75)] {
        let pose = standing(knee);
        let positions = posed(woman, &pose);
        let world_from_bind = woman.skeleton.world_from_bind(&pose);
        let capsules: Vec<Capsule> = woman.posed_capsules(&world_from_bind);
        let (mut area, mut in_band, mut outside) = (0.0, 0.0, 0.0);
        for triangle in &body {
            let bind = woman.skin.positions[triangle[0] as usize];
            let bone = usize::from(woman.skin.joints[triangle[0] as usize][0]);
            let is_arm = bone > Bone::Chest.index() && bone < Bone::LeftUpperLeg.index();
            let is_foot = [Bone::LeftFoot, Bone::RightFoot]
                .iter()
                .any(|b| b.index() == bone);
            let l = &woman.landmarks;
            if is_arm || is_foot || bind.y < l.ankle_height || bind.y > l.waist_height {
                continue;
            }
            let [a, b, c] = triangle.map(|vertex| positions[vertex as usize]);
            let share = f64::from((b - a).cross(c - a).length());
            let distance = (capsules.iter())
                .map(|capsule| capsule.signed_distance((a + b + c) / 3.0))
                .fold(f32::INFINITY, f32::min);
            area += share;
            in_band += if (-0.008..=0.003).contains(&distance) {
                share
            } else {
                0.0
            };
            outside += if distance > 0.003 { share } else { 0.0 };
            assert!(distance < 0.010, "skin {distance} m outside at {bind}");
        }
        assert!(
            in_band / area > least_share,
            "knee {knee}: {} in band",
            in_band / area
        );
        assert!(
            outside / area < 0.03,
            "knee {knee}: {} outside",
            outside / area
        );
    }
}

/// Root mean square distance [m] from the skin between ankle and waist to the capsules.
fn misfit(woman: &Dancer, layout: CapsuleLayout) -> f32 {
    let pose = standing(0.0);
    let world_from_bind = woman.skeleton.world_from_bind(&pose);
    let capsules: Vec<Capsule> = (woman.fit_capsules(layout).iter())
        .map(|capsule| capsule.posed(&world_from_bind))
        .collect();
    let l = &woman.landmarks;
    let (mut sum, mut count) = (0.0, 0.0);
    for (vertex, position) in posed(woman, &pose).into_iter().enumerate() {
        let bind = woman.skin.positions[vertex];
        let bone = usize::from(woman.skin.joints[vertex][0]);
        let is_arm = bone > Bone::Chest.index() && bone < Bone::LeftUpperLeg.index();
        if !is_arm && (l.ankle_height + 0.02..l.waist_height).contains(&bind.y) {
            let distance = (capsules.iter())
                .map(|capsule| capsule.signed_distance(position))
                .fold(f32::INFINITY, f32::min);
            sum += distance * distance;
            count += 1.0;
        }
    }
    (sum / count).sqrt()
}

#[test]
fn any_number_of_capsules_can_stand_for_the_body_and_more_fit_better() {
    let woman = woman();
    for count in 1..=CapsuleLayout::MOST {
        let capsules = woman.fit_capsules(CapsuleLayout::Fitted(count));
        assert_eq!(capsules.len(), count as usize);
        for capsule in &capsules {
            assert!(
                capsule.ends.iter().all(|(_, end)| end.is_finite()),
                "{count}"
            );
            assert!(
                capsule.radii.iter().all(|r| (0.02..0.2).contains(r)),
                "{count}: {capsule:?}"
            );
        }
    }
    let misfits = [1, 4, 8, 13, 20, 40].map(|count| misfit(woman, CapsuleLayout::Fitted(count)));
    assert!(misfits.is_sorted_by(|few, many| many < few), "{misfits:?}");
    let cylinders = woman.fit_capsules(CapsuleLayout::TwoCylinders);
    assert_eq!(cylinders.len(), 2);
    assert!(misfits[3] < misfit(woman, CapsuleLayout::TwoCylinders));
}

#[test]
fn a_tape_ring_runs_from_the_back_over_the_left_at_equal_steps() {
    let woman = woman();
    let ring = woman.tape_ring(woman.landmarks.asis_height, 400);
    assert_eq!(ring.len(), 400);
    let at = |index: usize| ring[index].bind_position;
    assert!(
        at(0).x.abs() < 1e-6 && at(0).z < at(200).z,
        "starts at the back"
    );
    assert!(at(100).x > 0.1, "then the left");
    let steps: Vec<f32> = (0..400)
        .map(|index| at(index).distance(at((index + 1) % 400)))
        .collect();
    let (least, most) = steps
        .iter()
        .fold((1.0_f32, 0.0_f32), |(a, b), &s| (a.min(s), b.max(s)));
    assert!(most / least < 1.02, "steps {least} to {most}");
    let middle = Vec2::new(0.0, 0.5 * (at(0).z + at(200).z));
    for point in &ring {
        let out = Vec2::new(point.bind_position.x, point.bind_position.z) - middle;
        assert!(out.dot(Vec2::new(point.outward.x, point.outward.z)) > 0.0);
        assert!((point.weights.iter().sum::<f32>() - 1.0).abs() < 1e-5);
    }
    let rest = woman.skeleton.world_from_bind(&Pose::default());
    assert!(
        ring.iter()
            .all(|point| point.posed(&rest).distance(point.bind_position) < 1e-5)
    );
}

#[test]
fn a_tape_below_the_arms_stays_on_the_trunk_when_they_are_raised() {
    let woman = woman();
    let rest = woman.skeleton.world_from_bind(&Pose::default());
    let mut raised = Pose::default();
    for (arm, turn) in [(Bone::LeftUpperArm, 0.9), (Bone::RightUpperArm, -0.9)] {
        raised.rotations[arm.index()] = Quat::from_rotation_z(turn);
    }
    let raised = woman.skeleton.world_from_bind(&raised);
    for above_bust in [0.0, 0.02, 0.05] {
        for point in woman.tape_ring(woman.landmarks.bust_height + above_bust, 360) {
            assert_eq!(point.posed(&raised), point.posed(&rest), "{above_bust} m");
        }
    }
}

#[test]
fn missing_measurements_follow_those_taken() {
    let woman = Measurements::woman();
    assert!((woman.hip_girth.to_cm() - 91.0).abs() < 1e-9);
    let hip = |cm| Tape {
        hip_girth: Some(Length::from_cm(cm)),
        ..Tape::default()
    };
    let larger = Measurements::from_tape(&hip(105.0)).unwrap();
    assert!(larger.waist_girth > woman.waist_girth && larger.thigh_girth > woman.thigh_girth);
    assert_eq!(larger.stature, woman.stature);
}

#[test]
fn a_measurement_outside_its_band_is_named() {
    let tape = Tape {
        waist_girth: Some(Length::from_cm(660.0)),
        ..Tape::default()
    };
    let error = Measurements::from_tape(&tape).unwrap_err().to_string();
    assert_eq!(
        error,
        "waist girth is 660.0 cm, but a dancer's lies between 45.0 and 130.0 cm; \
         measure again or correct the unit"
    );
}
