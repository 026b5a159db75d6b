//! Symbols that stand for exponentials and logarithms: their names, and the bounds that these have from those of
//! what is in them.

use kane_kernel::{Bound, Var};
use num_rational::BigRational;
use num_traits::{One as _, Signed as _, Zero as _};

use super::monomial::Monomial;

/// What stands for the exponential of a part of a product of symbols, or for the logarithm of a symbol.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Exponential {
    /// the symbol that stands for it
    pub symbol: usize,
    /// of what; a logarithm is one of a symbol alone
    pub of: Monomial,
    /// into how many parts that is cut; 0 for a logarithm
    pub parts: u32,
    /// whether its bounds are all that the bounds of the other symbols say
    pub exact: bool,
}

/// A product of symbols by their names, with their powers.
pub type NamedPowers = Vec<(String, i32)>;

/// How an exponential or a logarithm is called: `exp(c*t/m/2)`, `log(x)`.
#[must_use]
pub(crate) fn exponential_name(of: &[(String, i32)], parts: u32) -> String {
    let power = |(name, n): (&str, i32)| match n {
        1 => name.to_owned(),
        n => format!("{name}^{n}"),
    };
    let of_sign = |sign: i32| {
        let found = of.iter().filter(move |(_, n)| n.signum() == sign);
        found.map(|(name, n)| power((name.as_str(), n.abs())))
    };
    let mut whole = of_sign(1).collect::<Vec<_>>().join("*");
    if whole.is_empty() {
        whole.push('1');
    }
    for below in of_sign(-1) {
        whole = format!("{whole}/{below}");
    }
    match parts {
        0 => format!("log({whole})"),
        1 => format!("exp({whole})"),
        n => format!("exp({whole}/{n})"),
    }
}

/// What stands between the parentheses of such a name: the product, and the parts of it.
pub(crate) fn named_powers(argument: &str) -> Option<(NamedPowers, u32)> {
    let power = |factor: &str, sign: i32| -> Option<(String, i32)> {
        let (name, n) = factor.split_once('^').unwrap_or((factor, "1"));
        Some((name.to_owned(), sign * n.parse::<i32>().ok()?))
    };
    let mut pieces = argument.split('/');
    let above = pieces.next().filter(|above| *above != "1");
    let mut powers: NamedPowers =
        above.into_iter().flat_map(|a| a.split('*')).map(|f| power(f, 1)).collect::<Option<_>>()?;
    let mut parts = 1;
    for piece in pieces {
        match piece.parse() {
            Ok(n) => parts = n,
            Err(_) => powers.push(power(piece, -1)?),
        }
    }
    Some((powers, parts))
}

/// The sign that symbols give to a product: its bounds at 0, and whether the symbols' bounds say no more.
pub(crate) fn bounds_of_product(
    powers: &[(usize, i32)],
    vars: &[Var],
) -> ([Option<Bound>; 2], bool) {
    let end = |strict| Some(Bound { value: BigRational::zero(), strict });
    let (mut sign, mut strict, mut exact) = (Some(1), true, true);
    for (v, n) in powers {
        let ends =
            vars.get(*v).map_or([None, None], |var| [var.lower.as_ref(), var.upper.as_ref()]);
        exact &= ends.into_iter().flatten().all(|bound| bound.value.is_zero());
        exact &= !matches!(ends, [Some(_), Some(_)]);
        let beyond = |bound: Option<&Bound>, sign: i32| {
            let bound = bound.filter(|b| match sign {
                1 => !b.value.is_negative(),
                _ => !b.value.is_positive(),
            });
            bound.map(|b| (sign, b.strict || !b.value.is_zero()))
        };
        let [lower, upper] = ends;
        let own = beyond(lower, 1).or_else(|| beyond(upper, -1));
        match (own, n % 2 == 0) {
            (Some((_, apart)), true) => strict &= apart,
            (None, true) => strict = false,
            (Some((side, apart)), false) => {
                sign = sign.map(|sign| sign * side);
                strict &= apart;
            }
            (None, false) => sign = None,
        }
    }
    let ends = match sign {
        Some(1) => [end(strict), None],
        Some(_) => [None, end(strict)],
        None => [None, None],
    };
    (ends, exact)
}

/// What the bounds of a symbol say of its exponential, and whether that is all that they say.
pub(crate) fn bounds_of_exponential(ends: [Option<&Bound>; 2]) -> ([Option<Bound>; 2], bool) {
    let zero = BigRational::zero();
    let above = Bound { value: zero.clone(), strict: true };
    let at_one = |bound: &Bound| {
        let strict = bound.strict || !bound.value.is_zero();
        Bound { value: BigRational::one(), strict }
    };
    let [lower, upper] = ends;
    let exact = ends.into_iter().flatten().all(|bound| bound.value.is_zero());
    let lower = lower.filter(|bound| bound.value >= zero).map_or(above, at_one);
    let upper = upper.filter(|bound| bound.value <= zero).map(at_one);
    ([Some(lower), upper], exact)
}

/// What the bounds of a positive symbol say of its logarithm, and whether that is all that they say.
pub(crate) fn bounds_of_logarithm(ends: [Option<&Bound>; 2]) -> ([Option<Bound>; 2], bool) {
    let one = BigRational::one();
    let at_zero = |bound: &Bound| {
        let strict = bound.strict || !bound.value.is_one();
        Bound { value: BigRational::zero(), strict }
    };
    let [lower, upper] = ends;
    let exact = lower.is_some_and(|b| b.value.is_one() || (b.strict && b.value.is_zero()))
        && upper.is_none_or(|b| b.value.is_one());
    let lower = lower.filter(|bound| bound.value >= one).map(at_zero);
    let upper = upper.filter(|bound| bound.value <= one).map(at_zero);
    ([lower, upper], exact)
}
