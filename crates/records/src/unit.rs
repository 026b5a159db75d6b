//! Units at the ends of names.

/// Units of the schema, as tokens.
const SI: [&[&str]; 9] = [
    &["kg", "m2"],
    &["m", "s2"],
    &["rad", "s"],
    &["n", "s"],
    &["m", "s"],
    &["kg"],
    &["m"],
    &["s"],
    &["ns"],
];

/// Units of others, which are refused rather than converted in silence.
const FOREIGN: [&[&str]; 16] = [
    &["deg", "s"],
    &["degrees", "s"],
    &["rev", "s"],
    &["mm", "s"],
    &["cm", "s"],
    &["km", "h"],
    &["ft", "s"],
    &["kg", "mm2"],
    &["g", "mm2"],
    &["deg"],
    &["rpm"],
    &["mm"],
    &["cm"],
    &["um"],
    &["ms"],
    &["gram"],
];

/// Takes the unit off the end: one of the schema's, or a foreign one.
pub(crate) fn take_unit(tokens: &mut Vec<String>) -> Option<Result<String, String>> {
    let ends = |unit: &&[&str]| {
        tokens.len() > unit.len()
            && tokens[tokens.len() - unit.len()..].iter().zip(unit.iter()).all(|(a, b)| a == b)
    };
    let found = FOREIGN.iter().find(|unit| ends(unit)).map(|unit| (unit, false));
    let found = found.or_else(|| SI.iter().find(|unit| ends(unit)).map(|unit| (unit, true)));
    let (unit, si) = found?;
    tokens.truncate(tokens.len() - unit.len());
    let unit = unit.join("_").replace("ns", "n_s");
    Some(if si { Ok(unit) } else { Err(unit) })
}
