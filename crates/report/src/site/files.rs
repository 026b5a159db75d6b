//! The files of a site: every page, beside it the other forms of what it tells, and what pages share.

use kane_judges::{Claims, coq};

use super::form::{File, Form};
use super::{Site, derived, gallery, index, place};
use crate::figures::svg;
use crate::html::{shared, shortened};
use crate::sheet::Sheet;
use crate::{certificates, chart, collision, growth, html, json, latex, matrix, scene, stability};

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
            files.push(gallery::data(figure).file());
        }
        let page = gallery::gallery(self).placed(place("figures.html", &[]));
        add(&mut files, "figures.html", page.html());
        let forms = [Form::new("JSON", "index.json", index::json(self)).open()];
        let page = index::index(self).placed(place("index.html", &forms));
        add(&mut files, "index.html", page.html());
        files.extend(forms.map(Form::file));
        for shared in shared::ALL {
            let path = format!("{}/{}", shared::DIRECTORY, shared.name);
            add(&mut files, path, shared.text.to_owned());
        }
        files
    }

    /// The documents: page, JSON, LaTeX, certificates, and the lemmas for Coq, which share their theory.
    fn write_audits(&self, files: &mut Vec<File>) {
        let theory = || {
            let path = format!("derivations/{}.v", coq::THEORY);
            Form::new("its theory", path, coq::shared_theory())
        };
        for (stem, report) in &self.audits {
            let path = |ending: &str| format!("derivations/{stem}.{ending}");
            let lemmas = format!("derivations/{}.v", coq::library(stem));
            let claims = Claims::of(report.audit).only(&report.shown);
            let mut forms = vec![
                Form::new("JSON", path("json"), json(std::slice::from_ref(report))),
                Form::new("LaTeX", path("tex"), latex(report)),
                Form::new("Coq", lemmas, coq::file(&claims).beside_theory()),
                theory(),
                Form::new("certificates", path("cert.json"), certificates(report)),
            ];
            let derived = derived::in_document(self, stem);
            let place = place(&path("html"), &forms).with("Laws", derived);
            let placed = report.clone().placed(place);
            add(files, path("html"), self.with_pages(html(&placed)));
            forms.remove(3);
            files.extend(forms.into_iter().map(Form::file));
        }
        files.push(theory().file());
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
            Form::new("JSON", "laws.json", matrix::json(&self.matrix)),
            Form::new("LaTeX", "laws.tex", matrix::sheet(&self.matrix).latex()),
            Form::new("CSV", "matrix.csv", matrix::csv(&self.matrix)),
            Form::new("picture", "matrix.svg", matrix::picture(&self.matrix)),
        ];
        let place = place("laws.html", &forms);
        let derived = derived::of_laws(self);
        let page = matrix::html_in_site(&self.matrix, self.laws, &place, &derived);
        add(files, "laws.html", page);
        files.extend(forms.map(Form::file));
    }

    /// What is measured of formulas and methods, each with its rows for spreadsheets.
    fn write_measured(&self, files: &mut Vec<File>) {
        let (chart, stability, growth) = (&self.chart, &self.stability, &self.growth);
        let mut write = |path: &str, sheet, json, rows| {
            let rows = Form::new("CSV", format!("{path}.csv"), rows);
            write_with(files, path, sheet, json, Some(rows));
        };
        write("chart", chart::sheet(chart), chart::json(chart), chart::csv(chart));
        let rows = stability::csv(stability);
        write("stability", stability::sheet(stability), stability::json(stability), rows);
        write("growth", growth::sheet(growth), growth::json(growth), growth::csv(growth));
    }
}

/// A file as it is; of a page, what a browser adds by itself is left out.
fn add(files: &mut Vec<File>, path: impl Into<String>, text: String) {
    let path = path.into();
    let text = if path.ends_with(".html") { shortened(&text) } else { text };
    files.push(File { path, text });
}

/// A sheet as a page and for print, with its data.
fn write(files: &mut Vec<File>, path: &str, sheet: Sheet<'_>, json: String) {
    write_with(files, path, sheet, json, None);
}

/// The same with one more form.
fn write_with(
    files: &mut Vec<File>,
    path: &str,
    sheet: Sheet<'_>,
    json: String,
    more: Option<Form>,
) {
    let mut forms = vec![
        Form::new("JSON", format!("{path}.json"), json),
        Form::new("LaTeX", format!("{path}.tex"), sheet.latex()),
    ];
    forms.extend(more);
    let page = format!("{path}.html");
    add(files, &page, sheet.placed(place(&page, &forms)).html());
    files.extend(forms.into_iter().map(Form::file));
}
