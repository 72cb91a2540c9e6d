//! Skirts of strands: split ti leaves on a braided cord, raffia and film on a band with elastic.
//!
//! Every strand hangs from a point of the band, which the skin carries. Strands lie in layers, each a
//! little farther from the skin, and neighbors of a layer keep their order.

use std::f32::consts::TAU;

use glam::Vec3;
use lole_body::TapePoint;
use lole_cloth::strands::{Link, Ring, Strand, StrandConfig};
use lole_geom::trig;
use lole_pattern::DraftError;

use super::blade::half_width;
use super::body::rider;
use super::chosen::{Chosen, chance, real, whole};
use super::shape::{OnStrands, Shape};
use super::{AdornmentFinish, Carrier, HangingStrands, Made, Rider, Surface, Wearer};
use crate::GarmentSpec;
use crate::drafting::strands::is_on_hips;

/// Strands that are moved at most; more of them are drawn beside these.
const MOST_STRANDS: usize = 260;
/// Particles of a strand.
const PARTICLES: usize = 10;
/// Points of a band that is drawn.
const BAND_POINTS: usize = 96;
/// Gap between skin and the innermost layer, and from layer to layer [m].
const SKIN_GAP: f32 = 0.005;
const LAYER_GAP: f32 = 0.0022;
/// Slope with which strands are let down, out over down: outside of hips and thighs.
const FLARE: f32 = 0.85;

/// What a skirt is made of.
struct Stuff {
    /// Strands that are drawn.
    count: usize,
    /// Layers in which they lie.
    layers: usize,
    /// Width of a strand [m].
    width: f32,
    /// Height of the band [m].
    band: f32,
    linear_density: f32,
    bend_stiffness: f32,
    drag_rate: f32,
    friction: f32,
    /// Particles at the upper end that the band holds.
    held: u32,
    /// How far neighbors may part at the hem, over their distance at the band.
    spread: f32,
}

/// Where a skirt is worn.
struct Hung {
    height: f32,
    length: f32,
    /// Girth at the band [m].
    girth: f32,
}

impl Hung {
    fn new(chosen: &Chosen<'_>, wearer: &Wearer<'_>) -> Self {
        let measures = wearer.measures;
        let height = chosen.m("worn_height_cm", measures.hip_bone_height.to_m());
        let hem = chosen.m("hem_height_cm", measures.knee_height.to_m());
        let ring = wearer.dancer.tape_ring(height, BAND_POINTS);
        let next = ring.iter().cycle().skip(1);
        let girth = (ring.iter().zip(next))
            .map(|(a, b)| a.bind_position.distance(b.bind_position))
            .sum();
        Self {
            height,
            length: (height - hem).max(0.1),
            girth,
        }
    }
}

/// A ti-leaf skirt: each leaf is split into two halves that swing by themselves.
pub(crate) fn ti_leaf(spec: &GarmentSpec<'_>, wearer: &Wearer<'_>) -> Result<Made, DraftError> {
    let chosen = Chosen::new(spec)?;
    let hung = Hung::new(&chosen, wearer);
    let leaves = f64::from(hung.girth) / f64::from(chosen.m("leaf_spacing_cm", 0.009)).max(1e-3);
    let stuff = Stuff {
        count: 2 * whole(leaves).max(8),
        layers: 4,
        width: 0.046,
        band: 0.022,
        linear_density: 0.012,
        bend_stiffness: 1.3e-4,
        drag_rate: 1.4,
        friction: 0.35,
        held: 2,
        spread: 3.2,
    };
    let cord = chosen.ground();
    let leaf = chosen.leaf();
    let mut made = hang(wearer, &hung, &stuff, |on, (one, strand), spacing| {
        let length = spacing * real(PARTICLES - 1);
        // Both halves of a leaf are alike; leaves differ.
        let whole_leaf = one / 2;
        let light = 1.0 + 0.38 * chance(whole_leaf, 91);
        let ripe = 1.0 + 0.35 * chance(whole_leaf, 92);
        let color = leaf * Vec3::new(light * ripe, light, light * (1.4 - 0.4 * ripe));
        let ends = 1.0 + 0.10 * chance(whole_leaf, 96) + 0.05 * chance(one, 93);
        // One half has its rib on the left, the other on the right.
        let rib = if one.is_multiple_of(2) { 1.0 } else { -1.0 };
        let width = stuff.width * (1.0 + 0.15 * chance(one, 94));
        let twist = 0.75 * chance(one, 95);
        let half = Shape::sheet([14, 2], |along, across| {
            // The stem is whole for a sixth of the length, then the blade widens.
            let blade = half_width((0.10 + 0.90 * along).min(1.0)).max(0.10);
            let side = rib * (across - if rib < 0.0 { 1.0 } else { 0.0 });
            let (sin, cos) = trig::sin_cos(twist * along);
            let (x, y) = (
                width * blade * side,
                0.009 * trig::sin(3.0 * across) * blade,
            );
            let place = Vec3::new(x * cos - y * sin, y * cos + x * sin, length * along * ends);
            let shade = 0.72 + 0.30 * along + 0.12 * (1.0 - side.abs());
            let dry = Vec3::new(1.25, 1.05, 0.7).lerp(Vec3::ONE, (6.0 * (1.0 - along)).min(1.0));
            (place, (color * shade * dry).clamp(Vec3::ZERO, Vec3::ONE))
        });
        on.add_bent(&half, (strand, spacing));
    })?;
    made.surfaces.insert(0, braid(wearer, &hung, cord));
    Ok(named(made, AdornmentFinish::Leaf))
}

/// A raffia skirt: bundles of thin fibers.
pub(crate) fn raffia(spec: &GarmentSpec<'_>, wearer: &Wearer<'_>) -> Result<Made, DraftError> {
    let chosen = Chosen::new(spec)?;
    let hung = Hung::new(&chosen, wearer);
    let per_cm = chosen.number("strands_per_cm_ratio", 2.0);
    let stuff = Stuff {
        count: whole(f64::from(hung.girth) * 100.0 * per_cm).max(8),
        layers: 4,
        width: 0.006,
        band: chosen.m("band_cm", 0.035),
        linear_density: 0.0014,
        bend_stiffness: 1.2e-6,
        drag_rate: 2.0,
        friction: 0.35,
        held: 1,
        spread: 3.0,
    };
    let straw = chosen.leaf();
    let mut made = hang(wearer, &hung, &stuff, |on, (one, strand), spacing| {
        let length = spacing * real(PARTICLES - 1);
        // Each is folded: two halves, torn into fibers.
        for fiber in 0..6 {
            let number = 6 * one + fiber;
            let light = 1.0 + 0.22 * chance(number, 101);
            let color = straw * Vec3::new(light, light * (1.0 + 0.05 * chance(number, 102)), light);
            let ends = 1.0 + 0.06 * chance(number, 103);
            let [aside, out] = [104, 105].map(|salt| chance(number, salt));
            let (curl, phase) = (0.004 * chance(number, 106), 3.0 * chance(number, 107));
            let width = stuff.width * (0.75 + 0.35 * chance(number, 108));
            let fan = Shape::sheet([11, 1], |along, across| {
                let wave = curl * trig::sin(9.0 * along + phase) * along;
                let open = 0.40 + 0.60 * along;
                let side = across - 0.5;
                let place = Vec3::new(
                    0.017 * aside * open + width * side * (1.0 - 0.6 * along) + wave,
                    0.007 * out * open + 0.5 * wave + 0.15 * width * side * aside,
                    length * along * ends,
                );
                let shade = 0.80 + 0.20 * along;
                (place, (color * shade).clamp(Vec3::ZERO, Vec3::ONE))
            });
            on.add_bent(&fan, (strand, spacing));
        }
    })?;
    made.surfaces
        .insert(0, band(wearer, &hung, &stuff, chosen.ground()));
    Ok(named(made, AdornmentFinish::Fiber))
}

/// A cellophane skirt: narrow strips of shining film.
pub(crate) fn cellophane(spec: &GarmentSpec<'_>, wearer: &Wearer<'_>) -> Result<Made, DraftError> {
    let chosen = Chosen::new(spec)?;
    let hung = Hung::new(&chosen, wearer);
    let width = chosen.m("strip_cm", 0.008);
    let layers = chosen.count("layer_count").max(1);
    let per_layer = f64::from(hung.girth * 1.05 / width.max(1e-3));
    let stuff = Stuff {
        count: (whole(per_layer) * layers).max(8),
        layers,
        width,
        band: chosen.m("band_cm", 0.035),
        linear_density: 0.0004,
        bend_stiffness: 6.0e-8,
        drag_rate: 3.5,
        friction: 0.25,
        held: 1,
        spread: 3.0,
    };
    let film = chosen.leaf();
    let mut made = hang(wearer, &hung, &stuff, |on, (one, strand), spacing| {
        let length = spacing * real(PARTICLES - 1);
        let light = 1.0 + 0.18 * chance(one, 111);
        let ends = 1.0 + 0.03 * chance(one, 112);
        let (turn, phase) = (0.9 * chance(one, 113), 3.1 * chance(one, 114));
        let color = (film * light).clamp(Vec3::ZERO, Vec3::ONE);
        let strip = Shape::sheet([14, 1], |along, across| {
            // Film is never flat: each strip twists its own way and glints.
            let angle = turn * along + 0.45 * trig::sin(8.0 * along + phase) * along;
            let (sin, cos) = trig::sin_cos(angle);
            let side = stuff.width * 1.25 * (across - 0.5);
            let crinkle = 0.0025 * trig::sin(21.0 * along + 2.0 * phase) * along;
            let place = Vec3::new(side * cos, side * sin + crinkle, length * along * ends);
            (place, color)
        });
        on.add_bent(&strip, (strand, spacing));
    })?;
    made.surfaces
        .insert(0, band(wearer, &hung, &stuff, chosen.ground()));
    Ok(named(made, AdornmentFinish::Film))
}

/// Gives what hangs its finish; the band keeps its own.
fn named(mut made: Made, finish: AdornmentFinish) -> Made {
    for surface in made.surfaces.iter_mut().skip(1) {
        surface.finish = finish;
    }
    made
}

/// Hangs strands around the band; `draw` draws one by its number on the strand that moves it, whose
/// particles are so far apart [m].
fn hang(
    wearer: &Wearer<'_>,
    hung: &Hung,
    stuff: &Stuff,
    draw: impl Fn(&mut OnStrands, (usize, usize), f32),
) -> Result<Made, DraftError> {
    let fastened = 0.5 * f64::from(stuff.band);
    is_on_hips(wearer.measures, f64::from(hung.height), fastened)?;
    let moved = stuff.count.min(MOST_STRANDS);
    let spacing = hung.length / real(PARTICLES - 1);
    let ring = wearer
        .dancer
        .tape_ring(hung.height - 0.5 * stuff.band, moved);
    let lower = wearer
        .dancer
        .tape_ring(hung.height - 0.5 * stuff.band - spacing, 4 * moved);
    let mut hanging = HangingStrands {
        config: StrandConfig {
            drag_rate: stuff.drag_rate,
            friction: stuff.friction,
            substep_count: 10,
            ..StrandConfig::default()
        },
        ..HangingStrands::default()
    };
    let gap = |strand: usize| SKIN_GAP + LAYER_GAP * real(layer_of(strand, stuff.layers));
    for (strand, point) in ring.iter().enumerate() {
        let root = outside(&rider(point), gap(strand));
        let mut riders = vec![root];
        if 1 < stuff.held {
            riders.push(below(&root, &lower, (spacing, gap(strand))));
        }
        hanging.strands.push(Strand {
            positions: let_down(&riders, wearer, spacing),
            spacing,
            ring: Ring::Open,
            pinned: (0..stuff.held).collect(),
            linear_density: stuff.linear_density,
            bend_stiffness: stuff.bend_stiffness,
            contact_offset: gap(strand),
        });
        hanging.roots.push(root);
        hanging.pin_riders.extend(riders);
    }
    hanging.links = links(hung, stuff, moved);
    let mut on = OnStrands::default();
    for one in 0..stuff.count {
        draw(&mut on, (one, one * moved / stuff.count.max(1)), spacing);
    }
    Ok(Made {
        surfaces: vec![on.surface(AdornmentFinish::Fiber)],
        strands: Some(hanging),
        ..Made::default()
    })
}

/// Layers are dealt out so that neighbors around the waist lie over each other.
const fn layer_of(strand: usize, layers: usize) -> usize {
    strand % layers
}

/// A point of the band, lifted from the skin.
fn outside(of: &Rider, gap: f32) -> Rider {
    Rider {
        position: of.position + of.outward * gap,
        ..*of
    }
}

/// Where a stem that is held by the band lies one spacing lower: on the taut tape there.
fn below(root: &Rider, tape: &[TapePoint], (spacing, gap): (f32, f32)) -> Rider {
    let apart = |point: &TapePoint| {
        let way = point.bind_position - root.position;
        way.with_y(0.0).length_squared()
    };
    let nearest = tape.iter().min_by(|a, b| apart(a).total_cmp(&apart(b)));
    let lower = nearest.map_or(*root, |point| outside(&rider(point), gap));
    let way = (lower.position - root.position).normalize_or(Vec3::NEG_Y);
    Rider {
        position: root.position + way * spacing,
        // The band carries the stem with it.
        carrier: root.carrier,
        outward: root.outward,
    }
}

/// Where the particles of a strand begin: outside of all of the body.
fn let_down(riders: &[Rider], wearer: &Wearer<'_>, spacing: f32) -> Vec<Vec3> {
    let mut places: Vec<Vec3> = (riders.iter())
        .map(|rider| rider.posed(wearer.stance)[0])
        .collect();
    let outward = riders
        .first()
        .map_or(Vec3::Z, |rider| rider.posed(wearer.stance)[1]);
    let towards = (outward.with_y(0.0) * FLARE + Vec3::NEG_Y).normalize_or(Vec3::NEG_Y);
    while places.len() < PARTICLES {
        let last = places[places.len() - 1];
        places.push(last + towards * spacing);
    }
    places
}

/// Neighbors of a layer keep a distance: so narrow that they do not bunch, so wide that legs part them.
fn links(hung: &Hung, stuff: &Stuff, moved: usize) -> Vec<Link> {
    let mut links = Vec::new();
    let reach = stuff.layers.max(1);
    let at_band = hung.girth / real(moved) * real(reach);
    for strand in 0..moved {
        let next = (strand + reach) % moved;
        if next == strand {
            continue;
        }
        for particle in 2..PARTICLES {
            let down = real(particle) / real(PARTICLES - 1);
            let number =
                |strand: usize| u32::try_from(strand * PARTICLES + particle).unwrap_or(u32::MAX);
            links.push(Link {
                particles: [number(strand), number(next)],
                range: [
                    at_band * (0.85 - 0.45 * down),
                    at_band * (1.1 + stuff.spread * down * down),
                ],
                compliance: 0.02,
            });
        }
    }
    links
}

/// A band of cloth that hides the upper ends.
fn band(wearer: &Wearer<'_>, hung: &Hung, stuff: &Stuff, color: Vec3) -> Surface {
    let out = SKIN_GAP + LAYER_GAP * real(stuff.layers);
    let rows = [1.0, 0.75, 0.25, 0.0].map(|share| {
        let height = hung.height - stuff.band * (1.0 - share);
        let bulge = if share == 0.0 || share == 1.0 {
            0.7
        } else {
            1.0
        };
        (height, out * bulge)
    });
    let (shape, carriers) = around(wearer, &rows, |across| {
        let fold = trig::sin(TAU * 72.0 * across);
        (color * (0.90 + 0.10 * fold), 1.0 + 0.06 * fold)
    });
    shape.ridden_by(AdornmentFinish::Fiber, carriers)
}

/// The braided cord of a ti-leaf skirt, with the leaves' stems hung over it.
fn braid(wearer: &Wearer<'_>, hung: &Hung, color: Vec3) -> Surface {
    let out = SKIN_GAP + LAYER_GAP * 4.0;
    let rows = [
        (hung.height + 0.003, out * 0.6),
        (hung.height, out),
        (hung.height - 0.007, out + 0.003),
        (hung.height - 0.014, out + 0.003),
        (hung.height - 0.021, out - 0.001),
    ];
    let (shape, carriers) = around(wearer, &rows, |across| {
        let turn = trig::sin(TAU * 80.0 * across);
        (color * (0.85 + 0.15 * turn), 1.0 + 0.12 * turn)
    });
    shape.ridden_by(AdornmentFinish::Fiber, carriers)
}

/// Rows around the trunk at heights of the bind pose [m], so far from the taut tape [m]; `look` gives
/// color and how far a place bulges, by its share of the way around.
fn around(
    wearer: &Wearer<'_>,
    rows: &[(f32, f32)],
    look: impl Fn(f32) -> (Vec3, f32),
) -> (Shape, Vec<Carrier>) {
    const FINE: usize = 3 * BAND_POINTS;
    let rings: Vec<Vec<Rider>> = (rows.iter())
        .map(|&(height, _)| {
            let ring = wearer.dancer.tape_ring(height, FINE);
            ring.iter().map(rider).collect()
        })
        .collect();
    let count = rings.iter().map(Vec::len).min().unwrap_or(0);
    let mut carriers = Vec::new();
    for ring in &rings {
        for column in 0..=count {
            carriers.push(
                ring.get(column % count.max(1))
                    .map_or(Carrier::default(), |r| r.carrier),
            );
        }
    }
    if count == 0 {
        return (Shape::default(), Vec::new());
    }
    let last = rows.len() - 1;
    let index = |share: f32, most: usize| whole(f64::from(share * real(most))).min(most);
    let shape = Shape::sheet([last, count], |along, across| {
        let (row, column) = (index(along, last), index(across, count) % count);
        let rider = &rings[row][column];
        let (color, bulge) = look(across);
        (
            rider.position + rider.outward * (rows[row].1 * bulge),
            color,
        )
    });
    (shape, carriers)
}
