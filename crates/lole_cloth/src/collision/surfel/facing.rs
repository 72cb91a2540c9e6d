//! Which ways the skin faces around a place: by sectors of directions, so that a few bits tell
//! whether anything there may face against a normal.

use glam::Vec3;

/// Sectors: a quarter of each side of a cube.
const SECTOR_COUNT: usize = 24;

/// Direction in the middle of a sector across from its three signs, before it is normalized: the
/// corners of the sector lie as far from it as they can be brought together.
const SIDEWAYS: f32 = 0.41;

/// Cosine of 30.6°, within which of its middle a sector lies.
const SECTOR_COSINE: f32 = 0.8607;

/// Sine of the same angle.
const SECTOR_SINE: f32 = 0.5091;

/// Sectors in which normals lie, by bits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Sectors(u32);

impl Sectors {
    /// The one in which a normal lies.
    pub(super) fn of(normal: Vec3) -> Self {
        let size = normal.abs();
        let axis = if size.y <= size.x && size.z <= size.x {
            0
        } else if size.z <= size.y {
            1
        } else {
            2
        };
        let signs = u32::from(normal.x < 0.0)
            | (u32::from(normal.y < 0.0) << 1)
            | (u32::from(normal.z < 0.0) << 2);
        Self(1 << (axis * 8 + signs))
    }

    pub(super) const fn and(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Whether a normal in one of them may have a product of `limit` or less, which is above -1,
    /// with this unit vector: `false` is certain.
    pub(super) fn may_face(self, normal: Vec3, limit: f32) -> bool {
        // A sector's normals turn away from its middle by its half-width at most.
        let bound = limit * SECTOR_COSINE + (1.0 - limit * limit).max(0.0).sqrt() * SECTOR_SINE;
        let mut rest = self.0;
        while rest != 0 {
            let sector = rest.trailing_zeros() as usize;
            if MIDDLES[sector].dot(normal) <= bound {
                return true;
            }
            rest &= rest - 1;
        }
        false
    }
}

/// The middles of all sectors.
const MIDDLES: [Vec3; SECTOR_COUNT] = middles();

const fn middles() -> [Vec3; SECTOR_COUNT] {
    // 1 / √(1 + 2 SIDEWAYS²)
    let along = 0.865_096;
    let mut middles = [Vec3::ZERO; SECTOR_COUNT];
    let mut sector = 0;
    while sector < SECTOR_COUNT {
        let (axis, signs) = (sector / 8, sector % 8);
        let mut middle = [0.0; 3];
        let mut place = 0;
        while place < 3 {
            let size = if place == axis {
                along
            } else {
                along * SIDEWAYS
            };
            middle[place] = if (signs >> place) & 1 == 1 {
                -size
            } else {
                size
            };
            place += 1;
        }
        middles[sector] = Vec3::from_array(middle);
        sector += 1;
    }
    middles
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Directions all over the sphere.
    fn directions() -> impl Iterator<Item = Vec3> {
        let steps = || (-20_i8..=20).map(|step| f32::from(step) / 20.0);
        let cube =
            steps().flat_map(move |x| steps().flat_map(move |y| steps().map(move |z| (x, y, z))));
        cube.filter_map(|(x, y, z)| Vec3::new(x, y, z).try_normalize())
    }

    #[test]
    fn every_sector_lies_as_near_to_its_middle_as_its_width_says() {
        let mut seen = Sectors::default();
        for normal in directions() {
            let sectors = Sectors::of(normal);
            let middle = MIDDLES[sectors.0.trailing_zeros() as usize];
            assert!(middle.is_normalized());
            assert!(SECTOR_COSINE <= middle.dot(normal), "{normal}");
            seen = seen.and(sectors);
        }
        assert_eq!(seen.0, (1 << SECTOR_COUNT) - 1);
    }

    #[test]
    fn what_faces_against_a_normal_is_never_missed() {
        let limit = -0.3;
        let few: Vec<_> = directions().step_by(97).collect();
        let mut certain = 0;
        for &one in &few {
            for &other in &few {
                let may_face = Sectors::of(other).may_face(one, limit);
                assert!(may_face || limit < one.dot(other));
                certain += usize::from(!may_face);
            }
        }
        assert!(few.len() * few.len() / 4 < certain);
    }
}
