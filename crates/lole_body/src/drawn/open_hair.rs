//! Open hair as it swings: knots that whoever moves her moves, and what of the hair goes with them.

use std::ops::Range;

use glam::{Affine3A, Vec3};

use crate::SkinnedMesh;
use crate::skin::blend;

/// A place in the hair that moves by itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HairKnot {
    /// Where it is combed to, in the bind pose [m].
    pub place: Vec3,
    /// Unit vector away from the back, there.
    pub outward: Vec3,
    /// Bones ([`crate::Bone::index`]) that carry the place it is combed to, and their shares.
    pub carried: ([u16; 4], [f32; 4]),
}

/// Where a knot is combed to in a pose, in the world.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Combed {
    /// Its place [m].
    pub place: Vec3,
    /// Unit vector away from the back.
    pub outward: Vec3,
    /// Unit vector that was down when the hair was combed, while she stood.
    pub down: Vec3,
}

/// How the knots of open hair are away from where they are combed to: as many as [`OpenHair::knots`], or none.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Swing {
    /// How far [m], in the world.
    pub moved: Vec<Vec3>,
    /// How the hair there has turned: axis times angle [rad], in the world.
    pub turned: Vec<Vec3>,
}

/// What of open hair moves by itself.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct OpenHair {
    /// Column by column from her right to her left, in each from above down; the first of each stays where it is
    /// combed to.
    pub knots: Vec<HairKnot>,
    /// Columns of knots.
    pub column_count: usize,
    /// What of the drawn body goes with them.
    mesh: Vec<Share>,
    /// What of the single strands does.
    strands: Vec<Share>,
}

/// A vertex, and the four knots around it.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Share {
    vertex: u32,
    knots: [u16; 4],
    weights: [f32; 4],
}

/// Where a place lies among the knots: column and row, which need not be whole. Above the first row nothing moves.
pub(crate) type Lie = [f32; 2];

impl OpenHair {
    /// Hair with these knots, column by column, and of its vertices those whose lie is known.
    pub(crate) fn new(
        (knots, column_count): (Vec<HairKnot>, usize),
        mesh: impl Iterator<Item = (u32, Lie)>,
        strands: impl Iterator<Item = (u32, Lie)>,
    ) -> Self {
        let row_count = knots.len() / column_count.max(1);
        let share = |(vertex, [column, row]): (u32, Lie)| {
            let bounded = |at: f32, count: usize| {
                let at = at.clamp(0.0, count.saturating_sub(1) as f32);
                let low = at.floor().min(count.saturating_sub(2) as f32);
                (whole(low), at - low)
            };
            let ((column, across), (row, down)) =
                (bounded(column, column_count), bounded(row, row_count));
            let knot = |column: usize, row: usize| {
                let last = knots.len().saturating_sub(1);
                u16::try_from((column * row_count + row).min(last)).unwrap_or(u16::MAX)
            };
            Share {
                vertex,
                knots: [
                    knot(column, row),
                    knot(column + 1, row),
                    knot(column, row + 1),
                    knot(column + 1, row + 1),
                ],
                weights: [
                    (1.0 - across) * (1.0 - down),
                    across * (1.0 - down),
                    (1.0 - across) * down,
                    across * down,
                ],
            }
        };
        let hangs = |(_, [_, row]): &(u32, Lie)| 0.0 < *row;
        let (mesh, strands) = (
            mesh.filter(hangs).map(share).collect(),
            strands.filter(hangs).map(share).collect(),
        );
        Self {
            knots,
            column_count,
            mesh,
            strands,
        }
    }

    /// Where the knots are combed to.
    pub fn combed(&self, world_from_bind: &[Affine3A]) -> impl Iterator<Item = Combed> {
        self.knots.iter().map(|knot| {
            let (joints, weights) = knot.carried;
            let blended = blend(world_from_bind, joints, weights);
            let [outward, down] = [knot.outward, Vec3::NEG_Y]
                .map(|it| blended.transform_vector3(it).normalize_or_zero());
            Combed {
                place: blended.transform_point3(knot.place),
                outward,
                down,
            }
        })
    }

    /// Lets the posed body's hair swing.
    pub fn swing_mesh(&self, swing: &Swing, vertices: (&mut [Vec3], &mut [Vec3])) {
        self.carry(&self.mesh, swing, vertices);
    }

    /// Lets posed strands swing.
    pub fn swing_strands(&self, swing: &Swing, vertices: (&mut [Vec3], &mut [Vec3])) {
        self.carry(&self.strands, swing, vertices);
    }

    fn carry(
        &self,
        shares: &[Share],
        swing: &Swing,
        (positions, normals): (&mut [Vec3], &mut [Vec3]),
    ) {
        if swing.moved.len() != self.knots.len() || swing.turned.len() != self.knots.len() {
            return;
        }
        for share in shares {
            let (mut moved, mut turned) = (Vec3::ZERO, Vec3::ZERO);
            for (knot, weight) in share.knots.into_iter().zip(share.weights) {
                moved += swing.moved[usize::from(knot)] * weight;
                turned += swing.turned[usize::from(knot)] * weight;
            }
            let vertex = share.vertex as usize;
            positions[vertex] += moved;
            let normal = normals[vertex];
            normals[vertex] = (normal + turned.cross(normal)).normalize_or(normal);
        }
    }
}

/// Some vertices of a mesh, where they lie among the knots.
pub(crate) fn lies(
    mesh: &SkinnedMesh,
    some: Range<usize>,
    lie: impl Fn(Vec3) -> Lie,
) -> impl Iterator<Item = (u32, Lie)> {
    let vertices = mesh.positions.iter().enumerate();
    let vertices = vertices.take(some.end).skip(some.start);
    vertices.map(move |(vertex, &place)| (u32::try_from(vertex).unwrap_or(u32::MAX), lie(place)))
}

/// A whole number that is not negative, as an index.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "cut off at 0, and knots are few"
)]
const fn whole(at: f32) -> usize {
    at.max(0.0) as usize
}
