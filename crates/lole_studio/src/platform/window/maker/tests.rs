//! Products of a small design, made by the thread that the window has.

use std::path::Path;
use std::time::Duration;

use lole_costume::document::{Design, GarmentDesign};
use lole_export::pdf::Paper;
use lole_language::Language;

use super::*;
use crate::making::{Product, flew_apart, with_ending};
use crate::paper::Cutting;

/// A small skirt and a short dance, so that a test takes seconds.
fn wish(product: Product, name: &str) -> Wish {
    let mut design = Design::default();
    (design.skirt.column_count, design.skirt.row_count) = (96, 12);
    design.motion.duration_s = Some(0.5);
    design.dancer.hip_cm = Some(98.0);
    let folder = std::env::temp_dir();
    Wish {
        product,
        design,
        path: folder.join(format!("lole-making-{}-{name}", std::process::id())),
        paper: Paper::A4,
        cutting: Cutting::default(),
        language: Language::Japanese,
        title: "ハウ".to_owned(),
        group: None,
    }
}

/// The end of a piece, with the shares that were told before it; `told` is what was told of others.
fn end_of(maker: &mut Maker, number: u64, told: &mut Vec<(u64, Stage)>) -> (Stage, Vec<f32>) {
    loop {
        told.extend(maker.news());
        let of_it = |(of, stage): &(u64, Stage)| (*of == number).then(|| stage.clone());
        let stages: Vec<Stage> = told.iter().filter_map(of_it).collect();
        if let Some(end) = stages.iter().find(|stage| stage.is_end()) {
            let shares = stages.iter().filter_map(|stage| match stage {
                Stage::Working(share) => Some(*share),
                _ => None,
            });
            return (end.clone(), shares.collect());
        }
        thread::sleep(Duration::from_millis(5));
    }
}

fn end(maker: &mut Maker, number: u64) -> (Stage, Vec<f32>) {
    end_of(maker, number, &mut Vec::new())
}

#[test]
fn everybody_of_a_list_dances_in_one_film_or_it_is_said_why_not() {
    let mut maker = Maker::start(0, || {});
    let heads = "name,stature,bust,waist,hip\n";
    let mut ask = |rows: &str, name: &str| {
        let list = lole_costume::roster::read(format!("{heads}{rows}").as_bytes()).unwrap();
        let mut wish = wish(Product::GroupFilm, name);
        wish.design.skirt.column_count = 112;
        wish.group = Some((list.into(), lole_stage::Formation::Wedge));
        let piece = maker.ask(wish);
        (end(&mut maker, piece.number), piece.path)
    };
    let ((stage, shares), path) = ask("Hanako,158,83,66,91\nMele,165,92,74,99\n", "all.mp4");
    assert_eq!(stage, Stage::Done);
    assert!(shares.is_sorted() && shares.iter().all(|share| (0.0..=1.0).contains(share)));
    let bytes = std::fs::read(&path).unwrap();
    assert!(bytes[..12].windows(4).any(|four| four == b"ftyp"));
    std::fs::remove_file(&path).unwrap();
    let many: String = (0..25).map(|it| format!("{it},158,83,66,91\n")).collect();
    for (rows, said) in [(many.as_str(), "25 dancers"), ("", "no dancers")] {
        let ((stage, _), path) = ask(rows, "none.mp4");
        let Stage::Failed(why) = stage else {
            panic!("{said}");
        };
        assert!(why.english.contains(said), "{why}");
        assert!(!path.exists());
    }
}

#[test]
fn every_product_of_a_dancer_is_written_to_its_place_with_progress() {
    let mut maker = Maker::start(0, || {});
    for (product, name, magic) in [
        (Product::Booklet, "a.pdf", &b"%PDF"[..]),
        (Product::Film, "a.mp4", b"ftyp"),
        (Product::Model, "a.glb", b"glTF"),
    ] {
        let piece = maker.ask(wish(product, name));
        let (stage, shares) = end(&mut maker, piece.number);
        assert_eq!(stage, Stage::Done, "{product:?}");
        assert!(shares.is_sorted() && shares.iter().all(|share| (0.0..=1.0).contains(share)));
        let bytes = std::fs::read(&piece.path).unwrap();
        let start = &bytes[..12];
        assert!(start.windows(4).any(|four| four == magic), "{product:?}");
        std::fs::remove_file(&piece.path).unwrap();
    }
}

#[test]
fn a_pattern_is_cut_to_her_own_figures() {
    let mut maker = Maker::start(0, || {});
    let of_hip = |hip: f64, name: &str| {
        let mut wish = wish(Product::Pattern, name);
        wish.design.dancer.hip_cm = Some(hip);
        wish
    };
    let read = |piece: &Piece| std::fs::read_to_string(piece.path.join("pattern.json")).unwrap();
    let pieces = [of_hip(94.0, "small"), of_hip(98.0, "large")].map(|wish| maker.ask(wish));
    let mut told = Vec::new();
    for piece in &pieces {
        let (stage, _) = end_of(&mut maker, piece.number, &mut told);
        assert_eq!(stage, Stage::Done);
    }
    assert_ne!(read(&pieces[0]), read(&pieces[1]));
    let names = std::fs::read_dir(&pieces[1].path).unwrap().flatten();
    let names: Vec<_> = names.map(|entry| entry.file_name()).collect();
    for ending in ["cut-plan.pdf", "cut-plan.svg", "skirt.svg", "skirt.dxf"] {
        let has_it = |name: &std::ffi::OsString| name.to_string_lossy().ends_with(ending);
        assert!(names.iter().any(has_it), "{ending} in {names:?}");
    }
    for piece in pieces {
        std::fs::remove_dir_all(piece.path).unwrap();
    }
}

#[test]
fn what_is_called_off_leaves_nothing_and_what_waits_is_never_begun() {
    let mut maker = Maker::start(0, || {});
    let first = maker.ask(wish(Product::Film, "off.mp4"));
    let second = maker.ask(wish(Product::Model, "off.glb"));
    maker.call_off(second.number);
    maker.call_off(first.number);
    let mut told = Vec::new();
    for piece in [first, second] {
        let (stage, _) = end_of(&mut maker, piece.number, &mut told);
        assert_eq!(stage, Stage::CalledOff);
        assert!(!piece.path.exists());
    }
}

#[test]
fn what_is_called_off_at_the_last_moment_is_not_written() {
    let wish = wish(Product::Model, "late.glb");
    let is_called_off = AtomicBool::new(false);
    let line = Line {
        is_called_off: &is_called_off,
        tell: &|share| is_called_off.store(1.0 <= share, Ordering::Relaxed),
    };
    assert!(matches!(make(&wish, &line), Err(Unmade::CalledOff)));
    assert!(!wish.path.exists());
}

#[test]
fn sheets_of_the_costume_before_do_not_stay_in_the_folder() {
    let mut wish = wish(Product::Pattern, "again");
    let is_called_off = AtomicBool::new(false);
    let line = Line {
        is_called_off: &is_called_off,
        tell: &|_| {},
    };
    let top = GarmentDesign::of_kind("pau-top").unwrap();
    wish.design.garments = vec![top];
    make(&wish, &line).unwrap();
    let files = || -> Vec<String> {
        let found = std::fs::read_dir(&wish.path).unwrap().flatten();
        found
            .map(|it| it.file_name().to_string_lossy().into_owned())
            .collect()
    };
    let is_of_top = |name: &String| name.starts_with("pau_top");
    assert!(files().iter().any(is_of_top), "{:?}", files());
    std::fs::write(wish.path.join("notes.txt"), "").unwrap();
    let alone = Wish {
        design: Design {
            garments: Vec::new(),
            ..wish.design.clone()
        },
        ..wish.clone()
    };
    make(&alone, &line).unwrap();
    assert!(!files().iter().any(is_of_top), "{:?}", files());
    for name in ["notes.txt", "pau_skirt.svg", "cut-plan.pdf"] {
        assert!(
            files().iter().any(|it| it == name),
            "{name} in {:?}",
            files()
        );
    }
    std::fs::remove_dir_all(&wish.path).unwrap();
}

#[test]
fn a_product_that_breaks_is_told_and_the_next_one_is_made() {
    let breaks: Make = |wish, _| match wish.product {
        Product::Film => panic!("on purpose"),
        _ => Ok(()),
    };
    let mut maker = Maker::start_with(breaks, 7, || {});
    let pieces = [Product::Film, Product::Model].map(|it| maker.ask(wish(it, "breaks")));
    assert_eq!(pieces.each_ref().map(|piece| piece.number), [8, 9]);
    let mut told = Vec::new();
    let [film, model] = pieces.map(|it| end_of(&mut maker, it.number, &mut told).0);
    assert!(matches!(film, Stage::Failed(_)), "{film:?}");
    assert_eq!(model, Stage::Done);
    // Without a thread it is said at once.
    maker.thread = None;
    let piece = maker.ask(wish(Product::Model, "never.glb"));
    assert!(matches!(piece.stage, Stage::Failed(_)));
}

#[test]
fn cloth_that_flies_apart_while_it_settles_has_no_time_of_the_dance() {
    assert!(flew_apart(Some(1.25)).japanese.contains("1.25 秒"));
    for sentence in [flew_apart(Some(-1.2)), flew_apart(None)] {
        assert!(!sentence.japanese.contains("1.2") && !sentence.english.contains("1.2"));
    }
}

#[test]
fn what_cannot_be_made_says_why() {
    let mut maker = Maker::start(0, || {});
    let mut wish = wish(Product::Booklet, "never.pdf");
    wish.design.dancer.waist_cm = Some(130.0);
    wish.design.dancer.hip_cm = Some(80.0);
    let piece = maker.ask(wish);
    let (Stage::Failed(sentence), _) = end(&mut maker, piece.number) else {
        panic!("a body that nobody has was dressed")
    };
    assert!(sentence.japanese.contains("両立"), "{sentence}");
    assert!(!piece.path.exists());
}

#[test]
fn a_file_is_named_for_what_it_is() {
    for (typed, named) in [
        ("a", "a.pdf"),
        ("a.pdf", "a.pdf"),
        ("1.5", "1.5.pdf"),
        ("b.PDF", "b.PDF"),
    ] {
        assert_eq!(with_ending(Path::new(typed), "pdf"), Path::new(named));
    }
}
