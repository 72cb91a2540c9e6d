//! Rows of a print, for the skirt's and for those of garments.

use lole_print::{PrintBorder, PrintDirection, PrintFlip, PrintTiling};

pub(super) const DIRECTIONS: &[(&str, PrintDirection)] = &[
    ("up", PrintDirection::Up),
    ("right", PrintDirection::Right),
    ("down", PrintDirection::Down),
    ("left", PrintDirection::Left),
];
pub(super) const FLIPS: &[(&str, PrintFlip)] = &[
    ("none", PrintFlip::None),
    ("sideways", PrintFlip::Sideways),
    ("upside-down", PrintFlip::UpsideDown),
];
pub(super) const TILINGS: &[(&str, PrintTiling)] = &[
    ("straight", PrintTiling::Straight),
    ("half-drop", PrintTiling::HalfDrop),
    ("brick", PrintTiling::Brick),
    ("mirror", PrintTiling::Mirror),
];
pub(super) const BORDERS: &[(&str, PrintBorder)] = &[
    ("none", PrintBorder::None),
    ("hem", PrintBorder::Hem),
    ("hip", PrintBorder::Hip),
];

/// Largest place in a picture [pixel].
macro_rules! photo_mark {
    ($name:literal, $($field:ident).+, $japanese:literal, $about:literal) => {
        number_if_known!($name, 0.0..=20000.0, $($field).+, $japanese, $about)
    };
}

/// Rows of what is drawn.
macro_rules! print_keys {
    () => {{
        use lole_print::{COLORWAYS, Colorway, MOTIFS, PrintMotif};

        use crate::document::LinkedPicture;
        use crate::document::schema::print_rows::{BORDERS, DIRECTIONS, FLIPS, TILINGS};

        &[
            Key {
                name: "motif",
                about: words("描くもの", "what is drawn"),
                kind: Kind::Name {
                    what: words("柄", "motif"),
                    choices: || MOTIFS.iter().map(|row| row.id).collect(),
                    get: |design| design.print.motif.row().id,
                    set: |design, name| {
                        if let Some(motif) = PrintMotif::from_id(name) {
                            design.print.motif = motif;
                        }
                    },
                },
            },
            Key {
                name: "colorway",
                about: words("色の組み合わせ", "ready set of colors"),
                kind: Kind::Name {
                    what: words("配色", "colorway"),
                    choices: || COLORWAYS.iter().map(|way| way.id).collect(),
                    get: |design| design.print.colorway,
                    set: |design, name| {
                        if let Some(way) = Colorway::from_id(name) {
                            design.print.colorway = way.id;
                        }
                    },
                },
            },
            color!(
                "ground",
                print.ground,
                "地の色を変えるとき",
                "instead of the colorway's ground"
            ),
            color!(
                "flower",
                print.flower,
                "花の色を変えるとき",
                "instead of the colorway's flowers"
            ),
            color!(
                "leaf",
                print.leaf,
                "葉の色を変えるとき",
                "instead of the colorway's leaves"
            ),
            color!(
                "shadow",
                print.shadow,
                "奥の柄の色を変えるとき",
                "instead of the colorway's second layer"
            ),
            number!(
                "repeat_cm",
                5.0..=200.0,
                print.repeat_cm,
                "柄のひと送りの幅（布の上で）",
                "width of one repeat on the cloth"
            ),
            seed!(print, "柄の置き方（乱数の種）", "chance of the places"),
            Key {
                name: "file",
                about: words(
                    "描くかわりに使う布の画像（PNG・JPEG・SVG）。この文書から見た場所",
                    "picture of the print instead (PNG, JPEG, SVG); its place from this document",
                ),
                kind: Kind::Text {
                    what: words("画像のファイルの名前", "the name of a picture"),
                    get: |design| design.print.file.as_ref().map(|file| file.name.as_str()),
                    set: |design, name| design.print.file = Some(LinkedPicture::named(name)),
                },
            },
            photo_mark!(
                "crop_left_px",
                print.marks.crop_left_px,
                "画像のうち、ひと送りの左端",
                "left edge of the repeat in the picture"
            ),
            photo_mark!(
                "crop_top_px",
                print.marks.crop_top_px,
                "ひと送りの上端",
                "upper edge of the repeat"
            ),
            photo_mark!(
                "crop_width_px",
                print.marks.crop_width_px,
                "ひと送りの幅",
                "width of the repeat"
            ),
            photo_mark!(
                "crop_height_px",
                print.marks.crop_height_px,
                "ひと送りの高さ",
                "height of the repeat"
            ),
            number_if_known!(
                "known_length_cm",
                0.5..=400.0,
                print.marks.known_length_cm,
                "画像の 2 点の間の、本物の布での長さ（repeat_cm のかわり）",
                "distance of two points of the picture on the real cloth, instead of repeat_cm"
            ),
            photo_mark!(
                "known_from_x_px",
                print.marks.known_from_x_px,
                "1 点めの横の位置（左から）",
                "first point, from the left"
            ),
            photo_mark!(
                "known_from_y_px",
                print.marks.known_from_y_px,
                "1 点めの縦の位置（上から）",
                "first point, from the top"
            ),
            photo_mark!(
                "known_to_x_px",
                print.marks.known_to_x_px,
                "2 点めの横の位置",
                "second point, from the left"
            ),
            photo_mark!(
                "known_to_y_px",
                print.marks.known_to_y_px,
                "2 点めの縦の位置",
                "second point, from the top"
            ),
            number!(
                "scale_ratio",
                0.1..=10.0,
                print.lay.scale_ratio,
                "柄の大きさの倍率",
                "factor on the size of the print"
            ),
            choice!(
                "direction",
                words("柄の向き", "direction"),
                DIRECTIONS,
                print.lay.direction,
                "布を横に置いたとき、柄の上がどちらを向くか",
                "where the top of the print points, the bolt lying to the side"
            ),
            choice!(
                "flip",
                words("裏返し方", "flip"),
                FLIPS,
                print.lay.flip,
                "柄を左右（sideways）か上下（upside-down）に裏返すか",
                "mirror image of the print"
            ),
            choice!(
                "tiling",
                words("並べ方", "tiling"),
                TILINGS,
                print.lay.tiling,
                "並べ方。half-drop は 1 列おきに半分下げ、mirror は裏返して並べ、つなぎ目を隠す",
                "how copies lie; mirror hides the edges of a photo that does not repeat"
            ),
            choice!(
                "border",
                words("ボーダーの場所", "place of the border"),
                BORDERS,
                print.lay.border,
                "片耳に沿うボーダー柄が裾（hem）に来るか腰（hip）に来るか。none は総柄",
                "whether a border along one selvage comes to the hem or the hip; none: all over"
            ),
            number!(
                "offset_along_cm",
                -400.0..=400.0,
                print.lay.offset_along_cm,
                "柄を布に沿って右へずらす長さ",
                "moves the print along the cloth, to the right"
            ),
            number!(
                "offset_across_cm",
                -400.0..=400.0,
                print.lay.offset_across_cm,
                "柄を下の耳から上へずらす長さ",
                "moves the print up from the lower selvage"
            ),
        ]
    }};
}
