//! How a print lies on the cloth, and where a garment lies on it.
//!
//! The cloth lies before its maker with the right side up and the bolt to the side: *along* runs to
//! the right with the warp, *across* runs up from the lower selvage, both from the lower left corner.
//! A panel whose warp runs around the body is cut with its raw hem on the lower selvage, from the
//! corner on; one whose border is to show at the hip is cut the other way up.

use glam::{Affine2, Vec2};
use lole_geom::Length;
use lole_pattern::design::pau_skirt::PauDraft;

use super::PrintImage;

/// Where the top of the picture points, on cloth whose bolt lies to the side.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum PrintDirection {
    /// To the upper selvage: upright on a skirt whose warp runs around the body.
    #[default]
    Up,
    /// Along the cloth, to the right.
    Right,
    /// To the lower selvage.
    Down,
    /// Along the cloth, to the left.
    Left,
}

/// Which mirror image of a picture is printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum PrintFlip {
    /// The picture itself.
    #[default]
    None,
    /// Its left on the right.
    Sideways,
    /// Its top at the bottom.
    UpsideDown,
}

/// How copies of a picture cover the cloth.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum PrintTiling {
    /// Side by side and one above the other.
    #[default]
    Straight,
    /// Every second column half a picture lower, as most dress prints repeat.
    HalfDrop,
    /// Every second row half a picture aside.
    Brick,
    /// Every second copy a mirror image: a photo that does not repeat shows no edge.
    Mirror,
}

/// Whether the picture covers the cloth, or lies along one selvage.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum PrintBorder {
    /// It covers the cloth.
    #[default]
    None,
    /// Along the selvage that becomes the hem.
    Hem,
    /// Along the selvage that becomes the upper edge; motifs then hang head down, because it is the
    /// same cloth, turned.
    Hip,
}

/// How a print lies on the cloth, in the units of the document.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PrintLay {
    /// Where the top of the picture points.
    pub direction: PrintDirection,
    /// Which mirror image it is.
    pub flip: PrintFlip,
    /// How copies cover the cloth.
    pub tiling: PrintTiling,
    /// Whether it lies along a selvage.
    pub border: PrintBorder,
    /// How far to the right one repeat begins [cm].
    pub offset_along_cm: f64,
    /// How far above the lower selvage it begins [cm]: the width of a selvage without print.
    pub offset_across_cm: f64,
    /// Factor on its size: a print that is ordered larger or smaller.
    pub scale_ratio: f64,
}

impl Default for PrintLay {
    fn default() -> Self {
        Self {
            direction: PrintDirection::Up,
            flip: PrintFlip::None,
            tiling: PrintTiling::Straight,
            border: PrintBorder::None,
            offset_along_cm: 0.0,
            offset_across_cm: 0.0,
            scale_ratio: 1.0,
        }
    }
}

impl PrintImage {
    /// From a place on the cloth [m], along and across, to the picture in repeats: to the right, and
    /// down from its top. Whole numbers are corners of repeats.
    #[must_use]
    pub fn uv_from_cloth(&self) -> Affine2 {
        let repeat = Vec2::from(self.repeat.map(Length::to_m_f32));
        let offset = Vec2::from(self.offset.map(Length::to_m_f32));
        Affine2::from_scale(Vec2::new(1.0, -1.0) / repeat) * Affine2::from_translation(-offset)
    }

    /// The color at a place on the cloth, along and across.
    #[must_use]
    pub fn color_at(&self, at: [Length; 2]) -> [u8; 3] {
        let share = |axis: usize| {
            let repeats = (at[axis] - self.offset[axis]).to_m() / self.repeat[axis].to_m();
            repeats - repeats.floor()
        };
        let (column, row) = (
            pixel(share(0), self.width),
            pixel(1.0 - share(1), self.height),
        );
        let start = 4 * (row as usize * self.width as usize + column as usize);
        [0, 1, 2].map(|channel| self.pixels[start + channel])
    }

    /// From the flat cloth of a gathered panel [m] to the picture in repeats. The panel runs `x` to the
    /// left around the body as it is seen from outside, and `y` down from its top fold.
    #[must_use]
    pub fn uv_from_panel(&self, draft: &PauDraft) -> Affine2 {
        self.uv_from_cloth() * cloth_from_panel(draft, self.border)
    }
}

/// From the flat cloth of a gathered panel [m] to the cloth that it is cut from.
fn cloth_from_panel(draft: &PauDraft, border: PrintBorder) -> Affine2 {
    let seam = (draft.cut_length - draft.flat_length) * 0.5;
    let hem_edge = draft.finished_length + draft.hem_depth;
    let place = |along: Length, across: Length| {
        Affine2::from_translation(Vec2::new(along.to_m_f32(), across.to_m_f32()))
    };
    match border {
        PrintBorder::None | PrintBorder::Hem => {
            place(seam + draft.flat_length, hem_edge) * Affine2::from_scale(Vec2::splat(-1.0))
        }
        PrintBorder::Hip => place(seam, draft.cut_height - hem_edge),
    }
}

/// The pixel at a share of a side.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a share of the side"
)]
fn pixel(share: f64, side: u32) -> u32 {
    ((share * f64::from(side)) as u32).min(side - 1)
}

#[cfg(test)]
mod tests {
    use lole_pattern::design::pau_skirt::{PauMeasurements, PauOptions, draft_pau_skirt};

    use super::*;

    fn draft() -> PauDraft {
        let worn = PauMeasurements {
            hip_girth: Length::from_cm(91.4),
            worn_girth: Length::from_cm(83.0),
            worn_height: Length::from_cm(85.0),
        };
        draft_pau_skirt(&worn, &PauOptions::default()).unwrap()
    }

    #[test]
    fn a_panel_is_cut_from_the_corner_with_its_hem_or_its_top_on_the_selvage() {
        let draft = draft();
        let [width, height] = [draft.flat_length, draft.finished_length].map(Length::to_m_f32);
        let raw_hem = Vec2::new(width, height + draft.hem_depth.to_m_f32());
        let hem = cloth_from_panel(&draft, PrintBorder::Hem).transform_point2(raw_hem);
        // One seam allowance from the corner.
        assert!(hem.abs_diff_eq(Vec2::new(0.01, 0.0), 1e-6), "{hem}");
        let fold = draft.cut_height.to_m_f32() - raw_hem.y;
        let raw_top = Vec2::new(0.0, -fold);
        let top = cloth_from_panel(&draft, PrintBorder::Hip).transform_point2(raw_top);
        assert!(top.abs_diff_eq(Vec2::new(0.01, 0.0), 1e-6), "{top}");
    }

    #[test]
    fn the_picture_is_the_same_by_color_and_by_coordinates() {
        let image = PrintImage {
            width: 3,
            height: 2,
            pixels: (0..24).collect(),
            repeat: [0.3, 0.2].map(Length::from_m),
            offset: [0.05, -0.02].map(Length::from_m),
            border: PrintBorder::None,
        };
        for (along, across) in [(0.11, 0.03), (0.77, -0.41), (-0.2, 0.6)] {
            #[expect(clippy::cast_possible_truncation, reason = "a test's numbers")]
            let place = Vec2::new(along as f32, across as f32);
            let uv = image.uv_from_cloth().transform_point2(place);
            let uv = uv - uv.floor();
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "within the picture"
            )]
            let (column, row) = ((uv.x * 3.0) as usize, (uv.y * 2.0) as usize);
            let start = 4 * (3 * row + column);
            assert_eq!(
                image.color_at([along, across].map(Length::from_m)),
                [0, 1, 2].map(|channel| image.pixels[start + channel])
            );
        }
    }
}
