//! Smith's law where tangential and normal impulse couple and the slip reverses: a cubic.

use kane::impact::laws::Smith1991;
use kane::impact::{Contact, Delassus, ImpactLaw};
use kane::number::{Number, Ordered, Rational, Real, decode};

use super::{exact, magnitude};

/// W = (5/2, 3/2, 1), μ = 1/2, e = 7/10, v = (−1, −1/2).
fn contact<N: Real>() -> Contact<N> {
    let n = |text| N::from_rational(&exact(text));
    let delassus = Delassus::new(n("5/2"), n("3/2"), n("1")).expect("positive definite");
    Contact::new(n("-1"), n("1/2"), delassus, n("1/2"), n("7/10")).expect("a contact")
}

/// By hand, with v = 1, a = 1/2, W_tn = −3/2 in the mirror and c = (1 + e)·a = 17/20:
/// (k − 1)·((1 + k²) + ¾·(1 − k²)) + 17/20·(5/4·(1 − k²) + 3/2·(1 + k²)) = 0, times 80.
fn by_hand(k: &Rational) -> Rational {
    let [k1, k2, k3] = [k.clone(), k * k, k * k * k];
    exact("20") * k3 - exact("3") * k2 + exact("140") * k1 + exact("47")
}

/// Source: derived here from C. E. Smith's law (1991) as quoted by Chatterjee and Ruina (1998),
/// i = (1 − k²)/(1 + k²) for k < 0 with Newton's restitution; original not consulted.
#[test]
fn the_coefficients_are_those_found_by_hand() {
    let mirrored = contact::<Rational>().mirrored();
    let regimes = Smith1991.regimes::<Rational>();
    let regime = regimes.iter().find(|regime| regime.name == "reverse, coupled");
    let root = regime.and_then(|regime| regime.root.as_ref()).expect("it has a root");
    let found = (root.coefficients)(&Smith1991, &mirrored);
    let hand = ["47", "140", "-3", "20"].map(exact);
    let factor = &found[0] / &hand[0];
    assert!(factor > Rational::zero(), "{found:?}");
    assert_eq!(found, hand.map(|c| c * &factor));
}

/// The derivative 60k² − 6k + 140 has a negative discriminant, so the cubic grows and has one root.
///
/// How far may the float be? With u = 2⁻⁵³, half an ulp of 1, the coefficients divided by 80 are
/// rounded by at most 12.3u (47/80 is 2.3375 − 1.75, of which the first has 3.5 relative errors of u,
/// with that of e = 0.7 itself, and the second 2), 3.5u, 1.3u and 0.5u. At |k| < 1/3 these add up to
/// 14u, the slope there is 142.7/80 > 1.78, and so the root moves by at most 8u, which is 16 ulp of k.
/// One more for finding it: the cubic changes sign between the 17th neighbours.
#[test]
fn the_float_root_is_the_root_to_rounding() {
    let contact = contact::<f64>();
    let chosen = Smith1991.regime(&contact).unwrap_or_else(|error| unreachable!("{error}"));
    assert_eq!(chosen.regime.name, "reverse, coupled");
    let k = chosen.root;
    let at = |x: f64| by_hand(&decode(x).expect("finite"));
    let neighbour = |next: fn(f64) -> f64| (0..17).fold(k, |x, _| next(x));
    let (below, above) = (neighbour(f64::next_down), neighbour(f64::next_up));
    assert!(at(below) < Rational::zero() && at(above) > Rational::zero(), "k = {k}");

    let outcome = Smith1991.resolve(&contact).expect("the law has an answer");
    let ratios = outcome.ratios(&contact).expect("a slip and friction");
    // k after the fact: v + W·p of three products near 1, each rounded once, and one division
    let distance = magnitude(decode(ratios.k).expect("finite") - decode(k).expect("finite"));
    assert!(distance < Rational::new(8.into(), 1.into()) * decode(f64::EPSILON).expect("finite"));
    // k is between the rational neighbours of the root, by hand
    assert!(by_hand(&exact("-0.329")) < Rational::zero(), "left of the root");
    assert!(by_hand(&exact("-0.328")) > Rational::zero(), "right of the root");
    assert_eq!(decode(k).expect("finite").compare(&exact("-0.328")).is_less(), Some(true));
}

/// The root is irrational (a rational one would divide: ±p/q with p | 47, q | 20), and exact numbers
/// say so instead of rounding.
#[test]
fn exact_numbers_do_not_round_the_root() {
    for p in [1, 47] {
        for q in [1, 2, 4, 5, 10, 20] {
            let root = Rational::new((-p).into(), q.into());
            assert_ne!(by_hand(&root), Rational::zero());
        }
    }
    assert!(Smith1991.resolve(&contact::<Rational>()).is_err());
}
