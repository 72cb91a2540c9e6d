//! The body as a lei meets it: skin, raised to the cloth that lies over it.
//!
//! A string of flowers is five centimeters across and lies on the outside of folds. Cloth met vertex by
//! vertex, with the skin a few millimeters below it, pushes such a string now one way and now another,
//! and threw it about. Skin is smooth and moves without jumps, so where cloth lies over it, it is raised
//! to that; only cloth that hangs far from the skin is met by itself.

use std::sync::Arc;

use glam::Vec3;
use lole_geom::mesh::vertex_normals;
use lole_geom::{Surfel, TriangleGrid};
use rayon::iter::ParallelIterator as _;
use rayon::slice::ParallelSliceMut as _;

use super::order::Inner;

/// Skin is raised this far at most [m].
const REACH: f32 = 0.06;
/// Cloth farther from the skin than this as she stands hangs by itself [m].
const LOOSE: f32 = 0.05;
/// Skin this near is raised alike [m]: half of a flower.
const ALIKE: f32 = 0.025;
/// Cloth is looked for over surfels so far from each other [m]: some twenty of them are raised alike, and folds are
/// wider.
const STATION_GAP: f32 = 0.009;
/// Skin and cloth that face each other's way less than this cosine do not lie on each other.
const SAME_WAY: f32 = 0.3;
/// Only what is this near to a strand is looked at [m]: more than what it meets and what is alike.
const MARGIN: f32 = 0.12;
/// Cells of the search [m]: about two edges of the cloth.
const CELL: f32 = 0.03;

/// Frames in which every station is looked at once: cloth that lies under a string does not slide by a fold's
/// width in as many.
const TURNS: usize = 3;

/// Stations that a thread looks at together.
const TOGETHER: usize = 32;

/// A station, and what is found over it.
type Looked<'a> = (&'a u32, &'a mut (f32, Vec3));

/// How closely the cloth is looked at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Attention {
    /// Over all stations.
    Whole,
    /// Over those whose turn it is.
    InTurn,
}

/// What does not change from frame to frame, and room.
#[derive(Clone, Default)]
pub(super) struct OverCloth {
    /// Surfels of the skin over which cloth is looked for.
    stations: Arc<Vec<u32>>,
    /// Of every surfel of the skin, the places of the stations with which it is raised alike.
    alike: Arc<Vec<Vec<u32>>>,
    /// By garment, particles that hang far from the skin.
    loose: Arc<Vec<Vec<u32>>>,
    /// The box that was looked at last [m].
    looked: [Vec3; 2],
    /// How far each station is raised [m], and which way it faces then; and whose turn it is to be looked at.
    found: Vec<(f32, Vec3)>,
    turn: usize,
    /// The surfels in the box, how far they are raised [m], and which way they face then.
    raised: Vec<(u32, f32, Vec3)>,
    far: Vec<Surfel>,
}

/// Surfels by height, so that a slice of her is looked at and not all of her.
struct ByHeight<'a> {
    skin: &'a [Surfel],
    places: Vec<u32>,
}

impl<'a> ByHeight<'a> {
    fn new(skin: &'a [Surfel]) -> Self {
        let height = |place: u32| skin[place as usize].position.y;
        let mut places: Vec<u32> = (0..).take(skin.len()).collect();
        places.sort_by(|&a, &b| height(a).total_cmp(&height(b)));
        Self { skin, places }
    }

    fn around(&self, y: f32, reach: f32) -> impl Iterator<Item = u32> + '_ {
        let height = |place: u32| self.skin[place as usize].position.y;
        let below = |limit: f32| self.places.partition_point(|&place| height(place) < limit);
        let slice = below(y - reach)..below(y + reach);
        self.places[slice].iter().copied()
    }

    /// Those within `reach` [m] of a surfel that face its way, ascending.
    fn alike(&self, one: &Surfel, reach: f32) -> Vec<u32> {
        let is_alike = |&place: &u32| {
            let other = &self.skin[place as usize];
            one.position.distance_squared(other.position) < reach * reach
                && SAME_WAY < one.normal.dot(other.normal)
        };
        let mut alike: Vec<u32> = self
            .around(one.position.y, reach)
            .filter(is_alike)
            .collect();
        alike.sort_unstable();
        alike
    }
}

impl OverCloth {
    /// Looks at a dancer who stands in her garments.
    pub(super) fn new(skin: &[Surfel], cloth: &[Inner<'_>]) -> Self {
        let by_height = ByHeight::new(skin);
        let mut stations = Vec::new();
        // By surfel, its place among the stations.
        let mut station_of = vec![None; skin.len()];
        for (place, surfel) in (0..).zip(skin) {
            let alike = by_height.alike(surfel, STATION_GAP);
            if alike
                .iter()
                .all(|&other| station_of[other as usize].is_none())
            {
                station_of[place as usize] = u32::try_from(stations.len()).ok();
                stations.push(place);
            }
        }
        let alike = skin.iter().map(|surfel| {
            let alike = by_height.alike(surfel, ALIKE).into_iter();
            alike
                .filter_map(|other| station_of[other as usize])
                .collect()
        });
        let loose = cloth.iter().map(|(_, positions)| {
            let all = (0..).zip(*positions);
            let loose = all.filter(|(_, place)| {
                let apart = |one: u32| skin[one as usize].position.distance_squared(**place);
                (by_height.around(place.y, LOOSE)).all(|one| LOOSE * LOOSE < apart(one))
            });
            loose.map(|(particle, _)| particle).collect()
        });
        Self {
            alike: Arc::new(alike.collect()),
            loose: Arc::new(loose.collect()),
            stations: Arc::new(stations),
            ..Self::default()
        }
    }

    /// Whether a place is in the box that was looked at last.
    fn is_near(&self, place: Vec3) -> bool {
        let [low, high] = self.looked;
        place.cmpge(low).all() && place.cmple(high).all()
    }

    /// Finds how far the cloth raises the skin near the places of strands [m]: of every station, or of those whose
    /// turn it is, which is a look at each in [`TURNS`] frames.
    pub(super) fn look(
        &mut self,
        skin: &[Surfel],
        cloth: &[Inner<'_>],
        (strands, attention): (&[Vec3], Attention),
    ) {
        let start = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        let (low, high) = strands.iter().fold(start, |(low, high), &place| {
            (low.min(place), high.max(place))
        });
        self.looked = [low - MARGIN, high + MARGIN];
        let mut found = std::mem::take(&mut self.found);
        found.resize(self.stations.len(), (0.0, Vec3::ZERO));
        let looks = match attention {
            Attention::Whole => 0..TURNS,
            Attention::InTurn => self.turn..self.turn + 1,
        };
        self.turn = (self.turn + 1) % TURNS;
        let mut stations: Vec<Looked<'_>> = (self.stations.iter())
            .zip(&mut found)
            .enumerate()
            .filter_map(|(place, pair)| looks.contains(&(place % TURNS)).then_some(pair))
            .collect();
        for (station, found) in &mut stations {
            **found = (0.0, skin[**station as usize].normal);
        }
        self.far.clear();
        let loose = Arc::clone(&self.loose);
        for (&(triangles, positions), loose) in cloth.iter().zip(&*loose) {
            let near: Vec<[u32; 3]> = (triangles.iter().copied())
                .filter(|corners| {
                    let mut corners = corners.iter();
                    corners.any(|&corner| self.is_near(positions[corner as usize]))
                })
                .collect();
            let grid = TriangleGrid::new(positions, &near, CELL);
            let look = |stations: &mut [Looked<'_>]| {
                let mut crossed = Vec::new();
                let skin = stations
                    .iter_mut()
                    .map(|(it, found)| (&skin[**it as usize], found));
                for (surfel, found) in skin.filter(|(it, _)| self.is_near(it.position)) {
                    outermost(surfel, (&grid, &near, positions), (&mut crossed, found));
                }
            };
            if rayon::current_num_threads() == 1 {
                look(&mut stations);
            } else {
                stations.par_chunks_mut(TOGETHER).for_each(look);
            }
            let is_met = |particle: &&u32| self.is_near(positions[**particle as usize]);
            if !loose.iter().any(|particle| is_met(&particle)) {
                continue;
            }
            // All triangles around what is near are near.
            let normals = vertex_normals(positions, &near);
            let met: Vec<Surfel> = (loose.iter().filter(is_met))
                .map(|&particle| Surfel {
                    position: positions[particle as usize],
                    normal: normals[particle as usize],
                })
                .collect();
            self.far.extend(met);
        }
        self.found = found;
        self.spread(skin);
    }

    /// The mean of what is alike: half of a flower does not follow a fold, and rests a few millimeters
    /// deeper than its crests.
    fn spread(&mut self, skin: &[Surfel]) {
        let mut raised = std::mem::take(&mut self.raised);
        raised.clear();
        let all = (0..).zip(skin).zip(&*self.alike);
        for ((place, surfel), alike) in all.filter(|((_, it), _)| self.is_near(it.position)) {
            let found = alike.iter().map(|&station| self.found[station as usize]);
            let sum = found.fold((0.0, Vec3::ZERO), |sum, one| (sum.0 + one.0, sum.1 + one.1));
            #[expect(clippy::cast_precision_loss, reason = "stations are few")]
            let height = sum.0 / alike.len().max(1) as f32;
            let normal = sum.1.try_normalize().unwrap_or(surfel.normal);
            raised.push((place, height, normal));
        }
        self.raised = raised;
    }

    /// Raises the skin to the cloth that was looked at last.
    pub(super) fn raise(&self, skin: &mut [Surfel]) {
        for &(place, height, normal) in &self.raised {
            if 0.0 < height {
                let surfel = &mut skin[place as usize];
                surfel.position += surfel.normal * height;
                surfel.normal = normal;
            }
        }
    }

    /// Cloth near the strands that hangs far from the skin.
    pub(super) fn far(&self) -> &[Surfel] {
        &self.far
    }

    /// How the skin nearest to a place was raised when it was looked at last [m]; nothing where nothing was.
    pub(super) fn lift(&self, skin: &[Surfel], place: Vec3) -> Vec3 {
        if !self.is_near(place) {
            return Vec3::ZERO;
        }
        let apart = |one: u32| skin[one as usize].position.distance_squared(place);
        let nearest = (self.raised.iter()).min_by(|a, b| apart(a.0).total_cmp(&apart(b.0)));
        nearest.map_or(Vec3::ZERO, |&(one, height, _)| {
            skin[one as usize].normal * height
        })
    }
}

/// Finds how high the outermost cloth lies over a surfel [m], and its normal there.
fn outermost(
    surfel: &Surfel,
    (grid, triangles, positions): (&TriangleGrid<'_>, &[[u32; 3]], &[Vec3]),
    (crossed, found): (&mut Vec<u32>, &mut (f32, Vec3)),
) {
    let out = surfel.position + surfel.normal * REACH;
    grid.crossed_by(surfel.position, out, crossed);
    for &triangle in &*crossed {
        let [a, b, c] = triangles[triangle as usize].map(|corner| positions[corner as usize]);
        let normal = (b - a).cross(c - a).normalize_or_zero();
        let facing = normal.dot(surfel.normal);
        if facing < SAME_WAY {
            continue;
        }
        let height = ((a - surfel.position).dot(normal) / facing).clamp(0.0, REACH);
        if found.0 < height {
            *found = (height, normal);
        }
    }
}
