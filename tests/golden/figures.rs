//! The figures in `docs/figures`: their bytes, and that they show what the laws say.

use std::sync::OnceLock;

use kane::figures::{experiment, figures};
use kane::impact::{Alpha, Law, Ratios, laws};
use kane::measure::over_alpha;
use kane::number::{Algebraic, Number as _, Ordered as _};
use kane::report::figures::{Content, Figure, Kind, Series, Zone, csv, svg};

use crate::assert_kept;

/// All figures, drawn once for all tests.
fn all() -> &'static [Figure] {
    static ALL: OnceLock<Vec<Figure>> = OnceLock::new();
    ALL.get_or_init(|| figures(&mut |_, _| {}).expect("the half-space settles"))
}

fn figure(stem: &str) -> &'static Figure {
    all().iter().find(|figure| figure.stem == stem).expect("it is drawn")
}

fn curves(stem: &str) -> (&'static [Series], &'static [Zone]) {
    match &figure(stem).content {
        Content::Curves { series, zones } => (series, zones),
        Content::Map(_) => unreachable!("{stem} has no curves"),
    }
}

#[test]
fn the_figures_in_the_documentation_are_those_that_are_drawn() {
    for figure in all() {
        let picture = svg(figure);
        assert_eq!(picture, svg(figure), "the same in every run");
        assert!(picture.len() < 64 * 1024, "{}: {} bytes", figure.stem, picture.len());
        for (ending, text) in [("svg", picture), ("csv", csv(figure))] {
            assert_kept(&format!("docs/figures/{}.{ending}", figure.stem), &text);
        }
    }
}

/// A figure, and the quantity that it shows.
type Shown = (&'static str, fn(&Ratios<f64>) -> f64);

/// k, `i_x` and μ′ of a law in floats, a way that shares neither number system nor rounding with the
/// figures, whose values are exact until they are rounded.
struct Compared(usize);

impl Compared {
    fn visit(&mut self, law: &Law) {
        let of: [Shown; 3] = [
            ("slip-over-alpha", |r| r.k),
            ("impulse-over-alpha", |r| r.impulse),
            ("friction-over-alpha", |r| experiment::FRICTION * r.impulse),
        ];
        for (stem, value) in of {
            let (series, _) = curves(stem);
            let mut lines = series.iter().filter(|one| one.names.iter().any(|n| n == law.info.id));
            let Some(line) = lines.next() else {
                let at = |alpha| law.over().ratios(&Alpha::Finite(alpha)).is_none();
                assert!(at(0.1) && at(1.0) && at(10.0), "{} is missing", law.info.id);
                continue;
            };
            assert!(lines.next().is_none(), "{} is drawn once", law.info.id);
            for (alpha, drawn) in &line.points {
                let computed = law.over().ratios(&Alpha::Finite(*alpha)).as_ref().map(value);
                // docstrings state at most 7 ulp; forming k of terms up to 1 + 2α adds three at most
                let size = drawn.map_or(0.0, f64::abs).max(1.0 + 2.0 * alpha);
                let tolerance = 10.0 * f64::EPSILON * size;
                let agree = match (drawn, computed) {
                    (Some(a), Some(b)) => (a - b).abs() <= tolerance,
                    (None, None) => true,
                    _ => false,
                };
                assert!(agree, "{} at {alpha}: {drawn:?}, {computed:?}", law.info.id);
                self.0 += 1;
            }
        }
    }
}

#[test]
fn every_curve_is_what_its_law_says() {
    let mut compared = Compared(0);
    for law in laws() {
        compared.visit(law);
    }
    assert!(compared.0 > 18 * 3 * 100, "{} points", compared.0);
}

/// Energy rises exactly where a curve is strictly inside the zone, by the sign of Δe in exact numbers;
/// and the other zone is where `i_x` leaves [−1, 1].
#[test]
fn the_zones_are_where_energy_grows_and_where_the_cone_ends() {
    let laws = over_alpha(laws());
    let one = Algebraic::from_rational(&kane::number::parse("1").expect("a literal"));
    let mut inside = [0, 0];
    for stem in ["slip-over-alpha", "impulse-over-alpha", "friction-over-alpha"] {
        let (series, zones) = curves(stem);
        for (line, curve) in series.iter().zip(&laws.curves) {
            assert_eq!(line.names, curve.laws);
            for (index, ratios) in curve.ratios.iter().enumerate() {
                let Some(ratios) = ratios else { continue };
                let y = line.points[index].1.expect("it has a value");
                let beyond = |zone: &Zone| {
                    zone.borders.iter().any(|border| {
                        let (alpha, at) = border.points[index];
                        assert_eq!(alpha, line.points[index].0);
                        if border.is_zone_above { y > at } else { y < at }
                    })
                };
                let grows = ratios.energy.sign().is_greater() == Some(true);
                let leaves = ratios.impulse > one || ratios.impulse < -one.clone();
                // a value and a border that differ by less than a rounding would look equal
                assert_eq!(
                    [beyond(&zones[0]), beyond(&zones[1])],
                    [grows, leaves],
                    "{stem} {index}"
                );
                inside[0] += usize::from(grows);
                inside[1] += usize::from(leaves);
            }
        }
    }
    assert!(inside.iter().all(|count| *count > 50), "{inside:?}");
}

/// The grouping is found on a grid; that it holds everywhere is proved in the laws' page. Here: laws of
/// one line state the same k, and those of different lines differ somewhere.
#[test]
fn laws_that_share_a_line_share_their_formula() {
    let page = include_str!("../../docs/laws.md");
    let formula = |id: &str| {
        let row = page.lines().find(|line| line.starts_with(&format!("| [`{id}`]")));
        let cell = row.and_then(|row| row.split(" | ").nth(2)).expect("it is in the table");
        // with their default parameters
        match cell.trim_matches('`') {
            "1 − 2·share·α" => "1 − 2·α".to_owned(),
            "max(−e_t, 1 − 2·α)" => "max(0, 1 − 2·α)".to_owned(),
            other => other.to_owned(),
        }
    };
    let (series, _) = curves("slip-over-alpha");
    let laws: Vec<&Series> = series.iter().filter(|one| one.kind == Kind::Law).collect();
    for line in &laws {
        let first = formula(&line.names[0]);
        assert!(line.names.iter().all(|id| formula(id) == first), "{:?}", line.names);
    }
    let shared = laws.iter().find(|line| line.names.len() > 1).expect("some coincide");
    assert!(shared.names.contains(&"keller-1986".to_owned()) && laws.len() < 12);
}

/// A planted error in the data of a curve changes picture and table.
#[test]
fn a_changed_point_changes_the_bytes() {
    let figure = figure("model-error");
    let mut planted = figure.clone();
    let Content::Curves { series, .. } = &mut planted.content else { panic!("it has curves") };
    let point = &mut series[0].points[20];
    point.1 = point.1.map(|y| y + 0.1);
    assert_ne!(csv(figure), csv(&planted));
    assert_ne!(svg(figure), svg(&planted));
}

/// The measured points are all in the tables, those beyond the axes too, and the notes count these.
#[test]
fn no_measured_point_is_lost() {
    let points: usize = experiment::observed().iter().map(|one| one.points.len()).sum();
    for stem in ["slip-over-alpha", "impulse-over-alpha", "friction-over-alpha"] {
        let (series, _) = curves(stem);
        let measured: Vec<usize> =
            (1..).zip(series).filter(|(_, s)| s.kind == Kind::Measured).map(|(n, _)| n).collect();
        let table = csv(figure(stem));
        let is_measured = |line: &&str| measured.iter().any(|n| line.starts_with(&format!("{n},")));
        assert_eq!(table.lines().filter(is_measured).count(), points);
    }
}
