//! Private.
#![allow(
    clippy::all,
    clippy::pedantic,
    missing_docs,
    clippy::print_stdout,
    clippy::unwrap_used,
    clippy::disallowed_methods
)]
use glam::Vec3;
use lole_cloth::mesh::{self, MeshModel, MeshSpec, MeshState, Outcome, diagnose};
use lole_cloth::*;
use lole_geom::*;
use std::num::NonZeroU32;
fn read(p: &str) -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let (mut v, mut f) = (vec![], vec![]);
    for l in std::fs::read_to_string(p).unwrap().lines() {
        let w: Vec<&str> = l.split(' ').collect();
        if w[0] == "v" {
            v.push(Vec3::new(
                w[1].parse().unwrap(),
                w[2].parse().unwrap(),
                w[3].parse().unwrap(),
            ));
        } else {
            f.push([1, 2, 3].map(|k| w[k].parse::<u32>().unwrap() - 1));
        }
    }
    (v, f)
}
fn env(n: &str, d: f32) -> f32 {
    std::env::var(n).ok().map_or(d, |v| v.parse().unwrap())
}
fn list(n: &str) -> Vec<u32> {
    std::env::var(n).ok().map_or(vec![], |v| {
        v.split(',').map(|x| x.parse().unwrap()).collect()
    })
}
fn main() {
    let dir = std::env::args().nth(1).unwrap();
    let (rest, tri) = read("/tmp/mesh_out/rest.obj");
    let fabric = Fabric {
        areal_density: 0.12,
        thickness: 0.3e-3,
        stretch: [env("STRETCH", 4500.0), env("STRETCH", 4500.0) * 0.62],
        shear: env("SHEAR", 90.0),
        bend: [6.0e-6, 4.0e-6],
        twist: 3.0e-6,
        hysteresis: Hysteresis::NONE,
        friction: env("FRIC", 0.3),
        cloth_friction: 0.3,
        drag_rate: 1.0,
    };
    let spec = MeshSpec::of_surface(&rest, tri.clone(), |_| Vec3::Y, fabric);
    let model = MeshModel::new(&spec).unwrap();
    let mut state = MeshState::new(&model, &rest);
    let (b0, bt) = read(&format!("{dir}/body_0001.obj"));
    let points = MeshSurfels::new(&b0, &bt, 0.012);
    let config = SolverConfig {
        substep_count: NonZeroU32::new(env("SUB", 24.0) as u32).unwrap(),
        structural_sweep_count: NonZeroU32::new(env("SWEEP", 1.0) as u32).unwrap(),
        contact_offset: 0.004,
        depenetration_speed: 1.0,
        row_strides: list("ROWS"),
        column_strides: list("COLS"),
        tether_scale: None,
        self_collision: (env("SELF", 1.0) > 0.0).then_some(SelfCollision {
            radius: env("RAD", 0.002),
            substep_interval: NonZeroU32::new(env("INT", 3.0) as u32).unwrap(),
            crossings: if env("REP", 1.0) > 0.0 {
                Crossings::Repair
            } else {
                Crossings::Leave
            },
        }),
        ..SolverConfig::default()
    };
    let mut now = vec![];
    let mut surfels = vec![];
    let last = env("LAST", 240.0) as u32;
    let quality: Vec<f32> = (0..tri.len())
        .map(|t| {
            let [a, b, c] = model.flat_corners(t);
            let s = a.distance(b).max(b.distance(c)).max(c.distance(a));
            ((b - a).perp_dot(c - a).abs() / s / s)
        })
        .collect();
    let body = env("BODY", 1.0) > 0.0;
    for frame in 1..=last {
        let f = if body { frame } else { 1 };
        let (b, _) = read(&format!("{dir}/body_{f:04}.obj"));
        let n = lole_geom::mesh::vertex_normals(&b, &bt);
        points.pose(&b, &n, &mut surfels);
        let input = StepInput {
            surfels: &surfels,
            ..StepInput::default()
        };
        let t = std::time::Instant::now();
        assert_eq!(
            mesh::step(&model, &config, &input, &mut state, 1.0 / 60.0),
            Outcome::Advanced
        );
        let ms = t.elapsed().as_secs_f64() * 1e3;
        if frame % 30 == 0 {
            state.copy_positions(&model, &mut now);
            let mut s: Vec<(f32, usize, usize)> = (0..tri.len())
                .flat_map(|t| {
                    let c = diagnose::deformation_of(&model, t, &now);
                    [(c[0].length() - 1.0, t, 0), (c[1].length() - 1.0, t, 1)]
                })
                .collect();
            s.sort_by(|a, b| a.0.total_cmp(&b.0));
            let p = |q: f32| 100.0 * s[((s.len() - 1) as f32 * q) as usize].0;
            let mut good: Vec<f32> = s
                .iter()
                .filter(|x| quality[x.1] > 0.3)
                .map(|x| x.0.abs())
                .collect();
            good.sort_by(f32::total_cmp);
            let mut e: Vec<f32> = vec![];
            for t in &tri {
                for k in 0..3 {
                    let (a, b) = (t[k], t[(k + 1) % 3]);
                    e.push(
                        now[a as usize].distance(now[b as usize]) / model.flat_distance([a, b])
                            - 1.0,
                    );
                }
            }
            e.sort_by(f32::total_cmp);
            let q = |x: f32| 100.0 * e[((e.len() - 1) as f32 * x) as usize];
            println!(
                "{frame}: {ms:.1} ms  strain 0 {:.0} .5 {:.1} 1 {:.1} 50 {:.2} 99 {:.1} 99.5 {:.1} 100 {:.1} | good {} of {} p99 {:.1} max {:.0} | edges 0 {:.0} 1 {:.1} 50 {:.2} 99 {:.1} 100 {:.0}",
                p(0.0),
                p(0.005),
                p(0.01),
                p(0.5),
                p(0.99),
                p(0.995),
                p(1.0),
                good.len(),
                s.len(),
                100.0 * good[good.len() * 99 / 100],
                100.0 * good[good.len() - 1],
                q(0.0),
                q(0.01),
                q(0.5),
                q(0.99),
                q(1.0)
            );
            if frame == last {
                for x in s.iter().rev().take(6).chain(s.iter().take(4)) {
                    let [a, b, c] = tri[x.1];
                    let fl = model.flat_corners(x.1);
                    println!(
                        "   {:.2} col {} q {:.2} sides {:.4} {:.4} {:.4} now {:.4} {:.4} {:.4} at {:.2}",
                        x.0,
                        x.2,
                        quality[x.1],
                        fl[0].distance(fl[1]),
                        fl[1].distance(fl[2]),
                        fl[2].distance(fl[0]),
                        now[a as usize].distance(now[b as usize]),
                        now[b as usize].distance(now[c as usize]),
                        now[c as usize].distance(now[a as usize]),
                        now[a as usize]
                    );
                }
            }
        }
    }
}
