//! JSON is counted before it is read: what takes three bytes in a file, such as an empty node, takes hundreds
//! in memory.

use std::cell::Cell;
use std::fmt;

use lole_language::words;
use serde::de::{DeserializeSeed, Deserializer, Error, MapAccess, SeqAccess, Visitor};

use crate::AvatarError;

/// Numbers, texts, lists and objects of a file, at most: the largest figures of games have a tenth.
pub(crate) const MOST_VALUES: usize = 500_000;

/// Checks how much a text would become.
///
/// # Errors
/// More than [`MOST_VALUES`]. Text that is no JSON passes: its reader says what is wrong.
pub(crate) fn check(text: &[u8]) -> Result<(), AvatarError> {
    let count = Cell::new(0);
    let mut reader = serde_json::Deserializer::from_slice(text);
    // Why it ended early does not matter here.
    drop(Counter(&count).deserialize(&mut reader));
    if MOST_VALUES < count.get() {
        return Err(AvatarError::TooLarge {
            what: words("個より多くの値", "values or more in its text"),
            count: count.get() as u64,
            limit: MOST_VALUES as u64,
        });
    }
    Ok(())
}

/// Counts values and keeps none.
#[derive(Clone, Copy)]
struct Counter<'a>(&'a Cell<usize>);

impl Counter<'_> {
    fn one<E: Error>(self) -> Result<(), E> {
        self.0.set(self.0.get() + 1);
        if MOST_VALUES < self.0.get() {
            return Err(E::custom("too many values"));
        }
        Ok(())
    }
}

impl<'de> DeserializeSeed<'de> for Counter<'_> {
    type Value = ();

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(), D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for Counter<'_> {
    type Value = ();

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("JSON")
    }

    fn visit_bool<E: Error>(self, _: bool) -> Result<(), E> {
        self.one()
    }

    fn visit_i64<E: Error>(self, _: i64) -> Result<(), E> {
        self.one()
    }

    fn visit_u64<E: Error>(self, _: u64) -> Result<(), E> {
        self.one()
    }

    fn visit_f64<E: Error>(self, _: f64) -> Result<(), E> {
        self.one()
    }

    fn visit_str<E: Error>(self, _: &str) -> Result<(), E> {
        self.one()
    }

    fn visit_unit<E: Error>(self) -> Result<(), E> {
        self.one()
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<(), A::Error> {
        self.one()?;
        while items.next_element_seed(self)?.is_some() {}
        Ok(())
    }

    fn visit_map<A: MapAccess<'de>>(self, mut items: A) -> Result<(), A::Error> {
        self.one()?;
        while items.next_key_seed(self)?.is_some() {
            items.next_value_seed(self)?;
        }
        Ok(())
    }
}
