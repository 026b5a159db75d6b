//! An audit made by hand, with every verdict in it. Reports are tested on it, so that a change of the prover does
//! not change their snapshots.

use kane::audit::{
    Audit, Body, Claim, Content, Document, Judgement, LinkJudgement, Statement, Step, Verdict,
};
use kane::kernel::{Context, Sentence};

/// What the document says; the tests look the statements up by their first words.
const TEXT: &str = "\
# A sphere meets a wall

```kane
var m > 0, mu >= 0
let kW := 1 - 2*alpha
given (2): m*(vx - vx0) = -Ix      # as printed
given dom: alpha > 0
claim (1): m*(vy - vy0) = Iy  from (2)  expect refuted
claim (16): k = (1 - alpha)/(1 + alpha)
  from (2), dom                    # by hand: two lines
claim range: -1 < k < 1  from (16), dom
claim wrong: k > 1  from dom
claim half: k = 1/2, k < 1  from dom  expect refuted
claim lost: k_n >= mu*|vx|  from wrong
claim empty: contradiction  from (2), dom  expect refuted
claim nothing: 1/0*m = m  from (2)  expect vacuous
claim pole: m/(k - 1) > 0  expect ill-defined
claim open: m^4 + mu^4 > m*mu - 1
claim μ-lim: k -> -1 as alpha -> oo  from (16)
```
";

/// A judged document with every verdict, expected and not.
pub(crate) fn audit() -> Audit {
    let mut build = Build::default();
    build.add("kW", Kind::Let, "let kW", judged(Verdict::Defined, vec![]));
    build.add(
        "(2)",
        Kind::Given,
        "given (2)",
        judged(Verdict::Assumed, vec![]),
    );
    build.add(
        "dom",
        Kind::Given,
        "given dom",
        judged(Verdict::Assumed, vec![]),
    );

    let mut printed = judged(
        Verdict::Refuted,
        vec![link("m*(vy - vy0) = Iy", Verdict::Refuted)],
    );
    printed.expect = Some(Verdict::Refuted);
    printed.rests_on = vec![1];
    printed.model = Some(vec![
        ("m".into(), "1".into()),
        ("vy0".into(), "-1/2".into()),
    ]);
    build.add("(1)", Kind::Claim, "claim (1)", printed);

    let mut proved = judged(
        Verdict::Proved,
        vec![link("k = (1 - alpha)/(1 + alpha)", Verdict::Proved)],
    );
    proved.rests_on = vec![1, 2];
    proved.model = Some(vec![("alpha".into(), "1".into())]);
    build.add("(16)", Kind::Claim, "claim (16)", proved);

    let chain = vec![
        link("-1 < k", Verdict::Proved),
        link("k < 1", Verdict::Proved),
    ];
    let mut range = judged(Verdict::Proved, chain);
    range.rests_on = vec![1, 2];
    build.add("range", Kind::Claim, "claim range", range);

    build.add(
        "wrong",
        Kind::Claim,
        "claim wrong",
        judged(Verdict::Refuted, vec![link("k > 1", Verdict::Refuted)]),
    );

    let pair = vec![
        link("k = 1/2", Verdict::Refuted),
        link("k < 1", Verdict::Proved),
    ];
    let mut half = judged(Verdict::Refuted, pair);
    half.expect = Some(Verdict::Refuted);
    build.add("half", Kind::Claim, "claim half", half);

    let mut lost = judged(
        Verdict::Unsupported,
        vec![link("k_n >= mu*|vx|", Verdict::Proved)],
    );
    lost.conditional = Verdict::Proved;
    lost.unproved = vec![6];
    lost.rests_on = vec![2];
    build.add("lost", Kind::Claim, "claim lost", lost);

    let mut empty = judged(
        Verdict::Refuted,
        vec![link("contradiction", Verdict::Refuted)],
    );
    empty.expect = Some(Verdict::Refuted);
    build.add("empty", Kind::Claim, "claim empty", empty);

    let mut vacuous = judged(Verdict::Vacuous, vec![link("1/0*m = m", Verdict::Vacuous)]);
    vacuous.expect = Some(Verdict::Vacuous);
    build.add("nothing", Kind::Claim, "claim nothing", vacuous);

    let mut pole = judged(
        Verdict::IllDefined,
        vec![link("m/(k - 1) > 0", Verdict::IllDefined)],
    );
    pole.expect = Some(Verdict::IllDefined);
    pole.model = Some(vec![]);
    build.add("pole", Kind::Claim, "claim pole", pole);

    let undecided = vec![link("m^4 + mu^4 > m*mu - 1", Verdict::Undecided)];
    build.add(
        "open",
        Kind::Claim,
        "claim open",
        judged(Verdict::Undecided, undecided),
    );

    let mut limit = judged(
        Verdict::Proved,
        vec![link("k -> -1 as alpha -> oo", Verdict::Proved)],
    );
    limit.model = Some(vec![]);
    build.add("μ-lim", Kind::Claim, "claim μ-lim", limit);
    build.audit()
}

enum Kind {
    Let,
    Given,
    Claim,
}

#[derive(Default)]
struct Build {
    statements: Vec<Statement>,
    judgements: Vec<Judgement>,
}

impl Build {
    fn add(&mut self, label: &str, kind: Kind, start: &str, judgement: Judgement) {
        let begin = TEXT.find(start).expect("the statement is in the text");
        let rest = &TEXT[begin..];
        let end = rest
            .match_indices('\n')
            .map(|(at, _)| at)
            .find(|&at| !rest[at + 1..].starts_with(' '))
            .expect("the text goes on after every statement");
        let nothing = Sentence {
            when: vec![],
            links: vec![],
        };
        let body = match kind {
            Kind::Let => Body::Let(0),
            Kind::Given => Body::Given(nothing),
            Kind::Claim => Body::Claim(Claim {
                content: Content::Links(vec![]),
                when: vec![],
                from: vec![],
                by: vec![],
                expect: judgement.expect,
            }),
        };
        self.statements.push(Statement {
            label: label.to_owned(),
            body,
            span: begin..begin + end,
            line: TEXT[..begin].matches('\n').count() + 1,
        });
        self.judgements.push(judgement);
    }

    fn audit(self) -> Audit {
        Audit {
            document: Document {
                name: "wall.md".to_owned(),
                text: TEXT.to_owned(),
                title: Some("A sphere meets a wall".to_owned()),
                context: Context::default(),
                statements: self.statements,
            },
            judgements: self.judgements,
        }
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
        expect: None,
    }
}

/// A link with a reason, a certificate and steps that fit its verdict.
fn link(text: &str, verdict: Verdict) -> LinkJudgement {
    let step = |depth, text: &str| Step {
        depth,
        text: text.to_owned(),
    };
    let (reason, steps) = match verdict {
        Verdict::Proved => (
            "an identity after substitution of (2)",
            vec![
                step(0, "from (2): Ix = m*(vx0 - vx)"),
                step(1, "so both sides are equal:\n0 = 0"),
            ],
        ),
        Verdict::Refuted => (
            "at m = 1, vy0 = -1/2 the sides are -1/2 and 3/2",
            vec![
                step(0, "m = 1, vy0 = -1/2"),
                step(0, "left -1/2, right 3/2"),
            ],
        ),
        Verdict::IllDefined => ("at k = 1 the denominator k - 1 is zero", vec![]),
        Verdict::Vacuous => ("(2) and `when` contradict each other: 0 = 1 + m^2", vec![]),
        _ => (
            "no proof of degree <= 4 and no witness within 10000 steps",
            vec![],
        ),
    };
    LinkJudgement {
        text: text.to_owned(),
        latex: text.replace("alpha", "\\alpha").replace('*', " "),
        verdict,
        reason: reason.to_owned(),
        certificate: (verdict != Verdict::Undecided)
            .then(|| "0123456789abcdef0123456789abcdef".to_owned()),
        used: if verdict == Verdict::Proved {
            vec![1]
        } else {
            vec![]
        },
        steps,
        cost: 12,
    }
}
