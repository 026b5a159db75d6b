//! Lemmas: polynomials of which some signs are ruled out first, each by a search of its own among the conditions that
//! speak of its variables alone; then a sum with them closes the state.

use std::collections::BTreeSet;

use kane_kernel::{Atom, Expr, Poly, Sign, State, Term};

use super::combination::{Size, Summand, combined, summand};
use super::comparison::leads;
use super::elimination::Factors;
use super::hints::Hint;
use super::idle::nothing;
use super::search::{Outcome, Search, has_root, since};
use super::settled::Settled;
use super::tangents::tangents;
use super::touching::{Gap, Tangents};
use crate::argument::Argument;
use crate::open::Method;

/// States that the search for one lemma may visit.
const STEPS: u64 = 300;
/// One part in so many of the budget for squares is for one lemma.
const SHARE: u64 = 16;
/// Case distinctions after which nothing is looked at by itself.
const FEW: u32 = 2;
/// Expressions that an author says to use of which lemmas are made.
const HINTS: usize = 6;
/// The linear program of the last sum.
const SIZE: Size = Size { rows: 3000, columns: 120, pivots: 400 };

/// A polynomial that is positive, or at least not negative, and why.
struct Lemma {
    poly: Poly,
    /// why it is not zero, if it is not
    zero: Option<Argument>,
    negative: Argument,
}

/// A state with what lemmas say, and they.
struct Told<'a, 's, 'g> {
    search: &'a Search<'a>,
    state: State<'s, 'g>,
    /// atoms of the state without lemmas
    first: usize,
    lemmas: Vec<Lemma>,
    /// what no lemma is shown by: it may be an equation there, or has no part in it
    idle: Vec<usize>,
}

impl<'a, 's, 'g> Told<'a, 's, 'g> {
    fn new(search: &'a Search<'a>, state: &State<'s, 'g>, idle: Vec<usize>) -> Self {
        let (state, first) = (state.clone(), state.atoms.len());
        Self { search, state, first, lemmas: Vec::new(), idle }
    }

    /// The place of what says that a polynomial is positive, or else not negative; `None` if that is not shown.
    fn tell(&mut self, poly: &Poly, strict: bool) -> Option<usize> {
        let place = self.state.atoms.len();
        self.lemmas.push(self.search.lemma(&self.state, poly, strict, &self.idle)?);
        let sign = if strict { Sign::Positive } else { Sign::NonNegative };
        self.state = self.state.with(Atom::new(poly.clone(), sign));
        if !strict {
            self.idle.push(place);
        }
        Some(place)
    }

    /// A contradiction by a sum of conditions and of some products of them.
    fn closed(&self, products: impl IntoIterator<Item = Factors>) -> Option<Argument> {
        let alone = (0..self.first).filter(|i| self.state.atoms[*i].sign.is_order());
        let all = alone.map(|i| vec![(i, 1)]).chain(products);
        let summand = |factors| summand(&self.state, Poly::one(), factors);
        let summands: Vec<Summand> = all.map(summand).collect::<Option<_>>()?;
        let sum = combined(&self.state, summands, Vec::new(), &SIZE)?;
        let Argument::Positive { terms, .. } = sum else { return None };
        distinguished(&self.state, &self.lemmas, &terms, self.first, &mut Vec::new())
    }
}

impl Search<'_> {
    /// A claim by its tangent planes at a point where both sides agree.
    pub(super) fn by_tangents(&self, state: &State<'_, '_>) -> Option<Argument> {
        if !self.tangents {
            return None;
        }
        let ways = tangents(state)?;
        self.note(Method::Tangents);
        ways.into_iter().find_map(|tangents| self.cut(state, tangents))
    }

    fn cut(&self, state: &State<'_, '_>, tangents: Tangents) -> Option<Argument> {
        let Tangents { denominators, gaps, rest, at_edge } = tangents;
        let mut told = Told::new(self, state, at_edge);
        let by: Option<Vec<usize>> = denominators.iter().map(|p| told.tell(p, true)).collect();
        let by = by?;
        let mut places: Vec<(usize, Option<usize>)> = Vec::new();
        // the likeliest to fail first
        let rest = Gap { poly: rest, by: None };
        for gap in [rest].iter().chain(&gaps).filter(|gap| !gap.poly.is_constant()) {
            places.push((told.tell(&gap.poly, false)?, gap.by));
        }
        let products = places.iter().flat_map(|&(place, own)| {
            // a claim is multiplied by its denominators, or by their squares
            let times = |square: u32| {
                let power = |(j, at): (usize, &usize)| (*at, square + u32::from(Some(j) != own));
                let mut factors: Factors = by.iter().enumerate().map(power).collect();
                factors.retain(|power| power.1 > 0);
                factors.push((place, 1));
                factors
            };
            (0..=u32::from(!by.is_empty())).map(times).collect::<Vec<_>>()
        });
        told.closed(products)
    }

    /// A claim by what the author says to use, where each of that is shown to have one sign.
    pub(super) fn by_lemmas_of_hints(&self, state: &State<'_, '_>) -> Option<Argument> {
        if self.hints.is_empty() || self.hints.len() > HINTS || self.brief || !self.proofs {
            return None;
        }
        self.note(Method::Hints);
        let mut told = Told::new(self, state, Vec::new());
        let mut places: Vec<usize> = Vec::new();
        let mut seen: Vec<&Poly> = Vec::new();
        for p in self.hints.iter().flat_map(Hint::bases) {
            if seen.len() < HINTS && !seen.contains(&p) {
                seen.push(p);
                places.extend(told.tell(p, false).or_else(|| told.tell(&p.neg(), false)));
            }
        }
        let subsets = (1..1_usize << places.len()).map(|subset| {
            let chosen = places.iter().enumerate().filter(|(k, _)| subset >> k & 1 == 1);
            chosen.map(|(_, place)| (*place, 1)).collect()
        });
        if places.is_empty() { None } else { told.closed(subsets) }
    }

    /// What stands before a square, if it is shown by itself to be positive.
    pub(super) fn lead_by_itself(&self, state: &State<'_, '_>, splits: u32) -> Option<Settled> {
        if splits > FEW || self.brief || !self.proofs {
            return None;
        }
        leads(state).into_iter().flat_map(|lead| [lead.neg(), lead]).find_map(|lead| {
            let Lemma { poly, zero, negative } = self.lemma(state, &lead, true, &[])?;
            Settled::positive(state, poly, zero?, negative)
        })
    }

    /// Why a polynomial is not negative, and not zero if that is asked.
    fn lemma(
        &self,
        state: &State<'_, '_>,
        poly: &Poly,
        strict: bool,
        idle: &[usize],
    ) -> Option<Lemma> {
        let about = about(state, poly, idle);
        let never = |atom: Atom| self.closed_aside(&about.with(atom));
        let negative = never(Atom::new(poly.neg(), Sign::Positive))?;
        let zero = match strict {
            true => Some(never(Atom::new(poly.clone(), Sign::Zero))?),
            false => None,
        };
        Some(Lemma { poly: poly.clone(), zero, negative })
    }

    /// Why what is left once a sign is known contradicts itself, by the conditions that speak of its variables alone:
    /// after a root has been squared away those with the root only widen the search.
    pub(super) fn closed_alone(
        &self,
        state: &State<'_, '_>,
        settled: &Settled,
        splits: u32,
    ) -> Option<Argument> {
        let others = || state.atoms.iter().any(|a| has_root(state, &a.poly));
        if has_root(state, &settled.poly) || !others() {
            return None;
        }
        self.case_alone(state, settled.atom(), splits)
    }

    /// Why a case contradicts itself, by the conditions that speak of its variables alone.
    pub(super) fn case_alone(
        &self,
        state: &State<'_, '_>,
        case: Atom,
        splits: u32,
    ) -> Option<Argument> {
        let is_tried = splits <= FEW && !self.brief && self.proofs;
        let poly = case.poly.clone();
        is_tried.then(|| self.closed_aside(&about(&state.with(case), &poly, &[])))?
    }

    /// A contradiction in a state by a small search.
    pub(super) fn closed_aside(&self, state: &State<'_, '_>) -> Option<Argument> {
        match self.aside().run(state, &since(state, 0), Vec::new(), &[], 0) {
            Outcome::Closed(argument) => Some(argument),
            _ => None,
        }
    }

    /// A small search beside this one.
    fn aside(&self) -> Search<'_> {
        let mut search = Search::new(STEPS, self.may_eliminate, false);
        search.widest = self.widest;
        search.keep.clone_from(&self.keep);
        search.ideals = self.ideals;
        search.products = self.products;
        search.squares = self.squares.within(self.squares.left() / SHARE);
        search.cells = self.cells.within(self.cells.left() / SHARE);
        search
    }
}

/// A state in which nothing is said but of the variables of a polynomial, and of what stands under the roots among them.
/// All conditions keep their places.
fn about<'s, 'g>(state: &State<'s, 'g>, poly: &Poly, idle: &[usize]) -> State<'s, 'g> {
    let mut of: BTreeSet<usize> = poly.vars().into_iter().collect();
    let mut todo: Vec<usize> = of.iter().copied().collect();
    while let Some(v) = todo.pop() {
        let Some(Expr::Sqrt(inner)) = state.scope.root(v) else { continue };
        let pieces = state.scope.pieces(inner).unwrap_or_default();
        for value in pieces.into_iter().filter_map(|piece| piece.value) {
            let vars = value.num.vars().into_iter().chain(value.den.vars());
            todo.extend(vars.filter(|v| of.insert(*v)));
        }
    }
    let kept = |(i, atom): (usize, &Atom)| {
        let speaks = atom.poly.vars().into_iter().all(|v| of.contains(&v));
        if speaks && !idle.contains(&i) { atom.clone() } else { nothing() }
    };
    State { atoms: state.atoms.iter().enumerate().map(kept).collect(), ..state.clone() }
}

/// A split for each lemma. Where one is an equation, its products in the sum are multiples of that.
fn distinguished(
    state: &State<'_, '_>,
    lemmas: &[Lemma],
    terms: &[Term],
    first: usize,
    equations: &mut Vec<usize>,
) -> Option<Argument> {
    let Some((lemma, others)) = lemmas.split_first() else {
        return with_equations(state, terms, equations);
    };
    let positive = distinguished(state, others, terms, first + 1, equations)?;
    let zero = match &lemma.zero {
        Some(never) => never.clone(),
        None => {
            equations.push(first);
            let argument = distinguished(state, others, terms, first + 1, equations)?;
            equations.pop();
            argument
        }
    };
    let [zero, positive, negative] = [zero, positive, lemma.negative.clone()].map(Box::new);
    Some(Argument::Split { poly: lemma.poly.clone(), zero, positive, negative })
}

/// The sum, if some of its conditions are equations.
fn with_equations(state: &State<'_, '_>, terms: &[Term], equations: &[usize]) -> Option<Argument> {
    let fuel = &state.scope.fuel;
    let (mut left, mut cofactors): (Vec<Term>, Vec<(usize, Poly)>) = (Vec::new(), Vec::new());
    for term in terms {
        let place = term.factors.iter().position(|(i, _)| equations.contains(i));
        let Some(place) = place else {
            left.push(term.clone());
            continue;
        };
        let equation = term.factors[place].0;
        let mut cofactor = term.square.pow(2, fuel).ok()?.scale(&term.weight);
        for (k, &(i, n)) in term.factors.iter().enumerate() {
            let n = if k == place { n - 1 } else { n };
            cofactor = cofactor.mul(&state.atoms[i].poly.pow(n, fuel).ok()?, fuel).ok()?;
        }
        match cofactors.iter_mut().find(|(i, _)| *i == equation) {
            Some((_, sum)) => *sum = sum.add(&cofactor),
            None => cofactors.push((equation, cofactor)),
        }
    }
    Some(Argument::Positive { terms: left, cofactors })
}
