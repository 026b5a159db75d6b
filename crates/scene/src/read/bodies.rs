//! The bodies of a scene's file.

use kane_impact::bodies::{Direction, Motion, Shape};
use kane_number::Rational;
use serde::Deserialize;
use toml::Spanned;

use super::number::Domain;
use super::source::{Fault, Number, Source};
use super::stated::Stated;
use crate::round::Round;

/// A scene has tens of bodies, not thousands.
pub(super) const MOST_BODIES: usize = 100;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Body {
    pub(super) mass_kg: Number,
    pub(super) radius_m: Number,
    pub(super) shape: Option<Spanned<String>>,
    pub(super) mobility_ratio: Option<Number>,
    /// Two numbers, or three in space.
    pub(super) position_m: Spanned<Vec<Number>>,
    pub(super) velocity_m_s: Spanned<Vec<Number>>,
    /// About z.
    pub(super) spin_rad_s: Option<Number>,
    /// About x, y and z.
    pub(super) spins_rad_s: Option<[Number; 3]>,
}

/// Equal discs on a grid, each flying in another direction.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Discs {
    columns: Spanned<usize>,
    rows: Spanned<usize>,
    pub(super) mass_kg: Number,
    pub(super) radius_m: Number,
    pub(super) spacing_m: Number,
    speed_m_s: Number,
    pub(super) spin_rad_s: Option<Number>,
}

/// A rod that strikes with its tip, as a file has it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Rod {
    /// m > 0; kg.
    pub(super) mass_kg: Number,
    /// l > 0; m.
    pub(super) length_m: Number,
    /// Between the surface and the way from the tip up to the centre, unless its half tangent is given;
    /// degrees.
    pub(super) angle_deg: Option<Number>,
    /// The tangent of half of that angle.
    pub(super) half_tangent: Option<Number>,
    /// Of the centre, x and y; m/s.
    pub(super) velocity_m_s: [Number; 2],
    /// ω, 0 if it is not given; rad/s.
    pub(super) spin_rad_s: Option<Number>,
}

/// Kane's double pendulum, as a file has it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Pendulum {
    /// m > 0 of each of its two rods; kg.
    pub(super) mass_kg: Number,
    /// l > 0 of each; m.
    pub(super) length_m: Number,
    /// Of both rods from the vertical, unless their half tangents are given; degrees.
    pub(super) angles_deg: Option<[Number; 2]>,
    /// The tangents of half of those angles.
    pub(super) half_tangents: Option<[Number; 2]>,
    /// Of both rods; rad/s.
    pub(super) angular_velocities_rad_s: [Number; 2],
}

/// Discs in rows; each flies in the direction with the half tangent tan(φ/2) = c/200 by a fixed
/// sequence of c from −504 to 504 in which none comes twice, so that all is rational, the same
/// everywhere, and no two impacts are at the same time by symmetry.
pub(super) fn discs(source: Source<'_>, table: &Discs) -> Result<Vec<Round<Stated>>, Fault> {
    let (columns, rows) = (*table.columns.get_ref(), *table.rows.get_ref());
    if columns == 0 || rows == 0 || columns.saturating_mul(rows) > MOST_BODIES {
        let message = format!("columns times rows must be from 1 to {MOST_BODIES}");
        return Err(source.fault(table.columns.span(), message));
    }
    let number = |number, symbol, domain| source.number(number, symbol, domain);
    let mass = number(&table.mass_kg, "mass_kg", Domain::Positive)?;
    let radius = number(&table.radius_m, "radius_m", Domain::Positive)?;
    let spacing = number(&table.spacing_m, "spacing_m", Domain::Positive)?;
    let speed = number(&table.speed_m_s, "speed_m_s", Domain::NotNegative)?;
    let spin = match &table.spin_rad_s {
        Some(spin) => number(spin, "spin_rad_s", Domain::Any)?,
        None => Rational::default(),
    };
    let integer = |n: i64| Rational::from_integer(n.into());
    let at = |n: usize| {
        let n = i64::try_from(n).unwrap_or(i64::MAX);
        Stated::from((integer(n) + Rational::new(1.into(), 2.into())) * &spacing)
    };
    let inertia = &mass * &radius * &radius * Shape::Disc.gyration();
    let mut seed = 7_i64;
    let mut bodies = Vec::new();
    for index in 0..columns * rows {
        seed = (seed * 29 + 17) % 1009;
        let tangent = Rational::new((seed - 504).into(), 200.into());
        let Direction { cos, sin } = Direction::of_half_tangent(&tangent);
        let turn = if index.is_multiple_of(2) { spin.clone() } else { -spin.clone() };
        bodies.push(Round {
            mass: mass.clone().into(),
            inertia: inertia.clone().into(),
            radius: radius.clone().into(),
            position: [at(index % columns), at(index / columns)],
            motion: Motion {
                vx: (cos * &speed).into(),
                vy: (sin * &speed).into(),
                omega: turn.into(),
            },
            off_plane: None,
        });
    }
    Ok(bodies)
}
