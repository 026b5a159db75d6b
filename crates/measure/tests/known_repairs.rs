//! Repairs beside known ones: FPBench's and Herbie's cores with the forms that are published for them.

use kane_floats::rigor::{Budget, Inputs};
use kane_floats::{Core, Effort, fpcore};
use kane_measure::certify::{Certified, Work, account};

/// Inputs are searched, and bounds are not what is asked.
const WORK: Work = Work {
    budget: Budget { cells: 40, ratio: 2.0 },
    effort: Effort { drawn: 600, climbs: 4, rounds: 20 },
    repairs: 3,
    inputs: Inputs::Floats,
};

fn bits(ulps: f64) -> f64 {
    (1.0 + ulps).log2()
}

/// Bits lost at the worst input found.
fn lost(found: &Certified) -> f64 {
    found.worst_in_ulps.as_ref().map_or(0.0, |worst| bits(worst.error))
}

/// The table of docs/floats.md, with `-- --nocapture`. A repair is as good as the known one if it loses at most one bit more, at the worst input that the search finds for
/// each; every repair that is shown is proved equal.
#[test]
#[ignore = "takes minutes"]
fn repairs_are_as_good_as_the_known_ones_on_four_of_five() {
    let text = include_str!("../../../docs/examples/herbie.fpcore");
    let cores = fpcore::read("herbie.fpcore", text).expect("it is well formed");
    let name = |core: &Core| core.name.clone().unwrap_or_default();
    let (mut pairs, mut worse) = (0, Vec::new());
    for pair in cores.chunks(2) {
        let [given, known] = pair else { panic!("a core without a known repair") };
        assert_eq!(name(known), format!("{}, known", name(given)));
        let measured = |core: &Core, repairs: usize| {
            let found = account(&name(core), core, Work { repairs, ..WORK });
            found.formats.into_iter().next().expect("a format").expect("there are floats")
        };
        let (found, reference) = (measured(given, 3), lost(&measured(known, 0)));
        let repaired = found.repairs.iter().filter_map(|repair| {
            Some((bits(repair.worst_in_ulps.as_ref()?.error), repair.core.text()))
        });
        let as_given = (lost(&found), "as given".to_owned());
        let (best, form) =
            repaired.fold(as_given, |best, next| if next.0 < best.0 { next } else { best });
        pairs += 1;
        println!(
            "| {} | {:.1} | {reference:.1} | {best:.1} | `{form}` |",
            name(given),
            lost(&found)
        );
        if best > reference + 1.0 {
            worse.push(format!("{}: {best:.1} bits, known {reference:.1}", name(given)));
        }
    }
    assert!(
        pairs >= 15 && worse.len() * 5 <= pairs,
        "{} of {pairs} are worse: {worse:#?}",
        worse.len()
    );
}
