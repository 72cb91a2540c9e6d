//! Numbers on their way from where they are worked out to where they are used.

/// A number that was worked out in `f64` for what is kept in `f32`: seven digits are more than a tape, a
/// fabric's measurement or a page knows.
#[must_use]
#[expect(clippy::cast_possible_truncation, reason = "that is what it is for")]
pub const fn narrow(value: f64) -> f32 {
    value as f32
}
