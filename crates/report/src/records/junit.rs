//! A study as JUnit's XML, which services of continuous integration show: each check is a test.

use std::fmt::Write as _;

use kane_algebra::syntax::visible;
use kane_records::comparison::Comparison;

use super::RecordsReport;
use super::compared::{came as told, news, rejects_more};
use super::sentence::headline;
use super::wording::{asks, rejected, residual, suspicion, verdict};
use crate::wording::number_of;

/// What came of a test.
enum Came {
    Passed,
    Failed(String),
    /// there was nothing to ask
    Skipped,
}

/// A test: its name, what it asks, and what came of it.
struct Test {
    name: String,
    asks: String,
    came: Came,
}

/// The study as one suite: a test for every check, one that no row was rejected, and one that the units
/// and axes are plausible. It fails where [`as_expected`](kane_records::study::Study::as_expected) does.
#[must_use]
pub fn junit(report: &RecordsReport<'_>) -> String {
    let study = report.study;
    let mut tests: Vec<Test> = study
        .checks
        .iter()
        .map(|checked| {
            let worst = checked.worst.map_or_else(String::new, |(_, finding)| {
                format!(", the worst {}", residual(checked.check, &finding))
            });
            let came = match checked.rows {
                0 => Came::Skipped,
                _ if checked.as_expected() => Came::Passed,
                rows => Came::Failed(format!(
                    "{} of {}{worst}",
                    verdict(checked),
                    number_of(rows, "row")
                )),
            };
            Test { name: checked.check.id().to_owned(), asks: asks(checked.check).to_owned(), came }
        })
        .collect();
    let all = |lines: Vec<String>| match lines.as_slice() {
        [] => Came::Passed,
        lines => Came::Failed(lines.join("; ")),
    };
    let nothing = (study.rows == 0).then(|| "no row could be checked".to_owned());
    tests.push(Test {
        name: "rows".to_owned(),
        asks: "every row can be checked".to_owned(),
        came: all(rejected(study).into_iter().chain(nothing).collect()),
    });
    tests.push(Test {
        name: "units".to_owned(),
        asks: "units and axes are plausible".to_owned(),
        came: all(study.suspicions.iter().map(suspicion).collect()),
    });
    suite(report.log, &headline(study), &tests)
}

/// The comparison as one suite: a test for every check, and one for each law.
#[must_use]
pub fn compared_junit(comparison: &Comparison, [old, new]: &[String; 2]) -> String {
    let came = |worse: bool, words: String| if worse { Came::Failed(words) } else { Came::Passed };
    let mut tests: Vec<Test> = comparison
        .changes
        .iter()
        .map(|change| {
            let [before, now] = [0, 1].map(|at| told(change, at));
            let words = format!("{before} before, {now} now");
            let (name, asks) = (change.check.id().to_owned(), asks(change.check).to_owned());
            Test { name, asks, came: came(change.worse, words) }
        })
        .collect();
    let [before, now] = comparison.friction_close;
    tests.push(Test {
        name: "friction".to_owned(),
        asks: "friction follows the law that it followed".to_owned(),
        came: came(
            comparison.friction_is_worse(),
            format!("another law, or its own in a share of {before} before and {now} now"),
        ),
    });
    let [before, now] = comparison.normal_close;
    tests.push(Test {
        name: "restitution-law".to_owned(),
        asks: "restitution is as stated in as many rows as it was".to_owned(),
        came: came(
            comparison.normal_is_worse(),
            format!("a share of {before} before and {now} now"),
        ),
    });
    let [before, now] = comparison.rejected;
    tests.push(Test {
        name: "rows".to_owned(),
        asks: "no more rows are rejected".to_owned(),
        came: came(rejects_more(comparison), format!("{before} before and {now} now")),
    });
    tests.push(Test {
        name: "compared".to_owned(),
        asks: "both logs have a row that can be checked".to_owned(),
        came: came(!comparison.compares(), news(comparison).to_owned()),
    });
    suite(&format!("{new}, against {old}"), news(comparison), &tests)
}

fn suite(name: &str, headline: &str, tests: &[Test]) -> String {
    let count = |of: fn(&Came) -> bool| tests.iter().filter(|test| of(&test.came)).count();
    let failures = count(|came| matches!(came, Came::Failed(_)));
    let skipped = count(|came| matches!(came, Came::Skipped));
    let (name, headline) = (escaped(name), escaped(headline));
    let counts = format!("tests=\"{}\" failures=\"{failures}\" errors=\"0\"", tests.len());
    let mut out = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    let _ = writeln!(out, "<testsuites name=\"kane check\" {counts}>");
    let _ = writeln!(out, "  <testsuite name=\"{name}\" {counts} skipped=\"{skipped}\">");
    let _ = writeln!(out, "    <system-out>{headline}</system-out>");
    for test in tests {
        let (id, asks) = (escaped(&test.name), escaped(&test.asks));
        let head = format!("    <testcase classname=\"{name}\" name=\"{id}: {asks}\"");
        let _ = match &test.came {
            Came::Passed => writeln!(out, "{head}/>"),
            Came::Skipped => writeln!(out, "{head}>\n      <skipped/>\n    </testcase>"),
            Came::Failed(why) => writeln!(
                out,
                "{head}>\n      <failure message=\"{}\"/>\n    </testcase>",
                escaped(why)
            ),
        };
    }
    out.push_str("  </testsuite>\n</testsuites>\n");
    out
}

/// The words as XML has them, on one line; what XML 1.0 has no way to write, or nobody sees, is written out or becomes U+FFFD.
fn escaped(words: &str) -> String {
    let mut out = String::with_capacity(words.len());
    for c in visible(words).chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\u{fffe}' | '\u{ffff}' => out.push('\u{fffd}'),
            c => out.push(c),
        }
    }
    out
}
