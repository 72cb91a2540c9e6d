//! Laws of the list of garments in a design document: it reads back, today's documents mean what they
//! meant, and what is wrong is said with file, line, key and remedy in both languages.

use lole_costume::document::schema::{FINENESS, GARMENT, Key, Kind, kind_ids};
use lole_costume::document::{Design, GarmentDesign, GarmentLayer, MethodName, parse, to_toml};
use lole_garment::template::{OptionKind, PAU_SKIRT, PAU_TOP, TEMPLATES};
use lole_language::Bilingual;

/// The double pāʻū with its top.
fn dressed() -> Design {
    Design {
        garments: [&PAU_SKIRT, &PAU_TOP].map(GarmentDesign::new).into(),
        ..Design::default()
    }
}

#[test]
fn a_document_without_garments_wears_the_skirt_alone() {
    let design = parse("lole = 1\n[skirt]\nhem_height_cm = 25\n", "mine.lole").unwrap();
    assert!(design.garments.is_empty());
    assert_eq!(design.worn_fabrics(), [design.fabric.fabric()]);
    assert!(design.prints().eq([&design.print]));
    assert!(!to_toml(&design).contains("garment"));
}

#[test]
fn garments_read_back_to_the_last_bit() {
    let design = dressed();
    design.check("built-in").unwrap();
    let text = to_toml(&design);
    assert_eq!(parse(&text, "again").unwrap(), design);
    assert_eq!(to_toml(&parse(&text, "again").unwrap()), text);
    for kind in ["pau-skirt", "pau-top"] {
        assert!(text.contains(&format!("[[garment]]\nkind = \"{kind}\"")));
    }
}

#[test]
fn a_second_skirt_is_made_to_lie_under_the_first() {
    let skirt = GarmentDesign::of_kind("pau-skirt").unwrap();
    assert_eq!(skirt.layer, GarmentLayer::Under);
    let decided = ["hem_height_cm", "gather_ratio"].map(|key| skirt.option(key).unwrap());
    assert_eq!(decided, [14.0, 2.5]);
    assert_eq!(skirt.file_name(), "pau_underskirt");
    let own = &Design::default().skirt;
    let own = own.garment(&skirt.fabric, &skirt.print);
    assert_eq!(own.option("hem_height_cm"), Some(22.0));
    assert_eq!(own.option("worn_height_cm"), None);
}

#[test]
fn the_skirt_is_the_template_with_what_its_table_says() {
    let text = "lole = 1\n[skirt]\nhem_height_cm = 31\nworn_height_cm = 90\ngather_ratio = 3\n\
                elastic_row_count = 4\nelastic_ratio = 0.9\nheader_cm = 1\ncasing_cm = 2\n\
                casing_gap_cm = 3\nhem_allowance_cm = 6\ncolumn_count = 99\nrow_count = 33\nseed = 7\n";
    let listed = text.replace(
        "[skirt]",
        "[[garment]]\nkind = \"pau-skirt\"\nlayer = \"over\"",
    );
    let (skirt, listed) = (
        parse(text, "skirt").unwrap(),
        parse(&listed, "list").unwrap(),
    );
    let [listed] = &listed.garments[..] else {
        panic!("one garment is listed");
    };
    assert_eq!(skirt.skirt.garment(&listed.fabric, &listed.print), *listed);
}

#[test]
fn layers_lie_from_the_skin_outward_in_the_order_of_the_list() {
    let layers = ["over", "under", "over", "under"];
    let mut text = "lole = 1\n[fabric]\nareal_density_g_per_m2 = 163\n".to_owned();
    for (place, layer) in layers.iter().enumerate() {
        text += &format!(
            "[[garment]]\nkind = \"pau-skirt\"\nlayer = \"{layer}\"\n[garment.fabric]\nareal_density_g_per_m2 = 10{place}\n"
        );
    }
    let design = parse(&text, "mine.lole").unwrap();
    let fabrics = design.worn_fabrics().into_iter();
    let densities = fabrics.map(|fabric| (fabric.areal_density * 1000.0).round());
    assert_eq!(
        densities.collect::<Vec<f32>>(),
        [101.0, 103.0, 163.0, 100.0, 102.0]
    );
}

/// Every one of these keys at both ends of its range reads back.
fn check_ends<'k>(
    keys: impl Iterator<Item = &'k Key<GarmentDesign>>,
    fresh: &GarmentDesign,
) -> usize {
    let mut count = 0;
    for key in keys {
        // Marks on a photo go together, and with a photo, and a file belongs to patterns of others; their own tests
        // vary them.
        let is_tied = ["known_", "crop_"]
            .iter()
            .any(|it| key.name.starts_with(it));
        if is_tied || key.name == "file" {
            continue;
        }
        let mut ends = Vec::new();
        match &key.kind {
            Kind::Number { min, max, set, .. } => ends.extend([*min, *max].map(|value| {
                let mut garment = fresh.clone();
                set(&mut garment, value);
                garment
            })),
            Kind::Count { min, max, set, .. } => ends.extend([*min, *max].map(|value| {
                let mut garment = fresh.clone();
                set(&mut garment, value);
                garment
            })),
            Kind::Name { choices, set, .. } => ends.extend(choices().into_iter().map(|name| {
                let mut garment = fresh.clone();
                set(&mut garment, name);
                garment
            })),
            Kind::Text { set, .. } => {
                let mut garment = fresh.clone();
                set(&mut garment, "踊り \"1\".bvh");
                ends.push(garment);
            }
            Kind::Color { set, .. } => {
                let mut garment = fresh.clone();
                set(&mut garment, [0, 255, 122]);
                ends.push(garment);
            }
        }
        for garment in ends {
            let design = Design {
                garments: vec![garment],
                ..Design::default()
            };
            design.check("mine").expect("in range");
            assert_eq!(
                parse(&to_toml(&design), "again").expect("in range"),
                design,
                "{}",
                key.name
            );
            count += 1;
        }
    }
    count
}

#[test]
fn every_key_of_every_kind_reads_back_at_both_ends_of_its_range() {
    for template in TEMPLATES {
        let fresh = GarmentDesign::new(template);
        let keys = GARMENT.iter().flat_map(|table| table.keys);
        assert!(40 < check_ends(keys, &fresh));
        if fresh.is_danced() {
            assert_eq!(check_ends(FINENESS.iter(), &fresh), 6);
        }
    }
}

/// One garment of every kind.
fn drafted() -> impl Iterator<Item = GarmentDesign> {
    TEMPLATES.iter().copied().map(GarmentDesign::new)
}

#[test]
fn every_option_of_every_template_reads_back_at_both_ends_of_its_range() {
    let mut count = 0;
    for worn in drafted() {
        for (position, row) in worn.template.options.iter().enumerate() {
            let ends = match row.kind {
                OptionKind::Number { min, max, .. } => vec![Some(min), Some(max)],
                OptionKind::Count { min, max, .. } => {
                    vec![Some(f64::from(min)), Some(f64::from(max))]
                }
                OptionKind::Choice(choices) => {
                    (0..choices.len()).map(|one| Some(one as f64)).collect()
                }
            };
            for end in ends {
                let mut garment = worn.clone();
                garment.options.set(position, end);
                let design = Design {
                    garments: vec![garment],
                    ..Design::default()
                };
                design.check("mine").expect("in range");
                let text = to_toml(&design);
                assert_eq!(parse(&text, "again").expect("in range"), design, "{text}");
                count += 1;
            }
        }
    }
    assert!(100 < count, "{count}");
}

#[test]
fn every_template_is_a_kind_of_garment_and_is_seen_on_the_dancer() {
    let ids = kind_ids();
    for worn in drafted() {
        assert!(ids.contains(&worn.template.id));
        let text = format!("lole = 1\n[[garment]]\nkind = \"{}\"\n", worn.template.id);
        let design = parse(&text, "mine.lole").unwrap();
        let name = worn.template.name.english;
        assert_eq!(design.garments, [worn]);
        assert_eq!(parse(&to_toml(&design), "again").unwrap(), design);
        let garment = &design.garments[0];
        let ways = [
            garment.is_danced(),
            garment.is_dressed(),
            garment.is_adornment(),
        ];
        assert_eq!(ways.into_iter().filter(|way| *way).count(), 1, "{name}");
    }
    for (kind, ruffle, count) in [
        ("pau-kahiko", "", 1),
        ("pau-ruffle", "ruffle = \"header\"\n", 1),
        ("pau-ruffle", "ruffle = \"hem\"\n", 1),
        ("pau-ruffle", "ruffle = \"layer\"\n", 2),
        ("blouse", "", 0),
    ] {
        let text = format!("lole = 1\n[[garment]]\nkind = \"{kind}\"\n{ruffle}");
        let design = parse(&text, "mine.lole").unwrap();
        assert_eq!(
            design.garments[0].gathered_count(),
            count,
            "{kind} {ruffle}"
        );
        // The skirt is there as well.
        assert_eq!(design.worn_fabrics().len(), 1 + count);
    }
    parse(
        "lole = 1\n[method]\nname = \"fb-euler\"\n[[garment]]\nkind = \"kihei\"\n",
        "mine.lole",
    )
    .unwrap();
}

/// What follows `lole = 1`, start of what is said, and the remedy in both languages.
const MISTAKES: &[(&str, &str, [&str; 2])] = &[
    (
        "[[garment]]\nlayer = \"under\"\n",
        "mine.lole:2: [[garment]]: the kind of garment is missing",
        [
            "write kind = \"pau-skirt\"",
            "kind = \"pau-skirt\" のように",
        ],
    ),
    (
        "[[garment]]\nkind = \"pau-tops\"\n",
        "mine.lole:3: [[garment]] kind: \"pau-tops\" is not a kind of garment",
        ["did you mean \"pau-top\"?", "\"pau-top\" のことですか"],
    ),
    (
        "[[garment]]\nkind = 3\n",
        "mine.lole:3: [[garment]] kind: 3 is a whole number",
        ["pau-skirt, pau-ruffle", "pau-skirt, pau-ruffle"],
    ),
    (
        "[garment]\nkind = \"pau-top\"\n",
        "mine.lole:2: [garment]: [garment] is a table",
        ["begins with [[garment]]", "[[garment]] で始まる"],
    ),
    (
        "[[garment]]\nkind = \"pau-top\"\nhem_hight_cm = 90\n",
        "mine.lole:4: [[garment]] hem_hight_cm: there is no such key",
        ["did you mean hem_height_cm?", "hem_height_cm のことですか"],
    ),
    (
        "[[garment]]\nkind = \"pau-skirt\"\nzzz = 90\n",
        "mine.lole:4: [[garment]] zzz: there is no such key",
        [
            "the keys of this table are layer, file, hem_height_cm",
            "この表の項目は layer, file, hem_height_cm",
        ],
    ),
    (
        "[[garment]]\nkind = \"pau-skirt\"\nlayer = \"between\"\n",
        "mine.lole:4: [[garment]] layer: \"between\" is not a layer",
        ["under, over", "under, over"],
    ),
    (
        "[[garment]]\nkind = \"pau-skirt\"\n[garment.fabric]\npreset = \"silk\"\n",
        "mine.lole:5: [garment.fabric] preset: \"silk\" is not a fabric",
        ["the choices are", "選べるのは"],
    ),
    (
        "[[garment]]\nkind = \"pau-skirt\"\n[garment.print]\nrepeat_cm = 0\n",
        "mine.lole:5: [garment.print] repeat_cm: 0 is out of range",
        ["a number from 5 to 200", "5 から 200 までの数"],
    ),
    (
        "[[garment]]\nkind = \"pau-top\"\nlower_row_count = 9\n",
        "mine.lole:4: [[garment]] lower_row_count: 9 is out of range",
        ["a whole number from 0 to 3", "0 から 3 までの整数"],
    ),
    (
        "[[garment]]\nkind = \"muumu\"\n",
        "mine.lole:3: [[garment]] kind: \"muumu\" is not a kind of garment",
        ["did you mean \"muumuu\"?", "\"muumuu\" のことですか"],
    ),
    (
        "[[garment]]\nkind = \"blouse\"\npuf_ratio = 1.5\n",
        "mine.lole:4: [[garment]] puf_ratio: there is no such key",
        ["did you mean puff_ratio?", "puff_ratio のことですか"],
    ),
    (
        "[[garment]]\nkind = \"blouse\"\npuff_ratio = 9\n",
        "mine.lole:4: [[garment]] puff_ratio: 9 is out of range",
        ["a number from 1.1 to 2.2", "1.1 から 2.2 までの数"],
    ),
    (
        "[[garment]]\nkind = \"muumuu\"\nsleeve = \"pufff\"\n",
        "mine.lole:4: [[garment]] sleeve: \"pufff\" is not a choice",
        ["did you mean \"puff\"?", "\"puff\" のことですか"],
    ),
    (
        "[[garment]]\nkind = \"pau-kahiko\"\ncord_row_count = 2.5\n",
        "mine.lole:4: [[garment]] cord_row_count: 2.5 is a number with a point",
        ["a whole number from 1 to 6", "1 から 6 までの整数"],
    ),
    (
        "[[garment]]\nkind = \"kihei\"\nzzz = 1\n",
        "mine.lole:4: [[garment]] zzz: there is no such key",
        [
            "layer, file, length_cm, height_cm",
            "layer, file, length_cm, height_cm",
        ],
    ),
    (
        "[[garmnet]]\nkind = \"pau-top\"\n",
        "mine.lole:2: [garmnet]: there is no such table",
        ["did you mean garment?", "garment のことですか"],
    ),
    (
        "[method]\nname = \"fb-euler\"\n[[garment]]\nkind = \"pau-top\"\n",
        "mine.lole:2: [method]: the paper's methods move one garment alone",
        ["leave out [[garment]]", "[[garment]] を消して"],
    ),
    (
        "[[garment]]\nkind = \"pau-top\"\n[[garment]]\nkind = \"pau-top\"\n[[garment]]\nkind = \"pau-top\"\n[[garment]]\nkind = \"pau-top\"\n[[garment]]\nkind = \"pau-top\"\n",
        "mine.lole:2: [garment]: at most 4 garments",
        ["leave some out", "減らしてください"],
    ),
];

#[test]
fn a_mistake_in_a_garment_is_said_with_file_line_key_and_remedy_in_both_languages() {
    for (text, start, [english, japanese]) in MISTAKES {
        let error = parse(&format!("lole = 1\n{text}"), "mine.lole").expect_err(text);
        let sentence = error.to_string();
        assert!(sentence.starts_with(start), "{sentence}");
        assert!(sentence.contains(english), "{sentence}");
        assert!(error.japanese().contains(japanese), "{}", error.japanese());
    }
}

#[test]
fn a_garment_changed_by_the_program_is_held_to_the_same_ranges() {
    let mut design = dressed();
    if let Some(top) = design.garments.pop() {
        let top = top.with(&[("gather_ratio", f64::NAN)]);
        design.garments.push(top);
    }
    let sentence = design.check("command line").unwrap_err().to_string();
    assert_eq!(
        sentence,
        "command line: [[garment]] gather_ratio: NaN is out of range; write a number from 1 to 5"
    );
    let mut design = dressed();
    design.method.name = MethodName::Rk4;
    assert!(design.check("command line").is_err());
    let mut design = Design::default();
    let ruffle = GarmentDesign::new(TEMPLATES[1]).with(&[("ruffle_ratio", 7.0)]);
    design.garments.push(ruffle);
    assert_eq!(
        design.check("command line").unwrap_err().to_string(),
        "command line: [[garment]] ruffle_ratio: 7 is out of range; write a number from 1 to 3"
    );
}

#[test]
fn the_double_pau_of_the_documents_can_be_read() {
    let text = include_str!("../../../docs/double-pau.lole");
    let design = parse(text, "double-pau.lole").unwrap();
    assert_eq!(design.garments.len(), 2);
    assert_eq!(design.worn_fabrics().len(), 3);
}
