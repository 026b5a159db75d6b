//! No error that anyone finds is above the bound: random formulas, against an oracle that shares no code
//! with the bounds. The oracle has its own trees, its own float evaluation, and exact rational values; roots
//! are enclosed by integer square roots of 400 bits.

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    reason = "inputs are drawn, it does not matter which"
)]

use kane_floats::rigor::{Budget, Goal, Inputs, bounded};
use kane_floats::{Machine, fpcore};
use kane_number::{Integer, Rational, decode};
use num_traits::Float;

/// The generator `splitmix64`.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    fn below(&mut self, n: u64) -> u64 {
        self.next() % n
    }
}

#[derive(Clone, Debug)]
enum Tree {
    Number(&'static str),
    Input(usize),
    Neg(Box<Tree>),
    Abs(Box<Tree>),
    Sqrt(Box<Tree>),
    Two(&'static str, Box<Tree>, Box<Tree>),
    Fma(Box<Tree>, Box<Tree>, Box<Tree>),
    If(Box<Tree>, Box<Tree>, Box<Tree>, Box<Tree>),
}

const NUMBERS: [&str; 10] = ["1", "2", "3", "0.1", "1/3", "-1", "0.5", "100", "-2.7", "1e-3"];
const NAMES: [&str; 2] = ["x", "y"];

fn tree(random: &mut Random, inputs: usize, depth: u32) -> Tree {
    let sub = |random: &mut Random| Box::new(tree(random, inputs, depth - 1));
    if depth == 0 {
        return match random.below(3) {
            0 => Tree::Number(NUMBERS[random.below(10) as usize]),
            _ => Tree::Input(random.below(inputs as u64) as usize),
        };
    }
    match random.below(16) {
        0 => Tree::Neg(sub(random)),
        1 => Tree::Abs(sub(random)),
        2 | 3 => Tree::Sqrt(sub(random)),
        4 => Tree::Fma(sub(random), sub(random), sub(random)),
        5 => Tree::If(sub(random), sub(random), sub(random), sub(random)),
        6 => Tree::Two("fmin", sub(random), sub(random)),
        7..=9 => Tree::Two("-", sub(random), sub(random)),
        10..=11 => Tree::Two("+", sub(random), sub(random)),
        12..=13 => Tree::Two("*", sub(random), sub(random)),
        14 => Tree::Two("/", sub(random), sub(random)),
        _ => Tree::Input(random.below(inputs as u64) as usize),
    }
}

impl Tree {
    fn text(&self) -> String {
        match self {
            Self::Number(text) => (*text).to_owned(),
            Self::Input(index) => NAMES[*index].to_owned(),
            Self::Neg(a) => format!("(- {})", a.text()),
            Self::Abs(a) => format!("(fabs {})", a.text()),
            Self::Sqrt(a) => format!("(sqrt {})", a.text()),
            Self::Two(name, a, b) => format!("({name} {} {})", a.text(), b.text()),
            Self::Fma(a, b, c) => format!("(fma {} {} {})", a.text(), b.text(), c.text()),
            Self::If(a, b, c, d) => {
                format!("(if (< {} {}) {} {})", a.text(), b.text(), c.text(), d.text())
            }
        }
    }

    /// The value in a format, in which numbers are read by `read`.
    fn value<F: Float>(&self, at: &[F], read: fn(&str) -> F) -> F {
        let of = |tree: &Self| tree.value(at, read);
        match self {
            Self::Number(text) => read(text),
            Self::Input(index) => at[*index],
            Self::Neg(a) => -of(a),
            Self::Abs(a) => of(a).abs(),
            Self::Sqrt(a) => of(a).sqrt(),
            Self::Two(name, a, b) => {
                let (a, b) = (of(a), of(b));
                match *name {
                    "+" => a + b,
                    "-" => a - b,
                    "*" => a * b,
                    "/" => a / b,
                    _ => a.min(b),
                }
            }
            Self::Fma(a, b, c) => of(a).mul_add(of(b), of(c)),
            Self::If(a, b, c, d) => {
                if of(a) < of(b) {
                    of(c)
                } else {
                    of(d)
                }
            }
        }
    }

    /// The exact value within the two rationals; `None` where there is none or the oracle cannot tell.
    fn exact(&self, at: &[Rational]) -> Option<(Rational, Rational)> {
        let zero = || Rational::from_integer(0.into());
        Some(match self {
            Self::Number(text) => {
                let number = kane_number::parse(text).expect("a number");
                (number.clone(), number)
            }
            Self::Input(index) => (at[*index].clone(), at[*index].clone()),
            Self::Neg(a) => {
                let (l, u) = a.exact(at)?;
                (-u, -l)
            }
            Self::Abs(a) => {
                let (l, u) = a.exact(at)?;
                if l >= zero() {
                    (l, u)
                } else if u <= zero() {
                    (-u, -l)
                } else {
                    (zero(), u.max(-l))
                }
            }
            Self::Sqrt(a) => {
                let (l, u) = a.exact(at)?;
                if l < zero() {
                    return None;
                }
                let root = |x: &Rational, up: bool| {
                    let scaled = (x.numer() << 800_u32) / x.denom();
                    let root = scaled.sqrt();
                    let root = if up { root + 1 } else { root };
                    Rational::new(root, Integer::from(1) << 400_u32)
                };
                let exact_root = |x: &Rational| {
                    let (n, d) = (x.numer().sqrt(), x.denom().sqrt());
                    (&n * &n == *x.numer() && &d * &d == *x.denom()).then(|| Rational::new(n, d))
                };
                match (l == u).then(|| exact_root(&l)).flatten() {
                    Some(root) => (root.clone(), root),
                    None => (root(&l, false), root(&u, true)),
                }
            }
            Self::Two(name, a, b) => {
                let ((al, au), (bl, bu)) = (a.exact(at)?, b.exact(at)?);
                match *name {
                    "+" => (al + bl, au + bu),
                    "-" => (al - bu, au - bl),
                    "*" => product(&(al, au), &(bl, bu)),
                    "/" => {
                        if bl <= zero() && bu >= zero() {
                            return None;
                        }
                        let one = Rational::from_integer(1.into());
                        product(&(al, au), &(&one / bu, &one / bl))
                    }
                    _ => (al.min(bl), au.min(bu)),
                }
            }
            Self::Fma(a, b, c) => {
                let ((l, u), (cl, cu)) = (product(&a.exact(at)?, &b.exact(at)?), c.exact(at)?);
                (l + cl, u + cu)
            }
            Self::If(a, b, c, d) => {
                let ((al, au), (bl, bu)) = (a.exact(at)?, b.exact(at)?);
                if au < bl {
                    c.exact(at)?
                } else if al >= bu {
                    d.exact(at)?
                } else {
                    return None;
                }
            }
        })
    }
}

fn product(a: &(Rational, Rational), b: &(Rational, Rational)) -> (Rational, Rational) {
    let all = [&a.0 * &b.0, &a.0 * &b.1, &a.1 * &b.0, &a.1 * &b.1];
    (all.iter().min().expect("four").clone(), all.iter().max().expect("four").clone())
}

/// A literal as the machine's own reader rounds it; quotients are exact to the nearest by one division.
fn literal(text: &str) -> f64 {
    match text.split_once('/') {
        Some((a, b)) => a.parse::<f64>().expect("a number") / b.parse::<f64>().expect("a number"),
        None => text.parse().expect("a number"),
    }
}

fn single(text: &str) -> f32 {
    match text.split_once('/') {
        Some((a, b)) => a.parse::<f32>().expect("a number") / b.parse::<f32>().expect("a number"),
        None => text.parse().expect("a number"),
    }
}

const ENDS: [&str; 14] = [
    "-1000", "-10", "-1", "-0.1", "-1e-9", "0", "1e-12", "1e-3", "0.5", "1", "1.5", "7", "100",
    "1e6",
];

#[derive(Default, Debug)]
struct Tally {
    formulas: usize,
    bounded: usize,
    tried: usize,
    compared: usize,
}

/// Random formulas from a seed, each at so many inputs; no error may exceed the bound.
fn run(seed: u64, formulas: usize, inputs_each: usize, cells: usize) -> Tally {
    let mut random = Random(seed);
    let mut tally = Tally::default();
    for _ in 0..formulas {
        let count = 1 + random.below(2) as usize;
        let depth = 2 + random.below(3) as u32;
        let tree = tree(&mut random, count, depth);
        let ranges: Vec<(usize, usize)> = (0..count)
            .map(|_| {
                let (a, b) = (random.below(14) as usize, random.below(14) as usize);
                (a.min(b), a.max(b))
            })
            .collect();
        let pre: Vec<String> = ranges
            .iter()
            .zip(NAMES)
            .map(|((a, b), name)| format!("(<= {} {name} {})", ENDS[*a], ENDS[*b]))
            .collect();
        let names = NAMES[..count].join(" ");
        let text = format!("(FPCore ({names}) :pre (and {}) {})", pre.join(" "), tree.text());
        let core = &fpcore::read("random", &text).expect("it is well formed")[0];
        tally.formulas += 1;
        let budget = Budget { cells, ratio: 1.05 };
        let narrow = random.below(2) == 0;
        for goal in [Goal::Absolute, Goal::Ulps] {
            let found = if narrow {
                bounded::<f32>(core, Inputs::Floats, goal, budget)
            } else {
                bounded::<f64>(core, Inputs::Floats, goal, budget)
            };
            let Ok(found) = found else { continue };
            if !found.bound.is_finite() {
                continue;
            }
            tally.bounded += 1;
            for turn in 0..inputs_each {
                let mut point = Vec::new();
                for (a, b) in &ranges {
                    let (low, high) = (literal(ENDS[*a]), literal(ENDS[*b]));
                    let part = random.next() as f64 / u64::MAX as f64;
                    let mut x = match turn % 4 {
                        0 => low + (high - low) * part,
                        // near an end
                        1 => low + (high - low) * part.powi(12),
                        2 => high - (high - low) * part.powi(12),
                        // near the worst boxes
                        _ => found.worst.first().map_or(low, |cell| {
                            let (low, high) = cell.ends[point.len().min(cell.ends.len() - 1)];
                            low + (high - low) * part
                        }),
                    };
                    if narrow {
                        x = f64::from(x as f32);
                    }
                    point.push(x.clamp(low, high));
                }
                tally.tried += 1;
                let inside = point.iter().zip(&ranges).all(|(x, (a, b))| {
                    let x = decode(*x).expect("it is finite");
                    kane_number::parse(ENDS[*a]).expect("it is finite") <= x
                        && x <= kane_number::parse(ENDS[*b]).expect("it is finite")
                });
                let singles: Vec<f32> = point.iter().map(|x| *x as f32).collect();
                if !inside
                    || (narrow && singles.iter().zip(&point).any(|(s, x)| f64::from(*s) != *x))
                {
                    continue;
                }
                let exact: Vec<Rational> =
                    point.iter().map(|x| decode(*x).expect("it is finite")).collect();
                let computed = if narrow {
                    f64::from(tree.value(&singles, single))
                } else {
                    tree.value(&point, literal)
                };
                let Some((lower, upper)) = tree.exact(&exact) else { continue };
                assert!(computed.is_finite(), "{text} gives {computed} at {point:?}");
                tally.compared += 1;
                let computed = decode(computed).expect("it is finite");
                // the error is at least its distance from the enclosure
                let error = (&lower - &computed).max(&computed - &upper);
                let least = if lower.numer().sign() == upper.numer().sign() {
                    lower.clone().max(-upper.clone()).min((-lower).max(upper))
                } else {
                    continue;
                };
                let unit = if narrow {
                    kane_number::ulp::<f32>(&least)
                } else {
                    kane_number::ulp::<f64>(&least)
                };
                let measured = if goal == Goal::Absolute { error } else { error / unit };
                let bound = decode(found.bound).expect("it is finite");
                assert!(
                    measured <= bound,
                    "{text}: {goal:?} {} at {point:?} in {} is beyond {:e}",
                    <f64 as Machine>::nearest(kane_number::encode(
                        &measured,
                        kane_number::Rounding::Down
                    )),
                    if narrow { "f32" } else { "f64" },
                    found.bound
                );
            }
        }
    }
    tally
}

#[test]
fn no_error_is_above_the_bound() {
    let tally = run(1, 150, 40, 120);
    assert!(tally.bounded > 100 && tally.compared > 3_000, "{tally:?}");
}

/// The long run: `cargo test --release -p kane-floats --test soundness -- --ignored --nocapture`.
#[test]
#[ignore = "takes minutes"]
fn no_error_of_ten_thousand_formulas_is_above_the_bound() {
    let tally = run(20, 10_000, 400, 600);
    println!("{tally:?}");
    assert!(tally.bounded > 8_000 && tally.compared > 1_000_000, "{tally:?}");
}
