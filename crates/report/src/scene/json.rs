//! The report for programs. The schema is documented in `docs/scene-format.md`.

use kane_scene::{Round, Shown};
use serde::Serialize;

use super::{SceneReport, verdict, who};
use crate::envelope::{Program, Schema};

#[derive(Serialize)]
struct File<'a> {
    schema: Schema,
    program: Program,
    command: &'a str,
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
    error_at_most: Option<f64>,
    tolerance: f64,
    inputs_move_it_by: Option<f64>,
}

#[derive(Serialize)]
struct Tried {
    model: String,
    counted_cost: u64,
    errors_at_most: Vec<Option<f64>>,
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
    let file = File {
        schema: Schema { name: "kane-scene", version: 1 },
        program: Program::THIS,
        command: &report.command,
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
                error_at_most: line.error,
                tolerance: line.tolerance,
                inputs_move_it_by: line.spread,
            })
            .collect(),
        reasons: &answer.reasons,
        models: answer
            .judged
            .iter()
            .map(|judged| Tried {
                model: judged.model.to_string(),
                counted_cost: judged.cost,
                errors_at_most: judged.errors.clone(),
                error_by_tolerance: judged.ratio,
                good_enough: judged.verdict == kane_scene::Verdict::Meets,
                verdict: verdict(&judged.verdict),
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
    let mut out = serde_json::to_string_pretty(&file).expect("strings and numbers serialise");
    out.push('\n');
    out
}
