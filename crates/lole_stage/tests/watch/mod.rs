//! Cloth watched frame by frame for crossings, by exact predicates and a search that share nothing with the
//! engine: what its start had already, and what came to be.
#![allow(dead_code, reason = "every test file uses some of it")]

use std::collections::BTreeSet;
use std::fmt;

use glam::Vec3;
use lole_cloth::Grid;
use lole_stage::Performance;

use crate::exact_support::{Pair, Surface, Touching};

/// Pairs that are told of a cloth, at most.
const TOLD: usize = 4;

/// One cloth.
pub(crate) struct Watch {
    name: String,
    column_count: u32,
    surface: Surface,
    frame: u32,
    /// What crosses at the start.
    at_start: BTreeSet<Pair>,
    /// What crosses now.
    now: Vec<Pair>,
    /// The last frame in which something crossed that did so at the start.
    last_of_start: Option<u32>,
    /// Frames that end with a crossing and began without one: the promise was broken.
    pub(crate) broken: Vec<(u32, Vec<Pair>)>,
    /// Frames in which something crosses that did not at the start, and all such pairs.
    new_frame_count: u32,
    new_pairs: BTreeSet<Pair>,
    /// The first such pairs, with their frames.
    first_new: Vec<(u32, Pair)>,
}

impl Watch {
    /// Begins with the places of a grid's particles [m] at its start.
    pub(crate) fn new(name: &str, grid: &Grid, positions: &[Vec3]) -> Self {
        let mut surface = Surface::new(&grid.triangles(), positions);
        let now = surface.crossings(positions, Touching::IsFine);
        Self {
            name: name.to_owned(),
            column_count: grid.column_count,
            surface,
            frame: 0,
            last_of_start: (!now.is_empty()).then_some(0),
            at_start: now.iter().copied().collect(),
            now,
            broken: Vec::new(),
            new_frame_count: 0,
            new_pairs: BTreeSet::new(),
            first_new: Vec::new(),
        }
    }

    /// The garments of a performance, as they are now.
    pub(crate) fn all(performance: &Performance) -> Vec<Self> {
        let garments = performance.production().garments.iter();
        let watch = garments.map(|garment| {
            let positions = performance.garment_positions(garment);
            Self::new(&garment.name, &garment.sewn.spec.grid, positions)
        });
        watch.collect()
    }

    /// Looks at all of them after a frame.
    pub(crate) fn look_at_all(watches: &mut [Self], performance: &Performance) {
        for (watch, garment) in watches.iter_mut().zip(&performance.production().garments) {
            watch.look(performance.garment_positions(garment));
        }
    }

    /// Looks at the end of the next frame, where the particles are at `positions` [m].
    pub(crate) fn look(&mut self, positions: &[Vec3]) {
        self.frame += 1;
        let began_clean = self.now.is_empty();
        self.now = self.surface.crossings(positions, Touching::IsFine);
        if self.now.is_empty() {
            return;
        }
        if began_clean {
            self.broken.push((self.frame, self.now.clone()));
        }
        let new: Vec<Pair> = (self.now.iter())
            .filter(|pair| !self.at_start.contains(*pair))
            .copied()
            .collect();
        if new.len() < self.now.len() {
            self.last_of_start = Some(self.frame);
        }
        self.new_frame_count += u32::from(!new.is_empty());
        for pair in new {
            if self.new_pairs.insert(pair) && self.first_new.len() < TOLD {
                self.first_new.push((self.frame, pair));
            }
        }
    }

    /// Whether nothing has ever crossed that did not at the start.
    pub(crate) fn is_clean(&self) -> bool {
        self.new_pairs.is_empty()
    }

    /// A particle as its row and column.
    fn place(&self, particle: u32) -> String {
        let (row, column) = (particle / self.column_count, particle % self.column_count);
        format!("{row}.{column}")
    }

    /// A pair as the rows and columns of its edge and of its triangle.
    fn pair_words(&self, (edge, corners): &Pair) -> String {
        let [edge, corners] = [&edge[..], &corners[..]].map(|particles| {
            let places: Vec<_> = particles.iter().map(|&it| self.place(it)).collect();
            places.join(" ")
        });
        format!("({edge}) through ({corners})")
    }
}

impl fmt::Display for Watch {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, frame, .. } = self;
        write!(
            out,
            "{name}: {frame} frames, {} at the start",
            self.at_start.len()
        )?;
        if let Some(last) = self.last_of_start {
            write!(out, " (the last until frame {last})")?;
        }
        if !self.is_clean() {
            let (pairs, frames) = (self.new_pairs.len(), self.new_frame_count);
            write!(out, ", {pairs} new pairs in {frames} frames")?;
        }
        for (frame, pair) in &self.first_new {
            write!(out, "; frame {frame}: {}", self.pair_words(pair))?;
        }
        if self.broken.is_empty() {
            return write!(out, ", kept");
        }
        write!(out, ", BROKEN in {} frames", self.broken.len())?;
        for (frame, pairs) in self.broken.iter().take(TOLD) {
            let first = pairs.first().map(|pair| self.pair_words(pair));
            let first = first.unwrap_or_default();
            write!(out, "; frame {frame}: {} pairs, first {first}", pairs.len())?;
        }
        Ok(())
    }
}
