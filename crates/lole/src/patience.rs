//! Long work: its progress, and its interruption.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use anyhow::Context as _;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use lole_language::{Language, Sentence};

use crate::{Failure, summary};

/// A flag that Ctrl-C and a request to end set.
pub(crate) fn stop_flag() -> anyhow::Result<Arc<AtomicBool>> {
    let flag = Arc::new(AtomicBool::new(false));
    let set = Arc::clone(&flag);
    ctrlc::set_handler(move || set.store(true, Ordering::Relaxed)).context(Sentence::new(
        "このシステムでは Ctrl-C を受け取れません",
        "the system lets no program listen to Ctrl-C",
    ))?;
    Ok(flag)
}

/// Goes on, unless the flag is set.
pub(crate) fn check(stop: &AtomicBool) -> Result<(), Failure> {
    if stop.load(Ordering::Relaxed) {
        return Err(Failure::Interrupted);
    }
    Ok(())
}

/// A bar of `length` steps on standard error.
pub(crate) fn progress_bar(length: u32, message: &'static str) -> ProgressBar {
    let style = ProgressStyle::with_template("{msg:>12} [{bar:32}] {pos}/{len}  {eta}  {prefix}")
        .unwrap_or_else(|_| ProgressStyle::default_bar())
        .progress_chars("=> ");
    let target = if summary::is_quiet() {
        ProgressDrawTarget::hidden()
    } else {
        ProgressDrawTarget::stderr_with_hz(5)
    };
    let bar = ProgressBar::with_draw_target(Some(u64::from(length)), target);
    bar.with_style(style).with_message(message)
}

/// A frame that takes longer than this is spoken of.
const SILENCE: Duration = Duration::from_secs(10);
/// How often is looked.
const LOOK: Duration = Duration::from_millis(250);

/// Says on a bar that a frame takes long, and why, until it is dropped.
pub(crate) struct Watch {
    is_over: Arc<AtomicBool>,
    pressed: Arc<AtomicUsize>,
    thread: Option<JoinHandle<()>>,
}

impl Watch {
    /// Watches the position of a bar.
    pub(crate) fn over(bar: &ProgressBar, language: Language) -> Self {
        let (is_over, pressed) = (Arc::new(AtomicBool::new(false)), Arc::default());
        let thread = {
            let (bar, is_over, pressed) = (bar.clone(), Arc::clone(&is_over), Arc::clone(&pressed));
            thread::spawn(move || look(&bar, (&is_over, &pressed), language))
        };
        Self {
            is_over,
            pressed,
            thread: Some(thread),
        }
    }

    /// In how many places the cloth pressed on itself in the last frame.
    pub(crate) fn tell(&self, pressed: usize) {
        self.pressed.store(pressed, Ordering::Relaxed);
    }
}

impl Drop for Watch {
    fn drop(&mut self) {
        self.is_over.store(true, Ordering::Relaxed);
        if let Some(thread) = self.thread.take() {
            thread.thread().unpark();
            // A thread that only draws has nothing to say at its end.
            drop(thread.join());
        }
    }
}

fn look(bar: &ProgressBar, (is_over, pressed): (&AtomicBool, &AtomicUsize), language: Language) {
    let (mut position, mut waited) = (bar.position(), Duration::ZERO);
    while !is_over.load(Ordering::Relaxed) {
        thread::park_timeout(LOOK);
        if bar.position() == position {
            waited += LOOK;
        } else {
            (position, waited) = (bar.position(), Duration::ZERO);
            bar.set_prefix("");
        }
        if SILENCE <= waited {
            let count = pressed.load(Ordering::Relaxed);
            let said = said_of_slowness(waited, count);
            bar.set_prefix(language.pick(&said.japanese, &said.english).to_owned());
        }
    }
}

/// Why a frame takes so long.
fn said_of_slowness(waited: Duration, pressed: usize) -> Sentence {
    let seconds = waited.as_secs();
    if pressed == 0 {
        return Sentence::new(
            format!("このコマに {seconds} 秒かかっています"),
            format!("this frame has taken {seconds} s so far"),
        );
    }
    Sentence::new(
        format!(
            "このコマに {seconds} 秒かかっています。布どうしが {pressed} か所で押し合っています"
        ),
        format!(
            "this frame has taken {seconds} s so far: the cloth presses on itself in {pressed} places"
        ),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slow_frame_is_explained_in_both_languages() {
        let said = said_of_slowness(Duration::from_secs(12), 340);
        assert_eq!(
            said.english,
            "this frame has taken 12 s so far: the cloth presses on itself in 340 places"
        );
        assert!(said.japanese.contains("340 か所"));
        assert!(!said_of_slowness(SILENCE, 0).english.contains("presses"));
    }
}
