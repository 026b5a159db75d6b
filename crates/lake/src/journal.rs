//! What the processes of a cluster say of themselves, on standard error.

use std::io::Write as _;

use kane_algebra::syntax::printable;
use log::{LevelFilter, Log, Metadata, Record};

use crate::args::Level;

/// Writes a line for every record, without a clock: whoever collects lines has one.
struct Journal;

impl Log for Journal {
    fn enabled(&self, _: &Metadata<'_>) -> bool {
        true
    }

    fn log(&self, record: &Record<'_>) {
        let line = format!("{} {}: {}", record.level(), record.target(), record.args());
        let _ = writeln!(std::io::stderr().lock(), "{}", printable(&line));
    }

    fn flush(&self) {}
}

/// Begins to write records up to this level.
pub(crate) fn begin(level: Level) {
    let level = match level {
        Level::Off => LevelFilter::Off,
        Level::Error => LevelFilter::Error,
        Level::Warn => LevelFilter::Warn,
        Level::Info => LevelFilter::Info,
        Level::Debug => LevelFilter::Debug,
    };
    if log::set_logger(&Journal).is_ok() {
        log::set_max_level(level);
    }
}
