//! Lines between statements, in print: the symbols that they declare, with their ranges and units, and the author's
//! comments.

use kane_algebra::syntax::latex_name;
use maud::{Markup, html};
use pulldown_latex::config::DisplayMode;

use super::math::math;

/// What the lines declare; nothing where no line declares and none is a comment.
pub(super) fn declarations(between: &str) -> Option<Markup> {
    let said = |line: &&str| line.starts_with("var ") || line.starts_with('#');
    let lines: Vec<&str> = between.lines().map(str::trim).filter(said).collect();
    (!lines.is_empty()).then(|| {
        html! { div.vars data-v="ground" { @for line in &lines { p { (in_print(line)) } } } }
    })
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
        _ if is_name(word) => latex_name(word),
        _ => match word.strip_suffix(')').and_then(|word| word.split_once('(')) {
            Some((name, of)) if is_name(name) && is_name(of) => {
                format!("{}({})", latex_name(name), latex_name(of))
            }
            Some(_) => return None,
            None => {
                let number = word.strip_prefix('-').unwrap_or(word);
                let digits = |c: char| c.is_ascii_digit() || matches!(c, '.' | '/');
                (!number.is_empty() && number.chars().all(digits)).then(|| word.to_owned())?
            }
        },
    })
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
        assert_eq!(of("theta <= -pi/2"), None, "what is not known is not guessed");
    }

    #[test]
    fn a_line_that_is_not_known_stands_as_it_was_written() {
        let shown =
            declarations("\nvar x <= 2*y\n# of <b>both</b>\nlet z := 1\n").expect("two lines");
        let shown = shown.into_string();
        assert!(shown.contains("<code>var x &lt;= 2*y</code>"), "{shown}");
        assert!(shown.contains("of &lt;b&gt;both&lt;/b&gt;</span>"), "{shown}");
        assert!(!shown.contains("let"), "{shown}");
    }
}
