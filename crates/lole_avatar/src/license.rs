//! Under which conditions an avatar or a dance may be used: read, shown, kept and obeyed.
//!
//! A person who opens a file on her own machine uses it. What is refused is to write it into a file
//! that leaves the machine, where its license forbids to change it or to pass it on.

use lole_language::{Sentence, words};
use serde::Serialize;
use serde_json::Value;

use crate::container::File;
use crate::vrm::{ANIMATION, Format, VRM_0, VRM_1};

/// What is allowed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Permission {
    /// The file says so.
    Allowed,
    /// The file forbids it.
    Forbidden,
    /// The file says nothing.
    Unsaid,
}

/// What a file says about its use.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct License {
    /// Name of the avatar.
    pub title: Option<String>,
    /// Who made it.
    pub authors: Vec<String>,
    /// Copyright line.
    pub copyright: Option<String>,
    /// Whether the author must be named.
    pub credit_required: bool,
    /// Whether it may be changed: dressed, and written in another form.
    pub modification: Permission,
    /// Whether it may be passed on.
    pub redistribution: Permission,
    /// Every field of the license as it stands in the file, by its name there.
    pub fields: Vec<(String, String)>,
}

/// Fields of the license in VRM 0.x, in the order of its specification.
const FIELDS_0: [&str; 12] = [
    "title",
    "version",
    "author",
    "contactInformation",
    "reference",
    "allowedUserName",
    "violentUssageName",
    "sexualUssageName",
    "commercialUssageName",
    "otherPermissionUrl",
    "licenseName",
    "otherLicenseUrl",
];
/// Fields of the license in VRM 1.0.
const FIELDS_1: [&str; 18] = [
    "name",
    "version",
    "authors",
    "copyrightInformation",
    "contactInformation",
    "references",
    "thirdPartyLicenses",
    "licenseUrl",
    "avatarPermission",
    "allowExcessivelyViolentUsage",
    "allowExcessivelySexualUsage",
    "commercialUsage",
    "allowPoliticalOrReligiousUsage",
    "allowAntisocialOrHateUsage",
    "creditNotation",
    "allowRedistribution",
    "modification",
    "otherLicenseUrl",
];

impl License {
    pub(crate) fn of(file: &File<'_>, format: Format) -> Self {
        let meta = |extension| file.extension(extension).and_then(|said| said.get("meta"));
        let mut license = match format {
            Format::Vrm0 => Self::of_vrm_0(meta(VRM_0).unwrap_or(&Value::Null)),
            Format::Vrm1 => Self::of_vrm_1(meta(VRM_1).unwrap_or(&Value::Null)),
            Format::Vrma => Self::silent(meta(ANIMATION).unwrap_or(&Value::Null), &[]),
            Format::Gltf => Self::silent(&Value::Null, &[]),
        };
        let copyright = file.root.asset.copyright.as_deref().map(long);
        license.copyright = license.copyright.or(copyright);
        license
    }

    /// A license that says nothing, with the fields of `names`.
    fn silent(meta: &Value, names: &[&str]) -> Self {
        let said = names.iter().filter_map(|&name| {
            let text = match meta.get(name)? {
                Value::String(text) => long(text),
                Value::Bool(yes) => yes.to_string(),
                Value::Array(list) => long(&texts(list).join(", ")),
                Value::Number(number) => number.to_string(),
                Value::Null | Value::Object(_) => return None,
            };
            (!text.is_empty()).then(|| (name.to_owned(), text))
        });
        Self {
            title: None,
            authors: Vec::new(),
            copyright: None,
            credit_required: false,
            modification: Permission::Unsaid,
            redistribution: Permission::Unsaid,
            fields: said.collect(),
        }
    }

    /// The fields of VRM 0.x: a license by name, or permissions in the query of an address.
    fn of_vrm_0(meta: &Value) -> Self {
        let text = |name: &str| meta.get(name).and_then(Value::as_str).unwrap_or("");
        let (modification, redistribution) = match text("licenseName") {
            "CC0" | "CC_BY" | "CC_BY_NC" | "CC_BY_SA" | "CC_BY_NC_SA" => {
                (Permission::Allowed, Permission::Allowed)
            }
            // No derivatives: it may be passed on as it is, and only so.
            "CC_BY_ND" | "CC_BY_NC_ND" => (Permission::Forbidden, Permission::Allowed),
            "Redistribution_Prohibited" => (Permission::Unsaid, Permission::Forbidden),
            _ => {
                let address = [text("otherPermissionUrl"), text("otherLicenseUrl")];
                let of = |key| asked(&address, key);
                (of("modification"), of("redistribution"))
            }
        };
        let given = |name: &str| Some(long(text(name))).filter(|text| !text.is_empty());
        let address = [text("otherPermissionUrl"), text("otherLicenseUrl")];
        Self {
            title: given("title"),
            authors: given("author").into_iter().collect(),
            credit_required: text("licenseName").starts_with("CC_BY")
                || address.iter().any(|url| url.contains("credit=necessary")),
            modification,
            redistribution,
            ..Self::silent(meta, &FIELDS_0)
        }
    }

    fn of_vrm_1(meta: &Value) -> Self {
        let text = |name: &str| meta.get(name).and_then(Value::as_str);
        // What is left out is forbidden: the defaults of the specification.
        let modification = match text("modification") {
            Some("allowModification" | "allowModificationRedistribution") => Permission::Allowed,
            _ => Permission::Forbidden,
        };
        let redistribution = match meta.get("allowRedistribution").and_then(Value::as_bool) {
            Some(true) => Permission::Allowed,
            _ => Permission::Forbidden,
        };
        // Changed, it is passed on only where that is said.
        let changed = match text("modification") {
            Some("allowModificationRedistribution") => redistribution,
            _ => Permission::Forbidden,
        };
        let authors = meta.get("authors").and_then(Value::as_array);
        Self {
            title: text("name").map(long),
            authors: authors.map_or_else(Vec::new, |list| texts(list)),
            copyright: text("copyrightInformation").map(long),
            credit_required: text("creditNotation") != Some("unnecessary"),
            modification,
            redistribution: changed,
            ..Self::silent(meta, &FIELDS_1)
        }
    }

    /// Why files that leave the machine must not hold the avatar; `None` where they may.
    #[must_use]
    pub fn export_refusal(&self) -> Option<Sentence> {
        let forbidden = match (self.modification, self.redistribution) {
            (Permission::Forbidden, Permission::Forbidden) => {
                words("改変と再配布", "to change it or to pass it on")
            }
            (Permission::Forbidden, _) => words("改変", "to change it"),
            (_, Permission::Forbidden) => words("再配布", "to pass it on changed"),
            _ => return None,
        };
        Some(Sentence::new(
            format!(
                "このアバターのライセンスは{}を認めていません。手元で使い、書き出すファイルには入れません",
                forbidden.japanese
            ),
            format!(
                "the avatar's license forbids {}: it is used here and left out of exported files",
                forbidden.english
            ),
        ))
    }

    /// What the license says, as lines of text.
    #[must_use]
    pub fn lines(&self) -> Vec<Sentence> {
        let mut lines = Vec::new();
        if !self.authors.is_empty() {
            let names = self.authors.join(", ");
            let required = if self.credit_required {
                ("（表示が必要です）", " (must be named)")
            } else {
                ("", "")
            };
            lines.push(Sentence::new(
                format!("作者: {names}{}", required.0),
                format!("by: {names}{}", required.1),
            ));
        }
        if let Some(copyright) = &self.copyright {
            lines.push(Sentence::new(
                format!("著作権: {copyright}"),
                format!("copyright: {copyright}"),
            ));
        }
        if self.fields.is_empty() {
            lines.push(Sentence::new(
                "ライセンス: ファイルには書かれていません",
                "license: the file says nothing",
            ));
        } else {
            let fields: Vec<String> = self
                .fields
                .iter()
                .map(|(name, text)| format!("{name} = {text}"))
                .collect();
            let fields = fields.join(", ");
            lines.push(Sentence::new(
                format!("ライセンス: {fields}"),
                format!("license: {fields}"),
            ));
        }
        lines.extend(self.export_refusal());
        lines
    }
}

/// What the query of an address of `VRoid` Hub says to `key`.
fn asked(addresses: &[&str], key: &str) -> Permission {
    let parts = addresses.iter().filter_map(|url| url.split_once('?'));
    let mut said = parts
        .flat_map(|(_, query)| query.split('&'))
        .filter_map(|part| part.split_once('='))
        .filter(|(name, _)| *name == key)
        .map(|(_, value)| value);
    match said.next() {
        Some("allow") => Permission::Allowed,
        Some("disallow" | "deny" | "prohibited") => Permission::Forbidden,
        _ => Permission::Unsaid,
    }
}

fn texts(list: &[Value]) -> Vec<String> {
    let texts = list.iter().filter_map(Value::as_str);
    texts.map(long).take(32).collect()
}

/// Letters of one field that are kept: an address with its query.
const LONGEST_FIELD: usize = 2000;

/// A text of a license on one line.
fn long(text: &str) -> String {
    let visible = |letter: char| if letter.is_control() { ' ' } else { letter };
    text.chars().take(LONGEST_FIELD).map(visible).collect()
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn what_vrm_1_leaves_out_is_forbidden() {
        let license = License::of_vrm_1(&json!({"name": "a", "authors": ["b"]}));
        assert_eq!(license.modification, Permission::Forbidden);
        assert_eq!(license.redistribution, Permission::Forbidden);
        assert!(license.credit_required);
        let said = license.export_refusal().unwrap();
        assert!(said.english.contains("to change it or to pass it on"));
    }

    #[test]
    fn what_was_changed_is_passed_on_only_where_both_are_allowed() {
        let of = |modification: &str, redistribution: bool| {
            License::of_vrm_1(&json!({
                "modification": modification,
                "allowRedistribution": redistribution,
            }))
            .export_refusal()
        };
        assert!(of("allowModificationRedistribution", true).is_none());
        assert!(of("allowModificationRedistribution", false).is_some());
        assert!(of("allowModification", true).is_some());
        assert!(of("prohibited", true).is_some());
    }

    #[test]
    fn names_and_addresses_of_vrm_0_are_understood() {
        let of = |name: &str, url: &str| {
            License::of_vrm_0(&json!({"licenseName": name, "otherPermissionUrl": url}))
        };
        for name in ["CC0", "CC_BY", "CC_BY_NC", "CC_BY_SA", "CC_BY_NC_SA"] {
            assert_eq!(of(name, "").export_refusal(), None, "{name}");
        }
        for name in ["CC_BY_ND", "CC_BY_NC_ND", "Redistribution_Prohibited"] {
            assert!(of(name, "").export_refusal().is_some(), "{name}");
        }
        assert!(of("CC_BY", "").credit_required);
        let hub = "https://hub.vroid.com/license?modification=disallow&redistribution=allow";
        assert_eq!(of("Other", hub).modification, Permission::Forbidden);
        assert_eq!(of("Other", hub).redistribution, Permission::Allowed);
        assert_eq!(of("Other", "").modification, Permission::Unsaid);
    }
}
