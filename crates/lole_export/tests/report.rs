//! The report keeps NaN out of JSON and names out of markup, and tells everything twice.

#![allow(
    clippy::unwrap_used,
    clippy::cast_possible_truncation,
    reason = "a test that meets anything unexpected should stop"
)]

use lole_export::report::{
    DancerMeasure, GarmentFacts, PageFilm, PageMedia, ReportDivergence, ReportFile,
    ReportPieceOver, RunReport, RunSeries, Still, Worst, report_html, report_json,
};
use serde_json::Value;

fn report() -> RunReport {
    RunReport {
        lole: "0.1.0".into(),
        particles: 25_600,
        method: "xpbd".into(),
        dance_step: "kaholo".into(),
        frames: 4,
        finite: true,
        state_hash: "00ff00ff00ff00ff".into(),
        files: vec![ReportFile {
            name: "dancer.glb".into(),
            bytes: 28_800_000,
            what: "The dancer in 3D.".into(),
        }],
        series: RunSeries {
            time_s: vec![0.0, 0.1, 0.2, 0.3],
            frame_ms: vec![3.0, f64::NAN, 4.0, 5.0],
            ..RunSeries::default()
        },
        ..RunReport::default()
    }
}

#[test]
fn numbers_that_are_not_finite_become_null() {
    let mut report = report();
    report.strain_pct.max = f64::INFINITY;
    report.hem_height_cm.mean = f64::NAN;
    let text = report_json(&report).unwrap();
    let json: Value = serde_json::from_str(&text).unwrap();
    assert!(json["strain_pct"]["max"].is_null() && json["hem_height_cm"]["mean"].is_null());
    assert!(json["series"]["frame_ms"][1].is_null());
    assert_eq!(json["series"]["frame_ms"][2], 4.0);
    assert_eq!(json["files"][0]["name"], "dancer.glb");
}

#[test]
fn every_promised_key_is_in_the_json() {
    let json: Value = serde_json::from_str(&report_json(&report()).unwrap()).unwrap();
    for path in [
        "/particles",
        "/springs",
        "/method",
        "/substeps",
        "/threads",
        "/frames",
        "/frame_ms/median",
        "/frame_ms/p99",
        "/frame_wall_ms/median",
        "/frame_wall_ms/p99",
        "/realtime_factor",
        "/strain_pct/mean",
        "/strain_pct/p99",
        "/strain_pct/max",
        "/strain_end_pct/mean",
        "/strain_end_pct/p99",
        "/strain_end_pct/max",
        "/capsule_penetration_mm/worst",
        "/skin_penetration_mm/worst",
        "/skin_penetration_vertices/worst",
        "/hem_height_cm/min",
        "/hem_height_cm/mean",
        "/hem_height_cm/max",
        "/finite",
        "/state_hash",
        "/files/0/bytes",
    ] {
        assert!(json.pointer(path).is_some(), "{path}");
    }
}

#[test]
fn what_was_not_measured_is_shown_as_estimated() {
    let mut report = report();
    let measure = |key: &str, given_cm: Option<f64>| DancerMeasure {
        key: key.into(),
        name: "bust girth".into(),
        name_ja: "バスト".into(),
        on_body_cm: 83.5,
        given_cm,
        is_estimated: given_cm.is_none(),
    };
    report.dancer = vec![measure("bust_cm", Some(83.5))];
    let page = |report: &RunReport| report_html(report, PageMedia::default());
    assert!(page(&report).contains("83.5") && !page(&report).contains("Estimated"));
    report.dancer.push(measure("waist_cm", None));
    let html = page(&report);
    assert_eq!(html.matches("Estimated").count(), 1);
    assert_eq!(html.matches("推定した値").count(), 1);
    let json: Value = serde_json::from_str(&report_json(&report).unwrap()).unwrap();
    assert_eq!(json["dancer"][0]["is_estimated"], false);
    assert_eq!(json["dancer"][1]["is_estimated"], true);
    assert!(json["dancer"][1]["given_cm"].is_null());
}

#[test]
fn the_page_says_which_piece_of_a_garment_lies_outside() {
    let over = |outer: &str, inner: &str, places| ReportPieceOver {
        outer: outer.into(),
        outer_ja: format!("外{outer}"),
        inner: inner.into(),
        inner_ja: format!("内{inner}"),
        is_itself: outer == inner,
        places,
    };
    let mut report = report();
    let page = |report: &RunReport| report_html(report, PageMedia::default());
    assert!(!page(&report).contains("What lies over what"));
    report.garments = vec![GarmentFacts {
        id: "kikepa".into(),
        name: "kīkepa".into(),
        name_ja: "キーケパ".into(),
        overlapping_places: 1_300,
        over: vec![over("flap", "band", 1_200), over("sheet", "sheet", 100)],
        inverted_places: Worst { worst: 7 },
    }];
    let html = page(&report);
    for words in [
        "What lies over what",
        "布の重なり",
        "kīkepa: flap over band",
        "キーケパ: 内bandの外側に外flap",
        "sheet over itself",
        "the wrong way round",
    ] {
        assert!(html.contains(words), "{words}");
    }
    let json: Value = serde_json::from_str(&report_json(&report).unwrap()).unwrap();
    assert_eq!(json["garments"][0]["over"][0]["outer"], "flap");
    assert_eq!(json["garments"][0]["inverted_places"]["worst"], 7);
}

#[test]
fn names_cannot_become_markup() {
    let mut report = report();
    let attack = "<script>alert('1')</script>\"><img src=x onerror=alert(2)>";
    report.skirt.design_name = attack.into();
    report.renderer = attack.into();
    report.method = attack.into();
    report.dance_step = attack.into();
    report.state_hash = attack.into();
    report.files[0].name = attack.into();
    report.files[0].what = attack.into();
    report.divergence = Some(ReportDivergence {
        time_s: 1.0,
        particle: 3,
        sentence: attack.into(),
        sentence_ja: attack.into(),
    });
    let stills = [Still {
        caption_en: attack,
        caption_ja: attack,
        jpeg: &[1],
    }];
    let page = report_html(
        &report,
        PageMedia {
            film: None,
            stills: &stills,
        },
    );
    assert_eq!(page.matches("<script>").count(), 1, "only the page's own");
    assert!(!page.contains("<img src=x") && !page.contains("onerror=alert(2)>\""));
}

#[test]
fn the_page_needs_nothing_from_outside() {
    let stills = [Still {
        caption_en: "Front",
        caption_ja: "正面",
        jpeg: &[0xff, 0xd8],
    }];
    let page = report_html(
        &report(),
        PageMedia {
            film: Some(PageFilm::Held(&[0; 9])),
            stills: &stills,
        },
    );
    assert!(!page.contains("http://") && !page.contains("https://") && !page.contains("@import"));
    assert!(page.contains("data:video/mp4;base64,AAAAAAAAAAAA") && page.contains("playsinline"));
    assert!(page.contains("data:image/jpeg;base64,/9g="));
    assert!(page.contains("href=\"./dancer.glb\""));
}

#[test]
fn a_long_film_stays_beside_the_page() {
    let film = Some(PageFilm::Beside("dance.mp4"));
    let stills = &[];
    let page = report_html(&report(), PageMedia { film, stills });
    assert!(page.contains("src=\"./dance.mp4\"") && !page.contains("data:video"));
}

#[test]
fn everything_is_said_in_both_languages() {
    let mut report = report();
    report.divergence = Some(ReportDivergence::default());
    report.skirt.is_worn = true;
    let page = report_html(&report, PageMedia::default());
    let (english, japanese) = (page.matches("lang=\"en\">"), page.matches("lang=\"ja\">"));
    // The page itself declares Japanese once more.
    assert_eq!(english.count() + 1, japanese.count());
    assert!(page.contains("kāholo") && page.contains("パウスカート") && page.contains("用尺"));
    assert!(!page.contains("NaN") && !page.contains("inf "));
}
