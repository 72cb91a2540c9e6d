//! The fine left half between warping and simplification: regions are cut here, where triangles
//! are small, so that their lines run smoothly.

use glam::Vec3;

use super::simplify::{self, simplify};
use super::slice::{Cut, slice};
use crate::PartKind;
use crate::sections::{Sections, Tube};

/// Triangles of the whole body after simplification.
const TRIANGLE_TARGET: usize = 17_000;

/// Columns of the fine half.
#[derive(Debug, Clone, Default)]
pub(crate) struct Fine {
    /// Positions before girths were fitted.
    pub(crate) base: Vec<Vec3>,
    /// Positions with the measured girths.
    pub(crate) warped: Vec<Vec3>,
    pub(crate) normals: Vec<Vec3>,
    pub(crate) labels: Vec<Tube>,
    /// Share of each vertex that belongs to the arm.
    pub(crate) arms: Vec<f32>,
    pub(crate) triangles: Vec<[u32; 3]>,
    /// Material of each triangle.
    pub(crate) kinds: Vec<PartKind>,
}

impl Fine {
    /// Cuts along the zero line of `region`, a function of the place and the arm's share there,
    /// and marks what is inside.
    pub(crate) fn cut(&mut self, kind: PartKind, region: impl Fn(Vec3, f32) -> f32) {
        let values: Vec<f32> = (self.warped.iter().zip(&self.arms))
            .map(|(&point, &arm)| region(point, arm))
            .collect();
        let sliced = slice(&self.triangles, &values);
        for cut in &sliced.vertices[values.len()..] {
            if let Cut::Between(a, b, share) = *cut {
                self.push_between(a as usize, b as usize, share);
            }
        }
        self.kinds = (sliced.parents.iter().zip(&sliced.is_positive))
            .map(|(&parent, &inside)| {
                if inside {
                    kind
                } else {
                    self.kinds[parent as usize]
                }
            })
            .collect();
        self.triangles = sliced.triangles;
    }

    fn push_between(&mut self, a: usize, b: usize, share: f32) {
        for points in [&mut self.base, &mut self.warped] {
            points.push(points[a].lerp(points[b], share));
        }
        let normal = self.normals[a].lerp(self.normals[b], share);
        self.normals.push(normal.normalize_or_zero());
        self.labels
            .push(self.labels[if share < 0.5 { a } else { b }]);
        self.arms
            .push(self.arms[a] + (self.arms[b] - self.arms[a]) * share);
    }

    /// Collapses to the triangles of the skin; kept vertices keep their normals.
    pub(crate) fn simplify(&mut self, body: &Sections) {
        let regions: Vec<u8> = self.kinds.iter().map(|&kind| kind as u8).collect();
        let kept = simplify(
            &simplify::Fine {
                positions: &self.warped,
                detail: &self.detail(body),
                triangles: &self.triangles,
                regions: &regions,
            },
            TRIANGLE_TARGET / 2,
        );
        let mut renamed = vec![u32::MAX; self.warped.len()];
        let mut old = Vec::new();
        self.triangles.clear();
        self.kinds.clear();
        for (triangle, region) in kept {
            self.triangles.push(triangle.map(|vertex| {
                let new = &mut renamed[vertex as usize];
                if *new == u32::MAX {
                    *new = u32::try_from(old.len()).unwrap_or(u32::MAX);
                    old.push(vertex as usize);
                }
                *new
            }));
            self.kinds.push(match region {
                region if region == PartKind::Leotard as u8 => PartKind::Leotard,
                region if region == PartKind::Face as u8 => PartKind::Face,
                _ => PartKind::Skin,
            });
        }
        self.base = old.iter().map(|&vertex| self.base[vertex]).collect();
        self.warped = old.iter().map(|&vertex| self.warped[vertex]).collect();
        self.normals = old.iter().map(|&vertex| self.normals[vertex]).collect();
        self.labels = old.iter().map(|&vertex| self.labels[vertex]).collect();
        self.arms = old.iter().map(|&vertex| self.arms[vertex]).collect();
    }

    /// Face and fingers are looked at: their error counts more in the simplification.
    fn detail(&self, body: &Sections) -> Vec<f32> {
        let center = body.head.center;
        (self.warped.iter().zip(&self.labels))
            .map(|(position, label)| match label {
                Tube::Head if position.z > center.z => 4.0,
                Tube::Thumb | Tube::Index | Tube::Middle | Tube::Ring | Tube::Little => 3.0,
                _ => 1.0,
            })
            .collect()
    }
}
