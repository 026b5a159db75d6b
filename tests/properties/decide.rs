//! Certified decisions against exact numbers: on ordinary inputs, on ties planted in the inputs and
//! their neighbours, and on floats of every exponent.
//!
//! In the gate the reference is [`Rational`], with α and the criterion of `energy` as they are
//! printed; what takes only sums and products of integers is fast enough for the long run:
//!
//! ```sh
//! cargo test --release --test properties ten_million_decisions -- --ignored --nocapture
//! ```

use std::cmp::Ordering;

use kane_impact::InvalidInput;
use kane_impact::bodies::{Motion, SphereOnPlane};
use kane_impact::decide::{self, Decision, Shares, Spheres, Stage};
use kane_impact::exact::wang_su_li;
use kane_impact::laws::{WangSuLi, WhittakerUncapped};
use kane_impact::{Alpha, ImpactLaw};
use kane_number::{Rational, Rounding, encode};

use crate::dyadic::Dyadic;
use crate::random::Random;
use crate::rational;
use crate::strategies::exact;

impl Random {
    fn below(&mut self, end: u32) -> u32 {
        u32::try_from(((self.bits() >> 32) * u64::from(end)) >> 32).expect("below a u32")
    }

    fn sign(&mut self) -> f64 {
        if self.bits() & 1 == 0 { 1.0 } else { -1.0 }
    }

    /// From 2^−10 to 2^10, all bits of the significand at random.
    fn size(&mut self) -> f64 {
        let exponent = u64::from(1023 - 10 + self.below(20)) << 52;
        f64::from_bits(exponent | self.bits() >> 12)
    }

    /// An integer below 16 times a power of two.
    fn short(&mut self) -> f64 {
        f64::from(1 + self.below(15)) * self.power()
    }

    fn power(&mut self) -> f64 {
        [0.25, 0.5, 1.0, 2.0, 4.0][self.below(5) as usize]
    }

    /// Any finite positive float, of every exponent alike.
    fn wild(&mut self) -> f64 {
        f64::from_bits(1 + self.bits() % (f64::INFINITY.to_bits() - 1))
    }

    fn restitution(&mut self) -> f64 {
        match self.below(4) {
            0 => 0.0,
            1 => 1.0,
            2 => f64::from(self.below(5)) / 4.0,
            _ => f64::from_bits(1.0_f64.to_bits() | self.bits() >> 12) - 1.0,
        }
    }

    fn sphere(&mut self, mut size: impl FnMut(&mut Self) -> f64) -> SphereOnPlane<f64> {
        SphereOnPlane {
            mass: size(self),
            radius: size(self),
            inertia: size(self),
            friction: size(self),
            restitution: self.restitution(),
            before: Motion {
                vx: size(self) * self.sign(),
                vy: size(self),
                omega: size(self) * self.sign(),
            },
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Asked {
    Slip,
    Sliding,
    FrictionWork,
    Energy,
    Cone,
}

const ASKED: [Asked; 5] =
    [Asked::Slip, Asked::Sliding, Asked::FrictionWork, Asked::Energy, Asked::Cone];

#[derive(Clone, Debug)]
struct Case {
    asked: Asked,
    sphere: SphereOnPlane<f64>,
    tangential: f64,
}

impl Case {
    fn decide(&self) -> Result<Decision, InvalidInput<f64>> {
        match self.asked {
            Asked::Slip => decide::slip(&self.sphere),
            Asked::Sliding => decide::sliding(&self.sphere),
            Asked::FrictionWork => decide::friction_work(&self.sphere),
            Asked::Energy => decide::energy(&self.sphere),
            Asked::Cone => decide::in_cone(&self.sphere, self.tangential),
        }
    }

    /// Puts v_x, or the impulse, where floats compute the tie: exact if the inputs are short.
    fn plant(&mut self) {
        let SphereOnPlane { mass, radius, inertia, friction, restitution, before } =
            self.sphere.clone();
        let sliding = friction * (1.0 + restitution) * before.vy;
        let slowing = (inertia + mass * radius * radius) * sliding;
        let slip = match self.asked {
            Asked::Slip => 0.0,
            Asked::Sliding => slowing / inertia,
            Asked::FrictionWork => slowing / inertia / 2.0,
            Asked::Energy => {
                let lost = inertia * before.vy * (1.0 - restitution) / friction;
                (slowing - lost) / inertia / 2.0
            }
            Asked::Cone => {
                self.tangential = mass * sliding * self.tangential.signum();
                return;
            }
        };
        self.sphere.before.vx = before.omega * radius + slip.copysign(before.vx);
    }

    fn nudge(&mut self, random: &mut Random) {
        let target = match self.asked {
            Asked::Cone => &mut self.tangential,
            _ => &mut self.sphere.before.vx,
        };
        *target = if random.bits() & 1 == 0 { target.next_up() } else { target.next_down() };
    }
}

fn case(random: &mut Random, wild_in_64: u32) -> Case {
    let asked = ASKED[random.below(5) as usize];
    let kind = random.below(64);
    let mut case = Case { asked, sphere: random.sphere(Random::size), tangential: random.size() };
    case.tangential *= random.sign();
    if kind < wild_in_64 {
        case.sphere = random.sphere(Random::wild);
        case.tangential = random.wild();
        return case;
    }
    match kind % 8 {
        // ties of short inputs, which are exact, and their neighbours
        0..=3 => {
            case.sphere = random.sphere(Random::short);
            case.sphere.restitution = f64::from(random.below(5)) / 4.0;
            case.sphere.inertia = random.power();
            case.sphere.friction = random.power();
            case.plant();
            if kind % 8 > 1 {
                case.nudge(random);
            }
        }
        // nearly ties
        4 => case.plant(),
        // zeros
        5 => {
            for input in [
                &mut case.sphere.friction,
                &mut case.sphere.before.vy,
                &mut case.sphere.before.omega,
                &mut case.sphere.before.vx,
            ] {
                if random.below(3) == 0 {
                    *input = 0.0;
                }
            }
        }
        _ => {}
    }
    case
}

/// By fractions, with α.
fn by_rationals(case: &Case) -> Ordering {
    let zero = rational(0, 1);
    let sphere = case.sphere.map(|&x| exact(x));
    let (one, two) = (rational(1, 1), rational(2, 1));
    let closing = (&one + &sphere.restitution) * &sphere.before.vy;
    let normal = &sphere.mass * closing;
    let sliding = &sphere.friction * &normal;
    if case.asked == Asked::Cone {
        let tangential = exact(case.tangential.abs());
        return sliding.cmp(&tangential);
    }
    let slip = &sphere.before.vx - &sphere.before.omega * &sphere.radius;
    if case.asked == Asked::Slip {
        return slip.cmp(&zero);
    }
    let size = if slip < zero { -slip } else { slip };
    let j_p = &one + &sphere.mass * &sphere.radius * &sphere.radius / &sphere.inertia;
    let change = &j_p * &sliding / &sphere.mass;
    let lost = (&one - &sphere.restitution) * &normal;
    if size == zero {
        return match case.asked {
            Asked::Sliding => zero.cmp(&change),
            Asked::FrictionWork => Ordering::Equal,
            _ => zero.cmp(&lost),
        };
    }
    let alpha = change / (&two * size);
    match case.asked {
        Asked::Sliding => one.cmp(&(two * alpha)),
        Asked::FrictionWork if alpha == zero => Ordering::Equal,
        Asked::FrictionWork => alpha.cmp(&one),
        _ if alpha == zero => zero.cmp(&lost),
        _ => {
            let lever = j_p * &sphere.friction * &sphere.friction * (&one + &sphere.restitution);
            (lever * (&alpha - &one)).cmp(&((one - sphere.restitution) * alpha))
        }
    }
}

/// By integers times powers of two: works of impulses, without a case distinction but v = 0.
fn by_dyadics(case: &Case) -> Ordering {
    let zero = || Dyadic::of(0.0);
    let SphereOnPlane { mass, radius, inertia, friction, restitution, before } =
        case.sphere.map(|&x| Dyadic::of(x));
    let size = |x: Dyadic| if x.sign() == Ordering::Less { -x } else { x };
    let closing = &(Dyadic::of(1.0) + restitution.clone()) * &before.vy;
    let sliding = &(&friction * &mass) * &closing;
    let slip = before.vx - &before.omega * &radius;
    // W_tt times m·J
    let mobility = inertia.clone() + &(&mass * &radius) * &radius;
    // S times mJ·(W_tt·S − 2·|v|) is 2·m·J times the work of friction
    let twice = &(&mass * &inertia) * &size(slip.clone());
    let twice = twice.clone() + twice;
    let work = match slip.sign() {
        Ordering::Equal => zero(),
        _ => &sliding * &(&mobility * &sliding - twice.clone()),
    };
    match case.asked {
        Asked::Cone => (sliding - size(Dyadic::of(case.tangential))).sign(),
        Asked::Slip => slip.sign(),
        Asked::Sliding => {
            let change = &mobility * &sliding;
            (twice - (change.clone() + change)).sign()
        }
        Asked::FrictionWork => work.sign(),
        Asked::Energy => {
            // 2·m·J times m·v_y²·(1 − e²)/2
            let kept = &(&mass * &before.vy) * &(Dyadic::of(1.0) - restitution);
            (work - &(&(&mass * &inertia) * &kept) * &closing).sign()
        }
    }
}

/// Runs many cases; gives the shares and how many were ties.
fn run(count: u64, wild_in_64: u32, truth: fn(&Case) -> Ordering) -> (Shares, u64) {
    let (mut random, mut shares, mut ties) = (Random(0x9e37_79b9_7f4a_7c15), Shares::default(), 0);
    for _ in 0..count {
        let case = case(&mut random, wild_in_64);
        let decision = case.decide().expect("inputs are in their domains");
        assert_eq!(decision.sign, truth(&case), "{case:?}");
        ties += u64::from(decision.sign == Ordering::Equal);
        shares.count(decision.stage);
    }
    println!("{count} decisions, {ties} of them ties: {shares:?}");
    (shares, ties)
}

#[test]
fn decisions_are_those_of_fractions() {
    let count = 100_000;
    let (shares, ties) = run(count, 1, by_rationals);
    assert!(10 * ties >= count, "{ties} ties");
    let every_stage = [shares.filter, shares.interval, shares.fixed, shares.big];
    assert!(every_stage.iter().all(|&share| share > 0), "{shares:?}");
}

#[test]
fn decisions_are_those_of_integers() {
    run(200_000, 16, by_dyadics);
}

#[test]
#[ignore = "minutes: run in release with --ignored"]
fn ten_million_decisions() {
    let count = 10_000_000;
    let (_, ties) = run(count, 2, by_dyadics);
    assert!(10 * ties >= count, "{ties} ties");
}

#[test]
fn ordinary_inputs_hardly_ever_leave_the_filter() {
    let (mut random, mut shares) = (Random(1), Shares::default());
    for _ in 0..200_000 {
        let sphere = random.sphere(Random::size);
        for asked in ASKED {
            let case = Case { asked, sphere: sphere.clone(), tangential: random.size() };
            shares.count(case.decide().expect("in their domains").stage);
        }
    }
    println!("random inputs: {shares:?}");
    // a filter fails where terms cancel to within 20u or so: one time in 2^48
    assert_eq!(shares.total() - shares.filter, 0);
}

/// Every remainder of a block, rows in doubt among others, and the first row that is refused.
#[test]
fn columns_decide_as_single_spheres_do() {
    let mut random = Random(5);
    for rows in [0_usize, 1, 63, 64, 65, 640, 1000] {
        let mut spheres: Vec<_> = (0..rows)
            .map(|row| match row % 128 {
                0..64 => random.sphere(Random::size),
                _ => case(&mut random, 2).sphere,
            })
            .collect();
        let (decided, signs) = by_columns(&spheres);
        let shares = decided.expect("all are in their domains");
        let mut expected = Shares::default();
        for (sphere, sign) in spheres.iter().zip(signs) {
            let decision = decide::sliding(sphere).expect("in its domain");
            assert_eq!(sign, decision.sign, "{sphere:?}");
            expected.count(decision.stage);
        }
        assert_eq!(shares, expected);
        for row in [rows / 2, rows.saturating_sub(1)] {
            let Some(sphere) = spheres.get_mut(row) else { continue };
            sphere.before.omega = f64::NAN;
            let (row_refused, error) = by_columns(&spheres).0.expect_err("a NaN");
            assert_eq!(row_refused, rows / 2);
            assert_eq!(error.to_string(), "the angular velocity is NaN, which is not finite");
        }
    }
}

type Refusal = (usize, InvalidInput<f64>);

fn by_columns(spheres: &[SphereOnPlane<f64>]) -> (Result<Shares, Refusal>, Vec<Ordering>) {
    let column = |of: fn(&SphereOnPlane<f64>) -> f64| spheres.iter().map(of).collect::<Vec<_>>();
    let (mass, radius, inertia) = (column(|s| s.mass), column(|s| s.radius), column(|s| s.inertia));
    let (friction, restitution) = (column(|s| s.friction), column(|s| s.restitution));
    let (vx, vy) = (column(|s| s.before.vx), column(|s| s.before.vy));
    let omega = column(|s| s.before.omega);
    let mut signs = vec![Ordering::Equal; spheres.len()];
    let columns = Spheres {
        mass: &mass,
        radius: &radius,
        inertia: &inertia,
        friction: &friction,
        restitution: &restitution,
        vx: &vx,
        vy: &vy,
        omega: &omega,
    };
    (decide::sliding_all(columns, &mut signs), signs)
}

/// The law itself, run on fractions.
#[test]
fn energy_is_that_of_the_law() {
    let mut random = Random(7);
    for _ in 0..4_000 {
        let mut case = case(&mut random, 0);
        let sphere = case.sphere.map(|&x| exact(x));
        let outcome = sphere.collide(&WhittakerUncapped).expect("valid");
        case.asked = Asked::Energy;
        let zero: Rational = rational(0, 1);
        let decided = case.decide().expect("valid").sign;
        assert_eq!(decided, outcome.energy.total().cmp(&zero), "{case:?}");
        case.asked = Asked::FrictionWork;
        let decided = case.decide().expect("valid").sign;
        assert_eq!(decided, outcome.work.tangential.cmp(&zero), "{case:?}");
    }
}

/// k and i_x as unreduced integers against fractions: exactly, and as the nearest floats.
#[test]
fn unreduced_ratios_are_those_of_fractions() {
    let (mut random, mut by_fixed) = (Random(11), 0);
    for count in 0..4_000 {
        let mut case = case(&mut random, 0);
        if count % 8 == 0 {
            case.sphere = random.sphere(Random::wild);
        }
        let ratios = wang_su_li(&case.sphere).expect("valid");
        let sphere = case.sphere.map(|&x| exact(x));
        let Some(alpha) = sphere.alpha().expect("valid") else {
            let ratios = ratios.map(|ratios| (ratios.k.to_f64(), ratios.impulse.to_f64()));
            assert!(matches!(ratios, None | Some((-1.0, 0.0))), "{case:?}");
            continue;
        };
        let alpha = if alpha < rational(0, 1) { -alpha } else { alpha };
        let truth = WangSuLi.ratios(&Alpha::Finite(alpha)).expect("finite");
        let ratios = ratios.expect("it slips");
        for (fraction, exact) in [(&ratios.k, &truth.k), (&ratios.impulse, &truth.impulse)] {
            by_fixed += u32::from(fraction.is_fixed());
            assert_eq!(fraction.to_rational(), *exact, "{case:?}");
            let nearest: f64 = encode(exact, Rounding::NearestEven);
            assert_eq!(fraction.to_f64().to_bits(), nearest.to_bits(), "{case:?}");
        }
    }
    assert!(by_fixed > 6_000, "{by_fixed}");
}

/// Each input at each special value: the same refusal as a collision's, or the right sign.
#[test]
fn inputs_without_sense_are_refused_as_everywhere() {
    let ordinary = [2.0, 0.5, 0.2, 0.3, 0.8, 1.0, 1.5, -2.0];
    let special = [f64::NAN, f64::INFINITY, -1.0, -0.0, 0.0, 5e-324, 2.0, 1e300];
    for at in 0..ordinary.len() {
        for value in special {
            let mut inputs = ordinary;
            inputs[at] = value;
            let [mass, radius, inertia, friction, restitution, vx, vy, omega] = inputs;
            let before = Motion { vx, vy, omega };
            let sphere = SphereOnPlane { mass, radius, inertia, friction, restitution, before };
            let refusal = sphere.contact().err().map(|error| error.to_string());
            for asked in ASKED {
                let case = Case { asked, sphere: sphere.clone(), tangential: 0.7 };
                match case.decide() {
                    Ok(decision) => assert_eq!(decision.sign, by_dyadics(&case), "{case:?}"),
                    // a collision turns v_y round before it looks
                    Err(error) => assert_eq!(
                        Some(error.to_string()),
                        refusal
                            .clone()
                            .map(|text| text.replace("velocity is -inf", "velocity is inf")),
                        "{case:?}"
                    ),
                }
            }
        }
    }
    let case =
        Case { asked: Asked::Cone, sphere: Random(3).sphere(Random::size), tangential: f64::NAN };
    let refusal = case.decide().expect_err("not finite").to_string();
    assert_eq!(refusal, "the tangential impulse is NaN, which is not finite");
}

#[test]
fn a_filter_does_not_answer_for_subnormals() {
    let tiny = f64::from_bits(3);
    let mut sphere = Random(3).sphere(Random::size);
    (sphere.before.vy, sphere.before.vx, sphere.before.omega) = (tiny, tiny, tiny);
    let decision = decide::sliding(&sphere).expect("valid");
    assert!(decision.stage > Stage::Filter, "{decision:?}");
}
