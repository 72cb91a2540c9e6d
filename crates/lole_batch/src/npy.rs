//! Positions as `NumPy`'s own format, version 1.0: little-endian `f32`, one row of three a point.

use glam::Vec3;

/// The bytes of a `.npy` file of shape `[points, 3]`.
pub(crate) fn points(points: &[Vec3]) -> Vec<u8> {
    let mut head = format!(
        "{{'descr': '<f4', 'fortran_order': False, 'shape': ({}, 3), }}",
        points.len()
    );
    // Magic, version and length are 10 bytes; the head ends in a line break, at a multiple of 64.
    while !(10 + head.len() + 1).is_multiple_of(64) {
        head.push(' ');
    }
    head.push('\n');
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    let length = u16::try_from(head.len()).unwrap_or(u16::MAX);
    bytes.extend(length.to_le_bytes());
    bytes.extend(head.as_bytes());
    for point in points {
        for number in point.to_array() {
            bytes.extend(number.to_le_bytes());
        }
    }
    bytes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_data_begin_at_a_multiple_of_64_whatever_their_number() {
        for count in [0, 1, 9, 10, 99_999] {
            let bytes = points(&vec![Vec3::ONE; count]);
            let head = usize::from(u16::from_le_bytes([bytes[8], bytes[9]]));
            assert_eq!((10 + head) % 64, 0);
            assert_eq!(bytes.len(), 10 + head + 12 * count);
        }
    }
}
