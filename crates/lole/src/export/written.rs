//! Between a take and its files: progress, interruption, and what is said of a disk that is full.

use std::fs::File;
use std::io::{self, BufReader};
use std::sync::atomic::{AtomicBool, Ordering};

use indicatif::ProgressBar;
use lole_body::Pose;
use lole_export::take::record::StagedTake;
use lole_export::take::{TakeFile, TakeFolder, TakeScene, TakeSource, TakeVertices};
use lole_files::OutputFolder;
use lole_language::Sentence;

use crate::Failure;

/// A folder that a take is written into.
pub(super) struct Files(pub(super) OutputFolder);

impl TakeFolder for Files {
    fn create(&mut self, name: &str) -> io::Result<Box<dyn TakeFile + '_>> {
        Ok(Box::new(self.0.begin(name)?))
    }
}

/// A take that says how far its writing has come, and ends it when it is called off.
pub(super) struct Watched<'a> {
    pub(super) take: StagedTake<BufReader<File>>,
    pub(super) bar: &'a ProgressBar,
    pub(super) stop: &'a AtomicBool,
}

impl TakeSource for Watched<'_> {
    fn scene(&self) -> &TakeScene {
        self.take.scene()
    }

    fn vertices(&mut self, frame: u32, mesh: usize) -> io::Result<TakeVertices> {
        if self.stop.load(Ordering::Relaxed) {
            return Err(io::Error::other("called off"));
        }
        self.bar.inc(1);
        self.take.vertices(frame, mesh)
    }

    fn pose(&mut self, frame: u32) -> io::Result<Pose> {
        self.take.pose(frame)
    }
}

/// Why files were not written.
pub(super) fn failure(error: &io::Error, stop: &AtomicBool) -> Failure {
    if stop.load(Ordering::Relaxed) {
        return Failure::Interrupted;
    }
    Failure::error(Sentence::new(
        format!(
            "ファイルを書けませんでした（{error}）。何も書いていません。空きを作り、もう一度実行してください（記録は残っています）"
        ),
        format!(
            "the files cannot be written ({error}), and none was; make room and run it again: the take is kept"
        ),
    ))
}
