//! What the window shows and what was asked for: the state behind all panels.

use std::path::PathBuf;
use std::sync::Arc;

use lole_costume::document::schema::{self, Kind};
use lole_costume::document::{Design, FabricDesign};
use lole_language::{Bilingual as _, Language, Sentence, Words};
use lole_render::View;
use lole_stage::Divergence;

use crate::command::Watch;
use crate::history::History;
use crate::message::Message;
use crate::orbit::Orbit;
use crate::{Command, Snapshot};

/// Factors of the stiffness slider.
pub(crate) const STIFFNESSES: [f64; 2] = [0.1, 10.0];

/// What is drawn over the picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Shows {
    /// What the cloth meets.
    pub capsules: bool,
    /// The grid's structural springs.
    pub springs: bool,
    /// The cloth colored by its strain instead of its print.
    pub strain: bool,
    /// Cloth below the skin.
    pub sunken: bool,
    /// The bones.
    pub skeleton: bool,
}

/// What dragging on the cloth does; beside it, dragging always turns the view.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Tool {
    /// Holds the cloth.
    #[default]
    Hold,
    /// Turns the view.
    Turn,
}

/// What the program around the panels is asked for: it has files and dialogs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Request {
    /// Ask which design to open.
    AskOpen,
    /// Ask where to save.
    AskSave,
    /// Let the system's own dialog ask instead.
    Browse,
    /// Open this file.
    Open(PathBuf),
    /// Save there.
    Save(PathBuf),
    /// Write the picture to a file.
    Picture,
}

/// A question for a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Question {
    /// Whether a file is opened or saved.
    pub purpose: Purpose,
    /// What was typed.
    pub path: String,
}

/// What a file is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Purpose {
    /// To read a design.
    Open,
    /// To write the design.
    Save,
}

/// Everything behind the panels.
pub struct Studio {
    /// Language of every word.
    pub language: Language,
    /// What is wished.
    design: Design,
    /// The fabric as it was opened: the stiffness is a factor on it.
    base_fabric: FabricDesign,
    stiffness: f64,
    /// Whether a change waits until the hand leaves the slider.
    unsent: bool,
    /// The design as it was last opened or saved.
    saved: Design,
    /// Where it was.
    pub path: Option<PathBuf>,
    /// Whether it dances.
    pub plays: bool,
    /// Seconds of the dance in one second on the wall, as wished.
    pub speed: f64,
    /// What is drawn over the picture.
    pub shows: Shows,
    /// What dragging does.
    pub tool: Tool,
    /// The camera; `None` before the first picture.
    pub orbit: Option<Orbit>,
    /// A view that was asked for.
    pub wanted_view: Option<View>,
    /// The last seconds in numbers.
    pub history: History,
    /// The newest moment.
    pub snapshot: Option<Arc<Snapshot>>,
    /// Where and when the cloth flew apart.
    pub stopped: Option<Divergence>,
    /// Whether a skirt is being sewn.
    pub sews: bool,
    /// The sentence that is shown.
    pub message: Option<Message>,
    /// The question that is shown.
    pub question: Option<Question>,
    /// Pictures in the last second.
    pub pictures_per_second: Option<f64>,
    commands: Vec<Command>,
    requests: Vec<Request>,
}

impl Studio {
    /// The window of a design, before anything has been computed.
    #[must_use]
    pub fn new(language: Language, design: Design, path: Option<PathBuf>) -> Self {
        Self {
            language,
            base_fabric: design.fabric.clone(),
            saved: design.clone(),
            design,
            stiffness: 1.0,
            unsent: false,
            path,
            plays: true,
            speed: 1.0,
            shows: Shows::default(),
            tool: Tool::default(),
            orbit: None,
            wanted_view: Some(View::Front),
            history: History::default(),
            snapshot: None,
            stopped: None,
            sews: true,
            message: None,
            question: None,
            pictures_per_second: None,
            commands: Vec::new(),
            requests: Vec::new(),
        }
    }

    /// The same for another window: what was computed is gone, what was wished stays.
    #[must_use]
    pub fn anew(self) -> Self {
        Self {
            snapshot: None,
            stopped: None,
            history: History::default(),
            plays: true,
            speed: 1.0,
            shows: Shows::default(),
            sews: true,
            commands: Vec::new(),
            ..self
        }
    }

    /// The words in the window's language.
    #[must_use]
    pub const fn say(&self, words: Words) -> &'static str {
        words.text(self.language)
    }

    /// The sentence in the window's language.
    #[must_use]
    pub fn tell(&self, sentence: &Sentence) -> String {
        sentence.text(self.language)
    }

    /// What is wished.
    #[must_use]
    pub const fn design(&self) -> &Design {
        &self.design
    }

    /// Whether the design differs from its file.
    #[must_use]
    pub fn is_changed(&self) -> bool {
        self.design != self.saved
    }

    /// Sends a command to the simulation.
    pub fn command(&mut self, command: Command) {
        self.commands.push(command);
    }

    /// Asks the program for something.
    pub fn request(&mut self, request: Request) {
        self.requests.push(request);
    }

    /// The commands since the last time.
    pub fn take_commands(&mut self) -> Vec<Command> {
        std::mem::take(&mut self.commands)
    }

    /// The requests since the last time.
    pub fn take_requests(&mut self) -> Vec<Request> {
        std::mem::take(&mut self.requests)
    }

    /// Changes the design at once.
    pub fn change(&mut self, edit: impl FnOnce(&mut Design)) {
        self.change_later(edit);
        self.send_design();
    }

    /// Changes the design, to be sent when the hand leaves the slider: sewing takes a while.
    pub fn change_later(&mut self, edit: impl FnOnce(&mut Design)) {
        edit(&mut self.design);
        self.unsent = true;
    }

    /// Whether a change waits to be sent.
    #[must_use]
    pub const fn has_unsent(&self) -> bool {
        self.unsent
    }

    /// Sends the design, unless it is none.
    pub fn send_design(&mut self) {
        self.unsent = false;
        match self
            .design
            .check(self.language.pick("この窓", "this window"))
        {
            Ok(()) => self.command(Command::Wish(Box::new(self.design.clone()))),
            Err(error) => self.message = Some(Message::trouble(&error)),
        }
    }

    /// Factor on the fabric's stiffness.
    #[must_use]
    pub const fn stiffness(&self) -> f64 {
        self.stiffness
    }

    /// Makes the fabric as many times as stiff as it was opened: in stretch, shear and bending.
    pub fn set_stiffness(&mut self, factor: f64) {
        self.stiffness = factor.clamp(STIFFNESSES[0], STIFFNESSES[1]);
        let fabric = stiffened(&self.base_fabric, self.stiffness);
        self.change(|design| {
            let drag = design.fabric.drag_per_s;
            design.fabric = FabricDesign {
                drag_per_s: drag,
                ..fabric
            };
        });
    }

    /// Shows another design: it was opened, or a wish could not be granted.
    pub fn adopt(&mut self, design: Design) {
        self.base_fabric = design.fabric.clone();
        self.stiffness = 1.0;
        self.unsent = false;
        self.design = design;
    }

    /// Goes on with a design from a file.
    pub fn opened(&mut self, design: Design, path: Option<PathBuf>) {
        self.adopt(design.clone());
        self.saved = design;
        self.path = path;
        self.send_design();
    }

    /// Notes that the design is safe in a file.
    pub fn saved_at(&mut self, path: PathBuf) {
        self.saved = self.design.clone();
        self.path = Some(path);
    }

    /// Goes back to the design that is on stage, because a wish was refused.
    pub fn refused(&mut self, sentence: Sentence, kept: Design) {
        self.sews = false;
        self.message = Some(Message::trouble(&sentence));
        if kept != self.design {
            let same_fabric = kept.fabric == self.design.fabric;
            let (base, stiffness) = (self.base_fabric.clone(), self.stiffness);
            self.adopt(kept);
            if same_fabric {
                (self.base_fabric, self.stiffness) = (base, stiffness);
            }
        }
    }

    /// Takes in a new moment of the show.
    pub fn receive(&mut self, snapshot: Arc<Snapshot>) {
        for sample in &snapshot.samples {
            self.history.push(*sample);
        }
        self.stopped = snapshot.stopped;
        self.snapshot = Some(snapshot);
    }

    /// Dances on or stands still.
    pub fn toggle_playing(&mut self) {
        self.plays = !self.plays;
        self.command(if self.plays {
            Command::Play
        } else {
            Command::Pause
        });
    }

    /// One frame, then still.
    pub fn step(&mut self) {
        self.plays = false;
        self.command(Command::Step);
    }

    /// From the beginning.
    pub fn reset(&mut self) {
        self.plays = true;
        self.command(Command::Reset);
        self.command(Command::Play);
    }

    /// Changes what is drawn over the picture.
    pub fn set_shows(&mut self, shows: Shows) {
        if shows != self.shows {
            self.shows = shows;
            self.command(Command::Watch(Watch {
                strain: shows.strain,
                sunken: shows.sunken,
            }));
        }
    }
}

/// A fabric whose every stiffness is multiplied, within what the document takes.
fn stiffened(base: &FabricDesign, factor: f64) -> FabricDesign {
    #[expect(clippy::float_cmp, reason = "the slider's middle is exactly 1")]
    if factor == 1.0 {
        return base.clone();
    }
    let preset = base.preset;
    let times = |name: &str, value: f64| {
        let scaled = value * factor;
        let (low, high) = range("fabric", name);
        Some(scaled.clamp(low, high))
    };
    let [stretch_warp, stretch_weft] = preset.stretch.value;
    let [bend_warp, bend_weft] = preset.bend.value;
    let twist = base.twist_un_m;
    FabricDesign {
        stretch_warp_n_per_m: times(
            "stretch_warp_n_per_m",
            base.stretch_warp_n_per_m.unwrap_or(stretch_warp),
        ),
        stretch_weft_n_per_m: times(
            "stretch_weft_n_per_m",
            base.stretch_weft_n_per_m.unwrap_or(stretch_weft),
        ),
        shear_n_per_m: times(
            "shear_n_per_m",
            base.shear_n_per_m.unwrap_or(preset.shear.value),
        ),
        bend_warp_un_m: times("bend_warp_un_m", base.bend_warp_un_m.unwrap_or(bend_warp)),
        bend_weft_un_m: times("bend_weft_un_m", base.bend_weft_un_m.unwrap_or(bend_weft)),
        // Left out, it follows the bending.
        twist_un_m: twist.and_then(|twist| times("twist_un_m", twist)),
        ..base.clone()
    }
}

/// Smallest and largest number that a key of the document takes.
pub(crate) fn range(table: &str, name: &str) -> (f64, f64) {
    #[expect(clippy::cast_precision_loss, reason = "counts of a slider are small")]
    match schema::key(table, name).map(|key| &key.kind) {
        Some(Kind::Number { min, max, .. }) => (*min, *max),
        Some(Kind::Count { min, max, .. }) => (*min as f64, *max as f64),
        _ => (f64::MIN, f64::MAX),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn studio() -> Studio {
        Studio::new(Language::English, Design::default(), None)
    }

    #[test]
    fn twice_the_stiffness_is_twice_every_modulus_and_once_is_the_document_as_it_was() {
        let mut studio = studio();
        let before = studio.design().fabric.fabric();
        studio.set_stiffness(2.0);
        let after = studio.design().fabric.fabric();
        let close = |a: f32, b: f32| (a - 2.0 * b).abs() < 1e-5 * a.abs();
        assert!(close(after.stretch[0], before.stretch[0]));
        assert!(close(after.stretch[1], before.stretch[1]));
        assert!(close(after.shear, before.shear) && close(after.twist, before.twist));
        assert!(close(after.bend[0], before.bend[0]) && close(after.bend[1], before.bend[1]));
        assert!(matches!(studio.take_commands()[..], [Command::Wish(_)]));
        studio.set_stiffness(1.0);
        assert!(!studio.is_changed());
    }

    #[test]
    fn a_design_that_is_none_is_not_sent_but_explained() {
        let mut studio = studio();
        studio.change(|design| design.motion.tempo_bpm = 1e9);
        assert!(studio.take_commands().is_empty());
        let message = studio.message.unwrap();
        assert!(
            message.sentence.english.contains("tempo_bpm"),
            "{message:?}"
        );
    }

    #[test]
    fn a_refused_wish_leaves_the_sliders_where_the_show_is() {
        let mut studio = studio();
        studio.change(|design| design.skirt.gather_ratio = 1.0);
        let sentence = Sentence::new("だめ", "no");
        studio.refused(sentence, Design::default());
        assert_eq!(*studio.design(), Design::default());
        assert!(studio.message.is_some() && !studio.sews);
    }

    #[test]
    fn what_the_sliders_cover_is_what_the_document_takes() {
        for (table, key) in [
            ("motion", "tempo_bpm"),
            ("skirt", "gather_ratio"),
            ("skirt", "hem_height_cm"),
            ("wind", "speed_m_per_s"),
            ("fabric", "drag_per_s"),
        ] {
            let (low, high) = range(table, key);
            assert!(f64::MIN < low && high < 1e7, "{table}.{key}");
        }
    }
}
