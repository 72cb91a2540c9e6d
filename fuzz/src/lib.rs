//! Inputs that are nearly right: bytes of the fuzzer as choices, so that what it changes is what a document, a drawing
//! or an avatar says, and not whether it can be read at all.

pub mod checks;
pub mod design;
pub mod drawing;
pub mod gltf;
pub mod list;
pub mod recording;
pub mod song;

use arbitrary::Unstructured;

/// Writes what a target reads into the file that `LOLE_SHOW` names, if it names one.
pub fn show(read: &[u8]) {
    if let Some(file) = std::env::var_os("LOLE_SHOW") {
        std::fs::write(file, read).expect("the file of LOLE_SHOW can be written");
    }
}

/// The next choice of so many; the first where the bytes are used up.
fn choose<'c, T>(bytes: &mut Unstructured<'_>, choices: &'c [T]) -> &'c T {
    bytes.choose(choices).unwrap_or(&choices[0])
}

/// Whether something happens that happens once in so many times; never where the bytes are used up.
fn once_in(bytes: &mut Unstructured<'_>, times: u8) -> bool {
    !bytes.is_empty()
        && bytes
            .int_in_range(1..=times)
            .is_ok_and(|number| number == times)
}

/// A count up to `most`.
fn count(bytes: &mut Unstructured<'_>, most: u32) -> u32 {
    bytes.int_in_range(0..=most).unwrap_or(0)
}

/// A number of a range, now and then one of its ends.
fn between(bytes: &mut Unstructured<'_>, low: f64, high: f64) -> f64 {
    let share = f64::from(bytes.arbitrary::<u16>().unwrap_or(0x8000)) / f64::from(u16::MAX);
    low + (high - low) * share
}
