//! Bodies between those of the table, for laws that hold on any.

use proptest::prelude::*;

use crate::bodies::BODIES;

/// Any body near one of the six or between two of them, every measure a little off.
pub(crate) fn any_body() -> impl Strategy<Value = [f64; 27]> {
    let noise = proptest::collection::vec(0.97..1.03_f64, 27);
    (0..6_usize, 0..6_usize, 0.0..1.0_f64, 0.94..1.06_f64, noise).prop_map(
        |(one, other, share, size, noise)| {
            let (a, b) = (&BODIES[one].1, &BODIES[other].1);
            std::array::from_fn(|index| {
                (a[index] + share * (b[index] - a[index])) * size * noise[index]
            })
        },
    )
}
