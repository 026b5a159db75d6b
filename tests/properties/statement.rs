//! What a law states, solved exactly together with momentum and restitution, against its code.
//!
//! With Newton's restitution p_n = (1 + e)·a/(W_nn − μ·i_x·W_tn), and with momentum, for v_t > 0,
//!
//! ```text
//! i_x = ((1 − k)·v_t·W_nn + (1 + e)·a·W_tn)/(μ·((1 + e)·a·W_tt + (1 − k)·v_t·W_tn))
//! ```
//!
//! so that every relation of a statement is one in k alone. The candidates are the zeros of all of
//! them; the solutions are those that satisfy the whole statement with p_n > 0. This shares with the
//! code neither its regimes nor its formulas.

use kane::algebra::rational_function::RationalFunction;
use kane::algebra::syntax::{Scope, parse_sentence};
use kane::kernel::{Expr, Link, Rel, Relation, Sentence, Var};
use kane_impact::{Contact, Law, NoImpulse, laws};
use kane_number::{Algebraic, Number, Ordered as _, Rational, Real};
use proptest::prelude::*;

use crate::contacts::tame_contact;
use crate::frames::{as_given, as_seen};
use crate::{cases, rational};

/// A law's statement, parsed, and its parameters.
pub(crate) struct Statement {
    pub(crate) lines: Vec<Sentence>,
    pub(crate) parameters: Vec<Rational>,
}

/// The symbols of every statement, before the law's own.
pub(crate) const SYMBOLS: [&str; 5] = ["k", "i_x", "alpha", "e", "mu"];

impl Statement {
    pub(crate) fn of(law: &Law) -> Self {
        let mut scope = Scope::default();
        let (names, parameters): (Vec<_>, Vec<_>) = law.parameters().into_iter().unzip();
        for name in SYMBOLS.into_iter().chain(names) {
            let var = Var { name: name.into(), of: None, lower: None, upper: None };
            scope.declare(var).expect("distinct names");
        }
        let line = |text| parse_sentence(text, &scope).expect("the statement is well formed");
        Self { lines: law.info.statement.lines().map(line).collect(), parameters }
    }

    /// All relations, those under `when` included.
    fn relations(&self) -> impl Iterator<Item = &Relation> {
        self.lines.iter().flat_map(|line| line.when.iter().chain(links(line)))
    }
}

pub(crate) fn links(line: &Sentence) -> impl Iterator<Item = &Relation> {
    line.links.iter().map(|link| match link {
        Link::Relation(relation) => relation,
        Link::Limit(_) => unreachable!("a law states no limits"),
    })
}

/// The value of an expression by field operations, in any number system.
pub(crate) fn value<N: Number>(expr: &Expr, symbols: &[N]) -> N {
    let of = |expr: &Expr| value(expr, symbols);
    match expr {
        Expr::Num(exact) => N::from_rational(exact),
        Expr::Var(index) => symbols[*index].clone(),
        Expr::Neg(a) => -of(a),
        Expr::Add(a, b) => of(a) + of(b),
        Expr::Sub(a, b) => of(a) - of(b),
        Expr::Mul(a, b) => of(a) * of(b),
        Expr::Div(a, b) => of(a) / of(b),
        Expr::Pow(a, n) => (0..*n).fold(N::one(), |product, _| product * of(a)),
        _ => unreachable!("a law states field operations: {expr:?}"),
    }
}

fn holds<N: Real>(relation: &Relation, symbols: &[N]) -> bool {
    let order = value(&relation.lhs, symbols).compare(&value(&relation.rhs, symbols));
    let answer = match relation.rel {
        Rel::Eq => order.is_equal(),
        Rel::Ne => order.is_equal().map(|equal| !equal),
        Rel::Lt => order.is_less(),
        Rel::Le => order.is_at_most(),
        Rel::Gt => order.is_greater(),
        Rel::Ge => order.is_at_least(),
    };
    answer.expect("exact numbers decide")
}

/// The contact's part of the equations, with k.
struct Momentum<N> {
    impulse_by_k: [N; 2],
    bound_by_k: [N; 2],
}

impl<N: Number> Momentum<N> {
    /// i_x = (b0 + b1·(1 − k))/(c0 + c1·(1 − k)) on a contact that faces forwards.
    fn of(contact: &Contact<N>) -> Self {
        let (w, v, c) = (contact.delassus(), contact.slip(), contact.closing());
        let mu = contact.friction();
        Self {
            impulse_by_k: [c.clone() * w.tn(), v.clone() * w.nn()],
            bound_by_k: [c * w.tt() * mu, v.clone() * w.tn() * mu],
        }
    }

    fn ratio(&self, k: &N) -> Option<N> {
        let at = |[constant, linear]: &[N; 2]| constant.clone() + linear.clone() * (N::one() - k);
        at(&self.impulse_by_k).checked_div(&at(&self.bound_by_k))
    }
}

/// All k that the statement admits, with p_n > 0.
fn solutions(statement: &Statement, contact: &Contact<Rational>) -> Vec<Algebraic> {
    let symbols_at = |contact: &Contact<RationalFunction>, k: RationalFunction| {
        let i_x = Momentum::of(contact).ratio(&k).expect("not everywhere zero");
        let alpha = contact.alpha().expect("the contact slips");
        let mut symbols = vec![k, i_x, alpha];
        symbols.extend([contact.restitution().clone(), contact.friction().clone()]);
        symbols.extend(statement.parameters.iter().map(Number::from_rational));
        symbols
    };
    let symbolic = contact.map(RationalFunction::from_rational);
    let symbols = symbols_at(&symbolic, RationalFunction::symbol(0));
    let mut candidates: Vec<Algebraic> = Vec::new();
    for relation in statement.relations() {
        let difference = value(&relation.lhs, &symbols) - value(&relation.rhs, &symbols);
        let numerator = difference.fraction().0.univariate(0).expect("in k alone");
        let coefficients: Vec<_> = numerator.into_iter().map(Rational::from_integer).collect();
        for root in Algebraic::roots(&coefficients) {
            if !candidates.contains(&root) {
                candidates.push(root);
            }
        }
    }
    let exact = contact.map(|x| Algebraic::from(x.clone()));
    let (w, mu) = (exact.delassus(), exact.friction());
    candidates.retain(|k| {
        let Some(i_x) = Momentum::of(&exact).ratio(k) else { return false };
        let pushes = w.nn().clone() - mu.clone() * &i_x * w.tn();
        let mut symbols = vec![k.clone(), i_x, exact.alpha().expect("the contact slips")];
        symbols.extend([exact.restitution().clone(), mu.clone()]);
        symbols.extend(statement.parameters.iter().map(Number::from_rational));
        let obeys = statement.lines.iter().all(|line| {
            !line.when.iter().all(|relation| holds(relation, &symbols))
                || links(line).all(|relation| holds(relation, &symbols))
        });
        pushes.sign().is_greater() == Some(true) && obeys
    });
    candidates
}

struct Solve<'a> {
    contact: &'a Contact<Rational>,
    fault: Option<String>,
    solved: usize,
}

impl Solve<'_> {
    fn visit(&mut self, law: &Law) {
        self.at(law, self.contact);
        if law.over().frame(self.contact).is_some() {
            self.at(law, &self.contact.mirrored());
        }
    }
}

impl Solve<'_> {
    /// At the contact that the law sees as this one, facing either way.
    fn at(&mut self, law: &Law, seen: &Contact<Rational>) {
        let coupled = seen.delassus().tn() != &rational(0, 1);
        if coupled && !law.info.stated_for_coupling {
            return;
        }
        let contact = as_given(law.over::<Rational>(), seen);
        let (slip, approach) = (contact.slip().sign(), contact.approach().sign());
        if slip.is_greater() != Some(true) || approach.is_at_least() != Some(true) {
            return;
        }
        // the law may have another restitution in its frame
        let seen = law.over().frame(&contact).map_or_else(|| seen.clone(), |frame| frame.contact);
        let forward = *seen.slip() > rational(0, 1);
        let solutions =
            solutions(&Statement::of(law), &if forward { seen.clone() } else { seen.mirrored() });
        let exact = contact.map(|x| Algebraic::from(x.clone()));
        let computed = match law.over().resolve(&exact) {
            Ok(outcome) => {
                let (seen, impulse) = as_seen(law.over::<Algebraic>(), &exact, &outcome.impulse);
                vec![seen.slip_after(&impulse) / seen.slip()]
            }
            // what its acceptance or its gap forbids is not a solution of the statement alone
            Err(NoImpulse::Outside { .. }) => Vec::new(),
            Err(error) => unreachable!("exact numbers decide: {error}"),
        };
        self.solved += solutions.len();
        let refused = computed.is_empty() && law.info.gap.is_some();
        if solutions != computed && !refused {
            let texts = |all: &[Algebraic]| all.iter().map(ToString::to_string).collect::<Vec<_>>();
            self.fault = Some(format!(
                "{}: the statement has k = {:?}, the code k = {:?} at {:?}",
                law.info.id,
                texts(&solutions),
                texts(&computed),
                contact,
            ));
        }
    }
}

proptest! {
    #![proptest_config(cases(400))]

    /// Exactly one solution, and it is what the code computes, for every law. Where the code gives
    /// no impulse, the law says why.
    #[test]
    fn every_law_computes_the_only_solution_of_its_statement(
        contact in tame_contact(),
        uncoupled in any::<bool>(),
    ) {
        let zero = rational(0, 1);
        // k has no meaning without slip, nor i_x without impulse
        prop_assume!(*contact.slip() != zero && *contact.friction() != zero);
        prop_assume!(*contact.approach() != zero);
        let contact = if *contact.slip() < zero { contact.mirrored() } else { contact };
        let contact = if uncoupled { decoupled(&contact) } else { contact };
        let mut solve = Solve { contact: &contact, fault: None, solved: 0 };
        for law in laws() { solve.visit(law); }
        prop_assert!(solve.fault.is_none(), "{}", solve.fault.unwrap_or_default());
        prop_assert!(solve.solved > 0);
    }
}

/// The same contact without coupling.
pub(crate) fn decoupled(contact: &Contact<Rational>) -> Contact<Rational> {
    let w = contact.delassus();
    let delassus = kane_impact::Delassus::new(w.tt().clone(), rational(0, 1), w.nn().clone());
    Contact::new(
        contact.slip().clone(),
        contact.approach().clone(),
        delassus.expect("positive entries"),
        contact.friction().clone(),
        contact.restitution().clone(),
    )
    .expect("inside the domain")
}
