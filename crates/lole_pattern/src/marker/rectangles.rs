//! Upright rectangles, laid exactly: each into the leftmost corner that the others leave.

use kurbo::Rect;

use super::item::FITS;

/// The place farthest left, and the lowest one there, where a rectangle of this size fits beside the
/// others within a width [m]. A corner of it touches others or the edge: any other place could be
/// moved left or down.
pub(super) fn first_free(
    taken: &[Rect],
    [length, height]: [f64; 2],
    last_y: f64,
    is_column: &dyn Fn(f64) -> f64,
) -> [f64; 2] {
    let lefts = taken.iter().map(|rect| rect.x1).chain([0.0]);
    let bottoms = taken.iter().map(|rect| rect.y1).chain([0.0]);
    let bottoms: Vec<f64> = bottoms.filter(|y| *y <= last_y + FITS).collect();
    let mut best = [f64::INFINITY, 0.0];
    for left in lefts {
        let left = is_column(left);
        for &bottom in &bottoms {
            let rect = Rect::new(left, bottom, left + length, bottom + height);
            let is_better = left < best[0] - FITS || (left < best[0] + FITS && bottom < best[1]);
            if is_better && taken.iter().all(|other| !overlap(rect, *other)) {
                best = [left, bottom];
            }
        }
    }
    best
}

fn overlap(a: Rect, b: Rect) -> bool {
    a.x0 + FITS < b.x1 && b.x0 + FITS < a.x1 && a.y0 + FITS < b.y1 && b.y0 + FITS < a.y1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_halves_lie_side_by_side_and_a_third_behind() {
        let any = |left: f64| left;
        let mut taken = Vec::new();
        for expected in [[0.0, 0.0], [0.0, 0.55], [0.9, 0.0]] {
            let [x, y] = first_free(&taken, [0.9, 0.55], 0.55, &any);
            assert_eq!([x, y], expected);
            taken.push(Rect::new(x, y, x + 0.9, y + 0.55));
        }
    }
}
