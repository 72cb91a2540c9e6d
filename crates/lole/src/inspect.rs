//! `lole inspect`: what is in a recording or an avatar.

use std::path::Path;

use lole_avatar::AvatarInspection;
use lole_exchange::{PatternInspection, garmentcode, measures};
use lole_files::Unread;
use lole_language::{Language, Sentence};
use lole_motion::{RecordingInspection, bvh};

use crate::args::InspectArgs;
use crate::{Failure, summary};

/// Largest file that is looked into [byte].
const LARGEST_FILE: u64 = 512 << 20;

/// Runs the command.
pub(crate) fn run(args: &InspectArgs, language: Language) -> Result<(), Failure> {
    let bytes = read(&args.file)?;
    let bytes = lole_files::with_neighbors(bytes, &args.file).map_err(Failure::usage)?;
    let list = args.bones.as_deref().map(read).transpose()?;
    let list = list.map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
    let list = list.as_deref();
    let named = |sentence: Sentence| Failure::usage(lole_files::in_file(&args.file, &sentence));
    let is_pattern = garmentcode::is_specification(&bytes);
    if args.svg.is_some() && !is_pattern {
        return Err(named(Sentence::new(
            "--svg は GarmentCode の型紙だけに使えます",
            "--svg is for a pattern of GarmentCode alone",
        )));
    }
    let (lines, json) = if is_pattern {
        let given = garmentcode::read(&bytes).map_err(|error| named(Sentence::of(&error)))?;
        if let Some(path) = &args.svg {
            let drawing = lole_exchange::flat::svg(&given);
            lole_files::write_whole(path, drawing.as_bytes()).map_err(Failure::usage)?;
        }
        let found = PatternInspection::new(&given);
        (found.lines(), serde_json::to_string_pretty(&found))
    } else if is_measures(&args.file, &bytes) {
        let found = measures::read(&bytes).map_err(|error| named(Sentence::of(&error)))?;
        (found.lines(), serde_json::to_string_pretty(&found))
    } else if is_bvh(&bytes) {
        let recording = bvh::parse(&bytes).map_err(|error| named(Sentence::of(&error)))?;
        let found = RecordingInspection::new("BVH", &recording, list);
        (found.lines(), serde_json::to_string_pretty(&found))
    } else {
        let found = AvatarInspection::new(&bytes, list);
        let found = found.map_err(|error| {
            named(match ending(&args.file).as_str() {
                "json" => no_known_json(),
                "lole" => a_design(),
                "take" => a_take(),
                _ => Sentence::of(&error),
            })
        })?;
        (found.lines(), serde_json::to_string_pretty(&found))
    };
    if args.json {
        summary::print_json(&json.map_err(Failure::error)?);
    } else {
        summary::print_inspection(&args.file, &lines, language);
    }
    Ok(())
}

/// Whether a file is one of measures: by its name, or as a set of FreeSewing begins.
fn is_measures(path: &Path, bytes: &[u8]) -> bool {
    let ending = ending(path);
    let is_named = ["yaml", "yml", "smis", "vit"].contains(&ending.as_str());
    is_named || (ending == "json" && measures::read(bytes).is_ok())
}

/// What a file's name ends with, in small letters.
fn ending(path: &Path) -> String {
    let ending = path.extension().and_then(|ending| ending.to_str());
    ending.unwrap_or_default().to_ascii_lowercase()
}

/// Of a file whose name promises JSON, and that is nothing that is read here.
fn no_known_json() -> Sentence {
    Sentence::new(
        "GarmentCode の型紙でも、採寸でも、glTF でもありません。もとのプログラムから書き出し直してください",
        "this is no pattern of GarmentCode, no measures and no glTF; export it again from its program",
    )
}

/// Of a design, which has commands of its own.
fn a_design() -> Sentence {
    Sentence::new(
        "これはデザインです。型紙は lole pattern、費用は lole cost、踊りは lole dance に渡してください",
        "this is a design; give it to lole pattern for its pattern, lole cost for its price or lole dance to see it",
    )
}

/// Of a recording of Lole's own.
fn a_take() -> Sentence {
    Sentence::new(
        "これは踊りの記録です。lole export に渡してください",
        "this is a recorded dance; give it to lole export",
    )
}

/// Whether a file begins as BVH does.
fn is_bvh(bytes: &[u8]) -> bool {
    let text = bytes.strip_prefix("\u{feff}".as_bytes()).unwrap_or(bytes);
    let text = text.trim_ascii_start();
    let comment = text.starts_with(b"#") || text.starts_with(b"//");
    comment
        || text
            .get(..9)
            .is_some_and(|word| word.eq_ignore_ascii_case(b"HIERARCHY"))
}

fn read(path: &Path) -> Result<Vec<u8>, Failure> {
    let name = path.display();
    let limit = LARGEST_FILE >> 20;
    lole_files::read_ordinary(path, LARGEST_FILE).map_err(|why| {
        Failure::usage(match why {
            Unread::Unreadable => Sentence::new(
                format!("{name}: ファイルが読めません。場所と名前を確かめてください"),
                format!("{name}: the file cannot be read; check the path"),
            ),
            Unread::NoFile => lole_files::no_ordinary_file(path),
            Unread::TooLarge { megabytes } => Sentence::new(
                format!("{name}: {megabytes} MB あり、{limit} MB までしか読みません"),
                format!("{name}: the file has {megabytes} MB, and {limit} MB are read at most"),
            ),
        })
    })
}
