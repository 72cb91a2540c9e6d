//! `FNV-1a` for 64 bits (Fowler, Noll and Vo): the same number for the same bytes, on every machine.

/// Where a hash begins.
pub const BASIS: u64 = 0xcbf2_9ce4_8422_2325;
/// What it is multiplied by.
pub const PRIME: u64 = 0x0000_0100_0000_01b3;

/// The hash of bytes.
#[must_use]
pub fn hash(bytes: impl IntoIterator<Item = u8>) -> u64 {
    let bytes = bytes.into_iter();
    bytes.fold(BASIS, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(PRIME)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Test vectors of the authors' page.
    #[test]
    fn published_hashes_come_out() {
        assert_eq!(hash(*b""), 0xcbf2_9ce4_8422_2325);
        assert_eq!(hash(*b"a"), 0xaf63_dc4c_8601_ec8c);
        assert_eq!(hash(*b"foobar"), 0x8594_4171_f739_67e8);
    }
}
