//! A log in memory says what the same log says as a file.

use kane_impact::laws;
use kane_records::reader::{Kind, ReadFault};
use kane_records::study::{Options, Study, study};
use kane_records::table::{Cells, Table, study_table};

const LOG: &str = include_str!("../data/pymunk-7.3.1_default.csv");

/// The cells of a log in CSV, without its comments.
fn cells(log: &str) -> (Vec<&str>, Vec<Vec<&str>>) {
    let mut lines = log.lines().filter(|line| !line.starts_with('#') && !line.is_empty());
    let names: Vec<&str> = lines.next().expect("a header").split(',').collect();
    (names, lines.map(|line| line.split(',').collect()).collect())
}

/// A check: how many rows it was asked of, how many fail, and the worst residual.
type Came = (u64, u64, f64);

fn told(study: &Study) -> (u64, u64, bool, Vec<Came>, Vec<&str>) {
    let checks = study.checks.iter();
    let checks = checks.map(|c| (c.rows, c.failed, c.worst.map_or(0.0, |(_, f)| f.residual)));
    (
        study.rows,
        study.rejections.total(),
        study.as_expected(),
        checks.collect(),
        study.consistent_laws().map(|fit| fit.law.info.id).collect(),
    )
}

#[test]
fn columns_of_numbers_and_of_words_say_what_the_file_says() {
    let options = Options::new(laws());
    let file = study(LOG.as_bytes(), Kind::Csv, &options).expect("it can be checked");
    let (names, rows) = cells(LOG);
    let words: Vec<Vec<Option<String>>> = (0..names.len())
        .map(|at| rows.iter().map(|row| Some(row[at].to_owned())).collect())
        .collect();
    let numbers: Vec<Option<Vec<f64>>> = words
        .iter()
        .map(|column| column.iter().map(|word| word.as_ref()?.parse().ok()).collect())
        .collect();
    let (mut spelled, mut numeric) = (Table::default(), Table::default());
    for ((name, words), numbers) in names.iter().zip(&words).zip(&numbers) {
        spelled.push(name, Cells::Words(words));
        numeric.push(
            name,
            match numbers {
                Some(values) => Cells::Numbers { values, missing: &[] },
                None => Cells::Words(words),
            },
        );
    }
    assert!(numbers.iter().flatten().count() > 8, "most columns are numbers");
    for table in [&spelled, &numeric] {
        let study = study_table(table, &options).expect("it can be checked");
        assert_eq!(told(&study), told(&file));
    }
}

const NAMES: [&str; 11] = [
    "mass",
    "radius",
    "inertia",
    "mu",
    "e",
    "vx_pre",
    "vy_pre",
    "omega_pre",
    "vx_post",
    "vy_post",
    "omega_post",
];
const ROW: [f64; 11] = [1.0, 1.0, 0.4, 0.25, 0.5, 2.0, -1.0, 0.0, 1.625, 0.5, -0.9375];

/// Two rows, the second with another friction.
fn two(mu: f64, missing: &[bool]) -> Result<Study, ReadFault> {
    let columns: Vec<[f64; 2]> = NAMES
        .iter()
        .zip(ROW)
        .map(|(name, value)| [value, if *name == "mu" { mu } else { value }])
        .collect();
    let mut table = Table::default();
    for (name, values) in NAMES.iter().zip(&columns) {
        let missing = if *name == "mu" { missing } else { &[] };
        table.push(name, Cells::Numbers { values, missing });
    }
    study_table(&table, &Options::new(laws()))
}

#[test]
fn a_nan_rejects_its_row_and_a_missing_cell_does_not() {
    let nan = two(f64::NAN, &[]).expect("one row can be checked");
    assert_eq!((nan.rows, nan.rejections.total(), nan.as_expected()), (1, 1, false));
    let missing = two(f64::NAN, &[false, true]).expect("both can be checked");
    assert_eq!((missing.rows, missing.rejections.total()), (2, 0));
}

#[test]
fn columns_of_several_lengths_and_no_rows_are_refused() {
    assert!(matches!(two(0.25, &[true]), Err(ReadFault::Lengths)));
    let mut ragged = Table::default();
    for (at, name) in NAMES.iter().enumerate() {
        let values: &[f64] = if at == 3 { &[0.25, 0.25] } else { &[1.0] };
        ragged.push(name, Cells::Numbers { values, missing: &[] });
    }
    let options = Options::new(laws());
    assert!(matches!(study_table(&ragged, &options), Err(ReadFault::Lengths)));
    let mut empty = Table::default();
    for name in NAMES {
        empty.push(name, Cells::Numbers { values: &[], missing: &[] });
    }
    assert!(matches!(study_table(&empty, &options), Err(ReadFault::Empty)));
    assert!(matches!(study_table(&Table::default(), &options), Err(ReadFault::Header(_))));
}
