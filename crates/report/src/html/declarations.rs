//! Lines between statements, in print: the symbols that they declare, with their ranges and units, and the author's
//! comments.

use std::ops::Range;

use kane_algebra::syntax::latex_name;
use maud::{Markup, html};
use pulldown_latex::config::DisplayMode;

use super::math::math;

/// What the lines declare; nothing where no line declares and none is a comment.
pub(super) fn declarations(between: &str) -> Option<Markup> {
    let mut lines: Vec<String> = Vec::new();
    let mut is_open = false;
    for line in between.lines() {
        let said = line.trim();
        let goes_on = is_open && line.starts_with(char::is_whitespace) && !said.is_empty();
        // a line that is indented goes on with the one above
        if let Some(above) = lines.last_mut().filter(|_| goes_on) {
            above.push(' ');
            above.push_str(said);
        } else {
            let declares = said.starts_with("var ");
            if declares || said.starts_with('#') {
                lines.push(said.to_owned());
            }
            is_open = declares;
        }
        is_open &= !said.contains('#');
    }
    (!lines.is_empty()).then(|| {
        html! { div.vars data-v="ground" { @for line in &lines { p { (in_print(line)) } } } }
    })
}

/// The lines of the `var` in which a place of a text is, if it is in one.
pub(super) fn declaration_around(text: &str, at: usize) -> Option<Range<usize>> {
    let line_of = |at: usize| text[..at].rfind('\n').map_or(0, |end| end + 1);
    let mut start = line_of(at);
    while text[start..].starts_with([' ', '\t']) && start > 0 {
        start = line_of(start - 1);
    }
    let goes_on = |end: usize| text[end..].starts_with("\n ") || text[end..].starts_with("\n\t");
    let end_of = |from: usize| text[from..].find('\n').map_or(text.len(), |end| from + end);
    let mut end = end_of(at);
    while goes_on(end) {
        end = end_of(end + 1);
    }
    text[start..].starts_with("var ").then_some(start..end)
}

fn in_print(line: &str) -> Markup {
    let (said, comment) = line.split_once('#').map_or((line, None), |(a, b)| (a, Some(b.trim())));
    let symbols = said.trim().strip_prefix("var ");
    let symbols = symbols.map(|all| all.split(',').map(Symbol::of).collect::<Option<Vec<_>>>());
    html! {
        @match symbols {
            None => {}
            Some(Some(symbols)) => @for (place, symbol) in symbols.iter().enumerate() {
                @if place > 0 { ", " }
                (math(&symbol.latex, DisplayMode::Inline))
                @if let Some(unit) = &symbol.unit { " " (unit) }
            },
            // what is not known stands as it was written
            Some(None) => code { (said.trim()) },
        }
        @if let Some(comment) = comment { span.remark { @if !said.trim().is_empty() { " · " } (comment) } }
    }
}

/// A symbol as it is declared: `0 <= e <= 1 [1]`, `v(t) in R^2 [m/s]`.
#[derive(Debug, PartialEq)]
struct Symbol {
    latex: String,
    /// without that of a number, which is none
    unit: Option<String>,
}

impl Symbol {
    fn of(text: &str) -> Option<Self> {
        let (text, unit) = match text.split_once('[') {
            Some((text, unit)) => (text, Some(unit.trim().strip_suffix(']')?)),
            None => (text, None),
        };
        let (element, set) = match text.split_once(" in ") {
            Some((element, set)) => (element, Some(set.trim())),
            None => (text, None),
        };
        let mut latex: Vec<String> = element.split_whitespace().map(word).collect::<Option<_>>()?;
        if let Some(set) = set {
            latex.push(format!("\\in {}", self::set(set)?));
        }
        let unit = unit.filter(|unit| *unit != "1").map(|unit| {
            let raised = unit.replace("^2", "²").replace("^3", "³");
            raised.replace('*', "·")
        });
        Some(Self { latex: latex.join(" "), unit })
    }
}

/// The set in which a symbol is: `N`, `R^2`, `R^2x2`.
fn set(text: &str) -> Option<String> {
    let known = |c: char| c.is_ascii_digit() || c == 'x';
    match text.split_once('^') {
        None if text == "N" => Some("\\mathbb{N}".to_owned()),
        Some(("R", size)) if size.chars().all(known) => {
            let size = size.replace('x', "\\times ");
            Some(format!("\\mathbb{{R}}^{{{size}}}"))
        }
        _ => None,
    }
}

/// A word of a declaration in LaTeX: a sign, a number, a name, a name of a name.
fn word(word: &str) -> Option<String> {
    let is_name = |name: &str| {
        name.starts_with(|c: char| c.is_alphabetic())
            && name.chars().all(|c| c.is_alphanumeric() || matches!(c, '_' | '\''))
    };
    Some(match word {
        "<" | ">" => word.to_owned(),
        "<=" => "\\le".to_owned(),
        ">=" => "\\ge".to_owned(),
        "!=" => "\\ne".to_owned(),
        "+" | "-" => word.to_owned(),
        _ if is_name(word) => latex_name(word),
        _ => match word.strip_suffix(')').and_then(|word| word.split_once('(')) {
            Some((name, of)) if is_name(name) && is_name(of) => {
                format!("{}({})", latex_name(name), latex_name(of))
            }
            Some(_) => return None,
            None => product(word, is_name)?,
        },
    })
}

/// A product or a quotient of numbers and names, as `-pi/2` and `2*a/3`.
fn product(text: &str, is_name: impl Fn(&str) -> bool) -> Option<String> {
    let (sign, rest) = text.strip_prefix('-').map_or(("", text), |rest| ("-", rest));
    let factor = |factor: &str| {
        let is_digit = |c: char| c.is_ascii_digit() || c == '.';
        match factor {
            _ if is_name(factor) => Some(latex_name(factor)),
            _ if !factor.is_empty() && factor.chars().all(is_digit) => Some(factor.to_owned()),
            _ => None,
        }
    };
    let quotient = |part: &str| -> Option<String> {
        Some(part.split('/').map(factor).collect::<Option<Vec<_>>>()?.join("/"))
    };
    let parts = rest.split('*').map(quotient).collect::<Option<Vec<_>>>()?;
    Some(format!("{sign}{}", parts.join(" \\, ")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_symbol_has_its_range_in_print_and_its_unit_upright() {
        let of = |text: &str| Symbol::of(text).map(|symbol| (symbol.latex, symbol.unit));
        let unit = |text: &str| Some(text.to_owned());
        assert_eq!(of(" J_c > 0 [kg*m^2]"), Some(("J_c > 0".to_owned(), unit("kg·m²"))));
        assert_eq!(of("0 <= e <= 1 [1]"), Some(("0 \\le e \\le 1".to_owned(), None)));
        let vector = "v(t) \\in \\mathbb{R}^{2}".to_owned();
        assert_eq!(of("v(t) in R^2 [m/s]"), Some((vector, unit("m/s"))));
        assert_eq!(of("N > 0"), Some(("N > 0".to_owned(), None)), "a symbol and not a set");
        assert_eq!(of("n in N"), Some(("n \\in \\mathbb{N}".to_owned(), None)));
        assert_eq!(of("theta <= -pi/2"), Some(("\\theta \\le -\\pi/2".to_owned(), None)));
        assert_eq!(of("y <= 2*b + 1"), Some(("y \\le 2 \\, b + 1".to_owned(), None)));
        assert_eq!(of("y <= (b + 1)*2"), None, "what is not known is not guessed");
    }

    #[test]
    fn a_line_that_is_not_known_stands_as_it_was_written() {
        let shown =
            declarations("\nvar x <= 2*(y)\n# of <b>both</b>\nlet z := 1\n").expect("two lines");
        let shown = shown.into_string();
        assert!(shown.contains("<code>var x &lt;= 2*(y)</code>"), "{shown}");
        assert!(shown.contains("of &lt;b&gt;both&lt;/b&gt;</span>"), "{shown}");
        assert!(!shown.contains("let"), "{shown}");
    }

    #[test]
    fn a_declaration_is_found_from_any_of_its_lines() {
        let text = "claim a: x = x\nvar b > 0,\n    0 < c < b\n  # of c\nlet d := b\n";
        let whole = "var b > 0,\n    0 < c < b\n  # of c";
        for inside in ["var", "b > 0", "c < b", "of c"] {
            let at = text.find(inside).expect("it is there");
            let found = declaration_around(text, at).expect("a declaration");
            assert_eq!(&text[found], whole, "{inside}");
        }
        for outside in ["a: x", "let d"] {
            assert_eq!(declaration_around(text, text.find(outside).expect("it is there")), None);
        }
        let shown = declarations(whole).expect("a line").into_string();
        assert!(shown.contains("of c</span>") && !shown.contains("<code>"), "{shown}");
    }
}
