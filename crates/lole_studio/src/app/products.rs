//! What is written for one dancer, the folders that are looked into for it, and the picture.

use std::path::Path;
use std::sync::Arc;
use std::sync::mpsc::TryRecvError;

use lole_export::{ImageView, still};
use lole_files as files;
use lole_language::Sentence;
use lole_render::Image;

use super::App;
use crate::making::{Piece, Product, Stage, Wish, with_ending};
use crate::message::Message;
use crate::platform;
use crate::studio::{Purpose, Question};

impl App {
    /// What was made, and folders that cannot be shown, since the last picture.
    pub(super) fn receive_products(&mut self) {
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
        let list = self.studio.order.list.as_ref();
        let list = list.filter(|_| product == Product::GroupFilm);
        let wish = Wish {
            group: list.map(|(_, list)| (Arc::clone(list), self.studio.order.formation)),
            product,
            design: self.studio.design().clone(),
            path,
            paper: self.studio.order.wishes.paper,
            cutting: self.studio.cutting,
            language: self.studio.language,
            title: self.title(),
        };
        let piece = self.maker.ask(wish);
        if let Some(message) = told(&piece) {
            self.studio.message = Some(message);
        }
        self.studio.making.pieces.push(piece);
    }

    /// What the costume is called on paper.
    pub(super) fn title(&self) -> String {
        let own = self.studio.design().stage.title.trim();
        if !own.is_empty() {
            return own.to_owned();
        }
        let stem = self.studio.path().and_then(Path::file_stem);
        stem.map_or_else(
            || "Pāʻū".to_owned(),
            |stem| stem.to_string_lossy().into_owned(),
        )
    }

    pub(super) fn reveal(&mut self, path: &Path) {
        let context = self.context.clone();
        let news = platform::reveal(path, move || context.request_repaint());
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
        let path = with_ending(path, "png");
        match write_picture(&mut self.taken, &path) {
            Some(Ok(())) => {
                let path = std::fs::canonicalize(&path).unwrap_or(path);
                let name = path.display();
                let news = Message::news(
                    format!("写真を保存しました: {name}"),
                    format!("The picture is in {name}"),
                );
                self.studio.message = Some(news.at(&path));
            }
            Some(Err(sentence)) => {
                // Another place may take it.
                let mut question = Question::new(Purpose::Picture, path.display().to_string());
                question.note = Some(sentence);
                self.studio.question = Some(question);
                self.look_near(path);
            }
            None => {}
        }
    }
}

/// Writes the picture that was kept; until it is safe, it stays.
fn write_picture(taken: &mut Option<Image>, path: &Path) -> Option<Result<(), Sentence>> {
    let image = taken.as_ref()?;
    let written = png(image).and_then(|bytes| files::write_whole(path, &bytes));
    if written.is_ok() {
        *taken = None;
    }
    Some(written)
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
        Stage::Waiting | Stage::Working(_) | Stage::Stopping | Stage::CalledOff => None,
    }
}

/// A picture as the bytes of a PNG.
fn png(image: &Image) -> Result<Vec<u8>, Sentence> {
    ImageView::new(image.width, image.height, &image.pixels)
        .and_then(still::encode_png)
        .map_err(|error| Sentence::new(format!("写真を作れません（{error}）"), error.to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_that_cannot_be_written_is_kept() {
        let folder = std::env::temp_dir().join(format!("lole-taken-{}", std::process::id()));
        let path = folder.join("lole-1.png");
        let mut taken = Some(Image {
            width: 1,
            height: 1,
            pixels: vec![255; 4],
        });
        // The folder is not there.
        assert!(matches!(write_picture(&mut taken, &path), Some(Err(_))));
        assert!(taken.is_some());
        std::fs::create_dir_all(&folder).unwrap();
        assert_eq!(write_picture(&mut taken, &path), Some(Ok(())));
        assert!(taken.is_none() && path.exists());
        assert_eq!(write_picture(&mut taken, &path), None);
        std::fs::remove_dir_all(&folder).unwrap();
    }
}
