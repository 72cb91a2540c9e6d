//! Garments that are worn with the skirt, in the units of the document.

use lole_garment::{Colors, GarmentSpec, Options, Template};
use lole_pattern::{DraftError, Measures, Pattern};
use lole_print::PrintMotif;

use super::schema::KINDS;
use super::{FabricDesign, PrintChoice, SkirtDesign};
use crate::fabrics::Preset;

/// A garment beside the skirt, by kind.
#[derive(Debug, Clone, PartialEq)]
pub enum GarmentDesign {
    /// A second pāʻū skirt.
    PauSkirt(WornSkirt),
    /// A pāʻū top.
    PauTop(WornTop),
    /// A garment of the table of templates: drafted, and danced where it can be put on.
    Template(WornTemplate),
}

impl GarmentDesign {
    /// A garment of this kind, as the program would make it; `None` where there is no such kind.
    #[must_use]
    pub fn of_kind(id: &str) -> Option<Self> {
        let danced = KINDS.iter().find(|kind| kind.id == id);
        danced.map(|kind| (kind.make)()).or_else(|| {
            let template = Template::of_id(id)?;
            Some(Self::Template(WornTemplate::new(template)))
        })
    }

    /// What it is.
    #[must_use]
    pub fn template(&self) -> &'static Template {
        match self {
            Self::PauSkirt(_) => &lole_garment::template::PAU_SKIRT,
            Self::PauTop(_) => &lole_garment::template::PAU_TOP,
            Self::Template(worn) => worn.template,
        }
    }

    /// Name of its kind in documents.
    #[must_use]
    pub fn kind_id(&self) -> &'static str {
        self.template().id
    }

    /// Whether it is sewn from its template and put on as it is, and danced.
    #[must_use]
    pub fn is_dressed(&self) -> bool {
        self.template().is_sewn()
    }

    /// Whether it is gathered rectangles, sewn in rows and columns and danced.
    #[must_use]
    pub fn is_danced(&self) -> bool {
        0 < self.gathered_count()
    }

    /// How many gathered rectangles it is, one over the other, each carried by the dancer.
    #[must_use]
    pub fn gathered_count(&self) -> usize {
        match self {
            Self::PauSkirt(_) | Self::PauTop(_) => 1,
            Self::Template(worn) => worn.template.gathered_count(&worn.options),
        }
    }

    /// Whether it is worn or held beside the cloth, and seen on the dancer: see [`lole_garment::adorn`].
    #[must_use]
    pub fn is_adornment(&self) -> bool {
        self.template().is_adornment()
    }

    /// Where it is worn.
    #[must_use]
    pub const fn layer(&self) -> GarmentLayer {
        match self {
            Self::PauSkirt(worn) => worn.layer,
            Self::PauTop(worn) => worn.layer,
            Self::Template(worn) => worn.layer,
        }
    }

    /// What it is cut from.
    #[must_use]
    pub const fn fabric(&self) -> &FabricDesign {
        match self {
            Self::PauSkirt(worn) => &worn.fabric,
            Self::PauTop(worn) => &worn.fabric,
            Self::Template(worn) => &worn.fabric,
        }
    }

    /// What is printed on it.
    #[must_use]
    pub const fn print(&self) -> &PrintChoice {
        match self {
            Self::PauSkirt(worn) => &worn.print,
            Self::PauTop(worn) => &worn.print,
            Self::Template(worn) => &worn.print,
        }
    }

    /// Where it is worn, to be changed.
    pub const fn layer_mut(&mut self) -> &mut GarmentLayer {
        match self {
            Self::PauSkirt(worn) => &mut worn.layer,
            Self::PauTop(worn) => &mut worn.layer,
            Self::Template(worn) => &mut worn.layer,
        }
    }

    /// Its fabric and print, to be changed.
    pub const fn cloth_mut(&mut self) -> (&mut FabricDesign, &mut PrintChoice) {
        match self {
            Self::PauSkirt(worn) => (&mut worn.fabric, &mut worn.print),
            Self::PauTop(worn) => (&mut worn.fabric, &mut worn.print),
            Self::Template(worn) => (&mut worn.fabric, &mut worn.print),
        }
    }
}

/// Where a garment is worn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GarmentLayer {
    /// Between the skin and the skirt.
    Under,
    /// Outside the skirt.
    Over,
}

/// A skirt that is worn with the other, such as the plain underskirt of a double pāʻū.
#[derive(Debug, Clone, PartialEq)]
pub struct WornSkirt {
    /// Where it is worn.
    pub layer: GarmentLayer,
    /// Its cut.
    pub skirt: SkirtDesign,
    /// What it is cut from.
    pub fabric: FabricDesign,
    /// What is printed on it.
    pub print: PrintChoice,
}

impl Default for WornSkirt {
    /// A plain underskirt with less cloth, whose hem shows below the skirt's.
    fn default() -> Self {
        Self {
            layer: GarmentLayer::Under,
            skirt: SkirtDesign {
                hem_height_cm: 14.0,
                gather_ratio: 2.5,
                column_count: 352,
                row_count: 44,
                seed: 2,
                ..SkirtDesign::default()
            },
            fabric: lawn(),
            print: plain("cream"),
        }
    }
}

/// A top that is worn with the skirt.
#[derive(Debug, Clone, PartialEq)]
pub struct WornTop {
    /// Where its lower edge is worn.
    pub layer: GarmentLayer,
    /// Its cut.
    pub top: TopDesign,
    /// What it is cut from.
    pub fabric: FabricDesign,
    /// What is printed on it.
    pub print: PrintChoice,
}

impl Default for WornTop {
    /// A plain top that ends above the skirt.
    fn default() -> Self {
        Self {
            layer: GarmentLayer::Over,
            top: TopDesign::default(),
            fabric: FabricDesign::default(),
            print: plain("red"),
        }
    }
}

/// A garment of the table of templates.
#[derive(Debug, Clone, PartialEq)]
pub struct WornTemplate {
    /// Where it is worn.
    pub layer: GarmentLayer,
    /// What it is drafted by.
    pub template: &'static Template,
    /// What was decided, one value for each option of the template.
    pub options: Options,
    /// What it is cut from.
    pub fabric: FabricDesign,
    /// What is printed on it.
    pub print: PrintChoice,
}

impl WornTemplate {
    /// The garment as its template has it, in one color over the skirt.
    #[must_use]
    pub fn new(template: &'static Template) -> Self {
        Self {
            layer: GarmentLayer::Over,
            template,
            options: Options::of(template),
            fabric: FabricDesign::default(),
            print: made_in(template),
        }
    }

    /// Drafts it.
    ///
    /// # Errors
    /// Measures or options that it cannot be drafted from.
    pub fn pattern(&self, measures: &Measures) -> Result<Pattern, DraftError> {
        self.spec().pattern(measures)
    }

    /// The garment as it is drafted and put on.
    #[must_use]
    pub fn spec(&self) -> GarmentSpec<'_> {
        let print = self.print.print();
        GarmentSpec {
            template: self.template,
            options: &self.options,
            fabric: self.fabric.fabric(),
            colors: Colors {
                ground: print.ground,
                flower: print.flower,
                leaf: print.leaf,
                shadow: print.shadow,
            },
        }
    }
}

/// The pāʻū top: a tube held above the bust by elastic, and below it where there are rows for it.
#[derive(Debug, Clone, PartialEq)]
pub struct TopDesign {
    /// Height of the lowest upper elastic above the floor [cm]; a little above the fullest bust when
    /// `None`.
    pub upper_height_cm: Option<f64>,
    /// Height of the lowest lower elastic above the floor [cm]; below the bust when `None`.
    pub lower_height_cm: Option<f64>,
    /// Height of the hem above the floor [cm]; just above the skirt's upper edge when `None`.
    pub hem_height_cm: Option<f64>,
    /// Flat length over bust girth, 1 to 5.
    pub gather_ratio: f64,
    /// Rows of elastic above the bust, 1 to 3.
    pub upper_row_count: u32,
    /// Rows of elastic below it, 0 to 3.
    pub lower_row_count: u32,
    /// Relaxed elastic over the girth where it is worn, 0.8 to 0.9.
    pub elastic_ratio: f64,
    /// Ruffle above the top elastic [cm].
    pub header_cm: f64,
    /// Height of one casing [cm].
    pub casing_cm: f64,
    /// Height between two casings [cm].
    pub casing_gap_cm: f64,
    /// Cloth for the hem [cm].
    pub hem_allowance_cm: f64,
    /// Particles around.
    pub column_count: u32,
    /// Particles from top fold to hem.
    pub row_count: u32,
    /// Chance for how unevenly the gathers are pushed together.
    pub seed: u64,
}

impl Default for TopDesign {
    /// Twice the bust in cloth, as makers of tube tops buy it; ruffle and casing of an inch.
    fn default() -> Self {
        Self {
            upper_height_cm: None,
            lower_height_cm: None,
            hem_height_cm: None,
            gather_ratio: 2.0,
            upper_row_count: 1,
            lower_row_count: 1,
            elastic_ratio: 0.85,
            header_cm: 2.5,
            casing_cm: 2.5,
            casing_gap_cm: 1.5,
            hem_allowance_cm: 2.0,
            column_count: 288,
            row_count: 30,
            seed: 3,
        }
    }
}

/// Light cloth for what lies between.
fn lawn() -> FabricDesign {
    FabricDesign {
        preset: Preset::from_id("cotton-lawn").unwrap_or(FabricDesign::default().preset),
        ..FabricDesign::default()
    }
}

/// One color: the ground of a colorway.
fn plain(colorway: &'static str) -> PrintChoice {
    PrintChoice {
        motif: PrintMotif::Plain,
        colorway,
        ..PrintChoice::default()
    }
}

/// What a template is made in as the program has it.
fn made_in(template: &Template) -> PrintChoice {
    let usual = plain("red");
    let Some(colors) = template.natural else {
        return usual;
    };
    let [ground, flower, leaf, shadow] = colors.map(|hex| {
        let [_, red, green, blue] = hex.to_be_bytes();
        Some([red, green, blue])
    });
    PrintChoice {
        ground,
        flower,
        leaf,
        shadow,
        ..usual
    }
}
