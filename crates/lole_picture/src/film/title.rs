//! The title over the beginning of a film.

use lole_export::pdf::printable;
use lole_render::label::Label;
use lole_render::{Image, RenderError};

/// When a title is there [s]: it begins to show, is there whole, begins to go, is gone.
const TIMES: [f32; 4] = [0.3, 1.1, 3.8, 4.8];
/// Height of its letters over the picture's shorter side.
const HEIGHT: f32 = 0.085;
/// Widest line over the picture's width, and the free rim at its left.
const WIDTH: f32 = 0.86;
const RIM: f32 = 0.07;
/// How far from the upper edge it stands, over the picture's height.
const FALL: f32 = 0.80;
/// Longer titles end in an ellipsis.
pub const MOST_LETTERS: usize = 60;
const INK: [u8; 3] = [255, 252, 244];
/// What it stands out by where the picture is light.
const SHADE: [u8; 3] = [18, 12, 14];

/// Writes a title over the picture of a moment of the film [s], if it is seen then.
///
/// # Errors
/// A font that cannot be read.
pub fn write(image: &mut Image, title: &str, time: f32) -> Result<(), RenderError> {
    let opacity = opacity(time);
    let (Some(font), false) = (font(), title.trim().is_empty() || opacity <= 0.0) else {
        return Ok(());
    };
    let text = shortened(title);
    let (width, height) = (image.width as f32, image.height as f32);
    let mut label = Label {
        text: &text,
        font,
        size: HEIGHT * width.min(height),
        color: INK,
        opacity,
        width: f32::INFINITY,
    };
    // A long title is written smaller, on one line.
    label.size *= (WIDTH * width / label.advance()?.max(1.0)).min(1.0);
    let place = [RIM * width, FALL * height];
    let step = label.size * 0.022;
    for (across, down) in [(-1.0, 0.0), (1.0, 0.0), (0.0, -1.0), (0.0, 1.0), (1.0, 1.6)] {
        let shade = Label {
            color: SHADE,
            opacity: 0.30 * opacity,
            ..label
        };
        shade.write(image, [place[0] + across * step, place[1] + down * step])?;
    }
    label.write(image, place)?;
    Ok(())
}

/// How much of a title is seen, 0 to 1.
fn opacity(time: f32) -> f32 {
    let [from, whole, until, gone] = TIMES;
    let comes = ((time - from) / (whole - from)).clamp(0.0, 1.0);
    let goes = ((gone - time) / (gone - until)).clamp(0.0, 1.0);
    let share = comes.min(goes);
    share * share * (3.0 - 2.0 * share)
}

/// On one line, not too long, and with a mark for what the font lacks.
fn shortened(title: &str) -> String {
    let words: Vec<&str> = title.split_whitespace().collect();
    let line = printable(&words.join(" "));
    let mut letters = line.chars();
    let mut kept: String = letters.by_ref().take(MOST_LETTERS).collect();
    if letters.next().is_some() {
        kept.push('…');
    }
    kept
}

/// The font of printed pages, which has Japanese and Hawaiian.
#[cfg(not(target_arch = "wasm32"))]
#[expect(clippy::unnecessary_wraps, reason = "the page has none")]
fn font() -> Option<&'static [u8]> {
    Some(lole_export::pdf::regular_font())
}

/// The page makes no films with titles.
#[cfg(target_arch = "wasm32")]
fn font() -> Option<&'static [u8]> {
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use lole_render::Size;

    fn written(title: &str, time: f32) -> Vec<(u32, u32)> {
        let mut image = Image::filled(Size::new(320, 180), [90, 120, 60]);
        write(&mut image, title, time).unwrap();
        (0..180)
            .flat_map(|y| (0..320).map(move |x| (x, y)))
            .filter(|&(x, y)| image.pixel(x, y).unwrap()[..3] != [90, 120, 60])
            .collect()
    }

    #[test]
    fn a_title_comes_and_goes_at_the_left_below() {
        for title in ["Ka Pua Uʻi", "波の音", "Ē Hoʻi Mai Ē 波"] {
            assert!(written(title, 0.2).is_empty());
            assert!(written(title, 5.0).is_empty());
            let places = written(title, 2.0);
            assert!(places.len() > 200, "{title}");
            assert!(places.iter().all(|&(_, y)| y > 120), "{title}");
            assert!(places.iter().any(|&(x, _)| x < 40), "{title}");
        }
        assert!(written(" \n ", 2.0).is_empty());
    }

    #[test]
    fn a_long_title_stays_within_the_picture() {
        for title in ["a".repeat(1000), "夕".repeat(1000), "W W".repeat(300)] {
            let places = written(&title, 2.0);
            assert!(places.iter().all(|&(x, _)| (10..312).contains(&x)));
            assert!(places.iter().any(|&(x, _)| x > 150));
        }
    }

    #[test]
    fn what_the_font_lacks_is_a_mark_and_what_turns_text_is_too() {
        assert_eq!(shortened("波 \u{1f30a}  Kai\u{202e}"), "波 〓 Kai〓");
    }
}
