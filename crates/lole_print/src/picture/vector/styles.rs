//! What the attributes and rules of a drawing would cost.
//!
//! A reader looks for each attribute among those before it, and tries each rule on each element.

use std::collections::BTreeMap;

use resvg::usvg::roxmltree::Document;

/// Attributes of an element, at most.
const MOST_ATTRIBUTES: usize = 250;
/// Looks for attributes among those before them, at most: fifty thousand elements of sixty.
const MOST_LOOKS: u64 = 200_000_000;
/// Parts of selectors times elements, at most: a thousand rules for fifty thousand elements.
const MOST_TRIES: u64 = 50_000_000;
/// Declarations of rules times elements that they are for, at most.
const MOST_DECLARED: u64 = 20_000_000;
/// Letters of a list of classes that are looked at as long as at an element.
const LETTERS: usize = 16;

/// Whether an element of the text has more attributes than any that is drawn. No letter `<` stands in an
/// attribute, so that what lies between two of them is one element at most.
pub(super) fn has_crowded_elements(text: &str) -> bool {
    let elements = text.as_bytes().split(|byte| *byte == b'<');
    let mut counts = elements.map(|element| element.iter().filter(|byte| **byte == b'=').count());
    counts.any(|count| MOST_ATTRIBUTES < count)
}

/// Whether attributes and rules are read soon.
pub(super) fn are_few(document: &Document<'_>) -> bool {
    let (mut elements, mut looks) = (Elements::default(), 0_u64);
    for node in document.descendants().filter(|node| node.is_element()) {
        let declared = node.attribute("style").unwrap_or_default();
        let count = node.attributes().len() + declared.matches(';').count();
        let count = count as u64;
        looks = looks.saturating_add(count.saturating_mul(count));
        elements.add(node.attribute("class").unwrap_or_default());
    }
    looks <= MOST_LOOKS && are_rules_few(document, &elements)
}

/// How many elements rules may be for.
#[derive(Default)]
struct Elements<'a> {
    all: u64,
    of_class: BTreeMap<&'a str, u64>,
}

impl<'a> Elements<'a> {
    fn add(&mut self, classes: &'a str) {
        self.all += 1 + (classes.len() / LETTERS) as u64;
        for class in classes.split_ascii_whitespace() {
            *self.of_class.entry(class).or_default() += 1;
        }
    }

    /// Elements that a selector is for, at most: those of the class at its end, else all.
    fn of(&self, selector: &str) -> u64 {
        let end = selector.rsplit(|letter: char| letter.is_whitespace() || ">+~".contains(letter));
        let end = end.into_iter().next().unwrap_or_default();
        let Some((_, class)) = end.split_once('.') else {
            return self.all;
        };
        let class = class.split(['.', '#', ':', '[']).next().unwrap_or_default();
        self.of_class.get(class).copied().unwrap_or(0)
    }
}

fn are_rules_few(document: &Document<'_>, elements: &Elements<'_>) -> bool {
    let (mut tries, mut declared) = (0_u64, 0_u64);
    let styles = document
        .descendants()
        .filter(|node| node.tag_name().name() == "style");
    for rules in styles.flat_map(|style| style.children().filter_map(|child| child.text())) {
        for rule in rules.split('}') {
            let (selectors, declarations) = rule.split_once('{').unwrap_or((rule, ""));
            let parts = 1 + selectors
                .matches([',', '.', '#', ':', '[', ' ', '>', '+', '~'])
                .count();
            tries = tries.saturating_add((parts as u64).saturating_mul(elements.all));
            let count = 1 + declarations.matches(';').count() as u64;
            for selector in selectors.split(',') {
                let matched = elements.of(selector.trim());
                declared = declared.saturating_add(count.saturating_mul(matched));
            }
            if MOST_TRIES < tries || MOST_DECLARED < declared {
                return false;
            }
        }
    }
    true
}
