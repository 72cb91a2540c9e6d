//! Pieces laid around a dancer, before they are sewn.

use glam::{DVec2, Vec3};
use lole_body::{Bone, Dancer, Pose};
use lole_geom::narrow;
use lole_pattern::pattern::SeamSide;
use lole_pattern::piece::Piece;
use lole_pattern::{Measures, Pattern};

use super::bodice::{Bodice, Covered, mirrored};
use super::flat::{self, FlatMesh};
use super::folded;
use super::form::Form;
use super::given::{self, Sized};
use super::panel::{self, Panels};
use super::wrap::{Carrier, Cloth, Wrap};
use super::{Division, DressError, Pins, fit};
use crate::template::SewnRow;

/// How the pieces of a garment lie.
#[derive(Debug)]
pub enum Way {
    /// Around trunk and arms. What each piece covers, by the piece's identifier; others are left out of
    /// the picture.
    Fitted(&'static [(&'static str, Covered)]),
    /// One rectangle, laid by a rule.
    Wrapped(Wrap),
    /// As the file says that it was read from.
    Given,
}

/// Finest and coarsest edges of triangles [m].
const SPACING: [f64; 2] = [0.010, 0.030];
/// Area that a particle has over the square of the spacing: √3 / 2.
const AREA_SHARE: f64 = 0.866;

/// A garment laid around the dancer, not yet sewn.
pub(super) struct Laid {
    pub(super) pattern: Pattern,
    pub(super) mesh: FlatMesh,
    /// Every particle [m].
    pub(super) places: Vec<Vec3>,
    /// By panel, whether its drawn side looks away from her.
    pub(super) facing: Vec<bool>,
    /// By panel, the piece of the pattern that it is cut as.
    pub(super) pieces: Vec<usize>,
    /// By panel, whether it covers an arm.
    pub(super) is_on_arm: Vec<bool>,
    /// Lengths of elastic in the mesh's lines [m].
    pub(super) elastics: Vec<f32>,
    /// Particles that the skin carries.
    pub(super) pinned: Vec<bool>,
    /// What carries them.
    pub(super) pins: Pins,
    /// Places among the pinned particles of those that are led to where they are tied, and the way of each [m].
    pub(super) led: Vec<(usize, Vec<Vec3>)>,
    /// Layers of cloth at every particle.
    pub(super) layers: Vec<f32>,
}

/// Layers of cloth at an edge of a given pattern to which nothing is sewn: it says nothing of allowances.
const GIVEN_EDGE_LAYERS: f32 = 2.0;

/// Cuts a garment out and lays it around a dancer in the pose in which she is dressed.
pub(super) fn lay(
    (template, row): (&'static str, &SewnRow),
    pattern: Pattern,
    (dancer, measures): (&Dancer, &Measures),
    (division, sized): (Division, Option<Sized<'_>>),
) -> Result<Laid, DressError> {
    let part_of = |piece: &Piece| match &row.way {
        Way::Fitted(parts) => {
            let mut rows = parts.iter();
            rows.find(|(id, _)| *id == piece.id).map(|(_, part)| *part)
        }
        Way::Wrapped(_) | Way::Given => Some(Covered::Wrap),
    };
    let parts: Vec<Option<Covered>> = pattern.pieces.iter().map(part_of).collect();
    let particle_count = row.particle_count * division.particle_share();
    let spacing = spacing(&pattern, &parts, particle_count);
    let lines: Vec<SeamSide> = pattern.drawn_in.iter().map(|drawn| drawn.line).collect();
    let panels = panel::panels(&pattern, spacing, |piece| part_of(piece).is_none(), &lines);
    let crossed = DressError::CrossedPiece {
        template,
        measure: "the bust girth and the back length",
    };
    let mut mesh = flat::mesh(&pattern, &panels, spacing).ok_or(crossed)?;
    let form = Form::new(dancer, &fit::fitting_pose(), LOWEST_TAPE);
    let no_trunk = || DressError::NoTrunk { template };
    let mut pinned = vec![false; mesh.flat.len()];
    let mut led = Vec::new();
    let places = match &row.way {
        Way::Fitted(_) => {
            let bodice = Bodice::new(&pattern, parts.clone(), measures);
            let bodice = bodice.ok_or(DressError::NotWorn { template })?;
            let gaps = vec![fit::START_GAP; mesh.flat.len()];
            places(&panels, (&mesh, &gaps), &form, |piece, point| {
                bodice.place(&form, piece, point)
            })
        }
        Way::Wrapped(wrap) => {
            let cloth = Cloth::new(&form, (&pattern, measures));
            pinned = tied((wrap, &cloth), &mut mesh, spacing);
            led = led_ways((wrap, &cloth), (&mesh, &pinned));
            wrapped((wrap, &cloth), (&panels, &mesh, &pinned), &form)
        }
        Way::Given => {
            let sized = sized.ok_or(DressError::NotWorn { template })?;
            let laid = given::lay(sized, (&panels, &mesh), (&form, measures));
            let (places, held) = laid.ok_or(DressError::Unlaid { template })?;
            pinned = held;
            Some(places)
        }
    };
    let places = places.ok_or_else(no_trunk)?;
    let held = held_places((&places, &pinned), &led);
    let pins = carry(&row.way, &form, &held).ok_or_else(no_trunk)?;
    let facing = (0..panels.panels.len()).map(|panel| faces_out(panel, &mesh, &places, &form));
    let facing = facing.collect();
    let is_on_arm = on_arms(&panels, &parts, sized);
    let drawn_in = pattern.drawn_in.iter();
    let elastics = drawn_in.map(|drawn| narrow(drawn.length.to_m())).collect();
    let layers = match row.way {
        Way::Given => given_layers(&mesh),
        _ => folded::layers(&pattern, (&panels, &mesh), spacing),
    };
    Ok(Laid {
        layers,
        mesh,
        places,
        facing,
        pieces: panels.panels.iter().map(|panel| panel.piece).collect(),
        is_on_arm,
        elastics,
        pinned,
        pins,
        led,
        pattern,
    })
}

/// Layers at every particle of a given pattern.
fn given_layers(mesh: &FlatMesh) -> Vec<f32> {
    let mut layers = vec![1.0; mesh.flat.len()];
    for &edge in &mesh.hems {
        layers[edge as usize] = GIVEN_EDGE_LAYERS;
    }
    layers
}

/// By panel, whether it covers an arm.
fn on_arms(panels: &Panels, parts: &[Option<Covered>], sized: Option<Sized<'_>>) -> Vec<bool> {
    let of_file = sized.map(|sized| sized.given.on_arms());
    let covered = panels.panels.iter().map(|panel| match &of_file {
        Some(of_file) => of_file[panel.piece],
        None => parts[panel.piece] == Some(Covered::Sleeve),
    });
    covered.collect()
}

/// Which particles are tied or tucked so firmly that they are pinned: what is knotted is stitched too.
fn tied((wrap, cloth): (&Wrap, &Cloth<'_>), mesh: &mut FlatMesh, spacing: f64) -> Vec<bool> {
    let points = mesh.in_piece.iter();
    let mut pinned: Vec<bool> = points
        .map(|&point| (wrap.is_pinned)(cloth, point, spacing))
        .collect();
    for ends in (wrap.knots)(cloth) {
        let knot = ends.map(|point| mesh.nearest(point));
        for particle in knot {
            pinned[particle as usize] = true;
        }
        mesh.stitches.push(knot);
    }
    pinned
}

/// Places among the pinned particles of those that are led to where they are tied, and the way of each [m].
fn led_ways(
    (wrap, cloth): (&Wrap, &Cloth<'_>),
    (mesh, pinned): (&FlatMesh, &[bool]),
) -> Vec<(usize, Vec<Vec3>)> {
    let all = mesh.in_piece.iter().zip(pinned);
    let held = all.filter(|(_, pinned)| **pinned);
    let ways = held.map(|(&point, _)| (wrap.led)(cloth, point));
    ways.enumerate()
        .filter(|(_, way)| !way.is_empty())
        .collect()
}

/// Where pinned particles are held [m], in their order: where they lie, or where they are led to.
fn held_places((places, pinned): (&[Vec3], &[bool]), led: &[(usize, Vec<Vec3>)]) -> Vec<Vec3> {
    let all = places.iter().zip(pinned);
    let lying = all.filter(|(_, pinned)| **pinned).map(|(place, _)| *place);
    let mut held: Vec<Vec3> = lying.collect();
    for (pin, way) in led {
        held[*pin] = way.last().copied().unwrap_or(held[*pin]);
    }
    held
}

/// What carries places that are pinned.
fn carry(way: &Way, form: &Form<'_>, held: &[Vec3]) -> Option<Pins> {
    let mut pins = form.carry(held)?;
    let carrier = match way {
        Way::Fitted(_) => Carrier::Skin,
        Way::Wrapped(wrap) => wrap.carrier,
        Way::Given => Carrier::Tape,
    };
    match carrier {
        Carrier::Skin => {}
        Carrier::Tape => pins.tied = held.iter().map(|&place| form.tied(place)).collect(),
        Carrier::Girded => pins.tied = form.girded(held)?,
    }
    Some(pins)
}

/// Places of all particles of one cloth that is wrapped.
fn wrapped(
    (wrap, cloth): (&Wrap, &Cloth<'_>),
    (panels, mesh, pinned): (&Panels, &FlatMesh, &[bool]),
    form: &Form<'_>,
) -> Option<Vec<Vec3>> {
    let gaps = mesh.in_piece.iter();
    let gaps: Vec<f32> = gaps.map(|&point| (wrap.gap)(cloth, point)).collect();
    let rule = |point: DVec2| (wrap.place)(cloth, point);
    let mut laid = places(panels, (mesh, &gaps), form, |_, point| rule(point))?;
    if wrap.carrier != Carrier::Skin {
        lay_as_ruled(&mut laid, (mesh, pinned), rule);
    }
    Some(laid)
}

/// Puts what is pinned back to where its rule laid it: moved out of the skin one by one, the layers of what
/// is girded would go through each other, and an edge under the arms would be torn where an arm hangs.
fn lay_as_ruled(
    places: &mut [Vec3],
    (mesh, pinned): (&FlatMesh, &[bool]),
    rule: impl Fn(DVec2) -> Option<Vec3>,
) {
    let all = places.iter_mut().zip(&mesh.in_piece).zip(pinned);
    for ((place, &point), _) in all.filter(|(_, pinned)| **pinned) {
        *place = rule(point).unwrap_or(*place);
    }
}

/// Edges of triangles [m] that divide the pieces that are worn into so many particles.
fn spacing(pattern: &Pattern, parts: &[Option<Covered>], particle_count: f64) -> f64 {
    let worn = pattern.pieces.iter().zip(parts);
    let areas = worn.filter(|(_, part)| part.is_some()).map(|(piece, _)| {
        let outline = piece.unfolded().stitching_polygon(1.0e-3);
        outline.signed_area().abs() * f64::from(piece.cut.pieces())
    });
    let spacing = (areas.sum::<f64>() / (AREA_SHARE * particle_count)).sqrt();
    spacing.clamp(SPACING[0], SPACING[1])
}

/// Lowest tape around trunk and legs [m].
const LOWEST_TAPE: f32 = 0.03;

/// Places of all particles.
fn places(
    panels: &Panels,
    (mesh, gaps): (&FlatMesh, &[f32]),
    form: &Form<'_>,
    place: impl Fn(usize, DVec2) -> Option<Vec3>,
) -> Option<Vec<Vec3>> {
    let particles = mesh.in_piece.iter().zip(&mesh.panel_of);
    let mut places: Vec<Vec3> = particles
        .map(|(&point, &panel)| {
            let panel = &panels.panels[panel];
            if panel.copy == 1 && !panel.is_mirrored {
                place(panel.piece, point).map(mirrored)
            } else if panel.is_mirrored {
                place(panel.piece, DVec2::new(-point.x, point.y)).map(mirrored)
            } else {
                place(panel.piece, point)
            }
        })
        .collect::<Option<_>>()?;
    fit::close_seams((mesh, gaps), form, &mut places);
    Some(places)
}

/// Whether the drawn side of a panel looks away from the trunk, or from the arm that it is around.
fn faces_out(panel: usize, mesh: &FlatMesh, places: &[Vec3], form: &Form<'_>) -> bool {
    let hips = form.joint(Bone::Hips);
    let arms = [
        [Bone::LeftUpperArm, Bone::LeftHand],
        [Bone::RightUpperArm, Bone::RightHand],
    ]
    .map(|bones| bones.map(|bone| form.joint(bone)));
    let away = |place: Vec3| {
        let from_trunk = (place - hips).with_y(0.0);
        let from_arms = arms.map(|[from, to]| {
            let axis = to - from;
            let share = (place - from).dot(axis) / axis.length_squared().max(1.0e-6);
            place - from - axis * share.clamp(0.0, 1.0)
        });
        let nearest = from_arms
            .into_iter()
            .min_by(|a, b| a.length().total_cmp(&b.length()));
        match nearest {
            Some(arm) if arm.length() < from_trunk.length() => arm,
            _ => from_trunk,
        }
    };
    let own = mesh.triangles.iter();
    let own = own.filter(|triangle| mesh.panel_of[triangle[0] as usize] == panel);
    let outward: f32 = own
        .map(|triangle| {
            let [a, b, c] = triangle.map(|corner| places[corner as usize]);
            let normal = (b - a).cross(c - a);
            normal.dot(away((a + b + c) / 3.0).normalize_or_zero())
        })
        .sum();
    0.0 <= outward
}

/// The pose in which she is dressed.
pub(super) fn arms_raised(raise: f32) -> Pose {
    let mut pose = Pose::default();
    pose.rotate(Bone::LeftUpperArm, glam::Quat::from_rotation_z(raise));
    pose.rotate(Bone::RightUpperArm, glam::Quat::from_rotation_z(-raise));
    pose
}
