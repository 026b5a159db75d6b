//! `kane draft`: a paper in LaTeX or Markdown as a draft of a derivation document.

use std::fmt::Write as _;
use std::path::Path;

use kane::algebra::syntax::visible;
use kane::audit::{Diagnostic, read};
use kane::latex::{Draft, Format, draft};

use super::args::DraftArgs;
use super::input;
use super::{Outcome, bad_input, output};

/// How often what the reader of documents does not take is taken out.
const ROUNDS: usize = 100;

/// Runs the verb.
pub(super) fn run(args: &DraftArgs) -> Outcome {
    let (inputs, unreadable) = input::read(std::slice::from_ref(&args.file));
    let Some(input) = inputs.into_iter().next() else {
        let messages: Vec<String> = unreadable.into_iter().map(|file| file.message).collect();
        return bad_input(&messages.join("; "));
    };
    if input.bytes.len() > kane::audit::MAX_FILE_BYTES {
        let most = kane::audit::MAX_FILE_BYTES;
        return bad_input(&format!("{} has more than {most} bytes", input.name));
    }
    let Ok(text) = std::str::from_utf8(&input.bytes) else {
        output::to_stderr(&Diagnostic::not_utf8(&input.name, &input.bytes).to_string());
        return Outcome::BadInput;
    };
    let mut draft = draft(text, format(&args.file));
    if draft.equations.is_empty() {
        bad_input(&format!("{} has no displayed equation", input.name));
        return Outcome::Nothing;
    }
    settle(&mut draft);
    if let Err(error) = output::to_stdout(&draft.document) {
        return bad_input(&format!("cannot print: {error}"));
    }
    output::to_stderr(&summary(&input.name, &draft));
    if draft.equations.iter().all(|equation| equation.fault.is_none()) {
        Outcome::AsExpected
    } else {
        Outcome::Unexpected
    }
}

/// How a source is written, by its name; standard input is LaTeX.
fn format(file: &Path) -> Format {
    let ending = file.extension().unwrap_or_default().to_ascii_lowercase();
    if ending == "md" || ending == "markdown" { Format::Markdown } else { Format::Latex }
}

/// Takes out statements until the reader of documents takes the rest: what is printed can be audited.
fn settle(draft: &mut Draft) {
    for _ in 0..ROUNDS {
        let Err(faults) = read("draft.md", draft.document.as_bytes()) else { return };
        // from below, so that lines above keep their numbers
        let mut faults = faults;
        faults.sort_by_key(|fault| std::cmp::Reverse(fault.line));
        faults.dedup_by_key(|fault| fault.line);
        // what a claim rests on is a guess: no formula is to blame for it
        let refuse = |fault: &&Diagnostic| {
            draft.refuse_citation(fault.line, fault.column, &fault.message)
                || draft.refuse(fault.line, &fault.message)
        };
        let refused = faults.iter().filter(refuse).count();
        if refused == 0 {
            return;
        }
    }
}

fn summary(name: &str, draft: &Draft) -> String {
    let all = draft.equations.len();
    let unread: Vec<_> = draft
        .equations
        .iter()
        .filter_map(|equation| Some((equation, equation.fault.as_ref()?)))
        .collect();
    let name = visible(name);
    let mut out = format!("{name}: {} of {all} equations are statements now\n", all - unread.len());
    for (equation, fault) in unread {
        let (label, fault) = (visible(&equation.label), fault.to_string());
        let fault = visible(&fault);
        let _ = writeln!(out, "  line {}: {label} is not read: {fault}", equation.line);
    }
    out
}
