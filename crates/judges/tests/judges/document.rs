//! Small documents, the goals in them, and points.

use std::collections::HashMap;

use kane_audit::{Accepted, Audit, Body, Content, Document, Options, audit, read};
use kane_judges::smt::{NotPut, question};
use kane_kernel::{
    Certificate, Conclusion, Evidence, Finding, Goal, Hypothesis, Model, Point, Proof, Sentence,
    digest,
};
use num_rational::BigRational;

use crate::smt::Question;

pub(crate) type Q = BigRational;

/// n/d
pub(crate) fn q(n: i64, d: i64) -> Q {
    Q::new(n.into(), d.into())
}

/// An integer.
pub(crate) fn whole(n: i64) -> Q {
    Q::from_integer(n.into())
}

/// Values that are tried of each symbol: both signs, on both sides of 0 and 1, and squares of fractions.
pub(crate) const TRIED: [(i64, i64); 9] =
    [(-2, 1), (-1, 1), (-1, 4), (0, 1), (1, 4), (1, 2), (1, 1), (9, 4), (4, 1)];

/// The document of these statements.
pub(crate) fn document(statements: &str) -> Document {
    let text = format!("# Of a test\n\n```kane\n{statements}\n```\n");
    read("test.md", text.as_bytes()).unwrap_or_else(|faults| {
        unreachable!("{}", faults.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n"))
    })
}

/// The audit of these statements.
pub(crate) fn judged(statements: &str) -> Audit {
    audit(document(statements), &Options::default(), &mut |_, _| {})
}

/// The last statement as a goal behind the others, whether it is true or not.
pub(crate) fn goal(statements: &str) -> Goal {
    let document = document(statements);
    let said = |body: &Body| match body {
        Body::Given(sentence) => Some((sentence.clone(), true)),
        Body::Claim(claim) => match &claim.content {
            Content::Links(links) => {
                let links = links.iter().map(|(link, _)| link.clone()).collect();
                Some((Sentence { when: claim.when.clone(), links }, false))
            }
            _ => None,
        },
        _ => None,
    };
    let all: Vec<_> = document.statements.iter().filter_map(|s| said(&s.body)).collect();
    let (last, premises) = all.split_last().expect("a claim");
    let hypothesis = |(sentence, given): &(Sentence, bool)| Hypothesis {
        sentence: sentence.clone(),
        given: *given,
    };
    Goal {
        context: document.context.clone(),
        hypotheses: premises.iter().map(hypothesis).collect(),
        behind: Vec::new(),
        when: last.0.when.clone(),
        conclusion: Conclusion::Link(last.0.links[0].clone()),
    }
}

/// A finding that nothing shows: what is asked about it is asked all the same.
pub(crate) fn found(goal: Goal, finding: Finding, at: Option<Point>) -> Accepted {
    let evidence = match at {
        Some(point) => Evidence::Model(Model::Point(point)),
        None => {
            Evidence::Contradiction(Proof::Positive { terms: Vec::new(), cofactors: Vec::new() })
        }
    };
    Accepted { certificate: Certificate { goal: digest(&goal), finding, evidence }, goal }
}

/// What is asked where these statements are found to be so.
pub(crate) fn text(statements: &str, finding: Finding) -> Result<String, NotPut> {
    question(&found(goal(statements), finding, None)).map(|asked| asked.text)
}

/// The last statement as one that does not follow.
pub(crate) fn not_implied(statements: &str) -> Goal {
    let goal = goal(statements);
    let Conclusion::Link(link) = goal.conclusion else { unreachable!("a link") };
    let sentence = Sentence { when: goal.when, links: vec![link] };
    Goal { when: Vec::new(), conclusion: Conclusion::NotImplied(sentence), ..goal }
}

/// All points over the values that are tried.
pub(crate) fn points(symbols: usize) -> Vec<Vec<Q>> {
    (0..symbols).fold(vec![Vec::new()], |points, _| {
        let with = |point: &Vec<Q>, (n, d): (i64, i64)| {
            point.iter().cloned().chain([q(n, d)]).collect::<Vec<Q>>()
        };
        points.iter().flat_map(|point| TRIED.map(|value| with(point, value))).collect()
    })
}

/// Holds what is asked against what it should ask, at all points that are tried. Roots are written `|root N|`, and have
/// the values that are given them.
pub(crate) fn assert_asks(
    text: &str,
    symbols: &[&str],
    roots: impl Fn(&[Q]) -> Vec<Q>,
    wanted: impl Fn(&[Q]) -> bool,
) {
    let question = Question::read(text).unwrap_or_else(|why| unreachable!("{why}\n{text}"));
    let (mut some, mut none) = (0, 0);
    for point in points(symbols.len()) {
        let mut values: HashMap<String, Q> =
            symbols.iter().map(|s| format!("|{s}|")).zip(point.iter().cloned()).collect();
        let roots = roots(&point);
        values.extend((1..).map(|i| format!("|root {i}|")).zip(roots));
        assert!(question.declared.iter().all(|name| values.contains_key(name)), "{text}");
        let holds = question.holds(&values);
        assert_eq!(holds, Ok(wanted(&point)), "at {point:?} of\n{text}");
        *(if holds == Ok(true) { &mut some } else { &mut none }) += 1;
    }
    assert!(some > 0 && none > 0, "the points tell nothing apart: {some}, {none}\n{text}");
}

/// Holds what is asked against nothing: it holds at no point that is tried.
pub(crate) fn assert_asks_nothing(text: &str, symbols: &[&str]) {
    let question = Question::read(text).unwrap_or_else(|why| unreachable!("{why}\n{text}"));
    for point in points(symbols.len()) {
        let values = symbols.iter().map(|s| format!("|{s}|")).zip(point.iter().cloned());
        assert_eq!(question.holds(&values.collect()), Ok(false), "at {point:?} of\n{text}");
    }
}
