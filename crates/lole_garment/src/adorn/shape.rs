//! Shapes in the making: vertices with colors, put together from simple ones.

use glam::{Affine3A, Vec3};
use lole_geom::mesh::vertex_normals;
use lole_geom::trig;

use super::chosen::real;
use super::{AdornmentFinish, Carried, Carrier, OnStrand, Surface};

/// A mesh with colors, in a space of its own [m].
#[derive(Debug, Clone, Default)]
pub(crate) struct Shape {
    pub(crate) positions: Vec<Vec3>,
    pub(crate) normals: Vec<Vec3>,
    pub(crate) colors: Vec<Vec3>,
    pub(crate) triangles: Vec<[u32; 3]>,
}

impl Shape {
    /// A sheet of rows of vertices; `place` says where one is by its shares along and across, 0 to 1,
    /// and its color.
    pub(crate) fn sheet(
        [rows, columns]: [usize; 2],
        place: impl Fn(f32, f32) -> (Vec3, Vec3),
    ) -> Self {
        let mut shape = Self::default();
        for row in 0..=rows {
            for column in 0..=columns {
                let (position, color) = place(
                    real(row) / real(rows.max(1)),
                    real(column) / real(columns.max(1)),
                );
                shape.positions.push(position);
                shape.colors.push(color);
            }
        }
        let index = |row: usize, column: usize| {
            u32::try_from(row * (columns + 1) + column).unwrap_or(u32::MAX)
        };
        for row in 0..rows {
            for column in 0..columns {
                let [a, b] = [index(row, column), index(row, column + 1)];
                let [c, d] = [index(row + 1, column), index(row + 1, column + 1)];
                shape.triangles.extend([[a, b, c], [b, d, c]]);
            }
        }
        shape.normals = vertex_normals(&shape.positions, &shape.triangles);
        shape
    }

    /// A surface of revolution about `+Y`: points of its profile are `[radius, height]` [m] from below
    /// to above, with their colors.
    pub(crate) fn turned(around: usize, profile: &[([f32; 2], Vec3)]) -> Self {
        let rows = profile.len().saturating_sub(1);
        let last = real(rows.max(1));
        let mut shape = Self::sheet([rows, around], |along, across| {
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "a share of the rows"
            )]
            let row = ((along * last).round() as usize).min(rows);
            let ([radius, height], color) = profile[row];
            let (sin, cos) = trig::sin_cos(std::f32::consts::TAU * across);
            (Vec3::new(radius * sin, height, radius * cos), color)
        });
        // The first column and the last are one.
        for row in 0..=rows {
            let [first, other] = [row * (around + 1), row * (around + 1) + around];
            let both = (shape.normals[first] + shape.normals[other]).normalize_or_zero();
            (shape.normals[first], shape.normals[other]) = (both, both);
        }
        shape
    }

    /// Adds another one, moved.
    pub(crate) fn add(&mut self, other: &Self, move_by: &Affine3A) {
        let first = u32::try_from(self.positions.len()).unwrap_or(u32::MAX);
        let places = other.positions.iter();
        self.positions
            .extend(places.map(|&place| move_by.transform_point3(place)));
        let normals = other.normals.iter();
        self.normals
            .extend(normals.map(|&normal| move_by.transform_vector3(normal).normalize_or_zero()));
        self.colors.extend(&other.colors);
        let triangles = other.triangles.iter();
        self.triangles
            .extend(triangles.map(|triangle| triangle.map(|corner| corner + first)));
    }

    /// The same with all colors multiplied.
    pub(crate) fn tinted(mut self, tint: Vec3) -> Self {
        for color in &mut self.colors {
            *color = (*color * tint).clamp(Vec3::ZERO, Vec3::ONE);
        }
        self
    }

    /// A surface that one thing carries, from a shape in the bind pose.
    pub(crate) fn ridden(self, finish: AdornmentFinish, carrier: Carrier) -> Surface {
        let carriers = vec![carrier; self.positions.len()];
        self.ridden_by(finish, carriers)
    }

    /// A surface whose vertices are carried each by its own.
    pub(crate) fn ridden_by(self, finish: AdornmentFinish, carriers: Vec<Carrier>) -> Surface {
        Surface {
            finish,
            colors: self.colors,
            triangles: self.triangles,
            carried: Carried::Bones {
                positions: self.positions,
                normals: self.normals,
                carriers,
            },
        }
    }
}

/// Surfaces on strands in the making.
#[derive(Debug, Default)]
pub(crate) struct OnStrands {
    pub(crate) colors: Vec<Vec3>,
    pub(crate) triangles: Vec<[u32; 3]>,
    pub(crate) places: Vec<OnStrand>,
}

impl OnStrands {
    /// Adds a shape that rides as a whole on one place of a strand; its `+X` is across, its `+Y`
    /// outward and its `+Z` along.
    pub(crate) fn add_whole(&mut self, shape: &Shape, (strand, along): (usize, f32)) {
        let first = self.first();
        let strand = u32::try_from(strand).unwrap_or(u32::MAX);
        for (&offset, &normal) in shape.positions.iter().zip(&shape.normals) {
            self.places.push(OnStrand {
                strand,
                along,
                offset,
                normal,
            });
        }
        self.add_rest(shape, first);
    }

    /// Adds a shape that bends along a strand: its `z` [m] becomes the way along from the first
    /// particle, at `spacing` [m] from one to the next.
    pub(crate) fn add_bent(&mut self, shape: &Shape, (strand, spacing): (usize, f32)) {
        let first = self.first();
        let strand = u32::try_from(strand).unwrap_or(u32::MAX);
        for (&place, &normal) in shape.positions.iter().zip(&shape.normals) {
            self.places.push(OnStrand {
                strand,
                along: place.z / spacing,
                offset: place.with_z(0.0),
                normal,
            });
        }
        self.add_rest(shape, first);
    }

    fn first(&self) -> u32 {
        u32::try_from(self.places.len()).unwrap_or(u32::MAX)
    }

    fn add_rest(&mut self, shape: &Shape, first: u32) {
        self.colors.extend(&shape.colors);
        let triangles = shape.triangles.iter();
        self.triangles
            .extend(triangles.map(|triangle| triangle.map(|corner| corner + first)));
    }

    pub(crate) fn surface(self, finish: AdornmentFinish) -> Surface {
        Surface {
            finish,
            colors: self.colors,
            triangles: self.triangles,
            carried: Carried::Strands(self.places),
        }
    }
}

/// The transform whose axes are three directions.
pub(crate) fn affine([x, y, z]: [Vec3; 3], at: Vec3) -> Affine3A {
    Affine3A::from_cols(x.into(), y.into(), z.into(), at.into())
}

/// A right-handed frame whose `z` is one direction and whose `y` is as near as it can be to another.
pub(crate) fn facing(z: Vec3, y: Vec3) -> [Vec3; 3] {
    let z = z.normalize_or(Vec3::Z);
    let x = y.cross(z).try_normalize();
    let x = x.unwrap_or_else(|| z.any_orthonormal_vector());
    [x, z.cross(x), z]
}
