//! Which joint is which bone where names say nothing: by how joints hang together at rest.
//!
//! A person is a joint from which two like limbs hang, and a trunk, on which two other like limbs
//! hang and a head. Of a limb, the two longest bones that follow each other are the upper and the
//! lower one. The side is told by the toes, which point to the front.

use glam::Vec3;
use lole_body::Bone;

use crate::{JointPlace, Recording};

/// Two limbs are alike if their lengths and numbers of joints differ by at most this part together:
/// a trunk with its arms is about as long as a leg, but has more joints.
const ALIKE: f32 = 0.4;

/// The joint of each bone; `None` where the joints do not hang together as a person's.
pub(crate) fn by_hierarchy(recording: &Recording) -> Option<Vec<Option<usize>>> {
    let tree = Tree::new(recording);
    let hips = tree.fork(0..recording.joints.len())?;
    let trunk = tree.path(hips.trunk);
    // Deeper joints of the trunk follow all of its subtree's first joint.
    let chest = tree.fork(trunk.into_iter())?;
    let mut joints = vec![None; Bone::COUNT];
    joints[Bone::Hips.index()] = Some(hips.joint);
    joints[Bone::Head.index()] = tree.head(chest.trunk);

    let legs = hips.pair.map(|limb| tree.limb(limb));
    let arms = chest.pair.map(|limb| tree.limb(limb));
    let [legs, arms] = [both(legs)?, both(arms)?];
    let at = |joint: usize| tree.places[joint].position;
    let up = at(chest.joint) - at(hips.joint);
    let front: Vec3 = legs
        .iter()
        .filter_map(|leg| Some(at(*leg.after.first()?) - at(leg.end)))
        .sum();
    let left = up.cross(front);
    for (limbs, names) in [(legs, LEGS), (arms, ARMS)] {
        let aside = at(limbs[0].upper) - at(limbs[1].upper);
        if left.dot(aside).abs() <= 1e-3 * left.length() * aside.length() {
            return None;
        }
        let first = usize::from(left.dot(aside) < 0.0);
        for (limb, place) in limbs.iter().zip([first, 1 - first]) {
            let (before, [upper, lower, end], after) = names[place];
            joints[upper.index()] = Some(limb.upper);
            joints[lower.index()] = Some(limb.lower);
            joints[end.index()] = Some(limb.end);
            if let Some(before) = before {
                joints[before.index()] = limb.before;
            }
            if let Some(after) = after {
                joints[after.index()] = limb.after.first().copied();
            }
        }
    }
    Some(joints)
}

/// What comes before a limb, its three joints, what comes after; left and right.
type LimbNames = [(Option<Bone>, [Bone; 3], Option<Bone>); 2];

const LEGS: LimbNames = [
    (
        None,
        [Bone::LeftUpperLeg, Bone::LeftLowerLeg, Bone::LeftFoot],
        Some(Bone::LeftToes),
    ),
    (
        None,
        [Bone::RightUpperLeg, Bone::RightLowerLeg, Bone::RightFoot],
        Some(Bone::RightToes),
    ),
];
const ARMS: LimbNames = [
    (
        Some(Bone::LeftShoulder),
        [Bone::LeftUpperArm, Bone::LeftLowerArm, Bone::LeftHand],
        None,
    ),
    (
        Some(Bone::RightShoulder),
        [Bone::RightUpperArm, Bone::RightLowerArm, Bone::RightHand],
        None,
    ),
];

/// Two limbs, if both are there.
fn both(limbs: [Option<Limb>; 2]) -> Option<[Limb; 2]> {
    let [first, second] = limbs;
    Some([first?, second?])
}

/// A joint from which two like limbs hang, and one more branch.
struct Fork {
    joint: usize,
    /// First joints of the limbs.
    pair: [usize; 2],
    /// First joint of the longest other branch.
    trunk: usize,
}

/// Joints of a limb.
struct Limb {
    /// The joint before the upper bone, if it is the limb's own.
    before: Option<usize>,
    upper: usize,
    lower: usize,
    end: usize,
    /// Joints beyond, as far as there are any; the ends of bones among them.
    after: Vec<usize>,
}

/// A recording's joints at rest, with what hangs on each.
struct Tree<'a> {
    recording: &'a Recording,
    places: Vec<JointPlace>,
    children: Vec<Vec<usize>>,
    /// Longest way from each joint along its branches to an end [file units].
    reach: Vec<f32>,
    /// Joints from each one on, itself included.
    sizes: Vec<u16>,
}

/// Difference of two numbers as a part of the larger one.
fn difference([a, b]: [f32; 2]) -> f32 {
    (a - b).abs() / a.max(b).max(f32::MIN_POSITIVE)
}

impl<'a> Tree<'a> {
    fn new(recording: &'a Recording) -> Self {
        let places = recording.rest_places();
        let count = recording.joints.len();
        let mut children = vec![Vec::new(); count];
        let mut reach = vec![0.0_f32; count];
        let mut sizes = vec![1_u16; count];
        for index in (0..count).rev() {
            if let Some(parent) = recording.joints[index].parent {
                children[parent].insert(0, index);
                let bone = places[index].position.distance(places[parent].position);
                reach[parent] = reach[parent].max(reach[index] + bone);
                sizes[parent] += sizes[index];
            }
        }
        Self {
            recording,
            places,
            children,
            reach,
            sizes,
        }
    }

    /// The first of `joints` from which two like limbs hang and something else.
    fn fork(&self, joints: impl Iterator<Item = usize>) -> Option<Fork> {
        let mut joints = joints;
        joints.find_map(|joint| self.fork_at(joint))
    }

    fn fork_at(&self, joint: usize) -> Option<Fork> {
        let branches = self.branches(joint);
        let longest = branches.iter().map(|&branch| self.length(branch, joint));
        let longest = longest.fold(0.0, f32::max);
        let mut best: Option<(f32, [usize; 2])> = None;
        for (place, &a) in branches.iter().enumerate() {
            for &b in &branches[place + 1..] {
                let lengths = [a, b].map(|branch| self.length(branch, joint));
                let sizes = [a, b].map(|branch| self.sizes[branch] as f32);
                let unlike = difference(lengths) + difference(sizes);
                let long = 0.3 * longest < lengths[0].min(lengths[1]);
                let limbs = long && self.limb(a).is_some() && self.limb(b).is_some();
                if limbs && unlike < best.map_or(ALIKE, |(least, _)| least) {
                    best = Some((unlike, [a, b]));
                }
            }
        }
        let (_, pair) = best?;
        let others = branches.iter().filter(|branch| !pair.contains(branch));
        let trunk = others
            .copied()
            .max_by(|&a, &b| self.length(a, joint).total_cmp(&self.length(b, joint)))?;
        (self.length(trunk, joint) > 0.0).then_some(Fork { joint, pair, trunk })
    }

    /// What hangs on a joint; joints at the same place that branch on are taken apart.
    fn branches(&self, joint: usize) -> Vec<usize> {
        let mut branches = Vec::new();
        let mut open: Vec<usize> = self.children[joint].iter().rev().copied().collect();
        while let Some(child) = open.pop() {
            let apart = self.places[child]
                .position
                .distance(self.places[joint].position);
            if apart <= 1e-4 * self.reach[joint] && self.children[child].len() > 1 {
                open.extend(self.children[child].iter().rev());
            } else {
                branches.push(child);
            }
        }
        branches
    }

    /// From `joint` along a branch to its farthest end.
    fn length(&self, branch: usize, joint: usize) -> f32 {
        self.reach[branch]
            + self.places[branch]
                .position
                .distance(self.places[joint].position)
    }

    /// A joint and what follows it along the longest branches.
    fn path(&self, start: usize) -> Vec<usize> {
        std::iter::successors(Some(start), |&joint| {
            let children = self.children[joint].iter().copied();
            children.max_by(|&a, &b| self.length(a, joint).total_cmp(&self.length(b, joint)))
        })
        .collect()
    }

    /// The limb that begins at `start`: of its path, the two longest bones that follow each other.
    fn limb(&self, start: usize) -> Option<Limb> {
        let path = self.path(start);
        let bone = |i: usize| {
            let [a, b] = [path[i], path[i + 1]].map(|joint| self.places[joint].position);
            a.distance(b)
        };
        let starts = 0..path.len().saturating_sub(2);
        let score = |i: usize| bone(i).min(bone(i + 1));
        let upper = starts.max_by(|&a, &b| score(a).total_cmp(&score(b)).then(b.cmp(&a)))?;
        if score(upper) <= 0.0 {
            return None;
        }
        let own = |joint: usize| !self.recording.joints[joint].name.is_empty();
        let distinct = path[upper + 2..].iter().copied();
        let end = self.places[path[upper + 2]].position;
        let beyond = 1e-3 * (bone(upper) + bone(upper + 1));
        Some(Limb {
            before: upper.checked_sub(1).map(|i| path[i]).filter(|&i| own(i)),
            upper: path[upper],
            lower: path[upper + 1],
            end: path[upper + 2],
            after: distinct
                .skip(1)
                .filter(|&joint| beyond < self.places[joint].position.distance(end))
                .collect(),
        })
    }

    /// The last joint with a name along a branch.
    fn head(&self, start: usize) -> Option<usize> {
        let path = self.path(start);
        let named = |joint: &usize| !self.recording.joints[*joint].name.is_empty();
        path.into_iter().rev().find(named)
    }
}
