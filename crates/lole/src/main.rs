//! The lole command.
fn main() {}
