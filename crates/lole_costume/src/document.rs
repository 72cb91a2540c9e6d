//! The design document (`*.lole`): a TOML text that names dancer, skirt, fabric, print, motion,
//! wind and method.
//!
//! The first key is `lole = 1`, the version of the format. Every key that has a dimension ends in
//! its unit; one that has none ends in `_ratio`, `_coefficient` or `_count`, or is a name, a color
//! or a seed. Anything may be left out: the built-in pāʻū skirt dancing kāholo fills it in.
//! What is worn with the skirt follows as a list, `[[garment]]`, each with its `kind`, and under it
//! `[garment.fabric]` and `[garment.print]`. Its kind is a template of [`lole_garment`], whose options are keys.
//! Every key, with its range and meaning, is one row of [`schema`]; reading, checking and writing
//! all walk that table.

mod convert;
mod cost;
mod error;
mod face;
mod garment;
mod nearest;
mod parse;
mod print;
pub mod schema;
mod stage;
mod template;
mod write;

use std::sync::Arc;

use lole_body::{Figure, HairStyle, Makeup, Side};
use lole_cloth::collision::penalty::{CapsuleShape, Response};
use lole_cloth::method::explicit::{ContactEvaluation, Integrator, RungeKutta};
use lole_cloth::wind::WindLaw;
use lole_hula::SCHOOLS;
use lole_hula::{
    AmiTurn, ArmManner, ArmStyle, DanceStep, Formation, Hands, HipLead, HipLift, School,
};

use crate::fabrics::Preset;
use lole_pattern::{Alterations, TailorTape};
use lole_print::{PrintLay, PrintMotif};

pub use cost::{CostDesign, Currency, NotionPrices};
pub use error::{DesignError, Problem};
pub use face::FaceDesign;
pub use garment::{GarmentDesign, LinkedPattern};
pub use lole_garment::GarmentLayer;
pub use nearest::{likely, nearest};
pub use parse::{Place, locate, parse, parse_bytes};
pub use print::{LinkedPicture, PhotoMarks, PrintError};
pub use stage::{CameraWork, Gaze, MotionBlur, StageDesign, StageMood, StageSet};
pub use write::to_toml;

/// Version of the format that this program writes, and the newest it reads.
pub const VERSION: u64 = 1;

/// A whole design, in the units of the document so that reading and writing lose nothing.
///
/// Invariant of a design that [`parse()`] returned: every value is finite and in its range. One
/// built or changed in the program is brought under it by [`Design::check`].
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Design {
    /// Who wears it.
    pub dancer: DancerDesign,
    /// How fitted garments are altered for her.
    pub alterations: Alterations,
    /// What makes her face unlike others.
    pub face: FaceDesign,
    /// The pāʻū skirt.
    pub skirt: SkirtDesign,
    /// What it is cut from.
    pub fabric: FabricDesign,
    /// What is printed on it.
    pub print: PrintChoice,
    /// What is danced.
    pub motion: MotionDesign,
    /// Moving air.
    pub wind: WindDesign,
    /// How the cloth is computed.
    pub method: MethodDesign,
    /// What is around her in pictures.
    pub stage: StageDesign,
    /// Prices.
    pub cost: CostDesign,
    /// What is worn with the skirt, in each layer from the skin outward.
    pub garments: Vec<GarmentDesign>,
}

/// The dancer's tape; what was not measured follows from the rest.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct DancerDesign {
    /// An avatar that is dressed instead; its tape is its own.
    pub file: Option<LinkedFile>,
    /// Whose proportions she has.
    pub figure: Figure,
    /// Height of the crown above the floor [cm].
    pub stature_cm: Option<f64>,
    /// Around the fullest part of the bust [cm].
    pub bust_cm: Option<f64>,
    /// Around the trunk under the bust [cm].
    pub underbust_cm: Option<f64>,
    /// Around the narrowest part of the trunk [cm].
    pub waist_cm: Option<f64>,
    /// Around the trunk over the front points of the hip bones [cm].
    pub high_hip_cm: Option<f64>,
    /// Around the fullest part of the hips [cm].
    pub hip_cm: Option<f64>,
    /// Around one thigh just below the crotch [cm].
    pub thigh_cm: Option<f64>,
    /// Around one knee at the middle of the kneecap [cm].
    pub knee_cm: Option<f64>,
    /// Around the fullest part of one calf [cm].
    pub calf_cm: Option<f64>,
    /// Around one ankle at its narrowest [cm].
    pub ankle_cm: Option<f64>,
    /// Crotch to floor [cm].
    pub inseam_cm: Option<f64>,
    /// Waist tape to floor [cm].
    pub waist_height_cm: Option<f64>,
    /// Shoulder point to shoulder point [cm].
    pub shoulder_breadth_cm: Option<f64>,
    /// Shoulder point to elbow [cm].
    pub upper_arm_length_cm: Option<f64>,
    /// What was taken for drafting, and no body is built from.
    pub tailor_tape: TailorTape,
    /// How old she looks [years]; as her measures say when `None`.
    pub age_years: Option<f64>,
    /// How the hair is worn.
    pub hair: HairStyle,
    /// How the face is made up.
    pub makeup: Makeup,
    /// Color of bare skin instead of the usual one, sRGB bytes.
    pub skin_color: Option<[u8; 3]>,
    /// Color of the hair instead of the usual one, sRGB bytes.
    pub hair_color: Option<[u8; 3]>,
    /// Color of the leotard instead of the usual one, sRGB bytes.
    pub leotard_color: Option<[u8; 3]>,
}

/// The pāʻū skirt and how finely it is computed.
#[derive(Debug, Clone, PartialEq)]
pub struct SkirtDesign {
    /// Whether it is worn; a skirt of strands or a dress may be worn instead.
    pub is_worn: bool,
    /// Height of the hem above the floor [cm].
    pub hem_height_cm: f64,
    /// Height of the lowest elastic row above the floor [cm]; the front hip bones when `None`.
    pub worn_height_cm: Option<f64>,
    /// Flat length over hip girth, 1 to 5.
    pub gather_ratio: f64,
    /// Rows of elastic, 1 to 6.
    pub elastic_row_count: u32,
    /// Relaxed elastic over the girth where it is worn, 0.8 to 0.9.
    pub elastic_ratio: f64,
    /// Ruffle above the top elastic [cm].
    pub header_cm: f64,
    /// Height of one casing [cm].
    pub casing_cm: f64,
    /// Height between two casings [cm].
    pub casing_gap_cm: f64,
    /// Cloth for the hem [cm].
    pub hem_allowance_cm: f64,
    /// Particles around.
    pub column_count: u32,
    /// Particles from top fold to hem.
    pub row_count: u32,
    /// Chance for how unevenly the gathers are pushed together.
    pub seed: u64,
}

impl Default for SkirtDesign {
    fn default() -> Self {
        Self {
            is_worn: true,
            hem_height_cm: 22.0,
            worn_height_cm: None,
            gather_ratio: 4.0,
            elastic_row_count: 3,
            elastic_ratio: 0.85,
            header_cm: 2.0,
            casing_cm: 1.5,
            casing_gap_cm: 2.5,
            hem_allowance_cm: 5.0,
            column_count: 512,
            row_count: 55,
            seed: 1,
        }
    }
}

/// A fabric from the shelf, with the figures that were measured on the real cloth instead.
#[derive(Debug, Clone, PartialEq)]
pub struct FabricDesign {
    /// What its owner calls it; the preset's name when `None`.
    pub name: Option<String>,
    /// Fabric from the shelf.
    pub preset: &'static Preset,
    /// Width of the bolt, selvage to selvage [cm].
    pub width_cm: f64,
    /// Mass per area [g/m²].
    pub areal_density_g_per_m2: Option<f64>,
    /// Thickness [mm].
    pub thickness_mm: Option<f64>,
    /// Membrane stiffness along the warp, around the skirt [N/m].
    pub stretch_warp_n_per_m: Option<f64>,
    /// Membrane stiffness along the weft, down the skirt [N/m].
    pub stretch_weft_n_per_m: Option<f64>,
    /// Shear stiffness [N/m per radian].
    pub shear_n_per_m: Option<f64>,
    /// Bending rigidity along the warp [µN·m].
    pub bend_warp_un_m: Option<f64>,
    /// Bending rigidity along the weft [µN·m].
    pub bend_weft_un_m: Option<f64>,
    /// Twist rigidity [µN·m]; follows the bending rigidities when `None`.
    pub twist_un_m: Option<f64>,
    /// Bending hysteresis `2HB` along the warp [mN·m/m]; follows the bending rigidity when `None`.
    pub bend_hysteresis_warp_mn: Option<f64>,
    /// Bending hysteresis `2HB` along the weft [mN·m/m]; follows the bending rigidity when `None`.
    pub bend_hysteresis_weft_mn: Option<f64>,
    /// Shear hysteresis `2HG` [N/m]; follows the shear stiffness when `None`.
    pub shear_hysteresis_n_per_m: Option<f64>,
    /// Friction coefficient on skin.
    pub friction_coefficient: Option<f64>,
    /// Friction coefficient of the cloth on itself; that on skin when only that is given.
    pub cloth_friction_coefficient: Option<f64>,
    /// Air drag as a rate [1/s].
    pub drag_per_s: Option<f64>,
    /// Price of a meter, in the currency of [`CostDesign`].
    pub price_per_m: Option<f64>,
    /// Price of a yard; that of a meter comes first.
    pub price_per_yd: Option<f64>,
    /// Width of what lies beside it in the garment: lining, contrast cloth, interfacing [cm]; as wide
    /// as the cloth when `None`.
    pub beside_width_cm: Option<f64>,
    /// Price of a meter of that.
    pub beside_price_per_m: Option<f64>,
}

impl Default for FabricDesign {
    fn default() -> Self {
        Self {
            name: None,
            preset: &crate::fabrics::PRESETS[0],
            width_cm: 110.0,
            areal_density_g_per_m2: None,
            thickness_mm: None,
            stretch_warp_n_per_m: None,
            stretch_weft_n_per_m: None,
            shear_n_per_m: None,
            bend_warp_un_m: None,
            bend_weft_un_m: None,
            twist_un_m: None,
            bend_hysteresis_warp_mn: None,
            bend_hysteresis_weft_mn: None,
            shear_hysteresis_n_per_m: None,
            friction_coefficient: None,
            cloth_friction_coefficient: None,
            drag_per_s: None,
            price_per_m: None,
            price_per_yd: None,
            beside_width_cm: None,
            beside_price_per_m: None,
        }
    }
}

/// A ready colorway, with the colors that should differ.
#[derive(Debug, Clone, PartialEq)]
pub struct PrintChoice {
    /// What is scattered over the ground.
    pub motif: PrintMotif,
    /// Name of a ready set of colors, one of [`COLORWAYS`](lole_print::COLORWAYS).
    pub colorway: &'static str,
    /// Color of the ground, sRGB.
    pub ground: Option<[u8; 3]>,
    /// Color of the flowers or fruit, sRGB.
    pub flower: Option<[u8; 3]>,
    /// Color of the large leaves, sRGB.
    pub leaf: Option<[u8; 3]>,
    /// Color of the quiet second layer, sRGB.
    pub shadow: Option<[u8; 3]>,
    /// Width of one repeat on the cloth, before it is turned [cm]; one that the program draws is as
    /// high.
    pub repeat_cm: f64,
    /// Chooses places and turns.
    pub seed: u64,
    /// A picture that is printed instead of the motif.
    pub file: Option<LinkedPicture>,
    /// What is known of that picture.
    pub marks: PhotoMarks,
    /// How the print lies on the cloth.
    pub lay: PrintLay,
}

impl Default for PrintChoice {
    fn default() -> Self {
        Self {
            motif: PrintMotif::Hibiscus,
            colorway: "red",
            ground: None,
            flower: None,
            leaf: None,
            shadow: None,
            repeat_cm: 42.0,
            seed: 1,
            file: None,
            marks: PhotoMarks::default(),
            lay: PrintLay::default(),
        }
    }
}

/// A recording or an avatar that a document names. Whoever opens the document reads the file: the bytes are not
/// part of the text.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct LinkedFile {
    /// Its place from the document.
    pub name: String,
    /// What it holds; `None` until it is read.
    pub bytes: Option<Arc<[u8]>>,
}

impl LinkedFile {
    /// A file that is not read yet.
    #[must_use]
    pub fn named(name: &str) -> Self {
        Self {
            name: name.to_owned(),
            bytes: None,
        }
    }
}

/// What follows the end of a recording.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum MotionRepeat {
    /// She stands in its last pose.
    #[default]
    Once,
    /// The part that comes back best to where it began, over and over.
    Loop,
}

/// What becomes of the way that is gone in a recording.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum MotionDrift {
    /// She goes it.
    #[default]
    Keep,
    /// The straight line from the first place to the last is taken away.
    Remove,
}

/// What is danced, and in whose manner.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionDesign {
    /// The manner that sets what the document leaves out.
    pub school: &'static School,
    /// The step, where there are no parts.
    pub step: DanceStep,
    /// Counts per minute.
    pub tempo_bpm: f64,
    /// How long is danced [s]; as long as the parts, or 12 s without parts, when `None`.
    pub duration_s: Option<f64>,
    /// Factor on the sway of the hips.
    pub sway_ratio: f64,
    /// Bend of both knees while standing even [°].
    pub knee_deg: f64,
    /// Height of the free foot's heel over the stature.
    pub heel_ratio: f64,
    /// A step to the side over the stature.
    pub step_ratio: f64,
    /// Distance of the ankles while standing over the stature.
    pub stance_ratio: f64,
    /// Turn-out of each foot [°].
    pub toe_out_deg: f64,
    /// Depth of the hips' figure of eight over the stature.
    pub eight_ratio: f64,
    /// Which side of the pelvis is higher while it sways.
    pub hip_lift: HipLift,
    /// Where the hips are on the count.
    pub hip_lead: HipLead,
    /// What the arms do.
    pub arms: ArmStyle,
    /// How the arms move.
    pub arm_manner: ArmManner,
    /// What the hands are like.
    pub hands: Hands,
    /// Direction of the ʻami circle, where there are no parts.
    pub ami_turn: AmiTurn,
    /// A recording that is danced instead of the step.
    pub file: Option<LinkedFile>,
    /// Which animation of that file: a name, or a number, counted from 1; the first where it is empty.
    pub clip: String,
    /// What follows the recording's end.
    pub repeat: MotionRepeat,
    /// What becomes of its way.
    pub drift: MotionDrift,
    /// A choreography: danced once, part after part, instead of the step.
    pub parts: Vec<PartDesign>,
}

/// One part of a choreography.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PartDesign {
    /// The step.
    pub step: DanceStep,
    /// Which side begins.
    pub side: Side,
    /// Counts: whole phrases of the step.
    pub beat_count: u32,
    /// Where the dancer faces, to her left of the front [°].
    pub facing_deg: f64,
    /// What the arms do; as in the rest of the dance when `None`.
    pub arms: Option<ArmStyle>,
    /// Counts per minute from here on; as before when `None`.
    pub tempo_bpm: Option<f64>,
    /// How a group stands at its end, which walks there in this part; as before when `None`. One dancer stays.
    pub formation: Option<Formation>,
    /// What the lamps of a theater say from here on; as before when `None`.
    pub mood: Option<StageMood>,
}

impl Default for PartDesign {
    fn default() -> Self {
        Self {
            step: DanceStep::Kaholo,
            side: Side::Right,
            beat_count: 8,
            facing_deg: 0.0,
            arms: None,
            tempo_bpm: None,
            formation: None,
            mood: None,
        }
    }
}

impl Default for MotionDesign {
    fn default() -> Self {
        let mut motion = Self {
            school: &SCHOOLS[0],
            step: DanceStep::Kaholo,
            tempo_bpm: 80.0,
            duration_s: None,
            sway_ratio: 1.0,
            knee_deg: 0.0,
            heel_ratio: 0.0,
            step_ratio: 0.0,
            stance_ratio: 0.0,
            toe_out_deg: 0.0,
            eight_ratio: 0.0,
            hip_lift: HipLift::default(),
            hip_lead: HipLead::default(),
            arms: ArmStyle::default(),
            arm_manner: ArmManner::default(),
            hands: Hands::default(),
            ami_turn: AmiTurn::default(),
            parts: Vec::new(),
            file: None,
            clip: String::new(),
            repeat: MotionRepeat::default(),
            drift: MotionDrift::default(),
        };
        motion.follow(&SCHOOLS[0]);
        motion
    }
}

/// Moving air: the paper's turning wind, given by its strongest breath, or a steady one.
#[derive(Debug, Clone, PartialEq)]
pub struct WindDesign {
    /// Air speed at the strongest [m/s]; 0 is still air.
    pub speed_m_per_s: f64,
    /// How the wind's equation is read, or that it blows steadily.
    pub law: WindLaw,
    /// [`WindLaw::Steady`]: where it comes from [°], 0 from the dancer's front, 90 from her left, -90
    /// from her right.
    pub from_deg: f64,
    /// What the air acts on, under the real-time method.
    pub model: WindModel,
    /// [`WindModel::Triangles`]: root mean square of the gusts in each direction over
    /// `speed_m_per_s`.
    pub gust_ratio: f64,
    /// What the gusts follow from.
    pub seed: u64,
}

impl Default for WindDesign {
    /// Still air, and from the side where it is wished to blow: in front a skirt only lies on the legs.
    fn default() -> Self {
        Self {
            speed_m_per_s: 0.0,
            law: WindLaw::default(),
            from_deg: 90.0,
            model: WindModel::default(),
            gust_ratio: 0.0,
            seed: 0,
        }
    }
}

/// What moving air acts on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum WindModel {
    /// Every particle alike, as in the paper.
    #[default]
    Uniform,
    /// Triangles by their area and direction, so that cloth billows and flutters.
    Triangles,
}

/// How the cloth is computed.
#[derive(Debug, Clone, PartialEq)]
pub struct MethodDesign {
    /// The method.
    pub name: MethodName,
    /// Time slices of one picture; the method's own choice when `None`.
    pub substep_count: Option<u32>,
    /// What the cloth meets as a body.
    pub body: BodyShapes,
    /// Capsules where capsules are met.
    pub capsule_count: u32,
    /// When cloth of `xpbd` is kept from passing through itself.
    pub uncrossed: Uncrossed,
    /// The paper's methods: when contact is worked out.
    pub contact_evaluation: ContactEvaluation,
    /// The paper's methods: whether skin may pull.
    pub penalty: Response,
    /// The paper's methods: speed with which cloth leaves the skin over that with which it came;
    /// critically damped when `None`.
    pub bounce_ratio: Option<f64>,
    /// The paper's methods: whether capsules end.
    pub capsule_shape: CapsuleShape,
}

impl Default for MethodDesign {
    fn default() -> Self {
        Self {
            name: MethodName::default(),
            substep_count: None,
            body: BodyShapes::default(),
            capsule_count: PAPER_CAPSULES,
            uncrossed: Uncrossed::default(),
            contact_evaluation: ContactEvaluation::default(),
            penalty: Response::default(),
            bounce_ratio: None,
            capsule_shape: CapsuleShape::default(),
        }
    }
}

/// Capsules of the paper's body.
const PAPER_CAPSULES: u32 = 13;

/// What stands for the body where cloth meets it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum BodyShapes {
    /// The skin itself, as it is drawn; the paper's methods, which know none, meet capsules.
    #[default]
    Skin,
    /// Capsules fitted to the skin.
    Capsules,
    /// One upright cylinder for each leg, the paper's earlier body.
    TwoCylinders,
}

impl BodyShapes {
    /// Name in documents.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Skin => "skin",
            Self::Capsules => "capsules",
            Self::TwoCylinders => "two-cylinders",
        }
    }
}

/// When cloth is kept from passing through itself, which costs about a third of a frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Uncrossed {
    /// In every frame.
    #[default]
    Always,
    /// In films, and in the window as long as the machine keeps pace.
    InTime,
    /// Never: folds may pass through each other.
    Never,
}

impl Uncrossed {
    /// Every one.
    pub const ALL: [Self; 3] = [Self::Always, Self::InTime, Self::Never];

    /// Name in documents.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Always => "always",
            Self::InTime => "in-time",
            Self::Never => "never",
        }
    }
}

/// A method of computing cloth.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum MethodName {
    /// Small steps of position-based dynamics: real time.
    #[default]
    Xpbd,
    /// The paper's forward-backward Euler in double precision: the reference, slow.
    FbEuler,
    /// The paper's explicit Euler: flies apart unless its steps are tiny.
    Euler,
    /// The classical Runge-Kutta method of fourth order.
    Rk4,
    /// The paper's Runge-Kutta method to the letter.
    RkAsPrinted,
    /// The same, with gravity and resistance counted twice as the print can be read.
    RkDoubleCounted,
}

impl MethodName {
    /// All methods, the default first.
    pub const ALL: [Self; 6] = [
        Self::Xpbd,
        Self::FbEuler,
        Self::Euler,
        Self::Rk4,
        Self::RkAsPrinted,
        Self::RkDoubleCounted,
    ];

    /// Name in documents and on the command line.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Xpbd => "xpbd",
            Self::FbEuler => "fb-euler",
            Self::Euler => "euler",
            Self::Rk4 => "rk4",
            Self::RkAsPrinted => "rk-as-printed",
            Self::RkDoubleCounted => "rk-double-counted",
        }
    }

    /// The method whose [`id`](Self::id) is `id`.
    #[must_use]
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|method| method.id() == id)
    }

    /// The integrator of the paper's methods; `None` for `xpbd`.
    #[must_use]
    pub const fn integrator(self) -> Option<Integrator> {
        Some(match self {
            Self::Xpbd => return None,
            Self::FbEuler => Integrator::FbEuler,
            Self::Euler => Integrator::Euler,
            Self::Rk4 => Integrator::RungeKutta(RungeKutta::CLASSICAL),
            Self::RkAsPrinted => Integrator::RungeKutta(RungeKutta::AS_PRINTED),
            Self::RkDoubleCounted => Integrator::RungeKutta(RungeKutta::DOUBLE_COUNTED),
        })
    }
}
