#[path = "../../lole_pattern/tests/shapes/mod.rs"]
mod shapes;
use lole_costume::tailoring::{Cloth, GarmentPattern};
use lole_export::cutting::*;
use lole_export::pdf::{Document, Paper};
use lole_geom::Length;
use lole_language::{Language, words};
use lole_pattern::marker::{Lay, Nap};
#[test]
fn zz() {
    let garment = GarmentPattern {
        id: "trial".to_owned(),
        name: words("試しの服", "trial pāʻū"),
        pattern: shapes::pattern(),
        cloth: Cloth {
            name: words("木綿", "cotton"),
            width: Length::from_cm(110.0),
            areal_density: 0.12,
            nap: Nap::TwoWay,
            has_border: false,
            repeat: None,
        },
    };
    for (lay, name) in [(Lay::Single, "single"), (Lay::Folded, "folded")] {
        let t = std::time::Instant::now();
        let cut = CutGarment {
            plans: garment.cloth_plans(lay, None),
            garment: garment.clone(),
        };
        eprintln!(
            "{name} {:?} {:?} eff {}",
            t.elapsed(),
            cut.plans[0].marker.yardage,
            cut.plans[0].marker.efficiency
        );
        for (lang, l) in [(Language::Japanese, "ja"), (Language::English, "en")] {
            let pdf = |sheets| {
                Document {
                    title: "t".into(),
                    language: "ja",
                    sheets,
                }
                .to_bytes()
                .unwrap()
            };
            let w = |f: &str, b: &[u8]| {
                std::fs::write(format!("/tmp/look_paper/{name}-{l}-{f}"), b).unwrap()
            };
            let cuts = [cut.clone()];
            w("plan.pdf", &pdf(cut_plan_sheets(&cuts, Paper::A4, lang)));
            w("plan.svg", &cut_plan_svg(&cuts, lang));
            if lay == Lay::Single {
                w("ruler.pdf", &pdf(ruler_sheets(&cuts, Paper::A4, lang)));
                let t = std::time::Instant::now();
                let tiled = tiled_sheets(&cut, Paper::A4, lang).unwrap();
                eprintln!(
                    "tiles {:?} {} {:?}",
                    t.elapsed(),
                    tiled.sheets.len(),
                    tiled.grid
                );
                w("tiles.pdf", &pdf(tiled.sheets));
                w("pieces.svg", &pieces_svg(&cut, lang));
                w("pieces.dxf", &lole_export::dxf::pattern_dxf(&cut, "7"));
            }
        }
    }
}
