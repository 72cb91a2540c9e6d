//! The recording of a take: danced frame by frame into a file that grows, and goes on where it was stopped.

use std::fs::{self, File, OpenOptions};
use std::io::{self, BufReader, Write as _};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use lole_costume::document::{Design, to_toml};
use lole_export::take::TakeScene;
use lole_export::take::record::{RecordedTake, TakeHeader, append, frame_bytes};
use lole_geom::fnv;
use lole_language::{Language, Sentence};
use lole_picture::taken::{take_frame, take_scene};
use lole_stage::{Divergence, FRAMES_PER_SECOND, Performance, Production};
use lole_study::figures;

use crate::args::ExportArgs;
use crate::patience::{Watch, check, progress_bar};
use crate::{Failure, dance, summary};

/// Frames a second unless asked otherwise.
const FRAME_RATE: u32 = 30;
/// A take that is whole, and one that is not yet.
const WHOLE: &str = "dance.take";
const UNFINISHED: &str = "unfinished.take";

/// What is recorded, and how.
pub(super) struct Recorder<'a> {
    pub(super) args: &'a ExportArgs,
    pub(super) language: Language,
    pub(super) stop: &'a AtomicBool,
    pub(super) design: &'a Design,
}

/// A file that is being recorded.
struct Tape {
    file: File,
    header: TakeHeader,
    /// Bytes of the header.
    start: u64,
    /// Hashes of the frames that an earlier run has left, and that are the same until one differs.
    kept: Vec<[u8; 8]>,
}

impl Recorder<'_> {
    /// Dances, unless the folder has that very take already; gives its path.
    pub(super) fn record(&self, production: &Arc<Production>) -> Result<PathBuf, Failure> {
        let whole = self.args.out.join(WHOLE);
        let header = self.header(production)?;
        let is_there = read(&whole).is_some_and(|take| {
            *take.header() == header && take.whole_count() == header.frame_count
        });
        if is_there {
            return Ok(whole);
        }
        let path = self.args.out.join(UNFINISHED);
        let cannot = |error: io::Error| cannot_record(&path, &error, 0);
        let mut tape = Tape::open(&path, header).map_err(cannot)?;
        if !tape.kept.is_empty() {
            summary::print_found(&[found(&path, tape.kept.len())]);
        }
        self.dance(production, &mut tape, &path)
            .map_err(|failure| match failure {
                Failure::Interrupted => tape.left(&path),
                other => other,
            })?;
        tape.file.sync_all().map_err(cannot)?;
        drop(tape);
        fs::rename(&path, &whole).map_err(cannot)?;
        lole_files::sync_folder(&self.args.out);
        Ok(whole)
    }

    fn header(&self, production: &Production) -> Result<TakeHeader, Failure> {
        let looks = super::looks(self.design, production)?;
        let scene = take_scene(production, &looks.worn).map_err(Failure::error)?;
        let frame_rate = self.args.fps.unwrap_or(FRAME_RATE);
        let whole = production.dance.whole(self.design.motion.repeat);
        let frames = dance::frame_count(self.design.duration_s(whole));
        Ok(TakeHeader {
            lole: env!("CARGO_PKG_VERSION").to_owned(),
            frame_rate,
            frame_count: frames.div_ceil(FRAMES_PER_SECOND / frame_rate),
            design: to_toml(self.design),
            files_hash: files_hash(self.design),
            meshes: named(&scene),
        })
    }

    /// What is kept of an earlier run is danced through again, for the cloth to come to where it was, and looked at:
    /// from the first frame that is not the same, everything is recorded anew.
    fn dance(
        &self,
        production: &Arc<Production>,
        tape: &mut Tape,
        path: &Path,
    ) -> Result<(), Failure> {
        let mut performance = Performance::new(Arc::clone(production))
            .map_err(|error| Failure::Usage(error.into()))?;
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(dance::thread_count(self.args.threads))
            .build()
            .map_err(Failure::error)?;
        let diverged = |found: &Divergence| {
            let said = figures::explain(found, production, self.design);
            Failure::Diverged(Sentence::new(said.sentence_ja, said.sentence))
        };
        dance::settle_on(&mut performance, &pool, (self.stop, self.language))?
            .map_or(Ok(()), |found| Err(diverged(&found)))?;
        let stride = FRAMES_PER_SECOND / tape.header.frame_rate;
        let bar = progress_bar(
            tape.header.frame_count,
            self.language.pick("踊る", "dancing"),
        );
        let patience = Watch::over(&bar, self.language);
        for frame in 0..tape.header.frame_count {
            check(self.stop)?;
            performance.pose_body();
            let (pose, meshes) = take_frame(&performance);
            let written = tape.put(frame, &frame_bytes(&pose, &meshes));
            written.map_err(|error| cannot_record(path, &error, frame))?;
            bar.inc(1);
            if frame + 1 == tape.header.frame_count {
                break;
            }
            for _ in 0..stride {
                let moved = pool.install(|| performance.advance());
                moved.map_err(|found| diverged(&found))?;
                patience.tell(performance.pressed_count());
            }
        }
        drop(patience);
        bar.finish_and_clear();
        Ok(())
    }
}

impl Tape {
    /// Opens a recording of the same take that was stopped, or begins one.
    fn open(path: &Path, header: TakeHeader) -> io::Result<Self> {
        let mut kept = Vec::new();
        if let Some(mut take) = read(path).filter(|take| *take.header() == header) {
            let hashes = (0..take.whole_count()).map(|frame| take.hash(frame));
            kept = hashes.collect::<io::Result<_>>()?;
        }
        let bytes = header.bytes()?;
        let mut file = OpenOptions::new()
            .create(true)
            .truncate(kept.is_empty())
            .write(true)
            .open(path)?;
        if kept.is_empty() {
            file.write_all(&bytes)?;
        }
        let mut tape = Self {
            file,
            start: bytes.len() as u64,
            kept,
            header,
        };
        tape.cut(tape.kept.len())?;
        Ok(tape)
    }

    /// What is told when the recording is stopped: a tape without a frame is not kept.
    fn left(&self, path: &Path) -> Failure {
        let size = self.file.metadata().map_or(0, |it| it.len());
        let frames = size.saturating_sub(self.start) / self.header.frame_bytes() as u64;
        if frames == 0 {
            // Whoever records next begins anew, whether or not it can be removed.
            drop(fs::remove_file(path));
            return Failure::Interrupted;
        }
        let path = path.display();
        Failure::Paused(Sentence::new(
            format!(
                "中止しました。{path} に {frames} コマ残してあり、同じコマンドでその続きから録れます。"
            ),
            format!(
                "stopped; {path} keeps {frames} frames, and the same command goes on from there."
            ),
        ))
    }

    /// Leaves so many frames, whole ones.
    fn cut(&mut self, frames: usize) -> io::Result<()> {
        self.kept.truncate(frames);
        let size = self.start + frames as u64 * self.header.frame_bytes() as u64;
        self.file.set_len(size)
    }

    /// Records a frame, unless it is there. What a full disk took of it is cut off again.
    fn put(&mut self, frame: u32, bytes: &[u8]) -> io::Result<()> {
        let place = frame as usize;
        let hash = &bytes[bytes.len() - 8..];
        if let Some(kept) = self.kept.get(place) {
            if kept == hash {
                return Ok(());
            }
            self.cut(place)?;
        }
        let at = self.start + place as u64 * bytes.len() as u64;
        let written = append(&mut self.file, at, bytes);
        if written.is_err() {
            // The first failure is the one that is told.
            drop(self.cut(place));
        }
        written
    }
}

fn read(path: &Path) -> Option<RecordedTake<BufReader<File>>> {
    RecordedTake::open(BufReader::new(File::open(path).ok()?)).ok()
}

/// Names and vertices of a take's meshes.
pub(super) fn named(scene: &TakeScene) -> Vec<(String, usize)> {
    let meshes = scene.meshes.iter();
    meshes
        .map(|mesh| (mesh.name.clone(), mesh.vertex_count))
        .collect()
}

/// Hash of the avatar and the recorded motion of a design.
pub(super) fn files_hash(design: &Design) -> u64 {
    let files = [&design.dancer.file, &design.motion.file];
    let bytes = files
        .into_iter()
        .flatten()
        .filter_map(|file| file.bytes.as_deref());
    fnv::hash(bytes.flatten().copied())
}

fn found(path: &Path, frames: usize) -> Sentence {
    let name = path.display();
    Sentence::new(
        format!("{name}: {frames} コマが記録されています。確かめながら踊り直し、続きを記録します"),
        format!(
            "{name}: {frames} frames are recorded; they are danced again, compared, and then it goes on"
        ),
    )
}

fn cannot_record(path: &Path, error: &io::Error, frames: u32) -> Failure {
    let name = path.display();
    Failure::error(Sentence::new(
        format!(
            "{name}: 記録できません（{error}）。{frames} コマはそろっています。空きを作ってもう一度実行すると続きから始まり、このファイルを lole export に渡せばそこまでを書き出せます"
        ),
        format!(
            "{name}: cannot be recorded ({error}); {frames} frames are whole: make room and run it again to go on, or give this file to `lole export` to have those"
        ),
    ))
}
