//! The bodies of a scene's file.

use kane_impact::bodies::{Direction, Motion, Shape};
use kane_number::Rational;
use serde::Deserialize;
use toml::Spanned;

use super::angle::direction;
use super::file::MOST_BODIES;
use super::number::{Domain, read_in};
use super::source::{Fault, Number, Source};
use super::stated::Stated;
use crate::tip::TipBody;
use crate::world::Round;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Body {
    mass_kg: Number,
    radius_m: Number,
    shape: Option<Spanned<String>>,
    mobility_ratio: Option<Number>,
    pub(super) position_m: [Number; 2],
    velocity_m_s: [Number; 2],
    spin_rad_s: Option<Number>,
}

/// Equal discs on a grid, each flying in another direction.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Discs {
    columns: Spanned<usize>,
    rows: Spanned<usize>,
    mass_kg: Number,
    radius_m: Number,
    pub(super) spacing_m: Number,
    speed_m_s: Number,
    spin_rad_s: Option<Number>,
}

/// A rod that strikes with its tip, as a file has it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rod {
    /// m > 0; kg.
    pub mass_kg: Number,
    /// l > 0; m.
    pub length_m: Number,
    /// Between the surface and the way from the tip up to the centre, unless its half tangent is given;
    /// degrees.
    pub angle_deg: Option<Number>,
    /// The tangent of half of that angle.
    pub half_tangent: Option<Number>,
    /// Of the centre, x and y; m/s.
    pub velocity_m_s: [Number; 2],
    /// ω, 0 if it is not given; rad/s.
    pub spin_rad_s: Option<Number>,
}

/// Kane's double pendulum, as a file has it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Pendulum {
    /// m > 0 of each of its two rods; kg.
    pub mass_kg: Number,
    /// l > 0 of each; m.
    pub length_m: Number,
    /// Of both rods from the vertical, unless their half tangents are given; degrees.
    pub angles_deg: Option<[Number; 2]>,
    /// The tangents of half of those angles.
    pub half_tangents: Option<[Number; 2]>,
    /// Of both rods; rad/s.
    pub angular_velocities_rad_s: [Number; 2],
}

/// A number, or a table `{ value = …, within = … }`.
pub(super) fn stated(
    source: Source<'_>,
    number: &Number,
    symbol: &str,
    domain: Domain,
) -> Result<Stated, Fault> {
    let toml::Value::Table(table) = number.get_ref() else {
        return Ok(source.number(number, symbol, domain)?.into());
    };
    let fault = |message: String| source.fault(number.span(), message);
    if let Some(key) = table.keys().find(|key| *key != "value" && *key != "within") {
        return Err(fault(format!("unknown key `{key}`; write {{ value = 1, within = \"0.1\" }}")));
    }
    let text = source.text.get(number.span()).unwrap_or_default();
    let part = |key: &str, domain: Domain| {
        let value = table.get(key).ok_or_else(|| {
            fault(format!("{symbol} lacks `{key}`; write {{ value = 1, within = \"0.1\" }}"))
        })?;
        let written = match value {
            toml::Value::String(text) => text.clone(),
            _ => after_key(text, key),
        };
        read_in(&written, domain).map_err(|error| fault(format!("`{key}` of {symbol} {error}")))
    };
    let stated =
        Stated { value: part("value", domain)?, within: part("within", Domain::NotNegative)? };
    // the whole range must be in the domain
    for end in [&stated.value - &stated.within, &stated.value + &stated.within] {
        read_in(&end.to_string(), domain)
            .map_err(|error| fault(format!("an end of the range of {symbol} {error}")))?;
    }
    Ok(stated)
}

/// The text of a number inside an inline table: what stands between `key =` and the next comma,
/// because the parser's own floats are not exact.
fn after_key(table: &str, key: &str) -> String {
    let inner = table.trim().trim_start_matches('{').trim_end_matches('}');
    let of_key = inner.split(',').find_map(|item| {
        let (name, value) = item.split_once('=')?;
        (name.trim() == key).then(|| value.trim().replace('_', ""))
    });
    of_key.unwrap_or_default()
}

fn motion(
    source: Source<'_>,
    [vx, vy]: &[Number; 2],
    spin: Option<&Number>,
) -> Result<Motion<Stated>, Fault> {
    let velocity = |number| stated(source, number, "velocity_m_s", Domain::Any);
    let omega = match spin {
        Some(spin) => stated(source, spin, "spin_rad_s", Domain::Any)?,
        None => Stated::default(),
    };
    Ok(Motion { vx: velocity(vx)?, vy: velocity(vy)?, omega })
}

pub(super) fn round(source: Source<'_>, body: &Body) -> Result<Round<Stated>, Fault> {
    let mass = source.number(&body.mass_kg, "mass_kg", Domain::Positive)?;
    let radius = source.number(&body.radius_m, "radius_m", Domain::Positive)?;
    let gyration = match (&body.shape, &body.mobility_ratio) {
        (None, None) => Shape::Sphere.gyration(),
        (Some(word), None) => {
            let shape: Shape = word
                .get_ref()
                .parse()
                .map_err(|error| source.fault(word.span(), format!("{error}")))?;
            shape.gyration()
        }
        (None, Some(ratio)) => {
            let ratio = source.number(ratio, "mobility_ratio", Domain::AboveOne)?;
            (ratio - Rational::from_integer(1.into())).recip()
        }
        (Some(word), Some(_)) => {
            return Err(source.fault(word.span(), "shape and mobility_ratio; give one of them"));
        }
    };
    let [x, y] = &body.position_m;
    let place = |number| stated(source, number, "position_m", Domain::Any);
    Ok(Round {
        inertia: (&mass * &radius * &radius * gyration).into(),
        mass: mass.into(),
        radius: radius.into(),
        position: [place(x)?, place(y)?],
        motion: motion(source, &body.velocity_m_s, body.spin_rad_s.as_ref())?,
    })
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
        });
    }
    Ok(bodies)
}

fn heading(
    source: Source<'_>,
    degrees: Option<&Number>,
    tangent: Option<&Number>,
) -> Result<Direction<Rational>, Fault> {
    match (degrees, tangent) {
        (Some(degrees), None) => {
            Ok(direction(&source.number(degrees, "angle_deg", Domain::Within(u8::MAX))?))
        }
        (None, Some(tangent)) => {
            Ok(Direction::of_half_tangent(&source.number(tangent, "half_tangent", Domain::Any)?))
        }
        (Some(both), Some(_)) => {
            Err(source.fault(both.span(), "an angle in degrees and half a tangent; give one"))
        }
        (None, None) => {
            Err(source.fault(0..0, "the direction is missing: angle_deg or half_tangent"))
        }
    }
}

pub(super) fn rod_tip(source: Source<'_>, rod: &Rod) -> Result<TipBody<Stated>, Fault> {
    Ok(TipBody::Rod {
        mass: source.number(&rod.mass_kg, "mass_kg", Domain::Positive)?.into(),
        length: source.number(&rod.length_m, "length_m", Domain::Positive)?.into(),
        direction: heading(source, rod.angle_deg.as_ref(), rod.half_tangent.as_ref())?,
        motion: motion(source, &rod.velocity_m_s, rod.spin_rad_s.as_ref())?,
    })
}

pub(super) fn hinged(source: Source<'_>, pendulum: &Pendulum) -> Result<TipBody<Stated>, Fault> {
    let angle = |index: usize| {
        let degrees = pendulum.angles_deg.as_ref().map(|pair| &pair[index]);
        heading(source, degrees, pendulum.half_tangents.as_ref().map(|pair| &pair[index]))
    };
    let speed = |index: usize| {
        let speeds = &pendulum.angular_velocities_rad_s;
        stated(source, &speeds[index], "angular_velocities_rad_s", Domain::Any)
    };
    Ok(TipBody::Pendulum {
        mass: source.number(&pendulum.mass_kg, "mass_kg", Domain::Positive)?.into(),
        length: source.number(&pendulum.length_m, "length_m", Domain::Positive)?.into(),
        angles: [angle(0)?, angle(1)?],
        speeds: [speed(0)?, speed(1)?],
    })
}
