//! z3: one question a link, one process a question.

use std::fs;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use crate::smt::{Question, question};
use crate::{Answer, Claims, Judge};

use super::process::{Said, Scratch, run};
use super::{Limits, NotAsked, is_installed};

/// Processes at once.
const AT_ONCE: usize = 2;

/// Asks z3 about claims. `progress` is told how many questions are
/// answered, and their number.
///
/// # Errors
/// [`NotAsked`].
pub fn ask_z3(
    claims: &Claims<'_>,
    limits: &Limits,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<Judge, NotAsked> {
    if !is_installed("z3") {
        return Err(NotAsked::NotInstalled("z3"));
    }
    let mut judge = Judge { name: "z3".to_owned(), asked: true, ..Judge::default() };
    let mut questions = Vec::new();
    for asked in claims.links() {
        let Some(accepted) = &asked.judged.accepted else {
            continue;
        };
        match question(accepted) {
            Ok(text) => questions.push((asked.place, text)),
            Err(why) => {
                judge.answers.insert(asked.place, Answer::NotAsked(why.to_string()));
            }
        }
    }
    let (next, done) = (AtomicUsize::new(0), AtomicUsize::new(0));
    let answers = Mutex::new(Vec::new());
    std::thread::scope(|scope| {
        for _ in 0..AT_ONCE {
            scope.spawn(|| {
                while let Some((place, question)) =
                    questions.get(next.fetch_add(1, Ordering::Relaxed))
                {
                    let answer = ask(question, limits);
                    progress(done.fetch_add(1, Ordering::Relaxed) + 1, questions.len());
                    answers.lock().expect("no thread panics with the lock").push((*place, answer));
                }
            });
        }
    });
    for (place, answer) in answers.into_inner().expect("no thread panics with the lock") {
        judge.answers.insert(place, answer.map_err(|e| NotAsked::Failed(format!("z3: {e}")))?);
    }
    Ok(judge)
}

/// Puts one question.
fn ask(question: &Question, limits: &Limits) -> std::io::Result<Answer> {
    let folder = Scratch::new()?;
    fs::write(folder.0.join("claim.smt2"), &question.text)?;
    let said = run("z3", &["claim.smt2"], &folder.0, limits.question)?;
    Ok(heard(said.as_ref(), question, limits))
}

/// What it answers by what it said, if it said anything within the limit.
fn heard(said: Option<&Said>, question: &Question, limits: &Limits) -> Answer {
    let Some(said) = said else {
        let seconds = limits.question.as_secs();
        return Answer::Undecided(format!("no answer within {seconds} s"));
    };
    let wanted = if question.satisfiable { "sat" } else { "unsat" };
    match said.out.trim() {
        answer if answer == wanted => Answer::Agrees,
        "unknown" => Answer::Undecided("unknown".to_owned()),
        "sat" | "unsat" => {
            Answer::Disagrees(format!("{} where {wanted} was expected", said.out.trim()))
        }
        other => Answer::Disagrees(other.chars().take(200).collect()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_answer_that_is_not_the_one_that_is_due_disagrees() {
        let answer = |out: Option<&str>, satisfiable| {
            let said =
                out.map(|out| Said { success: true, out: out.to_owned(), err: String::new() });
            let question = Question { text: String::new(), satisfiable };
            heard(said.as_ref(), &question, &Limits::default())
        };
        assert_eq!(answer(Some("sat\n"), true), Answer::Agrees);
        assert_eq!(answer(Some("unsat\n"), false), Answer::Agrees);
        let disagrees = |why: &str| Answer::Disagrees(why.to_owned());
        assert_eq!(answer(Some("sat\n"), false), disagrees("sat where unsat was expected"));
        assert_eq!(answer(Some("unsat\n"), true), disagrees("unsat where sat was expected"));
        assert_eq!(answer(Some("(error)"), true), disagrees("(error)"));
        assert_eq!(answer(Some("unknown"), true), Answer::Undecided("unknown".to_owned()));
        assert_eq!(answer(None, true), Answer::Undecided("no answer within 10 s".to_owned()));
    }
}
