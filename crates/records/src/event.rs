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
    /// What a row states.
    ///
    /// # Errors
    /// [`Reason`] for a value outside its domain.
    #[inline]
    pub fn of(row: &Row) -> Result<Self, Reason> {
        let not_negative = |column| match row.get(column) {
            Some(value) if value < 0.0 => Err(Reason::Negative(column, value)),
            other => Ok(other),
        };
        let restitution = row.get(Column::Restitution);
        if let Some(e) = restitution.filter(|e| !(0.0..=1.0).contains(e)) {
            return Err(Reason::Restitution(e));
        }
        Ok(Self {
            friction: not_negative(Column::Friction)?,
            restitution,
            dt: not_negative(Column::Dt)?,
            phase: not_negative(Column::Phase)?,
            time: row.get(Column::Time),
        })
    }
}

impl<N: FromFloat> Event<N> {
    /// The impact of a row, as seen in a frame. Exact in exact numbers.
    ///
    /// # Errors
    /// [`Reason`] for the first cell that is missing or outside its domain.
    #[inline]
    pub fn of(row: &Row, frame: &Frame) -> Result<Self, Reason> {
        let first = Moving::of(row, Side::First, frame)?;
        let second =
            if row.has_second() { Some(Moving::of(row, Side::Second, frame)?) } else { None };
        let triple =
            |of: fn(Axis) -> Column| [Axis::X, Axis::Y, Axis::Z].map(|axis| row.or_zero(of(axis)));
        let kick = match row.get(Column::Dt) {
            Some(dt)
                if row.get(Column::Gravity(Axis::X)).is_some()
                    || row.get(Column::Gravity(Axis::Y)).is_some() =>
            {
                let dt = N::of_float(dt);
                planar(triple(Column::Gravity), frame).map(|g: N| g * &dt)
            }
            _ => [N::zero(), N::zero()],
        };
        let logged = row.get(Column::Impulse(Axis::X)).is_some()
            && row.get(Column::Impulse(Axis::Y)).is_some();
        let stated = logged.then(|| planar(triple(Column::Impulse), frame));
        Ok(Self { first, second, kick, stated })
    }
}

impl<N: FromFloat> Moving<N> {
    #[inline]
    fn of(row: &Row, side: Side, frame: &Frame) -> Result<Self, Reason> {
        let positive = |column| match row.need(column)? {
            value if value > 0.0 => Ok(N::of_float(value)),
            value => Err(Reason::NotPositive(column, value)),
        };
        let mass = positive(Column::Mass(side))?;
        let inertia = match row.get(Column::Inertia(side)) {
            Some(_) => positive(Column::Inertia(side))?,
            None => {
                let radius = positive(Column::Radius(side))?;
                let shape = row.shapes[usize::from(side == Side::Second)];
                let shape = shape.ok_or(Reason::Missing(Column::Inertia(side)))?;
                radius.square() * &mass * gyration::<N>(shape)
            }
        };
        let arm = match row.get(Column::Arm(side, Axis::X)) {
            Some(_) => {
                row.need(Column::Arm(side, Axis::Y))?;
                planar(vector(row, |axis| Column::Arm(side, axis)), frame)
            }
            None => {
                let radius = positive(Column::Radius(side))?;
                [N::zero(), if side == Side::First { -radius } else { radius }]
            }
        };
        match side {
            Side::First => row.need_all(
                &const { motion(Side::First) },
                const { Row::mask(&motion(Side::First)) },
            )?,
            Side::Second => row.need_all(
                &const { motion(Side::Second) },
                const { Row::mask(&motion(Side::Second)) },
            )?,
        }
        let motion = |when| -> [N; 3] {
            let velocity = vector(row, |axis| Column::Velocity(side, axis, when));
            let [t, n] = planar(velocity, frame);
            let spin = vector(row, |axis| Column::Spin(side, axis, when));
            [t, n, along(spin, frame.axis)]
        };
        Ok(Self { mass, inertia, arm, before: motion(When::Pre), after: motion(When::Post) })
    }
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

/// J/(m·r²) of a shape.
fn gyration<N: FromFloat>(shape: Shape) -> N {
    N::from_rational(&shape.gyration())
}

fn vector(row: &Row, of: impl Fn(Axis) -> Column) -> [f64; 3] {
    [Axis::X, Axis::Y, Axis::Z].map(|axis| row.or_zero(of(axis)))
}

/// Along tangent and normal.
fn planar<N: FromFloat>(vector: [f64; 3], frame: &Frame) -> [N; 2] {
    if frame.upright {
        return [N::of_float(vector[0]), N::of_float(vector[1])];
    }
    [along(vector, frame.tangent), along(vector, frame.normal)]
}

fn along<N: FromFloat>(vector: [f64; 3], direction: [f64; 3]) -> N {
    if direction == Frame::UPRIGHT.axis {
        return N::of_float(vector[2]);
    }
    let [a, b, c] = vector.map(N::of_float);
    let [x, y, z] = direction.map(N::of_float);
    a * &x + b * &y + c * &z
}
