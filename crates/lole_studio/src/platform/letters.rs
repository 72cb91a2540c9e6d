//! What a page and its workers send each other, as parcels.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use lole_body::{Bone, Measure, Taped};
use lole_costume::document::{self, Design, StageMood, StageSet};
use lole_export::pdf::Paper;
use lole_files::{self as files, shelf};
use lole_geom::{Capsule, Length};
use lole_language::{Language, Sentence};
use lole_picture::{BodyPart, Cover, Looks, Moment, Scenery};
use lole_render::{BackShade, Camera, Material, Sides, Texture};
use lole_stage::{Divergence, PartNow, Pull, Vertices, Vitals};

use super::parcel::{Packer, Unpacker, get_vertices, put_vertices};
use crate::command::Watch;
use crate::history::Sample;
use crate::sim::News;
use crate::snapshot::{Net, Wardrobe};
use crate::{Command, Snapshot};

/// A design: its text. The files that it names lie on the receiver's shelf before.
pub(crate) fn put_design(packer: &mut Packer, design: &Design) {
    packer.text(&document::to_toml(design));
}

/// See [`put_design`].
pub(crate) fn get_design(unpacker: &mut Unpacker<'_>) -> Option<Design> {
    let mut design = document::parse(&unpacker.text()?, "").ok()?;
    // What is missing is told by whoever needs it.
    drop(files::read_linked_files(&mut design, Path::new("")));
    Some(design)
}

/// Lays a file on the receiver's shelf.
pub(crate) fn put_file(packer: &mut Packer, name: &str, bytes: &[u8]) {
    packer.text(name);
    packer.list(bytes);
}

/// See [`put_file`].
pub(crate) fn get_file(unpacker: &mut Unpacker<'_>) -> Option<()> {
    let name = unpacker.text()?;
    shelf::lay(Path::new(&name), unpacker.list::<u8>()?);
    Some(())
}

pub(crate) fn put_sentence(packer: &mut Packer, sentence: &Sentence) {
    packer.text(&sentence.japanese);
    packer.text(&sentence.english);
}

pub(crate) fn get_sentence(unpacker: &mut Unpacker<'_>) -> Option<Sentence> {
    Some(Sentence::new(unpacker.text()?, unpacker.text()?))
}

pub(crate) fn put_language(packer: &mut Packer, language: Language) {
    packer.flag(language == Language::Japanese);
}

pub(crate) fn get_language(unpacker: &mut Unpacker<'_>) -> Option<Language> {
    Some(if unpacker.flag()? {
        Language::Japanese
    } else {
        Language::English
    })
}

/// A paper size by its place in the list of all.
pub(crate) fn put_paper(packer: &mut Packer, paper: Paper) {
    let place = Paper::ALL.iter().position(|(known, _)| *known == paper);
    packer.count(place.unwrap_or(0));
}

pub(crate) fn get_paper(unpacker: &mut Unpacker<'_>) -> Option<Paper> {
    Some(Paper::ALL.get(unpacker.count()?)?.0)
}

pub(crate) fn put_command(packer: &mut Packer, command: &Command) {
    match command {
        Command::Play => packer.put(0_u8),
        Command::Pause => packer.put(1_u8),
        Command::Step => packer.put(2_u8),
        Command::Speed(speed) => {
            packer.put(3_u8);
            packer.put(*speed);
        }
        Command::Wish(design) => {
            packer.put(4_u8);
            put_design(packer, design);
        }
        Command::Reset => packer.put(5_u8),
        Command::Pull(pull) => {
            packer.put(6_u8);
            packer.maybe(pull.as_ref(), |packer, pull| {
                packer.put(pull.particle);
                packer.put(pull.hand);
            });
        }
        Command::Watch(watch) => {
            packer.put(7_u8);
            packer.flag(watch.strain);
            packer.flag(watch.sunken);
        }
        Command::Quit => packer.put(8_u8),
    }
}

pub(crate) fn get_command(unpacker: &mut Unpacker<'_>) -> Option<Command> {
    Some(match unpacker.get::<u8>()? {
        0 => Command::Play,
        1 => Command::Pause,
        2 => Command::Step,
        3 => Command::Speed(unpacker.get()?),
        4 => Command::Wish(Box::new(get_design(unpacker)?)),
        5 => Command::Reset,
        6 => Command::Pull(unpacker.maybe(|unpacker| {
            Some(Pull {
                particle: unpacker.get()?,
                hand: unpacker.get()?,
            })
        })?),
        7 => Command::Watch(Watch {
            strain: unpacker.flag()?,
            sunken: unpacker.flag()?,
        }),
        8 => Command::Quit,
        _ => return None,
    })
}

pub(crate) fn put_news(packer: &mut Packer, news: &News) {
    match news {
        News::Sewing => packer.put(0_u8),
        News::Sewn => packer.put(1_u8),
        News::Refused(sentence, kept) => {
            packer.put(2_u8);
            put_sentence(packer, sentence);
            put_design(packer, kept);
        }
        News::Elsewhere(wished, kept) => {
            packer.put(3_u8);
            put_design(packer, wished);
            put_design(packer, kept);
        }
    }
}

pub(crate) fn get_news(unpacker: &mut Unpacker<'_>) -> Option<News> {
    Some(match unpacker.get::<u8>()? {
        0 => News::Sewing,
        1 => News::Sewn,
        2 => News::Refused(get_sentence(unpacker)?, Box::new(get_design(unpacker)?)),
        3 => {
            let wished = Box::new(get_design(unpacker)?);
            News::Elsewhere(wished, Box::new(get_design(unpacker)?))
        }
        _ => return None,
    })
}

/// A material with its picture.
fn put_material(packer: &mut Packer, material: &Material) {
    packer.put(material.base_color);
    packer.maybe(material.texture.as_deref(), |packer, texture| {
        packer.put([texture.width(), texture.height()]);
        packer.list(texture.pixels());
    });
    packer.maybe(material.back, |packer, back| {
        packer.put(back.color);
        packer.put(back.fade);
    });
    packer.put([
        material.roughness,
        material.specular,
        material.sheen,
        material.translucency,
        material.wrap,
    ]);
    packer.put(material.subsurface);
    packer.flag(material.sides == Sides::Both);
}

fn get_material(unpacker: &mut Unpacker<'_>) -> Option<Material> {
    let base_color = unpacker.get()?;
    let texture = unpacker.maybe(|unpacker| {
        let [width, height] = unpacker.get()?;
        Texture::new(width, height, unpacker.list()?)
            .ok()
            .map(Arc::new)
    })?;
    let back = unpacker.maybe(|unpacker| {
        Some(BackShade {
            color: unpacker.get()?,
            fade: unpacker.get()?,
        })
    })?;
    let [roughness, specular, sheen, translucency, wrap] = unpacker.get()?;
    Some(Material {
        base_color,
        texture,
        back,
        roughness,
        specular,
        sheen,
        translucency,
        wrap,
        subsurface: unpacker.get()?,
        sides: if unpacker.flag()? {
            Sides::Both
        } else {
            Sides::Outward
        },
    })
}

fn put_looks(packer: &mut Packer, looks: &Looks) {
    packer.each(&looks.worn, |packer, cover| {
        put_material(packer, &cover.material);
        packer.list(&cover.triangles);
        packer.list(&cover.colors);
        packer.flag(cover.is_cloth);
        packer.list(&cover.uvs);
    });
    packer.each(&looks.parts, |packer, part| {
        put_material(packer, &part.material);
        packer.list(&part.triangles);
    });
    packer.list(&looks.skin_uvs);
    packer.list(&looks.skin_colors);
    put_scenery(packer, looks.scenery);
}

/// What is around her: places in the lists of sets and moods.
pub(crate) fn put_scenery(packer: &mut Packer, scenery: Scenery) {
    let set = (StageSet::ALL.iter()).position(|set| *set == scenery.set);
    packer.put(set.unwrap_or(0) as u64);
    let mood = (StageMood::ALL.iter()).position(|mood| *mood == scenery.mood);
    packer.put(mood.unwrap_or(0) as u64);
}

/// See [`put_scenery`].
pub(crate) fn get_scenery(unpacker: &mut Unpacker<'_>) -> Option<Scenery> {
    Some(Scenery {
        set: *StageSet::ALL.get(usize::try_from(unpacker.get::<u64>()?).ok()?)?,
        mood: *StageMood::ALL.get(usize::try_from(unpacker.get::<u64>()?).ok()?)?,
    })
}

fn get_looks(unpacker: &mut Unpacker<'_>) -> Option<Looks> {
    let worn = unpacker.each(|unpacker| {
        Some(Cover {
            material: get_material(unpacker)?,
            triangles: unpacker.list()?,
            colors: unpacker.list()?,
            is_cloth: unpacker.flag()?,
            uvs: unpacker.list()?,
            // Files that carry it are made elsewhere, and so are photographs.
            print: None,
            finer: None,
        })
    })?;
    let parts = unpacker.each(|unpacker| {
        Some(BodyPart {
            material: get_material(unpacker)?,
            triangles: unpacker.list()?,
        })
    })?;
    Some(Looks {
        worn,
        parts,
        skin_uvs: unpacker.list()?,
        skin_colors: unpacker.list()?,
        strands: None,
        finer_skin: None,
        scenery: get_scenery(unpacker)?,
    })
}

pub(crate) fn put_wardrobe(packer: &mut Packer, wardrobe: &Wardrobe) {
    packer.put(wardrobe.id);
    put_looks(packer, &wardrobe.looks);
    packer.put(wardrobe.crown_height);
    packer.each(&wardrobe.taped, |packer, taped| {
        packer.maybe(taped.given, |packer, given| packer.put(given.to_m()));
        packer.put(taped.on_body.to_m());
    });
    packer.each(&wardrobe.tailored_cm, |packer, cm| packer.put(*cm));
    packer.each(&wardrobe.nets, |packer, net| {
        packer.put(net.spacing);
        packer.list(&net.lines);
    });
    packer.each(&wardrobe.particle_of_vertex, |packer, of| packer.list(of));
    packer.each(&wardrobe.coarse_triangles, |packer, triangles| {
        packer.maybe(triangles.as_ref(), |packer, it| packer.list(it));
    });
}

pub(crate) fn get_wardrobe(unpacker: &mut Unpacker<'_>) -> Option<Wardrobe> {
    let id = unpacker.get()?;
    let looks = get_looks(unpacker)?;
    let crown_height = unpacker.get()?;
    let mut measures = Measure::ALL.iter();
    let taped = unpacker.each(|unpacker| {
        let given = unpacker.maybe(Unpacker::get)?;
        Some(Taped {
            measure: *measures.next()?,
            given: given.map(Length::from_m),
            on_body: Length::from_m(unpacker.get()?),
        })
    })?;
    Some(Wardrobe {
        id,
        looks,
        crown_height,
        taped: taped.try_into().ok()?,
        tailored_cm: (unpacker.each(Unpacker::get)?).try_into().ok()?,
        nets: unpacker.each(|unpacker| {
            Some(Net {
                spacing: unpacker.get()?,
                lines: unpacker.list()?,
            })
        })?,
        particle_of_vertex: unpacker.each(Unpacker::list)?,
        coarse_triangles: unpacker.each(|unpacker| unpacker.maybe(Unpacker::list))?,
    })
}

pub(crate) fn put_moment(packer: &mut Packer, moment: &Moment) {
    packer.each(&moment.worn, put_vertices);
    put_vertices(packer, &moment.body);
}

pub(crate) fn get_moment(unpacker: &mut Unpacker<'_>) -> Option<Moment> {
    Some(Moment {
        worn: unpacker.each(get_vertices)?,
        body: get_vertices(unpacker)?,
        strands: Vertices::default(),
    })
}

pub(crate) fn put_camera(packer: &mut Packer, camera: &Camera) {
    packer.put([camera.eye, camera.target]);
    packer.put(camera.vertical_fov);
}

pub(crate) fn get_camera(unpacker: &mut Unpacker<'_>) -> Option<Camera> {
    let [eye, target] = unpacker.get()?;
    Some(Camera {
        eye,
        target,
        vertical_fov: unpacker.get()?,
    })
}

fn put_sample(packer: &mut Packer, sample: &Sample) {
    let vitals = &sample.vitals;
    packer.put([sample.time, sample.milliseconds]);
    packer.put([vitals.kinetic_energy, vitals.potential_energy]);
    packer.maybe(vitals.elastic_energy, Packer::put);
    packer.put(vitals.hem_height);
    packer.put(vitals.hem_middle);
}

fn get_sample(unpacker: &mut Unpacker<'_>) -> Option<Sample> {
    let [time, milliseconds] = unpacker.get()?;
    let [kinetic_energy, potential_energy] = unpacker.get()?;
    Some(Sample {
        time,
        milliseconds,
        vitals: Vitals {
            kinetic_energy,
            potential_energy,
            elastic_energy: unpacker.maybe(Unpacker::get)?,
            hem_height: unpacker.get()?,
            hem_middle: unpacker.get()?,
        },
    })
}

/// A moment without its wardrobe, of which it has the number.
pub(crate) fn put_snapshot(packer: &mut Packer, snapshot: &Snapshot) {
    packer.put(snapshot.wardrobe.id);
    packer.put(snapshot.time);
    packer.list(&snapshot.particles);
    put_moment(packer, &snapshot.moment);
    packer.each(&snapshot.capsules, |packer, capsule| {
        packer.put(capsule.ends);
        packer.put(capsule.radii);
    });
    packer.list(&snapshot.bones);
    packer.list(&snapshot.strain);
    packer.list(&snapshot.sunken);
    packer.each(&snapshot.samples, put_sample);
    packer.maybe(snapshot.pace, Packer::put);
    packer.maybe(snapshot.part, |packer, part| {
        packer.count(part.index);
        packer.put(part.share);
    });
    packer.maybe(snapshot.recording_seconds, Packer::put);
    packer.put(snapshot.substep_count);
    packer.each(&snapshot.without_room, |packer, bone| {
        packer.text(bone.name());
    });
    packer.maybe(snapshot.stopped, |packer, stopped| {
        packer.put(stopped.time);
        packer.count(stopped.garment);
        packer.put([stopped.row, stopped.column]);
    });
}

/// See [`put_snapshot`]; a moment of a wardrobe that never came is none.
pub(crate) fn get_snapshot(
    unpacker: &mut Unpacker<'_>,
    wardrobes: &BTreeMap<u64, Arc<Wardrobe>>,
) -> Option<Snapshot> {
    let wardrobe = Arc::clone(wardrobes.get(&unpacker.get()?)?);
    Some(Snapshot {
        wardrobe,
        time: unpacker.get()?,
        particles: unpacker.list()?,
        moment: get_moment(unpacker)?,
        capsules: unpacker.each(|unpacker| {
            Some(Capsule {
                ends: unpacker.get()?,
                radii: unpacker.get()?,
            })
        })?,
        bones: unpacker.list()?,
        strain: unpacker.list()?,
        sunken: unpacker.list()?,
        samples: unpacker.each(get_sample)?,
        pace: unpacker.maybe(Unpacker::get)?,
        part: unpacker.maybe(|unpacker| {
            let (index, share) = (unpacker.count()?, unpacker.get()?);
            Some(PartNow { index, share })
        })?,
        recording_seconds: unpacker.maybe(Unpacker::get)?,
        substep_count: unpacker.get()?,
        without_room: unpacker.each(|unpacker| {
            let name = unpacker.text()?;
            let mut bones = Bone::ALL.iter();
            bones.find(|bone| bone.name() == name).copied()
        })?,
        stopped: unpacker.maybe(|unpacker| {
            let time = unpacker.get()?;
            let garment = unpacker.count()?;
            let [row, column] = unpacker.get()?;
            Some(Divergence {
                time,
                garment,
                row,
                column,
            })
        })?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sim::first_moment;

    /// Packs, unpacks and packs again: both parcels are the same bytes.
    fn returns<T>(
        value: &T,
        put: impl Fn(&mut Packer, &T),
        get: impl Fn(&mut Unpacker<'_>) -> Option<T>,
    ) -> T {
        let mut first = Packer::default();
        put(&mut first, value);
        let mut parcel = Unpacker(&first.0);
        let read = get(&mut parcel).unwrap();
        assert!(parcel.0.is_empty());
        let mut second = Packer::default();
        put(&mut second, &read);
        assert!(first.0 == second.0);
        // Half a parcel is none.
        let half = &first.0[..first.0.len() / 2];
        assert!(get(&mut Unpacker(half)).is_none() || first.0.len() < 2);
        read
    }

    fn small() -> Design {
        let mut design = Design::default();
        (design.skirt.column_count, design.skirt.row_count) = (96, 24);
        design
    }

    #[test]
    fn languages_and_papers_come_through() {
        for language in [Language::Japanese, Language::English] {
            let read = returns(&language, |to, it| put_language(to, *it), get_language);
            assert_eq!(read, language);
        }
        for (paper, _) in Paper::ALL {
            assert!(returns(&paper, |to, it| put_paper(to, *it), get_paper) == paper);
        }
    }

    #[test]
    fn a_moment_and_its_wardrobe_come_through_to_the_bit() {
        let snapshot = first_moment(&small()).unwrap();
        let wardrobe = returns(&*snapshot.wardrobe, put_wardrobe, get_wardrobe);
        let wardrobes = BTreeMap::from([(wardrobe.id, Arc::new(wardrobe))]);
        let read = returns(&snapshot, put_snapshot, |parcel| {
            get_snapshot(parcel, &wardrobes)
        });
        assert_eq!(read.moment, snapshot.moment);
        assert_eq!(read.wardrobe.taped, snapshot.wardrobe.taped);
        assert_eq!(read.wardrobe.tailored_cm, snapshot.wardrobe.tailored_cm);
        let none = BTreeMap::new();
        let mut parcel = Packer::default();
        put_snapshot(&mut parcel, &snapshot);
        assert!(get_snapshot(&mut Unpacker(&parcel.0), &none).is_none());
        returns(&snapshot.moment, put_moment, get_moment);
    }

    #[test]
    fn wishes_and_news_come_through_as_they_were() {
        let mut design = small();
        design.dancer.hip_cm = Some(98.5);
        let pull = Pull {
            particle: 7,
            hand: glam::Vec3::Y,
        };
        let watch = Watch {
            strain: true,
            sunken: false,
        };
        for command in [
            Command::Play,
            Command::Pause,
            Command::Step,
            Command::Speed(0.25),
            Command::Wish(Box::new(design.clone())),
            Command::Reset,
            Command::Pull(Some(pull)),
            Command::Pull(None),
            Command::Watch(watch),
            Command::Quit,
        ] {
            assert_eq!(returns(&command, put_command, get_command), command);
        }
        let sentence = Sentence::new("だめ", "no");
        for news in [
            News::Sewing,
            News::Sewn,
            News::Refused(sentence, Box::new(design.clone())),
            News::Elsewhere(Box::new(design), Box::new(small())),
        ] {
            assert_eq!(returns(&news, put_news, get_news), news);
        }
    }

    #[test]
    fn files_come_before_the_design_that_names_them() {
        let svg = b"<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"4\" height=\"2\"/>";
        let mut parcel = Packer::default();
        put_file(&mut parcel, "布.svg", svg);
        get_file(&mut Unpacker(&parcel.0)).unwrap();
        let text = "lole = 1\n[print]\nfile = \"布.svg\"\n";
        let mut design = document::parse(text, "").unwrap();
        assert_eq!(design.linked_names().collect::<Vec<_>>(), ["布.svg"]);
        drop(files::read_linked_files(&mut design, Path::new("")));
        let read = returns(&design, put_design, get_design);
        assert!(read.print.file.is_some_and(|file| file.picture.is_some()));
    }

    #[test]
    fn a_camera_comes_through() {
        let camera = Camera {
            eye: glam::Vec3::new(0.0, 1.2, 3.0),
            target: glam::Vec3::Y,
            vertical_fov: 0.5,
        };
        returns(&camera, put_camera, get_camera);
    }
}
