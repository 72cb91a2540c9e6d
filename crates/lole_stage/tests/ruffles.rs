//! Laws of a pāʻū with a ruffle: a flounce hangs on the skirt down to the hem that was asked for, a
//! second layer lies over it from just below its band.

use lole_costume::document::{Design, parse};
use lole_stage::{Performance, Production};

/// A dance in nothing but a pāʻū with a ruffle there.
fn design(place: &str) -> Design {
    let text = format!(
        "lole = 1\n[skirt]\nworn = \"no\"\n[[garment]]\nkind = \"pau-ruffle\"\nruffle = \"{place}\"\n"
    );
    parse(&text, "mine.lole").expect("a design")
}

/// Settles, and dances half a second.
fn danced(place: &str) -> Performance {
    let production = Production::new(&design(place)).expect("can be sewn");
    let mut performance = Performance::new(production).expect("can be danced");
    while performance.time() < 0.5 {
        performance.advance().expect("it stays on stage");
    }
    performance.pose_body();
    performance
}

#[test]
fn a_flounce_ends_at_the_hem_and_stands_out_below_its_seam() {
    let performance = danced("hem");
    let [garment] = &performance.production().garments[..] else {
        panic!("one garment");
    };
    let grid = &garment.sewn.spec.grid;
    let flounce = grid.flounce.expect("it has a flounce");
    let drafts = [garment.flounce.as_ref(), Some(&garment.draft)];
    let [ruffle, skirt] = drafts.map(|draft| draft.expect("it has a ruffle").flat_length.to_m());
    assert!((f64::from(flounce.fullness) - ruffle / skirt).abs() < 1e-6);
    // Two strips of whole millimeters each.
    assert!((ruffle - 1.5 * skirt).abs() <= 0.001, "{ruffle} {skirt}");
    let metrics = performance.measure();
    // In her stance all hems are lower than they are drafted for.
    let hems = [metrics, danced("header").measure()].map(|metrics| metrics.hem_height);
    assert!(
        (hems[0] - hems[1]).abs() < 0.01,
        "{hems:?} m above the floor"
    );
    assert!(metrics.strain.p99 < 0.12, "{:?}", metrics.strain);
    assert_eq!(metrics.skin.showing_body_vertices, 0);
    assert_eq!(performance.self_crossings(garment), Some(0));
    let positions = performance.garment_positions(garment);
    let around = |row: u32| {
        let place = |column: u32| positions[grid.index(row, column % grid.column_count)];
        let edges = (0..grid.column_count).map(|column| place(column).distance(place(column + 1)));
        edges.sum::<f32>()
    };
    let fuller = around(grid.row_count - 1) / around(flounce.seam_row);
    assert!((1.4..1.6).contains(&fuller), "{fuller}");
}

#[test]
fn a_second_layer_hangs_outside_of_the_skirt_from_below_its_band() {
    let performance = danced("layer");
    let [skirt, layer] = &performance.production().garments[..] else {
        panic!("two garments");
    };
    assert_eq!(
        [&skirt.name[..], &layer.name],
        ["pau_ruffle", "pau_ruffle_2"]
    );
    assert_eq!(skirt.chain, layer.chain, "they meet");
    let metrics = performance.measure();
    assert!(metrics.strain.p99 < 0.25, "{:?}", metrics.strain);
    assert_eq!(metrics.skin.showing_body_vertices, 0);
    assert!(performance.layer_inversions() < 40);
    let height = |garment: &lole_stage::Garment, row: usize| {
        let columns = garment.sewn.spec.grid.column_count as usize;
        let row = &performance.garment_positions(garment)[row * columns..][..columns];
        row.iter().map(|place| place.y).sum::<f32>() / columns as f32
    };
    let lowest_elastic = *skirt.sewn.elastic_rows.last().expect("it has elastics") as usize;
    let below = height(skirt, lowest_elastic) - height(layer, 0);
    assert!((0.0..0.04).contains(&below), "{below} m below the elastic");
    let last = layer.sewn.spec.grid.row_count as usize - 1;
    let drop = height(layer, 0) - height(layer, last);
    assert!((0.18..0.26).contains(&drop), "it hangs {drop} m deep");
}
