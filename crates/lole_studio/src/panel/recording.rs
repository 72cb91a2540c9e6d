//! A recorded dance: which file, what follows its end, and whether she walks away.

use std::path::Path;
use std::sync::Arc;

use eframe::egui::{RichText, Ui};
use lole_avatar::{AnimationSummary, list_clips};
use lole_costume::document::{MotionDrift, MotionRepeat};
use lole_language::Sentence;

use super::knob::{DropDown, choice, wide_button};
use super::{dance, hindrance};
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
        first(ui, studio);
        return;
    };
    let bytes = file.bytes.clone();
    ui.label(RichText::new(file_name(&file.name)).strong());
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

/// What can be done before a recording is danced.
fn first(ui: &mut Ui, studio: &mut Studio) {
    ui.label(studio.say(text::RECORDING_HOW));
    if let Some(file) = studio.shelf.file.clone() {
        let name = file_name(&file.name);
        let again = Sentence::new(
            format!("前の記録（{name}）で踊る"),
            format!("Dance {name} again"),
        );
        if wide_button(ui, &studio.tell(&again)) {
            dance::dance_recording(studio, file);
            return;
        }
    }
    if wide_button(ui, studio.say(text::OPEN_FIRST_RECORDING)) {
        studio.request(Request::AskRecording);
    }
    let how = RichText::new(studio.say(text::DROP_RECORDING));
    ui.label(how.small().weak());
}

/// The last part of a file's name.
fn file_name(name: &str) -> String {
    let last = Path::new(name).file_name();
    last.map_or_else(|| name.to_owned(), |last| last.to_string_lossy().into())
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
