//! Every garment: how it is drafted to measures, laid around a dancer, sewn on her and worn.
//!
//! A garment is one file under `garment/` and one row of [`TEMPLATES`]. Three things are made of it: a
//! [`Pattern`](lole_pattern::Pattern) from [`Measures`](lole_pattern::Measures) and [`Options`]; of what is
//! sewn from shaped pieces, cloth on a dancer ([`dress`]); of leaves, flowers and what is played, shapes that
//! her bones and strands carry ([`adorn`]).
//!
//! The crate knows no design document, no print but its colors, no price and no file.

pub mod adorn;
mod drafting;
pub mod dress;
mod fitting;
mod garment;
pub mod given;
pub mod measures;
pub mod sketch;
mod spec;
pub mod template;
pub mod wave;

pub use fitting::Fitting;
pub use given::Given;
pub use measures::measures;
pub use sketch::Sketch;
pub use spec::{Colors, GarmentSpec};
pub use template::{
    Fineness, GarmentLayer, Options, RAFFIA_PER_METER, Shelf, TEMPLATES, Template, WornPlace,
};
