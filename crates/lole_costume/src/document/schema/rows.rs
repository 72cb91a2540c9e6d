//! How rows of the schema are written, and the rows that garments share: a macro for each part of a
//! design, because a skirt's rows fill a [`Design`](crate::document::Design) as they fill a
//! [`GarmentDesign`](crate::document::GarmentDesign).

macro_rules! number {
    ($name:literal, $min:literal..=$max:literal, $($field:ident).+, $japanese:literal, $about:literal) => {
        Key {
            name: $name,
            about: words($japanese, $about),
            kind: Kind::Number {
                min: $min,
                max: $max,
                get: |design| Some(design.$($field).+),
                set: |design, value| design.$($field).+ = value,
            },
        }
    };
}

macro_rules! number_if_known {
    ($name:literal, $min:literal..=$max:literal, $($field:ident).+, $japanese:literal, $about:literal) => {
        Key {
            name: $name,
            about: words($japanese, $about),
            kind: Kind::Number {
                min: $min,
                max: $max,
                get: |design| design.$($field).+,
                set: |design, value| design.$($field).+ = Some(value),
            },
        }
    };
}

/// A measure that patterns go by and no body is built from.
macro_rules! tailored {
    ($tailored:expr) => {
        Key {
            name: $tailored.key(),
            about: $tailored.about(),
            kind: Kind::Number {
                min: $tailored.band_cm()[0],
                max: $tailored.band_cm()[1],
                get: |design| design.dancer.tailor_tape.cm($tailored),
                set: |design, value| {
                    let taken = &mut design.dancer.tailor_tape;
                    *taken = taken.with_cm($tailored, Some(value));
                },
            },
        }
    };
}

macro_rules! count {
    ($name:literal, $min:literal..=$max:literal, $($field:ident).+, $japanese:literal, $about:literal) => {
        Key {
            name: $name,
            about: words($japanese, $about),
            kind: Kind::Count {
                min: $min,
                max: $max,
                get: |design| Some(u64::from(design.$($field).+)),
                set: |design, value| {
                    design.$($field).+ = u32::try_from(value).unwrap_or(u32::MAX);
                },
            },
        }
    };
}

macro_rules! seed {
    ($table:ident, $japanese:literal, $about:literal) => {
        Key {
            name: "seed",
            about: words($japanese, $about),
            kind: Kind::Count {
                min: 0,
                max: MAX_SEED,
                get: |design| Some(design.$table.seed),
                set: |design, value| design.$table.seed = value,
            },
        }
    };
}

macro_rules! color {
    ($name:literal, $($field:ident).+, $japanese:literal, $about:literal) => {
        Key {
            name: $name,
            about: words($japanese, $about),
            kind: Kind::Color {
                get: |design| design.$($field).+,
                set: |design, value| design.$($field).+ = Some(value),
            },
        }
    };
}

/// A choice among `(id, value)` pairs that this file names.
macro_rules! choice {
    ($name:literal, $what:expr, $list:ident, $($field:ident).+, $japanese:literal, $about:literal) => {
        Key {
            name: $name,
            about: words($japanese, $about),
            kind: Kind::Name {
                what: $what,
                choices: || $list.iter().map(|(id, _)| *id).collect(),
                get: |design| {
                    let found = $list
                        .iter()
                        .find(|(_, value)| *value == design.$($field).+);
                    found.map_or($list[0].0, |(id, _)| id)
                },
                set: |design, name| {
                    if let Some((_, value)) = $list.iter().find(|(id, _)| *id == name) {
                        design.$($field).+ = *value;
                    }
                },
            },
        }
    };
}

/// Rows of how finely something is gathered, and by what chance.
macro_rules! fineness_keys {
    ($table:ident) => {
        &[
            count!(
                "column_count",
                32..=4096,
                $table.column_count,
                "横まわりの質点の数",
                "particles around"
            ),
            count!(
                "row_count",
                8..=512,
                $table.row_count,
                "上から裾までの質点の数",
                "particles from top to hem"
            ),
            seed!(
                $table,
                "ギャザーの寄り方（乱数の種）",
                "chance of the gathers"
            ),
        ]
    };
}

/// Rows of a cut skirt, after others.
macro_rules! skirt_keys {
    ($($first:expr),*) => { &[
        $($first,)*
        number!(
            "hem_height_cm",
            0.0..=100.0,
            skirt.hem_height_cm,
            "床から裾まで",
            "hem above the floor"
        ),
        number_if_known!(
            "worn_height_cm",
            40.0..=130.0,
            skirt.worn_height_cm,
            "床からいちばん下のゴムまで。書かなければ腰骨の前",
            "lowest elastic above the floor; left out: the front hip bones"
        ),
        number!(
            "gather_ratio",
            1.0..=5.0,
            skirt.gather_ratio,
            "布の長さ÷ヒップ",
            "flat length over hip girth"
        ),
        count!(
            "elastic_row_count",
            1..=6,
            skirt.elastic_row_count,
            "ゴムの段数",
            "rows of elastic"
        ),
        number!(
            "elastic_ratio",
            0.8..=0.9,
            skirt.elastic_ratio,
            "縮んだゴムの長さ÷はく位置の胴回り",
            "relaxed elastic over the girth where it is worn"
        ),
        number!(
            "header_cm",
            0.0..=15.0,
            skirt.header_cm,
            "いちばん上のゴムより上のフリル",
            "ruffle above the top elastic"
        ),
        number!(
            "casing_cm",
            0.5..=10.0,
            skirt.casing_cm,
            "ゴム通しの幅",
            "height of one casing"
        ),
        number!(
            "casing_gap_cm",
            0.0..=15.0,
            skirt.casing_gap_cm,
            "ゴム通しの間隔",
            "between two casings"
        ),
        number!(
            "hem_allowance_cm",
            0.0..=30.0,
            skirt.hem_allowance_cm,
            "裾上げの分",
            "cloth for the hem"
        ),
        count!(
            "column_count",
            32..=4096,
            skirt.column_count,
            "横まわりの質点の数",
            "particles around"
        ),
        count!(
            "row_count",
            8..=512,
            skirt.row_count,
            "上から裾までの質点の数",
            "particles from top to hem"
        ),
        seed!(
            skirt,
            "ギャザーの寄り方（乱数の種）",
            "chance of the gathers"
        ),
    ] };
}

/// Rows of a fabric.
macro_rules! fabric_keys {
    () => {
        &[
            Key {
                name: "name",
                about: words("自分の布の名前", "what the cloth's owner calls it"),
                kind: Kind::Text {
                    what: words("布の名前", "the name of a cloth"),
                    get: |design| design.fabric.name.as_deref(),
                    set: |design, name| design.fabric.name = Some(name.to_owned()),
                },
            },
            Key {
                name: "preset",
                about: words("棚の布", "fabric from the shelf"),
                kind: Kind::Name {
                    what: words("布", "fabric"),
                    choices: || PRESETS.iter().map(|preset| preset.id).collect(),
                    get: |design| design.fabric.preset.id,
                    set: |design, name| {
                        if let Some(preset) = Preset::from_id(name) {
                            design.fabric.preset = preset;
                        }
                    },
                },
            },
            number!(
                "width_cm",
                30.0..=400.0,
                fabric.width_cm,
                "布の耳から耳まで",
                "selvage to selvage"
            ),
            number_if_known!(
                "areal_density_g_per_m2",
                10.0..=1000.0,
                fabric.areal_density_g_per_m2,
                "布の重さ",
                "weight"
            ),
            number_if_known!(
                "thickness_mm",
                0.02..=5.0,
                fabric.thickness_mm,
                "厚さ",
                "thickness"
            ),
            number_if_known!(
                "stretch_warp_n_per_m",
                1.0..=1e6,
                fabric.stretch_warp_n_per_m,
                "横まわりの伸びにくさ",
                "around the skirt"
            ),
            number_if_known!(
                "stretch_weft_n_per_m",
                1.0..=1e6,
                fabric.stretch_weft_n_per_m,
                "丈の方向の伸びにくさ",
                "down the skirt"
            ),
            number_if_known!(
                "shear_n_per_m",
                0.1..=1e6,
                fabric.shear_n_per_m,
                "バイアスの伸びにくさ",
                "across the bias"
            ),
            number_if_known!(
                "bend_warp_un_m",
                0.01..=1e5,
                fabric.bend_warp_un_m,
                "横まわりの曲げにくさ",
                "bending around"
            ),
            number_if_known!(
                "bend_weft_un_m",
                0.01..=1e5,
                fabric.bend_weft_un_m,
                "丈の方向の曲げにくさ",
                "bending down"
            ),
            number_if_known!(
                "twist_un_m",
                0.01..=1e5,
                fabric.twist_un_m,
                "ねじりにくさ",
                "twisting"
            ),
            number_if_known!(
                "bend_hysteresis_warp_mn",
                0.0..=1000.0,
                fabric.bend_hysteresis_warp_mn,
                "横まわりの曲げの戻りにくさ（KES 2HB）",
                "yarn friction in bending around (KES 2HB)"
            ),
            number_if_known!(
                "bend_hysteresis_weft_mn",
                0.0..=1000.0,
                fabric.bend_hysteresis_weft_mn,
                "丈の方向の曲げの戻りにくさ（KES 2HB）",
                "yarn friction in bending down (KES 2HB)"
            ),
            number_if_known!(
                "shear_hysteresis_n_per_m",
                0.0..=1000.0,
                fabric.shear_hysteresis_n_per_m,
                "せん断の戻りにくさ（KES 2HG）",
                "yarn friction in shear (KES 2HG)"
            ),
            number_if_known!(
                "friction_coefficient",
                0.0..=2.0,
                fabric.friction_coefficient,
                "肌との摩擦",
                "on skin"
            ),
            number_if_known!(
                "cloth_friction_coefficient",
                0.0..=2.0,
                fabric.cloth_friction_coefficient,
                "布どうしの摩擦",
                "on cloth"
            ),
            number_if_known!(
                "drag_per_s",
                0.0..=50.0,
                fabric.drag_per_s,
                "空気の抵抗",
                "air drag"
            ),
            number_if_known!(
                "price_per_m",
                0.0..=1_000_000.0,
                fabric.price_per_m,
                "1 m の値段",
                "price of a meter"
            ),
            number_if_known!(
                "price_per_yd",
                0.0..=1_000_000.0,
                fabric.price_per_yd,
                "1 ヤードの値段。1 m の値段があればそちらを使う",
                "price of a yard; that of a meter comes first"
            ),
            number_if_known!(
                "beside_width_cm",
                20.0..=400.0,
                fabric.beside_width_cm,
                "裏布・別布・芯地の布幅。書かなければ表布と同じ",
                "width of lining, contrast cloth and interfacing; as the cloth when left out"
            ),
            number_if_known!(
                "beside_price_per_m",
                0.0..=1_000_000.0,
                fabric.beside_price_per_m,
                "裏布・別布・芯地 1 m の値段",
                "price of a meter of lining, contrast cloth or interfacing"
            ),
        ]
    };
}
