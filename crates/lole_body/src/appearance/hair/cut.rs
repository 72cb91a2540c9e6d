//! Cuts of hair: where it begins and how far it stands off the skin.

use super::super::HairStyle;
use super::BUN_LATITUDE;

/// Latitude of the hairline [°] by longitude from the front [°]: forehead, temple, over the ear,
/// nape.
const COMBED_HAIRLINE: &[[f32; 2]] = &[
    [0.0, 39.0],
    [16.0, 38.0],
    [34.0, 33.0],
    [50.0, 23.0],
    [62.0, 12.0],
    [72.0, 3.0],
    [84.0, 1.0],
    [97.0, 3.0],
    [108.0, -9.0],
    [120.0, -27.0],
    [142.0, -39.0],
    [180.0, -43.0],
];
/// Height of the hair above the skin [mm] by the distance inside the hairline [°]: it rises gently
/// and stands fullest over the crown.
const COMBED_COVER: &[[f32; 2]] = &[
    [-12.0, -8.0],
    [-5.0, -1.8],
    [-1.0, -0.1],
    [2.0, 0.7],
    [6.0, 2.6],
    [12.0, 5.4],
    [22.0, 9.4],
    [38.0, 12.5],
    [70.0, 13.0],
];
/// A short cut: the forehead higher at the temples, sideburns, ears and nape free.
const SHORT_HAIRLINE: &[[f32; 2]] = &[
    [0.0, 38.0],
    [14.0, 38.5],
    [30.0, 38.0],
    [44.0, 30.0],
    [54.0, 17.0],
    [63.0, 6.0],
    [70.0, -3.0],
    [77.0, -7.0],
    [84.0, -1.0],
    [97.0, 3.0],
    [108.0, -6.0],
    [120.0, -21.0],
    [142.0, -31.0],
    [180.0, -34.0],
];
/// Close at the sides, fullest on top.
const SHORT_COVER: &[[f32; 2]] = &[
    [-12.0, -8.0],
    [-5.0, -1.8],
    [-1.0, -0.1],
    [2.0, 0.9],
    [6.0, 3.0],
    [12.0, 6.0],
    [22.0, 10.0],
    [38.0, 15.0],
    [60.0, 16.5],
    [95.0, 17.0],
];
/// A bob: a fringe over the forehead, then down beside the cheeks and around to the jaw.
const BOB_HAIRLINE: &[[f32; 2]] = &[
    [0.0, 15.0],
    [20.0, 14.5],
    [38.0, 12.0],
    [48.0, 6.0],
    [55.0, -8.0],
    [61.0, -30.0],
    [68.0, -45.0],
    [80.0, -50.0],
    [110.0, -51.0],
    [180.0, -51.0],
];
/// Straight hair of one thickness that ends at once.
const BOB_COVER: &[[f32; 2]] = &[
    [-12.0, -12.0],
    [-3.0, -3.0],
    [0.0, 2.0],
    [3.0, 7.0],
    [10.0, 10.0],
    [25.0, 12.0],
    [60.0, 13.0],
    [100.0, 13.0],
];

/// Where hair begins and how far it stands off.
pub(super) struct Cut {
    /// Latitude of the hairline [°] by longitude from the front [°].
    pub(super) hairline: &'static [[f32; 2]],
    /// Height above the skin [mm] by the distance inside the hairline [°].
    pub(super) cover: &'static [[f32; 2]],
    /// Where the locks come together: straight back, this much up [°].
    pub(super) crown_latitude: f32,
    /// Latitude [°] below which hair hangs straight.
    pub(super) hangs: Option<f32>,
}

impl Cut {
    pub(super) const fn of(style: HairStyle) -> Self {
        match style {
            HairStyle::OfFigure | HairStyle::Bun | HairStyle::Long => Self {
                hairline: COMBED_HAIRLINE,
                cover: COMBED_COVER,
                crown_latitude: BUN_LATITUDE,
                hangs: None,
            },
            HairStyle::Short => Self {
                hairline: SHORT_HAIRLINE,
                cover: SHORT_COVER,
                crown_latitude: 62.0,
                hangs: None,
            },
            HairStyle::Bob => Self {
                hairline: BOB_HAIRLINE,
                cover: BOB_COVER,
                crown_latitude: 66.0,
                hangs: Some(8.0),
            },
        }
    }
}
