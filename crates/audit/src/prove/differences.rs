//! Successive differences: a polynomial on a cone, which is cut until it has one sign on each part.
//!
//! Where as many linear conditions l₁ ≥ 0, …, lₙ ≥ 0 as there are variables are independent, a polynomial q
//! is one in l₁, …, lₙ, and in 1 if it is not homogeneous in them. If none of its coefficients is positive,
//! neither is q. If some are, the cone is cut where two of these forms are equal, one of which may be 1: on
//! the part lᵢ ≥ lⱼ the difference lᵢ − lⱼ takes the place of lᵢ. What has its only zeros at the corners of
//! a part, as symmetric inequalities do where all variables are equal, ends after few cuts.
//!
//! After L. Yang, Solving harder problems with lesser mathematics (2005), who cuts by all orders of the
//! variables at a time.

use kane_algebra::linear_program::common_denominator;
use kane_algebra::squares::total_degree as total;
use kane_kernel::{Atom, Fuel, Poly, Sign, State, Term};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::elimination::open_vars;
use super::{line, tactics};
use crate::argument::{Argument, Rules as _};

type Q = BigRational;

/// Of a polynomial that is tried.
const VARIABLES: usize = 5;
const TERMS: usize = 300;
const DEGREE: u32 = 20;
/// Conditions that are looked at on a part.
const TARGETS: usize = 6;
/// Cuts along one branch.
const DEPTH: u32 = 14;
/// Parts in all.
const PARTS: u32 = 300;

/// A linear condition that is a coordinate, with the index of its atom; the number 1 has none.
#[derive(Clone, Debug)]
struct Form {
    poly: Poly,
    atom: Option<usize>,
}

/// A condition that may fail: scale·(its polynomial) = q(forms), in variables 0, 1, … for the forms.
#[derive(Clone, Debug)]
struct Target {
    atom: usize,
    /// negative for the opposite of an equation
    scale: BigInt,
    q: Poly,
}

/// A part of a cone, and the conditions of which it is not known that they hold somewhere on it.
#[derive(Clone, Debug)]
struct Part {
    targets: Vec<Target>,
    forms: Vec<Form>,
}

/// A contradiction between polynomials of a state and its linear conditions.
pub(super) fn differences(state: &State<'_, '_>, fuel: &Fuel) -> Option<Argument> {
    let hard = |i: &usize| {
        let a = &state.atoms[*i];
        let (vars, terms) = (a.poly.vars().len(), a.poly.len());
        let fits = (2..=VARIABLES).contains(&vars) && terms > 2 && terms <= TERMS;
        a.sign.is_order() && fits && (2..=DEGREE).contains(&total(&a.poly))
    };
    let mut tried: Vec<Vec<usize>> = Vec::new();
    (0..state.atoms.len()).rev().filter(hard).find_map(|i| {
        let vars = state.atoms[i].poly.vars();
        if tried.contains(&vars) {
            return None;
        }
        tried.push(vars.clone());
        on_cones(state, &vars, fuel, &mut PARTS.clone())
    })
}

/// The same for the conditions in some variables.
fn on_cones(
    state: &State<'_, '_>,
    vars: &[usize],
    fuel: &Fuel,
    parts: &mut u32,
) -> Option<Argument> {
    let linear = |i: &usize| {
        let a = &state.atoms[*i];
        let known = a.sign.is_order() && a.decided().is_none() && total(&a.poly) == 1;
        known && a.poly.vars().iter().all(|v| vars.contains(v))
    };
    let last: Vec<usize> = (0..state.atoms.len()).rev().filter(linear).collect();
    let own: Option<Vec<usize>> = vars.iter().map(|&v| line::bounds(state, v).0).collect();
    let mut tried: Vec<Vec<usize>> = Vec::new();
    for cone in [own, independent(state, vars, &last)].into_iter().flatten() {
        if tried.contains(&cone) {
            continue;
        }
        let mut left = *parts;
        let whole = Part::new(state, vars, &cone, fuel);
        if let Some(found) = whole.and_then(|p| p.closed(state, fuel, DEPTH, &mut left)) {
            *parts = left;
            return Some(found);
        }
        tried.push(cone);
    }
    None
}

/// The first of these conditions that are independent, as many as there are variables.
fn independent(state: &State<'_, '_>, vars: &[usize], from: &[usize]) -> Option<Vec<usize>> {
    let mut chosen: Vec<usize> = Vec::new();
    for &i in from {
        let rows: Vec<usize> = chosen.iter().copied().chain([i]).collect();
        if rank(rows.iter().map(|&i| row(&state.atoms[i].poly, vars).0).collect()) == rows.len() {
            chosen = rows;
        }
        if chosen.len() == vars.len() {
            return Some(chosen);
        }
    }
    None
}

/// The coefficients of a linear polynomial, and its constant.
fn row(p: &Poly, vars: &[usize]) -> (Vec<Q>, Q) {
    let of = |m: &[(usize, u32)]| {
        let found = p.terms().find(|(n, _)| *n == m);
        found.map_or_else(Q::zero, |(_, c)| Q::from_integer(c.clone()))
    };
    (vars.iter().map(|&v| of(&[(v, 1)])).collect(), of(&[]))
}

/// Brings rows to reduced echelon form by their first columns, and returns how many are not zero there.
fn reduce(rows: &mut [Vec<Q>], columns: usize) -> usize {
    let mut done = 0;
    for column in 0..columns {
        let Some(pivot) = (done..rows.len()).find(|&r| !rows[r][column].is_zero()) else {
            continue;
        };
        rows.swap(done, pivot);
        let lead = rows[done][column].clone();
        for x in &mut rows[done] {
            *x /= &lead;
        }
        let by = rows[done].clone();
        for (r, other) in rows.iter_mut().enumerate() {
            if r != done {
                let factor = other[column].clone();
                for (x, y) in other.iter_mut().zip(&by) {
                    *x -= &factor * y;
                }
            }
        }
        done += 1;
    }
    done
}

fn rank(mut rows: Vec<Vec<Q>>) -> usize {
    let columns = rows.first().map_or(0, Vec::len);
    reduce(&mut rows, columns)
}

impl Target {
    /// How many coefficients have the wrong sign.
    fn wrong(&self) -> usize {
        self.q.terms().filter(|(_, c)| c.is_positive()).count()
    }

    /// Whether some have the right one, so that the condition may fail somewhere.
    fn may_fail(&self) -> bool {
        self.q.is_empty() || self.q.terms().any(|(_, c)| c.is_negative())
    }

    /// Whether the condition holds at the corner where only form i is not zero.
    fn holds_at(&self, i: usize) -> bool {
        let alone = |m: &[(usize, u32)]| m.iter().all(|x| x.0 == i);
        self.q.terms().any(|(m, c)| alone(m) && c.is_positive())
    }
}

impl Part {
    /// The whole cone.
    fn new(state: &State<'_, '_>, vars: &[usize], cone: &[usize], fuel: &Fuel) -> Option<Self> {
        let n = vars.len();
        if cone.len() != n {
            return None;
        }
        // l = A·x + b, so x = A⁻¹·l − A⁻¹·b: the rows (A | 1 | b), reduced
        let mut system: Vec<Vec<Q>> = Vec::new();
        for (i, &atom) in cone.iter().enumerate() {
            let (mut line, constant) = row(&state.atoms[atom].poly, vars);
            line.extend((0..n).map(|j| if i == j { Q::one() } else { Q::zero() }));
            line.push(constant);
            system.push(line);
        }
        if reduce(&mut system, n) < n {
            return None;
        }
        let common = common_denominator(system.iter().flatten());
        let whole = |x: &Q| (x * Q::from_integer(common.clone())).to_integer();
        // common·x by the forms, the number 1 being the last of them
        let values: Vec<Poly> = system
            .iter()
            .map(|line| {
                let by_forms = (0..n).map(|j| (vec![(j, 1)], whole(&line[n + j])));
                Poly::sum(by_forms.chain([(vec![(n, 1)], -whole(&line[2 * n]))]))
            })
            .collect();
        let one = Poly::term(vec![(n, 1)], common.clone());
        let mut targets = Vec::new();
        for (i, a) in state.atoms.iter().enumerate() {
            let inside = a.poly.vars().iter().all(|v| vars.contains(v));
            let small = a.poly.len() <= TERMS && total(&a.poly) <= DEGREE;
            if a.decided().is_some() || !inside || !small || cone.contains(&i) {
                continue;
            }
            let signs: &[i32] = match a.sign {
                Sign::NonZero => &[],
                Sign::Zero => &[1, -1],
                Sign::Positive | Sign::NonNegative => &[1],
            };
            let scale = common.pow(total(&a.poly));
            let q = by_forms(&a.poly, vars, &values, &one, fuel)?;
            let target = |s: &i32| Target { atom: i, scale: &scale * s, q: q.scale(&(*s).into()) };
            targets.extend(signs.iter().map(target));
        }
        targets.reverse();
        targets.retain(Target::may_fail);
        targets.truncate(TARGETS);
        let form = |&i: &usize| Form { poly: state.atoms[i].poly.clone(), atom: Some(i) };
        let mut forms: Vec<Form> = cone.iter().map(form).collect();
        forms.push(Form { poly: Poly::one(), atom: None });
        (!targets.is_empty()).then_some(Self { targets, forms })
    }

    /// The fewest coefficients of the wrong sign that a condition has; nothing if all hold at a corner, so
    /// that no cut helps.
    fn wrong(&self) -> Option<usize> {
        let open = |i: usize| self.targets.iter().all(|t| t.holds_at(i));
        let fewest = self.targets.iter().map(Target::wrong).min();
        fewest.filter(|_| !(0..self.forms.len()).any(open))
    }

    /// The part where form i is at least form j, with their difference, whose atom has the index `atom`,
    /// in the place of form i.
    fn above(
        &self,
        (i, j): (usize, usize),
        difference: &(BigInt, Poly),
        atom: usize,
        fuel: &Fuel,
    ) -> Option<Self> {
        let (content, poly) = difference;
        // lᵢ = content·d + lⱼ
        let value = Poly::sum([(vec![(i, 1)], content.clone()), (vec![(j, 1)], BigInt::one())]);
        let mut targets = Vec::new();
        for target in &self.targets {
            let mut q = Poly::default();
            for c in target.q.coefficients(i).iter().rev() {
                q = q.mul(&value, fuel).ok()?.add(c);
            }
            targets.push(Target { q, ..target.clone() });
        }
        targets.retain(Target::may_fail);
        let mut forms = self.forms.clone();
        forms[i] = Form { poly: poly.clone(), atom: Some(atom) };
        (!targets.is_empty()).then_some(Self { targets, forms })
    }

    /// Two forms of which a wrong coefficient is a multiple, and the parts where one is above the other,
    /// so that the fewest wrong coefficients are left.
    fn cut(&self, atom: usize, fuel: &Fuel) -> Option<(Poly, [Self; 2])> {
        let mut best: Option<(usize, Poly, [Self; 2])> = None;
        for i in 0..self.forms.len() {
            for j in 0..i {
                let both = |m: &[(usize, u32)]| [i, j].iter().all(|k| m.iter().any(|x| x.0 == *k));
                let helps = |t: &Target| t.q.terms().any(|(m, c)| c.is_positive() && both(m));
                if !self.targets.iter().any(helps) {
                    continue;
                }
                let (content, d) = self.forms[i].poly.sub(&self.forms[j].poly).primitive();
                let above = self.above((i, j), &(content.clone(), d.clone()), atom, fuel)?;
                let below = self.above((j, i), &(content, d.neg()), atom, fuel)?;
                let left = above.wrong()? + below.wrong()?;
                if best.as_ref().is_none_or(|b| left < b.0) {
                    best = Some((left, d, [above, below]));
                }
            }
        }
        best.map(|(_, d, parts)| (d, parts))
    }

    /// The contradiction on this part.
    fn closed(
        &self,
        state: &State<'_, '_>,
        fuel: &Fuel,
        depth: u32,
        parts: &mut u32,
    ) -> Option<Argument> {
        *parts = parts.checked_sub(1)?;
        if self.wrong()? == 0 {
            let mut sure = self.targets.iter().filter(|t| t.wrong() == 0);
            if let Some(proof) = sure.find_map(|t| self.by_signs(state, t)) {
                return Some(proof);
            }
        }
        let next = depth.checked_sub(1)?;
        let (d, [above, below]) = self.cut(state.atoms.len(), fuel)?;
        let on = |sign, d: &Poly| state.with(Atom::new(d.clone(), sign));
        let positive = above.closed(&on(Sign::Positive, &d), fuel, next, parts)?;
        let negative = below.closed(&on(Sign::Positive, &d.neg()), fuel, next, parts)?;
        let zero = above.where_equal(&on(Sign::Zero, &d), fuel, next, parts)?;
        Some(Argument::Split {
            poly: d,
            zero: Box::new(zero),
            positive: Box::new(positive),
            negative: Box::new(negative),
        })
    }

    /// The contradiction by the signs of coefficients.
    fn by_signs(&self, state: &State<'_, '_>, target: &Target) -> Option<Argument> {
        let one = Poly::one();
        let (mut terms, mut cofactors) = (Vec::new(), Vec::new());
        if state.atoms[target.atom].sign == Sign::Zero {
            cofactors.push((target.atom, Poly::constant(target.scale.clone())));
        } else {
            let factors = vec![(target.atom, 1)];
            terms.push(Term { weight: target.scale.clone(), square: one.clone(), factors });
        }
        for (m, c) in target.q.terms() {
            let mut factors: Vec<(usize, u32)> =
                m.iter().filter_map(|(i, n)| Some((self.forms[*i].atom?, *n))).collect();
            factors.sort_unstable();
            terms.push(Term { weight: -c, square: one.clone(), factors });
        }
        let proof = Argument::Positive { terms, cofactors };
        state.closes(&proof).is_ok().then_some(proof)
    }

    /// The contradiction where the last atom of a state, a linear equation, holds: on the face of this part
    /// where its latest form is zero, or else on any cone.
    fn where_equal(
        &self,
        state: &State<'_, '_>,
        fuel: &Fuel,
        depth: u32,
        parts: &mut u32,
    ) -> Option<Argument> {
        let equation = state.atoms.len() - 1;
        let var = *state.atoms[equation].poly.vars().last()?;
        let next = state.substitute(equation, var, &[]).ok()?;
        let mut vars: Vec<usize> =
            self.targets.iter().flat_map(|t| next.atoms[t.atom].poly.vars()).collect();
        vars.sort_unstable();
        vars.dedup();
        let on_face = |parts: &mut u32| {
            let others = self.forms.iter().filter_map(|f| f.atom).filter(|&i| i != equation);
            let face = Self::new(&next, &vars, &others.collect::<Vec<_>>(), fuel)?;
            face.closed(&next, fuel, depth, parts)
        };
        let then = tactics::quick(&next)
            .or_else(|| match open_vars(&next)[..] {
                [v] => line::sign_table(&next, v),
                _ => None,
            })
            .or_else(|| on_face(parts))
            .or_else(|| on_cones(&next, &vars, fuel, parts))?;
        Some(Argument::Substitute { equation, var, lead: Vec::new(), then: Box::new(then) })
    }
}

/// A polynomial by the forms that give its variables, each a common multiple of them; homogeneous, with that
/// multiple of 1 as a power.
fn by_forms(p: &Poly, vars: &[usize], values: &[Poly], one: &Poly, fuel: &Fuel) -> Option<Poly> {
    let degree = total(p);
    let mut q = Poly::default();
    for (m, c) in p.terms() {
        let mut term = Poly::constant(c.clone());
        let mut missing = degree;
        for (v, power) in m {
            let at = vars.iter().position(|w| w == v)?;
            term = term.mul(&values[at].pow(*power, fuel).ok()?, fuel).ok()?;
            missing -= power;
        }
        term = term.mul(&one.pow(missing, fuel).ok()?, fuel).ok()?;
        q = q.add(&term);
    }
    Some(q)
}
