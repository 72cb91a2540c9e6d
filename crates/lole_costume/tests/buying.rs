//! Laws of what is bought: it is at least what is cut, on any cloth, or nothing is planned.

use std::sync::OnceLock;

use lole_body::{Dancer, Measurements};
use lole_costume::document::{Design, GarmentDesign};
use lole_costume::order::{DancerPlan, PlanError, PrintTotal, Settings, plan_dancer, prints};
use lole_garment::TEMPLATES;
use lole_geom::Length;
use lole_language::Bilingual as _;
use proptest::prelude::*;

/// Six dancers, by their stature and hips [cm], from the smallest to the largest.
static SIZES: [[f64; 2]; 6] = [
    [150.0, 84.0],
    [155.6, 91.2],
    [161.2, 98.4],
    [166.8, 105.6],
    [172.4, 112.8],
    [178.0, 120.0],
];

/// A costume of one garment on cloth of this width [cm], for one of the dancers.
fn design(template: &str, width_cm: f64, who: usize) -> Design {
    let mut design = Design::default();
    design.skirt.is_worn = false;
    let [stature, hip] = SIZES[who];
    design.dancer.stature_cm = Some(stature);
    design.dancer.hip_cm = Some(hip);
    design.garments = GarmentDesign::of_kind(template).into_iter().collect();
    for garment in &mut design.garments {
        garment.fabric.width_cm = width_cm;
    }
    design
}

fn plan(template: &str, width_cm: f64, who: usize) -> Result<DancerPlan, PlanError> {
    static DANCERS: OnceLock<Vec<Dancer>> = OnceLock::new();
    let dancers = DANCERS.get_or_init(|| {
        let built = (0..SIZES.len()).map(|who| {
            let design = design("malo", 110.0, who);
            let tape = Measurements::from_tape(&design.tape())?;
            Dancer::with_appearance(&tape, &design.appearance())
        });
        let built: Result<Vec<Dancer>, _> = built.collect();
        built.unwrap_or_else(|error| panic!("{error}"))
    });
    plan_dancer("花子", &design(template, width_cm, who), &dancers[who])
}

/// Thirty dancers of six sizes on cloth of 110 cm, and what they buy of its one cloth.
fn thirty(template: &str) -> (Vec<DancerPlan>, PrintTotal) {
    let plans = (0..SIZES.len()).map(|who| plan(template, 110.0, who));
    let plans: Vec<DancerPlan> = plans
        .collect::<Result<_, _>>()
        .unwrap_or_else(|error| panic!("{error}"));
    let plans: Vec<DancerPlan> = plans.iter().cycle().take(30).cloned().collect();
    let totals = prints(&plans, &design(template, 110.0, 0), &Settings::default());
    assert_eq!(totals.len(), 1, "{template}");
    (plans, totals[0].clone())
}

/// Everybody's pieces are in the strips once, beside each other and within the selvages.
fn check_strips(plans: &[DancerPlan], total: &PrintTotal) {
    let mut shares = vec![0; plans.len()];
    let mut sum = Length::ZERO;
    for strip in &total.strips {
        let mut top = 0.0;
        for share in &strip.shares {
            let [from, to] = share.across.map(Length::to_m);
            assert!(top < from + 1e-9 && from < to && share.along <= strip.length);
            top = to;
            shares[share.dancer] += 1;
        }
        assert!(top < total.width.to_m() + 1e-6);
        sum = sum + strip.length;
    }
    assert!((sum - total.needed).to_cm().abs() < 1e-6);
    assert!(total.needed.to_m() < total.apart.to_m() + 1e-6);
    assert!(total.needed <= total.bought.metric && total.needed <= total.bought.imperial);
    for (plan, count) in plans.iter().zip(shares) {
        let placed = plan.garments[0].plans[0].marker.placed.len();
        assert!(count == placed || count == 1, "{count} of {placed}");
    }
}

/// Every piece lies within the selvages and within what is bought.
fn check(plan: &DancerPlan) -> Result<(), String> {
    for garment in &plan.garments {
        for plan in &garment.plans {
            let marker = &plan.marker;
            if let Some(warning) = marker.warnings.first() {
                return Err(warning.to_string());
            }
            let (width, bought) = (marker.cloth.width.to_m(), marker.yardage);
            let mut cut = 0.0;
            for placed in &marker.placed {
                let bounds = placed.outline.bounds();
                let is_within = -1.0e-6 < bounds.y0 && bounds.y1 < width + 1.0e-6;
                if !is_within || bought.needed.to_m() + 1.0e-6 < bounds.x1 {
                    return Err(format!("{bounds:?} of {width} m"));
                }
                cut += placed.outline.signed_area() * f64::from(placed.layers);
            }
            // A gathered ring is cut as long as its cloth where two centimeters are missing.
            for (metric, missing) in [bought.metric, bought.imperial]
                .into_iter()
                .zip(bought.missing())
            {
                if metric + missing + Length::from_cm(0.06) < bought.needed
                    || 0.0201 < missing.to_m()
                {
                    return Err(format!("{bought:?}"));
                }
                if (metric + missing).to_m() * width + 1.0e-6 < cut {
                    return Err(format!("{cut} m² of {metric:?}"));
                }
            }
        }
    }
    Ok(())
}

/// Garments whose pieces are laid in a moment; of the others one is tried each time.
const RECTANGLES: [&str; 6] = [
    "pau-skirt",
    "pau-ruffle",
    "pau-kahiko",
    "pau-top",
    "malo",
    "kihei",
];

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(6) })]

    #[test]
    fn the_cloth_bought_is_at_least_the_cloth_cut(
        width in 72.0..150.0_f64, who in 0..SIZES.len(), any in 0..TEMPLATES.len(),
    ) {
        for template in RECTANGLES.into_iter().chain([TEMPLATES[any].id]) {
            match plan(template, width, who) {
                Ok(plan) => {
                    let checked = check(&plan);
                    prop_assert!(checked.is_ok(), "{template}: {}", checked.unwrap_err());
                }
                Err(error) => prop_assert!(error.is_too_wide(), "{template}: {error}"),
            }
        }
    }
}

/// What cannot be cut is said in both languages, with a width that would do.
#[test]
fn a_wrap_on_narrow_cloth_is_not_planned() {
    let error = plan("kihei", 72.0, 2).err();
    let error = error.unwrap_or_else(|| panic!("a kīhei was cut from 72 cm"));
    assert!(error.is_too_wide());
    assert!(error.to_string().contains("use cloth at least"), "{error}");
    assert!(
        error.japanese().contains("以上の布"),
        "{}",
        error.japanese()
    );
}

/// By hand: as many side by side as the widest allows, so a group needs no more lengths than that, each no
/// longer than the longest.
#[test]
fn a_group_cuts_narrow_things_side_by_side() {
    for template in ["malo", "pau-top", "raffia-skirt", "cellophane-skirt"] {
        let (plans, total) = thirty(template);
        check_strips(&plans, &total);
        let sizes = plans
            .iter()
            .flat_map(|plan| &plan.garments[0].plans[0].marker.placed);
        let sizes = sizes.map(|placed| placed.outline.bounds());
        let [longest, widest] = sizes.fold([0.0_f64; 2], |[long, wide], bounds| {
            [long.max(bounds.width()), wide.max(bounds.height())]
        });
        let side_by_side = ((1.10 + 1e-6) / widest).floor();
        let most = (30.0 / side_by_side).ceil() * longest;
        assert!(
            total.needed.to_m() <= most + 1e-6,
            "{template}: {:?} of {most} m",
            total.needed
        );
        let [needed, apart] = [total.needed, total.apart].map(Length::to_m);
        assert!(
            side_by_side < 2.0 || 1.5 * needed < apart,
            "{template}: {needed} of {apart} m"
        );
    }
}

/// What is as wide as the cloth gains nothing and loses nothing.
#[test]
fn a_group_never_needs_more_than_its_dancers_apart() {
    for template in ["pau-skirt", "pau-ruffle", "blouse"] {
        let (plans, total) = thirty(template);
        check_strips(&plans, &total);
    }
}

/// Thousands are laid in a moment, and the same again.
#[test]
fn a_thousand_dancers_are_laid_alike_each_time() {
    let (plans, _) = thirty("malo");
    let many: Vec<DancerPlan> = plans.iter().cycle().take(1000).cloned().collect();
    let design = design("malo", 110.0, 0);
    let settings = Settings {
        bolt_length: Some(Length::from_m(50.0)),
        ..Settings::default()
    };
    let total = prints(&many, &design, &settings);
    check_strips(&many, &total[0]);
    assert_eq!(total, prints(&many, &design, &settings));
    let strips: usize = total[0].bolts.iter().map(Vec::len).sum();
    assert_eq!(strips, total[0].strips.len());
    for bolt in &total[0].bolts {
        let cut: f64 = bolt
            .iter()
            .map(|&strip| total[0].strips[strip].length.to_m())
            .sum();
        assert!(cut < 50.0 + 1e-6);
    }
}
