//! Bodies of strangers: shells over a built one, and worse.

use std::collections::BTreeMap;

use glam::{Vec2, Vec3};
use lole_body::{Bone, Dancer, Figure, Look, MeshPart, PartKind, SkinnedMesh};
use lole_costume::document::{DancerDesign, Design};
use lole_geom::Chance;
use lole_geom::mesh::vertex_normals;

use crate::{StageError, production};

/// Draws a body, and writes its tape into the design.
pub(super) fn draw(
    chance: &mut Chance,
    design: &mut Design,
) -> Result<(Dancer, String), StageError> {
    let (mut dancer, name) = built(chance, design)?;
    let mut words = vec![name];
    if chance.falls(0.2) {
        return Ok((dancer, words.concat()));
    }
    let mut sculptor = Sculptor::new(&dancer);
    if chance.falls(0.12) {
        sculptor.boxes(chance);
        words.push("boxes".to_owned());
    } else {
        for (probability, word, act) in ODDITIES {
            if chance.falls(*probability) {
                act(&mut sculptor, chance);
                words.push((*word).to_owned());
            }
        }
    }
    let skeleton = dancer.skeleton.clone();
    match Dancer::of_skin(skeleton, sculptor.finish()) {
        Ok(given) => dancer = given,
        // No tape finds its way around this one: she comes as she was.
        Err(_) => words.push("(unmeasurable)".to_owned()),
    }
    Ok((dancer, words.join(", ")))
}

fn built(chance: &mut Chance, design: &mut Design) -> Result<(Dancer, String), StageError> {
    let figures = [Figure::Child, Figure::Woman, Figure::Woman, Figure::Man];
    let figure = chance.choose(&figures).copied().unwrap_or_default();
    let (low, high, name) = match figure {
        Figure::Child => (104.0, 140.0, "child"),
        Figure::Man => (160.0, 190.0, "man"),
        _ => (146.0, 178.0, "woman"),
    };
    let stature = chance.between(low, high);
    let ease = chance.between(-1.0, 1.0);
    let mut tape = DancerDesign {
        figure,
        stature_cm: Some(f64::from(stature)),
        ..DancerDesign::default()
    };
    if figure == Figure::Woman {
        let girths = [0.545, 0.435, 0.585].map(|share| stature * share * (1.0 + 0.13 * ease));
        [tape.bust_cm, tape.waist_cm, tape.hip_cm] = girths.map(|girth| Some(f64::from(girth)));
    }
    design.dancer = tape;
    let (dancer, _) = match production::dancer(design) {
        Ok(built) => built,
        Err(_) => {
            let stature_cm = design.dancer.stature_cm;
            design.dancer = DancerDesign {
                figure,
                stature_cm,
                ..DancerDesign::default()
            };
            production::dancer(design)?
        }
    };
    Ok((dancer, format!("{name} of {stature:.0} cm")))
}

type Oddity = (f32, &'static str, fn(&mut Sculptor<'_>, &mut Chance));

/// What may be odd about a body, with how often it is.
const ODDITIES: &[Oddity] = &[
    (0.25, "thin limbs", |it, chance| {
        let factor = chance.between(0.5, 0.85);
        it.scale_limbs(factor);
    }),
    (0.25, "big head", |it, chance| {
        let factor = chance.between(1.3, 2.2);
        it.scale_head(factor);
    }),
    (0.45, "trousers", |it, chance| {
        let [above, below] = [chance.between(0.002, 0.005), chance.between(0.008, 0.03)];
        it.shell(LEGS, [above, below]);
    }),
    (0.5, "shoes", |it, chance| {
        let thick = chance.between(0.006, 0.02);
        it.shell(FEET, [thick, 1.6 * thick]);
    }),
    (0.25, "boots", |it, chance| {
        let thick = chance.between(0.008, 0.03);
        it.shell(SHANKS, [1.4 * thick, thick]);
    }),
    (0.3, "coat", |it, chance| {
        let [above, below] = [chance.between(0.003, 0.008), chance.between(0.004, 0.012)];
        it.shell(TRUNK, [above, below]);
    }),
    (0.3, "wide sleeves", |it, chance| {
        let [above, below] = [chance.between(0.005, 0.015), chance.between(0.03, 0.08)];
        it.shell(ARMS, [above, below]);
    }),
    (0.2, "a skirt of her own", |it, chance| {
        let flare = chance.between(0.02, 0.12);
        let length = chance.between(0.12, 0.4);
        it.cone(length, flare);
    }),
    (0.2, "inner faces", |it, _| it.turn_inside_out()),
    (0.2, "a second skin", |it, chance| {
        let off = chance.between(-0.006, 0.006);
        it.double(off);
    }),
    (0.2, "holes", |it, chance| {
        for _ in 0..3 {
            let size = chance.between(0.02, 0.06);
            let at = chance.share();
            it.tear(at, size);
        }
    }),
];

const LEGS: &[Bone] = &[
    Bone::Hips,
    Bone::LeftUpperLeg,
    Bone::RightUpperLeg,
    Bone::LeftLowerLeg,
    Bone::RightLowerLeg,
];
const FEET: &[Bone] = &[
    Bone::LeftFoot,
    Bone::RightFoot,
    Bone::LeftToes,
    Bone::RightToes,
];
const SHANKS: &[Bone] = &[
    Bone::LeftLowerLeg,
    Bone::RightLowerLeg,
    Bone::LeftFoot,
    Bone::RightFoot,
    Bone::LeftToes,
    Bone::RightToes,
];
const TRUNK: &[Bone] = &[
    Bone::Hips,
    Bone::Spine,
    Bone::Chest,
    Bone::UpperChest,
    Bone::LeftShoulder,
    Bone::RightShoulder,
    Bone::LeftUpperArm,
    Bone::RightUpperArm,
    Bone::LeftUpperLeg,
    Bone::RightUpperLeg,
];
const ARMS: &[Bone] = &[
    Bone::LeftUpperArm,
    Bone::RightUpperArm,
    Bone::LeftLowerArm,
    Bone::RightLowerArm,
];

/// A skin while it is being changed.
struct Sculptor<'a> {
    dancer: &'a Dancer,
    positions: Vec<Vec3>,
    joints: Vec<[u16; 4]>,
    weights: Vec<[f32; 4]>,
    /// All that cloth meets.
    triangles: Vec<[u32; 3]>,
    /// How many of them are the body's own, which come first.
    own_count: usize,
}

impl<'a> Sculptor<'a> {
    fn new(dancer: &'a Dancer) -> Self {
        let skin = &dancer.skin;
        let triangles = skin.body_triangles();
        Self {
            dancer,
            positions: skin.positions.clone(),
            joints: skin.joints.clone(),
            weights: skin.weights.clone(),
            own_count: triangles.len(),
            triangles,
        }
    }

    /// The bone that carries most of a vertex.
    fn bone(&self, vertex: u32) -> Bone {
        let vertex = vertex as usize;
        Bone::strongest(self.joints[vertex], self.weights[vertex])
    }

    fn normals(&self) -> Vec<Vec3> {
        vertex_normals(&self.positions, &self.triangles[..self.own_count])
    }

    /// Thins legs and arms about their bones.
    fn scale_limbs(&mut self, factor: f32) {
        let skeleton = &self.dancer.skeleton;
        let limbs = Bone::LEGS.iter().chain(&Bone::ARMS);
        let axes: BTreeMap<Bone, [Vec3; 2]> = limbs
            .flat_map(|limb| limb.windows(2))
            .map(|pair| (pair[0], [skeleton.joint(pair[0]), skeleton.joint(pair[1])]))
            .collect();
        for vertex in 0..self.positions.len() {
            let bone = self.bone(u32::try_from(vertex).unwrap_or(0));
            let is_root = matches!(bone, Bone::LeftShoulder | Bone::RightShoulder);
            let Some([start, end]) = axes.get(&bone).filter(|_| !is_root) else {
                continue;
            };
            let along = (*end - *start).normalize_or_zero();
            let off = self.positions[vertex] - *start;
            let foot = *start + along * off.dot(along);
            // The root of a limb keeps its width.
            let down = (off.dot(along) / start.distance(*end)).clamp(0.0, 1.0);
            let is_upper = matches!(
                bone,
                Bone::LeftUpperLeg | Bone::RightUpperLeg | Bone::LeftUpperArm | Bone::RightUpperArm
            );
            let share = if is_upper { down } else { 1.0 };
            let scale = 1.0 + (factor - 1.0) * share;
            self.positions[vertex] = foot + (self.positions[vertex] - foot) * scale;
        }
    }

    fn scale_head(&mut self, factor: f32) {
        let neck = self.dancer.skeleton.joint(Bone::Head);
        for vertex in 0..self.positions.len() {
            if self.bone(u32::try_from(vertex).unwrap_or(0)) == Bone::Head {
                self.positions[vertex] = neck + (self.positions[vertex] - neck) * factor;
            }
        }
    }

    /// A closed shell over the skin that some bones carry, so thick at its upper and its lower end [m]:
    /// an outer face, an inner one that faces the body, and the rims between them.
    fn shell(&mut self, bones: &[Bone], thick: [f32; 2]) {
        let normals = self.normals();
        let over: Vec<[u32; 3]> = self.triangles[..self.own_count]
            .iter()
            .copied()
            .filter(|triangle| triangle.iter().all(|&v| bones.contains(&self.bone(v))))
            .collect();
        let heights = || over.iter().flatten().map(|&v| self.positions[v as usize].y);
        let [low, high] = [
            heights().fold(f32::INFINITY, f32::min),
            heights().fold(f32::NEG_INFINITY, f32::max),
        ];
        let mut copies: BTreeMap<u32, [u32; 2]> = BTreeMap::new();
        for &vertex in over.iter().flatten() {
            if copies.contains_key(&vertex) {
                continue;
            }
            let place = self.positions[vertex as usize];
            let down = ((high - place.y) / (high - low).max(1.0e-3)).clamp(0.0, 1.0);
            let outer = thick[0] + (thick[1] - thick[0]) * down;
            let normal = normals[vertex as usize];
            let pair = [outer, 0.4 * outer].map(|off| self.copy(vertex, place + normal * off));
            copies.insert(vertex, pair);
        }
        let mut border: BTreeMap<[u32; 2], i32> = BTreeMap::new();
        for &[a, b, c] in &over {
            let [outer, inner] = [0, 1].map(|side| [a, b, c].map(|v| copies[&v][side]));
            self.triangles.push(outer);
            self.triangles.push([inner[0], inner[2], inner[1]]);
            for edge in [[a, b], [b, c], [c, a]] {
                *border.entry(edge).or_default() += 1;
            }
        }
        for &[a, b] in border.keys() {
            if !border.contains_key(&[b, a]) {
                let [from, to] = [copies[&a], copies[&b]];
                self.triangles.push([from[0], from[1], to[1]]);
                self.triangles.push([from[0], to[1], to[0]]);
            }
        }
    }

    /// A copy of a vertex that is elsewhere.
    fn copy(&mut self, vertex: u32, place: Vec3) -> u32 {
        let source = vertex as usize;
        self.positions.push(place);
        self.joints.push(self.joints[source]);
        self.weights.push(self.weights[source]);
        u32::try_from(self.positions.len() - 1).unwrap_or(u32::MAX)
    }

    fn carried(&mut self, place: Vec3, bone: Bone) -> u32 {
        self.positions.push(place);
        self.joints
            .push([u16::try_from(bone.index()).unwrap_or(0), 0, 0, 0]);
        self.weights.push([1.0, 0.0, 0.0, 0.0]);
        u32::try_from(self.positions.len() - 1).unwrap_or(u32::MAX)
    }

    /// A stiff skirt carried by the hips: so long, and so much wider below [m], seen from both sides.
    fn cone(&mut self, length: f32, flare: f32) {
        const AROUND: u32 = 48;
        let top = self.dancer.landmarks.high_hip_height;
        let ring = self.dancer.tape_ring(top, AROUND as usize);
        let bind = self
            .dancer
            .skeleton
            .world_from_bind(&lole_body::Pose::default());
        let axis = self.dancer.skeleton.joint(Bone::Hips);
        let rows: Vec<Vec<u32>> = [0.0_f32, 0.5, 1.0]
            .into_iter()
            .map(|down| {
                let places = ring.iter().map(|point| {
                    let place = point.posed(&bind);
                    let out = (place - axis).with_y(0.0).normalize_or_zero();
                    place + out * (0.008 + flare * down) - Vec3::Y * (length * down)
                });
                let places: Vec<Vec3> = places.collect();
                places
                    .into_iter()
                    .map(|place| self.carried(place, Bone::Hips))
                    .collect()
            })
            .collect();
        for pair in rows.windows(2) {
            for column in 0..pair[0].len() {
                let next = (column + 1) % pair[0].len();
                let [a, b, c, d] = [
                    pair[0][column],
                    pair[0][next],
                    pair[1][column],
                    pair[1][next],
                ];
                // Clockwise seen from above: the outer face first.
                self.triangles
                    .extend([[a, b, c], [b, d, c], [a, c, b], [b, c, d]]);
            }
        }
    }

    /// Faces that look into the body, under its skin.
    fn turn_inside_out(&mut self) {
        let normals = self.normals();
        let own: Vec<[u32; 3]> = self.triangles[..self.own_count].to_vec();
        let mut copies = BTreeMap::new();
        for &vertex in own.iter().flatten() {
            let place = self.positions[vertex as usize] - normals[vertex as usize] * 0.003;
            copies.entry(vertex).or_insert(place);
        }
        let copies: BTreeMap<u32, u32> = (copies.into_iter())
            .map(|(vertex, place)| (vertex, self.copy(vertex, place)))
            .collect();
        self.triangles.extend(
            own.iter()
                .map(|&[a, b, c]| [copies[&a], copies[&c], copies[&b]]),
        );
    }

    /// The whole skin once more, so far outside [m], carried by the strongest bone of each vertex alone:
    /// it goes through the first one wherever she bends.
    fn double(&mut self, off: f32) {
        let normals = self.normals();
        let own: Vec<[u32; 3]> = self.triangles[..self.own_count].to_vec();
        let mut copies: BTreeMap<u32, u32> = BTreeMap::new();
        for &vertex in own.iter().flatten() {
            if copies.contains_key(&vertex) {
                continue;
            }
            let place = self.positions[vertex as usize] + normals[vertex as usize] * off;
            let bone = self.bone(vertex);
            copies.insert(vertex, self.carried(place, bone));
        }
        self.triangles.extend(
            own.iter()
                .map(|triangle| triangle.map(|vertex| copies[&vertex])),
        );
    }

    /// Takes away what is within a distance [m] of some place of the skin below the waist.
    fn tear(&mut self, at: f32, size: f32) {
        let waist = self.dancer.landmarks.waist_height;
        let below: Vec<Vec3> = (self.triangles.iter())
            .map(|&[a, ..]| self.positions[a as usize])
            .filter(|place| place.y < waist)
            .collect();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a share of some thousands of triangles"
        )]
        let place = (at * below.len() as f32) as usize;
        let Some(&middle) = below.get(place) else {
            return;
        };
        let positions = &self.positions;
        let stays = |triangle: &[u32; 3]| {
            let mut corners = triangle.iter();
            corners.all(|&v| size < positions[v as usize].distance(middle))
        };
        let own = self.triangles[..self.own_count]
            .iter()
            .filter(|it| stays(it))
            .count();
        self.triangles.retain(stays);
        self.own_count = own;
    }

    /// A doll of boxes, one for each large bone.
    fn boxes(&mut self, chance: &mut Chance) {
        let wide = chance.between(0.8, 1.25);
        let mut bounds: BTreeMap<Bone, [Vec3; 2]> = BTreeMap::new();
        let own: Vec<[u32; 3]> = self.triangles[..self.own_count].to_vec();
        for &vertex in own.iter().flatten() {
            let place = self.positions[vertex as usize];
            let bound = bounds.entry(large(self.bone(vertex))).or_insert([place; 2]);
            *bound = [bound[0].min(place), bound[1].max(place)];
        }
        self.triangles.clear();
        for (bone, [low, high]) in bounds {
            let middle = (low + high) * 0.5;
            let half = (high - low) * 0.5 * Vec3::new(0.9 * wide, 1.0, 0.9 * wide);
            self.block(bone, middle - half, middle + half);
        }
        self.own_count = self.triangles.len();
    }

    /// A box whose faces are cut into smaller squares.
    fn block(&mut self, bone: Bone, low: Vec3, high: Vec3) {
        const PARTS: u8 = 3;
        let mut corners: BTreeMap<[u8; 3], u32> = BTreeMap::new();
        let faces = (0..3).flat_map(|axis| [(axis, 0), (axis, PARTS)]);
        let squares = faces.flat_map(|face| {
            (0..PARTS * PARTS).map(move |place| (face, [place / PARTS, place % PARTS]))
        });
        for ((axis, side), [one, other]) in squares {
            let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
            let square = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[i, j]| {
                let mut key = [0; 3];
                (key[axis], key[u], key[v]) = (side, one + i, other + j);
                *corners.entry(key).or_insert_with(|| {
                    let share = Vec3::from_array(key.map(f32::from)) / f32::from(PARTS);
                    self.carried(low + (high - low) * share, bone)
                })
            });
            let [a, b, c, d] = square;
            self.triangles.extend(if side == 0 {
                [[a, c, b], [a, d, c]]
            } else {
                [[a, b, c], [a, c, d]]
            });
        }
    }

    /// The skin as a given one.
    fn finish(self) -> SkinnedMesh {
        let normals = vertex_normals(&self.positions, &self.triangles);
        SkinnedMesh {
            uvs: vec![Vec2::ZERO; self.positions.len()],
            normals,
            joints: self.joints,
            weights: self.weights,
            parts: vec![MeshPart {
                kind: PartKind::Given,
                triangles: self.triangles.clone(),
            }],
            looks: vec![Look {
                name: String::new(),
                base_color: [0.5, 0.42, 0.36],
                picture: None,
                roughness: 0.8,
                is_two_sided: true,
            }],
            surface: self.triangles,
            positions: self.positions,
            ..SkinnedMesh::default()
        }
    }
}

/// The bone whose box stands for what a smaller one carries.
fn large(bone: Bone) -> Bone {
    match bone {
        Bone::Spine => Bone::Hips,
        Bone::Chest | Bone::LeftShoulder | Bone::RightShoulder | Bone::Neck => Bone::UpperChest,
        Bone::LeftToes => Bone::LeftFoot,
        Bone::RightToes => Bone::RightFoot,
        bone => {
            let hands = [Bone::LeftHand, Bone::RightHand];
            let found = bone.lineage().find(|above| hands.contains(above));
            found.unwrap_or(bone)
        }
    }
}
