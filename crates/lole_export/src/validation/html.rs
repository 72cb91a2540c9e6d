//! The page: for every protocol a table, its limits and its curve.

use super::{CheckEntry, CurveEntry, ProtocolEntry, ValidationReport};
use crate::page::plot::{Curve, Drawn, Floor, Plot, Scale, svg};
use crate::page::text::{both, escape};
use crate::page::{Page, heading, table};
use crate::report::Remark;

/// The whole page.
pub(super) fn page(report: &ValidationReport) -> String {
    let rows = || report.protocols.iter().flat_map(|protocol| &protocol.rows);
    let passed = rows().filter(|row| row.pass).count();
    let count = rows().count();
    let about = both(
        &format!("The engine against closed forms: {passed} of {count} figures within their gates"),
        &format!("布の計算と理論の値の比較: {count} 件のうち {passed} 件が許容内"),
    );
    let body: String = report.protocols.iter().map(protocol).collect();
    Page {
        title: "Lole validate",
        about: &about,
        body: &body,
        lole: &report.lole,
    }
    .html()
}

fn protocol(entry: &ProtocolEntry) -> String {
    let about = [&entry.about.sentence, &entry.about.sentence_ja].map(|text| escape(text));
    let name = format!("<code>{}</code>", escape(&entry.name));
    heading(&name, &name, [&about[0], &about[1]])
        + &plot(entry)
        + &rows(&entry.rows)
        + &limits(&entry.limits)
}

fn rows(rows: &[CheckEntry]) -> String {
    let head = [
        both("Method", "方法"),
        both("Case", "条件"),
        both("Measured", "実測"),
        both("Reference", "基準"),
        both("Unit", "単位"),
        both("Error (%)", "誤差（%）"),
        both("Passes from", "合格の下限"),
        both("to", "上限"),
        String::new(),
    ];
    let rows: Vec<Vec<String>> = rows.iter().map(cells).collect();
    table(&head, &rows)
}

fn cells(row: &CheckEntry) -> Vec<String> {
    let verdict = if row.pass {
        both("pass", "合格")
    } else {
        format!("<strong>{}</strong>", both("FAIL", "不合格"))
    };
    vec![
        format!("<code>{}</code>", escape(&row.method)),
        escape(&row.case),
        digits(row.measured),
        digits(row.reference),
        escape(&row.unit),
        digits(row.error_pct),
        digits(row.bounds[0]),
        digits(row.bounds[1]),
        verdict,
    ]
}

/// Five significant digits; a dash for what is no number.
fn digits(value: f64) -> String {
    let size = value.abs();
    if !value.is_finite() {
        "–".to_owned()
    } else if size < 1e-12 {
        "0".to_owned()
    } else if (1e-3..1e5).contains(&size) {
        let text = if size < 1.0 {
            format!("{value:.5}")
        } else {
            format!("{value:.4}")
        };
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        format!("{value:.2e}")
    }
}

fn limits(limits: &[(String, Remark)]) -> String {
    limits
        .iter()
        .map(|(method, limit)| {
            format!(
                "<p class=\"note\"><code>{}</code>: {}</p>\n",
                escape(method),
                both(&escape(&limit.sentence), &escape(&limit.sentence_ja)),
            )
        })
        .collect()
}

/// The curve with the measured points of every method on it.
fn plot(entry: &ProtocolEntry) -> String {
    let Some(curve) = &entry.curve else {
        return String::new();
    };
    let known = columns(curve.points.iter().copied());
    let mut methods: Vec<&str> = Vec::new();
    for row in entry.rows.iter().filter(|row| row.along.is_some()) {
        if !methods.contains(&row.method.as_str()) {
            methods.push(&row.method);
        }
    }
    let measured: Vec<_> = methods
        .iter()
        .map(|&method| {
            let rows = entry.rows.iter().filter(|row| row.method == method);
            columns(rows.filter_map(|row| Some([row.along?, row.measured])))
        })
        .collect();
    let mut curves = vec![Curve {
        name: "theory · 理論",
        along: &known[0],
        values: &known[1],
        drawn: Drawn::Line,
    }];
    for (index, (method, points)) in methods.iter().zip(&measured).enumerate() {
        curves.push(Curve {
            name: method,
            along: &points[0],
            values: &points[1],
            drawn: if index == 0 {
                Drawn::Rings
            } else {
                Drawn::Dots
            },
        });
    }
    let drawing = svg(&Plot {
        curves,
        reference: None,
        floor: Floor::Zero,
        scale: Scale::Linear,
    });
    drawing.map_or_else(String::new, |drawing| {
        format!(
            "<div class=\"plots\"><figure><h3>{}</h3>{drawing}</figure></div>\n",
            title(curve),
        )
    })
}

fn title(curve: &CurveEntry) -> String {
    let [english, japanese] = [
        [&curve.value.sentence, &curve.along.sentence],
        [&curve.value.sentence_ja, &curve.along.sentence_ja],
    ]
    .map(|texts| texts.map(|text| escape(text)));
    both(
        &format!("{} over {}", english[0], english[1]),
        &format!("{}（横軸は{}）", japanese[0], japanese[1]),
    )
}

fn columns(points: impl Iterator<Item = [f64; 2]>) -> [Vec<f64>; 2] {
    let (along, values) = points.map(|[along, value]| (along, value)).unzip();
    [along, values]
}
