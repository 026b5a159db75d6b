//! Abstract syntax of derivations: what a statement *is*, before anyone judges it.

use std::rc::Rc;

use num_rational::BigRational;

/// An expression over the symbols of a [`Context`]. Numbers are exact.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Expr {
    /// A rational number.
    Num(BigRational),
    /// The symbol at this index of [`Context::vars`].
    Var(usize),
    /// The definition at this index of [`Context::lets`].
    Let(usize),
    /// −a
    Neg(Rc<Expr>),
    /// a + b
    Add(Rc<Expr>, Rc<Expr>),
    /// a − b
    Sub(Rc<Expr>, Rc<Expr>),
    /// a · b
    Mul(Rc<Expr>, Rc<Expr>),
    /// a / b, undefined where b = 0
    Div(Rc<Expr>, Rc<Expr>),
    /// aⁿ; 0⁰ = 1, and a negative n is a division
    Pow(Rc<Expr>, i32),
    /// |a|
    Abs(Rc<Expr>),
    /// the smaller of two
    Min(Rc<Expr>, Rc<Expr>),
    /// the larger of two
    Max(Rc<Expr>, Rc<Expr>),
    /// the non-negative root, undefined where a < 0
    Sqrt(Rc<Expr>),
    /// the derivative of an explicit expression with respect to a symbol
    Deriv(Rc<Expr>, usize),
    /// first branch whose guards all hold; undefined where none does and there is no `else`
    Cases(Vec<(Vec<Relation>, Expr)>, Option<Rc<Expr>>),
}

/// How the two sides of a [`Relation`] compare.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Rel {
    /// =
    Eq,
    /// ≠
    Ne,
    /// <
    Lt,
    /// ≤
    Le,
    /// >
    Gt,
    /// ≥
    Ge,
}

/// One link `lhs ⋈ rhs`; true only where both sides are defined.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Relation {
    /// left side
    pub lhs: Expr,
    /// comparison
    pub rel: Rel,
    /// right side
    pub rhs: Expr,
}

/// What an expression tends to.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Target {
    /// a value, free of the limit variable
    Finite(Expr),
    /// +∞
    PlusInf,
    /// −∞
    MinusInf,
}

/// Where the limit variable goes.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Approach {
    /// x → a, from every side from which the domain reaches a
    To(BigRational),
    /// x → a+
    Above(BigRational),
    /// x → a−
    Below(BigRational),
    /// x → +∞
    PlusInf,
    /// x → −∞
    MinusInf,
}

/// `expr → to` as `var` follows `at`, inside the domain of `var`.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Limit {
    /// what tends
    pub expr: Expr,
    /// what it tends to
    pub to: Target,
    /// index of the limit variable
    pub var: usize,
    /// how the limit variable moves
    pub at: Approach,
}

/// A link of a statement.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Link {
    /// a relation that holds pointwise
    Relation(Relation),
    /// a limit
    Limit(Limit),
}

/// One end of a declared range.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Bound {
    /// the end point
    pub value: BigRational,
    /// whether the end point itself is excluded
    pub strict: bool,
}

/// A declared symbol.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Var {
    /// name as written
    pub name: String,
    /// `Some(x)` for an arbitrary real function of the symbol x
    pub of: Option<usize>,
    /// lower end of its range, −∞ if absent
    pub lower: Option<Bound>,
    /// upper end of its range, +∞ if absent
    pub upper: Option<Bound>,
}

/// A definition `let name := body`; the body names earlier symbols and definitions only.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Definition {
    /// name as written
    pub name: String,
    /// what it stands for
    pub body: Expr,
}

/// The symbols and definitions of a document.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Context {
    /// declared symbols
    pub vars: Vec<Var>,
    /// definitions in order
    pub lets: Vec<Definition>,
    /// symbols for which an expression in at most one other symbol stands; none in a document
    pub values: Vec<(usize, Expr)>,
}

/// What a statement says: its links hold wherever its `when` does.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Default)]
pub struct Sentence {
    /// conditions, read left to right; empty for none
    pub when: Vec<Relation>,
    /// the links of the chain or list, all of which are meant
    pub links: Vec<Link>,
}

/// A cited sentence and how far it may be trusted.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Hypothesis {
    /// what it says
    pub sentence: Sentence,
    /// a `given` also asserts that it is defined; a cited claim speaks only where it is
    pub given: bool,
}

/// What a claim concludes (one link of it).
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Conclusion {
    /// this link
    Link(Link),
    /// the hypotheses cannot all hold
    Contradiction,
    /// this sentence does not follow from the hypotheses
    NotImplied(Sentence),
}

/// What the kernel is asked about: under `when` and the hypotheses, the conclusion.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Goal {
    /// symbols and definitions
    pub context: Context,
    /// cited premises
    pub hypotheses: Vec<Hypothesis>,
    /// givens on which cited claims rest and which are not cited themselves: no premises, but along
    /// a limit the variable has to stay in the range of each
    pub behind: Vec<Sentence>,
    /// the claim's own conditions
    pub when: Vec<Relation>,
    /// one link of the claim
    pub conclusion: Conclusion,
}

impl Expr {
    /// A number as an expression.
    #[must_use]
    pub fn int(n: i64) -> Self {
        Self::Num(BigRational::from_integer(n.into()))
    }

    /// Its direct parts, guards included.
    #[must_use]
    pub fn children(&self) -> Vec<&Self> {
        match self {
            Self::Num(_) | Self::Var(_) | Self::Let(_) => Vec::new(),
            Self::Neg(a) | Self::Pow(a, _) | Self::Abs(a) | Self::Sqrt(a) | Self::Deriv(a, _) => {
                vec![a]
            }
            Self::Add(a, b) | Self::Sub(a, b) | Self::Mul(a, b) | Self::Div(a, b) => vec![a, b],
            Self::Min(a, b) | Self::Max(a, b) => vec![a, b],
            Self::Cases(branches, otherwise) => {
                let guards = branches.iter().flat_map(|(guards, _)| guards);
                let sides = guards.flat_map(|g| [&g.lhs, &g.rhs]);
                let bodies = branches.iter().map(|(_, body)| body);
                sides.chain(bodies).chain(otherwise.as_deref()).collect()
            }
        }
    }

    /// The absolute value, the minimum and the maximum as `cases`; anything else as it is.
    #[must_use]
    pub fn as_cases(&self) -> Self {
        let (a, rel, b, last) = match self {
            Self::Abs(a) => (a, Rel::Ge, Self::int(0), Self::Neg(a.clone()).into()),
            Self::Min(a, b) => (a, Rel::Le, (**b).clone(), b.clone()),
            Self::Max(a, b) => (a, Rel::Ge, (**b).clone(), b.clone()),
            other => return other.clone(),
        };
        let guard = Relation { lhs: (**a).clone(), rel, rhs: b };
        Self::Cases(vec![(vec![guard], (**a).clone())], Some(last))
    }
}

impl Relation {
    /// The sides, the one first that is greater if an inequality holds.
    #[must_use]
    pub fn greater_first(&self) -> (&Expr, &Expr) {
        match self.rel {
            Rel::Lt | Rel::Le => (&self.rhs, &self.lhs),
            Rel::Eq | Rel::Ne | Rel::Gt | Rel::Ge => (&self.lhs, &self.rhs),
        }
    }
}

impl Context {
    /// The expression that stands for a symbol, if one does.
    #[must_use]
    pub fn value(&self, symbol: usize) -> Option<&Expr> {
        self.values.iter().find(|(v, _)| *v == symbol).map(|(_, e)| e)
    }
}

impl Sentence {
    /// The relations of it that are wanted, under its conditions.
    #[must_use]
    pub fn only(&self, wanted: impl Fn(&Relation) -> bool) -> Self {
        let links = self.relations().filter(|r| wanted(r)).cloned().map(Link::Relation);
        Self { when: self.when.clone(), links: links.collect() }
    }

    /// Its links that are relations.
    pub fn relations(&self) -> impl Iterator<Item = &Relation> {
        self.links.iter().filter_map(|l| match l {
            Link::Relation(r) => Some(r),
            Link::Limit(_) => None,
        })
    }

    /// Its links that are limits.
    pub fn limits(&self) -> impl Iterator<Item = &Limit> {
        self.links.iter().filter_map(|l| match l {
            Link::Relation(_) => None,
            Link::Limit(l) => Some(l),
        })
    }
}

impl Conclusion {
    /// The links that it is about.
    #[must_use]
    pub fn links(&self) -> &[Link] {
        match self {
            Self::Link(l) => std::slice::from_ref(l),
            Self::NotImplied(s) => &s.links,
            Self::Contradiction => &[],
        }
    }

    /// The conditions of its own.
    #[must_use]
    pub fn when(&self) -> &[Relation] {
        match self {
            Self::NotImplied(s) => &s.when,
            Self::Link(_) | Self::Contradiction => &[],
        }
    }
}

/// Both sides of all relations, the expressions of all limits and what they tend to.
pub fn expressions<'a>(
    relations: &'a [Relation],
    links: &'a [Link],
) -> impl Iterator<Item = &'a Expr> {
    let of_link = |link: &'a Link| match link {
        Link::Relation(r) => vec![&r.lhs, &r.rhs],
        Link::Limit(Limit { expr, to: Target::Finite(value), .. }) => vec![expr, value],
        Link::Limit(l) => vec![&l.expr],
    };
    relations.iter().flat_map(|r| [&r.lhs, &r.rhs]).chain(links.iter().flat_map(of_link))
}
