//! How far rigid laws and simpler processes are from the elastic half-space, over α.

use std::fmt::Write as _;

use kane::impact::compliant::{
    Bilinear, Compliance, DimensionReduction, HertzMindlin, MawBarberFawcett, Memory, Process,
};
use kane::impact::{Alpha, law};

use crate::assert_kept;

/// The distinct ones on a sphere that are in use.
const LAWS: [&str; 5] = ["wang-su-li", "keller-1986", "smith-1991", "walton", "garwin-capped"];

/// Four decimals without the sign of zero.
fn shown(x: f64) -> String {
    let text = format!("{x:.4}");
    if text == "-0.0000" { "0.0000".into() } else { text }
}

/// A solid sphere with ν = 0.3 and e = 1, α in twentieths of a decade.
#[test]
fn the_model_error_is_what_the_processes_say() {
    let sphere = Compliance::of_poisson(3.5, 0.3, 1.0).expect("a sphere");
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
    let names = others.iter().map(|process| process.id()).chain(LAWS);
    names.for_each(|name| write!(rows, ",{name}").expect("a string takes all"));
    rows.push('\n');
    let mut greatest = 0.0_f64;
    for step in -20..=40 {
        let alpha = 10_f64.powf(f64::from(step) / 20.0);
        let reference = maw.outcome(&Alpha::Finite(alpha)).expect("it settles");
        let k = reference.ratios.k;
        write!(rows, "{alpha:.5},{},{}", shown(k), shown(reference.error)).expect("a string");
        for process in &others {
            let other = process.outcome(&Alpha::Finite(alpha)).expect("it ends").ratios.k;
            write!(rows, ",{}", shown(other - k)).expect("a string takes all");
            if process.id() == "hertz-mindlin" {
                greatest = greatest.max(other - k);
            }
        }
        for law in LAWS.into_iter().filter_map(law) {
            let ratios = law.over().ratios(&Alpha::Finite(alpha)).expect("total on a sphere");
            write!(rows, ",{}", shown(ratios.k - k)).expect("a string");
        }
        rows.push('\n');
    }
    // the shortcut's error near normal collision was stated as up to 0.7
    assert!((0.6..0.75).contains(&greatest), "{greatest}");
    assert_kept("docs/data/model-error.csv", &rows, "model_error");
}
