//! `lole validate`: the engine against closed forms.

use lole_language::{Language, Sentence, words};
use lole_stage::validate::{PROTOCOLS, Subject};
use serde::Serialize;

use crate::args::ValidateArgs;
use crate::dance::unknown;
use crate::patience::stop_flag;
use crate::{Failure, summary};

/// One figure, as it is printed for programs.
#[derive(Serialize)]
struct Row {
    name: &'static str,
    case: String,
    method: &'static str,
    measured: f64,
    reference: f64,
    unit: &'static str,
    error_pct: f64,
    gate_pct: f64,
    pass: bool,
}

/// Runs the command.
pub(crate) fn run(args: &ValidateArgs, language: Language) -> Result<(), Failure> {
    let names: Vec<_> = PROTOCOLS.iter().map(|protocol| protocol.name).collect();
    if let Some(only) = &args.only
        && !names.contains(&only.as_str())
    {
        let what = words("検証", "protocol");
        return Err(unknown("--only", only, what, &names));
    }
    let stop = stop_flag().map_err(Failure::Run)?;
    let wanted = |name: &str| args.only.as_ref().is_none_or(|only| only == name);
    let mut rows = Vec::new();
    for protocol in PROTOCOLS.iter().filter(|protocol| wanted(protocol.name)) {
        if !args.json {
            summary::print_protocol(protocol, language);
        }
        for subject in Subject::ALL {
            if stop.load(std::sync::atomic::Ordering::Relaxed) {
                return Err(Failure::Interrupted);
            }
            for check in protocol.run(subject).map_err(Failure::error)? {
                if !args.json {
                    summary::print_check(subject.id(), &check, language);
                }
                rows.push(Row {
                    name: protocol.name,
                    method: subject.id(),
                    measured: check.measured,
                    reference: check.reference,
                    unit: check.unit,
                    error_pct: check.error_pct(),
                    gate_pct: check.gate_pct,
                    pass: check.passes(),
                    case: check.case,
                });
            }
        }
    }
    if args.json {
        let json = serde_json::to_string_pretty(&rows).map_err(Failure::error)?;
        summary::print_json(&(json + "\n"));
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
