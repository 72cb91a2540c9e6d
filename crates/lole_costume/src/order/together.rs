//! Cloth that a group buys together: the pieces of all dancers side by side, in strips that are cut off from
//! selvage to selvage.

use lole_geom::Length;
use lole_language::Words;
use lole_pattern::marker::Placed;
use lole_pattern::marker::strips::{length_of, strips};

use super::PlannedGarment;
use crate::tailoring::ClothPlan;

/// A length of cloth that is cut off for several dancers.
#[derive(Debug, Clone, PartialEq)]
pub struct SharedStrip {
    /// Along the selvage.
    pub length: Length,
    /// What lies in it side by side, from the lower selvage up.
    pub shares: Vec<Share>,
}

/// What of a strip is whose.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Share {
    /// Place among the dancers.
    pub dancer: usize,
    /// For what.
    pub garment: Words,
    /// Which piece of it; `None` for all of the garment, laid as in her own cut plan.
    pub piece: Option<Words>,
    /// Along the selvage, from the strip's cut end.
    pub along: Length,
    /// From the lower selvage, where it begins and ends.
    pub across: [Length; 2],
}

/// What a group cuts from one cloth.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Together {
    /// Behind each other, the longest first.
    pub(super) strips: Vec<SharedStrip>,
    /// Of all strips.
    pub(super) needed: Length,
    /// What the same needs where everybody cuts her own.
    pub(super) apart: Length,
}

/// What is cut from one cloth: the dancer's place, her garment, and how it lies on cloth of its own.
pub(super) type Cut<'a> = (usize, &'a PlannedGarment, &'a ClothPlan);

/// Lays everything on one cloth: garment by garment as each lies in its own plan, one behind the other or side
/// by side, or piece by piece, whichever needs least. So a group never needs more than its dancers apart.
pub(super) fn together(cuts: &[Cut<'_>], width: Length) -> Together {
    let apart = (cuts.iter()).map(|(_, _, plan)| plan.marker.yardage.needed);
    let apart = apart.fold(Length::ZERO, |sum, length| sum + length);
    // The first of those that need as little: what keeps each dancer's cloth together comes first.
    let plans = [behind(cuts, width), by_garment(cuts), by_piece(cuts)];
    let mut best: Option<Together> = None;
    for shares in plans.into_iter().flatten() {
        let sizes: Vec<[Length; 2]> = (shares.iter())
            .map(|share| [share.along, share.across[1] - share.across[0]])
            .collect();
        let laid = strips(&sizes, width);
        let needed = length_of(&laid);
        // Rounding noise is no saving.
        let is_shorter = |best: &Together| (needed - best.needed).to_cm() < -1.0e-4;
        if best.as_ref().is_none_or(is_shorter) {
            let strips = laid.into_iter().map(|strip| SharedStrip {
                length: strip.length,
                shares: (strip.laid.iter())
                    .map(|one| {
                        let [_, wide] = sizes[one.index];
                        Share {
                            across: [one.across, one.across + wide],
                            ..shares[one.index]
                        }
                    })
                    .collect(),
            });
            best = Some(Together {
                strips: strips.collect(),
                needed,
                apart,
            });
        }
    }
    best.unwrap_or(Together {
        strips: Vec::new(),
        needed: Length::ZERO,
        apart,
    })
}

/// What has to lie at the lower selvage, for a printed border, lies there in its own plan only.
fn is_free(cut: &Cut<'_>) -> bool {
    cut.2.marker.cloth.border.is_none()
}

/// Every rectangle by itself, and garments of other shapes as they lie in their own plans; `None` where there
/// is a border to lie on.
fn by_piece(cuts: &[Cut<'_>]) -> Option<Vec<Share>> {
    let mut shares = Vec::new();
    for cut in cuts {
        let (dancer, garment, plan) = *cut;
        if !is_free(cut) {
            return None;
        }
        if !plan.marker.placed.iter().all(is_rectangle) {
            shares.push(whole(cut, reach(cut)));
            continue;
        }
        for placed in &plan.marker.placed {
            let bounds = placed.outline.bounds();
            let pieces = &garment.tailored.cutting().pieces;
            shares.push(Share {
                dancer,
                garment: garment.tailored.name,
                piece: pieces.get(placed.piece).map(|piece| piece.name),
                along: Length::from_m(bounds.width()),
                across: [Length::ZERO, Length::from_m(bounds.height())],
            });
        }
    }
    Some(shares)
}

/// How far a garment reaches across its cloth in its own plan.
fn reach(cut: &Cut<'_>) -> Length {
    let tops = cut
        .2
        .marker
        .placed
        .iter()
        .map(|one| one.outline.bounds().y1);
    Length::from_m(tops.fold(0.0, f64::max))
}

fn is_rectangle(placed: &Placed) -> bool {
    /// Rounding of areas [m²].
    const NOTHING: f64 = 1.0e-6;
    let outline = &placed.outline;
    (outline.signed_area() - outline.bounds().area()).abs() < NOTHING
}

/// Every garment as it lies in its own plan, as wide as it reaches there.
fn by_garment(cuts: &[Cut<'_>]) -> Option<Vec<Share>> {
    let shares = cuts.iter();
    shares
        .map(|cut| is_free(cut).then(|| whole(cut, reach(cut))))
        .collect()
}

/// Every garment on a length of its own.
fn behind(cuts: &[Cut<'_>], width: Length) -> Option<Vec<Share>> {
    Some(cuts.iter().map(|cut| whole(cut, width)).collect())
}

/// All of a garment.
fn whole((dancer, garment, plan): &Cut<'_>, across: Length) -> Share {
    Share {
        dancer: *dancer,
        garment: garment.tailored.name,
        piece: None,
        along: plan.marker.yardage.needed,
        across: [Length::ZERO, across],
    }
}

/// What is cut from each bolt, as places among the strips: the longest strip first, each from the first bolt
/// that still holds it (first fit, decreasing: at most 11/9 of the fewest bolts, Johnson 1973), so that none
/// spans the end of one. Strips that no bolt holds come second.
pub(super) fn bolts(strips: &[SharedStrip], bolt: Length) -> (Vec<Vec<usize>>, Vec<usize>) {
    let mut order: Vec<usize> = (0..strips.len()).collect();
    let long = |index: usize| strips[index].length.to_m();
    // Equal lengths stay in the order of the strips.
    order.sort_by(|one, other| long(*other).total_cmp(&long(*one)));
    let mut bolts: Vec<(Length, Vec<usize>)> = Vec::new();
    let mut too_long = Vec::new();
    for index in order {
        let length = strips[index].length;
        if bolt < length {
            too_long.push(index);
            continue;
        }
        match bolts.iter_mut().find(|(left, _)| length <= *left) {
            Some((left, cut)) => {
                *left = *left - length;
                cut.push(index);
            }
            None => bolts.push((bolt - length, vec![index])),
        }
    }
    (bolts.into_iter().map(|(_, cut)| cut).collect(), too_long)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_strip_spans_two_bolts() {
        let strips: Vec<SharedStrip> = [3.7, 3.9, 2.5, 4.1, 1.2, 3.3, 25.0]
            .map(|meters| SharedStrip {
                length: Length::from_m(meters),
                shares: Vec::new(),
            })
            .into();
        let (bolts, too_long) = bolts(&strips, Length::from_m(8.0));
        assert_eq!(too_long, [6]);
        let mut seen: Vec<usize> = Vec::new();
        for bolt in &bolts {
            let length: f64 = bolt.iter().map(|&index| strips[index].length.to_m()).sum();
            assert!(length <= 8.0 + 1e-9, "{length}");
            seen.extend(bolt);
        }
        seen.sort_unstable();
        assert_eq!(seen, [0, 1, 2, 3, 4, 5]);
        // 18.7 m need at least three bolts of 8 m.
        assert_eq!(bolts.len(), 3);
    }
}
