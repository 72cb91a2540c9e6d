//! What is said of the dress: strain, crossings, what lies in the body, times.

use glam::Vec3;
use lole_body::Bone;
use lole_cloth::mesh::{Depths, MeshModel, diagnose};
use lole_geom::TriangleGrid;
use lole_geom::triangle_grid::blend;

use crate::Body;

/// Farthest from the body's surface that is looked [m].
const REACH: f32 = 0.12;

/// Deeper than this is more than rounding and flat triangles [m].
const DEEP: f32 = 0.003;

#[derive(Default)]
pub(crate) struct Seen {
    /// [ms] a frame.
    pub(crate) times: Vec<f64>,
    /// Of it, the look into the body.
    pub(crate) looking: Vec<f64>,
    pub(crate) depths: Depths,
    worst: [f32; 3],
    crossings: usize,
}

impl Seen {
    /// Prints what there is at a time [s].
    pub(crate) fn look(&mut self, time: f32, (model, now): (&MeshModel, &[Vec3]), body: &Body) {
        let mut strains: Vec<(f32, usize)> = (0..model.triangles().len())
            .flat_map(|triangle| {
                let columns = diagnose::deformation_of(model, triangle, now);
                columns.map(|column| ((column.length() - 1.0).abs(), triangle))
            })
            .collect();
        strains.sort_by(|a, b| a.0.total_cmp(&b.0));
        let at = |share: usize| strains[strains.len() * share / 100].0;
        let &(max, triangle) = strains.last().expect("a dress has triangles");
        let crossings = diagnose::self_crossings(model, now).unwrap_or(usize::MAX);
        let depths = depths(body, now);
        let (deepest, place) = (0..)
            .zip(&depths)
            .fold((0.0_f32, 0), |most, (index, &depth)| {
                if most.0 < depth { (depth, index) } else { most }
            });
        let deep = depths.iter().filter(|&&depth| DEEP < depth).count();
        let frames = &self.times[self.times.len().saturating_sub(60)..];
        let (median, worst) = median_and_worst(frames);
        let beside = |place: Vec3| beside(body, place);
        let corner = now[model.triangles()[triangle][0] as usize];
        println!(
            "{time:6.2} s  strain p50 {:5.2} p99 {:5.2} max {:6.1} % ({})  {crossings} crossings  {deep} in the body, deepest {:.1} mm ({})  {median:.1} ms, worst {worst:.1}",
            100.0 * at(50),
            100.0 * at(99),
            100.0 * max,
            beside(corner),
            1e3 * deepest,
            beside(now[place]),
        );
        self.worst = [
            self.worst[0].max(at(99)),
            self.worst[1].max(max),
            self.worst[2].max(deepest),
        ];
        self.crossings = self.crossings.max(crossings);
    }

    pub(crate) fn say(&self) {
        let (median, worst) = median_and_worst(&self.times);
        let (looking, _) = median_and_worst(&self.looking);
        let [p99, max, deepest] = self.worst;
        println!(
            "all: p99 {:.2} %, max {:.1} %, {} crossings, {:.1} mm deep; {median:.1} ms, worst {worst:.1} ({:.1} times), {looking:.2} of it to look {:.0} mm deep",
            100.0 * p99,
            100.0 * max,
            self.crossings,
            1e3 * deepest,
            worst / median,
            1e3 * self.depths.reach
        );
    }
}

fn median_and_worst(times: &[f64]) -> (f64, f64) {
    let mut times = times.to_vec();
    times.sort_by(f64::total_cmp);
    let at = |place: usize| times.get(place).copied().unwrap_or_default();
    (at(times.len() / 2), at(times.len().saturating_sub(1)))
}

/// How deep every particle is below the skin [m], 0 outside: by the nearest triangle, on the side of which its
/// normal says.
fn depths(body: &Body, now: &[Vec3]) -> Vec<f32> {
    let grid = TriangleGrid::new(&body.positions, body.mesh.triangles(), 0.03);
    let depth = |&place: &Vec3| {
        let Some(nearest) = grid.nearest(place, REACH) else {
            return 0.0;
        };
        let corners = body.mesh.triangles()[nearest.triangle as usize];
        let normals = corners.map(|corner| body.normals[corner as usize]);
        let out = (place - nearest.point).dot(blend(normals, nearest.barycentric));
        if out < 0.0 { nearest.distance } else { 0.0 }
    };
    now.iter().map(depth).collect()
}

/// The bone whose skin is nearest.
fn beside(body: &Body, place: Vec3) -> &'static str {
    let vertices = body.positions.iter().enumerate();
    let nearest = vertices.min_by(|a, b| a.1.distance(place).total_cmp(&b.1.distance(place)));
    nearest.map_or("nobody", |(vertex, _)| {
        let joints = body.dancer.skin.joints[vertex];
        Bone::ALL[usize::from(joints[0])].name()
    })
}
