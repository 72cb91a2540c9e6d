//! Chains of joints around the hips, and what of the cloth each carries.

use glam::Vec3;
use lole_geom::trig;

use super::rest::Hanging;

/// Chains around the hips.
pub(super) const SECTORS: usize = 16;
/// Joints of a chain that turn; one more ends it.
pub(super) const LEVELS: usize = 4;
/// Joints of a chain, its end included.
pub(super) const NODES: usize = LEVELS + 1;

/// What carries a vertex: a chain and a joint of it, `None` for the hips, and its share.
pub(super) type Carriers = [(Option<(usize, usize)>, f32); 4];

/// Chains at rest.
pub(super) struct Chains {
    /// Joints of each chain from the hips down [m]; the last is the hem's.
    pub(super) rest: Vec<[Vec3; NODES]>,
    /// Hanging vertices, surface by surface, at rest [m].
    pub(super) vertices: Vec<Vec3>,
    /// What carries each of them.
    pub(super) carriers: Vec<Carriers>,
    /// Vertices about each joint, by chain and joint.
    pub(super) near: Vec<[Vec<usize>; NODES]>,
    hips: Vec3,
    hem: f32,
}

impl Chains {
    pub(super) fn new(hanging: &Hanging, hips: Vec3) -> Self {
        let surfaces = hanging.surfaces.iter();
        let vertices: Vec<Vec3> = surfaces.flat_map(|it| it.rest.iter().copied()).collect();
        let hem = vertices.iter().map(|it| it.y).fold(hips.y - 0.1, f32::min);
        let mut chains = Self {
            rest: Vec::new(),
            carriers: Vec::new(),
            near: vec![Default::default(); SECTORS],
            vertices,
            hips,
            hem,
        };
        for (vertex, &place) in chains.vertices.iter().enumerate() {
            let (around, down) = chains.place(place);
            let sector = wrapped(around.round());
            let node = index(down.round()).min(LEVELS);
            chains.near[sector][node].push(vertex);
        }
        chains.rest = (0..SECTORS).map(|sector| chains.joints(sector)).collect();
        chains.carriers = (chains.vertices.iter())
            .map(|&place| chains.carried(place))
            .collect();
        chains
    }

    /// Whether anything hangs.
    pub(super) const fn is_empty(&self) -> bool {
        self.vertices.is_empty()
    }

    /// Place around the hips in sectors, and down from them in levels.
    fn place(&self, point: Vec3) -> (f32, f32) {
        let off = point - self.hips;
        let turn = trig::atan2(off.x, off.z) / std::f32::consts::TAU;
        let down = (self.hips.y - point.y) / (self.hips.y - self.hem);
        (
            turn.rem_euclid(1.0) * SECTORS as f32,
            down.clamp(0.0, 1.0) * LEVELS as f32,
        )
    }

    /// Joints of a chain: amid the cloth at their level, or where the joint above them is from the axis.
    fn joints(&self, sector: usize) -> [Vec3; NODES] {
        let turn = sector as f32 / SECTORS as f32 * std::f32::consts::TAU;
        let (sin, cos) = trig::sin_cos(turn);
        let mut radius = 0.15;
        let mut node = 0;
        [(); NODES].map(|()| {
            let near = self.near[sector][node].iter();
            let radii: Vec<f32> = near
                .map(|&vertex| (self.vertices[vertex] - self.hips).with_y(0.0).length())
                .collect();
            if !radii.is_empty() {
                radius = radii.iter().sum::<f32>() / radii.len() as f32;
            }
            let down = node as f32 / LEVELS as f32;
            node += 1;
            let height = self.hips.y + down * (self.hem - self.hips.y);
            Vec3::new(
                self.hips.x + radius * sin,
                height,
                self.hips.z + radius * cos,
            )
        })
    }

    /// What carries a place: the two chains beside it, and of each the joint above it with the one before, so that
    /// chains bend smoothly.
    pub(super) fn carried(&self, point: Vec3) -> Carriers {
        let (around, down) = self.place(point);
        let share = around.fract();
        let (first, second) = (wrapped(around.floor()), wrapped(around.floor() + 1.0));
        let along = down - 0.5;
        let lower = along - along.floor();
        let joint = index((along + 1.0).floor());
        let of = |chain: usize, joint: usize| match joint {
            0 => None,
            joint => Some((chain, (joint - 1).min(LEVELS - 1))),
        };
        [
            (of(first, joint), (1.0 - share) * (1.0 - lower)),
            (of(first, joint + 1), (1.0 - share) * lower),
            (of(second, joint), share * (1.0 - lower)),
            (of(second, joint + 1), share * lower),
        ]
    }
}

/// A place around the hips as a sector.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "brought between 0 and 16"
)]
fn wrapped(around: f32) -> usize {
    around.rem_euclid(SECTORS as f32) as usize % SECTORS
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a level, from 0 to 5"
)]
fn index(level: f32) -> usize {
    level.max(0.0) as usize
}
