//! A recorded dance: which file, what follows its end, and whether she walks away.

use std::path::Path;
use std::sync::Arc;

use eframe::egui::{RichText, Ui};
use lole_avatar::{AnimationSummary, list_clips};
use lole_costume::document::{MotionDrift, MotionRepeat};

use super::hindrance;
use super::knob::{DropDown, choice, wide_button};
use crate::studio::Request;
use crate::{Studio, text};

/// The animations of the file that is danced.
#[derive(Debug, Default)]
pub(crate) struct ClipShelf {
    /// The file they are of.
    of: Option<Arc<[u8]>>,
    clips: Arc<[AnimationSummary]>,
}

impl ClipShelf {
    /// A file whose animations are known.
    #[cfg(test)]
    pub(crate) fn holding(bytes: Arc<[u8]>, clips: Vec<AnimationSummary>) -> Self {
        Self {
            of: Some(bytes),
            clips: clips.into(),
        }
    }

    /// The animations of these bytes, read when they are first asked for; none of a file that cannot be
    /// read, whose sentence is told where it is danced.
    fn of(&mut self, bytes: &Arc<[u8]>) -> Arc<[AnimationSummary]> {
        let is_known = (self.of.as_ref()).is_some_and(|known| Arc::ptr_eq(known, bytes));
        if !is_known {
            self.clips = list_clips(bytes).unwrap_or_default().into();
            self.of = Some(Arc::clone(bytes));
        }
        Arc::clone(&self.clips)
    }
}

pub(super) fn show(ui: &mut Ui, studio: &mut Studio) {
    let Some(file) = &studio.design().motion.file else {
        return;
    };
    let bytes = file.bytes.clone();
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
    if let Some(bytes) = bytes {
        clip(ui, studio, &bytes);
    }
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

/// Which of several animations is danced.
fn clip(ui: &mut Ui, studio: &mut Studio, bytes: &Arc<[u8]>) {
    let wished = studio.design().motion.clip.clone();
    let clips = studio.clips.of(bytes);
    let dances = || (clips.iter().enumerate()).filter(|(_, clip)| clip.is_dance());
    if dances().count() < 2 && wished.is_empty() {
        return;
    }
    let named = dances().find(|(_, clip)| clip.name == wished);
    let numbered = || dances().find(|(index, _)| wished == (index + 1).to_string());
    let first = || dances().next().filter(|_| wished.is_empty());
    let chosen = (named.or_else(numbered).or_else(first)).map(|(index, _)| index);
    let options: Vec<(Option<usize>, String)> = dances()
        .map(|(index, clip)| {
            let said = format!("{} {}  {:.1} s", index + 1, clip.name, clip.duration_s);
            (Some(index), said)
        })
        .collect();
    let name = studio.say(text::CLIP);
    let list = DropDown { salt: "clip", name };
    if let Some(picked) = list.show(ui, chosen, &options).flatten() {
        // A name that another animation has first would lead to that one.
        let name = &clips[picked].name;
        let leads_here = dances().find(|(_, clip)| clip.name == *name);
        let is_told = !name.is_empty() && leads_here.is_some_and(|(index, _)| index == picked);
        let clip = if is_told {
            name.clone()
        } else {
            (picked + 1).to_string()
        };
        studio.change(|design| design.motion.clip = clip);
    }
}

/// How long the recording is [s], once it is danced.
fn seconds(studio: &Studio) -> Option<f32> {
    studio.snapshot.as_ref()?.recording_seconds
}
