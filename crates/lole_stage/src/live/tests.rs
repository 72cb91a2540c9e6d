//! Laws of a show: what is kept and what begins anew when something else is wished.

use std::sync::LazyLock;

use lole_costume::document::{MethodName, parse};
use lole_garment::dress::Division;
use lole_hula::DanceStep;
use lole_pattern::Alteration;

use super::*;

/// A coarse skirt, so that a test is quick.
fn design() -> Design {
    let mut design = Design::default();
    design.skirt.column_count = 96;
    design.skirt.row_count = 24;
    design
}

/// Sewn once for all tests.
static PRODUCTION: LazyLock<Arc<Production>> =
    LazyLock::new(|| Arc::new(Production::new(&design()).unwrap()));

fn fresh() -> Show {
    Show::of(Arc::clone(&PRODUCTION)).unwrap()
}

fn dancing() -> Show {
    let mut show = fresh();
    show.settle().unwrap();
    for _ in 0..90 {
        show.advance().unwrap();
    }
    show
}

fn hips(show: &Show) -> Vec3 {
    show.bones()[0][0]
}

/// Farthest that the hips go in one frame of the next second [m].
fn jerk(show: &mut Show) -> f32 {
    let mut farthest = 0.0_f32;
    for _ in 0..60 {
        let before = hips(show);
        show.advance().unwrap();
        farthest = farthest.max(hips(show).distance(before));
    }
    farthest
}

#[test]
fn another_step_tempo_and_method_keep_dancer_and_cloth_where_they_are() {
    let mut show = dancing();
    let undisturbed = jerk(&mut show);
    for step in [DanceStep::Ami, DanceStep::Uwehe, DanceStep::Kao] {
        let mut wished = show.design().clone();
        wished.motion.step = step;
        wished.motion.tempo_bpm += 20.0;
        assert_eq!(show.wish(&wished).unwrap(), Wish::Granted);
        assert!(jerk(&mut show) < 2.5 * undisturbed, "{step:?}");
    }
    let before = show.cloth_positions().to_vec();
    let mut wished = show.design().clone();
    wished.method.name = MethodName::FbEuler;
    wished.fabric.drag_per_s = Some(3.0);
    assert_eq!(show.wish(&wished).unwrap(), Wish::Granted);
    assert_eq!(show.cloth_positions(), before);
    show.advance().unwrap();
    let moved = (before.iter().zip(show.cloth_positions()))
        .map(|(a, b)| a.distance(*b))
        .fold(0.0, f32::max);
    // An edge at the puckers that the one method leaves strained is let go by the other.
    assert!(moved < 0.15, "{moved} m in one frame");
}

#[test]
fn a_new_tempo_goes_on_from_the_same_count() {
    let mut show = dancing();
    let mut wished = show.design().clone();
    wished.motion.tempo_bpm *= 1.5;
    let before = show.pose();
    show.wish(&wished).unwrap();
    let apart = (before.rotations.iter().zip(&show.pose().rotations))
        .map(|(a, b)| 1.0 - a.dot(*b).abs())
        .fold(0.0, f32::max);
    assert!(apart < 1e-5, "{apart}");
}

#[test]
fn a_choreography_goes_on_when_what_comes_later_changes_and_begins_anew_else() {
    let part = |step, beat_count| PartDesign {
        step,
        beat_count,
        ..PartDesign::default()
    };
    let mut show = fresh();
    let mut wished = show.design().clone();
    wished.motion.parts = vec![part(DanceStep::Kaholo, 8), part(DanceStep::Ami, 8)];
    show.wish(&wished).unwrap();
    show.settle().unwrap();
    assert_eq!(show.part(), None);
    // Two counts of lead-in, then two of the first part.
    for _ in 0..180 {
        show.advance().unwrap();
    }
    assert_eq!(show.part().map(|part| part.index), Some(0));
    let time = |show: &Show| show.layers.last().map_or(0.0, |layer| layer.time);
    let before = time(&show);
    wished.motion.parts[1].step = DanceStep::Kao;
    show.wish(&wished).unwrap();
    assert!((time(&show) - before).abs() < 1e-6);
    wished.motion.parts[0].facing_deg = 45.0;
    show.wish(&wished).unwrap();
    // After the lead-in, at most a count late: the beat goes on.
    assert!(time(&show) < 3.01 * 60.0 / 80.0, "{}", time(&show));
}

#[test]
fn parts_follow_each_other_by_their_counts_and_end() {
    let mut design = design();
    design.motion.parts = [8, 16]
        .map(|beat_count| PartDesign {
            beat_count,
            ..PartDesign::default()
        })
        .to_vec();
    design.motion.tempo_bpm = 60.0;
    let dance = Danced::new(&design, &PRODUCTION.dancer).unwrap();
    let part = |time| part_at(&dance, &design.motion.parts, time);
    let indices = [1.9, 2.1, 9.9, 10.1, 25.9, 26.1].map(|time| part(time).map(|part| part.index));
    assert_eq!(indices, [None, Some(0), Some(0), Some(1), Some(1), None]);
    for (time, share) in [(2.0, 0.0), (6.0, 0.5), (10.0, 0.0), (22.0, 0.75)] {
        let now = part(time).unwrap();
        assert!((now.share - share).abs() < 1e-3, "{time} s: {now:?}");
    }
}

#[test]
fn another_cut_or_dancer_asks_for_sewing_and_changes_nothing() {
    let mut show = fresh();
    let mut wished = design();
    wished.skirt.gather_ratio = 3.0;
    assert_eq!(show.wish(&wished).unwrap(), Wish::Resew);
    wished = design();
    wished.dancer.stature_cm = Some(170.0);
    assert_eq!(show.wish(&wished).unwrap(), Wish::Resew);
    assert_eq!(*show.design(), design());
}

/// A garment as the least document lists it.
fn listed(kind: &str) -> GarmentDesign {
    let text = format!("lole = 1\n[[garment]]\nkind = \"{kind}\"\n");
    parse(&text, "garment").unwrap().garments.remove(0)
}

#[test]
fn a_lei_before_a_garment_in_the_list_leaves_each_its_place() {
    let mut design = design();
    design.garments = vec![listed("kihei")];
    let mut show = Show::new(&design).unwrap();
    let cloth = |show: &Show| show.surfaces()[..2].to_vec();
    let before = cloth(&show);
    design.garments.insert(0, listed("lei"));
    assert_eq!(show.wish(&design).unwrap(), Wish::Granted);
    let production = show.production();
    assert_eq!(production.design.garments, design.garments);
    assert_eq!(production.dressed[0].listed, 1);
    assert_eq!(cloth(&show), before);
}

#[test]
fn a_lei_is_put_on_and_taken_off_without_a_needle() {
    let mut show = dancing();
    let mut alone = dancing();
    let cloth = |show: &Show| show.cloth_positions().to_vec();
    for kinds in [&["lei"][..], &["lei-poo", "kupee"], &[]] {
        let mut wished = show.design().clone();
        wished.garments = kinds.iter().map(|kind| listed(kind)).collect();
        let before = cloth(&show);
        assert_eq!(show.wish(&wished).unwrap(), Wish::Granted, "{kinds:?}");
        assert_eq!(show.production().adornments.len(), kinds.len());
        assert_eq!(show.design().garments.len(), kinds.len());
        assert_eq!(cloth(&show), before, "it hangs as it did");
        for show in [&mut show, &mut alone] {
            show.advance().unwrap();
        }
        assert_eq!(cloth(&show), cloth(&alone), "and goes on so");
    }
    // What a lei stands for comes back without it.
    let kinds = |show: &Show| show.production().dancer.skin.parts.len();
    assert_eq!(kinds(&show), kinds(&alone));
    let mut again = show.restarted().unwrap();
    again.advance().unwrap();
    assert_eq!(again.production().adornments.len(), 0);
}

#[test]
fn cloth_follows_the_hand_that_holds_it_and_hangs_again_when_let_go() {
    let mut show = fresh();
    show.settle().unwrap();
    let grid = show.production().skirt().unwrap().sewn.spec.grid;
    let particle = grid.index(grid.row_count - 1, 48);
    let at = |show: &Show| show.cloth_positions()[particle];
    let rest = at(&show);
    let hand = rest + Vec3::new(0.0, 0.15, 0.10);
    show.pull(Some(Pull {
        particle: u32::try_from(particle).unwrap(),
        hand,
    }))
    .unwrap();
    for _ in 0..60 {
        show.advance().unwrap();
    }
    assert!(at(&show).distance(hand) < 1e-3, "{}", at(&show) - hand);
    show.pull(None).unwrap();
    for _ in 0..120 {
        show.advance().unwrap();
    }
    assert!(0.1 < at(&show).distance(hand));
}

/// Holds a particle and dances on until the hand is where it was drawn to.
fn draw(show: &mut Show, particle: u32, hand: Vec3) {
    show.pull(Some(Pull { particle, hand })).unwrap();
    dance(show, 40);
    let off = show.particles()[particle as usize] - hand;
    assert!(off.length() < 1e-3, "{off}");
}

fn dance(show: &mut Show, frame_count: u32) {
    for _ in 0..frame_count {
        show.advance().unwrap();
    }
}

/// What is sewn from shaped pieces is held as the skirt is, and let go of.
#[test]
fn a_dress_follows_the_hand_that_holds_it_and_hangs_again_when_let_go() {
    let mut design = Design::default();
    design.skirt.is_worn = false;
    design.garments = vec![listed("muumuu")];
    let production = Production::divided(&design, Division::Half).unwrap();
    let mut show = Show::of(production).unwrap();
    show.settle().unwrap();
    let lowest = |show: &Show| {
        let all = (0_u32..).zip(show.particles());
        all.min_by(|a, b| a.1.y.total_cmp(&b.1.y)).unwrap().0
    };
    let particle = lowest(&show);
    let at = |show: &Show| show.particles()[particle as usize];
    let hand = at(&show) + Vec3::new(0.0, 0.20, 0.0);
    draw(&mut show, particle, hand);
    let strained = show.strain();
    assert_eq!(strained.len(), show.particles().len());
    assert!(strained.iter().all(|strain| strain.is_finite()));
    show.pull(None).unwrap();
    dance(&mut show, 40);
    assert!(0.1 < at(&show).distance(hand));
    assert!(0.0 < show.vitals().potential_energy, "a dress has weight");
}

/// Strands are held, weighed and colored as cloth is.
#[test]
fn a_skirt_of_leaves_follows_the_hand_and_falls_again_when_let_go() {
    let mut design = Design::default();
    design.skirt.is_worn = false;
    design.garments = vec![listed("ti-leaf-skirt")];
    let mut show = Show::of(Production::new(&design).unwrap()).unwrap();
    show.settle().unwrap();
    let production = show.production();
    let adornment = &production.adornments[0];
    assert_eq!(adornment.particles, 0..show.particles().len());
    let tips = (0_u32..).zip(show.particles());
    let (particle, &tip) = tips.min_by(|a, b| a.1.y.total_cmp(&b.1.y)).unwrap();
    let at = |show: &Show| show.particles()[particle as usize];
    let hand = tip + Vec3::new(0.0, 0.15, 0.1);
    draw(&mut show, particle, hand);
    let strained = show.strain();
    assert_eq!(strained.len(), show.particles().len());
    // Twelve slices of a frame let a leaf give a little, and no more where a hand has it.
    assert!(strained.iter().all(|strain| strain.abs() < 0.3));
    let mut drawn = production.surfaces().zip(show.surfaces());
    let (surface, [vertices, _]) = drawn.find(|(it, _)| !it.rides_on_bones()).unwrap();
    assert_eq!(surface.by_vertex(&strained).len(), vertices.len());
    show.pull(None).unwrap();
    dance(&mut show, 60);
    assert!(0.05 < at(&show).distance(hand));
    assert!(0.0 < show.vitals().potential_energy, "leaves have weight");
}

/// A lei that is put on while it is danced is held as one that was there from the start.
#[test]
fn a_lei_put_on_later_is_held() {
    let mut show = fresh();
    let cloth = show.particles().len();
    let mut wished = show.design().clone();
    wished.garments.push(listed("lei"));
    assert!(matches!(show.wish(&wished), Ok(Wish::Granted)));
    assert!(cloth < show.particles().len());
    show.advance().unwrap();
    let particle = u32::try_from(show.particles().len() - 1).unwrap();
    let hand = show.particles()[particle as usize] + Vec3::new(0.0, 0.05, 0.1);
    draw(&mut show, particle, hand);
    // It is taken off while it is held: the hand is empty, and may be let go or drawn on.
    let without = fresh().design().clone();
    assert!(matches!(show.wish(&without), Ok(Wish::Granted)));
    assert_eq!(show.particles().len(), cloth);
    show.pull(Some(Pull { particle, hand })).unwrap();
    dance(&mut show, 2);
    show.pull(None).unwrap();
    dance(&mut show, 2);
}

#[test]
fn a_restarted_show_repeats_itself_bit_for_bit() {
    let mut first = fresh();
    for _ in 0..20 {
        first.advance().unwrap();
    }
    let mut second = first.restarted().unwrap();
    for _ in 0..20 {
        second.advance().unwrap();
    }
    assert_eq!(first.cloth_positions(), second.cloth_positions());
}

#[test]
fn energy_of_motion_falls_while_the_skirt_settles() {
    let mut show = fresh();
    let mut energies = Vec::new();
    while show.time() < 0.0 {
        show.advance().unwrap();
        energies.push(show.vitals().kinetic_energy);
    }
    let highest = energies.iter().copied().fold(0.0, f32::max);
    assert!(energies.last().is_some_and(|last| *last < 0.05 * highest));
    assert!(0.0 < show.vitals().potential_energy);
}

/// An alteration sews anew what is fitted, and nothing where nothing is.
#[test]
fn alterations_need_a_needle_where_something_is_fitted() {
    let plain = Design::default();
    let altered = |design: &Design| Design {
        alterations: design.alterations.with_cm(Alteration::BroadBack, 1.0),
        ..design.clone()
    };
    assert!(!needs_sewing(&plain, &altered(&plain)));
    let mut fitted = plain;
    fitted.garments = GarmentDesign::of_kind("blouse").into_iter().collect();
    assert!(needs_sewing(&fitted, &altered(&fitted)));
    assert!(!needs_sewing(&fitted, &fitted.clone()));
}

/// Face, hair, makeup and colors are another picture of the same body: nothing is sewn, no cloth moves, and a flower that
/// was in the hair is in it still.
#[test]
fn other_hair_and_makeup_need_no_needle() {
    let mut show = dancing();
    let before = show.cloth_positions().to_vec();
    let skin = show.production().dancer.skin.body_triangles();
    let mut wished = show.design().clone();
    wished.dancer.hair = HairStyle::Long;
    wished.dancer.makeup = Makeup::Stage;
    wished.dancer.age_years = Some(67.0);
    wished.face.seed = 12;
    wished.dancer.leotard_color = Some([120, 20, 30]);
    assert_eq!(show.wish(&wished).unwrap(), Wish::Granted);
    assert_eq!(show.cloth_positions(), before);
    let production = show.production();
    assert_eq!(production.dancer.skin.body_triangles(), skin);
    assert_eq!(production.dancer.appearance, wished.appearance());
    let as_sewn = Production::new(&wished).unwrap();
    assert_eq!(production.dancer, as_sewn.dancer);
    show.advance().unwrap();
}
