//! The engine against closed forms: what the protocols find, as rows of the table.

use lole_export::report::Remark;
use lole_export::validation::{CheckEntry, CurveEntry, ProtocolEntry};
use lole_language::Words;
use lole_stage::validate::{Check, Protocol, Subject};

/// What keeps a method from more.
pub fn limits(protocol: &Protocol, subject: Subject) -> impl Iterator<Item = Words> {
    let of_subject = move |limit: &&(Subject, Words)| limit.0 == subject;
    protocol
        .limits
        .iter()
        .filter(of_subject)
        .map(|limit| limit.1)
}

/// A protocol without figures yet.
#[must_use]
pub fn entry(protocol: &Protocol) -> ProtocolEntry {
    ProtocolEntry {
        name: protocol.name.to_owned(),
        about: remark(protocol.about),
        rows: Vec::new(),
        limits: (protocol.limits.iter())
            .map(|&(subject, limit)| (subject.id().to_owned(), remark(limit)))
            .collect(),
        curve: protocol.curve.as_ref().map(|curve| CurveEntry {
            along: remark(curve.along),
            value: remark(curve.value),
            points: curve.points(),
        }),
    }
}

/// One figure of a protocol for one method.
#[must_use]
pub fn row(protocol: &Protocol, subject: Subject, check: Check) -> CheckEntry {
    let limits: Vec<_> = limits(protocol, subject)
        .map(|limit| limit.english)
        .collect();
    CheckEntry {
        name: protocol.name.to_owned(),
        method: subject.id().to_owned(),
        measured: check.measured,
        reference: check.reference,
        unit: check.unit.to_owned(),
        error_pct: check.error_pct(),
        gate_pct: check.gate_pct,
        bounds: check.bounds(),
        pass: check.passes(),
        along: check.along,
        limit: (!limits.is_empty()).then(|| limits.join("; ")),
        case: check.case,
    }
}

fn remark(words: Words) -> Remark {
    Remark {
        sentence: words.english.to_owned(),
        sentence_ja: words.japanese.to_owned(),
    }
}
