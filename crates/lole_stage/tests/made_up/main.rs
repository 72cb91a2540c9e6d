//! A garment is one file: what is made up here, and never heard of anywhere else, is drafted, sewn, worn,
//! danced, cut out and colored as everything on the shelf.

mod frill;
mod vest;

use lole_costume::document::{Design, GarmentDesign};
use lole_costume::tailoring;
use lole_garment::Template;
use lole_stage::{Performance, Production};

fn design(template: &'static Template) -> Design {
    let mut design = Design::default();
    design.skirt.is_worn = false;
    design.garments = vec![GarmentDesign::new(template)];
    design
}

/// Half a second into her dance.
fn danced(design: &Design) -> Performance {
    let production = Production::new(design).expect("can be sewn");
    let mut performance = Performance::new(production).expect("can be put on");
    while performance.time() < 0.5 {
        performance.advance().expect("stays on the stage");
    }
    performance.pose_body();
    performance
}

#[test]
fn a_made_up_garment_of_shaped_pieces_is_worn() {
    let design = design(&vest::VEST);
    let performance = danced(&design);
    let [vest] = &performance.production().dressed[..] else {
        panic!("one garment is sewn on her");
    };
    assert_eq!(vest.name, "vest");
    let count = vest.dressed.particle_count();
    assert!((800..1800).contains(&count), "{count}");
    let found = performance.measure();
    assert!(found.strain.p99 < 0.1, "{:?}", found.strain);
    assert!(found.skin.worst_depth < 5.0e-3, "{:?}", found.skin);
    let settings = design.motion_settings();
    assert_eq!(settings.chest_room_degrees, 7.0, "hands keep clear of it");
}

#[test]
fn a_made_up_garment_that_is_gathered_is_worn() {
    let design = design(&frill::FRILL);
    let performance = danced(&design);
    let [frill] = &performance.production().garments[..] else {
        panic!("one rectangle is gathered");
    };
    assert_eq!(frill.name, "frill");
    let columns = frill.sewn.spec.grid.column_count as usize;
    let positions = performance.garment_positions(frill);
    let hem = &positions[positions.len() - columns..];
    let height = hem.iter().map(|place| place.y).sum::<f32>() / columns as f32;
    let drafted = 0.6 * frill.worn.worn_height.to_m_f32();
    assert!((height - drafted).abs() < 0.06, "{height} {drafted}");
    let found = performance.measure();
    assert!(found.strain.p99 < 0.1, "{:?}", found.strain);
    let print = design.garments[0].print.print();
    assert_eq!(print.ground, [0x20, 0x60, 0x40], "made in its own colors");
}

#[test]
fn made_up_garments_are_cut_out() {
    for template in [&vest::VEST, &frill::FRILL] {
        let design = design(template);
        let production = Production::new(&design).expect("can be sewn");
        let patterns = tailoring::patterns_of(&design, &production.dancer).expect("are drafted");
        let [pattern] = &patterns[..] else {
            panic!("one pattern");
        };
        assert_eq!(pattern.id, template.id);
        assert_eq!(pattern.name, template.name);
        assert!(!pattern.pattern.pieces.is_empty());
    }
}
