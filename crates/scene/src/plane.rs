//! Walls at any angle, at rest or in uniform motion.

use crate::coordinate::Coordinate;
use crate::round::Round;

/// A plane wall that moves as it is, without turning; SI units, y upwards.
#[derive(Clone, Debug, PartialEq)]
pub struct Plane<N> {
    /// Of length 1, out of the wall into the room.
    pub normal: [N; 2],
    /// A point of it at the start; m.
    pub through: [N; 2],
    /// Along its tangent (`n_y`, −`n_x`) and along its normal; m/s.
    pub velocity: [N; 2],
}

impl<N> Plane<N> {
    /// The same in another number system.
    pub fn map<M>(&self, mut to: impl FnMut(&N) -> M) -> Plane<M> {
        let mut pair = |[a, b]: &[N; 2]| [to(a), to(b)];
        Plane {
            normal: pair(&self.normal),
            through: pair(&self.through),
            velocity: pair(&self.velocity),
        }
    }
}

impl<N: Coordinate> Plane<N> {
    /// How far a body's surface is from the wall at a time, in metres; below 0 it is inside.
    pub(crate) fn gap(&self, body: &Round<N>, time: &N) -> N {
        let [nx, ny] = &self.normal;
        let [dx, dy] = [0, 1].map(|k| body.position[k].clone() - &self.through[k]);
        let height = dx * nx + dy * ny;
        height - self.velocity[1].clone() * time - &body.radius
    }

    /// The speed at which the gap grows, and its acceleration under gravity.
    pub(crate) fn parting(&self, body: &Round<N>, gravity: &N) -> [N; 2] {
        let [nx, ny] = &self.normal;
        let speed = body.motion.vx.clone() * nx + body.motion.vy.clone() * ny;
        [speed - &self.velocity[1], self.pull(gravity)]
    }

    /// Gravity along the normal.
    pub(crate) fn pull(&self, gravity: &N) -> N {
        -(gravity.clone() * &self.normal[1])
    }

    /// Puts a body that touches at a time where the wall is, whatever rounding says.
    pub(crate) fn touch(&self, body: &mut Round<N>, time: &N) {
        let gap = self.gap(body, time);
        for k in 0..2 {
            body.position[k] = body.position[k].clone() - gap.clone() * &self.normal[k];
        }
    }

    /// The earliest time at which a gap that is at least 0 closes, h + w·t + A·t²/2 = 0; `Err` if the number
    /// system cannot tell. `touching` says that it is closed already, and opens.
    pub(crate) fn closes(gap: &N, [speed, pull]: &[N; 2], touching: bool) -> Result<Option<N>, ()> {
        let closing = speed.sign().is_less().ok_or(())?;
        if pull.sign().is_equal() == Some(true) {
            let time = || gap.clone() / -speed.clone();
            return Ok((closing && !touching).then(time));
        }
        let falls = pull.sign().is_less().ok_or(())?;
        if touching {
            // up and back; without speed it rests, and there is no next impact
            let rises = speed.sign().is_greater().ok_or(())?;
            return Ok((falls && rises).then(|| speed.double() / -pull.clone()));
        }
        if !falls && !closing {
            return Ok(None);
        }
        let square = speed.square() - pull.double() * gap;
        if square.sign().is_less().ok_or(())? {
            return Ok(None);
        }
        let root = square.sqrt().ok_or(())?;
        Ok(Some(match closing {
            true => gap.double() / (root - speed),
            false => (root + speed) / -pull.clone(),
        }))
    }
}
