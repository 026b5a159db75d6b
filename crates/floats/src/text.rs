//! An operation in the usual notation, with no more parentheses than it needs.

use kane_kernel::Rel;
use kane_number::Rational;

use crate::{Core, Operation, Test};

/// How tightly an operator binds: sums, products, signs, atoms.
const SUM: u8 = 1;
const PRODUCT: u8 = 2;
const SIGN: u8 = 3;
const ATOM: u8 = 4;

impl Core {
    /// The value as a formula in the usual notation.
    #[must_use]
    pub fn text(&self) -> String {
        infix(self, self.root)
    }
}

/// The operation of this index. Shared operations are written out wherever they are used, so that the
/// text of a program may be longer than the program.
#[must_use]
pub fn infix(core: &Core, index: usize) -> String {
    let mut written = Vec::new();
    // operands precede what uses them, so one walk through the list is enough
    for operation in core.program.operations().iter().take(index + 1) {
        let text = one(core, operation, &written);
        written.push(text);
    }
    written.pop().map_or_else(String::new, |(text, _)| text)
}

/// Texts are cut beyond this many bytes, so that sharing cannot make them grow without end.
const MOST: usize = 4_000;

fn one(core: &Core, operation: &Operation, written: &[(String, u8)]) -> (String, u8) {
    let at = |index: &usize, least: u8| {
        let Some((text, binds)) = written.get(*index) else { return String::new() };
        if text.len() > MOST {
            return "…".to_owned();
        }
        if *binds < least { format!("({text})") } else { text.clone() }
    };
    match operation {
        Operation::Number(number) => literal(number),
        Operation::Input(index) => {
            let name = core.arguments.get(*index).map_or("?", |argument| argument.name.as_str());
            (name.to_owned(), ATOM)
        }
        Operation::Neg(a) => (format!("-{}", at(a, SIGN)), SIGN),
        Operation::Add(a, b) => (format!("{} + {}", at(a, SUM), at(b, PRODUCT)), SUM),
        Operation::Sub(a, b) => (format!("{} - {}", at(a, SUM), at(b, PRODUCT)), SUM),
        Operation::Mul(a, b) => (format!("{}*{}", at(a, PRODUCT), at(b, SIGN)), PRODUCT),
        Operation::Div(a, b) => (format!("{}/{}", at(a, PRODUCT), at(b, SIGN)), PRODUCT),
        Operation::Sqrt(a) => (format!("sqrt({})", at(a, 0)), ATOM),
        Operation::Fma(a, b, c) => (format!("fma({}, {}, {})", at(a, 0), at(b, 0), at(c, 0)), ATOM),
        Operation::Abs(a) => (format!("abs({})", at(a, 0)), ATOM),
        Operation::Min(a, b) => (format!("min({}, {})", at(a, 0), at(b, 0)), ATOM),
        Operation::Max(a, b) => (format!("max({}, {})", at(a, 0), at(b, 0)), ATOM),
        Operation::If(test, a, b) => {
            let compare = |rel, a, b| format!("{} {} {}", at(&a, SUM), sign(rel), at(&b, SUM));
            let guard = condition(test, &PLAIN, &compare);
            (format!("(if {guard} then {} else {})", at(a, 0), at(b, 0)), ATOM)
        }
    }
}

/// A number as a literal that reads back as it; fractions as quotients.
fn literal(number: &Rational) -> (String, u8) {
    let text = decimal(number);
    let binds = if text.contains('/') {
        PRODUCT
    } else if text.starts_with('-') {
        SIGN
    } else {
        ATOM
    };
    (text, binds)
}

/// A number in few characters: an integer, a short decimal where it is one, else a fraction.
#[must_use]
pub fn decimal(number: &Rational) -> String {
    if number.is_integer() {
        return number.numer().to_string();
    }
    let mut rest = number.denom().clone();
    let mut places = 0_u32;
    for prime in [2_u32, 5] {
        let mut power = 0;
        while (&rest % prime) == 0_u32.into() {
            rest /= prime;
            power += 1;
        }
        places = places.max(power);
    }
    if rest != 1_u32.into() || places > 25 {
        return number.to_string();
    }
    let scaled = number.numer() * kane_number::Integer::from(10).pow(places) / number.denom();
    let sign = if scaled < 0.into() { "-" } else { "" };
    let places = usize::try_from(places).unwrap_or(0);
    let digits = format!("{:0>1$}", scaled.magnitude().to_string(), places + 1);
    let (whole, fraction) = digits.split_at(digits.len() - places);
    format!("{sign}{whole}.{fraction}")
}

/// The sign of a comparison.
#[must_use]
pub const fn sign(rel: Rel) -> &'static str {
    match rel {
        Rel::Eq => "==",
        Rel::Ne => "!=",
        Rel::Lt => "<",
        Rel::Le => "<=",
        Rel::Gt => ">",
        Rel::Ge => ">=",
    }
}

/// How conditions are said.
pub(crate) struct Words {
    pub(crate) all: &'static str,
    pub(crate) any: &'static str,
    pub(crate) not: &'static str,
    pub(crate) yes: &'static str,
    pub(crate) no: &'static str,
}

/// In text for people.
const PLAIN: Words = Words { all: " and ", any: " or ", not: "not ", yes: "true", no: "false" };

/// A condition, with comparisons in a notation of choice.
pub(crate) fn condition(
    test: &Test,
    words: &Words,
    compare: &impl Fn(Rel, usize, usize) -> String,
) -> String {
    let joined = |tests: &[Test], word: &str, none: &str| match tests {
        [] => none.to_owned(),
        [test] => condition(test, words, compare),
        tests => {
            let part = |test: &Test| format!("({})", condition(test, words, compare));
            tests.iter().map(part).collect::<Vec<_>>().join(word)
        }
    };
    match test {
        Test::Compare(rel, a, b) => compare(*rel, *a, *b),
        Test::All(tests) => joined(tests, words.all, words.yes),
        Test::Any(tests) => joined(tests, words.any, words.no),
        Test::Not(test) => format!("{}({})", words.not, condition(test, words, compare)),
    }
}
