//! Whether a repair is equal to the formula that it repairs: a document of one claim, and its judgement.

use std::fmt::Write as _;

use kane_audit::{Budget, Options, Verdict, audit, read};
use kane_floats::{Core, Operation, Test, text};
use kane_kernel::Rel;

/// What the auditor says of `old = new` on the domain of both: their arguments between their bounds, and what
/// is assumed. `None` if it cannot be asked.
pub(super) fn equal(old: &Core, new: &Core) -> Option<Verdict> {
    let document = document(old, new)?;
    let document = read("repair.md", document.as_bytes()).ok()?;
    // equal forms are proved by normal forms, or not at all: a tenth of the usual effort tells
    let usual = Budget::default();
    let budget = Budget {
        steps: usual.steps / 10,
        fuel: usual.fuel / 10,
        squares: usual.squares / 10,
        document: usual.document / 10,
        ..usual
    };
    let audit = audit(document, &Options { budget, ..Options::default() }, &mut |_, _| {});
    audit.judgements.last().map(|judgement| judgement.verdict)
}

/// The document: names are its own, so that any name may come in.
pub(super) fn document(old: &Core, new: &Core) -> Option<String> {
    let (old, new) = (plain(old), plain(new));
    let mut text = "```kane\n".to_owned();
    for argument in &old.arguments {
        let less = |strict: bool| if strict { "<" } else { "<=" };
        text.push_str("var ");
        if let Some(lower) = &argument.lower {
            write!(text, "{} {} ", lower.value, less(lower.strict)).ok()?;
        }
        text.push_str(&argument.name);
        if let Some(upper) = &argument.upper {
            write!(text, " {} {}", less(upper.strict), upper.value).ok()?;
        }
        text.push('\n');
    }
    let mut cited = String::new();
    for (index, test) in old.assumed.iter().enumerate() {
        let Test::Compare(rel, a, b) = test else { return None };
        let rel = if *rel == Rel::Eq { "=" } else { text::sign(*rel) };
        let (a, b) = (text::infix(&old, *a), text::infix(&old, *b));
        writeln!(text, "given g{index}: {a} {rel} {b}").ok()?;
        write!(cited, "{} g{index}", if cited.is_empty() { " from" } else { "," }).ok()?;
    }
    let (a, b) = (old.text(), new.text());
    let cut = |text: &str| text.contains('…') || text.contains("(if ");
    if cut(&a) || cut(&b) {
        return None;
    }
    writeln!(text, "claim same: {a} = {b}{cited}\n```").ok()?;
    Some(text)
}

/// The formula over symbols v1, v2, …, fused operations taken apart.
fn plain(core: &Core) -> Core {
    let mut plain = core.clone();
    for (index, argument) in plain.arguments.iter_mut().enumerate() {
        argument.name = format!("v_{}", index + 1);
    }
    let mut program = kane_floats::Program::new();
    let mut moved: Vec<usize> = Vec::new();
    for operation in core.program.operations() {
        let at = |index: usize| moved.get(index).copied().unwrap_or(0);
        let copied = match *operation {
            Operation::Fma(a, b, c) => {
                let product = program.push(Operation::Mul(at(a), at(b)), 0..0);
                Operation::Add(product, at(c))
            }
            ref other => other.moved(&at),
        };
        moved.push(program.push(copied, 0..0));
    }
    plain.assumed = core
        .assumed
        .iter()
        .map(|test| test.moved(&|index| moved.get(index).copied().unwrap_or(0)))
        .collect();
    plain.root = moved.get(core.root).copied().unwrap_or(0);
    plain.program = program;
    plain
}
