//! Steps as sentences, indented by how they are nested.

use std::cmp::Ordering;
use std::iter::Peekable;
use std::slice::Iter;

use kane_audit::{Held, Source, Step, Supposed};
use kane_kernel::{Atom, Expr, Root, Sign};
use num_traits::Zero as _;

use super::formula::Formulas;
use super::lines::{Pen, Sentence};
use super::shape::Shapes;
use super::teller::{Branch, Teller};
use super::value::{assigned, end, root};
use super::{Form, Line};

/// Letters of sentences that share a line.
const TOGETHER: usize = 100;
/// Terms of a named polynomial, and products of a sum, that are written out.
const MOST_TERMS: usize = 60;

/// All lines of a proof or a witness; at their end, folded, what the names of long polynomials stand for.
pub(super) fn lines(
    labels: &[&str],
    (form, context): (Form, &kane_kernel::Context),
    proof: &kane_audit::Proof,
) -> Vec<Line> {
    let shapes = Shapes::for_proof();
    let of = |form| Formulas::new(form, context, &proof.variables).named(&shapes);
    let (set, plain) = (of(form), of(Form::Plain));
    let pen = Pen { set: &set, plain: &plain };
    let mut teller =
        Teller { labels, pen: &pen, lines: Vec::new(), explained: false, no_value: false };
    teller.all(0, &proof.steps);
    let mut lines = teller.lines;
    for (name, terms, told) in set.legend() {
        let told =
            if terms > MOST_TERMS { format!("a polynomial with {terms} terms") } else { told };
        lines.push(Line { depth: 0, text: format!("{name}: {told}"), folded: true });
    }
    lines
}

impl Teller<'_> {
    /// The steps in order. Assumptions that are short share a line, and so does what is left with what is wrong with it.
    pub(super) fn all(&mut self, depth: usize, steps: &[Step]) {
        let mut before: Option<Sentence> = None;
        let mut steps = steps.iter().peekable();
        while let Some(step) = steps.next() {
            let Some(sentence) = self.next_sentence(step, &mut steps) else {
                if let Some(before) = before.take() {
                    self.say(depth, before);
                }
                self.nested(depth, step);
                continue;
            };
            before = Some(match before.take() {
                Some(before) if before.letters() + sentence.letters() < TOGETHER => {
                    before.and(sentence)
                }
                Some(before) => {
                    self.say(depth, before);
                    sentence
                }
                None => sentence,
            });
        }
        if let Some(before) = before {
            self.say(depth, before);
        }
    }

    /// Steps in one sentence, if that is short.
    pub(super) fn brief(&self, steps: &[Step]) -> Option<Sentence> {
        let mut all: Option<Sentence> = None;
        let mut steps = steps.iter().peekable();
        while let Some(step) = steps.next() {
            let sentence = self.next_sentence(step, &mut steps)?;
            let told = match all.take() {
                Some(before) => before.and(sentence),
                None => sentence,
            };
            if told.letters() > TOGETHER {
                return None;
            }
            all = Some(told);
        }
        all
    }

    /// A step as a sentence, with the next one where that says what is wrong with it; `None` if steps are inside it.
    fn next_sentence(&self, step: &Step, steps: &mut Peekable<Iter<'_, Step>>) -> Option<Sentence> {
        let sentence = self.sentence(step)?;
        let whole = steps.peek().and_then(|next| self.contradicted(step, next));
        if whole.is_some() {
            steps.next();
        }
        Some(whole.unwrap_or(sentence))
    }

    /// The lines of steps, told apart from the others.
    pub(super) fn told(&self, steps: &[Step]) -> Vec<Line> {
        let Self { labels, pen, no_value, .. } = *self;
        let mut teller = Teller { labels, pen, lines: Vec::new(), explained: true, no_value };
        teller.all(0, steps);
        teller.lines
    }

    /// Steps with others inside them.
    fn nested(&mut self, depth: usize, step: &Step) {
        match step {
            Step::Suppose { what: supposed, then } => {
                let what = match supposed {
                    Supposed::Hypotheses => "all hypotheses hold",
                    Supposed::Failure => "the hypotheses hold and the claim does not",
                    Supposed::NoValue => "the hypotheses hold and a side has no value",
                };
                let what = format!("Suppose that {what}. This is contradictory:");
                self.say(depth, Sentence::of(&what));
                self.no_value = *supposed == Supposed::NoValue;
                self.all(depth + 1, then);
            }
            Step::Cases { source, cases } => {
                let branch = |(atoms, then)| Branch { atoms, then };
                let branches = cases.iter().map(|(atoms, then)| branch((atoms.clone(), &then[..])));
                self.cases(depth, *source, branches.collect());
            }
            Step::Split { poly, zero, positive, negative } => {
                self.signs(depth, poly, [zero, positive, negative]);
            }
            Step::Pass { side, power, along, otherwise, end } => {
                let along = self.pen.write(|f| {
                    let (side, small) = (f.side(side, *power), f.small_germ());
                    format!("Along {side} for small {small}: {}.", f.atom(along))
                });
                let explained =
                    std::mem::replace(&mut self.explained, true) || !self.has_brackets(step);
                let brackets = "(Square brackets stand for a quantity that has a limit.)";
                self.say(depth, if explained { along } else { along.and(Sentence::of(brackets)) });
                self.otherwise(depth, otherwise);
                self.say(
                    depth,
                    self.pen.write(|f| format!("In the limit {}: {}.", f.no_germ(), f.atom(end))),
                );
            }
            Step::LimitFrom { side, power, of, sense, quotient, otherwise, start, order } => {
                let sign = match sense {
                    Ordering::Less => "<=",
                    Ordering::Equal => "=",
                    Ordering::Greater => ">=",
                };
                let with = self.pen.write(|f| format!("With {},", f.side(side, *power)));
                let equal = self.pen.write(|f| {
                    let equal = f.compared(&f.expr(of), sign, &f.ratio(quotient));
                    format!("{equal} for all small {}.", f.small_germ())
                });
                self.say(depth, with.and(equal));
                if !matches!(otherwise[..], [Step::Equal { .. }]) {
                    self.otherwise(depth, otherwise);
                }
                let ends = self.pen.write(|f| {
                    let at = f.no_germ();
                    match order {
                        0 if *sense == Ordering::Equal => {
                            format!("At {at} this is {}.", f.ratio(start))
                        }
                        0 => format!("At {at} the bound is {}.", f.ratio(start)),
                        order => format!(
                            "At {at} the numerator is {} and the denominator vanishes to order {order}.",
                            f.poly(&start.0)
                        ),
                    }
                });
                self.say(depth, ends);
            }
            Step::Beside { all, values, said } => self.beside(depth, *all, values, said),
            Step::Point { values, definitions, said } => {
                self.point(depth, values, definitions, said)
            }
            Step::Functions { of, values, hypotheses, end: ends } => {
                if !values.is_empty() {
                    let one = |i: usize| self.pen.write(|f| assigned(f, &values[i..=i]).concat());
                    let values = Sentence::list((0..values.len()).map(one).collect());
                    self.say(depth, Sentence::of("Take").and(values).end("."));
                }
                for (Held { by_proof, limits }, label) in hypotheses.iter().zip(self.labels) {
                    let how = if *by_proof { ", by a sign table or substitution" } else { "" };
                    let limits = if *limits { "; its limit is as premised" } else { "" };
                    let held = self.pen.write(|f| {
                        let (label, x) = (f.words(label), f.symbol(*of));
                        format!("{label} holds for all {x}{how}{limits}.")
                    });
                    self.say(depth + 1, held);
                }
                self.say(depth, self.pen.write(|f| format!("Then {}.", end(f, ends))));
            }
            _ => {}
        }
    }

    fn has_brackets(&self, step: &Step) -> bool {
        let Step::Pass { along, .. } = step else { return false };
        self.pen.plain.atom(along).contains('[')
    }

    fn otherwise(&mut self, depth: usize, steps: &[Step]) {
        match self.brief(steps) {
            Some(brief) => self.say(depth + 1, Sentence::of("Otherwise:").and(brief)),
            None => {
                self.say(depth + 1, Sentence::of("Otherwise:"));
                self.all(depth + 2, steps);
            }
        }
    }

    /// A step that one sentence tells.
    fn sentence(&self, step: &Step) -> Option<Sentence> {
        Some(match step {
            Step::Assume { source, atoms } => {
                self.source(*source).end(":").begun().and(self.atoms(atoms)).end(".")
            }
            Step::Solve { solved, divided, leaves } => {
                self.solved(solved, divided, self.atoms(leaves), leaves.is_empty()).end(".")
            }
            Step::Reduce { variable, by, leaves } => {
                let reduce = self.pen.write(|f| {
                    let (name, by) = (f.symbol(*variable), f.atom(by));
                    format!("Reduce powers of {name} by {by}.")
                });
                match leaves.is_empty() {
                    true => reduce,
                    false => {
                        reduce.and(Sentence::of("This leaves")).and(self.atoms(leaves)).end(".")
                    }
                }
            }
            Step::Kept(definitions) => {
                let names = self.pen.write(|f| {
                    let names = definitions.iter().map(|i| f.expr(&Expr::Let(*i)));
                    names.collect::<Vec<_>>().join(", ")
                });
                names.and(Sentence::of(
                    "stay as they are: what follows is so for any values of theirs.",
                ))
            }
            Step::Suppose { .. }
            | Step::Cases { .. }
            | Step::Split { .. }
            | Step::Pass { .. }
            | Step::LimitFrom { .. }
            | Step::Point { .. }
            | Step::Beside { .. }
            | Step::Functions { .. } => return None,
            _ => self.contradiction(step)?,
        })
    }

    /// What is replaced and divided, and what that leaves.
    fn solved(
        &self,
        solved: &[kane_audit::Solved],
        divided: &[Atom],
        leaves: Sentence,
        is_idle: bool,
    ) -> Sentence {
        let one = |given: &kane_audit::Solved| {
            let equation = self
                .pen
                .write(|f| f.compared(&f.symbol(given.variable), "=", &f.ratio(&given.value)));
            match given.source {
                Some(source) => equation.and(Sentence::of("by")).and(self.source(source)),
                None => equation,
            }
        };
        let substitute =
            || Sentence::of("Substitute").and(Sentence::list(solved.iter().map(one).collect()));
        let divided = || Sentence::of("Divided by").and(self.atoms(divided)).end(",");
        match (solved.is_empty(), is_idle) {
            (true, true) => Sentence::of("What is left holds"),
            (false, true) => substitute(),
            (true, false) => divided().and(Sentence::of("this leaves")).and(leaves),
            (false, false) => substitute().end(".").and(Sentence::of("This leaves")).and(leaves),
        }
    }

    /// What is left or assumed, and what is wrong with it, in one sentence.
    fn contradicted(&self, step: &Step, next: &Step) -> Option<Sentence> {
        let (told, left) = match step {
            Step::Solve { solved, divided, leaves } => match &leaves[..] {
                [left] => (self.solved(solved, divided, self.atom(left), false), left),
                _ => return None,
            },
            Step::Assume { source, atoms } => match &atoms[..] {
                [left] => (self.source(*source).end(":").begun().and(self.atom(left)), left),
                _ => return None,
            },
            _ => return None,
        };
        Some(match next {
            Step::Absurd(atom) if atom == left => told.end(", which is false."),
            Step::Factors { atom, factors } if atom == left => {
                let why = self.against(factors.iter().map(|f| &f.0));
                told.end(", which contradicts").and(why).end(".")
            }
            Step::SignsOfCoefficients { atom, bounds, ranges, sum } if atom == left => {
                told.end(", which").and(self.signs_of(bounds, *ranges, sum.as_ref()))
            }
            Step::Clash(atoms) if atoms.contains(left) => {
                let others = atoms.iter().filter(|atom| *atom != left);
                told.end(", which contradicts").and(self.against(others)).end(".")
            }
            _ => return None,
        })
    }

    /// `contradicts` these bounds, and in which way.
    fn signs_of(
        &self,
        bounds: &[Atom],
        ranges: bool,
        sum: Option<&kane_audit::BoundedSum>,
    ) -> Sentence {
        let mut all: Vec<Sentence> = bounds.iter().map(|bound| self.atom(bound)).collect();
        if ranges {
            let also = if all.is_empty() { "the ranges of its symbols" } else { "and ranges" };
            all.push(Sentence::of(also));
        }
        let told = Sentence::of("contradicts").and(Sentence::list(all));
        let Some(sum) = sum else {
            return told.end(": all its terms have the other sign.");
        };
        let terms = sum.terms.iter().map(|(w, by)| self.pen.write(|f| f.product(w, by)));
        let what = if sum.scale == 1.into() {
            ": its sides differ by".to_owned()
        } else {
            format!(": {} times the difference of its sides is", sum.scale)
        };
        told.end(&what).and(Sentence::joined(terms.collect(), " +")).end(".")
    }

    /// Why a branch ends.
    fn contradiction(&self, step: &Step) -> Option<Sentence> {
        Some(match step {
            Step::Absurd(atom) => self.pen.write(|f| format!("{} is false.", f.atom(atom))),
            Step::Factors { atom, factors } => {
                let told = self.atom(atom).and(Sentence::of("contradicts"));
                told.and(self.against(factors.iter().map(|f| &f.0))).end(".")
            }
            Step::Clash(atoms) => {
                let (last, first) = atoms.split_last()?;
                let what = if first.len() == 1 { "contradicts" } else { "contradict" };
                self.against(first.iter()).and(Sentence::of(what)).and(self.atom(last)).end(".")
            }
            Step::Multiple { atom: (weight, poly), multiples } => {
                let not_zero = self.pen.write(|f| {
                    let told = match *weight == 1.into() {
                        true => f.poly(poly),
                        false => f.product(weight, &[(poly.clone(), 1)]),
                    };
                    f.compared(&told, "=", "").trim_end().to_owned()
                });
                let multiple = |(by, p): &(kane_kernel::Poly, kane_kernel::Poly)| {
                    self.pen.write(|f| match by.as_constant() {
                        Some(c) if c == 1.into() => format!("[{}]", f.poly(p)),
                        _ => format!("{}{}[{}]", f.in_parentheses(by), f.times(), f.poly(p)),
                    })
                };
                let sum = Sentence::joined(multiples.iter().map(multiple).collect(), " +");
                let why = match multiples.len() {
                    1 => "is 0, since the bracket is, though it is not.",
                    _ => "is 0, since the brackets are, though it is not.",
                };
                not_zero.and(sum).and(Sentence::of(why))
            }
            Step::Equal { sides: _, value } => {
                let told = Sentence::of("Both sides of the claim are");
                told.and(self.pen.write(|f| f.ratio(value))).end(".")
            }
            Step::Positive { terms, multiples } if terms.len() + multiples.len() > MOST_TERMS => {
                let products = terms.len() + multiples.len();
                let what = format!(
                    "A sum of {products} products, which the certificate lists, is 0 identically, but no term is \
                     negative, and one is positive."
                );
                Sentence::of(&what)
            }
            Step::Positive { terms, multiples } => {
                let summand = |t| self.pen.write(|f| f.summand(t));
                let mut parts: Vec<Sentence> = terms.iter().map(summand).collect();
                parts.extend(multiples.iter().map(|(c, p)| {
                    self.pen
                        .write(|f| format!("{}{}[{}]", f.in_parentheses(c), f.times(), f.poly(p)))
                }));
                let zero = self.pen.write(|f| f.number(&num_rational::BigRational::zero()));
                let brackets = if multiples.is_empty() { "" } else { "; brackets vanish" };
                let why =
                    format!("identically, but no term is negative, and one is positive{brackets}.");
                let sum = Sentence::joined(parts, " +").and(Sentence::of("is"));
                sum.and(zero).and(Sentence::of(&why))
            }
            Step::SignsOfCoefficients { atom, bounds, ranges, sum } => {
                self.atom(atom).and(self.signs_of(bounds, *ranges, sum.as_ref()))
            }
            Step::SignTable { variable, cuts, atoms } => {
                let line = self.pen.write(|f| format!("On the line of {},", f.symbol(*variable)));
                let cut = |cut: &Root| self.pen.write(|f| root(f, cut));
                let cuts = match &cuts[..] {
                    [] => Sentence::of("without a root,"),
                    cuts => {
                        let cuts = Sentence::list(cuts.iter().map(cut).collect());
                        Sentence::of("cut at").and(cuts).end(",")
                    }
                };
                let told = line.and(cuts).and(Sentence::of("no part satisfies"));
                told.and(self.atoms(atoms)).end(".")
            }
            _ => return None,
        })
    }

    /// What something contradicts.
    pub(super) fn against<'s>(&self, atoms: impl Iterator<Item = &'s Atom>) -> Sentence {
        let mut told: Vec<Sentence> = Vec::new();
        for atom in atoms {
            let one = self.atom(atom);
            if !told.contains(&one) {
                told.push(one);
            }
        }
        if told.is_empty() { Sentence::of("itself") } else { Sentence::list(told) }
    }

    pub(super) fn atom(&self, atom: &Atom) -> Sentence {
        self.pen.write(|f| f.atom(atom))
    }

    /// What all of these say.
    pub(super) fn atoms(&self, atoms: &[Atom]) -> Sentence {
        if atoms.is_empty() {
            return Sentence::of("nothing more");
        }
        let said = atoms.iter().filter(|a| !atoms.iter().any(|b| says_more(b, a)));
        Sentence::list(said.map(|a| self.atom(a)).collect())
    }

    /// What a formula stands for.
    pub(super) fn source(&self, source: Source) -> Sentence {
        self.pen.write(|f| {
            let label = |h: usize| self.labels.get(h).map(|label| f.words(label));
            match source {
                Source::Hypothesis(h) => {
                    label(h).unwrap_or_else(|| "a given behind the cited claims".to_owned())
                }
                Source::Limit(h) => {
                    format!("the limit in {}", label(h).unwrap_or_else(|| "a given".to_owned()))
                }
                Source::Condition => "the condition of the claim".to_owned(),
                Source::Failure if self.no_value => "a side has no value".to_owned(),
                Source::Failure => "the claim fails".to_owned(),
            }
        })
    }
}

/// Whether a condition is that a polynomial is positive, and another that the same is not negative or not 0.
fn says_more(strict: &Atom, other: &Atom) -> bool {
    let (p, q) = (strict.poly.primitive().1, other.poly.primitive().1);
    strict.sign == Sign::Positive
        && match other.sign {
            Sign::NonNegative => p == q,
            Sign::NonZero => p == q || p == q.neg(),
            Sign::Zero | Sign::Positive => false,
        }
}
