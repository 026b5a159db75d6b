//! Coulomb friction at every instant of the impact, in closed form.

use kane_number::Number;

use crate::arithmetic::difference_of_products;
use crate::{
    Coefficients, Contact, Guard, ImpactLaw, Impulse, Lasting, LawInfo, ModelInfo, Provenance,
    Regime, Relation, Restitution, Root,
};

/// Routh's process with Newton's restitution (id `routh-newton`).
///
/// With the normal impulse p as time, the contact slides with friction μ until the slip stops, at
/// `p_s`; from then on it sticks if the friction that this takes is inside the cone, |`W_tn`| ≤
/// μ·`W_tt`, and slides backwards if not. The collision ends at `v_n` = e·a:
///
/// ```text
/// a1 = W_nn − μ·W_tn    p_s = v_t/(μ·W_tt − W_tn)    v_s = a1·p_s − a
/// a2 = W_nn − W_tn²/W_tt  (stick)                    a2 = W_nn + μ·W_tn  (reverse)
/// p_f = (1 + e)·a/a1      while slip lasts           p_f = p_s + (e·a − v_s)/a2   after it stopped
/// ```
///
/// A contact jams where a1 ≤ 0: sliding cannot separate the bodies, and the slip always stops
/// first. On a sphere, k = max(0, 1 − 2α). With coupling, Newton's coefficient may create energy.
///
/// Without approach, a = 0, there is no collision and no impulse, even where a contact that jams
/// would start one.
///
/// Domain: every contact. Exact in exact numbers.
///
/// In floats the bound with coupling is the width of the result on intervals; without, heuristic: a
/// few ulp.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RouthNewton;

/// Routh's process with Poisson's restitution, which is Keller's law (id `keller-1986`).
///
/// The process of [`RouthNewton`]; the collision ends when the normal impulse is (1 + e) times that
/// of compression, `p_f` = (1 + e)·`p_c` with `v_n`(`p_c`) = 0. Energy never rises for 0 ≤ e ≤ 1.
///
/// Domain: every contact; where it does not couple, k = max(0, 1 − 2α). Exact in exact numbers.
///
/// In floats the bound with coupling is the width of the result on intervals; without, heuristic: a
/// few ulp.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Keller1986;

/// Routh's process with Stronge's energetic restitution (id `stronge-1990`).
///
/// The process of [`RouthNewton`]; the collision ends when the normal impulse has given back e² of
/// the normal work of compression. If the slip stops before, that takes a square root. Energy never
/// rises for 0 ≤ e ≤ 1. Here e is the energetic coefficient, a property of the bodies that is
/// free of the angle of incidence, whereas the ratio −`v_n⁺`/`v_n` that follows depends on the angle
/// where the contact couples; so this id is the angle-free law.
///
/// Domain: every contact; where it does not couple, k = max(0, 1 − 2α). Exact in exact numbers:
/// algebraic ones hold the square root, rational ones only where it is rational, as it always is
/// without coupling.
///
/// In floats heuristic: a few ulp where the contact does not couple; with coupling, once the slip has
/// stopped, plain floats have no bound, and intervals enclose the impulse.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Stronge1990;

/// What follows when the slip has stopped.
pub(crate) trait Then {
    /// dv_n/dp, always positive where this is what follows.
    fn rate<N: Number>(contact: &Contact<N>) -> N;

    /// dp_t/dp
    fn ratio<N: Number>(contact: &Contact<N>) -> N;

    /// Whether the contact ends without slip.
    const STICKS: bool;

    /// The impulse of sliding until `p_s`, and of what is left after it.
    fn impulse<N: Number>(contact: &Contact<N>, rest: N) -> Impulse<N> {
        let stop = stop(contact);
        let sliding = stop.clone() * contact.friction();
        Impulse { tangential: Self::ratio(contact) * &rest - sliding, normal: stop + rest }
    }
}

/// The contact sticks.
pub(crate) struct Stick;

/// The contact slides backwards.
pub(crate) struct Reverse;

impl Then for Stick {
    fn rate<N: Number>(contact: &Contact<N>) -> N {
        contact.delassus().determinant() / contact.delassus().tt()
    }

    fn ratio<N: Number>(contact: &Contact<N>) -> N {
        -(contact.delassus().tn().clone() / contact.delassus().tt())
    }

    const STICKS: bool = true;
}

impl Then for Reverse {
    fn rate<N: Number>(contact: &Contact<N>) -> N {
        contact.friction().mul_add(contact.delassus().tn(), contact.delassus().nn())
    }

    fn ratio<N: Number>(contact: &Contact<N>) -> N {
        contact.friction().clone()
    }

    const STICKS: bool = false;
}

/// `p_s`
fn stop<N: Number>(contact: &Contact<N>) -> N {
    contact.slip().clone() / contact.slowing_rate()
}

/// v_s = a1·p_s − a, times the slowing rate.
fn scaled_speed_at_stop<N: Number>(contact: &Contact<N>) -> N {
    let (slip, rate) = (contact.slip(), contact.slowing_rate());
    difference_of_products(&contact.separation_rate(), slip, contact.approach(), &rate)
}

fn speed_at_stop<N: Number>(contact: &Contact<N>) -> N {
    scaled_speed_at_stop(contact) / contact.slowing_rate()
}

/// e²·a² − v_s²
fn excess<N: Number>(contact: &Contact<N>) -> N {
    let speed = speed_at_stop(contact);
    let rebound = contact.restitution().clone() * contact.approach();
    (rebound.clone() - &speed) * (rebound + speed)
}

/// The greater root of factor·x² = value, and where to look for it.
fn square_root<N: Number>(value: N, factor: N) -> Coefficients<N> {
    Coefficients::Quadratic([-value, N::zero(), factor])
}

fn up_to<N: Number>(value: N, factor: N) -> (N, N) {
    (N::zero(), N::one() + value / factor)
}

/// Newton: (e·a − v_s)/a2 is left.
pub(crate) const fn newton<T: Then, L: ImpactLaw, N: Number>(
    name: &'static str,
    guards: &'static [Guard<L, N>],
) -> Regime<L, N> {
    after::<T, L, N>(name, guards, |_, contact, _| {
        let rebound = contact.restitution().clone() * contact.approach();
        T::impulse(contact, (rebound - speed_at_stop(contact)) / T::rate(contact))
    })
}

/// Poisson, stop in compression: `p_c` − `p_s` = −v_s/a2, and then e·`p_c`.
pub(crate) const fn poisson_compression<T: Then, L: ImpactLaw, N: Number>(
    name: &'static str,
    guards: &'static [Guard<L, N>],
) -> Regime<L, N> {
    after::<T, L, N>(name, guards, |_, contact, _| {
        let e = contact.restitution();
        let compression = -(speed_at_stop(contact) / T::rate(contact));
        let restitution = (stop(contact) + &compression) * e;
        T::impulse(contact, compression + restitution)
    })
}

/// Poisson, stop in restitution: `p_c` = a/a1.
pub(crate) const fn poisson_restitution<T: Then, L: ImpactLaw, N: Number>(
    name: &'static str,
    guards: &'static [Guard<L, N>],
) -> Regime<L, N> {
    after::<T, L, N>(name, guards, |_, contact, _| {
        T::impulse(contact, contact.closing() / contact.separation_rate() - stop(contact))
    })
}

/// Energetic, stop in compression: twice the work of compression is `p_s`·(a − v_s) + v_s²/a2, and
/// e·x of restitution give back e² of it if a2·x² is that.
pub(crate) const fn energetic_compression<T: Then, L: ImpactLaw, N: Number>(
    name: &'static str,
    guards: &'static [Guard<L, N>],
) -> Regime<L, N> {
    fn work<T: Then, N: Number>(contact: &Contact<N>) -> N {
        let speed = speed_at_stop(contact);
        let sliding = stop(contact) * (contact.approach().clone() - &speed);
        sliding + speed.square() / T::rate(contact)
    }
    after::<T, L, N>(name, guards, |_, contact, x| {
        let compression = -(speed_at_stop(contact) / T::rate(contact));
        T::impulse(contact, x.mul_add(contact.restitution(), &compression))
    })
    .with_root(Root {
        coefficients: |_, contact| square_root(work::<T, N>(contact), T::rate(contact)),
        between: |_, contact| up_to(work::<T, N>(contact), T::rate(contact)),
    })
}

/// Energetic, stop in restitution: the final speed y has y² = v_s² + a2/a1·(e²·a² − v_s²), and
/// (y − v_s)/a2 is left, which is the excess over (y + v_s)·a1, where nothing cancels.
pub(crate) const fn energetic_restitution<T: Then, L: ImpactLaw, N: Number>(
    name: &'static str,
    guards: &'static [Guard<L, N>],
) -> Regime<L, N> {
    fn squared_speed<T: Then, N: Number>(contact: &Contact<N>) -> N {
        let rates = T::rate(contact) / contact.separation_rate();
        rates.mul_add(&excess(contact), &speed_at_stop(contact).square())
    }
    after::<T, L, N>(name, guards, |_, contact, y| {
        let speeds = speed_at_stop(contact) + y;
        T::impulse(contact, excess(contact) / (speeds * contact.separation_rate()))
    })
    .with_root(Root {
        coefficients: |_, contact| square_root(squared_speed::<T, N>(contact), N::one()),
        between: |_, contact| up_to(squared_speed::<T, N>(contact), N::one()),
    })
}

const fn after<T: Then, L: ImpactLaw, N: Number>(
    name: &'static str,
    guards: &'static [Guard<L, N>],
    impulse: fn(&L, &Contact<N>, &N) -> Impulse<N>,
) -> Regime<L, N> {
    let regime = Regime::new(name, guards, impulse);
    if T::STICKS { Regime { slip: Some(|_, _, _| N::zero()), ..regime } } else { regime }
}

/// The regimes of the process: 1. the contact does not approach, 2. and 3. it slides all
/// the time, 4. to 7. the slip stops in compression or in restitution, and then sticks or reverses.
/// The two arguments say how the collision ends in each.
macro_rules! regimes {
    ($compression:ident, $restitution:ident) => {
        const {
            use $crate::law::guards;
            use $crate::laws::routh::{self, Reverse, Stick, When};
            use $crate::laws::whittaker_uncapped::{frictionless, slide};
            use $crate::{Guard, Regime};
            &[
                Regime::new("no approach", guards![When::no_approach()], frictionless),
                Regime::new("slide, not slowed down", guards![When::slip_grows()], slide),
                Regime::new("slide", guards![Guard::slides_apart(), Guard::slides_on()], slide),
                routh::$compression::<Stick, Self, N>(
                    "stick from compression on",
                    guards![When::stops_in_compression(), When::sticks()],
                ),
                routh::$compression::<Reverse, Self, N>(
                    "reverse in compression",
                    guards![When::stops_in_compression()],
                ),
                routh::$restitution::<Stick, Self, N>(
                    "stick from restitution on",
                    guards![When::sticks()],
                ),
                routh::$restitution::<Reverse, Self, N>("reverse in restitution", &[]),
            ]
        }
    };
}
pub(crate) use regimes;

/// The guards of the process.
pub(crate) struct When;

impl When {
    /// a = 0
    pub(crate) const fn no_approach<L, N: Number>() -> Guard<L, N> {
        Guard::new(Relation::Zero, |_, contact: &Contact<N>| contact.approach().clone())
    }

    /// μ·`W_tt` ≤ `W_tn`: sliding does not slow down.
    pub(crate) const fn slip_grows<L, N: Number>() -> Guard<L, N> {
        Guard::new(Relation::NotPositive, |_, contact: &Contact<N>| contact.slowing_rate())
    }

    /// v_s < 0: the slip stops before compression ends.
    pub(crate) const fn stops_in_compression<L, N: Number>() -> Guard<L, N> {
        Guard::new(Relation::Negative, |_, contact: &Contact<N>| scaled_speed_at_stop(contact))
    }

    /// |`W_tn`| ≤ μ·`W_tt`, given `W_tn` < μ·`W_tt`.
    pub(crate) const fn sticks<L, N: Number>() -> Guard<L, N> {
        Guard::new(Relation::NotNegative, |_, contact: &Contact<N>| {
            contact.friction().mul_add(contact.delassus().tt(), contact.delassus().tn())
        })
    }
}

/// What the process comes to on a contact that does not couple, under every hypothesis.
pub(crate) const UNCOUPLED: &str = "k >= 0\ni_x = 1 when k > 0\ni_x <= 1 when k = 0";

/// What is said of every law that is the process.
pub(crate) const PROCESS: LawInfo = LawInfo {
    statement: UNCOUPLED,
    stated_for_coupling: false,
    is_process: true,
    on_a_sphere: crate::info::STOPS,
    ..LawInfo::PLAIN
};

/// The implementation of a law that is the process under one hypothesis.
macro_rules! process_law {
    ($law:ty, $compression:ident, $restitution:ident, $info:expr $(, accepted by $acceptance:ident)?) => {
        impl $crate::ImpactLaw for $law {
            const INFO: $crate::LawInfo = $info;

            fn normal_collision(&self) -> Option<kane_number::Rational> {
                Some(kane_number::Number::zero())
            }

            $(
                fn acceptance<N: kane_number::Number>(
                    &self,
                    contact: &$crate::Contact<N>,
                    impulse: &$crate::Impulse<N>,
                ) -> Option<N> {
                    Some(contact.$acceptance(impulse))
                }
            )?

            fn regimes<N: kane_number::Number>(&self) -> &'static [$crate::Regime<Self, N>] {
                $crate::laws::routh::regimes!($compression, $restitution)
            }
        }
    };
}
pub(crate) use process_law;

process_law!(
    RouthNewton,
    newton,
    newton,
    LawInfo {
        id: "routh-newton",
        people: "Routh",
        year: Some(1860),
        form: "with Newton's restitution",
        source: "E. J. Routh, Dynamics of a System of Rigid Bodies, for the process; closed form derived here, following Y. Wang and M. T. Mason, J. Appl. Mech. 59 (1992) 635-642, abstract consulted; Routh's original not consulted",
        known_by: Provenance::OthersAndAbstract,
        model: Some(ModelInfo {
            words: "Coulomb friction on rigid bodies",
            operations: [29, 30, 7, 0],
            lasting: Lasting::Full
        }),
        ..PROCESS
    }
);
process_law!(
    Keller1986,
    poisson_compression,
    poisson_restitution,
    LawInfo {
        id: "keller-1986",
        people: "Keller",
        year: Some(1986),
        source: "J. B. Keller, J. Appl. Mech. 53 (1986) 1-4, abstract consulted: Coulomb friction at every instant, and a coefficient of restitution for the normal impulse. That this is Poisson's is from memory of the literature; closed form derived here",
        known_by: Provenance::Abstract,
        restitution: Restitution::Poisson,
        ..PROCESS
    }
);
process_law!(
    Stronge1990,
    energetic_compression,
    energetic_restitution,
    LawInfo {
        id: "stronge-1990",
        people: "Stronge",
        year: Some(1990),
        source: "W. J. Stronge, Proc. R. Soc. Lond. A 431 (1990) 169-181, from memory of its use in the literature, and J. Appl. Mech. 58 (1991) 1049-1055, abstract consulted; closed form derived here",
        known_by: Provenance::Abstract,
        restitution: Restitution::Energetic,
        model: Some(ModelInfo {
            words: "Coulomb friction with energetic restitution",
            operations: [62, 60, 18, 1],
            lasting: Lasting::Full
        }),
        ..PROCESS
    }
);
