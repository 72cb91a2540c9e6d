//! Drape coefficients of three measured fabrics beside those that were measured of them: `cargo run
//! --example drape_calibration -p lole_cloth`.
//!
//! A calibration and no gate: of the fabrics bending alone was measured, in one direction; weight,
//! shear and its hysteresis are guesses, and no piece of cloth drapes twice alike.

#![allow(clippy::print_stdout, reason = "a measurement prints")]

#[path = "../tests/drape_support/mod.rs"]
mod drape_support;

use drape_support::square;
use lole_cloth::drape_test::RoundDrape;
use lole_cloth::{Fabric, Hysteresis};

/// One fabric, in the units of Kawabata's instruments where it was measured.
struct Measured {
    name: &'static str,
    /// Bending rigidity [gf·cm²/cm].
    rigidity: f32,
    /// Bending hysteresis `2HB` [gf·cm/cm].
    moment: f32,
    /// Drape coefficient [%].
    coefficient: Option<f32>,
    /// Shear stiffness and hysteresis [N/m], estimated.
    shear: [f32; 2],
}

/// Figures of Matsudaira et al. 2015, J. Textile Eng. 61(6), as quoted by others.
const MEASURED: [Measured; 3] = [
    Measured {
        name: "cotton broadcloth",
        rigidity: 0.118,
        moment: 0.124,
        coefficient: Some(82.9),
        shear: [90.0, 4.5],
    },
    Measured {
        name: "wool tropical",
        rigidity: 0.067,
        moment: 0.033,
        coefficient: None,
        shear: [40.0, 1.2],
    },
    Measured {
        name: "polyester faille",
        rigidity: 0.019,
        moment: 0.007,
        coefficient: Some(28.3),
        shear: [25.0, 0.6],
    },
];

/// 1 gf·cm²/cm [N·m], and 1 gf·cm/cm [N·m/m].
const RIGIDITY_UNIT: f32 = 9.806_65e-5;
const MOMENT_UNIT: f32 = 9.806_65e-3;

fn main() {
    println!(
        "fabric: measured; round, elastic; square, elastic, with bending and shear hysteresis"
    );
    for fabric in MEASURED {
        let bend = fabric.rigidity * RIGIDITY_UNIT;
        let elastic = Fabric {
            areal_density: 0.12,
            thickness: 3.0e-4,
            stretch: [500.0; 2],
            shear: fabric.shear[0],
            bend: [bend; 2],
            twist: bend,
            hysteresis: Hysteresis::NONE,
            friction: 0.0,
            cloth_friction: 0.0,
            drag_rate: 0.0,
        };
        let rubbing = Fabric {
            hysteresis: Hysteresis {
                bend: [fabric.moment * MOMENT_UNIT; 2],
                shear: fabric.shear[1],
            },
            ..elastic
        };
        let [in_round, plain, held] = [
            RoundDrape::JIS.hang(elastic).expect("a sound piece"),
            square(elastic, RoundDrape::JIS),
            square(rubbing, RoundDrape::JIS),
        ];
        let measured =
            (fabric.coefficient).map_or_else(|| "-".to_owned(), |share| format!("{share:.1} %"));
        let shown = |hung: lole_cloth::drape_test::Hung| {
            format!("{:.1} % in {} folds", 100.0 * hung.coefficient, hung.folds)
        };
        println!(
            "{}: {measured}; {}; {}, {}",
            fabric.name,
            shown(in_round),
            shown(plain),
            shown(held)
        );
    }
}
