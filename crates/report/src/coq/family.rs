//! Goals whose symbols are constants, a limit variable, and functions of it: as data, and as the
//! statement that people read.

use std::fmt::Write as _;

use kane_kernel::{
    Expr, Finding, Goal, Hypothesis, Limit, Link, Relation, Scope, Side, Target, narrowing,
    premised, sides,
};

use super::NotEmitted;
use super::lemma::conclusion;
use super::prose::{Prose, arrow, conj, grouped};
use super::reify::{Symbols, integer, join};

/// Where a premise is said: of constants, to bound the domain, or of functions on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    Everywhere,
    Narrows,
    Along,
}

/// A goal whose symbols are constants, the limit variable, and functions of it.
pub(super) struct Family<'a, 'g> {
    pub(super) scope: &'a Scope<'g>,
    pub(super) goal: &'g Goal,
    pub(super) symbols: Symbols<'g>,
    pub(super) x: usize,
    pub(super) roles: Vec<Role>,
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
            always_when: false,
            limits: Vec::new(),
        };
        family.always_when = family.free_all(&family.symbols.expanded(&goal.when)?);
        for h in &goal.hypotheses {
            let s = &h.sentence;
            let all = family.symbols.expanded(s.when.iter().chain(s.relations()))?;
            family.roles.push(if family.free_all(&all) {
                Role::Everywhere
            } else if narrowing(scope, h, x).links.len() == s.links.len() {
                Role::Narrows
            } else {
                Role::Along
            });
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
        Ok(format!(
            "Definition goal_{name} : family := Family (Goal\n  {}\n  [{}]\n  {}\n  ({claim}))\n  \
             {}\n  {} [{}]%nat [{}] {}\n  [{}].\n",
            symbols.relations(&self.ranges(mentioned))?,
            premises.join(";\n   "),
            symbols.relations(&symbols.expanded(&self.goal.when)?)?,
            symbols.relations(&self.ranges(|v| !mentioned(v)))?,
            symbols.position(self.x)?,
            join(&self.positions(|v| self.is_constant(v))?, "; "),
            roles.join("; "),
            self.always_when,
            limits.join(";\n   "),
        ))
    }

    /// What bounds the domain.
    fn domain(&self, prose: &Prose<'_>) -> Result<Vec<String>, NotEmitted> {
        let mut out = Vec::new();
        for r in self.ranges(|v| v == self.x) {
            out.push(prose.relation(&r)?);
        }
        for h in self.hypotheses(Role::Narrows) {
            out.extend(prose.hypothesis(h)?);
        }
        Ok(out)
    }

    fn hypotheses(&self, role: Role) -> impl Iterator<Item = &Hypothesis> {
        let roled = self.goal.hypotheses.iter().zip(&self.roles);
        roled.filter(move |(_, r)| **r == role).map(|(h, _)| h)
    }

    /// For every value of x.
    fn forall(&self) -> String {
        format!("forall {} : R, ", self.symbols.name(self.x))
    }

    /// What is supposed, in words: of constants, and of functions on the domain.
    pub(super) fn supposed(&self, prose: &Prose<'_>) -> Result<Vec<String>, NotEmitted> {
        let mut out = Vec::new();
        for r in self.ranges(|v| self.is_constant(v)) {
            out.push(prose.relation(&r)?);
        }
        for h in self.hypotheses(Role::Everywhere) {
            out.extend(prose.hypothesis(h)?);
        }
        if self.always_when && !self.goal.when.is_empty() {
            out.push(conj(&prose.flat(&self.symbols.expanded(&self.goal.when)?)?));
        }
        for (ss, f, v) in self.limits.iter().flatten() {
            out.push(self.tends(prose, (f, &Target::Finite(v.clone()), ss))?);
        }
        let functions = self.ranges(|v| v != self.x && !self.is_constant(v));
        if !functions.is_empty() {
            let says =
                functions.iter().map(|r| prose.relation(r)).collect::<Result<Vec<_>, _>>()?;
            let mut within = Vec::new();
            for r in self.ranges(|v| v == self.x) {
                within.push(prose.relation(&r)?);
            }
            out.push(format!("{}{}", self.forall(), implied(&within, &conj(&says))));
        }
        let domain = self.domain(prose)?;
        for h in self.hypotheses(Role::Along) {
            if let Some(says) = prose.hypothesis(h)? {
                out.push(format!("{}{}", self.forall(), implied(&domain, &grouped(&says))));
            }
        }
        Ok(out)
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
        let (x, forall) = (self.symbols.name(self.x), self.forall());
        for s in sides {
            let near = match &s.at {
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
            };
            says.push(format!("{before}{near}"));
        }
        Ok(conj(&says))
    }

    /// What is claimed at each point of the domain, as data and in words.
    pub(super) fn pointwise(
        &self,
        prose: &Prose<'_>,
        finding: Finding,
    ) -> Result<(String, String), NotEmitted> {
        let (claim, says) = conclusion(prose, self.goal, finding)?;
        let conditions = match self.always_when {
            true => Vec::new(),
            false => prose.flat(&self.symbols.expanded(&self.goal.when)?)?,
        };
        let says = implied(&self.domain(prose)?, &arrow(&conditions, &says));
        Ok((claim, format!("{}{says}", self.forall())))
    }

    /// The symbols other than x: constants, then functions.
    pub(super) fn bound(&self) -> (Vec<usize>, Vec<usize>) {
        let others = self.symbols.order.iter().copied().filter(|v| *v != self.x);
        others.partition(|v| self.is_constant(*v))
    }

    /// The statement: for all constants and functions, what is supposed leads to what is said.
    pub(super) fn statement(&self, prose: &Prose<'_>, says: &str) -> Result<String, NotEmitted> {
        let (constants, functions) = self.bound();
        let mut kinds = Vec::new();
        for (symbols, kind) in [(&constants, "R"), (&functions, "R -> R")] {
            let names: Vec<String> = symbols.iter().map(|v| self.symbols.name(*v)).collect();
            if !names.is_empty() {
                kinds.push(format!("({} : {kind})", names.join(" ")));
            }
        }
        let mut text = String::new();
        if !kinds.is_empty() {
            text = format!("forall {},\n  ", kinds.join(" "));
        }
        for premise in self.supposed(prose)? {
            let _ = write!(text, "{} ->\n  ", grouped_all(&premise));
        }
        Ok(text + says)
    }

    /// A proved statement, from what shows it where the list of values is as it should be.
    pub(super) fn lemma(&self, name: &str, statement: &str, by: &str) -> String {
        let (constants, functions) = self.bound();
        let names: Vec<String> =
            constants.iter().chain(&functions).map(|v| self.symbols.name(*v)).collect();
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
