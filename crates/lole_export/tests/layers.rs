//! Pages with layers, read by a reader that is not ours.
#![expect(
    clippy::unwrap_used,
    reason = "a test that cannot be set up has failed"
)]

use lole_export::pdf::{Align, Layer, LayeredSheet, Sheet, Stroke, TextStyle};
use lole_language::Language;
use lopdf::{Dictionary, Object, ObjectId};

/// A page with a line on it and one on each layer, `10 * (index + 1)` mm long.
fn layered(names: &[&str]) -> LayeredSheet {
    let drawn = |index: usize, text: &str| {
        let mut sheet = Sheet::new([914.4, 2500.0]);
        let long = 10.0 * (index as f64 + 1.0);
        sheet.line([20.0, 30.0], [20.0 + long, 30.0], Stroke::solid(0.5));
        sheet.text([20.0, 60.0], text, &TextStyle::body(), Align::Left);
        sheet
    };
    let layers = (1..).zip(names).map(|(index, name)| Layer {
        name: (*name).to_owned(),
        items: drawn(index, name).items,
    });
    LayeredSheet {
        base: drawn(0, "pāʻū"),
        layers: layers.collect(),
    }
}

/// A dictionary's entry as a dictionary, through references.
fn inner<'a>(document: &'a lopdf::Document, of: &'a Dictionary, key: &str) -> &'a Dictionary {
    match of.get(key.as_bytes()).unwrap() {
        Object::Reference(id) => document.get_dictionary(*id).unwrap(),
        object => object.as_dict().unwrap(),
    }
}

fn references(of: &Dictionary, key: &str) -> Vec<ObjectId> {
    let listed = of.get(key.as_bytes()).and_then(Object::as_array).unwrap();
    listed.iter().map(|it| it.as_reference().unwrap()).collect()
}

/// What is drawn on the page, in order: the layer it is of, and how long its line is [mm].
fn drawn(document: &lopdf::Document) -> Vec<(Option<ObjectId>, f64)> {
    let pages = document.get_pages();
    assert_eq!(pages.len(), 1);
    let page = pages[&1];
    let resources = inner(
        document,
        document.get_dictionary(page).unwrap(),
        "Resources",
    );
    let content = document.get_and_decode_page_content(page).unwrap();
    let (mut layer, mut drawn) = (None, Vec::new());
    for operation in content.operations {
        let last = operation.operands.last().and_then(|it| it.as_name().ok());
        match operation.operator.as_str() {
            "BDC" => {
                let properties = inner(document, resources, "Properties");
                layer = Some(
                    properties
                        .get(last.unwrap())
                        .unwrap()
                        .as_reference()
                        .unwrap(),
                );
            }
            "EMC" => layer = None,
            "Do" => {
                let objects = inner(document, resources, "XObject");
                let object = objects.get(last.unwrap()).unwrap().as_reference().unwrap();
                drawn.push((layer, line_length(document, object)));
            }
            _ => {}
        }
    }
    drawn
}

/// Length of the first line of a form [mm].
fn line_length(document: &lopdf::Document, form: ObjectId) -> f64 {
    let stream = document.get_object(form).unwrap().as_stream().unwrap();
    let bytes = stream.decompressed_content().unwrap();
    let content = lopdf::content::Content::decode(&bytes).unwrap();
    let mut scale = f64::from(
        stream.dict.get(b"Matrix").unwrap().as_array().unwrap()[0]
            .as_float()
            .unwrap(),
    );
    let mut from = None;
    for operation in content.operations {
        let number = operation.operands.first().and_then(|it| it.as_float().ok());
        let number = number.map(f64::from);
        match operation.operator.as_str() {
            "cm" => scale *= number.unwrap(),
            "m" => from = number,
            "l" => return (number.unwrap() - from.unwrap()) * scale * 25.4 / 72.0,
            _ => {}
        }
    }
    panic!("a form without a line");
}

#[test]
fn every_layer_is_listed_by_its_name_and_holds_what_was_drawn_on_it() {
    let many: Vec<String> = (0..40).map(|number| format!("サイズ {number}")).collect();
    let many: Vec<&str> = many.iter().map(String::as_str).collect();
    for names in [
        &["縫い線", "裁ち線（わ）", ")\\(", "same", "same"][..],
        &[],
        &many,
    ] {
        let sheet = layered(names);
        let bytes = sheet.to_bytes("mū", Language::English).unwrap();
        assert_eq!(bytes, sheet.to_bytes("mū", Language::English).unwrap());
        let document = lopdf::Document::load_mem(&bytes).unwrap();
        let layers = inner(&document, document.catalog().unwrap(), "OCProperties");
        let groups = references(layers, "OCGs");
        let shown = inner(&document, layers, "D");
        assert_eq!(references(shown, "Order"), groups);
        assert_eq!(references(shown, "ON"), groups);
        let named = groups.iter().map(|group| {
            let name = document
                .get_dictionary(*group)
                .unwrap()
                .get(b"Name")
                .unwrap();
            lopdf::decode_text_string(name).unwrap()
        });
        assert_eq!(named.collect::<Vec<_>>(), names);
        let drawn = drawn(&document);
        let of_layers: Vec<Option<ObjectId>> = drawn.iter().map(|(layer, _)| *layer).collect();
        let expected = std::iter::once(None).chain(groups.iter().copied().map(Some));
        assert_eq!(of_layers, expected.collect::<Vec<_>>());
        for (index, (_, long)) in drawn.iter().enumerate() {
            let expected = 10.0 * (index as f64 + 1.0);
            assert!((long - expected).abs() < 0.01, "{index}: {long} mm");
        }
    }
}

#[test]
fn the_page_is_as_large_as_it_was_drawn() {
    let bytes = layered(&["one"])
        .to_bytes("mū", Language::Japanese)
        .unwrap();
    let document = lopdf::Document::load_mem(&bytes).unwrap();
    let page = document.get_dictionary(document.get_pages()[&1]).unwrap();
    let sides = page.get(b"MediaBox").and_then(Object::as_array).unwrap();
    let sides: Vec<f32> = sides.iter().map(|it| it.as_float().unwrap()).collect();
    let [width, height] = [914.4_f32, 2500.0].map(|side| side * 72.0 / 25.4);
    assert!((sides[2] - sides[0] - width).abs() < 0.1, "{sides:?}");
    assert!((sides[3] - sides[1] - height).abs() < 0.1, "{sides:?}");
}
