//! Derivatives: what an expression is near a point, and how fast that changes.
//!
//! Near a point an expression is one fraction, or it has no derivative there. Every condition that
//! says so is one on functions that are continuous at the point, and strict or free of what varies:
//! it holds in a neighbourhood if it holds at the point. So a derivative may be differentiated again
//! under the same conditions.

use crate::normal::{either, everywhere};
use crate::state::depends;
use crate::{Atom, Checked, Expr, Fraction, Piece, Poly, Rejection, Rel, Relation, Scope, Sign};

/// What is asked of an expression near a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Kind {
    /// that it has derivatives
    Smooth,
    /// that it is continuous
    Continuous,
}

/// An expression near a point.
#[derive(Clone, Debug)]
pub(crate) struct Local {
    value: Fraction,
    /// the roots in it: their variables and radicands
    roots: Vec<(usize, Fraction)>,
    /// whether it is only one of the sides of a kink, on which more than its value depends
    bent: bool,
}

/// The pieces of an expression near a point.
pub(crate) type Locals = Vec<Piece<Local>>;

/// Definitions inside definitions, followed at most this deep.
const MAX_DEPTH: usize = 64;

impl Local {
    fn of(value: Fraction, parts: &[&Self]) -> Vec<Piece<Self>> {
        let mut roots: Vec<(usize, Fraction)> = Vec::new();
        for (s, radicand) in parts.iter().flat_map(|part| &part.roots) {
            if !roots.iter().any(|known| known.0 == *s) {
                roots.push((*s, radicand.clone()));
            }
        }
        roots.sort_by_key(|root| root.0);
        let bent = parts.iter().any(|part| part.bent);
        everywhere(Some(Self { value, roots, bent }))
    }

    /// Whether it stays as it is while the variables vary near the point.
    fn is_free(&self, over: &[usize]) -> bool {
        !self.bent && !over.iter().any(|x| self.varies(&self.value, *x))
    }

    /// Whether a fraction in the same variables varies with x.
    fn varies(&self, f: &Fraction, x: usize) -> bool {
        let in_roots = |p: &Poly| {
            self.roots.iter().any(|(s, radicand)| p.degree(*s) > 0 && self.varies(radicand, x))
        };
        [&f.num, &f.den].into_iter().any(|p| p.degree(x) > 0 || in_roots(p))
    }

    /// Its derivative by x.
    fn slope(&self, x: usize, scope: &Scope<'_>) -> Checked<Fraction> {
        self.slope_of(&self.value, x, scope)
    }

    /// (n/d)′ = (n′·d − n·d′)/d²
    fn slope_of(&self, f: &Fraction, x: usize, scope: &Scope<'_>) -> Checked<Fraction> {
        let fuel = &scope.fuel;
        let top = self.slope_of_poly(&f.num, x, scope)?;
        let over = |den: Poly| Fraction { num: Poly::one(), den };
        if f.den.is_constant() {
            return top.mul(&over(f.den.clone()), fuel);
        }
        let bottom = self.slope_of_poly(&f.den, x, scope)?;
        let left = top.mul(&Fraction::whole(f.den.clone()), fuel)?;
        let right = Fraction::whole(f.num.clone()).mul(&bottom, fuel)?;
        left.add(&right.neg(), fuel)?.mul(&over(f.den.mul(&f.den, fuel)?), fuel)
    }

    /// ∂p/∂x + Σ ∂p/∂s·s′ with s′ = r′/(2s) for the root s of r.
    fn slope_of_poly(&self, p: &Poly, x: usize, scope: &Scope<'_>) -> Checked<Fraction> {
        let fuel = &scope.fuel;
        let mut sum = Fraction::whole(p.derivative(x, fuel)?);
        for (s, radicand) in self.roots.iter().filter(|root| p.degree(root.0) > 0) {
            if self.varies(radicand, x) {
                let half = Fraction { num: Poly::one(), den: Poly::var(*s).scale(&2.into()) };
                let slope = self.slope_of(radicand, x, scope)?.mul(&half, fuel)?;
                let part = Fraction::whole(p.derivative(*s, fuel)?).mul(&slope, fuel)?;
                sum = sum.add(&part, fuel)?;
            }
        }
        Ok(sum)
    }
}

impl Scope<'_> {
    /// The pieces of d f / d x: where f, x alone being varied, is one differentiable expression
    /// near the point, its derivative; elsewhere undefined.
    ///
    /// # Errors
    /// [`Rejection::NotExplicit`] if f contains an undefined function of x, or an expression stands
    /// for x; else as
    /// [`Scope::pieces`].
    pub fn slopes(&self, f: &Expr, x: usize) -> Checked<Vec<Piece>> {
        self.slopes_near(f, x, (&[], MAX_DEPTH), |slope, _| everywhere(Some(slope)))
    }

    fn slopes_near<T>(
        &self,
        f: &Expr,
        x: usize,
        (over, depth): (&[usize], usize),
        next: impl Fn(Fraction, &Local) -> Vec<Piece<T>>,
    ) -> Checked<Vec<Piece<T>>> {
        let mut wider = over.to_vec();
        if !wider.contains(&x) {
            wider.push(x);
            wider.sort_unstable();
        }
        let near = self.near(f, &wider, Kind::Smooth, depth)?;
        self.each(&near, |local| Ok(next(local.slope(x, self)?, local)))
    }

    /// The pieces of an expression near a point, the variables `over` being varied.
    fn near(&self, e: &Expr, over: &[usize], kind: Kind, depth: usize) -> Checked<Locals> {
        let fuel = &self.fuel;
        fuel.spend(1)?;
        let go = |e: &Expr| self.near(e, over, kind, depth);
        let both = |a: &Expr, b: &Expr, next: &dyn Fn(&Local, &Local) -> Checked<Locals>| {
            let right = go(b)?;
            self.each(&go(a)?, |x| self.each(&right, |y| next(x, y)))
        };
        match e {
            Expr::Num(q) => Ok(Local::of(Fraction::rational(q), &[])),
            Expr::Var(v) => match (self.context.value(*v), self.context.vars.get(*v)) {
                // What is varied has no value.
                (Some(_), _) if over.contains(v) => Err(Rejection::NotExplicit),
                // Nor does a function of x vary with anything else, whatever stands for it.
                (Some(value), Some(var))
                    if over.iter().any(|x| var.of != Some(*x) && depends(self, value, *x)) =>
                {
                    Err(Rejection::NotExplicit)
                }
                (Some(value), _) => go(value),
                (None, None) => Err(Rejection::UnknownSymbol),
                (None, Some(var)) if var.of.is_some_and(|x| over.contains(&x)) => {
                    Err(Rejection::NotExplicit)
                }
                (None, Some(_)) => Ok(Local::of(Fraction::whole(Poly::var(*v)), &[])),
            },
            Expr::Let(i) => {
                let known = (*i, over.to_vec(), kind);
                if let Some(near) = self.near_lets.borrow().get(&known) {
                    return Ok(near.clone());
                }
                let body = &self.context.lets.get(*i).ok_or(Rejection::UnknownSymbol)?.body;
                let depth = depth.checked_sub(1).ok_or(Rejection::Budget)?;
                let near = self.near(body, over, kind, depth)?;
                self.near_lets.borrow_mut().insert(known, near.clone());
                Ok(near)
            }
            Expr::Neg(a) => self.each(&go(a)?, |x| Ok(Local::of(x.value.neg(), &[x]))),
            Expr::Add(a, b) => {
                both(a, b, &|x, y| Ok(Local::of(x.value.add(&y.value, fuel)?, &[x, y])))
            }
            Expr::Sub(a, b) => {
                both(a, b, &|x, y| Ok(Local::of(x.value.add(&y.value.neg(), fuel)?, &[x, y])))
            }
            Expr::Mul(a, b) => {
                both(a, b, &|x, y| Ok(Local::of(x.value.mul(&y.value, fuel)?, &[x, y])))
            }
            Expr::Div(a, b) => both(a, b, &|x, y| {
                let by = Atom::new(y.value.num.clone(), Sign::NonZero);
                let value = Local::of(x.value.over(&y.value, fuel)?, &[x, y]);
                self.each(&either(by, Some(()), None), |()| Ok(value.clone()))
            }),
            Expr::Pow(a, n) if *n < 0 => {
                let power = Expr::Pow(a.clone(), n.checked_neg().ok_or(Rejection::Budget)?);
                go(&Expr::Div(Expr::int(1).into(), power.into()))
            }
            Expr::Pow(a, n) => {
                self.each(&go(a)?, |x| Ok(Local::of(x.value.pow(n.unsigned_abs(), fuel)?, &[x])))
            }
            Expr::Sqrt(a) => self.each(&go(a)?, |x| self.root_near(e, x, over)),
            Expr::Abs(_) | Expr::Min(..) | Expr::Max(..) if kind == Kind::Smooth => {
                go(&e.as_cases())
            }
            Expr::Abs(a) => self.each(&go(a)?, |x| {
                let atom = Atom::new(x.value.sign_poly(fuel)?, Sign::NonNegative);
                self.chosen(atom, x.is_free(over), x, &Local { value: x.value.neg(), ..x.clone() })
            }),
            Expr::Min(a, b) | Expr::Max(a, b) => both(a, b, &|x, y| {
                let (low, high) = if matches!(e, Expr::Min(..)) { (x, y) } else { (y, x) };
                let gap = Local::of(high.value.add(&low.value.neg(), fuel)?, &[high, low]);
                self.each(&gap, |gap| {
                    let atom = Atom::new(gap.value.sign_poly(fuel)?, Sign::NonNegative);
                    self.chosen(atom, gap.is_free(over), x, y)
                })
            }),
            Expr::Deriv(f, x) => {
                self.slopes_near(f, *x, (over, depth), |slope, at| Local::of(slope, &[at]))
            }
            Expr::Cases(branches, otherwise) => {
                let last = otherwise.as_ref().map(|body| go(body)).transpose()?;
                let mut rest = last.unwrap_or_else(|| everywhere(None));
                for (guards, body) in branches.iter().rev() {
                    let body = go(body)?;
                    rest = self.each(&self.all_near(guards, over, depth)?, |taken| {
                        Ok(if *taken { body.clone() } else { rest.clone() })
                    })?;
                }
                Ok(rest)
            }
        }
    }

    /// One of two where an atom holds and where it does not; both are continuous, and agree where
    /// they meet. Unless the atom's polynomial does not vary, the one is not all that is near.
    fn chosen(&self, atom: Atom, fixed: bool, holds: &Local, fails: &Local) -> Checked<Locals> {
        self.each(&either(atom, Some(true), Some(false)), |taken| {
            let side = if *taken { holds } else { fails };
            Ok(everywhere(Some(Local { bent: side.bent || !fixed, ..side.clone() })))
        })
    }

    /// A root near a point: it needs a positive radicand, unless that does not vary.
    fn root_near(&self, e: &Expr, radicand: &Local, over: &[usize]) -> Checked<Locals> {
        let s = self.root_variable(e)?;
        let sign = if radicand.is_free(over) { Sign::NonNegative } else { Sign::Positive };
        let mut known = radicand.clone();
        known.roots.push((s, radicand.value.clone()));
        let pieces = self.root_pieces(s, &radicand.value, sign)?;
        self.each(&pieces, |root| Ok(Local::of(root.clone(), &[&known])))
    }

    /// Where guards, read left to right, are true and stay so nearby; where they are false and stay
    /// so; elsewhere undefined.
    fn all_near(
        &self,
        guards: &[Relation],
        over: &[usize],
        depth: usize,
    ) -> Checked<Vec<Piece<bool>>> {
        let mut truth = everywhere(Some(true));
        for guard in guards {
            let next = self.relation_near(guard, over, depth)?;
            truth = self.each(&truth, |so_far| {
                Ok(if *so_far { next.clone() } else { everywhere(Some(false)) })
            })?;
        }
        Ok(truth)
    }

    fn relation_near(
        &self,
        r: &Relation,
        over: &[usize],
        depth: usize,
    ) -> Checked<Vec<Piece<bool>>> {
        let fuel = &self.fuel;
        let (left, right) = r.greater_first();
        let side = |e: &Expr| self.near(e, over, Kind::Continuous, depth);
        let right = side(right)?;
        self.each(&side(left)?, |x| {
            self.each(&right, |y| {
                let gap = Local::of(x.value.add(&y.value.neg(), fuel)?, &[x, y]);
                self.each(&gap, |gap| self.compared(r.rel, gap, over))
            })
        })
    }

    /// Where a relation holds, or does not, and stays so nearby, from the difference of its sides.
    fn compared(&self, rel: Rel, gap: &Local, over: &[usize]) -> Checked<Vec<Piece<bool>>> {
        if gap.is_free(over) {
            return Ok(either(self.condition(rel, &gap.value)?, Some(true), Some(false)));
        }
        // The two sides are continuous: where they differ, they differ the same way nearby.
        let (above, below) = match rel {
            Rel::Eq => (false, false),
            Rel::Ne => (true, true),
            Rel::Lt | Rel::Gt | Rel::Le | Rel::Ge => (true, false),
        };
        let sign = gap.value.sign_poly(&self.fuel)?;
        let piece = |poly, sign, value| Piece { atoms: vec![Atom::new(poly, sign)], value };
        Ok(vec![
            piece(sign.clone(), Sign::Positive, Some(above)),
            piece(sign.neg(), Sign::Positive, Some(below)),
            piece(gap.value.num.clone(), Sign::Zero, None),
        ])
    }
}
