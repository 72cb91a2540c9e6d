//! The validation's page: complete, in both languages, and free of what is not a number.

use lole_export::report::Remark;
use lole_export::validation::{
    CheckEntry, CurveEntry, ProtocolEntry, ValidationReport, validation_html,
};

fn remark(english: &str) -> Remark {
    Remark {
        sentence: english.to_owned(),
        sentence_ja: "ことば".to_owned(),
    }
}

fn row(method: &str, measured: f64) -> CheckEntry {
    CheckEntry {
        name: "sag".to_owned(),
        case: "a < b".to_owned(),
        method: method.to_owned(),
        measured,
        reference: 2.0,
        error_pct: 50.0 * (measured - 2.0),
        gate_pct: 1.0,
        bounds: [1.98, 2.02],
        pass: measured.is_finite(),
        along: Some(1.5),
        ..CheckEntry::default()
    }
}

fn report() -> ValidationReport {
    ValidationReport {
        lole: "0".to_owned(),
        protocols: vec![ProtocolEntry {
            name: "sag".to_owned(),
            about: remark("how <far> it hangs"),
            rows: vec![
                row("first", 2.01),
                row("second", 1.99),
                row("third", f64::NAN),
            ],
            limits: vec![("second".to_owned(), remark("why & how"))],
            curve: Some(CurveEntry {
                along: remark("length"),
                value: remark("depth"),
                points: vec![[0.0, 0.0], [1.0, 1.0], [2.0, 4.0]],
            }),
        }],
    }
}

#[test]
fn every_figure_limit_and_point_is_on_the_page() {
    let page = validation_html(&report());
    for text in [
        "2.01",
        "1.99",
        "why &amp; how",
        "how &lt;far&gt; it hangs",
        "a &lt; b",
        "ことば",
    ] {
        assert!(page.contains(text), "{text}");
    }
    assert_eq!(page.matches("<circle").count(), 2, "the third has no place");
    assert_eq!(page.matches("<path class=\"curve").count(), 1);
    assert!(page.contains("2 of 3 figures") && page.contains("FAIL"));
    assert!(!page.contains("NaN") && !page.contains("inf"));
}

#[test]
fn a_protocol_without_a_curve_has_no_plot() {
    let mut report = report();
    report.protocols[0].curve = None;
    assert!(!validation_html(&report).contains("<svg"));
}
