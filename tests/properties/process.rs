//! The laws that are processes, in closed form, against the integration of the process.

use kane_impact::laws::{DjerassiPoisson, DjerassiStronge, Keller1986, RouthNewton, Stronge1990};
use kane_impact::oracle::{Event, integrate};
use kane_impact::{Contact, ImpactLaw, Restitution};
use kane_number::{Algebraic, Rational, Real};
use proptest::prelude::*;

use crate::cases;
use crate::contacts::{contact, tame_contact};

/// Impulse, velocities and work, all exactly.
fn agrees<L: ImpactLaw, N: Real + PartialEq>(
    law: &L,
    contact: &Contact<N>,
) -> Result<(), TestCaseError> {
    let path = integrate(contact, law.restitution())?;
    let (outcome, end) = (law.resolve(contact)?, path.end());
    prop_assert_eq!(&outcome.impulse, &end.impulse, "{}: {:?}", law.id(), contact);
    prop_assert_eq!(&outcome.slip, &end.slip, "{}: {:?}", law.id(), contact);
    prop_assert_eq!(&outcome.separation, &end.normal_velocity, "{}: {:?}", law.id(), contact);
    // the path knows which direction did the work when; the law only the two ends
    let work = end.normal_work.clone() + &end.tangential_work;
    prop_assert_eq!(outcome.work.total(), work, "{}: {:?}", law.id(), contact);
    Ok(())
}

/// The total energy along a path never rises above its start, and friction always takes.
fn dissipates<N: Real>(contact: &Contact<N>, hypothesis: Restitution) -> Result<(), TestCaseError> {
    let path = integrate(contact, hypothesis)?;
    for pair in path.events.windows(2) {
        let friction = pair[1].tangential_work.clone() - &pair[0].tangential_work;
        prop_assert_eq!(friction.sign().is_at_most(), Some(true));
    }
    let end = path.end();
    let total = end.tangential_work.clone() + &end.normal_work;
    prop_assert_eq!(total.sign().is_at_most(), Some(true), "{:?} {:?}", hypothesis, contact);
    Ok(())
}

proptest! {
    #![proptest_config(cases(1500))]

    #[test]
    fn closed_forms_are_the_path_of_newton_and_poisson(contact in contact()) {
        agrees(&RouthNewton, &contact)?;
        agrees(&Keller1986, &contact)?;
        agrees(&DjerassiPoisson, &contact)?;
        dissipates(&contact, Restitution::Poisson)?;
    }
}

proptest! {
    #![proptest_config(cases(700))]

    /// The end of the energetic hypothesis is irrational as a rule.
    #[test]
    fn the_closed_form_is_the_path_of_energetic_restitution(contact in tame_contact()) {
        let contact = contact.map(|x| Algebraic::from(x.clone()));
        agrees(&Stronge1990, &contact)?;
        agrees(&DjerassiStronge, &contact)?;
        dissipates(&contact, Restitution::Energetic)?;
    }
}

/// The strategy reaches every way that a path can go, ties included.
#[test]
fn the_contacts_take_every_path() {
    use proptest::strategy::ValueTree;
    use proptest::test_runner::TestRunner;
    let mut runner = TestRunner::deterministic();
    let mut seen = std::collections::BTreeMap::<String, u32>::new();
    for _ in 0..1500 {
        let contact = contact().new_tree(&mut runner).expect("no filter").current();
        let path = integrate::<Rational>(&contact, Restitution::Newton).expect("rational");
        let kinds: Vec<Event> = path.events.iter().map(|event| event.event).collect();
        *seen.entry(format!("{kinds:?}")).or_default() += 1;
    }
    for path in [
        "[Start, End]",
        "[Start, Compressed, End]",
        "[Start, Stick, Compressed, End]",
        "[Start, Reverse, Compressed, End]",
        "[Start, Compressed, Stick, End]",
        "[Start, Compressed, Reverse, End]",
    ] {
        assert!(seen.get(path).is_some_and(|&count| count >= 15), "{path}: {seen:#?}");
    }
}
