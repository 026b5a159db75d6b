//! What stands where, gathered from what was read before citations are resolved.

use std::collections::{BTreeSet, HashMap};
use std::ops::Range;

use kane_algebra::syntax::Symbol;

use super::citation::{Cited, DraftBody, DraftContent};
use super::{Reader, label};
use crate::origin::Origin;
use crate::outline::{Citation, Kind, Label, Name, Outline};

impl Reader {
    /// The outline of a text, of which these are the blocks.
    pub(super) fn outline(&self, text: &str, blocks: &[Range<usize>], origin: &Origin) -> Outline {
        let made: BTreeSet<usize> = self
            .circles
            .values()
            .chain(self.arcs.values())
            .chain(self.exponentials.values())
            .chain(self.ranges.values())
            .chain(self.derived.keys())
            .copied()
            .collect();
        let mut outline = Outline {
            blocks: blocks.iter().map(|block| origin.in_file(block.clone())).collect(),
            names: self.names(text, origin),
            ..Outline::default()
        };
        let mut listed: HashMap<usize, usize> = HashMap::new();
        let mut cited = Vec::new();
        for (index, draft) in self.drafts.iter().enumerate() {
            if let DraftBody::Claim(claim) = &draft.body {
                cited.extend(&claim.from);
                if let DraftContent::NotImplied(target) = &claim.content {
                    cited.push(target);
                }
            }
            let place = draft.parts.label.clone();
            // what was derived from a statement, or stands for an angle, is written nowhere
            if made.contains(&index) || text.get(place.clone()) != Some(&draft.label) {
                continue;
            }
            let kind = match draft.body {
                DraftBody::Let(_) | DraftBody::Defined(_) => Kind::Let,
                DraftBody::Given(_) => Kind::Given,
                DraftBody::Claim(_) => Kind::Claim,
                DraftBody::Broken => Kind::Broken,
            };
            let goes_by_its_name = match kind {
                Kind::Let => draft.parts.content.start == place.start,
                Kind::Given | Kind::Claim => false,
                // of which it is not known what it is
                Kind::Broken => self.scope.resolve(&draft.label).is_some(),
            };
            listed.insert(index, outline.labels.len());
            outline.labels.push(Label {
                text: draft.label.clone(),
                place: origin.in_file(place),
                statement: origin.in_file(draft.span.clone()),
                kind,
                is_name: goes_by_its_name,
            });
        }
        let citation = |cited: &Cited| {
            let mut cited = cited;
            while let Some((inner, _)) = &cited.derivative {
                cited = inner;
            }
            let known = self.labels.get(&label::key(&cited.label));
            Citation {
                place: origin.in_file(cited.span.clone()),
                cites: known.and_then(|index| listed.get(index)).copied(),
            }
        };
        outline.citations = cited.into_iter().map(citation).collect();
        outline
    }

    /// Symbols and definitions with the words that declare them.
    fn names(&self, text: &str, origin: &Origin) -> Vec<Name> {
        let of = |name: &str| {
            let (site, is_definition) = match self.scope.resolve(name)? {
                Symbol::Var(index) => (self.var_sites.get(index)?, false),
                Symbol::Let(index) => (self.let_sites.get(index)?, true),
            };
            let word = text.get(*site..)?;
            let in_name = |c: char| c.is_alphanumeric() || "_'′".contains(c);
            let length = word.find(|c| !in_name(c)).unwrap_or(word.len());
            let place = origin.in_file(*site..*site + length);
            // a derivative or a part of an angle has no name that could be written
            let writable = name.chars().all(in_name);
            writable.then(|| Name { text: name.to_owned(), place, is_definition })
        };
        let mut names: Vec<Name> = self.scope.names().filter_map(of).collect();
        names.sort_by(|a, b| a.text.cmp(&b.text));
        names
    }
}
