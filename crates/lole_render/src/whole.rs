//! Whole numbers from floats, without a call into the mathematics library for each.

/// The greatest whole number that is not above `x`; the nearest that fits where none does.
#[expect(
    clippy::cast_possible_truncation,
    reason = "`as` saturates, which is what is documented"
)]
#[inline]
pub(crate) fn floor(x: f32) -> i32 {
    let cut = x as i32;
    cut - i32::from(x < cut as f32)
}

/// The least whole number that is not below `x`.
#[inline]
pub(crate) fn ceil(x: f32) -> i32 {
    -floor(-x)
}

/// `x` without its fraction as an index; 0 for what is negative.
#[expect(
    clippy::cast_possible_truncation,
    reason = "`as` saturates, which is what is documented"
)]
#[inline]
pub(crate) fn index(x: f32) -> usize {
    x.max(0.0) as usize
}

/// The nearest byte; 0 or 255 for what is outside.
#[expect(
    clippy::cast_possible_truncation,
    reason = "`as` saturates, which is what is documented"
)]
#[inline]
pub(crate) fn byte(x: f32) -> u8 {
    (x + 0.5).max(0.0) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn floor_and_ceil_agree_with_the_standard_library() {
        for step in -400_i16..400 {
            let x = f32::from(step) * 0.125;
            assert!((floor(x) as f32 - x.floor()).abs() < f32::EPSILON, "{x}");
            assert!((ceil(x) as f32 - x.ceil()).abs() < f32::EPSILON, "{x}");
        }
    }
}
