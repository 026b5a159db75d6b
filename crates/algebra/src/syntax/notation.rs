//! How things are written, in plain text and in LaTeX.

use kane_kernel::{Context, Expr, Limit, Link, Relation, Sentence};

use super::{latex, plain};

/// How something is written. The context gives the names; a name that it lacks becomes `?`.
///
/// Whatever the parser has read is printed by [`plain`](Self::plain) such that it reads back as the
/// same syntax. What it cannot have read is printed with the same meaning: a negative number gets
/// a sign, a number without a finite decimal expansion becomes a quotient.
pub trait Notation {
    /// In the notation of derivation documents, with as few parentheses as it takes.
    fn plain(&self, context: &Context) -> String;
    /// In LaTeX, for math mode.
    fn latex(&self, context: &Context) -> String;
}

impl Notation for Expr {
    fn plain(&self, context: &Context) -> String {
        plain::whole_expr(self, context)
    }

    fn latex(&self, context: &Context) -> String {
        latex::whole_expr(self, context)
    }
}

impl Notation for Relation {
    fn plain(&self, context: &Context) -> String {
        plain::chain(std::slice::from_ref(self), context)
    }

    fn latex(&self, context: &Context) -> String {
        latex::relations(std::slice::from_ref(self), context)
    }
}

impl Notation for [Relation] {
    fn plain(&self, context: &Context) -> String {
        plain::chain(self, context)
    }

    fn latex(&self, context: &Context) -> String {
        latex::relations(self, context)
    }
}

impl Notation for Limit {
    fn plain(&self, context: &Context) -> String {
        format!("{} as {}", plain::tends(self, context), plain::motion(self, context))
    }

    fn latex(&self, context: &Context) -> String {
        latex::limit(self, context)
    }
}

impl Notation for Link {
    fn plain(&self, context: &Context) -> String {
        match self {
            Self::Relation(relation) => relation.plain(context),
            Self::Limit(limit) => limit.plain(context),
        }
    }

    fn latex(&self, context: &Context) -> String {
        match self {
            Self::Relation(relation) => relation.latex(context),
            Self::Limit(limit) => limit.latex(context),
        }
    }
}

impl Notation for Sentence {
    fn plain(&self, context: &Context) -> String {
        let mut parts = Vec::new();
        let mut moves = None;
        for group in groups(&self.links) {
            match group {
                Group::Relations(relations) => parts.push(plain::chain(&relations, context)),
                Group::Limit(limit) => {
                    parts.push(plain::tends(limit, context));
                    moves = Some(limit);
                }
            }
        }
        let mut out = parts.join(", ");
        if let Some(limit) = moves {
            out = format!("{out} as {}", plain::motion(limit, context));
        }
        if !self.when.is_empty() {
            out = format!("{out} when {}", plain::chain(&self.when, context));
        }
        out
    }

    fn latex(&self, context: &Context) -> String {
        let links: Vec<String> = groups(&self.links)
            .iter()
            .map(|group| match group {
                Group::Relations(relations) => latex::relations(relations, context),
                Group::Limit(limit) => latex::limit(limit, context),
            })
            .collect();
        let links = links.join(",\\quad ");
        if self.when.is_empty() {
            links
        } else {
            format!("{links} \\quad\\text{{when }} {}", latex::relations(&self.when, context))
        }
    }
}

/// Neighbouring relations, or one limit.
enum Group<'a> {
    Relations(Vec<Relation>),
    Limit(&'a Limit),
}

fn groups(links: &[Link]) -> Vec<Group<'_>> {
    let mut groups = Vec::new();
    for link in links {
        match (link, groups.last_mut()) {
            (Link::Relation(relation), Some(Group::Relations(relations))) => {
                relations.push(relation.clone());
            }
            (Link::Relation(relation), _) => {
                groups.push(Group::Relations(vec![relation.clone()]));
            }
            (Link::Limit(limit), _) => groups.push(Group::Limit(limit)),
        }
    }
    groups
}
