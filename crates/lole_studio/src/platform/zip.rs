//! Several files as one: a ZIP archive without compression, because what is in it is compressed already or small.

use std::io::{Cursor, Write as _};

use zip::result::ZipResult;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

/// The archive of files by name: of the same files always the same bytes, because no time is in it.
///
/// # Errors
/// More files, or longer names, than an archive may have.
pub(crate) fn archive(files: &[(String, Vec<u8>)]) -> ZipResult<Vec<u8>> {
    let stored = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Stored)
        .last_modified_time(DateTime::DEFAULT);
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, content) in files {
        archive.start_file(name.as_str(), stored)?;
        archive.write_all(content)?;
    }
    Ok(archive.finish()?.into_inner())
}

#[cfg(test)]
mod tests {
    use std::io::Read as _;

    use super::*;

    #[test]
    fn files_come_out_of_an_archive_as_they_went_in() {
        let files = [
            ("型紙.svg".to_owned(), b"<svg/>".to_vec()),
            ("booklet.pdf".to_owned(), (0..=255).collect()),
        ];
        let bytes = archive(&files).unwrap();
        let mut opened = zip::ZipArchive::new(Cursor::new(bytes)).unwrap();
        assert_eq!(opened.len(), files.len());
        for (name, content) in files {
            let mut found = Vec::new();
            opened
                .by_name(&name)
                .unwrap()
                .read_to_end(&mut found)
                .unwrap();
            assert_eq!(found, content, "{name}");
        }
    }

    #[test]
    fn the_same_files_are_the_same_bytes() {
        let files = [("a".to_owned(), vec![1, 2, 3])];
        assert_eq!(archive(&files).unwrap(), archive(&files).unwrap());
    }
}
