//! An impact in the frame of its contact, in any number system.

use kane_impact::bodies::Shape;
use kane_number::{Number, Rational, decode};

use crate::frame::Frame;
use crate::rejection::Reason;
use crate::row::Row;
use crate::schema::{Axis, Column, Side, When};

/// A number system into which the floats of a log go without loss.
pub trait FromFloat: Number {
    /// The same number. A float that is not finite never comes here: rows with one are rejected.
    fn of_float(float: f64) -> Self;
}

impl FromFloat for f64 {
    fn of_float(float: f64) -> Self {
        float
    }
}

impl FromFloat for Rational {
    fn of_float(float: f64) -> Self {
        decode(float).unwrap_or_else(|_| <Self as Number>::zero())
    }
}

/// A body, along tangent and normal; SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct Moving<N> {
    /// m; kg
    pub mass: N,
    /// J; kg·m²
    pub inertia: N,
    /// from the centre of mass to the contact point; m
    pub arm: [N; 2],
    /// v_t, v_n, ω before
    pub before: [N; 3],
    /// v_t, v_n, ω after
    pub after: [N; 3],
}

/// An impact.
#[derive(Clone, Debug, PartialEq)]
pub struct Event<N> {
    /// the body into which the normal points
    pub first: Moving<N>,
    /// the other, if it is not fixed
    pub second: Option<Moving<N>>,
    /// what gravity adds to velocities within the step, along tangent and normal; m/s
    pub kick: [N; 2],
    /// the impulse that the log states
    pub stated: Option<[N; 2]>,
}

/// What is stated of an impact beside the motion.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Given {
    /// μ
    pub friction: Option<f64>,
    /// e
    pub restitution: Option<f64>,
    /// the time step; s
    pub dt: Option<f64>,
    /// the phase within the step
    pub phase: Option<f64>,
    /// when; s
    pub time: Option<f64>,
}

impl Given {
    /// That what a row states is in its domain.
    ///
    /// # Errors
    /// [`Reason`] for the first value that is not.
    #[inline]
    pub fn check(row: &Row) -> Result<(), Reason> {
        for column in [Column::Friction, Column::Dt, Column::Phase] {
            let value = row.or_zero(column);
            if value < 0.0 {
                return Err(Reason::Negative(column, value));
            }
        }
        let e = row.or_zero(Column::Restitution);
        if (0.0..=1.0).contains(&e) { Ok(()) } else { Err(Reason::Restitution(e)) }
    }

    /// What a row states.
    #[must_use]
    #[inline]
    pub fn of(row: &Row) -> Self {
        Self {
            friction: row.get(Column::Friction),
            restitution: row.get(Column::Restitution),
            dt: row.get(Column::Dt),
            phase: row.get(Column::Phase),
            time: row.get(Column::Time),
        }
    }
}

impl Event<f64> {
    /// That a row has all that an impact needs, and in its domain.
    ///
    /// # Errors
    /// [`Reason`] for the first cell that is missing or outside its domain.
    #[inline]
    pub fn check(row: &Row) -> Result<(), Reason> {
        check_body(row, Side::First)?;
        let moving =
            const { Row::mask(&motion(Side::Second)) | Row::mask(&motion_in_space(Side::Second)) };
        if row.has_second() {
            check_body(row, Side::Second)
        } else if row.any_is_not_zero(moving) {
            // without a mass it would be an obstacle at rest
            Err(Reason::Missing(Column::Mass(Side::Second)))
        } else {
            Ok(())
        }
    }
}

impl<N: FromFloat> Event<N> {
    /// The impact of a row that was [checked](Event::check), as seen in a frame. Exact in exact numbers.
    #[must_use]
    #[inline(always)]
    pub fn of(row: &Row, frame: &Frame) -> Self {
        let kick = match row.get(Column::Dt) {
            Some(dt)
                if row.get(Column::Gravity(Axis::X)).is_some()
                    || row.get(Column::Gravity(Axis::Y)).is_some() =>
            {
                let dt = N::of_float(dt);
                planar(vector(row, Column::Gravity), frame).map(|g: N| g * &dt)
            }
            _ => [N::zero(), N::zero()],
        };
        let logged = row.get(Column::Impulse(Axis::X)).is_some()
            && row.get(Column::Impulse(Axis::Y)).is_some();
        Self {
            first: Moving::of(row, Side::First, frame),
            second: row.has_second().then(|| Moving::of(row, Side::Second, frame)),
            kick,
            stated: logged.then(|| planar(vector(row, Column::Impulse), frame)),
        }
    }
}

/// The least mass, inertia or radius by which what comes of a motion is divided without leaving the floats.
const LEAST: f64 = 1e-100;

/// That a body has a mass, an inertia, a place of the contact and a motion.
#[inline]
fn check_body(row: &Row, side: Side) -> Result<(), Reason> {
    let positive = |column| match row.need(column)? {
        value if value >= LEAST => Ok(()),
        value if value > 0.0 => Err(Reason::Extreme(column, value)),
        value => Err(Reason::NotPositive(column, value)),
    };
    positive(Column::Mass(side))?;
    if row.get(Column::Inertia(side)).is_some() {
        positive(Column::Inertia(side))?;
    } else {
        positive(Column::Radius(side))?;
        row.stated_shape(side).ok_or(Reason::Missing(Column::Inertia(side)))?;
    }
    if row.get(Column::Arm(side, Axis::X)).is_some() {
        row.need(Column::Arm(side, Axis::Y))?;
    } else {
        positive(Column::Radius(side))?;
    }
    match side {
        Side::First => {
            row.need_all(&const { motion(Side::First) }, const { Row::mask(&motion(Side::First)) })
        }
        Side::Second => row
            .need_all(&const { motion(Side::Second) }, const { Row::mask(&motion(Side::Second)) }),
    }
}

impl<N: FromFloat> Moving<N> {
    #[inline(always)]
    fn of(row: &Row, side: Side, frame: &Frame) -> Self {
        let float = |column| N::of_float(row.or_zero(column));
        let mass = float(Column::Mass(side));
        let inertia = match row.stated_shape(side) {
            Some(shape) => float(Column::Radius(side)).square() * &mass * gyration::<N>(shape),
            None => float(Column::Inertia(side)),
        };
        let arm = if row.get(Column::Arm(side, Axis::X)).is_some() {
            planar(vector(row, |axis| Column::Arm(side, axis)), frame)
        } else {
            let radius = float(Column::Radius(side));
            [N::zero(), if side == Side::First { -radius } else { radius }]
        };
        let [before, after] =
            [moves(row, side, When::Pre, frame), moves(row, side, When::Post, frame)];
        Self { mass, inertia, arm, before, after }
    }
}

/// v_t, v_n, ω of a body.
#[inline(always)]
fn moves<N: FromFloat>(row: &Row, side: Side, when: When, frame: &Frame) -> [N; 3] {
    let [t, n] = planar(vector(row, |axis| Column::Velocity(side, axis, when)), frame);
    let spin = vector(row, |axis| Column::Spin(side, axis, when));
    [t, n, along(spin, frame.axis)]
}

/// The columns of a body's motion that every row needs.
const fn motion(side: Side) -> [Column; 6] {
    [
        Column::Velocity(side, Axis::X, When::Pre),
        Column::Velocity(side, Axis::Y, When::Pre),
        Column::Spin(side, Axis::Z, When::Pre),
        Column::Velocity(side, Axis::X, When::Post),
        Column::Velocity(side, Axis::Y, When::Post),
        Column::Spin(side, Axis::Z, When::Post),
    ]
}

/// The columns of a body's motion that a row in space has besides.
const fn motion_in_space(side: Side) -> [Column; 6] {
    [
        Column::Velocity(side, Axis::Z, When::Pre),
        Column::Spin(side, Axis::X, When::Pre),
        Column::Spin(side, Axis::Y, When::Pre),
        Column::Velocity(side, Axis::Z, When::Post),
        Column::Spin(side, Axis::X, When::Post),
        Column::Spin(side, Axis::Y, When::Post),
    ]
}

/// J/(m·r²) of a shape.
fn gyration<N: FromFloat>(shape: Shape) -> N {
    N::from_rational(&shape.gyration())
}

#[inline(always)]
fn vector(row: &Row, of: impl Fn(Axis) -> Column) -> [f64; 3] {
    [row.or_zero(of(Axis::X)), row.or_zero(of(Axis::Y)), row.or_zero(of(Axis::Z))]
}

/// Along tangent and normal.
#[inline(always)]
fn planar<N: FromFloat>(vector: [f64; 3], frame: &Frame) -> [N; 2] {
    if frame.upright {
        return [N::of_float(vector[0]), N::of_float(vector[1])];
    }
    [along(vector, frame.tangent), along(vector, frame.normal)]
}

#[inline(always)]
fn along<N: FromFloat>(vector: [f64; 3], direction: [f64; 3]) -> N {
    if direction == Frame::UPRIGHT.axis {
        return N::of_float(vector[2]);
    }
    let [a, b, c] = vector.map(N::of_float);
    let [x, y, z] = direction.map(N::of_float);
    a * &x + b * &y + c * &z
}
