//! The states and the models as rows for spreadsheets and plotting programs.

use kane_scene::stress::Row;
use kane_scene::{Known, Round, Setup, Shown};

use super::{SceneReport, body_id, ids, verdict};
use crate::sheet::csv;

/// A row for each body at the start, one for each body of each impact that is kept, and one for each at
/// the end. Numbers are
/// those of the model: fractions where it is exact.
#[must_use]
pub fn states_csv(report: &SceneReport<'_>) -> String {
    let answer = report.answer;
    let in_air = answer.bounces.iter().any(|bounce| bounce.air.is_some());
    let in_space = matches!(&answer.stated, Setup::Bodies(world) if world.is_in_space());
    let turns = answer.bounces.iter().any(|bounce| bounce.corner.is_some());
    let mut rows = Vec::new();
    let state = |body: &Round<Shown>| {
        let [x, y] = &body.position;
        let m = &body.motion;
        let off_plane = body.off_plane.iter();
        let off_plane = off_plane.flat_map(|off| [&off.z, &off.vz, &off.omega_x, &off.omega_y]);
        let numbers = [x, y, &m.vx, &m.vy, &m.omega].into_iter().chain(off_plane);
        numbers.map(|number| number.text.clone()).collect::<Vec<_>>()
    };
    let unmoved = |when: &str, time: &str, index: usize, state: Vec<String>| {
        let mut row = [when, time, "", ""].map(str::to_owned).to_vec();
        row.push(body_id(index));
        row.extend(state);
        let more = usize::from(in_air) + 2 * usize::from(turns);
        row.extend(std::iter::repeat_n(String::new(), 4 + more));
        row
    };
    if let Setup::Bodies(world) = &answer.stated {
        for (index, body) in world.bodies.iter().enumerate() {
            rows.push(unmoved("start", "0", index, state(body)));
        }
    }
    for (index, bounce) in answer.bounces.iter().enumerate() {
        let ledger = &bounce.ledger;
        let energy = [&ledger.normal, &ledger.tangential, &ledger.rotational, &bounce.gravity];
        let struck = std::iter::once(&bounce.after.0).chain(&bounce.after.1);
        for (body, after) in bounce.bodies().zip(struck) {
            let impact = [(index + 1).to_string(), bounce.time.text.clone()];
            let what = [ids(bounce.encounter).join(" "), bounce.regime.to_owned(), body_id(body)];
            let mut row = [&impact[..], &what].concat();
            row.extend(state(after));
            row.extend(energy.into_iter().chain(&bounce.air).map(|number| number.text.clone()));
            if let Some((corner, angle)) = &bounce.corner {
                row.extend([(corner + 1).to_string(), angle.text.clone()]);
            }
            rows.push(row);
        }
    }
    if let Some(end) = &answer.end {
        for (index, body) in end.bodies.iter().enumerate() {
            rows.push(unmoved("end", &end.time.text, index, state(body)));
        }
    }
    let names = "impact,time_s,who,regime,body,x_m,y_m,v_x_m_s,v_y_m_s,omega_rad_s";
    let of_space = if in_space { ",z_m,v_z_m_s,omega_x_rad_s,omega_y_rad_s" } else { "" };
    let of_energy = ",dT_normal_j,dT_tangential_j,dT_rotational_j,gravity_j";
    let of_air = if in_air { ",air_j" } else { "" };
    let of_corners = if turns { ",corner,turned_rad" } else { "" };
    csv(&[names, of_space, of_energy, of_air, of_corners].concat(), rows)
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
