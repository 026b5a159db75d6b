//! What a scene says is true, and what is known of it: models are held against this.

use kane_number::{DoubleDouble, Interval, Lane as _, Number as _, Rational, decode};

use super::evaluate::{Failed, Found, evaluate};
use super::model::{COULOMB, ENERGETIC, GRIP, Mechanics};
use super::spread::{Spread, affordable, spread};
use crate::coordinate::Coordinate;
use crate::read::Stated;
use crate::scene::{Scene, Setup, Tangential};
use crate::world::World;

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
    /// Heuristic: a process or an integration, by the change under refinement of its steps, or a law in
    /// floats of two lengths, by their difference.
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

/// The reference of a scene.
pub(super) struct Reference {
    pub(super) mechanics: Mechanics,
    /// The two ends between which each quantity is, at the values as stated.
    pub(super) values: Result<Vec<(Rational, Rational)>, Failed>,
    pub(super) known: Known,
    /// What happens over the whole stated uncertainty, enclosed; `None` if nothing is uncertain.
    pub(super) over: Option<Result<Found<Interval>, Failed>>,
    /// How far the stated uncertainty moves each answer; `None` if nothing is uncertain, or it is not
    /// known.
    pub(super) spread: Option<Vec<Spread>>,
    /// The same at the values as stated.
    pub(super) at: Result<Found<Interval>, Failed>,
}

impl Reference {
    pub(super) fn of(scene: &Scene) -> Self {
        let mechanics = mechanics(scene);
        let nominal = scene.nominal();
        let exact = || -> Result<Vec<(Rational, Rational)>, Failed> {
            let found = evaluate(scene, &nominal, mechanics, 1)?;
            Ok(found.values.into_iter().map(|value| (value.clone(), value)).collect())
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
        let tells = |ends: &[(Rational, Rational)]| {
            let mut all = ends.iter().zip(&scene.asked);
            // so wide that what is near the middle is still within the tolerance of either end
            all.all(|((low, high), asked)| {
                (high - low).double() <= &asked.tolerance + asked.tolerance.double()
            })
        };
        // exact numbers where they are needed and can be had; else enclosures
        let (values, known) = match (asks_exactly, &at) {
            (true, _) | (false, Err(_)) => match (exact(), &at) {
                (Ok(values), _) => (Ok(values), Known::Exactly),
                (Err(_), Ok(found)) => (enclosed(found), Known::on_intervals(mechanics, found)),
                (Err(_), Err(failed)) => (Err(failed.clone()), Known::Enclosed),
            },
            (false, Ok(found)) => (enclosed(found), Known::on_intervals(mechanics, found)),
        };
        let untold = match &values {
            Ok(ends) => !asks_exactly && known != Known::Estimated && !tells(ends),
            Err(failed) => !failed.is_of_the_model(),
        };
        let (values, known) = match compared(scene, mechanics).filter(|_| untold) {
            Some(ends) => (Ok(ends), Known::Estimated),
            None => (values, known),
        };
        let over =
            (scene.uncertain() > 0).then(|| evaluate(scene, &scene.enclosed(), mechanics, 1));
        let spread =
            over.as_ref().and_then(|_| spread(scene, mechanics, affordable(scene, mechanics, &at)));
        Self { mechanics, values, known, over, spread, at }
    }
}

/// The reference in floats of two lengths, where neither intervals nor exact numbers tell what is asked
/// for: if both agree to the tolerance, the longer ones are taken to be right to a millionth of
/// their difference, since both lose digits alike and they have more than as many again.
fn compared(scene: &Scene, mechanics: Mechanics) -> Option<Vec<(Rational, Rational)>> {
    // steps are in f64, whatever holds their numbers
    if !matches!(mechanics, Mechanics::NormalOnly | Mechanics::Law(_)) || scene.in_air() {
        return None;
    }
    let nominal = scene.nominal();
    let short = evaluate(scene, &nominal.map(|x| x.to_f64()), mechanics, 1).ok()?;
    let long = evaluate(scene, &nominal.map(DoubleDouble::from_rational), mechanics, 1).ok()?;
    let impacts = |end: Option<u64>| end.unwrap_or(0);
    if impacts(short.end.map(|end| end.impacts)) != impacts(long.end.map(|end| end.impacts)) {
        return None;
    }
    let values = short.values.iter().zip(&long.values).zip(&scene.asked);
    let ends = values.map(|((short, long), asked)| {
        let (short, long) = (decode(*short).ok()?, long.exact()?);
        let apart = if short < long { &long - &short } else { &short - &long };
        let within = &apart / Rational::from_integer(1_000_000.into());
        (apart <= asked.tolerance).then(|| (&long - &within, &long + &within))
    });
    ends.collect()
}

/// What the scene states of its contacts.
pub(super) fn mechanics(scene: &Scene) -> Mechanics {
    let none = |mu: &Stated| mu.value == Rational::default() && mu.is_certain();
    let frictionless = scene.setup.frictions().into_iter().all(none);
    match (&scene.tangential, &scene.setup) {
        _ if scene.stiffness.is_some() => Mechanics::Chain,
        _ if frictionless => Mechanics::NormalOnly,
        (Tangential::Grip(_), _) => Mechanics::Law(&GRIP),
        (Tangential::Elastic(_) | Tangential::Springs(_), _) => Mechanics::Compliant,
        (Tangential::Rigid, Setup::Tip(_) | Setup::Bodies(World { corners: Some(_), .. })) => {
            Mechanics::Law(&ENERGETIC)
        }
        (Tangential::Rigid, Setup::Bodies(_)) => Mechanics::Law(&COULOMB),
    }
}
