//! The engine's own layout: sixteen column strips side by side in one vector.
//!
//! A row of `W` columns is cut into sixteen strips of neighboring columns; lane `l` of group `g`
//! holds column `g` of strip `l`. Neighbors along a row are then whole neighboring vectors, and
//! only from the last column of a strip to the first of the next does a lane rotate.

use std::ops::Range;

use fearless_simd::{f32x16, prelude::*};
use glam::Vec3;

use crate::{Grid, Topology};

/// Column strips, and lanes of a vector.
pub(crate) const LANES: usize = 16;
const LANES_U8: u8 = 16;

/// One scalar for each lane.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(align(64))]
pub(crate) struct Scalars(pub(crate) [f32; LANES]);

/// One point for each lane: three vectors.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(align(64))]
pub(crate) struct Points {
    pub(crate) x: [f32; LANES],
    pub(crate) y: [f32; LANES],
    pub(crate) z: [f32; LANES],
}

impl Points {
    /// Moves all of them [m].
    pub(crate) fn shift(&mut self, by: Vec3) {
        let axes = [
            (&mut self.x, by.x),
            (&mut self.y, by.y),
            (&mut self.z, by.z),
        ];
        for (axis, by) in axes {
            axis.iter_mut().for_each(|value| *value += by);
        }
    }

    pub(crate) const fn get(&self, lane: usize) -> Vec3 {
        Vec3::new(self.x[lane], self.y[lane], self.z[lane])
    }

    pub(crate) const fn set(&mut self, lane: usize, point: Vec3) {
        self.x[lane] = point.x;
        self.y[lane] = point.y;
        self.z[lane] = point.z;
    }
}

/// Three vectors in registers.
#[derive(Clone, Copy)]
pub(crate) struct Vectors<S: Simd> {
    pub(crate) x: f32x16<S>,
    pub(crate) y: f32x16<S>,
    pub(crate) z: f32x16<S>,
}

impl<S: Simd> Vectors<S> {
    #[inline(always)]
    pub(crate) fn load(simd: S, points: &Points) -> Self {
        Self {
            x: f32x16::load_array_ref(simd, &points.x),
            y: f32x16::load_array_ref(simd, &points.y),
            z: f32x16::load_array_ref(simd, &points.z),
        }
    }

    #[inline(always)]
    pub(crate) fn splat(simd: S, point: Vec3) -> Self {
        Self {
            x: f32x16::splat(simd, point.x),
            y: f32x16::splat(simd, point.y),
            z: f32x16::splat(simd, point.z),
        }
    }

    #[inline(always)]
    pub(crate) fn store(self, points: &mut Points) {
        self.x.store_array(&mut points.x);
        self.y.store_array(&mut points.y);
        self.z.store_array(&mut points.z);
    }

    #[inline(always)]
    pub(crate) fn add(self, other: Self) -> Self {
        Self {
            x: self.x + other.x,
            y: self.y + other.y,
            z: self.z + other.z,
        }
    }

    #[inline(always)]
    pub(crate) fn sub(self, other: Self) -> Self {
        Self {
            x: self.x - other.x,
            y: self.y - other.y,
            z: self.z - other.z,
        }
    }

    #[inline(always)]
    pub(crate) fn scale(self, factor: f32x16<S>) -> Self {
        Self {
            x: self.x * factor,
            y: self.y * factor,
            z: self.z * factor,
        }
    }

    #[inline(always)]
    pub(crate) fn dot(self, other: Self) -> f32x16<S> {
        (self.x * other.x + self.y * other.y) + self.z * other.z
    }

    #[inline(always)]
    pub(crate) fn cross(self, other: Self) -> Self {
        Self {
            x: self.y * other.z - self.z * other.y,
            y: self.z * other.x - self.x * other.z,
            z: self.x * other.y - self.y * other.x,
        }
    }

    /// Lane `l` receives lane `l + shift`; a wide cloth needs shifts of 0 and 1, its strides 2 or 4.
    #[inline(always)]
    pub(crate) fn rotate_left(self, shift: u8) -> Self {
        match shift {
            0 => self,
            1 => self.slide::<1>(),
            2 => self.slide::<2>(),
            4 => self.slide::<4>(),
            _ => self.turned(shift),
        }
    }

    /// Lane `l + shift` receives lane `l`.
    #[inline(always)]
    pub(crate) fn rotate_right(self, shift: u8) -> Self {
        match shift {
            0 => self,
            1 => self.slide::<15>(),
            2 => self.slide::<14>(),
            4 => self.slide::<12>(),
            _ => self.turned(LANES_U8 - shift),
        }
    }

    #[inline(always)]
    fn slide<const SHIFT: usize>(self) -> Self {
        Self {
            x: self.x.rotate_elements_left::<SHIFT>(),
            y: self.y.rotate_elements_left::<SHIFT>(),
            z: self.z.rotate_elements_left::<SHIFT>(),
        }
    }

    #[inline(always)]
    fn turned(self, shift: u8) -> Self {
        let simd = self.x.token();
        let mut points = Points::default();
        self.store(&mut points);
        turn(&mut points, shift);
        Self::load(simd, &points)
    }
}

/// Lane `l` receives lane `l + shift`, whatever it is: rare, and kept out of the loops.
#[cold]
#[inline(never)]
fn turn(points: &mut Points, shift: u8) {
    for lanes in [&mut points.x, &mut points.y, &mut points.z] {
        lanes.rotate_left(usize::from(shift));
    }
}

/// Lane `l` receives lane `l + shift`.
#[inline(always)]
pub(crate) fn rotate_left<S: Simd>(value: f32x16<S>, shift: u8) -> f32x16<S> {
    match shift {
        0 => value,
        1 => value.rotate_elements_left::<1>(),
        2 => value.rotate_elements_left::<2>(),
        4 => value.rotate_elements_left::<4>(),
        _ => f32x16::load_array(value.token(), turned(value.to_array(), shift)),
    }
}

#[cold]
#[inline(never)]
fn turned(mut lanes: [f32; LANES], shift: u8) -> [f32; LANES] {
    lanes.rotate_left(usize::from(shift));
    lanes
}

/// The smaller of two numbers. Of two zeros and of a number and none it may be either, which no
/// bit of a finite state depends on but the sign of a zero.
#[inline(always)]
pub(crate) fn smaller<S: Simd>(first: f32x16<S>, second: f32x16<S>) -> f32x16<S> {
    first.min(second)
}

/// The larger of two numbers; see [`smaller`].
#[inline(always)]
pub(crate) fn larger<S: Simd>(first: f32x16<S>, second: f32x16<S>) -> f32x16<S> {
    first.max(second)
}

/// Where the columns of a row lie.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Layout {
    /// Vectors in a row.
    pub(crate) group_count: usize,
    pub(crate) row_count: usize,
    /// Group and lane of every column.
    slots: Vec<(u16, u8)>,
}

impl Layout {
    pub(crate) fn new(grid: &Grid) -> Self {
        let columns = grid.column_count as usize;
        let slots = (0..columns).map(|column| {
            // Lane `l` begins at column ceil(l W / 16): lengths of strips differ by one at most.
            let lane = column * LANES / columns;
            let first = (lane * columns).div_ceil(LANES);
            (narrow_u16(column - first), narrow_u8(lane))
        });
        Self {
            group_count: columns.div_ceil(LANES),
            row_count: grid.row_count as usize,
            slots: slots.collect(),
        }
    }

    /// Memory that it holds [byte].
    pub(crate) const fn byte_count(&self) -> usize {
        size_of_val(self.slots.as_slice())
    }

    /// Vectors in all rows.
    pub(crate) const fn vector_count(&self) -> usize {
        self.group_count * self.row_count
    }

    /// Vector and lane of the particle with row-major index `particle`.
    pub(crate) fn slot(&self, particle: usize) -> (usize, usize) {
        let (row, column) = (particle / self.slots.len(), particle % self.slots.len());
        let (group, lane) = self.slots[column];
        (
            row * self.group_count + usize::from(group),
            usize::from(lane),
        )
    }

    /// Vector and lane of every particle of a row, by column.
    #[inline(always)]
    pub(crate) fn row_slots(&self, row: usize) -> impl Iterator<Item = (usize, usize)> {
        let first = row * self.group_count;
        (self.slots.iter())
            .map(move |&(group, lane)| (first + usize::from(group), usize::from(lane)))
    }

    /// Brings row-major scalars into the layout; unused lanes hold 0.
    pub(crate) fn scatter(&self, values: &[f32]) -> Vec<Scalars> {
        let mut vectors = vec![Scalars::default(); self.vector_count()];
        for (particle, &value) in values.iter().enumerate() {
            let (vector, lane) = self.slot(particle);
            vectors[vector].0[lane] = value;
        }
        vectors
    }

    /// Brings row-major points into the layout. Unused lanes hold the first point, so that they
    /// lie in no box where the cloth is not.
    pub(crate) fn scatter_points(&self, points: &[Vec3], vectors: &mut [Points]) {
        let filler = points.first().copied().unwrap_or_default();
        for vector in vectors.iter_mut() {
            for lane in 0..LANES {
                vector.set(lane, filler);
            }
        }
        for (particle, &point) in points.iter().enumerate() {
            let (vector, lane) = self.slot(particle);
            vectors[vector].set(lane, point);
        }
    }

    /// Brings points back to row-major order.
    pub(crate) fn gather_points(&self, vectors: &[Points], points: &mut Vec<Vec3>) {
        points.clear();
        for row in vectors.chunks_exact(self.group_count) {
            points.extend(
                self.slots
                    .iter()
                    .map(|&(group, lane)| row[usize::from(group)].get(usize::from(lane))),
            );
        }
    }
}

/// A set of particles, by where they stand.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct SlotSet {
    /// By vector, their lanes; empty where there are none.
    lanes: Vec<u16>,
}

impl SlotSet {
    /// Memory that it holds [byte].
    pub(crate) const fn byte_count(&self) -> usize {
        size_of_val(self.lanes.as_slice())
    }

    pub(crate) const fn is_empty(&self) -> bool {
        self.lanes.is_empty()
    }

    /// Whether the particle of a vector and lane is in it.
    pub(crate) fn contains(&self, (vector, lane): (usize, usize)) -> bool {
        self.lanes
            .get(vector)
            .is_some_and(|lanes| (lanes >> lane) & 1 == 1)
    }

    pub(crate) fn clear(&mut self) {
        self.lanes.clear();
    }

    /// Adds the particle of a vector, of so many, and lane.
    pub(crate) fn insert(&mut self, (vector, lane): (usize, usize), vector_count: usize) {
        self.lanes.resize(vector_count, 0);
        self.lanes[vector] |= 1 << lane;
    }

    /// Becomes those of some of the vectors of another.
    pub(crate) fn take_part(&mut self, whole: &Self, vectors: Range<usize>) {
        self.lanes.clear();
        self.lanes
            .extend_from_slice(whole.lanes.get(vectors).unwrap_or(&[]));
    }
}

/// One relation between particles of a row, such as a spring, for all lanes at once.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct RowLink<const N: usize> {
    /// Group of every partner.
    pub(crate) groups: [u16; N],
    /// Lanes every partner is rotated by; 0 for the first.
    pub(crate) shifts: [u8; N],
    /// 1 in lanes where the relation exists, 0 elsewhere; `None` when it exists in all.
    pub(crate) mask: Option<Box<Scalars>>,
    /// Whether no link of its list has two partners in one group.
    list_is_apart: bool,
}

/// Whether no partners of any link lie in one group: only then may all be written at once.
#[inline(always)]
pub(crate) fn are_apart<const N: usize>(links: &[RowLink<N>]) -> bool {
    links.first().is_none_or(|link| link.list_is_apart)
}

impl<const N: usize> RowLink<N> {
    /// Whether it exists in all lanes and no partner is rotated.
    #[inline(always)]
    pub(crate) fn is_straight(&self) -> bool {
        self.mask.is_none() && self.shifts == [0; N]
    }

    /// Whether no two partners lie in one group.
    fn has_own_groups(&self) -> bool {
        (0..N).all(|first| (first + 1..N).all(|second| self.groups[first] != self.groups[second]))
    }
}

/// Every relation of a column with those `offsets` to its right, in an order that is fixed and
/// lets neighbors in the order run side by side.
pub(crate) fn row_links<const N: usize>(
    grid: &Grid,
    layout: &Layout,
    offsets: [u32; N],
) -> Vec<RowLink<N>> {
    let mut links: Vec<(RowLink<N>, [bool; LANES])> = Vec::new();
    let reach = offsets[N - 1].max(1) as usize;
    for column in 0..grid.column_count {
        let Some(partners) = partner_columns(grid, column, offsets) else {
            continue;
        };
        let slots = partners.map(|partner| layout.slots[partner as usize]);
        let lane = slots[0].1;
        let groups = slots.map(|(group, _)| group);
        let shifts =
            slots.map(|(_, partner)| (partner + narrow_u8(LANES) - lane) % narrow_u8(LANES));
        let lane = usize::from(lane);
        let home = links.iter_mut().find(|(link, lanes)| {
            link.groups == groups
                && link.shifts == shifts
                && lanes_are_free(&link.groups, &link.shifts, lanes, lane)
        });
        match home {
            Some((_, lanes)) => lanes[lane] = true,
            None => {
                let mut lanes = [false; LANES];
                lanes[lane] = true;
                links.push((
                    RowLink {
                        groups,
                        shifts,
                        mask: None,
                        list_is_apart: false,
                    },
                    lanes,
                ));
            }
        }
    }
    let period = reach + 1;
    let mut links: Vec<_> = links
        .into_iter()
        .map(|(mut link, lanes)| {
            if lanes != [true; LANES] {
                link.mask = Some(Box::new(Scalars(
                    lanes.map(|used| f32::from(u8::from(used))),
                )));
            }
            link
        })
        .collect();
    let list_is_apart = links.iter().all(RowLink::has_own_groups);
    for link in &mut links {
        link.list_is_apart = list_is_apart;
    }
    links.sort_by_key(|link| (usize::from(link.groups[0]) % period, link.groups[0]));
    links
}

fn partner_columns<const N: usize>(
    grid: &Grid,
    column: u32,
    offsets: [u32; N],
) -> Option<[u32; N]> {
    let mut partners = [column; N];
    for (partner, offset) in partners.iter_mut().zip(offsets) {
        if grid.topology == Topology::Tube && offset >= grid.column_count {
            return None;
        }
        *partner = grid.column_right(column, offset)?;
    }
    Some(partners)
}

/// Whether `lane` can join `lanes` without two relations touching one particle: only possible
/// where partners share a group.
fn lanes_are_free<const N: usize>(
    groups: &[u16; N],
    shifts: &[u8; N],
    lanes: &[bool; LANES],
    lane: usize,
) -> bool {
    for first in 0..N {
        for second in 0..N {
            if first == second || groups[first] != groups[second] {
                continue;
            }
            let particle_lane = (lane + usize::from(shifts[first])) % LANES;
            let owner = (particle_lane + LANES - usize::from(shifts[second])) % LANES;
            if lanes[owner] || owner == lane {
                return false;
            }
        }
    }
    true
}

/// An index or a count of particles, patches, rows or cells, as the engine keeps it.
#[expect(
    clippy::cast_possible_truncation,
    reason = "a cloth has fewer than 2^32 of each"
)]
pub(crate) const fn narrow(value: usize) -> u32 {
    value as u32
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "a row holds fewer than 65,536 × 16 columns"
)]
const fn narrow_u16(value: usize) -> u16 {
    value as u16
}

#[expect(clippy::cast_possible_truncation, reason = "a lane is below 16")]
const fn narrow_u8(value: usize) -> u8 {
    value as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid(column_count: u32, topology: Topology) -> Grid {
        Grid {
            column_count,
            row_count: 3,
            topology,
            spacing: [0.01, 0.01],
            flounce: None,
            crimp: None,
        }
    }

    #[test]
    fn links_name_every_pair_of_columns_once() {
        for topology in [Topology::Sheet, Topology::Tube] {
            for column_count in [3, 7, 16, 17, 31, 33, 50, 64, 100] {
                for stride in [1, 2, 4] {
                    check_pairs(&grid(column_count, topology), stride);
                }
            }
        }
    }

    fn check_pairs(grid: &Grid, stride: u32) {
        let layout = Layout::new(grid);
        let column_at = |group: u16, lane: usize| {
            layout
                .slots
                .iter()
                .position(|&slot| slot == (group, narrow_u8(lane)))
        };
        let mut found = Vec::new();
        for link in row_links(grid, &layout, [0, stride]) {
            let mut touched = Vec::new();
            for lane in 0..LANES {
                if link.mask.as_ref().is_some_and(|mask| mask.0[lane] < 0.5) {
                    continue;
                }
                let other = (lane + usize::from(link.shifts[1])) % LANES;
                touched.extend([(link.groups[0], lane), (link.groups[1], other)]);
                found.push((
                    column_at(link.groups[0], lane).expect("column"),
                    column_at(link.groups[1], other).expect("column"),
                ));
            }
            let count = touched.len();
            touched.sort_unstable();
            touched.dedup();
            assert_eq!(
                touched.len(),
                count,
                "two relations of one vector share a particle"
            );
        }
        found.sort_unstable();
        let expected: Vec<_> = (0..grid.column_count)
            .filter(|_| stride < grid.column_count)
            .filter_map(|c| Some((c as usize, grid.column_right(c, stride)? as usize)))
            .collect();
        assert_eq!(found, expected);
    }

    #[test]
    fn points_survive_the_layout() {
        let grid = grid(37, Topology::Tube);
        let layout = Layout::new(&grid);
        let points: Vec<_> = (0..37 * 3).map(|i| Vec3::splat(i as f32)).collect();
        let mut vectors = vec![Points::default(); layout.vector_count()];
        layout.scatter_points(&points, &mut vectors);
        let mut back = Vec::new();
        layout.gather_points(&vectors, &mut back);
        assert_eq!(back, points);
    }
}
