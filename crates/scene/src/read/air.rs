//! The air of a scene's file.

use serde::Deserialize;
use toml::Spanned;

use super::number::Domain;
use super::source::{Fault, Number, Source};
use super::stated::{Stated, stated};
use crate::air::Air;

/// The air, and the coefficients of the bodies in it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct AirTable {
    density_kg_m3: Number,
    drag_coefficient: Option<Number>,
    lift_coefficient: Option<Number>,
}

pub(super) fn air(source: Source<'_>, table: &Spanned<AirTable>) -> Result<Air<Stated>, Fault> {
    let AirTable { density_kg_m3, drag_coefficient, lift_coefficient } = table.get_ref();
    let or_none = |number: &Option<Number>, key: &str, domain| match number {
        Some(number) => stated(source, number, key, domain),
        None => Ok(Stated::default()),
    };
    Ok(Air {
        density: stated(source, density_kg_m3, "density_kg_m3", Domain::NotNegative)?,
        drag: or_none(drag_coefficient, "drag_coefficient", Domain::NotNegative)?,
        lift: or_none(lift_coefficient, "lift_coefficient", Domain::Any)?,
    })
}
