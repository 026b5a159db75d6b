//! The check: a goal, a finding and its evidence, accepted or rejected with the reason.

use std::hash::{Hash, Hasher};
use std::rc::Rc;

use crate::limit::{Place, constants, is_explicit, narrowing, premises, sides};
use crate::model::satisfies;
use crate::{
    Bound, Cases, Certificate, Checked, Conclusion, Context, Evidence, Expr, Failure, Finding,
    Fuel, Functions, Goal, Hypothesis, Limit, Link, Model, Passages, Point, Proof, Rejection, Rel,
    Relation, Scope, Sentence, SideProof, State, Target, expressions,
};

/// Checks a certificate against the goal that it is for, within the budget.
///
/// # Errors
/// [`Rejection`]: why it was not accepted. Nothing but `Ok` means accepted.
pub fn check(goal: &Goal, certificate: &Certificate, fuel: Fuel) -> Checked {
    if certificate.goal != digest(goal) || !goal.context.values.is_empty() {
        return Err(Rejection::OtherGoal);
    }
    crate::door::enter(goal, certificate)?;
    let finding = certificate.finding;
    match (&certificate.evidence, &goal.conclusion) {
        (
            evidence @ (Evidence::Limit(_) | Evidence::Split { .. }),
            Conclusion::Link(Link::Limit(limit)),
        ) if finding == Finding::Proved => {
            let scope = scope(goal, fuel)?;
            tends(&constants(&scope, goal, limit.var)?, limit, evidence)
        }
        (Evidence::Contradiction(proof), _) => contradicts(goal, finding, proof, &fuel),
        (Evidence::Model(Model::Point(point)), _) => holds_at(goal, finding, point, &fuel),
        (Evidence::Model(Model::Functions(f)), _) => functions(goal, finding, f, &fuel),
        _ => Err(Rejection::WrongEvidence),
    }
}

/// The scope of a goal.
///
/// # Errors
/// [`Rejection::Budget`], [`Rejection::UnknownSymbol`].
pub fn scope(goal: &Goal, fuel: Fuel) -> Checked<Scope<'_>> {
    let sentences = goal.hypotheses.iter().map(|h| &h.sentence);
    let subjects: Vec<&Expr> = sentences
        .flat_map(|s| expressions(&s.when, &s.links))
        .chain(expressions(&goal.when, &[]))
        .chain(expressions(goal.conclusion.when(), goal.conclusion.links()))
        .collect();
    Scope::new(&goal.context, &subjects, fuel)
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
) -> Checked<State<'s, 'g>> {
    Ok(asked(scope, goal, finding)?.1)
}

/// Whether a finding speaks of all points (that none satisfies the state) or of some, and the
/// state.
fn asked<'s, 'g>(
    scope: &'s Scope<'g>,
    goal: &'g Goal,
    finding: Finding,
) -> Checked<(bool, State<'s, 'g>)> {
    let wanted = |r: &Relation, value: &dyn Fn(Option<bool>) -> bool| {
        Ok(Some(crate::normal::regions(scope.relation(r)?, value)))
    };
    let (all, failure) = match (&goal.conclusion, finding) {
        (Conclusion::Link(Link::Limit(l)), Finding::Vacuous) => {
            let state = constants(scope, goal, l.var)?;
            return Ok((true, State { reaching: true, ..state }));
        }
        (_, Finding::Vacuous) | (Conclusion::Contradiction, Finding::Proved) => (true, None),
        (_, Finding::Consistent) | (Conclusion::Contradiction, Finding::Refuted) => (false, None),
        (Conclusion::Link(Link::Relation(r)), Finding::Proved) => {
            (true, wanted(r, &|value| value != Some(true))?)
        }
        (Conclusion::Link(Link::Relation(r)), Finding::Refuted) => {
            (false, wanted(r, &|value| value == Some(false))?)
        }
        (Conclusion::Link(Link::Relation(r)), Finding::IllDefined) => {
            (false, wanted(r, &|value| value.is_none())?)
        }
        (Conclusion::NotImplied(s), Finding::Proved) => {
            (false, Some(scope.premise(s, true, false)?))
        }
        (Conclusion::NotImplied(s), Finding::Refuted) if s.limits().next().is_none() => {
            (true, Some(scope.premise(s, true, false)?))
        }
        _ => return Err(Rejection::WrongEvidence),
    };
    Ok((all, point_state(scope, goal, failure)?))
}

/// The premises of a goal at a point, and a way in which something fails there.
///
/// # Errors
/// [`Rejection::Budget`].
pub fn point_state<'s, 'g>(
    scope: &'s Scope<'g>,
    goal: &'g Goal,
    failure: Option<Cases>,
) -> Checked<State<'s, 'g>> {
    let mut formulas = premises(scope, goal, Place::Point)?;
    formulas.extend(failure);
    let (atoms, formulas) = (scope.ranges(), Rc::new(formulas));
    // Without a limit statements speak of one point, and behind a claim nothing is owed.
    let passages = match limits(goal).next() {
        Some(_) => Passages::Anywhere,
        None => Passages::Nowhere,
    };
    Ok(State { scope, goal, atoms, formulas, reaching: false, passages })
}

/// Checks that no point satisfies what a finding denies.
fn contradicts(goal: &Goal, finding: Finding, proof: &Proof, fuel: &Fuel) -> Checked {
    let scope = scope(goal, fuel.clone())?;
    match asked(&scope, goal, finding)? {
        (true, state) => state.refute(proof),
        (false, _) => Err(Rejection::WrongEvidence),
    }
}

/// Checks that a point satisfies what a finding asserts. It says nothing about limits.
fn holds_at(goal: &Goal, finding: Finding, point: &Point, fuel: &Fuel) -> Checked {
    if limits(goal).next().is_some() {
        return Err(Rejection::NeedsFunctions);
    }
    let scope = scope(goal, fuel.clone())?;
    match asked(&scope, goal, finding)? {
        (false, state) => satisfies(&state, point),
        (true, _) => Err(Rejection::WrongEvidence),
    }
}

/// All limits that a goal speaks of.
fn limits(goal: &Goal) -> impl Iterator<Item = &Limit> {
    let premised = goal.hypotheses.iter().flat_map(|h| &h.sentence.links);
    premised.chain(goal.conclusion.links()).filter_map(|l| match l {
        Link::Relation(_) => None,
        Link::Limit(l) => Some(l),
    })
}

/// Checks a limit in each case of the constants, of which it is known what the state says.
fn tends(state: &State<'_, '_>, limit: &Limit, evidence: &Evidence) -> Checked {
    match evidence {
        Evidence::Limit(proofs) => from_all_sides(state, limit, proofs),
        Evidence::Contradiction(proof) => state.refute(proof),
        Evidence::Split { poly, cases } => {
            if !poly.vars().iter().all(|v| state.is_constant(*v, limit.var)) {
                return Err(Rejection::NotConstant);
            }
            state.split(poly, cases, &|state, case| tends(state, limit, case))
        }
        Evidence::Model(_) => Err(Rejection::WrongEvidence),
    }
}

/// Checks a limit from all its sides.
fn from_all_sides(state: &State<'_, '_>, limit: &Limit, proofs: &[SideProof]) -> Checked {
    let sides = sides(state.scope, limit);
    if sides.is_empty() || sides.len() != proofs.len() {
        return Err(Rejection::OutsideDomain);
    }
    sides.iter().zip(proofs).try_for_each(|(s, p)| crate::limit::check(state, limit, s, p))
}

/// Checks explicit functions: premises for all x, and how the conclusion fails.
fn functions(goal: &Goal, finding: Finding, f: &Functions, fuel: &Fuel) -> Checked {
    // Every symbol in question but x has an expression: in x if it is a function of x, else closed.
    let outer = scope(goal, fuel.clone())?;
    let vars = &goal.context.vars;
    let others = outer.mentioned.iter().filter(|v| **v != f.var);
    if !f.values.iter().map(|(v, _)| v).eq(others) || limits(goal).any(|l| l.var != f.var) {
        return Err(Rejection::NotConstant);
    }
    let explicit = |v: usize, e: &Expr| {
        let of_x = vars.get(v).is_some_and(|var| var.of == Some(f.var));
        is_explicit(e, &|w| of_x && w == f.var)
    };
    if f.values.iter().any(|(v, e)| !explicit(*v, e)) {
        return Err(Rejection::NotConstant);
    }
    if f.premises.len() != goal.hypotheses.len() || f.ranges.len() != f.values.len() {
        return Err(Rejection::CaseCount(goal.hypotheses.len(), f.premises.len()));
    }
    // What premises say of x alone narrows its domain; they are proved on that domain.
    let domain = on_functions(&outer, goal, f.var, &f.values);
    let on_domain =
        |conclusion, when: &[Relation]| Goal { conclusion, when: when.to_vec(), ..domain.clone() };
    let holds = |h: &Hypothesis, proof: &Proof| {
        // The premise is only named here so that its roots are known; it may not prove itself.
        let goal = on_domain(Conclusion::NotImplied(h.sentence.clone()), &[]);
        let scope = scope(&goal, fuel.clone())?;
        let fails = scope.premise(&h.sentence, h.given, false)?;
        let passages = Passages::Nowhere;
        State { passages, ..point_state(&scope, &goal, Some(fails))? }.refute(proof)
    };
    let tends = |l: Limit, when: &[Relation], proofs: &[SideProof]| {
        let goal = on_domain(Conclusion::Link(Link::Limit(l.clone())), when);
        let scope = scope(&goal, fuel.clone())?;
        // With explicit functions there is nothing that a passage could add.
        let state = State { passages: Passages::Nowhere, ..constants(&scope, &goal, l.var)? };
        from_all_sides(&state, &l, proofs)
    };
    for ((v, _), proof) in f.values.iter().zip(&f.ranges) {
        holds(&range_premise(&goal.context, *v), proof)?;
    }
    for (h, (proof, limits)) in goal.hypotheses.iter().zip(&f.premises) {
        holds(h, proof)?;
        let wanted = h.sentence.limits().count();
        if wanted != limits.len() {
            return Err(Rejection::CaseCount(wanted, limits.len()));
        }
        h.sentence.limits().zip(limits).try_for_each(|(l, p)| tends(l.clone(), &[], p))?;
    }
    match (&f.failure, &goal.conclusion, finding) {
        (Failure::At(point), _, Finding::Consistent) => {
            holds_at(&on_domain(Conclusion::Contradiction, &goal.when), finding, point, fuel)
        }
        (Failure::At(point), conclusion, _) => {
            holds_at(&on_domain(conclusion.clone(), &goal.when), finding, point, fuel)
        }
        (Failure::Reaches(proofs), Conclusion::Link(Link::Limit(l)), Finding::Consistent) => {
            let subjects: Vec<_> = expressions(&goal.when, &[]).collect();
            let scope = Scope::new(&domain.context, &subjects, fuel.clone())?;
            applies(&scope, &goal.when)?;
            let zero = Limit { expr: Expr::int(0), to: Target::Finite(Expr::int(0)), ..l.clone() };
            tends(zero, &goal.when, proofs)
        }
        (Failure::Limit { link, target, proof, apart }, Conclusion::Link(_), Finding::Refuted)
        | (
            Failure::Limit { link, target, proof, apart },
            Conclusion::NotImplied(_),
            Finding::Proved,
        ) => {
            let Some(Link::Limit(claimed)) = goal.conclusion.links().get(*link) else {
                return Err(Rejection::WrongEvidence);
            };
            let found = Limit { to: target.clone(), ..claimed.clone() };
            tends(one_sided(&outer, &found, proof)?, &[], std::slice::from_ref(proof))?;
            let when = [&goal.when[..], goal.conclusion.when()].concat();
            let both = [Link::Limit(claimed.clone()), Link::Limit(found)];
            let subjects: Vec<_> = expressions(&when, &both).collect();
            let scope = Scope::new(&domain.context, &subjects, fuel.clone())?;
            applies(&scope, &when)?;
            let Some(proof) = apart else {
                let differ = differ(&scope, &claimed.to, target)?;
                return differ.then_some(()).ok_or(Rejection::NotAModel(None));
            };
            let unequal = unequal(&claimed.to, target).ok_or(Rejection::WrongEvidence)?;
            contradicts(&on_domain(unequal, &[]), Finding::Proved, proof, fuel)
        }
        _ => Err(Rejection::WrongEvidence),
    }
}

/// What is left of a goal with explicit functions of x for its symbols: no condition, nothing
/// claimed, and of its premises what narrows the domain of x.
#[must_use]
pub fn on_functions(scope: &Scope<'_>, goal: &Goal, x: usize, values: &[(usize, Expr)]) -> Goal {
    let narrowed = goal.hypotheses.iter().filter_map(|h| {
        let sentence = narrowing(scope, h, x);
        (!sentence.links.is_empty()).then_some(Hypothesis { sentence, given: true })
    });
    Goal {
        context: Context { values: values.to_vec(), ..goal.context.clone() },
        hypotheses: narrowed.collect(),
        behind: Vec::new(),
        when: Vec::new(),
        conclusion: Conclusion::Contradiction,
    }
}

/// «v is defined and within its range» as a premise.
#[must_use]
pub fn range_premise(context: &Context, v: usize) -> Hypothesis {
    let relation = |rel, rhs| Link::Relation(Relation { lhs: Expr::Var(v), rel, rhs });
    let end = |b: &Bound, strict, weak| {
        relation(if b.strict { strict } else { weak }, Expr::Num(b.value.clone()))
    };
    let var = &context.vars[v];
    let lower = var.lower.as_ref().map(|b| end(b, Rel::Gt, Rel::Ge));
    let upper = var.upper.as_ref().map(|b| end(b, Rel::Lt, Rel::Le));
    let links = [Some(relation(Rel::Eq, Expr::Var(v))), lower, upper].into_iter().flatten();
    Hypothesis { sentence: Sentence { when: Vec::new(), links: links.collect() }, given: true }
}

/// A limit from nothing but the side of a proof, if that is one of its sides.
fn one_sided(scope: &Scope<'_>, limit: &Limit, proof: &SideProof) -> Checked<Limit> {
    let side = &proof.germ.side;
    if !sides(scope, limit).contains(side) {
        return Err(Rejection::OutsideDomain);
    }
    Ok(Limit { at: side.approach(), ..limit.clone() })
}

/// Checks that conditions on closed expressions are visibly true.
fn applies(scope: &Scope<'_>, when: &[Relation]) -> Checked {
    let holds = scope.all(when)?.iter().all(|p| p.value == Some(true));
    holds.then_some(()).ok_or(Rejection::NotAModel(None))
}

/// That two closed targets differ, as a conclusion; of numbers only.
#[must_use]
pub fn unequal(claimed: &Target, found: &Target) -> Option<Conclusion> {
    let (Target::Finite(a), Target::Finite(b)) = (claimed, found) else {
        return None;
    };
    let differ = Relation { lhs: a.clone(), rel: Rel::Ne, rhs: b.clone() };
    Some(Conclusion::Link(Link::Relation(differ)))
}

/// Whether two closed targets are visibly different.
///
/// # Errors
/// [`Rejection::Budget`].
pub fn differ(scope: &Scope<'_>, claimed: &Target, found: &Target) -> Checked<bool> {
    let (Target::Finite(a), Target::Finite(b)) = (claimed, found) else {
        return Ok(std::mem::discriminant(claimed) != std::mem::discriminant(found));
    };
    let equal = scope.relation(&Relation { lhs: a.clone(), rel: Rel::Eq, rhs: b.clone() })?;
    Ok(equal.iter().all(|p| p.value != Some(true)))
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
