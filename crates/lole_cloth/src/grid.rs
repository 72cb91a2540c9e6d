//! The grid of mass points: how many, how they are joined, how far apart they lie when flat.

/// How the first and last column meet.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Topology {
    /// A rectangle with four free edges.
    Sheet,
    /// The last column is followed by the first, as in a skirt sewn by one seam.
    Tube,
}

/// A rectangular grid of particles, stored row by row from the top.
///
/// `u` runs along a row (around the body), `v` runs down the columns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grid {
    /// Particles in a row, at least 3.
    pub column_count: u32,
    /// Rows, at least 3.
    pub row_count: u32,
    /// Whether rows are closed rings.
    pub topology: Topology,
    /// Rest distance between neighbors along `u` and `v` [m]; the cells are rectangles.
    pub spacing: [f32; 2],
    /// Fuller cloth that is sewn to the lower part; `None` where all rows are as long.
    pub flounce: Option<Flounce>,
    /// How the upper part is crimped; `None` where cloth lies as long as it is.
    pub crimp: Option<Crimp>,
}

/// Cloth that is pushed together along its rows in puckers too small for the grid: it lies as shorter cloth,
/// and opens to its full length below.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crimp {
    /// Length of a crimped row as it lies over that of its cloth, above 0 and at most 1.
    pub share: f32,
    /// Last row that is crimped so much.
    pub last_row: u32,
    /// First row below it that lies as long as its cloth is.
    pub open_row: u32,
}

/// Cloth that is gathered into a seam along a row and hangs below it: a column of it is wider than one
/// of the cloth above.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flounce {
    /// Row of the seam; every row below it is the flounce's. At least 1, and not the last.
    pub seam_row: u32,
    /// Length of the flounce along a row over that of the cloth above it, at least 1.
    pub fullness: f32,
}

impl Crimp {
    /// Length of a row as it lies over that of its cloth: puckers flow into each other evenly on the way down.
    #[expect(clippy::cast_precision_loss, reason = "rows are fewer than 2^24")]
    fn share_of(self, row: u32) -> f32 {
        let below = row.saturating_sub(self.last_row) as f32;
        let opening = self.open_row.saturating_sub(self.last_row).max(1) as f32;
        self.share + (1.0 - self.share) * (below / opening).min(1.0)
    }
}

impl Grid {
    /// A rectangle with four free edges, its particles `spacing` [m] apart along `u` and `v`.
    #[must_use]
    pub const fn sheet(column_count: u32, row_count: u32, spacing: [f32; 2]) -> Self {
        Self {
            column_count,
            row_count,
            topology: Topology::Sheet,
            spacing,
            flounce: None,
            crimp: None,
        }
    }

    /// A rectangle closed to a ring, its last column followed by the first, and its particles `spacing` [m]
    /// apart along `u` and `v`.
    #[must_use]
    pub const fn tube(column_count: u32, row_count: u32, spacing: [f32; 2]) -> Self {
        Self {
            topology: Topology::Tube,
            ..Self::sheet(column_count, row_count, spacing)
        }
    }

    /// Number of particles.
    #[must_use]
    pub const fn particle_count(&self) -> usize {
        self.column_count as usize * self.row_count as usize
    }

    /// Number of cells along a row: as many as columns in a tube, one less in a sheet.
    #[must_use]
    pub const fn cell_columns(&self) -> u32 {
        match self.topology {
            Topology::Sheet => self.column_count - 1,
            Topology::Tube => self.column_count,
        }
    }

    /// Index of the particle at `row`, `column`.
    #[must_use]
    pub const fn index(&self, row: u32, column: u32) -> usize {
        row as usize * self.column_count as usize + column as usize
    }

    /// Length of the cloth of a row over that of the first row.
    #[must_use]
    pub fn row_fullness(&self, row: u32) -> f32 {
        let flounce = self.flounce.filter(|flounce| flounce.seam_row < row);
        flounce.map_or(1.0, |flounce| flounce.fullness)
    }

    /// Length of the cloth of the cells between a row and the next, that of the lower, over that of the first
    /// row.
    #[must_use]
    pub fn cell_fullness(&self, row: u32) -> f32 {
        self.row_fullness(row + 1)
    }

    /// Cloth between neighbors along a row [m].
    #[must_use]
    pub fn cloth_spacing(&self, row: u32) -> f32 {
        self.spacing[0] * self.row_fullness(row)
    }

    /// Length of a row as it lies over that of its cloth: less than 1 where it is crimped.
    #[must_use]
    pub fn crimp_share(&self, row: u32) -> f32 {
        self.crimp.map_or(1.0, |crimp| crimp.share_of(row))
    }

    /// Rest distance between neighbors along a row as it lies [m].
    #[must_use]
    pub fn row_spacing(&self, row: u32) -> f32 {
        self.cloth_spacing(row) * self.crimp_share(row)
    }

    /// Row from which on all rows, and all cells between them, are as wide.
    pub(crate) fn last_uneven_row(&self) -> u32 {
        let seam = self.flounce.map_or(0, |flounce| flounce.seam_row + 1);
        let open = self.crimp.map_or(0, |crimp| crimp.open_row);
        seam.max(open).min(self.row_count - 1)
    }

    /// Column `offset` to the right of `column`; `None` beyond the edge of a sheet.
    #[must_use]
    pub const fn column_right(&self, column: u32, offset: u32) -> Option<u32> {
        let target = column + offset;
        match self.topology {
            Topology::Tube => Some(target % self.column_count),
            Topology::Sheet if target < self.column_count => Some(target),
            Topology::Sheet => None,
        }
    }

    /// Two triangles for every cell, row by row, cut from upper left to lower right: upper left,
    /// upper right and lower right, then upper left, lower right and lower left. In a tube whose
    /// columns run from `+X` to `+Z` and whose rows run down they are counterclockwise seen from
    /// outside.
    #[must_use]
    pub fn triangles(&self) -> Vec<[u32; 3]> {
        let at = |row: u32, column: u32| row * self.column_count + column;
        let mut triangles = Vec::with_capacity(2 * self.particle_count());
        for row in 0..self.row_count.saturating_sub(1) {
            for column in 0..self.column_count {
                let Some(right) = self.column_right(column, 1) else {
                    continue;
                };
                let (first, last) = (at(row, column), at(row + 1, right));
                triangles.push([first, at(row, right), last]);
                triangles.push([first, last, at(row + 1, column)]);
            }
        }
        triangles
    }
}
