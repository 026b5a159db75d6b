//! One link of a claim: data, lemma and proof.

use std::fmt::Write as _;

use kane_audit::Accepted;
use kane_kernel::{
    Conclusion, Evidence, Finding, Fuel, Goal, Link, Model, Point, Proof, Relation, Scope,
    claim_state, scope,
};

use super::NotEmitted;
use super::chain::Form;
use super::conclusion::{behind, conclusion};
use super::family::{Family, limits};
use super::functions;
use super::prose::{Prose, conj, grouped};
use super::reify::Symbols;
use super::script::Writer;
use super::slopes::settled;
use super::theory::Part;
use super::witness::{Witness, witness};

/// A lemma as it is printed.
pub(super) struct Emitted {
    /// its data, the lemma and its proof
    pub(super) text: String,
    /// the part of the theory that it needs
    pub(super) part: Part,
    /// how it is applied, if it says of points that something follows
    pub(super) form: Option<Form>,
}

/// The lemma `claim_NAME`.
pub(super) fn lemma(name: &str, accepted: &Accepted) -> Result<Emitted, NotEmitted> {
    let (goal, certificate) = (&accepted.goal, &accepted.certificate);
    let scope = scope(goal, Fuel::new(u64::MAX))?;
    let finding = certificate.finding;
    let x = limits(goal).next().map(|l| l.var);
    let family = |x| Family::new(&scope, goal, x);
    let (text, part) = match (&certificate.evidence, &goal.conclusion, x) {
        (Evidence::Model(Model::Functions(f)), ..) => {
            (functions::lemma(name, &family(f.var)?, finding, f)?, Part::Functions)
        }
        (Evidence::Model(Model::Point(point)), ..) => {
            (refuted(name, &scope, goal, finding, point)?, Part::Witnesses)
        }
        (Evidence::Limit(proofs), Conclusion::Link(Link::Limit(l)), _) => {
            let (text, form) = family(l.var)?.limit(name, l, proofs)?;
            return Ok(Emitted { text, part: Part::Limits, form: Some(form) });
        }
        (Evidence::Contradiction(_), Conclusion::Link(Link::Limit(_)), _) => {
            return Err(NotEmitted::Step("premises of a limit that contradict each other"));
        }
        (Evidence::Contradiction(proof), _, Some(x)) => {
            let (text, form) = family(x)?.point(name, finding, proof)?;
            return Ok(Emitted { text, part: Part::Limits, form: Some(form) });
        }
        (Evidence::Contradiction(proof), _, None) => {
            let (text, form) = proved(name, &scope, goal, finding, proof)?;
            return Ok(Emitted { text, part: Part::Points, form: Some(form) });
        }
        (Evidence::Limit(_), ..) => return Err(NotEmitted::Step("limits for another claim")),
        (Evidence::Split { .. }, ..) => {
            return Err(NotEmitted::Step("a limit by cases of constants"));
        }
    };
    Ok(Emitted { text, part, form: None })
}

/// The goal as data and in words: `goal_NAME`, and the body of the statement.
fn statement(
    name: &str,
    symbols: &Symbols<'_>,
    goal: &Goal,
    finding: Finding,
) -> Result<(String, String), NotEmitted> {
    let written = |v: usize| symbols.name(v);
    let prose = Prose { name: &written, symbols };
    let ranges: Vec<Relation> = symbols.order.iter().flat_map(|v| symbols.range(*v)).collect();
    let when = symbols.expanded(&goal.when)?;
    let (claim, says) = conclusion(&prose, goal, finding)?;
    let mut premises = Vec::new();
    let mut words: Vec<String> = Vec::new();
    for r in &ranges {
        words.push(prose.relation(r)?);
    }
    for h in &goal.hypotheses {
        premises.push(symbols.sentence(&h.sentence, h.given)?);
        words.extend(prose.hypothesis(h)?);
    }
    let conditions = prose.flat(&when)?;
    if !conditions.is_empty() {
        words.push(conj(&conditions));
    }
    let data = format!(
        "Definition goal_{name} : goal := Goal\n  {}\n  [{}]\n  {}\n  ({claim}).\n",
        symbols.relations(&ranges)?,
        premises.join(";\n   "),
        symbols.relations(&when)?,
    );
    let mut text = String::new();
    for w in &words {
        let _ = write!(text, "{} ->\n  ", grouped(w));
    }
    text.push_str(&says);
    Ok((data, text))
}

fn binders(symbols: &Symbols<'_>) -> (String, String) {
    let names: Vec<String> = symbols.order.iter().map(|v| symbols.name(*v)).collect();
    match names[..] {
        [] => (String::new(), String::new()),
        _ => (format!("forall {} : R,\n  ", names.join(" ")), names.join(" ")),
    }
}

fn proved(
    name: &str,
    scope: &Scope<'_>,
    goal: &Goal,
    finding: Finding,
    proof: &Proof,
) -> Result<(String, Form), NotEmitted> {
    let symbols = Symbols::new(scope, 0)?;
    let state = claim_state(scope, goal, finding)?;
    let script = Writer { symbols: &symbols, sides: None }.proof(&state, proof)?;
    let (data, text) = statement(name, &symbols, goal, finding)?;
    let (forall, names) = binders(&symbols);
    settled(scope, &symbols.slopes())?;
    let (behind, known) = behind(&symbols)?;
    let mut values: Vec<String> = symbols.order.iter().map(|v| symbols.name(*v)).collect();
    values.extend(behind.iter().cloned());
    let list = format!("[{}]", values.join("; "));
    let intros = if names.is_empty() { String::new() } else { format!("intros {names}. ") };
    let (forall, text, by) = if behind.is_empty() {
        let by = format!(
            "{intros}exact (proved goal_{name} proof_{name} {list}\n    \
             (eq_refl true <: proves goal_{name} proof_{name} = true))."
        );
        (forall, text, by)
    } else {
        let by = format!(
            "intros {names} {} {}. refine (proved_rooted goal_{name} proof_{name} {list}\n    \
             (eq_refl true <: accepted goal_{name} proof_{name} = true) _). unfold goal_{name}. has_roots.",
            behind.join(" "),
            symbols.known(known.len()).join(" ")
        );
        (format!("forall {names} {} : R,\n  ", behind.join(" ")), known.concat() + &text, by)
    };
    let lemma = format!(
        "{data}Definition proof_{name} : proof :=\n  {script}.\n\
         Lemma claim_{name} :\n  {forall}{text}.\nProof. {by} Qed.\n"
    );
    let slopes = symbols.slopes();
    let roots = symbols.roots.into_iter().map(|r| r.1).collect();
    Ok((lemma, Form { symbols: symbols.order, roots, slopes, along: None }))
}

fn refuted(
    name: &str,
    scope: &Scope<'_>,
    goal: &Goal,
    finding: Finding,
    point: &Point,
) -> Result<String, NotEmitted> {
    let symbols = Symbols::new(scope, 1)?;
    if !symbols.roots.is_empty() {
        return Err(NotEmitted::Step("a point at a square root"));
    }
    let (data, text) = statement(name, &symbols, goal, finding)?;
    let (mut forall, names) = binders(&symbols);
    let Witness { data: witness, values } =
        witness(&symbols, &claim_state(scope, goal, finding)?, point)?;
    settled(scope, &symbols.slopes())?;
    let at = |t: &str| values.iter().map(|v| format!(" (at_ {t} {v})")).collect::<String>();
    let (behind, known) = behind(&symbols)?;
    if !behind.is_empty() {
        forall = format!("forall {names} {} : R,\n  {}", behind.join(" "), known.concat());
    }
    let proof = match &point.generator {
        None if behind.is_empty() => format!(
            "exact (refuted goal_{name} witness_{name}\n    \
             (eq_refl true <: refutes goal_{name} witness_{name} = true) (H{})).",
            at("0")
        ),
        None => {
            let values: Vec<String> = values.iter().map(|v| format!("at_ 0 {v}")).collect();
            let exist = symbols.slopes_exist(&format!("[{}]", values.join("; ")))?;
            let (slopes, shown) = (symbols.numbered("s", exist.len()), symbols.known(exist.len()));
            let found = exist.iter().zip(slopes.iter().zip(&shown));
            let found: Vec<String> =
                found.map(|(e, (s, k))| format!("destruct ({e}) as [{s} {k}].\n  ")).collect();
            format!(
                "{}refine (refuted_rooted goal_{name} witness_{name} [{}]\n    \
                 (eq_refl true <: refutes_rooted goal_{name} witness_{name} = true) _ (H{} {} {})).\n  \
                 unfold goal_{name}. has_roots.",
                found.concat(),
                slopes.join("; "),
                at("0"),
                slopes.join(" "),
                shown.join(" ")
            )
        }
        Some(_) if !behind.is_empty() => {
            return Err(NotEmitted::Step("a derivative at an algebraic number"));
        }
        Some(_) => format!(
            "destruct (refuted_root goal_{name} witness_{name}\n    \
             (eq_refl true <: refutes_at_root goal_{name} witness_{name} = true)) as [t N].\n  \
             exact (N (H{})).",
            at("t")
        ),
    };
    Ok(format!(
        "{data}Definition witness_{name} : witness := {witness}.\n\
         Lemma claim_{name} : ~ (\n  {forall}{text}).\nProof. intro H. {proof} Qed.\n"
    ))
}
