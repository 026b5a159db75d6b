//! A body with corners: a polygon or a rod that flies.

use kane_impact::bodies::Motion;
use kane_number::Rational;
use serde::Deserialize;
use toml::Spanned;

use super::number::Domain;
use super::reader::Reader;
use super::source::{Fault, Number, Source};
use super::stated::Stated;
use crate::corners::Corners;
use crate::round::Round;
use crate::world::World;

/// A uniform convex polygon.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Polygon {
    mass_kg: Number,
    /// Counterclockwise, from any point.
    corners_m: Spanned<Vec<[Number; 2]>>,
    /// By which they are turned at the start; 0 if neither is given.
    angle_deg: Option<Number>,
    half_tangent: Option<Number>,
    /// Of the centre of mass.
    position_m: [Number; 2],
    velocity_m_s: [Number; 2],
    spin_rad_s: Option<Number>,
}

/// A thin uniform rod.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct FlyingRod {
    mass_kg: Number,
    length_m: Number,
    /// From x; 0 if neither is given.
    angle_deg: Option<Number>,
    half_tangent: Option<Number>,
    /// Of the centre of mass.
    position_m: [Number; 2],
    velocity_m_s: [Number; 2],
    spin_rad_s: Option<Number>,
}

/// Where the centre of mass is, how the body moves, and by what it is turned.
struct Flight<'a> {
    position: &'a [Number; 2],
    velocity: &'a [Number; 2],
    spin: Option<&'a Number>,
    angle: [Option<&'a Number>; 2],
}

/// The corners of a polygon and its centre.
pub(super) fn polygon(
    source: Source<'_>,
    reader: &mut Reader<'_>,
    table: &Polygon,
) -> Result<(Round<Stated>, Corners<Stated>), Fault> {
    let corner = |pair: &[Number; 2]| -> Result<[Rational; 2], Fault> {
        let [x, y] = pair;
        let of = |number| source.number(number, "a corner", Domain::Any);
        Ok([of(x)?, of(y)?])
    };
    let given = table.corners_m.get_ref().iter().map(corner).collect::<Result<Vec<_>, _>>()?;
    let shape = Corners::of_polygon(&given);
    let shape = shape.map_err(|error| source.fault(table.corners_m.span(), error.to_string()))?;
    let flight = Flight {
        position: &table.position_m,
        velocity: &table.velocity_m_s,
        spin: table.spin_rad_s.as_ref(),
        angle: [table.angle_deg.as_ref(), table.half_tangent.as_ref()],
    };
    flying(source, reader, &table.mass_kg, shape, &flight)
}

/// The ends of a rod and its centre.
pub(super) fn rod(
    source: Source<'_>,
    reader: &mut Reader<'_>,
    table: &FlyingRod,
) -> Result<(Round<Stated>, Corners<Stated>), Fault> {
    let length = source.number(&table.length_m, "length_m", Domain::Positive)?;
    let flight = Flight {
        position: &table.position_m,
        velocity: &table.velocity_m_s,
        spin: table.spin_rad_s.as_ref(),
        angle: [table.angle_deg.as_ref(), table.half_tangent.as_ref()],
    };
    flying(source, reader, &table.mass_kg, Corners::of_rod(&length), &flight)
}

fn flying(
    source: Source<'_>,
    reader: &mut Reader<'_>,
    mass: &Number,
    (shape, gyration): (Corners<Rational>, Rational),
    flight: &Flight<'_>,
) -> Result<(Round<Stated>, Corners<Stated>), Fault> {
    let Flight { position, velocity, spin, angle: [degrees, tangent] } = flight;
    let mass = source.number(mass, "mass_kg", Domain::Positive)?;
    let turned = match (degrees, tangent) {
        (None, None) => shape,
        _ => {
            let direction = reader.heading(*degrees, *tangent, "")?;
            let (c, s) = (&direction.cos, &direction.sin);
            Corners(shape.0.iter().map(|[x, y]| [c * x - s * y, s * x + c * y]).collect())
        }
    };
    let motion: Motion<Stated> = reader.motion(velocity, *spin, "0")?;
    let centre = Round {
        inertia: (&mass * gyration).into(),
        mass: mass.into(),
        radius: Stated::default(),
        position: reader.pair(position, "position_m", ["x", "y"], "m", Domain::Any)?,
        motion,
        off_plane: None,
    };
    Ok((centre, turned.map(|x| x.clone().into())))
}

/// No corner may be inside a wall.
pub(super) fn outside(source: Source<'_>, world: &World<Stated>) -> Result<(), Fault> {
    let Some(corners) = &world.corners else { return Ok(()) };
    let exact = world.map(|stated| stated.value.clone());
    for (number, [x, y]) in corners.0.iter().enumerate() {
        let corner = Round {
            position: [
                &exact.bodies[0].position[0] + &x.value,
                &exact.bodies[0].position[1] + &y.value,
            ],
            ..exact.bodies[0].clone()
        };
        for (side, plane) in exact.as_planes() {
            if plane.gap(&corner, &Rational::default()) < Rational::default() {
                let message = format!("corner {} is inside the {}", number + 1, side.name());
                return Err(source.fault(0..0, message));
            }
        }
    }
    Ok(())
}
