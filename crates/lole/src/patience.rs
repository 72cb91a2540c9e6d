//! Long work: its progress, and its interruption.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use anyhow::{Context as _, Result};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use lole_language::Sentence;

/// A flag that Ctrl-C and a request to end set.
pub(crate) fn stop_flag() -> Result<Arc<AtomicBool>> {
    let flag = Arc::new(AtomicBool::new(false));
    let set = Arc::clone(&flag);
    ctrlc::set_handler(move || set.store(true, Ordering::Relaxed)).context(Sentence::new(
        "このシステムでは Ctrl-C を受け取れません",
        "the system lets no program listen to Ctrl-C",
    ))?;
    Ok(flag)
}

/// A bar of `length` steps on standard error.
pub(crate) fn progress_bar(length: u32, message: &'static str) -> ProgressBar {
    let style = ProgressStyle::with_template("{msg:>12} [{bar:32}] {pos}/{len}  {eta}")
        .unwrap_or_else(|_| ProgressStyle::default_bar())
        .progress_chars("=> ");
    let bar = ProgressBar::with_draw_target(
        Some(u64::from(length)),
        ProgressDrawTarget::stderr_with_hz(5),
    );
    bar.with_style(style).with_message(message)
}
