//! Snapshots of what the program prints: every file under `snapshots/` has one test here that owns it.

mod collide; // one collision under all laws, or under one in depth
mod draft; // papers in LaTeX as drafts
mod figures; // the figures and their data
mod fixture;
mod growth; // how cost grows with size, without a clock
mod judges; // what Coq and z3 are handed
mod laws;
mod made_up_law; // what the impact laws return, over a range of states
mod matrix; // every law against every property, some cells in full, and the page of properties
mod methods; // the errors and counted costs of all methods
mod proofs; // how long the proofs of two documents are to read
mod puzzle; // Kane's double pendulum, as numbers and as a map
mod reports; // the report of a small audit, in every format
mod rounding; // the scripts that bound rounding errors
mod scene; // the shipped scenes, and where methods fail
mod schema; // the JSON Schemas
#[path = "../schemas/mod.rs"]
mod schemas; // that reports are as they say
mod site; // the site: its index, its links
mod stability; // where the formulas of the paper fail

/// Where snapshots live and how they are named: the tests of `reports.rs` own `snapshots/reports/NAME.snap`.
/// No other test touches insta's settings.
///
/// The path is absolute, so it does not depend on how deep a test file sits. The version of the program is `VERSION` in
/// all of them, so that a release changes none.
#[track_caller]
fn settings() -> insta::Settings {
    let caller = std::path::Path::new(std::panic::Location::caller().file());
    let folder = caller.file_stem().expect("a source file has a name");
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(
        std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("snapshots").join(folder),
    );
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    let version = format!(r"\b{}\b", env!("CARGO_PKG_VERSION").replace('.', r"\."));
    settings.add_filter(&version, "VERSION");
    settings
}

/// A file of the checkout that is made from data is what is made now.
#[track_caller]
fn assert_kept(file: &str, made: &str) {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
    let kept = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(kept == made, "{file} is stale; write it by\n  cargo run --release -p kane-pages");
}
