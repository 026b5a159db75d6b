//! Derived atoms: what substitution and division make of an atom, with the identity behind it.
//!
//! A derived atom is brought into the kernel's state by a cut: cases by the sign of its polynomial,
//! of which those that the identity excludes are closed at once.

use kane_kernel::{Fuel, Poly, Rejection, Sign};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::node::{Fact, Known, Node, Side, Sum, power, whole};
use super::rules::{Flaw, Step};

/// The powers of what is known not to vanish.
pub(super) type Lead<'a> = [(&'a Known, u32)];

/// How a derived polynomial P follows from an older atom O.
#[derive(Clone, Debug)]
pub(super) enum Identity {
    /// P = a·Π·O + b·C·E with a > 0 and an equation E
    Reduced { a: BigRational, lead: Vec<(Known, u32)>, b: BigRational, cofactor: Poly, by: Known },
    /// Π·P = a·O with a > 0
    Divided { a: BigRational, lead: Vec<(Known, u32)> },
}

/// An atom that follows from an older one.
#[derive(Clone, Debug)]
pub(super) struct Derived {
    /// what it follows from
    old: Known,
    /// itself
    pub(super) new: Known,
    how: Identity,
}

/// The opposite of a derived atom, as a summand or an equation: a fact, or a constant.
enum Against {
    /// a fact about P or −P
    Fact(Known),
    /// P is this constant
    Constant(BigInt),
}

fn product(lead: &[(Known, u32)], fuel: &Fuel) -> Step<Poly> {
    let mut out = Poly::one();
    for (known, n) in lead {
        out = out.mul(&known.atom.poly.pow(*n, fuel)?, fuel)?;
    }
    Ok(out)
}

fn borrowed(lead: &[(Known, u32)]) -> Vec<(&Known, u32)> {
    lead.iter().map(|(k, n)| (k, *n)).collect()
}

/// lead(rule)ⁿ·p = q·rule + rest: n, q, rest. With `even`, n is even.
fn division(p: &Poly, v: usize, rule: &Poly, even: bool, fuel: &Fuel) -> Step<(u32, Poly, Poly)> {
    let degree = rule.degree(v);
    let lead = rule.coefficient(v, degree);
    let (mut n, mut q, mut rest) = (0, Poly::default(), p.clone());
    while degree > 0 && rest.degree(v) >= degree {
        let shift = Poly::power(v, rest.degree(v) - degree);
        let top = rest.coefficient(v, rest.degree(v)).mul(&shift, fuel)?;
        rest = rest.mul(&lead, fuel)?.sub(&top.mul(rule, fuel)?);
        q = q.mul(&lead, fuel)?.add(&top);
        n += 1;
    }
    if even && n % 2 == 1 {
        (n, q, rest) = (n + 1, q.mul(&lead, fuel)?, rest.mul(&lead, fuel)?);
    }
    Ok((n, q, rest))
}

/// An equation that reduces others, with what is known of its leading coefficient.
pub(super) struct Reducer<'a> {
    equation: &'a Known,
    var: usize,
    lead: &'a Lead<'a>,
    /// the equation or its opposite, with the sign of the lead
    rule: Poly,
    flip: bool,
    /// Π lead = κ · leading coefficient of the rule
    kappa: BigRational,
    /// whether the lead is known to be positive
    positive: bool,
}

impl<'a> Reducer<'a> {
    /// Prepares a reduction in the variable by the equation.
    pub(super) fn new(
        equation: &'a Known,
        var: usize,
        lead: &'a Lead<'a>,
        fuel: &Fuel,
    ) -> Step<Self> {
        let poly = &equation.atom.poly;
        if equation.atom.sign != Sign::Zero || poly.degree(var) == 0 {
            return Err(Rejection::NotAnEquation(0).into());
        }
        let mut whole_lead = Poly::one();
        for (known, n) in lead {
            if !matches!(known.atom.sign, Sign::Positive | Sign::NonZero) {
                return Err(Rejection::MayVanish.into());
            }
            whole_lead = whole_lead.mul(&known.atom.poly.pow(*n, fuel)?, fuel)?;
        }
        let (content, want) = whole_lead.primitive();
        let (own, have) = poly.coefficient(var, poly.degree(var)).primitive();
        let flip = have == want.neg();
        if have.is_empty() || !(flip || have == want) {
            return Err(Rejection::MayVanish.into());
        }
        let even = |(k, n): &(&Known, u32)| n % 2 == 0 || k.atom.sign == Sign::Positive;
        Ok(Self {
            equation,
            var,
            lead,
            rule: if flip { poly.neg() } else { poly.clone() },
            flip,
            kappa: BigRational::new(content, own),
            positive: lead.iter().all(even),
        })
    }

    /// What the equation makes of an atom; `None` if it stays what it is.
    pub(super) fn derived(&self, old: &Known, fact: Fact, fuel: &Fuel) -> Step<Option<Derived>> {
        let sign = old.atom.sign;
        let even = sign.is_order() && !self.positive;
        let (n, q, rest) = division(&old.atom.poly, self.var, &self.rule, even, fuel)?;
        let (content, new) = rest.primitive();
        if n == 0 {
            return Ok(None);
        }
        let content = whole(content);
        let lead = self.lead.iter().map(|(k, e)| ((*k).clone(), e * n)).collect();
        let how = Identity::Reduced {
            a: BigRational::one() / (power(&self.kappa, n) * &content),
            lead,
            b: if self.flip { content.recip() } else { -content.recip() },
            cofactor: q,
            by: self.equation.clone(),
        };
        Ok(Some(Derived { old: old.clone(), new: Known::new(new, sign, fact), how }))
    }
}

/// The quotient of an atom by factors that do not vanish.
pub(super) fn divided(
    old: &Known,
    factors: &Lead<'_>,
    quotient: &Poly,
    fact: Fact,
    fuel: &Fuel,
) -> Step<Derived> {
    let sign = old.atom.sign;
    let lead: Vec<(Known, u32)> = factors.iter().map(|(k, n)| ((*k).clone(), *n)).collect();
    let allowed = |(k, n): &(Known, u32)| match k.atom.sign {
        Sign::Positive => true,
        Sign::NonZero => n % 2 == 0 || !sign.is_order(),
        Sign::Zero | Sign::NonNegative => false,
    };
    if !lead.iter().all(allowed) {
        return Err(Rejection::MayVanish.into());
    }
    let (have, product) = product(&lead, fuel)?.mul(quotient, fuel)?.primitive();
    let (want, p) = old.atom.poly.primitive();
    if product != p {
        return Err(Rejection::NotAnIdentity.into());
    }
    let how = Identity::Divided { a: BigRational::new(have, want), lead };
    Ok(Derived { old: old.clone(), new: Known::new(quotient.clone(), sign, fact), how })
}

impl Derived {
    /// If the derived atom is a false constant: the contradiction.
    pub(super) fn absurd(&self, fuel: &Fuel) -> Step<Option<Node>> {
        if self.new.atom.decided() != Some(false) {
            return Ok(None);
        }
        let c = self.new.atom.poly.as_constant().unwrap_or_default();
        self.excluded(&Against::Constant(c), fuel).map(Some)
    }

    /// A proof that may use the derived atom.
    pub(super) fn cut(
        &self,
        then: Node,
        fresh: &mut dyn FnMut() -> Fact,
        fuel: &Fuel,
    ) -> Step<Node> {
        let atom = &self.new.atom;
        let Some((fact, _)) = self.new.fact.as_ref().filter(|f| then.used.contains(&f.0)) else {
            return Ok(then);
        };
        let mut cases = vec![Side { opposite: false, sign: atom.sign, fact: *fact, then }];
        // What is left of the line.
        let others: &[(bool, Sign)] = match atom.sign {
            Sign::Zero => &[(false, Sign::Positive), (true, Sign::Positive)],
            Sign::NonZero => &[(false, Sign::Zero)],
            Sign::NonNegative => &[(true, Sign::Positive)],
            Sign::Positive => &[(true, Sign::NonNegative)],
        };
        for &(opposite, sign) in others {
            let side = if opposite { atom.poly.neg() } else { atom.poly.clone() };
            let known = Known::new(side, sign, fresh());
            let fact = known.fact.as_ref().map_or(0, |f| f.0);
            let then = self.excluded_side(&Against::Fact(known), opposite, fuel)?;
            cases.push(Side { opposite, sign, fact, then });
        }
        Ok(Node::split(atom.poly.clone(), cases))
    }

    fn excluded(&self, against: &Against, fuel: &Fuel) -> Step<Node> {
        let Against::Constant(c) = against else {
            return Err(Flaw::WrongSign);
        };
        self.excluded_side(against, c.is_negative(), fuel)
    }

    /// Why the derived polynomial does not have the sign that the derived atom excludes; `opposite`
    /// if that is said of −P.
    fn excluded_side(&self, against: &Against, opposite: bool, fuel: &Fuel) -> Step<Node> {
        let one = BigRational::one;
        let mut sum = Sum::default();
        // ±P, as a summand that stands for it.
        let side = |sum: &mut Sum, lead: &[(&Known, u32)]| match against {
            Against::Fact(k) => {
                sum.product(one(), &[lead, &[(k, 1)]].concat());
            }
            Against::Constant(c) if c.is_zero() => {}
            Against::Constant(c) => {
                sum.product(whole(c.abs()), lead);
            }
        };
        let toward = |q: BigRational| if opposite { q } else { -q };
        match (&self.how, self.new.atom.sign) {
            (Identity::Reduced { a, lead, b, cofactor, by }, Sign::Zero) => {
                // P > 0: P − aΠO − bCE = 0; −P > 0: −P + aΠO + bCE = 0.
                side(&mut sum, &[]);
                sum.multiple(toward(a.clone()), product(lead, fuel)?, &self.old);
                sum.multiple(toward(b.clone()), cofactor.clone(), by);
            }
            (Identity::Reduced { a, lead, b, cofactor, by }, Sign::NonZero) => {
                // P = 0: (aΠO)² + aΠO·(bCE − P) = 0
                let known = product(lead, fuel)?.mul(&self.old.atom.poly, fuel)?;
                let mut squares = vec![(&self.old, 2)];
                squares.extend(lead.iter().map(|(k, n)| (k, 2 * n)));
                sum.product(a * a, &squares);
                sum.multiple(a * b, known.mul(cofactor, fuel)?, by);
                if let Against::Fact(k) = against {
                    sum.multiple(-a, known, k);
                }
            }
            (Identity::Reduced { a, lead, b, cofactor, by }, _) => {
                // −P ≥ 0 or −P > 0: aΠO + bCE − P = 0
                let factors = [&borrowed(lead)[..], &[(&self.old, 1)]].concat();
                sum.product(a.clone(), &factors);
                sum.multiple(b.clone(), cofactor.clone(), by);
                side(&mut sum, &[]);
            }
            (Identity::Divided { a, lead }, Sign::Zero) => {
                // With R to make all powers of Π even that have to be: RΠ·P − aR·O = 0.
                let odd = |(k, n): &&(Known, u32)| n % 2 == 1 && k.atom.sign == Sign::NonZero;
                let rest: Vec<(Known, u32)> =
                    lead.iter().filter(odd).map(|(k, _)| (k.clone(), 1)).collect();
                side(&mut sum, &[borrowed(lead), borrowed(&rest)].concat());
                sum.multiple(toward(a.clone()), product(&rest, fuel)?, &self.old);
            }
            (Identity::Divided { a, lead }, Sign::NonZero) => {
                // P = 0: (aO)² − aO·Π·P = 0
                sum.product(a * a, &[(&self.old, 2)]);
                if let Against::Fact(k) = against {
                    let cofactor = self.old.atom.poly.mul(&product(lead, fuel)?, fuel)?;
                    sum.multiple(-a, cofactor, k);
                }
            }
            (Identity::Divided { a, lead }, _) => {
                // aO + Π·(−P) = 0
                sum.product(a.clone(), &[(&self.old, 1)]);
                side(&mut sum, &borrowed(lead));
            }
        }
        Ok(sum.close())
    }
}
