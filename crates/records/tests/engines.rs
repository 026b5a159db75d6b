//! Small parts of recorded logs of public engines: what is known of them is found. One row in
//! eleven of the recordings (2026-11), see `tests/data/README.md`.

#![allow(clippy::float_arithmetic, reason = "logs are made of floats")]

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
    let study = studied(include_str!("data/pymunk-7.3.1_default.csv"));
    assert!(study.as_expected(), "{:?}", study.checks);
    assert_eq!(friction(&study), FrictionLaw::Coulomb);
    assert_eq!(study.restitution.as_ref().map(|found| found.law), Some(NormalLaw::Stated));
    assert!(study.consistent_laws().any(|fit| fit.law.info.id == "kane-levinson"));
}

#[test]
fn rapier_0_34_is_coulombs_and_rapier_0_36_is_bounded_by_the_compression() {
    let old = studied(include_str!("data/rapier2d-0.34.0_tight.csv"));
    assert!(old.as_expected(), "{:?}", old.checks);
    assert_eq!(friction(&old), FrictionLaw::Coulomb);
    let new = studied(include_str!("data/rapier2d-0.36.1_tight.csv"));
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
    let study = studied(include_str!("data/box2d-2.3.10_v2x_above_threshold.csv"));
    assert_eq!(study.precision.told.format.name(), "binary32");
    assert_eq!(friction(&study), FrictionLaw::Coulomb);
    assert_eq!(study.restitution.as_ref().map(|found| found.law), Some(NormalLaw::Stated));
    assert!(failed(&study, Check::Moment) > 0);
    assert_eq!(failed(&study, Check::Sticks), 0);
}

#[test]
fn mujoco_has_its_own_restitution_and_roughly_coulombs_friction() {
    let study = studied(include_str!("data/mujoco-4.0.0_default.csv"));
    let found = study.restitution.as_ref().expect("it approaches");
    assert_eq!(found.law, NormalLaw::Depends);
    assert!(found.observed[2] > 1.5 && failed(&study, Check::Energy) == 0);
    assert_eq!(friction(&study), FrictionLaw::Coulomb);
    assert!(study.friction[0].rough * 10 >= study.friction[0].rows * 9);
}

/// The recording with another value in some columns.
fn changed(log: &str, change: impl Fn(&mut Vec<f64>)) -> String {
    let (head, rows) = log.split_once('\n').expect("it has a header");
    let mut text = format!("{head}\n");
    for row in rows.lines() {
        let mut cells: Vec<f64> =
            row.split(',').map(|cell| cell.parse().expect("a float")).collect();
        change(&mut cells);
        let cells: Vec<String> = cells.iter().map(f64::to_string).collect();
        text.push_str(&format!("{}\n", cells.join(",")));
    }
    text
}

#[test]
fn a_fault_planted_into_any_recording_makes_it_worse() {
    // dt, phase, mass, radius, inertia, mu, e, then v_x, v_y and omega before and after
    let turn = |row: &mut Vec<f64>| {
        let p = row[10] - row[7];
        row[10] = row[7] - p;
        row[12] = -row[12];
    };
    let arm = |row: &mut Vec<f64>| row[3] *= 1.01;
    let e = |row: &mut Vec<f64>| row[6] = (row[6] - 0.01).abs();
    let cap = |row: &mut Vec<f64>| {
        let (p, n) = (row[10] - row[7], row[11] - row[8]);
        let capped = p.clamp(-row[5] * n / 2.0, row[5] * n / 2.0);
        row[12] -= (p - capped) / row[4];
        row[10] = row[7] + capped;
    };
    for log in [
        include_str!("data/pymunk-7.3.1_default.csv"),
        include_str!("data/rapier2d-0.34.0_tight.csv"),
        include_str!("data/rapier2d-0.36.1_tight.csv"),
        include_str!("data/box2d-2.3.10_v2x_above_threshold.csv"),
        include_str!("data/mujoco-4.0.0_default.csv"),
        include_str!("data/rapier2d-0.36.1_default.csv"),
    ] {
        let clean = studied(log);
        let name = log.lines().nth(1).unwrap_or_default();
        let worse =
            |text: &str| kane_records::comparison::compare(&clean, &studied(text)).is_worse();
        // where a recording misses a check by more than the fault does, it fails with the fault as without
        let fails = |text: &str, check| {
            failed(&clean, check) * 2 > clean.rows && failed(&studied(text), check) * 2 > clean.rows
        };
        assert!(worse(&changed(log, turn)), "sign of friction: {name}");
        let (arm, e) = (changed(log, arm), changed(log, e));
        assert!(worse(&arm) || fails(&arm, Check::Moment), "arm: {name}");
        assert!(worse(&e) || fails(&e, Check::Restitution), "e: {name}");
        // the one that is bounded by the compression is bounded by less only at small e
        assert!(worse(&changed(log, cap)), "half the cone: {name}");
        let mut rows: Vec<&str> = log.lines().collect();
        let (a, b) = (rows[20].to_owned(), rows[60].to_owned());
        let split = |row: &str| {
            let place = row.match_indices(',').nth(9).map_or(0, |(place, _)| place);
            (row[..place].to_owned(), row[place..].to_owned())
        };
        let ((before, after), (other, its)) = (split(&a), split(&b));
        let (first, second) = (format!("{before}{its}"), format!("{other}{after}"));
        (rows[20], rows[60]) = (&first, &second);
        assert!(worse(&rows.join("\n")), "two answers exchanged: {name}");
        // the recordings have no time: with one, a row that stands before an earlier one is found
        let timed = log.lines().enumerate().map(|(line, row)| match line {
            0 => format!("{row},time"),
            _ => format!("{row},{line}"),
        });
        let mut rows: Vec<String> = timed.collect();
        assert_eq!(failed(&studied(&rows.join("\n")), Check::Order), 0, "{name}");
        rows.swap(20, 60);
        assert!(worse(&rows.join("\n")), "two rows exchanged: {name}");
        assert!(failed(&studied(&rows.join("\n")), Check::Order) > 0, "{name}");
    }
}
