//! One garment on stage: its solver, what carries it, and how it comes to rest.

use glam::{Affine3A, Vec3};
use lole_cloth::diagnose::{self, StrainSummary};
use lole_cloth::method::settle::{SettleConfig, Settling};
use lole_costume::document::Design;
use lole_costume::sew::Lifts;
use lole_geom::Surfel;

use super::{FRAME_SECONDS, SETTLE_FRAMES};
use crate::production::Garment;
use crate::solver::{Observer, Solver, Surroundings};
use crate::{StageError, skin_check};

/// Least distance of an elastic row from the skin [m]: half the thickness of what is sewn there.
const PIN_CLEARANCE: f32 = 0.001;

/// Farthest that elastics stand off when a garment is put on [m], and the least that is tried.
const WIDEST_START: f32 = 0.03;
const LEAST_WIDENING: f32 = 0.003;

/// Time in which what is stitched onto a skirt is brought to it [s].
const PUTTING_ON: f32 = 0.6;

/// The moving part of a garment.
#[derive(Clone)]
pub(super) struct Worn {
    pub(super) solver: Solver,
    pin_targets: Vec<Vec3>,
    /// The skin below every pin.
    pin_skin: Vec<Surfel>,
    /// Brings the cloth to rest before the dance; `None` once it is, and for the paper's methods,
    /// whose experiments keep the damping they had.
    settling: Option<Settling>,
    /// Room for a row of pins.
    lifts: Vec<f32>,
    /// How far its elastics have given way, on somebody given.
    given_way: Lifts,
    /// How far it has been put on, from 0 to 1.
    put_on: f32,
    /// Whether a step was not taken: it stays where it was.
    is_lost: bool,
}

/// The body in the present pose, as pins need it.
pub(super) struct Carrier<'a> {
    pub(super) world_from_bind: &'a [Affine3A],
    /// Vertices of the skin and their normals; `None` where capsules are met.
    pub(super) skin: Option<(&'a [Vec3], &'a [Vec3])>,
    /// The same as surfels; none where capsules are met.
    pub(super) surfels: &'a [Surfel],
    /// All of the forearms' surfels, those too that touch no cloth.
    pub(super) forearms: &'a [Surfel],
    /// Triangles of the skin.
    pub(super) triangles: &'a [[u32; 3]],
}

impl Carrier<'_> {
    /// How far the elastics of a garment would give way.
    fn lifts(&self, garment: &Garment) -> Lifts {
        let Some(band) = &garment.sewn.band else {
            return Lifts::default();
        };
        let watched = garment.watched.iter();
        let surfels = watched.filter_map(|watched| {
            let surfel = self.surfels.get(watched.surfel as usize)?;
            Some((*surfel, watched.bone))
        });
        band.lifts(self.world_from_bind, surfels)
    }

    /// How far the elastics of a garment stand off when it is put on: as far as they give way, and as all
    /// that hangs from them needs to lie outside of her, if that is not too far.
    fn lifts_at_start(&self, garment: &Garment) -> Lifts {
        let given_way = self.lifts(garment).lowered();
        let Some((positions, normals)) = self.skin.filter(|_| garment.sewn.band.is_some()) else {
            return given_way;
        };
        let skin = skin_check::CheckedSurface {
            positions,
            normals,
            triangles: self.triangles,
        };
        let mut out = 0.0;
        while out < WIDEST_START {
            let start = garment
                .sewn
                .start_positions(self.world_from_bind, &given_way.widened(out));
            let depths = skin_check::depths(skin, &start).into_iter();
            let deepest = depths.fold(0.0, f32::max);
            if deepest == 0.0 {
                break;
            }
            out += deepest.max(LEAST_WIDENING);
        }
        given_way.widened(out.min(WIDEST_START))
    }
}

impl Worn {
    /// A garment where its drape starts.
    pub(super) fn new(
        design: &Design,
        garment: &Garment,
        body: &Carrier<'_>,
    ) -> Result<Self, StageError> {
        let given_way = body.lifts_at_start(garment);
        let start = garment
            .sewn
            .start_positions(body.world_from_bind, &given_way);
        let spec = &garment.sewn.spec;
        let solver = Solver::new(design, (spec, garment.rows), &start)?;
        let settle = SettleConfig {
            dt: FRAME_SECONDS,
            frame_limit: SETTLE_FRAMES,
            ..SettleConfig::default()
        };
        let is_quick = solver.explicit().is_none();
        Ok(Self {
            settling: is_quick.then(|| Settling::new(spec, settle, &start)),
            solver,
            pin_targets: Vec::new(),
            pin_skin: Vec::new(),
            lifts: Vec::new(),
            given_way,
            put_on: 0.0,
            is_lost: false,
        })
    }

    /// Places the pins on the body, and those of the particles that a hand holds (ascending, by
    /// their numbers in this garment).
    pub(super) fn place_pins(
        &mut self,
        garment: &Garment,
        body: &Carrier<'_>,
        held: &[(u32, Vec3)],
    ) {
        let lifts = body.lifts(garment);
        self.given_way.approach(&lifts, FRAME_SECONDS);
        let put_on = (self.put_on, &self.given_way);
        garment
            .sewn
            .pose_pins(body.world_from_bind, put_on, &mut self.pin_targets);
        let skin = (body.skin).filter(|_| garment.sewn.band.is_none());
        if let (Some(skin), Some(surfels)) = (skin, &garment.pin_surfels) {
            surfels.pose(skin.0, skin.1, &mut self.pin_skin);
            let column_count = garment.sewn.spec.grid.column_count as usize;
            self.lift_pins(column_count, garment.sewn.fold_columns);
            // What was lifted is farther from the next elastic.
            garment.sewn.slide_elastics(&mut self.pin_targets);
            self.lift_pins(column_count, garment.sewn.fold_columns);
            let forearms: Vec<Part<'_>> = body.forearms.chunks(PART).map(Part::new).collect();
            let rows = self.pin_targets.chunks_mut(column_count);
            for (targets, skin) in rows.zip(self.pin_skin.chunks(column_count)) {
                press_pins((targets, skin), &forearms, garment.sewn.fold_columns);
            }
        }
        if !held.is_empty() {
            let pins = garment.sewn.pins.iter().map(|pin| pin.particle);
            let mut all: Vec<(u32, Vec3)> = pins.zip(self.pin_targets.drain(..)).collect();
            all.extend(held);
            all.sort_by_key(|&(particle, _)| particle);
            self.pin_targets
                .extend(all.iter().map(|&(_, target)| target));
        }
    }

    /// Skin that folds would swallow the tape, which runs straight between the points that carry it.
    /// What lifts one turn of a gather of `fold_columns` pins lifts the whole of it, and its neighbors
    /// in part: a gather that is pressed flat from inside has more cloth than room.
    fn lift_pins(&mut self, column_count: usize, fold_columns: usize) {
        let rows = self.pin_targets.chunks_mut(column_count);
        for (targets, skin) in rows.zip(self.pin_skin.chunks(column_count)) {
            self.lifts.clear();
            self.lifts
                .extend(targets.iter().zip(skin).map(|(target, skin)| {
                    let gap = (*target - skin.position).dot(skin.normal);
                    (PIN_CLEARANCE - gap).max(0.0)
                }));
            if self.lifts.iter().all(|&lift| lift == 0.0) {
                continue;
            }
            let lifts = spread(&self.lifts, fold_columns);
            for ((target, skin), lift) in targets.iter_mut().zip(skin).zip(lifts) {
                *target += skin.normal * lift;
            }
        }
    }

    /// Moves the cloth on by a frame among what touches it.
    pub(super) fn step(&mut self, surroundings: &Surroundings<'_>, observer: Observer<'_>) {
        let surroundings = Surroundings {
            pin_targets: &self.pin_targets,
            ..*surroundings
        };
        let moved = self.solver.step(&surroundings, FRAME_SECONDS, observer);
        self.is_lost |= moved.is_err();
        self.put_on = (self.put_on + FRAME_SECONDS / PUTTING_ON).min(1.0);
    }

    pub(super) const fn is_lost(&self) -> bool {
        self.is_lost
    }

    /// Writes the positions of its particles [m], row-major, after what is in `out`.
    pub(super) fn add_positions(&self, out: &mut Vec<Vec3>) {
        self.solver.add_positions(out);
    }

    /// Damps the cloth, which lies at `positions` [m], on its way to rest; whether it is there.
    pub(super) fn settle(&mut self, positions: &[Vec3]) -> bool {
        let Some(settling) = &mut self.settling else {
            return true;
        };
        let verdict = settling.judge(positions);
        if let Some(kept) = verdict.kept {
            self.solver.scale_velocities(kept);
        }
        verdict.end.is_some()
    }

    /// Whether it is brought to rest by [`Self::settle`].
    pub(super) const fn is_settling(&self) -> bool {
        self.settling.is_some()
    }

    /// Lets the dance begin.
    pub(super) fn let_go(&mut self) {
        self.settling = None;
    }

    /// How much the cloth at `positions` [m] is stretched, and how much of it is in the skin.
    pub(super) fn measure(
        garment: &Garment,
        positions: &[Vec3],
        body: skin_check::CheckedSurface<'_>,
    ) -> (StrainSummary, skin_check::SkinCheck) {
        let cloth = skin_check::CheckedSurface {
            positions,
            normals: &[],
            triangles: &garment.mesh.particle_triangles,
        };
        (
            diagnose::strain(&garment.sewn.spec, positions),
            skin_check::check(body, cloth),
        )
    }
}

/// A forearm that hangs against the band presses a row of gathers flat on the skin below each of them, as far
/// as they stand off: a whole gather of `fold_columns` and its neighbors in part.
fn press_pins(
    (targets, skin): (&mut [Vec3], &[Surfel]),
    forearms: &[Part<'_>],
    fold_columns: usize,
) {
    let stands_off = |target: Vec3, skin: &Surfel| {
        let gap = (target - skin.position).dot(skin.normal);
        (gap - PIN_CLEARANCE).max(0.0)
    };
    let low = forearms
        .iter()
        .fold(Vec3::INFINITY, |low, part| low.min(part.low));
    let high = forearms
        .iter()
        .fold(Vec3::NEG_INFINITY, |high, part| high.max(part.high));
    let pressed = targets.iter().zip(skin).map(|(&target, skin)| {
        let off = stands_off(target, skin);
        let is_near = target.cmpge(low).all() && target.cmple(high).all();
        if 0.0 < off && is_near {
            depth(target, forearms).min(off)
        } else {
            0.0
        }
    });
    let pressed: Vec<f32> = pressed.collect();
    if pressed.iter().all(|&it| it == 0.0) {
        return;
    }
    let pressed = spread(&pressed, fold_columns);
    for ((target, skin), pressed) in targets.iter_mut().zip(skin).zip(pressed) {
        *target -= skin.normal * pressed.min(stands_off(*target, skin));
    }
}

/// Corners of a box around surfels, with a little room; an empty one around none.
fn bounds(surfels: &[Surfel]) -> (Vec3, Vec3) {
    let empty = (Vec3::INFINITY, Vec3::NEG_INFINITY);
    surfels.iter().fold(empty, |(low, high), surfel| {
        let at = surfel.position;
        (low.min(at - PIN_CLEARANCE), high.max(at + PIN_CLEARANCE))
    })
}

/// Surfels of a part of skin: they are copied slice by slice along a forearm, and so many lie near each other.
const PART: usize = 32;

/// A part of skin, and a box around it.
struct Part<'a> {
    surfels: &'a [Surfel],
    low: Vec3,
    high: Vec3,
}

impl<'a> Part<'a> {
    fn new(surfels: &'a [Surfel]) -> Self {
        let (low, high) = bounds(surfels);
        Self { surfels, low, high }
    }

    /// Square of a distance [m²] that none of its surfels is nearer to a place than.
    fn least_square(&self, place: Vec3) -> f32 {
        place.distance_squared(place.clamp(self.low, self.high))
    }
}

/// How far inside of a skin a place is that should be clear of it [m], 0 outside: by the nearest surfel.
fn depth(place: Vec3, skin: &[Part<'_>]) -> f32 {
    let mut nearest: Option<(f32, &Surfel)> = None;
    for part in skin {
        if nearest.is_some_and(|(square, _)| square <= part.least_square(place)) {
            continue;
        }
        for surfel in part.surfels {
            let square = surfel.position.distance_squared(place);
            if nearest.is_none_or(|(least, _)| square < least) {
                nearest = Some((square, surfel));
            }
        }
    }
    nearest.map_or(0.0, |(_, nearest)| {
        let out = (place - nearest.position).dot(nearest.normal);
        (PIN_CLEARANCE - out).max(0.0)
    })
}

/// The mean, over `reach` places to either side on a closed line, of the largest values as far around
/// each of them: nowhere less than the value itself.
fn spread(values: &[f32], reach: usize) -> Vec<f32> {
    let reach = reach.min(values.len());
    let width = 2 * reach + 1;
    let wrapped =
        |values: &[f32]| [&values[values.len() - reach..], values, &values[..reach]].concat();
    let largest = |near: &[f32]| near.iter().copied().fold(0.0, f32::max);
    let largest: Vec<f32> = wrapped(values).windows(width).map(largest).collect();
    let mean = |near: &[f32]| near.iter().sum::<f32>() / width as f32;
    wrapped(&largest).windows(width).map(mean).collect()
}

#[cfg(test)]
mod tests {
    use lole_geom::trig;

    use super::*;

    /// Gathers of ten pins around a waist of 10 cm that stand off by 2 to 10 mm, and an arm whose skin is 5 mm
    /// off the waist on its right.
    #[test]
    fn an_arm_presses_gathers_flat_and_lets_no_pins_change_places() {
        let around = |turn: f32| {
            let (sin, cos) = trig::sin_cos(turn);
            Vec3::new(cos, 0.0, sin)
        };
        let turns = (0..200_u16).map(|pin| f32::from(pin) * std::f32::consts::TAU / 200.0);
        let normals: Vec<Vec3> = turns.map(around).collect();
        let off = |pin: usize| 0.002 + 0.0016 * (pin % 10).abs_diff(5) as f32;
        let waist = normals.iter().map(|&normal| Surfel {
            position: normal * 0.1,
            normal,
        });
        let skin: Vec<Surfel> = waist.collect();
        let mut pins: Vec<Vec3> = (0..200)
            .map(|pin| normals[pin] * (0.1 + off(pin)))
            .collect();
        let before = pins.clone();
        let arm = (0..20_u8).map(|it| Surfel {
            position: around((f32::from(it) - 10.0) * 0.02) * 0.105,
            normal: Vec3::NEG_X,
        });
        let mut arm: Vec<Surfel> = arm.collect();
        let outer = arm.iter().map(|inner| Surfel {
            position: inner.position + Vec3::X * 0.06,
            normal: Vec3::X,
        });
        arm.extend(outer.collect::<Vec<_>>());
        let arm = [Part::new(&arm)];
        press_pins((&mut pins, &skin), &arm, 10);
        for (pin, (&now, &before)) in pins.iter().zip(&before).enumerate() {
            assert!(depth(now, &arm) < 1.0e-6 || before == now, "{pin}");
            assert!(
                0.101 - 1.0e-6 < now.length(),
                "{pin} is pressed into the waist"
            );
            assert!(
                now.normalize_or_zero().distance(normals[pin]) < 1.0e-6,
                "{pin} has moved along"
            );
            assert!(now.length() <= before.length() + 1.0e-6);
        }
        assert!(pins[0].length() + 0.004 < before[0].length());
        assert_eq!(pins[100], before[100], "behind her");
    }

    #[test]
    fn what_is_spread_lies_over_the_values_evenly_and_closes() {
        let mut values = [0.0_f32; 40];
        values[1] = 3.0;
        values[20] = 1.0;
        let over = spread(&values, 4);
        assert_eq!(over.len(), values.len());
        for (place, (&over, &value)) in over.iter().zip(&values).enumerate() {
            assert!(value <= over + 1e-6, "{place}: {over}");
            let next = spread(&values, 4)[(place + 1) % 40];
            assert!(
                (over - next).abs() <= 3.0 / 9.0 + 1e-6,
                "{place}: {over} and {next}"
            );
        }
        assert!(0.0 < over[39], "around the seam");
        assert_eq!(over[30], 0.0, "no farther than twice the reach");
        assert_eq!(spread(&[2.0; 9], 4), [2.0; 9]);
    }
}
