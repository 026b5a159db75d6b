//! What is said to somebody whose word the language does not know.

use std::ops::Range;

use kane_algebra::syntax::{Lines, Symbol, canonical_name, nearest};

use super::{MAX_CANDIDATES, Reader};

/// What to say of a name that is used like a function and is none.
const FUNCTIONS: &str = "functions are `abs`, `min`, `max`, `sqrt`, and `sin`, `cos`, `tan` of angles; others are \
                         declared, `var f(x)`, or defined, `let f(x) := …`";

/// What to say of π where it is no multiple of an angle.
const PI: &str = "π stands inside `sin`, `cos`, `tan` and in the bounds of an angle; elsewhere a number takes its place \
                  of which no more is known than is said: `var 333/106 < pi < 355/113`";

/// Functions that others have, and how what they are is said here.
const ELSEWHERE: [(&[&str], &str); 7] = [
    (&["sinh", "cosh", "tanh"], "it is made of exponentials: `(exp(x) - exp(-x))/2`"),
    (&["ln"], "the natural logarithm is `log(x)`, of what is declared positive: `var x > 0`"),
    (
        &["arcsin", "arccos", "arctan", "asin", "acos", "atan", "atan2"],
        "an angle is declared, and what is known of it given: `var theta`, `given slope: tan(theta) = y/x`",
    ),
    (
        &["Sum", "Prod", "product"],
        "a sum is `sum(f for k in 1..n)`, a product `prod(f for k in 1..n)`",
    ),
    (&["lim", "limit"], "a limit is claimed as `f -> L as x -> a`"),
    (&["cbrt", "root"], "a root is a symbol: `var r >= 0`, `given root: r^3 = f`"),
    (&["diff", "D", "integrate", "int"], "a derivative is `d(f, x)`; an integral is what has it"),
];

/// Words with which statements begin elsewhere.
const BEGINNINGS: [(&str, &[&str]); 4] = [
    ("var", &["variable", "variables", "vars", "symbol", "symbols", "real", "param", "const"]),
    ("let", &["def", "define", "definition", "set", "where"]),
    ("given", &["assume", "assumption", "assuming", "suppose", "hypothesis", "axiom", "premise"]),
    ("claim", &["prove", "proof", "theorem", "lemma", "show", "assert", "check", "conclude"]),
];

/// The statement that begins with a word like this one, of those that begin with `keywords`.
pub(super) fn beginning(word: &str, keywords: [&'static str; 4]) -> Option<String> {
    let word = word.to_lowercase();
    let other = BEGINNINGS.iter().find(|(_, words)| words.contains(&&*word));
    let meant = other.map(|(keyword, _)| *keyword).or_else(|| nearest(&word, keywords));
    meant.map(|meant| format!("did you mean `{meant}`?"))
}

impl Reader {
    /// What to say of the name at `span` of `text`, which nothing declares.
    pub(super) fn hint_at_unknown(&self, name: &str, span: &Range<usize>, text: &str) -> String {
        let is_called = text.get(span.end..).is_some_and(|behind| behind.starts_with('('));
        if is_called && let Some((_, hint)) = ELSEWHERE.iter().find(|(of, _)| of.contains(&name)) {
            return (*hint).to_owned();
        }
        if canonical_name(name) == "pi" && self.scope.is_unused("pi") {
            return PI.to_owned();
        }
        let derivative = self.hint_at_derivative(name, span, text);
        derivative.or_else(|| self.hint_at_name(name, text)).unwrap_or_else(|| match is_called {
            // `exp(x)` is no symbol that one forgot
            true => FUNCTIONS.to_owned(),
            false => format!("a symbol is declared above its first use: `var {name}`"),
        })
    }

    /// Of `x'`, where `x` is a function, and of the halves of `dE/dt`.
    fn hint_at_derivative(&self, name: &str, span: &Range<usize>, text: &str) -> Option<String> {
        let name = canonical_name(name);
        let bare = name.trim_end_matches('\'');
        if bare.len() < name.len()
            && let Some(Symbol::Var(v)) = self.scope.resolve(bare)
        {
            let vars = &self.scope.context().vars;
            let of = vars.get(v).and_then(|var| vars.get(var.of?))?;
            return Some(format!("a derivative is written `d({bare}, {})`", of.name));
        }
        let before = text.get(..span.start).is_some_and(|text| text.trim_end().ends_with('/'));
        let behind = text.get(span.end..).is_some_and(|text| text.trim_start().starts_with('/'));
        let of = name.strip_prefix('d').filter(|of| self.scope.resolve(of).is_some());
        of.filter(|_| before || behind).map(|_| "a derivative is written `d(f, x)`".to_owned())
    }

    fn hint_at_name(&self, unknown: &str, text: &str) -> Option<String> {
        let site = match self.scope.resolve(unknown) {
            Some(Symbol::Var(index)) => self.var_sites.get(index),
            Some(Symbol::Let(index)) => self.let_sites.get(index),
            None => None,
        };
        if let Some(site) = site {
            let line = Lines::new(text).place(*site).line;
            return Some(format!("it is declared below its use, on line {line}"));
        }
        if let Some(array) = self.scope.array(unknown) {
            let parts = array.shape.names(unknown).join("`, `");
            return Some(format!("it is {}; its components are `{parts}`", array.shape));
        }
        if self.scope.is_sequence(unknown) {
            return Some("it is a sequence".to_owned());
        }
        if self.scope.is_function(unknown) {
            return Some("it is a definition with arguments".to_owned());
        }
        if self.var_sites.len() + self.let_sites.len() > MAX_CANDIDATES {
            return None;
        }
        nearest(canonical_name(unknown).as_ref(), self.scope.names())
            .map(|name| format!("did you mean `{name}`?"))
    }

    pub(super) fn hint_at_label(&self, key: &str) -> Option<String> {
        if self.labels.len() > MAX_CANDIDATES {
            return None;
        }
        let key = nearest(key, self.labels.keys().map(String::as_str))?;
        let draft = self.drafts.get(*self.labels.get(key)?)?;
        Some(format!("did you mean `{}`?", draft.label))
    }

    /// Keeps the words of a statement that could not be read: what it was to declare is not missing besides.
    pub(super) fn lose(&mut self, statement: &str) {
        let words = statement.split(|c: char| !c.is_alphanumeric() && !"_'′-.".contains(c));
        self.lost.extend(words.map(|word| canonical_name(word).into_owned()));
    }

    /// Whether a statement that could not be read may have declared this name or label.
    pub(super) fn may_be_lost(&self, name: &str) -> bool {
        self.lost.contains(canonical_name(name).as_ref())
    }
}
