//! Whether a frame has the time to take back what cloth has gone through of itself: as long as the
//! machine keeps pace with it. Asked where the design wants that in time only.
//!
//! To repair in some of the frames and not in others is no way between: what is tangled goes without
//! contact until it is drawn out, and tangles more.

/// Share of a frame's time up to which repaired frames go on.
const MOST: f64 = 0.9;
/// Share of it from which on they begin again: less, so that it does not go to and fro.
const LEAST: f64 = 0.7;
/// Weight of the newest cost in the running mean.
const NEWEST: f64 = 0.05;
/// Frames from one change to the next, at least: until the mean is of the new way.
const SETTLED: u32 = 60;
/// Cost of a repaired frame over that of one which is not, until both were seen.
const USUAL_RATIO: f64 = 1.3;

/// How it has gone so far.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Repair {
    is_on: bool,
    /// Mean cost of a frame as they are now [s]; 0 before the first.
    cost: f64,
    /// Cost of the last repaired frames [s]; 0 before they were given up.
    repaired_cost: f64,
    ratio: f64,
    /// Frames since the last change.
    frames: u32,
}

impl Default for Repair {
    fn default() -> Self {
        Self {
            is_on: true,
            cost: 0.0,
            repaired_cost: 0.0,
            ratio: USUAL_RATIO,
            frames: 0,
        }
    }
}

impl Repair {
    /// Whether the next frame repairs.
    pub(super) const fn is_on(&self) -> bool {
        self.is_on
    }

    /// Notes what a frame cost [s], when there is one in `period` [s].
    pub(super) fn note(&mut self, cost: f64, period: f64) {
        if self.cost == 0.0 {
            self.cost = cost;
        }
        self.cost += NEWEST * (cost - self.cost);
        self.frames += 1;
        if self.frames < SETTLED {
            return;
        }
        if self.is_on && MOST * period < self.cost {
            self.repaired_cost = self.cost;
            self.change();
        } else if !self.is_on {
            if self.frames == SETTLED && 0.0 < self.cost {
                self.ratio = (self.repaired_cost / self.cost).max(1.0);
            }
            if self.cost * self.ratio < LEAST * period {
                self.change();
            }
        }
    }

    const fn change(&mut self) {
        self.is_on = !self.is_on;
        (self.cost, self.frames) = (0.0, 0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PERIOD: f64 = 1.0 / 60.0;

    /// Repaired frames among the next 1,200, and changes, with frames of these costs [s].
    fn danced(repair: &mut Repair, plain: f64, repaired: f64) -> (u32, u32) {
        let (mut count, mut changes) = (0, 0);
        for _ in 0..1200 {
            let was_on = repair.is_on();
            count += u32::from(was_on);
            repair.note(if was_on { repaired } else { plain }, PERIOD);
            changes += u32::from(was_on != repair.is_on());
        }
        (count, changes)
    }

    #[test]
    fn a_quick_machine_repairs_in_every_frame() {
        assert_eq!(danced(&mut Repair::default(), 0.008, 0.011), (1200, 0));
    }

    #[test]
    fn a_slow_one_gives_it_up_and_does_not_go_to_and_fro() {
        for repaired in [0.016, 0.030] {
            let found = danced(&mut Repair::default(), 0.011, repaired);
            assert_eq!(found, (SETTLED, 1));
        }
    }

    #[test]
    fn one_that_becomes_quick_again_takes_it_up_again() {
        let mut repair = Repair::default();
        danced(&mut repair, 0.020, 0.026);
        assert!(!repair.is_on());
        let (count, changes) = danced(&mut repair, 0.006, 0.008);
        assert!(1000 < count && changes == 1, "{count}, {changes}");
    }
}
