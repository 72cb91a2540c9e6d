//! Laws of recorded motion: what is read, what is recognized, what is danced.

mod bvh;
mod retarget;
mod support;
