//! What is no log is an error that says why, and what is no row is counted.

use std::fs;
use std::path::{Path, PathBuf};

use kane_lake::{Reading, check, open};

use crate::{opened, parquet, recorded, session};

const LOG: &str = "pymunk-7.3.1_default";

/// Why the files cannot be opened.
async fn fault(files: &[PathBuf]) -> String {
    open(&session(1), files, Reading::default()).await.expect_err("it is no log").to_string()
}

fn file(dir: &Path, name: &str, text: &[u8]) -> PathBuf {
    let place = dir.join(name);
    fs::write(&place, text).expect("there is room");
    place
}

#[tokio::test]
async fn a_parquet_file_that_was_cut_off_is_named() {
    let dir = tempfile::tempdir().expect("there is room");
    let (writing, _) = opened(&recorded(LOG), 1).await;
    let whole = dir.path().join("whole.parquet");
    parquet(&writing, "SELECT * FROM log", &whole).await;
    let bytes = fs::read(&whole).expect("it was written");
    for (end, why) in [
        (0, "too short"),
        (7, "too short"),
        (bytes.len() / 2, "its end is missing"),
        (bytes.len() - 1, "its end is missing"),
    ] {
        let cut = file(dir.path(), "cut.parquet", &bytes[..end]);
        let told = fault(&[whole.clone(), cut]).await;
        assert!(told.contains("cut.parquet") && told.contains(why), "{told}");
    }
    let other = file(dir.path(), "cut.parquet", &[b"PAR2".as_slice(), &bytes[4..]].concat());
    assert!(fault(&[other]).await.contains("does not begin as one"));
    for claimed in [u32::MAX, u32::try_from(bytes.len()).expect("it is short")] {
        let end = [&bytes[..bytes.len() - 8], &claimed.to_le_bytes(), b"PAR1"].concat();
        let longer = file(dir.path(), "longer.parquet", &end);
        assert!(fault(&[longer]).await.contains("longer than the file"));
    }
    // whole at both ends, and damaged between: the query engine says so
    let mut damaged = bytes.clone();
    let end = bytes.len();
    damaged[end - 60..end - 12].fill(0xff);
    let damaged = file(dir.path(), "damaged.parquet", &damaged);
    assert!(!fault(&[damaged]).await.is_empty());
}

#[tokio::test]
async fn files_that_are_no_log_are_refused() {
    let dir = tempfile::tempdir().expect("there is room");
    let csv = recorded(LOG);
    let missing = fault(&[dir.path().join("nothing.csv")]).await;
    assert!(missing.contains("cannot read") && missing.contains("nothing.csv"), "{missing}");
    assert!(fault(&[]).await.contains("no log was given"));
    assert!(fault(&[dir.path().to_owned()]).await.contains("no log was given"));
    let text = file(dir.path(), "log.jsonl", b"{}");
    assert!(fault(&[text]).await.contains("JSON lines are read by `kane check`"));
    let arrow = file(dir.path(), "log.arrow", b"ARROW1");
    assert!(fault(&[csv, arrow]).await.contains("of two forms"));
    let short = file(dir.path(), "short.csv", b"mass,vx_pre\n1,2\n");
    let told = fault(&[short]).await;
    assert!(told.contains("columns are missing: vy1_pre_m_s"), "{told}");
    let unit = fs::read_to_string(recorded(LOG))
        .expect("it is there")
        .replace("omega_post", "omega_post_deg_s");
    let told = fault(&[file(dir.path(), "unit.csv", unit.as_bytes())]).await;
    assert!(told.contains("convert it to SI units"), "{told}");
}

#[tokio::test]
async fn rows_that_cannot_be_checked_are_counted_by_their_reasons() {
    // dt, phase, mass, radius, inertia, mu, e, then v_x, v_y and omega before and after
    let text = fs::read_to_string(recorded(LOG)).expect("it is there");
    let changed = text.lines().enumerate().map(|(line, row)| {
        let mut cells: Vec<&str> = row.split(',').collect();
        match line % 9 {
            2 => cells[2] = "0",
            4 => cells[8] = "NaN",
            6 => cells[12] = "",
            _ => {}
        }
        cells.join(",") + "\n"
    });
    let dir = tempfile::tempdir().expect("there is room");
    let csv = file(dir.path(), "log.csv", changed.collect::<String>().as_bytes());
    let (writing, _) = opened(&csv, 1).await;
    let log = dir.path().join("log.parquet");
    parquet(&writing, "SELECT * FROM log", &log).await;
    let (session, log) = opened(&log, 3).await;
    let study = check(&session, &log).await.expect("it has rows");
    let kinds: Vec<(&str, usize)> =
        study.rejections.kinds().map(|(kind, _, listed)| (kind, listed.len())).collect();
    let expected = [
        ("NaN or infinity in vy1_pre_m_s", 3),
        ("mass1_kg is not above zero", 3),
        ("omega1_post_rad_s is empty", 3),
    ];
    assert_eq!(kinds, expected);
    let rows = text.lines().count() - 1;
    assert_eq!(usize::try_from(study.rows + study.rejections.total()), Ok(rows));
    assert!(!study.as_expected() && study.rows > 0);
}

#[tokio::test]
async fn a_ragged_csv_is_an_error_and_an_odd_cell_a_rejected_row() {
    let text = fs::read_to_string(recorded(LOG)).expect("it is there");
    let dir = tempfile::tempdir().expect("there is room");
    let ragged = file(dir.path(), "ragged.csv", format!("{text}1,2,3\n").as_bytes());
    let told = match open(&session(1), &[ragged], Reading::default()).await {
        Err(fault) => fault.to_string(),
        Ok(_) => String::new(),
    };
    assert!(told.contains("unequal lengths"), "{told}");
    let last = text.lines().last().expect("it has rows");
    let (head, _) = last.rsplit_once(',').expect("it has cells");
    let odd = file(dir.path(), "odd.csv", format!("{text}{head},n/a\n").as_bytes());
    let (session, log) = opened(&odd, 1).await;
    let study = check(&session, &log).await.expect("it has rows");
    assert_eq!(study.rejections.of_kind("no number in"), 1);
}

#[tokio::test]
async fn a_quote_that_nothing_closes_is_an_error_with_its_line() {
    let text = fs::read_to_string(recorded(LOG)).expect("it is there");
    let dir = tempfile::tempdir().expect("there is room");
    let last = text.lines().last().expect("it has rows");
    let open = file(dir.path(), "open.csv", format!("{text}\"{last}\n{last}\n").as_bytes());
    let told = fault(&[open]).await;
    let line = format!("line {}: a quote opens", text.lines().count() + 1);
    assert!(told.contains("open.csv") && told.contains(&line), "{told}");
}

#[tokio::test]
async fn two_columns_of_one_name_are_told_by_it() {
    let text = fs::read_to_string(recorded(LOG)).expect("it is there");
    let dir = tempfile::tempdir().expect("there is room");
    let twice: String = text
        .lines()
        .map(|line| format!("{},{line}\n", line.split(',').next().unwrap_or("")))
        .collect();
    let told = fault(&[file(dir.path(), "twice.csv", twice.as_bytes())]).await;
    assert!(told.starts_with("columns 1 and 2 are both called `"), "{told}");
}
