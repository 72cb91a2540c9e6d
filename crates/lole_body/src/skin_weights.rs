//! How far each bone carries each vertex: planes at the joints, smooth blends, then averaging.
//!
//! All on the left half; the mirror image swaps left and right. Widths are for a stature of
//! 158.5 cm and scale with it.

use glam::Vec3;

use crate::Bone;
use crate::sections::{Sections, Tube};
use crate::surface::Shape;
use crate::surface::half::{Neighbors, is_on_plane};
use crate::surface::warp::smooth_step;

/// Weight of every bone, shape `[Bone::COUNT]`.
pub(crate) type Row = [f32; Bone::COUNT];

const AVERAGING_PASSES: usize = 9;

/// Dense weights of the left half, each row summing to 1.
pub(crate) fn half_weights(shape: &Shape) -> Vec<Row> {
    let joints = Joints::new(&shape.body);
    let mut rows: Vec<Row> = (shape.positions.iter().zip(&shape.labels))
        .map(|(&position, &label)| joints.row(position, label))
        .collect();
    let neighbors = Neighbors::new(shape.positions.len(), &shape.triangles);
    for _ in 0..AVERAGING_PASSES {
        average(&mut rows, &neighbors, &shape.positions);
    }
    join_close(&mut rows, &neighbors, &shape.positions);
    ease_armpit(&mut rows, &shape.positions, &joints);
    rows
}

/// Around the armpit, weights become a smooth function of the place alone: averaging over edges
/// leaves steps where triangles are small, and the leotard's armhole, which runs there, would show
/// them as a ragged edge when the arm rises.
fn ease_armpit(rows: &mut [Row], positions: &[Vec3], joints: &Joints<'_>) {
    const REACH: f32 = 0.13;
    const SPREAD: f32 = 0.034;
    const PASSES: usize = 2;
    let k = joints.k;
    let center = Vec3::new(
        joints.body.level("armpit_x"),
        joints.armpit,
        joints.body.level("armpit_z"),
    );
    let share = |point: Vec3| smooth_step(2.0 * (1.0 - point.distance(center) / (REACH * k)));
    let near: Vec<usize> = (0..positions.len())
        .filter(|&vertex| share(positions[vertex]) > 0.0)
        .collect();
    for _ in 0..PASSES {
        let before: Vec<Row> = near.iter().map(|&vertex| rows[vertex]).collect();
        for &vertex in &near {
            let mut sum = [0.0; Bone::COUNT];
            let mut total = 0.0;
            for (&other, row) in near.iter().zip(&before) {
                let apart = positions[vertex].distance(positions[other]) / (SPREAD * k);
                let bell = (1.0 - apart * apart).max(0.0);
                if bell == 0.0 {
                    continue;
                }
                add(&mut sum, &row.map(|weight| weight * bell * bell));
                total += bell * bell;
            }
            let eased = share(positions[vertex]);
            for (weight, sum) in rows[vertex].iter_mut().zip(sum) {
                *weight += (sum / total - *weight) * eased;
            }
        }
    }
}

/// The bone on the other side, or itself in the middle.
pub(crate) fn mirrored_bone(bone: Bone) -> Bone {
    let name = bone.name();
    let other = match (name.strip_prefix("left"), name.strip_prefix("right")) {
        (Some(rest), _) => format!("right{rest}"),
        (_, Some(rest)) => format!("left{rest}"),
        _ => return bone,
    };
    Bone::ALL
        .iter()
        .copied()
        .find(|bone| bone.name() == other)
        .unwrap_or(bone)
}

/// The row of the mirrored vertex.
pub(crate) fn mirrored_row(row: &Row, mirror: &[usize]) -> Row {
    std::array::from_fn(|bone| row[mirror[bone]])
}

/// Index of every bone's mirror image.
pub(crate) fn mirror_table() -> Vec<usize> {
    Bone::ALL
        .iter()
        .map(|&bone| mirrored_bone(bone).index())
        .collect()
}

/// The four largest weights of a row, normalized, largest first.
pub(crate) fn four_largest(row: &Row) -> ([u16; 4], [f32; 4]) {
    let mut order: Vec<usize> = (0..Bone::COUNT).collect();
    order.sort_by(|&a, &b| row[b].total_cmp(&row[a]).then(a.cmp(&b)));
    let mut joints = [0; 4];
    let mut weights = [0.0; 4];
    let sum: f32 = order[..4].iter().map(|&bone| row[bone]).sum();
    for slot in 0..4 {
        if row[order[slot]] > 0.0 {
            joints[slot] = u16::try_from(order[slot]).unwrap_or(0);
            weights[slot] = row[order[slot]] / sum;
        }
    }
    (joints, weights)
}

fn average(rows: &mut [Row], neighbors: &Neighbors, positions: &[Vec3]) {
    let mirror = mirror_table();
    let before = rows.to_vec();
    for (vertex, row) in rows.iter_mut().enumerate() {
        let on_plane = is_on_plane(positions[vertex]);
        let mut sum = [0.0; Bone::COUNT];
        let mut count = 0.0;
        for &other in neighbors.of(vertex) {
            let other = other as usize;
            add(&mut sum, &before[other]);
            count += 1.0;
            if on_plane && !is_on_plane(positions[other]) {
                add(&mut sum, &mirrored_row(&before[other], &mirror));
                count += 1.0;
            }
        }
        if count > 0.0 {
            for (weight, sum) in row.iter_mut().zip(sum) {
                *weight = 0.5 * *weight + 0.5 * sum / count;
            }
        }
    }
}

/// Ends of very short edges, as along cut lines, move together.
fn join_close(rows: &mut [Row], neighbors: &Neighbors, positions: &[Vec3]) {
    const CLOSE: f32 = 0.002;
    const PASSES: usize = 4;
    for _ in 0..PASSES {
        for vertex in 0..positions.len() {
            for &other in neighbors.of(vertex) {
                let other = other as usize;
                let [a, b] = [vertex, other].map(|end| positions[end]);
                if a.distance(b) < CLOSE && is_on_plane(a) == is_on_plane(b) {
                    let mean: Row =
                        std::array::from_fn(|bone| 0.5 * (rows[vertex][bone] + rows[other][bone]));
                    rows[vertex] = mean;
                    rows[other] = mean;
                }
            }
        }
    }
}

fn add(sum: &mut Row, row: &Row) {
    for (sum, weight) in sum.iter_mut().zip(row) {
        *sum += weight;
    }
}

/// Rises from 0 to 1 over `width`, beginning `before` the plane through `joint` across `normal`.
fn past(position: Vec3, joint: Vec3, normal: Vec3, [before, width]: [f32; 2]) -> f32 {
    smooth_step(((position - joint).dot(normal.normalize_or_zero()) + before) / width)
}

/// Bisector of two directions: the normal of a joint's plane.
fn bisector(from: Vec3, joint: Vec3, to: Vec3) -> Vec3 {
    (joint - from).normalize_or_zero() + (to - joint).normalize_or_zero()
}

/// Joints and levels the planes are made of.
struct Joints<'a> {
    body: &'a Sections,
    /// Stature over that of the body the widths were made for.
    k: f32,
    armpit: f32,
    crotch: f32,
}

impl<'a> Joints<'a> {
    fn new(body: &'a Sections) -> Self {
        Self {
            body,
            k: body.height / 1.585,
            armpit: body.level("armpit"),
            crotch: body.level("crotch"),
        }
    }

    fn joint(&self, bone: Bone) -> Vec3 {
        self.body.joint(bone.name())
    }

    fn row(&self, position: Vec3, label: Tube) -> Row {
        let mut row = [0.0; Bone::COUNT];
        let neck = self.neck_share(position);
        self.fill_arm(&mut row, position, label, neck);
        if !label.is_arm() {
            self.fill_leg(&mut row, position);
        }
        let limbs: f32 = row.iter().sum();
        self.fill_trunk(&mut row, position, (1.0 - limbs).max(0.0));
        let sum: f32 = row.iter().sum();
        row.map(|weight| weight / sum)
    }

    fn neck_share(&self, position: Vec3) -> f32 {
        let k = self.k;
        if position.x.abs() > 0.13 * k {
            return 0.0;
        }
        let (neck, head) = (self.joint(Bone::Neck), self.joint(Bone::Head));
        past(position, neck, head - neck, [0.02 * k, 0.05 * k])
    }

    fn fill_trunk(&self, row: &mut Row, position: Vec3, share: f32) {
        let k = self.k;
        let y = |bone: Bone| self.joint(bone).y;
        let above = |level: f32| smooth_step((position.y - level + 0.05 * k) / (0.1 * k));
        let neck = self.neck_share(position);
        let (neck_joint, head_joint) = (self.joint(Bone::Neck), self.joint(Bone::Head));
        let along = (head_joint - neck_joint).normalize_or_zero();
        let skull = head_joint - Vec3::Z * (0.01 * k);
        let chin_to_nape = along * 0.8 + Vec3::new(0.0, 0.2, -0.45);
        let head = past(position, skull, chin_to_nape, [0.015 * k, 0.035 * k]);
        let chain = [
            (Bone::Hips, above(y(Bone::Spine) - 0.04 * k)),
            (Bone::Spine, above(y(Bone::Chest))),
            (Bone::Chest, above(y(Bone::UpperChest) - 0.02 * k)),
            (Bone::UpperChest, neck),
            (Bone::Neck, if neck > 0.0 { head } else { 0.0 }),
            (Bone::Head, 0.0),
        ];
        let mut left = share;
        for (bone, next) in chain {
            row[bone.index()] += left * (1.0 - next);
            left *= next;
        }
    }

    fn fill_arm(&self, row: &mut Row, position: Vec3, label: Tube, neck: f32) {
        let k = self.k;
        let [shoulder, upper, lower, hand, knuckle] = [
            Bone::LeftShoulder,
            Bone::LeftUpperArm,
            Bone::LeftLowerArm,
            Bone::LeftHand,
            Bone::LeftMiddleProximal,
        ]
        .map(|bone| self.joint(bone));
        let is_arm = label.is_arm();
        let mut girdle = 0.8
            * smooth_step((position.x - shoulder.x) / (0.09 * k))
            * smooth_step((position.y - upper.y + 0.09 * k) / (0.10 * k));
        if is_arm && position.x > upper.x {
            girdle = 0.8;
        }
        girdle *= 1.0 - neck;
        // The torso's skin beside the armpit follows the arm less and less downwards and inwards.
        let near = match label {
            Tube::Torso => {
                smooth_step((position.y - self.armpit + 0.06 * k) / (0.09 * k))
                    * smooth_step((position.x - 0.62 * upper.x) / (0.32 * upper.x))
            }
            _ if is_arm => 1.0,
            _ => 0.0,
        };
        let axis = (lower - upper).normalize_or_zero() + Vec3::X * 0.55;
        let arm = near * past(position, upper, axis, [0.035 * k, 0.085 * k]);
        let forearm = if arm > 0.5 {
            past(
                position,
                lower,
                bisector(upper, lower, hand),
                [0.045 * k, 0.09 * k],
            )
        } else {
            0.0
        };
        let palm = if forearm > 0.5 {
            past(
                position,
                hand,
                bisector(lower, hand, knuckle),
                [0.02 * k, 0.04 * k],
            )
        } else {
            0.0
        };
        row[Bone::LeftShoulder.index()] = (1.0 - arm) * girdle;
        row[Bone::LeftUpperArm.index()] = arm * (1.0 - forearm);
        row[Bone::LeftLowerArm.index()] = arm * forearm * (1.0 - palm);
        let fingers = self.fill_finger(row, position, label, arm * forearm * palm);
        row[Bone::LeftHand.index()] = arm * forearm * palm - fingers;
    }

    /// Shares a finger's own vertices among its three bones; returns what they took of `hand`.
    fn fill_finger(&self, row: &mut Row, position: Vec3, label: Tube, hand: f32) -> f32 {
        let Some((bones, tip)) = finger_bones(label) else {
            return 0.0;
        };
        let tip = self.body.joint(tip);
        let mut left = hand;
        let mut taken = 0.0;
        for (index, &bone) in bones.iter().enumerate() {
            let joint = self.joint(bone);
            let next = bones.get(index + 1).map_or(tip, |&bone| self.joint(bone));
            let before = match index {
                0 => joint - (next - joint),
                _ => self.joint(bones[index - 1]),
            };
            let width = [0.006 * self.k, 0.012 * self.k];
            let share = past(position, joint, bisector(before, joint, next), width);
            if index == 0 {
                taken = left * share;
            } else {
                row[bones[index - 1].index()] = left * (1.0 - share);
            }
            left *= share;
        }
        row[bones[2].index()] = left;
        taken
    }

    /// Both legs: near the mirror plane the right one carries a little too.
    fn fill_leg(&self, row: &mut Row, position: Vec3) {
        let k = self.k;
        let mirrored = Vec3::new(-position.x, position.y, position.z);
        let [left, right] = [position, mirrored].map(|point| self.leg_share(point));
        row[Bone::RightUpperLeg.index()] = right;
        let [knee, ankle, toes] =
            [Bone::LeftLowerLeg, Bone::LeftFoot, Bone::LeftToes].map(|bone| self.joint(bone));
        let shank = smooth_step((knee.y + 0.04 * k - position.y) / (0.08 * k));
        let foot = if position.y < ankle.y + 0.08 * k {
            let forward_down = Vec3::new(0.0, -0.9, 0.45);
            past(position, ankle, forward_down, [0.03 * k, 0.05 * k])
        } else {
            0.0
        };
        let ball = if foot > 0.5 {
            let ahead = (toes - ankle) * Vec3::new(1.0, 0.0, 1.0);
            past(position, toes, ahead, [0.012 * k, 0.03 * k])
        } else {
            0.0
        };
        row[Bone::LeftUpperLeg.index()] = left * (1.0 - shank);
        row[Bone::LeftLowerLeg.index()] = left * shank * (1.0 - foot);
        row[Bone::LeftFoot.index()] = left * shank * foot * (1.0 - ball);
        row[Bone::LeftToes.index()] = left * shank * foot * ball;
    }

    /// Share of the left leg: past an oblique plane through the hip joint, on its side.
    fn leg_share(&self, position: Vec3) -> f32 {
        let k = self.k;
        if position.y < self.crotch - 0.03 * k {
            return if position.x > 0.0 { 1.0 } else { 0.0 };
        }
        let hip = self.joint(Bone::LeftUpperLeg);
        let outward_down = Vec3::new(0.45, -0.9, 0.0);
        past(position, hip, outward_down, [0.045 * k, 0.12 * k])
            * smooth_step((position.x + 0.005 * k) / (0.035 * k))
    }
}

/// The three bones of a finger and the name of its tip.
fn finger_bones(label: Tube) -> Option<([Bone; 3], &'static str)> {
    let bones = match label {
        Tube::Thumb => (
            [
                Bone::LeftThumbMetacarpal,
                Bone::LeftThumbProximal,
                Bone::LeftThumbDistal,
            ],
            "tip_Thumb",
        ),
        Tube::Index => (
            [
                Bone::LeftIndexProximal,
                Bone::LeftIndexIntermediate,
                Bone::LeftIndexDistal,
            ],
            "tip_Index",
        ),
        Tube::Middle => (
            [
                Bone::LeftMiddleProximal,
                Bone::LeftMiddleIntermediate,
                Bone::LeftMiddleDistal,
            ],
            "tip_Middle",
        ),
        Tube::Ring => (
            [
                Bone::LeftRingProximal,
                Bone::LeftRingIntermediate,
                Bone::LeftRingDistal,
            ],
            "tip_Ring",
        ),
        Tube::Little => (
            [
                Bone::LeftLittleProximal,
                Bone::LeftLittleIntermediate,
                Bone::LeftLittleDistal,
            ],
            "tip_Little",
        ),
        _ => return None,
    };
    Some(bones)
}
