//! How long a log takes: reading alone, and reading with all checks.
//!
//! `cargo run --release -p kane-records --example throughput LOG.csv`; with `read` behind the log it is
//! read once and nothing else, and with a count of rows in place of a log such a log is written to
//! standard output.

use std::error::Error;
use std::fs::File;
use std::io::{BufReader, BufWriter, Write as _};
use std::time::{Duration, Instant};

use kane_records::header::Header;
use kane_records::reader::{Kind, Pairs, Sink, read};
use kane_records::rejection::Rejected;
use kane_records::row::Row;
use kane_records::study::{Options, study};

/// Counts rows and does nothing else.
struct Count(u64);

impl Sink for Count {
    fn header(&mut self, _: &Header, _: &Pairs) {}

    fn row(&mut self, _: &Row) {
        self.0 += 1;
    }

    fn reject(&mut self, _: Rejected) {}

    fn end(&mut self, _: &Pairs) {}
}

fn main() -> Result<(), Box<dyn Error>> {
    let argument = std::env::args().nth(1).ok_or("give a log, or a count of rows")?;
    if let Ok(rows) = argument.parse() {
        return Ok(written(rows)?);
    }
    let open = || File::open(&argument).map(|file| BufReader::with_capacity(1 << 18, file));
    if std::env::args().nth(2).as_deref() == Some("read") {
        let mut count = Count(0);
        read(open()?, Kind::Csv, &[], &mut count)?;
        println!("{} rows", count.0);
        return Ok(());
    }
    // the time on a core, where the system tells it, so that other work does not count
    let begin = Instant::now();
    let on_core = || -> Duration {
        let told = std::fs::read_to_string("/proc/self/schedstat").ok();
        let nanoseconds = told.and_then(|told| told.split_whitespace().next()?.parse().ok());
        nanoseconds.map_or_else(|| begin.elapsed(), Duration::from_nanos)
    };
    for _ in 0..3 {
        let start = on_core();
        let mut count = Count(0);
        read(open()?, Kind::Csv, &[], &mut count)?;
        let reading = on_core() - start;
        let start = on_core();
        let study = study(open()?, Kind::Csv, &Options::new(kane_impact::laws()))?;
        let all = on_core() - start;
        println!(
            "{} rows: reading {:.2} s, reading and checking {:.2} s, checking {:.2} s",
            count.0,
            reading.as_secs_f64(),
            all.as_secs_f64(),
            all.saturating_sub(reading).as_secs_f64()
        );
        assert_eq!(study.rows, count.0, "every row is one to check");
    }
    Ok(())
}

/// Discs under Coulomb's friction, with slips and spins that vary.
#[allow(clippy::cast_precision_loss, clippy::float_arithmetic, reason = "a log of floats")]
fn written(rows: u64) -> std::io::Result<()> {
    let mut out = BufWriter::new(std::io::stdout().lock());
    writeln!(out, "mass,radius,inertia,mu,e,vx_pre,vy_pre,omega_pre,vx_post,vy_post,omega_post")?;
    for i in 0..rows {
        let (u, w) = ((i % 1013) as f64 / 331.0 - 1.5, (i % 97) as f64 / 50.0 - 1.0);
        let (mu, e, a) = (0.3, 0.5, 0.5 + (i % 89) as f64 / 60.0);
        let normal = (1.0 + e) * a;
        let friction = (-(u + w) / 3.0).clamp(-mu * normal, mu * normal);
        let (x, spin) = (u + friction, w + 2.0 * friction);
        writeln!(out, "1,1,0.5,{mu},{e},{u},-{a},{w},{x},{},{spin}", normal - a)?;
    }
    out.flush()
}
