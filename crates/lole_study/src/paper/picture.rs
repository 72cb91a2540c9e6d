//! The skirts side by side, as in the paper's figures 13 to 15, with its sentence and ours.

use lole_costume::document::MethodName;
use lole_export::study::RunEntry;
use lole_picture::studio::PhotoStudio;
use lole_render::label::{self, Label};
use lole_render::{Backend, Camera, Image, RenderError, Renderer, Size, View};
use lole_stage::Performance;

use crate::StudyError;

/// One skirt of the picture.
pub struct ComparedPanel {
    pub(super) method: MethodName,
    pub(super) paper: &'static str,
    pub(super) entry: RunEntry,
    pub(super) performance: Performance,
}

/// Size of one skirt in the picture.
const PANEL: Size = Size::new(520, 720);
/// Room for words below it [pixel].
const CAPTION: u32 = 190;
/// Edge around everything [pixel].
const EDGE: u32 = 24;

const PAPER_WHITE: [u8; 3] = [255, 253, 249];
const INK: [u8; 3] = [42, 36, 48];
const SOFT: [u8; 3] = [106, 96, 112];
const GOOD: [u8; 3] = [12, 107, 82];
const BAD: [u8; 3] = [156, 18, 48];

/// Draws all panels but those of readings that the paper has no figure of, the classical method
/// last.
///
/// # Errors
/// A skirt that cannot be painted or drawn.
pub fn draw(panels: &[ComparedPanel]) -> Result<Image, StudyError> {
    let shown: Vec<&ComparedPanel> = panels
        .iter()
        .filter(|panel| panel.method != MethodName::RkDoubleCounted)
        .collect();
    let count = u32::try_from(shown.len()).unwrap_or(1);
    let size = Size::new(
        EDGE + count * (PANEL.width + EDGE),
        PANEL.height + CAPTION + 2 * EDGE,
    );
    let mut picture = Image::filled(size, PAPER_WHITE);
    let mut renderer = Renderer::new(Backend::Auto, PANEL)?;
    let mut left = EDGE;
    for panel in shown {
        let image = shoot(&panel.performance, &mut renderer)?;
        picture.paste(&image, left, EDGE);
        caption(panel, &mut picture, left)?;
        left += PANEL.width + EDGE;
    }
    Ok(picture)
}

/// One skirt on its dancer, from the side that the paper shows.
fn shoot(performance: &Performance, renderer: &mut Renderer) -> Result<Image, StudyError> {
    // The dancer alone sets the frame, so that all skirts are seen at one scale.
    let points = performance.body_positions();
    let camera = Camera::framing_points(points, View::ThreeQuarter, PANEL.aspect());
    Ok(PhotoStudio::new(performance)?.photograph(performance, camera, renderer)?)
}

/// The method's name, the paper's sentence and ours below a skirt.
fn caption(panel: &ComparedPanel, picture: &mut Image, left: u32) -> Result<(), RenderError> {
    let (x, width) = (left as f32, PANEL.width as f32);
    let mut y = (EDGE + PANEL.height + 10) as f32;
    let mut write = |text: &str, size: f32, color: [u8; 3]| -> Result<(), RenderError> {
        let label = Label {
            text,
            font: label::LATIN,
            size,
            color,
            opacity: 1.0,
            width,
        };
        y += label.write(picture, [x, y])? + 6.0;
        Ok(())
    };
    write(title(panel.method), 30.0, INK)?;
    if !panel.paper.is_empty() {
        write(&format!("Paper: “{}”", panel.paper), 19.0, SOFT)?;
    }
    let run = &panel.entry;
    let color = if run.outcome == "stable" { GOOD } else { BAD };
    write(&ours(run), 19.0, color)
}

const fn title(method: MethodName) -> &'static str {
    match method {
        MethodName::Euler => "Euler (8), as in figure 13",
        MethodName::FbEuler => "FB Euler (9), as in figure 14",
        MethodName::RkAsPrinted => "Runge-Kutta (10) as printed, figure 15",
        MethodName::Rk4 => "Runge-Kutta, the classical method",
        MethodName::RkDoubleCounted => "Runge-Kutta (10), gravity twice",
        MethodName::Xpbd => "Lole's own method",
    }
}

fn ours(run: &RunEntry) -> String {
    let step = format!(
        "{} steps a frame, {:.2} ms a step",
        run.steps_per_frame, run.step_ms
    );
    match run.diverged_at_s {
        Some(time) => format!("Measured: flies apart, diverged after {time:.2} s; {step}"),
        None => format!(
            "Measured: {}; strain {:.0} %, {:.1} mm into the body, {} points inside; {step}",
            run.outcome,
            run.strain_pct.p99,
            run.skin_mm.max(run.penetration_mm),
            run.penetrating_particles,
        ),
    }
}
