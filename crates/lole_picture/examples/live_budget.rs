//! What the window's picture of a design costs: draw calls, triangles, bytes and milliseconds of each pass, on an
//! adapter of its own.
//!
//! `cargo run --release -p lole_picture --example live_budget -- DESIGN.lole [WIDTH HEIGHT]`, for both efforts of
//! the window. `WGPU_ADAPTER_NAME` chooses an adapter: `llvmpipe` is Mesa's, which computes on the processor.

#![expect(
    clippy::print_stdout,
    clippy::disallowed_methods,
    reason = "a tool prints figures, times among them"
)]

use std::collections::BTreeMap;
use std::error::Error;
use std::time::Instant;

use lole_costume::document;
use lole_picture::studio::still_cameras;
use lole_picture::{Lamps, Looks, Moment};
use lole_render::{AmbientLight, Effort, LivePass, LiveView, Overlay, PassCost, Size};
use lole_stage::{Performance, Production};

/// Pictures that are drawn before any is measured, and those that are measured.
const WARM: usize = 8;
const MEASURED: usize = 40;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let design = arguments.next().ok_or("which design?")?;
    let sides: Vec<u32> = arguments.map(|a| a.parse()).collect::<Result<_, _>>()?;
    let size = match sides[..] {
        [] => Size::new(1280, 720),
        [width, height] => Size::new(width, height),
        _ => return Err("a width and a height".into()),
    };
    let design = document::parse(&std::fs::read_to_string(&design)?, &design)?;
    let production = Production::new(&design)?;
    let looks = Looks::new(&design, &production)?;
    let mut performance = Performance::new(production)?;
    performance
        .advance()
        .map_err(|error| format!("{error:?}"))?;
    performance.pose_body();
    let moment = Moment::of(&performance);
    let camera = still_cameras(&performance, size)[0];
    for effort in [Effort::Full, Effort::Light] {
        let dancer = moment.dancer();
        let scene = looks.scene(&dancer, camera, Lamps::WithCamera);
        let mut view = LiveView::alone(size, effort)?;
        println!(
            "{effort:?}, {} × {}, {}",
            size.width,
            size.height,
            view.description()
        );
        let mut taken: BTreeMap<LivePass, (PassCost, Vec<f64>)> = BTreeMap::new();
        for round in 0..WARM + MEASURED {
            let mut since = Instant::now();
            view.draw_by_pass(&scene, Overlay::default(), &mut |pass, cost| {
                let now = Instant::now();
                if WARM <= round {
                    let of_pass = taken.entry(pass).or_insert((cost, Vec::new()));
                    of_pass.1.push((now - since).as_secs_f64() * 1e3);
                }
                since = now;
            })?;
            if round == 0 {
                view.light_up(&AmbientLight::of(&scene)?);
            }
        }
        for (pass, (cost, mut times)) in taken {
            times.sort_by(f64::total_cmp);
            println!(
                "| {} | {} | {} | {:.2} MB | {:.2} ms | {} |",
                pass.name(),
                cost.draw_count,
                cost.triangle_count,
                cost.byte_count as f64 / 1e6,
                times[times.len() / 2],
                times.len(),
            );
        }
    }
    Ok(())
}
