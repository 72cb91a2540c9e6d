//! Heads of columns, in Japanese and English.

use lole_body::{Figure, Measure};
use lole_language::{Sentence, Words, words};
use lole_pattern::{Alteration, Tailored};

use super::RosterError;
use super::cells::Record;
use super::lengths::{Unit, narrow};
use crate::document::schema::{self, Kind};

/// A column that is read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Column {
    /// Its place, from 0.
    pub(super) index: usize,
    /// As it is written.
    pub(super) head: String,
    pub(super) meaning: Meaning,
    /// Of its numbers, where the head says so.
    pub(super) unit: Option<Unit>,
}

/// What a column holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Meaning {
    Name,
    Figure,
    Age,
    Measure(Measure),
    /// What drafts go by and no body is built from.
    Tailored(Tailored),
    /// How fitted garments are altered for her.
    Alteration(Alteration),
}

impl Meaning {
    /// What a column is called.
    pub(super) const fn words(self) -> Words {
        match self {
            Self::Name => words("名前", "name"),
            Self::Figure => words("体型", "figure"),
            Self::Age => words("年齢", "age"),
            Self::Measure(measure) => measure.words(),
            Self::Tailored(tailored) => tailored.name(),
            Self::Alteration(alteration) => alteration.name(),
        }
    }

    /// What a tape can say of anybody [cm]; `None` of what no tape says.
    pub(super) const fn taped_cm(self) -> Option<[f64; 2]> {
        match self {
            Self::Measure(measure) => Some(measure.band_cm()),
            Self::Tailored(tailored) => Some(tailored.band_cm()),
            Self::Name | Self::Figure | Self::Age | Self::Alteration(_) => None,
        }
    }
}

/// Heads that people write, without spaces, units and case.
const HEADS: &[(Meaning, &[&str])] = &[
    (
        Meaning::Name,
        &[
            "名前",
            "氏名",
            "お名前",
            "なまえ",
            "姓名",
            "踊り手",
            "name",
            "fullname",
            "dancer",
        ],
    ),
    (
        Meaning::Figure,
        &["体型", "体形", "性別", "figure", "sex", "gender"],
    ),
    (Meaning::Age, &["年齢", "年令", "年齢歳", "age", "ageyears"]),
    (
        Meaning::Measure(Measure::Stature),
        &["身長", "stature", "height", "bodyheight"],
    ),
    (
        Meaning::Measure(Measure::Bust),
        &[
            "バスト",
            "胸囲",
            "胸回り",
            "胸まわり",
            "bust",
            "chest",
            "bustgirth",
        ],
    ),
    (
        Meaning::Measure(Measure::Underbust),
        &["アンダーバスト", "アンダー", "underbust", "underbustgirth"],
    ),
    (
        Meaning::Measure(Measure::Waist),
        &[
            "ウエスト",
            "ウェスト",
            "胴囲",
            "胴回り",
            "胴まわり",
            "waist",
            "waistgirth",
        ],
    ),
    (
        Meaning::Measure(Measure::HighHip),
        &[
            "腰骨回り",
            "腰骨まわり",
            "ミドルヒップ",
            "中ヒップ",
            "highhip",
            "middlehip",
            "highhipgirth",
        ],
    ),
    (
        Meaning::Measure(Measure::Hip),
        &[
            "ヒップ",
            "腰囲",
            "腰回り",
            "腰まわり",
            "尻囲",
            "hip",
            "hips",
            "hipgirth",
        ],
    ),
    (
        Meaning::Measure(Measure::Thigh),
        &[
            "太もも回り",
            "太ももまわり",
            "太もも",
            "わたり",
            "thigh",
            "thighgirth",
        ],
    ),
    (
        Meaning::Measure(Measure::Knee),
        &["ひざ回り", "ひざまわり", "膝回り", "knee", "kneegirth"],
    ),
    (
        Meaning::Measure(Measure::Calf),
        &[
            "ふくらはぎ回り",
            "ふくらはぎまわり",
            "ふくらはぎ",
            "calf",
            "calfgirth",
        ],
    ),
    (
        Meaning::Measure(Measure::Ankle),
        &["足首回り", "足首まわり", "足首", "ankle", "anklegirth"],
    ),
    (
        Meaning::Measure(Measure::Inseam),
        &["股下", "またした", "inseam", "inseamlength", "insideleg"],
    ),
    (
        Meaning::Measure(Measure::WaistHeight),
        &["ウエストの高さ", "ウエスト高", "waistheight"],
    ),
    (
        Meaning::Measure(Measure::ShoulderBreadth),
        &[
            "肩幅",
            "背肩幅",
            "shoulderbreadth",
            "shoulderwidth",
            "shoulder",
            "shoulders",
        ],
    ),
    (
        Meaning::Measure(Measure::UpperArmLength),
        &[
            "上腕の長さ",
            "上腕長",
            "上腕丈",
            "ひじ丈",
            "肘丈",
            "upperarmlength",
            "shouldertoelbow",
        ],
    ),
    (
        Meaning::Tailored(Tailored::Neck),
        &[
            "首回り",
            "首まわり",
            "首周り",
            "首囲",
            "頸囲",
            "頚囲",
            "ネック",
            "ネックサイズ",
            "首の付け根回り",
            "首の付け根まわり",
            "首の付け根周り",
            "首の付け根の周り",
            "neck",
            "neckgirth",
            "neckcircumference",
        ],
    ),
    (
        Meaning::Tailored(Tailored::BackBreadth),
        &["背幅", "背巾", "backbreadth", "backwidth", "acrossback"],
    ),
    (
        Meaning::Tailored(Tailored::ChestBreadth),
        &[
            "胸幅",
            "胸巾",
            "chestbreadth",
            "chestwidth",
            "acrosschest",
            "acrossfront",
        ],
    ),
    (
        Meaning::Tailored(Tailored::BackLength),
        &[
            "背丈",
            "後ろ丈",
            "後丈",
            "backlength",
            "napetowaist",
            "backwaistlength",
        ],
    ),
    (
        Meaning::Tailored(Tailored::FrontLength),
        &["前丈", "前身丈", "frontlength", "frontwaistlength"],
    ),
    (
        Meaning::Tailored(Tailored::BustPoints),
        &[
            "乳間",
            "乳間幅",
            "乳頭間",
            "乳頭の間隔",
            "バストポイント間",
            "バストポイントの間隔",
            "bp間",
            "bustpointdistance",
            "bustpoints",
            "bustspan",
            "apextoapex",
        ],
    ),
    (
        Meaning::Tailored(Tailored::UpperArm),
        &[
            "腕回り",
            "腕まわり",
            "腕周り",
            "上腕回り",
            "上腕まわり",
            "上腕周り",
            "上腕の周り",
            "上腕囲",
            "腕囲",
            "上腕",
            "二の腕",
            "二の腕回り",
            "二の腕まわり",
            "二の腕周り",
            "upperarm",
            "upperarmgirth",
            "upperarmcircumference",
            "armgirth",
            "bicep",
            "biceps",
        ],
    ),
    (
        Meaning::Tailored(Tailored::Wrist),
        &[
            "手首回り",
            "手首まわり",
            "手首周り",
            "手首囲",
            "手首",
            "wrist",
            "wristgirth",
        ],
    ),
    (
        Meaning::Tailored(Tailored::ArmLength),
        &[
            "袖丈",
            "腕丈",
            "腕の長さ",
            "armlength",
            "sleeve",
            "sleevelength",
        ],
    ),
    (
        Meaning::Tailored(Tailored::CrotchLength),
        &[
            "股上前後長",
            "股上前後",
            "前後股上",
            "股ぐり",
            "股ぐり長",
            "crotchlength",
        ],
    ),
    (
        Meaning::Tailored(Tailored::Head),
        &[
            "頭回り",
            "頭まわり",
            "頭周り",
            "頭囲",
            "head",
            "headgirth",
            "headcircumference",
        ],
    ),
    (
        Meaning::Alteration(Alteration::FullBust),
        &["胸の補正", "胸補正", "fullbust"],
    ),
    (
        Meaning::Alteration(Alteration::RoundBack),
        &["猫背の補正", "猫背補正", "猫背", "roundback"],
    ),
    (
        Meaning::Alteration(Alteration::SwayBack),
        &["反り腰の補正", "反り腰補正", "反り腰", "swayback"],
    ),
    (
        Meaning::Alteration(Alteration::SlopingShoulders),
        &[
            "なで肩の補正",
            "なで肩補正",
            "なで肩",
            "slopingshoulders",
            "slopingshoulder",
        ],
    ),
    (
        Meaning::Alteration(Alteration::BroadBack),
        &["背幅の補正", "背幅補正", "broadback"],
    ),
    (
        Meaning::Alteration(Alteration::FullArm),
        &["腕の補正", "腕補正", "fullarm"],
    ),
];

/// Without these nothing can be sized or told apart.
pub(super) const NEEDED: [Meaning; 2] = [Meaning::Name, Meaning::Measure(Measure::Hip)];

/// The columns of a row of heads, and notes on those that are not read.
pub(super) fn read(
    head: &Record,
    needed: &[Meaning],
) -> Result<(Vec<Column>, Vec<Sentence>), RosterError> {
    let mut columns: Vec<Column> = Vec::new();
    let mut unknown = Vec::new();
    for index in 0..head.cells.len() {
        let written = head.cell(index);
        if written.is_empty() {
            continue;
        }
        let Some((meaning, unit)) = meaning_of(written) else {
            unknown.push(written.to_owned());
            continue;
        };
        if let Some(first) = columns.iter().find(|column| column.meaning == meaning) {
            return Err(RosterError::TwiceColumn {
                line: head.line,
                column: meaning.words(),
                first: first.index + 1,
                second: index + 1,
            });
        }
        columns.push(Column {
            index,
            head: written.to_owned(),
            meaning,
            unit,
        });
    }
    let has = |meaning: Meaning| columns.iter().any(|column| column.meaning == meaning);
    if let Some(missing) = needed.iter().copied().find(|&meaning| !has(meaning)) {
        return Err(RosterError::MissingColumn {
            line: head.line,
            column: missing.words(),
        });
    }
    Ok((columns, notes(&unknown)))
}

/// How many cells of a row are heads.
pub(super) fn known_count(row: &Record) -> usize {
    let cells = (0..row.cells.len()).map(|index| row.cell(index));
    cells.filter(|cell| meaning_of(cell).is_some()).count()
}

fn notes(unknown: &[String]) -> Vec<Sentence> {
    if unknown.is_empty() {
        return Vec::new();
    }
    vec![Sentence::new(
        format!("次の列は読みませんでした: {}", unknown.join("、")),
        format!("These columns were not read: {}", unknown.join(", ")),
    )]
}

/// What a head says, and the unit of its numbers: `ヒップ cm` and `ヒップcm` alike.
fn meaning_of(head: &str) -> Option<(Meaning, Option<Unit>)> {
    let meaning_of = |name: &str| {
        let row = HEADS.iter().find(|(_, names)| names.contains(&name));
        row.map(|&(meaning, _)| meaning)
    };
    let (name, unit) = name_and_unit(head);
    if let Some(meaning) = meaning_of(&name) {
        return Some((meaning, unit));
    }
    let mut glued = name.char_indices().skip(1).map(|(at, _)| name.split_at(at));
    glued.find_map(|(name, end)| Some((meaning_of(name)?, Some(Unit::of(end)?))))
}

/// `ヒップ（cm）`, `hip_cm`, `Hip [in]`, `hip inches` without its unit.
fn name_and_unit(head: &str) -> (String, Option<Unit>) {
    let head = narrow(head);
    let words = head.split(|letter: char| " _()[]:/・-".contains(letter));
    let mut words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
    let unit = words.last().and_then(|last| Unit::of(last));
    if unit.is_some() && 1 < words.len() {
        words.pop();
    }
    (words.concat(), unit)
}

/// Whose proportions a cell names; `None` of an empty one.
pub(super) fn figure(cell: &str) -> Result<Option<Figure>, ()> {
    Ok(Some(match narrow(cell).trim() {
        "" => return Ok(None),
        "女性" | "女" | "woman" | "female" | "f" | "w" => Figure::Woman,
        "男性" | "男" | "man" | "male" | "m" => Figure::Man,
        "子ども" | "子供" | "こども" | "ケイキ" | "child" | "keiki" => Figure::Child,
        _ => return Err(()),
    }))
}

/// How old a cell says she is [years], `67`, `６７歳` or `60代`, of which the middle counts; `None` of an empty one.
pub(super) fn age(cell: &str) -> Result<Option<f64>, ()> {
    let cell = narrow(cell);
    let number = cell.trim().trim_end_matches(['歳', '才']).trim_end();
    if matches!(number, "" | "-") {
        return Ok(None);
    }
    let (number, more) = match number.strip_suffix('代') {
        Some(decade) => (decade, 5.0),
        None => (number, 0.0),
    };
    let years = number.parse::<f64>().map_err(drop)? + more;
    let [youngest, oldest] = ages();
    (youngest..=oldest)
        .contains(&years)
        .then_some(Some(years))
        .ok_or(())
}

/// Youngest and oldest dancer [years], as a design may have them.
pub(super) fn ages() -> [f64; 2] {
    match schema::key("dancer", "age_years").map(|key| &key.kind) {
        Some(Kind::Number { min, max, .. }) => [*min, *max],
        _ => [0.0, f64::INFINITY],
    }
}
