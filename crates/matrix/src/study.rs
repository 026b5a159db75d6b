//! A law's code on symbols, and what is proved or refuted of it.

use std::cell::{OnceCell, RefCell};
use std::collections::BTreeMap;
use std::rc::Rc;

use kane_impact::{Contact, Frame, Law, Outcome};
use kane_kernel::{
    Conclusion, Context, Evidence, Goal, Link, Model, Point, Rel, Relation, Root as KernelRoot,
    digest,
};
use kane_number::{Algebraic, Rational};
use num_traits::{One as _, Zero as _};

use crate::applied::{Applied, Premise, absurd, apply, with_root};
use crate::property::Demand;
use crate::sample::algebraic;
use crate::setting::{ROOTS, Setting, Symbolic};
use crate::visible::{Condition, Ranges};
use kane_audit::{Budget, Decided, Open, Proof, Reason, find_witness, prove_goal, refute_goal};

/// What the search for one proof may take: the goals are small, and many.
const BUDGET: Budget = Budget {
    steps: 120,
    fuel: 100_000,
    check: 40_000_000,
    functions: 0,
    ideals: false,
    products: false,
    squares: 0,
    cells: 0,
    document: u64::MAX,
};
/// The same with the tactics that take long, where all variables are few.
const THOROUGH: Budget = Budget { steps: 60, products: true, ..BUDGET };

/// What was asked before, and the answers: laws that say the same share their proofs.
#[derive(Debug, Default)]
pub(crate) struct Memo(RefCell<BTreeMap<(u128, Search), Answer>>);

/// A certificate that the kernel accepted, or why there is none.
type Answer = Result<Decided, Open>;

/// What is looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Search {
    Proof,
    ThoroughProof,
    Witness,
}

impl Memo {
    fn answer(&self, goal: &Goal, search: Search) -> Answer {
        let key = (digest(goal), search);
        if let Some(known) = self.0.borrow().get(&key) {
            return known.clone();
        }
        let answer = match search {
            Search::Proof => prove_goal(goal, BUDGET),
            Search::ThoroughProof => prove_goal(goal, THOROUGH),
            Search::Witness => find_witness(goal, BUDGET).ok_or(Open::Steps(BUDGET.steps)),
        };
        self.0.borrow_mut().insert(key, answer.clone());
        answer
    }
}

/// One goal that the kernel was asked, and its answer.
#[derive(Clone, Debug)]
pub struct Part {
    /// for which contacts
    pub setting: &'static str,
    /// in which regime, or between which
    pub regime: String,
    /// what is claimed there, in the words of the template
    pub claim: String,
    /// names of the goal's hypotheses
    pub labels: Vec<String>,
    /// the goal
    pub goal: Goal,
    /// what the kernel accepted
    pub decided: Decided,
}

impl Part {
    /// The proof or witness in outline.
    #[must_use]
    pub fn reason(&self) -> Reason {
        self.decided.reason(&self.goal)
    }

    /// The proof or witness step by step.
    #[must_use]
    pub fn steps(&self) -> Proof {
        self.decided.steps(&self.goal)
    }

    /// Digest of the certificate, 32 hexadecimal digits.
    #[must_use]
    pub fn digest(&self) -> String {
        format!("{:032x}", kane_kernel::digest(&self.decided.certificate))
    }
}

/// A law on one family of contacts.
pub(crate) struct Family {
    pub(crate) memo: Rc<Memo>,
    pub(crate) setting: Setting,
    pub(crate) context: Context,
    pub(crate) contact: Contact<Symbolic>,
    pub(crate) ranges: Ranges,
    pub(crate) regimes: Vec<Applied>,
    /// the contact as the law sees it, where that is another
    pub(crate) seen: Option<Frame<Symbolic>>,
    /// its contacts as a process sees them, once somebody needed that
    pub(crate) stopped: OnceCell<Vec<Self>>,
    /// what is asked beyond the ranges of the symbols
    pub(crate) asked: Vec<Premise>,
    /// holds where no regime is taken, if that may be
    pub(crate) rest: Option<Vec<Premise>>,
    /// per regime: the root as a rational function, with its proof
    pub(crate) solved: Vec<Option<(Outcome<Symbolic>, Part)>>,
    /// per regime: what was shown of its outcome, once somebody needed it
    pub(crate) lemmas: Vec<OnceCell<Vec<(String, Part)>>>,
}

/// A question about a regime.
pub(crate) struct Question<'a> {
    pub(crate) memo: &'a Memo,
    pub(crate) context: &'a Context,
    pub(crate) setting: &'static str,
    pub(crate) regime: String,
    pub(crate) premises: &'a [Premise],
    pub(crate) when: Vec<Relation>,
    pub(crate) conclusion: Relation,
    pub(crate) claim: String,
}

impl Question<'_> {
    pub(crate) fn goal(&self) -> Goal {
        Goal {
            behind: Vec::new(),
            context: self.context.clone(),
            hypotheses: self.premises.iter().map(|p| p.hypothesis.clone()).collect(),
            when: self.when.clone(),
            conclusion: Conclusion::Link(Link::Relation(self.conclusion.clone())),
        }
    }

    /// The same question on other premises.
    pub(crate) fn on(&self, premises: &[Premise]) -> Result<Part, String> {
        Question {
            premises,
            when: self.when.clone(),
            regime: self.regime.clone(),
            conclusion: self.conclusion.clone(),
            claim: self.claim.clone(),
            ..*self
        }
        .prove()
    }

    fn part(&self, goal: Goal, decided: Decided) -> Part {
        Part {
            setting: self.setting,
            regime: self.regime.clone(),
            claim: self.claim.clone(),
            labels: self.premises.iter().map(|p| p.label.clone()).collect(),
            goal,
            decided,
        }
    }

    /// A proof that the kernel accepted.
    pub(crate) fn prove(&self) -> Result<Part, String> {
        let goal = self.goal();
        let decided = self.memo.answer(&goal, Search::Proof).map_err(|why| why.to_string())?;
        Ok(self.part(goal, decided))
    }

    /// The same with more patience.
    pub(crate) fn prove_patiently(&self) -> Result<Part, String> {
        self.prove().or_else(|_| {
            let goal = self.goal();
            let decided = self.memo.answer(&goal, Search::ThoroughProof);
            let decided = decided.map_err(|why| why.to_string())?;
            Ok(self.part(goal, decided))
        })
    }

    /// A point that the search finds and the kernel accepts.
    pub(crate) fn search(&self) -> Option<(Part, Point)> {
        let goal = self.goal();
        let decided = self.memo.answer(&goal, Search::Witness).ok()?;
        let Evidence::Model(Model::Point(point)) = &decided.certificate.evidence else {
            return None;
        };
        let point = point.clone();
        Some((self.part(goal, decided), point))
    }

    /// A witness that the kernel accepted.
    pub(crate) fn refute(&self, point: Point) -> Result<Part, String> {
        let goal = self.goal();
        let decided = refute_goal(&goal, point).map_err(|why| why.to_string())?;
        Ok(self.part(goal, decided))
    }
}

impl Family {
    pub(crate) fn new(memo: &Rc<Memo>, law: &Law, setting: Setting) -> Self {
        let context = setting.context();
        let ranges = Ranges::of(&context);
        Self::of(memo, law, setting, (context, ranges), setting.contact(), Vec::new())
    }

    /// The contacts that a law sees in its own frame as those of a family, as far as they slip forwards
    /// and approach in theirs; `None` if the law's frame depends on the contact.
    pub(crate) fn seen(memo: &Rc<Memo>, law: &Law, setting: Setting) -> Option<Self> {
        let (context, seen) = (setting.context(), setting.contact());
        let ranges = Ranges::of(&context);
        let some = Contact::of_alpha(Rational::one());
        let Some(frame) = law.over::<Rational>().frame(&some) else {
            return Some(Self::of(memo, law, setting, (context, ranges), seen, Vec::new()));
        };
        let turn = frame.turn.map(<Symbolic as kane_number::Number>::from_rational);
        let contact = seen.turned(&turn.mirrored());
        let again = law.symbolic().frame(&contact)?;
        let fits = again.turn == turn
            && seen.slip() == again.contact.slip()
            && seen.approach() == again.contact.approach()
            && seen.delassus() == again.contact.delassus();
        let asked = [("v > 0", contact.slip().clone()), ("a > 0", contact.approach().clone())];
        let known = asked.iter().fold(ranges.clone(), |known, (_, x)| known.asking(x));
        let premises =
            asked.map(|(label, x)| Premise::new(label, Vec::new(), ranges.relation(&x, Rel::Gt)));
        fits.then(|| Self::of(memo, law, setting, (context, known), contact, premises.into()))
    }

    fn of(
        memo: &Rc<Memo>,
        law: &Law,
        setting: Setting,
        (context, ranges): (Context, Ranges),
        contact: Contact<Symbolic>,
        asked: Vec<Premise>,
    ) -> Self {
        let (mut regimes, rest) = apply(law, &contact, &ranges, ROOTS[0]);
        for regime in &mut regimes {
            regime.premises.extend(asked.iter().cloned());
        }
        let solved = Vec::new();
        let lemmas = regimes.iter().map(|_| OnceCell::new()).collect();
        let slips = !matches!(setting, Setting::RestingSphere | Setting::Resting);
        let seen = law.symbolic().frame(&contact).filter(|_| slips);
        let mut family = Self {
            memo: memo.clone(),
            setting,
            context,
            contact,
            seen,
            asked,
            ranges,
            regimes,
            rest,
            solved,
            lemmas,
            stopped: OnceCell::new(),
        };
        family.solved = family.regimes.iter().map(|regime| family.solve(law, regime)).collect();
        family
    }

    /// The root of a regime as a rational function, proved to be it.
    fn solve(&self, law: &Law, regime: &Applied) -> Option<(Outcome<Symbolic>, Part)> {
        let root = regime.root.as_ref()?;
        root.rational().iter().find_map(|value| {
            let x = Symbolic::symbol(root.symbol);
            let question = self.question(
                regime,
                Vec::new(),
                self.ranges.relation(&(x - value), Rel::Eq),
                "the root".to_owned(),
            );
            Some((with_root(law, &self.contact, regime, value), question.prove().ok()?))
        })
    }

    pub(crate) fn question<'a>(
        &'a self,
        regime: &'a Applied,
        when: Vec<Relation>,
        conclusion: Relation,
        claim: String,
    ) -> Question<'a> {
        Question {
            memo: &self.memo,
            context: &self.context,
            setting: self.setting.name(),
            regime: regime.name.to_owned(),
            premises: &regime.premises,
            when,
            conclusion,
            claim,
        }
    }

    /// A demand as conditions and a conclusion; `None` if its conditions visibly never hold.
    pub(crate) fn relations(&self, demand: &Demand<Symbolic>) -> Option<(Vec<Relation>, Relation)> {
        let mut when = Vec::new();
        for condition in &demand.when {
            let quantity = condition.lhs.clone() - &condition.rhs;
            match self.ranges.condition(&quantity, condition.rel) {
                Condition::Always => {}
                Condition::Never => return None,
                Condition::Where(relation) => when.push(relation),
            }
        }
        let claim = &demand.claim;
        Some((when, self.ranges.relation(&(claim.lhs.clone() - &claim.rhs), claim.rel)))
    }
}

/// The contact at a point of its family; `None` if it is not rational.
pub(crate) fn contact_at(family: &Family, point: &Point) -> Option<Contact<Rational>> {
    let mut values = vec![Rational::zero(); family.context.vars.len()];
    for (symbol, coefficients) in &point.values {
        match &coefficients[..] {
            [value] => *values.get_mut(*symbol)? = value.clone(),
            _ if ROOTS.contains(symbol) => {}
            [] => {}
            _ => return None,
        }
    }
    // what the goal does not mention is free
    for (symbol, value) in values.iter_mut().enumerate() {
        let mentioned = point.values.iter().any(|(known, _)| *known == symbol);
        if !mentioned {
            *value = Rational::one();
        }
    }
    let at = |x: &Symbolic| x.eval(&values);
    let c = &family.contact;
    let w = c.delassus();
    let delassus = kane_impact::Delassus::new(at(w.tt())?, at(w.tn())?, at(w.nn())?).ok()?;
    Contact::new(
        at(c.slip())?,
        at(c.approach())?,
        delassus,
        at(c.friction())?,
        at(c.restitution())?,
    )
    .ok()
}

/// A contact as a point of its family, with the regime that the law takes there.
pub(crate) struct Located {
    /// place of the regime among those of the family
    pub(crate) regime: usize,
    pub(crate) point: Point,
}

/// Finds a contact in a family: the regime that applies, its root, and the values of all symbols.
pub(crate) fn locate(law: &Law, family: &Family, contact: &Contact<Rational>) -> Option<Located> {
    let values = family.setting.values(contact)?;
    let index = law.over().place(contact)?;
    let regime = family.regimes.iter().position(|applied| applied.index == index)?;
    let mut point = Point { generator: None, values: Vec::new() };
    point.values = values.into_iter().map(|(symbol, value)| (symbol, vec![value])).collect();
    if family.regimes[regime].root.is_some() {
        let chosen = law.over().regime(&algebraic(contact)).ok()?;
        add_root(&mut point, ROOTS[0], &chosen.root?)?;
    }
    Some(Located { regime, point })
}

/// Gives a symbol the value of a root; `None` if the point already has another irrational value.
pub(crate) fn add_root(point: &mut Point, symbol: usize, root: &Algebraic) -> Option<()> {
    let coefficients = match root.as_rational() {
        Some(value) => vec![value.clone()],
        None if point.generator.is_none() => {
            let (lo, hi) = root.isolating_interval();
            point.generator = Some(KernelRoot { poly: root.polynomial(), lo, hi });
            vec![Rational::zero(), Rational::one()]
        }
        None => return None,
    };
    point.values.push((symbol, coefficients));
    point.values.sort_by_key(|(symbol, _)| *symbol);
    Some(())
}

/// That the premises contradict each other.
pub(crate) fn impossible(
    family: &Family,
    premises: &[Premise],
    regime: String,
    claim: &str,
) -> Result<Part, String> {
    Question {
        memo: &family.memo,
        context: &family.context,
        setting: family.setting.name(),
        regime,
        premises,
        when: Vec::new(),
        conclusion: absurd(),
        claim: claim.to_owned(),
    }
    .prove()
}
