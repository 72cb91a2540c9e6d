//! A stranger's dress, welded to one surface, on a body that is given as a moving triangle mesh: what the
//! engine's public interface does with it.
//!
//! `cargo run --release -p lole_stage --example stranger_dress -- [--obj cloth.obj [--unit METERS] [--uv METERS]]
//! [--pattern garment.json [--lift METERS]] [--tape STATURE,BUST,WAIST,HIP] [--bvh walk.bvh] [--seconds S]
//! [--edge METERS] [--substeps N] [--forearms] [--write FOLDER] [--trace]` prints a line a second: strain, crossings,
//! particles in the body, and what a frame costs. Without an OBJ file a dress with
//! sleeves is spread over the built dancer, without a recording she dances a kāholo with her arms up. An OBJ
//! stands where the dancer does: meters, `+Y` up, `+Z` her front, arms 47° below the horizontal; with `--uv`
//! its texture coordinates times so many meters are its flat pieces. A pattern is one of flat panels as
//! `GarmentCode` writes it, for a body that stands as she does, raised by so much where its origin is not on the
//! floor; what is sewn from it is drawn together before she dances. The tape [cm] is hers. `--forearms` lets
//! cloth meet those too, which a skirt does not. `--write` leaves dress and body as OBJ, for `draw_obj` of
//! `lole_render`.

#![expect(
    clippy::print_stdout,
    reason = "a tool prints figures, times among them"
)]

mod cotton;
mod dress;
mod obj;
mod panels;
mod seen;

use std::error::Error;
use std::num::NonZeroU32;
use std::path::{Path, PathBuf};

use cpu_time::ProcessTime;
use glam::Vec3;
use lole_body::{Bone, Dancer, Measurements, Pose, Tape};
use lole_cloth::mesh::{self, MeshBody, MeshModel, MeshSpec, MeshState};
use lole_cloth::{SolverConfig, StepInput};
use lole_geom::Length;
use lole_hula::{ArmStyle, Dance, DanceStep, MotionSettings};
use lole_motion::{BoneMap, Clip, ClipSettings, bvh};

use cotton::FABRIC;
use seen::Seen;

const FRAME_DT: f32 = 1.0 / 60.0;

/// Time in which she goes from the bind pose into the dance, and in which the dress comes to rest [s].
const EASING: f32 = 1.0;
const RESTING: f32 = 0.5;

/// Time in which seams draw their panels together [s].
const CLOSING: f32 = 5.0;

/// How far apart the points are in which the body is met [m].
const POINT_SPACING: f32 = 0.012;

struct Asked {
    obj: Option<PathBuf>,
    unit: f32,
    uv: Option<f32>,
    pattern: Option<PathBuf>,
    lift: f32,
    tape: Tape,
    bvh: Option<PathBuf>,
    seconds: f32,
    edge: f32,
    substeps: Option<NonZeroU32>,
    meets_forearms: bool,
    write: Option<PathBuf>,
    traces: bool,
}

fn asked() -> Result<Asked, Box<dyn Error>> {
    let mut asked = Asked {
        obj: None,
        unit: 1.0,
        uv: None,
        pattern: None,
        lift: 0.0,
        tape: Tape::default(),
        bvh: None,
        seconds: 5.0,
        edge: 0.0125,
        substeps: None,
        meets_forearms: false,
        write: None,
        traces: false,
    };
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        let mut value = || arguments.next().ok_or(format!("{argument}: what?"));
        match argument.as_str() {
            "--obj" => asked.obj = Some(value()?.into()),
            "--unit" => asked.unit = value()?.parse()?,
            "--uv" => asked.uv = Some(value()?.parse()?),
            "--pattern" => asked.pattern = Some(value()?.into()),
            "--lift" => asked.lift = value()?.parse()?,
            "--tape" => asked.tape = tape(&value()?)?,
            "--bvh" => asked.bvh = Some(value()?.into()),
            "--seconds" => asked.seconds = value()?.parse()?,
            "--edge" => asked.edge = value()?.parse()?,
            "--substeps" => asked.substeps = Some(value()?.parse()?),
            "--write" => asked.write = Some(value()?.into()),
            "--forearms" => asked.meets_forearms = true,
            "--trace" => asked.traces = true,
            _ => return Err(format!("what is {argument}?").into()),
        }
    }
    Ok(asked)
}

/// Stature, bust, waist and hip [cm].
fn tape(text: &str) -> Result<Tape, Box<dyn Error>> {
    let lengths = text.split(',').map(|it| it.parse().map(Length::from_cm));
    let lengths = lengths.collect::<Result<Vec<_>, _>>()?;
    let [stature, bust_girth, waist_girth, hip_girth] = lengths[..] else {
        return Err("a tape is STATURE,BUST,WAIST,HIP".into());
    };
    Ok(Tape {
        stature: Some(stature),
        bust_girth: Some(bust_girth),
        waist_girth: Some(waist_girth),
        hip_girth: Some(hip_girth),
        ..Tape::default()
    })
}

/// What she dances.
enum Moves {
    Kaholo(Box<Dance>),
    Recorded(Clip),
}

impl Moves {
    fn new(asked: &Asked, dancer: &Dancer) -> Result<Self, Box<dyn Error>> {
        let Some(path) = &asked.bvh else {
            let settings = MotionSettings {
                dance_step: DanceStep::Kaholo,
                arms: ArmStyle::OpenUp,
                ..MotionSettings::default()
            };
            return Ok(Self::Kaholo(Box::new(Dance::new(
                &dancer.skeleton,
                &settings,
            )?)));
        };
        let recording = bvh::parse(&std::fs::read(path)?)?;
        let map = BoneMap::recognize(&recording)?;
        let clip = Clip::retarget(&recording, &map, &dancer.skeleton, ClipSettings::default())?;
        // Recorded hands hang where a skirt is.
        Ok(Self::Recorded(clip.clear_of_skirt(dancer)))
    }

    fn pose_at(&self, time: f32) -> Pose {
        match self {
            Self::Kaholo(dance) => dance.pose_at(time),
            Self::Recorded(clip) => clip.pose_at(time),
        }
    }
}

/// The body as it moves: the dancer's skin, and what cloth meets of it.
struct Body {
    dancer: Dancer,
    moves: Moves,
    positions: Vec<Vec3>,
    normals: Vec<Vec3>,
    mesh: MeshBody,
}

impl Body {
    fn new(asked: &Asked) -> Result<Self, Box<dyn Error>> {
        let dancer = Dancer::new(&Measurements::from_tape(&asked.tape)?)?;
        let triangles = dancer.skin.body_triangles();
        let is_forearm = |bone: Bone| {
            (bone.lineage()).any(|it| matches!(it, Bone::LeftLowerArm | Bone::RightLowerArm))
        };
        let vertices = 0..dancer.skin.positions.len();
        let met =
            vertices.map(|it| asked.meets_forearms || !is_forearm(dancer.skin.strongest_bone(it)));
        let mesh = MeshBody::new(&dancer.skin.positions, &triangles, POINT_SPACING)?;
        let body = Self {
            moves: Moves::new(asked, &dancer)?,
            mesh: mesh.with_met(met.collect()),
            dancer,
            positions: Vec::new(),
            normals: Vec::new(),
        };
        Ok(body)
    }

    fn pose(&mut self, pose: &Pose) -> Result<(), Box<dyn Error>> {
        let world_from_bind = self.dancer.skeleton.world_from_bind(pose);
        let skin = &self.dancer.skin;
        skin.pose(&world_from_bind, &mut self.positions, &mut self.normals);
        Ok(self.mesh.pose(&self.positions)?)
    }

    /// Where she is at a time [s]: the bind pose, then into the dance, then the dance.
    fn pose_at(&self, time: f32) -> Pose {
        let into = ((time - RESTING) / EASING).clamp(0.0, 1.0);
        let first = self.moves.pose_at((time - RESTING - EASING).max(0.0));
        let eased = into * into * (3.0 - 2.0 * into);
        let rotations = first.rotations.iter();
        Pose {
            hips_translation: first.hips_translation * eased,
            rotations: rotations
                .map(|&it| glam::Quat::IDENTITY.slerp(it, eased))
                .collect(),
        }
    }
}

/// The dress as it is given, and where it stands [m].
fn cloth(asked: &Asked, body: &Body) -> Result<(MeshSpec, Vec<Vec3>), Box<dyn Error>> {
    if let Some(path) = &asked.pattern {
        let text = std::fs::read_to_string(path)?;
        let sewn = panels::sew(&text, f64::from(asked.edge), asked.lift)?;
        let count = sewn.positions.len();
        let spec = MeshSpec::welded(count, sewn.triangles, sewn.flat, FABRIC);
        return Ok((spec, sewn.positions));
    }
    let Some(path) = &asked.obj else {
        let (positions, triangles) = dress::spread(&body.dancer, asked.edge);
        let spec = MeshSpec::of_surface(&positions, triangles, |_| Vec3::Y, FABRIC);
        return Ok((spec, positions));
    };
    let read = obj::Obj::parse(&std::fs::read_to_string(path)?, asked.unit)?;
    let welded = lole_geom::weld::weld((&read.positions, &read.triangles), 1.0e-4, &[]);
    println!(
        "{} vertices and {} triangles read, {} and {} welded",
        read.positions.len(),
        read.triangles.len(),
        welded.positions.len(),
        welded.triangles.len()
    );
    let spec = match asked.uv {
        Some(scale) => {
            let corners = welded
                .sources
                .iter()
                .map(|&it| read.flat_corners(it, scale));
            let corners = corners
                .collect::<Option<_>>()
                .ok_or("not every corner has a vt")?;
            MeshSpec::welded(welded.positions.len(), welded.triangles, corners, FABRIC)
        }
        None => MeshSpec::of_surface(&welded.positions, welded.triangles, |_| Vec3::Y, FABRIC),
    };
    Ok((spec, welded.positions))
}

/// Lets seams draw panels together around her in the bind pose. Seams that are open yet go through each other
/// on their way, so cloth meets only her until they are closed.
fn draw_together(
    body: &mut Body,
    (model, config): (&MeshModel, &SolverConfig),
    state: &mut MeshState,
    asked: &Asked,
) -> Result<(), Box<dyn Error>> {
    let (still, mut now) = (vec![Vec3::ZERO; model.particle_count()], Vec::new());
    let mut seen = Seen::default();
    body.pose(&Pose::default())?;
    let open = SolverConfig {
        self_collision: None,
        gravity: Vec3::ZERO,
        substep_count: NonZeroU32::MIN,
        ..config.clone()
    };
    let mut frame = 0_u16;
    while f32::from(frame) * FRAME_DT < CLOSING {
        frame += 1;
        seen.depths = body.mesh.look(model, state);
        let input = StepInput {
            surfels: body.mesh.surfels(),
            ..StepInput::default()
        };
        if let Err(cause) = mesh::step(model, &open, &input, state, FRAME_DT) {
            return Err(cause.into());
        }
        state.set_velocities(model, &still);
        body.pose(&Pose::default())?;
        if asked.traces && frame.is_multiple_of(10) {
            state.copy_positions(model, &mut now);
            seen.look(f32::from(frame) * FRAME_DT - CLOSING, (model, &now), body);
        }
    }
    state.copy_positions(model, &mut now);
    print!("drawn together: ");
    seen.look(0.0, (model, &now), body);
    Ok(())
}

/// Writes cloth with its flat pieces as texture coordinates, which `--uv 1` reads again.
fn write_cloth(path: &Path, model: &MeshModel, now: &[Vec3]) -> Result<(), Box<dyn Error>> {
    let flat = |triangle: usize| model.flat_corners(triangle);
    obj::write(path, (now, model.triangles()), Some(&flat))
}

fn main() -> Result<(), Box<dyn Error>> {
    let asked = asked()?;
    let mut body = Body::new(&asked)?;
    let (spec, positions) = cloth(&asked, &body)?;
    let began = ProcessTime::now();
    let model = MeshModel::new(&spec)?;
    let mut config = model.settings();
    config.substep_count = asked.substeps.unwrap_or(config.substep_count);
    println!(
        "{} particles, {} triangles, built in {:.2} s; a body of {} triangles in {} points; {} substeps",
        model.particle_count(),
        model.triangles().len(),
        began.elapsed().as_secs_f64(),
        body.mesh.triangles().len(),
        body.mesh.surfels().len(),
        config.substep_count
    );
    let mut state = MeshState::new(&model, &positions);
    let mut now = positions;
    if asked.pattern.is_some() {
        draw_together(&mut body, (&model, &config), &mut state, &asked)?;
        state.copy_positions(&model, &mut now);
    }
    if let Some(folder) = &asked.write {
        write_cloth(&folder.join("dress.obj"), &model, &now)?;
    }
    let mut seen = Seen::default();
    let frame_count = ((asked.seconds + RESTING + EASING) / FRAME_DT).round();
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a few hundred"
    )]
    let frame_count = frame_count as u16;
    for frame in 1..=frame_count {
        let time = f32::from(frame) * FRAME_DT;
        body.pose(&body.pose_at(time))?;
        let began = ProcessTime::now();
        seen.depths = body.mesh.look(&model, &mut state);
        seen.looking.push(1e3 * began.elapsed().as_secs_f64());
        let input = StepInput {
            surfels: body.mesh.surfels(),
            ..StepInput::default()
        };
        if let Err(cause) = mesh::step(&model, &config, &input, &mut state, FRAME_DT) {
            return Err(cause.into());
        }
        seen.times.push(1e3 * began.elapsed().as_secs_f64());
        state.copy_positions(&model, &mut now);
        if asked.traces || frame % 60 == 30 || frame == frame_count {
            seen.look(time - RESTING - EASING, (&model, &now), &body);
            if let Some(folder) = &asked.write {
                write_cloth(&folder.join(format!("dress_{frame:04}.obj")), &model, &now)?;
                let skin = (&body.positions[..], body.mesh.triangles());
                obj::write(&folder.join(format!("body_{frame:04}.obj")), skin, None)?;
            }
        }
    }
    seen.say();
    Ok(())
}
