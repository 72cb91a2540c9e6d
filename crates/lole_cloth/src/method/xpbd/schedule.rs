//! The order of the work in a substep: what is done to which rows, and when.
//!
//! Every constraint reaches down a few rows at most, and is solved from the top down. A row is
//! finished with one family as soon as the rows within reach have had their turn, so the next
//! family may begin there before the first has come to the bottom. Done row by row in this
//! staggered way the arithmetic is that of one family after the other over the whole cloth, bit for
//! bit, and a row is still in the nearest cache when the next family wants it.

use crate::constraint::stride::Limit;
use crate::constraint::tether::Tethers;
use crate::{ClothModel, ClothState, SolverConfig};

/// Structural sweeps after the contacts of the cloth with itself: none leaves the springs strained
/// where folds are pressed together, all of them press folds through each other.
const LAST_SWEEPS: u32 = 1;

/// One thing that is done to every row, or to every row and some below it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Stage {
    /// Gravity, drag towards the air, and a straight flight.
    Predict,
    /// Tethers to pins, which lie at most so many rows further down.
    Tether(usize),
    /// Strides down the columns, over so many rows, and their limit.
    ColumnStride(usize, Limit),
    /// Strides along the row: which of the strides, and how many columns it bridges.
    RowStride(usize, u32),
    /// Bending along the row.
    BendAlong,
    /// Bending down the columns.
    BendDown,
    /// Shear and twist of the cells between two rows.
    Cells,
    /// Structural springs along the row.
    SpringsAlong,
    /// Structural springs along the row once more, where cloth is gathered.
    SpringsGathered,
    /// Structural springs down the columns.
    SpringsDown,
    /// Contact with the body, and velocities.
    Finish,
}

impl Stage {
    /// Rows below the first that it changes.
    const fn span(self) -> usize {
        match self {
            Self::ColumnStride(rows, _) => rows,
            Self::BendDown => 2,
            Self::Cells | Self::SpringsDown => 1,
            Self::Predict
            | Self::Tether(_)
            | Self::RowStride(..)
            | Self::BendAlong
            | Self::SpringsAlong
            | Self::SpringsGathered
            | Self::Finish => 0,
        }
    }

    /// Rows below the first that must be finished with what comes before.
    const fn reach(self) -> usize {
        match self {
            Self::Tether(rows) => rows,
            _ => self.span(),
        }
    }
}

/// Stages in their order, each as many rows behind the first as the reaches so far ask for.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Schedule {
    stages: Vec<(Stage, usize)>,
}

impl Schedule {
    /// A single stage.
    pub(crate) fn of(stage: Stage) -> Self {
        let mut schedule = Self::default();
        schedule.push(stage);
        schedule
    }

    /// The stages in their order.
    pub(crate) fn stages(&self) -> impl Iterator<Item = Stage> {
        self.stages.iter().map(|&(stage, _)| stage)
    }

    /// Forgets every stage.
    pub(crate) fn clear(&mut self) {
        self.stages.clear();
    }

    /// Adds the next stage.
    pub(crate) fn push(&mut self, stage: Stage) {
        self.stages.push((stage, self.lag() + stage.reach()));
    }

    /// Rows by which the last stage is behind the first.
    fn lag(&self) -> usize {
        self.stages.last().map_or(0, |&(_, lag)| lag)
    }

    /// Calls with every stage and every row that it starts at, in the staggered order.
    #[inline(always)]
    pub(crate) fn run(&self, row_count: usize, mut work: impl FnMut(Stage, usize)) {
        if self.stages.is_empty() {
            return;
        }
        for time in 0..row_count + self.lag() {
            for &(stage, lag) in &self.stages {
                if let Some(row) = time.checked_sub(lag)
                    && row + stage.span() < row_count
                {
                    work(stage, row);
                }
            }
        }
    }
}

/// A substep in one piece, or cut where the cloth meets itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Part {
    Whole,
    BeforeContact,
    AfterContact,
}

/// Order of the work by [`Part`].
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Schedules([Schedule; 3]);

impl Schedules {
    /// The schedule of a part.
    pub(super) const fn of(&self, part: Part) -> &Schedule {
        &self.0[part as usize]
    }

    /// The schedule of a part, to be set.
    pub(super) const fn of_mut(&mut self, part: Part) -> &mut Schedule {
        &mut self.0[part as usize]
    }
}

/// Orders the work: what reaches farthest first, structural springs last, so that what is drawn is
/// stretched least.
pub(super) fn set_schedules(model: &ClothModel, config: &SolverConfig, state: &mut ClothState) {
    let scratch = &mut state.scratch;
    scratch.row_strides.set(model, config);
    let sweep_count = config.structural_sweep_count.get();
    let last_count = LAST_SWEEPS.min(sweep_count);
    for (part, schedule) in [Part::Whole, Part::BeforeContact, Part::AfterContact]
        .into_iter()
        .zip(&mut scratch.schedules.0)
    {
        schedule.clear();
        let sweeps = match part {
            Part::Whole => sweep_count,
            Part::BeforeContact => sweep_count - last_count,
            Part::AfterContact => last_count,
        };
        if part != Part::AfterContact {
            push_far_and_soft(model, config, schedule);
        }
        for _ in 0..sweeps {
            schedule.push(Stage::SpringsAlong);
            for _ in 0..config.gathered_sweep_count {
                schedule.push(Stage::SpringsGathered);
            }
            schedule.push(Stage::SpringsDown);
        }
        if part != Part::BeforeContact {
            schedule.push(Stage::Finish);
        }
    }
}

fn push_far_and_soft(model: &ClothModel, config: &SolverConfig, schedule: &mut Schedule) {
    schedule.push(Stage::Predict);
    if config.tether_scale.is_some() && model.tethers != Tethers::Loose {
        schedule.push(Stage::Tether(model.tethers.reach()));
    }
    let v = model.spec().grid.spacing[1];
    for &stride in &config.column_strides {
        schedule.push(Stage::ColumnStride(stride as usize, Limit::new(stride, v)));
    }
    for (index, &stride) in config.row_strides.iter().enumerate() {
        schedule.push(Stage::RowStride(index, stride));
    }
    schedule.push(Stage::BendAlong);
    schedule.push(Stage::BendDown);
    schedule.push(Stage::Cells);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What a stage does to a number per row here: it depends on order in every way.
    fn act(values: &mut [f64], stage: Stage, row: usize) {
        let span = stage.span();
        let far = (row + stage.reach()).min(values.len() - 1);
        let sum: f64 = values[row..=row + span].iter().sum::<f64>() + 0.3 * values[far];
        for (place, value) in values[row..=row + span].iter_mut().enumerate() {
            *value = 0.7 * *value + 0.1 * sum * (1.0 + place as f64);
        }
    }

    #[test]
    fn staggered_rows_do_what_one_family_after_the_other_does() {
        let stages = [
            Stage::Predict,
            Stage::Tether(3),
            Stage::ColumnStride(16, Limit::new(1, 1.0)),
            Stage::ColumnStride(4, Limit::new(1, 1.0)),
            Stage::RowStride(0, 4),
            Stage::BendAlong,
            Stage::BendDown,
            Stage::Cells,
            Stage::SpringsAlong,
            Stage::SpringsDown,
            Stage::SpringsAlong,
            Stage::SpringsDown,
            Stage::Finish,
        ];
        for row_count in [3_usize, 4, 5, 16, 17, 50] {
            let start: Vec<f64> = (0..row_count).map(|row| (row * row % 7) as f64).collect();
            let mut apart = start.clone();
            for stage in stages {
                for row in 0..row_count.saturating_sub(stage.span()) {
                    act(&mut apart, stage, row);
                }
            }
            let mut schedule = Schedule::default();
            stages.into_iter().for_each(|stage| schedule.push(stage));
            let mut staggered = start;
            schedule.run(row_count, |stage, row| act(&mut staggered, stage, row));
            assert_eq!(staggered, apart, "{row_count} rows");
        }
    }
}
