//! The public descriptions the steps are compiled from.

/// A published description.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Source {
    /// Short name, as statements cite it.
    pub key: &'static str,
    /// Where it stands.
    pub place: &'static str,
}

const fn source(key: &'static str, place: &'static str) -> Source {
    Source { key, place }
}

/// All of them, in the order of their keys. They were read in excerpts, and none is copied.
pub const SOURCES: &[Source] = &[
    source("1", "hulasbymoikeha.blogspot.com, 2010-11"),
    source("2", "napuaokapiolani.com, hula fundamentals"),
    source(
        "3",
        "islapacifika.com, dance steps (after Pukui and Elbert)",
    ),
    source("4", "tutustaro.com, hula steps"),
    source("5", "malulani.club, hulastep/kao"),
    source("6", "malulani.club, hulastep/kaholo"),
    source("7", "hura-dance.com, step1"),
    source("8", "mangadehura.com, dance/step"),
    source("9", "hura-dance.com, step6; huladance.me, kawelu_step"),
    source("9b", "wis-dom.net, hula-basic-step"),
    source("10", "hulahalaukealakahiolahou.com"),
    source("11", "byuhhawaiianclub.blogspot.com, 2009"),
    source("11b", "byuhhawaiianclub.blogspot.com, 2009, turning kāholo"),
    source("12", "huladance.me, uehe_step and ami_step"),
    source("12b", "huladance.me"),
    source("13", "Honolulu Advertiser, 2010-04-04"),
    source("14", "amykstillman.wordpress.com, 2009"),
    source("15", "hura-dance.com, step4"),
    source("16", "hula-berlin.de, Was ist ʻai haʻa"),
    source("17", "Honolulu Advertiser, 2005-03-31"),
    source("18", "halau-na-ohia-lehua.com"),
    source("19", "hulahawaii-japan.com"),
    source("19b", "hulanaomi.com"),
    source(
        "20",
        "Komiyama et al. 2018, J Med Case Rep, doi 10.1186/s13256-018-1942-2 (abstract)",
    ),
    source(
        "21",
        "Tournillon and Siegler 2021, Hum Mov Sci 77:102791 (abstract)",
    ),
    source("23", "monkeysee.com, ʻami and ʻuwehe"),
    source("24", "ya-yanikki.com/1466"),
    source("25", "pomai.jp, blog/lesson-551"),
    source("26", "cakesi3.blogspot.com, 2014 (uniu)"),
    source("27", "wehewehe (Pukui and Elbert) via shntn.net/kawelu"),
    source("28", "findhobby.click, p=4671"),
    source("29", "hura-dance.com, step6"),
    source("30", "huladance.me, kalakaua_step"),
    source("31", "hoalahawaii.com, dyknov02 (Keaulana)"),
    source("32", "huladancehq.com"),
];
