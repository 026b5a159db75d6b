//! Routh's diagram: an impact as a path in the plane of its impulse.

use kane_impact::oracle::{Event, Path, integrate};
use kane_impact::{Contact, Law, Restitution};

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
    /// start and the end alone, and nothing where no law is looked at by itself.
    pub path: Vec<(Event, [f64; 2])>,
    /// Impulses that leave the kinetic energy as it is, around a closed curve: inside it falls.
    pub equal_energy: Vec<[f64; 2]>,
    /// Where laws end, with the ids of those that end there.
    pub ends: Vec<(Vec<&'static str>, [f64; 2])>,
}

/// Points of the curve of equal energy.
const POINTS: u32 = 180;
/// Ends so near to each other, by the size of the frame, are one.
const SAME: f64 = 1e-9;
/// Ends so many times as far as the usual ones are not in the frame.
const FAR: f64 = 3.0;

impl ImpulsePlane {
    /// The diagram of a tip in floats, for the model's way to resolve impacts.
    pub(crate) fn of(scene: &Scene, mechanics: Mechanics, laws: &[Law]) -> Result<Self, Failed> {
        let missing = || Failed::Invalid("no single contact".to_owned());
        let contact = contact_of(scene).ok_or_else(missing)?;
        let process = match mechanics {
            Mechanics::Law(law) if law.info.is_process => Some(law.info.restitution),
            _ => None,
        };
        let followed = process.and_then(|restitution| integrate(&contact, restitution).ok());
        let path = match followed {
            Some(path) => points(path),
            None => {
                let impulse = resolve_tip(scene, &contact, mechanics)?.impulse;
                vec![(Event::Start, [0.0, 0.0]), (Event::End, [impulse.tangential, impulse.normal])]
            }
        };
        // parameters that nobody stated would be invented
        let plain = laws.iter().filter(|law| law.info.parameters.is_empty());
        let end = |law: &Law| {
            let impulse = law.over::<f64>().resolve(&contact).ok()?.impulse;
            let end = [impulse.tangential, impulse.normal];
            end.iter().all(|p| p.is_finite()).then_some((law.info.id, end))
        };
        Ok(Self::around(&contact, path, plain.filter_map(end).collect()))
    }

    /// The diagram of a contact with the ends of laws, and the path of a process with such a restitution. `None`
    /// without ends.
    pub(crate) fn of_ends(
        contact: &Contact<f64>,
        process: Option<Restitution>,
        ends: Vec<(&'static str, [f64; 2])>,
    ) -> Option<Self> {
        let path = process.and_then(|restitution| integrate(contact, restitution).ok());
        (!ends.is_empty())
            .then(|| Self::around(contact, path.map(points).unwrap_or_default(), ends))
    }

    fn around(
        contact: &Contact<f64>,
        path: Vec<(Event, [f64; 2])>,
        found: Vec<(&'static str, [f64; 2])>,
    ) -> Self {
        let mut heights: Vec<f64> =
            found.iter().map(|(_, end)| end[1]).chain(path.last().map(|(_, p)| p[1])).collect();
        heights.sort_by(f64::total_cmp);
        let usual = heights.get(heights.len() / 2).copied().unwrap_or(1.0);
        let most = |k: usize| {
            let near = |p: &f64| *p <= FAR * usual * (1.0 + *contact.friction());
            let ends = found.iter().map(|(_, end)| end[k].abs()).filter(near);
            path.iter().map(|(_, p)| p[k].abs()).chain(ends).fold(0.0, f64::max)
        };
        let height = most(1).max(f64::MIN_POSITIVE) * 1.2;
        // as wide on both sides, so that the cone stands upright
        let width = (most(0) * 1.5).max(height / 2.0);
        let mut ends: Vec<(Vec<&'static str>, [f64; 2])> = Vec::new();
        for (id, end) in found {
            let same = |other: &[f64; 2]| {
                (0..2).all(|k| (other[k] - end[k]).abs() <= SAME * (width + height))
            };
            match ends.iter_mut().find(|(_, other)| same(other)) {
                Some((ids, _)) => ids.push(id),
                None => ends.push((vec![id], end)),
            }
        }
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
        Self { frame, lines, path, equal_energy: equal_energy(contact), ends }
    }
}

/// The events of a path.
fn points(path: Path<f64>) -> Vec<(Event, [f64; 2])> {
    let events = path.events.into_iter();
    events.map(|at| (at.event, [at.impulse.tangential, at.impulse.normal])).collect()
}

/// v·p + p·W·p/2 = 0 around its centre −W⁻¹·v, by a factor of Cholesky of W.
fn equal_energy(contact: &Contact<f64>) -> Vec<[f64; 2]> {
    let w = contact.delassus();
    let (tt, tn, nn) = (*w.tt(), *w.tn(), *w.nn());
    let (slip, out) = (*contact.slip(), -*contact.approach());
    let determinant = tt * nn - tn * tn;
    let centre = [(tn * out - nn * slip) / determinant, (tn * slip - tt * out) / determinant];
    // twice the energy that is there to be lost
    let size = -(slip * centre[0] + out * centre[1]);
    let (first, cross) = (tt.sqrt(), tn / tt.sqrt());
    let second = (nn - cross * cross).sqrt();
    let point = |n: u32| {
        let (sin, cos) = (std::f64::consts::TAU * f64::from(n) / f64::from(POINTS)).sin_cos();
        let y = size.sqrt() * sin / second;
        [centre[0] + (size.sqrt() * cos - cross * y) / first, centre[1] + y]
    };
    (0..=POINTS).map(point).collect()
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
