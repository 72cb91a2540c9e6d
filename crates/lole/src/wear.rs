//! `lole wear`: a garment sewn from another program's pattern, danced as a design is.

use lole_costume::document::schema::LIST;
use lole_costume::document::{GarmentDesign, PrintChoice};
use lole_costume::fabrics::{PRESETS, Preset};
use lole_garment::given;
use lole_language::{Language, words};
use lole_print::PrintMotif;

use crate::args::{DanceArgs, GroupArgs, WearArgs};
use crate::{Failure, dance, source};

/// Runs the command.
pub(crate) fn run(args: WearArgs, language: Language) -> Result<(), Failure> {
    let file = lole_files::linked_pattern(&args.pattern, "PATTERN").map_err(Failure::usage)?;
    let mut source = source::read(args.dancer.as_deref())?;
    source.put(args.avatar.as_deref(), args.motion.as_deref())?;
    source.measure(args.measures.as_deref())?;
    let design = &mut source.design;
    let mut garment = GarmentDesign::new(&given::TEMPLATE);
    garment.file = Some(file);
    if args.dancer.is_some() {
        garment.fabric = design.fabric.clone();
        garment.print = design.print.clone();
    } else {
        garment.print = PrintChoice {
            motif: PrintMotif::Plain,
            ..PrintChoice::default()
        };
    }
    if let Some(name) = &args.fabric {
        let ids: Vec<&str> = PRESETS.iter().map(|preset| preset.id).collect();
        let preset = Preset::from_id(name);
        garment.fabric.preset =
            preset.ok_or_else(|| dance::unknown("--fabric", name, words("布", "fabric"), &ids))?;
    }
    let chosen = args.size_ratio.map(|ratio| (given::SIZE_KEY, ratio));
    design.garments = vec![garment.with(chosen.as_slice())];
    design.skirt.is_worn = false;
    source.replaces(LIST);
    let wishes = DanceArgs {
        design: args.dancer,
        out: args.out,
        seconds: args.seconds,
        step: args.step,
        bpm: args.bpm,
        method: None,
        avatar: args.avatar,
        measures: args.measures,
        motion: args.motion,
        audio: None,
        size: args.size,
        threads: args.threads,
        seed: None,
        cpu: args.cpu,
        json: args.json,
        group: GroupArgs::default(),
    };
    dance::lay_over(&mut source.design, &wishes)?;
    dance::perform(&wishes, source, language)
}
