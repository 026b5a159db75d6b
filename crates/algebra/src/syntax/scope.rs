//! What names mean at a place in a document.

use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};

use kane_kernel::{Bound, Context, Definition, Expr, Var};
use num_rational::BigRational;
use num_traits::{Signed as _, Zero as _};
use thiserror::Error;

use super::error::SyntaxErrorKind;
use super::exponential_symbol::{
    Exponential, bounds_of_exponential, bounds_of_logarithm, bounds_of_product, exponential_name,
    named_powers,
};
use super::monomial::Monomial;
use super::names::{
    PI, RESERVED, applied, canonical_name, latex_name, power as power_name, rate, summed,
};
use super::sequence::{Sequences, bounds_of_power};
use super::summation::Summation;
use super::template::{Template, parameter};
use super::value::{Array, Shape, Value};

/// Nodes that all visits of a scope may see together. Definitions that share others can make
/// every visit as long as the document.
const MAX_EFFORT: usize = 50_000_000;

/// Parts of expressions that vectors, matrices and definitions with arguments may be written out to.
const MAX_WRITTEN: usize = 5_000_000;
/// Derivatives by the chain rule of which it is noted how they were written.
const MAX_DERIVATIVES: usize = 1_000;

/// What a name stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Symbol {
    /// index of [`Context::vars`]
    Var(usize),
    /// index of [`Context::lets`]
    Let(usize),
}

/// What stands for an angle: cosine and sine of one of its equal parts, as symbols.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Angle {
    /// the cosine of the part
    pub cos: usize,
    /// the sine of the part
    pub sin: usize,
    /// how many parts make the angle
    pub parts: u32,
}

/// Why a name cannot be declared.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum DeclareError {
    /// a word of the language
    #[error("`{0}` is a reserved word and cannot be a name")]
    ReservedWord(String),
    /// the name is taken
    #[error("`{name}` is already declared")]
    Redeclared {
        /// the name
        name: String,
        /// what it stands for already
        first: Symbol,
    },
    /// the name is one of a vector, a matrix, or a definition with arguments
    #[error("`{0}` is already declared")]
    Taken(String),
    /// another name looks the same in print, as `v_x0` and `vx0` do
    #[error("`{name}` and `{other}` look the same in print")]
    Alike {
        /// the name
        name: String,
        /// the one that is there already
        other: String,
    },
}

/// `cos(theta/2)` as programs spell it that have names of letters alone.
fn spelled(name: &str) -> String {
    let mut out = String::new();
    for c in canonical_name(name).chars() {
        match c {
            '*' => out.push_str("_times_"),
            '^' => out.push_str("_to_"),
            '/' => out.push_str("_over_"),
            c if c.is_alphanumeric() || c == '\'' => out.push(c),
            _ => out.push('_'),
        }
    }
    out
}

/// The symbols and definitions known so far, by name.
#[derive(Clone, Debug, Default)]
pub struct Scope {
    context: Context,
    names: HashMap<String, Symbol>,
    /// each name as it was written, by what it looks like in print
    typeset: HashMap<String, String>,
    /// height of each definition, those that it uses expanded
    heights: Vec<usize>,
    /// what stands for the symbols that are angles
    angles: HashMap<usize, Angle>,
    /// angles that stand by themselves, as numbers
    measured: BTreeSet<usize>,
    /// by what is in them, exponentials and logarithms
    exponentials: BTreeMap<(Monomial, bool), Exponential>,
    /// variables of limits
    limited: BTreeSet<usize>,
    /// by symbol, what stands for its distance from the point to which it tends
    pub(super) shifts: BTreeMap<usize, usize>,
    /// by function, the symbol for its derivative
    rates: BTreeMap<usize, usize>,
    /// vectors and matrices: how their components are arranged, and what stands for each
    arrays: HashMap<String, (Shape, Vec<Symbol>)>,
    /// definitions with arguments
    functions: HashMap<String, Template>,
    /// indices, and the symbols for powers and terms
    sequences: Sequences,
    /// by base as it is named and index, the symbol for a power
    powers: BTreeMap<(String, usize), usize>,
    /// sequences by name: the index, and the term at it
    terms: HashMap<String, (usize, Expr)>,
    /// sums and products up to an index, with the symbol of each
    sums: HashMap<Summation, usize>,
    /// nodes visited so far
    effort: Cell<usize>,
    /// parts written out so far
    written: Cell<usize>,
    /// derivatives by the chain rule, each with what was differentiated by which symbol
    derivatives: RefCell<Vec<(Expr, Expr)>>,
}

impl Scope {
    /// The scope of a finished context. Later entries under a name already taken stay unnamed.
    #[must_use]
    pub fn of(context: &Context) -> Self {
        let mut scope = Self::default();
        for var in &context.vars {
            scope.enter(&var.name, Symbol::Var(scope.context.vars.len()));
            scope.context.vars.push(var.clone());
        }
        for (index, var) in context.vars.iter().enumerate() {
            scope.recognise(index, &var.name);
        }
        for definition in &context.lets {
            scope.enter(&definition.name, Symbol::Let(scope.context.lets.len()));
            let height = scope.height(&definition.body);
            scope.heights.push(height);
            scope.context.lets.push(definition.clone());
        }
        scope
    }

    fn enter(&mut self, name: &str, symbol: Symbol) {
        self.names.entry(canonical_name(name).into_owned()).or_insert(symbol);
        self.typeset.entry(latex_name(name)).or_insert_with(|| name.to_owned());
    }

    /// Takes the cosine of an angle, or the derivative of a function, for what its name says.
    fn recognise(&mut self, index: usize, name: &str) {
        let symbol = |name: &str| match self.resolve(name) {
            Some(Symbol::Var(symbol)) => Some(symbol),
            _ => None,
        };
        if let Some((function, _)) = rate(name) {
            if let Some(function) = symbol(function) {
                self.rates.insert(function, index);
            }
        } else if let Some(sum) = summed(name) {
            let n = sum.to.split(" + ").next().and_then(symbol);
            n.into_iter().for_each(|n| self.sequences.add_index(n));
        } else if let Some((base, n)) = power_name(name) {
            if let Some(n) = symbol(n) {
                self.sequences.add_index(n);
                self.powers.insert((canonical_name(base).into_owned(), n), index);
            }
        } else if let Some((sequence, n)) =
            applied(name).filter(|(f, _)| !["cos", "sin", "exp", "log"].contains(f))
        {
            if let Some(n) = symbol(n) {
                self.sequences.add_index(n);
                let name = canonical_name(sequence).into_owned();
                self.terms.insert(name, (n, Expr::Var(index)));
            }
        } else if let Some((function @ ("exp" | "log"), part)) = applied(name) {
            let Some((powers, parts)) = named_powers(part) else { return };
            let resolved: Option<Vec<(usize, i32)>> =
                powers.iter().map(|(name, n)| Some((symbol(name)?, *n))).collect();
            if let Some(powers) = resolved {
                let parts = if function == "log" { 0 } else { parts };
                let of = Monomial::of(powers);
                let found = Exponential { symbol: index, of: of.clone(), parts, exact: false };
                self.exponentials.insert((of, parts == 0), found);
            }
        } else if let Some(("cos", part)) = applied(name) {
            let (angle, parts) = part.split_once('/').unwrap_or((part, "1"));
            if let (Some(angle), Ok(parts)) = (symbol(angle), parts.parse()) {
                // the sine is declared behind the cosine
                self.angles.insert(angle, Angle { cos: index, sin: index + 1, parts });
            }
        }
    }

    /// The symbols and definitions.
    #[must_use]
    pub fn context(&self) -> &Context {
        &self.context
    }

    /// The symbols and definitions, at the end of the text.
    #[must_use]
    pub fn into_context(self) -> Context {
        self.context
    }

    /// What the name stands for, in either spelling.
    #[must_use]
    pub fn resolve(&self, name: &str) -> Option<Symbol> {
        self.names.get(canonical_name(name).as_ref()).copied()
    }

    /// All names, in canonical spelling and no particular order.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        let names = self.names.keys().chain(self.arrays.keys()).chain(self.functions.keys());
        names.chain(self.terms.keys()).map(String::as_str)
    }

    fn check_free(&self, name: &str) -> Result<(), DeclareError> {
        if RESERVED.contains(&canonical_name(name).as_ref()) {
            return Err(DeclareError::ReservedWord(name.to_owned()));
        }
        match self.resolve(name) {
            Some(first) => Err(DeclareError::Redeclared { name: name.to_owned(), first }),
            None if !self.is_unused(name) => Err(DeclareError::Taken(name.to_owned())),
            None => match self.typeset.get(&latex_name(name)) {
                Some(other) => {
                    Err(DeclareError::Alike { name: name.to_owned(), other: other.clone() })
                }
                None => Ok(()),
            },
        }
    }

    /// Whether nothing at all has the name.
    #[must_use]
    pub fn is_unused(&self, name: &str) -> bool {
        let name = canonical_name(name);
        self.resolve(&name).is_none()
            && !self.arrays.contains_key(name.as_ref())
            && !self.functions.contains_key(name.as_ref())
            && !self.terms.contains_key(name.as_ref())
    }

    /// Gives a name to symbols or definitions as the components of a vector or a matrix.
    ///
    /// # Errors
    /// As [`declare`](Self::declare).
    pub fn declare_array(
        &mut self,
        name: &str,
        shape: Shape,
        parts: Vec<Symbol>,
    ) -> Result<(), DeclareError> {
        self.check_free(name)?;
        self.typeset.entry(latex_name(name)).or_insert_with(|| name.to_owned());
        self.arrays.insert(canonical_name(name).into_owned(), (shape, parts));
        Ok(())
    }

    /// The vector or the matrix of this name.
    #[must_use]
    pub fn array(&self, name: &str) -> Option<Array> {
        let (shape, parts) = self.arrays.get(canonical_name(name).as_ref())?;
        let part = |symbol: &Symbol| match symbol {
            Symbol::Var(index) => Expr::Var(*index),
            Symbol::Let(index) => Expr::Let(*index),
        };
        Some(Array { shape: *shape, parts: parts.iter().map(part).collect() })
    }

    /// Adds a definition that takes so many arguments; a [placeholder](super::placeholder) stands for
    /// each in its body.
    ///
    /// # Errors
    /// As [`declare`](Self::declare).
    pub fn define_function(
        &mut self,
        name: &str,
        takes: usize,
        body: Value,
    ) -> Result<(), DeclareError> {
        self.check_free(name)?;
        self.typeset.entry(latex_name(name)).or_insert_with(|| name.to_owned());
        let height = body.parts().iter().map(|part| self.height(part)).max().unwrap_or(0);
        let template = Template::new(takes, body, height);
        self.functions.insert(canonical_name(name).into_owned(), template);
        Ok(())
    }

    /// Whether the name is one of a definition with arguments.
    #[must_use]
    pub fn is_function(&self, name: &str) -> bool {
        self.functions.contains_key(canonical_name(name).as_ref())
    }

    pub(crate) fn function(&self, name: &str) -> Option<&Template> {
        self.functions.get(canonical_name(name).as_ref())
    }

    /// Notes what a derivative by the chain rule is the derivative of, so that it can be shown as it was written.
    pub fn note_derivative(&self, slope: &Expr, f: &Expr, by: usize) {
        let is_sum = matches!(
            slope,
            Expr::Add(..) | Expr::Sub(..) | Expr::Mul(..) | Expr::Div(..) | Expr::Neg(..)
        );
        let mut known = self.derivatives.borrow_mut();
        if is_sum && known.len() < MAX_DERIVATIVES && known.iter().all(|(shown, _)| shown != slope)
        {
            known.push((slope.clone(), Expr::Deriv(f.clone().into(), by)));
        }
    }

    /// Derivatives by the chain rule, each with the derivative as it was written.
    #[must_use]
    pub fn derivatives(&self) -> Vec<(Expr, Expr)> {
        self.derivatives.borrow().clone()
    }

    /// Notes that so many parts are to be written out, and tells whether they may be.
    pub(crate) fn charge(&self, parts: usize) -> bool {
        let written = self.written.get().saturating_add(parts);
        self.written.set(written);
        written <= MAX_WRITTEN
    }

    /// Declares an index, a natural number.
    ///
    /// # Errors
    /// As [`declare`](Self::declare).
    pub fn declare_index(&mut self, name: &str) -> Result<usize, DeclareError> {
        let lower = Some(Bound { value: BigRational::zero(), strict: false });
        let symbol = self.declare(Var { name: name.to_owned(), of: None, lower, upper: None })?;
        self.sequences.add_index(symbol);
        Ok(symbol)
    }

    /// Declares the symbol for the power of a base to an index: `base` is a number, a plain symbol or a
    /// definition that is [total](Self::is_total), and goes by `name`.
    ///
    /// # Errors
    /// As [`declare`](Self::declare).
    pub fn declare_power(
        &mut self,
        name: &str,
        base: Expr,
        index: usize,
    ) -> Result<(), DeclareError> {
        let n = self.context.vars.get(index).map_or("?", |var| &var.name);
        let whole = format!("pow({name}, {n})");
        let end = |bound: &Option<Bound>| bound.as_ref().map(|b| (b.value.clone(), b.strict));
        let ends = match &base {
            Expr::Num(q) => [Some((q.clone(), false)), Some((q.clone(), false))],
            Expr::Var(v) => {
                let var = self.context.vars.get(*v);
                var.map_or([None, None], |var| [end(&var.lower), end(&var.upper)])
            }
            _ => [None, None],
        };
        let bound = |(value, strict)| Bound { value, strict };
        let [lower, upper] = bounds_of_power(ends).map(|end| end.map(bound));
        let symbol = self.declare_compound(Var { name: whole, of: None, lower, upper })?;
        self.sequences.add_power(symbol, base, index);
        self.powers.insert((canonical_name(name).into_owned(), index), symbol);
        Ok(())
    }

    /// Declares a symbol with a name that is put together, such as `s(n)`.
    fn declare_compound(&mut self, var: Var) -> Result<usize, DeclareError> {
        self.check_free(&spelled(&var.name))?;
        self.typeset.entry(latex_name(&spelled(&var.name))).or_insert_with(|| var.name.clone());
        self.declare(var)
    }

    /// Declares a sequence by its term at an index.
    ///
    /// # Errors
    /// As [`declare`](Self::declare).
    pub fn declare_sequence(
        &mut self,
        name: &str,
        index: usize,
        term: Expr,
    ) -> Result<(), DeclareError> {
        self.check_free(name)?;
        self.typeset.entry(latex_name(name)).or_insert_with(|| name.to_owned());
        self.terms.insert(canonical_name(name).into_owned(), (index, term));
        Ok(())
    }

    /// Declares a sequence by s(0), and by s(n + 1), in which a [placeholder](super::placeholder) stands
    /// for s(n); both are [total](Self::is_total).
    ///
    /// # Errors
    /// As [`declare`](Self::declare).
    pub fn declare_recursion(
        &mut self,
        name: &str,
        index: usize,
        first: Expr,
        step: impl FnOnce(&Expr) -> Expr,
    ) -> Result<(), DeclareError> {
        self.check_free(name)?;
        let n = self.context.vars.get(index).map_or("?", |var| &var.name);
        let whole = format!("{name}({n})");
        let symbol =
            self.declare_compound(Var { name: whole, of: None, lower: None, upper: None })?;
        let term = Expr::Var(symbol);
        self.sequences.add_recursion(symbol, index, first, step(&term));
        self.declare_sequence(name, index, term)
    }

    /// Declares the symbol of a sum up to an index, whose terms are [total](Self::is_total).
    ///
    /// # Errors
    /// As [`declare`](Self::declare).
    pub fn declare_sum(&mut self, name: &str, sum: Summation) -> Result<(), DeclareError> {
        let whole = Var { name: name.to_owned(), of: None, lower: None, upper: None };
        // signs are told apart, which `declare_compound` does not need
        let signs =
            [('+', "_plus_"), ('-', "_minus_"), ('*', "_times_"), ('/', "_over_"), ('^', "_to_")];
        let spelled = signs.iter().fold(name.to_owned(), |name, (c, word)| name.replace(*c, word));
        let spelled = self::spelled(&spelled);
        self.check_free(&spelled)?;
        self.typeset.entry(latex_name(&spelled)).or_insert_with(|| name.to_owned());
        let symbol = self.declare(whole)?;
        let next = sum.joined(Expr::Var(symbol));
        self.sequences.add_recursion(symbol, sum.index, sum.first.clone(), next);
        self.sums.insert(sum, symbol);
        Ok(())
    }

    /// The symbol of a sum up to an index.
    #[must_use]
    pub fn sum(&self, sum: &Summation) -> Option<usize> {
        self.sums.get(sum).copied()
    }

    /// Indices, powers and terms.
    #[must_use]
    pub fn sequences(&self) -> &Sequences {
        &self.sequences
    }

    /// The symbol for a power, by its base as it is named.
    pub(crate) fn power(&self, base: &str, index: usize) -> Option<usize> {
        self.powers.get(&(canonical_name(base).into_owned(), index)).copied()
    }

    /// Whether the power has its symbol.
    #[must_use]
    pub fn has_power(&self, base: &str, index: usize) -> bool {
        self.power(base, index).is_some()
    }

    /// The index of a sequence, and its term at it.
    pub(crate) fn term(&self, name: &str) -> Option<&(usize, Expr)> {
        self.terms.get(canonical_name(name).as_ref())
    }

    /// Whether the name is one of a sequence.
    #[must_use]
    pub fn is_sequence(&self, name: &str) -> bool {
        self.term(name).is_some()
    }

    /// Whether an expression has a value at all points of the declared domain, for reasons that are
    /// seen at once: it is a polynomial in plain symbols, divided by products of numbers and of symbols
    /// whose bounds exclude 0. Of indices it may speak of this one; of functions and angles of none.
    #[must_use]
    pub fn is_total(&self, e: &Expr, index: Option<usize>) -> bool {
        let mut total = !self.is_exhausted();
        self.visit(e, &mut |node| {
            total &= match node {
                Expr::Var(v) if parameter(*v).is_none() => {
                    let plain = self.context.vars.get(*v).is_some_and(|var| var.of.is_none());
                    let own = self.sequences.index_of(*v).is_none_or(|n| Some(n) == index);
                    let angle = self.angle(*v).is_some() || self.angle_at(*v).is_some();
                    plain && own && !angle
                }
                Expr::Num(_) | Expr::Var(_) | Expr::Let(_) | Expr::Neg(_) => true,
                Expr::Add(..) | Expr::Sub(..) | Expr::Mul(..) => true,
                Expr::Div(_, b) => self.never_vanishes(b),
                Expr::Pow(_, n) => *n >= 0,
                _ => false,
            };
        });
        total && !self.is_exhausted()
    }

    /// Whether an expression has a value whatever its symbols are within their declared bounds, for reasons
    /// that are seen at once: it divides by what never vanishes by what is declared, and has no roots,
    /// cases and derivatives.
    #[must_use]
    pub fn has_value(&self, e: &Expr) -> bool {
        let mut has = !self.is_exhausted();
        self.visit(e, &mut |node| {
            has &= match node {
                Expr::Num(_) | Expr::Var(_) | Expr::Let(_) | Expr::Neg(_) => true,
                Expr::Add(..) | Expr::Sub(..) | Expr::Mul(..) => true,
                Expr::Abs(_) | Expr::Min(..) | Expr::Max(..) => true,
                Expr::Div(_, b) => self.never_vanishes(b),
                Expr::Pow(a, n) => *n >= 0 || self.never_vanishes(a),
                _ => false,
            };
        });
        has && !self.is_exhausted()
    }

    /// Whether it is not 0 by what is declared: a product of numbers and symbols, and of sums of what is
    /// not negative and one of which is positive.
    pub(crate) fn never_vanishes(&self, e: &Expr) -> bool {
        match e {
            Expr::Num(q) => !q.is_zero(),
            Expr::Add(..) | Expr::Sub(..) => self.is_above(e, true),
            Expr::Var(v) => self.context.vars.get(*v).is_some_and(|var| {
                let beyond = |b: &Bound, sign: bool| match b.value.is_zero() {
                    true => b.strict,
                    false => b.value.is_negative() == sign,
                };
                var.lower.as_ref().is_some_and(|bound| beyond(bound, false))
                    || var.upper.as_ref().is_some_and(|bound| beyond(bound, true))
            }),
            Expr::Neg(a) | Expr::Pow(a, _) => self.never_vanishes(a),
            Expr::Mul(a, b) => self.never_vanishes(a) && self.never_vanishes(b),
            _ => false,
        }
    }

    /// Whether it is not negative, or positive, by what is declared.
    #[must_use]
    pub fn is_above(&self, e: &Expr, strictly: bool) -> bool {
        let above = |e: &Expr| self.is_above(e, strictly);
        if let Some(sum) = self.sequences.linear(e) {
            return sum.plus >= i64::from(strictly) && sum.times.values().all(|n| *n >= 0);
        }
        match e {
            Expr::Num(q) => q.is_positive() || !strictly && q.is_zero(),
            Expr::Var(v) => {
                let lower = self.context.vars.get(*v).and_then(|var| var.lower.as_ref());
                lower.is_some_and(|b| match b.value.is_zero() {
                    true => b.strict || !strictly,
                    false => b.value.is_positive(),
                })
            }
            Expr::Add(a, b) => {
                let [a, b] = [a, b].map(|e| (self.is_above(e, false), above(e)));
                a.0 && b.1 || a.1 && b.0
            }
            Expr::Mul(a, b) => above(a) && above(b),
            Expr::Div(a, b) => above(a) && self.is_above(b, true),
            Expr::Pow(a, n) => self.is_above(a, strictly || *n < 0),
            _ => false,
        }
    }

    /// Declares a symbol and returns its index.
    ///
    /// # Errors
    /// When the name is reserved or taken, or looks like another one in print.
    pub fn declare(&mut self, var: Var) -> Result<usize, DeclareError> {
        self.check_free(&var.name)?;
        let index = self.context.vars.len();
        self.enter(&var.name, Symbol::Var(index));
        self.context.vars.push(var);
        Ok(index)
    }

    /// Declares a symbol as an angle, with cosine and sine of one of its equal parts; of the variable of a
    /// limit these are functions.
    ///
    /// # Errors
    /// As [`declare`](Self::declare).
    pub fn declare_angle(
        &mut self,
        var: Var,
        parts: u32,
        limited: bool,
    ) -> Result<(usize, Angle), DeclareError> {
        let part = if parts == 1 { var.name.clone() } else { format!("{}/{parts}", var.name) };
        let point = ["cos", "sin"].map(|f| Var {
            name: format!("{f}({part})"),
            of: if limited { Some(self.context.vars.len()) } else { var.of },
            lower: None,
            upper: None,
        });
        for var in &point {
            self.check_free(&spelled(&var.name))?;
        }
        let index = self.declare(var)?;
        let [cos, sin] = point.map(|var| {
            self.typeset.entry(latex_name(&spelled(&var.name))).or_insert_with(|| var.name.clone());
            self.declare(var)
        });
        let angle = Angle { cos: cos?, sin: sin?, parts };
        self.angles.insert(index, angle);
        Ok((index, angle))
    }

    /// Has an angle stand by itself, too, as the number of its radians.
    pub fn declare_measured(&mut self, angle: usize) {
        self.measured.insert(angle);
    }

    /// Whether a symbol is an angle that is known by its direction alone.
    #[must_use]
    pub fn is_unmeasured(&self, symbol: usize) -> bool {
        self.angle(symbol).is_some() && !self.measured.contains(&symbol)
    }

    /// The angles that stand by themselves, with what stands for them.
    pub fn measured(&self) -> impl Iterator<Item = (usize, Angle)> {
        self.measured.iter().filter_map(|v| Some((*v, *self.angle(*v)?)))
    }

    /// Notes that a symbol is the variable of a limit: what stands for its exponentials is a function of it.
    pub fn declare_limited(&mut self, symbol: usize) {
        self.limited.insert(symbol);
    }

    /// The variable with which a product varies: that of the functions in it, or the variable of a limit.
    ///
    /// # Errors
    /// When there are two.
    pub(crate) fn variable_of(&self, of: &Monomial) -> Result<Option<usize>, SyntaxErrorKind> {
        let var = |v: usize| {
            let of = self.context.vars.get(v).and_then(|var| var.of);
            of.or_else(|| self.limited.contains(&v).then_some(v))
        };
        let found: BTreeSet<usize> = of.symbols().filter_map(var).collect();
        match found.len() {
            0 | 1 => Ok(found.into_iter().next()),
            _ => Err(SyntaxErrorKind::TwoVariables),
        }
    }

    /// The symbols of a product by their names.
    pub(crate) fn named(&self, of: &Monomial) -> Vec<(String, i32)> {
        let name = |v: usize| self.context.vars.get(v).map_or("?", |var| &var.name).to_owned();
        of.powers().iter().map(|(v, n)| (name(*v), *n)).collect()
    }

    /// Declares the symbol for the exponential of a part of a product of symbols; of 0 parts for the
    /// logarithm of the symbol that it is.
    ///
    /// # Errors
    /// As [`declare`](Self::declare).
    pub fn declare_exponential(
        &mut self,
        of: &Monomial,
        parts: u32,
    ) -> Result<Exponential, DeclareError> {
        let name = exponential_name(&self.named(of), parts);
        let vars = &self.context.vars;
        let of_product;
        let (ends, all) = match of.as_symbol().and_then(|v| vars.get(v)) {
            Some(var) => ([var.lower.as_ref(), var.upper.as_ref()], true),
            None => {
                of_product = bounds_of_product(of.powers(), vars);
                ([of_product.0[0].as_ref(), of_product.0[1].as_ref()], of_product.1)
            }
        };
        let ([lower, upper], exact) = match parts {
            0 => bounds_of_logarithm(ends),
            _ => bounds_of_exponential(ends),
        };
        let variable = self.variable_of(of).unwrap_or_default();
        let symbol = self.declare_compound(Var { name, of: variable, lower, upper })?;
        let found = Exponential { symbol, of: of.clone(), parts, exact: exact && all };
        self.exponentials.insert((of.clone(), parts == 0), found.clone());
        Ok(found)
    }

    /// All exponentials and logarithms, in the order of what is in them.
    pub fn exponentials(&self) -> impl Iterator<Item = &Exponential> {
        self.exponentials.values()
    }

    /// What stands for the exponential of a product.
    #[must_use]
    pub fn exponential(&self, of: &Monomial) -> Option<&Exponential> {
        self.exponentials.get(&(of.clone(), false))
    }

    /// What stands for the logarithm of a symbol.
    #[must_use]
    pub fn logarithm(&self, of: &Monomial) -> Option<&Exponential> {
        self.exponentials.get(&(of.clone(), true))
    }

    /// What a symbol stands for, if it is an exponential or a logarithm.
    #[must_use]
    pub fn exponential_at(&self, symbol: usize) -> Option<&Exponential> {
        self.exponentials().find(|known| known.symbol == symbol)
    }

    /// What a symbol is, in words, if it is no plain constant: a function, an index, an angle, or what
    /// stands for a power or an exponential.
    #[must_use]
    pub fn kind_of(&self, v: usize) -> Option<&'static str> {
        if v == PI {
            Some("a multiple of it is a bound by itself alone")
        } else if self.angle(v).is_some() || self.angle_at(v).is_some() {
            Some("it is an angle")
        } else if self.sequences.index_of(v) == Some(v) {
            Some("it is an index")
        } else if self.sequences.index_of(v).is_some() {
            Some("it varies with an index")
        } else if self.exponential_at(v).is_some() {
            Some("it is an exponential or a logarithm")
        } else {
            self.context.vars.get(v).and_then(|var| var.of).map(|_| "it is a function")
        }
    }

    /// Whether a symbol may stand in an exponential: it is declared by its name, and is no index and no
    /// angle.
    pub(crate) fn is_exponent(&self, v: usize) -> bool {
        let angle = self.angle(v).is_some() || self.angle_at(v).is_some();
        let plain = |var: &Var| !var.name.contains('(');
        !angle
            && self.sequences.index_of(v).is_none()
            && self.context.vars.get(v).is_some_and(plain)
    }

    /// Declares symbols for the first derivatives of a function, up to an order; nothing for a plain
    /// symbol.
    ///
    /// # Errors
    /// As [`declare`](Self::declare).
    pub fn declare_rates(&mut self, function: usize, order: u32) -> Result<(), DeclareError> {
        let mut last = function;
        for _ in 0..order {
            let vars = &self.context.vars;
            let Some((name, of)) = vars.get(last).and_then(|var| Some((&var.name, var.of?))) else {
                return Ok(());
            };
            let name = format!("d({name}, {})", vars.get(of).map_or("?", |var| &var.name));
            self.check_free(&spelled(&name))?;
            self.typeset.entry(latex_name(&spelled(&name))).or_insert_with(|| name.clone());
            let rate = self.declare(Var { name, of: Some(of), lower: None, upper: None })?;
            self.rates.insert(last, rate);
            last = rate;
        }
        Ok(())
    }

    /// The symbol for the derivative of a function, if one is declared.
    #[must_use]
    pub fn rate(&self, function: usize) -> Option<usize> {
        self.rates.get(&function).copied()
    }

    /// All functions with the symbols for their derivatives.
    #[must_use]
    pub fn rates(&self) -> &BTreeMap<usize, usize> {
        &self.rates
    }

    /// All angles with what stands for them, in no particular order.
    pub fn angles(&self) -> impl Iterator<Item = (usize, Angle)> {
        self.angles.iter().map(|(symbol, angle)| (*symbol, *angle))
    }

    /// What stands for a symbol, if it is an angle.
    #[must_use]
    pub fn angle(&self, symbol: usize) -> Option<&Angle> {
        self.angles.get(&symbol)
    }

    /// The angle of which a symbol is the cosine or the sine, and its symbol.
    #[must_use]
    pub fn angle_at(&self, symbol: usize) -> Option<(usize, Angle)> {
        self.angles().find(|(_, angle)| [angle.cos, angle.sin].contains(&symbol))
    }

    /// Adds a definition and returns its index.
    ///
    /// # Errors
    /// When the name is reserved or taken, or looks like another one in print.
    pub fn define(&mut self, name: &str, body: Expr) -> Result<usize, DeclareError> {
        self.check_free(name)?;
        let index = self.context.lets.len();
        self.enter(name, Symbol::Let(index));
        self.heights.push(self.height(&body));
        self.context.lets.push(Definition { name: name.to_owned(), body });
        Ok(index)
    }

    /// Operations on the longest path from the root to a leaf, definitions expanded; a leaf has 1.
    #[must_use]
    pub fn height(&self, expr: &Expr) -> usize {
        let below = match expr {
            Expr::Let(index) => self.height_of_let(*index),
            _ => expr.children().iter().map(|child| self.height(child)).max().unwrap_or(0),
        };
        below + 1
    }

    pub(crate) fn height_of_let(&self, index: usize) -> usize {
        self.heights.get(index).copied().unwrap_or(0)
    }

    /// Calls `see` on every node of the expression and of the definitions that it uses, each
    /// definition once. Sees fewer when the scope [is exhausted](Self::is_exhausted).
    pub fn visit<'a>(&'a self, expr: &'a Expr, see: &mut impl FnMut(&'a Expr)) {
        let mut seen = HashSet::new();
        let mut pending = vec![expr];
        while let Some(node) = pending.pop() {
            if self.is_exhausted() {
                return;
            }
            self.effort.set(self.effort.get() + 1);
            see(node);
            if let Expr::Let(index) = node
                && seen.insert(*index)
                && let Some(definition) = self.context.lets.get(*index)
            {
                pending.push(&definition.body);
            }
            pending.extend(node.children());
        }
    }

    /// Whether visits have seen more nodes than they may; then what they found is not to be
    /// relied upon.
    #[must_use]
    pub fn is_exhausted(&self) -> bool {
        self.effort.get() >= MAX_EFFORT
    }

    /// These symbols, and those that stand in exponentials among them: k and x of exp(k*x).
    #[must_use]
    pub fn with_factors(&self, mut symbols: BTreeSet<usize>) -> BTreeSet<usize> {
        let exponentials = self.exponentials().filter(|e| symbols.contains(&e.symbol));
        let factors: Vec<usize> = exponentials.flat_map(|e| e.of.symbols()).collect();
        symbols.extend(factors);
        symbols
    }

    /// The same, and all of an angle, its cosine and its sine where one of them is there.
    #[must_use]
    pub fn inside(&self, symbols: BTreeSet<usize>) -> BTreeSet<usize> {
        let mut symbols = self.with_factors(symbols);
        let spoken = self.angles().map(|(theta, a)| [theta, a.cos, a.sin]);
        let spoken: Vec<_> = spoken.filter(|all| all.iter().any(|v| symbols.contains(v))).collect();
        symbols.extend(spoken.into_iter().flatten());
        symbols
    }

    /// Indices of the symbols in the expression, definitions expanded.
    #[must_use]
    pub fn symbols(&self, expr: &Expr) -> BTreeSet<usize> {
        let mut found = BTreeSet::new();
        self.visit(expr, &mut |node| {
            if let Expr::Var(index) | Expr::Deriv(_, index) = node {
                found.insert(*index);
            }
        });
        found
    }

    /// Whether the value may vary with the symbol `x`: through x itself or a function of it,
    /// definitions expanded.
    #[must_use]
    pub fn varies_with(&self, expr: &Expr, x: usize) -> bool {
        let mut varies = false;
        self.visit(expr, &mut |node| {
            if let Expr::Var(index) = node {
                varies |=
                    *index == x || self.context.vars.get(*index).and_then(|v| v.of) == Some(x);
            }
        });
        varies
    }
}
