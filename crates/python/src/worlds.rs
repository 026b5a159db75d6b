//! Collisions and scenes, from the text of a file.

use kane_impact::{Law, laws, set_parameter};
use kane_report::collision;
use kane_report::scene::{SceneReport, json, sheet};
use kane_scene::collide::{Question, answer, in_depth};
use kane_scene::{Effort, Model, Verdict, read};
use pyo3::prelude::*;

use crate::away::away;
use crate::bad_input;

/// Puts a collision, as `docs/collide-format.md` describes it, to all laws or to one; gives JSON and HTML.
///
/// # Errors
/// `ValueError` for what is no collision, or no law or parameter.
#[pyfunction]
pub(crate) fn collide(
    py: Python<'_>,
    text: String,
    name: String,
    law: Option<String>,
    parameters: Vec<(String, String)>,
) -> PyResult<(String, String)> {
    away(py, move |_| collided(&text, &name, law.as_deref(), &parameters))?
}

fn collided(
    text: &str,
    name: &str,
    law: Option<&str>,
    parameters: &[(String, String)],
) -> PyResult<(String, String)> {
    let mut all = laws().to_vec();
    for (path, value) in parameters {
        let value = read::read(value).map_err(|why| bad_input(format!("{path} {why}")))?;
        set_parameter(&mut all, path, &value).map_err(bad_input)?;
    }
    let mut question: Question = read::collision(name, text).map_err(bad_input)?;
    question.command = format!("kane.collide({name})");
    let answered = match law {
        Some(id) => in_depth(&question, known(&all, id)?),
        None => {
            // a law whose parameters would be invented is left out, as the program does
            let given = |law: &Law| {
                let set = |name: &&str| {
                    let path = format!("{}.{name}", law.info.id);
                    parameters.iter().any(|(given, _)| *given == path)
                };
                law.invented().iter().all(|name| set(&&**name))
            };
            let asked: Vec<Law> = all.iter().filter(|law| given(law)).cloned().collect();
            answer(&question, &asked)
        }
    };
    let collision = answered.map_err(|why| bad_input(why.map(|exact| exact.to_string())))?;
    Ok((collision::json(&collision), collision::sheet(&collision).html()))
}

fn known<'a>(laws: &'a [Law], id: &str) -> PyResult<&'a Law> {
    laws.iter().find(|law| law.info.id == id).ok_or_else(|| {
        let ids: Vec<&str> = laws.iter().map(|law| law.info.id).collect();
        bad_input(format!("no law is called {id:?}; there are {}", ids.join(", ")))
    })
}

/// Answers a scene, as `docs/scene-format.md` describes it, by the least model that is good enough, or by
/// the one that is named; gives JSON, HTML, and whether the model shown meets the tolerance.
///
/// # Errors
/// `ValueError` for what is no scene or model, and where no model has an answer.
#[pyfunction]
pub(crate) fn scene(
    py: Python<'_>,
    text: String,
    name: String,
    model: Option<String>,
) -> PyResult<(String, String, bool)> {
    away(py, move |_| answered(&text, &name, model.as_deref()))?
}

fn answered(text: &str, name: &str, model: Option<&str>) -> PyResult<(String, String, bool)> {
    let wanted = model.map(|model| Model::named(model, laws())).transpose().map_err(bad_input)?;
    let scene = read::scene(name, text).map_err(bad_input)?;
    let answer = kane_scene::answer(&scene, laws(), wanted, Effort::Chosen, &mut |_, _| {})
        .map_err(bad_input)?;
    let meets = answer
        .judged
        .iter()
        .any(|judged| judged.model == answer.shown && judged.verdict == Verdict::Meets);
    let command = format!("kane.scene({name})");
    let report =
        SceneReport { answer: &answer, title: scene.title.clone(), command, is_compared: false };
    Ok((json(&report), sheet(&report).html(), meets))
}
