//! Models by explicit functions: for goals with limits, where a point says too little.

use std::cell::OnceCell;
use std::rc::Rc;

use kane_algebra::syntax::rebuild;
use kane_kernel::{
    Atom, Bound, Conclusion, Context, Expr, Failure, Finding, Fuel, Functions, Goal, Hypothesis,
    Limit, Link, Passages, Place, Poly, Proof, Relation, Side, State, Target, Var, claim_state,
    constants, differ, on_functions, point_state, premises, range_premise, scope, sides, sign_at,
    unequal,
};
use num_rational::BigRational;

use super::asymptote;
use super::factors::linear_factors;
use super::limits;
use super::search::{Outcome, Search};
use super::variation::{determined, ratio};
use crate::argument::{expand, side_proof};

type Q = BigRational;

/// Sizes of the search.
#[derive(Clone, Debug)]
pub(crate) struct Effort {
    pub(crate) steps: u64,
    pub(crate) fuel: u64,
    pub(crate) candidates: usize,
    /// of which all is a part
    pub(crate) work: Fuel,
}

impl Effort {
    fn fuel(&self) -> Fuel {
        self.work.within(self.fuel)
    }
}

/// Functions that satisfy the premises and against which the conclusion fails as `finding` says.
pub(crate) fn model(
    goal: &Goal,
    finding: Finding,
    x: usize,
    by: &[(usize, Expr)],
    effort: &Effort,
) -> Option<Functions> {
    let scope = scope(goal, effort.fuel()).ok()?;
    // What the premises determine, off the limits.
    let formulas = premises(&scope, goal, Place::Point).ok()?;
    let count = goal.hypotheses.len();
    let atoms = scope.ranges();
    let state = State {
        scope: &scope,
        goal,
        atoms,
        formulas: Rc::new(formulas[..count].to_vec()),
        reaching: false,
        passages: Passages::Anywhere,
    };
    let fixed: Vec<usize> = by.iter().map(|b| b.0).chain([x]).collect();
    let may = |v: usize, _: &Poly| !fixed.contains(&v) && v < goal.context.vars.len();
    let search = Search::new(effort.steps, &may, false);
    let (rest, trail) = search.reduced(&state)?;
    let free: Vec<usize> = (0..goal.context.vars.len())
        .filter(|v| !fixed.contains(v) && !trail.iter().any(|e| e.var == *v))
        .collect();
    // Only symbols that the premises or the conclusion mention are worth varying.
    let mut used: Vec<usize> =
        rest.atoms.iter().filter(|a| a.poly.vars().len() > 1).flat_map(|a| a.poly.vars()).collect();
    used.extend(trail.iter().flat_map(|e| [e.d.vars(), e.e.vars()].concat()));
    used.extend(mentioned(goal));
    // what the claim's condition says without cases
    let when = formulas.last().filter(|cases| cases.len() == 1).and_then(|cases| cases.first());
    let known: Vec<Atom> = rest.atoms.iter().chain(when.into_iter().flatten()).cloned().collect();
    let functions = OnceCell::new();
    let of_x = || functions.get_or_init(|| simple_functions(x)).clone();
    let candidates = |v: &usize| {
        let simple = candidates(&goal.context, *v, x, used.contains(v), &of_x);
        let of_x = goal.context.vars.get(*v).is_some_and(|var| var.of == Some(x));
        if of_x { [roots(&rest, *v, x), simple].concat() } else { admitted(&known, *v, simple) }
    };
    let lists: Vec<Vec<Rc<Expr>>> = free.iter().map(candidates).collect();
    let tries = super::diagonal::diagonal(&lists, effort.candidates);
    for choice in tries {
        let mut values: Vec<(usize, Expr)> = by.to_vec();
        values.extend(free.iter().copied().zip(choice.iter().map(|e| Expr::clone(e))));
        // A quotient may have poles where the premises are silent: there any value will do.
        let put = |total| determined(&state, (x, &[]), values.clone(), &trail, total);
        let quotients = put(false);
        let anywhere = put(true).filter(|v| quotients.as_ref() != Some(v));
        for mut values in quotients.into_iter().chain(anywhere) {
            values.retain(|(symbol, _)| scope.mentioned.contains(symbol));
            let found = certified(goal, finding, x, values, effort);
            if found.is_some() {
                return found;
            }
        }
    }
    None
}

/// The numbers among candidates for a constant that what is known of it alone admits, if there are any.
fn admitted(known: &[Atom], v: usize, candidates: Vec<Rc<Expr>>) -> Vec<Rc<Expr>> {
    let alone = known.iter().filter(|a| a.poly.vars() == [v]);
    let tests: Vec<_> = alone.filter_map(|a| Some((a.sign, a.poly.univariate(v)?))).collect();
    let admits = |e: &Rc<Expr>| match &**e {
        Expr::Num(q) => tests.iter().all(|(sign, p)| sign.admits(sign_at(p, q))),
        _ => true,
    };
    let some: Vec<_> = candidates.iter().filter(|e| admits(e)).cloned().collect();
    if some.is_empty() { candidates } else { some }
}

/// What equations of degree two in a function say that it may be, as functions of x, and what is never negative.
fn roots(state: &State<'_, '_>, v: usize, x: usize) -> Vec<Rc<Expr>> {
    let fuel = &state.scope.fuel;
    let factors = state.atoms.iter().flat_map(|atom| linear_factors(atom, v, fuel));
    let of_x = factors.filter(|p| p.vars().iter().all(|w| [v, x].contains(w)));
    let root = |p: Poly| ratio(&p.coefficient(v, 0).neg(), &p.coefficient(v, 1));
    let roots: Vec<Expr> = of_x.map(root).collect();
    let magnitudes = roots.clone().into_iter().map(|root| Expr::Abs(root.into()));
    roots.into_iter().chain(magnitudes).map(Rc::new).collect()
}

/// Symbols in the conclusion and in the `when`.
fn mentioned(goal: &Goal) -> Vec<usize> {
    let mut todo: Vec<&Expr> = goal.when.iter().flat_map(|r| [&r.lhs, &r.rhs]).collect();
    let links: &[Link] = match &goal.conclusion {
        Conclusion::Link(l) => std::slice::from_ref(l),
        Conclusion::NotImplied(s) => &s.links,
        Conclusion::Contradiction => &[],
    };
    for link in links.iter().chain(goal.hypotheses.iter().flat_map(|h| &h.sentence.links)) {
        match link {
            Link::Relation(r) => todo.extend([&r.lhs, &r.rhs]),
            Link::Limit(l) => todo.push(&l.expr),
        }
    }
    let (mut out, mut lets) = (Vec::new(), Vec::new());
    while let Some(e) = todo.pop() {
        match e {
            Expr::Var(v) if !out.contains(v) => out.push(*v),
            Expr::Let(i) if !lets.contains(i) => {
                lets.push(*i);
                todo.extend(goal.context.lets.get(*i).map(|d| &d.body));
            }
            _ => {}
        }
        todo.extend(e.children());
    }
    out
}

/// Möbius and quadratic functions of x with small coefficients, constants first.
fn simple_functions(x: usize) -> Vec<Rc<Expr>> {
    let quadratic = |(a, b, c): Quadratic| Poly::in_variable(x, &[a.into(), b.into(), c.into()]);
    FUNCTIONS.iter().map(|&(n, d)| ratio(&quadratic(n), &quadratic(d)).into()).collect()
}

/// Simple expressions for a free symbol: functions of x, or constants in its range.
fn candidates(
    context: &Context,
    v: usize,
    x: usize,
    varied: bool,
    functions: &dyn Fn() -> Vec<Rc<Expr>>,
) -> Vec<Rc<Expr>> {
    let var = &context.vars[v];
    let inside = |q: &Q| is_within(var, q);
    if varied && var.of == Some(x) {
        return functions();
    }
    let mut out: Vec<Rc<Expr>> = NUMBERS
        .iter()
        .map(|&(n, d)| Q::new_raw(n.into(), d.into()))
        .filter(inside)
        .map(|q| Expr::Num(q).into())
        .collect();
    if out.is_empty() {
        let ends = (var.lower.as_ref(), var.upper.as_ref());
        let middle = kane_algebra::sign_table::simplest_between(
            ends.0.map(|b| &b.value),
            ends.1.map(|b| &b.value),
        );
        out.push(Expr::Num(middle).into());
    }
    if !varied {
        out.truncate(1);
    }
    out
}

/// Values for constants in lowest terms, simplest first.
const NUMBERS: [(i64, i64); 10] =
    [(1, 1), (2, 1), (1, 2), (0, 1), (-1, 1), (3, 1), (1, 3), (-2, 1), (1, 4), (3, 4)];

/// Times that roots are looked for which a limit needs.
const NESTED: usize = 3;

/// A quadratic polynomial a + b·x + c·x².
type Quadratic = (i64, i64, i64);

/// Functions of x as quotients: constants, then what tends to 0, ±1 or ∞ at the ends of the line,
/// most of it without real poles.
const FUNCTIONS: [(Quadratic, Quadratic); 30] = [
    ((1, 0, 0), (1, 0, 0)),
    ((0, 0, 0), (1, 0, 0)),
    ((-1, 0, 0), (1, 0, 0)),
    ((1, 0, 0), (1, 1, 0)),
    ((1, -1, 0), (1, 1, 0)),
    ((0, 1, 0), (1, 0, 1)),
    ((1, 0, 0), (1, 0, 1)),
    ((0, 1, 0), (1, 0, 0)),
    ((1, 0, -1), (1, 0, 1)),
    ((1, -1, -1), (1, 1, 1)),
    ((1, 1, 0), (1, 1, 1)),
    ((1, -2, 0), (1, 2, 0)),
    ((1, 0, 0), (1, 2, 0)),
    ((0, 1, 0), (1, 1, 0)),
    ((1, -2, 0), (1, 0, 0)),
    ((2, 0, 0), (1, 0, 0)),
    ((1, 0, 0), (2, 0, 0)),
    ((2, 0, 0), (2, 1, 0)),
    ((1, -3, 0), (1, 3, 0)),
    ((1, 0, 0), (1, 3, 0)),
    ((2, -1, 0), (2, 1, 0)),
    ((0, -1, 0), (1, 1, 0)),
    ((0, 2, 0), (1, 1, 0)),
    ((1, 0, -1), (1, 1, 1)),
    ((1, 2, 0), (1, 2, 2)),
    ((1, -2, 1), (1, 0, 1)),
    ((0, -2, 0), (1, 0, 1)),
    ((-2, 0, 0), (1, 0, 0)),
    ((3, 0, 0), (1, 0, 0)),
    ((1, 0, 0), (0, 1, 0)),
];

/// Proofs of all that explicit functions must satisfy, if they do.
fn certified(
    goal: &Goal,
    finding: Finding,
    x: usize,
    values: Vec<(usize, Expr)>,
    effort: &Effort,
) -> Option<Functions> {
    let constant = |v: usize, e: &Expr| goal.context.vars[v].of == Some(x) || !mentions(e, x);
    if !values.iter().all(|(v, e)| constant(*v, e)) {
        return None;
    }
    let outer = scope(goal, effort.fuel()).ok()?;
    let domain = on_functions(&outer, goal, x, &values);
    let bare = |conclusion, when| Goal { conclusion, when, ..domain.clone() };
    let premise = |h: &Hypothesis| -> Option<Proof> {
        let goal = bare(Conclusion::NotImplied(h.sentence.clone()), Vec::new());
        let scope = scope(&goal, effort.fuel()).ok()?;
        let fails = scope.premise(&h.sentence, h.given, false).ok()?;
        closed(&point_state(&scope, &goal, Some(fails)).ok()?, effort)
    };
    let limit = |l: &Limit| {
        let goal = bare(Conclusion::Link(Link::Limit(l.clone())), Vec::new());
        let scope = scope(&goal, effort.fuel()).ok()?;
        let state = constants(&scope, &goal, l.var).ok()?;
        if sides(&scope, l).iter().any(|side| limits::misses(&state, l, side, effort.steps)) {
            return None;
        }
        let arguments = limits::from_all_sides(&state, l, effort.steps)?;
        arguments.iter().map(|a| side_proof(&state, l, a).ok()).collect::<Option<Vec<_>>>()
    };
    // What holds at points is less work than limits.
    let proofs = goal.hypotheses.iter().map(premise).collect::<Option<Vec<Proof>>>()?;
    let limits = |h: &Hypothesis| h.sentence.limits().map(limit).collect::<Option<Vec<_>>>();
    let limits = goal.hypotheses.iter().map(limits).collect::<Option<Vec<_>>>()?;
    let premises = proofs.into_iter().zip(limits).collect();
    let ranges: Option<Vec<Proof>> =
        values.iter().map(|(v, _)| premise(&range_premise(&goal.context, *v))).collect();
    let failure = failure(goal, finding, x, &bare, effort)?;
    Some(Functions { var: x, values, ranges: ranges?, premises, failure })
}

/// A proof that no point satisfies a state, if the search finds one.
fn closed(state: &State<'_, '_>, effort: &Effort) -> Option<Proof> {
    match Search::new(effort.steps, &|_: usize, _: &Poly| true, false).solve(state) {
        Outcome::Closed(argument) => expand(state, &argument).ok(),
        _ => None,
    }
}

fn mentions(e: &Expr, x: usize) -> bool {
    let mut todo = vec![e];
    while let Some(e) = todo.pop() {
        if *e == Expr::Var(x) {
            return true;
        }
        todo.extend(e.children());
    }
    false
}

/// That a limit that was found is another one than is claimed, for the values in place: by a proof, if it is not visible.
fn apart(
    claimed: &Target,
    found: &Target,
    bare: &dyn Fn(Conclusion, Vec<Relation>) -> Goal,
    effort: &Effort,
) -> Option<Option<Proof>> {
    let Some(unequal) = unequal(claimed, found) else {
        return (claimed != found).then_some(None);
    };
    let goal = bare(unequal, Vec::new());
    let scope = scope(&goal, effort.fuel()).ok()?;
    if differ(&scope, claimed, found).ok()? {
        return Some(None);
    }
    closed(&claim_state(&scope, &goal, Finding::Proved).ok()?, effort).map(Some)
}

/// What a limit is from one side, if that is a number in roots of numbers: those that the scope lacks are named in the
/// target of a limit that is only looked at.
fn irrational(
    claimed: &Limit,
    side: &Side,
    bare: &dyn Fn(Conclusion, Vec<Relation>) -> Goal,
    effort: &Effort,
) -> Option<Target> {
    let mut roots = Expr::int(0);
    for _ in 0..NESTED {
        let probe = Limit { to: Target::Finite(roots.clone()), ..claimed.clone() };
        let goal = bare(Conclusion::Link(Link::Limit(probe.clone())), Vec::new());
        let scope = scope(&goal, effort.fuel()).ok()?;
        let state = constants(&scope, &goal, probe.var).ok()?;
        match asymptote::value(&state, &probe, side) {
            Ok(Target::Finite(number)) => {
                return with_values(&number, &goal.context.values).map(Target::Finite);
            }
            Ok(infinite) => return Some(infinite),
            Err(missing) if missing.is_empty() => return None,
            Err(missing) => {
                for q in missing {
                    roots = Expr::Add(roots.into(), Expr::Sqrt(Expr::Num(q).into()).into());
                }
            }
        }
    }
    None
}

/// A number with values in the place of symbols, if nothing else is left in it.
fn with_values(number: &Expr, values: &[(usize, Expr)]) -> Option<Expr> {
    let mut put = |e: &Expr| match e {
        Expr::Var(v) => {
            let value = values.iter().find(|(w, _)| w == v).map(|(_, value)| value.clone());
            value.filter(|value| matches!(value, Expr::Num(_))).map(Some).ok_or(())
        }
        Expr::Let(_) => Err(()),
        _ => Ok(None),
    };
    rebuild(number, &mut put).ok()
}

/// How the conclusion fails for explicit functions.
fn failure(
    goal: &Goal,
    finding: Finding,
    x: usize,
    bare: &dyn Fn(Conclusion, Vec<Relation>) -> Goal,
    effort: &Effort,
) -> Option<Failure> {
    let links: &[Link] = match &goal.conclusion {
        Conclusion::Link(l) => std::slice::from_ref(l),
        Conclusion::NotImplied(s) => &s.links,
        Conclusion::Contradiction => &[],
    };
    let limit = links.iter().position(|l| matches!(l, Link::Limit(_)));
    if let (Some(index), true) = (limit, finding != Finding::Consistent) {
        let Link::Limit(claimed) = &links[index] else {
            return None;
        };
        let goal = bare(Conclusion::Link(Link::Limit(claimed.clone())), Vec::new());
        let scope = scope(&goal, effort.fuel()).ok()?;
        let state = constants(&scope, &goal, claimed.var).ok()?;
        for side in sides(&scope, claimed) {
            let found = limits::value(&state, claimed, &side, effort.steps);
            let Some(target) = found.or_else(|| irrational(claimed, &side, bare, effort)) else {
                continue;
            };
            let Some(apart) = apart(&claimed.to, &target, bare, effort) else {
                continue;
            };
            let found = Limit { to: target.clone(), at: side.approach(), ..claimed.clone() };
            let goal = bare(Conclusion::Link(Link::Limit(found.clone())), Vec::new());
            let scope = kane_kernel::scope(&goal, effort.fuel()).ok()?;
            let state = constants(&scope, &goal, found.var).ok()?;
            let argument = limits::one_side(&state, &found, &side, effort.steps)?;
            let proof = side_proof(&state, &found, &argument).ok()?;
            return Some(Failure::Limit { link: index, target, proof, apart: apart.map(Box::new) });
        }
        return None;
    }
    if let (Finding::Consistent, Conclusion::Link(Link::Limit(l))) = (finding, &goal.conclusion) {
        let zero = Limit { expr: Expr::int(0), to: Target::Finite(Expr::int(0)), ..l.clone() };
        let outer = scope(goal, effort.fuel()).ok()?;
        let reaches = |side: kane_kernel::Side| {
            let trivial = Limit { at: side.approach(), ..zero.clone() };
            let goal = bare(Conclusion::Link(Link::Limit(trivial.clone())), goal.when.clone());
            let scope = scope(&goal, effort.fuel()).ok()?;
            let state = constants(&scope, &goal, l.var).ok()?;
            let argument = limits::one_side(&state, &trivial, &side, effort.steps)?;
            side_proof(&state, &trivial, &argument).ok()
        };
        let proofs: Option<Vec<_>> = sides(&outer, &zero).into_iter().map(reaches).collect();
        return proofs.map(Failure::Reaches);
    }
    let conclusion = match finding {
        Finding::Consistent => Conclusion::Contradiction,
        _ => goal.conclusion.clone(),
    };
    let goal = bare(conclusion, goal.when.clone());
    let scope = scope(&goal, effort.fuel()).ok()?;
    let state = claim_state(&scope, &goal, finding).ok()?;
    let any = |_: usize, _: &Poly| true;
    match Search::new(effort.steps, &any, true).solve(&state) {
        Outcome::Model(mut point) => {
            point.values.retain(|(v, _)| *v == x || *v >= goal.context.vars.len());
            Some(Failure::At(point))
        }
        _ => None,
    }
}

/// Whether a number is within the declared bounds of a symbol.
pub(super) fn is_within(var: &Var, q: &Q) -> bool {
    let above = |b: &Bound| if b.strict { *q > b.value } else { *q >= b.value };
    let below = |b: &Bound| if b.strict { *q < b.value } else { *q <= b.value };
    var.lower.as_ref().is_none_or(above) && var.upper.as_ref().is_none_or(below)
}
