//! From measured sections to the dancer's surface: a half mesh in the bind pose with her tape.
//!
//! Sections, blended and scaled → hard minimum of tubes → marching cubes → smoothing →
//! heights and girths → simplification → regions. All on the left half; the mirror image closes it.

pub(crate) mod field;
mod fine;
pub(crate) mod half;
mod head;
mod march;
pub(crate) mod pchip;
pub(crate) mod regions;
pub(crate) mod section;
mod shoulders;
mod simplify;
pub(crate) mod slice;
pub(crate) mod warp;

use std::collections::BTreeMap;

use glam::Vec3;
use lole_language::Sentence;

use crate::parts::Shares;
use crate::sections::{Sections, Tube, read_bodies};
use crate::{BodyError, Figure, Measure, Measurements, PartKind};
pub(crate) use field::Field;
use fine::Fine;
use half::{HalfMesh, Neighbors, is_on_plane};
use regions::Regions;
use shoulders::Shoulders;
use warp::{Girths, Heights, arm_share, asis_level, smooth_step};

/// Lattice steps [m], tried until the surface has no handle: fingers that nearly touch grow
/// together on a coarse lattice.
const LATTICE_STEPS: [f32; 4] = [0.004, 0.0034, 0.0029, 0.0025];
const TAUBIN_PASSES: usize = 2;
const FAIRING_PASSES: usize = 50;
const FACE_PASSES: usize = 10;

/// The left half of the finished surface and what was measured on the way.
pub(crate) struct Shape {
    pub(crate) positions: Vec<Vec3>,
    pub(crate) normals: Vec<Vec3>,
    pub(crate) labels: Vec<Tube>,
    pub(crate) triangles: Vec<[u32; 3]>,
    /// Material of each triangle.
    pub(crate) kinds: Vec<PartKind>,
    /// The sections with final heights; joints with final girths.
    pub(crate) body: Sections,
    pub(crate) crotch: f32,
    /// The head's field before heights were carried; `body.head.center` is where it ended.
    pub(crate) head: Field,
    pub(crate) asis: f32,
    /// Size of the head over the mean woman's.
    pub(crate) head_size: f32,
    /// Which measured bodies she is made of.
    pub(crate) made_of: MadeOf,
    /// How she came from them to her measures.
    pub(crate) placing: Placing,
}

/// Shares of the measured bodies, and where the head of their sections went.
pub(crate) struct MadeOf {
    /// Of the body.
    pub(crate) body: Shares,
    /// Of the head, which a small child's proportions are not carried on to.
    pub(crate) head: Shares,
    /// Middle of the head of these shares, and where it is in the sections [m].
    pub(crate) head_moved: [Vec3; 2],
    /// How much the head is grown about it.
    pub(crate) head_grown: f32,
}

/// From the sections of the measured bodies to the body of a tape.
pub(crate) struct Placing {
    floor: f32,
    heights: Heights,
    shoulders: Option<Shoulders>,
    girths: Girths,
}

impl Placing {
    /// Points of the left half, each of which rides with the arm by so much.
    pub(crate) fn carry(&self, points: &[Vec3], arms: &[f32]) -> Vec<Vec3> {
        let placed = points.iter().zip(arms).map(|(&point, &arm)| {
            let point = self.heights.carry(point - Vec3::Y * self.floor, arm);
            let shoulders = self.shoulders.as_ref();
            shoulders.map_or(point, |it| it.carry(point, arm))
        });
        self.girths.warp(&placed.collect::<Vec<_>>(), arms)
    }
}

/// Builds the left half of the dancer's surface.
pub(crate) fn build(tape: &Measurements) -> Result<Shape, BodyError> {
    let (mut body, mut made_of) = nearest_body(&read_bodies()?, tape)?;
    if tape.figure == Figure::Child {
        made_of.head_grown = head::grow(&mut body);
    }
    made_of.head_moved[1] = body.head.center;
    let head_size = head::size(&body.head);
    let field = Field::new(&body);
    let (mut mesh, neighbors) = closed_half(&field)?;
    mesh.smooth(&neighbors, TAUBIN_PASSES);
    mesh.fair(&neighbors, &fairing_balls(&body), FAIRING_PASSES);
    let (floor, crotch, crown) = extent(&mesh)?;
    for position in &mut mesh.positions {
        position.y -= floor;
    }
    let heights = Heights::new(&body, crotch - floor, crown - floor, tape);
    let arms = arm_shares(&mesh, &neighbors, &body);
    for (position, &arm) in mesh.positions.iter_mut().zip(&arms) {
        *position = heights.carry(*position, arm);
    }
    let asis = heights.at(asis_level(&body));
    let mut body = heights.carry_sections(&body);
    #[expect(clippy::cast_possible_truncation, reason = "a length to 0.1 µm")]
    let crotch = tape.inseam_length.to_m() as f32;
    let shoulders = Shoulders::new(&body, tape, &mesh.positions, &mesh.triangles);
    if let Some(shoulders) = &shoulders {
        for (position, &arm) in mesh.positions.iter_mut().zip(&arms) {
            *position = shoulders.carry(*position, arm);
        }
        shoulders.carry_sections(&mut body);
    }
    let mut girths = Girths::new(&body, crotch, tape);

    let mut fine = Fine {
        base: mesh.positions.clone(),
        warped: girths.fit(&mesh.positions, &mesh.triangles, &arms)?,
        ..Fine::default()
    };
    mesh.positions.clone_from(&fine.warped);
    fine.normals = mesh.normals(&neighbors);
    let face = face_balls(&body, head_size);
    mesh.soften_normals(&mut fine.normals, &neighbors, &face, FACE_PASSES);
    fine.kinds = vec![PartKind::Skin; mesh.triangles.len()];
    fine.triangles = mesh.triangles;
    fine.labels = mesh.labels;
    fine.arms = arms;
    let regions = Regions::new(&body, crotch, head_size);
    fine.cut(PartKind::Leotard, |point, arm| regions.leotard(point, arm));
    fine.cut(PartKind::Face, |point, _| regions.face(point));
    fine.simplify(&body);
    let positions = girths.fit(&fine.base, &fine.triangles, &fine.arms)?;
    for (name, joint) in &mut body.joints {
        // A measured shoulder lies where the tape says, whatever the bust's scale does around it.
        let is_held = shoulders.is_some() && name == "leftUpperArm";
        let arm = if is_held { 1.0 } else { arm_share(name) };
        *joint = girths.warp_point(*joint, arm);
    }
    Ok(Shape {
        positions,
        normals: fine.normals,
        labels: fine.labels,
        triangles: fine.triangles,
        kinds: fine.kinds,
        body,
        crotch,
        head: field,
        asis,
        head_size,
        made_of,
        placing: Placing {
            floor,
            heights,
            shoulders,
            girths,
        },
    })
}

/// The left half of the body's surface, with its neighbors: one disk, so that it and its mirror
/// image make a sphere.
fn closed_half(field: &Field) -> Result<(HalfMesh, Neighbors), BodyError> {
    for step in LATTICE_STEPS {
        let mut mesh = march::march(&field.sample(step));
        let neighbors = mesh.keep_largest();
        if mesh.euler_characteristic() == 1 {
            return Ok((mesh, neighbors));
        }
    }
    Err(BodyError::Unbuildable {
        reason: Sentence::new("手足がつながってしまいます", "its limbs grow together"),
        check: Measure::Stature.words(),
        against: Measure::Hip.words(),
    })
}

/// The measured body, or blend of bodies, whose proportions this dancer has, at her stature.
fn nearest_body(
    bodies: &BTreeMap<String, Sections>,
    tape: &Measurements,
) -> Result<(Sections, MadeOf), BodyError> {
    const WOMEN: [&str; 4] = ["woman_mean", "woman_60s", "woman_small", "woman_large"];
    const WOMEN_AND_CHILDREN: [&str; 6] = [
        "woman_mean",
        "woman_60s",
        "woman_small",
        "woman_large",
        "child_8",
        "child_12",
    ];
    let names: &[&str] = match tape.figure {
        Figure::OfStature => &WOMEN_AND_CHILDREN,
        Figure::Woman => &WOMEN,
        Figure::Man => &["man_mean"],
        Figure::Child => return child(bodies, tape),
    };
    let (body, shares) = nearest_blend(bodies, names, tape)?;
    let head = shares.clone();
    Ok((body, MadeOf::new(bodies, shares, head)))
}

impl MadeOf {
    fn new(bodies: &BTreeMap<String, Sections>, body: Shares, head: Shares) -> Self {
        let centers = head
            .iter()
            .filter_map(|(name, share)| Some(bodies.get(name)?.head.center * *share));
        let center = centers.sum();
        Self {
            body,
            head,
            head_moved: [center, center],
            head_grown: 1.0,
        }
    }
}

/// A child's proportions by stature: on the line through the two measured children, carried on
/// beyond the younger one, whose head is larger and whose legs are shorter.
fn child(
    bodies: &BTreeMap<String, Sections>,
    tape: &Measurements,
) -> Result<(Sections, MadeOf), BodyError> {
    /// How far beyond the younger child the line is carried on: to 100 cm.
    const YOUNGEST: f32 = -1.22;
    /// How far the line is carried on for the head: not beyond the younger child, for the size of the
    /// head is a survey's.
    const LEAST_FACE: f32 = 0.0;
    let named = |name: &str| {
        bodies.get(name).ok_or_else(|| BodyError::Sections {
            reason: format!("{name} is missing"),
        })
    };
    let (younger, older) = (named("child_8")?, named("child_12")?);
    #[expect(clippy::cast_possible_truncation, reason = "a length to 0.1 µm")]
    let stature = tape.stature.to_m() as f32;
    let share = (stature - younger.height) / (older.height - younger.height);
    let share = share.clamp(YOUNGEST, 1.0);
    let scales = [younger, older].map(|body| stature / body.height);
    let [low, high] = [younger.scaled(scales[0]), older.scaled(scales[1])];
    let shares = |share: f32| -> Shares {
        let names = ["child_8", "child_12"].into_iter().map(str::to_owned);
        names
            .zip([(1.0 - share) * scales[0], share * scales[1]])
            .collect()
    };
    let blended = |share: f32| {
        let blend = Sections::blended(&[(1.0 - share, &low), (share, &high)]);
        blend.ok_or_else(|| BodyError::Sections {
            reason: "no child in the table".to_owned(),
        })
    };
    let mut body = blended(share)?;
    // A face does not bear it: beyond the younger child it keeps its features.
    let face = blended(share.max(LEAST_FACE))?.head;
    (body.head.radii, body.head.face) = (face.radii, face.face);
    let made_of = MadeOf::new(bodies, shares(share), shares(share.max(LEAST_FACE)));
    Ok((body, made_of))
}

/// The convex blend of the named bodies nearest to the tape, at her stature.
///
/// Nearest in girths over stature, with a little pull of stature itself, by projected gradient
/// descent from the first name; the tape warp removes the rest.
fn nearest_blend(
    bodies: &BTreeMap<String, Sections>,
    names: &[&str],
    tape: &Measurements,
) -> Result<(Sections, Shares), BodyError> {
    const STATURE_WEIGHT: f64 = 0.25;
    const STEPS: usize = 600;
    let stature = tape.stature.to_m();
    let feature = |height: f64, girths: [f64; 3]| {
        let [bust, waist, hip] = girths.map(|girth| girth / height);
        [bust, waist, hip, STATURE_WEIGHT * height]
    };
    let found = names
        .iter()
        .filter_map(|&name| Some((name, bodies.get(name)?)));
    let (names, found): (Vec<&str>, Vec<&Sections>) = found.unzip();
    let wanted = feature(
        stature,
        [tape.bust_girth, tape.waist_girth, tape.hip_girth].map(lole_geom::Length::to_m),
    );
    let offsets: Vec<[f64; 4]> = (found.iter())
        .map(|body| {
            let has = feature(f64::from(body.height), body.girths.map(f64::from));
            std::array::from_fn(|k| has[k] - wanted[k])
        })
        .collect();
    let steepness: f64 = offsets.iter().flatten().map(|x| x * x).sum();
    let step = 1.0 / steepness.max(1.0e-9);
    let mut shares = vec![0.0; found.len()];
    if let Some(first) = shares.first_mut() {
        *first = 1.0;
    }
    for _ in 0..STEPS {
        let residual: [f64; 4] = std::array::from_fn(|k| {
            shares
                .iter()
                .zip(&offsets)
                .map(|(share, offset)| share * offset[k])
                .sum()
        });
        for (share, offset) in shares.iter_mut().zip(&offsets) {
            let slope: f64 = residual.iter().zip(offset).map(|(r, x)| r * x).sum();
            *share -= step * slope;
        }
        project_to_simplex(&mut shares);
    }
    #[expect(clippy::cast_possible_truncation, reason = "a share to seven digits")]
    let scaled: Vec<(f32, Sections, (String, f32))> = (shares.iter().zip(&found).zip(names))
        .filter(|((share, _), _)| **share > 1.0e-4)
        .map(|((&share, body), name)| {
            let (share, scale) = (share as f32, (stature / f64::from(body.height)) as f32);
            (share, body.scaled(scale), (name.to_owned(), share * scale))
        })
        .collect();
    let blend: Vec<(f32, &Sections)> = (scaled.iter())
        .map(|(share, body, _)| (*share, body))
        .collect();
    let body = Sections::blended(&blend).ok_or_else(|| BodyError::Sections {
        reason: "no such body in the table".to_owned(),
    })?;
    Ok((body, scaled.into_iter().map(|(.., share)| share).collect()))
}

/// Nearest point with shares that are not negative and sum to 1 (Duchi et al. 2008).
fn project_to_simplex(shares: &mut [f64]) {
    let mut sorted = shares.to_vec();
    sorted.sort_by(|a, b| b.total_cmp(a));
    let mut sum = 0.0;
    let mut shift = 0.0;
    for (index, &share) in sorted.iter().enumerate() {
        sum += share;
        let candidate = (sum - 1.0) / (index + 1) as f64;
        if share > candidate {
            shift = candidate;
        }
    }
    for share in shares {
        *share = (*share - shift).max(0.0);
    }
}

/// Where tubes meet badly: under the crotch (flat rings see it edge-on) and in the armpit.
fn fairing_balls(body: &Sections) -> [(Vec3, f32); 3] {
    let k = body.height / 1.585;
    let level = |name: &str| body.level(name);
    let crotch = level("crotch") + 0.004 * k;
    let armpit = Vec3::new(
        level("armpit_x") + 0.01 * k,
        level("armpit"),
        level("armpit_z") - 0.012 * k,
    );
    [
        (
            Vec3::new(0.0, crotch, level("crotch_z") + 0.02 * k),
            0.05 * k,
        ),
        (
            Vec3::new(0.0, crotch, level("crotch_z") - 0.01 * k),
            0.045 * k,
        ),
        (armpit, 0.06 * k),
    ]
}

/// Where the face's light is evened out: eye, mouth with chin, and cheek.
fn face_balls(body: &Sections, k: f32) -> [(Vec3, f32); 4] {
    let at = |x: f32, y: f32, z: f32| body.head.center + Vec3::new(x, y, z) * k;
    [
        (at(0.031, -0.006, 0.085), 0.030 * k),
        (at(0.0, -0.076, 0.085), 0.055 * k),
        (at(0.035, -0.050, 0.070), 0.050 * k),
        (at(0.0, -0.052, 0.100), 0.030 * k),
    ]
}

/// Floor, crotch (lowest point on the mirror plane) and crown heights.
fn extent(mesh: &HalfMesh) -> Result<(f32, f32, f32), BodyError> {
    let lowest = |points: &mut dyn Iterator<Item = &Vec3>| {
        points.map(|point| point.y).fold(f32::INFINITY, f32::min)
    };
    let floor = lowest(&mut mesh.positions.iter());
    let crotch = lowest(&mut mesh.positions.iter().filter(|point| is_on_plane(**point)));
    let crown = mesh
        .positions
        .iter()
        .map(|point| point.y)
        .fold(0.0, f32::max);
    if crotch - floor < 0.3 * (crown - floor) || !crotch.is_finite() {
        return Err(BodyError::Unbuildable {
            reason: Sentence::new("脚がつながってしまいます", "its legs grow together"),
            check: Measure::Hip.words(),
            against: Measure::Inseam.words(),
        });
    }
    Ok((floor, crotch, crown))
}

/// Share of each vertex that belongs to the arm, fading over the shoulder.
fn arm_shares(mesh: &HalfMesh, neighbors: &Neighbors, body: &Sections) -> Vec<f32> {
    const PASSES: usize = 18;
    let k = body.height / 1.585;
    let shoulder = body.joint("leftUpperArm");
    let along = (body.joint("leftLowerArm") - shoulder).normalize_or_zero();
    let normal = (along + Vec3::new(0.55, 0.0, 0.0)).normalize_or_zero();
    let mut shares: Vec<f32> = (mesh.positions.iter().zip(&mesh.labels))
        .map(|(&position, label)| {
            let past = (position - shoulder).dot(normal);
            if label.is_arm() {
                smooth_step((past + 0.035 * k) / (0.085 * k))
            } else {
                0.0
            }
        })
        .collect();
    // All but a band around the shoulder is 0 or 1 and stays so: only what is beside a change can change.
    let mut open: Vec<usize> = (0..shares.len()).collect();
    let mut is_open = vec![false; shares.len()];
    for _ in 0..PASSES {
        let found = open.iter().map(|&vertex| {
            let (share, around) = (shares[vertex], neighbors.of(vertex));
            let sum: f32 = around.iter().map(|&other| shares[other as usize]).sum();
            0.5 * share + 0.5 * sum / around.len() as f32
        });
        let found: Vec<f32> = found.collect();
        let mut next = Vec::new();
        for (&vertex, &share) in open.iter().zip(&found) {
            let around = neighbors.of(vertex).iter().map(|&other| other as usize);
            if shares[vertex] != share && 0 < around.len() {
                shares[vertex] = share;
                let fresh = |it: &usize| !std::mem::replace(&mut is_open[*it], true);
                next.extend(around.chain([vertex]).filter(fresh));
            }
        }
        for &vertex in &next {
            is_open[vertex] = false;
        }
        open = next;
    }
    shares
}
