//! Each rule of arguments: a valid use is written out in what the kernel accepts, and each part of
//! it can be wrong.

use kane_kernel::{
    Atom, Conclusion, Context, Fuel, Goal, Passages, Poly, Root, Sign, State, Term, Var, scope,
};
use num_bigint::BigInt;
use num_rational::BigRational;

use super::{Argument, Rules, expand};

type Q = BigRational;

const X: usize = 0;
const Y: usize = 1;

fn q(n: i64, d: i64) -> Q {
    Q::new(n.into(), d.into())
}

/// A contradiction claim in x, y and z without premises.
fn plain() -> Goal {
    let var = |name: &str| Var { name: name.to_string(), of: None, lower: None, upper: None };
    Goal {
        context: Context { vars: ["x", "y", "z"].map(var).to_vec(), ..Context::default() },
        hypotheses: Vec::new(),
        behind: Vec::new(),
        when: Vec::new(),
        conclusion: Conclusion::Contradiction,
    }
}

fn x() -> Poly {
    Poly::var(X)
}

fn y() -> Poly {
    Poly::var(Y)
}

fn n(c: i64) -> Poly {
    Poly::constant(c.into())
}

fn equal(p: Poly) -> Atom {
    Atom::new(p, Sign::Zero)
}

fn positive(p: Poly) -> Atom {
    Atom::new(p, Sign::Positive)
}

fn at_least(p: Poly) -> Atom {
    Atom::new(p, Sign::NonNegative)
}

fn distinct(p: Poly) -> Atom {
    Atom::new(p, Sign::NonZero)
}

/// Asks about a state with these atoms.
fn asked<T>(atoms: &[Atom], ask: impl FnOnce(&State<'_, '_>) -> T) -> T {
    let goal = plain();
    let scope = scope(&goal, Fuel::new(10_000_000)).expect("a small goal");
    let (atoms, formulas) = (atoms.to_vec(), std::rc::Rc::default());
    let (reaching, passages) = (false, Passages::Anywhere);
    ask(&State { scope: &scope, goal: &goal, atoms, formulas, reaching, passages })
}

/// Whether the rules take an argument, and whether the kernel takes what it is written out as.
fn taken(atoms: &[Atom], argument: &Argument) -> (bool, bool) {
    asked(atoms, |state| {
        let written = expand(state, argument);
        (state.closes(argument).is_ok(), written.is_ok_and(|p| state.refute(&p).is_ok()))
    })
}

/// The first argument is taken and written out, the others are refused by the rules.
fn only_first(atoms: &[Atom], arguments: &[Argument]) {
    for (i, argument) in arguments.iter().enumerate() {
        let (rules, kernel) = taken(atoms, argument);
        assert_eq!(rules, i == 0, "argument {i}: {argument:?}");
        assert!(kernel || i > 0, "argument {i}: {argument:?}");
    }
}

#[test]
fn absurd_needs_a_false_constant() {
    only_first(
        &[positive(n(-1)), equal(x())],
        &[Argument::Absurd(0), Argument::Absurd(1), Argument::Absurd(2)],
    );
    for atom in [equal(n(2)), equal(n(-2)), distinct(n(0)), positive(n(0)), at_least(n(-3))] {
        only_first(&[atom], &[Argument::Absurd(0)]);
    }
}

#[test]
fn substitution_needs_an_equation_and_a_lead_that_cannot_vanish() {
    // x·y = 1, x > 0, −y ≥ 0: with y = 1/x the last says −1 ≥ 0.
    let product = x().mul(&y(), &Fuel::new(10)).expect("small").sub(&n(1));
    let atoms = [equal(product), positive(x()), at_least(y().neg())];
    let step = |equation, var, lead| Argument::Substitute {
        equation,
        var,
        lead,
        then: Box::new(Argument::Absurd(2)),
    };
    only_first(
        &atoms,
        &[
            step(0, Y, vec![(1, 1)]),
            step(1, Y, vec![(1, 1)]),
            step(0, X, vec![(1, 1)]),
            step(0, Y, Vec::new()),
            step(0, Y, vec![(1, 2)]),
            step(0, Y, vec![(2, 1)]),
        ],
    );
    // With x ≠ 0 alone the sign of 1/x is open, and x = y = −1 is a point.
    let weaker = [atoms[0].clone(), distinct(x()), atoms[2].clone()];
    assert_eq!(taken(&weaker, &step(0, Y, vec![(1, 1)])), (false, false));
}

#[test]
fn cancelling_needs_factors_that_cannot_vanish() {
    // x·y < 0 with x ≠ 0, y > 0 …
    let product = x().mul(&y(), &Fuel::new(10)).expect("small");
    let rest = |quotient, factors| Argument::Cancel {
        atom: 0,
        factors,
        quotient,
        then: Box::new(Argument::Absurd(0)),
    };
    // … for x·y = 0 it leaves 1 = 0.
    let atoms = [equal(product.clone()), distinct(x()), positive(y()), at_least(x())];
    only_first(
        &atoms,
        &[
            rest(n(1), vec![(1, 1), (2, 1)]),
            rest(n(1), vec![(1, 1)]),
            rest(n(1), vec![(3, 1), (2, 1)]),
            rest(n(1), vec![(0, 1)]),
            rest(n(1), vec![(1, 1), (2, 2)]),
            rest(n(0), vec![(1, 1), (2, 1)]),
        ],
    );
    // −x > 0 divided by x ≠ 0 says nothing of the sign.
    let weaker = [positive(x().neg()), distinct(x())];
    assert_eq!(taken(&weaker, &rest(n(-1), vec![(1, 1)])), (false, false));
}

#[test]
fn the_orthant_counts_faces_that_belong_to_the_region() {
    // −x − y ≥ 0 with x > 0 and y ≥ 0.
    let target = at_least(x().neg().sub(&y()));
    let orthant = |bounds| Argument::Orthant { atom: 0, bounds };
    let atoms = [target.clone(), positive(x()), at_least(y()), at_least(x())];
    only_first(
        &atoms,
        &[
            orthant(vec![(X, Some(1), None), (Y, Some(2), None)]),
            orthant(vec![(X, Some(3), None), (Y, Some(2), None)]),
            orthant(vec![(X, None, Some(1)), (Y, Some(2), None)]),
            orthant(vec![(X, Some(1), None), (Y, Some(1), None)]),
            orthant(vec![(X, Some(1), None), (Y, None, None)]),
            orthant(vec![(X, Some(1), None)]),
            Argument::Orthant { atom: 1, bounds: vec![(X, Some(1), None)] },
        ],
    );
    // Bounds that leave one point, or none.
    let pinched = |low: i64, high| {
        let ends = [at_least(x().sub(&n(low))), at_least(n(high).sub(&x()))];
        [&[equal(x().sub(&n(5)))][..], &ends].concat()
    };
    for (low, high) in [(1, 1), (2, 1)] {
        let argument = orthant(vec![(X, Some(1), Some(2))]);
        assert!(taken(&pinched(low, high), &argument).1, "{low} {high}");
    }
    // x − 1 ≥ 0 fails on 0 ≤ x < 1, but not on 0 ≤ x ≤ 1.
    let below = |end: Atom| [at_least(x().sub(&n(1))), at_least(x()), end];
    let bounds = || orthant(vec![(X, Some(1), Some(2))]);
    assert_eq!(taken(&below(positive(n(1).sub(&x()))), &bounds()), (true, true));
    assert_eq!(taken(&below(at_least(n(1).sub(&x()))), &bounds()), (false, false));
}

#[test]
fn a_sign_table_covers_the_line() {
    // x² − 2 = 0 and x > 2.
    let base = || vec![BigInt::from(-2), BigInt::from(0), BigInt::from(1)];
    let line = || vec![BigInt::from(-2), BigInt::from(1)];
    let atoms = [equal(Poly::in_variable(X, &base())), positive(x().sub(&n(2)))];
    let root = |poly, lo, hi| Root { poly, lo, hi };
    let roots = || {
        vec![
            root(base(), q(-2, 1), q(-1, 1)),
            root(base(), q(1, 1), q(3, 2)),
            root(line(), q(2, 1), q(2, 1)),
        ]
    };
    let used = || vec![(0, q(1, 1), vec![1, 0]), (1, q(1, 1), vec![0, 1])];
    let table = |var, bases, roots, atoms| Argument::SignTable { var, bases, roots, atoms };
    let swapped = |a: usize, b: usize| {
        let mut all = roots();
        all.swap(a, b);
        all
    };
    let moved = |lo, hi| vec![roots()[0].clone(), root(base(), lo, hi), roots()[2].clone()];
    only_first(
        &atoms,
        &[
            table(X, vec![base(), line()], roots(), used()),
            table(Y, vec![base(), line()], roots(), used()),
            table(X, vec![line(), base()], roots(), used()),
            table(X, vec![base(), line()], roots()[1..].to_vec(), used()),
            table(X, vec![base(), line()], roots()[..2].to_vec(), used()),
            table(X, vec![base(), line()], swapped(0, 1), used()),
            table(X, vec![base(), line()], moved(q(3, 2), q(7, 4)), used()),
            table(X, vec![base(), line()], moved(q(1, 1), q(3, 1)), used()),
            table(X, vec![base(), line()], roots(), used()[..1].to_vec()),
            table(
                X,
                vec![base(), line()],
                roots(),
                vec![(0, q(2, 1), vec![1, 0]), used()[1].clone()],
            ),
            table(
                X,
                vec![base(), line()],
                roots(),
                vec![(0, q(1, 1), vec![2, 0]), used()[1].clone()],
            ),
            table(
                X,
                vec![base(), line()],
                roots(),
                vec![(1, q(1, 1), vec![1, 0]), used()[1].clone()],
            ),
        ],
    );
}

#[test]
fn a_derived_atom_of_each_sign_is_cut_in() {
    // With x·y = 1 the atom on x² becomes one on 1, and with x² = 2 one on 2.
    let fuel = Fuel::new(1000);
    let product = x().mul(&y(), &fuel).expect("small");
    let square = |p: &Poly| p.mul(p, &fuel).expect("small");
    let rule = equal(product.sub(&n(1)));
    for known in [positive(x()), distinct(x())] {
        for wrong in [equal(y()), distinct(product.sub(&n(1))), at_least(square(&y()).neg())] {
            let lead = vec![(1, 1)];
            let then = Box::new(Argument::Absurd(2));
            let argument = Argument::Substitute { equation: 0, var: Y, lead, then };
            let atoms = [rule.clone(), known.clone(), wrong];
            assert_eq!(taken(&atoms, &argument), (true, true), "{atoms:?}");
        }
    }
    // A factor that cannot vanish, below each sign; what is left is contradicted by the last atom.
    let cancelled = |sign, known: Atom, power: u32, last: Atom| {
        let factor = x().pow(power, &fuel).expect("small");
        let left = y().sub(&n(1));
        let atoms = [Atom::new(factor.mul(&left, &fuel).expect("small"), sign), known, last];
        let term = |factors| Term { weight: 1.into(), square: n(1), factors };
        let (terms, cofactors) = match sign {
            Sign::Zero => (vec![term(vec![(2, 1)])], vec![(0, n(-1))]),
            Sign::NonZero => (vec![term(vec![(0, 2)])], vec![(2, left.neg())]),
            _ => (vec![term(vec![(0, 1)]), term(vec![(2, 1)])], Vec::new()),
        };
        let then = Box::new(Argument::Positive { terms, cofactors });
        let factors = vec![(1, power)];
        let argument = Argument::Cancel { atom: 0, factors, quotient: left, then };
        assert_eq!(taken(&atoms, &argument), (true, true), "{atoms:?}");
    };
    let (above, below) = (|| positive(y().sub(&n(1))), || positive(n(1).sub(&y())));
    for power in [1, 2] {
        cancelled(Sign::Zero, distinct(x()), power, above());
        cancelled(Sign::Zero, positive(x()), power, above());
        cancelled(Sign::NonZero, distinct(x()), power, equal(y().sub(&n(1))));
        cancelled(Sign::NonNegative, positive(x()), power, below());
        cancelled(Sign::Positive, positive(x()), power, at_least(n(1).sub(&y())));
    }
    cancelled(Sign::NonNegative, distinct(x()), 2, below());
    cancelled(Sign::Positive, distinct(x()), 2, at_least(n(1).sub(&y())));
}
