//! A paper becomes a draft: a document that is read once the statements that are refused are taken out.
#![no_main]

use std::cmp::Reverse;

use kane_audit::read;
use kane_latex::{Format, draft};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    // the last byte says which: a file as it is shipped, which ends in a line feed, is LaTeX
    let Some((last, before)) = data.split_last() else { return };
    let Some(text) = kane_fuzz::text(before) else { return };
    let format = if last % 4 == 0 { Format::Markdown } else { Format::Latex };
    let mut draft = draft(text, format);
    // as `kane draft` does
    for _ in 0..100 {
        let Err(faults) = read("draft.md", draft.document.as_bytes()) else { return };
        let mut lines: Vec<(usize, String)> =
            faults.into_iter().map(|fault| (fault.line, fault.message)).collect();
        lines.sort_by_key(|(line, _)| Reverse(*line));
        lines.dedup_by_key(|(line, _)| *line);
        let refused = lines.iter().filter(|(line, reason)| draft.refuse(*line, reason)).count();
        assert!(refused > 0, "a draft that cannot be read: {lines:?}\n{}", draft.document);
    }
    panic!("a draft that is never settled:\n{}", draft.document);
});
