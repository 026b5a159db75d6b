//! A release says one version, wherever it says one.

use std::path::Path;

/// The text of a file of the checkout.
fn text(path: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
    let read = std::fs::read_to_string(&path);
    assert!(read.is_ok(), "{}: {read:?}", path.display());
    read.unwrap_or_default()
}

const VERSION: &str = env!("CARGO_PKG_VERSION");

#[test]
fn whatever_names_the_version_names_that_of_the_workspace() {
    for (path, said) in [
        ("CITATION.cff", format!("\nversion: {VERSION}\n")),
        ("editors/vscode/package.json", format!("\n  \"version\": \"{VERSION}\",\n")),
        ("editors/README.md", format!("kane-{VERSION}.vsix")),
        (".github/ISSUE_TEMPLATE/wrong-verdict.yml", format!("kane {VERSION}\n")),
        ("docs/figures/matrix.svg", format!(">kane {VERSION}: kane laws</text>")),
    ] {
        assert!(text(path).contains(&said), "{path} does not say {said:?}");
    }
    // dependencies of the workspace on its own crates
    let manifest = text("Cargo.toml");
    let own = manifest.lines().filter(|line| line.starts_with("kane") && line.contains("path = "));
    let own: Vec<&str> = own.collect();
    assert!(own.len() > 10, "{own:?}");
    for line in own {
        assert!(line.contains(&format!("version = \"{VERSION}\"")), "{line}");
    }
}

#[test]
fn the_changelog_has_the_version_with_its_date_below_what_is_unreleased() {
    let changelog = text("CHANGELOG.md");
    let mut versions = changelog.lines().filter_map(|line| line.strip_prefix("## "));
    assert_eq!(versions.next(), Some("Unreleased"));
    let (version, date) = versions.next().and_then(|line| line.split_once(' ')).expect("a release");
    assert_eq!(version, VERSION);
    let date = date.trim_start_matches('(').trim_end_matches(')');
    assert!(date.len() == 10 && text("CITATION.cff").contains(&format!("date-released: {date}\n")));
}
