//! The Rust side of `scripts/compare`: runs one piece of work when asked, and says how long it took.
//!
//! Each line on the standard input is `work rows`; the answer is a line with the nanoseconds of one
//! pass over that many rows. Data is made before the clock starts.

use std::collections::HashMap;
use std::hint::black_box;
use std::io::{BufRead, Write};
use std::time::Instant;

use kane_impact::batch::{self, Columns};
use kane_impact::bodies::{Motion, SphereOnPlane};
use kane_impact::decide::{self, Spheres, Stage};
use kane_impact::exact::wang_su_li;
use kane_impact::laws::{Smith1991, WangSuLi};
use kane_impact::{Alpha, Contact, LawOver};
use kane_number::{Number, Rational, Real, decode};

type Sphere = SphereOnPlane<f64>;

/// A small generator of the xorshift family (Marsaglia 2003).
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    /// Between zero and one.
    fn unit(&mut self) -> f64 {
        f64::from_bits(1.0_f64.to_bits() | self.bits() >> 12) - 1.0
    }

    fn size(&mut self) -> f64 {
        0.1 + 2.0 * self.unit()
    }

    fn sphere(&mut self) -> Sphere {
        SphereOnPlane {
            mass: self.size(),
            radius: self.size(),
            inertia: self.size(),
            friction: self.unit(),
            restitution: self.unit(),
            before: Motion {
                vx: 4.0 * self.unit() - 2.0,
                vy: self.size(),
                omega: 4.0 * self.unit() - 2.0,
            },
        }
    }
}

/// A sphere whose slip sliding would end, as far as floats can tell.
fn nearly_tied(random: &mut Random) -> Sphere {
    loop {
        let mut sphere = random.sphere();
        let Sphere { mass, radius, inertia, friction, restitution, before } = &mut sphere;
        let sliding = *friction * (1.0 + *restitution) * before.vy;
        let slip = (*inertia + *mass * *radius * *radius) * sliding / *inertia;
        before.vx = before.omega * *radius + slip;
        if decide::sliding(&sphere).is_ok_and(|decision| decision.stage == Stage::Fixed) {
            return sphere;
        }
    }
}

/// The same question in floats, unproved and without a look at the domains.
fn plain(sphere: &Sphere) -> bool {
    let Sphere { mass, radius, inertia, friction, restitution, before } = sphere;
    let sliding = friction * ((1.0 + restitution) * before.vy);
    let slowing = (inertia + mass * radius * radius) * sliding;
    inertia * (before.vx - before.omega * radius).abs() > slowing
}

/// The same over columns.
#[inline(never)]
fn plain_columns(columns: &[Vec<f64>; 8]) -> usize {
    let rows = columns[0].len();
    let [m, r, j, mu, e, vx, vy, w] = columns.each_ref().map(|column| &column[..rows]);
    let slides = |row: usize| {
        let sliding = mu[row] * ((1.0 + e[row]) * vy[row]);
        let slowing = (j[row] + m[row] * r[row] * r[row]) * sliding;
        j[row] * (vx[row] - w[row] * r[row]).abs() > slowing
    };
    (0..rows).map(|row| usize::from(slides(row))).sum()
}

/// The same with the domains.
fn plain_checked(sphere: &Sphere) -> bool {
    let Sphere { mass, radius, inertia, friction, restitution, before } = sphere;
    let positive = |x: f64| x > 0.0 && x.is_finite();
    let valid = positive(*mass)
        && positive(*radius)
        && positive(*inertia)
        && *friction >= 0.0
        && friction.is_finite()
        && (0.0..=1.0).contains(restitution)
        && before.vy >= 0.0
        && before.vy.is_finite()
        && before.vx.is_finite()
        && before.omega.is_finite();
    valid & plain(sphere)
}

/// k and i_x by the formulas of the paper in fractions.
fn by_fractions(sphere: &SphereOnPlane<Rational>) -> (Rational, Rational) {
    let one = Rational::one();
    let slip = &sphere.before.vx - &sphere.before.omega * &sphere.radius;
    let slip = if slip < Rational::zero() { -slip } else { slip };
    let j_p = &one + &sphere.mass * &sphere.radius * &sphere.radius / &sphere.inertia;
    let sliding = &sphere.friction * (&one + &sphere.restitution) * &sphere.before.vy;
    let alpha = j_p * sliding / slip.double();
    let whole = &one + &alpha;
    ((&one - alpha) / &whole, one / whole)
}

/// The laws at contacts that are given, and in terms of α, as [`LawOver`] is called from above.
#[derive(Default)]
struct Alone<N> {
    contacts: Vec<Contact<N>>,
    alphas: Vec<Alpha<N>>,
}

impl<N: Real> Alone<N> {
    fn of(spheres: &[Sphere]) -> Self {
        let exactly = |x: &f64| N::from_rational(&decode(*x).expect("finite"));
        let contact = |sphere: &Sphere| sphere.map(exactly).contact().expect("valid");
        let alpha = |sphere: &Sphere| Alpha::Finite(exactly(&(3.0 * sphere.restitution)));
        Self {
            contacts: spheres.iter().map(contact).collect(),
            alphas: spheres.iter().map(alpha).collect(),
        }
    }

    /// What is asked of the law follows the last dash: all of the outcome, its impulse, or ratios.
    fn pass(&self, work: &str, law: &dyn LawOver<N>) {
        match work.rsplit('-').next() {
            Some("ratios") => {
                self.alphas.iter().for_each(|alpha| _ = black_box(law.ratios(black_box(alpha))));
            }
            Some("impulse") => {
                self.contacts.iter().for_each(|c| _ = black_box(law.impulse(black_box(c))));
            }
            _ => self.contacts.iter().for_each(|c| _ = black_box(law.resolve(black_box(c)))),
        }
    }
}

/// All that the work needs, made once.
#[derive(Default)]
struct Data {
    floats: Alone<f64>,
    fractions: Alone<Rational>,
    alpha: Vec<f64>,
    columns: [Vec<f64>; 3],
    spheres: Vec<Sphere>,
    tied: Vec<Sphere>,
    sphere_columns: [Vec<f64>; 8],
    signs: Vec<std::cmp::Ordering>,
    rationals: Vec<SphereOnPlane<Rational>>,
}

impl Data {
    fn of(work: &str, rows: usize) -> Self {
        let mut random = Random(0x9e37_79b9_7f4a_7c15);
        let mut data = Self::default();
        match work {
            "stores" | "batch" | "survey" | "reads" => {
                data.alpha = (0..rows).map(|_| 3.0 * random.unit()).collect();
                data.columns = [vec![1.0; rows], vec![1.0; rows], vec![1.0; rows]];
            }
            "decide-tied" => data.tied = (0..rows).map(|_| nearly_tied(&mut random)).collect(),
            _ => data.spheres = (0..rows).map(|_| random.sphere()).collect(),
        }
        if work.ends_with("-columns") {
            let fields: [fn(&Sphere) -> f64; 8] = [
                |s| s.mass,
                |s| s.radius,
                |s| s.inertia,
                |s| s.friction,
                |s| s.restitution,
                |s| s.before.vx,
                |s| s.before.vy,
                |s| s.before.omega,
            ];
            data.sphere_columns = fields.map(|field| data.spheres.iter().map(field).collect());
        }
        if work.starts_with("law-f64") {
            data.floats = Alone::of(&data.spheres);
        }
        if work.starts_with("law-rational") {
            data.fractions = Alone::of(&data.spheres);
        }
        data.signs = vec![std::cmp::Ordering::Equal; data.spheres.len()];
        if work == "exact-rational" {
            let exactly = |x: &f64| decode(*x).expect("finite");
            data.rationals = data.spheres.iter().map(|sphere| sphere.map(exactly)).collect();
        }
        data
    }

    /// One pass; what it computes goes to a black box.
    fn pass(&mut self, work: &str) {
        let [k, impulse, energy] = &mut self.columns;
        match work {
            "stores" => stores(&self.alpha, k, impulse, energy),
            "batch" => batch::evaluate(&WangSuLi, &self.alpha, Columns { k, impulse, energy }),
            "survey" => _ = black_box(batch::survey(&WangSuLi, &self.alpha)),
            "reads" => _ = black_box(reads(&self.alpha)),
            "decide-plain" => {
                _ = black_box(self.spheres.iter().filter(|sphere| plain(sphere)).count());
            }
            "decide-plain-checked" => {
                let slides = self.spheres.iter().filter(|sphere| plain_checked(sphere));
                _ = black_box(slides.count());
            }
            "decide" | "decide-tied" => {
                let spheres = if work == "decide" { &self.spheres } else { &self.tied };
                let slides =
                    |sphere: &&Sphere| decide::sliding(sphere).is_ok_and(|d| d.sign.is_gt());
                _ = black_box(spheres.iter().filter(slides).count());
            }
            "plain-columns" => _ = black_box(plain_columns(&self.sphere_columns)),
            "decide-columns" => {
                let [mass, radius, inertia, friction, restitution, vx, vy, omega] =
                    &self.sphere_columns;
                let spheres =
                    Spheres { mass, radius, inertia, friction, restitution, vx, vy, omega };
                _ = black_box(decide::sliding_all(spheres, &mut self.signs).is_ok());
            }
            "exact" => {
                for sphere in &self.spheres {
                    _ = black_box(wang_su_li(sphere));
                }
            }
            "exact-floats" => {
                for sphere in &self.spheres {
                    let ratios = wang_su_li(sphere).ok().flatten();
                    _ = black_box(ratios.map(|r| (r.k.to_f64(), r.impulse.to_f64())));
                }
            }
            "exact-rational" => {
                for sphere in &self.rationals {
                    _ = black_box(by_fractions(sphere));
                }
            }
            work if work.starts_with("law-f64-smith") => self.floats.pass(work, &Smith1991),
            work if work.starts_with("law-f64") => self.floats.pass(work, &WangSuLi),
            work if work.starts_with("law-rational") => self.fractions.pass(work, &WangSuLi),
            other => eprintln!("no such work: {other}"),
        }
    }
}

/// The reads and writes of the batch, with a change of sign for work.
#[inline(never)]
fn stores(alpha: &[f64], k: &mut [f64], impulse: &mut [f64], energy: &mut [f64]) {
    for (((&alpha, k), impulse), energy) in alpha.iter().zip(k).zip(impulse).zip(energy) {
        (*k, *impulse, *energy) = (-alpha, alpha.abs(), -alpha.abs());
    }
}

/// The reads of the survey.
#[inline(never)]
fn reads(alpha: &[f64]) -> u64 {
    alpha.iter().fold(0, |all, alpha| all | alpha.to_bits())
}

fn main() {
    let mut known: HashMap<String, Data> = HashMap::new();
    for line in std::io::stdin().lock().lines().map_while(Result::ok) {
        let mut words = line.split_whitespace();
        let (Some(work), Some(Ok(rows))) = (words.next(), words.next().map(str::parse)) else {
            eprintln!("expected: work rows");
            continue;
        };
        // one set of columns serves all work on columns
        let columns = ["stores", "batch", "survey", "reads"].contains(&work);
        let key = format!("{} {rows}", if columns { "columns" } else { work });
        let data = known.entry(key).or_insert_with(|| Data::of(work, rows));
        let start = Instant::now();
        data.pass(work);
        println!("{}", start.elapsed().as_nanos());
        _ = std::io::stdout().flush();
    }
}
