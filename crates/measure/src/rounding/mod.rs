//! Bounds on rounding errors that a program which we did not write can prove.
//!
//! A law that comes to a straight line of operations has, in a binary format, an error that Gappa
//! can bound and Coq can check. This module says what is to be proved: the operations, the exact
//! value, and a bound in ulps on each piece of the domain. Nothing is proved here.

mod gappa;

use kane_number::{Binary, Rational, System, ulp};
use num_bigint::BigInt;
use num_traits::Zero;

/// A bound on the error of a quantity of the paper's law as computed from α, in one format.
#[derive(Clone, Debug)]
pub struct RoundingBound {
    /// the law's id
    pub law: &'static str,
    /// `k`, `i_x` or `Delta_e`
    pub quantity: &'static str,
    /// the methods of the chart that compute it by these operations, by their names
    pub methods: &'static [&'static str],
    /// `f32` or `f64`
    pub system: System,
    /// the operations, one a line: after `rnd=` every operation is rounded, after `=` none, and
    /// `rnd(…)` is rounded once
    pub operations: &'static str,
    /// the name of the result among them
    pub result: &'static str,
    /// the same quantity without any rounding, by lines of the same kind that end in one for `exact`
    pub exact: &'static str,
    /// the error that is bounded
    pub error: &'static str,
    /// identities of real numbers that the proof needs
    pub hints: &'static str,
    /// the bound, in ulps of the exact value; exact
    pub ulps: Rational,
    /// whether the error is that before the last rounding, which adds half an ulp and no more
    pub before_last_rounding: bool,
    /// the domain, in pieces on which the ulp does not change
    pub pieces: Vec<Piece>,
}

/// A part of the domain, from one end to the other with both included.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Piece {
    /// the lower end of α
    pub from: Rational,
    /// the upper end of α
    pub to: Rational,
    /// the least ulp of exact values there; 0 where the value is 0
    pub ulp: Rational,
}

impl RoundingBound {
    /// What it is called: law, quantity, method and format.
    #[must_use]
    pub fn name(&self) -> String {
        let method = self.methods.first().map_or("", |name| name.trim_matches(['(', ')']));
        format!("{}-{}-{method}-{}", self.law, self.quantity, self.system)
    }

    /// The bound on the error of the result, in ulps of the exact value; exact.
    #[must_use]
    pub fn whole(&self) -> Rational {
        let half = Rational::new(1.into(), 2.into());
        if self.before_last_rounding { &self.ulps + half } else { self.ulps.clone() }
    }
}

/// Where α ends: 2³⁰, as in the chart.
const REACH: u32 = 30;

/// Ends of pieces are multiples of 2⁻⁶⁰.
const GRID: u32 = 60;

fn power(exponent: u32) -> BigInt {
    BigInt::from(1) << exponent
}

/// The pieces between two multiples of 2^−[`GRID`], for a value whose magnitude is monotone there.
///
/// A piece ends at the last multiple with its ulp, and the next begins at the next multiple. Between
/// the two lies no float: the ulps of all values here change at α > 2⁻⁷ only, where floats are
/// multiples. With `binades`, a piece also ends where a binade of α does, from 1 on.
fn pieces<F: Binary>(
    value: fn(&Rational) -> Rational,
    from: &BigInt,
    to: &BigInt,
    binades: bool,
) -> Vec<Piece> {
    let at = |m: &BigInt| Rational::new(m.clone(), power(GRID));
    let unit = |m: &BigInt| ulp::<F>(&value(&at(m)));
    let mut found = Vec::new();
    let mut start = from.clone();
    while &start < to {
        let binade: BigInt = start.clone().max(power(GRID - 1)) * 2;
        let widest = if binades { binade.min(to.clone()) } else { to.clone() };
        let (mut last, mut beyond) = (&start + 1, widest.clone());
        let inside = unit(&last);
        if unit(&widest) == inside {
            found.push(Piece { from: at(&start), to: at(&widest), ulp: inside });
            start = widest;
            continue;
        }
        while &last + 1 < beyond {
            let middle: BigInt = (&last + &beyond) / 2;
            if unit(&middle) == inside { last = middle } else { beyond = middle }
        }
        found.push(Piece { from: at(&start), to: at(&last), ulp: inside });
        start = beyond;
    }
    found
}

fn k(alpha: &Rational) -> Rational {
    let one = Rational::from_integer(1.into());
    (&one - alpha) / (one + alpha)
}

fn share(alpha: &Rational) -> Rational {
    let one = Rational::from_integer(1.into());
    &one / (&one + alpha)
}

fn loss(alpha: &Rational) -> Rational {
    let share = share(alpha);
    -(&share * &share)
}

/// The quantities, without format and pieces.
struct Line {
    quantity: &'static str,
    methods: &'static [&'static str],
    operations: &'static str,
    result: &'static str,
    exact: &'static str,
    error: &'static str,
    hints: &'static str,
    /// in 128ths of an ulp
    ulps: i64,
    before_last_rounding: bool,
    value: fn(&Rational) -> Rational,
}

const LINES: [Line; 5] = [
    Line {
        quantity: "k",
        methods: &["law"],
        // es and ed are what TwoSum returns: exact, by D. Knuth's theorem
        operations: "\
s rnd= 1 + a;
d rnd= 1 - a;
es = (1 + a) - s;
ed = (1 - a) - d;
q rnd= d / s;
r = rnd(d - q * s);
m rnd= (r + ed) - q * es;
c rnd= m / s;
k rnd= q + c;",
        result: "k",
        exact: "\
M = ((d - q * s) + ed) - q * es;
exact = (1 - a) / (1 + a);",
        error: "(q + c) - exact",
        hints: "\
d - q * s -> -(q - d / s) * s { s <> 0 };
(q + c) - exact -> (c - m / s) + (m - M) / s + M * es / (s * (1 + a)) { s <> 0, 1 + a <> 0 };",
        ulps: 1,
        before_last_rounding: true,
        value: k,
    },
    Line {
        quantity: "k",
        methods: &["(16)"],
        operations: "\
d rnd= 1 - a;
s rnd= 1 + a;
k rnd= d / s;",
        result: "k",
        exact: "exact = (1 - a) / (1 + a);",
        error: "k - exact",
        hints: "",
        ulps: 2 * 128,
        before_last_rounding: false,
        value: k,
    },
    Line {
        quantity: "i_x",
        methods: &["law", "(17)"],
        operations: "\
s rnd= 1 + a;
i rnd= 1 / s;",
        result: "i",
        exact: "exact = 1 / (1 + a);",
        error: "i - exact",
        hints: "",
        ulps: 3 * 64,
        before_last_rounding: false,
        value: share,
    },
    Line {
        quantity: "Delta_e",
        methods: &["law", "e_a"],
        operations: "\
s rnd= 1 + a;
i rnd= 1 / s;
e rnd= -(i * i);",
        result: "e",
        exact: "\
I = 1 / (1 + a);
exact = -(I * I);",
        error: "e - exact",
        hints: "",
        ulps: 4 * 128,
        before_last_rounding: false,
        value: loss,
    },
    Line {
        quantity: "Delta_e",
        methods: &["(19x)"],
        operations: "\
s rnd= 1 + a;
t rnd= s * s;
e rnd= -(1 / t);",
        result: "e",
        exact: "exact = -(1 / ((1 + a) * (1 + a)));",
        error: "e - exact",
        hints: "",
        ulps: 4 * 128,
        before_last_rounding: false,
        value: loss,
    },
];

/// The domain in pieces: α from 0 to 2³⁰; for k without the gaps next to 1, in which no float lies,
/// and for its plain quotient no further than 2^p, from where on 1 − α and 1 + α need not differ.
fn domain<F: Binary>(line: &Line) -> Vec<Piece> {
    let (none, one, reach) = (BigInt::zero(), power(GRID), power(REACH + GRID));
    if line.quantity != "k" {
        return pieces::<F>(line.value, &none, &reach, false);
    }
    let corrected = line.before_last_rounding;
    let reach = if corrected { reach } else { reach.min(power(F::PRECISION + GRID)) };
    let below = &one - power(GRID - F::PRECISION);
    let above = &one + power(GRID - F::PRECISION + 1);
    let at_one = Rational::from_integer(1.into());
    let mut all = pieces::<F>(line.value, &none, &below, corrected);
    all.push(Piece { from: at_one.clone(), to: at_one, ulp: Rational::zero() });
    all.extend(pieces::<F>(line.value, &above, &reach, corrected));
    all
}

/// All bounds: of the paper's law in `f64` and `f32`, and of the literal forms of the chart that have
/// one. The other forms cancel, and have no bound in ulps.
#[must_use]
pub fn rounding_bounds() -> Vec<RoundingBound> {
    let bound = |line: &Line, system: System| RoundingBound {
        law: "wang-su-li",
        quantity: line.quantity,
        methods: line.methods,
        system,
        operations: line.operations,
        result: line.result,
        exact: line.exact,
        error: line.error,
        hints: line.hints,
        ulps: Rational::new(line.ulps.into(), 128.into()),
        before_last_rounding: line.before_last_rounding,
        pieces: match system {
            System::F32 => domain::<f32>(line),
            _ => domain::<f64>(line),
        },
    };
    LINES.iter().flat_map(|line| [System::F64, System::F32].map(|s| bound(line, s))).collect()
}
