//! The nodes of a file as a tree, and where they lie.

use glam::{Affine3A, Mat3, Mat4, Quat, Vec3};
use lole_motion::JointPlace;

use crate::AvatarError;
use crate::container::File;

/// Levels of nodes at most.
const DEEPEST: usize = 256;

/// Parents of nodes, and an order in which they come first.
pub(crate) struct Tree {
    /// Parent of each node.
    pub(crate) parents: Vec<Option<usize>>,
    /// All nodes, parents before children.
    pub(crate) order: Vec<usize>,
}

/// Translation, rotation and scale of a node in its parent's space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Local {
    pub(crate) translation: Vec3,
    pub(crate) rotation: Quat,
    pub(crate) scale: Vec3,
}

impl Local {
    /// The transform that scales first, then turns, then moves.
    pub(crate) fn parent_from_node(&self) -> Affine3A {
        Affine3A::from_scale_rotation_translation(self.scale, self.rotation, self.translation)
    }
}

impl Tree {
    /// The tree of a file's nodes.
    ///
    /// # Errors
    /// A child that is none, has two parents, or is its own ancestor.
    pub(crate) fn new(file: &File<'_>) -> Result<Self, AvatarError> {
        let nodes = &file.root.nodes;
        let mut parents = vec![None; nodes.len()];
        for (index, node) in nodes.iter().enumerate() {
            for child in node.children.iter().flatten() {
                let child = child.value();
                let place = || format!("nodes[{index}].children");
                let parent = parents.get_mut(child).ok_or_else(|| {
                    AvatarError::part(
                        place(),
                        format!("nodes[{child}] がありません"),
                        format!("there is no nodes[{child}]"),
                    )
                })?;
                if parent.is_some() || child == index {
                    return Err(AvatarError::part(
                        place(),
                        format!("nodes[{child}] の親が一つではありません"),
                        format!("nodes[{child}] hangs on more than one node"),
                    ));
                }
                *parent = Some(index);
            }
        }
        let mut order: Vec<usize> = (0..nodes.len())
            .filter(|&node| parents[node].is_none())
            .collect();
        let mut depths = vec![0; nodes.len()];
        let mut next = 0;
        while let Some(&node) = order.get(next) {
            next += 1;
            for child in nodes[node].children.iter().flatten() {
                depths[child.value()] = depths[node] + 1;
                order.push(child.value());
            }
        }
        if order.len() < nodes.len() || depths.iter().any(|&depth| DEEPEST < depth) {
            return Err(AvatarError::part(
                "nodes",
                "親子のつながりが輪になっているか、深すぎます",
                "nodes hang on each other in a ring, or too deep",
            ));
        }
        Ok(Self { parents, order })
    }

    /// The nearest of `wanted` on the way from a node up, itself included.
    pub(crate) fn nearest<T>(&self, node: usize, wanted: impl Fn(usize) -> Option<T>) -> Option<T> {
        std::iter::successors(Some(node), |&node| self.parents[node]).find_map(wanted)
    }

    /// World transforms of all nodes, of their local ones.
    pub(crate) fn worlds(&self, locals: &[Local]) -> Vec<Affine3A> {
        let mut worlds = vec![Affine3A::IDENTITY; locals.len()];
        for &node in &self.order {
            let local = locals[node].parent_from_node();
            worlds[node] = match self.parents[node] {
                Some(parent) => worlds[parent] * local,
                None => local,
            };
        }
        worlds
    }
}

/// Local transforms of all nodes as the file leaves them.
///
/// # Errors
/// Numbers that are too large or no numbers.
pub(crate) fn locals(file: &File<'_>) -> Result<Vec<Local>, AvatarError> {
    let nodes = file.root.nodes.iter().enumerate();
    nodes
        .map(|(index, node)| {
            let local = match node.matrix {
                Some(columns) => {
                    let matrix = Mat4::from_cols_array(&columns);
                    let place = place(&Affine3A::from_mat4(matrix));
                    let axes = Mat3::from_mat4(matrix);
                    Local {
                        translation: place.position,
                        rotation: place.rotation,
                        scale: Vec3::new(
                            axes.x_axis.length(),
                            axes.y_axis.length(),
                            axes.z_axis.length() * axes.determinant().signum(),
                        ),
                    }
                }
                None => Local {
                    translation: node.translation.map_or(Vec3::ZERO, Vec3::from_array),
                    rotation: node.rotation.map_or(Quat::IDENTITY, |turn| turn_of(turn.0)),
                    scale: node.scale.map_or(Vec3::ONE, Vec3::from_array),
                },
            };
            let sane = local.translation.abs().max_element() < 1e7
                && local.scale.abs().max_element() < 1e7
                && local.rotation.is_finite();
            sane.then_some(local).ok_or_else(|| {
                AvatarError::part(
                    format!("nodes[{index}]"),
                    "位置か回転か拡大率が有限の数ではありません",
                    "its translation, rotation or scale is no finite number",
                )
            })
        })
        .collect()
}

/// A turn of four numbers `x, y, z, w`; none where they are all 0.
pub(crate) fn turn_of(numbers: [f32; 4]) -> Quat {
    let turn = Quat::from_array(numbers);
    let length = turn.length();
    if length.is_finite() && 1e-6 < length {
        turn * (1.0 / length)
    } else {
        Quat::IDENTITY
    }
}

/// Place and turn of a transform, without its scale.
pub(crate) fn place(world: &Affine3A) -> JointPlace {
    let [x, y]: [Vec3; 2] = [world.matrix3.x_axis.into(), world.matrix3.y_axis.into()];
    let x = x.try_normalize().unwrap_or(Vec3::X);
    let y = (y - x * x.dot(y))
        .try_normalize()
        .unwrap_or_else(|| x.any_orthonormal_vector());
    // The third axis of a mirrored node points the other way in every frame alike.
    let turned = Mat3::from_cols(x, y, x.cross(y));
    let position: Vec3 = world.translation.into();
    JointPlace {
        position,
        rotation: Quat::from_mat3(&turned).normalize(),
    }
}
