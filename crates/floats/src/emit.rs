//! Formulas as functions in Rust, C and Python.

use std::fmt::Write as _;

use kane_kernel::Rel;
use kane_number::Rational;

use crate::machine::rounded;
use crate::{Core, Operation, Precision, Test, text};

mod branches;
mod names;

pub(crate) use names::{arguments, identifier};

/// A programming language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// Rust
    Rust,
    /// C99, with `math.h`
    C,
    /// Python 3; `f32` by NumPy's `float32`, where a fused operation is rounded twice; `fma` from 3.13 on
    Python,
}

impl Language {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Rust, Self::C, Self::Python];

    /// Its name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Rust => "Rust",
            Self::C => "C",
            Self::Python => "Python",
        }
    }
}

/// The formula as a function that carries out exactly these operations in this order, one a line, in a
/// format. Compilers that keep to IEEE 754 return what is bounded here (no `-ffast-math`, and for C
/// `-ffp-contract=off`).
#[must_use]
pub fn emit(core: &Core, precision: Precision, language: Language) -> String {
    let arguments = arguments(core);
    Writer { core, arguments: &arguments, precision, language, named: &|_, _, _| None }.function()
}

/// Writes a formula in a language.
pub(crate) struct Writer<'a> {
    pub(crate) core: &'a Core,
    /// what its arguments are called
    pub(crate) arguments: &'a [String],
    pub(crate) precision: Precision,
    pub(crate) language: Language,
    /// comparisons that are functions by their names; the others are compared as they stand
    pub(crate) named: &'a dyn Fn(Rel, usize, usize) -> Option<String>,
}

impl Writer<'_> {
    /// The formula as a function.
    pub(crate) fn function(&self) -> String {
        let name = identifier(self.core.name.as_deref().unwrap_or("f"));
        let arguments = self.arguments;
        let float = match (self.language, self.precision) {
            (Language::Rust, precision) => precision.name(),
            (_, Precision::F32) => "float",
            (_, Precision::F64) => "double",
        };
        let mut text = String::new();
        match self.language {
            Language::Rust => {
                let typed: Vec<String> =
                    arguments.iter().map(|a| format!("{a}: {float}")).collect();
                writeln!(text, "pub fn {name}({}) -> {float} {{", typed.join(", "))
            }
            Language::C => {
                let typed: Vec<String> = arguments.iter().map(|a| format!("{float} {a}")).collect();
                writeln!(text, "{float} {name}({}) {{", typed.join(", "))
            }
            Language::Python => writeln!(text, "def {name}({}):", arguments.join(", ")),
        }
        .expect("a string takes all");
        if self.language == Language::Python && self.precision == Precision::F32 {
            for argument in arguments {
                writeln!(text, "    {argument} = float32({argument})").expect("a string takes all");
            }
        }
        if self.language == Language::Python
            && let Some((lines, value)) = self.by_branches()
        {
            write!(text, "{lines}    return {value}").expect("a string takes all");
            return text;
        }
        let needed = self.core.program.needed(self.core.root);
        for (index, operation) in self.core.program.operations().iter().enumerate() {
            let is_leaf = matches!(operation, Operation::Number(_) | Operation::Input(_));
            if needed.get(index) != Some(&true) || is_leaf || index == self.core.root {
                continue;
            }
            let value = self.operation(operation);
            match self.language {
                Language::Rust => writeln!(text, "    let t{index} = {value};"),
                Language::C => writeln!(text, "    const {float} t{index} = {value};"),
                Language::Python => writeln!(text, "    t{index} = {value}"),
            }
            .expect("a string takes all");
        }
        let last = match self.core.program.get(self.core.root) {
            Some(Operation::Number(_) | Operation::Input(_)) | None => self.at(self.core.root),
            Some(operation) => self.operation(operation),
        };
        match self.language {
            Language::Rust => write!(text, "    {last}\n}}"),
            Language::C => write!(text, "    return {last};\n}}"),
            Language::Python => write!(text, "    return {last}"),
        }
        .expect("a string takes all");
        text
    }

    fn at(&self, index: usize) -> String {
        match self.core.program.get(index) {
            Some(Operation::Number(number)) => self.number(number),
            Some(Operation::Input(input)) => {
                self.arguments.get(*input).cloned().unwrap_or_default()
            }
            _ => format!("t{index}"),
        }
    }

    /// The float that a constant is rounded to, by its shortest decimal.
    fn number(&self, number: &Rational) -> String {
        let wide = match self.precision {
            Precision::F32 => f64::from(rounded::<f32>(number)),
            Precision::F64 => rounded::<f64>(number),
        };
        if wide.is_infinite() {
            return infinity(self.language, self.precision, wide.is_sign_negative());
        }
        let digits = match self.precision {
            Precision::F32 => format!("{:?}", rounded::<f32>(number)),
            Precision::F64 => format!("{:?}", rounded::<f64>(number)),
        };
        let digits = match (self.language, self.precision) {
            (Language::Rust, precision) => format!("{digits}_{}", precision.name()),
            (Language::C, Precision::F32) => format!("{digits}f"),
            (Language::Python, Precision::F32) => format!("float32({digits})"),
            _ => digits,
        };
        if wide.is_sign_negative() { format!("({digits})") } else { digits }
    }

    fn operation(&self, operation: &Operation) -> String {
        let at = |index: &usize| self.at(*index);
        let single = if self.precision == Precision::F32 { "f" } else { "" };
        let call = |rust: &str, c: &str, python: &str, operands: &[&usize]| {
            let operands: Vec<String> = operands.iter().map(|index| at(index)).collect();
            match self.language {
                Language::Rust => {
                    let (first, rest) =
                        operands.split_first().map_or(("", &[][..]), |(f, r)| (f, r));
                    format!("{first}.{rust}({})", rest.join(", "))
                }
                Language::C => format!("{c}{single}({})", operands.join(", ")),
                // these functions return doubles
                Language::Python if self.precision == Precision::F32 => {
                    format!("float32({python}({}))", operands.join(", "))
                }
                Language::Python => format!("{python}({})", operands.join(", ")),
            }
        };
        match operation {
            Operation::Number(_) | Operation::Input(_) => String::new(),
            Operation::Neg(a) => format!("-{}", at(a)),
            Operation::Add(a, b) => format!("{} + {}", at(a), at(b)),
            Operation::Sub(a, b) => format!("{} - {}", at(a), at(b)),
            Operation::Mul(a, b) => format!("{} * {}", at(a), at(b)),
            Operation::Div(a, b) => format!("{} / {}", at(a), at(b)),
            Operation::Sqrt(a) => call("sqrt", "sqrt", "sqrt", &[a]),
            Operation::Fma(a, b, c) => call("mul_add", "fma", "fma", &[a, b, c]),
            Operation::Abs(a) => call("abs", "fabs", "abs", &[a]),
            Operation::Min(a, b) => call("min", "fmin", "min", &[a, b]),
            Operation::Max(a, b) => call("max", "fmax", "max", &[a, b]),
            Operation::If(test, a, b) => {
                let guard = self.guard(test);
                match self.language {
                    Language::Rust => format!("if {guard} {{ {} }} else {{ {} }}", at(a), at(b)),
                    Language::C => format!("({guard}) ? {} : {}", at(a), at(b)),
                    Language::Python => format!("{} if {guard} else {}", at(a), at(b)),
                }
            }
        }
    }

    /// A test in the language.
    fn guard(&self, test: &Test) -> String {
        let compare = |rel, a, b| self.comparison(rel, a, b);
        text::condition(test, words(self.language), &compare)
    }

    /// A comparison, by its function if it has one.
    fn comparison(&self, rel: Rel, a: usize, b: usize) -> String {
        match (self.named)(rel, a, b) {
            None => format!("{} {} {}", self.at(a), text::sign(rel), self.at(b)),
            Some(name) => {
                let widened = |argument: &String| match (self.language, self.precision) {
                    (Language::Rust, Precision::F32) => format!("f64::from({argument})"),
                    _ => argument.clone(),
                };
                let arguments: Vec<String> = self.arguments.iter().map(widened).collect();
                format!("{name}({})", arguments.join(", "))
            }
        }
    }
}

/// How a language says conditions.
pub(crate) const fn words(language: Language) -> &'static text::Words {
    match language {
        Language::Rust => {
            &text::Words { all: " && ", any: " || ", not: "!", yes: "true", no: "false" }
        }
        Language::C => &text::Words { all: " && ", any: " || ", not: "!", yes: "1", no: "0" },
        Language::Python => {
            &text::Words { all: " and ", any: " or ", not: "not ", yes: "True", no: "False" }
        }
    }
}

/// What a constant beyond every float is rounded to.
pub(crate) fn infinity(language: Language, precision: Precision, negative: bool) -> String {
    let name = match language {
        Language::Rust => format!("{}::INFINITY", precision.name()),
        Language::C => "INFINITY".to_owned(),
        Language::Python => "inf".to_owned(),
    };
    if negative { format!("(-{name})") } else { name }
}

/// A comment of one line before a function.
pub(crate) fn comment(language: Language, text: &str) -> String {
    match language {
        Language::Rust => format!("/// {text}"),
        // a name may end so
        Language::C => format!("/* {} */", text.replace("*/", "* /")),
        Language::Python => format!("# {text}"),
    }
}
