//! A film gives back the pictures that went in, at the times and in the colors they had.

#![allow(
    clippy::unwrap_used,
    clippy::cast_possible_truncation,
    reason = "a test that meets anything unexpected should stop"
)]

use std::fs::File;

use lole_export::video::{Mp4Writer, VideoSettings};
use mp4_atom::{Any, Atom as _, Codec, Colr, Decode as _, Moov, StszSamples};
use openh264::decoder::Decoder;
use openh264::formats::YUVSource as _;

const SIZE: [u32; 2] = [192, 112];

/// A picture with a smooth sheen, stripes that move, and a block of one color.
fn picture(frame: u32, block: [u8; 3]) -> Vec<u8> {
    let [width, height] = SIZE;
    let mut pixels = Vec::new();
    for (y, x) in (0..height).flat_map(|y| (0..width).map(move |x| (y, x))) {
        let stripe = if ((x + 2 * frame) / 12).is_multiple_of(2) {
            [180, 30, 60]
        } else {
            [240, 220, 190]
        };
        let color = match (x, y) {
            (96.., 48..) => block,
            (_, 0..48) => [x, y * 2, 120].map(|level| u8::try_from(level).unwrap()),
            _ => stripe,
        };
        pixels.extend_from_slice(&color);
        pixels.push(255);
    }
    pixels
}

fn film(frame_count: u32, block: [u8; 3]) -> Vec<u8> {
    let mut writer = Mp4Writer::new(SIZE, 30, VideoSettings::default()).unwrap();
    for frame in 0..frame_count {
        writer.push_frame(&picture(frame, block)).unwrap();
    }
    assert_eq!(writer.frame_count(), frame_count as usize);
    writer.finish().unwrap()
}

/// An empty file, open to be written and read, and open to be read alone.
fn scratch(name: &str) -> (File, File) {
    let path = std::env::temp_dir().join(format!("lole_film_{}_{name}", std::process::id()));
    let mut options = File::options();
    let options = options.read(true).write(true).create(true).truncate(true);
    let both = (options.open(&path).unwrap(), File::open(&path).unwrap());
    std::fs::remove_file(&path).unwrap();
    both
}

#[test]
fn a_film_kept_in_a_file_is_the_same_to_the_byte() {
    let mut writer = Mp4Writer::new(SIZE, 30, VideoSettings::default()).unwrap();
    let (scratch, _) = scratch("kept");
    writer.keep_in(scratch);
    for frame in 0..9 {
        writer.push_frame(&picture(frame, [200, 40, 90])).unwrap();
    }
    let mut bytes = Vec::new();
    writer.finish_into(&mut bytes).unwrap();
    assert!(bytes == film(9, [200, 40, 90]));
}

#[test]
fn a_film_that_cannot_be_kept_says_so() {
    let mut writer = Mp4Writer::new(SIZE, 30, VideoSettings::default()).unwrap();
    let (_, only_read) = scratch("only_read");
    // A file that is only read takes nothing, as a full disk does.
    writer.keep_in(only_read);
    let error = writer.push_frame(&picture(0, [1, 2, 3])).unwrap_err();
    assert!(error.to_string().contains("writing MP4 failed"), "{error}");
}

/// The index, and the H.264 samples in order.
fn read(bytes: &[u8]) -> (Moov, Vec<Vec<u8>>) {
    let mut rest = bytes;
    let mut moov = None;
    while !rest.is_empty() {
        match Any::decode(&mut rest).unwrap() {
            Any::Moov(found) => moov = Some(found),
            Any::Mdat(_) => assert!(moov.is_some(), "the index must come before the pictures"),
            _ => {}
        }
    }
    let moov = moov.unwrap();
    let table = &moov.trak[0].mdia.minf.stbl;
    let mut offset = table.stco.as_ref().unwrap().entries[0] as usize;
    let StszSamples::Different { sizes } = &table.stsz.samples else {
        panic!("sizes differ")
    };
    let mut samples = Vec::new();
    for size in sizes {
        samples.push(bytes[offset..offset + *size as usize].to_vec());
        offset += *size as usize;
    }
    assert_eq!(offset, bytes.len());
    (moov, samples)
}

/// RGB of one decoded pixel by BT.709 in the limited range, in f64 from the standard's numbers.
fn rgb([luma, blue, red]: [u8; 3]) -> [f64; 3] {
    let luma = (f64::from(luma) - 16.0) / 219.0;
    let (blue, red) = (
        (f64::from(blue) - 128.0) / 224.0,
        (f64::from(red) - 128.0) / 224.0,
    );
    let (r, b) = (luma + 1.5748 * red, luma + 1.8556 * blue);
    let g = (luma - 0.2126 * r - 0.0722 * b) / 0.7152;
    [r, g, b].map(|channel| 255.0 * channel)
}

/// Decodes all samples and hands each picture's planes to `visit` as a function of the pixel.
fn decode(
    moov: &Moov,
    samples: &[Vec<u8>],
    mut visit: impl FnMut(usize, &dyn Fn(usize, usize) -> [u8; 3]),
) {
    let Codec::Avc1(entry) = &moov.trak[0].mdia.minf.stbl.stsd.codecs[0] else {
        panic!("not H.264")
    };
    let mut decoder = Decoder::new().unwrap();
    let start = [0, 0, 0, 1];
    for (index, sample) in samples.iter().enumerate() {
        let mut stream = Vec::new();
        if index == 0 {
            for set in entry
                .avcc
                .sequence_parameter_sets
                .iter()
                .chain(&entry.avcc.picture_parameter_sets)
            {
                stream.extend(start.iter().chain(set));
            }
        }
        let mut rest = sample.as_slice();
        while let Some((length, tail)) = rest.split_first_chunk::<4>() {
            let (unit, tail) = tail.split_at(u32::from_be_bytes(*length) as usize);
            stream.extend(start.iter().chain(unit));
            rest = tail;
        }
        let picture = decoder.decode(&stream).unwrap().unwrap();
        let (wide, narrow, _) = picture.strides();
        visit(index, &|x, y| {
            let chroma = y / 2 * narrow + x / 2;
            [
                picture.y()[y * wide + x],
                picture.u()[chroma],
                picture.v()[chroma],
            ]
        });
    }
}

#[test]
fn a_film_has_its_pictures_at_their_times() {
    let (moov, samples) = read(&film(70, [9, 9, 9]));
    let track = &moov.trak[0].mdia;
    assert_eq!(samples.len(), 70);
    let seconds = track.mdhd.duration as f64 / f64::from(track.mdhd.timescale);
    assert!((seconds - 70.0 / 30.0).abs() < 1e-12, "{seconds} s");
    assert_eq!(
        track.minf.stbl.stss.as_ref().unwrap().entries,
        [1, 61],
        "a key every 2 s"
    );
    let Codec::Avc1(entry) = &track.minf.stbl.stsd.codecs[0] else {
        panic!("not H.264")
    };
    assert_eq!(
        [
            u32::from(entry.visual.width),
            u32::from(entry.visual.height)
        ],
        SIZE
    );
    let bt_709 = Colr::Nclx {
        colour_primaries: 1,
        transfer_characteristics: 1,
        matrix_coefficients: 1,
        full_range_flag: false,
    };
    assert_eq!(entry.colr, Some(bt_709));
    assert_eq!(Moov::KIND, b"moov".into());
}

#[test]
fn known_colors_come_back_within_three_levels() {
    for block in [
        [206, 40, 110],
        [8, 92, 66],
        [255, 246, 240],
        [14, 62, 134],
        [0, 0, 0],
    ] {
        let (moov, samples) = read(&film(4, block));
        decode(&moov, &samples, |frame, pixel| {
            let back = rgb(pixel(144, 80));
            for (level, wanted) in back.into_iter().zip(block) {
                let error = (level - f64::from(wanted)).abs();
                assert!(
                    error < 3.5,
                    "frame {frame}: {block:?} came back as {back:?}"
                );
            }
        });
    }
}

#[test]
fn moving_print_keeps_its_luma_above_38_db() {
    let (moov, samples) = read(&film(20, [30, 90, 60]));
    decode(&moov, &samples, |frame, pixel| {
        let original = picture(u32::try_from(frame).unwrap(), [30, 90, 60]);
        let width = SIZE[0] as usize;
        let mut squares = 0.0;
        for (index, color) in original.chunks_exact(4).enumerate() {
            let [r, g, b] = [0, 1, 2].map(|channel| f64::from(color[channel]));
            let luma = 16.0 + 219.0 / 255.0 * (0.2126 * r + 0.7152 * g + 0.0722 * b);
            let back = f64::from(pixel(index % width, index / width)[0]);
            squares += (luma - back) * (luma - back);
        }
        let mean = squares * 4.0 / original.len() as f64;
        let psnr = 10.0 * (255.0 * 255.0 / mean).log10();
        assert!(38.0 < psnr, "frame {frame}: {psnr} dB");
    });
}

#[test]
fn sizes_that_cannot_be_stored_are_refused_with_the_nearest_that_can() {
    let error = Mp4Writer::new([1281, 719], 30, VideoSettings::default()).unwrap_err();
    assert!(error.to_string().contains("try 1282 × 720"), "{error}");
    let error = Mp4Writer::new([8, 9000], 30, VideoSettings::default()).unwrap_err();
    assert!(error.to_string().contains("try 16 × 2160"), "{error}");
    let error = Mp4Writer::new([64, 64], 0, VideoSettings::default()).unwrap_err();
    assert!(error.to_string().contains("choose 1 to 120"), "{error}");
    let empty = Mp4Writer::new([64, 64], 30, VideoSettings::default()).unwrap();
    assert!(
        empty
            .finish()
            .unwrap_err()
            .to_string()
            .contains("at least one frame")
    );
    let mut writer = Mp4Writer::new([64, 64], 30, VideoSettings::default()).unwrap();
    assert!(
        writer
            .push_frame(&[0; 16])
            .unwrap_err()
            .to_string()
            .contains("64 × 64")
    );
}
