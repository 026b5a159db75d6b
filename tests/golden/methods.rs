//! The committed table of errors and counted costs. Times are in no table that is compared.

use std::path::Path;

use kane::measure::chart::table;
use kane::report::chart::committed;

#[test]
fn the_committed_methods_are_the_program_s() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/data/methods.csv");
    let shown = committed(&table());
    if std::env::var_os("KANE_WRITE_DOCS").is_some() {
        std::fs::write(&path, &shown).expect("the checkout is writable");
    }
    let kept = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(
        kept == shown,
        "docs/data/methods.csv is stale; write it by\n  KANE_WRITE_DOCS=1 cargo test --test golden methods"
    );
}
