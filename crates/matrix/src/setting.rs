//! Families of contacts in symbols, which together are all contacts that a property speaks of.
//!
//! Every family is a bijection from an orthant onto its contacts, so that a statement about the
//! contacts is one about signs of polynomials on that orthant. With c = (1 + e)·a,
//!
//! ```text
//! W_nn = w    W_tn = ±nu·w/mu    W_tt = (nu² + d)·w/mu²    c = gamma·mu·v    det W = d·w²/mu² > 0
//! ```
//!
//! so that W = U·Uᵀ with an upper triangular U and a positive diagonal, for d > 0 alone; and without
//! coupling W_tt = 2·alpha·w/(gamma·mu²), so that alpha is the paper's.

use std::cmp::Ordering;

use kane_algebra::rational_function::RationalFunction;
use kane_impact::{Contact, Delassus};
use kane_kernel::{Bound, Context, Var};
use kane_number::{Number, Rational};
use num_traits::{Signed as _, Zero as _};

use crate::stop::Stop;

/// A number in symbols.
pub type Symbolic = RationalFunction;

/// How contacts are written in symbols, for people; formulas stand between backticks.
pub const SYMBOLS_IN_WORDS: &str = "\
In symbols: `c = (1 + e)*a` is the change of normal velocity by Newton's rule, `W_nn = w`, `c = gamma*mu*v`, and
`W_tt = 2*alpha*w/(gamma*mu^2)` where `W_tn = 0`; else `W_tn` = ±`nu*w/mu` and `W_tt = (nu^2 + d)*w/mu^2`, so that
det `W` = `d*w^2/mu^2`. Where `v = 0`, `c = gamma`, and `W_tt = d` if `W_tn = 0`. All of these are positive.
Where `q` stands in place of `v`, the contact is as the law sees it in its own frame, `v` = ±`q - W_tn*a/W_nn` there,
`c = gamma*mu*q`, and where `q = 0`, `c = gamma`.
Where it is said how the slip stops: `p = v/s` is the normal impulse until then and `u` the normal speed at it, `T = W_tt`,
`nu` = |`W_tn`|, `s = mu*T - W_tn`, `a1 = W_nn - mu*W_tn`, `t` = |`mu*T - nu`|, `d` = det `W`; of a jam, `b = -a1` and `r` = det `W`/`T`; in
restitution `e*a = u + h` and `a = u + h + g`.
Factors that are visibly positive are left out.";

/// The symbols of all families; the last three are roots.
pub(crate) const NAMES: [&str; 12] =
    ["v", "w", "mu", "gamma", "nu", "d", "e", "alpha", "beta", "x", "y", "z"];
pub(crate) const V: usize = 0;
pub(crate) const W: usize = 1;
pub(crate) const MU: usize = 2;
pub(crate) const GAMMA: usize = 3;
pub(crate) const NU: usize = 4;
pub(crate) const D: usize = 5;
pub(crate) const E: usize = 6;
pub(crate) const ALPHA: usize = 7;
pub(crate) const BETA: usize = 8;
/// The roots of up to three applications of a law.
pub(super) const ROOTS: [usize; 3] = [9, 10, 11];

/// A family of contacts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Setting {
    /// W_tn = 0, v > 0, a > 0, mu > 0
    Sphere,
    /// W_tn > 0, v > 0, a > 0, mu > 0
    Driving,
    /// W_tn < 0, v > 0, a > 0, mu > 0
    Braking,
    /// v = 0 and W_tn = 0, mu >= 0, a >= 0
    RestingSphere,
    /// v = 0, W_tn > 0, mu > 0, a > 0
    Resting,
    /// a > 0 and mu > 0 with any v, in the law's own frame: the signs of W_tn and of
    /// q = v + W_tn·a/W_nn, the slip that is left when a normal push has stopped the approach
    Seen {
        /// of W_tn
        coupling: Ordering,
        /// of q
        slip: Ordering,
    },
    /// W_tn ≠ 0, v > 0, a > 0, mu > 0, and the slip stops
    Stopped(Stop),
}

/// All families of contacts.
pub(crate) const FAMILIES: [Setting; 5] =
    [Setting::Sphere, Setting::Driving, Setting::Braking, Setting::RestingSphere, Setting::Resting];

impl Setting {
    /// What it is, for people.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Sphere => "W_tn = 0",
            Self::Driving => "W_tn > 0",
            Self::Braking => "W_tn < 0",
            Self::RestingSphere => "W_tn = 0, v = 0",
            Self::Resting => "W_tn > 0, v = 0",
            Self::Stopped(stop) => stop.name(),
            Self::Seen { coupling, slip } => match (coupling, slip) {
                (Ordering::Greater, Ordering::Greater) => "W_tn > 0, q > 0",
                (Ordering::Greater, Ordering::Equal) => "W_tn > 0, q = 0",
                (Ordering::Greater, Ordering::Less) => "W_tn > 0, q < 0",
                (Ordering::Equal, Ordering::Greater) => "W_tn = 0, q > 0",
                (Ordering::Equal, Ordering::Equal) => "W_tn = 0, q = 0",
                (Ordering::Equal, Ordering::Less) => "W_tn = 0, q < 0",
                (Ordering::Less, Ordering::Greater) => "W_tn < 0, q > 0",
                (Ordering::Less, Ordering::Equal) => "W_tn < 0, q = 0",
                (Ordering::Less, Ordering::Less) => "W_tn < 0, q < 0",
            },
        }
    }

    /// All contacts with a > 0 and mu > 0, as a law sees them in its own frame.
    pub(crate) fn seen() -> impl Iterator<Item = Self> {
        const SIGNS: [Ordering; 3] = [Ordering::Greater, Ordering::Equal, Ordering::Less];
        let with = |coupling| SIGNS.map(|slip| Self::Seen { coupling, slip });
        SIGNS.into_iter().flat_map(with)
    }

    /// Whether there are slip and approach, in the contact's own frame.
    pub(crate) fn approaches(self) -> bool {
        matches!(self, Self::Sphere | Self::Driving | Self::Braking)
    }

    /// The symbols with their ranges.
    #[must_use]
    pub fn context(self) -> Context {
        let end = |value: i64, strict| {
            Some(Bound { value: Rational::from_integer(value.into()), strict })
        };
        let (renamed, weak) = match self {
            Self::RestingSphere => (Vec::new(), vec![MU, GAMMA]),
            Self::Seen { .. } => (vec![(V, "q")], Vec::new()),
            Self::Stopped(stop) => stop.symbols(),
            _ => (Vec::new(), Vec::new()),
        };
        let vars = NAMES.iter().enumerate().map(|(index, &name)| {
            let (lower, upper) = match index {
                E => (end(0, false), end(1, false)),
                index if ROOTS.contains(&index) => (None, None),
                index => (end(0, !weak.contains(&index)), None),
            };
            let name = renamed.iter().rev().find(|r| r.0 == index).map_or(name, |r| r.1);
            Var { name: name.into(), of: None, lower, upper }
        });
        Context { vars: vars.collect(), ..Context::default() }
    }

    /// The contact of these symbols.
    #[must_use]
    pub fn contact(self) -> Contact<Symbolic> {
        let [v, w, mu, gamma, nu, d, e, alpha] =
            [V, W, MU, GAMMA, NU, D, E, ALPHA].map(Symbolic::symbol);
        let one = <Symbolic as Number>::one;
        let closing = gamma.clone() * &mu * &v;
        let coupled = |nu: Symbolic| {
            let tn = nu.clone() * &w / &mu;
            let tt = (nu.square() + &d) * &w / mu.square();
            Delassus::unchecked(tt, tn, w.clone())
        };
        let (slip, closing, delassus) = match self {
            Self::Sphere => {
                let tt = alpha.double() * &w / (gamma * mu.square());
                (v, closing, Delassus::unchecked(tt, <Symbolic as Number>::zero(), w))
            }
            Self::Driving => (v, closing, coupled(nu)),
            Self::Braking => (v, closing, coupled(-nu)),
            // without slip gamma is c and d is W_tt itself
            Self::RestingSphere => (
                <Symbolic as Number>::zero(),
                gamma,
                Delassus::unchecked(d, <Symbolic as Number>::zero(), w),
            ),
            Self::Resting => (<Symbolic as Number>::zero(), gamma, coupled(nu)),
            Self::Stopped(stop) => return stop.contact(),
            Self::Seen { coupling, slip } => {
                let signed = |sign: Ordering, x: Symbolic| match sign {
                    Ordering::Greater => x,
                    Ordering::Equal => <Symbolic as Number>::zero(),
                    Ordering::Less => -x,
                };
                let closing = if slip == Ordering::Equal { gamma } else { closing };
                let w = coupled(signed(coupling, nu));
                // v = q - W_tn·a/W_nn
                let pushed = closing.clone() / (one() + &e) * w.tn() / w.nn();
                (signed(slip, v) - pushed, closing, w)
            }
        };
        Contact::unchecked(slip, closing / (one() + &e), delassus, mu, e)
    }

    /// The values of the symbols at a contact that faces forwards, if it is of this family.
    #[must_use]
    pub fn values(self, contact: &Contact<Rational>) -> Option<Vec<(usize, Rational)>> {
        let (v, mu, e) = (contact.slip(), contact.friction(), contact.restitution());
        let (w, closing) = (contact.delassus(), contact.closing());
        let inside = match self {
            Self::Sphere => w.tn().is_zero() && v.is_positive(),
            Self::Driving => w.tn().is_positive() && v.is_positive(),
            Self::Braking => w.tn().is_negative() && v.is_positive(),
            Self::RestingSphere => w.tn().is_zero() && v.is_zero(),
            Self::Resting => w.tn().is_positive() && v.is_zero(),
            // nothing is looked for there
            Self::Seen { .. } | Self::Stopped(_) => false,
        };
        let known = self == Self::RestingSphere || (mu.is_positive() && closing.is_positive());
        if !inside || !known {
            return None;
        }
        let mut values = vec![(W, w.nn().clone()), (MU, mu.clone()), (E, e.clone())];
        if v.is_positive() {
            values.push((V, v.clone()));
            values.push((GAMMA, &closing / (mu * v)));
        } else {
            values.push((GAMMA, closing.clone()));
        }
        match self {
            Self::Sphere => values.push((ALPHA, contact.alpha()?)),
            Self::RestingSphere => values.push((D, w.tt().clone())),
            Self::Driving
            | Self::Braking
            | Self::Resting
            | Self::Seen { .. }
            | Self::Stopped(_) => {
                let nu = mu * w.tn().abs() / w.nn();
                values.push((D, mu * mu * w.tt() / w.nn() - &nu * &nu));
                values.push((NU, nu));
            }
        }
        values.sort_by_key(|(symbol, _)| *symbol);
        Some(values)
    }
}
