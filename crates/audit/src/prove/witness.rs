//! Points and functions as models of a goal: what refutes it, and what shows that its hypotheses can
//! hold.

use kane_kernel::{Conclusion, Finding, Fuel, Functions, Goal, Link, Model, premised, scope};

use super::budget::Ways;
use super::functions;
use super::search::Outcome;
use super::{Decided, Prover, REMEMBERED, Verdicts};
use crate::argument::Grounds;

impl Prover<'_> {
    /// A model of a finding: a point, or functions where limits are involved.
    fn model(
        &self,
        goal: &Goal,
        finding: Finding,
        candidates: usize,
        ways: Ways,
        out: &mut Verdicts,
    ) -> Option<Model> {
        match limit_variable(goal) {
            None => match self.search(goal, finding, true, ways, out) {
                (_, Outcome::Model(point)) => Some(Model::Point(point)),
                _ => None,
            },
            Some(_) if ways != Ways::Near => None,
            Some(x) => functions::model(
                goal,
                finding,
                x,
                self.by,
                &self.effort(candidates, goal.hypotheses.len() > self.cited),
            )
            .map(|f: Functions| Model::Functions(Box::new(f))),
        }
    }

    /// A model for the goal, preferably one that satisfies all givens behind it.
    pub(super) fn witness(
        &self,
        goal: &Goal,
        finding: Finding,
        ways: Ways,
        out: &mut Verdicts,
    ) -> bool {
        self.witness_from(self.resting, goal, finding, ways, out)
            || self.resting != goal && self.witness_from(goal, goal, finding, ways, out)
    }

    /// A model for the goal that satisfies a source, which has further hypotheses or is the goal.
    pub(super) fn witness_from(
        &self,
        source: &Goal,
        goal: &Goal,
        finding: Finding,
        ways: Ways,
        out: &mut Verdicts,
    ) -> bool {
        let candidates = self.candidates(source, goal);
        let Some(model) = self.model(source, finding, candidates, ways, out) else { return false };
        let grounds = Grounds::Model(restricted(model, goal, source));
        let decides = self.decide(goal, finding, grounds, out);
        if decides {
            out.behind_met = source == self.resting;
        }
        decides
    }

    /// Has a witness count for all premises that the goal rests on, if the kernel accepts it for them.
    pub(crate) fn of_all(&self, found: &mut Verdicts) {
        let Some(Decided { certificate, grounds, .. }) = &mut found.decided else { return };
        if found.behind_met
            && matches!(grounds, Grounds::Model(_))
            && let Ok(of_all) = self.accept(self.resting, certificate.finding, grounds)
        {
            *certificate = of_all;
        }
    }

    /// A witness of the goal found as a model of a source with further hypotheses, and the whole model.
    pub(crate) fn witness_within(
        &self,
        source: &Goal,
        goal: &Goal,
        finding: Finding,
    ) -> Option<(Decided, Model)> {
        let mut out = Verdicts::default();
        let candidates = self.candidates(source, goal);
        let model = self.model(source, finding, candidates, Ways::Near, &mut out)?;
        let whole = Grounds::Model(model.clone());
        self.accept(source, finding, &whole).ok()?;
        let grounds = Grounds::Model(restricted(model.clone(), goal, source));
        self.decide(goal, finding, grounds, &mut out);
        Some((out.decided?, model))
    }

    /// How many functions to try: few where more premises than the cited ones only guide.
    fn candidates(&self, source: &Goal, goal: &Goal) -> usize {
        if source == goal { self.budget.functions } else { self.budget.functions / 20 }
    }

    /// A model of an earlier claim that satisfies the hypotheses of this one too.
    fn remembered(&self, goal: &Goal) -> Option<Model> {
        let earlier = self.earlier.borrow();
        let scope = scope(goal, self.fuel()).ok()?;
        // What has no value for a symbol with a range, or not just for the symbols of the goal, the
        // kernel would not accept.
        let fits = |model: &&Model| match model {
            Model::Point(point) => {
                let mut ranged = scope.mentioned.iter().filter(|v| !scope.range(**v).is_empty());
                ranged.all(|v| point.values.iter().any(|known| known.0 == *v))
            }
            Model::Functions(f) => {
                let others = scope.mentioned.iter().filter(|v| **v != f.var);
                f.values.iter().map(|(v, _)| v).eq(others)
            }
        };
        let holds = |model: &&Model| {
            let grounds = Grounds::Model((*model).clone());
            self.accept(goal, Finding::Consistent, &grounds).is_ok()
        };
        earlier.iter().rev().take(REMEMBERED).filter(fits).find(holds).cloned()
    }

    /// The point that shows that the hypotheses can hold, if the claim fails there. Then there is no
    /// proof to look for, and what is left is to look for a point that is easier to follow.
    pub(super) fn counterexample(&self, goal: &Goal, out: &Verdicts) -> Option<Decided> {
        let grounds = Grounds::Model(out.model.clone()?);
        let certificate = self.accept(goal, Finding::Refuted, &grounds).ok()?;
        Some(Decided { certificate, grounds, kept: None })
    }

    /// Looks for a model of the hypotheses; `true` if they are contradictory instead.
    pub(super) fn consistent(&self, goal: &Goal, out: &mut Verdicts) -> bool {
        if let Some(model) = self.remembered(goal) {
            out.model = Some(model);
            return false;
        }
        let found =
            self.model(goal, Finding::Consistent, self.budget.functions / 4, Ways::Near, out);
        if let Some(model) = found {
            let grounds = Grounds::Model(model.clone());
            if self.accept(goal, Finding::Consistent, &grounds).is_ok() {
                self.earlier.borrow_mut().push(model.clone());
                out.model = Some(model);
                return false;
            }
        }
        match self.closed(goal, Finding::Vacuous, Ways::Near, out) {
            Some(grounds) => self.decide(goal, Finding::Vacuous, grounds, out),
            None => false,
        }
    }
}

/// The variable in which functions have to be chosen, if a point is not enough.
fn limit_variable(goal: &Goal) -> Option<usize> {
    if let Some((_, l)) = premised(goal).next() {
        return Some(l.var);
    }
    let links: &[Link] = match &goal.conclusion {
        Conclusion::Link(l) => std::slice::from_ref(l),
        Conclusion::NotImplied(s) => &s.links,
        Conclusion::Contradiction => &[],
    };
    links.iter().find_map(|l| match l {
        Link::Limit(l) => Some(l.var),
        Link::Relation(_) => None,
    })
}

/// A model of a goal with more hypotheses, as a model of the goal.
fn restricted(model: Model, goal: &Goal, source: &Goal) -> Model {
    match model {
        Model::Functions(mut f) if goal != source => {
            f.premises.truncate(goal.hypotheses.len());
            if let Ok(scope) = scope(goal, Fuel::new(1_000_000)) {
                let kept: Vec<bool> =
                    f.values.iter().map(|(v, _)| scope.mentioned.contains(v)).collect();
                let (mut i, mut j) = (0, 0);
                f.values.retain(|_| {
                    i += 1;
                    kept[i - 1]
                });
                f.ranges.retain(|_| {
                    j += 1;
                    kept[j - 1]
                });
            }
            Model::Functions(f)
        }
        // Variables of roots and limits are numbered by the goal.
        Model::Point(mut p) if goal != source => {
            let symbols = goal.context.vars.len();
            if goal_roots(goal) != goal_roots(source) {
                p.values.retain(|(v, _)| *v < symbols);
            }
            Model::Point(p)
        }
        other => other,
    }
}

fn goal_roots(goal: &Goal) -> usize {
    scope(goal, Fuel::new(1_000_000)).map_or(0, |s| s.germ() - goal.context.vars.len())
}
