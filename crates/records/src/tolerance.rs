//! How far what is written down may be from what mechanics asks, derived from how it was written.
//!
//! Three things stand between an impact that obeys a law and its row in a log.
//!
//! **Rounding.** Let u be half a unit in the last place of what was [computed with](Format::unit). A solver forms a
//! velocity by additions and products of terms no greater than |v| + |v⁺|; with n roundings it is off
//! by at most n·u/(1 − n·u) times that (Higham's γ_n). [`ROUNDINGS`] = 64 stands for ten sweeps
//! over a contact of six operations each, and the rounding of the result when it is written down.
//! Hence η = 64·u. That is so along each axis of the log; where tangent and normal lean against these, an error of
//! v_n is one of v_t by Σ|t_k·n_k| of it, and the other way round. In this program's own arithmetic a fact is a sum of at most twelve products, off by
//! at most 16·2^−53 of their magnitudes: a quarter of η at most, as u ≥ 2^−53. So a residual that
//! is computed in floats decides unless it is within a quarter of its tolerance, and there the
//! residual is computed exactly.
//!
//! **Writing.** A number that was rounded to decimals is off by half of its [last one](Format::step) besides, each
//! column by its own. Along a tangent that leans, that of v is q_t = |t_x|·q_x + |t_y|·q_y + |t_z|·q_z.
//!
//! **Positions.** The arm and the normal are not the body's own: they are formed from positions in
//! a world that is larger than a body. With coordinates up to E arms, two roundings of positions and
//! one of their difference move the contact point by up to 3·u·E arms, and turn the normal by as much:
//! τ = 3·u·E. [`EXTENT`] = 1000, a floor of a thousand radii, is what is taken unless it is said.
//!
//! **Time step.** An engine looks at the contact once a step. By then the surfaces have moved by up
//! to Δt times their velocity at the contact: the arm is uncertain by δ = Δt·a along the normal, a
//! the approach speed, where both bodies are round (their contact stays under the centre), and by
//! Δt·(|u_t| + a) in every direction where they are not. Gravity adds g·Δt within the step, and
//! whether before or after the impact is the engine's; that is taken off, and the choice is left open.
//!
//! Terms of second order in these are left out; each tolerance is a sum of first-order terms, all
//! taken by their magnitudes.

use crate::event::{Event, Given, Moving};
use crate::facts::Facts;
use crate::format::{Format, Printed, Step};
use crate::schema::{COLUMNS, Side, When};
use crate::told::{Told, motion, settings};
use crate::written::{Settings, Steps, Written};

/// Roundings between an impact and its row.
pub const ROUNDINGS: f64 = 64.0;

/// How large the world is, in arms.
pub const EXTENT: f64 = 1000.0;

/// What every row of a log shares.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Precision {
    /// the formats of the numbers
    pub told: Told,
    /// how large the world is, in arms
    pub extent: f64,
    /// η = 64·u
    pub rounding: f64,
    /// how far the numbers of a column may be from their decimals; without it by no more than `floor`
    pub(crate) steps: Option<Steps>,
    /// half of the last decimal of binary floats, which were printed with no more
    pub(crate) floor: f64,
    /// whether settings were rounded, too
    pub(crate) settings: bool,
    /// τ = 3·u·E
    pub tilt: f64,
}

impl Precision {
    /// Of what is told of the numbers, in a world of `extent` arms.
    #[must_use]
    pub fn told(told: Told, extent: f64) -> Self {
        let unit = told.unit();
        let all = told.printed().step();
        let has_own = told.own.iter().any(Option::is_some);
        let mut steps = [Step::default(); COLUMNS];
        for side in [Side::First, Side::Second] {
            for column in motion(side, When::Post) {
                steps[column.index()] = told.of_column(column).step();
            }
        }
        for column in settings() {
            steps[column.index()] = told.own[column.index()].map(Printed::step).unwrap_or_default();
        }
        let binary = matches!(told.format, Format::Binary32 | Format::Binary64);
        Self {
            told,
            extent,
            rounding: ROUNDINGS * unit,
            settings: settings().any(|column| steps[column.index()] != Step::default()),
            steps: (!binary || has_own).then_some(steps),
            floor: if binary { all.absolute } else { 0.0 },
            tilt: 3.0 * unit * extent,
        }
    }

    /// That of the stricter format in which the numbers may be as well, in the same world.
    #[must_use]
    pub(crate) fn strict(&self) -> Option<Self> {
        self.told.or.map(|or| Self::told(Told::stated(or), self.extent))
    }
}

/// The tolerances of a row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// of p_t; N·s
    pub tangential: f64,
    /// of p_n; N·s
    pub normal: f64,
    /// of the sum of both impulses, along either axis; N·s
    pub reaction: f64,
    /// of M of the first body; N·m·s
    pub moment: f64,
    /// of M of the second body; N·m·s
    pub other_moment: f64,
    /// of u_t⁺; m/s
    pub slip: f64,
    /// of u_n⁺; m/s
    pub separation: f64,
    /// of u_n⁺ − e·a; m/s
    pub restitution: f64,
    /// of ΔT; J
    pub energy: f64,
    /// of u_t before; m/s
    pub slip_before: f64,
    /// by how much the arm is uncertain, by its length
    pub arm: f64,
    /// of the inverse inertia W, by its size, beside what the arm does to it
    pub mobility: f64,
    /// of μ
    pub friction: f64,
    /// of e
    pub elasticity: f64,
}

/// The magnitudes of a body.
struct Size {
    /// |v| + |v⁺| + |g·Δt| along both axes, with what [leans](Written::lean) over from the other, and |ω| + |ω⁺|
    speed: [f64; 3],
    /// the same with what is rounded into them from [beside the plane](Written::sizes)
    rounded: [f64; 3],
    /// how far what was written of them is off
    step: [f64; 3],
    arm: f64,
    round: bool,
}

impl Size {
    #[inline(always)]
    fn of(body: &Moving<f64>, kick: [f64; 2], written: &Written, place: usize) -> Self {
        let lean = written.lean;
        let along = |k: usize| body.before[k].abs() + body.after[k].abs();
        let (t, n) = (along(0) + kick[0].abs(), along(1) + kick[1].abs());
        let speed = [t + lean * n, n + lean * t, along(2)];
        let rounded = written.sizes.map_or(speed, |sizes| {
            let [a, b, spin] = sizes[place];
            [a + kick[0].abs(), b + kick[1].abs(), spin]
        });
        let ([x, y], step) = (body.arm, written.steps[place]);
        Self { speed, rounded, step, arm: x.abs() + y.abs(), round: x.abs() <= 1e-6 * y.abs() }
    }

    /// By how much a velocity or the spin is off, before and after together.
    #[inline(always)]
    fn off(&self, k: usize, eta: f64) -> f64 {
        eta * self.rounded[k] + self.step[k]
    }
}

impl Tolerance {
    /// Of a row.
    #[must_use]
    #[inline]
    pub(crate) fn of(
        event: &Event<f64>,
        facts: &Facts<f64>,
        given: &Given,
        log: &Precision,
        written: &Written,
    ) -> Self {
        let (eta, tau) = (log.rounding, log.tilt + written.slack);
        let kick = event.kick;
        let dt = given.dt.unwrap_or(0.0);
        let first = Size::of(&event.first, kick, written, 0);
        let second = event.second.as_ref().map(|body| (body, Size::of(body, kick, written, 1)));
        let round = first.round && second.as_ref().is_none_or(|(_, size)| size.round);
        let [u_t, u_n] = facts.before;
        // an engine that adds gravity behind the impact comes to it by that much slower or faster
        let fall = if second.is_some() { [0.0; 2] } else { kick.map(f64::abs) };
        let along = dt * (u_n.abs() + fall[1]);
        let every = if round { 0.0 } else { dt * (u_t.abs() + fall[0]) + along };
        let [p_t, p_n] = facts.impulse.map(f64::abs);

        let of_impulse = |body: &Moving<f64>, size: &Size, k: usize| body.mass * size.off(k, eta);
        let tangential = of_impulse(&event.first, &first, 0) + tau * p_n;
        let normal = of_impulse(&event.first, &first, 1) + tau * p_t;
        let moment = |body: &Moving<f64>, size: &Size| {
            let [x, y] = body.arm.map(f64::abs);
            let rounding = body.inertia * size.off(2, eta);
            let arms = y * of_impulse(body, size, 0) + x * of_impulse(body, size, 1);
            let shift = (along + tau * size.arm) * p_t + (every + tau * size.arm) * (p_t + p_n);
            // on round bodies the tilt turns arm and impulse alike
            let tilted = if round { tau * size.arm * p_t } else { 0.0 };
            rounding + arms + if round { along * p_t + tilted } else { shift }
        };

        // velocities of the contact points
        let [mut slip, mut separation, mut before] = [0.0; 3];
        let mut add = |body: &Moving<f64>, size: &Size| {
            let [x, y] = body.arm.map(f64::abs);
            let [off_t, off_n, off_spin] = [0, 1, 2].map(|k| size.off(k, eta));
            slip += off_t + y * off_spin;
            before += off_t + y * off_spin;
            separation += off_n + x * off_spin;
            let shift = (along + tau * size.arm + every) * size.speed[2];
            slip += shift;
            before += shift;
            separation += if round { 0.0 } else { (every + tau * size.arm) * size.speed[2] };
        };
        add(&event.first, &first);
        if let Some((body, size)) = &second {
            add(body, size);
        }
        let turned = tau * (u_t.abs() + facts.after[0].abs() + u_n.abs() + facts.after[1].abs());
        // gravity may act before or after the impact; both bodies fall alike, a fixed one does not
        let slip = slip + turned + fall[0];
        let separation = separation + turned + fall[1];

        let e = given.restitution.unwrap_or(1.0);
        let mut reaction =
            of_impulse(&event.first, &first, 0) + of_impulse(&event.first, &first, 1);
        let mut energy = energy_scale(&event.first, &first, eta);
        let mut other_moment = 0.0;
        if let Some((body, size)) = &second {
            reaction += of_impulse(body, size, 0) + of_impulse(body, size, 1);
            energy += energy_scale(body, size, eta);
            other_moment = moment(body, size);
        }
        energy += kick[0].abs() * p_t + kick[1].abs() * p_n;
        Self {
            tangential,
            normal,
            reaction,
            moment: moment(&event.first, &first),
            other_moment,
            slip,
            separation,
            restitution: (1.0 + e) * separation,
            energy,
            slip_before: before + turned + fall[0],
            arm: (along + every) / first.arm.max(f64::MIN_POSITIVE) + tau,
            mobility: 0.0,
            friction: 0.0,
            elasticity: 0.0,
        }
    }

    /// The same, where settings were rounded when they were written down as well.
    #[must_use]
    #[inline(never)]
    pub(crate) fn widened(
        self,
        event: &Event<f64>,
        facts: &Facts<f64>,
        given: &Given,
        off: &Settings,
    ) -> Self {
        let mut wide = self;
        let kick: f64 = off.kick.iter().sum();
        let bodies =
            [(Some(&event.first), Some(facts.impulse)), (event.second.as_ref(), facts.reaction)];
        for (place, (body, impulse)) in bodies.into_iter().enumerate() {
            let (Some(body), Some(impulse)) = (body, impulse) else { continue };
            let [p_t, p_n] = impulse.map(f64::abs);
            let [x, y] = body.arm.map(f64::abs);
            let (mass, inertia, [dx, dy]) = (off.mass[place], off.inertia[place], off.arm[place]);
            let turned = (body.after[2] - body.before[2]).abs() * body.inertia;
            let moment = inertia * turned
                + (x + dx) * (mass * p_n + body.mass * off.kick[1])
                + (y + dy) * (mass * p_t + body.mass * off.kick[0])
                + dx * p_n
                + dy * p_t
                + off.normal * (x + y) * (p_t + p_n);
            let spin = body.before[2].abs() + body.after[2].abs();
            wide.slip += dy * spin;
            wide.slip_before += dy * spin;
            wide.separation += dx * spin;
            wide.reaction += mass * (p_t + p_n) + body.mass * kick;
            let part =
                |k: usize, p: f64| p * (body.after[k] + body.before[k] + event.kick[k]).abs();
            let (t, n) = (part(0, p_t), part(1, p_n));
            let rotation = turned * (body.after[2] + body.before[2]).abs();
            wide.energy += (mass + 2.0 * off.normal) * (t + n) + inertia * rotation;
            wide.energy += off.kick[0] * p_t + off.kick[1] * p_n;
            wide.mobility = wide.mobility.max(mass.max(inertia));
            if place == 0 {
                wide.moment += moment;
                wide.tangential += mass * p_t + body.mass * off.kick[0] + off.normal * (p_t + p_n);
                wide.normal += mass * p_n + body.mass * off.kick[1] + off.normal * (p_t + p_n);
                wide.arm += (dx + dy) / (x + y).max(f64::MIN_POSITIVE);
            } else {
                wide.other_moment += moment;
            }
        }
        wide.reaction += off.impulse[0] + off.impulse[1];
        // both bodies fall alike
        if event.second.is_none() {
            wide.slip += off.kick[0];
            wide.slip_before += off.kick[0];
            wide.separation += off.kick[1];
        }
        let e = given.restitution.unwrap_or(1.0);
        wide.restitution = (1.0 + e) * wide.separation + off.restitution * facts.before[1].abs();
        wide.friction = off.friction;
        wide.elasticity = off.restitution;
        wide
    }
}

fn energy_scale(body: &Moving<f64>, size: &Size, eta: f64) -> f64 {
    let of = |k: usize| size.speed[k] * size.off(k, eta);
    body.mass * (of(0) + of(1)) + body.inertia * of(2)
}
