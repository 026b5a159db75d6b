//! Names that a user may ask for, and what to say of one that nobody has.

use kane::algebra::syntax::nearest;
use kane::impact::laws;
use kane::matrix::PROPERTIES;

/// Shorter words are in names by chance.
const TELLING: usize = 3;

/// Up to so many names that contain the word are told; of more, none is likely to be meant.
const FAMILY: usize = 6;

/// The ids that may be meant: those that contain the word, or else the nearest one.
pub(super) fn near<'a>(wanted: &str, ids: impl Iterator<Item = &'a str> + Clone) -> Vec<&'a str> {
    let wanted = wanted.to_lowercase();
    let family: Vec<&str> = ids.clone().filter(|id| id.contains(&wanted)).collect();
    if wanted.chars().count() >= TELLING && (1..=FAMILY).contains(&family.len()) {
        return family;
    }
    nearest(&wanted, ids).into_iter().collect()
}

/// What to say of an id that nobody has: those that may be meant, or else all that there are.
pub(super) fn unknown(what: &str, wanted: &str, ids: &[&str]) -> String {
    match near(wanted, ids.iter().copied()).as_slice() {
        [] => format!("no {what} is called `{wanted}`; there are {}", ids.join(", ")),
        near => format!("no {what} is called `{wanted}`; did you mean `{}`?", near.join("` or `")),
    }
}

/// The laws' ids.
pub(super) fn law_ids() -> Vec<&'static str> {
    laws().iter().map(|law| law.info.id).collect()
}

/// The properties' ids.
pub(super) fn property_ids() -> Vec<&'static str> {
    PROPERTIES.iter().map(|property| property.id).collect()
}

/// The laws' parameters, as `--param` takes them.
pub(super) fn parameter_ids() -> Vec<String> {
    let names = laws().iter().flat_map(|law| {
        law.info.parameters.iter().map(|own| format!("{}.{}", law.info.id, own.name))
    });
    names.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn part_of_a_name_or_a_slip_of_the_pen_finds_it() {
        let laws = law_ids();
        let told = |wanted| unknown("law", wanted, &laws);
        assert!(told("smith").ends_with("did you mean `smith-1991` or `smith-printed`?"));
        assert!(told("Walton ").ends_with("did you mean `walton`?"), "{}", told("Walton "));
        assert!(told("1991").contains("`smith-1991`"));
        assert!(told("zzzzzz").contains("there are "));
        assert!(told("").contains("there are "));
        // letters that are in names by chance are no hint
        assert!(told("er").contains("there are "), "{}", told("er"));
        assert!(told("-").contains("there are "), "{}", told("-"));
    }
}
