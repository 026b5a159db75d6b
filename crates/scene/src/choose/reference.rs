//! What a scene says is true, and what is known of it: models are held against this.

use kane_number::{Interval, Lane as _, Rational, decode};

use super::evaluate::{Failed, Found, evaluate};
use super::model::{COULOMB, ENERGETIC, GRIP, Mechanics};
use crate::coordinate::Coordinate;
use crate::scene::{Scene, Setup, Tangential};

/// How the reference's values are known, and with them every error against it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Known {
    /// Proved: in exact numbers.
    Exactly,
    /// Proved: on intervals.
    Enclosed,
    /// On intervals, in a range where the literature documents that an elastic contact slides all
    /// the time ([`Elastic::slides_up_to`](crate::Elastic::slides_up_to)). What the processes say
    /// there is charted in `docs/data/model-error.csv`.
    Documented,
    /// Heuristic: a process or an integration, by the change under refinement of its steps.
    Estimated,
}

impl Known {
    /// Its name in tables.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Exactly => "exact",
            Self::Enclosed => "enclosed",
            Self::Documented => "documented",
            Self::Estimated => "estimated",
        }
    }

    /// How what was found on intervals is known.
    fn on_intervals(mechanics: Mechanics, found: &Found<Interval>) -> Self {
        let elastic = matches!(mechanics, Mechanics::Compliant | Mechanics::Annuli);
        if found.estimated {
            Self::Estimated
        } else if elastic && !found.no_slip {
            Self::Documented
        } else {
            Self::Enclosed
        }
    }
}

/// How far the stated uncertainty moves an answer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// To either side, in the unit of the quantity.
    pub by: f64,
    /// Enclosed by intervals; else measured at the corners of the uncertainty, which is heuristic.
    pub enclosed: bool,
}

impl Spread {
    /// Whether the inputs leave more open than was asked; the tolerance in the unit of the quantity.
    #[must_use]
    pub fn exceeds(&self, tolerance: f64) -> bool {
        self.by > tolerance
    }
}

/// The reference of a scene.
pub(super) struct Reference {
    pub(super) mechanics: Mechanics,
    /// The two ends between which each quantity is, at the values as stated.
    pub(super) values: Result<Vec<(Rational, Rational)>, Failed>,
    pub(super) known: Known,
    /// What happens over the whole stated uncertainty, enclosed; `None` if nothing is uncertain.
    pub(super) over: Option<Result<Found<Interval>, Failed>>,
    /// The same at the values as stated.
    pub(super) at: Result<Found<Interval>, Failed>,
}

impl Reference {
    pub(super) fn of(scene: &Scene) -> Self {
        let mechanics = mechanics(scene);
        let nominal = scene.nominal();
        let exact = || {
            let found = evaluate(scene, &nominal, mechanics, 1)?;
            Ok(found.values.into_iter().map(|value| (value.clone(), value)).collect::<Vec<_>>())
        };
        let asks_exactly = scene
            .asked
            .iter()
            .any(|asked| asked.tolerance < Rational::new(1.into(), 10_u64.pow(15).into()));
        let at = evaluate(scene, &nominal.map(Coordinate::enclosed), mechanics, 1);
        let enclosed = |found: &Found<Interval>| -> Result<Vec<(Rational, Rational)>, Failed> {
            let ends =
                found.values.iter().zip(&scene.asked).map(|(value, asked)| {
                    value.ends().map_err(|_| Failed::NoValue(asked.quantity))
                });
            ends.collect()
        };
        // exact numbers where they are needed and can be had; else enclosures
        let (values, known) = match (asks_exactly, &at) {
            (true, _) | (false, Err(_)) => match (exact(), &at) {
                (Ok(values), _) => (Ok(values), Known::Exactly),
                (Err(_), Ok(found)) => (enclosed(found), Known::on_intervals(mechanics, found)),
                (Err(failed), Err(other)) => {
                    let failed = if other.is_of_the_model() { other.clone() } else { failed };
                    (Err(failed), Known::Enclosed)
                }
            },
            (false, Ok(found)) => (enclosed(found), Known::on_intervals(mechanics, found)),
        };
        let over =
            (scene.uncertain() > 0).then(|| evaluate(scene, &scene.enclosed(), mechanics, 1));
        Self { mechanics, values, known, over, at }
    }

    /// How far the stated uncertainty moves each answer to either side, from enclosures where they
    /// are finite, else by the corners of the box; `None` if nothing is uncertain, or not known.
    pub(super) fn spread(&self, scene: &Scene) -> Option<Vec<Spread>> {
        let over = self.over.as_ref()?;
        let all = |halves: Vec<f64>, enclosed| {
            Some(halves.into_iter().map(|by| Spread { by, enclosed }).collect())
        };
        if let Ok(found) = over {
            let half: Vec<f64> = found.values.iter().map(|value| value.width() / 2.0).collect();
            if half.iter().all(|half| half.is_finite()) {
                return all(half, !found.estimated);
            }
        }
        let middle = at(scene, self.mechanics, &scene.nominal())?;
        let mut most = vec![0.0_f64; middle.len()];
        for corner in scene.corners() {
            let values = at(scene, self.mechanics, &corner)?;
            for ((most, value), middle) in most.iter_mut().zip(values).zip(&middle) {
                *most = most.max((value - middle).abs());
            }
        }
        all(most, false)
    }
}

/// The values by a model in floats, for measuring.
pub(super) fn at(scene: &Scene, mechanics: Mechanics, setup: &Setup<Rational>) -> Option<Vec<f64>> {
    let found = evaluate(scene, &setup.map(|x| x.to_f64()), mechanics, 1).ok()?;
    let finite = found.values.iter().all(|value| decode(*value).is_ok());
    finite.then_some(found.values)
}

/// What the scene states of its contacts.
fn mechanics(scene: &Scene) -> Mechanics {
    let frictionless =
        scene.setup.friction().value == Rational::default() && scene.setup.friction().is_certain();
    match (&scene.tangential, &scene.setup) {
        _ if scene.stiffness.is_some() => Mechanics::Chain,
        _ if frictionless => Mechanics::NormalOnly,
        (Tangential::Grip(_), _) => Mechanics::Law(&GRIP),
        (Tangential::Elastic(_) | Tangential::Springs(_), _) => Mechanics::Compliant,
        (Tangential::Rigid, Setup::Tip(_)) => Mechanics::Law(&ENERGETIC),
        (Tangential::Rigid, Setup::Bodies(_)) => Mechanics::Law(&COULOMB),
    }
}
