//! What one dancer takes home: booklet, pattern, film and 3D file of the design as it stands, made one
//! after the other on a thread of its own.

pub(crate) mod dance;
pub(crate) mod paper;

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use lole_costume::document::Design;
use lole_costume::roster::Roster;
use lole_export::cutting::{PATTERN_JSON, left_behind};
use lole_export::pdf::Paper;
use lole_language::{Language, Sentence, Words, words};
use lole_stage::Formation;

use crate::paper::Cutting;
use crate::platform;

/// What can be made of a design.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Product {
    /// How it is sewn, with drawings, materials and cost, as PDF.
    Booklet,
    /// Everything it is cut by: PDF, SVG, DXF, in a folder.
    Pattern,
    /// The dance, as MP4.
    Film,
    /// The dancer with her dance, for 3D programs, as GLB.
    Model,
    /// Everybody of the list in one dance, as MP4.
    GroupFilm,
}

impl Product {
    /// Those of one dancer, as they stand in the panel.
    pub(crate) const ALL: [Self; 4] = [Self::Booklet, Self::Pattern, Self::Film, Self::Model];

    /// What it is called.
    pub(crate) const fn name(self) -> Words {
        match self {
            Self::Booklet => words("縫い方の本（PDF）", "Sewing booklet (PDF)"),
            Self::Pattern => words("型紙一式（PDF・SVG・DXF）", "Patterns (PDF, SVG, DXF)"),
            Self::Film => words("踊りの動画（MP4）", "Film of the dance (MP4)"),
            Self::Model => words("3D ファイル（GLB）", "3D file (GLB)"),
            Self::GroupFilm => words("みんなで踊る動画（MP4）", "Film of everybody (MP4)"),
        }
    }

    /// What it is for, and how long it takes.
    pub(crate) const fn about(self) -> Words {
        match self {
            Self::Booklet => words(
                "材料、裁ち方、図入りの手順、費用。印刷して使います。1 分ほど。",
                "Materials, cutting, steps with drawings, cost; to be printed. About a minute.",
            ),
            Self::Pattern => words(
                "裁ち方図と原寸の型紙をフォルダーに書きます。すぐできます。",
                "Cut plan and pieces at full size, in a folder. Done at once.",
            ),
            Self::Film => words(
                "踊り全体を録画します。数分かかります。",
                "The whole dance; takes some minutes.",
            ),
            Self::Model => words(
                "Blender などで開けます。数分かかります。",
                "Opens in Blender and the like; takes some minutes.",
            ),
            Self::GroupFilm => words(
                "名簿の全員が、それぞれの寸法と衣装で一緒に踊ります。一人につき数分かかります。",
                "Everybody of the list dances, in her own measures and costume; takes some minutes for each.",
            ),
        }
    }

    /// Name of its file or folder until somebody gives it another.
    pub(crate) const fn usual_name(self) -> Words {
        match self {
            Self::Booklet => words("縫い方.pdf", "booklet.pdf"),
            Self::Pattern => words("型紙", "pattern"),
            Self::Film => words("踊り.mp4", "dance.mp4"),
            Self::Model => words("踊り手.glb", "dancer.glb"),
            Self::GroupFilm => words("みんな.mp4", "group.mp4"),
        }
    }

    /// How the name of its file ends; a folder has no ending.
    pub(crate) const fn ending(self) -> Option<&'static str> {
        match self {
            Self::Booklet => Some("pdf"),
            Self::Pattern => None,
            Self::Film | Self::GroupFilm => Some("mp4"),
            Self::Model => Some("glb"),
        }
    }
}

/// How far a product has come.
#[derive(Debug, Clone, PartialEq)]
pub enum Stage {
    /// Others are made before it.
    Waiting,
    /// This share of it is done, from 0 to 1.
    Working(f32),
    /// It was called off while it was being made, and ends as soon as it can.
    Stopping,
    /// It lies at its place.
    Done,
    /// Why it was not made.
    Failed(Sentence),
    /// It was called off; nothing is left of it.
    CalledOff,
}

impl Stage {
    /// Whether nothing more happens to it.
    pub(crate) const fn is_end(&self) -> bool {
        !matches!(self, Self::Waiting | Self::Working(_) | Self::Stopping)
    }
}

/// One product that was asked for.
#[derive(Debug, Clone, PartialEq)]
pub struct Piece {
    /// No two of a window share one.
    pub number: u64,
    /// What it is.
    pub product: Product,
    /// Where it is written.
    pub path: PathBuf,
    /// How far it has come.
    pub stage: Stage,
}

/// Everything behind the panel of products.
#[derive(Debug, Clone, Default)]
pub struct MakingDesk {
    /// What was asked for, in its order.
    pub pieces: Vec<Piece>,
}

impl MakingDesk {
    /// Takes in what was told of a piece; the piece itself where that was its end.
    pub(crate) fn note(&mut self, number: u64, stage: Stage) -> Option<&Piece> {
        let piece = self
            .pieces
            .iter_mut()
            .find(|piece| piece.number == number)?;
        // What the thread told before it heard that the piece is called off is no news.
        let is_called_off = matches!(piece.stage, Stage::Stopping | Stage::CalledOff);
        if is_called_off && !stage.is_end() {
            return None;
        }
        piece.stage = stage;
        piece.stage.is_end().then_some(piece)
    }

    /// Shows at once that a piece is called off: one that waits will never be begun.
    pub(crate) fn call_off(&mut self, number: u64) {
        for piece in &mut self.pieces {
            if piece.number == number {
                piece.stage = match piece.stage {
                    Stage::Waiting => Stage::CalledOff,
                    Stage::Working(_) => Stage::Stopping,
                    _ => continue,
                };
            }
        }
    }

    /// This desk for another window: the thread that made the pieces went with the window before.
    pub(crate) fn anew(mut self) -> Self {
        for piece in &mut self.pieces {
            if !piece.stage.is_end() {
                piece.stage = Stage::CalledOff;
            }
        }
        self
    }

    /// The highest number that was given to a piece.
    pub(crate) fn last_number(&self) -> u64 {
        let numbers = self.pieces.iter().map(|piece| piece.number);
        numbers.max().unwrap_or(0)
    }

    /// Where something is about to be written.
    pub(crate) fn places(&self) -> Vec<PathBuf> {
        let unfinished = self.pieces.iter().filter(|piece| !piece.stage.is_end());
        unfinished.map(|piece| piece.path.clone()).collect()
    }

    /// Forgets a piece that nothing more happens to.
    pub(crate) fn forget(&mut self, number: u64) {
        (self.pieces).retain(|piece| piece.number != number || !piece.stage.is_end());
    }
}

/// What is to be made, with the design as it was when it was asked for.
#[derive(Debug, Clone)]
pub(crate) struct Wish {
    pub(crate) product: Product,
    pub(crate) design: Design,
    pub(crate) path: PathBuf,
    pub(crate) paper: Paper,
    pub(crate) cutting: Cutting,
    pub(crate) language: Language,
    /// What the costume is called.
    pub(crate) title: String,
    /// Who dances where it is of everybody, and how they stand.
    pub(crate) group: Option<(Arc<Roster>, Formation)>,
}

/// Why a product was not made.
#[derive(Debug)]
pub(crate) enum Unmade {
    CalledOff,
    Failed(Sentence),
}

impl Unmade {
    /// Of an error that has no words of its own in both languages.
    pub(crate) fn of(error: &dyn std::fmt::Display) -> Self {
        let text = error.to_string();
        Self::Failed(Sentence::new(format!("作れません（{text}）"), text))
    }
}

/// The cloth flew apart at this time of the dance [s], or where no dance is danced.
pub(crate) fn flew_apart(time: Option<f32>) -> Sentence {
    match time {
        Some(time) if 0.0 <= time => Sentence::new(
            format!("踊りの {time:.2} 秒で布が飛び散ったので、書けませんでした。"),
            format!("the cloth flew apart at {time:.2} s of the dance; nothing was written"),
        ),
        // Before the dance the clock is below 0.
        _ => Sentence::new(
            "踊りの前、布をなじませているあいだに布が飛び散ったので、書けませんでした。",
            "the cloth flew apart before the dance, while it settled; nothing was written",
        ),
    }
}

/// How a product that is being made stays in touch with the window.
pub(crate) struct Line<'a> {
    pub(crate) is_called_off: &'a AtomicBool,
    pub(crate) tell: &'a dyn Fn(f32),
}

impl Line<'_> {
    pub(crate) fn is_called_off(&self) -> bool {
        self.is_called_off.load(Ordering::Relaxed)
    }

    /// Goes on, or does not, with this share done.
    pub(crate) fn goes_on(&self, share: f32) -> Result<(), Unmade> {
        (self.tell)(share);
        if self.is_called_off() {
            return Err(Unmade::CalledOff);
        }
        Ok(())
    }
}

/// What is said of a product whose maker is gone.
pub(crate) fn stopped_unexpectedly() -> Sentence {
    Sentence::new(
        "途中で止まってしまい、できませんでした。もう一度お試しください。",
        "It stopped unexpectedly and was not made; please try again.",
    )
}

/// Makes it and writes it, whole or not at all.
pub(crate) fn make(wish: &Wish, line: &Line<'_>) -> Result<(), Unmade> {
    line.goes_on(0.0)?;
    let one = |bytes: Vec<u8>| -> Result<(), Unmade> {
        // The last moment to call it off.
        line.goes_on(1.0)?;
        lole_files::write_whole(&wish.path, &bytes).map_err(Unmade::Failed)
    };
    match wish.product {
        Product::Booklet => one(paper::booklet(wish, line)?),
        Product::Pattern => fill(&wish.path, &paper::pattern(wish, line)?).map_err(Unmade::Failed),
        Product::Film => one(platform::film(wish, line)?),
        Product::GroupFilm => one(platform::group_film(wish, line)?),
        Product::Model => one(dance::model(wish, line)?),
    }
}

/// Fills a folder of patterns; sheets of the costume before, which would be taken for this one's, go.
fn fill(folder: &Path, files: &[(String, Vec<u8>)]) -> Result<(), Sentence> {
    let earlier = std::fs::read(folder.join(PATTERN_JSON)).unwrap_or_default();
    lole_files::write_folder(folder, files)?;
    for name in left_behind(&earlier, files) {
        // An old sheet that stays does no harm to the new ones.
        drop(std::fs::remove_file(folder.join(name)));
    }
    Ok(())
}

/// A path that says what it is of: nothing opens a file whose name does not end as its kind does.
pub(crate) fn with_ending(path: &Path, ending: &str) -> PathBuf {
    let has_it = path
        .extension()
        .is_some_and(|known| known.eq_ignore_ascii_case(ending));
    if has_it {
        return path.to_owned();
    }
    let mut name = path.as_os_str().to_owned();
    name.push(".");
    name.push(ending);
    PathBuf::from(name)
}
