//! Germs: how near a limit one has to be for all givens to be able to hold.

use std::cell::RefCell;

use kane_kernel::{Atom, Germ, Inside, Poly, Sentence, Side, Sign, State, owed};
use num_bigint::BigInt;
use num_traits::One;

use super::ranges::{self, Values};
use super::search::{Outcome, Search};
use crate::argument::expand;

/// Radii to try, for constants c around and a polynomial D in them that must not vanish.
#[derive(Clone, Debug)]
enum Radius {
    /// 1/2ᵏ
    Fixed(u32),
    /// 1/(2ᵏ·(1 + Σc²))
    Constants(u32),
    /// D, where it is known to be positive
    Known(Poly),
    /// D²/((1 + D²)·2·(1 + Σc²))
    Lead(Poly),
    /// a quotient as it is
    Given(Poly, Poly),
}

const RADII: [Radius; 6] = [
    Radius::Fixed(0),
    Radius::Constants(1),
    Radius::Fixed(3),
    Radius::Fixed(7),
    Radius::Constants(7),
    Radius::Fixed(20),
];

/// The smallest of them: functions that do not serve there serve at none.
const SMALLEST: [Radius; 2] = [Radius::Fixed(20), Radius::Constants(7)];

impl Radius {
    /// Numerator and denominator; `None` if it is none of its own.
    fn fraction(&self, state: &State<'_, '_>, x: usize) -> Option<(Poly, Poly)> {
        let power = |k: u32| BigInt::one() << k;
        let mut size = Poly::one();
        for &v in &state.scope.mentioned {
            if state.is_constant(v, x) {
                size = size.add(&Poly::term(vec![(v, 2)], BigInt::one()));
            }
        }
        match self {
            Self::Fixed(k) => Some((Poly::one(), Poly::constant(power(*k)))),
            Self::Constants(k) => {
                (size != Poly::one()).then(|| (Poly::one(), size.scale(&power(*k))))
            }
            Self::Known(d) => Some((d.clone(), Poly::one())),
            Self::Lead(d) => {
                let fuel = &state.scope.fuel;
                let square = d.mul(d, fuel).ok()?;
                let den = square.add(&Poly::one()).mul(&size, fuel).ok()?.scale(&power(1));
                Some((square, den))
            }
            Self::Given(num, den) => Some((num.clone(), den.clone())),
        }
    }
}

/// Functions with which givens held near a limit, for another look at the same limit: they are tried first.
#[derive(Default)]
pub(crate) struct Memory(RefCell<Vec<(Side, Sentence, Values)>>);

impl Memory {
    fn of(&self, side: &Side, given: &Sentence) -> Option<Values> {
        let known = self.0.borrow();
        known.iter().find(|k| k.0 == *side && k.1 == *given).map(|k| k.2.clone())
    }

    /// Takes values in the place of those that no longer served.
    fn keep(&self, side: &Side, given: &Sentence, values: Values) {
        let mut known = self.0.borrow_mut();
        known.retain(|k| k.0 != *side || k.1 != *given);
        known.push((side.clone(), given.clone(), values));
    }
}

/// What is known of functions with which a given holds near a limit.
#[derive(Clone)]
enum Known {
    Untried,
    Values(Values),
    Nothing,
}

/// The germs on one side of a limit.
pub(super) struct Germs<'a, 's, 'g> {
    state: &'a State<'s, 'g>,
    side: &'a Side,
    power: u32,
    steps: u64,
    owed: Vec<&'g Sentence>,
    known: RefCell<Vec<Known>>,
    memory: Option<&'a Memory>,
}

impl<'a, 's, 'g> Germs<'a, 's, 'g> {
    pub(super) fn new(state: &'a State<'s, 'g>, side: &'a Side, steps: u64) -> Self {
        let owed = owed(state, side);
        let known = RefCell::new(vec![Known::Untried; owed.len()]);
        Self { state, side, power: 1, steps, owed, known, memory: None }
    }

    /// The same, with what earlier looks have found.
    pub(super) fn remembering(self, memory: &'a Memory) -> Self {
        Self { memory: Some(memory), ..self }
    }

    /// The same along a power of t.
    pub(super) fn along(self, power: u32) -> Self {
        Self { power, ..self }
    }

    /// Germs inside the ranges of all givens: of simple radii first, then of those that shrink with
    /// what must not vanish near the limit.
    pub(super) fn all(&self) -> impl Iterator<Item = Germ> {
        let simple = RADII.iter().filter_map(|radius| self.simple(radius));
        simple.chain(std::iter::once(()).flat_map(|()| self.shrinking()))
    }

    /// A germ of a radius, without the proof that it lies in any range.
    fn around(&self, radius: &Radius) -> Option<Germ> {
        let Self { state, side, power, steps, .. } = self;
        let (num, den) = radius.fraction(state, side.var)?;
        let any = |_: usize, _: &Poly| true;
        let not = |p: &Poly| vec![Atom::new(p.clone(), Sign::Positive).not()];
        let state = state.with_cases(vec![not(&num), not(&den)]);
        let Outcome::Closed(argument) = Search::new(*steps, &any, false).solve(&state) else {
            return None;
        };
        let positive = Box::new(expand(&state, &argument).ok()?);
        let (side, radius) = ((*side).clone(), (num, den));
        Some(Germ { side, power: *power, radius, positive, inside: Vec::new() })
    }

    fn simple(&self, radius: &Radius) -> Option<Germ> {
        if self.known.borrow().iter().any(|known| matches!(known, Known::Nothing)) {
            return None;
        }
        self.inside(self.around(radius)?, &|i, germ| {
            let known = self.known.borrow()[i].clone();
            match known {
                Known::Values(values) => ranges::proved(self.state, germ, self.owed[i], values),
                Known::Nothing => None,
                Known::Untried => {
                    let found = self.remembered(self.owed[i], germ).or_else(|| {
                        let found = ranges::inside(self.state, germ, self.owed[i])?;
                        if let Some(memory) = self.memory {
                            memory.keep(self.side, self.owed[i], found.values.clone());
                        }
                        Some(found)
                    });
                    let values = found.as_ref().map(|found| found.values.clone());
                    let values = values.or_else(|| self.smallest(self.owed[i]));
                    let known = values.map_or(Known::Nothing, Known::Values);
                    self.known.borrow_mut()[i] = known;
                    found
                }
            }
        })
    }

    /// A proof that a given holds with the functions of an earlier look.
    fn remembered(&self, given: &Sentence, germ: &Germ) -> Option<Inside> {
        let values = self.memory?.of(self.side, given)?;
        ranges::proved(self.state, germ, given, values)
    }

    /// Functions with which a given holds near enough.
    fn smallest(&self, given: &Sentence) -> Option<Values> {
        let found = |radius: &Radius| {
            let germ = self.around(radius)?;
            ranges::inside(self.state, &germ, given).map(|found| found.values)
        };
        SMALLEST.iter().find_map(found)
    }

    fn shrinking(&self) -> impl Iterator<Item = Germ> {
        let known =
            |lead: &Poly| self.state.atoms.contains(&Atom::new(lead.clone(), Sign::Positive));
        let radii = self.leads().into_iter().flat_map(move |lead| {
            let signs = [lead.clone(), lead.neg()].into_iter().filter(known);
            signs.map(Radius::Known).chain([Radius::Lead(lead)]).collect::<Vec<_>>()
        });
        radii.filter_map(|radius| self.germ(&radius))
    }

    /// A germ whose radius shrinks with a polynomial in constants.
    pub(super) fn with_lead(&self, lead: Poly) -> Option<Germ> {
        self.germ(&Radius::Lead(lead))
    }

    /// A germ of this radius.
    pub(super) fn within(&self, (num, den): (Poly, Poly)) -> Option<Germ> {
        self.germ(&Radius::Given(num, den))
    }

    fn germ(&self, radius: &Radius) -> Option<Germ> {
        let around = self.around(radius)?;
        self.inside(around, &|i, germ| ranges::inside(self.state, germ, self.owed[i]))
    }

    fn inside(
        &self,
        mut germ: Germ,
        prove: &dyn Fn(usize, &Germ) -> Option<Inside>,
    ) -> Option<Germ> {
        for i in 0..self.owed.len() {
            let inside = prove(i, &germ)?;
            germ.inside.push(inside);
        }
        Some(germ)
    }

    /// Polynomials in constants that decide, by being zero or not, whether the givens can hold near
    /// the limit.
    pub(super) fn leads(&self) -> Vec<Poly> {
        let mut out: Vec<Poly> = Vec::new();
        let Some(germ) = self.around(&RADII[0]) else {
            return out;
        };
        for given in &self.owed {
            for lead in ranges::leads(self.state, &germ, given) {
                let known = out.contains(&lead) || out.contains(&lead.neg());
                if !lead.is_constant() && !known {
                    out.push(lead);
                }
            }
        }
        out
    }

    /// A given that was not shown to hold near the limit, if there is one.
    pub(super) fn unreached(&self) -> Option<&'g Sentence> {
        let fails = |given: &&Sentence| self.smallest(given).is_none();
        self.owed.iter().copied().find(fails)
    }
}
