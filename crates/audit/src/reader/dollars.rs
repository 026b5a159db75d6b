//! Formulas in LaTeX, between dollars, in the place of formulas of the language.

use std::borrow::Cow;
use std::ops::Range;

use kane_latex::{Names, statement};

use super::Fault;
use super::blocks::Blocks;
use crate::origin::Origin;

/// The text with every `$…$` of its statements in the notation of the language, and where in the file
/// its places are. It is this text that is judged and shown.
///
/// # Errors
/// The formulas that cannot be read, by their places.
pub(super) fn read<'t>(
    text: &'t str,
    blocks: &Blocks,
) -> Result<(Cow<'t, str>, Origin), Vec<Fault>> {
    let (mut faults, mut read) = (Vec::new(), Vec::new());
    let mut names = Names::default();
    for span in &blocks.statements {
        for formula in formulas(text, span, &mut faults) {
            let latex = &text[formula.start + 1..formula.end - 1];
            match statement(latex, &mut names) {
                Ok(found) if found.left_out.is_none() => read.push((formula, found.text())),
                Ok(_) => {
                    let message =
                        "a limit is written as `\\lim_{x \\to a} f = L`, or as `f \\to L`";
                    faults.push(Fault::new(formula, message.to_owned()));
                }
                Err(reason) => {
                    let message = format!("this formula cannot be read: {reason}");
                    faults.push(Fault::new(formula, message));
                }
            }
        }
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    if read.is_empty() {
        return Ok((Cow::Borrowed(text), Origin::default()));
    }
    let mut origin = Origin::default();
    let (mut out, mut from) = (String::with_capacity(text.len()), 0);
    for (formula, found) in read {
        out.push_str(&text[from..formula.start]);
        let start = out.len();
        out.push_str(&found);
        from = formula.end;
        origin.push(formula, start..out.len());
    }
    out.push_str(&text[from..]);
    Ok((Cow::Owned(out), origin))
}

/// Where the formulas of a statement stand, dollars included. In parentheses a dollar is one of a label.
fn formulas(text: &str, span: &Range<usize>, faults: &mut Vec<Fault>) -> Vec<Range<usize>> {
    let mut out = Vec::new();
    let (mut start, mut depth) = (span.start, 0usize);
    for line in text[span.clone()].split_inclusive('\n') {
        let mut from = 0;
        while let Some(at) = line[from..].find(['$', '#', '(', ')']).map(|at| from + at) {
            from = at + 1;
            match &line[at..from] {
                "(" => depth += 1,
                ")" => depth = depth.saturating_sub(1),
                "$" if depth == 0 => match line[from..].find('$') {
                    Some(length) => {
                        from += length + 1;
                        out.push(start + at..start + from);
                    }
                    None => {
                        let message = "a formula in dollars ends in its line".to_owned();
                        faults.push(Fault::new(start + at..start + from, message));
                        break;
                    }
                },
                "$" => {}
                _ => break,
            }
        }
        start += line.len();
    }
    out
}
