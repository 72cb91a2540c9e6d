//! The presets themselves, one entry for each fabric.
//!
//! Stretch and shear taken from Wang, O'Brien and Ramamoorthi 2011 are the figures as published in
//! their material files, near rest; their loader doubles them, so take them as an order of
//! magnitude. A skirt loads its band with about 1 N/m, where any of them stretches little.
//! The larger of two stretch figures is taken for the warp, and 0° of bending for the warp.

use super::{Figure, Preset, Provenance};

const fn measured<T: Copy>(value: T) -> Figure<T> {
    Figure {
        value,
        provenance: Provenance::Measured,
    }
}

const fn derived<T: Copy>(value: T) -> Figure<T> {
    Figure {
        value,
        provenance: Provenance::Derived,
    }
}

const fn estimated<T: Copy>(value: T) -> Figure<T> {
    Figure {
        value,
        provenance: Provenance::Estimated,
    }
}

/// Every fabric on the shelf; the first is the pāʻū skirt's default.
pub const PRESETS: &[Preset] = &[
    Preset {
        id: "polycotton-broadcloth",
        name: "Polyester/cotton broadcloth 65/35",
        name_ja: "ポリエステル綿ブロード 65/35",
        areal_density: derived(110.0),
        thickness: estimated(0.22),
        stretch: measured([4500.0, 2800.0]),
        shear: estimated(90.0),
        bend: estimated([9.0, 6.0]),
        twist: estimated(7.35),
        friction: estimated(0.45),
        source: "Stretch by proxy: cotton of Clyde, Teran and Tamstorf 2017. Weight from 4 oz per linear yard at 44.5 in.",
    },
    Preset {
        id: "cotton-lawn",
        name: "Cotton lawn or poplin",
        name_ja: "綿ローン・ポプリン",
        areal_density: measured(104.0),
        thickness: measured(0.18),
        stretch: measured([4500.0, 2800.0]),
        shear: estimated(60.0),
        bend: estimated([6.0, 4.0]),
        twist: estimated(4.9),
        friction: estimated(0.5),
        source: "Cotton of Clyde, Teran and Tamstorf 2017; its shear of 194 N/m holds at high strain, the estimate near rest.",
    },
    Preset {
        id: "cotton-sheeting",
        name: "Cotton sheeting or muslin",
        name_ja: "シーチング・生成り綿",
        areal_density: measured(150.0),
        thickness: measured(0.32),
        stretch: estimated([2000.0, 2000.0]),
        shear: estimated(60.0),
        bend: estimated([15.0, 10.0]),
        twist: estimated(12.25),
        friction: estimated(0.5),
        source: "Weight and thickness: Penava et al. 2014; published stretch runs from 261 to 3500 N/m.",
    },
    Preset {
        id: "barkcloth",
        name: "Barkcloth, heavy 65/35",
        name_ja: "バーククロス（厚手）",
        areal_density: measured(220.0),
        thickness: estimated(0.45),
        stretch: measured([2017.0, 2035.0]),
        shear: measured(105.0),
        bend: measured([125.0, 125.0]),
        twist: derived(91.0),
        friction: estimated(0.5),
        source: "Woven 65/35 trousers of Wang, O'Brien and Ramamoorthi 2011 (royal-target).",
    },
    Preset {
        id: "rayon-challis",
        name: "Rayon challis",
        name_ja: "レーヨン・チャリス",
        areal_density: derived(120.0),
        thickness: estimated(0.2),
        stretch: estimated([1500.0, 900.0]),
        shear: estimated(22.0),
        bend: estimated([3.0, 2.0]),
        twist: estimated(2.45),
        friction: estimated(0.35),
        source: "Weight from shop listings of 100 to 145 g/m².",
    },
    Preset {
        id: "polyester-satin",
        name: "Polyester satin or charmeuse",
        name_ja: "ポリエステルサテン",
        areal_density: measured(85.0),
        thickness: measured(0.18),
        stretch: measured([1790.0, 774.0]),
        shear: estimated(25.0),
        bend: estimated([2.0, 1.2]),
        twist: estimated(1.55),
        friction: estimated(0.3),
        source: "Silk charmeuse of Clyde, Teran and Tamstorf 2017; its shear of 103 N/m holds at high strain.",
    },
    Preset {
        id: "polyester-print",
        name: "Plain polyester print",
        name_ja: "ポリエステルプリント",
        areal_density: measured(165.0),
        thickness: measured(0.25),
        stretch: estimated([2000.0, 2000.0]),
        shear: estimated(20.0),
        bend: estimated([30.0, 20.0]),
        twist: estimated(24.49),
        friction: estimated(0.35),
        source: "Weight and thickness: Penava et al. 2014; the rest by proxy.",
    },
    Preset {
        id: "light-polyester",
        name: "Light woven polyester",
        name_ja: "薄手ポリエステル",
        areal_density: measured(113.0),
        thickness: estimated(0.2),
        stretch: measured([171.0, 43.0]),
        shear: measured(14.0),
        bend: measured([14.0, 20.0]),
        twist: derived(27.0),
        friction: estimated(0.35),
        source: "Jacket of Wang, O'Brien and Ramamoorthi 2011 (tango-red-jet-set).",
    },
    Preset {
        id: "stretch-velvet",
        name: "Stretch velvet",
        name_ja: "ストレッチベロア",
        areal_density: estimated(250.0),
        thickness: estimated(0.9),
        stretch: estimated([40.0, 25.0]),
        shear: estimated(30.0),
        bend: estimated([30.0, 35.0]),
        twist: estimated(32.4),
        friction: estimated(0.5),
        source: "By proxy of a 96/4 polyester knit of Wang, O'Brien and Ramamoorthi 2011.",
    },
    Preset {
        id: "woven-velvet",
        name: "Woven velvet",
        name_ja: "ベルベット",
        areal_density: estimated(290.0),
        thickness: estimated(1.0),
        stretch: estimated([2000.0, 1500.0]),
        shear: estimated(50.0),
        bend: estimated([60.0, 40.0]),
        twist: estimated(48.99),
        friction: estimated(0.55),
        source: "Estimated by comparison.",
    },
    Preset {
        id: "chiffon",
        name: "Chiffon or georgette",
        name_ja: "シフォン・ジョーゼット",
        areal_density: estimated(55.0),
        thickness: estimated(0.15),
        stretch: estimated([800.0, 600.0]),
        shear: estimated(8.0),
        bend: estimated([0.5, 0.4]),
        twist: estimated(0.45),
        friction: estimated(0.3),
        source: "Estimated within the 20 to 100 g/m² of listings.",
    },
    Preset {
        id: "jersey",
        name: "Interlock jersey",
        name_ja: "スムース・天竺ニット",
        areal_density: measured(187.0),
        thickness: estimated(0.6),
        stretch: measured([34.0, 17.0]),
        shear: measured(37.0),
        bend: measured([23.0, 14.0]),
        twist: derived(31.5),
        friction: estimated(0.5),
        source: "60/40 interlock of Wang, O'Brien and Ramamoorthi 2011 (gray-interlock).",
    },
    Preset {
        id: "spandex",
        name: "Nylon and spandex knit",
        name_ja: "ツーウェイ（水着地）",
        areal_density: measured(204.0),
        thickness: estimated(0.5),
        stretch: measured([105.0, 48.0]),
        shear: measured(61.0),
        bend: measured([60.0, 51.0]),
        twist: derived(62.5),
        friction: estimated(0.6),
        source: "87/13 swimwear of Wang, O'Brien and Ramamoorthi 2011 (white-swim-solid).",
    },
];
