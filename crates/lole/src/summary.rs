//! What the terminal says at the end: what was written and how to open it, or what went wrong.
#![expect(clippy::print_stderr, reason = "this is the terminal's voice")]

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering};

use lole_costume::cost::Bill;
use lole_costume::document::DesignError;
use lole_export::dancer_sheet::DancerSheet;
use lole_export::report::{Remark, RunReport};
use lole_export::study::StudyReport;
use lole_language::{Bilingual, Language, Sentence, Words, shown, visible_json};
use lole_picture::vrm::VrmFigures;
use lole_stage::StageError;
use lole_stage::validate::{Check, Protocol};

use crate::Failure;

/// Writes a line where the user looks, with nothing in it that a terminal would follow.
macro_rules! say {
    () => {
        say!("")
    };
    ($($words:tt)*) => {
        $crate::summary::heard(writeln!(
            std::io::stdout(),
            "{}",
            lole_language::visible(&format!($($words)*))
        ))
    };
}

/// Whether what was written is not told of.
static IS_QUIET: AtomicBool = AtomicBool::new(false);

/// Leaves out what was written and how far it is.
pub(crate) fn say_less() {
    IS_QUIET.store(true, Ordering::Relaxed);
}

/// Whether only warnings and asked-for figures are told.
pub(crate) fn is_quiet() -> bool {
    IS_QUIET.load(Ordering::Relaxed)
}

/// Whether something that was to be said is lost.
static IS_LOST: AtomicBool = AtomicBool::new(false);

/// Remembers that a line was lost. Nobody may be looking any more, as behind `| head`: that is no failure of
/// the run.
pub(crate) fn heard(said: std::io::Result<()>) {
    if said.is_err_and(|error| error.kind() != std::io::ErrorKind::BrokenPipe) {
        IS_LOST.store(true, Ordering::Relaxed);
    }
}

/// The exit code of a run that went well: 1 where what it said could not be written.
pub(crate) fn end(language: Language) -> ExitCode {
    heard(std::io::stdout().flush());
    if !IS_LOST.load(Ordering::Relaxed) {
        return ExitCode::SUCCESS;
    }
    eprintln!(
        "lole: {}",
        language.pick(
            "結果を出力に書けませんでした。出力先の空きを確かめてください。",
            "the output could not be written; check that there is room where it goes"
        )
    );
    ExitCode::from(1)
}

mod bench;

pub(crate) use bench::{
    print_bench_head, print_bench_row, print_pareto, print_size_costs, print_soak,
};

/// Exit code after Ctrl-C: 128 plus the signal's number, as shells have it.
const INTERRUPTED: u8 = 130;

/// Prints the report as JSON, for programs and for terminals.
pub(crate) fn print_json(json: &str) {
    heard(writeln!(std::io::stdout(), "{}", visible_json(json)));
}

/// Says what was found before a run began: beside the results, so that JSON stays JSON.
pub(crate) fn print_found(found: &[Sentence]) {
    let language = Language::of_locale(sys_locale::get_locale().as_deref());
    for sentence in found {
        eprintln!("{}", shown(&sentence.text(language)));
    }
}

/// Says some sentences, a line each.
pub(crate) fn print_lines(lines: &[Sentence], language: Language) {
    for line in lines {
        say!("{}", line.text(language));
    }
}

/// Says what a file holds.
pub(crate) fn print_inspection(path: &Path, lines: &[Sentence], language: Language) {
    say!("{}", path.display());
    for line in lines {
        say!("  {}", line.text(language));
    }
}

/// Says what a dancer measures, and how well her capsules stand for her.
pub(crate) fn print_dancer(sheet: &DancerSheet, language: Language) {
    say!();
    for measure in &sheet.measures {
        let name = language.pick(&measure.name_ja, &measure.name);
        let given = match measure.given_cm {
            Some(given) => format!("{} {given:.1} cm", language.pick("採寸", "given")),
            None if measure.is_estimated => language.pick("推定", "estimated").to_owned(),
            None => String::new(),
        };
        say!("  {:>7.1} cm  {name}  {given}", measure.on_body_cm);
    }
    let coverage = &sheet.capsule_coverage;
    say!(
        "  {} {} {:.1} % · {} {:.1} mm",
        sheet.capsules.len(),
        language.pick("本のカプセル: 肌を覆う割合", "capsules: close to the skin"),
        coverage.close_pct,
        language.pick("肌が外に出るのは最大", "skin outside by at most"),
        coverage.farthest_mm,
    );
}

/// Says what a run wrote and how it went.
pub(crate) fn print_run(report: &RunReport, paths: &[PathBuf], seconds: f64, language: Language) {
    print_files(paths, language);
    if !is_quiet() {
        say!();
    }
    print_warnings(report, language);
    if 0 < report.frames && !is_quiet() {
        print_figures(report, seconds, language);
    }
}

/// Says what the film of a group wrote, and how long all took.
pub(crate) fn print_group(paths: &[PathBuf], (count, seconds): (usize, f64), language: Language) {
    print_files(paths, language);
    if !is_quiet() {
        say!();
        say!(
            "  {count} {} · {seconds:.0} s",
            language.pick("人", "dancers")
        );
    }
}

/// What is unusual about a run, and measures that nobody took.
fn print_warnings(report: &RunReport, language: Language) {
    let pick = |japanese: &'static str, english: &'static str| language.pick(japanese, english);
    for remark in report.skirt.warnings.iter().chain(&report.no_room) {
        say!("  ! {}", pick_remark(remark, language));
    }
    for garment in &report.garments {
        let (of, worst) = (garment.overlapping_places, garment.inverted_places.worst);
        if 0 < worst {
            let name = language.pick(&garment.name_ja, &garment.name);
            let said = pick(
                "内と外が逆の点（最大）",
                "points the wrong way round at worst",
            );
            say!("  ! {name}: {said} {worst} / {of}");
        }
    }
    let estimated: Vec<String> = (report.dancer.iter().filter(|measure| measure.is_estimated))
        .map(|measure| {
            let name = language.pick(&measure.name_ja, &measure.name);
            format!("{name} {:.1}", measure.on_body_cm)
        })
        .collect();
    if !estimated.is_empty() {
        say!(
            "  {}: {} cm",
            pick("採寸されていないので推定", "estimated, not measured"),
            estimated.join(pick("、", ", ")),
        );
    }
}

/// How fast a run was, and how far its cloth can be believed.
fn print_figures(report: &RunReport, seconds: f64, language: Language) {
    let pick = |japanese: &'static str, english: &'static str| language.pick(japanese, english);
    say!(
        "  {} {} {} · {} {} · {:.1} {} ({} {:.1} ms) · {} {:.2} ×",
        report.method,
        report.particles,
        pick("質点", "particles"),
        report.threads,
        if report.threads == 1 {
            pick("スレッド", "thread")
        } else {
            pick("スレッド", "threads")
        },
        report.frame_wall_ms.median,
        pick("ミリ秒/コマ", "ms a frame"),
        pick("CPU", "CPU"),
        report.frame_ms.median,
        pick("実時間の", "real time"),
        report.realtime_factor,
    );
    say!(
        "  {} {:.1} % (p99) · {} {:.1} mm · {} {:.1} cm · {} · {:.0} s",
        pick("ひずみ", "strain"),
        report.strain_pct.p99,
        pick("肌へのめり込み", "below the skin"),
        report.skin_penetration_mm.worst,
        pick("裾の高さ", "hem height"),
        report.hem_height_cm.mean,
        report.renderer,
        seconds,
    );
}

fn pick_remark(remark: &Remark, language: Language) -> &str {
    language.pick(&remark.sentence_ja, &remark.sentence)
}

/// Says what the study wrote and what it found.
pub(crate) fn print_study(report: &StudyReport, paths: &[PathBuf], language: Language) {
    say!();
    for path in paths {
        say!("  {:<44} {}", path.display(), open_hint(path, language));
    }
    for finding in &report.findings {
        let mark = if finding.agrees { "=" } else { "≠" };
        say!("\n  {mark} “{}”", finding.paper);
        say!("    {}", pick_remark(&finding.measured, language));
    }
    say!("\n  {:.0} s", report.seconds);
}

/// Says what a pattern wrote, what to buy and what to decide before cutting.
pub(crate) fn print_pattern(
    paths: &[PathBuf],
    purchases: &[Sentence],
    warnings: &[Sentence],
    language: Language,
) {
    print_files(paths, language);
    if !is_quiet() {
        say!();
        for purchase in purchases {
            say!("  {}", purchase.text(language));
        }
    }
    for warning in warnings {
        say!("  ! {}", warning.text(language));
    }
}

/// Says what a costume costs.
pub(crate) fn print_bill(bill: &Bill, remarks: &[String], language: Language) {
    for line in &bill.lines {
        let sum = line.sum.map_or_else(
            || language.pick("値段を確認", "ask the price").to_owned(),
            |sum| bill.currency.write(sum),
        );
        let (name, amount) = (line.name.text(language), line.amount.text(language));
        say!("  {sum:>12}  {name}  {amount}");
    }
    if bill.knows_something() {
        let total = bill.currency.write(bill.total);
        let said = if bill.is_complete() {
            language.pick("合計", "total")
        } else {
            language.pick("わかっている分の合計", "total of what is known")
        };
        say!("  {total:>12}  {said}");
    }
    for remark in remarks {
        say!("  {remark}");
    }
}

/// Says what a protocol compares.
pub(crate) fn print_protocol(protocol: &Protocol, language: Language) {
    let about = protocol.about.text(language);
    say!("\n{}: {about}", protocol.name);
}

/// Says what keeps a method from more.
pub(crate) fn print_limit(method: &str, limit: Words, language: Language) {
    say!("  {method:<10} ! {}", limit.text(language));
}

/// Says what a validation wrote.
pub(crate) fn print_files(paths: &[PathBuf], language: Language) {
    if is_quiet() {
        return;
    }
    say!();
    for path in paths {
        say!("  {:<44} {}", path.display(), open_hint(path, language));
    }
}

/// Says what an export wrote; a sequence of files is one line.
pub(crate) fn print_export(
    take: &Path,
    (frames, rate): (u32, u32),
    paths: &[PathBuf],
    language: Language,
) {
    if is_quiet() {
        return;
    }
    let is_numbered = |path: &&PathBuf| {
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        has_end(path, "obj") && stem.starts_with("dance_")
    };
    let (numbered, alone): (Vec<_>, Vec<_>) = paths.iter().partition(is_numbered);
    let alone: Vec<PathBuf> = alone.into_iter().cloned().collect();
    print_files(&alone, language);
    if let (Some(first), Some(last)) = (numbered.first(), numbered.last()) {
        let last = last.file_name().unwrap_or_default().to_string_lossy();
        let names = format!("{} … {last}", first.display());
        say!("  {names:<44} {}", open_hint(first, language));
    }
    let seconds = f64::from(frames) / f64::from(rate);
    say!();
    say!(
        "  {}",
        language.pick(
            &format!(
                "{frames} コマ、毎秒 {rate} コマ（{seconds:.1} 秒）。単位はメートル、上は +Y、正面は +Z"
            ),
            &format!(
                "{frames} frames, {rate} a second ({seconds:.1} s); in meters, +Y up, the dancer's front at +Z"
            ),
        )
    );
    say!(
        "  {}",
        language.pick(
            &format!(
                "{}: 踊り直さずに、ほかの形式でも書き出せます",
                take.display()
            ),
            &format!(
                "{}: gives other formats without another dance",
                take.display()
            ),
        )
    );
}

/// Says how near the springs of an avatar come to the dance that they were fitted to.
pub(crate) fn print_vrm(figures: &VrmFigures, language: Language) {
    let VrmFigures {
        frames,
        mean_mm,
        worst_mm,
        leg_share,
        settings: [stiffness, drag, gravity],
    } = figures;
    let legs = 100.0 * leg_share;
    say!();
    say!(
        "  {}",
        language.pick(
            &format!("揺れ骨: 硬さ {stiffness:.2}、減衰 {drag:.2}、重力 {gravity:.2}。{frames} コマで、布との差は平均 {mean_mm:.1} mm、最大 {worst_mm:.0} mm。脚が出るコマは {legs:.1} %"),
            &format!("springs: stiffness {stiffness:.2}, drag {drag:.2}, gravity {gravity:.2}; over {frames} frames off by {mean_mm:.1} mm on the mean and {worst_mm:.0} mm at most; a leg comes through in {legs:.1} % of them"),
        )
    );
}

/// One figure of a protocol against its reference.
pub(crate) fn print_check(method: &str, check: &Check, language: Language) {
    let verdict = if check.passes() {
        language.pick("合格", "pass")
    } else {
        language.pick("不合格", "FAIL")
    };
    let [low, high] = check.bounds();
    say!(
        "  {method:<10} {:<18} {:>12} {:>12} {:<4} {:>9.3} %  [{}, {}]  {verdict}",
        check.case,
        figure(check.measured),
        figure(check.reference),
        check.unit,
        check.error_pct(),
        figure(low),
        figure(high),
    );
}

/// Six decimals, or a power of ten where they would show nothing.
fn figure(value: f64) -> String {
    if 0.0 < value.abs() && value.abs() < 1e-4 {
        format!("{value:.3e}")
    } else {
        format!("{value:.6}")
    }
}

fn open_hint(path: &Path, language: Language) -> &'static str {
    if let Some(hint) = take_hint(path, language) {
        return hint;
    }
    let name = path
        .file_name()
        .and_then(|name| name.to_str())
        .unwrap_or("");
    match name {
        "report.html" | "study.html" | "validation.html" | "bench.html" => {
            language.pick("ここから: ブラウザで開く", "start here: open in a browser")
        }
        "dance.mp4" => language.pick("動画プレーヤーで再生", "plays in any video player"),
        "dancer.glb" | "dance.glb" => language.pick(
            "Blender や 3D ビューアーで開く",
            "opens in Blender and 3D viewers",
        ),
        "design.lole" => language.pick(
            "lole dance design.lole で同じ踊り",
            "lole dance design.lole repeats it",
        ),
        "counts.csv" => language.pick(
            "拍の時刻。曲を合わせるときに",
            "when the counts fall, to match music",
        ),
        "cut-plan.pdf" => language.pick(
            "ここから: 布の置き方と買う長さ",
            "start here: where the pieces lie, what to buy",
        ),
        "ruler.pdf" => language.pick(
            "定規とチャコで引く線",
            "rectangles to draw with ruler and chalk",
        ),
        _ if has_end(path, "csv") => language.pick("表計算で開く", "opens in a spreadsheet"),
        _ if has_end(path, "json") => {
            language.pick("プログラム用の数値", "the numbers, for programs")
        }
        _ if has_end(path, "dxf") => language.pick(
            "型紙ソフトで開く（AAMA/ASTM）",
            "opens in pattern software (AAMA/ASTM)",
        ),
        _ if has_end(path, "svg") => language.pick(
            "ブラウザーや Inkscape で開く（原寸 mm）",
            "opens in browsers and Inkscape, in mm",
        ),
        _ if ["-a4.pdf", "-a3.pdf", "-letter.pdf"]
            .iter()
            .any(|end| name.ends_with(end)) =>
        {
            language.pick(
                "倍率 100 % で印刷して貼り合わせる",
                "print at 100 %, join the sheets",
            )
        }
        _ if ["-a0.pdf", "-roll.pdf", "-sizes.pdf"]
            .iter()
            .any(|end| name.ends_with(end)) =>
        {
            language.pick(
                "コピー店のロール紙に 100 % で印刷",
                "for a copy shop's roll, at 100 %",
            )
        }
        _ if name.ends_with("-projector.pdf") => {
            language.pick("プロジェクターで布に映す", "for a projector over the cloth")
        }
        _ if has_end(path, "pdf") => language.pick("印刷して読む", "to print and read"),
        _ => language.pick("写真", "a still"),
    }
}

/// With what a file of a take or a sweep is opened.
fn take_hint(path: &Path, language: Language) -> Option<&'static str> {
    Some(match path.extension()?.to_str()? {
        "usdc" | "usdz" => language.pick(
            "Blender・Houdini・Maya・Unreal などで開く（USD）",
            "opens in Blender, Houdini, Maya, Unreal (USD)",
        ),
        "vrm" => language.pick(
            "VRM を読むアプリで開く",
            "opens in programs that read VRM 1.0",
        ),
        "pc2" | "mdd" => language.pick(
            "同じ名前の OBJ に頂点キャッシュとして付ける",
            "a vertex cache for the OBJ of the same name",
        ),
        "obj" => language.pick("3D ソフトで開く（OBJ）", "opens in 3D programs (OBJ)"),
        "mtl" => language.pick("OBJ の材質", "materials of the OBJ"),
        "npz" => language.pick("numpy.load で読む", "numpy.load reads it"),
        "parquet" => language.pick("pandas や DuckDB で読む", "for pandas, Polars, DuckDB"),
        _ => return None,
    })
}

fn has_end(path: &Path, end: &str) -> bool {
    path.extension().is_some_and(|found| found == end)
}

/// Says what is wrong, or what to look at, one a line, where results go to standard output.
pub(crate) fn print_problems(problems: &[Sentence], language: Language) {
    for problem in problems {
        eprintln!("  ! {}", shown(&problem.text(language)));
    }
}

/// Says what went wrong, in one sentence, and gives the exit code.
pub(crate) fn explain(failure: &Failure, language: Language) -> ExitCode {
    match failure {
        Failure::Usage(error) => {
            eprintln!("lole: {}", shown(&one_line(error, language)));
            ExitCode::from(2)
        }
        Failure::Run(error) => {
            eprintln!("lole: {}", shown(&one_line(error, language)));
            ExitCode::from(1)
        }
        Failure::Diverged(sentence) => {
            eprintln!("lole: {}", shown(&sentence.text(language)));
            ExitCode::from(1)
        }
        Failure::Interrupted => {
            eprintln!(
                "lole: {}",
                language.pick(
                    "中止しました。書きかけのファイルは残っていません。",
                    "stopped; nothing half-written was left."
                )
            );
            ExitCode::from(INTERRUPTED)
        }
        Failure::Paused(sentence) => {
            eprintln!("lole: {}", shown(&sentence.text(language)));
            ExitCode::from(INTERRUPTED)
        }
    }
}

/// The sentence and its causes, without line breaks.
fn one_line(error: &anyhow::Error, language: Language) -> String {
    let mut text = said(error, language).replace(['\n', '\r'], " ");
    for cause in error.chain().skip(1) {
        let sentence = cause.to_string().replace(['\n', '\r'], " ");
        if !text.contains(&sentence) {
            text.push_str(" (");
            text.push_str(&sentence);
            text.push(')');
        }
    }
    text
}

/// What people read of an error: what is not ours is in the language it came in.
fn said(error: &anyhow::Error, language: Language) -> String {
    if let Some(sentence) = error.downcast_ref::<Sentence>() {
        sentence.text(language)
    } else if let Some(design) = error.downcast_ref::<DesignError>() {
        design.text(language)
    } else if let Some(stage) = error.downcast_ref::<StageError>() {
        stage.text(language)
    } else {
        error.to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn causes_follow_the_sentence_in_parentheses() {
        let sentence = Sentence::new("a.lole: 読めません", "a.lole: cannot be read");
        let error = anyhow::anyhow!("no such\nfile").context(sentence);
        for (language, expected) in [
            (Language::English, "a.lole: cannot be read (no such file)"),
            (Language::Japanese, "a.lole: 読めません (no such file)"),
        ] {
            assert_eq!(one_line(&error, language), expected);
        }
    }

    #[test]
    fn mistakes_in_a_design_are_explained_in_both_languages() {
        let error =
            lole_costume::document::parse("lole = 1\n[skirt]\nhem_hight_cm = 2\n", "a.lole")
                .unwrap_err();
        let error = anyhow::Error::from(error);
        assert_eq!(
            one_line(&error, Language::Japanese),
            "a.lole:3: [skirt] hem_hight_cm: このような項目はありません。hem_height_cm のことですか"
        );
        assert!(one_line(&error, Language::English).ends_with("did you mean hem_height_cm?"));
    }
}
