//! The code of a law run on symbols, regime by regime.

use kane_impact::{Contact, Equation, Law, Outcome, RegimeOver, Relation as Sign};
use kane_kernel::{Expr, Hypothesis, Link, Poly, Rel, Relation, Sentence};
use kane_number::Number;
use num_bigint::BigInt;
use num_traits::{Signed, Zero};

use crate::setting::Symbolic;
use crate::visible::{Condition, Ranges, lowered, negated};

/// What the label of the premise says that a law accepts its outcome.
pub(crate) const ACCEPTED: &str = "accepted";
/// What the label of premises on a root says.
pub(crate) const ROOT: &str = "root";

/// A hypothesis with the name that explanations give it.
#[derive(Clone, Debug)]
pub struct Premise {
    /// what it is
    pub label: String,
    /// what it says
    pub hypothesis: Hypothesis,
}

impl Premise {
    /// «links hold where the conditions do».
    #[must_use]
    pub fn new(label: impl Into<String>, when: Vec<Relation>, link: Relation) -> Self {
        let sentence = Sentence { when, links: vec![Link::Relation(link)] };
        Self { label: label.into(), hypothesis: Hypothesis { sentence, given: true } }
    }

    /// Whether it is an equation.
    pub(super) fn is_equation(&self) -> bool {
        let of = |link: &Link| matches!(link, Link::Relation(Relation { rel: Rel::Eq, .. }));
        self.hypothesis.sentence.links.iter().any(of)
    }
}

/// A regime of a law at a contact in symbols: where it is taken, and what follows.
#[derive(Clone, Debug)]
pub struct Applied {
    /// its index among the law's regimes
    pub index: usize,
    /// its name
    pub name: &'static str,
    /// those of its guards that do not visibly hold
    pub guards: Vec<Relation>,
    /// its guards, the failure of the regimes before it, and what is known of the root
    pub premises: Vec<Premise>,
    /// what follows
    pub outcome: Outcome<Symbolic>,
    /// the quantity that must not be negative for the law to accept it
    pub acceptance: Option<Symbolic>,
    /// the root's symbol, interval and polynomial
    pub root: Option<RootOf>,
}

/// The root of a regime, in symbols.
#[derive(Clone, Debug)]
pub struct RootOf {
    /// its symbol
    pub symbol: usize,
    /// where the greatest root is meant
    pub between: (Symbolic, Symbolic),
    /// c₀, c₁, …
    pub coefficients: Vec<Symbolic>,
}

impl RootOf {
    /// The polynomial at a value.
    #[must_use]
    pub fn at(&self, x: &Symbolic) -> Symbolic {
        let terms = self.coefficients.iter().rev();
        terms.fold(Symbolic::zero(), |sum, c| sum * x + c)
    }

    /// l ≤ x ≤ u and the polynomial at x is zero; `None` if that is visibly impossible.
    #[must_use]
    pub fn premises(&self, x: &Symbolic, ranges: &Ranges) -> Option<Vec<Premise>> {
        let (lower, upper) = &self.between;
        let known =
            [(x.clone() - lower, Rel::Ge), (upper.clone() - x, Rel::Ge), (self.at(x), Rel::Eq)];
        let mut out = Vec::new();
        for (quantity, rel) in known {
            match ranges.condition(&quantity, rel) {
                Condition::Always => {}
                Condition::Never => return None,
                Condition::Where(relation) => out.push(Premise::new(ROOT, Vec::new(), relation)),
            }
        }
        Some(out)
    }

    /// The same value with x² put in above and below, where the root's equation is one in x² and the value
    /// has such a power.
    #[must_use]
    pub fn reduced(&self, value: &Symbolic) -> Option<Symbolic> {
        let [c, b, a] = &self.coefficients[..] else { return None };
        let (num, den) = value.fraction();
        if !b.is_zero() || num.degree(self.symbol).max(den.degree(self.symbol)) < 2 {
            return None;
        }
        let (x, square) = (Symbolic::symbol(self.symbol), -c.clone() / a);
        let put_in = |p: &Poly| {
            let terms = p.coefficients(self.symbol).into_iter().enumerate();
            terms.fold(Symbolic::zero(), |sum, (n, c)| {
                let even = (0..n / 2).fold(Symbolic::one(), |power, _| power * &square);
                let power = if n % 2 == 1 { even * &x } else { even };
                sum + whole(&c) * power
            })
        };
        put_in(&num).checked_div(&put_in(&den))
    }

    /// The roots that are rational functions, of a polynomial of degree two whose discriminant is a square.
    #[must_use]
    pub fn rational(&self) -> Vec<Symbolic> {
        let [c, b, a] = &self.coefficients[..] else { return Vec::new() };
        let four = Symbolic::one().double().double();
        let discriminant = b.square() - four * a * c;
        let (Some(root), false) = (square_root(&discriminant), a.is_zero()) else {
            return Vec::new();
        };
        let half = |sum: Symbolic| sum / a.double();
        vec![half(root.clone() - b), half(-(root + b))]
    }
}

/// The sign that a guard asks for, as a comparison with zero.
#[must_use]
pub fn rel(sign: Sign) -> Rel {
    match sign {
        Sign::Positive => Rel::Gt,
        Sign::NotNegative => Rel::Ge,
        Sign::Zero => Rel::Eq,
        Sign::NotPositive => Rel::Le,
        Sign::Negative => Rel::Lt,
    }
}

/// The guards of a regime that do not visibly hold; `None` if one visibly fails.
fn guards(
    regime: &dyn RegimeOver<Symbolic>,
    contact: &Contact<Symbolic>,
    ranges: &Ranges,
) -> Option<Vec<Relation>> {
    let mut out = Vec::new();
    for (quantity, sign) in regime.guards(contact) {
        match ranges.condition(&quantity, rel(sign)) {
            Condition::Always => {}
            Condition::Never => return None,
            Condition::Where(relation) => out.push(relation),
        }
    }
    Some(out)
}

/// A law's regimes at a contact in symbols, those that are visibly never taken left out; and what
/// holds where none is taken, if that may be anywhere.
#[must_use]
pub fn apply(
    law: &Law,
    contact: &Contact<Symbolic>,
    ranges: &Ranges,
    root: usize,
) -> (Vec<Applied>, Option<Vec<Premise>>) {
    let all = 0..law.symbolic().regimes().len();
    apply_some(law, contact, ranges, root, all)
}

/// The same for some of its regimes, without those after them.
pub(super) fn apply_some(
    law: &Law,
    contact: &Contact<Symbolic>,
    ranges: &Ranges,
    root: usize,
    wanted: std::ops::Range<usize>,
) -> (Vec<Applied>, Option<Vec<Premise>>) {
    let mut out = Vec::new();
    let mut passed: Vec<Premise> = Vec::new();
    for (index, regime) in law.symbolic().regimes().iter().enumerate().take(wanted.end) {
        let Some(mine) = guards(&**regime, contact, ranges) else { continue };
        let label = |what: &str| format!("{what} \"{}\"", regime.name());
        let premises = || -> Vec<Premise> {
            let own = mine.iter().map(|g| Premise::new(label("guard of"), Vec::new(), g.clone()));
            own.chain(passed.iter().cloned()).collect()
        };
        if wanted.contains(&index)
            && let Some(applied) = one(law, &**regime, contact, ranges, (index, root), premises())
        {
            out.push(Applied { guards: mine.clone(), ..applied });
        }
        let Some((last, others)) = mine.split_last() else { return (out, None) };
        passed.push(Premise::new(label("passed over:"), others.to_vec(), negated(last)));
    }
    (out, Some(passed))
}

fn one(
    law: &Law,
    regime: &dyn RegimeOver<Symbolic>,
    contact: &Contact<Symbolic>,
    ranges: &Ranges,
    (index, symbol): (usize, usize),
    mut premises: Vec<Premise>,
) -> Option<Applied> {
    let x = Symbolic::symbol(symbol);
    let root = regime.equation(contact).map(|Equation { coefficients, between }| RootOf {
        symbol,
        between,
        coefficients,
    });
    if let Some(root) = &root {
        premises.extend(root.premises(&x, ranges)?);
    }
    let outcome = regime.outcome(contact, &x);
    let acceptance = law.symbolic().acceptance(contact, &outcome.impulse);
    if let Some(quantity) = &acceptance {
        match ranges.condition(quantity, Rel::Ge) {
            Condition::Always => {}
            Condition::Never => return None,
            Condition::Where(relation) => {
                premises.push(Premise::new(ACCEPTED, Vec::new(), relation));
            }
        }
    }
    Some(Applied {
        index,
        name: regime.name(),
        guards: Vec::new(),
        premises,
        outcome,
        acceptance,
        root,
    })
}

/// The same regime with its root replaced by a value.
#[must_use]
pub(super) fn with_root(
    law: &Law,
    contact: &Contact<Symbolic>,
    applied: &Applied,
    value: &Symbolic,
) -> Outcome<Symbolic> {
    law.symbolic().regimes()[applied.index].outcome(contact, value)
}

fn whole(p: &Poly) -> Symbolic {
    Symbolic::new(p, &Poly::one()).expect("1 is not zero")
}

/// s with s² = f and a positive first coefficient, if there is one.
fn square_root(f: &Symbolic) -> Option<Symbolic> {
    let (num, den) = f.fraction();
    Symbolic::new(&root_of_polynomial(&num)?, &root_of_polynomial(&den)?)
}

/// By the first coefficient and one term after another: s² + 2·s·t + … = p.
fn root_of_polynomial(p: &Poly) -> Option<Poly> {
    let first = |p: &Poly| p.terms().next_back_term();
    let Some((monomial, coefficient)) = first(p) else { return Some(Poly::default()) };
    if coefficient.is_negative() || monomial.iter().any(|(_, n)| n % 2 == 1) {
        return None;
    }
    let root = coefficient.sqrt();
    if &root * &root != coefficient {
        return None;
    }
    let half = monomial.iter().map(|&(v, n)| (v, n / 2)).collect();
    let lead = Poly::term(half, root);
    let (of_lead, twice) = first(&lead).map(|(m, c)| (m, c * 2))?;
    let mut sum = lead;
    let fuel = kane_kernel::Fuel::new(1_000_000);
    for _ in 0..p.len() {
        let rest = p.sub(&sum.mul(&sum, &fuel).ok()?);
        let Some((m, c)) = first(&rest) else { return Some(sum) };
        let divides = of_lead.iter().all(|&(v, n)| kane_kernel::exponent(&m, v) >= n);
        if !divides || &twice * (&c / &twice) != c {
            return None;
        }
        sum = sum.add(&lowered(&Poly::term(m, c / &twice), &of_lead));
    }
    let rest = p.sub(&sum.mul(&sum, &fuel).ok()?);
    rest.is_empty().then_some(sum)
}

trait LastTerm {
    fn next_back_term(self) -> Option<(kane_kernel::Monomial, BigInt)>;
}

impl<'a, I: Iterator<Item = (&'a [kane_kernel::Power], &'a BigInt)>> LastTerm for I {
    fn next_back_term(self) -> Option<(kane_kernel::Monomial, BigInt)> {
        // by total degree, then as listed: a term order, so that the first term of a square is a square
        let degree = |m: &[kane_kernel::Power]| m.iter().map(|x| x.1).sum::<u32>();
        self.filter(|(_, c)| !c.is_zero())
            .max_by_key(|(m, _)| (degree(m), dense(m)))
            .map(|(m, c)| (m.to_vec(), c.clone()))
    }
}

/// The exponents of all symbols, so that they compare lexicographically.
fn dense(m: &[kane_kernel::Power]) -> Vec<u32> {
    let top = m.last().map_or(0, |x| x.0 + 1);
    (0..top).map(|v| kane_kernel::exponent(m, v)).collect()
}

/// An equation or inequality between expressions in symbols.
#[must_use]
pub fn compare(lhs: &Symbolic, rel: Rel, rhs: &Symbolic) -> Relation {
    Relation { lhs: lhs.to_expr(), rel, rhs: rhs.to_expr() }
}

/// 0 < 0, which follows from nothing but a contradiction.
#[must_use]
pub fn absurd() -> Relation {
    Relation { lhs: Expr::int(1), rel: Rel::Lt, rhs: Expr::int(0) }
}
