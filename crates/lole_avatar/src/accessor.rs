//! Numbers of a file: accessors into views into buffers, every range checked before anything is
//! allocated.

use gltf_json::accessor::{ComponentType, Type};
use gltf_json::validation::Checked;
use gltf_json::{Index, accessor, buffer};

use crate::AvatarError;
use crate::container::{File, visible};

/// Elements of one accessor at most.
const MOST_ELEMENTS: u64 = 1 << 24;
/// Elements of an accessor without bytes of its own at most: nothing in the file bounds them.
const MOST_ZEROS: usize = 1 << 20;

/// Where elements lie.
struct Layout<'f> {
    bytes: &'f [u8],
    stride: usize,
    component: ComponentType,
}

impl File<'_> {
    /// Floats of an accessor, `N` an element, normalized integers brought to -1..1.
    pub(crate) fn floats<const N: usize>(
        &self,
        index: Index<accessor::Accessor>,
    ) -> Result<Vec<[f32; N]>, AvatarError> {
        let found = self.elements::<N, f32>(index, |accessor, component, bytes| {
            let value = match component {
                ComponentType::F32 => f32::from_le_bytes(four(bytes)),
                ComponentType::U8 => f32::from(bytes[0]),
                ComponentType::I8 => f32::from(i8::from_le_bytes([bytes[0]])),
                ComponentType::U16 => f32::from(u16::from_le_bytes([bytes[0], bytes[1]])),
                ComponentType::I16 => f32::from(i16::from_le_bytes([bytes[0], bytes[1]])),
                ComponentType::U32 => u32::from_le_bytes(four(bytes)) as f32,
            };
            if !accessor.normalized {
                return value;
            }
            match component {
                ComponentType::U8 => value / 255.0,
                ComponentType::U16 => value / 65535.0,
                ComponentType::I8 => (value / 127.0).max(-1.0),
                ComponentType::I16 => (value / 32767.0).max(-1.0),
                ComponentType::U32 | ComponentType::F32 => value,
            }
        })?;
        let finite = |element: &[f32; N]| element.iter().all(|value| value.abs() <= LARGEST);
        match found.iter().position(|element| !finite(element)) {
            None => Ok(found),
            Some(element) => Err(AvatarError::part(
                format!("accessors[{}]", index.value()),
                format!("{element} 番目の値が大きすぎるか、有限の数ではありません"),
                format!("element {element} is too large or no finite number"),
            )),
        }
    }

    /// Whole numbers of an accessor, `N` an element.
    pub(crate) fn integers<const N: usize>(
        &self,
        index: Index<accessor::Accessor>,
    ) -> Result<Vec<[u32; N]>, AvatarError> {
        self.elements::<N, u32>(index, |_, component, bytes| match component {
            ComponentType::U8 | ComponentType::I8 => u32::from(bytes[0]),
            ComponentType::U16 | ComponentType::I16 => {
                u32::from(u16::from_le_bytes([bytes[0], bytes[1]]))
            }
            ComponentType::U32 | ComponentType::F32 => u32::from_le_bytes(four(bytes)),
        })
    }

    /// Bytes of a view.
    pub(crate) fn view(&self, index: Index<buffer::View>) -> Result<&[u8], AvatarError> {
        let place = || format!("bufferViews[{}]", index.value());
        let view = self
            .root
            .get(index)
            .ok_or_else(|| AvatarError::part(place(), "ありません", "there is no such view"))?;
        let buffer = view.buffer.value();
        let bytes = match self.buffers.get(buffer) {
            Some(Some(bytes)) => bytes,
            Some(None) => {
                let uri = self.root.buffers[buffer].uri.as_deref();
                return Err(AvatarError::Elsewhere {
                    place: format!("buffers[{buffer}]"),
                    uri: visible(uri.unwrap_or("(GLB)")),
                });
            }
            None => {
                return Err(AvatarError::part(
                    place(),
                    format!("buffers[{buffer}] がありません"),
                    format!("there is no buffers[{buffer}]"),
                ));
            }
        };
        let start = view.byte_offset.map_or(0, |offset| offset.0);
        range(bytes, start, view.byte_length.0).ok_or_else(|| {
            AvatarError::part(
                place(),
                format!("buffers[{buffer}] の {} バイトをはみ出します", bytes.len()),
                format!(
                    "it reaches beyond the {} bytes of buffers[{buffer}]",
                    bytes.len()
                ),
            )
        })
    }

    fn elements<const N: usize, T: Copy + Default>(
        &self,
        index: Index<accessor::Accessor>,
        read: impl Fn(&accessor::Accessor, ComponentType, &[u8]) -> T,
    ) -> Result<Vec<[T; N]>, AvatarError> {
        let place = || format!("accessors[{}]", index.value());
        let wrong = |japanese: &str, english: &str| AvatarError::part(place(), japanese, english);
        let (accessor, component) = self.accessor_of::<N>(index)?;
        let count = accessor.count.0;
        let beyond = || {
            wrong(
                "bufferView をはみ出します",
                "it reaches beyond its bufferView",
            )
        };
        if MOST_ELEMENTS < count {
            return Err(beyond());
        }
        #[expect(clippy::cast_possible_truncation, reason = "at most 2²⁴")]
        let count = count as usize;
        let size = component.size();
        let mut elements = match accessor.buffer_view {
            None if MOST_ZEROS < count => return Err(beyond()),
            None => vec![[T::default(); N]; count],
            Some(view) => {
                let offset = accessor.byte_offset.map_or(0, |offset| offset.0);
                let view_bytes = self.view(view)?;
                let rest = usize::try_from(offset)
                    .ok()
                    .and_then(|at| view_bytes.get(at..));
                let stride = self.root.get(view).and_then(|view| view.byte_stride);
                let layout = Layout {
                    bytes: rest.ok_or_else(beyond)?,
                    stride: stride.map_or(N * size, |stride| stride.0.max(1)),
                    component,
                };
                layout
                    .read::<N, T>(count, |bytes| read(accessor, component, bytes))
                    .ok_or_else(beyond)?
            }
        };
        if let Some(sparse) = &accessor.sparse {
            self.replace(accessor, sparse, &mut elements, |bytes| {
                read(accessor, component, bytes)
            })
            .ok_or_else(|| {
                wrong(
                    "疎な値（sparse）が範囲の外です",
                    "its sparse values lie out of range",
                )
            })?;
        }
        Ok(elements)
    }

    /// An accessor of elements that have `N` numbers each, and the type of those.
    fn accessor_of<const N: usize>(
        &self,
        index: Index<accessor::Accessor>,
    ) -> Result<(&accessor::Accessor, ComponentType), AvatarError> {
        let place = || format!("accessors[{}]", index.value());
        let wrong = |japanese: &str, english: &str| AvatarError::part(place(), japanese, english);
        let accessor = self
            .root
            .get(index)
            .ok_or_else(|| wrong("ありません", "there is no such accessor"))?;
        let Checked::Valid(component) = &accessor.component_type else {
            return Err(wrong("数の型が不明です", "its numbers have no known type"));
        };
        let Checked::Valid(kind) = &accessor.type_ else {
            return Err(wrong(
                "要素の型が不明です",
                "its elements have no known type",
            ));
        };
        let parts = multiplicity(*kind);
        if parts != N {
            return Err(AvatarError::part(
                place(),
                format!("要素の数値が {parts} 個で、{N} 個のはずです"),
                format!("its elements have {parts} numbers, and {N} are needed"),
            ));
        }
        Ok((accessor, component.0))
    }

    /// Lays sparse values over elements.
    fn replace<const N: usize, T: Copy + Default>(
        &self,
        accessor: &accessor::Accessor,
        sparse: &accessor::sparse::Sparse,
        elements: &mut [[T; N]],
        read: impl Fn(&[u8]) -> T,
    ) -> Option<()> {
        let count = usize::try_from(sparse.count.0).ok()?;
        if elements.len() < count {
            return None;
        }
        let (Checked::Valid(component), Checked::Valid(places)) =
            (&accessor.component_type, &sparse.indices.component_type)
        else {
            return None;
        };
        let from = |view, offset: u64| {
            let bytes = self.view(view).ok()?;
            bytes.get(usize::try_from(offset).ok()?..)
        };
        let indices = Layout {
            bytes: from(sparse.indices.buffer_view, sparse.indices.byte_offset.0)?,
            stride: places.0.size(),
            component: places.0,
        };
        let indices = indices.read::<1, usize>(count, |bytes| match bytes {
            [a] => usize::from(*a),
            [a, b] => usize::from(u16::from_le_bytes([*a, *b])),
            _ => u32::from_le_bytes(four(bytes)) as usize,
        })?;
        let values = Layout {
            bytes: from(sparse.values.buffer_view, sparse.values.byte_offset.0)?,
            stride: N * component.0.size(),
            component: component.0,
        };
        let values = values.read::<N, T>(count, read)?;
        for ([index], value) in indices.into_iter().zip(values) {
            *elements.get_mut(index)? = value;
        }
        Some(())
    }
}

/// Largest number that is read: a kilometer in millimeters.
const LARGEST: f32 = 1.0e7;

impl Layout<'_> {
    /// `count` elements of `N` numbers; `None` where they do not lie within the bytes.
    fn read<const N: usize, T: Copy + Default>(
        &self,
        count: usize,
        number: impl Fn(&[u8]) -> T,
    ) -> Option<Vec<[T; N]>> {
        let size = self.component.size();
        let last = count.checked_sub(1);
        let end = last.map_or(Some(0), |last| {
            last.checked_mul(self.stride)?.checked_add(N * size)
        })?;
        if self.bytes.len() < end {
            return None;
        }
        let elements = (0..count).map(|element| {
            let start = element * self.stride;
            let mut values = [T::default(); N];
            for (part, value) in values.iter_mut().enumerate() {
                let at = start + part * size;
                *value = number(&self.bytes[at..at + size]);
            }
            values
        });
        Some(elements.collect())
    }
}

const fn multiplicity(kind: Type) -> usize {
    match kind {
        Type::Scalar => 1,
        Type::Vec2 => 2,
        Type::Vec3 => 3,
        Type::Vec4 | Type::Mat2 => 4,
        Type::Mat3 => 9,
        Type::Mat4 => 16,
    }
}

fn four(bytes: &[u8]) -> [u8; 4] {
    [bytes[0], bytes[1], bytes[2], bytes[3]]
}

fn range(bytes: &[u8], start: u64, length: u64) -> Option<&[u8]> {
    let start = usize::try_from(start).ok()?;
    let end = start.checked_add(usize::try_from(length).ok()?)?;
    bytes.get(start..end)
}
