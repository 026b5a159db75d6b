//! A normal that turns during the contact, so that the kinematic restitution may be negative.

use kane_number::{Number, Rational};

use super::tilted::{TURNED, Turns, turned_law};
use super::walton::BETA0;
use crate::bodies::Direction;
use crate::{Contact, Frame, Guard, LawInfo, Parameter, Provenance, Relation};

/// The bodies part along another normal than that on which they met (id `saitoh`).
///
/// During the contact the normal turns along the slip by the angle φ, from n to n' = cos φ·n + sin φ·t.
/// The proper restitution e ≥ 0 compares the speed of separation along n' with that of approach along
/// n, and the kinematic one need not be positive:
///
/// ```text
/// v⁺·n' = e·a      −(v⁺·n)/(v·n) = cos φ·e − sin φ·(v⁺·t')/a
/// ```
///
/// so that it is negative where e·cos φ·a < sin φ·(v⁺·t'). The other component is left to a law in the
/// frame of n', here [`Walton`](crate::laws::Walton)'s carried over to coupling by
/// [`ChatterjeeRuina`](crate::laws::ChatterjeeRuina)'s formula with `e_t` = β0; which law it is in the
/// paper is not known here. In that frame the contact has the approach speed a' = −v·n' and, after
/// Newton, the coefficient e·a/a', which may exceed one. Then energy may be created: where the slip
/// is fast, n' is met at a lower speed than n. The source tells of clusters with heat to give.
///
/// The angle is given as tan(φ/2), so that cos φ and sin φ are rational, and is constant here.
///
/// Domain: contacts on which the bodies approach along n' too, a·cos φ > `v_t`·sin φ, with μ·tan φ ≤ 1,
/// so that all of the cone about n' pushes along n; 0 ≤ turn ≤ 1 and 0 ≤ β0 ≤ 1 are the caller's.
/// Without slip the normal does not turn. Of any outcome only v⁺·n' ≥ 0 is promised. Exact in exact
/// numbers.
///
/// In floats heuristic: turning may cancel, so plain floats are not used, and intervals enclose the
/// impulse.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Saitoh {
    /// tan(φ/2) of the turn φ; 0 ≤ turn ≤ 1.
    pub turn: Rational,
    /// β0, the tangential restitution at sticking; 0 ≤ β0 ≤ 1.
    pub restitution: Rational,
}

impl Default for Saitoh {
    fn default() -> Self {
        Self { turn: TURN.default(), restitution: BETA0.default() }
    }
}

const TURN: Parameter = Parameter {
    name: "turn",
    meaning: "tangent of half the angle by which the normal turns",
    least: 0,
    greatest: Some(1),
    default: (1, 5),
    invented: true,
};

impl Turns for Saitoh {
    fn turned<N: Number>(&self, contact: &Contact<N>) -> Frame<N> {
        let turn = Direction::of_half_tangent(&N::from_rational(&self.turn)).mirrored();
        let seen = contact.turned(&turn);
        // at a' = 0 there is no regime
        let rebound = contact.restitution().clone() * contact.approach();
        let restitution = rebound.checked_div(seen.approach()).unwrap_or_else(N::zero);
        let (slip, approach) = (seen.slip().clone(), seen.approach().clone());
        let (delassus, friction) = (seen.delassus().clone(), seen.friction().clone());
        let contact = Contact::unchecked(slip, approach, delassus, friction, restitution);
        Frame { turn, contact }
    }
}

/// a' > 0
const fn approaches<N: Number>() -> Guard<Saitoh, N> {
    Guard::new(Relation::Positive, |law: &Saitoh, contact: &Contact<N>| {
        law.turned(contact).contact.approach().clone()
    })
}

turned_law!(
    Saitoh,
    turn,
    LawInfo {
        id: "saitoh",
        people: "Saitoh, Bodrova, Hayakawa and Brilliantov",
        year: Some(2010),
        source: "K. Saitoh, A. Bodrova, H. Hayakawa and N. V. Brilliantov, Phys. Rev. Lett. 105 (2010) 238001, abstract consulted, original not consulted: the formula from memory, and derived anew. The default turn = 1/5 is chosen here and belongs to no material; beta0 = 0.44 is Walton's",
        known_by: Provenance::OthersAndAbstract,
        form: "with an invented turn",
        caveat: Some("its default turn is invented and belongs to no material"),
        parameters: &[TURN, BETA0],
        gap: Some(
            "the bodies do not approach along the normal on which they would part, or the cone about it reaches below the surface, mu*tan(phi) > 1",
        ),
        ..TURNED
    },
    [approaches()]
);
