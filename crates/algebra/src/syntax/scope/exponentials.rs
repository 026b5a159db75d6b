//! Exponentials and logarithms, and what stands in them.

use std::collections::BTreeSet;

use kane_kernel::Var;

use super::super::error::SyntaxErrorKind;
use super::super::exponential_symbol::{
    Exponential, bounds_of_exponential, bounds_of_logarithm, bounds_of_product, exponential_name,
};
use super::super::monomial::Monomial;
use super::{DeclareError, Scope};

impl Scope {
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

    /// Whether a symbol may stand in an exponential: it is declared by its name, and is no index and no
    /// angle.
    pub(crate) fn is_exponent(&self, v: usize) -> bool {
        let angle = self.angle(v).is_some() || self.angle_at(v).is_some();
        let plain = |var: &Var| !var.name.contains('(');
        !angle
            && self.sequences.index_of(v).is_none()
            && self.context.vars.get(v).is_some_and(plain)
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
}
