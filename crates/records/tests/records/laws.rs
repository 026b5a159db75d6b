//! Logs made by every published law, with floats of either format: the law is named among those
//! that give every row, nothing that mechanics asks is called broken, and a planted fault is found.

use std::fmt::Write as _;

use kane_impact::bodies::{Collision, Motion, PlanarBody};
use kane_impact::{Law, NumberSystem, laws};
use kane_number::{Number, Rational, decode};
use kane_records::check::{Check, Ground};
use kane_records::reader::Kind;
use kane_records::study::{Options, Study, study};

/// An input of the log: body, motion, μ and e, as numbers that either format rounds.
struct Planned {
    inertia: f64,
    arm: [f64; 2],
    motion: [f64; 3],
    mu: f64,
    e: f64,
}

/// Discs and rods, slips of both signs, spins, friction and restitution that vary.
fn planned() -> Vec<Planned> {
    let mut rows = Vec::new();
    for (i, arm) in [[0.0, -0.7], [0.0, -1.3], [-0.3, -0.8], [0.55, -0.6], [-0.9, -0.35]]
        .into_iter()
        .enumerate()
    {
        for slip in [-3.1, -0.71, 0.13, 0.37, 1.9, 6.3] {
            for (mu, e) in [(0.13, 0.37), (0.31, 0.83), (0.57, 0.11), (0.31, 0.59)] {
                let place = f64::from(u32::try_from(rows.len()).expect("few rows"));
                rows.push(Planned {
                    inertia: if i < 2 { 0.41 } else { 0.23 },
                    arm,
                    motion: [slip, -0.9 - 0.01 * place, 0.3 * (place % 3.0 - 1.0)],
                    mu,
                    e,
                });
            }
        }
    }
    rows
}

/// A row of the log as numbers.
type Cells = [f64; 13];
const NAMES: &str = "mass1_kg,inertia1_kg_m2,arm1_x_m,arm1_y_m,mu,e,vx1_pre_m_s,vy1_pre_m_s,omega1_pre_rad_s,vx1_post_m_s,vy1_post_m_s,omega1_post_rad_s,time_s";
const ARM_X: usize = 2;
const ARM_Y: usize = 3;
const MU: usize = 4;
const E: usize = 5;
const VX: usize = 9;
const VY: usize = 10;
const SPIN: usize = 11;

/// What the law makes of a row in a number system; `None` where it has no answer.
fn made<N: NumberSystem>(law: &Law, row: &Planned, to: impl Fn(&N) -> f64) -> Option<Cells> {
    let n = |x: f64| N::from_rational(&decode(x).expect("it is finite"));
    let [vx, vy, omega] = row.motion.map(n);
    let body = PlanarBody {
        mass: n(1.7),
        inertia: n(row.inertia),
        arm: row.arm.map(n),
        before: Motion { vx, vy, omega },
    };
    let collision =
        Collision { body: body.clone(), other: None, friction: n(row.mu), restitution: n(row.e) };
    // in the system itself, as an engine computes, and not in a wider one
    let contact = collision.contact().ok()?;
    let impulse = law.over::<N>().impulse(&contact).ok()?;
    let after = body.after(&impulse);
    let Motion { vx, vy, omega } = &body.before;
    let cells = [
        to(&body.mass),
        to(&body.inertia),
        to(&body.arm[0]),
        to(&body.arm[1]),
        to(&collision.friction),
        to(&collision.restitution),
        to(vx),
        to(vy),
        to(omega),
        to(&after.vx),
        to(&after.vy),
        to(&after.omega),
        0.0,
    ];
    cells.iter().all(|cell| cell.is_finite()).then_some(cells)
}

/// The log of a law: in binary64, or in binary32.
fn log(law: &Law, single: bool) -> Vec<Cells> {
    let make = |row: &Planned| match single {
        true => made::<f32>(law, row, |x| f64::from(*x)),
        false => made::<f64>(law, row, |x| *x),
    };
    let mut rows: Vec<Cells> = planned().iter().filter_map(make).collect();
    for (place, row) in rows.iter_mut().enumerate() {
        row[12] = f64::from(u32::try_from(place).expect("few rows"));
    }
    rows
}

fn written(rows: &[Cells]) -> String {
    let mut text = format!("{NAMES}\n");
    for row in rows {
        let cells: Vec<String> = row.iter().map(f64::to_string).collect();
        let _ = writeln!(text, "{}", cells.join(","));
    }
    text
}

fn studied(rows: &[Cells]) -> Study {
    studied_by(rows, laws())
}

fn studied_by(rows: &[Cells], laws: &[Law]) -> Study {
    study(written(rows).as_bytes(), Kind::Csv, &Options::new(laws)).expect("the log is a log")
}

/// Whether a law creates energy on purpose, so that a clean log of it has an alarm.
fn gains(rows: &[Cells]) -> bool {
    // an independent sum: energies after less before, of the numbers in the log
    rows.iter().any(|r| {
        let energy = |v: [f64; 3]| r[0] * (v[0] * v[0] + v[1] * v[1]) + r[1] * v[2] * v[2];
        let (before, after) = (energy([r[6], r[7], r[8]]), energy([r[VX], r[VY], r[SPIN]]));
        after > before * (1.0 + 1e-5)
    })
}

/// The checks that fail without an excuse.
fn alarms(study: &Study) -> Vec<Check> {
    let failing = study.checks.iter().filter(|checked| !checked.as_expected());
    failing.map(|checked| checked.check).collect()
}

#[test]
fn a_law_is_named_among_those_that_give_its_log() {
    let mut misses = Vec::new();
    assert_eq!(laws().len(), 21);
    for law in laws() {
        for single in [false, true] {
            let rows = log(law, single);
            assert!(rows.len() > 20, "{}: {} rows", law.info.id, rows.len());
            let study = studied(&rows);
            assert_eq!(study.rejections.total(), 0, "{}", law.info.id);
            let own = study.laws.iter().find(|fit| fit.law.info.id == law.info.id);
            let own = own.expect("every law is asked");
            if !own.gives_all() || own.fitted {
                misses.push(format!(
                    "{} {single}: {} of {}, worst {:e} line {}, {}",
                    law.info.id,
                    own.consistent,
                    own.rows,
                    own.worst,
                    own.worst_line,
                    study.precision.told.format.name()
                ));
            }
        }
    }
    assert!(misses.is_empty(), "{}", misses.join("\n"));
}

#[test]
fn laws_that_differ_are_told_apart() {
    for (law, others) in [
        ("wang-su-li", &["kane-levinson", "smith-1991", "walton"][..]),
        ("kane-levinson", &["routh-newton", "keller-1986", "stronge-1990"]),
        ("keller-1986", &["stronge-1990", "routh-newton", "kane-levinson"]),
        ("walton", &["garwin", "smith-1991", "kane-levinson"]),
        ("tilted-2002", &["walton", "kane-levinson", "saitoh"]),
    ] {
        for single in [false, true] {
            let law = kane_impact::law(law).expect("it is known");
            let study = studied(&log(law, single));
            for other in others {
                let fit = study.laws.iter().find(|fit| fit.law.info.id == *other);
                let gives = fit.is_some_and(|fit| fit.gives_all() && !fit.fitted);
                assert!(!gives, "{other} gives the log of {}", law.info.id);
            }
        }
    }
}

#[test]
fn a_clean_log_raises_no_alarm_but_a_gain_of_energy() {
    let mut false_alarms = Vec::new();
    for law in laws() {
        for single in [false, true] {
            let rows = log(law, single);
            let alarms = alarms(&studied(&rows));
            let gains = gains(&rows);
            let allowed = |check: &Check| *check == Check::Energy && gains;
            if !alarms.iter().all(allowed) || alarms.contains(&Check::Energy) != gains {
                false_alarms.push(format!("{} {single}: {alarms:?} gains {gains}", law.info.id));
            }
        }
    }
    assert!(false_alarms.is_empty(), "{}", false_alarms.join("\n"));
}

/// Plants a fault in every row.
type Fault = fn(&mut Cells);

#[test]
fn a_planted_fault_is_found_in_the_log_of_every_law() {
    let faults: [(&str, Fault); 4] = [
        ("sign of friction", |row| {
            // the tangential impulse turned round, with its moment
            let p = row[0] * (row[VX] - row[6]);
            row[VX] -= 2.0 * p / row[0];
            row[SPIN] += 2.0 * p * row[ARM_Y] / row[1];
        }),
        ("arm off by 1 %", |row| {
            row[ARM_X] *= 1.01;
            row[ARM_Y] *= 1.01;
        }),
        ("e off by 0.01", |row| row[E] += 0.01),
        ("friction capped at half the cone", |row| {
            let (p, n) = (row[0] * (row[VX] - row[6]), row[0] * (row[VY] - row[7]));
            let capped = p.clamp(-row[MU] * n / 2.0, row[MU] * n / 2.0);
            row[VX] += (capped - p) / row[0];
            row[SPIN] -= (capped - p) * row[ARM_Y] / row[1];
        }),
    ];
    let (mut unfound, mut unchanged) = (Vec::new(), Vec::new());
    for law in laws() {
        // it alone could excuse its log
        let own = std::slice::from_ref(law);
        for single in [false, true] {
            let clean = log(law, single);
            let before = alarms(&studied_by(&clean, own));
            for (name, fault) in &faults {
                let mut rows = clean.clone();
                rows.iter_mut().for_each(fault);
                let changed = rows.iter().zip(&clean).any(|(a, b)| {
                    a.iter().zip(b).any(|(a, b)| (a - b).abs() > 1e-3 * b.abs().max(1e-3))
                });
                if !changed {
                    unchanged.push(format!("{} {single} {name}", law.info.id));
                    continue;
                }
                let study = studied_by(&rows, own);
                let after = alarms(&study);
                let new = after.iter().any(|check| !before.contains(check));
                if !new {
                    unfound.push(format!("{} {single} {name}: {after:?}", law.info.id));
                }
            }
            let mut rows = clean.clone();
            let (a, b) = (5, rows.len() - 3);
            for place in [VX, VY, SPIN] {
                let kept = rows[a][place];
                rows[a][place] = rows[b][place];
                rows[b][place] = kept;
            }
            let after = alarms(&studied_by(&rows, own));
            if !after
                .iter()
                .any(|check| check.ground() == Ground::Mechanics && !before.contains(check))
            {
                unfound.push(format!("{} {single} answers exchanged: {after:?}", law.info.id));
            }
            rows = clean;
            rows.swap(7, 11);
            if !alarms(&studied_by(&rows, own)).contains(&Check::Order) {
                unfound.push(format!("{} {single} rows exchanged", law.info.id));
            }
        }
    }
    assert!(unfound.is_empty(), "{}", unfound.join("\n"));
    // its friction is below half of the cone everywhere
    let lazy = ["false", "true"].map(|single| format!("smith-printed {single} {}", faults[3].0));
    assert_eq!(unchanged, lazy, "each other fault changes each log");
}

#[test]
fn the_lanes_of_the_test_are_what_they_say() {
    assert_eq!(<f32 as Number>::from_rational(&Rational::new(1.into(), 3.into())), 1.0 / 3.0);
}
