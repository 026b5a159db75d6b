//! MathML: what stands inside of a `math` element.
//!
//! Pages of proofs have thousands of formulas, so elements are only where they change what is seen: a
//! subscript is one identifier, a product has no sign where none is needed.

use kane_kernel::{Context, Expr, Rel, Relation};
use num_rational::BigRational;
use num_traits::Signed as _;

use super::latex::{is_function, is_loose, last_factor};
use super::letters::greek_letter;
use super::lexer::{self, Token};
use super::logic::Logic;
use super::names::{
    applied, canonical_name, exponent, greek_subscript, name_parts, of_argument, power, rates,
    summed,
};
use super::number::decimal;
use super::parser::Level;
use super::plain::{let_name, var_name};

/// An expression; further symbols, which the context does not name, are set as `beyond` says.
#[must_use]
pub fn mathml(expr: &Expr, context: &Context, beyond: &dyn Fn(usize) -> Option<String>) -> String {
    Writer { context, beyond }.expr(expr, Level::Sum)
}

/// A name: a letter with its subscript and primes, or a word.
#[must_use]
pub fn mathml_name(name: &str) -> String {
    if let Some((function, time, order)) = rates(name) {
        let (function, time) = (mathml_name(function), mathml_name(time));
        let power = |what: &str| match order {
            1 => what.to_owned(),
            n => format!("<msup>{what}<mn>{n}</mn></msup>"),
        };
        let (d, by) = (power("<mi>d</mi>"), power(&time));
        return format!("<mfrac><mrow>{d}{function}</mrow><mrow><mi>d</mi>{by}</mrow></mfrac>");
    }
    if let Some((base, index)) = power(name) {
        let base = match base.starts_with(|c: char| c.is_ascii_digit()) {
            true => format!("<mn>{base}</mn>"),
            false => mathml_name(base),
        };
        return in_parentheses(&format!("<msup>{base}{}</msup>", mathml_name(index)));
    }
    if let Some(sum) = summed(name) {
        let sign = if sum.product { "∏" } else { "∑" };
        let from =
            format!("<mrow>{}<mo>=</mo>{}</mrow>", mathml_name(sum.over), mathml_tokens(sum.from));
        let (to, term) = (mathml_tokens(sum.to), mathml_tokens(sum.term));
        let sign = format!("<munderover><mo>{sign}</mo>{from}<mrow>{to}</mrow></munderover>");
        return in_parentheses(&format!("{sign}{term}"));
    }
    if let Some((function, argument)) = applied(name) {
        if !["cos", "sin", "exp", "log"].contains(&function) {
            let (function, argument) = (mathml_name(function), mathml_name(argument));
            return format!("<mrow>{function}<mo>(</mo>{argument}<mo>)</mo></mrow>");
        }
        let argument =
            of_argument(argument, ["", "<mo>/</mo>"], |factor| match factor.split_once('^') {
                Some((name, n)) => format!("<msup>{}<mn>{n}</mn></msup>", mathml_name(name)),
                None if factor.starts_with(|c: char| c.is_ascii_digit()) => {
                    format!("<mn>{factor}</mn>")
                }
                None => mathml_name(factor),
            });
        return format!("<mrow><mi>{function}</mi><mo>(</mo>{argument}<mo>)</mo></mrow>");
    }
    let canonical = canonical_name(name);
    let (base, sub) = name_parts(&canonical);
    let primes = "′".repeat(canonical.matches('\'').count());
    let letters = |part: &String| greek_letter(part).map_or_else(|| part.clone(), String::from);
    let base = format!("<mi>{}</mi>", base.iter().map(letters).collect::<String>());
    let letters = |part: &String| match greek_subscript(part) {
        Some((letter, rest)) => format!("{letter}{rest}"),
        None => part.clone(),
    };
    let sub = sub.iter().map(letters).collect::<Vec<_>>().join(",");
    let sub = match sub.bytes().all(|byte| byte.is_ascii_digit()) {
        true => format!("<mn>{sub}</mn>"),
        false => format!("<mi>{sub}</mi>"),
    };
    match (sub == "<mn></mn>", primes.is_empty()) {
        (true, true) => base,
        (true, false) => format!("<msup>{base}<mo>{primes}</mo></msup>"),
        (false, true) => format!("<msub>{base}{sub}</msub>"),
        (false, false) => format!("<msubsup>{base}{sub}<mo>{primes}</mo></msubsup>"),
    }
}

fn number(value: &BigRational) -> String {
    let sign = if value.is_negative() { "<mo>−</mo>" } else { "" };
    match decimal(value) {
        Some(digits) => format!("{sign}<mn>{digits}</mn>"),
        None => {
            let (numer, denom) = (value.numer().magnitude(), value.denom());
            format!("{sign}<mfrac><mn>{numer}</mn><mn>{denom}</mn></mfrac>")
        }
    }
}

/// The text of an expression, sign by sign.
fn mathml_tokens(text: &str) -> String {
    let (mut parts, mut at): (Vec<String>, usize) = (Vec::new(), 0);
    loop {
        let (token, span) = lexer::next(text, at);
        at = span.end;
        let lexeme = text.get(span).unwrap_or_default();
        let part = match token {
            Token::End => return parts.concat(),
            Token::Name => mathml_name(lexeme),
            Token::Number => format!("<mn>{lexeme}</mn>"),
            Token::Star => "<mo>&#x2062;</mo>".to_owned(),
            Token::Minus => "<mo>−</mo>".to_owned(),
            Token::Caret => {
                let (end, exponent) = exponent(text, at);
                at = end;
                let base = parts.pop().unwrap_or_default();
                format!("<msup>{base}<mrow>{}</mrow></msup>", mathml_tokens(exponent))
            }
            _ => format!("<mo>{}</mo>", lexeme.replace('<', "&lt;").replace('>', "&gt;")),
        };
        parts.push(part);
    }
}

/// What takes one place in an element with several.
fn row(inside: &str) -> String {
    format!("<mrow>{inside}</mrow>")
}

fn in_parentheses(inside: &str) -> String {
    format!("<mrow><mo>(</mo>{inside}<mo>)</mo></mrow>")
}

fn comparison(rel: Rel) -> &'static str {
    match rel {
        Rel::Eq => "<mo>=</mo>",
        Rel::Ne => "<mo>≠</mo>",
        Rel::Lt => "<mo>&lt;</mo>",
        Rel::Le => "<mo>≤</mo>",
        Rel::Gt => "<mo>&gt;</mo>",
        Rel::Ge => "<mo>≥</mo>",
    }
}

struct Writer<'a> {
    context: &'a Context,
    beyond: &'a dyn Fn(usize) -> Option<String>,
}

impl Writer<'_> {
    /// `e` where an operand of at least `least` is due.
    fn expr(&self, e: &Expr, least: Level) -> String {
        let bare = self.bare(e);
        if is_loose(e, least) { in_parentheses(&bare) } else { bare }
    }

    fn free(&self, e: &Expr) -> String {
        self.expr(e, Level::Sum)
    }

    fn bare(&self, e: &Expr) -> String {
        let free = |e: &Expr| self.free(e);
        let row = |e: &Expr| if is_one_element(e) { free(e) } else { row(&free(e)) };
        match e {
            Expr::Num(value) => number(value),
            Expr::Var(v) => {
                (self.beyond)(*v).unwrap_or_else(|| mathml_name(var_name(*v, self.context)))
            }
            Expr::Let(i) => mathml_name(let_name(*i, self.context)),
            Expr::Neg(a) => format!("<mo>−</mo>{}", self.operand(a, Level::Product)),
            Expr::Add(a, b) => self.pair(a, "<mo>+</mo>", b),
            Expr::Sub(a, b) => self.pair(a, "<mo>−</mo>", b),
            Expr::Mul(a, b) => self.product(a, b),
            Expr::Div(a, b) => format!("<mfrac>{}{}</mfrac>", row(a), row(b)),
            Expr::Pow(a, n) => {
                let base = self.operand(a, Level::Atom);
                let sign = if *n < 0 { "<mo>−</mo>" } else { "" };
                let n = format!("{sign}<mn>{}</mn>", n.unsigned_abs());
                let n = if sign.is_empty() { n } else { self::row(&n) };
                let is_difference = is_difference(a, &base);
                // the power of a letter stands above its subscript
                let is_letter = is_one_element(a) && !is_difference;
                let with_subscript = base.strip_prefix("<msub>").filter(|_| is_letter);
                if let Some(letter) = with_subscript.and_then(|l| l.strip_suffix("</msub>")) {
                    return format!("<msubsup>{letter}{n}</msubsup>");
                }
                // behind arguments an exponent would seem to belong to them alone
                let base = match **a {
                    Expr::Min(..) | Expr::Max(..) => in_parentheses(&base),
                    // to the top of a fraction, or to what stands behind a Δ or d
                    _ if is_difference || base.starts_with("<mfrac>") => in_parentheses(&base),
                    _ => base,
                };
                let is_whole = is_one_element(a) || base.starts_with("<mrow>");
                let base = if is_whole { base } else { self::row(&base) };
                format!("<msup>{base}{n}</msup>")
            }
            Expr::Abs(a) => format!("<mrow><mo>|</mo>{}<mo>|</mo></mrow>", free(a)),
            Expr::Sqrt(a) => format!("<msqrt>{}</msqrt>", free(a)),
            Expr::Min(a, b) | Expr::Max(a, b) => {
                let name = if matches!(e, Expr::Min(..)) { "min" } else { "max" };
                let both = format!("{}<mo>,</mo>{}", free(a), free(b));
                format!("<mi>{name}</mi>{}", in_parentheses(&both))
            }
            Expr::Deriv(f, x) => {
                let x = mathml_name(var_name(*x, self.context));
                let f = in_parentheses(&free(f));
                format!("<mfrac><mi>d</mi><mrow><mi>d</mi>{x}</mrow></mfrac>{f}")
            }
            Expr::Cases(branches, otherwise) => self.cases(branches, otherwise.as_deref()),
        }
    }

    fn pair(&self, a: &Expr, operator: &str, b: &Expr) -> String {
        format!("{}{operator}{}", self.operand(a, Level::Sum), self.operand(b, Level::Product))
    }

    /// A part of a larger expression. What follows `cases` would seem to belong to its last row.
    fn operand(&self, e: &Expr, least: Level) -> String {
        match e {
            Expr::Cases(..) => in_parentheses(&self.bare(e)),
            _ => self.expr(e, least),
        }
    }

    fn product(&self, a: &Expr, b: &Expr) -> String {
        let (left, right) = (self.operand(a, Level::Product), self.operand(b, Level::Power));
        let last = last_factor(a);
        let dot = match last {
            Expr::Deriv(..) => true,
            // a function before parentheses would seem to be applied
            Expr::Var(v) if is_function(*v, self.context) => right.starts_with("<mrow><mo>("),
            // numbers side by side would read as one, words as a word, the product Δ·E as a difference of E
            _ => {
                right.starts_with("<mn>")
                    || (right.starts_with("<mfrac") && left.ends_with("</mn>"))
                    || is_word(last, self.context)
                    || is_word(b, self.context)
                    || left.ends_with("<mi>Δ</mi>")
            }
        };
        format!("{left}{}{right}", if dot { "<mo>·</mo>" } else { "" })
    }

    fn relation(&self, r: &Relation) -> String {
        let part = |relations: &[Relation]| {
            let parts: Vec<String> = relations
                .iter()
                .map(|r| match Logic::of(r) {
                    Some(_) => in_parentheses(&self.relation(r)),
                    None => self.relation(r),
                })
                .collect();
            parts.join("<mo>∧</mo>")
        };
        match Logic::of(r) {
            Some(logic) => logic.written(part, ["<mo>∨</mo>", "<mo>⇒</mo>", "<mo>⇔</mo>"]),
            None => format!("{}{}{}", self.free(&r.lhs), comparison(r.rel), self.free(&r.rhs)),
        }
    }

    fn cases(&self, branches: &[(Vec<Relation>, Expr)], otherwise: Option<&Expr>) -> String {
        let line = |value: &Expr, when: String| {
            format!("<mtr><mtd>{}</mtd><mtd>{when}</mtd></mtr>", self.free(value))
        };
        let mut rows = String::new();
        for (guards, value) in branches {
            let guards: Vec<String> = guards.iter().map(|r| self.relation(r)).collect();
            let when = format!("<mtext>if </mtext>{}", guards.join("<mo>,</mo>"));
            rows.push_str(&line(value, when));
        }
        if let Some(value) = otherwise {
            rows.push_str(&line(value, "<mtext>otherwise</mtext>".to_owned()));
        }
        format!("<mrow><mo>{{</mo><mtable>{rows}</mtable></mrow>")
    }
}

/// Whether an expression is set as one element: a name or a number without a sign.
fn is_one_element(e: &Expr) -> bool {
    match e {
        Expr::Var(_) | Expr::Let(_) | Expr::Sqrt(_) => true,
        Expr::Num(value) => !value.is_negative(),
        _ => false,
    }
}

/// Whether a symbol is set as a difference, ΔE or dE: an exponent would seem to belong to its last letter.
fn is_difference(e: &Expr, set: &str) -> bool {
    let letters = set.split_once("<mi>").map_or("", |(_, letters)| letters);
    let of_capital = |rest: &str| rest.starts_with(|c: char| c.is_ascii_uppercase());
    matches!(e, Expr::Var(_) | Expr::Let(_))
        && (letters.strip_prefix('Δ').is_some_and(|rest| !rest.starts_with('<'))
            || letters.strip_prefix('d').is_some_and(of_capital))
}

/// Whether a symbol is set as a word of several letters.
fn is_word(e: &Expr, context: &Context) -> bool {
    let name = match e {
        Expr::Var(v) => var_name(*v, context),
        Expr::Let(i) => let_name(*i, context),
        _ => return false,
    };
    let name = canonical_name(name);
    let (base, _) = name_parts(&name);
    base.iter().any(|part| part.len() > 1 && greek_letter(part).is_none())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::syntax::{Scope, parse_expr};
    use kane_kernel::Var;

    fn set(text: &str) -> String {
        let mut scope = Scope::default();
        for name in ["x", "slip", "v_x0'", "mu"] {
            let var = Var { name: name.to_owned(), of: None, lower: None, upper: None };
            scope.declare(var).expect("a name");
        }
        let expr = parse_expr(text, &scope).expect("an expression");
        mathml(&expr, scope.context(), &|_| None)
    }

    #[test]
    fn names_have_their_letters_and_subscripts() {
        for (written, shown) in [
            ("v_px0", "<msub><mi>v</mi><mi>px0</mi></msub>"),
            ("w0", "<msub><mi>w</mi><mn>0</mn></msub>"),
            ("mu'", "<msup><mi>μ</mi><mo>′</mo></msup>"),
            ("v'_x", "<msubsup><mi>v</mi><mi>x</mi><mo>′</mo></msubsup>"),
            ("k_alpha", "<msub><mi>k</mi><mi>α</mi></msub>"),
            ("DeltaE", "<mi>ΔE</mi>"),
            ("slip", "<mi>slip</mi>"),
            ("m", "<mi>m</mi>"),
        ] {
            assert_eq!(mathml_name(written), shown, "{written}");
        }
    }

    #[test]
    fn products_powers_and_quotients_hold_together() {
        assert_eq!(set("2*x"), "<mn>2</mn><mi>x</mi>");
        assert_eq!(set("slip*x"), "<mi>slip</mi><mo>·</mo><mi>x</mi>");
        assert_eq!(
            set("-(x + 1)^2/mu"),
            "<mo>−</mo><mfrac><mrow><msup><mrow><mo>(</mo><mi>x</mi><mo>+</mo><mn>1</mn>\
             <mo>)</mo></mrow><mn>2</mn></msup></mrow><mi>μ</mi></mfrac>"
        );
        let set_power = set("v_x0'^2*slip^3");
        assert!(set_power.starts_with("<msup><msubsup>"), "{set_power}");
        assert!(set_power.ends_with("<msup><mi>slip</mi><mn>3</mn></msup>"), "{set_power}");
        assert!(set("cases { x > 0: 1; else: 0 }").contains("<mo>&gt;</mo>"));
    }
}
