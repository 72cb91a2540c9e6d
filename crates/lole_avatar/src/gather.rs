//! A `.gltf` whose data lies in files beside it, made one file.
//!
//! Nothing is opened here: [`neighbors`] says which files are wanted, and [`gathered`] takes their bytes.

use base64::Engine as _;
use serde_json::Value;

use crate::{AvatarError, bounded};

/// Arrays of glTF whose items may name a file.
const PARTS: [&str; 2] = ["buffers", "images"];

/// Names of the files beside a `.gltf` that hold its data and its pictures, each once, in order; none
/// for any other file.
///
/// # Errors
/// An address that leads out of the folder or to another machine.
pub fn neighbors(bytes: &[u8]) -> Result<Vec<String>, AvatarError> {
    let Some(root) = text(bytes) else {
        return Ok(Vec::new());
    };
    let mut names = Vec::new();
    for part in PARTS {
        let items = root.get(part).and_then(Value::as_array);
        for (index, item) in items.into_iter().flatten().enumerate() {
            let Some(uri) = address(item) else {
                continue;
            };
            let name = name(uri).ok_or_else(|| AvatarError::Elsewhere {
                place: format!("{part}[{index}]"),
                uri: crate::container::visible(uri),
            })?;
            if !names.contains(&name) {
                names.push(name);
            }
        }
    }
    Ok(names)
}

/// A file with the bytes of its neighbors inside; a neighbor that `read` does not have stays outside. `None` where nothing is to be gathered.
#[must_use]
pub fn gathered(bytes: &[u8], read: impl Fn(&str) -> Option<Vec<u8>>) -> Option<Vec<u8>> {
    let mut root = text(bytes)?;
    let mut has_changed = false;
    for part in PARTS {
        let items = root.get_mut(part).and_then(Value::as_array_mut);
        for item in items.into_iter().flatten() {
            let found = address(item).and_then(name).and_then(|name| read(&name));
            if let (Some(found), Some(item)) = (found, item.as_object_mut()) {
                let text = base64::engine::general_purpose::STANDARD.encode(found);
                let data = format!("data:application/octet-stream;base64,{text}");
                item.insert("uri".to_owned(), Value::String(data));
                has_changed = true;
            }
        }
    }
    has_changed.then(|| root.to_string().into_bytes())
}

/// The text of a `.gltf`; nothing for any other file, which its reader will refuse.
fn text(bytes: &[u8]) -> Option<Value> {
    let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    text.trim_ascii_start().starts_with(b"{").then_some(())?;
    bounded::check(text).ok()?;
    serde_json::from_slice(text).ok()
}

/// Where a part says its data lies, unless it is inside.
fn address(item: &Value) -> Option<&str> {
    let uri = item.get("uri")?.as_str()?;
    (!uri.starts_with("data:")).then_some(uri)
}

/// The file that an address names, if that lies in the folder or below it.
fn name(uri: &str) -> Option<String> {
    let name = unescaped(uri)?;
    let is_within = |step: &str| !matches!(step, "" | "." | "..") && !step.ends_with(['.', ' ']);
    let is_plain = !name.contains(['\\', ':']) && !name.chars().any(char::is_control);
    (is_plain && name.split('/').all(is_within)).then_some(name)
}

/// An address with its `%20` as characters.
fn unescaped(uri: &str) -> Option<String> {
    let mut bytes = Vec::with_capacity(uri.len());
    let mut rest = uri.bytes();
    while let Some(byte) = rest.next() {
        if byte != b'%' {
            bytes.push(byte);
            continue;
        }
        let digits = [rest.next()?, rest.next()?];
        let digits = std::str::from_utf8(&digits).ok()?;
        bytes.push(u8::from_str_radix(digits, 16).ok()?);
    }
    String::from_utf8(bytes).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_files_of_the_folder_are_neighbors() {
        for (uri, expected) in [
            ("body.bin", Some("body.bin")),
            ("data/my%20body.bin", Some("data/my body.bin")),
            ("../body.bin", None),
            ("data/..%2F..%2Fbody.bin", None),
            ("/etc/passwd", None),
            ("C:/body.bin", None),
            ("https://example.org/body.bin", None),
            ("a\\b.bin", None),
            ("body%zz.bin", None),
        ] {
            assert_eq!(name(uri).as_deref(), expected, "{uri}");
        }
    }

    #[test]
    fn gathered_data_lies_inside() {
        let file = br#"{"buffers":[{"uri":"a.bin","byteLength":3}],"images":[{"uri":"no.png"}]}"#;
        assert_eq!(
            neighbors(file),
            Ok(vec!["a.bin".to_owned(), "no.png".to_owned()])
        );
        let whole = gathered(file, |name| (name == "a.bin").then(|| vec![1, 2, 3]));
        let root: Value = serde_json::from_slice(&whole.unwrap_or_default()).unwrap_or_default();
        let uri = root["buffers"][0]["uri"].as_str().unwrap_or("");
        assert_eq!(uri, "data:application/octet-stream;base64,AQID");
        assert_eq!(root["images"][0]["uri"], "no.png");
        assert_eq!(gathered(b"glTF", |_| Some(Vec::new())), None);
    }
}
