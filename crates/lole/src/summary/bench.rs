//! What `lole bench` says.

use std::io::Write as _;

use lole_language::Language;
use lole_study::bench::BenchRow;
use lole_study::bench::pareto::ParetoPoint;
use lole_study::soak::{SoakRow, WorstAt};

/// Phases of a smaller share of the time are not shown [%].
const PHASE_SHOWN_PCT: f64 = 0.5;

/// Column heads of the bench table.
pub(crate) fn print_bench_head(language: Language) {
    say!(
        "{:<14} {:<13} {:>9} {:>8} {:>8} {:>7} {:>8} {:>8} {:>6} {:>22} {:>15} {:>8} {:>7} {:>9} {:>10} {:>7} {:>6}  hash",
        language.pick("場面", "scene"),
        language.pick("方法", "method"),
        language.pick("質点", "particles"),
        language.pick("分割", "substeps"),
        "CPU ms",
        language.pick("基準比", "ratio"),
        "CPU p99",
        "wall ms",
        "ns",
        "end mean p99 max %",
        "worst p99 max %",
        "depth mm",
        "skin mm",
        "crossings",
        "inversions",
        "rms m/s",
        "bytes",
    );
}

/// A figure with so many decimals, or a dash.
fn figure(value: Option<f64>, decimals: usize) -> String {
    value.map_or("-".to_owned(), |value| format!("{value:.decimals$}"))
}

/// One row of the bench table.
pub(crate) fn print_bench_row(row: &BenchRow, language: Language) {
    let [crossings, inversions] = [row.self_crossings, row.layer_inversions]
        .map(|count| count.map_or("-".to_owned(), |count| count.to_string()));
    let skin =
        (row.skin_penetration_mm).map_or("-".to_owned(), |skin| format!("{:.2}", skin.worst));
    say!(
        "{:<14} {:<13} {:>9} {:>8} {:>8.3} {:>7} {:>8.3} {:>8.3} {:>6.2} {:>10.3} {:>5.2} {:>5.2} {:>9.2} {:>5.2} {:>8.3} {:>7} {:>9} {:>10} {:>7} {:>6}  {}",
        row.scene,
        row.method,
        row.particles,
        row.substeps,
        row.frame_ms.median,
        figure(row.ratio_to_reference, 3),
        row.frame_ms.p99,
        row.frame_wall_ms.median,
        row.particle_substep_ns,
        row.strain_end_pct.mean,
        row.strain_end_pct.p99,
        row.strain_end_pct.max,
        row.strain_worst_pct.p99,
        row.strain_worst_pct.max,
        row.penetration_mm.worst,
        skin,
        crossings,
        inversions,
        figure(row.rms_speed_m_per_s, 3),
        figure(row.bytes_per_particle, 0),
        row.state_hash
    );
    print_below(row, language);
}

/// What stands below a row: why figures are missing, where the time goes, and the springs.
fn print_below(row: &BenchRow, language: Language) {
    if !row.finite {
        say!(
            "{:14} ! {}",
            "",
            language.pick(
                "座標に有限でない値があり、交差は数えられません",
                "not every position is finite, so crossings cannot be counted",
            )
        );
    }
    if let Some(phases) = &row.phases {
        let shares: Vec<String> = (phases.iter())
            .filter(|phase| PHASE_SHOWN_PCT <= phase.share_pct)
            .map(|phase| format!("{} {:.0} %", phase.name, phase.share_pct))
            .collect();
        say!("{:14} {}", "", shares.join(" · "));
    }
    if let Some(springs) = &row.spring_roofline {
        say!(
            "{:14} {} {:.3} ns · {} {:.3} ns ({:.1} GFLOP/s, {:.1} GB/s) · {:.0} %",
            "",
            language.pick("構造バネ1本", "a structural spring"),
            springs.spring_ns,
            language.pick("この機械の最良", "this machine at best"),
            springs.best_spring_ns,
            springs.best_gflops,
            springs.best_gbytes_per_s,
            springs.reached_pct,
        );
    }
}

/// Cost of a particle by the size of the cloth, of each method.
pub(crate) fn print_size_costs(rows: &[BenchRow], language: Language) {
    for rows in rows.chunk_by(|one, next| one.method == next.method) {
        #[expect(clippy::cast_precision_loss, reason = "a count is far below 2^52")]
        let cost = |row: &BenchRow| 1e6 * row.frame_ms.median / row.particles as f64;
        let least = rows.iter().map(cost).fold(f64::INFINITY, f64::min);
        say!(
            "\n{}: {}",
            rows[0].method,
            language.pick(
                "1質点1コマの時間と、最も安いものとの比",
                "time of a particle in a frame, and over the cheapest",
            )
        );
        for row in rows {
            let cost = cost(row);
            say!(
                "  {:>9} {cost:>9.1} ns {:>6.2} ×",
                row.particles,
                cost / least
            );
        }
    }
}

/// The points of a scene, fastest first; those that no other beats are marked.
pub(crate) fn print_pareto(points: &[ParetoPoint], language: Language) {
    let Some(first) = points.first() else { return };
    say!(
        "\n{}  (* {}; = {})",
        first.row.scene,
        language.pick("ほかに負けない", "beaten by no other"),
        language.pick("場面の設定", "the scene's own"),
    );
    say!(
        "   {:<13} {:>8} {:>6} {:>9} {:>9} {:>9} {:>9}  {}",
        language.pick("方法", "method"),
        language.pick("分割", "substeps"),
        language.pick("回数", "sweeps"),
        "CPU ms",
        "p99 %",
        "max %",
        "depth mm",
        language.pick("最も長い段階", "longest phase"),
    );
    let mut sorted: Vec<&ParetoPoint> = points.iter().collect();
    sorted.sort_by(|a, b| a.row.frame_ms.median.total_cmp(&b.row.frame_ms.median));
    for point in sorted {
        let (row, mark) = (&point.row, if point.on_front { '*' } else { ' ' });
        say!(
            " {mark}{} {:<13} {:>8} {:>6} {:>9.3} {:>9.2} {:>9.2} {:>9.2}  {}",
            if point.is_own { '=' } else { ' ' },
            row.method,
            row.substeps,
            (point.sweeps).map_or("-".to_owned(), |count| count.to_string()),
            row.frame_ms.median,
            row.strain_worst_pct.p99,
            row.strain_worst_pct.max,
            row.penetration_mm.worst,
            point.longest_phase.unwrap_or("-"),
        );
    }
}

/// What a soak of a scene found.
pub(crate) fn print_soak(row: &SoakRow, language: Language) {
    let at = |figure: &WorstAt| format!("{:.2} @{}", figure.worst, figure.frame);
    say!(
        "{:<12} {} {} · {} {} · {} {} · max {} · {} {} · {} {} · rms {} m/s · {}",
        row.scene,
        row.frames,
        language.pick("コマ", "frames"),
        language.pick("種", "seed"),
        row.seed,
        language.pick("ひずみ p99 %", "strain p99 %"),
        at(&row.strain_p99_pct),
        at(&row.strain_max_pct),
        language.pick("めり込み mm", "depth mm"),
        at(&row.penetration_mm),
        language.pick("交差", "crossings"),
        row.self_crossings.as_ref().map_or("-".to_owned(), at),
        at(&row.rms_speed_m_per_s),
        row.state_hash,
    );
    for violation in &row.violations {
        say!(
            "{:12} ! {}: {:.3} > {:.3} @{} ({} {})",
            "",
            violation.law.about().text(language),
            violation.measured,
            violation.bound,
            violation.frame,
            violation.looks,
            language.pick("回", "looks"),
        );
    }
}
