//! What a program for a page hands out: which of its tables has which name.

/// The section of what is handed out.
const EXPORTS: u8 = 7;
/// What a table is called there.
const TABLE: u8 = 1;

/// Name and number of each table that a program hands out, in its order; `None` where this is no program.
///
/// The page's script fills a table by its name, so that a tool that confuses two of them has broken the program.
pub(super) fn tables(wasm: &[u8]) -> Option<Vec<(String, u32)>> {
    let mut rest = Reader(wasm.strip_prefix(b"\0asm\x01\0\0\0")?);
    while !rest.0.is_empty() {
        let kind = rest.byte()?;
        let length = rest.number()? as usize;
        let section = rest.take(length)?;
        if kind == EXPORTS {
            return Reader(section).exports();
        }
    }
    Some(Vec::new())
}

struct Reader<'a>(&'a [u8]);

impl<'a> Reader<'a> {
    fn take(&mut self, count: usize) -> Option<&'a [u8]> {
        let (taken, rest) = self.0.split_at_checked(count)?;
        self.0 = rest;
        Some(taken)
    }

    fn byte(&mut self) -> Option<u8> {
        self.take(1).map(|byte| byte[0])
    }

    /// A number in seven bits a byte, the lowest first.
    fn number(&mut self) -> Option<u32> {
        let mut number = 0;
        for place in 0..5 {
            let byte = self.byte()?;
            number |= u32::from(byte & 0x7f) << (7 * place);
            if byte < 0x80 {
                return Some(number);
            }
        }
        None
    }

    fn exports(mut self) -> Option<Vec<(String, u32)>> {
        let mut tables = Vec::new();
        for _ in 0..self.number()? {
            let length = self.number()? as usize;
            let name = String::from_utf8(self.take(length)?.to_vec()).ok()?;
            let (kind, number) = (self.byte()?, self.number()?);
            if kind == TABLE {
                tables.push((name, number));
            }
        }
        Some(tables)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A program that hands out a function and a table of this number.
    fn program(table: u8) -> Vec<u8> {
        let exports = [2, 1, b'f', 0, 0, 1, b't', TABLE, table];
        let length = u8::try_from(exports.len()).unwrap();
        // A section of another kind stands before it, with a length of two bytes.
        let before = [&[0, 0x80, 0x01][..], &[0; 128]].concat();
        [
            b"\0asm\x01\0\0\0",
            &before[..],
            &[EXPORTS, length],
            &exports,
        ]
        .concat()
    }

    #[test]
    fn tables_are_told_apart_by_name_and_number() {
        assert_eq!(tables(&program(1)), Some(vec![("t".to_owned(), 1)]));
        assert_ne!(tables(&program(0)), tables(&program(1)));
        assert_eq!(tables(b"\0asm\x01\0\0\0"), Some(Vec::new()));
    }

    #[test]
    fn half_a_program_is_none() {
        let whole = program(1);
        assert_eq!(tables(&whole[..whole.len() - 1]), None);
        assert_eq!(tables(b"%PDF"), None);
    }
}
