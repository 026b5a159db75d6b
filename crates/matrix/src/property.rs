//! The properties that mechanics asks of a law: the columns of the matrix.

use kane_algebra::syntax::{Scope, parse_sentence};
use kane_impact::{Contact, Outcome};
use kane_kernel::{Expr, Link, Rel, Relation, Sentence, Var};
use kane_number::Number;

use crate::setting::Setting;

/// What a property asks, and how it is decided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// a statement about every contact of these families and the law's outcome there
    Pointwise(&'static [Setting]),
    /// a quantity tends to a value for alpha → ∞ (true) or 0, on contacts that do not couple
    Limit(bool),
    /// the impulse tends to the one without slip
    Continuous,
    /// units of speed and of mass do not matter
    Scale,
    /// two parts of a normal impulse, one after the other, do what the whole does
    Subdivision,
    /// there is an outcome
    Exists(&'static [Setting]),
    /// it does not matter which regime is asked at a border, nor which root
    Unique,
}

/// A property: a column of the matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Property {
    /// the name that the command line takes
    pub id: &'static str,
    /// what it is about, in a word that it shares with others
    pub group: &'static str,
    /// the head of the column, four characters at most
    pub head: &'static str,
    /// what it is called
    pub name: &'static str,
    /// for which contacts it is asked; formulas stand between backticks
    pub domain: &'static str,
    /// the statement, in the notation of derivation documents
    pub template: &'static str,
    /// what that means, in words; formulas stand between backticks
    pub meaning: &'static str,
    /// how it is decided
    pub kind: Kind,
}

const SPHERE: &[Setting] = &[Setting::Sphere];
const PLANAR: &[Setting] = &[Setting::Sphere, Setting::Driving, Setting::Braking];
const ALL_SPHERES: &[Setting] = &[Setting::Sphere, Setting::RestingSphere];
const ALL_PLANAR: &[Setting] = &[
    Setting::Sphere,
    Setting::Driving,
    Setting::Braking,
    Setting::RestingSphere,
    Setting::Resting,
];

const UNCOUPLED: &str = "contacts that do not couple, `W_tn = 0`";
const EVERY: &str = "every planar contact";

/// The collision creates no energy.
const NO_ENERGY_CREATED: &str = "E_t + E_n <= 0";

/// All properties, in the order of the columns.
pub const PROPERTIES: [Property; 19] = [
    Property {
        id: "momentum",
        group: "conditions",
        head: "mom",
        name: "momentum identity (9)",
        domain: UNCOUPLED,
        template: "2*alpha*i_x = 1 - k",
        meaning: "Equation (9) of the paper: what friction takes from the slip is what its impulse does to it. \
                  It joins the law's impulse with the slip that the law reports.",
        kind: Kind::Pointwise(SPHERE),
    },
    Property {
        id: "C1",
        group: "conditions",
        head: "C1",
        name: "connection condition (10)",
        domain: UNCOUPLED,
        template: "k -> -1 as alpha -> oo",
        meaning: "In normal collision the slip is reversed. Equation (10) of the paper.",
        kind: Kind::Limit(true),
    },
    Property {
        id: "C2",
        group: "conditions",
        head: "C2",
        name: "connection condition (11)",
        domain: UNCOUPLED,
        template: "i_x -> 0 as alpha -> oo",
        meaning: "In normal collision there is no friction. Equation (11) of the paper.",
        kind: Kind::Limit(true),
    },
    Property {
        id: "C3",
        group: "conditions",
        head: "C3",
        name: "connection condition (12)",
        domain: UNCOUPLED,
        template: "k -> 1 as alpha -> 0+",
        meaning: "In a grazing collision the slip stays. Equation (12) of the paper.",
        kind: Kind::Limit(false),
    },
    Property {
        id: "C4",
        group: "conditions",
        head: "C4",
        name: "connection condition (13)",
        domain: UNCOUPLED,
        template: "i_x -> 1 as alpha -> 0+",
        meaning: "In a grazing collision friction is that of sliding. Equation (13) of the paper.",
        kind: Kind::Limit(false),
    },
    Property {
        id: "cone-sphere",
        group: "friction",
        head: "con",
        name: "friction cone, sphere",
        domain: UNCOUPLED,
        template: "p_n >= 0, -mu*p_n <= p_t <= mu*p_n",
        meaning: "The impulse pushes, and friction is at most `mu` times as much.",
        kind: Kind::Pointwise(ALL_SPHERES),
    },
    Property {
        id: "cone",
        group: "friction",
        head: "con*",
        name: "friction cone, every contact",
        domain: EVERY,
        template: "p_n >= 0, -mu*p_n <= p_t <= mu*p_n",
        meaning: "The impulse pushes, and friction is at most `mu` times as much.",
        kind: Kind::Pointwise(ALL_PLANAR),
    },
    Property {
        id: "energy-tangential",
        group: "energy",
        head: "E_t",
        name: "tangential energy, sphere",
        domain: UNCOUPLED,
        template: "E_t <= 0",
        meaning: "Friction creates no energy, `E_t = p_t*(v + v_1)/2`. On a sphere this is the change of \
                  tangential and rotational energy together, equation (18) of the paper.",
        kind: Kind::Pointwise(ALL_SPHERES),
    },
    Property {
        id: "energy-sphere",
        group: "energy",
        head: "E",
        name: "total energy, sphere",
        domain: UNCOUPLED,
        template: NO_ENERGY_CREATED,
        meaning: "The collision creates no energy, for `0 <= e <= 1`.",
        kind: Kind::Pointwise(ALL_SPHERES),
    },
    Property {
        id: "energy",
        group: "energy",
        head: "E*",
        name: "total energy, every contact",
        domain: EVERY,
        template: NO_ENERGY_CREATED,
        meaning: "The collision creates no energy, for `0 <= e <= 1` and every symmetric positive definite `W`.",
        kind: Kind::Pointwise(ALL_PLANAR),
    },
    Property {
        id: "sliding",
        group: "friction",
        head: "slip",
        name: "Coulomb sliding while slip persists",
        domain: UNCOUPLED,
        template: "p_t = -mu*p_n when v_1 > 0",
        meaning: "If the contact still slides forwards at the end, it slid all the time, and friction is that of sliding.",
        kind: Kind::Pointwise(SPHERE),
    },
    Property {
        id: "reversal",
        group: "shape",
        head: "|k|",
        name: "bounded reversal",
        domain: UNCOUPLED,
        template: "-1 <= k <= 1",
        meaning: "The slip afterwards is no larger than before.",
        kind: Kind::Pointwise(SPHERE),
    },
    Property {
        id: "odd",
        group: "shape",
        head: "odd",
        name: "odd symmetry",
        domain: UNCOUPLED,
        template: "p_t = 0 when v = 0",
        meaning: "The mirrored contact has the mirrored impulse. Regimes are asked at the contact that faces \
                  forwards and the answer is mirrored back, so that this can fail only where a contact is its own \
                  mirror image: without slip and coupling there must be no tangential impulse.",
        kind: Kind::Pointwise(&[Setting::RestingSphere]),
    },
    Property {
        id: "continuity",
        group: "shape",
        head: "cont",
        name: "continuity at zero slip",
        domain: UNCOUPLED,
        template: "p_t -> 0 as v -> 0+, p_t = 0 when v = 0",
        meaning: "Where the slip vanishes, so does friction; with the mirror image the impulse is continuous there.",
        kind: Kind::Continuous,
    },
    Property {
        id: "scale",
        group: "shape",
        head: "unit",
        name: "scale invariance",
        domain: EVERY,
        template: "p(s*v, s*a, W, mu, e) = s*p(v, a, W, mu, e), p(v, a, s*W, mu, e) = p(v, a, W, mu, e)/s",
        meaning: "Units of speed and of mass do not matter. Every guard, every coefficient and end of a root, \
                  and the impulse are multiplied by a positive factor that is the same everywhere.",
        kind: Kind::Scale,
    },
    Property {
        id: "subdivision",
        group: "shape",
        head: "part",
        name: "invariance under subdividing the impulse",
        domain: UNCOUPLED,
        template: "v_1(v_1(v, a), b) = v_1(v, a + b)",
        meaning: "Two collisions with approach speeds `a` and `b`, the second of which begins with the slip that the \
                  first leaves, do to the slip what one with `a + b` does: the law is a process in which the normal \
                  impulse passes. A slip that the first reverses is that of the mirrored contact.",
        kind: Kind::Subdivision,
    },
    Property {
        id: "exists-sphere",
        group: "outcome",
        head: "som",
        name: "existence, sphere",
        domain: UNCOUPLED,
        template: "some guards hold; p(l)*p(u) <= 0, l <= u for a root of p between l and u; no divisor is 0",
        meaning: "Every contact is in some regime, whose root exists, whose formulas divide by nothing that may \
                  vanish, and whose outcome the law accepts.",
        kind: Kind::Exists(SPHERE),
    },
    Property {
        id: "exists",
        group: "outcome",
        head: "som*",
        name: "existence, every contact",
        domain: EVERY,
        template: "some guards hold; p(l)*p(u) <= 0, l <= u for a root of p between l and u; no divisor is 0",
        meaning: "Every contact is in some regime, whose root exists, whose formulas divide by nothing that may \
                  vanish, and whose outcome the law accepts.",
        kind: Kind::Exists(PLANAR),
    },
    Property {
        id: "unique",
        group: "outcome",
        head: "one",
        name: "uniqueness, sphere",
        domain: UNCOUPLED,
        template: "x = y when x and y are roots of one regime; p = q at the border of two regimes",
        meaning: "A regime has one admissible root, and where a guard holds with equality the regime that takes \
                  over beyond it gives the same impulse, so that it does not matter which of the two is asked.",
        kind: Kind::Unique,
    },
];

impl Property {
    /// Whether it takes k and i_x as functions of alpha.
    pub(crate) fn speaks_of_alpha(&self) -> bool {
        self.id == "momentum" || matches!(self.kind, Kind::Limit(_))
    }

    /// Whether it asks components of the impulse one by one where there is slip, so that turned axes matter.
    pub(crate) fn depends_on_frame(&self) -> bool {
        if self.kind == Kind::Pointwise(&[Setting::RestingSphere]) {
            return false;
        }
        let whole = "E_t + E_n";
        let parts = |name: &str| self.template.replace(whole, "").contains(name);
        matches!(self.kind, Kind::Pointwise(_) | Kind::Continuous)
            && ["p_t", "p_n", "E_t", "k"].into_iter().any(parts)
    }
}

/// The property of this id.
#[must_use]
pub fn property(id: &str) -> Option<&'static Property> {
    PROPERTIES.iter().find(|property| property.id == id)
}

/// The symbols of templates.
pub(crate) const SYMBOLS: [&str; 15] = [
    "v", "a", "W_tt", "W_tn", "W_nn", "mu", "e", "v_1", "p_t", "p_n", "E_t", "E_n", "k", "i_x",
    "alpha",
];

/// A comparison of two numbers.
#[derive(Clone, Debug)]
pub(crate) struct Comparison<N> {
    pub(crate) lhs: N,
    pub(crate) rel: Rel,
    pub(crate) rhs: N,
}

/// What a property demands of one outcome: a link of its template.
#[derive(Clone, Debug)]
pub(crate) struct Demand<N> {
    pub(crate) when: Vec<Comparison<N>>,
    pub(crate) claim: Comparison<N>,
    /// the link as written
    pub(crate) text: String,
}

/// A template, parsed.
pub(crate) struct Template {
    sentence: Sentence,
    scope: Scope,
}

impl Template {
    /// Reads a template that speaks of outcomes.
    pub(crate) fn new(text: &str) -> Self {
        let mut scope = Scope::default();
        for name in SYMBOLS {
            let var = Var { name: name.into(), of: None, lower: None, upper: None };
            scope.declare(var).expect("distinct names");
        }
        let sentence = parse_sentence(text, &scope).expect("the template is well formed");
        Self { sentence, scope }
    }

    /// Whether it is that no energy is created.
    pub(crate) fn is_of_energy(&self) -> bool {
        self.sentence == Self::new(NO_ENERGY_CREATED).sentence
    }

    /// For «a + b compared with 0» the same of a and of b, which together say more.
    pub(crate) fn summands(&self) -> Option<Self> {
        let [Link::Relation(Relation { lhs: Expr::Add(a, b), rel, rhs })] =
            &self.sentence.links[..]
        else {
            return None;
        };
        let signs = matches!(rel, Rel::Le | Rel::Ge) && *rhs == Expr::int(0);
        let link =
            |lhs: &Expr| Link::Relation(Relation { lhs: lhs.clone(), rel: *rel, rhs: rhs.clone() });
        let links = vec![link(a), link(b)];
        let sentence = Sentence { links, ..self.sentence.clone() };
        signs.then(|| Self { sentence, scope: self.scope.clone() })
    }

    /// What it says of an outcome, in any number system. `None` where a ratio has no meaning.
    pub(crate) fn demands<N: Number>(
        &self,
        contact: &Contact<N>,
        outcome: &Outcome<N>,
    ) -> Option<Vec<Demand<N>>> {
        let (w, p) = (contact.delassus(), &outcome.impulse);
        let sliding = p.normal.clone() * contact.friction();
        let known = [
            contact.slip(),
            contact.approach(),
            w.tt(),
            w.tn(),
            w.nn(),
            contact.friction(),
            contact.restitution(),
            &outcome.slip,
            &p.tangential,
            &p.normal,
            &outcome.work.tangential,
            &outcome.work.normal,
        ];
        let mut symbols: Vec<Option<N>> = known.into_iter().cloned().map(Some).collect();
        symbols.push(outcome.slip.checked_div(contact.slip()));
        symbols.push((-p.tangential.clone()).checked_div(&sliding));
        symbols.push(contact.alpha());
        let side = |expr: &Expr| value(expr, &symbols);
        let comparison =
            |r: &Relation| Some(Comparison { lhs: side(&r.lhs)?, rel: r.rel, rhs: side(&r.rhs)? });
        let when: Vec<_> = self.sentence.when.iter().map(comparison).collect::<Option<_>>()?;
        let demand = |link: &Link| match link {
            Link::Relation(relation) => {
                use kane_algebra::syntax::Notation as _;
                let mut text = relation.plain(self.scope.context());
                if !self.sentence.when.is_empty() {
                    text =
                        format!("{text} when {}", self.sentence.when.plain(self.scope.context()));
                }
                Some(Demand { when: when.clone(), claim: comparison(relation)?, text })
            }
            Link::Limit(_) => None,
        };
        self.sentence.links.iter().map(demand).collect()
    }
}

/// The value of an expression by field operations; `None` if a symbol has none, or by division by zero.
pub fn value<N: Number>(expr: &Expr, symbols: &[Option<N>]) -> Option<N> {
    let of = |expr: &Expr| value(expr, symbols);
    Some(match expr {
        Expr::Num(exact) => N::from_rational(exact),
        Expr::Var(index) => symbols.get(*index)?.clone()?,
        Expr::Neg(a) => -of(a)?,
        Expr::Add(a, b) => of(a)? + of(b)?,
        Expr::Sub(a, b) => of(a)? - of(b)?,
        Expr::Mul(a, b) => of(a)? * of(b)?,
        Expr::Div(a, b) => of(a)?.checked_div(&of(b)?)?,
        Expr::Pow(a, n) => {
            let base = of(a)?;
            (0..*n).fold(N::one(), |product, _| product * &base)
        }
        _ => return None,
    })
}
