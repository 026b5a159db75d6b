//! Lemmas about functions of a variable say what limits, and claims that rest on limits, say.

use crate::document::judged;
use crate::lemmas::{Said, assert_lemmas, coq};

/// Limits, one side after the other, with what holds of constants before what holds on the set.
pub(crate) const LIMITS: Said = (
    "var x, a, b\n\
     var f(x), g(x) > 0\n\
     given pos: a > 0\n\
     given ahead: x > 0\n\
     given law: f = a + 1/x\n\
     given tends: g -> b as x -> oo\n\
     given mixed: a > 1, x > a\n\
     given late: f = a when x > b\n\
     claim far: f -> a as x -> oo from law, ahead\n\
     claim sum: f + g -> a + b as x -> oo from law, tends, ahead\n\
     claim down: x^2 -> 0 as x -> 0\n\
     claim above: 1/x -> oo as x -> 0+\n\
     claim below: 1/x -> -oo as x -> 0-\n\
     claim left: -x -> oo as x -> -oo\n\
     claim half: x/(1 + x) -> 1/3 as x -> 1/2\n\
     claim cond: f -> a as x -> oo when a > 0 from law, ahead\n\
     claim within: f -> a as x -> oo from law, mixed, pos\n\
     claim lately: f -> a as x -> oo from late",
    &[
        (
            "far",
            "forall (a : R) (f : R -> R) (domain : R -> Prop), (exists bound : R, forall x : R, x \
                 > bound -> domain x) -> (forall x : R, domain x -> (x <> 0 /\\ f x = a + 1 / x)) -> \
                 (forall x : R, domain x -> x > 0) -> forall epsilon : R, epsilon > 0 -> exists bound \
                 : R, forall x : R, x > bound -> Rabs (f x - a) < epsilon",
        ),
        (
            "sum",
            "forall (a b : R) (f g : R -> R) (domain : R -> Prop), (forall epsilon : R, epsilon > \
                 0 -> exists bound : R, forall x : R, x > bound -> Rabs (g x - b) < epsilon) -> \
                 (exists bound : R, forall x : R, x > bound -> domain x) -> (forall x : R, g x > 0) \
                 -> (forall x : R, domain x -> (x <> 0 /\\ f x = a + 1 / x)) -> (forall x : R, domain \
                 x -> x > 0) -> forall epsilon : R, epsilon > 0 -> exists bound : R, forall x : R, x \
                 > bound -> Rabs (f x + g x - (a + b)) < epsilon",
        ),
        (
            "down",
            "(forall epsilon : R, epsilon > 0 -> exists delta : R, delta > 0 /\\ (forall x : R, 0 \
                 < x < 0 + delta -> Rabs (x ^ 2 - 0) < epsilon)) /\\ (forall epsilon : R, epsilon > 0 \
                 -> exists delta : R, delta > 0 /\\ (forall x : R, 0 - delta < x < 0 -> Rabs (x ^ 2 - \
                 0) < epsilon))",
        ),
        (
            "above",
            "forall level : R, exists delta : R, delta > 0 /\\ (forall x : R, 0 < x < 0 + delta \
                 -> (x <> 0 /\\ 1 / x > level))",
        ),
        (
            "below",
            "forall level : R, exists delta : R, delta > 0 /\\ (forall x : R, 0 - delta < x < 0 \
                 -> (x <> 0 /\\ 1 / x < level))",
        ),
        ("left", "forall level : R, exists bound : R, forall x : R, x < bound -> - x > level"),
        (
            "half",
            "(forall epsilon : R, epsilon > 0 -> exists delta : R, delta > 0 /\\ (forall x : R, 1 \
                 / 2 < x < 1 / 2 + delta -> (1 + x <> 0 /\\ Rabs (x / (1 + x) - 1 / 3) < epsilon))) \
                 /\\ (forall epsilon : R, epsilon > 0 -> exists delta : R, delta > 0 /\\ (forall x : \
                 R, 1 / 2 - delta < x < 1 / 2 -> (1 + x <> 0 /\\ Rabs (x / (1 + x) - 1 / 3) < \
                 epsilon)))",
        ),
        (
            "cond",
            "forall (a : R) (f : R -> R) (domain : R -> Prop), a > 0 -> (exists bound : R, forall \
                 x : R, x > bound -> domain x) -> (forall x : R, domain x -> (x <> 0 /\\ f x = a + 1 \
                 / x)) -> (forall x : R, domain x -> x > 0) -> forall epsilon : R, epsilon > 0 -> \
                 exists bound : R, forall x : R, x > bound -> Rabs (f x - a) < epsilon",
        ),
        (
            "within",
            "forall (a : R) (f : R -> R) (domain : R -> Prop), a > 0 -> a > 1 -> (exists bound : \
                 R, forall x : R, x > bound -> domain x) -> (forall x : R, domain x -> (x <> 0 /\\ f \
                 x = a + 1 / x)) -> (forall x : R, domain x -> (a > 1 /\\ x > a)) -> forall epsilon : \
                 R, epsilon > 0 -> exists bound : R, forall x : R, x > bound -> Rabs (f x - a) < \
                 epsilon",
        ),
        (
            "lately",
            "forall (a b : R) (f : R -> R) (domain : R -> Prop), (exists bound : R, forall x : R, \
                 x > bound -> domain x) -> (forall x : R, domain x -> (x > b -> f x = a)) -> forall \
                 epsilon : R, epsilon > 0 -> exists bound : R, forall x : R, x > bound -> Rabs (f x - \
                 a) < epsilon",
        ),
    ],
);

#[test]
fn a_limit_is_said_on_a_set_that_reaches_up_to_it() {
    assert_lemmas(&LIMITS);
}

/// A claim at each point of a set that reaches up to the limits of its premises.
pub(crate) const AT_POINTS: Said = (
    "var x, a, b\n\
     var f(x), g(x) > 0\n\
     given pos: a > 0\n\
     given ahead: x > 0\n\
     given law: f = a + 1/x\n\
     given tends: g -> b as x -> oo\n\
     given mixed: a > 1, x > a\n\
     given late: f = a when x > b\n\
     claim b-pos: b >= 0 from tends",
    &[(
        "b_pos",
        "forall (b : R) (g : R -> R) (domain : R -> Prop), (forall epsilon : R, epsilon > 0 \
                 -> exists bound : R, forall x : R, x > bound -> Rabs (g x - b) < epsilon) -> (exists \
                 bound : R, forall x : R, x > bound -> domain x) -> (forall x : R, g x > 0) -> forall \
                 x : R, domain x -> b >= 0",
    )],
);

#[test]
fn a_claim_that_rests_on_limits_is_said_at_each_point() {
    assert_lemmas(&AT_POINTS);
}

/// What functions of the variable refute: the premises are denied to lead there.
pub(crate) const REFUTED: Said = (
    "var x, a, b\n\
     var f(x), g(x) > 0, k(x)\n\
     given pos: a > 0\n\
     given ahead: x > 0\n\
     given law: f = a + 1/x\n\
     given tends: g -> b as x -> oo\n\
     given mixed: a > 1, x > a\n\
     given late: f = a when x > b\n\
     claim wrong: f -> a + 1 as x -> oo from law, ahead expect refuted\n\
     claim apart: f = a from tends, law, ahead expect refuted\n\
     claim (m): f -> 2 as x -> oo expect refuted\n\
     claim free: not implied m from law, ahead\n\
     given line: k = x\n\
     claim grown: k -> 1 as x -> oo from line expect refuted\n\
     claim fallen: -k -> 1 as x -> oo from line expect refuted",
    &[
        (
            "wrong",
            "~ ( forall (a : R) (f : R -> R), (forall x : R, x > 0 -> (x <> 0 /\\ f x = a + 1 / \
                 x)) -> forall epsilon : R, epsilon > 0 -> exists bound : R, forall x : R, x > bound \
                 -> Rabs (f x - (a + 1)) < epsilon)",
        ),
        (
            "m",
            "~ ( forall (f : R -> R), forall epsilon : R, epsilon > 0 -> exists bound : R, forall \
                 x : R, x > bound -> Rabs (f x - 2) < epsilon)",
        ),
        // what is infinite is no number either
        (
            "grown",
            "~ ( forall (k : R -> R), (forall x : R, k x = x) -> forall epsilon : R, epsilon > 0 \
                 -> exists bound : R, forall x : R, x > bound -> Rabs (k x - 1) < epsilon)",
        ),
        (
            "fallen",
            "~ ( forall (k : R -> R), (forall x : R, k x = x) -> forall epsilon : R, epsilon > 0 \
                 -> exists bound : R, forall x : R, x > bound -> Rabs (- k x - 1) < epsilon)",
        ),
        (
            "free",
            "~ ( forall (a : R) (f : R -> R), (forall x : R, x > 0 -> (x <> 0 /\\ f x = a + 1 / \
                 x)) -> forall epsilon : R, epsilon > 0 -> exists bound : R, forall x : R, x > bound \
                 -> Rabs (f x - 2) < epsilon)",
        ),
    ],
);

#[test]
fn what_functions_refute_is_denied_where_the_variable_may_be() {
    assert_lemmas(&REFUTED);
}

/// Where nothing depends on the variable any value in its range will do, on whichever side it has an end.
pub(crate) const RANGES: Said = (
    "var x, 2 < t < 3, 3 < u, v < -3, a, b, 0 < m < 1\n\
     var f(x), g(t), h(u), k(v), 0 < p(x) < 1, r(x), 0 < q(u) < 1\n\
     given gx: f -> a as x -> oo\n\
     given gt: g -> a as t -> 2+\n\
     given gu: h -> a as u -> oo\n\
     given gv: k -> a as v -> -oo\n\
     given gp: p -> m as x -> oo\n\
     claim (x): a > 1 from gx expect refuted\n\
     claim (t): a > 1 from gt expect refuted\n\
     claim (u): a > 1 from gu expect refuted\n\
     claim (v): a > 1 from gv expect refuted\n\
     claim (p): p > 1/2 from gp expect refuted\n\
     claim (when): f > a when x > 1 from gx expect refuted\n\
     given gr: r -> a as x -> 0\n\
     claim (both): a > 1 from gr expect refuted\n\
     given gq: q -> 0 as u -> oo\n\
     claim (q): q > 1/2 from gq expect refuted",
    &[
        (
            "x",
            "~ ( forall (a : R) (f : R -> R), (forall epsilon : R, epsilon > 0 -> exists bound : \
                 R, forall x : R, x > bound -> Rabs (f x - a) < epsilon) -> forall x : R, a > 1)",
        ),
        (
            "t",
            "~ ( forall (a : R) (g : R -> R), (forall epsilon : R, epsilon > 0 -> exists delta : \
                 R, delta > 0 /\\ (forall t : R, 2 < t < 2 + delta -> Rabs (g t - a) < epsilon)) -> \
                 forall t : R, t > 2 -> t < 3 -> a > 1)",
        ),
        (
            "u",
            "~ ( forall (a : R) (h : R -> R), (forall epsilon : R, epsilon > 0 -> exists bound : \
                 R, forall u : R, u > bound -> Rabs (h u - a) < epsilon) -> forall u : R, u > 3 -> a \
                 > 1)",
        ),
        (
            "v",
            "~ ( forall (a : R) (k : R -> R), (forall epsilon : R, epsilon > 0 -> exists bound : \
                 R, forall v : R, v < bound -> Rabs (k v - a) < epsilon) -> forall v : R, v < -3 -> a \
                 > 1)",
        ),
        (
            "p",
            "~ ( forall (m : R) (p : R -> R), m > 0 -> m < 1 -> (forall epsilon : R, epsilon > 0 \
                 -> exists bound : R, forall x : R, x > bound -> Rabs (p x - m) < epsilon) -> (forall \
                 x : R, p x > 0 /\\ p x < 1) -> forall x : R, p x > 1 / 2)",
        ),
        // a function that is positive and falls to 0 is below 1 by the range of its variable
        (
            "q",
            "~ ( forall (q : R -> R), (forall epsilon : R, epsilon > 0 -> exists bound : R, forall \
                 u : R, u > bound -> Rabs (q u - 0) < epsilon) -> (forall u : R, u > 3 -> q u > 0 /\\ \
                 q u < 1) -> forall u : R, u > 3 -> q u > 1 / 2)",
        ),
        (
            "when",
            "~ ( forall (a : R) (f : R -> R), (forall epsilon : R, epsilon > 0 -> exists bound : \
                 R, forall x : R, x > bound -> Rabs (f x - a) < epsilon) -> forall x : R, x > 1 -> f \
                 x > a)",
        ),
    ],
);

#[test]
fn a_point_at_which_functions_refute_lies_in_the_range_of_the_variable() {
    assert_lemmas(&RANGES);
}

#[test]
fn each_side_of_a_limit_is_shown_once_to_lie_in_the_domain() {
    let shown = |near: &str| {
        let text = coq(&judged(&format!(
            "var x, a, b\nvar f(x), g(x)\ngiven one: f -> a as x -> {near}\n\
             given other: g -> b as x -> {near}\nclaim c: a > b from one, other expect refuted"
        )));
        let text = &text.lemmas[0].text;
        [true, false]
            .map(|above| text.matches(&format!("((Side (Some (q_ 0 1)) {above}), Within ")).count())
    };
    assert_eq!([shown("0"), shown("0+"), shown("0-")], [[1, 1], [1, 0], [0, 1]]);
}
