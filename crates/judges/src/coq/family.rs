//! Goals whose symbols are constants, a limit variable, and functions of it: as data, and as the
//! statement that people read.

use std::fmt::Write as _;

use kane_kernel::{
    Expr, Finding, Goal, Hypothesis, Limit, Link, Relation, Scope, Sentence, Side, Target,
    narrowing, premised, sides,
};

use super::NotEmitted;
use super::conclusion::conclusion;
use super::prose::{Prose, arrow, conj, grouped};
use super::reify::{Symbols, integer, join};

/// What a premise is about: constants, the limit variable alone, or functions of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    Everywhere,
    Narrows,
    Along,
}

/// A premise of a lemma about functions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Slot {
    /// an end of the declared range of a constant
    Range(usize, usize),
    /// the hypothesis with this index, about constants
    Everywhere(usize),
    /// what the hypothesis with this index says of constants
    Part(usize),
    /// the claim's own conditions
    When,
    /// a limit of a hypothesis: its index, and that of the link
    Limit(usize, usize),
    /// that the set reaches up to a limit from this side
    Near(Side),
    /// the declared ranges of functions
    Functions,
    /// the hypothesis with this index, on the set
    Moving(usize),
}

/// Where premises about functions are supposed to hold.
pub(super) enum Setting {
    /// on a set of values of the variable that reaches up to the limits from these sides
    Set {
        /// the sides
        used: Vec<Side>,
        /// whether something is claimed at the points of the set
        point: bool,
    },
    /// wherever premises about the variable alone allow
    Narrowed,
}

/// A goal whose symbols are constants, the limit variable, and functions of it.
pub(super) struct Family<'a, 'g> {
    pub(super) scope: &'a Scope<'g>,
    pub(super) goal: &'g Goal,
    pub(super) symbols: Symbols<'g>,
    pub(super) x: usize,
    pub(super) roles: Vec<Role>,
    /// what premises that are not about constants say of constants all the same
    parts: Vec<Hypothesis>,
    pub(super) always_when: bool,
    /// for each premised limit what is used of it: sides, function, value
    pub(super) limits: Vec<Option<(Vec<Side>, Expr, Expr)>>,
}

/// A limit with its sides, its function and its target written out, and the target as data.
pub(super) struct Claimed {
    pub(super) sides: Vec<Side>,
    pub(super) f: Expr,
    pub(super) to: Target,
    pub(super) target: String,
}

/// The limits of which a goal speaks: those of its premises, then those of its conclusion.
pub(super) fn limits(goal: &Goal) -> impl Iterator<Item = &Limit> {
    let claimed = goal.conclusion.links().iter().filter_map(|l| match l {
        Link::Relation(_) => None,
        Link::Limit(l) => Some(l),
    });
    premised(goal).map(|(_, l)| l).chain(claimed)
}

impl<'a, 'g> Family<'a, 'g> {
    /// A goal along its limit variable x.
    pub(super) fn new(scope: &'a Scope<'g>, goal: &'g Goal, x: usize) -> Result<Self, NotEmitted> {
        if limits(goal).any(|l| l.var != x) {
            return Err(NotEmitted::Step("limits in two variables"));
        }
        let offset = 1 + premised(goal).count();
        let symbols = Symbols::with(scope, offset, Some(x))?;
        if !symbols.roots.is_empty() {
            return Err(NotEmitted::Step("a square root along a limit"));
        }
        let mut family = Self {
            scope,
            goal,
            symbols,
            x,
            roles: Vec::new(),
            parts: Vec::new(),
            always_when: false,
            limits: Vec::new(),
        };
        family.always_when = family.free_all(&family.symbols.expanded(&goal.when)?);
        for h in &goal.hypotheses {
            let s = &h.sentence;
            let all = family.symbols.expanded(s.when.iter().chain(s.relations()))?;
            let role = if family.free_all(&all) {
                Role::Everywhere
            } else if narrowing(scope, h, x).links.len() == s.links.len() {
                Role::Narrows
            } else {
                Role::Along
            };
            let when = family.symbols.expanded(&s.when)?;
            let speaks = role != Role::Everywhere && h.given && family.free_all(&when);
            let part = s.only(|r| {
                let free = |e| family.symbols.expand(e).is_ok_and(|e| family.free(&e));
                speaks && free(&r.lhs) && free(&r.rhs)
            });
            let when = if speaks { part.when } else { Vec::new() };
            family.parts.push(Hypothesis { sentence: Sentence { when, ..part }, given: h.given });
            family.roles.push(role);
        }
        for (s, l) in premised(goal) {
            if !s.when.is_empty() {
                return Err(NotEmitted::Step("a conditional limit among the premises"));
            }
            let used = match &l.to {
                Target::Finite(value) => {
                    let value = family.symbols.expand(value)?;
                    let f = family.symbols.expand(&l.expr)?;
                    family.free(&value).then(|| (sides(scope, l), f, value))
                }
                _ => None,
            };
            family.limits.push(used);
        }
        Ok(family)
    }

    /// Whether a symbol keeps its value while x varies.
    pub(super) fn is_constant(&self, v: usize) -> bool {
        v != self.x && self.scope.context.vars.get(v).is_some_and(|var| var.of != Some(self.x))
    }

    /// Whether an expanded expression mentions constants only.
    fn free(&self, e: &Expr) -> bool {
        let here = match e {
            Expr::Var(v) | Expr::Deriv(_, v) => self.is_constant(*v),
            _ => true,
        };
        here && e.children().into_iter().all(|part| self.free(part))
    }

    fn free_all(&self, rs: &[Relation]) -> bool {
        rs.iter().all(|r| self.free(&r.lhs) && self.free(&r.rhs))
    }

    /// A symbol as people write it: a function of x with its argument.
    pub(super) fn written(&self, v: usize) -> String {
        let name = self.symbols.name(v);
        let function = v != self.x && !self.is_constant(v);
        if function { format!("{name} {}", self.symbols.name(self.x)) } else { name }
    }

    /// A name that no symbol has.
    fn fresh(&self, name: &str) -> String {
        let mut name = name.to_owned();
        while self.symbols.order.iter().any(|v| self.symbols.name(*v) == name) {
            name.push('\'');
        }
        name
    }

    /// The declared ranges of some symbols.
    pub(super) fn ranges(&self, wanted: impl Fn(usize) -> bool) -> Vec<Relation> {
        let order = self.symbols.order.iter().filter(|v| wanted(**v));
        order.flat_map(|v| self.symbols.range(*v)).collect()
    }

    fn positions(&self, wanted: impl Fn(usize) -> bool) -> Result<Vec<usize>, NotEmitted> {
        let order = self.symbols.order.iter().filter(|v| wanted(**v));
        order.map(|v| self.symbols.position(*v)).collect()
    }

    /// The goal as data.
    pub(super) fn data(&self, name: &str, claim: &str) -> Result<String, NotEmitted> {
        let symbols = &self.symbols;
        let mentioned = |v| self.scope.mentioned.contains(&v);
        let (mut premises, mut limits) = (Vec::new(), Vec::new());
        for h in &self.goal.hypotheses {
            premises.push(symbols.sentence(&h.sentence, h.given)?);
        }
        for used in &self.limits {
            limits.push(match used {
                Some((ss, f, v)) => {
                    let ss: Vec<String> = ss.iter().map(side).collect();
                    let (f, v) = (symbols.expr(f)?, symbols.expr(v)?);
                    format!("Some ([{}], {f}, {v})", join(&ss, "; "))
                }
                None => "None".to_owned(),
            });
        }
        let roles: Vec<String> = self.roles.iter().map(|r| format!("{r:?}")).collect();
        let mut parts = Vec::new();
        for h in &self.parts {
            parts.push(symbols.sentence(&h.sentence, h.given)?);
        }
        Ok(format!(
            "Definition goal_{name} : family := Family (Goal\n  {}\n  [{}]\n  {}\n  ({claim}))\n  \
             {}\n  {} [{}]%nat [{}] [{}] {}\n  [{}].\n",
            symbols.relations(&self.ranges(mentioned))?,
            premises.join(";\n   "),
            symbols.relations(&symbols.expanded(&self.goal.when)?)?,
            symbols.relations(&self.ranges(|v| !mentioned(v)))?,
            symbols.position(self.x)?,
            join(&self.positions(|v| self.is_constant(v))?, "; "),
            roles.join("; "),
            parts.join("; "),
            self.always_when,
            limits.join(";\n   "),
        ))
    }

    /// What bounds the domain.
    fn domain(&self, prose: &Prose<'_>, setting: &Setting) -> Result<Vec<String>, NotEmitted> {
        let mut out = Vec::new();
        for r in self.ranges(|v| v == self.x) {
            out.push(prose.relation(&r)?);
        }
        match setting {
            // who asks has something to say of its points, so that there is one
            Setting::Set { .. } => {
                out.push(format!("{} {}", self.set(), self.symbols.name(self.x)));
            }
            Setting::Narrowed => {
                for h in self.narrowing() {
                    out.extend(prose.hypothesis(&h)?);
                }
            }
        }
        Ok(out)
    }

    /// What premises say of the limit variable alone.
    pub(super) fn narrowing(&self) -> Vec<Hypothesis> {
        let one = |h: &Hypothesis| Hypothesis {
            sentence: narrowing(self.scope, h, self.x),
            given: h.given,
        };
        let all = self.goal.hypotheses.iter().map(one);
        all.filter(|h| !h.sentence.links.is_empty()).collect()
    }

    fn hypotheses(&self, roles: &[Role]) -> impl Iterator<Item = (usize, &Hypothesis)> {
        let roled = self.goal.hypotheses.iter().zip(&self.roles);
        roled.enumerate().filter(move |(_, (_, r))| roles.contains(r)).map(|(i, (h, _))| (i, h))
    }

    /// The name of the set on which premises hold.
    pub(super) fn set(&self) -> String {
        self.fresh("domain")
    }

    /// Whether the lemma speaks of such a set.
    pub(super) fn has_set(&self, setting: &Setting) -> bool {
        let moving = || self.hypotheses(&[Role::Narrows, Role::Along]);
        let speaks = |h: &Hypothesis| h.sentence.relations().next().is_some();
        match setting {
            Setting::Set { point, .. } => *point || moving().any(|(_, h)| speaks(h)),
            Setting::Narrowed => false,
        }
    }

    /// The sets of the lemma, as data.
    pub(super) fn sets(&self, setting: &Setting) -> String {
        if self.has_set(setting) { format!("[{}]", self.set()) } else { "[]".to_owned() }
    }

    /// For every value of x.
    fn forall(&self) -> String {
        format!("forall {} : R, ", self.symbols.name(self.x))
    }

    /// What is supposed: of constants, and of functions on the domain; each premise in words.
    pub(super) fn supposed(
        &self,
        prose: &Prose<'_>,
        setting: &Setting,
    ) -> Result<Vec<(Slot, String)>, NotEmitted> {
        let mut out = Vec::new();
        for &v in self.symbols.order.iter().filter(|v| self.is_constant(**v)) {
            for (end, r) in self.symbols.range(v).iter().enumerate() {
                out.push((Slot::Range(v, end), prose.relation(r)?));
            }
        }
        for (i, h) in self.hypotheses(&[Role::Everywhere]) {
            out.extend(prose.hypothesis(h)?.map(|says| (Slot::Everywhere(i), says)));
        }
        for (i, h) in self.parts.iter().enumerate() {
            out.extend(prose.hypothesis(h)?.map(|says| (Slot::Part(i), says)));
        }
        if self.always_when && !self.goal.when.is_empty() {
            let when = prose.flat(&self.symbols.expanded(&self.goal.when)?)?;
            out.push((Slot::When, conj(&when)));
        }
        for (slot, limit) in self.limit_slots().into_iter().zip(&self.limits) {
            if let Some((ss, f, v)) = limit {
                out.push((slot, self.tends(prose, (f, &Target::Finite(v.clone()), ss))?));
            }
        }
        let mut moving = vec![Role::Along];
        if let Setting::Set { used, .. } = setting {
            moving.push(Role::Narrows);
            let says = format!("{} {}", self.set(), self.symbols.name(self.x));
            for side in used.iter().filter(|_| self.has_set(setting)) {
                out.push((Slot::Near(side.clone()), self.near(prose, side, &says)?));
            }
        }
        let functions = self.ranges(|v| v != self.x && !self.is_constant(v));
        if !functions.is_empty() {
            let says =
                functions.iter().map(|r| prose.relation(r)).collect::<Result<Vec<_>, _>>()?;
            let mut within = Vec::new();
            for r in self.ranges(|v| v == self.x) {
                within.push(prose.relation(&r)?);
            }
            let says = format!("{}{}", self.forall(), implied(&within, &conj(&says)));
            out.push((Slot::Functions, says));
        }
        let domain = self.domain(prose, setting)?;
        for (i, h) in self.hypotheses(&moving) {
            if let Some(says) = prose.hypothesis(h)? {
                let says = format!("{}{}", self.forall(), implied(&domain, &grouped(&says)));
                out.push((Slot::Moving(i), says));
            }
        }
        Ok(out)
    }

    /// The premised limits, by hypothesis and link.
    fn limit_slots(&self) -> Vec<Slot> {
        let mut out = Vec::new();
        for (i, h) in self.goal.hypotheses.iter().enumerate() {
            for (link, l) in h.sentence.links.iter().enumerate() {
                out.extend(matches!(l, Link::Limit(_)).then_some(Slot::Limit(i, link)));
            }
        }
        out
    }

    /// A limit of a claim, written out.
    pub(super) fn claimed(&self, limit: &Limit) -> Result<Claimed, NotEmitted> {
        let sides = sides(self.scope, limit);
        let f = self.symbols.expand(&limit.expr)?;
        let to = match &limit.to {
            Target::Finite(v) => Target::Finite(self.symbols.expand(v)?),
            other => other.clone(),
        };
        let target = self.symbols.target(&to)?;
        Ok(Claimed { sides, f, to, target })
    }

    /// A limit in words: for each side, what holds close to it.
    pub(super) fn tends(
        &self,
        prose: &Prose<'_>,
        (f, to, sides): (&Expr, &Target, &[Side]),
    ) -> Result<String, NotEmitted> {
        let (mut says, mut close) = (Vec::new(), prose.conditions(f)?);
        let before = match to {
            Target::Finite(v) => {
                let eps = self.fresh("epsilon");
                says.extend(prose.conditions(v)?);
                let gap = Expr::Abs(Expr::Sub(f.clone().into(), v.clone().into()).into());
                close.push(format!("{} < {eps}", prose.term(&gap)?));
                format!("forall {eps} : R, {eps} > 0 -> ")
            }
            Target::PlusInf | Target::MinusInf => {
                let (level, sign) =
                    (self.fresh("level"), if *to == Target::PlusInf { '>' } else { '<' });
                close.push(format!("{} {sign} {level}", prose.term(f)?));
                format!("forall {level} : R, ")
            }
        };
        let close = grouped(&conj(&close));
        for s in sides {
            says.push(format!("{before}{}", self.near(prose, s, &close)?));
        }
        Ok(conj(&says))
    }

    /// What holds close to a point on one side of it, or far out.
    fn near(&self, prose: &Prose<'_>, s: &Side, close: &str) -> Result<String, NotEmitted> {
        let (x, forall) = (self.symbols.name(self.x), self.forall());
        Ok(match &s.at {
            Some(a) => {
                let (a, d) = (prose.term(&Expr::Num(a.clone()))?, self.fresh("delta"));
                let within = if s.above {
                    format!("{a} < {x} < {a} + {d}")
                } else {
                    format!("{a} - {d} < {x} < {a}")
                };
                format!("exists {d} : R, {d} > 0 /\\ ({forall}{within} -> {close})")
            }
            None => {
                let (b, sign) = (self.fresh("bound"), if s.above { '>' } else { '<' });
                format!("exists {b} : R, {forall}{x} {sign} {b} -> {close}")
            }
        })
    }

    /// What is claimed at each point of the domain, as data and in words.
    pub(super) fn pointwise(
        &self,
        prose: &Prose<'_>,
        finding: Finding,
        setting: &Setting,
    ) -> Result<(String, String), NotEmitted> {
        let (claim, says) = conclusion(prose, self.goal, finding)?;
        let conditions = match self.always_when {
            true => Vec::new(),
            false => prose.flat(&self.symbols.expanded(&self.goal.when)?)?,
        };
        let says = implied(&self.domain(prose, setting)?, &arrow(&conditions, &says));
        Ok((claim, format!("{}{says}", self.forall())))
    }

    /// The symbols other than x: constants, then functions.
    pub(super) fn bound(&self) -> (Vec<usize>, Vec<usize>) {
        let others = self.symbols.order.iter().copied().filter(|v| *v != self.x);
        others.partition(|v| self.is_constant(*v))
    }

    /// The statement: for all constants and functions, what is supposed leads to what is said.
    pub(super) fn statement(
        &self,
        prose: &Prose<'_>,
        says: &str,
        setting: &Setting,
    ) -> Result<String, NotEmitted> {
        let (constants, functions) = self.bound();
        let mut kinds = Vec::new();
        for (symbols, kind) in [(&constants, "R"), (&functions, "R -> R")] {
            let names: Vec<String> = symbols.iter().map(|v| self.symbols.name(*v)).collect();
            if !names.is_empty() {
                kinds.push(format!("({} : {kind})", names.join(" ")));
            }
        }
        if self.has_set(setting) {
            kinds.push(format!("({} : R -> Prop)", self.set()));
        }
        let mut text = String::new();
        if !kinds.is_empty() {
            text = format!("forall {},\n  ", kinds.join(" "));
        }
        for (_, premise) in self.supposed(prose, setting)? {
            let _ = write!(text, "{} ->\n  ", grouped_all(&premise));
        }
        Ok(text + says)
    }

    /// A proved statement, from what shows it where the list of values is as it should be.
    pub(super) fn lemma(&self, name: &str, statement: &str, by: &str, setting: &Setting) -> String {
        let (constants, functions) = self.bound();
        let mut names: Vec<String> =
            constants.iter().chain(&functions).map(|v| self.symbols.name(*v)).collect();
        names.extend(self.has_set(setting).then(|| self.set()));
        let intros =
            if names.is_empty() { String::new() } else { format!("intros {}. ", names.join(" ")) };
        let values: Vec<String> = self.symbols.order.iter().map(|v| self.written(*v)).collect();
        let values = format!("(fun {} => [{}])", self.symbols.name(self.x), values.join("; "));
        format!(
            "Lemma claim_{name} :\n  {statement}.\nProof. {intros}exact ({by}\n    \
             (Steady goal_{name} {values} (fun _ => eq_refl) (fun _ _ => eq_refl) (fun _ => eq_refl))). Qed.\n"
        )
    }
}

/// A side as data.
pub(super) fn side(s: &Side) -> String {
    match &s.at {
        Some(a) => format!("(Side (Some (q_ {} {})) {})", integer(a.numer()), a.denom(), s.above),
        None => format!("(Side None {})", s.above),
    }
}

/// A proposition behind premises, one after the other.
fn implied(premises: &[String], says: &str) -> String {
    let premises: String = premises.iter().map(|p| format!("{} -> ", grouped(p))).collect();
    premises + says
}

/// In parentheses if it is more than a comparison.
fn grouped_all(p: &str) -> String {
    if p.contains("forall ") { format!("({p})") } else { grouped(p) }
}
