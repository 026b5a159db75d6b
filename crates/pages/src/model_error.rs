//! How far rigid laws and simpler processes are from the elastic half-space, over α.

use std::fmt::Write as _;

use kane::impact::compliant::{
    Bilinear, Compliance, DimensionReduction, HertzMindlin, MawBarberFawcett, Memory, Process,
};
use kane::impact::{Alpha, law};

use crate::NotMade;

/// The distinct ones on a sphere that are in use.
const LAWS: [&str; 5] = ["wang-su-li", "keller-1986", "smith-1991", "walton", "garwin-capped"];

/// Four decimals without the sign of zero.
fn shown(x: f64) -> String {
    let text = format!("{x:.4}");
    if text == "-0.0000" { "0.0000".into() } else { text }
}

/// The table: a solid sphere with ν = 0.3 and e = 1, α in twentieths of a decade.
///
/// # Errors
/// [`NotMade`] if a process does not come to an end within its budget.
pub fn model_error() -> Result<String, NotMade> {
    let no_k = |why: &dyn std::fmt::Display| NotMade::because("model-error.csv", why);
    let sphere = Compliance::of_poisson(3.5, 0.3, 1.0).map_err(|error| no_k(&error))?;
    let maw = MawBarberFawcett::new(sphere);
    let others: [Box<dyn Process>; 4] = [
        Box::new(DimensionReduction::new(sphere)),
        Box::new(Bilinear::new(sphere)),
        Box::new(HertzMindlin::new(sphere)),
        Box::new(HertzMindlin::new(sphere).remembering(Memory::Displacement)),
    ];
    let mut rows = String::from(
        "# k by the elastic half-space (Maw, Barber and Fawcett by annuli, with its estimated error), and by how much k of others exceeds it; solid sphere, nu = 0.3, e = 1\nalpha,k,error",
    );
    for name in others.iter().map(|process| process.id()).chain(LAWS) {
        let _ = write!(rows, ",{name}");
    }
    rows.push('\n');
    for step in -20..=40 {
        let alpha = 10_f64.powf(f64::from(step) / 20.0);
        let reference = maw.outcome(&Alpha::Finite(alpha)).map_err(|error| no_k(&error))?;
        let k = reference.ratios.k;
        let _ = write!(rows, "{alpha:.5},{},{}", shown(k), shown(reference.error));
        for process in &others {
            let other = process.outcome(&Alpha::Finite(alpha)).map_err(|error| no_k(&error))?;
            let _ = write!(rows, ",{}", shown(other.ratios.k - k));
        }
        for law in LAWS.into_iter().filter_map(law) {
            let ratios = law.over().ratios(&Alpha::Finite(alpha));
            let ratios = ratios.ok_or_else(|| no_k(&format_args!("{} has none", law.info.id)))?;
            let _ = write!(rows, ",{}", shown(ratios.k - k));
        }
        rows.push('\n');
    }
    Ok(rows)
}
