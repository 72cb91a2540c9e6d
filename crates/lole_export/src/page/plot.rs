//! Line plots as inline SVG: few ticks, large figures, one accent.

use std::fmt::Write as _;

use super::text::{escape, number};

/// Size of the drawing [SVG unit]; the page scales it.
const WIDTH: f64 = 520.0;
const HEIGHT: f64 = 250.0;
/// Room for figures left of and below the axes, and above and right of the curve.
const LEFT: f64 = 58.0;
const BOTTOM: f64 = 44.0;
const MARGIN: f64 = 16.0;
/// Most points of a curve; more would not be seen and make the page heavy.
const POINTS_MAX: usize = 1200;

/// Curves over one axis.
pub(crate) struct Plot<'a> {
    /// The curves; named in a legend where there are several.
    pub curves: Vec<Curve<'a>>,
    /// A value drawn as a dashed line, with its label.
    pub reference: Option<(f64, &'a str)>,
    /// Where the value axis starts.
    pub floor: Floor,
    /// How values are spread over the axis.
    pub scale: Scale,
}

/// One curve.
pub(crate) struct Curve<'a> {
    /// Its name in the legend.
    pub name: &'a str,
    /// Along the axis, from 0 upwards, ascending.
    pub along: &'a [f64],
    /// Values; where one is not finite the curve is broken.
    pub values: &'a [f64],
    /// How its points are shown.
    pub drawn: Drawn,
}

/// How the points of a curve are shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Drawn {
    /// Joined by a line.
    Line,
    /// Each by a ring, so that what lies under it is still seen.
    Rings,
    /// Each by a small dot.
    Dots,
}

/// Where a value axis starts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Floor {
    /// At zero.
    Zero,
    /// At a round number below the smallest value.
    Smallest,
}

/// How values are spread over the axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Scale {
    /// Evenly.
    Linear,
    /// By their decimal logarithm; values that have none break the curve.
    Logarithmic,
}

impl<'a> Plot<'a> {
    /// One curve on a linear axis.
    pub(crate) fn single(along: &'a [f64], values: &'a [f64], floor: Floor) -> Self {
        Self {
            curves: vec![Curve {
                name: "",
                along,
                values,
                drawn: Drawn::Line,
            }],
            reference: None,
            floor,
            scale: Scale::Linear,
        }
    }

    /// Where a value lies on the axis, before it is scaled to the drawing.
    fn on_axis(&self, value: f64) -> f64 {
        match self.scale {
            Scale::Linear => value,
            Scale::Logarithmic if value > 0.0 => value.log10(),
            Scale::Logarithmic => f64::NAN,
        }
    }

    /// All finite points of all curves, on the axis.
    fn points(&self) -> impl Iterator<Item = (f64, f64)> {
        self.curves
            .iter()
            .flat_map(|curve| curve.along.iter().zip(curve.values))
            .map(|(&along, &value)| (along, self.on_axis(value)))
            .filter(|(along, value)| along.is_finite() && value.is_finite())
    }
}

/// The plot as an SVG element, `None` where there is nothing to draw.
pub(crate) fn svg(plot: &Plot<'_>) -> Option<String> {
    let axes = Axes::of(plot)?;
    let mut svg = format!("<svg viewBox=\"0 0 {WIDTH} {HEIGHT}\" role=\"img\">");
    axes.append_ticks(&mut svg);
    for (index, curve) in plot.curves.iter().enumerate() {
        axes.append_curve(&mut svg, index, curve);
    }
    if let Some((value, label)) = plot.reference {
        append_reference(&mut svg, axes.y(plot.on_axis(value)), label);
    }
    svg.push_str("</svg>");
    if 1 < plot.curves.len() {
        svg.push_str(&legend(plot));
    }
    Some(svg)
}

/// A plot, and what of its axes is shown.
struct Axes<'p> {
    plot: &'p Plot<'p>,
    along_max: f64,
    /// Ends of the value axis, whole steps both.
    bottom: f64,
    top: f64,
    value_step: f64,
}

impl<'p> Axes<'p> {
    /// The axes that hold everything of a plot; `None` where it has nothing to draw.
    fn of(plot: &'p Plot<'p>) -> Option<Self> {
        let along_max = plot.points().map(|point| point.0).reduce(f64::max)?;
        let (low, high) = plot
            .points()
            .fold((f64::MAX, f64::MIN), |(l, h), (_, v)| (l.min(v), h.max(v)));
        if along_max <= 0.0 {
            return None;
        }
        let high = plot
            .reference
            .map_or(high, |(value, _)| high.max(plot.on_axis(value * 1.08)));
        let low = if plot.floor == Floor::Zero && plot.scale == Scale::Linear {
            low.min(0.0)
        } else {
            low
        };
        let value_step = match plot.scale {
            Scale::Linear => tick_step(high - low),
            Scale::Logarithmic => tick_step(high - low).max(1.0).round(),
        };
        let first = (low / value_step).floor();
        let last = (high / value_step + 1e-9).ceil().max(first + 1.0);
        Some(Self {
            plot,
            along_max,
            bottom: first * value_step,
            top: last * value_step,
            value_step,
        })
    }

    /// Where something stands along the drawing.
    fn x(&self, along: f64) -> f64 {
        LEFT + (WIDTH - LEFT - MARGIN) * along / self.along_max
    }

    /// How far down a value of the axis stands.
    fn y(&self, value: f64) -> f64 {
        let height = HEIGHT - BOTTOM - MARGIN;
        HEIGHT - BOTTOM - height * (value - self.bottom) / (self.top - self.bottom)
    }

    /// Lines and figures of the value axis, figures of the other one.
    fn append_ticks(&self, svg: &mut String) {
        for value in ticks(self.bottom, self.top, self.value_step) {
            let (right, line) = (WIDTH - MARGIN, self.y(value));
            let text = tick_label(self.plot, value, self.value_step);
            append(
                svg,
                format_args!(
                    "<line class=\"grid\" x1=\"{LEFT}\" x2=\"{right}\" y1=\"{line:.1}\" y2=\"{line:.1}\"/><text x=\"{:.0}\" y=\"{:.1}\" text-anchor=\"end\">{text}</text>",
                    LEFT - 8.0,
                    line + 6.0,
                ),
            );
        }
        let along_step = tick_step(self.along_max);
        for along in ticks(0.0, self.along_max, along_step) {
            let text = number(along, usize::from(along_step < 1.0));
            append(
                svg,
                format_args!(
                    "<text x=\"{:.1}\" y=\"{:.0}\" text-anchor=\"middle\">{text}</text>",
                    self.x(along),
                    HEIGHT - BOTTOM + 24.0,
                ),
            );
        }
    }

    /// A curve as a line, or as a mark for each point.
    fn append_curve(&self, svg: &mut String, index: usize, curve: &Curve<'_>) {
        let (class, radius) = match curve.drawn {
            Drawn::Line => {
                let path = self.curve_path(curve);
                return append(
                    svg,
                    format_args!("<path class=\"curve c{index}\" d=\"{path}\"/>"),
                );
            }
            Drawn::Rings => ("ring", 6.5),
            Drawn::Dots => ("dot", 3.5),
        };
        for (&along, &value) in curve.along.iter().zip(curve.values) {
            let value = self.plot.on_axis(value);
            if along.is_finite() && value.is_finite() {
                append(
                    svg,
                    format_args!(
                        "<circle class=\"{class} c{index}\" cx=\"{:.1}\" cy=\"{:.1}\" r=\"{radius}\"/>",
                        self.x(along),
                        self.y(value),
                    ),
                );
            }
        }
    }

    /// The curve as SVG path commands. Long series are thinned to the largest value of each stretch,
    /// so that no peak is lost.
    fn curve_path(&self, curve: &Curve<'_>) -> String {
        let pairs: Vec<(f64, f64)> = curve
            .along
            .iter()
            .zip(curve.values)
            .map(|(&along, &value)| (along, self.plot.on_axis(value)))
            .collect();
        let stretch = pairs.len().div_ceil(POINTS_MAX).max(1);
        let mut path = String::new();
        let mut pen_is_down = false;
        for pairs in pairs.chunks(stretch) {
            let peak = pairs
                .iter()
                .filter(|(along, value)| along.is_finite() && value.is_finite())
                .copied()
                .reduce(|best, next| if best.1 < next.1 { next } else { best });
            if let Some((along, value)) = peak {
                let command = if pen_is_down { 'L' } else { 'M' };
                append(
                    &mut path,
                    format_args!("{command}{:.1} {:.1}", self.x(along), self.y(value)),
                );
            }
            pen_is_down = peak.is_some();
        }
        path
    }
}

/// What a tick of the value axis is called.
fn tick_label(plot: &Plot<'_>, value: f64, step: f64) -> String {
    if plot.scale == Scale::Logarithmic {
        return format!("10<tspan dy=\"-6\" font-size=\"75%\">{value:.0}</tspan>");
    }
    let decimals = if step < 0.1 {
        2
    } else {
        usize::from(step < 1.0)
    };
    number(value, decimals)
}

/// The names of the curves in their colors.
fn legend(plot: &Plot<'_>) -> String {
    let items: String = (plot.curves.iter().enumerate())
        .map(|(index, curve)| format!("<li class=\"c{index}\">{}</li>", escape(curve.name)))
        .collect();
    format!("<ul class=\"legend\">{items}</ul>")
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
        let plot = Plot::single(&times, &values, Floor::Zero);
        let svg = svg(&plot).unwrap();
        assert!(!svg.contains("NaN"));
        let path = &svg[svg.find("d=\"").unwrap()..];
        assert_eq!(path.matches('M').count(), 2);
    }

    #[test]
    fn every_finite_point_gets_its_mark() {
        let along = [0.0, 1.0, 2.0];
        let mut plot = Plot::single(&along, &[1.0, f64::NAN, 3.0], Floor::Zero);
        plot.curves[0].drawn = Drawn::Rings;
        let svg = svg(&plot).unwrap();
        assert_eq!(svg.matches("<circle").count(), 2);
        assert!(!svg.contains("<path") && !svg.contains("NaN"), "{svg}");
    }

    #[test]
    fn logarithms_have_powers_of_ten_and_no_zero() {
        let along = [0.0, 1.0, 2.0];
        let mut plot = Plot::single(&along, &[0.0, 1.0, 1000.0], Floor::Zero);
        plot.scale = Scale::Logarithmic;
        let svg = svg(&plot).unwrap();
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
        for power in 0..=3 {
            assert!(svg.contains(&format!(">{power}</tspan>")), "{svg}");
        }
    }

    #[test]
    fn nothing_finite_draws_nothing() {
        let plot = Plot::single(&[0.0, 1.0], &[f64::NAN, f64::INFINITY], Floor::Smallest);
        assert!(svg(&plot).is_none());
    }
}
