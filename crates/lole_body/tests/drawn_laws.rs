//! Laws of the drawn body: a closed surface whose head, hands and feet are sewn on without a crack, and which is
//! the skin that cloth meets everywhere else.

use std::collections::{BTreeMap, BTreeSet};

use glam::Vec3;
use lole_body::{
    Appearance, BodyError, Bone, Dancer, Expression, Face, Feature, Figure, HairStyle,
    Measurements, PartKind, Pose, SkinnedMesh, Tape,
};
use lole_geom::{Chance, Length, TriangleGrid};

fn drawn(measurements: &Measurements) -> Result<Dancer, BodyError> {
    Dancer::with_appearance(measurements, &Appearance::default())
}

/// The measured face, one whose features are all at their least or most, or one by chance, of any age.
fn face(chance: &mut Chance) -> Appearance {
    let face = match chance.bits() % 3 {
        0 => Face::default(),
        1 => Feature::ALL
            .into_iter()
            .fold(Face::default(), |face, feature| {
                face.with(feature, if chance.falls(0.5) { 1.0 } else { -1.0 })
            }),
        _ => Face::of_seed(chance.bits()),
    };
    Appearance {
        face,
        age_years: chance.falls(0.5).then(|| chance.between(3.0, 100.0)),
        ..Appearance::default()
    }
}

/// Dancers of every figure and face at random, over the whole range of measures that a body can be built of.
fn dancers(count: u64) -> Vec<Dancer> {
    let mut chance = Chance::new(7);
    let mut found = Vec::new();
    for turn in 0.. {
        let figure = [Figure::Woman, Figure::Man, Figure::Child, Figure::OfStature][turn % 4];
        let mut between = |low: f64, high: f64| low + (high - low) * f64::from(chance.share());
        let stature = match figure {
            Figure::Child => between(100.0, 155.0),
            _ => between(140.0, 190.0),
        };
        let hip = stature * between(0.46, 0.8);
        let tape = Tape {
            figure,
            stature: Some(Length::from_cm(stature)),
            hip_girth: Some(Length::from_cm(hip)),
            waist_girth: Some(Length::from_cm(hip * between(0.66, 0.95))),
            bust_girth: Some(Length::from_cm(hip * between(0.82, 1.05))),
            ..Tape::default()
        };
        // What no body has is refused, and not drawn.
        let looks = face(&mut chance);
        let built =
            Measurements::from_tape(&tape).and_then(|tape| Dancer::with_appearance(&tape, &looks));
        found.extend(built.ok());
        if found.len() as u64 == count {
            break;
        }
        assert!(turn < 400, "hardly any of them can be built");
    }
    found
}

/// Every edge has a triangle on each side, once in each direction, and the whole is one ball.
fn assert_closed(mesh: &SkinnedMesh) {
    let triangles = mesh.body_triangles();
    let mut met: BTreeMap<[u32; 2], u32> = BTreeMap::new();
    for &[a, b, c] in &triangles {
        for edge in [[a, b], [b, c], [c, a]] {
            *met.entry(edge).or_default() += 1;
        }
    }
    let twice = met.values().filter(|count| **count != 1).count();
    let open = met.keys().filter(|[a, b]| !met.contains_key(&[*b, *a]));
    assert_eq!(
        (twice, open.count()),
        (0, 0),
        "edges met twice, and open ones"
    );
    let vertices: BTreeSet<u32> = triangles.iter().flatten().copied().collect();
    assert_eq!(
        vertices.len() + triangles.len(),
        met.len() / 2 + 2,
        "one ball"
    );
}

#[test]
fn the_drawn_body_is_closed_whatever_the_measures() {
    for dancer in dancers(16) {
        let drawn = dancer.drawn();
        assert_closed(drawn);
        for (vertex, normal) in drawn.normals.iter().enumerate() {
            assert!(
                (normal.length() - 1.0).abs() < 1.0e-3,
                "normal {vertex}: {normal}"
            );
            let sum: f32 = drawn.weights[vertex].iter().sum();
            assert!((sum - 1.0).abs() < 1.0e-4, "weights {vertex}: {sum}");
        }
        let is_color = |color: &Vec3| color.cmpge(Vec3::ZERO).all() && color.cmple(Vec3::ONE).all();
        assert_eq!(drawn.colors.len(), drawn.positions.len());
        assert!(drawn.colors.iter().all(is_color));
    }
}

#[test]
fn the_drawn_body_is_the_skin_but_for_head_hands_and_feet() {
    for dancer in dancers(8) {
        let (drawn, skin) = (dancer.drawn(), &dancer.skin);
        let triangles = skin.body_triangles();
        let grid = TriangleGrid::new(&skin.positions, &triangles, 0.012);
        let neck = dancer.skeleton.joint(Bone::Neck).y;
        for &vertex in drawn.body_triangles().iter().flatten() {
            let place = drawn.positions[vertex as usize];
            let bone = drawn.strongest_bone(vertex as usize);
            let name = bone.name();
            let is_part = [
                "Hand", "Thumb", "Index", "Middle", "Ring", "Little", "Foot", "Toes",
            ]
            .iter()
            .any(|part| name.contains(part))
                || neck - 0.02 < place.y
                    && matches!(bone, Bone::Head | Bone::Neck | Bone::UpperChest);
            // Ears, lids and toes stand farther off than their sections.
            let most = if is_part { 0.035 } else { 0.006 };
            let off = grid
                .nearest(place, 0.05)
                .map_or(0.05, |nearest| nearest.distance);
            assert!(off < most, "{name} at {place}: {off} m off the skin");
        }
    }
}

#[test]
fn eyes_lie_behind_the_lids_and_between_them() {
    for dancer in dancers(8) {
        let drawn = dancer.drawn();
        let part = |kind: PartKind| drawn.parts.iter().find(|part| part.kind == kind).unwrap();
        let eyes = &part(PartKind::Eye).triangles;
        let places = |triangles: &[[u32; 3]]| -> Vec<Vec3> {
            let corners = triangles.iter().flatten();
            corners
                .map(|&corner| drawn.positions[corner as usize])
                .collect()
        };
        let left: Vec<Vec3> = places(eyes)
            .into_iter()
            .filter(|place| 0.0 < place.x)
            .collect();
        let front = left
            .iter()
            .fold(Vec3::MIN, |front, place| front.max(*place))
            .z;
        let back = left
            .iter()
            .fold(Vec3::MAX, |back, place| back.min(*place))
            .z;
        let body = drawn.body_triangles();
        let grid = TriangleGrid::new(&drawn.positions, &body, 0.012);
        let middle = left.iter().sum::<Vec3>() / left.len() as f32;
        // Somebody before her sees the iris, and skin over and under the eye.
        let seen = |up: f32, depth: f32| {
            let from = Vec3::new(middle.x, middle.y + up, front + 0.2);
            let to = Vec3::new(middle.x, middle.y + up, depth);
            grid.first_crossing(from, to).is_none()
        };
        assert!(seen(0.0, front - 0.001), "the lids are closed");
        let size = front - back;
        let is_covered = |up: f32| !seen(up * size, back);
        assert!(is_covered(1.1) && is_covered(-1.1), "there are no lids");
    }
}

#[test]
fn closed_eyes_are_covered_and_open_again() {
    for dancer in dancers(6) {
        let bones = dancer.skeleton.world_from_bind(&Pose::default());
        let pose = |closed: f32| {
            let expression = Expression {
                closed,
                looks_at: None,
            };
            let (mut positions, mut normals) = (Vec::new(), Vec::new());
            dancer.pose_drawn(&bones, expression, (&mut positions, &mut normals));
            positions
        };
        let drawn = dancer.drawn();
        let eyes = drawn.parts.iter().find(|part| part.kind == PartKind::Eye);
        let eyes: BTreeSet<u32> = eyes.unwrap().triangles.iter().flatten().copied().collect();
        let body = drawn.body_triangles();
        let seen = |closed: f32| {
            let positions = pose(closed);
            let grid = TriangleGrid::new(&positions, &body, 0.012);
            let is_seen = |&&vertex: &&u32| {
                let place = positions[vertex as usize];
                let from = place + Vec3::Z * 0.2;
                grid.first_crossing(from, place + Vec3::Z * 1.0e-4)
                    .is_none()
            };
            eyes.iter().filter(is_seen).count()
        };
        let counts = [0.0, 0.25, 0.5, 0.75, 1.0].map(seen);
        assert!(30 < counts[0], "{counts:?}");
        assert!(counts.is_sorted_by(|more, less| less <= more), "{counts:?}");
        assert_eq!(counts[4], 0, "nothing of a closed eye is seen");
        assert_eq!(pose(0.0), {
            let (mut positions, mut normals) = (Vec::new(), Vec::new());
            drawn.pose(&bones, &mut positions, &mut normals);
            positions
        });
    }
}

#[test]
fn eyes_turn_to_what_she_looks_at_and_stay_where_they_are() {
    let dancer = drawn(&Measurements::woman()).unwrap();
    let bones = dancer.skeleton.world_from_bind(&Pose::default());
    let eyes = |looks_at: Option<Vec3>| -> Vec<Vec3> {
        let expression = Expression {
            closed: 0.0,
            looks_at,
        };
        let (mut positions, mut normals) = (Vec::new(), Vec::new());
        dancer.pose_drawn(&bones, expression, (&mut positions, &mut normals));
        let part = (dancer.drawn().parts.iter()).find(|part| part.kind == PartKind::Eye);
        let corners = part.unwrap().triangles.iter().flatten();
        corners.map(|&corner| positions[corner as usize]).collect()
    };
    let ahead = eyes(None);
    // The first triangle begins at the pupil's middle.
    for (target, way) in [(Vec3::X, Vec3::X), (-Vec3::X, -Vec3::X), (Vec3::Y, Vec3::Y)] {
        let looking = eyes(Some(ahead[0] + target * 0.7 + Vec3::Z));
        assert!(0.5e-3 < (looking[0] - ahead[0]).dot(way), "{target}");
        let farthest = looking.iter().zip(&ahead).map(|(a, b)| a.distance(*b));
        assert!(farthest.fold(0.0, f32::max) < 6.0e-3);
    }
    let behind = eyes(Some(ahead[0] - Vec3::Z * 2.0));
    assert!(behind[0].distance(ahead[0]) < 0.5e-3);
}

/// Whatever is chosen, all below the head stays to the bit, hair to 8 mm, every point of the face has moved by less
/// than 1.5 cm, and no triangle of it has turned over.
#[test]
fn features_change_the_face_alone_and_turn_nothing_over() {
    let mut chance = Chance::new(21);
    for dancer in dancers(4) {
        let usual = drawn(&dancer.measurements).unwrap();
        for _ in 0..4 {
            let looks = Appearance {
                age_years: None,
                ..face(&mut chance)
            };
            let changed = Dancer::with_appearance(&dancer.measurements, &looks).unwrap();
            let [before, after] = [&usual, &changed].map(Dancer::drawn);
            assert_eq!(usual.skin, changed.skin);
            let neck = usual.skeleton.joint(Bone::Neck).y;
            for (vertex, (place, moved)) in
                before.positions.iter().zip(&after.positions).enumerate()
            {
                assert!(
                    place.distance(*moved) < 0.015,
                    "{vertex} at {place}: {moved}"
                );
                assert!(neck < place.y || place == moved, "{vertex} at {place}");
            }
            for (part, other) in before.parts.iter().zip(&after.parts) {
                assert_eq!(
                    part.triangles.len(),
                    other.triangles.len(),
                    "{:?}",
                    part.kind
                );
                let is_hair = matches!(part.kind, PartKind::Hair);
                for triangle in &part.triangles {
                    let [a, b, c] = triangle.map(|corner| before.positions[corner as usize]);
                    let [d, e, f] = triangle.map(|corner| after.positions[corner as usize]);
                    // Hair lies on the head below, a child's bob on cheek and jaw.
                    let far = [a.distance(d), b.distance(e), c.distance(f)];
                    assert!(!is_hair || far.iter().all(|&far| far < 0.008), "{far:?}");
                    let [old, new] = [(b - a).cross(c - a), (e - d).cross(f - d)];
                    let is_turned = new.dot(old) < 0.0 && part.kind == PartKind::Skin;
                    assert!(!is_turned, "a triangle turned over at {a}");
                }
            }
        }
    }
}

/// Years raise nothing and take nothing away: the same triangles, at other places of the head alone.
#[test]
fn years_change_the_head_alone() {
    for dancer in dancers(4) {
        let [young, old] = [20.0, 95.0].map(|age| {
            let looks = Appearance {
                age_years: Some(age),
                ..Appearance::default()
            };
            Dancer::with_appearance(&dancer.measurements, &looks).unwrap()
        });
        assert_eq!(young.skin, old.skin);
        let [before, after] = [&young, &old].map(Dancer::drawn);
        let neck = young.skeleton.joint(Bone::Neck).y;
        let mut farthest = 0.0_f32;
        for (part, other) in before.parts.iter().zip(&after.parts) {
            if part.kind == PartKind::Hair {
                continue;
            }
            assert_eq!(part.triangles, other.triangles);
            for &corner in part.triangles.iter().flatten() {
                let [place, moved] = [before, after].map(|mesh| mesh.positions[corner as usize]);
                assert!(neck - 0.02 < place.y || place == moved, "{place}: {moved}");
                farthest = farthest.max(place.distance(moved));
            }
        }
        assert!((0.002..0.04).contains(&farthest), "{farthest}");
        assert!(young.drawn().colors != old.drawn().colors);
    }
}

#[test]
fn the_same_tape_draws_the_same_bits() {
    let [one, other] = [(); 2].map(|()| drawn(&Measurements::woman()).unwrap());
    assert_eq!(one.drawn_body, other.drawn_body);
}

/// Single strands lie on hair or on the skin beside it, in every style and on unlike heads, and the head carries them.
#[test]
fn strands_lie_on_the_hair() {
    for measurements in dancers(3).iter().map(|dancer| dancer.measurements) {
        for hair in [
            HairStyle::Bun,
            HairStyle::Long,
            HairStyle::Short,
            HairStyle::Bob,
        ] {
            let appearance = Appearance {
                hair,
                ..Appearance::default()
            };
            let dancer = Dancer::with_appearance(&measurements, &appearance).unwrap();
            let (drawn, strands) = (dancer.drawn(), &dancer.drawn_body.as_ref().unwrap().strands);
            let [part] = &strands.parts[..] else {
                panic!("{} parts", strands.parts.len());
            };
            assert!(
                part.triangles.len() > 10_000,
                "{} triangles",
                part.triangles.len()
            );
            let on: Vec<Vec3> = (drawn.parts.iter())
                .filter(|part| matches!(part.kind, PartKind::Hair | PartKind::Skin))
                .flat_map(|part| part.triangles.iter().flatten())
                .map(|&vertex| drawn.positions[vertex as usize])
                .filter(|place| f64::from(place.y) > 0.5 * measurements.stature.to_m())
                .collect();
            for (vertex, place) in strands.positions.iter().enumerate().step_by(97) {
                let nearest = (on.iter())
                    .map(|other| other.distance(*place))
                    .fold(f32::INFINITY, f32::min);
                assert!(nearest < 0.02, "{hair:?}: {nearest} m off at {place}");
                assert!((strands.normals[vertex].length() - 1.0).abs() < 1.0e-3);
                let sum: f32 = strands.weights[vertex].iter().sum();
                assert!((sum - 1.0).abs() < 1.0e-4, "weights {vertex}");
            }
        }
    }
}
