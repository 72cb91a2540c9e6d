//! dbg2 DESIGN SECONDS
use lole_costume::document::parse;
use lole_stage::{Performance, Production};
use glam::Vec3;
fn main() {
    let file = std::env::args().nth(1).unwrap();
    let seconds: f32 = std::env::args().nth(2).unwrap().parse().unwrap();
    let design = parse(&std::fs::read_to_string(&file).unwrap(), &file).unwrap();
    let production = Production::new(&design).unwrap();
    let mut p = Performance::new(production).unwrap();
    let mut hem: Vec<usize> = Vec::new();
    let mut f = 0;
    let mut still: Vec<f32> = Vec::new();
    loop {
        let pos = p.dressed_positions(0).to_vec();
        let g = &p.production().dressed[0].dressed;
        let joint = p.production().dancer.skeleton.joint(lole_body::Bone::Hips); let hips = p.world_from_bind()[lole_body::Bone::Hips.index()].transform_point3(joint);
        if p.time() >= 0.0 && hem.is_empty() {
            let mut lines: std::collections::BTreeMap<u32, Vec<usize>> = Default::default();
            let _ = &mut lines;
            let mut on: Vec<usize> = g.trunk_triangles.iter().flatten().map(|&c| c as usize).collect();
            on.sort(); on.dedup();
            on.sort_by(|&a, &b| pos[a].y.total_cmp(&pos[b].y));
            hem = on[..on.len() / 14].to_vec();
            still = hem.iter().map(|&i| pos[i].y - hips.y).collect();
        }
        if !hem.is_empty() && f % 30 == 0 {
            let mut ups: Vec<f32> = hem.iter().zip(&still).map(|(&i, s)| pos[i].y - hips.y - s).collect();
            ups.sort_by(f32::total_cmp);
            let r: f32 = hem.iter().map(|&i| (pos[i] - hips).with_y(0.0).length()).sum::<f32>() / hem.len() as f32;
            let (strain, skin) = p.measure_dressed(0);
            let low = pos.iter().fold(Vec3::splat(9.0), |a, b| a.min(*b)).y - hips.y;
            println!("t {:5.2} hem up mean {:4.0} mm, p10 {:4.0} p50 {:4.0} p90 {:4.0}, lowest {:.3}, radius {:.3}, p99 {:.1} %, showing {} crossings {:?}", p.time(), 1000.0 * ups.iter().sum::<f32>() / ups.len() as f32, 1000.0 * ups[ups.len() / 10], 1000.0 * ups[ups.len() / 2], 1000.0 * ups[ups.len() * 9 / 10], low, r, 100.0 * strain.p99, skin.showing_body_vertices, g.crossings(&pos));
        }
        if p.time() >= seconds { break; }
        p.advance().ok().unwrap();
        p.pose_body();
        f += 1;
    }
}
