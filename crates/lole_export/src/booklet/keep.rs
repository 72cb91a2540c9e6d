//! Tools and care: what the materials and steps of a costume ask for, and nothing else.

use lole_costume::order::{DancerPlan, PlannedGarment};
use lole_language::{Words, words};
use lole_pattern::pattern::NotionKind;

/// What matters of the garments for tools and care.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
struct Made {
    /// Something is cut from cloth.
    of_cloth: bool,
    /// Something of cloth can be washed: nothing else is sewn onto it.
    is_washed: bool,
    /// Something is sewn along seams and hems.
    is_sewn: bool,
    /// Cloth is gathered on cords.
    on_cords: bool,
    /// A belt of leaves is braided of cord.
    of_leaves: bool,
    /// Cloth that can be washed is gathered on elastics around the body, and not at sleeves alone.
    is_drawn_in_above: bool,
}

/// Whether a garment takes such a notion.
fn takes(garment: &PlannedGarment, kinds: &[NotionKind]) -> bool {
    let mut notions = garment.tailored.pattern.notions.iter();
    notions.any(|notion| kinds.contains(&notion.kind))
}

/// What spoils in water or is sewn onto what does not.
const NOT_WASHED: &[NotionKind] = &[
    NotionKind::Flower,
    NotionKind::Pistil,
    NotionKind::Leaf,
    NotionKind::Raffia,
    NotionKind::Film,
    NotionKind::HairPin,
    NotionKind::Gourd,
    NotionKind::Bamboo,
    NotionKind::Feather,
];

/// Whether a garment is sewn along seams or hems, so that a machine is of use.
pub(super) fn is_sewn(garment: &PlannedGarment) -> bool {
    takes(garment, &[NotionKind::Thread])
}

fn made(plan: &DancerPlan) -> Made {
    let mut made = Made::default();
    for garment in &plan.garments {
        let of_cloth = !garment.plans.is_empty();
        made.of_cloth |= of_cloth;
        made.is_washed |= of_cloth && !takes(garment, NOT_WASHED);
        made.is_sewn |= is_sewn(garment);
        made.on_cords |= of_cloth
            && takes(garment, &[NotionKind::Cord])
            && !takes(garment, &[NotionKind::Elastic]);
        let mut elastics = garment.tailored.pattern.notions.iter();
        made.is_drawn_in_above |= of_cloth
            && !takes(garment, NOT_WASHED)
            && elastics.any(|it| it.kind == NotionKind::Elastic && it.place.is_none());
        made.of_leaves |= takes(garment, &[NotionKind::Leaf]);
    }
    made
}

/// A tool or a rule, where it is needed.
type Row = (bool, Words);

fn needed(rows: Vec<Row>) -> Vec<Words> {
    let rows = rows.into_iter().filter(|(is_needed, _)| *is_needed);
    rows.map(|(_, words)| words).collect()
}

/// The tools, in the order in which they are taken up.
pub(super) fn tools(plan: &DancerPlan) -> Vec<Words> {
    let made = made(plan);
    let any = |kinds: &[NotionKind]| plan.garments.iter().any(|garment| takes(garment, kinds));
    let by_needle = any(&[NotionKind::Feather, NotionKind::HairPin]);
    needed(vec![
        (
            made.is_sewn,
            words(
                "ミシン（または手縫い針）",
                "a sewing machine (or hand needles)",
            ),
        ),
        (by_needle, words("手縫い針と糸", "a hand needle and thread")),
        (
            any(&[NotionKind::Flower]) && !made.of_leaves,
            words("レイ針（長い針）", "a lei needle (a long one)"),
        ),
        (made.is_sewn, words("アイロン", "an iron")),
        (made.of_cloth, words("長い定規", "a long ruler")),
        (made.of_cloth, words("チャコ", "chalk")),
        (made.of_cloth, words("布用のはさみ", "fabric scissors")),
        (
            !made.of_cloth && any(&[NotionKind::Flower, NotionKind::Leaf, NotionKind::Raffia]),
            words("はさみ", "scissors"),
        ),
        (
            any(&[NotionKind::Film]),
            words("紙用のはさみ", "paper scissors"),
        ),
        (
            any(&[NotionKind::Leaf]) && any(&[NotionKind::Cord]),
            words("小刀", "a small knife"),
        ),
        (made.is_sewn, words("まち針", "pins")),
        (
            any(&[NotionKind::Elastic]) || made.on_cords,
            words("ゴム通し（ひも通し）", "a bodkin"),
        ),
        (
            any(&[NotionKind::HairPin]),
            words("ほつれ止め液", "fray sealant"),
        ),
        (
            any(&[NotionKind::Gourd, NotionKind::Bamboo]),
            words("細かいのこぎり", "a fine saw"),
        ),
        (any(&[NotionKind::Bamboo]), words("小刀", "a knife")),
        (
            any(&[NotionKind::Gourd, NotionKind::Bamboo]),
            words("紙やすり", "sandpaper"),
        ),
        (
            any(&[
                NotionKind::Flower,
                NotionKind::Leaf,
                NotionKind::Raffia,
                NotionKind::Film,
            ]) && !made.of_cloth,
            words("巻き尺", "a tape measure"),
        ),
    ])
}

/// How it is kept, one sentence or two for each material.
pub(super) fn care(plan: &DancerPlan) -> Vec<Words> {
    let made = made(plan);
    let any = |kinds: &[NotionKind]| plan.garments.iter().any(|garment| takes(garment, kinds));
    let washed = |kind| {
        (plan.garments.iter())
            .any(|it| !it.plans.is_empty() && takes(it, &[kind]) && !takes(it, NOT_WASHED))
    };
    let mut rows = of_cloth(&made, &washed);
    rows.extend([
        (
            any(&[NotionKind::Leaf]),
            words(
                "葉は洗えません。使うまで湿らせた紙に包んで冷蔵庫に入れ、使ったあとは土に返します。",
                "Leaves are not washed. Keep them in damp paper in the cold until they are worn, and give them back to the earth afterwards.",
            ),
        ),
        (
            any(&[NotionKind::Flower]),
            words(
                "生花は霧を吹いて冷蔵庫に入れ、その日のうちに使います。造花は洗わず、柔らかいはけでほこりを払います。",
                "Mist fresh flowers, keep them cold and wear them the same day. Artificial ones are not washed: brush the dust off softly.",
            ),
        ),
        (
            any(&[NotionKind::Raffia]),
            words(
                "ラフィアは洗いません。振ってほこりを落とし、霧を吹いて手でまっすぐに伸ばし、乾いた所につるします。",
                "Raffia is not washed. Shake the dust out, mist it, draw it straight by hand and hang it where it is dry.",
            ),
        ),
        (
            any(&[NotionKind::Film]),
            words(
                "フィルムは洗わず、アイロンをかけません。乾いた布で拭き、折らずにつるして、熱い所に置かないようにします。",
                "Film is neither washed nor ironed. Wipe it with a dry cloth, hang it without folds and keep it from heat.",
            ),
        ),
        (
            any(&[NotionKind::HairPin]),
            words(
                "髪飾りは洗いません。柔らかいはけでほこりを払い、つぶれないように箱にしまいます。",
                "The hair flower is not washed. Brush the dust off softly and keep it in a box where nothing presses on it.",
            ),
        ),
        (
            any(&[NotionKind::Gourd, NotionKind::Bamboo]),
            words(
                "水で洗わず、乾いた布で拭きます。日なたと湿気を避け、落とさないように袋に入れてしまいます。",
                "It is not washed: wipe it with a dry cloth. Keep it in a bag, from sun, damp and falls.",
            ),
        ),
        (
            any(&[NotionKind::Feather]),
            words(
                "羽根はぬらさず、筆で向きを整えます。虫よけといっしょにしまいます。",
                "Keep the feathers dry, smooth them with a brush and store them with something against moths.",
            ),
        ),
    ]);
    needed(rows)
}

/// Rules for what can be washed.
fn of_cloth(made: &Made, washed: &dyn Fn(NotionKind) -> bool) -> Vec<Row> {
    let elastic = washed(NotionKind::Elastic);
    // A dress or blouse has elastics at its sleeves only, and does not hang by them.
    let hangs_by_elastic = made.is_drawn_in_above;
    vec![
        (
            made.is_washed,
            words(
                "布のものは、ネットに入れて、ぬるま湯か水で手洗い、または洗濯機の弱いコースで洗います。濃い色は分けて洗います。",
                "Wash what is of cloth in a net, by hand or on a gentle cycle, in cool or lukewarm water. Wash dark colors apart.",
            ),
        ),
        (
            washed(NotionKind::Zip),
            words(
                "洗う前に、ファスナーを閉め、ホックがあれば留めます。",
                "Close the zip, and a hook where there is one, before washing.",
            ),
        ),
        (
            made.on_cords,
            words(
                "ひもは洗う前に抜き、布を広げて洗います。乾いたら通し直します。",
                "Draw the cords out and spread the cloth before washing; draw them in again when it is dry.",
            ),
        ),
        (
            hangs_by_elastic,
            words(
                "ギャザーをのばさないように、ゴムのところを持ってつるし、日陰に干します。",
                "Hang by the elastics in the shade, so that the gathers keep their shape.",
            ),
        ),
        (
            made.is_washed && !hangs_by_elastic,
            words(
                "形を整えて、日陰に干します。",
                "Pull it into shape and dry it in the shade.",
            ),
        ),
        (
            made.is_washed && elastic,
            words(
                "アイロンは布の表示にしたがい、ゴムの上は避けます。ゴムは伸びたら、縫い目の口をほどいて取り替えます。",
                "Iron as the cloth’s label says, and not over the elastic. When an elastic gets loose, open its gap in the seam and replace it.",
            ),
        ),
        (
            made.is_washed && !elastic,
            words(
                "アイロンは布の表示にしたがい、裏からかけます。",
                "Iron from the wrong side, as the cloth’s label says.",
            ),
        ),
    ]
}
