//! The theory at the beginning of a file: rules of proof, and their soundness proved in Coq itself.

use std::collections::HashSet;
use std::sync::OnceLock;

/// A part of the theory, which rests on those before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Part {
    /// claims at a point
    Points,
    /// points at which a claim fails
    Witnesses,
    /// limits, and claims that rest on them
    Limits,
    /// functions that meet premises; needs all the others
    Functions,
}

const POINTS: [&str; 10] = [
    include_str!("theory/polynomials.v"),
    include_str!("theory/conditions.v"),
    include_str!("theory/expressions.v"),
    include_str!("theory/near.v"),
    include_str!("theory/derivatives.v"),
    include_str!("theory/regions.v"),
    include_str!("theory/sentences.v"),
    include_str!("theory/rules.v"),
    include_str!("theory/germs.v"),
    include_str!("theory/claims.v"),
];
const WITNESSES: [&str; 1] = [include_str!("theory/witnesses.v")];
const LIMITS: [&str; 3] = [
    include_str!("theory/limits.v"),
    include_str!("theory/along.v"),
    include_str!("theory/limits_sound.v"),
];
const FUNCTIONS: [&str; 2] =
    [include_str!("theory/functions.v"), include_str!("theory/functions_sound.v")];

/// The parts that claims need, in order.
pub(super) fn theory(needed: &[Part]) -> String {
    let needs = |part: Part| needed.contains(&part) || needed.contains(&Part::Functions);
    let mut texts = POINTS.to_vec();
    if needs(Part::Witnesses) {
        texts.extend(WITNESSES);
    }
    if needs(Part::Limits) {
        texts.extend(LIMITS);
    }
    if needs(Part::Functions) {
        texts.extend(FUNCTIONS);
    }
    texts.join("\n")
}

/// All of it.
pub(super) fn whole() -> String {
    theory(&[Part::Witnesses, Part::Limits, Part::Functions])
}

/// Whether the theory, in any of its parts, uses this word. Words of one letter are names of what it
/// binds for itself.
pub(super) fn has_word(word: &str) -> bool {
    static WORDS: OnceLock<HashSet<&str>> = OnceLock::new();
    let apart = |c: char| !(c.is_alphanumeric() || c == '_' || c == '\'');
    let words = WORDS.get_or_init(|| {
        let parts = POINTS.iter().chain(&WITNESSES).chain(&LIMITS).chain(&FUNCTIONS);
        parts.flat_map(|text| text.split(apart)).filter(|word| word.len() > 1).collect()
    });
    words.contains(word)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What prints lemmas, and so names definitions of the theory.
    const PRINTERS: [&str; 12] = [
        include_str!("chain.rs"),
        include_str!("chain_along.rs"),
        include_str!("conclusion.rs"),
        include_str!("family.rs"),
        include_str!("functions.rs"),
        include_str!("lemma.rs"),
        include_str!("limits.rs"),
        include_str!("prose.rs"),
        include_str!("reify.rs"),
        include_str!("script.rs"),
        include_str!("slopes.rs"),
        include_str!("witness.rs"),
    ];

    #[test]
    fn nothing_in_the_theory_is_unused() {
        let text = theory(&[Part::Functions]);
        let words = |text: &str| {
            let apart = |c: char| !(c.is_alphanumeric() || c == '_' || c == '\'');
            text.split(apart).map(str::to_owned).collect::<Vec<String>>()
        };
        let (used, printed) = (words(&text), words(&PRINTERS.concat()));
        let kinds = ["Lemma", "Theorem", "Definition", "Fixpoint", "Inductive", "Record", "Ltac"];
        for pair in used.windows(2).filter(|p| kinds.contains(&p[0].as_str())) {
            let name = &pair[1];
            let times = used.iter().filter(|w| *w == name).count();
            assert!(times > 1 || printed.contains(name), "{name} is used nowhere");
        }
    }
}
