//! Laws of reading avatars and dances.

mod body;
mod broken;
mod dance;
mod files;
mod support;
