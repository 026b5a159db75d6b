//! The matrix of laws and properties: every law of the literature against every property that
//! mechanics asks of it.
//!
//! A cell is a conjunction of goals, one a family of contacts, a regime of the law and a link of the
//! property's template. A goal is made by running the law's own code on symbols; its hypotheses are
//! the regime's guards, the failure of the regimes before it, and what is known of the root. The
//! cell is proved if the kernel accepted a certificate for every goal. It is refuted if the law's
//! answer at a contact, in exact numbers, violates the template, and the kernel accepts that contact
//! as a point at which the hypotheses hold and the conclusion does not. Nothing is typed in.
#![deny(clippy::float_arithmetic)]

mod applied;
mod cell;
mod conjugate;
mod limits;
mod outcome;
mod pointwise;
mod property;
mod sample;
mod scale;
mod setting;
mod stop;
mod stopped;
mod study;
mod subdivision;
mod symbol;
mod visible;
mod work;

use std::rc::Rc;

use kane_impact::{Contact, Law, NoImpulse};
use kane_number::Rational;

pub use applied::{Applied, Premise, RootOf, absurd, apply, compare, rel};
pub use cell::{Cell, Finding, Said, Witness};
pub use property::{Kind, PROPERTIES, Property, property, value};
pub use sample::{Exact, contacts, resolve};
pub use setting::{SYMBOLS_IN_WORDS, Setting, Symbolic};
pub use stop::Stop;
pub use study::Part;
pub use symbol::symbols;
pub use visible::{Condition, Ranges, negated};

use property::Template;
use setting::FAMILIES;
use study::{Family, Memo};

/// A law and its cells.
#[derive(Clone, Debug)]
pub struct Row {
    /// the law, with its own parameters as they are here
    pub law: Law,
    /// one cell a property, in the order of [`Matrix::properties`]
    pub cells: Vec<Cell>,
}

/// Laws against properties.
#[derive(Clone, Debug)]
pub struct Matrix {
    /// the columns
    pub properties: Vec<&'static Property>,
    /// the laws
    pub rows: Vec<Row>,
}

/// What is asked for.
#[derive(Clone, Debug, Default)]
pub struct Selection {
    /// ids of laws; `None` for all
    pub laws: Option<Vec<String>>,
    /// ids of properties; `None` for all
    pub properties: Option<Vec<String>>,
}

impl Selection {
    fn properties(&self) -> Vec<&'static Property> {
        let wanted = |p: &&Property| {
            self.properties.as_ref().is_none_or(|ids| ids.iter().any(|id| id == p.id))
        };
        PROPERTIES.iter().filter(wanted).collect()
    }
}

/// A sentence of the matrix without the backticks around its formulas.
#[must_use]
pub fn unmarked(sentence: &str) -> String {
    sentence.replace('`', "")
}

/// The findings about one law; `progress` is told after each.
pub fn row(law: &Law, properties: &[&'static Property], progress: &mut dyn FnMut()) -> Row {
    row_with(&Rc::default(), law, properties, progress)
}

fn row_with(
    memo: &Rc<Memo>,
    law: &Law,
    properties: &[&'static Property],
    progress: &mut dyn FnMut(),
) -> Row {
    let families: Vec<Family> = FAMILIES.into_iter().map(|s| Family::new(memo, law, s)).collect();
    let mut sample = Sample::default();
    for contact in contacts(&FAMILIES) {
        match resolve(law, &contact) {
            Ok(outcome) => sample.answers.push((contact, outcome)),
            Err(NoImpulse::Outside { reason, .. }) => sample.silent.push((contact, reason)),
            Err(_) => {}
        }
    }
    let cells = properties.iter().map(|property| {
        let cell = cell(law, property, &families, &sample);
        progress();
        cell
    });
    let cells = cells.collect();
    Row { law: law.clone(), cells }
}

/// What a law says of simple contacts.
#[derive(Default)]
struct Sample {
    answers: Vec<(Contact<Rational>, Exact)>,
    /// contacts that it leaves out, and how that is told
    silent: Vec<(Contact<Rational>, &'static str)>,
}

/// Of contacts with what is known of them those of some families.
fn of_families<T: Clone>(
    all: &[(Contact<Rational>, T)],
    settings: &[Setting],
) -> Vec<(Contact<Rational>, T)> {
    let inside = |(c, _): &&(Contact<Rational>, T)| settings.iter().any(|s| s.values(c).is_some());
    all.iter().filter(inside).cloned().collect()
}

fn cell(law: &Law, property: &Property, families: &[Family], sample: &Sample) -> Cell {
    if let Some(reason) = silent_on(law, property, families) {
        return Cell::not_applicable(reason);
    }
    let found = decided(law, property, families, sample);
    match law.has_frame() && property.depends_on_frame() {
        true => found.remarked(IN_THE_FRAME_OF_THE_CONTACT),
        false => found,
    }
}

fn decided(law: &Law, property: &Property, families: &[Family], sample: &Sample) -> Cell {
    let answers = &sample.answers;
    match property.kind {
        Kind::Pointwise(settings) => {
            let template = Template::new(property.template);
            let answers = of_families(answers, settings);
            pointwise::decide(law, families, settings, &template, &answers)
        }
        Kind::Limit(infinite) => limits::decide(law, families, property.template, infinite),
        Kind::Continuous => limits::continuous(law, families, answers),
        Kind::Scale => scale::decide(law, &families[..3], answers),
        Kind::Subdivision => subdivision::decide(law, &families[0]),
        Kind::Exists(settings) => {
            let silent = of_families(&sample.silent, settings);
            outcome::exists(law, families, settings, &silent)
        }
        Kind::Unique => outcome::unique(law, &families[0]),
    }
}

/// Why alpha says nothing about a law with a frame of its own.
const NO_FUNCTION_OF_ALPHA: &str = "the law's cone and restitution stand about a normal of its own, so \
     that `k` and `i_x` depend on `e`, `mu` and the angle of incidence one by one, and are no functions of `alpha`";
/// What is asked of such a law where the axes matter.
const IN_THE_FRAME_OF_THE_CONTACT: &str = "asked in the contact's frame, while the law's cone and \
     restitution stand about a normal of its own";

/// Why a property has no meaning: one in alpha for a law that stands in a frame of its own, one of
/// every contact for a law that never speaks of coupled ones.
fn silent_on(law: &Law, property: &Property, families: &[Family]) -> Option<&'static str> {
    if property.speaks_of_alpha() && law.has_frame() {
        return Some(NO_FUNCTION_OF_ALPHA);
    }
    let Kind::Pointwise(settings) = property.kind else { return None };
    let coupled = |s: &Setting| matches!(s, Setting::Driving | Setting::Braking);
    let speaks = |f: &Family| coupled(&f.setting) && !f.regimes.is_empty();
    let asked = settings.iter().any(coupled);
    (asked && !families.iter().any(speaks)).then_some(law.info.gap).flatten()
}

/// The matrix of these laws, or what is asked for of it. `progress` is told, after each cell, how many
/// are done and how many there are.
pub fn matrix(
    laws: &[Law],
    selection: &Selection,
    progress: &mut dyn FnMut(usize, usize),
) -> Matrix {
    let properties = selection.properties();
    let wanted = |law: &&Law| {
        selection.laws.as_ref().is_none_or(|ids| ids.iter().any(|id| id == law.info.id))
    };
    let laws: Vec<&Law> = laws.iter().filter(wanted).collect();
    let all = laws.len() * properties.len();
    let (memo, mut done) = (Rc::default(), 0);
    let rows = laws.into_iter().map(|law| {
        row_with(&memo, law, &properties, &mut || {
            done += 1;
            progress(done, all);
        })
    });
    let rows = rows.collect();
    Matrix { properties, rows }
}

impl Matrix {
    /// How many cells end so.
    #[must_use]
    pub fn count(&self, finding: Finding) -> usize {
        self.rows.iter().flat_map(|row| &row.cells).filter(|cell| cell.finding == finding).count()
    }
}
