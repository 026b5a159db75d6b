//! Small parts of recorded logs of public engines: what is known of them is found. One row in
//! eleven of the recordings (2026-11), see `tests/data/README.md`.

use kane_impact::laws;
use kane_records::check::Check;
use kane_records::friction::FrictionLaw;
use kane_records::reader::Kind;
use kane_records::restitution::NormalLaw;
use kane_records::study::{Options, Study, study};

fn studied(log: &str) -> Study {
    study(log.as_bytes(), Kind::Csv, &Options::new(laws())).expect("it is a log")
}

fn friction(study: &Study) -> FrictionLaw {
    study.friction.first().expect("friction is asked").law
}

fn failed(study: &Study, check: Check) -> u64 {
    study.checked(check).map_or(0, |checked| checked.failed)
}

#[test]
fn pymunk_keeps_every_check_and_is_coulombs() {
    let study = studied(include_str!("../data/pymunk-7.3.1_default.csv"));
    assert!(study.as_expected(), "{:?}", study.checks);
    assert_eq!(friction(&study), FrictionLaw::Coulomb);
    assert_eq!(study.restitution.as_ref().map(|found| found.law), Some(NormalLaw::Stated));
    assert!(study.consistent_laws().any(|fit| fit.law.info.id == "kane-levinson"));
}

#[test]
fn rapier_0_34_is_coulombs_and_rapier_0_36_is_bounded_by_the_compression() {
    let old = studied(include_str!("../data/rapier2d-0.34.0_tight.csv"));
    assert!(old.as_expected(), "{:?}", old.checks);
    assert_eq!(friction(&old), FrictionLaw::Coulomb);
    let new = studied(include_str!("../data/rapier2d-0.36.1_tight.csv"));
    assert_eq!(friction(&new), FrictionLaw::Compression);
    assert_eq!(new.friction[0].consistent, new.friction[0].rows);
    assert_eq!(new.restitution.as_ref().map(|found| found.law), Some(NormalLaw::Stated));
    // two rows in five slide below the cone, and nothing else fails
    assert!(failed(&new, Check::Sticks) * 10 > 3 * new.rows);
    for check in Check::ALL.into_iter().filter(|check| *check != Check::Sticks) {
        assert_eq!(failed(&new, check), 0, "{check:?}");
    }
    assert!(kane_records::comparison::compare(&old, &new).is_worse());
    assert!(!kane_records::comparison::compare(&old, &old).is_worse());
}

#[test]
fn box2d_is_coulombs_about_a_contact_point_within_its_margin() {
    let study = studied(include_str!("../data/box2d-2.3.10_v2x_above_threshold.csv"));
    assert_eq!(study.precision.told.format.name(), "binary32");
    assert_eq!(friction(&study), FrictionLaw::Coulomb);
    assert_eq!(study.restitution.as_ref().map(|found| found.law), Some(NormalLaw::Stated));
    assert!(failed(&study, Check::Moment) > 0);
    assert_eq!(failed(&study, Check::Sticks), 0);
}

#[test]
fn mujoco_has_its_own_restitution_and_roughly_coulombs_friction() {
    let study = studied(include_str!("../data/mujoco-4.0.0_default.csv"));
    let found = study.restitution.as_ref().expect("it approaches");
    assert_eq!(found.law, NormalLaw::Depends);
    assert!(found.observed[2] > 1.5 && failed(&study, Check::Energy) == 0);
    assert_eq!(friction(&study), FrictionLaw::Coulomb);
    assert!(study.friction[0].rough * 10 >= study.friction[0].rows * 9);
}
