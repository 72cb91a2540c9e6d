//! The paper's sentences beside the numbers: what agrees, what does not, and why.

use lole_costume::document::MethodName;
use lole_export::report::Remark;
use lole_export::study::{Finding, IntegratorEntry, RunEntry, StudyReport};

/// Relative difference of two costs that a busy machine may make.
const COST_NOISE: f64 = 0.25;
/// A run of the same kind that is this much deeper in the body is worse.
const DEEPER: f64 = 2.0;

/// All findings, in the order of the paper's text.
pub(super) fn of(report: &StudyReport) -> Vec<Finding> {
    let entry = |name: MethodName| report.integrators.get(name.id());
    let (Some(euler), Some(fb), Some(printed), Some(classical)) = (
        entry(MethodName::Euler),
        entry(MethodName::FbEuler),
        entry(MethodName::RkAsPrinted),
        entry(MethodName::Rk4),
    ) else {
        return Vec::new();
    };
    let mut findings = vec![
        euler_flies_away(euler, fb),
        euler_is_not_slow(euler, fb),
        fb_is_stable(fb),
        printed_is_slowest(printed, fb),
        printed_penetrates(report, printed, classical),
    ];
    findings.extend(capsules(report));
    findings
}

/// Whether the measurement agrees with the paper.
struct Agrees(bool);

fn finding(paper: &str, Agrees(agrees): Agrees, sentence: String, sentence_ja: String) -> Finding {
    Finding {
        paper: paper.to_owned(),
        agrees,
        measured: Remark {
            sentence,
            sentence_ja,
        },
    }
}

/// How a run ended, in English and Japanese.
fn ending(run: &RunEntry) -> [String; 2] {
    match (run.diverged_at_s, run.outcome.as_str()) {
        (Some(time), _) => [
            format!("diverged after {time:.2} s"),
            format!("{time:.2} 秒で発散"),
        ],
        (None, "penetrating") => [
            format!(
                "penetrates {:.1} mm into the body",
                run.skin_mm.max(run.penetration_mm)
            ),
            format!(
                "体に {:.1} mm めり込む",
                run.skin_mm.max(run.penetration_mm)
            ),
        ],
        (None, _) => ["stable".to_owned(), "安定".to_owned()],
    }
}

fn limits(entry: &IntegratorEntry) -> [f64; 2] {
    [
        entry.threshold.theory.unwrap_or(0.0),
        entry.threshold.measured.unwrap_or(0.0),
    ]
}

fn euler_flies_away(euler: &IntegratorEntry, fb: &IntegratorEntry) -> Finding {
    let run = &euler.same_step;
    let [english, japanese] = ending(run);
    let ([theory, measured], [fb_theory, _]) = (limits(euler), limits(fb));
    let damping = euler.threshold.damping_ratio;
    finding(
        "Euler: the skirt flying away from the body",
        Agrees(run.diverged_at_s.is_some()),
        format!(
            "Euler's method at the step that all share: {english}. It is stable only below ω Δt = c / ω: {theory:.4} in theory and {measured:.4} on this skirt with c / ω = {damping}, where FB Euler bears {fb_theory:.2}. The time step is the cause; no other switch is needed."
        ),
        format!(
            "共通の刻みでオイラー法は「{japanese}」。安定なのは ω Δt < c / ω の間だけで、c / ω = {damping} のとき理論値 {theory:.4}、このスカートでの実測 {measured:.4} です（FB オイラー法は {fb_theory:.2}）。原因は時間刻みです。"
        ),
    )
}

fn euler_is_not_slow(euler: &IntegratorEntry, fb: &IntegratorEntry) -> Finding {
    let ratio = euler.own_step.cost_of_step / fb.own_step.cost_of_step.max(1e-12);
    let is_equal = (ratio - 1.0).abs() < COST_NOISE;
    finding(
        "Euler: the movement of the human model did not slow down; FB Euler: it slowed down due to the large number of calculation processes",
        Agrees(!is_equal),
        format!(
            "Both evaluate the forces once a step, and a step of Euler costs {ratio:.2} times one of FB Euler while both are stable. Calculation cannot tell them apart: cloth that has flown away meets no body and is drawn nowhere, which is the speed that was seen. At its own stable step Euler needs {:.0} steps for one of FB Euler.",
            fb.own_step.step_s / euler.own_step.step_s.max(1e-12),
        ),
        format!(
            "どちらも1ステップに力を1回計算し、安定しているときのオイラー法の1ステップは FB オイラー法の {ratio:.2} 倍です。計算量では差が出ません。飛び去った布は体に当たらず、描かれもしないので速く見えたのです。安定な刻みでは、オイラー法は FB オイラー法の1ステップに {:.0} ステップかかります。",
            fb.own_step.step_s / euler.own_step.step_s.max(1e-12),
        ),
    )
}

fn fb_is_stable(fb: &IntegratorEntry) -> Finding {
    let [english, japanese] = ending(&fb.same_step);
    let [theory, measured] = limits(fb);
    finding(
        "FB Euler: stable",
        Agrees(fb.same_step.outcome == "stable"),
        format!(
            "FB Euler at the step that all share: {english}; strain {:.1} % (99 of 100 threads), {:.1} mm into the drawn body. Its limit is ω Δt = {theory:.4} in theory, {measured:.4} on this skirt. The print calls its second half backward Euler; it is symplectic Euler, nothing is implicit.",
            fb.same_step.strain_pct.p99, fb.same_step.skin_mm,
        ),
        format!(
            "共通の刻みで FB オイラー法は「{japanese}」、ひずみ {:.1} %（100本中99本）、肌へのめり込み {:.1} mm です。限界は理論値 ω Δt = {theory:.4}、実測 {measured:.4}。論文は後半を後退オイラー法と呼びますが、陰的な計算はなく、シンプレクティックオイラー法です。",
            fb.same_step.strain_pct.p99, fb.same_step.skin_mm,
        ),
    )
}

fn printed_is_slowest(printed: &IntegratorEntry, fb: &IntegratorEntry) -> Finding {
    let ratio = printed.own_step.cost_of_step / fb.own_step.cost_of_step.max(1e-12);
    finding(
        "Runge-Kutta: the movement of the human model was the slowest among the three",
        Agrees(2.0 < ratio),
        format!(
            "Four evaluations of the forces a step: measured {ratio:.1} times a step of FB Euler, against 4 in theory."
        ),
        format!(
            "1ステップに力を4回計算します。実測で FB オイラー法の {ratio:.1} 倍（理論では4倍）です。"
        ),
    )
}

fn printed_penetrates(
    report: &StudyReport,
    printed: &IntegratorEntry,
    classical: &IntegratorEntry,
) -> Finding {
    let depth = |run: &RunEntry| run.skin_mm.max(run.penetration_mm);
    let is_worse = |run: &RunEntry| {
        run.diverged_at_s.is_some()
            || DEEPER * depth(&classical.same_step) < depth(run)
            || DEEPER * classical.same_step.strain_pct.p99 < run.strain_pct.p99
    };
    let causes: Vec<_> = report
        .causes
        .iter()
        .filter(|cause| !cause.name.starts_with("as-printed") && is_worse(&cause.same_step))
        .collect();
    let join = |sentences: Vec<&str>| sentences.join("; ");
    let english = join(causes.iter().map(|c| c.what.sentence.as_str()).collect());
    let japanese = join(causes.iter().map(|c| c.what.sentence_ja.as_str()).collect());
    let [printed_english, printed_japanese] = ending(&printed.same_step);
    let [classical_english, classical_japanese] = ending(&classical.same_step);
    let english = if english.is_empty() {
        "none alone".to_owned()
    } else {
        english
    };
    let japanese = if japanese.is_empty() {
        "どれも単独ではならない".to_owned()
    } else {
        japanese
    };
    finding(
        "Runge-Kutta: the skirt penetrated the legs",
        Agrees(is_worse(&printed.same_step)),
        format!(
            "Equation (10) as printed at the step that all share: {printed_english}, strain {:.0} %. The classical method at the same step: {classical_english}, strain {:.0} %. Switched on alone, what makes this picture: {english}. The printed scheme is of first order and gains energy in every step without damping.",
            printed.same_step.strain_pct.p99, classical.same_step.strain_pct.p99,
        ),
        format!(
            "印刷のままの式 (10) は「{printed_japanese}」、ひずみ {:.0} % です。同じ刻みの古典的な方法は「{classical_japanese}」、{:.0} %。単独でこの絵になる違い: {japanese}。印刷の式は1次精度で、減衰がなければ1ステップごとにエネルギーが増えます。",
            printed.same_step.strain_pct.p99, classical.same_step.strain_pct.p99,
        ),
    )
}

fn capsules(report: &StudyReport) -> Option<Finding> {
    let of = |count: usize| {
        let mut entries = report.capsules.iter();
        entries.find(|entry| entry.body == "capsules" && entry.count == count)
    };
    let (few, paper, many) = (of(4)?, of(13)?, of(40)?);
    let gain = few.skin_mean_mm / paper.skin_mean_mm.max(1e-9);
    let more = many.frame_ms.median / paper.frame_ms.median.max(1e-9);
    let enough = paper.skin_mean_mm <= 0.75 * few.skin_mean_mm;
    Some(finding(
        "13 capsule shapes, considering that the position of the cylinder can correctly determine the collision and the processing speed is not too slow",
        Agrees(enough),
        format!(
            "From 4 to 13 capsules the cloth lies {gain:.1} times less deep in the drawn body ({:.1} to {:.1} mm, mean of the frames); with 40 it is {:.1} mm and a frame takes {more:.2} times as long.",
            few.skin_mean_mm, paper.skin_mean_mm, many.skin_mean_mm,
        ),
        format!(
            "カプセルを4本から13本にすると、体へのめり込みは {gain:.1} 分の1（各コマの最深の平均で {:.1} → {:.1} mm）になります。40本では {:.1} mm、1コマの時間は {more:.2} 倍です。",
            few.skin_mean_mm, paper.skin_mean_mm, many.skin_mean_mm,
        ),
    ))
}
