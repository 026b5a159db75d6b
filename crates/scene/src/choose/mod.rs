//! The least model that is good enough.
//!
//! Candidates are tried from the cheapest by counted cost. One is accepted where its error in every
//! quantity asked for is known to be within the tolerance, and passed over where it measurably is
//! not, or where nothing shows it. *Known* is by a bound, by a documented result, or by the estimate
//! of a process, and [`Known`] tells which. No clock is asked.

mod evaluate;
mod judge;
mod model;
mod reasons;
mod reference;
mod refine;
mod spread;

pub use judge::{Judged, Place, Verdict};
pub use model::{Mechanics, Model, UnknownModel, model_names};
pub use reference::Known;
pub use spread::Spread;

use kane_impact::{Law, NumberSystem};
use kane_number::{Lane as _, Rational, Rounding, encode};
use num_traits::Signed as _;

use crate::coordinate::Coordinate;
use crate::picture::Picture;
use crate::quantity::Quantity;
use crate::scene::{Scene, Setup};
use crate::simulate::{Bounce, End};
pub(crate) use evaluate::{Failed, chain_of, resolve_tip};
use evaluate::{Found, evaluate};
use reference::Reference;

/// How many models are tried.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effort {
    /// Up to the first that is good enough.
    Chosen,
    /// All that apply.
    All,
}

/// A number as a float and as its own text.
#[derive(Clone, Debug, PartialEq)]
pub struct Shown {
    /// near it
    pub value: f64,
    /// the shortest decimal of a float, or a fraction
    pub text: String,
}

/// A quantity that was asked for, answered.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// What was asked.
    pub quantity: Quantity,
    /// Near the answer of the model.
    pub value: f64,
    /// The exact answer, from a model in exact numbers.
    pub exact: Option<String>,
    /// No further is the answer from that of the reference, as surely as [`Answer::known`] says;
    /// `None` if that is unknown.
    pub error: Option<f64>,
    /// What was asked for.
    pub tolerance: f64,
    /// How far the stated uncertainty moves the reference's answer to either side; `None` if nothing
    /// is uncertain, or it is not known.
    pub spread: Option<Spread>,
}

/// The answer to a scene.
#[derive(Clone, Debug)]
pub struct Answer {
    /// The SHA-256 of the scene's file.
    pub sha256: String,
    /// What collides, at the values as stated.
    pub stated: Setup<Shown>,
    /// Every quantity, in the order of the file.
    pub lines: Vec<Line>,
    /// How the reference is known, and so what every error here is: a bound, documented, or an
    /// estimate; `None` if the reference has no answer.
    pub known: Option<Known>,
    /// The models that were tried, from the cheapest.
    pub judged: Vec<Judged>,
    /// The cheapest of those tried that is good enough; `None` if none is.
    pub chosen: Option<Model>,
    /// The one that was asked for; it alone was tried, if not [all](Effort::All) were.
    pub wanted: Option<Model>,
    /// The one whose answer is shown: the chosen one, or the one that was asked for, or the most
    /// faithful one.
    pub shown: Model,
    /// Why, sentence by sentence.
    pub reasons: Vec<String>,
    /// The impacts, up to some thousand.
    pub bounces: Vec<Bounce<Shown>>,
    /// What impacts, gravity and the air have done to the energy up to each of them.
    pub sums: Vec<Bounced>,
    /// The state at the end; `None` for one impact of a tip and for a chain.
    pub end: Option<End<Shown>>,
    /// The kinetic energy at the start; J.
    pub start_energy: f64,
    /// What the scene shows of itself.
    pub picture: Option<Picture>,
}

/// The change of energy since the start, right after an impact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounced {
    /// s
    pub time: f64,
    /// By the normal, tangential and rotational part of impacts, by gravity, and by the air, which is 0
    /// where there is none; J.
    pub parts: [f64; 5],
}

/// The running sums of a ledger.
fn sums(bounces: &[Bounce<Shown>]) -> Vec<Bounced> {
    let mut parts = [0.0; 5];
    let after = |bounce: &Bounce<Shown>| {
        let Bounce { ledger, gravity, .. } = bounce;
        let added = [&ledger.normal, &ledger.tangential, &ledger.rotational, gravity];
        for (part, added) in parts.iter_mut().zip(added.into_iter().chain(&bounce.air)) {
            *part += added.value;
        }
        Bounced { time: bounce.time.value, parts }
    };
    bounces.iter().map(after).collect()
}

/// Why there is nothing to show.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{model} has no answer: {reason}")]
pub struct NoAnswer {
    /// The model.
    pub model: Model,
    /// What it lacks.
    pub reason: String,
}

/// Answers a scene by the least model that these laws and the processes offer, or by the one given. `progress` hears how many of how many
/// models are judged.
///
/// # Errors
/// [`NoAnswer`] if the model to be shown has none.
pub fn answer(
    scene: &Scene,
    laws: &'static [Law],
    wanted: Option<Model>,
    effort: Effort,
    progress: &mut dyn FnMut(usize, usize),
) -> Result<Answer, NoAnswer> {
    let scene = &refine::refined(scene, reference::mechanics(scene));
    let reference = Reference::of(scene);
    let candidates = model::candidates(reference.mechanics, laws, scene.in_air());
    let mut judged = Vec::new();
    for (index, candidate) in candidates.iter().enumerate() {
        progress(index, candidates.len());
        if wanted.is_some_and(|wanted| effort == Effort::Chosen && wanted != *candidate) {
            continue;
        }
        let verdict = judge::judge(scene, &reference, *candidate);
        let good = verdict.verdict == Verdict::Meets;
        judged.push(verdict);
        if good && effort == Effort::Chosen {
            break;
        }
    }
    if let Some(wanted) = wanted
        && !judged.iter().any(|judged| judged.model == wanted)
    {
        judged.push(judge::judge(scene, &reference, wanted));
    }
    let chosen = judged.iter().find(|judged| judged.verdict == Verdict::Meets).map(|j| j.model);
    let faithful = model::faithful(reference.mechanics);
    let shown = wanted.or(chosen).unwrap_or(faithful);
    let told = of_model(scene, shown).map_err(|reason| NoAnswer { model: shown, reason })?;
    let verdict = judged.iter().find(|judged| judged.model == shown);
    let spread = reference.spread.as_ref();
    let lines = scene
        .asked
        .iter()
        .enumerate()
        .map(|(index, asked)| Line {
            quantity: asked.quantity,
            value: told.values[index].value,
            exact: told.exact.then(|| told.values[index].text.clone()),
            error: verdict.and_then(|judged| judged.errors.get(index).copied().flatten()),
            tolerance: asked.tolerance.to_f64(),
            spread: spread.map(|spread| spread[index]),
        })
        .collect();
    let reasons = reasons::reasons(scene, &reference, &judged, chosen, wanted, effort);
    let stated = |x: &Rational| Shown { value: x.to_f64(), text: x.to_string() };
    Ok(Answer {
        sha256: scene.sha256.clone(),
        stated: scene.nominal().map(stated),
        lines,
        known: reference.values.is_ok().then_some(reference.known),
        chosen,
        wanted,
        shown,
        reasons,
        picture: Picture::of(scene, shown, laws),
        judged,
        sums: sums(&told.bounces),
        bounces: told.bounces,
        end: told.end,
        start_energy: told.start_energy,
    })
}

/// Rounded up, so that a bound stays one.
fn upwards(exact: &Rational) -> f64 {
    encode(&exact.abs(), Rounding::Up)
}

/// What a model says, whatever its number system.
struct Told {
    values: Vec<Shown>,
    exact: bool,
    bounces: Vec<Bounce<Shown>>,
    end: Option<End<Shown>>,
    start_energy: f64,
}

/// Impacts that are kept for tables.
const KEPT: usize = 5_000;

fn of_model(scene: &Scene, model: Model) -> Result<Told, String> {
    use kane_number::System;
    fn told<N: Coordinate + NumberSystem>(scene: &Scene, model: Model) -> Result<Told, String> {
        let setup = scene.nominal().map(N::from_rational);
        let found: Found<N> =
            evaluate(scene, &setup, model.mechanics, KEPT).map_err(|failed| failed.to_string())?;
        let shown = |x: &N| Shown { value: x.to_f64(), text: x.to_string() };
        Ok(Told {
            values: found.values.iter().map(shown).collect(),
            exact: N::SYSTEM == System::Rational,
            bounces: found.bounces.iter().map(|bounce| bounce.map(shown)).collect(),
            end: found.end.as_ref().map(|end| end.map(shown)),
            start_energy: found.start_energy.to_f64(),
        })
    }
    match model.system {
        System::F32 => told::<f32>(scene, model),
        System::F64 => told::<f64>(scene, model),
        System::DoubleDouble => told::<kane_number::DoubleDouble>(scene, model),
        System::Interval => told::<kane_number::Interval>(scene, model),
        System::Rational => told::<Rational>(scene, model),
    }
}

/// The motion in floats for a picture, with more impacts than a table shows.
pub(crate) fn run_for_picture(
    scene: &Scene,
    world: &crate::world::World<f64>,
    mechanics: Mechanics,
) -> Option<(End<f64>, Vec<Bounce<f64>>)> {
    let setup = crate::scene::Setup::Bodies(world.clone());
    let found = evaluate::evaluate_with(scene, &setup, mechanics, KEPT, PICTURED).ok()?;
    Some((found.end?, found.bounces))
}

/// Impacts of a ball that comes to rest, followed one by one for a picture: later ones are too small
/// to be seen.
const PICTURED: u64 = 60;
