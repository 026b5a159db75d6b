//! k(α) of a sphere as tabulated for this project from the laws' closed forms.

use kane::impact::laws::{ChatterjeeRuina, Walton};
use kane::impact::{Alpha, Law, laws};
use kane::number::{Algebraic, Number, Rational};

use super::{exact, k_by_id, ratios, rounds_to};

/// The laws of each column: those that are the same law on a sphere share one.
const COLUMNS: [&[&str]; 8] = [
    &["wang-su-li"],
    &["whittaker-uncapped"],
    &["smith-printed"],
    &["keller-printed"],
    &[
        "keller-1986",
        "routh-newton",
        "stronge-1990",
        "djerassi-newton",
        "djerassi-poisson",
        "djerassi-stronge",
        "kane-levinson",
        "whittaker-stop",
        "chatterjee-ruina",
    ],
    &["smith-1991"],
    &["walton"],
    &["garwin-capped"],
];

/// α, and k by each column.
const TABLE: [(&str, [&str; 8]); 13] = [
    ("0.1", ["0.8182", "0.80", "0.92", "0.8667", "0.80", "0.8000", "0.80", "0.80"]),
    ("0.25", ["0.6000", "0.50", "0.80", "0.6667", "0.50", "0.5000", "0.50", "0.50"]),
    ("0.4", ["0.4286", "0.20", "0.68", "0.4667", "0.20", "0.2000", "0.20", "0.20"]),
    ("0.5", ["0.3333", "0", "0.60", "0.3333", "0", "0", "0", "0"]),
    ("0.6", ["0.2500", "-0.2", "0.52", "0.2000", "0", "-0.1483", "-0.2", "-0.2"]),
    ("0.75", ["0.1429", "-0.5", "0.40", "0", "0", "-0.2808", "-0.44", "-0.5"]),
    ("1", ["0", "-1", "0.20", "-0.1667", "0", "-0.4142", "-0.44", "-1"]),
    ("1.5", ["-0.2", "-2", "-0.20", "-0.5", "0", "-0.5616", "-0.44", "-1"]),
    ("2", ["-0.3333", "-3", "-0.60", "-0.8333", "0", "-0.6458", "-0.44", "-1"]),
    ("3", ["-0.5", "-5", "-1.40", "-1.5", "0", "-0.7417", "-0.44", "-1"]),
    ("5", ["-0.6667", "-9", "-3.00", "-2.8333", "0", "-0.8310", "-0.44", "-1"]),
    ("10", ["-0.8182", "-19", "-7.00", "-6.1667", "0", "-0.9087", "-0.44", "-1"]),
    ("100", ["-0.9802", "-199", "-79", "-66.17", "0", "-0.9901", "-0.44", "-1"]),
];

/// Source: computed from the closed forms given by Wang, Su and Li ((16), (22), (24), (26)), by
/// Keller (1986) and Routh, by Smith (1991) as quoted by Chatterjee and Ruina (1998), by Walton
/// (1993) as quoted by Foerster et al. (1994) with β0 = 0.44, and by Garwin (1969) with Coulomb's
/// bound; the table is this project's own reference table, not a table of any of them.
#[test]
fn the_reference_table_is_met_to_its_printed_digits() {
    let mut wrong = Vec::new();
    for (alpha, row) in TABLE {
        for (laws, printed) in COLUMNS.iter().zip(row) {
            for law in *laws {
                let k = k_by_id(law, &exact(alpha)).expect("the law has a value");
                if !rounds_to(k.clone(), printed) {
                    wrong.push(format!("{law} at α = {alpha}: {k}, printed {printed}"));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Source: Garwin (1969), abstract; A. Chatterjee and A. Ruina (1998), whose law is Walton's on a
/// sphere if `e_t` = `β0`; Brach (1984) with `μ_B` = μ, which is Whittaker's where it is admitted.
#[test]
fn the_laws_without_a_column_follow_from_those_with_one() {
    let walton = Walton::default();
    let same = Law::from(ChatterjeeRuina { restitution: walton.restitution.clone() });
    let walton = Law::from(walton);
    for (alpha, _) in TABLE {
        let alpha = exact(alpha);
        assert_eq!(k_by_id("garwin", &alpha), Some((-Rational::one()).into()));
        assert_eq!(ratios(&same, &alpha), ratios(&walton, &alpha));
        if let Some(brach) = k_by_id("brach", &alpha) {
            assert_eq!(Some(brach), k_by_id("whittaker-uncapped", &alpha));
        }
    }
    assert!(
        k_by_id("brach", &Rational::one()).is_some() && k_by_id("brach", &exact("3")).is_none()
    );
}

/// Every law of the catalogue that says k in terms of α has a column or is named in the test above.
#[test]
fn no_law_is_left_out() {
    let missing = laws().iter().filter(|law| {
        let id = law.info.id;
        let listed = COLUMNS.iter().any(|laws| laws.contains(&id));
        let by_alpha = law.over().ratios(&Alpha::Finite(Algebraic::one())).is_some();
        by_alpha && !listed && !["garwin", "brach"].contains(&id)
    });
    let missing: Vec<_> = missing.map(|law| law.info.id).collect();
    assert!(missing.is_empty(), "{missing:?}");
}
