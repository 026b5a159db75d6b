//! Every law's answer, in every number system, as data for a report.

use kane_impact::bodies::CollideError;
use kane_impact::{Contact, Law, NoImpulse, NumberSystem};
use kane_number::{
    Algebraic, Interval, Number as _, Ordered as _, Rational, Rounding, Scaled, encode,
    error_in_ulps, ulp,
};

use super::checks::checks;
use super::lanes::{Measured, Quantity, at_contact, of_contact, of_system};
use super::written::near;
use super::{Answer, Check, Energy, Errors, LawAnswer, Reading, System, written};

/// The contact and the energy before, above the answers.
pub(super) fn before(system: &System<Rational>, contact: &Contact<Rational>) -> Vec<Reading> {
    let mut readings: Vec<Reading> = of_contact(contact)
        .into_iter()
        .map(|(quantity, exact)| of_exact(quantity, exact.map(Algebraic::from).as_ref()))
        .collect();
    let energy =
        Quantity { symbol: "T-", unit: "J", meaning: "kinetic energy before", column: false };
    readings.push(of_exact(energy, Some(&Algebraic::from(system.kinetic_energy()))));
    readings
}

fn reading(quantity: Quantity) -> Reading {
    Reading {
        symbol: quantity.symbol,
        unit: quantity.unit,
        meaning: quantity.meaning,
        column: quantity.column,
        ..Reading::default()
    }
}

/// A rational number in full.
fn fraction(exact: &Algebraic) -> Option<String> {
    exact.as_rational().map(Rational::to_string)
}

fn of_exact(quantity: Quantity, exact: Option<&Algebraic>) -> Reading {
    Reading {
        exact: exact.map(written),
        fraction: exact.and_then(fraction),
        float: exact.map(Algebraic::to_f64).filter(|float| float.is_finite()),
        ..reading(quantity)
    }
}

/// The answer of a law, with all lanes and checks if it is asked for in depth.
pub(super) fn answer(law: &Law, system: &System<Rational>, deeply: bool) -> LawAnswer {
    let answer = if deeply { in_depth(law, system) } else { in_short(law, system) };
    let parameters = law.parameters().into_iter();
    LawAnswer {
        id: law.info.id,
        statement: law.info.statement,
        source: law.info.source,
        restitution: law.restitution(),
        parameters: parameters.map(|(name, value)| (name, value.to_string())).collect(),
        answer,
    }
}

/// The reason, without the law's name, which stands beside it.
fn reason<N: std::fmt::Display>(error: &CollideError<N>) -> String {
    match error {
        CollideError::NoImpulse(NoImpulse::Outside { reason, .. }) => (*reason).to_owned(),
        other => other.to_string(),
    }
}

/// A law's answer in exact numbers: rational ones if they suffice, as they mostly do.
struct Exact {
    measured: Measured<Algebraic>,
    energy: Energy,
    checks: Vec<Check>,
}

/// Bits of a contact with which an irrational outcome takes a second or two. Velocities of 17 digits
/// and angles in degrees come to some 2,000.
const MOST_BITS: u64 = 5_000;
const TOO_LONG: &str = "the outcome is irrational, and from inputs of so many digits its exact form would take too long; give fewer digits";

/// The bits of the contact's entries and coefficients in all.
fn bits(contact: &Contact<Rational>) -> u64 {
    let w = contact.delassus();
    let (mu, e) = (contact.friction(), contact.restitution());
    let all = [contact.slip(), contact.approach(), w.tt(), w.tn(), w.nn(), mu, e];
    all.iter().map(|entry| entry.numer().bits() + entry.denom().bits()).sum()
}

/// Runs the exact lane; the checks only if asked for.
fn exactly(law: &Law, system: &System<Rational>, checked: bool) -> Result<Exact, String> {
    fn run<N: NumberSystem<WideSystem = N>>(
        law: &Law,
        system: &System<N>,
        checked: bool,
    ) -> Result<(Measured<N>, Vec<Check>), CollideError<N>> {
        let happened = of_system(law, system)?;
        let checks = if checked { checks(law, system, &happened) } else { Vec::new() };
        Ok((happened.measured, checks))
    }
    let (measured, checks) = match run(law, system, checked) {
        Ok((measured, checks)) => (measured.map(|exact| Some(Algebraic::from(exact))), checks),
        Err(CollideError::NoImpulse(NoImpulse::Unrepresentable { .. })) => {
            if system.contact().is_ok_and(|contact| bits(&contact) > MOST_BITS) {
                return Err(TOO_LONG.to_owned());
            }
            let system = system.map(|exact| Algebraic::from(exact.clone()));
            run(law, &system, checked).map_err(|error| reason(&error))?
        }
        Err(error) => return Err(reason(&error)),
    };
    let sign = measured.get("dE").map(Algebraic::sign);
    let energy = match sign {
        Some(sign) if sign.is_greater() == Some(true) => Energy::Created,
        Some(sign) if sign.is_equal() == Some(true) => Energy::Kept,
        _ => Energy::Lost,
    };
    Ok(Exact { measured, energy, checks })
}

/// The inputs, each rounded to the nearest float.
fn in_floats(system: &System<Rational>) -> System<f64> {
    system.map(|exact| encode(exact, Rounding::NearestEven))
}

/// The answer by way of double-double, rounded once; `None` where it is no float.
fn in_double_double(
    law: &Law,
    floats: &System<f64>,
) -> Result<Measured<f64>, CollideError<Scaled>> {
    let wide = of_system(law, &floats.map(kane_number::Number::widen))?;
    Ok(wide.measured.map(|value| Some(value.to_f64()).filter(|float| float.is_finite())))
}

fn in_short(law: &Law, system: &System<Rational>) -> Result<Answer, String> {
    let exact = exactly(law, system, false)?;
    let values = exact.measured.values.iter();
    let told = |quantity: &Quantity| {
        quantity.column || matches!(quantity.symbol, "p_t" | "p_n") || is_energy(quantity)
    };
    let readings = values
        .filter(|(quantity, _)| told(quantity))
        .map(|(quantity, value)| of_exact(*quantity, value.as_ref()))
        .collect();
    Ok(Answer {
        regime: exact.measured.regime,
        energy: exact.energy,
        readings,
        checks: Vec::new(),
        remarks: Vec::new(),
    })
}

/// Whether the quantity is a part of the energy ledger.
fn is_energy(quantity: &Quantity) -> bool {
    quantity.unit == "J"
}

fn in_depth(law: &Law, system: &System<Rational>) -> Result<Answer, String> {
    let mut exact = exactly(law, system, true)?;
    let regime = exact.measured.regime;
    let mut remarks = Vec::new();

    let floats = in_floats(system);
    let wide = in_double_double(law, &floats);
    let plain = floats.contact().map_err(CollideError::from);
    let plain = plain.and_then(|contact| {
        let (measured, _) = at_contact(law.over(), &contact)?;
        Ok(measured)
    });
    // what the floats should give: the inputs as they are after rounding, without any error
    let rounded = system.map(|exact| nearest(exact).unwrap_or_else(|| exact.clone()));
    let truth = exactly(law, &rounded, false).map(|truth| truth.measured);
    let enclosed = of_system(law, &system.map(Interval::from_rational));
    let enclosed = enclosed.map(|happened| happened.measured);

    let of_floats = truth.as_ref().ok().map(|truth| truth.regime);
    let regimes = (regime, of_floats);
    note(&mut remarks, "plain f64", regimes, plain.as_ref().map_err(reason));
    note(&mut remarks, "double-double", regimes, wide.as_ref().map_err(reason));
    note(&mut remarks, "intervals", regimes, enclosed.as_ref().map_err(reason));
    if exact.measured.values.iter().flat_map(|(_, value)| value).any(|v| v.as_rational().is_none())
    {
        remarks.push("the regime's root is irrational: exact numbers are algebraic".to_owned());
    }

    let mut outside = Vec::new();
    let mut readings = Vec::new();
    for (quantity, value) in &exact.measured.values {
        let get =
            |lane: Option<&Measured<f64>>| lane.and_then(|lane| lane.get(quantity.symbol)).copied();
        let (plain, wide) = (get(plain.as_ref().ok()), get(wide.as_ref().ok()));
        let truth = truth.as_ref().ok().and_then(|truth| truth.get(quantity.symbol)).map(near);
        let given = value.as_ref().map(near);
        let error = |float: Option<f64>| {
            let float = float.filter(|float| float.is_finite())?;
            error_in_ulps(float, truth.as_ref()?).ok().map(|ulps| f64::from_rational(&ulps))
        };
        let by_inputs = given
            .as_ref()
            .zip(truth.as_ref())
            .map(|(given, truth)| f64::from_rational(&((truth - given) / ulp::<f64>(given))));
        let enclosure = enclosed.as_ref().ok().and_then(|lane| lane.get(quantity.symbol));
        if let (Some(enclosure), Some(value)) = (enclosure, value)
            && !holds(*enclosure, value)
        {
            outside.push(quantity.symbol);
        }
        readings.push(Reading {
            exact: value.as_ref().map(written),
            fraction: value.as_ref().and_then(fraction),
            float: wide,
            plain: plain.filter(|float| float.is_finite()),
            errors: Some(Errors { inputs: by_inputs, plain: error(plain), wide: error(wide) }),
            enclosure: enclosure.map(|enclosure| [enclosure.lower(), enclosure.upper()]),
            ..reading(*quantity)
        });
    }
    if enclosed.is_ok() {
        exact.checks.push(Check {
            claim: "every interval holds the exact value".to_owned(),
            holds: outside.is_empty(),
        });
    }
    Ok(Answer { regime, energy: exact.energy, readings, checks: exact.checks, remarks })
}

/// Says so if a lane has no answer, or another regime's than the exact one; beside that stands the exact
/// regime of the inputs as floats.
fn note<N>(
    remarks: &mut Vec<String>,
    lane: &str,
    (regime, of_floats): (&str, Option<&str>),
    answer: Result<&Measured<N>, String>,
) {
    match answer {
        Ok(measured) if measured.regime == regime => {}
        Ok(Measured { regime, .. }) => {
            let why = match of_floats == Some(*regime) {
                true => "inputs rounded to floats lie on the other side of a boundary",
                false => "it rounds across a boundary",
            };
            remarks.push(format!("{lane}: takes the regime \"{regime}\", for {why}"));
        }
        Err(reason) => remarks.push(format!("{lane}: no answer; {reason}")),
    }
}

/// The float nearest to an exact number, exactly.
fn nearest(exact: &Rational) -> Option<Rational> {
    let float: f64 = encode(exact, Rounding::NearestEven);
    kane_number::decode(float).ok()
}

/// Whether the exact number is inside.
fn holds(enclosure: Interval, exact: &Algebraic) -> bool {
    let end = |float: f64| kane_number::decode(float).ok().map(Algebraic::from);
    let above = end(enclosure.lower()).is_none_or(|lower| lower <= *exact);
    let below = end(enclosure.upper()).is_none_or(|upper| *exact <= upper);
    above && below
}

#[cfg(test)]
mod tests {
    use super::*;
    use kane_impact::bodies::{Motion, SphereOnPlane};
    use kane_impact::law;
    use kane_number::parse;

    fn sphere() -> SphereOnPlane<Rational> {
        let n = |text| parse(text).expect("a literal");
        SphereOnPlane {
            mass: n("0.3"),
            radius: n("0.7"),
            inertia: n("0.0588"),
            friction: n("0.092"),
            restitution: n("0.98"),
            before: Motion { vx: n("1.3"), vy: n("3.6"), omega: n("-0.2") },
        }
    }

    fn agrees(law: &Law) {
        let floats = sphere().map(|exact| encode(exact, Rounding::NearestEven));
        let ours = in_double_double(law, &System::Sphere(floats.clone()));
        let ours = ours.expect("the input is ordinary");
        let theirs = floats.collide(law.over()).expect("the input is ordinary");
        assert_eq!(ours.get("p_t"), Some(&-theirs.tangential_impulse), "{}", law.info.id);
        assert_eq!(ours.get("p_n"), Some(&theirs.normal_impulse), "{}", law.info.id);
        assert_eq!(ours.get("v_t+"), Some(&theirs.slip), "{}", law.info.id);
        let Motion { vx, vy, omega } = theirs.after;
        // the law's own frame has y into the plane, and turns the other way
        for (symbol, after) in [("v_x", vx), ("v_y", -vy), ("omega", -omega)] {
            assert_eq!(ours.get(symbol), Some(&after), "{} {symbol}", law.info.id);
        }
    }

    #[test]
    fn the_wide_lane_is_what_colliding_floats_gives() {
        for id in ["wang-su-li", "smith-1991", "walton"] {
            agrees(law(id).expect("it is known"));
        }
    }
}
