//! How old a face is: its shape between those of a young woman and of one in her sixties, and the lines of age.

use glam::Vec3;
use lole_geom::mesh::vertex_normals;

use super::features::Marks;
use crate::BodyError;
use crate::appearance::oldness;
use crate::parts::{self, HeadPart, Shares};
use crate::surface::warp::smooth_step;

/// The measured bodies between which the years of a face lie.
const YOUNG: &str = "woman_mean";
const OLD: &str = "woman_60s";

/// Where lines of age run deepest: depth of the fold beside the nose, of the one below the mouth and of the bag below
/// the eye, at 65 years [mm].
const FOLD: f32 = 0.75;
const MOUTH_FOLD: f32 = 0.5;
const BAG: f32 = 0.55;
/// How dark they are.
const FOLD_SHADE: f32 = 0.26;
const BAG_SHADE: f32 = 0.17;

/// Takes a head that is made of these shares so far from that of a young woman to that of one in her sixties, whoever
/// else it is made of; `free` says how far each of its points may move.
pub(super) fn grow(
    head: &mut HeadPart,
    shares: &Shares,
    (age_years, free): (Option<f32>, &[f32]),
) -> Result<(), BodyError> {
    if age_years.is_none() {
        return Ok(());
    }
    let old = oldness(age_years);
    let total: f32 = shares.iter().map(|(_, share)| *share).sum();
    let elder = shares.iter().filter(|(name, _)| name == OLD);
    let already = elder.map(|(_, share)| *share / total).sum::<f32>();
    // Her measures may have made her face of an elder one's in part: that part is of her years, not more.
    let more = old - already;
    let measured = |name: &str| parts::head(&vec![(name.to_owned(), 1.0)]);
    let (young, elder) = (measured(YOUNG)?, measured(OLD)?);
    let size = head.size();
    let down = elder.eye - young.eye;
    let down = Vec3::new(0.0, down.y, down.z);
    let ends = young.part.positions.iter().zip(&elder.part.positions);
    let places = head.part.positions.iter_mut().zip(free);
    for ((place, free), (young, elder)) in places.zip(ends) {
        *place += (*elder - *young - down) * (size * more * free);
    }
    head.eye += (elder.eye - young.eye - down) * (size * more);
    for (radius, [young, elder]) in [
        (&mut head.eye_radius, [young.eye_radius, elder.eye_radius]),
        (
            &mut head.iris_radius,
            [young.iris_radius, elder.iris_radius],
        ),
    ] {
        *radius += (elder - young) * size * more;
    }
    Ok(())
}

/// A line of age, seen from the front.
struct Crease {
    points: Vec<Vec3>,
    /// Half its width [m].
    half: f32,
    /// How deep it is [m].
    depth: f32,
    shade: f32,
}

impl Crease {
    /// How near a place is to it, 0 to 1.
    fn near(&self, place: Vec3) -> f32 {
        let pairs = self.points.windows(2).enumerate();
        let count = self.points.len().saturating_sub(1).max(1) as f32;
        let found = pairs.map(|(index, pair)| {
            let [a, b] = [pair[0], pair[1]].map(|it| it.truncate());
            let (way, to) = (b - a, place.truncate() - a);
            let share = (to.dot(way) / way.length_squared().max(1.0e-12)).clamp(0.0, 1.0);
            let apart = to.distance(way * share);
            (apart, (index as f32 + share) / count)
        });
        let nearest = found.min_by(|a, b| a.0.total_cmp(&b.0));
        let Some((apart, along)) = nearest else {
            return 0.0;
        };
        // It begins and ends in nothing.
        let ends = smooth_step(along / 0.2) * smooth_step((1.0 - along) / 0.3);
        ends * smooth_step(1.0 - apart / (2.0 * self.half))
    }
}

/// Folds beside nose and mouth and bags below the eyes.
fn creases(head: &HeadPart, old: f32) -> Vec<Crease> {
    let marks = Marks::of(head);
    let mm = marks.mm;
    let by = |x: f32, y: f32| Vec3::new(x, y, 0.0) * mm;
    let bag = |turn: f32| {
        let (sin, cos) = lole_geom::trig::sin_cos(turn);
        marks.eye + Vec3::new(cos, sin, 0.0) * (1.27 * marks.radius)
    };
    let beside = vec![
        marks.alare + by(1.0, 6.0),
        marks.alare + by(6.5, -5.0),
        marks.corner + by(9.0, 9.0),
        marks.corner + by(9.5, -3.0),
    ];
    let below = vec![
        marks.corner + by(3.0, 1.0),
        marks.corner + by(6.5, -7.0),
        marks.corner + by(7.0, -17.0),
    ];
    let under = [-2.75_f32, -2.3, -1.9, -1.5, -1.1, -0.7].map(bag).to_vec();
    [
        (beside, 3.2, FOLD, FOLD_SHADE),
        (below, 2.8, MOUTH_FOLD, 0.7 * FOLD_SHADE),
        (under, 2.6, BAG, BAG_SHADE),
    ]
    .map(|(points, half, depth, shade)| Crease {
        points,
        half: half * mm,
        depth: depth * old * mm,
        shade: shade * old,
    })
    .into()
}

/// Lays lines into the skin.
pub(super) fn line(head: &mut HeadPart, age_years: Option<f32>) {
    let old = oldness(age_years);
    if old <= 0.0 {
        return;
    }
    let normals = vertex_normals(&head.part.positions, &head.part.triangles);
    let creases = creases(head, old);
    for (place, normal) in head.part.positions.iter_mut().zip(normals) {
        // A line lies in what is seen from the front.
        let front = smooth_step(normal.normalize_or_zero().z / 0.4);
        let at = *place;
        for crease in &creases {
            let near = crease.near(at);
            *place -= normal.normalize_or_zero() * (crease.depth * near * near * front);
        }
    }
}

/// How much light lines of age leave to each point of a head.
pub(super) fn lined(head: &HeadPart, age_years: Option<f32>) -> Option<Vec<f32>> {
    let old = oldness(age_years);
    if old <= 0.0 {
        return None;
    }
    let creases = creases(head, old);
    let shades = head.part.positions.iter().map(|&place| {
        let shade = creases.iter().map(|crease| {
            let near = crease.near(place);
            1.0 - crease.shade * near * near
        });
        shade.product()
    });
    Some(shades.collect())
}
