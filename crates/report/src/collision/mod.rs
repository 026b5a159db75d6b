//! One collision under the laws: a sheet, and its data.

mod json;
mod sheet;

#[cfg(feature = "schema")]
pub(crate) use json::schema;
pub use json::{COLLISION_SCHEMA_NAME, COLLISION_SCHEMA_VERSION, json};
pub use sheet::sheet;

use kane_scene::collide::{Collision, Energy, Given};

/// The counts as a sentence.
fn headline(collision: &Collision) -> String {
    let (all, some) = (collision.laws.len(), collision.outcomes().count());
    let created = collision.creators().len();
    let mut line = match (collision.in_depth, all) {
        (true, _) => return verdict(collision),
        (_, 1) => "1 law".to_owned(),
        _ => format!("{all} laws"),
    };
    if some < all {
        line.push_str(&format!(", {some} with an outcome"));
    }
    match created {
        0 => line.push_str("; none creates energy"),
        1 => line.push_str("; 1 creates energy"),
        _ => line.push_str(&format!("; {created} create energy")),
    }
    line
}

/// The news of one law in depth.
fn verdict(collision: &Collision) -> String {
    let Some((law, answer)) = collision.outcomes().next() else {
        let law = collision.laws.first().map_or("", |law| law.id);
        return format!("{law}: no outcome");
    };
    let (all, good) =
        (answer.checks.len(), answer.checks.iter().filter(|check| check.holds).count());
    let energy = match answer.energy {
        Energy::Lost => "energy is lost",
        Energy::Kept => "energy is kept",
        Energy::Created => "energy is CREATED",
    };
    format!("{}: {}; {energy}; {good} of {all} exact checks hold", law.id, answer.regime)
}

/// `mu = 0.092`, `mass = 1 kg (assumed)`.
fn in_words(given: &Given) -> String {
    let space = if given.unit.is_empty() || given.unit == "°" { "" } else { " " };
    let assumed = if given.assumed { " (default)" } else { "" };
    format!("{} = {}{space}{}{assumed}", given.symbol, given.value, given.unit)
}

/// A float with four digits, for a table.
fn brief(float: f64) -> String {
    let rounded = format!("{float:.3e}");
    let Some((mantissa, power)) = rounded.split_once('e') else { return rounded };
    let digits = mantissa.trim_end_matches('0').trim_end_matches('.');
    match power.parse::<i32>() {
        Ok(0) if digits == "0" || digits == "-0" => "0".to_owned(),
        Ok(power @ -3..=3) => {
            let places = usize::try_from(3 - power).unwrap_or(0);
            format!("{float:.places$}")
        }
        _ => format!("{digits}e{power}"),
    }
}

/// A float with all digits that identify it.
fn full(float: f64) -> String {
    if float == 0.0 {
        return "0".to_owned();
    }
    let text = format!("{float:?}");
    text.strip_suffix(".0").map_or_else(|| text.clone(), str::to_owned)
}

/// An error in ulps.
fn ulps(error: f64) -> String {
    let size = error.abs();
    if size == 0.0 {
        "0".to_owned()
    } else if size < 0.005 {
        "<0.01".to_owned()
    } else if size < 10_000.0 {
        format!("{error:+.2}")
    } else {
        format!("{error:+.1e}")
    }
}

#[cfg(test)]
mod tests {
    use kane_scene::collide::{Answer, Check, LawAnswer};

    use super::*;

    #[test]
    fn few_digits_and_no_noise() {
        for (float, shown) in [
            (0.0, "0"),
            (-0.0, "0"),
            (1.0, "1.000"),
            (-0.312_504, "-0.3125"),
            (0.000_123_456, "1.235e-4"),
            (12_345.6, "1.235e4"),
            (1e300, "1e300"),
        ] {
            assert_eq!(brief(float), shown);
        }
    }

    #[test]
    fn all_digits_are_those_that_identify_the_float() {
        assert_eq!(full(0.1), "0.1");
        assert_eq!(full(2.0), "2");
        assert_eq!(full(-0.0), "0");
        assert_eq!(full(-1e300), "-1e300");
    }

    #[test]
    fn one_check_that_fails_is_not_as_expected_and_says_so() {
        let check = |holds| Check { claim: "momentum".to_owned(), holds };
        let answer = Answer {
            regime: "slide",
            energy: Energy::Lost,
            readings: Vec::new(),
            checks: vec![check(true), check(false)],
            remarks: Vec::new(),
        };
        let law = LawAnswer {
            id: "some-law",
            statement: "i_x = 1",
            source: "nobody",
            restitution: "Newton",
            parameters: Vec::new(),
            answer: Ok(answer),
        };
        let collision = Collision {
            title: "A test".to_owned(),
            given: Vec::new(),
            notes: Vec::new(),
            before: Vec::new(),
            laws: vec![law],
            plane: None,
            in_depth: true,
            command: "kane".to_owned(),
        };
        assert!(!collision.as_expected());
        let sheet = sheet(&collision);
        assert!(sheet.text(crate::Page::default()).contains("DOES NOT HOLD  momentum"));
        assert!(sheet.markdown().contains("1 of 2 exact checks hold"));
        assert!(json(&collision).contains("\"as_expected\": false"));
    }

    #[test]
    fn small_and_great_errors_stay_short() {
        for (error, shown) in [(0.0, "0"), (-0.001, "<0.01"), (0.5, "+0.50"), (2e9, "+2.0e9")] {
            assert_eq!(ulps(error), shown);
        }
    }
}
