//! The check: a goal, a finding and its evidence, accepted or rejected with the reason.

use std::hash::{Hash, Hasher};
use std::rc::Rc;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

use crate::limit::{at_point, constants, sides};
use crate::{
    Atoms, Cases, Certificate, Conclusion, Evidence, Expr, Failure, Finding, Fuel, Functions, Goal,
    Hypothesis, Limit, Link, Model, Point, Rejection, Relation, Scope, Sentence, State, Target,
    descartes, sign_at,
};

/// Checks a certificate against the goal that it is for, within the budget.
///
/// # Errors
/// [`Rejection`]: why it was not accepted. Nothing but `Ok` means accepted.
pub fn check(goal: &Goal, certificate: &Certificate, fuel: Fuel) -> Result<(), Rejection> {
    if certificate.goal != digest(goal) {
        return Err(Rejection::OtherGoal);
    }
    let scope = scope(goal, fuel)?;
    let finding = certificate.finding;
    match (&certificate.evidence, &goal.conclusion) {
        (Evidence::Limit(proofs), Conclusion::Link(Link::Limit(limit)))
            if finding == Finding::Proved =>
        {
            limit_holds(&constants(&scope, goal, limit.var)?, limit, proofs)
        }
        (Evidence::Contradiction(proof), conclusion) if is_universal(conclusion, finding) => {
            claim_state(&scope, goal, finding)?.refute(proof)
        }
        (Evidence::Model(Model::Point(point)), conclusion)
            if is_existential(conclusion, finding) =>
        {
            // A point says nothing about limits, neither premised nor claimed.
            let links = goal.hypotheses.iter().flat_map(|h| &h.sentence.links);
            if links.chain(claimed(conclusion)).any(|l| matches!(l, Link::Limit(_))) {
                return Err(Rejection::NeedsFunctions);
            }
            satisfies(&claim_state(&scope, goal, finding)?, point)
        }
        (Evidence::Model(Model::Functions(f)), conclusion)
            if is_existential(conclusion, finding) =>
        {
            functions(goal, finding, f, &scope.fuel)
        }
        _ => Err(Rejection::WrongEvidence),
    }
}

/// The scope of a goal.
///
/// # Errors
/// [`Rejection::Budget`], [`Rejection::UnknownSymbol`].
pub fn scope(goal: &Goal, fuel: Fuel) -> Result<Scope<'_>, Rejection> {
    let mut subjects = Vec::new();
    collect(goal, &mut subjects);
    Scope::new(&goal.context, &subjects, fuel)
}

fn collect<'g>(goal: &'g Goal, out: &mut Vec<&'g Expr>) {
    fn sentence<'g>(when: &'g [Relation], links: &'g [Link], out: &mut Vec<&'g Expr>) {
        out.extend(when.iter().flat_map(|r| [&r.lhs, &r.rhs]));
        for link in links {
            match link {
                Link::Relation(r) => out.extend([&r.lhs, &r.rhs]),
                Link::Limit(l) => {
                    out.push(&l.expr);
                    if let Target::Finite(value) = &l.to {
                        out.push(value);
                    }
                }
            }
        }
    }
    for h in &goal.hypotheses {
        sentence(&h.sentence.when, &h.sentence.links, out);
    }
    sentence(&goal.when, &[], out);
    match &goal.conclusion {
        Conclusion::Link(link) => sentence(&[], std::slice::from_ref(link), out),
        Conclusion::NotImplied(s) => sentence(&s.when, &s.links, out),
        Conclusion::Contradiction => {}
    }
}

fn is_universal(conclusion: &Conclusion, finding: Finding) -> bool {
    match conclusion {
        _ if finding == Finding::Vacuous => true,
        Conclusion::Link(Link::Relation(_)) | Conclusion::Contradiction => {
            finding == Finding::Proved
        }
        Conclusion::Link(Link::Limit(_)) => false,
        Conclusion::NotImplied(s) => {
            finding == Finding::Refuted && !s.links.iter().any(|l| matches!(l, Link::Limit(_)))
        }
    }
}

fn is_existential(conclusion: &Conclusion, finding: Finding) -> bool {
    match conclusion {
        _ if finding == Finding::Consistent => true,
        Conclusion::Link(Link::Relation(_)) => {
            matches!(finding, Finding::Refuted | Finding::IllDefined)
        }
        Conclusion::Link(Link::Limit(_)) | Conclusion::Contradiction => finding == Finding::Refuted,
        Conclusion::NotImplied(_) => finding == Finding::Proved,
    }
}

fn claimed(conclusion: &Conclusion) -> &[Link] {
    match conclusion {
        Conclusion::Link(link) => std::slice::from_ref(link),
        Conclusion::Contradiction => &[],
        Conclusion::NotImplied(s) => &s.links,
    }
}

/// The state that a contradiction closes, or that a model satisfies: premises, premised limits,
/// `when`, and the conclusion's failure, in this order.
///
/// # Errors
/// [`Rejection::Budget`], [`Rejection::WrongEvidence`].
pub fn claim_state<'s, 'g>(
    scope: &'s Scope<'g>,
    goal: &'g Goal,
    finding: Finding,
) -> Result<State<'s, 'g>, Rejection> {
    if let (Conclusion::Link(Link::Limit(l)), Finding::Vacuous) = (&goal.conclusion, finding) {
        let state = constants(scope, goal, l.var)?;
        return Ok(State { reaching: true, ..state });
    }
    let mut formulas = at_point(scope, goal, None)?;
    formulas.extend(failure(scope, &goal.conclusion, finding)?);
    Ok(State { scope, goal, atoms: scope.ranges(), formulas: Rc::new(formulas), reaching: false })
}

/// The cases in which the conclusion fails in the way that the finding speaks of.
fn failure(
    scope: &Scope<'_>,
    conclusion: &Conclusion,
    finding: Finding,
) -> Result<Option<Cases>, Rejection> {
    Ok(match (conclusion, finding) {
        (_, Finding::Vacuous | Finding::Consistent) | (Conclusion::Contradiction, _) => None,
        (Conclusion::Link(Link::Relation(r)), _) => {
            let truth = scope.relation(r)?;
            Some(match finding {
                Finding::Proved => truth.not(),
                Finding::Refuted => truth.fails,
                _ => truth.undefined,
            })
        }
        (Conclusion::Link(Link::Limit(_)), _) => return Err(Rejection::WrongEvidence),
        (Conclusion::NotImplied(s), _) => Some(scope.premise_fails(s, true)?),
    })
}

/// Checks one limit from all its sides.
fn limit_holds(
    state: &State<'_, '_>,
    limit: &Limit,
    proofs: &[crate::SideProof],
) -> Result<(), Rejection> {
    let sides = sides(state.scope, limit);
    if sides.is_empty() || sides.len() != proofs.len() {
        return Err(Rejection::OutsideDomain);
    }
    sides.iter().zip(proofs).try_for_each(|(s, p)| crate::limit::check(state, limit, s, p))
}

/// Whether a point satisfies the atoms of a state and a case of each of its formulas.
///
/// # Errors
/// [`Rejection::NotAModel`] with the index of the formula that fails.
pub fn satisfies(state: &State<'_, '_>, point: &Point) -> Result<(), Rejection> {
    let fuel = &state.scope.fuel;
    if let Some(root) = &point.generator {
        let simple = descartes(&root.poly, Some(&root.lo), Some(&root.hi), fuel)? == 1
            && sign_at(&root.poly, &root.lo) != 0
            && sign_at(&root.poly, &root.hi) != 0;
        if !simple || root.is_exact() {
            return Err(Rejection::RootCount);
        }
    }
    let holds = |atoms: &Atoms| -> Result<bool, Rejection> {
        for a in atoms {
            match point.sign(&a.poly, fuel)? {
                Some(s) if a.sign.admits(s) => {}
                _ => return Ok(false),
            }
        }
        Ok(true)
    };
    if !holds(&state.atoms)? {
        return Err(Rejection::NotAModel(None));
    }
    for (i, cases) in state.formulas.iter().enumerate() {
        let mut found = false;
        for case in cases {
            found = found || holds(case)?;
        }
        if !found {
            return Err(Rejection::NotAModel(Some(i)));
        }
    }
    Ok(())
}

/// Halvings of an isolating interval before a sign is given up as undecided.
const MAX_HALVINGS: usize = 512;

impl Point {
    /// Sign of a polynomial at this point; `None` if a variable has no value. Exact.
    ///
    /// # Errors
    /// [`Rejection::Budget`], also if the sign at an algebraic number does not come out.
    pub fn sign(&self, p: &crate::Poly, fuel: &Fuel) -> Result<Option<i8>, Rejection> {
        let mut sum: Vec<BigRational> = Vec::new();
        for (m, c) in p.terms() {
            let mut product = vec![BigRational::from_integer(c.clone())];
            for &(v, n) in m {
                let Some((_, value)) = self.values.iter().find(|x| x.0 == v) else {
                    return Ok(None);
                };
                let (mut n, mut base) = (n, value.clone());
                while n > 0 {
                    if n & 1 == 1 {
                        product = self.times(&product, &base, fuel)?;
                    }
                    n >>= 1;
                    if n > 0 {
                        base = self.times(&base, &base, fuel)?;
                    }
                }
            }
            for (i, q) in product.into_iter().enumerate() {
                match sum.get_mut(i) {
                    Some(s) => *s += q,
                    None => sum.push(q),
                }
            }
        }
        while sum.last().is_some_and(Zero::is_zero) {
            sum.pop();
        }
        let common = sum.iter().fold(BigInt::one(), |l, q| num_integer::lcm(l, q.denom().clone()));
        let whole: Vec<BigInt> = sum.iter().map(|q| q.numer() * (&common / q.denom())).collect();
        let Some(root) = &self.generator else {
            return Ok(Some(whole.first().map_or(0, crate::sign)));
        };
        if whole.is_empty() {
            return Ok(Some(0));
        }
        let (mut lo, mut hi) = (root.lo.clone(), root.hi.clone());
        let low = sign_at(&root.poly, &lo);
        for _ in 0..MAX_HALVINGS {
            let mid = (&lo + &hi) / BigRational::from_integer(2.into());
            if descartes(&whole, Some(&lo), Some(&hi), fuel)? == 0 {
                return Ok(Some(sign_at(&whole, &mid)));
            }
            match sign_at(&root.poly, &mid) {
                0 => return Ok(Some(sign_at(&whole, &mid))),
                s if s == low => lo = mid,
                _ => hi = mid,
            }
        }
        Err(Rejection::Budget)
    }

    /// Product modulo the generator's polynomial.
    fn times(
        &self,
        a: &[BigRational],
        b: &[BigRational],
        fuel: &Fuel,
    ) -> Result<Vec<BigRational>, Rejection> {
        let bits = |p: &[BigRational]| {
            1 + p.iter().map(|q| q.numer().bits() + q.denom().bits()).max().unwrap_or(0) / 64
        };
        let size = u64::try_from(a.len() * b.len()).unwrap_or(u64::MAX);
        fuel.spend(size.saturating_mul(bits(a).saturating_mul(bits(b))))?;
        let mut out = vec![BigRational::zero(); (a.len() + b.len()).saturating_sub(1)];
        for (i, x) in a.iter().enumerate() {
            for (j, y) in b.iter().enumerate() {
                out[i + j] += x * y;
            }
        }
        let Some(root) = &self.generator else {
            return Ok(out);
        };
        let (Some(lead), n) = (root.poly.last(), root.poly.len()) else {
            return Err(Rejection::RootCount);
        };
        if lead.is_zero() {
            return Err(Rejection::RootCount);
        }
        while out.len() >= n {
            let top = out.pop().unwrap_or_else(BigRational::zero);
            let factor = top / BigRational::from_integer(lead.clone());
            let from = out.len() + 1 - n;
            for (k, c) in root.poly[..n - 1].iter().enumerate() {
                out[from + k] -= &factor * BigRational::from_integer(c.clone());
            }
        }
        Ok(out)
    }
}

/// Checks explicit functions: premises for all x, and how the conclusion fails.
fn functions(goal: &Goal, finding: Finding, f: &Functions, fuel: &Fuel) -> Result<(), Rejection> {
    let context = &goal.context;
    // Every symbol but x has one expression: in x if it is a function of x, else closed.
    for (i, (v, e)) in f.values.iter().enumerate() {
        let var = context.vars.get(*v).ok_or(Rejection::UnknownSymbol)?;
        let free = mentions(e, f.var, var.of == Some(f.var));
        if !free || *v == f.var || f.values[..i].iter().any(|w| w.0 == *v) {
            return Err(Rejection::NotConstant);
        }
    }
    if f.values.len() + 1 != context.vars.len()
        || f.premises.len() != goal.hypotheses.len()
        || f.ranges.len() != f.values.len()
    {
        return Err(Rejection::CaseCount(context.vars.len(), f.values.len()));
    }
    let explicit = crate::substituted(goal, &f.values);
    let outer = scope(goal, Fuel::new(fuel.left()))?;
    // Premises about x alone narrow its domain; all others are proved on that domain.
    let narrow: Vec<bool> =
        goal.hypotheses.iter().map(|h| crate::limit::narrows(&outer, &h.sentence, f.var)).collect();
    let domain: Vec<Hypothesis> = explicit
        .hypotheses
        .iter()
        .zip(&narrow)
        .filter(|(_, narrow)| **narrow)
        .map(|(h, _)| h.clone())
        .collect();
    let on_domain = |conclusion, when| Goal {
        context: explicit.context.clone(),
        hypotheses: domain.clone(),
        when,
        conclusion,
    };
    let limit_goal = |l: &Limit| on_domain(Conclusion::Link(Link::Limit(l.clone())), Vec::new());
    let left = || Fuel::new(fuel.left());
    let prove = |h: &Hypothesis, proof: &crate::Proof| {
        let alone = on_domain(Conclusion::Contradiction, Vec::new());
        // The premise is only named here so that its roots are known; it may not prove itself.
        let carrier =
            Goal { conclusion: Conclusion::NotImplied(h.sentence.clone()), ..alone.clone() };
        let scope = scope(&carrier, left())?;
        let mut formulas = at_point(&scope, &alone, None)?;
        formulas.push(scope.premise_fails(&h.sentence, h.given)?);
        let state = State {
            scope: &scope,
            goal: &alone,
            atoms: scope.range(f.var),
            formulas: Rc::new(formulas),
            reaching: false,
        };
        let outcome = state.refute(proof);
        fuel.spend(fuel.left().saturating_sub(scope.fuel.left()))?;
        outcome
    };
    for ((v, e), proof) in f.values.iter().zip(&f.ranges) {
        prove(&range_premise(goal, *v, e), proof)?;
    }
    for ((h, narrow), (proof, limits)) in explicit.hypotheses.iter().zip(narrow).zip(&f.premises) {
        if narrow {
            continue;
        }
        prove(h, proof)?;
        let wanted = h.sentence.links.iter().filter_map(|l| match l {
            Link::Limit(l) => Some(l),
            Link::Relation(_) => None,
        });
        let wanted: Vec<_> = wanted.collect();
        if wanted.len() != limits.len() {
            return Err(Rejection::CaseCount(wanted.len(), limits.len()));
        }
        for (limit, proofs) in wanted.into_iter().zip(limits) {
            let goal = limit_goal(limit);
            let scope = scope(&goal, left())?;
            limit_holds(&constants(&scope, &goal, limit.var)?, limit, proofs)?;
        }
    }
    match (&f.failure, &explicit.conclusion, finding) {
        (Failure::At(point), conclusion, _)
            if finding == Finding::Consistent || !is_limit(conclusion) =>
        {
            let goal = on_domain(explicit.conclusion.clone(), explicit.when.clone());
            let scope = scope(&goal, left())?;
            let mut state = claim_state(&scope, &goal, finding)?;
            state.atoms = scope.range(f.var);
            satisfies(&state, point)
        }
        (Failure::Reaches(proof), Conclusion::Link(Link::Limit(l)), Finding::Consistent) => {
            let zero = Expr::int(0);
            let trivial = Limit { expr: zero.clone(), to: Target::Finite(zero), ..l.clone() };
            let goal = on_domain(Conclusion::Link(Link::Limit(trivial.clone())), explicit.when);
            let scope = scope(&goal, left())?;
            let state = constants(&scope, &goal, l.var)?;
            let sides = sides(&scope, &trivial);
            let side = sides.iter().find(|s| **s == proof.germ.side);
            let side = side.ok_or(Rejection::OutsideDomain)?;
            crate::limit::check(&state, &trivial, side, proof)
        }
        (Failure::Limit { link, target, side, proof }, conclusion, _)
            if finding != Finding::Consistent =>
        {
            let when: &[Relation] = match conclusion {
                Conclusion::NotImplied(s) => &s.when,
                _ => &[],
            };
            let Some(Link::Limit(claimed)) = self::claimed(conclusion).get(*link) else {
                return Err(Rejection::WrongEvidence);
            };
            let found = Limit { to: target.clone(), ..claimed.clone() };
            let (goal, claim) = (limit_goal(&found), limit_goal(claimed));
            let (scope, claim_scope) = (scope(&goal, left())?, scope(&claim, left())?);
            let state = constants(&scope, &goal, found.var)?;
            let sides = sides(&scope, &found);
            let side = sides.get(*side).ok_or(Rejection::OutsideDomain)?;
            crate::limit::check(&state, &found, side, proof)?;
            let differs = differ(&claim_scope, &claimed.to, target)?;
            let applies =
                claim_scope.all(explicit.when.iter().chain(when))?.holds.contains(&Atoms::new());
            (differs && applies).then_some(()).ok_or(Rejection::NotAModel(None))
        }
        _ => Err(Rejection::WrongEvidence),
    }
}

fn is_limit(conclusion: &Conclusion) -> bool {
    claimed(conclusion).iter().any(|l| matches!(l, Link::Limit(_)))
}

/// «e is defined and within the range of v» as a premise.
#[must_use]
pub fn range_premise(goal: &Goal, v: usize, e: &Expr) -> Hypothesis {
    let relation =
        |rel, value: &Expr| Link::Relation(Relation { lhs: e.clone(), rel, rhs: value.clone() });
    let mut links = vec![relation(crate::Rel::Eq, e)];
    if let Some(var) = goal.context.vars.get(v) {
        use crate::Rel::{Ge, Gt, Le, Lt};
        let number = |b: &crate::Bound| Expr::Num(b.value.clone());
        links.extend(
            var.lower.as_ref().map(|b| relation(if b.strict { Gt } else { Ge }, &number(b))),
        );
        links.extend(
            var.upper.as_ref().map(|b| relation(if b.strict { Lt } else { Le }, &number(b))),
        );
    }
    let sentence = Sentence { when: Vec::new(), links };
    Hypothesis { sentence, given: true }
}

/// Whether two closed targets are visibly different.
fn differ(scope: &Scope<'_>, claimed: &Target, found: &Target) -> Result<bool, Rejection> {
    let (Target::Finite(a), Target::Finite(b)) = (claimed, found) else {
        return Ok(std::mem::discriminant(claimed) != std::mem::discriminant(found));
    };
    let unequal = Relation { lhs: a.clone(), rel: crate::Rel::Eq, rhs: b.clone() };
    let truth = scope.relation(&unequal)?;
    Ok(truth.holds.is_empty() && truth.not().contains(&Atoms::new()))
}

/// Whether an expression mentions nothing but numbers and, if allowed, x.
fn mentions(e: &Expr, x: usize, allowed: bool) -> bool {
    let mut todo = vec![e];
    while let Some(e) = todo.pop() {
        match e {
            Expr::Var(v) if *v == x && allowed => {}
            Expr::Var(_) | Expr::Let(_) => return false,
            _ => {}
        }
        todo.extend(e.children());
    }
    true
}

/// Digest of a goal or a certificate: 128-bit FNV-1a of its parts. A name, not a safeguard: the
/// check itself never relies on it.
#[must_use]
pub fn digest(value: &impl Hash) -> u128 {
    struct Fnv(u128);
    impl Hasher for Fnv {
        fn write(&mut self, bytes: &[u8]) {
            for b in bytes {
                self.0 = (self.0 ^ u128::from(*b)).wrapping_mul(0x0100_0000_0000_0000_0000_013b);
            }
        }
        fn write_usize(&mut self, i: usize) {
            self.write(&u64::try_from(i).unwrap_or(u64::MAX).to_le_bytes());
        }
        fn finish(&self) -> u64 {
            u64::try_from(self.0 >> 64).unwrap_or(u64::MAX)
        }
    }
    let mut hash = Fnv(0x6c62_272e_07bb_0142_62b8_2175_6295_c58d);
    value.hash(&mut hash);
    hash.0
}
