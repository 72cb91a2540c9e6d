//! The situations: costumes, dancers, cloths, sets and distances that a look must hold in.

use lole_render::View;

/// What of the dancer is shown.
#[derive(Clone, Copy)]
pub(crate) enum Part {
    /// All of her with what she wears.
    Whole,
    /// Her head.
    Head,
    /// Head and chest.
    Bust,
    /// Around the band of a skirt.
    Waist,
    /// Feet and hem.
    Feet,
}

/// One picture.
pub(crate) struct Situation {
    pub(crate) name: &'static str,
    /// Its design.
    pub(crate) document: &'static str,
    /// Moment of the dance [s].
    pub(crate) seconds: f32,
    pub(crate) view: View,
    pub(crate) part: Part,
}

const fn whole(name: &'static str, seconds: f32, view: View, document: &'static str) -> Situation {
    Situation {
        name,
        document,
        seconds,
        view,
        part: Part::Whole,
    }
}

const fn close(name: &'static str, part: Part, view: View, document: &'static str) -> Situation {
    Situation {
        name,
        document,
        seconds: 1.2,
        view,
        part,
    }
}

/// All of them, in the order of the sheet.
pub(crate) const SITUATIONS: &[Situation] = &[
    whole("kaholo", 2.3, View::ThreeQuarter, "lole = 1\n"),
    whole(
        "ami-back",
        2.0,
        View::Back,
        "lole = 1\n[motion]\nstep = \"ami\"\n[print]\ncolorway = \"blue\"\n",
    ),
    whole(
        "double-beach",
        1.6,
        View::ThreeQuarter,
        concat!(
            include_str!("../../../../docs/double-pau.lole"),
            "\n[stage]\nset = \"beach\"\n"
        ),
    ),
    whole(
        "muumuu-lawn",
        1.9,
        View::ThreeQuarter,
        "lole = 1\n[skirt]\nworn = \"no\"\n[stage]\nset = \"lawn\"\n[motion]\nstep = \"hela\"\n[[garment]]\nkind = \"muumuu\"\n[[garment]]\nkind = \"lei\"\n",
    ),
    whole(
        "holoku-theater",
        1.5,
        View::Turned(0.9),
        "lole = 1\n[skirt]\nworn = \"no\"\n[stage]\nset = \"theater\"\n[[garment]]\nkind = \"holoku\"\n[[garment]]\nkind = \"lei\"\n",
    ),
    whole(
        "kikepa-beach",
        1.4,
        View::Front,
        "lole = 1\n[skirt]\nworn = \"no\"\n[stage]\nset = \"beach\"\n[[garment]]\nkind = \"kikepa\"\n[[garment]]\nkind = \"lei-poo\"\n",
    ),
    whole(
        "blouse-pau",
        1.7,
        View::ThreeQuarter,
        "lole = 1\n[stage]\nset = \"plain\"\n[[garment]]\nkind = \"blouse\"\n[garment.print]\nmotif = \"plain\"\nground = \"#f4ead8\"\n[[garment]]\nkind = \"lei\"\n",
    ),
    whole(
        "malo-kihei",
        1.5,
        View::Turned(-0.6),
        "lole = 1\n[dancer]\nfigure = \"man\"\nstature_cm = 176\n[skirt]\nworn = \"no\"\n[stage]\nset = \"lawn\"\n[[garment]]\nkind = \"malo\"\n[[garment]]\nkind = \"kihei\"\n",
    ),
    whole(
        "ti-leaf",
        1.4,
        View::ThreeQuarter,
        "lole = 1\n[skirt]\nworn = \"no\"\n[stage]\nset = \"beach\"\n[motion]\nstep = \"uwehe\"\n[[garment]]\nkind = \"ti-leaf-skirt\"\n[[garment]]\nkind = \"lei-poo\"\n[[garment]]\nkind = \"kupee\"\n",
    ),
    whole(
        "cellophane",
        1.6,
        View::Front,
        "lole = 1\n[skirt]\nworn = \"no\"\n[stage]\nset = \"theater\"\n[motion]\nstep = \"ami\"\n[[garment]]\nkind = \"cellophane-skirt\"\n",
    ),
    whole(
        "raffia",
        1.6,
        View::Side,
        "lole = 1\n[skirt]\nworn = \"no\"\n[stage]\nset = \"plain\"\n[[garment]]\nkind = \"raffia-skirt\"\n",
    ),
    whole(
        "kahiko",
        1.5,
        View::ThreeQuarter,
        "lole = 1\n[skirt]\nworn = \"no\"\n[stage]\nset = \"lawn\"\n[motion]\nstep = \"kawelu\"\n[[garment]]\nkind = \"pau-kahiko\"\n[[garment]]\nkind = \"lei-poo\"\n",
    ),
    whole(
        "velvet",
        1.8,
        View::Turned(-0.5),
        "lole = 1\n[fabric]\npreset = \"stretch-velvet\"\n[print]\nmotif = \"plain\"\nground = \"#3a0d2e\"\n[stage]\nset = \"theater\"\n",
    ),
    whole(
        "child",
        2.1,
        View::Front,
        "lole = 1\n[dancer]\nfigure = \"child\"\nstature_cm = 124\n[print]\ncolorway = \"blue\"\n[stage]\nset = \"lawn\"\n",
    ),
    whole(
        "large",
        1.9,
        View::Side,
        "lole = 1\n[dancer]\nstature_cm = 160\nbust_cm = 112\nwaist_cm = 98\nhip_cm = 118\n[stage]\nset = \"beach\"\n[skirt]\nworn = \"no\"\n[[garment]]\nkind = \"muumuu\"\n",
    ),
    close("face", Part::Head, View::Front, "lole = 1\n"),
    close(
        "profile",
        Part::Head,
        View::Side,
        "lole = 1\n[dancer]\nhair = \"long\"\n[stage]\nset = \"beach\"\n",
    ),
    close(
        "bust",
        Part::Bust,
        View::ThreeQuarter,
        "lole = 1\n[dancer]\nfigure = \"man\"\nstature_cm = 174\n[stage]\nset = \"theater\"\n[[garment]]\nkind = \"lei\"\n",
    ),
    close("band", Part::Waist, View::ThreeQuarter, "lole = 1\n"),
    close(
        "hem",
        Part::Feet,
        View::Turned(0.4),
        "lole = 1\n[stage]\nset = \"lawn\"\n",
    ),
];
