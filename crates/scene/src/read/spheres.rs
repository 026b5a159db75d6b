//! The round bodies of a scene's file: in the plane of x and y, or as spheres in space.

use kane_impact::bodies::{Motion, Shape};
use toml::Spanned;

use super::bodies::Body;
use super::number::Domain;
use super::reader::{Reader, name};
use super::source::{Fault, Number};
use super::stated::Stated;
use crate::off_plane::OffPlane;
use crate::round::Round;

/// The bodies of `[[body]]`; all are in space if one is, or if something is behind or in front of them.
pub(super) fn spheres(
    reader: &mut Reader<'_>,
    bodies: &[Body],
    has_depth: bool,
) -> Result<Vec<Round<Stated>>, Fault> {
    let third = |list: &Spanned<Vec<Number>>| list.get_ref().len() > 2;
    let in_space = |body: &Body| {
        third(&body.position_m) || third(&body.velocity_m_s) || body.spins_rad_s.is_some()
    };
    let in_space = has_depth || bodies.iter().any(in_space);
    bodies.iter().map(|body| round(reader, body, in_space)).collect()
}

fn round(reader: &mut Reader<'_>, body: &Body, in_space: bool) -> Result<Round<Stated>, Fault> {
    let Body { mass_kg, radius_m, shape, mobility_ratio, .. } = body;
    let [mass, radius, inertia] =
        reader.round([mass_kg, radius_m], shape.as_ref(), mobility_ratio.as_ref(), "")?;
    let ([x, y], z) = components(reader, &body.position_m, "position_m", ["x", "y", "z"], "m")?;
    let symbols = ["v_x0", "v_y0", "v_z0"];
    let ([vx, vy], vz) = components(reader, &body.velocity_m_s, "velocity_m_s", symbols, "m/s")?;
    let [omega_x, omega_y, omega] = spins(reader, body)?;
    if in_space {
        let shell = &mass * &radius * &radius * Shape::HollowSphere.gyration();
        let spheres = [Shape::Sphere, Shape::HollowSphere].map(Shape::name);
        let is_other =
            shape.as_ref().is_some_and(|word| !spheres.contains(&word.get_ref().as_str()));
        if is_other || inertia > shell {
            let place = match (shape, mobility_ratio) {
                (Some(shape), _) => shape.span(),
                (None, Some(ratio)) => ratio.span(),
                (None, None) => 0..0,
            };
            return Err(reader.fault(
                place,
                "in space a body is a sphere, whose inertia is at most that of a shell: shape sphere or hollow-sphere, or a mobility_ratio of at least 5/2",
            ));
        }
    }
    let off_plane = OffPlane { z, vz, omega_x, omega_y };
    Ok(Round {
        inertia: inertia.into(),
        mass: mass.into(),
        radius: radius.into(),
        position: [x, y],
        motion: Motion { vx, vy, omega },
        off_plane: in_space.then_some(off_plane),
    })
}

/// Two or three components; the third is 0 if it is not given.
fn components(
    reader: &mut Reader<'_>,
    list: &Spanned<Vec<Number>>,
    key: &str,
    symbols: [&str; 3],
    unit: &'static str,
) -> Result<([Stated; 2], Stated), Fault> {
    let [x, y, z] = symbols;
    let mut of =
        |number: &Number, symbol| reader.stated(number, name(key, symbol, unit), Domain::Any);
    match &list.get_ref()[..] {
        [a, b] => Ok(([of(a, x)?, of(b, y)?], Stated::default())),
        [a, b, c] => Ok(([of(a, x)?, of(b, y)?], of(c, z)?)),
        _ => Err(reader.fault(list.span(), format!("{key} needs two numbers, or three in space"))),
    }
}

/// The spin about x, y and z.
fn spins(reader: &mut Reader<'_>, body: &Body) -> Result<[Stated; 3], Fault> {
    let mut of = |number: &Number, key, symbol| {
        reader.stated(number, name(key, symbol, "rad/s"), Domain::Any)
    };
    let none = Stated::default;
    match (&body.spin_rad_s, &body.spins_rad_s) {
        (None, None) => Ok([none(), none(), none()]),
        (Some(spin), None) => Ok([none(), none(), of(spin, "spin_rad_s", "omega0")?]),
        (None, Some([x, y, z])) => {
            let mut of = |number, symbol| of(number, "spins_rad_s", symbol);
            Ok([of(x, "omega_x0")?, of(y, "omega_y0")?, of(z, "omega_z0")?])
        }
        (Some(spin), Some(_)) => {
            Err(reader.fault(spin.span(), "spin_rad_s, about z, and spins_rad_s; give one of them"))
        }
    }
}
