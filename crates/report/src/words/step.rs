//! Steps as lines, indented by how they are nested.

use std::cmp::Ordering;

use kane_audit::{Held, Source, Step, Summand};
use kane_kernel::{Poly, Root};
use num_traits::One as _;

use super::Line;
use super::formula::Formulas;
use super::value::{assigned, comparison, end, root};

/// All lines of a proof or a witness.
pub(super) fn lines(labels: &[&str], formulas: &Formulas, steps: &[Step]) -> Vec<Line> {
    let mut teller = Teller { labels, formulas, lines: Vec::new() };
    teller.all(0, steps);
    teller.lines
}

struct Teller<'a> {
    labels: &'a [&'a str],
    formulas: &'a Formulas,
    lines: Vec<Line>,
}

impl Teller<'_> {
    fn say(&mut self, depth: usize, text: String) {
        self.lines.push(Line { depth, text });
    }

    fn all(&mut self, depth: usize, steps: &[Step]) {
        for step in steps {
            self.step(depth, step);
        }
    }

    fn step(&mut self, depth: usize, step: &Step) {
        let f = self.formulas;
        match step {
            Step::Suppose { hypotheses_alone, then } => {
                let what = match hypotheses_alone {
                    true => "all hypotheses hold",
                    false => "the hypotheses hold and the claim does not",
                };
                self.say(depth, format!("Suppose that {what}. This is contradictory:"));
                self.all(depth + 1, then);
            }
            Step::Assume { source, atoms } => {
                self.say(depth, format!("{}: {}.", self.source(*source), f.atoms(atoms)));
            }
            Step::Cases { source, cases } => {
                let what = self.source(*source);
                self.say(depth, format!("{what}: one of {} cases.", cases.len()));
                for (number, (atoms, then)) in cases.iter().enumerate() {
                    self.say(depth + 1, format!("Case {}: {}.", number + 1, f.atoms(atoms)));
                    self.all(depth + 2, then);
                }
            }
            Step::Split { poly, zero, positive, negative } => {
                self.say(depth, format!("Distinguish the sign of {}:", f.poly(poly)));
                for (sign, then) in [("=", zero), (">", positive), ("<", negative)] {
                    self.say(depth + 1, format!("{}:", f.against_zero(poly, sign)));
                    self.all(depth + 2, then);
                }
            }
            Step::Substitute { variable, value, leaves } => {
                let equation = f.compared(&f.symbol(*variable), "=", &f.ratio(value));
                self.say(depth, format!("Substitute {equation}."));
                self.leaves(depth, leaves);
            }
            Step::Reduce { variable, by, leaves } => {
                let (name, by) = (f.symbol(*variable), f.atom(by));
                self.say(depth, format!("Reduce powers of {name} by {by}."));
                self.leaves(depth, leaves);
            }
            Step::Divide { atom, by, quotient } => {
                let factor = |(p, n): &(Poly, u32)| match n {
                    1 => f.poly(p),
                    n => format!("{}{}", f.in_parentheses(p), f.power(*n)),
                };
                let by: Vec<String> = by.iter().map(factor).collect();
                let (atom, left) = (f.atom(atom), f.atom(quotient));
                let by = by.join(" and ");
                self.say(depth, format!("Divide {atom} by {by}, which cannot vanish: {left}."));
            }
            Step::Positive { terms, multiples } => {
                let mut parts: Vec<String> = terms.iter().map(|t| self.summand(t)).collect();
                parts.extend(
                    multiples.iter().map(|(c, p)| {
                        format!("{}{}[{}]", f.in_parentheses(c), f.times(), f.poly(p))
                    }),
                );
                let brackets = if multiples.is_empty() { "" } else { " (brackets vanish)" };
                let sum = parts.join(" + ");
                let zero = f.number(&num_traits::Zero::zero());
                self.say(depth, format!(
                    "{sum} is {zero} identically, yet it is a sum of non-negative terms, one of them positive{brackets}."
                ));
            }
            Step::SignsOfCoefficients { atom, bounds } => {
                let bounds: Vec<String> = bounds.iter().map(|a| f.atom(a)).collect();
                self.say(depth, format!(
                    "{} contradicts {}: measured from these bounds, all its coefficients have the other sign.",
                    f.atom(atom),
                    bounds.join(", ")
                ));
            }
            Step::SignTable { variable, cuts, atoms } => {
                let atoms: Vec<String> = atoms.iter().map(|a| f.atom(a)).collect();
                let cuts: Vec<String> = cuts.iter().map(|cut: &Root| root(f, cut)).collect();
                let cuts = match &cuts[..] {
                    [] => "without a root".to_owned(),
                    cuts => format!("cut at {}", cuts.join(", ")),
                };
                let name = f.symbol(*variable);
                let atoms = atoms.join(", ");
                let text = format!("On the line of {name}, {cuts}, no part satisfies {atoms}.");
                self.say(depth, text);
            }
            Step::Absurd(atom) => self.say(depth, format!("{} is false.", f.atom(atom))),
            Step::Pass { side, power, along, otherwise, end } => {
                self.say(depth, format!(
                    "Along {} for small {}: {}. (Square brackets stand for a quantity that has a limit.)",
                    f.side(side, *power),
                    f.small_germ(),
                    f.atom(along)
                ));
                self.otherwise(depth, otherwise);
                self.say(depth, format!("In the limit {}: {}.", f.no_germ(), f.atom(end)));
            }
            Step::LimitFrom { side, power, of, sense, quotient, otherwise, start, order } => {
                let sign = match sense {
                    Ordering::Less => "<=",
                    Ordering::Equal => "=",
                    Ordering::Greater => ">=",
                };
                let equal = f.compared(&f.expr(of), sign, &f.ratio(quotient));
                let (with, small) = (f.side(side, *power), f.small_germ());
                self.say(depth, format!("With {with}, {equal} for all small {small}."));
                self.otherwise(depth, otherwise);
                let at = f.no_germ();
                self.say(depth, match order {
                    0 if *sense == Ordering::Equal => {
                        format!("At {at} this is {}.", f.quotient(start))
                    }
                    0 => format!("At {at} the bound is {}.", f.quotient(start)),
                    order => format!(
                        "At {at} the numerator is {} and the denominator vanishes to order {order}.",
                        f.poly(&start.0)
                    ),
                });
            }
            Step::Point { values, sides } => {
                let values = assigned(f, values).join(", ");
                self.say(depth, format!("At the point {values}:"));
                for (of, sides) in sides {
                    let what = match of.map(|h| self.labels.get(h)) {
                        None => "the claim".to_owned(),
                        Some(Some(label)) => f.words(label),
                        // a given behind the cited claims
                        Some(None) => continue,
                    };
                    self.say(depth + 1, format!("{what}: {}", comparison(f, sides)));
                }
            }
            Step::Functions { of, values, hypotheses, end: ends } => {
                let values = assigned(f, values);
                if !values.is_empty() {
                    self.say(depth, format!("Take {}.", values.join(", ")));
                }
                let x = f.symbol(*of);
                for (Held { by_proof, limits }, label) in hypotheses.iter().zip(self.labels) {
                    let how = if *by_proof { ", by a sign table or substitution" } else { "" };
                    let limits = if *limits { "; its limit is as premised" } else { "" };
                    let label = f.words(label);
                    self.say(depth + 1, format!("{label} holds for all {x}{how}{limits}."));
                }
                self.say(depth, format!("Then {}.", end(f, ends)));
            }
        }
    }

    fn leaves(&mut self, depth: usize, leaves: &[kane_kernel::Atom]) {
        if !leaves.is_empty() {
            self.say(depth, format!("This leaves {}.", self.formulas.atoms(leaves)));
        }
    }

    fn otherwise(&mut self, depth: usize, steps: &[Step]) {
        self.say(depth + 1, "Otherwise:".to_owned());
        self.all(depth + 2, steps);
    }

    /// weight · square² · Π factorⁿ
    fn summand(&self, summand: &Summand) -> String {
        let f = self.formulas;
        let mut factors = Vec::new();
        if !summand.weight.is_one() {
            factors.push(f.number(&summand.weight.clone().into()));
        }
        if summand.square != Poly::one() {
            factors.push(format!("{}{}", f.in_parentheses(&summand.square), f.power(2)));
        }
        let power = |(p, n): &(Poly, u32)| format!("{}{}", f.in_parentheses(p), f.power(*n));
        factors.extend(summand.factors.iter().map(power));
        match &factors[..] {
            [] => f.number(&num_traits::One::one()),
            factors => factors.join(f.times()),
        }
    }

    /// What a formula stands for.
    fn source(&self, source: Source) -> String {
        let label = |h: usize| {
            let label = self.labels.get(h).copied();
            label.map(|label| self.formulas.words(label))
        };
        match source {
            Source::Hypothesis(h) => {
                label(h).unwrap_or_else(|| "a given behind the cited claims".to_owned())
            }
            Source::Limit(h) => {
                format!("the limit in {}", label(h).unwrap_or_else(|| "a given".to_owned()))
            }
            Source::Condition => "the condition of the claim".to_owned(),
            Source::Failure => "the claim fails".to_owned(),
        }
    }
}
