//! Cloth on bones of its own: the closest that skinning comes to a recorded motion.
//!
//! Viewers play few morph targets, and any number of keys of bones. Vertices that go the same way share a bone; then
//! bones and weights are improved in turn, each with the other held (Le and Deng 2012, "Smooth skinning decomposition
//! with rigid bones"): a bone is the rotation and translation that leave its vertices the least error, the weights of
//! a vertex are the ones of four bones that leave it the least error over all samples.

use glam::{Mat3, Mat4, Quat, Vec3, Vec4};
use lole_geom::trig;
use lole_language::Sentence;
use rayon::prelude::*;

/// Most bones of a cloth.
const MOST_BONES: usize = 96;
/// Least vertices for each bone.
const VERTICES_PER_BONE: usize = 12;
/// Frames that weights are fitted to, evenly taken.
pub(super) const SAMPLES: usize = 64;
/// Frames that vertices are told apart by when bones are shared out.
const FEATURES: usize = 6;
/// Rounds of sharing out, and of improving bones and weights.
const SHARING_ROUNDS: usize = 8;
const ROUNDS: usize = 4;
/// Bones that are tried for a vertex: those next to it on the cloth.
const CANDIDATES: usize = 8;
/// Turns of the search for a rotation: it converges in about five from where it was.
const ROTATION_TURNS: usize = 24;
/// Squarings after which a form has little left but its longest axis.
const FORM_SQUARES: usize = 12;
/// Added to the diagonal of a vertex's weight problem, as a share of it: bones that move alike share evenly.
const RIDGE: f32 = 1.0e-4;

/// A bone at one moment: `p -> turn * p + place`, from where the cloth is at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rigid {
    pub(super) turn: Quat,
    pub(super) place: Vec3,
}

impl Rigid {
    const REST: Self = Self {
        turn: Quat::IDENTITY,
        place: Vec3::ZERO,
    };

    fn at(self, point: Vec3) -> Vec3 {
        self.turn * point + self.place
    }
}

/// How far skinned cloth is from its recording.
#[derive(Debug, Clone, PartialEq)]
pub struct ClothFit {
    /// Name of the cloth.
    pub name: String,
    /// Bones of its own.
    pub bone_count: usize,
    /// Mean distance of a vertex from where it was recorded [mm], over all frames.
    pub mean_mm: f64,
    /// Largest distance [mm].
    pub worst_mm: f64,
}

/// What is said of cloth that a 3D file has on bones, because it moved for too long; nothing
/// where there is none.
#[must_use]
pub fn said_of(fits: &[ClothFit]) -> Sentence {
    let mut said = Sentence::new("", "");
    for fit in fits {
        let ClothFit {
            name,
            bone_count,
            mean_mm,
            worst_mm,
        } = fit;
        said.japanese += &format!(
            " {name} は{bone_count}本の骨で動きます（記録との差は平均 {mean_mm:.1} mm、最大 {worst_mm:.0} mm）。"
        );
        said.english += &format!(
            " {name} is moved by {bone_count} bones, off by {mean_mm:.1} mm on the mean and {worst_mm:.0} mm at most."
        );
    }
    said
}

/// Cloth on bones, which follow its frames one by one.
#[derive(Debug)]
pub(super) struct Fit {
    rest: Vec<Vec3>,
    /// Where a bone's vertices are at rest, on the mean [m].
    pub(super) joints: Vec<Vec3>,
    pub(super) skin: Skin,
    by_bone: Vec<Vec<(usize, f32)>>,
    last: Vec<Rigid>,
    sum: f64,
    count: u64,
    worst: f32,
}

impl Fit {
    /// Fits bones to some frames of a cloth, of which the first is at rest and has a vertex.
    pub(super) fn new(samples: &[Vec<Vec3>]) -> Self {
        let rest = samples[0].clone();
        let owner = share_out(samples);
        let bone_count = owner.iter().copied().max().map_or(1, |most| most + 1);
        let joints = centers(&rest, &owner, bone_count);
        let candidates = candidates(&rest, &owner, &joints);
        let mut skin = Skin {
            bones: owner.iter().map(|&bone| [index(bone), 0, 0, 0]).collect(),
            weights: vec![[1.0, 0.0, 0.0, 0.0]; rest.len()],
        };
        let still = vec![Rigid::REST; bone_count];
        let mut keys = vec![still.clone(); samples.len()];
        for _ in 0..ROUNDS {
            let by_bone = skin.by_bone(bone_count);
            keys = (samples.par_iter().zip(keys))
                .map(|(sample, key)| improved(&rest, sample, (&skin, &by_bone), key))
                .collect();
            skin = skin.reweighted(&rest, samples, (&keys, &candidates));
        }
        Self {
            by_bone: skin.by_bone(bone_count),
            last: still,
            rest,
            joints,
            skin,
            sum: 0.0,
            count: 0,
            worst: 0.0,
        }
    }

    /// The bones in the next frame. Each begins where the one before it ended, so that bones turn steadily.
    pub(super) fn follow(&mut self, frame: &[Vec3]) -> &[Rigid] {
        let last = std::mem::take(&mut self.last);
        self.last = improved(&self.rest, frame, (&self.skin, &self.by_bone), last);
        for (vertex, &place) in frame.iter().enumerate() {
            let found = self.skin.at(vertex, self.rest[vertex], &self.last);
            let off = found.distance(place);
            self.sum += f64::from(off);
            self.worst = self.worst.max(off);
        }
        self.count += frame.len() as u64;
        &self.last
    }

    /// What is said of cloth without a vertex.
    pub(super) fn nothing(name: &str) -> ClothFit {
        ClothFit {
            name: name.to_owned(),
            bone_count: 0,
            mean_mm: 0.0,
            worst_mm: 0.0,
        }
    }

    /// How far it was from the frames that it followed.
    #[expect(clippy::cast_precision_loss, reason = "a mean of fewer than 2^52")]
    pub(super) fn told(&self, name: &str) -> ClothFit {
        ClothFit {
            name: name.to_owned(),
            bone_count: self.joints.len(),
            mean_mm: 1000.0 * self.sum / self.count.max(1) as f64,
            worst_mm: 1000.0 * f64::from(self.worst),
        }
    }
}

/// Which bones carry the vertices.
#[derive(Debug)]
pub(super) struct Skin {
    pub(super) bones: Vec<[u16; 4]>,
    pub(super) weights: Vec<[f32; 4]>,
}

impl Skin {
    fn at(&self, vertex: usize, rest: Vec3, key: &[Rigid]) -> Vec3 {
        let carried = self.bones[vertex].into_iter().zip(self.weights[vertex]);
        carried.fold(Vec3::ZERO, |sum, (bone, weight)| {
            sum + weight * key[usize::from(bone)].at(rest)
        })
    }

    /// Vertices of each bone, with their weights.
    fn by_bone(&self, bone_count: usize) -> Vec<Vec<(usize, f32)>> {
        let mut by_bone = vec![Vec::new(); bone_count];
        for (vertex, (bones, weights)) in self.bones.iter().zip(&self.weights).enumerate() {
            for (&bone, &weight) in bones.iter().zip(weights) {
                if 0.0 < weight {
                    by_bone[usize::from(bone)].push((vertex, weight));
                }
            }
        }
        by_bone
    }

    /// Better weights for the bones as they are.
    fn reweighted(
        &self,
        rest: &[Vec3],
        samples: &[Vec<Vec3>],
        (keys, candidates): (&[Vec<Rigid>], &[Vec<u16>]),
    ) -> Self {
        let carried = (0..rest.len()).into_par_iter().map(|vertex| {
            let bones = &candidates[vertex];
            let errors = |sample: usize, bone: u16| {
                keys[sample][usize::from(bone)].at(rest[vertex]) - samples[sample][vertex]
            };
            let mut best = bones.clone();
            let alone = |bone: u16| -> f32 {
                let offs = (0..samples.len()).map(|sample| errors(sample, bone).length_squared());
                offs.sum()
            };
            let mut by_error: Vec<(f32, u16)> = best.drain(..).map(|it| (alone(it), it)).collect();
            by_error.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            by_error.truncate(4);
            let chosen: Vec<u16> = by_error.into_iter().map(|(_, bone)| bone).collect();
            let offs: Vec<Vec<Vec3>> = (0..samples.len())
                .map(|sample| chosen.iter().map(|&bone| errors(sample, bone)).collect())
                .collect();
            let weights = least(&offs, chosen.len());
            let mut own = ([chosen[0]; 4], [0.0; 4]);
            for (slot, (bone, weight)) in chosen.into_iter().zip(weights).enumerate() {
                (own.0[slot], own.1[slot]) = (bone, weight);
            }
            own
        });
        let (bones, weights) = carried.unzip();
        Self { bones, weights }
    }
}

/// Bones that leave their vertices less error in a frame, one after the other, each with the others held.
fn improved(
    rest: &[Vec3],
    frame: &[Vec3],
    (skin, by_bone): (&Skin, &[Vec<(usize, f32)>]),
    last: Vec<Rigid>,
) -> Vec<Rigid> {
    let carried = |key: &[Rigid]| -> Vec<Vec3> {
        (0..rest.len())
            .map(|vertex| skin.at(vertex, rest[vertex], key))
            .collect()
    };
    let off = |now: &[Vec3]| -> f32 {
        (now.iter().zip(frame))
            .map(|(now, place)| now.distance_squared(*place))
            .sum()
    };
    // Each bone as if it alone carried its vertices: exact where they go together, while bones that share them
    // would find there from the last frame only slowly, each held back by the others.
    let alone: Vec<Rigid> = (by_bone.iter().zip(&last))
        .map(|(vertices, last)| {
            let pairs = vertices.iter();
            let pairs = pairs.map(|&(vertex, weight)| (weight, rest[vertex], frame[vertex]));
            let pairs: Vec<(f32, Vec3, Vec3)> = pairs.collect();
            if pairs.is_empty() {
                *last
            } else {
                rigid(&pairs, last.turn)
            }
        })
        .collect();
    let (now_last, now_alone) = (carried(&last), carried(&alone));
    let (mut key, mut now) = if off(&now_alone) < off(&now_last) {
        (alone, now_alone)
    } else {
        (last, now_last)
    };
    // Errors are passed on from bone to bone.
    for _ in 0..2 {
        for (bone, vertices) in by_bone.iter().enumerate() {
            if vertices.is_empty() {
                continue;
            }
            let old = key[bone];
            // What the bone alone should reach, for its vertex to be where it was recorded.
            let pairs: Vec<(f32, Vec3, Vec3)> = vertices
                .iter()
                .map(|&(vertex, weight)| {
                    let others = now[vertex] - weight * old.at(rest[vertex]);
                    let wanted = (frame[vertex] - others) / weight;
                    (weight * weight, rest[vertex], wanted)
                })
                .collect();
            key[bone] = rigid(&pairs, old.turn);
            for &(vertex, weight) in vertices {
                now[vertex] += weight * (key[bone].at(rest[vertex]) - old.at(rest[vertex]));
            }
        }
    }
    key
}

/// The rigid motion with the least weighted squares between its first points and its second.
fn rigid(pairs: &[(f32, Vec3, Vec3)], start: Quat) -> Rigid {
    let sum: f32 = pairs.iter().map(|(weight, ..)| weight).sum();
    let center = |pick: fn(&(f32, Vec3, Vec3)) -> Vec3| {
        pairs.iter().map(|pair| pair.0 * pick(pair)).sum::<Vec3>() / sum
    };
    let (from, to) = (center(|pair| pair.1), center(|pair| pair.2));
    let mut covariance = Mat3::ZERO;
    for &(weight, first, second) in pairs {
        let (first, second) = (first - from, weight * (second - to));
        covariance += Mat3::from_cols(first.x * second, first.y * second, first.z * second);
    }
    let turn = rotation(covariance, start);
    Rigid {
        turn,
        place: to - turn * from,
    }
}

/// The rotation nearest to a matrix: the one that is found from `start`, so that a bone turns steadily where its
/// vertices leave it free, unless the best of all is better by more than rounding.
fn rotation(matrix: Mat3, start: Quat) -> Quat {
    let fit = |turn: Quat| {
        let axes = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| turn * axis);
        let columns = [matrix.x_axis, matrix.y_axis, matrix.z_axis];
        (axes.iter().zip(&columns))
            .map(|(axis, column)| axis.dot(*column))
            .sum::<f32>()
    };
    let near = polished(matrix, start);
    let best = polished(matrix, by_form(matrix, start));
    let size = matrix
        .to_cols_array()
        .iter()
        .map(|it| it * it)
        .sum::<f32>()
        .sqrt();
    if fit(best) - fit(near) < 1.0e-6 * size {
        near
    } else {
        best
    }
}

/// Near the rotation that is nearest to a matrix, wherever it is: a quaternion's square form of it (Horn 1987) has it
/// for its longest axis, which is what its powers leave.
fn by_form(matrix: Mat3, start: Quat) -> Quat {
    let [x, y, z] = [matrix.x_axis, matrix.y_axis, matrix.z_axis];
    let twist = Vec3::new(y.z - z.y, z.x - x.z, x.y - y.x);
    let trace = x.x + y.y + z.z;
    let form = Mat4::from_cols(
        Vec4::new(x.x - y.y - z.z, x.y + y.x, x.z + z.x, twist.x),
        Vec4::new(x.y + y.x, y.y - x.x - z.z, y.z + z.y, twist.y),
        Vec4::new(x.z + z.x, y.z + z.y, z.z - x.x - y.y, twist.z),
        Vec4::new(twist.x, twist.y, twist.z, trace),
    );
    // Longer than its most negative axis, so that the most positive one wins.
    let shift = form
        .to_cols_array()
        .iter()
        .map(|it| it * it)
        .sum::<f32>()
        .sqrt();
    if shift <= f32::MIN_POSITIVE {
        return start;
    }
    let mut power = form * (1.0 / shift) + Mat4::IDENTITY;
    for _ in 0..FORM_SQUARES {
        let square = power * power;
        let size = square
            .to_cols_array()
            .iter()
            .fold(0.0_f32, |most, it| most.max(it.abs()));
        power = square * (1.0 / size.max(f32::MIN_POSITIVE));
    }
    // Its columns are multiples of that axis, the longest one the least rounded.
    let columns = [power.x_axis, power.y_axis, power.z_axis, power.w_axis];
    let longest = columns.into_iter().fold(Vec4::ZERO, |longest, column| {
        if longest.length_squared() < column.length_squared() {
            column
        } else {
            longest
        }
    });
    let turn = longest.normalize_or(Vec4::from(start));
    Quat::from_vec4(turn)
}

/// The rotation nearest to a matrix, from one that is near (Müller, Bender, Chentanez and Macklin 2016, "A robust
/// method to extract the rotational part of deformations").
fn polished(matrix: Mat3, start: Quat) -> Quat {
    let mut turn = start;
    let columns = [matrix.x_axis, matrix.y_axis, matrix.z_axis];
    for _ in 0..ROTATION_TURNS {
        let axes = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| turn * axis);
        let pairs = || axes.iter().zip(&columns);
        let twist: Vec3 = pairs().map(|(axis, column)| axis.cross(*column)).sum();
        let fit: f32 = pairs().map(|(axis, column)| axis.dot(*column)).sum();
        // Nothing to turn by: a point, or a line that turns as it likes.
        let omega = twist / (fit.abs() + 1.0e-12);
        let angle = omega.length();
        if angle < 1.0e-6 {
            break;
        }
        let (sin, cos) = trig::sin_cos(0.5 * angle.min(1.5));
        let axis = omega / angle * sin;
        turn = (Quat::from_xyzw(axis.x, axis.y, axis.z, cos) * turn).normalize();
    }
    turn
}

/// Weights from 0 to 1, of sum 1, with the least squares of the weighted sum of errors: by shares that are taken
/// from the worst and given to the best (coordinate pairs), which for four bones is quick and cannot leave the range.
fn least(offs: &[Vec<Vec3>], count: usize) -> [f32; 4] {
    let mut squares = [[0.0_f32; 4]; 4];
    for off in offs {
        for (row, first) in off.iter().enumerate() {
            for (column, second) in off.iter().enumerate() {
                squares[row][column] += first.dot(*second);
            }
        }
    }
    let trace: f32 = (0..count).map(|it| squares[it][it]).sum();
    for (it, row) in squares.iter_mut().enumerate().take(count) {
        row[it] += RIDGE * trace + f32::MIN_POSITIVE;
    }
    let mut weights = [0.0; 4];
    weights[0] = 1.0;
    for _ in 0..40 {
        for give in 0..count {
            for take in 0..count {
                if give == take || weights[give] <= 0.0 {
                    continue;
                }
                let slope = |it: usize| -> f32 {
                    (0..count)
                        .map(|other| squares[it][other] * weights[other])
                        .sum()
                };
                let curve = squares[give][give] + squares[take][take] - 2.0 * squares[give][take];
                if curve <= 0.0 {
                    continue;
                }
                let step = ((slope(give) - slope(take)) / curve).clamp(0.0, weights[give]);
                weights[give] -= step;
                weights[take] += step;
            }
        }
    }
    weights
}

/// A bone for each vertex: vertices that go the same way in a few frames are together.
fn share_out(frames: &[Vec<Vec3>]) -> Vec<usize> {
    let vertex_count = frames[0].len();
    let count = (vertex_count / VERTICES_PER_BONE).clamp(1, MOST_BONES);
    let looks = spread(frames.len(), FEATURES);
    let path = |vertex: usize| looks.iter().map(move |&frame| frames[frame][vertex]);
    let distance = |vertex: usize, center: &[Vec3]| -> f32 {
        path(vertex)
            .zip(center)
            .map(|(place, center)| place.distance_squared(*center))
            .sum()
    };
    // Each center is the vertex that is farthest from those before it.
    let mut centers: Vec<Vec<Vec3>> = vec![path(0).collect()];
    let mut nearest: Vec<f32> = (0..vertex_count)
        .map(|vertex| distance(vertex, &centers[0]))
        .collect();
    while centers.len() < count {
        let farthest = (0..vertex_count).max_by(|&a, &b| nearest[a].total_cmp(&nearest[b]));
        let center: Vec<Vec3> = path(farthest.unwrap_or(0)).collect();
        for (vertex, near) in nearest.iter_mut().enumerate() {
            *near = near.min(distance(vertex, &center));
        }
        centers.push(center);
    }
    let mut owner = vec![0; vertex_count];
    for _ in 0..SHARING_ROUNDS {
        owner = (0..vertex_count)
            .into_par_iter()
            .map(|vertex| {
                let all = centers.iter().map(|center| distance(vertex, center));
                let best = all.enumerate().min_by(|a, b| a.1.total_cmp(&b.1));
                best.map_or(0, |(center, _)| center)
            })
            .collect();
        let mut sums = vec![(vec![Vec3::ZERO; looks.len()], 0.0_f32); centers.len()];
        for (vertex, &center) in owner.iter().enumerate() {
            let (sum, number) = &mut sums[center];
            for (sum, place) in sum.iter_mut().zip(path(vertex)) {
                *sum += place;
            }
            *number += 1.0;
        }
        for (center, (sum, number)) in centers.iter_mut().zip(sums) {
            if 0.0 < number {
                *center = sum.into_iter().map(|sum| sum / number).collect();
            }
        }
    }
    packed(&owner)
}

/// The same owners, numbered without gaps in the order in which they come.
fn packed(owner: &[usize]) -> Vec<usize> {
    let mut numbers: Vec<usize> = Vec::new();
    let packed = owner.iter().map(|&old| {
        numbers.iter().position(|&it| it == old).unwrap_or_else(|| {
            numbers.push(old);
            numbers.len() - 1
        })
    });
    packed.collect()
}

fn centers(rest: &[Vec3], owner: &[usize], bone_count: usize) -> Vec<Vec3> {
    let mut sums = vec![(Vec3::ZERO, 0.0_f32); bone_count];
    for (&point, &bone) in rest.iter().zip(owner) {
        sums[bone].0 += point;
        sums[bone].1 += 1.0;
    }
    let means = sums.into_iter().map(|(sum, number)| sum / number.max(1.0));
    means.collect()
}

/// Bones that may carry a vertex: its own first, then the nearest at rest.
fn candidates(rest: &[Vec3], owner: &[usize], joints: &[Vec3]) -> Vec<Vec<u16>> {
    let near = rest.par_iter().zip(owner).map(|(&point, &own)| {
        let mut bones: Vec<usize> = (0..joints.len()).filter(|&bone| bone != own).collect();
        let far = |bone: &usize| joints[*bone].distance_squared(point);
        bones.sort_by(|a, b| far(a).total_cmp(&far(b)));
        bones.truncate(CANDIDATES - 1);
        bones.insert(0, own);
        bones.into_iter().map(index).collect()
    });
    near.collect()
}

/// At most `most` of `count` places, evenly, the first and the last among them.
pub(super) fn spread(count: usize, most: usize) -> Vec<usize> {
    if count <= most {
        return (0..count).collect();
    }
    (0..most).map(|it| it * (count - 1) / (most - 1)).collect()
}

fn index(bone: usize) -> u16 {
    u16::try_from(bone).unwrap_or(u16::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two plates that turn about a hinge and travel.
    fn plates(frame: u8) -> Vec<Vec3> {
        let angle = 0.05 * f32::from(frame);
        let (sin, cos) = trig::sin_cos(angle);
        let mut points = Vec::new();
        for row in 0..10_u8 {
            for column in 0..20_u8 {
                let (along, z) = (f32::from(column) - 9.5, f32::from(row) * 0.05);
                let along = along * 0.05;
                let turned = if along < 0.0 {
                    Vec3::new(along, 0.0, z)
                } else {
                    Vec3::new(along * cos, along * sin, z)
                };
                points.push(turned + Vec3::Z * f32::from(frame) * 0.01);
            }
        }
        points
    }

    /// Bones fitted to all frames, which they have followed.
    fn followed(frames: &[Vec<Vec3>]) -> (Fit, ClothFit) {
        let mut fit = Fit::new(frames);
        for frame in frames {
            fit.follow(frame);
        }
        let told = fit.told("cloth");
        (fit, told)
    }

    #[test]
    fn what_moves_as_bones_do_is_met() {
        let frames: Vec<Vec<Vec3>> = (0..40).map(plates).collect();
        let (fit, told) = followed(&frames);
        assert!(told.worst_mm < 0.1, "{told:?}");
        assert!(told.mean_mm <= told.worst_mm);
        for weights in &fit.skin.weights {
            let sum: f32 = weights.iter().sum();
            assert!((sum - 1.0).abs() < 1.0e-4 && weights.iter().all(|it| 0.0 <= *it));
        }
    }

    #[test]
    fn the_nearest_rotation_is_found_from_anywhere() {
        for number in 0..200_u8 {
            let angles = [0.7, 1.3, 2.9].map(|rate| rate * f32::from(number));
            let truth = Quat::from_euler(glam::EulerRot::XYZ, angles[0], angles[1], angles[2]);
            // A volume, a plate and a narrow plate.
            for sizes in [
                Vec3::new(3.0, 2.0, 1.0),
                Vec3::new(3.0, 2.0, 0.0),
                Vec3::new(3.0, 0.3, 0.0),
            ] {
                let matrix = Mat3::from_quat(truth) * Mat3::from_diagonal(sizes);
                let found = rotation(matrix, Quat::IDENTITY);
                assert!(
                    0.999 < found.dot(truth).abs(),
                    "{number} {sizes}: {found} {truth}"
                );
            }
        }
    }

    #[test]
    fn rest_is_rest() {
        let (_, told) = followed(&vec![plates(3); 5]);
        assert!(told.worst_mm < 0.01, "{told:?}");
    }

    #[test]
    fn one_vertex_has_a_bone() {
        let frames: Vec<Vec<Vec3>> = (0..5_u8).map(|it| vec![Vec3::X * f32::from(it)]).collect();
        let (_, told) = followed(&frames);
        assert!(told.worst_mm < 0.01, "{told:?}");
    }

    #[test]
    fn the_nearest_rotation_is_the_one_that_was_put_in() {
        let turn = Quat::from_xyzw(0.2, -0.5, 0.3, 0.7).normalize();
        let stretched = Mat3::from_quat(turn) * Mat3::from_diagonal(Vec3::new(3.0, 1.0, 0.5));
        let found = rotation(stretched, Quat::IDENTITY);
        assert!(0.999_999 < found.dot(turn).abs(), "{found} {turn}");
    }
}
