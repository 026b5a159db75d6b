//! Symbols that are angles: what stands for them, and what holds of it.
//!
//! An angle brings a `given` along: the point
//! (cos, sin) of its part lies on the unit circle, and in the range that is declared. Whoever speaks of
//! the point rests on that `given`.

use std::collections::{BTreeMap, BTreeSet};

use kane_algebra::syntax::{Angle, Turn};
use kane_kernel::{Bound, Expr, Link, Rel, Relation, Sentence, Var};
use num_rational::BigRational;
use num_traits::{One, Signed as _, Zero};

use super::citation::{Draft, DraftBody};
use super::symbol::Item;
use super::{Fault, Reader};
use crate::Parts;

impl Reader {
    /// Enters an angle, and what holds of it.
    pub(super) fn declare_angle(&mut self, item: Item, of: Option<usize>, parts: u32) {
        let (alone, limited) =
            (self.wanted.is_alone(&item.name), self.wanted.is_limited(&item.name));
        // where the range ends at 0 the number does
        let [lower, upper] = item.range_in_turns().map(|end| {
            end.filter(|(end, _)| alone && end.is_zero())
                .map(|(value, strict)| Bound { value, strict })
        });
        let var = Var { name: item.name.clone(), of, lower, upper };
        let angle = match self.scope.declare_angle(var, parts, limited) {
            Ok((angle, _)) => angle,
            Err(error) => return self.refuse(&error, item.span),
        };
        if alone {
            self.scope.declare_measured(angle);
        }
        if limited {
            self.scope.declare_limited(angle);
        }
        self.declare_rates(angle, &item.name, item.span.clone());
        let links = match self.circle(angle, &item) {
            Ok(relations) => relations.into_iter().map(Link::Relation).collect(),
            Err(message) => {
                let mut fault = Fault::new(item.whole, message);
                if fault.message.contains("half a turn") {
                    let note = "a half turn at most, or a whole one; a `given` can say the rest";
                    fault.note = Some(note.to_owned());
                }
                self.faults.push(fault);
                return;
            }
        };
        let body = DraftBody::Given(Sentence { when: Vec::new(), links });
        let parts =
            Parts { label: item.span.clone(), content: item.whole.clone(), ..Parts::default() };
        let label = format!("(angle {})", item.name);
        let (line, span) = (self.line, item.whole.clone());
        self.circles.insert(angle, self.drafts.len());
        self.enter(Draft { label, parts: parts.clone(), body, span, line });
        if alone && let Some(point) = self.scope.angle(angle) {
            let links = arc(angle, *point, &item.range_in_turns())
                .into_iter()
                .map(Link::Relation)
                .collect();
            let body = DraftBody::Given(Sentence { when: Vec::new(), links });
            let label = format!("(arc {})", item.name);
            self.arcs.insert(angle, self.drafts.len());
            self.enter(Draft { label, parts, body, span: item.whole, line });
        }
    }

    /// cos² + sin² = 1, and that the point lies on the arc that is declared.
    fn circle(&self, symbol: usize, item: &Item) -> Result<Vec<Relation>, String> {
        let angle = self.scope.angle(symbol).ok_or("no angle")?;
        let square = |v| Expr::Pow(Expr::Var(v).into(), 2);
        let lhs = Expr::Add(square(angle.cos).into(), square(angle.sin).into());
        let mut relations = vec![Relation { lhs, rel: Rel::Eq, rhs: Expr::int(1) }];
        if item.ends.iter().any(Option::is_some) {
            return Err(format!("the bounds of the angle `{}` are multiples of `pi`", item.name));
        }
        let mut ends = item.turns.clone();
        for (end, bound) in ends.iter_mut().zip([&item.lower, &item.upper]) {
            match bound {
                Some(bound) if !bound.value.is_zero() => {
                    return Err(format!(
                        "the bounds of the angle `{}` are multiples of `pi`",
                        item.name
                    ));
                }
                Some(_) if end.is_some() => {
                    return Err(format!("`{}` is bounded twice on one side", item.name));
                }
                Some(bound) => *end = Some((BigRational::zero(), bound.strict)),
                None => {}
            }
        }
        let [Some((a, after)), Some((b, before))] = ends else { return Ok(relations) };
        let (one, two) = (BigRational::one(), BigRational::from_integer(2.into()));
        if a > b || (a == b && (after || before)) {
            return Err(format!("the domain of `{}` is empty", item.name));
        }
        let part = BigRational::new(1.into(), angle.parts.into());
        let width = (&b - &a) * &part;
        // the part beside one end, in the sense of the range
        let beside = |end: &BigRational, sense: i64| {
            let sense = BigRational::from_integer(sense.into());
            let angles = [(symbol, &part * &sense)].into();
            let half_turns = -end * &part * &sense;
            let turn = Turn { angles, half_turns, number: BigRational::zero() };
            turn.direction(&self.scope).map_err(|kind| kind.to_string())
        };
        let (start, end) = (beside(&a, 1)?, beside(&b, -1)?);
        if width.is_zero() {
            relations.push(Relation { lhs: start.cos, rel: Rel::Eq, rhs: Expr::int(1) });
            return Ok(relations);
        }
        let apart = |cos: Expr| Relation { lhs: cos, rel: Rel::Ne, rhs: Expr::int(1) };
        if width >= two {
            // all directions, but for the one where both ends meet if neither belongs to it
            if width == two && after && before {
                relations.push(apart(start.cos));
            }
            return Ok(relations);
        }
        if width > one {
            return Err(format!(
                "`{}` ranges over more than half a turn and less than a whole one",
                item.name
            ));
        }
        // Only at the ends of half a turn does the sine vanish at both at once.
        let both = width < one || (after && before);
        let side = |sin, strict| {
            let rel = if strict && both { Rel::Gt } else { Rel::Ge };
            Relation { lhs: sin, rel, rhs: Expr::int(0) }
        };
        for (at, strict) in [(start, after), (end, before)] {
            relations.push(side(at.sin, strict));
            if strict && !both {
                relations.push(apart(at.cos));
            }
        }
        Ok(relations)
    }

    /// By statement, what is tied to the meaning of exponentials, logarithms and angles by it.
    pub(super) fn stands_for(&self) -> BTreeMap<usize, Vec<usize>> {
        let of_angle = |(theta, given): (&usize, &usize)| {
            let angle = self.scope.angle(*theta)?;
            Some((*given, vec![*theta, angle.cos, angle.sin]))
        };
        let angles = self.circles.iter().chain(&self.arcs).filter_map(of_angle);
        let others = self.exponentials.iter().map(|(symbol, given)| (*given, vec![*symbol]));
        angles.chain(others).collect()
    }

    /// The `given`s of the angles that are among these symbols by themselves, and by their points, or have
    /// a range.
    pub(super) fn arcs_of(&self, symbols: &BTreeSet<usize>) -> BTreeSet<usize> {
        let spoken = |(theta, given): (&usize, &usize)| {
            let angle = self.scope.angle(*theta)?;
            let by_point = symbols.contains(&angle.cos) || symbols.contains(&angle.sin);
            let ranged = || {
                let draft = self.drafts.get(*given)?;
                let DraftBody::Given(sentence) = &draft.body else { return None };
                (sentence.links.len() > TAYLOR).then_some(())
            };
            let is_spoken = symbols.contains(theta) && (by_point || ranged().is_some());
            is_spoken.then_some(*given)
        };
        self.arcs.iter().filter_map(spoken).collect()
    }

    /// The `given`s of the angles whose points are among these symbols, in the order of the text.
    pub(super) fn circles_of(&self, symbols: &BTreeSet<usize>) -> BTreeSet<usize> {
        let spoken = |(symbol, given): (&usize, &usize)| {
            let angle = self.scope.angle(*symbol)?;
            let is_spoken = symbols.contains(&angle.cos) || symbols.contains(&angle.sin);
            is_spoken.then_some(*given)
        };
        self.circles.iter().filter_map(spoken).collect()
    }
}

/// Relations of an arc that hold whatever its range is.
const TAYLOR: usize = 4;

/// What cosine and sine of a part u are beside u itself: u² − u⁴/6 ≤ u·sin u ≤ u² and
/// 1 − u²/2 ≤ cos u ≤ 1 − u²/2 + u⁴/24 for all real u; and that the angle lies between the ends of its
/// range, with 333/106 < π < 355/113.
fn arc(theta: usize, point: Angle, ends: &[Option<(BigRational, bool)>; 2]) -> Vec<Relation> {
    let number = |n: i64, d: i64| Expr::Num(BigRational::new(n.into(), d.into()));
    let u = || match point.parts {
        1 => Expr::Var(theta),
        n => Expr::Div(Expr::Var(theta).into(), Expr::int(n.into()).into()),
    };
    let power = |n: i32| Expr::Pow(u().into(), n);
    let over = |a: Expr, n: i64| Expr::Div(a.into(), Expr::int(n).into());
    let minus = |a: Expr, b: Expr| Expr::Sub(a.into(), b.into());
    let below = || minus(Expr::int(1), over(power(2), 2));
    let (cos, sin) = (Expr::Var(point.cos), || Expr::Mul(u().into(), Expr::Var(point.sin).into()));
    let relation = |lhs, rel, rhs| Relation { lhs, rel, rhs };
    let mut relations = vec![
        relation(sin(), Rel::Ge, minus(power(2), over(power(4), 6))),
        relation(sin(), Rel::Le, power(2)),
        relation(cos.clone(), Rel::Ge, below()),
        relation(cos, Rel::Le, Expr::Add(below().into(), over(power(4), 24).into())),
    ];
    for (end, rel) in ends.iter().zip([Rel::Gt, Rel::Lt]) {
        let Some((turns, _)) = end.as_ref().filter(|(turns, _)| !turns.is_zero()) else { continue };
        // outwards
        let pi = match (rel == Rel::Gt) == turns.is_positive() {
            true => number(333, 106),
            false => number(355, 113),
        };
        let at = Expr::Mul(Expr::Num(turns.clone()).into(), pi.into());
        relations.push(relation(Expr::Var(theta), rel, at));
    }
    relations
}
