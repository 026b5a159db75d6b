//! Time-outs are verdicts: what is too large ends soon, with a message or undecided, never with a
//! panic, an overflow or all memory. All run in an ordinary test thread.

use std::fmt::Write;
use std::time::Instant;

use kane::audit::{Options, Verdict, audit, read};

/// Seconds a document may take; the budgets end it far sooner where the machine is quick.
const BOUND: f64 = 20.0;

/// The most memory that this process ever had, as the system tells.
fn peak() -> String {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find(|l| l.starts_with("VmHWM"));
    line.map_or("unknown".to_owned(), |l| l.trim_start_matches("VmHWM:").trim().to_owned())
}

/// How a document ends: the verdicts of its claims, or the first message.
fn ends(name: &str, statements: &str) -> Result<Vec<Verdict>, String> {
    let text = format!("```kane\n{statements}\n```\n");
    let start = Instant::now();
    let outcome = match read("hard.md", text.as_bytes()) {
        Ok(document) => {
            let audit = audit(document, &Options::default(), &mut |_, _| {});
            let claims = audit.judgements.iter().filter(|j| !j.links.is_empty());
            Ok(claims.map(|j| j.verdict).collect())
        }
        Err(faults) => Err(faults.first().map(|f| f.to_string()).unwrap_or_default()),
    };
    let seconds = start.elapsed().as_secs_f64();
    let told = match &outcome {
        Ok(verdicts) => format!("{verdicts:?}"),
        Err(message) => message.lines().next().unwrap_or_default().chars().take(100).collect(),
    };
    println!("adversarial, {name}: {seconds:.2} s, peak {}: {told}", peak());
    assert!(seconds < BOUND, "{name} took {seconds:.1} s");
    outcome
}

fn undecided(name: &str, statements: &str) {
    let outcome = ends(name, statements);
    assert_eq!(outcome, Ok(vec![Verdict::Undecided]), "{name}");
}

fn sum(n: usize) -> String {
    (1..=n).map(|i| format!("x{i}")).collect::<Vec<_>>().join(" + ")
}

fn symbols(n: usize) -> String {
    (1..=n).map(|i| format!("x{i}")).collect::<Vec<_>>().join(", ")
}

#[test]
fn a_power_of_a_sum_of_twelve_ends() {
    let (all, s) = (symbols(12), sum(12));
    undecided("degree 200, 12 variables", &format!("var {all}\nclaim c: ({s})^200 >= x1"));
    let outcome = ends("its even power", &format!("var {all}\nclaim c: ({s})^200 >= 0"));
    assert!(outcome.is_ok());
    let outcome = ends("exponent 10000", &format!("var {all}\nclaim c: ({s})^10000 = x1"));
    assert!(outcome.is_ok());
}

/// A product of a hundred roots, in which no square is written.
fn hundred_roots() -> String {
    (1..=100).map(|i| format!("(x - {i})")).collect::<Vec<_>>().join("*")
}

#[test]
fn one_variable_of_degree_two_hundred_ends() {
    let outcome = ends("x^200", "var x\nclaim c: x^200 - 3*x^101 + 7*x^2 + 1 > 0");
    assert_eq!(outcome, Ok(vec![Verdict::Proved]));
    // false at −1, which is seen although the line cannot be cut at all its roots
    let outcome = ends("dense", "var x\nclaim c: (x^2 + 3*x + 1)^100 >= (x - 1)^200 - x^99");
    assert_eq!(outcome, Ok(vec![Verdict::Refuted]));
    let roots = hundred_roots();
    undecided("100 double roots", &format!("var x\nclaim c: {roots}*{roots} >= 0"));
    let roots: Vec<String> = (1..=100).map(|i| format!("(x - {i})^2")).collect();
    let outcome = ends("100 squares", &format!("var x\nclaim c: {} >= 0", roots.join("*")));
    assert_eq!(outcome, Ok(vec![Verdict::Proved]));
    let roots: Vec<String> = [2, 3, 5, 7, 11].iter().map(|p| format!("sqrt({p})")).collect();
    undecided("degree 32", &format!("var x\nclaim c: x != {} when x > 3", roots.join(" + ")));
}

#[test]
fn deep_nesting_is_an_error() {
    for n in [300, 100_000] {
        let (open, close) = ("(".repeat(n), ")".repeat(n));
        assert!(
            ends("nested parentheses", &format!("var x\nclaim c: {open}x{close} = x")).is_err()
        );
        let open = "abs(".repeat(n);
        assert!(ends("nested abs", &format!("var x\nclaim c: {open}x{close} = x")).is_err());
        let minus = "-".repeat(n);
        let _ = ends("a row of signs", &format!("var x\nclaim c: {minus}x = x"));
        let tower = "x^2".to_owned() + &"^1".repeat(n);
        let _ = ends("a tower", &format!("var x\nclaim c: {tower} = x^2"));
    }
}

#[test]
fn two_hundred_nested_absolute_values_end() {
    let n = 200;
    let (open, close) = ("abs(".repeat(n), ")".repeat(n));
    let outcome = ends("200 nested abs", &format!("var x\nclaim c: {open}x{close} >= 0"));
    assert_eq!(outcome, Ok(vec![Verdict::Proved]));
    let shifted: String =
        (0..n).fold("x".to_owned(), |inner, i| format!("abs({inner} - {})", i + 1));
    undecided("200 shifted abs", &format!("var x\nclaim c: {shifted} >= 0"));
    let lets = (1..=300).fold("var x\nlet a0 := x".to_owned(), |all, i| {
        format!("{all}\nlet a{i} := abs(a{} - {i})", i - 1)
    });
    undecided("300 abs by definitions", &format!("{lets}\nclaim c: a300 >= 0"));
}

#[test]
fn definitions_that_double_end() {
    let mut text = String::from("var x0\nlet x1 := x0*x0\n");
    for i in 2..=10_000 {
        let _ = writeln!(text, "let x{i} := x{}*x{}", i - 1, i - 1);
    }
    let _ = ends("10000 squares", &format!("{text}claim c: x10000 >= 0"));
    let mut text = String::from("var x0, y\nlet x1 := x0 + y\n");
    for i in 2..=100 {
        let _ = writeln!(text, "let x{i} := x{}*x{} + y", i - 1, i - 1);
    }
    let _ = ends("100 squares and sums", &format!("{text}claim c: x100 >= 0"));
}

#[test]
fn a_million_combinations_of_cases_end() {
    let mut text = format!("var {}\n", symbols(20));
    let parts: Vec<String> = (1..=20).map(|i| format!("abs(x{i})")).collect();
    let _ = writeln!(text, "claim c: {} >= 0", parts.join(" + "));
    undecided("20 absolute values", &text);
    let branches: Vec<String> = (1..=2_000).map(|i| format!("x < {i}: {i}*x")).collect();
    let cases = format!("cases {{ {}; else: 0 }}", branches.join("; "));
    undecided("2000 branches", &format!("var x\nclaim c: {cases} < 2000*abs(x) + 1"));
    let mut text = String::from("var x\n");
    for i in 1..=20 {
        let _ = writeln!(text, "let c{i} := cases {{ x < {i}: x; else: c{} }}", i - 1);
    }
    let text = text.replacen("c0", "x^2", 1);
    let outcome = ends("20 cases within each other", &format!("{text}claim c: c20 >= x"));
    assert_eq!(outcome, Ok(vec![Verdict::Proved]));
}

#[test]
fn what_does_not_fit_a_budget_says_so() {
    let reason = |statements: &str| {
        let text = format!("```kane\n{statements}\n```\n");
        let document = read("hard.md", text.as_bytes()).expect("it can be read");
        let audit = audit(document, &Options::default(), &mut |_, _| {});
        let open = audit.judgements.last().and_then(|j| j.links[0].open.clone());
        open.map(|why| why.to_string()).unwrap_or_default()
    };
    let parts: Vec<String> = (1..=20).map(|i| format!("abs(x{i})")).collect();
    let cases = reason(&format!("var {}\nclaim c: {} >= 0", symbols(20), parts.join(" + ")));
    assert!(cases.contains("normal form does not fit the budget"), "{cases}");
    let roots = hundred_roots();
    let roots = reason(&format!("var x\nclaim c: {roots}*{roots} >= 0"));
    assert!(roots.contains("coefficient operations"), "{roots}");
}

#[test]
fn huge_numbers_end() {
    let digits = "9".repeat(9_999);
    let outcome = ends("10^4 digits", &format!("var x\nclaim c: {digits}*x^2 + 1/{digits} > 0"));
    assert!(outcome.is_ok());
    let outcome = ends("their power", &format!("var x\nclaim c: ({digits}*x)^1000 >= 0"));
    assert!(outcome.is_ok());
    let outcome = ends("2^10000^…", "var x\nclaim c: (2^10000)^10000*x^2 >= 0");
    assert!(outcome.is_ok());
    assert!(ends("too long", &format!("var x\nclaim c: {digits}{digits}*x = 0")).is_err());
}

#[test]
fn a_large_file_ends() {
    let line = "claim c: x + x = 2*x\n";
    let mut text = String::from("var x\n");
    for i in 0..20_000 {
        let _ = writeln!(text, "let y{i} := x + {i}");
    }
    text.push_str(line);
    text.push_str(&"# nothing but talk, line after line of it\n".repeat(230_000));
    assert_eq!(ends("10 MB", &text), Ok(vec![Verdict::Proved]));
    assert!(ends("17 MB", &"# too long\n".repeat(1_600_000)).is_err());
    let noise = "claim ?!: )( \n".repeat(700_000);
    assert!(ends("10 MB of faults", &noise).is_err());
}

#[test]
fn equations_in_many_symbols_end() {
    let mut text = format!("var {}\n", symbols(12));
    for i in 1..=11 {
        let _ = writeln!(text, "given g{i}: x{i}^3 + x{}^2*x{i} + x12 = {i}", i + 1);
    }
    let all: Vec<String> = (1..=11).map(|i| format!("g{i}")).collect();
    let _ = writeln!(text, "claim c: x1^5 + x12^7 > x3*x5     from {}", all.join(", "));
    assert!(ends("11 cubic equations in 12 symbols", &text).is_ok());
}
