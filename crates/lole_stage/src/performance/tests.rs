//! Laws of a performance: rest, wind and whoever wears no skirt.

use super::*;

#[test]
fn the_film_s_skirt_is_at_rest_when_it_dances_and_stays_there() {
    let production = Production::new(&Design::default()).unwrap();
    let mut performance = Performance::new(production).unwrap();
    let mut frame_count = 0;
    while performance.time() < 0.0 {
        performance.advance().unwrap();
        frame_count += 1;
    }
    assert!(frame_count <= SETTLE_FRAMES, "{frame_count} frames");
    let stance = performance.production.dance.pose_at(0.0);
    let mut seen = vec![performance.cloth_positions().to_vec()];
    for _ in 0..4 {
        for _ in 0..FRAMES_PER_SECOND {
            performance.advance_in(stance.clone()).unwrap();
        }
        seen.push(performance.cloth_positions().to_vec());
    }
    let apart = |one: &[Vec3], other: &[Vec3]| {
        let squares = one.iter().zip(other).map(|(a, b)| a.distance_squared(*b));
        (squares.sum::<f32>() / one.len() as f32).sqrt()
    };
    // Folds sink into each other for some seconds, each less than the last.
    let whole = apart(&seen[0], &seen[4]);
    assert!(whole < 0.012, "{whole} m in four seconds");
    let last = apart(&seen[3], &seen[4]);
    assert!(last < 0.0025, "{last} m in the last of them");
}

/// Hash of a coarse skirt after half a second in this wind, and how far its hem has swung [m].
fn blown(change: impl Fn(&mut Design)) -> (u64, f32) {
    let mut design = Design::default();
    (design.skirt.column_count, design.skirt.row_count) = (96, 24);
    change(&mut design);
    let mut performance = Performance::new(Production::new(&design).unwrap()).unwrap();
    let start = performance.cloth_positions().to_vec();
    for _ in 0..30 {
        performance.advance().unwrap();
    }
    let hem = performance.cloth_positions().iter().zip(&start).rev();
    let swing = hem
        .take(96)
        .map(|(now, then)| (*now - *then).x)
        .sum::<f32>()
        / 96.0;
    (performance.state_hash(), swing.abs())
}

#[test]
fn a_dancer_without_skirt_rests_and_then_dances_in_the_wind() {
    let kihei = lole_costume::document::GarmentDesign::of_kind("kihei").unwrap();
    let danced = |speed: f64, gust_ratio: f64| {
        let mut design = Design::default();
        design.skirt.is_worn = false;
        design.garments.push(kihei.clone());
        design.wind.speed_m_per_s = speed;
        design.wind.gust_ratio = gust_ratio;
        if 0.0 < gust_ratio {
            design.wind.model = lole_costume::document::WindModel::Triangles;
        }
        let mut performance = Performance::new(Production::new(&design).unwrap()).unwrap();
        while performance.time() < 0.0 {
            performance.advance().unwrap();
        }
        for frame in 1..=12_u8 {
            performance.advance().unwrap();
            let time = f32::from(frame) * FRAME_SECONDS;
            assert!((performance.time() - time).abs() < 1e-5, "{frame}");
        }
        performance.dressed_positions(0).to_vec()
    };
    let apart = |one: &[Vec3], other: &[Vec3]| {
        let apart = one.iter().zip(other).map(|(a, b)| a.distance(*b));
        apart.fold(0.0, f32::max)
    };
    let (calm, storm, gusty) = (danced(0.0, 0.0), danced(8.0, 0.0), danced(8.0, 0.4));
    assert!(0.01 < apart(&calm, &storm));
    assert!(0.001 < apart(&storm, &gusty));
    assert_eq!(gusty, danced(8.0, 0.4));
}

#[test]
fn wind_on_triangles_moves_the_skirt_and_its_gusts_follow_the_seed() {
    let wind = |seed: u64, speed: f64| {
        blown(move |design| {
            design.wind.model = lole_costume::document::WindModel::Triangles;
            design.wind.speed_m_per_s = speed;
            design.wind.gust_ratio = 0.3;
            design.wind.seed = seed;
        })
    };
    let (calm, storm) = (wind(1, 0.0), wind(1, 8.0));
    assert!(calm.1 + 0.005 < storm.1, "{} and {} m", calm.1, storm.1);
    assert_eq!(storm, wind(1, 8.0));
    assert!(storm.0 != wind(2, 8.0).0);
}
