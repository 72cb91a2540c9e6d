//! Laws of garments in layers on one dancer: sewing puts each outside of the one below, dancing keeps
//! the order and leaves the skin outside, and the bits are the same on any number of threads.

use lole_cloth::diagnose;
use lole_costume::document::{Design, GarmentDesign};
use lole_garment::template::{PAU_SKIRT, PAU_TOP};
use lole_stage::{Performance, Production};
use std::sync::{Arc, LazyLock};

/// A double skirt, coarse enough that the laws are quick, and a top as it is usually divided: in a
/// coarser one folds are deeper than a hand before the chest leaves room for.
fn design() -> Design {
    let mut under = GarmentDesign::new(&PAU_SKIRT);
    (under.fineness.column_count, under.fineness.row_count) = (160, 40);
    let top = GarmentDesign::new(&PAU_TOP);
    let mut design = Design::default();
    design.skirt.hem_height_cm = 34.0;
    design.skirt.gather_ratio = 2.0;
    (design.skirt.column_count, design.skirt.row_count) = (176, 32);
    design.garments = vec![under, top];
    design
}

static PRODUCTION: LazyLock<Arc<Production>> =
    LazyLock::new(|| Arc::new(Production::new(&design()).expect("can be sewn")));

#[test]
fn garments_are_sewn_from_the_skin_outward() {
    let names: Vec<&str> = (PRODUCTION.garments.iter())
        .map(|garment| garment.name.as_str())
        .collect();
    assert_eq!(names, ["pau_underskirt", "pau_skirt", "pau_top"]);
    assert_eq!(PRODUCTION.skirt().unwrap().name, "pau_skirt");
    let chains: Vec<usize> = (PRODUCTION.garments.iter())
        .map(|garment| garment.chain)
        .collect();
    assert_eq!(chains, [0, 0, 2], "the top ends above the skirts");
    let mut end = 0;
    for garment in &PRODUCTION.garments {
        assert_eq!(garment.particles.start, end);
        end = garment.particles.end;
        assert_eq!(
            garment.particles.len(),
            garment.sewn.spec.grid.particle_count()
        );
    }
    assert_eq!(PRODUCTION.particle_count(), end);
    let start = Performance::new(Arc::clone(&PRODUCTION)).unwrap();
    assert_eq!(start.layer_inversions(), 0);
}

#[test]
fn a_top_that_reaches_down_to_the_skirt_is_worn_over_it() {
    let mut design = design();
    let top = GarmentDesign::new(&PAU_TOP).with(&[("hem_height_cm", 82.0)]);
    design.garments[1] = top;
    let production = Production::new(&design).unwrap();
    assert!(production.garments.iter().all(|garment| garment.chain == 0));
    assert_eq!(Performance::new(production).unwrap().layer_inversions(), 0);
}

/// What one garment was like at worst over a dance.
#[derive(Debug, Default)]
struct Worst {
    crossings: usize,
    strain: f32,
    /// Sum over the looks.
    strains: f32,
}

#[test]
fn a_dance_keeps_the_order_the_cloth_whole_and_the_skin_covered() {
    let mut performance = Performance::new(Arc::clone(&PRODUCTION)).unwrap();
    while performance.time() < 0.0 {
        performance.advance().unwrap();
    }
    let (mut disordered, mut deepest, mut looks) = (0, 0.0_f32, 0.0);
    let mut garments: Vec<Worst> = PRODUCTION
        .garments
        .iter()
        .map(|_| Worst::default())
        .collect();
    for frame in 0..90 {
        performance.advance().unwrap();
        if frame % 6 == 0 {
            looks += 1.0;
            disordered = disordered.max(performance.layer_inversions());
            performance.pose_body();
            deepest = deepest.max(performance.measure().skin.worst_depth);
            for (worst, garment) in garments.iter_mut().zip(&PRODUCTION.garments) {
                let (spec, positions) =
                    (&garment.sewn.spec, performance.garment_positions(garment));
                let strain = diagnose::strain(spec, positions).p99;
                worst.strain = worst.strain.max(strain);
                worst.strains += strain;
                let crossings = diagnose::self_crossings(&spec.grid, positions).unwrap();
                worst.crossings = worst.crossings.max(crossings);
            }
        }
    }
    assert_eq!(disordered, 0, "particles in the wrong order");
    assert!(deepest < 0.000_5, "{deepest} m");
    for (worst, garment) in garments.iter().zip(&PRODUCTION.garments) {
        let mean = worst.strains / looks;
        assert_eq!(worst.crossings, 0, "crossings of {}", garment.name);
        assert!(worst.strain < 0.06, "{}: {worst:?}", garment.name);
        assert!(mean < 0.05, "{}: {mean}", garment.name);
    }
}

#[test]
fn three_garments_have_the_same_bits_on_one_two_and_three_threads() {
    let hash = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        let mut performance = Performance::new(Arc::clone(&PRODUCTION)).unwrap();
        pool.install(|| {
            for _ in 0..20 {
                performance.advance().unwrap();
            }
        });
        performance.state_hash()
    };
    let once = hash(1);
    assert_eq!(once, hash(2));
    assert_eq!(once, hash(3));
}

#[test]
fn a_mistake_in_a_garment_says_which_one() {
    let mut design = design();
    let top = GarmentDesign::new(&PAU_TOP).with(&[("upper_height_cm", 150.0)]);
    design.garments[1] = top;
    let error = Production::new(&design).err().unwrap();
    let sentence = error.to_string();
    assert!(
        sentence.starts_with("garment 2 of the list: the top would reach"),
        "{sentence}"
    );
    assert!(sentence.contains("lower upper_height_cm"), "{sentence}");
    let japanese = lole_language::Bilingual::japanese(&error);
    assert!(japanese.starts_with("2 枚目の服"), "{japanese}");
}
