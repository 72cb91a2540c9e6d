//! What VRM says on top of glTF: which node is which bone, and of what kind the file is.
//!
//! VRM 0.x: <https://github.com/vrm-c/vrm-specification/tree/master/specification/0.0>, VRM 1.0 and
//! VRMA: the `VRMC_vrm-1.0` and `VRMC_vrm_animation-1.0` folders beside it.

use lole_body::Bone;
use serde_json::Value;

use crate::AvatarError;
use crate::container::{File, visible};

/// Kind of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// VRM 0.x: an avatar that faces -Z.
    Vrm0,
    /// VRM 1.0: an avatar that faces +Z.
    Vrm1,
    /// A dance alone.
    Vrma,
    /// glTF or GLB without either.
    Gltf,
}

impl Format {
    /// Its usual name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Vrm0 => "VRM 0.x",
            Self::Vrm1 => "VRM 1.0",
            Self::Vrma => "VRMA 1.0",
            Self::Gltf => "glTF 2.0",
        }
    }

    pub(crate) fn of(file: &File<'_>) -> Self {
        if file.extension(VRM_1).is_some() {
            Self::Vrm1
        } else if file.extension(VRM_0).is_some() {
            Self::Vrm0
        } else if file.extension(ANIMATION).is_some() {
            Self::Vrma
        } else {
            Self::Gltf
        }
    }
}

pub(crate) const VRM_0: &str = "VRM";
pub(crate) const VRM_1: &str = "VRMC_vrm";
pub(crate) const ANIMATION: &str = "VRMC_vrm_animation";

/// The node of each bone, shape `[Bone::COUNT]`, where the file says it; `None` where it does not.
///
/// # Errors
/// A bone that is given to a node that is not there.
pub(crate) fn human_bones(
    file: &File<'_>,
    format: Format,
) -> Result<Option<Vec<Option<usize>>>, AvatarError> {
    let extension = match format {
        Format::Vrm0 => VRM_0,
        Format::Vrm1 => VRM_1,
        Format::Vrma => ANIMATION,
        Format::Gltf => return Ok(None),
    };
    let bones = file.extension(extension);
    let bones = bones.and_then(|said| said.get("humanoid")?.get("humanBones"));
    // A list of bones in 0.x, a table by name later.
    let named: Vec<(&str, Option<&Value>)> = match bones {
        Some(Value::Array(list)) => list
            .iter()
            .filter_map(|entry| Some((entry.get("bone")?.as_str()?, entry.get("node"))))
            .collect(),
        Some(Value::Object(table)) => table
            .iter()
            .map(|(name, entry)| (name.as_str(), entry.get("node")))
            .collect(),
        _ => {
            return Err(AvatarError::part(
                format!("extensions.{extension}"),
                "humanoid.humanBones がありません",
                "humanoid.humanBones is missing",
            ));
        }
    };
    let mut nodes = vec![None; Bone::COUNT];
    for (name, node) in named {
        let Some(bone) = bone_named(name, format) else {
            continue;
        };
        let node = match node {
            // Programs write -1 for a bone that is left out.
            Some(Value::Number(number)) if number.as_i64().is_some_and(|n| n < 0) => continue,
            Some(node) => node.as_u64().and_then(|node| usize::try_from(node).ok()),
            None => continue,
        };
        let node = node.filter(|&node| node < file.root.nodes.len());
        nodes[bone.index()] = Some(node.ok_or_else(|| {
            let name = visible(name);
            AvatarError::part(
                format!("extensions.{extension}.humanoid"),
                format!("{name} の指すノードがありません"),
                format!("the node of {name} is not there"),
            )
        })?);
    }
    Ok(Some(nodes))
}

/// A bone by its name in VRM. In 0.x the bones of the thumb are named one joint further out.
fn bone_named(name: &str, format: Format) -> Option<Bone> {
    let renamed = match (format, name) {
        (Format::Vrm0, "leftThumbProximal") => "leftThumbMetacarpal",
        (Format::Vrm0, "leftThumbIntermediate") => "leftThumbProximal",
        (Format::Vrm0, "rightThumbProximal") => "rightThumbMetacarpal",
        (Format::Vrm0, "rightThumbIntermediate") => "rightThumbProximal",
        _ => name,
    };
    Bone::ALL
        .iter()
        .copied()
        .find(|bone| bone.name() == renamed)
}

/// Facial expressions of an avatar.
pub(crate) fn expression_count(file: &File<'_>, format: Format) -> usize {
    let count = |value: Option<&Value>| match value {
        Some(Value::Array(list)) => list.len(),
        Some(Value::Object(table)) => table.len(),
        _ => 0,
    };
    match format {
        Format::Vrm0 => {
            let said = file.extension(VRM_0);
            count(said.and_then(|said| said.get("blendShapeMaster")?.get("blendShapeGroups")))
        }
        Format::Vrm1 | Format::Vrma => {
            let said = file.extension(if format == Format::Vrm1 {
                VRM_1
            } else {
                ANIMATION
            });
            let said = said.and_then(|said| said.get("expressions"));
            count(said.and_then(|said| said.get("preset")))
                + count(said.and_then(|said| said.get("custom")))
        }
        Format::Gltf => 0,
    }
}
