//! What `lole validate` found: rows for programs, a page for people.

mod html;

use serde::Serialize;

use crate::report::Remark;

/// All that was validated.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ValidationReport {
    /// Version of the program.
    pub lole: String,
    /// The protocols in their order.
    pub protocols: Vec<ProtocolEntry>,
}

/// One protocol.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ProtocolEntry {
    /// Name for programs.
    pub name: String,
    /// What is compared with what.
    pub about: Remark,
    /// Its figures.
    pub rows: Vec<CheckEntry>,
    /// What keeps a method from more: the method, and why.
    pub limits: Vec<(String, Remark)>,
    /// The curve that some of its figures should lie on.
    pub curve: Option<CurveEntry>,
}

/// One figure held against its reference.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct CheckEntry {
    /// Name of the protocol.
    pub name: String,
    /// Which case of it.
    pub case: String,
    /// Name of the method.
    pub method: String,
    /// The figure.
    pub measured: f64,
    /// What it should be.
    pub reference: f64,
    /// Unit of both, or nothing.
    pub unit: String,
    /// Error [%], of the reference or of the bound where that is zero.
    pub error_pct: f64,
    /// Largest error that passes [%].
    pub gate_pct: f64,
    /// From where to where the figure passes, in its unit.
    pub bounds: [f64; 2],
    /// Whether it does.
    pub pass: bool,
    /// Where the figure lies along the curve.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub along: Option<f64>,
    /// What keeps the method from more here, in English.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limit: Option<String>,
}

/// A curve that is known.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct CurveEntry {
    /// What is along the axis below.
    pub along: Remark,
    /// What is upward.
    pub value: Remark,
    /// Points of it, ascending along the axis.
    pub points: Vec<[f64; 2]>,
}

/// `validation.html`: one self-contained page in Japanese and English, a table and a plot for every
/// protocol.
#[must_use]
pub fn validation_html(report: &ValidationReport) -> String {
    html::page(report)
}
