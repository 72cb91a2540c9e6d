//! The engine against closed forms: protocols with measured, reference, error and gate.
//!
//! A protocol is one file, one row of [`PROTOCOLS`]. It runs for every method that claims it; a
//! method's gate is what it promises, and its note says what keeps it from more.

mod beam;
mod cantilever;
mod capstan;
mod catenary;
mod chain;
mod check;
mod column;
mod drape;
mod elastica;
mod hanging_strip;
mod incline;
mod lateral;
mod momentum;
mod pendulum;
mod rig;
mod skirt_weight;
mod stick_slip;
mod waistband;
mod wave;

use lole_cloth::BuildError;

pub use check::Check;
pub use rig::Subject;

/// One protocol.
pub struct Protocol {
    /// Name for programs and for `--only`.
    pub name: &'static str,
    /// What is compared with what, in English.
    pub about: &'static str,
    /// The same in Japanese.
    pub about_ja: &'static str,
    run: fn(Subject) -> Result<Vec<Check>, BuildError>,
}

impl Protocol {
    /// Runs it for one method.
    ///
    /// # Errors
    /// A cloth that cannot be built: a mistake of the protocol.
    pub fn run(&self, subject: Subject) -> Result<Vec<Check>, BuildError> {
        (self.run)(subject)
    }
}

/// All protocols.
pub const PROTOCOLS: &[Protocol] = &[
    Protocol {
        name: "cantilever",
        about: "height over width of a clamped strip under its own weight, against the heavy elastica",
        about_ja: "片側を固定した布の垂れの縦横比（重い弾性線と比べる）",
        run: cantilever::run,
    },
    Protocol {
        name: "self-buckling",
        about: "the Γ at which an upright clamped strip falls over under its own weight",
        about_ja: "立てた布が自重で倒れはじめる Γ",
        run: column::run,
    },
    Protocol {
        name: "lateral-buckling",
        about: "the Γ at which a strip held on its narrow edge tips over sideways: bending and twist",
        about_ja: "細い縁で立てて片側を固定した布が横に倒れはじめる Γ（曲げとねじり）",
        run: lateral::run,
    },
    Protocol {
        name: "hanging-strip",
        about: "how far a hanging strip stretches, against the sum of the weights below each spring",
        about_ja: "吊るした布の伸び（各ばねの下の重さの和と比べる）",
        run: hanging_strip::run,
    },
    Protocol {
        name: "catenary",
        about: "sag of a strip held at both ends, against the catenary",
        about_ja: "両端を持った布のたるみ（懸垂線と比べる）",
        run: catenary::run,
    },
    Protocol {
        name: "chain-mode",
        about: "period of the slowest swing of a hanging strip, against the hanging chain",
        about_ja: "吊るした布のいちばん遅い揺れの周期（吊り鎖と比べる）",
        run: chain::run,
    },
    Protocol {
        name: "pendulum",
        about: "period of a pendulum over that of its small swings, by amplitude",
        about_ja: "振り子の周期（小さな揺れの周期との比、振幅ごと）",
        run: pendulum::run,
    },
    Protocol {
        name: "wave-speed",
        about: "how fast a pulse travels along a strip, against the root of stiffness over mass",
        about_ja: "布を伝わる波の速さ（剛性と質量の比の平方根と比べる）",
        run: wave::run,
    },
    Protocol {
        name: "momentum",
        about: "change of linear and angular momentum of a crumpled sheet in empty space",
        about_ja: "何にも触れない布の運動量と角運動量の変化",
        run: momentum::run,
    },
    Protocol {
        name: "incline",
        about: "a patch on a slope sticks below the angle of friction, slides above it, and is carried by a belt",
        about_ja: "斜面の布は摩擦角より緩ければ止まり、急なら滑り、動く面には運ばれる",
        run: incline::run,
    },
    Protocol {
        name: "capstan",
        about: "how much harder a strip must be pulled over half a turn of a cylinder: exp(μ π)",
        about_ja: "円柱に半周かけた布を引くときの張力の比 exp(μ π)",
        run: capstan::run,
    },
    Protocol {
        name: "stick-slip",
        about: "how far a clamped strip is pushed against a table before its tip slips",
        about_ja: "固定した布を台に押しつけ、先端が滑りだすまでの押し込み",
        run: stick_slip::run,
    },
    Protocol {
        name: "waistband",
        about: "tension of an elastic band around a body, by the weight that its friction holds",
        about_ja: "体に巻いたゴムの張力（摩擦で支えられる重さから求める）",
        run: waistband::run,
    },
    Protocol {
        name: "skirt-weight",
        about: "what the waist of a freely hanging skirt carries, against its weight",
        about_ja: "吊るしたスカートのウエストにかかる力（スカートの重さと比べる）",
        run: skirt_weight::run,
    },
    Protocol {
        name: "drape",
        about: "drape coefficient of a square on a disc over the bending length, against strips clamped level",
        about_ja: "円盤にのせた四角い布のドレープ係数（曲げ長さごと、片持ちの帯の見積もりと比べる）",
        run: drape::run,
    },
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_method_passes_its_gates() {
        for protocol in PROTOCOLS {
            for subject in Subject::ALL {
                for check in protocol.run(subject).unwrap() {
                    let name = format!("{} {}", protocol.name, subject.id());
                    assert!(check.passes(), "{name}: {check:?} {}", check.error_pct());
                }
            }
        }
    }
}
