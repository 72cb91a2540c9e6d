//! Files without folders: where a program runs in a page, those that were handed to it lie here, and what it
//! writes waits here to be handed out.
//!
//! Like a disk it is one for the whole program, but for each thread of its own, because threads of a page share
//! nothing. In a window it stays empty.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

#[derive(Default)]
struct Shelf {
    files: BTreeMap<PathBuf, Arc<[u8]>>,
    written: Vec<(PathBuf, Vec<u8>)>,
}

thread_local! {
    static SHELF: RefCell<Shelf> = RefCell::default();
}

/// Whether files lie here and not in folders.
pub const IS_ALL: bool = cfg!(target_arch = "wasm32");

/// Lays a file down, instead of one that has its name.
pub fn lay(path: &Path, bytes: impl Into<Arc<[u8]>>) {
    let bytes = bytes.into();
    SHELF.with_borrow_mut(|shelf| shelf.files.insert(path.to_owned(), bytes));
}

/// A file that was laid down.
#[must_use]
pub fn find(path: &Path) -> Option<Arc<[u8]>> {
    SHELF.with_borrow(|shelf| shelf.files.get(path).cloned())
}

/// Leaves a file to be handed out; read again, it is what was written.
pub fn write(path: &Path, bytes: &[u8]) {
    lay(path, bytes);
    SHELF.with_borrow_mut(|shelf| shelf.written.push((path.to_owned(), bytes.to_vec())));
}

/// What was written since the last time, in its order.
#[must_use]
pub fn take_written() -> Vec<(PathBuf, Vec<u8>)> {
    SHELF.with_borrow_mut(|shelf| std::mem::take(&mut shelf.written))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_handed_out_once_and_can_be_read_again() {
        let path = Path::new("shelf/縫い方.pdf");
        write(path, b"%PDF");
        assert_eq!(find(path).as_deref(), Some(&b"%PDF"[..]));
        assert_eq!(take_written(), [(path.to_owned(), b"%PDF".to_vec())]);
        assert!(take_written().is_empty());
    }
}
