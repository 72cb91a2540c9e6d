//! The grid of a gathered rectangle: where its elastics, its folds and its seams fall.

use lole_body::Dancer;
use lole_cloth::{Crimp, Flounce, Grid, Topology};
use lole_geom::{Chance, trig};
use lole_pattern::design::pau_skirt::{PauDraft, PauMeasurements};
use lole_pattern::piece::hem_turns;

use super::profile::Profile;
use super::ring::{Gathers, Ring};
use super::{SewError, SewSettings};

/// Deepest fold of the gathers [m] that still looks gathered: beyond, a fold is one pair of cells
/// that stick out like a cog.
const DEEPEST_FOLD: f32 = 0.04;

/// Rows of the band lie this much closer on the body than in the cloth: cloth between two elastics
/// blouses, it is never tight.
pub(super) const BLOUSING: f32 = 0.96;

/// Cloth below the lowest elastic over which its puckers have flowed into folds [m].
const OPENING: f32 = 0.12;

/// Particles of a gather, at least: with fewer it is a cog that crosses the next one.
const LEAST_FOLD_COLUMNS: u32 = 6;

/// Cloth of a crimped gather, at least, over the ring that it takes.
const LEAST_FULLNESS: f32 = 1.1;

/// The grid and what its rows and columns mean.
pub(super) struct Layout {
    pub(super) grid: Grid,
    pub(super) elastic_rows: Vec<u32>,
    pub(super) row_layers: Vec<f32>,
    /// Cloth around the skirt [m].
    pub(super) flat_length: f32,
    /// Where each fold starts, as a fraction of the ring.
    pub(super) fold_starts: Vec<f32>,
    /// Gap between skin and inner turns [m].
    pub(super) band_gap: f32,
}

impl Layout {
    pub(super) fn new(
        (draft, flounce): (&PauDraft, Option<&PauDraft>),
        worn: &PauMeasurements,
        settings: &SewSettings,
    ) -> Result<Self, SewError> {
        let above = draft.finished_length.to_m_f32();
        let finished = above + flounce.map_or(0.0, |flounce| flounce.finished_length.to_m_f32());
        let flat_length = draft.flat_length.to_m_f32();
        let elastics = |row_count: u32| {
            let spacing = finished / (row_count.max(2) - 1) as f32;
            elastic_rows(draft, row_count, spacing)
        };
        let spacing_v = finished / (settings.row_count.max(2) - 1) as f32;
        let Some(elastic_rows) = elastics(settings.row_count) else {
            return Err(SewError::TooFewRows {
                row_count: settings.row_count,
                elastic_row_count: draft.elastic_rows.len(),
                least: (settings.row_count..=MOST_ROWS).find(|&count| elastics(count).is_some()),
            });
        };
        let fullness = (worn.worn_girth.to_m_f32() / flat_length).min(1.0);
        let least = flat_length * (1.0 - fullness * fullness).sqrt() / DEEPEST_FOLD;
        if (settings.column_count as f32) < least {
            return Err(SewError::TooFewColumns {
                column_count: settings.column_count,
                flat_cm: f64::from(flat_length) * 100.0,
                least: whole_count(least.ceil(), 1.0),
            });
        }
        let grid = Grid {
            column_count: settings.column_count,
            row_count: settings.row_count,
            topology: Topology::Tube,
            spacing: [flat_length / settings.column_count as f32, spacing_v],
            flounce: flounce.map(|flounce| Flounce {
                seam_row: whole_count(above, spacing_v).clamp(1, settings.row_count - 2),
                fullness: (flounce.flat_length.to_m_f32() / flat_length).max(1.0),
            }),
            crimp: None,
        };
        let fold_depth = draft.fold_depth.to_m_f32();
        let hem = flounce.unwrap_or(draft).hem_depth;
        // Its allowance is turned in, so it lies on less cloth than it is deep.
        let hem_height = hem_turns(hem)[1].to_m_f32();
        let hem_layers = hem.to_m_f32() / hem_height.max(f32::MIN_POSITIVE);
        let layers = |row: u32| {
            let from_top = row as f32 * spacing_v;
            let is_seam = grid.flounce.is_some_and(|flounce| flounce.seam_row == row);
            let folded = if from_top < fold_depth || is_seam {
                1.0
            } else {
                0.0
            };
            // Of the lowest row the half below it is not cloth.
            let from_hem = finished - from_top;
            let low = (from_hem - 0.5 * spacing_v).max(0.0);
            let high = from_hem + 0.5 * spacing_v;
            let hemmed = (high.min(hem_height) - low).max(0.0) / (high - low);
            1.0 + folded + hem_layers * hemmed
        };
        let ring_length = worn.worn_girth.to_m_f32();
        let fold_count = whole_count(ring_length, settings.gather_pitch)
            .min(settings.column_count / LEAST_FOLD_COLUMNS)
            .max(8);
        let mut layout = Self {
            grid,
            elastic_rows,
            row_layers: (0..settings.row_count).map(layers).collect(),
            flat_length,
            fold_starts: fold_starts(settings, fold_count),
            band_gap: settings.band_gap,
        };
        layout.crimp(ring_length, settings);
        Ok(layout)
    }

    /// Crimps the band so that gathers around a ring [m] of skin are as deep as is asked for, but never so much
    /// that the widest of uneven gathers has too little cloth.
    pub(super) fn crimp(&mut self, ring: f32, settings: &SewSettings) {
        let ring = ring + std::f32::consts::TAU * self.band_gap;
        let deep = 2.0 * settings.gather_depth * self.fold_starts.len() as f32;
        let widest = 1.0 + LARGEST_UNEVENNESS * settings.unevenness;
        let around = (ring + deep).max(LEAST_FULLNESS * widest * ring);
        let last_row = self.elastic_rows.last().copied().unwrap_or(0);
        self.grid.crimp = (around < self.flat_length).then(|| Crimp {
            share: around / self.flat_length,
            last_row,
            open_row: last_row + whole_count(OPENING, self.grid.spacing[1]).max(1),
        });
    }

    /// Leaves the side open, at her left.
    pub(super) fn open(&mut self) {
        self.grid.topology = Topology::Sheet;
        for start in &mut self.fold_starts {
            *start += LEFT_SIDE;
        }
    }

    /// Those of a row.
    pub(super) fn gathers(&self, row: u32) -> Gathers<'_> {
        Gathers {
            gap: self.band_gap,
            spacing: self.grid.spacing[0] * self.grid.crimp_share(row),
            column_count: self.grid.column_count,
            fold_starts: &self.fold_starts,
        }
    }

    /// Rings for every row down to the lowest elastic, a row's height apart along the skin.
    pub(super) fn band_rings(
        &self,
        dancer: &Dancer,
        worn_height: f32,
        lowest: u32,
    ) -> Result<Vec<Ring>, SewError> {
        let apart = BLOUSING * self.grid.spacing[1];
        let highest = worn_height + lowest as f32 * apart;
        let profile = Profile::new(dancer, worn_height..highest)?;
        let lowest_ring = self.fitting(profile.at(worn_height)?)?;
        let reach = lowest_ring.depth_of(self.gathers(lowest));
        let mut rings = vec![lowest_ring];
        rings.extend(Ring::upward(&profile, worn_height, [apart, reach], lowest)?);
        rings.reverse();
        rings.into_iter().map(|ring| self.fitting(ring)).collect()
    }

    fn fitting(&self, ring: Ring) -> Result<Ring, SewError> {
        let around = ring.girth + std::f32::consts::TAU * self.band_gap;
        if self.flat_length < around {
            return Err(SewError::TooNarrow {
                flat_cm: f64::from(self.flat_length) * 100.0,
                ring_cm: f64::from(around) * 100.0,
            });
        }
        Ok(ring)
    }
}

/// Her left side, as a fraction of the ring from where a skirt's seam is.
const LEFT_SIDE: f32 = 0.25;

/// Rows that a design may ask for.
const MOST_ROWS: u32 = 512;

/// Grid rows that carry elastic; `None` where two fall on one row or too few are left below.
fn elastic_rows(draft: &PauDraft, row_count: u32, spacing: f32) -> Option<Vec<u32>> {
    let rows: Vec<u32> = draft
        .elastic_rows
        .iter()
        .map(|row| whole_count(row.from_fold.to_m_f32(), spacing))
        .collect();
    let rising = rows.windows(2).all(|pair| pair[0] < pair[1]);
    let below = rows.last().map_or(0, |&row| row + 3);
    (rising && below < row_count).then_some(rows)
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a length on the skirt over a row or a fold: below 10,000"
)]
fn whole_count(distance: f32, spacing: f32) -> u32 {
    (distance / spacing).round() as u32
}

/// Where folds start around the ring: evenly, plus a slow random drift that closes.
fn fold_starts(settings: &SewSettings, fold_count: u32) -> Vec<f32> {
    const WAVES: [f32; 6] = [2.0, 3.0, 5.0, 7.0, 11.0, 17.0];
    let mut chance = Chance::new(settings.seed ^ 0x9e37_79b9_7f4a_7c15);
    let shifts = WAVES.map(|_| chance.fine_share());
    let strengths = WAVES.map(|_| 0.5 + chance.fine_share());
    let drift = |around: f32| -> f32 {
        let wave = |((wave, shift), strength): ((f32, f32), f32)| {
            // Each wave changes the local pitch by the same share, whatever its length.
            strength / wave * trig::sin(std::f32::consts::TAU * (wave * around + shift))
        };
        WAVES.into_iter().zip(shifts).zip(strengths).map(wave).sum()
    };
    let first = drift(0.0);
    (0..fold_count)
        .map(|fold| {
            let around = fold as f32 / fold_count as f32;
            around + LARGEST_DRIFT * settings.unevenness * (drift(around) - first)
        })
        .collect()
}

/// Drift of the folds at an unevenness of 1, in rings over waves: six waves of strength up to 1.5
/// change the pitch by at most `6 · 1.5 · 2π · 0.015 = 85 %`, so folds never change places.
const LARGEST_DRIFT: f32 = 0.015;
const LARGEST_UNEVENNESS: f32 = 0.85;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folds_stay_in_order_for_any_seed() {
        for seed in 0..200 {
            let settings = SewSettings {
                seed,
                unevenness: 1.0,
                ..SewSettings::default()
            };
            let starts = fold_starts(&settings, 52);
            assert!(
                starts.windows(2).all(|pair| pair[0] < pair[1]),
                "seed {seed}"
            );
            assert!(starts[51] < 1.0 + starts[0]);
        }
    }
}
