//! Lays pieces on cloth in several orders and keeps the shortest plan.

use kurbo::{Affine, Rect, Vec2};
use lole_geom::Length;

use super::Placed;
use super::item::{FITS, Item, Way};
use super::raster::{Columns, Field, Shape};
use super::rectangles;
use super::slide::free_way;
use crate::polygon::Polygon;

/// Pixels while orders are tried [m].
const COARSE: f64 = 0.008;
/// Pixels of the plan itself [m].
const FINE: f64 = 0.004;
/// Orders that are tried beyond the usual ones, at least and at most.
const TRIES: [usize; 2] = [12, 160];
/// Rows of pixels that are smeared while orders are tried, in all: about a second of work.
const ROWS: usize = 6_000_000;
/// Plans that are laid again with fine pixels.
const KEPT: usize = 4;
/// Passes of pushing together.
const PASSES: u32 = 4;

/// A way for one item, and where it lies.
#[derive(Debug, Clone, Copy)]
struct Spot {
    way: usize,
    x: f64,
    y: f64,
}

/// Lays the items on cloth of this width.
pub(super) fn place(items: &[Item], width: Length, repeat: Option<Length>) -> Vec<Placed> {
    let table = Table {
        items,
        width: width.to_m(),
        repeat: repeat.map(Length::to_m).filter(|repeat| 0.0 < *repeat),
    };
    let (fitting, wide): (Vec<usize>, Vec<usize>) =
        (0..items.len()).partition(|&index| table.fits(index));
    let mut plan = if fitting.iter().all(|&index| table.is_rectangle(index)) {
        table.best_of(&fitting, |order| table.lay_rectangles(order))
    } else {
        table.nest(&fitting)
    };
    // What is wider than the cloth is drawn all the same, behind the others.
    let mut end = table.length(&plan);
    for index in wide {
        let way = &items[index].ways[0];
        let x = table.next_column(way, end);
        plan.push((index, Spot { way: 0, x, y: 0.0 }));
        end = x + way.outline.bounds().x1;
    }
    let placed = plan.into_iter().map(|(index, spot)| {
        let item = &items[index];
        let way = &item.ways[spot.way];
        let to_place = Affine::translate((spot.x, spot.y));
        Placed {
            piece: item.piece,
            copy: item.copy,
            layers: item.layers,
            cloth_from_piece: to_place * way.cloth_from_piece,
            outline: way.outline.transformed(to_place),
            is_on_fold: item.is_on_fold,
        }
    });
    placed.collect()
}

/// Items and where each lies.
type Plan = Vec<(usize, Spot)>;

struct Table<'a> {
    items: &'a [Item],
    width: f64,
    repeat: Option<f64>,
}

impl Table<'_> {
    fn fits(&self, index: usize) -> bool {
        let height = |way: &Way| way.outline.bounds().y1;
        (self.items[index].ways.iter()).all(|way| height(way) <= self.width + FITS)
    }

    fn is_rectangle(&self, index: usize) -> bool {
        self.items[index].ways.iter().all(|way| {
            let bounds = way.outline.bounds();
            (way.outline.signed_area() - bounds.area()).abs() < FITS
        })
    }

    fn way(&self, (index, spot): &(usize, Spot)) -> &Way {
        &self.items[*index].ways[spot.way]
    }

    fn length(&self, plan: &Plan) -> f64 {
        let ends = plan
            .iter()
            .map(|laid| laid.1.x + self.way(laid).outline.bounds().x1);
        ends.fold(0.0, f64::max)
    }

    /// The first column from `x` on at which the print of a piece is where it should be.
    fn next_column(&self, way: &Way, x: f64) -> f64 {
        let Some(repeat) = self.repeat else {
            return x;
        };
        let repeats = ((x + way.match_level) / repeat - FITS).ceil();
        repeats * repeat - way.match_level
    }

    /// The shortest of the plans that `lay` makes of the usual orders and of some by chance.
    fn best_of(&self, indices: &[usize], lay: impl Fn(&[usize]) -> Plan) -> Plan {
        self.orders(indices, &lay)
            .into_iter()
            .next()
            .map_or_else(Vec::new, |(_, order)| lay(&order))
    }

    /// Orders by the length of their plans, the shortest first.
    fn orders(&self, indices: &[usize], lay: &impl Fn(&[usize]) -> Plan) -> Vec<(f64, Vec<usize>)> {
        let size = |index: usize| self.items[index].ways[0].outline.bounds();
        let area = |index: usize| self.items[index].ways[0].outline.signed_area();
        let keys: [&dyn Fn(usize) -> f64; 4] = [
            &area,
            &|index| size(index).y1,
            &|index| size(index).x1,
            &|index| size(index).x1 + size(index).y1,
        ];
        let mut tried: Vec<(f64, Vec<usize>)> = Vec::new();
        for key in keys {
            let mut order = indices.to_vec();
            order.sort_by(|a, b| key(*b).total_cmp(&key(*a)));
            if tried.iter().all(|(_, other)| *other != order) {
                tried.push((self.length(&lay(&order)), order));
            }
        }
        tried.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut chance = 0x9e37_79b9_7f4a_7c15_u64;
        let tries = self.tries(indices);
        for _ in 0..if indices.len() < 2 { 0 } else { tries } {
            let mut order = tried[0].1.clone();
            let [one, other] = [(); 2].map(|()| random(&mut chance) % order.len());
            // Copies of one piece are alike: to swap them changes nothing.
            if self.items[order[one]].piece == self.items[order[other]].piece {
                continue;
            }
            order.swap(one, other);
            // Few pieces have few orders.
            if tried.iter().any(|(_, known)| *known == order) {
                continue;
            }
            tried.push((self.length(&lay(&order)), order));
            tried.sort_by(|a, b| a.0.total_cmp(&b.0));
        }
        tried
    }

    /// Orders that are worth trying: fewer where each takes longer.
    fn tries(&self, indices: &[usize]) -> usize {
        let rows = |index: &usize| -> usize {
            let ways = self.items[*index].ways.iter();
            ways.map(|way| {
                let height = way.outline.bounds().y1;
                whole(height / COARSE) * whole((self.width - height) / COARSE).max(1)
            })
            .sum()
        };
        let cost: usize = indices.iter().map(rows).sum();
        (ROWS / cost.max(1)).clamp(TRIES[0], TRIES[1])
    }

    fn lay_rectangles(&self, order: &[usize]) -> Plan {
        let mut taken: Vec<Rect> = Vec::new();
        let mut plan = Vec::new();
        for &index in order {
            let spots = self.items[index]
                .ways
                .iter()
                .enumerate()
                .map(|(number, way)| {
                    let size = way.outline.bounds();
                    let last_y = if way.is_at_edge {
                        0.0
                    } else {
                        self.width - size.y1
                    };
                    let column = |left: f64| self.next_column(way, left);
                    let [x, y] =
                        rectangles::first_free(&taken, [size.x1, size.y1], last_y, &column);
                    (x + size.x1, Spot { way: number, x, y })
                });
            let Some((_, spot)) =
                spots.reduce(|best, other| if other.0 < best.0 { other } else { best })
            else {
                continue;
            };
            let size = self.items[index].ways[spot.way].outline.bounds();
            taken.push(size + Vec2::new(spot.x, spot.y));
            plan.push((index, spot));
        }
        plan
    }

    /// Lays free shapes: many orders coarsely, the best ones finely, and pushes them together.
    fn nest(&self, indices: &[usize]) -> Plan {
        let coarse = self.shapes(COARSE);
        let orders = self.orders(indices, &|order| self.lay_shapes(order, &coarse, COARSE));
        let fine = self.shapes(FINE);
        let plans = orders.into_iter().take(KEPT).map(|(_, order)| {
            let mut plan = self.lay_shapes(&order, &fine, FINE);
            self.push_together(&mut plan);
            plan
        });
        let shorter = |best: Plan, other: Plan| {
            if self.length(&other) < self.length(&best) - FITS {
                other
            } else {
                best
            }
        };
        plans.reduce(shorter).unwrap_or_default()
    }

    fn shapes(&self, pixel: f64) -> Vec<Vec<Shape>> {
        let ways = |item: &Item| {
            item.ways
                .iter()
                .map(|way| Shape::new(&way.outline, pixel))
                .collect()
        };
        self.items.iter().map(ways).collect()
    }

    fn lay_shapes(&self, order: &[usize], shapes: &[Vec<Shape>], pixel: f64) -> Plan {
        let row_count = whole(self.width / pixel);
        // A piece as wide as the cloth may touch one row of pixels more than the cloth has.
        let mut field = Field::new(row_count + 1);
        let mut plan = Vec::new();
        for &index in order {
            let item = &self.items[index];
            let mut best: Option<(f64, Spot, [usize; 2])> = None;
            for (number, way) in item.ways.iter().enumerate() {
                let shape = &shapes[index][number];
                let last_row = row_count.saturating_sub(shape.row_count());
                let last_row = if way.is_at_edge { 0 } else { last_row };
                let list = self.columns(way, &field, pixel);
                let columns = list
                    .as_ref()
                    .map_or(Columns::All, |(pixels, _)| Columns::Only(pixels));
                let Some([column, row]) = field.first_free(shape, last_row, &columns) else {
                    continue;
                };
                let x = match &list {
                    Some((pixels, exact)) => (pixels.iter().zip(exact))
                        .find(|(pixel, _)| **pixel == column)
                        .map_or(0.0, |(_, x)| *x),
                    None => column as f64 * pixel,
                };
                let end = x + way.outline.bounds().x1;
                if best.as_ref().is_none_or(|(least, ..)| end < least - FITS) {
                    let y = row as f64 * pixel;
                    best = Some((end, Spot { way: number, x, y }, [column, row]));
                }
            }
            if let Some((_, spot, at)) = best {
                let shape = &shapes[index][spot.way];
                field.take(shape, at);
                if self.repeat.is_some() {
                    field.take(shape, [at[0] + 1, at[1]]);
                }
                plan.push((index, spot));
            }
        }
        plan
    }

    /// The columns at which the print of a piece is where it should be, as pixels and exactly, past the
    /// end of what is taken; `None` where all are.
    fn columns(&self, way: &Way, field: &Field, pixel: f64) -> Option<(Vec<usize>, Vec<f64>)> {
        let repeat = self.repeat?;
        let end = field.end() as f64 * pixel + 2.0 * repeat;
        let mut x = self.next_column(way, 0.0);
        let (mut pixels, mut exact) = (Vec::new(), Vec::new());
        while x <= end {
            pixels.push(whole(x / pixel));
            exact.push(x);
            x += repeat;
        }
        Some((pixels, exact))
    }

    /// Pushes pieces toward the cut end and the lower edge, those that lie nearest to it first.
    fn push_together(&self, plan: &mut Plan) {
        let mut order: Vec<usize> = (0..plan.len()).collect();
        order.sort_by(|a, b| plan[*a].1.x.total_cmp(&plan[*b].1.x));
        let mut outlines: Vec<Polygon> = (plan.iter())
            .map(|laid| {
                let spot = laid.1;
                let outline = &self.way(laid).outline;
                outline.transformed(Affine::translate((spot.x, spot.y)))
            })
            .collect();
        for _ in 0..PASSES {
            for &moving in &order {
                for direction in [Vec2::new(-1.0, 0.0), Vec2::new(0.0, -1.0)] {
                    let way = self.slack(&plan[moving], moving, &outlines, direction);
                    let spot = &mut plan[moving].1;
                    spot.x += direction.x * way;
                    spot.y += direction.y * way;
                    let along = Affine::translate(direction * way);
                    outlines[moving] = outlines[moving].transformed(along);
                }
            }
        }
    }

    /// How far a piece can be pushed [m].
    fn slack(
        &self,
        laid: &(usize, Spot),
        moving: usize,
        outlines: &[Polygon],
        direction: Vec2,
    ) -> f64 {
        let (is_along, spot) = (direction.x != 0.0, laid.1);
        let is_held = if is_along {
            self.repeat.is_some()
        } else {
            self.way(laid).is_at_edge
        };
        if is_held {
            return 0.0;
        }
        let limit = if is_along { spot.x } else { spot.y };
        let others = outlines.iter().enumerate();
        let others: Vec<_> = others
            .filter(|(index, _)| *index != moving)
            .map(|(_, outline)| outline)
            .collect();
        free_way(&outlines[moving], &others, direction, limit)
    }
}

/// Whole pixels of a length.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "cloth is some thousand pixels long"
)]
fn whole(pixels: f64) -> usize {
    (pixels + 1e-4).floor().max(0.0) as usize
}

/// The next number of a linear congruential row (Knuth's multiplier), its upper bits.
fn random(state: &mut u64) -> usize {
    *state = state
        .wrapping_mul(6_364_136_223_846_793_005)
        .wrapping_add(1_442_695_040_888_963_407);
    usize::try_from(*state >> 33).unwrap_or(0)
}
