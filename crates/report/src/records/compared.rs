//! Two logs against each other.

use std::fmt::Write as _;

use kane_algebra::syntax::visible;
use kane_records::comparison::{Change, Comparison};
use kane_records::friction::FrictionLaw;
use kane_records::restitution::NormalLaw;
use kane_records::statistics::percent;
use serde::Serialize;

use super::wording::{asks, brief, friction_name};
use crate::envelope::{Program, Schema, written};
use crate::markdown::fenced;

/// What changed, for people; the names are those of the older and the newer log.
#[must_use]
pub fn compared_text(comparison: &Comparison, [old, new]: &[String; 2]) -> String {
    let [old, new] = [old, new].map(|name| visible(name));
    let mut out = format!("{new}, against {old}\n{}\n", news(comparison));
    if !comparison.compares() {
        let _ = writeln!(out, "\n       {}", rejected(comparison));
        return out;
    }
    out.push_str("A residual is told by the scale of what is checked: 1 is all of it.\n\n");
    for change in &comparison.changes {
        let [before, now] = [0, 1].map(|i| came(change, i));
        let _ = writeln!(
            out,
            "{}  {}: {before} before, {now} now",
            mark(change.worse),
            asks(change.check)
        );
    }
    let laws =
        comparison.friction.map(|law| law.map_or_else(|| "not asked".to_owned(), friction_name));
    let [before, now] = comparison.friction_close.map(|share| brief(percent(share)));
    let worse = mark(comparison.friction_is_worse());
    let _ = writeln!(
        out,
        "{worse}  friction: {} in {before} % before, {} in {now} % now",
        laws[0], laws[1]
    );
    let [before, now] = comparison.normal_close.map(|share| brief(percent(share)));
    let worse = mark(comparison.normal_is_worse());
    let _ = writeln!(out, "{worse}  restitution as stated in {before} % before, {now} % now");
    let _ = writeln!(out, "{}  {}", mark(rejects_more(comparison)), rejected(comparison));
    if comparison.normal_moved() {
        let [before, now] = comparison.normal_offset.map(brief);
        let _ = writeln!(
            out,
            "MOVED  e is off what is stated by {before} on the whole before, {now} now"
        );
    }
    if comparison.arm_moved() {
        let [before, now] = comparison.arm.map(|arm| brief(percent(arm.unwrap_or(0.0))));
        let _ = writeln!(
            out,
            "MOVED  the stated arm is too long by {before} % in the median before, {now} % now"
        );
    }
    out
}

/// The same for the web: its lines as they are, so that no name in them is markup.
#[must_use]
pub fn compared_markdown(comparison: &Comparison, names: &[String; 2]) -> String {
    fenced(&compared_text(comparison, names))
}

/// What stands before a line.
const fn mark(worse: bool) -> &'static str {
    if worse { "WORSE" } else { "     " }
}

/// What came of a check in the older log, at 0, or in the newer one, at 1.
pub(super) fn came(change: &Change, at: usize) -> String {
    if change.rows[at] == 0 {
        return "not asked".to_owned();
    }
    let share = |share: f64| format!("{} %", brief(percent(share)));
    let mut words = format!("fails in {}", share(change.failing[at]));
    if change.failing[at] > 0.0 {
        let _ = write!(words, " by at most {}", brief(change.worst[at]));
    }
    if change.undecided[at] > 0.0 {
        let _ = write!(words, " and is undecided in {}", share(change.undecided[at]));
    }
    words
}

/// Whether rows are rejected that were not.
pub(super) const fn rejects_more(comparison: &Comparison) -> bool {
    comparison.rejected[1] > comparison.rejected[0]
}

fn rejected(comparison: &Comparison) -> String {
    let [before, now] = comparison.rejected;
    format!("rows rejected: {before} before, {now} now")
}

/// What came of it, in a sentence.
pub(super) fn news(comparison: &Comparison) -> &'static str {
    if comparison.rows[1] == 0 {
        "Nothing is compared: no row of the newer log could be checked."
    } else if comparison.rows[0] == 0 {
        "Nothing is compared: no row of the older log could be checked."
    } else if comparison.is_worse() {
        "Worse than before."
    } else if comparison.normal_moved() || comparison.arm_moved() {
        "Nothing is worse, but e or the arm is off by another amount."
    } else {
        "Nothing is worse."
    }
}

/// What changed, for programs.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct File<'a> {
    schema: Schema,
    program: Program,
    old: &'a str,
    new: &'a str,
    worse: bool,
    rows: [u64; 2],
    checks: Vec<Checked>,
    friction: [Option<&'static str>; 2],
    friction_close: [f64; 2],
    restitution: [Option<&'static str>; 2],
    restitution_close: [f64; 2],
    restitution_off: [f64; 2],
    restitution_moved: bool,
    arm_off: [Option<f64>; 2],
    arm_moved: bool,
    rejected: [u64; 2],
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Checked {
    check: &'static str,
    rows: [u64; 2],
    failing: [f64; 2],
    undecided: [f64; 2],
    worst: [f64; 2],
    worse: bool,
}

/// What the report is, as a JSON Schema.
#[cfg(feature = "schema")]
pub(crate) fn baseline_schema() -> serde_json::Value {
    crate::envelope::schema_of::<File<'static>>("kane check --baseline")
}

/// What changed as JSON, ended by a line feed; what was before comes first in every pair.
#[must_use]
pub fn compared_json(comparison: &Comparison, [old, new]: &[String; 2]) -> String {
    let change = |change: &Change| Checked {
        check: change.check.id(),
        rows: change.rows,
        failing: change.failing,
        undecided: change.undecided,
        worst: change.worst,
        worse: change.worse,
    };
    written(&File {
        schema: Schema { name: "kane-check-baseline", version: 1 },
        program: Program::THIS,
        old,
        new,
        worse: comparison.is_worse(),
        rows: comparison.rows,
        checks: comparison.changes.iter().map(change).collect(),
        friction: comparison.friction.map(|law| law.map(FrictionLaw::id)),
        friction_close: comparison.friction_close,
        restitution: [0, 1].map(|i| comparison.normal[i].as_ref().map(NormalLaw::id)),
        restitution_close: comparison.normal_close,
        restitution_off: comparison.normal_offset,
        restitution_moved: comparison.normal_moved(),
        arm_off: comparison.arm,
        arm_moved: comparison.arm_moved(),
        rejected: comparison.rejected,
    })
}

#[cfg(test)]
mod tests {
    use kane_records::comparison::compare;

    use super::super::compared_junit;
    use super::super::made_up::study_of;
    use super::*;

    const HEAD: &str =
        "mass,inertia,rx,ry,mu,e,vx_pre,vy_pre,omega_pre,vx_post,vy_post,omega_post\n";
    /// A body that slides on, and the spin that the impulse gives it.
    const ROW: &str = "1,0.4,0,-1,0.1,0.5,2.123456789012345,-1,0,1.973456789012345,0.5,-0.375\n";
    /// The same with another spin.
    const TWISTED: &str = "1,0.4,0,-1,0.1,0.5,2.123456789012345,-1,0,1.973456789012345,0.5,-0.75\n";

    fn compared(old: &str, new: &str) -> (Comparison, String) {
        let [old, new] = [old, new].map(study_of);
        let comparison = compare(&old, &new);
        let text = compared_text(&comparison, &["old".to_owned(), "new".to_owned()]);
        (comparison, text)
    }

    fn line<'a>(text: &'a str, of: &str) -> &'a str {
        text.lines().find(|line| line.contains(of)).unwrap_or_else(|| panic!("{of}: {text}"))
    }

    #[test]
    fn a_check_that_fails_more_says_by_how_much_and_by_what_scale() {
        let (comparison, text) = compared(&format!("{HEAD}{ROW}"), &format!("{HEAD}{TWISTED}"));
        assert!(comparison.is_worse());
        let moment = line(&text, "the impulse acts");
        assert!(moment.starts_with("WORSE  "), "{moment}");
        assert!(moment.contains(": fails in 0 % before, fails in 100 % by at most "), "{moment}");
        assert!(text.contains("by the scale of what is checked"), "{text}");
        assert!(line(&text, "surfaces do not pull").starts_with("       the"), "{text}");
    }

    #[test]
    fn a_check_that_is_asked_no_more_is_worse_and_not_said_to_hold() {
        let head = HEAD.replace(",mu,", ",note,");
        let (comparison, text) = compared(&format!("{HEAD}{ROW}"), &format!("{head}{ROW}"));
        assert!(comparison.is_worse() && comparison.compares());
        let cone = line(&text, "friction is in its cone");
        assert!(cone.starts_with("WORSE  ") && cone.ends_with("before, not asked now"), "{cone}");
    }

    #[test]
    fn what_is_undecided_is_told_beside_what_fails() {
        let short = format!("{HEAD}1,0.4,0,-1,0.1,1,1,-1,0,0.8,1,0.5\n");
        let (_, text) = compared(&short, &short);
        let moment = line(&text, "the impulse acts");
        assert!(moment.contains("fails in 0 % and is undecided in 100 % before"), "{moment}");
    }

    #[test]
    fn of_a_log_without_a_row_nothing_is_compared() {
        let whole = format!("{HEAD}{ROW}");
        for (old, new, which) in [(&whole[..], HEAD, "newer"), (HEAD, &whole, "older")] {
            let (comparison, text) = compared(old, new);
            assert!(!comparison.compares());
            let none = format!("Nothing is compared: no row of the {which} log could be checked.");
            assert!(text.contains(&none) && !text.contains("fails"), "{text}");
            let suite = compared_junit(&comparison, &["a".to_owned(), "b".to_owned()]);
            assert!(suite.contains(&format!("<failure message=\"{none}\"/>")), "{suite}");
        }
    }
}
