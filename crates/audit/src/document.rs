//! A derivation document after reading: symbols, statements, and where each stands in the text.

use std::collections::BTreeSet;
use std::ops::Range;

use kane_algebra::syntax::{Notation as _, Sequences, rebuild};
use kane_kernel::{Context, Expr, Limit, Link, Relation, Sentence, expressions};
use sha2::{Digest as _, Sha256};

use crate::motion::Motion;
use crate::spoken::within;
use crate::{Existence, Verdict};

/// A derivation document that was read without error.
#[derive(Clone, Debug)]
pub struct Document {
    /// the file's name, as given, with what cannot be seen in it written out
    pub name: String,
    /// the whole text; a carriage return that ends a line by itself is a line feed in it, and a formula
    /// in LaTeX is written in the notation of the language
    pub text: String,
    /// the first level-one heading, if any, with what cannot be seen in it written out
    pub title: Option<String>,
    /// symbols and definitions
    pub context: Context,
    /// `let`, `given` and `claim` in the order of the text
    pub statements: Vec<Statement>,
    pub(crate) motion: Motion,
    pub(crate) sequences: Sequences,
    /// derivatives by the chain rule, each with the derivative as it was written
    pub(crate) derivatives: Vec<(Expr, Expr)>,
    pub(crate) digest: String,
}

/// One `let`, `given` or `claim`.
#[derive(Clone, Debug)]
pub struct Statement {
    /// the label as written, `(9)` or `k-range`; a `let` without one goes by its name
    pub label: String,
    /// what it says
    pub body: Body,
    /// byte range in [`Document::text`]
    pub span: Range<usize>,
    /// the byte ranges of its parts
    pub parts: Parts,
    /// line of its first character, from 1
    pub line: usize,
}

/// Where the parts of a statement stand in [`Document::text`]; each clause begins with its keyword.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Parts {
    /// the label; the name of a `let` without one
    pub label: Range<usize>,
    /// what is defined, assumed or claimed, without its conditions
    pub content: Range<usize>,
    /// `for …` and `when …`
    pub when: Option<Range<usize>>,
    /// `from …`
    pub from: Option<Range<usize>>,
    /// `using …`
    pub using: Option<Range<usize>>,
    /// `by …`
    pub by: Option<Range<usize>>,
    /// `expect …`
    pub expect: Option<Range<usize>>,
}

impl Parts {
    /// The content with its conditions.
    #[must_use]
    pub fn saying(&self) -> Range<usize> {
        self.content.start..self.when.as_ref().map_or(self.content.end, |when| when.end)
    }
}

/// What a statement says.
#[derive(Clone, Debug)]
pub enum Body {
    /// definition at this index of [`Context::lets`]
    Let(usize),
    /// the definitions that are the components of a vector or a matrix; none for a definition with
    /// arguments, which is written out where it is used
    Defined(Vec<usize>),
    /// what the author assumes
    Given(Sentence),
    /// what the author claims
    Claim(Claim),
}

/// A claim with its citations.
#[derive(Clone, Debug)]
pub struct Claim {
    /// the claimed thing
    pub content: Content,
    /// whether it says that something exists: the content has the witness in its place, so only a
    /// proof of it decides
    pub exists: bool,
    /// the witness that was found where none is named: each name, and what stands in its place
    pub found: Vec<(String, Expr)>,
    /// the claim's own conditions, the range of its index first
    pub when: Vec<kane_kernel::Relation>,
    /// how it is shown for all values of an index
    pub induction: Option<Induction>,
    /// indices of the cited statements, as cited
    pub from: Vec<usize>,
    /// expressions whose squares and products with premises are to be tried, and whose sign tells
    /// cases; hints to the search, never trusted
    pub using: Vec<Expr>,
    /// values or functions proposed as a witness: symbol and expression
    pub by: Vec<(usize, Expr)>,
    /// the verdict that the author expects; `Proved` where nothing is written
    pub expect: Option<Verdict>,
}

/// That a claim is to be shown by induction. It has two links for each of its relations: all of them at
/// the first value of the index, and then all of them one step further, from the claim itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Induction {
    /// the symbol of the index
    pub index: usize,
    /// its first value
    pub from: u32,
}

/// The claimed thing.
#[derive(Clone, Debug)]
pub enum Content {
    /// links, each judged on its own, with the byte range of each in the text
    Links(Vec<(kane_kernel::Link, Range<usize>)>),
    /// something exists that is to be found
    Sought(Existence),
    /// the hypotheses cannot all hold
    Contradiction,
    /// the statement at this index does not follow
    NotImplied(usize),
}

/// The SHA-256 of these bytes as 64 hexadecimal digits.
pub(crate) fn digest(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

impl Document {
    /// The SHA-256 of the file as 64 hexadecimal digits, which `sha256sum` prints, too.
    #[must_use]
    pub fn sha256(&self) -> String {
        self.digest.clone()
    }

    /// The statement's text as written, without its comment.
    #[must_use]
    pub fn source(&self, statement: &Statement) -> &str {
        self.text.get(statement.span.clone()).unwrap_or_default()
    }

    /// A link of a claim in the notation of documents; empty if there is none.
    #[must_use]
    pub fn link(&self, statement: usize, link: usize) -> String {
        let Some(Body::Claim(claim)) = self.statements.get(statement).map(|s| &s.body) else {
            return String::new();
        };
        match &claim.content {
            Content::Links(links) => {
                let said = links.get(link % links.len().max(1));
                let said = said.map_or_else(String::new, |(link, _)| {
                    self.link_as_written(link).plain(&self.context)
                });
                let stage = self.stage(claim, link).map(|stage| format!(" {stage}"));
                said + &stage.unwrap_or_default()
            }
            Content::Sought(existence) => {
                let part = existence.links.get(link % existence.links.len().max(1));
                part.map_or_else(String::new, |(_, span)| self.on_one_line(span.clone()))
            }
            Content::Contradiction => "contradiction".to_owned(),
            Content::NotImplied(denied) => {
                let denied = self.statements.get(*denied).map_or("", |s| &s.label);
                format!("not implied {denied}")
            }
        }
    }

    /// Symbols in a claimed limit that are constants by their declaration, where nothing in it varies with the limit
    /// variable and a cited `given` ties them to that; and the limit variable.
    #[must_use]
    pub fn constants_along(&self, claim: &Claim, link: usize) -> Option<(Vec<usize>, usize)> {
        let Content::Links(links) = &claim.content else { return None };
        let (Link::Limit(limit), _) = links.get(link)? else { return None };
        let x = limit.var;
        let vars = &self.context.vars;
        let (own, _) = within(&self.context, vec![&limit.expr]);
        let varies = |v: &usize| *v == x || vars.get(*v).is_some_and(|var| var.of == Some(x));
        if own.iter().any(varies) {
            return None;
        }
        let tied = claim.from.iter().filter_map(|i| match &self.statements.get(*i)?.body {
            Body::Given(sentence) => {
                let all = expressions(&sentence.when, &sentence.links).collect();
                Some(within(&self.context, all).0).filter(|symbols| symbols.contains(&x))
            }
            _ => None,
        });
        let tied: BTreeSet<usize> = tied.flatten().filter(|v| own.contains(v)).collect();
        (!tied.is_empty()).then(|| (tied.into_iter().collect(), x))
    }

    /// Whether a statement is one that the language makes of an exponential, a logarithm or an angle. It holds at every
    /// point, with their values.
    #[must_use]
    pub fn is_convention(&self, statement: usize) -> bool {
        self.motion.stands_for.contains_key(&statement)
    }

    /// An expression of a statement, with derivatives as they were written where the chain rule took them.
    #[must_use]
    pub fn as_written(&self, e: &Expr) -> Expr {
        let written = rebuild(e, &mut |part| {
            let known = self.derivatives.iter().find(|(shown, _)| shown == part);
            Ok::<_, std::convert::Infallible>(known.map(|(_, written)| written.clone()))
        });
        let Ok(written) = written;
        written
    }

    /// A relation, likewise.
    #[must_use]
    pub fn relation_as_written(&self, r: &Relation) -> Relation {
        Relation { lhs: self.as_written(&r.lhs), rel: r.rel, rhs: self.as_written(&r.rhs) }
    }

    /// A link, likewise.
    #[must_use]
    pub fn link_as_written(&self, link: &Link) -> Link {
        match link {
            Link::Relation(r) => Link::Relation(self.relation_as_written(r)),
            Link::Limit(l) => Link::Limit(Limit { expr: self.as_written(&l.expr), ..l.clone() }),
        }
    }

    /// Which part of an induction a link of a claim is: `at n = 0`, or `from n to n + 1`.
    #[must_use]
    pub fn stage(&self, claim: &Claim, link: usize) -> Option<String> {
        let Induction { index, from } = claim.induction?;
        let Content::Links(links) = &claim.content else { return None };
        let n = &self.context.vars.get(index)?.name;
        Some(match link < links.len() {
            true => format!("at {n} = {from}"),
            false => format!("from {n} to {n} + 1"),
        })
    }

    /// A part of a statement on one line, without comments.
    #[must_use]
    pub fn on_one_line(&self, part: Range<usize>) -> String {
        let lines = self.text.get(part).unwrap_or_default().lines();
        let code = lines.map(|line| line.split('#').next().unwrap_or_default());
        code.flat_map(str::split_whitespace).collect::<Vec<_>>().join(" ")
    }
}
