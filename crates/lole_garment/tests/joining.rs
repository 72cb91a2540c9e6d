//! Laws of pieces that are wider than their cloth: what is cut fits the cloth, is as much as the whole, and is
//! joined by a step that counts; or nothing is cut, and one sentence says which cloth would do.

#[path = "bodies/any.rs"]
mod any;
mod bodies;

use kurbo::{Affine, ParamCurve as _};
use lole_garment::Fitting;
use lole_garment::template::{Options, TEMPLATES, Template};
use lole_geom::{Length, trig64};
use lole_language::Bilingual as _;
use lole_pattern::joining::{Fitted, fit_to_cloth};
use lole_pattern::marker::{Lay, Nap, TableCloth};
use lole_pattern::pattern::{Amount, NotionKind, Step};
use lole_pattern::piece::{Edge, Finish, LineKind, Mark};
use lole_pattern::{DraftError, Pattern, Piece};
use proptest::prelude::*;

use any::any_body;
use bodies::{BODIES, of_row};

fn cloth(width_cm: f64) -> TableCloth {
    TableCloth {
        width: Length::from_cm(width_cm),
        nap: Nap::AllWays,
        border: None,
        matched_repeat: None,
        lay: Lay::Single,
    }
}

fn drafted(template: &Template, row: &[f64; 27]) -> Pattern {
    let pattern = (template.draft)(&Fitting::by(&of_row(row)), &Options::of(template));
    pattern.unwrap_or_else(|error| panic!("{}: {error}", template.id))
}

/// Size of a piece across the cloth, allowances included [m].
fn across(piece: &Piece) -> f64 {
    let upright = Affine::rotate(-trig64::atan2(piece.grain.y, piece.grain.x));
    let outline = piece.unfolded().cut_polygon(2.0e-4).transformed(upright);
    outline.bounds().height()
}

/// Area of the cloth of all pieces, allowances included [m²].
fn area(pieces: &[Piece]) -> f64 {
    let of = |piece: &Piece| {
        let whole = piece.unfolded().cut_polygon(1.0e-4).signed_area();
        whole * f64::from(piece.cut.pieces())
    };
    pieces.iter().map(of).sum()
}

fn thread(pattern: &Pattern) -> f64 {
    let thread = pattern.notions.iter();
    let thread = thread.filter(|notion| notion.kind == NotionKind::Thread);
    thread
        .map(|notion| match notion.amount {
            Amount::Length(length) => length.to_m(),
            _ => 0.0,
        })
        .sum()
}

fn minutes(pattern: &Pattern) -> f64 {
    pattern.steps.iter().map(|step| step.minutes[0]).sum()
}

/// Cloth in parts over that of the whole: a strip of cloth has two allowances, and the ends of an open skirt
/// are hemmed.
const MOST_IN_JOINS: f64 = 1.12;

/// What was cut of a whole pattern on cloth of this width.
fn check(whole: &Pattern, width_cm: f64, fitted: &Fitted) -> Result<(), String> {
    let cut = fitted.parts.as_ref().unwrap_or(&fitted.pattern);
    for piece in &cut.pieces {
        let across_cm = 100.0 * across(piece);
        if width_cm + 0.01 < across_cm {
            return Err(format!("{} is {across_cm:.1} cm across", piece.id));
        }
        let ends = piece.edges.iter().map(|edge| {
            let ends = [edge.segments.first(), edge.segments.last()];
            ends.map(|segment| segment.map(|segment| (segment.start(), segment.end())))
        });
        let ends: Vec<_> = ends.collect();
        let is_closed = (0..ends.len()).all(|index| {
            let next = ends[(index + 1) % ends.len()][0].map(|ends| ends.0);
            ends[index][1].map(|ends| ends.1) == next
        });
        if !is_closed {
            return Err(format!("{} is open", piece.id));
        }
    }
    let [before, after] = [&whole.pieces, &cut.pieces].map(|pieces| area(pieces));
    // Joins take their allowances, and nothing else is more or less.
    if after < before - 1.0e-6 || before * MOST_IN_JOINS < after {
        return Err(format!("{before} m² become {after} m²"));
    }
    let joined = fitted.pattern.steps.len() - whole.steps.len();
    let is_counted = thread(whole) < thread(&fitted.pattern) || thread(whole) == 0.0;
    if fitted.parts.is_some() != (0 < joined)
        || fitted.parts.is_some() && (!is_counted || minutes(&fitted.pattern) <= minutes(whole))
    {
        return Err(format!("{joined} steps join {} pieces", cut.pieces.len()));
    }
    check_joins(&cut.pieces, &fitted.pattern.steps)
}

/// Cloth is joined right after it is cut, and sewn together with the allowance that its joins have.
fn check_joins(pieces: &[Piece], steps: &[Step]) -> Result<(), String> {
    let joins = pieces.iter().flat_map(|piece| &piece.edges);
    let joins: Vec<&Edge> = joins.filter(|edge| edge.id == "join").collect();
    if joins.is_empty() {
        return Ok(());
    }
    let is_join = |step: &Step| step.title.english == "Join what is wider than the cloth";
    let first = steps.iter().position(is_join);
    let cut = steps.iter().position(|step| step.cuts);
    if first.is_none() || first != cut.map(|cut| cut + 1) {
        return Err(format!("cut in step {cut:?}, joined in {first:?}"));
    }
    for join in joins {
        let said = format!("{:.1} cm of allowance", join.allowance.to_cm());
        let says = |step: &Step| step.by_machine.to_string().contains(&said);
        if !steps.iter().any(|step| is_join(step) && says(step)) {
            return Err(format!("no step sews a join with {said}"));
        }
    }
    Ok(())
}

/// A refusal names a piece that is wider than the cloth, and a width that would do.
fn check_refusal(error: &DraftError, width_cm: f64) -> Result<(), String> {
    let DraftError::WiderThanCloth { across_cm, .. } = error else {
        return Err(error.to_string());
    };
    let enough = format!("{:.0} cm", across_cm.ceil());
    let says = error.to_string().contains(&enough) && error.japanese().contains(&enough);
    if width_cm < *across_cm && says {
        Ok(())
    } else {
        Err(error.to_string())
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(150) })]

    #[test]
    fn what_is_cut_fits_its_cloth_or_nothing_is_cut(row in any_body(), width_cm in 70.0..150.0_f64) {
        for template in TEMPLATES {
            let whole = drafted(template, &row);
            let checked = match fit_to_cloth(whole.clone(), |_| cloth(width_cm)) {
                Ok(fitted) => check(&whole, width_cm, &fitted),
                Err(error) => check_refusal(&error, width_cm),
            };
            prop_assert!(checked.is_ok(), "{} on {width_cm} cm: {}", template.id, checked.unwrap_err());
        }
    }
}

/// Gathers and turned edges hide their joins: every skirt and dress can be cut from cloth of 90 cm.
#[test]
fn skirts_and_dresses_can_be_joined_on_narrow_cloth() {
    for (name, row) in &BODIES {
        for id in [
            "pau-skirt",
            "pau-ruffle",
            "pau-kahiko",
            "pau-top",
            "blouse",
            "muumuu",
            "holoku",
        ] {
            let template = TEMPLATES.iter().find(|one| one.id == id);
            let whole = drafted(template.unwrap_or_else(|| panic!("no {id}")), row);
            let fitted = fit_to_cloth(whole, |_| cloth(90.0));
            assert!(fitted.is_ok(), "{id} {name}: {:?}", fitted.err());
        }
    }
}

/// A wrap shows all of its cloth: it is not joined.
#[test]
fn a_wrap_is_refused_on_cloth_that_it_does_not_fit() {
    let template = TEMPLATES.iter().find(|one| one.id == "kikepa");
    let whole = drafted(
        template.unwrap_or_else(|| panic!("no kikepa")),
        &BODIES[2].1,
    );
    let error = fit_to_cloth(whole, |_| cloth(60.0)).err();
    let error = error.unwrap_or_else(|| panic!("a wrap was joined"));
    assert!(check_refusal(&error, 60.0).is_ok(), "{error}");
}

/// A print that has a right way up is not turned, and a join is marked on the whole piece.
#[test]
fn a_print_with_a_direction_is_not_turned() {
    let template = TEMPLATES.iter().find(|one| one.id == "pau-skirt");
    let whole = drafted(template.unwrap_or_else(|| panic!("no skirt")), &BODIES[2].1);
    let needed_cm = 100.0 * across(&whole.pieces[0]);
    let narrow = |cm| TableCloth {
        nap: Nap::OneWay,
        ..cloth(cm)
    };
    // The band's inside is some ten centimeters deep: more cannot be hidden there.
    assert!(fit_to_cloth(whole.clone(), |_| narrow(needed_cm - 20.0)).is_err());
    let fitted = fit_to_cloth(whole, |_| narrow(needed_cm - 2.0));
    let fitted = fitted.unwrap_or_else(|error| panic!("{error}"));
    let parts = fitted.parts.unwrap_or_else(|| panic!("nothing is joined"));
    let names: Vec<&str> = parts.pieces.iter().map(|piece| piece.id).collect();
    assert_eq!(names, ["panel", "facing"]);
    let is_join = |mark: &Mark| {
        matches!(
            mark,
            Mark::Line {
                kind: LineKind::Join,
                ..
            }
        )
    };
    assert!(fitted.pattern.pieces[0].marks.iter().any(is_join));
    let joins = parts.pieces.iter().flat_map(|piece| &piece.edges);
    let joins = joins.filter(|edge| edge.id == "join" && edge.finish == Finish::Seam);
    assert_eq!(joins.count(), 1);
}
