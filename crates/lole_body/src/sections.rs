//! The measured sections of seven bodies (`data/body_sections.json`): reading, blending, scaling.
//!
//! A body is a union of tubes (torso, leg, foot, arm, palm, fingers; left ones only, mirror in
//! `x`) given by rings of radii, and a head given by radii over longitude and latitude. Ring `i`
//! is the same anatomical level in every body, so bodies blend linearly, number by number.
//! Provenance: `data/README.md`.

use std::collections::BTreeMap;

use glam::Vec3;
use serde::Deserialize;

use crate::BodyError;

const TABLE: &str = include_str!("../data/body_sections.json");
/// Radii are stored in tenths of a millimeter.
const RADIUS_UNIT: f32 = 1.0e-4;

/// Which part of the body a tube is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Tube {
    Torso,
    Leg,
    Foot,
    Arm,
    Palm,
    Thumb,
    Index,
    Middle,
    Ring,
    Little,
    Head,
}

impl Tube {
    pub(crate) const RINGED: [Self; 10] = [
        Self::Torso,
        Self::Leg,
        Self::Foot,
        Self::Arm,
        Self::Palm,
        Self::Thumb,
        Self::Index,
        Self::Middle,
        Self::Ring,
        Self::Little,
    ];

    const fn key(self) -> &'static str {
        match self {
            Self::Torso => "torso",
            Self::Leg => "leg",
            Self::Foot => "foot",
            Self::Arm => "arm",
            Self::Palm => "palm",
            Self::Thumb => "finger_Thumb",
            Self::Index => "finger_Index",
            Self::Middle => "finger_Middle",
            Self::Ring => "finger_Ring",
            Self::Little => "finger_Little",
            Self::Head => "head",
        }
    }

    /// Arm, palm or finger.
    pub(crate) const fn is_arm(self) -> bool {
        !matches!(self, Self::Torso | Self::Leg | Self::Foot | Self::Head)
    }
}

/// One ring: `point(i) = center + radii[i] (cos a · across + sin a · axis × across)`,
/// `a = 2π i / len`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Ring {
    pub(crate) center: Vec3,
    pub(crate) axis: Vec3,
    pub(crate) across: Vec3,
    pub(crate) radii: Vec<f32>,
}

/// A tube: rings in order, and the lengths [m] of its rounded ends (0 is a flat, buried end).
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct TubeTable {
    pub(crate) tube: Tube,
    pub(crate) caps: [f32; 2],
    pub(crate) rings: Vec<Ring>,
}

/// The head: `radii[lon][lat]`, longitude 0..=180° by 3° from `+Z`, latitude -75..=90° by 3°, and
/// a finer `face[lon][lat]`, longitude 0..=48°, latitude -48..=22.5°, by 1.5°.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct HeadTable {
    pub(crate) center: Vec3,
    pub(crate) radii: Vec<Vec<f32>>,
    pub(crate) face: Vec<Vec<f32>>,
}

/// One body. Lengths in meters.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Sections {
    pub(crate) height: f32,
    /// Heights of the tape levels.
    pub(crate) tape: BTreeMap<String, f32>,
    /// Heights and places of the body's joins.
    pub(crate) levels: BTreeMap<String, f32>,
    /// VRM joints of the left side and the middle.
    pub(crate) joints: BTreeMap<String, Vec3>,
    pub(crate) tubes: Vec<TubeTable>,
    pub(crate) head: HeadTable,
    /// Tape of the body [m]: bust, waist, hip.
    pub(crate) girths: [f32; 3],
}

#[derive(Deserialize)]
struct RawTable {
    bodies: BTreeMap<String, RawBody>,
}

#[derive(Deserialize)]
struct RawBody {
    height: f32,
    tape: BTreeMap<String, RawTape>,
    levels: BTreeMap<String, f32>,
    joints: BTreeMap<String, Vec<f32>>,
    tubes: RawTubes,
}

#[derive(Deserialize)]
struct RawTape {
    y: f32,
    girth: Option<f32>,
}

#[derive(Deserialize)]
struct RawTubes {
    head: RawHead,
    #[serde(flatten)]
    ringed: BTreeMap<String, RawTube>,
}

#[derive(Deserialize)]
struct RawHead {
    c: [f32; 3],
    r: Vec<Vec<f32>>,
    face: Vec<Vec<f32>>,
}

#[derive(Deserialize)]
struct RawTube {
    sym: u8,
    caps: [f32; 2],
    rings: Vec<RawRing>,
}

#[derive(Deserialize)]
struct RawRing {
    c: [f32; 3],
    n: [f32; 3],
    u: [f32; 3],
    r: Vec<f32>,
}

/// All bodies of the table, by name.
pub(crate) fn read_bodies() -> Result<BTreeMap<String, Sections>, BodyError> {
    let table: RawTable = serde_json::from_str(TABLE).map_err(|error| BodyError::Sections {
        reason: error.to_string(),
    })?;
    table
        .bodies
        .into_iter()
        .map(|(name, body)| Ok((name, body.unpack()?)))
        .collect()
}

impl RawBody {
    fn unpack(mut self) -> Result<Sections, BodyError> {
        let missing = |what: &str| BodyError::Sections {
            reason: format!("{what} is missing"),
        };
        let mut tubes = Vec::with_capacity(Tube::RINGED.len());
        for tube in Tube::RINGED {
            let raw = (self.tubes.ringed.remove(tube.key())).ok_or_else(|| missing(tube.key()))?;
            tubes.push(raw.unpack(tube));
        }
        let mut girths = [0.0; 3];
        for (girth, name) in girths.iter_mut().zip(["bust", "waist", "hip"]) {
            *girth = (self.tape.get(name))
                .and_then(|tape| tape.girth)
                .ok_or_else(|| missing(name))?;
        }
        let meters = |rows: &[Vec<f32>]| -> Vec<Vec<f32>> {
            rows.iter()
                .map(|row| row.iter().map(|radius| radius * RADIUS_UNIT).collect())
                .collect()
        };
        Ok(Sections {
            height: self.height,
            girths,
            tape: (self.tape.into_iter().map(|(name, tape)| (name, tape.y))).collect(),
            levels: self.levels,
            joints: (self.joints.into_iter())
                .filter(|(_, joint)| joint.len() == 3)
                .map(|(name, joint)| (name, Vec3::new(joint[0], joint[1], joint[2])))
                .collect(),
            tubes,
            head: HeadTable {
                center: Vec3::from_array(self.tubes.head.c),
                radii: meters(&self.tubes.head.r),
                face: meters(&self.tubes.head.face),
            },
        })
    }
}

impl RawTube {
    /// A symmetric tube stores the angles 0..=π only.
    fn unpack(self, tube: Tube) -> TubeTable {
        let rings = self.rings.into_iter().map(|ring| {
            let mut radii: Vec<f32> = ring.r.iter().map(|radius| radius * RADIUS_UNIT).collect();
            if self.sym == 1 {
                let mirrored: Vec<f32> = radii[1..radii.len() - 1].iter().rev().copied().collect();
                radii.extend(mirrored);
            }
            Ring {
                center: Vec3::from_array(ring.c),
                axis: Vec3::from_array(ring.n),
                across: Vec3::from_array(ring.u),
                radii,
            }
        });
        TubeTable {
            tube,
            caps: self.caps,
            rings: rings.collect(),
        }
    }
}

impl Sections {
    /// The body, `factor` times as large.
    pub(crate) fn scaled(&self, factor: f32) -> Self {
        let mut scaled = self.clone();
        scaled.for_each_number(&mut |number| *number *= factor);
        for tube in &mut scaled.tubes {
            for ring in &mut tube.rings {
                ring.axis /= factor;
                ring.across /= factor;
            }
        }
        scaled
    }

    /// `Σ share · body`, number by number. The shares sum to 1.
    pub(crate) fn blended(bodies: &[(f32, &Self)]) -> Option<Self> {
        let (&(first_share, first), others) = bodies.split_first()?;
        let mut sum = first.clone();
        sum.for_each_number(&mut |number| *number *= first_share);
        for &(share, body) in others {
            let mut numbers = Vec::new();
            let mut body = body.clone();
            body.for_each_number(&mut |number| numbers.push(*number));
            let mut numbers = numbers.into_iter();
            sum.for_each_number(&mut |number| *number += share * numbers.next().unwrap_or(0.0));
        }
        for tube in &mut sum.tubes {
            for ring in &mut tube.rings {
                ring.axis = ring.axis.normalize_or_zero();
                ring.across = ring.across.normalize_or_zero();
            }
        }
        Some(sum)
    }

    /// Visits every number of the body in a fixed order.
    fn for_each_number(&mut self, visit: &mut dyn FnMut(&mut f32)) {
        let visit_vector = |vector: &mut Vec3, visit: &mut dyn FnMut(&mut f32)| {
            visit(&mut vector.x);
            visit(&mut vector.y);
            visit(&mut vector.z);
        };
        visit(&mut self.height);
        self.girths.iter_mut().for_each(&mut *visit);
        self.tape.values_mut().for_each(&mut *visit);
        self.levels.values_mut().for_each(&mut *visit);
        for joint in self.joints.values_mut() {
            visit_vector(joint, visit);
        }
        for tube in &mut self.tubes {
            tube.caps.iter_mut().for_each(&mut *visit);
            for ring in &mut tube.rings {
                visit_vector(&mut ring.center, visit);
                visit_vector(&mut ring.axis, visit);
                visit_vector(&mut ring.across, visit);
                ring.radii.iter_mut().for_each(&mut *visit);
            }
        }
        visit_vector(&mut self.head.center, visit);
        for row in self.head.radii.iter_mut().chain(&mut self.head.face) {
            row.iter_mut().for_each(&mut *visit);
        }
    }

    /// Height of a tape level, 0 where the table has none.
    pub(crate) fn tape_level(&self, name: &str) -> f32 {
        self.tape.get(name).copied().unwrap_or(0.0)
    }

    /// A level of the body, 0 where the table has none.
    pub(crate) fn level(&self, name: &str) -> f32 {
        self.levels.get(name).copied().unwrap_or(0.0)
    }

    /// A joint by VRM name; right ones are mirrored left ones.
    pub(crate) fn joint(&self, name: &str) -> Vec3 {
        if let Some(rest) = name.strip_prefix("right") {
            let left = self.joint(&format!("left{rest}"));
            return Vec3::new(-left.x, left.y, left.z);
        }
        self.joints.get(name).copied().unwrap_or(Vec3::ZERO)
    }

    /// The rings of one tube.
    pub(crate) fn tube(&self, tube: Tube) -> &TubeTable {
        &self.tubes[tube as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_holds_seven_bodies_of_one_layout() {
        let bodies = read_bodies().unwrap();
        assert_eq!(bodies.len(), 7);
        let mut lengths = bodies.values().map(|body| {
            let mut count = 0;
            body.clone().for_each_number(&mut |_| count += 1);
            count
        });
        let first = lengths.next().unwrap();
        assert!(lengths.all(|length| length == first));
    }

    #[test]
    fn a_blend_with_itself_is_the_body() {
        let bodies = read_bodies().unwrap();
        let mean = &bodies["woman_mean"];
        let blend = Sections::blended(&[(0.25, mean), (0.75, mean)]).unwrap();
        assert!((blend.height - mean.height).abs() < 1e-6);
        assert!((blend.joint("leftHand") - mean.joint("leftHand")).length() < 1e-6);
    }
}
