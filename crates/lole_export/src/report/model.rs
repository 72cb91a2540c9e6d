//! The numbers of one run. Field names are the keys of `report.json` and change with its version.

use serde::Serialize;

/// Median and 99th percentile.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct MedianPercentile {
    /// Half of all values are smaller.
    pub median: f64,
    /// 99 of 100 values are smaller.
    pub p99: f64,
}

/// Mean, 99th percentile and largest value.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct MeanPercentileMax {
    /// Arithmetic mean.
    pub mean: f64,
    /// 99 of 100 values are smaller.
    pub p99: f64,
    /// Largest value.
    pub max: f64,
}

/// Smallest value, mean and largest value.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct MinMeanMax {
    /// Smallest value.
    pub min: f64,
    /// Arithmetic mean.
    pub mean: f64,
    /// Largest value.
    pub max: f64,
}

/// The worst value over a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct Worst<T> {
    /// The worst value.
    pub worst: T,
}

/// When, where and how a run left the finite numbers.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct ReportDivergence {
    /// Time into the dance [s].
    pub time_s: f64,
    /// Index of the first particle that was not finite.
    pub particle: usize,
    /// One sentence: what happened and what to change.
    pub sentence: String,
    /// What happened and what to change, in Japanese.
    pub sentence_ja: String,
}

/// One file of the run.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
pub struct ReportFile {
    /// File name beside the report.
    pub name: String,
    /// Size [byte].
    pub bytes: u64,
    /// One English sentence: what it is and how to open it.
    pub what: String,
}

/// A sentence for the reader, in both languages.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
pub struct Remark {
    /// English
    pub sentence: String,
    /// 日本語
    pub sentence_ja: String,
}

/// What the elastics of a skirt have to hold and what they do hold.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ElasticHoldFacts {
    /// Strongest pull of the skirt downwards in the dance, its weight included [N].
    pub pull_n: f64,
    /// What friction under the elastics holds [N].
    pub held_n: f64,
    /// How far the skirt slides down in the dance, as a band held by friction alone [cm]; as far as hips are high
    /// where it comes off.
    pub slid_cm: f64,
    /// Longest elastics, as they are cut, that hold half as much again as the dance pulls [cm]; `None` where
    /// none do.
    pub loosest_cut_cm: Option<f64>,
}

/// What a tailor wants to know of the skirt.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct SkirtFacts {
    /// Whether it is worn; without it, only the name and the warnings below say anything.
    pub is_worn: bool,
    /// Name of the design as its maker wrote it.
    pub design_name: String,
    /// Cloth to buy, along the bolt [m].
    pub cloth_needed_m: f64,
    /// Cloth to buy, along the bolt [yd].
    pub cloth_needed_yd: f64,
    /// Width of the bolt [cm].
    pub cloth_width_cm: f64,
    /// Flat width of the skirt over the hip girth.
    pub gather_ratio: f64,
    /// Flat width of the sewn ring of cloth [cm].
    pub flat_width_cm: f64,
    /// From the top of the header ruffle to the hem [cm].
    pub finished_length_cm: f64,
    /// Height of the hem above the floor that was asked for [cm].
    pub hem_height_cm: f64,
    /// Length of elastic to cut for each row, from the top [cm].
    pub elastic_lengths_cm: Vec<f64>,
    /// Whether the elastics hold it in this dance; `None` where it was not watched.
    pub elastic_hold: Option<ElasticHoldFacts>,
    /// Girth of the hip the skirt was drafted for [cm].
    pub hip_girth_cm: f64,
    /// What is unusual about the draft and what to do about it.
    pub warnings: Vec<Remark>,
}

/// One piece of a garment that lies outside over another.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
pub struct ReportPieceOver {
    /// The piece outside, as the paper calls it.
    pub outer: String,
    /// Its Japanese name.
    pub outer_ja: String,
    /// The piece that it lies over.
    pub inner: String,
    /// Its Japanese name.
    pub inner_ja: String,
    /// Whether both are one piece of cloth: a turn or a tuck of it. Two pieces of one name are a pair.
    pub is_itself: bool,
    /// At how many places of the cloth.
    pub places: usize,
}

/// One garment of the run: its names, and what of its cloth lies over what.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
pub struct GarmentFacts {
    /// Name in files, such as `blouse`.
    pub id: String,
    /// What it is called.
    pub name: String,
    /// Its Japanese name.
    pub name_ja: String,
    /// Places of the cloth that lie under other cloth of it, as it was put on.
    pub overlapping_places: usize,
    /// Which piece lies outside over which, most places first.
    pub over: Vec<ReportPieceOver>,
    /// Places that lie the wrong way round.
    pub inverted_places: Worst<usize>,
}

/// One measure of the dancer as the finished body has it.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct DancerMeasure {
    /// Key of the design, such as `bust_cm`.
    pub key: String,
    /// Name in English.
    pub name: String,
    /// Name in Japanese.
    pub name_ja: String,
    /// What the surface has, measured as a tape measures [cm].
    pub on_body_cm: f64,
    /// What the design gave [cm]; `None` where it was estimated.
    pub given_cm: Option<f64>,
    /// Whether nobody measured it.
    pub is_estimated: bool,
}

/// Columns over the frames of the run; equally long, or empty where not measured.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct RunSeries {
    /// Time of each frame [s].
    pub time_s: Vec<f64>,
    /// Simulation of each frame, process CPU [ms].
    pub frame_ms: Vec<f64>,
    /// 99th percentile of the absolute strain of structural edges [%].
    pub strain_p99_pct: Vec<f64>,
    /// Mean height of the hem above the floor [cm].
    pub hem_height_mean_cm: Vec<f64>,
    /// Deepest cloth vertex inside the drawn body [mm].
    pub skin_penetration_mm: Vec<f64>,
}

/// One run of `lole dance`, measured.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct RunReport {
    /// Version of the program that ran.
    pub lole: String,
    /// Mass points of the cloth.
    pub particles: usize,
    /// Springs of the cloth, or distance constraints of the method.
    pub springs: usize,
    /// Name of the integration method, such as `xpbd`.
    pub method: String,
    /// Substeps of a frame as the cloth is after the last one: more than usual where it is strained.
    pub substeps: u32,
    /// Threads the simulation used.
    pub threads: usize,
    /// Frames of the dance that were simulated.
    pub frames: usize,
    /// Length of the dance [s].
    pub seconds: f64,
    /// Name of the dance step, such as `kaholo`.
    pub dance_step: String,
    /// Beats per minute.
    pub bpm: f64,
    /// Seed of everything that is chosen by chance.
    pub seed: u64,
    /// What drew the pictures, in words.
    pub renderer: String,
    /// Simulation of one frame, process CPU over all threads [ms].
    pub frame_ms: MedianPercentile,
    /// Simulation of one frame, wall clock [ms].
    pub frame_wall_ms: MedianPercentile,
    /// Simulated seconds over wall seconds of simulation.
    pub realtime_factor: f64,
    /// Absolute strain of structural edges, pairs of pinned points left out, worst over the run [%].
    pub strain_pct: MeanPercentileMax,
    /// Absolute strain of structural edges, pairs of pinned points left out, at the end of the run [%].
    pub strain_end_pct: MeanPercentileMax,
    /// What the cloth met as a body: `skin`, `capsules` or `two-cylinders`.
    pub contact_body: String,
    /// Deepest particle inside a capsule [mm]; 0 where cloth met the skin.
    pub capsule_penetration_mm: Worst<f64>,
    /// Deepest cloth vertex inside the drawn body [mm].
    pub skin_penetration_mm: Worst<f64>,
    /// Cloth vertices deeper than 0.5 mm in the drawn body, and body vertices outside cloth that
    /// covers them.
    pub skin_penetration_vertices: Worst<usize>,
    /// Height of the hem above the floor [cm].
    pub hem_height_cm: MinMeanMax,
    /// Whether every number of the run stayed finite.
    pub finite: bool,
    /// Where the run diverged, if it did.
    pub divergence: Option<ReportDivergence>,
    /// When, and beside what, the dance left the cloth no room.
    pub no_room: Vec<Remark>,
    /// How each dressed garment covers itself.
    pub garments: Vec<GarmentFacts>,
    /// Hash of all bits of the final state, 16 hexadecimal digits.
    pub state_hash: String,
    /// Files the run wrote.
    pub files: Vec<ReportFile>,
    /// The dancer's measures, given and estimated.
    pub dancer: Vec<DancerMeasure>,
    /// Facts of the skirt for its maker.
    pub skirt: SkirtFacts,
    /// Columns over frames.
    pub series: RunSeries,
}

/// A still of the page.
#[derive(Debug, Clone, Copy)]
pub struct Still<'a> {
    /// English caption, such as `Front`.
    pub caption_en: &'a str,
    /// Japanese caption, such as `正面`.
    pub caption_ja: &'a str,
    /// JPEG bytes.
    pub jpeg: &'a [u8],
}
