//! Whether a model is good enough.

use kane_impact::NumberSystem;
use kane_number::{DoubleDouble, Interval, Lane as _, Rational, System};

use super::evaluate::{Found, at, evaluate};
use super::model::{Mechanics, Model};
use super::reference::Reference;
use super::spread::{Part, affordable};
use super::upwards;
use crate::coordinate::Coordinate;
use crate::quantity::Quantity;
use crate::scene::{Scene, Setup};
use crate::tip::TipBody;

/// What is said of a model.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// Every error is within the tolerance, as surely as the reference is [known](super::Known).
    Meets,
    /// It measurably misses.
    Misses {
        /// The quantity with the worst error by its tolerance.
        quantity: Quantity,
        /// At least so far off.
        by: f64,
        /// Where.
        place: Place,
    },
    /// It may be good enough, but nothing certifies it.
    Uncertified(&'static str),
    /// It has no answer.
    Fails(String),
}

/// At which state a model misses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// At the values as stated.
    Stated,
    /// At a corner of the stated uncertainty.
    Corner,
    /// At values within a hundredth of those stated: at these themselves it agrees by chance.
    Near,
}

/// A model with its cost and its error.
#[derive(Clone, Debug, PartialEq)]
pub struct Judged {
    /// The model.
    pub model: Model,
    /// In additions of `f64`, an impact.
    pub cost: u64,
    /// The error of each quantity at the values as stated is no greater, as surely as the reference
    /// is [known](super::Known); `None` if unknown.
    pub errors: Vec<Option<f64>>,
    /// The greatest error by its tolerance; `None` if unknown, or the tolerance is 0 and the error
    /// is not.
    pub ratio: Option<f64>,
    /// Whether it is good enough.
    pub verdict: Verdict,
}

pub(super) fn judge(scene: &Scene, reference: &Reference, model: Model) -> Judged {
    let blank = |verdict| Judged {
        model,
        cost: model.cost(),
        errors: vec![None; scene.asked.len()],
        ratio: None,
        verdict,
    };
    if model.system == System::Interval {
        return blank(Verdict::Uncertified(
            "intervals hold no single answer; their middles are shown",
        ));
    }
    let values = match exact_values(scene, model) {
        Ok(values) => values,
        Err(reason) => return blank(Verdict::Fails(reason)),
    };
    let Ok(truth) = &reference.values else {
        return blank(Verdict::Uncertified("the reference has no answer to compare with"));
    };
    // between these two the error is
    let mut bounds: Vec<(Rational, Rational)> = Vec::new();
    for (value, (low, high)) in values.iter().zip(truth) {
        let zero = Rational::default();
        let (below, above) = (low - value, value - high);
        let least = below.max(above).max(zero);
        let most = (value - low).max(high - value);
        bounds.push((least, most));
    }
    let errors: Vec<Option<f64>> = bounds.iter().map(|(_, most)| Some(upwards(most))).collect();
    let ratio = ratio(scene, &errors);
    let verdict = verdict(scene, reference, model, &bounds);
    Judged { errors, ratio, verdict, ..blank(Verdict::Meets) }
}

fn ratio(scene: &Scene, errors: &[Option<f64>]) -> Option<f64> {
    let mut worst = 0.0_f64;
    for (error, asked) in errors.iter().zip(&scene.asked) {
        let (error, tolerance) = ((*error)?, asked.tolerance.to_f64());
        if error > 0.0 {
            worst = worst.max(error / tolerance);
        }
    }
    worst.is_finite().then_some(worst)
}

fn verdict(
    scene: &Scene,
    reference: &Reference,
    model: Model,
    bounds: &[(Rational, Rational)],
) -> Verdict {
    let missing = scene
        .asked
        .iter()
        .zip(bounds)
        .filter(|(asked, (least, _))| *least > asked.tolerance)
        .map(|(asked, (least, _))| (asked.quantity, upwards(least), asked.tolerance.to_f64()))
        .max_by(|a, b| (a.1 / a.2).total_cmp(&(b.1 / b.2)).then(a.1.total_cmp(&b.1)));
    if let Some((quantity, by, _)) = missing {
        return Verdict::Misses { quantity, by, place: Place::Stated };
    }
    if scene.asked.iter().zip(bounds).any(|(asked, (_, most))| *most > asked.tolerance) {
        return Verdict::Uncertified("the reference is not known well enough");
    }
    if model.mechanics == reference.mechanics {
        return Verdict::Meets;
    }
    let alike = |setup: &Setup<Interval>| {
        let found = evaluate(scene, setup, reference.mechanics, 1).ok()?;
        let other = evaluate(scene, setup, model.mechanics, 1).ok()?;
        Some((equal(model.mechanics, &found, &other), within(scene, &found, &other)))
    };
    let nominal = scene.nominal();
    // on principle, or not only by chance
    if alike(&nominal.map(Coordinate::enclosed)).is_none_or(|(equal, _)| !equal)
        && let Some(miss) =
            worst_at(scene, reference.mechanics, model.mechanics, &near(&nominal), Place::Near)
    {
        return miss;
    }
    let Some(over) = &reference.over else { return Verdict::Meets };
    // the same formulas over the whole uncertainty?
    let others =
        over.as_ref().ok().zip(evaluate(scene, &scene.enclosed(), model.mechanics, 1).ok());
    if let Some((found, other)) = &others
        && equal(model.mechanics, found, other)
    {
        return Verdict::Meets;
    }
    let corners = scene.corners();
    if let Some(miss) =
        worst_at(scene, reference.mechanics, model.mechanics, &corners, Place::Corner)
    {
        return miss;
    }
    if let Some((found, other)) = &others
        && within(scene, found, other)
    {
        return Verdict::Meets;
    }
    // part by part
    let whole = Part::whole(scene);
    let mut left = whole.halves(whole.widest(&whole)).to_vec();
    for _ in 0..affordable(scene, reference.mechanics, &reference.at) / 4 {
        let Some(part) = left.pop() else { return Verdict::Meets };
        if !alike(&part.enclosed(scene)).is_some_and(|(equal, within)| equal || within) {
            left.extend(part.halves(part.widest(&whole)));
        }
    }
    Verdict::Uncertified("it is not certified over the stated uncertainty")
}

/// Whether the model's formulas are those of the reference, given what happened at every impact under
/// either: all laws that slide all the time slide alike.
fn equal(model: Mechanics, found: &Found<Interval>, other: &Found<Interval>) -> bool {
    match model {
        Mechanics::NormalOnly => found.no_slip,
        Mechanics::Law(_) => found.slides && other.slides,
        _ => false,
    }
}

/// Whether the two enclosures over the whole uncertainty are so close that any two of their members
/// are within the tolerance.
fn within(scene: &Scene, found: &Found<Interval>, other: &Found<Interval>) -> bool {
    scene.asked.iter().zip(found.values.iter().zip(&other.values)).all(|(asked, (a, b))| {
        let width = a.hull(b).ends().map(|(low, high)| high - low);
        width.is_ok_and(|width| width <= asked.tolerance)
    })
}

/// Within a hundredth of the values as stated: friction, restitution, all velocities along one axis, or
/// all spins, each less and more.
fn near(nominal: &Setup<Rational>) -> Vec<Setup<Rational>> {
    let part = |n: i64| Rational::new(n.into(), 100.into());
    let one = Rational::from_integer(1.into());
    let mut all = Vec::new();
    for factor in [part(99), part(101)] {
        for which in 0..6 {
            let mut setup = nominal.clone();
            let scaled = |x: &mut Rational, this: usize| {
                if this == which {
                    *x = &*x * &factor;
                }
            };
            match &mut setup {
                Setup::Bodies(world) => {
                    world.frictions_mut().for_each(|mu| scaled(mu, 0));
                    world.restitutions_mut().for_each(|e| scaled(e, 1));
                    for body in &mut world.bodies {
                        scaled(&mut body.motion.vx, 2);
                        scaled(&mut body.motion.vy, 3);
                        scaled(&mut body.motion.omega, 4);
                        if let Some(off) = &mut body.off_plane {
                            scaled(&mut off.omega_x, 4);
                            scaled(&mut off.omega_y, 4);
                            scaled(&mut off.vz, 5);
                        }
                    }
                    world.restitutions_mut().for_each(|e| *e = e.clone().min(one.clone()));
                }
                Setup::Tip(tip) => {
                    scaled(&mut tip.friction, 0);
                    scaled(&mut tip.restitution, 1);
                    match &mut tip.body {
                        TipBody::Rod { motion, .. } => {
                            scaled(&mut motion.vx, 2);
                            scaled(&mut motion.vy, 3);
                            scaled(&mut motion.omega, 4);
                        }
                        TipBody::Pendulum { speeds: [first, second], .. } => {
                            scaled(first, 2);
                            scaled(second, 3);
                        }
                    }
                    tip.restitution = tip.restitution.clone().min(one.clone());
                }
            }
            if setup != *nominal {
                all.push(setup);
            }
        }
    }
    all
}

/// The worst miss at these states, measured in floats.
fn worst_at(
    scene: &Scene,
    reference: Mechanics,
    model: Mechanics,
    states: &[Setup<Rational>],
    place: Place,
) -> Option<Verdict> {
    let mut worst: Option<(Quantity, f64, f64)> = None;
    for state in states {
        let (Some(truth), Some(values)) = (at(scene, reference, state), at(scene, model, state))
        else {
            continue;
        };
        for ((asked, a), b) in scene.asked.iter().zip(truth).zip(values) {
            let (error, tolerance) = ((a - b).abs(), asked.tolerance.to_f64());
            // what floats themselves may err by is no miss of the model
            let noise = 1e-9 * (1.0 + a.abs());
            let by = error / tolerance;
            if error > tolerance + noise && worst.is_none_or(|(.., most)| by > most) {
                worst = Some((asked.quantity, error, by));
            }
        }
    }
    worst.map(|(quantity, by, _)| Verdict::Misses { quantity, by, place })
}

/// The model's values as exact numbers. Chains and processes say how far they are off themselves, and
/// that is in the reference already.
fn exact_values(scene: &Scene, model: Model) -> Result<Vec<Rational>, String> {
    fn of<N: Coordinate + NumberSystem>(
        scene: &Scene,
        model: Model,
    ) -> Result<Vec<Rational>, String> {
        let setup = scene.nominal().map(N::from_rational);
        let found = evaluate(scene, &setup, model.mechanics, 1).map_err(|f| f.to_string())?;
        let exact = found.values.iter().zip(&scene.asked).map(|(value, asked)| {
            value.exact().ok_or_else(|| format!("{} is beyond the range", asked.quantity))
        });
        exact.collect()
    }
    match model.system {
        System::F32 => of::<f32>(scene, model),
        System::F64 => of::<f64>(scene, model),
        System::DoubleDouble => of::<DoubleDouble>(scene, model),
        System::Interval => Err("intervals hold no single value".to_owned()),
        System::Rational => of::<Rational>(scene, model),
    }
}
