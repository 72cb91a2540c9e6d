//! What panels of files are called here: by their numbers, because pieces have names that the program knows.

use lole_language::{Words, words};

macro_rules! numbered {
    ($($number:literal)*) => {
        const IDS: &[&str] = &[$(concat!("panel-", $number),)*];
        const WORDS: &[Words] = &[$(words(
            concat!($number, " 番の型紙"),
            concat!("panel ", $number),
        ),)*];
    };
}

numbered!(
    1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20
    21 22 23 24 25 26 27 28 29 30 31 32 33 34 35 36 37 38 39 40
    41 42 43 44 45 46 47 48 49 50 51 52 53 54 55 56 57 58 59 60
    61 62 63 64 65 66 67 68 69 70 71 72 73 74 75 76 77 78 79 80
    81 82 83 84 85 86 87 88 89 90 91 92 93 94 95 96 97 98 99 100
);

/// Panels of a garment, at most.
pub const MOST_PANELS: usize = IDS.len();

/// Identifier of the panel at a place, from 0.
#[must_use]
pub fn panel_id(place: usize) -> &'static str {
    IDS[place.min(MOST_PANELS - 1)]
}

/// What the panel at a place, from 0, is called.
#[must_use]
pub fn number_words(place: usize) -> Words {
    WORDS[place.min(MOST_PANELS - 1)]
}
