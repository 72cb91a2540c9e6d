//! Measured heads, hands and feet (`data/head.json` and its siblings): reading, and blending like the sections.
//!
//! They stand on the bodies of the sections, in the same frame; every body has the same points and triangles, so
//! parts blend linearly, point by point. Provenance: `data/README.md`.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use glam::{Mat3, Vec3};
use serde::Deserialize;

use crate::BodyError;

const HEAD: &str = include_str!("../data/head.json");
const HAND: &str = include_str!("../data/hand.json");
const FOOT: &str = include_str!("../data/foot.json");

/// The body that the others are told by.
const FIRST: &str = "woman_mean";

/// Shares of the measured bodies in a dancer, times how much each is scaled.
pub(crate) type Shares = Vec<(String, f32)>;

/// A part of the left half of a body, which is sewn to it along its loop.
#[derive(Debug, Clone)]
pub(crate) struct Part {
    /// Places [m].
    pub(crate) positions: Vec<Vec3>,
    /// Counter-clockwise seen from outside.
    pub(crate) triangles: Vec<[u32; 3]>,
    /// Where it meets the body, in order: closed, or of a half that ends on the mirror plane at both ends.
    pub(crate) rim: Vec<u32>,
    /// How much open sky each point sees, 0 to 1.
    pub(crate) open: Vec<f32>,
    /// Nail of each triangle, 0 for none; empty on a head.
    pub(crate) nails: Vec<u8>,
}

/// A head with what is told of its places.
#[derive(Debug, Clone)]
pub(crate) struct HeadPart {
    pub(crate) part: Part,
    /// Points on the mirror plane.
    pub(crate) middle: Vec<u32>,
    /// Rings around the lids, and which is their outer edge; see `data/README.md`.
    pub(crate) lids: Vec<Vec<u32>>,
    pub(crate) lid_rim: usize,
    /// Rings around the lips, and which is their border.
    pub(crate) lips: Vec<Vec<u32>>,
    pub(crate) lip_rim: usize,
    pub(crate) ear: Vec<u32>,
    /// How much color the cheek has, 0 to 1.
    pub(crate) cheek: Vec<f32>,
    /// Places of the brow's middle line, from the nose outwards.
    pub(crate) brow: Vec<([u32; 3], [f32; 3])>,
    /// Points that are told by name.
    pub(crate) places: HeadPlaces,
    /// Middle of the left eyeball [m].
    pub(crate) eye: Vec3,
    /// Its radius [m], that of its iris, and where it looks.
    pub(crate) eye_radius: f32,
    pub(crate) iris_radius: f32,
    pub(crate) gaze: Vec3,
}

#[derive(Deserialize)]
struct Raw {
    unit: f32,
    tri: Vec<i32>,
    r#loop: Vec<u32>,
    ao: Vec<f32>,
    #[serde(default)]
    nail: Vec<u8>,
    bodies: BTreeMap<String, RawBody>,
}

#[derive(Deserialize)]
struct RawBody {
    a: Option<[f32; 12]>,
    p: Vec<i32>,
    eye: Option<RawEye>,
}

#[derive(Deserialize)]
struct RawEye {
    c: [f32; 3],
    r: f32,
    iris: f32,
    gaze: [f32; 3],
}

#[derive(Deserialize)]
struct RawHead {
    #[serde(flatten)]
    part: Raw,
    mid: Vec<i32>,
    eye: Vec<Vec<u32>>,
    rim_ring: usize,
    mouth: Vec<Vec<u32>>,
    lip_ring: usize,
    ear: Vec<i32>,
    cheek: Vec<f32>,
    brow: Vec<[u32; 5]>,
    smile: RawSmile,
    places: HeadPlaces,
}

#[derive(Deserialize)]
struct RawSmile {
    i: Vec<i32>,
    d: Vec<i32>,
}

/// Points of a head that anatomy has names for.
#[derive(Debug, Clone, Copy, Deserialize)]
pub(crate) struct HeadPlaces {
    pub(crate) nostril: u32,
    /// The tip of the nose.
    pub(crate) pronasale: u32,
    /// The side of the nose where it is widest.
    pub(crate) alare: u32,
    /// Where the nose meets the upper lip.
    pub(crate) subnasale: u32,
    /// The root of the nose.
    pub(crate) nasion: u32,
    /// Where the lips meet.
    pub(crate) stomion: u32,
    /// The chin's lowest point.
    pub(crate) menton: u32,
    pub(crate) ear_lobe: u32,
}

/// How much she smiles: a hint of it, as one dances.
const SMILE: f32 = 0.28;
/// Radius of the mean woman's eye [m], by which lengths of a face are told.
const MEAN_EYE: f32 = 0.0143;

fn broken(reason: impl ToString) -> BodyError {
    BodyError::Sections {
        reason: reason.to_string(),
    }
}

/// What a table holds; it is read once.
fn read<'a, T: Deserialize<'a>>(table: &'a str) -> Result<T, String> {
    serde_json::from_str(table).map_err(|error| error.to_string())
}

/// The head of a blend of bodies.
pub(crate) fn head(shares: &Shares) -> Result<HeadPart, BodyError> {
    static RAW: LazyLock<Result<RawHead, String>> = LazyLock::new(|| read(HEAD));
    let told = RAW.as_ref().map_err(broken)?;
    let raw = &told.part;
    let mut part = raw.blend(shares)?;
    let eyes = raw.weighed(shares)?;
    let eyes =
        eyes.map(|(share, body)| Ok((share, body.eye.as_ref().ok_or_else(|| broken("eye"))?)));
    let eyes: Vec<(f32, &RawEye)> = eyes.collect::<Result<_, BodyError>>()?;
    let sum = |of: &dyn Fn(&RawEye) -> f32| -> f32 {
        eyes.iter().map(|(share, eye)| share * of(eye)).sum()
    };
    let vector = |of: &dyn Fn(&RawEye) -> [f32; 3]| -> Vec3 {
        (eyes.iter())
            .map(|(share, eye)| Vec3::from_array(of(eye)) * *share)
            .sum()
    };
    let eye_radius = sum(&|eye| eye.r);
    let middle = run(&told.mid);
    let smiling = run(&told.smile.i);
    let moves = told.smile.d.as_chunks::<3>().0;
    let by = SMILE * raw.unit * eye_radius / MEAN_EYE;
    for (&point, step) in smiling.iter().zip(moves) {
        part.positions[point as usize] += triple(*step) * by;
    }
    for &point in &middle {
        part.positions[point as usize].x = 0.0;
    }
    let brow = told.brow.iter();
    let brow = brow.map(|&[a, b, c, second, third]| {
        let [second, third] = [second, third].map(|share| share as f32 / 1000.0);
        ([a, b, c], [1.0 - second - third, second, third])
    });
    Ok(HeadPart {
        part,
        middle,
        lids: told.eye.clone(),
        lid_rim: told.rim_ring,
        lips: told.mouth.clone(),
        lip_rim: told.lip_ring,
        ear: run(&told.ear),
        cheek: told.cheek.iter().map(|percent| percent / 100.0).collect(),
        brow: brow.collect(),
        places: told.places,
        eye: vector(&|eye| eye.c),
        eye_radius,
        iris_radius: sum(&|eye| eye.iris),
        gaze: vector(&|eye| eye.gaze).normalize_or(Vec3::Z),
    })
}

/// The left hand of a blend of bodies.
pub(crate) fn hand(shares: &Shares) -> Result<Part, BodyError> {
    static RAW: LazyLock<Result<Raw, String>> = LazyLock::new(|| read(HAND));
    RAW.as_ref().map_err(broken)?.blend(shares)
}

/// The left foot of a blend of bodies.
pub(crate) fn foot(shares: &Shares) -> Result<Part, BodyError> {
    static RAW: LazyLock<Result<Raw, String>> = LazyLock::new(|| read(FOOT));
    RAW.as_ref().map_err(broken)?.blend(shares)
}

/// Numbers from the differences between them.
fn run(steps: &[i32]) -> Vec<u32> {
    let mut last = 0_i32;
    (steps.iter())
        .map(|step| {
            last += step;
            u32::try_from(last).unwrap_or_default()
        })
        .collect()
}

fn triple(numbers: [i32; 3]) -> Vec3 {
    Vec3::from_array(numbers.map(|number| number as f32))
}

impl Raw {
    fn weighed<'a>(
        &'a self,
        shares: &'a Shares,
    ) -> Result<impl Iterator<Item = (f32, &'a RawBody)>, BodyError> {
        if let Some((name, _)) = (shares.iter()).find(|(name, _)| !self.bodies.contains_key(name)) {
            return Err(broken(format!("{name} is missing")));
        }
        Ok((shares.iter()).filter_map(|(name, share)| Some((*share, self.bodies.get(name)?))))
    }

    /// Points from the differences between them [m].
    fn points(&self, body: &RawBody) -> Vec<Vec3> {
        let mut last = [0_i32; 3];
        (body.p.as_chunks::<3>().0.iter())
            .map(|step| {
                for (sum, step) in last.iter_mut().zip(step) {
                    *sum += step;
                }
                triple(last) * self.unit
            })
            .collect()
    }

    fn blend(&self, shares: &Shares) -> Result<Part, BodyError> {
        let first = self.bodies.get(FIRST).ok_or_else(|| broken(FIRST))?;
        let first = self.points(first);
        let mut positions = vec![Vec3::ZERO; first.len()];
        for (share, body) in self.weighed(shares)? {
            match body.a {
                None => add(&mut positions, first.iter().copied(), share),
                Some([a, b, c, x, d, e, f, y, g, h, i, z]) => {
                    let turn = Mat3::from_cols_array(&[a, d, g, b, e, h, c, f, i]);
                    let moved = first.iter().map(|&place| turn * place);
                    let rest = self.points(body);
                    let placed = moved
                        .zip(rest)
                        .map(|(place, rest)| place + Vec3::new(x, y, z) + rest);
                    add(&mut positions, placed, share);
                }
            }
        }
        let mut corner = 0;
        let triangles = self
            .tri
            .as_chunks::<3>()
            .0
            .iter()
            .map(|&[first, second, third]| {
                corner += first;
                [corner, corner + second, corner + third]
                    .map(|it| u32::try_from(it).unwrap_or_default())
            });
        Ok(Part {
            triangles: triangles.collect(),
            positions,
            rim: self.r#loop.clone(),
            open: self.ao.iter().map(|percent| percent / 100.0).collect(),
            nails: self.nail.clone(),
        })
    }
}

impl HeadPart {
    /// How large its face is over the mean woman's.
    pub(crate) fn size(&self) -> f32 {
        self.eye_radius / MEAN_EYE
    }
}

impl Part {
    /// Whether its triangles run along its rim as the rim is listed.
    pub(crate) fn is_along_rim(&self) -> bool {
        let [Some(&first), Some(&second)] = [self.rim.first(), self.rim.get(1)] else {
            return true;
        };
        self.triangles.iter().any(|&[a, b, c]| {
            let edges = [[a, b], [b, c], [c, a]];
            edges.contains(&[first, second])
        })
    }
}

fn add(sum: &mut [Vec3], places: impl Iterator<Item = Vec3>, share: f32) {
    for (sum, place) in sum.iter_mut().zip(places) {
        *sum += place * share;
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap as Map;

    use super::*;

    /// Edges that one triangle alone has, and whether every edge is met at most once in each direction.
    fn borders(triangles: &[[u32; 3]]) -> (Vec<[u32; 2]>, bool) {
        let mut met: Map<[u32; 2], u32> = Map::new();
        for &[a, b, c] in triangles {
            for edge in [[a, b], [b, c], [c, a]] {
                *met.entry(edge).or_default() += 1;
            }
        }
        let is_oriented = met.values().all(|&count| count == 1);
        let open = met.keys().filter(|[a, b]| !met.contains_key(&[*b, *a]));
        (open.copied().collect(), is_oriented)
    }

    #[test]
    fn parts_are_surfaces_whose_border_is_the_rim() {
        let alone = vec![("woman_large".to_owned(), 0.5), ("child_8".to_owned(), 0.5)];
        for part in [hand(&alone).unwrap(), foot(&alone).unwrap()] {
            let (open, is_oriented) = borders(&part.triangles);
            assert!(is_oriented);
            assert_eq!(open.len(), part.rim.len());
            assert!(open.iter().flatten().all(|end| part.rim.contains(end)));
            assert_eq!(part.nails.len(), part.triangles.len());
            assert!((1..=5).all(|nail| part.nails.contains(&nail)));
        }
        let head = head(&alone).unwrap();
        let (open, is_oriented) = borders(&head.part.triangles);
        assert!(is_oriented);
        let is_border = |end: &u32| head.part.rim.contains(end) || head.middle.contains(end);
        assert!(open.iter().flatten().all(is_border));
    }

    #[test]
    fn a_part_of_equal_bodies_is_that_body() {
        let whole = foot(&vec![("man_mean".to_owned(), 1.0)]).unwrap();
        let halves = foot(&vec![
            ("man_mean".to_owned(), 0.25),
            ("man_mean".to_owned(), 0.75),
        ]);
        for (one, other) in whole.positions.iter().zip(&halves.unwrap().positions) {
            assert!(one.distance(*other) < 1.0e-6);
        }
        assert!(foot(&vec![("nobody".to_owned(), 1.0)]).is_err());
    }
}
