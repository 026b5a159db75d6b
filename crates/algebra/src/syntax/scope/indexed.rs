//! Indices, and the symbols for powers, terms and sums.

use kane_kernel::{Bound, Expr, Var};
use num_rational::BigRational;
use num_traits::Zero as _;

use super::super::names::{canonical_name, latex_name};
use super::super::sequence::{Sequences, bounds_of_power};
use super::super::summation::Summation;
use super::{DeclareError, Scope, spelled};

impl Scope {
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

    /// Declares a sequence by s(0), and by s(n + 1), in which a [placeholder](super::super::placeholder) stands
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
}
