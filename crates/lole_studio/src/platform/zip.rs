//! Several files as one: a ZIP archive without compression, because what is in it is compressed already or small.
//!
//! The format is that of PKWARE's APPNOTE 6.3.3; names are UTF-8 (bit 11).

/// Bit 11 of the general purpose flags: names are UTF-8.
const UTF8: u16 = 1 << 11;
/// What is needed to read it: version 2.0.
const VERSION: u16 = 20;
/// The first of January 1980, the earliest date: archives of the same files are the same bytes.
const DATE: u16 = (1 << 5) | 1;

/// The archive of files by name. Parts of 4 GB and more have no place in it.
pub(crate) fn archive(files: &[(String, Vec<u8>)]) -> Vec<u8> {
    let (mut bytes, mut directory) = (Vec::new(), Vec::new());
    for (name, content) in files {
        let offset = length(bytes.len());
        let common = header(name, content);
        bytes.extend(0x0403_4b50_u32.to_le_bytes());
        bytes.extend(&common);
        bytes.extend(name.as_bytes());
        bytes.extend(content);
        directory.extend(0x0201_4b50_u32.to_le_bytes());
        directory.extend(VERSION.to_le_bytes());
        directory.extend(&common);
        // No comment, first disk, no attributes.
        directory.extend([0; 10]);
        directory.extend(offset.to_le_bytes());
        directory.extend(name.as_bytes());
    }
    let (start, count) = (length(bytes.len()), short(files.len()));
    bytes.extend(&directory);
    bytes.extend(0x0605_4b50_u32.to_le_bytes());
    bytes.extend([0; 4]);
    bytes.extend(count.to_le_bytes());
    bytes.extend(count.to_le_bytes());
    bytes.extend(length(directory.len()).to_le_bytes());
    bytes.extend(start.to_le_bytes());
    bytes.extend([0; 2]);
    bytes
}

/// What stands both before a file and in the directory.
fn header(name: &str, content: &[u8]) -> Vec<u8> {
    let mut bytes = Vec::new();
    for half in [VERSION, UTF8, 0, 0, DATE] {
        bytes.extend(half.to_le_bytes());
    }
    for word in [crc32(content), length(content.len()), length(content.len())] {
        bytes.extend(word.to_le_bytes());
    }
    bytes.extend(short(name.len()).to_le_bytes());
    bytes.extend([0; 2]);
    bytes
}

fn length(length: usize) -> u32 {
    u32::try_from(length).unwrap_or(u32::MAX)
}

fn short(length: usize) -> u16 {
    u16::try_from(length).unwrap_or(u16::MAX)
}

/// The checksum of ISO 3309, polynomial 0xEDB88320 reflected.
fn crc32(bytes: &[u8]) -> u32 {
    let mut crc = u32::MAX;
    for &byte in bytes {
        crc ^= u32::from(byte);
        for _ in 0..8 {
            crc = (crc >> 1) ^ (0xedb8_8320 & 0_u32.wrapping_sub(crc & 1));
        }
    }
    !crc
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_checksum_is_that_of_the_standards_example() {
        assert_eq!(crc32(b"123456789"), 0xcbf4_3926);
    }

    #[test]
    fn an_archive_ends_with_its_directory() {
        let bytes = archive(&[("型紙.svg".to_owned(), b"<svg/>".to_vec())]);
        let end = bytes.len() - 22;
        assert_eq!(bytes[end..end + 4], 0x0605_4b50_u32.to_le_bytes());
        let start = u32::from_le_bytes(bytes[end + 16..end + 20].try_into().unwrap());
        assert_eq!(bytes[start as usize..][..4], 0x0201_4b50_u32.to_le_bytes());
    }
}
