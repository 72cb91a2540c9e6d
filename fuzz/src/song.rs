//! Songs in MP4 whose boxes and tables fit each other, now and then not.

use arbitrary::Unstructured;

use crate::{choose, count, once_in};

/// Sounds and chunks of a song, at most.
const MOST: u32 = 12;
/// Numbers that a table may hold instead of the right one.
const WRONG: [u32; 7] = [0, 1, 2, 0x7fff_ffff, 0x8000_0000, 0xffff_fffe, 0xffff_ffff];
/// What boxes are now and then called instead.
const KINDS: [&[u8; 4]; 8] = [
    b"free", b"trak", b"stbl", b"stsz", b"co64", b"moof", b"edts", b"wave",
];

/// A file.
pub fn file(bytes: &mut Unstructured<'_>) -> Vec<u8> {
    let sizes: Vec<u32> = (0..=count(bytes, MOST)).map(|_| count(bytes, 40)).collect();
    let data: Vec<u8> = (0..sizes.iter().sum::<u32>())
        .map(|byte| byte as u8)
        .collect();
    let mut file = atom(bytes, b"ftyp", b"M4A \0\0\x02\0isomM4A ");
    let begins = file.len() as u32 + 8;
    file.extend(atom(bytes, b"mdat", &data));
    let movie = movie(bytes, (&sizes, begins));
    file.extend(atom(bytes, b"moov", &movie));
    if once_in(bytes, 6) {
        let moof = atom(bytes, b"mfhd", &words(&[0, 1]));
        file.extend(atom(bytes, b"moof", &moof));
    }
    if once_in(bytes, 8) {
        file.truncate(count(bytes, file.len() as u32) as usize);
    }
    file
}

/// A box, whose size or kind is wrong once in a while.
fn atom(bytes: &mut Unstructured<'_>, kind: &[u8; 4], holds: &[u8]) -> Vec<u8> {
    let size = holds.len() as u32 + 8;
    let size = if once_in(bytes, 40) {
        *choose(bytes, &WRONG)
    } else {
        size
    };
    let kind = if once_in(bytes, 40) {
        *choose(bytes, &KINDS)
    } else {
        kind
    };
    let mut atom = size.to_be_bytes().to_vec();
    atom.extend(kind);
    atom.extend(holds);
    atom
}

fn words(words: &[u32]) -> Vec<u8> {
    words.iter().flat_map(|word| word.to_be_bytes()).collect()
}

/// A number, which is another one once in a while.
fn number(bytes: &mut Unstructured<'_>, right: u32) -> u32 {
    if once_in(bytes, 12) {
        *choose(bytes, &WRONG)
    } else {
        right
    }
}

fn movie(bytes: &mut Unstructured<'_>, song: (&[u32], u32)) -> Vec<u8> {
    let mut movie = atom(bytes, b"mvhd", &words(&[0; 25]));
    for _ in 0..=count(bytes, 2) {
        let mut track = atom(bytes, b"tkhd", &words(&[0; 21]));
        if once_in(bytes, 3) {
            let edit = words(&[
                0,
                number(bytes, 1),
                number(bytes, 900),
                number(bytes, 1024),
                0x1_0000,
            ]);
            let list = atom(bytes, b"elst", &edit);
            track.extend(atom(bytes, b"edts", &list));
        }
        let media = media(bytes, song);
        track.extend(atom(bytes, b"mdia", &media));
        movie.extend(atom(bytes, b"trak", &track));
    }
    movie
}

fn media(bytes: &mut Unstructured<'_>, song: (&[u32], u32)) -> Vec<u8> {
    let timescale = number(bytes, 44_100);
    let mut media = atom(
        bytes,
        b"mdhd",
        &words(&[0, 0, 0, timescale, 1024, 0x55c4_0000]),
    );
    let kind = *choose(bytes, &[b"soun", b"soun", b"soun", b"vide"]);
    let mut handler = words(&[0, 0]);
    handler.extend(kind);
    handler.extend(words(&[0, 0, 0]));
    handler.extend(b"song\0");
    media.extend(atom(bytes, b"hdlr", &handler));
    let table = table(bytes, song);
    let mut information = atom(bytes, b"smhd", &words(&[0, 0]));
    information.extend(atom(bytes, b"stbl", &table));
    media.extend(atom(bytes, b"minf", &information));
    media
}

fn table(bytes: &mut Unstructured<'_>, (sizes, begins): (&[u32], u32)) -> Vec<u8> {
    let entry = entry(bytes);
    let mut described = words(&[0, number(bytes, 1)]);
    described.extend(entry);
    let mut table = atom(bytes, b"stsd", &described);
    let samples = sizes.len() as u32;
    let lasts = words(&[
        0,
        number(bytes, 1),
        number(bytes, samples),
        number(bytes, 1024),
    ]);
    table.extend(atom(bytes, b"stts", &lasts));
    let in_chunk = number(bytes, 3);
    let chunks = words(&[
        0,
        number(bytes, 1),
        number(bytes, 1),
        in_chunk,
        number(bytes, 1),
    ]);
    table.extend(atom(bytes, b"stsc", &chunks));
    let all_the_same = once_in(bytes, 4);
    let mut lengths = vec![
        0,
        if all_the_same { number(bytes, 8) } else { 0 },
        number(bytes, samples),
    ];
    if !all_the_same {
        lengths.extend(sizes.iter().map(|&size| number(bytes, size)));
    }
    let lengths = words(&lengths);
    table.extend(atom(bytes, b"stsz", &lengths));
    let offsets: Vec<u32> = sizes
        .chunks(3)
        .scan(begins, |at, chunk| {
            let here = *at;
            *at += chunk.iter().sum::<u32>();
            Some(here)
        })
        .collect();
    if once_in(bytes, 4) {
        let mut long = words(&[0, number(bytes, offsets.len() as u32)]);
        for offset in offsets {
            long.extend(words(&[
                if once_in(bytes, 20) { 1 } else { 0 },
                number(bytes, offset),
            ]));
        }
        table.extend(atom(bytes, b"co64", &long));
    } else {
        let mut short = vec![0, number(bytes, offsets.len() as u32)];
        short.extend(offsets.iter().map(|&offset| number(bytes, offset)));
        let short = words(&short);
        table.extend(atom(bytes, b"stco", &short));
    }
    table
}

/// How the sound is coded: AAC, Opus, or neither.
fn entry(bytes: &mut Unstructured<'_>) -> Vec<u8> {
    let mut sound = words(&[0, 1, 0, 0, 0x0002_0010, 0]);
    sound.extend(words(&[48_000 << 16]));
    match count(bytes, 3) {
        0 => {
            let mut head = vec![0, 2, 0x01, 0x38];
            head.extend(48_000_u32.to_be_bytes());
            head.extend([0, 0, count(bytes, 2) as u8]);
            sound.extend(atom(bytes, b"dOps", &head));
            atom(bytes, b"Opus", &sound)
        }
        1 => atom(bytes, b"alac", &sound),
        _ => {
            // ES descriptor, decoder's configuration, its specific information, and how samples are laid.
            let length = number(bytes, 25) as u8;
            let mut coded = vec![0, 0, 0, 0, 3, length, 0, 1, 0, 4, 17];
            coded.extend([number(bytes, 0x40) as u8, 0x15, 0, 0, 0]);
            coded.extend(words(&[128_000, 128_000]));
            coded.extend([5, number(bytes, 2) as u8, 0x12, 0x10, 6, 1, 2]);
            sound.extend(atom(bytes, b"esds", &coded));
            atom(bytes, b"mp4a", &sound)
        }
    }
}
