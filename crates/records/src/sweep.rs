//! A sweep of impacts that tells laws apart.

use std::fmt::Write as _;

/// A row of the sweep.
#[derive(Clone, Debug, PartialEq)]
pub struct Planned {
    /// its name
    pub id: String,
    /// the body: "disc" or "rod"
    pub body: &'static str,
    /// J; kg·m², of a body of 1 kg
    pub inertia: f64,
    /// the arm; m
    pub arm: [f64; 2],
    /// v_x, v_y, ω before
    pub motion: [f64; 3],
    /// μ
    pub friction: f64,
    /// e
    pub restitution: f64,
    /// the fraction of a step before contact
    pub phase: f64,
}

/// α of the sweep of discs: from grazing to nearly normal, thicker where laws part.
const ALPHAS: [f64; 13] = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.75, 1.0, 1.5, 2.0, 3.0, 5.0, 10.0];
const RESTITUTIONS: [f64; 3] = [0.0, 0.5, 1.0];
const PHASES: [f64; 3] = [0.05, 0.45, 0.85];
/// Approach speeds of the discs; engines tend to ignore restitution below about one.
const SPEEDS: [f64; 3] = [0.25, 1.0, 4.0];
/// The cosine and the sine of the angle of a rod with the surface, as Pythagorean triples.
const RODS: [(f64, f64); 4] = [
    (3.0 / 5.0, 4.0 / 5.0),
    (4.0 / 5.0, 3.0 / 5.0),
    (12.0 / 13.0, 5.0 / 13.0),
    (-3.0 / 5.0, 4.0 / 5.0),
];
const SLIPS: [f64; 4] = [-2.0, -0.25, 0.25, 2.0];

/// The sweep.
///
/// Discs of radius 1 m with α from 0.1 to 10, three e, three phases, and three approach speeds: k over
/// α tells laws of friction apart, a varying e tells μ·p_n from μ·p_n/(1 + e), and the phases and speeds
/// show on what e depends. Rods of length 2 m that hit with a tip couple normal and tangent, which
/// alone tells Newton's, Poisson's and the energetic hypothesis, and Kane–Levinson from Routh.
#[must_use]
pub fn sweep() -> Vec<Planned> {
    let mut rows = Vec::new();
    for (e, phase) in crossed(&RESTITUTIONS, &PHASES) {
        for (alpha, speed) in crossed(&ALPHAS, &SPEEDS) {
            let friction = 0.3;
            // α = 3·μ·(1 + e)·a/(2·v), j_p = 3 for a disc
            let vx = 1.5 * friction * (1.0 + e) * speed / alpha;
            rows.push(Planned {
                id: format!("disc-{}", rows.len() + 1),
                body: "disc",
                inertia: 0.5,
                arm: [0.0, -1.0],
                motion: [vx, -speed, 0.0],
                friction,
                restitution: e,
                phase,
            });
        }
    }
    for ((cos, sin), friction) in RODS.into_iter().flat_map(|rod| [0.2, 0.8].map(|mu| (rod, mu))) {
        for (slip, e) in crossed(&SLIPS, &RESTITUTIONS) {
            rows.push(Planned {
                id: format!("rod-{}", rows.len() + 1),
                body: "rod",
                inertia: 1.0 / 3.0,
                arm: [-cos, -sin],
                motion: [slip, -1.0, 0.0],
                friction,
                restitution: e,
                phase: 0.45,
            });
        }
    }
    rows
}

fn crossed(a: &'static [f64], b: &'static [f64]) -> impl Iterator<Item = (f64, f64)> {
    a.iter().flat_map(move |a| b.iter().map(move |b| (*a, *b)))
}

/// The sweep as a table for an engine, with empty columns for what it finds.
#[must_use]
pub fn csv() -> String {
    let mut out = String::from(
        "# Run every row in your engine: a body of 1 kg without gravity hits a fixed plane whose normal is +y, fill in\n\
         # the last three columns and dt_s, and give the table to kane check. A disc has radius 1 m; a rod is 2 m long\n\
         # and hits with the end at arm1 from its centre.\n\
         id,body_kind,mass1_kg,inertia1_kg_m2,arm1_x_m,arm1_y_m,mu,e,phase,dt_s,\
         vx1_pre_m_s,vy1_pre_m_s,omega1_pre_rad_s,vx1_post_m_s,vy1_post_m_s,omega1_post_rad_s\n",
    );
    for row in sweep() {
        let Planned { id, body, inertia, arm: [x, y], motion: [vx, vy, spin], .. } = &row;
        let _ = writeln!(
            out,
            "{id},{body},1,{inertia},{x},{y},{},{},{},,{vx},{vy},{spin},,,",
            row.friction, row.restitution, row.phase
        );
    }
    out
}
