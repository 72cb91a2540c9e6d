//! Colors of head, hands and feet, as factors on the color of the skin.

use glam::Vec3;
use lole_geom::trig;

use super::years;
use crate::appearance::oldness;
use crate::parts::{HeadPart, Part};
use crate::surface::warp::smooth_step;
use crate::{Appearance, Figure, Makeup};

/// The skin that colors were chosen on; all of them linear.
const SKIN: Vec3 = Vec3::new(0.74, 0.50, 0.385);
const CHEEK: Vec3 = Vec3::new(0.78, 0.36, 0.28);
const EAR: Vec3 = Vec3::new(0.76, 0.41, 0.32);
const LIPS: Vec3 = Vec3::new(0.54, 0.22, 0.21);
/// Lips and lids made up for a stage.
const ROUGE: Vec3 = Vec3::new(0.46, 0.055, 0.07);
const LID_SHADOW: Vec3 = Vec3::new(0.30, 0.14, 0.13);
/// How far above the lid the color over the eyes reaches [eye radii].
const SHADOW_REACH: f32 = 1.45;
const LASHES: Vec3 = Vec3::new(0.055, 0.034, 0.028);
const LOWER_LID: Vec3 = Vec3::new(0.52, 0.27, 0.22);
const NOSTRIL: Vec3 = Vec3::new(0.12, 0.05, 0.04);
/// How far nails lie over the skin [m].
const NAIL_LIFT: f32 = 0.15e-3;
/// Points of a ring around the lids on the upper lid, with both corners.
const UPPER: usize = 18;

/// How strong the colors of a face are.
struct Tones {
    cheeks: f32,
    lips: f32,
    /// Factor on the lips' own color.
    lip_tone: f32,
    /// What colors the lips.
    rouge: Vec3,
    /// How strong the line along the upper lashes is.
    lash_line: f32,
    /// How strong the color over the eyes is.
    shadow: f32,
}

impl Tones {
    /// A little color.
    const LIGHT: Self = Self {
        cheeks: 0.34,
        lips: 0.78,
        lip_tone: 1.0,
        rouge: LIPS,
        lash_line: 1.0,
        shadow: 0.0,
    };

    const fn of(makeup: Makeup, figure: Figure) -> Self {
        match makeup {
            Makeup::OfFigure => Self::of_figure(figure),
            Makeup::Bare => Self {
                cheeks: 0.10,
                lips: 0.34,
                lip_tone: 0.95,
                rouge: LIPS,
                lash_line: 0.6,
                shadow: 0.0,
            },
            Makeup::Light => Self::LIGHT,
            Makeup::Stage => Self {
                cheeks: 0.62,
                lips: 0.95,
                lip_tone: 1.0,
                rouge: ROUGE,
                lash_line: 1.0,
                shadow: 0.62,
            },
        }
    }

    /// Blood shows less through older skin.
    fn fade(&mut self, old: f32) {
        self.cheeks *= 1.0 - 0.3 * old;
        self.lips *= 1.0 - 0.25 * old;
    }

    const fn of_figure(figure: Figure) -> Self {
        match figure {
            Figure::OfStature | Figure::Woman => Self::LIGHT,
            Figure::Man => Self {
                cheeks: 0.12,
                lips: 0.28,
                lip_tone: 0.86,
                rouge: LIPS,
                lash_line: 0.7,
                shadow: 0.0,
            },
            Figure::Child => Self {
                cheeks: 0.36,
                lips: 0.40,
                lip_tone: 1.0,
                rouge: LIPS,
                lash_line: 0.8,
                shadow: 0.0,
            },
        }
    }
}

/// Skin that sees little of the sky: it reddens before it darkens.
fn shaded(open: f32) -> Vec3 {
    let channel = |power: f32| 0.55 + 0.45 * trig::powf(open.max(0.0), power);
    SKIN * Vec3::new(channel(0.55), channel(0.8), channel(0.9))
}

fn factors(colors: impl Iterator<Item = Vec3>) -> Vec<Vec3> {
    colors.map(|color| (color / SKIN).min(Vec3::ONE)).collect()
}

/// Of a hand or a foot, without its nails.
pub(super) fn limb(part: &Part) -> Vec<Vec3> {
    factors(part.open.iter().map(|&open| shaded(open)))
}

/// Nails of a hand or a foot, a little over the skin, on points of their own at the part's end; their triangles.
pub(super) fn nails(part: &mut Part, colors: &mut Vec<Vec3>) -> Vec<[u32; 3]> {
    let normals = lole_geom::mesh::vertex_normals(&part.positions, &part.triangles);
    let mut own = vec![u32::MAX; part.positions.len()];
    let nails = part.triangles.iter().zip(&part.nails);
    let nails = nails.filter(|(_, nail)| **nail != 0);
    let nails: Vec<[u32; 3]> = nails.map(|(triangle, _)| *triangle).collect();
    let mut placed = |corner: u32| {
        let old = corner as usize;
        if own[old] == u32::MAX {
            own[old] = u32::try_from(part.positions.len()).unwrap_or(u32::MAX);
            part.positions
                .push(part.positions[old] + normals[old] * NAIL_LIFT);
            colors.push(Vec3::ONE);
        }
        own[old]
    };
    nails.iter().map(|nail| nail.map(&mut placed)).collect()
}

/// Of a head.
pub(super) fn head(head: &HeadPart, figure: Figure, appearance: &Appearance) -> Vec<Vec3> {
    let mut tones = Tones::of(appearance.makeup, figure);
    tones.fade(oldness(appearance.age_years));
    let part = &head.part;
    let mut colors: Vec<Vec3> = part.open.iter().map(|&open| shaded(open)).collect();
    let tint = |color: &mut Vec3, to: Vec3, share: f32| *color = color.lerp(to, share);
    for (color, &cheek) in colors.iter_mut().zip(&head.cheek) {
        tint(color, CHEEK, cheek * tones.cheeks);
    }
    for &point in &head.ear {
        let open = part.open[point as usize];
        tint(&mut colors[point as usize], EAR * open, 0.25);
    }
    let [tip, nostril] =
        [head.places.pronasale, head.places.nostril].map(|point| part.positions[point as usize]);
    let size = head.size();
    for (color, &place) in colors.iter_mut().zip(&part.positions) {
        let near =
            |center: Vec3, reach: f32| smooth_step(1.0 - place.distance(center) / (reach * size));
        tint(color, CHEEK, 0.7 * tones.cheeks * near(tip, 0.02));
        tint(color, NOSTRIL, 0.45 * near(nostril, 0.005));
    }
    if let Some(lined) = years::lined(head, appearance.age_years) {
        for (color, light) in colors.iter_mut().zip(lined) {
            // As in any hollow, red goes last.
            *color *= Vec3::new(light, light * light, light * light);
        }
    }
    shadow(head, tones.shadow, &mut colors);
    let lips = tones.rouge * tones.lip_tone;
    for (ring, points) in head.lips.iter().enumerate() {
        let share = match ring.checked_sub(head.lip_rim) {
            None => 0.0,
            Some(0) => 0.7,
            Some(1) => 0.92,
            Some(2..=6) => 1.0,
            Some(7..=8) => 0.7,
            Some(_) => 0.35,
        };
        for &point in points {
            tint(&mut colors[point as usize], lips, share * tones.lips);
        }
    }
    let rim = head.lid_rim;
    for (ring, points) in head.lids.iter().enumerate().skip(rim - 1) {
        let dark = match ring.cmp(&rim) {
            std::cmp::Ordering::Less => 0.25,
            std::cmp::Ordering::Equal => 0.75,
            std::cmp::Ordering::Greater => 0.9,
        };
        for (column, &point) in points.iter().enumerate() {
            let color = &mut colors[point as usize];
            if column <= UPPER {
                let from_corner = column.min(UPPER - column) as f32;
                let share = smooth_step((from_corner + 0.5) / 3.0);
                tint(color, LASHES, dark * share * tones.lash_line);
            } else if rim < ring {
                tint(color, LOWER_LID, 0.8);
            }
        }
    }
    factors(colors.into_iter())
}

/// Color over the eyes: full on the lid, gone at the brow.
fn shadow(head: &HeadPart, strength: f32, colors: &mut [Vec3]) {
    if strength <= 0.0 {
        return;
    }
    let positions = &head.part.positions;
    let Some(ring) = head.lids.get(head.lid_rim) else {
        return;
    };
    let lid: Vec<Vec3> = (ring.iter().take(UPPER + 1))
        .map(|&point| positions[point as usize])
        .collect();
    let reach = SHADOW_REACH * head.eye_radius;
    for (color, place) in colors.iter_mut().zip(positions) {
        let nearest = (lid.iter()).min_by(|a, b| {
            a.distance_squared(*place)
                .total_cmp(&b.distance_squared(*place))
        });
        let Some(nearest) = nearest else {
            continue;
        };
        let above = smooth_step((place.y - nearest.y) / (0.25 * reach));
        let share = strength * above * smooth_step(1.0 - place.distance(*nearest) / reach);
        *color = color.lerp(LID_SHADOW, share);
    }
}
