//! What was wished before: a step back for every movement of the hand.

use std::collections::VecDeque;

/// Steps that are kept.
const MOST_STEPS: usize = 200;

/// States before and after the present one, which is kept elsewhere.
#[derive(Debug, Clone)]
pub(crate) struct Undo<T> {
    /// Oldest first.
    past: VecDeque<T>,
    /// What was taken back, the next one last.
    future: Vec<T>,
    /// Whether the hand that began the last step is still at it.
    is_open: bool,
}

impl<T> Default for Undo<T> {
    fn default() -> Self {
        Self {
            past: VecDeque::new(),
            future: Vec::new(),
            is_open: false,
        }
    }
}

impl<T> Undo<T> {
    /// States from the oldest on, and those that were taken back, the next one last.
    pub(crate) fn of(past: Vec<T>, future: Vec<T>) -> Self {
        Self {
            past: past.into(),
            future,
            is_open: false,
        }
    }

    /// Notes that the present state is about to change; it is kept if this begins a step.
    pub(crate) fn begin(&mut self, present: impl FnOnce() -> T) {
        if self.is_open {
            return;
        }
        if self.past.len() == MOST_STEPS {
            self.past.pop_front();
        }
        self.past.push_back(present());
        self.future.clear();
        self.is_open = true;
    }

    /// Ends the step; whether there was one.
    pub(crate) const fn end(&mut self) -> bool {
        std::mem::replace(&mut self.is_open, false)
    }

    /// The state before the present one.
    pub(crate) fn back(&mut self, present: T) -> Option<T> {
        self.is_open = false;
        let before = self.past.pop_back()?;
        self.future.push(present);
        Some(before)
    }

    /// The state that was taken back last.
    pub(crate) fn forward(&mut self, present: T) -> Option<T> {
        self.is_open = false;
        let after = self.future.pop()?;
        self.past.push_back(present);
        Some(after)
    }

    /// Forgets the last step, if it began with a state such as this one.
    pub(crate) fn forget(&mut self, is_this: impl FnOnce(&T) -> bool) -> Option<T> {
        self.is_open = false;
        let last = self.past.back();
        last.is_some_and(is_this).then(|| self.past.pop_back())?
    }

    /// States before the present one, the oldest first.
    pub(crate) const fn past(&self) -> &VecDeque<T> {
        &self.past
    }

    /// States that were taken back, the next one last.
    pub(crate) fn future(&self) -> &[T] {
        &self.future
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_drag_is_one_step_and_every_step_comes_back_both_ways() {
        let mut undo = Undo::default();
        let mut present = 0;
        for value in [1, 2, 3] {
            undo.begin(|| present);
            present = value;
        }
        assert!(undo.end() && !undo.end());
        undo.begin(|| present);
        present = 9;
        undo.end();
        let mut seen = Vec::new();
        while let Some(before) = undo.back(present) {
            present = before;
            seen.push(present);
        }
        assert_eq!(seen, [3, 0]);
        while let Some(after) = undo.forward(present) {
            present = after;
            seen.push(present);
        }
        assert_eq!(seen, [3, 0, 3, 9]);
    }

    #[test]
    fn a_new_step_forgets_what_was_taken_back_and_the_oldest_step_goes_first() {
        let mut undo = Undo::default();
        for value in 0..=MOST_STEPS {
            undo.begin(|| value);
            undo.end();
        }
        assert_eq!(undo.past().front(), Some(&1));
        let back = undo.back(MOST_STEPS + 1);
        assert_eq!(back, Some(MOST_STEPS));
        undo.begin(|| MOST_STEPS);
        assert!(undo.future().is_empty());
    }
}
