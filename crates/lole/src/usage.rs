//! The command line in both languages: its help, and one sentence for what was typed wrongly.

use std::error::Error as _;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Arg, ArgAction, Command, CommandFactory as _, FromArgMatches as _};

use lole_costume::document;
use lole_language::{Bilingual as _, Language, Sentence, repeated};

use crate::args::{self, Cli};
use crate::{Failure, summary};

/// What help says in Japanese: a command, one of its arguments (none for the command itself), and
/// the text.
const JAPANESE_HELP: &[(&str, &str, &str)] = &[
    (
        "dance",
        "",
        "デザインを着せて踊らせ、動画・写真・3Dファイル・レポートを書き出します",
    ),
    (
        "dance",
        "design",
        "デザインの文書。書かなければ、内蔵のパウスカートがカホロを踊ります",
    ),
    ("dance", "out", "書き出すフォルダー"),
    (
        "dance",
        "seconds",
        "踊りの長さ [秒]、0.5 から 600。書かなければデザインのとおり（デザインがなければ 12）",
    ),
    (
        "dance",
        "step",
        "ステップ: kao, kaholo, ami, uwehe。書かなければデザインのとおり",
    ),
    (
        "dance",
        "bpm",
        "テンポ（1分あたりの拍数）。書かなければデザインのとおり",
    ),
    (
        "dance",
        "method",
        "計算方法: xpbd（実時間）または fb-euler（基準、遅い）。書かなければデザインのとおり",
    ),
    (
        "dance",
        "avatar",
        "デザインの踊り手のかわりに踊るアバター（.vrm .glb .gltf）",
    ),
    (
        "dance",
        "motion",
        "デザインの踊りのかわりに踊る記録（.bvh .vrma .glb .vrm）",
    ),
    (
        "dance",
        "audio",
        "動画に入れる曲: MP4 の AAC か Opus（.m4a）。踊りと同時に始まります",
    ),
    ("dance", "size", "動画の大きさ [画素]。どちらも偶数"),
    (
        "dance",
        "threads",
        "計算に使うスレッド数。いくつでも結果は同じです",
    ),
    (
        "dance",
        "seed",
        "ギャザーの寄り方のばらつきの種。書かなければデザインのとおり",
    ),
    (
        "dance",
        "measures",
        "ほかのプログラムの採寸: GarmentCode の体（.yaml）、FreeSewing（.json .yaml）、Seamly の .smis",
    ),
    (
        "dance",
        "cpu",
        "グラフィックス装置があっても CPU で描きます",
    ),
    (
        "dance",
        "json",
        "レポートを JSON で標準出力に書きます（ほかには何も書きません）",
    ),
    (
        "wear",
        "",
        "ほかのプログラムの型紙から服を縫い、着せて踊らせます（書き出すものは dance と同じ）",
    ),
    (
        "wear",
        "pattern",
        "型紙: GarmentCode の仕様ファイル（.json）",
    ),
    (
        "wear",
        "dancer",
        "踊り手・踊り・布・柄をとるデザイン（その服は着ません）",
    ),
    ("wear", "avatar", "着るアバター（.vrm .glb .gltf）"),
    ("wear", "out", "書き出すフォルダー"),
    (
        "wear",
        "size_ratio",
        "型紙の大きさの倍率、0.25 から 4。書かなければ、着られる大きさ",
    ),
    (
        "wear",
        "fabric",
        "棚の布（cotton-lawn など）。一覧は lole fabric",
    ),
    (
        "wear",
        "seconds",
        "踊りの長さ [秒]、0.5 から 600。書かなければデザインのとおり（デザインがなければ 12）",
    ),
    (
        "wear",
        "step",
        "ステップ: kao, kaholo, ami, uwehe。書かなければデザインのとおり",
    ),
    (
        "wear",
        "bpm",
        "テンポ（1分あたりの拍数）。書かなければデザインのとおり",
    ),
    ("wear", "motion", "踊る記録（.bvh .vrma .glb .vrm）"),
    ("wear", "size", "動画の大きさ [画素]。どちらも偶数"),
    (
        "wear",
        "threads",
        "計算に使うスレッド数。いくつでも結果は同じです",
    ),
    (
        "wear",
        "measures",
        "ほかのプログラムの採寸: GarmentCode の体（.yaml）、FreeSewing（.json .yaml）、Seamly の .smis",
    ),
    ("wear", "cpu", "グラフィックス装置があっても CPU で描きます"),
    (
        "wear",
        "json",
        "レポートを JSON で標準出力に書きます（ほかには何も書きません）",
    ),
    (
        "pattern",
        "",
        "裁ち方図と型紙を書き出します: 実物大の PDF、SVG、DXF",
    ),
    (
        "pattern",
        "design",
        "デザインの文書。書かなければ、内蔵のパウスカート",
    ),
    ("pattern", "out", "書き出すフォルダー"),
    (
        "pattern",
        "paper",
        "印刷する紙: a4、a3、letter。書かなければ a4",
    ),
    (
        "pattern",
        "folded",
        "布を縦に二つ折り（わ）にして、左右を一度に裁ちます",
    ),
    (
        "pattern",
        "match_print",
        "縫い目で柄が合うように置きます（布が多く要ります）",
    ),
    (
        "pattern",
        "format",
        "かわりに、ほかのプログラムの形で型紙と縫い合わせを書き出します: garmentcode",
    ),
    (
        "pattern",
        "json",
        "型紙を JSON で標準出力に書きます（ほかには何も書きません）",
    ),
    (
        "order",
        "",
        "一つのデザインを名簿の全員に: 裁つ寸法、ゴム、買う布、費用、縫い方の本、一覧",
    ),
    ("order", "roster", "表計算ソフトの名簿（CSV）: 名前と寸法"),
    ("order", "design", "全員が着るデザインの文書"),
    (
        "order",
        "out",
        "書き出すフォルダー。中止した回の写真はここに残り、次に使われます",
    ),
    (
        "order",
        "spare",
        "予備の布。用尺に対する割合 [%]、0 から 100",
    ),
    (
        "order",
        "bolt",
        "一反の長さ [m]。どこで反物が変わるかがわかります",
    ),
    (
        "order",
        "language",
        "ページの言葉: ja または en。書かなければシステムのとおり",
    ),
    ("order", "paper", "プリンターの紙: a4、a3、letter"),
    (
        "order",
        "no_pictures",
        "踊り手の写真を省きます（時間の大半は写真です）",
    ),
    (
        "order",
        "json",
        "注文を JSON で標準出力に書きます（ほかには何も書きません）",
    ),
    (
        "booklet",
        "",
        "縫い方の本（PDF）: 用意するもの、裁ち方、図のある手順、費用",
    ),
    (
        "booklet",
        "design",
        "デザインの文書。書かなければ、内蔵のパウスカート",
    ),
    ("booklet", "out", "書き出すファイル"),
    (
        "booklet",
        "language",
        "ページの言葉: ja または en。書かなければシステムのとおり",
    ),
    ("booklet", "paper", "プリンターの紙: a4、a3、letter"),
    ("booklet", "no_pictures", "表紙の写真を省きます"),
    ("cost", "", "デザインにある値段での費用と、足りない値段"),
    (
        "cost",
        "design",
        "デザインの文書。書かなければ、内蔵のパウスカート",
    ),
    ("cost", "json", "費用を JSON で書きます"),
    ("form", "", "寸法を書き込む採寸表（PDF）"),
    (
        "form",
        "roster",
        "名前を書き入れる名簿（CSV）、一人一ページ。書かなければ名前は空けます",
    ),
    ("form", "out", "書き出すファイル"),
    (
        "form",
        "language",
        "ページの言葉: ja または en。書かなければシステムのとおり",
    ),
    ("form", "paper", "プリンターの紙: a4、a3、letter"),
    (
        "study",
        "",
        "論文の実験を数値で: 積分法とその限界、13本のカプセル",
    ),
    ("study", "out", "書き出すフォルダー"),
    (
        "study",
        "quick",
        "短い計算にします（数分のかわりに1分以内）",
    ),
    ("study", "threads", "計算に使うスレッド数"),
    (
        "study",
        "json",
        "結果を JSON で標準出力に書きます（ほかには何も書きません）",
    ),
    (
        "validate",
        "",
        "布の計算を理論の値と比べます: 実測、基準、誤差、許容",
    ),
    ("validate", "only", "この検証だけを行います"),
    (
        "validate",
        "out",
        "表と曲線のページを書き出すフォルダー。書かなければ何も書き出しません",
    ),
    ("validate", "json", "行を JSON で書きます"),
    (
        "batch",
        "",
        "デザインの一部を変えながら何千回でも踊らせ、一つの表にします",
    ),
    (
        "batch",
        "sweep",
        "スイープ: デザインと、変えるキーの一覧（.toml）",
    ),
    (
        "batch",
        "out",
        "結果のフォルダー。そこで終わっている分は繰り返しません",
    ),
    (
        "batch",
        "threads",
        "同時に行う数（一つに一コア）。書かなければコアの数。表は同じです",
    ),
    (
        "batch",
        "shard",
        "N に分けた I 番目だけを行い、表は作りません（例 2/8）。Slurm などのために。同じフォルダーに書けます",
    ),
    (
        "batch",
        "merge",
        "何も踊らせず、終わっている分から表を作ります",
    ),
    (
        "batch",
        "from",
        "先に結果をもらう別のフォルダー。何度でも書けます",
    ),
    ("batch", "json", "結果を JSON で書きます"),
    (
        "bench",
        "",
        "この機械での1コマの計算時間を、ひずみとめり込みとともに場面ごとに測ります",
    ),
    ("bench", "scene", "この場面だけを測ります"),
    (
        "bench",
        "method",
        "この方法だけで測ります: xpbd または explicit-rows",
    ),
    ("bench", "threads", "計算に使うスレッド数"),
    (
        "bench",
        "vectors",
        "ベクトル命令: detected（この CPU で最も広いもの）、wide（AVX2 まで）、baseline（どの CPU にもあるもの）。ハッシュはどれでも同じです",
    ),
    (
        "bench",
        "roofline",
        "構造バネを、この機械の最良と比べます: 同じ演算・同じバイト数・同じ質点数（同じキャッシュ）で、何も待たないバネの列に対する速さの割合",
    ),
    (
        "bench",
        "sizes",
        "場面のかわりに、同じ設定の正方形を 4,096 から 262,144 質点まで測ります",
    ),
    (
        "bench",
        "pareto",
        "品質と時間: 各場面を粗い設定から細かい設定まで測り、ほかに負けないものを示します",
    ),
    (
        "bench",
        "out",
        "--pareto の曲線のページを書き出すフォルダー。書かなければ何も書き出しません",
    ),
    (
        "bench",
        "soak",
        "各場面をこのコマ数だけでたらめに動かし、布が有限で、伸びすぎず、体の正しい側にあることを確かめます",
    ),
    (
        "bench",
        "seed",
        "--soak の動きの種。書かなければ 1。同じ種は同じ動きになります",
    ),
    ("bench", "json", "表を JSON で書きます"),
    (
        "dancer",
        "",
        "踊り手だけ: 四方からの写真、体の寸法、カプセル、3Dファイル",
    ),
    (
        "dancer",
        "design",
        "デザインの文書。書かなければ、内蔵の踊り手です",
    ),
    ("dancer", "out", "書き出すフォルダー"),
    (
        "dancer",
        "avatar",
        "デザインの踊り手のかわりのアバター（.vrm .glb .gltf）",
    ),
    (
        "dancer",
        "measures",
        "ほかのプログラムの採寸: GarmentCode の体（.yaml）、FreeSewing（.json .yaml）、Seamly の .smis",
    ),
    (
        "dancer",
        "cpu",
        "グラフィックス装置があっても CPU で描きます",
    ),
    (
        "dancer",
        "json",
        "数値を JSON で標準出力に書きます（ほかには何も書きません）",
    ),
    (
        "inspect",
        "",
        "アバターや踊りの記録の中身: 骨、単位、向き、姿勢、メッシュ、動き、ライセンス",
    ),
    (
        "inspect",
        "file",
        "調べるファイル: アバターか踊りの記録（.vrm .glb .gltf .vrma .bvh）",
    ),
    (
        "inspect",
        "bones",
        "どの関節がどの骨かの表。一行に一つ「関節 = 骨」",
    ),
    (
        "inspect",
        "svg",
        "型紙を平らに、縫い合わせに番号をつけて、このファイルに描きます",
    ),
    ("inspect", "json", "JSON で書きます"),
    (
        "fabric",
        "",
        "棚の布とその数値。自分の布を物差しとはかりで測ることもできます",
    ),
    (
        "fabric",
        "task",
        "list: 棚の布。measure: 自分の布。数を書かなければ測り方を説明します",
    ),
    ("fabric", "length_cm", "布切れの、耳に沿った長さ [cm]"),
    ("fabric", "width_cm", "布切れの幅 [cm]"),
    ("fabric", "mass_g", "布切れの重さ [g]"),
    (
        "fabric",
        "overhang_warp_cm",
        "耳に沿って切った細い布が、机の端からはみ出した長さ [cm]",
    ),
    (
        "fabric",
        "drop_warp_cm",
        "その先が机の面から下がった長さ [cm]。書かなければ --slope-deg の斜面に触れたときとします",
    ),
    (
        "fabric",
        "overhang_weft_cm",
        "耳から耳の方向に切った布のはみ出した長さ [cm]。書かなければ同じとみなします",
    ),
    ("fabric", "drop_weft_cm", "その先が下がった長さ [cm]"),
    (
        "fabric",
        "slope_deg",
        "先が触れる斜面の角度 [度]。多くの試験所は 41.5、JIS L 1096 は 45",
    ),
    ("fabric", "json", "JSON で書きます"),
];

/// What was asked for.
pub(crate) enum Asked {
    /// The live window, with this document.
    Window(Option<PathBuf>),
    /// A command.
    Command(Box<args::Command>),
}

/// Reads the command line; where that ends the program (help, version, a mistake), the exit code.
pub(crate) fn read(language: Language) -> Result<Asked, ExitCode> {
    let words: Vec<OsString> = std::env::args_os().skip(1).collect();
    if let Some(document) = window(&words) {
        return Ok(Asked::Window(document));
    }
    command(language)
        .try_get_matches()
        .and_then(|matches| Cli::from_arg_matches(&matches))
        .map(|cli| Asked::Command(Box::new(cli.command)))
        .map_err(|error| match error.kind() {
            ErrorKind::DisplayHelp
            | ErrorKind::DisplayVersion
            | ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => error.exit(),
            _ => summary::explain(&Failure::usage(sentence(&error)), language),
        })
}

/// The window's document, where nothing else was typed: nothing at all, or one design.
fn window(words: &[OsString]) -> Option<Option<PathBuf>> {
    match words {
        [] => Some(None),
        [word] => {
            let path = Path::new(word);
            let is_design = (path.extension()).is_some_and(|end| end.eq_ignore_ascii_case("lole"));
            is_design.then(|| Some(path.to_owned()))
        }
        _ => None,
    }
}

fn command(language: Language) -> Command {
    let command = Cli::command();
    match language {
        Language::English => command,
        Language::Japanese => in_japanese(command),
    }
}

fn in_japanese(command: Command) -> Command {
    let names: Vec<_> = command
        .get_subcommands()
        .map(|sub| sub.get_name().to_owned())
        .collect();
    let command = headed(command)
        .about("布が生きて動く、フラ衣装の CAD。コマンドを書かなければ、踊りの窓を開きます")
        .subcommand_help_heading("コマンド")
        .disable_help_subcommand(true)
        .disable_version_flag(true)
        .arg(
            Arg::new("version")
                .short('V')
                .long("version")
                .action(ArgAction::Version)
                .help_heading("オプション")
                .help("バージョンを表示します"),
        );
    names.into_iter().fold(command, |command, name| {
        command.mut_subcommand(name.clone(), |sub| {
            let text = |argument: &str| {
                JAPANESE_HELP
                    .iter()
                    .find(|entry| entry.0 == name && entry.1 == argument)
                    .map_or("", |entry| entry.2)
            };
            let sub = sub.mut_args(|argument| {
                let help = text(argument.get_id().as_str());
                let heading = if argument.is_positional() {
                    "引数"
                } else {
                    "オプション"
                };
                let choices = argument.get_action().takes_values();
                let argument = argument.hide_possible_values(choices);
                argument.help(help).long_help(help).help_heading(heading)
            });
            headed(sub).about(text(""))
        })
    })
}

/// The headings of a command's help, and its help option.
fn headed(command: Command) -> Command {
    command
        .help_template("{about-with-newline}\n使い方: {usage}\n\n{all-args}")
        .disable_help_flag(true)
        .arg(
            Arg::new("help")
                .short('h')
                .long("help")
                .action(ArgAction::Help)
                .help_heading("オプション")
                .help("この説明を表示します"),
        )
}

/// What was typed wrongly, and what to type.
fn sentence(error: &clap::Error) -> Sentence {
    let context = |kind| match error.get(kind) {
        Some(ContextValue::String(text)) => repeated(text),
        Some(ContextValue::Strings(texts)) => texts.join(", "),
        _ => String::new(),
    };
    let option = context(ContextKind::InvalidArg);
    let name = option.split([' ', '=']).next().unwrap_or_default();
    match error.kind() {
        ErrorKind::ValueValidation => {
            let value = context(ContextKind::InvalidValue);
            let remedy = error.source().and_then(|source| source.downcast_ref());
            remedy.map_or_else(
                || plain(error),
                |remedy: &Sentence| {
                    Sentence::new(
                        format!("{name} {value}: {}", remedy.japanese()),
                        format!("{name} {value}: {remedy}"),
                    )
                },
            )
        }
        ErrorKind::InvalidValue => match context(ContextKind::InvalidValue).as_str() {
            "" => Sentence::new(
                format!("{name}: 値がありません。{option} のように書いてください"),
                format!("{name}: the value is missing; write {option}"),
            ),
            value => {
                let valid = context(ContextKind::ValidValue);
                Sentence::new(
                    format!("{name} {value}: {valid} から選んでください"),
                    format!("{name} {value}: choose one of {valid}"),
                )
            }
        },
        ErrorKind::UnknownArgument => unknown(
            &option,
            "オプションや引数",
            "option or argument",
            &long_options(),
        ),
        ErrorKind::InvalidSubcommand => {
            let command = Cli::command();
            let names = command.get_subcommands().map(Command::get_name);
            let names: Vec<_> = names.map(str::to_owned).collect();
            let typed = context(ContextKind::InvalidSubcommand);
            unknown(&typed, "コマンド", "command", &names)
        }
        ErrorKind::ArgumentConflict => Sentence::new(
            format!("{name}: 二度は書けません。一つだけ残してください"),
            format!("{name}: it stands there twice; keep one"),
        ),
        _ => plain(error),
    }
}

fn unknown(typed: &str, japanese: &str, english: &str, names: &[String]) -> Sentence {
    let choices: Vec<_> = names.iter().map(String::as_str).collect();
    let (near_japanese, near_english) = document::likely(typed, &choices).map_or_else(
        || {
            (
                "lole --help に一覧があります".to_owned(),
                "lole --help lists what there is".to_owned(),
            )
        },
        |near| {
            (
                format!("{near} のことですか"),
                format!("did you mean {near}?"),
            )
        },
    );
    Sentence::new(
        format!("{typed}: このような{japanese}はありません。{near_japanese}"),
        format!("{typed}: there is no such {english}; {near_english}"),
    )
}

/// Every option of the command that was typed, else of all of them.
fn long_options() -> Vec<String> {
    let command = Cli::command();
    let typed: Vec<String> = std::env::args().skip(1).collect();
    let named = |sub: &&Command| typed.iter().any(|word| word == sub.get_name());
    let own: Vec<&Command> = command.get_subcommands().filter(named).take(1).collect();
    let commands = if own.is_empty() {
        command.get_subcommands().collect()
    } else {
        own
    };
    commands
        .into_iter()
        .flat_map(Command::get_arguments)
        .filter_map(|argument| Some(format!("--{}", argument.get_long()?)))
        .collect()
}

/// A mistake of a rare kind, in the words of the argument parser.
fn plain(error: &clap::Error) -> Sentence {
    let text = error.to_string();
    let first = text.lines().next().unwrap_or_default();
    let english = first.strip_prefix("error: ").unwrap_or(first);
    Sentence::new(
        format!("コマンドの書き方が違います。lole --help をご覧ください ({english})"),
        format!("{english}; see lole --help"),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(words: &[&str]) -> Sentence {
        let error = command(Language::English)
            .try_get_matches_from(words)
            .unwrap_err();
        sentence(&error)
    }

    #[test]
    fn nothing_and_a_design_alone_open_the_window() {
        let opens = |words: &[&str]| {
            let words: Vec<OsString> = words.iter().map(OsString::from).collect();
            window(&words)
        };
        assert_eq!(opens(&[]), Some(None));
        assert_eq!(opens(&["a/hau.LOLE"]), Some(Some("a/hau.LOLE".into())));
        for words in [
            &["dance"][..],
            &["--help"],
            &["dans"],
            &["a.lole", "--json"],
        ] {
            assert_eq!(opens(words), None, "{words:?}");
        }
    }

    #[test]
    fn every_command_and_argument_has_help_in_japanese() {
        let command = Cli::command();
        for sub in command.get_subcommands() {
            let ids = sub
                .get_arguments()
                .map(|argument| argument.get_id().as_str());
            for id in ids.chain([""]) {
                let entry = JAPANESE_HELP
                    .iter()
                    .find(|entry| entry.0 == sub.get_name() && entry.1 == id);
                assert!(entry.is_some(), "{} {id}", sub.get_name());
            }
        }
        for (name, id, _) in JAPANESE_HELP.iter().copied() {
            let sub = command.find_subcommand(name).unwrap();
            let exists = sub.get_arguments().any(|argument| argument.get_id() == id);
            assert!(id.is_empty() || exists, "{name} {id}");
        }
        in_japanese(Cli::command()).debug_assert();
    }

    #[test]
    fn every_slip_gets_a_sentence_in_both_languages() {
        for (words, english) in [
            (
                ["lole", "dance", "--seconds", "-1"].as_slice(),
                "--seconds -1: give a number of seconds from 0.5 to 600, such as 12",
            ),
            (
                &["lole", "dance", "--bpm", "fast"],
                "--bpm fast: give a number of counts per minute, such as 80",
            ),
            (
                &["lole", "dance", "--threads", "0"],
                "--threads 0: give a whole number from 1 to 256",
            ),
            (
                &["lole", "dance", "--second", "2"],
                "--second: there is no such option or argument; did you mean --seconds?",
            ),
            (
                &["lole", "dans"],
                "dans: there is no such command; did you mean dance?",
            ),
            (
                &["lole", "bench", "--soak", "-5"],
                "--soak -5: give a whole number from 1 to 1000000000, such as 100000",
            ),
            (
                &["lole", "bench", "--soak", "9", "--seed", "dice"],
                "--seed dice: give a whole number from 0 upward, such as 1",
            ),
            (
                &["lole", "bench", "--vectors", "avx"],
                "--vectors avx: choose one of detected, wide, baseline",
            ),
            (
                &["lole", "pattern", "--paper", "b5"],
                "--paper b5: choose one of a4, a3, letter",
            ),
            (
                &["lole", "dance", "--step"],
                "--step: the value is missing; write --step <STEP>",
            ),
            (
                &["lole", "dance", "--seconds", "2", "--seconds", "3"],
                "--seconds: it stands there twice; keep one",
            ),
        ] {
            let sentence = said(words);
            assert_eq!(sentence.english, english);
            let kana = |letter: char| ('ぁ'..='ヿ').contains(&letter);
            assert!(sentence.japanese.contains(kana), "{sentence}");
        }
    }
}
