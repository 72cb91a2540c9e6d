//! What `lole bench --pareto` found: a page for people, with quality over time.

mod html;

use crate::report::Remark;

/// All scenes that were measured.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TradeOffReport {
    /// Version of the program.
    pub lole: String,
    /// The scenes in their order.
    pub scenes: Vec<TradeOff>,
}

/// One scene with many settings.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TradeOff {
    /// Name for programs.
    pub scene: String,
    /// What a viewer should see, in English.
    pub about: String,
    /// Its settings, in any order.
    pub points: Vec<TradeOffPoint>,
}

/// One setting and what it gives.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TradeOffPoint {
    /// Name of the method.
    pub method: String,
    /// What was set.
    pub settings: Remark,
    /// Whether the scene itself has these settings.
    pub is_own: bool,
    /// Time of a frame [ms].
    pub frame_ms: f64,
    /// 99th percentile of the strain [%].
    pub strain_p99_pct: f64,
    /// Largest strain [%].
    pub strain_max_pct: f64,
    /// The phase that takes most of the time, where it is known.
    pub longest_phase: Option<String>,
    /// Whether no other point is as fast and as good.
    pub on_front: bool,
}

/// `bench.html`: one self-contained page in Japanese and English, a plot and a table for every
/// scene.
#[must_use]
pub fn trade_off_html(report: &TradeOffReport) -> String {
    html::page(report)
}
