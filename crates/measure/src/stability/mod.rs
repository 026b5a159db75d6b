//! Where the formulas of a document fail in floating point, and which equal formula does not.

mod better;
mod cause;
mod edges;
mod plane;
mod scan;
mod search;

use kane_audit::Document;

use crate::{Fault, Format, Formula, Ranges, formulas};
use scan::Probe;

pub use plane::{Cell, Plane};
pub use search::Searched;

/// The forms of one value that the program knows, as a derivation document: the shipped one, once more,
/// so that the crate builds from its package alone.
const EQUAL_FORMS: &str = include_str!("equal-forms.md");

/// The forms of one value that the program knows. A document whose claims prove that they are equal.
///
/// # Panics
/// Never: the document is part of the program, and a test reads it.
#[must_use]
pub fn equal_forms() -> Document {
    match kane_audit::read("equal-forms.md", EQUAL_FORMS.as_bytes()) {
        Ok(document) => document,
        Err(_) => unreachable!("the program's own document is well formed"),
    }
}

/// What is examined: formulas, and further ones that may be better.
#[derive(Clone, Debug)]
pub struct Subject {
    /// all formulas; those to examine come first
    pub formulas: Vec<Formula>,
    /// how many are examined
    pub examined: usize,
    /// how many of them are the document's own; the others are the program's
    pub own: usize,
    /// labels of what is printed as a formula but is not examined, and why
    pub left_out: Vec<(String, String)>,
    /// per formula, the indices of the formulas of equal value
    pub equal: Vec<Vec<usize>>,
}

impl Subject {
    /// The formulas of a document, beside the equal forms that the program knows. With `all` the
    /// latter are examined, too.
    #[must_use]
    pub fn new(document: &Document, all: bool) -> Self {
        let mut found = formulas(document);
        let own = found.formulas.len();
        let known = formulas(&equal_forms()).formulas;
        let is_new = |form: &Formula| {
            !found.formulas.iter().any(|own| {
                own.program.operations() == form.program.operations()
                    && own.inputs.iter().map(|i| &i.name).eq(form.inputs.iter().map(|i| &i.name))
            })
        };
        let known: Vec<Formula> = known.into_iter().filter(is_new).collect();
        found.formulas.extend(known);
        let equal = better::groups(&found.formulas);
        let examined = if all { found.formulas.len() } else { own };
        Self { formulas: found.formulas, examined, own, left_out: found.left_out, equal }
    }
}

/// A representable number as a report needs it.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// the place of its magnitude in the order of representable numbers ≥ 0
    pub place: u64,
    /// its value; a narrower format is widened exactly
    pub value: f64,
    /// the shortest decimal that names it in its format
    pub text: String,
}

impl Point {
    pub(crate) fn of<F: Format>(negative: bool, place: u64) -> Self {
        let float = F::signed(negative, place);
        let text = if place == 0 { "0".to_owned() } else { format!("{float:e}") };
        // the shortest decimal of a narrower format does not name the same f64, so go by bits
        let value = kane_number::decode(float).map_or(f64::NAN, |exact| {
            kane_number::encode(&exact, kane_number::Rounding::NearestEven)
        });
        Self { place, value, text }
    }
}

/// A range of inputs on which a formula fails in one way.
#[derive(Clone, Debug, PartialEq)]
pub struct Range {
    /// how it fails
    pub fault: Fault,
    /// the least input at which it does
    pub from: Point,
    /// the greatest one
    pub to: Point,
    /// whether the domain ends there, below and above; otherwise the next float is sound
    pub open: (bool, bool),
    /// the worst input
    pub worst: Point,
    /// hundredths of bits lost there
    pub lost: i64,
    /// what the formula returns there
    pub computed: String,
    /// what it should return, rounded to the format
    pub exact: String,
    /// the operation at which the loss happens, in words
    pub cause: String,
    /// an equal formula that does better on the range
    pub better: Option<Better>,
}

/// An equal formula and the worst it does where another fails.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Better {
    /// index in [`Subject::formulas`]
    pub formula: usize,
    /// hundredths of bits that it loses at most on probes of the range
    pub lost: i64,
}

/// One formula of one input in one format.
#[derive(Clone, Debug)]
pub struct Examined {
    /// index in [`Subject::formulas`]
    pub formula: usize,
    /// the format's name
    pub format: &'static str,
    /// its precision in bits
    pub precision: u32,
    /// whether this is the part of the domain below 0
    pub negative: bool,
    /// the least and the greatest input
    pub domain: (Point, Point),
    /// where it fails, by the least input
    pub ranges: Vec<Range>,
    /// the worst input of all, with the hundredths of bits lost
    pub worst: (Point, i64),
    /// per binade of the input: its exponent, the most hundredths of bits lost, the worst fault
    pub profile: Vec<(i64, i64, Option<Fault>)>,
    /// how many inputs were tried
    pub tried: usize,
}

/// What came out for a document.
#[derive(Clone, Debug)]
pub struct Stability {
    /// the document's name
    pub name: String,
    /// its title
    pub title: Option<String>,
    /// the formulas
    pub subject: Subject,
    /// formulas of one input: first inputs ≥ 0, f32 before f64, then those below 0
    pub lines: Vec<Examined>,
    /// formulas of two inputs, where both are ≥ 0
    pub planes: Vec<Plane>,
    /// formulas of three inputs or more, and those of two of which one may be below 0
    pub searches: Vec<Searched>,
}

/// Examines every formula in `f32` and `f64` over its whole domain. Deterministic.
///
/// The faults NaN, ∞, a wrong sign and 0 come in stretches, and the edges of these are exact: the
/// two representable numbers on either side of an edge are told apart by evaluation. Lost digits
/// come and go from one float to the next near an edge; the one that is given is the outermost that
/// the search found, and its neighbour is sound. Of formulas of two inputs a grid of binades is
/// examined, without edges, where both are ≥ 0; formulas of more inputs, and those of two that may be
/// below 0, are searched at points: what is found there is a failure, but others may exist.
pub fn examine(
    document: &Document,
    all: bool,
    progress: &mut dyn FnMut(usize, usize),
) -> Stability {
    examine_over(document, all, &Ranges::full_line(), progress)
}

/// The same over ranges of the inputs.
pub fn examine_over(
    document: &Document,
    all: bool,
    ranges: &Ranges,
    progress: &mut dyn FnMut(usize, usize),
) -> Stability {
    let mut subject = Subject::new(document, all);
    for formula in &mut subject.formulas {
        formula.inputs = formula.inputs.iter().map(|input| ranges.narrowed(input)).collect();
    }
    let (mut planes, mut searches) = (Vec::new(), Vec::new());
    let steps = 2 * subject.formulas.len();
    let mut found: [Vec<Option<Examined>>; 4] = Default::default();
    for index in 0..subject.formulas.len() {
        progress(2 * index, steps);
        let inputs = subject.formulas.get(index).map_or(0, |formula| formula.inputs.len());
        // those that are not examined may be better, so they are asked, too
        let is_line = inputs == 1;
        let [singles, doubles, below_singles, below_doubles] = &mut found;
        for (lines, negative) in [(singles, false), (below_singles, true)] {
            lines.push(if is_line { line::<f32>(&subject, index, negative) } else { None });
        }
        if index < subject.examined && !is_line {
            planes.extend(plane::examine::<f32>(&subject, index));
            searches.extend(search::examine::<f32>(&subject, index));
        }
        progress(2 * index + 1, steps);
        for (lines, negative) in [(doubles, false), (below_doubles, true)] {
            lines.push(if is_line { line::<f64>(&subject, index, negative) } else { None });
        }
        if index < subject.examined && !is_line {
            planes.extend(plane::examine::<f64>(&subject, index));
            searches.extend(search::examine::<f64>(&subject, index));
        }
    }
    let [singles, doubles, below_singles, below_doubles] = &mut found;
    for lines in [singles, below_singles] {
        advise::<f32>(&subject, lines);
    }
    for lines in [doubles, below_doubles] {
        advise::<f64>(&subject, lines);
    }
    let mut lines = Vec::new();
    for index in 0..subject.examined {
        let of = found.iter_mut().filter_map(|lines| lines.get_mut(index)?.take());
        lines.extend(of.map(Examined::ascending));
    }
    progress(steps, steps);
    let is_examined = |index: usize| {
        lines.iter().any(|line| line.formula == index)
            || planes.iter().any(|plane| plane.formula == index)
            || searches.iter().any(|search| search.formula == index)
    };
    for (index, formula) in subject.formulas.iter().enumerate().take(subject.examined) {
        if !is_examined(index) {
            let why = "no float was found in its domain".to_owned();
            subject.left_out.push((formula.label.clone(), why));
        }
    }
    let (name, title) = (document.name.clone(), document.title.clone());
    Stability { name, title, subject, lines, planes, searches }
}

impl Examined {
    /// With ranges from their least to their greatest input, which below 0 is against the order of
    /// magnitudes.
    fn ascending(mut self) -> Self {
        if self.negative {
            self.domain = (self.domain.1, self.domain.0);
            self.ranges.reverse();
            for range in &mut self.ranges {
                std::mem::swap(&mut range.from, &mut range.to);
                range.open = (range.open.1, range.open.0);
            }
        }
        self
    }
}

/// Says for each range which equal formula is better there.
fn advise<F: Format>(subject: &Subject, examined: &mut [Option<Examined>]) {
    let failures: Vec<usize> =
        examined.iter().map(|e| e.as_ref().map_or(0, |e| e.ranges.len())).collect();
    for examined in examined.iter_mut().flatten() {
        for range in &mut examined.ranges {
            let (index, negative) = (examined.formula, examined.negative);
            range.better = better::better::<F>(subject, index, negative, range, &failures);
        }
    }
}

/// One formula of one input in one format, on one side of 0; `None` if no float is in its domain.
fn line<F: Format>(subject: &Subject, index: usize, negative: bool) -> Option<Examined> {
    let formula = subject.formulas.get(index)?;
    let input = formula.inputs.first()?;
    let axis = input.axis::<F>(negative)?;
    let probe = Probe::<F>::new(subject, index, negative)?;
    let samples = scan::scan(&probe, &axis);
    let (first, last) = (samples.first()?.place, samples.last()?.place);
    let mut ranges = edges::ranges(&probe, &axis, &samples);
    for range in &mut ranges {
        range.cause = cause::cause(&probe, range.worst.place, range.fault);
    }
    let worst =
        samples.iter().max_by_key(|s| (s.sample.fault, s.sample.lost, u64::MAX - s.place))?;
    let (worst_place, worst_lost) = (worst.place, worst.sample.lost);
    Some(Examined {
        formula: index,
        format: F::NAME,
        precision: F::PRECISION,
        negative,
        domain: (Point::of::<F>(negative, first), Point::of::<F>(negative, last)),
        ranges,
        worst: (Point::of::<F>(negative, worst_place), worst_lost),
        profile: scan::profile::<F>(&samples),
        tried: samples.len(),
    })
}
