//! Measures of bodies from other programs: each of their names is one row with what it is here.
//!
//! Sources of the names: GarmentCode's body files (`assets/bodies/*.yaml` and "Body Measurements GarmentCode", MIT),
//! FreeSewing's measurement sets (`@freesewing/models`, all in millimeters, MIT), and the names that Seamly2D and
//! Valentina give their known measurements.

use lole_body::Measure;
use lole_language::{Sentence, is_unseen, repeated};
use serde::{Serialize, Serializer};
use serde_json::Value;

use crate::ExchangeError;
use crate::fields;

/// Bytes of a file, at most.
pub const MOST_BYTES: usize = 1 << 20;
/// Lines of a file in YAML, measures of any, at most.
const MOST: usize = 2000;
/// Deepest nesting of a file in XML.
const DEEPEST: usize = 32;

/// Measures of a body.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BodyMeasures {
    /// What the file is.
    pub format: &'static str,
    /// What was measured [cm], each once.
    pub measures: Vec<Taken>,
    /// Names of measures that a dancer is not built from, in the order of the file.
    pub unused: Vec<String>,
}

/// One measure.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Taken {
    /// What it is here.
    #[serde(serialize_with = "key")]
    pub measure: Measure,
    /// Its length [cm].
    pub cm: f64,
    /// What it was taken from: names of the file.
    pub from: &'static str,
}

/// A measure by its key in a document.
fn key<S: Serializer>(measure: &Measure, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(measure.key())
}

impl BodyMeasures {
    /// What was taken from where, and what was not used, as sentences.
    #[must_use]
    pub fn lines(&self) -> Vec<Sentence> {
        let count = self.measures.len();
        let mut lines = vec![Sentence::new(
            format!("{} の採寸: {count} か所", self.format),
            format!("measures of {}: {count}", self.format),
        )];
        for taken in &self.measures {
            let (words, cm, from) = (taken.measure.words(), taken.cm, taken.from);
            lines.push(Sentence::new(
                format!("{} {cm:.1} cm（{from}）", words.japanese),
                format!("{} {cm:.1} cm ({from})", words.english),
            ));
        }
        if !self.unused.is_empty() {
            let names = self.unused.join(", ");
            let shown: String = names.chars().take(600).collect();
            lines.push(Sentence::new(
                format!("使わなかった採寸: {shown}"),
                format!("not used: {shown}"),
            ));
        }
        lines
    }
}

/// A measure of a format: names whose sum it is, those with a minus taken away, and what it is here.
struct Row {
    terms: &'static [(&'static str, f64)],
    from: &'static str,
    measure: Measure,
}

macro_rules! rows {
    ($($measure:ident = $($from:literal)+;)*) => {
        &[$(rows!(@row $measure $($from)+),)*]
    };
    (@row $measure:ident $one:literal) => {
        Row { terms: &[($one, 1.0)], from: $one, measure: Measure::$measure }
    };
    (@row $measure:ident $first:literal $($less:literal)+) => {
        Row {
            terms: &[($first, 1.0), $(($less, -1.0)),+],
            from: concat!($first, $(" - ", $less),+),
            measure: Measure::$measure,
        }
    };
}

/// GarmentCode: centimeters. Lengths down the back from the nape are taken as upright.
const GARMENTCODE: &[Row] = rows! {
    Stature = "height";
    Bust = "bust";
    Underbust = "underbust";
    Waist = "waist";
    Hip = "hips";
    Thigh = "leg_circ";
    ShoulderBreadth = "shoulder_w";
    WaistHeight = "height" "head_l" "waist_line";
    Inseam = "height" "head_l" "waist_line" "hips_line" "crotch_hip_diff";
};

/// FreeSewing: millimeters. Its hips are the high hips, and its seat the fullest ones.
const FREESEWING: &[Row] = rows! {
    Bust = "chest";
    Underbust = "underbust";
    Waist = "waist";
    HighHip = "hips";
    Hip = "seat";
    Thigh = "upperLeg";
    Knee = "knee";
    Ankle = "ankle";
    Inseam = "inseam";
    WaistHeight = "waistToFloor";
    ShoulderBreadth = "shoulderToShoulder";
    UpperArmLength = "shoulderToElbow";
};

/// Seamly2D and Valentina: the unit is in the file.
const SEAMLY: &[Row] = rows! {
    Stature = "height";
    Bust = "bust_circ";
    Underbust = "lowbust_circ";
    Waist = "waist_circ";
    HighHip = "highhip_circ";
    Hip = "hip_circ";
    Thigh = "leg_thigh_upper_circ";
    Knee = "leg_knee_circ";
    Calf = "leg_calf_circ";
    Ankle = "leg_ankle_circ";
    Inseam = "leg_crotch_to_floor";
    WaistHeight = "height_waist_side";
    ShoulderBreadth = "shoulder_tip_to_shoulder_tip_b";
    UpperArmLength = "arm_shoulder_tip_to_elbow";
};

/// Reads a body file of GarmentCode (YAML), a measurement set of FreeSewing (JSON or YAML), or individual
/// measurements of Seamly2D or Valentina (`.smis`, `.vit`).
///
/// # Errors
/// The first thing that is wrong, in one sentence with its place.
pub fn read(bytes: &[u8]) -> Result<BodyMeasures, ExchangeError> {
    const WHAT: lole_language::Words = lole_language::words("採寸のファイル", "a file of measures");
    let bytes = fields::checked(bytes, WHAT, MOST_BYTES)?;
    let text = std::str::from_utf8(bytes).map_err(|error| {
        let line = 1 + bytes[..error.valid_up_to()]
            .iter()
            .filter(|it| **it == b'\n')
            .count();
        ExchangeError::unsewable(
            format!("line {line}"),
            "UTF-8 の文字ではありません。UTF-8 で保存し直してください",
            "this is no UTF-8; save the file as UTF-8",
        )
    })?;
    let start = text.trim_start();
    let (values, is_seamly) = if start.starts_with('<') {
        (xml(text)?, true)
    } else if start.starts_with('{') {
        (json(text)?, false)
    } else {
        (yaml(text)?, false)
    };
    if MOST < values.len() {
        return Err(ExchangeError::TooMany {
            place: "measures".to_owned(),
            what: WHAT,
            count: values.len(),
            most: MOST,
        });
    }
    let has = |name: &str| values.iter().any(|(other, _)| other == name);
    if is_seamly {
        taken("Seamly2D", SEAMLY, 1.0, &values)
    } else if has("chest") || has("seat") || has("waistToFloor") {
        taken("FreeSewing", FREESEWING, 0.1, &values)
    } else {
        taken("GarmentCode", GARMENTCODE, 1.0, &values)
    }
}

/// What the rows make of named values, in `unit` [cm].
fn taken(
    format: &'static str,
    rows: &[Row],
    unit: f64,
    values: &[(String, f64)],
) -> Result<BodyMeasures, ExchangeError> {
    let value = |name: &str| {
        values
            .iter()
            .find(|(other, _)| other == name)
            .map(|(_, value)| *value)
    };
    let mut measures = Vec::new();
    for row in rows {
        let terms = row
            .terms
            .iter()
            .map(|(name, sign)| Some(sign * value(name)?));
        let Some(sum) = terms.sum::<Option<f64>>() else {
            continue;
        };
        let cm = sum * unit;
        let [least, most] = row.measure.band_cm();
        if !(least..=most).contains(&cm) {
            let words = row.measure.words();
            return Err(ExchangeError::unsewable(
                row.from,
                format!(
                    "{}が {cm:.1} cm になります（{least} から {most} cm まで）。値と単位を確かめてください",
                    words.japanese
                ),
                format!(
                    "the {} would be {cm:.1} cm, and is {least} to {most} cm; check the value and its unit",
                    words.english
                ),
            ));
        }
        measures.push(Taken {
            measure: row.measure,
            cm,
            from: row.from,
        });
    }
    if measures.is_empty() {
        return Err(ExchangeError::unsewable(
            "measures",
            "知っている採寸が一つもありません。GarmentCode の体（YAML）、FreeSewing の採寸、Seamly の .smis を選んでください",
            "no measure in it is known; choose a body of GarmentCode (YAML), a measurement set of FreeSewing, or a .smis of Seamly",
        ));
    }
    let used = |name: &str| {
        rows.iter()
            .any(|row| row.terms.iter().any(|(term, _)| *term == name))
    };
    let unused = values.iter().filter(|(name, _)| !used(name));
    Ok(BodyMeasures {
        format,
        measures,
        unused: unused.map(|(name, _)| name.clone()).collect(),
    })
}

/// A name that can be shown.
fn named(name: &str, place: &str) -> Result<String, ExchangeError> {
    if name.is_empty() || name.chars().any(is_unseen) || name.chars().nth(100).is_some() {
        return Err(ExchangeError::wrong(
            place,
            &lole_language::visible(name),
            ("採寸の名前", "the name of a measure"),
        ));
    }
    Ok(name.to_owned())
}

/// Lines of `name: number`; what has no number, as the head of a part, is passed over.
fn yaml(text: &str) -> Result<Vec<(String, f64)>, ExchangeError> {
    let mut values = Vec::new();
    for (number, line) in (1..).zip(text.lines().take(MOST)) {
        let line = line.split(" #").next().unwrap_or_default();
        let line = line.trim();
        if line.is_empty() || line.starts_with('#') || line == "---" {
            continue;
        }
        let place = format!("line {number}");
        let Some((name, value)) = line.split_once(':') else {
            return Err(ExchangeError::wrong(
                place,
                &lole_language::visible(line),
                ("「名前: 数」の行", "a line of \"name: number\""),
            ));
        };
        let name = named(name.trim().trim_matches(['"', '\'']), &place)?;
        if let Ok(value) = value.trim().parse::<f64>() {
            if !value.is_finite() {
                return Err(ExchangeError::wrong(
                    place,
                    &repeated(line),
                    ("数", "a number"),
                ));
            }
            values.push((name, value));
        }
    }
    Ok(values)
}

/// Numbers of an object, or of one of those that measurement sets keep them in.
fn json(text: &str) -> Result<Vec<(String, f64)>, ExchangeError> {
    let value: Value = serde_json::from_str(text).map_err(|error| ExchangeError::NotJson {
        line: error.line(),
        column: error.column(),
    })?;
    let parts = ["measies", "measurements", "body"];
    let part = parts.iter().find_map(|name| value.get(*name));
    let object = part.unwrap_or(&value).as_object();
    let mut values = Vec::new();
    for (name, value) in object.into_iter().flatten().take(MOST + 1) {
        if value.is_number() {
            values.push((named(name, "measures")?, fields::number(value, name)?));
        }
    }
    Ok(values)
}

/// Measures of `.smis` and `.vit` [cm]; formulas are passed over.
fn xml(text: &str) -> Result<Vec<(String, f64)>, ExchangeError> {
    let not_xml = |line: u32| {
        ExchangeError::unsewable(
            format!("line {line}"),
            "XML ではありません。Seamly か Valentina で保存し直してください",
            "this is no XML; save the file again with Seamly or Valentina",
        )
    };
    let document = roxmltree::Document::parse(text).map_err(|error| not_xml(error.pos().row))?;
    let deep =
        |node: &roxmltree::Node<'_, '_>| DEEPEST < node.ancestors().take(DEEPEST + 2).count();
    if document
        .descendants()
        .take(4 * MOST)
        .any(|node| deep(&node))
    {
        return Err(not_xml(1));
    }
    let unit = document
        .descendants()
        .find(|node| node.has_tag_name("unit"));
    let unit = unit.and_then(|node| node.text()).map(str::trim);
    let cm = match unit {
        Some("mm") => 0.1,
        Some("cm") => 1.0,
        Some("inch") => 2.54,
        other => {
            return Err(ExchangeError::wrong(
                "<unit>",
                &lole_language::visible(other.unwrap_or("")),
                ("cm・mm・inch のどれか", "cm, mm or inch"),
            ));
        }
    };
    let mut values = Vec::new();
    for node in document
        .descendants()
        .filter(|node| node.has_tag_name("m"))
        .take(MOST + 1)
    {
        let place = format!("line {}", document.text_pos_at(node.range().start).row);
        let name = named(node.attribute("name").unwrap_or_default(), &place)?;
        let value = node
            .attribute("value")
            .and_then(|value| value.trim().parse::<f64>().ok());
        if let Some(value) = value.filter(|value| value.is_finite() && 0.0 < *value) {
            values.push((name, cm * value));
        }
    }
    Ok(values)
}
