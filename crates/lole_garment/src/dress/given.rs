//! Where the panels of a file lie around her before they are sewn.
//!
//! The file lays them flat in front of a body and behind it. Here every panel is bent around her: below the armpits
//! what lies beside each other on one side goes around the trunk as far as its share of all cloth at that level;
//! above them front and back lie on her as they hang, seen from the front; sleeves go around the arms. So seams
//! nearly meet. Then seams are drawn together, and cloth that this stretches draws what is beside it along.

use glam::{DVec2, DVec3, Vec2, Vec3};
use lole_geom::{narrow, trig};
use lole_pattern::Measures;

use super::bodice::mirrored;
use super::flat::FlatMesh;
use super::form::{Face, Form};
use super::panel::Panels;
use super::{fit, number, welded};
use crate::given::around::{Arm, Around, NEAR_TOP, Part};
use crate::given::{Given, Hang, Size};

/// Gap between skin and cloth that lies close [m].
const CLOSE: f32 = 0.008;
/// Gap of a band that is held [m].
const BAND_GAP: f32 = 0.004;
/// Farthest that cloth is laid from the trunk [m].
const FARTHEST: f32 = 0.30;
/// The trunk goes around as one below this distance from the armpits [m].
const BELOW_ARMPIT: f32 = 0.02;
/// Distance of levels whose cloth is looked up [m].
const LEVEL: f64 = 0.01;
/// Steps down the slope of the shoulder, and how far it is looked for [m].
const SLOPE_STEP: f32 = 0.005;
const DEEPEST_SLOPE: f32 = 0.16;
/// Halvings until a place on a tape is found.
const HALVINGS: u32 = 18;
/// Passes in which stretched cloth draws what is beside it, and after how many it is brought out of the skin.
const DRAWING_PASSES: u32 = 240;
const PASSES_OF_SKIN: u32 = 24;
/// Cloth is drawn while it is longer than this over its length.
const TAUT: f32 = 1.002;

/// A garment of a file, in the size that is sewn.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sized<'a> {
    pub(super) given: &'a Given,
    pub(super) size: &'a Size,
}

/// Rules for where the points of panels lie.
struct Placing<'a> {
    sized: Sized<'a>,
    around: Around,
    form: &'a Form<'a>,
    /// Heights in the stance of the file's levels: of armpits, shoulder points and necks [m].
    armpit: f32,
    shoulder: f32,
    /// Lowest level, and cloth around at each level from there [m].
    lowest: f64,
    girths: Vec<f64>,
    sleeves: [Option<Sleeve>; 2],
}

/// Both halves of a sleeve in the plane between left and right of the file's body, as on her left [m].
struct Sleeve {
    /// Down the arm, and across it upward.
    axes: [DVec2; 2],
    /// Where it begins at the shoulder, and where all of it has begun, down the arm.
    begins: [f64; 2],
    /// Borders of the front half and of the back half: down the arm and across it.
    borders: [Vec<Vec<DVec2>>; 2],
}

impl<'a> Placing<'a> {
    fn new(sized: Sized<'a>, form: &'a Form<'a>, measures: &Measures) -> Self {
        let around = Around::new(sized.given);
        let [lowest, highest] = around.levels().unwrap_or([0.0, LEVEL]);
        let levels = (0_u32..).map(|step| lowest + (f64::from(step) + 0.5) * LEVEL);
        let levels = levels.take_while(|level| *level < highest + LEVEL);
        let girths: Vec<Option<f64>> = levels.map(|level| around.girth(level)).collect();
        let sleeves = [1.0, -1.0].map(|left| Sleeve::new(sized.given, &around, left));
        let shoulder = measures.neck_height - measures.shoulder_drop;
        Self {
            sized,
            around,
            form,
            armpit: measures.armpit_height.to_m_f32() - BELOW_ARMPIT,
            shoulder: shoulder.to_m_f32(),
            lowest,
            girths: filled(&girths),
            sleeves,
        }
    }

    /// Where a point of a piece lies [m].
    fn place(&self, piece: usize, point: DVec2) -> Option<Vec3> {
        let ratio = self.sized.size.ratio;
        let place = self.sized.given.panels[piece].place(point / ratio);
        match self.around.panels[piece].part {
            Part::Trunk(side) => self.on_trunk(side, place),
            Part::Arm(arm) => self.on_arm(arm, place),
        }
    }

    /// Cloth around at a level of the file's body, in her size [m].
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "clamped to the levels"
    )]
    fn girth(&self, level: f64) -> f32 {
        let last = self.girths.len().saturating_sub(1);
        let at = ((level - self.lowest) / LEVEL - 0.5).clamp(0.0, last as f64);
        let below = at as usize;
        let [a, b] = [below, (below + 1).min(last)].map(|at| self.girths[at]);
        narrow((a + (b - a) * (at - below as f64)) * self.sized.size.ratio)
    }

    fn on_trunk(&self, side: usize, place: DVec3) -> Option<Vec3> {
        let size = self.sized.size;
        let height = narrow(size.height(place.y));
        let along = narrow(self.around.along(side, place) * size.ratio);
        let below = height.min(self.armpit);
        let raised = f64::from(height - below) / size.ratio;
        let cloth = self.girth(place.y - raised).max(1.0e-3);
        let turn = narrow(self.around.sides[side].turn) / std::f32::consts::TAU + along / cloth;
        let (skin, outward) = self.form.around_trunk(below, 0.5 - turn)?;
        let close = if size.hang == Hang::Band {
            BAND_GAP
        } else {
            CLOSE
        };
        let room = (cloth - self.form.girth(below)) / std::f32::consts::TAU;
        let wrapped = skin + outward * room.clamp(close, FARTHEST) + Vec3::Y * (height - below);
        if height <= self.armpit {
            return Some(wrapped);
        }
        let face = if trig::cos(narrow(self.around.sides[side].turn)) < 0.0 {
            Face::Back
        } else {
            Face::Front
        };
        let across = narrow(place.x * size.ratio);
        let Some(hanging) = self.on_face(face, (across, height)) else {
            return Some(wrapped);
        };
        let share = (height - self.armpit) / (self.shoulder - self.armpit).max(1.0e-3);
        let share = share.clamp(0.0, 1.0);
        Some(wrapped.lerp(hanging, share * share * (3.0 - 2.0 * share)))
    }

    /// The place on front or back so far to her left at a height, or below it on the slope of the shoulder.
    fn on_face(&self, face: Face, (across, height): (f32, f32)) -> Option<Vec3> {
        let mut lower = height;
        while height - DEEPEST_SLOPE < lower {
            let (side, _) = self.form.on_trunk(lower, face, 1.0)?;
            if across.abs() <= side.x {
                break;
            }
            lower -= SLOPE_STEP;
        }
        let mut shares = [0.0_f32, 1.0];
        for _ in 0..HALVINGS {
            let middle = 0.5 * (shares[0] + shares[1]);
            let (place, _) = self.form.on_trunk(lower, face, middle)?;
            if place.x < across.abs() {
                shares[0] = middle;
            } else {
                shares[1] = middle;
            }
        }
        let (place, outward) = self.form.on_trunk(lower, face, shares[1])?;
        let place = place + outward * CLOSE + Vec3::Y * CLOSE;
        Some(if across < 0.0 { mirrored(place) } else { place })
    }

    fn on_arm(&self, arm: Arm, place: DVec3) -> Option<Vec3> {
        let sleeve = self.sleeves[usize::from(!arm.is_left)].as_ref()?;
        let ratio = self.sized.size.ratio;
        let [down, across] = sleeve.seen(place, if arm.is_left { 1.0 } else { -1.0 });
        let whole = down.max(sleeve.begins[1]);
        let spans = [0, 1].map(|half| sleeve.span(half, whole));
        let own = spans[usize::from(!arm.is_front)]?;
        let width: f64 = (spans.iter().flatten()).map(|[low, high]| high - low).sum();
        let share = (own[1] - across) / (own[1] - own[0]).max(1.0e-4);
        let turn = std::f32::consts::PI * narrow(share.clamp(0.0, 1.0));
        let (sin, cos) = trig::sin_cos(if arm.is_front { turn } else { -turn });
        let radius = narrow(width * ratio) / std::f32::consts::TAU;
        let along = narrow((down - sleeve.begins[0]) * ratio);
        let [center, over, forward] = self.form.in_arm(along);
        let place = center + (over * cos + forward * sin) * radius;
        Some(if arm.is_left { place } else { mirrored(place) })
    }
}

/// Levels at which cloth does not go around take what the nearest one has.
fn filled(girths: &[Option<f64>]) -> Vec<f64> {
    let known: Vec<(usize, f64)> = (girths.iter().enumerate())
        .filter_map(|(at, girth)| Some((at, (*girth)?)))
        .collect();
    let nearest = |at: usize| {
        let near = known.iter().min_by_key(|(other, _)| other.abs_diff(at));
        near.map_or(1.0, |(_, girth)| *girth)
    };
    let all = girths.iter().enumerate();
    all.map(|(at, girth)| girth.unwrap_or_else(|| nearest(at)))
        .collect()
}

impl Sleeve {
    /// The sleeve of one arm: `left` is 1 of the left one and -1 of the right one.
    fn new(given: &Given, around: &Around, left: f64) -> Option<Self> {
        let own = |piece: usize| match around.panels[piece].part {
            Part::Arm(arm) => (arm.is_left == (0.0 < left)).then_some(arm),
            Part::Trunk(_) => None,
        };
        let seen = |piece: usize, point: DVec2| {
            let place = given.panels[piece].place(point);
            DVec2::new(left * place.x, place.y)
        };
        // Edges that are sewn to the trunk, and those that nothing is sewn to.
        let (mut armhole, mut free) = (Vec::new(), Vec::new());
        for (piece, drawn) in given.pattern.pieces.iter().enumerate() {
            if own(piece).is_none() {
                continue;
            }
            for (edge, line) in drawn.edges.iter().enumerate() {
                let other = given.sewn_to(piece, edge);
                let into = match other {
                    None => &mut free,
                    Some(other) if own(other).is_none() => &mut armhole,
                    Some(_) => continue,
                };
                into.extend(
                    line.ends()
                        .map(|point| seen(piece, DVec2::new(point.x, point.y))),
                );
            }
        }
        let middle = |points: &[DVec2]| points.iter().sum::<DVec2>() / points.len().max(1) as f64;
        let down = (middle(&free) - middle(&armhole)).try_normalize();
        let down = down.filter(|_| !free.is_empty() && !armhole.is_empty())?;
        let across = if down.x < 0.0 {
            -down.perp()
        } else {
            down.perp()
        };
        let axes = [down, across];
        let mut sleeve = Self {
            axes,
            begins: [f64::INFINITY, f64::NEG_INFINITY],
            borders: [Vec::new(), Vec::new()],
        };
        for (piece, panel) in around.panels.iter().enumerate() {
            let Some(arm) = own(piece) else { continue };
            let border = panel.border.iter();
            let border: Vec<DVec2> = border
                .map(|place| DVec2::from(sleeve.seen(*place, left)))
                .collect();
            let first = border
                .iter()
                .fold(f64::INFINITY, |first, at| first.min(at.x));
            sleeve.begins[0] = sleeve.begins[0].min(first);
            sleeve.borders[usize::from(!arm.is_front)].push(border);
        }
        let latest = armhole.iter().map(|point| point.dot(down));
        sleeve.begins[1] = latest.fold(f64::NEG_INFINITY, f64::max) + 0.5 * LEVEL;
        Some(sleeve)
    }

    /// A place of the file's body down the arm and across it, as on her left.
    fn seen(&self, place: DVec3, left: f64) -> [f64; 2] {
        let place = DVec2::new(left * place.x, place.y);
        self.axes.map(|axis| axis.dot(place))
    }

    /// From where to where a half reaches across the arm so far down it; what is beyond its end is as its end.
    fn span(&self, half: usize, down: f64) -> Option<[f64; 2]> {
        let borders = &self.borders[half];
        let last = borders
            .iter()
            .flatten()
            .fold(f64::NEG_INFINITY, |last, at| last.max(at.x));
        let down = down.min(last - 0.1 * LEVEL);
        let mut span = [f64::INFINITY, f64::NEG_INFINITY];
        for border in borders {
            let next = border.iter().cycle().skip(1);
            for (a, b) in border.iter().zip(next) {
                if (a.x <= down) != (b.x <= down) {
                    let across = a.y + (b.y - a.y) * (down - a.x) / (b.x - a.x);
                    span = [span[0].min(across), span[1].max(across)];
                }
            }
        }
        (span[0] < span[1]).then_some(span)
    }
}

/// Places of all particles [m], and which of them are held; `None` where she has no trunk there.
pub(super) fn lay(
    sized: Sized<'_>,
    (panels, mesh): (&Panels, &FlatMesh),
    (form, measures): (&Form<'_>, &Measures),
) -> Option<(Vec<Vec3>, Vec<bool>)> {
    let placing = Placing::new(sized, form, measures);
    let particles = mesh.in_piece.iter().zip(&mesh.panel_of);
    let places = particles.map(|(&point, &panel)| {
        let piece = panels.panels[panel].piece;
        placing.place(piece, point)
    });
    let mut places: Vec<Vec3> = places.collect::<Option<_>>()?;
    let held = held(sized, (panels, mesh));
    let gaps: Vec<f32> = (held.iter())
        .map(|&is_held| if is_held { BAND_GAP } else { fit::START_GAP })
        .collect();
    fit::close_seams((mesh, &gaps), form, &mut places);
    draw_along((mesh, &gaps, &held), form, &mut places);
    Some((places, held))
}

/// Particles of the upper edge of what is worn from a band.
fn held(sized: Sized<'_>, (panels, mesh): (&Panels, &FlatMesh)) -> Vec<bool> {
    let size = sized.size;
    let mut held = vec![false; mesh.flat.len()];
    if size.hang != Hang::Band {
        return held;
    }
    let level = |particle: u32| {
        let particle = particle as usize;
        let piece = panels.panels[mesh.panel_of[particle]].piece;
        let place = sized.given.panels[piece].place(mesh.in_piece[particle] / size.ratio);
        place.y
    };
    for &particle in &mesh.hems {
        held[particle as usize] = size.top[0] - NEAR_TOP < level(particle);
    }
    // Corners of the edge lie in seams.
    let edge = held.clone();
    let ends = mesh
        .triangles
        .iter()
        .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    for [a, b] in ends {
        for [one, other] in [[a, b], [b, a]] {
            let is_beside = edge[one as usize] && !edge[other as usize];
            if is_beside && level(one) - 0.5 * LEVEL < level(other) {
                held[other as usize] = true;
            }
        }
    }
    held
}

/// Cloth that is longer than it is cut draws what is beside it along, until nothing is stretched that can give.
fn draw_along(
    (mesh, gaps, held): (&FlatMesh, &[f32], &[bool]),
    form: &Form<'_>,
    places: &mut [Vec3],
) {
    let groups = welded(mesh);
    let mut is_fixed = vec![false; places.len()];
    for (&group, &is_held) in groups.iter().zip(held) {
        is_fixed[group as usize] |= is_held;
    }
    let mut sides: Vec<[u32; 2]> = (mesh.triangles.iter())
        .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
        .map(|[a, b]| [a.min(b), a.max(b)])
        .collect();
    sides.sort_unstable();
    sides.dedup();
    let length = |[a, b]: [u32; 2]| {
        let [a, b]: [Vec2; 2] = [a, b].map(|end| mesh.flat[end as usize]);
        a.distance(b)
    };
    let sides: Vec<([u32; 2], f32)> = (sides.into_iter())
        .map(|side| (side.map(|end| groups[end as usize]), TAUT * length(side)))
        .filter(|([a, b], _)| a != b)
        .collect();
    for pass in 0..DRAWING_PASSES {
        for &([a, b], most) in &sides {
            let [a, b] = [a as usize, b as usize];
            let way = places[b] - places[a];
            let length = way.length();
            if length <= most {
                continue;
            }
            let shares = match [is_fixed[a], is_fixed[b]] {
                [true, true] => continue,
                [true, false] => [0.0, 1.0],
                [false, true] => [1.0, 0.0],
                [false, false] => [0.5, 0.5],
            };
            let step = way * ((length - most) / length);
            places[a] += step * shares[0];
            places[b] -= step * shares[1];
        }
        if (pass + 1) % PASSES_OF_SKIN == 0 {
            let is_free = |particle: usize| !is_fixed[particle];
            form.push_out_some(places, |particle| {
                let is_first = groups[particle] == number(particle);
                (is_first && is_free(particle)).then_some(gaps[particle])
            });
        }
    }
    for particle in 0..places.len() {
        places[particle] = places[groups[particle] as usize];
    }
}
