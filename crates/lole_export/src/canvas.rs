//! A place on a page that a drawing fills.

use lole_language::Language;

use crate::pdf::{Flow, Rect, Sheet};

/// Where a drawing is made, and in which language its words are.
pub(crate) struct Canvas<'a> {
    /// The page.
    pub(crate) sheet: &'a mut Sheet,
    /// What of it the drawing may fill.
    pub(crate) rect: Rect,
    /// Language of the words.
    pub(crate) language: Language,
}

impl Flow {
    /// Reserves a place over the whole width, on one page, for a drawing of this height [mm].
    pub(crate) fn drawing(
        &mut self,
        height: f64,
        language: Language,
        draw: impl FnOnce(&mut Canvas<'_>),
    ) {
        self.block(height, |sheet, rect| {
            draw(&mut Canvas {
                sheet,
                rect,
                language,
            });
        });
    }
}

impl Canvas<'_> {
    /// Another place on this page.
    pub(crate) fn at(&mut self, rect: Rect) -> Canvas<'_> {
        Canvas {
            sheet: self.sheet,
            rect,
            language: self.language,
        }
    }
}
