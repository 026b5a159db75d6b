//! The files of a site: every page, and beside it the other forms of what it tells.

use kane_judges::{Claims, coq};

use super::{Site, derived, gallery, index, place};
use crate::envelope::folded;
use crate::figures::{csv, svg};
use crate::sheet::Sheet;
use crate::{
    Place, certificates, chart, collision, growth, html, json, latex, matrix, scene, stability,
};

/// A file of a site.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// where it is, seen from the index
    pub path: String,
    /// what it holds
    pub text: String,
}

impl Site<'_> {
    /// Every file of the site. Equal sites give equal bytes.
    #[must_use]
    pub fn files(&self) -> Vec<File> {
        let mut files = Vec::new();
        self.write_audits(&mut files);
        self.write_laws(&mut files);
        self.write_measured(&mut files);
        for (stem, collision) in &self.collisions {
            let sheet = collision::sheet(collision);
            write(&mut files, &format!("collisions/{stem}"), sheet, collision::json(collision));
        }
        for (stem, report) in &self.scenes {
            let sheet = scene::sheet(report);
            write(&mut files, &format!("scenes/{stem}"), sheet, scene::json(report));
        }
        for figure in self.figures {
            let path = |ending: &str| format!("figures/{}.{ending}", figure.stem);
            add(&mut files, path("svg"), svg(figure));
            add(&mut files, path("csv"), csv(figure));
        }
        let page = gallery::gallery(self).placed(place("figures.html", &[]));
        add(&mut files, "figures.html", page.html());
        let forms = [("JSON", "index.json".to_owned())];
        let page = index::index(self).placed(place("index.html", &forms));
        add(&mut files, "index.html", page.html());
        add(&mut files, "index.json", index::json(self));
        files
    }

    /// The documents: page, JSON, LaTeX, certificates, and the lemmas for Coq, which share their theory.
    fn write_audits(&self, files: &mut Vec<File>) {
        add(files, format!("derivations/{}.v", coq::THEORY), coq::shared_theory());
        for (stem, report) in &self.audits {
            let path = |ending: &str| format!("derivations/{stem}.{ending}");
            let lemmas = coq::library(stem);
            let forms = [
                ("JSON", format!("{stem}.json")),
                ("LaTeX", format!("{stem}.tex")),
                ("Coq", format!("{lemmas}.v")),
                ("its theory", format!("{}.v", coq::THEORY)),
                ("certificates", format!("{stem}.cert.json")),
            ];
            let place = place(&path("html"), &forms).with("Laws", derived::in_document(self, stem));
            let placed = report.clone().placed(place);
            add(files, path("html"), self.with_pages(html(&placed)));
            add(files, path("json"), json(std::slice::from_ref(report)));
            add(files, path("tex"), latex(report));
            add(files, path("cert.json"), certificates(report));
            let claims = Claims::of(report.audit).only(&report.shown);
            add(files, format!("derivations/{lemmas}.v"), coq::file(&claims).beside_theory());
        }
    }

    /// A page whose links to documents that the site has lead to their pages.
    fn with_pages(&self, page: String) -> String {
        self.audits.iter().fold(page, |page, (stem, _)| {
            page.replace(&format!("href=\"{stem}.md"), &format!("href=\"{stem}.html"))
        })
    }

    /// The matrix: its page, its sheet for print, the picture and its data.
    fn write_laws(&self, files: &mut Vec<File>) {
        let forms = [
            ("JSON", "laws.json".to_owned()),
            ("LaTeX", "laws.tex".to_owned()),
            ("CSV", "matrix.csv".to_owned()),
            ("picture", "matrix.svg".to_owned()),
        ];
        let place = place("laws.html", &forms);
        let derived = derived::of_laws(self);
        let page = matrix::html_in_site(&self.matrix, self.laws, &place, &derived);
        add(files, "laws.html", page);
        add(files, "laws.json", matrix::json(&self.matrix));
        add(files, "laws.tex", matrix::sheet(&self.matrix).latex());
        add(files, "matrix.csv", matrix::csv(&self.matrix));
        add(files, "matrix.svg", matrix::picture(&self.matrix));
    }

    /// What is measured of formulas and methods, each with its rows for spreadsheets.
    fn write_measured(&self, files: &mut Vec<File>) {
        let (chart, stability, growth) = (&self.chart, &self.stability, &self.growth);
        write_with(files, "chart", chart::sheet(chart), chart::json(chart), chart::csv(chart));
        let rows = stability::csv(stability);
        write_with(
            files,
            "stability",
            stability::sheet(stability),
            stability::json(stability),
            rows,
        );
        write_with(
            files,
            "growth",
            growth::sheet(growth),
            growth::json(growth),
            growth::csv(growth),
        );
    }
}

/// Data for programs are written without the spaces that only people need.
fn add(files: &mut Vec<File>, path: impl Into<String>, text: String) {
    let path = path.into();
    let text = if path.ends_with(".json") { folded(&text) } else { text };
    files.push(File { path, text });
}

/// A sheet as a page and for print, with its data.
fn write(files: &mut Vec<File>, path: &str, sheet: Sheet<'_>, json: String) {
    let stem = path.rsplit('/').next().unwrap_or(path);
    let forms = [("JSON", format!("{stem}.json")), ("LaTeX", format!("{stem}.tex"))];
    write_placed(files, path, sheet, json, place(&format!("{path}.html"), &forms));
}

/// The same with rows.
fn write_with(files: &mut Vec<File>, path: &str, sheet: Sheet<'_>, json: String, rows: String) {
    let form = |ending: &str| format!("{path}.{ending}");
    let forms = [("JSON", form("json")), ("LaTeX", form("tex")), ("CSV", form("csv"))];
    write_placed(files, path, sheet, json, place(&form("html"), &forms));
    add(files, form("csv"), rows);
}

fn write_placed(files: &mut Vec<File>, path: &str, sheet: Sheet<'_>, json: String, place: Place) {
    add(files, format!("{path}.tex"), sheet.latex());
    add(files, format!("{path}.html"), sheet.placed(place).html());
    add(files, format!("{path}.json"), json);
}
