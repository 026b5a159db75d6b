//! Walls at an angle or in motion, and what is stated of single contacts.

use kane_impact::bodies::Direction;
use serde::Deserialize;
use toml::Spanned;

use super::number::Domain;
use super::reader::Reader;
use super::source::{Fault, Number, Source};
use super::stated::{Stated, stated};
use crate::encounter::Encounter;
use crate::plane::Plane;
use crate::side::{MOST_PLANES, Side};
use crate::terms::{Restitution, Terms};
use crate::world::Wall;

/// A wall at an angle.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct PlaneTable {
    through_m: [Number; 2],
    angle_deg: Option<Number>,
    half_tangent: Option<Number>,
    /// Along itself, towards where it points.
    sliding_m_s: Option<Number>,
    /// Towards the room.
    advancing_m_s: Option<Number>,
}

/// What is stated of a contact.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ContactTable {
    between: Option<Spanned<[String; 2]>>,
    friction: Option<Number>,
    restitution: Option<Number>,
    /// The speed at which `restitution` is so, and falls with its fourth root beyond.
    restitution_at_m_s: Option<Number>,
    speeds_m_s: Option<Spanned<Vec<Number>>>,
    restitutions: Option<Vec<Number>>,
}

/// The walls of `[[wall]]`.
pub(super) fn planes(
    source: Source<'_>,
    reader: &mut Reader<'_>,
    tables: &[Spanned<PlaneTable>],
) -> Result<Vec<Plane<Stated>>, Fault> {
    if let Some(beyond) = tables.get(MOST_PLANES) {
        let message = format!("a scene has at most {MOST_PLANES} of [[wall]]");
        return Err(source.fault(beyond.span(), message));
    }
    let plane = |table: &Spanned<PlaneTable>| {
        let PlaneTable { through_m, angle_deg, half_tangent, sliding_m_s, advancing_m_s } =
            table.get_ref();
        let Direction { cos, sin } =
            reader.heading(angle_deg.as_ref(), half_tangent.as_ref(), "")?;
        let speed = |number: &Option<Number>, key: &str| match number {
            Some(number) => stated(source, number, key, Domain::Any),
            None => Ok(Stated::default()),
        };
        Ok(Plane {
            // the room is on the left of where the wall points
            normal: [(-sin).into(), cos.into()],
            through: reader.pair(through_m, "through_m", ["x", "y"], "m", Domain::Any)?,
            velocity: [speed(sliding_m_s, "sliding_m_s")?, speed(advancing_m_s, "advancing_m_s")?],
        })
    };
    tables.iter().map(plane).collect()
}

/// The contacts of `[[contact]]`.
pub(super) fn terms(
    source: Source<'_>,
    tables: &[Spanned<ContactTable>],
    walls: &[Wall<Stated>],
    planes: usize,
    bodies: usize,
) -> Result<Vec<Terms<Stated>>, Fault> {
    let one = |table: &Spanned<ContactTable>| {
        let ContactTable { between, friction, .. } = table.get_ref();
        let between = between.as_ref().map(|ids| encounter(source, ids, walls, planes, bodies));
        let friction =
            friction.as_ref().map(|mu| stated(source, mu, "friction", Domain::NotNegative));
        let terms = Terms {
            between: between.transpose()?,
            friction: friction.transpose()?,
            restitution: restitution(source, table)?,
        };
        if terms.friction.is_none() && terms.restitution.is_none() {
            let message = "[[contact]] states neither friction nor restitution";
            return Err(source.fault(table.span(), message));
        }
        Ok(terms)
    };
    tables.iter().map(one).collect()
}

/// e of a contact, in one of three forms.
fn restitution(
    source: Source<'_>,
    table: &Spanned<ContactTable>,
) -> Result<Option<Restitution<Stated>>, Fault> {
    let ContactTable { restitution, restitution_at_m_s, speeds_m_s, restitutions, .. } =
        table.get_ref();
    let value = |e: &Number| stated(source, e, "restitution", Domain::Fraction);
    match (restitution, restitution_at_m_s, speeds_m_s, restitutions) {
        (None, None, None, None) => Ok(None),
        (Some(e), None, None, None) => Ok(Some(Restitution::Constant(value(e)?))),
        (Some(e), Some(speed), None, None) => {
            let speed = stated(source, speed, "restitution_at_m_s", Domain::Positive)?;
            Ok(Some(Restitution::QuarterPower { speed, value: value(e)? }))
        }
        (None, None, Some(speeds), Some(values)) => {
            let place = speeds.span();
            let speeds = speeds.get_ref();
            if speeds.is_empty() || speeds.len() != values.len() {
                let message = "speeds_m_s and restitutions need the same number of entries, at least one";
                return Err(source.fault(place, message));
            }
            let mut points: Vec<[Stated; 2]> = Vec::new();
            for (speed, e) in speeds.iter().zip(values) {
                // a table is measured as a whole: its speeds are where it was
                let at = source.number(speed, "a speed", Domain::NotNegative)?;
                if points.last().is_some_and(|[before, _]| before.value >= at) {
                    return Err(source.fault(speed.span(), "speeds_m_s must grow"));
                }
                points.push([at.into(), value(e)?]);
            }
            Ok(Some(Restitution::Table(points)))
        }
        _ => Err(source.fault(
            table.span(),
            "a restitution is `restitution`, the same with `restitution_at_m_s`, or `speeds_m_s` with `restitutions`",
        )),
    }
}

/// Who meets, by ids.
fn encounter(
    source: Source<'_>,
    ids: &Spanned<[String; 2]>,
    walls: &[Wall<Stated>],
    planes: usize,
    bodies: usize,
) -> Result<Encounter, Fault> {
    let body = |id: &str| {
        let number = id.strip_prefix("body-")?.parse::<usize>().ok()?;
        (1..=bodies).contains(&number).then(|| number - 1)
    };
    let wall = |id: &str| {
        let sides = walls.iter().map(|wall| wall.side);
        let planes = (0..8).map(Side::Plane).take(planes);
        sides.chain(planes).find(|side| side.id() == id)
    };
    let [first, second] = ids.get_ref();
    let found = match (body(first), body(second), wall(first), wall(second)) {
        (Some(i), Some(j), ..) if i != j => Some(Encounter::Pair(i.min(j), i.max(j))),
        (Some(i), _, _, Some(side)) | (_, Some(i), Some(side), _) => Some(Encounter::Wall(i, side)),
        _ => None,
    };
    found.ok_or_else(|| {
        let message = "between names two that can meet: body-1, body-2, …, floor, ceiling, left, right, wall-1, …, as far as the scene has them";
        source.fault(ids.span(), message)
    })
}
