//! `docs/verdict.md` is what laws, audits and points say now; its numbers by other ways, and its links.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use kane::impact::bodies::{Direction, DoublePendulum};
use kane::impact::laws::KaneLevinson;

const PAGE: &str = include_str!("../../../docs/verdict.md");

fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

#[test]
fn the_page_is_what_laws_audits_and_points_say() {
    let matrix = include_str!("../../../docs/figures/matrix.csv");
    let made = kane_pages::verdict(root(), matrix).expect("every verdict is what the page says");
    assert!(
        made == PAGE,
        "docs/verdict.md is stale; write it by\n  cargo run --release -p kane-pages"
    );
}

/// The table says that a law is so far from the points.
#[track_caller]
fn assert_rms(law: &str, k: impl Fn(f64) -> f64) {
    let table = include_str!("../../../docs/data/kharaz-2001-restitution.csv");
    let rows = table.lines().filter(|line| line.starts_with(|c: char| c.is_ascii_digit()));
    let squares: Vec<f64> = rows
        .map(|row| {
            let (angle, e_t) = row.split_once(',').expect("two columns");
            let [angle, e_t] = [angle, e_t].map(|cell| cell.parse::<f64>().expect("a number"));
            // alpha = j_p·μ·(1 + e)·cot θ/2, k = 1 − j_p·(1 − e_t), with j_p = 7/2
            let alpha = 3.5 * 0.092 * 1.98 / (2.0 * angle.to_radians().tan());
            (k(alpha) - (1.0 - 3.5 * (1.0 - e_t))).powi(2)
        })
        .collect();
    assert_eq!(squares.len(), 8);
    let rms = (squares.iter().sum::<f64>() / 8.0).sqrt();
    let named = |line: &&str| line.starts_with("| [") && line.contains(&format!("[{law}]"));
    let shown = PAGE.lines().filter(named).any(|line| line.contains(&format!("| {rms:.3} |")));
    assert!(shown, "{law}: {rms:.3} is not in the page");
}

/// By their formulas on a sphere, written out here.
#[test]
fn laws_are_as_far_from_the_points_as_their_formulas() {
    assert_rms("wang-su-li", |a| (1.0 - a) / (1.0 + a));
    assert_rms("keller-1986", |a| (1.0 - 2.0 * a).max(0.0));
    assert_rms("walton", |a| (1.0 - 2.0 * a).max(-0.44));
    assert_rms("whittaker-uncapped", |a| 1.0 - 2.0 * a);
    assert_rms("smith-1991", |a| match a <= 0.5 {
        true => 1.0 - 2.0 * a,
        false => a - (a * a + 2.0 * a - 1.0).sqrt(),
    });
}

/// By the pendulum itself, in floats of the angles, without the file and its reader.
#[test]
fn the_puzzle_is_kanes_pendulum() {
    for restitution in [0.5, 0.7] {
        let direction = |degrees: f64| {
            let (sin, cos) = degrees.to_radians().sin_cos();
            Direction { cos, sin }
        };
        let pendulum = DoublePendulum {
            mass: 1.0,
            length: 1.0,
            angles: [direction(20.0), direction(30.0)],
            before: [-0.1, -0.2],
            friction: 0.5,
            restitution,
        };
        let ratio = pendulum.collide(&KaneLevinson).expect("it collides").energy_ratio;
        let row = PAGE.lines().find(|line| line.starts_with("| [kane-levinson]"));
        assert!(row.is_some_and(|row| row.contains(&format!("**{ratio:.2}**"))), "{ratio}");
    }
}

/// As readers of Markdown on the web make them.
fn anchors(text: &str) -> BTreeSet<String> {
    let headings = text.lines().filter(|line| line.starts_with('#'));
    let slug = |line: &str| {
        let words = line.trim_start_matches('#').trim().to_lowercase();
        let kept = words.chars().filter(|c| c.is_alphanumeric() || " -_".contains(*c));
        kept.map(|c| if c == ' ' { '-' } else { c }).collect()
    };
    headings.map(slug).collect()
}

#[test]
fn every_link_of_the_page_leads_somewhere() {
    let targets: BTreeSet<&str> =
        PAGE.split("](").skip(1).filter_map(|rest| rest.split(')').next()).collect();
    assert!(targets.len() > 50, "{}", targets.len());
    for target in targets {
        let (path, place) = target.split_once('#').unwrap_or((target, ""));
        let text = fs::read_to_string(root().join("docs").join(path));
        let text = text.unwrap_or_else(|error| unreachable!("{target}: {error}"));
        let line = place.strip_prefix('L').and_then(|line| line.parse::<usize>().ok());
        let leads = match line {
            Some(line) => (1..=text.lines().count()).contains(&line),
            None => place.is_empty() || anchors(&text).contains(place),
        };
        assert!(leads, "{target}");
    }
}
