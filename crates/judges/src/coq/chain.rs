//! Theorems from the givens: the lemmas of a document, applied to one another.
//!
//! A lemma says what follows from the statements that a claim cites. Its theorem says what follows
//! from the givens on which the claim rests through all claims in between.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

use kane_audit::{Accepted, Body, Content, Document};
use kane_kernel::{Certificate, Evidence, Expr, Hypothesis, Link, Relation, Sentence};

use super::NotEmitted;
use super::conclusion::{behind, conclusion};
use super::family::Slot;
use super::prose::{Prose, conj, grouped};
use super::reify::Symbols;
use super::slopes::{FIRST, Slope};

/// Why a claim has a lemma, but no theorem.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Unchained {
    /// a cited claim has none
    #[error("no theorem from the givens: it cites {0}")]
    Cited(String),
    /// it is about functions
    #[error("no theorem from the givens: it is about limits")]
    Limits,
    /// a part of it cannot be said
    #[error("no theorem from the givens: {0}")]
    NotEmitted(#[from] NotEmitted),
}

/// How a lemma or a theorem is applied: its symbols, its roots and derivatives, and its premises.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Form {
    pub(super) symbols: Vec<usize>,
    pub(super) roots: Vec<Expr>,
    pub(super) slopes: Vec<Slope>,
    /// for functions of a variable
    pub(super) along: Option<Along>,
}

/// How what speaks of functions is applied.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Along {
    /// the variable
    pub(super) x: usize,
    /// its premises, in order
    pub(super) slots: Vec<Slot>,
    /// whether there is a set on which premises hold
    pub(super) set: bool,
    /// whether the claim's own conditions are one of the premises
    pub(super) always_when: bool,
}

/// A claim as it follows from givens.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Theorem {
    /// its name
    pub name: String,
    /// its part of the file
    pub(super) text: String,
    /// the theorems to which it is applied
    pub(super) needs: Vec<String>,
    pub(super) form: Form,
    /// statements, in the order of its premises
    pub(super) givens: Vec<usize>,
    /// whether the claim's own conditions are a premise
    pub(super) when: bool,
}

/// The theorems of a document, by statement and link.
pub(super) type Theorems = BTreeMap<(usize, usize), Theorem>;

/// The place of a link among the claims of a document, and what is known of it.
pub(super) struct Place<'a> {
    pub(super) document: &'a Document,
    pub(super) statement: usize,
    pub(super) rests_on: &'a [usize],
    pub(super) accepted: &'a Accepted,
    pub(super) form: &'a Form,
}

/// The relations of a claim and its conditions.
pub(super) fn said(document: &Document, statement: usize) -> Option<Sentence> {
    match &document.statements[statement].body {
        Body::Given(s) => Some(s.clone()),
        Body::Claim(claim) => match &claim.content {
            Content::Links(links) => Some(Sentence {
                when: claim.when.clone(),
                links: links.iter().map(|(l, _)| l.clone()).collect(),
            }),
            _ => None,
        },
        Body::Let(_) | Body::Defined(_) => None,
    }
}

impl Place<'_> {
    /// The statements behind the premises of the goal.
    pub(super) fn cited(&self) -> Result<Vec<usize>, Unchained> {
        let hypotheses = &self.accepted.goal.hypotheses;
        let Body::Claim(claim) = &self.document.statements[self.statement].body else {
            return Err(NotEmitted::Symbol.into());
        };
        // base and step have lemmas; that they make a claim for all n is not said to Coq
        if claim.induction.is_some() {
            return Err(NotEmitted::Step("an induction").into());
        }
        let mut all: Vec<usize> = Vec::new();
        for i in claim.from.iter().chain(self.rests_on).copied() {
            if said(self.document, i).is_some() && !all.contains(&i) {
                all.push(i);
            }
        }
        all.truncate(hypotheses.len());
        let supposes = |&i: &usize| {
            Some(Hypothesis { sentence: said(self.document, i)?, given: self.is_given(i) })
        };
        match all.iter().filter_map(supposes).eq(hypotheses.iter().cloned()) {
            true => Ok(all),
            false => Err(NotEmitted::Step("a premise that the document does not have").into()),
        }
    }

    pub(super) fn is_given(&self, i: usize) -> bool {
        matches!(self.document.statements[i].body, Body::Given(_))
    }

    /// The theorem of a claim at a point, from its lemma `claim_NAME`.
    pub(super) fn theorem(&self, name: &str, known: &Theorems) -> Result<Theorem, Unchained> {
        let (lemma, name) = (format!("claim_{name}"), format!("theorem_{name}"));
        if let Some(along) = &self.form.along {
            return self.along(lemma, name, along.x, known);
        }
        let (cited, goal) = (self.cited()?, &self.accepted.goal);
        let when = !goal.when.is_empty();
        if cited.iter().all(|i| self.is_given(*i)) {
            let text = format!("Definition {name} := {lemma}.\n");
            let (form, needs) = (self.form.clone(), Vec::new());
            return Ok(Theorem { name, text, needs, form, givens: cited, when });
        }
        let mut used: Vec<&Theorem> = Vec::new();
        for &i in cited.iter().filter(|i| !self.is_given(**i)) {
            for link in 0..said(self.document, i).map_or(0, |s| s.links.len()) {
                let label = || Unchained::Cited(self.document.statements[i].label.clone());
                used.push(known.get(&(i, link)).ok_or_else(label)?);
            }
        }
        if let Some(along) = used.iter().find_map(|t| t.form.along.as_ref()) {
            return self.along(lemma, name, along.x, known);
        }
        let forms = || used.iter().map(|t| &t.form).chain([self.form]);
        let union: BTreeSet<usize> = forms().flat_map(|f| f.symbols.iter().copied()).collect();
        let (mut roots, mut slopes) = (Vec::new(), Vec::new());
        forms().flat_map(|f| &f.roots).for_each(|r| add(&mut roots, r));
        forms().flat_map(|f| &f.slopes).for_each(|s| add(&mut slopes, s));
        let symbols = Symbols::of(&self.document.context, union, roots, slopes);
        let prose = Prose { name: &|v| symbols.name(v), symbols: &symbols };
        let context = Chained::new(&symbols, self.rests_on.to_vec());
        let (statement, before) = self.statement(&prose)?;
        let mut holes = String::new();
        let mut premises = Vec::new();
        for &i in &cited {
            if let Some(given) = context.given(i) {
                premises.push(given);
                continue;
            }
            premises.push("_".to_owned());
            let _ = writeln!(holes, "  {{ {} }}", self.follows(&prose, &context, i, known)?);
        }
        premises.extend(when.then(|| context.when.clone()));
        let proof = format!(
            "Proof. intros {}.\n  refine ({lemma} {} {}).\n{holes}Qed.\n",
            context.all(when).join(" "),
            context.arguments(self.form)?,
            premises.join(" "),
        );
        let form = Form {
            symbols: symbols.order.clone(),
            roots: symbols.roots.iter().map(|r| r.1.clone()).collect(),
            slopes: symbols.slopes(),
            along: None,
        };
        if before != symbols.slopes().len() {
            return Err(NotEmitted::Step("a derivative that no claim mentions").into());
        }
        let mut needs: Vec<String> = used.iter().map(|t| t.name.clone()).collect();
        needs.dedup();
        let text = format!("Theorem {name} :\n  {statement}.\n{proof}");
        Ok(Theorem { name, text, needs, form, givens: self.rests_on.to_vec(), when })
    }

    /// What the theorem says, and the number of derivatives that were known before it was said.
    fn statement(&self, prose: &Prose<'_>) -> Result<(String, usize), NotEmitted> {
        let (symbols, goal) = (prose.symbols, &self.accepted.goal);
        let before = symbols.slopes().len();
        let (names, known) = behind(symbols)?;
        let all: Vec<String> =
            symbols.order.iter().map(|v| symbols.name(*v)).chain(names).collect();
        let mut text = String::new();
        if !all.is_empty() {
            let _ = write!(text, "forall {} : R,\n  ", all.join(" "));
        }
        text += &known.concat();
        let mut premises = Vec::new();
        for r in symbols.order.iter().flat_map(|v| symbols.range(*v)) {
            premises.push(prose.relation(&r)?);
        }
        for &i in self.rests_on {
            let given = said(self.document, i).ok_or(NotEmitted::Symbol)?;
            premises.push(prose.sentence(&given, true)?);
        }
        if !goal.when.is_empty() {
            premises.push(conj(&prose.flat(&symbols.expanded(&goal.when)?)?));
        }
        for p in premises {
            let _ = write!(text, "{} ->\n  ", grouped(&p));
        }
        text += &conclusion(prose, goal, self.accepted.certificate.finding)?.1;
        Ok((text, before))
    }

    /// That a cited claim is true where it is defined, by its own theorems.
    fn follows(
        &self,
        prose: &Prose<'_>,
        context: &Chained<'_>,
        i: usize,
        known: &Theorems,
    ) -> Result<String, Unchained> {
        let symbols = prose.symbols;
        let sentence = said(self.document, i).ok_or(NotEmitted::Symbol)?;
        let mut script = String::new();
        let there = symbols.fresh("There");
        if !sentence.when.is_empty() {
            let _ = write!(script, "intro {there}. ");
        }
        let last = sentence.links.len().saturating_sub(1);
        for (link, said) in sentence.links.iter().enumerate() {
            let Link::Relation(r) = said else {
                return Err(Unchained::Limits);
            };
            let r: Relation = symbols.expanded([r])?.remove(0);
            if !prose.defined(&r)?.is_empty() {
                script += "intros _. ";
            }
            let theorem = known.get(&(i, link)).ok_or(Unchained::Limits)?;
            let mut applied = context.applied(theorem)?;
            if theorem.when {
                let _ = write!(applied, " {there}");
            }
            match link == last {
                true => _ = write!(script, "ends ({applied})."),
                false => _ = write!(script, "split. {{ ends ({applied}). }} "),
            }
        }
        Ok(script)
    }
}

fn add<T: Clone + PartialEq>(all: &mut Vec<T>, one: &T) {
    if !all.contains(one) {
        all.push(one.clone());
    }
}

/// The names under which a proof has its premises.
struct Chained<'a> {
    symbols: &'a Symbols<'a>,
    known: Vec<String>,
    /// one for each end of the declared range of a symbol
    ranges: Vec<(usize, String)>,
    givens: Vec<(usize, String)>,
    when: String,
}

impl<'a> Chained<'a> {
    fn new(symbols: &'a Symbols<'a>, givens: Vec<usize>) -> Self {
        let ends: Vec<usize> =
            symbols.order.iter().flat_map(|v| vec![*v; symbols.range(*v).len()]).collect();
        let named = |all: Vec<usize>, name: &str| {
            let names = symbols.numbered(name, all.len());
            all.into_iter().zip(names).collect::<Vec<_>>()
        };
        Self {
            symbols,
            known: symbols.known(symbols.roots.len() + symbols.slopes().len()),
            ranges: named(ends, "Range"),
            givens: named(givens, "Given"),
            when: symbols.fresh("When"),
        }
    }

    fn all(&self, when: bool) -> Vec<String> {
        let symbols = self.symbols.order.iter().map(|v| self.symbols.name(*v));
        let roots = self.symbols.roots.iter().map(|r| self.symbols.name(r.0));
        let slopes = self.symbols.slope_names();
        let mut out: Vec<String> = symbols.chain(roots).chain(slopes).collect();
        out.extend(self.known.iter().cloned());
        out.extend(self.ranges.iter().chain(&self.givens).map(|r| r.1.clone()));
        out.extend(when.then(|| self.when.clone()));
        out
    }

    fn given(&self, i: usize) -> Option<String> {
        self.givens.iter().find(|g| g.0 == i).map(|g| g.1.clone())
    }

    /// Symbols, roots, derivatives, what is known of them, and declared ranges.
    fn arguments(&self, form: &Form) -> Result<String, NotEmitted> {
        let symbols = self.symbols;
        let mut out: Vec<String> = form.symbols.iter().map(|v| symbols.name(*v)).collect();
        let mut known = Vec::new();
        for root in &form.roots {
            let place = symbols.roots.iter().position(|r| r.1 == *root);
            let place = place.ok_or(NotEmitted::Symbol)?;
            out.push(symbols.name(symbols.roots[place].0));
            known.push(self.known[place].clone());
        }
        for slope in &form.slopes {
            let place = symbols.slopes().iter().position(|s| s == slope);
            let place = place.ok_or(NotEmitted::Symbol)?;
            out.push(symbols.name(FIRST + place));
            known.push(self.known[symbols.roots.len() + place].clone());
        }
        out.extend(known);
        for v in &form.symbols {
            out.extend(self.ranges.iter().filter(|r| r.0 == *v).map(|r| r.1.clone()));
        }
        Ok(out.join(" "))
    }

    /// A theorem on the same symbols.
    fn applied(&self, theorem: &Theorem) -> Result<String, NotEmitted> {
        let mut out = format!("{} {}", theorem.name, self.arguments(&theorem.form)?);
        for i in &theorem.givens {
            let _ = write!(out, " {}", self.given(*i).ok_or(NotEmitted::Symbol)?);
        }
        Ok(out)
    }
}

/// Whether a certificate shows that something follows.
pub(super) fn concludes(certificate: &Certificate) -> bool {
    !matches!(certificate.evidence, Evidence::Model(_))
}
