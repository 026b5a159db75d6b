//! Derivatives of functions in a model: whether a point can be one of functions for which the premises
//! hold for all t.
//!
//! A point gives values to functions and to their derivatives, and nothing in it ties the one to the
//! other. The premises hold for all t, so a point refutes only if functions pass through it for which
//! they do, on an interval around it. Here they do if the equations can be solved, one after the other,
//! each for the highest derivative of a function of its own: then the theorem of Picard and Lindelöf gives
//! the functions. What cannot be seen so is left open.

use std::collections::{BTreeMap, BTreeSet};

use kane_algebra::rational_function::RationalFunction;
use kane_algebra::syntax::{Angle, Exponential};
use kane_kernel::{
    Approach, Bound, Context, Evidence, Expr, Fuel, Goal, Hypothesis, Limit, Link, Model, Point,
    Poly, Rel, Relation, Sentence, Side, expressions,
};
use num_rational::BigRational;
use num_traits::Zero as _;

/// Steps that one differentiation of a polynomial may take.
const FUEL: u64 = 1_000_000;

/// What a document says of derivatives of functions.
#[derive(Clone, Debug, Default)]
pub(crate) struct Motion {
    /// by function, the symbol for its derivative
    pub(crate) rates: BTreeMap<usize, usize>,
    /// angles, and what stands for them
    pub(crate) angles: Vec<(usize, Angle)>,
    /// angles that stand by themselves, too
    pub(crate) measured: Vec<(usize, Angle)>,
    /// what stands for exponentials and logarithms
    pub(crate) exponentials: Vec<Exponential>,
    /// by statement, what a given about an exponential, a logarithm or an angle speaks of that nothing else has to
    pub(crate) stands_for: BTreeMap<usize, Vec<usize>>,
    /// by statement, of which statement it is the derivative
    pub(crate) derived: BTreeMap<usize, usize>,
    /// givens that may hold nowhere near a limit, with the variables of such limits
    pub(crate) undetermined: BTreeMap<usize, BTreeSet<usize>>,
}

/// A function, differentiated so often.
type Jet = (usize, usize);

/// An equation and its derivatives, as polynomials that vanish.
type Unit = Vec<Poly>;

impl Motion {
    /// Whether the goal speaks of derivatives of functions, of exponentials, or of angles themselves.
    pub(crate) fn concerns(&self, goal: &Goal) -> bool {
        self.concerns_rates(goal) || self.concerns_exponentials(goal) || self.concerns_arcs(goal)
    }

    /// A given, of those on which a goal rests, that may hold nowhere near a limit of which the goal speaks, and a
    /// side of that limit.
    pub(crate) fn unheld(&self, goal: &Goal, ids: &[usize]) -> Option<(Side, usize)> {
        let cited = goal.hypotheses.iter().flat_map(|h| &h.sentence.links);
        let limit = |link: &'_ Link| match link {
            Link::Limit(limit) => Some(limit.clone()),
            Link::Relation(_) => None,
        };
        let limits: Vec<Limit> = cited.chain(goal.conclusion.links()).filter_map(limit).collect();
        let along = |i: usize| {
            let variables = self.undetermined.get(&i)?;
            let limit = limits.iter().find(|limit| variables.contains(&limit.var))?;
            let (at, above) = match &limit.at {
                Approach::To(a) | Approach::Above(a) => (Some(a), true),
                Approach::Below(a) => (Some(a), false),
                Approach::PlusInf => (None, true),
                Approach::MinusInf => (None, false),
            };
            Some((Side { var: limit.var, at: at.cloned(), above }, i))
        };
        ids.iter().find_map(|i| along(*i))
    }

    /// Whether the goal speaks of an angle by itself and by its point.
    pub(crate) fn concerns_arcs(&self, goal: &Goal) -> bool {
        !self.arcs(&mentioned(goal)).is_empty()
    }

    /// The angles among these symbols by themselves and by their points.
    fn arcs(&self, mentioned: &BTreeSet<usize>) -> Vec<(usize, Angle)> {
        let spoken = |(theta, point): &&(usize, Angle)| {
            mentioned.contains(theta)
                && (mentioned.contains(&point.cos) || mentioned.contains(&point.sin))
        };
        self.measured.iter().filter(spoken).copied().collect()
    }

    fn concerns_rates(&self, goal: &Goal) -> bool {
        let rates = &self.rates;
        !rates.is_empty() && mentioned(goal).iter().any(|v| rates.values().any(|rate| rate == v))
    }

    /// Whether the goal speaks of an exponential or a logarithm.
    pub(crate) fn concerns_exponentials(&self, goal: &Goal) -> bool {
        let known = &self.exponentials;
        !known.is_empty() && mentioned(goal).iter().any(|v| known.iter().any(|e| e.symbol == *v))
    }

    /// Whether exponentials, logarithms, cosines and sines have the values that a point gives them, for
    /// some values of what is in them: exp(0) is 1, log(1) is 0, cos(0) is 1, and where nothing else is said
    /// of u, exp(u) is any number that the bounds of its symbols allow.
    fn are_taken(&self, goal: &Goal, point: &Point) -> bool {
        let mentioned = mentioned(goal);
        let spoken: Vec<&Exponential> =
            self.exponentials.iter().filter(|e| mentioned.contains(&e.symbol)).collect();
        let is = |v: usize, n: i64| value(v, point) == Some(BigRational::from_integer(n.into()));
        let at = |e: &Exponential, n: i64| is(e.symbol, n);
        let spoken_of = |v: usize, n: i64| mentioned.contains(&v) && is(v, n);
        let straight = |(theta, a): (usize, Angle)| {
            let unless = |v: usize, n: i64| !mentioned.contains(&v) || is(v, n);
            is(theta, 0) && unless(a.cos, 1) && unless(a.sin, 0)
        };
        self.arcs(&mentioned).into_iter().all(straight)
            && spoken.iter().all(|e| {
                if e.of.symbols().any(|v| mentioned.contains(&v)) {
                    return match e.parts {
                        0 => e.of.symbols().all(|v| is(v, 1)) && at(e, 0),
                        // no symbol that divides is 0
                        _ => {
                            e.of.powers().iter().any(|(v, n)| *n > 0 && spoken_of(*v, 0))
                                && at(e, 1)
                        }
                    };
                }
                let apart = |other: &Exponential| !other.of.symbols().any(|v| e.of.contains(v));
                e.exact && spoken.iter().all(|other| other.symbol == e.symbol || apart(other))
            })
    }

    /// That what stands in the exponentials and sines of a goal is 0, and in its logarithms 1, with what they
    /// are there; nothing if they stand alone in it.
    pub(crate) fn pins(&self, goal: &Goal) -> Vec<Hypothesis> {
        if self.exponentials.is_empty() && self.measured.is_empty() {
            return Vec::new();
        }
        let mentioned = mentioned(goal);
        let spoken = self.exponentials.iter().filter(|e| {
            mentioned.contains(&e.symbol) && e.of.symbols().any(|v| mentioned.contains(&v))
        });
        let pin = |lhs: Expr, n: i64| {
            let equation = Relation { lhs, rel: Rel::Eq, rhs: Expr::int(n) };
            let sentence = Sentence { when: Vec::new(), links: vec![Link::Relation(equation)] };
            Hypothesis { sentence, given: true }
        };
        let both = |e: &Exponential| {
            let (inside, own) = if e.parts == 0 { (1, 0) } else { (0, 1) };
            [pin(e.of.expr(), inside), pin(Expr::Var(e.symbol), own)]
        };
        let straight = |(theta, a): (usize, Angle)| {
            [pin(Expr::Var(theta), 0), pin(Expr::Var(a.cos), 1), pin(Expr::Var(a.sin), 0)]
        };
        let arcs = self.arcs(&mentioned).into_iter().flat_map(straight);
        spoken.flat_map(both).chain(arcs).collect()
    }

    /// Whether functions pass through the model for which all premises hold nearby: `ids` are the
    /// statements that the hypotheses of the goal are. Everything that a hypothesis rests on has to be
    /// among them.
    pub(crate) fn is_met(&self, goal: &Goal, ids: &[usize], evidence: &Evidence) -> bool {
        let Evidence::Model(Model::Point(point)) = evidence else { return false };
        let moves = self.concerns_rates(goal);
        // an exponential is no function that equations could be solved for, nor is an angle beside its point
        !(moves && (self.concerns_exponentials(goal) || self.concerns_arcs(goal)))
            && self.are_taken(goal, point)
            && (!moves || self.passes(goal, ids, point).unwrap_or(false))
    }

    /// The function that a symbol is a derivative of, and of which order; cosine and sine are the angle.
    fn jet(&self, v: usize, context: &Context) -> Option<Jet> {
        context.vars.get(v)?.of?;
        let point = self.angles.iter().find(|(_, a)| [a.cos, a.sin].contains(&v));
        let (mut base, mut order) = (point.map_or(v, |(theta, _)| *theta), 0);
        while let Some((lower, _)) = self.rates.iter().find(|(_, rate)| **rate == base) {
            (base, order) = (*lower, order + 1);
        }
        Some((base, order))
    }

    fn passes(&self, goal: &Goal, ids: &[usize], point: &Point) -> Option<bool> {
        let context = &goal.context;
        let mentioned = mentioned(goal);
        let jets: BTreeSet<Jet> = mentioned.iter().filter_map(|v| self.jet(*v, context)).collect();
        for v in mentioned.iter().filter(|v| self.jet(**v, context).is_some()) {
            let var = context.vars.get(*v)?;
            let apart =
                |bound: &Bound| bound.strict || value(*v, point).is_some_and(|x| x != bound.value);
            if ![&var.lower, &var.upper].into_iter().flatten().all(apart) {
                return Some(false);
            }
        }
        let mut units: BTreeMap<usize, Vec<(usize, Poly)>> = BTreeMap::new();
        for (hypothesis, id) in goal.hypotheses.iter().zip(ids) {
            // what is cited and proved holds where the premises do that it rests on
            if !hypothesis.given {
                continue;
            }
            let sentence = &hypothesis.sentence;
            for link in &sentence.links {
                let Link::Relation(relation) = link else { return Some(false) };
                let symbols = symbols([&relation.lhs, &relation.rhs], context);
                let variables = variables(&symbols, context);
                if self.is_circle(relation) || variables.is_empty() {
                    continue;
                }
                // what holds for all values of two variables says more than an equation of motion
                if !sentence.when.is_empty() || variables.len() > 1 {
                    return Some(false);
                }
                let functions = symbols.iter().any(|v| self.jet(*v, context).is_some());
                let gap = Expr::Sub(relation.lhs.clone().into(), relation.rhs.clone().into());
                let gap = RationalFunction::from_expr(&gap, context).ok()?;
                match relation.rel {
                    Rel::Lt | Rel::Gt | Rel::Ne => {}
                    Rel::Le | Rel::Ge
                        if at(&gap.fraction().0, point).is_some_and(|v| !v.is_zero()) => {}
                    Rel::Eq if functions => {
                        let (base, order) = self.source(*id);
                        units.entry(base).or_default().push((order, gap.fraction().0));
                    }
                    _ => return Some(false),
                }
            }
        }
        let units: Option<Vec<Vec<Unit>>> = units.into_values().map(in_order).collect();
        self.solve(units?.concat(), &jets, context, point)
    }

    /// Whether units can be taken away one after the other, each solved for what no other one has.
    fn solve(
        &self,
        mut units: Vec<Unit>,
        jets: &BTreeSet<Jet>,
        context: &Context,
        point: &Point,
    ) -> Option<bool> {
        let top = |base: usize| jets.iter().filter(|jet| jet.0 == base).map(|jet| jet.1).max();
        while !units.is_empty() {
            let solved = units.iter().position(|unit| {
                let Some(first) = unit.first() else { return true };
                first.vars().into_iter().any(|u| {
                    let Some((base, order)) = self.jet(u, context) else { return false };
                    // an angle is solved for in no sine
                    let plain = !self.angles.iter().any(|(_, a)| [a.cos, a.sin].contains(&u));
                    let highest = top(base) == Some(order + unit.len() - 1);
                    let slope = first.derivative(u, &Fuel::new(FUEL)).ok();
                    let moves = slope.is_some_and(|s| at(&s, point).is_some_and(|v| !v.is_zero()));
                    let own = units.iter().filter(|other| *other != unit).flatten().all(|p| {
                        let jets = p.vars().into_iter().filter_map(|v| self.jet(v, context));
                        jets.into_iter().all(|jet| jet.0 != base || jet.1 < order)
                    });
                    plain && highest && moves && own
                })
            });
            match solved {
                Some(i) => _ = units.swap_remove(i),
                None => return Some(self.solve_together(&units, jets, context, point)),
            }
        }
        Some(true)
    }

    /// Whether equations can be solved together for as many highest derivatives: the slopes by these
    /// are independent rows. Equations that are cited with their derivatives are not.
    fn solve_together(
        &self,
        units: &[Unit],
        jets: &BTreeSet<Jet>,
        context: &Context,
        point: &Point,
    ) -> bool {
        let equations: Option<Vec<&Poly>> =
            units.iter().map(|unit| if let [one] = &unit[..] { Some(one) } else { None }).collect();
        let Some(equations) = equations else { return false };
        let is_highest = |u: &usize| {
            let plain = !self.angles.iter().any(|(_, a)| [a.cos, a.sin].contains(u));
            let jet = self.jet(*u, context).filter(|_| plain);
            jet.is_some_and(|(base, order)| !jets.iter().any(|j| j.0 == base && j.1 > order))
        };
        let found: BTreeSet<usize> = equations.iter().flat_map(|p| p.vars()).collect();
        let highest: Vec<usize> = found.into_iter().filter(is_highest).collect();
        let row = |p: &&Poly| -> Option<Vec<BigRational>> {
            highest.iter().map(|u| at(&p.derivative(*u, &Fuel::new(FUEL)).ok()?, point)).collect()
        };
        let rows: Option<Vec<_>> = equations.iter().map(row).collect();
        rows.is_some_and(are_independent)
    }

    /// The statement that a derived one comes from, and how often it is differentiated.
    fn source(&self, mut id: usize) -> (usize, usize) {
        let mut order = 0;
        while let Some(base) = self.derived.get(&id) {
            (id, order) = (*base, order + 1);
        }
        (id, order)
    }

    /// Whether it is cos² + sin² = 1 of an angle, which its functions satisfy by what they are.
    fn is_circle(&self, relation: &Relation) -> bool {
        let square = |v: usize| Expr::Pow(Expr::Var(v).into(), 2);
        relation.rel == Rel::Eq
            && relation.rhs == Expr::int(1)
            && self
                .angles
                .iter()
                .any(|(_, a)| relation.lhs == Expr::Add(square(a.cos).into(), square(a.sin).into()))
    }
}

/// Whether the rows of a matrix are linearly independent.
fn are_independent(mut rows: Vec<Vec<BigRational>>) -> bool {
    while let Some(first) = rows.pop() {
        let Some(pivot) = first.iter().position(|x| !x.is_zero()) else { return false };
        for row in &mut rows {
            let factor = &row[pivot] / &first[pivot];
            for (x, y) in row.iter_mut().zip(&first) {
                *x -= &factor * y;
            }
        }
    }
    true
}

/// The equations of one premise, each with its derivatives; nothing if one between is missing.
fn in_order(mut found: Vec<(usize, Poly)>) -> Option<Vec<Unit>> {
    found.sort_by_key(|(order, _)| *order);
    let count = found.iter().filter(|(order, _)| *order == 0).count();
    let orders = found.len().checked_div(count)?;
    let whole = found.iter().enumerate().all(|(i, (order, _))| *order == i / count);
    let unit = |i: usize| (0..orders).map(|k| found[k * count + i].1.clone()).collect();
    (whole && orders * count == found.len()).then(|| (0..count).map(unit).collect())
}

/// The symbols of which a goal speaks, definitions written out.
pub(crate) fn mentioned(goal: &Goal) -> BTreeSet<usize> {
    let premises = goal.hypotheses.iter().map(|h| &h.sentence);
    let premises = premises.flat_map(|s| expressions(&s.when, &s.links));
    let own = expressions(&goal.when, goal.conclusion.links());
    let denied = expressions(goal.conclusion.when(), &[]);
    symbols(premises.chain(own).chain(denied), &goal.context)
}

/// The symbols in expressions, definitions written out.
fn symbols<'a>(
    expressions: impl IntoIterator<Item = &'a Expr>,
    context: &'a Context,
) -> BTreeSet<usize> {
    let (mut found, mut lets) = (BTreeSet::new(), BTreeSet::new());
    let mut todo: Vec<&Expr> = expressions.into_iter().collect();
    while let Some(e) = todo.pop() {
        match e {
            Expr::Var(v) | Expr::Deriv(_, v) => _ = found.insert(*v),
            Expr::Let(i) if lets.insert(*i) => todo.extend(context.lets.get(*i).map(|d| &d.body)),
            _ => {}
        }
        todo.extend(e.children());
    }
    found
}

/// The variables of which symbols speak, being functions of them or such variables themselves.
fn variables(symbols: &BTreeSet<usize>, context: &Context) -> BTreeSet<usize> {
    let of = |v: usize| context.vars.get(v).and_then(|var| var.of);
    let is_argument = |v: usize| context.vars.iter().any(|var| var.of == Some(v));
    symbols.iter().filter_map(|&v| of(v).or(is_argument(v).then_some(v))).collect()
}

/// The value of a symbol at a point with rational coordinates.
fn value(v: usize, point: &Point) -> Option<BigRational> {
    let (_, coefficients) = point.values.iter().find(|(known, _)| *known == v)?;
    match (&point.generator, coefficients.as_slice()) {
        (_, []) => Some(BigRational::zero()),
        (_, [rational]) => Some(rational.clone()),
        _ => None,
    }
}

/// The value of a polynomial there; nothing where a coordinate in it is not rational.
fn at(p: &Poly, point: &Point) -> Option<BigRational> {
    let mut total = BigRational::zero();
    for (powers, coefficient) in p.terms() {
        let mut term = BigRational::from_integer(coefficient.clone());
        for &(v, n) in powers {
            term *= num_traits::pow(value(v, point)?, usize::try_from(n).ok()?);
        }
        total += term;
    }
    Some(total)
}
