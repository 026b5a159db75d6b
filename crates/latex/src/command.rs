//! The commands that a factor may begin with.

use crate::name::letter;

/// What a command is the beginning of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Beginning<'a> {
    /// a letter, by its name in the language
    Letter(&'a str),
    /// π
    Pi,
    /// a quotient, or a derivative
    Fraction,
    /// a square root
    Root,
    /// sin, cos or tan
    Angle(&'static str),
    /// two of these: the one over the other, 1 for none
    Quotient(Option<&'static str>, &'static str),
    /// exp or log
    Exponential(&'static str),
    /// a sum or a product over a range
    Summation(&'static str),
    /// min or max
    Extreme(&'static str),
    /// so many derivatives by t
    Rate(usize),
    /// a mark that is part of a name
    Mark(&'static str),
    /// a vector or a matrix
    Vector,
    /// a brace that is printed
    Brace,
    /// a bar; whether it can only open
    Bar(bool),
}

/// What a command is the beginning of, if of anything.
pub(crate) fn beginning(command: &str) -> Option<Beginning<'_>> {
    use Beginning::{
        Angle, Bar, Brace, Exponential, Extreme, Fraction, Letter, Mark, Pi, Quotient, Rate, Root,
        Summation, Vector,
    };
    Some(match command {
        "pi" => Pi,
        "frac" | "dfrac" | "tfrac" | "cfrac" => Fraction,
        "sqrt" => Root,
        "sin" => Angle("sin"),
        "cos" => Angle("cos"),
        "tan" => Angle("tan"),
        "sec" => Quotient(None, "cos"),
        "csc" => Quotient(None, "sin"),
        // and not 1/tan, which is undefined where the cosine is 0
        "cot" => Quotient(Some("cos"), "sin"),
        "exp" => Exponential("exp"),
        "ln" | "log" => Exponential("log"),
        "sum" => Summation("sum"),
        "prod" => Summation("prod"),
        "min" => Extreme("min"),
        "max" => Extreme("max"),
        "dot" => Rate(1),
        "ddot" => Rate(2),
        "dddot" => Rate(3),
        "hat" | "widehat" => Mark("hat"),
        "bar" | "overline" => Mark("bar"),
        "tilde" | "widetilde" => Mark("tilde"),
        "check" => Mark("check"),
        "mathcal" => Mark("cal"),
        "mathbf" | "boldsymbol" | "vec" | "bm" => Vector,
        "{" | "lbrace" => Brace,
        "lvert" => Bar(true),
        "vert" => Bar(false),
        other => Letter(letter(other)?),
    })
}
