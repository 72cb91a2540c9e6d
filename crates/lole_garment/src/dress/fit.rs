//! Sewing on the dancer: seams are closed, then the cloth comes to rest on her skin while she goes from
//! the pose in which she is dressed to the one in which she stands.

use glam::{Affine3A, Vec3};
use lole_body::{Bone, Dancer, Pose};
use lole_cloth::Lost;
use lole_cloth::assembly::Assembly;
use lole_geom::{MeshSurfels, Surfel};

use super::flat::FlatMesh;
use super::form::Form;
use super::smooth::Smoothing;
use super::under::Under;
use super::wrap::along;
use super::{DressError, Dressed, DressedState, Ease, Kit, World, assembly, laid};

/// How far she lifts her arms to be dressed from where they are built, 47° below the level [rad].
const RAISED: f32 = 0.75;
/// Passes in which pieces are drawn together and out of the skin before anything moves.
const CLOSING_PASSES: u32 = 3;
/// Passes in which what is drawn at the seams is spread over the pieces.
const SPREADING_PASSES: u32 = 120;
/// Least distance from the skin at the start [m].
pub(crate) const START_GAP: f32 = 0.006;

/// Frames in which what is tied is drawn to its knot, in which the seams come together, in which she takes her stance, and in which cloth comes to
/// rest.
const LEADING_FRAMES: u32 = 100;
const SEWING_FRAMES: u32 = 24;
const MOVING_FRAMES: u32 = 45;
const RESTING_FRAMES: u32 = 30;
/// How often what lies through itself is smoothed at most, and frames in which it comes to rest again.
const SMOOTHING_ROUNDS: u32 = 8;
const SMOOTHED_FRAMES: u32 = 12;
/// Cloth deeper in the skin than this has been drawn through it [m].
const SUNK: f32 = 0.004;
/// A round that draws more than one particle in so many into it is taken back.
const DRAWN_THROUGH: usize = 200;
/// Duration of a frame [s].
const FRAME: f32 = 1.0 / 60.0;
/// Velocity kept from frame to frame while she moves, and while it comes to rest.
const KEPT: [f32; 2] = [0.6, 0.85];

/// The pose in which she is dressed: arms away from the sides.
pub(crate) fn fitting_pose() -> Pose {
    laid::arms_raised(RAISED)
}

/// Draws what is sewn together to one place and spreads the way over the pieces, so that nothing is
/// torn when the seams are tight; keeps all of it out of the skin.
pub(super) fn close_seams((mesh, gaps): (&FlatMesh, &[f32]), form: &Form<'_>, places: &mut [Vec3]) {
    let count = places.len();
    let groups = super::welded(mesh);
    let mut is_sewn = vec![false; count];
    for &particle in mesh.stitches.iter().flatten() {
        is_sewn[particle as usize] = true;
    }
    let mut is_led = is_sewn.clone();
    for &(particle, ..) in &mesh.puckers {
        is_led[particle as usize] = true;
    }
    let mut neighbors: Vec<Vec<u32>> = vec![Vec::new(); count];
    for &[a, b, c] in &mesh.triangles {
        for [one, other] in [[a, b], [b, c], [c, a], [b, a], [c, b], [a, c]] {
            neighbors[one as usize].push(other);
        }
    }
    for _ in 0..CLOSING_PASSES {
        form.push_out(places, |particle| gaps[particle]);
        let mut sums = vec![(Vec3::ZERO, 0.0_f32); count];
        for (&group, &place) in groups.iter().zip(&*places) {
            let sum = &mut sums[group as usize];
            *sum = (sum.0 + place, sum.1 + 1.0);
        }
        let middle = |particle: u32| {
            let (sum, members) = sums[groups[particle as usize] as usize];
            sum / members
        };
        let mut moves = vec![Vec3::ZERO; count];
        for (particle, place) in (0..).zip(&*places) {
            if is_sewn[particle as usize] {
                moves[particle as usize] = middle(particle) - *place;
            }
        }
        // What is gathered in between lies in the seam too.
        for &(particle, ends, share) in &mesh.puckers {
            let [first, last] = ends.map(middle);
            moves[particle as usize] = first.lerp(last, share) - places[particle as usize];
        }
        for _ in 0..SPREADING_PASSES {
            for particle in 0..count {
                if !is_led[particle] && !neighbors[particle].is_empty() {
                    let near = neighbors[particle]
                        .iter()
                        .map(|&other| moves[other as usize]);
                    moves[particle] = near.sum::<Vec3>() / neighbors[particle].len() as f32;
                }
            }
        }
        for (place, change) in places.iter_mut().zip(&moves) {
            *place += *change;
        }
    }
    form.push_out(places, |particle| gaps[particle]);
}

/// Sews the garment tight and lets it come to rest.
pub(super) fn fit(
    (garment, kit): (&mut Dressed, &Kit),
    body: (&Dancer, &MeshSurfels),
    (stance, under): (&Pose, &mut Under<'_>),
) -> Result<(), DressError> {
    let basted = assembly(kit, Ease::Basted)?;
    let mut state = garment.state();
    let mut room = Room::default();
    let start = fitting_pose();
    let smoothing = Smoothing::new(garment);
    let template = kit.template;
    let lost = |lost| DressError::Lost { template, lost };
    lead((garment, kit, &basted), body, (&start, under), &mut state).map_err(lost)?;
    for frame in 0..SEWING_FRAMES + MOVING_FRAMES + RESTING_FRAMES {
        let moved = frame.saturating_sub(SEWING_FRAMES).min(MOVING_FRAMES);
        let share = moved as f32 / MOVING_FRAMES as f32;
        let pose = between(&start, stance, share * share * (3.0 - 2.0 * share));
        let assembly = if frame < SEWING_FRAMES {
            &basted
        } else {
            &garment.assembly
        };
        let world = room.world(body, (&pose, under));
        let moved_on = state.step_as(garment, assembly, (&world, FRAME));
        moved_on.map_err(lost)?;
        let kept = if frame < SEWING_FRAMES {
            0.0
        } else if moved < MOVING_FRAMES {
            KEPT[0]
        } else {
            KEPT[1]
        };
        state.scale_velocities(garment, kept);
        if frame + 1 == SEWING_FRAMES {
            smooth(
                (garment, &smoothing),
                body,
                (&basted, &start, 0.0),
                (under, &mut state),
            )
            .map_err(lost)?;
        }
    }
    let rested = (&garment.assembly, stance, KEPT[0]);
    smooth((garment, &smoothing), body, rested, (under, &mut state)).map_err(lost)?;
    garment.start_from(state);
    Ok(())
}

/// Draws what is tied to the place of its knot, on a dancer in a pose, while it slips as when it is sewn.
fn lead(
    (garment, kit, basted): (&Dressed, &Kit, &Assembly),
    body: (&Dancer, &MeshSurfels),
    (pose, under): (&Pose, &mut Under<'_>),
    state: &mut DressedState,
) -> Result<(), Lost> {
    if kit.led.is_empty() {
        return Ok(());
    }
    let mut room = Room::default();
    let world = room.world(body, (pose, under));
    for frame in 1..=LEADING_FRAMES {
        let share = frame as f32 / LEADING_FRAMES as f32;
        let mut pins = garment.pin_targets(&world);
        for (pin, way) in &kit.led {
            pins[*pin] = along(way, share);
        }
        state.step_to((pins, &mut |_| {}), basted, (&world, FRAME))?;
        state.scale_velocities(garment, KEPT[1]);
    }
    Ok(())
}

/// Smooths what lies through itself on a dancer in a pose, and lets it come to rest again, sewn as `assembly`
/// with so much of its velocity kept.
fn smooth(
    (garment, smoothing): (&Dressed, &Smoothing),
    body: (&Dancer, &MeshSurfels),
    (assembly, pose, kept): (&Assembly, &Pose, f32),
    (under, state): (&mut Under<'_>, &mut DressedState),
) -> Result<(), Lost> {
    let form = Form::new(body.0, pose, body.0.landmarks.crotch_height);
    let mut room = Room::default();
    let count = |state: &DressedState| {
        let mut places = Vec::new();
        state.copy_positions(garment, &mut places);
        let crossings = garment.crossings(&places).unwrap_or(usize::MAX);
        (crossings, places)
    };
    let (mut least, mut places) = count(state);
    // No round leaves more than there was, nor draws cloth through her.
    let most_sunk = sunk(&form, &places) + places.len() / DRAWN_THROUGH;
    let mut best = state.clone();
    for round in 0..SMOOTHING_ROUNDS {
        if !smoothing.smooth(garment, (&form, round), &mut places) {
            break;
        }
        state.lay(assembly, &places);
        let world = room.world(body, (pose, under));
        for _ in 0..SMOOTHED_FRAMES {
            state.step_as(garment, assembly, (&world, FRAME))?;
            state.scale_velocities(garment, kept);
        }
        let crossings;
        (crossings, places) = count(state);
        if crossings < least && sunk(&form, &places) <= most_sunk {
            least = crossings;
            best = state.clone();
        }
    }
    *state = best;
    Ok(())
}

/// Places that lie in her skin.
fn sunk(form: &Form<'_>, places: &[Vec3]) -> usize {
    let mut outside = places.to_vec();
    form.push_out(&mut outside, |_| -SUNK);
    let pairs = places.iter().zip(&outside);
    pairs.filter(|(place, outside)| place != outside).count()
}

/// Lets a garment come to rest again on a dancer in her stance.
pub(super) fn rest(
    garment: &mut Dressed,
    body: (&Dancer, &MeshSurfels),
    (stance, under): (&Pose, &mut Under<'_>),
) -> Result<(), Lost> {
    let mut state = garment.state();
    let mut room = Room::default();
    let world = room.world(body, (stance, under));
    for _ in 0..RESTING_FRAMES {
        state.step(garment, &world, FRAME)?;
        state.scale_velocities(garment, KEPT[1]);
    }
    garment.start_from(state);
    Ok(())
}

/// Room for the dancer in a pose.
#[derive(Default)]
struct Room {
    world_from_bind: Vec<Affine3A>,
    positions: Vec<Vec3>,
    normals: Vec<Vec3>,
    surfels: Vec<Surfel>,
}

impl Room {
    /// The dancer in a pose, as cloth meets her.
    fn world(
        &mut self,
        (dancer, skin): (&Dancer, &MeshSurfels),
        (pose, under): (&Pose, &mut Under<'_>),
    ) -> World<'_> {
        self.world_from_bind = dancer.skeleton.world_from_bind(pose);
        (dancer.skin).pose(
            &self.world_from_bind,
            &mut self.positions,
            &mut self.normals,
        );
        skin.pose(&self.positions, &self.normals, &mut self.surfels);
        under.add(&self.world_from_bind, &mut self.surfels);
        World {
            held: &[],
            skin: (&self.positions, &self.normals),
            surfels: &self.surfels,
            world_from_bind: &self.world_from_bind,
            air_velocity: Vec3::ZERO,
            floor: Vec3::ZERO,
        }
    }
}

/// A pose on the way from one to another.
fn between(from: &Pose, to: &Pose, share: f32) -> Pose {
    let mut pose = Pose {
        hips_translation: from.hips_translation.lerp(to.hips_translation, share),
        ..Pose::default()
    };
    for &bone in Bone::ALL {
        pose.rotate(bone, from.rotation(bone).slerp(to.rotation(bone), share));
    }
    pose
}
