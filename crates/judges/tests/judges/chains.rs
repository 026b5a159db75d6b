//! Theorems say what follows from the givens, through all claims in between.

use crate::lemmas::{Said, assert_theorems};

/// Claims at points.
pub(crate) const AT_POINTS: Said = (
    "var x, y, z\n\
     var 0 < u < 1, w >= 0\n\
     given g: y = x + 1\n\
     given p: x > 0\n\
     claim a: y > 1 from g, p\n\
     claim b: y^2 > 1 from a\n\
     claim c: y^2 + x > 1 when z > 0 from b, p\n\
     claim d: y > 3 when x > 2 from g\n\
     claim e: y + u > 3 when x > 2 from d\n\
     claim pair: y > 0, x + y > 1 from a, p\n\
     claim last: x + 2*y > 1 from pair\n\
     claim quotient: 1/y < 1 from a\n\
     claim under: 1/y < 2 from quotient\n\
     claim root: sqrt(y) > 1 from a\n\
     claim roots: sqrt(y)*(1 + w) > 1 from root\n\
     claim slope: d(x^2, x) > 0 from p\n\
     claim steep: d(x^2, x) + u > 0 from slope\n\
     claim wrong: y > 5 from g, p expect refuted\n\
     claim after: y > 4 from wrong\n\
     claim two: y^2 > 1, y^2 + u > 1 from b\n\
     let inc := x + 1\n\
     claim named: y + inc > 2 from inc, g, p\n\
     claim again: y + inc > 1 from named, inc\n\
     claim product: sqrt(y)*d(x^2, x) > 0 from a, p\n\
     claim power: d(x^3, x) > 0 from p\n\
     claim both: sqrt(y)*d(x^2, x) + d(x^3, x) + u > 0 from product, power, a",
    &[
        ("b", "forall x y : R, y = x + 1 -> x > 0 -> y ^ 2 > 1"),
        ("c", "forall x y z : R, y = x + 1 -> x > 0 -> z > 0 -> y ^ 2 + x > 1"),
        ("e", "forall x y u : R, u > 0 -> u < 1 -> y = x + 1 -> x > 2 -> y + u > 3"),
        ("last", "forall x y : R, y = x + 1 -> x > 0 -> x + 2 * y > 1"),
        ("quotient", "forall x y : R, y = x + 1 -> x > 0 -> y <> 0 /\\ 1 / y < 1"),
        (
            "root",
            "forall x y root : R, (0 <= y -> 0 <= root /\\ root * root = y) -> y = x + 1 -> x > 0 \
                 -> 0 <= y /\\ root > 1",
        ),
        (
            "steep",
            "forall x u slope : R, (derivable_pt_lim (fun x : R => x ^ 2) x slope) -> u > 0 -> u \
                 < 1 -> x > 0 -> slope + u > 0",
        ),
        ("two_2", "forall x y u : R, u > 0 -> u < 1 -> y = x + 1 -> x > 0 -> y ^ 2 + u > 1"),
        // a definition that is cited is no premise
        ("again", "forall x y : R, y = x + 1 -> x > 0 -> y + (x + 1) > 1"),
        (
            "both",
            "forall x y u root slope slope_2 : R, (0 <= y -> 0 <= root /\\ root * root = y) -> \
                 (derivable_pt_lim (fun x : R => x ^ 2) x slope) -> (derivable_pt_lim (fun x : R => x \
                 ^ 3) x slope_2) -> u > 0 -> u < 1 -> y = x + 1 -> x > 0 -> 0 <= y /\\ root * slope + \
                 slope_2 + u > 0",
        ),
    ],
);

/// Claims about functions of a variable.
pub(crate) const ALONG: Said = (
    "var x, a, b, c\n\
     var f(x), g(x), 0 < h(x) < 2\n\
     given apos: a > 0\n\
     given ahead: x > 0\n\
     given law: f = a + b/x\n\
     given double: g = 2*f\n\
     given both: c > a, x > a\n\
     claim far: f -> a as x -> oo from law, ahead\n\
     claim twice: g -> 2*a as x -> oo from far, double\n\
     claim here: x*(f - a) = b from law, ahead\n\
     claim there: x*(g - 2*a) = 2*b from here, double\n\
     claim big: c > 0 from apos, both\n\
     claim bigger: f + c -> a + c as x -> oo when c > 0 from far, big\n\
     claim in-range: h*x < 2*x from ahead\n\
     claim squared: h^2*x < 4*x from in-range, ahead\n\
     given line: g = b + c*f\n\
     claim tie: 2*a = b + c*a from twice, far, line\n\
     claim tied: (2 - c)*a = b from tie\n\
     claim since: (2 - c)*f -> b as x -> oo from far, tied\n\
     claim at-x: (2 - c)*a*x = b*x when x > 1 from tied, ahead\n\
     claim in-all: (2 - c)*a*f = b*f from tied, law\n\
     claim square: (2 - c)*a*x^2 = b*x^2 when x > 1 from at-x\n\
     claim steady: (2 - c)*a*a = b*a when a > 1 from tied\n\
     claim steadier: (2 - c)*a*a + 1 = b*a + 1 when a > 1 from steady",
    &[
        (
            "twice",
            "forall (a b : R) (f g : R -> R) (domain : R -> Prop), (exists bound : R, forall x : \
                 R, x > bound -> domain x) -> (forall x : R, domain x -> x > 0) -> (forall x : R, \
                 domain x -> (x <> 0 /\\ f x = a + b / x)) -> (forall x : R, domain x -> g x = 2 * f \
                 x) -> forall epsilon : R, epsilon > 0 -> exists bound : R, forall x : R, x > bound \
                 -> Rabs (g x - 2 * a) < epsilon",
        ),
        (
            "there'",
            "forall x a b f g : R, x > 0 -> (x <> 0 /\\ f = a + b / x) -> g = 2 * f -> x * (g - 2 \
                 * a) = 2 * b",
        ),
        ("squared", "forall x h : R, h > 0 -> h < 2 -> x > 0 -> h ^ 2 * x < 4 * x"),
        (
            "tie",
            "forall (a b c : R) (f g : R -> R) (domain : R -> Prop), (exists bound : R, forall x \
                 : R, x > bound -> domain x) -> (forall x : R, domain x -> x > 0) -> (forall x : R, \
                 domain x -> (x <> 0 /\\ f x = a + b / x)) -> (forall x : R, domain x -> g x = 2 * f \
                 x) -> (forall x : R, domain x -> g x = b + c * f x) -> forall x : R, domain x -> 2 * \
                 a = b + c * a",
        ),
        (
            "tied",
            "forall (a b c : R) (f g : R -> R) (domain : R -> Prop), (exists bound : R, forall x \
                 : R, x > bound -> domain x) -> (forall x : R, domain x -> x > 0) -> (forall x : R, \
                 domain x -> (x <> 0 /\\ f x = a + b / x)) -> (forall x : R, domain x -> g x = 2 * f \
                 x) -> (forall x : R, domain x -> g x = b + c * f x) -> forall x : R, domain x -> (2 \
                 - c) * a = b",
        ),
        (
            "since",
            "forall (a b c : R) (f g : R -> R) (domain : R -> Prop), (exists bound : R, forall x \
                 : R, x > bound -> domain x) -> (forall x : R, domain x -> x > 0) -> (forall x : R, \
                 domain x -> (x <> 0 /\\ f x = a + b / x)) -> (forall x : R, domain x -> g x = 2 * f \
                 x) -> (forall x : R, domain x -> g x = b + c * f x) -> forall epsilon : R, epsilon > \
                 0 -> exists bound : R, forall x : R, x > bound -> Rabs ((2 - c) * f x - b) < epsilon",
        ),
        (
            "at_x",
            "forall (a b c : R) (f g : R -> R) (domain : R -> Prop), (exists bound : R, forall x \
                 : R, x > bound -> domain x) -> (forall x : R, domain x -> x > 0) -> (forall x : R, \
                 domain x -> (x <> 0 /\\ f x = a + b / x)) -> (forall x : R, domain x -> g x = 2 * f \
                 x) -> (forall x : R, domain x -> g x = b + c * f x) -> forall x : R, domain x -> x > \
                 1 -> (2 - c) * a * x = b * x",
        ),
        (
            "in_all",
            "forall (a b c : R) (f g : R -> R) (domain : R -> Prop), (exists bound : R, forall x \
                 : R, x > bound -> domain x) -> (forall x : R, domain x -> x > 0) -> (forall x : R, \
                 domain x -> (x <> 0 /\\ f x = a + b / x)) -> (forall x : R, domain x -> g x = 2 * f \
                 x) -> (forall x : R, domain x -> g x = b + c * f x) -> forall x : R, domain x -> (2 \
                 - c) * a * f x = b * f x",
        ),
        (
            "steadier",
            "forall (a b c : R) (f g : R -> R) (domain : R -> Prop), a > 1 -> (exists bound : R, \
                 forall x : R, x > bound -> domain x) -> (forall x : R, domain x -> x > 0) -> (forall \
                 x : R, domain x -> (x <> 0 /\\ f x = a + b / x)) -> (forall x : R, domain x -> g x = \
                 2 * f x) -> (forall x : R, domain x -> g x = b + c * f x) -> forall x : R, domain x \
                 -> (2 - c) * a * a + 1 = b * a + 1",
        ),
        (
            "square",
            "forall (a b c : R) (f g : R -> R) (domain : R -> Prop), (exists bound : R, forall x \
                 : R, x > bound -> domain x) -> (forall x : R, domain x -> x > 0) -> (forall x : R, \
                 domain x -> (x <> 0 /\\ f x = a + b / x)) -> (forall x : R, domain x -> g x = 2 * f \
                 x) -> (forall x : R, domain x -> g x = b + c * f x) -> forall x : R, domain x -> x > \
                 1 -> (2 - c) * a * x ^ 2 = b * x ^ 2",
        ),
    ],
);

/// Claims about functions of a variable that has an end, with ranges of constants and functions.
pub(crate) const RANGED: Said = (
    "var 0 < t < 5, 0 < m < 1, n\n\
     var p(t), 0 < q(t) < 2, r(t) > 0, s(t)\n\
     let grown := m + t*q\n\
     given law: p = grown\n\
     given end: q -> 1 as t -> 0+\n\
     given order: n > m\n\
     given shift: s = p + r when t < 1\n\
     claim start: p -> m as t -> 0+ from law, end\n\
     claim rise: p + q -> m + 1 as t -> 0+ from start, end\n\
     claim above: p > m from law\n\
     claim higher: s > m + r when t < 1 from above, shift\n\
     claim under: p < m + 2*t from law\n\
     claim back: m < n + 1 from order\n\
     claim end-of: p + n -> m + n as t -> 0+ when n > 0 from start, order\n\
     claim over: n > 0 from order\n\
     claim end-over: p/n -> m/n as t -> 0+ from start, over\n\
     claim meets: m + 1 < n + 1 from rise, order\n\
     claim squeeze: s - r -> m as t -> 0+ from start, shift\n\
     claim then: p*2 > 2*m when t < 1 from higher, shift\n\
     claim held: r*t > 0 when t < 2 from law\n\
     given low: r -> n as t -> 0+\n\
     claim bottom: n >= 0 when n > -1 from low\n\
     claim lifted: n + 1 > 0 when n > -1 from bottom\n\
     claim apart: p - m = t*q from law\n\
     claim twice: 2*(p - m) = 2*t*q from apart\n\
     claim vanishes: 2*(p - m) -> 0 as t -> 0+ from twice, end",
    &[
        (
            "rise",
            "forall (m : R) (p q : R -> R) (domain : R -> Prop), m > 0 -> m < 1 -> (forall \
                 epsilon : R, epsilon > 0 -> exists delta : R, delta > 0 /\\ (forall t : R, 0 < t < 0 \
                 + delta -> Rabs (q t - 1) < epsilon)) -> (exists delta : R, delta > 0 /\\ (forall t \
                 : R, 0 < t < 0 + delta -> domain t)) -> (forall t : R, t > 0 -> t < 5 -> q t > 0 /\\ \
                 q t < 2) -> (forall t : R, t > 0 -> t < 5 -> domain t -> p t = m + t * q t) -> \
                 forall epsilon : R, epsilon > 0 -> exists delta : R, delta > 0 /\\ (forall t : R, 0 \
                 < t < 0 + delta -> Rabs (p t + q t - (m + 1)) < epsilon)",
        ),
        (
            "higher",
            "forall t m p q r s : R, t > 0 -> t < 5 -> m > 0 -> m < 1 -> q > 0 -> q < 2 -> r > 0 \
                 -> p = m + t * q -> (t < 1 -> s = p + r) -> t < 1 -> s > m + r",
        ),
        (
            "end_of",
            "forall (m n : R) (p q : R -> R) (domain : R -> Prop), m > 0 -> m < 1 -> n > m -> n > \
                 0 -> (forall epsilon : R, epsilon > 0 -> exists delta : R, delta > 0 /\\ (forall t : \
                 R, 0 < t < 0 + delta -> Rabs (q t - 1) < epsilon)) -> (exists delta : R, delta > 0 \
                 /\\ (forall t : R, 0 < t < 0 + delta -> domain t)) -> (forall t : R, t > 0 -> t < 5 \
                 -> q t > 0 /\\ q t < 2) -> (forall t : R, t > 0 -> t < 5 -> domain t -> p t = m + t \
                 * q t) -> forall epsilon : R, epsilon > 0 -> exists delta : R, delta > 0 /\\ (forall \
                 t : R, 0 < t < 0 + delta -> Rabs (p t + n - (m + n)) < epsilon)",
        ),
        (
            "end_over",
            "forall (m n : R) (p q : R -> R) (domain : R -> Prop), m > 0 -> m < 1 -> n > m -> \
                 (forall epsilon : R, epsilon > 0 -> exists delta : R, delta > 0 /\\ (forall t : R, 0 \
                 < t < 0 + delta -> Rabs (q t - 1) < epsilon)) -> (exists delta : R, delta > 0 /\\ \
                 (forall t : R, 0 < t < 0 + delta -> domain t)) -> (forall t : R, t > 0 -> t < 5 -> q \
                 t > 0 /\\ q t < 2) -> (forall t : R, t > 0 -> t < 5 -> domain t -> p t = m + t * q \
                 t) -> n <> 0 /\\ (forall epsilon : R, epsilon > 0 -> exists delta : R, delta > 0 /\\ \
                 (forall t : R, 0 < t < 0 + delta -> (n <> 0 /\\ Rabs (p t / n - m / n) < epsilon)))",
        ),
        (
            "meets",
            "forall (m n : R) (p q : R -> R) (domain : R -> Prop), m > 0 -> m < 1 -> n > m -> \
                 (forall epsilon : R, epsilon > 0 -> exists delta : R, delta > 0 /\\ (forall t : R, 0 \
                 < t < 0 + delta -> Rabs (q t - 1) < epsilon)) -> (exists delta : R, delta > 0 /\\ \
                 (forall t : R, 0 < t < 0 + delta -> domain t)) -> (forall t : R, t > 0 -> t < 5 -> q \
                 t > 0 /\\ q t < 2) -> (forall t : R, t > 0 -> t < 5 -> domain t -> p t = m + t * q \
                 t) -> forall t : R, t > 0 -> t < 5 -> domain t -> m + 1 < n + 1",
        ),
        (
            "squeeze",
            "forall (m : R) (p q r s : R -> R) (domain : R -> Prop), m > 0 -> m < 1 -> (forall \
                 epsilon : R, epsilon > 0 -> exists delta : R, delta > 0 /\\ (forall t : R, 0 < t < 0 \
                 + delta -> Rabs (q t - 1) < epsilon)) -> (exists delta : R, delta > 0 /\\ (forall t \
                 : R, 0 < t < 0 + delta -> domain t)) -> (forall t : R, t > 0 -> t < 5 -> q t > 0 /\\ \
                 q t < 2 /\\ r t > 0) -> (forall t : R, t > 0 -> t < 5 -> domain t -> p t = m + t * q \
                 t) -> (forall t : R, t > 0 -> t < 5 -> domain t -> (t < 1 -> s t = p t + r t)) -> \
                 forall epsilon : R, epsilon > 0 -> exists delta : R, delta > 0 /\\ (forall t : R, 0 \
                 < t < 0 + delta -> Rabs (s t - r t - m) < epsilon)",
        ),
        (
            "lifted",
            "forall (n : R) (r : R -> R) (domain : R -> Prop), n > - 1 -> (forall epsilon : R, \
                 epsilon > 0 -> exists delta : R, delta > 0 /\\ (forall t : R, 0 < t < 0 + delta -> \
                 Rabs (r t - n) < epsilon)) -> (exists delta : R, delta > 0 /\\ (forall t : R, 0 < t \
                 < 0 + delta -> domain t)) -> (forall t : R, t > 0 -> t < 5 -> r t > 0) -> forall t : \
                 R, t > 0 -> t < 5 -> domain t -> n + 1 > 0",
        ),
        (
            "vanishes",
            "forall (m : R) (p q : R -> R) (domain : R -> Prop), m > 0 -> m < 1 -> (forall \
                 epsilon : R, epsilon > 0 -> exists delta : R, delta > 0 /\\ (forall t : R, 0 < t < 0 \
                 + delta -> Rabs (q t - 1) < epsilon)) -> (exists delta : R, delta > 0 /\\ (forall t \
                 : R, 0 < t < 0 + delta -> domain t)) -> (forall t : R, t > 0 -> t < 5 -> q t > 0 /\\ \
                 q t < 2) -> (forall t : R, t > 0 -> t < 5 -> domain t -> p t = m + t * q t) -> \
                 forall epsilon : R, epsilon > 0 -> exists delta : R, delta > 0 /\\ (forall t : R, 0 \
                 < t < 0 + delta -> Rabs (2 * (p t - m) - 0) < epsilon)",
        ),
        (
            "then",
            "forall t m p q r s : R, t > 0 -> t < 5 -> m > 0 -> m < 1 -> q > 0 -> q < 2 -> r > 0 \
                 -> p = m + t * q -> (t < 1 -> s = p + r) -> t < 1 -> p * 2 > 2 * m",
        ),
    ],
);

/// A definition of which a given speaks, and a claim that rests on that given and does not mention it.
pub(crate) const DEFINED: Said = (
    "var x, a, b\n\
     var f(x)\n\
     let top := a + 1\n\
     given tends: f -> top as x -> oo\n\
     given above: f > b\n\
     claim order: a + 1 >= b from tends, above\n\
     claim later: a + 2 > b from order\n\
     claim ahead: (a + 1)*x >= b*x when x > 0 from tends, above\n\
     claim beyond: (a + 1)*x + 1 > b*x when x > 0 from ahead",
    &[
        (
            "later",
            "forall (a b : R) (f : R -> R) (domain : R -> Prop), (forall epsilon : R, epsilon > 0 \
                 -> exists bound : R, forall x : R, x > bound -> Rabs (f x - (a + 1)) < epsilon) -> \
                 (exists bound : R, forall x : R, x > bound -> domain x) -> (forall x : R, domain x \
                 -> f x > b) -> forall x : R, domain x -> a + 2 > b",
        ),
        // the condition of what is cited holds at the point
        (
            "beyond",
            "forall (a b : R) (f : R -> R) (domain : R -> Prop), (forall epsilon : R, epsilon > 0 \
                 -> exists bound : R, forall x : R, x > bound -> Rabs (f x - (a + 1)) < epsilon) -> \
                 (exists bound : R, forall x : R, x > bound -> domain x) -> (forall x : R, domain x \
                 -> f x > b) -> forall x : R, domain x -> x > 0 -> (a + 1) * x + 1 > b * x",
        ),
    ],
);

#[test]
fn a_theorem_writes_out_what_its_givens_mention_and_its_claim_does_not() {
    assert_theorems(&DEFINED);
}

#[test]
fn theorems_say_what_follows_from_the_givens_on_which_a_claim_rests() {
    assert_theorems(&AT_POINTS);
}

#[test]
fn theorems_about_functions_hold_on_a_set_on_which_all_givens_do() {
    assert_theorems(&ALONG);
}

#[test]
fn declared_ranges_stand_before_what_is_said_on_the_set() {
    assert_theorems(&RANGED);
}
