//! Keys of the alterations of fitted garments, one row each.

use lole_language::words;
use lole_pattern::Alteration;

use super::{Key, Kind, Table};

/// An alteration, nothing at first.
macro_rules! altered {
    ($alteration:expr) => {
        Key {
            name: $alteration.key(),
            about: $alteration.about(),
            kind: Kind::Number {
                min: $alteration.band_cm()[0],
                max: $alteration.band_cm()[1],
                get: |design| {
                    let cm = design.alterations.cm($alteration);
                    (cm != 0.0).then_some(cm)
                },
                set: |design, value| {
                    design.alterations = design.alterations.with_cm($alteration, value);
                },
            },
        }
    };
}

pub(super) const ALTERATIONS: Table = Table {
    name: "alterations",
    about: words(
        "仮縫いで分かった補正（cm）。ブラウス・ムウムウ・ホロクーの型紙を引き直す",
        "what a trial in basted cloth has shown [cm]; blouse, muʻumuʻu and holokū are drafted anew",
    ),
    keys: &[
        altered!(Alteration::FullBust),
        altered!(Alteration::RoundBack),
        altered!(Alteration::SwayBack),
        altered!(Alteration::SlopingShoulders),
        altered!(Alteration::BroadBack),
        altered!(Alteration::FullArm),
    ],
};
