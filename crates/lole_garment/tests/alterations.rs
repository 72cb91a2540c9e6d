//! What each alteration of a fitted garment does, and what it leaves alone.

mod bodies;

use lole_garment::Fitting;
use lole_garment::template::{Options, Template};
use lole_pattern::{Alteration, Alterations, DraftError, Pattern, Piece};

use bodies::{BODIES, of_row};

/// Lengths nearer than this are alike [m].
const ALIKE: f64 = 1.0e-9;
/// What a fitter does not see [m].
const UNSEEN: f64 = 4.0e-3;
/// The garments that alterations change.
const FITTED: [&str; 3] = ["blouse", "muumuu", "holoku"];

fn template(id: &str) -> &'static Template {
    Template::of_id(id).unwrap_or_else(|| panic!("no {id}"))
}

/// A garment of a body of the table, altered by so much [cm].
fn drafted(id: &str, row: &[f64; 27], by: (Alteration, f64)) -> Result<Pattern, DraftError> {
    let measures = of_row(row);
    let fitting = Fitting {
        alterations: Alterations::NONE.with_cm(by.0, by.1),
        ..Fitting::by(&measures)
    };
    let template = template(id);
    (template.draft)(&fitting, &Options::of(template))
}

/// The garment as it is and altered, on every body; one that an alteration does not go with is left out.
fn each(alteration: Alteration, cm: f64, mut check: impl FnMut(&str, &Pattern, &Pattern)) {
    let mut count = 0;
    for id in FITTED {
        for (name, row) in &BODIES {
            let plain = drafted(id, row, (alteration, 0.0)).unwrap_or_else(|e| panic!("{id}: {e}"));
            let altered = drafted(id, row, (alteration, cm));
            if let Ok(altered) = altered {
                check(&format!("{id} {name}"), &plain, &altered);
                count += 1;
            }
        }
    }
    assert!(
        12 <= count,
        "{alteration:?} by {cm} goes with {count} of 18"
    );
}

fn piece<'a>(pattern: &'a Pattern, id: &str) -> &'a Piece {
    let found = pattern.pieces.iter().find(|piece| piece.id == id);
    found.unwrap_or_else(|| panic!("no {id}"))
}

/// Length of an edge over all pieces of front or back that have it [m].
fn long(pattern: &Pattern, face: &str, edge: &str) -> f64 {
    let pieces = (pattern.pieces.iter()).filter(|piece| piece.id.starts_with(face));
    let edges = pieces.filter_map(|piece| piece.edge(edge));
    edges.map(lole_pattern::piece::Edge::length).sum()
}

/// Widest place of a piece, without the hem's flare: at its underarm [m].
fn underarm(pattern: &Pattern, id: &str) -> f64 {
    let edge = piece(pattern, id).edge("armhole");
    let start = edge.and_then(|edge| Some(kurbo::ParamCurve::start(edge.segments.first()?)));
    start.unwrap_or_else(|| panic!("no armhole")).x
}

fn is_same(one: &Piece, other: &Piece) -> bool {
    one.edges == other.edges
}

#[test]
fn nothing_altered_is_the_draft_itself() {
    for id in FITTED {
        let (_, row) = &BODIES[2];
        let measures = of_row(row);
        let plain = (template(id).draft)(&Fitting::by(&measures), &Options::of(template(id)));
        for alteration in Alteration::ALL {
            assert_eq!(drafted(id, row, (alteration, 0.0)), plain, "{id}");
        }
    }
}

#[test]
fn every_alteration_changes_every_fitted_garment_but_a_fold_has_no_sway_back() {
    for id in FITTED {
        let (_, row) = &BODIES[2];
        for alteration in Alteration::ALL {
            let [plain, altered] = [0.0, 2.0].map(|cm| drafted(id, row, (alteration, cm)));
            let changes = plain != altered;
            let hangs_on_fold = id == "muumuu" && alteration == Alteration::SwayBack;
            assert_eq!(changes, !hangs_on_fold, "{id} {alteration:?}");
        }
    }
}

#[test]
fn garments_that_are_not_fitted_stay_as_they_are() {
    for template in lole_garment::template::TEMPLATES {
        assert_eq!(template.is_fitted(), FITTED.contains(&template.id));
        if template.is_fitted() {
            continue;
        }
        let (_, row) = &BODIES[2];
        for alteration in Alteration::ALL {
            let [plain, altered] = [0.0, 2.0].map(|cm| drafted(template.id, row, (alteration, cm)));
            assert_eq!(plain, altered, "{} {alteration:?}", template.id);
        }
    }
}

#[test]
fn a_full_bust_makes_the_front_longer_and_leaves_the_back() {
    each(Alteration::FullBust, 2.0, |name, plain, altered| {
        let middle = |pattern| long(pattern, "front", "center_front");
        let longer = middle(altered) - middle(plain);
        assert!((longer - 0.02).abs() < ALIKE, "{name}: {longer}");
        let armhole = |pattern| long(pattern, "front", "armhole");
        let wider = armhole(altered) - armhole(plain);
        assert!((-UNSEEN..0.011).contains(&wider), "{name}: armhole {wider}");
        // Where hips and waist are as measured, sides share what the bust has more.
        for edge in ["armhole", "shoulder", "neckline", "center_back"] {
            let both = [plain, altered].map(|pattern| long(pattern, "back", edge));
            assert!((both[0] - both[1]).abs() < ALIKE, "{name} {edge}");
        }
    });
}

#[test]
fn a_round_back_makes_the_back_longer_and_leaves_front_and_armhole() {
    for cm in [-1.0, 2.0] {
        each(Alteration::RoundBack, cm, |name, plain, altered| {
            let middle = |pattern| long(pattern, "back", "center_back");
            let longer = middle(altered) - middle(plain);
            assert!((longer - cm / 100.0).abs() < UNSEEN, "{name}: {longer}");
            let armhole = |pattern| long(pattern, "back", "armhole");
            let other = armhole(altered) - armhole(plain);
            assert!(other.abs() < 2.0 * UNSEEN, "{name}: armhole {other}");
            for front in ["front", "front_yoke"] {
                let fronts = [plain, altered]
                    .map(|pattern| pattern.pieces.iter().find(|piece| piece.id == front));
                if let [Some(one), Some(other)] = fronts {
                    assert!(is_same(one, other), "{name} {front}");
                }
            }
        });
    }
}

#[test]
fn a_sway_back_shortens_the_middle_and_leaves_the_sides() {
    for id in ["blouse", "holoku"] {
        for (name, row) in &BODIES {
            let [plain, altered] = [0.0, 2.0].map(|cm| {
                drafted(id, row, (Alteration::SwayBack, cm)).unwrap_or_else(|e| panic!("{e}"))
            });
            let middle = |pattern| long(pattern, "back", "center_back");
            let shorter = middle(&plain) - middle(&altered);
            assert!((0.015..0.0201).contains(&shorter), "{id} {name}: {shorter}");
            for edge in ["side", "armhole", "shoulder", "neckline"] {
                let both = [&plain, &altered].map(|pattern| long(pattern, "back", edge));
                assert!((both[0] - both[1]).abs() < ALIKE, "{id} {name} {edge}");
            }
            assert!(is_same(piece(&plain, "front"), piece(&altered, "front")));
        }
    }
}

#[test]
fn sloping_shoulders_lower_the_armhole_and_leave_its_length() {
    for cm in [-1.5, 1.5] {
        each(Alteration::SlopingShoulders, cm, |name, plain, altered| {
            for face in ["front", "back"] {
                let side = |pattern| long(pattern, face, "side");
                let shorter = side(plain) - side(altered);
                assert!(
                    (shorter - cm / 100.0).abs() < 2.0 * UNSEEN,
                    "{name} {face}: {shorter}"
                );
                let armhole = |pattern| long(pattern, face, "armhole");
                let longer = armhole(altered) - armhole(plain);
                assert!(
                    longer.abs() < 2.0 * UNSEEN,
                    "{name} {face}: armhole {longer}"
                );
            }
        });
    }
}

#[test]
fn a_broad_back_is_wider_at_the_back_alone() {
    for cm in [-2.0, 3.0] {
        each(Alteration::BroadBack, cm, |name, plain, altered| {
            let wider = underarm(altered, "back") - underarm(plain, "back");
            // Of the whole width half is this half's; gathers below a yoke take their share of it.
            let least = 0.5 * cm / 100.0;
            assert!(
                least.abs() - 1.0e-6 <= wider.abs() && 0.0 < wider * cm,
                "{name}: {wider}"
            );
            let front = underarm(altered, "front") - underarm(plain, "front");
            assert!(front.abs() < ALIKE, "{name}: front {front}");
        });
    }
}

#[test]
fn a_full_arm_widens_the_sleeve_and_leaves_its_cap() {
    for cm in [-1.5, 3.0] {
        each(Alteration::FullArm, cm, |name, plain, altered| {
            let sleeve = |pattern| piece(pattern, "sleeve").clone();
            let wide = |piece: &Piece| {
                let cap = piece.edge("cap").map(|edge| edge.segments.clone());
                let cap = cap.unwrap_or_default();
                let ends = cap.first().zip(cap.last());
                ends.map_or(0.0, |(first, last)| {
                    let from = kurbo::ParamCurve::start(first);
                    (from - kurbo::ParamCurve::end(last)).hypot()
                })
            };
            let cap = |piece: &Piece| piece.edge("cap").map_or(0.0, |edge| edge.length());
            let (plain, altered) = (sleeve(plain), sleeve(altered));
            let wider = wide(&altered) - wide(&plain);
            assert!((wider - cm / 100.0).abs() < 6.0e-4, "{name}: {wider}");
            let longer = cap(&altered) - cap(&plain);
            assert!(longer.abs() < 1.0e-5, "{name}: cap {longer}");
        });
    }
}

/// Every alteration of every fitted garment on every body, to both ends of its band.
fn extremes() -> impl Iterator<Item = (&'static str, &'static [f64; 27], Alteration, f64)> {
    FITTED.into_iter().flat_map(|id| {
        let bodies = BODIES.iter().map(move |(_, row)| (id, row));
        bodies.flat_map(|(id, row)| {
            let all = Alteration::ALL.into_iter();
            all.flat_map(move |one| one.band_cm().map(|cm| (id, row, one, cm)))
        })
    })
}

#[test]
fn what_cannot_be_altered_so_far_is_refused_by_the_name_of_its_key() {
    let mut refused = 0;
    for (id, row, one, cm) in extremes() {
        let Err(error) = drafted(id, row, (one, cm)) else {
            continue;
        };
        let DraftError::Option { key, min, max, .. } = error else {
            panic!("{id} {one:?} {cm}: {error}");
        };
        assert_eq!(key, one.key(), "{id}");
        assert!(min <= max, "{id} {key}: {min} {max}");
        let nearest = cm.clamp(min, max);
        let allowed = drafted(id, row, (one, nearest));
        assert!(allowed.is_ok(), "{id} {key} {nearest}: {allowed:?}");
        refused += 1;
    }
    assert!(0 < refused, "nothing was refused, so nothing was shown");
}
