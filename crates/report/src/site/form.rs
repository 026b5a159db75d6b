//! The other forms of what a page tells: data, print, lemmas. Large ones are packed.

use crate::envelope::folded;
use crate::place::Link;

/// From so many bytes on, data and other files for programs are packed by gzip: a browser shows no such file anyhow.
const PACKED_FROM: usize = 4_096;

/// A file of a site.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// where it is, seen from the index; one that ends in `.gz` is to be packed by gzip
    pub path: String,
    /// what it holds, not packed
    pub text: String,
}

impl File {
    /// Whether it is to be packed.
    #[must_use]
    pub fn is_packed(&self) -> bool {
        self.path.ends_with(".gz")
    }

    /// Where it is, were it not packed.
    #[must_use]
    pub fn name(&self) -> &str {
        self.path.strip_suffix(".gz").unwrap_or(&self.path)
    }
}

/// A form of what a page tells.
pub(super) struct Form {
    /// what it is called
    words: &'static str,
    /// its file
    file: File,
}

impl Form {
    /// A form in this file, seen from the index. Data for programs are written without the spaces that only people
    /// need.
    pub(super) fn new(words: &'static str, path: impl Into<String>, text: String) -> Self {
        let mut path = path.into();
        let text = if path.ends_with(".json") { folded(&text) } else { text };
        let is_seen = path.ends_with(".svg");
        if text.len() >= PACKED_FROM && !is_seen {
            path.push_str(".gz");
        }
        Self { words, file: File { path, text } }
    }

    /// The same, never packed.
    pub(super) fn open(self) -> Self {
        let path = self.file.name().to_owned();
        Self { file: File { path, ..self.file }, ..self }
    }

    /// The link to it from a page in the same directory.
    pub(super) fn link(&self) -> Link {
        let name = self.file.path.rsplit('/').next().unwrap_or_default();
        let packed = if self.file.is_packed() { " (gzip)" } else { "" };
        Link::new(format!("{}{packed}", self.words), name)
    }

    pub(super) fn file(self) -> File {
        self.file
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn large_files_for_programs_are_packed_and_their_links_say_so() {
        let small = Form::new("LaTeX", "a/b.tex", "x".repeat(PACKED_FROM - 1));
        assert_eq!(small.link(), Link::new("LaTeX", "b.tex"));
        let large = Form::new("LaTeX", "a/b.tex", "x".repeat(PACKED_FROM));
        assert_eq!(large.link(), Link::new("LaTeX (gzip)", "b.tex.gz"));
        let file = large.file();
        assert!(file.is_packed() && file.name() == "a/b.tex" && file.text.starts_with("xx"));
        assert_eq!(Form::new("picture", "b.svg", "x".repeat(PACKED_FROM)).file().path, "b.svg");
    }
}
