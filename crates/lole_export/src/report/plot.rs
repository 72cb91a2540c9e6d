//! Line plots as inline SVG: few ticks, large figures, one accent.

use std::fmt::Write as _;

use super::text::number;

/// Size of the drawing [SVG unit]; the page scales it.
const WIDTH: f64 = 520.0;
const HEIGHT: f64 = 250.0;
/// Room for figures left of and below the axes, and above and right of the curve.
const LEFT: f64 = 58.0;
const BOTTOM: f64 = 44.0;
const MARGIN: f64 = 16.0;
/// Most points of a curve; more would not be seen and make the page heavy.
const POINTS_MAX: usize = 1200;

/// One curve over time.
pub(super) struct Plot<'a> {
    /// Times [s].
    pub times: &'a [f64],
    /// Values; where one is not finite the curve is broken.
    pub values: &'a [f64],
    /// A value drawn as a dashed line, with its label.
    pub reference: Option<(f64, &'a str)>,
    /// Whether the axis starts at zero, or near the smallest value.
    pub floor: Floor,
}

/// Where a value axis starts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Floor {
    /// At zero.
    Zero,
    /// At a round number below the smallest value.
    Smallest,
}

/// The plot as an SVG element, `None` where there is nothing to draw.
pub(super) fn svg(plot: &Plot<'_>) -> Option<String> {
    let count = plot.times.len().min(plot.values.len());
    let finite = || {
        plot.values[..count]
            .iter()
            .copied()
            .filter(|value| value.is_finite())
    };
    let time_max = plot.times[..count]
        .iter()
        .copied()
        .filter(|time| time.is_finite())
        .reduce(f64::max)?;
    let (low, high) = finite().fold((f64::MAX, f64::MIN), |(l, h), v| (l.min(v), h.max(v)));
    if high < low || time_max <= 0.0 {
        return None;
    }
    let high = plot
        .reference
        .map_or(high, |(value, _)| high.max(value * 1.08));
    let low = if plot.floor == Floor::Zero {
        low.min(0.0)
    } else {
        low
    };
    let value_step = tick_step(high - low);
    let (bottom, top) = (
        (low / value_step).floor() * value_step,
        (high / value_step + 1e-9)
            .ceil()
            .max((low / value_step).floor() + 1.0)
            * value_step,
    );
    let x = |time: f64| LEFT + (WIDTH - LEFT - MARGIN) * time / time_max;
    let y = |value: f64| {
        HEIGHT - BOTTOM - (HEIGHT - BOTTOM - MARGIN) * (value - bottom) / (top - bottom)
    };
    let mut svg = format!("<svg viewBox=\"0 0 {WIDTH} {HEIGHT}\" role=\"img\">");
    let decimals = if value_step < 0.1 {
        2
    } else {
        usize::from(value_step < 1.0)
    };
    for value in ticks(bottom, top, value_step) {
        let (right, line, text) = (WIDTH - MARGIN, y(value), number(value, decimals));
        append(
            &mut svg,
            format_args!(
                "<line class=\"grid\" x1=\"{LEFT}\" x2=\"{right}\" y1=\"{line:.1}\" y2=\"{line:.1}\"/><text x=\"{:.0}\" y=\"{:.1}\" text-anchor=\"end\">{text}</text>",
                LEFT - 8.0,
                line + 6.0,
            ),
        );
    }
    let time_step = tick_step(time_max);
    for time in ticks(0.0, time_max, time_step) {
        let text = number(time, usize::from(time_step < 1.0));
        append(
            &mut svg,
            format_args!(
                "<text x=\"{:.1}\" y=\"{:.0}\" text-anchor=\"middle\">{text}</text>",
                x(time),
                HEIGHT - BOTTOM + 24.0,
            ),
        );
    }
    let path = curve(plot, count, &x, &y);
    append(
        &mut svg,
        format_args!("<path class=\"curve\" d=\"{path}\"/>"),
    );
    if let Some((value, label)) = plot.reference {
        append_reference(&mut svg, y(value), label);
    }
    svg.push_str("</svg>");
    Some(svg)
}

/// A dashed line at height `line` with its label above it.
fn append_reference(svg: &mut String, line: f64, label: &str) {
    let right = WIDTH - MARGIN;
    append(
        svg,
        format_args!(
            "<line class=\"reference\" x1=\"{LEFT}\" x2=\"{right}\" y1=\"{line:.1}\" y2=\"{line:.1}\"/><text class=\"reference\" x=\"{right}\" y=\"{:.1}\" text-anchor=\"end\">{label}</text>",
            line - 6.0,
        ),
    );
}

/// The curve as SVG path commands. Long series are thinned to the largest value of each stretch,
/// so that no peak is lost.
fn curve(plot: &Plot<'_>, count: usize, x: &dyn Fn(f64) -> f64, y: &dyn Fn(f64) -> f64) -> String {
    let stretch = count.div_ceil(POINTS_MAX).max(1);
    let mut path = String::new();
    let mut pen_is_down = false;
    let pairs: Vec<(f64, f64)> = plot.times[..count]
        .iter()
        .copied()
        .zip(plot.values[..count].iter().copied())
        .collect();
    for pairs in pairs.chunks(stretch) {
        let peak = pairs
            .iter()
            .filter(|(time, value)| time.is_finite() && value.is_finite())
            .copied()
            .reduce(|best, next| if best.1 < next.1 { next } else { best });
        if let Some((time, value)) = peak {
            let command = if pen_is_down { 'L' } else { 'M' };
            append(
                &mut path,
                format_args!("{command}{:.1} {:.1}", x(time), y(value)),
            );
        }
        pen_is_down = peak.is_some();
    }
    path
}

/// A step of 1, 2 or 5 times a power of ten that gives three to six ticks over `span`.
fn tick_step(span: f64) -> f64 {
    let mut step = 1e-6;
    for factor in [2.0, 2.5, 2.0].into_iter().cycle().take(60) {
        if span <= 5.0 * step {
            break;
        }
        step *= factor;
    }
    step
}

/// Multiples of `step` from `low` to `high`.
fn ticks(low: f64, high: f64, step: f64) -> impl Iterator<Item = f64> {
    (0..=12_u8)
        .map(move |index| low + step * f64::from(index))
        .take_while(move |value| *value <= high + 1e-9 * step.max(high.abs()))
}

/// Writes to a string, which cannot fail.
fn append(text: &mut String, arguments: std::fmt::Arguments<'_>) {
    let written = text.write_fmt(arguments);
    debug_assert!(written.is_ok());
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_few_and_round() {
        for span in [0.003, 0.7, 1.0, 12.0, 16.7, 240.0] {
            let step = tick_step(span);
            let count = span / step;
            assert!((1.9..=5.0).contains(&count), "span {span}: step {step}");
        }
        assert!((tick_step(12.0) - 5.0).abs() < 1e-9);
    }

    #[test]
    fn a_gap_in_the_numbers_is_a_gap_in_the_curve() {
        let times = [0.0, 1.0, 2.0, 3.0, 4.0];
        let values = [1.0, 2.0, f64::NAN, 2.0, 1.0];
        let plot = Plot {
            times: &times,
            values: &values,
            reference: None,
            floor: Floor::Zero,
        };
        let svg = svg(&plot).unwrap();
        assert!(!svg.contains("NaN"));
        let path = &svg[svg.find("d=\"").unwrap()..];
        assert_eq!(path.matches('M').count(), 2);
    }

    #[test]
    fn nothing_finite_draws_nothing() {
        let plot = Plot {
            times: &[0.0, 1.0],
            values: &[f64::NAN, f64::INFINITY],
            reference: None,
            floor: Floor::Smallest,
        };
        assert!(svg(&plot).is_none());
    }
}
