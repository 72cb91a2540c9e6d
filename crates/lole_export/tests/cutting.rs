//! Cut plans and patterns, measured by readers that are not ours.
#![expect(
    clippy::unwrap_used,
    reason = "a test that cannot be set up has failed"
)]

#[path = "../../lole_pattern/tests/shapes/mod.rs"]
mod shapes;

use std::collections::BTreeSet;

use kurbo::{Affine, Point};
use lole_costume::tailoring::{Cloth, GarmentPattern};
use lole_export::cutting::{
    CutGarment, cut_plan_sheets, cut_plan_svg, pattern_json, pieces_svg, ruler_sheets, tiled_sheets,
};
use lole_export::dxf::pattern_dxf;
use lole_export::pdf::{Document, Paper, Sheet, Stroke};
use lole_geom::Length;
use lole_language::{Language, words};
use lole_pattern::Pattern;
use lole_pattern::marker::{Lay, Nap};

/// What a print may be off [mm].
const GATE: f64 = 0.1;

fn cut(pattern: Pattern) -> CutGarment {
    let garment = GarmentPattern {
        template: &lole_garment::template::PAU_SKIRT,
        place: None,
        id: "trial".to_owned(),
        name: words("試しの服", "trial pāʻū"),
        pattern,
        parts: None,
        cloth: Cloth {
            name: words("木綿", "cotton"),
            width: Length::from_cm(110.0),
            beside_width: Length::from_cm(110.0),
            areal_density: 0.12,
            nap: Nap::TwoWay,
            border: None,
            repeat: None,
        },
    };
    CutGarment {
        plans: garment.cloth_plans(Lay::Single, None),
        garment,
        print: None,
        owner: String::new(),
        stamp: lole_export::cutting::Stamp::default(),
    }
}

fn pdf(sheets: Vec<Sheet>) -> Vec<u8> {
    let document = Document {
        title: "trial".to_owned(),
        language: "en",
        sheets,
    };
    document.to_bytes().unwrap()
}

/// Straight lines of every page [mm], by lopdf: transforms and path operators followed by hand.
fn pdf_lines(bytes: &[u8]) -> Vec<Vec<f64>> {
    let document = lopdf::Document::load_mem(bytes).unwrap();
    let pages = document.get_pages();
    pages
        .into_values()
        .map(|page| page_lines(&document, page))
        .collect()
}

fn page_lines(document: &lopdf::Document, page: lopdf::ObjectId) -> Vec<f64> {
    let content = document.get_and_decode_page_content(page).unwrap();
    let mut transforms = vec![Affine::IDENTITY];
    let (mut lengths, mut at, mut start) = (Vec::new(), Point::ZERO, Point::ZERO);
    for operation in &content.operations {
        let numbers: Vec<f64> = (operation.operands.iter())
            .filter_map(|operand| operand.as_float().ok().map(f64::from))
            .collect();
        let last = transforms.len() - 1;
        let mut line_to = |at: &mut Point, to: Point| {
            let [from, end] = [*at, to].map(|point| transforms[last] * point);
            lengths.push(from.distance(end) * 25.4 / 72.0);
            *at = to;
        };
        match operation.operator.as_str() {
            "m" => {
                at = Point::new(numbers[0], numbers[1]);
                start = at;
            }
            "l" => line_to(&mut at, Point::new(numbers[0], numbers[1])),
            "h" => line_to(&mut at, start),
            "re" => {
                let corner = Point::new(numbers[0], numbers[1]);
                at = corner;
                line_to(&mut at, corner + kurbo::Vec2::new(numbers[2], 0.0));
                line_to(&mut at, corner + kurbo::Vec2::new(numbers[2], numbers[3]));
            }
            "q" => transforms.push(transforms[last]),
            "Q" => {
                transforms.pop();
            }
            "cm" => {
                let matrix: [f64; 6] = numbers.try_into().unwrap();
                transforms[last] *= Affine::new(matrix);
            }
            _ => {}
        }
    }
    lengths
}

fn has(lengths: &[f64], expected: f64) -> bool {
    lengths
        .iter()
        .any(|length| (length - expected).abs() < GATE)
}

#[test]
fn a_line_of_100_mm_measures_100_mm_in_the_pdf() {
    for (paper, _) in Paper::ALL {
        let mut sheet = Sheet::new(paper.size_mm());
        sheet.line([20.0, 30.0], [120.0, 30.0], Stroke::solid(0.3));
        let lines = pdf_lines(&pdf(vec![sheet]));
        assert!(has(&lines[0], 100.0), "{:?}", lines[0]);
    }
}

#[test]
fn full_size_pieces_measure_what_they_should_on_every_sheet() {
    let gores = cut(Pattern {
        pieces: vec![shapes::gore(0.2, 0.34, 0.6, 4.0)],
        ..shapes::pattern()
    });
    let cut_line = gores.garment.pattern.pieces[0].cut_polygon(1e-4);
    for (paper, name) in Paper::ALL {
        let tiled = tiled_sheets(&gores, paper, Language::English).unwrap();
        let pages = pdf_lines(&pdf(tiled.sheets));
        assert!(has(&pages[0], 100.0), "{name}: the test square");
        assert!(2 < pages.len(), "{name}");
        for (number, page) in pages.iter().enumerate().skip(1) {
            for [from, to] in cut_line.sides() {
                let side = 1000.0 * from.distance(to);
                assert!(has(page, side), "{name} sheet {number}: {side} mm");
            }
        }
    }
}

/// Every bit of every piece is on a sheet, and neighbors share a centimeter and a number.
#[test]
fn sheets_meet_at_numbered_joints() {
    let garment = cut(shapes::pattern());
    let tiled = tiled_sheets(&garment, Paper::A4, Language::English).unwrap();
    assert_eq!(tiled.piece_count, 4);
    let [columns, rows] = tiled.grid;
    assert!(tiled.sheets.len() <= (columns * rows) as usize + 1);
    let mut sheets: Vec<BTreeSet<&str>> = Vec::new();
    for sheet in &tiled.sheets[1..] {
        sheets.push(sheet.texts().into_iter().collect());
    }
    for texts in &sheets {
        for text in texts.iter().filter_map(|text| text.strip_prefix("lay ")) {
            let name = text.strip_suffix(" here").unwrap();
            let neighbor = sheets.iter().find(|texts| texts.contains(name)).unwrap();
            let number = |texts: &BTreeSet<&str>| -> BTreeSet<u32> {
                texts.iter().filter_map(|text| text.parse().ok()).collect()
            };
            let shared = number(texts).intersection(&number(neighbor)).count();
            assert!(0 < shared, "{name}: {texts:?} {neighbor:?}");
        }
    }
}

#[test]
fn rectangles_are_drawn_by_ruler_and_not_on_paper() {
    let strips = cut(Pattern {
        pieces: vec![shapes::strip(0.9, 0.06)],
        ..shapes::pattern()
    });
    assert!(tiled_sheets(&strips, Paper::A4, Language::Japanese).is_none());
    let ruler = ruler_sheets(&[strips], Paper::A4, Language::English);
    assert_eq!(ruler.len(), 1);
    let text = ruler[0].texts().join(" ");
    assert!(
        text.contains("92.0 cm") && text.contains("8.0 cm"),
        "{text}"
    );
    assert!(
        text.contains("stitching line") && text.contains("1.0 cm"),
        "{text}"
    );
    let free = cut(Pattern {
        pieces: vec![shapes::sleeve()],
        ..shapes::pattern()
    });
    assert!(ruler_sheets(&[free], Paper::A4, Language::English).is_empty());
}

#[test]
fn cut_plans_say_what_to_buy_in_both_languages() {
    let garment = [cut(shapes::pattern())];
    for (language, words) in [
        (Language::Japanese, ["買う", "耳", "使用率", "型紙で"]),
        (
            Language::English,
            ["buy", "selvage", "is used", "paper pattern"],
        ),
    ] {
        let sheets = cut_plan_sheets(&garment, Paper::A4, language);
        let text: String = sheets
            .iter()
            .flat_map(Sheet::texts)
            .collect::<Vec<_>>()
            .join(" ");
        for word in words {
            assert!(text.contains(word), "{word}: {text}");
        }
        assert!(pdf(sheets).starts_with(b"%PDF-"));
    }
}

/// Pixels of usvg, 96 to the inch, as millimeters.
const MM_PER_PIXEL: f64 = 25.4 / 96.0;

/// Bounding boxes of the paths of a group of this class inside the group of a piece [mm].
fn svg_boxes(group: &usvg::Group, boxes: &mut Vec<[f64; 2]>) {
    for node in group.children() {
        match node {
            usvg::Node::Group(group) => svg_boxes(group, boxes),
            usvg::Node::Path(path) => {
                let bounds = path.abs_bounding_box();
                boxes.push([
                    f64::from(bounds.width()) * MM_PER_PIXEL,
                    f64::from(bounds.height()) * MM_PER_PIXEL,
                ]);
            }
            usvg::Node::Image(_) | usvg::Node::Text(_) => {}
        }
    }
}

#[test]
fn svg_pieces_measure_what_they_should() {
    let garment = cut(shapes::pattern());
    let svg = pieces_svg(&garment, Language::Japanese);
    let tree = usvg::Tree::from_data(&svg, &usvg::Options::default()).unwrap();
    let mut boxes = Vec::new();
    svg_boxes(tree.root(), &mut boxes);
    for piece in &garment.garment.pattern.pieces {
        let bounds = piece.unfolded().cut_polygon(1e-4).bounds();
        let size = [1000.0 * bounds.width(), 1000.0 * bounds.height()];
        let is_there =
            (boxes.iter()).any(|found| (0..2).all(|axis| (found[axis] - size[axis]).abs() < GATE));
        assert!(is_there, "{} {size:?}", piece.id);
    }
    let plan = cut_plan_svg(&[garment], Language::English);
    assert!(usvg::Tree::from_data(&plan, &usvg::Options::default()).is_ok());
}

#[test]
fn dxf_pieces_measure_what_they_should_on_the_layers_of_the_standard() {
    let garment = cut(shapes::pattern());
    let bytes = pattern_dxf(&garment, "Hōkū 7");
    assert!(bytes.is_ascii());
    let drawing = dxf::Drawing::load(&mut std::io::Cursor::new(&bytes)).unwrap();
    let blocks: Vec<&dxf::Block> = drawing.blocks().collect();
    assert_eq!(blocks.len(), garment.garment.pattern.pieces.len());
    for (piece, block) in garment.garment.pattern.pieces.iter().zip(blocks) {
        let bounds = piece.unfolded().cut_polygon(1e-5).bounds();
        let mut layers = BTreeSet::new();
        for entity in &block.entities {
            layers.insert(entity.common.layer.as_str());
            if let dxf::entities::EntityType::Polyline(line) = &entity.specific
                && entity.common.layer == "1"
            {
                let x: Vec<f64> = line.vertices().map(|vertex| vertex.location.x).collect();
                let width = x.iter().fold(f64::MIN, |a, b| a.max(*b))
                    - x.iter().fold(f64::MAX, |a, b| a.min(*b));
                assert!(
                    (width - 1000.0 * bounds.width()).abs() < GATE,
                    "{}",
                    piece.id
                );
                assert!(line.is_closed(), "{}", piece.id);
            }
        }
        for layer in ["1", "2", "7", "14", "15"] {
            assert!(layers.contains(layer), "{}: {layers:?}", piece.id);
        }
    }
    let text = String::from_utf8(bytes).unwrap();
    for line in [
        "Units: METRIC",
        "Sample Size: Hoku 7",
        "Piece Name: SLEEVE",
        "Quantity: 2",
    ] {
        assert!(text.contains(line), "{line}");
    }
    let inserts = drawing
        .entities()
        .filter(|entity| matches!(entity.specific, dxf::entities::EntityType::Insert(_)));
    assert_eq!(inserts.count(), garment.garment.pattern.pieces.len());
}

#[test]
fn json_holds_every_piece_and_place() {
    let garment = cut(shapes::pattern());
    let json = pattern_json(std::slice::from_ref(&garment), "0").unwrap();
    let value: serde_json::Value = serde_json::from_str(&json).unwrap();
    let first = &value["garments"][0];
    let pieces = first["pieces"].as_array().unwrap();
    assert_eq!(pieces.len(), garment.garment.pattern.pieces.len());
    let placed = first["cloths"][0]["placed"].as_array().unwrap();
    assert_eq!(placed.len(), garment.plans[0].marker.placed.len());
    let strip = pieces.iter().find(|piece| piece["id"] == "strip").unwrap();
    assert_eq!(strip["width_cm"], 92.0);
    assert_eq!(strip["is_rectangle"], true);
}

#[test]
fn the_same_pattern_gives_the_same_bytes() {
    let files = || {
        let garment = cut(shapes::pattern());
        let tiled = tiled_sheets(&garment, Paper::Letter, Language::Japanese).unwrap();
        (
            pattern_dxf(&garment, "7"),
            pieces_svg(&garment, Language::English),
            pdf(tiled.sheets),
        )
    };
    assert!(files() == files());
}
