//! What must hold of every collision: in the words of the request, on inputs that aim at trouble.
//!
//! `PROPTEST_CASES` replaces the number of cases of every property; without it there are a quarter of those of
//! the gate (`KANE_GATE=1`).

/// Floats against exact numbers in α, and the two ways through the physics against each other.
mod agreement;
/// Laws over columns of floats.
mod batch;
/// From bodies to contacts and back.
mod bodies;
/// The limits of normal collision and of non-collision, with their rates.
mod connection;
/// Contacts that couple, aimed at every guard.
mod contacts;
/// Decisions in stages against exact numbers, with ties planted.
mod decide;
/// Exact arithmetic on floats without fractions.
mod dyadic;
/// Who creates energy, and exactly when.
mod energy;
/// Laws that stand in a frame of their own.
mod frames;
/// The same on very many contacts, by intervals.
mod long_run;
/// How much a test does.
#[path = "../shared/many.rs"]
#[expect(dead_code, reason = "all here is random")]
mod many;
/// The matrix of laws and properties, against contacts drawn at random, planted faults and mutations.
mod matrix;
/// Closed forms against the integration of their process.
mod process;
/// Randomness that a run repeats.
mod random;
/// What every law does on any planar contact.
mod rigid;
/// Floats from physical inputs, of every size.
mod rounding;
/// The law that is known in space.
mod spatial;
/// What laws state, solved exactly, against their code.
mod statement;
/// Inputs for all of these.
mod strategies;
/// The code of the laws, run on symbols.
mod symbolic;
/// Mirror symmetry, zero slip, grazing, and inputs without any sense.
mod totality;
/// The quick ways of a law against its table.
mod working;

use kane_number::{Integer, Rational};
use proptest::test_runner::Config;

/// A configuration with this many cases in the gate, and a quarter elsewhere, unless `PROPTEST_CASES` says
/// otherwise.
fn cases(in_the_gate: u32) -> Config {
    let cases =
        usize::try_from(in_the_gate).map(many::many).ok().and_then(|n| u32::try_from(n).ok());
    Config { cases: cases.unwrap_or(in_the_gate), ..Config::default() }
}

fn rational(numer: impl Into<Integer>, denom: impl Into<Integer>) -> Rational {
    Rational::new(numer.into(), denom.into())
}

/// 2^exponent.
fn two_to(exponent: i32) -> Rational {
    rational(2, 1).pow(exponent)
}
