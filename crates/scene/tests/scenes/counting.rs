//! The operations of an impact, counted by running the code on a number that counts.

use std::cell::Cell;
use std::fmt;
use std::ops::{Add, Div, Mul, Neg, Sub};

use kane_impact::laws::{RouthNewton, Stronge1990, Walton, WangSuLi, WhittakerUncapped};
use kane_number::{Comparison, Interval, Lane, Number, Ordered, Rational, Real, System};
use kane_scene::simulate::{Budget, Until, run};
use kane_scene::{ByLaw, Coordinate, Mechanics, NormalOnly, Resolver};

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

/// The operations of the fall of a ball, its impact, and the look for the next one; the most over
/// impacts with little slip and much.
fn operations(resolver: &dyn Resolver<Counted>) -> [u64; 4] {
    let mut most = [0; 4];
    for slip in ["1/10", "1/2", "3"] {
        let ball = ball("1/3", "1/2", ["0", "2"], [slip, "-1", "1/7"]);
        let world = above_floor(vec![ball], "10", "1/5", "3/4").map(Counted::from_rational);
        COUNTS.with(|counts| counts.set([0; 4]));
        run(&world, resolver, &Until::Impacts(1), Budget::default(), &mut |_| {})
            .expect("it falls and bounces");
        let counted = COUNTS.with(Cell::get);
        for (most, counted) in most.iter_mut().zip(counted) {
            *most = counted.max(*most);
        }
    }
    most
}

#[test]
fn the_costs_of_models_are_counted_in_the_code() {
    let half = crate::n("1/2");
    let found: [(Mechanics, Box<dyn Resolver<Counted>>); 6] = [
        (Mechanics::NormalOnly, Box::new(NormalOnly)),
        (Mechanics::Sliding, Box::new(ByLaw(WhittakerUncapped))),
        (Mechanics::WangSuLi, Box::new(ByLaw(WangSuLi))),
        (Mechanics::Coulomb, Box::new(ByLaw(RouthNewton))),
        (Mechanics::Grip, Box::new(ByLaw(Walton { restitution: half }))),
        (Mechanics::Energetic, Box::new(ByLaw(Stronge1990))),
    ];
    let counted = found.iter().map(|(mechanics, resolver)| (*mechanics, operations(&**resolver)));
    let counted: Vec<_> = counted.collect();
    let committed: Vec<_> = counted.iter().map(|(of, _)| (*of, of.operations())).collect();
    assert_eq!(counted, committed);
    for mechanics in Mechanics::ALL {
        let is_counted = counted.iter().any(|(of, _)| *of == mechanics);
        assert_eq!(mechanics.is_counted(), is_counted, "{mechanics:?}");
    }
}
