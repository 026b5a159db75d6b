//! Claims that explicit functions refute: they meet the premises on the whole domain, and the
//! conclusion fails at a point of it, or has another limit.

use std::cell::RefCell;

use kane_kernel::{
    Bound, Conclusion, Expr, Failure, Finding, Fuel, Functions, Goal, Hypothesis, Limit, Link,
    Point, Proof, Side, SideProof, State, Target, claim_state, constants, on_functions,
    point_state, range_premise, scope,
};
use num_rational::BigRational;
use num_traits::One;

use super::NotEmitted;
use super::family::{Claimed, Family, Role, Setting, side};
use super::prose::Prose;
use super::reify::Symbols;
use super::script::Writer;
use super::witness::{Witness, witness};

/// A proof that nothing asks for.
const NONE: &str = "(false, Absurd)";

/// A goal, and what is left of it with the functions in place of its symbols.
struct Model<'a, 'g> {
    family: &'a Family<'a, 'g>,
    functions: &'a Functions,
    domain: Goal,
    /// the sides from which limits are taken
    sides: RefCell<Vec<Side>>,
    /// for each of them, that it lies in the domain
    reaching: RefCell<Vec<(Side, String)>>,
}

/// The lemma `claim_NAME` and what it needs.
pub(super) fn lemma(
    name: &str,
    family: &Family<'_, '_>,
    finding: Finding,
    functions: &Functions,
) -> Result<String, NotEmitted> {
    if family.limits.iter().any(Option::is_none) {
        return Err(NotEmitted::Step("an infinite limit among premises that functions meet"));
    }
    // A declared range holds everywhere, but functions are known on the narrowed domain alone.
    let ranged = family.bound().1.iter().any(|v| !family.symbols.range(*v).is_empty());
    if ranged && !family.narrowing().is_empty() {
        return Err(NotEmitted::Step("functions in a declared range, known on a narrowed domain"));
    }
    let domain = on_functions(family.scope, family.goal, family.x, &functions.values);
    let model = Model {
        family,
        functions,
        domain,
        sides: RefCell::default(),
        reaching: RefCell::default(),
    };
    let data = model.data()?;
    let written = |v: usize| family.written(v);
    let prose = Prose { name: &written, symbols: &family.symbols };
    let (claim, says, failing) = match &functions.failure {
        Failure::At(point) => {
            let (claim, says) = family.pointwise(&prose, finding, &Setting::Narrowed)?;
            (claim, says, model.at(name, finding, point)?)
        }
        Failure::Limit { apart: Some(_), .. } => {
            return Err(NotEmitted::Step("limits that a proof tells apart"));
        }
        Failure::Limit { target, proof, .. } => {
            let limit = claimed(&family.goal.conclusion)
                .filter(|_| family.always_when)
                .ok_or(NotEmitted::Step("a limit beside other conclusions or conditions"))?;
            let all = family.claimed(limit)?;
            let says = family.tends(&prose, (&all.f, &all.to, &all.sides))?;
            ("Falsehood".to_owned(), says, model.limit(name, limit, all, target, proof)?)
        }
        Failure::Reaches(_) => return Err(NotEmitted::Step("a limit that is reached")),
    };
    let Failing { data: witness, theorem, check, arguments } = failing;
    let arguments = format!("goal_{name} functions_{name} {} {arguments}", model.used());
    let values = model.values(&prose)?;
    let reaching: Vec<String> = model.reaching.take().into_iter().map(|r| r.1).collect();
    Ok(format!(
        "{}Definition functions_{name} : functions := {data}\n  [{}].\n{witness}\
         Lemma claim_{name} : ~ (\n  {}).\n\
         Proof. intro H. exact ({theorem}\n    \
         (eq_refl true <: {check} {arguments} = true) (H{values})). Qed.\n",
        family.data(name, &claim)?,
        reaching.join(";\n   "),
        family.statement(&prose, &says, &Setting::Narrowed)?,
    ))
}

/// How the conclusion fails: what it needs, and the theorem that says so.
struct Failing {
    data: String,
    theorem: &'static str,
    check: &'static str,
    arguments: String,
}

/// The one limit that a goal concludes, or that is said not to follow.
fn claimed(conclusion: &Conclusion) -> Option<&Limit> {
    match (conclusion.when(), conclusion.links()) {
        ([], [Link::Limit(l)]) => Some(l),
        _ => None,
    }
}

impl Model<'_, '_> {
    /// Functions and proofs, as data.
    fn data(&self) -> Result<String, NotEmitted> {
        let f = self.functions;
        let (mut exprs, mut ranges, mut premises, mut limits) =
            (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        for &v in &self.family.symbols.order {
            let Some(i) = f.values.iter().position(|(w, _)| *w == v) else {
                exprs.push("(Var 0)".to_owned());
                ranges.push(NONE.to_owned());
                continue;
            };
            let hypothesis = range_premise(&self.family.goal.context, v);
            ranges.push(self.pointwise(&hypothesis, &f.ranges[i])?);
            exprs.push(self.expr(&f.values[i].1)?);
        }
        let hypotheses = self.family.goal.hypotheses.iter().zip(&self.family.roles);
        for ((h, role), (proof, tends)) in hypotheses.zip(&f.premises) {
            let speaks = h.sentence.relations().next().is_some();
            let asked = *role == Role::Along && speaks;
            premises.push(if asked { self.pointwise(h, proof)? } else { NONE.to_owned() });
            for (l, proofs) in h.sentence.limits().zip(tends) {
                limits.push(self.side_proofs(l, proofs)?);
            }
        }
        let mut narrowing = Vec::new();
        for h in self.family.narrowing() {
            narrowing.push(self.family.symbols.sentence(&h.sentence, h.given)?);
        }
        let lists =
            [exprs, ranges, premises, limits, narrowing].map(|l| format!("[{}]", l.join(";\n   ")));
        Ok(format!("Functions\n  {}", lists.join("\n  ")))
    }

    /// An expression in x, with the functions in it written out.
    fn expr(&self, e: &Expr) -> Result<String, NotEmitted> {
        let goal = self.with(Conclusion::Contradiction);
        let scope = scope(&goal, Fuel::new(u64::MAX))?;
        let symbols = Symbols::with(&scope, 0, Some(self.family.x))?;
        symbols.expr(&symbols.expand(e)?)
    }

    fn with(&self, conclusion: Conclusion) -> Goal {
        Goal { conclusion, ..self.domain.clone() }
    }

    /// A proof that a premise holds at each point of the domain, and if it uses the range of x.
    fn pointwise(&self, h: &Hypothesis, proof: &Proof) -> Result<String, NotEmitted> {
        let goal = self.with(Conclusion::NotImplied(h.sentence.clone()));
        let scope = scope(&goal, Fuel::new(u64::MAX))?;
        let symbols = Symbols::with(&scope, 0, Some(self.family.x))?;
        let fails = scope.premise(&h.sentence, h.given, false)?;
        let state = point_state(&scope, &goal, Some(fails))?;
        let script = Writer { symbols: &symbols, sides: None }.proof(&state, proof)?;
        Ok(format!("({}, {script})", scope.mentioned.contains(&self.family.x)))
    }

    /// Proofs that a limit is as it should be, each with its side.
    fn side_proofs(&self, limit: &Limit, proofs: &[SideProof]) -> Result<String, NotEmitted> {
        self.along(limit, proofs, |writer, state| writer.side_proofs(state, limit, proofs))
    }

    fn along(
        &self,
        limit: &Limit,
        proofs: &[SideProof],
        write: impl FnOnce(&Writer<'_>, &State<'_, '_>) -> Result<String, NotEmitted>,
    ) -> Result<String, NotEmitted> {
        let goal = self.with(Conclusion::Link(Link::Limit(limit.clone())));
        let scope = scope(&goal, Fuel::new(u64::MAX))?;
        let symbols = Symbols::with(&scope, 1, Some(self.family.x))?;
        let state = constants(&scope, &goal, self.family.x)?;
        let writer = Writer { symbols: &symbols, sides: Some(self.sides.take().into()) };
        let text = write(&writer, &state)?;
        for germ in proofs.iter().map(|p| &p.germ) {
            let mut reaching = self.reaching.borrow_mut();
            if !reaching.iter().any(|(side, _)| *side == germ.side) {
                let within = writer.within(&state, germ, self.family.narrowing().len())?;
                reaching.push((germ.side.clone(), within));
            }
        }
        self.sides.replace(writer.sides.map(RefCell::into_inner).unwrap_or_default());
        Ok(text)
    }

    fn used(&self) -> String {
        let sides: Vec<String> = self.sides.borrow().iter().map(side).collect();
        format!("[{}]", sides.join("; "))
    }

    /// The conclusion fails at a point.
    fn at(&self, name: &str, finding: Finding, point: &Point) -> Result<Failing, NotEmitted> {
        let x = self.family.x;
        let when = self.family.goal.when.clone();
        let goal = Goal { when, ..self.with(self.family.goal.conclusion.clone()) };
        let scope = scope(&goal, Fuel::new(u64::MAX))?;
        let symbols = Symbols::with(&scope, 1, Some(x))?;
        let state = claim_state(&scope, &goal, finding)?;
        let mut point = point.clone();
        if point.generator.is_some() {
            return Err(NotEmitted::Step("functions at an algebraic number"));
        }
        // Where nothing depends on x, any value in its range will do.
        if point.values.iter().all(|(v, _)| *v != x) {
            let var = &goal.context.vars[x];
            point.values.push((x, vec![within(var.lower.as_ref(), var.upper.as_ref())]));
        }
        let Witness { data, .. } = witness(&symbols, &state, &point)?;
        Ok(Failing {
            data: format!("Definition witness_{name} : witness := {data}.\n"),
            theorem: "point_refuted _ _ _ _",
            check: "refutes_point",
            arguments: format!("witness_{name}"),
        })
    }

    /// The limit is another one.
    fn limit(
        &self,
        name: &str,
        limit: &Limit,
        claimed: Claimed,
        target: &Target,
        proof: &SideProof,
    ) -> Result<Failing, NotEmitted> {
        let found = Limit { to: target.clone(), ..limit.clone() };
        let data = self.along(&found, std::slice::from_ref(proof), |writer, state| {
            writer.side_proof(state, &found, proof)
        })?;
        let to = match target {
            Target::Finite(v) => format!("(Finite {})", self.expr(v)?),
            other => self.family.symbols.target(other)?,
        };
        let sides: Vec<String> = claimed.sides.iter().map(side).collect();
        Ok(Failing {
            data: format!("Definition limit_{name} : side_proof :=\n  {data}.\n"),
            theorem: "limit_refuted _ _ _ _ _ _ _ _ _",
            check: "refutes_limit",
            arguments: format!(
                "{} {} [{}] {} {to} limit_{name}",
                self.family.symbols.expr(&claimed.f)?,
                claimed.target,
                sides.join("; "),
                side(&proof.germ.side)
            ),
        })
    }

    /// The functions as what the lemma is applied to.
    fn values(&self, prose: &Prose<'_>) -> Result<String, NotEmitted> {
        let (constants, functions) = self.family.bound();
        let mut text = String::new();
        for v in constants.iter().chain(&functions) {
            let value = self.functions.values.iter().find(|(w, _)| w == v);
            let value = prose.term(&value.ok_or(NotEmitted::Step("no value"))?.1)?;
            let x = self.family.symbols.name(self.family.x);
            text += &match functions.contains(v) {
                true => format!(" (fun {x} : R => {value})"),
                false => format!(" ({value})"),
            };
        }
        Ok(text)
    }
}

/// A number between two bounds.
fn within(lower: Option<&Bound>, upper: Option<&Bound>) -> BigRational {
    let one = BigRational::one();
    match (lower, upper) {
        (Some(a), Some(b)) => (&a.value + &b.value) / (&one + &one),
        (Some(a), None) => &a.value + one,
        (None, Some(b)) => &b.value - one,
        (None, None) => one,
    }
}
