//! (a) What the puzzle is: Kane's pendulum under each law.

use std::fmt::Write as _;
use std::path::Path;

use kane::collide::{Question, System, answer};
use kane::impact::{Law, laws};
use kane::number::{Rational, Rounding, encode};

use super::groups;
use crate::NotMade;

const FILE: &str = "docs/collisions/double-pendulum.toml";

/// The shipped pendulum.
fn question(root: &Path) -> Result<Question, NotMade> {
    let text = kane::scene::read::load(&root.join(FILE));
    let text = text.map_err(|error| NotMade::because(FILE, error))?;
    kane::scene::read::collision(FILE, &text).map_err(|error| NotMade::because(FILE, error))
}

/// The same with another e.
fn with_restitution(question: &Question, restitution: &Rational) -> Question {
    let mut question = question.clone();
    if let System::Pendulum(pendulum) = &mut question.system {
        pendulum.restitution = restitution.clone();
    }
    question
}

/// k and T⁺/T⁻ of every law, `None` where it has no outcome.
fn said(question: &Question, laws: &[Law]) -> Result<Vec<Option<[f64; 2]>>, NotMade> {
    let collision = answer(question, laws).map_err(|error| NotMade::because(FILE, error))?;
    let of = |law: &kane::collide::LawAnswer| {
        let answer = law.answer.as_ref().ok()?;
        let value = |symbol| {
            answer.readings.iter().find(|one| one.symbol == symbol).and_then(|one| one.float)
        };
        Some([value("k")?, value("T+/T-")?])
    };
    Ok(collision.laws.iter().map(of).collect())
}

/// The section.
pub(super) fn section(root: &Path) -> Result<String, NotMade> {
    let asked = question(root)?;
    let System::Pendulum(pendulum) = &asked.system else {
        return Err(NotMade::because(FILE, "it is no pendulum"));
    };
    let float = |x: &Rational| encode::<f64>(x, Rounding::NearestEven);
    let (stated, other) = (pendulum.restitution.clone(), Rational::new(7.into(), 10.into()));
    // laws that run on invented parameters say nothing of a pendulum
    let laws: Vec<Law> = laws().iter().filter(|law| law.invented().is_empty()).cloned().collect();
    let [first, second] = [&stated, &other].map(|e| said(&with_restitution(&asked, e), &laws));
    let rows: Vec<_> = first?.into_iter().zip(second?).collect();
    let mut out = format!(
        "## What the puzzle is\n\nTwo hinged rods strike the floor with their free end, [{FILE}](../{FILE}): μ = {}, without any motor, and yet the kinetic energy after is more than before. T⁺/T⁻ by each law, at the e of the file and at the other value that is quoted as Kane's:\n\n| law | T⁺/T⁻ at e = {} | at e = {} | k at e = {} |\n|---|---|---|---|\n",
        float(&pendulum.friction),
        float(&stated),
        float(&other),
        float(&other),
    );
    let ids: Vec<&str> = laws.iter().map(|law| law.info.id).collect();
    let mut groups = groups(&ids, &rows);
    // the greatest gain first, those without an outcome last
    let size =
        |row: &(Option<[f64; 2]>, Option<[f64; 2]>)| row.1.or(row.0).map_or(-1.0, |[_, t]| t);
    groups.sort_by(|a, b| size(&b.1).total_cmp(&size(&a.1)));
    let bold = |ratio: f64| {
        if ratio > 1.0 { format!("**{ratio:.2}**") } else { format!("{ratio:.2}") }
    };
    let shown = |cell: Option<[f64; 2]>| cell.map_or("none".into(), |[_, ratio]| bold(ratio));
    for (ids, (first, second)) in groups {
        let k = second.map_or("–".into(), |[k, _]| super::signed(k, 2));
        let names: Vec<String> = ids.iter().map(|id| super::law_link(id)).collect();
        let _ =
            writeln!(out, "| {} | {} | {} | {k} |", names.join(", "), shown(first), shown(second));
    }
    let _ = writeln!(
        out,
        "\nAgain by `kane collide {FILE}`; for which μ and e energy rises: [the map](figures/energy-map.svg), [its data](data/kane-puzzle.csv). It rises where the contact couples, the slip stops or turns round on the way, and Newton's e fixes the normal velocity after, whatever friction did before."
    );
    Ok(out)
}
