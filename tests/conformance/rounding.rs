//! The documented bounds on rounding errors, proved by Gappa, about the operations of the code.

use std::io::Write as _;
use std::process::{Command, Output, Stdio};

use kane::impact::laws::WangSuLi;
use kane::impact::{Alpha, ImpactLaw};
use kane::measure::chart::{Answer, registry};
use kane::measure::{RoundingBound, rounding_bounds};
use kane_number::{Binary, Rational, Real, Rounding, System, decode, encode};
use num_bigint::BigInt;

use crate::support::installed;

/// Runs a program on a text.
fn run(program: &str, arguments: &[&str], input: &str) -> Output {
    let mut child = Command::new(program)
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program is installed");
    let mut stdin = child.stdin.take().expect("it is piped");
    stdin.write_all(input.as_bytes()).expect("the program reads its input");
    drop(stdin);
    child.wait_with_output().expect("the program ends")
}

#[test]
fn gappa_proves_every_bound() {
    if !installed("gappa") {
        return;
    }
    for bound in rounding_bounds() {
        for script in bound.gappa_questions() {
            let output = run("gappa", &[], &script);
            let said = String::from_utf8_lossy(&output.stderr);
            assert!(output.status.success(), "{}: {said}", bound.name());
        }
    }
}

/// Gappa would accept no bound that is too small.
#[test]
fn gappa_rejects_bounds_below_the_error_of_a_known_input() {
    if !installed("gappa") {
        return;
    }
    for mut bound in rounding_bounds() {
        // what is left is below the half ulp of any rounding, or the second order of a correction
        let factor = if bound.before_last_rounding { 50 } else { 3 };
        bound.ulps /= Rational::from_integer(BigInt::from(1) << factor);
        let output = run("gappa", &[], &bound.gappa_questions()[0]);
        assert!(!output.status.success(), "{}", bound.name());
    }
}

/// A number of the script's language: exactly, every operation rounded after `rnd=`.
struct Script<'a> {
    names: Vec<(&'a str, Rational)>,
    round: fn(&Rational) -> Rational,
}

fn rounded<F: Binary>(exact: &Rational) -> Rational {
    decode(encode::<F>(exact, Rounding::NearestEven)).expect("no result leaves the range")
}

impl<'a> Script<'a> {
    /// The value of `result` at an input.
    fn run(bound: &RoundingBound, operations: &'a str, alpha: Rational) -> Rational {
        let round = match bound.system {
            System::F32 => rounded::<f32>,
            _ => rounded::<f64>,
        };
        let mut script = Self { names: vec![("a", alpha)], round };
        for line in operations.lines() {
            let (name, body) = line.trim_end_matches(';').split_once('=').expect("an assignment");
            let (name, rounds) = match name.trim().strip_suffix(" rnd") {
                Some(name) => (name, true),
                None => (name.trim(), false),
            };
            let words = words(body);
            let mut rest = words.as_slice();
            let value = script.sum(&mut rest, rounds);
            assert!(rest.is_empty(), "{line}: {rest:?}");
            script.names.push((name, value));
        }
        let last = script.names.iter().rev().find(|(name, _)| *name == bound.result);
        last.expect("the result is among the names").1.clone()
    }

    fn keep(&self, value: Rational, rounds: bool) -> Rational {
        if rounds { (self.round)(&value) } else { value }
    }

    fn sum(&self, rest: &mut &[&str], rounds: bool) -> Rational {
        let mut value = self.product(rest, rounds);
        while let Some(sign @ ("+" | "-")) = rest.first().copied() {
            *rest = &rest[1..];
            let next = self.product(rest, rounds);
            value = self.keep(if sign == "+" { value + next } else { value - next }, rounds);
        }
        value
    }

    fn product(&self, rest: &mut &[&str], rounds: bool) -> Rational {
        let mut value = self.factor(rest, rounds);
        while let Some(sign @ ("*" | "/")) = rest.first().copied() {
            *rest = &rest[1..];
            let next = self.factor(rest, rounds);
            value = self.keep(if sign == "*" { value * next } else { value / next }, rounds);
        }
        value
    }

    fn factor(&self, rest: &mut &[&str], rounds: bool) -> Rational {
        let (word, others) = rest.split_first().expect("an operand");
        *rest = others;
        match *word {
            "-" => -self.factor(rest, rounds),
            "rnd" => {
                let inner = self.factor(rest, false);
                (self.round)(&inner)
            }
            "(" => {
                let value = self.sum(rest, rounds);
                assert_eq!(rest.first(), Some(&")"));
                *rest = &rest[1..];
                value
            }
            name => match self.names.iter().rev().find(|(known, _)| *known == name) {
                Some((_, value)) => value.clone(),
                None => name.parse().expect("a number"),
            },
        }
    }
}

fn words(text: &str) -> Vec<&str> {
    let mut found = Vec::new();
    let mut rest = text.trim_start();
    while !rest.is_empty() {
        let length = rest.find(|c: char| !c.is_alphanumeric()).unwrap_or(rest.len()).max(1);
        found.push(&rest[..length]);
        rest = rest[length..].trim_start();
    }
    found
}

/// What the code of the law says.
fn code<F: Binary + Real>(quantity: &str, alpha: F) -> Rational {
    let ratios = WangSuLi.ratios(&Alpha::new(alpha).expect("α ≥ 0")).expect("α is finite");
    let value = match quantity {
        "k" => ratios.k,
        "i_x" => ratios.impulse,
        _ => ratios.energy,
    };
    decode(value).expect("a finite result")
}

/// Some floats of each piece: its ends and what lies between them.
fn inputs<F: Binary>(bound: &RoundingBound) -> Vec<Rational> {
    let of = |exact: &Rational, way| decode(encode::<F>(exact, way)).expect("in range");
    let between = |a: &Rational, b: &Rational, of_eleven: i64| {
        a + (b - a) * Rational::new(of_eleven.into(), 11.into())
    };
    let mut all = Vec::new();
    for piece in &bound.pieces {
        all.push(of(&piece.from, Rounding::Up));
        all.push(of(&piece.to, Rounding::Down));
        all.extend((1..11).map(|n| of(&between(&piece.from, &piece.to, n), Rounding::NearestEven)));
    }
    all
}

/// What is proved is proved about the code: the script's operations give the law's own floats, and
/// those of every form of the chart that the bound is said to cover.
#[test]
fn the_operations_of_a_script_are_those_of_the_code_bit_by_bit() {
    let methods = registry();
    let mut compared = 0;
    for bound in rounding_bounds() {
        let alphas = match bound.system {
            System::F32 => inputs::<f32>(&bound),
            _ => inputs::<f64>(&bound),
        };
        for alpha in alphas {
            let script = Script::run(&bound, bound.operations, alpha.clone());
            for name in bound.methods {
                let coded = if *name == "law" {
                    match bound.system {
                        System::F32 => code(bound.quantity, encode::<f32>(&alpha, Rounding::Down)),
                        _ => code(bound.quantity, encode::<f64>(&alpha, Rounding::Down)),
                    }
                } else {
                    let found = methods.iter().find(|m| {
                        (m.law, m.quantity, m.name, m.system)
                            == (bound.law, bound.quantity, *name, bound.system)
                    });
                    let method = found.expect("the chart has the method");
                    match method.answer(encode::<f64>(&alpha, Rounding::Down)) {
                        Some(Answer::Number(value)) => value,
                        other => panic!("{name} at {alpha}: {other:?}"),
                    }
                };
                assert_eq!(script, coded, "{} {name} at {alpha}", bound.name());
                compared += 1;
            }
        }
    }
    println!("{compared} results compared");
    assert!(compared > 10_000);
}

/// Coq checks the proof that Gappa found, from its own library on floats.
#[test]
fn coq_accepts_gappa_s_proof() {
    if !(installed("gappa") && installed("coqc")) {
        return;
    }
    let bounds = rounding_bounds();
    let bound = bounds.into_iter().find(|b| b.quantity == "i_x").expect("i_x has a bound");
    let proof = run("gappa", &["-Bcoq"], &bound.gappa_questions()[0]);
    assert!(proof.status.success());
    let folder = std::env::temp_dir().join(format!("kane-gappa-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("the folder for temporary files is writable");
    std::fs::write(folder.join("proof.v"), &proof.stdout).expect("writable");
    let coq = Command::new("coqc").arg("proof.v").current_dir(&folder).output();
    let coq = coq.expect("coqc is installed");
    let said = String::from_utf8_lossy(&coq.stderr).into_owned();
    std::fs::remove_dir_all(&folder).expect("it was made above");
    assert!(coq.status.success(), "{said}");
}
