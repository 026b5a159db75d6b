//! Rational numbers against dashu, which shares no code with the library that they rest on.
#![no_main]

use dashu_int::IBig;
use dashu_ratio::RBig;
use kane_number::{Integer, Number, OddFraction, Rational};
use libfuzzer_sys::fuzz_target;

fn pair(numer: &[u8], denom: &[u8]) -> Option<(Rational, RBig)> {
    let own = [numer, denom].map(Integer::from_signed_bytes_le);
    if own[1] == Integer::ZERO {
        return None;
    }
    // the sign of the second goes to the first
    let [n, d] = own.clone().map(|n| n.to_string().parse::<IBig>().expect("digits"));
    let positive = d > IBig::ZERO;
    let (n, d) = if positive { (n, d) } else { (-n, -d) };
    let [numer, denom] = own;
    let theirs = RBig::from_parts(n, d.try_into().expect("it is positive"));
    Some((Rational::new(numer, denom), theirs))
}

fn assert_same(what: &str, own: &Rational, theirs: &RBig) {
    assert_eq!(own.to_string(), theirs.to_string(), "{what}");
}

fuzz_target!(|data: &[u8]| {
    let Some((cuts, rest)) = data.split_first_chunk::<3>() else { return };
    let mut rest = rest;
    let mut part = |cut: usize| {
        let (part, others) = rest.split_at(cut.min(rest.len()));
        rest = others;
        part
    };
    let parts = cuts.map(|cut| part(usize::from(cut)));
    let last = rest;
    let (Some((a, x)), Some((b, y))) = (pair(parts[0], parts[1]), pair(parts[2], last)) else {
        return;
    };
    assert_same("first", &a, &x);
    assert_same("sum", &(&a + &b), &(&x + &y));
    assert_same("difference", &(&a - &b), &(&x - &y));
    assert_same("product", &(&a * &b), &(&x * &y));
    assert_eq!(a.cmp(&b), x.cmp(&y));
    let [c, d] = [&a, &b].map(|q| OddFraction::from_rational(q));
    assert_same("odd sum", &(c.clone() + d.clone()).to_rational(), &(&x + &y));
    assert_same("odd product", &(c * d).to_rational(), &(&x * &y));
    if y != RBig::ZERO {
        assert_same("quotient", &(&a / &b), &(&x / &y));
    }
});
