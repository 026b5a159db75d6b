//! A scheduler and two executors on loopback give the answer of one process, also when one of the
//! executors is ended while it works.

use std::fs;
use std::io::Read as _;
use std::net::{TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use datafusion::dataframe::DataFrameWriteOptions;
use datafusion::prelude::SessionContext;
use tempfile::TempDir;

/// As long as anything may take.
const PATIENCE: Duration = Duration::from_secs(300);

/// A process that ends with the test.
struct Process(Child);

impl Drop for Process {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

fn kane_lake() -> Command {
    Command::new(env!("CARGO_BIN_EXE_kane-lake"))
}

fn started(command: &mut Command, output: &Path) -> Process {
    let file = fs::File::create(output).expect("there is room");
    let errors = file.try_clone().expect("it is a file");
    Process(command.stdout(file).stderr(errors).spawn().expect("it starts"))
}

/// A port of loopback on which nothing listens.
fn port() -> u16 {
    let listener = TcpListener::bind("127.0.0.1:0").expect("there are ports");
    listener.local_addr().expect("it has one").port()
}

/// Waits until something is so.
fn until(what: &str, mut so: impl FnMut() -> bool) {
    let start = Instant::now();
    while !so() {
        assert!(start.elapsed() < PATIENCE, "{what}");
        std::thread::sleep(Duration::from_millis(20));
    }
}

struct Cluster {
    scheduler: u16,
    executors: Vec<(Process, PathBuf)>,
    // dropped last
    _scheduler: Process,
    _dir: TempDir,
}

impl Cluster {
    /// A scheduler and two executors of one core each.
    fn start() -> Self {
        let dir = tempfile::tempdir().expect("there is room");
        let scheduler = port();
        let address = format!("127.0.0.1:{scheduler}");
        let mut command = kane_lake();
        command.args(["scheduler", "--bind", &address, "--patience", "8"]);
        let process = started(&mut command, &dir.path().join("scheduler.txt"));
        until("the scheduler listens", || TcpStream::connect(&address).is_ok());
        let executors = (0..2).map(|place| {
            let work = dir.path().join(format!("work-{place}"));
            fs::create_dir(&work).expect("there is room");
            let bind = format!("127.0.0.1:{}", port());
            let mut command = kane_lake();
            command.args(["executor", "--bind", &bind, "--scheduler", &address, "--cores", "1"]);
            command.args(["--tasks", &port().to_string()]);
            command.arg("--work").arg(&work);
            let process = started(&mut command, &dir.path().join(format!("executor-{place}.txt")));
            until("an executor listens", || TcpStream::connect(&bind).is_ok());
            (process, work)
        });
        let executors = executors.collect();
        Self { scheduler, executors, _scheduler: process, _dir: dir }
    }

    fn check(&self, log: &Path) -> Command {
        let mut command = check(log);
        command.arg("--cluster").arg(format!("127.0.0.1:{}", self.scheduler));
        command
    }
}

/// The log checked into a report for programs.
fn check(log: &Path) -> Command {
    let mut command = kane_lake();
    command.arg("check").arg(log).args(["--format", "json", "--parts", "8"]);
    command
}

fn answer(command: &mut Command) -> String {
    let output = command.output().expect("it runs");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert_eq!((output.status.code(), &*errors), (Some(1), ""), "the log has rows that fail");
    String::from_utf8(output.stdout).expect("it is text")
}

/// A log of eight Parquet files: spheres that meet the ground with friction that is Coulomb's, one row in
/// a thousand with energy out of nothing, and one in five thousand with NaN in a column that has one
/// value otherwise.
fn log(rows: usize) -> TempDir {
    let dir = tempfile::tempdir().expect("there is room");
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build();
    runtime.expect("it starts").block_on(async {
        let session = SessionContext::new();
        for file in 0..8 {
            let (from, to) = (file * rows / 8 + 1, (file + 1) * rows / 8);
            let query = format!(
                "SELECT value AS id, 1.0 AS mass, 0.4 AS inertia, 1.0 AS radius, 0.25 AS mu, 0.5 AS e, \
                 2.0 + value / 65536.0 AS vx_pre, \
                 CASE WHEN value % 5000 = 7 THEN 'NaN'::DOUBLE ELSE -1.0 END AS vy_pre, 0.0 AS omega_pre, \
                 CASE WHEN value % 1000 = 0 THEN 3.0 + value / 65536.0 ELSE 1.625 + value / 65536.0 END AS vx_post, \
                 0.5 AS vy_post, -0.9375 AS omega_post FROM generate_series({from}, {to})"
            );
            let frame = session.sql(&query).await.expect("it is a query");
            let place = dir.path().join(format!("{file}.parquet"));
            let options = DataFrameWriteOptions::new();
            frame.write_parquet(&place.to_string_lossy(), options, None).await.expect("room");
        }
    });
    dir
}

/// Files below a directory.
fn files(dir: &Path) -> usize {
    let Ok(entries) = fs::read_dir(dir) else { return 0 };
    let paths = entries.flatten().map(|entry| entry.path());
    paths.map(|path| if path.is_dir() { files(&path) } else { 1 }).sum()
}

#[test]
fn two_executors_give_the_answer_of_one_process() {
    let cluster = Cluster::start();
    let log = log(100_000);
    let alone = answer(&mut check(log.path()));
    assert!(
        alone.contains("\"kind\": \"NaN or infinity in vy1_pre_m_s\",\n      \"rows\": 20"),
        "{alone}"
    );
    assert_eq!(answer(&mut cluster.check(log.path())), alone);
    let query = "SELECT e, count(*) AS n, max(kane_energy_gain()) AS gain FROM log GROUP BY e";
    let mut here = kane_lake();
    here.arg("sql").arg(log.path()).arg(query);
    let mut there = kane_lake();
    there.arg("sql").arg(log.path()).arg(query);
    there.arg("--cluster").arg(format!("127.0.0.1:{}", cluster.scheduler));
    let shown = |command: &mut Command| {
        let output = command.output().expect("it runs");
        (output.status.code(), String::from_utf8_lossy(&output.stdout).into_owned())
    };
    let table = shown(&mut here);
    assert!(table.0 == Some(0) && table.1.contains("100000"), "{table:?}");
    assert_eq!(shown(&mut there), table);
    // both of them worked
    for (_, work) in &cluster.executors {
        assert!(files(work) > 0, "{}", work.display());
    }
}

#[test]
fn an_executor_that_ends_in_the_middle_changes_nothing() {
    let mut cluster = Cluster::start();
    let log = log(400_000);
    let alone = answer(&mut check(log.path()));
    let mut command = cluster.check(log.path());
    let mut client =
        Process(command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("it starts"));
    let (process, work) = cluster.executors.remove(0);
    // it has written what its first task found
    until("the first executor works", || files(&work) > 0);
    assert!(client.0.try_wait().expect("it runs").is_none(), "the query is not answered yet");
    drop(process);
    let mut told = String::new();
    let mut out = client.0.stdout.take().expect("it has one");
    out.read_to_string(&mut told).expect("it is text");
    assert_eq!(told, alone);
}
