//! Routh's diagram: an impact as a path in the plane of its impulse.

use kane_impact::Contact;
use kane_impact::oracle::{Event, integrate};

use crate::choose::{Failed, Mechanics, resolve_tip};
use crate::picture::contact_of;
use crate::scene::Scene;

/// A line of the diagram.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlaneLine {
    /// |p_t| = μ·p_n: friction at its limit.
    Cone,
    /// `v_t` + `W_tt`·p_t + `W_tn`·p_n = 0: the contact has no slip.
    Stick,
    /// −a + `W_tn`·p_t + `W_nn`·p_n = 0: the compression is greatest.
    Compression,
}

/// The impact in the plane of its impulse; points are (`p_t`, `p_n`) in N·s.
///
/// Friction drives the impulse along an edge of the cone while the contact slides; at the line of
/// sticking it turns, and where it ends is the impulse. Source of the picture: E. J. Routh's
/// process as drawn by Y. Wang and M. T. Mason (1992).
#[derive(Clone, Debug, PartialEq)]
pub struct ImpulsePlane {
    /// The corner with the least and that with the greatest coordinates.
    pub frame: [[f64; 2]; 2],
    /// Both ends of each line within the frame; the two edges of the cone are two lines.
    pub lines: Vec<(PlaneLine, [[f64; 2]; 2])>,
    /// The events of the process, from the origin to the impulse; of a law that is no process the
    /// start and the end alone.
    pub path: Vec<(Event, [f64; 2])>,
}

impl ImpulsePlane {
    /// The diagram of a tip in floats, for the model's way to resolve impacts.
    pub(crate) fn of(scene: &Scene, mechanics: Mechanics) -> Result<Self, Failed> {
        let missing = || Failed::Invalid("no single contact".to_owned());
        let contact = contact_of(scene).ok_or_else(missing)?;
        let process = match mechanics {
            Mechanics::Law(law) if law.info.is_process => Some(law.info.restitution),
            _ => None,
        };
        let followed = process.and_then(|restitution| integrate(&contact, restitution).ok());
        let path = match followed {
            Some(path) => path
                .events
                .iter()
                .map(|event| (event.event, [event.impulse.tangential, event.impulse.normal]))
                .collect(),
            None => {
                let impulse = resolve_tip(scene, &contact, mechanics)?.impulse;
                vec![(Event::Start, [0.0, 0.0]), (Event::End, [impulse.tangential, impulse.normal])]
            }
        };
        Ok(Self::around(&contact, path))
    }

    fn around(contact: &Contact<f64>, path: Vec<(Event, [f64; 2])>) -> Self {
        let most = |k: usize| path.iter().map(|(_, p)| p[k].abs()).fold(0.0, f64::max);
        let height = most(1).max(f64::MIN_POSITIVE) * 1.2;
        // as wide on both sides, so that the cone stands upright
        let width = (most(0) * 1.5).max(height / 2.0);
        let frame = [[-width, 0.0], [width, height]];
        let (w, mu) = (contact.delassus(), *contact.friction());
        let lines = [
            (PlaneLine::Cone, [0.0, 1.0, -mu]),
            (PlaneLine::Cone, [0.0, 1.0, mu]),
            (PlaneLine::Stick, [*contact.slip(), *w.tt(), *w.tn()]),
            (PlaneLine::Compression, [-*contact.approach(), *w.tn(), *w.nn()]),
        ];
        let lines =
            lines.into_iter().filter_map(|(line, of)| Some((line, within(of, &frame)?))).collect();
        Self { frame, lines, path }
    }
}

/// Where the line c + a·x + b·y = 0 enters and leaves a frame, if it does.
fn within([c, a, b]: [f64; 3], [low, high]: &[[f64; 2]; 2]) -> Option<[[f64; 2]; 2]> {
    let mut ends: Vec<[f64; 2]> = Vec::new();
    let mut reach = |point: [f64; 2]| {
        let size = [high[0] - low[0], high[1] - low[1]];
        let tiny = size.map(|size| 1e-9 * size);
        let inside = (0..2).all(|k| point[k] >= low[k] - tiny[k] && point[k] <= high[k] + tiny[k]);
        let apart = |end: &[f64; 2]| (0..2).any(|k| (end[k] - point[k]).abs() > tiny[k]);
        if inside && ends.iter().all(apart) {
            ends.push(point);
        }
    };
    for [x, y] in [*low, *high] {
        if a != 0.0 {
            reach([-(c + b * y) / a, y]);
        }
        if b != 0.0 {
            reach([x, -(c + a * x) / b]);
        }
    }
    match ends[..] {
        [from, to, ..] => Some([from, to]),
        _ => None,
    }
}
