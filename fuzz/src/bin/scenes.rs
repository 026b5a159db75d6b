//! A scene is read, or refused; what is read is answered, or there is a reason.
#![no_main]

use kane_impact::laws;
use kane_scene::{Effort, answer, read};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    let Some(text) = kane_fuzz::text(data) else { return };
    let Ok(scene) = read::scene("fuzz.toml", text) else { return };
    if let Ok(answer) = answer(&scene, laws(), None, Effort::Chosen, &mut |_, _| {}) {
        let shown = answer.judged.iter().any(|judged| judged.model == answer.shown);
        assert!(shown, "what is shown is one of the models that were judged");
    }
});
