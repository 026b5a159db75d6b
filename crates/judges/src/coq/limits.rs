//! Claims that are proved of functions: limits, and what limits among the premises lead to.

use std::borrow::Cow;
use std::cell::RefCell;
use std::cmp::Ordering;

use kane_kernel::{
    Atom, Finding, Fuel, Germ, Limit, Poly, Proof, Side, SideProof, Sign, State, claim_state,
    constants, differs, inside_goal, inside_state, misses, owed, scope,
};

use super::NotEmitted;
use super::chain::{Along, Form};
use super::family::{Claimed, Family, Setting, side};
use super::prose::Prose;
use super::reify::Symbols;
use super::script::{Writer, sign};

impl Family<'_, '_> {
    /// A limit, from a proof for each of its sides.
    pub(super) fn limit(
        &self,
        name: &str,
        limit: &Limit,
        proofs: &[SideProof],
    ) -> Result<(String, Form), NotEmitted> {
        let state = constants(self.scope, self.goal, self.x)?;
        let writer = Writer { symbols: &self.symbols, sides: Some(RefCell::default()) };
        let written = |v: usize| self.written(v);
        let prose = Prose { name: &written, symbols: &self.symbols };
        let Claimed { sides, f, to, target } = self.claimed(limit)?;
        let parts = writer.side_proofs(&state, limit, proofs)?;
        let says = self.tends(&prose, (&f, &to, &sides))?;
        let setting = Setting::Set { used: writer.sides(), point: false };
        let arguments = format!(
            "goal_{name} {} {} {target} proof_{name}",
            writer.used(),
            self.symbols.expr(&f)?
        );
        let by = format!(
            "limit_proved _ _ _ _ _ {} _\n    (eq_refl true <: proves_limit {arguments} = true) eq_refl",
            self.sets(&setting)
        );
        let text = format!(
            "{}Definition proof_{name} : list (side * side_proof) :=\n  {parts}.\n{}",
            self.data(name, "Falsehood")?,
            self.lemma(name, &self.statement(&prose, &says, &setting)?, &by, &setting),
        );
        Ok((text, self.form(&prose, setting)?))
    }

    /// A claim at each point, from a contradiction that may pass to limits.
    pub(super) fn point(
        &self,
        name: &str,
        finding: Finding,
        proof: &Proof,
    ) -> Result<(String, Form), NotEmitted> {
        let state = claim_state(self.scope, self.goal, finding)?;
        let writer = Writer { symbols: &self.symbols, sides: Some(RefCell::default()) };
        let script = writer.proof(&state, proof)?;
        let written = |v: usize| self.written(v);
        let prose = Prose { name: &written, symbols: &self.symbols };
        let setting = Setting::Set { used: writer.sides(), point: true };
        let (claim, says) = self.pointwise(&prose, finding, &setting)?;
        let arguments = format!("goal_{name} {} proof_{name}", writer.used());
        let by = format!(
            "point_proved _ _ _ {} _\n    (eq_refl true <: proves_point {arguments} = true)",
            self.sets(&setting)
        );
        let text = format!(
            "{}Definition proof_{name} : proof :=\n  {script}.\n{}",
            self.data(name, &claim)?,
            self.lemma(name, &self.statement(&prose, &says, &setting)?, &by, &setting),
        );
        Ok((text, self.form(&prose, setting)?))
    }

    /// How the lemma is applied.
    fn form(&self, prose: &Prose<'_>, setting: Setting) -> Result<Form, NotEmitted> {
        let slots = self.supposed(prose, &setting)?.into_iter().map(|s| s.0).collect();
        let set = self.has_set(&setting);
        let along = Some(Along { x: self.x, slots, set, always_when: self.always_when });
        let symbols = self.symbols.order.clone();
        Ok(Form { symbols, roots: Vec::new(), slopes: Vec::new(), along })
    }
}

impl Writer<'_> {
    /// Remembers that a limit is taken from this side.
    fn uses(&self, side: &Side) {
        if let Some(sides) = &self.sides {
            let mut sides = sides.borrow_mut();
            if !sides.contains(side) {
                sides.push(side.clone());
            }
        }
    }

    /// The sides from which limits were taken so far.
    fn sides(&self) -> Vec<Side> {
        self.sides.as_ref().map(|s| s.borrow().clone()).unwrap_or_default()
    }

    /// All of them, as data.
    pub(super) fn used(&self) -> String {
        let sides: Vec<String> = self.sides().iter().map(side).collect();
        format!("[{}]", sides.join("; "))
    }

    /// Proofs of a limit, each with its side.
    pub(super) fn side_proofs(
        &self,
        state: &State<'_, '_>,
        limit: &Limit,
        proofs: &[SideProof],
    ) -> Result<String, NotEmitted> {
        let mut parts = Vec::new();
        for p in proofs {
            let data = self.side_proof(state, limit, p)?;
            parts.push(format!("({}, {data})", side(&p.germ.side)));
        }
        Ok(format!("[{}]", parts.join(";\n   ")))
    }

    /// A proof of a limit from one side.
    pub(super) fn side_proof(
        &self,
        state: &State<'_, '_>,
        limit: &Limit,
        p: &SideProof,
    ) -> Result<String, NotEmitted> {
        let lower = self.bound(state, limit, p)?;
        match &p.upper {
            None => Ok(format!("By ({lower})")),
            Some(upper) => Ok(format!("Between ({lower}) ({})", self.bound(state, limit, upper)?)),
        }
    }

    /// How a function compares with a quotient along a germ, and where that ends.
    fn bound(
        &self,
        state: &State<'_, '_>,
        limit: &Limit,
        p: &SideProof,
    ) -> Result<String, NotEmitted> {
        if matches!(limit.compared(state.scope), Cow::Owned(_)) {
            return Err(NotEmitted::Step("a limit with a root of its own"));
        }
        self.uses(&p.germ.side);
        let germ = self.germ(state, &p.germ)?;
        let along = state.along_unproved(&p.germ)?;
        let wrong = differs(state.scope, &limit.compared(state.scope), (&p.num, &p.den), p.sense)?;
        let comparison = self.proof(&along.with_cases(wrong), &p.along)?;
        let sense = match p.sense {
            Ordering::Less => "AtMost",
            Ordering::Equal => "Same",
            Ordering::Greater => "AtLeast",
        };
        let misses = misses(state, &p.germ.side, (&p.num, &p.den, p.order), &limit.to)?;
        let ends = self.proof(&state.with_cases(misses), &p.at_zero)?;
        Ok(format!(
            "Bound {germ} {} {} {} {sense} {comparison} {ends}",
            self.poly(&p.num)?,
            self.poly(&p.den)?,
            p.order
        ))
    }

    /// The radius, and that it is positive. That the germ lies where premises hold is supposed.
    fn germ(&self, state: &State<'_, '_>, germ: &Germ) -> Result<String, NotEmitted> {
        Ok(format!("{} (Assume 0 [])", self.radius(state, germ)?))
    }

    fn radius(&self, state: &State<'_, '_>, germ: &Germ) -> Result<String, NotEmitted> {
        if germ.power != 1 {
            return Err(NotEmitted::Step("a germ along a power of t"));
        }
        let (num, den) = &germ.radius;
        let fails = |p: &Poly| vec![Atom::new(p.clone(), Sign::Positive).not()];
        let radius = state.with_cases(vec![fails(num), fails(den)]);
        let positive = self.proof(&radius, &germ.positive)?;
        Ok(format!("{} {} {positive}", self.poly(num)?, self.poly(den)?))
    }

    /// That a germ lies where premises about the variable alone hold; `count` of them narrow it.
    pub(super) fn within(
        &self,
        state: &State<'_, '_>,
        germ: &Germ,
        count: usize,
    ) -> Result<String, NotEmitted> {
        let (radius, owed) = (self.radius(state, germ)?, owed(state, &germ.side));
        if owed.len() != count || germ.inside.len() != count {
            return Err(NotEmitted::Step("a domain that a cited claim narrows"));
        }
        let mut proofs = Vec::new();
        for (given, inside) in owed.into_iter().zip(&germ.inside) {
            let goal = inside_goal(state, &germ.side, given, &inside.values)?;
            let scope = scope(&goal, Fuel::new(u64::MAX))?;
            if scope.mentioned.iter().any(|v| *v != germ.side.var) {
                return Err(NotEmitted::Step("a domain that depends on constants"));
            }
            let symbols = Symbols::with(&scope, 1, Some(germ.side.var))?;
            let writer = Writer { symbols: &symbols, sides: None };
            proofs.push(writer.proof(&inside_state(state, germ, &scope, &goal)?, &inside.proof)?);
        }
        Ok(format!("({}, Within {radius} [{}])", side(&germ.side), proofs.join("; ")))
    }

    /// What holds along a germ, at its end.
    pub(super) fn pass(
        &self,
        state: &State<'_, '_>,
        (germ, atom): (&Germ, &Atom),
        (along, then): (&Proof, &Proof),
    ) -> Result<String, NotEmitted> {
        if self.sides.is_none() {
            return Err(NotEmitted::Step("a passage to the limit"));
        }
        self.uses(&germ.side);
        let radius = self.germ(state, germ)?;
        let along = self.proof(&state.along_unproved(germ)?.with(atom.not()), along)?;
        let then = self.proof(&state.with(state.at_zero(germ, atom)?), then)?;
        let sign = sign(atom.sign);
        let atom = format!("(A {} {sign})", self.poly(&atom.poly)?);
        Ok(format!("(Pass {} {radius} {atom} {along} {then})", side(&germ.side)))
    }
}
