//! `lole order`, `lole cost`, `lole booklet` and `lole form`: costumes for one dancer or a group, on
//! paper.

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use indicatif::ProgressBar;

use lole_body::{Dancer, Measurements};
use lole_costume::cost;
use lole_costume::document::{Design, Place};
use lole_costume::order::{self, DancerPlan, Group, PrintTotal, Settings};
use lole_costume::roster::{self, Roster, RosterError};
use lole_costume::tailoring;
use lole_export::booklet::{Booklet, bill_remarks, booklet_sheets};
use lole_export::form::form_sheets;
use lole_export::order::{
    ORDER_JSON, OrderParts, PATTERN_FILES, PICTURE_FOLDER, bill_json, left_behind, listed_files,
    order_folder,
};
use lole_export::pdf::{Document, Paper, missing_glyphs, printable};
use lole_files::Unread;
use lole_geom::Length;
use lole_language::{Bilingual as _, Language, Sentence};
use rayon::prelude::*;

use crate::args::{BookletArgs, CostArgs, FormArgs, OrderArgs, PageLanguage};
use crate::output;
use crate::patience::{check, progress_bar, stop_flag};
use crate::portrait::{self, Album, Kept};
use crate::source::{self, Source};
use crate::{Failure, summary};

/// Repeats on cut plans are drawn with so many pixels on a side.
pub(crate) const PRINT_SIDE: u32 = 512;

impl PageLanguage {
    /// The language that was asked for, else the system's.
    fn of(asked: Option<Self>, system: Language) -> Language {
        match asked {
            None => system,
            Some(Self::Ja) => Language::Japanese,
            Some(Self::En) => Language::English,
        }
    }
}

/// Runs `lole order`.
pub(crate) fn run_order(args: &OrderArgs, language: Language) -> Result<(), Failure> {
    let stop = stop_flag().map_err(Failure::error)?;
    let pages = PageLanguage::of(args.language, language);
    let source = source::read(Some(&args.design))?;
    let list = read_roster(&args.roster)?;
    let settings = Settings {
        spare_ratio: args.spare / 100.0,
        bolt_length: args.bolt.map(Length::from_m),
    };
    let mut output = output::create(&args.out).map_err(Failure::Usage)?;
    let album = (!args.no_pictures).then(|| Album::of(&args.out, &stop));
    let album = album.transpose()?;
    let (group, kept) = cut(&list, &source.design, (album.as_ref(), &stop, language))?;
    if group.plans.is_empty() {
        return Err(nobody(&group, &args.roster));
    }
    let earlier = std::fs::read_to_string(args.out.join(ORDER_JSON)).unwrap_or_default();
    let (pictures, kept_files): (Vec<_>, Vec<_>) = kept.into_iter().map(Option::unzip).unzip();
    let kept_files: Vec<String> = if args.no_pictures {
        // Pictures of an earlier run stay for a later one.
        let listed = listed_files(&earlier).into_iter();
        listed
            .filter(|name| name.starts_with(PICTURE_FOLDER))
            .collect()
    } else {
        kept_files.into_iter().flatten().collect()
    };
    let parts = OrderParts {
        title: title(&source),
        design: &source.design,
        group: &group,
        pictures: &pictures,
        settings: &settings,
        paper: args.paper.paper(),
        language: pages,
        version: env!("CARGO_PKG_VERSION"),
        kept_files: &kept_files,
    };
    let bar = bar_of(group.plans.len(), language.pick("型紙", "patterns"));
    let goes_on = || {
        bar.inc(1);
        !stop.load(Ordering::Relaxed)
    };
    let folder = order_folder(&parts, &goes_on).map_err(Failure::error)?;
    bar.finish_and_clear();
    check(&stop)?;
    for (name, bytes) in &folder.files {
        output.write(name, bytes).map_err(Failure::error)?;
    }
    let paths = output.finish().map_err(Failure::error)?;
    let stayed = output::tidy(&args.out, &left_behind(&earlier, &folder.json));
    if args.json {
        summary::print_json(&folder.json);
    } else {
        let lines = prints_lines(&folder.prints, group.plans.len());
        let mut notes = group.notes.clone();
        notes.extend(group.warnings());
        notes.extend(
            folder
                .prints
                .iter()
                .filter_map(|print| short_bolt(print, &group.plans)),
        );
        notes.extend(stayed);
        let names = group.plans.iter().map(|plan| plan.name.as_str());
        notes.extend(unprinted(names.chain([parts.title.as_str()])));
        summary::print_pattern(&shown(&paths), &lines, &notes, language);
    }
    verdict(&group.problems, language)
}

/// Tells of letters that the built-in typeface lacks, so that nobody wonders at 〓 on paper.
fn unprinted<'a>(texts: impl Iterator<Item = &'a str>) -> Option<Sentence> {
    let mut missing: Vec<char> = texts.flat_map(missing_glyphs).collect();
    missing.sort_unstable();
    missing.dedup();
    let listed = |comma: &str| {
        let letters: Vec<String> = missing.iter().map(char::to_string).collect();
        letters.join(comma)
    };
    (!missing.is_empty()).then(|| {
        Sentence::new(
            format!(
                "紙に印刷できない文字があり、〓になります: {}。名簿でかなや常用の漢字に書きかえると印刷できます",
                listed("、")
            ),
            format!(
                "letters that cannot be printed stand as 〓 on paper: {}; write these names in kana, kanji of everyday use or Latin letters",
                listed(", ")
            ),
        )
    })
}

/// What is said of a list without rows.
pub(crate) fn nobody_listed() -> Sentence {
    Sentence::new(
        "名簿に踊り手がいません。見出しの下に一人一行で書いてください",
        "the list has no dancers; write one a line below the heads",
    )
}

/// Why nobody of a list can be cut for.
fn nobody(group: &Group, list: &Path) -> Failure {
    let sentence = group.problems.first().cloned();
    let sentence = sentence.unwrap_or_else(nobody_listed);
    let sentence = of_file(list, &sentence);
    // A list of dancers who are all too large for the cloth can be read.
    if 0 < group.too_wide_count && group.too_wide_count == group.problems.len() {
        return Failure::error(sentence);
    }
    Failure::usage(sentence)
}

/// A bar for so many dancers.
fn bar_of(count: usize, doing: &'static str) -> ProgressBar {
    progress_bar(u32::try_from(count).unwrap_or(u32::MAX), doing)
}

/// Cuts the design for every dancer and takes the pictures of an album; whoever cannot be cut for is told and left
/// out.
fn cut(
    list: &Roster,
    design: &Design,
    (album, stop, language): (Option<&Album<'_>>, &AtomicBool, Language),
) -> Result<(Group, Vec<Option<Kept>>), Failure> {
    let doing = match album {
        Some(_) => language.pick("製図と着せつけ", "drafting and dressing"),
        None => language.pick("製図", "drafting"),
    };
    let bar = bar_of(list.dancers.len(), doing);
    let cut: Result<Vec<_>, Failure> = (list.dancers.par_iter().enumerate())
        .map(|(place, dancer)| {
            check(stop)?;
            let own = dancer.design(design);
            let cut = match album {
                Some(album) => album.cut(place, (&dancer.name, &own))?,
                None => (order::plan_design(&dancer.name, &own), None),
            };
            bar.inc(1);
            Ok((dancer, cut))
        })
        .collect();
    bar.finish_and_clear();
    let (mut group, mut pictures) = (Group::of(list), Vec::new());
    for (dancer, (plan, picture)) in cut? {
        if plan.is_ok() {
            pictures.push(picture);
        }
        group.add(dancer, design, plan);
    }
    Ok((group, pictures))
}

/// The files to tell of: of many patterns the first alone.
fn shown(paths: &[PathBuf]) -> Vec<PathBuf> {
    let is_pattern = |path: &&PathBuf| {
        let name = path.file_name().map(|name| name.to_string_lossy());
        name.is_some_and(|name| name.starts_with(PATTERN_FILES))
    };
    let first = paths.iter().find(is_pattern);
    let others = paths.iter().filter(|path| !is_pattern(path));
    others.chain(first).cloned().collect()
}

/// A sentence about a file.
pub(crate) fn of_file(path: &Path, sentence: &Sentence) -> Sentence {
    let name = path.display();
    Sentence::new(
        format!("{name}: {}", sentence.japanese()),
        format!("{name}: {sentence}"),
    )
}

/// Done, or a failure that names the rows that were left out.
fn verdict(problems: &[Sentence], language: Language) -> Result<(), Failure> {
    if problems.is_empty() {
        return Ok(());
    }
    summary::print_problems(problems, language);
    let count = problems.len();
    Err(Failure::error(Sentence::new(
        format!("ほかの人の分は書き出しました。使えない行が {count} 件あります（上に書きました）"),
        match count {
            1 => "everybody else's files are written; one row cannot be used, as told above"
                .to_owned(),
            _ => format!(
                "everybody else's files are written; {count} rows cannot be used, as told above"
            ),
        },
    )))
}

pub(crate) fn read_roster(path: &Path) -> Result<Roster, Failure> {
    roster::read(&read_list(path)?).map_err(|error| no_list(path, &error))
}

/// The bytes of a list of dancers.
fn read_list(path: &Path) -> Result<Vec<u8>, Failure> {
    let most = roster::MOST_BYTES as u64;
    let read = if lole_files::is_piped(path) {
        lole_files::read_piped(most)
    } else {
        lole_files::read_ordinary(path, most)
    };
    read.map_err(|why| {
        let sentence = match why {
            Unread::NoFile if path.is_dir() => Sentence::new(
                "フォルダーです。名簿のファイルを書いてください",
                "this is a folder; name the file of the list",
            ),
            Unread::NoFile => return Failure::usage(lole_files::no_ordinary_file(path)),
            Unread::TooLarge { megabytes } => Sentence::new(
                format!("{megabytes} MB あり、名簿としては大きすぎます。名簿だけを保存してください"),
                format!("the file has {megabytes} MB, more than a list of dancers has; save only the list"),
            ),
            Unread::Unreadable => Sentence::new(
                "ファイルが読めません。場所と名前を確かめてください",
                "the file cannot be read; check the path",
            ),
        };
        Failure::usage(of_file(path, &sentence))
    })
}

fn no_list(path: &Path, error: &RosterError) -> Failure {
    Failure::usage(of_file(path, &Sentence::of(error)))
}

/// What to buy of each print, in a line.
fn prints_lines(prints: &[PrintTotal], count: usize) -> Vec<Sentence> {
    prints
        .iter()
        .map(|print| {
            let (cloth, width) = (print.cloth, print.width.to_cm());
            let (metric, yards) = (print.bought.metric.to_m(), print.bought.imperial.to_yd());
            let saved = print.saved().to_m();
            let [japanese, english] = if 0.0 < saved {
                [
                    format!("。いっしょに裁って {saved:.1} m 節約"),
                    format!("; {saved:.1} m saved by cutting together"),
                ]
            } else {
                [String::new(), String::new()]
            };
            Sentence::new(
                format!("{count} 人分: {}、幅 {width:.0} cm、{metric:.1} m（{yards:.1} ヤード、予備を含む）{japanese}", cloth.japanese),
                format!("for {count}: {} of {width:.0} cm, {metric:.1} m ({yards:.1} yd), spare included{english}", cloth.english),
            )
        })
        .collect()
}

/// Who needs more than one bolt holds.
fn short_bolt(print: &PrintTotal, plans: &[DancerPlan]) -> Option<Sentence> {
    let (first, others) = print.longer_than_bolt.split_first()?;
    let name = plans.get(*first).map_or("", |plan| plan.name.as_str());
    let (cloth, more) = (print.cloth, others.len());
    let [japanese, english] = if more == 0 {
        [String::new(), String::new()]
    } else {
        [format!(" ほか {more} 人"), format!(" and {more} more")]
    };
    Some(Sentence::new(
        format!(
            "{name}{japanese}: {}は一反では足りません。はぎ合わせるか、長い反物をさがしてください",
            cloth.japanese
        ),
        format!(
            "{name}{english}: one bolt of {} is too short; join two lengths, or find a longer bolt",
            cloth.english
        ),
    ))
}

/// Name of the costume: its title, or that of its document.
pub(crate) fn title(source: &Source) -> String {
    let own = source.design.stage.title.trim();
    if !own.is_empty() {
        return printable(own);
    }
    let stem = Path::new(&source.name).file_stem();
    let is_document = !source.text.is_empty();
    match stem.filter(|_| is_document) {
        Some(stem) => printable(&stem.to_string_lossy()),
        None => "Pāʻū".to_owned(),
    }
}

/// A design's own dancer, and its plan for her.
fn own_plan(source: &Source) -> Result<(Dancer, DancerPlan), Failure> {
    let located = |table, sentence| source.located(Place { table, key: "" }, sentence);
    let design = &source.design;
    let dancer = match &design.dancer.file {
        Some(_) => lole_stage::dancer(design)
            .map(|(dancer, _)| dancer)
            .map_err(|error| located("dancer", Sentence::of(&error)))?,
        None => Measurements::from_tape(&design.tape())
            .and_then(|tape| Dancer::to_measure(&tape, &design.appearance()))
            .map_err(|error| located("dancer", Sentence::of(&error)))?,
    };
    let plan = order::plan_dancer("", design, &dancer).map_err(|error| {
        if error.is_too_wide() {
            return Failure::error(Sentence::of(&error));
        }
        let sentence = Sentence::of(&error);
        match error.dancer_key() {
            Some(key) => {
                let table = "dancer";
                source.located(Place { table, key }, sentence)
            }
            None => located("skirt", sentence),
        }
    })?;
    Ok((dancer, plan))
}

/// Runs `lole cost`.
pub(crate) fn run_cost(args: &CostArgs, language: Language) -> Result<(), Failure> {
    let source = source::read(args.design.as_deref())?;
    let (_, plan) = own_plan(&source)?;
    let bill = cost::bill(&source.design, &plan);
    if args.json {
        summary::print_json(&bill_json(&bill).map_err(Failure::error)?);
    } else {
        summary::print_bill(&bill, &bill_remarks(&bill, language), language);
    }
    Ok(())
}

/// Runs `lole booklet`.
pub(crate) fn run_booklet(args: &BookletArgs, language: Language) -> Result<(), Failure> {
    let stop = stop_flag().map_err(Failure::error)?;
    let pages = PageLanguage::of(args.language, language);
    let source = source::read(args.design.as_deref())?;
    let (dancer, plan) = own_plan(&source)?;
    let bill = cost::bill(&source.design, &plan);
    let worn = if args.no_pictures {
        None
    } else {
        Some(portrait::worn(&source.design, &stop)?)
    };
    let drafted_by = tailoring::drafted_by(&source.design, &dancer);
    let prints = source.design.cut_print_images(PRINT_SIDE);
    let prints = prints.map_err(|error| Failure::usage(Sentence::of(&error)))?;
    let prints: Vec<_> = prints.into_iter().map(Arc::new).collect();
    let booklet = Booklet {
        title: title(&source),
        plan: &plan,
        group: &[],
        prints: &prints,
        bill: &bill,
        drafted_by: &drafted_by,
        worn,
        hem_height_cm: source.design.costume_hem_cm(),
    };
    let sheets = booklet_sheets(&booklet, args.paper.paper(), pages);
    let document = Document::new(&booklet.title, pages, sheets);
    write_file(&args.out, &document, &[], language)
}

/// Runs `lole form`.
pub(crate) fn run_form(args: &FormArgs, language: Language) -> Result<(), Failure> {
    let pages = PageLanguage::of(args.language, language);
    let paper: Paper = args.paper.paper();
    // Names are enough: what is missing is what the form asks for.
    let names = match &args.roster {
        None => Vec::new(),
        Some(path) => roster::names(&read_list(path)?).map_err(|error| no_list(path, &error))?,
    };
    let sheets = if args.roster.is_none() {
        form_sheets(None, paper, pages).into()
    } else {
        let sheets = names
            .iter()
            .flat_map(|name| form_sheets(Some(name), paper, pages));
        sheets.collect()
    };
    let notes: Vec<Sentence> = unprinted(names.iter().map(String::as_str))
        .into_iter()
        .collect();
    let title = pages.pick("採寸表", "Measurement form");
    let document = Document::new(title, pages, sheets);
    write_file(&args.out, &document, &notes, language)
}

/// Writes one file, whole or not at all, and tells of it in the system's language.
fn write_file(
    path: &Path,
    document: &Document,
    notes: &[Sentence],
    language: Language,
) -> Result<(), Failure> {
    let bytes = document.to_bytes().map_err(Failure::error)?;
    if lole_files::is_piped(path) {
        summary::heard(std::io::stdout().write_all(&bytes));
        summary::print_found(notes);
        return Ok(());
    }
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let name = file_name(path)?;
    let mut output = output::create(folder).map_err(Failure::Usage)?;
    output.write(&name, &bytes).map_err(Failure::error)?;
    let paths = output.finish().map_err(Failure::error)?;
    summary::print_pattern(&paths, &[], notes, language);
    Ok(())
}

/// The name of the file that a path asks for.
fn file_name(path: &Path) -> Result<String, Failure> {
    let name = path
        .file_name()
        .map(|name| name.to_string_lossy().into_owned());
    let name = name.ok_or_else(|| {
        Failure::usage(Sentence::new(
            "--out にはファイルの名前を書いてください（例: booklet.pdf）",
            "--out needs the name of a file, such as booklet.pdf",
        ))
    })?;
    if path.is_dir() {
        return Err(Failure::usage(of_file(
            path,
            &Sentence::new(
                "フォルダーです。--out にはファイルの名前を書いてください（例: booklet.pdf）",
                "this is a folder; --out needs the name of a file, such as booklet.pdf",
            ),
        )));
    }
    // Nothing opens a file whose name does not say what it is.
    Ok(match Path::new(&name).extension() {
        Some(_) => name,
        None => name + ".pdf",
    })
}
