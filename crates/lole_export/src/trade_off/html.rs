//! The page: for every scene its points over time, the line of the best, and their table.

use super::{TradeOff, TradeOffPoint, TradeOffReport};
use crate::page::plot::{Curve, Drawn, Floor, Plot, Scale, svg};
use crate::page::text::{both, escape, number};
use crate::page::{Page, heading, table};

/// The whole page.
pub(super) fn page(report: &TradeOffReport) -> String {
    let about = both(
        "What more time for a frame buys, scene by scene, on this machine",
        "この機械で1コマに時間をかけると何が良くなるか（場面ごと）",
    );
    let body: String = report.scenes.iter().map(scene).collect();
    Page {
        title: "Lole bench",
        about: &about,
        body: &body,
        lole: &report.lole,
    }
    .html()
}

fn scene(scene: &TradeOff) -> String {
    let name = format!("<code>{}</code>", escape(&scene.scene));
    let about = escape(&scene.about);
    let mut front: Vec<_> = scene.points.iter().filter(|point| point.on_front).collect();
    front.sort_by(|a, b| a.frame_ms.total_cmp(&b.frame_ms));
    let about_ja = "線の上の点より速くて良いものはありません。太字はこの場面の設定です。";
    let about_en = format!("{about} Nothing beats the points on the line. Bold: the scene’s own.");
    heading(&name, &name, [&about_en, about_ja]) + &plot(scene, &front) + &rows(&front, scene)
}

/// The front as a line, and the points of every method around it.
fn plot(scene: &TradeOff, front: &[&TradeOffPoint]) -> String {
    let columns = |points: &mut dyn Iterator<Item = &TradeOffPoint>| -> [Vec<f64>; 2] {
        let (along, values) = points
            .map(|point| (point.frame_ms, point.strain_p99_pct))
            .unzip();
        [along, values]
    };
    let line = columns(&mut front.iter().copied());
    let mut methods: Vec<&str> = scene.points.iter().map(|p| p.method.as_str()).collect();
    methods.dedup();
    let of_methods: Vec<_> = methods
        .iter()
        .map(|&method| columns(&mut scene.points.iter().filter(|point| point.method == method)))
        .collect();
    let mut curves = vec![Curve {
        name: "best · 最良",
        along: &line[0],
        values: &line[1],
        drawn: Drawn::Line,
    }];
    for (&method, points) in methods.iter().zip(&of_methods) {
        curves.push(Curve {
            name: method,
            along: &points[0],
            values: &points[1],
            drawn: Drawn::Dots,
        });
    }
    let drawing = svg(&Plot {
        curves,
        reference: None,
        floor: Floor::Zero,
        scale: Scale::Linear,
    });
    let title = both(
        "99th percentile of the strain (%) over time of a frame (ms)",
        "ひずみの 99 パーセンタイル（%）、横軸は1コマの時間（ミリ秒）",
    );
    drawing.map_or_else(String::new, |drawing| {
        format!("<div class=\"plots\"><figure><h3>{title}</h3>{drawing}</figure></div>\n")
    })
}

/// The points of the front, and the scene's own where it is not among them.
fn rows(front: &[&TradeOffPoint], scene: &TradeOff) -> String {
    let head = [
        both("Method", "方法"),
        both("Settings", "設定"),
        both("Frame (ms)", "1コマ（ミリ秒）"),
        both("Strain p99 (%)", "ひずみ p99（%）"),
        both("Strain max (%)", "ひずみ最大（%）"),
        both("Longest phase", "最も長い段階"),
    ];
    let beaten = (scene.points.iter()).filter(|point| point.is_own && !point.on_front);
    let rows: Vec<Vec<String>> = front.iter().copied().chain(beaten).map(cells).collect();
    table(&head, &rows)
}

fn cells(point: &TradeOffPoint) -> Vec<String> {
    let settings = both(
        &escape(&point.settings.sentence),
        &escape(&point.settings.sentence_ja),
    );
    let longest = point.longest_phase.as_deref().unwrap_or("–");
    vec![
        format!("<code>{}</code>", escape(&point.method)),
        if point.is_own {
            format!("<strong>{settings}</strong>")
        } else {
            settings
        },
        number(point.frame_ms, 3),
        number(point.strain_p99_pct, 2),
        number(point.strain_max_pct, 2),
        format!("<code>{}</code>", escape(longest)),
    ]
}
