//! The format of collisions, `docs/collide-format.md`.

use kane_impact::bodies::{Collision, Motion, PlanarBody, SphereOnPlane};
use kane_number::{Algebraic, Rational};
use serde::Deserialize;
use toml::Spanned;

use super::bodies::{Pendulum, Rod};
use super::number::Domain;
use super::reader::{Reader, name};
use super::source::{Fault, Number, Source};
use super::stated::Stated;
use crate::collide::{Question, System};
use crate::tip::{Tip, TipBody};

#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
struct File {
    title: Option<String>,
    friction: Number,
    restitution: Number,
    sphere: Option<Sphere>,
    rod_tip: Option<Rod>,
    ellipse: Option<Ellipse>,
    planar: Option<Planar>,
    two_spheres: Option<TwoSpheres>,
    double_pendulum: Option<Pendulum>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Sphere {
    mass_kg: Number,
    radius_m: Number,
    shape: Option<Spanned<String>>,
    mobility_ratio: Option<Number>,
    velocity_m_s: [Number; 2],
    spin_rad_s: Option<Number>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct TwoSpheres {
    first: Sphere,
    second: Sphere,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Ellipse {
    mass_kg: Number,
    half_axes_m: [Number; 2],
    angle_deg: Option<Number>,
    half_tangent: Option<Number>,
    velocity_m_s: [Number; 2],
    spin_rad_s: Option<Number>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Body {
    mass_kg: Number,
    inertia_kg_m2: Number,
    arm_m: [Number; 2],
    velocity_m_s: [Number; 2],
    spin_rad_s: Option<Number>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Planar {
    body: Body,
    other: Option<Body>,
}

/// Reads a collision; `name` is what faults call the file.
///
/// # Errors
/// The first thing wrong with it, with its place.
pub fn collision(name: &str, text: &str) -> Result<Question, Fault> {
    let source = Source::file(name, text);
    let file: File = source.parse()?;
    let mut reader = Reader::new(source);
    let system = system(&mut reader, &file)?;
    let mut question = Question::new(system);
    question.given = reader.given;
    question.notes.append(&mut reader.notes);
    if let Some(title) = file.title {
        question.title = title.split_whitespace().collect::<Vec<_>>().join(" ");
    }
    Ok(question)
}

/// What is wrong with a velocity that points away from the plane, and maybe was right once.
pub const TURNED: &str = "this body moves away from the plane: y points away from it and spin counts from x to y, as everywhere; up to version 0.1 y pointed into the plane and spin counted the other way, so change the signs of both";

/// The same motion in the signs of the paper, whose y points into the plane.
#[must_use]
pub fn of_the_paper(motion: Motion<Rational>) -> Motion<Rational> {
    Motion { vx: motion.vx, vy: -motion.vy, omega: -motion.omega }
}

/// What is known exactly.
fn certain(motion: &Motion<Stated>) -> Motion<Rational> {
    motion.map(|stated| stated.value.clone())
}

fn system(reader: &mut Reader<'_>, file: &File) -> Result<System<Rational>, Fault> {
    let bodies = [
        file.sphere.is_some(),
        file.rod_tip.is_some(),
        file.ellipse.is_some(),
        file.planar.is_some(),
        file.two_spheres.is_some(),
        file.double_pendulum.is_some(),
    ];
    let one = bodies.iter().filter(|given| **given).count() == 1;
    let missing = "exactly one of [sphere], [rod-tip], [ellipse], [planar.body], [two-spheres.first] with [two-spheres.second], and [double-pendulum] must be there";
    if !one {
        return Err(reader.fault(0..0, missing));
    }
    let friction =
        reader.number(&file.friction, name("friction", "mu", ""), Domain::NotNegative)?;
    let restitution =
        reader.number(&file.restitution, name("restitution", "e", ""), Domain::Fraction)?;
    if let Some(sphere) = &file.sphere {
        let [mass, radius, inertia] = round(reader, sphere, "")?;
        let before = reader.motion(&sphere.velocity_m_s, sphere.spin_rad_s.as_ref(), "0")?;
        let before = certain(&before);
        if before.vy > Rational::default() {
            return Err(reader.fault(sphere.velocity_m_s[1].span(), TURNED));
        }
        let before = of_the_paper(before);
        return Ok(System::Sphere(SphereOnPlane {
            mass,
            radius,
            inertia,
            friction,
            restitution,
            before,
        }));
    }
    let tip = |body: TipBody<Stated>| {
        let (friction, restitution) = (friction.clone().into(), restitution.clone().into());
        Tip { body, friction, restitution }.map(|stated: &Stated| stated.value.clone()).system()
    };
    let mut other = None;
    let body = if let Some(rod) = &file.rod_tip {
        return Ok(tip(reader.rod_tip(rod)?));
    } else if let Some(pendulum) = &file.double_pendulum {
        return Ok(tip(reader.hinged(pendulum)?));
    } else if let Some(body) = &file.ellipse {
        ellipse(reader, body)?
    } else if let Some(body) = &file.planar {
        let two = body.other.is_some();
        other = body.other.as_ref().map(|body| planar(reader, body, "2")).transpose()?;
        planar(reader, &body.body, if two { "1" } else { "0" })?
    } else if let Some(TwoSpheres { first, second }) = &file.two_spheres {
        let first = ball(reader, first, "1", false)?;
        other = Some(ball(reader, second, "2", true)?);
        first
    } else {
        return Err(reader.fault(0..0, missing));
    };
    Ok(System::Planar(Collision { body, other, friction, restitution }))
}

fn round(reader: &mut Reader<'_>, body: &Sphere, tag: &str) -> Result<[Rational; 3], Fault> {
    let Sphere { mass_kg, radius_m, shape, mobility_ratio, .. } = body;
    reader.round([mass_kg, radius_m], shape.as_ref(), mobility_ratio.as_ref(), tag)
}

/// One of two round bodies; the second lies below, so that its contact point is above it.
fn ball(
    reader: &mut Reader<'_>,
    ball: &Sphere,
    tag: &str,
    below: bool,
) -> Result<PlanarBody<Rational>, Fault> {
    let [mass, radius, inertia] = round(reader, ball, tag)?;
    let before = reader.motion(&ball.velocity_m_s, ball.spin_rad_s.as_ref(), tag)?;
    let height = if below { radius } else { -radius };
    let arm = [Rational::default(), height];
    Ok(PlanarBody { mass, inertia, arm, before: certain(&before) })
}

fn planar(reader: &mut Reader<'_>, body: &Body, tag: &str) -> Result<PlanarBody<Rational>, Fault> {
    let of = |symbol: &str| match tag {
        "0" => symbol.to_owned(),
        tag => format!("{symbol}{tag}"),
    };
    let (m, j, x, y) = (of("m"), of("J"), of("arm_x"), of("arm_y"));
    let mass = reader.number(&body.mass_kg, name("mass_kg", &m, "kg"), Domain::Positive)?;
    let inertia = name("inertia_kg_m2", &j, "kg·m²");
    let inertia = reader.number(&body.inertia_kg_m2, inertia, Domain::Positive)?;
    let arm = reader.pair(&body.arm_m, "arm_m", [&x, &y], "m", Domain::Any)?;
    let arm = arm.map(|stated| stated.value);
    let before = reader.motion(&body.velocity_m_s, body.spin_rad_s.as_ref(), tag)?;
    Ok(PlanarBody { mass, inertia, arm, before: certain(&before) })
}

/// An ellipse; where the root in its height is irrational, its arm is rounded to floats.
fn ellipse(reader: &mut Reader<'_>, ellipse: &Ellipse) -> Result<PlanarBody<Rational>, Fault> {
    let mass = reader.number(&ellipse.mass_kg, name("mass_kg", "m", "kg"), Domain::Positive)?;
    let half_axes = &ellipse.half_axes_m;
    let axes = reader.pair(half_axes, "half_axes_m", ["a", "b"], "m", Domain::Positive)?;
    let axes = axes.map(|stated| stated.value);
    let direction =
        reader.heading(ellipse.angle_deg.as_ref(), ellipse.half_tangent.as_ref(), "")?;
    let before = reader.motion(&ellipse.velocity_m_s, ellipse.spin_rad_s.as_ref(), "0")?;
    let before = certain(&before);
    let body = PlanarBody::ellipse(mass.clone(), axes.clone(), &direction, before.clone());
    if let Some(body) = body {
        return Ok(body);
    }
    let place = half_axes[0].span();
    let root = |exact: &Rational| Algebraic::from(exact.clone());
    let body = PlanarBody::ellipse(
        root(&mass),
        [root(&axes[0]), root(&axes[1])],
        &direction.map(root),
        before.map(root),
    )
    .ok_or_else(|| reader.fault(place.clone(), "the ellipse has no height above the obstacle"))?;
    let rounded = |number: &Algebraic| kane_number::decode(number.to_f64()).ok();
    let arm = match (rounded(&body.arm[0]), rounded(&body.arm[1])) {
        (Some(x), Some(y)) => [x, y],
        _ => return Err(reader.fault(place, "the ellipse's arm is beyond the range of f64")),
    };
    reader.notes.push(
        "The height of the centre is irrational: the arm of the contact point is the pair of nearest floats, taken exactly."
            .to_owned(),
    );
    let [a, b] = axes;
    let inertia = (&a * &a + &b * &b) * &mass / Rational::from_integer(4.into());
    Ok(PlanarBody { mass, inertia, arm, before })
}
