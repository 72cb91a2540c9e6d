//! What is written for one dancer, the folders that are looked into for it, and the picture.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::mpsc::TryRecvError;

use lole_export::{ImageView, pdf, still};
use lole_files as files;
use lole_language::Sentence;
use lole_render::Image;

use super::App;
use crate::making::{Piece, Product, Stage, Wish, with_ending};
use crate::message::Message;
use crate::studio::Purpose;
use crate::{chooser, reveal};

impl App {
    /// Begins to read a folder for the question.
    pub(super) fn list_folder(&mut self, folder: PathBuf) {
        let purpose = self.studio.question.as_ref().map(|it| it.purpose);
        let endings = purpose.map_or(&[][..], Purpose::endings);
        let context = self.context.clone();
        let listing = chooser::begin(folder, endings, move || context.request_repaint());
        self.listing = Some(listing);
    }

    /// Folders that were read, and what was made, since the last picture.
    pub(super) fn receive_products(&mut self) {
        match self.listing.as_ref().map(|listing| listing.try_recv()) {
            Some(Ok(listing)) => {
                self.listing = None;
                if let Some(question) = &mut self.studio.question {
                    question.listing = Some(Arc::new(listing));
                }
            }
            Some(Err(TryRecvError::Disconnected)) => self.listing = None,
            Some(Err(TryRecvError::Empty)) | None => {}
        }
        for (number, stage) in self.maker.news() {
            if let Some(piece) = self.studio.making.note(number, stage).cloned() {
                self.studio.message = told(&piece).or(self.studio.message.take());
            }
        }
        let mut troubles = self.reveals.iter().filter_map(|news| news.try_recv().ok());
        if let Some(sentence) = troubles.next_back() {
            self.studio.message = Some(Message::trouble(&sentence));
        }
        // Those that have ended tell nothing more.
        (self.reveals).retain(|news| news.try_recv() == Err(TryRecvError::Empty));
    }

    /// Puts a product of the design as it is now into the queue.
    pub(super) fn make(&mut self, product: Product, path: &Path) {
        if let Err(error) = self.studio.check() {
            self.studio.message = Some(Message::trouble(&error));
            return;
        }
        let path = match product.ending() {
            Some(ending) => with_ending(path, ending),
            None => path.to_owned(),
        };
        let wish = Wish {
            product,
            design: self.studio.design().clone(),
            path,
            paper: self.studio.order.wishes.paper,
            cutting: self.studio.cutting,
            language: self.studio.language,
            title: self.title(),
        };
        let piece = self.maker.ask(wish);
        self.studio.making.pieces.push(piece);
    }

    /// What the costume is called on paper.
    pub(super) fn title(&self) -> String {
        let stem = self.studio.path().and_then(Path::file_stem);
        stem.map_or_else(
            || "Pāʻū".to_owned(),
            |stem| pdf::printable(&stem.to_string_lossy()),
        )
    }

    pub(super) fn reveal(&mut self, path: &Path) {
        let context = self.context.clone();
        let news = reveal::begin(path, move || context.request_repaint());
        self.reveals.push(news);
    }

    /// Keeps the picture as it is now, and asks where it is to be written.
    pub(super) fn take_picture(&mut self) {
        match self.viewport.picture() {
            Some(Ok(image)) => {
                self.taken = Some(image);
                self.ask(Purpose::Picture);
            }
            Some(Err(error)) => {
                let text = error.to_string();
                let sentence = Sentence::new(format!("写真を撮れません（{text}）"), text);
                self.studio.message = Some(Message::trouble(&sentence));
            }
            None => {
                self.studio.message = Some(Message::trouble(&Sentence::new(
                    "まだ踊り手が見えていません。見えてから撮ってください。",
                    "The dancer is not there yet; take the picture when she is.",
                )));
            }
        }
    }

    pub(super) fn save_picture(&mut self, path: &Path) {
        let Some(image) = self.taken.take() else {
            return;
        };
        let path = with_ending(path, "png");
        let written = png(&image).and_then(|bytes| files::write_whole(&path, &bytes));
        self.studio.message = Some(match written {
            Ok(()) => {
                let path = std::fs::canonicalize(&path).unwrap_or(path);
                let name = path.display();
                let news = Message::news(
                    format!("写真を書きました: {name}"),
                    format!("The picture is in {name}"),
                );
                news.at(&path)
            }
            Err(sentence) => Message::trouble(&sentence),
        });
    }
}

/// What is said of a product that has ended; nothing where it was called off.
fn told(piece: &Piece) -> Option<Message> {
    let (name, path) = (piece.product.name(), piece.path.display());
    match &piece.stage {
        Stage::Done => {
            let news = Message::news(
                format!("{}ができました: {path}", name.japanese),
                format!("{}: done, in {path}", name.english),
            );
            Some(news.at(&piece.path))
        }
        Stage::Failed(sentence) => Some(Message::trouble(&Sentence::new(
            format!("{}: {}", name.japanese, sentence.japanese),
            format!("{}: {}", name.english, sentence.english),
        ))),
        Stage::Waiting | Stage::Working(_) | Stage::CalledOff => None,
    }
}

/// A picture as the bytes of a PNG.
fn png(image: &Image) -> Result<Vec<u8>, Sentence> {
    ImageView::new(image.width, image.height, &image.pixels)
        .and_then(still::encode_png)
        .map_err(|error| Sentence::new(format!("写真を作れません（{error}）"), error.to_string()))
}
