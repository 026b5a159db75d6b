//! What was judged before is not judged again, and nobody can tell from the audit.

use std::fmt::Write as _;
use std::path::Path;

use crate::many::{all, share};
use kane_audit::{Audit, Budget, Memo, Options, Verdict, audit, audit_again, read};

/// Edits of one document.
const EDITS: usize = 5;

fn options() -> Options {
    let budget = Budget {
        steps: 60,
        fuel: 60_000,
        check: 3_000_000,
        functions: 3,
        squares: 20_000,
        cells: 5_000,
        ..Budget::default()
    };
    Options { only: None, budget }
}

/// Everything that is in an audit but the text.
fn all_of(audit: &Audit) -> String {
    format!("{:?}", audit.judgements)
}

/// Audits the text with the memo and without; `None` if it cannot be read.
fn both(text: &str, memo: &mut Memo) -> Option<(String, String)> {
    let document = read("d.md", text.as_bytes()).ok()?;
    let fresh = audit(document.clone(), &options(), &mut |_, _| {});
    let again = audit_again(document, &options(), memo, &mut |_, _| true).expect("it goes on");
    Some((all_of(&fresh), all_of(&again)))
}

/// The documents of these folders, in the order of their names.
fn documents() -> Vec<(String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut found = Vec::new();
    for folder in ["docs/derivations", "tests/conformance/semantics"] {
        let entries = std::fs::read_dir(root.join(folder)).expect("the folder is there");
        for entry in entries {
            let path = entry.expect("it can be listed").path();
            if path.extension().is_some_and(|ending| ending == "md") {
                let text = std::fs::read_to_string(&path).expect("it is text");
                found.push((path.display().to_string(), text));
            }
        }
    }
    found.sort();
    found
}

/// Numbers that look random.
struct Dice(u64);

impl Dice {
    fn below(&mut self, most: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        usize::try_from(self.0 % most.max(1) as u64).expect("it is below a length")
    }
}

/// One edit, as somebody makes it who writes: of a line, a digit, a sign, a word.
fn edited(text: &str, dice: &mut Dice) -> String {
    let lines: Vec<&str> = text.lines().collect();
    let statements: Vec<usize> = (0..lines.len())
        .filter(|i| ["var ", "let ", "given ", "claim "].iter().any(|k| lines[*i].starts_with(k)))
        .collect();
    if statements.is_empty() {
        return text.to_owned();
    }
    let at = statements[dice.below(statements.len())];
    let other = statements[dice.below(statements.len())];
    let mut new: Vec<String> = lines.iter().map(|line| (*line).to_owned()).collect();
    let line = new[at].clone();
    match dice.below(9) {
        0 => drop(new.remove(at)),
        1 => new.swap(at, other),
        2 => new[at] = line.replacen(['1', '2'], &dice.below(5).to_string(), 1),
        3 => {
            let signs = [" = ", " < ", " <= ", " > ", " >= ", " != "];
            let from = signs.iter().find(|sign| line.contains(**sign)).unwrap_or(&" = ");
            new[at] = line.replacen(from, signs[dice.below(signs.len())], 1);
        }
        4 => {
            // one citation less
            if let Some((head, tail)) = line.split_once(" from ") {
                let kept =
                    tail.split_once(", ").map_or(String::new(), |(_, t)| format!(" from {t}"));
                new[at] = format!("{head}{kept}");
            }
        }
        5 => {
            new[at] = match line.split_once(" expect ") {
                Some((head, _)) => head.to_owned(),
                None if line.starts_with("claim") => format!("{line} expect refuted"),
                None => line,
            };
        }
        6 => new[at] = line.replacen(" + ", " - ", 1),
        7 => new.insert(at, format!("given extra{}: 1 {} 1", dice.0 % 9_999, [">=", "<="][at % 2])),
        _ => {
            // what is cited comes from elsewhere
            let from = lines[other].split(':').next().unwrap_or_default();
            let label = from.split_whitespace().nth(1).unwrap_or_default();
            if line.starts_with("claim") && !line.contains(" from ") {
                new[at] = format!("{line} from {label}");
            }
        }
    }
    let mut out = String::new();
    for line in new {
        let _ = writeln!(out, "{line}");
    }
    out
}

/// Audits of edited documents, and how many of their claims were judged and how many known.
fn edits(documents: &[(String, String)]) -> (u32, u64, u64) {
    let mut counts = (0, 0, 0);
    for (number, (name, source)) in documents.iter().enumerate() {
        let mut dice = Dice(0x9E37_79B9_7F4A_7C15 ^ (number as u64 + 1));
        let mut memo = Memo::default();
        let mut text = source.clone();
        for _ in 0..EDITS {
            let next = edited(&text, &mut dice);
            let Some((fresh, again)) = both(&next, &mut memo) else { continue };
            assert_eq!(fresh, again, "{name}:\n{next}");
            counts.0 += 1;
            // from time to time all is taken back
            text = if dice.below(6) == 0 { source.clone() } else { next };
        }
        let (judged, known) = memo.counts();
        counts = (counts.0, counts.1 + judged, counts.2 + known);
    }
    counts
}

#[test]
fn what_is_known_is_what_a_fresh_audit_says_after_any_edits() {
    // what is long takes long
    let documents = documents().into_iter().filter(|(_, source)| source.len() <= 6_000);
    let documents: Vec<_> = share(documents).collect();
    // the longest of these tests: alone it would leave a core idle
    let (first, second) = documents.split_at(documents.len() / 2);
    let (a, b) = std::thread::scope(|scope| {
        let other = scope.spawn(|| edits(first));
        (edits(second), other.join().expect("one half panicked"))
    });
    let (audits, judged, known) = (a.0 + b.0, a.1 + b.1, a.2 + b.2);
    println!("{audits} audits; {judged} claims judged and {known} known");
    let least = if all() { 100 } else { 80 };
    assert!(audits > least && known > least.into(), "{audits} audits, {known} known");
}

/// The verdicts after each of these texts, one memo for all of them.
fn verdicts(texts: &[&str]) -> Vec<Vec<Verdict>> {
    let mut memo = Memo::default();
    let each = |text: &&str| {
        let text = format!("# T\n\n```kane\n{text}\n```\n");
        let (fresh, again) = both(&text, &mut memo).expect("it can be read");
        assert_eq!(fresh, again, "{text}");
        let document = read("d.md", text.as_bytes()).expect("it was read before");
        let audit = audit_again(document, &options(), &mut memo, &mut |_, _| true);
        audit.expect("it goes on").judgements.iter().map(|j| j.verdict).collect()
    };
    texts.iter().map(each).collect()
}

#[test]
fn a_claim_is_judged_anew_when_what_it_reads_has_changed() {
    use Verdict::{Assumed, Defined, Proved, Refuted, Unsupported};
    let bound = verdicts(&["var x > 0\nclaim a: x > 0", "var x >= 0\nclaim a: x > 0"]);
    assert_eq!(bound, [[Proved], [Refuted]]);
    let definition = verdicts(&[
        "var x > 0\nlet f := x\nclaim a: f > 0",
        "var x > 0\nlet f := -x\nclaim a: f > 0",
    ]);
    assert_eq!(definition, [[Defined, Proved], [Defined, Refuted]]);
    let within = verdicts(&[
        "var x > 0\nlet g := x\nlet f := g\nclaim a: f > 0",
        "var x > 0\nlet g := -x\nlet f := g\nclaim a: f > 0",
    ]);
    assert_eq!(within, [[Defined, Defined, Proved], [Defined, Defined, Refuted]]);
    let premise = verdicts(&[
        "var x\ngiven p: x > 0\nclaim a: x > 0 from p",
        "var x\ngiven p: x > -1\nclaim a: x > 0 from p",
    ]);
    assert_eq!(premise, [[Assumed, Proved], [Assumed, Refuted]]);
    let support = verdicts(&[
        "var x > 0\nclaim a: x > 0\nclaim b: x > -1 from a",
        "var x > 0\nclaim a: x > 1\nclaim b: x > -1 from a",
    ]);
    assert_eq!(support, [[Proved, Proved], [Refuted, Unsupported]]);
    let denied = verdicts(&[
        "var x\ngiven p: x > 0\ngiven q: x > -1\nclaim a: not implied q from p",
        "var x\ngiven p: x > 0\ngiven q: x > 1\nclaim a: not implied q from p",
    ]);
    assert_ne!(denied[0], denied[1]);
}

#[test]
fn a_given_that_would_do_is_named_though_nothing_else_changed() {
    let text = |given: &str| {
        format!(
            "# T\n\n```kane\nvar x\ngiven p: {given}\ngiven q: x < 9\nclaim a: x > 0 from q\n```\n"
        )
    };
    let mut memo = Memo::default();
    let mut would_do = Vec::new();
    for given in ["x > -5", "x > 1", "x > -5"] {
        let (fresh, again) = both(&text(given), &mut memo).expect("it can be read");
        assert_eq!(fresh, again);
        let document = read("d.md", text(given).as_bytes()).expect("it was read before");
        let audit = audit(document, &options(), &mut |_, _| {});
        would_do.push(audit.judgements[2].links[0].would_do);
    }
    assert_eq!(would_do, [None, Some(0), None]);
}

#[test]
fn nothing_is_judged_again_where_only_prose_and_expectations_change() {
    let text = |prose: &str, end: &str| {
        format!(
            "# {prose}\n\n```kane\nvar x > 0\nclaim a: x > 0\n```\n{prose}\n```kane\nclaim b: x > 1{end}\n```\n"
        )
    };
    let mut memo = Memo::default();
    for (prose, end) in [("A", ""), ("Much longer\nprose", ""), ("A", "  expect refuted # so")] {
        let (fresh, again) = both(&text(prose, end), &mut memo).expect("it can be read");
        assert_eq!(fresh, again);
    }
    assert_eq!(memo.counts(), (2, 4));
}

#[test]
fn an_audit_that_is_broken_off_leaves_nothing_wrong_behind() {
    let text = "# T\n\n```kane\nvar x > 0\nclaim a: x > 0\nclaim b: x > 1 from a\nclaim c: x >= 0 from a\n```\n";
    let document = read("d.md", text.as_bytes()).expect("it can be read");
    let mut memo = Memo::default();
    for stop in 0..3 {
        let stopped =
            audit_again(document.clone(), &options(), &mut memo, &mut |done, _| done < stop);
        assert!(stopped.is_none());
    }
    let (fresh, again) = both(text, &mut memo).expect("it can be read");
    assert_eq!(fresh, again);
}
