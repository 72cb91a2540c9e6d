//! Products of a small design, made by the thread that the window has.

use std::time::Duration;

use super::*;

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
fn every_product_of_a_dancer_is_written_to_its_place_with_progress() {
    let mut maker = Maker::start(|| {});
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
    let mut maker = Maker::start(|| {});
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
    let mut maker = Maker::start(|| {});
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
fn what_cannot_be_made_says_why() {
    let mut maker = Maker::start(|| {});
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
