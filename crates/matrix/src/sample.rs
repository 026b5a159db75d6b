//! Simple contacts, and what laws say of them exactly: where witnesses are looked for first.

use kane_impact::{Contact, Delassus, Law, NoImpulse, Outcome};
use kane_kernel::Rel;
use kane_number::{Algebraic, Rational};

use crate::property::{Comparison, Demand, Template};
use crate::setting::Setting;

/// An exact outcome: rational where it can be.
#[derive(Clone, Debug)]
pub enum Exact {
    /// all of it is rational
    Rational(Box<Outcome<Rational>>),
    /// a root is not
    Algebraic(Box<Outcome<Algebraic>>),
}

/// What a law says of a contact, exactly.
///
/// # Errors
/// [`NoImpulse`] where it says nothing.
pub fn resolve(law: &Law, contact: &Contact<Rational>) -> Result<Exact, NoImpulse> {
    match law.over().resolve(contact) {
        Ok(outcome) => Ok(Exact::Rational(outcome.into())),
        Err(NoImpulse::Unrepresentable { .. }) => {
            law.over().resolve(&algebraic(contact)).map(|outcome| Exact::Algebraic(outcome.into()))
        }
        Err(error) => Err(error),
    }
}

/// The contact in algebraic numbers.
#[must_use]
pub(super) fn algebraic(contact: &Contact<Rational>) -> Contact<Algebraic> {
    contact.map(|x| Algebraic::from(x.clone()))
}

/// Whether a comparison holds.
fn holds<N: kane_number::Ordered>(comparison: &Comparison<N>) -> bool {
    let order = comparison.lhs.compare(&comparison.rhs);
    let answer = match comparison.rel {
        Rel::Eq => order.is_equal(),
        Rel::Ne => order.is_equal().map(|equal| !equal),
        Rel::Lt => order.is_less(),
        Rel::Le => order.is_at_most(),
        Rel::Gt => order.is_greater(),
        Rel::Ge => order.is_at_least(),
    };
    answer == Some(true)
}

fn violated<N: kane_number::Ordered>(demands: &[Demand<N>]) -> Option<usize> {
    demands.iter().position(|demand| demand.when.iter().all(holds) && !holds(&demand.claim))
}

/// The first link of a template that an outcome violates.
pub(crate) fn violation(
    template: &Template,
    contact: &Contact<Rational>,
    outcome: &Exact,
) -> Option<usize> {
    match outcome {
        Exact::Rational(outcome) => violated(&template.demands(contact, outcome)?),
        Exact::Algebraic(outcome) => violated(&template.demands(&algebraic(contact), outcome)?),
    }
}

/// The contacts of some families, simple ones first: v and W_nn are 1, units being free.
#[must_use]
pub fn contacts(settings: &[Setting]) -> Vec<Contact<Rational>> {
    const FEW: [(i64, i64); 7] = [(1, 1), (2, 1), (1, 2), (4, 1), (3, 1), (1, 4), (1, 8)];
    const SPEEDS: [(i64, i64); 6] = [(1, 1), (2, 1), (4, 1), (1, 2), (3, 1), (1, 4)];
    const MOBILITIES: [(i64, i64); 6] = [(1, 1), (2, 1), (1, 2), (1, 3), (4, 1), (3, 1)];
    const ENDS: [(i64, i64); 3] = [(1, 1), (0, 1), (1, 2)];
    let rational = |(n, d): (i64, i64)| Rational::new(n.into(), d.into());
    let mut out: Vec<(u64, Contact<Rational>)> = Vec::new();
    let couplings: Vec<(i64, i64)> = if settings == [Setting::Sphere] {
        vec![(0, 1)]
    } else {
        vec![(0, 1), (1, 2), (-1, 2), (1, 1), (-1, 1), (3, 2), (-3, 2), (1, 4), (-1, 4)]
    };
    // what a choice costs: its place in its list
    for (i, &slip) in [(1, 1), (0, 1)].iter().enumerate() {
        for (j, &approach) in SPEEDS.iter().enumerate() {
            for (k, &friction) in FEW.iter().enumerate() {
                for (l, &restitution) in ENDS.iter().enumerate() {
                    for (m, &tt) in MOBILITIES.iter().enumerate() {
                        for (n, &tn) in couplings.iter().enumerate() {
                            let cost = 4 * i + j + k + l + m + n.div_ceil(2);
                            if cost > 6 {
                                continue;
                            }
                            let delassus =
                                Delassus::new(rational(tt), rational(tn), rational((1, 1)));
                            let Ok(delassus) = delassus else { continue };
                            let contact = Contact::new(
                                rational(slip),
                                rational(approach),
                                delassus,
                                rational(friction),
                                rational(restitution),
                            );
                            let Ok(contact) = contact else { continue };
                            if settings.iter().any(|setting| setting.values(&contact).is_some()) {
                                out.push((cost.try_into().unwrap_or(u64::MAX), contact));
                            }
                        }
                    }
                }
            }
        }
    }
    out.sort_by_key(|(cost, _)| *cost);
    out.into_iter().map(|(_, contact)| contact).collect()
}
