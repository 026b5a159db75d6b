//! What a file asks for.

use std::collections::BTreeMap;

use kane_number::Rational;
use serde::Deserialize;
use toml::Spanned;

use super::number::Domain;
use super::source::{Fault, Number, Source};
use crate::quantity::{Kind, Quantity};
use crate::scene::{Asked, Setup};
use crate::simulate::Until;
use crate::world::World;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct UntilTable {
    impacts: Option<Number>,
    duration_s: Option<Number>,
    rest: Option<Spanned<bool>>,
}

/// When to stop.
pub(super) fn until<N>(
    source: Source<'_>,
    table: &Spanned<UntilTable>,
    world: &World<N>,
) -> Result<Until<Rational>, Fault> {
    let UntilTable { impacts, duration_s, rest } = table.get_ref();
    match (impacts, duration_s, rest) {
        (Some(impacts), None, None) => match impacts.get_ref() {
            toml::Value::Integer(count) if *count > 0 => {
                Ok(Until::Impacts(u64::try_from(*count).unwrap_or(u64::MAX)))
            }
            _ => Err(source.fault(impacts.span(), "impacts must be a whole number above 0")),
        },
        (None, Some(time), None) => {
            Ok(Until::Duration(source.number(time, "duration_s", Domain::Positive)?))
        }
        (None, None, Some(rest)) if *rest.get_ref() && world.is_in_space() => {
            let message =
                "rest is described in the plane of x and y alone; give impacts or duration_s";
            Err(source.fault(rest.span(), message))
        }
        (None, None, Some(rest)) if *rest.get_ref() => Ok(Until::Rest),
        (None, None, Some(rest)) => Err(source.fault(rest.span(), "rest can only be true")),
        _ => {
            Err(source
                .fault(table.span(), "[until] needs exactly one of impacts, duration_s and rest"))
        }
    }
}

/// The quantities, each with its tolerance.
pub(super) fn asked<N>(
    source: Source<'_>,
    table: &BTreeMap<Spanned<String>, Number>,
    setup: &Setup<N>,
) -> Result<Vec<Asked>, Fault> {
    let mut in_order: Vec<_> = table.iter().collect();
    in_order.sort_by_key(|(key, _)| key.span().start);
    let mut asked = Vec::new();
    for (key, tolerance) in in_order {
        let quantity =
            Quantity::parse(key.get_ref()).map_err(|error| source.fault(key.span(), error))?;
        let tolerance = source.number(
            tolerance,
            &format!("the tolerance of {quantity}"),
            Domain::NotNegative,
        )?;
        match setup {
            Setup::Bodies(world) if quantity.body >= world.bodies.len() => {
                let count = world.bodies.len();
                return Err(source.fault(key.span(), format!("there are {count} bodies")));
            }
            Setup::Bodies(world) if quantity.kind == Kind::Turned && world.corners.is_none() => {
                return Err(source.fault(key.span(), "turned_rad is of a [polygon] or a [rod]"));
            }
            Setup::Bodies(world) if quantity.kind.is_off_plane() && !world.is_in_space() => {
                let message = format!("{quantity} is of spheres in space");
                return Err(source.fault(key.span(), message));
            }
            Setup::Tip(_) if !quantity.kind.is_of_a_tip() => {
                return Err(source.fault(
                    key.span(),
                    "one impact of a tip answers k, v_t_m_s, v_n_m_s, p_t_n_s, p_n_n_s and energy_ratio",
                ));
            }
            _ => asked.push(Asked { quantity, tolerance }),
        }
    }
    if asked.is_empty() {
        let message =
            "nothing is asked; [ask] needs a quantity with a tolerance, as `v_x_m_s = 1e-6`";
        return Err(source.fault(0..0, message));
    }
    Ok(asked)
}
