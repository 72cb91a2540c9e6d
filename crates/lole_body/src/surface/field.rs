//! The body as a signed field: the hard minimum of tubes and head, sampled on a lattice.
//!
//! Every tube is an inner subset of the body, so the union needs no smooth minimum, which would
//! swell where skins coincide. Only the left half (`x >= 0`) is sampled.

use std::f32::consts::TAU;

use glam::Vec3;
use lole_geom::triangle_grid::TriangleGrid;
use lole_geom::trig;
use rayon::prelude::*;

use super::pchip::{resample_periodic, resample_rows};
use crate::sections::{HeadTable, Ring, Sections, Tube, TubeTable};

/// Field far from every tube [m]: farther than any cell of the lattice.
pub(crate) const FAR: f32 = 0.05;
/// Distance of upsampled rings [m].
const RING_STEP: f32 = 0.006;
/// Radii of an upsampled ring.
const AROUND: usize = 96;
/// Heights of the rings of a rounded end, as shares of its length.
const DOME: [f32; 6] = [0.35, 0.6, 0.8, 0.92, 0.98, 1.0];
/// The lowest latitude of the head table [°].
const LOWEST_LATITUDE: f32 = -75.0;
/// Step [°] in which a surface is asked how far it reaches, and cells [m] its triangles are sorted into.
const SURFACE_STEP: f32 = 1.5;
/// How far out of what is known, and into it, the surface is looked for [m].
const SURFACE_OUT: f32 = 0.02;
const SURFACE_IN: f32 = 0.03;
const SURFACE_CELL: f32 = 0.012;
/// Points nearer to the mirror plane than this share of the lattice step are sampled there: legs
/// are cut flat at the plane, where their field is zero from both sides.
const OFF_PLANE: f32 = 0.5;

/// The body's field, ready to be sampled.
pub(crate) struct Field {
    tubes: Vec<Solid>,
    head: Head,
}

struct Solid {
    tube: Tube,
    stations: Vec<Station>,
}

struct Station {
    center: Vec3,
    axis: Vec3,
    across: Vec3,
    up: Vec3,
    radii: Vec<f32>,
    /// Least and largest radius.
    least: f32,
    reach: f32,
}

/// Samples on a lattice: `x` slices of `y` rows of `z`.
pub(crate) struct Lattice {
    pub(crate) origin: Vec3,
    pub(crate) step: f32,
    pub(crate) size: [usize; 3],
    pub(crate) values: Vec<f32>,
    /// The tube that is deepest at each sample.
    pub(crate) labels: Vec<Tube>,
    /// Whether a row of `z` has a sample inside.
    pub(crate) is_row_inside: Vec<bool>,
}

impl Lattice {
    pub(crate) const fn index(&self, x: usize, y: usize, z: usize) -> usize {
        (x * self.size[1] + y) * self.size[2] + z
    }

    pub(crate) fn point(&self, x: usize, y: usize, z: usize) -> Vec3 {
        self.origin + Vec3::new(x as f32, y as f32, z as f32) * self.step
    }
}

impl Field {
    pub(crate) fn new(body: &Sections) -> Self {
        Self {
            tubes: body.tubes.iter().map(Solid::new).collect(),
            head: Head::new(&body.head),
        }
    }

    /// The head alone, for hair and face.
    pub(crate) const fn head(&self) -> &Head {
        &self.head
    }

    /// Samples the left half at `step` [m].
    pub(crate) fn sample(&self, step: f32) -> Lattice {
        let (low, high) = self.bounds();
        let margin = Vec3::splat(3.0 * step);
        let origin = Vec3::new(0.0, low.y, low.z) - margin * Vec3::new(0.0, 1.0, 1.0);
        let cells = ((high + margin - origin) / step).ceil();
        #[expect(
            clippy::cast_possible_truncation,
            reason = "a body spans hundreds of cells"
        )]
        let size = cells.to_array().map(|count| count as usize + 1);
        let slice = size[1] * size[2];
        let mut lattice = Lattice {
            origin,
            step,
            size,
            values: vec![FAR; size[0] * slice],
            labels: vec![Tube::Torso; size[0] * slice],
            is_row_inside: vec![false; size[0] * size[1]],
        };
        let values = lattice.values.par_chunks_mut(slice);
        let labels = lattice.labels.par_chunks_mut(slice);
        let rows = lattice.is_row_inside.par_chunks_mut(size[1]);
        let frame = LatticeFrame { origin, step, size };
        values
            .zip(labels)
            .zip(rows)
            .enumerate()
            .for_each(|(x, ((values, labels), rows))| {
                let mut slice = Slice {
                    frame: &frame,
                    x: (x as f32 * step).max(OFF_PLANE * step),
                    values,
                    labels,
                };
                for solid in &self.tubes {
                    solid.fill(&mut slice);
                }
                self.head.fill(&mut slice);
                for (row, values) in rows.iter_mut().zip(slice.values.chunks(size[2])) {
                    *row = values.iter().any(|&value| value < 0.0);
                }
            });
        lattice
    }

    fn bounds(&self) -> (Vec3, Vec3) {
        let reach = Vec3::splat(self.head.reach);
        let mut low = self.head.center - reach;
        let mut high = self.head.center + reach;
        for station in self.tubes.iter().flat_map(|solid| &solid.stations) {
            let (station_low, station_high) = station.disc(0.0);
            low = low.min(station_low);
            high = high.max(station_high);
        }
        // Nothing lies under the floor.
        low.y = low.y.max(0.0);
        (low, high)
    }
}

struct LatticeFrame {
    origin: Vec3,
    step: f32,
    size: [usize; 3],
}

/// One `x` slice of the lattice being filled.
struct Slice<'a> {
    frame: &'a LatticeFrame,
    x: f32,
    values: &'a mut [f32],
    labels: &'a mut [Tube],
}

impl Slice<'_> {
    /// Lowers the samples in a box to `field`, where that is lower. Of the row through a point only
    /// what lies between the two `z` of `within`, give or take a sample, is looked at.
    fn lower(
        &mut self,
        [low, high]: [Vec3; 2],
        tube: Tube,
        within: impl Fn(Vec3) -> [f32; 2],
        field: impl Fn(Vec3) -> Option<f32>,
    ) {
        if self.x < low.x || self.x > high.x {
            return;
        }
        let LatticeFrame { origin, step, size } = *self.frame;
        let range = |low: f32, high: f32, origin: f32, size: usize| {
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "clamped to the lattice first"
            )]
            let index = |x: f32| x.clamp(0.0, size as f32) as usize;
            index(((low - origin) / step).floor())..index(((high - origin) / step).ceil() + 1.0)
        };
        for y in range(low.y, high.y, origin.y, size[1]) {
            let height = origin.y + y as f32 * step;
            let [from, to] = within(Vec3::new(self.x, height, 0.0));
            let [from, to] = [low.z.max(from - step), high.z.min(to + step)];
            if to < from {
                continue;
            }
            for z in range(from, to, origin.z, size[2]) {
                let point = Vec3::new(self.x, height, origin.z + z as f32 * step);
                let index = y * size[2] + z;
                if let Some(value) = field(point).filter(|value| *value < self.values[index]) {
                    self.values[index] = value;
                    self.labels[index] = tube;
                }
            }
        }
    }
}

impl Solid {
    /// Upsamples the rings to a fixed distance and adds rounded ends.
    fn new(table: &TubeTable) -> Self {
        let mut along = vec![0.0_f32];
        for pair in table.rings.windows(2) {
            let gap = (pair[1].center - pair[0].center).length().max(1.0e-4);
            along.push(along[along.len() - 1] + gap);
        }
        let mut at = vec![0.0];
        for pair in along.windows(2) {
            let pieces = ((pair[1] - pair[0]) / RING_STEP).ceil().max(1.0);
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "a ring gap holds few steps"
            )]
            let pieces = pieces as usize;
            for piece in 1..=pieces {
                at.push(pair[0] + (pair[1] - pair[0]) * piece as f32 / pieces as f32);
            }
        }
        let rows: Vec<Vec<f32>> = table.rings.iter().map(ring_row).collect();
        let mut rings: Vec<Ring> = (resample_rows(&along, &rows, &at).into_iter())
            .map(|row| row_ring(&row))
            .collect();
        let [start, end] = table.caps;
        if end > 0.0 {
            let last = rings[rings.len() - 1].clone();
            rings.extend(DOME.map(|share| dome_ring(&last, share, end)));
        }
        if start > 0.0 {
            let first = rings[0].clone();
            let mut dome: Vec<Ring> = DOME.map(|share| dome_ring(&first, share, -start)).to_vec();
            dome.reverse();
            dome.extend(rings);
            rings = dome;
        }
        Self {
            tube: table.tube,
            stations: rings.into_iter().map(Station::new).collect(),
        }
    }

    /// Distance across the axis between each two rings, within the slab they bound.
    fn fill(&self, slice: &mut Slice<'_>) {
        for pair in self.stations.windows(2) {
            let [a, b] = pair else { continue };
            let reach = Vec3::splat(a.reach.max(b.reach) + 2.0 * slice.frame.step);
            let low = a.center.min(b.center) - reach;
            let high = a.center.max(b.center) + reach;
            // A ring is flat: along its own axis it reaches nowhere.
            let near = tighten(low, high, a, b);
            let steps = slice.frame.step;
            slice.lower(
                near,
                self.tube,
                |row| slab(a, b, row),
                |point| between(a, b, point, steps),
            );
        }
    }
}

/// Shrinks the box of two rings to the discs they span plus two lattice steps.
fn tighten(low: Vec3, high: Vec3, a: &Station, b: &Station) -> [Vec3; 2] {
    const MARGIN: f32 = 0.009;
    let ((low_a, high_a), (low_b, high_b)) = (a.disc(MARGIN), b.disc(MARGIN));
    [low.max(low_a.min(low_b)), high.min(high_a.max(high_b))]
}

/// Where a row of `z` through a point lies between two rings: from and to, empty if turned round.
fn slab(a: &Station, b: &Station, row: Vec3) -> [f32; 2] {
    const LEVEL: f32 = 1.0e-4;
    let mut within = [f32::NEG_INFINITY, f32::INFINITY];
    for (center, inward) in [(a.center, a.axis), (b.center, -b.axis)] {
        let depth = (row - center).dot(inward);
        if inward.z > LEVEL {
            within[0] = within[0].max(-depth / inward.z);
        } else if inward.z < -LEVEL {
            within[1] = within[1].min(-depth / inward.z);
        } else if depth < -LEVEL {
            return [1.0, -1.0];
        }
    }
    within
}

/// Lattice steps from the skin beyond which only the sign of the field counts.
const CLEAR: f32 = 4.0;

/// Field between two rings, or nothing outside their slab. Clear of the skin by many a `step` it
/// only has the right sign.
fn between(a: &Station, b: &Station, point: Vec3, step: f32) -> Option<f32> {
    let from_a = point - a.center;
    let s0 = from_a.dot(a.axis);
    let s1 = (point - b.center).dot(b.axis);
    if s0 < 0.0 || s1 >= 0.0 {
        return None;
    }
    let t = s0 / (s0 - s1);
    let offset = from_a - (b.center - a.center) * t;
    let u = offset.dot(a.across + (b.across - a.across) * t);
    let v = offset.dot(a.up + (b.up - a.up) * t);
    let distance = (u * u + v * v).sqrt();
    if distance > a.reach.max(b.reach) + CLEAR * step {
        return None;
    }
    let depth = distance - a.least.min(b.least);
    if depth < -CLEAR * step {
        return Some(depth);
    }
    let turn = trig::atan2(v, u) / TAU;
    let slot = (turn - turn.floor()) * AROUND as f32;
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a fraction of a turn times the number of radii"
    )]
    let first = slot as usize % AROUND;
    let second = (first + 1) % AROUND;
    let share = slot - slot.floor();
    let radius_a = a.radii[first] + (a.radii[second] - a.radii[first]) * share;
    let radius_b = b.radii[first] + (b.radii[second] - b.radii[first]) * share;
    Some(distance - (radius_a + (radius_b - radius_a) * t))
}

impl Station {
    fn new(ring: Ring) -> Self {
        let axis = ring.axis.normalize_or_zero();
        let across = (ring.across - axis * axis.dot(ring.across)).normalize_or_zero();
        Self {
            center: ring.center,
            axis,
            across,
            up: axis.cross(across),
            least: ring.radii.iter().copied().fold(f32::INFINITY, f32::min),
            reach: ring.radii.iter().copied().fold(0.0, f32::max),
            radii: ring.radii,
        }
    }

    /// Box of the flat disc that the ring spans, `margin` wider.
    fn disc(&self, margin: f32) -> (Vec3, Vec3) {
        let share = Vec3::ONE - self.axis * self.axis;
        let reach = (self.reach + margin)
            * Vec3::new(
                share.x.max(0.0).sqrt(),
                share.y.max(0.0).sqrt(),
                share.z.max(0.0).sqrt(),
            );
        (self.center - reach, self.center + reach)
    }
}

fn ring_row(ring: &Ring) -> Vec<f32> {
    let mut row = Vec::with_capacity(9 + AROUND);
    for vector in [ring.center, ring.axis, ring.across] {
        row.extend(vector.to_array());
    }
    row.extend(resample_periodic(&ring.radii, AROUND));
    row
}

fn row_ring(row: &[f32]) -> Ring {
    let vector = |start: usize| Vec3::new(row[start], row[start + 1], row[start + 2]);
    Ring {
        center: vector(0),
        axis: vector(3),
        across: vector(6),
        radii: row[9..].to_vec(),
    }
}

/// The ring of an elliptic dome of `length` [m] (negative: backwards) at a `share` of it.
fn dome_ring(end: &Ring, share: f32, length: f32) -> Ring {
    let shrink = (1.0 - share * share).max(1.0e-5).sqrt();
    Ring {
        center: end.center + end.axis * (share * length),
        radii: end.radii.iter().map(|radius| radius * shrink).collect(),
        ..end.clone()
    }
}

/// The head: radii on a grid of one degree.
pub(crate) struct Head {
    pub(crate) center: Vec3,
    /// `[longitude][latitude]`, longitude 0..=180°, latitude -75..=90°.
    radii: Vec<Vec<f32>>,
    /// Least and largest radius.
    least: f32,
    reach: f32,
}

impl Head {
    fn new(table: &HeadTable) -> Self {
        let radii = merge_face(table);
        let all = || radii.iter().flatten().copied();
        Self {
            center: table.center,
            least: all().fold(f32::INFINITY, f32::min),
            reach: all().fold(0.0, f32::max),
            radii,
        }
    }

    /// The same directions from a `center`, as far as a surface reaches there; where it is open, as far as around
    /// the opening.
    pub(crate) fn on(&self, center: Vec3, (positions, triangles): (&[Vec3], &[[u32; 3]])) -> Self {
        let grid = TriangleGrid::new(positions, triangles, SURFACE_CELL);
        let radius = |longitude: f32, latitude: f32| {
            let (sin, cos) = trig::sin_cos(longitude.to_radians());
            let (up, level) = trig::sin_cos(latitude.to_radians());
            let towards = Vec3::new(sin * level, up, cos * level);
            let known = self.radius(longitude, latitude);
            // From outside, and not from inside: behind the lids lies more of the surface.
            let [far, near] = [known + SURFACE_OUT, known - SURFACE_IN];
            let met = grid.first_crossing(center + towards * far, center + towards * near);
            met.map_or(f32::NAN, |share| far + (near - far) * share)
        };
        let step = SURFACE_STEP;
        let [longitude_count, latitude_count] = [180.0, 90.0 - LOWEST_LATITUDE].map(|range| {
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "some hundreds"
            )]
            let count = (range / step) as usize + 1;
            count
        });
        let rows = (0..longitude_count).into_par_iter().map(|longitude| {
            // A hair's breadth off the mirror plane, where the half surface ends.
            let longitude = (longitude as f32 * step).clamp(0.1, 179.9);
            (0..latitude_count)
                .map(|latitude| radius(longitude, LOWEST_LATITUDE + latitude as f32 * step))
                .collect()
        });
        let mut rows: Vec<Vec<f32>> = rows.collect();
        close(&mut rows, 0.5 * (self.least + self.reach));
        let longitudes: Vec<f32> = (0..=180).map(|degree| degree as f32).collect();
        let latitudes: Vec<f32> = (-75..=90).map(|degree| degree as f32).collect();
        let radii = resample_grid(
            &rows,
            [step, LOWEST_LATITUDE, step],
            &longitudes,
            &latitudes,
        );
        let all = || radii.iter().flatten().copied();
        Self {
            center,
            least: all().fold(f32::INFINITY, f32::min),
            reach: all().fold(0.0, f32::max),
            radii,
        }
    }

    fn fill(&self, slice: &mut Slice<'_>) {
        let step = slice.frame.step;
        let reach = Vec3::splat(self.reach + 2.0 * step);
        slice.lower(
            [self.center - reach, self.center + reach],
            Tube::Head,
            |_| [f32::NEG_INFINITY, f32::INFINITY],
            |point| {
                let offset = point - self.center;
                let distance = offset.length();
                let depth = distance - self.least;
                if depth < -CLEAR * step || distance > self.reach + CLEAR * step {
                    return Some(depth);
                }
                let latitude = trig::asin(offset.y / (distance + 1.0e-9)).to_degrees();
                let longitude = trig::atan2(offset.x.abs(), offset.z).to_degrees();
                Some(distance - self.radius(longitude, latitude))
            },
        );
    }

    /// Radius [m] at a longitude from the front and a latitude [°]; below the table its last row.
    pub(crate) fn radius(&self, longitude: f32, latitude: f32) -> f32 {
        let x = longitude.abs().clamp(0.0, 180.0);
        let y = (latitude - LOWEST_LATITUDE).clamp(0.0, 90.0 - LOWEST_LATITUDE);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "clamped to the table"
        )]
        let (i, j) = ((x as usize).min(179), (y as usize).min(164));
        let (x, y) = (x - i as f32, y - j as f32);
        let low = self.radii[i][j] + (self.radii[i + 1][j] - self.radii[i][j]) * x;
        let high = self.radii[i][j + 1] + (self.radii[i + 1][j + 1] - self.radii[i][j + 1]) * x;
        low + (high - low) * y
    }
}

/// Gives what is not a number the mean of what is around it, from its rim inwards.
fn close(rows: &mut [Vec<f32>], otherwise: f32) {
    loop {
        let mut found = Vec::new();
        let mut left = false;
        for (row, values) in rows.iter().enumerate() {
            for (column, _) in values
                .iter()
                .enumerate()
                .filter(|(_, value)| value.is_nan())
            {
                let beside = [row.wrapping_sub(1), row + 1].map(|row| rows.get(row)?.get(column));
                let along = [column.wrapping_sub(1), column + 1].map(|column| values.get(column));
                let around = beside.into_iter().chain(along).flatten();
                let around: Vec<f32> = around.copied().filter(|value| !value.is_nan()).collect();
                if around.is_empty() {
                    left = true;
                } else {
                    let mean = around.iter().sum::<f32>() / around.len() as f32;
                    found.push(([row, column], mean));
                }
            }
        }
        let is_stuck = found.is_empty();
        for ([row, column], mean) in found {
            rows[row][column] = mean;
        }
        if is_stuck && left {
            // Nothing at all was met.
            for value in rows.iter_mut().flatten().filter(|value| value.is_nan()) {
                *value = otherwise;
            }
        }
        if !left || is_stuck {
            return;
        }
    }
}

/// Merges the coarse table and the finer face, blended over 8°, on a grid of one degree.
fn merge_face(table: &HeadTable) -> Vec<Vec<f32>> {
    const BLEND: f32 = 8.0;
    let longitudes: Vec<f32> = (0..=180).map(|degree| degree as f32).collect();
    let latitudes: Vec<f32> = (-75..=90).map(|degree| degree as f32).collect();
    let coarse = resample_grid(&table.radii, [3.0, -75.0, 3.0], &longitudes, &latitudes);
    let face = resample_grid(&table.face, [1.5, -48.0, 1.5], &longitudes, &latitudes);
    let last_longitude = (table.face.len() - 1) as f32 * 1.5;
    let top = -48.0 + (table.face[0].len() - 1) as f32 * 1.5;
    let ramp = |degrees: f32| {
        let x = (degrees / BLEND).clamp(0.0, 1.0);
        x * x * (3.0 - 2.0 * x)
    };
    (longitudes.iter().enumerate())
        .map(|(i, &longitude)| {
            (latitudes.iter().enumerate())
                .map(|(j, &latitude)| {
                    let inside = (last_longitude - longitude)
                        .min(latitude + 48.0)
                        .min(top - latitude);
                    coarse[i][j] + (face[i][j] - coarse[i][j]) * ramp(inside)
                })
                .collect()
        })
        .collect()
}

/// Resamples `rows[longitude][latitude]` with spacing `[d_lon, lat_0, d_lat]`; even in longitude.
fn resample_grid(
    rows: &[Vec<f32>],
    [lon_step, lat_0, lat_step]: [f32; 3],
    longitudes: &[f32],
    latitudes: &[f32],
) -> Vec<Vec<f32>> {
    // Three mirrored rows before the front make the curve even there.
    let mut padded: Vec<Vec<f32>> = (1..4).rev().map(|index| rows[index].clone()).collect();
    padded.extend(rows.iter().cloned());
    let abscissas: Vec<f32> = (0..padded.len())
        .map(|index| (index as f32 - 3.0) * lon_step)
        .collect();
    let by_longitude = resample_rows(&abscissas, &padded, longitudes);
    (by_longitude.iter())
        .map(|row| {
            let knots: Vec<[f32; 2]> = (row.iter().enumerate())
                .map(|(index, &radius)| [lat_0 + index as f32 * lat_step, radius])
                .collect();
            let curve = super::pchip::Pchip::new(&knots);
            latitudes
                .iter()
                .map(|&latitude| curve.at(latitude))
                .collect()
        })
        .collect()
}
