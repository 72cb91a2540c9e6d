//! Keys of `[cost]`: prices as a shop told them. The price of a cloth stands with the cloth.

use lole_language::words;

use super::{Key, Kind, Table};
use crate::document::Currency;

const CURRENCIES: &[(&str, Currency)] = &[
    (Currency::Yen.id(), Currency::Yen),
    (Currency::Dollar.id(), Currency::Dollar),
];

/// The table.
pub(super) const COST: Table = Table {
    name: "cost",
    about: words(
        "費用。値段は店で見たものを書く。書かないものは数えず、たずねる",
        "prices as a shop told them; what is not written is not counted but asked for",
    ),
    keys: &[
        choice!(
            "currency",
            words("通貨", "currency"),
            CURRENCIES,
            cost.currency,
            "通貨",
            "currency"
        ),
        number_if_known!(
            "elastic_price_per_m",
            0.0..=100_000.0,
            cost.elastic_price_per_m,
            "ゴム 1 m の値段",
            "one meter of elastic"
        ),
        number_if_known!(
            "tape_price_per_m",
            0.0..=100_000.0,
            cost.tape_price_per_m,
            "テープやひも 1 m の値段",
            "one meter of tape or cord"
        ),
        number_if_known!(
            "thread_price_per_spool",
            0.0..=100_000.0,
            cost.thread_price_per_spool,
            "糸 1 巻きの値段",
            "one spool of thread"
        ),
        number!(
            "thread_spool_m",
            10.0..=10_000.0,
            cost.thread_spool_m,
            "糸 1 巻きの長さ",
            "thread on one spool"
        ),
        number_if_known!(
            "zip_price",
            0.0..=1_000_000.0,
            cost.notions.zip,
            "ファスナー 1 本の値段",
            "one zip"
        ),
        number_if_known!(
            "button_price",
            0.0..=1_000_000.0,
            cost.notions.button,
            "ボタン 1 個の値段",
            "one button"
        ),
        number_if_known!(
            "hook_price",
            0.0..=1_000_000.0,
            cost.notions.hook,
            "ホック 1 組の値段",
            "one hook and eye"
        ),
        number_if_known!(
            "flower_price",
            0.0..=1_000_000.0,
            cost.notions.flower,
            "花 1 個の値段",
            "one flower"
        ),
        number_if_known!(
            "pistil_price",
            0.0..=1_000_000.0,
            cost.notions.pistil,
            "しべ 1 本の値段",
            "one pistil"
        ),
        number_if_known!(
            "leaf_price",
            0.0..=1_000_000.0,
            cost.notions.leaf,
            "葉 1 枚の値段",
            "one leaf or fern"
        ),
        number_if_known!(
            "raffia_price_per_100g",
            0.0..=1_000_000.0,
            cost.notions.raffia_per_100g,
            "ラフィア 100 gの値段",
            "100 g of raffia"
        ),
        number_if_known!(
            "film_price_per_m",
            0.0..=1_000_000.0,
            cost.notions.film_per_m,
            "セロファンや OPP フィルム 1 mの値段",
            "one meter of cellophane or OPP film"
        ),
        number_if_known!(
            "hair_pin_price",
            0.0..=1_000_000.0,
            cost.notions.hair_pin,
            "ヘアピンやクリップ 1 本の値段",
            "one hair pin or clip"
        ),
        number_if_known!(
            "gourd_price",
            0.0..=1_000_000.0,
            cost.notions.gourd,
            "ひょうたん 1 個の値段",
            "one gourd"
        ),
        number_if_known!(
            "bamboo_price",
            0.0..=1_000_000.0,
            cost.notions.bamboo,
            "竹 1 本の値段",
            "one stick of bamboo"
        ),
        number_if_known!(
            "feather_price",
            0.0..=1_000_000.0,
            cost.notions.feather,
            "羽根 1 本の値段",
            "one feather"
        ),
        number_if_known!(
            "handle_price",
            0.0..=1_000_000.0,
            cost.notions.handle,
            "持ち手 1 本の値段",
            "one handle of a rattle"
        ),
        number_if_known!(
            "seed_price",
            0.0..=1_000_000.0,
            cost.notions.seed,
            "種 1 粒の値段",
            "one seed"
        ),
        number_if_known!(
            "card_price",
            0.0..=1_000_000.0,
            cost.notions.card,
            "厚紙 1 枚の値段",
            "one sheet of card"
        ),
        number_if_known!(
            "glue_price",
            0.0..=1_000_000.0,
            cost.notions.glue,
            "接着剤 1 本の値段",
            "one tube of glue"
        ),
        number_if_known!(
            "other_price",
            0.0..=10_000_000.0,
            cost.other_price,
            "ほかにかかるもの（1 着）",
            "all else, for one costume"
        ),
        number_if_known!(
            "wage_per_h",
            0.0..=1_000_000.0,
            cost.wage_per_h,
            "縫う人への 1 時間の礼。書かなければ数えない",
            "an hour of sewing; not counted when left out"
        ),
        number_if_known!(
            "bought_price",
            0.0..=10_000_000.0,
            cost.bought_price,
            "同じものを買うときの値段",
            "the same costume bought ready"
        ),
    ],
};
