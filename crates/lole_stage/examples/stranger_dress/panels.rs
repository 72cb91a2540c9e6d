//! A sewing pattern of flat panels as `GarmentCode` and its forerunner write it (Korosteleva and Sorkine-Hornung
//! 2023), divided into triangles, laid around the dancer and sewn: one welded surface whose
//! triangles know where they lie in their panel.
//!
//! A curved edge has its control points where its chord is the unit along `x`; a circle is an arc as SVG has
//! it. Panels turn about `x`, then `y`, then `z`. Both sides of a stitch get as many points, and the ends meet
//! that are nearer to each other where the panels are placed.

use std::error::Error;

use glam::{DVec2, EulerRot, Quat, Vec2, Vec3};
use lole_geom::weld::weld;
use lole_geom::{narrow, polygon, trig64};
use serde_json::Value;

/// Pieces of a curve from which lengths are taken.
const FINE: u32 = 64;
/// A garment as it is sewn, not yet drawn together.
#[derive(Debug, Clone, Default)]
pub(crate) struct Sewn {
    /// Where its vertices are [m]: those of a seam between its sides, the others in their panel.
    pub(crate) positions: Vec<Vec3>,
    pub(crate) triangles: Vec<[u32; 3]>,
    /// The corners of each in its panel [m], the warp, which runs up the panel, along `x`.
    pub(crate) flat: Vec<[Vec2; 3]>,
}

struct Edge {
    /// From its beginning to its end [m].
    curve: Vec<DVec2>,
    length: f64,
    /// Parts that it is divided into.
    count: usize,
}

struct Panel {
    name: String,
    edges: Vec<Edge>,
    rotation: Quat,
    translation: Vec3,
}

type Side = (usize, usize);

/// Reads a pattern, with edges of triangles about so long [m], raised by `lift` [m].
pub(crate) fn sew(text: &str, edge: f64, lift: f32) -> Result<Sewn, Box<dyn Error>> {
    let all: Value = serde_json::from_str(text)?;
    if all["properties"]["curvature_coords"] != "relative" {
        return Err("control points that are not relative to their edge".into());
    }
    let unit = 1.0
        / all["properties"]["units_in_meter"]
            .as_f64()
            .ok_or("no unit")?;
    let listed = all["pattern"]["panels"].as_object().ok_or("no panels")?;
    let panels = listed
        .iter()
        .map(|(name, panel)| {
            Panel::read(name, panel, unit, edge).map_err(|it| format!("{name}: {it}").into())
        })
        .collect::<Result<Vec<_>, Box<dyn Error>>>();
    let mut panels = panels?;
    let stitches = all["pattern"]["stitches"].as_array().ok_or("no stitches")?;
    let stitches = stitches
        .iter()
        .map(|stitch| Some([side(&panels, &stitch[0])?, side(&panels, &stitch[1])?]))
        .collect::<Option<Vec<_>>>();
    let stitches = stitches.ok_or("a stitch of an edge that is not")?;
    for &sides in &stitches {
        let counts = sides.map(|(panel, edge)| panels[panel].edges[edge].count);
        for (panel, edge) in sides {
            panels[panel].edges[edge].count = counts[0].max(counts[1]);
        }
    }
    let mut mesh = Sewn::default();
    let mut starts = Vec::new();
    for panel in &panels {
        starts.push(mesh.positions.len());
        panel.divide(edge, lift, &mut mesh)?;
    }
    let joined: Vec<[u32; 2]> = stitches
        .iter()
        .flat_map(|&sides| joined(&panels, &starts, sides))
        .collect();
    Ok(mesh.welded(&joined))
}

impl Panel {
    fn read(name: &str, panel: &Value, unit: f64, spacing: f64) -> Result<Self, Box<dyn Error>> {
        let vertices = panel["vertices"].as_array().ok_or("no vertices")?;
        let vertices = vertices
            .iter()
            .map(|it| Some(unit * plane(it)?))
            .collect::<Option<Vec<_>>>();
        let vertices = vertices.ok_or("a vertex without a place")?;
        let mut edges = Vec::new();
        let mut last = None;
        for edge in panel["edges"].as_array().ok_or("no edges")? {
            let ends = [0, 1].map(|it| {
                edge["endpoints"][it]
                    .as_u64()
                    .and_then(|it| usize::try_from(it).ok())
            });
            let [Some(from), Some(to)] = ends else {
                return Err("an edge without ends".into());
            };
            if last.is_some_and(|last| last != from) {
                return Err("an edge that does not begin where the last one ended".into());
            }
            last = Some(to);
            let ends = [from, to].map(|it| vertices.get(it).copied());
            let [Some(from), Some(to)] = ends else {
                return Err("an edge between vertices that are not".into());
            };
            edges.push(Edge::new(
                curve([from, to], &edge["curvature"], unit)?,
                spacing,
            ));
        }
        let three = |key: &str| -> Option<[f32; 3]> {
            let numbers = panel[key]
                .as_array()?
                .iter()
                .map(|it| it.as_f64().map(narrow));
            numbers.collect::<Option<Vec<_>>>()?.try_into().ok()
        };
        let [x, y, z] = three("rotation").ok_or("no rotation")?.map(f32::to_radians);
        Ok(Self {
            name: name.to_owned(),
            edges,
            rotation: Quat::from_euler(EulerRot::ZYX, z, y, x),
            translation: Vec3::from(three("translation").ok_or("no translation")?) * narrow(unit),
        })
    }

    fn placed(&self, at: DVec2) -> Vec3 {
        self.rotation * at.as_vec2().extend(0.0) + self.translation
    }

    /// The number of the point at a place of an edge, among those of the border.
    fn border_point(&self, edge: usize, at: usize) -> usize {
        let counts = || self.edges.iter().map(|edge| edge.count);
        (counts().take(edge).sum::<usize>() + at) % counts().sum::<usize>()
    }

    /// Adds its triangles to a mesh.
    fn divide(&self, spacing: f64, lift: f32, mesh: &mut Sewn) -> Result<(), Box<dyn Error>> {
        let border: Vec<DVec2> = self.edges.iter().flat_map(Edge::points).collect();
        let divided = polygon::divide(&border, spacing);
        let polygon::DividedPolygon { points, triangles } =
            divided.ok_or_else(|| format!("{}: its border crosses itself", self.name))?;
        let start = u32::try_from(mesh.positions.len())?;
        let on_cloth = |corner: u32| {
            let at = points[corner as usize].as_vec2();
            Vec2::new(at.y, -at.x)
        };
        for corners in triangles {
            mesh.triangles.push(corners.map(|corner| corner + start));
            mesh.flat.push(corners.map(on_cloth));
        }
        let placed = points.iter().map(|&at| self.placed(at) + Vec3::Y * lift);
        mesh.positions.extend(placed);
        Ok(())
    }
}

impl Edge {
    fn new(curve: Vec<DVec2>, spacing: f64) -> Self {
        let length = curve
            .windows(2)
            .map(|it| it[0].distance(it[1]))
            .sum::<f64>();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "some hundreds"
        )]
        let count = (length / spacing).round().clamp(1.0, 4096.0) as usize;
        Self {
            curve,
            length,
            count,
        }
    }

    /// Its points without the last one, equally far apart.
    fn points(&self) -> impl Iterator<Item = DVec2> + '_ {
        (0..self.count).map(|part| self.at(self.length * part as f64 / self.count as f64))
    }

    fn at(&self, mut length: f64) -> DVec2 {
        for ends in self.curve.windows(2) {
            let piece = ends[0].distance(ends[1]);
            if length <= piece {
                return ends[0].lerp(ends[1], length / piece.max(f64::MIN_POSITIVE));
            }
            length -= piece;
        }
        self.curve[self.curve.len() - 1]
    }
}

impl Sewn {
    fn welded(self, joined: &[[u32; 2]]) -> Self {
        let welded = weld((&self.positions, &self.triangles), 0.0, joined);
        let mut sums = vec![(Vec3::ZERO, 0.0); welded.positions.len()];
        for (&place, vertex) in self.positions.iter().zip(&welded.vertices) {
            if let Some(vertex) = vertex {
                let sum = &mut sums[*vertex as usize];
                *sum = (sum.0 + place, sum.1 + 1.0);
            }
        }
        Self {
            positions: sums.into_iter().map(|(sum, count)| sum / count).collect(),
            triangles: welded.triangles,
            flat: welded.sources.iter().map(|&it| self.flat[it]).collect(),
        }
    }
}

/// Pairs of vertices that a stitch makes one.
fn joined(panels: &[Panel], starts: &[usize], sides: [Side; 2]) -> Vec<[u32; 2]> {
    let edges = sides.map(|(panel, edge)| &panels[panel].edges[edge]);
    let ends = [0, 1].map(|it| {
        let (panel, curve) = (&panels[sides[it].0], &edges[it].curve);
        [curve[0], curve[curve.len() - 1]].map(|end| panel.placed(end))
    });
    let apart = |from: usize, to: usize| {
        ends[0][0].distance(ends[1][from]) + ends[0][1].distance(ends[1][to])
    };
    // Where neither is nearer they run against each other, as sides of one surface do.
    let is_along = apart(0, 1) < apart(1, 0);
    let count = edges[0].count;
    let number = |(panel, edge): Side, at: usize| {
        u32::try_from(starts[panel] + panels[panel].border_point(edge, at)).unwrap_or(u32::MAX)
    };
    let other = |at: usize| if is_along { at } else { count - at };
    (0..=count)
        .map(|at| [number(sides[0], at), number(sides[1], other(at))])
        .collect()
}

fn side(panels: &[Panel], side: &Value) -> Option<Side> {
    let name = side["panel"].as_str()?;
    let panel = panels.iter().position(|panel| panel.name == name)?;
    let edge = usize::try_from(side["edge"].as_u64()?).ok()?;
    (edge < panels[panel].edges.len()).then_some((panel, edge))
}

fn plane(pair: &Value) -> Option<DVec2> {
    Some(DVec2::new(pair[0].as_f64()?, pair[1].as_f64()?))
}

/// Points of an edge between its ends [m].
fn curve(
    [from, to]: [DVec2; 2],
    curvature: &Value,
    unit: f64,
) -> Result<Vec<DVec2>, Box<dyn Error>> {
    let (along, across) = (to - from, (to - from).perp());
    let control = |pair: &Value| Some(from + plane(pair)?.x * along + plane(pair)?.y * across);
    let kind = curvature["type"].as_str();
    let listed = if kind.is_some() {
        &curvature["params"]
    } else {
        curvature
    };
    let controls = match kind {
        None if curvature.is_null() => Vec::new(),
        None => vec![control(listed)],
        Some("quadratic") => vec![control(&listed[0])],
        Some("cubic") => vec![control(&listed[0]), control(&listed[1])],
        Some("circle") => return arc([from, to], listed, unit),
        Some(other) => return Err(format!("a curve of kind {other}").into()),
    };
    let controls = controls
        .into_iter()
        .collect::<Option<Vec<_>>>()
        .ok_or("a curve without control points")?;
    let mut points = vec![from];
    points.extend(controls);
    points.push(to);
    if points.len() == 2 {
        return Ok(points);
    }
    let shares = (0..=FINE).map(|it| f64::from(it) / f64::from(FINE));
    Ok(shares
        .map(|share| casteljau(points.clone(), share))
        .collect())
}

fn casteljau(mut points: Vec<DVec2>, share: f64) -> DVec2 {
    while 1 < points.len() {
        points = points
            .windows(2)
            .map(|it| it[0].lerp(it[1], share))
            .collect();
    }
    points[0]
}

/// An arc of a circle: radius, whether it is the larger part, whether it turns to the right.
fn arc([from, to]: [DVec2; 2], listed: &Value, unit: f64) -> Result<Vec<DVec2>, Box<dyn Error>> {
    let [Some(radius), Some(large), Some(right)] = [0, 1, 2].map(|it| listed[it].as_f64()) else {
        return Err("a circle needs radius and two flags".into());
    };
    let half = 0.5 * from.distance(to);
    let radius = (radius * unit).max(half);
    let (is_large, is_right) = (large != 0.0, right != 0.0);
    let out = (radius * radius - half * half).max(0.0).sqrt();
    let to_left = (to - from).perp().normalize_or_zero();
    let center = from.midpoint(to) + to_left * if is_large == is_right { -out } else { out };
    let (small, start) = (2.0 * trig64::asin((half / radius).min(1.0)), from - center);
    let whole = if is_large {
        std::f64::consts::TAU - small
    } else {
        small
    };
    let turn = if is_right { whole } else { -whole };
    let shares = (0..=FINE).map(|it| f64::from(it) / f64::from(FINE));
    Ok(shares
        .map(|share| center + DVec2::from_angle(share * turn).rotate(start))
        .collect())
}
