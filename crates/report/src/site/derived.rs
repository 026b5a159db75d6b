//! Where in the shipped documents a law is derived, or examined: a law's page leads there, and the document back.

use super::Site;
use crate::Link;
use crate::html::anchor;

/// A law's id, a document's name, and the label of the statement there.
const DERIVED: [(&str, &str, &str); 14] = [
    ("wang-su-li", "oblique-collision", "(16)"),
    ("wang-su-li", "answers-to-the-conditions", "linear-16"),
    ("wang-su-li", "coupled-collision", "(16c)"),
    ("whittaker-uncapped", "oblique-collision", "(22)"),
    ("smith-printed", "oblique-collision", "(24)"),
    ("keller-printed", "oblique-collision", "(26)"),
    ("smith-1991", "answers-to-the-conditions", "smith-solved"),
    ("smith-1991", "oblique-collision", "smith-loss"),
    ("garwin-capped", "answers-to-the-conditions", "garwin-energy"),
    ("walton", "answers-to-the-conditions", "walton-energy"),
    ("routh-newton", "answers-to-the-conditions", "process"),
    ("keller-1986", "answers-to-the-conditions", "process"),
    ("stronge-1990", "answers-to-the-conditions", "process"),
    ("keller-1986", "oblique-collision", "(27-cont)"),
];

/// By law, links from the page of the laws to where it is derived. What the site does not have is left out.
pub(super) fn of_laws<'a>(site: &Site<'a>) -> Vec<(&'static str, Link)> {
    let link = |(law, document, label): &(&'static str, &str, &str)| {
        let (stem, report) = site.audits.iter().find(|(stem, _)| stem == document)?;
        let anchor = anchor(report, label)?;
        let title = report.audit.document.title.as_deref().unwrap_or(stem);
        let to = format!("derivations/{stem}.html#{anchor}");
        Some((*law, Link::new(format!("{title}, {label}"), to)))
    };
    DERIVED.iter().filter_map(link).collect()
}

/// Links from a document to the laws that it derives.
pub(super) fn in_document(site: &Site<'_>, document: &str) -> Vec<Link> {
    let has = |law: &str| site.matrix.matrix.rows.iter().any(|row| row.law.info.id == law);
    let mut laws: Vec<&str> = DERIVED.iter().filter(|d| d.1 == document).map(|d| d.0).collect();
    laws.retain(|law| has(law));
    laws.dedup();
    laws.sort_unstable();
    laws.dedup();
    laws.iter().map(|law| Link::new(*law, format!("../laws.html#{law}"))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_law_and_every_statement_that_is_named_is_there() {
        for (law, document, label) in DERIVED {
            assert!(kane_impact::law(law).is_some(), "{law}");
            let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/derivations");
            let bytes = std::fs::read(format!("{root}/{document}.md")).expect("it is shipped");
            let read = kane_audit::read(document, &bytes).expect("it is well formed");
            assert!(read.statements.iter().any(|s| s.label == label), "{document}: {label}");
        }
    }
}
