//! Laws of sweeps: hypercubes, grids and lists, and what is refused.

use proptest::prelude::{prop_assert, prop_assert_eq, proptest};

use super::*;

fn cube(count: u64, seed: u64, more: &str) -> Sweep {
    let text = format!(
        "lole_sweep = 1\nkind = \"latin-hypercube\"\ncount = {count}\nseed = {seed}\n\
         [[axis]]\nkey = \"skirt.gather_ratio\"\nfrom = 1\nto = 5\n{more}"
    );
    Sweep::read(&text, "s.toml").unwrap()
}

proptest! {
    /// The law of a Latin hypercube: every part of every axis is met once.
    #[test]
    fn every_part_of_an_axis_has_one_run(count in 1_u64..200, seed in 0_u64..1000) {
        let shares = cube(count, seed, "").shares().unwrap();
        let part = |share: &f64| (1..=count).filter(|&end| end as f64 <= share * count as f64).count();
        let mut parts: Vec<usize> = shares[0].iter().map(part).collect();
        parts.sort_unstable();
        prop_assert_eq!(parts, (0..shares[0].len()).collect::<Vec<_>>());
        prop_assert!(shares[0].iter().all(|it| (0.0..1.0).contains(it)));
    }

    #[test]
    fn another_axis_leaves_the_first_as_it_was(count in 1_u64..50, seed in 0_u64..100) {
        let more = "[[axis]]\nkey = \"motion.tempo_bpm\"\nfrom = 60\nto = 90\n";
        let (one, two) = (cube(count, seed, "").shares(), cube(count, seed, more).shares());
        prop_assert_eq!(&one.unwrap()[0], &two.unwrap()[0]);
    }

    /// Whatever stands there, a sentence comes back, never a panic or an endless list.
    #[test]
    fn any_text_is_read_or_refused(text in "[ -~\n]{0,200}") {
        if let Ok(sweep) = Sweep::read(&format!("lole_sweep = 1\n{text}"), "s.toml") {
            prop_assert!(sweep.run_count() <= MOST_RUNS);
        }
    }

    #[test]
    fn ranges_keep_their_ends_and_their_order(from in 0.001_f64..10.0, width in 0.001_f64..100.0, log in 0..2) {
        let span = Span::Between { from, to: from + width, is_log: log == 1 };
        let at = |share: f64| span.at(share).as_float().unwrap();
        prop_assert!((at(0.0) - from).abs() <= 1e-12 * from);
        prop_assert!((at(1.0) - from - width).abs() <= 1e-9 * (from + width));
        prop_assert!(at(0.25) < at(0.5) && at(0.5) < at(0.75));
    }
}

#[test]
fn a_grid_has_every_pair_once_and_a_list_goes_along() {
    let axes = "[[axis]]\nkey = \"a.b\"\nvalues = [1, 2]\n[[axis]]\nkey = \"a.c\"\nvalues = [\"x\", \"y\"]\n";
    let of = |kind: &str| {
        Sweep::read(&format!("lole_sweep = 1\nkind = \"{kind}\"\n{axes}"), "s").unwrap()
    };
    let all = |sweep: &Sweep| {
        let runs = (0..sweep.run_count()).map(|run| {
            let values = sweep.listed(run).into_iter().map(|it| it.to_string());
            values.collect::<Vec<_>>().join(" ")
        });
        runs.collect::<Vec<_>>().join(", ")
    };
    assert_eq!(all(&of("grid")), "1 \"x\", 1 \"y\", 2 \"x\", 2 \"y\"");
    assert_eq!(all(&of("list")), "1 \"x\", 2 \"y\"");
}

#[test]
fn a_hostile_axis_is_one_sentence() {
    let axis = "[[axis]]\nkey = \"skirt.gather_ratio\"\n";
    refused(&[
        ("kind = \"grid\"\n".to_owned(), "axis"),
        (
            "kind = \"grid\"\naxis = []\n".to_owned(),
            "nothing is varied",
        ),
        (
            format!("kind = \"spiral\"\n{axis}values = [1]\n"),
            "s.toml:2",
        ),
        (
            format!("kind = \"grid\"\n{axis}values = []\n"),
            "values is empty",
        ),
        (
            format!("kind = \"grid\"\n{axis}values = [nan]\n"),
            "no value",
        ),
        (
            format!("kind = \"grid\"\n{axis}values = [[1]]\n"),
            "no value",
        ),
        (
            format!("kind = \"grid\"\n{axis}from = nan\nto = 2\ncount = 3\n"),
            "empty range",
        ),
        (
            format!("kind = \"grid\"\n{axis}from = 2\nto = 2\ncount = 3\n"),
            "empty range",
        ),
        (
            format!("kind = \"grid\"\n{axis}from = 0\nto = inf\ncount = 3\n"),
            "empty range",
        ),
        (
            format!("kind = \"grid\"\n{axis}from = 0\nto = 2\ncount = 3\nscale = \"log\"\n"),
            "above 0",
        ),
        (
            format!("kind = \"grid\"\n{axis}from = 0\nto = 2\n"),
            "write its count",
        ),
    ]);
}

#[test]
fn a_hostile_sweep_is_one_sentence() {
    let axis = "[[axis]]\nkey = \"skirt.gather_ratio\"\n";
    let huge = "from = 0\nto = 1\ncount = 1000000\n[[axis]]\nkey = \"skirt.hem_height_cm\"\nfrom = 0\nto = 1\ncount = 1000000\n";
    refused(&[
        (
            format!("kind = \"grid\"\n{axis}from = 0\nto = 2\ncount = 18446744073709551615\n"),
            "s.toml",
        ),
        (format!("kind = \"grid\"\n{axis}{huge}"), "out of range"),
        (
            format!("kind = \"latin-hypercube\"\n{axis}from = 0\nto = 2\n"),
            "needs its count",
        ),
        (
            format!("kind = \"latin-hypercube\"\ncount = 0\n{axis}from = 0\nto = 2\n"),
            "out of range",
        ),
        (
            format!("kind = \"grid\"\nseed = 2\n{axis}values = [1]\n"),
            "take them out",
        ),
        (
            format!("kind = \"grid\"\n{axis}values = [1]\n{axis}values = [2]\n"),
            "twice",
        ),
        (
            "kind = \"grid\"\n[[axis]]\nkey = \"skirt\"\nvalues = [1]\n".to_owned(),
            "names no key",
        ),
        (
            "kind = \"grid\"\n[[axis]]\nvalues = [1]\n".to_owned(),
            "either key or keys",
        ),
    ]);
}

/// Each of these texts is refused in one sentence, in both languages, that names the file and this word.
fn refused(cases: &[(String, &str)]) {
    for (text, word) in cases {
        let error = Sweep::read(&format!("lole_sweep = 1\n{text}"), "s.toml").unwrap_err();
        let said = error.to_string();
        assert!(said.contains(word), "{text}: {said}");
        assert!(said.starts_with("s.toml") && !said.contains('\n'), "{said}");
        assert!(!error.japanese().is_ascii());
    }
}

#[test]
fn sweeps_in_the_documents_can_be_read() {
    for (name, text, fence) in [
        (
            "README.md",
            include_str!("../../../../README.md"),
            "```toml sweep\n",
        ),
        (
            "batch.md",
            include_str!("../../../../docs/batch.md"),
            "```toml\nlole_sweep",
        ),
    ] {
        let (_, rest) = text.split_once(fence).expect(name);
        let (sample, _) = rest.split_once("```").expect(name);
        let sample = sample.trim_start_matches(" = 1\n");
        let sample = if sample.contains("lole_sweep") {
            sample.to_owned()
        } else {
            format!("lole_sweep = 1\n{sample}")
        };
        Sweep::read(&sample, name).unwrap();
    }
}
