//! What follows of an impact by arithmetic alone: impulses, moments, slips, energy.

use kane_impact::Delassus;
use kane_number::Number;

use crate::event::{Event, Moving};

/// The facts of an impact, before any law. SI units.
///
/// With m, J, the arm (x, y) from the centre to the contact point, velocities v and spins ω of each
/// body, and g·Δt, the [kick](Event::kick) of gravity within the step:
///
/// ```text
/// p  = m·(v⁺ − v − g·Δt)          the impulse on each body
/// M  = J·(ω⁺ − ω) − (x·p_n − y·p_t)   what the impulse at the contact leaves of the moment
/// u  = v + g·Δt + ω×r             of the first contact point against the second, before
/// u⁺ = v⁺ + ω⁺×r                  and after
/// ΔT = p·(v⁺ + v + g·Δt)/2 + J·(ω⁺ − ω)·(ω⁺ + ω)/2    by part
/// ```
///
/// Exact in exact numbers; in floats each is a sum of at most twelve products, so that it is off by
/// at most 16·2^−53 of the sum of their magnitudes.
#[derive(Clone, Debug, PartialEq)]
pub struct Facts<N> {
    /// p of the first body, along tangent and normal; N·s
    pub impulse: [N; 2],
    /// p of the second body
    pub reaction: Option<[N; 2]>,
    /// M of the first body; N·m·s
    pub moment: N,
    /// M of the second body
    pub other_moment: Option<N>,
    /// u; m/s
    pub before: [N; 2],
    /// u⁺; m/s
    pub after: [N; 2],
    /// ΔT along the normal, along the tangent, and of rotation; J
    pub energy: [N; 3],
}

impl<N: Number> Moving<N> {
    fn impulse(&self, kick: &[N; 2]) -> [N; 2] {
        let along = |k: usize| (self.after[k].clone() - &self.before[k] - &kick[k]) * &self.mass;
        [along(0), along(1)]
    }

    fn moment(&self, [t, n]: &[N; 2]) -> N {
        let turned = (self.after[2].clone() - &self.before[2]) * &self.inertia;
        turned - (self.arm[0].clone() * n - self.arm[1].clone() * t)
    }

    /// v + ω×r of the contact point.
    fn at_contact(&self, motion: &[N; 3]) -> [N; 2] {
        let [t, n, spin] = motion;
        [t.clone() - spin.clone() * &self.arm[1], n.clone() + spin.clone() * &self.arm[0]]
    }

    fn energy(&self, impulse: &[N; 2], kick: &[N; 2]) -> [N; 3] {
        let twice = |k: usize| (self.after[k].clone() + &self.before[k] + &kick[k]) * &impulse[k];
        let spin = (self.after[2].clone() - &self.before[2])
            * (self.after[2].clone() + &self.before[2])
            * &self.inertia;
        let two = N::one().double();
        [twice(1) / &two, twice(0) / &two, spin / &two]
    }

    fn delassus(&self) -> Delassus<N> {
        let free = N::one() / &self.mass;
        let [x, y] = &self.arm;
        let entry = |a: &N, b: &N| a.clone() * b / &self.inertia;
        Delassus::unchecked(free.clone() + entry(y, y), -entry(x, y), free + entry(x, x))
    }
}

impl<N: Number> Event<N> {
    /// The facts.
    #[must_use]
    #[inline]
    pub fn facts(&self) -> Facts<N> {
        let first = &self.first;
        let impulse = first.impulse(&self.kick);
        let kicked = |motion: &[N; 3]| {
            let [t, n, spin] = motion.clone();
            [t + &self.kick[0], n + &self.kick[1], spin]
        };
        let mut before = first.at_contact(&kicked(&first.before));
        let mut after = first.at_contact(&first.after);
        let mut energy = first.energy(&impulse, &self.kick);
        let (mut reaction, mut other_moment) = (None, None);
        if let Some(second) = &self.second {
            let theirs = second.impulse(&self.kick);
            let minus = |a: [N; 2], b: [N; 2]| {
                let ([a, c], [b, d]) = (a, b);
                [a - b, c - d]
            };
            before = minus(before, second.at_contact(&kicked(&second.before)));
            after = minus(after, second.at_contact(&second.after));
            for (part, more) in energy.iter_mut().zip(second.energy(&theirs, &self.kick)) {
                *part = part.clone() + more;
            }
            other_moment = Some(second.moment(&theirs));
            reaction = Some(theirs);
        }
        Facts {
            moment: first.moment(&impulse),
            impulse,
            reaction,
            other_moment,
            before,
            after,
            energy,
        }
    }

    /// The inverse inertia at the contact, of both bodies; 1/kg.
    #[must_use]
    pub fn delassus(&self) -> Delassus<N> {
        let first = self.first.delassus();
        match &self.second {
            Some(second) => first.plus(&second.delassus()),
            None => first,
        }
    }
}
