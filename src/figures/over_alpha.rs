//! k, `i_x` and μ′ over α: Figures 3, 4 and 5 of the paper, with all laws.

use kane_impact::compliant::{MawBarberFawcett, NoOutcome, Process as _};
use kane_impact::{Alpha, Ratios};
use kane_measure::{OverAlpha, over_alpha};
use kane_number::{Algebraic, Number as _, Rational, Rounding, encode};
use kane_report::figures::{Axis, Border, Content, Figure, Kind, Series, Zone};

use super::experiment::{self, Observed, Point};

/// A border of a zone: y by α, and whether the zone is above.
type Edge = (fn(&Rational) -> Rational, bool);

/// One of the three quantities, by every way that leads to it.
struct Quantity {
    stem: &'static str,
    title: &'static str,
    y: Axis,
    of_law: fn(&Ratios<Algebraic>) -> Algebraic,
    of_process: fn(&Ratios<f64>) -> f64,
    of_point: fn(&Point) -> f64,
    /// beyond these energy rises, and the cone is left
    energy: &'static [Edge],
    cone: &'static [Edge],
    energy_rises: &'static str,
    out_of_cone: &'static str,
}

fn ratio(numerator: i32, denominator: i32) -> Rational {
    Rational::new(numerator.into(), denominator.into())
}

/// μ = 0.092 of the experiment, for μ′ = μ·`i_x`.
fn friction() -> Rational {
    ratio(92, 1000)
}

fn quantities() -> [Quantity; 3] {
    let axis = |symbol, label: &str, range, ticks: &[f64], is_logarithmic| Axis {
        symbol,
        label: label.to_owned(),
        range,
        ticks: ticks.to_vec(),
        is_logarithmic,
    };
    [
        Quantity {
            stem: "slip-over-alpha",
            title: "Tangential velocity of the contact point: after by before, over α",
            y: axis(
                "k",
                "k = v_t⁺/v_t (dimensionless)",
                (-1.5, 1.5),
                &[-1.5, -1.0, -0.5, 0.0, 0.5, 1.0, 1.5],
                false,
            ),
            of_law: |ratios| ratios.k.clone(),
            of_process: |ratios| ratios.k,
            of_point: |point| point.k,
            energy: &[(|_| ratio(-1, 1), false), (|_| ratio(1, 1), true)],
            cone: &[
                (|alpha| ratio(1, 1) - ratio(2, 1) * alpha, false),
                (|alpha| ratio(1, 1) + ratio(2, 1) * alpha, true),
            ],
            energy_rises: "tangential energy grows: |k| > 1",
            out_of_cone: "outside the friction cone: |1 − k| > 2·α",
        },
        Quantity {
            stem: "impulse-over-alpha",
            title: "Tangential impulse: share of that of full sliding, over α",
            y: axis(
                "i_x",
                "i_x = I_x/(μ·I_y) (dimensionless)",
                (-0.5, 1.5),
                &[-0.5, 0.0, 0.5, 1.0, 1.5],
                false,
            ),
            of_law: |ratios| ratios.impulse.clone(),
            of_process: |ratios| ratios.impulse,
            of_point: Point::impulse,
            energy: &[(|alpha| alpha.recip(), true), (|_| ratio(0, 1), false)],
            cone: &[(|_| ratio(1, 1), true), (|_| ratio(-1, 1), false)],
            energy_rises: "tangential energy grows: i_x < 0 or > 1/α",
            out_of_cone: "outside the friction cone: |i_x| > 1",
        },
        Quantity {
            stem: "friction-over-alpha",
            title: "Effective coefficient of friction, at μ = 0.092, over α",
            y: axis(
                "mu_effective",
                "μ′ = μ·i_x (dimensionless, logarithmic)",
                (0.001, 1.0),
                &[0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0],
                true,
            ),
            of_law: |ratios| Algebraic::from_rational(&friction()) * &ratios.impulse,
            of_process: |ratios| experiment::FRICTION * ratios.impulse,
            of_point: |point| experiment::FRICTION * point.impulse(),
            energy: &[(|alpha| friction() / alpha, true)],
            cone: &[(|_| friction(), true)],
            energy_rises: "tangential energy grows: μ′ > μ/α",
            out_of_cone: "outside the friction cone: μ′ > μ",
        },
    ]
}

/// The half-space over α, with the materials of the experiment.
struct HalfSpace {
    ratios: Vec<(f64, Ratios<f64>)>,
    error: f64,
}

pub(super) fn figures(progress: &mut dyn FnMut(usize, usize)) -> Result<[Figure; 3], NoOutcome> {
    let laws = over_alpha(kane_impact::laws());
    let half_space = half_space(&laws.alphas, progress)?;
    let observed = experiment::observed();
    Ok(quantities().map(|quantity| figure(quantity, &laws, &half_space, &observed)))
}

fn half_space(
    alphas: &[Rational],
    progress: &mut dyn FnMut(usize, usize),
) -> Result<HalfSpace, NoOutcome> {
    let maw = MawBarberFawcett::new(experiment::compliance()?);
    let mut found = HalfSpace { ratios: Vec::new(), error: 0.0 };
    let all = alphas.len();
    for (done, alpha) in alphas.iter().enumerate().step_by(2) {
        progress(done, all);
        let alpha = encode(alpha, Rounding::NearestEven);
        let outcome = maw.outcome(&Alpha::Finite(alpha))?;
        found.error = found.error.max(outcome.error);
        found.ratios.push((alpha, outcome.ratios));
    }
    progress(all, all);
    Ok(found)
}

fn figure(
    quantity: Quantity,
    laws: &OverAlpha,
    half_space: &HalfSpace,
    observed: &[Observed],
) -> Figure {
    let float = |alpha: &Rational| encode::<f64>(alpha, Rounding::NearestEven);
    let alphas: Vec<f64> = laws.alphas.iter().map(float).collect();
    let mut series: Vec<Series> = Vec::new();
    for curve in &laws.curves {
        let value = |ratios: &Option<Ratios<Algebraic>>| {
            ratios.as_ref().map(|ratios| (quantity.of_law)(ratios).to_f64())
        };
        series.push(Series {
            names: curve.laws.iter().map(|id| (*id).to_owned()).collect(),
            kind: Kind::Law,
            points: alphas.iter().copied().zip(curve.ratios.iter().map(value)).collect(),
            bars: Vec::new(),
            decimals: 6,
        });
    }
    let of_process = |(alpha, ratios): &(f64, _)| (*alpha, Some((quantity.of_process)(ratios)));
    series.push(Series {
        names: vec!["maw-barber-fawcett, with the materials of the experiment".to_owned()],
        kind: Kind::Process,
        points: half_space.ratios.iter().map(of_process).collect(),
        bars: Vec::new(),
        decimals: 4,
    });
    let bar = |point: &Point| {
        let [a, b] = point.ends().map(|end| (quantity.of_point)(&end));
        (a - b).abs() / 2.0
    };
    series.extend(observed.iter().map(|observed| Series {
        names: vec![observed.name.to_owned()],
        kind: Kind::Measured,
        points: observed.points.iter().map(|p| (p.alpha, Some((quantity.of_point)(p)))).collect(),
        bars: observed.points.iter().map(bar).collect(),
        decimals: 4,
    }));
    let zone = |name: &str, borders: &[Edge]| Zone {
        name: name.to_owned(),
        borders: borders
            .iter()
            .map(|(y, is_zone_above)| Border {
                points: laws.alphas.iter().map(|alpha| (float(alpha), float(&y(alpha)))).collect(),
                is_zone_above: *is_zone_above,
            })
            .collect(),
    };
    let zones = vec![
        zone(quantity.energy_rises, quantity.energy),
        zone(quantity.out_of_cone, quantity.cone),
    ];
    let x = super::alpha(0.02, 20.0);
    let notes = notes(laws, half_space, beyond(&series, &x, &quantity.y));
    Figure {
        stem: quantity.stem,
        title: quantity.title.to_owned(),
        notes,
        x,
        y: quantity.y,
        content: Content::Curves { series, zones },
    }
}

/// How many measured points the axes leave out.
fn beyond(series: &[Series], x: &Axis, y: &Axis) -> usize {
    let is_off = |axis: &Axis, value: f64| value < axis.range.0 || axis.range.1 < value;
    let measured = series.iter().filter(|one| one.kind == Kind::Measured);
    let points = measured.flat_map(|one| &one.points);
    points.filter(|(at, value)| is_off(x, *at) || value.is_none_or(|v| is_off(y, v))).count()
}

fn notes(laws: &OverAlpha, half_space: &HalfSpace, beyond: usize) -> Vec<String> {
    let mut notes = vec![
        "A sphere on a plane: α = j_p·μ·(1 + e)·v_n/(2·v_t). Laws have their default parameters; those that coincide share a line.".to_owned(),
        "A line ends where its law has no answer: brach's, which depends on all of the energy, here for e = 0.".to_owned(),
        "Measured: Kharaz, Gorham and Salman (2001), spheres of alumina on glass, e = 0.98, μ = 0.092, as digitised by others; weak at both ends.".to_owned(),
        format!(
            "Bars: what {}% of the measured quantity does. The source as digitised tells no errors; two hands read one figure up to {:.1}% apart.",
            100.0 * experiment::READING,
            100.0 * experiment::hands_differ(),
        ),
        format!("The half-space is fitted to nothing; the estimated error of its k is below {}.", ceiling(half_space.error)),
    ];
    if !laws.without.is_empty() {
        let without = laws.without.join(", ");
        notes.push(format!("Not drawn, as they do not depend on α alone: {without}."));
    }
    if beyond > 0 {
        notes.push(format!("Measured points beyond the axes: {beyond}; the data have them."));
    }
    notes
}

/// Three decimals, rounded up.
fn ceiling(x: f64) -> String {
    format!("{:.3}", (x * 1000.0).floor() / 1000.0 + 0.001)
}
