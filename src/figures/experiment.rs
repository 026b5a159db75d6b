//! Measured collisions of spheres, in the paper's variables.
//!
//! A. H. Kharaz, D. A. Gorham and A. D. Salman, Powder Technol. 120 (2001) 281–291: spheres of
//! alumina on thick soda-lime glass, without spin before. The original was not consulted; the files in
//! `docs/data` say who digitised which points. These are good to one or two per cent, and
//! k = 1 − 7/2·(1 − `e_t`) magnifies that by 3.5, so that the first two or three points of a series,
//! and those near grazing, are weak.

use kane_impact::InvalidInput;
use kane_impact::compliant::{Compliance, Elastic};
use kane_impact::{Alpha, Law};
use kane_report::site::Fit;

/// e, the coefficient of normal restitution.
pub const RESTITUTION: f64 = 0.98;
/// μ, Coulomb's coefficient.
pub const FRICTION: f64 = 0.092;
/// The radius; m.
pub const RADIUS: f64 = 0.0025;
/// The share of what was measured that a point is taken to be off: one per cent. The points as digitised tell no
/// errors; [`hands_differ`] says how far two readings of one figure are apart.
pub const READING: f64 = 0.01;
/// The speed before; m/s.
pub const SPEED: f64 = 3.9;

/// A measured collision.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// The angle of incidence from the normal, degrees.
    pub degrees: f64,
    /// α = 7/4·μ·(1 + e)/tan θ; see [`alpha`].
    pub alpha: f64,
    /// k, from what was measured.
    pub k: f64,
    /// By how much k moves where what was measured moves by [`READING`].
    pub bar: f64,
}

impl Point {
    /// `i_x` = (1 − k)/(2α), the paper's (9).
    #[must_use]
    pub fn impulse(&self) -> f64 {
        (1.0 - self.k) / (2.0 * self.alpha)
    }

    /// The point with k moved by its bar, up and down.
    #[must_use]
    pub fn ends(&self) -> [Self; 2] {
        [Self { k: self.k + self.bar, ..*self }, Self { k: self.k - self.bar, ..*self }]
    }
}

/// The points of one observable.
#[derive(Clone, Debug, PartialEq)]
pub struct Observed {
    /// What was measured.
    pub name: &'static str,
    /// The points, by angle.
    pub points: Vec<Point>,
}

/// α = 7/4·μ·(1 + e)/tan θ of a solid sphere, the paper's (7) without spin before; θ in degrees from
/// the normal, above 0. In floats, *heuristic*.
#[must_use]
pub fn alpha(degrees: f64) -> f64 {
    1.75 * FRICTION * (1.0 + RESTITUTION) / degrees.to_radians().tan()
}

/// The four series, each from an observable of its own or by another hand.
#[must_use]
pub fn observed() -> [Observed; 4] {
    macro_rules! data {
        ($name:literal) => {
            include_str!(concat!("../../docs/data/kharaz-2001-", $name, ".csv"))
        };
    }
    let series = |name, table, to_k| Observed { name, points: points(table, to_k) };
    [
        series("tangential restitution of the centre", data!("restitution"), by_restitution),
        series(
            "tangential restitution of the centre, digitised by others",
            data!("restitution-second"),
            by_restitution,
        ),
        series("spin after", data!("spin"), by_spin),
        series("direction of the contact point after", data!("contact"), by_recoil),
    ]
}

/// By how much of its value at most two hands that digitised one figure read the tangential restitution differently,
/// at angles that they read within half a degree. In floats, *heuristic*.
#[must_use]
pub fn hands_differ() -> f64 {
    let [first, second, ..] = observed();
    let e_t = |point: &Point| 1.0 - (1.0 - point.k) / 3.5;
    let pairs = first.points.iter().flat_map(|a| second.points.iter().map(move |b| (a, b)));
    let near = pairs.filter(|(a, b)| (a.degrees - b.degrees).abs() < 0.5);
    near.map(|(a, b)| (e_t(a) / e_t(b) - 1.0).abs()).fold(0.0, f64::max)
}

/// How far the laws are from the measured points: the median distance of k, the nearest law first. Laws that are
/// equally far at every point share an entry; those that do not depend on α alone, or have no answer at a point, have
/// none. In floats, *heuristic*.
#[must_use]
pub fn fits(laws: &[Law]) -> Vec<Fit> {
    let points: Vec<Point> = observed().into_iter().flat_map(|one| one.points).collect();
    let mut found: Vec<(Vec<f64>, Fit)> = Vec::new();
    for law in laws {
        let distance = |point: &Point| {
            let ratios = law.over::<f64>().ratios(&Alpha::Finite(point.alpha))?;
            Some((ratios.k - point.k).abs())
        };
        let Some(mut distances) = points.iter().map(distance).collect::<Option<Vec<f64>>>() else {
            continue;
        };
        distances.sort_by(f64::total_cmp);
        // laws that are one on a sphere differ in their last digits
        let known = found
            .iter_mut()
            .find(|(other, _)| other.iter().zip(&distances).all(|(a, b)| (a - b).abs() < 1e-9));
        match known {
            Some((_, fit)) => fit.laws.push(law.info.id),
            None => {
                let middle = distances.len() / 2;
                let median = distances.get(middle).copied().unwrap_or(f64::INFINITY);
                found.push((distances, Fit { laws: vec![law.info.id], median }));
            }
        }
    }
    let mut fits: Vec<Fit> = found.into_iter().map(|(_, fit)| fit).collect();
    fits.sort_by(|a, b| a.median.total_cmp(&b.median));
    fits
}

/// The points of a table; `to_k` gives k from the angle in degrees and what was measured.
fn points(table: &str, to_k: fn(f64, f64) -> f64) -> Vec<Point> {
    let point = |row: Vec<&str>| {
        let cell = |column: usize| super::number(row.get(column).copied().unwrap_or_default());
        let (degrees, measured) = (cell(0), cell(1));
        let moved = |by: f64| to_k(degrees, measured * (1.0 + by));
        let bar = (moved(READING) - moved(-READING)).abs() / 2.0;
        Point { degrees, alpha: alpha(degrees), k: to_k(degrees, measured), bar }
    };
    super::rows(table).skip(1).map(point).collect()
}

fn by_restitution(_: f64, e_t: f64) -> f64 {
    1.0 - 3.5 * (1.0 - e_t)
}

fn by_spin(degrees: f64, omega: f64) -> f64 {
    let sliding = FRICTION * (1.0 + RESTITUTION) * SPEED * degrees.to_radians().cos();
    1.0 - 2.0 * alpha(degrees) * 0.4 * RADIUS * omega / sliding
}

fn by_recoil(degrees: f64, recoil: f64) -> f64 {
    RESTITUTION * recoil.to_radians().tan() / degrees.to_radians().tan()
}

/// Alumina (E = 380 GPa, ν = 0.23) on soda-lime glass, whose E = 70 GPa and ν = 0.25 are not told
/// with the points, but usual: χ = 1.504. Nothing is fitted.
///
/// # Errors
/// [`InvalidInput`], which these constants do not give.
pub fn compliance() -> Result<Compliance, InvalidInput<f64>> {
    let elastic = |young: f64, poisson: f64| Elastic {
        shear_modulus: young / (2.0 * (1.0 + poisson)),
        poisson,
    };
    Compliance::between([elastic(380e9, 0.23), elastic(70e9, 0.25)], 3.5, RESTITUTION)
}
