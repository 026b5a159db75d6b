//! The frame of a contact: tangent, normal, and the axis of spin.

use crate::rejection::Reason;
use crate::row::Row;
use crate::schema::{Axis, Column, Side, When};

/// By how much a normal's length may differ from one: a normal that was formed in binary32 and
/// normalised by one square root and one division has an error below 3·2^−24 < 2·10^−7.
const LENGTH: f64 = 1e-6;

/// By how much a quantity may leave the plane, by its own scale: 2^−24 times the 64 roundings of
/// [`tolerance`](crate::tolerance), rounded up.
const PLANE: f64 = 1e-5;

/// The directions of a contact, as the log has them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// along the surface
    pub tangent: [f64; 3],
    /// out of the second body into the first
    pub normal: [f64; 3],
    /// about which a spin counts from tangent to normal
    pub axis: [f64; 3],
    /// by how much the normal may be turned: what its length is off by, its direction is off by,
    /// too, within a factor of two
    pub slack: f64,
    /// whether tangent and normal are x and y
    pub upright: bool,
}

impl Frame {
    /// The frame of a contact whose normal is y.
    pub const UPRIGHT: Self = Self {
        tangent: [1.0, 0.0, 0.0],
        normal: [0.0, 1.0, 0.0],
        axis: [0.0, 0.0, 1.0],
        slack: 0.0,
        upright: true,
    };

    /// The frame of a row. In space the tangent is that of the longest of the slips before and after and the change
    /// of velocity along the surface, and whatever would leave the plane is refused. `printed` is by how much the normal
    /// may be off by its decimals.
    ///
    /// # Errors
    /// [`Reason::Normal`], [`Reason::Missing`] or [`Reason::OutOfPlane`].
    #[inline]
    pub fn of(row: &Row, spatial: bool, printed: f64) -> Result<Self, Reason> {
        let (normal, slack) = normal(row, printed)?;
        if !spatial && normal == Self::UPRIGHT.normal {
            return Ok(Self { slack, ..Self::UPRIGHT });
        }
        if !spatial {
            let [x, y, _] = normal;
            return Ok(Self {
                tangent: [y, -x, 0.0],
                normal,
                axis: [0.0, 0.0, 1.0],
                slack,
                upright: false,
            });
        }
        spatial_frame(row, normal, slack)
    }
}

impl Frame {
    /// Σ|t_k·n_k|, 0 where tangent and normal are axes of the log and 1 at most.
    #[inline]
    pub(crate) fn lean(&self) -> f64 {
        if self.upright {
            return 0.0;
        }
        let ([a, b, c], [x, y, z]) = (self.tangent, self.normal);
        (a * x).abs() + (b * y).abs() + (c * z).abs()
    }
}

/// The normal, and its slack.
fn normal(row: &Row, printed: f64) -> Result<([f64; 3], f64), Reason> {
    let given = [Axis::X, Axis::Y, Axis::Z].map(|axis| row.get(Column::Normal(axis)));
    if given.iter().all(Option::is_none) {
        return Ok((Frame::UPRIGHT.normal, 0.0));
    }
    let normal = given.map(|component| component.unwrap_or(0.0));
    let length = norm(normal);
    let off = (length - 1.0).abs();
    if off > LENGTH + printed {
        Err(Reason::Normal(length))
    } else {
        Ok((normal, 2.0 * (off + printed)))
    }
}

/// A body of a row in space.
struct Body {
    arm: [f64; 3],
    velocity: [[f64; 3]; 2],
    spin: [[f64; 3]; 2],
}

impl Body {
    fn of(row: &Row, side: Side, normal: [f64; 3]) -> Result<Self, Reason> {
        let axes = [Axis::X, Axis::Y, Axis::Z];
        let vector = |of: &dyn Fn(Axis) -> Column| -> Result<[f64; 3], Reason> {
            Ok([row.need(of(axes[0]))?, row.need(of(axes[1]))?, row.need(of(axes[2]))?])
        };
        let arm = match row.get(Column::Arm(side, Axis::X)) {
            Some(_) => vector(&|axis| Column::Arm(side, axis))?,
            None => {
                let radius = row.need(Column::Radius(side))?;
                let sign = if side == Side::First { -radius } else { radius };
                normal.map(|component| sign * component)
            }
        };
        let both = |of: &dyn Fn(Axis, When) -> Column| -> Result<[[f64; 3]; 2], Reason> {
            Ok([vector(&|axis| of(axis, When::Pre))?, vector(&|axis| of(axis, When::Post))?])
        };
        Ok(Self {
            arm,
            velocity: both(&|axis, when| Column::Velocity(side, axis, when))?,
            spin: both(&|axis, when| Column::Spin(side, axis, when))?,
        })
    }

    fn at_contact(&self, time: usize) -> [f64; 3] {
        plus(self.velocity[time], cross(self.spin[time], self.arm), 1.0)
    }
}

fn spatial_frame(row: &Row, normal: [f64; 3], slack: f64) -> Result<Frame, Reason> {
    let first = Body::of(row, Side::First, normal)?;
    let second = row.has_second().then(|| Body::of(row, Side::Second, normal)).transpose()?;
    let slip = |time: usize| {
        let mut velocity = first.at_contact(time);
        if let Some(second) = &second {
            velocity = plus(velocity, second.at_contact(time), -1.0);
        }
        plus(velocity, normal, -dot(velocity, normal))
    };
    let speed = norm(first.velocity[0]).max(norm(first.velocity[1])).max(
        second
            .as_ref()
            .map_or(0.0, |second| norm(second.velocity[0]).max(norm(second.velocity[1]))),
    );
    let (before, after) = (slip(0), slip(1));
    let change = plus(first.velocity[1], first.velocity[0], -1.0);
    let change = plus(change, normal, -dot(change, normal));
    // rounding turns the longest least, and what is in its plane is in that of the others
    let longer = |a: [f64; 3], b: [f64; 3]| if norm(b) > norm(a) { b } else { a };
    let longest = longer(longer(before, after), change);
    // without slip and friction any tangent does; take the one that is nearest to x or z
    let tangent = if norm(longest) > PLANE * speed {
        let along = unit(longest);
        if dot(along, before) < 0.0 { along.map(|component| -component) } else { along }
    } else {
        let seed = if normal[0].abs() < 0.9 { [1.0, 0.0, 0.0] } else { [0.0, 0.0, 1.0] };
        unit(plus(seed, normal, -dot(seed, normal)))
    };
    let axis = cross(tangent, normal);
    let out = |vector: [f64; 3], scale: f64| dot(vector, axis).abs() > PLANE * scale;
    if out(before, speed) || out(after, speed) {
        return Err(Reason::OutOfPlane("the slip turns"));
    }
    for body in std::iter::once(&first).chain(&second) {
        let arm = norm(body.arm);
        if out(body.arm, arm) {
            return Err(Reason::OutOfPlane("the contact point is beside the plane of the slip"));
        }
        if out(plus(body.velocity[1], body.velocity[0], -1.0), speed) {
            return Err(Reason::OutOfPlane("friction is not along the slip"));
        }
        let change = plus(body.spin[1], body.spin[0], -1.0);
        let beside = plus(change, axis, -dot(change, axis));
        let rim = norm(body.spin[0]).max(norm(body.spin[1])) * arm;
        if norm(beside) * arm > PLANE * rim.max(speed) {
            return Err(Reason::OutOfPlane("the spin changes about another axis"));
        }
    }
    Ok(Frame { tangent, normal, axis, slack, upright: false })
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn plus(a: [f64; 3], b: [f64; 3], factor: f64) -> [f64; 3] {
    [a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]]
}

fn norm(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

fn unit(a: [f64; 3]) -> [f64; 3] {
    let length = norm(a);
    a.map(|component| component / length)
}
