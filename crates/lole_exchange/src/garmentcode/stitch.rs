//! Stitches: which edges meet, and which of their ends.
//!
//! The file does not say the ends. Loops run counterclockwise seen from outside, so cloth is a surface with one
//! right side where two edges that are sewn run against each other. Where the panels' places say the opposite, it
//! is told.

use std::collections::BTreeMap;

use kurbo::{ParamCurve as _, ParamCurveArclen as _, PathSeg};
use lole_language::{Sentence, repeated, words};
use lole_pattern::pattern::{Seam, SeamKind, SeamSide};
use serde_json::Value;

use super::{MOST_STITCHES, Panel, WHAT, plane, too_many};
use crate::ExchangeError;
use crate::fields::{self, Fields};

/// Sides whose lengths differ by no more than this share are equally long, and up to the second one eased.
const LONGER: [f64; 2] = [1.005, 1.12];
/// Ends that meet lie farther apart than the other way by more than this [m] where the places contradict.
const FARTHER: f64 = 0.05;
/// The mark of a stitch that joins a right side to a wrong one.
const TURNED: &str = "right_wrong";

/// One side of a stitch: places of the panel and of its edge in the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Side {
    panel: usize,
    edge: usize,
}

/// The seams of a file, and what is told about their ends.
pub(super) fn read(
    list: &[Value],
    panels: &[Panel],
) -> Result<(Vec<Seam>, Vec<Sentence>), ExchangeError> {
    let at = "pattern.stitches";
    too_many(
        at,
        words("縫い合わせ", "stitches"),
        (list.len(), MOST_STITCHES),
    )?;
    let names: BTreeMap<&str, usize> = (panels.iter().enumerate())
        .map(|(place, panel)| (panel.name.as_str(), place))
        .collect();
    let mut sewn: BTreeMap<Side, usize> = BTreeMap::new();
    let (mut seams, mut notes) = (Vec::new(), Vec::new());
    for (number, value) in list.iter().enumerate() {
        let place = format!("{at}[{number}]");
        let parts = fields::list(value, &place)?;
        let (sides, is_turned) = match parts {
            [first, second] => ([first, second], false),
            [first, second, mark] if mark.as_str() == Some(TURNED) => ([first, second], true),
            _ => {
                return Err(ExchangeError::wrong(
                    place,
                    &value.to_string(),
                    (
                        "2 つの縁（と \"right_wrong\"）の並び",
                        "a list of two edges, with \"right_wrong\" or nothing after them",
                    ),
                ));
            }
        };
        let [first, second] = sides.map(|side| read_side(side, &place, (panels, &names)));
        let sides = [first?, second?];
        for side in sides {
            if let Some(other) = sewn.insert(side, number) {
                let name = &panels[side.panel].name;
                return Err(ExchangeError::unsewable(
                    place,
                    format!(
                        "{} の縁 {} は {at}[{other}] でも縫われています。一つの縁は一度だけ縫えます",
                        repeated(name),
                        side.edge
                    ),
                    format!(
                        "edge {} of {} is sewn in {at}[{other}] already; an edge is sewn once",
                        side.edge,
                        repeated(name)
                    ),
                ));
            }
        }
        notes.extend(contradiction(number, sides, (panels, is_turned)));
        seams.push(seam(sides, (panels, is_turned)));
    }
    Ok((seams, notes))
}

fn read_side(
    value: &Value,
    place: &str,
    (panels, names): (&[Panel], &BTreeMap<&str, usize>),
) -> Result<Side, ExchangeError> {
    let side = Fields::of(value, place, WHAT)?;
    let name = side.value("panel")?;
    let found = name.as_str().and_then(|name| names.get(name));
    let Some(&panel) = found else {
        return Err(ExchangeError::wrong(
            side.at("panel"),
            &name.to_string(),
            (
                "このファイルの型紙の名前",
                "the name of a panel of this file",
            ),
        ));
    };
    let edge = fields::index(side.value("edge")?, &side.at("edge"))?;
    let count = panels[panel].edges.len();
    if count <= edge {
        return Err(ExchangeError::wrong(
            side.at("edge"),
            &edge.to_string(),
            (
                &format!("{count} 本の縁の番号（0 から）"),
                &format!("one of {count} edges, counted from 0"),
            ),
        ));
    }
    Ok(Side { panel, edge })
}

fn length(segments: &[PathSeg]) -> f64 {
    segments.iter().map(|segment| segment.arclen(1.0e-6)).sum()
}

fn seam(sides: [Side; 2], (panels, is_turned): (&[Panel], bool)) -> Seam {
    let of_piece = |side: Side| {
        let panel = &panels[side.panel];
        let whole = SeamSide::whole(side.panel, 0, panel.edge_of_piece(side.edge));
        // As the edge runs in the file.
        if panel.is_clockwise {
            whole.back()
        } else {
            whole
        }
    };
    let [first, second] = sides.map(of_piece);
    let second = if is_turned { second } else { second.back() };
    let [one, other] = sides.map(|side| length(&panels[side.panel].edges[side.edge]));
    let (flat, full, ratio) = if one <= other {
        (first, second, other / one)
    } else {
        (second, first, one / other)
    };
    let kind = if ratio <= LONGER[0] {
        SeamKind::Plain
    } else if ratio <= LONGER[1] {
        SeamKind::Eased
    } else {
        SeamKind::Gathered
    };
    Seam { flat, full, kind }
}

/// What is told where the ends that meet lie much farther apart in the file than the others would.
fn contradiction(
    number: usize,
    [first, second]: [Side; 2],
    (panels, is_turned): (&[Panel], bool),
) -> Option<Sentence> {
    if first.panel == second.panel {
        return None;
    }
    let ends = |side: Side| {
        let panel = &panels[side.panel];
        let segments = &panel.edges[side.edge];
        let ends = [segments[0].start(), segments[segments.len() - 1].end()];
        ends.map(|end| panel.given.place(plane(end)))
    };
    let [[a, b], [c, d]] = [first, second].map(ends);
    let along = a.distance(c) + b.distance(d);
    let against = a.distance(d) + b.distance(c);
    let (sewn, other) = if is_turned {
        (along, against)
    } else {
        (against, along)
    };
    if sewn <= other + FARTHER {
        return None;
    }
    let [sewn, other] = [sewn, other].map(|way| 50.0 * way);
    let number = number + 1;
    Some(Sentence::new(
        format!(
            "縫い合わせ {number}: 表と裏がそろう向きに縫います。型紙の置き場所では、その端どうしは平均 {sewn:.0} cm、逆向きなら {other:.0} cm 離れています"
        ),
        format!(
            "stitch {number} is sewn so that right sides stay right; where the panels lie, those ends are {sewn:.0} cm apart on average, and {other:.0} cm the other way round"
        ),
    ))
}
