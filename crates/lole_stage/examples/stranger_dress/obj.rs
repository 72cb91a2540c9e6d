//! As much of the OBJ format as a dress needs: `v`, `vt` and `f`.

use std::error::Error;
use std::fmt::Write as _;
use std::path::Path;

use glam::{Vec2, Vec3};

/// A mesh as it is in a file.
#[derive(Default)]
pub(crate) struct Obj {
    /// [m].
    pub(crate) positions: Vec<Vec3>,
    pub(crate) triangles: Vec<[u32; 3]>,
    /// Texture coordinates, and those of the triangles' corners.
    places: Vec<Vec2>,
    corners: Vec<[Option<u32>; 3]>,
}

impl Obj {
    /// Reads a file whose unit is so many meters; polygons are cut into triangles around their first corner.
    pub(crate) fn parse(text: &str, unit: f32) -> Result<Self, Box<dyn Error>> {
        let mut obj = Self::default();
        for (number, line) in (1..).zip(text.lines()) {
            obj.read(line, unit)
                .map_err(|error| format!("line {number}: {error}"))?;
        }
        Ok(obj)
    }

    fn read(&mut self, line: &str, unit: f32) -> Result<(), Box<dyn Error>> {
        let mut words = line.split_whitespace();
        let kind = words.next().unwrap_or_default();
        let words: Vec<&str> = words.collect();
        let number = |place: usize| -> Result<f32, Box<dyn Error>> {
            Ok(words.get(place).ok_or("a number is missing")?.parse()?)
        };
        match kind {
            "v" => {
                let place = Vec3::new(number(0)?, number(1)?, number(2)?);
                self.positions.push(place * unit);
            }
            "vt" => self.places.push(Vec2::new(number(0)?, number(1)?)),
            "f" => {
                let corners = words.iter().map(|word| self.corner(word));
                let corners: Vec<(u32, Option<u32>)> = corners.collect::<Result<_, _>>()?;
                for pair in corners.windows(2).skip(1) {
                    let triangle = [corners[0], pair[0], pair[1]];
                    self.triangles.push(triangle.map(|it| it.0));
                    self.corners.push(triangle.map(|it| it.1));
                }
            }
            _ => {}
        }
        Ok(())
    }

    /// Position and texture coordinate of a corner, counted from 1, or from the end where negative.
    fn corner(&self, word: &str) -> Result<(u32, Option<u32>), Box<dyn Error>> {
        let mut parts = word.split('/');
        let index = |part: &str, count: usize| -> Result<u32, Box<dyn Error>> {
            let number: i64 = part.parse()?;
            let place = if number < 0 {
                i64::try_from(count)? + number
            } else {
                number - 1
            };
            Ok(u32::try_from(place)?)
        };
        let position = index(parts.next().unwrap_or_default(), self.positions.len())?;
        let place = parts.next().filter(|part| !part.is_empty());
        let place = place
            .map(|part| index(part, self.places.len()))
            .transpose()?;
        Ok((position, place))
    }

    /// Texture coordinates of a triangle's corners times `scale` [m]; `None` where it has none.
    pub(crate) fn flat_corners(&self, triangle: usize, scale: f32) -> Option<[Vec2; 3]> {
        let [a, b, c] = self.corners[triangle].map(|corner| {
            let place = self.places.get(corner? as usize)?;
            Some(*place * scale)
        });
        Some([a?, b?, c?])
    }
}

/// Writes a mesh; `flat` says where the corners of a triangle lie in their flat piece [m], where there is one.
pub(crate) fn write(
    path: &Path,
    (positions, triangles): (&[Vec3], &[[u32; 3]]),
    flat: Option<&dyn Fn(usize) -> [Vec2; 3]>,
) -> Result<(), Box<dyn Error>> {
    let mut text = String::new();
    for at in positions {
        writeln!(text, "v {} {} {}", at.x, at.y, at.z)?;
    }
    for (triangle, corners) in triangles.iter().enumerate() {
        let [a, b, c] = corners.map(|corner| corner + 1);
        let Some(flat) = flat else {
            writeln!(text, "f {a} {b} {c}")?;
            continue;
        };
        for at in flat(triangle) {
            writeln!(text, "vt {} {}", at.x, at.y)?;
        }
        let first = 3 * triangle + 1;
        let [second, third] = [first + 1, first + 2];
        writeln!(text, "f {a}/{first} {b}/{second} {c}/{third}")?;
    }
    Ok(std::fs::write(path, text)?)
}
