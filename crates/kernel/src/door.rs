//! The door: what enters the kernel is canonical, or does not enter.
//!
//! A rational number has a positive denominator and no common factor with it. Polynomials are
//! canonical by construction; numbers are not, since whoever builds one may skip the reduction.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed};

use crate::{
    Approach, Bound, Certificate, Checked, Conclusion, Evidence, Expr, Failure, Germ, Goal, Link,
    Model, Point, Proof, Rejection, Root, Sentence, SideProof, Target, expressions,
};

/// Checks that all numbers of a goal and of a certificate are canonical.
///
/// # Errors
/// [`Rejection::NotCanonical`].
pub(crate) fn enter(goal: &Goal, certificate: &Certificate) -> Checked {
    let Goal { context, hypotheses, behind, when, conclusion } = goal;
    let bounds = context.vars.iter().flat_map(|v| [&v.lower, &v.upper]).flatten();
    bounds.map(|Bound { value, .. }| value).try_for_each(number)?;
    context.lets.iter().map(|d| &d.body).try_for_each(expression)?;
    context.values.iter().map(|(_, e)| e).try_for_each(expression)?;
    hypotheses.iter().map(|h| &h.sentence).chain(behind).try_for_each(sentence)?;
    expressions(when, &[]).try_for_each(expression)?;
    match conclusion {
        Conclusion::Link(l) => links(std::slice::from_ref(l))?,
        Conclusion::NotImplied(s) => sentence(s)?,
        Conclusion::Contradiction => {}
    }
    evidence(&certificate.evidence)
}

fn evidence(found: &Evidence) -> Checked {
    match found {
        Evidence::Contradiction(p) => proof(p),
        Evidence::Limit(sides) => sides.iter().try_for_each(side_proof),
        Evidence::Split { cases, .. } => cases.iter().try_for_each(|case| evidence(&case.then)),
        Evidence::Model(Model::Point(p)) => point(p),
        Evidence::Model(Model::Functions(f)) => {
            f.values.iter().map(|(_, e)| e).try_for_each(expression)?;
            f.ranges.iter().try_for_each(proof)?;
            for (p, limits) in &f.premises {
                proof(p)?;
                limits.iter().flatten().try_for_each(side_proof)?;
            }
            match &f.failure {
                Failure::At(p) => point(p),
                Failure::Reaches(sides) => sides.iter().try_for_each(side_proof),
                Failure::Limit { target, proof: side, apart, .. } => {
                    if let Target::Finite(e) = target {
                        expression(e)?;
                    }
                    apart.as_deref().map_or(Ok(()), proof)?;
                    side_proof(side)
                }
            }
        }
    }
}

fn number(q: &BigRational) -> Checked {
    let reduced = || q.numer().gcd(q.denom()) == BigInt::one();
    (q.denom().is_positive() && reduced()).then_some(()).ok_or(Rejection::NotCanonical)
}

fn expression(e: &Expr) -> Checked {
    let mut todo = vec![e];
    while let Some(e) = todo.pop() {
        if let Expr::Num(q) = e {
            number(q)?;
        }
        todo.extend(e.children());
    }
    Ok(())
}

fn sentence(s: &Sentence) -> Checked {
    expressions(&s.when, &[]).try_for_each(expression)?;
    links(&s.links)
}

fn links(links: &[Link]) -> Checked {
    expressions(&[], links).try_for_each(expression)?;
    links.iter().try_for_each(|link| match link {
        Link::Limit(l) => match &l.at {
            Approach::To(a) | Approach::Above(a) | Approach::Below(a) => number(a),
            Approach::PlusInf | Approach::MinusInf => Ok(()),
        },
        Link::Relation(_) => Ok(()),
    })
}

fn point(p: &Point) -> Checked {
    if let Some(Root { lo, hi, .. }) = &p.generator {
        [lo, hi].into_iter().try_for_each(number)?;
    }
    p.values.iter().flat_map(|(_, coefficients)| coefficients).try_for_each(number)
}

fn side_proof(s: &SideProof) -> Checked {
    germ(&s.germ)?;
    proof(&s.along)?;
    proof(&s.at_zero)?;
    s.upper.as_deref().map_or(Ok(()), side_proof)
}

fn germ(g: &Germ) -> Checked {
    g.side.at.iter().try_for_each(number)?;
    proof(&g.positive)?;
    for inside in &g.inside {
        inside.values.iter().map(|(_, e)| e).try_for_each(expression)?;
        proof(&inside.proof)?;
    }
    Ok(())
}

fn proof(p: &Proof) -> Checked {
    let mut todo = vec![p];
    while let Some(p) = todo.pop() {
        match p {
            Proof::Assume { cases, .. } => todo.extend(cases),
            Proof::Split { cases, .. } => todo.extend(cases.iter().map(|case| &case.then)),
            Proof::Positive { .. } => {}
            Proof::Pass { germ: g, along, then, .. } => {
                germ(g)?;
                todo.extend([&**along, then]);
            }
        }
    }
    Ok(())
}
