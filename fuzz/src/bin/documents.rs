//! A document is read, or refused with a place; what is read is judged, once like twice, each statement once.
#![no_main]

use kane_audit::{Options, audit, read};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    let document = match read("fuzz.md", data) {
        Ok(document) => document,
        Err(faults) => {
            assert!(!faults.is_empty(), "a refusal has a reason");
            return;
        }
    };
    let options = Options { budget: kane_fuzz::small(), ..Options::default() };
    let judged = audit(document, &options, &mut |_, _| {});
    assert_eq!(judged.judgements.len(), judged.document.statements.len());
    for link in judged.judgements.iter().flat_map(|judgement| &judgement.links) {
        if let Some(accepted) = &link.accepted {
            let fuel = kane_kernel::Fuel::new(400_000_000);
            let again = kane_kernel::check(&accepted.goal, &accepted.certificate, fuel);
            assert_eq!(again, Ok(()), "what was accepted is accepted again");
        }
    }
});
