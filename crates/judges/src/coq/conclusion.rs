//! What a lemma concludes, and what stands behind its symbols.

use kane_kernel::{Conclusion, Finding, Goal, Link, Relation};

use super::NotEmitted;
use super::prose::{Prose, arrow, conj};
use super::reify::Symbols;

/// What is concluded: as data, and as people read it.
pub(super) fn conclusion(
    prose: &Prose<'_>,
    goal: &Goal,
    finding: Finding,
) -> Result<(String, String), NotEmitted> {
    let symbols = prose.symbols;
    let one =
        |r: &Relation| -> Result<Relation, NotEmitted> { Ok(symbols.expanded([r])?.remove(0)) };
    Ok(match (&goal.conclusion, finding) {
        (Conclusion::Link(Link::Relation(r)), Finding::Proved) => {
            let r = one(r)?;
            let mut all = prose.defined(&r)?;
            all.push(prose.relation(&r)?);
            (format!("Holds ({})", symbols.relation(&r)?), conj(&all))
        }
        (Conclusion::Link(Link::Relation(r)), Finding::Refuted) => {
            let r = one(r)?;
            let says = arrow(&prose.defined(&r)?, &prose.relation(&r)?);
            (format!("IfDefined ({})", symbols.relation(&r)?), says)
        }
        (Conclusion::Link(Link::Relation(r)), Finding::IllDefined) => {
            let r = one(r)?;
            (format!("Defined ({})", symbols.relation(&r)?), conj(&prose.defined(&r)?))
        }
        (Conclusion::Contradiction, _) | (_, Finding::Vacuous | Finding::Consistent) => {
            ("Falsehood".to_owned(), "False".to_owned())
        }
        (Conclusion::NotImplied(s), _) if s.limits().next().is_none() => {
            (format!("Sentence ({})", symbols.sentence(s, true)?), prose.sentence(s, true)?)
        }
        _ => return Err(NotEmitted::Step("a limit as conclusion")),
    })
}

/// What stands behind the symbols in the list of values: roots and derivatives, their names and what
/// is known of each.
pub(super) fn behind(symbols: &Symbols<'_>) -> Result<(Vec<String>, Vec<String>), NotEmitted> {
    let prose = Prose { name: &|v| symbols.name(v), symbols };
    let (mut names, mut known) = symbols.roots(&prose)?;
    names.extend(symbols.slope_names());
    known.extend(prose.slopes_known()?);
    Ok((names, known.into_iter().map(|k| format!("({k}) ->\n  ")).collect()))
}
