//! A length as people write it in a cell: `91.4`, `９１．４cm`, `36 in`, `36"`, `5'4"`, `1.58 m`.

use lole_language::{Words, words};

use super::cells::Separator;

/// A unit of length.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Unit {
    Millimeter,
    Centimeter,
    Meter,
    Inch,
}

impl Unit {
    pub(super) const fn to_cm(self, number: f64) -> f64 {
        number
            * match self {
                Self::Millimeter => 0.1,
                Self::Centimeter => 1.0,
                Self::Meter => 100.0,
                Self::Inch => 2.54,
            }
    }

    pub(super) const fn abbreviation(self) -> &'static str {
        match self {
            Self::Millimeter => "mm",
            Self::Centimeter => "cm",
            Self::Meter => "m",
            Self::Inch => "in",
        }
    }

    pub(super) const fn name(self) -> Words {
        match self {
            Self::Millimeter => words("ミリ", "millimeters"),
            Self::Centimeter => words("センチ", "centimeters"),
            Self::Meter => words("メートル", "meters"),
            Self::Inch => words("インチ", "inches"),
        }
    }

    /// The unit of this name, in lower case.
    pub(super) fn of(name: &str) -> Option<Self> {
        Some(match name.trim_end_matches('.') {
            "mm" | "ミリ" => Self::Millimeter,
            "cm" | "㎝" | "センチ" | "センチメートル" | "centimeter" | "centimeters" => {
                Self::Centimeter
            }
            "m" | "メートル" => Self::Meter,
            "in" | "inch" | "inches" | "インチ" | "\"" | "”" | "″" | "''" => Self::Inch,
            _ => return None,
        })
    }
}

/// What a cell says.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Reading {
    Empty,
    /// A number without a unit.
    Plain(f64),
    /// A number with its unit [cm].
    Length(f64),
    NoNumber,
}

/// Whether a dancer can have this [cm] of a measure that lies in this band.
pub(super) fn fits([least, most]: [f64; 2], cm: f64) -> bool {
    (least..=most).contains(&cm)
}

/// Reads a cell.
pub(super) fn read(cell: &str, separator: Separator) -> Reading {
    let cell = narrow(cell);
    let cell = cell.trim();
    if cell.is_empty() || matches!(cell, "-" | "–" | "—" | "?" | "n/a" | "なし" | "未測定")
    {
        return Reading::Empty;
    }
    if let Some(cm) = feet(cell) {
        return Reading::Length(cm);
    }
    if let Some(reading) = fraction(cell) {
        return reading;
    }
    let end = cell
        .find(|letter: char| !letter.is_ascii_digit() && !".,+".contains(letter))
        .unwrap_or(cell.len());
    let (number, unit) = cell.split_at(end);
    let Some(number) = decimal(number, separator) else {
        return Reading::NoNumber;
    };
    match unit.trim() {
        "" => Reading::Plain(number),
        unit => Unit::of(unit).map_or(Reading::NoNumber, |unit| {
            Reading::Length(unit.to_cm(number))
        }),
    }
}

/// Feet and inches: `5'4"`, `5 ft 4 in`.
fn feet(cell: &str) -> Option<f64> {
    let (feet, rest) = cell
        .split_once("ft")
        .or_else(|| cell.split_once(['\'', '’', '′']))?;
    let feet: f64 = feet.trim().parse().ok()?;
    let inches = rest
        .trim()
        .trim_end_matches(|letter: char| !letter.is_ascii_digit());
    let inches: f64 = match inches {
        "" => 0.0,
        inches => inches.parse().ok()?,
    };
    let is_length = (0.0..10.0).contains(&feet) && (0.0..12.0).contains(&inches);
    is_length.then_some((12.0 * feet + inches) * 2.54)
}

/// A number with eighths or the like, as rulers in inches are read: `37 1/2`, `37 1/2 in`.
fn fraction(cell: &str) -> Option<Reading> {
    let (whole, rest) = cell.split_once(' ')?;
    let (over, rest) = rest.trim_start().split_once('/')?;
    let end = rest.find(|letter: char| !letter.is_ascii_digit());
    let (under, unit) = rest.split_at(end.unwrap_or(rest.len()));
    let whole: u16 = whole.parse().ok()?;
    let (over, under): (u16, u16) = (over.parse().ok()?, under.parse().ok()?);
    if under <= over {
        return None;
    }
    let number = f64::from(whole) + f64::from(over) / f64::from(under);
    match unit.trim() {
        "" => Some(Reading::Plain(number)),
        unit => Unit::of(unit).map(|unit| Reading::Length(unit.to_cm(number))),
    }
}

/// A finite positive number; its decimals may follow a comma, which within a cell parts no columns.
fn decimal(number: &str, separator: Separator) -> Option<f64> {
    let is_decimal_comma = || {
        let mut parts = number.split(',');
        let decimals = parts.nth(1).is_some_and(|decimals| decimals.len() < 3);
        decimals && parts.next().is_none()
    };
    let number = match separator {
        Separator::Comma if !is_decimal_comma() => number.to_owned(),
        _ => number.replace(',', "."),
    };
    let number: f64 = number.parse().ok()?;
    (number.is_finite() && 0.0 <= number).then_some(number)
}

/// Katakana from U+FF66 on, in the order of their half-width forms.
const KATAKANA: &str = "ヲァィゥェォャュョッーアイウエオカキクケコサシスセソタチツテトナニヌネノハヒフヘホマミムメモヤユヨラリルレロワン";

/// Full-width letters as narrow ones, in lower case; half-width kana, and kana whose marks are letters of
/// their own, as everybody writes them.
pub(super) fn narrow(text: &str) -> String {
    let mut narrowed = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '\u{ff01}'..='\u{ff5e}' => {
                narrowed.extend(char::from_u32(u32::from(letter) - 0xfee0));
            }
            '\u{3000}' | '\u{a0}' => narrowed.push(' '),
            '\u{ff66}'..='\u{ff9d}' => {
                let place = u32::from(letter) - 0xff66;
                narrowed.extend(KATAKANA.chars().nth(place as usize));
            }
            'ﾞ' | '\u{3099}' => mark(&mut narrowed, 1),
            'ﾟ' | '\u{309a}' => mark(&mut narrowed, 2),
            _ => narrowed.push(letter),
        }
    }
    narrowed.to_lowercase()
}

/// Puts a voiced mark (1) or a half-voiced one (2) on the last letter, where it can have one.
fn mark(text: &mut String, mark: u32) {
    let Some(last) = text.pop() else { return };
    let takes = match last {
        'ウ' => mark == 1,
        'は' | 'ひ' | 'ふ' | 'へ' | 'ほ' | 'ハ' | 'ヒ' | 'フ' | 'ヘ' | 'ホ' => true,
        _ => {
            mark == 1
                && "かきくけこさしすせそたちつてとカキクケコサシスセソタチツテト".contains(last)
        }
    };
    let marked = match last {
        'ウ' if takes => Some('ヴ'),
        _ if takes => char::from_u32(u32::from(last) + mark),
        _ => None,
    };
    text.push(marked.unwrap_or(last));
}
