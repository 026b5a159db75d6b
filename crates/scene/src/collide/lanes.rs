//! The same quantities, measured in any number system.

use kane_impact::bodies::{CollideError, Ledger};
use kane_impact::{Contact, Law, LawOver, NoImpulse, NumberSystem, Outcome};
use kane_number::Real;

use super::System;
use super::system::After;

/// A quantity of a report.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Quantity {
    pub(super) symbol: &'static str,
    pub(super) unit: &'static str,
    pub(super) meaning: &'static str,
    /// whether the table of all laws has a column for it
    pub(super) column: bool,
}

/// A quantity, and its value if it has one.
pub(super) type Value<N> = (Quantity, Option<N>);

/// What a law makes of a system, in one number system: measured, and as it happened.
pub(super) struct Happened<N> {
    pub(super) measured: Measured<N>,
    pub(super) contact: Contact<N>,
    /// The impulse in the signs of mechanics.
    pub(super) outcome: Outcome<N>,
    pub(super) after: After<N>,
}

/// The quantities, in one number system.
#[derive(Clone, Debug)]
pub(super) struct Measured<N> {
    pub(super) regime: &'static str,
    pub(super) values: Vec<Value<N>>,
}

const fn quantity(symbol: &'static str, unit: &'static str, meaning: &'static str) -> Quantity {
    Quantity { symbol, unit, meaning, column: false }
}

const fn column(symbol: &'static str, unit: &'static str, meaning: &'static str) -> Quantity {
    Quantity { symbol, unit, meaning, column: true }
}

impl<N> Measured<N> {
    /// The value of a quantity.
    pub(super) fn get(&self, symbol: &str) -> Option<&N> {
        let found = self.values.iter().find(|(quantity, _)| quantity.symbol == symbol);
        found.and_then(|(_, value)| value.as_ref())
    }

    /// The same in another number system.
    pub(super) fn map<M>(self, to: impl Fn(N) -> Option<M>) -> Measured<M> {
        let convert = |(quantity, value): Value<N>| (quantity, value.and_then(&to));
        Measured { regime: self.regime, values: self.values.into_iter().map(convert).collect() }
    }
}

/// What the law is given.
pub(super) fn of_contact<N: Real>(contact: &Contact<N>) -> Vec<Value<N>> {
    let w = contact.delassus();
    [
        (quantity("v_t", "m/s", "slip before"), contact.slip()),
        (quantity("a", "m/s", "approach speed, -v_n"), contact.approach()),
        (quantity("W_tt", "1/kg", "tangential mobility"), w.tt()),
        (quantity("W_tn", "1/kg", "coupling"), w.tn()),
        (quantity("W_nn", "1/kg", "normal mobility"), w.nn()),
    ]
    .into_iter()
    .map(|(quantity, value)| (quantity, Some(value.clone())))
    .chain([
        (quantity("S", "N·s", "mu*(1 + e)*a/W_nn"), Some(contact.sliding_impulse())),
        (quantity("alpha", "", "W_tt*S/(2*v_t)"), contact.alpha()),
    ])
    .collect()
}

/// What the law answers at the contact, formed in the contact's own number system.
pub(super) fn at_contact<N: Real>(
    law: &dyn LawOver<N>,
    contact: &Contact<N>,
) -> Result<(Measured<N>, Outcome<N>), NoImpulse> {
    let (outcome, root) = law.resolve_with_root(contact)?;
    let ratios = outcome.ratios(contact);
    let ratio = |part: fn(kane_impact::Ratios<N>) -> N| ratios.clone().map(part);
    let mut values = of_contact(contact);
    values.extend([
        (quantity("root", "", "of the regime's equation"), root),
        (quantity("p_t", "N·s", "tangential impulse"), Some(outcome.impulse.tangential.clone())),
        (quantity("p_n", "N·s", "normal impulse"), Some(outcome.impulse.normal.clone())),
        (quantity("v_t+", "m/s", "slip after"), Some(outcome.slip.clone())),
        (quantity("v_n+", "m/s", "speed of separation"), Some(outcome.separation.clone())),
        // without friction or approach there is no i_x, but the slip stays
        (column("k", "", "v_t+/v_t"), outcome.slip.checked_div(contact.slip())),
        (column("i_x", "", "-p_t/(mu*p_n), or p_t/(mu*p_n) if v_t < 0"), ratio(|r| r.impulse)),
        (quantity("de", "", "dE_t/(mu*p_n*|v_t|)"), ratio(|r| r.energy)),
        (quantity("dE_t", "J", "work of friction"), Some(outcome.work.tangential.clone())),
        (quantity("dE_n", "J", "work of the normal impulse"), Some(outcome.work.normal.clone())),
        (column("dE", "J", "change of kinetic energy"), Some(outcome.work.total())),
    ]);
    Ok((Measured { regime: outcome.regime, values }, outcome))
}

/// What the law makes of the system: at the contact, and of the bodies.
///
/// In a number system that is its own wider one: the outcome at the contact is that of the bodies.
pub(super) fn of_system<N: NumberSystem<WideSystem = N>>(
    law: &Law,
    system: &System<N>,
) -> Result<Happened<N>, CollideError<N>> {
    let contact = system.contact()?;
    let (mut measured, outcome) = at_contact(law.over(), &contact)?;
    let after = system.after(&outcome)?;
    let before = system.kinetic_energy();
    let change = measured.get("dE").cloned();
    let ratio = change.and_then(|change| (before.clone() + change).checked_div(&before));
    measured.values.push((column("T+/T-", "", "kinetic energy after by before"), ratio));
    for (&(symbol, unit, meaning), value) in system.velocities().iter().zip(&after.velocities) {
        measured.values.push((column(symbol, unit, meaning), Some(value.clone())));
    }
    if let Some(Ledger { normal, tangential, rotational }) = after.ledger.clone() {
        measured.values.extend([
            (quantity("dT_y", "J", "ledger: energy of motion along y"), Some(normal)),
            (quantity("dT_x", "J", "ledger: energy of motion along x"), Some(tangential)),
            (quantity("dT_rot", "J", "ledger: energy of rotation"), Some(rotational)),
        ]);
    }
    Ok(Happened { measured, contact, outcome, after })
}
