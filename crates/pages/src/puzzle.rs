//! Kane's puzzle as a map: at which friction and restitution a law creates energy.

use std::fmt::Write as _;

use kane::impact::bodies::{Collision, Direction, DoublePendulum, Motion, PlanarBody};
use kane::impact::laws;
use kane::impact::puzzle::Tip;
use kane::number::{Rational, Rounding, encode};

use crate::NotMade;

fn ratio(numerator: i32, denominator: i32) -> Rational {
    Rational::new(numerator.into(), denominator.into())
}

/// tan(q1/2) = 3/17 and tan(q2/2) = 4/15: 20.02° and 29.86°.
fn pendulum() -> DoublePendulum<Rational> {
    let direction = |tangent| Direction::of_half_tangent(&tangent);
    DoublePendulum {
        mass: ratio(1, 1),
        length: ratio(1, 1),
        angles: [direction(ratio(3, 17)), direction(ratio(4, 15))],
        before: [ratio(-1, 10), ratio(-1, 5)],
        friction: ratio(1, 2),
        restitution: ratio(7, 10),
    }
}

/// A uniform rod, half-tangent 1/2, that falls without spin and slides into its slope.
fn rod() -> Collision<Rational> {
    let before = Motion { vx: ratio(-1, 1), vy: ratio(-1, 1), omega: ratio(0, 1) };
    let direction = Direction::of_half_tangent(&ratio(1, 2));
    Collision {
        body: PlanarBody::rod_tip(ratio(1, 1), ratio(2, 1), &direction, before),
        other: None,
        friction: ratio(0, 1),
        restitution: ratio(0, 1),
    }
}

/// For every law and restitution, where friction makes energy rise; every sign is exact.
///
/// # Errors
/// [`NotMade`], which these bodies do not give.
pub fn energy_map() -> Result<String, NotMade> {
    let no_map = |why: &dyn std::fmt::Display| NotMade::because("kane-puzzle.csv", why);
    let swinging = Tip::of(&pendulum()).map_err(|error| no_map(&error))?;
    let falling = Tip::touching(rod().contact().map_err(|error| no_map(&error))?);
    let mut rows = String::from("body,law,e,mu_from,mu_to\n");
    for (body, tip) in [("double pendulum", swinging), ("rod tip", falling)] {
        for law in laws() {
            for restitution in (0..=10).map(|tenth| ratio(tenth, 10)) {
                let stretches = tip.stretches(law, &restitution).map_err(|error| no_map(&error))?;
                for gain in stretches {
                    let decimal = |x: &Rational| {
                        let float: f64 = encode(x, Rounding::NearestEven);
                        format!("{float:.4}")
                    };
                    let e = decimal(&gain.restitution);
                    let from = decimal(&gain.from);
                    let to = gain.to.as_ref().map_or_else(String::new, decimal);
                    let _ = writeln!(rows, "{body},{},{e},{from},{to}", law.info.id);
                }
            }
        }
    }
    Ok(rows)
}
