//! Coq: one file a document, in which every lemma has to pass.

use std::fs;
use std::path::{Path, PathBuf};

use crate::coq::{File, THEORY, shared_theory};
use crate::{Answer, Judge};

use super::process::{Scratch, run};
use super::{Limits, NotAsked, is_installed};

/// What proofs may rest on: the axioms of the classical real numbers of Coq's library. The third
/// stands behind the completeness of the reals alone, which a witness at an algebraic number needs.
pub const ALLOWED_AXIOMS: [&str; 3] = [
    "ClassicalDedekindReals.sig_forall_dec",
    "FunctionalExtensionality.functional_extensionality_dep",
    "ClassicalDedekindReals.sig_not_dec",
];

/// Lemmas that may be rejected before Coq is no longer asked about the rest.
const MAX_REJECTED: usize = 20;

/// The whole theory, compiled once for many files: each of them then proves its lemmas and no more.
#[derive(Debug)]
pub struct Theory {
    folder: PathBuf,
    /// holds the folder, if it is ours
    _scratch: Option<Scratch>,
}

impl Theory {
    /// Has Coq compile the theory, for as long as this value is there.
    ///
    /// # Errors
    /// [`NotAsked`].
    pub fn new(limits: &Limits) -> Result<Self, NotAsked> {
        let scratch = Scratch::new().map_err(failed)?;
        let theory = Self::within(scratch.0.clone(), limits)?;
        Ok(Self { _scratch: Some(scratch), ..theory })
    }

    /// Has Coq compile the theory in this folder, which is made if need be and stays.
    ///
    /// # Errors
    /// [`NotAsked`].
    pub fn within(folder: PathBuf, limits: &Limits) -> Result<Self, NotAsked> {
        if !is_installed("coqc") {
            return Err(NotAsked::NotInstalled("coqc"));
        }
        let name = format!("{THEORY}.v");
        fs::create_dir_all(&folder).map_err(failed)?;
        fs::write(folder.join(&name), shared_theory()).map_err(failed)?;
        let said = run("coqc", &["-q", &name], &folder, limits.file).map_err(failed)?;
        let why = match said {
            Some(said) if said.success => return Ok(Self { folder, _scratch: None }),
            Some(said) => brief(&said.err),
            None => format!("no answer within {} s", limits.file.as_secs()),
        };
        Err(NotAsked::Failed(format!("coqc: {why}")))
    }

    /// Asks Coq about a file that shares this theory.
    ///
    /// # Errors
    /// [`NotAsked`].
    pub fn ask(&self, file: &File, limits: &Limits) -> Result<Judge, NotAsked> {
        ask(file, Some(&self.folder), limits)
    }
}

/// Asks Coq about a file as it is written, with its own theory.
///
/// # Errors
/// [`NotAsked`].
pub fn ask_coq(file: &File, limits: &Limits) -> Result<Judge, NotAsked> {
    ask(file, None, limits)
}

fn failed(error: std::io::Error) -> NotAsked {
    NotAsked::Failed(format!("coqc: {error}"))
}

/// Asks Coq about a file beside the theory in a folder, or one with its own.
fn ask(file: &File, theory: Option<&Path>, limits: &Limits) -> Result<Judge, NotAsked> {
    if !is_installed("coqc") {
        return Err(NotAsked::NotInstalled("coqc"));
    }
    let written = if theory.is_some() { File::beside_theory_without } else { File::without };
    let theory = theory.map(|folder| folder.to_string_lossy().into_owned());
    let mut arguments = vec!["-q"];
    arguments.extend(theory.iter().flat_map(|folder| ["-Q", folder, ""]));
    arguments.push("claims.v");
    let mut judge = Judge { name: "Coq".to_owned(), asked: true, ..Judge::default() };
    let mut rejected: Vec<(String, String)> = Vec::new();
    let ended = loop {
        let without: Vec<&str> = rejected.iter().map(|r| r.0.as_str()).collect();
        let folder = Scratch::new().map_err(failed)?;
        let text = written(file, &without);
        fs::write(folder.0.join("claims.v"), &text).map_err(failed)?;
        let said = run("coqc", &arguments, &folder.0, limits.file).map_err(failed)?;
        let Some(said) = said else {
            break Some(format!("no answer within {} s", limits.file.as_secs()));
        };
        if said.success {
            judge.axioms = axioms(&said.out);
            break None;
        }
        let why = said.err.trim().to_owned();
        match line(&why).and_then(|line| file.lemma_at(line, &text)) {
            Some(name) if rejected.len() < MAX_REJECTED => {
                rejected.push((name.to_owned(), brief(&why)));
            }
            Some(_) => break Some("too many lemmas before it are rejected".to_owned()),
            None => return Err(NotAsked::Failed(format!("coqc: {}", brief(&why)))),
        }
    };
    let strange = judge.axioms.iter().find(|a| !ALLOWED_AXIOMS.contains(&a.as_str())).cloned();
    let without: Vec<&str> = rejected.iter().map(|r| r.0.as_str()).collect();
    let theorems = file.theorems(&without);
    for lemma in &file.lemmas {
        let answer = match &lemma.name {
            Err(why) => Answer::NotAsked(format!("not emitted: {why}")),
            Ok(name) => match (rejected.iter().find(|r| r.0 == *name), &ended, &strange) {
                (Some((_, why)), ..) => Answer::Disagrees(why.clone()),
                (None, Some(why), _) => Answer::Undecided(why.clone()),
                (None, None, Some(axiom)) => Answer::Disagrees(format!("rests on {axiom}")),
                (None, None, None) => match &lemma.theorem {
                    Some(Err(why)) => Answer::Partly(why.to_string()),
                    Some(Ok(t)) if !theorems.contains(t.name.as_str()) => {
                        Answer::Partly("it rests on a claim that is rejected".to_owned())
                    }
                    _ => Answer::Agrees,
                },
            },
        };
        judge.answers.insert((lemma.statement, lemma.link), answer);
    }
    Ok(judge)
}

/// The names behind `Axioms:`, each of which begins a line.
fn axioms(out: &str) -> Vec<String> {
    let list = out.split("Axioms:").nth(1).unwrap_or_default();
    let begins = |l: &&str| l.starts_with(|c: char| c.is_alphabetic());
    let mut names: Vec<String> = list
        .lines()
        .filter(begins)
        .filter_map(|l| l.split_whitespace().next().map(str::to_owned))
        .collect();
    names.sort();
    names
}

/// The line of an error message.
fn line(message: &str) -> Option<usize> {
    let rest = message.split(", line ").nth(1)?;
    rest.split(|c: char| !c.is_ascii_digit()).next()?.parse().ok()
}

/// What went wrong, on one line.
fn brief(message: &str) -> String {
    let said = message.split("Error:").nth(1).unwrap_or(message);
    let words: Vec<&str> = said.split_whitespace().collect();
    words.join(" ").chars().take(200).collect()
}
