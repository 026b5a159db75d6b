//! The states and the models as rows for spreadsheets and plotting programs.

use std::fmt::Write as _;

use kane_scene::stress::Row;
use kane_scene::{Known, Round, Setup, Shown};

use super::{SceneReport, body_id, ids, verdict};
use crate::stability::quoted;

/// A row for each body at the start, one for each body of each impact that is kept, and one for each at
/// the end. Numbers are
/// those of the model: fractions where it is exact.
#[must_use]
pub fn states_csv(report: &SceneReport<'_>) -> String {
    let answer = report.answer;
    let mut out = String::from(
        "impact,time_s,who,regime,body,x_m,y_m,v_x_m_s,v_y_m_s,omega_rad_s,dT_normal_j,dT_tangential_j,dT_rotational_j,gravity_j\n",
    );
    let state = |body: &Round<Shown>| {
        let [x, y] = &body.position;
        let m = &body.motion;
        [x, y, &m.vx, &m.vy, &m.omega].map(|number| number.text.clone()).join(",")
    };
    if let Setup::Bodies(world) = &answer.stated {
        for (index, body) in world.bodies.iter().enumerate() {
            let _ = writeln!(out, "start,0,,,{},{},,,,", body_id(index), state(body));
        }
    }
    for (index, bounce) in answer.bounces.iter().enumerate() {
        let who = ids(bounce.encounter).join(" ");
        let energy = [
            &bounce.ledger.normal,
            &bounce.ledger.tangential,
            &bounce.ledger.rotational,
            &bounce.gravity,
        ];
        let energy = energy.map(|number| number.text.clone()).join(",");
        let struck = std::iter::once(&bounce.after.0).chain(&bounce.after.1);
        for (body, after) in bounce.bodies().zip(struck) {
            let _ = writeln!(
                out,
                "{},{},{who},{},{},{},{energy}",
                index + 1,
                bounce.time.text,
                quoted(bounce.regime),
                body_id(body),
                state(after)
            );
        }
    }
    if let Some(end) = &answer.end {
        for (index, body) in end.bodies.iter().enumerate() {
            let _ = writeln!(out, "end,{},,,{},{},,,,", end.time.text, body_id(index), state(body));
        }
    }
    out
}

/// A row for each model that was tried.
#[must_use]
pub fn models_csv(report: &SceneReport<'_>) -> String {
    let mut out = String::from("model,cost,cost_is,error_by_tolerance,error_is,verdict\n");
    for judged in &report.answer.judged {
        let ratio = judged.ratio.map_or_else(String::new, |ratio| format!("{ratio:e}"));
        let verdict = quoted(&verdict(&judged.verdict, report.answer.known));
        let how = if judged.model.mechanics.is_counted() { "counted" } else { "estimated" };
        let known = judged.ratio.and(report.answer.known).map_or("", Known::id);
        let _ = writeln!(out, "{},{},{how},{ratio},{known},{verdict}", judged.model, judged.cost);
    }
    out
}

/// A row for each measurement of the table of stress; errors to two digits.
#[must_use]
pub fn stress_csv(rows: &[Row]) -> String {
    let mut out = String::from("case,pushed,to,method,error\n");
    for row in rows {
        let error = if row.error == 0.0 { "0".to_owned() } else { super::small(row.error) };
        let cells = [row.case, row.pushed, &row.to, row.method].map(quoted);
        let _ = writeln!(out, "{},{error}", cells.join(","));
    }
    out
}
