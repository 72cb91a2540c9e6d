//! The table of templates: one file and one row for each garment that can be drafted from measures
//! and options.
//!
//! The options of a template are rows too. The document's keys, the forms of the window and the
//! messages all read them, so that an option is written once.

mod accessory;
mod block;
mod blouse;
mod cellophane_skirt;
mod chosen;
mod fitted;
mod hair_flower;
mod holoku;
mod ipu;
mod kihei;
mod kikepa;
mod kupee;
mod lei;
mod lei_poo;
mod making;
mod malo;
mod muumuu;
mod pau_kahiko;
mod pau_ruffle;
mod pau_skirt;
mod pau_top;
mod puili;
mod raffia_skirt;
mod shape;
mod sleeve;
mod strands;
mod ti_leaf_skirt;
mod uliuli;
mod work;
mod yoke;

use lole_language::{Words, words};

use crate::design::pau_skirt::{PauDraft, PauMeasurements};
use crate::{DraftError, Measures, Pattern};

/// Mass of a meter of raffia [kg]. Estimated.
pub const RAFFIA_PER_METER: f64 = raffia_skirt::MASS_PER_METER;

/// A garment that can be drafted. Two are equal when their identifiers are.
#[derive(Debug)]
pub struct Template {
    /// Identifier without diacritics, as typed in a document.
    pub id: &'static str,
    /// What it is called.
    pub name: Words,
    /// What it is, in one sentence.
    pub about: Words,
    /// What the maker decides, in the order a form shows it.
    pub options: &'static [OptionRow],
    /// Drafts it.
    pub draft: fn(&Measures, &Options) -> Result<Pattern, DraftError>,
    /// How it is worn where it can be one gathered rectangle.
    worn: Option<Worn>,
}

/// A template that is one gathered rectangle and at most a ruffle on it.
#[derive(Debug)]
struct Worn {
    /// How many rectangles are carried, with these options: two where a ruffle hangs over the first.
    carried: fn(&Options) -> usize,
    /// The rectangle as it is worn.
    draft: fn(&Measures, &Options) -> Result<Gathered, DraftError>,
}

/// A template that is one rectangle, gathered around the hips.
#[derive(Debug, Clone, PartialEq)]
pub struct Gathered {
    /// The rectangle on paper.
    pub draft: PauDraft,
    /// What was measured for it, and where it is worn.
    pub worn: PauMeasurements,
    /// Whether its side stays open, as of what is tied.
    pub is_open: bool,
    /// What is gathered once more and sewn to it.
    pub ruffle: Option<WornRuffle>,
}

/// A ring of cloth that is gathered and sewn to a gathered rectangle.
#[derive(Debug, Clone, PartialEq)]
pub enum WornRuffle {
    /// It hangs from the rectangle's lower edge.
    Flounce(PauDraft),
    /// It hangs over the rectangle, from just below the lowest elastic.
    Layer {
        /// The ruffle on paper, its upper edge as a row that is carried.
        draft: PauDraft,
        /// Where that edge is worn.
        worn: PauMeasurements,
    },
}

impl Template {
    /// How many rectangles of it are gathered around the hips, one over the other, with these options;
    /// 0 where it is sewn otherwise.
    #[must_use]
    pub fn gathered_count(&self, options: &Options) -> usize {
        (self.worn.as_ref()).map_or(0, |worn| (worn.carried)(options))
    }

    /// Drafts it as what is gathered; `None` where it is not.
    ///
    /// # Errors
    /// As for [`Self::draft`].
    pub fn gathered(
        &self,
        measures: &Measures,
        options: &Options,
    ) -> Result<Option<Gathered>, DraftError> {
        let worn = self.worn.as_ref();
        worn.map(|worn| (worn.draft)(measures, options)).transpose()
    }
}

/// One thing the maker decides.
#[derive(Debug)]
pub struct OptionRow {
    /// Key in a document, ending in its unit where it has one: `hem_height_cm`.
    pub key: &'static str,
    /// What it means.
    pub about: Words,
    /// What it takes.
    pub kind: OptionKind,
}

/// What an option takes.
#[derive(Debug)]
pub enum OptionKind {
    /// A number, in the unit of its key.
    Number {
        /// Smallest accepted number.
        min: f64,
        /// Largest accepted number.
        max: f64,
        /// What it is when nothing is said; `None` when that follows from the measures.
        default: Option<f64>,
    },
    /// A whole number.
    Count {
        /// Smallest accepted number.
        min: u32,
        /// Largest accepted number.
        max: u32,
        /// What it is when nothing is said.
        default: u32,
    },
    /// One of several; the first when nothing is said.
    Choice(&'static [Choice]),
}

/// One of several ways.
#[derive(Debug)]
pub struct Choice {
    /// Identifier in a document.
    pub id: &'static str,
    /// What it is called.
    pub name: Words,
}

/// What was decided for one garment, one value for each option of its template.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    values: Vec<Option<f64>>,
}

impl PartialEq for Template {
    fn eq(&self, other: &Self) -> bool {
        self.id == other.id
    }
}

impl Eq for Template {}

impl Template {
    /// The template of this name.
    #[must_use]
    pub fn of_id(id: &str) -> Option<&'static Self> {
        TEMPLATES.iter().find(|template| template.id == id)
    }

    /// Where an option of this key stands among [`Template::options`].
    #[must_use]
    pub fn position(&self, key: &str) -> Option<usize> {
        self.options.iter().position(|row| row.key == key)
    }
}

impl Options {
    /// Everything as the template has it.
    #[must_use]
    pub fn of(template: &Template) -> Self {
        let default = |row: &OptionRow| match row.kind {
            OptionKind::Number { default, .. } => default,
            OptionKind::Count { default, .. } => Some(f64::from(default)),
            OptionKind::Choice(_) => Some(0.0),
        };
        Self {
            values: template.options.iter().map(default).collect(),
        }
    }

    /// The value of an option: a number in its key's unit, a count, or the index of a choice. `None`
    /// where it follows from the measures.
    #[must_use]
    pub fn get(&self, position: usize) -> Option<f64> {
        self.values.get(position).copied().flatten()
    }

    /// Decides an option; positions beyond the last one change nothing.
    pub fn set(&mut self, position: usize, value: Option<f64>) {
        if let Some(slot) = self.values.get_mut(position) {
            *slot = value;
        }
    }
}

/// Templates that stand together on a shelf.
#[derive(Debug)]
pub struct Shelf {
    /// What they are.
    pub name: Words,
    /// Their identifiers, in the order a menu shows them.
    pub ids: &'static [&'static str],
}

/// Templates of what is held in the hands and not worn.
pub const HELD: &[&str] = &["uliuli", "puili", "ipu"];

/// Every template by what it is for; a law keeps it whole.
pub const SHELVES: &[Shelf] = &[
    Shelf {
        name: words("スカート", "Skirts"),
        ids: &[
            "pau-skirt",
            "pau-ruffle",
            "pau-kahiko",
            "ti-leaf-skirt",
            "raffia-skirt",
            "cellophane-skirt",
        ],
    },
    Shelf {
        name: words("トップス", "Tops"),
        ids: &["pau-top", "blouse"],
    },
    Shelf {
        name: words("ドレス", "Dresses"),
        ids: &["muumuu", "holoku"],
    },
    Shelf {
        name: words("巻く布・掛ける布", "Wraps"),
        ids: &["kikepa", "kihei", "malo"],
    },
    Shelf {
        name: words("レイと飾り", "Lei and adornments"),
        ids: &["lei", "lei-poo", "kupee", "hair-flower"],
    },
    Shelf {
        name: words("楽器", "Implements"),
        ids: HELD,
    },
];

/// Every template, in the order a menu shows them.
pub const TEMPLATES: &[Template] = &[
    pau_skirt::TEMPLATE,
    pau_ruffle::TEMPLATE,
    pau_kahiko::TEMPLATE,
    pau_top::TEMPLATE,
    blouse::TEMPLATE,
    kikepa::TEMPLATE,
    kihei::TEMPLATE,
    malo::TEMPLATE,
    muumuu::TEMPLATE,
    holoku::TEMPLATE,
    ti_leaf_skirt::TEMPLATE,
    raffia_skirt::TEMPLATE,
    cellophane_skirt::TEMPLATE,
    lei::TEMPLATE,
    lei_poo::TEMPLATE,
    kupee::TEMPLATE,
    hair_flower::TEMPLATE,
    uliuli::TEMPLATE,
    puili::TEMPLATE,
    ipu::TEMPLATE,
];
