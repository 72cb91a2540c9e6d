//! Whatever somebody calls a costume, a dancer or a cloth is text in every file that is made of it: readers that
//! are not ours find what they find with harmless names, and nothing that would run.
#![expect(
    clippy::unwrap_used,
    reason = "a test that meets anything unexpected should stop"
)]

use std::collections::BTreeSet;
use std::sync::LazyLock;

use html5gum::emitters::default::DefaultEmitter;
use html5gum::{Token, Tokenizer};
use lole_costume::document::{Design, GarmentDesign, parse, to_toml};
use lole_costume::order::{self, Group, Settings};
use lole_costume::roster;
use lole_costume::tailoring;
use lole_export::cutting::CutGarment;
use lole_export::dancer_sheet::{DancerSheet, dancer_json};
use lole_export::dxf::pattern_dxf;
use lole_export::order::{ORDER_JSON, OrderFolder, OrderParts, order_folder};
use lole_export::pdf::{Align, Document, Layer, LayeredSheet, Paper, Sheet, TextStyle, printable};
use lole_export::report::{
    DancerMeasure, GarmentFacts, PageMedia, Remark, ReportDivergence, ReportFile, ReportPieceOver,
    RunReport, Still, report_html, report_json,
};
use lole_export::study::{CapsulesEntry, CauseEntry, RunEntry, StepEntry, StudyReport, study_csv};
use lole_export::svg::sheet_svg;
use lole_language::{Language, is_unseen};
use lole_pattern::marker::Lay;

/// A name with which nothing is wrong.
const HARMLESS: &str = "Leilani";

/// What somebody might write who wants a reader to run, to break or to show something else.
static HOSTILE: LazyLock<Vec<String>> = LazyLock::new(|| {
    let mut names: Vec<String> = [
        "<script>alert(1)</script>",
        "</style><script>alert(1)</script>",
        "</title></text></svg><script>alert(1)</script>",
        "\"onload=\"alert(1)",
        "' onmouseover='alert(1)",
        "<img src=x onerror=alert(1)>",
        "javascript:alert(1)",
        "&lt;script&gt;&#60;b&#62;&amp;",
        "]]><!--<![CDATA[<b>",
        "<!DOCTYPE x [<!ENTITY e SYSTEM \"file:///etc/passwd\">]>&e;",
        "<?xml-stylesheet href=\"http://example.com\"?>",
        "=cmd|' /C calc'!A0",
        "@SUM(1+9)*cmd",
        "+1+cmd|'x'!A",
        "-2+3,\"quoted\",\r\nnew,row",
        "\t=1+1",
        ") Tj ET /JavaScript << /S /JavaScript /JS (app.alert(1)) >> \\) endstream endobj",
        "\\)\\(\\\\ 1 0 obj",
        "a\n  0\nSECTION\n  2\nENTITIES\n  0\nEOF",
        "a\r\n  0\r\nENDSEC",
        "a^J  0^JSECTION %%010 \\U+000A \\P {\\fArial;x}",
        "\u{1b}[2J\u{1b}]0;title\u{7}\u{9b}31m",
        "\u{202e}gnp.exe\u{2066}\u{200f}\u{61c}",
        "nul\u{1}\u{8}\u{b}\u{7f}\u{85}\u{2028}\u{2029}\u{fffe}\u{ffff}",
        "../../etc/passwd",
        "C:\\con\\aux.lole",
        "김 \u{1f33a} e\u{301}\u{301}\u{301}",
    ]
    .map(str::to_owned)
    .into();
    names.push("very long ".repeat(1000));
    names.push("<b>".repeat(1000));
    names
});

/// What is left of a page without its text: tags with the names of their attributes, and what runs.
#[derive(Debug, Default, PartialEq, Eq)]
struct Skeleton {
    tags: Vec<String>,
    /// What stands in scripts and styles.
    code: Vec<String>,
}

/// A page by the tokenizer of the HTML standard; its text is checked on the way.
fn skeleton(page: &str) -> Skeleton {
    let mut emitter = DefaultEmitter::default();
    // Texts of scripts and styles are no tags.
    emitter.naively_switch_states(true);
    let mut found = Skeleton::default();
    let mut inside_code = false;
    for Ok(token) in Tokenizer::new_with_emitter(page, emitter) {
        match token {
            Token::StartTag(tag) => {
                let name = String::from_utf8_lossy(&tag.name).into_owned();
                inside_code = ["script", "style"].contains(&name.as_str());
                let mut line = name;
                for (attribute, value) in &tag.attributes {
                    let attribute = String::from_utf8_lossy(attribute);
                    let value = String::from_utf8_lossy(value);
                    assert!(!attribute.starts_with("on"), "{attribute}={value}");
                    if ["href", "src", "action", "formaction"].contains(&attribute.as_ref()) {
                        let is_own = ["./", "#", "data:image/jpeg;", "data:video/mp4;"]
                            .iter()
                            .any(|start| value.starts_with(start));
                        assert!(is_own, "{attribute}={value}");
                    }
                    line = format!("{line} {attribute}");
                }
                found.tags.push(line);
            }
            Token::EndTag(tag) => {
                inside_code = false;
                let name = String::from_utf8_lossy(&tag.name);
                found.tags.push(format!("/{name}"));
            }
            Token::String(text) if inside_code => {
                found.code.push(String::from_utf8_lossy(&text).into_owned());
            }
            Token::String(text) => {
                let text = String::from_utf8_lossy(&text).into_owned();
                let turned = |letter: &char| is_unseen(*letter) && !"\n\t".contains(*letter);
                assert_eq!(text.chars().find(turned), None, "{text:?}");
            }
            Token::Doctype(_) => found.tags.push("doctype".to_owned()),
            Token::Comment(comment) => panic!("a comment: {comment:?}"),
            Token::Error(_) => {}
        }
    }
    found
}

/// A report in which every text is `name`.
fn page_of(name: &str) -> String {
    let text = || name.to_owned();
    let remark = || Remark {
        sentence: text(),
        sentence_ja: text(),
    };
    let mut report = RunReport {
        lole: text(),
        method: text(),
        dance_step: text(),
        renderer: text(),
        contact_body: text(),
        state_hash: text(),
        divergence: Some(ReportDivergence {
            time_s: 1.0,
            particle: 3,
            sentence: text(),
            sentence_ja: text(),
        }),
        no_room: vec![remark()],
        garments: vec![GarmentFacts {
            id: text(),
            name: text(),
            name_ja: text(),
            overlapping_places: 10,
            over: vec![ReportPieceOver {
                outer: text(),
                outer_ja: text(),
                inner: text(),
                inner_ja: text(),
                is_itself: false,
                places: 9,
            }],
            ..GarmentFacts::default()
        }],
        files: vec![ReportFile {
            name: text(),
            bytes: 10,
            what: text(),
        }],
        dancer: vec![DancerMeasure {
            key: text(),
            name: text(),
            name_ja: text(),
            on_body_cm: 83.5,
            given_cm: None,
            is_estimated: true,
        }],
        ..RunReport::default()
    };
    report.skirt.design_name = text();
    let json: serde_json::Value = serde_json::from_str(&report_json(&report).unwrap()).unwrap();
    assert_eq!(json["files"][0]["name"], name);
    let stills = [Still {
        caption_en: name,
        caption_ja: name,
        jpeg: &[1],
    }];
    let media = PageMedia {
        film: None,
        stills: &stills,
    };
    report_html(&report, media)
}

#[test]
fn a_page_has_the_tags_and_scripts_that_it_has_with_harmless_names() {
    let harmless = skeleton(&page_of(HARMLESS));
    assert!(harmless.code.iter().any(|code| code.contains("function")));
    for name in HOSTILE.iter() {
        assert_eq!(skeleton(&page_of(name)), harmless, "{name:?}");
    }
}

/// Elements and attributes of a drawing by a parser of XML, and its texts; the parser refuses what is no XML.
fn drawing(svg: &[u8]) -> (Vec<String>, Vec<String>) {
    let svg = std::str::from_utf8(svg).unwrap();
    let document = roxmltree::Document::parse(svg).unwrap_or_else(|error| panic!("{error}: {svg}"));
    let (mut elements, mut texts) = (Vec::new(), Vec::new());
    for node in document.descendants() {
        if node.is_element() {
            let attributes = node.attributes().map(|attribute| attribute.name());
            let attributes: Vec<&str> = attributes.collect();
            elements.push(format!(
                "{} {}",
                node.tag_name().name(),
                attributes.join(" ")
            ));
        } else if node.is_text() {
            texts.push(node.text().unwrap_or_default().to_owned());
        } else {
            assert!(node.is_root(), "{node:?}");
        }
    }
    (elements, texts)
}

fn sheet_of(name: &str) -> Sheet {
    let mut sheet = Sheet::new(Paper::A4.size_mm());
    sheet.text([20.0, 30.0], name, &TextStyle::body(), Align::Left);
    sheet
}

#[test]
fn a_drawing_is_xml_with_the_elements_that_it_has_with_harmless_names() {
    let (elements, texts) = drawing(&sheet_svg(&sheet_of(HARMLESS)));
    assert!(texts.iter().any(|text| text == HARMLESS));
    for name in HOSTILE.iter() {
        let (found, texts) = drawing(&sheet_svg(&sheet_of(name)));
        assert_eq!(found, elements, "{name:?}");
        let is_there = texts.iter().any(|text| text.len() + 2 >= name.trim().len());
        assert!(is_there, "{name:?} is missing: {texts:?}");
        let letters = texts.iter().flat_map(|text| text.chars());
        let unseen = letters.filter(|letter| is_unseen(*letter) && !"\n\t".contains(*letter));
        assert_eq!(unseen.count(), 0, "{name:?}");
    }
}

/// Keys of a PDF that run something, open something, or carry a file.
const LIVE_KEYS: [&str; 15] = [
    "JS",
    "JavaScript",
    "OpenAction",
    "AA",
    "A",
    "Launch",
    "URI",
    "SubmitForm",
    "ImportData",
    "GoToR",
    "EmbeddedFiles",
    "EF",
    "RichMedia",
    "XFA",
    "Annots",
];

/// Looks through everything of a PDF that may run; returns its title.
fn dead_pdf(bytes: &[u8]) -> String {
    let document = lopdf::Document::load_mem(bytes).unwrap();
    for object in document.objects.values() {
        no_live_keys(object);
    }
    for page in document.get_pages().into_values() {
        // The operators of every page can be read: no text has left its string.
        let content = document.get_and_decode_page_content(page).unwrap();
        assert!(!content.operations.is_empty());
    }
    let info = document
        .trailer
        .get(b"Info")
        .unwrap()
        .as_reference()
        .unwrap();
    let info = document.get_dictionary(info).unwrap();
    lopdf::decode_text_string(info.get(b"Title").unwrap()).unwrap()
}

fn no_live_keys(object: &lopdf::Object) {
    let dictionary = match object {
        lopdf::Object::Dictionary(dictionary) => dictionary,
        lopdf::Object::Stream(stream) => {
            if stream.dict.get_type().is_ok_and(|kind| kind == b"Metadata") {
                let text = stream.get_plain_content().unwrap();
                let text = std::str::from_utf8(&text).unwrap();
                assert!(roxmltree::Document::parse(text).is_ok(), "{text}");
            }
            &stream.dict
        }
        lopdf::Object::Array(objects) => return objects.iter().for_each(no_live_keys),
        _ => return,
    };
    for (key, value) in dictionary.iter() {
        let key = String::from_utf8_lossy(key);
        assert!(!LIVE_KEYS.contains(&key.as_ref()), "{key}: {value:?}");
        no_live_keys(value);
    }
}

/// A list of dancers as a spreadsheet writes it, by a writer that is not ours; names without what the list
/// refuses by itself.
fn list() -> Vec<u8> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    // A column that nobody reads is named in the notes.
    let heads = ["name", "stature", "hip", "<script>alert(1)</script>"];
    writer.write_record(heads).unwrap();
    for name in HOSTILE.iter() {
        let name = if 80 < name.chars().count() {
            &name[..80]
        } else {
            name
        };
        writer.write_record([name, "158", "91", "x"]).unwrap();
    }
    // A row that cannot be used is told with what it holds.
    writer
        .write_record(["<img src=x onerror=alert(1)>", "=cmd|x", "\u{202e}", ""])
        .unwrap();
    writer.into_inner().unwrap()
}

/// The order of everybody with a hostile name, called `title`.
fn order_of(title: &str) -> (OrderFolder, Group) {
    let design = Design {
        // Its pieces are patterns, in a file for each dancer that is called after her.
        garments: vec![GarmentDesign::of_kind("blouse").unwrap()],
        ..Design::default()
    };
    let list = roster::read(&list()).unwrap();
    let mut group = Group::of(&list);
    for dancer in list.dancers.iter() {
        group.add(dancer, &design, order::plan(dancer, &design));
    }
    let pictures = vec![None; group.plans.len()];
    let parts = OrderParts {
        title: title.to_owned(),
        design: &design,
        group: &group,
        pictures: &pictures,
        settings: &Settings::default(),
        paper: Paper::A4,
        language: Language::English,
        version: "test",
        kept_files: &[],
    };
    let folder = order_folder(&parts, &|| true).unwrap();
    (folder, group)
}

#[test]
fn the_pages_of_a_group_hold_no_action_and_its_files_have_plain_names() {
    let (folder, group) = order_of(&HOSTILE[16]);
    let (all, usable) = (HOSTILE.len(), group.plans.len());
    assert!(
        all < usable + 8,
        "only {usable} of {all} names are usable: {:?}",
        group.problems
    );
    let mut pdf_count = 0;
    for (name, bytes) in &folder.files {
        let is_plain = |letter: char| letter.is_alphanumeric() || "-.".contains(letter);
        assert!(
            name.chars().all(is_plain) && !name.contains(".."),
            "{name:?}"
        );
        assert!(name.len() < 255, "{name:?}");
        if name.ends_with(".pdf") {
            let title = dead_pdf(bytes);
            assert_eq!(title.chars().find(|letter| letter.is_control()), None);
            pdf_count += 1;
        }
    }
    assert_eq!(pdf_count, 2 + usable);
    for name in HOSTILE.iter() {
        let document = Document::new(name, Language::English, vec![sheet_of(name)]);
        let title = dead_pdf(&document.to_bytes().unwrap());
        assert_eq!(title, printable(name));
        assert_eq!(title.chars().find(|letter| is_unseen(*letter)), None);
        let layer = Layer {
            name: name.to_string(),
            items: sheet_of(name).items,
        };
        let layered = LayeredSheet {
            base: sheet_of(name),
            layers: vec![layer],
        };
        assert_eq!(
            dead_pdf(&layered.to_bytes(name, Language::English).unwrap()),
            title
        );
    }
}

/// Kinds of what is in a drawing of a pattern, block by block, by a reader that is not ours.
fn blocks(dxf: &[u8]) -> Vec<Vec<String>> {
    let drawing = dxf::Drawing::load(&mut std::io::Cursor::new(dxf)).unwrap();
    let kind = |entity: &dxf::entities::Entity| {
        let kind = format!("{:?}", entity.specific);
        let end = kind.find('(').unwrap_or(kind.len());
        kind[..end].to_owned()
    };
    let mut found: Vec<Vec<String>> = drawing
        .blocks()
        .map(|block| block.entities.iter().map(kind).collect())
        .collect();
    found.push(drawing.entities().map(kind).collect());
    found
}

#[test]
fn a_pattern_for_programs_has_the_parts_that_it_has_with_harmless_names() {
    let design = Design::default();
    let tape = lole_body::Measurements::from_tape(&design.tape()).unwrap();
    let dancer = lole_body::Dancer::new(&tape).unwrap();
    let garment = tailoring::patterns_of(&design, &dancer).unwrap().remove(0);
    let cut = CutGarment {
        plans: garment.cloth_plans(Lay::Single, None),
        garment,
        print: None,
        owner: String::new(),
        stamp: lole_export::cutting::Stamp::default(),
    };
    let harmless = pattern_dxf(&cut, HARMLESS);
    let line_count = |dxf: &[u8]| dxf.split(|byte| *byte == b'\n').count();
    for name in HOSTILE.iter() {
        let found = pattern_dxf(&cut, name);
        assert_eq!(blocks(&found), blocks(&harmless), "{name:?}");
        assert_eq!(line_count(&found), line_count(&harmless), "{name:?}");
        let text = String::from_utf8(found).unwrap();
        let spells = ["^", "%%", "\\"].into_iter().find(|one| text.contains(one));
        assert_eq!(spells, None, "{name:?}");
        assert!(text.is_ascii(), "{name:?}");
        assert!(text.lines().all(|line| line.len() <= 255), "{name:?}");
    }
}

#[test]
fn data_give_every_name_back_as_it_was() {
    let (folder, group) = order_of(HARMLESS);
    let file = folder.files.iter().find(|(name, _)| name == ORDER_JSON);
    let json: serde_json::Value = serde_json::from_slice(&file.unwrap().1).unwrap();
    let names: Vec<&str> = (json["dancers"].as_array().unwrap().iter())
        .filter_map(|dancer| dancer["name"].as_str())
        .collect();
    let expected: Vec<&str> = group.plans.iter().map(|plan| plan.name.as_str()).collect();
    assert_eq!(names, expected);
    let listed: BTreeSet<&str> = (json["files"].as_array().unwrap().iter())
        .filter_map(|file| file.as_str())
        .collect();
    let written = folder.files.iter().map(|(name, _)| name.as_str());
    assert_eq!(written.collect::<BTreeSet<_>>(), listed);
    for name in HOSTILE.iter() {
        let sheet = DancerSheet {
            avatar: Some(name.clone()),
            license: vec![name.clone()],
            ..DancerSheet::default()
        };
        let json: serde_json::Value = serde_json::from_str(&dancer_json(&sheet).unwrap()).unwrap();
        assert_eq!(json["avatar"], name.as_str());
        assert_eq!(json["license"][0], name.as_str());
    }
}

#[test]
fn a_design_keeps_the_name_of_its_cloth_as_text() {
    for name in HOSTILE.iter() {
        let mut design = Design::default();
        design.fabric.name = Some(name.clone());
        let text = to_toml(&design);
        // Names on several lines are refused when they are read, with their line.
        match parse(&text, "again.lole") {
            Ok(read) => assert_eq!(read.fabric.name.as_ref(), Some(name)),
            Err(error) => {
                let is_refused = name.chars().any(char::is_control) || 1000 < name.len();
                assert!(is_refused && error.line.is_some(), "{name:?}: {error}");
            }
        }
    }
}

#[test]
fn a_spreadsheet_computes_no_cell() {
    for name in HOSTILE.iter() {
        let run = RunEntry {
            outcome: name.clone(),
            ..RunEntry::default()
        };
        let mut report = StudyReport {
            causes: vec![CauseEntry {
                name: name.clone(),
                same_step: run.clone(),
                ..CauseEntry::default()
            }],
            steps: vec![StepEntry {
                method: name.clone(),
                phase: 0.1,
                run: run.clone(),
            }],
            capsules: vec![CapsulesEntry {
                body: name.clone(),
                ..CapsulesEntry::default()
            }],
            ..StudyReport::default()
        };
        let entry = report.integrators.entry(name.clone()).or_default();
        entry.same_step = run;
        let table = study_csv(&report);
        // A reader that refuses rows of another length than the first.
        let mut reader = csv::Reader::from_reader(table.as_bytes());
        let rows: Vec<csv::StringRecord> = reader.records().collect::<Result<_, _>>().unwrap();
        assert_eq!(rows.len(), 4, "{name:?}");
        for cell in rows.iter().flatten() {
            let is_number = cell.parse::<f64>().is_ok();
            let is_computed = cell.starts_with(['=', '+', '-', '@', '\t', '\r', '\n']);
            assert!(is_number || !is_computed, "{cell:?}");
        }
    }
}
