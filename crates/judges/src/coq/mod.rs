//! Coq: every judged claim as a lemma over the real numbers, its proof built from the certificate
//! that the kernel accepted.
//!
//! The file begins with a theory: the rules of proof and their soundness, proved in Coq itself. Then
//! follows, for each link of each claim, the goal as data, the certificate as data, and a lemma that
//! says the claim in full; Coq compares the lemma with the data by computation, and runs the rules
//! on the certificate. Claims about limits are lemmas about functions, with epsilon and delta written
//! out.
//!
//! What a lemma cannot say is not emitted, with the reason in the file.

mod chain;
mod chain_along;
mod conclusion;
mod family;
mod functions;
mod lemma;
mod limits;
mod prose;
mod reify;
mod script;
mod slopes;
mod theory;
mod witness;

use std::collections::BTreeSet;
use std::fmt::Write as _;

use kane_audit::Accepted;
use kane_kernel::Rejection;

use crate::Claims;
use chain::{Place, Theorems, concludes};
pub use chain::{Theorem, Unchained};
use reify::OWN;
use theory::{Part, has_word, theory};

/// The name of the library that [`shared_theory`] is.
pub const THEORY: &str = "kane_theory";

/// What a file begins with that shares its theory.
const SHARED: &str = "\
(* Proofs of a derivation, checked by Coq and its standard library alone. The theory, which the files of a site share, is
   in kane_theory.v: compile that first, and then this file in the same directory. *)

From Coq Require Import Reals Lra List ZArith Bool Arith.
Import ListNotations.
Open Scope R_scope.
Require Import kane_theory.
";

/// The whole theory as a library of its own, for files by [`File::beside_theory`].
#[must_use]
pub fn shared_theory() -> String {
    theory::whole()
}

/// A file's stem as the name of a library, which is all that Coq compiles: letters, digits, underscores.
#[must_use]
pub fn library(stem: &str) -> String {
    let plain = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
    let name: String = stem.chars().map(plain).collect();
    if name.starts_with(|c: char| c.is_ascii_digit()) { format!("_{name}") } else { name }
}

/// Why a certificate is not turned into a lemma.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum NotEmitted {
    /// a symbol that the lemma does not have
    #[error("a symbol without a name")]
    Symbol,
    /// a step that has no counterpart
    #[error("{0}")]
    Step(&'static str),
    /// the kernel does not follow
    #[error("{0}")]
    Kernel(#[from] Rejection),
}

/// A link of a claim in the file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Lemma {
    /// index of the statement
    pub statement: usize,
    /// index of the link in it
    pub link: usize,
    /// the lemma's name, or why there is none
    pub name: Result<String, NotEmitted>,
    /// its part of the file
    pub text: String,
    /// that it follows from the givens, or why that is not said; `None` for what does not follow
    pub theorem: Option<Result<Theorem, Unchained>>,
    /// what it needs of the theory
    parts: Vec<Part>,
}

/// A document in Coq.
#[derive(Clone, Debug)]
pub struct File {
    title: String,
    /// what became of the links that have a verdict, in order
    pub lemmas: Vec<Lemma>,
}

impl File {
    /// The whole file.
    #[must_use]
    pub fn text(&self) -> String {
        self.without(&[])
    }

    /// What the file begins with: the rules of proof that it needs, and that they are sound.
    #[must_use]
    pub fn theory(&self) -> String {
        theory(&self.lemmas.iter().flat_map(|l| l.parts.clone()).collect::<Vec<_>>())
    }

    /// The file for a directory that has [`shared_theory`]: the same lemmas behind a line that loads it.
    #[must_use]
    pub fn beside_theory(&self) -> String {
        self.beside_theory_without(&[])
    }

    /// [`Self::beside_theory`] without the lemmas of these names.
    #[must_use]
    pub fn beside_theory_without(&self, names: &[&str]) -> String {
        self.behind(SHARED, names)
    }

    /// The file without the lemmas of these names.
    #[must_use]
    pub fn without(&self, names: &[&str]) -> String {
        self.behind(&self.theory(), names)
    }

    /// The lemmas but those of these names behind what the file begins with.
    fn behind(&self, head: &str, names: &[&str]) -> String {
        let mut text = format!("{head}\n(** * {} *)\n", self.title);
        let mut kept = Vec::new();
        let theorems = self.theorems(names);
        for lemma in &self.lemmas {
            match &lemma.name {
                Ok(name) if names.contains(&name.as_str()) => continue,
                Ok(name) => kept.push(name.as_str()),
                Err(_) => {}
            }
            text.push_str(&lemma.text);
            match &lemma.theorem {
                Some(Ok(theorem)) if theorems.contains(theorem.name.as_str()) => {
                    text.push_str(&theorem.text);
                    kept.push(&theorem.name);
                }
                Some(Err(why)) => _ = writeln!(text, "(* {} *)", comment(&why.to_string())),
                _ => {}
            }
        }
        if !kept.is_empty() {
            text.push_str("\n(** All of them, for a look at what they rest on. *)\n");
            // a tuple would say the type of what is left at each of its commas
            text.push_str("Definition all_claims : True :=\n");
            kept.iter().for_each(|name| _ = writeln!(text, "  let _ := @{name} in"));
            text.push_str("  I.\n");
            text.push_str("Print Assumptions all_claims.\n");
        }
        text
    }

    /// The theorems that the file has without the lemmas of these names: those of the others that
    /// need none of them.
    #[must_use]
    pub fn theorems(&self, without: &[&str]) -> BTreeSet<&str> {
        let mut all = BTreeSet::new();
        for lemma in &self.lemmas {
            let there = lemma.name.as_ref().is_ok_and(|n| !without.contains(&n.as_str()));
            if let (true, Some(Ok(theorem))) = (there, &lemma.theorem)
                && theorem.needs.iter().all(|n| all.contains(n.as_str()))
            {
                all.insert(theorem.name.as_str());
            }
        }
        all
    }

    /// The lemma to which a line of the file's text belongs.
    #[must_use]
    pub fn lemma_at(&self, line: usize, text: &str) -> Option<&str> {
        let before = text.lines().take(line).collect::<Vec<_>>();
        let heading = before.iter().rev().find_map(|l| l.strip_prefix("Definition goal_"))?;
        let label = heading.split_whitespace().next()?;
        let named = |label: &str| {
            let name = format!("claim_{label}");
            self.lemmas.iter().filter_map(|l| l.name.as_deref().ok()).find(|n| *n == name)
        };
        named(label).or_else(|| named(label.strip_prefix("met_")?))
    }
}

/// The judged claims of a document as one file. Links without a verdict are left out.
#[must_use]
pub fn file(claims: &Claims<'_>) -> File {
    let audit = claims.audit;
    let document = &audit.document;
    let title = comment(document.title.as_deref().unwrap_or(&document.name));
    let (mut lemmas, mut names) = (Vec::new(), BTreeSet::new());
    let mut theorems = Theorems::new();
    for asked in claims.links() {
        let Some(accepted) = &asked.judged.accepted else {
            continue;
        };
        let (statement, link) = asked.place;
        let mut name = asked.name();
        let taken = |name: &str| OWN.iter().any(|own| has_word(&format!("{own}{name}")));
        while taken(&name) || !names.insert(name.clone()) {
            name.push('\'');
        }
        let said = document.link(statement, link);
        let heading = format!("{}: {said} ({})", asked.label, asked.judged.verdict);
        let mut text = format!("\n(** {} *)\n", comment(&heading));
        let emitted = lemma::lemma(&name, accepted);
        let mut parts = vec![Part::Points];
        match &emitted {
            Ok(lemma) => {
                text.push_str(&lemma.text);
                parts.push(lemma.part);
            }
            Err(why) => {
                let _ = writeln!(text, "(* not emitted: {} *)", comment(&why.to_string()));
            }
        }
        let follows = concludes(&accepted.certificate);
        let theorem = emitted.as_ref().ok().filter(|_| follows).map(|lemma| {
            let rests_on = &audit.judgements[statement].rests_on;
            let form = lemma.form.as_ref().ok_or(Unchained::Limits)?;
            Place { document, statement, rests_on, accepted, form }.theorem(&name, &theorems)
        });
        if follows && emitted.is_ok() && link == 0 {
            let met = audit.judgements[statement].met.as_deref();
            let (premises, needs) = premises_met(&name, accepted, met);
            text.push_str(&premises);
            parts.extend(needs);
        }
        if let Some(Ok(theorem)) = &theorem {
            theorems.insert((statement, link), theorem.clone());
        }
        let name = emitted.map(|_| format!("claim_{name}"));
        lemmas.push(Lemma { statement, link, name, text, theorem, parts });
    }
    File { title, lemmas }
}

/// That the premises of a lemma can be met, if a model of them is known, as an example.
fn premises_met(name: &str, accepted: &Accepted, met: Option<&Accepted>) -> (String, Option<Part>) {
    let goal = &accepted.goal;
    if goal.hypotheses.is_empty() && goal.when.is_empty() {
        return (String::new(), None);
    }
    let Some(met) = met else {
        return ("(* no model of the premises is known *)\n".to_owned(), None);
    };
    match lemma::lemma(&format!("met_{name}"), met) {
        Ok(lemma) => {
            let text = lemma.text.replace("Lemma claim_met_", "Example met_");
            (format!("(* its premises can be met *)\n{text}"), Some(lemma.part))
        }
        Err(why) => {
            let why = comment(&why.to_string());
            (format!("(* its premises can be met; the model is not emitted: {why} *)\n"), None)
        }
    }
}

/// Text that does not end a comment.
fn comment(text: &str) -> String {
    text.replace("(*", "( *").replace("*)", "* )").replace('"', "'")
}
