//! Certificates in words: each step as a sentence that a person can check on paper.

use kane_algebra::syntax::{Evaluator, NoValue, Notation};
use kane_kernel::{
    Atom, Conclusion, Expr, Failure, Finding, Fuel, Functions, Goal, Link, Model, Point, Poly,
    Proof, Scope, Side, Sign, State, Target, claim_state, constants, expressions, premised, scope,
    sides,
};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use crate::Step;
use crate::argument::{Argument, Course, Grounds, Passage, Rules as _, SideArgument};
use crate::prove::expression;

type Q = BigRational;

/// Work that one explanation may take.
const FUEL: u64 = 400_000_000;
/// Lines after which an explanation is cut.
const MAX_LINES: usize = 600;

/// A certificate told.
pub(crate) struct Told {
    /// one sentence
    pub(crate) reason: String,
    /// step by step
    pub(crate) steps: Vec<Step>,
    /// indices of the hypotheses that were used
    pub(crate) used: Vec<usize>,
}

/// Tells the grounds of an accepted finding about a goal whose hypotheses have these labels.
pub(crate) fn grounds(goal: &Goal, finding: Finding, grounds: &Grounds, labels: &[&str]) -> Told {
    let mut teller =
        Teller { goal, labels, steps: Vec::new(), used: Vec::new(), rules: Rules::default() };
    let reason = match scope(goal, Fuel::new(FUEL)) {
        Err(_) => "accepted".to_string(),
        Ok(scope) => match grounds {
            Grounds::Contradiction(course) => {
                if let Ok(state) = claim_state(&scope, goal, finding) {
                    teller.open(finding);
                    teller.course(&state, course, 1);
                }
                teller.rules.sentence(finding)
            }
            Grounds::Limit(arguments) => teller.limit(&scope, arguments),
            Grounds::Model(Model::Point(point)) => teller.point(finding, point),
            Grounds::Model(Model::Functions(f)) => teller.functions(finding, f),
        },
    };
    let Teller { steps, mut used, .. } = teller;
    used.sort_unstable();
    used.dedup();
    Told { reason, steps, used }
}

/// A model as names and values, only of the symbols that the goal mentions.
pub(crate) fn model(goal: &Goal, model: &Model) -> Vec<(String, String)> {
    let shown = mentioned(goal, true);
    let name = |v: &usize| goal.context.vars[*v].name.clone();
    match model {
        Model::Point(p) => {
            let values = shown.iter().filter_map(|v| Some((name(v), value(p, *v)?)));
            values.collect()
        }
        Model::Functions(f) => {
            let values = f.values.iter().filter(|(v, _)| shown.contains(v));
            values.map(|(v, e)| (name(v), e.plain(&goal.context))).collect()
        }
    }
}

/// Which rules a proof used.
#[derive(Default)]
struct Rules {
    substituted: Vec<String>,
    tables: Vec<String>,
    signs: bool,
    sums: bool,
    limits: bool,
    splits: usize,
}

impl Rules {
    fn sentence(&self, finding: Finding) -> String {
        let mut parts = Vec::new();
        if self.limits {
            parts.push("passage to the limit".to_string());
        }
        if !self.substituted.is_empty() {
            let names = if self.substituted.len() > 4 {
                format!("{} solved premises", self.substituted.len())
            } else {
                self.substituted.join(", ")
            };
            parts.push(format!("substituting {names}"));
        }
        if !self.tables.is_empty() {
            parts.push(format!("sign table in {}", self.tables.join(", ")));
        }
        if self.sums {
            parts.push("a sum of non-negative terms".to_string());
        }
        if self.signs {
            parts.push("signs of coefficients".to_string());
        }
        let how = if parts.is_empty() {
            "directly".to_string()
        } else {
            format!("by {}", parts.join("; "))
        };
        match finding {
            Finding::Vacuous => format!("the hypotheses contradict each other, {how}"),
            Finding::Refuted => format!("it does follow, {how}"),
            _ => how,
        }
    }
}

struct Teller<'a> {
    goal: &'a Goal,
    labels: &'a [&'a str],
    steps: Vec<Step>,
    used: Vec<usize>,
    rules: Rules,
}

impl Teller<'_> {
    fn say(&mut self, depth: usize, text: String) {
        match self.steps.len().cmp(&MAX_LINES) {
            std::cmp::Ordering::Less => self.steps.push(Step { depth, text }),
            std::cmp::Ordering::Equal => {
                let text = "(the rest of this proof is left out here)".to_string();
                self.steps.push(Step { depth: 0, text });
            }
            std::cmp::Ordering::Greater => {}
        }
    }

    fn open(&mut self, finding: Finding) {
        let text = match finding {
            Finding::Vacuous => "Suppose that all hypotheses hold. This is contradictory:",
            _ => "Suppose that the hypotheses hold and the claim does not. This is contradictory:",
        };
        self.say(0, text.to_string());
    }

    fn name(&self, scope: &Scope<'_>, v: usize) -> String {
        if let Some(var) = self.goal.context.vars.get(v) {
            return var.name.clone();
        }
        if let Some(root) = scope.root(v) {
            return root.plain(&self.goal.context);
        }
        match v.checked_sub(scope.germ() + 1) {
            None => "t".to_string(),
            Some(i) => match premised(self.goal).nth(i) {
                Some((_, l)) => format!("[{}]", l.expr.plain(&self.goal.context)),
                None => format!("z{i}"),
            },
        }
    }

    fn poly(&self, scope: &Scope<'_>, p: &Poly) -> String {
        if p.len() > 40 {
            return format!("(a polynomial with {} terms)", p.len());
        }
        let top = p.vars().last().map_or(0, |v| v + 1);
        let mut context = kane_kernel::Context::default();
        for v in 0..top {
            context.vars.push(kane_kernel::Var {
                name: self.name(scope, v),
                of: None,
                lower: None,
                upper: None,
            });
        }
        expression(p).plain(&context)
    }

    fn atom(&self, scope: &Scope<'_>, a: &Atom) -> String {
        // One side each for the positive and the negative terms reads best.
        let (mut left, mut right) = (Poly::default(), Poly::default());
        for (m, c) in a.poly.terms() {
            if c.is_negative() {
                right.add_term(m.clone(), -c);
            } else {
                left.add_term(m.clone(), c.clone());
            }
        }
        let relation = match a.sign {
            Sign::Zero => "=",
            Sign::NonZero => "!=",
            Sign::NonNegative => ">=",
            Sign::Positive => ">",
        };
        format!("{} {relation} {}", self.poly(scope, &left), self.poly(scope, &right))
    }

    fn atoms(&self, scope: &Scope<'_>, atoms: &[Atom]) -> String {
        if atoms.is_empty() {
            return "nothing more".to_string();
        }
        let all: Vec<String> = atoms.iter().map(|a| self.atom(scope, a)).collect();
        all.join(", ")
    }

    /// What a formula stands for.
    fn formula(&mut self, i: usize) -> String {
        let (hypotheses, limits) = (self.goal.hypotheses.len(), premised(self.goal).count());
        if i < hypotheses {
            self.used.push(i);
            return match self.labels.get(i) {
                Some(label) => (*label).to_string(),
                None => "a given behind the cited claims".to_string(),
            };
        }
        if i < hypotheses + limits {
            let mut index = i - hypotheses;
            for (h, hypothesis) in self.goal.hypotheses.iter().enumerate() {
                for l in &hypothesis.sentence.links {
                    if matches!(l, Link::Limit(_)) {
                        if index == 0 {
                            self.used.push(h);
                            let label = self.labels.get(h).copied().unwrap_or("a given");
                            return format!("the limit in {label}");
                        }
                        index -= 1;
                    }
                }
            }
        }
        if i == hypotheses + limits {
            return "the condition of the claim".to_string();
        }
        "the claim fails".to_string()
    }

    fn walk(&mut self, state: &State<'_, '_>, argument: &Argument, depth: usize) {
        let scope = state.scope;
        match argument {
            Argument::Absurd(i) => {
                let text = match state.atoms.get(*i) {
                    Some(a) => format!("{} is false.", self.atom(scope, a)),
                    None => "Contradiction.".to_string(),
                };
                self.say(depth, text);
            }
            Argument::Assume { formula, cases } => {
                let what = self.formula(*formula);
                let Ok(states) = state.assume(*formula) else {
                    return;
                };
                let new = |s: &State<'_, '_>| s.atoms[state.atoms.len()..].to_vec();
                if let ([next], [then]) = (&states[..], &cases[..]) {
                    if !new(next).is_empty() {
                        let text = format!("{what}: {}.", self.atoms(scope, &new(next)));
                        self.say(depth, text);
                    }
                    return self.walk(next, then, depth);
                }
                self.say(depth, format!("{what}: one of {} cases.", cases.len()));
                for (i, (next, then)) in states.iter().zip(cases).enumerate() {
                    let text = format!("Case {}: {}.", i + 1, self.atoms(scope, &new(next)));
                    self.say(depth + 1, text);
                    self.walk(next, then, depth + 2);
                }
            }
            Argument::Split { poly, zero, positive, negative } => {
                let cases = [&**zero, positive, negative];
                self.split(state, poly, depth, &mut |teller, state, i| {
                    teller.walk(state, cases[i], depth + 2);
                });
            }
            Argument::Substitute { equation, var, lead, then } => {
                let Ok(next) = state.substitute(*equation, *var, lead) else {
                    return;
                };
                let name = self.name(scope, *var);
                let parts = state.atoms[*equation].poly.coefficients(*var);
                let solved = match &parts[..] {
                    [e, d] => {
                        let (num, den) = (e.neg(), d.clone());
                        match den.as_constant() {
                            Some(c) if c.is_one() => self.poly(scope, &num),
                            Some(c) if (-&c).is_one() => self.poly(scope, &num.neg()),
                            _ => {
                                format!("({})/({})", self.poly(scope, &num), self.poly(scope, &den))
                            }
                        }
                    }
                    _ => String::new(),
                };
                let text = if solved.is_empty() {
                    // of higher degree: powers are reduced, the variable stays
                    let by = self.atom(scope, &state.atoms[*equation]);
                    format!("Reduce powers of {name} by {by}.")
                } else {
                    format!("Substitute {name} = {solved}.")
                };
                self.say(depth, text);
                if !self.rules.substituted.contains(&name) {
                    self.rules.substituted.push(name);
                }
                let changed: Vec<Atom> = next
                    .atoms
                    .iter()
                    .zip(&state.atoms)
                    .filter(|(new, old)| new != old && new.decided() != Some(true))
                    .map(|(new, _)| new.clone())
                    .collect();
                if !changed.is_empty() {
                    let text = format!("This leaves {}.", self.atoms(scope, &changed));
                    self.say(depth, text);
                }
                self.walk(&next, then, depth);
            }
            Argument::Cancel { atom, factors, quotient, then } => {
                let Ok(next) = state.cancel(*atom, factors, quotient) else {
                    return;
                };
                let by: Vec<String> = factors
                    .iter()
                    .map(|(i, n)| {
                        let p = self.poly(scope, &state.atoms[*i].poly);
                        if *n == 1 { p } else { format!("({p})^{n}") }
                    })
                    .collect();
                let text = format!(
                    "Divide {} by {}, which cannot vanish: {}.",
                    self.atom(scope, &state.atoms[*atom]),
                    by.join(" and "),
                    self.atom(scope, &next.atoms[*atom])
                );
                self.say(depth, text);
                self.walk(&next, then, depth);
            }
            Argument::Positive { terms, cofactors } => {
                self.rules.sums = true;
                let mut parts = Vec::new();
                for t in terms {
                    let mut factors = Vec::new();
                    if !t.weight.is_one() {
                        factors.push(t.weight.to_string());
                    }
                    if t.square != Poly::one() {
                        factors.push(format!("({})^2", self.poly(scope, &t.square)));
                    }
                    for (i, n) in &t.factors {
                        let p = self.poly(scope, &state.atoms[*i].poly);
                        factors.push(if *n == 1 { format!("({p})") } else { format!("({p})^{n}") });
                    }
                    parts.push(if factors.is_empty() {
                        "1".to_string()
                    } else {
                        factors.join("*")
                    });
                }
                for (i, c) in cofactors {
                    let (c, p) = (self.poly(scope, c), self.poly(scope, &state.atoms[*i].poly));
                    parts.push(format!("({c})*[{p}]"));
                }
                let text = format!(
                    "{} is 0 identically, yet it is a sum of non-negative terms, one of them positive{}.",
                    parts.join(" + "),
                    if cofactors.is_empty() { "" } else { " (brackets vanish)" }
                );
                self.say(depth, text);
            }
            Argument::Orthant { atom, bounds } => {
                self.rules.signs = true;
                let shown: Vec<String> = bounds
                    .iter()
                    .flat_map(|(_, l, u)| [*l, *u])
                    .flatten()
                    .map(|i| self.atom(scope, &state.atoms[i]))
                    .collect();
                let text = format!(
                    "{} contradicts {}: measured from these bounds, all its coefficients have the other sign.",
                    self.atom(scope, &state.atoms[*atom]),
                    shown.join(", ")
                );
                self.say(depth, text);
            }
            Argument::SignTable { var, roots, atoms, .. } => {
                let name = self.name(scope, *var);
                let shown: Vec<String> =
                    atoms.iter().map(|(i, ..)| self.atom(scope, &state.atoms[*i])).collect();
                let cuts: Vec<String> = roots.iter().map(root_text).collect();
                let where_ = if cuts.is_empty() {
                    "without a root".to_string()
                } else {
                    format!("cut at {}", cuts.join(", "))
                };
                self.say(
                    depth,
                    format!(
                        "On the line of {name}, {where_}, no part satisfies {}.",
                        shown.join(", ")
                    ),
                );
                if !self.rules.tables.contains(&name) {
                    self.rules.tables.push(name);
                }
            }
        }
    }

    /// The three signs of a polynomial: zero, positive, negative.
    fn split<'s, 'g>(
        &mut self,
        state: &State<'s, 'g>,
        poly: &Poly,
        depth: usize,
        then: &mut dyn FnMut(&mut Self, &State<'s, 'g>, usize),
    ) {
        self.rules.splits += 1;
        let shown = self.poly(state.scope, poly);
        self.say(depth, format!("Distinguish the sign of {shown}:"));
        let cases = [
            (" = 0", Atom::new(poly.clone(), Sign::Zero)),
            (" > 0", Atom::new(poly.clone(), Sign::Positive)),
            (" < 0", Atom::new(poly.neg(), Sign::Positive)),
        ];
        for (i, (sign, atom)) in cases.into_iter().enumerate() {
            self.say(depth + 1, format!("{shown}{sign}:"));
            then(self, &state.with(atom), i);
        }
    }

    fn course(&mut self, state: &State<'_, '_>, course: &Course, depth: usize) {
        match course {
            Course::After(passages, then) => self.passages(state, passages, then, depth),
            Course::Split { poly, zero, positive, negative } => {
                let cases = [&**zero, positive, negative];
                self.split(state, poly, depth, &mut |teller, state, i| {
                    teller.course(state, cases[i], depth + 2);
                });
            }
        }
    }

    /// Passages to limits, and what follows.
    fn passages(
        &mut self,
        state: &State<'_, '_>,
        passages: &[Passage],
        then: &Argument,
        depth: usize,
    ) {
        let scope = state.scope;
        let Some((Passage { germ, atom, along }, rest)) = passages.split_first() else {
            return self.walk(state, then, depth);
        };
        self.rules.limits = true;
        let (Ok(at), Ok(zero)) = (state.along_unproved(germ), state.at_zero(germ, atom)) else {
            return;
        };
        let text = format!(
            "Along {} for small t > 0: {}. (Square brackets stand for a quantity that has a limit.)",
            self.side(&germ.side),
            self.atom(scope, atom)
        );
        self.say(depth, text);
        self.say(depth + 1, "Otherwise:".to_string());
        self.walk(&at.with(atom.not()), along, depth + 2);
        let text = format!("In the limit t = 0: {}.", self.atom(scope, &zero));
        self.say(depth, text);
        self.passages(&state.with(zero), rest, then, depth);
    }

    fn side(&self, side: &Side) -> String {
        let x = &self.goal.context.vars[side.var].name;
        match (&side.at, side.above) {
            (None, true) => format!("{x} = 1/t"),
            (None, false) => format!("{x} = -1/t"),
            (Some(a), true) if a.is_zero() => format!("{x} = t"),
            (Some(a), false) if a.is_zero() => format!("{x} = -t"),
            (Some(a), true) => format!("{x} = {a} + t"),
            (Some(a), false) => format!("{x} = {a} - t"),
        }
    }

    fn limit(&mut self, scope: &Scope<'_>, arguments: &[SideArgument]) -> String {
        let Conclusion::Link(Link::Limit(limit)) = &self.goal.conclusion else {
            return "accepted".to_string();
        };
        let mut reason = String::new();
        for (side, proof) in sides(scope, limit).iter().zip(arguments) {
            let (num, den) = (self.poly(scope, &proof.num), self.poly(scope, &proof.den));
            let f = limit.expr.plain(&self.goal.context);
            let ratio = if den == "1" { num.clone() } else { format!("({num})/({den})") };
            let start = |p: &Poly| {
                let zero = p.coefficients(scope.germ()).swap_remove(0);
                self.poly(scope, &zero)
            };
            let text = format!("With {}, {f} = {ratio} for all small t > 0.", self.side(side));
            let ends = if proof.order == 0 {
                format!("At t = 0 this is ({})/({}).", start(&proof.num), start(&proof.den))
            } else {
                format!(
                    "At t = 0 the numerator is {} and the denominator vanishes to order {}.",
                    start(&proof.num),
                    proof.order
                )
            };
            self.say(0, text);
            let Ok(state) = constants(scope, self.goal, limit.var) else {
                continue;
            };
            if let Ok(mut along) = state.along(&proof.germ)
                && let Ok(cases) =
                    kane_kernel::differs(scope, &limit.expr, (&proof.num, &proof.den))
            {
                along.formulas = std::rc::Rc::new([&along.formulas[..], &[cases]].concat());
                self.say(1, "Otherwise:".to_string());
                self.walk(&along, &proof.along, 2);
            }
            self.say(0, ends);
            let short =
                if ratio.len() > 60 { "a quotient of polynomials in t".to_string() } else { ratio };
            if reason.is_empty() {
                reason = format!("{} gives {short}", self.side(side));
            }
        }
        reason
    }

    fn point(&mut self, finding: Finding, point: &Point) -> String {
        let goal = self.goal;
        let name = |v: usize| goal.context.vars[v].name.clone();
        let pairs = |vars: &[usize]| -> Vec<String> {
            let one = |v: &usize| Some(format!("{} = {}", name(*v), value(point, *v)?));
            vars.iter().filter_map(one).collect()
        };
        self.say(0, format!("At the point {}:", pairs(&mentioned(goal, true)).join(", ")));
        self.used.extend(0..goal.hypotheses.len().min(self.labels.len()));
        let rational = point.generator.is_none();
        let values: Vec<Q> = (0..goal.context.vars.len())
            .map(|v| {
                let known = point.values.iter().find(|x| x.0 == v);
                known.and_then(|x| x.1.first().cloned()).unwrap_or_else(Q::zero)
            })
            .collect();
        let mut evaluator = Evaluator::new(&goal.context, &values);
        // premises are defined; it is the claim that may not be
        let mut sides = |link: &Link, undefined: bool| -> Option<String> {
            let Link::Relation(r) = link else {
                return None;
            };
            let (a, b) = (evaluator.value(&r.lhs), evaluator.value(&r.rhs));
            let mut faults = [&a, &b].into_iter().filter_map(|side| side.as_ref().err());
            let why = faults.find(|why| !matches!(why, NoValue::Irrational)).filter(|_| undefined);
            if let Some(why) = why {
                return Some(format!("{} is undefined ({why})", r.plain(&goal.context)));
            }
            let shown =
                |side: &Result<Q, NoValue>| side.as_ref().map_or_else(ToString::to_string, short);
            Some(format!("left side {}, right side {}", shown(&a), shown(&b)))
        };
        let mut told = String::new();
        if rational {
            for (h, label) in goal.hypotheses.iter().zip(self.labels) {
                for link in &h.sentence.links {
                    if let Some(text) = sides(link, false) {
                        self.steps.push(Step { depth: 1, text: format!("{label}: {text}") });
                    }
                }
            }
            let conclusion: &[Link] = match &goal.conclusion {
                Conclusion::Link(l) => std::slice::from_ref(l),
                Conclusion::NotImplied(s) => &s.links,
                Conclusion::Contradiction => &[],
            };
            for link in conclusion {
                if let Some(text) = sides(link, finding == Finding::IllDefined) {
                    self.steps.push(Step { depth: 1, text: format!("the claim: {text}") });
                    told = text;
                }
            }
        }
        let shown = mentioned(goal, false);
        let near = if shown.is_empty() { mentioned(goal, true) } else { shown };
        let mut at = pairs(&near);
        if at.len() > 8 {
            at.truncate(8);
            at.push("…".to_string());
        }
        let at = at.join(", ");
        match (told.is_empty(), at.is_empty()) {
            (true, true) => "everywhere".to_string(),
            (true, false) => format!("at {at}"),
            (false, true) => told,
            (false, false) => format!("at {at}: {told}"),
        }
    }

    fn functions(&mut self, _finding: Finding, f: &Functions) -> String {
        let goal = self.goal;
        let shown = mentioned(goal, true);
        let pairs: Vec<String> = f
            .values
            .iter()
            .filter(|(v, _)| shown.contains(v))
            .map(|(v, e)| format!("{} = {}", goal.context.vars[*v].name, e.plain(&goal.context)))
            .collect();
        let x = &goal.context.vars[f.var].name;
        let with =
            if pairs.is_empty() { String::new() } else { format!("for {}: ", pairs.join(", ")) };
        self.used.extend(0..goal.hypotheses.len().min(self.labels.len()));
        if !pairs.is_empty() {
            self.say(0, format!("Take {}.", pairs.join(", ")));
        }
        for (i, (proof, limits)) in f.premises.iter().enumerate().take(self.labels.len()) {
            let how = if matches!(proof, Proof::Assume { cases, .. } if cases.is_empty()) {
                ""
            } else {
                ", by a sign table or substitution"
            };
            let limits = if limits.is_empty() { "" } else { "; its limit is as premised" };
            self.say(1, format!("{} holds for all {x}{how}{limits}.", self.labels[i]));
        }
        let end = match &f.failure {
            Failure::Reaches(_) => "all hypotheses hold".to_string(),
            Failure::At(point) => match value(point, f.var) {
                Some(at) => format!("it fails at {x} = {at}"),
                None => "it fails".to_string(),
            },
            Failure::Limit { target, .. } => {
                let target = match target {
                    Target::Finite(e) => e.plain(&goal.context),
                    Target::PlusInf => "oo".to_string(),
                    Target::MinusInf => "-oo".to_string(),
                };
                format!("the limit is {target}")
            }
        };
        self.say(0, format!("Then {end}."));
        format!("{with}{end}")
    }
}

/// Symbols that the conclusion and `when` mention, and with `all` also the hypotheses, in order of
/// declaration.
fn mentioned(goal: &Goal, all: bool) -> Vec<usize> {
    let mut todo: Vec<&Expr> = goal.when.iter().flat_map(|r| [&r.lhs, &r.rhs]).collect();
    fn links<'g>(links: &'g [Link], todo: &mut Vec<&'g Expr>) {
        todo.extend(expressions(&[], links));
    }
    match &goal.conclusion {
        Conclusion::Link(l) => links(std::slice::from_ref(l), &mut todo),
        Conclusion::NotImplied(s) => {
            todo.extend(s.when.iter().flat_map(|r| [&r.lhs, &r.rhs]));
            links(&s.links, &mut todo);
        }
        Conclusion::Contradiction => {}
    }
    if all {
        for h in &goal.hypotheses {
            todo.extend(h.sentence.when.iter().flat_map(|r| [&r.lhs, &r.rhs]));
            links(&h.sentence.links, &mut todo);
        }
    }
    let (mut out, mut lets) = (std::collections::BTreeSet::new(), Vec::new());
    while let Some(e) = todo.pop() {
        match e {
            Expr::Var(v) => {
                out.insert(*v);
            }
            Expr::Let(i) if !lets.contains(i) => {
                lets.push(*i);
                todo.extend(goal.context.lets.get(*i).map(|d| &d.body));
            }
            _ => {}
        }
        todo.extend(e.children());
    }
    out.into_iter().collect()
}

/// A value at a point, as a number or as a root.
fn value(point: &Point, v: usize) -> Option<String> {
    let (_, coefficients) = point.values.iter().find(|x| x.0 == v)?;
    let root = match &point.generator {
        Some(root) if coefficients.len() > 1 => root,
        _ => return Some(coefficients.first().map_or("0".to_string(), short)),
    };
    if coefficients[..] == [Q::zero(), Q::one()] {
        return Some(root_text(root));
    }
    let mut p = Poly::default();
    let common =
        coefficients.iter().fold(BigInt::one(), |l, q| num_integer::lcm(l, q.denom().clone()));
    for (i, q) in (0u32..).zip(coefficients) {
        let m = if i == 0 { Vec::new() } else { vec![(0, i)] };
        p.add_term(m, q.numer() * (&common / q.denom()));
    }
    let text = expression(&p).plain(&single("r"));
    let scaled = if common.is_one() { text } else { format!("({text})/{common}") };
    Some(format!("{scaled} with r = {}", root_text(root)))
}

fn single(name: &str) -> kane_kernel::Context {
    let var = kane_kernel::Var { name: name.to_string(), of: None, lower: None, upper: None };
    kane_kernel::Context { vars: vec![var], ..kane_kernel::Context::default() }
}

fn root_text(root: &kane_kernel::Root) -> String {
    if root.is_exact() {
        return short(&root.lo);
    }
    let p = Poly::in_variable(0, &root.poly);
    let text = expression(&p).plain(&single("x"));
    let mut tight = root.clone();
    for _ in 0..40 {
        if !tight.is_exact() {
            kane_algebra::sign_table::refine(&mut tight);
        }
    }
    format!("the root of {text} near {}", decimal(&tight.lo))
}

/// Four digits after the point, rounded down.
fn decimal(q: &Q) -> String {
    let scaled = (q * Q::from_integer(10_000.into())).floor().to_integer();
    let sign = if scaled.is_negative() { "-" } else { "" };
    let size = scaled.abs();
    let (whole, rest) = (&size / 10_000, &size % 10_000);
    format!("{sign}{whole}.{rest:0>4}")
}

/// A rational number; very long ones by their size.
fn short(q: &Q) -> String {
    let text = q.to_string();
    if text.len() > 80 { format!("about {}", decimal(q)) } else { text }
}
