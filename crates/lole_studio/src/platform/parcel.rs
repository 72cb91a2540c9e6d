//! Values as bytes, between a page and its workers: they share no memory. Sender and receiver are always of the
//! same build, so that there is no version; floats keep all their bits.

use bytemuck::Pod;
use glam::Vec3;

/// Writes values one after the other.
#[derive(Debug, Default)]
pub(crate) struct Packer(pub(crate) Vec<u8>);

/// Reads them in the same order; `None` where there is nothing more, or something else.
#[derive(Debug)]
pub(crate) struct Unpacker<'a>(pub(crate) &'a [u8]);

impl Packer {
    /// A number, or several of a fixed count.
    pub(crate) fn put<T: Pod>(&mut self, value: T) {
        self.0.extend_from_slice(bytemuck::bytes_of(&value));
    }

    #[expect(clippy::fn_params_excessive_bools, reason = "it packs one")]
    pub(crate) fn flag(&mut self, value: bool) {
        self.put(u8::from(value));
    }

    pub(crate) fn count(&mut self, count: usize) {
        self.put(count as u64);
    }

    /// So many numbers as there are.
    pub(crate) fn list<T: Pod>(&mut self, values: &[T]) {
        self.count(values.len());
        self.0.extend_from_slice(bytemuck::cast_slice(values));
    }

    pub(crate) fn text(&mut self, text: &str) {
        self.list(text.as_bytes());
    }

    /// A value that may be missing.
    pub(crate) fn maybe<T>(&mut self, value: Option<T>, put: impl FnOnce(&mut Self, T)) {
        self.flag(value.is_some());
        if let Some(value) = value {
            put(self, value);
        }
    }

    /// Values of any kind, one after the other.
    pub(crate) fn each<T>(&mut self, values: &[T], mut put: impl FnMut(&mut Self, &T)) {
        self.count(values.len());
        for value in values {
            put(self, value);
        }
    }
}

impl<'a> Unpacker<'a> {
    fn bytes(&mut self, count: usize) -> Option<&'a [u8]> {
        let (bytes, rest) = self.0.split_at_checked(count)?;
        self.0 = rest;
        Some(bytes)
    }

    /// See [`Packer::put`].
    pub(crate) fn get<T: Pod>(&mut self) -> Option<T> {
        let bytes = self.bytes(size_of::<T>())?;
        Some(bytemuck::pod_read_unaligned(bytes))
    }

    pub(crate) fn flag(&mut self) -> Option<bool> {
        self.get::<u8>().map(|flag| flag == 1)
    }

    pub(crate) fn count(&mut self) -> Option<usize> {
        usize::try_from(self.get::<u64>()?).ok()
    }

    /// See [`Packer::list`].
    pub(crate) fn list<T: Pod>(&mut self) -> Option<Vec<T>> {
        let count = self.count()?;
        let bytes = self.bytes(count.checked_mul(size_of::<T>())?)?;
        let mut values = vec![T::zeroed(); count];
        bytemuck::cast_slice_mut(&mut values).copy_from_slice(bytes);
        Some(values)
    }

    pub(crate) fn text(&mut self) -> Option<String> {
        String::from_utf8(self.list()?).ok()
    }

    /// See [`Packer::maybe`]; the outer `None` is a broken parcel.
    #[expect(
        clippy::option_option,
        reason = "a value that is missing is none that is broken"
    )]
    pub(crate) fn maybe<T>(
        &mut self,
        get: impl FnOnce(&mut Self) -> Option<T>,
    ) -> Option<Option<T>> {
        if self.flag()? {
            get(self).map(Some)
        } else {
            Some(None)
        }
    }

    /// See [`Packer::each`].
    pub(crate) fn each<T>(
        &mut self,
        mut get: impl FnMut(&mut Self) -> Option<T>,
    ) -> Option<Vec<T>> {
        let count = self.count()?;
        (0..count).map(|_| get(self)).collect()
    }
}

/// Positions and normals of many surfaces.
pub(crate) fn put_vertices(packer: &mut Packer, vertices: &[Vec<Vec3>; 2]) {
    packer.list(&vertices[0]);
    packer.list(&vertices[1]);
}

/// See [`put_vertices`].
pub(crate) fn get_vertices(unpacker: &mut Unpacker<'_>) -> Option<[Vec<Vec3>; 2]> {
    Some([unpacker.list()?, unpacker.list()?])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_packed_is_unpacked_and_half_a_parcel_is_none() {
        let mut packer = Packer::default();
        packer.put(7_u32);
        packer.text("ハウ");
        packer.maybe(Some(1.5_f64), Packer::put);
        packer.maybe(None::<f64>, Packer::put);
        packer.list(&[Vec3::X, Vec3::Y]);
        packer.each(&["a", "bc"], |packer, text| packer.text(text));
        let read = |bytes: &[u8]| {
            let mut parcel = Unpacker(bytes);
            let head = (parcel.get::<u32>()?, parcel.text()?);
            let numbers = [
                parcel.maybe(Unpacker::get::<f64>)?,
                parcel.maybe(Unpacker::get)?,
            ];
            let places: Vec<Vec3> = parcel.list()?;
            Some((head, numbers, places, parcel.each(Unpacker::text)?))
        };
        let (head, numbers, places, texts) = read(&packer.0).unwrap();
        assert_eq!(head, (7, "ハウ".to_owned()));
        assert_eq!(
            (numbers, places),
            ([Some(1.5), None], vec![Vec3::X, Vec3::Y])
        );
        assert_eq!(texts, ["a", "bc"]);
        for length in 0..packer.0.len() {
            assert!(read(&packer.0[..length]).is_none(), "{length}");
        }
    }
}
