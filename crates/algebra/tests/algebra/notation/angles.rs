//! Sines of sums against the floating-point library: two ways to a value that share nothing.

use kane_algebra::syntax::{Scope, parse_expr};
use kane_kernel::{Expr, Var};
use num_traits::ToPrimitive as _;
use proptest::prelude::*;

/// Two angles in twelve parts, each the finest.
fn angles() -> (Scope, [[usize; 2]; 2]) {
    let mut scope = Scope::default();
    let points = ["theta", "phi"].map(|name| {
        let var = Var { name: name.to_owned(), of: None, lower: None, upper: None };
        let (_, angle) = scope.declare_angle(var, 12, false).expect("the names are free");
        [angle.cos, angle.sin]
    });
    (scope, points)
}

fn value(e: &Expr, at: &dyn Fn(usize) -> f64) -> f64 {
    let go = |e: &Expr| value(e, at);
    match e {
        Expr::Num(q) => q.to_f64().expect("small numbers"),
        Expr::Var(v) => at(*v),
        Expr::Neg(a) => -go(a),
        Expr::Add(a, b) => go(a) + go(b),
        Expr::Sub(a, b) => go(a) - go(b),
        Expr::Mul(a, b) => go(a) * go(b),
        Expr::Div(a, b) => go(a) / go(b),
        Expr::Pow(a, n) => go(a).powi(*n),
        Expr::Sqrt(a) => go(a).sqrt(),
        other => unreachable!("{other:?} is in no sine"),
    }
}

proptest! {
    #[test]
    fn sines_of_sums_have_the_values_of_sines(
        [a, b, c] in [-24i64..=24, -24i64..=24, -30i64..=30],
        [theta, phi] in [-4.0f64..4.0, -4.0f64..4.0],
    ) {
        let (scope, points) = angles();
        let part = [theta / 12.0, phi / 12.0];
        let at = |v: usize| {
            let found = points.iter().zip(part).find(|([cos, sin], _)| v == *cos || v == *sin);
            let ([cos, _], part) = found.expect("it is one of the two points");
            if v == *cos { part.cos() } else { part.sin() }
        };
        let sum = format!("{a}*theta/12 + {b}*phi/12 + {c}/12*pi");
        let angle = a as f64 * part[0] + b as f64 * part[1] + c as f64 * std::f64::consts::PI / 12.0;
        for (function, exact) in [("sin", angle.sin()), ("cos", angle.cos())] {
            let e = parse_expr(&format!("{function}({sum})"), &scope).expect("it is an angle");
            // The terms of one multiple add up to (|cos| + |sin|)^24 ≤ 2^12 at most, those of both to 2^24,
            // and each is wrong by less than 2^7 units of 2^-53: 2^-22 in all. A wrong term is seen.
            prop_assert!((value(&e, &at) - exact).abs() < 1e-5, "{function}({sum}): {} and {exact}", value(&e, &at));
        }
    }
}

#[test]
fn what_is_no_angle_is_refused() {
    let (scope, _) = angles();
    for (text, message) in [
        ("sin(1)", "take a sum of angles"),
        ("sin(theta*phi)", "take a sum of angles"),
        ("sin(theta^2)", "take a sum of angles"),
        ("cos(sin(theta))", "take a sum of angles"),
        ("sin(theta/24)", "twelfths at the finest"),
        ("sin(25*theta/12)", "up to 24"),
        ("cos(pi/7)", "multiples of `pi/12`"),
        ("theta + 1", "is an angle, and no number"),
        ("pi + 1", "unknown symbol `pi`"),
    ] {
        let errors = parse_expr(text, &scope).expect_err(text);
        assert!(errors[0].to_string().contains(message), "{text}: {}", errors[0]);
    }
}

#[test]
fn a_name_that_is_declared_is_no_function() {
    let mut scope = Scope::default();
    let var = Var { name: "sin".to_owned(), of: None, lower: None, upper: None };
    let sin = scope.declare(var).expect("the name is free");
    assert_eq!(parse_expr("sin*2", &scope).map(|e| e.children().len()), Ok(2));
    assert_eq!(parse_expr("sin", &scope), Ok(Expr::Var(sin)));
}
