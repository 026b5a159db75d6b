//! Faults planted into recorded logs of public engines: each changes what is found, against the recording without it.
//! One row in eleven of the recordings (2026-11), see `tests/data/README.md`.

use kane_impact::laws;
use kane_records::check::Check;
use kane_records::comparison::{Comparison, compare};
use kane_records::reader::Kind;
use kane_records::study::{Options, Study, study};

/// The recordings, each with its name.
const RECORDINGS: [(&str, &str); 6] = [
    ("pymunk", include_str!("../data/pymunk-7.3.1_default.csv")),
    ("rapier 0.34.0 tight", include_str!("../data/rapier2d-0.34.0_tight.csv")),
    ("rapier 0.36.1 tight", include_str!("../data/rapier2d-0.36.1_tight.csv")),
    ("box2d", include_str!("../data/box2d-2.3.10_v2x_above_threshold.csv")),
    ("mujoco", include_str!("../data/mujoco-4.0.0_default.csv")),
    ("rapier 0.36.1 default", include_str!("../data/rapier2d-0.36.1_default.csv")),
];

// dt, phase, mass, radius, inertia, mu, e, then v_x, v_y and omega before and after
const RADIUS: usize = 3;
const INERTIA: usize = 4;
const MU: usize = 5;
const E: usize = 6;
const BEFORE: [usize; 2] = [7, 8];
const AFTER: [usize; 3] = [10, 11, 12];

/// Plants a fault into a row.
type Fault = fn(&mut Vec<f64>);

const FAULTS: [(&str, Fault); 6] = [
    ("sign of friction", |row| rub(row, |p, _| -p)),
    ("arm longer by 1 %", |row| row[RADIUS] *= 1.01),
    ("arm shorter by 1 %", |row| row[RADIUS] *= 0.99),
    ("e higher by 0.01", |row| row[E] += 0.01),
    ("e off by 0.01", |row| row[E] = (row[E] - 0.01).abs()),
    ("half the cone", |row| rub(row, |p, bound| p.clamp(-bound / 2.0, bound / 2.0))),
];

/// Puts another friction in place of p_t, by p_t and μ·p_n; with its moment, for a mass of 1 and a radius of 1.
fn rub(row: &mut [f64], friction: impl Fn(f64, f64) -> f64) {
    let [p, push] = [0, 1].map(|k| row[AFTER[k]] - row[BEFORE[k]]);
    let more = friction(p, row[MU] * push) - p;
    row[AFTER[0]] += more;
    row[AFTER[2]] += more / row[INERTIA];
}

fn studied(log: &str) -> Study {
    study(log.as_bytes(), Kind::Csv, &Options::new(laws())).expect("it is a log")
}

fn cells(row: &str) -> Vec<f64> {
    row.split(',').map(|cell| cell.parse().expect("a float")).collect()
}

fn written(head: &str, rows: &[Vec<f64>]) -> String {
    let mut text = format!("{head}\n");
    for row in rows {
        let cells: Vec<String> = row.iter().map(f64::to_string).collect();
        text.push_str(&format!("{}\n", cells.join(",")));
    }
    text
}

/// Whether the comparison tells of the fault.
fn told(comparison: &Comparison) -> bool {
    comparison.is_worse() || comparison.normal_moved() || comparison.arm_moved()
}

#[test]
fn a_fault_planted_into_any_recording_is_told_against_the_recording() {
    let mut untold = Vec::new();
    for (name, log) in RECORDINGS {
        let (head, rows) = log.split_once('\n').expect("it has a header");
        let rows: Vec<Vec<f64>> = rows.lines().map(cells).collect();
        let clean = studied(&written(head, &rows));
        assert!(!told(&compare(&clean, &studied(log))), "{name}: written anew");
        for (what, fault) in FAULTS {
            let mut faulty = rows.clone();
            faulty.iter_mut().for_each(fault);
            if !told(&compare(&clean, &studied(&written(head, &faulty)))) {
                untold.push(format!("{name}: {what}"));
            }
        }
        let mut faulty = rows.clone();
        for place in AFTER {
            (faulty[20][place], faulty[60][place]) = (rows[60][place], rows[20][place]);
        }
        if !compare(&clean, &studied(&written(head, &faulty))).is_worse() {
            untold.push(format!("{name}: two answers exchanged"));
        }
    }
    assert!(untold.is_empty(), "{}", untold.join("\n"));
}

/// The recordings have no time: with one, a row that stands before an earlier one is found.
#[test]
fn rows_that_are_exchanged_are_told_by_their_time() {
    for (name, log) in RECORDINGS {
        let timed = log.lines().enumerate().map(|(line, row)| match line {
            0 => format!("{row},time"),
            _ => format!("{row},{line}"),
        });
        let mut rows: Vec<String> = timed.collect();
        let clean = studied(&rows.join("\n"));
        rows.swap(20, 60);
        let faulty = studied(&rows.join("\n"));
        let failed = |study: &Study| study.checked(Check::Order).map(|checked| checked.failed);
        assert_eq!(failed(&clean), Some(0), "{name}");
        assert!(failed(&faulty) > Some(0) && compare(&clean, &faulty).is_worse(), "{name}");
    }
}

/// Rapier with its default settings has its impulse at an arm that is longer by 0.6 % than the stated one: one that is
/// stated 1 % longer is nearer to it. This is no regression, and is told as a change.
#[test]
fn a_fault_that_makes_up_for_another_is_told_and_no_regression() {
    let (_, log) = RECORDINGS[5];
    let (head, rows) = log.split_once('\n').expect("it has a header");
    let mut rows: Vec<Vec<f64>> = rows.lines().map(cells).collect();
    let clean = studied(log);
    rows.iter_mut().for_each(|row| row[RADIUS] *= 1.01);
    let found = compare(&clean, &studied(&written(head, &rows)));
    assert!(found.arm_moved() && !found.is_worse(), "{found:?}");
    let [Some(before), Some(now)] = found.arm else { panic!("{:?}", found.arm) };
    assert!((-0.007..-0.005).contains(&before) && (0.003..0.005).contains(&now), "{found:?}");
}
