//! What a browser does for a page: files are chosen, dropped and downloaded.

use std::cell::RefCell;
use std::collections::VecDeque;
use std::path::PathBuf;
use std::sync::Arc;

use eframe::egui::{Context, DroppedFile};
use js_sys::{Array, Uint8Array};
use lole_files::shelf;
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast as _, JsValue};
use wasm_bindgen_futures::spawn_local;
use web_sys::{Blob, BlobPropertyBag, Document, Event, File, HtmlAnchorElement, HtmlInputElement};

use crate::chooser::ends_with_one_of;
use crate::platform::zip;

thread_local! {
    /// Files that were dropped and lie on the shelf by now.
    static DROPPED: RefCell<VecDeque<PathBuf>> = RefCell::default();
}

pub(super) fn document() -> Option<Document> {
    web_sys::window()?.document()
}

/// Notes on the page when something was seen for the first time, in milliseconds since it was asked for, as
/// `data-dancing`: whoever measures the page reads it there.
pub(crate) fn note(what: &str) {
    thread_local!(static NOTED: RefCell<Vec<String>> = const { RefCell::new(Vec::new()) });
    let is_new = NOTED.with_borrow_mut(|noted| {
        let is_new = noted.iter().all(|known| known != what);
        if is_new {
            noted.push(what.to_owned());
        }
        is_new
    });
    let root = document().and_then(|document| document.document_element());
    let clock = web_sys::window().and_then(|window| window.performance());
    if let (true, Some(root), Some(clock)) = (is_new, root, clock) {
        // A note that is not taken is missed by nobody who dances.
        drop(root.set_attribute(&format!("data-{what}"), &format!("{:.0}", clock.now())));
    }
}

/// A file that was dropped on the page, once its bytes are there. Of several dropped together the design is
/// opened; the others lie beside it.
pub(crate) fn take_dropped(context: &Context) -> Option<PathBuf> {
    let files = context.input(|input| input.raw.dropped_files.clone());
    if !files.is_empty() {
        let context = context.clone();
        spawn_local(async move {
            let mut names = Vec::new();
            for file in files {
                names.extend(laid(&file).await);
            }
            let is_design = |name: &&PathBuf| ends_with_one_of(name, &["lole"]);
            let opened = names.iter().find(is_design).or(names.first()).cloned();
            DROPPED.with_borrow_mut(|dropped| dropped.extend(opened));
            context.request_repaint();
        });
    }
    DROPPED.with_borrow_mut(VecDeque::pop_front)
}

/// Lays a dropped file on the shelf; its name.
async fn laid(file: &Arc<dyn DroppedFile + Send + Sync>) -> Option<PathBuf> {
    let path = file.path().to_owned();
    let bytes = file.bytes_async().await.ok()?;
    super::keeping::keep_file(&path, &bytes);
    shelf::lay(&path, bytes);
    Some(path)
}

/// Lets the user choose a file; `chosen` is called with its name when it lies on the shelf.
pub(super) fn choose(endings: &[&str], chosen: impl Fn(PathBuf) + 'static) -> Option<()> {
    let input = document()?.create_element("input").ok()?;
    let input: HtmlInputElement = input.unchecked_into();
    input.set_type("file");
    let endings: Vec<String> = endings.iter().map(|ending| format!(".{ending}")).collect();
    input.set_accept(&endings.join(","));
    input.set_id("chooser");
    input.set_hidden(true);
    let body = document()?.body()?;
    // One at a time: the one before was called off without a word, as browsers do.
    if let Some(before) = document()?.get_element_by_id("chooser") {
        before.remove();
    }
    body.append_child(&input).ok()?;
    let (own, chosen) = (input.clone(), std::rc::Rc::new(chosen));
    let changed = Closure::<dyn FnMut(Event)>::new(move |_| {
        let file = own.files().and_then(|files| files.get(0));
        own.remove();
        if let Some(file) = file {
            let chosen = std::rc::Rc::clone(&chosen);
            spawn_local(async move {
                if let Some(path) = read(&file).await {
                    chosen(path);
                }
            });
        }
    });
    input.set_onchange(Some(changed.as_ref().unchecked_ref()));
    // It is called at most once, when the page is asked nothing else.
    changed.forget();
    input.click();
    Some(())
}

async fn read(file: &File) -> Option<PathBuf> {
    let path = PathBuf::from(file.name());
    let buffer = wasm_bindgen_futures::JsFuture::from(file.array_buffer())
        .await
        .ok()?;
    let bytes = Uint8Array::new(&buffer).to_vec();
    super::keeping::keep_file(&path, &bytes);
    shelf::lay(&path, bytes);
    Some(path)
}

/// Hands out everything that was written: files of a folder as one archive.
pub(super) fn hand_out() {
    let mut single = Vec::new();
    let mut folders: Vec<(PathBuf, Vec<(String, Vec<u8>)>)> = Vec::new();
    for (path, bytes) in shelf::take_written() {
        let mut parts = path.components();
        let folder = PathBuf::from(parts.next().map_or("".as_ref(), |part| part.as_os_str()));
        // Archives part their folders by this sign on every system.
        let name = parts.as_path().to_string_lossy().replace('\\', "/");
        if name.is_empty() {
            single.push((folder.to_string_lossy().into_owned(), bytes));
        } else if let Some((_, files)) = folders.iter_mut().find(|(known, _)| *known == folder) {
            files.push((name, bytes));
        } else {
            folders.push((folder, vec![(name, bytes)]));
        }
    }
    for (name, bytes) in single {
        download(&name, &bytes);
    }
    for (folder, files) in folders {
        match zip::archive(&files) {
            Ok(archive) => drop(download(&format!("{}.zip", folder.display()), &archive)),
            Err(error) => web_sys::console::error_1(&error.to_string().into()),
        }
    }
}

/// Has the browser put a file where it puts downloads.
fn download(name: &str, bytes: &[u8]) -> Option<()> {
    let parts = Array::of1(&Uint8Array::from(bytes));
    let kind = BlobPropertyBag::new();
    kind.set_type("application/octet-stream");
    let blob = Blob::new_with_u8_array_sequence_and_options(&parts, &kind).ok()?;
    let address = web_sys::Url::create_object_url_with_blob(&blob).ok()?;
    let link: HtmlAnchorElement = document()?.create_element("a").ok()?.unchecked_into();
    link.set_href(&address);
    link.set_download(name);
    link.click();
    let release = Closure::once_into_js(move || {
        // It was an address a minute ago.
        drop(web_sys::Url::revoke_object_url(&address));
    });
    let wait: JsValue = release;
    drop(
        web_sys::window()?
            .set_timeout_with_callback_and_timeout_and_arguments_0(wait.unchecked_ref(), 60_000),
    );
    Some(())
}
