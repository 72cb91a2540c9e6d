//! Waves in which cloth is laid that is longer than where it lies.

/// Depth of a wave over a `length` [m], so that the way along it is `fullness` times as long [m]: a wave of
/// depth `a` and length `l` is longer by `(π a / l)²`.
#[must_use]
pub fn depth(length: f32, fullness: f32) -> f32 {
    length / std::f32::consts::PI * (fullness - 1.0).max(0.0).sqrt()
}

#[cfg(test)]
mod tests {
    use lole_geom::trig;

    use super::*;

    #[test]
    fn the_way_along_a_shallow_wave_is_as_long_as_asked() {
        let (length, steps) = (0.1_f32, 400_u16);
        for fullness in [1.0, 1.1, 1.2] {
            let depth = depth(length, fullness);
            let place = |step: u16| {
                let along = f32::from(step) / f32::from(steps);
                let out = depth * trig::sin(std::f32::consts::TAU * along);
                glam::Vec2::new(length * along, out)
            };
            let way: f32 = (0..steps)
                .map(|step| place(step).distance(place(step + 1)))
                .sum();
            let error = way / length / fullness - 1.0;
            assert!(error.abs() < 0.03, "{fullness}: {error}");
        }
    }
}
