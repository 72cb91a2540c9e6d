//! `lole fabric`: the shelf of fabrics, and one's own cloth measured with ruler and scale.

use lole_costume::fabrics::{
    FabricFigure, Measured, Overhang, PRESETS, Preset, Provenance, Swatch, Touch,
};
use lole_language::{Language, Sentence};
use serde_json::{Value, json};

use crate::args::{FabricArgs, FabricTask};
use crate::{Failure, summary};

/// Runs the command.
pub(crate) fn run(args: &FabricArgs, language: Language) -> Result<(), Failure> {
    let (lines, value) = match args.task {
        FabricTask::List => shelf(),
        FabricTask::Measure => measure(args)?,
    };
    if args.json {
        let text = serde_json::to_string_pretty(&value).map_err(Failure::error)?;
        summary::print_json(&text);
    } else {
        summary::print_lines(&lines, language);
    }
    Ok(())
}

fn shelf() -> (Vec<Sentence>, Value) {
    let mut lines = Vec::new();
    for preset in PRESETS {
        let touch = preset.touch();
        let [words_ja, words_en] = words(&touch);
        let [warp, weft] = preset.bend.value;
        let (weight, bend) = (preset.areal_density, preset.bend);
        // What follows from a guess is one.
        let guessed = [weight.provenance, bend.provenance].contains(&Provenance::Estimated);
        let length = provenance(if guessed {
            Provenance::Estimated
        } else {
            Provenance::Derived
        });
        lines.extend([
            Sentence::new(
                format!("{}  {}", preset.id, preset.name_ja),
                format!("{}  {}", preset.id, preset.name),
            ),
            Sentence::new(format!("    {words_ja}"), format!("    {words_en}")),
            Sentence::new(
                format!(
                    "    重さ {} g/m²（{}）・曲げ たて {warp} よこ {weft} µN·m（{}）・曲げ長さ {:.1} cm（{}）",
                    weight.value,
                    provenance(weight.provenance).japanese,
                    provenance(bend.provenance).japanese,
                    touch.bending_length,
                    length.japanese,
                ),
                format!(
                    "    weight {} g/m² ({}), bending warp {warp} weft {weft} µN·m ({}), bending length {:.1} cm ({length})",
                    weight.value,
                    provenance(weight.provenance),
                    provenance(bend.provenance),
                    touch.bending_length,
                ),
            ),
        ]);
    }
    lines.push(Sentence::new(
        "推定の値は、似た布からの見積もりです。自分の布は lole fabric measure で測れます",
        "what is estimated is a guess by comparison; lole fabric measure measures your own cloth",
    ));
    let value = PRESETS.iter().map(preset_json).collect();
    (lines, value)
}

fn preset_json(preset: &Preset) -> Value {
    let one = |figure: FabricFigure<f64>| json!({ "value": figure.value, "provenance": provenance(figure.provenance).english });
    let two = |figure: FabricFigure<[f64; 2]>| json!({ "value": figure.value, "provenance": provenance(figure.provenance).english });
    json!({
        "id": preset.id,
        "name": preset.name,
        "name_ja": preset.name_ja,
        "areal_density_g_per_m2": one(preset.areal_density),
        "thickness_mm": one(preset.thickness),
        "stretch_warp_weft_n_per_m": two(preset.stretch),
        "shear_n_per_m": one(preset.shear),
        "bend_warp_weft_un_m": two(preset.bend),
        "twist_un_m": one(preset.twist),
        "bend_hysteresis_warp_weft_mn": two(preset.bend_hysteresis),
        "shear_hysteresis_n_per_m": one(preset.shear_hysteresis),
        "friction_coefficient": one(preset.friction),
        "cloth_friction_coefficient": one(preset.cloth_friction),
        "touch": touch_json(&preset.touch()),
        "source": preset.source,
    })
}

fn touch_json(touch: &Touch) -> Value {
    json!({
        "bending_length_cm": touch.bending_length,
        "drape_ratio_of_strips": touch.drape,
        "words": touch.words.iter().map(|word| word.english).collect::<Vec<_>>(),
        "words_ja": touch.words.iter().map(|word| word.japanese).collect::<Vec<_>>(),
    })
}

fn words(touch: &Touch) -> [String; 2] {
    let joined = |pick: fn(&lole_language::Words) -> &'static str, comma| {
        let all: Vec<&str> = touch.words.iter().map(pick).collect();
        all.join(comma)
    };
    [
        joined(|word| word.japanese, "・"),
        joined(|word| word.english, ", "),
    ]
}

fn provenance(provenance: Provenance) -> Sentence {
    match provenance {
        Provenance::Measured => Sentence::new("実測", "measured"),
        Provenance::Derived => Sentence::new("計算", "derived"),
        Provenance::Estimated => Sentence::new("推定", "estimated"),
    }
}

fn measure(args: &FabricArgs) -> Result<(Vec<Sentence>, Value), Failure> {
    let needed = [
        ("--length-cm", args.length_cm),
        ("--width-cm", args.width_cm),
        ("--mass-g", args.mass_g),
        ("--overhang-warp-cm", args.overhang_warp_cm),
    ];
    let others = [args.drop_warp_cm, args.overhang_weft_cm, args.drop_weft_cm];
    let given = needed.iter().map(|(_, value)| *value).chain(others);
    if given.flatten().next().is_none() {
        let lines = recipe();
        let text: Vec<Value> = lines
            .iter()
            .map(|line| json!({ "ja": line.japanese, "en": line.english }))
            .collect();
        return Ok((lines, json!({ "recipe": text })));
    }
    let missing = |option: &str| {
        Failure::usage(Sentence::new(
            format!("{option} がありません。測り方は lole fabric measure で見られます"),
            format!("{option} is missing; lole fabric measure says how to measure it"),
        ))
    };
    let [length_cm, width_cm, mass_g, overhang] =
        needed.map(|(option, value)| value.ok_or_else(|| missing(option)));
    let warp = strip(overhang?, args.drop_warp_cm, args.slope_deg);
    let weft = match (args.overhang_weft_cm, args.drop_weft_cm) {
        (Some(length), drop) => Some(strip(length, drop, args.slope_deg)),
        (None, Some(_)) => return Err(missing("--overhang-weft-cm")),
        (None, None) => None,
    };
    let swatch = Swatch {
        length_cm: length_cm?,
        width_cm: width_cm?,
        mass_g: mass_g?,
    };
    let measured = swatch.measure(warp, weft);
    let measured = measured.map_err(|error| Failure::usage(Sentence::of(&error)))?;
    Ok(result(&measured))
}

const fn strip(length_cm: f64, drop_cm: Option<f64>, slope_deg: f64) -> Overhang {
    match drop_cm {
        Some(drop_cm) => Overhang::Drop { length_cm, drop_cm },
        None => Overhang::Slope {
            length_cm,
            slope_deg,
        },
    }
}

/// What to write into the document, and how such a cloth feels.
fn result(measured: &Measured) -> (Vec<Sentence>, Value) {
    let design = measured.fabric();
    let touch = Touch::of(&design.figures());
    let [words_ja, words_en] = words(&touch);
    let [warp_cm, weft_cm] = measured.bending_length;
    let [warp, weft] = measured.bend;
    let (density_error, bend_error) = (100.0 * measured.density_error, 100.0 * measured.bend_error);
    let density = measured.areal_density;
    let toml = format!(
        "[fabric]\npreset = \"{}\"\nareal_density_g_per_m2 = {density:.0}\n\
         bend_warp_un_m = {warp:.2}\nbend_weft_un_m = {weft:.2}",
        design.preset.id
    );
    let lines = vec![
        Sentence::new(
            format!("重さ {density:.0} g/m²（±{density_error:.0} %）"),
            format!("weight {density:.0} g/m² (±{density_error:.0} %)"),
        ),
        Sentence::new(
            format!("曲げ長さ たて {warp_cm:.2} cm・よこ {weft_cm:.2} cm"),
            format!("bending length warp {warp_cm:.2} cm, weft {weft_cm:.2} cm"),
        ),
        Sentence::new(
            format!("曲げにくさ たて {warp:.1}・よこ {weft:.1} µN·m（±{bend_error:.0} %）"),
            format!("bending rigidity warp {warp:.1}, weft {weft:.1} µN·m (±{bend_error:.0} %)"),
        ),
        Sentence::new(
            format!("手ざわり: {words_ja}"),
            format!("touch: {words_en}"),
        ),
        Sentence::new(
            format!(
                "いちばん近い棚の布は {}（{}）。ほかの数値はこの布から取ります。文書に書くなら:",
                design.preset.id, design.preset.name_ja
            ),
            format!(
                "nearest on the shelf: {} ({}), which gives the other figures; for the document:",
                design.preset.id, design.preset.name
            ),
        ),
        Sentence::new(toml.clone(), toml.clone()),
    ];
    let value = json!({
        "areal_density_g_per_m2": density,
        "areal_density_error_ratio": measured.density_error,
        "bending_length_warp_weft_cm": measured.bending_length,
        "bend_warp_weft_un_m": measured.bend,
        "bend_error_ratio": measured.bend_error,
        "nearest_preset": design.preset.id,
        "touch": touch_json(&touch),
        "document": toml,
    });
    (lines, value)
}

/// How the test is done at home.
fn recipe() -> Vec<Sentence> {
    [
        (
            "用意するもの: 物差し、台所のはかり（1 g 単位）、まっすぐな机の端。",
            "You need: a ruler, a kitchen scale (1 g), and a table with a straight edge.",
        ),
        (
            "1. 布をアイロンで平らにし、50 cm × 40 cm くらいの大きさで、耳に沿った長さと幅と重さを測ります（買った布ぜんぶでもよい）。",
            "1. Iron the cloth flat. Take about 50 cm by 40 cm of it (or all you bought); measure its length along the selvage and its width, and weigh it.",
        ),
        (
            "2. 耳に沿って、幅 3 cm・長さ 25 cm の細い布を切ります（たて）。耳から耳の方向にも 1 本切ります（よこ）。端の 1 cm は使いません。",
            "2. Cut a strip 3 cm wide and 25 cm long along the selvage (warp), and another one across (weft). Keep away from the selvage itself.",
        ),
        (
            "3. 細い布を机の上に置き、物差しをのせ、いっしょにゆっくり机の端から押し出します。先が曲がって下がってきます。",
            "3. Lay a strip on the table, the ruler on top, and push both slowly over the edge. The tip bends down.",
        ),
        (
            "4. はみ出した長さの半分ほど下がったところで止め、はみ出した布の長さと、先が机の面より何 cm 下がったかを測ります。表と裏、両方の端で測り、平均します。",
            "4. Stop when the tip has come down by about half of what hangs over. Measure the length of cloth over the edge, and how far the tip is below the table. Do it with both faces and both ends, and take the mean.",
        ),
        (
            "5. 数を入れます（例）:",
            "5. Give the numbers (an example):",
        ),
        (
            "   lole fabric measure --length-cm 50 --width-cm 40 --mass-g 22 --overhang-warp-cm 3.5 --drop-warp-cm 1.9 --overhang-weft-cm 3.2 --drop-weft-cm 1.8",
            "   lole fabric measure --length-cm 50 --width-cm 40 --mass-g 22 --overhang-warp-cm 3.5 --drop-warp-cm 1.9 --overhang-weft-cm 3.2 --drop-weft-cm 1.8",
        ),
        (
            "斜面の試験器があれば、先が斜面に触れるまでの長さだけを書きます（角度は --slope-deg 41.5 か 45）。",
            "With a sloped tester give only the length at which the tip touches the slope (--slope-deg 41.5 or 45).",
        ),
    ]
    .map(|(japanese, english)| Sentence::new(japanese, english))
    .into()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_printed_for_the_document_is_read_by_it() {
        let swatch = Swatch {
            length_cm: 50.0,
            width_cm: 40.0,
            mass_g: 22.0,
        };
        let measured = swatch.measure(strip(4.0, None, 41.5), None);
        let (lines, value) = result(&measured.unwrap_or_else(|error| panic!("{error}")));
        let toml = &lines[lines.len() - 1].english;
        let design = lole_costume::document::parse(&format!("lole = 1\n{toml}\n"), "own.lole");
        let fabric = design.unwrap_or_else(|error| panic!("{error}")).fabric;
        assert_eq!(fabric.areal_density_g_per_m2, Some(110.0));
        assert_eq!(fabric.preset.id, "polycotton-broadcloth");
        assert_eq!(value["document"], json!(toml));
    }
}
