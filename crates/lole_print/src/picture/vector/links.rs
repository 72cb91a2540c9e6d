//! What reading a drawing would cost, before anything is made of it: attributes, rules of style, and things that
//! name each other.
//!
//! Readers of SVG look for each attribute among those before it, at each rule for each element, along each chain of
//! names from its beginning, and through everything that is named inside of something named. What people draw is
//! far below the bounds; a text of some kilobytes can be made for which a reader never ends.

use std::collections::BTreeMap;

use resvg::usvg::roxmltree::{Document, Node};

/// Attributes of an element, at most.
const MOST_ATTRIBUTES: usize = 500;
/// Declarations in one `style`, at most.
const MOST_DECLARATIONS: usize = 200;
/// Letters of selectors times elements, at most: four thousand rules for ten thousand elements.
const MOST_MATCHES: u64 = 400_000_000;
/// Gradients, patterns or filters that inherit from each other in a chain, at most.
const LONGEST_CHAIN: usize = 64;
/// Steps along such chains, at most.
const MOST_STEPS: u64 = 10_000_000;
/// Looks at elements inside of what is named inside of patterns, masks, clips and filters, at most.
const MOST_LOOKS: u64 = 20_000_000;
/// Elements that are named by elements in each other, at most.
const DEEPEST: u32 = 1024;

/// What is used by its name, and has things in it.
const CONTAINERS: [&str; 5] = ["pattern", "mask", "clipPath", "filter", "marker"];
/// What inherits from what it names.
const HEIRS: [&str; 4] = ["linearGradient", "radialGradient", "pattern", "filter"];

/// Whether an element of the text has more attributes than any that is drawn. No letter `<` stands in an
/// attribute, so that what lies between two of them is one element at most.
pub(super) fn has_crowded_elements(text: &str) -> bool {
    let elements = text.as_bytes().split(|byte| *byte == b'<');
    let mut counts = elements.map(|element| element.iter().filter(|byte| **byte == b'=').count());
    counts.any(|count| MOST_ATTRIBUTES < count)
}

/// Whether a reader would end soon.
pub(super) fn are_few(document: &Document<'_>) -> bool {
    are_styles_few(document) && Links::of(document).is_some_and(|links| links.are_few(document))
}

/// Whether declarations and rules are few.
fn are_styles_few(document: &Document<'_>) -> bool {
    let (mut elements, mut letters) = (0_u64, 0_u64);
    for node in document.descendants() {
        elements += u64::from(node.is_element());
        let declared = node.attribute("style").unwrap_or_default();
        if MOST_DECLARATIONS < declared.matches(';').count() {
            return false;
        }
        if is(node, &["style"]) {
            let texts = node.children().filter_map(|child| child.text());
            letters += texts.map(selector_letters).sum::<u64>();
        }
    }
    letters.saturating_mul(elements) <= MOST_MATCHES
}

/// Letters of a text of rules that stand outside of braces.
fn selector_letters(rules: &str) -> u64 {
    let mut is_inside = false;
    let mut count = 0;
    for letter in rules.bytes() {
        match letter {
            b'{' => is_inside = true,
            b'}' => is_inside = false,
            _ => count += u64::from(!is_inside && !letter.is_ascii_whitespace()),
        }
    }
    count
}

fn is(node: Node<'_, '_>, names: &[&str]) -> bool {
    node.is_element() && names.contains(&node.tag_name().name())
}

/// Names that a text refers to as `url(#name)`.
fn named(text: &str) -> impl Iterator<Item = &str> {
    text.split("url(").skip(1).filter_map(|rest| {
        let name = rest.split(')').next()?;
        let name = name.trim().trim_matches(['"', '\'']).trim();
        name.strip_prefix('#')
    })
}

/// Number of a node in its document.
fn number(node: Node<'_, '_>) -> usize {
    node.id().get_usize()
}

/// Name that an element refers to as a whole.
fn href<'a>(node: Node<'a, '_>) -> Option<&'a str> {
    let mut all = node.attributes();
    let value = all.find(|attribute| attribute.name() == "href")?.value();
    value.trim().strip_prefix('#')
}

/// What is called how; names that stand twice mean any of them.
struct Links<'a, 'input> {
    called: BTreeMap<&'a str, Vec<Node<'a, 'input>>>,
    /// Elements in each node, and in what it uses, by the node's number; 0 where that is not known yet.
    sizes: Vec<u64>,
}

impl<'a, 'input> Links<'a, 'input> {
    /// `None` where elements use each other too deeply.
    fn of(document: &'a Document<'input>) -> Option<Self> {
        let mut links = Self {
            called: BTreeMap::new(),
            sizes: vec![0; document.descendants().map(number).max().unwrap_or(0) + 1],
        };
        for node in document.descendants() {
            if let Some(name) = node.attribute("id") {
                links.called.entry(name).or_default().push(node);
            }
        }
        links.size(document.root_element(), 0)?;
        Some(links)
    }

    fn targets(&self, name: &str) -> &[Node<'a, 'input>] {
        self.called.get(name).map_or(&[], Vec::as_slice)
    }

    /// Elements in an element and in what it uses; what uses itself is not drawn.
    fn size(&mut self, node: Node<'a, 'input>, depth: u32) -> Option<u64> {
        if DEEPEST < depth {
            return None;
        }
        match self.sizes[number(node)] {
            0 => self.sizes[number(node)] = 1,
            size => return Some(size),
        }
        let mut size = 1_u64;
        for child in node.children().filter(Node::is_element) {
            size = size.saturating_add(self.size(child, depth + 1)?);
        }
        if is(node, &["use"]) {
            let used = href(node).map_or_else(Vec::new, |name| self.targets(name).to_vec());
            for target in used {
                size = size.saturating_add(self.size(target, depth + 1)?);
            }
        }
        self.sizes[number(node)] = size;
        Some(size)
    }

    fn are_few(&self, document: &'a Document<'input>) -> bool {
        self.are_chains_short(document) && self.are_looks_few(document) && !self.has_circles()
    }

    /// Whether what inherits does so from few, and not in a circle that it is not part of, which has no end.
    fn are_chains_short(&self, document: &'a Document<'input>) -> bool {
        let mut steps = 0;
        for start in document.descendants().filter(|node| is(*node, &HEIRS)) {
            let mut seen = vec![start];
            let mut next = 0;
            while let Some(node) = seen.get(next).copied() {
                next += 1;
                for target in href(node).map_or(&[][..], |name| self.targets(name)) {
                    steps += 1;
                    if *target == start || *target == node {
                        continue;
                    }
                    if seen.contains(target) || LONGEST_CHAIN < seen.len() || MOST_STEPS < steps {
                        return false;
                    }
                    seen.push(*target);
                }
            }
        }
        true
    }

    /// Whether few elements lie in what is named inside of containers.
    fn are_looks_few(&self, document: &'a Document<'input>) -> bool {
        let weight = |name: &str| -> u64 {
            let targets = self
                .targets(name)
                .iter()
                .filter(|node| is(**node, &CONTAINERS));
            targets.map(|node| self.sizes[number(*node)]).sum()
        };
        let styles = document.descendants().filter(|node| is(*node, &["style"]));
        let styles = styles.flat_map(|style| style.children().filter_map(|child| child.text()));
        // A rule may be about any element.
        let styled: u64 = styles.flat_map(named).map(weight).sum();
        let mut looks = 0_u64;
        // Elements and how many containers they lie in.
        let mut open = vec![(document.root_element(), 0_u64)];
        while let Some((node, depth)) = open.pop() {
            let depth = depth + u64::from(is(node, &CONTAINERS));
            if 0 < depth {
                let texts = node.attributes().map(|attribute| attribute.value());
                let names = texts.flat_map(named).map(weight).sum::<u64>();
                looks = looks.saturating_add((names + styled + 1).saturating_mul(depth));
                if MOST_LOOKS < looks {
                    return false;
                }
            }
            open.extend(
                node.children()
                    .filter(Node::is_element)
                    .map(|child| (child, depth)),
            );
        }
        true
    }

    /// Whether something is drawn with itself, by way of whatever lies in it.
    fn has_circles(&self) -> bool {
        let containers = self
            .called
            .values()
            .flatten()
            .filter(|node| is(**node, &CONTAINERS));
        // Each is opened once and closed once; what is open again lies in itself.
        let mut is_open: Vec<Option<bool>> = vec![None; self.sizes.len()];
        for start in containers {
            let mut path = vec![(*start, false)];
            while let Some((node, is_done)) = path.pop() {
                if is_done {
                    is_open[number(node)] = Some(false);
                    continue;
                }
                if is_open[number(node)].is_some() {
                    continue;
                }
                is_open[number(node)] = Some(true);
                path.push((node, true));
                for target in self.inside(node) {
                    match is_open[number(target)] {
                        Some(true) => return true,
                        Some(false) => {}
                        None => path.push((target, false)),
                    }
                }
            }
        }
        false
    }

    /// Containers that are named in a container.
    fn inside(&self, container: Node<'a, 'input>) -> Vec<Node<'a, 'input>> {
        let attributes = container.descendants().flat_map(|node| node.attributes());
        let names = attributes.flat_map(|attribute| named(attribute.value()));
        let targets = names.flat_map(|name| self.targets(name).iter().copied());
        targets.filter(|node| is(*node, &CONTAINERS)).collect()
    }
}
