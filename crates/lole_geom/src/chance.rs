//! Chance that a seed repeats: `SplitMix64` (Steele, Lea and Flood 2014, "Fast Splittable Pseudorandom
//! Number Generators").

/// A stream of numbers that look random and are the same for the same seed, on every machine.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Chance(u64);

impl Chance {
    /// The stream of a seed. Seeds that follow each other give streams that have nothing in common.
    #[must_use]
    pub const fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// The next 64 bits.
    pub const fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// A number in `0..1`, with 16 bits.
    pub fn share(&mut self) -> f32 {
        let [high, low, ..] = self.bits().to_be_bytes();
        f32::from(u16::from_be_bytes([high, low])) / 65_536.0
    }

    /// A number in `0..1`, with 24 bits.
    #[expect(clippy::cast_precision_loss, reason = "24 bits fit")]
    pub const fn fine_share(&mut self) -> f32 {
        (self.bits() >> 40) as f32 / (1_u32 << 24) as f32
    }

    /// A number in `0..1`, with 53 bits.
    #[expect(clippy::cast_precision_loss, reason = "53 bits fit")]
    pub const fn finest_share(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A number between two others, the second left out.
    pub fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * self.share()
    }

    /// True with a probability.
    pub fn falls(&mut self, probability: f32) -> bool {
        self.share() < probability
    }

    /// One of some things; `None` where there are none.
    pub fn choose<'a, T>(&mut self, from: &'a [T]) -> Option<&'a T> {
        let count = u64::try_from(from.len()).ok().filter(|&count| 0 < count)?;
        from.get(usize::try_from(self.bits() % count).ok()?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_published_stream_comes_out() {
        // The first numbers of the reference implementation for the seed 1234567.
        let mut chance = Chance::new(1_234_567);
        let first = [0; 3].map(|_: i32| chance.bits());
        assert_eq!(
            first,
            [
                6_457_827_717_110_365_317,
                3_203_168_211_198_807_973,
                9_817_491_932_198_370_423
            ]
        );
    }

    #[test]
    fn shares_are_spread_evenly_and_below_one() {
        let mut chance = Chance::new(7);
        let mut counts = [0_u32; 8];
        for _ in 0..8000 {
            let share = chance.share();
            assert!((0.0..1.0).contains(&share));
            counts[(0..8_u8)
                .filter(|&part| f32::from(part) / 8.0 <= share)
                .count()
                - 1] += 1;
        }
        assert!(
            counts.iter().all(|count| (850..1150).contains(count)),
            "{counts:?}"
        );
    }
}
