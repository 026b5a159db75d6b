//! Pages held against axe-core, a checker of accessible pages. It comes from npm; without npm, or a browser, these
//! tests are skipped, unless `KANE_REQUIRE_AXE` is set. `KANE_AXE` names an `axe.min.js` that is there already.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::LazyLock;

use serde_json::Value;

use crate::browser::browser;
use crate::chromium::{Chromium, installed, skip};
use crate::{kane, scratch};

/// The version that is asked for, so that a new rule does not come by itself.
const PACKAGE: &str = "axe-core@4.14.1";

/// The checker's script.
static AXE: LazyLock<Option<String>> = LazyLock::new(|| {
    let named = std::env::var_os("KANE_AXE").map(PathBuf::from);
    fs::read_to_string(named.or_else(packed)?).ok()
});

/// The script out of the package, fetched and unpacked in a directory of its own.
fn packed() -> Option<PathBuf> {
    let dir = scratch("axe");
    fs::create_dir_all(&dir).ok()?;
    let run = |program: &str, arguments: &[&str]| {
        let mut command = Command::new(program);
        command.args(arguments).current_dir(&dir).stdin(Stdio::null()).stderr(Stdio::null());
        command.output().ok().filter(|output| output.status.success())
    };
    let fetched =
        run("npm", &["pack", "--silent", "--fetch-timeout=20000", "--fetch-retries=0", PACKAGE])?;
    let file = String::from_utf8(fetched.stdout).ok()?;
    run("tar", &["xzf", file.trim()])?;
    Some(dir.join("package/axe.min.js"))
}

/// The checker, or nothing and a message.
fn axe() -> Option<&'static str> {
    if AXE.is_none() {
        skip("axe-core (npm)", "KANE_REQUIRE_AXE");
    }
    AXE.as_deref()
}

/// The rules of the default run, and that a name has the words that are seen.
const RUN: &str = "axe.run({ rules: { 'label-content-name-mismatch': { enabled: true } } }).then(r =>
    r.violations.map(v => `${v.id}: ${v.nodes.length} times, first ${v.nodes[0].html.slice(0, 200)}`))";

/// What the checker finds on the page that is open.
fn found(browser: &mut Chromium, axe: &str) -> Vec<String> {
    browser.value(&format!("{axe}; 0"));
    let found = browser.value(RUN);
    let found = found.as_array().expect("a list").iter();
    found.map(|one| one.as_str().expect("text").to_owned()).collect()
}

/// Opens a page on a desk and a telephone, in both schemes, and expects to find nothing, and nothing that sticks out.
fn assert_clean(browser: &mut Chromium, axe: &str, page: &Path) {
    for width in [1400, 400] {
        for scheme in ["light", "dark"] {
            let place = format!("{}, {width} px, {scheme}", page.display());
            browser.open(&format!("file://{}", page.display()), width, scheme);
            assert_eq!(found(browser, axe), Vec::<String>::new(), "{place}");
            let reach = browser.value("document.documentElement.scrollWidth");
            assert!(reach.as_u64().expect("a number") <= width as u64, "{place}: {reach}");
        }
    }
}

#[test]
fn a_checker_of_accessible_pages_finds_nothing_on_a_page_of_each_kind() {
    let Some(axe) = axe() else { return };
    let Some(mut browser) = browser() else { return };
    let dir = scratch("axe-pages");
    let out = dir.to_str().expect("UTF-8");
    for (verb, page) in [
        (&["audit", "docs/derivations/bouncing-ball.md"][..], "bouncing-ball.html"),
        (&["laws", "--law", "wang-su-li", "--law", "keller-printed"], "laws.html"),
        (&["scene", "docs/scenes/backspin.toml"], "backspin.html"),
        (&["collide", "docs/collisions/double-pendulum.toml"], "double-pendulum.html"),
    ] {
        kane(&[verb, &["--out", out]].concat());
        assert_clean(&mut browser, axe, &dir.join(page));
    }
    // it would find a picture without words
    browser.value("document.body.append(document.createElement('img'))");
    assert!(found(&mut browser, axe).iter().any(|one| one.starts_with("image-alt")));
}

/// All that is shipped. Run it with `cargo test --release --test cli axe -- --ignored`.
#[test]
#[ignore = "takes minutes in the release profile"]
fn a_checker_of_accessible_pages_finds_nothing_on_any_page_of_the_site() {
    let Some(axe) = axe() else { return };
    let Some(program) = installed() else { return skip("chromium", "KANE_REQUIRE_BROWSER") };
    let dir = scratch("axe-site");
    assert_eq!(kane(&["site", "--out", dir.to_str().expect("UTF-8")]).code, 0);
    let index = fs::read_to_string(dir.join("index.json")).expect("it was written");
    let index: Value = serde_json::from_str(&index).expect("it is JSON");
    let pages = index["pages"].as_array().expect("a list").iter();
    let pages: Vec<&str> = pages.map(|page| page["to"].as_str().expect("an address")).collect();
    assert!(pages.len() > 40, "{} pages", pages.len());
    for (number, page) in [&["index.html"], &pages[..]].concat().into_iter().enumerate() {
        // a browser each, since one is ended after a while whatever it does
        let mut browser = Chromium::start(&program, &scratch(&format!("axe-browser-{number}")));
        assert_clean(&mut browser, axe, &dir.join(page));
    }
}
