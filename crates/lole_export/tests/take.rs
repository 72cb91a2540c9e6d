//! Every form of a take has what went in, read by the rules of its format and by the archive's own library.

#![allow(
    clippy::unwrap_used,
    reason = "a test that meets anything unexpected should stop"
)]

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::io::{self, Cursor, Read as _, Seek, SeekFrom, Write};
use std::rc::Rc;

use glam::{Vec2, Vec3};
use lole_body::Pose;
use lole_export::take::{
    TakeFile, TakeFolder, TakeFormat, TakeMaterial, TakeMesh, TakePart, TakeScene, TakeSource,
    TakeVertices, write_take,
};

const FRAMES: u32 = 5;
const RATE: u32 = 20;

/// Two meshes that move, one with a picture and one with colors.
struct Sample(TakeScene);

impl Sample {
    fn new() -> Self {
        let mesh = |name: &str, count: usize, png: Option<&[u8]>| TakeMesh {
            name: name.to_owned(),
            vertex_count: count,
            uvs: (0..count).map(|it| Vec2::new(it as f32, 0.25)).collect(),
            colors: match png {
                Some(_) => Vec::new(),
                None => vec![Vec3::splat(0.5); count],
            },
            parts: vec![TakePart {
                triangles: vec![[0, 1, 2]],
                material: TakeMaterial {
                    name: format!("{name}_cloth"),
                    base_color: [0.5, 0.25, 1.0],
                    roughness: 0.8,
                    texture_png: png.map(<[u8]>::to_vec),
                    is_two_sided: true,
                },
            }],
        };
        Self(TakeScene {
            frame_rate: RATE,
            frame_count: FRAMES,
            meshes: vec![mesh("skirt", 4, Some(b"\x89PNG")), mesh("lei", 3, None)],
        })
    }

    fn position(frame: u32, mesh: usize, vertex: usize) -> Vec3 {
        Vec3::new(vertex as f32, frame as f32 * 0.125, mesh as f32 + 0.5)
    }
}

impl TakeSource for Sample {
    fn scene(&self) -> &TakeScene {
        &self.0
    }

    fn vertices(&mut self, frame: u32, mesh: usize) -> io::Result<TakeVertices> {
        let count = self.0.meshes[mesh].vertex_count;
        let positions = (0..count).map(|vertex| Self::position(frame, mesh, vertex));
        Ok([positions.collect(), vec![Vec3::Y; count]])
    }

    fn pose(&mut self, _: u32) -> io::Result<Pose> {
        Ok(Pose::default())
    }
}

/// A folder in memory.
#[derive(Default)]
struct Folder(Rc<RefCell<BTreeMap<String, Vec<u8>>>>);

struct Entry {
    files: Rc<RefCell<BTreeMap<String, Vec<u8>>>>,
    name: String,
    cursor: Cursor<Vec<u8>>,
}

impl Write for Entry {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.cursor.write(bytes)?;
        let whole = self.cursor.get_ref().clone();
        self.files.borrow_mut().insert(self.name.clone(), whole);
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Seek for Entry {
    fn seek(&mut self, place: SeekFrom) -> io::Result<u64> {
        self.cursor.seek(place)
    }
}

impl TakeFolder for Folder {
    fn create(&mut self, name: &str) -> io::Result<Box<dyn TakeFile + '_>> {
        Ok(Box::new(Entry {
            files: Rc::clone(&self.0),
            name: name.to_owned(),
            cursor: Cursor::default(),
        }))
    }
}

fn written(format: TakeFormat) -> BTreeMap<String, Vec<u8>> {
    let mut folder = Folder::default();
    write_take(format, &mut Sample::new(), &mut folder).unwrap();
    folder.0.take()
}

/// All positions of a mesh, frame by frame, as numbers.
fn expected(mesh: usize, count: usize) -> Vec<f32> {
    (0..FRAMES)
        .flat_map(|frame| (0..count).map(move |vertex| Sample::position(frame, mesh, vertex)))
        .flat_map(|point| point.to_array())
        .collect()
}

#[test]
fn point_caches_have_heads_and_positions_as_their_programs_read_them() {
    let files = written(TakeFormat::Pc2);
    for (mesh, (name, count)) in [("skirt", 4_usize), ("lei", 3)].into_iter().enumerate() {
        let bytes = &files[&format!("{name}.pc2")];
        assert_eq!(&bytes[..12], b"POINTCACHE2\0");
        let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
        assert_eq!((word(12), word(16) as usize, word(28)), (1, count, FRAMES));
        assert_eq!(
            (f32::from_bits(word(20)), f32::from_bits(word(24))),
            (0.0, 1.0)
        );
        let found: Vec<f32> = (32..bytes.len())
            .step_by(4)
            .map(|at| f32::from_bits(word(at)))
            .collect();
        assert_eq!(found, expected(mesh, count));
        assert!(files.contains_key(&format!("{name}.obj")));
    }
    let bytes = &written(TakeFormat::Mdd)["lei.mdd"];
    let word = |at: usize| u32::from_be_bytes(bytes[at..at + 4].try_into().unwrap());
    assert_eq!((word(0), word(4)), (FRAMES, 3));
    assert!((f32::from_bits(word(8 + 4 * 2)) - 2.0 / RATE as f32).abs() < 1.0e-7);
    let start = 8 + 4 * FRAMES as usize;
    let found: Vec<f32> = (start..bytes.len())
        .step_by(4)
        .map(|at| f32::from_bits(word(at)))
        .collect();
    assert_eq!(found, expected(1, 3));
}

#[test]
fn a_sequence_numbers_vertices_through_all_meshes_and_names_its_materials() {
    let files = written(TakeFormat::Obj);
    assert_eq!(
        files.keys().filter(|name| name.ends_with(".obj")).count(),
        FRAMES as usize
    );
    let text = String::from_utf8(files["dance_0002.obj"].clone()).unwrap();
    let lines = |start: &str| text.lines().filter(|line| line.starts_with(start)).count();
    assert_eq!(
        (lines("v "), lines("vt "), lines("vn "), lines("f ")),
        (7, 7, 7, 2)
    );
    assert!(text.contains("f 5/5/5 6/6/6 7/7/7"), "{text}");
    assert!(text.contains("v 1.000000 0.250000 0.500000\n"), "{text}");
    assert!(text.contains("vt 1.00000 0.75000"), "v runs up: {text}");
    let materials = String::from_utf8(files["dance.mtl"].clone()).unwrap();
    for name in ["skirt_cloth", "lei_cloth"] {
        assert!(text.contains(&format!("usemtl {name}\n")));
        assert!(materials.contains(&format!("newmtl {name}\n")));
    }
    assert!(materials.contains("map_Kd skirt_cloth.png"));
    assert_eq!(files["skirt_cloth.png"], b"\x89PNG");
}

#[test]
fn arrays_are_whole_and_have_their_shape() {
    let files = written(TakeFormat::Npz);
    let mut archive = zip::ZipArchive::new(Cursor::new(files["dance.npz"].clone())).unwrap();
    let mut bytes = Vec::new();
    let mut file = archive.by_name("lei.positions.npy").unwrap();
    file.read_to_end(&mut bytes).unwrap();
    let header = usize::from(u16::from_le_bytes([bytes[8], bytes[9]]));
    assert!((10 + header).is_multiple_of(64));
    let text = String::from_utf8_lossy(&bytes[10..10 + header]);
    assert!(
        text.contains("'shape': (5,3,3,)") && text.ends_with('\n'),
        "{text}"
    );
    let numbers = bytes[10 + header..].chunks_exact(4);
    let found: Vec<f32> = numbers
        .map(|it| f32::from_le_bytes(it.try_into().unwrap()))
        .collect();
    assert_eq!(found, expected(1, 3));
}

#[test]
fn a_package_is_stored_and_every_file_in_it_begins_at_64_bytes() {
    let files = written(TakeFormat::Usdz);
    let stage = &written(TakeFormat::Usd)["dance.usdc"];
    assert_eq!(&stage[..8], b"PXR-USDC");
    let mut archive = zip::ZipArchive::new(Cursor::new(files["dance.usdz"].clone())).unwrap();
    assert_eq!(archive.len(), 2);
    for place in 0..archive.len() {
        let mut file = archive.by_index(place).unwrap();
        assert_eq!(file.compression(), zip::CompressionMethod::Stored);
        assert!(
            file.data_start().unwrap().is_multiple_of(64),
            "{}",
            file.name().unwrap()
        );
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes).unwrap();
        if place == 0 {
            assert_eq!(file.name().unwrap(), "dance.usdc");
            assert!(
                &bytes == stage,
                "the stage alone and in the package are one"
            );
        }
    }
}

#[test]
fn what_is_nowhere_is_in_no_file() {
    struct Lost(Sample);
    impl TakeSource for Lost {
        fn scene(&self) -> &TakeScene {
            self.0.scene()
        }
        fn vertices(&mut self, frame: u32, mesh: usize) -> io::Result<TakeVertices> {
            let mut vertices = self.0.vertices(frame, mesh)?;
            vertices[0][1].x = f32::NAN;
            Ok(vertices)
        }
        fn pose(&mut self, frame: u32) -> io::Result<Pose> {
            self.0.pose(frame)
        }
    }
    for format in [
        TakeFormat::Pc2,
        TakeFormat::Mdd,
        TakeFormat::Obj,
        TakeFormat::Npz,
        TakeFormat::Csv,
        TakeFormat::Usd,
        TakeFormat::Usdz,
    ] {
        let mut folder = Folder::default();
        let error = write_take(format, &mut Lost(Sample::new()), &mut folder).unwrap_err();
        assert!(
            error.to_string().contains("skirt: vertex 1"),
            "{format:?}: {error}"
        );
    }
}
