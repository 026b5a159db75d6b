//! What the suites share: deterministic chance, documents, goals, and how much to do.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use kane::algebra::syntax::Notation;
use kane::audit::{Audit, Body, Claim, Content, Document, Options, audit, read};
use kane::kernel::{Conclusion, Expr, Goal, Hypothesis, Link, Sentence};
use num_rational::BigRational;

pub(crate) type Q = BigRational;

/// n/d
pub(crate) fn q(n: i64, d: i64) -> Q {
    Q::new(n.into(), d.into())
}

/// An integer as an expression.
pub(crate) fn num(value: &Q) -> Expr {
    Expr::Num(value.clone())
}

/// Whether a program that a test needs can be run. If not, the test says that it is skipped; the gate
/// installs the programs and sets `KANE_REQUIRE_JUDGES`, so that nothing is skipped there.
pub(crate) fn installed(program: &str) -> bool {
    let found = kane::judges::is_installed(program);
    let required = std::env::var_os("KANE_REQUIRE_JUDGES").is_some();
    assert!(found || !required, "{program} is not installed");
    if !found {
        println!("skipped: {program} is not installed");
    }
    found
}

/// The generator of Steele, Lea and Flood (2014), *SplitMix*: the same numbers on every machine.
pub(crate) struct Chance(u64);

impl Chance {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// One of 0, …, n − 1.
    pub(crate) fn below(&mut self, n: usize) -> usize {
        let n = u64::try_from(n.max(1)).expect("a length fits");
        usize::try_from(self.next() % n).expect("less than a length")
    }

    /// An integer from lo to hi, both included.
    pub(crate) fn within(&mut self, lo: i64, hi: i64) -> i64 {
        let span = usize::try_from(hi - lo + 1).expect("an ordered range");
        lo + i64::try_from(self.below(span)).expect("a small range")
    }

    /// True once in n times.
    pub(crate) fn once_in(&mut self, n: usize) -> bool {
        self.below(n) == 0
    }

    pub(crate) fn pick<'a, T>(&mut self, all: &'a [T]) -> &'a T {
        &all[self.below(all.len())]
    }
}

/// A table is what its snapshot in `snapshots/conformance` says.
pub(crate) fn assert_snapshot(name: &str, table: &str) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(root().join("snapshots/conformance"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, table));
}

pub(crate) fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The Markdown files right under `folder`, sorted: name and bytes.
pub(crate) fn pages(folder: &str) -> Vec<(String, Vec<u8>)> {
    let entries = fs::read_dir(root().join(folder)).expect("the folder is there");
    let mut pages: Vec<PathBuf> = entries
        .map(|entry| entry.expect("the folder is readable").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "md"))
        .collect();
    pages.sort();
    let named = |path: PathBuf| {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        (name, fs::read(&path).expect("the page is readable"))
    };
    pages.into_iter().map(named).collect()
}

/// The documents of a folder that can be read.
pub(crate) fn documents(folder: &str) -> Vec<Document> {
    pages(folder).iter().filter_map(|(name, bytes)| read(name, bytes).ok()).collect()
}

/// The shipped documents and the semantics suite.
pub(crate) fn all_documents() -> Vec<Document> {
    let mut all = documents("docs/derivations");
    all.extend(documents("tests/conformance/semantics"));
    all
}

/// Statements outside of any fence, as a judged document.
pub(crate) fn judged(statements: &str) -> Audit {
    let text = format!("```kane\n{statements}\n```\n");
    let document = match read("test.md", text.as_bytes()) {
        Ok(document) => document,
        Err(faults) => {
            let faults: String = faults.iter().map(ToString::to_string).collect();
            unreachable!("{statements}\n{faults}")
        }
    };
    audit(document, &Options::default(), &mut |_, _| {})
}

/// One link of a claim as a goal, and where it comes from.
#[derive(Clone, Debug)]
pub(crate) struct Case {
    pub(crate) name: String,
    pub(crate) goal: Goal,
    pub(crate) by: Vec<(usize, Expr)>,
}

fn sentence(claim: &Claim) -> Option<Sentence> {
    match &claim.content {
        Content::Links(links) => Some(Sentence {
            when: claim.when.clone(),
            links: links.iter().map(|(l, _)| l.clone()).collect(),
        }),
        Content::Contradiction | Content::NotImplied(_) | Content::Sought(_) => None,
    }
}

fn hypothesis(document: &Document, i: usize) -> Option<Hypothesis> {
    match &document.statements[i].body {
        Body::Let(_) | Body::Defined(_) => None,
        Body::Given(sentence) => Some(Hypothesis { sentence: sentence.clone(), given: true }),
        Body::Claim(claim) => Some(Hypothesis { sentence: sentence(claim)?, given: false }),
    }
}

/// The givens on which the cited claims rest and which are not cited themselves.
fn behind(document: &Document, claim: &Claim) -> Vec<Sentence> {
    let (mut todo, mut rests) = (claim.from.clone(), BTreeSet::new());
    while let Some(i) = todo.pop() {
        match &document.statements[i].body {
            Body::Given(_) => _ = rests.insert(i),
            Body::Claim(cited) => todo.extend(&cited.from),
            Body::Let(_) | Body::Defined(_) => {}
        }
    }
    rests.retain(|i| !claim.from.contains(i));
    rests.into_iter().filter_map(|i| Some(hypothesis(document, i)?.sentence)).collect()
}

/// The goals behind a document's claims: what each cites, its conditions, one link.
pub(crate) fn cases(document: &Document) -> Vec<Case> {
    let mut out = Vec::new();
    for statement in &document.statements {
        let Body::Claim(claim) = &statement.body else {
            continue;
        };
        let hypotheses: Vec<Hypothesis> =
            claim.from.iter().filter_map(|&i| hypothesis(document, i)).collect();
        let conclusions: Vec<Conclusion> = match &claim.content {
            Content::Links(links) => {
                links.iter().map(|(l, _)| Conclusion::Link(l.clone())).collect()
            }
            Content::Contradiction => vec![Conclusion::Contradiction],
            // what is found is in no document before it is judged
            Content::Sought(_) => Vec::new(),
            Content::NotImplied(m) => hypothesis(document, *m)
                .map(|h| Conclusion::NotImplied(h.sentence))
                .into_iter()
                .collect(),
        };
        let behind = behind(document, claim);
        for (i, conclusion) in conclusions.into_iter().enumerate() {
            out.push(Case {
                name: format!("{} {}.{i}", document.name, statement.label),
                goal: Goal {
                    context: document.context.clone(),
                    hypotheses: hypotheses.clone(),
                    behind: behind.clone(),
                    when: claim.when.clone(),
                    conclusion,
                },
                by: claim.by.clone(),
            });
        }
    }
    out
}

/// A goal in words, for messages.
pub(crate) fn shown(goal: &Goal) -> String {
    use std::fmt::Write;
    let mut out = String::new();
    for v in &goal.context.vars {
        let side = |b: &Option<kane::kernel::Bound>| {
            b.as_ref().map(|b| format!("{}{}", b.value, if b.strict { " excluded" } else { "" }))
        };
        let _ = writeln!(out, "var {} from {:?} to {:?}", v.name, side(&v.lower), side(&v.upper));
    }
    for h in &goal.hypotheses {
        for l in &h.sentence.links {
            let _ = writeln!(out, "given({}) {}", h.given, l.plain(&goal.context));
        }
        for r in &h.sentence.when {
            let _ = writeln!(out, "    when {}", Link::Relation(r.clone()).plain(&goal.context));
        }
    }
    if let Conclusion::Link(l) = &goal.conclusion {
        let _ = writeln!(out, "claim {}", l.plain(&goal.context));
    }
    for r in &goal.when {
        let _ = writeln!(out, "    when {}", Link::Relation(r.clone()).plain(&goal.context));
    }
    out
}
