//! Audits of derivation documents.

use kane_audit::{Audit, LinkJudgement, Memo, Options, Verdict, audit_again, read};
use kane_kernel::{Evidence, Model, Point};
use kane_report::{Report, html, json, markdown, text};
use num_rational::BigRational;
use pyo3::prelude::*;

use crate::away::{Awaited, away};
use crate::bad_input;

/// The value of a symbol: numerator and denominator where it is a fraction; otherwise nothing, and the
/// coefficients of a polynomial in the root of the point.
type Value = (String, Option<(String, String)>, Vec<(String, String)>);

/// An algebraic number: an integer polynomial from x⁰ up, and the ends between which its root lies.
type Root = (Vec<String>, (String, String), (String, String));

/// A witness: the places of its statement and of its link, its values, and the root they are in.
type Witness = (usize, usize, Vec<Value>, Option<Root>);

/// A report as JSON, HTML, Markdown and text, and its witnesses.
type Told = (String, String, String, String, Vec<Witness>);

/// Judges every statement of a document; gives the report as JSON, HTML, Markdown and text, and the points
/// that the kernel accepted against claims.
///
/// # Errors
/// `ValueError` with every fault, if the text is no document.
#[pyfunction]
pub(crate) fn audit(py: Python<'_>, document: String, name: String, effort: u64) -> PyResult<Told> {
    away(py, move |awaited| {
        let audit = judged(&document, &name, effort, None, awaited)?;
        Ok(told(&audit, &name))
    })?
}

fn told(audit: &Audit, name: &str) -> Told {
    let report = Report::new(audit, format!("kane audit {name}"));
    let found = audit.judgements.iter().enumerate().flat_map(|(statement, judgement)| {
        let links = judgement.links.iter().enumerate();
        links.filter_map(move |(at, link)| witness(link).map(|point| (statement, at, link, point)))
    });
    let witnesses = found.filter_map(|(statement, link, judged, point)| {
        let goal = &judged.accepted.as_deref()?.goal;
        let value = |(var, parts): &(usize, Vec<BigRational>)| {
            let name = goal.context.vars.get(*var)?.name.clone();
            let exact = match (parts.as_slice(), &point.generator) {
                ([], _) => Some(("0".to_owned(), "1".to_owned())),
                ([one], _) => Some(fraction(one)),
                (_, _) => None,
            };
            Some((name, exact, parts.iter().map(fraction).collect()))
        };
        let root = point.generator.as_ref().map(|root| {
            let poly = root.poly.iter().map(ToString::to_string).collect();
            (poly, fraction(&root.lo), fraction(&root.hi))
        });
        Some((statement, link, point.values.iter().filter_map(value).collect(), root))
    });
    let witnesses = witnesses.collect();
    let reports = std::slice::from_ref(&report);
    let page = kane_report::Page::default();
    (json(reports), html(&report), markdown(&report), text(&report, page), witnesses)
}

/// The proof or the witness of one statement, by its place, written out for a person with paper.
///
/// # Errors
/// `ValueError` if the text is no document, or has no such statement.
#[pyfunction]
pub(crate) fn explain(
    py: Python<'_>,
    document: String,
    name: String,
    effort: u64,
    place: usize,
) -> PyResult<String> {
    away(py, move |awaited| {
        let audit = judged(&document, &name, effort, Some(vec![place]), awaited)?;
        kane_report::explain(&audit, place).ok_or_else(|| bad_input("there is no such statement"))
    })?
}

/// Judges the statements of these places, or all, as long as somebody waits.
fn judged(
    document: &str,
    name: &str,
    effort: u64,
    only: Option<Vec<usize>>,
    awaited: &Awaited,
) -> PyResult<Audit> {
    let document = read(name, document.as_bytes()).map_err(|faults| faulty(&faults))?;
    let mut options = Options { only, ..Options::default() };
    options.budget = options.budget.times(effort.max(1));
    audit_again(document, &options, &mut Memo::default(), &mut |_, _| awaited.still())
        .ok_or_else(|| bad_input("the audit was interrupted"))
}

fn faulty(faults: &[kane_audit::Diagnostic]) -> PyErr {
    let faults: Vec<String> = faults.iter().map(ToString::to_string).collect();
    bad_input(faults.join("\n"))
}

/// The point that speaks against a link, if a point does.
fn witness(link: &LinkJudgement) -> Option<&Point> {
    if !matches!(link.verdict, Verdict::Refuted | Verdict::IllDefined) {
        return None;
    }
    match &link.accepted.as_deref()?.certificate.evidence {
        Evidence::Model(Model::Point(point)) => Some(point),
        _ => None,
    }
}

fn fraction(value: &BigRational) -> (String, String) {
    (value.numer().to_string(), value.denom().to_string())
}
