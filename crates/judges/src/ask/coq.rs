//! Coq: one file a document, in which every lemma has to pass.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::coq::{File, THEORY, shared_theory};
use crate::{Answer, Judge};

use super::process::{Said, Scratch, run};
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

fn failed(error: io::Error) -> NotAsked {
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
    let coqc = |text: &str| {
        let folder = Scratch::new()?;
        fs::write(folder.0.join("claims.v"), text)?;
        run("coqc", &arguments, &folder.0, limits.file)
    };
    heard(file, written, limits, coqc)
}

/// What Coq says of the lemmas of a file, from what it says of texts: a lemma that is rejected is left out of the next.
fn heard(
    file: &File,
    written: fn(&File, &[&str]) -> String,
    limits: &Limits,
    mut coqc: impl FnMut(&str) -> io::Result<Option<Said>>,
) -> Result<Judge, NotAsked> {
    let mut judge = Judge { name: "Coq".to_owned(), asked: true, ..Judge::default() };
    let mut rejected: Vec<(String, String)> = Vec::new();
    let ended = loop {
        let without: Vec<&str> = rejected.iter().map(|r| r.0.as_str()).collect();
        let text = written(file, &without);
        let Some(said) = coqc(&text).map_err(failed)? else {
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

#[cfg(test)]
mod tests {
    use kane_audit::{Options, audit, read};

    use super::*;
    use crate::Claims;
    use crate::coq::file;

    /// Claims n of which each has a lemma; the last cites the first, and one cites what is refuted.
    fn claims(n: usize) -> File {
        let mut text = "# T\n\n```kane\nvar x, y\ngiven g: y = x\n".to_owned();
        for i in 0..n {
            text.push_str(&format!("claim c{i}: y + {i} = x + {i} from g\n"));
        }
        text.push_str("claim last: 2*y = 2*x from c0\n");
        text.push_str("claim wrong: y > x from g expect refuted\n");
        text.push_str("claim partly: y >= x from wrong\n");
        text.push_str("given k: x = 0\nclaim at: sqrt(y^2) = 1 from g, k expect refuted\n```\n");
        let document = read("t.md", text.as_bytes()).expect("it is well formed");
        file(&Claims::of(&audit(document, &Options::default(), &mut |_, _| {})))
    }

    fn said(success: bool, out: &str, err: &str) -> io::Result<Option<Said>> {
        Ok(Some(Said { success, out: out.to_owned(), err: err.to_owned() }))
    }

    /// A Coq that rejects these lemmas, the first in the file first.
    fn rejects(names: &[String]) -> impl FnMut(&str) -> io::Result<Option<Said>> {
        move |text| {
            let at = |name: &String| text.lines().position(|l| *l == format!("Lemma {name} :"));
            match names.iter().filter_map(at).min() {
                Some(line) => {
                    let place = format!("File \"./claims.v\", line {}, characters 0-1:", line + 1);
                    said(false, "", &format!("{place}\nError:\n  It is\n  wrong.\n"))
                }
                None => said(true, "Closed", ""),
            }
        }
    }

    /// The answers by the names of lemmas.
    fn answers(file: &File, judge: &Judge) -> Vec<(String, Answer)> {
        let name = |l: &crate::coq::Lemma| l.name.clone().unwrap_or_else(|_| "none".to_owned());
        let named = |l| (name(l), judge.answers[&(l.statement, l.link)].clone());
        file.lemmas.iter().map(named).collect()
    }

    fn asked(file: &File, coqc: impl FnMut(&str) -> io::Result<Option<Said>>) -> Judge {
        heard(file, File::without, &Limits::default(), coqc).expect("it is asked")
    }

    #[test]
    fn a_rejected_lemma_disagrees_and_what_rests_on_it_agrees_in_part() {
        let file = claims(3);
        let judge = asked(&file, rejects(&["claim_c0".to_owned()]));
        assert!(judge.asked && judge.name == "Coq" && !judge.agrees());
        let partly = |why: &str| Answer::Partly(why.to_owned());
        let wanted = [
            ("claim_c0", Answer::Disagrees("It is wrong.".to_owned())),
            ("claim_c1", Answer::Agrees),
            ("claim_c2", Answer::Agrees),
            ("claim_last", partly("it rests on a claim that is rejected")),
            ("claim_wrong", Answer::Agrees),
            ("claim_partly", partly("no theorem from the givens: it cites wrong")),
            ("none", Answer::NotAsked("not emitted: a point at a square root".to_owned())),
        ];
        assert_eq!(answers(&file, &judge), wanted.map(|(name, a)| (name.to_owned(), a)));
        // the first statement is a given
        assert!(judge.disagrees_on(1) && !judge.disagrees_on(0) && !judge.disagrees_on(2));
        let judge = asked(&file, rejects(&[]));
        assert!(judge.agrees() && !judge.disagrees_on(1));
        assert_eq!(judge.answers[&(4, 0)], Answer::Agrees);
    }

    #[test]
    fn after_twenty_rejected_lemmas_nothing_more_is_asked() {
        let file = claims(22);
        let all: Vec<String> = (0..22).map(|i| format!("claim_c{i}")).collect();
        // with twenty of them it is asked about the rest
        let judge = asked(&file, rejects(&all[..20]));
        let agree =
            |judge: &Judge| judge.answers.values().filter(|a| matches!(a, Answer::Agrees)).count();
        assert_eq!(agree(&judge), 3);
        let mut runs = 0;
        let mut coq = rejects(&all);
        let judge = asked(&file, |text| {
            runs += 1;
            coq(text)
        });
        assert_eq!(runs, 21);
        assert_eq!(agree(&judge), 0);
        let answers = answers(&file, &judge);
        assert!(matches!(answers[19].1, Answer::Disagrees(_)), "{answers:?}");
        let left = Answer::Undecided("too many lemmas before it are rejected".to_owned());
        assert_eq!((&answers[20].1, &answers[21].1), (&left, &left));
    }

    #[test]
    fn axioms_are_told_and_one_that_is_not_allowed_is_a_disagreement() {
        let file = claims(1);
        let out = |more: &str| {
            let [a, b, _] = ALLOWED_AXIOMS;
            format!("all\nAxioms:\n{b} : forall x,\n  x = x\n{a}\n  : Set\n{more}")
        };
        let [a, b, _] = ALLOWED_AXIOMS.map(str::to_owned);
        let judge = asked(&file, |_| said(true, &out(""), ""));
        assert_eq!(judge.axioms, [a, b]);
        assert!(judge.agrees());
        let judge = asked(&file, |_| said(true, &out("Magic.wand : False\n"), ""));
        assert_eq!(judge.axioms.len(), 3);
        let wrong = Answer::Disagrees("rests on Magic.wand".to_owned());
        assert_eq!(answers(&file, &judge)[0].1, wrong);
    }

    #[test]
    fn what_is_no_answer_about_a_lemma_is_none() {
        let file = claims(1);
        let judge = asked(&file, |_| Ok(None));
        let late = Answer::Undecided("no answer within 300 s".to_owned());
        assert_eq!(answers(&file, &judge)[0].1, late);
        let ask =
            |err: &str| heard(&file, File::without, &Limits::default(), |_| said(false, "", err));
        let failed = |why: &str| Err(NotAsked::Failed(format!("coqc: {why}")));
        assert_eq!(ask("no such file"), failed("no such file"));
        // a place in the theory
        assert_eq!(ask("File \"claims.v\", line 3, Error: a lemma"), failed("a lemma"));
        let broken =
            heard(&file, File::without, &Limits::default(), |_| Err(io::Error::other("no room")));
        assert_eq!(broken, failed("no room"));
    }
}
