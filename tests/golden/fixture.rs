//! An audit whose judgements are made by hand, with every verdict in it. Reports are tested on it, so that a change
//! of the prover does not change their snapshots.

use kane::audit::{Audit, Judgement, LinkJudgement, Step, Verdict};

const TEXT: &str = "\
# A sphere meets a wall

```kane
var m > 0, mu >= 0, r_0, alpha
var k(alpha), v_x(alpha), v_y(alpha), v_x0(alpha), v_y0(alpha), I_x(alpha), I_y(alpha)
let k_W := 1 - 2*alpha
given (2): m*(v_x - v_x0) = -I_x    # as printed
given dom: alpha > 0
claim (1): m*(v_y - v_y0) = I_y  when mu > 0  from (2)  expect refuted
claim (16): k = (1 - alpha)/(1 + alpha)
  from (2), dom                     # a line that goes on
claim range: -1 < k < 1  from (16), dom
claim wrong: k > 1  from dom
claim half: k = 1/2, k < 1  from dom  expect refuted
claim lost: k >= mu*abs(v_x)  from wrong
claim empty: contradiction  from (2), dom  expect refuted
claim nothing: r_0/r_0*m = m  from (2)  expect vacuous
claim pole: m/(k - 1) > 0  expect ill-defined
claim open: m^4 + mu^4 > m*mu - 1
claim μ-lim: k -> -1 as alpha -> oo  from (16)
```
";

/// A judged document with every verdict, expected and not.
pub(crate) fn audit() -> Audit {
    let document = kane::audit::read("wall.md", TEXT.as_bytes()).expect("the text is well formed");
    let judgements =
        document.statements.iter().map(|statement| judgement(&statement.label)).collect();
    Audit { document, judgements }
}

/// What the prover could have said of the statement.
fn judgement(label: &str) -> Judgement {
    use Verdict::{Assumed, Defined, IllDefined, Proved, Refuted, Undecided, Unsupported, Vacuous};
    let one = |verdict, text: &str| judged(verdict, vec![link(text, verdict)]);
    let expected =
        |judgement: Judgement| Judgement { expect: Some(judgement.verdict), ..judgement };
    let at = |pairs: &[(&str, &str)]| {
        Some(pairs.iter().map(|&(name, value)| (name.to_owned(), value.to_owned())).collect())
    };
    match label {
        "k_W" => judged(Defined, vec![]),
        "(2)" | "dom" => judged(Assumed, vec![]),
        "(1)" => Judgement {
            rests_on: vec![1],
            model: at(&[("m", "1"), ("v_y0", "-1/2")]),
            ..expected(one(Refuted, "m*(v_y - v_y0) = I_y"))
        },
        "(16)" => Judgement {
            rests_on: vec![1, 2],
            model: at(&[("alpha", "1")]),
            ..one(Proved, "k = (1 - alpha)/(1 + alpha)")
        },
        "range" => Judgement {
            rests_on: vec![1, 2],
            ..judged(Proved, vec![link("-1 < k", Proved), link("k < 1", Proved)])
        },
        "wrong" => one(Refuted, "k > 1"),
        "half" => expected(judged(Refuted, vec![link("k = 1/2", Refuted), link("k < 1", Proved)])),
        "lost" => Judgement {
            conditional: Proved,
            unproved: vec![6],
            rests_on: vec![2],
            ..judged(Unsupported, vec![link("k >= mu*abs(v_x)", Proved)])
        },
        "empty" => expected(one(Refuted, "contradiction")),
        "nothing" => expected(one(Vacuous, "r_0/r_0*m = m")),
        "pole" => Judgement { model: at(&[]), ..expected(one(IllDefined, "m/(k - 1) > 0")) },
        "open" => one(Undecided, "m^4 + mu^4 > m*mu - 1"),
        "μ-lim" => Judgement { model: at(&[]), ..one(Proved, "k -> -1 as alpha -> oo") },
        other => unreachable!("no judgement of {other} was made up"),
    }
}

fn judged(verdict: Verdict, links: Vec<LinkJudgement>) -> Judgement {
    Judgement {
        verdict,
        conditional: verdict,
        links,
        unproved: vec![],
        rests_on: vec![],
        model: None,
        met: None,
        expect: None,
    }
}

/// A link with a reason, a certificate and steps that fit its verdict.
fn link(text: &str, verdict: Verdict) -> LinkJudgement {
    let step = |depth, text: &str| Step { depth, text: text.to_owned() };
    let (reason, steps) = match verdict {
        Verdict::Proved => (
            "an identity after substitution of (2)",
            vec![
                step(0, "from (2): I_x = m*(v_x0 - v_x)"),
                step(1, "so both sides are equal:\n0 = 0"),
            ],
        ),
        Verdict::Refuted => (
            "at m = 1, v_y0 = -1/2 the sides are -1/2 and 3/2",
            vec![step(0, "m = 1, v_y0 = -1/2"), step(0, "left -1/2, right 3/2")],
        ),
        Verdict::IllDefined => ("at k = 1 the denominator k - 1 is zero", vec![]),
        Verdict::Vacuous => ("(2) and `when` contradict each other: 0 = 1 + m^2", vec![]),
        _ => ("no proof of degree <= 4 and no witness within 10000 steps", vec![]),
    };
    LinkJudgement {
        text: text.to_owned(),
        latex: text.replace("alpha", "\\alpha").replace('*', " "),
        verdict,
        reason: reason.to_owned(),
        certificate: (verdict != Verdict::Undecided)
            .then(|| "0123456789abcdef0123456789abcdef".to_owned()),
        used: if verdict == Verdict::Proved { vec![1] } else { vec![] },
        steps: steps.into(),
        cost: 12,
        accepted: None,
    }
}
