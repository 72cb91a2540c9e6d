//! How numbers are packed in a USD crate: LZ4 blocks, and integers as differences.

/// Most that a block holds [byte] (`LZ4_MAX_INPUT_SIZE`); larger ones would be cut into several.
const LARGEST_BLOCK: usize = 0x7E00_0000;
/// Literals that the first byte of a sequence can count.
const SHORT_RUN: usize = 15;

/// Bytes as an LZ4 block of literals alone, behind the number of further blocks (0): the packed parts of a take are
/// a few kilobytes beside its points, which are never packed.
pub(super) fn block(bytes: &[u8]) -> Vec<u8> {
    debug_assert!(bytes.len() <= LARGEST_BLOCK, "one block");
    let count = bytes.len();
    let mut packed = vec![0];
    if count < SHORT_RUN {
        #[expect(clippy::cast_possible_truncation, reason = "below 15")]
        packed.push((count as u8) << 4);
    } else {
        packed.push(0xF0);
        let mut rest = count - SHORT_RUN;
        while 255 <= rest {
            packed.push(255);
            rest -= 255;
        }
        #[expect(clippy::cast_possible_truncation, reason = "below 255")]
        packed.push(rest as u8);
    }
    packed.extend_from_slice(bytes);
    packed
}

/// Integers as differences from the one before: the commonest difference, two bits for each that say how wide it is
/// (0: the commonest, then 8, 16 and 32 bits), and those that are not the commonest; with their packed size before.
pub(super) fn integers(values: &[u32]) -> Vec<u8> {
    /// Neighbors mostly follow each other.
    const COMMON: i32 = 1;
    let mut codes = vec![0_u8; values.len().div_ceil(4)];
    let mut wide = Vec::new();
    let mut last = 0_u32;
    for (place, &value) in values.iter().enumerate() {
        let difference = value.wrapping_sub(last).cast_signed();
        last = value;
        let code = if difference == COMMON {
            0
        } else if let Ok(narrow) = i8::try_from(difference) {
            wide.extend(narrow.to_le_bytes());
            1
        } else if let Ok(narrow) = i16::try_from(difference) {
            wide.extend(narrow.to_le_bytes());
            2
        } else {
            wide.extend(difference.to_le_bytes());
            3
        };
        codes[place / 4] |= code << (2 * (place % 4));
    }
    let bytes = [&COMMON.to_le_bytes()[..], &codes, &wide].concat();
    let packed = block(&bytes);
    [&(packed.len() as u64).to_le_bytes()[..], &packed].concat()
}
