//! The quick ways of a law, fractions of their own and regimes in a straight line, against its table of
//! regimes, formula by formula.

use kane_impact::{Contact, Facing, Law, NoImpulse, NumberSystem, Outcome, laws};
use kane_number::{Number, Rational, decode};
use proptest::prelude::*;

use crate::cases;
use crate::contacts::contact;
use crate::strategies::float_sphere;

/// What the table says: the formulas of the first regime whose guards hold, in the numbers
/// themselves.
fn by_the_table<N: NumberSystem>(law: &Law, contact: &Contact<N>) -> Result<Outcome<N>, NoImpulse> {
    let law = law.over::<N>();
    let taken = law.regime(contact)?;
    let place = law.place(&taken.contact).expect("it was taken");
    let root = taken.root.unwrap_or_else(N::zero);
    let outcome = law.regimes()[place].outcome(&taken.contact, &root);
    if let Some(quantity) = law.acceptance(&taken.contact, &outcome.impulse)
        && quantity.sign().is_at_least() != Some(true)
    {
        return law.resolve(contact); // which must refuse
    }
    Ok(match taken.facing {
        Facing::Forward => outcome,
        Facing::Backward => outcome.mirrored(),
    })
}

fn is_the_same<N: NumberSystem>(
    contact: &Contact<N>,
    same: fn(&N, &N) -> bool,
) -> Result<(), TestCaseError> {
    for law in laws() {
        let quick = law.over::<N>().resolve(contact);
        let (outcome, expected) = match (&quick, by_the_table(law, contact)) {
            (Ok(outcome), Ok(expected)) => (outcome, expected),
            (Err(error), Err(expected)) => {
                prop_assert_eq!(*error, expected);
                continue;
            }
            (_, expected) => {
                prop_assert!(false, "{}: {:?}, not {:?}", law.info.id, quick, expected);
                continue;
            }
        };
        prop_assert_eq!(outcome.regime, expected.regime);
        let numbers = |o: &Outcome<N>| {
            let Outcome { impulse, slip, separation, work, .. } = o.clone();
            [impulse.tangential, impulse.normal, slip, separation, work.tangential, work.normal]
        };
        for (a, b) in numbers(outcome).iter().zip(&numbers(&expected)) {
            prop_assert!(same(a, b), "{}: {} is not {}", law.info.id, a, b);
        }
        let impulse = law.over::<N>().impulse(contact).expect("it has an outcome");
        prop_assert!(same(&impulse.tangential, &outcome.impulse.tangential));
        prop_assert!(same(&impulse.normal, &outcome.impulse.normal));
    }
    Ok(())
}

/// Equal, and both in lowest terms.
fn identical(a: &Rational, b: &Rational) -> bool {
    (a.numer(), a.denom()) == (b.numer(), b.denom())
}

proptest! {
    #![proptest_config(cases(200))]

    #[test]
    fn fractions_of_their_own_are_those_of_the_table(contact in contact()) {
        is_the_same(&contact, identical)?;
    }

    #[test]
    fn a_straight_line_gives_the_floats_of_the_table_bit_by_bit(contact in contact()) {
        let contact = contact.map(f64::from_rational);
        // NaN and infinities would compare with nothing, and no law promises their bits
        is_the_same(&contact, |a, b| a.to_bits() == b.to_bits() || !a.is_finite())?;
    }
}

proptest! {
    #![proptest_config(cases(40))]

    /// Floats of full significands, whose outcomes have more bits than the short form has room for.
    #[test]
    fn fractions_of_any_size_are_those_of_the_table(sphere in float_sphere()) {
        let exact = sphere.map(|x| decode(*x).expect("finite"));
        if let Ok(contact) = exact.contact() {
            is_the_same(&contact, identical)?;
        }
    }
}
