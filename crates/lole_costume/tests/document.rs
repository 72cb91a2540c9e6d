//! Laws of the design document: what is written reads back, and what is wrong is said in one
//! sentence with file, line and remedy.

use lole_costume::document::schema::{Kind, TABLES};
use lole_costume::document::{Design, MethodName, Place, locate, parse, parse_bytes, to_toml};
use lole_pattern::{TailorTape, Tailored};
use proptest::prelude::*;

/// The sentence for a document that must be refused.
fn sentence(text: &str) -> String {
    let error = parse(text, "mine.lole").expect_err(text);
    error.to_string()
}

/// Replaces one line of the built-in document, or adds it to the end of its table.
fn with_line(table: &str, line: &str) -> String {
    format!("lole = 1\n\n[{table}]\n{line}\n")
}

#[test]
fn an_empty_document_is_the_built_in_design() {
    assert_eq!(parse("lole = 1", "mine.lole").unwrap(), Design::default());
    assert_eq!(
        parse("\u{feff}lole = 1\r\n", "mine.lole").unwrap(),
        Design::default()
    );
}

#[test]
fn the_built_in_design_reads_back_and_is_in_range() {
    let text = to_toml(&Design::default());
    assert!(text.starts_with("lole = 1\n"), "{text}");
    assert_eq!(parse(&text, "built-in").unwrap(), Design::default());
    Design::default().check("built-in").unwrap();
}

/// Table, line that is wrong, start of what is said, and the remedy.
const MISTAKES: &[(&str, &str, &str, &str)] = &[
    (
        "skirt",
        "hem_hight_cm = 22",
        ":4: [skirt] hem_hight_cm: ",
        "did you mean hem_height_cm?",
    ),
    (
        "skirt",
        "hem_height = 22",
        ":4: [skirt] hem_height: ",
        "did you mean hem_height_cm?",
    ),
    (
        "skirt",
        "zzz = 1",
        ":4: [skirt] zzz: ",
        "the keys of this table are worn, hem_height_cm, ",
    ),
    (
        "skrit",
        "",
        ":3: [skrit]: there is no such table",
        "did you mean skirt?",
    ),
    (
        "skirt",
        "hem_height_cm = -3",
        ":4: [skirt] hem_height_cm: -3 is",
        "a number from 0 to 100",
    ),
    (
        "skirt",
        "hem_height_cm = 1e9",
        ":4: [skirt] hem_height_cm: 1e9 is",
        "from 0 to 100",
    ),
    (
        "skirt",
        "hem_height_cm = nan",
        ":4: [skirt] hem_height_cm: nan is",
        "from 0 to 100",
    ),
    (
        "skirt",
        "hem_height_cm = inf",
        ":4: [skirt] hem_height_cm: inf is",
        "from 0 to 100",
    ),
    (
        "skirt",
        "hem_height_cm = -inf",
        ":4: [skirt] hem_height_cm: -inf is",
        "from 0 to 100",
    ),
    (
        "skirt",
        "hem_height_cm = \"22\"",
        "\"22\" is a text; write a number",
        "from 0 to 100",
    ),
    (
        "skirt",
        "hem_height_cm = true",
        "true is a yes-or-no value",
        "a number from 0 to 100",
    ),
    (
        "skirt",
        "hem_height_cm = [22]",
        "[22] is a list",
        "a number from 0 to 100",
    ),
    (
        "skirt",
        "hem_height_cm = 2026-11-21",
        "2026-11-21 is a date",
        "a number from 0",
    ),
    (
        "skirt",
        "hem_height_cm = 99999999999999999999999",
        "is out of range",
        "from 0 to 100",
    ),
    (
        "skirt",
        "gather_ratio = 0.5",
        ":4: [skirt] gather_ratio: 0.5 is",
        "from 1 to 5",
    ),
    (
        "skirt",
        "elastic_row_count = 2.5",
        "2.5 is a number with a point",
        "whole number from 1 to 6",
    ),
    (
        "skirt",
        "elastic_row_count = -1",
        "-1 is out of range",
        "a whole number from 1 to 6",
    ),
    (
        "skirt",
        "seed = 9223372036854775808",
        "is out of range",
        "from 0 to 9223372036854775807",
    ),
    (
        "motion",
        "step = \"kahollo\"",
        "\"kahollo\" is not a dance step; did you mean \"kaholo\"?",
        "kao, kaholo, ami, uwehe",
    ),
    (
        "motion",
        "step = 3",
        "3 is a whole number",
        "the name of a dance step",
    ),
    (
        "method",
        "name = \"fb_euler\"",
        "\"fb_euler\" is not a method",
        "\"fb-euler\"",
    ),
    (
        "fabric",
        "preset = \"broadcloth\"",
        "is not a fabric",
        "\"polycotton-broadcloth\"",
    ),
    (
        "print",
        "ground = \"red\"",
        "\"red\" is not a color",
        "a color such as \"#9e1026\"",
    ),
    (
        "print",
        "ground = \"#12345\"",
        "is not a color",
        "a color such as",
    ),
    (
        "dancer",
        "hip_cm = 910",
        ":4: [dancer] hip_cm: 910 is",
        "from 55 to 150",
    ),
    (
        "dancer",
        "stature_cm = 190\ninseam_cm = 55",
        ":3: [dancer]: ",
        "measure both again",
    ),
    (
        "dancer",
        "hip_cm = 90\nthigh_cm = 80",
        ":3: [dancer]: thigh girth 80.0 cm and hip girth 90.0 cm exclude each other",
        "measure both again",
    ),
    (
        "dancer",
        "figure = \"boy\"",
        ":4: [dancer] figure: \"boy\" is not a figure",
        "the choices are of-stature, woman, man, child",
    ),
    (
        "dancer",
        "hip_cm = 90\nhip_cm = 91",
        ":5: this is not TOML",
        "mend the line",
    ),
    (
        "dancer",
        "hip_cm = ",
        ":4: this is not TOML",
        "mend the line",
    ),
];

#[test]
fn every_mistake_has_its_line_its_place_and_its_remedy() {
    for (table, line, start, remedy) in MISTAKES.iter().copied() {
        let sentence = sentence(&with_line(table, line));
        assert!(sentence.starts_with("mine.lole:"), "{sentence}");
        assert!(sentence.contains(start), "{sentence}\n lacks {start}");
        assert!(sentence.contains(remedy), "{sentence}\n lacks {remedy}");
        assert!(!sentence.contains('\n'), "{sentence}");
    }
}

#[test]
fn the_version_comes_first() {
    for (text, expected) in [
        (
            "",
            "mine.lole:1: the version is missing; begin the document with the line lole = 1",
        ),
        (
            "[dancer]\nhip_cm = 91\n",
            "mine.lole:1: the version is missing",
        ),
        (
            "lole = 2\n[garment]\nnew_key = 1",
            "mine.lole:1: lole: the document has version 2",
        ),
        (
            "# mine\n\nlole = 0",
            "mine.lole:3: lole: 0 is not a version; write lole = 1",
        ),
        ("lole = \"1\"", "\"1\" is not a version"),
        ("lole = -1", "-1 is not a version"),
        ("lole = 1.0", "1.0 is not a version"),
    ] {
        let sentence = sentence(text);
        assert!(sentence.contains(expected), "{sentence}\n lacks {expected}");
    }
    assert!(sentence("lole = 2").contains("install a newer Lole"));
}

#[test]
fn the_mistake_nearest_the_top_is_the_one_reported() {
    let text = "lole = 1\n[wind]\nspeed_m_per_s = -1\n[dancer]\nhips = 3\n";
    assert!(sentence(text).starts_with("mine.lole:3: [wind] speed_m_per_s"));
}

#[test]
fn tables_may_be_written_in_any_way_toml_has() {
    let expected = parse("lole = 1\n[skirt]\nhem_height_cm = 25\n", "a").unwrap();
    for text in [
        "lole = 1\nskirt.hem_height_cm = 25.0",
        "lole = 1\nskirt = { hem_height_cm = 2.5e1 }",
        "lole = 1\n[\"skirt\"]\n'hem_height_cm' = 0x19",
    ] {
        assert_eq!(parse(text, "b").unwrap(), expected, "{text}");
    }
    assert!(sentence("lole = 1\nskirt = 25").contains("25 is a whole number; write a table"));
    assert!(sentence("lole = 1\n[[skirt]]\n").contains("a list; write a table"));
}

#[test]
fn text_in_another_encoding_is_said_with_its_line() {
    let shift_jis = b"lole = 1\n# \x83\x8d\x83\x8c\n";
    let sentence = parse_bytes(shift_jis, "mine.lole").unwrap_err().to_string();
    assert_eq!(
        sentence,
        "mine.lole:2: the text is not UTF-8; save the document again as UTF-8"
    );
    assert!(parse_bytes(b"lole = 1", "mine.lole").is_ok());
}

#[test]
fn a_file_that_is_no_document_is_refused_before_it_is_read() {
    let film = "x".repeat(2 << 20);
    assert!(sentence(&film).contains("is this the right file?"));
}

#[test]
fn every_key_ends_in_its_unit_or_says_that_it_has_none() {
    let units = [
        "_cm",
        "_mm",
        "_s",
        "_deg",
        "_bpm",
        "_m_per_s",
        "_g_per_m2",
        "_n_per_m",
        "_un_m",
        "_per_s",
        "_mn",
        "_m",
        // Prices, in the document's currency.
        "_price",
        "_price_per_m",
        "_price_per_spool",
        "_price_per_100g",
        "price_per_m",
        "price_per_yd",
        "_per_h",
        "_px",
        "_years",
    ];
    let bare = ["_ratio", "_coefficient", "_count"];
    // All features of a face are from -1 to 1, which their table says.
    for table in TABLES.iter().filter(|table| table.name != "face") {
        for key in table.keys {
            match key.kind {
                Kind::Number { .. } | Kind::Count { .. } if key.name != "seed" => assert!(
                    units
                        .iter()
                        .chain(&bare)
                        .any(|ending| key.name.ends_with(ending)),
                    "{}",
                    key.name
                ),
                _ => {}
            }
        }
    }
}

/// What patterns alone go by goes with any tape.
fn is_tailored(name: &str) -> bool {
    Tailored::ALL.iter().any(|tailored| tailored.key() == name)
}

/// What is taken for drafting reads back to the last bit, and is left out where it was not taken; an avatar has
/// its own.
#[test]
fn what_is_taken_for_drafting_reads_back_alone() {
    for tailored in Tailored::ALL {
        let [least, most] = tailored.band_cm();
        for cm in [least, 0.3 * least + 0.7 * most, most] {
            let text = with_line("dancer", &format!("{} = {cm:?}", tailored.key()));
            let design = parse(&text, "mine.lole").unwrap();
            let taken = TailorTape::NONE.with_cm(tailored, Some(cm));
            assert_eq!(design.dancer.tailor_tape, taken);
            assert_eq!(parse(&to_toml(&design), "again").unwrap(), design);
            let with_file = format!("{text}file = \"hina.vrm\"\n");
            assert!(sentence(&with_file).contains(tailored.key()), "{with_file}");
        }
        for cm in [least - 0.1, most + 0.1] {
            let text = with_line("dancer", &format!("{} = {cm}", tailored.key()));
            let place = format!("mine.lole:4: [dancer] {}: ", tailored.key());
            assert!(sentence(&text).starts_with(&place), "{text}");
        }
        assert!(!to_toml(&Design::default()).contains(tailored.key()));
    }
}

/// Marks on a photo go together, and with a photo; their own tests vary them.
fn is_photo_mark(name: &str) -> bool {
    name.starts_with("known_") || name.starts_with("crop_")
}

#[test]
fn every_key_reads_back_alone_at_both_ends_of_its_range() {
    for table in TABLES.iter().filter(|table| table.name != "dancer") {
        for key in table.keys.iter().filter(|key| !is_photo_mark(key.name)) {
            let values: Vec<String> = match &key.kind {
                Kind::Number { min, max, .. } => vec![format!("{min:?}"), format!("{max:?}")],
                Kind::Count { min, max, .. } => vec![min.to_string(), max.to_string()],
                Kind::Name { choices, .. } => {
                    choices().iter().map(|name| format!("{name:?}")).collect()
                }
                Kind::Text { .. } => vec!["\"踊り 1.bvh\"".to_owned(), r#"'a\b"c'"#.to_owned()],
                Kind::Color { .. } => vec!["\"#00ff7A\"".to_owned()],
            };
            for value in values {
                let text = with_line(table.name, &format!("{} = {value}", key.name));
                let design = parse(&text, "mine.lole").unwrap();
                design.check("mine").unwrap();
                assert_eq!(parse(&to_toml(&design), "again").unwrap(), design, "{text}");
            }
        }
    }
}

#[test]
fn a_design_changed_by_the_program_is_held_to_the_same_ranges() {
    let mut design = Design::default();
    design.motion.tempo_bpm = f64::NAN;
    let sentence = design.check("command line").unwrap_err().to_string();
    assert_eq!(
        sentence,
        "command line: [motion] tempo_bpm: NaN is out of range; write a number from 30 to 240"
    );
}

#[test]
fn figures_measured_on_the_real_cloth_replace_the_preset() {
    let design = parse(
        "lole = 1\n[fabric]\npreset = \"barkcloth\"\nbend_warp_un_m = 500\nareal_density_g_per_m2 = 110\n",
        "mine.lole",
    )
    .unwrap();
    let fabric = design.fabric.fabric();
    let preset = design.fabric.preset.fabric();
    assert!((fabric.bend[0] - 500e-6).abs() < 1e-9);
    assert!((fabric.bend[1] - preset.bend[1]).abs() < f32::EPSILON);
    // Twice the root of a fourfold rigidity; half the weight is slowed twice as fast.
    assert!((fabric.twist / preset.twist - 2.0).abs() < 1e-5);
    assert!((fabric.drag_rate / preset.drag_rate - 2.0).abs() < 1e-5);
}

#[test]
fn wind_pressure_is_that_of_the_air_speed() {
    let design = parse("lole = 1\n[wind]\nspeed_m_per_s = 10", "mine.lole").unwrap();
    assert!((design.wind.pressure() - 60.2).abs() < 1e-9);
    assert!(Design::default().wind.pressure().abs() < f64::EPSILON);
}

#[test]
fn a_mistake_found_while_sewing_is_blamed_on_its_line() {
    let text = "lole = 1\n\n[skirt]\ngather_ratio = 4\nhem_height_cm = 84\n";
    for (table, key, expected) in [
        (
            "skirt",
            "hem_height_cm",
            "mine.lole:5: [skirt] hem_height_cm: too short; lower it",
        ),
        (
            "skirt",
            "header_cm",
            "mine.lole:3: [skirt] header_cm: too short; lower it",
        ),
        ("skirt", "", "mine.lole:3: [skirt]: too short; lower it"),
        (
            "dancer",
            "hip_cm",
            "mine.lole:1: [dancer] hip_cm: too short; lower it",
        ),
    ] {
        let sentence =
            lole_language::Sentence::new("短すぎます。下げてください", "too short; lower it");
        let error = locate(text, "mine.lole", Place { table, key }, sentence);
        assert_eq!(error.to_string(), expected);
    }
}

#[test]
fn designs_in_the_readmes_can_be_read() {
    for (name, text) in [
        ("README.md", include_str!("../../../README.md")),
        ("README.ja.md", include_str!("../../../README.ja.md")),
        ("hula.md", include_str!("../../../docs/hula.md")),
        ("cloth.md", include_str!("../../../docs/cloth.md")),
    ] {
        let samples: Vec<&str> = text
            .split("```toml\n")
            .skip(1)
            .filter_map(|rest| rest.split_once("```").map(|(sample, _)| sample))
            .collect();
        assert!(!samples.is_empty(), "{name}");
        for sample in samples {
            parse(sample, name).unwrap();
        }
    }
}

#[test]
fn method_names_read_back() {
    for method in MethodName::ALL {
        assert_eq!(MethodName::from_id(method.id()), Some(method));
    }
}

/// A design with arbitrary values in range.
fn any_design() -> impl Strategy<Value = Design> {
    let key_count = TABLES.iter().map(|table| table.keys.len()).sum::<usize>();
    proptest::collection::vec((any::<bool>(), 0.0..=1.0_f64, any::<u64>()), key_count).prop_map(
        |choices| {
            let mut design = Design::default();
            let keys = TABLES
                .iter()
                .flat_map(|table| table.keys.iter().map(move |key| (table, key)));
            for ((table, key), (chosen, share, bits)) in keys.zip(choices) {
                // The tape must fit together, so only its hip is varied here.
                let is_body = table.name == "dancer" && key.name != "hip_cm";
                let together = (is_body && !is_tailored(key.name)) || is_photo_mark(key.name);
                if !chosen || together {
                    continue;
                }
                match &key.kind {
                    Kind::Number { min, max, set, .. } => {
                        set(&mut design, (min + (max - min) * share).clamp(*min, *max));
                    }
                    Kind::Count { min, max, set, .. } => set(&mut design, min + bits % (max - min)),
                    Kind::Name { choices, set, .. } => {
                        let names = choices();
                        let index = bits % names.len() as u64;
                        set(
                            &mut design,
                            names[usize::try_from(index).expect("a list's index")],
                        );
                    }
                    Kind::Text { set, .. } => set(&mut design, &format!("\"{bits}\\.bvh")),
                    Kind::Color { set, .. } => {
                        let [red, green, blue, ..] = bits.to_le_bytes();
                        set(&mut design, [red, green, blue]);
                    }
                }
            }
            design
        },
    )
}

#[test]
fn friction_on_cloth_is_its_own_key_and_old_documents_mean_both_by_one() {
    let frictions = |keys: &str| {
        let text = format!("lole = 1\n[fabric]\npreset = \"polyester-satin\"\n{keys}");
        let fabric = parse(&text, "mine.lole").unwrap().fabric.fabric();
        [fabric.friction, fabric.cloth_friction]
    };
    assert_eq!(frictions(""), [0.3, 0.25]);
    assert_eq!(frictions("friction_coefficient = 0.4"), [0.4, 0.4]);
    assert_eq!(frictions("cloth_friction_coefficient = 0.2"), [0.3, 0.2]);
    let both = "friction_coefficient = 0.4\ncloth_friction_coefficient = 0.2";
    assert_eq!(frictions(both), [0.4, 0.2]);
}

#[test]
fn hysteresis_follows_the_stiffness_until_it_is_given() {
    let hysteresis = |keys: &str| {
        let text = format!("lole = 1\n[fabric]\npreset = \"barkcloth\"\n{keys}");
        parse(&text, "mine.lole")
            .unwrap()
            .fabric
            .fabric()
            .hysteresis
    };
    let near = |found: f32, expected: f32| (found / expected - 1.0).abs() < 1e-5;
    let preset = hysteresis("");
    assert!(near(preset.bend[0], 10.0e-3) && near(preset.shear, 5.2));
    let softer = hysteresis("bend_warp_un_m = 12.5\nshear_n_per_m = 10.5");
    assert!(near(softer.bend[0], 1.0e-3) && near(softer.bend[1], 10.0e-3));
    assert!(near(softer.shear, 0.52));
    let given = hysteresis(
        "bend_hysteresis_warp_mn = 2.0\nbend_hysteresis_weft_mn = 3.0\nshear_hysteresis_n_per_m = 0.0",
    );
    assert!(near(given.bend[0], 2.0e-3) && near(given.bend[1], 3.0e-3));
    assert!(given.shear <= 0.0);
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(128) })]

    #[test]
    fn any_design_reads_back_to_the_last_bit(design in any_design()) {
        let text = to_toml(&design);
        let again = parse(&text, "again").map_err(|error| TestCaseError::fail(error.to_string()))?;
        prop_assert_eq!(&again, &design);
        prop_assert_eq!(to_toml(&again), text);
    }

    #[test]
    fn arbitrary_bytes_never_panic(bytes in proptest::collection::vec(any::<u8>(), 0..400)) {
        let _either = parse_bytes(&bytes, "mine.lole");
    }

    #[test]
    fn arbitrary_text_that_looks_like_a_document_never_panics(
        text in "(lole = 1\n)?(\\[?(dancer|skirt|fabric|[a-z.]{0,3})\\]?\n)?([a-z_\"']{0,9} ?= ?[-+0-9a-f_.xe\"'{}\\[\\], \n#]{0,30}\n?){0,4}"
    ) {
        if let Err(error) = parse(&text, "mine.lole") {
            prop_assert!(error.line.is_some());
            prop_assert!(!error.to_string().contains('\n'));
        }
    }

    #[test]
    fn a_mutated_document_reads_or_is_refused_with_its_line(
        position in any::<prop::sample::Index>(),
        inserted in "[ -~\n\u{30ed}]{0,3}",
        removed in 0..4_usize,
    ) {
        let text = to_toml(&Design::default());
        let characters: Vec<char> = text.chars().collect();
        let start = position.index(characters.len());
        let end = (start + removed).min(characters.len());
        let mutated: String = characters[..start]
            .iter()
            .copied()
            .chain(inserted.chars())
            .chain(characters[end..].iter().copied())
            .collect();
        match parse(&mutated, "mine.lole") {
            Ok(design) => prop_assert!(design.check("mutated").is_ok()),
            Err(error) => {
                let line = error.line.unwrap_or(0);
                prop_assert!((1..=mutated.lines().count().max(1) + 1).contains(&line));
                let sentence = error.to_string();
                prop_assert!(sentence.starts_with(&format!("mine.lole:{line}: ")), "{}", sentence);
                prop_assert!(!sentence.contains('\n'), "{}", sentence);
            }
        }
    }
}

#[test]
fn a_school_sets_what_is_left_out_wherever_it_stands() {
    let design = parse(
        "lole = 1\n[motion]\nknee_deg = 50\nschool = \"kahiko-kane\"\n",
        "mine.lole",
    )
    .unwrap();
    assert_eq!(design.motion.school.id, "kahiko-kane");
    assert!((design.motion.knee_deg - 50.0).abs() < f64::EPSILON);
    assert!((design.motion.stance_ratio - 0.22).abs() < f64::EPSILON);
    assert_eq!(parse(&to_toml(&design), "again").unwrap(), design);
}

#[test]
fn the_built_in_dance_is_that_of_the_first_school() {
    let settings = Design::default().motion_settings();
    assert_eq!(settings, lole_hula::MotionSettings::default());
}

const CHOREOGRAPHY: &str = "lole = 1

[motion]
tempo_bpm = 72

[[motion.part]]
step = \"kaholo\"
beat_count = 16

[[motion.part]]
step = \"ami\"
side = \"left\"
beat_count = 8
facing_deg = 45
arms = \"hands-on-hips\"
tempo_bpm = 96.5
";

#[test]
fn a_choreography_reads_back() {
    let design = parse(CHOREOGRAPHY, "mine.lole").unwrap();
    let parts = &design.motion.parts;
    assert_eq!(parts.len(), 2);
    assert_eq!(parts[0].beat_count, 16);
    assert_eq!(parts[1].tempo_bpm, Some(96.5));
    assert_eq!(parse(&to_toml(&design), "again").unwrap(), design);
    design.check("mine").unwrap();
    let settings = design.motion_settings();
    assert_eq!(settings.parts[1].beats_per_minute, Some(96.5));
}

#[test]
fn mistakes_in_a_choreography_are_said_with_their_part() {
    for (from, to, expected) in [
        (
            "beat_count = 16",
            "beat_cout = 16",
            "mine.lole:8: [[motion.part]] 1 beat_cout: there is no such key; did you mean beat_count?",
        ),
        (
            "beat_count = 16",
            "beat_count = 6",
            "mine.lole:8: [[motion.part]] 1 beat_count: part 1 dances kaholo for 6 counts, and its phrases have 4; write a multiple of 4, up to 256",
        ),
        (
            "beat_count = 16",
            "beat_count = 0",
            "mine.lole:8: [[motion.part]] 1 beat_count: 0 is out of range; write a whole number from 1 to 256",
        ),
        (
            "\"ami\"",
            "\"amy\"",
            "mine.lole:11: [[motion.part]] 2 step: \"amy\" is not a dance step; did you mean \"ami\"?",
        ),
        (
            "facing_deg = 45",
            "facing_deg = 300",
            "mine.lole:14: [[motion.part]] 2 facing_deg: part 2 faces 300° away",
        ),
        (
            "side = \"left\"",
            "side = \"lft\"",
            "did you mean \"left\"?",
        ),
        (
            "tempo_bpm = 96.5",
            "tempo_bpm = 9",
            "[[motion.part]] 2 tempo_bpm: 9 is out of range; write a number from 30 to 240",
        ),
        (
            "[[motion.part]]\nstep = \"kaholo\"\nbeat_count = 16\n\n[[motion.part]]",
            "part = 3\n[motion.parts]",
            "[[motion.part]] 1: 3 is a whole number; write parts that begin with [[motion.part]] each",
        ),
    ] {
        let text = CHOREOGRAPHY.replacen(from, to, 1);
        let said = sentence(&text);
        assert!(said.contains(expected), "{said}\n{text}");
    }
}

#[test]
fn a_choreography_is_as_long_as_its_parts() {
    let design = parse(CHOREOGRAPHY, "mine.lole").unwrap();
    let measurements = lole_body::Measurements::woman();
    let skeleton = lole_body::Dancer::new(&measurements).unwrap().skeleton;
    let dance = lole_hula::Dance::new(&skeleton, &design.motion_settings()).unwrap();
    // 18 beats of 5/6 s, two that shrink, eight of 60/96.5 s.
    let truth = 18.0 * 60.0 / 72.0 + 60.0 / 72.0 + 60.0 / 96.5 + 8.0 * 60.0 / 96.5;
    assert!((design.duration_s(dance.duration()) - truth).abs() < 1e-6);
    let mut short = design.clone();
    short.motion.duration_s = Some(5.0);
    assert!((short.duration_s(dance.duration()) - 5.0).abs() < f64::EPSILON);
}

#[test]
fn yes_and_no_may_be_said_as_toml_says_them() {
    let answers = [
        ("true", true),
        ("false", false),
        ("\"yes\"", true),
        ("\"no\"", false),
    ];
    for (word, is_worn) in answers {
        let text = format!("lole = 1\n[skirt]\nworn = {word}\n[[garment]]\nkind = \"muumuu\"\n");
        let design = parse(&text, "a.lole").unwrap();
        assert_eq!(design.skirt.is_worn, is_worn, "{word}");
    }
    for key in ["hem_height_cm", "fabric"] {
        let text = format!("lole = 1\n[skirt]\n{key} = true\n");
        assert!(parse(&text, "a.lole").is_err(), "{key}");
    }
}
