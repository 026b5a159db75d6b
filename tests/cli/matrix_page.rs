//! The page of the matrix in a browser, of some laws. Skipped without Chromium, as in `browser`.

use std::path::PathBuf;
use std::sync::LazyLock;

use serde_json::Value;

use crate::browser::{browser, noise, number, seen};
use crate::{kane, scratch};

/// Laws with cells that are proved, refuted and not applicable, and all properties.
static REPORTS: LazyLock<PathBuf> = LazyLock::new(|| {
    let dir = scratch("matrix-page");
    let laws = ["--law", "wang-su-li", "--law", "whittaker-uncapped", "--law", "keller-printed"];
    let out = ["--out", dir.to_str().expect("UTF-8")];
    let run = kane(&[&["laws"], &laws[..], &out[..]].concat());
    assert!(run.code < 2, "{}", run.stderr);
    dir
});

fn address() -> String {
    format!("file://{}", REPORTS.join("laws.html").display())
}

/// How many cells of the report for programs end so; all, if nothing is named.
fn cells(finding: Option<&str>) -> usize {
    let json = std::fs::read_to_string(REPORTS.join("laws.json")).expect("it was written");
    let report: Value = serde_json::from_str(&json).expect("it is JSON");
    let laws = report["laws"].as_array().expect("a list").iter();
    let cells = laws.flat_map(|law| law["cells"].as_object().expect("an object").values());
    cells.filter(|cell| finding.is_none_or(|finding| cell["finding"] == finding)).count()
}

#[test]
fn the_page_loads_nothing_and_fits_a_telephone_and_a_desk() {
    let Some(mut browser) = browser() else { return };
    let page = address();
    for (width, scheme) in [(400, "dark"), (1400, "light")] {
        browser.open(&page, width, scheme);
        assert_eq!(seen(&mut browser, "td"), cells(None));
        browser.value("document.querySelectorAll('details').forEach(d => d.open = true)");
        assert_eq!(noise(&browser, &page), Vec::<String>::new());
        let reach = number(&browser.value("document.documentElement.scrollWidth"));
        assert!(reach <= width, "{reach} px in a window of {width}");
        // the table scrolls in itself where it must, and law and property stay in sight
        let places = browser.value(
            "(() => { const box = document.getElementById('matrix'); box.scrollTo(9999, 9999);
                      const cell = document.querySelector('tbody tr:last-child td:last-child').getBoundingClientRect();
                      const law = document.querySelector('tbody tr:last-child th').getBoundingClientRect();
                      return [cell.right, law.left, law.width] })()",
        );
        let place = |index: usize| places[index].as_f64().expect("a number");
        assert!(place(0) <= f64::from(u16::try_from(width).expect("small")), "{places}");
        assert!(place(1) >= 0.0 && place(2) > 40.0, "{places}");
    }
}

#[test]
fn a_filter_leaves_the_cells_of_its_finding_and_a_link_brings_one_back() {
    let Some(mut browser) = browser() else { return };
    browser.open(&address(), 1400, "light");
    browser.value(
        "document.querySelectorAll('input[name=v]:not([value=refuted])').forEach(b => b.click())",
    );
    assert_eq!(seen(&mut browser, "details.cell"), cells(Some("refuted")));
    assert_eq!(seen(&mut browser, "td:not(.faint)"), cells(Some("refuted")));
    let told = browser.value("document.querySelector('.filter output').textContent");
    assert_eq!(told, format!("{} of {} cells", cells(Some("refuted")), cells(None)));
    let link = "document.querySelector('a[href=\"#wang-su-li:reversal\"]')";
    browser.value(&format!("{link}.click(); new Promise(done => setTimeout(done, 50))"));
    assert_eq!(seen(&mut browser, "[id=\"wang-su-li:reversal\"]"), 1, "it is unfolded");
}

#[test]
fn without_scripts_a_link_unfolds_its_cell() {
    let Some(mut browser) = browser() else { return };
    browser.call("Emulation.setScriptExecutionDisabled", serde_json::json!({ "value": true }));
    browser.open(&format!("{}#wang-su-li:cone", address()), 1400, "light");
    assert_eq!(seen(&mut browser, "details.cell"), cells(None));
    assert_eq!(seen(&mut browser, "form.filter"), 0, "what needs a script is not offered");
    assert_eq!(seen(&mut browser, "[id=\"wang-su-li:cone\"]"), 1);
    assert_eq!(seen(&mut browser, "[id=\"wang-su-li:reversal\"]"), 0, "the others stay folded");
    browser.call("Emulation.setScriptExecutionDisabled", serde_json::json!({ "value": false }));
}
