//! Building the drawn body: parts are placed by the tape, sewn to the skin, mirrored, and given eyes and hair.

use glam::Vec3;
use lole_geom::triangle_grid::{TriangleGrid, blend};

use super::face::{self, LidPoint};
use super::weld::{self, Seam};
use super::{DrawnBody, armhole, eyes, features, paint, years};
use crate::parts::{self, HeadPart, Part, Shares};
use crate::skin_build::{Half, add_hinges};
use crate::skin_weights::Row;
use crate::surface::Shape;
use crate::surface::field::Head;
use crate::surface::warp::smooth_step;
use crate::{Appearance, BodyError, Bone, Figure, PartKind, Skeleton};

/// Cells [m] in which the skin's triangles are found: twice their edges.
const CELL: f32 = 0.012;
/// How near to the neck's edge nothing moves, and from where on everything does [m].
const NECK: [f32; 2] = [0.004, 0.045];
/// How far from a part the skin is looked for whose place it takes [m].
const FARTHEST: f32 = 1.0;

/// The drawn body without hair, and the head that hair lies on.
pub(crate) fn build_drawn(
    (shape, half): (&Shape, &Half),
    skeleton: &Skeleton,
    (figure, appearance): (Figure, &Appearance),
) -> Result<(DrawnBody, Head), BodyError> {
    let made_of = &shape.made_of;
    let mut half = half.clone();
    half.colors = vec![Vec3::ONE; half.positions.len()];
    for kind in &mut half.kinds {
        if *kind == PartKind::Face {
            *kind = PartKind::Skin;
        }
    }
    let rows = half.rows.clone();
    armhole::cut(&mut half, shape, skeleton);
    let skin = ContactSkin {
        grid: TriangleGrid::new(&shape.positions, &shape.triangles, CELL),
        shape,
        rows: &rows,
    };
    for (mut part, arm, tip) in [
        (parts::hand(&made_of.body)?, 1.0, Bone::LeftMiddleDistal),
        (parts::foot(&made_of.body)?, 0.0, Bone::LeftToes),
    ] {
        let arms = vec![arm; part.positions.len()];
        part.positions = shape.placing.carry(&part.positions, &arms);
        let mut colors = paint::limb(&part);
        let nails = paint::nails(&mut part, &mut colors);
        skin.sew(&mut half, &mut part, (colors, &nails), skeleton.joint(tip));
    }
    let mut head = parts::head(&made_of.head)?;
    shape_head(&mut head, &made_of.head, appearance)?;
    place_head(&mut head, shape);
    let colors = paint::head(&head, figure, appearance);
    let crown = Vec3::new(0.0, shape.body.height, shape.body.head.center.z);
    let first = skin.sew(&mut half, &mut head.part, (colors.clone(), &[]), crown);
    let renamed = half.compact();
    let scalp = shape.head.head().on(
        shape.body.head.center,
        (&head.part.positions, &without_ear(&head)),
    );
    let (mut mesh, twins) = half.mirrored();
    add_hinges(&mut mesh, skeleton);
    let flip = Vec3::new(-1.0, 1.0, 1.0);
    let halves = face::closing(&head, 0.5);
    let lids = halves.into_iter().zip(face::closing(&head, 1.0));
    let lids = lids.flat_map(|((point, half), (_, whole))| {
        let vertex = renamed[(first + point) as usize];
        let moved = [half, whole];
        let other = moved.map(|by| by * flip);
        [(vertex, moved), (twins[vertex as usize], other)]
    });
    let lids = lids.map(|(vertex, moved)| LidPoint { vertex, moved });
    let mut lids: Vec<LidPoint> = lids.collect();
    let looks = (figure, appearance);
    let (eyes, lashes) = eyes::add(&mut mesh, (&head, &colors), looks);
    lids.extend(lashes);
    lids.sort_by_key(|lid| lid.vertex);
    lids.dedup_by_key(|lid| lid.vertex);
    let drawn = DrawnBody {
        mesh,
        strands: crate::SkinnedMesh::default(),
        open_hair: super::OpenHair::default(),
        lids,
        eyes,
    };
    Ok((drawn, scalp))
}

/// Gives a head that is made of these shares the years and the features that were chosen.
fn shape_head(
    head: &mut HeadPart,
    shares: &Shares,
    appearance: &Appearance,
) -> Result<(), BodyError> {
    let free = free_of_the_neck(head);
    years::grow(head, shares, (appearance.age_years, &free))?;
    features::choose(head, &appearance.face, &free);
    years::line(head, appearance.age_years);
    for &point in &head.middle {
        head.part.positions[point as usize].x = 0.0;
    }
    Ok(())
}

/// How far each point may move: where the head meets the neck, nothing does.
fn free_of_the_neck(head: &HeadPart) -> Vec<f32> {
    let positions = &head.part.positions;
    let rim: Vec<Vec3> = (head.part.rim.iter())
        .map(|&point| positions[point as usize])
        .collect();
    let free = positions.iter().map(|place| {
        let apart = rim.iter().map(|end| end.distance_squared(*place));
        let nearest = apart.fold(f32::INFINITY, f32::min).sqrt();
        smooth_step((nearest - NECK[0]) / (NECK[1] - NECK[0]))
    });
    free.collect()
}

/// Carries a head and its eye to the body's measures.
fn place_head(head: &mut HeadPart, shape: &Shape) {
    let made_of = &shape.made_of;
    let [from, to] = made_of.head_moved;
    let grown = |place: Vec3| to + (place - from) * made_of.head_grown;
    let part = &mut head.part;
    // A point beside the eye tells what became of its radius.
    let ends = [Vec3::ZERO, Vec3::X * head.eye_radius].map(|out| head.eye + out);
    let places = part.positions.iter().copied().chain(ends);
    let places: Vec<Vec3> = places.map(grown).collect();
    let mut placed = shape.placing.carry(&places, &vec![0.0; places.len()]);
    if let [.., eye, side] = placed[..] {
        let size = eye.distance(side) / head.eye_radius;
        (head.eye, head.eye_radius) = (eye, head.eye_radius * size);
        head.iris_radius *= size;
    }
    placed.truncate(part.positions.len());
    for &point in &head.middle {
        placed[point as usize].x = 0.0;
    }
    part.positions = placed;
}

/// A head's triangles without its ear: hair lies on the skull behind it.
fn without_ear(head: &HeadPart) -> Vec<[u32; 3]> {
    let mut is_ear = vec![false; head.part.positions.len()];
    for &point in &head.ear {
        is_ear[point as usize] = true;
    }
    let triangles = head.part.triangles.iter();
    let left = triangles.filter(|it| !it.iter().any(|&point| is_ear[point as usize]));
    left.copied().collect()
}

/// The skin that cloth meets, which parts take their weights from.
struct ContactSkin<'a> {
    grid: TriangleGrid<'a>,
    shape: &'a Shape,
    rows: &'a [Row],
}

impl ContactSkin<'_> {
    /// Cuts the half off where a part begins, and sews the part with its nails on; the vertex of its first point.
    /// `tip` is a place in what is cut off.
    fn sew(
        &self,
        half: &mut Half,
        part: &mut Part,
        (colors, nails): (Vec<Vec3>, &[[u32; 3]]),
        tip: Vec3,
    ) -> u32 {
        let seam = Seam::of(part);
        let border = weld::cut(half, &seam, tip);
        weld::fit(part, &seam, (&half.positions, &border));
        let mut joined = part.triangles.clone();
        let first = u32::try_from(half.positions.len()).unwrap_or(u32::MAX);
        let mut rim: Vec<u32> = part.rim.iter().map(|point| point + first).collect();
        let mut rows = Vec::with_capacity(part.positions.len());
        let mut around = Vec::with_capacity(part.positions.len());
        for &place in &part.positions {
            let (row, normal) = self.at(place);
            rows.push(row);
            around.push(normal);
        }
        let normals = weld::normals(part, &around);
        half.positions.extend(&part.positions);
        half.normals.extend(normals);
        half.rows.extend(rows);
        half.colors.extend(colors);
        for triangle in &mut joined {
            *triangle = triangle.map(|point| point + first);
        }
        // Two surfaces run along their common border in opposite ways.
        if part.is_along_rim() {
            rim.reverse();
        }
        joined.extend(weld::zip(&half.positions, &border, &rim));
        half.kinds
            .resize(half.triangles.len() + joined.len(), PartKind::Skin);
        half.triangles.extend(joined);
        let nails = nails.iter().map(|nail| nail.map(|point| point + first));
        half.triangles.extend(nails);
        half.kinds.resize(half.triangles.len(), PartKind::Nail);
        first
    }

    /// How bones carry the skin nearest to a place, and its normal there.
    fn at(&self, place: Vec3) -> (Row, Vec3) {
        let Some(nearest) = self.grid.nearest(place, FARTHEST) else {
            return ([0.0; Bone::COUNT], Vec3::ZERO);
        };
        let corners = self.shape.triangles[nearest.triangle as usize];
        let mut row = [0.0; Bone::COUNT];
        for (corner, share) in corners.into_iter().zip(nearest.barycentric.to_array()) {
            for (sum, weight) in row.iter_mut().zip(&self.rows[corner as usize]) {
                *sum += share * weight;
            }
        }
        let normals = corners.map(|corner| self.shape.normals[corner as usize]);
        (row, blend(normals, nearest.barycentric).normalize_or_zero())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Face;

    /// The neck's edge stays to the bit, at every age of every measured head.
    #[test]
    fn no_year_moves_the_neck() {
        for name in [
            "woman_mean",
            "woman_60s",
            "woman_large",
            "man_mean",
            "child_8",
        ] {
            let shares = vec![(name.to_owned(), 1.0)];
            let before = parts::head(&shares).unwrap();
            let mut after = before.clone();
            let looks = Appearance {
                face: Face::of_seed(5),
                age_years: Some(95.0),
                ..Appearance::default()
            };
            shape_head(&mut after, &shares, &looks).unwrap();
            for &point in &before.part.rim {
                let [from, to] = [&before, &after].map(|head| head.part.positions[point as usize]);
                assert_eq!(from, to, "{name}");
            }
        }
    }
}
