//! `kane chart --figures`, and the page that shows them.

use std::fs;

use crate::{kane, scratch};

#[test]
fn the_figures_are_those_of_the_documentation() {
    let dir = scratch("figures");
    let run = kane(&["chart", "--figures", "--out", dir.to_str().expect("UTF-8")]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(run.stdout.contains("slip-over-alpha: ") && run.stdout.contains("1 law: wang-su-li"));
    let committed = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/figures");
    let mut written = 0;
    for entry in fs::read_dir(&dir).expect("it was made") {
        let path = entry.expect("readable").path();
        let name = path.file_name().expect("a file");
        let twin = fs::read(std::path::Path::new(committed).join(name)).expect("it is committed");
        assert!(fs::read(&path).expect("it was written") == twin, "{}", path.display());
        written += 1;
    }
    assert_eq!(written, 10, "five figures, each with its data");
}

#[test]
fn figures_go_with_nothing_that_is_timed() {
    for other in ["--quick", "--growth", "--format=json"] {
        assert_eq!(kane(&["chart", "--figures", other]).code, 2, "{other}");
    }
}

#[test]
fn the_page_of_the_paper_shows_the_figures_and_no_other_page_does() {
    let dir = scratch("figures-page");
    let target = dir.to_str().expect("UTF-8");
    let pictures = |name: &str| {
        let page = fs::read_to_string(dir.join(name)).expect("it was written");
        // a term of a proof takes twice the bytes in MathML that it takes as letters
        assert!(page.len() < 1_300_000, "{} bytes", page.len());
        page.matches("class=\"picture\"").count()
    };
    kane(&["audit", "--out", target]);
    assert_eq!(pictures("oblique-collision.html"), 2);
    let other = scratch("figures-page-of-another");
    let other = crate::document(&other, "other.md", "var x > 0\nclaim a: x > 0");
    kane(&["audit", &other, "--out", target]);
    assert_eq!(pictures("other.html"), 0);
}
