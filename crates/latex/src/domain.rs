//! Guesses at the range of a symbol: what the running text says of it, or its customary meaning.

use std::collections::BTreeMap;

use crate::name::Names;
use crate::relation::statement;

/// A range that is guessed, and from what.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Domain {
    /// before the name, `0 <= `
    pub(crate) lower: String,
    /// behind the name, ` <= 1`
    pub(crate) upper: String,
    /// why
    pub(crate) reason: String,
}

/// What formulas of the running text say of the range of a symbol: `m > 0`, `0 \le e \le 1`.
pub(crate) fn stated(inline: &[String]) -> BTreeMap<String, String> {
    let mut out = BTreeMap::new();
    for latex in inline {
        let Ok(read) = statement(latex, &mut Names::default()) else { continue };
        if read.limit.is_some() || read.when.is_some() || read.defines.is_some() {
            continue;
        }
        for part in read.relations.split(", ") {
            let words: Vec<&str> = part.split(' ').collect();
            let number = |text: &str| text.trim_start_matches('-').parse::<f64>().is_ok();
            let name = |text: &str| text.starts_with(char::is_alphabetic) && text != "oo";
            let order = |sign: &str| matches!(sign, "<" | "<=" | ">" | ">=");
            let x = match words.as_slice() {
                [x, sign, a] if name(x) && order(sign) && number(a) => *x,
                [a, low, x, high, b]
                    if name(x) && number(a) && number(b) && order(low) && order(high) =>
                {
                    *x
                }
                _ => continue,
            };
            let is_symbol = |c: char| c.is_alphanumeric() || matches!(c, '_' | '\'');
            if x.chars().all(is_symbol) {
                let said = format!("the text has {}", part.trim());
                out.entry(x.to_owned()).or_insert(said);
            }
        }
    }
    out
}

/// What a letter customarily stands for, if a word of the text says that it may.
pub(crate) fn customary(name: &str, text: &str) -> Option<Domain> {
    let base: String = name.chars().take_while(|c| c.is_ascii_alphabetic()).collect();
    let meanings: [(&str, &[&str], &str, &str); 7] = [
        ("m", &["mass"], "", " > 0"),
        ("M", &["mass"], "", " > 0"),
        ("J", &["inertia"], "", " > 0"),
        ("r", &["radius"], "", " > 0"),
        ("R", &["radius"], "", " > 0"),
        ("mu", &["friction"], "", " >= 0"),
        ("e", &["restitution"], "0 <= ", " <= 1"),
    ];
    let bare = name == base || name.strip_prefix(&base).is_some_and(|rest| rest.starts_with('_'));
    meanings
        .iter()
        .find(|(letter, words, ..)| {
            bare && *letter == base && words.iter().any(|word| text.contains(word))
        })
        .map(|(_, words, lower, upper)| Domain {
            lower: (*lower).to_owned(),
            upper: (*upper).to_owned(),
            reason: format!("the text speaks of {}", words[0]),
        })
}
