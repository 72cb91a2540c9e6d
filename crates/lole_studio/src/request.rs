//! What the panels ask of the program around them, and the question for a file.

use std::path::PathBuf;
use std::sync::Arc;

use lole_language::Sentence;

use crate::chooser::Listing;
use crate::making::Product;

/// What the program around the panels is asked for: it has files and dialogs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Request {
    /// Ask which design to open.
    AskOpen,
    /// Ask which recording to dance.
    AskRecording,
    /// Ask where to save.
    AskSave,
    /// Let the system's own dialog ask instead.
    Browse,
    /// Look into this folder for the question that is shown.
    ListFolder(PathBuf),
    /// Open this file.
    Open(PathBuf),
    /// Save there.
    Save(PathBuf),
    /// Dance this recording.
    OpenRecording(PathBuf),
    /// Ask which picture is printed on a garment of the list, from 0; `None` is the skirt.
    AskPicture(Option<usize>),
    /// Print it.
    OpenPicture(Option<usize>, PathBuf),
    /// Ask for the list of a group's dancers.
    AskRoster,
    /// Read it.
    OpenRoster(PathBuf),
    /// Work out what the group needs.
    WorkOutOrder,
    /// Ask where the order is to be written.
    AskOrderFolder,
    /// Write it there.
    MakeOrder(PathBuf),
    /// Stop working on it.
    CallOffOrder,
    /// Go on with the work that was found.
    Resume,
    /// Throw it away.
    Discard,
    /// Keep the picture as it is now and ask where to write it.
    Picture,
    /// Write the picture that was kept there.
    SavePicture(PathBuf),
    /// Ask where a product of the design is to be written.
    AskMake(Product),
    /// Make it there.
    Make(Product, PathBuf),
    /// Make no more of the product of this number.
    CallOff(u64),
    /// Show this file's folder with the system's own program.
    Reveal(PathBuf),
}

/// A question for a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Question {
    /// Whether a file is opened or saved.
    pub purpose: Purpose,
    /// What was typed.
    pub path: String,
    /// The folder that is looked into, once it was read.
    pub listing: Option<Arc<Listing>>,
    /// What is to be said of it.
    pub note: Option<Sentence>,
}

impl Question {
    /// A question before anything was read or said.
    #[must_use]
    pub fn new(purpose: Purpose, path: impl Into<String>) -> Self {
        Self {
            purpose,
            path: path.into(),
            listing: None,
            note: None,
        }
    }
}

/// What a file is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Purpose {
    /// To read a design.
    Open,
    /// To write the design.
    Save,
    /// To dance a recording.
    Record,
    /// To print a picture on a garment of the list, from 0; `None` is the skirt.
    Print(Option<usize>),
    /// To read a list of dancers.
    Roster,
    /// To write an order.
    Order,
    /// To write something that is made of the design.
    Make(Product),
    /// To write the picture.
    Picture,
}

impl Purpose {
    /// Whether a folder is asked for.
    #[must_use]
    pub const fn is_folder(self) -> bool {
        matches!(self, Self::Order | Self::Make(Product::Pattern))
    }

    /// Whether something is written there.
    #[must_use]
    pub const fn writes(self) -> bool {
        matches!(
            self,
            Self::Save | Self::Order | Self::Make(_) | Self::Picture
        )
    }

    /// How names of files that are asked for end.
    pub(crate) const fn endings(self) -> &'static [&'static str] {
        match self {
            Self::Open => &["lole", "png", "jpg", "jpeg", "svg"],
            Self::Save => &["lole"],
            Self::Record => &["bvh", "vrma", "glb", "gltf", "vrm"],
            Self::Print(_) => &["png", "jpg", "jpeg", "svg"],
            Self::Roster => &["csv", "tsv", "txt"],
            Self::Order | Self::Make(Product::Pattern) => &[],
            Self::Make(Product::Booklet) => &["pdf"],
            Self::Make(Product::Film) => &["mp4"],
            Self::Make(Product::Model) => &["glb"],
            Self::Picture => &["png"],
        }
    }
}
