//! Laws of plans: every run is a design, and what is none is refused before anything runs.

use std::collections::BTreeSet;

use proptest::prelude::{prop_assert, prop_assert_eq, proptest};

use super::*;

const BASE: &str = "lole = 1\n[skirt]\ncolumn_count = 96\nrow_count = 40\n";

fn plan(sweep: &str) -> Result<Plan, SweepError> {
    let sweep = Sweep::read(&format!("lole_sweep = 1\n{sweep}"), "s.toml")?;
    Plan::new(sweep, BASE, "base.lole")
}

proptest! {
    /// Whatever is drawn inside the ranges is a design with those values.
    #[test]
    fn every_run_of_a_hypercube_is_a_design(count in 1_u64..30, seed in 0_u64..1000) {
        let plan = plan(&format!(
            "kind = \"latin-hypercube\"\ncount = {count}\nseed = {seed}\n\
             [[axis]]\nkey = \"skirt.gather_ratio\"\nfrom = 1\nto = 5\n\
             [[axis]]\nkey = \"skirt.elastic_row_count\"\nfrom = 1\nto = 6\n\
             [[axis]]\nkeys = [\"fabric.bend_warp_un_m\", \"fabric.bend_weft_un_m\"]\nfrom = 0.5\nto = 200\nscale = \"log\"\n\
             [[axis]]\nkey = \"print.colorway\"\nvalues = [\"red\", \"blue\"]\n"
        ))
        .unwrap();
        let mut ids = BTreeSet::new();
        for number in 0..count {
            let run = plan.run(number, 7);
            let design = document::parse(&run.document, "run").unwrap();
            prop_assert_eq!(run.values[0].as_float(), Some(design.skirt.gather_ratio));
            prop_assert_eq!(run.values[1].as_integer(), Some(i64::from(design.skirt.elastic_row_count)));
            prop_assert_eq!(design.fabric.bend_warp_un_m, design.fabric.bend_weft_un_m);
            prop_assert_eq!(design.skirt.column_count, 96);
            prop_assert_eq!(&run, &plan.run(number, 7));
            prop_assert!(plan.run(number, 8).id != run.id, "other files make another run");
            ids.insert(run.id);
        }
        prop_assert_eq!(ids.len() as u64, count);
    }
}

#[test]
fn what_the_design_does_not_take_is_refused_before_anything_runs() {
    let cases = [
        (
            "skirt.gather_ratoi",
            "values = [2]",
            "did you mean gather_ratio",
        ),
        ("skirtt.gather_ratio", "values = [2]", "there is no such"),
        ("skirt.gather_ratio", "values = [2, 50]", "out of range"),
        (
            "skirt.gather_ratio",
            "from = 1\nto = 1e300\ncount = 3",
            "out of range",
        ),
        ("skirt.column_count", "values = [96.5]", "96.5"),
        ("skirt.gather_ratio", "values = [\"wide\"]", "number"),
        ("garment.1.ease_cm", "values = [2]", "no such place"),
        ("motion.step", "values = [\"kaholoo\"]", "kaholo"),
    ];
    for (key, values, word) in cases {
        let error = plan(&format!(
            "kind = \"grid\"\n[[axis]]\nkey = \"{key}\"\n{values}\n"
        ))
        .unwrap_err();
        let said = error.to_string();
        assert!(
            said.contains(word) && said.starts_with("[[axis]] 1"),
            "{said}"
        );
    }
    let fixed = plan(
        "kind = \"grid\"\n[[axis]]\nkey = \"skirt.gather_ratio\"\nvalues = [2]\n[fixed]\n\"motion.duration_s\" = -1\n",
    );
    assert!(fixed.unwrap_err().to_string().starts_with("[fixed]"));
    let broken = Plan::new(
        Sweep::read("lole_sweep = 1\nkind = \"grid\"\n[[axis]]\nkey = \"skirt.gather_ratio\"\nvalues = [2]\n", "s").unwrap(),
        "lole = 1\n[skirt]\nhem = 2\n",
        "base.lole",
    );
    assert!(broken.unwrap_err().to_string().starts_with("base.lole:3"));
}

#[test]
fn a_grid_of_whole_numbers_is_written_as_a_range() {
    let plan = plan(
        "kind = \"grid\"\n[[axis]]\nkey = \"skirt.column_count\"\nfrom = 64\nto = 128\ncount = 4\n",
    )
    .unwrap();
    let values: Vec<_> = (0..4)
        .map(|it| plan.run(it, 0).values[0].as_integer())
        .collect();
    assert_eq!(values, [64, 85, 107, 128].map(Some));
}
