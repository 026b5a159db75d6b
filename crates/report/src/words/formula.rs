//! Formulas within sentences: text, MathML that may be broken between its terms, or math mode.

use kane_algebra::syntax::{Logic, Notation as _, comparison, latex_with, literal, mathml};
use kane_audit::{Summand, Variable, expression};
use kane_kernel::{Approach, Atom, Context, Expr, Poly, Rel, Relation, Side, Sign, Target, Var};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One as _, Signed as _, Zero as _};

use super::decimal::decimal;
use super::fences::tight;
use super::shape::{Shapes, sum};
use super::{Form, words};

/// Terms of a polynomial that are written out; of a longer one only their number is.
const MOST_TERMS: usize = 40;
/// Terms above and below a line of a fraction; with more, the quotient stands on one line.
const MOST_IN_FRACTION: usize = 4;
/// Digits of a number that is set as mathematics; a longer one may be broken.
const MOST_DIGITS: usize = 12;
/// Bits of a coefficient that is set as mathematics in LaTeX.
const MOST_BITS: u64 = 60;
/// Letters of a polynomial that is written out where long ones have names.
const MOST_LETTERS: usize = 90;
/// Letters of a factor, likewise.
const MOST_OF_FACTOR: usize = 60;
/// Letters of both sides of an atom, likewise.
const MOST_OF_ATOM: usize = 120;

/// How formulas of a goal are written in one form.
pub(crate) struct Formulas {
    pub(super) form: Form,
    /// the goal's symbols and definitions, and the further variables of a proof under names of theirs
    context: Context,
    /// the number of the goal's symbols
    symbols: usize,
    /// how the further variables are set in MathML or LaTeX
    further: Vec<String>,
    germ: usize,
    /// how polynomials are written, and names of long ones, if they may have some
    shapes: Shapes,
}

impl Formulas {
    /// Formulas in these symbols, and in polynomials of these variables.
    pub(crate) fn new(form: Form, context: &Context, variables: &[Variable]) -> Self {
        let symbols = context.vars.len();
        let mut all = Self {
            form,
            context: context.clone(),
            symbols,
            further: Vec::new(),
            germ: symbols,
            shapes: Shapes::default(),
        };
        for (v, variable) in variables.iter().enumerate().skip(symbols) {
            let (name, set) = match variable {
                Variable::Root(root) => (root.plain(context), all.bare(root)),
                Variable::Definition(i) => {
                    let definition = Expr::Let(*i);
                    (definition.plain(context), all.bare(&definition))
                }
                Variable::Germ => {
                    all.germ = v;
                    ("t".to_owned(), all.letter("t"))
                }
                Variable::Limiting(f) => {
                    let (name, set) = (f.plain(context), all.bare(f));
                    let set = match form {
                        Form::Html => format!("<mrow><mo>[</mo>{set}<mo>]</mo></mrow>"),
                        Form::Plain | Form::Latex => format!("\\left[{set}\\right]"),
                    };
                    (format!("[{name}]"), set)
                }
                Variable::Symbol(_) => ("?".to_owned(), all.letter("?")),
                Variable::Unnamed(i) => (format!("z{i}"), all.letter(&format!("z{i}"))),
            };
            all.context.vars.push(Var { name, of: None, lower: None, upper: None });
            all.further.push(set);
        }
        all
    }

    /// A formula in one letter alone.
    pub(super) fn of_letter(form: Form, name: &str) -> Self {
        let var = Var { name: name.to_owned(), of: None, lower: None, upper: None };
        Self::new(form, &Context { vars: vec![var], ..Context::default() }, &[])
    }

    /// The first of these letters that is no symbol and no definition, or one that never is.
    pub(super) fn unused_letter(&self, letters: &[&'static str]) -> &'static str {
        let lets = self.context.lets.iter().map(|definition| &definition.name);
        let names = || self.context.vars.iter().map(|var| &var.name).chain(lets.clone());
        let is_free = |letter: &&&str| !names().any(|name| name == **letter);
        letters.iter().find(is_free).copied().unwrap_or("root")
    }

    fn letter(&self, name: &str) -> String {
        match self.form {
            Form::Html => kane_algebra::syntax::mathml_name(name),
            Form::Plain | Form::Latex => kane_algebra::syntax::latex_name(name),
        }
    }

    /// Text in this form.
    pub(super) fn words(&self, text: &str) -> String {
        words(text, self.form)
    }

    /// An expression without what sets it apart from words.
    fn bare(&self, e: &Expr) -> String {
        let beyond = |v: usize| self.further.get(v.checked_sub(self.symbols)?).cloned();
        match self.form {
            Form::Plain => e.plain(&self.context),
            Form::Html => mathml(e, &self.context, &beyond),
            Form::Latex => latex_with(e, &self.context, &beyond),
        }
    }

    /// An expression.
    pub(crate) fn expr(&self, e: &Expr) -> String {
        let bare = |e: &Expr| self.bare(e);
        match self.form {
            Form::Plain => bare(e),
            Form::Latex => format!("${}$", bare(e)),
            // a line may end between two terms of a sum
            Form::Html => match e {
                Expr::Add(a, b) => format!("{} + {}", self.expr(a), math(&self.term(b))),
                Expr::Sub(a, b) => format!("{} − {}", self.expr(a), math(&self.term(b))),
                // a page of proofs has thousands of whole numbers, which need no setting
                Expr::Num(q) if q.is_integer() => bare_integer(q),
                _ => math(&bare(e)),
            },
        }
    }

    /// An expression behind a sign.
    fn term(&self, e: &Expr) -> String {
        let bare = self.bare(e);
        match e {
            Expr::Add(..) | Expr::Sub(..) | Expr::Neg(_) => {
                format!("<mo>(</mo>{bare}<mo>)</mo>")
            }
            _ => bare,
        }
    }

    /// A symbol of the goal or a variable of the proof.
    pub(crate) fn symbol(&self, v: usize) -> String {
        self.expr(&Expr::Var(v))
    }

    /// The same formulas, where long polynomials have names, shared with others of the same goal.
    pub(super) fn named(mut self, shapes: &Shapes) -> Self {
        self.shapes = shapes.clone();
        self
    }

    /// A polynomial.
    pub(super) fn poly(&self, p: &Poly) -> String {
        self.poly_within(p, MOST_LETTERS)
    }

    /// A polynomial, by its name if it has more letters than these.
    pub(super) fn poly_within(&self, p: &Poly, letters: usize) -> String {
        if !self.shapes.are_named() {
            return match p.len() > MOST_TERMS {
                true => self.words(&format!("(a polynomial with {} terms)", p.len())),
                false => self.expr(&expression(p)),
            };
        }
        let (shaped, length) = self.shapes.shaped(p, &self.context);
        match length > letters {
            true => self.name(self.shapes.name(p)),
            false => self.expr(&shaped),
        }
    }

    /// The name of a polynomial.
    fn name(&self, number: usize) -> String {
        let name = self.shapes.written(number, &self.context);
        match self.form {
            Form::Plain => name,
            Form::Html => math(&self.letter(&name)),
            Form::Latex => format!("${}$", self.letter(&name)),
        }
    }

    /// What the names of long polynomials stand for, as text: the name, the number of terms, and the polynomial.
    pub(super) fn legend(&self) -> Vec<(String, usize, String)> {
        let told = |(number, p): (usize, Poly)| {
            let (shaped, _) = self.shapes.shaped(&p, &self.context);
            let told = match self.form {
                // what stands in parentheses, and a long number, is not broken there
                Form::Latex if p.bits() > MOST_BITS => self.words(&sum(&p).plain(&self.context)),
                Form::Latex => self.expr(&sum(&p)),
                Form::Plain | Form::Html => self.expr(&shaped),
            };
            (self.name(number), p.len(), told)
        };
        self.shapes.all().into_iter().enumerate().map(told).collect()
    }

    /// A polynomial that is a factor or has a power.
    pub(super) fn in_parentheses(&self, p: &Poly) -> String {
        let is_letter = matches!(p.vars()[..], [v] if *p == Poly::var(v));
        if is_letter && (self.form != Form::Plain || self.shapes.are_named()) {
            return self.poly(p);
        }
        let told = self.poly_within(p, MOST_OF_FACTOR);
        let named =
            self.shapes.are_named() && self.shapes.shaped(p, &self.context).1 > MOST_OF_FACTOR;
        if named { told } else { format!("({told})") }
    }

    /// A power behind parentheses.
    pub(super) fn power(&self, n: u32) -> String {
        match (n, self.form) {
            (1, _) => String::new(),
            (n, Form::Plain) => format!("^{n}"),
            (n, Form::Html) => format!("<sup>{n}</sup>"),
            (n, Form::Latex) => format!("$^{{{n}}}$"),
        }
    }

    /// weight · square² · Π factorⁿ
    pub(super) fn summand(&self, summand: &Summand) -> String {
        let mut factors = summand.factors.clone();
        if summand.square != Poly::one() {
            factors.insert(0, (summand.square.clone(), 2));
        }
        self.product(&summand.weight, &factors)
    }

    /// weight · Π factorⁿ
    pub(super) fn product(&self, weight: &BigInt, factors: &[(Poly, u32)]) -> String {
        let power = |(p, n): &(Poly, u32)| format!("{}{}", self.in_parentheses(p), self.power(*n));
        let mut told: Vec<String> = factors.iter().map(power).collect();
        if !weight.is_one() || told.is_empty() {
            told.insert(0, self.number(&weight.clone().into()));
        }
        told.join(self.times())
    }

    /// The sign between factors.
    pub(super) fn times(&self) -> &'static str {
        match self.form {
            Form::Plain => "*",
            Form::Html => "·",
            Form::Latex => "$\\cdot$\\allowbreak{}",
        }
    }

    /// What an atom says; one side each for the positive and the negative terms reads best.
    pub(super) fn atom(&self, a: &Atom) -> String {
        if self.shapes.are_named() {
            return self.shaped_atom(a);
        }
        let side = |negative: bool| {
            let terms = a.poly.terms().filter(|(_, c)| c.is_negative() == negative);
            Poly::sum(terms.map(|(m, c)| (m.to_vec(), c.abs())))
        };
        let (left, right) = (side(false), side(true));
        let relation = match a.sign {
            Sign::Zero => "=",
            Sign::NonZero => "!=",
            Sign::NonNegative => ">=",
            Sign::Positive => ">",
        };
        self.compared(&self.poly(&left), relation, &self.poly(&right))
    }

    /// What an atom says, with factors apart where that is shorter, and a name for what is long.
    fn shaped_atom(&self, a: &Atom) -> String {
        let p = a.poly.primitive().1;
        let side = |negative: bool| {
            let terms = p.terms().filter(|(_, c)| c.is_negative() == negative);
            Poly::sum(terms.map(|(m, c)| (m.to_vec(), c.abs())))
        };
        let (left, right) = (side(false), side(true));
        let length = |p: &Poly| self.shapes.shaped(p, &self.context).1;
        let apart = length(&left) + length(&right);
        let (opposite, whole) = (p.neg(), length(&p));
        let whole_is_shorter =
            !left.is_empty() && !right.is_empty() && whole + 3 < apart || apart > MOST_OF_ATOM;
        let (left, right) = match whole_is_shorter {
            false => (left, right),
            true if length(&opposite) < whole => (Poly::default(), opposite),
            true => (p, Poly::default()),
        };
        let relation = match a.sign {
            Sign::Zero => "=",
            Sign::NonZero => "!=",
            Sign::NonNegative => ">=",
            Sign::Positive => ">",
        };
        let side = |p: &Poly| self.poly_within(p, MOST_OF_ATOM);
        self.compared(&side(&left), relation, &side(&right))
    }

    /// A polynomial compared with 0.
    pub(super) fn against_zero(&self, p: &Poly, relation: &str) -> String {
        self.compared(&self.poly(p), relation, &self.number(&BigRational::zero()))
    }

    /// Two sides that are written already, compared.
    pub(super) fn compared(&self, left: &str, relation: &str, right: &str) -> String {
        joined(self.form, left, relation, right)
    }

    /// A relation.
    pub(crate) fn relation(&self, r: &Relation) -> String {
        match Logic::of(r) {
            Some(_) if self.form == Form::Plain => r.plain(&self.context),
            Some(logic) => self.formula(&logic),
            None => self.compared(&self.expr(&r.lhs), comparison(r.rel), &self.expr(&r.rhs)),
        }
    }

    /// `or`, `implies` and `iff` between relations, in words.
    fn formula(&self, logic: &Logic<'_>) -> String {
        let one = |r: &Relation| match Logic::of(r) {
            Some(logic) => format!("({})", self.formula(&logic)),
            None => self.relation(r),
        };
        let part =
            |relations: &[Relation]| relations.iter().map(one).collect::<Vec<_>>().join(" and ");
        logic.written(part, [" or ", " implies ", " iff "])
    }

    /// Relations with commas between; those that share a side become a chain.
    pub(crate) fn relations(&self, relations: &[Relation]) -> String {
        match self.form {
            Form::Plain => relations.plain(&self.context),
            Form::Html | Form::Latex => self.chain(relations),
        }
    }

    fn chain(&self, relations: &[Relation]) -> String {
        let mut out = String::new();
        let mut last: Option<&Expr> = None;
        for r in relations {
            if last == Some(&r.lhs) && Logic::of(r).is_none() {
                out = self.compared(&out, comparison(r.rel), &self.expr(&r.rhs));
            } else {
                let comma = if last.is_some() { ", " } else { "" };
                out = format!("{out}{comma}{}", self.relation(r));
            }
            last = Some(&r.rhs);
        }
        out
    }

    /// A quotient in parentheses, even where its parts would not need them.
    pub(super) fn quotient(&self, (num, den): &(Poly, Poly)) -> String {
        if self.shapes.are_named() && self.form == Form::Plain {
            return self.divided(num, den);
        }
        let is_small = num.len() <= MOST_IN_FRACTION && den.len() <= MOST_IN_FRACTION;
        if self.form != Form::Plain && *den == Poly::one() {
            return self.poly(num);
        }
        if self.form != Form::Plain && is_small {
            return self.expr(&Expr::Div(expression(num).into(), expression(den).into()));
        }
        format!("{}/{}", self.in_parentheses(num), self.in_parentheses(den))
    }

    /// A quotient as text, with no parentheses but those that it needs.
    fn divided(&self, num: &Poly, den: &Poly) -> String {
        let is_product = |p: &Poly| {
            let (shaped, length) = self.shapes.shaped(p, &self.context);
            length > MOST_OF_FACTOR
                || !matches!(shaped, Expr::Add(..) | Expr::Sub(..) | Expr::Neg(..))
        };
        let is_one = |p: &Poly| {
            let (shaped, length) = self.shapes.shaped(p, &self.context);
            length > MOST_OF_FACTOR || matches!(shaped, Expr::Var(_) | Expr::Num(_) | Expr::Pow(..))
        };
        let part = |p: &Poly, bare: bool| {
            let told = self.poly_within(p, MOST_OF_FACTOR);
            if bare { told } else { format!("({told})") }
        };
        if *den == Poly::one() {
            return self.poly(num);
        }
        format!("{}/{}", part(num, is_product(num)), part(den, is_one(den)))
    }

    /// A quotient, or the numerator alone if the denominator is 1.
    pub(super) fn ratio(&self, ratio: &(Poly, Poly)) -> String {
        match ratio.1.as_constant() {
            Some(c) if c.is_one() => self.poly(&ratio.0),
            _ => self.quotient(ratio),
        }
    }

    /// A side of a limit as a substitution for its variable.
    pub(super) fn side(&self, side: &Side, power: u32) -> String {
        let germ = Expr::Var(self.germ);
        let n = i32::try_from(power).unwrap_or(i32::MAX);
        let t = || match n {
            1 => germ.clone(),
            n => Expr::Pow(germ.clone().into(), n),
        };
        let value = match (&side.at, side.above) {
            (None, true) => Expr::Div(Expr::int(1).into(), t().into()),
            (None, false) => Expr::Neg(Expr::Div(Expr::int(1).into(), t().into()).into()),
            (Some(a), true) if a.is_zero() => t(),
            (Some(a), false) if a.is_zero() => Expr::Neg(t().into()),
            (Some(a), true) => Expr::Add(literal(a).into(), t().into()),
            (Some(a), false) => Expr::Sub(literal(a).into(), t().into()),
        };
        let moving = Relation { lhs: Expr::Var(side.var), rel: Rel::Eq, rhs: value };
        self.relation(&moving)
    }

    /// The place of the t of a germ.
    pub(super) fn germ(&self) -> usize {
        self.germ
    }

    /// t > 0
    pub(super) fn small_germ(&self) -> String {
        self.compared(&self.symbol(self.germ), ">", &self.number(&BigRational::zero()))
    }

    /// t = 0
    pub(super) fn no_germ(&self) -> String {
        self.compared(&self.symbol(self.germ), "=", &self.number(&BigRational::zero()))
    }

    /// How a limit variable moves.
    pub(super) fn moving(&self, var: usize, at: &Approach) -> String {
        let one_sided = |a: &BigRational, sign: &str| {
            let raised = match self.form {
                Form::Plain => sign.to_owned(),
                Form::Html => format!("<sup>{}</sup>", sign.replace('-', "−")),
                Form::Latex => format!("$^{{{sign}}}$"),
            };
            format!("{}{raised}", self.number(a))
        };
        let point = match at {
            Approach::To(a) => self.number(a),
            Approach::Above(a) => one_sided(a, "+"),
            Approach::Below(a) => one_sided(a, "-"),
            Approach::PlusInf => self.infinity(true),
            Approach::MinusInf => self.infinity(false),
        };
        self.compared(&self.symbol(var), "->", &point)
    }

    /// A limit.
    pub(super) fn limit(&self, l: &kane_kernel::Limit) -> String {
        let to = match &l.to {
            Target::Finite(value) => self.expr(value),
            Target::PlusInf => self.infinity(true),
            Target::MinusInf => self.infinity(false),
        };
        let tends = self.compared(&self.expr(&l.expr), "->", &to);
        format!("{tends} as {}", self.moving(l.var, &l.at))
    }

    pub(super) fn minus(&self) -> &'static str {
        match self.form {
            Form::Plain => "-",
            Form::Html => "−",
            Form::Latex => "$-$",
        }
    }

    /// Infinity, or its opposite.
    pub(super) fn infinity(&self, positive: bool) -> String {
        let sign = if positive { "" } else { self.minus() };
        match self.form {
            Form::Plain => format!("{sign}oo"),
            Form::Html => format!("{sign}∞"),
            Form::Latex => format!("{sign}$\\infty$"),
        }
    }

    /// A rational number; a very long one by its size.
    pub(super) fn number(&self, q: &BigRational) -> String {
        let text = q.to_string();
        match self.form {
            Form::Plain if text.len() > 80 => format!("about {}", decimal(q)),
            Form::Plain => text,
            _ if text.len() > 80 => self.words(&format!("about {}", decimal(q))),
            _ if text.len() <= MOST_DIGITS => self.expr(&literal(q)),
            _ => match text.strip_prefix('-') {
                Some(size) => format!("{}{}", self.minus(), self.words(size)),
                None => self.words(&text),
            },
        }
    }
}

/// An integer in HTML.
fn bare_integer(q: &BigRational) -> String {
    q.to_string().replace('-', "−")
}

/// Two sides with a relation between.
pub(super) fn joined(form: Form, left: &str, relation: &str, right: &str) -> String {
    let relation = match (form, relation) {
        (Form::Plain, relation) => relation,
        (Form::Html, "!=") => "≠",
        (Form::Html, ">=") => "≥",
        (Form::Html, "<=") => "≤",
        (Form::Html, ">") => "&gt;",
        (Form::Html, "<") => "&lt;",
        (Form::Html, "->") => "→",
        (Form::Html, relation) => relation,
        (Form::Latex, relation) => return in_math(left, relation, right),
    };
    format!("{left} {relation} {right}")
}

/// The same in LaTeX, in one formula where both sides are formulas.
fn in_math(left: &str, relation: &str, right: &str) -> String {
    let relation = match relation {
        "!=" => "\\ne",
        ">=" => "\\ge",
        "<=" => "\\le",
        "->" => "\\to",
        relation => relation,
    };
    let left = match left.strip_suffix('$') {
        Some(open) => open.to_owned(),
        None => format!("{left} $"),
    };
    let right = match right.strip_prefix('$') {
        Some(open) => open.to_owned(),
        None => format!("$ {right}"),
    };
    format!("{left} {relation} {right}")
}

/// A formula in MathML. A number alone needs no setting, and a group alone is none.
fn math(inside: &str) -> String {
    let inside = &*tight(inside);
    let (sign, unsigned) = match inside.strip_prefix("<mo>−</mo>") {
        Some(rest) => ("−", rest),
        None => ("", inside),
    };
    let within = |tag: &str, text: &str| {
        let text = text.strip_prefix(&format!("<{tag}>"))?.strip_suffix(&format!("</{tag}>"))?;
        (!text.contains(&format!("<{tag}>"))).then(|| text.to_owned())
    };
    match (within("mn", unsigned), within("mrow", inside)) {
        (Some(number), _) => format!("{sign}{number}"),
        (_, Some(alone)) => format!("<math>{alone}</math>"),
        _ => format!("<math>{inside}</math>"),
    }
}

/// Text for HTML.
pub(crate) fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests;
