//! The page of the study: the picture, the paper's sentences beside ours, tables and curves.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;

use super::{RunEntry, StudyReport};
use crate::page::plot::{Curve, Drawn, Floor, Plot, Scale, svg};
use crate::page::text::{both, dance_step, escape, grouped, number};
use crate::page::{Page, heading, table};

/// The methods in the order of the page: the paper's three first.
const ORDER: [&str; 5] = [
    "euler",
    "fb-euler",
    "rk-as-printed",
    "rk4",
    "rk-double-counted",
];

/// The whole page.
pub(super) fn page(report: &StudyReport, picture_jpeg: &[u8]) -> String {
    let step = dance_step(&report.dance_step);
    let bpm = number(report.bpm, 0);
    let about = both(
        &format!(
            "The experiment of Kamasaka, Miyamoto and Sakamoto with numbers: {step}, {bpm} counts a minute"
        ),
        &format!("論文（Kamasaka, Miyamoto, Sakamoto）の実験を数値で: {step}、1分間に{bpm}拍"),
    );
    let body = [
        picture(picture_jpeg),
        findings(report),
        skirts(report),
        methods(report),
        limits(report),
        curves(report),
        causes(report),
        steps(report),
        capsules(report),
    ]
    .concat();
    Page {
        title: "Euler · FB Euler · Runge-Kutta",
        about: &about,
        body: &body,
        lole: &report.lole,
    }
    .html()
}

fn picture(jpeg: &[u8]) -> String {
    if jpeg.is_empty() {
        return String::new();
    }
    format!(
        "<figure class=\"picture\"><img alt=\"Euler, FB Euler, Runge-Kutta\" src=\"data:image/jpeg;base64,{}\"><figcaption>{}</figcaption></figure>\n",
        STANDARD.encode(jpeg),
        both(
            "The last moment of each run at the step that all share, as in figures 13 to 15 of the paper.",
            "共通の刻みでの、それぞれの計算の最後の瞬間（論文の図13～15にあたります）。",
        )
    )
}

fn findings(report: &StudyReport) -> String {
    let items: String = report
        .findings
        .iter()
        .map(|finding| {
            let (class, verdict) = if finding.agrees {
                ("finding", both("Confirmed", "確認できた"))
            } else {
                ("finding differs", both("Differs", "違っていた"))
            };
            format!(
                "<div class=\"{class}\"><blockquote lang=\"en-GB\">“{}”</blockquote><p><strong>{verdict}.</strong> {}</p></div>\n",
                escape(&finding.paper),
                both(
                    &escape(&finding.measured.sentence),
                    &escape(&finding.measured.sentence_ja)
                ),
            )
        })
        .collect();
    heading(
        "What the paper says, and what was measured",
        "論文のことばと、測った結果",
        [
            "The paper gives no constants and no numbers; its sentences are quoted.",
            "論文には定数も数値もありません。文をそのまま引用しています。",
        ],
    ) + &items
}

fn skirts(report: &StudyReport) -> String {
    let row = |name: String, skirt: &super::SkirtOfStudy| {
        vec![
            name,
            grouped(skirt.particles),
            grouped(skirt.springs),
            number(skirt.damping_per_s, 2),
            number(skirt.highest_frequency_rad_per_s, 0),
        ]
    };
    let head = [
        both("Skirt", "スカート"),
        both("Mass points", "質点"),
        both("Springs", "ばね"),
        both("Damping c (1/s)", "減衰 c（1/s）"),
        both("Highest ω (rad/s)", "最高の ω（rad/s）"),
    ];
    let rows = [
        row(both("The methods'", "積分法の比較"), &report.skirt),
        row(
            both("The capsules'", "カプセルの比較"),
            &report.capsule_skirt,
        ),
        row(
            both("The film's (extrapolated to)", "動画（外挿先）"),
            &report.film_skirt,
        ),
    ];
    heading(
        "The skirts",
        "スカート",
        [
            "The first is of the paper's kind: few mass points and springs soft enough for its step.",
            "最初のものは論文と同じ種類で、質点が少なく、ばねは刻みに合わせて柔らかくしてあります。",
        ],
    ) + &table(&head, &rows)
}

/// How a run ended.
fn outcome(run: &RunEntry) -> String {
    match (run.diverged_at_s, run.outcome.as_str()) {
        (Some(time), _) => {
            let particle = run.diverged_particle.unwrap_or(0);
            both(
                &format!("diverged at {time:.2} s (particle {particle})"),
                &format!("{time:.2} 秒で発散（質点 {particle}）"),
            )
        }
        (None, "penetrating") => both("penetrating", "めり込む"),
        (None, "stable") => both("stable", "安定"),
        _ => "–".to_owned(),
    }
}

/// What a run was, in the cells after its name.
fn run_cells(run: &RunEntry) -> Vec<String> {
    if run.outcome.is_empty() {
        return vec!["–".to_owned(); 9];
    }
    vec![
        grouped(run.steps_per_frame as usize),
        outcome(run),
        number(run.strain_pct.p99, 1),
        number(run.skin_mm, 1),
        number(run.penetration_mm, 1),
        grouped(run.penetrating_particles),
        number(run.step_ms, 3),
        number(run.frame_ms.median, 2),
        number(run.cost_of_step, 2),
    ]
}

fn run_head(first: String) -> Vec<String> {
    let mut head = vec![first];
    head.extend(
        [
            ["Steps a frame", "1コマの刻み数"],
            ["How it ended", "結果"],
            ["Strain p99 (%)", "ひずみ p99（%）"],
            ["Into the skin (mm)", "肌へ（mm）"],
            ["Into capsules (mm)", "カプセルへ（mm）"],
            ["Points inside", "入った点"],
            ["A step (ms)", "1刻み（ms）"],
            ["A frame (ms)", "1コマ（ms）"],
            ["Cost of a step", "1刻みの費用比"],
        ]
        .map(|[english, japanese]| both(english, japanese)),
    );
    head
}

fn methods(report: &StudyReport) -> String {
    let rows = |pick: fn(&super::IntegratorEntry) -> &RunEntry| -> Vec<Vec<String>> {
        ORDER
            .iter()
            .filter_map(|name| Some((name, report.integrators.get(*name)?)))
            .map(|(name, entry)| {
                let mut row = vec![format!("<code>{name}</code>")];
                row.extend(run_cells(pick(entry)));
                row
            })
            .collect()
    };
    let head = run_head(both("Method", "方法"));
    heading(
        "All at the same step",
        "すべて同じ刻みで",
        [
            "Same skirt, same dance, same step: a sixth of what FB Euler needs.",
            "同じスカート、同じ踊り、同じ刻み（FB オイラー法に必要な刻みの6分の1）。",
        ],
    ) + &table(&head, &rows(|entry| &entry.same_step))
        + &heading(
            "Each at its own stable step",
            "それぞれの安定な刻みで",
            [
                "The damping is that of the table of skirts. The film's cost below is extrapolated, not run.",
                "減衰はスカートの表のとおりです。下の動画の費用は外挿で、計算はしていません。",
            ],
        )
        + &table(&head, &rows(|entry| &entry.own_step))
        + &extrapolated(report)
}

fn extrapolated(report: &StudyReport) -> String {
    let head = [
        both("Method", "方法"),
        both("Step of the film's skirt (s)", "動画のスカートの刻み（秒）"),
        both("A frame of it, extrapolated", "その1コマ、外挿（ms）"),
    ];
    let rows: Vec<_> = ORDER
        .iter()
        .filter_map(|name| Some((name, report.integrators.get(*name)?)))
        .map(|(name, entry)| {
            vec![
                format!("<code>{name}</code>"),
                format!("{:.1e}", entry.film_step_s_extrapolated),
                duration(entry.film_frame_ms_extrapolated),
            ]
        })
        .collect();
    table(&head, &rows)
}

/// A time given in milliseconds in the unit that people would use.
fn duration(ms: f64) -> String {
    if ms < 1e3 {
        format!("{} ms", number(ms, 0))
    } else if ms < 120e3 {
        format!("{} s", number(ms / 1e3, 1))
    } else {
        format!("{} h", number(ms / 3.6e6, 1))
    }
}

fn limits(report: &StudyReport) -> String {
    let head = [
        both("Method", "方法"),
        both("Order (free, damped)", "次数（減衰なし、あり）"),
        both("Forces a step", "1刻みの力の計算"),
        both("Limit in theory", "理論の限界"),
        both("ω Δt in theory", "理論の ω Δt"),
        both("ω Δt measured", "実測の ω Δt"),
        both("Difference (%)", "差（%）"),
    ];
    let rows: Vec<_> = ORDER
        .iter()
        .filter_map(|name| Some((name, report.integrators.get(*name)?)))
        .map(|(name, entry)| {
            let limit = &entry.threshold;
            let (theory, measured) = (
                limit.theory.unwrap_or(f64::NAN),
                limit.measured.unwrap_or(f64::NAN),
            );
            vec![
                format!("<code>{name}</code>"),
                format!("{}, {}", entry.order[0], entry.order[1]),
                entry.evaluations_per_step.to_string(),
                escape(&limit.formula),
                number(theory, 4),
                number(measured, 4),
                number(100.0 * (measured / theory - 1.0), 2),
            ]
        })
        .collect();
    heading(
        "How long a step may be",
        "刻みはどこまで大きくできるか",
        [
            "With c / ω = 0.05: in theory from the method's own amplification, measured from the growth of the skirt's highest mode.",
            "c / ω = 0.05 のとき。理論値は方法の増幅率から、実測値はスカートの最高次モードの成長から求めました。",
        ],
    ) + &table(&head, &rows)
}

fn curves(report: &StudyReport) -> String {
    let curve = |pick: fn(&RunEntry) -> &Vec<f64>| -> Vec<Curve<'_>> {
        ORDER
            .iter()
            .filter_map(|name| Some((name, report.integrators.get(*name)?)))
            .map(|(name, entry)| Curve {
                name,
                along: &entry.same_step.series.time_s,
                values: pick(&entry.same_step),
                drawn: Drawn::Line,
            })
            .collect()
    };
    let figure = |title: [&str; 2], curves: Vec<Curve<'_>>, scale: Scale| -> String {
        let drawing = svg(&Plot {
            curves,
            reference: None,
            floor: Floor::Smallest,
            scale,
        });
        drawing.map_or_else(String::new, |drawing| {
            format!(
                "<figure><h3>{}</h3>{drawing}</figure>\n",
                both(title[0], title[1])
            )
        })
    };
    let figures = [
        figure(
            ["Energy (J)", "エネルギー（J）"],
            curve(|run| &run.series.energy_j),
            Scale::Logarithmic,
        ),
        figure(
            ["Strain, 99 of 100 threads (%)", "ひずみ、100本中99本（%）"],
            curve(|run| &run.series.strain_p99_pct),
            Scale::Logarithmic,
        ),
        figure(
            ["Into the capsules (mm)", "カプセルへのめり込み（mm）"],
            curve(|run| &run.series.penetration_mm),
            Scale::Linear,
        ),
    ]
    .concat();
    heading(
        "From beginning to end, at the same step",
        "はじめから終わりまで（同じ刻み）",
        [
            "The axis below is the time of the dance in seconds.",
            "横軸は踊りの時間（秒）です。",
        ],
    ) + &format!("<div class=\"plots\">\n{figures}</div>\n")
}

fn causes(report: &StudyReport) -> String {
    let rows: Vec<_> = report
        .causes
        .iter()
        .map(|cause| {
            let mut row = vec![both(
                &escape(&cause.what.sentence),
                &escape(&cause.what.sentence_ja),
            )];
            row.extend(run_cells(&cause.same_step));
            row
        })
        .collect();
    heading(
        "Which of its causes makes the picture of Runge-Kutta",
        "ルンゲ・クッタ法の絵の原因はどれか",
        [
            "The classical method, with one departure of the print switched on at a time.",
            "古典的な方法に、印刷の違いを一つずつ入れました。",
        ],
    ) + &table(&run_head(both("Switched", "変えたもの")), &rows)
}

fn steps(report: &StudyReport) -> String {
    let rows: Vec<_> = report
        .steps
        .iter()
        .map(|step| {
            let mut row = vec![format!(
                "<code>{}</code> ω Δt = {}",
                escape(&step.method),
                number(step.phase, 3)
            )];
            row.extend(run_cells(&step.run));
            row
        })
        .collect();
    heading(
        "What the time step does",
        "時間刻みの影響",
        [
            "Where growth is slow, folding cloth swallows it: it flutters and sinks into the body before it flies apart.",
            "成長が遅いところでは、折れ曲がる布がエネルギーを受け止め、飛び散る前に震えて体にめり込みます。",
        ],
    ) + &table(&run_head(both("Method and step", "方法と刻み")), &rows)
}

fn capsules(report: &StudyReport) -> String {
    let head = [
        both("Body", "体"),
        both("Into the skin, worst (mm)", "肌へ、最深（mm）"),
        both("… mean of the frames (mm)", "… 各コマの平均（mm）"),
        both("Wrong points", "ずれた点"),
        both("A frame (ms)", "1コマ（ms）"),
    ];
    let rows: Vec<_> = report
        .capsules
        .iter()
        .map(|entry| {
            let name = match entry.body.as_str() {
                "two-cylinders" => {
                    both("two cylinders (the earlier body)", "2本の円柱（以前の体）")
                }
                "skin" => both("the drawn skin itself", "描いている肌そのもの"),
                _ => both(
                    &format!("{} capsules", entry.count),
                    &format!("カプセル {} 本", entry.count),
                ),
            };
            vec![
                name,
                number(entry.skin_mm, 1),
                number(entry.skin_mean_mm, 1),
                grouped(entry.wrong_vertices as usize),
                number(entry.frame_ms.median, 2),
            ]
        })
        .collect();
    let fitted = || report.capsules.iter().filter(|e| e.body == "capsules");
    let counts: Vec<f64> = fitted().map(|entry| entry.count as f64).collect();
    let depth: Vec<f64> = fitted().map(|entry| entry.skin_mean_mm).collect();
    let time: Vec<f64> = fitted().map(|entry| entry.frame_ms.median).collect();
    let figure = |title: [&str; 2], values: &[f64]| {
        svg(&Plot::single(&counts, values, Floor::Zero)).map_or_else(String::new, |drawing| {
            format!(
                "<figure><h3>{}</h3>{drawing}</figure>\n",
                both(title[0], title[1])
            )
        })
    };
    heading(
        "How many capsules?",
        "カプセルは何本いるか",
        [
            "The same dance with the real-time method on bodies of more and more capsules, each fitted to the same skin. The last body is the drawn skin itself. The axis below is the number of capsules.",
            "同じ踊りを、同じ肌に合わせたカプセルの数だけ変えて、実時間の方法で計算しました。最後の行は描いている肌そのものです。横軸はカプセルの本数です。",
        ],
    ) + &format!(
        "<div class=\"plots\">\n{}{}</div>\n",
        figure(
            [
                "Into the skin, mean of the frames (mm)",
                "肌へのめり込み、各コマの平均（mm）"
            ],
            &depth
        ),
        figure(["A frame (ms)", "1コマの計算時間（ms）"], &time),
    ) + &table(&head, &rows)
}
