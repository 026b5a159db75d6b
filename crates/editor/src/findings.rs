//! What an audit found, as plain data that can go from one thread to another.

use std::ops::Range;

use kane_audit::{Audit, Body, Diagnostic, Origin, Verdict};
use kane_report::Report;
use kane_report::remarks::of_audit;
use serde_json::{Value, json};

use crate::position::Lines;

/// What was found of one text.
#[derive(Clone, Debug)]
pub(crate) enum Findings {
    /// it cannot be read
    Faults(Vec<Fault>),
    /// its statements, in the order of the text
    Judged(Vec<Stated>),
}

/// Something wrong with a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Fault {
    place: Range<usize>,
    message: String,
}

/// A statement.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Stated {
    /// the whole of it
    pub(crate) place: Range<usize>,
    /// its label
    label: Range<usize>,
    /// of a claim, how it fares
    claim: Option<Judged>,
}

/// How a claim fares.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Judged {
    verdict: Verdict,
    as_expected: bool,
    /// whether something other than `proved` is expected and found
    is_foreseen: bool,
    message: String,
}

impl Findings {
    /// What is wrong with a text that cannot be read.
    pub(crate) fn faults(found: Vec<Diagnostic>, origin: &Origin) -> Self {
        let fault = |fault: Diagnostic| {
            let mut message = fault.message;
            if let Some(note) = fault.note {
                message.push('\n');
                message.push_str(&note);
            }
            Fault { place: origin.in_file(fault.span), message }
        };
        Self::Faults(found.into_iter().map(fault).collect())
    }

    /// That the judge itself has failed.
    pub(crate) fn broken() -> Self {
        let message = "the judge has failed on this document; please report it".to_owned();
        Self::Faults(vec![Fault { place: 0..0, message }])
    }

    /// What an audit comes to.
    pub(crate) fn of(audit: &Audit, origin: &Origin) -> Self {
        // one remark a claim, in the order of the text
        let mut remarks = of_audit(&Report::new(audit, "kane audit")).into_iter();
        let stated = audit.document.statements.iter().zip(&audit.judgements);
        let stated = stated.map(|(statement, judgement)| {
            let is_claim = matches!(statement.body, Body::Claim(_));
            let claim = is_claim.then(|| Judged {
                verdict: judgement.verdict,
                as_expected: judgement.as_expected(),
                is_foreseen: judgement.as_expected() && judgement.verdict != Verdict::Proved,
                message: remarks.next().map_or_else(String::new, |remark| remark.message),
            });
            let (place, label) = (statement.span.clone(), statement.parts.label.clone());
            Stated { place: origin.in_file(place), label: origin.in_file(label), claim }
        });
        Self::Judged(stated.collect())
    }

    /// The statements; none of a text that cannot be read.
    pub(crate) fn stated(&self) -> &[Stated] {
        match self {
            Self::Faults(_) => &[],
            Self::Judged(stated) => stated,
        }
    }

    /// The diagnostics of the protocol: errors of the text, and verdicts that are not the expected ones.
    pub(crate) fn diagnostics(&self, text: &str, lines: &Lines) -> Vec<Value> {
        let diagnostic = |place: &Range<usize>, severity: u8, code: &str, message: &str| {
            json!({
                "range": lines.range(text, place),
                "severity": severity,
                "code": code,
                "source": "kane",
                "message": message,
            })
        };
        match self {
            Self::Faults(faults) => {
                let shown = |fault: &Fault| diagnostic(&fault.place, 1, "syntax", &fault.message);
                faults.iter().map(shown).collect()
            }
            Self::Judged(stated) => {
                let shown = |stated: &Stated| {
                    let claim = stated.claim.as_ref().filter(|claim| !claim.as_expected)?;
                    let code = claim.verdict.to_string();
                    Some(diagnostic(&stated.label, severity(claim.verdict), &code, &claim.message))
                };
                stated.iter().filter_map(shown).collect()
            }
        }
    }

    /// The verdicts in the margin of these bytes, each at the end of the last line of its claim.
    pub(crate) fn hints(&self, text: &str, lines: &Lines, within: &Range<usize>) -> Vec<Value> {
        let hint = |stated: &Stated| {
            let claim = stated.claim.as_ref()?;
            let end = lines.line(text, lines.line_of(stated.place.end)).end;
            if end < within.start || within.end < end {
                return None;
            }
            let (mark, verdict) = (mark(claim), claim.verdict);
            let foreseen = if claim.is_foreseen { ", as expected" } else { "" };
            Some(json!({
                "position": lines.range(text, &(end..end))["start"],
                "label": format!("{mark} {verdict}{foreseen}"),
                "paddingLeft": true,
                "tooltip": claim.message,
            }))
        };
        self.stated().iter().filter_map(hint).collect()
    }
}

/// 1 is an error, 2 a warning.
const fn severity(verdict: Verdict) -> u8 {
    match verdict {
        Verdict::Refuted | Verdict::IllDefined | Verdict::Vacuous => 1,
        _ => 2,
    }
}

/// A sign that tells what is well from what is not, without colours.
const fn mark(claim: &Judged) -> &'static str {
    match (claim.as_expected, claim.verdict) {
        (true, _) => "✓",
        (false, Verdict::Undecided | Verdict::Unsupported) => "?",
        (false, _) => "✗",
    }
}
