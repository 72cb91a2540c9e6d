//! From the document's units to what the other crates work with.

use lole_body::appearance::hair_srgb_at;
use lole_body::{Appearance, CapsuleLayout, Measure, Measurements, Tape};
use lole_cloth::wind::Wind;
use lole_cloth::{Crossings, Fabric};
use lole_garment::given;
use lole_geom::Length;
use lole_geom::narrow;
use lole_hula::{DanceStep, MotionSettings, Part, School};
use lole_language::{Bilingual, Sentence, repeated};
use lole_pattern::Tailored;

use super::{
    BodyShapes, DancerDesign, Design, DesignError, FabricDesign, GarmentDesign, GarmentLayer,
    MotionDesign, PartDesign, PrintChoice, Problem, Uncrossed, WindDesign, schema, template,
};
use crate::fabrics::{FabricFigures, si_fabric};

/// Density of air at 20 °C and sea level [kg/m³].
const AIR_DENSITY: f64 = 1.204;

impl DancerDesign {
    /// What is written of a measure [cm], to change it; `None` where it is estimated.
    pub const fn measure_mut(&mut self, measure: Measure) -> &mut Option<f64> {
        match measure {
            Measure::Stature => &mut self.stature_cm,
            Measure::Bust => &mut self.bust_cm,
            Measure::Underbust => &mut self.underbust_cm,
            Measure::Waist => &mut self.waist_cm,
            Measure::HighHip => &mut self.high_hip_cm,
            Measure::Hip => &mut self.hip_cm,
            Measure::Thigh => &mut self.thigh_cm,
            Measure::Knee => &mut self.knee_cm,
            Measure::Calf => &mut self.calf_cm,
            Measure::Ankle => &mut self.ankle_cm,
            Measure::Inseam => &mut self.inseam_cm,
            Measure::WaistHeight => &mut self.waist_height_cm,
            Measure::ShoulderBreadth => &mut self.shoulder_breadth_cm,
            Measure::UpperArmLength => &mut self.upper_arm_length_cm,
        }
    }
}

impl Design {
    /// Checks every value against its row of the schema, and the tape as a whole.
    ///
    /// `source` is named in the sentence, such as `command line`.
    ///
    /// # Errors
    /// The first value out of range.
    pub fn check(&self, source: &str) -> Result<(), DesignError> {
        for table in schema::TABLES {
            for key in table.keys {
                key.kind.check(self).map_err(|problem| DesignError {
                    file_name: source.to_owned(),
                    line: None,
                    place: format!("[{}] {}", table.name, key.name),
                    problem: Box::new(problem),
                })?;
            }
        }
        for garment in &self.garments {
            check_garment(garment, source)?;
        }
        for (number, part) in (1..).zip(&self.motion.parts) {
            for key in schema::PART_KEYS {
                key.kind.check(part).map_err(|problem| DesignError {
                    file_name: source.to_owned(),
                    line: None,
                    place: part_place(number, key.name),
                    problem: Box::new(problem),
                })?;
            }
        }
        self.check_together()
            .map_err(|(table, problem)| DesignError {
                file_name: source.to_owned(),
                line: None,
                place: format!("[{table}]"),
                problem,
            })
    }

    /// What only several values together can get wrong, with the table to look at.
    pub(super) fn check_together(&self) -> Result<(), (&'static str, Box<Problem>)> {
        Measurements::from_tape(&self.tape()).map_err(|error| ("dancer", together(&error)))?;
        self.check_avatar().map_err(|problem| ("dancer", problem))?;
        (self.motion_settings().check()).map_err(|error| ("motion", together(&error)))?;
        let mut parts = (1..).zip(&self.motion.parts);
        if let Some(sentence) = parts.find_map(|(number, part)| part.cannot_walk(number)) {
            return Err(("motion", Box::new(Problem::Together { sentence })));
        }
        self.check_prints()?;
        self.check_files()
            .map_err(|problem| (schema::LIST, problem))?;
        let danced = self.garments.iter().filter(|garment| garment.is_danced());
        let danced_count = danced.count();
        if MOST_LISTED < self.garments.len() {
            let sentence = Sentence::new(
                format!("服と小物は {MOST_LISTED} 点まで並べられます。減らしてください"),
                format!(
                    "at most {MOST_LISTED} garments and accessories are listed; leave some out"
                ),
            );
            return Err((schema::LIST, Box::new(Problem::Together { sentence })));
        }
        if MOST_GARMENTS < danced_count {
            let sentence = Sentence::new(
                format!("服は {MOST_GARMENTS} 枚まで重ねられます。減らしてください"),
                format!("at most {MOST_GARMENTS} garments are worn with the skirt; leave some out"),
            );
            return Err((schema::LIST, Box::new(Problem::Together { sentence })));
        }
        if 0 < danced_count && self.method.name.integrator().is_some() {
            let sentence = Sentence::new(
                "論文の方法は服 1 枚だけを動かします。name = \"xpbd\" にするか、[[garment]] を消してください"
                    .to_owned(),
                "the paper's methods move one garment alone; write name = \"xpbd\", or leave out [[garment]]"
                    .to_owned(),
            );
            return Err(("method", Box::new(Problem::Together { sentence })));
        }
        Ok(())
    }

    /// A file is named where a garment is cut after one, and nowhere else.
    fn check_files(&self) -> Result<(), Box<Problem>> {
        let id = given::TEMPLATE.id;
        for garment in &self.garments {
            let sentence = match (garment.kind_id() == id, &garment.file) {
                (true, Some(_)) | (false, None) => continue,
                (true, None) => Sentence::new(
                    format!(
                        "kind = \"{id}\" には、型紙のファイルの名前が要ります。file = \"…\" を書いてください"
                    ),
                    format!(
                        "kind = \"{id}\" needs the name of a pattern's file; write file = \"…\""
                    ),
                ),
                (false, Some(file)) => Sentence::new(
                    format!(
                        "file = \"{}\" は kind = \"{id}\" の服だけのものです。どちらかを直してください",
                        repeated(&file.name)
                    ),
                    format!(
                        "file = \"{}\" is for a garment of kind = \"{id}\" alone; change one of them",
                        repeated(&file.name)
                    ),
                ),
            };
            return Err(Box::new(Problem::Together { sentence }));
        }
        Ok(())
    }

    /// An avatar has its own tape.
    fn check_avatar(&self) -> Result<(), Box<Problem>> {
        let tape = self.tape();
        let taken = self.dancer.tailor_tape;
        let measured = (Measure::ALL.into_iter())
            .filter(|measure| measure.of(&tape).is_some())
            .map(Measure::key);
        let tailored = (Tailored::ALL.into_iter())
            .filter(|tailored| taken.cm(*tailored).is_some())
            .map(Tailored::key);
        let first = measured.chain(tailored).next();
        let (Some(file), Some(key)) = (&self.dancer.file, first) else {
            return Ok(());
        };
        let name = &file.name;
        let sentence = Sentence::new(
            format!("アバター {name} は自分の寸法で着ます。{key} か file を消してください"),
            format!("the avatar {name} is dressed to its own tape; leave out {key} or file"),
        );
        Err(Box::new(Problem::Together { sentence }))
    }

    /// What the cloth meets as a body: capsules where the method knows no skin.
    #[must_use]
    pub const fn contact_body(&self) -> BodyShapes {
        match self.method.body {
            BodyShapes::Skin if self.method.name.integrator().is_some() => BodyShapes::Capsules,
            body => body,
        }
    }

    /// What is done about cloth that has gone through itself where nobody is in a hurry.
    #[must_use]
    pub const fn crossings(&self) -> Crossings {
        match self.method.uncrossed {
            Uncrossed::Always | Uncrossed::InTime => Crossings::Repair,
            Uncrossed::Never => Crossings::Leave,
        }
    }

    /// The capsules that the cloth meets where it meets capsules.
    #[must_use]
    pub const fn capsule_layout(&self) -> CapsuleLayout {
        match self.method.body {
            BodyShapes::Skin | BodyShapes::Capsules => {
                CapsuleLayout::Fitted(self.method.capsule_count)
            }
            BodyShapes::TwoCylinders => CapsuleLayout::TwoCylinders,
        }
    }

    /// The dancer's face, hair and colors.
    #[must_use]
    pub fn appearance(&self) -> Appearance {
        let (dancer, usual) = (&self.dancer, Appearance::default());
        #[expect(clippy::cast_possible_truncation, reason = "years below 100")]
        let age_years = dancer.age_years.map(|age| age as f32);
        let natural = age_years.map_or(usual.hair_srgb, |age| hair_srgb_at(age, usual.hair_srgb));
        Appearance {
            face: self.face.face(),
            age_years,
            hair: dancer.hair,
            makeup: dancer.makeup,
            skin_srgb: dancer.skin_color.unwrap_or(usual.skin_srgb),
            hair_srgb: dancer.hair_color.unwrap_or(natural),
            leotard_srgb: dancer.leotard_color.unwrap_or(usual.leotard_srgb),
        }
    }

    /// What was measured of the dancer.
    #[must_use]
    pub fn tape(&self) -> Tape {
        let dancer = &self.dancer;
        let cm = |value: Option<f64>| value.map(Length::from_cm);
        Tape {
            figure: dancer.figure,
            stature: cm(dancer.stature_cm),
            bust_girth: cm(dancer.bust_cm),
            underbust_girth: cm(dancer.underbust_cm),
            waist_girth: cm(dancer.waist_cm),
            high_hip_girth: cm(dancer.high_hip_cm),
            hip_girth: cm(dancer.hip_cm),
            thigh_girth: cm(dancer.thigh_cm),
            knee_girth: cm(dancer.knee_cm),
            calf_girth: cm(dancer.calf_cm),
            ankle_girth: cm(dancer.ankle_cm),
            inseam_length: cm(dancer.inseam_cm),
            waist_height: cm(dancer.waist_height_cm),
            shoulder_breadth: cm(dancer.shoulder_breadth_cm),
            upper_arm_length: cm(dancer.upper_arm_length_cm),
        }
    }

    /// What is danced in one layer, from the skin outward, each with its place in the list.
    pub fn garments_in(
        &self,
        layer: GarmentLayer,
    ) -> impl Iterator<Item = (usize, &GarmentDesign)> {
        let listed = self.garments.iter().enumerate();
        listed.filter(move |(_, garment)| garment.is_danced() && garment.layer == layer)
    }

    /// Everything that is listed for a layer, danced or only drafted, with its place in the list, from
    /// the skin outward.
    pub fn listed_in(&self, layer: GarmentLayer) -> impl Iterator<Item = (usize, &GarmentDesign)> {
        let listed = self.garments.iter().enumerate();
        listed.filter(move |(_, garment)| garment.layer == layer)
    }

    /// Everything that is cut, from the skin outward, by its place in the list; the skirt has none.
    pub fn cut(&self) -> impl Iterator<Item = Option<usize>> {
        let layer = |layer| self.listed_in(layer).map(|(place, _)| Some(place));
        layer(GarmentLayer::Under)
            .chain(self.skirt.is_worn.then_some(None))
            .chain(layer(GarmentLayer::Over))
    }

    /// The fabrics of everything that is danced, from the skin outward.
    #[must_use]
    pub fn worn_fabrics(&self) -> Vec<Fabric> {
        self.worn(&self.fabric, |garment| &garment.fabric)
            .map(FabricDesign::fabric)
            .collect()
    }

    /// Fabric and print of what stands at a place of the list; of the skirt where that is none, or there is
    /// nothing.
    #[must_use]
    pub fn cloth_of(&self, listed: Option<usize>) -> (&FabricDesign, &PrintChoice) {
        let garment = listed.and_then(|place| self.garments.get(place));
        garment.map_or((&self.fabric, &self.print), |it| (&it.fabric, &it.print))
    }

    /// What is printed on the skirt, and on everything that is listed.
    pub fn prints(&self) -> impl Iterator<Item = &PrintChoice> {
        let listed = self.garments.iter().map(|garment| &garment.print);
        [&self.print].into_iter().chain(listed)
    }

    /// Names of the files that it links, from where the document is.
    pub fn linked_names(&self) -> impl Iterator<Item = &str> {
        let files = [&self.dancer.file, &self.motion.file].into_iter().flatten();
        let files = files.map(|file| &file.name);
        let prints = self.prints().filter_map(|print| print.file.as_ref());
        let prints = prints.map(|file| &file.name);
        let patterns = (self.garments.iter()).filter_map(|garment| garment.file.as_ref());
        let patterns = patterns.map(|file| &file.name);
        files.chain(prints).chain(patterns).map(String::as_str)
    }

    /// A part of every gathered rectangle that is worn, from the skin outward: `skirt` of the skirt.
    pub(super) fn worn<'a, P>(
        &'a self,
        skirt: &'a P,
        part: impl Fn(&'a GarmentDesign) -> &'a P + Copy,
    ) -> impl Iterator<Item = &'a P> {
        let layer = move |layer| {
            self.garments_in(layer).flat_map(move |(_, garment)| {
                std::iter::repeat_n(part(garment), garment.gathered_count())
            })
        };
        layer(GarmentLayer::Under)
            .chain(self.skirt.is_worn.then_some(skirt))
            .chain(layer(GarmentLayer::Over))
    }

    /// What is danced, for [`lole_hula::Dance`].
    #[must_use]
    pub fn motion_settings(&self) -> MotionSettings {
        let motion = &self.motion;
        MotionSettings {
            dance_step: motion.step,
            beats_per_minute: narrow(motion.tempo_bpm),
            sway: narrow(motion.sway_ratio),
            knee_degrees: narrow(motion.knee_deg),
            hip_lift: motion.hip_lift,
            hip_lead: motion.hip_lead,
            heel_lift: narrow(motion.heel_ratio),
            step_width: narrow(motion.step_ratio),
            stance_width: narrow(motion.stance_ratio),
            toe_out_degrees: narrow(motion.toe_out_deg),
            arms: motion.arms,
            arm_manner: motion.arm_manner,
            hands: motion.hands,
            chest_room_degrees: self.chest_room_deg(),
            ami_turn: motion.ami_turn,
            figure_eight: narrow(motion.eight_ratio),
            parts: motion.parts.iter().map(PartDesign::part).collect(),
        }
    }

    /// Opening of an elbow whose hand would press what lies on the chest, or go through it [°].
    fn chest_room_deg(&self) -> f32 {
        let rooms = self.garments.iter();
        let rooms = rooms.map(|garment| garment.template.chest_room_deg);
        rooms.fold(0.0, f32::max)
    }

    /// How long is danced what ends after `whole` [s], or is repeated for ever [s].
    #[must_use]
    pub fn duration_s(&self, whole: Option<f64>) -> f64 {
        let whole = || whole.map(|seconds| seconds.min(LONGEST_S));
        (self.motion.duration_s.or_else(whole)).unwrap_or(REPEATED_S)
    }
}

/// How long a step is repeated where the design does not say [s].
const REPEATED_S: f64 = 12.0;
/// The longest dance [s].
const LONGEST_S: f64 = 600.0;

/// Where a key of a part stands.
pub(super) fn part_place(number: usize, key: &str) -> String {
    let place = format!("[[motion.{}]] {number} {key}", schema::MOTION_PARTS);
    place.trim_end().to_owned()
}

impl PartDesign {
    fn part(&self) -> Part {
        Part {
            step: self.step,
            side: self.side,
            counts: self.beat_count,
            facing_degrees: narrow(self.facing_deg),
            arms: self.arms,
            beats_per_minute: self.tempo_bpm.map(narrow),
            travel: [0.0; 2],
        }
    }

    /// What is wrong where a group is to walk in a step that stays.
    pub(super) fn cannot_walk(&self, number: usize) -> Option<Sentence> {
        if self.formation.is_none() || self.step.walks() {
            return None;
        }
        let walking = DanceStep::ALL.into_iter().filter(|step| step.walks());
        let (step, walking) = (
            self.step.id(),
            walking.map(DanceStep::id).collect::<Vec<_>>(),
        );
        let walking = walking.join(", ");
        Some(Sentence::new(
            format!(
                "{number} 番目の部分は {step} で、その場から動きません。formation は歩くステップの部分に書いてください（{walking}）"
            ),
            format!(
                "part {number} dances {step}, in which nobody gets anywhere; write formation in a part whose step walks ({walking})"
            ),
        ))
    }
}

impl MotionDesign {
    /// Dances in the manner of `school`; what is danced stays as it is.
    pub fn follow(&mut self, school: &'static School) {
        self.school = school;
        self.sway_ratio = decimal(school.sway);
        self.knee_deg = decimal(school.knee_degrees);
        self.heel_ratio = decimal(school.heel_lift);
        self.step_ratio = decimal(school.step_width);
        self.stance_ratio = decimal(school.stance_width);
        self.toe_out_deg = decimal(school.toe_out_degrees);
        self.eight_ratio = decimal(school.figure_eight);
        self.hip_lift = school.hip_lift;
        self.hip_lead = school.hip_lead;
        self.arm_manner = school.arm_manner;
        self.hands = school.hands;
    }
}

/// The number that people would write: 0.18, not 0.18000000715.
fn decimal(value: f32) -> f64 {
    value.to_string().parse().unwrap_or(f64::from(value))
}

/// Garments that are danced with the skirt, at most.
const MOST_GARMENTS: usize = 4;
/// Garments and accessories that are listed, at most.
const MOST_LISTED: usize = 24;

/// Checks what a garment holds against its rows of the schema.
/// Every value of a garment against its row, and the options of its template.
fn check_garment(garment: &GarmentDesign, source: &str) -> Result<(), DesignError> {
    let refuse = |place: String, problem| DesignError {
        file_name: source.to_owned(),
        line: None,
        place,
        problem: Box::new(problem),
    };
    for table in schema::GARMENT {
        for key in table.keys {
            let place = || {
                if table.name == schema::LIST {
                    format!("[[{}]] {}", schema::LIST, key.name)
                } else {
                    format!("[{}.{}] {}", schema::LIST, table.name, key.name)
                }
            };
            (key.kind.check(garment)).map_err(|problem| refuse(place(), problem))?;
        }
    }
    for key in schema::FINENESS {
        let place = || format!("[[{}]] {}", schema::LIST, key.name);
        (key.kind.check(garment)).map_err(|problem| refuse(place(), problem))?;
    }
    template::check(garment, source)
}

fn together(error: &impl Bilingual) -> Box<Problem> {
    Box::new(Problem::Together {
        sentence: Sentence::of(error),
    })
}

impl FabricDesign {
    /// The fabric in the engine's SI units, warp along `u`: the preset where nothing else is given.
    ///
    /// A twist that is not given keeps the preset's share of `√(B_warp B_weft)`, hysteresis its
    /// share of the stiffness; a drag that is not given stays the same force on heavier or lighter
    /// cloth. Friction that is given on skin alone is also that on cloth, as it was in documents
    /// that knew only one.
    #[must_use]
    pub fn fabric(&self) -> Fabric {
        si_fabric(&self.figures())
    }

    /// The same in the units of a textile laboratory.
    #[must_use]
    pub fn figures(&self) -> FabricFigures {
        let preset = self.preset;
        let [stretch_warp, stretch_weft] = preset.stretch.value;
        let [bend_warp, bend_weft] = preset.bend.value;
        let bend = [
            self.bend_warp_un_m.unwrap_or(bend_warp),
            self.bend_weft_un_m.unwrap_or(bend_weft),
        ];
        let twist_share = preset.twist.value / (bend_warp * bend_weft).sqrt();
        let areal_density = self
            .areal_density_g_per_m2
            .unwrap_or(preset.areal_density.value);
        let shear = self.shear_n_per_m.unwrap_or(preset.shear.value);
        let drag_rate = preset.drag_rate() * preset.areal_density.value / areal_density;
        FabricFigures {
            areal_density,
            thickness: self.thickness_mm.unwrap_or(preset.thickness.value),
            stretch: [
                self.stretch_warp_n_per_m.unwrap_or(stretch_warp),
                self.stretch_weft_n_per_m.unwrap_or(stretch_weft),
            ],
            shear,
            bend,
            twist: self
                .twist_un_m
                .unwrap_or(twist_share * (bend[0] * bend[1]).sqrt()),
            bend_hysteresis: [
                self.bend_hysteresis_warp_mn
                    .unwrap_or(preset.bend_hysteresis.value[0] * bend[0] / bend_warp),
                self.bend_hysteresis_weft_mn
                    .unwrap_or(preset.bend_hysteresis.value[1] * bend[1] / bend_weft),
            ],
            shear_hysteresis: self
                .shear_hysteresis_n_per_m
                .unwrap_or(preset.shear_hysteresis.value * shear / preset.shear.value),
            friction: self.friction_coefficient.unwrap_or(preset.friction.value),
            cloth_friction: self
                .cloth_friction_coefficient
                .or(self.friction_coefficient)
                .unwrap_or(preset.cloth_friction.value),
            drag_rate: self.drag_per_s.unwrap_or(drag_rate),
        }
    }
}

impl WindDesign {
    /// Dynamic pressure `½ ρ v²` of the strongest breath [Pa]; the amplitude of the paper's wind
    /// is this on the area of one particle, so a finer grid feels the same wind.
    #[must_use]
    pub fn pressure(&self) -> f64 {
        0.5 * AIR_DENSITY * self.speed_m_per_s * self.speed_m_per_s
    }

    /// The air's velocity [m/s] as the law has its force.
    #[must_use]
    pub fn velocity(&self) -> Wind {
        Wind {
            amplitude: self.speed_m_per_s,
            law: self.law,
            heading: self.heading(),
        }
    }

    /// Where a steady wind blows to [rad], as [`Wind::heading`].
    #[must_use]
    pub fn heading(&self) -> f64 {
        (self.from_deg + 180.0).to_radians()
    }
}
