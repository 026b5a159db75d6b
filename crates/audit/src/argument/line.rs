//! Sign tables as cases: the line is cut at rational points, and what is left between them is read
//! off the signs of coefficients.

use kane_kernel::{Poly, Root, Sign, sign, sign_at};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::Factored;
use super::expand::{Work, absurd, at};
use super::identity::Reducer;
use super::node::{Known, Node, Sum, whole};
use super::orthant::{Range, Signs, bound_of};
use super::rules::{Flaw, Step};

/// A sign table of atoms in one variable.
pub(super) struct Line<'a> {
    pub(super) work: &'a Work<'a>,
    pub(super) var: usize,
    pub(super) bases: &'a [Vec<BigInt>],
    pub(super) roots: &'a [Root],
    pub(super) used: &'a [Factored],
}

/// An end of an interval: the point, and what says on which side of it we are.
type Cut = Option<(BigRational, Known)>;

impl Line<'_> {
    /// The proof.
    pub(super) fn close(&self, known: &[Known]) -> Step<Node> {
        for (i, ..) in self.used {
            if at(known, *i)?.atom.decided() == Some(false) {
                return absurd(at(known, *i)?, *i);
            }
        }
        // Bounds among the atoms themselves spare the cells behind them.
        let (mut left, mut right): (Cut, Cut) = (None, None);
        for (i, ..) in self.used {
            let atom = at(known, *i)?;
            let Some((value, lower)) = bound_of(atom, self.var) else {
                continue;
            };
            let strict = atom.atom.sign == Sign::Positive;
            let tighter = |cut: &Cut| {
                cut.as_ref().is_none_or(|(old, by)| {
                    let same = *old == value && strict && by.atom.sign != Sign::Positive;
                    same || if lower { value > *old } else { value < *old }
                })
            };
            let cut = if lower { &mut left } else { &mut right };
            if tighter(cut) {
                *cut = Some((value, atom.clone()));
            }
        }
        if let (Some((a, low)), Some((b, high))) = (&left, &right)
            && a >= b
        {
            return self.empty(known, low, high);
        }
        let inside = |r: &&Root| {
            let above = left.as_ref().is_none_or(|(a, _)| r.hi > *a);
            let below = right.as_ref().is_none_or(|(b, _)| r.lo < *b);
            // An interval around no root is a part of a gap.
            above && below && (r.is_exact() || self.bases.contains(&r.poly))
        };
        let roots: Vec<&Root> = self.roots.iter().filter(inside).collect();
        self.strict(known, left, |left| {
            self.strict(known, right.clone(), |right| match (&left, &right, &roots[..]) {
                (None, None, []) => {
                    let zero = BigRational::zero();
                    let below = |cut| self.gap(known, None, Some(cut));
                    self.cut(known, &zero, below, |cut| self.gap(known, Some(cut), None))
                }
                _ => self.from(known, &roots, left.clone(), &right),
            })
        })
    }

    /// A bound, with a case for the point itself if that belongs to the region.
    fn strict(&self, known: &[Known], end: Cut, then: impl Fn(Cut) -> Step<Node>) -> Step<Node> {
        match end {
            Some((a, bound)) if bound.atom.sign != Sign::Positive => {
                self.beside(known, (&a, &bound), |cut| then(Some((a.clone(), cut))))
            }
            other => then(other),
        }
    }

    /// Strictly inside a bound, or at it.
    fn beside(
        &self,
        known: &[Known],
        (at, bound): (&BigRational, &Known),
        inside: impl FnOnce(Known) -> Step<Node>,
    ) -> Step<Node> {
        let poly = &bound.atom.poly;
        let zero = self.work.side(poly, (false, Sign::Zero), |z| self.point(known, at, &z))?;
        let positive = self.work.side(poly, (false, Sign::Positive), inside)?;
        let negative = self.work.side(poly, (true, Sign::Positive), |n| {
            let one = BigRational::one;
            Ok(Sum::default().product(one(), &[(&n, 1)]).product(one(), &[(bound, 1)]).close())
        })?;
        Ok(Node::split(poly.clone(), vec![zero, positive, negative]))
    }

    /// Bounds that leave a point or nothing.
    fn empty(&self, known: &[Known], low: &Known, high: &Known) -> Step<Node> {
        let bounds = [Range::new(self.var, Some(low), None)?];
        let signs = Signs::new(high, (&[], &high.atom.poly), &bounds, &self.work.fuel);
        if let Ok(node) = signs.and_then(|s| s.close(self.work)) {
            return Ok(node);
        }
        // Both belong to the region, and they are the same point.
        let Some((value, _)) = bound_of(low, self.var) else {
            return Err(Flaw::NotABound(self.var));
        };
        self.beside(known, (&value, low), |above| {
            let bounds = [Range::new(self.var, Some(&above), None)?];
            Signs::new(high, (&[], &high.atom.poly), &bounds, &self.work.fuel)?.close(self.work)
        })
    }

    /// What is right of a cut, from the first of these roots on.
    fn from(&self, known: &[Known], roots: &[&Root], left: Cut, right: &Cut) -> Step<Node> {
        let Some((root, rest)) = roots.split_first() else {
            return self.gap(known, left, right.clone());
        };
        if left.as_ref().is_some_and(|(a, _)| *a >= root.lo) {
            return self.root(known, (root, rest), left, right);
        }
        let before = left.clone();
        self.cut(
            known,
            &root.lo,
            |cut| self.gap(known, before, Some(cut)),
            |cut| {
                if root.is_exact() {
                    self.from(known, rest, Some(cut), right)
                } else {
                    self.root(known, (root, rest), Some(cut), right)
                }
            },
        )
    }

    /// Right of the left end of the interval of an irrational root.
    fn root(
        &self,
        known: &[Known],
        (root, rest): (&Root, &[&Root]),
        left: Cut,
        right: &Cut,
    ) -> Step<Node> {
        if right.as_ref().is_some_and(|(b, _)| *b <= root.hi) {
            return self.inside(known, root, &left, right);
        }
        self.cut(
            known,
            &root.hi,
            |cut| self.inside(known, root, &left, &Some(cut)),
            |cut| self.from(known, rest, Some(cut), right),
        )
    }

    /// Cases at a rational point: there, all atoms are numbers.
    fn cut(
        &self,
        known: &[Known],
        at: &BigRational,
        below: impl FnOnce((BigRational, Known)) -> Step<Node>,
        above: impl FnOnce((BigRational, Known)) -> Step<Node>,
    ) -> Step<Node> {
        let poly = Poly::in_variable(self.var, &[-at.numer(), at.denom().clone()]);
        let work = self.work;
        let zero = work.side(&poly, (false, Sign::Zero), |z| self.point(known, at, &z))?;
        let positive = work.side(&poly, (false, Sign::Positive), |cut| above((at.clone(), cut)))?;
        let negative = work.side(&poly, (true, Sign::Positive), |cut| below((at.clone(), cut)))?;
        Ok(Node::split(poly, vec![zero, positive, negative]))
    }

    /// An atom that does not hold at a rational point, given by an equation.
    fn point(&self, known: &[Known], at: &BigRational, zero: &Known) -> Step<Node> {
        let signs: Vec<i8> = self.bases.iter().map(|p| sign_at(p, at)).collect();
        let (i, ..) = self.violated(known, &signs)?;
        let reducer = Reducer::new(zero, self.var, &[], &self.work.fuel)?;
        let derived = reducer.derived(&known[*i], self.work.fresh(), &self.work.fuel)?;
        derived.ok_or(Flaw::OpenCell)?.absurd(&self.work.fuel)?.ok_or(Flaw::OpenCell)
    }

    /// An atom that does not hold where the bases have these signs.
    fn violated(&self, known: &[Known], signs: &[i8]) -> Step<&Factored> {
        let power = |(s, n): (&i8, &u32)| match n {
            0 => 1,
            n if n % 2 == 0 => s * s,
            _ => *s,
        };
        let holds = |(i, constant, powers): &Factored| {
            let whole = sign(constant.numer());
            let here = whole * signs.iter().zip(powers).map(power).product::<i8>();
            known[*i].atom.sign.admits(here)
        };
        // The shortest proof is that of the smallest degree.
        let degree = |a: &&Factored| known[a.0].atom.poly.degree(self.var);
        self.used.iter().filter(|a| !holds(a)).min_by_key(degree).ok_or(Flaw::OpenCell)
    }

    /// Between two cuts without a root between them.
    fn gap(&self, known: &[Known], left: Cut, right: Cut) -> Step<Node> {
        let one = BigRational::one();
        let inside = match (&left, &right) {
            (Some((a, _)), Some((b, _))) => (a + b) / (&one + &one),
            (Some((a, _)), None) => a + one,
            (None, Some((b, _))) => b - one,
            (None, None) => BigRational::zero(),
        };
        let signs: Vec<i8> = self.bases.iter().map(|p| sign_at(p, &inside)).collect();
        let (i, ..) = self.violated(known, &signs)?;
        let target = &known[*i];
        self.signs((target, &BigInt::one()), (&[], &target.atom.poly), &left, &right)
    }

    /// An atom of which a multiple is the product of `factors` and `rest`, contradicted by the signs
    /// of coefficients between two cuts.
    fn signs(
        &self,
        (target, times): (&Known, &BigInt),
        (factors, rest): (&[(Known, u32)], &Poly),
        left: &Cut,
        right: &Cut,
    ) -> Step<Node> {
        let (low, high) = (left.as_ref().map(|c| &c.1), right.as_ref().map(|c| &c.1));
        // One bound may be enough.
        let mut best: Option<Node> = None;
        for (low, high) in [(low, None), (None, high), (low, high)] {
            if best.is_some() || (low.is_none() && high.is_none()) {
                continue;
            }
            let bounds = [Range::new(self.var, low, high)?];
            let signs = Signs::new(target, (factors, rest), &bounds, &self.work.fuel);
            best = signs.and_then(|s| s.times(times).close(self.work)).ok();
        }
        best.ok_or(Flaw::OpenCell)
    }

    /// Around an irrational root: at it, right of it and left of it.
    fn inside(&self, known: &[Known], root: &Root, left: &Cut, right: &Cut) -> Step<Node> {
        let base = self.bases.iter().position(|b| *b == root.poly).ok_or(Flaw::OpenCell)?;
        let poly = Poly::in_variable(self.var, &root.poly);
        let middle = (&root.lo + &root.hi) / BigRational::from_integer(2.into());
        let signs: Vec<i8> = self.bases.iter().map(|p| sign_at(p, &middle)).collect();
        let case = |here: i8| {
            let sign = if here == 0 { Sign::Zero } else { Sign::Positive };
            self.work.side(&poly, (here < 0, sign), |new| {
                let mut signs = signs.clone();
                signs[base] = here;
                let (i, constant, powers) = self.violated(known, &signs)?;
                let (n, target) = (powers[base], &known[*i]);
                if here == 0 && n > 0 {
                    let rest = self.rest(constant, powers, base, 1)?;
                    return self.at_root((target, constant.denom()), (&new, n), &rest);
                }
                let flip = here < 0 && n % 2 == 1;
                let rest = self.rest(constant, powers, base, if flip { -1 } else { 1 })?;
                let factors = if n > 0 { vec![(new, n)] } else { Vec::new() };
                self.signs((target, constant.denom()), (&factors, &rest), left, right)
            })
        };
        Ok(Node::split(poly.clone(), vec![case(0)?, case(1)?, case(-1)?]))
    }

    /// The product of all bases but one, with the constant.
    fn rest(
        &self,
        constant: &BigRational,
        powers: &[u32],
        without: usize,
        flip: i64,
    ) -> Step<Poly> {
        let fuel = &self.work.fuel;
        let mut out = Poly::constant(constant.numer() * flip);
        for (j, (b, n)) in self.bases.iter().zip(powers).enumerate() {
            if j != without {
                out = out.mul(&Poly::in_variable(self.var, b).pow(*n, fuel)?, fuel)?;
            }
        }
        Ok(out)
    }

    /// An atom > 0 or ≠ 0 of which a multiple is a multiple of what is zero.
    fn at_root(
        &self,
        (target, times): (&Known, &BigInt),
        (zero, n): (&Known, u32),
        rest: &Poly,
    ) -> Step<Node> {
        let fuel = &self.work.fuel;
        // d·P = zeroⁿ·rest, so d·Pᵉ − zero·(zeroⁿ⁻¹·rest·Pᵉ⁻¹) = 0.
        let e = if target.atom.sign == Sign::Positive { 1 } else { 2 };
        let cofactor = zero.atom.poly.pow(n - 1, fuel)?.mul(rest, fuel)?;
        let cofactor = cofactor.mul(&target.atom.poly.pow(e - 1, fuel)?, fuel)?;
        let mut sum = Sum::default();
        sum.product(whole(times.clone()), &[(target, e)]);
        sum.multiple(-whole(BigInt::one()), cofactor, zero);
        Ok(sum.close())
    }
}
