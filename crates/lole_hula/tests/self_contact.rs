//! The posed body does not go through itself: triangle against triangle, over the whole repertoire.
//!
//! A crease may fold: two triangles that one bone carries, or two bones that meet in a joint, may
//! cross where they lie near each other in the bind pose ([`CREASE`]), but not deeply
//! ([`CREASE_DEPTH`]); so may the webs between fingers. Nothing else may.

#![expect(clippy::unwrap_used, reason = "a test of the default dancers")]

use glam::{DVec3, IVec3, Vec3};
use lole_body::{Bone, Dancer, Figure, Measurements, Tape};
use lole_geom::Length;
use lole_hula::{ArmStyle, Dance, DanceStep, MotionSettings};
use rayon::prelude::*;

/// Poses a count at which a step is looked at.
const SAMPLES_PER_COUNT: u16 = 2;
/// How far apart the triangles of a crease lie in the bind pose, at most [statures]: upper arm and
/// forearm of a bent arm meet this far from the elbow.
const CREASE: f32 = 0.085;
/// How far apart the triangles of a crease lie in the bind pose of a small child, at most [statures]:
/// her arm is thick for her stature.
const CREASE_OF_SMALL_CHILD: f32 = 0.09;
/// How far apart the triangles of the webs between fingers lie in the bind pose, at most [statures].
const WEB: f32 = 0.01;
/// How deep flesh is pressed in a crease, at most [statures]: 15 mm in the elbow of a man.
const CREASE_DEPTH: f32 = 0.01;
/// Cells of the grid are this wide [m]: about as wide as triangles.
const CELL: f32 = 0.012;

/// A dancer's body, with the bone that carries each triangle most.
struct Body {
    dancer: Dancer,
    triangles: Vec<[u32; 3]>,
    bones: Vec<Bone>,
    /// How far apart the triangles of its creases may lie in the bind pose [statures].
    crease: f32,
}

impl Body {
    fn new(tape: &Tape, crease: f32) -> Self {
        let dancer = Dancer::new(&Measurements::from_tape(tape).unwrap()).unwrap();
        let triangles = dancer.skin.body_triangles();
        let carrier = |triangle: &[u32; 3]| {
            let mut shares = [0.0_f32; Bone::COUNT];
            for vertex in triangle.map(|vertex| vertex as usize) {
                let skin = &dancer.skin;
                for (&joint, weight) in skin.joints[vertex].iter().zip(skin.weights[vertex]) {
                    shares[usize::from(joint)] += weight;
                }
            }
            let most = (0..Bone::COUNT).max_by(|&a, &b| shares[a].total_cmp(&shares[b]));
            Bone::ALL[most.unwrap()]
        };
        let bones = triangles.iter().map(carrier).collect();
        Self {
            dancer,
            triangles,
            bones,
            crease,
        }
    }

    /// Whether a pair lies in the crease of a joint.
    fn is_crease(&self, pair: [usize; 2]) -> bool {
        let bind = &self.dancer.skin.positions;
        let [one, other] = pair.map(|index| {
            let corners = self.triangles[index].map(|vertex| bind[vertex as usize]);
            corners.iter().sum::<Vec3>() / 3.0
        });
        let apart = one.distance(other) / self.dancer.landmarks.crown_height;
        let [a, b] = pair.map(|index| self.bones[index]);
        let meet = a == b || a.parent() == Some(b) || b.parent() == Some(a);
        let are_fingers = a.parent() == b.parent() && a.parent() != Some(Bone::Hips);
        (meet && apart < self.crease) || (are_fingers && apart < WEB)
    }

    /// What is wrong with one moment of a dance.
    fn fault(&self, dance: &Dance, time: f32) -> Option<String> {
        let (mut positions, mut normals) = (Vec::new(), Vec::new());
        let world = (self.dancer.skeleton).world_from_bind(&dance.pose_at(time));
        self.dancer.skin.pose(&world, &mut positions, &mut normals);
        crossings(&positions, &self.triangles)
            .into_iter()
            .find_map(|pair| {
                let [a, b] = pair.map(|index| self.triangles[index].map(|v| positions[v as usize]));
                let depth = depth(a, b) / self.dancer.landmarks.crown_height;
                let allowed = self.is_crease(pair) && depth < CREASE_DEPTH;
                let bones = pair.map(|index| self.bones[index]);
                (!allowed).then(|| format!("{bones:?} at {time} s, {depth} statures deep"))
            })
    }
}

/// Pairs of triangles that share no vertex and cross; found cell by cell of a grid.
fn crossings(positions: &[Vec3], triangles: &[[u32; 3]]) -> Vec<[usize; 2]> {
    let mut entries: Vec<([i32; 3], u32)> = Vec::new();
    for (index, triangle) in (0..).zip(triangles) {
        let [a, b, c] = triangle.map(|vertex| positions[vertex as usize]);
        let cell = |point: Vec3| -> IVec3 { (point / CELL).floor().as_ivec3() };
        let (low, high) = (cell(a.min(b).min(c)), cell(a.max(b).max(c)));
        for (x, y) in (low.x..=high.x).flat_map(|x| (low.y..=high.y).map(move |y| (x, y))) {
            entries.extend((low.z..=high.z).map(|z| ([x, y, z], index)));
        }
    }
    entries.sort_unstable();
    let mut found = Vec::new();
    for cell in entries.chunk_by(|a, b| a.0 == b.0) {
        for (index, &(_, first)) in cell.iter().enumerate() {
            let pairs = cell[index + 1..].iter();
            found.extend(
                pairs
                    .map(|&(_, second)| [first as usize, second as usize])
                    .filter(|pair| {
                        let [one, other] = pair.map(|index| triangles[index]);
                        let are_apart = !one.iter().any(|vertex| other.contains(vertex));
                        let corners = |t: [u32; 3]| t.map(|vertex| positions[vertex as usize]);
                        are_apart && cross(corners(one), corners(other))
                    }),
            );
        }
    }
    found.sort_unstable();
    found.dedup();
    found
}

/// Whether an edge of one triangle goes through the other.
fn cross(a: [Vec3; 3], b: [Vec3; 3]) -> bool {
    let low = |t: [Vec3; 3]| t[0].min(t[1]).min(t[2]);
    let high = |t: [Vec3; 3]| t[0].max(t[1]).max(t[2]);
    if low(a).cmpgt(high(b)).any() || low(b).cmpgt(high(a)).any() {
        return false;
    }
    let [a, b] = [a, b].map(|triangle| triangle.map(|point| point.as_dvec3()));
    let through = |edges: [DVec3; 3], face: [DVec3; 3]| {
        (0..3).any(|side| pierces([edges[side], edges[(side + 1) % 3]], face))
    };
    through(a, b) || through(b, a)
}

/// Whether a segment goes through a triangle, by signs of volumes.
fn pierces([p, q]: [DVec3; 2], [a, b, c]: [DVec3; 3]) -> bool {
    let volume = |a: DVec3, b: DVec3, c: DVec3, d: DVec3| (b - a).cross(c - a).dot(d - a);
    if volume(a, b, c, p) * volume(a, b, c, q) >= 0.0 {
        return false;
    }
    let sides = [volume(p, q, a, b), volume(p, q, b, c), volume(p, q, c, a)];
    sides.iter().all(|&side| side > 0.0) || sides.iter().all(|&side| side < 0.0)
}

/// How deep a corner of one triangle lies below the other [m], of those right below it.
fn depth(a: [Vec3; 3], b: [Vec3; 3]) -> f32 {
    let mut deepest = 0.0_f32;
    for (points, [p, q, r]) in [(a, b), (b, a)] {
        let normal = (q - p).cross(r - p).normalize_or_zero();
        for point in points {
            let is_over = |[s, t]: [Vec3; 2]| 0.0 <= (t - s).cross(point - s).dot(normal);
            if [[p, q], [q, r], [r, p]].into_iter().all(is_over) {
                deepest = deepest.max(-(point - p).dot(normal));
            }
        }
    }
    deepest
}

/// Every step with its own arms, and every other manner of arms.
fn dances() -> impl Iterator<Item = MotionSettings> {
    const STYLES: [ArmStyle; 6] = [
        ArmStyle::Open,
        ArmStyle::HandsOnHips,
        ArmStyle::Ready,
        ArmStyle::OpenUp,
        ArmStyle::LowFront,
        ArmStyle::Rounded,
    ];
    let steps = DanceStep::ALL
        .into_iter()
        .map(|step| (step, ArmStyle::OfStep));
    let manners = STYLES.map(|style| (DanceStep::Kao, style));
    steps
        .chain(manners)
        .map(|(dance_step, arms)| MotionSettings {
            dance_step,
            arms,
            ..MotionSettings::default()
        })
}

fn of(figure: Figure) -> Tape {
    Tape {
        figure,
        ..Tape::default()
    }
}

fn assert_apart(tape: &Tape, crease: f32) {
    let body = Body::new(tape, crease);
    let bind = crossings(&body.dancer.skin.positions, &body.triangles);
    assert!(bind.is_empty(), "bind pose: {} pairs", bind.len());
    for settings in dances() {
        let dance = Dance::new(&body.dancer.skeleton, &settings).unwrap();
        let counts = u16::try_from(settings.dance_step.counts()).unwrap();
        let samples = counts * SAMPLES_PER_COUNT;
        let faults: Vec<String> = (0..samples)
            .into_par_iter()
            .filter_map(|sample| {
                let share = f32::from(sample) / f32::from(samples);
                body.fault(&dance, dance.lead_in() + dance.period() * share)
            })
            .collect();
        let step = settings.dance_step;
        assert!(
            faults.is_empty(),
            "{step:?}, {:?}: {faults:?}",
            settings.arms
        );
    }
}

#[test]
fn a_woman_never_goes_through_herself() {
    assert_apart(&of(Figure::Woman), CREASE);
}

#[test]
fn a_man_never_goes_through_himself() {
    assert_apart(&of(Figure::Man), CREASE);
}

#[test]
fn a_child_never_goes_through_herself() {
    assert_apart(&of(Figure::Child), CREASE);
}

#[test]
fn a_child_of_100_cm_never_goes_through_herself() {
    let small = Tape {
        stature: Some(Length::from_cm(100.0)),
        ..of(Figure::Child)
    };
    assert_apart(&small, CREASE_OF_SMALL_CHILD);
}

/// The check itself: two blades that cross, and two that only touch the same box.
#[test]
fn crossing_triangles_are_found() {
    let positions = [
        [0.0, 0.0, 0.0],
        [0.02, 0.0, 0.0],
        [0.0, 0.02, 0.0],
        [0.005, 0.005, -0.01],
        [0.005, 0.005, 0.01],
        [0.005, 0.03, 0.0],
        [0.018, 0.018, 0.0],
        [0.02, 0.02, -0.004],
        [0.019, 0.02, 0.004],
    ]
    .map(Vec3::from_array);
    let triangles = [[0, 1, 2], [3, 4, 5], [6, 7, 8]];
    assert_eq!(crossings(&positions, &triangles), [[0, 1]]);
    let [a, b] = [0, 1].map(|index: usize| triangles[index].map(|v: u32| positions[v as usize]));
    assert!((depth(a, b) - 0.01).abs() < 1.0e-6);
}
