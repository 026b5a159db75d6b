//! Derivatives in SMT-LIB are those of school, where the language says that there is one (rule 6). What is wanted is
//! differentiated here by hand.

use kane_judges::smt::{NotPut, question};
use kane_kernel::Finding;
use num_traits::{Signed, Zero};

use crate::document::{Q, assert_asks, assert_asks_nothing, found, goal, points, q, text, whole};

/// A slope at x and y, where there is one.
type Slope = fn(&Q, &Q) -> Option<Q>;

/// A root of a square among the values that are tried, −1 for others.
fn root(square: &Q) -> Q {
    [0, 1, 2, 3, 4].map(|n| q(n, 2)).into_iter().find(|r| r * r == *square).unwrap_or(whole(-1))
}

fn some(condition: bool, value: Q) -> Option<Q> {
    condition.then_some(value)
}

/// What is asked of a slope: it differs from a number s, or there is none.
fn assert_slope(term: &str, slope: Slope) {
    for (finding, differs) in
        [(Finding::Proved, true), (Finding::Refuted, true), (Finding::IllDefined, false)]
    {
        let statements = format!("var x, y, s\nclaim c: {term} = s + 0*(x + y)");
        let asked = text(&statements, finding).expect("it can be put");
        let wanted = |p: &[Q]| match slope(&p[0], &p[1]) {
            Some(value) => differs && value != p[2],
            None => finding != Finding::Refuted,
        };
        let nowhere = finding == Finding::IllDefined
            && points(2).iter().all(|p| slope(&p[0], &p[1]).is_some());
        if nowhere {
            assert_asks_nothing(&asked, &["x", "y", "s"]);
            continue;
        }
        assert_asks(&asked, &["x", "y", "s"], |_| Vec::new(), wanted);
    }
}

#[test]
fn sums_products_quotients_and_powers_by_the_rules_of_school() {
    let table: [(&str, Slope); 18] = [
        ("d(3, x)", |_, _| Some(whole(0))),
        ("d(y, x)", |_, _| Some(whole(0))),
        ("d(x, x)", |_, _| Some(whole(1))),
        ("d(-x, x)", |_, _| Some(whole(-1))),
        ("d(x + y, x)", |_, _| Some(whole(1))),
        ("d(y - 2*x, x)", |_, _| Some(whole(-2))),
        ("d(x*y, x)", |_, y| Some(y.clone())),
        ("d((x + 1)*(x - y), x)", |x, y| Some(whole(2) * x + whole(1) - y)),
        ("d(x/y, x)", |_, y| some(!y.is_zero(), if y.is_zero() { whole(0) } else { whole(1) / y })),
        ("d(y/x, x)", |x, y| (!x.is_zero()).then(|| -y / (x * x))),
        ("d((x + y)/(x - y), x)", |x, y| (x != y).then(|| whole(-2) * y / ((x - y) * (x - y)))),
        ("d(x^0, x)", |_, _| Some(whole(0))),
        ("d(x^1, x)", |_, _| Some(whole(1))),
        ("d(x^3, x)", |x, _| Some(whole(3) * x * x)),
        ("d((x*y)^2, x)", |x, y| Some(whole(2) * x * y * y)),
        ("d(x^-2, x)", |x, _| (!x.is_zero()).then(|| whole(-2) / (x * x * x))),
        ("d(y^-1*x, x)", |_, y| (!y.is_zero()).then(|| whole(1) / y)),
        ("d((1/x)^0, x)", |x, _| some(!x.is_zero(), whole(0))),
    ];
    for (term, slope) in table {
        assert_slope(term, slope);
    }
}

#[test]
fn roots_have_a_slope_where_the_radicand_is_positive_or_does_not_vary() {
    // 1/2 is no square of a fraction: there is no number to be given for its root, and nothing is asked
    let asked = |term: &str, finding| {
        text(&format!("var x, y, s\nclaim c: {term} = s"), finding).expect("it can be put")
    };
    let roots = |p: &[Q]| vec![root(&p[0])];
    assert_asks(&asked("d(sqrt(x), x) + 0*y", Finding::Refuted), &["x", "y", "s"], roots, |p| {
        let r = root(&p[0]);
        r.is_positive() && whole(1) / (whole(2) * r) != p[2]
    });
    assert_asks(&asked("d(sqrt(x), x) + 0*y", Finding::IllDefined), &["x", "y", "s"], roots, |p| {
        !p[0].is_positive()
    });
    let roots = |p: &[Q]| vec![root(&p[1])];
    assert_asks(&asked("d(sqrt(y)*x, x)", Finding::Refuted), &["x", "y", "s"], roots, |p| {
        !root(&p[1]).is_negative() && root(&p[1]) != p[2]
    });
    assert_asks(&asked("d(sqrt(y)*x, x)", Finding::IllDefined), &["x", "y", "s"], roots, |p| {
        p[1].is_negative()
    });
    // a radicand that does not vary may be 0, whatever is added to it and multiplied with it
    let term = "d(x + sqrt(-3*y + 0 + 2*(2*y - y/2)), x)";
    let roots = |p: &[Q]| vec![whole(0); p.len().min(1)];
    assert_asks(&asked(term, Finding::Proved), &["x", "y", "s"], roots, |p| p[2] != whole(1));
}

#[test]
fn choices_have_the_slope_of_their_branch_and_none_where_they_change() {
    let table: [(&str, Slope); 11] = [
        ("d(abs(x), x)", |x, _| some(!x.is_zero(), x.signum())),
        ("d(abs(y)*x, x)", |_, y| Some(y.abs())),
        ("d(min(x, y), x)", |x, y| some(x != y, whole(i64::from(x < y)))),
        ("d(max(3*x, y), x)", |x, y| {
            some(whole(3) * x != *y, if whole(3) * x > *y { whole(3) } else { whole(0) })
        }),
        // the branches meet, and still there is none
        ("d(cases { x < 1: x^2; else: 2*x - 1 }, x)", |x, _| {
            some(*x != whole(1), if *x < whole(1) { whole(2) * x } else { whole(2) })
        }),
        // a guard that does not vary
        ("d(cases { y < 1: x; else: x^2 }, x)", |x, y| {
            Some(if *y < whole(1) { whole(1) } else { whole(2) * x })
        }),
        // the second guard is read where the first is false
        ("d(cases { x < 0: x; x < 1: 2*x; else: y*x }, x)", |x, y| {
            let value = if x.is_negative() {
                whole(1)
            } else if *x < whole(1) {
                whole(2)
            } else {
                y.clone()
            };
            some(!x.is_zero() && *x != whole(1), value)
        }),
        // of two guards the second is read where the first is true
        ("d(cases { y > 0, x < 1: x; else: 3*x }, x)", |x, y| {
            let (first, second) = (y.is_positive(), *x < whole(1));
            some(!(first && *x == whole(1)), whole(if first && second { 1 } else { 3 }))
        }),
        ("d(cases { x > 1: 4*x }, x)", |x, _| some(*x > whole(1), whole(4))),
        // a kink in a side of a guard does not matter, but a place where it is undefined does
        ("d(cases { abs(x) < 1/4: x; else: 3*x }, x)", |x, _| {
            let small = x.abs() < q(1, 4);
            some(x.abs() != q(1, 4), whole(if small { 1 } else { 3 }))
        }),
        ("d(cases { 1/x < 1: x; else: 3*x }, x)", |x, _| {
            let first = x.is_negative() || *x > whole(1);
            some(!x.is_zero() && *x != whole(1), whole(if first { 1 } else { 3 }))
        }),
    ];
    for (term, slope) in table {
        assert_slope(term, slope);
    }
}

#[test]
fn derivatives_of_derivatives_need_both_symbols_to_move() {
    let table: [(&str, Slope); 5] = [
        ("d(d(x^4, x), x)", |x, _| Some(whole(12) * x * x)),
        ("d(d(x^2*y^3, x), y)", |x, y| Some(whole(6) * x * y * y)),
        ("d(d(abs(y)*x, x), y)", |_, y| some(!y.is_zero(), y.signum())),
        ("d(x*d(abs(y), y), x)", |_, y| some(!y.is_zero(), y.signum())),
        ("d(d(1/x, x), x)", |x, _| (!x.is_zero()).then(|| whole(2) / (x * x * x))),
    ];
    for (term, slope) in table {
        assert_slope(term, slope);
    }
}

#[test]
fn definitions_are_written_out_before_they_are_differentiated() {
    let lets =
        "var x, y, s\nlet f := x^2/y\nlet g := cases { f < 1: min(x, y); else: -abs(x)*sqrt(y) }\n";
    let asked = text(&format!("{lets}claim c: d(f + 0*x^0, x) = s"), Finding::Refuted);
    assert_asks(
        &asked.expect("put"),
        &["x", "y", "s"],
        |_| Vec::new(),
        |p| !p[1].is_zero() && whole(2) * &p[0] / &p[1] != p[2],
    );
    let asked = text(&format!("{lets}claim c: d(g, x) = s"), Finding::Refuted).expect("put");
    let f = |p: &[Q]| &p[0] * &p[0] / &p[1];
    assert_asks(
        &asked,
        &["x", "y", "s"],
        |p| vec![root(&p[1])],
        |p| {
            let (x, y, s) = (&p[0], &p[1], &p[2]);
            if y.is_zero() || f(p) == whole(1) {
                return false;
            }
            if f(p) < whole(1) {
                return x != y && whole(i64::from(x < y)) != *s;
            }
            let r = root(y);
            !r.is_negative() && !x.is_zero() && -x.signum() * r != *s
        },
    );
}

#[test]
fn a_derivative_of_a_function_is_not_put() {
    // such a derivative is a symbol of its own, which no document has without a formula
    let mut goal = goal("var x, y, z\nclaim c: d(x*z, x) = y");
    goal.context.vars[2].of = Some(0);
    let asked = question(&found(goal, Finding::Proved, None));
    assert_eq!(asked, Err(NotPut::Derivative));
    // nor is one by a symbol that there is not
    let mut goal = self::goal("var x, y\nclaim c: x = d(y^2, y)");
    goal.context.vars.pop();
    let asked = question(&found(goal, Finding::Proved, None));
    assert_eq!(asked, Err(NotPut::Symbol));
}
