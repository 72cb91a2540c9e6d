//! How pins are dragged and cloth is thrown.

use std::fmt::Write as _;

use glam::Vec3;
use lole_geom::Chance;

use super::cloth::Cloth;

/// From one random place to the next, at rest at each.
#[derive(Debug, Clone)]
pub(super) struct Way {
    /// Farthest along each axis [m].
    reach: f32,
    /// Frames from one place to the next, at least.
    least: f32,
    from: Vec3,
    to: Vec3,
    frame: f32,
    frame_count: f32,
}

impl Way {
    pub(super) const fn new(reach: f32, least: f32) -> Self {
        Self {
            reach,
            least,
            from: Vec3::ZERO,
            to: Vec3::ZERO,
            frame: 0.0,
            frame_count: 0.0,
        }
    }

    /// Where it is a frame later [m], from where it began.
    pub(super) fn move_on(&mut self, chance: &mut Chance) -> Vec3 {
        if self.frame_count <= self.frame {
            let to = [(); 3].map(|()| chance.between(-self.reach, self.reach));
            (self.from, self.to) = (self.to, Vec3::from_array(to));
            self.frame_count = chance.between(self.least, 40.0).round();
            self.frame = 0.0;
        }
        self.frame += 1.0;
        let share = self.frame / self.frame_count;
        (self.from).lerp(self.to, share * share * (3.0 - 2.0 * share))
    }
}

/// Where the pins go, and how cloth is thrown.
pub(super) struct Drive {
    /// By piece and pin: its home [m], and which way it goes.
    homes: Vec<Vec<(Vec3, usize)>>,
    ways: [Way; 3],
    /// How pins are drawn together towards their middle and let out again; only one number of it counts.
    gather: Option<Way>,
    middle: Vec3,
    /// Frames from one throw to the next.
    pub(super) throw_interval: u32,
    /// Fastest of a wave along each axis [m/s]; 0 for none.
    pub(super) throw_speed: f32,
}

impl Drive {
    pub(super) fn draw(chance: &mut Chance, cloth: &Cloth, about: &mut String) -> Self {
        let homes = cloth.pin_homes();
        let all: Vec<Vec3> = homes.iter().flatten().copied().collect();
        let middle = all.iter().sum::<Vec3>() / all.len().max(1) as f32;
        // Neighbors go the same way: halves across an axis, or all of a piece.
        let axis = usize::from(chance.falls(0.5)) * 2;
        let is_by_piece = 1 < homes.len() && chance.falls(0.6);
        let way_of = |piece: usize, home: &Vec3| {
            if is_by_piece {
                piece % 3
            } else {
                usize::from(middle[axis] < home[axis])
            }
        };
        let homes = homes.iter().enumerate().map(|(piece, homes)| {
            let homes = homes.iter().map(|home| (*home, way_of(piece, home)));
            homes.collect()
        });
        let reach = chance.between(0.02, 0.15);
        let least = chance.between(4.0, 20.0);
        let gather = chance.falls(0.3).then(|| Way::new(1.0, least));
        let throw_speed = if chance.falls(0.8) {
            chance.between(0.3, 4.0)
        } else {
            0.0
        };
        if !all.is_empty() {
            let drawn = if gather.is_some() {
                " and drawn together"
            } else {
                ""
            };
            write!(about, ", {} pins dragged{drawn}", all.len()).expect("a string takes all");
        }
        Self {
            homes: homes.collect(),
            ways: [(); 3].map(|()| Way::new(reach, least)),
            gather,
            middle,
            throw_interval: 5 + u32::from(chance.falls(0.5)) * 8,
            throw_speed,
        }
    }

    /// Where the pins of every piece are a frame later [m].
    pub(super) fn move_on(&mut self, chance: &mut Chance) -> Vec<Vec<Vec3>> {
        let by = self.ways.each_mut().map(|way| way.move_on(chance));
        let gather = self.gather.as_mut();
        // From as far apart as they were to a tenth of it.
        let scale = gather.map_or(1.0, |way| 1.0 - 0.9 * way.move_on(chance).x.abs());
        let middle = self.middle;
        let goal = |(home, way): &(Vec3, usize)| middle + (*home - middle) * scale + by[*way];
        let pieces = self.homes.iter();
        pieces
            .map(|homes| homes.iter().map(goal).collect())
            .collect()
    }
}
