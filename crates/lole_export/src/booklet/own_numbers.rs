//! The numbers of steps that differ from dancer to dancer, where several sew by one booklet.
//!
//! Steps are sentences with numbers in them. What is the same for everybody is the sentence; a number that is not is
//! a letter in it and a column of a table. Whoever has a sentence of her own, as one whose cloth is joined first, has
//! it there.

use std::collections::BTreeMap;

use lole_costume::order::DancerPlan;
use lole_language::{Bilingual as _, Language, Words};

use super::{by_hand_words, head, subhead};
use crate::pdf::{Cell, Column, Flow, PageTable, TextStyle};

/// Columns of numbers that stand side by side.
const MOST_COLUMNS: usize = 7;
/// Size of letters in the tables [pt].
const SIZE: f64 = 12.0;

/// A sentence for some dancers, and what stands in it for each.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Own {
    /// The number of the step in the booklet; `None` where the dancer of the booklet does not have it.
    number: Option<usize>,
    title: Words,
    /// The sentence with letters for numbers that differ.
    sentence: String,
    /// Dancers, by their places in the group, with the numbers for the letters.
    rows: Vec<(usize, Vec<String>)>,
}

/// Whether anything in the steps of a group differs.
pub(super) fn of_group(group: &[DancerPlan], language: Language) -> Vec<Own> {
    let Some(first) = group.first() else {
        return Vec::new();
    };
    let garments = 0..first.garments.len();
    garments
        .flat_map(|garment| of_garment(group, garment, language))
        .collect()
}

fn of_garment(group: &[DancerPlan], garment: usize, language: Language) -> Vec<Own> {
    /// What tells steps apart: their title, and which of those with this title.
    type Key = (Words, usize);
    let mut order: Vec<Key> = Vec::new();
    let mut numbers: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
    let mut texts: Vec<BTreeMap<(&str, usize), String>> = Vec::new();
    for (place, plan) in group.iter().enumerate() {
        let steps = plan.garments.get(garment);
        let steps = steps.map_or(&[][..], |it| &it.tailored.pattern.steps);
        let mut of_dancer = BTreeMap::new();
        let mut seen: BTreeMap<&str, usize> = BTreeMap::new();
        for (number, step) in (1..).zip(steps) {
            let count = seen.entry(step.title.english).or_default();
            let key = (step.title, *count);
            *count += 1;
            if place == 0 {
                numbers.entry(step.title.english).or_default().push(number);
            }
            if !order.contains(&key) {
                order.push(key);
            }
            let by_hand = (step.by_hand.as_ref()).map(|text| by_hand_words(text, language));
            let text = [Some(step.by_machine.text(language)), by_hand];
            let text: Vec<String> = text.into_iter().flatten().collect();
            of_dancer.insert((key.0.english, key.1), text.join("\n"));
        }
        texts.push(of_dancer);
    }
    let of_step = |(title, count): Key| {
        let number = numbers.get(title.english).and_then(|it| it.get(count));
        let of_dancers = texts.iter().map(|it| it.get(&(title.english, count)));
        let of_dancers: Vec<Option<&str>> = of_dancers.map(|it| it.map(String::as_str)).collect();
        of_one_step((number.copied(), title), &of_dancers)
    };
    order.into_iter().flat_map(of_step).collect()
}

/// The sentences of one step.
fn of_one_step((number, title): (Option<usize>, Words), texts: &[Option<&str>]) -> Vec<Own> {
    /// A dancer's place with the numbers of her text.
    type Numbers<'a> = (usize, Vec<&'a str>);
    // Those with the same words between their numbers, in the order of the first of each.
    let mut kinds: Vec<(Vec<&str>, Vec<Numbers<'_>>)> = Vec::new();
    for (place, text) in texts.iter().enumerate() {
        let Some(text) = text else { continue };
        let (words, numbers) = parts(text);
        match kinds.iter_mut().find(|(known, _)| *known == words) {
            Some((_, dancers)) => dancers.push((place, numbers)),
            None => kinds.push((words, vec![(place, numbers)])),
        }
    }
    let is_usual = |dancers: &[Numbers<'_>]| number.is_some() && dancers[0].0 == 0;
    let owns = kinds.into_iter().filter_map(|(words, dancers)| {
        let columns = (0..words.len() - 1).map(|column| {
            let values = dancers.iter().map(|(_, numbers)| numbers[column]);
            values.collect::<Vec<&str>>()
        });
        let columns: Vec<Vec<&str>> = columns.collect();
        let mut letters: Vec<&Vec<&str>> = Vec::new();
        let mut sentence = words[0].to_owned();
        for (column, after) in columns.iter().zip(&words[1..]) {
            if column.iter().all(|value| value == &column[0]) {
                sentence.push_str(column[0]);
            } else {
                let known = letters.iter().position(|it| *it == column);
                let letter = known.unwrap_or_else(|| {
                    letters.push(column);
                    letters.len() - 1
                });
                sentence.push_str(&format!("[{}]", letter_of(letter)));
            }
            sentence.push_str(after);
        }
        if letters.is_empty() && is_usual(&dancers) {
            return None;
        }
        let rows = dancers.iter().enumerate().map(|(row, (place, _))| {
            let values = letters.iter().map(|column| column[row].to_owned());
            (*place, values.collect())
        });
        Some(Own {
            number,
            title,
            sentence,
            rows: rows.collect(),
        })
    });
    owns.collect()
}

/// What stands between the numbers of a text, and the numbers: there is one piece of text more.
fn parts(text: &str) -> (Vec<&str>, Vec<&str>) {
    let (mut words, mut numbers) = (Vec::new(), Vec::new());
    let mut rest = text;
    while let Some(start) = rest.find(|letter: char| letter.is_ascii_digit()) {
        let (before, from) = rest.split_at(start);
        let digits = |text: &str| {
            text.find(|letter: char| !letter.is_ascii_digit())
                .unwrap_or(text.len())
        };
        let mut end = digits(from);
        if let Some(decimals) = from[end..].strip_prefix('.') {
            let count = digits(decimals);
            // A point that ends the sentence is none of the number.
            if 0 < count {
                end += 1 + count;
            }
        }
        words.push(before);
        numbers.push(&from[..end]);
        rest = &from[end..];
    }
    words.push(rest);
    (words, numbers)
}

/// A, B, … Z, AA, AB, …
fn letter_of(place: usize) -> String {
    let letter = |place: usize| char::from(b'A' + u8::try_from(place % 26).unwrap_or_default());
    match place.checked_div(26) {
        Some(more) if 0 < more => format!("{}{}", letter_of(more - 1), letter(place)),
        _ => letter(place).to_string(),
    }
}

/// The sentences and tables, after the steps.
pub(super) fn draw(flow: &mut Flow, (owns, group): (&[Own], &[DancerPlan]), language: Language) {
    if owns.is_empty() {
        return;
    }
    flow.space(4.0);
    flow.keep(70.0);
    head(
        flow,
        language.pick("人によって違う数字", "Numbers of her own"),
    );
    flow.paragraph(
        language.pick(
            "縫い方の手順のうち、人によって数字の違うところです。文の中の [A] などの所に、表の自分の行の数字を入れて読んでください。",
            "These are the steps whose numbers differ. Read the sentence with the numbers of your own row in place of [A], [B] and so on.",
        ),
        &TextStyle::body(),
    );
    for own in owns {
        own.draw(flow, group, language);
    }
}

impl Own {
    fn draw(&self, flow: &mut Flow, group: &[DancerPlan], language: Language) {
        flow.space(4.0);
        flow.keep(46.0);
        let title = self.title.text(language);
        let title = match (self.number, language) {
            (Some(number), Language::Japanese) => format!("手順 {number}　{title}"),
            (Some(number), Language::English) => format!("Step {number}: {title}"),
            (None, Language::Japanese) => format!("下の人だけの手順: {title}"),
            (None, Language::English) => format!("Only for those below: {title}"),
        };
        subhead(flow, &title);
        for line in self.sentence.lines() {
            flow.paragraph(line, &TextStyle::body());
        }
        flow.space(2.0);
        let letters = self.rows.first().map_or(0, |(_, values)| values.len());
        let firsts = (0..letters.max(1)).step_by(MOST_COLUMNS);
        for first in firsts {
            let shown = first..letters.min(first + MOST_COLUMNS);
            let mut columns = vec![Column::number("", 0.5), Column::text("", 3.0)];
            let heads = shown
                .clone()
                .map(|letter| Column::number(letter_of(letter), 1.0));
            columns.extend(heads);
            let rows = self.rows.iter().map(|(place, values)| {
                let name = group.get(*place).map_or("", |plan| plan.name.as_str());
                let mut row = vec![Cell::from((place + 1).to_string()), Cell::bold(name)];
                row.extend(
                    values[shown.clone()]
                        .iter()
                        .map(|value| Cell::from(value.as_str())),
                );
                row
            });
            PageTable {
                columns,
                rows: rows.collect(),
                size_pt: SIZE,
            }
            .draw(flow);
            flow.space(2.0);
        }
    }
}

#[cfg(test)]
mod tests {
    use lole_language::words;

    use super::*;

    const TITLE: Words = words("裾", "Hem");

    #[test]
    fn numbers_are_told_from_words() {
        let (words, numbers) = parts("Fold 3 cm, then 84.0 cm; all 12. 4–5 cm");
        assert_eq!(numbers, ["3", "84.0", "12", "4", "5"]);
        assert_eq!(
            words,
            ["Fold ", " cm, then ", " cm; all ", ". ", "–", " cm"]
        );
        assert_eq!(parts("nothing"), (vec!["nothing"], vec![]));
    }

    #[test]
    fn what_differs_is_a_letter_and_everybody_reads_her_own_sentence_again() {
        let texts = [
            Some("Fold 1.0 cm at 84.0 cm, then 84.0 cm of 366."),
            Some("Fold 1.0 cm at 81.7 cm, then 81.7 cm of 360."),
            None,
            Some("Join 2 parts first. Fold 1.0 cm."),
        ];
        let owns = of_one_step((Some(8), TITLE), &texts);
        assert_eq!(owns.len(), 2);
        assert_eq!(
            owns[0].sentence,
            "Fold 1.0 cm at [A] cm, then [A] cm of [B]."
        );
        for own in &owns {
            for (place, values) in &own.rows {
                let mut read = own.sentence.clone();
                for (letter, value) in values.iter().enumerate() {
                    read = read.replace(&format!("[{}]", letter_of(letter)), value);
                }
                assert_eq!(Some(read.as_str()), texts[*place]);
            }
        }
        assert_eq!(owns[1].rows, [(3, Vec::new())]);
        // Nobody needs a table of what is the same.
        assert!(of_one_step((Some(1), TITLE), &[Some("Press 2 cm."); 3]).is_empty());
        // Whoever alone has a step has it here.
        assert_eq!(of_one_step((None, TITLE), &[None, Some("Join.")]).len(), 1);
    }

    #[test]
    fn letters_go_on_after_the_alphabet() {
        assert_eq!(
            [0, 25, 26, 27, 52, 701, 702].map(letter_of),
            ["A", "Z", "AA", "AB", "BA", "ZZ", "AAA"]
        );
    }
}
