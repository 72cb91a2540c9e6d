//! `lole pattern`: cut plans and patterns of everything that a design has.

use std::sync::Arc;

use lole_costume::document::Place;
use lole_costume::tailoring::{self, ClothPlan, GarmentPattern};
use lole_export::booklet::amount_words;
use lole_export::cutting::{
    CutGarment, cut_plan_sheets, cut_plan_svg, masses, pattern_json, pieces_svg, ruler_sheets,
    short_words, tiled_sheets, used_words,
};
use lole_export::dxf::pattern_dxf;
use lole_export::pdf::{Document, Paper, Sheet};
use lole_language::{Bilingual as _, Language, Sentence, Words};
use lole_pattern::marker::Lay;
use lole_print::PrintImage;

use crate::args::{PaperSize, PatternArgs};
use crate::dance::place_of;
use crate::order::PRINT_SIDE;
use crate::output::OutputFolder;
use crate::patience::{check, progress_bar, stop_flag};
use crate::source::{self, Source};
use crate::{Failure, summary};

impl PaperSize {
    pub(crate) const fn paper(self) -> Paper {
        match self {
            Self::A4 => Paper::A4,
            Self::A3 => Paper::A3,
            Self::Letter => Paper::Letter,
        }
    }
}

/// Runs the command.
pub(crate) fn run(args: &PatternArgs, language: Language) -> Result<(), Failure> {
    let stop = stop_flag().map_err(Failure::Run)?;
    let source = source::read(args.design.as_deref())?;
    let garments = draft(&source)?;
    let mut files = PatternFiles {
        output: OutputFolder::create(&args.out).map_err(Failure::Usage)?,
        paper: args.paper.paper(),
        language,
    };
    let count = u32::try_from(garments.len()).unwrap_or(u32::MAX);
    let bar = progress_bar(2 * count + 1, language.pick("型紙", "pattern"));
    let mut cuts = Vec::new();
    let prints = source.design.cut_print_images(PRINT_SIDE);
    let prints = prints.map_err(|error| Failure::usage(Sentence::of(&error)))?;
    for (garment, print) in garments.into_iter().zip(prints) {
        check(&stop)?;
        cuts.push(plan(garment, print, args));
        bar.inc(1);
    }
    files.write_plans(&cuts)?;
    bar.inc(1);
    let size = args
        .design
        .as_deref()
        .and_then(|path| path.file_stem())
        .map_or_else(|| "LOLE".into(), |stem| stem.to_string_lossy());
    for cut in &cuts {
        check(&stop)?;
        files.write_garment(cut, &size)?;
        bar.inc(1);
    }
    let json = pattern_json(&cuts, env!("CARGO_PKG_VERSION")).map_err(Failure::error)?;
    files.write("pattern.json", json.as_bytes())?;
    bar.finish_and_clear();
    let paths = files.output.finish().map_err(Failure::Run)?;
    if args.json {
        summary::print_json(&json);
    } else {
        let purchases: Vec<Sentence> = cuts.iter().flat_map(purchases).collect();
        let warnings: Vec<Sentence> = cuts.iter().flat_map(warnings).collect();
        summary::print_pattern(&paths, &purchases, &warnings, language);
    }
    Ok(())
}

/// Drafts everything that the design has to its dancer.
fn draft(source: &Source) -> Result<Vec<GarmentPattern>, Failure> {
    let (dancer, _) = lole_stage::dancer(&source.design)
        .map_err(|error| source.located(place_of(&error), Sentence::of(&error)))?;
    tailoring::patterns_of(&source.design, &dancer).map_err(|error| {
        // Nothing is wrong with the document: there is no wider cloth on the table.
        if error.is_too_wide() {
            return Failure::error(Sentence::of(&error));
        }
        let table = if error.place.is_some() {
            "garment"
        } else {
            "skirt"
        };
        source.located(Place { table, key: "" }, Sentence::of(&error))
    })
}

fn plan(garment: GarmentPattern, print: PrintImage, args: &PatternArgs) -> CutGarment {
    let lay = if args.folded {
        Lay::Folded
    } else {
        Lay::Single
    };
    let repeat = garment.cloth.repeat.filter(|_| args.match_print);
    CutGarment {
        plans: garment.cloth_plans(lay, repeat),
        garment,
        print: Some(Arc::new(print)),
        owner: String::new(),
    }
}

/// The folder of the files, and how they are written.
struct PatternFiles {
    output: OutputFolder,
    paper: Paper,
    language: Language,
}

impl PatternFiles {
    /// What all garments share: cut plans, and the sheets for ruler and chalk.
    fn write_plans(&mut self, cuts: &[CutGarment]) -> Result<(), Failure> {
        // What is tied, strung or carved has no cut plan: its booklet says what to gather.
        if cuts.iter().all(|cut| cut.plans.is_empty()) {
            return Ok(());
        }
        let (paper, language) = (self.paper, self.language);
        let title = language.pick("裁ち方図", "cut plan");
        self.write_pdf(
            "cut-plan.pdf",
            title,
            cut_plan_sheets(cuts, paper, language),
        )?;
        self.write("cut-plan.svg", &cut_plan_svg(cuts, language))?;
        let ruler = ruler_sheets(cuts, paper, language);
        if ruler.is_empty() {
            return Ok(());
        }
        let title = language.pick("定規で引く線", "rectangles by ruler");
        self.write_pdf("ruler.pdf", title, ruler)
    }

    /// The pieces of one garment at full size; `size` is the name of the design.
    fn write_garment(&mut self, cut: &CutGarment, size: &str) -> Result<(), Failure> {
        let (paper, language) = (self.paper, self.language);
        let id = &cut.garment.id;
        if let Some(tiled) = tiled_sheets(cut, paper, language) {
            let name = format!("{id}-{}.pdf", paper.name().to_ascii_lowercase());
            self.write_pdf(&name, cut.garment.name.text(language), tiled.sheets)?;
        }
        // Leaves and flowers are tied, not cut.
        if cut.garment.pattern.pieces.is_empty() {
            return Ok(());
        }
        self.write(&format!("{id}.svg"), &pieces_svg(cut, language))?;
        self.write(&format!("{id}.dxf"), &pattern_dxf(cut, size))
    }

    fn write_pdf(&mut self, name: &str, title: &str, sheets: Vec<Sheet>) -> Result<(), Failure> {
        let document = Document::new(title, self.language, sheets);
        self.write(name, &document.to_bytes().map_err(Failure::error)?)
    }

    fn write(&mut self, name: &str, bytes: &[u8]) -> Result<(), Failure> {
        self.output.write(name, bytes).map_err(Failure::Run)
    }
}

/// What to buy for each cloth of a garment.
fn purchases(cut: &CutGarment) -> Vec<Sentence> {
    if cut.plans.is_empty() {
        return vec![gathered(cut)];
    }
    let plans = cut.plans.iter();
    plans.map(|plan| purchase(cut.garment.name, plan)).collect()
}

/// What to buy for one cloth of a garment of this name.
fn purchase(name: Words, plan: &ClothPlan) -> Sentence {
    let marker = &plan.marker;
    let (needed, metric) = (marker.yardage.needed.to_cm(), marker.yardage.metric.to_m());
    let (yards, width) = (marker.yardage.imperial.to_yd(), marker.cloth.width.to_cm());
    let ([metric_kg, cut_kg], [yard_kg, _]) = (
        masses(plan, Language::Japanese),
        masses(plan, Language::English),
    );
    let short = |language: Language| {
        let sentence = short_words(&marker.yardage, language);
        sentence.map_or_else(String::new, |sentence| {
            format!("{}{sentence}", language.pick("。", ". "))
        })
    };
    Sentence::new(
        format!(
            "{}: 幅 {width:.0} cm の布 {metric:.1} m（{yards:.1} ヤード）、用尺 {needed:.1} cm、買う布 {metric_kg:.2} kg（ヤードなら {yard_kg:.2} kg）、裁った布 {cut_kg:.2} kg{}{}",
            name.japanese,
            used_words(plan, "、", Language::Japanese),
            short(Language::Japanese)
        ),
        format!(
            "{}: buy {metric:.1} m ({yards:.1} yd) of {width:.0} cm cloth; {needed:.1} cm are needed; {metric_kg:.2} kg bought ({yard_kg:.2} kg by the yard), {cut_kg:.2} kg once cut{}{}",
            name.english,
            used_words(plan, ", ", Language::English),
            short(Language::English)
        ),
    )
}

/// What to gather for what is not cut from cloth.
fn gathered(cut: &CutGarment) -> Sentence {
    let listed = |language: Language| {
        let notions = cut.garment.pattern.notions.iter();
        let named = notions.map(|notion| {
            let amount = amount_words(notion.kind, notion.amount, language);
            format!("{} {amount}", notion.name.text(language))
        });
        let named: Vec<String> = named.collect();
        named.join(language.pick("、", ", "))
    };
    let name = cut.garment.name;
    Sentence::new(
        format!(
            "{}: 布は裁ちません。用意するものは {}。作り方は lole booklet の本にあります",
            name.japanese,
            listed(Language::Japanese)
        ),
        format!(
            "{}: no cloth is cut. Gather {}. The booklet of lole booklet says how it is made",
            name.english,
            listed(Language::English)
        ),
    )
}

/// What the maker should decide before cutting.
fn warnings(cut: &CutGarment) -> Vec<Sentence> {
    let name = cut.garment.name;
    let drafted = cut.garment.pattern.warnings.iter().map(|sentence| {
        Sentence::new(
            format!("{}: {}", name.japanese, sentence.japanese()),
            format!("{}: {sentence}", name.english),
        )
    });
    let laid = cut.plans.iter().flat_map(|plan| &plan.marker.warnings);
    drafted
        .chain(laid.map(|warning| warning.of_garment(name)))
        .collect()
}
