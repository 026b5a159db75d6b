//! The format of scenes, `docs/scene-format.md`.

use std::collections::BTreeMap;

use kane_algebra::syntax::visible;
use kane_impact::compliant::Loss;
use kane_number::Rational;
use serde::Deserialize;
use sha2::{Digest as _, Sha256};
use toml::Spanned;

use super::air::{AirTable, air};
use super::ask::{UntilTable, asked, until};
use super::bodies::{Body, Discs, MOST_BODIES, Pendulum, Rod, discs};
use super::contacts::{ContactTable, PlaneTable, planes, terms};
use super::number::Domain;
use super::reader::Reader;
use super::source::{Fault, Number, Source};
use super::spheres::spheres;
use super::stated::{Stated, stated};
use super::tumbling::{FlyingRod, Polygon, outside, polygon, rod};
use crate::round::Round;
use crate::scene::{MOST_UNCERTAIN, Scene, Setup, Tangential};
use crate::side::Side;
use crate::simulate::Until;
use crate::tip::Tip;
use crate::vector::{minus, square};
use crate::world::{Wall, World};

#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub(super) struct File {
    title: Option<String>,
    friction: Number,
    restitution: Number,
    #[serde(rename = "rolling_resistance")]
    pub(super) rolling: Option<Number>,
    #[serde(rename = "tangential_restitution")]
    grip: Option<Number>,
    #[serde(rename = "poisson_ratio")]
    poisson_ratio: Option<Number>,
    #[serde(rename = "stiffness_ratio")]
    stiffness_ratio: Option<Number>,
    loss: Option<Spanned<String>>,
    #[serde(rename = "hertz_stiffness_n_m_3_2")]
    pub(super) stiffness: Option<Number>,
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
    #[serde(rename = "back_m")]
    pub(super) back: Option<Number>,
    #[serde(rename = "front_m")]
    pub(super) front: Option<Number>,
    pub(super) air: Option<Spanned<AirTable>>,
    #[serde(default)]
    wall: Vec<Spanned<PlaneTable>>,
    #[serde(default)]
    contact: Vec<Spanned<ContactTable>>,
    body: Option<Vec<Body>>,
    discs: Option<Spanned<Discs>>,
    polygon: Option<Polygon>,
    rod: Option<FlyingRod>,
    rod_tip: Option<Rod>,
    double_pendulum: Option<Pendulum>,
    until: Option<Spanned<UntilTable>>,
    #[serde(default)]
    ask: BTreeMap<Spanned<String>, Number>,
}

/// Reads a scene; `name` is what faults call the file.
///
/// # Errors
/// The first thing wrong with it, with its place.
pub fn scene(name: &str, text: &str) -> Result<Scene, Fault> {
    read(Source::file(name, text))
}

fn read(source: Source<'_>) -> Result<Scene, Fault> {
    let file: File = source.parse()?;
    let setup = setup(source, &file)?;
    let digest = Sha256::digest(source.text.as_bytes());
    let scene = Scene {
        sha256: digest.iter().map(|byte| format!("{byte:02x}")).collect(),
        title: file
            .title
            .as_deref()
            .unwrap_or(source.name)
            .split_whitespace()
            .map(visible)
            .collect::<Vec<_>>()
            .join(" "),
        until: match (&file.until, &setup) {
            (Some(table), Setup::Bodies(world)) => until(source, table, world)?,
            (Some(table), Setup::Tip(_)) => {
                return Err(source.fault(table.span(), "a tip has one impact; leave [until] out"));
            }
            (None, Setup::Tip(_)) => Until::Impacts(1),
            (None, Setup::Bodies(_)) => {
                return Err(source.fault(0..0, "[until] is missing: impacts, duration_s or rest"));
            }
        },
        tangential: tangential(source, &file)?,
        loss: file.loss.as_ref().map(|loss| lost(source, loss, &file)).transpose()?,
        finer: 1,
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
        return Err(
            source.fault(0..0, format!("at most {MOST_UNCERTAIN} numbers may be uncertain"))
        );
    }
    Ok(scene)
}

/// A chain of springs moves along one line, without spin and loss.
fn in_a_row(
    source: Source<'_>,
    number: &Number,
    setup: &Setup<Stated>,
    file: &File,
) -> Result<(), Fault> {
    let zero = Stated::default();
    let Setup::Bodies(world) = setup else {
        return Err(source.fault(number.span(), "a stiffness is for spheres in a row"));
    };
    let first = &world.bodies[0];
    let row = world.bodies.len() > 1
        && world.walls.is_empty()
        && world.planes.is_empty()
        && world.air.is_none()
        && world.terms.is_empty()
        && world
            .bodies
            .windows(2)
            .all(|pair| pair[0].position[0].value < pair[1].position[0].value)
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

fn tangential(source: Source<'_>, file: &File) -> Result<Tangential, Fault> {
    let stated = [
        ("tangential_restitution", &file.grip, Domain::Fraction),
        ("poisson_ratio", &file.poisson_ratio, Domain::NotNegative),
        ("stiffness_ratio", &file.stiffness_ratio, Domain::Positive),
    ];
    let mut stated = stated
        .into_iter()
        .filter_map(|(key, number, domain)| number.as_ref().map(|number| (key, number, domain)));
    let Some((key, number, domain)) = stated.next() else { return Ok(Tangential::Rigid) };
    if file.body.is_none() && file.discs.is_none() {
        let message = "tangential compliance is described for round bodies alone";
        return Err(source.fault(number.span(), message));
    }
    if let Some((other, ..)) = stated.next() {
        return Err(source.fault(number.span(), format!("{key} and {other}; give one of them")));
    }
    let value = source.number(number, key, domain)?;
    match key {
        "tangential_restitution" => Ok(Tangential::Grip(value)),
        "stiffness_ratio" => Ok(Tangential::Springs(value)),
        _ if value > Rational::new(1.into(), 2.into()) => {
            Err(source.fault(number.span(), "poisson_ratio must be at most 1/2"))
        }
        _ => Ok(Tangential::Elastic(value)),
    }
}

/// What e < 1 means for an elastic contact.
fn lost(source: Source<'_>, loss: &Spanned<String>, file: &File) -> Result<Loss, Fault> {
    let fault = |message: String| source.fault(loss.span(), message);
    let known: &[Loss] = match (&file.poisson_ratio, &file.stiffness_ratio) {
        (Some(_), _) => &Loss::ALL,
        (None, Some(_)) => &[Loss::Recoil, Loss::Linear],
        (None, None) => {
            return Err(fault("loss is for poisson_ratio or stiffness_ratio".to_owned()));
        }
    };
    let found = known.iter().find(|known| known.id() == loss.get_ref());
    let ids = || known.iter().map(|known| known.id()).collect::<Vec<_>>().join(" or ");
    found.copied().ok_or_else(|| fault(format!("loss is {} here", ids())))
}

fn setup(source: Source<'_>, file: &File) -> Result<Setup<Stated>, Fault> {
    let kinds = [
        file.body.is_some(),
        file.discs.is_some(),
        file.polygon.is_some(),
        file.rod.is_some(),
        file.rod_tip.is_some(),
        file.double_pendulum.is_some(),
    ];
    if kinds.iter().filter(|given| **given).count() != 1 {
        return Err(source.fault(
            0..0,
            "exactly one of [[body]], [discs], [polygon], [rod], [rod-tip] and [double-pendulum] must be there",
        ));
    }
    let friction = stated(source, &file.friction, "friction", Domain::NotNegative)?;
    let restitution = stated(source, &file.restitution, "restitution", Domain::Fraction)?;
    let mut reader = Reader::of_uncertain(source);
    let (is_round, has_corners) =
        (file.body.is_some() || file.discs.is_some(), file.polygon.is_some() || file.rod.is_some());
    let of_flights = if has_corners { 2 } else { 4 };
    let stray = [
        file.rolling.as_ref().map(Spanned::span),
        file.air.as_ref().map(Spanned::span),
        file.wall.first().map(Spanned::span),
        file.contact.first().map(Spanned::span),
    ];
    let mut stray = stray.into_iter().take(of_flights).flatten();
    if let (false, Some(place)) = (is_round, stray.next()) {
        return Err(source.fault(
            place,
            "rolling_resistance and [air] are for round bodies, [[wall]] and [[contact]] for what flies",
        ));
    }
    if let Some(rod) = &file.rod_tip {
        return Ok(Setup::Tip(Tip { body: reader.rod_tip(rod)?, friction, restitution }));
    }
    if let Some(pendulum) = &file.double_pendulum {
        return Ok(Setup::Tip(Tip { body: reader.hinged(pendulum)?, friction, restitution }));
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
        (&file.back, Side::Back, "back_m"),
        (&file.front, Side::Front, "front_m"),
    ] {
        if let Some(number) = number {
            walls.push(Wall { side, at: source.number(number, key, Domain::Any)?.into() });
        }
    }
    let tumbling = match (&file.polygon, &file.rod) {
        (Some(table), _) => Some(polygon(source, &mut reader, table)?),
        (None, Some(table)) => Some(rod(source, &mut reader, table)?),
        (None, None) => None,
    };
    let (centre, corners) = tumbling.unzip();
    let bodies = match (&file.body, &file.discs) {
        (Some(bodies), _) => {
            spheres(&mut reader, bodies, file.back.is_some() || file.front.is_some())?
        }
        (None, Some(table)) => discs(source, table.get_ref())?,
        (None, None) => centre.into_iter().collect(),
    };
    in_plane(source, file, &bodies)?;
    let planes = planes(source, &mut reader, &file.wall)?;
    let terms = terms(source, &file.contact, &walls, planes.len(), bodies.len())?;
    let gravity = gravity.into();
    let air = file.air.as_ref().map(|table| air(source, table)).transpose()?;
    let rolling = match &file.rolling {
        Some(number) => stated(source, number, "rolling_resistance", Domain::NotNegative)?,
        None => Stated::default(),
    };
    let world = World {
        gravity,
        air,
        walls,
        planes,
        bodies,
        corners,
        friction,
        restitution,
        terms,
        rolling,
    };
    apart(source, &world, file)?;
    outside(source, &world)?;
    Ok(Setup::Bodies(world))
}

/// The centre of a body as stated.
fn place(body: &Round<Stated>) -> [Rational; 3] {
    body.map(|stated| stated.value.clone()).place()
}

/// No body may be inside another or inside a wall.
fn apart(source: Source<'_>, world: &World<Stated>, file: &File) -> Result<(), Fault> {
    let span = |index: usize| match (&file.body, &file.discs) {
        (Some(bodies), _) => {
            let place = &bodies[index].position_m;
            place.get_ref().first().map_or_else(|| place.span(), Spanned::span)
        }
        (None, Some(discs)) => discs.get_ref().spacing_m.span(),
        (None, None) => 0..0,
    };
    if world.bodies.is_empty() || world.bodies.len() > MOST_BODIES {
        return Err(source.fault(0..0, format!("a scene has 1 to {MOST_BODIES} bodies")));
    }
    for (i, body) in world.bodies.iter().enumerate() {
        let [x, y, z] = &place(body);
        let r = &body.radius.value;
        for wall in &world.walls {
            let at = &wall.at.value;
            let gap = match wall.side {
                Side::Floor => y - at - r,
                Side::Ceiling => at - y - r,
                Side::Left => x - at - r,
                Side::Right => at - x - r,
                Side::Back => z - at - r,
                Side::Front => at - z - r,
                Side::Plane(_) => continue,
            };
            if gap < Rational::default() {
                let message = format!("body {} is inside the {}", i + 1, wall.side.name());
                return Err(source.fault(span(i), message));
            }
        }
        for (number, plane) in world.planes.iter().enumerate() {
            let exact = |stated: &Stated| stated.value.clone();
            let gap = plane.map(exact).gap(&body.map(exact), &Rational::default());
            if gap < Rational::default() {
                let message = format!("body {} is inside wall {}", i + 1, number + 1);
                return Err(source.fault(span(i), message));
            }
        }
        for (j, other) in world.bodies.iter().enumerate().skip(i + 1) {
            let reach = r + &other.radius.value;
            if square(&minus(&place(body), &place(other))) < &reach * &reach {
                let message = format!("bodies {} and {} overlap", i + 1, j + 1);
                return Err(source.fault(span(j), message));
            }
        }
    }
    Ok(())
}

/// What is described in one plane alone is not stated of spheres in space, and what is behind or in front is
/// of them alone.
fn in_plane(source: Source<'_>, file: &File, bodies: &[Round<Stated>]) -> Result<(), Fault> {
    if !bodies.iter().any(|body| body.off_plane.is_some()) {
        let depth = file.back.as_ref().or(file.front.as_ref());
        return depth.map_or(Ok(()), |number| {
            Err(source
                .fault(number.span(), "back_m and front_m are for [[body]], spheres in space"))
        });
    }
    let planar = [
        (file.air.as_ref().map(Spanned::span), "[air]"),
        (file.rolling.as_ref().map(Spanned::span), "rolling_resistance"),
        (file.stiffness.as_ref().map(Spanned::span), "a stiffness"),
    ];
    for (place, what) in planar {
        if let Some(place) = place {
            let message = format!("{what} is described for motion in the plane of x and y alone");
            return Err(source.fault(place, message));
        }
    }
    Ok(())
}
