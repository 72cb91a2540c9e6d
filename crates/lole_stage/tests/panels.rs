//! Laws of garments that others drafted: flat panels sewn to one surface, drawn together around a dancer and
//! danced in.

#![expect(clippy::print_stderr, reason = "a test says why it is skipped")]

#[path = "../examples/stranger_dress/cotton.rs"]
mod cotton;
#[path = "../examples/stranger_dress/panels.rs"]
mod panels;

use std::num::NonZeroU32;
use std::path::Path;

use glam::{Quat, Vec2, Vec3};
use lole_body::{Dancer, Measurements, Pose, Tape};
use lole_cloth::mesh::{self, MeshBody, MeshModel, MeshSpec, MeshState, diagnose};
use lole_cloth::{SolverConfig, StepInput};
use lole_geom::triangle_grid::blend;
use lole_geom::{Length, TriangleGrid};
use lole_hula::{Dance, DanceStep, MotionSettings};

use cotton::FABRIC;
use panels::{Sewn, sew};

const DT: f32 = 1.0 / 60.0;
/// Edges of the triangles of cloth [m].
const EDGE: f64 = 0.02;

/// A skirt of two panels, one laid over from the front, its hem an arc, its sides of each kind of curve, with
/// its waist at the origin; the back one is `side` up.
fn skirt(back_rotation: &str) -> String {
    let panel = |z: f32, rotation: &str| {
        format!(
            r#"{{"translation": [0, -30, {z}], "rotation": {rotation},
            "vertices": [[-34, -30], [34, -30], [21, 27], [-21, 27]],
            "edges": [
                {{"endpoints": [0, 1], "curvature": {{"type": "circle", "params": [180, 0, 1]}}}},
                {{"endpoints": [1, 2], "curvature": {{"type": "quadratic", "params": [[0.7, -0.02]]}}}},
                {{"endpoints": [2, 3], "curvature": [0.5, 0.04]}},
                {{"endpoints": [3, 0], "curvature": {{"type": "cubic", "params": [[0.2, -0.02], [0.4, -0.02]]}}}}
            ]}}"#
        )
    };
    let (front, back) = (panel(20.0, "[0, 0, 0]"), panel(-20.0, back_rotation));
    let turned = back_rotation != "[0, 0, 0]";
    let [left, right] = if turned { [3, 1] } else { [1, 3] };
    format!(
        r#"{{"pattern": {{"panels": {{"front": {front}, "back": {back}}}, "stitches": [
            [{{"panel": "front", "edge": 1}}, {{"panel": "back", "edge": {left}}}],
            [{{"panel": "front", "edge": 3}}, {{"panel": "back", "edge": {right}}}]
        ]}}, "properties": {{"curvature_coords": "relative", "units_in_meter": 100}}}}"#
    )
}

/// How many triangles every side has.
fn sides(triangles: &[[u32; 3]]) -> Vec<usize> {
    let sides = triangles
        .iter()
        .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let mut sides: Vec<[u32; 2]> = sides.map(|[a, b]| [a.min(b), a.max(b)]).collect();
    sides.sort_unstable();
    sides.chunk_by(|a, b| a == b).map(<[_]>::len).collect()
}

fn area([a, b, c]: [Vec2; 3]) -> f32 {
    0.5 * (b - a).perp_dot(c - a)
}

/// Whichever way the back lies, it is one tube: as many vertices and triangles as sides, and the hem and the
/// waist the only borders.
#[test]
fn panels_become_one_surface_whichever_side_of_them_is_up() {
    for back in ["[0, 0, 0]", "[180, 0, 180]"] {
        let sewn = sew(&skirt(back), EDGE, 1.0).expect("a skirt");
        let sides = sides(&sewn.triangles);
        assert!(sides.iter().all(|&it| it <= 2), "{back}");
        assert_eq!(
            sewn.positions.len() + sewn.triangles.len(),
            sides.len(),
            "{back}"
        );
        let area: f32 = sewn.flat.iter().map(|&it| area(it)).sum();
        // The trapezes, the arc below the hem and what the curves take and give, drawn by hand.
        assert!((0.64..0.68).contains(&area), "{back}: {area} m²");
        assert!(sewn.positions.iter().all(|it| it.is_finite()));
        let model = MeshModel::new(&MeshSpec::welded(
            sewn.positions.len(),
            sewn.triangles,
            sewn.flat,
            FABRIC,
        ));
        assert!(model.is_ok(), "{back}: {:?}", model.err());
    }
}

#[test]
fn what_a_pattern_lacks_is_said() {
    let whole = skirt("[0, 0, 0]");
    for (from, to, said) in [
        ("relative", "absolute", "relative"),
        ("quadratic", "spline", "spline"),
        ("\"edge\": 3", "\"edge\": 9", "stitch"),
        ("[0, 1]", "[0, 2]", "begin"),
    ] {
        let broken = whole.replace(from, to);
        let error = sew(&broken, EDGE, 0.0).expect_err(said).to_string();
        assert!(error.contains(said), "{error}");
    }
}

/// A garment on a dancer who is given as moving triangles.
struct Stage {
    dancer: Dancer,
    body: MeshBody,
    model: MeshModel,
    config: SolverConfig,
    state: MeshState,
    posed: [Vec<Vec3>; 2],
    now: Vec<Vec3>,
}

impl Stage {
    fn new(dancer: Dancer, sewn: Sewn) -> Self {
        let triangles = dancer.skin.body_triangles();
        let body = MeshBody::new(&dancer.skin.positions, &triangles, 0.012).expect("a body");
        let count = sewn.positions.len();
        let spec = MeshSpec::welded(count, sewn.triangles, sewn.flat, FABRIC);
        let model = MeshModel::new(&spec).expect("cloth");
        Self {
            config: model.settings(),
            state: MeshState::new(&model, &sewn.positions),
            now: sewn.positions,
            posed: [Vec::new(), Vec::new()],
            dancer,
            body,
            model,
        }
    }

    fn pose(&mut self, pose: &Pose) {
        let [positions, normals] = &mut self.posed;
        let world_from_bind = self.dancer.skeleton.world_from_bind(pose);
        self.dancer.skin.pose(&world_from_bind, positions, normals);
        self.body.pose(positions).expect("finite");
        self.body.look(&self.model, &mut self.state);
    }

    fn step(&mut self, config: &SolverConfig) {
        let input = StepInput {
            surfels: self.body.surfels(),
            ..StepInput::default()
        };
        let outcome = mesh::step(&self.model, config, &input, &mut self.state, DT);
        assert_eq!(outcome, Ok(()));
        self.state.copy_positions(&self.model, &mut self.now);
    }

    /// Lets seams draw panels together, without weight and speed.
    fn draw_together(&mut self) {
        let open = SolverConfig {
            self_collision: None,
            gravity: Vec3::ZERO,
            substep_count: NonZeroU32::MIN,
            ..self.config.clone()
        };
        let still = vec![Vec3::ZERO; self.model.particle_count()];
        for _ in 0..300 {
            self.pose(&Pose::default());
            self.step(&open);
            self.state.set_velocities(&self.model, &still);
        }
    }

    /// How deep the deepest particle is [m].
    fn deepest(&self) -> f32 {
        let [positions, normals] = &self.posed;
        let triangles = self.body.triangles();
        let grid = TriangleGrid::new(positions, triangles, 0.03);
        let depth = |&place: &Vec3| {
            let Some(nearest) = grid.nearest(place, 0.1) else {
                return 0.0;
            };
            let corners = triangles[nearest.triangle as usize];
            let out = blend(corners.map(|it| normals[it as usize]), nearest.barycentric);
            let is_inside = (place - nearest.point).dot(out) < 0.0;
            if is_inside { nearest.distance } else { 0.0 }
        };
        self.now.iter().map(depth).fold(0.0, f32::max)
    }
}

/// Draws a garment together around her, eases her into a kāholo and looks at the cloth, of which 99 parts of
/// 100 may be strained by `most`.
fn dance(name: &str, most: f32, mut stage: Stage) {
    stage.draw_together();
    let config = stage.config.clone();
    let closed = diagnose::strain(&stage.model, &stage.now);
    let settings = MotionSettings {
        dance_step: DanceStep::Kaholo,
        ..MotionSettings::default()
    };
    let dance = Dance::new(&stage.dancer.skeleton, &settings).expect("a dance");
    for frame in 0..150_u16 {
        let time = f32::from(frame) * DT;
        let into = time.min(1.0);
        let first = dance.pose_at((time - 1.0).max(0.0));
        let pose = Pose {
            hips_translation: first.hips_translation * into,
            rotations: (first.rotations.iter())
                .map(|&it| Quat::IDENTITY.slerp(it, into))
                .collect(),
        };
        stage.pose(&pose);
        stage.step(&config);
        if frame % 30 == 29 {
            let strain = diagnose::strain(&stage.model, &stage.now);
            let crossings = diagnose::self_crossings(&stage.model, &stage.now);
            let deepest = stage.deepest();
            let said =
                format!("{name}, {time:.2} s: {strain:?} after {closed:?}, {deepest} m deep");
            assert_eq!(crossings, Some(0), "{said}");
            assert!(strain.p99 < most, "{said}");
            assert!(deepest < 0.005, "{said}");
        }
    }
}

#[test]
fn a_skirt_that_was_drawn_by_numbers_is_danced_in() {
    let dancer = Dancer::new(&Measurements::woman()).expect("a woman");
    let waist = dancer.landmarks.waist_height;
    let sewn = sew(&skirt("[180, 0, 180]"), EDGE, waist).expect("a skirt");
    dance("skirt", 0.10, Stage::new(dancer, sewn));
}

/// The tape of the woman of `GarmentCode`. The sleeves are drafted for arms that hang, and hers open. Runs
/// where the folder that `LOLE_ASSETS` names holds the shirt.
#[test]
fn a_shirt_that_others_drafted_is_danced_in() {
    let name = "patterns/garmentcode_shirt.json";
    let folder = std::env::var("LOLE_ASSETS").unwrap_or_default();
    let text = match std::fs::read_to_string(Path::new(&folder).join(name)) {
        Ok(text) => text,
        Err(error) => {
            eprintln!("skipped: LOLE_ASSETS names no folder with {name} ({error})");
            return;
        }
    };
    let cm = |length: f64| Some(Length::from_cm(length));
    let tape = Tape {
        stature: cm(166.2),
        bust_girth: cm(97.4),
        waist_girth: cm(80.3),
        hip_girth: cm(104.1),
        ..Tape::default()
    };
    let measurements = Measurements::from_tape(&tape).expect("a woman");
    let dancer = Dancer::new(&measurements).expect("a woman");
    dance(
        "shirt",
        0.20,
        Stage::new(dancer, sew(&text, EDGE, 0.0).expect("a shirt")),
    );
}
