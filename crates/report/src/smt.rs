//! SMT-LIB: the opposite of a claim as polynomial conditions, for solvers that decide them.
//!
//! Denominators are cleared, and every condition under which something is defined is asserted
//! beside it. A proved claim's conditions have no common point: the answer should be `unsat`. For a
//! refuted one the witness is asserted too: `sat`.

use std::fmt::Write as _;

use kane_audit::Accepted;
use kane_kernel::{
    Atom, Certificate, Conclusion, Evidence, Finding, Fuel, Link, Model, Point, Poly, Scope, Sign,
    claim_state, premised, scope,
};
use num_bigint::BigInt;
use num_traits::{One, Signed};

use crate::Report;

/// A question to a solver.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Question {
    /// one file with one `check-sat`
    pub text: String,
    /// whether the answer should be `sat`; else `unsat`
    pub satisfiable: bool,
}

/// The question that a finding answers; `None` if it speaks of limits.
#[must_use]
pub fn smt(accepted: &Accepted) -> Option<Question> {
    let (goal, Certificate { finding, evidence, .. }) = (&accepted.goal, &accepted.certificate);
    let limit = matches!(goal.conclusion, Conclusion::Link(Link::Limit(_)));
    if limit || premised(goal).next().is_some() {
        return None;
    }
    let scope = scope(goal, Fuel::new(u64::MAX)).ok()?;
    let state = claim_state(&scope, goal, *finding).ok()?;
    let point = match evidence {
        Evidence::Contradiction(_) => None,
        Evidence::Model(Model::Point(point)) => Some(point),
        Evidence::Model(Model::Functions(_)) | Evidence::Limit(_) => return None,
    };
    let names = Names { scope: &scope };
    let mut text = "(set-logic QF_NRA)\n".to_owned();
    let roots = goal.context.vars.len()..scope.germ();
    for v in scope.mentioned.iter().copied().chain(roots) {
        let _ = writeln!(text, "(declare-const {} Real)", names.of(v));
    }
    for atom in &state.atoms {
        let _ = writeln!(text, "(assert {})", names.atom(atom));
    }
    for cases in state.formulas.iter() {
        let all: Vec<String> = cases.iter().map(|c| names.all(c)).collect();
        match all.as_slice() {
            [one] if one == "true" => {}
            [one] => _ = writeln!(text, "(assert {one})"),
            many => _ = writeln!(text, "(assert (or false {}))", many.join(" ")),
        }
    }
    if let Some(point) = point {
        text.push_str(&names.point(point));
    }
    text.push_str("(check-sat)\n");
    let satisfiable = point.is_some() && *finding != Finding::Vacuous;
    Some(Question { text, satisfiable })
}

/// The questions to all links that a report shows, each with a name for its file.
#[must_use]
pub fn questions(report: &Report<'_>) -> Vec<(String, Question)> {
    let mut out: Vec<(String, Question)> = Vec::new();
    for &statement in &report.shown {
        let links = &report.audit.judgements[statement].links;
        for (link, judged) in links.iter().enumerate() {
            let Some(question) = judged.accepted.as_deref().and_then(smt) else {
                continue;
            };
            let mut name = crate::coq::link_name(
                &report.audit.document.statements[statement].label,
                (link, links.len()),
            );
            while out.iter().any(|(n, _)| *n == name) {
                name.push('_');
            }
            out.push((name, question));
        }
    }
    out
}

struct Names<'s, 'g> {
    scope: &'s Scope<'g>,
}

impl Names<'_, '_> {
    fn of(&self, v: usize) -> String {
        match self.scope.context.vars.get(v) {
            Some(var) => format!("|{}|", var.name),
            None => format!("|root {}|", v - self.scope.context.vars.len() + 1),
        }
    }

    fn poly(&self, p: &Poly) -> String {
        let term = |m: &kane_kernel::Monomial, c: &BigInt| {
            let mut factors = Vec::new();
            if !c.is_one() || m.is_empty() {
                factors.push(integer(c));
            }
            for &(v, n) in m {
                factors.extend((0..n).map(|_| self.of(v)));
            }
            operation("*", &factors, "1")
        };
        let terms: Vec<String> = p.terms().map(|(m, c)| term(m, c)).collect();
        operation("+", &terms, "0")
    }

    fn atom(&self, a: &Atom) -> String {
        let p = self.poly(&a.poly);
        match a.sign {
            Sign::Zero => format!("(= {p} 0)"),
            Sign::NonZero => format!("(not (= {p} 0))"),
            Sign::NonNegative => format!("(>= {p} 0)"),
            Sign::Positive => format!("(> {p} 0)"),
        }
    }

    fn all(&self, atoms: &[Atom]) -> String {
        operation("and", &atoms.iter().map(|a| self.atom(a)).collect::<Vec<_>>(), "true")
    }

    /// The coordinates of a witness, with the number in which they are polynomials.
    fn point(&self, point: &Point) -> String {
        let fraction = |q: &num_rational::BigRational| match q.denom().is_one() {
            true => integer(q.numer()),
            false => format!("(/ {} {})", integer(q.numer()), q.denom()),
        };
        let power = |n: usize| vec!["theta".to_owned(); n];
        let mut text = String::new();
        if let Some(root) = &point.generator {
            let terms = root.poly.iter().enumerate();
            let terms: Vec<String> = terms
                .map(|(n, c)| operation("*", &[vec![integer(c)], power(n)].concat(), "1"))
                .collect();
            let _ = writeln!(text, "(declare-const theta Real)");
            let _ = writeln!(text, "(assert (= {} 0))", operation("+", &terms, "0"));
            let (lo, hi) = (fraction(&root.lo), fraction(&root.hi));
            let _ = writeln!(text, "(assert (< {lo} theta {hi}))");
        }
        for (v, cs) in &point.values {
            let known = self.scope.mentioned.contains(v) || self.scope.root(*v).is_some();
            if !known {
                continue;
            }
            let terms = cs.iter().enumerate();
            let terms: Vec<String> = terms
                .map(|(n, c)| operation("*", &[vec![fraction(c)], power(n)].concat(), "1"))
                .collect();
            let value = operation("+", &terms, "0");
            let _ = writeln!(text, "(assert (= {} {value}))", self.of(*v));
        }
        text
    }
}

fn integer(c: &BigInt) -> String {
    if c.is_negative() { format!("(- {})", c.magnitude()) } else { c.to_string() }
}

fn operation(operator: &str, parts: &[String], empty: &str) -> String {
    match parts {
        [] => empty.to_owned(),
        [one] => one.clone(),
        many => format!("({operator} {})", many.join(" ")),
    }
}
