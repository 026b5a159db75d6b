//! Smith's law where tangential and normal impulse couple and the slip reverses: a cubic.

use kane::impact::laws::Smith1991;
use kane::impact::{Contact, Delassus, ImpactLaw};
use kane::number::{Algebraic, Integer, Number, Rational, Real, Rounding, decode, steps_between};

use super::exact;

/// W = (5/2, 3/2, 1), μ = 1/2, e = 7/10, v = (−1, −1/2).
fn contact<N: Real>() -> Contact<N> {
    let n = |text| N::from_rational(&exact(text));
    let delassus = Delassus::new(n("5/2"), n("3/2"), n("1")).expect("positive definite");
    Contact::new(n("-1"), n("1/2"), delassus, n("1/2"), n("7/10")).expect("a contact")
}

/// By hand, with v = 1, a = 1/2, `W_tn` = −3/2 in the mirror and c = (1 + e)·a = 17/20:
/// (k − 1)·((1 + k²) + 3/4·(1 − k²)) + 17/20·(5/4·(1 − k²) + 3/2·(1 + k²)) = 0, times 80:
/// 20k³ − 3k² + 140k + 47 = 0.
const BY_HAND: [i32; 4] = [47, 140, -3, 20];

/// Source: derived here from C. E. Smith's law (1991) as quoted by Chatterjee and Ruina (1998),
/// i = (1 − k²)/(1 + k²) for k < 0 with Newton's restitution; original not consulted.
#[test]
fn the_coefficients_are_those_found_by_hand() {
    let mirrored = contact::<Rational>().mirrored();
    let regimes = Smith1991.regimes::<Rational>();
    let regime = regimes.iter().find(|regime| regime.name == "reverse, coupled");
    let root = regime.and_then(|regime| regime.root.as_ref()).expect("it has a root");
    let found = (root.coefficients)(&Smith1991, &mirrored);
    let hand = BY_HAND.map(|c| Rational::from_integer(c.into()));
    let factor = &found[0] / &hand[0];
    assert!(factor > Rational::zero(), "{found:?}");
    assert_eq!(found[..], hand.map(|c| c * &factor));
}

/// The derivative 60k² − 6k + 140 has a negative discriminant, so that there is one real root. It is
/// irrational: rational numbers do not round it, and algebraic ones have the cubic as its polynomial.
#[test]
fn exact_numbers_hold_the_root_or_say_that_they_do_not() {
    assert!(Smith1991.resolve(&contact::<Rational>()).is_err());
    let contact = contact::<Algebraic>();
    let outcome = Smith1991.resolve(&contact).expect("an algebraic answer");
    assert_eq!(outcome.regime, "reverse, coupled");
    let ratios = outcome.ratios(&contact).expect("a slip and friction");
    assert_eq!(ratios.k.polynomial(), BY_HAND.map(Integer::from));
    let square = ratios.k.square();
    let one = Algebraic::one;
    assert_eq!(ratios.impulse * (one() + &square), one() - square);
}

/// How far may the float be? With u = 2⁻⁵³, half an ulp of 1, the coefficients divided by 80 are
/// rounded by at most 12.3u (47/80 is 2.3375 − 1.75, of which the first has 3.5 relative errors of u,
/// with that of e = 0.7 itself, and the second 2), 3.5u, 1.3u and 0.5u. At |k| < 1/3 these add up to
/// 14u, the slope there is 142.7/80 > 1.78, and so the root moves by at most 8u, which is 16 ulp of
/// k. One more for finding it.
#[test]
fn the_float_root_is_the_root_to_rounding() {
    let truth = {
        let contact = contact::<Algebraic>();
        let outcome = Smith1991.resolve(&contact).expect("an algebraic answer");
        outcome.ratios(&contact).expect("a slip and friction").k
    };
    let contact = contact::<f64>();
    let chosen = Smith1991.regime(&contact).unwrap_or_else(|error| unreachable!("{error}"));
    assert_eq!(chosen.regime.name, "reverse, coupled");
    let nearest: f64 = truth.encode(Rounding::NearestEven);
    let steps = steps_between(chosen.root, nearest).expect("finite");
    println!("the float root is {steps} steps from the nearest float");
    assert!(steps <= 17, "{} is {steps} steps from {nearest}", chosen.root);
    assert_eq!(decode(nearest).map(|k| super::rounds_to(k, "-0.32835")), Ok(true));
}
