//! `lole validate`: the engine against closed forms.

use lole_export::validation::{CheckEntry, ValidationReport, validation_html};
use lole_files::OutputFolder;
use lole_language::{Language, Sentence, words};
use lole_stage::validate::{Check, PROTOCOLS, Protocol, Subject};
use lole_study::validation::{entry, limits, row};

use crate::args::ValidateArgs;
use crate::dance::unknown;
use crate::output;
use crate::patience::{check, stop_flag};
use crate::{Failure, summary};

/// Runs the command.
pub(crate) fn run(args: &ValidateArgs, language: Language) -> Result<(), Failure> {
    let names: Vec<_> = PROTOCOLS.iter().map(|protocol| protocol.name).collect();
    if let Some(only) = &args.only
        && !names.contains(&only.as_str())
    {
        let what = words("検証", "protocol");
        return Err(unknown("--only", only, what, &names));
    }
    let output = args
        .out
        .as_deref()
        .map(output::create)
        .transpose()
        .map_err(Failure::Usage)?;
    let stop = stop_flag().map_err(Failure::error)?;
    let wanted = |name: &str| args.only.as_ref().is_none_or(|only| only == name);
    let mut report = ValidationReport {
        lole: env!("CARGO_PKG_VERSION").to_owned(),
        protocols: Vec::new(),
    };
    for protocol in PROTOCOLS.iter().filter(|protocol| wanted(protocol.name)) {
        let shown = (!args.json).then_some(language);
        if let Some(language) = shown {
            summary::print_protocol(protocol, language);
        }
        let mut entry = entry(protocol);
        for &subject in protocol.subjects {
            check(&stop)?;
            let checks = protocol.run(subject).map_err(Failure::error)?;
            if let Some(language) = shown {
                print(protocol, subject, &checks, language);
            }
            let rows = checks
                .into_iter()
                .map(|check| row(protocol, subject, check));
            entry.rows.extend(rows);
        }
        report.protocols.push(entry);
    }
    finish(args, &report, output, language)
}

/// Prints and writes what was found.
fn finish(
    args: &ValidateArgs,
    report: &ValidationReport,
    output: Option<OutputFolder>,
    language: Language,
) -> Result<(), Failure> {
    let rows: Vec<&CheckEntry> = (report.protocols.iter())
        .flat_map(|protocol| &protocol.rows)
        .collect();
    let json = serde_json::to_string_pretty(&rows).map_err(Failure::error)? + "\n";
    if args.json {
        summary::print_json(&json);
    }
    if let Some(mut output) = output {
        let page = validation_html(report);
        output
            .write("validation.html", page.as_bytes())
            .and_then(|()| output.write("validation.json", json.as_bytes()))
            .map_err(Failure::error)?;
        let paths = output.finish().map_err(Failure::error)?;
        if !args.json {
            summary::print_files(&paths, language);
        }
    }
    let failed = rows.iter().filter(|row| !row.pass).count();
    if failed == 0 {
        return Ok(());
    }
    let sentence = Sentence::new(
        format!("{failed} 件が許容を超えました。上の行をご覧ください"),
        format!("{failed} figures are outside their gates; see the rows above"),
    );
    Err(Failure::Run(sentence.into()))
}

fn print(protocol: &Protocol, subject: Subject, checks: &[Check], language: Language) {
    for check in checks {
        summary::print_check(subject.id(), check, language);
    }
    for limit in limits(protocol, subject) {
        summary::print_limit(subject.id(), limit, language);
    }
}
