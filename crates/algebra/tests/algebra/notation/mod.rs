//! The notation of derivations: what is parsed, printed and evaluated, and what is refused.

use kane_algebra::syntax::Scope;
use kane_kernel::Var;
use num_rational::BigRational;

/// exact values and derivatives at points
mod angles;
mod evaluation;
/// deep and long input within the limits and beyond them
mod limits;
/// text to syntax, and the faults with their places
mod parsing;
/// syntax to text and back, and to LaTeX
mod printing;
/// powers with an index for exponent, and sequences
mod sequences;
/// formulas as they are set, where another way would be read as something else
mod setting;

/// x, y, mu, alpha, k(alpha); and f := x^2 + 1.
fn scope() -> Scope {
    let mut scope = Scope::default();
    let mut declare = |name: &str, of| {
        scope
            .declare(Var { name: name.to_owned(), of, lower: None, upper: None })
            .expect("the names are free")
    };
    declare("x", None);
    declare("y", None);
    declare("mu", None);
    let alpha = declare("alpha", None);
    declare("k", Some(alpha));
    let body = kane_algebra::syntax::parse_expr("x^2 + 1", &scope).expect("well-formed");
    scope.define("f", body).expect("the name is free");
    scope
}

fn ratio(n: i64, d: i64) -> BigRational {
    BigRational::new(n.into(), d.into())
}
