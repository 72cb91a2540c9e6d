//! The page of quality against time, as a reader's browser gets it.

use lole_export::trade_off::{TradeOff, TradeOffPoint, TradeOffReport, trade_off_html};

fn point(
    method: &str,
    [frame_ms, strain]: [f64; 2],
    [is_own, on_front]: [bool; 2],
) -> TradeOffPoint {
    TradeOffPoint {
        method: method.to_owned(),
        is_own,
        frame_ms,
        strain_p99_pct: strain,
        strain_max_pct: 2.0 * strain,
        on_front,
        ..TradeOffPoint::default()
    }
}

#[test]
fn every_point_has_its_dot_and_the_front_is_one_line_from_fast_to_good() {
    let report = TradeOffReport {
        lole: "1 < 2".to_owned(),
        scenes: vec![TradeOff {
            scene: "skirt".to_owned(),
            about: "Sways.".to_owned(),
            points: vec![
                point("xpbd", [4.0, 1.0], [false, true]),
                point("xpbd", [1.0, 5.0], [false, true]),
                point("xpbd", [3.0, 6.0], [true, false]),
                point("explicit-rows", [9.0, 0.5], [false, true]),
            ],
        }],
    };
    let page = trade_off_html(&report);
    assert_eq!(page.matches("<circle").count(), 4);
    assert_eq!(page.matches("<path class=\"curve").count(), 1);
    let path = &page[page.find("d=\"").expect("a line")..];
    let path = &path[..path[3..].find('"').expect("its end") + 3];
    assert_eq!(path.matches('L').count(), 2, "three points: {path}");
    // The front and the scene's own, which something beats.
    assert_eq!(page.matches("<tr><td>").count(), 4);
    assert!(page.contains("1 &lt; 2") && page.contains("ひずみ"));
    assert!(!page.contains("http"), "the page loads nothing");
}
