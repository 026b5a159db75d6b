//! Certificates as a file, for those who check them without this program: `docs/certificates.md`.

use std::cmp::Ordering;
use std::ptr;

use kane_algebra::syntax::{Notation as _, canonical_name};
use kane_audit::{Accepted, Body, Claim, Content, LinkJudgement, Verdict};
use kane_kernel::{
    Atom, Conclusion, Context, Evidence, Expr, Failure, Finding, Fuel, Functions, Germ, Goal,
    Hypothesis, Limit, Link, Model, Point, Poly, Proof, Rejection, Relation, Root, Scope,
    SideProof, Sign, State, Target, claim_state, constants, inside_goal, narrowing, on_functions,
    owed, point_state, range_premise, scope, unequal,
};
use num_rational::BigRational;
use serde_json::{Map, Value, json};

use crate::Report;

/// The version of the format.
const FORMAT: u32 = 1;

/// What the file is, as a JSON Schema. It is written by hand, since evidence is told value by value.
#[cfg(feature = "schema")]
pub(crate) fn schema() -> Value {
    serde_json::from_str(include_str!("certificate.json")).expect("the schema is JSON")
}

/// The certificates of all claims of a document, ended by a line feed; one link a line.
#[must_use]
pub fn certificates(report: &Report<'_>) -> String {
    let document = &report.audit.document;
    let claims = document.statements.iter().zip(&report.audit.judgements);
    let claims: Vec<Value> = claims
        .filter_map(|(statement, judgement)| match &statement.body {
            Body::Claim(claim) => {
                let links = judgement.links.iter();
                let links: Vec<Value> =
                    links.map(|l| link(report, claim, &judgement.rests_on, l)).collect();
                let label = statement.label.trim_start_matches('(').trim_end_matches(')').trim();
                let verdict = judgement.verdict.to_string();
                let mut told = json!({ "label": label, "verdict": verdict, "links": links });
                if !claim.found.is_empty() {
                    let value = |e: &Expr| json!(e.plain(&document.context));
                    let found = claim.found.iter();
                    let found = found.map(|(y, e)| (canonical_name(y).into_owned(), value(e)));
                    told["witness"] = Value::Object(found.collect());
                }
                Some(told)
            }
            Body::Let(_) | Body::Defined(_) | Body::Given(_) => None,
        })
        .collect();
    let program = json!(format!("kane {}", env!("CARGO_PKG_VERSION")));
    let (name, digest) = (json!(document.name), json!(document.sha256()));
    let mut out = format!(
        "{{\"program\": {program},\n\"format\": {FORMAT},\n\"document\": {name},\n\"sha256\": {digest},\n\"claims\": ["
    );
    for (i, claim) in claims.iter().enumerate() {
        out.push_str(if i == 0 { "\n" } else { ",\n" });
        out.push_str(&claim.to_string());
    }
    out.push_str("\n]}\n");
    out
}

fn link(report: &Report<'_>, claim: &Claim, rests_on: &[usize], judged: &LinkJudgement) -> Value {
    let nothing = json!({ "finding": null });
    let Some(accepted) =
        judged.accepted.as_deref().filter(|_| judged.verdict != Verdict::Undecided)
    else {
        return nothing;
    };
    let statements = &report.audit.document.statements;
    let is_cited = |i: &&usize| match &statements[**i].body {
        Body::Let(_) | Body::Defined(_) => false,
        Body::Given(_) => true,
        Body::Claim(claim) => matches!(claim.content, Content::Links(_)),
    };
    let cited: Vec<usize> = claim.from.iter().filter(is_cited).copied().collect();
    let behind = rests_on.iter().copied().filter(|i| !cited.contains(i));
    let label = |i: usize| {
        statements[i].label.trim_start_matches('(').trim_end_matches(')').trim().to_owned()
    };
    // a witness may be one of all that is assumed above; the step of an induction has more premises of its own
    let is_model = matches!(accepted.certificate.evidence, Evidence::Model(_));
    let all = accepted.goal.hypotheses.len() > cited.len() && is_model;
    let mut labels =
        Labels { cited: cited.iter().copied().map(label).collect(), behind: Vec::new() };
    match all {
        true => labels.cited.extend(behind.map(label)),
        false => labels.behind = behind.map(label).collect(),
    }
    let mut writer = Writer { context: &accepted.goal.context, roots: Vec::new() };
    match writer.evidence(accepted, &labels) {
        Ok(evidence) => {
            let finding = match accepted.certificate.finding {
                Finding::Proved => "proved",
                Finding::Refuted => "refuted",
                Finding::IllDefined => "ill-defined",
                Finding::Vacuous => "vacuous",
                Finding::Consistent => "consistent",
            };
            let roots: Vec<String> =
                writer.roots.iter().map(|root| root.plain(writer.context)).collect();
            let premises = if all { "all" } else { "cited" };
            let mut link = json!({
                "finding": finding, "premises": premises, "roots": roots, "evidence": evidence
            });
            if !judged.at.is_empty() {
                link["at"] = writer.indices(&judged.at);
            }
            link
        }
        Err(_) => nothing,
    }
}

/// The labels of a goal's premises, and of the givens behind them.
struct Labels {
    cited: Vec<String>,
    behind: Vec<String>,
}

/// Writes the evidence for one goal.
struct Writer<'a> {
    context: &'a Context,
    /// the roots that were named so far
    roots: Vec<Expr>,
}

type Written = Result<Value, Rejection>;

impl Writer<'_> {
    /// The numbers in the place of indices.
    fn indices(&self, at: &[(usize, u32)]) -> Value {
        let name = |v: usize| Expr::Var(v).plain(self.context);
        let named =
            at.iter().map(|(v, n)| (canonical_name(&name(*v)).into_owned(), json!(n.to_string())));
        Value::Object(named.collect())
    }

    fn evidence(&mut self, accepted: &Accepted, labels: &Labels) -> Written {
        let goal = &accepted.goal;
        let scope = scope(goal, Fuel::new(u64::MAX))?;
        let mut v = goal.context.vars.len();
        while let Some(root) = scope.root(v) {
            self.roots.push(root.clone());
            v += 1;
        }
        Ok(match &accepted.certificate.evidence {
            Evidence::Contradiction(proof) => {
                let state = claim_state(&scope, goal, accepted.certificate.finding)?;
                json!({ "proof": self.proof(&state, labels, proof)? })
            }
            limit @ (Evidence::Limit(_) | Evidence::Split { .. }) => {
                let Conclusion::Link(Link::Limit(l)) = &goal.conclusion else {
                    return Err(Rejection::WrongEvidence);
                };
                self.limit(&constants(&scope, goal, l.var)?, labels, limit)?
            }
            Evidence::Model(Model::Point(point)) => json!({ "point": self.point(&scope, point) }),
            Evidence::Model(Model::Functions(f)) => {
                json!({ "functions": self.functions(&scope, goal, labels, f)? })
            }
        })
    }

    /// The name of a variable of a scope.
    fn variable(&mut self, scope: &Scope<'_>, v: usize) -> String {
        if let Some(var) = self.context.vars.get(v) {
            return var.name.clone();
        }
        if let Some(root) = scope.root(v) {
            let known = self.roots.iter().position(|known| known == root);
            let i = known.unwrap_or_else(|| {
                self.roots.push(root.clone());
                self.roots.len() - 1
            });
            return format!("sqrt:{i}");
        }
        match v.checked_sub(scope.germ() + 1) {
            None => "t:".to_owned(),
            Some(i) => format!("lim:{i}"),
        }
    }

    fn poly(&mut self, scope: &Scope<'_>, p: &Poly) -> Value {
        let mut terms: Vec<(Vec<(String, u32)>, String)> = Vec::new();
        for (m, c) in p.terms() {
            let mut powers: Vec<(String, u32)> =
                m.iter().map(|(v, n)| (self.variable(scope, *v), *n)).collect();
            powers.sort();
            terms.push((powers, c.to_string()));
        }
        terms.sort();
        let term = |(powers, c): (Vec<(String, u32)>, String)| {
            let powers: Map<String, Value> =
                powers.into_iter().map(|(name, n)| (name, n.into())).collect();
            json!([c, powers])
        };
        terms.into_iter().map(term).collect()
    }

    fn condition(&mut self, scope: &Scope<'_>, atom: &Atom) -> Value {
        json!({ "poly": self.poly(scope, &atom.poly), "is": sign(atom.sign) })
    }

    fn proof(&mut self, state: &State<'_, '_>, labels: &Labels, proof: &Proof) -> Written {
        let scope = state.scope;
        Ok(match proof {
            Proof::Assume { formula, cases } => {
                let cases: Result<Vec<Value>, _> =
                    cases.iter().map(|p| self.proof(state, labels, p)).collect();
                json!({ "assume": formula, "cases": cases? })
            }
            Proof::Split { poly, cases } => {
                let mut all = Vec::new();
                for case in cases {
                    let then = self.proof(state, labels, &case.then)?;
                    let is = sign(case.sign);
                    all.push(json!({ "opposite": case.opposite, "is": is, "then": then }));
                }
                json!({ "split": self.poly(scope, poly), "cases": all })
            }
            Proof::Positive { terms, cofactors } => {
                let terms: Vec<Value> = terms
                    .iter()
                    .map(|t| json!([t.weight.to_string(), self.poly(scope, &t.square), t.factors]))
                    .collect();
                let cofactors: Vec<Value> =
                    cofactors.iter().map(|(i, p)| json!([i, self.poly(scope, p)])).collect();
                json!({ "positive": terms, "cofactors": cofactors })
            }
            Proof::Pass { germ, atom, along, then } => json!({
                "pass": self.germ(state, labels, germ)?,
                "condition": self.condition(scope, atom),
                "along": self.proof(state, labels, along)?,
                "then": self.proof(state, labels, then)?,
            }),
        })
    }

    fn germ(&mut self, state: &State<'_, '_>, labels: &Labels, germ: &Germ) -> Written {
        let Germ { side, power, radius, positive, inside } = germ;
        let mut all = Vec::new();
        for (given, proof) in owed(state, side).into_iter().zip(inside) {
            let cited = state.goal.hypotheses.iter().position(|h| ptr::eq(&h.sentence, given));
            let behind = state.goal.behind.iter().position(|s| ptr::eq(s, given));
            let label = cited.and_then(|i| labels.cited.get(i));
            let label = label.or_else(|| behind.and_then(|i| labels.behind.get(i)));
            let goal = inside_goal(state, side, given, &proof.values)?;
            let scope = scope(&goal, Fuel::new(u64::MAX))?;
            // Only names are needed: the conditions do not matter here.
            let there = point_state(&scope, &goal, None)?;
            let nobody = Labels { cited: Vec::new(), behind: Vec::new() };
            all.push(json!({
                "given": label,
                "values": self.values(&proof.values),
                "proof": self.proof(&there, &nobody, &proof.proof)?,
            }));
        }
        let mut written = json!({
            "variable": self.variable(state.scope, side.var),
            "at": side.at.as_ref().map(rational),
            "above": side.above,
            "radius": [self.poly(state.scope, &radius.0), self.poly(state.scope, &radius.1)],
            "positive": self.proof(state, labels, positive)?,
            "inside": all,
        });
        if *power != 1 {
            written["power"] = json!(power);
        }
        Ok(written)
    }

    fn values(&self, values: &[(usize, Expr)]) -> Value {
        let value = |(v, e): &(usize, Expr)| {
            (self.context.vars[*v].name.clone(), e.plain(self.context).into())
        };
        Value::Object(values.iter().map(value).collect())
    }

    /// A limit claim, in each case of the constants.
    fn limit(&mut self, state: &State<'_, '_>, labels: &Labels, evidence: &Evidence) -> Written {
        Ok(match evidence {
            Evidence::Limit(proofs) => json!({ "sides": self.each_side(state, labels, proofs)? }),
            Evidence::Contradiction(proof) => json!({ "proof": self.proof(state, labels, proof)? }),
            Evidence::Split { poly, cases } => {
                let mut all = Vec::new();
                for case in cases {
                    let then = self.limit(state, labels, &case.then)?;
                    all.push(
                        json!({ "opposite": case.opposite, "is": sign(case.sign), "then": then }),
                    );
                }
                json!({ "split": self.poly(state.scope, poly), "cases": all })
            }
            Evidence::Model(_) => return Err(Rejection::WrongEvidence),
        })
    }

    /// One limit from all its sides, as the conclusion of the goal.
    fn sides(&mut self, goal: &Goal, labels: &Labels, proofs: &[SideProof]) -> Written {
        let Conclusion::Link(Link::Limit(limit)) = &goal.conclusion else {
            return Err(Rejection::WrongEvidence);
        };
        let scope = scope(goal, Fuel::new(u64::MAX))?;
        self.each_side(&constants(&scope, goal, limit.var)?, labels, proofs)
    }

    fn each_side(
        &mut self,
        state: &State<'_, '_>,
        labels: &Labels,
        proofs: &[SideProof],
    ) -> Written {
        proofs.iter().map(|p| self.side(state, labels, p)).collect()
    }

    fn side(&mut self, state: &State<'_, '_>, labels: &Labels, p: &SideProof) -> Written {
        let mut written = json!({
            "germ": self.germ(state, labels, &p.germ)?,
            "num": self.poly(state.scope, &p.num),
            "den": self.poly(state.scope, &p.den),
            "order": p.order,
            "along": self.proof(state, labels, &p.along)?,
            "at_zero": self.proof(state, labels, &p.at_zero)?,
        });
        match p.sense {
            Ordering::Less => written["sense"] = json!("<="),
            Ordering::Equal => {}
            Ordering::Greater => written["sense"] = json!(">="),
        }
        if let Some(upper) = &p.upper {
            written["upper"] = self.side(state, labels, upper)?;
        }
        Ok(written)
    }

    fn point(&mut self, scope: &Scope<'_>, point: &Point) -> Value {
        let theta = point.generator.as_ref().map(|Root { poly, lo, hi }| {
            let poly: Vec<String> = poly.iter().map(ToString::to_string).collect();
            json!({ "poly": poly, "from": rational(lo), "to": rational(hi) })
        });
        let mut values = Map::new();
        for (v, coefficients) in &point.values {
            let named = scope.mentioned.contains(v) || scope.root(*v).is_some();
            if named {
                let mut coefficients: Vec<String> = coefficients.iter().map(rational).collect();
                while coefficients.last().is_some_and(|c| c == "0") {
                    coefficients.pop();
                }
                values.insert(self.variable(scope, *v), coefficients.into());
            }
        }
        json!({ "theta": theta, "values": values })
    }

    fn functions(
        &mut self,
        outer: &Scope<'_>,
        goal: &Goal,
        labels: &Labels,
        f: &Functions,
    ) -> Written {
        let domain = on_functions(outer, goal, f.var, &f.values);
        let narrows = |h: &&Hypothesis| !narrowing(outer, h, f.var).links.is_empty();
        let all = goal.hypotheses.iter().zip(&labels.cited);
        let narrowed = all.filter(|(h, _)| narrows(h)).map(|(_, label)| label.clone());
        let labels = Labels { cited: narrowed.collect(), behind: Vec::new() };
        let on = |conclusion, when: &[Relation]| Goal {
            conclusion,
            when: when.to_vec(),
            ..domain.clone()
        };
        let mut holds = |h: &Hypothesis, proof: &Proof| {
            let goal = on(Conclusion::NotImplied(h.sentence.clone()), &[]);
            let scope = scope(&goal, Fuel::new(u64::MAX))?;
            self.proof(&point_state(&scope, &goal, None)?, &labels, proof)
        };
        let mut ranges = Vec::new();
        for ((v, _), proof) in f.values.iter().zip(&f.ranges) {
            ranges.push(holds(&range_premise(&goal.context, *v), proof)?);
        }
        let mut proofs = Vec::new();
        for (h, (proof, _)) in goal.hypotheses.iter().zip(&f.premises) {
            proofs.push(holds(h, proof)?);
        }
        let tends =
            |l: &Limit, when: &[Relation]| on(Conclusion::Link(Link::Limit(l.clone())), when);
        let mut premises = Vec::new();
        for ((h, (_, limits)), proof) in goal.hypotheses.iter().zip(&f.premises).zip(proofs) {
            let mut all = Vec::new();
            for (l, p) in h.sentence.limits().zip(limits) {
                all.push(self.sides(&tends(l, &[]), &labels, p)?);
            }
            premises.push(json!({ "proof": proof, "limits": all }));
        }
        let failure = match &f.failure {
            Failure::At(point) => {
                let conclusion = goal.conclusion.clone();
                let there = on(conclusion, &goal.when);
                let scope = scope(&there, Fuel::new(u64::MAX))?;
                json!({ "at": self.point(&scope, point) })
            }
            // that hypotheses are consistent is no finding on a claim
            Failure::Reaches(_) => return Err(Rejection::WrongEvidence),
            Failure::Limit { link, target, proof, apart } => {
                let Some(Link::Limit(claimed)) = goal.conclusion.links().get(*link) else {
                    return Err(Rejection::WrongEvidence);
                };
                let found = Limit { to: target.clone(), ..claimed.clone() };
                let side = self.sides(&tends(&found, &[]), &labels, std::slice::from_ref(proof))?;
                let to = match target {
                    Target::Finite(e) => e.plain(self.context),
                    Target::PlusInf => "oo".to_owned(),
                    Target::MinusInf => "-oo".to_owned(),
                };
                let mut told = json!({ "limit": link, "to": to, "side": side[0] });
                if let Some(proof) = apart {
                    let goal =
                        on(unequal(&claimed.to, target).ok_or(Rejection::WrongEvidence)?, &[]);
                    let scope = scope(&goal, Fuel::new(u64::MAX))?;
                    let state = claim_state(&scope, &goal, Finding::Proved)?;
                    told["apart"] = self.proof(&state, &labels, proof)?;
                }
                told
            }
        };
        Ok(json!({
            "variable": self.variable(outer, f.var),
            "values": self.values(&f.values),
            "ranges": ranges,
            "premises": premises,
            "failure": failure,
        }))
    }
}

fn sign(sign: Sign) -> &'static str {
    match sign {
        Sign::Zero => "=0",
        Sign::NonZero => "!=0",
        Sign::NonNegative => ">=0",
        Sign::Positive => ">0",
    }
}

fn rational(q: &BigRational) -> String {
    q.to_string()
}

#[cfg(test)]
mod tests {
    use kane_audit::{Options, audit, read};

    use super::*;

    /// The claims of the file of a document of these statements.
    fn told(statements: &str) -> Vec<Value> {
        let text = format!("# T\n\n```kane\n{statements}```\n");
        let document = read("made-up.md", text.as_bytes()).expect("it is well formed");
        let audit = audit(document, &Options::default(), &mut |_, _| {});
        let file = certificates(&Report::new(&audit, "kane audit made-up.md"));
        let file: Value = serde_json::from_str(&file).expect("JSON");
        assert_eq!(
            [&file["document"], &file["sha256"]],
            [&json!("made-up.md"), &json!(audit.document.sha256())]
        );
        file["claims"].as_array().expect("a list").clone()
    }

    fn number(text: &Value) -> BigRational {
        text.as_str().and_then(|text| text.parse().ok()).expect("a fraction")
    }

    #[test]
    fn each_claim_has_its_label_and_its_verdict_and_each_link_its_finding() {
        let claims = told(
            "var x\ngiven (g): x > 1\nclaim (1): x^2 >= 0\nclaim b: x > 2\nclaim c: 1 < x <= 0 from g\n\
             claim e: 1/(x - x) = 0\nclaim f: x^2 >= 0, x^2 + 1 > 0\n",
        );
        let told: Vec<Value> = claims
            .iter()
            .map(|claim| {
                let links = claim["links"].as_array().expect("a list");
                let findings: Vec<&Value> = links.iter().map(|link| &link["finding"]).collect();
                json!([claim["label"], claim["verdict"], findings])
            })
            .collect();
        assert_eq!(
            told,
            [
                json!(["1", "proved", ["proved"]]),
                json!(["b", "refuted", ["refuted"]]),
                json!(["c", "refuted", ["proved", "refuted"]]),
                json!(["e", "ill-defined", ["ill-defined"]]),
                json!(["f", "proved", ["proved", "proved"]]),
            ]
        );
        // only what is sought has a witness
        assert!(claims.iter().all(|claim| claim.get("witness").is_none()), "{claims:?}");
    }

    #[test]
    fn what_was_found_for_what_is_sought_stands_in_the_file() {
        let claims = told("var x, y\nclaim a: exists m: m = 2*x\n");
        let witness = claims[0]["witness"].as_object().expect("an object");
        assert_eq!(witness.keys().collect::<Vec<_>>(), ["m"]);
        assert_eq!(witness["m"].as_str().map(|text| text.replace(' ', "")), Some("2*x".to_owned()));
    }

    #[test]
    fn a_counterexample_is_a_point_at_which_the_claim_fails() {
        let claims = told("var x\ngiven (g): x > 1\nclaim a: x > 2 from g\n");
        let link = &claims[0]["links"][0];
        let point = &link["evidence"]["point"];
        assert_eq!(point["theta"], Value::Null);
        let [value] = point["values"]["x"].as_array().expect("a list").as_slice() else {
            panic!("one coefficient: {point}")
        };
        let [one, two] = [1, 2].map(|n| BigRational::from_integer(n.into()));
        assert!(one < number(value) && number(value) <= two, "{point}");
    }

    #[test]
    fn an_irrational_counterexample_is_told_by_its_polynomial_and_where_its_root_is() {
        let claims = told("var x > 0\nclaim a: x^2 != 2\n");
        let point = &claims[0]["links"][0]["evidence"]["point"];
        let theta = &point["theta"];
        let poly: Vec<BigRational> =
            theta["poly"].as_array().expect("a list").iter().map(number).collect();
        let [constant, linear, square] = poly.as_slice() else { panic!("degree two: {theta}") };
        let two = BigRational::from_integer(2.into());
        // t² − 2, or a multiple of it
        assert_eq!((*constant == -square * &two, linear.to_string()), (true, "0".to_owned()));
        let [from, to] = ["from", "to"].map(|end| number(&theta[end]));
        let squares = [&from * &from, &to * &to];
        assert!(squares.iter().min() < Some(&two) && Some(&two) < squares.iter().max(), "{theta}");
        // x is the root or its opposite: no coefficient after the last that is not 0
        let x = point["values"]["x"].as_array().expect("a list");
        let expected = if from.numer().sign() == num_bigint::Sign::Minus { "-1" } else { "1" };
        assert_eq!(x, &[json!("0"), json!(expected)]);
    }

    #[test]
    fn roots_are_listed_and_named_by_their_places() {
        let claims = told("var x, y\nclaim a: sqrt(x^2 + 1) + sqrt(y^2 + 2) > 0\n");
        let link = &claims[0]["links"][0];
        let mut roots: Vec<String> = link["roots"]
            .as_array()
            .expect("a list")
            .iter()
            .map(|root| root.as_str().unwrap_or_default().replace(' ', ""))
            .collect();
        roots.sort();
        assert_eq!(roots, ["sqrt(x^2+1)", "sqrt(y^2+2)"]);
        let evidence = link["evidence"].to_string();
        let names = evidence.split("\"sqrt:").skip(1).filter_map(|rest| rest.split('"').next());
        let places: Vec<usize> = names.filter_map(|place| place.parse().ok()).collect();
        assert!(!places.is_empty() && places.iter().all(|place| *place < 2), "{evidence}");
        assert!(!evidence.contains("lim:") && !evidence.contains("\"t:\""), "{evidence}");
    }

    #[test]
    fn premises_are_those_that_are_cited_where_these_are_enough() {
        let claims = told(
            "var x, y\ngiven g: y > 1\nclaim b: y^2 > 1 from g\ngiven h: x > y^2\nclaim c: x > 1 from b, h\n",
        );
        for claim in &claims {
            assert_eq!(claim["links"][0]["premises"], "cited", "{claim}");
        }
        assert_eq!(claims.len(), 2);
    }

    #[test]
    fn signs_and_fractions_are_told_as_the_checkers_read_them() {
        let signs = [Sign::Zero, Sign::NonZero, Sign::NonNegative, Sign::Positive].map(sign);
        assert_eq!(signs, ["=0", "!=0", ">=0", ">0"]);
        let half = BigRational::new((-1).into(), 2.into());
        assert_eq!([rational(&half), rational(&half.floor())], ["-1/2", "-1"]);
    }
}
