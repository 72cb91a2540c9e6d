//! What the window shows and what was asked for: the state behind all panels.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use lole_costume::document::schema::{self, Kind};
use lole_costume::document::{Design, DesignError, FabricDesign, LinkedFile, PartDesign, Problem};
use lole_costume::roster::RosterDancer;
use lole_language::{Bilingual as _, Language, Sentence, Words};
use lole_picture::Scenery;
use lole_render::View;
use lole_stage::Divergence;

use crate::command::Watch;
use crate::history::History;
use crate::making::MakingDesk;
use crate::memory::Memory;
use crate::message::Message;
use crate::orbit::Orbit;
use crate::ordering::OrderDesk;
use crate::panel::{ClipShelf, ClothTextures, PhotoDesk, SwatchForm};
use crate::paper::{Cutting, PaperDesign};
use crate::replay::Replay;
use crate::take::Take;
use crate::undo::Undo;
use crate::wished::Wished;
use crate::work::Work;
use crate::{Command, Snapshot};

pub(crate) use crate::request::{Purpose, Question, Request};

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

/// A design's file.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct OpenFile {
    /// Where it is; `None` for what was never saved.
    pub(crate) path: Option<PathBuf>,
    /// What it holds.
    pub(crate) saved: Design,
}

/// What keeps the design from being danced, and where.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Hindrance {
    /// Table and key, such as `[dancer] hip_cm`.
    pub place: String,
    /// What is wrong and what to do.
    pub sentence: Sentence,
}

impl Hindrance {
    fn of(error: &DesignError) -> Self {
        let problem: &Problem = &error.problem;
        Self {
            place: error.place.clone(),
            sentence: Sentence::of(problem),
        }
    }
}

/// Which panels the left column shows, in the order in which a costume is thought of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Tab {
    /// Who dances.
    #[default]
    Dancer,
    /// What is worn.
    Costume,
    /// Of which cloth.
    Cloth,
    /// What is danced, in which air.
    Dance,
    /// How it is cut, what it costs and what is printed.
    Cutting,
    /// A group's order.
    Order,
}

/// The pages of the dance.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DancePage {
    /// One step, over and over.
    Step,
    /// Steps one after the other.
    Choreography,
    /// What a dancer's motion was recorded as.
    Recording,
}

/// What was danced before something else was chosen, so that it comes back when it is chosen again.
#[derive(Debug, Clone, Default)]
pub struct DanceShelf {
    /// A choreography.
    pub parts: Vec<PartDesign>,
    /// A recording.
    pub file: Option<LinkedFile>,
}

/// Everything behind the panels.
pub struct Studio {
    /// Language of every word.
    pub language: Language,
    /// What is wished.
    wished: Wished,
    /// What was wished before.
    undo: Undo<Wished>,
    /// The files that were open in this window.
    files: Vec<OpenFile>,
    /// Whether a change waits until the hand leaves the slider.
    unsent: bool,
    /// Whether something changed since [`Studio::take_work`].
    is_unkept: bool,
    /// Why the design is not on its way to the stage.
    pub hindrance: Option<Hindrance>,
    /// Which panels the left column shows.
    pub tab: Tab,
    /// The page of the dance that is looked at; `None` is that of what is danced.
    pub dance_page: Option<DancePage>,
    /// Whether the door to what researchers look at is open.
    pub researches: bool,
    /// Whether a window that is too narrow for both shows the picture.
    pub watches: bool,
    /// What was danced before something else was chosen.
    pub shelf: DanceShelf,
    /// Work of a window that ended without saving, to be offered.
    pub found: Option<Work>,
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
    /// The moment that is shown.
    pub snapshot: Option<Arc<Snapshot>>,
    /// What was danced, to be seen again.
    pub take: Take,
    /// What is seen again; `None` while the show is seen.
    pub replay: Option<Replay>,
    /// What was danced before and is danced once more beside what is on stage.
    pub kept: Option<Arc<Take>>,
    /// From where to where it is seen over and over [s]; all of it where nothing was chosen.
    pub phrase: [Option<f32>; 2],
    /// Where and when the cloth flew apart.
    pub stopped: Option<Divergence>,
    /// Whether a skirt is being sewn.
    pub sews: bool,
    /// The sentence that is shown.
    pub message: Option<Message>,
    /// The question that is shown.
    pub question: Option<Question>,
    /// The question whose answer is among the requests.
    pub answered: Option<Question>,
    /// Pictures in the last second.
    pub pictures_per_second: Option<f64>,
    /// The newest draft on paper.
    pub paper: Option<Arc<PaperDesign>>,
    /// How cloth is laid to be cut.
    pub cutting: Cutting,
    /// Whether the shelf of garments is open.
    pub shelf_is_open: bool,
    /// Garment and plan of the paper that are shown large.
    pub enlarged: Option<(usize, usize)>,
    /// The test of one's own cloth.
    pub(crate) swatch: SwatchForm,
    /// The picture of the own cloth that is being marked.
    pub(crate) photo: PhotoDesk,
    /// The animations of the recording that is danced.
    pub(crate) clips: ClipShelf,
    /// Cloth on the cut plans.
    pub(crate) textures: ClothTextures,
    /// A group's order.
    pub order: OrderDesk,
    /// What is made of the design.
    pub making: MakingDesk,
    /// Whether the first page is shown.
    pub starts: bool,
    /// What the next window is to know.
    pub memory: Memory,
    commands: Vec<Command>,
    requests: Vec<Request>,
}

impl Studio {
    /// The window of a design, before anything has been computed.
    #[must_use]
    pub fn new(language: Language, design: Design, path: Option<PathBuf>) -> Self {
        Self {
            language,
            files: vec![OpenFile {
                path,
                saved: design.clone(),
            }],
            wished: Wished::new(design, 0),
            undo: Undo::default(),
            unsent: false,
            is_unkept: false,
            hindrance: None,
            tab: Tab::default(),
            dance_page: None,
            researches: false,
            watches: false,
            shelf: DanceShelf::default(),
            found: None,
            plays: true,
            speed: 1.0,
            shows: Shows::default(),
            tool: Tool::default(),
            orbit: None,
            wanted_view: Some(View::Front),
            history: History::default(),
            snapshot: None,
            take: Take::default(),
            replay: None,
            kept: None,
            phrase: [None; 2],
            stopped: None,
            sews: true,
            message: None,
            question: None,
            answered: None,
            pictures_per_second: None,
            paper: None,
            cutting: Cutting::default(),
            shelf_is_open: false,
            enlarged: None,
            swatch: SwatchForm::default(),
            photo: PhotoDesk::default(),
            clips: ClipShelf::default(),
            textures: ClothTextures::default(),
            order: OrderDesk::default(),
            making: MakingDesk::default(),
            starts: false,
            memory: Memory::default(),
            commands: Vec::new(),
            requests: Vec::new(),
        }
    }

    /// This studio for another window: what was computed is gone, what was wished stays.
    #[must_use]
    pub fn anew(mut self) -> Self {
        // The picture that it is about went with the window.
        let is_picture = |question: &mut Question| question.purpose == Purpose::Picture;
        self.question.take_if(is_picture);
        if let Some(question) = &self.question
            && question.listing.is_none()
        {
            let folder = question.folder.clone();
            self.requests.push(Request::ListFolder(folder));
        }
        Self {
            snapshot: None,
            take: Take::default(),
            replay: None,
            kept: None,
            phrase: [None; 2],
            stopped: None,
            history: History::default(),
            plays: true,
            speed: 1.0,
            shows: Shows::default(),
            sews: true,
            // Textures went with their adapter.
            photo: PhotoDesk::default(),
            textures: ClothTextures::default(),
            commands: Vec::new(),
            making: self.making.anew(),
            order: OrderDesk {
                progress: None,
                ..self.order
            },
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
        &self.wished.design
    }

    /// Where the design was opened or saved.
    #[must_use]
    pub fn path(&self) -> Option<&Path> {
        self.files[self.wished.file].path.as_deref()
    }

    /// Whether the design differs from its file.
    #[must_use]
    pub fn is_changed(&self) -> bool {
        self.wished.design != self.files[self.wished.file].saved
    }

    /// Sends a command to the simulation.
    pub fn command(&mut self, command: Command) {
        self.commands.push(command);
    }

    /// Asks the program for something.
    pub fn request(&mut self, request: Request) {
        self.requests.push(request);
    }

    /// Asks for the design to be saved: where it was, or wherever the answer is.
    pub fn request_saving(&mut self) {
        let known = self.path().map(|path| Request::Save(path.to_owned()));
        self.request(known.unwrap_or(Request::AskSave));
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

    /// What is around her in a moment: the lamps of a theater say what the part of the choreography says, or one
    /// before it.
    #[must_use]
    pub(crate) fn scenery(&self, snapshot: &Snapshot) -> Scenery {
        let usual = snapshot.wardrobe.looks.scenery;
        let danced = snapshot.part.map_or(0, |part| part.index + 1);
        let begun = self.design().motion.parts.iter().take(danced);
        let mood = begun.filter_map(|part| part.mood).next_back();
        Scenery {
            mood: mood.unwrap_or(usual.mood),
            ..usual
        }
    }

    /// Changes the design, to be sent when the hand leaves the slider: sewing takes a while.
    pub fn change_later(&mut self, edit: impl FnOnce(&mut Design)) {
        self.undo.begin(|| self.wished.clone());
        edit(&mut self.wished.design);
        self.unsent = true;
    }

    /// Notes that no hand is at work: what waited is sent, and the next change is another step to
    /// take back.
    pub fn rest(&mut self) {
        if self.unsent {
            self.send_design();
        }
        self.is_unkept |= self.undo.end();
    }

    /// Sends the design, or says what keeps it from being danced.
    fn send_design(&mut self) {
        self.unsent = false;
        match self.check() {
            Ok(()) => {
                self.hindrance = None;
                self.command(Command::Wish(Box::new(self.wished.design.clone())));
            }
            Err(error) => self.hindrance = Some(Hindrance::of(&error)),
        }
    }

    /// Whether the design can be danced and saved.
    ///
    /// # Errors
    /// The first thing that is wrong with it.
    pub fn check(&self) -> Result<(), DesignError> {
        let source = self.language.pick("この窓", "this window");
        self.wished.design.check(source)
    }

    /// Whether there is a step to take back.
    #[must_use]
    pub fn has_past(&self) -> bool {
        !self.undo.past().is_empty()
    }

    /// Whether a step was taken back.
    #[must_use]
    pub fn has_future(&self) -> bool {
        !self.undo.future().is_empty()
    }

    /// Takes the last step back.
    pub fn undo(&mut self) {
        if let Some(before) = self.undo.back(self.wished.clone()) {
            self.go_to(before);
        }
    }

    /// Does again what was taken back.
    pub fn redo(&mut self) {
        if let Some(after) = self.undo.forward(self.wished.clone()) {
            self.go_to(after);
        }
    }

    fn go_to(&mut self, wished: Wished) {
        self.wished = wished;
        self.is_unkept = true;
        self.send_design();
    }

    /// Factor on the fabric's stiffness.
    #[must_use]
    pub const fn stiffness(&self) -> f64 {
        self.wished.stiffness()
    }

    /// Makes the fabric as many times as stiff as it was chosen: in stretch, shear and bending.
    pub fn set_stiffness(&mut self, factor: f64) {
        self.undo.begin(|| self.wished.clone());
        self.wished.stiffen(factor);
        self.send_design();
    }

    /// Cuts the skirt from another fabric.
    pub fn choose_fabric(&mut self, fabric: FabricDesign) {
        self.undo.begin(|| self.wished.clone());
        self.wished.choose_fabric(fabric);
        self.send_design();
    }

    /// Goes on with a design from a file; what was there before can be taken back.
    pub fn opened(&mut self, design: Design, path: Option<PathBuf>) {
        self.undo.end();
        self.undo.begin(|| self.wished.clone());
        self.undo.end();
        self.files.push(OpenFile {
            path,
            saved: design.clone(),
        });
        self.shelf = DanceShelf::default();
        self.dance_page = None;
        self.starts = false;
        self.go_to(Wished::new(design, self.files.len() - 1));
    }

    /// Dresses a dancer of the group's list; whoever was dressed before is one step back.
    pub fn try_on(&mut self, dancer: &RosterDancer) {
        self.change(|design| *design = dancer.design(design));
        let name = &dancer.name;
        self.order.dressed = Some((name.clone(), self.design().dancer.clone()));
        self.message = Some(Message::news(
            format!("{name} さんの寸法で着せています。「元に戻す」で前の踊り手に戻ります。"),
            format!("Dressing {name}; Undo brings back the dancer before."),
        ));
    }

    /// Notes that the design is safe in a file.
    pub fn saved_at(&mut self, path: PathBuf) {
        let file = &mut self.files[self.wished.file];
        file.saved = self.wished.design.clone();
        file.path = Some(path);
        self.is_unkept = true;
    }

    /// Names recording and pictures as they are found from another place, without a step to take back.
    pub(crate) fn rename_linked(&mut self, name_from_there: impl Fn(&str) -> String) {
        let design = &mut self.wished.design;
        if let Some(file) = &mut design.motion.file {
            file.name = name_from_there(&file.name);
        }
        for file in design.prints_mut().filter_map(|print| print.file.as_mut()) {
            file.name = name_from_there(&file.name);
        }
    }

    /// Goes back to the design that is on stage, because a wish was refused.
    pub fn refused(&mut self, sentence: Sentence, kept: Design) {
        self.sews = false;
        self.message = Some(Message::trouble(&sentence));
        if kept == self.wished.design {
            return;
        }
        self.unsent = false;
        self.is_unkept = true;
        self.hindrance = None;
        let before = self.undo.forget(|before| before.design == kept);
        self.wished = before.unwrap_or_else(|| Wished::new(kept, self.wished.file));
    }

    /// The work to be kept from a crash, if it changed since the last time.
    pub fn take_work(&mut self) -> Option<Work> {
        std::mem::take(&mut self.is_unkept).then(|| self.work())
    }

    /// The whole work.
    pub(crate) fn work(&self) -> Work {
        Work {
            files: self.files.clone(),
            past: self.undo.past().iter().cloned().collect(),
            present: self.wished.clone(),
            future: self.undo.future().to_vec(),
        }
    }

    /// Goes on with work that was found; what was done meanwhile is one step back.
    pub fn resume(&mut self, mut work: Work) {
        let meanwhile = self.work();
        if meanwhile.is_unsaved() {
            let mut before = meanwhile.present;
            before.file += work.files.len();
            work.files.extend(meanwhile.files);
            work.past.push(before);
        }
        self.undo = Undo::of(work.past, work.future);
        self.files = work.files;
        self.starts = false;
        self.go_to(work.present);
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
    use crate::making::{Piece, Product, Stage};
    use crate::ordering::Progress;

    fn studio() -> Studio {
        Studio::new(Language::English, Design::default(), None)
    }

    #[test]
    fn a_design_that_is_none_is_not_sent_but_explained() {
        let mut studio = studio();
        studio.change(|design| design.motion.tempo_bpm = 1e9);
        assert!(studio.take_commands().is_empty());
        let hindrance = studio.hindrance.clone().unwrap();
        assert_eq!(hindrance.place, "[motion] tempo_bpm");
        assert!(hindrance.sentence.english.contains("out of range"));
        studio.undo();
        assert!(studio.hindrance.is_none());
    }

    #[test]
    fn a_refused_wish_leaves_the_sliders_where_the_show_is() {
        let mut studio = studio();
        studio.change(|design| design.skirt.gather_ratio = 1.0);
        let sentence = Sentence::new("だめ", "no");
        studio.refused(sentence, Design::default());
        assert_eq!(*studio.design(), Design::default());
        assert!(studio.message.is_some() && !studio.sews);
        assert!(!studio.has_past());
    }

    #[test]
    fn a_drag_is_one_step_back_and_sent_when_the_hand_rests() {
        let mut studio = studio();
        for height in [23.0, 26.0, 30.0] {
            studio.change_later(|design| design.skirt.hem_height_cm = height);
        }
        assert!(studio.take_commands().is_empty());
        studio.rest();
        assert!(matches!(studio.take_commands()[..], [Command::Wish(_)]));
        assert!(studio.take_work().is_some() && studio.take_work().is_none());
        studio.set_stiffness(3.0);
        studio.rest();
        studio.undo();
        #[expect(clippy::float_cmp, reason = "taken back to the bit")]
        let is_soft = studio.stiffness() == 1.0;
        assert!(is_soft);
        studio.undo();
        assert_eq!(*studio.design(), Design::default());
        assert!(!studio.has_past() && !studio.is_changed());
        studio.redo();
        assert_eq!(
            studio.design().skirt.hem_height_cm.to_bits(),
            30.0_f64.to_bits()
        );
    }

    #[test]
    fn work_that_is_resumed_keeps_what_was_done_meanwhile_one_step_back() {
        let mut left = studio();
        left.change(|design| design.skirt.hem_height_cm = 30.0);
        left.rest();
        let mut studio = studio();
        studio.change(|design| design.motion.tempo_bpm = 90.0);
        studio.rest();
        let meanwhile = studio.design().clone();
        studio.resume(left.work());
        assert_eq!(studio.design(), left.design());
        studio.undo();
        assert_eq!(*studio.design(), meanwhile);
        studio.undo();
        assert_eq!(*studio.design(), Design::default());
    }

    #[test]
    fn another_window_goes_on_with_the_cards_and_the_question_but_not_with_their_threads() {
        let mut studio = studio();
        let piece = |number, stage| Piece {
            number,
            product: Product::Film,
            path: PathBuf::from("hula.mp4"),
            stage,
        };
        studio.making.pieces = vec![
            piece(1, Stage::Done),
            piece(2, Stage::Working(0.4)),
            piece(3, Stage::Waiting),
        ];
        studio.order.progress = Some(Progress { done: 1, of: 9 });
        studio.question = Some(Question::new(Purpose::Picture, "silk/lole-1.png"));
        let mut studio = studio.anew();
        let stages = studio.making.pieces.iter().map(|piece| &piece.stage);
        let ends = [Stage::Done, Stage::CalledOff, Stage::CalledOff];
        assert_eq!(stages.collect::<Vec<_>>(), ends.iter().collect::<Vec<_>>());
        assert_eq!(studio.making.last_number(), 3);
        assert_eq!(studio.order.progress, None);
        // The picture went with the window.
        assert_eq!(studio.question, None);
        assert!(studio.take_requests().is_empty());
        studio.question = Some(Question::new(Purpose::Open, "silk/a.lole"));
        let mut studio = studio.anew();
        assert!(studio.question.is_some());
        let requests = studio.take_requests();
        assert_eq!(requests, [Request::ListFolder("silk".into())]);
    }

    #[test]
    fn another_file_is_a_step_that_can_be_taken_back_with_its_name() {
        let mut studio = studio();
        studio.change(|design| design.skirt.hem_height_cm = 30.0);
        studio.rest();
        let mut other = Design::default();
        other.motion.tempo_bpm = 100.0;
        studio.opened(other, Some(PathBuf::from("b.lole")));
        assert_eq!(studio.path(), Some(Path::new("b.lole")));
        assert!(!studio.is_changed());
        studio.undo();
        assert!(studio.path().is_none() && studio.is_changed());
        studio.redo();
        studio.saved_at(PathBuf::from("c.lole"));
        studio.undo();
        assert!(studio.path().is_none());
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
