//! Cloth and pieces as rows of bits along the cloth, and all free places of a piece at once.

use kurbo::Point;

use crate::polygon::Polygon;

/// Bits of a word.
const WORD: usize = 64;

/// A row of pixels along the cloth.
#[derive(Debug, Clone, Default)]
struct Bits(Vec<u64>);

impl Bits {
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
        if bits == 0 {
            let pairs = self.0.iter_mut().zip(source);
            pairs.for_each(|(word, low)| *word |= low);
            return;
        }
        let Some((last, ahead)) = source.split_last().map(|(last, _)| (last, &source[1..])) else {
            return;
        };
        let pairs = source.iter().zip(ahead);
        for (word, (low, high)) in self.0.iter_mut().zip(pairs) {
            *word |= low >> bits | high << (WORD - bits);
        }
        if let Some(word) = self.0.get_mut(source.len() - 1) {
            *word |= last >> bits;
        }
    }

    fn is_full(&self) -> bool {
        self.0.iter().all(|word| *word == u64::MAX)
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

/// A piece as runs of pixels: every pixel that it touches.
#[derive(Debug, Clone)]
pub(super) struct Shape {
    /// Runs `[from, to)` of each row, rows across the cloth.
    rows: Vec<Vec<[usize; 2]>>,
    /// Rows in the order in which they are looked at: the longest first, for they leave least.
    longest_first: Vec<usize>,
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
        let rows: Vec<Vec<[usize; 2]>> = (0..row_count)
            .map(|row| row_runs(&sides, row as f64))
            .collect();
        let longest = |row: &usize| rows[*row].iter().map(|[from, to]| to - from).max();
        let mut longest_first: Vec<usize> = (0..row_count).collect();
        longest_first.sort_by_key(|row| std::cmp::Reverse(longest(row)));
        Self {
            rows,
            longest_first,
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

/// A row of cloth, and where a run of 1, 2, 4, … pixels that begins there would meet something; empty where nothing
/// is taken.
#[derive(Debug, Clone, Default)]
struct Row(Vec<Bits>);

impl Row {
    /// Takes some pixels of a row of so many words.
    fn take(&mut self, runs: impl Iterator<Item = [usize; 2]>, word_count: usize) {
        let mut taken = self.0.drain(..).next().unwrap_or_default();
        taken.0.resize(word_count, 0);
        runs.for_each(|run| taken.set(run));
        let mut length = 1;
        while length < word_count * WORD {
            let mut longer = taken.clone();
            longer.or_shifted(&taken, length);
            self.0.push(std::mem::replace(&mut taken, longer));
            length *= 2;
        }
        self.0.push(taken);
    }

    /// Adds to `taken` where a run would meet something, `from` pixels behind the place itself.
    fn meet(&self, [from, to]: [usize; 2], taken: &mut Bits) {
        let Some(longest) = self.0.len().checked_sub(1) else {
            return;
        };
        let length = to - from;
        // Two runs of a power of two cover one of any length; longer than the cloth is as long as it.
        let level = (length.ilog2() as usize).min(longest);
        let met = &self.0[level];
        taken.or_shifted(met, from);
        let rest = length - (1 << level);
        if 0 < rest {
            taken.or_shifted(met, from + rest);
        }
    }
}

/// Cloth of which some pixels are taken.
#[derive(Debug, Clone)]
pub(super) struct Field {
    rows: Vec<Row>,
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
            rows: vec![Row::default(); row_count],
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
        let mut taken = Bits::default();
        for row in 0..=last_row {
            let before = best.map(|[column, _]| column);
            if before == Some(0) {
                break;
            }
            self.find_taken(shape, row, before, &mut taken);
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

    /// All columns at which a shape whose lowest row lies at `row` would meet something; of those `before` a column
    /// where only they matter, and then more may count as taken.
    fn find_taken(&self, shape: &Shape, row: usize, before: Option<usize>, taken: &mut Bits) {
        taken.0.clear();
        taken.0.resize(self.end.div_ceil(WORD), 0);
        if let Some(before) = before {
            // A place between two pixels needs the next one too.
            let matter = before + 1;
            taken.0.truncate(matter.div_ceil(WORD));
            taken.set([matter.min(taken.0.len() * WORD), taken.0.len() * WORD]);
        }
        for &above in &shape.longest_first {
            let cloth = &self.rows[row + above];
            if cloth.0.is_empty() {
                continue;
            }
            for run in &shape.rows[above] {
                cloth.meet(*run, taken);
            }
            if before.is_some() && taken.is_full() {
                return;
            }
        }
    }

    /// Takes the pixels of a shape.
    pub(super) fn take(&mut self, shape: &Shape, [column, row]: [usize; 2]) {
        let needed = column + shape.column_count + 1;
        self.end = self.end.max(needed);
        let word_count = self.end.div_ceil(WORD);
        for (runs, cloth) in shape.rows.iter().zip(&mut self.rows[row..]) {
            if !runs.is_empty() {
                let runs = runs.iter().map(|[from, to]| [from + column, to + column]);
                cloth.take(runs, word_count);
            }
        }
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

    /// The first free place, pixel by pixel.
    fn looked_for(
        taken: &[Vec<bool>],
        shape: &Shape,
        last_row: usize,
        columns: &Columns<'_>,
    ) -> Option<[usize; 2]> {
        let is_free = |column: usize, row: usize| {
            let mut runs = shape.rows.iter().enumerate();
            runs.all(|(above, runs)| {
                let mut pixels = runs.iter().flat_map(|[from, to]| *from..*to);
                pixels.all(|x| {
                    let pixel = taken[row + above].get(column + x);
                    !pixel.copied().unwrap_or(false)
                })
            })
        };
        let rows = |column: usize| (0..=last_row).map(move |row| [column, row]);
        match columns {
            Columns::All => (0..).flat_map(rows).find(|[x, y]| is_free(*x, *y)),
            Columns::Only(list) => (list.iter().copied().flat_map(rows))
                .find(|[x, y]| is_free(*x, *y) && is_free(*x + 1, *y)),
        }
    }

    /// Polygons by chance are laid one after the other where a search pixel by pixel finds room for them.
    #[test]
    fn the_first_free_place_is_the_one_that_a_search_finds() {
        let mut chance = lole_geom::chance::Chance::new(7);
        let mut side = |most: f32| f64::from(chance.between(1.0, most));
        for round in 0..40 {
            let row_count = 24;
            let mut field = Field::new(row_count);
            let mut taken = vec![vec![false; 2_000]; row_count];
            for piece in 0..12 {
                let [wide, high] = [side(90.0), side(20.0)];
                let corners = [
                    (0.0, side(20.0).min(high)),
                    (side(90.0).min(wide), 0.0),
                    (wide, side(20.0).min(high)),
                    (side(90.0).min(wide), high),
                ];
                let shape = Shape::new(&Polygon::new(corners.map(Point::from)), 1.0);
                let last_row = row_count - shape.row_count();
                let list = [0, 3, 40, 64, 65, 127, 200, 400, 1_000];
                let columns = if piece % 3 == 2 {
                    Columns::Only(&list)
                } else {
                    Columns::All
                };
                let found = field.first_free(&shape, last_row, &columns);
                let expected = looked_for(&taken, &shape, last_row, &columns);
                assert_eq!(found, expected, "piece {piece} of round {round}");
                let Some([column, row]) = found else { continue };
                field.take(&shape, [column, row]);
                for (above, runs) in shape.rows.iter().enumerate() {
                    let pixels = runs.iter().flat_map(|[from, to]| *from..*to);
                    pixels.for_each(|x| taken[row + above][column + x] = true);
                }
            }
        }
    }

    #[test]
    fn bits_are_found_across_words() {
        let mut bits = Bits(vec![0; 4]);
        bits.set([0, 130]);
        assert_eq!(bits.first_zero(0), 130);
        let mut shifted = Bits(vec![0; 4]);
        shifted.or_shifted(&bits, 70);
        assert_eq!(shifted.first_zero(0), 60);
    }
}
