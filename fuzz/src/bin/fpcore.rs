//! What is read as FPCore is written and read back as the same; a bound is not below an error that was found.
#![no_main]

use kane_floats::rigor::{Budget, Goal, Inputs, bounded};
use kane_floats::{Effort, fpcore, worst};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    let Some(text) = kane_fuzz::text(data) else { return };
    let Ok(cores) = fpcore::read("fuzz.fpcore", text) else { return };
    for core in cores.iter().take(2) {
        let written = fpcore::write(core);
        let read = fpcore::read("written.fpcore", &written);
        let [again] = &read.expect("what is written is read")[..] else {
            panic!("one core is written as one: {written}");
        };
        assert_eq!(fpcore::write(again), written, "written once like twice");
        let budget = Budget { cells: 20, ratio: 2.0 };
        let Ok(bound) = bounded::<f64>(core, Inputs::Floats, Goal::Absolute, budget) else {
            continue;
        };
        let effort = Effort { drawn: 20, climbs: 1, rounds: 4 };
        if let Some(found) = worst::<f64>(core, &bound.worst, Goal::Absolute, effort) {
            let error = found.error(Goal::Absolute);
            // NaN is an error of a machine that went on behind a pole
            assert!(!(error > bound.bound) || bound.pole.is_some(), "{error:e}: {written}");
        }
    }
});
