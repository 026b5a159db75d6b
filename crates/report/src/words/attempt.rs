//! What was tried in vain: the methods by name, and the smallest conditions that stay open.

use kane_audit::{Attempt, Method};
use kane_kernel::Context;

use super::formula::Formulas;
use super::{Form, words};

/// Conditions that are shown.
const MOST: usize = 2;
/// Terms of a condition that is shown.
const LONGEST: usize = 6;

/// After what says why a link is undecided.
pub(super) fn remark(attempt: &Attempt, context: &Context, form: Form) -> String {
    let names: Vec<&str> = attempt.tried.iter().map(|m| name(*m)).collect();
    let mut text = words(&format!("; tried: {}", names.join(", ")), form);
    let formulas = Formulas::new(form, context, &attempt.variables);
    let short = attempt.left.iter().filter(|a| a.poly.len() <= LONGEST).take(MOST);
    let shown: Vec<String> = short.map(|a| formulas.atom(a)).collect();
    if shown.is_empty() {
        return text;
    }
    text.push_str(&words("; left open, whether these can hold together: ", form));
    text.push_str(&shown.join(", "));
    let more = attempt.left.len() - shown.len();
    if more > 0 {
        text.push_str(&words(&format!(" and {more} more"), form));
    }
    text
}

fn name(method: Method) -> &'static str {
    match method {
        Method::SignTables => "sign tables",
        Method::Hints => "the hints",
        Method::Combinations => "sums of conditions",
        Method::Products => "products of conditions",
        Method::Squares => "sums of squares",
        Method::Ideals => "ideals",
        Method::Tangents => "tangent planes",
        Method::Differences => "successive differences",
        Method::Boxes => "boxes",
        Method::Points => "points",
        Method::Cells => "cells",
        Method::Cases => "cases by elimination",
        _ => "others",
    }
}
