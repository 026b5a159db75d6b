//! Certified comparisons as functions in Rust, C and Python.

use std::fmt::Write as _;

use kane_kernel::Rel;

use super::compared::{Decision, decisions};
use super::exact::Steps;
use crate::emit::{Writer, arguments, comment, identifier};
use crate::{Core, Language, Precision};

/// The certified comparisons of a formula as functions, and the formula that calls them in place of its own; it
/// rounds as before, and takes the branch that exact numbers take. `None` without a comparison that
/// rounding may turn. They need [`super::prelude`] once.
///
/// A comparison is that of the exact values at finite inputs where both have one. First come floats with a
/// running bound on their distance from the exact values; where the difference is within that bound, exact
/// numbers decide.
#[must_use]
pub fn certified(core: &Core, precision: Precision, language: Language) -> Option<String> {
    let all = decisions(core);
    let name = identifier(core.name.as_deref().unwrap_or("f"));
    let arguments = arguments(core);
    let function = |index| {
        Function { core, arguments: &arguments, language, all: &all, name: &name, index }.text()
    };
    let functions: Vec<Option<String>> = (0..all.len()).map(function).collect();
    if functions.iter().all(Option::is_none) {
        return None;
    }
    let called: Vec<Option<String>> = functions
        .iter()
        .enumerate()
        .map(|(index, text)| text.as_ref().map(|_| function_name(&name, index)))
        .collect();
    let mut parts: Vec<String> = functions.into_iter().flatten().collect();
    let mut named = core.clone();
    named.name = Some(format!("{name}_certified"));
    let what = "The same operations; which branch is taken is certified.";
    let named_by = |rel: Rel, a: usize, b: usize| {
        let place = all.iter().position(|known| known.rel == rel && known.operands == (a, b))?;
        called.get(place)?.clone()
    };
    let function =
        Writer { core: &named, arguments: &arguments, precision, language, named: &named_by };
    parts.push(format!("{}\n{}", comment(language, what), function.function()));
    Some(parts.join("\n\n"))
}

/// What the function of a comparison of a formula is called, by its index.
#[must_use]
pub fn function_name(formula: &str, index: usize) -> String {
    format!("{}_decides_{}", identifier(formula), index + 1)
}

/// One comparison.
pub(super) struct Function<'a> {
    pub(super) core: &'a Core,
    /// what its arguments are called
    pub(super) arguments: &'a [String],
    pub(super) language: Language,
    pub(super) all: &'a [Decision],
    pub(super) name: &'a str,
    pub(super) index: usize,
}

impl Function<'_> {
    /// `None` if there is no exact version.
    fn text(&self) -> Option<String> {
        let decision = self.all.get(self.index)?;
        let steps = Steps::of(self.core, decision)?;
        let filter = self.filter(decision)?;
        let name = function_name(self.name, self.index);
        let what = decision.text(self.core);
        // a name may be a tag for those who read documentation as HTML, and has no backtick
        let mark = if self.language == Language::Rust { "`" } else { "" };
        let mut text =
            comment(self.language, &format!("Whether {mark}{what}{mark}, of exact values."));
        let typed = |before: &str, after: &str| {
            let typed: Vec<String> = self
                .arguments
                .iter()
                .map(|argument| format!("{before}{argument}{after}"))
                .collect();
            typed.join(", ")
        };
        text.push('\n');
        match self.language {
            Language::Rust => writeln!(text, "pub fn {name}({}) -> bool {{", typed("", ": f64")),
            Language::C => writeln!(text, "int {name}({}) {{", typed("double ", "")),
            Language::Python => writeln!(text, "def {name}({}):", typed("", "")),
        }
        .expect("a string takes all");
        if self.language == Language::Python {
            for argument in self.arguments {
                writeln!(text, "    {argument} = float({argument})").expect("a string takes all");
            }
        }
        text.push_str(&filter);
        self.exact(&steps, &mut text);
        text.push_str(match self.language {
            Language::Python => "",
            _ => "}",
        });
        Some(text.trim_end().to_owned())
    }

    pub(super) fn argument(&self, index: usize) -> &str {
        self.arguments.get(index).map_or("", String::as_str)
    }

    pub(super) fn line(&self, indent: &str, name: &str, value: &str) -> String {
        match self.language {
            Language::Rust => format!("{indent}let {name} = {value};\n"),
            Language::C => format!("{indent}const double {name} = {value};\n"),
            Language::Python => format!("{indent}{name} = {value}\n"),
        }
    }

    pub(super) fn call(&self, rust: &str, other: &str, operands: &[&str]) -> String {
        match (self.language, operands.split_first()) {
            (Language::Rust, Some((first, rest))) => {
                format!("({first}).{rust}({})", rest.join(", "))
            }
            _ => format!("{other}({})", operands.join(", ")),
        }
    }

    pub(super) fn magnitude(&self, of: &str) -> String {
        self.call("abs", if self.language == Language::C { "fabs" } else { "abs" }, &[of])
    }

    pub(super) fn choose(&self, truth: &str, a: &str, b: &str) -> String {
        match self.language {
            Language::Rust => format!("if {truth} {{ {a} }} else {{ {b} }}"),
            Language::C => format!("({truth}) ? {a} : {b}"),
            Language::Python => format!("{a} if {truth} else {b}"),
        }
    }

    pub(super) fn constants(&self) -> [&'static str; 4] {
        match self.language {
            Language::Rust => ["HALF", "MORE", "TINY", "f64::INFINITY"],
            Language::C => ["KANE_HALF", "KANE_MORE", "KANE_TINY", "INFINITY"],
            Language::Python => ["HALF", "MORE", "TINY", "inf"],
        }
    }
}
