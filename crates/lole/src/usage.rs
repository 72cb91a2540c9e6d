//! The command line in both languages: its help, and one sentence for what was typed wrongly.

mod japanese;

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
use japanese::JAPANESE_HELP;

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
    let typed = std::env::args_os().take(1).chain(as_help(words));
    command(language)
        .try_get_matches_from(typed)
        .and_then(|matches| Cli::from_arg_matches(&matches))
        .map(|cli| {
            if cli.quiet {
                summary::say_less();
            }
            Asked::Command(Box::new(cli.command))
        })
        .map_err(|error| match error.kind() {
            ErrorKind::DisplayHelp
            | ErrorKind::DisplayVersion
            | ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => error.exit(),
            _ => summary::explain(&Failure::usage(sentence(&error)), language),
        })
}

/// `lole help order` as `lole order --help`: one word of help in both languages.
fn as_help(words: Vec<OsString>) -> Vec<OsString> {
    match words.split_first() {
        Some((first, asked)) if first == "help" => {
            let asked = asked.iter().take(1).cloned();
            asked.chain(["--help".into()]).collect()
        }
        _ => words,
    }
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

pub(crate) fn command(language: Language) -> Command {
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
        .mut_arg("quiet", |quiet| {
            quiet
                .help("書き出したものと進み具合を表示しません（警告と、求めた数値は表示します）")
                .help_heading("オプション")
        })
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
        ErrorKind::MissingRequiredArgument => Sentence::new(
            format!("{option}: 書かれていません。足してください。lole --help に説明があります"),
            format!("{option}: it is missing; add it, lole --help tells how"),
        ),
        ErrorKind::ArgumentConflict => {
            let other = context(ContextKind::PriorArg);
            let other = other.split([' ', '=']).next().unwrap_or_default();
            if other.is_empty() || other == name {
                Sentence::new(
                    format!("{name}: 二度は書けません。一つだけ残してください"),
                    format!("{name}: it stands there twice; keep one"),
                )
            } else {
                Sentence::new(
                    format!("{name} と {other} は一緒に使えません。どちらか一つを残してください"),
                    format!("{name} and {other} do not go together; keep one"),
                )
            }
        }
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
            (
                &["lole", "dance", "--avatar", "a.vrm", "--measures", "b.yaml"],
                "--avatar and --measures do not go together; keep one",
            ),
        ] {
            let sentence = said(words);
            assert_eq!(sentence.english, english);
            let kana = |letter: char| ('ぁ'..='ヿ').contains(&letter);
            assert!(sentence.japanese.contains(kana), "{sentence}");
        }
    }
}
