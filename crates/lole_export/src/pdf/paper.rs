//! Sizes of paper.

/// Paper that people have at home or in a shop.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Paper {
    /// ISO 216 A4.
    A4,
    /// ISO 216 A3.
    A3,
    /// ANSI Letter.
    Letter,
}

impl Paper {
    /// Every paper with its name, in the order of a menu.
    pub const ALL: [(Self, &'static str); 3] =
        [(Self::A4, "A4"), (Self::A3, "A3"), (Self::Letter, "Letter")];

    /// Width and height, upright [mm].
    #[must_use]
    pub const fn size_mm(self) -> [f64; 2] {
        match self {
            Self::A4 => [210.0, 297.0],
            Self::A3 => [297.0, 420.0],
            Self::Letter => [215.9, 279.4],
        }
    }

    /// Its name as printers say it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::A4 => "A4",
            Self::A3 => "A3",
            Self::Letter => "Letter",
        }
    }
}
