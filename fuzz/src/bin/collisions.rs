//! A collision is read, or refused; what is read is put to every law, and no outcome is without a number.
#![no_main]

use kane_impact::laws;
use kane_scene::collide::{answer, in_depth};
use kane_scene::read;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    let Some((first, rest)) = data.split_first() else { return };
    let Some(text) = kane_fuzz::text(rest) else { return };
    let Ok(question) = read::collision("fuzz.toml", text) else { return };
    let laws = laws();
    let law = &laws[usize::from(*first) % laws.len()];
    let _ = in_depth(&question, law);
    let _ = answer(&question, laws);
});
