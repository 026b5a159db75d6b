//! The states and the models as rows for spreadsheets and plotting programs.

use kane_scene::simulate::Encounter;
use kane_scene::stress::Row;
use kane_scene::{Known, Round, Shown};

use super::{SceneReport, verdict, who};
use crate::sheet::csv;

/// A row for each body of each impact that is kept, and one for each body at the end. Numbers are
/// those of the model: fractions where it is exact.
#[must_use]
pub fn states_csv(report: &SceneReport<'_>) -> String {
    let answer = report.answer;
    let mut rows = Vec::new();
    let bodies = answer.end.as_ref().map_or(1, |end| end.bodies.len());
    let state = |body: &Round<Shown>| {
        let [x, y] = &body.position;
        let m = &body.motion;
        [x, y, &m.vx, &m.vy, &m.omega].map(|number| number.text.clone())
    };
    for (index, bounce) in answer.bounces.iter().enumerate() {
        let (first, second) = match bounce.encounter {
            Encounter::Wall(i, _) => (i, i),
            Encounter::Pair(i, j) => (i, j),
        };
        let ledger = &bounce.ledger;
        let energy = [&ledger.normal, &ledger.tangential, &ledger.rotational, &bounce.gravity];
        let struck = std::iter::once((first, &bounce.after.0))
            .chain(bounce.after.1.as_ref().map(|body| (second, body)));
        for (body, after) in struck {
            let impact = [(index + 1).to_string(), bounce.time.text.clone()];
            let what = [who(bounce.encounter, bodies), bounce.regime.to_owned()];
            let mut row = [impact, what].concat();
            row.push((body + 1).to_string());
            row.extend(state(after));
            row.extend(energy.map(|number| number.text.clone()));
            rows.push(row);
        }
    }
    if let Some(end) = &answer.end {
        for (index, body) in end.bodies.iter().enumerate() {
            let mut row = ["end", &end.time.text, "", ""].map(str::to_owned).to_vec();
            row.push((index + 1).to_string());
            row.extend(state(body));
            row.extend(std::iter::repeat_n(String::new(), 4));
            rows.push(row);
        }
    }
    let names = "impact,time_s,who,regime,body,x_m,y_m,v_x_m_s,v_y_m_s,omega_rad_s,dT_normal_j,dT_tangential_j,dT_rotational_j,gravity_j";
    csv(names, rows)
}

/// A row for each model that was tried.
#[must_use]
pub fn models_csv(report: &SceneReport<'_>) -> String {
    let rows = report.answer.judged.iter().map(|judged| {
        let ratio = judged.ratio.map_or_else(String::new, |ratio| format!("{ratio:e}"));
        let how = if judged.model.mechanics.is_counted() { "counted" } else { "estimated" };
        let known = judged.ratio.and(report.answer.known).map_or("", Known::id);
        let verdict = verdict(&judged.verdict, report.answer.known);
        let cost = judged.cost.to_string();
        vec![judged.model.to_string(), cost, how.to_owned(), ratio, known.to_owned(), verdict]
    });
    csv("model,cost,cost_is,error_by_tolerance,error_is,verdict", rows)
}

/// A row for each measurement of the table of stress; errors to two digits.
#[must_use]
pub fn stress_csv(rows: &[Row]) -> String {
    let row = |row: &Row| {
        let cells = [row.case, row.pushed, &row.to, row.method].map(str::to_owned);
        [&cells[..], &[super::small(row.error)]].concat()
    };
    csv("case,pushed,to,method,error", rows.iter().map(row))
}
