//! Laws of the pāʻū draft, against figures from published sewing notes and worked by hand.

use std::fmt::Write as _;

use lole_geom::Length;
use lole_pattern::design::pau_skirt::{
    PauDraft, PauLine, PauMeasurements, PauOptions, PauWarning, draft_pau_skirt,
    longest_finished_length,
};
use lole_pattern::{DraftError, ElasticRatio, GatherRatio};
use proptest::prelude::*;

/// The default woman: hip 91 cm, worn on the front hip bones.
fn woman() -> PauMeasurements {
    PauMeasurements {
        hip_girth: Length::from_cm(91.0),
        worn_girth: Length::from_cm(83.0),
        worn_height: Length::from_cm(84.8),
    }
}

fn with_hip(hip_cm: f64) -> PauMeasurements {
    PauMeasurements {
        hip_girth: Length::from_cm(hip_cm),
        worn_girth: Length::from_cm(hip_cm * 0.91),
        ..woman()
    }
}

fn with_rows(elastic_row_count: u32) -> PauOptions {
    PauOptions {
        elastic_row_count,
        ..PauOptions::default()
    }
}

fn draft(measurements: &PauMeasurements, options: &PauOptions) -> PauDraft {
    draft_pau_skirt(measurements, options).expect("this skirt can be sewn")
}

#[track_caller]
fn assert_cm(length: Length, expected_cm: f64) {
    assert!(
        (length.to_cm() - expected_cm).abs() < 1e-6,
        "{} for {expected_cm}",
        length.to_cm()
    );
}

#[test]
fn yardage_follows_the_table_of_hips() {
    // hip, ratio, needed m, half yards bought (worked by hand from ratio × hip + 2 cm).
    let table = [
        (85.0, 4.0, 3.42, 4.0),
        (91.0, 4.0, 3.66, 4.0),
        (100.0, 4.0, 4.02, 4.5),
        (110.0, 4.0, 4.42, 5.0),
        (120.0, 4.0, 4.82, 5.5),
        (70.0, 4.0, 2.82, 3.5),
        (85.0, 3.0, 2.57, 3.0),
        (91.0, 3.0, 2.75, 3.0),
        (100.0, 3.0, 3.02, 3.5),
        (110.0, 3.0, 3.32, 4.0),
        (120.0, 3.0, 3.62, 4.0),
        (70.0, 3.0, 2.12, 2.5),
    ];
    for (hip_cm, ratio, needed_m, yards) in table {
        let gather_ratio = GatherRatio::new(ratio).unwrap();
        let options = PauOptions {
            gather_ratio,
            ..PauOptions::default()
        };
        let yardage = draft(&with_hip(hip_cm), &options).yardage;
        assert!(
            (yardage.needed.to_m() - needed_m).abs() < 1e-9,
            "hip {hip_cm} × {ratio}"
        );
        assert!(
            (yardage.imperial.to_yd() - yards).abs() < 1e-9,
            "hip {hip_cm} × {ratio}"
        );
        let shortfall = yardage.needed.to_cm() - yardage.metric.to_cm();
        assert!(
            (-10.0..=2.0 + 1e-9).contains(&shortfall),
            "hip {hip_cm} × {ratio}: {shortfall}"
        );
    }
}

#[test]
fn the_band_is_as_deep_as_its_casings() {
    for (row_count, depth_cm) in [(1, 3.5), (2, 7.5), (3, 11.5), (4, 15.5), (5, 19.5)] {
        assert_cm(draft(&woman(), &with_rows(row_count)).fold_depth, depth_cm);
    }
}

#[test]
fn a_75_cm_skirt_is_cut_92_cm_and_a_half_tall() {
    // 75 finished + 11.5 fold + 1 turned under + 5 hem.
    let worn_height = Length::from_cm(75.0 - 10.75 + 22.0);
    let drafted = draft(
        &PauMeasurements {
            worn_height,
            ..woman()
        },
        &PauOptions::default(),
    );
    assert_cm(drafted.finished_length, 75.0);
    assert_cm(drafted.cut_height, 92.5);
    assert!(drafted.warnings.is_empty(), "{:?}", drafted.warnings);
}

#[test]
fn the_longest_skirt_uses_the_whole_width_and_no_more() {
    for (width_cm, rows) in [(110.0, [92.5, 88.5, 84.5]), (90.0, [72.5, 68.5, 64.5])] {
        for (row_count, longest_cm) in (3..=5).zip(rows) {
            let options = PauOptions {
                fabric_width: Length::from_cm(width_cm),
                ..with_rows(row_count)
            };
            assert_cm(longest_finished_length(&options), longest_cm);
            for (extra_cm, fits) in [(-0.1, true), (0.1, false)] {
                let band_cm = draft(&woman(), &options)
                    .elastic_rows
                    .last()
                    .unwrap()
                    .from_fold;
                let worn_height =
                    Length::from_cm(longest_cm + extra_cm) - band_cm + options.hem_height;
                let drafted = draft(
                    &PauMeasurements {
                        worn_height,
                        ..woman()
                    },
                    &options,
                );
                let tall =
                    |warning: &PauWarning| matches!(warning, PauWarning::TallerThanCloth { .. });
                assert_eq!(
                    !drafted.warnings.iter().any(tall),
                    fits,
                    "{width_cm} {row_count}"
                );
            }
        }
    }
}

#[test]
fn three_elastics_for_86_cm_take_228_cm() {
    let measurements = PauMeasurements {
        worn_girth: Length::from_cm(86.0),
        ..woman()
    };
    let drafted = draft(&measurements, &PauOptions::default());
    assert_cm(drafted.elastic_rows[0].cut_length, 76.1);
    assert_cm(drafted.elastic_total, 228.3);
}

#[test]
fn the_hem_hangs_at_its_height_from_where_the_skirt_is_worn() {
    for hem_cm in [15.0, 22.0, 30.0] {
        for row_count in 1..=6 {
            let options = PauOptions {
                hem_height: Length::from_cm(hem_cm),
                ..with_rows(row_count)
            };
            let drafted = draft(&woman(), &options);
            let worn_row = drafted.elastic_rows.last().unwrap();
            let below = drafted.finished_length - worn_row.from_fold;
            assert_cm(woman().worn_height - below, hem_cm);
        }
    }
}

#[test]
fn the_usual_skirt_has_the_usual_length() {
    // Makers give 65 to 80 cm, 72 to 73 on the mean.
    let length_cm = draft(&woman(), &PauOptions::default())
        .finished_length
        .to_cm();
    assert!((72.0..75.0).contains(&length_cm), "{length_cm}");
}

#[test]
fn lines_lie_in_order_inside_the_piece() {
    let drafted = draft(&woman(), &with_rows(5));
    assert!(
        drafted
            .lines
            .is_sorted_by(|upper, lower| upper.from_edge < lower.from_edge)
    );
    let last = drafted.lines.last().unwrap();
    assert_eq!(last.kind, PauLine::HemFold);
    assert_cm(
        drafted.cut_height - last.from_edge,
        drafted.hem_depth.to_cm(),
    );
}

#[test]
fn a_spool_of_200_m_sews_two_skirts() {
    // 9 rounds of 3.66 m and one seam, three meters of thread to a stitched meter: about 100 m.
    let thread_m = draft(&woman(), &PauOptions::default()).thread.to_m();
    assert!((thread_m - 100.0).abs() < 3.0, "{thread_m}");
}

#[test]
fn what_cannot_be_sewn_is_refused_with_a_remedy() {
    let refused = |measurements: &PauMeasurements, options: &PauOptions| {
        draft_pau_skirt(measurements, options)
            .unwrap_err()
            .to_string()
    };
    let defaults = PauOptions::default();
    for (hip_cm, expected) in [
        (
            -91.0,
            "the hip girth is -91 cm; give a length between 40 cm and 200 cm",
        ),
        (f64::NAN, "the hip girth is NaN cm; give"),
        (f64::INFINITY, "the hip girth is inf cm; give"),
    ] {
        let measurements = PauMeasurements {
            hip_girth: Length::from_cm(hip_cm),
            ..woman()
        };
        let sentence = refused(&measurements, &defaults);
        assert!(sentence.starts_with(expected), "{sentence}");
    }
    assert!(refused(&woman(), &with_rows(0)).contains("use 1 to 6"));
    let high_hem = PauOptions {
        hem_height: Length::from_cm(84.0),
        ..defaults
    };
    assert!(refused(&woman(), &high_hem).contains("lower the hem"));
    let narrow = PauOptions {
        gather_ratio: GatherRatio::new(1.0).unwrap(),
        ..defaults
    };
    let belly = PauMeasurements {
        worn_girth: Length::from_cm(95.0),
        ..woman()
    };
    assert!(refused(&belly, &narrow).contains("raise the gather ratio above 1.04"));
    assert!(matches!(
        draft_pau_skirt(&belly, &narrow),
        Err(DraftError::TooNarrow { .. })
    ));
}

#[test]
fn an_elastic_that_cannot_pass_the_hips_is_said() {
    let slim = PauMeasurements {
        worn_girth: Length::from_cm(60.0),
        ..woman()
    };
    let warnings = draft(
        &slim,
        &PauOptions {
            elastic_ratio: ElasticRatio::new(0.8).unwrap(),
            ..PauOptions::default()
        },
    )
    .warnings;
    let stretch = warnings
        .iter()
        .find(|warning| matches!(warning, PauWarning::ElasticStretch { .. }))
        .unwrap();
    // 60 cm · 0.8 = 48 cm, and 91 cm / 1.8 = 50.6 cm.
    let english = stretch.to_string();
    assert!(
        english.contains("48.0 cm") && english.contains("91.0 cm") && english.contains("50.6 cm")
    );
    let japanese = lole_language::Bilingual::japanese(stretch);
    assert!(japanese.contains("ヒップ") && japanese.contains("50.6 cm"));
    assert!(draft(&woman(), &PauOptions::default()).warnings.is_empty());
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(256) })]

    #[test]
    fn bigger_hips_never_buy_less_cloth(hip_cm in 60.0..150.0_f64, more_cm in 0.0..20.0_f64) {
        let options = PauOptions::default();
        let smaller = draft(&with_hip(hip_cm), &options).yardage;
        let larger = draft(&with_hip(hip_cm + more_cm), &options).yardage;
        prop_assert!(smaller.metric <= larger.metric && smaller.imperial <= larger.imperial);
    }

    #[test]
    fn any_numbers_give_a_draft_or_a_sentence(
        numbers in proptest::array::uniform5(prop_oneof![-1e3..1e3_f64, any::<f64>()]),
        elastic_row_count in any::<u32>(),
    ) {
        let [hip, girth, height, hem_height, casing] = numbers.map(Length::from_cm);
        let measurements = PauMeasurements { hip_girth: hip, worn_girth: girth, worn_height: height };
        let options = PauOptions { hem_height, casing, elastic_row_count, ..PauOptions::default() };
        if let Ok(drafted) = draft_pau_skirt(&measurements, &options) {
            prop_assert!(Length::ZERO < drafted.finished_length);
            prop_assert!(drafted.cut_height.to_m().is_finite());
        }
    }
}

/// The draft as a tailor would write it on a card.
fn card(drafted: &PauDraft) -> String {
    let mut text = String::new();
    let mut row = |name: &str, length: Length| {
        let (cm, yd) = (length.to_cm(), length.to_yd());
        writeln!(text, "{name:<30}{cm:>9.2} cm {yd:>8.3} yd").expect("writing to a string");
    };
    row("cut along the selvage", drafted.cut_length);
    row("cut across, from the top edge", drafted.cut_height);
    row("around, sewn and flat", drafted.flat_length);
    row("finished, top fold to hem", drafted.finished_length);
    row("band, doubled", drafted.fold_depth);
    row("hem, doubled", drafted.hem_depth);
    row("cloth to buy, by 10 cm", drafted.yardage.metric);
    row("cloth to buy, by half yards", drafted.yardage.imperial);
    row("elastic, all rows", drafted.elastic_total);
    row("thread", drafted.thread);
    for (index, elastic) in (1..).zip(&drafted.elastic_rows) {
        row(
            &format!("elastic {index}, below the top fold"),
            elastic.from_fold,
        );
        row(&format!("elastic {index}, cut"), elastic.cut_length);
    }
    for line in &drafted.lines {
        row(&format!("at {}", line.kind.name()), line.from_edge);
    }
    for warning in &drafted.warnings {
        writeln!(text, "note: {warning}").expect("writing to a string");
    }
    text
}

#[test]
fn golden_of_the_default_draft() {
    lole_golden::check(
        "pau_skirt.txt",
        &card(&draft(&woman(), &PauOptions::default())),
    );
}
