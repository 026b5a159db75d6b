//! What all reports come to, in ten sentences that are counted from their data.

use kane_audit::Verdict;
use kane_matrix::{Finding, Row};

use super::{Fit, Site};
use crate::chart::{Reading, readings, timed};
use crate::figures::Content;
use crate::matrix::{breaking, conflicts};
use crate::sheet::Words;
use crate::stability::Strips;
use crate::{Report, Summary};

/// A finding: what it is about, in a word or two, and a sentence.
pub(super) type Told = (&'static str, Words);

/// The findings, those that there is something to say of.
pub(super) fn findings(site: &Site<'_>) -> Vec<Told> {
    let mut all: Vec<Told> = Vec::new();
    if let Some((stem, paper)) = site.audits.first() {
        let page = format!("derivations/{stem}.html");
        all.push(("The paper", Words::link("The paper", page) + claims(paper)));
        all.push(("As printed", printed(paper)));
    }
    all.push(("Derivations", others(site)));
    let matrix = site.matrix.matrix;
    all.push(("Laws", Words::link(breaking(matrix), "laws.html") + "."));
    all.push(("Conflicts", Words::from(conflicts(matrix).join("; ")) + "."));
    all.push(("Energy", energy(site)));
    let readings = readings(&timed(&site.chart));
    all.push(("Speed", speed(&readings)));
    all.push(("Rewriting", rewriting(&readings)));
    all.push((
        "Floats",
        Words::link(Strips::of(&site.stability).reading(), "stability.html") + ".",
    ));
    all.push(("Experiment", experiment(site.fits)));
    all.retain(|(_, words)| !words.plain().trim_end_matches('.').is_empty());
    all
}

/// `: of 179 claims 149 are proved, …; every verdict is as expected.`
fn claims(report: &Report<'_>) -> String {
    let summary = Summary::of(report);
    format!(
        ": of {} claims {}; {}.",
        summary.claims,
        fared(&summary.verdicts),
        summary.expectation()
    )
}

fn fared(verdicts: &[(Verdict, usize)]) -> String {
    let parts: Vec<String> = verdicts.iter().map(|(verdict, n)| format!("{n} {verdict}")).collect();
    listed(&parts)
}

/// `a, b and c`.
fn listed(parts: &[String]) -> String {
    match parts {
        [] => "none".to_owned(),
        [one] => one.clone(),
        [all @ .., last] => format!("{} and {last}", all.join(", ")),
    }
}

fn printed(paper: &Report<'_>) -> Words {
    let summary = Summary::of(paper);
    let wrong = &summary.refuted_as_printed;
    let equations = summary.equations;
    match wrong.len() {
        0 => Words::from(format!("None of its {equations} numbered equations is refuted.")),
        n => {
            let are = if n == 1 { "is" } else { "are" };
            Words::from(format!(
                "Of its {equations} numbered equations {n} {are} refuted as printed: "
            )) + listed(wrong)
                + "."
        }
    }
}

fn others(site: &Site<'_>) -> Words {
    let others = site.audits.get(1..).unwrap_or_default();
    if others.is_empty() {
        return Words::default();
    }
    let summaries: Vec<Summary> = others.iter().map(|(_, report)| Summary::of(report)).collect();
    let mut verdicts: Vec<(Verdict, usize)> = Vec::new();
    for (verdict, n) in summaries.iter().flat_map(|summary| &summary.verdicts) {
        match verdicts.iter_mut().find(|(known, _)| known == verdict) {
            Some((_, sum)) => *sum += n,
            None => verdicts.push((*verdict, *n)),
        }
    }
    let claims: usize = summaries.iter().map(|summary| summary.claims).sum();
    let surprises: usize = summaries.iter().map(|summary| summary.surprises.len()).sum();
    let expected = match surprises {
        0 => "every verdict is as expected".to_owned(),
        n => format!("{n} are NOT as expected"),
    };
    let (documents, have) = match others.len() {
        1 => ("1 other derivation".to_owned(), "has"),
        n => (format!("{n} other derivations"), "have"),
    };
    Words::link(documents, "index.html#derivations")
        + format!(" {have} {claims} claims: {}; {expected}.", fared(&verdicts))
}

/// Which laws create energy on some planar contact, in which friction alone does, and in how many Kane's pendulum gains
/// some.
fn energy(site: &Site<'_>) -> Words {
    let matrix = site.matrix.matrix;
    if !matrix.properties.iter().any(|property| property.group == "energy") {
        return Words::default();
    }
    let found = |row: &Row, id: &str| {
        let column = matrix.properties.iter().position(|property| property.id == id)?;
        row.cells.get(column).map(|cell| cell.finding)
    };
    let laws = |is_meant: &dyn Fn(&Row) -> bool| -> Vec<String> {
        let meant = matrix.rows.iter().filter(|row| is_meant(row));
        meant.map(|row| row.law.info.id.to_owned()).collect()
    };
    // a law that says nothing of contacts that couple is asked on a sphere alone, which is a planar contact, too
    let totals = ["energy-sphere", "energy"];
    let creators = laws(&|row| totals.iter().any(|id| found(row, id) == Some(Finding::Refuted)));
    let by_friction = laws(&|row| {
        found(row, "energy-tangential") == Some(Finding::Refuted)
            && totals.iter().all(|id| found(row, id) == Some(Finding::Proved))
    });
    let friction = match by_friction.is_empty() {
        true => String::new(),
        false => format!(
            "; in {} friction does, though the collision as a whole does not",
            listed(&by_friction)
        ),
    };
    let map = site.figures.iter().find_map(|figure| match &figure.content {
        Content::Map(panels) => Some(panels),
        Content::Curves { .. } => None,
    });
    let pendulum = map.map_or(0, |panels| {
        panels.iter().filter(|panel| panel.case[0] == "double pendulum").count()
    });
    let gains = match pendulum {
        0 => Words::from("."),
        n => {
            Words::from(format!("; in Kane's double pendulum {n} laws gain energy at "))
                + Words::link("some friction and restitution", "figures.html#energy-map")
                + "."
        }
    };
    let all = matrix.rows.len();
    Words::from(format!(
        "{} of {all} laws create energy on some planar contact: {}",
        creators.len(),
        listed(&creators)
    )) + friction
        + gains
}

/// What f64, double-double and exact fractions cost.
fn speed(readings: &[Reading]) -> Words {
    let told: Vec<String> =
        readings.iter().filter(|reading| !reading.is_wrong).map(Reading::sentence).collect();
    match told.is_empty() {
        true => Words::default(),
        false => Words::link("The price of a digit", "chart.html") + ": " + told.join("; ") + ".",
    }
}

/// What an equal formula loses.
fn rewriting(readings: &[Reading]) -> Words {
    let wrong = readings.iter().find(|reading| reading.is_wrong);
    wrong.map_or_else(Words::default, |reading| {
        Words::from(format!("The same k by another formula: {}.", reading.sentence()))
    })
}

/// Which law is nearest to what was measured, and how far the paper's is.
fn experiment(fits: &[Fit]) -> Words {
    let Some(best) = fits.first() else { return Words::default() };
    let names = |fit: &Fit| listed(&fit.laws.iter().map(|id| (*id).to_owned()).collect::<Vec<_>>());
    let paper = fits.iter().find(|fit| fit.laws.contains(&"wang-su-li"));
    let paper = match paper {
        Some(paper) if paper != best => format!("; the paper's law is {:.2} off", paper.median),
        _ => String::new(),
    };
    // by another measure another law may be nearest
    let off = format!(
        " {} is nearest by the median distance of k over all points, {:.2}{paper}. docs/verdict.md measures one series \
         of them by the root of the mean square.",
        names(best),
        best.median
    );
    Words::from("Of rigid laws with their default parameters beside ")
        + Words::link("measured spheres", "figures.html#slip-over-alpha")
        + off
}

#[cfg(test)]
mod tests {
    use kane_audit::{Audit, Options, audit, read};
    use kane_impact::laws;
    use kane_matrix::{Matrix, PROPERTIES};
    use kane_measure::growth::Growth;
    use kane_measure::{Stability, Subject};

    use super::*;
    use crate::chart::ChartReport;
    use crate::figures::{Axis, Figure, Panel};
    use crate::growth::GrowthReport;
    use crate::matrix::MatrixReport;
    use crate::matrix::made_up::matrix_of;
    use crate::stability::StabilityReport;

    /// A matrix of properties with these ids.
    fn matrix(ids: &[&str], rows: &[&str]) -> Matrix {
        let property =
            |id: &&str| PROPERTIES.iter().find(|p| p.id == *id).expect("there is one of this id");
        matrix_of(ids.iter().map(property).collect(), rows)
    }

    fn judged(statements: &str) -> Audit {
        let text = format!("# T\n\n```kane\nvar x\n{statements}```\n");
        let document = read("made-up.md", text.as_bytes()).expect("it is well formed");
        audit(document, &Options::default(), &mut |_, _| {})
    }

    fn id(law: usize) -> &'static str {
        laws()[law].info.id
    }

    fn axis() -> Axis {
        let label = String::new();
        Axis { symbol: "x", label, range: (0.0, 1.0), ticks: Vec::new(), is_logarithmic: false }
    }

    fn figure(content: Content) -> Figure {
        let (title, notes) = (String::new(), Vec::new());
        Figure { stem: "energy-map", title, notes, x: axis(), y: axis(), content }
    }

    fn map(cases: &[[&str; 2]]) -> Figure {
        let panel = |case: &[&str; 2]| Panel {
            case: case.map(str::to_owned),
            stretches: Vec::new(),
            marks: Vec::new(),
            is_marked: false,
        };
        figure(Content::Map(cases.iter().map(panel).collect()))
    }

    /// What is said of a site of these parts, under what it is about.
    fn told(
        audits: &[Audit],
        matrix: &Matrix,
        figures: &[Figure],
        fits: &[Fit],
    ) -> Vec<(&'static str, String)> {
        let stability = Stability {
            name: String::new(),
            title: None,
            subject: Subject {
                formulas: Vec::new(),
                examined: 0,
                own: 0,
                left_out: Vec::new(),
                equal: Vec::new(),
            },
            lines: Vec::new(),
            planes: Vec::new(),
            searches: Vec::new(),
        };
        let growth = Growth { batches: Vec::new(), chains: Vec::new(), families: Vec::new() };
        let command = String::new;
        let audits = audits.iter().enumerate();
        let site = Site {
            audits: audits.map(|(n, a)| (format!("paper-{n}"), Report::new(a, ""))).collect(),
            matrix: MatrixReport { matrix, command: command() },
            laws: "",
            chart: ChartReport { all: &[], machine: command(), command: command() },
            stability: StabilityReport { stability: &stability, accounts: &[], command: command() },
            growth: GrowthReport { growth: &growth, machine: command(), command: command() },
            figures,
            fits,
            collisions: Vec::new(),
            scenes: Vec::new(),
            command: command(),
        };
        findings(&site).into_iter().map(|(head, words)| (head, words.plain())).collect()
    }

    fn of(head: &str, all: &[(&'static str, String)]) -> Option<String> {
        all.iter().find(|(known, _)| *known == head).map(|(_, words)| words.clone())
    }

    #[test]
    fn of_the_first_paper_and_of_the_others_the_verdicts_are_counted() {
        let paper =
            judged("claim (1): x^2 >= 0\nclaim (2): x > 0 expect refuted\nclaim a: x > 1\n");
        let second = judged("claim (1): x^2 >= 0\nclaim (2): x > 0\n");
        let third = judged("claim b: x^2 + 1 > 0\nclaim c: x > 0 expect refuted\nclaim e: x > 3\n");
        let nothing = matrix(&[], &[]);
        let all = told(&[paper, second, third], &nothing, &[], &[]);
        assert_eq!(
            of("The paper", &all).as_deref(),
            Some("The paper: of 3 claims 1 proved and 2 refuted; 1 NOT PROVED: a.")
        );
        assert_eq!(
            of("As printed", &all).as_deref(),
            Some("Of its 2 numbered equations 1 is refuted as printed: (2).")
        );
        // (2) of the second, and e, are not as expected
        assert_eq!(
            of("Derivations", &all).as_deref(),
            Some(
                "2 other derivations have 5 claims: 2 proved and 3 refuted; 2 are NOT as expected."
            )
        );
        let sound = || judged("claim (1): x^2 >= 0\nclaim (2): x^2 + 1 > 0\n");
        let all = told(&[sound(), sound()], &nothing, &[], &[]);
        assert_eq!(
            of("The paper", &all).as_deref(),
            Some("The paper: of 2 claims 2 proved; every claim is proved.")
        );
        assert_eq!(
            of("As printed", &all).as_deref(),
            Some("None of its 2 numbered equations is refuted.")
        );
        assert_eq!(
            of("Derivations", &all).as_deref(),
            Some("1 other derivation has 2 claims: 2 proved; every verdict is as expected.")
        );
        let wrong = judged("claim (1): x > 0\nclaim (2): x > 2\nclaim (3): x > 1\n");
        let all = told(&[wrong], &nothing, &[], &[]);
        assert_eq!(
            of("As printed", &all).as_deref(),
            Some("Of its 3 numbered equations 3 are refuted as printed: (1), (2) and (3).")
        );
        assert_eq!(of("Derivations", &all), None);
    }

    #[test]
    fn laws_that_create_energy_are_told_from_those_in_which_friction_alone_does() {
        let ids = ["energy-sphere", "energy", "energy-tangential"];
        let of_rows = |rows: &[&str], figures: &[Figure]| {
            of("Energy", &told(&[], &matrix(&ids, rows), figures, &[]))
        };
        let rows = ["yyn", "ynn", "n--", "yyy", "y-n"];
        let expected = format!(
            "2 of 5 laws create energy on some planar contact: {} and {}; in {} friction does, though the collision as a \
             whole does not.",
            id(1),
            id(2),
            id(0)
        );
        assert_eq!(of_rows(&rows, &[]), Some(expected));
        assert_eq!(
            of_rows(&["yyy", "yy-"], &[]).as_deref(),
            Some("0 of 2 laws create energy on some planar contact: none.")
        );
        let cases = [["double pendulum", "a"], ["rod tip", "a"], ["double pendulum", "b"]];
        let curves = figure(Content::Curves { series: Vec::new(), zones: Vec::new() });
        let figures = [curves, map(&cases)];
        assert_eq!(
            of_rows(&["yyy"], &figures).as_deref(),
            Some(
                "0 of 1 laws create energy on some planar contact: none; in Kane's double pendulum 2 laws gain energy at \
                 some friction and restitution."
            )
        );
        // where nothing was asked of energy nothing is said of it
        let other = matrix(&["momentum"], &["n"]);
        assert_eq!(of("Energy", &told(&[], &other, &figures, &[])), None);
    }

    #[test]
    fn the_nearest_law_is_told_and_how_far_the_paper_s_is() {
        let fit = |laws: &[&'static str], median| Fit { laws: laws.to_vec(), median };
        let nothing = matrix(&[], &[]);
        let told = |fits: &[Fit]| of("Experiment", &told(&[], &nothing, &[], fits));
        let head = "Of rigid laws with their default parameters beside measured spheres ";
        let tail = ". docs/verdict.md measures one series of them by the root of the mean square.";
        let by = "nearest by the median distance of k over all points, ";
        assert_eq!(
            told(&[fit(&["a", "b"], 0.123), fit(&["wang-su-li"], 0.456)]),
            Some(format!("{head}a and b is {by}0.12; the paper's law is 0.46 off{tail}"))
        );
        assert_eq!(
            told(&[fit(&["wang-su-li"], 0.2), fit(&["a"], 0.3)]),
            Some(format!("{head}wang-su-li is {by}0.20{tail}"))
        );
        assert_eq!(told(&[]), None);
    }

    #[test]
    fn what_digits_cost_is_told_apart_from_what_is_wrong() {
        use crate::chart::{ChartReport, readings, timed};
        use kane_measure::chart::{Accuracy, Measured, Time, registry};
        let measured = |worst, picoseconds| {
            let mut method = registry().remove(0);
            (method.law, method.name, method.text) = ("law", "law", "1");
            method.system = kane_number::System::F64;
            let (median, quartiles) = (picoseconds, (picoseconds, picoseconds));
            Measured {
                method,
                accuracy: Accuracy {
                    worst,
                    median: worst,
                    at: 0.5,
                    ulps: None,
                    greatest: 1.0,
                    tried: 9,
                },
                cost: None,
                proved: None,
                time: Some(Time { median, quartiles, rounds: 3 }),
            }
        };
        let told = |all: &[Measured]| {
            let chart = ChartReport { all, machine: String::new(), command: String::new() };
            let readings = readings(&timed(&chart));
            [speed(&readings), rewriting(&readings)].map(|words| words.plain())
        };
        let right = "The price of a digit: f64, the law's code: 15.9 digits in 3.00 ns.";
        let wrong = "The same k by another formula: f64, rewritten, the law's code: no digit is right, in 1.00 ns.";
        assert_eq!(told(&[measured(1590, 3_000), measured(0, 1_000)]), [right, wrong]);
        assert_eq!(told(&[measured(1590, 3_000)]), [right, ""]);
        assert_eq!(told(&[measured(0, 1_000)]), ["", wrong]);
    }
}
