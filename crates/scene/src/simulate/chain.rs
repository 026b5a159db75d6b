//! Several spheres in a row that touch at once: Hertz's springs, integrated.

/// A row of elastic spheres that move along one line.
#[derive(Clone, Debug, PartialEq)]
pub struct Chain {
    /// kg, from left to right
    pub masses: Vec<f64>,
    /// The gaps between neighbours, at least 0; m.
    pub gaps: Vec<f64>,
    /// m/s, to the right
    pub velocities: Vec<f64>,
    /// κ of the force κ·δ^(3/2) at every contact; N/m^(3/2).
    pub stiffness: f64,
}

/// Why there is no answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ChainError {
    /// It went on for longer than any such collision does.
    #[error("the spheres did not part within the budget of steps")]
    Endless,
    /// Numbers that describe no chain.
    #[error(
        "a chain needs two spheres at least, positive masses and stiffness, and finite numbers"
    )]
    Invalid,
}

/// Steps before it is called endless.
const MOST_STEPS: usize = 4_000_000;

/// The velocities after all spheres have parted for good, with `steps` steps to the time that two
/// spheres take to bounce off each other, by the classical method of Runge and Kutta; times without
/// any contact are passed in closed form.
///
/// Heuristic; refine the steps to see the error. Order 5/2 at least, that of the force's kink at the
/// first touch. Normal forces alone, no loss: C. M. Donahue, C. M. Hrenya, A. P. Zelinskaya,
/// K. J. Nakagawa, Phys. Fluids 20, 113301 (2008), abstract consulted, call the model soft-sphere.
///
/// # Errors
/// [`ChainError`].
pub fn collide_chain(chain: &Chain, steps: u32) -> Result<Vec<f64>, ChainError> {
    follow(chain, steps, &mut |_, _| {})
}

/// A moment of a collision of several spheres.
#[derive(Clone, Debug, PartialEq)]
pub struct Moment {
    /// Since the first touch; s.
    pub time: f64,
    /// Of each sphere; m/s.
    pub velocities: Vec<f64>,
    /// Between neighbours, at least 0; N.
    pub forces: Vec<f64>,
}

/// A collision of several spheres over the time from the first touch to the last parting.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactTime {
    /// In order; evenly thinned to some hundred.
    pub moments: Vec<Moment>,
}

/// Moments that are kept.
const KEPT: usize = 120;

/// The same integration, watched; heuristic as [`collide_chain`] is.
///
/// # Errors
/// [`ChainError`].
pub fn watch_chain(chain: &Chain, steps: u32) -> Result<ContactTime, ChainError> {
    let mut moments: Vec<Moment> = Vec::new();
    follow(chain, steps, &mut |time, state| {
        let forces = (0..state.gaps.len()).map(|i| chain.force(state, i)).collect();
        moments.push(Moment { time, velocities: state.velocities.clone(), forces });
    })?;
    let start = moments.first().map_or(0.0, |first| first.time);
    let (every, last) = (moments.len().div_ceil(KEPT).max(1), moments.len().saturating_sub(1));
    let kept = moments.into_iter().enumerate().filter(|(n, _)| n % every == 0 || *n == last);
    let kept = kept.map(|(_, moment)| Moment { time: moment.time - start, ..moment });
    Ok(ContactTime { moments: kept.collect() })
}

/// Integrates, and shows the state at every first touch and after every step.
fn follow(
    chain: &Chain,
    steps: u32,
    see: &mut dyn FnMut(f64, &State),
) -> Result<Vec<f64>, ChainError> {
    let n = chain.masses.len();
    let finite = chain.gaps.iter().chain(&chain.velocities).all(|x| x.is_finite());
    let positive = chain.masses.iter().chain([&chain.stiffness]).all(|x| *x > 0.0);
    if n < 2
        || !finite
        || !positive
        || chain.gaps.len() + 1 != n
        || chain.velocities.len() != n
        || chain.gaps.iter().any(|gap| *gap < 0.0)
    {
        return Err(ChainError::Invalid);
    }
    let mut state = State { gaps: chain.gaps.clone(), velocities: chain.velocities.clone() };
    let (mut left, mut now) = (MOST_STEPS, 0.0);
    loop {
        let touching = |gap: f64, closing: f64| gap < 0.0 || (gap == 0.0 && closing > 0.0);
        let contact = (0..n - 1).any(|i| touching(state.gaps[i], state.closing(i)));
        if !contact {
            // free: to the next touch, or the end
            let next = (0..n - 1)
                .filter(|i| state.closing(*i) > 0.0)
                .map(|i| (state.gaps[i] / state.closing(i), i))
                .min_by(|a, b| a.0.total_cmp(&b.0));
            let Some((time, first)) = next else { return Ok(state.velocities) };
            for i in 0..n - 1 {
                state.gaps[i] -= state.closing(i) * time;
            }
            state.gaps[first] = 0.0;
            now += time;
            continue;
        }
        let step = chain.time_of_bounce(&state) / f64::from(steps);
        let mut work = Work::of(&state);
        see(now, &state);
        while (0..n - 1).any(|i| touching(state.gaps[i], state.closing(i))) {
            left = left.checked_sub(1).ok_or(ChainError::Endless)?;
            chain.advance(&mut state, step, &mut work);
            now += step;
            see(now, &state);
        }
    }
}

#[derive(Clone)]
struct State {
    gaps: Vec<f64>,
    velocities: Vec<f64>,
}

impl State {
    fn closing(&self, i: usize) -> f64 {
        self.velocities[i] - self.velocities[i + 1]
    }

    /// The state after a time at a constant rate.
    fn move_from(&mut self, start: &Self, rate: &Self, time: f64) {
        let add = |to: &mut [f64], a: &[f64], b: &[f64]| {
            to.iter_mut().zip(a.iter().zip(b)).for_each(|(to, (a, b))| *to = a + b * time);
        };
        add(&mut self.gaps, &start.gaps, &rate.gaps);
        add(&mut self.velocities, &start.velocities, &rate.velocities);
    }
}

/// What one step is computed in, so that it asks for no memory: four rates, their mean, and a state between.
struct Work {
    rates: [State; 4],
    mean: State,
    between: State,
}

impl Work {
    fn of(state: &State) -> Self {
        let one = || state.clone();
        Self { rates: [one(), one(), one(), one()], mean: one(), between: one() }
    }
}

impl Chain {
    /// 2.94·δ_max/v of the fastest pair, Hertz's time of contact, from δ_max = (5·m·v²/(4·κ))^(2/5).
    fn time_of_bounce(&self, state: &State) -> f64 {
        let spread = (0..self.gaps.len()).map(|i| state.closing(i).abs()).fold(0.0, f64::max);
        let lightest = self.masses.iter().copied().fold(f64::INFINITY, f64::min) / 2.0;
        let depth = (1.25 * lightest * spread * spread / self.stiffness).powf(0.4);
        2.94 * depth / spread
    }

    /// κ·δ^(3/2) where the two overlap by δ, and 0 where they do not touch.
    fn force(&self, state: &State, i: usize) -> f64 {
        let depth = (-state.gaps[i]).max(0.0);
        self.stiffness * depth * depth.sqrt()
    }

    fn rate(&self, state: &State, rate: &mut State) {
        rate.velocities.fill(0.0);
        for i in 0..self.gaps.len() {
            let force = self.force(state, i);
            rate.velocities[i] -= force / self.masses[i];
            rate.velocities[i + 1] += force / self.masses[i + 1];
            rate.gaps[i] = -state.closing(i);
        }
    }

    /// One step of the classical method of Runge and Kutta.
    fn advance(&self, state: &mut State, step: f64, work: &mut Work) {
        let Work { rates: [k1, k2, k3, k4], mean, between } = work;
        self.rate(state, k1);
        between.move_from(state, k1, step / 2.0);
        self.rate(between, k2);
        between.move_from(state, k2, step / 2.0);
        self.rate(between, k3);
        between.move_from(state, k3, step);
        self.rate(between, k4);
        let weigh = |to: &mut [f64], a: &[f64], b: &[f64], c: &[f64], d: &[f64]| {
            let four = a.iter().zip(b).zip(c.iter().zip(d));
            to.iter_mut().zip(four).for_each(|(to, ((a, b), (c, d)))| {
                *to = (a + 2.0 * (b + c) + d) / 6.0;
            });
        };
        weigh(&mut mean.gaps, &k1.gaps, &k2.gaps, &k3.gaps, &k4.gaps);
        weigh(&mut mean.velocities, &k1.velocities, &k2.velocities, &k3.velocities, &k4.velocities);
        between.move_from(state, mean, step);
        std::mem::swap(state, between);
    }
}
