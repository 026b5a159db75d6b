//! A site: every report as a page, and an index that says what they come to.
//!
//! Pages know each other by relative addresses, so that a site works from a disk, and load nothing but what they share,
//! which is beside them.

mod derived;
mod files;
mod findings;
mod form;
mod gallery;
mod index;
mod listed;

use kane_scene::collide::Collision;

use crate::chart::ChartReport;
use crate::figures::Figure;
use crate::growth::GrowthReport;
use crate::matrix::MatrixReport;
use crate::scene::SceneReport;
use crate::stability::StabilityReport;
use crate::{Link, Place, Report};

use form::Form;

pub use form::File;
pub use index::index;
#[cfg(feature = "schema")]
pub(crate) use index::schema;
pub use listed::Listed;

/// What a site is made of.
pub struct Site<'a> {
    /// audits of derivations with the names of their files; the paper's is the first
    pub audits: Vec<(String, Report<'a>)>,
    /// the matrix of laws and properties
    pub matrix: MatrixReport<'a>,
    /// the page of the laws, `docs/laws.md`, which tells the formula and the source of each
    pub laws: &'a str,
    /// speed against accuracy
    pub chart: ChartReport<'a>,
    /// where the paper's formulas fail
    pub stability: StabilityReport<'a>,
    /// how cost grows
    pub growth: GrowthReport<'a>,
    /// the figures; the one with measured points is called `slip-over-alpha`
    pub figures: &'a [Figure],
    /// how far laws are from what was measured, the nearest first
    pub fits: &'a [Fit],
    /// collisions with the names of their files
    pub collisions: Vec<(String, &'a Collision)>,
    /// answers to scenes with the names of their files
    pub scenes: Vec<(String, SceneReport<'a>)>,
    /// a command that makes the site again
    pub command: String,
}

/// How far laws are from measured points.
#[derive(Clone, Debug, PartialEq)]
pub struct Fit {
    /// the ids of laws that are equally far, because they coincide there
    pub laws: Vec<&'static str>,
    /// the median distance of k
    pub median: f64,
}

/// The pages that every page leads to, by what they are called.
const PAGES: [(&str, &str); 8] = [
    ("Findings", "index.html"),
    ("The paper", "derivations/oblique-collision.html"),
    ("Laws", "laws.html"),
    ("Speed and accuracy", "chart.html"),
    ("Where formulas fail", "stability.html"),
    ("Growth", "growth.html"),
    ("Figures", "figures.html"),
    ("All pages", "index.html#pages"),
];

/// What is beside the page at this address: the other pages, and the other forms of what it tells.
fn place(page: &str, forms: &[Form]) -> Place {
    let up = "../".repeat(page.matches('/').count());
    let pages = PAGES.iter().filter(|(_, to)| *to != page);
    let pages = pages.map(|(words, to)| Link::new(*words, format!("{up}{to}"))).collect();
    let forms = forms.iter().map(Form::link).collect();
    Place::in_site(up).with("Site", pages).with("This page as", forms)
}
