//! `exists y: … by y := …`: a claim is read with the witness in the place of the name; without `by` the name keeps its
//! placeholder until a witness is found.

use std::collections::BTreeSet;
use std::ops::Range;

use kane_algebra::syntax::{
    Parser, SyntaxError, SyntaxErrorKind, Token, canonical_name, placeholder,
};
use kane_kernel::{Expr, Link, Relation};

use super::citation::DraftContent;

/// Names and where they stand.
type Names = [(String, Range<usize>)];

/// Passes the relations behind `exists y:`, in which placeholders stand for the names.
pub(super) fn relations(p: &mut Parser<'_>) -> Result<Vec<(Link, Range<usize>)>, SyntaxError> {
    let relations = p.spanned_relations()?;
    if p.at_word("as") {
        return Err(p.fault(SyntaxErrorKind::LimitExists));
    }
    Ok(relations.into_iter().map(|(relation, span)| (Link::Relation(relation), span)).collect())
}

/// `y := EXPR, …`: for each name its value.
pub(super) fn witnesses(
    p: &mut Parser<'_>,
    names: &Names,
) -> Result<Vec<Option<Expr>>, SyntaxError> {
    let mut values = vec![None; names.len()];
    let mut count = 0;
    loop {
        let (name, span) = p.name()?;
        p.expect(Token::Define, "`:=` and a value")?;
        let value = p.expr()?;
        let same = |known: &str| canonical_name(known) == canonical_name(name);
        match names.iter().position(|(known, _)| same(known)) {
            Some(place) if values.get(place).is_some_and(Option::is_some) => {
                p.report(SyntaxErrorKind::NamedTwice(name.to_owned()), span);
            }
            Some(place) => values[place] = Some(value),
            None => p.report(SyntaxErrorKind::UnknownSymbol(name.to_owned()), span),
        }
        count += 1;
        if !p.next_item(count)? {
            return Ok(values);
        }
    }
}

/// Puts the values in the place of the names.
pub(super) fn put_in(
    p: &mut Parser<'_>,
    names: &Names,
    values: Vec<Option<Expr>>,
    content: &mut DraftContent,
) -> Result<(), SyntaxError> {
    let DraftContent::Links(links) = content else { return Ok(()) };
    let mut arguments = Vec::new();
    for (place, (name, span)) in names.iter().enumerate() {
        match values.get(place).cloned().flatten() {
            Some(value) => arguments.push(value),
            None => {
                let kind = SyntaxErrorKind::NoWitness(name.clone());
                return Err(SyntaxError { kind, span: span.clone() });
            }
        }
    }
    let sides = |link: &Link| match link {
        Link::Relation(r) => vec![r.lhs.clone(), r.rhs.clone()],
        Link::Limit(_) => Vec::new(),
    };
    let all: Vec<Expr> = links.iter().flat_map(|(link, _)| sides(link)).collect();
    refuse_unused(p, names, &all);
    for (link, span) in links {
        if let Link::Relation(Relation { lhs, rhs, .. }) = link {
            for side in [lhs, rhs] {
                *side = p.with_arguments(side, &arguments, span.clone())?;
            }
        }
    }
    Ok(())
}

/// The names for which nothing is named, once what is said of them may be said of something that is looked for.
pub(super) fn sought(
    p: &mut Parser<'_>,
    names: &Names,
    content: &DraftContent,
) -> Result<Vec<String>, SyntaxError> {
    let DraftContent::Links(links) = content else { return Ok(Vec::new()) };
    let mut sides = Vec::new();
    for (link, span) in links {
        let Link::Relation(r) = link else { continue };
        for side in [&r.lhs, &r.rhs] {
            let mut varies = false;
            p.scope().visit(side, &mut |part| varies |= matches!(part, Expr::Deriv(..)));
            if varies {
                return Err(SyntaxError {
                    kind: SyntaxErrorKind::SoughtBesideDerivative,
                    span: span.clone(),
                });
            }
            sides.push(side.clone());
        }
    }
    refuse_unused(p, names, &sides);
    Ok(names.iter().map(|(name, _)| name.clone()).collect())
}

/// Notes the names whose placeholders stand in none of the expressions.
pub(super) fn refuse_unused(p: &mut Parser<'_>, names: &Names, parts: &[Expr]) {
    // where something is wrong already it may stand where the fault is
    if p.has_faults() {
        return;
    }
    let found: BTreeSet<usize> = parts.iter().flat_map(|part| p.scope().symbols(part)).collect();
    for (place, (name, span)) in names.iter().enumerate() {
        if !matches!(placeholder(place), Expr::Var(symbol) if found.contains(&symbol)) {
            p.report(SyntaxErrorKind::Unused(name.clone()), span.clone());
        }
    }
}
