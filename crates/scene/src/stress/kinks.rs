//! α close to where a law changes its regime: the error of k, absolute.

use kane_algebra::sign_table::simplest_between;
use kane_impact::laws::{RouthNewton, Walton, WangSuLi};
use kane_impact::{Contact, Law};
use kane_number::{Lane as _, Number, Rational, changes};

use super::{Row, integer, ratio};

/// The absolute error of k at a contact with the given α, a float; ∞ where floats have no answer, `None`
/// where the law has none in rational numbers.
fn k_error(law: &Law, alpha: &Rational) -> Option<f64> {
    let exact = law.over().resolve(&Contact::of_alpha(alpha.clone())).ok()?.slip.double();
    let found = law.over().resolve(&Contact::of_alpha(<f64 as Number>::from_rational(alpha))).ok();
    let found = found.and_then(|outcome| outcome.slip.double().exact());
    Some(found.map_or(f64::INFINITY, |k| num_traits::Signed::abs(&(k - exact)).to_f64()))
}

/// The α below 5 at which the law changes its regime on contacts of α: found between sixteenths, and then
/// the simplest fraction where bisection ends.
pub(super) fn kinks(law: &Law) -> Vec<Rational> {
    let regime = |alpha: &Rational| {
        law.over().resolve(&Contact::of_alpha(alpha.clone())).ok().map(|outcome| outcome.regime)
    };
    let sixteenths: Vec<Rational> = (1..=80).map(|n| ratio(n, 16)).collect();
    let mut out: Vec<Rational> = changes(&sixteenths, 40, regime)
        .into_iter()
        // an end may itself be the kink, on whichever side its guard puts it
        .map(|[low, high]| (&low + &low - &high, &high + &high - &low))
        .map(|(low, high)| simplest_between(Some(&low), Some(&high)))
        .collect();
    out.dedup();
    out
}

/// Of all laws at all their kinks, the worst error at each offset.
struct Worst {
    offsets: Vec<Rational>,
    errors: Vec<f64>,
}

impl Worst {
    fn visit(&mut self, law: &Law) {
        for kink in kinks(law) {
            for (offset, worst) in self.offsets.iter().zip(&mut self.errors) {
                let error = k_error(law, &(&kink + offset));
                *worst = worst.max(error.unwrap_or(0.0));
            }
        }
    }
}

/// α beside 1/2, where sliding ends, beside 3/4, where it does if half of the slip comes back, beside 1,
/// where the paper's k changes its sign, and beside every kink of every law.
pub(super) fn rows(laws: &[Law], rows: &mut Vec<Row>) {
    let places: Vec<(u32, i64)> =
        [10, 20, 30, 40, 50].into_iter().flat_map(|power| [(power, -1), (power, 1)]).collect();
    let offset = |(power, sign): &(u32, i64)| ratio(*sign, 1) / integer(1 << power);
    let offsets: Vec<Rational> = places.iter().map(offset).collect();
    let mut worst = Worst { errors: vec![0.0; offsets.len()], offsets };
    laws.iter().for_each(|law| worst.visit(law));
    for (n, (power, sign)) in places.iter().enumerate() {
        let tiny = &worst.offsets[n];
        let to = format!("{}2^-{power}", if *sign < 0 { "-" } else { "+" });
        let mut push = |pushed, method, error: Option<f64>| {
            let (to, error) = (to.clone(), error.unwrap_or(f64::INFINITY));
            rows.push(Row { case: "kink, error of k", pushed, to, method, error });
        };
        let beside = |place: Rational| place + tiny;
        let half = k_error(&Law::from(RouthNewton), &beside(ratio(1, 2)));
        push("alpha from 1/2 by", "routh-newton/f64", half);
        // with a share of 1/2 given back sliding ends at (1 + 1/2)/2
        let walton = Walton { restitution: ratio(1, 2) };
        let at_end = k_error(&Law::from(walton), &beside(ratio(3, 4)));
        push("alpha from 3/4 by", "walton/f64", at_end);
        let turned = k_error(&Law::from(WangSuLi), &beside(integer(1)));
        push("alpha from 1 by", "wang-su-li/f64", turned);
        push("alpha from a kink by", "all laws, worst", Some(worst.errors[n]));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_kinks_of_laws_are_where_their_formulas_meet() {
        assert_eq!(kinks(&Law::from(RouthNewton)), [ratio(1, 2)], "k = 1 - 2*alpha meets 0");
        assert_eq!(kinks(&Law::from(Walton { restitution: ratio(1, 2) })), [ratio(3, 4)]);
        assert!(kinks(&Law::from(WangSuLi)).is_empty(), "one formula for all alpha");
    }
}
