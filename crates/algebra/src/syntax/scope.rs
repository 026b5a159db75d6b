//! What names mean at a place in a document.

mod angles;
mod domain;
mod exponentials;
mod indexed;
mod walk;

use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, BTreeSet, HashMap};

use kane_kernel::{Context, Definition, Expr, Var};
use thiserror::Error;

use super::exponential_symbol::{Exponential, named_powers};
use super::monomial::Monomial;
use super::names::{
    MATHEMATICAL, PI, RESERVED, applied, canonical_name, latex_name, power as power_name, rate,
    summed,
};
use super::sequence::Sequences;
use super::summation::Summation;
use super::template::Template;
use super::value::{Array, Shape, Value};

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
    /// a name that mathematics has given away
    #[error("`{0}` has a meaning of its own and cannot be defined as something else")]
    Mathematical(String),
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

    fn check_definable(&self, name: &str) -> Result<(), DeclareError> {
        if MATHEMATICAL.contains(&canonical_name(name).as_ref()) {
            return Err(DeclareError::Mathematical(name.to_owned()));
        }
        self.check_free(name)
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
        self.check_definable(name)?;
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

    /// Declares a symbol with a name that is put together, such as `s(n)`.
    fn declare_compound(&mut self, var: Var) -> Result<usize, DeclareError> {
        self.check_free(&spelled(&var.name))?;
        self.typeset.entry(latex_name(&spelled(&var.name))).or_insert_with(|| var.name.clone());
        self.declare(var)
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

    /// Adds a definition and returns its index.
    ///
    /// # Errors
    /// When the name is reserved or taken, or looks like another one in print.
    pub fn define(&mut self, name: &str, body: Expr) -> Result<usize, DeclareError> {
        self.check_definable(name)?;
        let index = self.context.lets.len();
        self.enter(name, Symbol::Let(index));
        self.heights.push(self.height(&body));
        self.context.lets.push(Definition { name: name.to_owned(), body });
        Ok(index)
    }
}
