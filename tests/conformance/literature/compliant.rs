//! What every compliant process is held to, and how fast steps converge.
//!
//! Each process has a module of its own for the numbers that are printed for it.

use kane::impact::compliant::{
    Bilinear, Compliance, DimensionReduction, HertzMindlin, MawBarberFawcett, Memory, Moment,
    NoOutcome, Process,
};
use kane::impact::{Alpha, Ratios};

/// A solid sphere with ν = 0.3, χ = 1.4412.
pub(super) fn steel(restitution: f64) -> Compliance {
    Compliance::of_poisson(3.5, 0.3, restitution).expect("a sphere")
}

pub(super) fn ratios(process: &dyn Process, alpha: f64) -> Ratios<f64> {
    process.outcome(&Alpha::Finite(alpha)).expect("within its budget").ratios
}

/// From grazing to nearly normal, and normal.
const ALPHAS: [f64; 14] =
    [1e-6, 0.1, 0.5, 0.605, 0.7, 0.85, 1.0, 1.3, 1.9, 2.5, 4.0, 10.0, 1e3, f64::INFINITY];

fn processes(compliance: Compliance) -> [Box<dyn Process>; 5] {
    [
        Box::new(Bilinear::new(compliance)),
        Box::new(HertzMindlin::new(compliance)),
        Box::new(HertzMindlin::new(compliance).remembering(Memory::Displacement)),
        Box::new(MawBarberFawcett::with_grid(compliance, 20, 100).expect("a grid")),
        Box::new(DimensionReduction::with_grid(compliance, 40, 200).expect("a grid")),
    ]
}

fn compliances() -> Vec<Compliance> {
    let mut all = Vec::new();
    for chi in [0.3, 0.5, 1.4412, 2.0, 8.0] {
        for restitution in [0.0, 0.3, 0.98, 1.0] {
            all.push(Compliance::new(chi, restitution).expect("in the domain"));
        }
    }
    all
}

/// (9) and (19) of Wang, Su and Li from three sums that are made apart: of the impulse, of the work,
/// and of the changes of the slip. N additions of terms below 1 are off by N·u at most; k may grow
/// them by 2χ, and Δe and i_x are divided by α.
#[test]
fn momentum_and_work_balance_to_rounding() {
    for compliance in compliances() {
        for process in processes(compliance) {
            for alpha in ALPHAS {
                let outcome = process.outcome(&Alpha::Finite(alpha)).expect("within its budget");
                let Ratios { k, impulse, energy } = outcome.ratios;
                let steps = f64::from(u32::try_from(outcome.ledger.steps).expect("few"));
                let rounding = 4.0 * (steps + 10.0) * f64::EPSILON * (1.0 + compliance.chi());
                let what = format!("{} {compliance:?} at {alpha}", process.id());
                if alpha == f64::INFINITY {
                    assert!(impulse == 0.0 && energy == 0.0, "{what}");
                    continue;
                }
                let momentum = (1.0 - k) - 2.0 * alpha * impulse;
                assert!(momentum.abs() <= rounding * (1.0 + alpha), "{what}: {momentum:e}");
                let work = 2.0 * energy + impulse * (1.0 + k);
                assert!(work.abs() <= rounding * (1.0 + 1.0 / alpha), "{what}: {work:e}");
            }
        }
    }
}

/// Coulomb at every step, locally where there are annuli or springs, and no energy from nothing: the
/// kinetic energy of the slip is never above the first, and together with what is stored it never
/// rises, save where the slip of an annulus reverses within a step, which falls with the step and is
/// below 1e-4 of the first energy on these coarse grids. The incremental springs have no energy that
/// depends on their state alone; see their own module.
#[test]
fn the_cone_and_the_energy_hold_at_every_step() {
    for compliance in compliances() {
        for process in processes(compliance) {
            for alpha in ALPHAS {
                let outcome = process.outcome(&Alpha::Finite(alpha)).expect("within its budget");
                let ledger = outcome.ledger;
                let what = format!("{} {compliance:?} at {alpha}: {ledger:?}", process.id());
                assert!(ledger.beyond_cone <= 1e-12, "{what}");
                assert_eq!(ledger.created.is_none(), process.id().starts_with("hertz"), "{what}");
                let Some(created) = ledger.created else { continue };
                let limit = if process.id() == "stronge-bilinear" { 1e-12 } else { 1e-4 };
                assert!(created <= limit, "{what}");
                // stored energy is not negative: what moves has no more than the first and this
                assert!(ledger.above_start <= created + 1e-12, "{what}");
                assert!(outcome.ratios.k.abs() <= 1.0 + created + 1e-12, "{what}");
                assert!((0.0..=1.0 + 1e-12).contains(&outcome.ratios.impulse), "{what}");
            }
        }
    }
}

/// The same seen from outside: by an observer who is told time, forces and slip, and sums up momentum
/// on its own.
#[test]
fn an_observer_finds_the_cone_and_the_momentum_as_well() {
    let steel = steel(0.9);
    let (alpha, cone) = (1.2, steel.cone(1.2));
    let check = |all: &[Moment], k: f64| {
        let (mut normal, mut slip) = (0.0, 1.0);
        for pair in all.windows(2) {
            let [from, to] = pair else { continue };
            let h = to.time - from.time;
            assert!(h > 0.0);
            normal += h * (from.normal + to.normal) / 2.0;
            slip -= steel.chi() * cone * h * (from.friction + to.friction);
            assert!(to.friction.abs() <= to.normal + 1e-12);
            assert!((to.slip - slip).abs() < 1e-12);
        }
        assert!((normal - 1.9).abs() < 1e-12 && (slip - k).abs() < 1e-12);
        // it sticks at last, and friction reverses: the mark of tangential compliance
        assert!(all.iter().any(|moment| moment.friction < -1e-3));
    };
    let alpha = Alpha::Finite(alpha);
    let mut all: Vec<Moment> = Vec::new();
    let end = HertzMindlin::new(steel).observe(&alpha, &mut |moment| all.push(*moment));
    check(&all, end.expect("it ends").0.k);
    all.clear();
    let end = MawBarberFawcett::new(steel).observe(&alpha, &mut |moment| all.push(*moment));
    check(&all, end.expect("it settles").0.k);
    all.clear();
    let end = DimensionReduction::new(steel).observe(&alpha, &mut |moment| all.push(*moment));
    check(&all, end.expect("it ends").0.k);
}

/// α → 0 is sliding all the time, and so is every α that is small enough, to rounding.
#[test]
fn small_alpha_is_sliding() {
    for compliance in compliances() {
        for process in processes(compliance) {
            let grazing = Ratios { k: 1.0, impulse: 1.0, energy: -1.0 };
            assert_eq!(ratios(process.as_ref(), 0.0), grazing);
            for alpha in [1e-300, 1e-9, 0.1] {
                let found = ratios(process.as_ref(), alpha);
                assert!((found.k - (1.0 - 2.0 * alpha)).abs() < 1e-12, "{}", process.id());
                assert!((found.impulse - 1.0).abs() < 1e-12, "{}", process.id());
            }
        }
    }
}

#[test]
fn the_same_question_has_the_same_answer() {
    for process in processes(steel(1.0)) {
        let again = processes(steel(1.0)).into_iter().find(|other| other.id() == process.id());
        for alpha in ALPHAS {
            let alpha = Alpha::Finite(alpha);
            let again = again.as_ref().expect("the same").outcome(&alpha);
            assert_eq!(process.outcome(&alpha), again);
        }
    }
}

#[test]
fn what_has_no_sense_is_refused_by_name() {
    for (chi, e, message) in [
        (f64::NAN, 1.0, "chi is NaN, which is not finite"),
        (0.0, 1.0, "chi is 0, but must be positive"),
        (-1.0, 1.0, "chi is -1, but must be positive"),
        (f64::INFINITY, 1.0, "chi is inf, which is not finite"),
        (1.0, 1.5, "the restitution is 1.5, but must not exceed 1"),
        (1.0, -0.1, "the restitution is -0.1, but must not be negative"),
        (1.0, f64::NAN, "the restitution is NaN, which is not finite"),
    ] {
        let refusal = Compliance::new(chi, e).expect_err("out of the domain");
        assert_eq!(refusal.to_string(), message);
    }
    assert!(Compliance::of_poisson(3.5, 0.6, 1.0).is_err());
    assert!(Compliance::of_poisson(3.5, -1.0, 1.0).is_err());
    assert!(Compliance::of_springs(3.5, 0.0, 1.0).is_err());
    for process in processes(steel(1.0)) {
        for alpha in [-1.0, f64::NAN] {
            let refusal = process.outcome(&Alpha::Finite(alpha)).expect_err("no α");
            assert!(matches!(refusal, NoOutcome::Alpha(_)), "{refusal}");
        }
    }
    for steps in [0, 1, 10_000_000] {
        let refusal = HertzMindlin::with_steps(steel(1.0), steps).expect_err("no such budget");
        let message = format!("the number of steps is {steps}, but must be from 6 to 1000000");
        assert_eq!(refusal.to_string(), message);
    }
    assert!(MawBarberFawcett::with_grid(steel(1.0), 3, 100).is_err());
    assert!(DimensionReduction::with_grid(steel(1.0), 10, 1_000_000).is_err());
}

/// Springs that are stiff or soft beyond any material end in a budget or in an outcome, not in a loop.
#[test]
fn absurd_stiffness_ends() {
    for chi in [1e-12, 1e-3, 1e4, 1e12] {
        let springs = Bilinear::new(Compliance::new(chi, 0.9).expect("positive"));
        for alpha in [1e-12, 0.5, 1.0, chi, 3.0 * chi, 1e3 * chi, 1e300, f64::INFINITY] {
            match springs.outcome(&Alpha::Finite(alpha)) {
                Ok(outcome) => assert!(outcome.ratios.k.abs() <= 1.0 + 1e-9, "{chi} {alpha}"),
                Err(error) => assert!(matches!(error, NoOutcome::TooManyEvents(_)), "{error}"),
            }
        }
    }
}

/// The root of the mean square of k's error over many α, which averages over where in a step the
/// events fall.
pub(super) fn error(process: &dyn Process, alphas: &[f64], truth: &dyn Process) -> f64 {
    let square = |alpha: &f64| (ratios(process, *alpha).k - ratios(truth, *alpha).k).powi(2);
    let count = f64::from(u32::try_from(alphas.len()).expect("few"));
    (alphas.iter().map(square).sum::<f64>() / count).sqrt()
}

/// The order that errors show from the first to the last of steps that are halved each time.
pub(super) fn order(what: &str, errors: &[f64]) -> f64 {
    let halvings = f64::from(u32::try_from(errors.len() - 1).expect("few"));
    let order = (errors[0] / errors[errors.len() - 1]).log2() / halvings;
    let errors: Vec<String> = errors.iter().map(|error| format!("{error:.1e}")).collect();
    println!("{what}: order {order:.2}, errors {}", errors.join(", "));
    order
}

/// n values from one to the other, in geometric progression.
pub(super) fn spread(from: f64, to: f64, n: u32) -> Vec<f64> {
    let ratio = (to / from).powf(1.0 / f64::from(n - 1));
    (0..n).map(|i| from * ratio.powi(i32::try_from(i).expect("few"))).collect()
}
