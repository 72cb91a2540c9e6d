//! Drawings whose patterns, masks, clips and filters use each other.

use std::fmt::Write as _;

use arbitrary::Unstructured;

use crate::{between, choose, count, once_in};

/// Things in each other, at most.
const DEEPEST: u32 = 12;
/// What can be used by its name.
const USED: u32 = 6;

/// A drawing as SVG.
pub fn text(bytes: &mut Unstructured<'_>) -> String {
    let size = size(bytes);
    let mut text = format!("<svg xmlns=\"http://www.w3.org/2000/svg\" {size}><defs>");
    for number in 0..USED {
        used(bytes, number, &mut text);
    }
    text.push_str("</defs>");
    things(bytes, 0, &mut text);
    text.push_str("</svg>");
    text
}

fn size(bytes: &mut Unstructured<'_>) -> String {
    let mut size = String::new();
    for side in ["width", "height"] {
        if !once_in(bytes, 4) {
            let unit = choose(bytes, &["", "mm", "%", "in", "em"]);
            let _ = write!(size, "{side}=\"{}{unit}\" ", length(bytes));
        }
    }
    if once_in(bytes, 3) {
        let [x, y, width, height] = [(); 4].map(|()| length(bytes));
        let _ = write!(size, "viewBox=\"{x} {y} {width} {height}\"");
    }
    size
}

/// A length of any size, mostly of about the drawing's.
fn length(bytes: &mut Unstructured<'_>) -> f64 {
    let power = f64::from(*choose(bytes, &[0_i8, 0, 0, 1, 2, 4, 7, 30, -3, -9]));
    between(bytes, -20.0, 100.0) * 10.0_f64.powf(power)
}

/// Something with the name `uN`.
fn used(bytes: &mut Unstructured<'_>, number: u32, text: &mut String) {
    let kinds = [
        "pattern",
        "mask",
        "clipPath",
        "filter",
        "linearGradient",
        "radialGradient",
        "g",
    ];
    // Markers are refused before anything else is looked at.
    let kind = if once_in(bytes, 200) {
        "marker"
    } else {
        *choose(bytes, &kinds)
    };
    let _ = write!(text, "<{kind} id=\"u{number}\" {}", place(bytes));
    let units = *choose(bytes, &["userSpaceOnUse", "objectBoundingBox"]);
    let _ = write!(
        text,
        " {kind}Units=\"{units}\" {kind}ContentUnits=\"{units}\""
    );
    if once_in(bytes, 4) {
        let _ = write!(text, " href=\"#u{}\"", count(bytes, USED));
    }
    text.push('>');
    match kind {
        "filter" => {
            for _ in 0..count(bytes, 8) {
                primitive(bytes, text);
            }
        }
        "linearGradient" | "radialGradient" => {
            for _ in 0..count(bytes, 4) {
                let at = length(bytes);
                let _ = write!(text, "<stop offset=\"{at}\" stop-color=\"red\"/>");
            }
        }
        _ => things(bytes, DEEPEST / 2, text),
    }
    let _ = write!(text, "</{kind}>");
}

fn primitive(bytes: &mut Unstructured<'_>, text: &mut String) {
    let kinds = [
        "feGaussianBlur",
        "feTurbulence",
        "feMorphology",
        "feConvolveMatrix",
        "feFlood",
        "feTile",
        "feOffset",
        "feDisplacementMap",
        "feComposite",
        "feDiffuseLighting",
        "feDropShadow",
        "feImage",
        "feColorMatrix",
    ];
    let kind = *choose(bytes, &kinds);
    let number = length(bytes);
    let (order, octaves) = (count(bytes, 30), count(bytes, 200));
    let matrix = if once_in(bytes, 3) {
        "1 ".repeat((order * order) as usize)
    } else {
        "1 0 0".to_owned()
    };
    let _ = write!(
        text,
        "<{kind} stdDeviation=\"{number}\" baseFrequency=\"{number}\" radius=\"{number}\" order=\"{order}\" \
         numOctaves=\"{octaves}\" kernelMatrix=\"{matrix}\" in=\"{}\" in2=\"SourceAlpha\" scale=\"{number}\" \
         operator=\"{}\" href=\"#u{}\" dx=\"{number}\"/>",
        choose(bytes, &["SourceGraphic", "SourceAlpha", "r1"]),
        choose(bytes, &["dilate", "erode", "over", "arithmetic"]),
        count(bytes, USED),
    );
}

fn place(bytes: &mut Unstructured<'_>) -> String {
    let [x, y, width, height] = [(); 4].map(|()| length(bytes));
    format!("x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\"")
}

/// Things side by side, and in each other.
fn things(bytes: &mut Unstructured<'_>, depth: u32, text: &mut String) {
    if DEEPEST < depth {
        return;
    }
    for _ in 0..1 + count(bytes, 3) {
        if bytes.is_empty() {
            return;
        }
        let style = style(bytes);
        match count(bytes, 5) {
            0 => {
                let _ = write!(text, "<g {style}>");
                things(bytes, depth + 1, text);
                text.push_str("</g>");
            }
            1 => {
                let _ = write!(text, "<path d=\"{}\" {style}/>", path(bytes));
            }
            2 => {
                let _ = write!(
                    text,
                    "<use href=\"#u{}\" {style} {}/>",
                    count(bytes, USED),
                    place(bytes)
                );
            }
            3 => {
                let _ = write!(
                    text,
                    "<circle cx=\"50\" cy=\"50\" r=\"{}\" {style}/>",
                    length(bytes)
                );
            }
            _ => {
                let _ = write!(text, "<rect {} {style}/>", place(bytes));
            }
        }
    }
}

fn path(bytes: &mut Unstructured<'_>) -> String {
    let mut path = "M0 0".to_owned();
    for _ in 0..count(bytes, 12) {
        let letter = choose(bytes, &['L', 'l', 'C', 'Q', 'A', 'Z', 'H', 'S', 't']);
        path.push(*letter);
        for _ in 0..count(bytes, 7) {
            let _ = write!(path, "{} ", length(bytes));
        }
    }
    path.repeat(1 + count(bytes, 20) as usize)
}

fn style(bytes: &mut Unstructured<'_>) -> String {
    let mut style = String::new();
    for key in [
        "fill",
        "stroke",
        "mask",
        "clip-path",
        "filter",
        "marker-mid",
    ] {
        if once_in(bytes, 4) {
            let _ = write!(style, "{key}=\"url(#u{})\" ", count(bytes, USED));
        }
    }
    for key in ["opacity", "stroke-width", "stroke-dashoffset", "font-size"] {
        if once_in(bytes, 5) {
            let _ = write!(style, "{key}=\"{}\" ", length(bytes));
        }
    }
    if once_in(bytes, 5) {
        let _ = write!(
            style,
            "stroke-dasharray=\"{} {}\" ",
            length(bytes),
            length(bytes)
        );
    }
    if once_in(bytes, 5) {
        let kind = choose(bytes, &["scale", "rotate", "translate", "skewX"]);
        let _ = write!(style, "transform=\"{kind}({})\" ", length(bytes));
    }
    if once_in(bytes, 6) {
        style.push_str("style=\"mix-blend-mode:multiply;isolation:isolate\" ");
    }
    style
}
