//! Whether the elastics of a gathered skirt hold it while she dances.
//!
//! In the simulation they go with the skin. On her, friction carries the skirt: an elastic stretched to a
//! tension `T` around any convex ring presses with `2 π T` in all, whatever the ring's shape, and holds
//! `μ 2 π T`; `lole validate` holds the engine's own friction against the same formula (`waistband`).
//! What it has to hold is what moves the skirt beside its weight, taken from the motion of its center of mass.
//! Where that is more than they hold, the band slides, as a block does on a slope that an earthquake shakes
//! (Newmark 1965): what friction does not take of the pull accelerates it, and friction stops it again.
//! Hips that widen below the band, and cloth that lies on them, help; they are left out, so that what is said
//! to hold does.

use std::collections::VecDeque;
use std::f64::consts::TAU;

use lole_cloth::model::particle_masses;

use crate::{FRAME_SECONDS, Performance};

/// Stiffness of a braided elastic of eight cords in its casing [N] for a stretch to twice its length, an
/// estimate; heavier ones hold more.
const STIFFNESS: f64 = 25.0;
/// Frames on either side over which an acceleration is measured: 0.05 s, within which a band gives way.
const SPAN: usize = 3;
/// How far down a skirt is off the hips that carried it [m].
pub const OFF: f64 = 0.25;
/// How many times what the dance pulls an elastic that is recommended holds.
const MARGIN: f64 = 1.5;

/// Watches how a skirt pulls at its elastics.
#[derive(Debug, Clone, PartialEq)]
pub struct HoldWatch {
    /// Mass of every particle [kg].
    masses: Vec<f32>,
    /// Mass of it all [kg].
    mass: f64,
    /// Of free fall [m/s²].
    gravity: f64,
    /// Height of the center of mass [m] in the last frames, the newest last.
    heights: VecDeque<f64>,
    /// Pull downwards in every frame that was seen from both sides [N].
    pulls: Vec<f64>,
}

/// What the elastics of a skirt hold.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElasticHold {
    /// Strongest pull of the skirt downwards [N]: its weight and what its motion adds.
    pub pull: f64,
    /// What friction under the elastics holds [N].
    pub held: f64,
    /// How far the skirt slides down while she dances [m]; [`OFF`] where it comes off.
    pub slid: f64,
    /// Longest relaxed ring of each elastic that holds half as much again as the skirt pulls [m]; `None` where
    /// no elastic does, not even one that is stretched to twice its length.
    pub loosest_ring: Option<f64>,
}

impl HoldWatch {
    /// Of the skirt that is worn; `None` where none is.
    #[must_use]
    pub fn new(performance: &Performance) -> Option<Self> {
        let skirt = performance.production().skirt()?;
        let masses = particle_masses(&skirt.sewn.spec);
        let mass = masses.iter().map(|&mass| f64::from(mass)).sum::<f64>();
        let gravity = f64::from(performance.gravity().length());
        Some(Self {
            masses,
            mass,
            gravity,
            heights: VecDeque::with_capacity(2 * SPAN + 1),
            pulls: Vec::new(),
        })
    }

    /// Looks at a frame; call it after every one.
    pub fn look(&mut self, performance: &Performance) {
        let Some(skirt) = performance.production().skirt() else {
            return;
        };
        let positions = self.masses.iter().zip(performance.garment_positions(skirt));
        let moments = positions.map(|(&mass, at)| f64::from(mass) * f64::from(at.y));
        self.rise_to(moments.sum::<f64>() / self.mass);
    }

    /// Takes the height of the center of mass [m] in the next frame.
    fn rise_to(&mut self, height: f64) {
        self.heights.push_back(height);
        if self.heights.len() <= 2 * SPAN {
            return;
        }
        let span = SPAN as f64 * f64::from(FRAME_SECONDS);
        let [before, between, now] = [0, SPAN, 2 * SPAN].map(|frame| self.heights[frame]);
        let upwards = (before - 2.0 * between + now) / (span * span);
        self.pulls.push(self.mass * (self.gravity + upwards));
        self.heights.pop_front();
    }

    /// What the elastics hold of the strongest pull that was seen; `None` where there are none.
    #[must_use]
    pub fn seen(&self, performance: &Performance) -> Option<ElasticHold> {
        let skirt = performance.production().skirt()?;
        let rings = skirt.draft.elastic_rows.iter();
        let rings: Vec<f64> = rings.map(|row| row.ring_length.to_m()).collect();
        let friction = f64::from(skirt.sewn.spec.fabric.friction);
        let girth = skirt.worn.worn_girth.to_m();
        let mut hold = elastic_hold(girth, &rings, (friction, self.pull()))?;
        hold.slid = self.slid(hold.held);
        Some(hold)
    }

    /// Strongest pull downwards so far [N], no less than the weight.
    fn pull(&self) -> f64 {
        let weight = self.mass * self.gravity;
        self.pulls.iter().copied().fold(weight, f64::max)
    }

    /// How far friction that holds so much [N] lets the skirt slide [m].
    fn slid(&self, held: f64) -> f64 {
        let dt = f64::from(FRAME_SECONDS);
        let (mut way, mut speed) = (0.0_f64, 0.0_f64);
        for pull in &self.pulls {
            speed = (speed + dt * (pull - held) / self.mass).max(0.0);
            way += dt * speed;
        }
        way.min(OFF)
    }
}

/// What relaxed rings [m] hold around a girth [m], by coefficient of friction and pull [N].
fn elastic_hold(girth: f64, rings: &[f64], (friction, pull): (f64, f64)) -> Option<ElasticHold> {
    if rings.is_empty() {
        return None;
    }
    let tension = |ring: f64| STIFFNESS * (girth / ring - 1.0).max(0.0);
    let held = friction * TAU * rings.iter().map(|&ring| tension(ring)).sum::<f64>();
    let needed = MARGIN * pull / (friction * TAU * rings.len() as f64 * STIFFNESS);
    Some(ElasticHold {
        pull,
        held,
        slid: 0.0,
        loosest_ring: (needed <= 1.0).then(|| girth / (1.0 + needed)),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn elastics_hold_what_friction_under_their_tension_does() {
        // 0.8 m of ring around 1 m: 6.25 N, pressed with 39.3 N, of which friction holds 0.4.
        let hold = elastic_hold(1.0, &[0.8, 0.8], (0.4, 10.0)).unwrap();
        assert!(
            (hold.held - 2.0 * 0.4 * TAU * 6.25).abs() < 1e-9,
            "{hold:?}"
        );
        let ring = hold.loosest_ring.unwrap();
        let just = elastic_hold(1.0, &[ring, ring], (0.4, 10.0)).unwrap();
        assert!((just.held - 15.0).abs() < 1e-9, "{just:?}");
        assert_eq!(
            elastic_hold(1.0, &[0.8], (0.0, 10.0)).unwrap().loosest_ring,
            None
        );
        assert_eq!(elastic_hold(1.0, &[], (0.4, 10.0)), None);
    }

    #[test]
    fn a_skirt_pulls_with_its_weight_and_with_what_lifts_it() {
        let mut watch = HoldWatch {
            masses: Vec::new(),
            mass: 0.5,
            gravity: 10.0,
            heights: VecDeque::new(),
            pulls: Vec::new(),
        };
        (0..20).for_each(|_| watch.rise_to(0.8));
        assert!((watch.pull() - 5.0).abs() < 1e-9, "still: {}", watch.pull());
        // Thrown up with 4 m/s².
        for frame in 0..20 {
            let time = f64::from(frame) * f64::from(FRAME_SECONDS);
            watch.rise_to(0.8 + 2.0 * time * time);
        }
        let pull = watch.pull();
        assert!((pull - 7.0).abs() < 1e-6, "lifted: {pull}");
    }

    #[test]
    fn what_a_pull_is_too_strong_for_slides_until_friction_has_stopped_it() {
        // Half a second of 8 N, then the weight of 5 N, against 6 N: faster by 4 m/s² for 0.5 s, slower by 2 for 1 s.
        let watch = HoldWatch {
            masses: Vec::new(),
            mass: 0.5,
            gravity: 10.0,
            heights: VecDeque::new(),
            pulls: [[8.0; 30].as_slice(), &[5.0; 120]].concat(),
        };
        let exact = 0.5 * 4.0 * 0.5 * 0.5 + 2.0 * 2.0 / (2.0 * 2.0);
        assert!(OFF < exact, "it comes off");
        assert!((watch.slid(6.0) - OFF).abs() < 1e-12);
        // With 7.8 N: faster by 0.4 m/s² for 0.5 s, slower by 5.6 until it stands.
        let slid = watch.slid(7.8);
        let exact = 0.5 * 0.4 * 0.5 * 0.5 + 0.2 * 0.2 / (2.0 * 5.6);
        assert!((slid - exact).abs() < 2.0e-3, "{slid} of {exact}");
        assert!(watch.slid(8.0).abs() < 1e-12, "it holds");
    }

    #[test]
    fn a_ring_as_long_as_the_girth_holds_nothing() {
        for ring in [1.0, 1.2] {
            assert!(elastic_hold(1.0, &[ring], (0.4, 10.0)).unwrap().held.abs() < 1e-12);
        }
    }
}
