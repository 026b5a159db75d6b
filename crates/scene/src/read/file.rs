//! The format of scenes, `docs/scene-format.md`.

use std::collections::BTreeMap;

use kane_audit::Diagnostic;
use kane_impact::bodies::{Direction, Motion, Shape};
use kane_number::Rational;
use serde::Deserialize;
use toml::Spanned;

use super::angle::direction;
use super::ask::{UntilTable, asked, until};
use super::number::{Domain, read_in};
use super::source::{Number, Source};
use super::stated::Stated;
use crate::scene::{MOST_UNCERTAIN, Scene, Setup, Tangential};
use crate::simulate::Until;
use crate::tip::{Tip, TipBody};
use crate::world::{Round, Side, Wall, World};

/// A scene has tens of bodies, not thousands.
const MOST_BODIES: usize = 100;

#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
struct File {
    title: Option<String>,
    friction: Number,
    restitution: Number,
    #[serde(rename = "tangential_restitution")]
    grip: Option<Number>,
    #[serde(rename = "poisson_ratio")]
    poisson_ratio: Option<Number>,
    #[serde(rename = "hertz_stiffness_n_m_3_2")]
    stiffness: Option<Number>,
    #[serde(rename = "gravity_m_s2")]
    gravity: Option<Number>,
    #[serde(rename = "floor_m")]
    floor: Option<Number>,
    #[serde(rename = "ceiling_m")]
    ceiling: Option<Number>,
    #[serde(rename = "left_m")]
    left: Option<Number>,
    #[serde(rename = "right_m")]
    right: Option<Number>,
    body: Option<Vec<Body>>,
    discs: Option<Spanned<Discs>>,
    rod_tip: Option<Rod>,
    double_pendulum: Option<Pendulum>,
    until: Option<Spanned<UntilTable>>,
    ask: BTreeMap<Spanned<String>, Number>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Body {
    mass_kg: Number,
    radius_m: Number,
    shape: Option<Spanned<String>>,
    mobility_ratio: Option<Number>,
    position_m: [Number; 2],
    velocity_m_s: [Number; 2],
    spin_rad_s: Option<Number>,
}

/// Equal discs on a grid, each flying in another direction.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Discs {
    columns: Spanned<usize>,
    rows: Spanned<usize>,
    mass_kg: Number,
    radius_m: Number,
    spacing_m: Number,
    speed_m_s: Number,
    spin_rad_s: Option<Number>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Rod {
    mass_kg: Number,
    length_m: Number,
    angle_deg: Option<Number>,
    half_tangent: Option<Number>,
    velocity_m_s: [Number; 2],
    spin_rad_s: Option<Number>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Pendulum {
    mass_kg: Number,
    length_m: Number,
    angles_deg: Option<[Number; 2]>,
    half_tangents: Option<[Number; 2]>,
    angular_velocities_rad_s: [Number; 2],
}

/// Reads a scene; `name` is what faults call the file.
///
/// # Errors
/// The first thing wrong with it, with its place.
pub fn scene(name: &str, text: &str) -> Result<Scene, Box<Diagnostic>> {
    let source = Source { name, text };
    Ok(read(source)?)
}

fn read(source: Source<'_>) -> Result<Scene, Diagnostic> {
    let file: File = source.parse()?;
    let setup = setup(source, &file)?;
    let scene = Scene {
        title: file.title.as_deref().unwrap_or(source.name).split_whitespace().collect::<Vec<_>>().join(" "),
        until: match (&file.until, &setup) {
            (Some(table), Setup::Bodies(_)) => until(source, table)?,
            (Some(table), Setup::Tip(_)) => {
                return Err(source.fault(table.span(), "a tip has one impact; leave [until] out"));
            }
            (None, Setup::Tip(_)) => Until::Impacts(1),
            (None, Setup::Bodies(_)) => {
                return Err(source.fault(0..0, "[until] is missing: impacts, duration_s or rest"));
            }
        },
        tangential: tangential(source, &file)?,
        stiffness: match &file.stiffness {
            None => None,
            Some(number) => {
                in_a_row(source, number, &setup, &file)?;
                Some(source.number(number, "the stiffness", Domain::Positive)?)
            }
        },
        asked: asked(source, &file.ask, &setup)?,
        setup,
    };
    if scene.uncertain() > MOST_UNCERTAIN {
        return Err(source.fault(0..0, format!("at most {MOST_UNCERTAIN} numbers may be uncertain")));
    }
    Ok(scene)
}

/// A chain of springs moves along one line, without spin and loss.
fn in_a_row(
    source: Source<'_>,
    number: &Number,
    setup: &Setup<Stated>,
    file: &File,
) -> Result<(), Diagnostic> {
    let zero = Stated::default();
    let Setup::Bodies(world) = setup else {
        return Err(source.fault(number.span(), "a stiffness is for spheres in a row"));
    };
    let first = &world.bodies[0];
    let row = world.bodies.len() > 1
        && world.walls.is_empty()
        && world.bodies.windows(2).all(|pair| pair[0].position[0].value < pair[1].position[0].value)
        && world.bodies.iter().all(|body| {
            body.position[1] == first.position[1]
                && body.motion.vy == zero
                && body.motion.omega == zero
        });
    let lossless = world.restitution.value == Rational::from_integer(1.into());
    if !row || !lossless || file.gravity.is_some() {
        return Err(source.fault(
            number.span(),
            "a stiffness is for bodies on a horizontal line, from left to right, without spin, walls and gravity, and for restitution = 1",
        ));
    }
    Ok(())
}

fn tangential(source: Source<'_>, file: &File) -> Result<Tangential, Diagnostic> {
    match (&file.grip, &file.poisson_ratio) {
        (None, None) => Ok(Tangential::Rigid),
        (Some(_), _) | (_, Some(_)) if file.body.is_none() && file.discs.is_none() => {
            let span = file.grip.as_ref().or(file.poisson_ratio.as_ref()).map_or(0..0, Spanned::span);
            Err(source.fault(span, "tangential compliance is described for round bodies alone"))
        }
        (Some(grip), None) => {
            Ok(Tangential::Grip(source.number(grip, "tangential_restitution", Domain::Fraction)?))
        }
        (None, Some(ratio)) => {
            let value = source.number(ratio, "poisson_ratio", Domain::NotNegative)?;
            if value > Rational::new(1.into(), 2.into()) {
                return Err(source.fault(ratio.span(), "poisson_ratio must be at most 1/2"));
            }
            Ok(Tangential::Elastic(value))
        }
        (Some(both), Some(_)) => Err(source
            .fault(both.span(), "tangential_restitution and poisson_ratio; give one of them")),
    }
}

fn setup(source: Source<'_>, file: &File) -> Result<Setup<Stated>, Diagnostic> {
    let kinds =
        [file.body.is_some(), file.discs.is_some(), file.rod_tip.is_some(), file.double_pendulum.is_some()];
    if kinds.iter().filter(|given| **given).count() != 1 {
        return Err(source.fault(
            0..0,
            "exactly one of [[body]], [discs], [rod-tip] and [double-pendulum] must be there",
        ));
    }
    let friction = stated(source, &file.friction, "friction", Domain::NotNegative)?;
    let restitution = stated(source, &file.restitution, "restitution", Domain::Fraction)?;
    if let Some(rod) = &file.rod_tip {
        return Ok(Setup::Tip(Tip { body: rod_tip(source, rod)?, friction, restitution }));
    }
    if let Some(pendulum) = &file.double_pendulum {
        return Ok(Setup::Tip(Tip { body: hinged(source, pendulum)?, friction, restitution }));
    }
    let gravity = match &file.gravity {
        Some(gravity) => source.number(gravity, "gravity_m_s2", Domain::NotNegative)?,
        None => Rational::default(),
    };
    let mut walls = Vec::new();
    for (number, side, key) in [
        (&file.floor, Side::Floor, "floor_m"),
        (&file.ceiling, Side::Ceiling, "ceiling_m"),
        (&file.left, Side::Left, "left_m"),
        (&file.right, Side::Right, "right_m"),
    ] {
        if let Some(number) = number {
            walls.push(Wall { side, at: source.number(number, key, Domain::Any)?.into() });
        }
    }
    let bodies = match (&file.body, &file.discs) {
        (Some(bodies), _) => {
            bodies.iter().map(|body| round(source, body)).collect::<Result<Vec<_>, _>>()?
        }
        (None, Some(table)) => discs(source, table.get_ref())?,
        (None, None) => Vec::new(),
    };
    let world = World { gravity: gravity.into(), walls, bodies, friction, restitution };
    apart(source, &world, file)?;
    Ok(Setup::Bodies(world))
}

/// No body may be inside another or inside a wall.
fn apart(source: Source<'_>, world: &World<Stated>, file: &File) -> Result<(), Diagnostic> {
    let span = |index: usize| match (&file.body, &file.discs) {
        (Some(bodies), _) => bodies[index].position_m[0].span(),
        (None, Some(discs)) => discs.get_ref().spacing_m.span(),
        (None, None) => 0..0,
    };
    if world.bodies.is_empty() || world.bodies.len() > MOST_BODIES {
        return Err(source.fault(0..0, format!("a scene has 1 to {MOST_BODIES} bodies")));
    }
    for (i, body) in world.bodies.iter().enumerate() {
        let [x, y] = [&body.position[0].value, &body.position[1].value];
        let r = &body.radius.value;
        for wall in &world.walls {
            let at = &wall.at.value;
            let gap = match wall.side {
                Side::Floor => y - at - r,
                Side::Ceiling => at - y - r,
                Side::Left => x - at - r,
                Side::Right => at - x - r,
            };
            if gap < Rational::default() {
                let message = format!("body {} is inside the {}", i + 1, wall.side.name());
                return Err(source.fault(span(i), message));
            }
        }
        for (j, other) in world.bodies.iter().enumerate().skip(i + 1) {
            let [dx, dy] = [0, 1].map(|k| &body.position[k].value - &other.position[k].value);
            let reach = r + &other.radius.value;
            if &dx * &dx + &dy * &dy < &reach * &reach {
                let message = format!("bodies {} and {} overlap", i + 1, j + 1);
                return Err(source.fault(span(j), message));
            }
        }
    }
    Ok(())
}

/// A number, or a table `{ value = …, within = … }`.
fn stated(
    source: Source<'_>,
    number: &Number,
    symbol: &str,
    domain: Domain,
) -> Result<Stated, Diagnostic> {
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
    let stated = Stated { value: part("value", domain)?, within: part("within", Domain::NotNegative)? };
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
) -> Result<Motion<Stated>, Diagnostic> {
    let velocity = |number| stated(source, number, "velocity_m_s", Domain::Any);
    let omega = match spin {
        Some(spin) => stated(source, spin, "spin_rad_s", Domain::Any)?,
        None => Stated::default(),
    };
    Ok(Motion { vx: velocity(vx)?, vy: velocity(vy)?, omega })
}

fn round(source: Source<'_>, body: &Body) -> Result<Round<Stated>, Diagnostic> {
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
fn discs(source: Source<'_>, table: &Discs) -> Result<Vec<Round<Stated>>, Diagnostic> {
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
) -> Result<Direction<Rational>, Diagnostic> {
    match (degrees, tangent) {
        (Some(degrees), None) => {
            Ok(direction(&source.number(degrees, "angle_deg", Domain::Within(u8::MAX))?))
        }
        (None, Some(tangent)) => Ok(Direction::of_half_tangent(&source.number(
            tangent,
            "half_tangent",
            Domain::Any,
        )?)),
        (Some(both), Some(_)) => {
            Err(source.fault(both.span(), "an angle in degrees and half a tangent; give one"))
        }
        (None, None) => {
            Err(source.fault(0..0, "the direction is missing: angle_deg or half_tangent"))
        }
    }
}

fn rod_tip(source: Source<'_>, rod: &Rod) -> Result<TipBody<Stated>, Diagnostic> {
    Ok(TipBody::Rod {
        mass: source.number(&rod.mass_kg, "mass_kg", Domain::Positive)?.into(),
        length: source.number(&rod.length_m, "length_m", Domain::Positive)?.into(),
        direction: heading(source, rod.angle_deg.as_ref(), rod.half_tangent.as_ref())?,
        motion: motion(source, &rod.velocity_m_s, rod.spin_rad_s.as_ref())?,
    })
}

fn hinged(source: Source<'_>, pendulum: &Pendulum) -> Result<TipBody<Stated>, Diagnostic> {
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
