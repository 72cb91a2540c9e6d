//! The outside of a file: GLB chunks, the glTF text, and the bytes that it speaks of.
//!
//! The text is read by `gltf-json`. Nothing is trusted afterwards: every index is looked up, every
//! range is checked where it is used.

use std::borrow::Cow;

use base64::Engine as _;
use gltf_json::Root;
use lole_language::{Sentence, words};
use serde_json::{Map, Value};

use crate::{AvatarError, bounded};

/// Nodes of a file at most: a detailed avatar has a thousand.
const MOST_NODES: usize = 4096;
/// Bytes of text that are read at most.
const MOST_TEXT: usize = 64 << 20;
/// Extensions without which a file may say it cannot be read, and which are understood or change
/// nothing that is read.
const UNDERSTOOD: [&str; 13] = [
    "VRM",
    "VRMC_vrm",
    "VRMC_vrm_animation",
    "VRMC_materials_mtoon",
    "VRMC_springBone",
    "VRMC_node_constraint",
    "KHR_materials_unlit",
    "KHR_materials_emissive_strength",
    "KHR_materials_specular",
    "KHR_materials_ior",
    "KHR_mesh_quantization",
    "KHR_texture_transform",
    "KHR_lights_punctual",
];

const MAGIC: &[u8] = b"glTF";
const JSON_CHUNK: u32 = 0x4e4f_534a;
const BIN_CHUNK: u32 = 0x004e_4942;

/// A file whose text was read.
pub(crate) struct File<'a> {
    /// The text.
    pub(crate) root: Root,
    /// Bytes of each buffer; `None` where they lie in another file.
    pub(crate) buffers: Vec<Option<Cow<'a, [u8]>>>,
}

impl<'a> File<'a> {
    /// Reads text and buffers.
    pub(crate) fn read(bytes: &'a [u8]) -> Result<Self, AvatarError> {
        let (text, blob) = chunks(bytes)?;
        if MOST_TEXT < text.len() {
            return Err(AvatarError::TooLarge {
                what: words("バイトの記述", "bytes of text"),
                count: text.len() as u64,
                limit: MOST_TEXT as u64,
            });
        }
        bounded::check(text)?;
        let root: Root = serde_json::from_slice(text).map_err(|error| AvatarError::Text {
            problem: visible(&error.to_string()),
        })?;
        if !root.asset.version.starts_with("2.") {
            return Err(AvatarError::part(
                "asset.version",
                format!(
                    "glTF {} です。読めるのは 2.0 です",
                    visible(&root.asset.version)
                ),
                format!(
                    "this is glTF {}, and 2.0 is read",
                    visible(&root.asset.version)
                ),
            ));
        }
        let strange = root.extensions_required.iter();
        if let Some(name) = strange
            .clone()
            .find(|name| !UNDERSTOOD.contains(&name.as_str()))
        {
            return Err(AvatarError::Extension {
                name: visible(name),
            });
        }
        if MOST_NODES < root.nodes.len() {
            return Err(AvatarError::TooLarge {
                what: words("ノード", "nodes"),
                count: root.nodes.len() as u64,
                limit: MOST_NODES as u64,
            });
        }
        let buffers = buffers(&root, blob)?;
        Ok(Self { root, buffers })
    }

    /// A named extension of the whole file.
    pub(crate) fn extension(&self, name: &str) -> Option<&Value> {
        self.extensions()?.get(name)
    }

    fn extensions(&self) -> Option<&Map<String, Value>> {
        Some(&self.root.extensions.as_ref()?.others)
    }

    /// Name of a node; empty where it has none.
    pub(crate) fn node_name(&self, node: usize) -> &str {
        let node = self.root.nodes.get(node);
        node.and_then(|node| node.name.as_deref()).unwrap_or("")
    }
}

/// What stands in a file, short enough for a sentence and on one line.
pub(crate) fn visible(text: &str) -> String {
    let visible = |letter: char| if letter.is_control() { ' ' } else { letter };
    text.chars().take(120).map(visible).collect()
}

/// Whether bytes begin as a GLB (VRM and VRMA are such) or as a glTF text does.
#[must_use]
pub fn is_gltf(bytes: &[u8]) -> bool {
    bytes.starts_with(MAGIC) || without_mark(bytes).trim_ascii_start().starts_with(b"{")
}

fn without_mark(bytes: &[u8]) -> &[u8] {
    bytes.strip_prefix("\u{feff}".as_bytes()).unwrap_or(bytes)
}

/// The text, and the bytes that follow it in a GLB.
fn chunks(bytes: &[u8]) -> Result<(&[u8], Option<&[u8]>), AvatarError> {
    if !is_gltf(bytes) {
        return Err(AvatarError::UnknownFormat);
    }
    if !bytes.starts_with(MAGIC) {
        return Ok((without_mark(bytes), None));
    }
    let damaged = |japanese: String, english: String| AvatarError::Container {
        problem: Sentence::new(japanese, english),
    };
    let version = number(bytes, 4).unwrap_or(0);
    if version != 2 {
        return Err(damaged(
            format!("GLB の版が {version} で、読めるのは 2 です"),
            format!("the GLB has version {version}, and version 2 is read"),
        ));
    }
    let (mut text, mut blob) = (None, None);
    let mut at = 12;
    while let (Some(length), Some(kind)) = (number(bytes, at), number(bytes, at + 4)) {
        let start = at + 8;
        let end = start.saturating_add(length as usize);
        let chunk = bytes.get(start..end).ok_or_else(|| {
            let there = bytes.len() - start;
            damaged(
                format!(
                    "ファイルが途中で切れています（{length} バイトのうち {there} バイトしかありません）"
                ),
                format!("the file is cut off: a chunk of {length} bytes has {there}"),
            )
        })?;
        match kind {
            JSON_CHUNK if text.is_none() => text = Some(chunk),
            BIN_CHUNK if blob.is_none() => blob = Some(chunk),
            _ => {}
        }
        at = end;
    }
    let text = text.ok_or_else(|| {
        damaged(
            "GLB に記述（JSON）がありません".to_owned(),
            "the GLB has no JSON chunk".to_owned(),
        )
    })?;
    Ok((text, blob))
}

/// Little-endian number of four bytes.
fn number(bytes: &[u8], at: usize) -> Option<u32> {
    let word: [u8; 4] = bytes.get(at..at.checked_add(4)?)?.try_into().ok()?;
    Some(u32::from_le_bytes(word))
}

fn buffers<'a>(
    root: &Root,
    blob: Option<&'a [u8]>,
) -> Result<Vec<Option<Cow<'a, [u8]>>>, AvatarError> {
    let buffers = root.buffers.iter().enumerate();
    buffers
        .map(|(index, buffer)| match &buffer.uri {
            None if index == 0 => Ok(blob.map(Cow::Borrowed)),
            None => Ok(None),
            Some(uri) => match embedded(uri) {
                Some(Ok(bytes)) => Ok(Some(Cow::Owned(bytes))),
                Some(Err(())) => Err(AvatarError::part(
                    format!("buffers[{index}]"),
                    "埋め込まれたデータ（base64）が壊れています",
                    "the embedded data is no base64",
                )),
                None => Ok(None),
            },
        })
        .collect()
}

/// Bytes of a `data:` address; `None` where the address is another.
pub(crate) fn embedded(uri: &str) -> Option<Result<Vec<u8>, ()>> {
    let (kind, text) = uri.strip_prefix("data:")?.split_once(',')?;
    if !kind.ends_with(";base64") {
        return Some(Err(()));
    }
    let engine = base64::engine::general_purpose::STANDARD;
    Some(engine.decode(text.trim()).map_err(|_| ()))
}
