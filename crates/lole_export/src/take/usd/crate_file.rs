//! A USD crate, version 0.8: what `.usdc` files are, as OpenUSD reads them.
//!
//! A head that says where the table of contents is; values; then six sections: tokens, strings, fields (a name and a
//! value), sets of fields, paths (a tree), and specs (a path, its set of fields, its kind).
//! A value is eight bytes: its type, and either itself or where it is. Nothing in it depends on what the moving
//! vertices are, only on how many, so everything is laid out before the first of them is read.

use std::collections::BTreeMap;

use super::encode::{block, integers};

/// First bytes, and the version: the oldest one that OpenUSD reads without a warning, so that old programs read it too.
const MAGIC: &[u8; 8] = b"PXR-USDC";
const VERSION: [u8; 8] = [0, 8, 0, 0, 0, 0, 0, 0];
/// Bytes of the head.
const HEAD: usize = 88;
/// A token that stands first because names of properties are counted downward from 0, which has no negative.
const FIRST_TOKEN: &str = ";-)";
/// Ends a set of fields.
const END_OF_SET: u32 = u32::MAX;
/// Values begin at multiples of this.
const ALIGNMENT: usize = 8;

/// Types of values.
#[derive(Debug, Clone, Copy)]
pub(super) enum Kind {
    Bool = 1,
    Int = 3,
    Float = 8,
    Double = 9,
    String = 10,
    Token = 11,
    Asset = 12,
    Vec2f = 20,
    Vec3f = 24,
    Vec4f = 28,
    TokenListOp = 32,
    PathListOp = 34,
    TokenVector = 41,
    Specifier = 42,
    Variability = 44,
    TimeSamples = 46,
    DoubleVector = 48,
}

/// Kinds of specs.
#[derive(Debug, Clone, Copy)]
pub(super) enum SpecKind {
    Attribute = 1,
    Prim = 6,
    Root = 7,
    Relationship = 8,
}

/// A value: type, and itself or its place.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rep(u64);

impl Rep {
    const IS_ARRAY: u64 = 1 << 63;
    const IS_INLINED: u64 = 1 << 62;

    const fn inlined(kind: Kind, bits: u32) -> Self {
        Self(Self::IS_INLINED | (kind as u64) << 48 | bits as u64)
    }

    const fn at(kind: Kind, place: u64) -> Self {
        Self((kind as u64) << 48 | place)
    }

    const fn array(kind: Kind, place: u64) -> Self {
        Self(Self::IS_ARRAY | (kind as u64) << 48 | place)
    }

    #[expect(clippy::fn_params_excessive_bools, reason = "the value itself")]
    pub(super) const fn bool(value: bool) -> Self {
        Self::inlined(Kind::Bool, value as u32)
    }

    pub(super) const fn float(value: f32) -> Self {
        Self::inlined(Kind::Float, value.to_bits())
    }

    /// A number that `f32` has exactly; such are kept as one.
    pub(super) const fn double(value: f32) -> Self {
        Self::inlined(Kind::Double, value.to_bits())
    }

    pub(super) const fn define() -> Self {
        Self::inlined(Kind::Specifier, 0)
    }

    pub(super) const fn uniform() -> Self {
        Self::inlined(Kind::Variability, 1)
    }
}

/// What lies between head and sections.
#[derive(Debug)]
pub(super) enum Piece {
    /// Bytes that are known.
    Bytes(Vec<u8>),
    /// Points, normals and extent of a mesh in a frame, each an array.
    Frame { mesh: u32, frame: u32 },
}

/// A path with its spec.
#[derive(Debug)]
struct Node {
    element: u32,
    children: Vec<usize>,
    kind: SpecKind,
    fields: Vec<(u32, Rep)>,
}

/// Place of a path in the tree.
#[derive(Debug, Clone, Copy)]
pub(super) struct Path(usize);

/// A crate as it grows.
#[derive(Debug)]
pub(super) struct CrateFile {
    tokens: Vec<String>,
    token_places: BTreeMap<String, u32>,
    strings: Vec<u32>,
    nodes: Vec<Node>,
    pieces: Vec<Piece>,
    /// Where the next piece begins.
    end: usize,
}

/// A crate that can be written from its first byte to its last.
#[derive(Debug)]
pub(super) struct LaidOut {
    pub(super) head: Vec<u8>,
    pub(super) pieces: Vec<Piece>,
    pub(super) tail: Vec<u8>,
}

/// Bytes of an array of so many vectors, with its length before and zeros behind.
pub(super) const fn array_bytes(count: usize) -> usize {
    (8 + 12 * count).next_multiple_of(ALIGNMENT)
}

impl CrateFile {
    pub(super) fn new() -> Self {
        let mut file = Self {
            tokens: Vec::new(),
            token_places: BTreeMap::new(),
            strings: Vec::new(),
            nodes: Vec::new(),
            pieces: Vec::new(),
            end: HEAD,
        };
        file.token_place(FIRST_TOKEN);
        let element = file.token_place("");
        file.push_node(element, SpecKind::Root);
        file
    }

    pub(super) const ROOT: Path = Path(0);

    fn push_node(&mut self, element: u32, kind: SpecKind) -> Path {
        self.nodes.push(Node {
            element,
            children: Vec::new(),
            kind,
            fields: Vec::new(),
        });
        Path(self.nodes.len() - 1)
    }

    fn child(&mut self, parent: Path, name: &str, kind: SpecKind) -> Path {
        let element = self.token_place(name);
        let child = self.push_node(element, kind);
        self.nodes[parent.0].children.push(child.0);
        child
    }

    /// Defines a prim.
    pub(super) fn prim(&mut self, parent: Path, name: &str, type_name: &str) -> Path {
        let prim = self.child(parent, name, SpecKind::Prim);
        self.field(prim, "specifier", Rep::define());
        if !type_name.is_empty() {
            let kind = self.token(type_name);
            self.field(prim, "typeName", kind);
        }
        prim
    }

    /// Adds an attribute; `value` is its `default`, where it has one.
    pub(super) fn attribute(
        &mut self,
        prim: Path,
        (type_name, name): (&str, &str),
        value: Option<Rep>,
    ) -> Path {
        let attribute = self.child(prim, name, SpecKind::Attribute);
        let kind = self.token(type_name);
        self.field(attribute, "typeName", kind);
        if let Some(value) = value {
            self.field(attribute, "default", value);
        }
        attribute
    }

    /// Adds an attribute that never varies.
    pub(super) fn constant(&mut self, prim: Path, name: (&str, &str), value: Rep) -> Path {
        let attribute = self.attribute(prim, name, Some(value));
        self.field(attribute, "variability", Rep::uniform());
        attribute
    }

    /// Adds a relationship to one target.
    pub(super) fn relationship(&mut self, prim: Path, name: &str, target: Path) {
        let relationship = self.child(prim, name, SpecKind::Relationship);
        self.field(relationship, "variability", Rep::uniform());
        let target = self.paths(&[target]);
        self.field(relationship, "targetPaths", target);
    }

    /// Connects an attribute to another.
    pub(super) fn connect(&mut self, attribute: Path, source: Path) {
        let source = self.paths(&[source]);
        self.field(attribute, "connectionPaths", source);
    }

    pub(super) fn field(&mut self, path: Path, name: &str, value: Rep) {
        let name = self.token_place(name);
        self.nodes[path.0].fields.push((name, value));
    }

    fn token_place(&mut self, text: &str) -> u32 {
        if let Some(&place) = self.token_places.get(text) {
            return place;
        }
        let place = count(self.tokens.len());
        self.tokens.push(text.to_owned());
        self.token_places.insert(text.to_owned(), place);
        place
    }

    pub(super) fn token(&mut self, text: &str) -> Rep {
        Rep::inlined(Kind::Token, self.token_place(text))
    }

    pub(super) fn asset(&mut self, text: &str) -> Rep {
        Rep::inlined(Kind::Asset, self.token_place(text))
    }

    pub(super) fn string(&mut self, text: &str) -> Rep {
        let token = self.token_place(text);
        self.strings.push(token);
        Rep::inlined(Kind::String, count(self.strings.len() - 1))
    }

    /// Keeps bytes and says where they are.
    fn keep(&mut self, mut bytes: Vec<u8>) -> u64 {
        bytes.resize(bytes.len().next_multiple_of(ALIGNMENT), 0);
        let place = self.end as u64;
        self.end += bytes.len();
        match self.pieces.last_mut() {
            Some(Piece::Bytes(before)) => before.append(&mut bytes),
            _ => self.pieces.push(Piece::Bytes(bytes)),
        }
        place
    }

    /// Values of one width, with their number before.
    fn keep_array<const BYTES: usize>(
        &mut self,
        values: impl ExactSizeIterator<Item = [u8; BYTES]>,
    ) -> u64 {
        let mut bytes = (values.len() as u64).to_le_bytes().to_vec();
        bytes.extend(values.flatten());
        self.keep(bytes)
    }

    fn paths(&mut self, targets: &[Path]) -> Rep {
        let places: Vec<u32> = targets.iter().map(|path| count(path.0)).collect();
        // Explicit, and it has explicit items.
        let place = self.keep_list(0b11, &places);
        Rep::at(Kind::PathListOp, place)
    }

    /// Schemas that a prim has besides its type.
    pub(super) fn prepended(&mut self, words: &[&str]) -> Rep {
        let places: Vec<u32> = words.iter().map(|word| self.token_place(word)).collect();
        // It has prepended items.
        let place = self.keep_list(0b10_0000, &places);
        Rep::at(Kind::TokenListOp, place)
    }

    fn keep_list(&mut self, header: u8, items: &[u32]) -> u64 {
        let mut bytes = vec![header];
        bytes.extend((items.len() as u64).to_le_bytes());
        bytes.extend(items.iter().flat_map(|item| item.to_le_bytes()));
        self.keep(bytes)
    }

    pub(super) fn vector(&mut self, vector: [f32; 3]) -> Rep {
        let bytes = vector.into_iter().flat_map(f32::to_le_bytes).collect();
        Rep::at(Kind::Vec3f, self.keep(bytes))
    }

    pub(super) fn vector4(&mut self, vector: [f32; 4]) -> Rep {
        let bytes = vector.into_iter().flat_map(f32::to_le_bytes).collect();
        Rep::at(Kind::Vec4f, self.keep(bytes))
    }

    pub(super) fn integers(&mut self, values: &[u32]) -> Rep {
        let place = self.keep_array(values.iter().map(|value| value.to_le_bytes()));
        Rep::array(Kind::Int, place)
    }

    pub(super) fn vectors2(&mut self, values: &[[f32; 2]]) -> Rep {
        let place = self.keep_array(values.iter().map(|[x, y]| {
            let mut bytes = [0; 8];
            bytes[..4].copy_from_slice(&x.to_le_bytes());
            bytes[4..].copy_from_slice(&y.to_le_bytes());
            bytes
        }));
        Rep::array(Kind::Vec2f, place)
    }

    pub(super) fn vectors3(&mut self, values: &[[f32; 3]]) -> Rep {
        let place = self.keep_array(values.iter().map(|[x, y, z]| {
            let mut bytes = [0; 12];
            bytes[..4].copy_from_slice(&x.to_le_bytes());
            bytes[4..8].copy_from_slice(&y.to_le_bytes());
            bytes[8..].copy_from_slice(&z.to_le_bytes());
            bytes
        }));
        Rep::array(Kind::Vec3f, place)
    }

    /// Times of samples, for [`Self::samples`].
    pub(super) fn times(&mut self, times: &[f64]) -> Rep {
        let place = self.keep_array(times.iter().map(|time| time.to_le_bytes()));
        Rep::at(Kind::DoubleVector, place)
    }

    /// Makes room for a frame of a mesh; points, normals and extent.
    pub(super) fn frame(&mut self, (mesh, frame): (u32, u32), vertex_count: usize) -> [Rep; 3] {
        self.pieces.push(Piece::Frame { mesh, frame });
        [vertex_count, vertex_count, 2].map(|count| {
            let place = self.end as u64;
            self.end += array_bytes(count);
            Rep::array(Kind::Vec3f, place)
        })
    }

    /// A value for each of the times. Each of the two parts says how far behind its own beginning it goes on.
    pub(super) fn samples(&mut self, times: Rep, values: &[Rep]) -> Rep {
        let on = 8_i64.to_le_bytes();
        let mut bytes = [&on[..], &times.0.to_le_bytes(), &on].concat();
        bytes.extend((values.len() as u64).to_le_bytes());
        bytes.extend(values.iter().flat_map(|value| value.0.to_le_bytes()));
        Rep::at(Kind::TimeSamples, self.keep(bytes))
    }

    /// Names the children of every path, lays out the sections and the head.
    pub(super) fn laid_out(mut self) -> LaidOut {
        self.name_children();
        let mut tail = Vec::new();
        let mut contents: Vec<(&str, usize, usize)> = Vec::new();
        let sections = [
            ("TOKENS", self.token_section()),
            ("STRINGS", self.string_section()),
            ("FIELDS", self.field_section()),
            ("FIELDSETS", self.set_section()),
            ("PATHS", self.path_section()),
            ("SPECS", self.spec_section()),
        ];
        for (name, bytes) in sections {
            contents.push((name, self.end + tail.len(), bytes.len()));
            tail.extend(bytes);
        }
        let table = self.end + tail.len();
        tail.extend((contents.len() as u64).to_le_bytes());
        for (name, start, size) in contents {
            let mut padded = [0; 16];
            padded[..name.len()].copy_from_slice(name.as_bytes());
            tail.extend(padded);
            tail.extend((start as u64).to_le_bytes());
            tail.extend((size as u64).to_le_bytes());
        }
        let mut head = [&MAGIC[..], &VERSION, &(table as u64).to_le_bytes()].concat();
        head.resize(HEAD, 0);
        LaidOut {
            head,
            pieces: self.pieces,
            tail,
        }
    }

    fn name_children(&mut self) {
        for place in 0..self.nodes.len() {
            for (is_wanted, field) in [(true, "primChildren"), (false, "properties")] {
                let children = self.nodes[place].children.iter();
                let names: Vec<u32> = children
                    .map(|&child| &self.nodes[child])
                    .filter(|child| matches!(child.kind, SpecKind::Prim) == is_wanted)
                    .map(|child| child.element)
                    .collect();
                if !names.is_empty() {
                    let at = self.keep_array(names.iter().map(|name| name.to_le_bytes()));
                    self.field(Path(place), field, Rep::at(Kind::TokenVector, at));
                }
            }
        }
    }

    fn token_section(&self) -> Vec<u8> {
        let mut text = Vec::new();
        for token in &self.tokens {
            text.extend_from_slice(token.as_bytes());
            text.push(0);
        }
        let packed = block(&text);
        let sizes = [self.tokens.len(), text.len(), packed.len()];
        let sizes = sizes.map(|size| (size as u64).to_le_bytes());
        [sizes.as_flattened(), &packed].concat()
    }

    fn string_section(&self) -> Vec<u8> {
        let mut bytes = (self.strings.len() as u64).to_le_bytes().to_vec();
        bytes.extend(self.strings.iter().flat_map(|token| token.to_le_bytes()));
        bytes
    }

    fn field_section(&self) -> Vec<u8> {
        let fields = || self.nodes.iter().flat_map(|node| &node.fields);
        let names: Vec<u32> = fields().map(|(name, _)| *name).collect();
        let values: Vec<u8> = fields()
            .flat_map(|(_, value)| value.0.to_le_bytes())
            .collect();
        let packed = block(&values);
        let sizes = [names.len(), packed.len()].map(|size| (size as u64).to_le_bytes());
        [&sizes[0][..], &integers(&names), &sizes[1], &packed].concat()
    }

    /// A set for each spec, in the order of the paths, with its fields in their order.
    fn set_section(&self) -> Vec<u8> {
        let mut sets = Vec::new();
        let mut field = 0;
        for node in &self.nodes {
            sets.extend((field..).take(node.fields.len()));
            field += count(node.fields.len());
            sets.push(END_OF_SET);
        }
        [&(sets.len() as u64).to_le_bytes()[..], &integers(&sets)].concat()
    }

    fn path_section(&self) -> Vec<u8> {
        let mut tree = Tree::default();
        tree.add(&self.nodes, (0, false));
        let size = (self.nodes.len() as u64).to_le_bytes();
        let lists = [&tree.paths, &tree.elements, &tree.jumps].map(|list| integers(list));
        [&size[..], &size, &lists.concat()].concat()
    }

    fn spec_section(&self) -> Vec<u8> {
        let paths: Vec<u32> = (0..count(self.nodes.len())).collect();
        let sets = self.nodes.iter().scan(0, |next, node| {
            let set = *next;
            *next += count(node.fields.len()) + 1;
            Some(set)
        });
        let sets: Vec<u32> = sets.collect();
        let kinds: Vec<u32> = self.nodes.iter().map(|node| node.kind as u32).collect();
        let size = (self.nodes.len() as u64).to_le_bytes();
        let lists = [&paths, &sets, &kinds].map(|list| integers(list));
        [&size[..], &lists.concat()].concat()
    }
}

/// Paths as a tree, depth first. A jump says what follows: -2 neither child nor sibling, -1 a child alone, 0 a
/// sibling alone, else both, and how far on the sibling is. Names of properties are counted downward.
#[derive(Debug, Default)]
struct Tree {
    paths: Vec<u32>,
    elements: Vec<u32>,
    jumps: Vec<u32>,
}

impl Tree {
    fn add(&mut self, nodes: &[Node], (place, has_sibling): (usize, bool)) {
        let node = &nodes[place];
        let own = self.paths.len();
        self.paths.push(count(place));
        let is_property = matches!(node.kind, SpecKind::Attribute | SpecKind::Relationship);
        self.elements.push(if is_property {
            node.element.wrapping_neg()
        } else {
            node.element
        });
        self.jumps.push(0);
        for (number, &child) in node.children.iter().enumerate() {
            self.add(nodes, (child, number + 1 < node.children.len()));
        }
        let jump: i32 = match (node.children.is_empty(), has_sibling) {
            (true, false) => -2,
            (false, false) => -1,
            (true, true) => 0,
            (false, true) => count(self.paths.len() - own).cast_signed(),
        };
        self.jumps[own] = jump.cast_unsigned();
    }
}

/// A number of the file's tables, which have thousands of rows.
fn count(number: usize) -> u32 {
    u32::try_from(number).unwrap_or(u32::MAX)
}
