//! Any text is a sweep whose first and last runs can be named, or one sentence.

#![no_main]

use libfuzzer_sys::fuzz_target;
use lole_batch::{Plan, Sweep};

fuzz_target!(|text: &str| {
    let sweep = Sweep::read(text, "sweep.toml");
    let plan = sweep.and_then(|sweep| Plan::new(sweep, "lole = 1\n", "design.lole"));
    match plan {
        Ok(plan) => drop([plan.run(0, 0), plan.run(plan.run_count() - 1, 0)]),
        Err(error) => assert!(!error.0.to_string().contains('\n')),
    }
});
