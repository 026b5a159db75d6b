//! The derivation behind the code, a scene and a log, as tests.

use kane::testing::{Tested, document, log, scene};

#[test]
fn the_derivation_of_the_loss_holds() -> Tested {
    document("derivation.md")
}

#[test]
fn the_bounce_has_an_answer_that_is_good_enough() -> Tested {
    scene("bounce.toml")
}

#[test]
fn the_log_of_the_last_release_keeps_every_check() -> Tested {
    log("impacts.csv")
}

/// What fails says why, and where: the test above would print this.
#[test]
fn a_broken_derivation_is_told_with_its_line_and_a_witness() {
    let told = document("broken.md").expect_err("its claim is false").to_string();
    assert!(told.contains("broken.md:6: sign is refuted"), "{told}");
    assert!(told.contains("e = "), "{told}");
    assert!(document("empty.md").is_err(), "nothing that is not checked passes");
    assert!(log("derivation.md").is_err() && scene("no-such.toml").is_err());
}

#[test]
fn the_code_computes_the_formula() {
    assert_eq!(as_a_test::loss(2.0, 3.0, 0.5).to_bits(), 6.75_f64.to_bits());
}
