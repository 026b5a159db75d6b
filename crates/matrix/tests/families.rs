//! The families of contacts of the matrix against contacts in numbers.

use std::cmp::Ordering;

use kane_impact::Contact;
use kane_matrix::{Setting, contacts};
use kane_number::Rational;
use num_rational::Ratio;
use num_traits::{Signed as _, Zero as _};

fn sign(x: &Rational) -> Ordering {
    x.cmp(&Ratio::zero())
}

/// The symbols q, w, mu, gamma, nu, d, e by their indices, from the contact alone.
fn symbols(contact: &Contact<Rational>) -> (Setting, Vec<Rational>) {
    let (w, mu, a) = (contact.delassus(), contact.friction(), contact.approach());
    let q = contact.slip() + w.tn() * a / w.nn();
    let closing = contact.closing();
    let gamma = if q.is_zero() { closing } else { closing / (mu * q.abs()) };
    let nu = mu * w.tn().abs() / w.nn();
    let d = mu * mu * w.determinant() / (w.nn() * w.nn());
    let setting = Setting::Seen { coupling: sign(w.tn()), slip: sign(&q) };
    let e = contact.restitution().clone();
    let mut values = vec![q.abs(), w.nn().clone(), mu.clone(), gamma, nu, d, e];
    values.resize(12, Ratio::zero());
    (setting, values)
}

#[test]
fn every_contact_that_approaches_is_of_one_family_seen_in_a_frame() {
    let planar = [Setting::Sphere, Setting::Driving, Setting::Braking, Setting::Resting];
    let mut seen = Vec::new();
    for forwards in contacts(&planar) {
        for contact in [forwards.clone(), forwards.mirrored()] {
            let (setting, values) = symbols(&contact);
            let symbolic = setting.contact();
            let of = |c: &Contact<Rational>| {
                let w = c.delassus();
                [c.slip(), c.approach(), w.tt(), w.tn(), w.nn(), c.friction(), c.restitution()]
                    .map(|x| Some(x.clone()))
            };
            let w = symbolic.delassus();
            let at = [
                symbolic.slip(),
                symbolic.approach(),
                w.tt(),
                w.tn(),
                w.nn(),
                symbolic.friction(),
                symbolic.restitution(),
            ]
            .map(|x| x.eval(&values));
            assert_eq!(at, of(&contact), "{contact:?}");
            if !seen.contains(&setting) {
                seen.push(setting);
            }
        }
    }
    // all signs but those of W_tn = 0 = q, where nothing would slip
    assert!(seen.len() >= 8, "{seen:?}");
}
