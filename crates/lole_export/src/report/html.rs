//! The page: film, pictures, the skirt in a tailor's words, the run in plain words.
//!
//! Everything is in one file. Without scripts both languages show; with them, one.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;

use super::{
    ElasticHoldFacts, GarmentFacts, PageFilm, PageMedia, ReportDivergence, ReportFile,
    ReportPieceOver, RunReport, SkirtFacts,
};
use crate::page::plot::{Floor, Plot, svg};
use crate::page::text::{both, dance_step, escape, file_size, grouped, link, number};
use crate::page::{Page, Row, row, section};

/// The whole page.
pub(super) fn page(report: &RunReport, media: PageMedia<'_>) -> String {
    let name = title(report);
    let body = [
        alarm(report),
        film(media),
        stills(media),
        skirt(report),
        garments(report),
        dancer(report),
        motion(report),
        speed(report),
        plots(report),
        files(&report.files),
        settings(report),
    ]
    .concat();
    Page {
        title: &name,
        about: &about(report),
        body: &body,
        lole: &report.lole,
    }
    .html()
}

fn title(report: &RunReport) -> String {
    if report.skirt.design_name.trim().is_empty() {
        "Pāʻū".into()
    } else {
        escape(report.skirt.design_name.trim())
    }
}

/// What was danced, in one line.
fn about(report: &RunReport) -> String {
    let (step, bpm, seconds) = (
        dance_step(&report.dance_step),
        number(report.bpm, 0),
        number(report.seconds, 0),
    );
    both(
        &format!("A pāʻū skirt dancing {step}, {bpm} beats a minute, {seconds} seconds"),
        &format!("パウスカートで踊る {step}（1分間に{bpm}拍、{seconds}秒間）"),
    )
}

/// What went wrong, where everyone sees it first.
fn alarm(report: &RunReport) -> String {
    if report.finite && report.divergence.is_none() {
        return String::new();
    }
    let detail = report.divergence.as_ref();
    let detail = detail.map_or_else(String::new, where_it_broke);
    format!(
        "<section class=\"alarm\" role=\"alert\"><h3>{}</h3>{detail}</section>\n",
        both(
            "The calculation broke off. The pictures and numbers below end there.",
            "計算が途中で止まりました。下の映像と数値は、そこまでのものです。",
        ),
    )
}

/// When and at which particle a run broke off, and what to change.
fn where_it_broke(found: &ReportDivergence) -> String {
    let (time, particle) = (number(found.time_s, 2), grouped(found.particle));
    format!(
        "<p>{}</p><p>{}</p>",
        both(
            &format!("At {time} seconds, at particle {particle}."),
            &format!("{time} 秒、質点 {particle} 番で起こりました。"),
        ),
        both(&escape(&found.sentence), &escape(&found.sentence_ja)),
    )
}

fn film(media: PageMedia<'_>) -> String {
    let Some(film) = media.film else {
        return String::new();
    };
    let poster = media.stills.first().map_or_else(String::new, |still| {
        format!(
            " poster=\"data:image/jpeg;base64,{}\"",
            STANDARD.encode(still.jpeg)
        )
    });
    let source = match film {
        PageFilm::Held(bytes) => format!("data:video/mp4;base64,{}", STANDARD.encode(bytes)),
        PageFilm::Beside(name) => format!("./{}", escape(name)),
    };
    format!(
        "<video controls playsinline loop preload=\"metadata\"{poster} src=\"{source}\"></video>\n"
    )
}

fn stills(media: PageMedia<'_>) -> String {
    if media.stills.is_empty() {
        return String::new();
    }
    let figures: String = media
        .stills
        .iter()
        .map(|still| {
            format!(
                "<figure><img alt=\"{} / {}\" src=\"data:image/jpeg;base64,{}\"><figcaption>{}</figcaption></figure>\n",
                escape(still.caption_en),
                escape(still.caption_ja),
                STANDARD.encode(still.jpeg),
                both(&escape(still.caption_en), &escape(still.caption_ja)),
            )
        })
        .collect();
    format!(
        "<h2>{}</h2>\n<div class=\"stills\">\n{figures}</div>\n",
        both("From all sides", "いろいろな角度から")
    )
}

/// The dancer's measures; nothing where none were taken down.
fn dancer(report: &RunReport) -> String {
    if report.dancer.is_empty() {
        return String::new();
    }
    let rows: Vec<_> = (report.dancer.iter())
        .map(|measure| {
            let notes = match measure.given_cm {
                Some(_) => ["", ""],
                None => [
                    "Estimated: nobody measured it.",
                    "推定した値です（採寸されていません）。",
                ],
            };
            row(
                [&escape(&measure.name), &escape(&measure.name_ja)],
                format!("{} <i>cm</i>", number(measure.on_body_cm, 1)),
                notes,
            )
        })
        .collect();
    section(
        ["The dancer", "踊り手の寸法"],
        [
            "Measured on the finished body, as a tape measures.",
            "できあがった体を、巻き尺と同じ測り方で測った値です。",
        ],
        &rows,
    )
}

fn skirt(report: &RunReport) -> String {
    let skirt = &report.skirt;
    let mut rows = if skirt.is_worn {
        skirt_rows(skirt)
    } else {
        Vec::new()
    };
    for remark in skirt.warnings.iter().chain(&report.no_room) {
        rows.push(row(
            ["Worth a thought", "ご確認ください"],
            "<i>!</i>".to_owned(),
            [&escape(&remark.sentence), &escape(&remark.sentence_ja)],
        ));
    }
    if rows.is_empty() {
        return String::new();
    }
    section(
        ["The skirt", "スカートの寸法"],
        ["What to sew it from.", "縫うときに必要な寸法です。"],
        &rows,
    )
}

fn skirt_rows(skirt: &SkirtFacts) -> Vec<Row> {
    let cm = |value: f64| format!("{} <i>cm</i>", number(value, 1));
    let mut rows = vec![
        row(
            ["Cloth to buy", "用尺（必要な布の長さ）"],
            format!(
                "{} <i>m</i><span class=\"also\">{} yd</span>",
                number(skirt.cloth_needed_m, 2),
                number(skirt.cloth_needed_yd, 2),
            ),
            [
                &format!("For a bolt {} cm wide.", number(skirt.cloth_width_cm, 0)),
                &format!("布幅 {} cm の場合です。", number(skirt.cloth_width_cm, 0)),
            ],
        ),
        row(
            ["Finished length", "仕上がり丈"],
            cm(skirt.finished_length_cm),
            [
                "From the top of the ruffle at the waist to the hem.",
                "ウエストのフリルの上端から裾までの長さです。",
            ],
        ),
        row(
            ["Hem above the floor", "裾上がり"],
            cm(skirt.hem_height_cm),
            [
                "The height that was asked for, standing still.",
                "まっすぐ立ったときの、床から裾までの高さ（指定した値）です。",
            ],
        ),
        row(
            ["Gathers", "ギャザーの倍率"],
            format!("{} ×", number(skirt.gather_ratio, 2)),
            [
                &format!(
                    "The cloth is {} cm around before it is gathered, for hips of {} cm.",
                    number(skirt.flat_width_cm, 0),
                    number(skirt.hip_girth_cm, 1)
                ),
                &format!(
                    "ヒップ {} cm に対して、ギャザーを寄せる前の布の幅は {} cm です。",
                    number(skirt.hip_girth_cm, 1),
                    number(skirt.flat_width_cm, 0)
                ),
            ],
        ),
    ];
    rows.extend(skirt.elastic_hold.map(hold_row));
    for (index, length) in skirt.elastic_lengths_cm.iter().enumerate() {
        let place = index + 1;
        rows.push(row(
            [
                &format!("Elastic, row {place}"),
                &format!("ゴム {place} 段目"),
            ],
            cm(*length),
            if index == 0 {
                [
                    "Length to cut, rows counted from the top.",
                    "切るゴムの長さです。段は上から数えます。",
                ]
            } else {
                ["", ""]
            },
        ));
    }
    rows
}

/// Whether the elastics hold the skirt.
fn hold_row(hold: ElasticHoldFacts) -> Row {
    // Rounded down: longer ones hold less.
    let loosest = hold.loosest_cut_cm.map(|cut| number(cut.floor(), 0));
    let advice = match &loosest {
        Some(cut) => [
            format!(
                "Cut to {cut} cm, they would still hold half as much again as the dance pulls."
            ),
            format!("{cut} cm に切っても、踊りで引かれる力の 1.5 倍まで持ちこたえます。"),
        ],
        None => [
            "More rows of elastic, or stronger ones, are needed.".to_owned(),
            "ゴムの段を増やすか、強いゴムにしてください。".to_owned(),
        ],
    };
    let pulled = [
        format!(
            "The skirt pulls with {} N at most, and friction under its elastics holds {} N: it slides {} cm.",
            number(hold.pull_n, 0),
            number(hold.held_n, 0),
            number(hold.slid_cm, 1)
        ),
        format!(
            "踊りのなかでスカートが引く力は最大 {} N、ゴムの下の摩擦が支える力は {} N で、ずれは {} cm です。",
            number(hold.pull_n, 0),
            number(hold.held_n, 0),
            number(hold.slid_cm, 1)
        ),
    ];
    row(
        ["Do the elastics hold?", "ゴムはずり落ちないか"],
        format!("{} ×", number(hold.held_n / hold.pull_n, 1)),
        [
            &format!("{} {}", pulled[0], advice[0]),
            &format!("{}{}", pulled[1], advice[1]),
        ],
    )
}

/// Which piece of each garment lies outside; nothing where none covers itself.
fn garments(report: &RunReport) -> String {
    let covered = report.garments.iter().filter(|it| !it.over.is_empty());
    let rows: Vec<Row> = covered.flat_map(garment_rows).collect();
    if rows.is_empty() {
        return String::new();
    }
    section(
        ["What lies over what", "布の重なり"],
        [
            "Where pieces of one garment overlap: which of them lies outside, and at how many points of the cloth.",
            "一着のなかで布が重なるところで、どちらが外側になるかと、その点の数です。",
        ],
        &rows,
    )
}

fn garment_rows(garment: &GarmentFacts) -> Vec<Row> {
    let name = [&garment.name, &garment.name_ja].map(|it| escape(it));
    let places = |count: usize| format!("{} {}", grouped(count), both("points", "か所"));
    let mut rows: Vec<Row> = (garment.over.iter())
        .map(|over| {
            let [english, japanese] = said_over(over);
            row(
                [
                    &format!("{}: {}", name[0], escape(&english)),
                    &format!("{}: {}", name[1], escape(&japanese)),
                ],
                places(over.places),
                ["", ""],
            )
        })
        .collect();
    rows.push(row(
        [
            &format!("{}: the wrong way round", name[0]),
            &format!("{}: 内と外が逆の点", name[1]),
        ],
        format!(
            "{}<span class=\"also\">{} {}</span>",
            places(garment.inverted_places.worst),
            both("of", "全"),
            grouped(garment.overlapping_places)
        ),
        [
            "At the worst moment of the dance: none where everything stays as it was put on.",
            "踊りのなかでいちばん多いときの数です。着せたときのままなら 0 です。",
        ],
    ));
    rows
}

/// One piece over another, in English and Japanese.
fn said_over(over: &ReportPieceOver) -> [String; 2] {
    let ReportPieceOver {
        outer,
        outer_ja,
        inner,
        inner_ja,
        ..
    } = over;
    if over.is_itself {
        return [
            format!("{outer} over itself"),
            format!("{outer_ja}（巻き重ね・折り重ね）"),
        ];
    }
    if outer == inner {
        return [
            format!("{outer} over the other {inner}"),
            format!("もう一枚の{inner_ja}の外側に{outer_ja}"),
        ];
    }
    [
        format!("{outer} over {inner}"),
        format!("{inner_ja}の外側に{outer_ja}"),
    ]
}

fn motion(report: &RunReport) -> String {
    let hem = report.hem_height_cm;
    let pct = |value: f64| format!("{} <i>%</i>", number(value, 2));
    let stretch = [
        row(
            ["Hem above the floor, dancing", "踊っているときの裾の高さ"],
            format!(
                "{}–{} <i>cm</i><span class=\"also\">{} {} cm</span>",
                number(hem.min, 1),
                number(hem.max, 1),
                both("mean", "平均"),
                number(hem.mean, 1)
            ),
            [
                "Lowest and highest point of the hem, and the mean.",
                "裾のいちばん低いところと高いところ、平均です。",
            ],
        ),
        row(
            ["Stretch of the cloth", "布の伸び縮み"],
            pct(report.strain_pct.mean),
            [
                "Mean at the worst moment. Real cotton hardly stretches: less is better.",
                "もっとも大きい瞬間の平均です。木綿はほとんど伸びません。小さいほど本物に近い動きです。",
            ],
        ),
        row(
            ["… of 99 in 100 threads", "… 100本中99本"],
            pct(report.strain_pct.p99),
            [
                "99 of 100 threads stretch less than this.",
                "100本の糸のうち99本は、これより小さい伸びです。",
            ],
        ),
        row(
            ["… largest", "… 最大"],
            pct(report.strain_pct.max),
            [
                "The one worst thread of the whole dance.",
                "踊り全体でいちばん伸びた1か所です。",
            ],
        ),
        row(
            ["Stretch at the end", "終わりの伸び縮み"],
            format!(
                "{}<span class=\"also\">99 %: {} %</span>",
                pct(report.strain_end_pct.mean),
                number(report.strain_end_pct.p99, 2)
            ),
            [
                "Mean in the last frame; it should not have grown.",
                "最後のコマの平均です。増え続けていないかを見ます。",
            ],
        ),
    ];
    let rows = stretch
        .into_iter()
        .chain(penetration(report))
        .collect::<Vec<_>>();
    section(
        ["How it moved", "布の動き"],
        [
            "How far the cloth can be believed.",
            "布の動きがどこまで信用できるかの目安です。",
        ],
        &rows,
    )
}

/// How far the cloth went into the dancer.
fn penetration(report: &RunReport) -> Vec<Row> {
    let mm = |value: f64| format!("{} <i>mm</i>", number(value, 2));
    let mut rows = vec![row(
        ["Cloth inside the body", "体へのめり込み"],
        format!(
            "{}<span class=\"also\">{} {}</span>",
            mm(report.skin_penetration_mm.worst),
            grouped(report.skin_penetration_vertices.worst),
            both("points", "か所")
        ),
        [
            "Deepest place in the whole dance, and how many points lie wrongly at the worst moment.",
            "踊り全体でいちばん深いところと、もっとも多い瞬間の点の数です。",
        ],
    )];
    if report.contact_body != "skin" {
        rows.push(row(
            ["… of the collision shapes", "… 衝突用のカプセル"],
            mm(report.capsule_penetration_mm.worst),
            [
                "The same against the capsules that stand for the body.",
                "体のかわりに使うカプセルに対する値です。",
            ],
        ));
    }
    rows
}

fn speed(report: &RunReport) -> String {
    let ms = |value: f64| format!("{} <i>ms</i>", number(value, 2));
    let rows = [
        row(
            ["Faster than life", "実際の時間との比"],
            format!("{} ×", number(report.realtime_factor, 2)),
            [
                "1 is as fast as the dance itself; more is faster. Drawing is not counted.",
                "1なら踊りと同じ速さ、大きいほど速い計算です。描画の時間は含みません。",
            ],
        ),
        row(
            ["One frame, processor", "1コマの計算（CPU時間）"],
            format!(
                "{}<span class=\"also\">99 %: {} ms</span>",
                ms(report.frame_ms.median),
                number(report.frame_ms.p99, 2)
            ),
            [
                "Half of all frames took less; 99 of 100 took less than the second number.",
                "半分のコマはこれより短く、100コマ中99コマは2番目の数より短い時間です。",
            ],
        ),
        row(
            ["One frame, clock", "1コマの計算（実時間）"],
            format!(
                "{}<span class=\"also\">99 %: {} ms</span>",
                ms(report.frame_wall_ms.median),
                number(report.frame_wall_ms.p99, 2)
            ),
            [
                "Below 16.7 ms the cloth keeps up with 60 pictures a second.",
                "16.7 ms より短ければ、1秒60コマに間に合います。",
            ],
        ),
    ];
    section(
        ["How fast it was", "計算の速さ"],
        [
            "Measured on the computer that ran it.",
            "計算したコンピューターで測った値です。",
        ],
        &rows,
    )
}

/// A figure over the time of the dance.
struct TimePlot<'a> {
    /// English and Japanese.
    title: [&'a str; 2],
    /// What to read from it, in both.
    about: [&'a str; 2],
    values: &'a [f64],
    reference: Option<(f64, &'a str)>,
    floor: Floor,
}

impl TimePlot<'_> {
    /// The figure over these times [s]; `None` where there is nothing to draw.
    fn figure(&self, times: &[f64]) -> Option<String> {
        let drawing = svg(&Plot {
            reference: self.reference,
            ..Plot::single(times, self.values, self.floor)
        })?;
        let [title, about] = [self.title, self.about].map(|[en, ja]| both(en, ja));
        Some(format!(
            "<figure><h3>{title}</h3><p>{about}</p>{drawing}</figure>\n"
        ))
    }
}

fn plots(report: &RunReport) -> String {
    let series = &report.series;
    let shown = [
        TimePlot {
            title: ["Time for one frame (ms)", "1コマの計算時間（ms）"],
            about: [
                "The dashed line is 16.7 ms: 60 frames a second.",
                "破線は 16.7 ms（1秒60コマ）です。",
            ],
            values: &series.frame_ms,
            reference: Some((1000.0 / 60.0, "16.7 ms")),
            floor: Floor::Zero,
        },
        TimePlot {
            title: ["Height of the hem (cm)", "裾の高さ（cm）"],
            about: ["Mean height above the floor.", "床からの高さの平均です。"],
            values: &series.hem_height_mean_cm,
            reference: None,
            floor: Floor::Smallest,
        },
        TimePlot {
            title: ["Stretch of the cloth (%)", "布の伸び縮み（%）"],
            about: [
                "99 of 100 threads stretch less.",
                "100本中99本はこれより小さい伸びです。",
            ],
            values: &series.strain_p99_pct,
            reference: None,
            floor: Floor::Zero,
        },
        TimePlot {
            title: ["Cloth inside the body (mm)", "体へのめり込み（mm）"],
            about: [
                "Deepest point of each frame.",
                "各コマでいちばん深い点です。",
            ],
            values: &series.skin_penetration_mm,
            reference: None,
            floor: Floor::Zero,
        },
    ];
    let figures: String = shown
        .iter()
        .filter_map(|shown| shown.figure(&series.time_s))
        .collect();
    if figures.is_empty() {
        return String::new();
    }
    format!(
        "<h2>{}</h2>\n<p class=\"note\">{}</p>\n<div class=\"plots\">\n{figures}</div>\n",
        both("From beginning to end", "はじめから終わりまで"),
        both(
            "The axis below is the time of the dance in seconds.",
            "横軸は踊りの時間（秒）です。"
        ),
    )
}

fn files(files: &[ReportFile]) -> String {
    if files.is_empty() {
        return String::new();
    }
    let items: String = files
        .iter()
        .map(|file| {
            let name = escape(&file.name);
            let what = escape(&file.what);
            format!(
                "<li><a href=\"{}\">{name}</a> <span class=\"note\">{}</span><br>{}</li>\n",
                link(&file.name),
                file_size(file.bytes),
                both(&what, what_in_japanese(&file.name).unwrap_or(&what)),
            )
        })
        .collect();
    format!(
        "<h2>{}</h2>\n<ul class=\"files\">\n{items}</ul>\n",
        both("Files", "ファイル")
    )
}

/// What a file is, by its ending.
fn what_in_japanese(name: &str) -> Option<&'static str> {
    match name.rsplit_once('.')?.1 {
        "mp4" => Some("踊りの動画です。ふつうの動画プレーヤーやスマートフォンで再生できます。"),
        "png" | "jpg" | "jpeg" => Some("静止画です。印刷にも使えます。"),
        "glb" => Some("動く3Dモデルです。Blender や Windows の 3D ビューアーで開けます。"),
        "lole" => Some("この衣装の設計データです。同じデータからは同じ動きが再現されます。"),
        "json" => Some("プログラム用の数値データです。"),
        "html" => Some("このページです。"),
        _ => None,
    }
}

fn settings(report: &RunReport) -> String {
    let plain = |value: String| value;
    let rows = [
        row(
            ["Mass points", "質点の数"],
            grouped(report.particles),
            [
                "The cloth as the computer sees it.",
                "コンピューターの中の布を表す点です。",
            ],
        ),
        row(["Springs", "ばねの数"], grouped(report.springs), ["", ""]),
        row(
            ["Method", "計算方法"],
            plain(escape(&report.method)),
            [
                &format!(
                    "{} substeps a frame, {} threads",
                    report.substeps, report.threads
                ),
                &format!(
                    "1コマを{}回に分けて計算、スレッド数 {}",
                    report.substeps, report.threads
                ),
            ],
        ),
        row(["Frames", "コマ数"], grouped(report.frames), ["", ""]),
        row(
            ["Seed", "乱数の種"],
            plain(report.seed.to_string()),
            ["", ""],
        ),
        row(
            ["Pictures drawn by", "描画"],
            plain(escape(&report.renderer)),
            ["", ""],
        ),
        row(
            ["Fingerprint of the run", "計算結果の指紋"],
            format!("<code>{}</code>", escape(&report.state_hash)),
            [
                "The same design and version give the same one, on any number of threads.",
                "同じ設計データと同じバージョンなら、スレッド数が違っても同じ値になります。",
            ],
        ),
    ];
    section(["For the curious", "くわしい設定"], ["", ""], &rows)
}
