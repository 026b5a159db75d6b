//! The list of pages: what each is about, and what it comes to in a line.

use serde::Serialize;

use super::Site;
use crate::{Summary, collision, growth, matrix, scene, stability};

/// A page of a site.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Listed {
    /// the heading that it stands under
    pub group: &'static str,
    /// what it is called
    pub title: String,
    /// its address, seen from the index
    pub to: String,
    /// what it comes to
    pub line: String,
}

impl Site<'_> {
    /// Every page but the index, in the order in which they are listed.
    #[must_use]
    pub fn listed(&self) -> Vec<Listed> {
        let mut all = Vec::new();
        let mut list = |group, title: &str, to: String, line: String| {
            all.push(Listed { group, title: title.to_owned(), to, line });
        };
        for (stem, report) in &self.audits {
            let title = report.audit.document.title.as_deref().unwrap_or(stem);
            let line = Summary::of(report);
            let line = format!("{}; {}", line.headline(), line.expectation());
            list("Derivations", title, format!("derivations/{stem}.html"), line);
        }
        let headline = matrix::sheet(&self.matrix).headline().to_owned();
        list("Laws", "Laws and properties", "laws.html".to_owned(), headline);
        let mut laws: Vec<&str> = self.chart.all.iter().map(|one| one.method.law).collect();
        laws.dedup();
        let chart =
            format!("{} ways to compute what {} laws say", self.chart.all.len(), laws.len());
        list("Floats", "Speed against accuracy", "chart.html".to_owned(), chart);
        let headline = stability::sheet(&self.stability).headline().to_owned();
        list("Floats", "Where formulas fail", "stability.html".to_owned(), headline);
        let headline = growth::sheet(&self.growth).headline().to_owned();
        let headline = if headline.is_empty() {
            "rows in a batch, bounces in a chain, variables of a claim".to_owned()
        } else {
            headline
        };
        list("Floats", "How cost grows", "growth.html".to_owned(), headline);
        let drawn = format!("{} figures with their data", self.figures.len());
        list("Figures", "Laws, measured points, energy", "figures.html".to_owned(), drawn);
        for (stem, collision) in &self.collisions {
            let line = collision::sheet(collision).headline().to_owned();
            list("Collisions", &collision.title, format!("collisions/{stem}.html"), line);
        }
        for (stem, report) in &self.scenes {
            let line = scene::SceneReport::headline(report);
            list("Scenes", &report.title, format!("scenes/{stem}.html"), line);
        }
        all
    }
}
