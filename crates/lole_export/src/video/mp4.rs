//! The MP4 around the H.264 pictures: index first, one track of pictures in one chunk,
//! and behind it one of sound.

use mp4_atom::{
    Atom as _, Avc1, Avcc, Codec, Colr, Dinf, Dref, DrefEntry, Edts, Elst, ElstEntry, Encode as _,
    FixedPoint, Ftyp, Hdlr, Mdhd, Mdia, Minf, Moov, Mvhd, Smhd, Stbl, Stco, Stsc, StscEntry, Stsd,
    Stss, Stsz, StszSamples, Stts, SttsEntry, Tkhd, Trak, Url, Visual, Vmhd,
};

use super::audio::Song;

/// Media time units per picture. A film's time unit is then `1 / (fps × 1000)` s, which holds
/// every picture's time exactly.
const TICKS_PER_PICTURE: u32 = 1000;

/// Code points of BT.709 primaries, transfer and matrix in ITU-T H.273, tables 2 to 4.
const BT_709: u16 = 1;

/// A film whose pictures are encoded.
pub(super) struct Track<'a> {
    /// Width and height [pixel].
    pub size: [u16; 2],
    /// Pictures a second.
    pub fps: u32,
    /// Sequence parameter set, without start code.
    pub sequence_parameters: &'a [u8],
    /// Picture parameter set, without start code.
    pub picture_parameters: &'a [u8],
    /// Bytes of each picture.
    pub sample_sizes: &'a [u32],
    /// Indices of the pictures that stand alone, from 0.
    pub keyframes: &'a [u32],
    /// The song, no longer than the film.
    pub song: Option<&'a Song>,
}

/// Bytes of the file before its pictures and its sound: `ftyp`, `moov`, and the head of `mdat`.
pub(super) fn head(track: &Track<'_>) -> Result<Vec<u8>, mp4_atom::Error> {
    let mut bytes = Vec::with_capacity(64 * 1024);
    Ftyp {
        major_brand: b"isom".into(),
        minor_version: 0x200,
        compatible_brands: [b"isom", b"iso2", b"avc1", b"mp41"]
            .map(Into::into)
            .to_vec(),
    }
    .encode(&mut bytes)?;
    // The index holds the place of the pictures, which stand behind the index: its length does
    // not depend on the number it holds, so it is written once to be measured.
    let mut measured = Vec::new();
    movie(track, [0; 2]).encode(&mut measured)?;
    let header_len = 8;
    let sizes = track.sample_sizes.iter();
    let pictures_len: u64 = sizes.map(|&size| u64::from(size)).sum();
    let sound_len = track.song.map_or(0, |song| song.data.len()) as u64;
    let offset = (bytes.len() + measured.len()) as u64 + header_len;
    let mdat_len = pictures_len + sound_len + header_len;
    let lengths = [offset, offset + pictures_len, mdat_len].map(u32::try_from);
    let [Ok(pictures_at), Ok(sound_at), Ok(mdat_len)] = lengths else {
        return Err(mp4_atom::Error::TooLarge(mp4_atom::Mdat::KIND));
    };
    movie(track, [pictures_at, sound_at]).encode(&mut bytes)?;
    bytes.extend_from_slice(&mdat_len.to_be_bytes());
    bytes.extend_from_slice(b"mdat");
    Ok(bytes)
}

/// The index of the film, whose first picture and first sound stand at these places [byte].
fn movie(track: &Track<'_>, [pictures_at, sound_at]: [u32; 2]) -> Moov {
    let timescale = track.fps * TICKS_PER_PICTURE;
    let duration = track.sample_sizes.len() as u64 * u64::from(TICKS_PER_PICTURE);
    let pictures = picture_track(track, (timescale, duration), pictures_at);
    let song = track
        .song
        .map(|song| sound_track(song, (timescale, duration), sound_at));
    Moov {
        mvhd: Mvhd {
            timescale,
            duration,
            rate: FixedPoint::from(1),
            volume: FixedPoint::from(1),
            next_track_id: 3,
            ..Mvhd::default()
        },
        trak: [Some(pictures), song].into_iter().flatten().collect(),
        ..Moov::default()
    }
}

/// The pictures: `duration` ticks of `timescale` a second, the first at `offset` [byte].
fn picture_track(track: &Track<'_>, (timescale, duration): (u32, u64), offset: u32) -> Trak {
    let [width, height] = track.size;
    Trak {
        tkhd: Tkhd {
            track_id: 1,
            duration,
            enabled: true,
            in_movie: true,
            width: FixedPoint::from(width),
            height: FixedPoint::from(height),
            ..Tkhd::default()
        },
        mdia: Mdia {
            mdhd: Mdhd {
                timescale,
                duration,
                language: "und".into(),
                ..Mdhd::default()
            },
            hdlr: Hdlr {
                handler: b"vide".into(),
                name: "Lole".into(),
            },
            minf: Minf {
                vmhd: Some(Vmhd::default()),
                dinf: here(),
                stbl: sample_table(track, offset),
                ..Minf::default()
            },
        },
        ..Trak::default()
    }
}

/// The sound under `duration` ticks of a film, `timescale` a second; the first at `offset` [byte].
fn sound_track(song: &Song, (timescale, duration): (u32, u64), offset: u32) -> Trak {
    let of_film = song.seconds() * f64::from(timescale);
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "positive, and no longer than the film"
    )]
    let heard = duration.min(of_film as u64);
    let sample_count = u32::try_from(song.sizes.len()).unwrap_or(u32::MAX);
    Trak {
        tkhd: Tkhd {
            track_id: 2,
            duration: heard,
            enabled: true,
            in_movie: true,
            volume: FixedPoint::from(1),
            alternate_group: 1,
            ..Tkhd::default()
        },
        edts: Some(Edts {
            elst: Some(Elst {
                entries: vec![ElstEntry {
                    segment_duration: heard,
                    media_time: Some(song.priming),
                    media_rate: FixedPoint::from(1),
                }],
            }),
        }),
        mdia: Mdia {
            mdhd: Mdhd {
                timescale: song.timescale,
                duration: song.durations.iter().copied().map(u64::from).sum(),
                language: "und".into(),
                ..Mdhd::default()
            },
            hdlr: Hdlr {
                handler: b"soun".into(),
                name: "Lole".into(),
            },
            minf: Minf {
                smhd: Some(Smhd::default()),
                dinf: here(),
                stbl: Stbl {
                    stsd: Stsd {
                        codecs: vec![song.codec.clone()],
                    },
                    stts: Stts {
                        entries: song.duration_runs(),
                    },
                    stsc: one_chunk(sample_count),
                    stsz: Stsz {
                        samples: StszSamples::Different {
                            sizes: song.sizes.clone(),
                        },
                    },
                    stco: Some(Stco {
                        entries: vec![offset],
                    }),
                    ..Stbl::default()
                },
                ..Minf::default()
            },
        },
        ..Trak::default()
    }
}

/// Samples lie in this file.
fn here() -> Dinf {
    Dinf {
        dref: Dref {
            entries: vec![DrefEntry::Url(Url::default())],
        },
    }
}

/// All samples lie one after the other.
fn one_chunk(sample_count: u32) -> Stsc {
    Stsc {
        entries: vec![StscEntry {
            first_chunk: 1,
            samples_per_chunk: sample_count,
            sample_description_index: 1,
        }],
    }
}

/// Where each picture stands and how long it shows.
fn sample_table(track: &Track<'_>, offset: u32) -> Stbl {
    let sample_count = u32::try_from(track.sample_sizes.len()).unwrap_or(u32::MAX);
    Stbl {
        stsd: Stsd {
            codecs: vec![Codec::Avc1(sample_entry(track))],
        },
        stts: Stts {
            entries: vec![SttsEntry {
                sample_count,
                sample_delta: TICKS_PER_PICTURE,
            }],
        },
        stss: Some(Stss {
            entries: track.keyframes.iter().map(|index| index + 1).collect(),
        }),
        stsc: one_chunk(sample_count),
        stsz: Stsz {
            samples: StszSamples::Different {
                sizes: track.sample_sizes.to_vec(),
            },
        },
        stco: Some(Stco {
            entries: vec![offset],
        }),
        ..Stbl::default()
    }
}

/// How the pictures are coded, and what their colors mean.
fn sample_entry(track: &Track<'_>) -> Avc1 {
    let parameters = track.sequence_parameters;
    let byte = |index: usize| parameters.get(index).copied().unwrap_or(0);
    Avc1 {
        visual: Visual {
            data_reference_index: 1,
            width: track.size[0],
            height: track.size[1],
            ..Visual::default()
        },
        avcc: Avcc {
            configuration_version: 1,
            avc_profile_indication: byte(1),
            profile_compatibility: byte(2),
            avc_level_indication: byte(3),
            length_size: 4,
            sequence_parameter_sets: vec![parameters.to_vec()],
            picture_parameter_sets: vec![track.picture_parameters.to_vec()],
            ext: None,
        },
        colr: Some(Colr::Nclx {
            colour_primaries: BT_709,
            transfer_characteristics: BT_709,
            matrix_coefficients: BT_709,
            full_range_flag: false,
        }),
        ..Avc1::default()
    }
}
