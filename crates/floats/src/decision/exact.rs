//! A comparison as a straight line of exact operations: sums, products and signs of numbers that are integers
//! times powers of two. Quotients are kept as two numbers, and a root √c as an element of a tower: every number
//! is a + b·√c with a and b of lower roots, so that its sign follows from those of a, b and a² − b²·c.

use std::collections::HashMap;

use kane_kernel::Rel;
use kane_number::{Integer, Rational};

use super::compared::Decision;
use crate::{Core, Operation, Test};

/// Steps of a comparison, and roots in it, beyond which none is written.
const MOST_STEPS: usize = 3_000;
const MOST_ROOTS: usize = 4;

/// A step; operands are earlier steps.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) enum Step {
    /// an input of the formula, a number
    Input(usize),
    /// a number
    Integer(Integer),
    /// a + b
    Sum(usize, usize),
    /// a − b
    Difference(usize, usize),
    /// a·b
    Product(usize, usize),
    /// the first number where a truth holds, otherwise the second
    Pick(usize, usize, usize),
    /// the sign of a number: −1, 0 or 1
    Sign(usize),
    /// the product of two signs
    Signs(usize, usize),
    /// the sign of a + b·√c from those of a, b and a² − b²·c
    RootSign(usize, usize, usize),
    /// whether a sign compares so with 0, a truth
    Holds(Rel, usize),
    /// whether all of these truths hold
    All(Vec<usize>),
    /// whether one of them does
    Any(Vec<usize>),
    /// the opposite of a truth
    Not(usize),
}

/// An element of the tower.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Element {
    Zero,
    /// a step
    Number(usize),
    /// a + b·√c for the root of this index, a and b of lower ones
    Root(usize, Box<Element>, Box<Element>),
}

/// A quotient; without a divisor it is over 1.
#[derive(Clone, Debug)]
struct Quotient {
    over: Element,
    under: Option<Element>,
}

/// The steps of a comparison; the last one is its truth.
#[derive(Debug, Default)]
pub(super) struct Steps {
    pub(super) steps: Vec<Step>,
    known: HashMap<Step, usize>,
    /// the radicands, by index
    roots: Vec<Element>,
}

impl Decision {
    /// Whether exact arithmetic can be written for it: no more than four roots, and not too many steps.
    #[must_use]
    pub fn is_certifiable(&self, core: &Core) -> bool {
        Steps::of(core, self).is_some()
    }
}

impl Steps {
    /// The comparison in steps; `None` if that takes too many, or too many roots.
    pub(super) fn of(core: &Core, decision: &Decision) -> Option<Self> {
        let mut all = Self::default();
        let mut values: Vec<Option<Quotient>> = Vec::new();
        let (a, b) = decision.operands;
        let needed = core.program.needed_by(&[a, b]);
        for (index, operation) in core.program.operations().iter().enumerate() {
            let used = needed.get(index) == Some(&true);
            let value = if used { Some(all.operation(operation, &values)?) } else { None };
            values.push(value);
        }
        let truth =
            all.compared(decision.rel, values.get(a)?.as_ref()?, values.get(b)?.as_ref()?)?;
        // the truth comes last, as what is not needed after it is not made
        (truth + 1 == all.steps.len()).then_some(all)
    }

    fn push(&mut self, step: Step) -> Option<usize> {
        // a truth that was found before is said again, so that it is the last
        if let Some(known) = self.known.get(&step).filter(|_| !matches!(step, Step::Holds(..))) {
            return Some(*known);
        }
        let next = self.steps.len();
        self.known.insert(step.clone(), next);
        self.steps.push(step);
        (next < MOST_STEPS).then_some(next)
    }

    fn operation(
        &mut self,
        operation: &Operation,
        values: &[Option<Quotient>],
    ) -> Option<Quotient> {
        let at = |index: usize| values.get(index)?.clone();
        let whole = |over: Element| Quotient { over, under: None };
        Some(match *operation {
            Operation::Number(ref number) => self.rational(number)?,
            Operation::Input(input) => whole(Element::Number(self.push(Step::Input(input))?)),
            Operation::Neg(a) => self.opposite(at(a)?)?,
            Operation::Add(a, b) => self.sum(&at(a)?, &at(b)?, false)?,
            Operation::Sub(a, b) => self.sum(&at(a)?, &at(b)?, true)?,
            Operation::Mul(a, b) => self.times(&at(a)?, &at(b)?)?,
            Operation::Fma(a, b, c) => {
                let product = self.times(&at(a)?, &at(b)?)?;
                self.sum(&product, &at(c)?, false)?
            }
            Operation::Div(a, b) => {
                let b = at(b)?;
                let turned = match b.under {
                    Some(under) => Quotient { over: under, under: Some(b.over) },
                    None => Quotient { over: self.one()?, under: Some(b.over) },
                };
                self.times(&at(a)?, &turned)?
            }
            Operation::Sqrt(a) => self.root(at(a)?)?,
            Operation::Abs(a) => {
                let a = at(a)?;
                let negative = self.is_negative(&a)?;
                let opposite = self.opposite(a.clone())?;
                self.pick(negative, &opposite, &a)?
            }
            Operation::Min(a, b) | Operation::Max(a, b) => {
                let (a, b) = (at(a)?, at(b)?);
                let difference = self.sum(&a, &b, true)?;
                let less = self.is_negative(&difference)?;
                let (first, second) =
                    if matches!(operation, Operation::Min(..)) { (a, b) } else { (b, a) };
                self.pick(less, &first, &second)?
            }
            Operation::If(ref test, a, b) => {
                let truth = self.test(test, values)?;
                self.pick(truth, &at(a)?, &at(b)?)?
            }
        })
    }

    fn one(&mut self) -> Option<Element> {
        Some(Element::Number(self.push(Step::Integer(1.into()))?))
    }

    fn rational(&mut self, number: &Rational) -> Option<Quotient> {
        let over = if *number.numer() == Integer::ZERO {
            Element::Zero
        } else {
            Element::Number(self.push(Step::Integer(number.numer().clone()))?)
        };
        let under = match number.is_integer() {
            true => None,
            false => Some(Element::Number(self.push(Step::Integer(number.denom().clone()))?)),
        };
        Some(Quotient { over, under })
    }

    fn opposite(&mut self, a: Quotient) -> Option<Quotient> {
        Some(Quotient { over: self.negative(&a.over)?, ..a })
    }

    fn negative(&mut self, a: &Element) -> Option<Element> {
        self.add(&Element::Zero, a, true)
    }

    /// a ± b.
    fn sum(&mut self, a: &Quotient, b: &Quotient, minus: bool) -> Option<Quotient> {
        if a.under == b.under {
            return Some(Quotient {
                over: self.add(&a.over, &b.over, minus)?,
                under: a.under.clone(),
            });
        }
        let left = self.scaled(&a.over, b.under.as_ref())?;
        let right = self.scaled(&b.over, a.under.as_ref())?;
        let under = self.both(a.under.as_ref(), b.under.as_ref())?;
        Some(Quotient { over: self.add(&left, &right, minus)?, under })
    }

    fn times(&mut self, a: &Quotient, b: &Quotient) -> Option<Quotient> {
        let over = self.multiply(&a.over, &b.over)?;
        Some(Quotient { over, under: self.both(a.under.as_ref(), b.under.as_ref())? })
    }

    fn scaled(&mut self, a: &Element, by: Option<&Element>) -> Option<Element> {
        by.map_or_else(|| Some(a.clone()), |by| self.multiply(a, by))
    }

    /// The product of two divisors, `None` inside for 1.
    fn both(&mut self, a: Option<&Element>, b: Option<&Element>) -> Option<Option<Element>> {
        Some(match (a, b) {
            (None, None) => None,
            (Some(one), None) | (None, Some(one)) => Some(one.clone()),
            (Some(a), Some(b)) => Some(self.multiply(a, b)?),
        })
    }

    /// √(p/q) = √(p·q)/|q|.
    fn root(&mut self, a: Quotient) -> Option<Quotient> {
        let radicand = self.scaled(&a.over, a.under.as_ref())?;
        if radicand == Element::Zero {
            return Some(Quotient { over: Element::Zero, under: None });
        }
        let under = match a.under {
            None => None,
            Some(under) => {
                let sign = self.sign(&under)?;
                let negative = self.push_truth(Rel::Lt, sign)?;
                let opposite = self.negative(&under)?;
                Some(self.choose(negative, &opposite, &under)?)
            }
        };
        let known = self.roots.iter().position(|known| *known == radicand);
        let index = known.unwrap_or(self.roots.len());
        if known.is_none() {
            if index >= MOST_ROOTS {
                return None;
            }
            self.roots.push(radicand);
        }
        let one = self.one()?;
        let over = Element::Root(index, Box::new(Element::Zero), Box::new(one));
        Some(Quotient { over, under })
    }

    /// Parts of an element by a root: a and b of a + b·√c.
    fn parts(of: &Element, index: usize) -> (Element, Element) {
        match of {
            Element::Root(own, a, b) if *own == index => ((**a).clone(), (**b).clone()),
            lower => (lower.clone(), Element::Zero),
        }
    }

    /// The highest root in an element.
    fn top(of: &Element) -> Option<usize> {
        match of {
            Element::Root(index, ..) => Some(*index),
            _ => None,
        }
    }

    fn made(index: usize, a: Element, b: Element) -> Element {
        match b {
            Element::Zero => a,
            b => Element::Root(index, Box::new(a), Box::new(b)),
        }
    }

    /// a ± b.
    fn add(&mut self, a: &Element, b: &Element, minus: bool) -> Option<Element> {
        match (a, b) {
            (a, Element::Zero) => return Some(a.clone()),
            (Element::Zero, b) if !minus => return Some(b.clone()),
            (Element::Number(a), Element::Number(b)) => {
                let step = if minus { Step::Difference(*a, *b) } else { Step::Sum(*a, *b) };
                return Some(Element::Number(self.push(step)?));
            }
            (Element::Zero, Element::Number(b)) => {
                let zero = self.push(Step::Integer(Integer::ZERO))?;
                return Some(Element::Number(self.push(Step::Difference(zero, *b))?));
            }
            _ => {}
        }
        let index = Self::top(a).max(Self::top(b))?;
        let ((a0, a1), (b0, b1)) = (Self::parts(a, index), Self::parts(b, index));
        let (first, second) = (self.add(&a0, &b0, minus)?, self.add(&a1, &b1, minus)?);
        Some(Self::made(index, first, second))
    }

    fn multiply(&mut self, a: &Element, b: &Element) -> Option<Element> {
        match (a, b) {
            (Element::Zero, _) | (_, Element::Zero) => return Some(Element::Zero),
            (Element::Number(a), Element::Number(b)) => {
                let one = Step::Integer(1.into());
                let is_one = |step: usize| self.steps.get(step) == Some(&one);
                if is_one(*a) {
                    return Some(Element::Number(*b));
                }
                if is_one(*b) {
                    return Some(Element::Number(*a));
                }
                return Some(Element::Number(self.push(Step::Product(*a, *b))?));
            }
            _ => {}
        }
        let index = Self::top(a).max(Self::top(b))?;
        let ((a0, a1), (b0, b1)) = (Self::parts(a, index), Self::parts(b, index));
        // (a0 + a1·√c)·(b0 + b1·√c) = a0·b0 + a1·b1·c + (a0·b1 + a1·b0)·√c
        let radicand = self.roots.get(index)?.clone();
        let squares = self.multiply(&a1, &b1)?;
        let squares = self.multiply(&squares, &radicand)?;
        let lower = self.multiply(&a0, &b0)?;
        let lower = self.add(&lower, &squares, false)?;
        let (left, right) = (self.multiply(&a0, &b1)?, self.multiply(&a1, &b0)?);
        let upper = self.add(&left, &right, false)?;
        Some(Self::made(index, lower, upper))
    }

    /// The sign of an element, a step.
    fn sign(&mut self, of: &Element) -> Option<usize> {
        match of {
            Element::Zero => {
                let zero = self.push(Step::Integer(Integer::ZERO))?;
                self.push(Step::Sign(zero))
            }
            Element::Number(step) => self.push(Step::Sign(*step)),
            Element::Root(index, a, b) => {
                let radicand = self.roots.get(*index)?.clone();
                let (first, second) = (self.sign(a)?, self.sign(b)?);
                let (a2, b2) = (self.multiply(a, a)?, self.multiply(b, b)?);
                let b2c = self.multiply(&b2, &radicand)?;
                let norm = self.add(&a2, &b2c, true)?;
                let norm = self.sign(&norm)?;
                self.push(Step::RootSign(first, second, norm))
            }
        }
    }

    /// The sign of a quotient, a step.
    fn sign_of(&mut self, of: &Quotient) -> Option<usize> {
        let over = self.sign(&of.over)?;
        match &of.under {
            None => Some(over),
            Some(under) => {
                let under = self.sign(under)?;
                self.push(Step::Signs(over, under))
            }
        }
    }

    fn push_truth(&mut self, rel: Rel, sign: usize) -> Option<usize> {
        self.push(Step::Holds(rel, sign))
    }

    fn is_negative(&mut self, of: &Quotient) -> Option<usize> {
        let sign = self.sign_of(of)?;
        self.push_truth(Rel::Lt, sign)
    }

    /// Whether a comparison holds, a step.
    fn compared(&mut self, rel: Rel, a: &Quotient, b: &Quotient) -> Option<usize> {
        let difference = self.sum(a, b, true)?;
        let sign = self.sign_of(&difference)?;
        self.push_truth(rel, sign)
    }

    fn test(&mut self, test: &Test, values: &[Option<Quotient>]) -> Option<usize> {
        match test {
            Test::Compare(rel, a, b) => {
                let (a, b) = (values.get(*a)?.clone()?, values.get(*b)?.clone()?);
                self.compared(*rel, &a, &b)
            }
            Test::All(tests) | Test::Any(tests) => {
                let truths: Option<Vec<usize>> =
                    tests.iter().map(|test| self.test(test, values)).collect();
                let truths = truths?;
                self.push(if matches!(test, Test::All(_)) {
                    Step::All(truths)
                } else {
                    Step::Any(truths)
                })
            }
            Test::Not(test) => {
                let truth = self.test(test, values)?;
                self.push(Step::Not(truth))
            }
        }
    }

    fn pick(&mut self, truth: usize, a: &Quotient, b: &Quotient) -> Option<Quotient> {
        let over = self.choose(truth, &a.over, &b.over)?;
        let under = match (&a.under, &b.under) {
            (None, None) => None,
            (a, b) => {
                let one = self.one()?;
                let (a, b) = (a.as_ref().unwrap_or(&one), b.as_ref().unwrap_or(&one));
                Some(self.choose(truth, a, b)?)
            }
        };
        Some(Quotient { over, under })
    }

    /// One of two elements, by a truth.
    fn choose(&mut self, truth: usize, a: &Element, b: &Element) -> Option<Element> {
        if a == b {
            return Some(a.clone());
        }
        if let Some(index) = Self::top(a).max(Self::top(b)) {
            let ((a0, a1), (b0, b1)) = (Self::parts(a, index), Self::parts(b, index));
            let (lower, upper) = (self.choose(truth, &a0, &b0)?, self.choose(truth, &a1, &b1)?);
            return Some(Self::made(index, lower, upper));
        }
        let zero = self.push(Step::Integer(Integer::ZERO))?;
        let step = |element: &Element| match element {
            Element::Number(step) => *step,
            _ => zero,
        };
        Some(Element::Number(self.push(Step::Pick(truth, step(a), step(b)))?))
    }
}
