//! A recorded dance: which file, what follows its end, and whether she walks away.

use std::path::Path;

use eframe::egui::{RichText, Ui};
use lole_costume::document::{MotionDrift, MotionRepeat};

use super::hindrance;
use super::knob::{choice, wide_button};
use crate::studio::Request;
use crate::{Studio, text};

pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
    let Some(file) = &studio.design().motion.file else {
        return;
    };
    let name = Path::new(&file.name).file_name();
    let name = name.map_or_else(|| file.name.clone(), |name| name.to_string_lossy().into());
    ui.label(RichText::new(name).strong());
    if let Some(seconds) = seconds(studio) {
        let unit = studio.say(text::SECONDS);
        ui.label(RichText::new(format!("{seconds:.1} {unit}")).small().weak());
    }
    if wide_button(ui, studio.say(text::OPEN_RECORDING)) {
        studio.request(Request::AskRecording);
    }
    hindrance::show(ui, studio, &["[motion]"]);
    ui.label(studio.say(text::AFTER_ITS_END));
    let repeats = [
        (MotionRepeat::Once, studio.say(text::STANDS_STILL)),
        (MotionRepeat::Loop, studio.say(text::BEGINS_AGAIN)),
    ];
    let motion = &studio.design().motion;
    let (repeat, drift) = (motion.repeat, motion.drift);
    if let Some(repeat) = choice(ui, Some(repeat), &repeats) {
        studio.change(|design| design.motion.repeat = repeat);
    }
    ui.label(studio.say(text::WAY));
    let drifts = [
        (MotionDrift::Keep, studio.say(text::WALKS)),
        (MotionDrift::Remove, studio.say(text::STAYS)),
    ];
    if let Some(drift) = choice(ui, Some(drift), &drifts) {
        studio.change(|design| design.motion.drift = drift);
    }
    ui.label(
        RichText::new(studio.say(text::DROP_RECORDING))
            .small()
            .weak(),
    );
}

/// How long the recording is [s], once it is danced.
fn seconds(studio: &Studio) -> Option<f32> {
    studio.snapshot.as_ref()?.recording_seconds
}
