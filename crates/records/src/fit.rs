//! Coefficients as the log has them, as intervals, for each pair of materials.

use std::collections::BTreeMap;

use crate::seen::Seen;

/// An interval of values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fitted {
    /// the least
    pub low: f64,
    /// the greatest; ∞ where the log gives no upper bound
    pub high: f64,
    /// rows that speak of it
    pub rows: usize,
    /// whether one value is within the tolerance of each of these rows, so that the interval holds
    /// all such values; otherwise it holds what was measured, from the least to the greatest
    pub one_value: bool,
}

/// The coefficients of a pair of materials.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairFit {
    /// its place among the names
    pub pair: u32,
    /// μ and e as stated
    pub stated: [Option<f64>; 2],
    /// its rows
    pub rows: usize,
    /// e, from every row with an approach
    pub restitution: Option<Fitted>,
    /// μ, from rows that slide on, or at least a lower bound from those that do not
    pub friction: Option<Fitted>,
    /// β0, from rows below the cone
    pub rebound: Option<Fitted>,
}

/// Gathers intervals.
#[derive(Default)]
struct Gathered {
    inner: Option<(f64, f64)>,
    outer: Option<(f64, f64)>,
    rows: usize,
}

impl Gathered {
    fn add(&mut self, value: f64, error: f64) {
        let (low, high) = (value - error, value + error);
        let (inner, outer) =
            (self.inner.unwrap_or((low, high)), self.outer.unwrap_or((value, value)));
        self.inner = Some((inner.0.max(low), inner.1.min(high)));
        self.outer = Some((outer.0.min(value), outer.1.max(value)));
        self.rows += 1;
    }

    fn fitted(&self) -> Option<Fitted> {
        let ((low, high), (least, greatest)) = (self.inner?, self.outer?);
        let one_value = low <= high;
        let (low, high) = if one_value { (low, high) } else { (least, greatest) };
        Some(Fitted { low, high, rows: self.rows, one_value })
    }
}

/// A pair, with what is stated of it.
type Key = (u32, [Option<u64>; 2]);

/// How many pairs with stated coefficients are fitted.
const MOST: usize = 1000;

/// The coefficients of every pair with every stated μ and e, in this order.
#[must_use]
pub fn fits(rows: &[Seen]) -> Vec<PairFit> {
    let mut pairs: BTreeMap<Key, Vec<&Seen>> = BTreeMap::new();
    for seen in rows {
        let stated = [seen.given.friction, seen.given.restitution].map(|x| x.map(f64::to_bits));
        pairs.entry((seen.pair, stated)).or_default().push(seen);
    }
    pairs.into_iter().take(MOST).map(|(key, rows)| of_pair(&rows, key)).collect()
}

fn of_pair(rows: &[&Seen], (pair, stated): Key) -> PairFit {
    let [mut e, mut mu, mut beta] = [(); 3].map(|()| Gathered::default());
    let mut least_friction = 0.0_f64;
    let mut count = 0;
    for seen in rows {
        count += 1;
        if let Some(value) = seen.observed_restitution() {
            // u_n⁺ and a are off by up to so much of a: e·a·(1 ± share) = u_n⁺ ± share·a
            let share = seen.within[1] / seen.approach;
            let error = share * (1.0 + value.abs()) / (1.0 - share);
            e.add(value, if share < 1.0 { error } else { f64::INFINITY });
        }
        if seen.normal <= 2.0 * seen.within[3] {
            continue;
        }
        let ratio = seen.tangential.abs() / seen.normal;
        let error = (seen.within[2] + ratio * seen.within[3]) / seen.normal;
        let opposes = seen.tangential * seen.slip_after < 0.0;
        if seen.slips_after() && opposes {
            mu.add(ratio, error);
        } else {
            least_friction = least_friction.max(ratio - error);
        }
        let below = seen.given.friction.is_none_or(|mu| ratio < mu - 2.0 * error);
        if below && !opposes && seen.slip.abs() > 2.0 * seen.within[0] {
            beta.add(-seen.slip_after / seen.slip, 2.0 * seen.within[0] / seen.slip.abs());
        }
    }
    let at_least = (count > 0 && least_friction > 0.0).then_some(Fitted {
        low: least_friction,
        high: f64::INFINITY,
        rows: count,
        one_value: true,
    });
    PairFit {
        pair,
        stated: stated.map(|bits| bits.map(f64::from_bits)),
        rows: count,
        restitution: e.fitted(),
        friction: mu.fitted().or(at_least),
        rebound: beta.fitted(),
    }
}
