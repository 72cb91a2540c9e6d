//! Ready sets of colors: of a ground, flowers, leaves and a quiet second layer.
//!
//! The colors of the eight islands are those of their flowers and leaves, by which costumes are
//! chosen; the shades themselves are this program's. With the motif `plain` they are plain cloth.

use lole_language::{Words, words};

/// A ready set of colors, sRGB bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Colorway {
    /// Name in documents.
    pub id: &'static str,
    /// What it is called.
    pub name: Words,
    /// Color of the ground.
    pub ground: [u8; 3],
    /// Color of the flowers, or of the fruit.
    pub flower: [u8; 3],
    /// Color of the large leaves.
    pub leaf: [u8; 3],
    /// Color of the quiet second layer, close to the ground.
    pub shadow: [u8; 3],
}

/// Red, green and blue of `0xrrggbb`.
const fn rgb(hex: u32) -> [u8; 3] {
    let [_, red, green, blue] = hex.to_be_bytes();
    [red, green, blue]
}

const fn colorway(
    id: &'static str,
    name: Words,
    [ground, flower, leaf, shadow]: [u32; 4],
) -> Colorway {
    Colorway {
        id,
        name,
        ground: rgb(ground),
        flower: rgb(flower),
        leaf: rgb(leaf),
        shadow: rgb(shadow),
    }
}

/// Every ready set; the first is the default.
pub const COLORWAYS: &[Colorway] = &[
    colorway(
        "red",
        words("赤", "red"),
        [0x9e1026, 0xfcf0de, 0xeeb246, 0x7e081e],
    ),
    colorway(
        "pink",
        words("ピンク", "pink"),
        [0xce286e, 0xfff6f0, 0xfabecd, 0xb0185c],
    ),
    colorway(
        "blue",
        words("青", "blue"),
        [0x0e3e86, 0xfafaf5, 0x78bed7, 0x082e6c],
    ),
    colorway(
        "green",
        words("緑", "green"),
        [0x085c42, 0xfcf4dc, 0x96c878, 0x044834],
    ),
    colorway(
        "black",
        words("黒", "black"),
        [0x17181a, 0xf4ead6, 0xb58a3f, 0x2a2b2e],
    ),
    colorway(
        "cream",
        words("生成り", "cream"),
        [0xf6ecd6, 0xb23a2e, 0x3f6b4a, 0xe6d8ba],
    ),
    colorway(
        "teal",
        words("青緑", "teal"),
        [0x0a6f78, 0xfdf3e0, 0xf0a06a, 0x075c64],
    ),
    colorway(
        "earth",
        words("土色", "earth"),
        [0x5a2c1c, 0xf2dfbd, 0xc7873e, 0x451f13],
    ),
    colorway(
        "oahu",
        words("オアフの黄（イリマ）", "Oʻahu yellow (ʻilima)"),
        [0xf2b71c, 0xfff7e0, 0xc4501b, 0xe5a40e],
    ),
    colorway(
        "maui",
        words("マウイのピンク（ロケラニ）", "Maui pink (lokelani)"),
        [0xe7799f, 0xfff6f2, 0x9c2152, 0xdd6690],
    ),
    colorway(
        "kauai",
        words("カウアイの紫（モキハナ）", "Kauaʻi purple (mokihana)"),
        [0x5b2d82, 0xf6edfb, 0xb78fd6, 0x4b226e],
    ),
    colorway(
        "hawaii",
        words("ハワイ島の赤（レフア）", "Hawaiʻi red (lehua)"),
        [0xc1121f, 0xfff3e2, 0xf4a742, 0xa60b18],
    ),
    colorway(
        "molokai",
        words("モロカイの緑（ククイ）", "Molokaʻi green (kukui)"),
        [0x2f7d43, 0xfbf8e6, 0xb8d68c, 0x266b38],
    ),
    colorway(
        "lanai",
        words("ラナイのオレンジ（カウナオア）", "Lānaʻi orange (kaunaʻoa)"),
        [0xe8711a, 0xfff5e4, 0x8f2d12, 0xd9620f],
    ),
    colorway(
        "niihau",
        words("ニイハウの白（プープー・貝）", "Niʻihau white (pūpū shell)"),
        [0xfaf7f0, 0x8a6f5a, 0xc9b49a, 0xf0eadd],
    ),
    colorway(
        "kahoolawe",
        words("カホオラヴェの灰（ヒナヒナ）", "Kahoʻolawe gray (hinahina)"),
        [0x8b9194, 0xf7f6f1, 0x4d5a5f, 0x7f8588],
    ),
];

impl Colorway {
    /// The set of this name.
    #[must_use]
    pub fn from_id(id: &str) -> Option<&'static Self> {
        COLORWAYS.iter().find(|way| way.id == id)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_set_has_its_own_name_and_a_ground_that_its_motifs_stand_out_from() {
        for (place, way) in COLORWAYS.iter().enumerate() {
            assert_eq!(
                Colorway::from_id(way.id),
                Some(&COLORWAYS[place]),
                "{}",
                way.id
            );
            let luma = |[red, green, blue]: [u8; 3]| {
                0.30 * f64::from(red) + 0.59 * f64::from(green) + 0.11 * f64::from(blue)
            };
            let contrast = |color| (luma(color) - luma(way.ground)).abs();
            assert!(40.0 < contrast(way.flower), "{}: flowers", way.id);
            assert!(40.0 < contrast(way.leaf), "{}: leaves", way.id);
            let quiet = contrast(way.shadow);
            assert!((4.0..32.0).contains(&quiet), "{}: shadow {quiet}", way.id);
        }
    }
}
