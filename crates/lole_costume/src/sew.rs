//! Sews a drafted pāʻū skirt or top to a dancer: flat rectangle → gathered tube of particles around
//! hips or bust, its elastic rows carried by the skin, outside of what she wears already.

mod band;
mod clothed;
mod error;
mod flounce;
mod fold_curve;
mod layout;
mod mesh;
mod profile;
mod ring;
mod rising;

use glam::{Affine3A, Vec3};
use lole_body::{Bone, Dancer, TapePoint};
use lole_cloth::{ClothSpec, Fabric, MassLaw};
use lole_garment::WornPlace;
use lole_pattern::design::pau_skirt::{PauDraft, PauMeasurements};

pub use band::{Band, Lifts, Watched};
pub use clothed::Clothed;
pub use error::SewError;
use layout::{BLOUSING, Layout};
pub use mesh::SkirtMesh;
use ring::{Flare, Ring};

/// How the skirt is divided into particles and laid around the dancer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SewSettings {
    /// Particles around the skirt; at least 512 for gathers of about 2 cm.
    pub column_count: u32,
    /// Particles from top fold to hem.
    pub row_count: u32,
    /// Ring length of one gather at the band [m].
    pub gather_pitch: f32,
    /// Depth of a gather at the band [m]: what cloth there is beyond that is crimped in puckers that the grid does
    /// not have.
    pub gather_depth: f32,
    /// Gap between the skin and the inner turn of the gathers [m]: a fold of cloth and elastic.
    pub band_gap: f32,
    /// How unevenly gathers are pushed together: 0 is a machine's pleating, 1 a loose hand's.
    pub unevenness: f32,
    /// Chance for the unevenness; same seed, same gathers.
    pub seed: u64,
}

impl Default for SewSettings {
    fn default() -> Self {
        Self {
            column_count: 512,
            row_count: 55,
            gather_pitch: 0.0165,
            gather_depth: 0.0075,
            band_gap: 0.004,
            unevenness: 0.5,
            seed: 1,
        }
    }
}

/// A particle carried by the skin: its place in the bind pose and the bones that move it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SkinPin {
    /// Particle it holds.
    pub particle: u32,
    point: TapePoint,
}

impl SkinPin {
    /// Where it is in the world [m].
    #[must_use]
    pub fn posed(&self, world_from_bind: &[Affine3A]) -> Vec3 {
        self.point.posed(world_from_bind)
    }

    /// The same, so much [m] nearer to the body.
    fn drawn_in(&self, by: f32) -> TapePoint {
        let mut point = self.point;
        point.bind_position -= point.outward * by;
        point
    }
}

/// A garment on paper, to be sewn.
#[derive(Debug, Clone, Copy)]
pub struct Cut<'a> {
    /// Its pieces.
    pub draft: &'a PauDraft,
    /// Where it is worn.
    pub worn: &'a PauMeasurements,
    /// Its cloth.
    pub fabric: &'a Fabric,
    /// What carries it.
    pub place: WornPlace,
    /// How its ends meet.
    pub closing: Closing,
    /// A fuller ring that is gathered and sewn to its lower edge.
    pub flounce: Option<&'a PauDraft>,
}

/// How the ends of a gathered rectangle meet.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Closing {
    /// They are sewn to each other, at the back.
    #[default]
    Sewn,
    /// They hang open beside each other, at the left side.
    Open,
}

/// A garment on a dancer, ready to be simulated and drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct SewnSkirt {
    /// What the engine needs to know.
    pub spec: ClothSpec,
    /// The pinned particles, in ascending order.
    pub pins: Vec<SkinPin>,
    /// Grid rows that carry elastic, from the top.
    pub elastic_rows: Vec<u32>,
    /// Particles of a gather, at most.
    pub fold_columns: usize,
    /// How far what is put on over something loose is drawn in, to be stitched onto it [m].
    drawn_in: f32,
    /// How far apart two elastics may be, over the cloth between them.
    taut: f32,
    /// What carries the elastics of somebody given; `None` where her skin does.
    pub band: Option<Band>,
    /// Every particle carried by the nearest skin, or by the band's bone: the start of the drape.
    start: Vec<TapePoint>,
}

impl SewnSkirt {
    /// Where the drape starts, in the pose `world_from_bind` [m], shape `[particle_count, 3]`; `lifts` is
    /// how far the elastics of a [`Self::band`] have given way, and is not looked at without one.
    #[must_use]
    pub fn start_positions(&self, world_from_bind: &[Affine3A], lifts: &Lifts) -> Vec<Vec3> {
        let Some(band) = &self.band else {
            let start = self.start.iter();
            return start.map(|point| point.posed(world_from_bind)).collect();
        };
        let columns = self.spec.grid.column_count as usize;
        let posed = |(index, point): (usize, &TapePoint)| {
            let [above, below] = self.elastics_at(index / columns);
            let [(one, part), (other, rest)] = [above, below];
            let lift =
                part * band.lift((one, point), lifts) + rest * band.lift((other, point), lifts);
            band.posed(world_from_bind, point, lift)
        };
        self.start.iter().enumerate().map(posed).collect()
    }

    /// The elastics above and below a row, with how much of it goes with each.
    fn elastics_at(&self, row: usize) -> [(usize, f32); 2] {
        let rows = &self.elastic_rows;
        let below = rows.partition_point(|&elastic| (elastic as usize) < row);
        if below == 0 || below == rows.len() {
            return [(below.min(rows.len() - 1), 1.0), (0, 0.0)];
        }
        let [from, to] = [rows[below - 1], rows[below]].map(|row| row as f32);
        let share = (row as f32 - from) / (to - from);
        [(below - 1, 1.0 - share), (below, share)]
    }

    /// Where every particle starts in the bind pose [m], row-major.
    pub fn bind_positions(&self) -> impl Iterator<Item = Vec3> {
        self.start.iter().map(|point| point.bind_position)
    }

    /// Where the pins are in the pose `world_from_bind` [m], in the order of [`Self::pins`]: on the
    /// skin that carries them, but where she stretches more than cloth does, the upper elastics
    /// slide down with the cloth below them; on the [`Self::band`], where there is one, whose elastics
    /// have given way as `lifts` says. `put_on`, from 0 to 1, is how far it has been put on: a
    /// ruffle that is stitched onto a skirt comes to it from outside.
    pub fn pose_pins(
        &self,
        world_from_bind: &[Affine3A],
        (put_on, lifts): (f32, &Lifts),
        targets: &mut Vec<Vec3>,
    ) {
        targets.clear();
        let pins = self
            .pins
            .iter()
            .map(|pin| pin.drawn_in(self.drawn_in * put_on));
        let Some(band) = &self.band else {
            targets.extend(pins.map(|point| point.posed(world_from_bind)));
            self.slide_elastics(targets);
            return;
        };
        let columns = self.spec.grid.column_count as usize;
        targets.extend(pins.enumerate().map(|(index, mut point)| {
            let at = (index / columns, &point);
            let (lift, rise) = (band.lift(at, lifts), band.rise(at, lifts));
            if 0.0 < rise {
                let above = (0..=index).rev().step_by(columns);
                let above = above.map(|it| self.pins[it].drawn_in(self.drawn_in * put_on));
                let above = above.map(|point| point.bind_position);
                point.bind_position = rising::climbed(above, rise).unwrap_or(point.bind_position);
            }
            band.posed(world_from_bind, &point, lift)
        }));
    }

    /// Lets every upper elastic slide down until the cloth below it reaches to the next one; `targets`
    /// [m] are where pins are, in the order of [`Self::pins`].
    pub fn slide_elastics(&self, targets: &mut [Vec3]) {
        let columns = self.spec.grid.column_count as usize;
        for upper in (0..self.elastic_rows.len().saturating_sub(1)).rev() {
            let rows = self.elastic_rows[upper + 1] - self.elastic_rows[upper];
            let longest = self.taut * rows as f32 * self.spec.grid.spacing[1];
            let (above, below) = targets[upper * columns..].split_at_mut(columns);
            for (above, &below) in above.iter_mut().zip(&*below) {
                *above = below + (*above - below).clamp_length_max(longest);
            }
        }
    }
}

/// Sews a garment onto the dancer, who holds still in the pose `stance` (world from bind, by bone)
/// while it is put on over what she wears already.
///
/// # Errors
/// A draft that does not fit the body or the grid.
pub fn sew(
    cut: &Cut<'_>,
    (dancer, clothed): (&Dancer, &Clothed),
    stance: &[Affine3A],
    settings: &SewSettings,
) -> Result<SewnSkirt, SewError> {
    let Cut { draft, worn, .. } = cut;
    let mut layout = Layout::new((draft, cut.flounce), worn, settings)?;
    if cut.closing == Closing::Open {
        layout.open();
    }
    check_place(cut, dancer)?;
    let mut start = Vec::with_capacity(layout.grid.particle_count());
    let lowest = *layout.elastic_rows.last().unwrap_or(&0);
    let worn_height = worn.worn_height.to_m_f32();
    let bare = layout.band_rings(dancer, worn_height, lowest)?;
    let least_gap = bare.iter().map(|ring| ring.gap_over(clothed));
    layout.band_gap = least_gap.fold(layout.band_gap, f32::max);
    layout.crimp(worn.worn_girth.to_m_f32(), settings);
    let mut rings = layout.band_rings(dancer, worn_height, lowest)?;
    let taut = match cut.place {
        WornPlace::Hips | WornPlace::Skirt => TAUT,
        WornPlace::Bust => TAUT_OVER_BUST,
    };
    let band = dancer.skin.is_given().then(|| {
        let bone = Band::carrier(&rings);
        rings.iter_mut().for_each(|ring| ring.be_carried_by(bone));
        let elastics: Vec<&Ring> = (layout.elastic_rows.iter())
            .map(|&row| &rings[row as usize])
            .collect();
        Band::new(&elastics, bone, taut / BLOUSING)
    });
    for (row, ring) in (0..).zip(&rings) {
        ring.lay(layout.gathers(row), &Flare::none(), 0.0, &mut start);
    }
    let last = &rings[lowest as usize];
    let hanging = (layout.grid.row_count - 1 - lowest) as f32 * layout.grid.spacing[1];
    let room = [layout.band_gap, hanging];
    let flat_length = layout.flat_length;
    let flare = Flare::around(last, (dancer, clothed), stance, room, flat_length);
    for row in 1..layout.grid.row_count - lowest {
        let below = row as f32 * layout.grid.spacing[1];
        last.lay(layout.gathers(lowest + row), &flare, below, &mut start);
    }
    flounce::gather(&layout.grid, &mut start);
    let mut pinned = vec![false; layout.grid.particle_count()];
    let mut pins = Vec::new();
    for &row in &layout.elastic_rows {
        for column in 0..layout.grid.column_count {
            let index = layout.grid.index(row, column);
            pinned[index] = true;
            let particle = row * layout.grid.column_count + column;
            pins.push(SkinPin {
                particle,
                point: start[index],
            });
        }
    }
    let spec = ClothSpec {
        grid: layout.grid,
        fabric: *cut.fabric,
        row_layers: layout.row_layers,
        mass: MassLaw::AreaWeighted,
        pinned,
    };
    Ok(SewnSkirt {
        spec,
        pins,
        fold_columns: (layout.grid.column_count as usize).div_ceil(layout.fold_starts.len()),
        elastic_rows: layout.elastic_rows,
        drawn_in: match cut.place {
            WornPlace::Hips | WornPlace::Bust => 0.0,
            WornPlace::Skirt => (1.0 - STITCHED) * layout.band_gap,
        },
        taut,
        band,
        start,
    })
}

/// Refuses a garment worn around the legs, and one that reaches up too far: a skirt's band over the
/// bust, a top over the shoulders.
fn check_place(cut: &Cut<'_>, dancer: &Dancer) -> Result<(), SewError> {
    let Cut { draft, worn, .. } = cut;
    let worn_cm = worn.worn_height.to_cm();
    let least_cm = f64::from(dancer.landmarks.crotch_height) * 100.0 + LEAST_ABOVE_CROTCH_CM;
    if worn_cm < least_cm {
        return Err(SewError::WornTooLow { worn_cm, least_cm });
    }
    let lowest_cm = draft
        .elastic_rows
        .last()
        .map_or(0.0, |row| row.from_fold.to_cm());
    let top_cm = worn_cm + lowest_cm;
    let bust_cm = f64::from(dancer.landmarks.bust_height) * 100.0;
    let shoulder_cm = f64::from(dancer.skeleton.joint(Bone::LeftUpperArm).y) * 100.0;
    match cut.place {
        WornPlace::Hips if bust_cm < top_cm => Err(SewError::BandTooTall { top_cm, bust_cm }),
        WornPlace::Bust if shoulder_cm < top_cm => Err(SewError::TopTooTall {
            top_cm,
            shoulder_cm,
        }),
        WornPlace::Hips | WornPlace::Bust | WornPlace::Skirt => Ok(()),
    }
}

/// Lowest elastic above the crotch [cm], at least: below, nothing carries a skirt.
const LEAST_ABOVE_CROTCH_CM: f64 = 2.0;

/// Distance of the edge of a ruffle from the skin below it, where it is stitched onto the gathers of a
/// skirt, over how far those stand out before the skirt has hung: they are pressed together there.
const STITCHED: f32 = 0.55;

/// Elastic rows are at most this much of the cloth between them apart: weaving is never pulled
/// straight by an elastic, which slides first.
const TAUT: f32 = 0.98;

/// The same where cloth goes over the bust and the folds of the back: its way is longer than straight.
const TAUT_OVER_BUST: f32 = 0.93;

#[cfg(test)]
mod tests {
    use lole_body::Measurements;
    use lole_geom::Length;
    use lole_pattern::GatherRatio;
    use lole_pattern::design::pau_skirt::{PauOptions, draft_pau_skirt};

    use super::*;

    static DANCER: std::sync::LazyLock<Dancer> =
        std::sync::LazyLock::new(|| Dancer::new(&Measurements::woman()).unwrap());

    fn sewn(settings: &SewSettings) -> (&'static Dancer, Result<SewnSkirt, SewError>) {
        let stance = DANCER.skeleton.world_from_bind(&lole_body::Pose::default());
        (&DANCER, sewn_in(&DANCER, &stance, settings))
    }

    fn sewn_in(
        dancer: &Dancer,
        stance: &[Affine3A],
        settings: &SewSettings,
    ) -> Result<SewnSkirt, SewError> {
        sewn_with(dancer, stance, (settings, None))
    }

    fn sewn_with(
        dancer: &Dancer,
        stance: &[Affine3A],
        (settings, flounce): (&SewSettings, Option<&PauDraft>),
    ) -> Result<SewnSkirt, SewError> {
        let girth = Length::from_cm(82.0);
        sewn_as(
            (dancer, stance),
            girth,
            &PauOptions::default(),
            (settings, flounce),
        )
    }

    /// Casings and hem weigh as much where they are folded as they were cut.
    #[test]
    fn a_skirt_weighs_as_much_as_the_cloth_that_is_cut() {
        let girth = Length::from_cm(82.0);
        let options = PauOptions::default();
        let stance = DANCER.skeleton.world_from_bind(&lole_body::Pose::default());
        let settings = SewSettings::default();
        let skirt = sewn_as((&DANCER, &stance), girth, &options, (&settings, None)).unwrap();
        let worn = PauMeasurements {
            hip_girth: DANCER.measurements.hip_girth,
            worn_girth: girth,
            worn_height: Length::from_m(f64::from(DANCER.landmarks.asis_height)),
        };
        let draft = draft_pau_skirt(&worn, &options).unwrap();
        let layers = &skirt.spec.row_layers;
        // The first and the last row stand for half a row.
        let whole: f32 = layers.iter().sum();
        let rows = whole - 0.5 * (layers[0] + layers[layers.len() - 1]);
        let folded = f64::from(rows * skirt.spec.grid.spacing[1]);
        let share = folded / draft.cut_height.to_m();
        assert!((0.98..1.02).contains(&share), "{share}");
    }

    fn sewn_as(
        (dancer, stance): (&Dancer, &[Affine3A]),
        worn_girth: Length,
        options: &PauOptions,
        (settings, flounce): (&SewSettings, Option<&PauDraft>),
    ) -> Result<SewnSkirt, SewError> {
        let worn = PauMeasurements {
            hip_girth: dancer.measurements.hip_girth,
            worn_girth,
            worn_height: Length::from_m(f64::from(dancer.landmarks.asis_height)),
        };
        let draft = draft_pau_skirt(&worn, options).unwrap();
        let fabric = crate::fabrics::PRESETS[0].fabric();
        let cut = Cut {
            draft: &draft,
            worn: &worn,
            fabric: &fabric,
            place: WornPlace::Hips,
            closing: Closing::Sewn,
            flounce,
        };
        sew(&cut, (dancer, &Clothed::new(Vec3::ZERO)), stance, settings)
    }

    #[test]
    fn gathered_cloth_keeps_its_length_around_and_down() {
        let (dancer, skirt) = sewn(&SewSettings::default());
        let skirt = skirt.unwrap();
        let pose = lole_body::Pose::default();
        let start =
            skirt.start_positions(&dancer.skeleton.world_from_bind(&pose), &Lifts::default());
        let grid = &skirt.spec.grid;
        for row in 0..grid.row_count {
            let place = |column: u32| start[grid.index(row, column % grid.column_count)];
            let lengths = (0..grid.column_count)
                .map(|c| place(c).distance(place(c + 1)) / grid.row_spacing(row));
            let lengths: Vec<f32> = lengths.collect();
            let around = lengths.iter().sum::<f32>() / grid.column_count as f32;
            assert!((around - 1.0).abs() < 0.01, "row {row}: {around}");
            let longest = lengths.iter().copied().fold(0.0, f32::max);
            assert!(
                longest < 1.5,
                "row {row}: an edge is stretched to {longest}"
            );
        }
        let mut longest = 0.0_f32;
        for index in 0..start.len() - grid.column_count as usize {
            let down = start[index].distance(start[index + grid.column_count as usize]);
            longest = longest.max(down / grid.spacing[1]);
        }
        assert!(longest < 1.06, "down a column: {longest}");
    }

    #[test]
    fn a_flounce_lies_in_waves_below_cloth_that_lies_as_without_it() {
        let stance = (DANCER.skeleton).world_from_bind(&lole_body::Pose::default());
        let settings = SewSettings::default();
        let plain = sewn_in(&DANCER, &stance, &settings).unwrap();
        let worn = PauMeasurements {
            hip_girth: DANCER.measurements.hip_girth,
            worn_girth: Length::from_cm(82.0),
            worn_height: Length::from_m(f64::from(DANCER.landmarks.asis_height)),
        };
        let above = draft_pau_skirt(&worn, &PauOptions::default()).unwrap();
        let flounce = PauDraft {
            flat_length: above.flat_length * 1.5,
            finished_length: Length::from_cm(15.0),
            ..above
        };
        let skirt = sewn_with(&DANCER, &stance, (&settings, Some(&flounce))).unwrap();
        let grid = &skirt.spec.grid;
        let sewn = grid.flounce.unwrap();
        assert!((sewn.fullness - 1.5).abs() < 1e-5);
        let seam = sewn.seam_row as f32 * grid.spacing[1];
        let finished = plain.spec.grid.spacing[1] * (settings.row_count - 1) as f32;
        assert!((seam - finished).abs() < 0.6 * grid.spacing[1], "{seam}");
        let start = skirt.start_positions(&stance, &Lifts::default());
        let length = |row: u32| {
            let place = |column: u32| start[grid.index(row, column % grid.column_count)];
            let edges = (0..grid.column_count).map(|c| place(c).distance(place(c + 1)));
            edges.sum::<f32>() / (grid.column_count as f32 * grid.spacing[0])
        };
        assert!((length(sewn.seam_row) - 1.0).abs() < 0.01);
        let hem = length(grid.row_count - 1);
        assert!((1.2..1.5).contains(&hem), "{hem}");
    }

    #[test]
    fn the_drape_starts_outside_the_body_in_any_stance() {
        let dancer = &*DANCER;
        let dance =
            lole_hula::Dance::new(&dancer.skeleton, &lole_hula::MotionSettings::default()).unwrap();
        let stance = dancer.skeleton.world_from_bind(&dance.pose_at(0.0));
        let skirt = sewn_in(dancer, &stance, &SewSettings::default()).unwrap();
        let start = skirt.start_positions(&stance, &Lifts::default());
        let capsules = dancer.posed_capsules(&stance);
        let depth = lole_cloth::diagnose::worst_capsule_penetration(&skirt.spec, &start, &capsules);
        // Pins lie on the skin, and capsules stand out of it by up to 12 mm.
        assert!(depth < 0.010, "{depth} m inside");
    }

    #[test]
    fn elastics_are_never_pulled_apart_farther_than_their_cloth() {
        let (dancer, skirt) = sewn(&SewSettings::default());
        let skirt = skirt.unwrap();
        let mut pose = lole_body::Pose::default();
        pose.rotations[Bone::Spine as usize] = glam::Quat::from_rotation_z(0.3);
        let mut targets = Vec::new();
        let put_on = (1.0, &Lifts::default());
        skirt.pose_pins(
            &dancer.skeleton.world_from_bind(&pose),
            put_on,
            &mut targets,
        );
        let columns = skirt.spec.grid.column_count as usize;
        for (upper, rows) in skirt.elastic_rows.windows(2).enumerate() {
            let cloth = (rows[1] - rows[0]) as f32 * skirt.spec.grid.spacing[1];
            for column in 0..columns {
                let [above, below] = [upper, upper + 1].map(|row| targets[row * columns + column]);
                assert!(above.distance(below) < 0.981 * cloth);
            }
        }
    }

    #[test]
    fn pins_are_the_elastic_rows_and_stay_outside_the_skin() {
        let (dancer, skirt) = sewn(&SewSettings::default());
        let skirt = skirt.unwrap();
        assert_eq!(skirt.elastic_rows.len(), 3);
        assert_eq!(skirt.pins.len(), 3 * skirt.spec.grid.column_count as usize);
        let body = &dancer.skin;
        let triangles = body.body_triangles();
        let grid = lole_geom::TriangleGrid::new(&body.positions, &triangles, 0.02);
        let transforms = dancer.skeleton.world_from_bind(&lole_body::Pose::default());
        for pin in &skirt.pins {
            let place = pin.posed(&transforms);
            let nearest = grid.nearest(place, 0.08).unwrap();
            let normals = triangles[nearest.triangle as usize].map(|i| body.normals[i as usize]);
            let outward = lole_geom::triangle_grid::blend(normals, nearest.barycentric);
            assert!(
                0.0 < (place - nearest.point).dot(outward),
                "pin {}",
                pin.particle
            );
        }
    }

    #[test]
    fn a_band_stands_no_farther_off_than_sewn_puckers_do() {
        let large = lole_body::Tape {
            waist_girth: Some(Length::from_cm(98.0)),
            hip_girth: Some(Length::from_cm(118.0)),
            ..lole_body::Tape::default()
        };
        let large = Dancer::new(&Measurements::from_tape(&large).unwrap()).unwrap();
        for dancer in [&*DANCER, &large] {
            let (body, still) = (&dancer.skin, lole_body::Pose::default());
            let triangles = body.body_triangles();
            let grid = lole_geom::TriangleGrid::new(&body.positions, &triangles, 0.02);
            let stance = dancer.skeleton.world_from_bind(&still);
            for ratio in [2.0, 3.0, 4.0, 5.0] {
                let options = PauOptions {
                    gather_ratio: GatherRatio::new(ratio).unwrap(),
                    ..PauOptions::default()
                };
                let height = dancer.landmarks.asis_height;
                let girth = Ring::at(dancer, height).unwrap().girth;
                let girth = Length::from_m(f64::from(girth));
                let settings = (&SewSettings::default(), None);
                let skirt = sewn_as((dancer, &stance), girth, &options, settings).unwrap();
                let off = skirt.pins.iter().map(|pin| {
                    let place = pin.posed(&stance);
                    grid.nearest(place, 0.08).unwrap().point.distance(place)
                });
                let mut off: Vec<f32> = off.collect();
                off.sort_by(f32::total_cmp);
                // An elastic is straight over the small of the back.
                let [most, farthest] = [off[off.len() * 9 / 10], off[off.len() - 1]];
                assert!(
                    most < 0.016 && farthest < 0.025,
                    "{ratio} times: {most} and {farthest} m off the skin"
                );
            }
        }
    }

    #[test]
    fn other_seeds_push_the_gathers_otherwise() {
        let lay = |seed| {
            sewn(&SewSettings {
                seed,
                ..SewSettings::default()
            })
            .1
            .unwrap()
        };
        assert_eq!(lay(1), lay(1));
        assert_ne!(lay(1), lay(2));
    }

    #[test]
    fn too_few_rows_are_refused_in_a_sentence() {
        let (_, skirt) = sewn(&SewSettings {
            row_count: 9,
            ..SewSettings::default()
        });
        let sentence = skirt.unwrap_err().to_string();
        assert!(
            sentence.contains("9 rows") && sentence.contains("at least"),
            "{sentence}"
        );
    }
}
