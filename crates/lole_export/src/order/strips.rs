//! How a group's cloth is cut: strips from selvage to selvage, with who is where, by bolt.

use lole_costume::order::{PrintTotal, Share, SharedStrip};
use lole_language::Language;
use serde::Serialize;

use super::{Order, rounded};
use crate::pdf::{Flow, TextStyle};

/// Writes what cutting together saves, what is cut from each bolt, and how each strip is divided where several
/// dancers share one.
pub(super) fn write(flow: &mut Flow, order: &Order<'_>, print: &PrintTotal, language: Language) {
    let style = TextStyle::regular(11.0);
    let mut line = |text: &str| flow.indented(12.0, text, &style);
    if let Some(saved) = saved_words(print, language) {
        line(&saved);
    }
    let is_shared = print.strips.iter().any(|strip| 1 < strip.shares.len());
    if is_shared {
        line(language.pick(
            "布を下の長さずつ耳から耳まで切り離し、片方の耳から測って分けます。",
            "Cut these lengths off from selvage to selvage and divide each, measured from one selvage.",
        ));
    }
    let name = |dancer: usize| name_of(order, dancer);
    if print.bolts.is_empty() && is_shared {
        for (number, strip) in (1..).zip(&print.strips) {
            line(&strip_words((number, strip), print, (&name, language)));
        }
    }
    for (number, bolt) in (1..).zip(&print.bolts) {
        let cut: f64 = bolt
            .iter()
            .map(|&strip| print.strips[strip].length.to_m())
            .sum();
        // Strips that several share are told one by one below.
        let names: Vec<String> = if is_shared {
            let dancers = dancers(print, bolt).into_iter();
            dancers.map(|dancer| name(dancer).to_owned()).collect()
        } else {
            let strips = bolt.iter().map(|&strip| &print.strips[strip]);
            let alone = strips.map(|strip| {
                let who = strip.shares.first().map_or("", |share| name(share.dancer));
                format!("{who} {:.2} m", strip.length.to_m())
            });
            alone.collect()
        };
        let names = names.join(language.pick("、", ", "));
        line(&match language {
            Language::Japanese => format!("{number} 反目から {cut:.2} m: {names}"),
            Language::English => format!("bolt {number}, {cut:.2} m: {names}"),
        });
        if is_shared {
            for &strip in bolt {
                let numbered = (strip + 1, &print.strips[strip]);
                line(&strip_words(numbered, print, (&name, language)));
            }
        }
    }
    if !print.longer_than_bolt.is_empty() {
        let names = print.longer_than_bolt.iter().map(|&dancer| name(dancer));
        let names: Vec<&str> = names.collect();
        let names = names.join(language.pick("、", ", "));
        let warning = match language {
            Language::Japanese => format!(
                "! 一反では足りない人: {names}。はぎ合わせるか、長い反物をさがしてください。"
            ),
            Language::English => format!(
                "! One bolt is too short for {names}: join two lengths, or find a longer bolt."
            ),
        };
        flow.indented(12.0, &warning, &TextStyle::bold(12.0));
    }
}

fn name_of<'a>(order: &'a Order<'_>, dancer: usize) -> &'a str {
    let plan = order.plans.get(dancer);
    plan.map_or("", |plan| plan.name.as_str())
}

/// What is saved by cutting together; `None` where it is nothing.
fn saved_words(print: &PrintTotal, language: Language) -> Option<String> {
    let [apart, saved] = [print.apart, print.saved()].map(lole_geom::Length::to_m);
    (0.0 < saved).then(|| match language {
        Language::Japanese => format!(
            "みんなの分をいっしょに裁つので、一人ずつ裁つときの {apart:.2} m より {saved:.2} m 少なくてすみます。"
        ),
        Language::English => format!(
            "Cut together this is {saved:.2} m less than the {apart:.2} m that everybody's by themselves would need."
        ),
    })
}

/// How a strip is divided: "2. 3.20 m: Hana 0–35.0 cm (318.0 cm long), …".
fn strip_words<'a>(
    (number, strip): (usize, &SharedStrip),
    print: &PrintTotal,
    (name, language): (&dyn Fn(usize) -> &'a str, Language),
) -> String {
    let shares = strip.shares.iter().map(|share| {
        let [from, to] = share.across.map(|side| side.to_cm());
        let (who, what, long) = (
            name(share.dancer),
            share_words(share, print, language),
            share.along.to_cm(),
        );
        match language {
            Language::Japanese => format!("{who}{what} {from:.1}～{to:.1} cm（長さ {long:.1} cm）"),
            Language::English => format!("{who}{what} {from:.1}–{to:.1} cm ({long:.1} cm long)"),
        }
    });
    let shares: Vec<String> = shares.collect();
    let long = strip.length.to_m();
    format!(
        "{number}. {long:.3} m: {}",
        shares.join(language.pick("、", ", "))
    )
}

/// What a share is for, where the cloth is for more than one thing.
fn share_words(share: &Share, print: &PrintTotal, language: Language) -> String {
    let garment = share.garment.text(language);
    let of_garment = if print.garments.len() < 2 {
        ""
    } else {
        garment
    };
    let piece = share.piece.map(|piece| piece.text(language));
    let piece = piece.filter(|piece| *piece != garment).unwrap_or_default();
    let words: Vec<&str> = [of_garment, piece]
        .into_iter()
        .filter(|word| !word.is_empty())
        .collect();
    if words.is_empty() {
        return String::new();
    }
    format!(
        "{}{}",
        language.pick("・", ", "),
        words.join(language.pick("・", ", "))
    )
}

/// Whose pieces are cut from some strips, each once, in the order of the strips.
pub(super) fn dancers(print: &PrintTotal, strips: &[usize]) -> Vec<usize> {
    let shares = strips.iter().flat_map(|&strip| &print.strips[strip].shares);
    let mut found: Vec<usize> = Vec::new();
    for share in shares {
        if !found.contains(&share.dancer) {
            found.push(share.dancer);
        }
    }
    found
}

/// A strip as data.
#[derive(Serialize)]
pub(super) struct StripRow {
    length_m: f64,
    /// From which bolt, from 1, where their length is known.
    bolt: Option<usize>,
    shares: Vec<ShareRow>,
}

#[derive(Serialize)]
struct ShareRow {
    dancer: String,
    garment: &'static str,
    piece: Option<&'static str>,
    along_cm: f64,
    across_cm: [f64; 2],
}

/// All strips of a print as data.
pub(super) fn rows(print: &PrintTotal, name: &dyn Fn(usize) -> Option<String>) -> Vec<StripRow> {
    let bolt_of = |index: usize| print.bolts.iter().position(|bolt| bolt.contains(&index));
    let strips = print.strips.iter().enumerate();
    strips
        .map(|(index, strip)| StripRow {
            length_m: rounded(strip.length.to_m()),
            bolt: bolt_of(index).map(|bolt| bolt + 1),
            shares: (strip.shares.iter())
                .map(|share| ShareRow {
                    dancer: name(share.dancer).unwrap_or_default(),
                    garment: share.garment.english,
                    piece: share.piece.map(|piece| piece.english),
                    along_cm: rounded(share.along.to_cm()),
                    across_cm: share.across.map(|side| rounded(side.to_cm())),
                })
                .collect(),
        })
        .collect()
}
