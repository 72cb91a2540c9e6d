//! What may be typed after `lole`.

mod group;

use std::ops::RangeInclusive;
use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};

pub(crate) use group::GroupArgs;
use lole_language::Sentence;

/// Hula costume CAD with live cloth. Without a command it opens the live window.
#[derive(Debug, Parser)]
#[command(
    name = "lole",
    version,
    override_usage = "lole [DESIGN.lole]\n       lole <COMMAND>"
)]
pub(crate) struct Cli {
    /// Leave out what was written and how far it is; warnings and asked-for figures stay.
    #[arg(short, long, global = true)]
    pub(crate) quiet: bool,
    /// What to do.
    #[command(subcommand)]
    pub(crate) command: Command,
}

/// The commands.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Drape and dance a design; write film, stills, 3D file and report.
    Dance(DanceArgs),
    /// Sew a garment from another program's pattern, and dance in it; write what dance writes.
    Wear(Box<WearArgs>),
    /// A dance for other programs: point caches, OBJ, NumPy, tables, USD.
    Export(Box<ExportArgs>),
    /// A dancer in her costume as an avatar (VRM 1.0), its skirt on spring bones fitted to how it sways.
    Vrm(Box<VrmArgs>),
    /// Cut plans and patterns of a design: on paper at full size, as SVG and as DXF.
    Pattern(PatternArgs),
    /// One design for a list of dancers: cut sizes, elastics, cloth to buy, cost, booklet, summary.
    Order(OrderArgs),
    /// The sewing booklet of a design as PDF: materials, cut plan, steps with drawings, cost.
    Booklet(BookletArgs),
    /// What a design costs by the prices in it, and which prices are missing.
    Cost(CostArgs),
    /// A form to write measurements on, as PDF.
    Form(FormArgs),
    /// The paper's experiment with numbers: its integrators, their limits, its 13 capsules.
    Study(StudyArgs),
    /// The engine against closed forms: measured, reference, error, gate.
    Validate(ValidateArgs),
    /// Frame time by scene on this machine, with strain and penetration.
    Bench(BenchArgs),
    /// Runs by the thousand: what a sweep varies of a design, as one table.
    Batch(BatchArgs),
    /// The dancer alone: pictures from four sides, the tape on her body, capsules, 3D file.
    Dancer(DancerArgs),
    /// What is in an avatar or a recording: bones, unit, axes, pose, meshes, motion, license.
    Inspect(InspectArgs),
    /// The shelf of fabrics with their figures, and your own cloth measured with ruler and scale.
    Fabric(FabricArgs),
    /// What a shell completes after lole, on standard output, for its folder of completions.
    Completions(CompletionsArgs),
    /// Manual pages of lole and of each of its commands.
    Man(ManArgs),
}

/// `lole completions`.
#[derive(Debug, Args)]
pub(crate) struct CompletionsArgs {
    /// The shell: bash, zsh, fish, elvish or powershell.
    #[arg(value_enum)]
    pub(crate) shell: clap_complete::Shell,
}

/// `lole man`.
#[derive(Debug, Args)]
pub(crate) struct ManArgs {
    /// Folder for the pages.
    #[arg(long, value_name = "DIR", default_value = "lole-man")]
    pub(crate) out: PathBuf,
}

/// `lole fabric`.
#[derive(Debug, Args)]
pub(crate) struct FabricArgs {
    /// list: the fabrics of the shelf; measure: your own cloth. Without its numbers, measure says how
    /// it is done.
    #[arg(value_enum, default_value_t = FabricTask::List)]
    pub(crate) task: FabricTask,
    /// Length of the swatch along the selvage [cm].
    #[arg(long, value_name = "CM", value_parser = figure, allow_negative_numbers = true)]
    pub(crate) length_cm: Option<f64>,
    /// Width of the swatch across the cloth [cm].
    #[arg(long, value_name = "CM", value_parser = figure, allow_negative_numbers = true)]
    pub(crate) width_cm: Option<f64>,
    /// Weight of the swatch [g].
    #[arg(long, value_name = "G", value_parser = figure, allow_negative_numbers = true)]
    pub(crate) mass_g: Option<f64>,
    /// Length over the edge of a strip cut along the selvage [cm].
    #[arg(long, value_name = "CM", value_parser = figure, allow_negative_numbers = true)]
    pub(crate) overhang_warp_cm: Option<f64>,
    /// How far its tip is below the edge [cm]; left out, the tip touches a slope of --slope-deg.
    #[arg(long, value_name = "CM", value_parser = figure, allow_negative_numbers = true)]
    pub(crate) drop_warp_cm: Option<f64>,
    /// The same of a strip cut across; left out, the cloth is taken to be alike both ways [cm].
    #[arg(long, value_name = "CM", value_parser = figure, allow_negative_numbers = true)]
    pub(crate) overhang_weft_cm: Option<f64>,
    /// How far its tip is below the edge [cm].
    #[arg(long, value_name = "CM", value_parser = figure, allow_negative_numbers = true)]
    pub(crate) drop_weft_cm: Option<f64>,
    /// Slope of the plane that the tip touches, where no drop is given [degrees]: 41.5 in most
    /// laboratories, 45 in JIS L 1096.
    #[arg(long, value_name = "DEGREES", default_value_t = 41.5, value_parser = figure, allow_negative_numbers = true)]
    pub(crate) slope_deg: f64,
    /// Print it as JSON.
    #[arg(long)]
    pub(crate) json: bool,
}

/// What `lole fabric` does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum FabricTask {
    /// Lists the shelf.
    List,
    /// Works out a cloth's figures.
    Measure,
}

/// `lole dancer`.
#[derive(Debug, Args)]
pub(crate) struct DancerArgs {
    /// Design document; without one, the built-in dancer.
    pub(crate) design: Option<PathBuf>,
    /// Folder for the results.
    #[arg(long, value_name = "DIR", default_value = "lole-dancer")]
    pub(crate) out: PathBuf,
    /// Avatar instead of the design's dancer (.vrm, .glb, .gltf).
    #[arg(long, value_name = "FILE")]
    pub(crate) avatar: Option<PathBuf>,
    /// Her measures from another program: a body of GarmentCode (.yaml), a set of FreeSewing (.json, .yaml),
    /// .smis of Seamly.
    #[arg(long, value_name = "FILE", conflicts_with = "avatar")]
    pub(crate) measures: Option<PathBuf>,
    /// Draw with the processor even where there is a graphics device.
    #[arg(long)]
    pub(crate) cpu: bool,
    /// Print the figures as JSON on standard output, and nothing else there.
    #[arg(long)]
    pub(crate) json: bool,
}

/// `lole inspect`.
#[derive(Debug, Args)]
pub(crate) struct InspectArgs {
    /// The file: an avatar or a recorded motion (.vrm, .glb, .gltf, .vrma, .bvh), another program's pattern
    /// (.json) or measures (.yaml, .json, .smis).
    pub(crate) file: PathBuf,
    /// List that says which joint is which bone, one `joint = bone` on a line.
    #[arg(long, value_name = "LIST")]
    pub(crate) bones: Option<PathBuf>,
    /// Draw the panels of a pattern flat, with their stitches numbered, into this file.
    #[arg(long, value_name = "FILE")]
    pub(crate) svg: Option<PathBuf>,
    /// Print it as JSON.
    #[arg(long)]
    pub(crate) json: bool,
}

/// `lole dance`.
#[derive(Debug, Args)]
pub(crate) struct DanceArgs {
    /// Design document; without one, the built-in pāʻū skirt dances kāholo.
    pub(crate) design: Option<PathBuf>,
    /// Folder for the results.
    #[arg(long, value_name = "DIR", default_value = "lole-dance")]
    pub(crate) out: PathBuf,
    /// Length of the dance [s], 0.5 to 600; otherwise the design's, 12 without one.
    #[arg(long, value_parser = seconds, allow_negative_numbers = true)]
    pub(crate) seconds: Option<f64>,
    /// Dance step, such as kao, kaholo, hela or ami-kuu, instead of what the design dances.
    #[arg(long)]
    pub(crate) step: Option<String>,
    /// Tempo in counts per minute; otherwise the design's.
    #[arg(long, value_name = "COUNTS", value_parser = tempo, allow_negative_numbers = true)]
    pub(crate) bpm: Option<f64>,
    /// Method: xpbd (real time) or fb-euler (the reference, slow); otherwise the design's.
    #[arg(long)]
    pub(crate) method: Option<String>,
    /// Avatar who dances instead of the design's dancer (.vrm, .glb, .gltf).
    #[arg(long, value_name = "FILE")]
    pub(crate) avatar: Option<PathBuf>,
    /// Her measures from another program: a body of GarmentCode (.yaml), a set of FreeSewing (.json, .yaml),
    /// .smis of Seamly.
    #[arg(long, value_name = "FILE", conflicts_with = "avatar")]
    pub(crate) measures: Option<PathBuf>,
    /// Recorded motion that is danced instead of the design's (.bvh, .vrma, .glb, .vrm).
    #[arg(long, value_name = "FILE", conflicts_with = "step")]
    pub(crate) motion: Option<PathBuf>,
    /// Song under the film: AAC or Opus in an MP4 file (.m4a); it begins with the dance.
    #[arg(long, value_name = "FILE")]
    pub(crate) audio: Option<PathBuf>,
    /// Size of the film in pixels, both even.
    #[arg(long, value_name = "WIDTHxHEIGHT", default_value = "1280x720", value_parser = size)]
    pub(crate) size: (u32, u32),
    /// Threads of the simulation; the result is the same on any number.
    #[arg(long, value_parser = threads, allow_negative_numbers = true)]
    pub(crate) threads: Option<u16>,
    /// Chance for how unevenly the gathers are pushed together; otherwise the design's.
    #[arg(long, value_parser = seed, allow_negative_numbers = true)]
    pub(crate) seed: Option<u64>,
    /// Draw with the processor even where there is a graphics device.
    #[arg(long)]
    pub(crate) cpu: bool,
    /// Print the report as JSON on standard output, and nothing else there.
    #[arg(long)]
    pub(crate) json: bool,
    #[command(flatten)]
    pub(crate) group: GroupArgs,
}

/// `lole wear`.
#[derive(Debug, Args)]
pub(crate) struct WearArgs {
    /// The pattern: a specification of GarmentCode (.json).
    pub(crate) pattern: PathBuf,
    /// Design whose dancer, motion, cloth and print are taken; her garments are not.
    #[arg(long, value_name = "DESIGN")]
    pub(crate) dancer: Option<PathBuf>,
    /// Avatar who wears it (.vrm, .glb, .gltf).
    #[arg(long, value_name = "FILE")]
    pub(crate) avatar: Option<PathBuf>,
    /// Her measures from another program: a body of GarmentCode (.yaml), a set of FreeSewing (.json, .yaml),
    /// .smis of Seamly.
    #[arg(long, value_name = "FILE", conflicts_with = "avatar")]
    pub(crate) measures: Option<PathBuf>,
    /// Folder for the results.
    #[arg(long, value_name = "DIR", default_value = "lole-wear")]
    pub(crate) out: PathBuf,
    /// Size of all pieces over that of the file, 0.25 to 4; left out, the one that she can wear.
    #[arg(long, value_name = "RATIO", value_parser = size_ratio, allow_negative_numbers = true)]
    pub(crate) size_ratio: Option<f64>,
    /// Fabric of the shelf, such as cotton-lawn; `lole fabric` lists them.
    #[arg(long, value_name = "NAME")]
    pub(crate) fabric: Option<String>,
    /// Length of the dance [s], 0.5 to 600; otherwise the design's, 12 without one.
    #[arg(long, value_parser = seconds, allow_negative_numbers = true)]
    pub(crate) seconds: Option<f64>,
    /// Dance step, such as kao, kaholo, hela or ami-kuu, instead of what the design dances.
    #[arg(long)]
    pub(crate) step: Option<String>,
    /// Tempo in counts per minute; otherwise the design's.
    #[arg(long, value_name = "COUNTS", value_parser = tempo, allow_negative_numbers = true)]
    pub(crate) bpm: Option<f64>,
    /// Recorded motion that is danced (.bvh, .vrma, .glb, .vrm).
    #[arg(long, value_name = "FILE", conflicts_with = "step")]
    pub(crate) motion: Option<PathBuf>,
    /// Size of the film in pixels, both even.
    #[arg(long, value_name = "WIDTHxHEIGHT", default_value = "1280x720", value_parser = size)]
    pub(crate) size: (u32, u32),
    /// Threads of the simulation; the result is the same on any number.
    #[arg(long, value_parser = threads, allow_negative_numbers = true)]
    pub(crate) threads: Option<u16>,
    /// Draw with the processor even where there is a graphics device.
    #[arg(long)]
    pub(crate) cpu: bool,
    /// Print the report as JSON on standard output, and nothing else there.
    #[arg(long)]
    pub(crate) json: bool,
}

/// `lole export`.
#[derive(Debug, Args)]
pub(crate) struct ExportArgs {
    /// Design document, which is danced and recorded, or a take that was recorded (.take); without one, the
    /// built-in pāʻū skirt dances kāholo.
    pub(crate) source: Option<PathBuf>,
    /// Forms to write, with commas between them.
    #[arg(long, value_enum, value_delimiter = ',', required = true)]
    pub(crate) format: Vec<ExportFormat>,
    /// Folder for the results; a recording that was stopped is kept in it and goes on.
    #[arg(long, value_name = "DIR", default_value = "lole-export")]
    pub(crate) out: PathBuf,
    /// Frames in a second: 60, 30, 20, 15, 12, 10, 6 or 5; of a take, those it was recorded with.
    #[arg(long, value_name = "FRAMES", value_parser = frame_rate, allow_negative_numbers = true)]
    pub(crate) fps: Option<u32>,
    /// Length of the dance [s], 0.5 to 600; otherwise the design's, 12 without one.
    #[arg(long, value_parser = seconds, allow_negative_numbers = true)]
    pub(crate) seconds: Option<f64>,
    /// Dance step, such as kao, kaholo, hela or ami-kuu, instead of what the design dances.
    #[arg(long)]
    pub(crate) step: Option<String>,
    /// Tempo in counts per minute; otherwise the design's.
    #[arg(long, value_name = "COUNTS", value_parser = tempo, allow_negative_numbers = true)]
    pub(crate) bpm: Option<f64>,
    /// Avatar who dances instead of the design's dancer (.vrm, .glb, .gltf).
    #[arg(long, value_name = "FILE")]
    pub(crate) avatar: Option<PathBuf>,
    /// Recorded motion that is danced instead of the design's (.bvh, .vrma, .glb, .vrm).
    #[arg(long, value_name = "FILE", conflicts_with = "step")]
    pub(crate) motion: Option<PathBuf>,
    /// Threads of the simulation; the result is the same on any number.
    #[arg(long, value_parser = threads, allow_negative_numbers = true)]
    pub(crate) threads: Option<u16>,
    /// Print what was written as JSON on standard output, and nothing else there.
    #[arg(long)]
    pub(crate) json: bool,
}

/// Forms of a dance for other programs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, ValueEnum)]
pub(crate) enum ExportFormat {
    /// glTF with dancer and bones, for viewers and game engines.
    Glb,
    /// OpenUSD, binary, with its pictures beside it.
    Usd,
    /// OpenUSD as one file.
    Usdz,
    /// Point caches of 3ds Max and Blender, with each mesh as OBJ.
    Pc2,
    /// Point caches of LightWave, with each mesh as OBJ.
    Mdd,
    /// One OBJ for each frame.
    Obj,
    /// Arrays of NumPy.
    Npz,
    /// A table for each mesh.
    Csv,
}

/// `lole vrm`.
#[derive(Debug, Args)]
pub(crate) struct VrmArgs {
    /// Design document, which is danced and recorded, or a take that was recorded (.take); without one, the
    /// built-in pāʻū skirt dances kāholo.
    pub(crate) source: Option<PathBuf>,
    /// Folder for the results: costume.vrm, and the recording.
    #[arg(long, value_name = "DIR", default_value = "lole-vrm")]
    pub(crate) out: PathBuf,
    /// What the avatar is called.
    #[arg(long, value_name = "NAME", default_value = "Lole")]
    pub(crate) name: String,
    /// Who made it, for the terms of use that every VRM carries.
    #[arg(long, value_name = "NAME", required = true)]
    pub(crate) author: Vec<String>,
    /// Length of the dance that the springs are fitted to [s], 0.5 to 600; otherwise the design's, 12 without one.
    #[arg(long, value_parser = seconds, allow_negative_numbers = true)]
    pub(crate) seconds: Option<f64>,
    /// Threads of the simulation; the result is the same on any number.
    #[arg(long, value_parser = threads, allow_negative_numbers = true)]
    pub(crate) threads: Option<u16>,
    /// Print what was written as JSON on standard output, and nothing else there.
    #[arg(long)]
    pub(crate) json: bool,
}

/// `lole pattern`.
#[derive(Debug, Args)]
pub(crate) struct PatternArgs {
    /// Design document; without one, the built-in pāʻū skirt.
    pub(crate) design: Option<PathBuf>,
    /// Folder for the results.
    #[arg(long, value_name = "DIR", default_value = "lole-pattern")]
    pub(crate) out: PathBuf,
    /// Paper of the printer: a4, a3 or letter.
    #[arg(long, value_enum, default_value_t = PaperSize::A4)]
    pub(crate) paper: PaperSize,
    /// Write each garment on one page too, at full size: a0, roll (91 cm wide), projector or plotter
    /// (HP-GL for pen plotters and cutters); several with commas.
    /// Cutting lines, sewing lines, marks and names are layers that a reader's window shows and hides.
    #[arg(long, value_enum, value_name = "PAGE", value_delimiter = ',')]
    pub(crate) whole: Vec<WholePage>,
    /// Write each garment in several sizes around one another too: jis (JIS L 4005, 5AR to 17AR), en (EN
    /// 13402-3, bust 76 to 104), or a list of your own sizes as for an order. Each size is a layer that a reader's
    /// window shows and hides.
    #[arg(long, value_name = "LIST")]
    pub(crate) sizes: Option<String>,
    /// Lay the cloth doubled, folded lengthwise, and cut pairs at once.
    #[arg(long)]
    pub(crate) folded: bool,
    /// Lay the pieces so that the print meets at the seams: takes more cloth.
    #[arg(long)]
    pub(crate) match_print: bool,
    /// Write the pieces and how they are sewn for another program instead.
    #[arg(long, value_enum)]
    pub(crate) format: Option<PatternFormat>,
    /// Print the pattern as JSON on standard output, and nothing else there.
    #[arg(long)]
    pub(crate) json: bool,
}

/// Pages that hold a garment whole.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum WholePage {
    /// As wide as A0.
    A0,
    /// From a roll of 36 inches.
    Roll,
    /// For a projector: no margin, thick lines.
    Projector,
    /// For a pen plotter or a cutter: HP-GL, the cutting lines with pen 1.
    Plotter,
}

/// Forms of other programs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum PatternFormat {
    /// Specifications of GarmentCode (JSON): panels, edges, stitches.
    Garmentcode,
}

/// `lole order`.
#[derive(Debug, Args)]
pub(crate) struct OrderArgs {
    /// List of dancers from a spreadsheet (CSV, .xlsx, .ods; - reads it from standard input): names and
    /// measurements.
    pub(crate) roster: PathBuf,
    /// Design document that all of them wear.
    pub(crate) design: PathBuf,
    /// Folder for the results; pictures of a stopped run are kept in it and used again.
    #[arg(long, value_name = "DIR", default_value = "lole-order")]
    pub(crate) out: PathBuf,
    /// Spare cloth in percent of what is needed, 0 to 100.
    #[arg(long, value_name = "PERCENT", default_value_t = 5.0, value_parser = percent, allow_negative_numbers = true)]
    pub(crate) spare: f64,
    /// Cloth on one bolt in meters, to see where one bolt ends and the next begins.
    #[arg(long, value_name = "METERS", value_parser = bolt, allow_negative_numbers = true)]
    pub(crate) bolt: Option<f64>,
    /// Language of the pages: ja or en; otherwise the system's.
    #[arg(long, value_enum)]
    pub(crate) language: Option<PageLanguage>,
    /// Paper of the printer: a4, a3 or letter.
    #[arg(long, value_enum, default_value_t = PaperSize::A4)]
    pub(crate) paper: PaperSize,
    /// Leave out the pictures of the dancers, which take most of the time.
    #[arg(long)]
    pub(crate) no_pictures: bool,
    /// Print the order as JSON on standard output, and nothing else there.
    #[arg(long)]
    pub(crate) json: bool,
}

/// `lole booklet`.
#[derive(Debug, Args)]
pub(crate) struct BookletArgs {
    /// Design document; without one, the built-in pāʻū skirt.
    pub(crate) design: Option<PathBuf>,
    /// File to write; - writes it to standard output.
    #[arg(long, value_name = "FILE", default_value = "booklet.pdf")]
    pub(crate) out: PathBuf,
    /// Language of the pages: ja or en; otherwise the system's.
    #[arg(long, value_enum)]
    pub(crate) language: Option<PageLanguage>,
    /// Paper of the printer: a4, a3 or letter.
    #[arg(long, value_enum, default_value_t = PaperSize::A4)]
    pub(crate) paper: PaperSize,
    /// Leave out the picture on the cover.
    #[arg(long)]
    pub(crate) no_pictures: bool,
}

/// `lole cost`.
#[derive(Debug, Args)]
pub(crate) struct CostArgs {
    /// Design document; without one, the built-in pāʻū skirt.
    pub(crate) design: Option<PathBuf>,
    /// Print the bill as JSON.
    #[arg(long)]
    pub(crate) json: bool,
}

/// `lole form`.
#[derive(Debug, Args)]
pub(crate) struct FormArgs {
    /// List of dancers (CSV, .xlsx, .ods) whose names are written in, one page each; an empty form without one.
    pub(crate) roster: Option<PathBuf>,
    /// File to write; - writes it to standard output.
    #[arg(long, value_name = "FILE", default_value = "form.pdf")]
    pub(crate) out: PathBuf,
    /// Language of the page: ja or en; otherwise the system's.
    #[arg(long, value_enum)]
    pub(crate) language: Option<PageLanguage>,
    /// Paper of the printer: a4, a3 or letter.
    #[arg(long, value_enum, default_value_t = PaperSize::A4)]
    pub(crate) paper: PaperSize,
}

/// Language of pages.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum PageLanguage {
    /// 日本語
    Ja,
    /// English
    En,
}

/// Paper of printed pages.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum PaperSize {
    /// 210 × 297 mm.
    A4,
    /// 297 × 420 mm.
    A3,
    /// 8½ × 11 inches.
    Letter,
}

/// `lole study`.
#[derive(Debug, Args)]
pub(crate) struct StudyArgs {
    /// Folder for the results.
    #[arg(long, value_name = "DIR", default_value = "lole-study")]
    pub(crate) out: PathBuf,
    /// Shorter runs: under a minute instead of several.
    #[arg(long)]
    pub(crate) quick: bool,
    /// Threads of the simulation.
    #[arg(long, value_parser = threads, allow_negative_numbers = true)]
    pub(crate) threads: Option<u16>,
    /// Print the study as JSON on standard output, and nothing else there.
    #[arg(long)]
    pub(crate) json: bool,
}

/// `lole validate`.
#[derive(Debug, Args)]
pub(crate) struct ValidateArgs {
    /// One protocol only.
    #[arg(long)]
    pub(crate) only: Option<String>,
    /// Folder for a page with tables and curves; without one, nothing is written.
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
    /// Print the rows as JSON.
    #[arg(long)]
    pub(crate) json: bool,
}

/// `lole batch`.
#[derive(Debug, Args)]
pub(crate) struct BatchArgs {
    /// The sweep: a design, and which of its keys are varied (.toml).
    pub(crate) sweep: PathBuf,
    /// Folder for the results; runs that ended there are not run again.
    #[arg(long, value_name = "DIR", default_value = "lole-batch")]
    pub(crate) out: PathBuf,
    /// Runs at a time, one on a core each; otherwise as many as there are cores. The table is the same.
    #[arg(long, value_parser = threads, allow_negative_numbers = true)]
    pub(crate) threads: Option<u16>,
    /// Only the I-th of N shares of the runs, as in 2/8, without a table: for a queue such as Slurm's, whose
    /// shares may write into one folder.
    #[arg(long, value_name = "I/N", value_parser = shard)]
    pub(crate) shard: Option<(u64, u64)>,
    /// Run nothing: make the table of what has ended.
    #[arg(long, conflicts_with = "shard")]
    pub(crate) merge: bool,
    /// Another folder of results whose runs are taken over first; may be given again.
    #[arg(long, value_name = "DIR")]
    pub(crate) from: Vec<PathBuf>,
    /// Print the outcome as JSON.
    #[arg(long)]
    pub(crate) json: bool,
}

/// `lole bench`.
#[derive(Debug, Args)]
pub(crate) struct BenchArgs {
    /// One scene only.
    #[arg(long)]
    pub(crate) scene: Option<String>,
    /// One method only: xpbd or explicit-rows.
    #[arg(long)]
    pub(crate) method: Option<String>,
    /// Threads of the simulation.
    #[arg(long, default_value_t = 1, value_parser = threads, allow_negative_numbers = true)]
    pub(crate) threads: u16,
    /// Vector instructions: the widest of this processor, AVX2 at most, or what every one has. The
    /// state hash is the same with all of them.
    #[arg(long, value_enum, default_value_t = Vectors::Detected)]
    pub(crate) vectors: Vectors,
    /// Also hold the structural springs against the best of this machine: the speed of the scene's
    /// springs over that of a stream of springs that wait for nothing, with the same arithmetic, the
    /// same bytes, and as many particles, so that they lie in the same cache.
    #[arg(long)]
    pub(crate) roofline: bool,
    /// The same square from 4,096 to 262,144 particles by the same settings, instead of the scenes.
    #[arg(long)]
    pub(crate) sizes: bool,
    /// Quality against time: every scene of the engine with coarser and finer settings, and which
    /// of them no other beats.
    #[arg(long)]
    pub(crate) pareto: bool,
    /// Folder for a page with the curves of --pareto; without one, nothing is written.
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
    /// Move every scene of the engine at random for so many frames, and see that the cloth stays
    /// finite, whole, and on its side of the body.
    #[arg(long, value_name = "FRAMES", value_parser = frames, allow_negative_numbers = true)]
    pub(crate) soak: Option<u32>,
    /// Chance for the motion of --soak; 1 where it is left out. A seed repeats its run.
    #[arg(long, value_parser = seed, allow_negative_numbers = true)]
    pub(crate) seed: Option<u64>,
    /// Print the table as JSON.
    #[arg(long)]
    pub(crate) json: bool,
}

/// Vector instructions of `lole bench`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Vectors {
    /// The widest of this processor.
    Detected,
    /// Eight floats at a time at most.
    Wide,
    /// What every processor of the kind has.
    Baseline,
}

fn seconds(text: &str) -> Result<f64, Sentence> {
    let help = || {
        Sentence::new(
            "0.5 から 600 までの秒数を書いてください（例: 12）",
            "give a number of seconds from 0.5 to 600, such as 12",
        )
    };
    within(text, 0.5..=600.0).ok_or_else(help)
}

fn frame_rate(text: &str) -> Result<u32, Sentence> {
    const RATES: [u32; 8] = [60, 30, 20, 15, 12, 10, 6, 5];
    let help = || {
        Sentence::new(
            "60・30・20・15・12・10・6・5 から選んでください（1秒のコマ数）",
            "choose one of 60, 30, 20, 15, 12, 10, 6, 5 frames a second",
        )
    };
    let rate = text.parse().ok();
    rate.filter(|rate| RATES.contains(rate)).ok_or_else(help)
}

fn size_ratio(text: &str) -> Result<f64, Sentence> {
    let help = || {
        Sentence::new(
            "0.25 から 4 までの倍率を書いてください（例: 1.1）",
            "give a ratio from 0.25 to 4, such as 1.1",
        )
    };
    within(text, 0.25..=4.0).ok_or_else(help)
}

/// A number in a range.
fn within(text: &str, range: RangeInclusive<f64>) -> Option<f64> {
    let value = text.parse::<f64>().ok()?;
    range.contains(&value).then_some(value)
}

/// Any number: the measurement knows which there are.
fn figure(text: &str) -> Result<f64, Sentence> {
    text.parse().map_err(|_| {
        Sentence::new(
            "数を書いてください（例: 12.5）",
            "give a number, such as 12.5",
        )
    })
}

/// Any number: the design knows which tempos there are.
fn tempo(text: &str) -> Result<f64, Sentence> {
    text.parse().map_err(|_| {
        Sentence::new(
            "1分あたりの拍数を数で書いてください（例: 80）",
            "give a number of counts per minute, such as 80",
        )
    })
}

fn percent(text: &str) -> Result<f64, Sentence> {
    number(text, [0.0, 100.0], "5")
}

fn bolt(text: &str) -> Result<f64, Sentence> {
    number(text, [1.0, 1000.0], "50")
}

fn number(text: &str, [min, max]: [f64; 2], such_as: &str) -> Result<f64, Sentence> {
    let value = text.parse::<f64>().ok();
    value
        .filter(|value| (min..=max).contains(value))
        .ok_or_else(|| {
            Sentence::new(
                format!("{min} から {max} までの数を書いてください（例: {such_as}）"),
                format!("give a number from {min} to {max}, such as {such_as}"),
            )
        })
}

fn threads(text: &str) -> Result<u16, Sentence> {
    let help = || {
        Sentence::new(
            "1 から 256 までの整数を書いてください",
            "give a whole number from 1 to 256",
        )
    };
    let value = text.parse().map_err(|_| help())?;
    (1..=256).contains(&value).then_some(value).ok_or_else(help)
}

/// `I/N`, counted from 1.
fn shard(text: &str) -> Result<(u64, u64), Sentence> {
    let numbers = text.split_once('/');
    let numbers = numbers.and_then(|(one, all)| Some((one.parse().ok()?, all.parse().ok()?)));
    numbers
        .filter(|(one, all)| (1..=*all).contains(one))
        .ok_or_else(|| {
            Sentence::new(
                "何番目/いくつに分けるか を書いてください（例: 2/8）",
                "give a share and how many there are, such as 2/8",
            )
        })
}

fn frames(text: &str) -> Result<u32, Sentence> {
    let help = || {
        Sentence::new(
            "1 から 1000000000 までの整数を書いてください（例: 100000）",
            "give a whole number from 1 to 1000000000, such as 100000",
        )
    };
    let value = text.parse().map_err(|_| help())?;
    (1..=1_000_000_000)
        .contains(&value)
        .then_some(value)
        .ok_or_else(help)
}

fn seed(text: &str) -> Result<u64, Sentence> {
    text.parse().map_err(|_| {
        Sentence::new(
            "0 以上の整数を書いてください（例: 1）",
            "give a whole number from 0 upward, such as 1",
        )
    })
}

fn size(text: &str) -> Result<(u32, u32), Sentence> {
    let help = || {
        Sentence::new(
            "幅x高さ を 64 から 4096 までの偶数で書いてください（例: 1280x720）",
            "give WIDTHxHEIGHT, both even and from 64 to 4096, such as 1280x720",
        )
    };
    let (width, height) = text.split_once(['x', 'X', '×']).ok_or_else(help)?;
    let (width, height): (u32, u32) = (
        width.parse().map_err(|_| help())?,
        height.parse().map_err(|_| help())?,
    );
    let fits = |side: u32| (64..=4096).contains(&side) && side.is_multiple_of(2);
    if fits(width) && fits(height) {
        Ok((width, height))
    } else {
        Err(help())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_command_line_is_well_formed() {
        use clap::CommandFactory as _;
        Cli::command().debug_assert();
    }

    #[test]
    fn sizes_that_no_film_can_have_are_refused() {
        assert_eq!(size("1280x720"), Ok((1280, 720)));
        for bad in ["", "1280", "0x0", "641x360", "-2x4", "99999x720", "axb"] {
            assert!(size(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn absurd_lengths_are_refused() {
        assert_eq!(seconds("2"), Ok(2.0));
        for bad in ["0", "-1", "nan", "inf", "1e9", "long"] {
            assert!(seconds(bad).is_err(), "{bad}");
        }
    }
}
