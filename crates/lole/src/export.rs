//! `lole export`: a dance, recorded once, as files that other programs open.

mod record;
mod written;

use std::fs::File;
use std::io::BufReader;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use lole_avatar::License;
use lole_costume::document::Design;
use lole_export::glb::{ClothFit, said_of};
use lole_export::take::record::{RecordedTake, StagedTake, TakeError, TakeHeader};
use lole_export::take::{TakeFormat, TakeSource as _, write_take};
use lole_export::vrm::VrmMeta;
use lole_files::OutputFolder;
use lole_language::{Language, Sentence};
use lole_picture::taken::{take_glb, take_scene};
use lole_picture::vrm::take_vrm;
use lole_picture::{Cover, Looks};
use lole_stage::Production;
use serde_json::json;

use crate::args::{DanceArgs, ExportArgs, ExportFormat, GroupArgs, VrmArgs};
use crate::patience::{check, progress_bar, stop_flag};
use crate::source::{self, Source};
use crate::{Failure, dance, output, summary};
use record::Recorder;
use written::{Files, Watched};

/// How the name of a take ends.
const TAKE: &str = "take";
/// The file with bones.
const GLB: &str = "dance.glb";
/// The avatar.
const VRM: &str = "costume.vrm";

/// A take that is read from the disk.
type Take = RecordedTake<BufReader<File>>;

/// Runs the command.
pub(crate) fn run(args: &ExportArgs, language: Language) -> Result<(), Failure> {
    let mut formats = args.format.clone();
    formats.sort_unstable();
    formats.dedup();
    let stop = stop_flag().map_err(Failure::error)?;
    let Ready {
        take,
        production,
        path,
        output,
    } = ready(args, |_| Ok(()), language, &stop)?;
    let looks = looks(&production.design, &production)?;
    let staged = stage(take, (&production, &looks.worn), &path)?;
    let (frames, rate) = (staged.scene().frame_count, staged.scene().frame_rate);
    let (paths, fits) = write(
        (staged, &production, &looks.worn),
        &formats,
        (output, language, &stop),
    )?;
    if args.json {
        let files: Vec<String> = paths.iter().map(|it| it.display().to_string()).collect();
        let path = path.display().to_string();
        let told = json!({ "take": path, "frames": frames, "frame_rate": rate, "files": files,
            "on_bones": fits.iter().map(told).collect::<Vec<_>>() });
        summary::print_json(&format!("{told:#}"));
    } else {
        summary::print_export(&path, (frames, rate), &paths, language);
        summary::print_lines(&[said_of(&fits)], language);
    }
    Ok(())
}

/// Runs `lole vrm`.
pub(crate) fn run_vrm(args: &VrmArgs, language: Language) -> Result<(), Failure> {
    let stop = stop_flag().map_err(Failure::error)?;
    let wishes = ExportArgs {
        source: args.source.clone(),
        format: Vec::new(),
        out: args.out.clone(),
        fps: None,
        seconds: args.seconds,
        step: None,
        bpm: None,
        avatar: None,
        motion: None,
        threads: args.threads,
        json: args.json,
    };
    let Ready {
        take,
        production,
        path,
        mut output,
    } = ready(&wishes, refused_as_avatar, language, &stop)?;
    let looks = looks(&production.design, &production)?;
    let mut staged = stage(take, (&production, &looks.worn), &path)?;
    let meta = VrmMeta {
        name: args.name.clone(),
        authors: args.author.clone(),
    };
    let made = take_vrm(&production, &looks.worn, (&mut staged, &meta));
    let (bytes, figures) = made.map_err(Failure::error)?;
    output.write(VRM, &bytes).map_err(Failure::error)?;
    let paths = output.finish().map_err(Failure::error)?;
    if args.json {
        let files: Vec<String> = paths.iter().map(|it| it.display().to_string()).collect();
        let [stiffness, drag, gravity] = figures.settings;
        let told = json!({ "take": path.display().to_string(), "files": files,
            "frames": figures.frames, "mean_mm": figures.mean_mm, "worst_mm": figures.worst_mm,
            "leg_share": figures.leg_share,
            "stiffness": stiffness, "drag_force": drag, "gravity_power": gravity });
        summary::print_json(&format!("{told:#}"));
    } else {
        summary::print_files(&paths, language);
        summary::print_vrm(&figures, language);
    }
    Ok(())
}

/// A take that is whole, and what is needed to make files of it.
struct Ready {
    take: Take,
    production: Arc<Production>,
    path: PathBuf,
    output: OutputFolder,
}

/// A dancer whose license keeps her out of files becomes no avatar.
fn refused_as_avatar(production: &Production) -> Result<(), Failure> {
    let license = production.license.as_ref();
    let refusal = license.and_then(License::export_refusal);
    refusal.map_or(Ok(()), |refusal| Err(Failure::usage(refusal)))
}

/// Opens the take that was given, or records the design, unless the dancer is refused before.
fn ready(
    args: &ExportArgs,
    refuse: fn(&Production) -> Result<(), Failure>,
    language: Language,
    stop: &AtomicBool,
) -> Result<Ready, Failure> {
    let make = || output::create(&args.out).map_err(Failure::Usage);
    if let Some(path) = args.source.as_deref().filter(|it| is_take(it)) {
        refuse_wishes(args)?;
        let take = open(path)?;
        let production = produce(&read(path, take.header())?)?;
        refuse(&production)?;
        return Ok(Ready {
            take,
            production,
            path: path.to_owned(),
            output: make()?,
        });
    }
    let source = load(args)?;
    let production = produce(&source)?;
    refuse(&production)?;
    let output = make()?;
    let recorder = Recorder {
        args,
        language,
        stop,
        design: &source.design,
    };
    let path = recorder.record(&production)?;
    Ok(Ready {
        take: open(&path)?,
        production,
        path,
        output,
    })
}

/// Cloth that a file has on bones, and how far they carry it from where it was.
fn told(fit: &ClothFit) -> serde_json::Value {
    json!({ "name": fit.name, "bones": fit.bone_count, "mean_mm": fit.mean_mm, "worst_mm": fit.worst_mm })
}

fn is_take(path: &Path) -> bool {
    path.extension().is_some_and(|end| end == TAKE)
}

/// What is decided when a take is recorded cannot be asked of it afterwards.
fn refuse_wishes(args: &ExportArgs) -> Result<(), Failure> {
    let wishes = [
        ("--fps", args.fps.is_some()),
        ("--seconds", args.seconds.is_some()),
        ("--step", args.step.is_some()),
        ("--bpm", args.bpm.is_some()),
        ("--avatar", args.avatar.is_some()),
        ("--motion", args.motion.is_some()),
    ];
    let Some((option, _)) = wishes.iter().find(|(_, is_wished)| *is_wished) else {
        return Ok(());
    };
    Err(Failure::usage(Sentence::new(
        format!("{option}: テイクはもう記録されています。デザインから記録し直してください"),
        format!("{option}: a take is recorded already; record it anew from its design"),
    )))
}

/// Reads the design and lays the command line's wishes over it.
fn load(args: &ExportArgs) -> Result<Source, Failure> {
    let mut source = source::read(args.source.as_deref())?;
    source.put(args.avatar.as_deref(), args.motion.as_deref())?;
    let wishes = DanceArgs {
        design: None,
        out: args.out.clone(),
        seconds: args.seconds,
        step: args.step.clone(),
        bpm: args.bpm,
        method: None,
        avatar: None,
        measures: None,
        motion: args.motion.clone(),
        audio: None,
        size: (64, 64),
        threads: args.threads,
        seed: None,
        cpu: true,
        json: args.json,
        group: GroupArgs::default(),
    };
    dance::lay_over(&mut source.design, &wishes)?;
    Ok(source)
}

/// The design of a take, with the files that it names.
fn read(path: &Path, header: &TakeHeader) -> Result<Source, Failure> {
    let name = path.display().to_string();
    let mut design = lole_costume::document::parse_bytes(header.design.as_bytes(), &name)
        .map_err(|error| Failure::Usage(error.into()))?;
    lole_files::read_linked_files(&mut design, path).map_err(Failure::usage)?;
    if record::files_hash(&design) != header.files_hash {
        return Err(Failure::usage(Sentence::new(
            format!(
                "{name}: アバターか踊りのファイルが、記録したあとに変わっています。記録し直してください"
            ),
            format!(
                "{name}: the avatar or the recorded motion has changed since; record the take again"
            ),
        )));
    }
    Ok(Source::of(name, header.design.clone(), design))
}

fn produce(source: &Source) -> Result<Arc<Production>, Failure> {
    let production = Production::new(&source.design);
    let production = production
        .map_err(|error| source.located(dance::place_of(&error), Sentence::of(&error)))?;
    Ok(Arc::new(production))
}

fn open(path: &Path) -> Result<Take, Failure> {
    let file = File::open(path).map_err(TakeError::from);
    let take = file.and_then(|file| RecordedTake::open(BufReader::new(file)));
    let take = take.and_then(|take| {
        let version = &take.header().lole;
        if version != env!("CARGO_PKG_VERSION") {
            return Err(TakeError::OtherVersion(version.clone()));
        }
        if take.whole_count() == 0 {
            return Err(TakeError::Empty);
        }
        Ok(take)
    });
    take.map_err(|error| {
        let name = path.display();
        let japanese = match &error {
            TakeError::Unreadable(cause) => {
                format!("ファイルが読めません。場所を確かめてください（{cause}）")
            }
            TakeError::OtherVersion(version) => {
                format!(
                    "別のバージョンの Lole（{version}）が記録したテイクです。記録し直してください"
                )
            }
            TakeError::Empty => "全部そろったコマがありません。記録し直してください".to_owned(),
            _ => "テイクではありません。lole export で記録してください".to_owned(),
        };
        Failure::usage(Sentence::new(
            format!("{name}: {japanese}"),
            format!("{name}: {error}"),
        ))
    })
}

/// A take with the meshes that it moves, which are those of its design.
fn stage(
    take: Take,
    (production, covers): (&Production, &[Cover]),
    path: &Path,
) -> Result<StagedTake<BufReader<File>>, Failure> {
    let mut scene = take_scene(production, covers).map_err(Failure::error)?;
    if record::named(&scene) != take.header().meshes {
        let name = path.display();
        return Err(Failure::usage(Sentence::new(
            format!("{name}: デザインが、記録したときと違う形になります。記録し直してください"),
            format!(
                "{name}: its design is sewn otherwise than when it was recorded; record it again"
            ),
        )));
    }
    scene.frame_rate = take.header().frame_rate;
    scene.frame_count = take.whole_count();
    Ok(take.with_scene(scene))
}

fn looks(design: &Design, production: &Production) -> Result<Looks, Failure> {
    Looks::new(design, production).map_err(Failure::error)
}

/// Writes every form; all files appear at the end, or none.
fn write(
    (staged, production, covers): (StagedTake<BufReader<File>>, &Production, &[Cover]),
    formats: &[ExportFormat],
    (output, language, stop): (OutputFolder, Language, &AtomicBool),
) -> Result<(Vec<PathBuf>, Vec<ClothFit>), Failure> {
    let scene = staged.scene();
    let meshes = u32::try_from(scene.meshes.len()).unwrap_or(u32::MAX);
    let forms = u32::try_from(formats.len()).unwrap_or(u32::MAX);
    let steps = forms.saturating_mul(meshes.saturating_mul(scene.frame_count));
    let bar = progress_bar(steps, language.pick("書き出す", "writing"));
    let mut take = Watched {
        take: staged,
        bar: &bar,
        stop,
    };
    let mut files = Files(output);
    let mut fits = Vec::new();
    for &format in formats {
        if let Some(form) = form(format) {
            let written = write_take(form, &mut take, &mut files);
            written.map_err(|error| written::failure(&error, stop))?;
        } else {
            let glb = take_glb(production, covers, &mut take);
            check(stop)?;
            let glb = glb.map_err(Failure::error)?;
            files.0.write(GLB, &glb.bytes).map_err(Failure::error)?;
            fits = glb.fits;
        }
    }
    let paths = files.0.finish().map_err(Failure::error)?;
    bar.finish_and_clear();
    Ok((paths, fits))
}

/// The form as the library writes it; the one with bones needs the production.
const fn form(format: ExportFormat) -> Option<TakeFormat> {
    match format {
        ExportFormat::Glb => None,
        ExportFormat::Usd => Some(TakeFormat::Usd),
        ExportFormat::Usdz => Some(TakeFormat::Usdz),
        ExportFormat::Pc2 => Some(TakeFormat::Pc2),
        ExportFormat::Mdd => Some(TakeFormat::Mdd),
        ExportFormat::Obj => Some(TakeFormat::Obj),
        ExportFormat::Npz => Some(TakeFormat::Npz),
        ExportFormat::Csv => Some(TakeFormat::Csv),
    }
}
