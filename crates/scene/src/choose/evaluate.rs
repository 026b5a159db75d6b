//! A scene under one model.

use kane_impact::compliant::Loss;
use kane_impact::{Contact, Law, NumberSystem, Outcome};
use kane_number::{Interval, Lane as _, Number as _, Rational, System, decode};

use super::model::Mechanics;
use crate::air::Air;
use crate::coordinate::Coordinate;
use crate::quantity::{Kind, Quantity};
use crate::resolver::{COMPLIANT, Elastic, NormalOnly, Process, Resolver};
use crate::round::Round;
use crate::scene::{Scene, Setup, Tangential};
use crate::simulate::{
    Bounce, Budget, Chain, ChainError, End, Steps, Stopped, Until, collide_chain, run, run_in_air,
    run_tumbling,
};
use crate::tip::Tip;
use crate::world::World;

/// Why a model has no answer.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub(crate) enum Failed {
    #[error(transparent)]
    Stopped(#[from] Stopped),
    #[error(transparent)]
    NoImpulse(#[from] kane_impact::NoImpulse),
    #[error(transparent)]
    Chain(#[from] ChainError),
    #[error("{0}")]
    Invalid(String),
    #[error("{0} has no value here")]
    NoValue(Quantity),
}

impl Failed {
    /// Whether the model itself refuses, rather than its number system.
    pub(crate) fn is_of_the_model(&self) -> bool {
        let refuses = |reason: &kane_impact::NoImpulse| {
            matches!(reason, kane_impact::NoImpulse::Outside { .. })
        };
        match self {
            Self::NoImpulse(reason) => refuses(reason),
            Self::Stopped(Stopped::NoImpulse { source, .. }) => refuses(source),
            _ => false,
        }
    }
}

/// What a model finds.
pub(super) struct Found<N> {
    /// One a quantity asked for.
    pub(super) values: Vec<N>,
    /// Every impact slid all the time, or had no slip.
    pub(super) slides: bool,
    /// Some impact was followed by a process, whose error is its own estimate.
    pub(super) estimated: bool,
    /// No impact had any slip.
    pub(super) no_slip: bool,
    /// α of the first impact, with the sign of its slip.
    pub(super) alpha: Option<N>,
    pub(super) bounces: Vec<Bounce<N>>,
    pub(super) end: Option<End<N>>,
    pub(super) start_energy: N,
}

/// Runs the scene; keeps up to `kept` impacts.
pub(super) fn evaluate<N: Coordinate + NumberSystem>(
    scene: &Scene,
    setup: &Setup<N>,
    mechanics: Mechanics,
    kept: usize,
) -> Result<Found<N>, Failed> {
    evaluate_with(scene, setup, mechanics, kept, Budget::default().shown)
}

/// The same with so many impacts of a ball that comes to rest followed one by one.
pub(super) fn evaluate_with<N: Coordinate + NumberSystem>(
    scene: &Scene,
    setup: &Setup<N>,
    mechanics: Mechanics,
    kept: usize,
    shown: u64,
) -> Result<Found<N>, Failed> {
    if mechanics == Mechanics::Chain {
        return chain(scene, setup);
    }
    if let Setup::Bodies(world) = setup
        && let Some(air) = &world.air
    {
        return in_air(scene, world, air, mechanics, kept);
    }
    let resolver = resolver(scene, mechanics)?;
    match setup {
        Setup::Bodies(world) => bodies(scene, world, &*resolver, kept, shown),
        Setup::Tip(tip) => tips(scene, tip, &*resolver),
    }
}

/// What resolves one contact at a time.
fn resolver<N: Coordinate + NumberSystem>(
    scene: &Scene,
    mechanics: Mechanics,
) -> Result<Box<dyn Resolver<N>>, Failed> {
    Ok(match mechanics {
        Mechanics::NormalOnly => Box::new(NormalOnly),
        Mechanics::Law(law) => Box::new(stated(law, &scene.tangential)?),
        Mechanics::Compliant | Mechanics::Annuli => Box::new(contact(scene, mechanics)?),
        Mechanics::Chain => {
            return Err(Failed::Invalid("a chain is no single contact".to_owned()));
        }
    })
}

/// The law with what the scene states of it: the share of the slip that comes back.
fn stated(law: &Law, tangential: &Tangential) -> Result<Law, Failed> {
    let with = match (law.info.parameters, tangential) {
        ([], _) => Some(law.clone()),
        ([share], Tangential::Grip(value)) => law.with(share.name, value),
        _ => None,
    };
    with.ok_or_else(|| missing("tangential_restitution"))
}

/// The values by a model in floats, for measuring.
pub(super) fn at(scene: &Scene, mechanics: Mechanics, setup: &Setup<Rational>) -> Option<Vec<f64>> {
    let found = evaluate(scene, &setup.map(|x| x.to_f64()), mechanics, 1).ok()?;
    let finite = found.values.iter().all(|value| decode(*value).is_ok());
    finite.then_some(found.values)
}

/// The outcome of a tip's contact in floats.
pub(crate) fn resolve_tip(
    scene: &Scene,
    contact: &Contact<f64>,
    mechanics: Mechanics,
) -> Result<Outcome<f64>, Failed> {
    Ok(resolver(scene, mechanics)?.resolve(contact)?)
}

/// The elastic contact of the scene, followed by one process or by the finer one.
pub(super) fn contact(scene: &Scene, mechanics: Mechanics) -> Result<Elastic, Failed> {
    let (loss, finer) = (scene.loss, scene.finer);
    let of = |stiffness_ratio, process| Elastic { stiffness_ratio, process, loss, finer };
    match (&scene.tangential, mechanics) {
        (_, Mechanics::Annuli) if loss.is_some_and(|loss| loss != Loss::Recoil) => {
            Err(Failed::Invalid("annuli follow no damper".to_owned()))
        }
        (Tangential::Elastic(nu), _) => {
            let (one, two) = (Rational::one(), Rational::one().double());
            // Mindlin's
            let ratio = &two * (one - nu) / (&two - nu);
            let finer = mechanics == Mechanics::Annuli;
            let process =
                if finer { Process::MawBarberFawcett } else { Process::DimensionReduction };
            Ok(of(ratio, process))
        }
        (Tangential::Springs(ratio), Mechanics::Compliant) => {
            Ok(of(ratio.clone(), Process::Bilinear))
        }
        _ => Err(missing("poisson_ratio")),
    }
}

fn missing(key: &str) -> Failed {
    Failed::Invalid(format!("the scene states no {key}"))
}

fn bodies<N: Coordinate>(
    scene: &Scene,
    world: &World<N>,
    resolver: &dyn Resolver<N>,
    kept: usize,
    shown: u64,
) -> Result<Found<N>, Failed> {
    let (mut slides, mut no_slip, mut estimated) = (true, true, false);
    let mut bounces: Vec<Bounce<N>> = Vec::new();
    let mut alpha = None;
    let until = scene.until.map(N::from_rational);
    let budget = Budget { shown, impacts: most_impacts(N::SYSTEM, &until) };
    let mut observe = |bounce: &Bounce<N>| {
        // where a contact couples there may be friction without slip
        let none = bounce.slip[0].sign().is_equal() == Some(true) && bounce.corner.is_none();
        no_slip &= none;
        slides &= none || bounce.regime.starts_with("slide");
        estimated |= bounce.regime == COMPLIANT;
        if bounces.is_empty() && bounce.corner.is_none() {
            alpha = world.alpha(bounce);
        }
        if bounces.len() < kept.max(1) {
            bounces.push(bounce.clone());
        }
    };
    let end = match &world.corners {
        Some(corners) => run_tumbling(world, corners, resolver, &until, budget, &mut observe)?,
        None => run(world, resolver, &until, budget, &mut observe)?,
    };
    let start_energy = world.bodies.iter().fold(N::zero(), |sum, body| sum + body.kinetic_energy());
    let values = scene.asked.iter().map(|asked| {
        let value = asked.quantity.of(world, bounces.first(), &end);
        value.ok_or(Failed::NoValue(asked.quantity))
    });
    Ok(Found {
        values: values.collect::<Result<_, _>>()?,
        slides,
        estimated,
        no_slip,
        alpha,
        bounces,
        end: Some(end),
        start_energy,
    })
}

/// Bodies and pairs that are looked at in the steps of one motion in air.
const MOST_LOOKS: usize = 300_000;

/// Bodies in air: two runs in floats, of which the finer counts; the error of each number is estimated
/// by how far the coarser is from it, of which at fourth order a fifteenth would do.
fn in_air<N: Coordinate>(
    scene: &Scene,
    world: &World<N>,
    air: &Air<N>,
    mechanics: Mechanics,
    kept: usize,
) -> Result<Found<N>, Failed> {
    if N::of_enclosure(Interval::zero()).is_none() {
        return Err(Failed::Invalid("a flight in air has no exact answer".to_owned()));
    }
    let mut certain = true;
    let mut middle = |x: &N| {
        let enclosed = x.enclosed();
        certain &= enclosed.width() <= 1e-12 * enclosed.midpoint().abs();
        enclosed.midpoint()
    };
    let (floats, air) = (world.map(&mut middle), air.map(&mut middle));
    if !certain {
        return Err(Failed::Invalid("a flight in air is followed at a point alone".to_owned()));
    }
    let resolver = resolver::<f64>(scene, mechanics)?;
    let until = scene.until.map(|time| time.to_f64());
    let budget = Budget { shown: 0, impacts: most_impacts(System::Rational, &until) };
    // the corners of what is uncertain are followed, too: all share the looks
    let looks = MOST_LOOKS >> scene.uncertain().saturating_sub(2);
    let follow = |finer| {
        let mut bounces = Vec::new();
        let mut observe = |bounce: &Bounce<f64>| bounces.push(bounce.clone());
        let end = run_in_air(
            &floats,
            &air,
            &*resolver,
            &until,
            (budget, Steps { finer, looks }),
            &mut observe,
        )?;
        Ok::<_, Failed>((end, bounces))
    };
    let ((coarse_end, coarse), (end, fine)) = (follow(1)?, follow(2)?);
    let same = coarse.iter().map(|b| b.encounter).eq(fine.iter().map(|b| b.encounter));
    if !same {
        let (impact, time) = (end.impacts, end.time);
        return Err(Stopped::Undecided { impact, time }.into());
    }
    let lifted = |fine: f64, coarse: Option<f64>| {
        let error = coarse.map_or(f64::INFINITY, |coarse| (fine - coarse).abs());
        let error = error + 1e-14 * fine.abs();
        N::of_enclosure(Interval::between(fine - error, fine + error)).unwrap_or_else(N::zero)
    };
    let bounce = |(coarse, fine): (&Bounce<f64>, &Bounce<f64>)| {
        let mut numbers = Vec::new();
        coarse.map(|x| numbers.push(*x));
        let mut numbers = numbers.into_iter();
        fine.map(|x| lifted(*x, numbers.next()))
    };
    let mut numbers = Vec::new();
    coarse_end.map(|x| numbers.push(*x));
    let mut numbers = numbers.into_iter();
    let end = end.map(|x| lifted(*x, numbers.next()));
    let no_slip = fine.iter().all(|bounce| bounce.slip[0] == 0.0);
    let slides = |bounce: &Bounce<f64>| bounce.slip[0] == 0.0 || bounce.regime.starts_with("slide");
    let slides = fine.iter().all(slides);
    let bounces: Vec<Bounce<N>> = coarse.iter().zip(&fine).take(kept.max(1)).map(bounce).collect();
    let values = scene.asked.iter().map(|asked| {
        let value = asked.quantity.of(world, bounces.first(), &end);
        value.ok_or(Failed::NoValue(asked.quantity))
    });
    Ok(Found {
        values: values.collect::<Result<_, _>>()?,
        slides,
        estimated: true,
        no_slip,
        alpha: bounces.first().and_then(|bounce| world.alpha(bounce)),
        bounces,
        end: Some(end),
        start_energy: world.bodies.iter().fold(N::zero(), |sum, body| sum + body.kinetic_energy()),
    })
}

/// How many impacts are followed, by what one costs; of a ball that comes to rest fewer, because what
/// has not stopped slipping by then never does. In floats many impacts
/// are cheap: a model whose impacts have no sum is followed until they change nothing any more.
const fn most_impacts<N>(system: System, until: &Until<N>) -> u64 {
    match (system, until) {
        (System::Rational, Until::Rest) => 60,
        (System::Rational, _) => 1_000,
        (System::F32 | System::F64, _) => 100_000,
        (_, Until::Rest) => 4_000,
        (System::DoubleDouble | System::Interval, _) => 10_000,
    }
}

fn tips<N: Coordinate>(
    scene: &Scene,
    tip: &Tip<N>,
    resolver: &dyn Resolver<N>,
) -> Result<Found<N>, Failed> {
    let (contact, energy) = tip.contact().map_err(|error| Failed::Invalid(error.to_string()))?;
    let outcome = resolver.resolve(&contact)?;
    let values = scene.asked.iter().map(|asked| {
        let value = match asked.quantity.kind {
            Kind::K => outcome.slip.checked_div(contact.slip()),
            Kind::TangentialImpulse => Some(outcome.impulse.tangential.clone()),
            Kind::NormalImpulse => Some(outcome.impulse.normal.clone()),
            Kind::Slip => Some(outcome.slip.clone()),
            Kind::Separation => Some(outcome.separation.clone()),
            Kind::EnergyRatio => {
                outcome.work.total().checked_div(&energy).map(|change| N::one() + change)
            }
            _ => None,
        };
        value.ok_or(Failed::NoValue(asked.quantity))
    });
    let no_slip = contact.slip().sign().is_equal() == Some(true);
    Ok(Found {
        values: values.collect::<Result<_, _>>()?,
        slides: outcome.regime.starts_with("slide"),
        estimated: outcome.regime == COMPLIANT,
        // without slip a contact that couples may still have a tangential impulse
        no_slip: no_slip && contact.delassus().tn().sign().is_equal() == Some(true),
        alpha: None,
        bounces: Vec::new(),
        end: None,
        start_energy: energy,
    })
}

/// Steps of a chain's integration, and for the estimate of its error half of them.
const STEPS: u32 = 8_192;

/// The row of spheres in floats; `None` if the scene states no stiffness.
pub(crate) fn chain_of<N: Coordinate>(scene: &Scene, setup: &Setup<N>) -> Option<Chain> {
    let (Setup::Bodies(world), Some(stiffness)) = (setup, &scene.stiffness) else { return None };
    // exact where it can be, so that spheres that touch have no gap by rounding
    let gap = |pair: &[Round<N>]| {
        let [a, b] = pair else { return 0.0 };
        let exact = b.position[0].clone() - &a.position[0] - &a.radius - &b.radius;
        exact.to_f64().max(0.0)
    };
    Some(Chain {
        masses: world.bodies.iter().map(|body| body.mass.to_f64()).collect(),
        gaps: world.bodies.windows(2).map(gap).collect(),
        velocities: world.bodies.iter().map(|body| body.motion.vx.to_f64()).collect(),
        stiffness: stiffness.to_f64(),
    })
}

fn chain<N: Coordinate>(scene: &Scene, setup: &Setup<N>) -> Result<Found<N>, Failed> {
    let chain = chain_of(scene, setup).ok_or_else(|| missing("stiffness"))?;
    if N::of_enclosure(Interval::zero()).is_none() {
        return Err(Failed::Invalid("an integration has no exact answer".to_owned()));
    }
    let (coarse, fine) = (collide_chain(&chain, STEPS / 2)?, collide_chain(&chain, STEPS)?);
    // at least first order is certain, so that what is left is at most what the halving changed;
    // twice that, and a part for the rounding of the steps
    let speed = chain.velocities.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
    let velocity = |i: usize| {
        let error = 2.0 * (fine[i] - coarse[i]).abs() + 1e-13 * speed;
        Interval::between(fine[i] - error, fine[i] + error)
    };
    let kinetic = |velocity: &dyn Fn(usize) -> Interval| {
        chain.masses.iter().enumerate().fold(Interval::zero(), |sum, (i, mass)| {
            sum + velocity(i).square() * Interval::from(*mass / 2.0)
        })
    };
    let start = kinetic(&|i| Interval::from(chain.velocities[i]));
    let values = scene.asked.iter().map(|asked| {
        let value = match asked.quantity.kind {
            Kind::Vx => Some(velocity(asked.quantity.body)),
            Kind::Energy => Some(kinetic(&velocity)),
            Kind::EnergyRatio => kinetic(&velocity).checked_div(&start),
            _ => None,
        };
        value.and_then(N::of_enclosure).ok_or(Failed::NoValue(asked.quantity))
    });
    Ok(Found {
        values: values.collect::<Result<_, _>>()?,
        slides: true,
        estimated: true,
        no_slip: true,
        alpha: None,
        bounces: Vec::new(),
        end: None,
        start_energy: N::of_enclosure(start).unwrap_or_else(N::zero),
    })
}
