//! A log is read, or refused; no row is lost among those that are checked and those that are rejected.
#![no_main]

use kane_impact::laws;
use kane_records::reader::Kind;
use kane_records::study::{Options, study};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    let Some((first, rest)) = data.split_first() else { return };
    let kind = if first % 4 == 0 { Kind::JsonLines } else { Kind::Csv };
    let options = Options { sample: 20, ..Options::new(laws()) };
    let studied = [(); 2].map(|()| study(rest, kind, &options));
    let [one, two] =
        studied.map(|study| study.map(|study| format!("{study:?}")).map_err(|e| e.to_string()));
    assert_eq!(one, two, "two studies of one log");
});
