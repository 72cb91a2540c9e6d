//! Threads that wait by looking for work, and not by sleeping.
//!
//! What a frame shares among threads comes in hundreds of pieces of a few tens of microseconds, and to wake a
//! thread that has gone to sleep takes about fifty. While one frame is worked out the other threads of its pool
//! look for pieces without a pause, and offer the processor to other programs in between.

use std::hint;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;

use rayon::Yield;

/// Threads that work on one frame at most, the first one included: what is shared is half of a frame, so more
/// would mostly look.
const TOGETHER: usize = 4;

/// Looks in vain before the processor is offered to other programs.
const PATIENCE: u32 = 64;

/// Whether some frame keeps threads awake already: of several at a time each has work for one thread.
static IS_KEPT: AtomicBool = AtomicBool::new(false);

/// Sets a flag to a value at its end, whatever happens.
struct AtEnd<'a>(&'a AtomicBool, bool);

impl Drop for AtEnd<'_> {
    fn drop(&mut self) {
        self.0.store(self.1, Ordering::Release);
    }
}

/// Does some work while up to three more threads of the pool that it is called in stay awake for what the work
/// shares. Outside of a pool, in a pool of one thread and within another call it is the work alone. What comes
/// out is the same.
pub fn keep_awake<R>(work: impl FnOnce() -> R) -> R {
    let more = rayon::current_num_threads().min(TOGETHER) - 1;
    let Some(own) = rayon::current_thread_index().filter(|_| 0 < more) else {
        return work();
    };
    if IS_KEPT.swap(true, Ordering::AcqRel) {
        return work();
    }
    let _kept = AtEnd(&IS_KEPT, false);
    let is_done = &AtomicBool::new(false);
    rayon::in_place_scope(|scope| {
        for _ in 0..more {
            scope.spawn(move |_| {
                // Whoever works must not begin to wait for his own end.
                if rayon::current_thread_index() != Some(own) {
                    look_for_work(is_done);
                }
            });
        }
        let _done = AtEnd(is_done, true);
        work()
    })
}

fn look_for_work(is_done: &AtomicBool) {
    let mut in_vain = 0;
    while !is_done.load(Ordering::Acquire) {
        if rayon::yield_now() == Some(Yield::Executed) {
            in_vain = 0;
        } else if in_vain < PATIENCE {
            in_vain += 1;
            hint::spin_loop();
        } else {
            in_vain = 0;
            thread::yield_now();
        }
    }
}

#[cfg(test)]
mod tests {
    use std::panic::{AssertUnwindSafe, catch_unwind};

    use rayon::prelude::*;

    use super::*;

    fn pool(threads: usize) -> rayon::ThreadPool {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        pool.build().expect("threads")
    }

    fn sum(count: u64) -> u64 {
        (0..count).into_par_iter().map(|it| it * it).sum()
    }

    #[test]
    fn work_is_done_with_any_number_of_threads_and_within_itself() {
        for threads in [1, 2, 3, 8] {
            let all = || {
                let sums = (0..6_u64).into_par_iter().map(|_| keep_awake(|| sum(1000)));
                sums.collect::<Vec<_>>()
            };
            let sums = pool(threads).install(|| keep_awake(all));
            assert_eq!(sums, [sum(1000); 6], "{threads} threads");
        }
        assert_eq!(keep_awake(|| sum(10)), 285, "outside of a pool");
    }

    #[test]
    fn threads_are_let_go_where_work_panics() {
        let pool = pool(3);
        for _ in 0..3 {
            let work = || {
                sum(100);
                panic!("the work");
            };
            let result = catch_unwind(AssertUnwindSafe(|| pool.install(|| keep_awake(work))));
            assert!(result.is_err());
        }
        assert_eq!(pool.install(|| keep_awake(|| sum(10))), 285);
    }
}
