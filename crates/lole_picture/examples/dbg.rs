//! dbg
use lole_costume::document::{Design, parse};
use lole_stage::{Performance, Production, six_dancers};
fn main() {
    let id = std::env::args().nth(1).unwrap();
    let only = std::env::args().nth(2).unwrap();
    let frames: usize = std::env::args().nth(3).unwrap().parse().unwrap();
    for (name, dancer) in six_dancers() {
        if name != only && only != "all" { continue; }
        let text = format!("lole = 1\n[[garment]]\nkind = \"{id}\"\n");
        let mut design = Design { dancer, garments: parse(&text, "g").unwrap().garments, ..Design::default() };
        design.skirt.is_worn = false;
        let production = Production::new(&design).unwrap();
        let mut p = Performance::new(production).unwrap();
        let mut f = 0;
        p.pose_body();
        let layers = p.dressed_layers(0);
        println!("{:?} of {}", layers.pieces(&p.production().dressed[0].dressed), layers.places().len());
        loop {
            let g = &p.production().dressed[0].dressed;
            let pos = p.dressed_positions(0);
            if f % 15 == 0 {
                let pairs = g.crossing_pairs(pos).unwrap();
                let mut q = p.clone(); q.pose_body(); let inv = q.dressed_inversions(0, &layers); print!("inv {inv} of {} ", q.dressed_layers(0).places().len()); let (st, sk) = q.measure_dressed(0); print!("p99 {:.1} deep {:.1} showing {} ", 100.0 * st.p99, 1000.0 * sk.worst_depth, sk.showing_body_vertices); println!("{name} t {:.2} crossings {} {:?}", p.time(), pairs.len(), g.crossings_debug(pos));
                if f == 0 || f == frames {
                    for pair in pairs.iter().step_by(pairs.len() / 12 + 1) {
                        println!("   at {:.3} edge {:.2} {:.2} tri {:.2} pinned {:?} {:?}", pair.place, g.on_cloth[pair.ends[0] as usize], g.on_cloth[pair.ends[1] as usize], g.on_cloth[pair.corners[0] as usize], pair.ends.map(|e| g.is_pinned(e)), pair.corners.map(|e| g.is_pinned(e)));
                    }
                }
            }
            if f >= frames { break; }
            p.advance().ok().unwrap();
            f += 1;
        }
    }
}
