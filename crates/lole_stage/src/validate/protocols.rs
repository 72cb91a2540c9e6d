//! The table of protocols, in the order in which they run.

use lole_language::words;

use super::{
    Curve, Protocol, Subject, cantilever, capstan, catenary, chain, column, convergence, creep,
    drape, fabric_drape, hanging_strip, incline, lateral, momentum, pendulum, residual,
    skirt_weight, stick_slip, waistband, wave,
};

/// All protocols.
pub const PROTOCOLS: &[Protocol] = &[
    Protocol {
        name: "cantilever",
        about: words(
            "片側を固定した布の垂れの縦横比（重い弾性線と比べる）",
            "height over width of a clamped strip under its own weight, against the heavy elastica",
        ),
        subjects: &Subject::ALL,
        limits: &[(
            Subject::Xpbd,
            words(
                "40分割では、曲げ長さあたり8マスまで布どおりに曲がります（12分割では4マス）。それより細かいと曲がりすぎます",
                "bends as its fabric up to eight cells a bending length with 40 substeps, four with 12; too deep on finer cells",
            ),
        )],
        curve: Some(Curve {
            along: words("Γ = w L³ / B", "Γ = w L³ / B"),
            value: words("垂れの縦横比", "Height over width"),
            points: cantilever::points,
        }),
        run: cantilever::run,
    },
    Protocol {
        name: "convergence",
        about: words(
            "固定した帯の垂れが、分割を細かくすると弾性線に近づく速さ",
            "how the hanging of a clamped strip nears the elastica as its cells grow finer",
        ),
        subjects: &Subject::ALL,
        limits: &[(
            Subject::Xpbd,
            words(
                "2次で近づくのは、分割数で決まる細かさまでです",
                "nears it with the second order only up to the fineness that its substeps allow",
            ),
        )],
        curve: Some(Curve {
            along: words("分割 N", "cells N"),
            value: words("Γ = 8 の垂れの縦横比", "Height over width at Γ = 8"),
            points: convergence::points,
        }),
        run: convergence::run,
    },
    Protocol {
        name: "self-buckling",
        about: words(
            "立てた布が自重で倒れはじめる Γ",
            "the Γ at which an upright clamped strip falls over under its own weight",
        ),
        subjects: &Subject::ALL,
        limits: &[],
        curve: None,
        run: column::run,
    },
    Protocol {
        name: "lateral-buckling",
        about: words(
            "細い縁で立てて片側を固定した布が横に倒れはじめる Γ（曲げとねじり）",
            "the Γ at which a strip held on its narrow edge tips over sideways: bending and twist",
        ),
        subjects: &Subject::ALL,
        limits: &[],
        curve: None,
        run: lateral::run,
    },
    Protocol {
        name: "hanging-strip",
        about: words(
            "吊るした布の伸び（各ばねの下の重さの和と比べる）",
            "how far a hanging strip stretches, against the sum of the weights below each spring",
        ),
        subjects: &Subject::ALL,
        limits: &[(
            Subject::Xpbd,
            words(
                "0.1 % より伸びにくい布では、40本のばねを1分割で揃えきれず、余計に伸びます",
                "strips that should stretch less than 0.1 % stretch more: a substep does not straighten forty springs",
            ),
        )],
        curve: None,
        run: hanging_strip::run,
    },
    Protocol {
        name: "catenary",
        about: words(
            "両端を持った布のたるみ（懸垂線と比べる）",
            "sag of a strip held at both ends, against the catenary",
        ),
        subjects: &Subject::ALL,
        limits: &[],
        curve: None,
        run: catenary::run,
    },
    Protocol {
        name: "chain-mode",
        about: words(
            "吊るした布の遅い三つの揺れの周期（吊り鎖と比べる）",
            "periods of the three slowest swings of a hanging strip, against the hanging chain",
        ),
        subjects: &Subject::ALL,
        limits: &[],
        curve: None,
        run: chain::run,
    },
    Protocol {
        name: "pendulum",
        about: words(
            "振り子の周期（小さな揺れの周期との比、振幅ごと）",
            "period of a pendulum over that of its small swings, by amplitude",
        ),
        subjects: &Subject::ALL,
        limits: &[(
            Subject::Xpbd,
            words(
                "位置が f32 なので、分割を増やすと丸めが、減らすと振幅の減りが効きます",
                "positions are f32: more substeps round more, fewer lose more amplitude",
            ),
        )],
        curve: Some(Curve {
            along: words("振幅（度）", "amplitude (degrees)"),
            value: words("周期の比", "Period over that of small swings"),
            points: pendulum::points,
        }),
        run: pendulum::run,
    },
    Protocol {
        name: "wave-speed",
        about: words(
            "布を伝わる波の速さ（剛性と質量の比の平方根と比べる）",
            "how fast a pulse travels along a strip, against the root of stiffness over mass",
        ),
        subjects: &Subject::ALL,
        limits: &[(
            Subject::Xpbd,
            words(
                "1分割の間に1マスより遠くへ進む波は遅くなります。それより遅い波は正しく伝わります",
                "waves that travel farther than a cell in a substep are slowed; slower ones travel as they should",
            ),
        )],
        curve: None,
        run: wave::run,
    },
    Protocol {
        name: "momentum",
        about: words(
            "何にも触れない布の運動量と角運動量の変化（すべての速さの和に対する割合）",
            "change of linear and angular momentum of a crumpled sheet in empty space, over the sum of all speeds",
        ),
        subjects: &Subject::ALL,
        limits: &[(
            Subject::Xpbd,
            words(
                "位置が f32 に丸められるので、1秒で千分の一ほど変わります",
                "positions are rounded to f32: a thousandth is lost or gained in a second",
            ),
        )],
        curve: None,
        run: momentum::run,
    },
    Protocol {
        name: "incline",
        about: words(
            "斜面の布は摩擦角より緩ければ止まり、急なら滑り、動く面には運ばれる",
            "a patch on a slope sticks below the angle of friction, slides above it, and is carried by a belt",
        ),
        subjects: &Subject::ALL,
        limits: &[(
            Subject::Xpbd,
            words(
                "摩擦角を0.5°超えた斜面では、f32 の丸めが加速度の数 % になります（摩擦力の 0.1 %）",
                "half a degree above the angle of friction, rounding to f32 is some percent of the acceleration, 0.1 % of the friction",
            ),
        )],
        curve: None,
        run: incline::run,
    },
    Protocol {
        name: "creep",
        about: words(
            "斜面に置いた畳んだ布が、摩擦角より緩い坂で1分間に動く距離",
            "how far a stack of folded cloth comes in a minute on a slope below the angle of friction",
        ),
        subjects: &[Subject::Xpbd],
        limits: &[],
        curve: None,
        run: creep::run,
    },
    Protocol {
        name: "capstan",
        about: words(
            "円柱に半周かけた布を引くときの張力の比 exp(μ π)",
            "how much harder a strip must be pulled over half a turn of a cylinder: exp(μ π)",
        ),
        subjects: &Subject::ALL,
        limits: &[],
        curve: Some(Curve {
            along: words("摩擦係数 μ", "friction μ"),
            value: words("張力の比", "Ratio of the tensions"),
            points: capstan::points,
        }),
        run: capstan::run,
    },
    Protocol {
        name: "stick-slip",
        about: words(
            "固定した布を台に押しつけ、先端が滑りだすまでの押し込み",
            "how far a clamped strip is pushed against a table before its tip slips",
        ),
        subjects: &Subject::ALL,
        limits: &[],
        curve: Some(Curve {
            along: words("摩擦係数 μ", "friction μ"),
            value: words("滑りだす押し込み Δ / L", "Push at which it slips, Δ / L"),
            points: stick_slip::points,
        }),
        run: stick_slip::run,
    },
    Protocol {
        name: "waistband",
        about: words(
            "体に巻いたゴムの張力（摩擦で支えられる重さから求める）",
            "tension of an elastic band around a body, by the weight that its friction holds",
        ),
        subjects: &Subject::ALL,
        limits: &[
            (
                Subject::FbEuler,
                words(
                    "ペナルティ接触なので少しめり込み、そのぶん張力が下がります",
                    "contact is a penalty: the band sinks in a little and is that much less stretched",
                ),
            ),
            (
                Subject::Xpbd,
                words(
                    "ばねは除算のない3次式で、25 % の伸びでは張力が 4 % 小さくなります",
                    "springs are a cubic without division, 4 % too soft at a stretch of 25 %",
                ),
            ),
        ],
        curve: None,
        run: waistband::run,
    },
    Protocol {
        name: "skirt-weight",
        about: words(
            "吊るしたスカートのウエストにかかる力（スカートの重さと比べる）",
            "what the waist of a freely hanging skirt carries, against its weight",
        ),
        subjects: &Subject::ALL,
        limits: &[],
        curve: None,
        run: skirt_weight::run,
    },
    Protocol {
        name: "residual-curvature",
        about: words(
            "丸めた布を放したときに残る曲率（糸の摩擦 2HB / (2 B) と比べる）",
            "curvature that a rolled strip keeps when it is let go, against 2HB / (2 B) of its yarns' friction",
        ),
        subjects: &Subject::ALL,
        limits: &[(
            Subject::FbEuler,
            words(
                "弾性だけで、内部の摩擦はありません。平らに戻ります",
                "elastic, without internal friction: the strip unrolls until it is flat",
            ),
        )],
        curve: None,
        run: residual::run,
    },
    Protocol {
        name: "drape",
        about: words(
            "円盤にのせた四角い布のドレープ係数（曲げ長さごと、片持ちの帯の見積もりと比べる）",
            "drape coefficient of a square on a disc over the bending length, against strips clamped level",
        ),
        subjects: &Subject::ALL,
        limits: &[
            (Subject::FbEuler, DRAPE_LIMIT),
            (Subject::Xpbd, DRAPE_LIMIT),
        ],
        curve: Some(Curve {
            along: words("曲げ長さ（cm）", "bending length (cm)"),
            value: words("ドレープ係数（%）", "Drape coefficient (%)"),
            points: drape::points,
        }),
        run: drape::run,
    },
    Protocol {
        name: "fabric-drape",
        about: words(
            "測定された10種の布の丸い試験片のドレープ係数とひだの数（別の方法で求めた板のつり合いと比べる）",
            "drape coefficient and folds of round specimens of ten measured fabrics, against the rests of a plate that is solved in another way",
        ),
        subjects: &[Subject::Xpbd],
        limits: &[],
        curve: None,
        run: fabric_drape::run,
    },
];

const DRAPE_LIMIT: lole_language::Words = words(
    "弾性だけの布です。測った布は内部の摩擦でもっと硬く垂れます。見積もりは隣どうしの帯を切り離しているので、柔らかい布では低めです",
    "an elastic cloth: measured ones drape stiffer by internal friction; and the estimate cuts the strips apart, so it is low for limp cloth",
);
