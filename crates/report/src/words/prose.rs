//! Sentences of the matrix: words, and between backticks formulas in its symbols.

use kane_algebra::syntax::{Scope, parse_expr, parse_sentence};
use kane_kernel::Sentence;
use kane_matrix::symbols;

use super::{Form, Formulas, words};

/// Writes sentences of the matrix in one form.
pub(crate) struct Prose {
    form: Form,
    scope: Scope,
    formulas: Formulas,
}

impl Prose {
    pub(crate) fn new(form: Form) -> Self {
        let scope = symbols();
        let formulas = Formulas::new(form, scope.context(), &[]);
        Self { form, scope, formulas }
    }

    /// A sentence; what stands between backticks is set as a formula.
    pub(crate) fn sentence(&self, text: &str) -> String {
        let pieces = text.split('`').enumerate();
        pieces.map(|(i, piece)| self.piece(piece, i % 2 == 1)).collect()
    }

    fn piece(&self, text: &str, is_formula: bool) -> String {
        if is_formula { self.formula(text) } else { words(text, self.form) }
    }

    /// What is one formula, or a list of them, or else words.
    pub(crate) fn formula(&self, text: &str) -> String {
        if self.form == Form::Plain {
            return text.to_owned();
        }
        let read = readable(text);
        if let Ok(sentence) = parse_sentence(&read, &self.scope) {
            return self.said(&sentence);
        }
        if let Ok(expr) = parse_expr(&read, &self.scope) {
            return self.formulas.expr(&expr);
        }
        match text.split_once(", ") {
            Some((first, rest)) => format!("{}, {}", self.formula(first), self.formula(rest)),
            None => words(text, self.form),
        }
    }

    fn said(&self, sentence: &Sentence) -> String {
        let relations: Vec<_> = sentence.relations().cloned().collect();
        let mut links: Vec<String> = sentence.limits().map(|l| self.formulas.limit(l)).collect();
        if !relations.is_empty() {
            links.push(self.formulas.relations(&relations));
        }
        let links = links.join(", ");
        match &sentence.when[..] {
            [] => links,
            when => format!("{links} when {}", self.formulas.relations(when)),
        }
    }
}

/// The formula with `d_` for each `d` alone, which the notation keeps for derivatives.
fn readable(text: &str) -> String {
    let continues = |c: char| c.is_alphanumeric() || matches!(c, '_' | '\'');
    let mut out = String::with_capacity(text.len());
    for (at, c) in text.char_indices() {
        let stands_alone =
            !text[..at].ends_with(continues) && !text[at + c.len_utf8()..].starts_with(continues);
        out.push(c);
        if c == 'd' && stands_alone {
            out.push('_');
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_d_that_stands_alone_is_a_symbol_and_one_in_a_name_is_a_letter() {
        for (text, read) in [("d", "d_"), ("2*d + 1", "2*d_ + 1"), ("(d)", "(d_)"), ("e*d", "e*d_")]
        {
            assert_eq!(readable(text), read);
        }
        for name in ["dv", "ad", "v_d", "d_0", "d'", "adv", "d1", "e"] {
            assert_eq!(readable(name), name);
        }
    }
}
