//! Particles while constraints are solved: place and inverse mass side by side, so that one load
//! brings all of a particle, whichever it is.
//!
//! A particle is four numbers, `x`, `y`, `z` [m] and the inverse mass [1/kg]. Constraints name
//! their particles by offsets of sixteen bits into a window of so many numbers, which every column
//! of particles is long enough for: no offset can lead out of it, so none is checked.

use fearless_simd::{f32x4, f32x16, prelude::*};

use crate::lanes::{LANES, Scalars, Vectors};

/// Numbers of one particle.
pub(crate) const WIDTH: usize = 4;

/// Particles that a window holds.
pub(crate) const WINDOW_SLOTS: usize = 1 << 14;

/// Windows start at multiples of so many slots, the last of which is never a particle's.
pub(crate) const BASE_STEP: usize = 1 << 12;

/// Numbers that an offset and the three after it may name.
const WINDOW: usize = WINDOW_SLOTS * WIDTH + WIDTH;

/// Part of the particles, as the constraints of one batch see them.
pub(crate) type Window = [f32; WINDOW];

/// Numbers in a column of so many slots: every slot can start a window.
pub(crate) const fn column_length(slot_count: usize) -> usize {
    slot_count * WIDTH + WINDOW
}

/// One particle for each lane, as offsets into a window.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(32))]
pub(crate) struct Lanes(pub(crate) [u16; LANES]);

impl Lanes {
    /// Inverse masses of the particles in a window that starts at slot `base` [1/kg]; 0 for what is
    /// none.
    pub(crate) fn inv_masses(&self, base: u32, inv_masses: &[Scalars]) -> [f32; LANES] {
        self.0.map(|offset| {
            let slot = base as usize + usize::from(offset) / WIDTH;
            inv_masses
                .get(slot / LANES)
                .map_or(0.0, |vector| vector.0[slot % LANES])
        })
    }
}

/// Sixteen particles: places, and inverse masses.
#[derive(Clone, Copy)]
pub(crate) struct Gathered<S: Simd> {
    pub(crate) place: Vectors<S>,
    pub(crate) inv_mass: f32x16<S>,
}

/// The window that starts at slot `base`.
#[inline(always)]
pub(crate) fn window(particles: &mut [f32], base: u32) -> Option<&mut Window> {
    particles
        .get_mut(base as usize * WIDTH..)?
        .first_chunk_mut()
}

/// Brings the particles of `lanes` side by side.
#[inline(always)]
pub(crate) fn gather<S: Simd>(simd: S, window: &Window, lanes: &Lanes) -> Gathered<S> {
    let lanes = &lanes.0;
    transpose([
        four(simd, window, [lanes[0], lanes[1], lanes[2], lanes[3]]),
        four(simd, window, [lanes[4], lanes[5], lanes[6], lanes[7]]),
        four(simd, window, [lanes[8], lanes[9], lanes[10], lanes[11]]),
        four(simd, window, [lanes[12], lanes[13], lanes[14], lanes[15]]),
    ])
}

#[inline(always)]
fn four<S: Simd>(simd: S, window: &Window, [a, b, c, d]: [u16; 4]) -> f32x16<S> {
    let low = simd.combine_f32x4(one(simd, window, a), one(simd, window, b));
    let high = simd.combine_f32x4(one(simd, window, c), one(simd, window, d));
    simd.combine_f32x8(low, high)
}

#[inline(always)]
fn one<S: Simd>(simd: S, window: &Window, offset: u16) -> f32x4<S> {
    let offset = usize::from(offset);
    f32x4::from_slice(simd, &window[offset..offset + WIDTH])
}

/// The particles of sixteen slots, wherever they stand.
#[inline(always)]
pub(crate) fn gather_far<S: Simd>(simd: S, particles: &[f32], slots: &[u32; LANES]) -> Gathered<S> {
    transpose([
        four_far(simd, particles, [slots[0], slots[1], slots[2], slots[3]]),
        four_far(simd, particles, [slots[4], slots[5], slots[6], slots[7]]),
        four_far(simd, particles, [slots[8], slots[9], slots[10], slots[11]]),
        four_far(
            simd,
            particles,
            [slots[12], slots[13], slots[14], slots[15]],
        ),
    ])
}

#[inline(always)]
fn four_far<S: Simd>(simd: S, particles: &[f32], [a, b, c, d]: [u32; 4]) -> f32x16<S> {
    let low = simd.combine_f32x4(one_far(simd, particles, a), one_far(simd, particles, b));
    let high = simd.combine_f32x4(one_far(simd, particles, c), one_far(simd, particles, d));
    simd.combine_f32x8(low, high)
}

#[inline(always)]
fn one_far<S: Simd>(simd: S, particles: &[f32], slot: u32) -> f32x4<S> {
    let first = slot as usize * WIDTH;
    f32x4::from_slice(simd, &particles[first..first + WIDTH])
}

/// Four vectors of four particles each become their coordinates.
#[inline(always)]
fn transpose<S: Simd>([a, b, c, d]: [f32x16<S>; 4]) -> Gathered<S> {
    let (xz_low, yw_low) = (a.unzip_low(b), a.unzip_high(b));
    let (xz_high, yw_high) = (c.unzip_low(d), c.unzip_high(d));
    Gathered {
        place: Vectors {
            x: xz_low.unzip_low(xz_high),
            y: yw_low.unzip_low(yw_high),
            z: xz_low.unzip_high(xz_high),
        },
        inv_mass: yw_low.unzip_high(yw_high),
    }
}

/// Coordinates of sixteen particles become four vectors of four particles each: [`transpose`] undone.
#[inline(always)]
fn untranspose<S: Simd>(sixteen: Gathered<S>) -> [f32x16<S>; 4] {
    let Gathered { place, inv_mass } = sixteen;
    let (xz_low, xz_high) = (place.x.zip_low(place.z), place.x.zip_high(place.z));
    let (yw_low, yw_high) = (place.y.zip_low(inv_mass), place.y.zip_high(inv_mass));
    [
        xz_low.zip_low(yw_low),
        xz_low.zip_high(yw_low),
        xz_high.zip_low(yw_high),
        xz_high.zip_high(yw_high),
    ]
}

/// Puts particles back where [`gather`] found them.
#[inline(always)]
pub(crate) fn scatter<S: Simd>(sixteen: Gathered<S>, window: &mut Window, lanes: &Lanes) {
    let [a, b, c, d] = untranspose(sixteen);
    let lanes = &lanes.0;
    put_four(a, window, [lanes[0], lanes[1], lanes[2], lanes[3]]);
    put_four(b, window, [lanes[4], lanes[5], lanes[6], lanes[7]]);
    put_four(c, window, [lanes[8], lanes[9], lanes[10], lanes[11]]);
    put_four(d, window, [lanes[12], lanes[13], lanes[14], lanes[15]]);
}

#[inline(always)]
fn put_four<S: Simd>(four: f32x16<S>, window: &mut Window, offsets: [u16; 4]) {
    let simd = four.token();
    let (low, high) = simd.split_f32x16(four);
    let (a, b) = simd.split_f32x8(low);
    let (c, d) = simd.split_f32x8(high);
    put_one(a, window, offsets[0]);
    put_one(b, window, offsets[1]);
    put_one(c, window, offsets[2]);
    put_one(d, window, offsets[3]);
}

#[inline(always)]
fn put_one<S: Simd>(one: f32x4<S>, window: &mut Window, offset: u16) {
    let offset = usize::from(offset);
    one.store_slice(&mut window[offset..offset + WIDTH]);
}

/// Sixteen neighbors in the order of the particles.
#[inline(always)]
pub(crate) fn load<S: Simd>(simd: S, particles: &[f32; LANES * WIDTH]) -> Gathered<S> {
    transpose([
        quarter(simd, particles, 0),
        quarter(simd, particles, 1),
        quarter(simd, particles, 2),
        quarter(simd, particles, 3),
    ])
}

#[inline(always)]
fn quarter<S: Simd>(simd: S, particles: &[f32; LANES * WIDTH], index: usize) -> f32x16<S> {
    f32x16::from_slice(simd, &particles[index * LANES..(index + 1) * LANES])
}

/// Puts sixteen particles where [`load`] found them.
#[inline(always)]
pub(crate) fn store<S: Simd>(sixteen: Gathered<S>, particles: &mut [f32; LANES * WIDTH]) {
    for (quarter, vector) in particles.chunks_exact_mut(LANES).zip(untranspose(sixteen)) {
        vector.store_slice(quarter);
    }
}
