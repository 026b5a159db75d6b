//! The operations of an impact, counted by running the code on a number that counts.

use std::cell::Cell;
use std::fmt;
use std::ops::{Add, Div, Mul, Neg, Sub};

use kane_impact::laws::{RouthNewton, Stronge1990, Walton, WangSuLi, WhittakerUncapped};
use kane_impact::{Contact, ImpactLaw, NoImpulse, Outcome, law, laws};
use kane_number::{Comparison, Interval, Lane, Number, Ordered, Rational, Real, System};
use kane_scene::simulate::{Budget, Until, run};
use kane_scene::{Coordinate, Lasting, Model, NormalOnly, Resolver, model_names};

use crate::{above_floor, ball};

thread_local! {
    /// Additions, multiplications, divisions and roots so far.
    static COUNTS: Cell<[u64; 4]> = const { Cell::new([0; 4]) };
}

fn count(which: usize) {
    COUNTS.with(|counts| {
        let mut now = counts.get();
        now[which] += 1;
        counts.set(now);
    });
}

/// A float that counts.
#[derive(Clone, Debug, PartialEq)]
struct Counted(f64);

impl fmt::Display for Counted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl Neg for Counted {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.0)
    }
}

macro_rules! counts {
    ($($trait:ident $method:ident $which:literal;)*) => {$(
        impl $trait for Counted {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                self.$method(&other)
            }
        }

        impl $trait<&Self> for Counted {
            type Output = Self;

            fn $method(self, other: &Self) -> Self {
                count($which);
                Self(self.0.$method(other.0))
            }
        }
    )*};
}

counts! { Add add 0; Sub sub 0; Mul mul 1; Div div 2; }

impl Number for Counted {
    type Wide = Self;

    fn widen(&self) -> Self {
        self.clone()
    }

    fn narrow(wide: &Self) -> Self {
        wide.clone()
    }

    fn zero() -> Self {
        Self(0.0)
    }

    fn one() -> Self {
        Self(1.0)
    }

    fn from_rational(exact: &Rational) -> Self {
        Self(f64::from_rational(exact))
    }

    fn mul_add(&self, factor: &Self, addend: &Self) -> Self {
        count(0);
        count(1);
        Self(self.0.mul_add(factor.0, addend.0))
    }

    fn checked_div(&self, divisor: &Self) -> Option<Self> {
        count(2);
        self.0.checked_div(&divisor.0).map(Self)
    }

    fn is_finite(&self) -> bool {
        self.0.is_finite()
    }
}

impl Ordered for Counted {
    fn compare(&self, other: &Self) -> Comparison {
        self.0.compare(&other.0)
    }
}

impl Real for Counted {
    type WideReal = Self;
    type Working = Self;

    fn to_working(&self) -> Self {
        self.clone()
    }

    fn from_working(working: &Self) -> Self {
        working.clone()
    }

    fn greatest_root(coefficients: &[Self], lower: &Self, upper: &Self) -> Option<Self> {
        count(3);
        let coefficients: Vec<f64> = coefficients.iter().map(|c| c.0).collect();
        f64::greatest_root(&coefficients, &lower.0, &upper.0).map(Self)
    }
}

impl Lane for Counted {
    const SYSTEM: System = System::F64;

    fn sqrt(&self) -> Option<Self> {
        count(3);
        Lane::sqrt(&self.0).map(Self)
    }

    fn to_f64(&self) -> f64 {
        self.0
    }

    fn exact(&self) -> Option<Rational> {
        self.0.exact()
    }
}

impl Coordinate for Counted {
    fn of_enclosure(enclosure: Interval) -> Option<Self> {
        f64::of_enclosure(enclosure).map(Self)
    }
}

/// A law on the number that counts, which no law as a value knows.
struct Generic<L>(L);

impl<L: ImpactLaw> Resolver<Counted> for Generic<L> {
    fn resolve(&self, contact: &Contact<Counted>) -> Result<Outcome<Counted>, NoImpulse> {
        self.0.resolve(contact)
    }

    fn lasting(&self, _: &Contact<Counted>) -> Lasting<Counted> {
        Lasting::Unsummed
    }
}

/// Keeps the operations of the impact alone.
struct Impact<'r>(&'r dyn Resolver<Counted>, Cell<[u64; 4]>);

impl Resolver<Counted> for Impact<'_> {
    fn resolve(&self, contact: &Contact<Counted>) -> Result<Outcome<Counted>, NoImpulse> {
        let before = COUNTS.with(Cell::get);
        let outcome = self.0.resolve(contact);
        let after = COUNTS.with(Cell::get);
        self.1.set(std::array::from_fn(|kind| after[kind] - before[kind]));
        outcome
    }

    fn lasting(&self, next: &Contact<Counted>) -> Lasting<Counted> {
        self.0.lasting(next)
    }
}

/// The operations of the fall of a ball, its impact, and the look for the next one, and those of the
/// impact alone; the most over impacts with little slip and much.
fn operations(resolver: &dyn Resolver<Counted>) -> [[u64; 4]; 2] {
    let mut most = [[0; 4]; 2];
    for slip in ["1/10", "1/2", "3"] {
        let ball = ball("1/3", "1/2", ["0", "2"], [slip, "-1", "1/7"]);
        let world = above_floor(vec![ball], "10", "1/5", "3/4").map(Counted::from_rational);
        COUNTS.with(|counts| counts.set([0; 4]));
        let impact = Impact(resolver, Cell::default());
        run(&world, &impact, &Until::Impacts(1), Budget::default(), &mut |_| {})
            .expect("it falls and bounces");
        let counted = [COUNTS.with(Cell::get), impact.1.get()];
        for (most, counted) in most.iter_mut().flatten().zip(counted.into_iter().flatten()) {
            *most = counted.max(*most);
        }
    }
    most
}

#[test]
fn the_costs_of_models_are_counted_in_the_code() {
    let half = crate::n("1/2");
    let found: [(&str, Box<dyn Resolver<Counted>>); 6] = [
        ("normal-only", Box::new(NormalOnly)),
        ("whittaker-uncapped", Box::new(Generic(WhittakerUncapped))),
        ("wang-su-li", Box::new(Generic(WangSuLi))),
        ("routh-newton", Box::new(Generic(RouthNewton))),
        ("walton", Box::new(Generic(Walton { restitution: half }))),
        ("stronge-1990", Box::new(Generic(Stronge1990))),
    ];
    for (name, resolver) in &found {
        let [whole, impact] = operations(&**resolver);
        let mechanics = Model::named(name, laws()).expect("it is a model").mechanics;
        assert_eq!((name, mechanics.operations()), (name, whole));
        if let Some(law) = law(name) {
            let model = law.info.model.expect("it is a model");
            assert_eq!((name, model.operations), (name, impact));
        }
    }
    let names = model_names(laws());
    for name in &names {
        let counted = found.iter().any(|(known, _)| known == name);
        let mechanics = Model::named(name, laws()).expect("it is a model").mechanics;
        assert_eq!(mechanics.is_counted(), counted, "{name}");
    }
    assert!(found.iter().all(|(name, _)| names.contains(name)), "{names:?}");
}
