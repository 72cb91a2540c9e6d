//! Drawings of a few kilobytes that would be drawn for minutes or take all memory are refused before they
//! are drawn; what people draw is not.

use lole_print::{Picture, PictureError};

fn read(drawn: &str) -> Result<Picture, PictureError> {
    let text = format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="100" height="100">{drawn}</svg>"#
    );
    Picture::read(text.as_bytes())
}

const ALL: &str = r#"x="0" y="0" width="100" height="100""#;

/// Things in a chain, each of which uses the one before twice.
fn chain(count: usize, link: impl Fn(usize, &str) -> String, used: &str) -> String {
    let links: String = (0..count)
        .map(|number| match number.checked_sub(1) {
            Some(before) => link(number, &used.replace('#', &format!("#l{before}"))),
            None => link(number, ""),
        })
        .collect();
    format!("<defs>{links}</defs>")
}

#[test]
fn what_uses_each_other_in_a_chain_is_not_drawn() {
    let patterns = chain(
        12,
        |number, before| {
            let fill = if before.is_empty() {
                "fill=\"red\""
            } else {
                before
            };
            let half = format!("<rect width=\"50\" height=\"25\" {fill}/>");
            format!(
                r#"<pattern id="l{number}" width="50" height="50" patternUnits="userSpaceOnUse">{half}<g transform="translate(0 25)">{half}</g></pattern>"#
            )
        },
        r#"fill="url(#)""#,
    );
    let masks = chain(
        14,
        |number, before| {
            let half =
                format!("<g {before}><rect width=\"100\" height=\"50\" fill=\"white\"/></g>");
            format!(r#"<mask id="l{number}" {ALL} maskUnits="userSpaceOnUse">{half}{half}</mask>"#)
        },
        r#"mask="url(#)""#,
    );
    let clips = chain(
        14,
        |number, before| {
            let half = format!("<rect {before} width=\"100\" height=\"50\"/>");
            format!(r#"<clipPath id="l{number}">{half}{half}</clipPath>"#)
        },
        r#"clip-path="url(#)""#,
    );
    for (links, used) in [
        (patterns, r#"fill="url(#l11)""#),
        (masks, r#"mask="url(#l13)""#),
        (clips, r#"clip-path="url(#l13)""#),
    ] {
        let said = read(&format!("{links}<rect {ALL} {used}/>"));
        let is_refused = matches!(said, Err(PictureError::SvgWork | PictureError::SvgMemory));
        assert!(is_refused, "{used}: {:?}", said.err());
    }
}

#[test]
fn a_tile_as_large_as_a_field_is_not_drawn() {
    let said = read(
        r#"<defs><pattern id="p" width="1e6" height="1e6" patternUnits="userSpaceOnUse"><rect width="9" height="9"/></pattern></defs><rect width="100" height="100" fill="url(#p)"/>"#,
    );
    assert_eq!(said.err(), Some(PictureError::SvgMemory));
}

#[test]
fn filters_that_look_at_too_many_pixels_are_not_drawn() {
    let ones = "1 ".repeat(625);
    let filtered = |primitives: &str| {
        read(&format!(
            r#"<defs><filter id="f" x="0" y="0" width="1" height="1">{primitives}</filter></defs><rect {ALL} filter="url(#f)"/>"#
        ))
    };
    for primitives in [
        format!(r#"<feConvolveMatrix order="25" kernelMatrix="{ones}"/>"#),
        r#"<feMorphology operator="dilate" radius="40"/>"#.to_owned(),
        r#"<feTurbulence baseFrequency="0.05" numOctaves="9"/>"#.to_owned(),
        r#"<feGaussianBlur stdDeviation="30"/>"#.repeat(40),
    ] {
        let said = filtered(&primitives);
        let is_refused = matches!(said, Err(PictureError::SvgWork | PictureError::SvgMemory));
        assert!(is_refused, "{primitives}: {:?}", said.err());
    }
    assert!(filtered(r#"<feGaussianBlur stdDeviation="2"/>"#).is_ok());
}

#[test]
fn heaps_are_not_drawn() {
    let groups = format!(
        "{}<rect {ALL}/>{}",
        r#"<g opacity="0.9">"#.repeat(300),
        "</g>".repeat(300)
    );
    let rectangles = format!(r#"<rect {ALL} fill="red" opacity="0.5"/>"#).repeat(3000);
    let zigzag = format!(r#"<path d="M0 0{}"/>"#, " L100 100L0 0".repeat(200_000));
    let dashes = r#"<path d="M0 0L100 100" stroke="red" stroke-dasharray="0.00001 0.00001"/>"#;
    // A long way in a small place, in as many dashes as are drawn of one path.
    let long = format!(
        r#"<path d="M0 0{}" stroke="red" fill="none" stroke-dasharray="0.008 0.008"/>"#,
        " L4 4L0 0".repeat(1000)
    );
    for drawn in [
        groups,
        rectangles,
        zigzag,
        dashes.repeat(50),
        long.repeat(100),
    ] {
        let said = read(&drawn);
        let is_refused = matches!(said, Err(PictureError::SvgWork | PictureError::SvgMemory));
        assert!(is_refused, "{:.60}: {:?}", drawn, said.err());
    }
}

#[test]
fn copies_of_copies_end() {
    let uses: String = (1..26)
        .map(|number| {
            let before = number - 1;
            format!(r##"<g id="u{number}"><use href="#u{before}"/><use href="#u{before}"/></g>"##)
        })
        .collect();
    let leaf = r#"<g id="u0"><rect width="1" height="1"/></g>"#;
    let said = read(&format!("<defs>{leaf}{uses}</defs><use href=\"#u25\"/>"));
    assert!(said.is_err());
    let marker = r#"<marker id="m"><path d="M0 0 1 1 2 2" marker-mid="url(#m)"/></marker>"#;
    let said = read(&format!(
        "<defs>{marker}</defs><path d=\"M0 0 1 1 2 2\" marker-mid=\"url(#m)\"/>"
    ));
    assert_eq!(said.err(), Some(PictureError::SvgMarkers));
}

#[test]
fn a_print_of_three_thousand_leaves_is_drawn() {
    let leaves: String = (0..3000)
        .map(|leaf| {
            let (x, y) = (leaf % 97, leaf % 89);
            format!(r##"<path fill="#307a3c" d="M{x} {y}q2 -3 4 0q-2 3 -4 0z"/>"##)
        })
        .collect();
    let picture = read(&leaves).expect("a print");
    let green = picture.pixels.chunks_exact(4).filter(|pixel| 0 < pixel[3]);
    assert!(100_000 < green.count());
}

/// Numbered things, one after the other.
fn many(count: usize, one: impl Fn(usize) -> String) -> String {
    (0..count).map(one).collect()
}

const SMALL: &str = r#"width="9" height="9""#;

/// Each of these is read without an end, or for minutes, before anything is drawn.
#[test]
fn what_is_read_for_ever_is_not_read() {
    let gradients = |links: &str| {
        let pairs = links.split(' ').map(|pair| pair.split_at(1));
        let all = pairs.map(|(id, to)| format!(r##"<linearGradient id="{id}" href="#{to}"/>"##));
        let all: String = all.collect();
        format!(r#"<defs>{all}</defs><rect {SMALL} fill="url(#a)"/>"#)
    };
    let rules = many(20_000, |number| format!(".a{number}{{fill:red}}"));
    let chain = many(20_000, |number| {
        format!(r##"<pattern id="p{number}" href="#p{}"/>"##, number + 1)
    });
    let cases = [
        // Those that inherit in a circle that does not come back to the first.
        gradients("ab bc cb"),
        gradients("ab bc cd db"),
        gradients("ab bc cb")
            .replace("linearGradient", "filter")
            .replace("fill=", "filter="),
        // Many that inherit in a chain, used often.
        format!("<defs>{chain}</defs>")
            + &format!(r#"<rect {SMALL} fill="url(#p0)"/>"#).repeat(2000),
        // Every rule is looked at for every element.
        format!("<style>{rules}</style>") + &"<g/>".repeat(20_000),
        format!("<style>{}.b{{fill:red}}</style>", ".a,".repeat(100_000)) + &"<g/>".repeat(20_000),
        // Every declaration is made for every element that a rule is for.
        format!("<style>g{{{}}}</style>", "fill:red;".repeat(100_000)) + &"<g/>".repeat(20_000),
        // A gradient is read anew wherever it is used.
        format!(
            "<linearGradient id=\"s\">{}</linearGradient>",
            "<stop/>".repeat(100_000)
        ) + &format!(r#"<rect {SMALL} fill="url(#s)"/>"#).repeat(10_000),
        // Every attribute is looked for among those before it.
        format!(
            "<g {}/>",
            many(100_000, |number| format!(r#"a{number}="1" "#))
        ),
        format!(
            "<g style=\"{}\"/>",
            many(200_000, |number| format!("a{number}:1;"))
        ),
        // What lies in itself is looked for anew after each that was found.
        many(20_000, |number| {
            format!(r#"<pattern id="p{number}"><g fill="url(#p{number})"/></pattern>"#)
        }),
        many(20_000, |number| {
            format!(
                r#"<clipPath id="p{number}"><rect {SMALL} clip-path="url(#p{number})"/></clipPath>"#
            )
        }),
        // What is named is looked through for everything that names it.
        format!(
            r#"<pattern id="q">{}</pattern><pattern id="p">{}</pattern>"#,
            "<g/>".repeat(20_000),
            r#"<g fill="url(#q)"/>"#.repeat(20_000)
        ),
        format!(
            r#"<style>g{{fill:url(#q)}}</style><pattern id="q">{0}</pattern>"#,
            "<g/>".repeat(20_000),
        ),
    ];
    for drawn in cases {
        assert_eq!(
            read(&drawn).err(),
            Some(PictureError::SvgWork),
            "{drawn:.120}"
        );
    }
}

/// Three that lie in each other have no bottom; a reader finds only two.
#[test]
fn what_lies_in_itself_by_way_of_others_is_not_read() {
    let cycle = |kind: &str, key: &str| {
        let links = [("a", "b"), ("b", "c"), ("c", "a")];
        let links = links.map(|(id, to)| {
            format!(r##"<{kind} id="{id}" {SMALL}><rect {SMALL} {key}="url(#{to})"/></{kind}>"##)
        });
        format!(
            r#"<defs>{}</defs><rect {SMALL} {key}="url(#a)"/>"#,
            links.concat()
        )
    };
    for (kind, key) in [
        ("pattern", "fill"),
        ("mask", "mask"),
        ("clipPath", "clip-path"),
    ] {
        let said = read(&cycle(kind, key));
        assert_eq!(said.err(), Some(PictureError::SvgWork), "{kind}");
    }
}

/// What people's programs write lies far below the bounds.
#[test]
fn styles_and_gradients_of_drawing_programs_are_read() {
    let rules = many(300, |number| {
        format!(".cls-{number}{{fill:url(#g{number})}}\n")
    });
    let gradients = many(300, |number| {
        let stops = r#"<stop stop-color="red"/><stop offset="1"/>"#;
        format!(
            r##"<linearGradient id="s{number}">{stops}</linearGradient><linearGradient id="g{number}" href="#s{number}" x1="1"/>"##
        )
    });
    let clips = many(200, |number| {
        format!(r#"<clipPath id="c{number}"><rect {SMALL} class="cls-1"/></clipPath>"#)
    });
    let leaves = many(600, |number| {
        let (class, clip) = (number % 300, number % 200);
        format!(
            r#"<g clip-path="url(#c{clip})"><rect {SMALL} class="cls-{class}" style="stroke:none;opacity:1"/></g>"#
        )
    });
    // A gradient that names itself is a slip of a pen and no harm.
    let slip = r##"<linearGradient id="me" href="#me"/>"##;
    let said = read(&format!(
        "<style>{rules}</style><defs>{gradients}{clips}{slip}</defs>{leaves}<rect {SMALL} fill=\"url(#me)\"/>"
    ));
    assert_eq!(said.err(), None);
}

/// The size is the width of an atom, and the circle that of a table.
#[test]
fn what_lies_far_outside_is_not_drawn() {
    let text = r#"<svg xmlns="http://www.w3.org/2000/svg" width="3e-8em" height="8e-9mm"><circle r="4916"/></svg>"#;
    let said = Picture::read(text.as_bytes()).err();
    assert!(said.is_some_and(|error| error.to_string().contains("far out of its edges")));
    // As far as a field from its leaf is nothing.
    for far in ["100", "-100000"] {
        assert!(read(&format!(r#"<circle cx="{far}" cy="{far}" r="99000"/>"#)).is_ok());
    }
}

/// A filter so high that `usvg` panics while it reads: the drawing is lost, and no more.
#[test]
fn a_panic_of_a_library_is_a_sentence() {
    let high = r#"<defs><filter id="f" height="6e31"/></defs><rect width="0.005" height="2e31" filter="url(#f)"/>"#;
    let text = format!(r#"<svg xmlns="http://www.w3.org/2000/svg">{high}</svg>"#);
    let said = Picture::read(text.as_bytes()).err();
    assert!(said.is_some_and(|error| error.to_string().contains("cannot be drawn")));
}
