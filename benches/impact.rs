//! How long collisions take: `cargo bench --bench impact`.
//!
//! `stored` fills columns with k, i_x and Δe, `survey` stores nothing; their items are rows, in the
//! first-level cache and far beyond the last. `decision` is by what it takes to decide, with all stages
//! before; `exactly` is one collision in exact arithmetic. `scripts/compare/run` sets them beside
//! other languages.

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use kane::impact::batch::{self, Batched, Columns};
use kane::impact::bodies::{Motion, SphereOnPlane};
use kane::impact::laws::{GarwinCapped, Smith1991, Walton, WangSuLi, WhittakerUncapped};
use kane::impact::{ImpactLaw, decide, exact};
use kane::number::{Rational, decode};

fn main() {
    divan::main();
}

const ROWS: [usize; 2] = [1_000, 10_000_000];

fn alpha(rows: usize) -> Vec<f64> {
    let step = 1.0 / 1_048_576.0;
    (0..rows).map(|row| f64::from(u32::try_from(row % 4_194_304).unwrap_or(0)) * step).collect()
}

fn columns<L: Batched>(bencher: Bencher<'_, '_>, law: &L, rows: usize) {
    let alpha = alpha(rows);
    let mut out = [vec![1.0; rows], vec![1.0; rows], vec![1.0; rows]];
    bencher.counter(ItemsCount::new(rows)).bench_local(|| {
        let [k, impulse, energy] = &mut out;
        batch::evaluate(law, black_box(&alpha), Columns { k, impulse, energy });
    });
}

#[divan::bench_group(sample_count = 20)]
mod stored {
    use super::*;

    #[divan::bench(args = ROWS)]
    fn wang_su_li(bencher: Bencher<'_, '_>, rows: usize) {
        columns(bencher, &WangSuLi, rows);
    }

    #[divan::bench(args = ROWS)]
    fn whittaker_uncapped(bencher: Bencher<'_, '_>, rows: usize) {
        columns(bencher, &WhittakerUncapped, rows);
    }

    #[divan::bench(args = ROWS)]
    fn walton(bencher: Bencher<'_, '_>, rows: usize) {
        columns(bencher, &Walton::default(), rows);
    }

    #[divan::bench(args = ROWS)]
    fn garwin_capped(bencher: Bencher<'_, '_>, rows: usize) {
        columns(bencher, &GarwinCapped, rows);
    }

    #[divan::bench(args = ROWS)]
    fn smith_1991(bencher: Bencher<'_, '_>, rows: usize) {
        columns(bencher, &Smith1991, rows);
    }
}

#[divan::bench(args = ROWS, sample_count = 20)]
fn survey(bencher: Bencher<'_, '_>, rows: usize) {
    let alpha = alpha(rows);
    let counter = ItemsCount::new(rows);
    bencher.counter(counter).bench(|| batch::survey(&WangSuLi, black_box(&alpha)));
}

/// Sliding ends far from rest, as near to it as full significands allow, at it, and with subnormals.
#[derive(Clone, Copy, Debug)]
enum Difficulty {
    Ordinary,
    NearlyTied,
    Tied,
    Extreme,
}

fn sphere(difficulty: Difficulty) -> SphereOnPlane<f64> {
    let before = Motion { vx: 1.1, vy: 1.3, omega: -0.7 };
    let mut sphere = SphereOnPlane {
        mass: 0.3,
        radius: 0.9,
        inertia: 0.1,
        friction: 0.35,
        restitution: 0.8,
        before,
    };
    let sliding = sphere.friction * (1.0 + sphere.restitution) * sphere.before.vy;
    let whole = sphere.inertia + sphere.mass * sphere.radius * sphere.radius;
    match difficulty {
        Difficulty::Ordinary => {}
        Difficulty::NearlyTied => {
            let turning = sphere.before.omega * sphere.radius;
            sphere.before.vx = turning + whole * sliding / sphere.inertia;
        }
        Difficulty::Tied => {
            (sphere.mass, sphere.radius, sphere.inertia) = (1.0, 1.0, 1.0);
            // 2·μ·v_y with 53 bits each, on the left as a turning contact point
            (sphere.restitution, sphere.before.vx) = (0.0, 0.0);
            (sphere.radius, sphere.before.omega) = (1.0, 2.0 * sphere.friction);
            sphere.before.vy = 1.0;
        }
        Difficulty::Extreme => {
            sphere.inertia = f64::from_bits(1);
            sphere.before.vx = sphere.before.omega * sphere.radius;
        }
    }
    sphere
}

#[divan::bench(args = [Difficulty::Ordinary, Difficulty::NearlyTied, Difficulty::Tied, Difficulty::Extreme])]
fn decision(bencher: Bencher<'_, '_>, difficulty: Difficulty) {
    let sphere = sphere(difficulty);
    bencher.bench(|| decide::sliding(black_box(&sphere)));
}

#[divan::bench_group]
mod exactly {
    use super::*;

    #[divan::bench]
    fn unreduced(bencher: Bencher<'_, '_>) {
        let sphere = sphere(Difficulty::Ordinary);
        bencher.bench(|| exact::wang_su_li(black_box(&sphere)));
    }

    #[divan::bench]
    fn unreduced_to_floats(bencher: Bencher<'_, '_>) {
        let sphere = sphere(Difficulty::Ordinary);
        bencher.bench(|| {
            let ratios = exact::wang_su_li(black_box(&sphere)).ok().flatten();
            ratios.map(|ratios| (ratios.k.to_f64(), ratios.impulse.to_f64()))
        });
    }

    /// The law itself on fractions: the whole impulse from a contact that is given.
    #[divan::bench]
    fn law_on_fractions(bencher: Bencher<'_, '_>) {
        let sphere = sphere(Difficulty::Ordinary).map(|&x| decode(x).expect("finite"));
        let contact = sphere.contact().expect("valid");
        bencher.bench(|| WangSuLi.impulse::<Rational>(black_box(&contact)));
    }
}
