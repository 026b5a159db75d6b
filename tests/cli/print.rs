//! The report for LaTeX, compiled. Without `pdflatex` this is skipped, unless `KANE_REQUIRE_LATEX` is set.

use std::fs;
use std::process::{Command, Stdio};

use crate::chromium::skip;
use crate::{document, kane, scratch};

/// Statements that bring every construct of the notation, and text that LaTeX would misread.
const STATEMENTS: &str = "\
var x, mu >= 0, v_x0', alpha
var f(alpha)
let k_W := cases { x < 1: 1 - 2*x; else: abs(x)/3 }
given a_b: mu*v_x0' <= max(x, 2)^2    # 100 % & more
given lim: f -> 1/3 as alpha -> 0+
claim (50): d(x^3, x) = 3*x^2    # 50 %, & # _ ~
claim not-so: sqrt(x^2) = x  expect refuted
claim chain: 0 <= mu < mu + 1 != mu  from a_b
claim weaker: not implied lim from a_b
claim gone: contradiction from a_b  expect refuted
claim pole: x/x = 1  expect ill-defined";

#[test]
fn the_reports_compile() {
    let found = Command::new("pdflatex").arg("--version").stdout(Stdio::null()).status();
    if found.is_err() {
        return skip("pdflatex", "KANE_REQUIRE_LATEX");
    }
    let dir = scratch("latex");
    let hard = document(&scratch("latex-source"), "hard.md", STATEMENTS);
    let paper = "docs/derivations/oblique-collision.md";
    let run = kane(&["audit", &hard, paper, "--out", dir.to_str().expect("UTF-8")]);
    assert_eq!(run.code, 0, "{}{}", run.stdout, run.stderr);
    for name in ["hard", "oblique-collision"] {
        let run = Command::new("pdflatex")
            .args(["-halt-on-error", "-interaction=nonstopmode", &format!("{name}.tex")])
            .current_dir(&dir)
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .status()
            .expect("it was found");
        let log = fs::read(dir.join(format!("{name}.log"))).expect("a log is written");
        let log = String::from_utf8_lossy(&log);
        assert!(
            run.success(),
            "{name}: {}",
            log.lines().rev().take(30).collect::<Vec<_>>().join("\n")
        );
        // a line that leaves the margin by more than the width of a letter would be cut or look so
        let beyond = log.lines().filter_map(|line| {
            let points = line.strip_prefix("Overfull \\hbox (")?.split_once("pt")?.0;
            Some((points.parse::<f64>().ok()?, line))
        });
        let worst: Vec<_> = beyond.filter(|(points, _)| *points > 10.0).collect();
        assert!(worst.is_empty(), "{name}: {worst:?}");
    }
}
