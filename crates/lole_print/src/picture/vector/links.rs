//! What things of a drawing that name each other would cost to read.
//!
//! Readers of SVG go along each chain of names from its beginning, and through everything that is named inside of
//! something named. What people draw is far below the bounds; a text of some kilobytes can be made for which a reader
//! never ends.

use std::collections::BTreeMap;

use resvg::usvg::roxmltree::{Document, Node};

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
/// What has colors along a line, and is read anew wherever it is used.
const GRADIENTS: [&str; 2] = ["linearGradient", "radialGradient"];
/// Elements in gradients times elements that name them, at most.
const MOST_STOPS: u64 = 500_000_000;

/// What inherits from what it names.
const HEIRS: [&str; 4] = ["linearGradient", "radialGradient", "pattern", "filter"];

/// Whether a reader would end soon.
pub(super) fn are_few(document: &Document<'_>) -> bool {
    Links::of(document).is_some_and(|links| {
        links.are_chains_short(document)
            && links.are_stops_few(document)
            && links.are_looks_few(document)
            && !links.has_circles()
    })
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

/// Names that rules of style refer to.
fn in_styles<'a>(document: &'a Document<'_>) -> impl Iterator<Item = &'a str> {
    let styles = document.descendants().filter(|node| is(*node, &["style"]));
    let texts = styles.flat_map(|style| style.children().filter_map(|child| child.text()));
    texts.flat_map(named)
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

    /// Whether what inherits does so from few, and not in a circle that it is not part of, which has no end.
    fn are_chains_short(&self, document: &'a Document<'input>) -> bool {
        let mut steps = 0;
        let mut heirs = document.descendants().filter(|node| is(*node, &HEIRS));
        heirs.all(|heir| self.is_chain_short(heir, &mut steps))
    }

    fn is_chain_short(&self, start: Node<'a, 'input>, steps: &mut u64) -> bool {
        let mut seen = vec![start];
        let mut next = 0;
        while let Some(node) = seen.get(next).copied() {
            next += 1;
            let targets = href(node).map_or(&[][..], |name| self.targets(name));
            for target in targets {
                *steps += 1;
                if *target == start || *target == node {
                    continue;
                }
                if seen.contains(target) || LONGEST_CHAIN < seen.len() || MOST_STEPS < *steps {
                    return false;
                }
                seen.push(*target);
            }
        }
        true
    }

    /// Elements in what has a name and is of some kinds.
    fn weight(&self, name: &str, kinds: &[&str]) -> u64 {
        let targets = self.targets(name).iter().filter(|node| is(**node, kinds));
        targets.map(|node| self.sizes[number(*node)]).sum()
    }

    /// Whether gradients are read anew for few elements.
    fn are_stops_few(&self, document: &'a Document<'input>) -> bool {
        let weight = |name: &str| self.weight(name, &GRADIENTS);
        let styled: u64 = in_styles(document).map(weight).sum();
        let elements = document.descendants().filter(Node::is_element);
        let stops = elements.map(|node| {
            let texts = node.attributes().map(|attribute| attribute.value());
            styled + texts.flat_map(named).map(weight).sum::<u64>()
        });
        stops.fold(0_u64, u64::saturating_add) <= MOST_STOPS
    }

    /// Whether few elements lie in what is named inside of containers.
    fn are_looks_few(&self, document: &'a Document<'input>) -> bool {
        let weight = |name: &str| self.weight(name, &CONTAINERS);
        // A rule may be about any element.
        let styled: u64 = in_styles(document).map(weight).sum();
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
        let mut containers = self.called.values().flatten();
        let mut is_open = vec![None; self.sizes.len()];
        containers.any(|node| is(*node, &CONTAINERS) && self.lies_in_itself(*node, &mut is_open))
    }

    /// Each is opened once and closed once; what is named while it is open lies in itself.
    fn lies_in_itself(&self, start: Node<'a, 'input>, is_open: &mut [Option<bool>]) -> bool {
        let mut path = vec![(start, false)];
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
            let inside = self.inside(node);
            if inside
                .iter()
                .any(|target| is_open[number(*target)] == Some(true))
            {
                return true;
            }
            path.extend(inside.into_iter().map(|target| (target, false)));
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
