//! All pieces of a garment on one page at full size: for plotters and copy shops that print from a roll, and for
//! projectors over the cutting table.

use kurbo::{Affine, Point};
use lole_costume::tailoring::GarmentPattern;
use lole_geom::Length;
use lole_language::Language;
use lole_pattern::marker::{Lay, Nap, TableCloth, lay_out};
use lole_pattern::piece::ClothRole;

use super::stamp::CODE;
use super::tiles::{Drawn, draw_pieces, free_pieces, on_paper};
use super::{CutGarment, MM};
use crate::pdf::{Align, LayeredSheet, Rect, Sheet, Stroke, TextStyle};

/// A page that holds everything.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WholeSheet {
    /// As wide as A0, and as long as it takes; A0 where that is enough.
    A0,
    /// From a roll of 36 inches.
    Roll,
    /// For a projector: no margin, thick lines.
    Projector,
    /// The roll once more, for a pen plotter or a cutter.
    Plotter,
}

impl WholeSheet {
    /// Every one with its name in files.
    pub const ALL: [(Self, &'static str); 4] = [
        (Self::A0, "a0"),
        (Self::Roll, "roll"),
        (Self::Projector, "projector"),
        (Self::Plotter, "plotter"),
    ];

    /// Its name in files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::A0 => "a0",
            Self::Roll => "roll",
            Self::Projector => "projector",
            Self::Plotter => "plotter",
        }
    }

    /// Width [mm].
    const fn width(self) -> f64 {
        match self {
            Self::A0 => 841.0,
            Self::Roll | Self::Plotter => 914.4,
            Self::Projector => 1000.0,
        }
    }

    /// Length that it has at least [mm].
    const fn least_length(self) -> f64 {
        match self {
            Self::A0 => 1189.0,
            Self::Roll | Self::Projector | Self::Plotter => 0.0,
        }
    }

    /// What is not printed on at its sides [mm].
    const fn margin(self) -> f64 {
        match self {
            Self::A0 | Self::Roll | Self::Plotter => 12.0,
            Self::Projector => 0.0,
        }
    }

    /// How thick lines are, over those of paper.
    const fn thick(self) -> f64 {
        match self {
            Self::A0 | Self::Roll | Self::Plotter => 1.0,
            // A pixel of a projector over a table is about a millimeter.
            Self::Projector => 3.0,
        }
    }
}

/// Room for name, square and code at the upper end [mm].
const HEAD: f64 = 122.0;

/// The pieces of a garment that no ruler draws, on one page; `None` where there are none, or where one is wider
/// than the page.
#[must_use]
pub fn whole_sheet(cut: &CutGarment, page: WholeSheet, language: Language) -> Option<LayeredSheet> {
    let free = free_pieces(cut);
    if free.is_empty() {
        return None;
    }
    let margin = page.margin();
    let room = page.width() - 2.0 * margin;
    let cloth = TableCloth {
        width: Length::from_m(room / MM),
        nap: Nap::TwoWay,
        border: None,
        matched_repeat: None,
        lay: Lay::Single,
    };
    let marker = lay_out(&on_paper(&free), ClothRole::Main, &cloth);
    if !marker.warnings.is_empty() {
        return None;
    }
    let ends = marker
        .placed
        .iter()
        .map(|placed| placed.outline.bounds().x1);
    let long = ends.fold(0.0, f64::max) * MM;
    let height = (HEAD + long + 2.0 * margin).max(page.least_length());
    let mut sheet = Sheet::new([page.width(), height]);
    draw_head(&mut sheet, (cut, page), language);
    // Cloth runs down the page.
    let turned = Affine::new([0.0, MM, MM, 0.0, margin, HEAD + margin]);
    let drawn = Drawn {
        placed: &marker.placed,
        page_from_cloth: turned,
        rooms: &[],
        is_upright: true,
        thick: page.thick(),
    };
    Some(LayeredSheet {
        base: sheet,
        layers: draw_pieces(cut, &free, &drawn, language),
    })
}

/// Whether a garment has pieces for such pages at all.
#[must_use]
pub fn has_shaped_pieces(garment: &GarmentPattern) -> bool {
    let mut pieces = garment.cutting().pieces.iter();
    pieces.any(|piece| piece.rectangle(super::TOLERANCE).is_none())
}

/// What it is and whose, a square to measure, and its code.
fn draw_head(sheet: &mut Sheet, (cut, page): (&CutGarment, WholeSheet), language: Language) {
    let left = page.margin().max(6.0);
    let square = Rect {
        x: left,
        y: left,
        width: 100.0,
        height: 100.0,
    };
    sheet.rect(square, None, Some(Stroke::solid(0.3 * page.thick())));
    let center = Point::new(square.x + 50.0, square.y + 50.0);
    let said = language.pick("この四角は 10 cm × 10 cm", "this square is 10 cm × 10 cm");
    sheet.text(
        [center.x, center.y],
        said,
        &TextStyle::bold(14.0),
        Align::Center,
    );
    let x = left + 112.0;
    let title = cut.title(language);
    sheet.text(
        [x, left + 14.0],
        &title,
        &TextStyle::bold(30.0),
        Align::Left,
    );
    let how = match page {
        WholeSheet::Projector => language.pick(
            "映した四角が 10 cm になるように大きさを合わせます",
            "set the projector so that the square is 10 cm on the table",
        ),
        WholeSheet::A0 | WholeSheet::Roll | WholeSheet::Plotter => language.pick(
            "実際のサイズ（100 %）で印刷し、四角を測ります",
            "print at actual size (100 %) and measure the square",
        ),
    };
    sheet.text(
        [x, left + 26.0],
        how,
        &TextStyle::regular(16.0),
        Align::Left,
    );
    let words = cut.stamp.words();
    sheet.text(
        [x, left + 37.0],
        &words,
        &TextStyle::regular(16.0),
        Align::Left,
    );
    let at = [x, left + 100.0 - CODE];
    cut.stamp.draw(sheet, at, &cut.owner);
}

#[cfg(test)]
mod tests {
    use super::*;
    use lole_costume::document::{Design, GarmentDesign};
    use lole_costume::order::plan_design;

    /// Every piece lies on the page, and no less of it than on the sheets that are joined.
    #[test]
    fn every_piece_lies_whole_on_the_page() {
        for kind in ["blouse", "muumuu", "holoku"] {
            let design = Design {
                garments: GarmentDesign::of_kind(kind).into_iter().collect(),
                ..Design::default()
            };
            let plan = plan_design("花子", &design).unwrap_or_else(|error| panic!("{error}"));
            let cut = CutGarment::of(&plan.garments[1]);
            for (page, name) in WholeSheet::ALL {
                let sheet = whole_sheet(&cut, page, Language::English);
                let sheet = sheet.unwrap_or_else(|| panic!("{kind} {name}")).flat();
                let [width, height] = sheet.size;
                let paths = sheet.items.iter().filter_map(|item| match item {
                    crate::pdf::Item::Path { path, .. } => Some(kurbo::Shape::bounding_box(path)),
                    _ => None,
                });
                for bounds in paths {
                    let is_inside = -0.01 <= bounds.x0
                        && bounds.x1 <= width + 0.01
                        && -0.01 <= bounds.y0
                        && bounds.y1 <= height + 0.01;
                    assert!(is_inside, "{kind} {name}: {bounds:?} on {:?}", sheet.size);
                }
                let named = sheet
                    .texts()
                    .iter()
                    .filter(|text| **text == "sleeve" || **text == "long sleeve")
                    .count();
                assert_eq!(named, 1, "{kind} {name}: {:?}", sheet.texts());
            }
        }
    }
}
