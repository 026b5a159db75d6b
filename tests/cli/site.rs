//! `kane site`: what it needs, and the whole site. Links are followed in `tests/golden/site.rs`, on a smaller one.

use std::fs;

use serde_json::Value;

use crate::{kane, scratch};

#[test]
fn where_a_site_cannot_be_written_is_said_before_it_is_made() {
    let dir = scratch("site-place");
    let file = dir.join("file");
    fs::write(&file, "mine\n").expect("writable");
    fs::write(dir.join("index.html"), "<p>mine").expect("writable");
    for (place, said) in [
        (&file, "not a directory"),
        (&file.join("below"), "not a directory"),
        (&dir, "did not write"),
    ] {
        let run = kane(&["site", "--out", place.to_str().expect("UTF-8")]);
        assert_eq!((run.code, run.stdout.as_str()), (2, ""), "{}", run.stderr);
        // a stage that took seconds would have a line of its own
        assert_eq!(run.stderr.lines().count(), 1, "{}", run.stderr);
        assert!(run.stderr.contains(said), "{}", run.stderr);
    }
}

#[test]
fn a_site_needs_a_directory() {
    let run = kane(&["site"]);
    assert_eq!(run.code, 2);
    assert!(run.stdout.is_empty() && run.stderr.contains("--out <DIR>"), "{}", run.stderr);
    let help = kane(&["site", "--help"]);
    assert_eq!(help.code, 0);
    assert!(help.stdout.contains("Examples:") && help.stdout.contains("kane site --out site"));
}

/// All that is shipped. Run it with `cargo test --release --test cli site -- --ignored`.
#[test]
#[ignore = "takes a minute in the release profile"]
fn the_whole_site_is_written_and_every_page_is_listed() {
    let dir = scratch("site");
    let run = kane(&["site", "--out", dir.to_str().expect("UTF-8")]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(run.stderr.contains("took: ") && run.stdout.contains("index.html"), "{}", run.stderr);
    let index = fs::read_to_string(dir.join("index.json")).expect("it was written");
    let index: Value = serde_json::from_str(&index).expect("it is JSON");
    let findings = index["findings"].as_array().expect("a list");
    assert_eq!(findings.len(), 10, "ten findings");
    let pages = index["pages"].as_array().expect("a list");
    assert!(pages.len() >= 28, "{} pages", pages.len());
    for page in pages {
        let path = dir.join(page["to"].as_str().expect("an address"));
        assert!(path.is_file(), "{}", path.display());
    }
    // a page tells the command that prints the same
    let page = fs::read_to_string(dir.join("stability.html")).expect("it was written");
    assert!(page.contains("kane stability --full-line"));
    let run = kane(&["stability", "--full-line"]);
    let headline = run.stdout.lines().nth(1).expect("a headline");
    assert!(page.contains(headline), "{headline}");
}
