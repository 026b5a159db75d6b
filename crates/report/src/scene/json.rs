//! The report for programs. The schema is documented in `docs/scene-format.md`.

use kane_scene::{Known, Round, Shown};
use serde::Serialize;

use super::{SceneReport, verdict, who};
use crate::envelope::{Schema, enveloped};

#[derive(Serialize)]
struct File<'a> {
    title: &'a str,
    headline: String,
    chosen: Option<String>,
    shown: String,
    asked: Vec<Asked<'a>>,
    reasons: &'a [String],
    models: Vec<Tried>,
    kinetic_energy_at_start_j: f64,
    impacts: Vec<Impact<'a>>,
    end: Option<End<'a>>,
}

#[derive(Serialize)]
struct Asked<'a> {
    quantity: String,
    unit: &'static str,
    value: f64,
    exact: Option<&'a str>,
    error: Option<f64>,
    error_is: Option<&'static str>,
    tolerance: f64,
    inputs_move_it_by: Option<f64>,
    inputs_are: Option<&'static str>,
}

#[derive(Serialize)]
struct Tried {
    model: String,
    cost: u64,
    cost_is: &'static str,
    errors: Vec<Option<f64>>,
    errors_are: Option<&'static str>,
    error_by_tolerance: Option<f64>,
    good_enough: bool,
    verdict: String,
}

#[derive(Serialize)]
struct Impact<'a> {
    time_s: &'a str,
    who: String,
    regime: &'a str,
    v_t_before_m_s: &'a str,
    v_t_after_m_s: &'a str,
    approach_m_s: &'a str,
    separation_m_s: &'a str,
    p_t_n_s: &'a str,
    p_n_n_s: &'a str,
    normal_j: &'a str,
    tangential_j: &'a str,
    rotational_j: &'a str,
    gravity_j: &'a str,
    after: Vec<State<'a>>,
}

#[derive(Serialize)]
struct State<'a> {
    x_m: &'a str,
    y_m: &'a str,
    v_x_m_s: &'a str,
    v_y_m_s: &'a str,
    omega_rad_s: &'a str,
}

#[derive(Serialize)]
struct End<'a> {
    time_s: &'a str,
    impacts: u64,
    bodies: Vec<State<'a>>,
}

fn state(body: &Round<Shown>) -> State<'_> {
    State {
        x_m: &body.position[0].text,
        y_m: &body.position[1].text,
        v_x_m_s: &body.motion.vx.text,
        v_y_m_s: &body.motion.vy.text,
        omega_rad_s: &body.motion.omega.text,
    }
}

/// The report as JSON, ended by a line feed. States are text, because exact ones are fractions.
#[must_use]
pub fn json(report: &SceneReport<'_>) -> String {
    let answer = report.answer;
    let bodies = answer.end.as_ref().map_or(1, |end| end.bodies.len());
    let known = answer.known.map(Known::id);
    let file = File {
        title: &report.title,
        headline: report.headline(),
        chosen: answer.chosen.map(|model| model.to_string()),
        shown: answer.shown.to_string(),
        asked: answer
            .lines
            .iter()
            .map(|line| Asked {
                quantity: line.quantity.to_string(),
                unit: line.quantity.unit(),
                value: line.value,
                exact: line.exact.as_deref(),
                error: line.error,
                error_is: known,
                tolerance: line.tolerance,
                inputs_move_it_by: line.spread.map(|spread| spread.by),
                inputs_are: line
                    .spread
                    .map(|spread| if spread.enclosed { "enclosed" } else { "at corners" }),
            })
            .collect(),
        reasons: &answer.reasons,
        models: answer
            .judged
            .iter()
            .map(|judged| Tried {
                model: judged.model.to_string(),
                cost: judged.cost,
                cost_is: if judged.model.mechanics.is_counted() { "counted" } else { "estimated" },
                errors: judged.errors.clone(),
                errors_are: judged.ratio.and(known),
                error_by_tolerance: judged.ratio,
                good_enough: judged.verdict == kane_scene::Verdict::Meets,
                verdict: verdict(&judged.verdict, answer.known),
            })
            .collect(),
        kinetic_energy_at_start_j: answer.start_energy,
        impacts: answer
            .bounces
            .iter()
            .map(|bounce| Impact {
                time_s: &bounce.time.text,
                who: who(bounce.encounter, bodies),
                regime: bounce.regime,
                v_t_before_m_s: &bounce.slip[0].text,
                v_t_after_m_s: &bounce.slip[1].text,
                approach_m_s: &bounce.approach.text,
                separation_m_s: &bounce.separation.text,
                p_t_n_s: &bounce.impulse.tangential.text,
                p_n_n_s: &bounce.impulse.normal.text,
                normal_j: &bounce.ledger.normal.text,
                tangential_j: &bounce.ledger.tangential.text,
                rotational_j: &bounce.ledger.rotational.text,
                gravity_j: &bounce.gravity.text,
                after: std::iter::once(&bounce.after.0).chain(&bounce.after.1).map(state).collect(),
            })
            .collect(),
        end: answer.end.as_ref().map(|end| End {
            time_s: &end.time.text,
            impacts: end.impacts,
            bodies: end.bodies.iter().map(state).collect(),
        }),
    };
    enveloped(Schema { name: "kane-scene", version: 1 }, &report.command, file)
}
