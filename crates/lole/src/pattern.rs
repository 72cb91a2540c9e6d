//! `lole pattern`: cut plans and patterns of everything that a design has.

use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::Ordering;

use lole_costume::document::{Design, Place};
use lole_costume::order;
use lole_costume::size_chart;
use lole_costume::tailoring::{self, ClothPlan, GarmentPattern};
use lole_exchange::garmentcode;
use lole_export::booklet::amount_words;
use lole_export::cutting::{
    CutGarment, MOST_SIZES, PATTERN_JSON, PatternParts, Stamp, WholeSheet, has_shaped_pieces,
    left_behind, masses, nested_sheet, pattern_folder, short_words, sizes_name, used_words,
    whole_name,
};
use lole_export::pdf::Paper;
use lole_language::{Bilingual as _, Language, Sentence, Words};
use lole_pattern::marker::Lay;
use lole_print::PrintImage;

use crate::args::{PaperSize, PatternArgs, PatternFormat, WholePage};
use crate::dance::place_of;
use crate::order::PRINT_SIDE;
use crate::output;
use crate::patience::{check, progress_bar, stop_flag};
use crate::source::{self, Source};
use crate::{Failure, summary};

impl WholePage {
    const fn page(self) -> WholeSheet {
        match self {
            Self::A0 => WholeSheet::A0,
            Self::Roll => WholeSheet::Roll,
            Self::Projector => WholeSheet::Projector,
            Self::Plotter => WholeSheet::Plotter,
        }
    }
}

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
    let stop = stop_flag().map_err(Failure::error)?;
    let source = source::read(args.design.as_deref())?;
    let garments = draft(&source)?;
    if args.format == Some(PatternFormat::Garmentcode) {
        return write_garmentcode(&source, &garments, args, language);
    }
    let mut output = output::create(&args.out).map_err(Failure::Usage)?;
    let count = u32::try_from(garments.len()).unwrap_or(u32::MAX);
    let bar = progress_bar(2 * count, language.pick("型紙", "pattern"));
    let mut cuts = Vec::new();
    let stamp = Stamp::of(&crate::order::title(&source), &source.design);
    let whole: Vec<WholeSheet> = args.whole.iter().map(|page| page.page()).collect();
    let prints = source.design.cut_print_images(PRINT_SIDE);
    let prints = prints.map_err(|error| Failure::usage(Sentence::of(&error)))?;
    for (garment, print) in garments.into_iter().zip(prints) {
        check(&stop)?;
        cuts.push(plan(garment, (print, &stamp), args));
        bar.inc(1);
    }
    let size = args
        .design
        .as_deref()
        .and_then(|path| path.file_stem())
        .map_or_else(|| "LOLE".into(), |stem| stem.to_string_lossy());
    let parts = PatternParts {
        cuts: &cuts,
        size: &size,
        paper: args.paper.paper(),
        whole: &whole,
        language,
        version: env!("CARGO_PKG_VERSION"),
    };
    let goes_on = || {
        bar.inc(1);
        !stop.load(Ordering::Relaxed)
    };
    let mut files = pattern_folder(&parts, &goes_on).map_err(Failure::error)?;
    let mut apart = Vec::new();
    if let Some(sizes) = &args.sizes {
        let (sheets, not_nested) = nested(&source.design, sizes, language)?;
        files.extend(sheets);
        apart = not_nested;
    }
    check(&stop)?;
    bar.finish_and_clear();
    for (name, bytes) in &files {
        output.write(name, bytes).map_err(Failure::error)?;
    }
    let earlier = std::fs::read(args.out.join(PATTERN_JSON)).unwrap_or_default();
    let paths = output.finish().map_err(Failure::error)?;
    // Sheets of the costume before would be taken for this one's.
    let stayed = output::tidy(&args.out, &left_behind(&earlier, &files));
    let narrow = too_wide_for_pages(&cuts, &whole, &files);
    let warnings = cuts.iter().flat_map(warnings).chain(stayed);
    let warnings: Vec<Sentence> = warnings.chain(narrow).chain(apart).collect();
    if args.json {
        let json = files.iter().find(|(name, _)| name == PATTERN_JSON);
        let text = json.map_or("".into(), |(_, bytes)| String::from_utf8_lossy(bytes));
        summary::print_json(&text);
        summary::print_problems(&warnings, language);
    } else {
        let purchases: Vec<Sentence> = cuts.iter().flat_map(purchases).collect();
        summary::print_pattern(&paths, &purchases, &warnings, language);
    }
    Ok(())
}

/// Writes every garment as a specification of GarmentCode.
fn write_garmentcode(
    source: &Source,
    garments: &[GarmentPattern],
    args: &PatternArgs,
    language: Language,
) -> Result<(), Failure> {
    let (dancer, _) = lole_stage::dancer(&source.design)
        .map_err(|error| source.located(place_of(&error), Sentence::of(&error)))?;
    let waist = f64::from(dancer.landmarks.waist_height);
    let mut output = output::create(&args.out).map_err(Failure::Usage)?;
    let cut = garments
        .iter()
        .filter(|garment| !garment.pattern.pieces.is_empty());
    for garment in cut {
        let name = format!("{}_specification.json", garment.id);
        let text = garmentcode::write(&garment.pattern, waist);
        output
            .write(&name, text.as_bytes())
            .map_err(Failure::error)?;
    }
    let paths = output.finish().map_err(Failure::error)?;
    summary::print_files(&paths, language);
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
        let (table, key) = match (error.dancer_key(), error.place) {
            (Some(key), _) => ("dancer", key),
            (None, Some(_)) => ("garment", ""),
            (None, None) => ("skirt", ""),
        };
        source.located(Place { table, key }, Sentence::of(&error))
    })
}

fn plan(
    garment: GarmentPattern,
    (print, stamp): (PrintImage, &Stamp),
    args: &PatternArgs,
) -> CutGarment {
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
        stamp: stamp.clone(),
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

/// Pages of garments in several sizes under their names, and why others have none.
type Nested = (Vec<(String, Vec<u8>)>, Vec<Sentence>);

/// Every garment in all sizes of a chart or a list, on a page each.
fn nested(design: &Design, sizes: &str, language: Language) -> Result<Nested, Failure> {
    let chart = match size_chart::chart(sizes) {
        Some(chart) => chart,
        None => crate::order::read_roster(Path::new(sizes))?,
    };
    let of_list = |sentence: Sentence| {
        Failure::usage(Sentence::new(
            format!("--sizes {sizes}: {}", sentence.japanese()),
            format!("--sizes {sizes}: {sentence}"),
        ))
    };
    if let Some(problem) = chart.problems.first() {
        return Err(of_list(problem.sentence()));
    }
    if MOST_SIZES < chart.dancers.len() {
        return Err(of_list(Sentence::new(
            format!("{MOST_SIZES} サイズまでです。表を分けてください"),
            format!("at most {MOST_SIZES} sizes can be told apart; divide the list"),
        )));
    }
    let mut plans = Vec::new();
    for size in &chart.dancers {
        let plan = order::plan(size, design).map_err(|error| {
            let (name, said) = (&size.name, Sentence::of(&error));
            of_list(Sentence::new(
                format!("{name}: {}", said.japanese()),
                format!("{name}: {said}"),
            ))
        })?;
        plans.push(plan);
    }
    let garments = plans.first().map_or(0, |plan| plan.garments.len());
    let (mut files, mut apart) = (Vec::new(), Vec::new());
    for garment in 0..garments {
        let tailored = &plans[0].garments[garment].tailored;
        match nested_sheet(&plans, garment, language) {
            Ok(sheet) => {
                let title = tailored.name.text(language);
                let bytes = sheet.to_bytes(title, language).map_err(Failure::error)?;
                files.push((sizes_name(&tailored.id), bytes));
            }
            Err(why) => apart.push(why.sentence(tailored.name)),
        }
    }
    Ok((files, apart))
}

/// Garments that were asked for on one page and do not fit on it.
fn too_wide_for_pages(
    cuts: &[CutGarment],
    whole: &[WholeSheet],
    files: &[(String, Vec<u8>)],
) -> Vec<Sentence> {
    let asked = cuts.iter().filter(|cut| has_shaped_pieces(&cut.garment));
    let asked = asked.flat_map(|cut| whole.iter().map(move |page| (cut, *page)));
    let missing = asked.filter(|(cut, page)| {
        let name = whole_name(&cut.garment.id, *page);
        files.iter().all(|(written, _)| *written != name)
    });
    missing
        .map(|(cut, page)| {
            let (name, page) = (cut.garment.name, page.name());
            Sentence::new(
                format!(
                    "{}: {page} の幅に入らない型紙があるので、貼り合わせる紙だけを書き出しました",
                    name.japanese
                ),
                format!(
                    "{}: a piece is wider than {page}; only the sheets to join are written",
                    name.english
                ),
            )
        })
        .collect()
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
