//! How far the decimals of a row may be from what they stand for, in the frame of its contact.

use crate::event::Event;
use crate::format::Step;
use crate::frame::Frame;
use crate::row::Row;
use crate::schema::{Axis, COLUMNS, Column, Side, When};
use crate::told::motion;

/// How far the numbers of each column may be from their decimals, by the places of columns.
pub(crate) type Steps = [Step; COLUMNS];

/// What writing a row down did to it.
pub(crate) struct Written {
    /// for each body by how much v_t, v_n and ω are off, before and after together; m/s and rad/s
    pub(crate) steps: [[f64; 3]; 2],
    /// by how much the normal is turned
    pub(crate) slack: f64,
    /// Σ|t_k·n_k| over the axes of the log: how much of what a velocity along the normal is off by is along the tangent
    pub(crate) lean: f64,
    /// where the axis of spin leans, for each body Σ|d_k|·(|x_k| + |x_k⁺|) over the axes of the log, of the velocity along
    /// tangent and normal and of the spin about the axis: what of the motion beside the plane is rounded into them
    pub(crate) sizes: Option<[[f64; 3]; 2]>,
}

impl Written {
    /// Of a row, where `columns` tells how far the numbers of each may be off; without it all are off by `floor`. A
    /// number before an impact is taken to be written as that behind it.
    #[inline(always)]
    pub(crate) fn of(row: &Row, frame: &Frame, columns: Option<&Steps>, floor: f64) -> Self {
        // twice, and along a direction by at most the root of three of it
        let steps = columns.map_or([[4.0 * floor; 3]; 2], |columns| steps(row, frame, columns));
        let sizes = (frame.axis != Frame::UPRIGHT.axis).then(|| sizes(row, frame));
        Self { steps, slack: frame.slack, lean: frame.lean(), sizes }
    }
}

#[inline(never)]
fn steps(row: &Row, frame: &Frame, columns: &Steps) -> [[f64; 3]; 2] {
    summed(row, frame, |after, value| columns[after.index()].of(value))
}

#[inline(never)]
fn sizes(row: &Row, frame: &Frame) -> [[f64; 3]; 2] {
    summed(row, frame, |_, value| value.abs())
}

/// Of what is told of each component of a motion, by its column behind the impact: the sum before and after, along
/// tangent and normal, and about the axis.
#[inline(always)]
fn summed(row: &Row, frame: &Frame, of: impl Fn(Column, f64) -> f64) -> [[f64; 3]; 2] {
    [Side::First, Side::Second].map(|side| {
        let mut off = [0.0; 6];
        let after = motion(side, When::Post);
        for when in [When::Pre, When::Post] {
            for (place, column) in motion(side, when).into_iter().enumerate() {
                off[place] += row.get(column).map_or(0.0, |value| of(after[place], value));
            }
        }
        let [x, y, z, spins @ ..] = off;
        [along([x, y, z], frame.tangent), along([x, y, z], frame.normal), along(spins, frame.axis)]
    })
}

fn along(off: [f64; 3], direction: [f64; 3]) -> f64 {
    off.iter().zip(direction).map(|(off, d)| off * d.abs()).sum()
}

/// What writing the settings of a row down did to them: masses, inertias and arms of both bodies, coefficients, gravity
/// and the logged impulse.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Settings {
    /// of m, by its size
    pub(crate) mass: [f64; 2],
    /// of J, by its size
    pub(crate) inertia: [f64; 2],
    /// of the arm along tangent and normal; m
    pub(crate) arm: [[f64; 2]; 2],
    /// of μ
    pub(crate) friction: f64,
    /// of e
    pub(crate) restitution: f64,
    /// of g·Δt along tangent and normal; m/s
    pub(crate) kick: [f64; 2],
    /// of the logged impulse along tangent and normal; N·s
    pub(crate) impulse: [f64; 2],
    /// of the normal
    pub(crate) normal: f64,
}

impl Settings {
    #[inline(never)]
    pub(crate) fn of(row: &Row, frame: &Frame, event: &Event<f64>, columns: &Steps) -> Self {
        let off =
            |column: Column| row.get(column).map_or(0.0, |value| columns[column.index()].of(value));
        let vector =
            |of: &dyn Fn(Axis) -> Column| [Axis::X, Axis::Y, Axis::Z].map(|axis| off(of(axis)));
        let planar = |of: &dyn Fn(Axis) -> Column| {
            let vector = vector(of);
            [along(vector, frame.tangent), along(vector, frame.normal)]
        };
        let by_size = |column: Column| match row.or_zero(column) {
            0.0 => 0.0,
            value => off(column) / value.abs(),
        };
        let sides = [Side::First, Side::Second];
        let dt = row.or_zero(Column::Dt).abs();
        let fall = planar(&Column::Gravity);
        let kick = [0, 1].map(|k: usize| dt * fall[k] + by_size(Column::Dt) * event.kick[k].abs());
        Self {
            mass: sides.map(|side| by_size(Column::Mass(side))),
            inertia: sides.map(|side| match row.stated_shape(side) {
                Some(_) => by_size(Column::Mass(side)) + 2.0 * by_size(Column::Radius(side)),
                None => by_size(Column::Inertia(side)),
            }),
            arm: sides.map(|side| match row.get(Column::Arm(side, Axis::X)) {
                Some(_) => planar(&|axis| Column::Arm(side, axis)),
                None => [0.0, off(Column::Radius(side))],
            }),
            friction: off(Column::Friction),
            restitution: off(Column::Restitution),
            kick,
            impulse: planar(&Column::Impulse),
            normal: turn(row, columns),
        }
    }
}

/// By how much a normal may be turned, and its length off, by its decimals.
pub(crate) fn turn(row: &Row, columns: &Steps) -> f64 {
    let off = |axis| {
        let column = Column::Normal(axis);
        row.get(column).map_or(0.0, |value| columns[column.index()].of(value))
    };
    off(Axis::X) + off(Axis::Y) + off(Axis::Z)
}
