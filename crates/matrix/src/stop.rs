//! Contacts on which the slip stops, in symbols of their own.
//!
//! With T = W_tt, the slowing rate s = mu·T − W_tn > 0 and a1 = W_nn − mu·W_tn, the slip stops at the
//! normal impulse p = v/s with the normal velocity v_s = a1·p − a. Written in p or a, in u = |v_s| and in
//! what decides between sticking and reversing, all that the process does is a sum of visible signs:
//!
//! ```text
//! W_tn = nu > 0    mu·T = nu + s, W_nn = a1 + mu·nu                              sticks
//! W_tn = −nu < 0   mu·T = nu + t, t ≥ 0 (sticks), or nu = mu·T + t, t > 0 (reverses),
//!                  W_nn = (nu² + d)/T, so that det W = d
//! in compression   v_s = −u < 0, a = a1·p + u; where a1 = −b ≤ 0, u = a + b·p and T = nu·s/(r + b),
//!                  so that det W = r·T
//! in restitution   v_s = u ≥ 0, e·a = u + h, a = u + h + g, h > 0, g ≥ 0, p = (a + u)/a1
//! ```
//!
//! Each is a bijection from an orthant, and together they are all contacts that couple, slip and approach
//! and on which the slip stops before v_n = e·a.

use kane_algebra::rational_function::RationalFunction as Symbolic;
use kane_impact::{Contact, Delassus};
use kane_number::Number as _;

/// How the slip stops.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// W_tn > 0 and W_nn > mu·W_tn, in compression
    DrivingInCompression,
    /// W_tn > 0 and W_nn ≤ mu·W_tn: sliding cannot separate the bodies
    Jamming,
    /// W_tn > 0, in restitution
    DrivingInRestitution,
    /// W_tn < 0, in compression, and the contact sticks
    SticksInCompression,
    /// W_tn < 0, in restitution, and the contact sticks
    SticksInRestitution,
    /// W_tn < 0, in compression, and the slip reverses
    ReversesInCompression,
    /// W_tn < 0, in restitution, and the slip reverses
    ReversesInRestitution,
}

impl Stop {
    /// All of them.
    pub(crate) const ALL: [Self; 7] = [
        Self::DrivingInCompression,
        Self::Jamming,
        Self::DrivingInRestitution,
        Self::SticksInCompression,
        Self::SticksInRestitution,
        Self::ReversesInCompression,
        Self::ReversesInRestitution,
    ];
}

/// The symbols by index: p or h, T, mu, u or a, nu, d, b or g, e, s or t, a1, r or g.
const P: usize = 0;
const T: usize = 1;
const MU: usize = 2;
const U: usize = 3;
const NU: usize = 4;
const D: usize = 5;
const E: usize = 6;
const S: usize = 7;
const R: usize = 8;

impl Stop {
    /// What it is, for people.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::DrivingInCompression => "W_tn > 0, the slip stops in compression",
            Self::Jamming => "W_tn > 0, the contact jams",
            Self::DrivingInRestitution => "W_tn > 0, the slip stops in restitution",
            Self::SticksInCompression => "W_tn < 0, sticks in compression",
            Self::SticksInRestitution => "W_tn < 0, sticks in restitution",
            Self::ReversesInCompression => "W_tn < 0, reverses in compression",
            Self::ReversesInRestitution => "W_tn < 0, reverses in restitution",
        }
    }

    fn in_restitution(self) -> bool {
        use Stop::{DrivingInRestitution, ReversesInRestitution, SticksInRestitution};
        matches!(self, DrivingInRestitution | SticksInRestitution | ReversesInRestitution)
    }

    /// The names of the symbols that differ, and those that may be zero.
    pub(crate) fn symbols(self) -> (Vec<(usize, &'static str)>, Vec<usize>) {
        let first = if self.in_restitution() { "h" } else { "p" };
        let mut names = vec![(P, first), (T, "T"), (U, "u")];
        let mut weak = if self.in_restitution() { vec![U] } else { Vec::new() };
        match self {
            Self::DrivingInCompression | Self::DrivingInRestitution => {
                names.extend([(S, "s"), (R, "a1")]);
            }
            Self::Jamming => {
                names.extend([(U, "a"), (S, "s"), (R, "r"), (D, "b")]);
                weak.push(D);
            }
            Self::SticksInCompression | Self::SticksInRestitution => {
                names.push((S, "t"));
                weak.push(S);
            }
            Self::ReversesInCompression | Self::ReversesInRestitution => names.push((S, "t")),
        }
        if self.in_restitution() {
            names.push((self.lost(), "g"));
            weak.push(self.lost());
        }
        (names, weak)
    }

    /// The symbol g of (1 − e)·a, one that is free.
    fn lost(self) -> usize {
        if self == Self::DrivingInRestitution { D } else { R }
    }

    /// The contact of these symbols.
    pub(crate) fn contact(self) -> Contact<Symbolic> {
        let [first, tt, mu, u, nu, d, e, s, r] =
            [P, T, MU, U, NU, D, E, S, R].map(Symbolic::symbol);
        let (tt, tn, nn, mu, slowing) = match self {
            Self::DrivingInCompression | Self::DrivingInRestitution => {
                let mu = (nu.clone() + &s) / &tt;
                let nn = r + mu.clone() * &nu;
                (tt, nu, nn, mu, s)
            }
            Self::Jamming => {
                let tt = nu.clone() * &s / (r + &d);
                let mu = (nu.clone() + &s) / &tt;
                let nn = mu.clone() * &nu - &d;
                (tt, nu, nn, mu, s)
            }
            Self::SticksInCompression | Self::SticksInRestitution => {
                let mu = (nu.clone() + &s) / &tt;
                let nn = (nu.square() + d) / &tt;
                let slowing = nu.double() + s;
                (tt, -nu, nn, mu, slowing)
            }
            Self::ReversesInCompression | Self::ReversesInRestitution => {
                let held = mu.clone() * &tt;
                let nu = held.clone() + s;
                let nn = (nu.square() + d) / &tt;
                let slowing = held + &nu;
                (tt, -nu, nn, mu, slowing)
            }
        };
        let apart = nn.clone() - mu.clone() * &tn;
        let (stop, approach, e) = match self {
            Self::Jamming => (first, u, e),
            _ if self.in_restitution() => {
                let rebound = u.clone() + first;
                let approach = rebound.clone() + Symbolic::symbol(self.lost());
                ((approach.clone() + u) / apart, approach.clone(), rebound / approach)
            }
            _ => (first.clone(), apart * first + u, e),
        };
        Contact::unchecked(stop * slowing, approach, Delassus::unchecked(tt, tn, nn), mu, e)
    }
}

#[cfg(test)]
mod tests {
    use kane_number::Rational;
    use num_traits::{Signed as _, Zero};

    use super::*;
    use crate::{Setting, contacts};

    const KINDS: [Stop; 7] = [
        Stop::DrivingInCompression,
        Stop::Jamming,
        Stop::DrivingInRestitution,
        Stop::SticksInCompression,
        Stop::SticksInRestitution,
        Stop::ReversesInCompression,
        Stop::ReversesInRestitution,
    ];

    /// The symbols of a contact as the page says, whether they are in range or not.
    fn values(stop: Stop, c: &Contact<Rational>) -> Option<Vec<Rational>> {
        let (w, mu, e, a) = (c.delassus(), c.friction(), c.restitution(), c.approach());
        let slowing = mu * w.tt() - w.tn();
        let apart = w.nn() - mu * w.tn();
        let p = c.slip() / &slowing;
        let at_stop = &apart * &p - a;
        let jams = stop == Stop::Jamming;
        let mut values = vec![<Rational as Zero>::zero(); 12];
        values[T] = w.tt().clone();
        values[MU] = mu.clone();
        values[NU] = w.tn().abs();
        values[D] = if jams { -apart.clone() } else { w.determinant() };
        values[E] = e.clone();
        values[R] = if jams { w.determinant() / w.tt() } else { apart.clone() };
        values[S] = match stop {
            _ if w.tn().is_positive() => slowing,
            Stop::SticksInCompression | Stop::SticksInRestitution => mu * w.tt() + w.tn(),
            _ => -(mu * w.tt() + w.tn()),
        };
        (values[P], values[U]) = if stop.in_restitution() {
            (e * a - &at_stop, at_stop)
        } else {
            (p, if jams { a.clone() } else { -at_stop })
        };
        if stop.in_restitution() {
            values[stop.lost()] = a - e * a;
        }
        let driving = [Stop::DrivingInCompression, Stop::Jamming, Stop::DrivingInRestitution];
        (driving.contains(&stop) == w.tn().is_positive()).then_some(values)
    }

    /// Two ways: the symbols of a contact give it back, and of the kinds one alone has them in range.
    #[test]
    fn every_contact_on_which_the_slip_stops_is_of_one_kind() {
        let mut seen = [0; KINDS.len()];
        for contact in contacts(&[Setting::Driving, Setting::Braking]) {
            let (mu, w) = (contact.friction(), contact.delassus());
            let slowing = mu * w.tt() - w.tn();
            let lasting = contact.slip() * (w.nn() - mu * w.tn()) - contact.closing() * &slowing;
            let stops = slowing.is_positive() && lasting.is_negative();
            let mut kinds = Vec::new();
            for (index, stop) in KINDS.into_iter().enumerate().filter(|_| stops) {
                let Some(values) = values(stop, &contact) else { continue };
                let symbolic = stop.contact();
                let entries = |c: &Contact<Symbolic>| {
                    let w = c.delassus();
                    [c.slip(), c.approach(), w.tt(), w.tn(), w.nn(), c.friction(), c.restitution()]
                        .map(|x| x.eval(&values))
                };
                let mentioned: Vec<usize> = [
                    symbolic.slip(),
                    symbolic.approach(),
                    symbolic.delassus().tt(),
                    symbolic.delassus().nn(),
                    symbolic.friction(),
                    symbolic.restitution(),
                ]
                .iter()
                .flat_map(|x| x.symbols())
                .collect();
                let weak = stop.symbols().1;
                let in_range = mentioned.iter().all(|v| match values[*v].is_zero() {
                    true => weak.contains(v) || *v == E,
                    false => values[*v].is_positive(),
                });
                if !in_range {
                    continue;
                }
                let w = contact.delassus();
                let expected = [
                    contact.slip(),
                    contact.approach(),
                    w.tt(),
                    w.tn(),
                    w.nn(),
                    contact.friction(),
                    contact.restitution(),
                ]
                .map(|x| Some(x.clone()));
                assert_eq!(entries(&symbolic), expected, "{stop:?}");
                kinds.push(index);
            }
            assert_eq!(kinds.len(), usize::from(stops), "{contact:?}: {kinds:?}");
            kinds.iter().for_each(|kind| seen[*kind] += 1);
        }
        assert!(seen.iter().all(|count| *count > 0), "{seen:?}");
    }
}
