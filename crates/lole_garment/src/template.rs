//! What a garment is: one file under `garment/` and one row of [`TEMPLATES`].
//!
//! The row says everything: how it is drafted, how it is worn, on which shelf it stands, in what colors it is
//! made, how it is sketched. Its options are rows too. The document's keys, the forms of the window and the
//! messages all read them, so that an option is written once.

use std::num::NonZeroU32;

use lole_language::{Words, words};
use lole_pattern::design::pau_skirt::{PauDraft, PauMeasurements};
use lole_pattern::{DraftError, Pattern};

use crate::adorn::Make;
use crate::dress::Way;
use crate::fitting::Fitting;
use crate::garment;
pub use crate::garment::pau_skirt::TEMPLATE as PAU_SKIRT;
pub use crate::garment::pau_top::TEMPLATE as PAU_TOP;
use crate::sketch::Sketch;

/// Mass of a meter of raffia [kg]. Estimated.
pub const RAFFIA_PER_METER: f64 = garment::raffia_skirt::MASS_PER_METER;

/// A garment. Two are equal when their identifiers are.
#[derive(Debug)]
pub struct Template {
    /// Identifier without diacritics, as typed in a document.
    pub id: &'static str,
    /// What it is called.
    pub name: Words,
    /// What it is, in one sentence.
    pub about: Words,
    /// Where it stands in a menu.
    pub shelf: Shelf,
    /// What the maker decides, in the order a form shows it.
    pub options: &'static [OptionRow],
    /// Drafts it.
    pub draft: fn(&Fitting<'_>, &Options) -> Result<Pattern, DraftError>,
    /// How it is worn.
    pub worn: Wear,
    /// Opening of an elbow whose hand would press it on the chest, or go through it [°]: gathers are 2 to
    /// 3 cm thick, the folds of a wrap more; 0 for what lies elsewhere.
    pub chest_room_deg: f32,
    /// Colors of ground, flower, leaf and shadow, as `0xRRGGBB`, of what is made of leaves, flowers, feathers
    /// and wood: what each of them means is said where it is drawn. `None` of what is cut from cloth.
    pub natural: Option<[u32; 4]>,
    /// Draws it flat, as a maker sketches it from the front.
    pub sketch: fn(&mut Sketch),
}

/// How a garment is worn.
#[derive(Debug)]
pub enum Wear {
    /// As rectangles that are gathered around the trunk.
    Gathered(GatheredRow),
    /// Its pieces are laid around her and sewn there.
    Sewn(SewnRow),
    /// Beside the cloth, or in her hands.
    Beside(BesideRow),
}

/// A garment that is one gathered rectangle and at most a ruffle on it.
#[derive(Debug)]
pub struct GatheredRow {
    /// How many rectangles are carried, with these options: two where a ruffle hangs over the first.
    pub count: fn(&Options) -> usize,
    /// The rectangle as it is worn.
    pub draft: fn(&Fitting<'_>, &Options) -> Result<Gathered, DraftError>,
    /// How finely it is sewn unless something else is decided.
    pub fineness: Fineness,
    /// How it is made where it is the second of its kind; `None` where one more is made like the first.
    pub second: Option<Second>,
}

/// How finely a gathered rectangle is sewn, and by what chance.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Fineness {
    /// Particles around.
    pub column_count: u32,
    /// Particles from top fold to hem.
    pub row_count: u32,
    /// Chance for how unevenly the gathers are pushed together.
    pub seed: u64,
}

impl Fineness {
    /// As the pāʻū skirt is sewn.
    pub const OF_SKIRT: Self = Self {
        column_count: 512,
        row_count: 55,
        seed: 1,
    };
}

/// How a skirt is made that is worn with another one like it.
#[derive(Debug)]
pub struct Second {
    /// What is decided otherwise than for one that is worn alone, by the keys of its options.
    pub options: &'static [(&'static str, f64)],
    /// How finely it is sewn.
    pub fineness: Fineness,
    /// What it is called under the other one, and over it.
    pub called: [Called; 2],
}

/// What something is called.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Called {
    /// In files.
    pub id: &'static str,
    /// By people.
    pub name: Words,
}

/// Where a garment is worn that is worn with a skirt.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GarmentLayer {
    /// Between the skin and the skirt.
    Under,
    /// Outside the skirt.
    Over,
}

/// Where a gathered rectangle is carried.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WornPlace {
    /// On the hips: the band ends below the bust.
    Hips,
    /// Around the bust, up to the arms.
    Bust,
    /// Stitched onto the skirt inside of it, below that one's band.
    Skirt,
}

/// A garment whose pieces are laid around the dancer and sewn there.
#[derive(Debug)]
pub struct SewnRow {
    /// How its pieces lie.
    pub way: Way,
    /// Particles it is divided into, about.
    pub particle_count: f64,
    /// Substeps of a frame while it is worn, as usual and at most where it is strained: with few of them all
    /// of it gives like knitwear.
    pub substep_counts: [NonZeroU32; 2],
}

/// A garment that is worn beside the cloth, or held.
#[derive(Debug)]
pub struct BesideRow {
    /// Makes its shapes, its strands and the hands that hold it.
    pub make: Make,
    /// Whether the flower of the dancer's hair gives way to it, with these options.
    pub replaces_flower: fn(&Options) -> bool,
}

/// Substeps of what is sewn or tied to lie loosely.
pub const MANY_SUBSTEPS: [NonZeroU32; 2] = [
    NonZeroU32::MIN.saturating_add(47),
    NonZeroU32::MIN.saturating_add(95),
];
/// Substeps of what is wound tightly.
pub const FEW_SUBSTEPS: [NonZeroU32; 2] = [NonZeroU32::MIN.saturating_add(23); 2];

/// A template that is one rectangle, gathered around the hips.
#[derive(Debug, Clone, PartialEq)]
pub struct Gathered {
    /// The rectangle on paper.
    pub draft: PauDraft,
    /// What was measured for it, and where it is worn.
    pub worn: PauMeasurements,
    /// Where it is carried.
    pub place: WornPlace,
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
        match &self.worn {
            Wear::Gathered(row) => (row.count)(options),
            Wear::Sewn(_) | Wear::Beside(_) => 0,
        }
    }

    /// Drafts it as what is gathered; `None` where it is not.
    ///
    /// # Errors
    /// As for [`Self::draft`].
    pub fn gathered(
        &self,
        fitting: &Fitting<'_>,
        options: &Options,
    ) -> Result<Option<Gathered>, DraftError> {
        match &self.worn {
            Wear::Gathered(row) => (row.draft)(fitting, options).map(Some),
            Wear::Sewn(_) | Wear::Beside(_) => Ok(None),
        }
    }

    /// What it is called in a layer of a costume; outside of any, as of the skirt that the layers lie under
    /// and over, by its own name.
    #[must_use]
    pub const fn name_in(&self, layer: Option<GarmentLayer>) -> Words {
        match self.called_in(layer) {
            Some(called) => called.name,
            None => self.name,
        }
    }

    /// What it is called in files, in a layer of a costume.
    #[must_use]
    pub fn file_name_in(&self, layer: Option<GarmentLayer>) -> String {
        let called = self.called_in(layer);
        called.map_or_else(|| self.id.replace('-', "_"), |called| called.id.to_owned())
    }

    const fn called_in(&self, layer: Option<GarmentLayer>) -> Option<Called> {
        let Some(second) = self.second() else {
            return None;
        };
        let [under, over] = second.called;
        match layer {
            None => None,
            Some(GarmentLayer::Under) => Some(under),
            Some(GarmentLayer::Over) => Some(over),
        }
    }

    /// How finely it is sewn unless something else is decided; as the skirt where it is not gathered.
    #[must_use]
    pub const fn fineness(&self) -> Fineness {
        match &self.worn {
            Wear::Gathered(row) => row.fineness,
            Wear::Sewn(_) | Wear::Beside(_) => Fineness::OF_SKIRT,
        }
    }

    /// How it is made where it is the second of its kind, if otherwise than the first.
    #[must_use]
    pub const fn second(&self) -> Option<&Second> {
        match &self.worn {
            Wear::Gathered(row) => row.second.as_ref(),
            Wear::Sewn(_) | Wear::Beside(_) => None,
        }
    }

    /// Whether its pieces are laid around the dancer and sewn there.
    #[must_use]
    pub const fn is_sewn(&self) -> bool {
        matches!(self.worn, Wear::Sewn(_))
    }

    /// Whether it is drafted from the bodice block of its dancer, and altered as that is.
    #[must_use]
    pub const fn is_fitted(&self) -> bool {
        matches!(
            self.worn,
            Wear::Sewn(SewnRow {
                way: Way::Fitted(_),
                ..
            })
        )
    }

    /// Whether it is worn beside the cloth, or held.
    #[must_use]
    pub const fn is_adornment(&self) -> bool {
        matches!(self.worn, Wear::Beside(_))
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
        let given = [&crate::given::TEMPLATE];
        let mut all = TEMPLATES.iter().chain(&given);
        all.find(|it| it.id == id).copied()
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

    /// Decides the options of these keys, each of which the template has.
    #[must_use]
    pub fn with(mut self, template: &Template, decided: &[(&str, f64)]) -> Self {
        for (key, value) in decided {
            let position = template.position(key);
            debug_assert!(position.is_some(), "{} has no option {key}", template.id);
            if let Some(position) = position {
                self.set(position, Some(*value));
            }
        }
        self
    }

    /// Decides an option; positions beyond the last one change nothing.
    pub fn set(&mut self, position: usize, value: Option<f64>) {
        if let Some(slot) = self.values.get_mut(position) {
            *slot = value;
        }
    }
}

/// What garments are for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shelf {
    /// From the hips down.
    Skirts,
    /// From the bust or the shoulders down to the hips.
    Tops,
    /// From the shoulders down.
    Dresses,
    /// One cloth, wrapped or hung about her.
    Wraps,
    /// Of flowers and leaves.
    Adornments,
    /// Held in the hands, and not worn.
    Implements,
}

impl Shelf {
    /// All of them, in the order a menu shows them.
    pub const ALL: [Self; 6] = [
        Self::Skirts,
        Self::Tops,
        Self::Dresses,
        Self::Wraps,
        Self::Adornments,
        Self::Implements,
    ];

    /// What stands on it.
    #[must_use]
    pub const fn name(self) -> Words {
        match self {
            Self::Skirts => words("スカート", "Skirts"),
            Self::Tops => words("トップス", "Tops"),
            Self::Dresses => words("ドレス", "Dresses"),
            Self::Wraps => words("巻く布・掛ける布", "Wraps"),
            Self::Adornments => words("レイと飾り", "Lei and adornments"),
            Self::Implements => words("楽器", "Implements"),
        }
    }

    /// Its garments, in the order a menu shows them.
    pub fn templates(self) -> impl Iterator<Item = &'static Template> {
        TEMPLATES.iter().copied().filter(move |it| it.shelf == self)
    }
}

/// Every template, in the order a menu shows them.
pub static TEMPLATES: &[&Template] = &[
    &garment::pau_skirt::TEMPLATE,
    &garment::pau_ruffle::TEMPLATE,
    &garment::pau_kahiko::TEMPLATE,
    &garment::pau_top::TEMPLATE,
    &garment::blouse::TEMPLATE,
    &garment::kikepa::TEMPLATE,
    &garment::kihei::TEMPLATE,
    &garment::malo::TEMPLATE,
    &garment::muumuu::TEMPLATE,
    &garment::holoku::TEMPLATE,
    &garment::ti_leaf_skirt::TEMPLATE,
    &garment::raffia_skirt::TEMPLATE,
    &garment::cellophane_skirt::TEMPLATE,
    &garment::lei::TEMPLATE,
    &garment::lei_poo::TEMPLATE,
    &garment::kupee::TEMPLATE,
    &garment::hair_flower::TEMPLATE,
    &garment::uliuli::TEMPLATE,
    &garment::puili::TEMPLATE,
    &garment::ipu::TEMPLATE,
];
