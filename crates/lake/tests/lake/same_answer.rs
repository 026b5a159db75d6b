//! The answer is that of `kane check`, from every form of file and however the log is cut.

use std::fs::File;
use std::io::BufReader;

use datafusion::arrow::ipc::writer::FileWriter;
use kane_lake::{Numbers, Reading, check, open};
use kane_records::format::Format;
use kane_records::reader::Kind;
use kane_records::study::{Options, Study, study};
use kane_records::told::Told;
use kane_report::records::{RecordsReport, headline, json};

use crate::{LOGS, opened, parquet, recorded, session};

/// What the program reads row by row.
fn read(name: &str) -> Study {
    let file = BufReader::new(File::open(recorded(name)).expect("it is there"));
    study(file, Kind::Csv, &Options::new(kane_impact::laws())).expect("it is a log")
}

/// The headline without the line that a query does not know.
fn sentence(study: &Study) -> String {
    let text = headline(study);
    match (text.find(" (line "), text.find(')')) {
        (Some(from), Some(to)) if from < to => format!("{}{}", &text[..from], &text[to + 1..]),
        _ => text,
    }
}

/// The counts, the residuals and the sums of energy, bit by bit; laws by their counts.
fn found(study: &Study) -> Vec<String> {
    let mut found = vec![
        format!("{} rows, {:?}", study.rows, study.precision),
        format!("{} rejected, {} sampled", study.rejections.total(), study.sampled),
        format!("{:?}", study.energy),
    ];
    for checked in &study.checks {
        // of rows that hold by equal shares of their tolerances any may be the worst
        let worst = checked.worst.filter(|(_, finding)| finding.holds() == Some(false));
        let worst = worst.map(|(_, finding)| finding.residual);
        found.push(format!(
            "{:?} {} {} {} {worst:?}",
            checked.check, checked.rows, checked.failed, checked.near
        ));
    }
    for fit in &study.friction {
        found.push(format!("{} {} {} {}", fit.law.id(), fit.consistent, fit.close, fit.rough));
    }
    // what is fitted is fitted on some of the rows, which are others in another order
    let mut laws: Vec<String> = study
        .laws
        .iter()
        .filter(|fit| fit.law.info.parameters.is_empty())
        .map(|fit| format!("{} {} of {}", fit.law.info.id, fit.consistent, fit.rows))
        .collect();
    laws.sort();
    found.extend(laws);
    found.extend(study.fits.iter().map(|fit| format!("{fit:?}")));
    found
}

#[tokio::test]
async fn a_csv_log_has_the_answer_of_kane_check() {
    for name in LOGS {
        let (session, log) = opened(&recorded(name), 2).await;
        let queried = check(&session, &log).await.expect("it has rows");
        let read = read(name);
        assert_eq!(found(&queried), found(&read), "{name}");
        assert_eq!(sentence(&queried), sentence(&read), "{name}");
        let sizes = |study: &Study| -> Vec<u64> {
            study.worst.iter().map(|worst| worst.finding.size().to_bits()).collect()
        };
        assert_eq!(sizes(&queried), sizes(&read), "{name}");
    }
}

#[tokio::test]
async fn parquet_and_arrow_files_have_the_answer_of_their_csv() {
    let name = "rapier2d-0.36.1_tight";
    let read = read(name);
    let dir = tempfile::tempdir().expect("there is room");
    let (session, _) = opened(&recorded(name), 3).await;
    parquet(&session, "SELECT * FROM log", dir.path()).await;
    let (other, log) = opened(dir.path(), 2).await;
    let queried = check(&other, &log).await.expect("it has rows");
    assert_eq!(found(&queried), found(&read));

    let batches = session.sql("SELECT * FROM log").await.expect("a query").collect().await;
    let batches = batches.expect("it has rows");
    let place = dir.path().join("log.arrow");
    let file = File::create(&place).expect("there is room");
    let mut writer = FileWriter::try_new(file, &batches[0].schema()).expect("it is a schema");
    batches.iter().for_each(|batch| writer.write(batch).expect("it is written"));
    writer.finish().expect("it is written");
    let (third, log) = opened(&place, 2).await;
    let queried = check(&third, &log).await.expect("it has rows");
    assert_eq!(found(&queried), found(&read));
}

#[tokio::test]
async fn the_report_is_the_same_bytes_however_the_log_is_cut() {
    let name = "box2d-2.3.10_v2x_above_threshold";
    let mut reports = Vec::new();
    for (parts, files) in [(1, 1), (2, 4), (8, 3)] {
        let dir = tempfile::tempdir().expect("there is room");
        let (writing, _) = opened(&recorded(name), 1).await;
        for file in 0..files {
            // rows that differ in phase go to files of their own, and each other way round
            let order = if file % 2 == 0 { "ASC" } else { "DESC" };
            let query = format!(
                "SELECT * FROM log WHERE CAST(phase * 100 AS INT) % {files} = {file} ORDER BY vx_post {order}"
            );
            parquet(&writing, &query, &dir.path().join(format!("{file}.parquet"))).await;
        }
        let session = session(parts);
        let numbers = Some(Numbers::new(Told::stated(Format::Binary32)));
        let reading = Reading { numbers, ..Reading::default() };
        let log = open(&session, &[dir.path().to_owned()], reading).await.expect("it is a log");
        let study = check(&session, &log).await.expect("it has rows");
        let report = RecordsReport { study: &study, log: "log", command: "" };
        reports.push(json(&report));
    }
    assert_eq!(reports[0], reports[1]);
    assert_eq!(reports[0], reports[2]);
}

#[tokio::test]
async fn a_sample_of_a_long_log_does_not_depend_on_its_parts() {
    // 40 000 rows that differ, of which 10 000 are sampled
    let dir = tempfile::tempdir().expect("there is room");
    let rows = "SELECT 1.0 AS mass, 0.4 AS inertia, 1.0 AS radius, 0.25 AS mu, 0.5 AS e, \
         2.0 + value / 1000.0 AS vx_pre, -1.0 AS vy_pre, 0.0 AS omega_pre, \
         1.625 + value / 1000.0 AS vx_post, 0.5 AS vy_post, -0.9375 AS omega_post \
         FROM generate_series(1, 40000)";
    parquet(&session(1), rows, &dir.path().join("a.parquet")).await;
    let mut reports = Vec::new();
    for parts in [1, 5] {
        let (session, log) = opened(dir.path(), parts).await;
        let study = check(&session, &log).await.expect("it has rows");
        assert_eq!((study.rows, study.sampled), (40_000, 10_000));
        reports.push(json(&RecordsReport { study: &study, log: "log", command: "" }));
    }
    assert_eq!(reports[0], reports[1]);
}
