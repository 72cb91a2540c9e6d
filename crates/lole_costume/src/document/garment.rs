//! Garments that are worn with the skirt, in the units of the document.

use std::sync::Arc;

use lole_garment::template::PAU_SKIRT;
use lole_garment::{
    Colors, Fineness, Fitting, GarmentLayer, GarmentSpec, Given, Options, Template,
};
use lole_language::Words;
use lole_pattern::{Alterations, DraftError, Pattern, TailorTape};
use lole_print::PrintMotif;

use super::{FabricDesign, PrintChoice, SkirtDesign};
use crate::fabrics::Preset;

/// A garment: its kind, how it is cut and sewn, and what of.
#[derive(Debug, Clone, PartialEq)]
pub struct GarmentDesign {
    /// Where it is worn.
    pub layer: GarmentLayer,
    /// What it is.
    pub template: &'static Template,
    /// What was decided, one value for each option of the template.
    pub options: Options,
    /// How finely it is sewn where it is gathered.
    pub fineness: Fineness,
    /// What it is cut from.
    pub fabric: FabricDesign,
    /// What is printed on it.
    pub print: PrintChoice,
    /// The file of another program that it is cut after, where it is of that kind.
    pub file: Option<LinkedPattern>,
}

/// A pattern of another program that a document names. Whoever opens the document reads it: the pieces are not
/// part of the text.
#[derive(Debug, Clone, PartialEq)]
pub struct LinkedPattern {
    /// Its place from the document.
    pub name: String,
    /// What it holds; `None` until it is read.
    pub given: Option<Arc<Given>>,
}

impl LinkedPattern {
    /// A pattern that is not read yet.
    #[must_use]
    pub fn named(name: &str) -> Self {
        Self {
            name: name.to_owned(),
            given: None,
        }
    }
}

impl GarmentDesign {
    /// The garment as the program would make it: in one color over the skirt, or as the skirt's second under
    /// it, of light cloth.
    #[must_use]
    pub fn new(template: &'static Template) -> Self {
        let options = Options::of(template);
        let print = made_in(template);
        let Some(second) = template.second() else {
            return Self {
                layer: GarmentLayer::Over,
                template,
                options,
                fineness: template.fineness(),
                fabric: FabricDesign::default(),
                print,
                file: None,
            };
        };
        Self {
            layer: GarmentLayer::Under,
            template,
            options: options.with(template, second.options),
            fineness: second.fineness,
            fabric: lawn(),
            print,
            file: None,
        }
    }

    /// A garment of this kind, as the program would make it; `None` where there is no such kind.
    #[must_use]
    pub fn of_kind(id: &str) -> Option<Self> {
        Template::of_id(id).map(Self::new)
    }

    /// Name of its kind in documents.
    #[must_use]
    pub const fn kind_id(&self) -> &'static str {
        self.template.id
    }

    /// Name in files, before it is numbered.
    #[must_use]
    pub fn file_name(&self) -> String {
        self.template.file_name_in(Some(self.layer))
    }

    /// What it is called.
    #[must_use]
    pub const fn name(&self) -> Words {
        self.template.name_in(Some(self.layer))
    }

    /// What was decided of the option of this key, in its unit; `None` where it follows from the measures, or
    /// there is no such option.
    #[must_use]
    pub fn option(&self, key: &str) -> Option<f64> {
        let position = self.template.position(key)?;
        self.options.get(position)
    }

    /// Decides the options of these keys, in their units, each of which its template has.
    #[must_use]
    pub fn with(mut self, decided: &[(&str, f64)]) -> Self {
        self.options = self.options.with(self.template, decided);
        self
    }

    /// Whether it is sewn from its template and put on as it is, and danced.
    #[must_use]
    pub const fn is_dressed(&self) -> bool {
        self.template.is_sewn()
    }

    /// Whether it is gathered rectangles, sewn in rows and columns and danced.
    #[must_use]
    pub fn is_danced(&self) -> bool {
        0 < self.gathered_count()
    }

    /// How many gathered rectangles it is, one over the other, each carried by the dancer.
    #[must_use]
    pub fn gathered_count(&self) -> usize {
        self.template.gathered_count(&self.options)
    }

    /// Whether it is worn or held beside the cloth, and seen on the dancer: see [`lole_garment::adorn`].
    #[must_use]
    pub const fn is_adornment(&self) -> bool {
        self.template.is_adornment()
    }

    /// Drafts it.
    ///
    /// # Errors
    /// Measures or options that it cannot be drafted from.
    pub fn pattern(&self, fitting: &Fitting<'_>) -> Result<Pattern, DraftError> {
        self.spec().pattern(fitting)
    }

    /// The garment as it is drafted and put on, without alterations and by her body's own measures.
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
            alterations: Alterations::NONE,
            tailor_tape: TailorTape::NONE,
            given: self.file.as_ref().and_then(|file| file.given.as_deref()),
        }
    }
}

impl SkirtDesign {
    /// The skirt as a garment among others, of this cloth.
    #[must_use]
    pub fn garment(&self, fabric: &FabricDesign, print: &PrintChoice) -> GarmentDesign {
        let decided = [
            ("hem_height_cm", self.hem_height_cm),
            ("gather_ratio", self.gather_ratio),
            ("elastic_row_count", f64::from(self.elastic_row_count)),
            ("elastic_ratio", self.elastic_ratio),
            ("header_cm", self.header_cm),
            ("casing_cm", self.casing_cm),
            ("casing_gap_cm", self.casing_gap_cm),
            ("hem_allowance_cm", self.hem_allowance_cm),
        ];
        let worn_height = self.worn_height_cm.map(|height| ("worn_height_cm", height));
        let options = Options::of(&PAU_SKIRT).with(&PAU_SKIRT, &decided);
        GarmentDesign {
            layer: GarmentLayer::Over,
            template: &PAU_SKIRT,
            options: options.with(&PAU_SKIRT, worn_height.as_slice()),
            fineness: Fineness {
                column_count: self.column_count,
                row_count: self.row_count,
                seed: self.seed,
            },
            fabric: fabric.clone(),
            print: print.clone(),
            file: None,
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

/// What a template is made in as the program has it: what lies under the skirt is pale.
fn made_in(template: &Template) -> PrintChoice {
    let usual = plain(if template.second().is_some() {
        "cream"
    } else {
        "red"
    });
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
