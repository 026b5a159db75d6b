//! What is committed is what is made now. Figures, tables of methods and scripts for Gappa are compared
//! where they are tested, in `tests/golden`.

use std::fs;
use std::path::Path;

use kane::impact::laws;
use kane_pages::{docstrings, energy_map, model_error};

fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

#[track_caller]
fn assert_fresh(path: &str, made: &str) {
    let kept = fs::read_to_string(root().join(path)).unwrap_or_default();
    let line = kept.lines().zip(made.lines()).position(|(a, b)| a != b);
    let line = line.unwrap_or_else(|| kept.lines().count().min(made.lines().count())) + 1;
    assert!(
        kept == made,
        "{path} is stale from line {line} on; write it by\n  cargo run --release -p kane-pages"
    );
}

#[test]
fn the_page_of_laws_is_what_the_laws_say() {
    let page = kane_pages::laws(root()).expect("every law is told");
    assert_fresh("docs/laws.md", &page);
}

#[test]
fn the_model_error_is_what_the_processes_say() {
    let table = model_error().expect("all processes end");
    assert_fresh("docs/data/model-error.csv", &table);
    // the shortcut's error near normal collision was stated as up to 0.7
    let mut rows = table.lines().skip(1).map(|line| line.split(',').collect::<Vec<_>>());
    let names = rows.next().expect("a line of names");
    let column = names.iter().position(|name| *name == "hertz-mindlin").expect("its column");
    let greatest =
        rows.map(|row| row[column].parse::<f64>().expect("a number")).fold(0.0, f64::max);
    assert!((0.6..0.75).contains(&greatest), "{greatest}");
}

#[test]
fn the_map_of_kanes_puzzle_is_what_the_laws_say() {
    assert_fresh("docs/data/kane-puzzle.csv", &energy_map().expect("inside the domain"));
}

#[test]
fn every_law_states_its_formula_domain_exactness_and_bound() {
    let docs = docstrings(root()).expect("the sources are there");
    for law in laws() {
        let doc = docs
            .get(law.info.id)
            .unwrap_or_else(|| unreachable!("{} has a docstring", law.info.id));
        let text = doc.lines.join("\n");
        for asked in [" = ", "Domain: ", "xact in\nexact", "n floats"] {
            let plain = text.replace('\n', " ");
            assert!(plain.contains(&asked.replace('\n', " ")), "{}: no `{asked}`", law.info.id);
        }
        // a line that begins like a quotation or a list would be shown as one
        let marked =
            |line: &&String| line.starts_with(['>', '#', '+', '*', '-']) && !line.starts_with("**");
        assert_eq!(doc.lines.iter().find(marked), None, "{}", law.info.id);
    }
    assert_eq!(docs.len(), laws().len(), "every struct with an id is in the catalogue");
}
