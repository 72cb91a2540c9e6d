//! Booklets and orders as they are printed: every letter has a glyph, nothing leaves its page, equal
//! designs give equal bytes.

use lole_body::{Dancer, Measurements};
use lole_costume::cost;
use lole_costume::document::{Design, GarmentDesign};
use lole_costume::order::{self, DancerPlan, Settings};
use lole_costume::roster;
use lole_costume::tailoring::{self, DraftedBy};
use lole_export::booklet::{Booklet, booklet_sheets};
use lole_export::order::{Order, order_json, order_sheets};
use lole_export::pdf::{Document, Item, Paper, Sheet, missing_glyphs};
use lole_garment::template::{PAU_SKIRT, PAU_TOP};
use lole_language::{Language, Sentence};
use lole_pattern::{Alteration, Measure, Tailored};

const LANGUAGES: [Language; 2] = [Language::Japanese, Language::English];

/// A double pāʻū with a top, and prices for all but the thread.
fn design() -> Design {
    let mut design = Design::default();
    design.dancer.hip_cm = Some(91.4);
    design.garments = [&PAU_SKIRT, &PAU_TOP].map(GarmentDesign::new).into();
    design.fabric.price_per_m = Some(1480.0);
    design.cost.elastic_price_per_m = Some(60.0);
    design.cost.wage_per_h = Some(1000.0);
    design.cost.bought_price = Some(18_000.0);
    design
}

/// A fitted top, altered.
fn blouse() -> Design {
    let mut design = Design::default();
    design.skirt.is_worn = false;
    design.garments = GarmentDesign::of_kind("blouse").into_iter().collect();
    design.alterations = design.alterations.with_cm(Alteration::RoundBack, 1.5);
    design
}

/// What a design's costume is drafted by.
fn drafted_by(design: &Design) -> DraftedBy {
    let measurements = Measurements::from_tape(&design.tape());
    let dancer = measurements.and_then(|it| Dancer::to_measure(&it, &design.appearance()));
    let dancer = dancer.unwrap_or_else(|error| panic!("{error}"));
    tailoring::drafted_by(design, &dancer)
}

fn plan(design: &Design) -> DancerPlan {
    order::plan_design("ʻIolana 高橋", design).unwrap_or_else(|error| panic!("{error}"))
}

fn pages(design: &Design, plan: &DancerPlan, language: Language) -> Vec<Sheet> {
    let bill = cost::bill(design, plan);
    let booklet = Booklet {
        title: "Pāʻū".to_owned(),
        plan,
        group: &[],
        prints: &[],
        bill: &bill,
        drafted_by: &drafted_by(design),
        worn: None,
        hem_height_cm: design.costume_hem_cm(),
    };
    booklet_sheets(&booklet, Paper::A4, language)
}

/// The group order of a short list.
fn group_pages(language: Language) -> Vec<Sheet> {
    let design = design();
    let list =
        "名前,身長,ヒップ\n高橋 花子,158,91.4\nʻIolana Kealoha-Nakamura,171,104\nみどり,149,84\n";
    let roster = roster::read(list.as_bytes()).unwrap_or_else(|error| panic!("{error}"));
    let plans: Vec<DancerPlan> = (roster.dancers.iter())
        .filter_map(|dancer| order::plan(dancer, &design).ok())
        .collect();
    assert_eq!(plans.len(), 3);
    let settings = Settings {
        bolt_length: Some(lole_geom::Length::from_m(8.0)),
        ..Settings::default()
    };
    let bills: Vec<cost::Bill> = plans.iter().map(|plan| cost::bill(&design, plan)).collect();
    let prints = order::prints(&plans, &design, &settings);
    let problems = [Sentence::new("5 行目: 空です", "line 5: it is empty")];
    let order = Order {
        title: "Pāʻū".to_owned(),
        hem_height_cm: Some(22.0),
        plans: &plans,
        pictures: &[],
        prints: &prints,
        notions: &order::notions(&plans, &settings),
        bills: &bills,
        total: &cost::group_bill(&design, &plans, &prints),
        problems: &problems,
        notes: &[],
        settings: &settings,
        spool_m: design.cost.thread_spool_m,
    };
    let json = order_json(&order, "test", &["order.pdf"]).unwrap_or_else(|error| panic!("{error}"));
    let json: serde_json::Value = serde_json::from_str(&json).unwrap_or_default();
    assert_eq!(json["dancers"][0]["garments"][1]["cut_cm"][0][0], 367.6);
    let elastic = &json["dancers"][0]["garments"][1]["elastics"][0];
    assert_eq!(elastic["count"], 3);
    order_sheets(&order, Paper::A4, language)
}

/// Texts lie between the edges of their page; returns how many there are.
fn check(sheets: &[Sheet]) -> usize {
    let mut count = 0;
    for (number, sheet) in sheets.iter().enumerate() {
        for text in sheet.texts() {
            assert!(
                missing_glyphs(text).is_empty(),
                "{text}: {:?}",
                missing_glyphs(text)
            );
            count += 1;
        }
        for item in &sheet.items {
            let Item::Text { at, text, style } = item else {
                continue;
            };
            let end = at[0] + style.width_of(text);
            let is_inside = 8.0 <= at[0] && end <= sheet.size[0] - 8.0;
            assert!(
                is_inside,
                "page {}: {text} from {} to {end}",
                number + 1,
                at[0]
            );
            assert!(0.0 < at[1] && at[1] < sheet.size[1] - 4.0, "{text}");
        }
    }
    count
}

#[test]
fn everything_that_is_printed_has_glyphs_and_stays_on_its_page() {
    let design = design();
    let plan = plan(&design);
    for language in LANGUAGES {
        assert!(200 < check(&pages(&design, &plan, language)));
        assert!(50 < check(&group_pages(language)));
    }
}

/// A booklet of something fitted says how it is tried on and altered, and by how much it is altered now; one of a
/// skirt does not.
#[test]
fn a_trial_is_described_where_something_is_fitted() {
    for language in LANGUAGES {
        let title = language.pick("仮縫いと補正", "A trial in basted cloth, and alterations");
        let has = |sheets: &[Sheet], wanted: &str| {
            let mut texts = sheets.iter().flat_map(Sheet::texts);
            texts.any(|text| text.contains(wanted))
        };
        let fitted = pages(&blouse(), &plan(&blouse()), language);
        check(&fitted);
        assert!(has(&fitted, title) && has(&fitted, "+1.5 cm"));
        for alteration in Alteration::ALL {
            assert!(has(&fitted, alteration.name().text(language)));
        }
        assert!(!has(&pages(&design(), &plan(&design()), language), title));
    }
}

/// What a tape has said stands in the table as measured, to the millimeter; before that it is a guess.
#[test]
fn what_was_taken_for_drafting_is_no_estimate() {
    let plain = blouse();
    let mut taken = plain.clone();
    let own = drafted_by(&plain).measures;
    let used = |measure| own.iter().any(|used| used.measure == measure);
    for tailored in Tailored::ALL {
        let own = own.iter().find(|it| it.measure == tailored.measure());
        let cm = own.map(|it| (10.0 * it.length.to_cm()).round() / 10.0);
        taken.dancer.tailor_tape = taken.dancer.tailor_tape.with_cm(tailored, cm);
    }
    let after = drafted_by(&taken).measures;
    assert!(own.iter().all(|it| !it.is_taken));
    for it in &after {
        let is_tailored = Tailored::ALL.iter().any(|one| one.measure() == it.measure);
        assert_eq!(it.is_taken, is_tailored, "{:?}", it.measure);
    }
    assert!(used(Measure::NeckGirth) && used(Measure::UpperArmGirth) && used(Measure::BackLength));
    for language in LANGUAGES {
        let word = language.pick("推定", "estimated");
        let count = |design: &Design| {
            let sheets = pages(design, &plan(design), language);
            let texts = sheets.iter().flat_map(Sheet::texts);
            texts.filter(|text| *text == word).count()
        };
        let (before, left) = (count(&plain), count(&taken));
        let tailored = after.iter().filter(|it| it.is_taken).count();
        assert_eq!(before, left + tailored, "{language:?}");
    }
}

#[test]
fn body_text_is_large_enough_for_old_eyes() {
    let design = design();
    for language in LANGUAGES {
        let sheets = pages(&design, &plan(&design), language);
        let steps = design_steps(&design, language);
        for item in sheets.iter().flat_map(|sheet| &sheet.items) {
            if let Item::Text { text, style, .. } = item {
                let is_body = 20 < text.chars().count()
                    && steps.iter().any(|step| step.contains(text.as_str()));
                assert!(
                    !is_body || 12.0 <= style.size_pt,
                    "{text}: {} pt",
                    style.size_pt
                );
            }
        }
    }
}

fn design_steps(design: &Design, language: Language) -> Vec<String> {
    use lole_language::Bilingual as _;
    let garments = plan(design).garments;
    let steps = garments
        .iter()
        .flat_map(|garment| &garment.tailored.pattern.steps);
    steps.map(|step| step.by_machine.text(language)).collect()
}

#[test]
fn equal_designs_give_equal_bytes() {
    let design = design();
    let bytes = || {
        let document = Document {
            title: "Pāʻū".to_owned(),
            language: "ja",
            sheets: pages(&design, &plan(&design), Language::Japanese),
        };
        document
            .to_bytes()
            .unwrap_or_else(|error| panic!("{error}"))
    };
    assert_eq!(bytes(), bytes());
}
