//! z3: one question a link, one process a question.

use std::fs;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use crate::smt::{Question, question};
use crate::{Answer, Claims, Judge};

use super::process::{Scratch, run};
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
    let Some(said) = said else {
        let seconds = limits.question.as_secs();
        return Ok(Answer::Undecided(format!("no answer within {seconds} s")));
    };
    let wanted = if question.satisfiable { "sat" } else { "unsat" };
    Ok(match said.out.trim() {
        answer if answer == wanted => Answer::Agrees,
        "unknown" => Answer::Undecided("unknown".to_owned()),
        "sat" | "unsat" => {
            Answer::Disagrees(format!("{} where {wanted} was expected", said.out.trim()))
        }
        other => Answer::Disagrees(other.chars().take(200).collect()),
    })
}
