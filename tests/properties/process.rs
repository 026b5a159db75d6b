//! The laws that are processes, in closed form, against the integration of the process.

use kane_impact::oracle::{Event, integrate};
use kane_impact::{Contact, Law, NumberSystem, Restitution, laws};
use kane_number::{Algebraic, Rational, Real};
use proptest::prelude::*;

use crate::cases;
use crate::contacts::{contact, tame_contact};

/// The laws that say of themselves that they are the process.
fn processes() -> impl Iterator<Item = &'static Law> {
    laws().iter().filter(|law| law.info.is_process)
}

/// Impulse, velocities and work, all exactly.
fn agrees<N: NumberSystem + PartialEq>(
    law: &Law,
    contact: &Contact<N>,
) -> Result<(), TestCaseError> {
    let path = integrate(contact, law.info.restitution)?;
    let (outcome, end) = (law.over().resolve(contact)?, path.end());
    prop_assert_eq!(&outcome.impulse, &end.impulse, "{}: {:?}", law.info.id, contact);
    prop_assert_eq!(&outcome.slip, &end.slip, "{}: {:?}", law.info.id, contact);
    prop_assert_eq!(&outcome.separation, &end.normal_velocity, "{}: {:?}", law.info.id, contact);
    // the path knows which direction did the work when; the law only the two ends
    let work = end.normal_work.clone() + &end.tangential_work;
    prop_assert_eq!(outcome.work.total(), work, "{}: {:?}", law.info.id, contact);
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
        // Djerassi's law with Newton's restitution refuses some of its impulses
        for law in processes().filter(|law| law.info.restitution != Restitution::Energetic) {
            if law.info.gap.is_none() {
                agrees(law, &contact)?;
            }
        }
        dissipates(&contact, Restitution::Poisson)?;
    }
}

proptest! {
    #![proptest_config(cases(700))]

    /// The end of the energetic hypothesis is irrational as a rule.
    #[test]
    fn the_closed_form_is_the_path_of_energetic_restitution(contact in tame_contact()) {
        let contact = contact.map(|x| Algebraic::from(x.clone()));
        for law in processes().filter(|law| law.info.restitution == Restitution::Energetic) {
            agrees(law, &contact)?;
        }
        dissipates(&contact, Restitution::Energetic)?;
    }
}

#[test]
fn six_laws_are_the_process() {
    assert_eq!(processes().count(), 6);
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
