//! Certified comparisons: what plain floats get wrong next to ties, and the emitted code against exact fractions.

use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;

use kane_floats::decision::{certified, decisions, prelude, share};
use kane_floats::{Core, Language, Precision, fpcore};
use kane_number::{Rational, decode};

fn core(text: &str) -> Core {
    fpcore::read("t.fpcore", text).expect("it is well formed").remove(0)
}

/// x·y against the exact product: next to a tie the rounded product decides wrongly.
#[test]
fn plain_floats_decide_wrongly_next_to_ties() {
    let core =
        core("(FPCore (x y) :name \"f\" :pre (and (<= 1 x 2) (<= 1 y 2)) (if (< (* x y) 2) 0 1))");
    let decision = decisions(&core).remove(0);
    assert_eq!(decision.text(&core), "x*y < 2");
    let share = share::<f64>(&core, &decision).expect("there are floats");
    assert!(share.near > 500 && share.wrong_near > 0, "{share:?}");
    assert!(share.wrong * 100 < share.drawn, "{share:?}");
    let tie = share.tie.expect("one is wrong");
    let [x, y] = [tie.at[0], tie.at[1]].map(|x| decode(x).expect("it is finite"));
    assert_eq!(&x * &y < Rational::from_integer(2.into()), tie.holds);
    assert_ne!(tie.at[0] * tie.at[1] < 2.0, tie.holds);
}

/// What the machine compares exactly needs no other version.
#[test]
fn inputs_are_compared_exactly_as_they_are() {
    for text in [
        "(FPCore (x y) (if (< x y) x y))",
        "(FPCore (x) (if (< (fabs x) 3) x (- x)))",
        "(FPCore (x) (+ x 1))",
    ] {
        assert_eq!(decisions(&core(text)), vec![], "{text}");
        assert_eq!(certified(&core(text), Precision::F64, Language::C), None, "{text}");
    }
}

/// Choices between inputs that are used twice each, forty deep: with each use written out that is 2^40 of them.
#[test]
fn what_is_shared_is_looked_at_and_written_once() {
    let shared: Vec<String> =
        (1..40).map(|n| format!("[t{n} (fmin t{} (fmax y t{}))]", n - 1, n - 1)).collect();
    let text = |test: &str| {
        let shared = shared.join(" ");
        format!("(FPCore (x y) (let* ([t0 x] {shared}) (if {test} 1 x)))")
    };
    assert_eq!(decisions(&core(&text("(< t39 y)"))), vec![]);
    let choice = core(&text("(< (if (< t39 y) (* x y) t39) (* t39 x))"));
    assert_eq!(decisions(&choice).len(), 1);
    for language in [Language::Rust, Language::C, Language::Python] {
        let written = certified(&choice, Precision::F64, language).expect("there is a comparison");
        assert!(written.len() < 40_000, "{}", written.len());
    }
}

/// Names that would end a comment, and constants beyond every float.
#[test]
fn strange_names_and_constants_are_written_as_code() {
    let core = core("(FPCore (*/x kt1 e2) :name \"1f\" (if (< (* */x kt1) 1e400) e2 (- 1e400)))");
    for language in Language::ALL {
        let code = certified(&core, Precision::F64, language).expect("it compares");
        assert!(!code.contains("inf_"), "{code}");
        assert!(code.contains("kt1_") && code.contains("v1f_decides_1"), "{code}");
    }
    let c = certified(&core, Precision::F64, Language::C).expect("it compares");
    assert_eq!(c.matches("*/").count(), c.matches("/*").count(), "{c}");
}

/// Comparisons with their exact values at rational inputs, by a way of their own: (formula, exact truth).
type Case = (&'static str, fn(&Rational, &Rational) -> bool);

fn n(integer: i64) -> Rational {
    Rational::from_integer(integer.into())
}

/// √x ≤ y, for y ≥ 0 and x ≥ 0.
fn root_at_most(x: &Rational, y: &Rational) -> bool {
    *x <= y * y
}

const CASES: [Case; 7] = [
    ("(< (* x y) 1)", |x, y| x * y < n(1)),
    ("(<= (sqrt x) y)", root_at_most),
    ("(>= (/ x (+ y 1)) (/ y (+ x 1/3)))", |x, y| {
        x * (x + Rational::new(1.into(), 3.into())) >= y * (y + n(1))
    }),
    ("(== (+ x (* 2 y)) 3)", |x, y| x + n(2) * y == n(3)),
    // √x + √y < 2: with s = 4 − x − y it holds iff s > 0 and 4xy < s²
    ("(< (+ (sqrt x) (sqrt y)) 2)", |x, y| {
        let s = n(4) - x - y;
        s > n(0) && n(4) * x * y < &s * &s
    }),
    // √(x + √y) > 3/2
    ("(> (sqrt (+ x (sqrt y))) 3/2)", |x, y| {
        let rest = Rational::new(9.into(), 4.into()) - x;
        rest < n(0) || *y > &rest * &rest
    }),
    ("(< (fabs (- (fmin x y) 0.1)) (- (* x x) y))", |x, y| {
        let least = if x < y { x } else { y } - Rational::new(1.into(), 10.into());
        let size = if least < n(0) { -least } else { least };
        size < x * x - y
    }),
];

/// Inputs next to ties of each case, and others.
fn inputs() -> Vec<(f64, f64)> {
    let mut found = vec![(1e-300, 1e300), (5e-324, 1.0), (0.0, 0.0), (1.0, 1.0), (2.25, 0.0)];
    let roots = |x: f64| [x.sqrt(), 1.0 / x, (3.0 - x) / 2.0, (2.0 - x.sqrt()).powi(2)];
    for x in [0.3, 1.0, 1.7, 2.0, 0.25, 1.1, 2.2, 0.7] {
        for y in roots(x).into_iter().chain([x, (2.25 - x) * (2.25 - x), x * x - (x - 0.1).abs()]) {
            let y = y.abs();
            found.extend([(x, y), (x, y.next_up()), (x, y.next_down().abs())]);
            found.extend([(x.next_up(), y), (x.next_down(), y)]);
        }
    }
    found
}

/// What the arguments are called, a case each: as the code around them calls what it needs.
const NAMES: [[&str; 2]; 7] = [
    ["HALF", "KANE_HALF"],
    ["sqrt", "kt3"],
    ["MORE", "KANE_MORE"],
    ["abs", "fabs"],
    ["TINY", "KANE_TINY"],
    ["Fraction", "exact_sign"],
    ["min", "falsely"],
];

/// A program that prints the certified answers of all cases at all inputs.
fn program(language: Language) -> String {
    let mut text = match language {
        Language::C => "#include <math.h>\n#include <stdio.h>\n".to_owned(),
        Language::Python => "from math import *\n".to_owned(),
        Language::Rust => String::new(),
    };
    text.push_str(prelude(language));
    for (index, (test, _)) in CASES.iter().enumerate() {
        let formula = format!("(FPCore (x y) :name \"f{index}\" (if {test} 1 0))");
        let mut core = core(&formula);
        for (argument, name) in core.arguments.iter_mut().zip(NAMES[index]) {
            name.clone_into(&mut argument.name);
        }
        let code = certified(&core, Precision::F64, language).expect("it compares");
        text.push('\n');
        text.push_str(&code);
        text.push('\n');
    }
    let mut calls = String::new();
    for (x, y) in inputs() {
        for index in 0..CASES.len() {
            match language {
                Language::Rust => writeln!(
                    calls,
                    "    println!(\"{{}}\", f{index}_certified({x:?}_f64, {y:?}_f64));"
                ),
                Language::C => {
                    writeln!(calls, "    printf(\"%g\\n\", f{index}_certified({x:?}, {y:?}));")
                }
                Language::Python => {
                    writeln!(calls, "print('%g' % f{index}_certified({x:?}, {y:?}))")
                }
            }
            .expect("a string takes all");
        }
    }
    match language {
        Language::Rust => text + "fn main() {\n" + &calls + "}\n",
        Language::C => text + "int main(void) {\n" + &calls + "    return 0;\n}\n",
        Language::Python => text + &calls,
    }
}

fn answers() -> Vec<String> {
    let mut all = Vec::new();
    for (x, y) in inputs() {
        let [x, y] = [x, y].map(|x| decode(x).expect("it is finite"));
        for (_, holds) in CASES {
            all.push(if holds(&x, &y) { "1".to_owned() } else { "0".to_owned() });
        }
    }
    all
}

/// Runs a program and compares what it prints; a language that is not installed is passed over.
fn agrees(language: Language, source: &str, build: Option<[&str; 5]>, run: &str) {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("decisions").join(language.name());
    std::fs::create_dir_all(&folder).expect("there is a place for files");
    std::fs::write(folder.join(source), program(language)).expect("it is writable");
    let path = |name: &str| folder.join(name).to_string_lossy().into_owned();
    let started = |program: &str, arguments: &[String], at: &Path| {
        Command::new(program).args(arguments).current_dir(at).output().ok()
    };
    let output = match build {
        Some([compiler, flags @ ..]) => {
            let mut arguments = vec![path(source), "-o".to_owned(), path("run")];
            arguments.extend(flags.iter().filter(|flag| !flag.is_empty()).map(|&f| f.to_owned()));
            let Some(built) = started(compiler, &arguments, &folder) else { return };
            assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
            started(&path("run"), &[], &folder)
        }
        None => started(run, &[path(source)], &folder),
    };
    let Some(output) = output else { return };
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let printed = String::from_utf8_lossy(&output.stdout);
    let printed: Vec<&str> = printed.lines().collect();
    let answers = answers();
    assert_eq!(printed.len(), answers.len());
    for (place, (printed, answer)) in printed.iter().zip(&answers).enumerate() {
        let at = inputs()[place / CASES.len()];
        assert_eq!(printed, answer, "{language:?}: {} at {at:?}", CASES[place % CASES.len()].0);
    }
    // and this is about something: plain floats are wrong at some
    let plain = inputs().iter().filter(|(x, y)| (x * y < 1.0) != exactly_less(*x, *y)).count();
    assert!(plain > 0);
}

fn exactly_less(x: f64, y: f64) -> bool {
    let [x, y] = [x, y].map(|x| decode(x).expect("it is finite"));
    x * y < n(1)
}

#[test]
fn certified_rust_decides_as_fractions_do() {
    agrees(
        Language::Rust,
        "f.rs",
        Some(["rustc", "--edition=2021", "-Copt-level=0", "-Awarnings", ""]),
        "",
    );
}

#[test]
fn certified_c_decides_as_fractions_do() {
    agrees(Language::C, "f.c", Some(["cc", "-std=c99", "-O1", "-ffp-contract=off", "-lm"]), "");
}

#[test]
fn certified_python_decides_as_fractions_do() {
    agrees(Language::Python, "f.py", None, "python3");
}
