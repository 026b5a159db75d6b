//! Remarks beside the lines of a file: what an audit or a log comes to, for tools that show it where it
//! stands. [`sarif`] is for scanners of code and editors, [`workflow`] for the log of a workflow.

mod sarif;
mod workflow;

use kane_audit::{Diagnostic, Verdict};

use crate::Report;
use crate::records::RecordsReport;
use crate::records::told;
use crate::words::Form;

pub use sarif::sarif;
pub use workflow::workflow;

/// How a remark is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// it is not as it should be
    Error,
    /// it is as its author expects, and worth knowing
    Note,
    /// it is proved, or holds
    Pass,
}

/// A remark about a line of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Remark {
    /// the file, as its user named it
    pub file: String,
    /// the line, from 1; `None` where it is about the whole file
    pub line: Option<usize>,
    /// how it is meant
    pub level: Level,
    /// what kind of remark it is: a verdict, or the id of a check
    pub rule: String,
    /// in a few words, what it is about
    pub title: String,
    /// what is to be said
    pub message: String,
}

/// A remark for every claim that a report shows: its verdict, the reason for it, and what its author
/// expects where that is something else. Without a claim there is one that says so.
#[must_use]
pub fn of_audit(report: &Report<'_>) -> Vec<Remark> {
    let claims = report.entries().filter(|entry| entry.is_claim());
    let remark = |entry: crate::report::Entry<'_>| {
        let verdict = entry.judgement.verdict;
        let level = match (entry.judgement.as_expected(), verdict) {
            (false, _) => Level::Error,
            (true, Verdict::Proved) => Level::Pass,
            (true, _) => Level::Note,
        };
        let told = entry.judgement.links.iter().filter(|link| link.verdict == verdict);
        let reasons: Vec<String> = told.map(|link| entry.reason(link, Form::Plain)).collect();
        let expected = match entry.judgement.expect {
            Some(expected) if expected != verdict => format!("; expected {expected}"),
            _ => String::new(),
        };
        let mut message = format!("{verdict}{expected}: {}", entry.saying());
        for reason in entry.support().into_iter().chain(reasons) {
            message.push_str(&format!("\n{reason}"));
        }
        Remark {
            file: report.audit.document.name.clone(),
            line: Some(entry.statement.line),
            level,
            rule: verdict.to_string(),
            title: format!("claim {}", entry.statement.label),
            message,
        }
    };
    let remarks: Vec<Remark> = claims.map(remark).collect();
    if !remarks.is_empty() {
        return remarks;
    }
    vec![Remark {
        file: report.audit.document.name.clone(),
        line: None,
        level: Level::Error,
        rule: "nothing".to_owned(),
        title: "no claim".to_owned(),
        message: "there is no claim, so that nothing is checked".to_owned(),
    }]
}

/// A remark for a fault in the text of a document, with the hint at its remedy.
#[must_use]
pub fn of_fault(fault: &Diagnostic) -> Remark {
    let hint = fault.note.as_ref().map(|note| format!("\n{note}")).unwrap_or_default();
    let message = format!("{}{hint}", fault.message);
    Remark { line: Some(fault.line), ..unread(&fault.file, message) }
}

/// A remark for a file that cannot be checked, and why.
#[must_use]
pub fn unread(file: &str, why: String) -> Remark {
    Remark {
        file: file.to_owned(),
        line: None,
        level: Level::Error,
        rule: "unread".to_owned(),
        title: "cannot be checked".to_owned(),
        message: why,
    }
}

/// A remark for every check of a log that was asked, at its worst row; one for each row that was
/// rejected and is listed, and one for each suspicion.
#[must_use]
pub fn of_log(report: &RecordsReport<'_>) -> Vec<Remark> {
    let remark = |line: u64, level, rule: &str, title: &str, message: String| Remark {
        file: report.log.to_owned(),
        line: usize::try_from(line).ok().filter(|line| *line > 0),
        level,
        rule: rule.to_owned(),
        title: title.to_owned(),
        message,
    };
    let mut remarks = Vec::new();
    for checked in report.study.checks.iter().filter(|checked| checked.rows > 0) {
        let level = match (checked.as_expected(), checked.failed) {
            (false, _) => Level::Error,
            (true, 0) => Level::Pass,
            (true, _) => Level::Note,
        };
        let worst = checked.worst.filter(|_| checked.failed + checked.undecided > 0);
        let line = worst.map_or(0, |(line, _)| line);
        let (asks, outcome) = told(checked);
        remarks.push(remark(line, level, checked.check.id(), asks, outcome));
    }
    for (kind, _, listed) in report.study.rejections.kinds() {
        for row in listed {
            remarks.push(remark(row.line, Level::Error, "rows", kind, row.why.clone()));
        }
    }
    for suspected in &report.study.suspicions {
        let message = crate::records::suspected(suspected);
        remarks.push(remark(0, Level::Error, "units", "units and axes are plausible", message));
    }
    if report.study.rows == 0 {
        let message = "no row could be checked".to_owned();
        remarks.push(remark(0, Level::Error, "rows", "every row can be checked", message));
    }
    remarks
}
