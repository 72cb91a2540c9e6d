//! Cloth and pieces as rows of bits along the cloth, and all free places of a piece at once.

use kurbo::Point;

use crate::polygon::Polygon;

/// Bits of a word.
const WORD: usize = 64;

/// A row of pixels along the cloth.
#[derive(Debug, Clone, Default)]
struct Bits(Vec<u64>);

impl Bits {
    fn zeros(length: usize) -> Self {
        Self(vec![0; length.div_ceil(WORD)])
    }

    fn set(&mut self, [from, to]: [usize; 2]) {
        for word in from / WORD..to.div_ceil(WORD) {
            let (low, high) = (word * WORD, (word + 1) * WORD);
            let count = to.min(high) - from.max(low);
            let ones = if count == WORD {
                u64::MAX
            } else {
                (1 << count) - 1
            };
            self.0[word] |= ones << (from.max(low) - low);
        }
    }

    /// `self[x] |= other[x + by]`.
    fn or_shifted(&mut self, other: &Self, by: usize) {
        let (words, bits) = (by / WORD, by % WORD);
        let source = other.0.get(words..).unwrap_or_default();
        for (index, word) in self.0.iter_mut().enumerate() {
            *word |= shifted(source, index, bits);
        }
    }

    /// `self[x] |= self[x + by]`: what is read lies ahead of what is written.
    fn smear(&mut self, by: usize) {
        let (words, bits) = (by / WORD, by % WORD);
        for index in 0..self.0.len() {
            let source = self.0.get(words..).unwrap_or_default();
            let ahead = shifted(source, index, bits);
            self.0[index] |= ahead;
        }
    }

    fn copy_from(&mut self, other: &Self) {
        self.0.clear();
        self.0.extend_from_slice(&other.0);
    }

    fn is_empty(&self) -> bool {
        self.0.iter().all(|word| *word == 0)
    }

    /// The first bit from `from` on that is zero; beyond the end all are.
    fn first_zero(&self, from: usize) -> usize {
        let mut at = from;
        while let Some(word) = self.0.get(at / WORD) {
            let rest = !word >> (at % WORD);
            if rest != 0 {
                return at + rest.trailing_zeros() as usize;
            }
            at = (at / WORD + 1) * WORD;
        }
        at
    }

    fn is_zero(&self, at: usize) -> bool {
        (self.0.get(at / WORD)).is_none_or(|word| word >> (at % WORD) & 1 == 0)
    }
}

/// 64 bits of a row from `index` words and some bits on.
fn shifted(row: &[u64], index: usize, bits: usize) -> u64 {
    let low = row.get(index).copied().unwrap_or(0) >> bits;
    if bits == 0 {
        low
    } else {
        low | row.get(index + 1).copied().unwrap_or(0) << (WORD - bits)
    }
}

/// A piece as runs of pixels: every pixel that it touches.
#[derive(Debug, Clone)]
pub(super) struct Shape {
    /// Runs `[from, to)` of each row, rows across the cloth.
    rows: Vec<Vec<[usize; 2]>>,
    pub(super) column_count: usize,
}

/// Whole pixels: what reaches into the next one by less than this part of a pixel does not touch it.
const SLACK: f64 = 1.0e-4;

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "cloth is some thousand pixels long, and no piece lies left of zero"
)]
fn pixel_below(value: f64) -> usize {
    (value + SLACK).floor().max(0.0) as usize
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "cloth is some thousand pixels long, and no piece lies left of zero"
)]
fn pixel_above(value: f64) -> usize {
    (value - SLACK).ceil().max(0.0) as usize
}

impl Shape {
    /// The pixels of size `pixel` [m] that an outline with its lower left corner at zero touches.
    pub(super) fn new(outline: &Polygon, pixel: f64) -> Self {
        let scaled = |point: Point| Point::new(point.x / pixel, point.y / pixel);
        let sides: Vec<[Point; 2]> = (outline.sides())
            .map(|[a, b]| [scaled(a), scaled(b)])
            .collect();
        let bounds = outline.bounds();
        let row_count = pixel_above(bounds.y1 / pixel);
        let rows = (0..row_count)
            .map(|row| row_runs(&sides, row as f64))
            .collect();
        Self {
            rows,
            column_count: pixel_above(bounds.x1 / pixel),
        }
    }

    pub(super) fn row_count(&self) -> usize {
        self.rows.len()
    }
}

/// Runs of the pixels between `bottom` and one above it that a polygon touches: what its sides cover
/// in the row, and what lies between them at the row's bottom, middle and top.
fn row_runs(sides: &[[Point; 2]], bottom: f64) -> Vec<[usize; 2]> {
    let top = bottom + 1.0;
    let mut spans: Vec<[f64; 2]> = Vec::new();
    for [a, b] in sides {
        let [low, high] = if a.y <= b.y { [a, b] } else { [b, a] };
        if high.y <= bottom + SLACK || top - SLACK <= low.y {
            continue;
        }
        let at = |y: f64| {
            let rise = high.y - low.y;
            if rise <= 0.0 {
                low.x
            } else {
                low.x + (high.x - low.x) * ((y - low.y) / rise).clamp(0.0, 1.0)
            }
        };
        let ends = [at(bottom.max(low.y)), at(top.min(high.y))];
        let is_flat = high.y - low.y <= 0.0;
        let ends = if is_flat { [low.x, high.x] } else { ends };
        spans.push([ends[0].min(ends[1]), ends[0].max(ends[1])]);
    }
    for level in [bottom + SLACK, bottom + 0.5, top - SLACK] {
        let mut crossings: Vec<f64> = (sides.iter())
            .filter(|[a, b]| (a.y <= level) != (b.y <= level))
            .map(|[a, b]| a.x + (b.x - a.x) * (level - a.y) / (b.y - a.y))
            .collect();
        crossings.sort_by(f64::total_cmp);
        spans.extend(crossings.chunks_exact(2).map(|pair| [pair[0], pair[1]]));
    }
    spans.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let mut runs: Vec<[usize; 2]> = Vec::new();
    for [from, to] in spans {
        let run = [
            pixel_below(from),
            pixel_above(to).max(pixel_below(from) + 1),
        ];
        match runs.last_mut() {
            Some(last) if run[0] <= last[1] => last[1] = last[1].max(run[1]),
            _ => runs.push(run),
        }
    }
    runs
}

/// Cloth of which some pixels are taken.
#[derive(Debug, Clone)]
pub(super) struct Field {
    rows: Vec<Bits>,
    column_count: usize,
    /// Free from this column on.
    end: usize,
}

/// Columns at which a piece may lie.
pub(super) enum Columns<'a> {
    /// All.
    All,
    /// Only these, rising.
    Only(&'a [usize]),
}

impl Field {
    pub(super) fn new(row_count: usize) -> Self {
        Self {
            rows: vec![Bits::default(); row_count],
            column_count: 0,
            end: 0,
        }
    }

    /// Free from this column on.
    pub(super) const fn end(&self) -> usize {
        self.end
    }

    /// The first free place: the column farthest left, and the lowest row there. Beyond everything
    /// that is taken there always is one.
    pub(super) fn first_free(
        &self,
        shape: &Shape,
        last_row: usize,
        columns: &Columns<'_>,
    ) -> Option<[usize; 2]> {
        let mut best: Option<[usize; 2]> = None;
        let mut smeared = Bits::default();
        for row in 0..=last_row {
            if best.is_some_and(|[column, _]| column == 0) {
                break;
            }
            let taken = self.taken(shape, row, &mut smeared);
            let column = match columns {
                Columns::All => Some(taken.first_zero(0)),
                Columns::Only(list) => {
                    let mut free = list.iter().filter(|column| {
                        // A place between two pixels touches both.
                        taken.is_zero(**column) && taken.is_zero(**column + 1)
                    });
                    free.next().copied()
                }
            };
            if let Some(column) = column
                && best.is_none_or(|[least, _]| column < least)
            {
                best = Some([column, row]);
            }
        }
        best
    }

    /// All columns at which a shape whose lowest row lies at `row` would meet something. `smeared` is
    /// room to work in.
    fn taken(&self, shape: &Shape, row: usize, smeared: &mut Bits) -> Bits {
        let mut taken = Bits::zeros(self.end);
        for (runs, cloth) in shape.rows.iter().zip(&self.rows[row..]) {
            if cloth.is_empty() {
                continue;
            }
            for [from, to] in runs {
                // The row smeared by the run's length, doubling it each time.
                smeared.copy_from(cloth);
                let mut length = 1;
                while length < to - from {
                    let by = length.min(to - from - length);
                    smeared.smear(by);
                    length += by;
                }
                taken.or_shifted(smeared, *from);
            }
        }
        taken
    }

    /// Takes the pixels of a shape.
    pub(super) fn take(&mut self, shape: &Shape, [column, row]: [usize; 2]) {
        let needed = column + shape.column_count + 1;
        if self.column_count < needed {
            self.column_count = needed.next_multiple_of(WORD);
            for bits in &mut self.rows {
                bits.0.resize(self.column_count / WORD, 0);
            }
        }
        for (runs, bits) in shape.rows.iter().zip(&mut self.rows[row..]) {
            for [from, to] in runs {
                bits.set([from + column, to + column]);
            }
        }
        self.end = self.end.max(needed);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangle() -> Polygon {
        Polygon::new([(0.0, 0.0), (10.0, 0.0), (0.0, 10.0)].map(Point::from))
    }

    #[test]
    fn a_shape_covers_every_pixel_that_it_touches() {
        let shape = Shape::new(&triangle(), 1.0);
        assert_eq!(shape.row_count(), 10);
        for (row, runs) in shape.rows.iter().enumerate() {
            assert_eq!(runs, &vec![[0, 10 - row]], "row {row}");
        }
    }

    #[test]
    fn a_second_triangle_fits_beside_the_slope_of_the_first() {
        let first = Shape::new(&triangle(), 1.0);
        let turned = [(10.0, 10.0), (0.0, 10.0), (10.0, 0.0)];
        let second = Shape::new(&Polygon::new(turned.map(Point::from)), 1.0);
        let mut field = Field::new(10);
        field.take(&first, [0, 0]);
        // The slopes meet in one row of pixels that both touch.
        assert_eq!(field.first_free(&second, 0, &Columns::All), Some([1, 0]));
        let only = [0, 5, 20];
        assert_eq!(
            field.first_free(&second, 0, &Columns::Only(&only)),
            Some([5, 0])
        );
    }

    #[test]
    fn bits_are_found_across_words() {
        let mut bits = Bits::zeros(256);
        bits.set([0, 130]);
        assert_eq!(bits.first_zero(0), 130);
        let mut shifted = Bits::zeros(256);
        shifted.or_shifted(&bits, 70);
        assert_eq!(shifted.first_zero(0), 60);
    }
}
