use kane_impact::laws::{WangSuLi, WhittakerUncapped};
use kane_impact::{Alpha, ImpactLaw};
use kane_number::Rational;
use proptest::prelude::*;

use crate::strategies::positive;
use crate::{cases, rational};

proptest! {
    #![proptest_config(cases(12_000))]

    /// Conditions (10) to (13) are limits; with a rate they can be tested at one point:
    /// k + 1 = 2/(1 + α), i_x = 1/(1 + α), 1 − k = 2α/(1 + α), 1 − i_x = α/(1 + α).
    #[test]
    fn connection_conditions_hold_with_rate(alpha in positive()) {
        let law = WangSuLi.ratios(&Alpha::Finite(alpha.clone())).expect("total");
        let one = rational(1, 1);
        let within = |distance: Rational, bound: &Rational| distance <= *bound && -distance <= *bound;
        prop_assert!(within(&law.k + &one, &(rational(2, 1) / &alpha)));
        prop_assert!(within(law.impulse.clone(), &(&one / &alpha)));
        prop_assert!(within(&one - &law.k, &(rational(2, 1) * &alpha)));
        prop_assert!(within(&one - &law.impulse, &alpha));
    }

    /// (12) and (13) hold for Whittaker's law too; (10) and (11) fail by any margin.
    #[test]
    fn whittaker_misses_the_conditions_of_normal_collision(alpha in positive()) {
        let law = WhittakerUncapped.ratios(&Alpha::Finite(alpha.clone())).expect("finite α");
        let one = rational(1, 1);
        prop_assert_eq!(&law.impulse, &one);
        prop_assert_eq!(&one - &law.k, rational(2, 1) * &alpha);
        prop_assert_eq!(law.k < -one.clone(), alpha > one);
    }
}

#[test]
fn the_limits_themselves_are_attained() {
    let (zero, one) = (rational(0, 1), rational(1, 1));
    let grazing = WangSuLi.ratios(&Alpha::Finite(zero.clone())).expect("total");
    assert_eq!((&grazing.k, &grazing.impulse), (&one, &one));
    let normal = WangSuLi.ratios(&Alpha::Infinite).expect("total");
    assert_eq!((normal.k, normal.impulse), (-one, zero));
}
