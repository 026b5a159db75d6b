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

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use kane_kernel::{Atom, Poly, Sign};

    use super::*;

    const ALL: [Method; 12] = [
        Method::SignTables,
        Method::Hints,
        Method::Combinations,
        Method::Products,
        Method::Squares,
        Method::Ideals,
        Method::Tangents,
        Method::Differences,
        Method::Boxes,
        Method::Points,
        Method::Cells,
        Method::Cases,
    ];

    fn told(tried: &[Method], left: Vec<Atom>) -> String {
        let document = kane_audit::read("a.md", b"```kane\nvar a, b\n```\n").expect("two symbols");
        let attempt = Attempt { tried: tried.to_vec(), variables: Vec::new(), left };
        remark(&attempt, &document.context, Form::Plain)
    }

    /// A sum of so many powers of the first symbol.
    fn sum(terms: u32) -> Poly {
        Poly::sum((1..=terms).map(|n| (vec![(0, n)], 1.into())))
    }

    #[test]
    fn each_method_has_a_name_of_its_own() {
        let named = |method| told(&[method], Vec::new());
        let names: BTreeSet<String> = ALL.iter().map(|m| named(*m)).collect();
        assert_eq!(names.len(), ALL.len());
        for name in &names {
            assert!(name.len() > "; tried: ".len() && !name.contains("others"), "{name}");
        }
        let all = told(&ALL, Vec::new());
        let bare: Vec<String> = ALL.iter().map(|m| named(*m).replace("; tried: ", "")).collect();
        assert_eq!(all, format!("; tried: {}", bare.join(", ")), "in the order of their trial");
    }

    #[test]
    fn of_what_stays_open_two_short_conditions_are_shown_and_the_others_counted() {
        let positive = |p: Poly| Atom::new(p, Sign::Positive);
        let (a, b) = (positive(Poly::var(0)), positive(Poly::var(1)));
        let long = positive(sum(7));
        let open = "; tried: boxes; left open, whether these can hold together: ";
        let of = |left: &[&Atom]| told(&[Method::Boxes], left.iter().copied().cloned().collect());
        assert_eq!(of(&[]), "; tried: boxes");
        assert_eq!(of(&[&long, &long]), "; tried: boxes");
        assert_eq!(of(&[&a]), format!("{open}a > 0"));
        assert_eq!(of(&[&a, &b]), format!("{open}a > 0, b > 0"));
        assert_eq!(of(&[&a, &long, &b, &a]), format!("{open}a > 0, b > 0 and 2 more"));
        // six terms are few enough
        assert!(of(&[&long, &positive(sum(6))]).contains("a^6"));
    }
}
