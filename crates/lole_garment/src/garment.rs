//! The garments: a file for each.

pub(crate) mod blouse;
pub(crate) mod cellophane_skirt;
pub(crate) mod hair_flower;
pub(crate) mod holoku;
pub(crate) mod ipu;
pub(crate) mod kihei;
pub(crate) mod kikepa;
pub(crate) mod kupee;
pub(crate) mod lei;
pub(crate) mod lei_poo;
pub(crate) mod malo;
pub(crate) mod muumuu;
pub(crate) mod pau_kahiko;
pub(crate) mod pau_ruffle;
pub(crate) mod pau_skirt;
pub(crate) mod pau_top;
pub(crate) mod puili;
pub(crate) mod raffia_skirt;
pub(crate) mod ti_leaf_skirt;
pub(crate) mod uliuli;
