//! Where a statement of an audited text comes from, read off its label.
//!
//! A document that audits a text numbers equations as the text does. `(16)` is the text's equation, `(16n)` and
//! `(25-eta)` are statements about it, and `-r` ends the label of a repair: these are the auditor's, as are names that
//! a document introduces. Other labels are words, for what the text says in prose or asks.

/// Who says it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Origin {
    /// an equation of the text, under its number
    Printed,
    /// what the text says in prose, or a question that it raises
    Words,
    /// about an equation, or a repair, or a name of the document's own
    Ours,
}

impl Origin {
    /// All of them, in the order in which they are offered.
    pub(crate) const ALL: [Self; 3] = [Self::Printed, Self::Words, Self::Ours];

    /// The origin of a statement with this label, which may be a definition.
    pub(crate) fn of(label: &str, is_definition: bool) -> Self {
        let number = label.strip_prefix('(').and_then(|rest| rest.strip_suffix(')'));
        let is_about = number.is_some_and(|n| n.bytes().next().is_some_and(|b| b.is_ascii_digit()));
        if number.is_some_and(|n| !n.is_empty() && n.bytes().all(|b| b.is_ascii_digit())) {
            Self::Printed
        } else if is_about || is_definition || label.ends_with("-r") {
            Self::Ours
        } else {
            Self::Words
        }
    }

    /// Its name in a page.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Printed => "printed",
            Self::Words => "in-words",
            Self::Ours => "ours",
        }
    }

    /// What a reader is told.
    pub(crate) const fn told(self) -> &'static str {
        match self {
            Self::Printed => "printed",
            Self::Words => "in words",
            Self::Ours => "ours",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_is_printed_and_what_stands_behind_it_is_ours() {
        for (label, origin) in [
            ("(16)", Origin::Printed),
            ("(16n)", Origin::Ours),
            ("(25-eta)", Origin::Ours),
            ("over-S-r", Origin::Ours),
            ("(kane)", Origin::Words),
            ("()", Origin::Words),
            ("k-range", Origin::Words),
        ] {
            assert_eq!(Origin::of(label, false), origin, "{label}");
        }
        assert_eq!(Origin::of("k_s", true), Origin::Ours);
    }
}
