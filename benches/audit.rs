//! How long an audit takes: `cargo bench --bench audit`.
//!
//! `paper` is the whole: reading is left out, judging includes building every certificate and having the kernel
//! check it. `by_verdict` judges the claims that end with one verdict, each with all that it cites, so a claim that
//! others cite counts for each verdict again.

use divan::Bencher;
use kane::audit::{Audit, Document, Options, Verdict, audit, read};

const PAPER: &str = include_str!("../docs/derivations/oblique-collision.md");

fn main() {
    divan::main();
}

fn document() -> Document {
    read("oblique-collision.md", PAPER.as_bytes()).expect("the paper is well formed")
}

fn judge(document: Document, only: Option<Vec<usize>>) -> Audit {
    let options = Options { only, ..Options::default() };
    audit(document, &options, &mut |_, _| {})
}

#[divan::bench(sample_count = 20)]
fn reading(bencher: Bencher<'_, '_>) {
    bencher.bench(document);
}

#[divan::bench(sample_count = 20)]
fn paper(bencher: Bencher<'_, '_>) {
    let document = document();
    bencher.with_inputs(|| document.clone()).bench_local_values(|document| judge(document, None));
}

#[divan::bench(sample_count = 20, args = [Verdict::Proved, Verdict::Refuted, Verdict::IllDefined, Verdict::Vacuous, Verdict::Unsupported])]
fn by_verdict(bencher: Bencher<'_, '_>, verdict: &Verdict) {
    let whole = judge(document(), None);
    let chosen: Vec<usize> = (0..whole.judgements.len())
        .filter(|&index| whole.judgements[index].verdict == *verdict)
        .collect();
    bencher
        .with_inputs(|| (whole.document.clone(), chosen.clone()))
        .bench_local_values(|(document, chosen)| judge(document, Some(chosen)));
}
