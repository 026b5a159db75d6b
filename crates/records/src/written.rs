//! How far the decimals of a row may be from what they stand for, in the frame of its contact.

use crate::format::Step;
use crate::frame::Frame;
use crate::row::Row;
use crate::schema::{Side, When};
use crate::told::motion;

/// What writing a row down did to it.
pub(crate) struct Written {
    /// for each body by how much v_t, v_n and ω are off, before and after together; m/s and rad/s
    pub(crate) steps: [[f64; 3]; 2],
    /// by how much the normal is turned
    pub(crate) slack: f64,
}

impl Written {
    /// Of a row, where `columns` tells how far the numbers of each may be off. A number before an impact is taken to be written as that behind it.
    #[inline(always)]
    pub(crate) fn of(row: &Row, frame: &Frame, columns: Option<&[[Step; 6]; 2]>) -> Self {
        let steps = columns.map_or([[0.0; 3]; 2], |columns| steps(row, frame, columns));
        Self { steps, slack: frame.slack }
    }
}

#[inline(never)]
fn steps(row: &Row, frame: &Frame, columns: &[[Step; 6]; 2]) -> [[f64; 3]; 2] {
    [Side::First, Side::Second].map(|side| {
        let steps = columns[usize::from(side == Side::Second)];
        let mut off = [0.0; 6];
        for when in [When::Pre, When::Post] {
            for (place, column) in motion(side, when).into_iter().enumerate() {
                off[place] += row.get(column).map_or(0.0, |value| steps[place].of(value));
            }
        }
        let [x, y, z, spins @ ..] = off;
        let along = |off: [f64; 3], direction: [f64; 3]| -> f64 {
            off.iter().zip(direction).map(|(off, d)| off * d.abs()).sum()
        };
        [along([x, y, z], frame.tangent), along([x, y, z], frame.normal), along(spins, frame.axis)]
    })
}
