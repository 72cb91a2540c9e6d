//! Writes the page of the dance steps: each as a strip of pictures with its counts, what is known
//! of it and from where, and what only a kumu can answer.
//!
//! `cargo run -p lole_hula --example hula_page -- docs` writes `docs/hula.md` and the pictures under
//! `docs/hula/`.

mod radiographs;
mod strip;

use std::fmt::Write as _;
use std::fs;
use std::io;
use std::path::PathBuf;

use lole_body::{Dancer, Measurements};
use lole_hula::{DanceStep, MotionSettings};
use lole_hula::{SCHOOLS, SOURCES};

const HEAD: &str = "\
# Hula steps

クムの教えが先です。
ここにあるのは公開された説明から集めた下絵で、呼び名も、拍の取り方も、大きさも、ハーラウごとに違います。

A kumu's way comes first.
What follows is a sketch, compiled from public descriptions; names, phase and amplitude differ from hālau to hālau, and a kumu should look at the result before it is called hula.

This page is written by `cargo run -p lole_hula --example hula_page -- docs` from the scores in `crates/lole_hula/src/repertoire/`.

Each strip shows the right side; the left is its mirror image.
Upper row: seen from the front, so that her left is on your right.
Lower row: the floor as she sees it from above, forward up; a full print is on the floor, a pale one in the air, a ring stands under the hips, and lines are 10 cm apart.
Small numbers are counts, and a dot is the half beat after one.
";

const CHOREOGRAPHY: &str = "
## A dance of several steps

振付は `[[motion.part]]` を並べて書きます。
前の部分は最後の拍で終わり、次の部分の「1」はその次の拍です。
切り替えの一拍のあいだ、片足は床についたまま動きません。
`lole dance` は拍の時刻を `counts.csv` に書くので、曲に合わせられます。

A choreography is a list of `[[motion.part]]`.
A part ends on its last count, and the next one's \"1\" is the beat after it.
In that beat the body goes over from one step into the other while one foot stays on the floor.
`lole dance` writes the time of every count to `counts.csv`, so that music can be matched.

```toml
lole = 1

[motion]
school = \"auana\"
tempo_bpm = 76

[[motion.part]]
step = \"kaholo\"
beat_count = 16

[[motion.part]]
step = \"hela\"
beat_count = 8
facing_deg = 45

[[motion.part]]
step = \"ami\"
side = \"left\"
beat_count = 8
arms = \"hands-on-hips\"
tempo_bpm = 96

[[motion.part]]
step = \"lele-uwehe\"
beat_count = 8
```

`beat_count` is a multiple of the step's phrase, `side` says which foot begins (for ʻami, which way round), and `facing_deg` turns her to her left of the front.
`arms` may be `of-step`, `open`, `hands-on-hips`, `ready`, `open-up`, `low-front` or `rounded`.
A new tempo is reached within two counts.

部分に `formation`（`rows`・`line`・`wedge`・`circle`）を書くと、名簿の全員の動画で、その部分のあいだに皆がその隊形へ歩いて移ります。
足の運びはステップのまま、一歩ずつが少し長くなります。
その場のステップ（`ami` など）では移れず、道のりに拍数が足りないときは、何拍要るかを言って断ります。
`mood`（`tender`・`joyful`・`sea`・`solemn`）を書くと、劇場の照明がその部分から移り変わります。

With `formation` (`rows`, `line`, `wedge`, `circle`) in a part, everybody of a list walks to it while the part is danced.
Her feet do the step, and every landing is a little farther.
Steps that stay in place, such as `ami`, take nobody anywhere, and a way too long for the counts of a part is refused with the counts that it takes.
`mood` (`tender`, `joyful`, `sea`, `solemn`) fades the lamps of a theater from that part on.
";

fn main() -> io::Result<()> {
    let folder = PathBuf::from(std::env::args().nth(1).unwrap_or_else(|| "docs".into()));
    fs::create_dir_all(folder.join("hula"))?;
    let dancer = Dancer::new(&Measurements::woman()).map_err(io::Error::other)?;
    let mut page = HEAD.to_owned();
    page.push_str("\n## Steps\n\n");
    for step in DanceStep::ALL {
        let link = anchor(step);
        line(
            &mut page,
            format_args!("- [{}](#{link}): {}", step.name(), step.title().english),
        );
    }
    page.push_str(CHOREOGRAPHY);
    for step in DanceStep::ALL {
        let settings = MotionSettings {
            dance_step: step,
            ..MotionSettings::default()
        };
        let image = strip::of(&dancer, &settings)?;
        fs::write(
            folder.join("hula").join(format!("{}.png", step.id())),
            image,
        )?;
        describe(&mut page, step);
    }
    radiographs::describe(&mut page, &dancer)?;
    describe_schools(&mut page);
    page.push_str("\n## Sources\n\nThey were read in excerpts, and none is copied.\n\n");
    for source in SOURCES {
        line(
            &mut page,
            format_args!("- [{}] {}", source.key, source.place),
        );
    }
    fs::write(folder.join("hula.md"), page)
}

/// The anchor of a step's heading.
fn anchor(step: DanceStep) -> &'static str {
    step.id()
}

/// Writing to a string cannot fail.
fn line(page: &mut String, text: std::fmt::Arguments<'_>) {
    let _ignored = page.write_fmt(text);
    page.push('\n');
}

/// One sentence to a line, each but the first after `indent`.
fn lines(text: &str, indent: &str) -> String {
    text.replace('。', &format!("。\n{indent}"))
}

fn describe(page: &mut String, step: DanceStep) {
    let (title, about) = (step.title(), step.about());
    line(page, format_args!("\n## {}\n", step.id()));
    line(
        page,
        format_args!(
            "**{}** · {} · {}\n",
            step.name(),
            title.japanese,
            title.english
        ),
    );
    line(
        page,
        format_args!("{}。\n{}\n", lines(about.japanese, ""), about.english),
    );
    line(
        page,
        format_args!("![{}](hula/{}.png)\n", step.name(), step.id()),
    );
    page.push_str("| Count | | |\n|---|---|---|\n");
    for (number, said) in (1..).zip(step.teaching()) {
        line(
            page,
            format_args!("| {number} | {} | {} |", said.japanese, said.english),
        );
    }
    let [slow, fast] = step.tempo();
    line(
        page,
        format_args!(
            "\nPhrases of {} counts, {} in all, {slow} to {fast} a minute (estimate).\n",
            step.phrase(),
            step.counts()
        ),
    );
    for statement in step.statements() {
        let basis = match (statement.sources, statement.estimated) {
            ([], true) => "estimate".to_owned(),
            ([], false) => "computed".to_owned(),
            (keys, _) => keys.join(", "),
        };
        let what = statement.what;
        line(
            page,
            format_args!(
                "- {}\n  {} [{basis}]",
                lines(what.japanese, "  "),
                what.english
            ),
        );
    }
    page.push_str("\nクムに聞きたいこと / open questions:\n\n");
    for question in step.questions() {
        line(
            page,
            format_args!(
                "- {}\n  {}",
                lines(question.japanese, "  "),
                question.english
            ),
        );
    }
}

fn describe_schools(page: &mut String) {
    page.push_str(
        "\n## Schools\n\nPresets of `[motion] school`; every key can be set besides.\n\n\
         | school | | | knees | stance | toes out | heel | hip up | hips on the count |\n\
         |---|---|---|---|---|---|---|---|---|\n",
    );
    for school in SCHOOLS {
        line(
            page,
            format_args!(
                "| `{}` | {} | {} | {}° | {} | {}° | {} | {:?} | {:?} |",
                school.id,
                school.about.japanese,
                school.about.english,
                school.knee_degrees,
                school.stance_width,
                school.toe_out_degrees,
                school.heel_lift,
                school.hip_lift,
                school.hip_lead,
            ),
        );
    }
    page.push_str("\nStance and heel are fractions of the stature.\n");
}
