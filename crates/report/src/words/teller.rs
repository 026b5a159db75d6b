//! What tells steps: the lines that it has said, and the pen that it says them with.

use kane_audit::Step;
use kane_kernel::Atom;

use super::Line;
use super::lines::{Pen, Sentence};

/// Tells steps in lines.
pub(super) struct Teller<'a> {
    pub(super) labels: &'a [&'a str],
    pub(super) pen: &'a Pen<'a>,
    pub(super) lines: Vec<Line>,
    /// whether it was said what brackets stand for
    pub(super) explained: bool,
    /// whether it is supposed that a side of the claim has no value
    pub(super) no_value: bool,
}

impl Teller<'_> {
    /// Says a sentence.
    pub(super) fn say(&mut self, depth: usize, sentence: Sentence) {
        self.lines.extend(sentence.lines(depth));
    }
}

/// A case, and what follows in it.
pub(super) struct Branch<'s> {
    pub(super) atoms: Vec<Atom>,
    pub(super) then: &'s [Step],
}
