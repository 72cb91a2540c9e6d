//! A ZIP with any parts of a workbook is a list of dancers, or one sentence.

#![no_main]

use std::io::{Cursor, Write as _};

use libfuzzer_sys::fuzz_target;
use lole_costume::roster;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

/// Parts of an `.ods`, and of an `.xlsx`.
const TEXT: [&str; 2] = ["mimetype", "content.xml"];
const SHEETS: [&str; 6] = [
    "[Content_Types].xml",
    "xl/_rels/workbook.xml.rels",
    "xl/workbook.xml",
    "xl/worksheets/sheet1.xml",
    "xl/sharedStrings.xml",
    "xl/styles.xml",
];
/// The first byte says which; others of this value part the parts.
const BETWEEN: u8 = 0xff;

fuzz_target!(|bytes: &[u8]| {
    let Some((kind, rest)) = bytes.split_first() else {
        return;
    };
    let names: &[&str] = if kind % 2 == 0 { &TEXT } else { &SHEETS };
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    let stored = SimpleFileOptions::default().compression_method(CompressionMethod::Stored);
    for (name, part) in names.iter().zip(rest.split(|&byte| byte == BETWEEN)) {
        zip.start_file(*name, stored).unwrap();
        zip.write_all(part).unwrap();
    }
    let book = zip.finish().unwrap().into_inner();
    match roster::read(&book) {
        Ok(list) => assert!(
            list.dancers
                .iter()
                .all(|dancer| dancer.hip_cm().is_finite())
        ),
        Err(error) => assert!(!error.to_string().contains('\n')),
    }
});
