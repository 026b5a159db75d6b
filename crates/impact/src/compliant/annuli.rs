//! Tractions on concentric annuli of an elastic half-space, and Coulomb friction on each of them.

use std::f64::consts::{FRAC_PI_2, PI};

use super::hertz::to_float;
use super::{Grip, NoOutcome};

/// u = D·Q: the mean displacements of n annuli of equal width on the unit disc under forces spread
/// evenly over each.
///
/// The operator is that of the normal displacements of a half-space, u = (16/15)·N q in the units
/// of [`hertz`](super::hertz), where Hertz's pressure displaces by x − r²/2. The tangential one,
/// averaged over the angle as Maw, Barber and Fawcett do, is 1/κ of it.
///
/// D follows from the energy of the tractions. By Abel's transform
///
/// ```text
/// g(x) = 2·∫ r·q/√(r² − x²) dr over r > x        ∫ 2π·r·q·(N q) dr = 2·∫ g² dx
/// ```
///
/// and of an even traction on an annulus g = 2·q·(√(b² − x²) − √(a² − x²)), so that
///
/// ```text
/// D_ij = (16/15)·8·Δ_i Δ_j M(r_i, r_j)/(A_i·A_j)    M(a, b) = ∫ √((a² − x²)·(b² − x²)) dx
/// ```
///
/// with Δ the difference over an annulus and A its area. D is symmetric and positive definite.
#[derive(Clone, Debug)]
pub(super) struct Annuli {
    /// How many.
    pub(super) count: usize,
    /// D, row by row.
    flexibility: Vec<f64>,
    /// Cholesky's L with D = L·Lᵀ, column by column: its leading blocks factor those of D.
    factor: Vec<f64>,
}

/// By how much of a ring's width a sticking disc under even tractions acts as if it were smaller;
/// the limit of many annuli, as measured by `a_sticking_disc_is_as_stiff_as_mindlin_says`.
pub(super) const DEFICIT: f64 = 0.115;

/// M(a, b) for 0 ≤ a ≤ b, by complete elliptic integrals: with m = (a/b)²,
/// ∫ cos²θ·√(1 − m·sin²θ) dθ = ((1 + m)·E − (1 − m)·K)/(3m), 0 ≤ θ ≤ π/2.
fn overlap(a: f64, b: f64) -> f64 {
    if a == 0.0 {
        return 0.0;
    }
    if a == b {
        return 2.0 * a * a * a / 3.0;
    }
    let m = (a / b) * (a / b);
    let (first, second) = elliptic(m);
    a * a * b * ((1.0 + m) * second - (1.0 - m) * first) / (3.0 * m)
}

/// K(m) and E(m), 0 < m < 1, by the arithmetic-geometric mean.
fn elliptic(m: f64) -> (f64, f64) {
    let (mut a, mut b, mut c) = (1.0, (1.0 - m).sqrt(), m.sqrt());
    let (mut sum, mut power) = (c * c / 2.0, 0.5);
    // quadratic: the ninth is below rounding for every m < 1 − 2⁻⁵²
    for _ in 0..9 {
        (a, b, c) = ((a + b) / 2.0, (a * b).sqrt(), (a - b) / 2.0);
        power *= 2.0;
        sum += power * c * c;
    }
    let first = FRAC_PI_2 / a;
    (first, first * (1.0 - sum))
}

impl Annuli {
    pub(super) fn new(count: usize) -> Self {
        let radius = |i: usize| to_float(i) / to_float(count);
        let side = count + 1;
        let mut overlaps = vec![0.0; side * side];
        for i in 0..side {
            for j in i..side {
                let value = overlap(radius(i), radius(j));
                overlaps[i * side + j] = value;
                overlaps[j * side + i] = value;
            }
        }
        let area = |i: usize| PI * (radius(i + 1) * radius(i + 1) - radius(i) * radius(i));
        let mut flexibility = vec![0.0; count * count];
        for i in 0..count {
            for j in 0..count {
                let at = |i: usize, j: usize| overlaps[i * side + j];
                let difference = (at(i + 1, j + 1) - at(i, j + 1)) - (at(i + 1, j) - at(i, j));
                flexibility[i * count + j] = 128.0 / 15.0 * difference / (area(i) * area(j));
            }
        }
        let all: Vec<usize> = (0..count).collect();
        let mut annuli = Self { count, flexibility, factor: Vec::new() };
        annuli.factor = annuli.cholesky(&all);
        annuli
    }

    pub(super) fn row(&self, i: usize) -> &[f64] {
        &self.flexibility[i * self.count..][..self.count]
    }

    /// L of the block of D that belongs to some annuli, column by column; columns have full height.
    fn cholesky(&self, of: &[usize]) -> Vec<f64> {
        let n = of.len();
        let mut columns: Vec<f64> =
            of.iter().flat_map(|&j| of.iter().map(move |&i| self.row(j)[i])).collect();
        for j in 0..n {
            let (before, after) = columns.split_at_mut((j + 1) * n);
            let column = &mut before[j * n..];
            let pivot = column[j].sqrt();
            column[j..].iter_mut().for_each(|x| *x /= pivot);
            for k in j + 1..n {
                let share = column[k];
                let other = &mut after[(k - j - 1) * n..][k..n];
                subtract(other, share, &column[k..]);
            }
        }
        columns
    }

    /// D·Q, for forces that vanish from `contact` on.
    pub(super) fn displacements(&self, forces: &[f64], contact: usize, out: &mut [f64]) {
        out.fill(0.0);
        for (j, force) in forces.iter().enumerate().take(contact) {
            subtract(out, -force, self.row(j));
        }
    }
}

/// a − share·b, in place.
fn subtract(a: &mut [f64], share: f64, b: &[f64]) {
    a.iter_mut().zip(b).for_each(|(a, b)| *a -= share * b);
}

/// L·Lᵀ·x = b in place, with L column by column, columns of `height`.
fn solve(columns: &[f64], height: usize, b: &mut [f64]) {
    let n = b.len();
    for j in 0..n {
        let column = &columns[j * height..][..n];
        let (head, tail) = b.split_at_mut(j + 1);
        head[j] /= column[j];
        subtract(tail, head[j], &column[j + 1..]);
    }
    for j in (0..n).rev() {
        let column = &columns[j * height..][..n];
        let (head, tail) = b.split_at_mut(j + 1);
        let rest: f64 = dot(tail, &column[j + 1..]);
        head[j] = (head[j] - rest) / column[j];
    }
}

/// The scalar product, in four sums that the processor can add at once.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; 4];
    let (left, right) = (a.chunks_exact(4), b.chunks_exact(4));
    let rest: f64 = left.remainder().iter().zip(right.remainder()).map(|(a, b)| a * b).sum();
    for (a, b) in left.zip(right) {
        for (sum, (a, b)) in sums.iter_mut().zip(a.iter().zip(b)) {
            *sum += a * b;
        }
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3]) + rest
}

/// The friction of all annuli in contact.
#[derive(Clone, Debug)]
pub(super) struct Friction {
    pub(super) grips: Vec<Grip>,
    pub(super) forces: Vec<f64>,
    pub(super) displacements: Vec<f64>,
    work: Vec<f64>,
    sticking: Vec<usize>,
}

/// Rounds in which every wrong grip is changed, and those after them in which only the last one is.
const BLOCK_ROUNDS: usize = 20;
const ROUNDS: usize = 2000;
/// Of the greatest force or displacement: far above rounding, far below any error of the method.
const TOLERANCE: f64 = 1e-12;

impl Friction {
    pub(super) fn new(count: usize) -> Self {
        Self {
            grips: vec![Grip::Stick; count],
            forces: vec![0.0; count],
            displacements: vec![0.0; count],
            work: vec![0.0; count],
            sticking: Vec::with_capacity(count),
        }
    }

    /// Finds the forces |Q_i| ≤ B_i with, for the slip w = b − D·Q of each annulus in contact,
    /// w = 0 inside the cone and w along Q on it; `bounds` is that of the annuli in contact, and
    /// `wanted` their b.
    ///
    /// D is positive definite, so that there is exactly one answer. The grips are those of the last
    /// call, changed wherever they are wrong; should that not end, one by one, from the outside,
    /// which does (Murty's rule for P-matrices, as Júdice and Pires combine the two).
    pub(super) fn settle(
        &mut self,
        annuli: &Annuli,
        bounds: &[f64],
        wanted: &[f64],
    ) -> Result<(), NoOutcome> {
        let contact = bounds.len();
        self.forces[contact..].fill(0.0);
        let finite = |x: &f64| if x.is_finite() { *x } else { 0.0 };
        let force_noise = TOLERANCE * bounds.iter().map(finite).fold(0.0, f64::max);
        let slip_noise = TOLERANCE * wanted.iter().map(|x| x.abs()).fold(0.0, f64::max);
        for round in 0..ROUNDS {
            self.solve(annuli, bounds, wanted);
            annuli.displacements(&self.forces, contact, &mut self.displacements);
            let mut right = true;
            for i in (0..contact).rev() {
                let (force, slip) = (self.forces[i], wanted[i] - self.displacements[i]);
                let better = match self.grips[i] {
                    Grip::Stick if force > bounds[i] + force_noise => Grip::Forward,
                    Grip::Stick if force < -bounds[i] - force_noise => Grip::Backward,
                    Grip::Forward if slip < -slip_noise => Grip::Stick,
                    Grip::Backward if slip > slip_noise => Grip::Stick,
                    grip => grip,
                };
                if better != self.grips[i] {
                    (self.grips[i], right) = (better, false);
                    if round >= BLOCK_ROUNDS {
                        break;
                    }
                }
            }
            if right {
                // the noise that was let pass
                for (force, bound) in self.forces.iter_mut().zip(bounds) {
                    *force = force.clamp(-bound, *bound);
                }
                return Ok(());
            }
        }
        Err(NoOutcome::Unsettled { annuli: contact, rounds: ROUNDS })
    }

    /// The forces for the grips as they are.
    fn solve(&mut self, annuli: &Annuli, bounds: &[f64], wanted: &[f64]) {
        let contact = bounds.len();
        self.sticking.clear();
        self.work[..contact].copy_from_slice(wanted);
        for (i, bound) in bounds.iter().enumerate() {
            self.forces[i] = match self.grips[i] {
                Grip::Stick => {
                    self.sticking.push(i);
                    continue;
                }
                Grip::Forward => *bound,
                Grip::Backward => -bound,
            };
            subtract(&mut self.work[..contact], self.forces[i], annuli.row(i));
        }
        let n = self.sticking.len();
        if self.sticking.last().is_none_or(|last| last + 1 == n) {
            // the inner ones stick, as they do most of the time
            solve(&annuli.factor, annuli.count, &mut self.work[..n]);
        } else {
            for (place, &i) in self.sticking.iter().enumerate() {
                self.work[place] = self.work[i];
            }
            solve(&annuli.cholesky(&self.sticking), n, &mut self.work[..n]);
        }
        for (place, &i) in self.sticking.iter().enumerate() {
            self.forces[i] = self.work[place];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Annuli, DEFICIT, Friction, elliptic, overlap};
    use crate::compliant::Grip;
    use crate::compliant::hertz::to_float;

    /// K(1/2) and E(1/2): the lemniscatic case, from Γ(1/4). Tolerance: a few roundings.
    #[test]
    fn elliptic_integrals_are_those_of_the_tables() {
        let (first, second) = elliptic(0.5);
        assert!((first - 1.854_074_677_301_372).abs() < 1e-15 * 4.0, "{first}");
        assert!((second - 1.350_643_881_047_675_5).abs() < 1e-15 * 4.0, "{second}");
    }

    /// Against the midpoint rule in x = a·sin θ, which converges exponentially for m = 1/4.
    #[test]
    fn overlaps_are_their_integrals() {
        let (a, b, n) = (0.5, 1.0, 64);
        let mut sum = 0.0;
        for i in 0..n {
            let theta = (to_float(i) + 0.5) / to_float(n) * std::f64::consts::FRAC_PI_2;
            let (sin, cos) = theta.sin_cos();
            sum += cos * cos * (b * b - a * a * sin * sin).sqrt();
        }
        let integral = a * a * sum / to_float(n) * std::f64::consts::FRAC_PI_2;
        assert!((overlap(a, b) - integral).abs() < 1e-15, "{integral}");
    }

    /// Hertz's pressure on the unit disc displaces by 1 − r²/2, inside. Even tractions on annuli
    /// miss it by O(1/n²) in the mean over an annulus, save at the very edge.
    #[test]
    fn hertzs_pressure_displaces_as_hertz_says() {
        let worst = |n: usize| {
            let annuli = Annuli::new(n);
            let radius = |i: usize| to_float(i) / to_float(n);
            let left = |i: usize| (1.0 - radius(i) * radius(i)).max(0.0).powf(1.5);
            let forces: Vec<f64> = (0..n).map(|i| 1.25 * (left(i) - left(i + 1))).collect();
            let mut u = vec![0.0; n];
            annuli.displacements(&forces, n, &mut u);
            let mean =
                |i: usize| 1.0 - (radius(i) * radius(i) + radius(i + 1) * radius(i + 1)) / 4.0;
            (0..n / 2).map(|i| (u[i] - mean(i)).abs()).fold(0.0, f64::max)
        };
        let (coarse, fine) = (worst(20), worst(40));
        assert!(fine < 2e-3 && fine < coarse / 3.0, "{coarse} {fine}");
    }

    /// Mindlin's stiffness without slip is 15/8·a in these units, 8·G*·a in others. Even tractions do
    /// less well than the best, which is singular at the edge, so that the disc acts as one that is
    /// smaller by `DEFICIT` of a ring's width, up to O(1/n²) of the radius.
    #[test]
    fn a_sticking_disc_is_as_stiff_as_mindlin_says() {
        for n in [20, 40, 80] {
            let annuli = Annuli::new(n);
            let mut friction = Friction::new(n);
            let bounds = vec![f64::INFINITY; n];
            friction.settle(&annuli, &bounds, &vec![1.0; n]).expect("it sticks");
            assert!(friction.grips.iter().all(|grip| *grip == Grip::Stick));
            let radius = friction.forces.iter().sum::<f64>() / 1.875;
            let missing = (1.0 - radius) * to_float(n);
            assert!((missing - DEFICIT).abs() < 0.05 / to_float(n), "{n}: {missing}");
        }
    }

    /// The answer is checked against its conditions, for grips in any order: what sticks need not be
    /// the inner annuli.
    #[test]
    fn friction_settles_where_slip_is_in_the_middle() {
        let n = 30;
        let annuli = Annuli::new(n);
        let mut friction = Friction::new(n);
        let bounds: Vec<f64> =
            (0..n).map(|i| if (10..20).contains(&i) { 1e-3 } else { 0.1 }).collect();
        let wanted: Vec<f64> = (0..n).map(|i| if i < 25 { 0.5 } else { -0.5 }).collect();
        friction.settle(&annuli, &bounds, &wanted).expect("a positive definite system");
        let (mut sticks, mut slides) = (0, 0);
        for i in 0..n {
            let (force, slip) = (friction.forces[i], wanted[i] - friction.displacements[i]);
            assert!(force.abs() <= bounds[i]);
            match friction.grips[i] {
                Grip::Stick => {
                    sticks += 1;
                    assert!(slip.abs() < 1e-11);
                }
                _ => {
                    slides += 1;
                    assert!(force.abs() == bounds[i] && force * slip >= -1e-14);
                }
            }
        }
        assert!(sticks > 0 && slides >= 10, "{sticks} {slides}");
    }
}
