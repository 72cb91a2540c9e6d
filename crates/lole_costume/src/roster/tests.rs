//! Lists as people save them, and lists that nobody should.

use proptest::prelude::*;

use super::*;
use crate::document::GarmentDesign;

fn read_text(text: &str) -> Roster {
    read(text.as_bytes()).unwrap_or_else(|error| panic!("{error}"))
}

fn refused(text: &str) -> String {
    read(text.as_bytes()).unwrap_err().to_string()
}

/// The one problem of a list, in English.
fn problem(text: &str) -> String {
    let roster = read_text(text);
    assert_eq!(roster.problems.len(), 1, "{:?}", roster.problems);
    roster.problems[0].sentence().english
}

fn hips(roster: &Roster) -> Vec<f64> {
    let hips = roster.dancers.iter().map(RosterDancer::hip_cm);
    hips.map(|cm| (cm * 100.0).round() / 100.0).collect()
}

#[test]
fn half_width_kana_and_marks_apart_are_the_same_heads() {
    let wanted = read_text("名前,バスト,ヒップ\n花子,84,91.4\n");
    for text in [
        "名前,ﾊﾞｽﾄ,ﾋｯﾌﾟ\n花子,84,91.4\n",
        "名前,ハ\u{3099}スト,ヒッフ\u{309a}\n花子,84,91.4\n",
    ] {
        let read = read_text(text);
        assert_eq!(read.dancers, wanted.dancers, "{text}");
        assert!(read.notes.is_empty(), "{:?}", read.notes);
    }
}

/// A ZIP archive of these parts.
fn archive(parts: &[(&str, String)]) -> Vec<u8> {
    use std::io::Write as _;
    use zip::write::SimpleFileOptions;
    let mut writer = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    let packed = SimpleFileOptions::default().compression_method(zip::CompressionMethod::Deflated);
    for (name, text) in parts {
        writer.start_file(*name, packed).unwrap();
        writer.write_all(text.as_bytes()).unwrap();
    }
    writer.finish().unwrap().into_inner()
}

/// An `.ods` whose second table holds these rows.
fn ods(rows: &str) -> Vec<u8> {
    let text = format!(
        r#"<?xml version="1.0"?><office:document-content
        xmlns:office="urn:oasis:names:tc:opendocument:xmlns:office:1.0"
        xmlns:table="urn:oasis:names:tc:opendocument:xmlns:table:1.0"
        xmlns:text="urn:oasis:names:tc:opendocument:xmlns:text:1.0"><office:body><office:spreadsheet>
        <table:table table:name="Notes"><table:table-row><table:table-cell office:value-type="string">
        <text:p>aloha</text:p></table:table-cell></table:table-row></table:table>
        <table:table table:name="List">{rows}</table:table>
        </office:spreadsheet></office:body></office:document-content>"#
    );
    let kind = "application/vnd.oasis.opendocument.spreadsheet".to_owned();
    let listed = r#"<manifest:manifest
        xmlns:manifest="urn:oasis:names:tc:opendocument:xmlns:manifest:1.0"/>"#;
    archive(&[
        ("mimetype", kind),
        ("META-INF/manifest.xml", listed.to_owned()),
        ("content.xml", text),
    ])
}

fn row_of(cells: &[&str]) -> String {
    let cells = cells.iter().map(|text| {
        format!(r#"<table:table-cell office:value-type="string"><text:p>{text}</text:p></table:table-cell>"#)
    });
    format!(
        "<table:table-row>{}</table:table-row>",
        cells.collect::<String>()
    )
}

#[test]
fn the_sheet_of_a_workbook_with_heads_is_the_list() {
    let wanted = read_text("名前,身長,ヒップ\n花子,158.5,91.4\n");
    let rest = r#"<table:table-row table:number-rows-repeated="1048000"><table:table-cell
        table:number-columns-repeated="16384"/></table:table-row>"#;
    let heads = row_of(&["名前", "身長", "ヒップ"]);
    let book = ods(&format!(
        "{heads}{}{rest}",
        row_of(&["花子", "158.5", "91.4"])
    ));
    assert_eq!(read(&book).unwrap().dancers, wanted.dancers);
    assert_eq!(names(&book).unwrap(), ["花子"]);
}

#[test]
fn workbooks_that_swell_are_refused() {
    let many = r#"<table:table-row table:number-rows-repeated="900000"><table:table-cell
        office:value-type="string" table:number-columns-repeated="90"><text:p>x</text:p></table:table-cell>
        </table:table-row>"#;
    let wide = many.replace("900000", "1").replace("\"90\"", "\"16000\"");
    for (rows, why) in [
        (many, "dancers or more"),
        (wide.as_str(), "more than 500 cells"),
    ] {
        let why_not = read(&ods(rows)).unwrap_err().to_string();
        assert!(why_not.contains(why), "{why_not}");
    }
    // Whatever else fills a cell, and whatever stands between a name and what it says.
    let cell = |said: &str, text: &str| {
        format!(
            "<table:table-row><table:table-cell {said}>{text}</table:table-cell></table:table-row>"
        )
    };
    let named = [
        "office:boolean-value=\"true\"",
        "office:date-value=\"2026-01-01\"",
        "office:string-value='x>y'",
    ];
    for named in named {
        let rows = cell(
            &format!("{named}\ttable:number-columns-repeated=\n'16000'"),
            "",
        );
        let why_not = read(&ods(&rows)).unwrap_err();
        assert!(
            matches!(why_not, RosterError::TooWide { line: 1 }),
            "{named}: {why_not}"
        );
    }
    let covered = "<table:table-row><table:covered-table-cell table:number-columns-repeated='16000' \
                   office:value='1'/></table:table-row>";
    assert!(matches!(
        read(&ods(covered)),
        Err(RosterError::TooWide { .. })
    ));
    let long = format!("<text:p>{}</text:p>", "x".repeat(1 << 20));
    let often = cell("table:number-columns-repeated='400'", &long);
    assert!(matches!(read(&ods(&often)), Err(RosterError::Swells)));
    let spaces = cell("", "<text:p>a<text:s text:c='99999999999'/>b</text:p>");
    assert!(!matches!(read(&ods(&spaces)), Err(RosterError::Swells)));
    let large = archive(&[("content.xml", " ".repeat((64 << 20) + 1))]);
    assert!(large.len() < 200_000);
    assert!(matches!(read(&large), Err(RosterError::Swells)));
    assert!(matches!(
        read(&archive(&[("note.txt", "aloha".to_owned())])),
        Err(RosterError::Workbook)
    ));
}

#[test]
fn the_back_length_is_no_stature() {
    let roster = read_text("名前,身長,背丈,ヒップ\n花子,158,38,91\n");
    let dancer = &roster.dancers[0];
    assert!(dancer.tape_cm.contains(&(Measure::Stature, 158.0)));
    assert_eq!(dancer.tailor_tape.cm(Tailored::BackLength), Some(38.0));
    let alone = read_text("名前,背丈,ヒップ\n花子,38,91\n");
    assert_eq!(alone.dancers[0].tape_cm, [(Measure::Hip, 91.0)]);
    assert!(alone.notes.is_empty(), "{:?}", alone.notes);
    let mistaken = read_text("名前,背丈,ヒップ\n花子,158,91\n");
    assert!(mistaken.dancers.is_empty());
    let what = &mistaken.problems[0].what;
    assert!(what.japanese.contains("見出しを「身長」に"), "{what}");
    assert!(what.english.contains("if it is the stature"), "{what}");
}

/// What a tape around the arm says is its girth; a length is one that says so.
#[test]
fn an_upper_arm_is_a_girth_unless_it_says_length() {
    for head in [
        "upper arm",
        "Upper arm girth",
        "upper_arm_cm",
        "腕回り",
        "腕まわり",
        "上腕回り",
        "上腕（cm）",
        "二の腕",
        "biceps",
    ] {
        let roster = read_text(&format!("name,{head},hip\na,27,91\n"));
        let dancer = &roster.dancers[0];
        assert_eq!(
            dancer.tailor_tape.cm(Tailored::UpperArm),
            Some(27.0),
            "{head}"
        );
        assert_eq!(dancer.tape_cm, [(Measure::Hip, 91.0)], "{head}");
    }
    for head in [
        "upper arm length",
        "上腕長",
        "上腕の長さ",
        "upper_arm_length_cm",
    ] {
        let roster = read_text(&format!("name,{head},hip\na,29,91\n"));
        let dancer = &roster.dancers[0];
        assert_eq!(dancer.tailor_tape, TailorTape::NONE, "{head}");
        assert!(
            dancer.tape_cm.contains(&(Measure::UpperArmLength, 29.0)),
            "{head}"
        );
    }
}

/// Its name in both languages and its key of a design are heads; what it says is hers alone.
#[test]
fn what_is_taken_for_drafting_has_columns() {
    for tailored in Tailored::ALL {
        let name = tailored.name();
        let [least, most] = tailored.band_cm();
        let cm = 0.5 * (least + most);
        for head in [name.japanese, name.english, tailored.key()] {
            let roster = read_text(&format!("name,{head},hip\na,{cm},91\nb,,91\nc,900,91\n"));
            assert!(roster.notes.is_empty(), "{head}: {:?}", roster.notes);
            let [first, second] = &roster.dancers[..] else {
                panic!("{head}: {roster:?}");
            };
            assert_eq!(
                first.tailor_tape,
                TailorTape::NONE.with_cm(tailored, Some(cm))
            );
            assert_eq!(second.tailor_tape, TailorTape::NONE);
            assert!(
                roster.problems[0]
                    .column
                    .as_ref()
                    .is_some_and(|it| it.1 == head)
            );
            let mut design = Design::default();
            design.dancer.tailor_tape = TailorTape::NONE.with_cm(Tailored::Head, Some(60.0));
            assert_eq!(first.design(&design).dancer.tailor_tape, first.tailor_tape);
            assert_eq!(second.design(&design).dancer.tailor_tape, TailorTape::NONE);
        }
    }
    let inches = read_text("name,neck,hip in\na,14,36\nb,15 1/2,37\n");
    let neck = |index: usize| inches.dancers[index].tailor_tape.cm(Tailored::Neck);
    assert_eq!(neck(0), Some(14.0 * 2.54));
    assert_eq!(neck(1), Some(15.5 * 2.54));
    assert!(inches.notes[0].english.contains("read as inches"));
}

#[test]
fn encodings_and_separators_say_the_same() {
    let text = "氏名,身長(cm),ヒップ,備考\n高橋 花子,158.5,91.4,\"午前, 火曜\"\n";
    let wanted = read_text(text);
    assert_eq!(hips(&wanted), [91.4]);
    let (sjis, _, _) = encoding_rs::SHIFT_JIS.encode(text);
    let with_mark = [b"\xef\xbb\xbf", text.as_bytes()].concat();
    let utf16: Vec<u8> = "\u{feff}"
        .encode_utf16()
        .chain(text.encode_utf16())
        .flat_map(u16::to_le_bytes)
        .collect();
    for bytes in [sjis.as_ref(), &with_mark, &utf16] {
        assert_eq!(read(bytes).unwrap(), wanted);
    }
    for (separator, hip) in [("\t", "91.4"), (";", "91,4")] {
        let text = [
            "氏名",
            "身長(cm)",
            "ヒップ",
            "備考\r\n高橋 花子",
            "158.5",
            hip,
            "x\r\n",
        ];
        assert_eq!(read_text(&text.join(separator)).dancers, wanted.dancers);
    }
}

#[test]
fn lengths_are_read_as_people_write_them() {
    let text = "name,hip,stature\na,91.4,158\nb,９１．４ｃｍ,1.58 m\nc,36 in,5'2\"\nd,\"36\"\"\",5 ft 2 in\ne,914 mm,-\n";
    let roster = read_text(text);
    assert!(roster.problems.is_empty(), "{:?}", roster.problems);
    assert_eq!(hips(&roster), [91.4, 91.4, 91.44, 91.44, 91.4]);
    let stature = |index: usize| {
        let tape = roster.dancers[index].tape_cm.first().copied();
        tape.filter(|(measure, _)| *measure == Measure::Stature)
    };
    for (index, wanted) in [Some(158.0), Some(158.0), Some(157.48), Some(157.48), None]
        .into_iter()
        .enumerate()
    {
        let found = stature(index).map(|(_, cm)| (cm * 100.0).round() / 100.0);
        assert_eq!(found, wanted);
    }
}

#[test]
fn heads_say_units_in_many_ways() {
    for head in [
        "hip (in)",
        "Hip [inches]",
        "hip_in",
        "HIPS inch",
        "ヒップ（インチ）",
    ] {
        assert_eq!(
            hips(&read_text(&format!("name,{head}\na,36\n"))),
            [91.44],
            "{head}"
        );
    }
}

#[test]
fn a_hip_of_36_among_centimeters_is_a_mistake_and_alone_is_inches() {
    let told = problem("name,hip\na,91\nb,36\nc,88\n");
    assert_eq!(
        told,
        "line 3, column 2 (hip): a hip girth of 36 fits nobody; if it is in inches, write \"36 in\""
    );
    let roster = read_text("name,hip\na,38\nb,36\n");
    assert_eq!(hips(&roster), [96.52, 91.44]);
    assert!(roster.notes[0].english.contains("as inches"));
}

#[test]
fn one_bad_row_leaves_the_others() {
    for (bad, told) in [
        ("b,=B2,158", "line 3, column 2 (hip): \"=B2\" is a formula"),
        ("b,,158", "line 3, column 2 (hip): it is empty"),
        ("a,90,158", "\"a\" is on line 2 too"),
        (",90,158", "line 3, column 1 (name): there is no name"),
        ("b,wide,158", "\"wide\" is no length"),
        ("b,-5,158", "\"-5\" is no length"),
        ("b,nan,158", "\"nan\" is no length"),
        ("b,90,1e9", "\"1e9\" is no length"),
        ("b,90,15.8", "the stature is 15.8 cm"),
    ] {
        let text = format!("name,hip,stature\na,91,160\n{bad}\nc,88,150\n");
        let found = problem(&text);
        assert!(found.contains(told), "{bad}: {found}");
        assert_eq!(read_text(&text).dancers.len(), 2);
    }
}

#[test]
fn files_that_are_no_lists_are_refused_whole() {
    for (text, told) in [
        ("", "the list is empty"),
        ("\n ,\n", "the list is empty"),
        ("name,bust\na,80\n", "no column is called hip girth"),
        ("dancer?,hip\na,80\n", "no column is called name"),
        (
            "name,hip,腰囲\na,80,80\n",
            "columns 2 and 3 are both hip girth",
        ),
        (
            "name,hip\n\"a,80\nb,90\n",
            "line 2: a quotation mark opens here",
        ),
        ("PK\u{3}\u{4}etc", "a workbook"),
        ("name,\0", "no text"),
    ] {
        assert!(refused(text).contains(told), "{text}: {}", refused(text));
    }
    assert_eq!(read(&[0xff, 0x80, 0x00, 0xfd]), Err(RosterError::NoText));
    let many = format!("name,hip\n{}", "a,90\n".repeat(MOST_DANCERS + 1));
    assert!(refused(&many).contains("1001 dancers"));
}

#[test]
fn quoted_cells_keep_lines_and_their_numbers() {
    let told = problem("name,hip\n\"two\nlines\",91\nb,x\n");
    assert!(told.starts_with("line 4, column 2"), "{told}");
    assert_eq!(
        read_text("name,hip\n\"two\nlines\",91\n").dancers[0].name,
        "two lines"
    );
}

#[test]
fn a_design_is_worn_by_another_dancer_with_the_same_hem() {
    let roster = read_text("name,hip,stature,figure\na,101,171,woman\n");
    let mut design = Design::default();
    design.dancer.waist_cm = Some(60.0);
    let worn = roster.dancers[0].design(&design);
    assert_eq!(worn.dancer.hip_cm, Some(101.0));
    assert_eq!(worn.dancer.waist_cm, None);
    assert_eq!(worn.dancer.figure, Figure::Woman);
    assert_eq!(worn.skirt, design.skirt);
}

/// Everybody of a list has a face of her own, always the same one, unless the design chooses one for all.
#[test]
fn everybody_has_her_own_face_and_years() {
    let roster = read_text("氏名,ヒップ,年齢(歳)\nあや,91,６７歳\nみき,95,\naya,91,8\n");
    assert!(roster.notes.is_empty(), "{:?}", roster.notes);
    let ages: Vec<Option<f64>> = roster.dancers.iter().map(|it| it.age_years).collect();
    assert_eq!(ages, [Some(67.0), None, Some(8.0)]);
    let mut design = Design::default();
    design.dancer.age_years = Some(30.0);
    let worn: Vec<Design> = roster.dancers.iter().map(|it| it.design(&design)).collect();
    assert_eq!(worn[1].dancer.age_years, Some(30.0));
    assert_eq!(worn[0].dancer.age_years, Some(67.0));
    assert_eq!(worn[0].face, roster.dancers[0].design(&design).face);
    for [a, b] in [[0, 1], [1, 2], [0, 2]] {
        assert_ne!(worn[a].face.face(), worn[b].face.face());
    }
    design.face.features[0] = Some(0.5);
    let alike = roster.dancers.iter().map(|it| it.design(&design).face);
    assert!(alike.into_iter().all(|face| face == design.face));
}

/// What a trial has shown of one body is hers alone.
#[test]
fn alterations_are_read_by_dancer_with_their_signs() {
    let listed = "name,hip,猫背,なで肩の補正(cm),Full bust [in],sway_back_cm\n\
                  a,91,1.5,－１,1,\nb,91,,▲0.5,-0.5,2 cm\nc,91,-,,,\n";
    let roster = read_text(listed);
    assert!(
        roster.problems.is_empty() && roster.notes.is_empty(),
        "{:?} {:?}",
        roster.problems,
        roster.notes
    );
    let mut design = Design::default();
    design.alterations = design.alterations.with_cm(Alteration::FullArm, 3.0);
    let of = |index: usize| roster.dancers[index].design(&design).alterations;
    let wanted = [
        [2.54, 1.5, 0.0, -1.0, 0.0, 0.0],
        [-1.27, 0.0, 2.0, -0.5, 0.0, 0.0],
        [0.0; 6],
    ];
    for (index, wanted) in wanted.into_iter().enumerate() {
        for (one, wanted) in Alteration::ALL.into_iter().zip(wanted) {
            let found = of(index).cm(one);
            assert!((found - wanted).abs() < 1e-9, "{index} {one:?}: {found}");
        }
    }
    let told = problem("name,hip,round back\na,91,9\n");
    assert!(told.contains("from -2 to 4 cm"), "{told}");
    let told = problem("name,hip,round back\na,91,somewhat\n");
    assert!(told.contains("no length"), "{told}");
}

/// An age that is none stops nobody: it is left out, and said once for all of its lines.
#[test]
fn an_age_that_is_none_is_left_out_and_said() {
    let listed = "name,hip,age\na,91,60代\nb,91,2\nc,91,101\nd,91,-8\ne,91,nan\nf,91,sixty\ng,91,1e9\nh,91,\ni,91,100\n";
    let roster = read_text(listed);
    assert!(roster.problems.is_empty(), "{:?}", roster.problems);
    let ages: Vec<Option<f64>> = roster.dancers.iter().map(|it| it.age_years).collect();
    let mut wanted = [None; 9];
    (wanted[0], wanted[8]) = (Some(65.0), Some(100.0));
    assert_eq!(ages, wanted);
    let [note] = &roster.notes[..] else {
        panic!("{:?}", roster.notes);
    };
    assert!(
        note.english.starts_with("line 3, 4, 5, 6, 7, 8: "),
        "{note:?}"
    );
    assert!(
        note.japanese.starts_with("3、4、5、6、7、8 行目"),
        "{note:?}"
    );
}

/// A skirt worn at 88 cm by a dancer of 160 cm is worn at 96.8 cm by one of 176 cm; the hem stays.
#[test]
fn heights_on_the_body_follow_the_stature() {
    let roster = read_text("name,hip,stature\na,96,176\n");
    let mut design = Design::default();
    design.dancer.stature_cm = Some(160.0);
    design.skirt.worn_height_cm = Some(88.0);
    let listed = [
        ("pau-kahiko", "worn_height_cm"),
        ("pau-top", "hem_height_cm"),
        ("blouse", "puff_height_cm"),
    ];
    design.garments = listed
        .map(|(kind, key)| GarmentDesign::of_kind(kind).unwrap().with(&[(key, 8.0)]))
        .into();
    let worn = roster.dancers[0].design(&design);
    let heights = worn.garments.iter().zip(listed);
    let heights = heights.map(|(garment, (_, key))| garment.option(key).unwrap());
    let heights: Vec<f64> = heights.collect();
    assert!((heights[0] - 8.8).abs() < 1e-9, "{heights:?}");
    assert_eq!(heights[1..], [8.0, 8.0], "hems and puffs stay");
    let height = worn.skirt.worn_height_cm.unwrap();
    assert!((height - 96.8).abs() < 1e-9, "{height}");
    assert_eq!(worn.skirt.hem_height_cm, design.skirt.hem_height_cm);
}

#[test]
fn units_may_be_glued_to_heads_and_rulers_have_fractions() {
    let roster = read_text("名前,身長cm,ヒップ㎝,バストin\na,158,91.4,33 1/2\nb,\"150,5\",90,34\n");
    assert!(roster.notes.is_empty(), "{:?}", roster.notes);
    let tape = |index: usize, measure: Measure| {
        let tape = &roster.dancers[index].tape_cm;
        let found = tape.iter().find(|(it, _)| *it == measure);
        found.map(|&(_, cm)| cm).unwrap()
    };
    assert_eq!(tape(0, Measure::Stature), 158.0);
    assert_eq!(tape(0, Measure::Hip), 91.4);
    assert!((tape(0, Measure::Bust) - 33.5 * 2.54).abs() < 1e-9);
    assert_eq!(tape(1, Measure::Stature), 150.5);
    assert!(problem("name,hip\na,1 3/2\n").contains("length"));
}

#[test]
fn cells_beyond_the_heads_are_told() {
    let roster = read_text("name,hip\na,90,91\nb,92,,\n");
    assert_eq!(roster.dancers.len(), 2);
    assert!(
        roster.notes[0].to_string().starts_with("line 2: cells"),
        "{:?}",
        roster.notes
    );
}

/// What a form asks for is not needed to print it.
/// As schools save them: a title, an empty line, the heads, the dancers, their sums.
#[test]
fn titles_above_the_heads_and_sums_below_are_told_and_left_out() {
    let text = "フラ教室 発表会 2026,,,\n担当: 名前のない人,,,\n,,,\nNo,名前,身長,ヒップ\n1,花子,158,91.4\n2,みどり,150,85\n,合計 2名,,176.4\n平均,,154,88.2\n";
    let roster = read_text(text);
    assert!(roster.problems.is_empty(), "{:?}", roster.problems);
    assert_eq!(hips(&roster), [91.4, 85.0]);
    assert_eq!(roster.dancers[0].line, 5);
    assert_eq!(
        roster.notes[0].english,
        "Not read, since it names neither columns nor a dancer: line 1 (\"フラ教室 発表会 2026\"), line 2 (\"担当: 名前のない人\"), line 7 (\"合計 2名\"), line 8 (\"平均\")"
    );
    assert_eq!(names(text.as_bytes()).unwrap(), ["花子", "みどり"]);
    // The same list without them is the same dancers.
    let plain = read_text("No,名前,身長,ヒップ\n1,花子,158,91.4\n2,みどり,150,85\n");
    assert_eq!(hips(&plain), hips(&roster));
    assert_eq!(plain.notes.len(), 1);
    // Heads below the tenth line are not looked for, and a list without heads names its first line.
    let deep = format!("{}名前,ヒップ\n花子,91\n", "題\n".repeat(10));
    assert!(refused(&deep).starts_with("line 1: no column is called"));
    // Who is called Max or Sumire is a dancer.
    let names = read_text("name,hip\nMax,95\nSumire,91\n総子,88\n");
    assert_eq!(names.dancers.len(), 3);
}

#[test]
fn names_alone_are_a_list_for_forms() {
    let list = "氏名,ヒップ\n花子,\n,90\n 海  子 ,36\n花子,=A1\n";
    assert_eq!(names(list.as_bytes()).unwrap(), ["花子", "海 子", "花子"]);
    assert!(matches!(
        names(b"hip\n90\n"),
        Err(RosterError::MissingColumn { .. })
    ));
}

proptest! {
    #[test]
    fn no_bytes_make_it_panic(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        drop(read(&bytes));
        drop(names(&bytes));
    }

    #[test]
    fn no_list_makes_it_panic(text in "name,hip,身長\n([a-c=+@\"',;\t\r\n0-9.\\-ヒ ]{0,12},){0,40}") {
        if let Ok(roster) = read(text.as_bytes()) {
            for dancer in &roster.dancers {
                prop_assert!(lengths::fits(Measure::Hip.band_cm(), dancer.hip_cm()));
            }
        }
    }
}

#[test]
fn cells_of_an_ods_hold_their_values_and_not_their_notes() {
    let row = r#"<table:table-row><table:table-cell office:value-type="string"><office:annotation>
        <text:p>ask her</text:p></office:annotation><text:p>A &amp; B&#x3042;</text:p></table:table-cell>
        <table:table-cell office:value-type="float" office:value="158.50000001"><text:p>159</text:p>
        </table:table-cell><table:table-cell office:value="91.4"/></table:table-row>"#;
    let book = ods(&format!("{}{row}", row_of(&["名前", "身長", "ヒップ"])));
    let wanted = read_text("名前,身長,ヒップ\nA & Bあ,158.5,91.4\n");
    assert_eq!(read(&book).unwrap().dancers, wanted.dancers);
}
