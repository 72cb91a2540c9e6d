//! Laws of the measures of a dancer: her own tape comes back, they are those of a body, and every
//! template can be drafted from them.

use lole_body::{Dancer, Figure, Measurements, Tape};
use lole_garment::template::{Options, TEMPLATES};
use lole_garment::{Fitting, measures};
use lole_geom::Length;
use lole_pattern::{Measure, Measures};

/// The six bodies that every garment is tried on: name, figure, stature, bust, waist, hip [cm].
const BODIES: [(&str, Figure, [f64; 4]); 6] = [
    ("child", Figure::Child, [115.0, 58.0, 52.0, 62.0]),
    ("small", Figure::Woman, [150.0, 78.0, 61.0, 86.0]),
    ("mean", Figure::Woman, [158.0, 83.5, 66.0, 91.0]),
    ("tall", Figure::Woman, [172.0, 88.0, 70.0, 96.0]),
    ("large", Figure::Woman, [160.0, 112.0, 98.0, 118.0]),
    ("man", Figure::Man, [171.0, 92.0, 80.0, 94.0]),
];

fn of_body((_, figure, [stature, bust, waist, hip]): (&str, Figure, [f64; 4])) -> Measures {
    let cm = |value| Some(Length::from_cm(value));
    let tape = Tape {
        figure,
        stature: cm(stature),
        bust_girth: cm(bust),
        waist_girth: cm(waist),
        hip_girth: cm(hip),
        ..Tape::default()
    };
    let measurements = Measurements::from_tape(&tape).unwrap_or_else(|error| panic!("{error}"));
    let dancer = Dancer::new(&measurements).unwrap_or_else(|error| panic!("{error}"));
    measures(&dancer)
}

#[test]
fn every_template_can_be_drafted_to_six_dancers() {
    for body in BODIES {
        let measures = of_body(body);
        measures
            .check(Measure::ALL)
            .unwrap_or_else(|error| panic!("{}: {error}", body.0));
        for template in TEMPLATES {
            let pattern = (template.draft)(&Fitting::by(&measures), &Options::of(template));
            pattern.unwrap_or_else(|error| panic!("{} for {}: {error}", template.id, body.0));
        }
    }
}

/// The dancer's own tape comes back from her skin, and tapes of a body lie in their order.
#[test]
fn measures_are_those_of_the_body() {
    for body in BODIES {
        let (name, _, [stature, bust, waist, hip]) = body;
        let measures = of_body(body);
        let cm = |measure: Measure| measure.of(&measures).to_cm();
        assert!((cm(Measure::Stature) - stature).abs() < 3.0, "{name}");
        let taped = [
            (measures.bust_height, bust),
            (measures.waist_height, waist),
            (measures.hip_height, hip),
        ];
        for (height, girth) in taped {
            let found = measures
                .girth_at(height)
                .expect("tapes around the trunk")
                .to_cm();
            assert!((found - girth).abs() < 2.0, "{name}: {found} for {girth}");
        }
        let rising = [
            Measure::KneeHeight,
            Measure::HipHeight,
            Measure::HipBoneHeight,
            Measure::WaistHeight,
            Measure::BustHeight,
            Measure::ArmpitHeight,
            Measure::NeckHeight,
            Measure::Stature,
        ];
        assert!(
            rising.is_sorted_by(|low, high| cm(*low) < cm(*high)),
            "{name}"
        );
        // Means of surveys, and what no body is far from.
        assert!(
            (0.28..0.36).contains(&(cm(Measure::UpperArmGirth) / cm(Measure::BustGirth)))
                || name == "large",
            "{name}"
        );
        assert!(
            (0.20..0.27).contains(&(cm(Measure::NeckGirth) / stature)),
            "{name}"
        );
        assert!(
            (0.20..0.27).contains(&(cm(Measure::BackLength) / stature)),
            "{name}"
        );
        assert!(
            (0.0..9.0).contains(&(cm(Measure::FrontLength) - cm(Measure::BackLength))),
            "{name}"
        );
        assert!(
            (0.34..0.45).contains(&(cm(Measure::CrotchLength) / stature)),
            "{name}"
        );
    }
}
