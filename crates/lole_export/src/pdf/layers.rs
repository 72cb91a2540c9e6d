//! A page of which a reader's window shows and hides parts.

use hayro_write::hayro_syntax::Pdf as ReadPdf;
use hayro_write::pdf_writer::types::PageMode;
use hayro_write::pdf_writer::{Content, Finish, Name, Pdf, Rect, Ref, TextStr};
use hayro_write::{ChunkSettings, ExtractionQuery, extract};
use lole_language::Language;

use super::sheet::{Item, Sheet};
use super::typeface::printable;
use super::write::Document;
use crate::ExportError;

/// A part of a page that is shown and hidden by its name.
#[derive(Debug, Clone, PartialEq)]
pub struct Layer {
    /// What a reader's window calls it.
    pub name: String,
    /// What is on it, the lowest first.
    pub items: Vec<Item>,
}

/// A page with layers over what is always seen.
#[derive(Debug, Clone, PartialEq)]
pub struct LayeredSheet {
    /// The page, and what is always seen. Its bookmarks are not written: there is one page.
    pub base: Sheet,
    /// Over it, the lowest first; at the beginning all are shown.
    pub layers: Vec<Layer>,
}

impl LayeredSheet {
    /// The page with everything on it.
    #[cfg(test)]
    pub(crate) fn flat(&self) -> Sheet {
        let mut sheet = self.base.clone();
        let layers = self.layers.iter();
        sheet
            .items
            .extend(layers.flat_map(|layer| layer.items.iter().cloned()));
        sheet
    }

    /// A PDF of the page under a title, with its layers as optional content (ISO 32000, 8.11); equal sheets give
    /// equal bytes.
    ///
    /// # Errors
    /// As [`Document::to_bytes`].
    pub fn to_bytes(&self, title: &str, language: Language) -> Result<Vec<u8>, ExportError> {
        let layers = self.layers.iter().map(|layer| Sheet {
            items: layer.items.clone(),
            ..Sheet::new(self.base.size)
        });
        let sheets = std::iter::once(self.base.clone()).chain(layers).collect();
        let document = Document::new(title, language, sheets);
        let names: Vec<String> = (self.layers.iter())
            .map(|layer| printable(&layer.name))
            .collect();
        let laid = one_over_another(document.to_bytes()?, &names, &document);
        laid.map_err(|cause| ExportError::Encoding { file: "PDF", cause })
    }
}

/// The pages of a document as one: the first always seen, each further one a layer of its name.
fn one_over_another(
    pages: Vec<u8>,
    names: &[String],
    document: &Document,
) -> Result<Vec<u8>, String> {
    let read = ReadPdf::new(pages).map_err(|error| format!("{error:?}"))?;
    let size = read.pages().first().map(|page| page.media_box());
    let size = size.ok_or("a document without a page")?;
    let mut next = Ref::new(1);
    let [catalog, info, page, contents] = [(); 4].map(|()| next.bump());
    let groups: Vec<Ref> = names.iter().map(|_| next.bump()).collect();
    let queries: Vec<ExtractionQuery> = (0..=names.len())
        .map(ExtractionQuery::new_xobject)
        .collect();
    let bump = Box::new(|| next.bump());
    let drawn = extract(&read, bump, ChunkSettings::default(), &queries)
        .map_err(|error| format!("{error:?}"))?;
    let mut pdf = Pdf::new();
    write_catalog(
        &mut pdf,
        [catalog, drawn.page_tree_parent_ref],
        &groups,
        document,
    );
    pdf.document_info(info)
        .title(TextStr(&printable(&document.title)))
        .producer(TextStr("Lole"));
    for (group, name) in groups.iter().zip(names) {
        let mut dict = pdf.indirect(*group).dict();
        dict.pair(Name(b"Type"), Name(b"OCG"));
        dict.pair(Name(b"Name"), TextStr(name));
    }
    pdf.pages(drawn.page_tree_parent_ref).kids([page]).count(1);
    let mut written = pdf.page(page);
    let corners = [size.x0, size.y0, size.x1, size.y1].map(lole_geom::narrow);
    let [left, bottom, right, top] = corners;
    written
        .media_box(Rect::new(left, bottom, right, top))
        .parent(drawn.page_tree_parent_ref)
        .contents(contents);
    let mut resources = written.resources();
    let mut objects = resources.x_objects();
    for (index, object) in drawn.root_refs.iter().enumerate() {
        let object = object.map_err(|error| format!("{error:?}"))?;
        objects.pair(Name(format!("X{index}").as_bytes()), object);
    }
    objects.finish();
    let mut properties = resources.insert(Name(b"Properties")).dict();
    for (index, group) in (1..).zip(&groups) {
        properties.pair(Name(format!("L{index}").as_bytes()), *group);
    }
    properties.finish();
    resources.finish();
    written.finish();
    pdf.stream(contents, &page_content(names.len()).finish());
    pdf.extend(&drawn.chunk);
    Ok(pdf.finish())
}

/// The root of a file whose layers a reader lists beside the page.
fn write_catalog(pdf: &mut Pdf, [id, pages]: [Ref; 2], groups: &[Ref], document: &Document) {
    let mut catalog = pdf.catalog(id);
    catalog
        .pages(pages)
        .page_mode(PageMode::UseOC)
        .lang(TextStr(document.language));
    catalog.viewer_preferences().display_doc_title(true);
    let mut layers = catalog.insert(Name(b"OCProperties")).dict();
    let listed = groups.iter().copied();
    layers.insert(Name(b"OCGs")).array().items(listed.clone());
    let mut shown = layers.insert(Name(b"D")).dict();
    shown.pair(Name(b"BaseState"), Name(b"ON"));
    // Readers list only what has a place in this order.
    shown.insert(Name(b"Order")).array().items(listed.clone());
    shown.insert(Name(b"ON")).array().items(listed);
}

/// The first drawing, and each further one as marked content of its layer.
fn page_content(layer_count: usize) -> Content {
    let mut content = Content::new();
    content.x_object(Name(b"X0"));
    for index in 1..=layer_count {
        content
            .begin_marked_content_with_properties(Name(b"OC"))
            .properties_named(Name(format!("L{index}").as_bytes()));
        content.x_object(Name(format!("X{index}").as_bytes()));
        content.end_marked_content();
    }
    content
}
