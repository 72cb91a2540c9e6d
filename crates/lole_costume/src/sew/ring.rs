//! Lays rows of gathered cloth around the body.

use glam::{Affine3A, Vec3};
use lole_body::{Bone, Dancer, TapePoint};
use lole_geom::trig;

use super::SewError;
use super::clothed::Clothed;
use super::fold_curve::{SHARPEST, direction};
use super::profile::{self, Profile};

/// Points of a tape that rows are laid along.
const RING_POINTS: usize = 720;
/// Halvings of the search for the sharpness of a fold.
const SEARCH_STEPS: u32 = 24;

/// Part of a ring over which its local scale is measured.
const SCALE_STEP: f32 = 0.004;
/// Least angle [rad] from the vertical at which a skirt is held before it is let go: narrower, it
/// would rub along the hips on its way down; wider, it swings in and its folds fall flat.
const LEAST_FLARE: f32 = 0.14;
/// Widest angle [rad] at which a skirt is held.
const LARGEST_FLARE: f32 = 0.7;
/// Points of the ring that stand for the side on which skin lies: 5°.
const RING_STEP: usize = 10;
/// Skin less than this below the ring [m] is the band's: contact lifts cloth out of it gently.
const LEAST_BELOW: f32 = 0.06;
/// Room that is left between it and a skirt that is held [m].
const SKIN_MARGIN: f32 = 0.004;
/// Farthest that a skirt is opened, as a part of the cloth around it.
const WIDEST: f32 = 0.9;
/// Precision of the angle [rad].
const FLARE_STEP: f32 = 0.01;
/// Places down the skirt that must be clear.
const FLARE_SAMPLES: u32 = 24;
/// Depth [m] inside the body's capsules at which inner turns may start: contact lifts them out of
/// it gently, and right below the band no angle would be wide enough to stay outside.
const START_DEPTH: f32 = 0.005;
/// Points of the ring, on either side, over which the way out of the body turns evenly: 30°. A tape
/// runs straight between two bones of the hip and turns sharply over them; cloth around it does not.
const OUTWARD_BLUR: usize = 60;
/// The same for what hangs around somebody given: a quarter of the ring, so that the hem turns evenly.
const EVEN_BLUR: usize = 180;
/// Radius of the curve around which cloth comes to a wide angle [m]: a few times as much as folds are deep.
const TURN: f32 = 0.08;
/// Points of the ring, on either side, that share an angle: 20°.
const FLARE_BLUR: usize = 40;

/// A closed line around the body that the inner turns of a row touch.
#[derive(Clone)]
pub(super) struct Ring {
    points: Vec<TapePoint>,
    /// Its length [m].
    pub(super) girth: f32,
}

/// How a skirt is held open below its band, for every point of the ring it hangs from.
pub(super) struct Flare {
    /// Angles [rad] from the vertical.
    angles: Vec<f32>,
    /// Unit horizontal directions in which cloth goes around a curve to its angle; outward and at once
    /// where there are none.
    ways: Option<Vec<Vec3>>,
}

/// The gathers of every row, and how far apart their particles are.
#[derive(Debug, Clone, Copy)]
pub(super) struct Gathers<'a> {
    /// Distance of the inner turns outside the ring [m].
    pub(super) gap: f32,
    /// Cloth between two particles of a row [m].
    pub(super) spacing: f32,
    /// Particles of the row.
    pub(super) column_count: u32,
    /// Where each fold starts, as a fraction of the ring, ascending; every fold holds as many
    /// particles, but for one.
    pub(super) fold_starts: &'a [f32],
}

/// A place on a ring: fraction around it, and distance outside it [m].
type Place = (f32, f32);

/// A row that hangs on a ring.
#[derive(Clone, Copy)]
struct Hanging<'a> {
    ring: &'a Ring,
    flare: &'a Flare,
    /// Cloth between the ring and the row [m].
    below: f32,
}

impl Hanging<'_> {
    fn position(&self, (around, out): Place) -> Vec3 {
        let (a, b, fraction) = self.ring.neighbors(around);
        let [from, to] = [&self.ring.points[a], &self.ring.points[b]];
        let outward = from
            .outward
            .lerp(to.outward, fraction)
            .normalize_or(from.outward);
        let angles = &self.flare.angles;
        let angle = angles[a] + (angles[b] - angles[a]) * fraction;
        let on_ring = from.bind_position.lerp(to.bind_position, fraction);
        let Some(ways) = &self.flare.ways else {
            let (sin, cos) = trig::sin_cos(angle);
            return on_ring + outward * (out + self.below * sin) - Vec3::Y * (self.below * cos);
        };
        let way = ways[a].lerp(ways[b], fraction).normalize_or(ways[a]);
        // Around a curve first, then straight on; folds stand upright on that way, and turn with it from
        // where they point at the ring.
        let turned = (self.below / TURN).min(angle);
        let (sin, cos) = trig::sin_cos(turned);
        let straight = self.below - TURN * turned;
        let across = TURN * (1.0 - cos) + straight * sin;
        let down = TURN * sin + straight * cos;
        let upright = outward.lerp(way, turned / angle).normalize_or(way);
        on_ring + way * across - Vec3::Y * down + (upright * cos + Vec3::Y * sin) * out
    }

    /// Meters per ring at a place: how far it is, there, once around.
    fn scale(&self, (around, out): Place) -> f32 {
        let [before, after] =
            [around - SCALE_STEP, around + SCALE_STEP].map(|around| self.position((around, out)));
        before.distance(after) / (2.0 * SCALE_STEP)
    }

    /// Places of the `count` particles of a fold whose links fill the ring between `ends`.
    fn fold(&self, gathers: Gathers<'_>, ends: [f32; 2], count: usize) -> Vec<Place> {
        let (mut low, mut high) = (0.0, SHARPEST);
        for _ in 0..SEARCH_STEPS {
            // Halves of the logarithm, nearly: sharpness spans three decades.
            let sharpness = ((1.0 + low) * (1.0_f32 + high)).sqrt() - 1.0;
            if self.chain(gathers, ends[0], (sharpness, count)).1 < ends[1] {
                high = sharpness;
            } else {
                low = sharpness;
            }
        }
        self.chain(gathers, ends[0], (low, count)).0
    }

    /// A chain of `count` links from `start`: its particles, and where on the ring it ends.
    fn chain(
        &self,
        gathers: Gathers<'_>,
        start: f32,
        (sharpness, count): (f32, usize),
    ) -> (Vec<Place>, f32) {
        let mut place = (start, gathers.gap);
        let mut places = Vec::with_capacity(count);
        for index in 0..count {
            places.push(place);
            let (sin, cos) = trig::sin_cos(direction(sharpness, index, count));
            let rise = gathers.spacing * sin;
            let scale = self.scale((place.0, place.1 + 0.5 * rise));
            place = (place.0 + gathers.spacing * cos / scale, place.1 + rise);
        }
        (places, place.0)
    }
}

impl Flare {
    /// Straight down.
    pub(super) fn none() -> Self {
        Self {
            angles: vec![0.0; RING_POINTS],
            ways: None,
        }
    }

    /// The same angle [rad] all around a ring of whatever shape, and as far to every side: what hangs from
    /// a corner has no wider a place at the hem than what hangs from a straight side.
    fn even(ring: &Ring, angle: f32) -> Self {
        let outward: Vec<Vec3> = ring.points.iter().map(|point| point.outward).collect();
        let ways = blurred(&outward, EVEN_BLUR).into_iter().zip(outward);
        Self {
            angles: vec![angle; RING_POINTS],
            ways: Some(
                ways.map(|(way, outward)| way.normalize_or(outward))
                    .collect(),
            ),
        }
    }

    /// The least that keeps `length` [m] of cloth, hung `gap` [m] outside `ring`, outside what the
    /// dancer's `stance` and what she wears puts in its way, but never less than [`LEAST_FLARE`]; it changes slowly
    /// around the ring.
    pub(super) fn around(
        ring: &Ring,
        (dancer, clothed): (&Dancer, &Clothed),
        stance: &[Affine3A],
        [gap, length]: [f32; 2],
        flat_length: f32,
    ) -> Self {
        let capsules = dancer.posed_capsules(stance);
        let clear = |point: &TapePoint, angle: f32| {
            let (sin, cos) = trig::sin_cos(angle);
            (1..=FLARE_SAMPLES).all(|sample| {
                let below = length * sample as f32 / FLARE_SAMPLES as f32;
                let place = TapePoint {
                    bind_position: point.bind_position + point.outward * (gap + below * sin)
                        - Vec3::Y * (below * cos),
                    ..*point
                };
                let posed = place.posed(stance);
                let is_outside = capsules
                    .iter()
                    .all(|capsule| -START_DEPTH < capsule.signed_distance(posed));
                is_outside && 0.0 < clothed.clearance(place.bind_position)
            })
        };
        let least = |point: &TapePoint| {
            let mut angle = LEAST_FLARE;
            while angle < LARGEST_FLARE && !clear(point, angle) {
                angle += FLARE_STEP;
            }
            angle
        };
        let mut least: Vec<f32> = ring.points.iter().map(least).collect();
        if dancer.skin.is_given() {
            // What somebody wears already stands out of the capsules.
            let needed = angles_over_skin(ring, dancer, stance, [gap, length]);
            for (least, needed) in least.iter_mut().zip(needed) {
                *least = least.max(needed.min(LARGEST_FLARE));
            }
            // No wider than there is cloth around the hem.
            let radius = (WIDEST * flat_length - ring.girth) / std::f32::consts::TAU;
            let widest = trig::asin((radius / length).clamp(0.0, 1.0)).max(LEAST_FLARE);
            // The same all around: where angles differ much, columns slant and are too long.
            let angle = least.iter().copied().fold(0.0, f32::max).min(widest);
            return Self::even(ring, angle);
        }
        let widest: Vec<f32> = (0..RING_POINTS)
            .map(|index| {
                let near = around(index, RING_POINTS, FLARE_BLUR);
                near.map(|other| least[other]).fold(0.0, f32::max)
            })
            .collect();
        Self {
            angles: blurred(&widest, FLARE_BLUR),
            ways: None,
        }
    }
}

/// By point of a ring, the angle [rad] at which `length` [m] of cloth, hung `gap` [m] outside of it,
/// clears the skin in a stance; arms hang outside of it.
fn angles_over_skin(
    ring: &Ring,
    dancer: &Dancer,
    stance: &[Affine3A],
    [gap, length]: [f32; 2],
) -> Vec<f32> {
    let (mut positions, mut normals) = (Vec::new(), Vec::new());
    dancer.skin.pose(stance, &mut positions, &mut normals);
    let posed: Vec<[Vec3; 2]> = (ring.points.iter())
        .map(|point| {
            let outward = point.posed_outward(stance).with_y(0.0);
            [point.posed(stance), outward.normalize_or_zero()]
        })
        .collect();
    let axis = posed.iter().map(|[place, _]| *place).sum::<Vec3>() / posed.len().max(1) as f32;
    let mut angles = vec![0.0_f32; posed.len()];
    for vertex in dancer.trunk_vertices() {
        let place = positions[vertex as usize];
        let from_axis = (place - axis).with_y(0.0);
        // The point of the ring on the same side.
        let along = |[at, _]: &[Vec3; 2]| {
            let way = (*at - axis).with_y(0.0);
            way.dot(from_axis) / way.length().max(f32::MIN_POSITIVE)
        };
        let nearest = (0..posed.len()).step_by(RING_STEP);
        let nearest = nearest.max_by(|&a, &b| along(&posed[a]).total_cmp(&along(&posed[b])));
        let Some(nearest) = nearest else { continue };
        let [from, outward] = posed[nearest];
        let below = from.y - place.y;
        if !(LEAST_BELOW..length + SKIN_MARGIN).contains(&below) {
            continue;
        }
        let out = (place - from).dot(outward) - gap + SKIN_MARGIN;
        for near in around(nearest, posed.len(), RING_STEP / 2 + 1) {
            angles[near] = angles[near].max(trig::atan2(out, below));
        }
    }
    angles
}

/// The indices up to `reach` from `index` on a closed line of `count` points.
fn around(index: usize, count: usize, reach: usize) -> impl Iterator<Item = usize> {
    (0..=2 * reach).map(move |step| (index + 2 * count + step - reach) % count)
}

/// Every value of a closed line as the mean of those up to `reach` points away.
fn blurred<T>(values: &[T], reach: usize) -> Vec<T>
where
    T: Copy + std::iter::Sum + std::ops::Div<f32, Output = T>,
{
    let mean = |index: usize| {
        let sum: T = around(index, values.len(), reach)
            .map(|other| values[other])
            .sum();
        sum / (2 * reach + 1) as f32
    };
    (0..values.len()).map(mean).collect()
}

impl Ring {
    /// The tape at `height` [m] of the bind pose.
    pub(super) fn at(dancer: &Dancer, height: f32) -> Result<Self, SewError> {
        let points = dancer.tape_ring(height, RING_POINTS);
        if points.is_empty() {
            return Err(SewError::NoSection {
                height_cm: f64::from(height) * 100.0,
            });
        }
        Ok(Self::of(points))
    }

    /// A line through points that lie on it evenly.
    pub(super) fn of(mut points: Vec<TapePoint>) -> Self {
        let outward = blurred(
            &points.iter().map(|point| point.outward).collect::<Vec<_>>(),
            OUTWARD_BLUR,
        );
        for (point, outward) in points.iter_mut().zip(outward) {
            point.outward = outward.normalize_or(point.outward);
        }
        let next = points.iter().cycle().skip(1);
        let girth = points
            .iter()
            .zip(next)
            .map(|(a, b)| a.bind_position.distance(b.bind_position))
            .sum();
        Self { points, girth }
    }

    /// Its points, from the back middle over the left side.
    pub(super) fn points(&self) -> &[TapePoint] {
        &self.points
    }

    /// Lets all of it go with one bone.
    pub(super) fn be_carried_by(&mut self, bone: Bone) {
        for point in &mut self.points {
            point.joints = [u16::try_from(bone.index()).unwrap_or(0); 4];
            point.weights = [1.0, 0.0, 0.0, 0.0];
        }
    }

    /// Gap [m] at which inner turns lie outside of all that is worn; less than nothing, or negative
    /// infinity, where nothing is in the way.
    pub(super) fn gap_over(&self, clothed: &Clothed) -> f32 {
        let gap = |point: &TapePoint| -clothed.clearance(point.bind_position);
        self.points
            .iter()
            .map(gap)
            .fold(f32::NEG_INFINITY, f32::max)
    }

    /// `count` rings above `height`, from the tape there, each `spacing` [m] further up, measured
    /// `reach` [m] outside the skin: at the sides, where the hips lean in, a row rises less than in
    /// front, and there the outer turns of the gathers are farther apart than the inner ones.
    pub(super) fn upward(
        profile: &Profile<'_>,
        height: f32,
        [spacing, reach]: [f32; 2],
        count: u32,
    ) -> Result<Vec<Self>, SewError> {
        let mut below = profile.at(height)?;
        let mut rows = vec![Vec::with_capacity(RING_POINTS); count as usize];
        let mut climbed = vec![0.0_f32; RING_POINTS];
        let mut reached = vec![0_usize; RING_POINTS];
        let mut level = height;
        while reached.iter().any(|&row| row < count as usize) {
            level += profile::STEP;
            let above = profile.at(level)?;
            for index in 0..RING_POINTS {
                let (low, high) = (&below.points[index], &above.points[index]);
                let outer = |point: &TapePoint| point.bind_position + point.outward * reach;
                let inner = low.bind_position.distance(high.bind_position);
                let rise = inner.max(outer(low).distance(outer(high)));
                let missing = |row: usize| (row + 1) as f32 * spacing - climbed[index];
                while reached[index] < count as usize && missing(reached[index]) <= rise {
                    let share = missing(reached[index]) / rise;
                    rows[reached[index]].push((index, mix(low, high, share)));
                    reached[index] += 1;
                }
                climbed[index] += rise;
            }
            below = above;
        }
        let rings = rows.into_iter().map(|mut row| {
            row.sort_by_key(|&(index, _)| index);
            Self::of(row.into_iter().map(|(_, point)| point).collect())
        });
        Ok(rings.collect())
    }

    /// Lays one row, `below` [m] of cloth under the ring: every fold as deep as it takes to bring
    /// its share of the cloth onto its share of the ring, particles evenly along the cloth.
    pub(super) fn lay(
        &self,
        gathers: Gathers<'_>,
        flare: &Flare,
        below: f32,
        into: &mut Vec<TapePoint>,
    ) {
        let row = Hanging {
            ring: self,
            flare,
            below,
        };
        let starts = gathers.fold_starts;
        let columns = gathers.column_count as usize;
        for (index, &start) in starts.iter().enumerate() {
            let end = starts.get(index + 1).copied().unwrap_or(1.0 + starts[0]);
            let first = |fold: usize| fold * columns / starts.len();
            let count = first(index + 1) - first(index);
            for place in row.fold(gathers, [start, end], count) {
                let (a, b, fraction) = self.neighbors(place.0);
                // The nearest skin carries what is laid here.
                let nearest = if fraction < 0.5 { a } else { b };
                into.push(TapePoint {
                    bind_position: row.position(place),
                    ..self.points[nearest]
                });
            }
        }
    }

    /// Depth [m] of the deepest of the gathers laid on this ring.
    pub(super) fn depth_of(&self, gathers: Gathers<'_>) -> f32 {
        let flare = Flare::none();
        let row = Hanging {
            ring: self,
            flare: &flare,
            below: 0.0,
        };
        let starts = gathers.fold_starts;
        let columns = gathers.column_count as usize;
        (0..starts.len())
            .flat_map(|index| {
                let end = starts.get(index + 1).copied().unwrap_or(1.0 + starts[0]);
                let count = (index + 1) * columns / starts.len() - index * columns / starts.len();
                row.fold(gathers, [starts[index], end], count)
            })
            .map(|place| place.1)
            .fold(0.0, f32::max)
    }

    /// The points before and after a fraction around the ring, and how far between them it is.
    fn neighbors(&self, around: f32) -> (usize, usize, f32) {
        let place = (around - around.floor()) * self.points.len() as f32;
        let whole = place.floor();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "between 0 and the number of points"
        )]
        let index = whole as usize % self.points.len();
        let next = (index + 1) % self.points.len();
        (index, next, place - whole)
    }
}

/// The point a fraction of the way from `low` to `high`, carried by the nearer one's bones.
fn mix(low: &TapePoint, high: &TapePoint, fraction: f32) -> TapePoint {
    let carrier = if fraction < 0.5 { low } else { high };
    TapePoint {
        bind_position: low.bind_position.lerp(high.bind_position, fraction),
        outward: low
            .outward
            .lerp(high.outward, fraction)
            .normalize_or(low.outward),
        ..*carrier
    }
}
