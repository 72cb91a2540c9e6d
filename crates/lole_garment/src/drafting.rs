//! What drafts of several garments share: the bodice block and its sleeve, lines and labels, and how things
//! are made.

pub(crate) mod accessory;
pub(crate) mod altered;
pub(crate) mod block;
pub(crate) mod chosen;
pub(crate) mod fitted;
pub(crate) mod making;
pub(crate) mod shape;
pub(crate) mod sleeve;
pub(crate) mod strands;
pub(crate) mod work;
pub(crate) mod yoke;
