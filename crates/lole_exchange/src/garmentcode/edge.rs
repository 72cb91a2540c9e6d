//! Edges of a panel: straight, quadratic, cubic and circular, in a closed loop.

use glam::DVec2;
use kurbo::{
    Arc, CubicBez, Line, ParamCurveArclen as _, PathEl, PathSeg, Point, QuadBez, Shape as _,
    SvgArc, Vec2,
};
use lole_language::words;
use serde_json::Value;

use super::{FARTHEST, Format, MOST_EDGES, SHORTEST, too_many};
use crate::ExchangeError;
use crate::fields::{self, Fields};

/// How exactly arcs are drawn as curves [m].
const EXACT: f64 = 1.0e-6;
/// An arc whose radius is shorter than half its chord by this share is rounded, and not wrong.
const ROUNDED: f64 = 1.0e-3;

/// The edges of a panel in the order of the file, each beginning where the last one ended [m].
pub(super) fn read_loop(
    panel: &Fields<'_>,
    (vertices, format): (&[DVec2], Format),
) -> Result<Vec<Vec<PathSeg>>, ExchangeError> {
    let edges = panel.list("edges")?;
    let at = panel.at("edges");
    too_many(&at, words("縁", "edges"), (edges.len(), MOST_EDGES))?;
    if edges.len() < 2 {
        return Err(ExchangeError::unsewable(
            at,
            "縁が 2 本より少なく、布を囲みません",
            "fewer than 2 edges enclose no cloth",
        ));
    }
    let mut read = Vec::new();
    let mut ends = Vec::new();
    for (number, value) in edges.iter().enumerate() {
        let edge = Fields::of(value, format!("{at}[{number}]"), panel.what)?;
        let place = edge.at("endpoints");
        let listed = fields::list(edge.value("endpoints")?, &place)?;
        let indices: Vec<usize> = listed
            .iter()
            .map(|value| fields::index(value, &place))
            .collect::<Result<_, _>>()?;
        let [from, to] = indices[..] else {
            return Err(ExchangeError::wrong(
                place,
                &edge.map["endpoints"].to_string(),
                ("2 つの頂点の番号", "the numbers of two vertices"),
            ));
        };
        let (Some(&start), Some(&end)) = (vertices.get(from), vertices.get(to)) else {
            return Err(ExchangeError::wrong(
                place,
                &format!("[{from}, {to}]"),
                (
                    &format!("{} 個の頂点の番号", vertices.len()),
                    &format!("two of {} vertices, counted from 0", vertices.len()),
                ),
            ));
        };
        let segments = read_edge(&edge, [start, end], format)?;
        if !segments.iter().all(is_near) || length(&segments) < SHORTEST {
            return Err(ExchangeError::unsewable(
                edge.place,
                "長さがないか、服より遠くまで曲がっています。縁を引き直してください",
                "it has no length, or bends farther than a garment is large; draw the edge again",
            ));
        }
        read.push(segments);
        ends.push([from, to]);
    }
    let next = ends.iter().cycle().skip(1);
    let gap = ends
        .iter()
        .zip(next)
        .position(|(one, next)| one[1] != next[0]);
    if let Some(number) = gap {
        return Err(ExchangeError::unsewable(
            format!("{at}[{number}]"),
            "次の縁の始まりにつながっていません。縁を一回りの順に並べてください",
            "it does not end where the next edge begins; list the edges once around the panel",
        ));
    }
    Ok(read)
}

/// What is bent far beyond its ends is no edge, and finding its length would take long.
fn is_near(segment: &PathSeg) -> bool {
    let around = segment.bounding_box();
    let ends = [around.x0, around.x1, around.y0, around.y1];
    ends.iter().all(|end| end.abs() <= FARTHEST)
}

fn length(segments: &[PathSeg]) -> f64 {
    segments.iter().map(|segment| segment.arclen(EXACT)).sum()
}

fn read_edge(
    edge: &Fields<'_>,
    [start, end]: [DVec2; 2],
    format: Format,
) -> Result<Vec<PathSeg>, ExchangeError> {
    let point = |point: DVec2| Point::new(point.x, point.y);
    let straight = PathSeg::Line(Line::new(point(start), point(end)));
    let Some(curvature) = edge.map.get("curvature").filter(|value| !value.is_null()) else {
        return Ok(vec![straight]);
    };
    let place = edge.at("curvature");
    let along = end - start;
    let control = |[x, y]: [f64; 2]| {
        if format.is_absolute {
            point(DVec2::new(x, y) * format.unit)
        } else {
            point(start + along * x + along.perp() * y)
        }
    };
    let quadratic = |bend| PathSeg::Quad(QuadBez::new(point(start), bend, point(end)));
    if curvature.is_array() {
        let bend = control(fields::numbers(curvature, &place)?);
        return Ok(vec![quadratic(bend)]);
    }
    let fields = Fields::of(curvature, place.clone(), edge.what)?;
    let params = fields.list("params")?;
    let at = fields.at("params");
    let controls = |wanted: usize| {
        let read = params.iter().map(|value| fields::numbers(value, &at));
        let read: Vec<[f64; 2]> = read.collect::<Result<_, _>>()?;
        if read.len() == wanted {
            return Ok(read);
        }
        Err(ExchangeError::wrong(
            at.clone(),
            &fields.map["params"].to_string(),
            (
                &format!("{wanted} 個の制御点"),
                &format!("a list of {wanted} control points"),
            ),
        ))
    };
    match fields.value("type")?.as_str() {
        Some("quadratic") => {
            let bend = control(controls(1)?[0]);
            Ok(vec![quadratic(bend)])
        }
        Some("cubic") => {
            let bends = controls(2)?;
            let [first, second] = [bends[0], bends[1]].map(control);
            let cubic = CubicBez::new(point(start), first, second, point(end));
            Ok(vec![PathSeg::Cubic(cubic)])
        }
        Some("circle") => {
            let [radius, is_large, is_right] = fields.numbers::<3>("params")?;
            let flags = [is_large != 0.0, is_right != 0.0];
            arc([point(start), point(end)], (radius * format.unit, flags)).ok_or_else(|| {
                ExchangeError::wrong(
                    at,
                    &fields.map["params"].to_string(),
                    (
                        "半径が弦の半分以上で 20 m までの弧",
                        "an arc with a radius of at least half its chord and at most 20 m",
                    ),
                )
            })
        }
        _ => Err(ExchangeError::wrong(
            fields.at("type"),
            &fields
                .value("type")
                .map(Value::to_string)
                .unwrap_or_default(),
            (
                "\"quadratic\"・\"cubic\"・\"circle\" のどれか",
                "\"quadratic\", \"cubic\" or \"circle\"",
            ),
        )),
    }
}

/// An arc of a circle between two points as curves; `None` where its circle does not reach both.
fn arc(
    [from, to]: [Point; 2],
    (radius, [is_large, is_right]): (f64, [bool; 2]),
) -> Option<Vec<PathSeg>> {
    let half = 0.5 * from.distance(to);
    if !(half * (1.0 - ROUNDED)..=FARTHEST).contains(&radius) {
        return None;
    }
    let radius = radius.max(half);
    let drawn = SvgArc {
        from,
        to,
        radii: Vec2::new(radius, radius),
        x_rotation: 0.0,
        large_arc: is_large,
        sweep: is_right,
    };
    let mut at = from;
    let mut segments = Vec::new();
    for element in Arc::from_svg_arc(&drawn)?.append_iter(EXACT) {
        if let PathEl::CurveTo(first, second, end) = element {
            segments.push(PathSeg::Cubic(CubicBez::new(at, first, second, end)));
            at = end;
        }
    }
    // Rounding leaves its end beside the vertex.
    if let Some(PathSeg::Cubic(last)) = segments.last_mut() {
        last.p3 = to;
    }
    Some(segments)
}
