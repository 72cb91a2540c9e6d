//! The built-in typeface: characters to glyphs, and how wide they are.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::sync::{Arc, LazyLock, PoisonError, RwLock};

use harfrust::{
    Direction, FontRef, Script, ShapeOptions, ShapePlan, Shaper, ShaperData, UnicodeBuffer,
};
use lole_language::is_unseen;
use skrifa::MetadataProvider as _;
use skrifa::charmap::Charmap;

/// Millimeters of a typographic point.
pub(super) const MM_PER_PT: f64 = 25.4 / 72.0;

/// Stands for a character that the typeface lacks, as Japanese printers have always done.
const GETA: char = '〓';

/// Thickness of the strokes of letters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Weight {
    /// For reading.
    Regular,
    /// For heads and what must not be overlooked.
    Bold,
}

/// Font files, see `data/fonts/README.md`; of each weight one.
#[cfg(not(target_arch = "wasm32"))]
mod files {
    /// They are built in.
    pub(super) fn all() -> Option<[&'static [u8]; 2]> {
        Some([
            include_bytes!("../../data/fonts/NotoSansJP-Regular.otf"),
            include_bytes!("../../data/fonts/NotoSansJP-Bold.otf"),
        ])
    }
}

/// A page does not carry seven megabytes that only paper needs: whoever makes paper there gives them first.
#[cfg(target_arch = "wasm32")]
mod files {
    use std::sync::OnceLock;

    static GIVEN: OnceLock<[Vec<u8>; 2]> = OnceLock::new();

    /// Gives the font files of both weights, the regular one first; those that were given first stay.
    pub fn give_fonts(files: [Vec<u8>; 2]) {
        // The second time they are the same.
        drop(GIVEN.set(files));
    }

    /// Those that were given.
    pub(super) fn all() -> Option<[&'static [u8]; 2]> {
        let [regular, bold] = GIVEN.get()?;
        Some([regular, bold])
    }
}

#[cfg(target_arch = "wasm32")]
pub use files::give_fonts;

/// The font file of ordinary text, which has the letters of Japanese and of Hawaiian.
#[cfg(not(target_arch = "wasm32"))]
#[must_use]
pub fn regular_font() -> &'static [u8] {
    Weight::Regular.bytes()
}

// The tables of a font are found once: pages measure thousands of words.
static FACES: LazyLock<Option<[Face; 2]>> = LazyLock::new(|| {
    let [regular, bold] = files::all()?;
    Some([Face::read(regular)?, Face::read(bold)?])
});

/// A font, with what is found in it once.
struct Face {
    font: FontRef<'static>,
    shaping: ShaperData,
    charmap: Charmap<'static>,
    /// How each script that was met is shaped: making this takes longer than shaping a word by it.
    plans: RwLock<Vec<(Script, Arc<ShapePlan>)>>,
}

impl Face {
    /// `None` where the bytes are no font.
    fn read(bytes: &'static [u8]) -> Option<Self> {
        let font = FontRef::new(bytes).ok()?;
        Some(Self {
            shaping: ShaperData::new(&font),
            charmap: font.charmap(),
            font,
            plans: RwLock::default(),
        })
    }

    /// How a script is shaped, from left to right.
    fn plan(&self, shaper: &Shaper<'_>, script: Script) -> Arc<ShapePlan> {
        let found = |plans: &[(Script, Arc<ShapePlan>)]| {
            let plan = plans.iter().find(|(of, _)| *of == script);
            plan.map(|(_, plan)| Arc::clone(plan))
        };
        let known = self.plans.read().unwrap_or_else(PoisonError::into_inner);
        if let Some(plan) = found(&known) {
            return plan;
        }
        drop(known);
        let told = (script != harfrust::script::UNKNOWN).then_some(script);
        let plan = ShapePlan::new(shaper, Direction::LeftToRight, told, None, &[]);
        let plan = Arc::new(plan);
        let mut known = self.plans.write().unwrap_or_else(PoisonError::into_inner);
        if found(&known).is_none() {
            known.push((script, Arc::clone(&plan)));
        }
        plan
    }

    /// Number of the glyph of a letter, where it has one.
    fn glyph(&self, letter: char) -> Option<u32> {
        let glyph = self.charmap.map(letter)?.to_u32();
        (glyph != 0).then_some(glyph)
    }
}

impl Weight {
    /// The font file; empty where it was not given.
    pub(super) fn bytes(self) -> &'static [u8] {
        let [regular, bold] = files::all().unwrap_or_default();
        match self {
            Self::Regular => regular,
            Self::Bold => bold,
        }
    }

    fn face(self) -> Option<&'static Face> {
        let faces = FACES.as_ref()?;
        Some(match self {
            Self::Regular => &faces[0],
            Self::Bold => &faces[1],
        })
    }
}

/// One glyph of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Glyph {
    /// Number within the font.
    pub(super) id: u32,
    /// First byte of its cluster in the text.
    pub(super) cluster: usize,
    /// Advance to the right, and offset right and up [em].
    pub(super) advance: f64,
    pub(super) offset: [f64; 2],
}

/// Glyphs of one line of text, from left to right.
pub(super) fn shape(text: &str, weight: Weight) -> Vec<Glyph> {
    let Some(face) = weight.face() else {
        return Vec::new();
    };
    let mut buffer = UnicodeBuffer::new();
    buffer.push_str(text);
    buffer.guess_segment_properties();
    buffer.set_direction(Direction::LeftToRight);
    let shaper = face.shaping.shaper(&face.font).build();
    let plan = face.plan(&shaper, buffer.script());
    let shaped = shaper.shape(buffer, ShapeOptions::new().plan(Some(&plan)));
    let em = f64::from(shaper.units_per_em());
    let positions = shaped.glyph_positions().iter();
    (shaped.glyph_infos().iter().zip(positions))
        .map(|(glyph, position)| Glyph {
            id: glyph.glyph_id,
            cluster: glyph.cluster as usize,
            advance: f64::from(position.x_advance) / em,
            offset: [
                f64::from(position.x_offset) / em,
                f64::from(position.y_offset) / em,
            ],
        })
        .collect()
}

/// Width of one line of text at `size_pt` [mm].
#[must_use]
pub fn text_width(text: &str, weight: Weight, size_pt: f64) -> f64 {
    advance(text, weight) * size_pt * MM_PER_PT
}

/// Texts whose widths a thread remembers, at most.
const REMEMBERED: usize = 1024;

thread_local! {
    /// Widths [em]: whoever looks for a place for words asks for the same ones again and again.
    static ADVANCES: RefCell<[BTreeMap<String, f64>; 2]> = RefCell::default();
}

/// Width of one line of text [em].
fn advance(text: &str, weight: Weight) -> f64 {
    if weight.face().is_none() {
        return 0.0;
    }
    ADVANCES.with_borrow_mut(|known| {
        let known = &mut known[usize::from(weight == Weight::Bold)];
        if let Some(advance) = known.get(text) {
            return *advance;
        }
        let advance = shape(text, weight).iter().map(|glyph| glyph.advance).sum();
        if known.len() == REMEMBERED {
            known.clear();
        }
        known.insert(text.to_owned(), advance);
        advance
    })
}

/// Characters of `text` that cannot be printed, each once, in order of appearance.
#[must_use]
pub fn missing_glyphs(text: &str) -> Vec<char> {
    let mut missing = Vec::new();
    for letter in text.chars().filter(|&letter| !is_drawable(letter)) {
        if !missing.contains(&letter) {
            missing.push(letter);
        }
    }
    missing
}

/// `text` with a geta mark (〓) for each character that cannot be printed: names from a list may hold
/// any character at all. A mark that turns what stands around it is one of these, whatever the fonts hold.
#[must_use]
pub fn printable(text: &str) -> String {
    let letter = |letter: char| match letter {
        '\t' | '\r' | '\n' => ' ',
        _ if is_drawable(letter) && !is_unseen(letter) => letter,
        _ => GETA,
    };
    text.chars().map(letter).collect()
}

fn is_drawable(letter: char) -> bool {
    let face = Weight::Regular.face();
    face.is_some_and(|face| face.glyph(letter).is_some())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_weights_hold_hawaiian_and_japanese() {
        for weight in [Weight::Regular, Weight::Bold] {
            for letter in "āēīōūĀĒĪŌŪʻぁ゛ヴ丶熙髙﨑①㎝℃×÷°→½".chars()
            {
                let face = weight.face().unwrap();
                assert!(face.glyph(letter).is_some(), "{letter} {weight:?}");
            }
        }
    }

    #[test]
    fn full_width_letters_are_one_em() {
        for size in [6.0, 12.0, 30.0] {
            let width = text_width("腰回り", Weight::Regular, size);
            assert!((width - 3.0 * size * MM_PER_PT).abs() < 1e-9, "{width}");
        }
    }

    #[test]
    fn width_of_a_line_is_the_sum_of_its_words() {
        let whole = text_width("elastic rows", Weight::Bold, 10.0);
        let parts = ["elastic", " ", "rows"].map(|part| text_width(part, Weight::Bold, 10.0));
        assert!((whole - parts.iter().sum::<f64>()).abs() < 0.05);
    }

    #[test]
    fn strangers_become_geta() {
        assert_eq!(missing_glyphs("김수 김"), ['김', '수']);
        assert_eq!(printable("김 Aloha\n"), "〓 Aloha ");
        assert!(missing_glyphs(&printable("🌺김\u{0}")).is_empty());
    }
}
