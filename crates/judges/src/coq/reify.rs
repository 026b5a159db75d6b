//! Expressions and goals as data of the Coq file.

use std::cell::RefCell;
use std::collections::BTreeMap;

use kane_algebra::syntax::{canonical_name, rebuild};
use kane_kernel::{Context, Expr, Poly, Power, Rel, Relation, Scope, Sentence, Target};
use num_bigint::BigInt;
use num_rational::BigRational;

use super::NotEmitted;
use super::prose::Prose;
use super::slopes::{FIRST, Slope};
use super::theory::has_word;

/// Definitions inside definitions, followed at most this deep.
const MAX_DEPTH: usize = 64;

/// The symbols of a goal in Coq: their names, and the numbers under which its data knows them.
#[derive(Debug)]
pub(super) struct Symbols<'a> {
    pub(super) context: &'a Context,
    /// symbols of the kernel in the order of the lemma's list
    pub(super) order: Vec<usize>,
    /// square roots behind them, inner ones first, each with its variable of the kernel
    pub(super) roots: Vec<(usize, Expr)>,
    /// numbers of t and of the limits, which come before them in polynomials
    pub(super) offset: usize,
    /// derivatives, as they are met; `None` where there may be none
    pub(super) slopes: Option<RefCell<Vec<Slope>>>,
    names: BTreeMap<usize, String>,
    positions: BTreeMap<usize, usize>,
    /// the kernel's number of t
    germ: usize,
}

impl<'a> Symbols<'a> {
    /// The symbols that a goal at a point mentions; it may mention derivatives.
    pub(super) fn new(scope: &Scope<'a>, offset: usize) -> Result<Self, NotEmitted> {
        Ok(Self { slopes: Some(RefCell::default()), ..Self::with(scope, offset, None)? })
    }

    /// The symbols that a goal mentions, and one more behind them.
    pub(super) fn with(
        scope: &Scope<'a>,
        offset: usize,
        also: Option<usize>,
    ) -> Result<Self, NotEmitted> {
        let context = scope.context;
        let also = also.filter(|v| !scope.mentioned.contains(v));
        let order: Vec<usize> = scope.mentioned.iter().copied().chain(also).collect();
        let mut roots = Vec::new();
        for v in context.vars.len()..scope.germ() {
            let root = scope.root(v).ok_or(NotEmitted::Symbol)?;
            roots.push((v, expand(context, root, MAX_DEPTH)?));
        }
        Ok(Self::named(context, order, roots, offset))
    }

    /// Some symbols, roots and derivatives of a document.
    pub(super) fn of(
        context: &'a Context,
        symbols: impl IntoIterator<Item = usize>,
        roots: Vec<Expr>,
        slopes: Vec<Slope>,
    ) -> Self {
        let roots = (context.vars.len()..).zip(roots).collect();
        let all = Self::named(context, symbols.into_iter().collect(), roots, 0);
        Self { slopes: Some(slopes.into()), ..all }
    }

    fn named(
        context: &'a Context,
        order: Vec<usize>,
        mut roots: Vec<(usize, Expr)>,
        offset: usize,
    ) -> Self {
        let germ = context.vars.len() + roots.len();
        let mut names = BTreeMap::new();
        for &v in &order {
            let mut name = identifier(&context.vars[v].name);
            while names.values().any(|n: &String| *n == name) {
                name.push('\'');
            }
            names.insert(v, name);
        }
        for (v, _) in &roots {
            let mut name = "root".to_owned();
            while names.values().any(|n: &String| *n == name) {
                name.push('\'');
            }
            names.insert(*v, name);
        }
        // A root inside another one is a part of it.
        roots.sort_by_key(|(_, e)| size(e));
        let listed = order.iter().copied().chain(roots.iter().map(|r| r.0));
        let positions = listed.enumerate().map(|(i, v)| (v, i)).collect();
        Self { context, order, roots, offset, slopes: None, names, positions, germ }
    }

    /// The name of a symbol.
    pub(super) fn name(&self, v: usize) -> String {
        match v.checked_sub(FIRST) {
            Some(i) => self.fresh(&integer_name("slope", i)),
            None => self.names.get(&v).cloned().unwrap_or_else(|| "0".to_owned()),
        }
    }

    /// Names for some of a kind that no symbol has.
    pub(super) fn numbered(&self, name: &str, count: usize) -> Vec<String> {
        (0..count).map(|i| self.fresh(&format!("{name}{i}"))).collect()
    }

    /// Names for what is known of roots and derivatives.
    pub(super) fn known(&self, count: usize) -> Vec<String> {
        self.numbered("Known", count)
    }

    /// A name that no symbol has.
    pub(super) fn fresh(&self, name: &str) -> String {
        let mut name = name.to_owned();
        while self.names.values().any(|n| *n == name) {
            name.push('\'');
        }
        name
    }

    /// The place of a symbol in the list of values.
    pub(super) fn position(&self, v: usize) -> Result<usize, NotEmitted> {
        self.positions.get(&v).copied().ok_or(NotEmitted::Symbol)
    }

    /// The number of a variable of the kernel in polynomials of the file.
    pub(super) fn variable(&self, v: usize) -> Result<usize, NotEmitted> {
        match v.checked_sub(self.germ) {
            Some(i) if i < self.offset => Ok(i),
            Some(_) => Err(NotEmitted::Symbol),
            None => Ok(self.offset + self.position(v)?),
        }
    }

    /// The expression without definitions and derivatives.
    pub(super) fn expand(&self, e: &Expr) -> Result<Expr, NotEmitted> {
        expand(self.context, e, MAX_DEPTH)
    }

    /// A polynomial as data, its terms in the order that the file's arithmetic keeps.
    pub(super) fn poly(&self, p: &Poly) -> Result<String, NotEmitted> {
        let mut terms = Vec::new();
        for (m, c) in p.terms() {
            terms.push((self.exponents(m)?, c));
        }
        terms.sort();
        let terms: Vec<String> =
            terms.iter().map(|(m, c)| format!("m_ {} {}", nats(m), integer(c))).collect();
        Ok(format!("[{}]", terms.join("; ")))
    }

    fn exponents(&self, m: &[Power]) -> Result<Vec<u32>, NotEmitted> {
        let mut out = Vec::new();
        for &(v, n) in m {
            let i = self.variable(v)?;
            if out.len() <= i {
                out.resize(i + 1, 0);
            }
            out[i] = n;
        }
        Ok(out)
    }

    /// An expanded expression as data.
    pub(super) fn expr(&self, e: &Expr) -> Result<String, NotEmitted> {
        let two =
            |f: &str, a: &Expr, b: &Expr| Ok(format!("({f} {} {})", self.expr(a)?, self.expr(b)?));
        match e {
            Expr::Num(q) => Ok(rational(q)),
            Expr::Var(v) => Ok(format!("(Var {})", self.position(*v)?)),
            Expr::Neg(a) => Ok(format!("(Neg {})", self.expr(a)?)),
            Expr::Add(a, b) => two("Add", a, b),
            Expr::Sub(a, b) => two("Sub", a, b),
            Expr::Mul(a, b) => two("Mul", a, b),
            Expr::Div(a, b) => two("Div", a, b),
            Expr::Pow(a, n) if *n < 0 => {
                let below = Expr::Pow(a.clone(), n.saturating_neg());
                two("Div", &Expr::int(1), &below)
            }
            Expr::Pow(a, n) => Ok(format!("(Pow {} {n})", self.expr(a)?)),
            Expr::Abs(a) => Ok(format!("(Abs {})", self.expr(a)?)),
            Expr::Min(a, b) => two("Min", a, b),
            Expr::Max(a, b) => two("Max", a, b),
            Expr::Sqrt(a) => {
                let root = self.roots.iter().find(|(_, r)| r == e).ok_or(NotEmitted::Symbol)?;
                Ok(format!("(Root {} {})", self.position(root.0)?, self.expr(a)?))
            }
            Expr::Cases(branches, otherwise) => {
                let mut rest = match otherwise {
                    Some(e) => self.expr(e)?,
                    None => "Undefined".to_owned(),
                };
                for (guards, body) in branches.iter().rev() {
                    let mut then = self.expr(body)?;
                    for g in guards.iter().rev() {
                        let (a, b) = (self.expr(&g.lhs)?, self.expr(&g.rhs)?);
                        then = format!("(If {a} {} {b} {then} {rest})", comparison(g.rel));
                    }
                    rest = then;
                }
                Ok(rest)
            }
            Expr::Deriv(f, x) => self.slope_data(self.slope(f, *x)?),
            Expr::Let(_) => Err(NotEmitted::Symbol),
        }
    }

    /// Where a limit leads, as data.
    pub(super) fn target(&self, to: &Target) -> Result<String, NotEmitted> {
        Ok(match to {
            Target::Finite(v) => format!("(Finite {})", self.expr(v)?),
            Target::PlusInf => "PlusInf".to_owned(),
            Target::MinusInf => "MinusInf".to_owned(),
        })
    }

    /// A relation, of which the sides are expanded, as data.
    pub(super) fn relation(&self, r: &Relation) -> Result<String, NotEmitted> {
        let (a, b) = (self.expr(&r.lhs)?, self.expr(&r.rhs)?);
        Ok(format!("Rel {a} {} {b}", comparison(r.rel)))
    }

    /// Relations as data.
    pub(super) fn relations(&self, rs: &[Relation]) -> Result<String, NotEmitted> {
        let rs = rs.iter().map(|r| self.relation(r)).collect::<Result<Vec<_>, _>>()?;
        Ok(format!("[{}]", rs.join("; ")))
    }

    /// The relations with both sides expanded.
    pub(super) fn expanded<'r>(
        &self,
        rs: impl IntoIterator<Item = &'r Relation>,
    ) -> Result<Vec<Relation>, NotEmitted> {
        let one = |r: &Relation| {
            Ok(Relation { lhs: self.expand(&r.lhs)?, rel: r.rel, rhs: self.expand(&r.rhs)? })
        };
        rs.into_iter().map(one).collect()
    }

    /// The relations of a premise as data.
    pub(super) fn sentence(&self, s: &Sentence, given: bool) -> Result<String, NotEmitted> {
        let when = self.relations(&self.expanded(&s.when)?)?;
        let links = self.relations(&self.expanded(s.relations())?)?;
        Ok(format!("Says {given} {when} {links}"))
    }

    /// The names of the square roots, and what is known of each: where the radicand is not
    /// negative, it is not negative and its square is the radicand.
    pub(super) fn roots(
        &self,
        prose: &Prose<'_>,
    ) -> Result<(Vec<String>, Vec<String>), NotEmitted> {
        let (mut names, mut given) = (Vec::new(), Vec::new());
        for (v, root) in &self.roots {
            let Expr::Sqrt(a) = root else {
                return Err(NotEmitted::Symbol);
            };
            let (s, a) = (self.name(*v), prose.term(a)?);
            given.push(format!("0 <= {a} -> 0 <= {s} /\\ {s} * {s} = {a}"));
            names.push(s);
        }
        Ok((names, given))
    }

    /// The declared range of a symbol as relations.
    pub(super) fn range(&self, v: usize) -> Vec<Relation> {
        let var = &self.context.vars[v];
        let end = |b: &kane_kernel::Bound, strict, weak| Relation {
            lhs: Expr::Var(v),
            rel: if b.strict { strict } else { weak },
            rhs: Expr::Num(b.value.clone()),
        };
        let lower = var.lower.as_ref().map(|b| end(b, Rel::Gt, Rel::Ge));
        let upper = var.upper.as_ref().map(|b| end(b, Rel::Lt, Rel::Le));
        lower.into_iter().chain(upper).collect()
    }
}

/// A rational number as an expression of the file.
fn rational(q: &BigRational) -> String {
    format!("(Num {} {})", integer(q.numer()), q.denom())
}

/// An integer, in parentheses if it is negative.
pub(super) fn integer(c: &BigInt) -> String {
    if c.sign() == num_bigint::Sign::Minus { format!("({c})") } else { c.to_string() }
}

/// A name, with a number if it is not the first.
pub(super) fn integer_name(name: &str, i: usize) -> String {
    if i == 0 { name.to_owned() } else { format!("{name}_{}", i + 1) }
}

/// Natural numbers as a list.
fn nats(ns: &[u32]) -> String {
    if ns.is_empty() { "[]".to_owned() } else { format!("[{}]%nat", join(ns, "; ")) }
}

/// Things with something between.
pub(super) fn join<T: ToString>(parts: &[T], between: &str) -> String {
    parts.iter().map(ToString::to_string).collect::<Vec<_>>().join(between)
}

fn comparison(rel: Rel) -> &'static str {
    match rel {
        Rel::Eq => "Eq",
        Rel::Ne => "Ne",
        Rel::Lt => "Lt",
        Rel::Le => "Le",
        Rel::Gt => "Gt",
        Rel::Ge => "Ge",
    }
}

fn size(e: &Expr) -> usize {
    1 + e.children().into_iter().map(size).sum::<usize>()
}

/// The expression with its definitions written out.
fn expand(context: &Context, e: &Expr, depth: usize) -> Result<Expr, NotEmitted> {
    rebuild(e, &mut |part| match part {
        Expr::Let(i) => {
            let body = &context.lets.get(*i).ok_or(NotEmitted::Symbol)?.body;
            let depth = depth.checked_sub(1).ok_or(NotEmitted::Symbol)?;
            expand(context, body, depth).map(Some)
        }
        Expr::Var(v) => context.value(*v).map(|e| expand(context, e, depth)).transpose(),
        _ => Ok(None),
    })
}

/// Words that Coq keeps for itself, or that stand in lemmas and proofs beside the symbols. Those of the
/// theory are kept, too.
const KEPT: [&str; 71] = [
    "as",
    "at",
    "by",
    "cofix",
    "else",
    "end",
    "exists",
    "exists2",
    "fix",
    "for",
    "forall",
    "fun",
    "if",
    "IF",
    "in",
    "lazymatch",
    "let",
    "match",
    "mod",
    "multimatch",
    "Prop",
    "quot",
    "rem",
    "return",
    "Set",
    "SProp",
    "then",
    "Type",
    "using",
    "where",
    "with",
    "Axiom",
    "CoFixpoint",
    "Definition",
    "Fixpoint",
    "Hypothesis",
    "Parameter",
    "Theorem",
    "Variable",
    "R",
    "IZR",
    "Rabs",
    "Rmin",
    "Rmax",
    "Rinv",
    "Rlt_dec",
    "Rle_dec",
    "Rgt_dec",
    "Rge_dec",
    "Req_EM_T",
    "sqrt",
    "pow",
    "O",
    "S",
    "I",
    "H",
    "not",
    "or",
    "and",
    "eq",
    "eq_refl",
    "true",
    "false",
    "True",
    "False",
    "epsilon",
    "delta",
    "level",
    "bound",
    "Root",
    "div",
];

/// What the names of a file's own definitions begin with.
pub(super) const OWN: [&str; 9] =
    ["met_", "theorem_", "goal_", "proof_", "claim_", "witness_", "functions_", "limit_", "Root"];

/// A name as Coq takes it, and as nothing else in the file is called.
pub(super) fn identifier(name: &str) -> String {
    let mut out: String = canonical_name(name)
        .chars()
        .map(|c| if c.is_ascii_alphanumeric() || c == '_' || c == '\'' { c } else { '_' })
        .collect();
    if OWN.iter().any(|own| out.starts_with(own)) {
        out.insert_str(0, "v_");
    }
    while KEPT.contains(&out.as_str()) || has_word(&out) || out.is_empty() {
        out.push('_');
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_the_file_uses_are_renamed_and_others_are_not() {
        for kept in ["x", "k", "alpha", "v_x0'", "Delta_e", "slip", "x_", "kW", "i_x"] {
            assert_eq!(identifier(kept), kept);
        }
        assert_eq!(identifier("μ′"), "mu'");
        for (name, other) in [
            ("epsilon", "epsilon_"),
            ("ε", "epsilon_"),
            ("true", "true_"),
            ("proved", "proved_"),
            ("Rlt_dec", "Rlt_dec_"),
            ("goal_x", "v_goal_x"),
            ("Root0", "v_Root0"),
            ("naïve", "na_ve"),
            ("", "_"),
        ] {
            assert_eq!(identifier(name), other);
        }
    }
}
