//! The collision of a row, for `kane collide`.

use std::fmt::Write as _;
use std::io::BufRead;

use kane_impact::bodies::Shape;
use kane_number::{Number as _, Rational, parse};

use crate::event::{Event, Given, Moving};
use crate::frame::Frame;
use crate::header::Header;
use crate::reader::{Kind, Pairs, ReadFault, Sink, read};
use crate::rejection::Rejected;
use crate::row::Row;

/// How `kane collide` is asked for the collision of a row.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Replay {
    /// by flags: all that follows `kane collide`
    Flags(String),
    /// by a file of this text
    File(String),
}

/// The decimal that stands for a float: its shortest, as an exact number.
fn exact(value: f64) -> Rational {
    parse(&format!("{value:e}")).unwrap_or_else(|_| Rational::zero())
}

fn decimal(value: f64) -> String {
    let (plain, short) = (format!("{value}"), format!("{value:e}"));
    if plain.len() <= short.len() + 4 { plain } else { short }
}

/// The collision of a row with its coefficients, and zero where one is not stated. Every number is
/// the shortest decimal of the float in the log, taken exactly.
///
/// A round body that meets a fixed obstacle is asked for by flags, everything else by a file; y and ω
/// point the same way in both as in a row. `shape` is that of the first body where its inertia follows from it.
#[must_use]
pub fn replay(event: &Event<f64>, given: &Given, shape: Option<Shape>) -> Replay {
    let mu = given.friction.unwrap_or(0.0);
    let e = given.restitution.unwrap_or(0.0);
    let body = &event.first;
    let [x, y] = body.arm;
    let fixed = event.second.is_none() && event.kick == [0.0; 2];
    if fixed && x == 0.0 && y < 0.0 {
        let radius = exact(-y);
        let weighed = || exact(body.inertia) / (exact(body.mass) * &radius * &radius);
        let gyration = shape.map_or_else(weighed, |shape| shape.gyration());
        let ratio = Rational::one() + Rational::one() / gyration;
        let [t, n, spin] = body.before;
        let mut flags = format!("--sphere {ratio} --vx {} --vy {}", decimal(t), decimal(n));
        if spin != 0.0 {
            let _ = write!(flags, " --spin {}", decimal(spin));
        }
        let _ = write!(flags, " --mu {} --e {}", decimal(mu), decimal(e));
        if body.mass != 1.0 {
            let _ = write!(flags, " --mass {}", decimal(body.mass));
        }
        if -y != 1.0 {
            let _ = write!(flags, " --radius {}", decimal(-y));
        }
        return Replay::Flags(flags);
    }
    Replay::File(file(event, mu, e))
}

fn file(event: &Event<f64>, mu: f64, e: f64) -> String {
    let mut file = format!("friction = {}\nrestitution = {}\n", quoted(mu), quoted(e));
    file.push_str(&table("planar.body", &event.first, event.kick));
    if let Some(second) = &event.second {
        file.push_str(&table("planar.other", second, event.kick));
    }
    file
}

/// A number as the format of collisions takes it.
fn quoted(value: f64) -> String {
    format!("\"{}\"", decimal(value))
}

fn table(name: &str, body: &Moving<f64>, kick: [f64; 2]) -> String {
    let [x, y] = body.arm.map(quoted);
    let [t, n, spin] = body.before;
    let [t, n] = [t + kick[0], n + kick[1]].map(quoted);
    format!(
        "\n[{name}]\nmass_kg = {}\ninertia_kg_m2 = {}\narm_m = [{x}, {y}]\nvelocity_m_s = [{t}, {n}]\nspin_rad_s = {}\n",
        quoted(body.mass),
        quoted(body.inertia),
        quoted(spin),
    )
}

/// Why a line has no collision.
#[derive(Debug, thiserror::Error)]
pub enum NoReplay {
    /// The log cannot be read.
    #[error(transparent)]
    Read(#[from] ReadFault),
    /// There is no such row.
    #[error("line {0} is no row of the log")]
    NoRow(u64),
    /// The row was rejected.
    #[error("line {} is rejected: {}", .0.line, .0.reason)]
    Rejected(Rejected),
}

/// The collision of a line as a file for `kane collide`.
///
/// # Errors
/// [`NoReplay`] if the line has none.
pub fn of_line(
    input: impl BufRead,
    kind: Kind,
    map: &[(String, String)],
    line: u64,
) -> Result<String, NoReplay> {
    let mut seeking = Seeking { line, spatial: false, found: None };
    read(input, kind, map, &mut seeking)?;
    let (event, given) = seeking.found.ok_or(NoReplay::NoRow(line))?.map_err(NoReplay::Rejected)?;
    Ok(file(&event, given.friction.unwrap_or(0.0), given.restitution.unwrap_or(0.0)))
}

/// By how much a normal may be off by its decimals, three of them.
const PRINTED: f64 = 2e-3;

struct Seeking {
    line: u64,
    spatial: bool,
    found: Option<Result<(Event<f64>, Given), Rejected>>,
}

impl Sink for Seeking {
    fn header(&mut self, header: &Header, _: &Pairs) {
        self.spatial = header.is_spatial();
    }

    fn row(&mut self, row: &Row) {
        if row.line == self.line {
            let event = Given::check(row).and_then(|()| {
                let frame = Frame::of(row, self.spatial, PRINTED)?;
                Event::check(row)?;
                Ok((Event::of(row, &frame), Given::of(row)))
            });
            self.found = Some(event.map_err(|reason| Rejected { line: row.line, reason }));
        }
    }

    fn reject(&mut self, rejected: Rejected) {
        if rejected.line == self.line {
            self.found = Some(Err(rejected));
        }
    }

    fn end(&mut self, _: &Pairs) {}
}
