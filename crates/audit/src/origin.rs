//! Where in the file a place of a document's text stands: formulas in dollars are written out in the
//! text, so that what follows them has moved.

use std::ops::Range;

/// The way from places in [`Document::text`](crate::Document::text) back to bytes of the file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Origin {
    /// where each formula stands in the file, and where in the text; in the order of the text
    formulas: Vec<(Range<usize>, Range<usize>)>,
}

impl Origin {
    pub(crate) fn push(&mut self, file: Range<usize>, text: Range<usize>) {
        self.formulas.push((file, text));
    }

    /// The bytes of the file from which this range of the text was read. A range that ends inside of a
    /// formula takes in the whole of it.
    #[must_use]
    pub fn in_file(&self, range: Range<usize>) -> Range<usize> {
        self.start(range.start)..self.end(range.end).max(self.start(range.start))
    }

    /// The last formula that begins at or before this place of the text.
    fn before(&self, at: usize) -> Option<&(Range<usize>, Range<usize>)> {
        let next = self.formulas.partition_point(|(_, text)| text.start <= at);
        self.formulas.get(next.checked_sub(1)?)
    }

    fn start(&self, at: usize) -> usize {
        match self.before(at) {
            Some((file, text)) if at < text.end => file.start,
            Some((file, text)) => file.end + (at - text.end),
            None => at,
        }
    }

    fn end(&self, at: usize) -> usize {
        match self.before(at) {
            Some((file, text)) if at <= text.start => file.start,
            Some((file, text)) => file.end + at.saturating_sub(text.end),
            None => at,
        }
    }
}
