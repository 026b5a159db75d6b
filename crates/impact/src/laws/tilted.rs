//! Laws of a tilted normal, which raise the kinematic restitution above one without creating energy.

use kane_number::{Number, Rational};

use super::chatterjee_ruina::{UNCOUPLED, View};
use super::walton::{BETA0, Rebounds};
use crate::bodies::Direction;
use crate::{Contact, Frame, Guard, Impulse, LawInfo, Parameter, Provenance, Relation};

/// Walton's law about a normal that leans against the slip, after Louge and Adams (id `tilted-2002`).
///
/// This is not their law: on a sphere the restitution along n that follows is 4 to 8 % from their
/// formula, see [`KuninakaHayakawa`].
///
/// The impulse of [`KuninakaHayakawa`], whose paper takes the transformation from this one; the two
/// differ in nothing that is known here. There too is the formula e = (e' + Ψ2·tan φ)/(1 − Ψ1·tan φ)
/// for the kinematic restitution, what is chosen here, and what the law lacks.
///
/// Domain: contacts with μ·tan φ ≤ 1 on which the surfaces then separate, with 0 ≤ tilt ≤ 1 and
/// 0 ≤ β0 ≤ 1; the ranges of the parameters are the caller's. Without slip the normal does not lean.
/// Exact in exact numbers.
///
/// In floats heuristic: turning may cancel, so plain floats are not used, and intervals enclose the
/// impulse.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LougeAdams {
    /// tan(φ/2) of the tilt φ; 0 ≤ tilt ≤ 1.
    pub tilt: Rational,
    /// β0, the tangential restitution at sticking; 0 ≤ β0 ≤ 1.
    pub restitution: Rational,
}

/// Walton's law about a normal that leans against the slip, after Kuninaka and Hayakawa (id `tilted-2004`).
///
/// The surface gives way under the contact, so that the normal there, n', leans by the angle φ
/// against the slip. In the frame of n' there is a law without coupling of
/// [`Walton`](crate::laws::Walton)'s form, with Newton's restitution e along n'. With Ψ1 = v_t'/a'
/// before and Ψ2 = v_t'⁺/a' after, both in that frame, the restitution along n is
///
/// ```text
/// v_n⁺/a = (e + Ψ2·tan φ)/(1 − Ψ1·tan φ)      Ψ1 = (tan γ − tan φ)/(1 + tan γ·tan φ)
/// ```
///
/// with tan γ = `v_t`/a. It exceeds one for oblique impact, and yet no energy is created: friction
/// and push are both forces of the tilted contact.
///
/// The tilt is given as tan(φ/2), so that cos φ and sin φ are rational. It is constant here, where
/// the papers have it depend on the angle of incidence. Hence a contact that grazes, a = 0, is no
/// limit of no collision, for the normal that leans makes it one; and the law jumps at `v_t` = 0,
/// where the normal does not lean. If tan γ < tan φ the slip along the tilted tangent is backwards.
///
/// On most contacts the tilted frame couples, a sphere's among them: only the normal turns, while
/// the contact point stays where it is. There Walton's law is carried over by
/// [`ChatterjeeRuina`](crate::laws::ChatterjeeRuina)'s formula with `e_t` = β0, which keeps in the
/// tilted friction cone and creates no energy; to end with a slip of −β0 would create some, on a
/// sphere already. The sliding formula of the papers, Ψ2 = Ψ1 − `j_p`·(1 + e)·μ with `j_p` = 3 of a disc,
/// is that of a contact point on the tilted normal through the centre, where nothing couples. So this
/// is not the law of the papers: on a sphere with e = 0.8, μ = 0.3 and tilt = 1/10 the formula above, with
/// Ψ2 = max(Ψ1 − 7/2·(1 + e)·μ, −β0·Ψ1), has 0.811, 0.869 and 1.119 at 20°, 50° and 70° from the normal,
/// where this has 0.778, 0.831 and 1.032.
///
/// Domain: contacts with μ·tan φ ≤ 1, so that all of the tilted cone pushes, on which the surfaces
/// then separate, `v_n⁺` ≥ 0; 0 ≤ tilt ≤ 1 and 0 ≤ β0 ≤ 1 are the caller's. Exact in exact numbers.
///
/// In floats heuristic: turning may cancel, so plain floats are not used, and intervals enclose the
/// impulse.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct KuninakaHayakawa {
    /// tan(φ/2) of the tilt φ; 0 ≤ tilt ≤ 1.
    pub tilt: Rational,
    /// β0, the tangential restitution at sticking; 0 ≤ β0 ≤ 1.
    pub restitution: Rational,
}

/// A law that stands in a frame of its own.
pub(crate) trait Turns: Rebounds {
    /// That frame, for a contact that faces forwards and slips.
    fn turned<N: Number>(&self, contact: &Contact<N>) -> Frame<N>;
}

/// In the frame of the law.
pub(crate) struct Turned;

impl<L: Turns> View<L> for Turned {
    fn contact<N: Number>(law: &L, contact: &Contact<N>) -> Contact<N> {
        law.turned(contact).contact
    }

    fn back<N: Number>(law: &L, contact: &Contact<N>, impulse: Impulse<N>) -> Impulse<N> {
        impulse.turned(&law.turned(contact).turn.mirrored())
    }

    const PLAIN: bool = false;
}

/// cos² φ ≥ μ²·sin² φ: every impulse in the law's cone pushes along the contact's normal too.
pub(crate) const fn cone_pushes<L: Turns, N: Number>() -> Guard<L, N> {
    Guard::new(Relation::NotNegative, |law: &L, contact: &Contact<N>| {
        let Direction { cos, sin } = law.turned(contact).turn;
        let friction = sin * contact.friction();
        (cos.clone() - &friction) * (cos + friction)
    })
}

/// What is said of every law in a frame of its own.
pub(crate) const TURNED: LawInfo =
    LawInfo { statement: UNCOUPLED, stated_for_coupling: false, ..LawInfo::PLAIN };

/// The implementation of a law in a frame of its own, with what it asks there.
macro_rules! turned_law {
    ($law:ty, $parameter:ident, $info:expr, [$($guard:expr),*] $(, $acceptance:item)?) => {
        impl $crate::laws::walton::Rebounds for $law {
            fn share<N: kane_number::Number>(&self) -> N {
                N::from_rational(&self.restitution)
            }
        }

        impl $crate::ImpactLaw for $law {
            const INFO: $crate::LawInfo = $info;

            fn values(&self) -> Vec<&kane_number::Rational> {
                vec![&self.$parameter, &self.restitution]
            }

            fn values_mut(&mut self) -> Vec<&mut kane_number::Rational> {
                vec![&mut self.$parameter, &mut self.restitution]
            }

            fn frame<N: kane_number::Number>(
                &self,
                contact: &$crate::Contact<N>,
            ) -> Option<$crate::Frame<N>> {
                Some($crate::laws::tilted::Turns::turned(self, contact))
            }

            fn normal_collision(&self) -> Option<kane_number::Rational> {
                None // k is no function of α
            }

            $($acceptance)?

            fn regimes<N: kane_number::Number>(&self) -> &'static [$crate::Regime<Self, N>] {
                use $crate::Guard;
                use $crate::law::guards;
                use $crate::laws::chatterjee_ruina::{
                    Own, above, backward, below, inside, on_the_cone_backward, on_the_cone_forward,
                };
                use $crate::laws::tilted::{Turned, cone_pushes};
                const {
                    &[
                        inside::<Own, Self, N>(
                            "no slip, inside the cone",
                            guards![
                                Guard::no_slip(),
                                above::<Own, Self, N>(),
                                below::<Own, Self, N>(),
                            ],
                        ),
                        on_the_cone_backward::<Own, Self, N>(
                            "no slip, on the cone",
                            guards![Guard::no_slip()],
                        ),
                        inside::<Turned, Self, N>(
                            "inside the turned cone",
                            guards![
                                $($guard,)*
                                cone_pushes(),
                                above::<Turned, Self, N>(),
                                below::<Turned, Self, N>(),
                            ],
                        ),
                        on_the_cone_backward::<Turned, Self, N>(
                            "on the turned cone, backwards",
                            guards![$($guard,)* cone_pushes(), backward::<Turned, Self, N>()],
                        ),
                        on_the_cone_forward::<Turned, Self, N>(
                            "on the turned cone, forwards",
                            guards![$($guard,)* cone_pushes()],
                        ),
                    ]
                }
            }
        }
    };
}
pub(crate) use turned_law;

/// The tilt of both.
const TILT: Parameter = Parameter {
    name: "tilt",
    meaning: "tangent of half the angle by which the normal leans",
    least: 0,
    greatest: Some(1),
    default: (1, 10),
    invented: true,
};

/// The two laws of a normal that leans against the slip.
macro_rules! tilted_law {
    ($law:ident, $info:expr) => {
        impl Default for $law {
            fn default() -> Self {
                Self { tilt: TILT.default(), restitution: BETA0.default() }
            }
        }

        impl Turns for $law {
            fn turned<N: Number>(&self, contact: &Contact<N>) -> Frame<N> {
                let turn = Direction::of_half_tangent(&N::from_rational(&self.tilt));
                Frame { contact: contact.turned(&turn), turn }
            }
        }

        turned_law!(
            $law,
            tilt,
            $info,
            [],
            fn acceptance<N: Number>(
                &self,
                contact: &Contact<N>,
                impulse: &Impulse<N>,
            ) -> Option<N> {
                Some(contact.separation_after(impulse))
            }
        );
    };
}

/// What is said of both.
const TILTED: LawInfo = LawInfo {
    parameters: &[TILT, BETA0],
    form: "carried over here to rigid contacts, with an invented tilt",
    caveat: Some(
        "it is not the formula of the paper that it is named after, and its default tilt is invented",
    ),
    gap: Some("the cone about the tilted normal reaches below the surface, mu*tan(phi) > 1"),
    rejects: Some("the surfaces would not separate"),
    ..TURNED
};

tilted_law!(
    LougeAdams,
    LawInfo {
        id: "tilted-2002",
        people: "after Louge and Adams",
        year: Some(2002),
        source: "M. Y. Louge and M. E. Adams, Phys. Rev. E 65 (2002) 021303, from memory of its use in the literature, original not consulted: oblique impacts of a hard sphere on an elastoplastic plate. The default tilt = 1/10 is chosen here and belongs to no material; beta0 = 0.44 is Walton's",
        known_by: Provenance::Others,
        ..TILTED
    }
);
tilted_law!(
    KuninakaHayakawa,
    LawInfo {
        id: "tilted-2004",
        people: "after Kuninaka and Hayakawa",
        year: Some(2004),
        source: "H. Kuninaka and H. Hayakawa, Phys. Rev. Lett. 93 (2004) 154301, abstract consulted, original not consulted: the formula from memory, and derived anew. The default tilt = 1/10 is chosen here and belongs to no material; beta0 = 0.44 is Walton's. For coupled frames the law is carried over here",
        known_by: Provenance::OthersAndAbstract,
        ..TILTED
    }
);
