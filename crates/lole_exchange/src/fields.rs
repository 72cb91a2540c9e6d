//! Files of text and the fields of a JSON file, read by name with the place of each for messages.

use lole_language::Words;
use serde_json::{Map, Value};

use crate::ExchangeError;

/// The bytes of a file of text without the mark that some programs begin it with, where it has at most so many.
pub(crate) fn checked(bytes: &[u8], what: Words, most: usize) -> Result<&[u8], ExchangeError> {
    if most < bytes.len() {
        return Err(ExchangeError::TooLarge {
            what,
            kilobytes: bytes.len() / 1000,
            most: most / 1000,
        });
    }
    Ok(bytes.strip_prefix("\u{feff}".as_bytes()).unwrap_or(bytes))
}

/// An object of a file and where it stands.
pub(crate) struct Fields<'a> {
    pub(crate) place: String,
    pub(crate) map: &'a Map<String, Value>,
    /// What kind of file it is, for messages.
    pub(crate) what: Words,
}

impl<'a> Fields<'a> {
    pub(crate) fn of(
        value: &'a Value,
        place: impl Into<String>,
        what: Words,
    ) -> Result<Self, ExchangeError> {
        let place = place.into();
        match value.as_object() {
            Some(map) => Ok(Self { place, map, what }),
            None => Err(ExchangeError::wrong(
                if place.is_empty() { "{}" } else { &place },
                &value.to_string(),
                ("{…} の形", "an object in braces"),
            )),
        }
    }

    pub(crate) fn at(&self, key: &str) -> String {
        if self.place.is_empty() {
            key.to_owned()
        } else {
            format!("{}.{key}", self.place)
        }
    }

    pub(crate) fn value(&self, key: &str) -> Result<&'a Value, ExchangeError> {
        self.map.get(key).ok_or_else(|| ExchangeError::Missing {
            place: self.at(key),
            what: self.what,
        })
    }

    pub(crate) fn object(&self, key: &str) -> Result<Self, ExchangeError> {
        Self::of(self.value(key)?, self.at(key), self.what)
    }

    pub(crate) fn list(&self, key: &str) -> Result<&'a [Value], ExchangeError> {
        let value = self.value(key)?;
        list(value, &self.at(key))
    }

    /// Numbers of a list that has exactly so many.
    pub(crate) fn numbers<const N: usize>(&self, key: &str) -> Result<[f64; N], ExchangeError> {
        numbers(self.value(key)?, &self.at(key))
    }
}

pub(crate) fn list<'a>(value: &'a Value, place: &str) -> Result<&'a [Value], ExchangeError> {
    value.as_array().map(Vec::as_slice).ok_or_else(|| {
        ExchangeError::wrong(
            place,
            &value.to_string(),
            ("[…] の並び", "a list in brackets"),
        )
    })
}

/// A number that is one.
pub(crate) fn number(value: &Value, place: &str) -> Result<f64, ExchangeError> {
    let found = value.as_f64().filter(|number| number.is_finite());
    found.ok_or_else(|| ExchangeError::wrong(place, &value.to_string(), ("数", "a number")))
}

/// A list of exactly so many numbers.
pub(crate) fn numbers<const N: usize>(
    value: &Value,
    place: &str,
) -> Result<[f64; N], ExchangeError> {
    let found = list(value, place)?;
    let read: Vec<f64> = found
        .iter()
        .map(|value| number(value, place))
        .collect::<Result<_, _>>()?;
    read.try_into().map_err(|_| {
        ExchangeError::wrong(
            place,
            &value.to_string(),
            (
                &format!("{N} 個の数の並び"),
                &format!("a list of {N} numbers"),
            ),
        )
    })
}

/// A whole number that is not negative.
pub(crate) fn index(value: &Value, place: &str) -> Result<usize, ExchangeError> {
    let found = value
        .as_u64()
        .and_then(|number| usize::try_from(number).ok());
    found.ok_or_else(|| {
        ExchangeError::wrong(
            place,
            &value.to_string(),
            ("0 以上の整数", "a whole number from 0 on"),
        )
    })
}
