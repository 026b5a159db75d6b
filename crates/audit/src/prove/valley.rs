//! Points in the valleys of what is written as squares: where the sums that are squared are zero.
//!
//! A quotient is large where its denominator is small, and 1 + (x + 2·y)² + (y − z + 3)² is where both sums vanish: a place
//! far from simple values of x, y and z.

use kane_algebra::squares::total_degree;
use kane_kernel::{Atom, Conclusion, Expr, Goal, Link, Point, Poly, Relation, Sign, State};

use super::hints::{Hint, expanded};
use super::search::{Outcome, Search, since};

/// Sums of squares that are looked at, and squares of one.
const VALLEYS: usize = 4;
const SQUARES: usize = 5;
/// States that the search in one valley may visit.
const STEPS: u64 = 60;

/// The sums of squares in a claim and its conditions, each as what is squared in it.
fn valleys(goal: &Goal) -> Vec<Vec<Expr>> {
    let relations = match &goal.conclusion {
        Conclusion::Link(Link::Relation(relation)) => std::slice::from_ref(relation),
        _ => &[],
    };
    let sides = |r: &Relation| [expanded(&r.lhs, &goal.context), expanded(&r.rhs, &goal.context)];
    let mut todo: Vec<Expr> =
        relations.iter().chain(&goal.when).flat_map(sides).flatten().collect();
    let mut found: Vec<Vec<Expr>> = Vec::new();
    while let Some(e) = todo.pop() {
        let mut squared = Vec::new();
        summands(&e, &mut squared, &mut todo);
        squared.truncate(SQUARES);
        if !squared.is_empty() && !found.contains(&squared) {
            found.push(squared);
        }
        if found.len() == VALLEYS {
            break;
        }
    }
    found
}

/// What is squared among the summands of a sum, and what is within the others.
fn summands(e: &Expr, squared: &mut Vec<Expr>, within: &mut Vec<Expr>) {
    match e {
        Expr::Add(a, b) | Expr::Sub(a, b) => {
            summands(a, squared, within);
            summands(b, squared, within);
        }
        Expr::Neg(a) => summands(a, squared, within),
        Expr::Mul(a, b) if matches!(**a, Expr::Num(_)) => summands(b, squared, within),
        Expr::Pow(base, n) if n % 2 == 0 && matches!(**base, Expr::Add(..) | Expr::Sub(..)) => {
            squared.push((**base).clone());
        }
        _ => within.extend(e.children().into_iter().cloned()),
    }
}

impl Search<'_> {
    /// A point in a valley: where all sums that are squared in it are zero, as far as they are linear, or all but one.
    pub(super) fn in_valleys(&self, state: &State<'_, '_>) -> Option<Point> {
        let linear = |squared: &Vec<Expr>| -> Vec<Poly> {
            let hints = Hint::all(state.scope, squared);
            let sums = hints.iter().flat_map(Hint::bases).filter(|p| total_degree(p) == 1);
            sums.cloned().collect()
        };
        let valleys: Vec<Vec<Poly>> = valleys(state.goal).iter().map(linear).collect();
        let whole = valleys.iter().map(|sums| self.at_zeros(state, sums.iter()));
        let all_but_one = valleys.iter().filter(|sums| sums.len() > 1).flat_map(|sums| {
            let without = |left: usize| sums.iter().enumerate().filter(move |(i, _)| *i != left);
            (0..sums.len()).map(move |left| without(left).map(|(_, sum)| sum))
        });
        let parts = all_but_one.map(|sums| self.at_zeros(state, sums));
        whole.chain(parts).find_map(|found| found)
    }

    /// A simple point at which these are zero.
    fn at_zeros<'p>(
        &self,
        state: &State<'_, '_>,
        sums: impl Iterator<Item = &'p Poly>,
    ) -> Option<Point> {
        let on = sums.fold(state.clone(), |on, sum| on.with(Atom::new(sum.clone(), Sign::Zero)));
        if on.atoms.len() == state.atoms.len() {
            return None;
        }
        let mut search = Search::new(STEPS, self.may_eliminate, true);
        search.proofs = false;
        search.brief = true;
        search.widest = self.widest;
        match search.run(&on, &since(&on, state.atoms.len()), Vec::new(), &[], 1) {
            Outcome::Model(point) => Some(point),
            _ => None,
        }
    }
}
