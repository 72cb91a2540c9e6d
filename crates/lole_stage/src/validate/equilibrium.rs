//! How a round sheet rests on a disc: the least energy of a plate that hardly stretches, found without time.
//!
//! Nothing is shared with the engine. The sheet is a net of rings and rays in `f64`, whose slopes and second
//! derivatives are central differences in polar coordinates, exact for every flat sheet. Its energy is that of
//! the fabric: `½ (Y_u (|f_u| - 1)² + Y_v (|f_v| - 1)² + G (f_u·f_v)²)` of stretch, `½ (B_u |x_uu|² +
//! B_v |x_vv|² + 2 B_t |x_uv|²)` of bending (which for a sheet that does not stretch is that of its curvatures),
//! and weight. Newton's method brings it down, the stretch's part of the matrix cut
//! to what is positive. Such sheets have several rests; where one ends depends on the folds that it begins with.

use std::f64::consts::TAU;

use glam::{DMat3, DVec3};
use lole_cloth::Fabric;
use lole_cloth::drape_test::{Hung, RoundDrape};
use lole_geom::trig64;

use super::banded::Banded;

/// Cells from the disc to the edge, and around.
pub(super) const RINGS: usize = 10;
pub(super) const RAYS: usize = 72;
/// Height of the folds that it begins with at the edge [m].
const SEED: f64 = 0.01;
/// Newton steps at most.
const STEPS: usize = 80;
/// Unbalanced force over weight at which it rests.
const BALANCED: f64 = 2.0e-3;

/// Second derivatives along warp, weft and both at a point, by its neighbors, times the roots of what resists.
struct Bending {
    nodes: [usize; 9],
    weights: [[f64; 9]; 3],
}

/// Slopes along warp and weft in the middle of a cell, by its corners, and its area [m²].
struct Cell {
    nodes: [usize; 4],
    slopes: [[f64; 4]; 2],
    area: f64,
}

/// A sheet on a disc.
pub(super) struct Sheet {
    drape: RoundDrape,
    bendings: Vec<Bending>,
    cells: Vec<Cell>,
    stretch: [f64; 2],
    shear: f64,
    /// Of every node [N].
    weights: Vec<f64>,
}

/// How it rests.
pub(super) struct Rest {
    pub(super) hung: Hung,
    /// Energy [J], by which one rest is likelier than another.
    pub(super) energy: f64,
}

/// Index of a node.
const fn node(ring: usize, ray: usize) -> usize {
    ring * RAYS + ray % RAYS
}

impl Sheet {
    /// A sheet of a fabric.
    pub(super) fn new(drape: RoundDrape, fabric: &Fabric, gravity: f64) -> Self {
        let [disc, specimen] = [drape.disc, drape.specimen].map(f64::from);
        let net = Net {
            disc,
            height: (specimen - disc) / RINGS as f64,
            turn: TAU / RAYS as f64,
        };
        let bend = [fabric.bend[0], fabric.bend[1], 2.0 * fabric.twist].map(f64::from);
        let rings = 0..=RINGS;
        let places = rings.flat_map(|ring| (0..RAYS).map(move |ray| (ring, ray)));
        let bendings = places.clone().map(|place| net.bending(place, bend));
        let cells = places
            .clone()
            .filter(|(ring, _)| *ring < RINGS)
            .map(|(ring, ray)| net.cell(ring, ray));
        let weight = f64::from(fabric.areal_density) * gravity;
        Self {
            drape,
            bendings: bendings.collect(),
            cells: cells.collect(),
            stretch: fabric.stretch.map(f64::from),
            shear: f64::from(fabric.shear),
            weights: places.map(|(ring, _)| weight * net.area(ring)).collect(),
        }
    }

    /// Where it rests if it begins with so many folds.
    pub(super) fn rest(&self, folds: u32) -> Rest {
        let [disc, specimen] = [self.drape.disc, self.drape.specimen].map(f64::from);
        let mut positions = Vec::new();
        for ring in 0..=RINGS {
            let share = ring as f64 / RINGS as f64;
            let radius = disc + share * (specimen - disc);
            for ray in 0..RAYS {
                let (sin, cos) = trig64::sin_cos(ray as f64 * TAU / RAYS as f64);
                let wave = trig64::cos(f64::from(folds) * TAU * ray as f64 / RAYS as f64 + 0.4);
                positions.push(DVec3::new(
                    radius * cos,
                    SEED * share * share * wave,
                    radius * sin,
                ));
            }
        }
        let mut energy = self.energy(&positions);
        let total: f64 = self.weights.iter().sum();
        for _ in 0..STEPS {
            let forces = self.forces(&positions);
            let unbalanced = norm(&forces) * (forces.len() as f64).sqrt() / total;
            if unbalanced < BALANCED {
                break;
            }
            let way = self.newton(&positions, &forces);
            let slope = dot(&way, &forces);
            // A step no longer than a cell turns no cell inside out.
            let longest = way.iter().map(|step| step.length()).fold(0.0, f64::max);
            let mut share = (0.004 / longest).min(1.0);
            let tried = loop {
                let tried: Vec<DVec3> = (positions.iter().zip(&way))
                    .map(|(place, step)| place + step * share)
                    .collect();
                let found = self.energy(&tried);
                if found <= energy - 1.0e-4 * share * slope || share < 1.0e-6 {
                    energy = found;
                    break tried;
                }
                share *= 0.5;
            };
            positions = tried;
        }
        let hem = positions[RINGS * RAYS..]
            .iter()
            .map(|place| place.as_vec3());
        Rest {
            hung: self.drape.hung(&hem.collect::<Vec<_>>()),
            energy,
        }
    }

    fn energy(&self, positions: &[DVec3]) -> f64 {
        let bending = self.bendings.iter().flat_map(|bending| {
            (bending.weights.iter())
                .map(|weights| 0.5 * mix(weights, &bending.nodes, positions).length_squared())
        });
        let stretch = self.cells.iter().map(|cell| {
            let [warp, weft] = cell
                .slopes
                .map(|weights| mix(&weights, &cell.nodes, positions));
            let [a, b] = [warp, weft].map(|slope| slope.length() - 1.0);
            let shear = warp.dot(weft);
            0.5 * cell.area
                * (self.stretch[0] * a * a + self.stretch[1] * b * b + self.shear * shear * shear)
        });
        let weight = (self.weights.iter().zip(positions)).map(|(weight, place)| weight * place.y);
        bending.sum::<f64>() + stretch.sum::<f64>() + weight.sum::<f64>()
    }

    /// What pulls at every node [N]; nothing on the disc.
    fn forces(&self, positions: &[DVec3]) -> Vec<DVec3> {
        let mut forces: Vec<DVec3> = (self.weights.iter())
            .map(|weight| DVec3::NEG_Y * *weight)
            .collect();
        for bending in &self.bendings {
            for weights in &bending.weights {
                let bent = mix(weights, &bending.nodes, positions);
                spread(&mut forces, weights, &bending.nodes, -bent);
            }
        }
        for cell in &self.cells {
            let [warp, weft] = cell
                .slopes
                .map(|weights| mix(&weights, &cell.nodes, positions));
            let shear = self.shear * warp.dot(weft);
            let pulls = [(warp, weft, 0), (weft, warp, 1)].map(|(own, other, way)| {
                let stretch = self.stretch[way] * (1.0 - 1.0 / own.length());
                (own * stretch + other * shear) * -cell.area
            });
            for (weights, pull) in cell.slopes.iter().zip(pulls) {
                spread(&mut forces, weights, &cell.nodes, pull);
            }
        }
        hold(&mut forces);
        forces
    }

    /// Newton's step.
    fn newton(&self, positions: &[DVec3], forces: &[DVec3]) -> Vec<DVec3> {
        let mut matrix = Banded::new();
        for bending in &self.bendings {
            for weights in &bending.weights {
                matrix.add_all(&bending.nodes, |[one, other]| {
                    DMat3::from_diagonal(DVec3::splat(weights[one] * weights[other]))
                });
            }
        }
        for cell in &self.cells {
            self.stretch_in(cell, positions, &mut matrix);
        }
        matrix.solve(forces)
    }

    /// Adds what stretch and shear of a cell resist.
    fn stretch_in(&self, cell: &Cell, positions: &[DVec3], matrix: &mut Banded) {
        let [warp, weft] = cell
            .slopes
            .map(|weights| mix(&weights, &cell.nodes, positions));
        let across = |one: DVec3, other: DVec3| {
            DMat3::from_cols(one * other.x, one * other.y, one * other.z)
        };
        let pull = |slope: DVec3, other: DVec3, stiffness: f64| {
            let length = slope.length();
            let along = slope / length;
            let along = across(along, along);
            // What is pressed together is stiff along itself only.
            let tension = (1.0 - 1.0 / length).max(0.0);
            let stretch = along + (DMat3::IDENTITY - along) * tension;
            stretch * stiffness + across(other, other) * self.shear
        };
        let own = [
            pull(warp, weft, self.stretch[0]),
            pull(weft, warp, self.stretch[1]),
        ];
        let both = across(weft, warp) * self.shear;
        matrix.add_all(&cell.nodes, |[one, other]| {
            let [a, b] = cell.slopes.map(|weights| weights[one]);
            let [c, d] = cell.slopes.map(|weights| weights[other]);
            let mixed = both * (a * d) + both.transpose() * (b * c);
            (own[0] * (a * c) + own[1] * (b * d) + mixed) * cell.area
        });
    }
}

/// The net of rings and rays: the radius of the first ring [m], from ring to ring [m], from ray to ray [rad].
#[derive(Clone, Copy)]
struct Net {
    disc: f64,
    height: f64,
    turn: f64,
}

impl Net {
    fn radius(self, ring: usize) -> f64 {
        self.disc + ring as f64 * self.height
    }

    /// What belongs to a node [m²].
    fn area(self, ring: usize) -> f64 {
        let share = if ring == 0 || ring == RINGS { 0.5 } else { 1.0 };
        share * self.radius(ring) * self.height * self.turn
    }

    /// At the disc only the ray bends, which leaves it level; the free edge is not bent across.
    fn bending(self, (ring, ray): (usize, usize), bend: [f64; 3]) -> Bending {
        let (h, r) = (self.height, self.radius(ring));
        let (sin, cos) = trig64::sin_cos(self.turn);
        // Rings that are looked at: below, here, above; at the edge here and the two below.
        let first = ring
            .saturating_sub(if ring == RINGS { 2 } else { 1 })
            .min(RINGS - 2);
        let nodes = std::array::from_fn(|place| {
            node((first + place / 3).min(RINGS), ray + RAYS - 1 + place % 3)
        });
        let slope = match ring {
            0 => [0.0; 3],
            RINGS => [0.5 / h, -2.0 / h, 1.5 / h],
            _ => [-0.5 / h, 0.0, 0.5 / h],
        };
        let here = if ring == RINGS { 2 } else { 1 };
        let mut along = [0.0; 9];
        let mut both = [0.0; 9];
        let mut around = [0.0; 9];
        if ring == 0 {
            along = self.clamped();
        } else {
            for row in 0..3 {
                around[3 * row + 1] += slope[row] / r;
                both[3 * row] -= slope[row] / (2.0 * sin * r);
                both[3 * row + 2] += slope[row] / (2.0 * sin * r);
            }
            let across = 1.0 / (2.0 * (1.0 - cos) * r * r);
            for (place, weight) in [(0, across), (1, -2.0 * across), (2, across)] {
                around[3 * here + place] += weight;
            }
            both[3 * here] += 1.0 / (2.0 * sin * r * r);
            both[3 * here + 2] -= 1.0 / (2.0 * sin * r * r);
            if ring < RINGS {
                for (row, weight) in [1.0, -2.0, 1.0].into_iter().enumerate() {
                    along[3 * row + 1] = weight / (h * h);
                }
            }
        }
        let (s, c) = trig64::sin_cos(ray as f64 * self.turn);
        let root = bend.map(|bend| (bend * self.area(ring)).sqrt());
        let turned = |place: usize| {
            let [a, b, m] = [along[place], around[place], both[place]];
            [
                root[0] * (c * c * a - 2.0 * c * s * m + s * s * b),
                root[1] * (s * s * a + 2.0 * c * s * m + c * c * b),
                root[2] * (c * s * (a - b) + (c * c - s * s) * m),
            ]
        };
        let weights = std::array::from_fn(|way| std::array::from_fn(|place| turned(place)[way]));
        Bending { nodes, weights }
    }

    /// `2 (x₁ - x₀ - h e_r) / h²`: the ray leaves the disc level. If it went on so, the first ring would lie at
    /// `r₁ / r₀` times the disc's edge.
    fn clamped(self) -> [f64; 9] {
        let h = self.height;
        let mut weights = [0.0; 9];
        weights[4] = 2.0 / (h * h);
        weights[1] = -2.0 / (h * h) * self.radius(1) / self.radius(0);
        weights
    }

    fn cell(self, ring: usize, ray: usize) -> Cell {
        let middle = self.radius(ring) + 0.5 * self.height;
        let (half_sin, half_cos) = trig64::sin_cos(0.5 * self.turn);
        let outward = 0.5 / (self.height * half_cos);
        let around = 0.5 / (middle * 2.0 * half_sin);
        let (s, c) = trig64::sin_cos((ray as f64 + 0.5) * self.turn);
        // Here and the next ray of this ring, then of the next.
        let slopes = [-outward, -outward, outward, outward];
        let turns = [-around, around, -around, around];
        let mixed = |along: f64, across: f64| {
            std::array::from_fn(|place| along * slopes[place] + across * turns[place])
        };
        Cell {
            nodes: [
                node(ring, ray),
                node(ring, ray + 1),
                node(ring + 1, ray),
                node(ring + 1, ray + 1),
            ],
            slopes: [mixed(c, -s), mixed(s, c)],
            area: middle * self.height * self.turn,
        }
    }
}

fn mix(weights: &[f64], nodes: &[usize], positions: &[DVec3]) -> DVec3 {
    (weights.iter().zip(nodes))
        .map(|(weight, &node)| positions[node] * *weight)
        .sum()
}

fn spread(all: &mut [DVec3], weights: &[f64], nodes: &[usize], value: DVec3) {
    for (weight, &node) in weights.iter().zip(nodes) {
        all[node] += value * *weight;
    }
}

/// The edge of the disc does not move.
fn hold(all: &mut [DVec3]) {
    all[..RAYS].fill(DVec3::ZERO);
}

fn dot(one: &[DVec3], other: &[DVec3]) -> f64 {
    one.iter()
        .zip(other)
        .map(|(one, other)| one.dot(*other))
        .sum()
}

fn norm(all: &[DVec3]) -> f64 {
    dot(all, all).sqrt()
}
