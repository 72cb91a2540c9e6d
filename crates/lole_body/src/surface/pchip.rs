//! Monotone cubic interpolation (Fritsch and Butland 1984): no overshoot between knots.

/// A monotone cubic through knots of increasing abscissa.
#[derive(Debug, Clone)]
pub(crate) struct Pchip {
    knots: Vec<[f32; 2]>,
    slopes: Vec<f32>,
}

impl Pchip {
    /// Through `knots` = `[x, y]`, sorted here; knots closer than a micrometer are merged.
    pub(crate) fn new(knots: &[[f32; 2]]) -> Self {
        let mut knots = knots.to_vec();
        knots.sort_by(|a, b| a[0].total_cmp(&b[0]));
        knots.dedup_by(|a, b| a[0] - b[0] < 1.0e-6);
        let slopes = slopes(&knots);
        Self { knots, slopes }
    }

    /// Value at `x`; constant beyond the ends.
    pub(crate) fn at(&self, x: f32) -> f32 {
        let (Some(first), Some(last)) = (self.knots.first(), self.knots.last()) else {
            return 0.0;
        };
        if x <= first[0] {
            return first[1];
        }
        if x >= last[0] {
            return last[1];
        }
        let upper = self.knots.partition_point(|knot| knot[0] <= x);
        let ([x0, y0], [x1, y1]) = (self.knots[upper - 1], self.knots[upper]);
        let span = x1 - x0;
        let [h00, h10, h01, h11] = hermite((x - x0) / span);
        h00 * y0 + h10 * span * self.slopes[upper - 1] + h01 * y1 + h11 * span * self.slopes[upper]
    }
}

/// Cubic Hermite basis at `t` in `0..=1`.
fn hermite(t: f32) -> [f32; 4] {
    let t2 = t * t;
    let t3 = t2 * t;
    [
        2.0 * t3 - 3.0 * t2 + 1.0,
        t3 - 2.0 * t2 + t,
        3.0 * t2 - 2.0 * t3,
        t3 - t2,
    ]
}

/// Slope at every knot: a weighted harmonic mean inside, a clamped three-point rule at the ends.
fn slopes(knots: &[[f32; 2]]) -> Vec<f32> {
    let count = knots.len();
    if count < 2 {
        return vec![0.0; count];
    }
    let spans: Vec<f32> = knots
        .windows(2)
        .map(|pair| pair[1][0] - pair[0][0])
        .collect();
    let secants: Vec<f32> = (knots.windows(2).zip(&spans))
        .map(|(pair, span)| (pair[1][1] - pair[0][1]) / span)
        .collect();
    if count == 2 {
        return vec![secants[0]; 2];
    }
    let mut slopes = vec![0.0; count];
    for index in 1..count - 1 {
        let (before, after) = (secants[index - 1], secants[index]);
        if before * after > 0.0 {
            let w1 = 2.0 * spans[index] + spans[index - 1];
            let w2 = spans[index] + 2.0 * spans[index - 1];
            slopes[index] = (w1 + w2) / (w1 / before + w2 / after);
        }
    }
    slopes[0] = end_slope([spans[0], spans[1]], [secants[0], secants[1]]);
    slopes[count - 1] = end_slope(
        [spans[count - 2], spans[count - 3]],
        [secants[count - 2], secants[count - 3]],
    );
    slopes
}

fn end_slope([h0, h1]: [f32; 2], [d0, d1]: [f32; 2]) -> f32 {
    let slope = ((2.0 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
    if slope * d0 <= 0.0 {
        0.0
    } else if d0 * d1 <= 0.0 && slope.abs() > 3.0 * d0.abs() {
        3.0 * d0
    } else {
        slope
    }
}

/// Rows of numbers along a common abscissa, interpolated column by column.
pub(crate) fn resample_rows(abscissas: &[f32], rows: &[Vec<f32>], at: &[f32]) -> Vec<Vec<f32>> {
    let mut resampled = vec![Vec::new(); at.len()];
    for column in 0..rows.first().map_or(0, Vec::len) {
        let knots: Vec<[f32; 2]> = (abscissas.iter().zip(rows))
            .map(|(&x, row)| [x, row[column]])
            .collect();
        let curve = Pchip::new(&knots);
        for (row, &x) in resampled.iter_mut().zip(at) {
            row.push(curve.at(x));
        }
    }
    resampled
}

/// A closed curve sampled at equal angles, resampled at `count` equal angles.
pub(crate) fn resample_periodic(values: &[f32], count: usize) -> Vec<f32> {
    const WRAP: usize = 3;
    let len = values.len();
    let knots: Vec<[f32; 2]> = (0..len + 2 * WRAP)
        .map(|index| {
            [
                index as f32 - WRAP as f32,
                values[(index + len - WRAP) % len],
            ]
        })
        .collect();
    let curve = Pchip::new(&knots);
    let step = len as f32 / count as f32;
    (0..count)
        .map(|index| curve.at(index as f32 * step))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_curve_goes_through_its_knots_and_never_overshoots() {
        let knots = [[0.0, 0.0], [1.0, 1.0], [2.0, 1.0], [4.0, 5.0]];
        let curve = Pchip::new(&knots);
        for [x, y] in knots {
            assert!((curve.at(x) - y).abs() < 1e-6);
        }
        let samples: Vec<f32> = (0..=100)
            .map(|index| curve.at(index as f32 * 0.04))
            .collect();
        assert!(samples.windows(2).all(|pair| pair[1] >= pair[0] - 1e-6));
    }

    #[test]
    fn a_straight_line_stays_straight() {
        let curve = Pchip::new(&[[0.0, 1.0], [0.5, 2.0], [2.0, 5.0]]);
        for index in 0..=20 {
            let x = index as f32 * 0.1;
            assert!((curve.at(x) - (1.0 + 2.0 * x)).abs() < 1e-5);
        }
    }
}
