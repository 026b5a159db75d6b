//! Where in the plane of friction and restitution a law creates energy.

use kane_report::figures::{Axis, Content, Figure, Panel, Stretch};

/// Kane's body, and μ and e that are quoted as his.
const PENDULUM: &str = "double pendulum";
const KANES: [(f64, f64); 2] = [(0.5, 0.5), (0.5, 0.7)];

pub(super) fn figure(table: &str) -> Figure {
    let mut panels: Vec<Panel> = Vec::new();
    for row in super::rows(table).skip(1) {
        let [body, law, e, from, to] = row.as_slice() else {
            unreachable!("the map that is carried along has five columns");
        };
        let case = [(*body).to_owned(), (*law).to_owned()];
        let to = (!to.is_empty()).then(|| super::number(to));
        let stretch = Stretch { y: super::number(e), from: super::number(from), to };
        match panels.iter_mut().find(|panel| panel.case == case) {
            Some(panel) => panel.stretches.push(stretch),
            None => {
                let marks = if case[0] == PENDULUM { KANES.to_vec() } else { Vec::new() };
                let is_marked = kane_impact::law(law).is_some_and(|law| law.info.caveat.is_some());
                panels.push(Panel { case, stretches: vec![stretch], marks, is_marked });
            }
        }
    }
    let mut notes = vec![
        "A bar is where energy grows, at one e each; μ was searched up to 2. Signs are exact; a stretch shorter than the step of 1/25 may be missed.".to_owned(),
        "Double pendulum: two equal rods, tan(q₁/2) = 3/17, tan(q₂/2) = 4/15, q̇ = (−0.1, −0.2). Rod tip: half-tangent 1/2, v = (−1, −1), no spin.".to_owned(),
    ];
    notes.push(format!(
        "Rings: μ and e that the literature quotes as Kane's, {}.",
        KANES.map(|(mu, e)| format!("({mu}, {e})")).join(" and ")
    ));
    for law in kane_impact::laws() {
        let is_drawn = panels.iter().any(|panel| panel.case[1] == law.info.id);
        if let (true, Some(caveat)) = (is_drawn, law.info.caveat) {
            notes.push(format!("† {}: {caveat}.", law.info.id));
        }
    }
    let mut bodies: Vec<&String> = panels.iter().map(|panel| &panel.case[0]).collect();
    bodies.dedup();
    for body in bodies {
        let gains = |law: &str| panels.iter().any(|panel| panel.case == [body.as_str(), law]);
        let without: Vec<&str> =
            kane_impact::laws::law_ids().into_iter().filter(|law| !gains(law)).collect();
        notes.push(format!("No gain found, or no outcome, {body}: {}.", without.join(", ")));
    }
    Figure {
        stem: "energy-map",
        title: "Kane's puzzle: at which μ and e a law creates energy".to_owned(),
        notes,
        x: axis("mu", "μ (dimensionless)", (0.0, 2.0), &[0.0, 0.5, 1.0, 1.5, 2.0]),
        y: axis("e", "e (dimensionless)", (-0.05, 1.05), &[0.0, 0.2, 0.4, 0.6, 0.8, 1.0]),
        content: Content::Map(panels),
    }
}

fn axis(symbol: &'static str, label: &str, range: (f64, f64), ticks: &[f64]) -> Axis {
    let label = label.to_owned();
    Axis { symbol, label, range, ticks: ticks.to_vec(), is_logarithmic: false }
}
