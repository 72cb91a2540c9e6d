//! Bent knees and elbows keep their flesh: the volume of the limb's piece about the joint.
//!
//! The piece lies between two planes across the limb, each fixed to its bone one diameter of the limb
//! from the joint. It is cut out of the bind pose, carried by the skin and closed with two caps. What
//! counts is the space that it fills: where a crease folds into itself, flesh counts once.

#![expect(clippy::unwrap_used, reason = "a test of the default dancers")]

use std::collections::BTreeMap;

use glam::{DVec3, Quat, Vec3};
use lole_body::{Bone, Dancer, Figure, Measurements, Pose, Tape};
use lole_geom::{Length, trig};

/// Part of the volume that may be lost or won. Knees stay within 0.025, elbows within 0.055 up to 90°.
const MOST_LOST: f64 = 0.06;
/// Width of the rays' grid [m].
const RAY: f64 = 0.001;

fn dancer(tape: &Tape) -> Dancer {
    Dancer::new(&Measurements::from_tape(tape).unwrap()).unwrap()
}

/// A hinge: its bone, the bone above and the joint below it.
struct Hinge {
    above: Bone,
    bone: Bone,
    end: Bone,
    /// Where it bends to.
    inward: Vec3,
    /// Diameter of the limb there [statures].
    diameter: f32,
}

const KNEE: Hinge = Hinge {
    above: Bone::LeftUpperLeg,
    bone: Bone::LeftLowerLeg,
    end: Bone::LeftFoot,
    inward: Vec3::NEG_Z,
    diameter: 0.068,
};
const ELBOW: Hinge = Hinge {
    above: Bone::LeftUpperArm,
    bone: Bone::LeftLowerArm,
    end: Bone::LeftHand,
    inward: Vec3::Z,
    diameter: 0.048,
};

/// A point between two vertices of the skin.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Between {
    ends: [u32; 2],
    /// Bits of the share of the second, which is not negative.
    share: u32,
}

impl Between {
    fn at(self, positions: &[Vec3]) -> Vec3 {
        let [a, b] = self.ends.map(|end| positions[end as usize]);
        a.lerp(b, f32::from_bits(self.share))
    }
}

/// A piece of a limb: closed but for the caps.
struct Piece {
    triangles: Vec<[Between; 3]>,
    /// Open edges of either cut.
    rims: [Vec<[Between; 2]>; 2],
}

impl Hinge {
    /// Unit directions down the bone above and down the bone itself, in the bind pose.
    fn directions(&self, dancer: &Dancer) -> [Vec3; 2] {
        let at = |bone| dancer.skeleton.joint(bone);
        [
            (at(self.bone) - at(self.above)).normalize_or_zero(),
            (at(self.end) - at(self.bone)).normalize_or_zero(),
        ]
    }

    /// Turns the bone until it makes `degrees` with the one above.
    fn bent(&self, dancer: &Dancer, degrees: f32) -> Pose {
        let [above, below] = self.directions(dancer);
        let side = (self.inward - above * self.inward.dot(above)).normalize_or_zero();
        let (sin, cos) = trig::sin_cos(degrees.to_radians());
        let wanted = above * cos + side * sin;
        let mut pose = Pose::default();
        pose.rotate(self.bone, Quat::from_rotation_arc(below, wanted));
        pose
    }

    /// The piece between the two planes, cut out of the bind pose.
    fn piece(&self, dancer: &Dancer) -> Piece {
        let bind = &dancer.skin.positions;
        let joint = dancer.skeleton.joint(self.bone);
        let [above, below] = self.directions(dancer);
        let reach = self.diameter * dancer.landmarks.crown_height;
        let heights = [
            |p: Vec3, [joint, above, _]: [Vec3; 3], reach: f32| (p - joint).dot(above) + reach,
            |p: Vec3, [joint, _, below]: [Vec3; 3], reach: f32| reach - (p - joint).dot(below),
        ]
        .map(|height| move |p: Vec3| height(p, [joint, above, below], reach));
        let is_near = |triangle: &[u32; 3]| {
            triangle.iter().all(|&vertex| {
                let place = bind[vertex as usize];
                place.x > 0.0 && place.distance(joint) < 2.0 * reach
            })
        };
        let mut triangles = Vec::new();
        for triangle in dancer.skin.body_triangles().iter().filter(|t| is_near(t)) {
            let mut corners = triangle
                .map(|vertex| Between {
                    ends: [vertex; 2],
                    share: 0,
                })
                .to_vec();
            for height in &heights {
                corners = clipped(&corners, bind, height);
            }
            for last in 2..corners.len() {
                triangles.push([corners[0], corners[last - 1], corners[last]]);
            }
        }
        let mut open = BTreeMap::new();
        for [a, b, c] in &triangles {
            for edge in [[*a, *b], [*b, *c], [*c, *a]] {
                if open.remove(&[edge[1], edge[0]]).is_none() {
                    open.insert(edge, ());
                }
            }
        }
        let mut rims = [Vec::new(), Vec::new()];
        for edge in open.into_keys() {
            let is_below = (edge[0].at(bind) - joint).dot(above) > 0.0;
            rims[usize::from(is_below)].push(edge);
        }
        Piece { triangles, rims }
    }
}

/// A convex polygon's part on the positive side of a plane.
fn clipped(corners: &[Between], bind: &[Vec3], height: impl Fn(Vec3) -> f32) -> Vec<Between> {
    let mut kept = Vec::new();
    for (index, &corner) in corners.iter().enumerate() {
        let next = corners[(index + 1) % corners.len()];
        let [here, there] = [corner, next].map(|c| height(c.at(bind)));
        if here >= 0.0 {
            kept.push(corner);
        }
        // A cut of a cut cannot be: the planes are far apart, and triangles are small.
        if (here < 0.0) != (there < 0.0) && corner.share == 0 && next.share == 0 {
            let (mut ends, mut sides) = ([corner.ends[0], next.ends[0]], [here, there]);
            if ends[0] > ends[1] {
                (ends, sides) = ([ends[1], ends[0]], [there, here]);
            }
            let share = (sides[0] / (sides[0] - sides[1])).max(f32::MIN_POSITIVE);
            kept.push(Between {
                ends,
                share: share.to_bits(),
            });
        }
    }
    kept
}

impl Piece {
    /// Its closed surface in a pose [m].
    fn posed(&self, dancer: &Dancer, pose: &Pose) -> Vec<[DVec3; 3]> {
        let (mut positions, mut normals) = (Vec::new(), Vec::new());
        let world = dancer.skeleton.world_from_bind(pose);
        dancer.skin.pose(&world, &mut positions, &mut normals);
        let at = |point: &Between| point.at(&positions).as_dvec3();
        let mut surface: Vec<[DVec3; 3]> = self
            .triangles
            .iter()
            .map(|t| t.each_ref().map(at))
            .collect();
        for rim in &self.rims {
            let center = rim.iter().map(|[a, _]| at(a)).sum::<DVec3>() / rim.len() as f64;
            surface.extend(rim.iter().map(|[a, b]| [at(b), at(a), center]));
        }
        surface
    }
}

/// Space inside a closed surface [m³], once where it lies in itself: along a grid of rays.
fn filled(surface: &[[DVec3; 3]]) -> f64 {
    let mut hits: BTreeMap<[i64; 2], Vec<(f64, i32)>> = BTreeMap::new();
    for corners in surface {
        let [a, b, c] = corners.map(|corner| corner / RAY - DVec3::new(0.0, 0.371, 0.617));
        let cross = |u: DVec3, v: DVec3| u.y * v.z - u.z * v.y;
        let area = cross(b - a, c - a);
        if area == 0.0 {
            continue;
        }
        #[expect(
            clippy::cast_possible_truncation,
            reason = "a body is a few thousand rays wide"
        )]
        let [low, high] = [a.min(b).min(c).ceil(), a.max(b).max(c).floor()]
            .map(|end| [end.y as i64, end.z as i64]);
        for (y, z) in (low[0]..=high[0]).flat_map(|y| (low[1]..=high[1]).map(move |z| (y, z))) {
            let ray = DVec3::new(0.0, y as f64, z as f64);
            let shares = [
                cross(b - ray, c - ray),
                cross(c - ray, a - ray),
                cross(a - ray, b - ray),
            ]
            .map(|share| share / area);
            if shares.iter().all(|&share| share >= 0.0) {
                let x = shares[0] * a.x + shares[1] * b.x + shares[2] * c.x;
                hits.entry([y, z])
                    .or_default()
                    .push((x, if area > 0.0 { -1 } else { 1 }));
            }
        }
    }
    let mut length = 0.0;
    for ray in hits.values_mut() {
        ray.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut inside = 0;
        for pair in ray.windows(2) {
            inside += pair[0].1;
            if inside > 0 {
                length += pair[1].0 - pair[0].0;
            }
        }
    }
    length * RAY * RAY * RAY
}

/// Who is bent.
fn tapes() -> [(&'static str, Tape); 4] {
    let of = |figure| Tape {
        figure,
        ..Tape::default()
    };
    let small = Tape {
        stature: Some(Length::from_cm(100.0)),
        ..of(Figure::Child)
    };
    [
        ("woman", of(Figure::Woman)),
        ("man", of(Figure::Man)),
        ("child", of(Figure::Child)),
        ("small child", small),
    ]
}

#[test]
fn bent_knees_and_elbows_keep_their_flesh() {
    let mut lost = Vec::new();
    for (who, tape) in tapes() {
        let dancer = dancer(&tape);
        for (name, hinge) in [("knee", KNEE), ("elbow", ELBOW)] {
            let piece = hinge.piece(&dancer);
            let volume = |degrees| filled(&piece.posed(&dancer, &hinge.bent(&dancer, degrees)));
            let straight = volume(0.0);
            for degrees in [45.0, 75.0, 90.0, 110.0] {
                let kept = volume(degrees) / straight;
                if (kept - 1.0).abs() > MOST_LOST {
                    lost.push(format!("{who}'s {name} at {degrees}°: {kept:.3}"));
                }
            }
        }
    }
    assert!(lost.is_empty(), "{lost:#?}");
}

/// The measure itself: a cube, and the same beside it once more, half inside.
#[test]
fn flesh_counts_once() {
    let cube = |shift: f64| {
        let corner = move |i: usize| {
            let bit = |n: usize| if i >> n & 1 == 1 { 0.02 } else { 0.0 };
            DVec3::new(bit(0) + shift, bit(1), bit(2))
        };
        let sides = [
            [0, 2, 3, 1],
            [4, 5, 7, 6],
            [0, 1, 5, 4],
            [2, 6, 7, 3],
            [0, 4, 6, 2],
            [1, 3, 7, 5],
        ];
        sides.into_iter().flat_map(move |[a, b, c, d]| {
            [[a, b, c], [a, c, d]].map(|side: [usize; 3]| side.map(corner))
        })
    };
    let one: Vec<_> = cube(0.0).collect();
    assert!(
        (filled(&one) / 8.0e-6 - 1.0).abs() < 0.01,
        "{}",
        filled(&one)
    );
    let two: Vec<_> = cube(0.0).chain(cube(0.01)).collect();
    assert!(
        (filled(&two) / 12.0e-6 - 1.0).abs() < 0.01,
        "{}",
        filled(&two)
    );
}
