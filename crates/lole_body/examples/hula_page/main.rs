//! Writes the page of the dance steps: each as a strip of pictures with its counts, what is known
//! of it and from where, and what only a kumu can answer.
//!
//! `cargo run -p lole_body --example hula_page -- docs` writes `docs/hula.md` and the pictures under
//! `docs/hula/`.

mod radiographs;
mod strip;

use std::fmt::Write as _;
use std::fs;
use std::io;
use std::path::PathBuf;

use lole_body::motion::{SCHOOLS, SOURCES};
use lole_body::{DanceStep, Dancer, Measurements, MotionSettings};

const HEAD: &str = "\
# Hula steps

クムの教えが先です。
ここにあるのは公開された説明から集めた下絵で、呼び名も、拍の取り方も、大きさも、ハーラウごとに違います。

A kumu's way comes first.
What follows is a sketch, compiled from public descriptions; names, phase and amplitude differ from hālau to hālau, and a kumu should look at the result before it is called hula.

This page is written by `cargo run -p lole_body --example hula_page -- docs` from the scores in `crates/lole_body/src/motion/repertoire/`.

Each strip shows the right side; the left is its mirror image.
Upper row: seen from the front, so that her left is on your right.
Lower row: the floor as she sees it from above, forward up; a full print is on the floor, a pale one in the air, a ring stands under the hips, and lines are 10 cm apart.
Small numbers are counts, and a dot is the half beat after one.
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
        format_args!("{}。\n{}\n", about.japanese, about.english),
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
            "\n{} counts in all, {slow} to {fast} a minute (estimate).\n",
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
            format_args!("- {}。 {} [{basis}]", what.japanese, what.english),
        );
    }
    page.push_str("\nクムに聞きたいこと / open questions:\n\n");
    for question in step.questions() {
        line(
            page,
            format_args!("- {} / {}", question.japanese, question.english),
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
