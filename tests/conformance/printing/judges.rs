//! What is put to Coq and to z3: terms and questions are read back, and mean at random points what the
//! statement means; and the programs themselves, where they are installed, take them.

use std::collections::HashMap;
use std::path::Path;
use std::process::Command;
use std::rc::Rc;

use kane::algebra::syntax::{NoValue, Notation, coq, coq_relation, eval, holds};
use kane::audit::Accepted;
use kane::judges::smt::question;
use kane::judges::{Answer, Claims};
use kane::kernel::{
    Certificate, Conclusion, Context, Evidence, Expr, Finding, Goal, Link, Proof, Relation, digest,
};

use super::generator::{self, PLAIN, Wanted};
use super::{context, terms};
use crate::many::many;
use crate::smt::Question;
use crate::support::{Chance, Q, installed, judged, q};

/// What a term of Coq can say by itself: definitions and derivatives are written out before.
const TERMS: Wanted = Wanted { slopes: false, names: false, numbers: true };

/// E is a function of x here.
fn written(v: usize) -> String {
    let name = PLAIN[v].0;
    if name == "E" { "E x".to_owned() } else { name.to_owned() }
}

fn point(context: &Context, chance: &mut Chance) -> Vec<Q> {
    let value = |_: &_| q(chance.within(-6, 6), *chance.pick(&[1, 1, 2, 3]));
    context.vars.iter().map(value).collect()
}

#[test]
fn terms_of_coq_have_the_values_of_what_they_stand_for() {
    let context = context();
    let mut chance = Chance::new(6);
    let mut compared = 0;
    for _ in 0..many(3000) {
        let e = generator::expression(1 + chance.below(4), TERMS, &mut chance);
        let term = coq(&e, &written);
        for _ in 0..4 {
            let point = point(&context, &mut chance);
            let names = PLAIN.iter().map(|(name, _)| (*name).to_owned());
            let values: HashMap<String, Q> = names.zip(point.iter().cloned()).collect();
            let read = terms::value(&term, &values);
            if let Ok(value) = eval(&e, &context, &point) {
                compared += 1;
                assert_eq!(read, Ok(Some(value)), "{}\n{term}", e.plain(&context));
            }
        }
    }
    assert!(compared > 2000, "{compared} values");
}

/// Runs a program on a file with this text in a folder of the tests' own: its output.
fn said(program: &str, arguments: &[&str], file: &str, text: &str) -> (bool, String) {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("printing").join(program);
    std::fs::create_dir_all(&folder).expect("the build directory is writable");
    std::fs::write(folder.join(file), text).expect("the build directory is writable");
    let mut command = Command::new(program);
    let output =
        command.args(arguments).arg(file).current_dir(&folder).output().expect("it starts");
    let said = String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).into_owned();
    (output.status.success(), said)
}

#[test]
fn coq_takes_every_term_and_comparison() {
    if !installed("coqc") {
        return;
    }
    let mut chance = Chance::new(7);
    let names: Vec<&str> = PLAIN.iter().map(|(name, _)| *name).filter(|n| *n != "E").collect();
    let mut text = "From Coq Require Import Reals.\nOpen Scope R_scope.\nSection S.\n".to_owned();
    text.push_str(&format!("Variables {} : R.\nVariable E : R -> R.\n", names.join(" ")));
    for n in 0..300 {
        let e = generator::expression(1 + chance.below(4), TERMS, &mut chance);
        text.push_str(&format!("Definition t{n} : R := {}.\n", coq(&e, &written)));
        for (m, r) in generator::relations(2, TERMS, &mut chance).iter().enumerate() {
            text.push_str(&format!(
                "Definition r{n}_{m} : Prop := {}.\n",
                coq_relation(r, &written)
            ));
        }
    }
    text.push_str("End S.\n");
    let (well, said) = said("coqc", &["-q"], "terms.v", &text);
    assert!(well, "{said}");
}

/// The same without roots, for which a question has symbols of its own.
fn rootless(e: &Expr) -> Expr {
    let go = |e: &Expr| Rc::new(rootless(e));
    match e {
        Expr::Sqrt(a) | Expr::Abs(a) => Expr::Abs(go(a)),
        Expr::Num(_) | Expr::Var(_) | Expr::Let(_) => e.clone(),
        Expr::Neg(a) => Expr::Neg(go(a)),
        Expr::Add(a, b) => Expr::Add(go(a), go(b)),
        Expr::Sub(a, b) => Expr::Sub(go(a), go(b)),
        Expr::Mul(a, b) => Expr::Mul(go(a), go(b)),
        Expr::Div(a, b) => Expr::Div(go(a), go(b)),
        Expr::Pow(a, n) => Expr::Pow(go(a), *n),
        Expr::Min(a, b) => Expr::Min(go(a), go(b)),
        Expr::Max(a, b) => Expr::Max(go(a), go(b)),
        Expr::Deriv(a, x) => Expr::Deriv(go(a), *x),
        Expr::Cases(branches, last) => Expr::Cases(
            branches
                .iter()
                .map(|(guards, body)| {
                    (guards.iter().map(rootless_relation).collect(), rootless(body))
                })
                .collect(),
            last.as_deref().map(go),
        ),
    }
}

fn rootless_relation(r: &Relation) -> Relation {
    Relation { lhs: rootless(&r.lhs), rel: r.rel, rhs: rootless(&r.rhs) }
}

/// What z3 is asked of a claim without premises: where is it false or undefined?
fn asked(context: &Context, relation: &Relation) -> String {
    let goal = Goal {
        context: context.clone(),
        hypotheses: Vec::new(),
        behind: Vec::new(),
        when: Vec::new(),
        conclusion: Conclusion::Link(Link::Relation(relation.clone())),
    };
    let evidence =
        Evidence::Contradiction(Proof::Positive { terms: Vec::new(), cofactors: Vec::new() });
    let certificate = Certificate { goal: digest(&goal), finding: Finding::Proved, evidence };
    question(&Accepted { goal, certificate }).expect("it speaks of no limit").text
}

#[test]
fn questions_to_z3_hold_exactly_where_the_claim_fails() {
    let context = context();
    let mut chance = Chance::new(8);
    let wanted = Wanted { slopes: false, names: true, numbers: true };
    let (mut held, mut failed) = (0, 0);
    let mut some = String::new();
    for _ in 0..many(400) {
        for relation in generator::relations(2, wanted, &mut chance) {
            let relation = rootless_relation(&relation);
            let text = asked(&context, &relation);
            let question = Question::read(&text).unwrap_or_else(|why| panic!("{why}\n{text}"));
            some.push_str(&format!(
                "(push)\n{}(pop)\n",
                text.replacen("(set-logic QF_NRA)\n", "", 1)
            ));
            for _ in 0..6 {
                let point = point(&context, &mut chance);
                let names = context.vars.iter().map(|var| format!("|{}|", var.name));
                let values: HashMap<String, Q> = names.zip(point.iter().cloned()).collect();
                assert!(question.declared.iter().all(|name| values.contains_key(name)));
                let fails = match holds(&relation, &context, &point) {
                    Err(NoValue::TooLarge) => continue,
                    truth => truth != Ok(true),
                };
                assert_eq!(
                    question.holds(&values),
                    Ok(fails),
                    "{}\n{text}",
                    relation.plain(&context)
                );
                *(if fails { &mut failed } else { &mut held }) += 1;
            }
        }
    }
    println!("questions at points: {held} where the claim holds, {failed} where it fails");
    assert!(held > many(400) && failed > many(400));
    if installed("z3") {
        // read by z3 itself; not answered, because on some of these z3 goes on beyond any limit of time
        let text = format!("(set-logic QF_NRA)\n{}", some.replace("(check-sat)\n", ""));
        let (_, said) = said("z3", &[], "questions.smt2", &text);
        assert!(!said.contains("error"), "{said:.2000}");
    }
}

/// Names that Coq, its library or the file itself have a use for.
const NAMES: &str = "epsilon, delta, bound, level, true, false, proved, eq_refl, H, root, Rlt_dec, \
    pow, R, S, O, I, Rabs, sqrt_, forall, fun, fix, end, in, let_, match, return, then, Prop, \
    Set, Type, goal_a, proof_a, claim_a, witness_a, Root0, t, N, nat, list, goal, proof, atom, expr, \
    Num, Var, Neg, Add, Mul, Div, Eq, Le, Holds, Goal, Says, Rel, Some, None, PI, exp, ln, sin, up, \
    IZR, INR, Rplus, Rmult, Ropp, Rinv, Rmin, Rmax, Rge_dec, Req_EM_T, Steady, Witness, refuted, \
    holds, conj, True, False, Axiom, Variable, mod, rem, div, quot, v_goal_a";

#[test]
fn no_name_clashes_with_a_word_of_coq_or_of_the_file() {
    if !installed("coqc") {
        return;
    }
    let mut text = format!("var x\nvar {NAMES}\nvar k(x)\n");
    text.push_str(
        "claim l1: x + epsilon -> epsilon as x -> 0\n\
         claim l2: delta*x -> 0 as x -> 0\n\
         claim l3: bound + 1/x -> bound as x -> oo\n\
         claim l4: x + level -> oo as x -> oo\n\
         claim r1: H > 0 expect refuted\n\
         claim r2: sqrt(root^2) = abs(root)\n\
         claim r3: cases { Rlt_dec < 0: 1; else: 1 } = 1\n\
         claim proved: true = true\n\
         claim atoms: refuted = 0 expect refuted\n\
         claim values: conj + 0 = conj\n",
    );
    for (n, name) in NAMES.split(',').map(str::trim).enumerate() {
        text.push_str(&format!("claim a{n}: {name}^2 + x^2 + 1 > 0\n"));
        if n % 8 == 0 {
            text.push_str(&format!("claim b{n}: x + {name} -> {name} as x -> 0\n"));
            text.push_str(&format!("claim c{n}: x > {name} expect refuted\n"));
        }
    }
    let audit = judged(&text);
    assert!(audit.as_expected(), "every claim ends as it should");
    let judge = crate::judges::coq(&kane::judges::coq::file(&Claims::of(&audit)));
    let others: Vec<_> =
        judge.answers.iter().filter(|(_, a)| !matches!(a, Answer::Agrees)).collect();
    assert!(others.is_empty(), "{others:?}");
}
