//! (d) Reality: laws against measured spheres.

use std::fmt::Write as _;

use kane::figures::experiment::{self, Point};
use kane::impact::compliant::{Compliance, MawBarberFawcett, Process as _};
use kane::impact::{Alpha, Law, law, laws};
use kane::report::site::Fit;

use super::cells::Cells;
use super::{groups, law_link, signed};
use crate::NotMade;

/// k of a law over α in floats; `None` where it has none.
fn k(law: &Law, alpha: f64) -> Option<f64> {
    Some(law.over::<f64>().ratios(&Alpha::Finite(alpha))?.k)
}

/// How far values are from measured ones, root of the mean square.
fn rms<'a>(pairs: impl Iterator<Item = (&'a Point, f64)>) -> f64 {
    let squares: Vec<f64> = pairs.map(|(point, k)| (k - point.k).powi(2)).collect();
    let count = u32::try_from(squares.len()).map_or(f64::NAN, f64::from);
    (squares.iter().sum::<f64>() / count).sqrt()
}

/// The μ with which a law, whose k falls with α, meets a point; `None` if none does.
fn friction_needed(law: &Law, point: &Point) -> Option<f64> {
    let (mut low, mut high) = (1e-6, 1e6);
    if k(law, low)? < point.k || point.k < k(law, high)? {
        return None;
    }
    for _ in 0..200 {
        let middle = f64::midpoint(low, high);
        if k(law, middle)? > point.k { low = middle } else { high = middle }
    }
    // a law that jumps over the value does not meet it
    let met = (k(law, low)? - point.k).abs() < 1e-6;
    met.then(|| experiment::FRICTION * low / point.alpha)
}

/// A way to k: the laws that say so, `None` for the half-space, and k at every point.
struct Way {
    laws: Vec<&'static str>,
    at: Vec<f64>,
}

impl Way {
    fn name(&self) -> String {
        let links: Vec<String> = self.laws.iter().map(|id| law_link(id)).collect();
        match links.is_empty() {
            true => "elastic half-space, fitted to nothing".to_owned(),
            false => links.join(", "),
        }
    }

    /// The same for one who has read the whole name.
    fn short_name(&self) -> String {
        let first = self.laws.first().map_or_else(String::new, |id| law_link(id));
        match self.laws.len() {
            0 | 1 => first,
            n => format!("{first} and the {} beside it", n - 1),
        }
    }
}

/// The laws that answer at every point, those with the same answers together.
fn of_laws(points: &[Point]) -> Vec<Way> {
    let at = |law: &Law| points.iter().map(|point| k(law, point.alpha)).collect::<Option<Vec<_>>>();
    let known = laws().iter().filter(|law| law.invented().is_empty());
    let (names, values): (Vec<&str>, Vec<Vec<f64>>) =
        known.filter_map(|law| Some((law.info.id, at(law)?))).unzip();
    groups(&names, &values).into_iter().map(|(laws, at)| Way { laws, at }).collect()
}

/// The elastic half-space with the materials of the experiment.
fn half_space(points: &[Point]) -> Result<(Compliance, Way), NotMade> {
    let because = |error: &dyn std::fmt::Display| NotMade::because("verdict.md", error);
    let compliance = experiment::compliance().map_err(|error| because(&error))?;
    let process = MawBarberFawcett::new(compliance);
    let k = |point: &Point| {
        let outcome = process.outcome(&Alpha::Finite(point.alpha));
        outcome.map(|outcome| outcome.ratios.k).map_err(|error| because(&error))
    };
    let at = points.iter().map(k).collect::<Result<_, _>>()?;
    Ok((compliance, Way { laws: Vec::new(), at }))
}

/// What the section says, and what the choice of a law needs of it.
pub(super) struct Reality {
    pub(super) text: String,
    /// the α up to which the half-space slides all the time
    pub(super) slides: f64,
    /// rms of k of the half-space
    pub(super) half_space: f64,
    /// the least that any law has where it slides all the time
    pub(super) sliding: f64,
}

/// The section.
pub(super) fn section(cells: Cells<'_>) -> Result<Reality, NotMade> {
    let [observed, ..] = experiment::observed();
    let points = observed.points;
    let (compliance, elastic) = half_space(&points)?;
    let slides = compliance.sliding_until();
    let of = |way: &Way| rms(points.iter().zip(way.at.iter().copied()));
    let of_sliding = |way: &Way| {
        let pairs = points.iter().zip(way.at.iter().copied());
        rms(pairs.filter(|(point, _)| point.alpha <= slides))
    };
    let half_space = of(&elastic);
    let mut ways = of_laws(&points);
    let sliding = ways.iter().map(of_sliding).fold(f64::INFINITY, f64::min);
    ways.push(elastic);
    let mut order: Vec<&Way> = ways.iter().collect();
    order.sort_by(|a, b| of(a).total_cmp(&of(b)));

    let mut out = format!(
        "## Reality\n\nSpheres of alumina on glass, {} angles ([data](data/kharaz-2001-restitution.csv), [where from](data/kharaz-2001.md), [figure](figures/slip-over-alpha.svg)), e = {}, μ = {}. How far k is from what was measured, as the root of the mean square; over the points that slide all the time, α ≤ {slides:.3}; at worst, and at which α:\n\n| by | rms of k | where it slides | worst | at α |\n|---|---|---|---|---|\n",
        points.len(),
        experiment::RESTITUTION,
        experiment::FRICTION,
    );
    for way in &order {
        let pairs = || points.iter().zip(way.at.iter().copied());
        let worst = pairs().max_by(|a, b| (a.1 - a.0.k).abs().total_cmp(&(b.1 - b.0.k).abs()));
        let (point, k) = worst.ok_or_else(|| NotMade::because("verdict.md", "no points"))?;
        let _ = writeln!(
            out,
            "| {} | {:.3} | {:.3} | {} | {:.2} |",
            way.name(),
            of(way),
            of_sliding(way),
            signed(k - point.k, 2),
            point.alpha
        );
    }
    out.push_str(&by_the_median());
    let keep = cells.laws_with(&["energy-sphere", "cone-sphere"]);
    out.push_str(&needed(&points, &order, &keep));
    Ok(Reality { text: out, slides, half_space, sliding })
}

/// What the site tells of the same laws by another measure, by which another is nearest.
fn by_the_median() -> String {
    let fits = experiment::fits(laws());
    let of = |fit: &Fit| {
        let names: Vec<String> = fit.laws.iter().map(|id| law_link(id)).collect();
        format!("{} {:.2}", names.join(", "), fit.median)
    };
    let first: Vec<String> = fits.iter().take(3).map(of).collect();
    format!(
        "\n`kane site` tells the median distance of k instead, over all points of four series. A few points that are far off do not move it, so that others are nearest: {}.\n",
        first.join("; ")
    )
}

/// The μ that the laws need which keep energy and cone.
fn needed(points: &[Point], ways: &[&Way], keep: &[&str]) -> String {
    let mut out = format!(
        "\nA law of the right form needs the same μ at every point, {}. What each law that keeps energy and cone on a sphere would need (–: no μ will do):\n\n| by ",
        experiment::FRICTION
    );
    for point in points.iter().rev() {
        let _ = write!(out, "| α = {:.2} ", point.alpha);
    }
    let _ = writeln!(out, "|\n|---{}|", "|---".repeat(points.len()));
    for way in ways {
        let Some(law) = way.laws.first().and_then(|id| law(id)) else { continue };
        if !way.laws.iter().any(|id| keep.contains(id)) {
            continue;
        }
        let found = points.iter().rev().map(|point| friction_needed(law, point));
        let cells = found.map(|mu| mu.map_or("–".to_owned(), |mu| format!("{mu:.3}")));
        let _ =
            writeln!(out, "| {} | {} |", way.short_name(), cells.collect::<Vec<_>>().join(" | "));
    }
    out
}
