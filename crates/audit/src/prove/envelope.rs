//! Roots between polynomials in t whose coefficients are fractions in symbols, and the signs that follow for small t > 0.
//!
//! A root s is enclosed by polynomials in t that its series gives. With s = low + g, 0 < g < width, what is left of an
//! inequality is a polynomial in t and small quantities, whose first power of t decides its sign: that is written out as a
//! sum of products. Nothing is searched for.

use std::cell::RefCell;

use kane_algebra::ring::cancelled;
use kane_kernel::{Atom, Expr, Poly, Sign, State};
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_rational::BigRational;
use num_traits::{One as _, Zero as _};

use super::ground::{Enclosed, Equation, Ground, Shown, add};
use super::nearness::{Cut, Nearness, Places};
use super::series::{Along, Numbers as _, Value};
use super::summands::{Signs, Sum, Summand, closed, common_powers, over};
use super::symbols::{Quotient, Symbols, polynomial};
use super::variation::roots;
use crate::argument::Argument;

/// Steps that the polynomials of one case may take.
const FUEL: u64 = 2_000_000;

/// Series of what varies, of which roots that are no numbers in the statement are estimates, and series without these.
pub(super) type Both<'b, 'a, 's, 'g> = [&'b Along<'a, 'g, Symbols<'a, 's, 'g>>; 2];

/// Coefficients of polynomials in t below and above a root times a power of t.
struct Beside {
    low: Vec<Quotient>,
    high: Vec<Quotient>,
    shift: u32,
}

/// A scaled root σ with its equation: square·(β·s² − γ) = β·σ² − radicand, where the sign is that of the equation's atom.
struct Around {
    equation: Equation,
    /// that the root is not negative
    root_atom: usize,
    scale: Poly,
    of_scale: Sum,
    scaled: Poly,
    square: Poly,
    radicand: Poly,
    of_beta: Shown,
}

/// A case along a germ, with the series of what varies there.
pub(super) struct Envelope<'a, 's, 'g> {
    pub(super) state: &'a State<'s, 'g>,
    /// series, of which roots that are no numbers here are estimates
    pub(super) along: &'a Along<'a, 'g, Symbols<'a, 's, 'g>>,
    /// the same without estimates
    exact: &'a Along<'a, 'g, Symbols<'a, 's, 'g>>,
    pub(super) ground: Ground<'a>,
    /// terms of a root's series that its enclosure has
    terms: u32,
    /// that roots of constants are positive
    cuts: Vec<Cut>,
}

impl<'a, 's, 'g> Envelope<'a, 's, 'g> {
    /// Of the atoms of a germ, which end before those of a case, the last three are 0 < t, t < radius and x.
    pub(super) fn new(
        state: &'a State<'s, 'g>,
        [along, exact]: Both<'a, 'a, 's, 'g>,
        (nearness, is_near): (&'a RefCell<Nearness>, bool),
        (before, terms): (usize, u32),
    ) -> Option<Self> {
        let t_atom = before.checked_sub(3)?;
        let t = state.scope.germ();
        let places = Places { t, t_atom, radius_atom: t_atom + 1, first: state.atoms.len() };
        let fuel = state.scope.fuel.beside(FUEL);
        let ground = Ground::new(Signs::new(state), (nearness, is_near), fuel, places);
        let mut out = Self { state, along, exact, ground, terms, cuts: Vec::new() };
        out.ground.binding = Some(out.equation(t_atom + 2, along.side.var, 1)?);
        for root in roots(state.scope) {
            let Some(equation) = out.of_root(root) else { continue };
            let mut vars = equation.beta.vars();
            vars.extend(equation.gamma.vars());
            if !vars.iter().all(|&v| out.is_constant(v)) || equation.of_beta.is_empty() {
                continue;
            }
            if let Some(cut) = out.root_is_positive(&equation) {
                out.cuts.push(cut);
                out.ground.signs.add(Atom::new(Poly::var(root), Sign::Positive));
                out.ground.places.first += 1;
            }
            out.ground.constants.push(equation);
        }
        Some(out)
    }

    fn is_constant(&self, v: usize) -> bool {
        let root = |e: &Equation| e.var == v;
        self.state.is_constant(v, self.along.side.var) || self.ground.constants.iter().any(root)
    }

    /// An atom as an equation for a power of a variable whose coefficient is positive.
    fn equation(&self, atom: usize, var: usize, period: u32) -> Option<Equation> {
        let poly = &self.state.atoms[atom].poly;
        let (beta, gamma) = (poly.coefficient(var, period), poly.coefficient(var, 0).neg());
        let whole = beta.mul(&Poly::power(var, period), &self.ground.fuel).ok()?.sub(&gamma);
        if whole != *poly {
            return None;
        }
        let plain = [beta.clone(), beta.neg()].map(|p| self.ground.signs.positive(&p));
        let (is_opposite, of_beta) = match plain {
            [Some(sum), _] => (false, sum),
            [_, Some(sum)] => (true, sum),
            // it varies
            _ => (!self.sign(&beta)?, Sum::new()),
        };
        let (beta, gamma) = if is_opposite { (beta.neg(), gamma.neg()) } else { (beta, gamma) };
        Some(Equation { atom, var, period, beta, of_beta, gamma, is_opposite })
    }

    /// What a root is the root of: the equation that a case has for its square.
    pub(super) fn of_root(&self, root: usize) -> Option<Equation> {
        let own = |a: &Atom| a.sign == Sign::Zero && a.poly.degree(root) == 2;
        let mut found = self.state.atoms.iter().enumerate().filter(|(_, a)| own(a));
        found.find_map(|(i, _)| self.equation(i, root, 2))
    }

    /// That a root is positive whose radicand plainly is.
    fn root_is_positive(&self, equation: &Equation) -> Option<Cut> {
        let Equation { atom, var, beta, gamma, is_opposite, .. } = equation;
        let root = Poly::var(*var);
        let here = self.ground.places.first;
        let s_atom = self.ground.signs.told(&root)?;
        let whole = Poly::constant(if *is_opposite { -BigInt::one() } else { BigInt::one() });
        let of_root = self.ground.mul(beta, &root)?.neg();
        let zero = closed(self.ground.signs.positive(gamma)?, [(*atom, whole), (here, of_root)]);
        let summand = |atom| unit(&[(atom, 1)]);
        Some((root, zero, closed(vec![summand(s_atom), summand(here)], [])))
    }

    /// Closes a case: its roots are enclosed, then one of its atoms has the wrong sign. Before the radius is known it is
    /// collected how near one has to be.
    pub(super) fn contradiction(mut self, before: usize) -> Option<Argument> {
        let absurd = self.state.atoms.iter().position(|a| a.decided() == Some(false));
        if let Some(atom) = absurd {
            return Some(Argument::Absurd(atom));
        }
        let mut cuts = std::mem::take(&mut self.cuts);
        let mut next = self.ground.places.first;
        if self.ground.is_near {
            let Ground { nearness, places, signs, fuel, .. } = &self.ground;
            let near = nearness.borrow().cuts((*places, signs), fuel)?;
            next += near.len();
            cuts.extend(near);
        }
        for root in self.varying_roots() {
            if let Some(both) = self.enclose(root, next) {
                cuts.extend(both);
                next += 2;
            }
        }
        let end = (before..self.state.atoms.len()).find_map(|i| self.wrong(i))?;
        let nest = |positive, (poly, zero, negative): Cut| {
            let [zero, positive, negative] = [zero, positive, negative].map(Box::new);
            Argument::Split { poly, zero, positive, negative }
        };
        Some(cuts.into_iter().rev().fold(end, nest))
    }

    /// Roots that depend on t.
    pub(super) fn varying_roots(&self) -> Vec<usize> {
        roots(self.state.scope).filter(|&root| !self.is_constant(root)).collect()
    }

    /// Polynomials in t around a root: what is positive, and why.
    fn enclose(&mut self, root: usize, next: usize) -> Option<[Cut; 2]> {
        // where a case says nothing of a root in the series, the rough ones may do
        self.between(root, self.beside(root)?, next).or_else(|| {
            let of_root = self.state.scope.root(root)?;
            self.between(root, self.rough(of_root)?, next)
        })
    }

    /// The same for polynomials with these coefficients.
    fn between(&mut self, root: usize, beside: Beside, next: usize) -> Option<[Cut; 2]> {
        let Beside { low, high, shift } = beside;
        // one denominator for all
        let coefficients: Vec<&Quotient> = low.iter().chain(&high).collect();
        let (_, scale) = polynomial(self.state, &coefficients)?;
        let whole = |coefficients: &[Quotient]| -> Option<Poly> {
            let mut sum = Poly::default();
            for (n, (num, den)) in (0..).zip(coefficients) {
                let (p, q) = cancelled(&self.ground.mul(num, &scale)?, den);
                let (content, p) = p.primitive();
                let (content, rest) = content.div_rem(&q.as_constant()?);
                let p = rest.is_zero().then(|| p.scale(&content))?;
                sum = sum.add(&self.ground.mul(&p, &Poly::power(self.ground.places.t, n))?);
            }
            Some(sum)
        };
        let (low, high) = (whole(&low)?, whole(&high)?);
        let around = self.around(root, &scale, shift)?;
        let (above, below) = (next, next + 1);
        let lower = self.lower(&around, &low, above)?;
        let upper = self.upper(&around, &high, below)?;
        let Around { equation, scale, of_scale, .. } = around;
        let width = high.sub(&low);
        self.ground.enclosed.push(Enclosed {
            root,
            equation,
            scale,
            of_scale,
            low,
            width,
            above,
            below,
        });
        Some([lower, upper])
    }

    /// Coefficients of polynomials between which a root lies near the end: of its series, or rough ones.
    fn beside(&self, root: usize) -> Option<Beside> {
        let of_root = self.state.scope.root(root)?;
        let Some(Value::Series(series)) = self.exact.value(of_root) else {
            return self.rough(of_root);
        };
        let numbers = &self.exact.numbers;
        let shift = u32::try_from((-series.low).max(0)).ok()?;
        let cut = u32::try_from(series.low + i64::from(shift)).ok()? + self.terms;
        let at = |n: u32| self.exact.coefficient(&series, i64::from(n) - i64::from(shift));
        let known = (0..cut).map(at).collect::<Option<Vec<_>>>()?;
        let (size, den) = numbers.majorant(&at(cut)?)?;
        let side = |by: i32| {
            let margin = (size.scale(&by.into()), den.clone());
            known.iter().cloned().chain([margin]).collect()
        };
        Some(Beside { low: side(-2), high: side(2), shift })
    }

    /// q/(1 + q) < √q < 1 + q for the first coefficient of a radicand whose root is no number here; of a rational one, three
    /// digits.
    fn rough(&self, of_root: &Expr) -> Option<Beside> {
        let Expr::Sqrt(radicand) = of_root else { return None };
        let Value::Series(series) = self.exact.value(radicand)? else { return None };
        let numbers = &self.exact.numbers;
        let q = &series.coefficients[0];
        if series.low % 2 != 0 || numbers.is_positive(q) != Some(true) {
            return None;
        }
        let (low, high) = numbers.around_root(q)?;
        let half = series.low / 2;
        let shift = u32::try_from((-half).max(0)).ok()?;
        let nothing = numbers.number(&BigRational::zero());
        let before = usize::try_from(half + i64::from(shift)).ok()?;
        let side = |c: Quotient| [vec![nothing.clone(); before], vec![c]].concat();
        Some(Beside { low: side(low), high: side(high), shift })
    }

    /// A root times a polynomial in constants and a power of t.
    fn around(&self, root: usize, scale: &Poly, shift: u32) -> Option<Around> {
        let equation = self.of_root(root)?;
        let root_atom = self.ground.signs.told(&Poly::var(root))?;
        let of_shift = [unit(&[(self.ground.places.t_atom, shift)])];
        let of_scale = self.ground.product(&self.ground.signs.positive(scale)?, &of_shift)?;
        let scale = self.ground.mul(scale, &Poly::power(self.ground.places.t, shift))?;
        let scaled = self.ground.mul(&scale, &Poly::var(root))?;
        let square = self.ground.mul(&scale, &scale)?;
        let radicand = self.ground.mul(&square, &equation.gamma)?;
        let of_beta = self.ground.positive(&equation.beta)?;
        let square = if equation.is_opposite { square.neg() } else { square };
        Some(Around { equation, root_atom, scale, of_scale, scaled, square, radicand, of_beta })
    }

    /// The lower polynomial l: where σ ≤ l, for a root σ with β·σ² = ρ, ρ − β·l² is positive, and −β·(l − σ)·(l + σ).
    fn lower(&self, around: &Around, low: &Poly, here: usize) -> Option<Cut> {
        let Around { equation, scaled, square, radicand, of_beta, .. } = around;
        let (beta, q) = (&equation.beta, equation.atom);
        let gap = self.ground.positive(&radicand.sub(&self.ground.triple(low, low, beta)?))?;
        let g = scaled.sub(low);

        let mut cofactors = gap.cofactors.clone();
        add(&mut cofactors, q, &self.ground.mul(&gap.scale, square)?);
        add(&mut cofactors, here, &self.ground.triple(&gap.scale, beta, &low.add(scaled))?.neg());
        let zero = closed(gap.products.clone(), cofactors);

        // with k = l − σ > 0, β·(k² + 2·k·σ) takes the place of β·(l − σ)·(l + σ)
        let k = g.neg();
        let of_gap = self.ground.product(&gap.of_scale, &of_beta.products)?;
        let mut sum = self.ground.product(&of_beta.of_scale, &gap.products)?;
        sum.extend(self.ground.product(&of_gap, &[unit(&[(here, 2)])])?);
        let two = Summand::new(BigRational::from_integer(2.into()), &[]);
        let twice = self.ground.product(&of_gap, &[two])?;
        sum.extend(self.ground.product(&twice, &self.of_root_times(around, here)?)?);
        let mut cofactors = self.ground.times(&gap.cofactors, &of_beta.scale)?;
        let by = self.ground.triple(&gap.scale, &k, &k.add(&scaled.scale(&2.into())))?;
        for (i, c) in self.ground.times(&of_beta.cofactors, &by)? {
            add(&mut cofactors, i, &c);
        }
        add(&mut cofactors, q, &self.ground.triple(&gap.scale, &of_beta.scale, square)?);
        Some((g, zero, closed(sum, cofactors)))
    }

    /// The upper polynomial h, which is positive: where σ ≥ h, β·h² − ρ is positive, and −β·(σ − h)·(σ + h).
    fn upper(&self, around: &Around, high: &Poly, here: usize) -> Option<Cut> {
        let Around { equation, scaled, square, radicand, of_beta, .. } = around;
        let (beta, q) = (&equation.beta, equation.atom);
        let gap = self.ground.positive(&self.ground.triple(high, high, beta)?.sub(radicand))?;
        let h = high.sub(scaled);

        let mut cofactors = gap.cofactors.clone();
        add(&mut cofactors, q, &self.ground.mul(&gap.scale, square)?.neg());
        add(&mut cofactors, here, &self.ground.triple(&gap.scale, beta, &high.add(scaled))?.neg());
        let zero = closed(gap.products.clone(), cofactors);

        let of_high = self.ground.positive(high)?;
        let lead = self.ground.mul(&of_high.scale, &of_beta.scale)?;
        let of_lead = self.ground.product(&of_high.of_scale, &of_beta.of_scale)?;
        let of_gap = self.ground.product(&gap.of_scale, &of_beta.products)?;
        let mut sum = self.ground.product(&of_lead, &gap.products)?;
        let with_root = self.ground.product(&of_gap, &of_high.of_scale)?;
        sum.extend(self.ground.product(&with_root, &self.of_root_times(around, here)?)?);
        let with_high = self.ground.product(&of_gap, &of_high.products)?;
        sum.extend(self.ground.product(&with_high, &[unit(&[(here, 1)])])?);
        let k = h.neg();
        let mut cofactors = self.ground.times(&gap.cofactors, &lead)?;
        let by = self.ground.triple(
            &gap.scale,
            &of_high.scale,
            &self.ground.mul(&scaled.add(high), &k)?,
        )?;
        for (i, c) in self.ground.times(&of_beta.cofactors, &by)? {
            add(&mut cofactors, i, &c);
        }
        // the product of two sums and their cofactors is β·h times what scales them
        let by = self.ground.mul(&gap.scale, &k)?;
        let of_sum = self.ground.mul(&of_beta.scale, beta)?;
        for (j, b) in self.ground.times(&of_high.cofactors, &by)? {
            let mut of_products = of_sum.clone();
            for (i, c) in &of_beta.cofactors {
                of_products = of_products.sub(&self.ground.mul(c, &self.state.atoms[*i].poly)?);
            }
            add(&mut cofactors, j, &self.ground.mul(&b, &of_products)?);
        }
        add(&mut cofactors, q, &self.ground.triple(&gap.scale, &lead, square)?.neg());
        Some((h, zero, closed(sum, cofactors)))
    }

    /// The scaled root times an atom.
    fn of_root_times(&self, around: &Around, atom: usize) -> Option<Sum> {
        self.ground.product(&around.of_scale, &[unit(&[(around.root_atom, 1), (atom, 1)])])
    }

    /// The contradiction in an atom whose polynomial has another sign for small t.
    fn wrong(&self, atom: usize) -> Option<Argument> {
        let Atom { poly, sign } = &self.state.atoms[atom];
        let Value::Series(series) = self.along.polynomial(poly)? else { return None };
        let is_positive = self.along.numbers.is_positive(&series.coefficients[0]);
        let is_positive = match sign {
            Sign::NonZero => return None,
            Sign::Zero => is_positive?,
            // that it has this sign is what is to be excluded, even if the series does not tell
            Sign::NonNegative | Sign::Positive if is_positive == Some(true) => return None,
            Sign::NonNegative | Sign::Positive => false,
        };
        let shown = if is_positive { poly.clone() } else { poly.neg() };
        self.by_enclosures(atom, &shown).or_else(|| self.by_conjugate(atom, &shown))
    }

    /// The same for what is positive, with each root in it between polynomials.
    fn by_enclosures(&self, atom: usize, shown: &Poly) -> Option<Argument> {
        let Atom { poly, sign } = &self.state.atoms[atom];
        let is_positive = shown == poly;
        // enclosed, a root that all terms have would be subtracted from itself; where the atom is strict it may be 0
        let mut common = common_powers(shown);
        let is_root = |v: usize| self.ground.enclosed.iter().any(|e| e.root == v);
        let serves = |atom| *sign == Sign::Positive || self.ground.signs.is_strict(atom);
        common.retain(|power| {
            is_root(power.0) && self.ground.signs.told(&Poly::var(power.0)).is_some_and(serves)
        });
        let factor = [self.ground.signs.monomial(BigRational::one(), &common)?];
        let Shown { scale, of_scale, products, cofactors, .. } =
            self.ground.positive(&over(shown, &common))?;
        let mut products = self.ground.product(&products, &factor)?;
        let mut cofactors = self.ground.times(&cofactors, &Poly::term(common, BigInt::one()))?;
        if *sign == Sign::Zero {
            add(&mut cofactors, atom, &if is_positive { scale.neg() } else { scale });
        } else {
            let once = [unit(&[(atom, 1)])];
            products.extend(self.ground.product(&of_scale, &once)?);
        }
        Some(closed(products, cofactors))
    }
}

/// A product of powers of atoms.
pub(super) fn unit(factors: &[(usize, u32)]) -> Summand {
    Summand::new(BigRational::one(), factors)
}
