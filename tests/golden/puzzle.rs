//! Kane's puzzle: his double pendulum, law by law, as numbers and as a map.

use std::fmt::Write as _;

use kane_impact::bodies::{Collision, Direction, DoublePendulum, Motion, PlanarBody};
use kane_impact::laws::KaneLevinson;
use kane_impact::{Law, laws};
use kane_number::{Algebraic, Interval, Rational, Real, Rounding, parse};

fn number(text: &str) -> Rational {
    parse(text).expect("a literal")
}

/// tan(q1/2) = 3/17 and tan(q2/2) = 4/15: 20.02° and 29.86°.
fn exact_pendulum() -> DoublePendulum<Rational> {
    let direction = |text| Direction::of_half_tangent(&number(text));
    DoublePendulum {
        mass: number("1"),
        length: number("1"),
        angles: [direction("3/17"), direction("4/15")],
        before: [number("-1/10"), number("-1/5")],
        friction: number("1/2"),
        restitution: number("7/10"),
    }
}

/// 20° and 30°, in any number system that has roots: 8·c³ − 6·c − 1 = 0 for c = cos 20°, from the
/// cosine of the triple angle.
fn pendulum_in_degrees<N: Real>(friction: &str, restitution: &str) -> DoublePendulum<N> {
    let n = |text: &str| N::from_rational(&number(text));
    let root = |coefficients: &[&str]| {
        let coefficients: Vec<N> = coefficients.iter().map(|text| n(text)).collect();
        N::greatest_root(&coefficients, &n("0"), &n("1")).expect("a root in [0, 1]")
    };
    let square_root = |square: N| {
        N::greatest_root(&[-square, N::zero(), N::one()], &n("0"), &n("1")).expect("a square root")
    };
    let cos20 = root(&["-1", "-6", "0", "8"]);
    let sin20 = square_root(N::one() - cos20.square());
    let cos30 = root(&["-3", "0", "4"]);
    DoublePendulum {
        mass: N::one(),
        length: N::one(),
        angles: [Direction { cos: cos20, sin: sin20 }, Direction { cos: cos30, sin: n("1/2") }],
        before: [n("-0.1"), n("-0.2")],
        friction: n(friction),
        restitution: n(restitution),
    }
}

/// The energy ratio of Kane and Levinson's law at 20° and 30° is proved to be above one: an interval
/// that holds it, from intervals that hold the cosines.
#[test]
fn energy_rises_in_kanes_pendulum_and_intervals_prove_it() {
    for (restitution, shown) in [("0.7", 2.7576), ("0.5", 1.5875)] {
        let float = pendulum_in_degrees::<f64>("0.5", restitution).collide(&KaneLevinson);
        let float = float.expect("it collides").energy_ratio;
        assert!((float - shown).abs() < 5e-5, "{float}");
        let enclosed = pendulum_in_degrees::<Interval>("0.5", restitution).collide(&KaneLevinson);
        let enclosed = enclosed.expect("intervals decide").energy_ratio;
        assert!(enclosed.lower() > 1.0 && enclosed.upper() < 3.0, "{enclosed}");
    }
}

struct Row<'a> {
    table: &'a mut String,
    pendulum: &'a DoublePendulum<Rational>,
}

impl Row<'_> {
    fn visit(&mut self, law: &Law) {
        let exact = self.pendulum.map(|x| Algebraic::from(x.clone()));
        let cell = match exact.collide(law.over()) {
            Ok(swung) => {
                let float: f64 = swung.energy_ratio.encode(Rounding::NearestEven);
                let exact = swung.energy_ratio.to_string();
                let exact = if exact.len() > 60 { "irrational, or long".into() } else { exact };
                format!("{:.6}  {:<32} {exact}", float, swung.outcome.regime)
            }
            Err(error) => error.to_string(),
        };
        writeln!(self.table, "  {:<20} {cell}", law.info.id).expect("a string takes all");
    }
}

/// T⁺/T of every law, on the pendulum with rational directions.
#[test]
fn every_law_on_kanes_pendulum() {
    let mut table =
        String::from("T+/T of Kane's double pendulum, tan(q1/2) = 3/17, tan(q2/2) = 4/15\n");
    for (friction, restitution) in [("1/2", "7/10"), ("1/2", "1/2"), ("1/10", "1/2"), ("7/10", "1")]
    {
        writeln!(table, "\nmu = {friction}, e = {restitution}").expect("a string takes all");
        let friction = number(friction);
        let restitution = number(restitution);
        let pendulum = DoublePendulum { friction, restitution, ..exact_pendulum() };
        for law in laws() {
            Row { table: &mut table, pendulum: &pendulum }.visit(law);
        }
    }
    crate::settings().bind(|| insta::assert_snapshot!("kane-puzzle", table));
}

/// A uniform rod, half-tangent 1/2, that falls without spin and slides into its slope.
fn rod(friction: &str, restitution: &str) -> Collision<Rational> {
    let before = Motion { vx: number("-1"), vy: number("-1"), omega: number("0") };
    let direction = Direction::of_half_tangent(&number("1/2"));
    Collision {
        body: PlanarBody::rod_tip(number("1"), number("2"), &direction, before),
        other: None,
        friction: number(friction),
        restitution: number(restitution),
    }
}

struct RodRow<'a> {
    table: &'a mut String,
    rod: &'a Collision<Rational>,
}

impl RodRow<'_> {
    fn visit(&mut self, law: &Law) {
        let exact = self.rod.map(|x| Algebraic::from(x.clone()));
        let cell = match exact.collide(law.over()) {
            Ok(collided) => {
                let one = Algebraic::from(number("1"));
                let ratio = one + collided.outcome.work.total() / exact.kinetic_energy();
                format!("{:.6}  {}", ratio.to_f64(), collided.outcome.regime)
            }
            Err(error) => error.to_string(),
        };
        writeln!(self.table, "  {:<20} {cell}", law.info.id).expect("a string takes all");
    }
}

/// The rod slides towards its tip, slows down, reverses or jams.
#[test]
fn every_law_on_a_rod_tip() {
    let mut table =
        String::from("T+/T of a rod that falls on its tip, half-tangent 1/2, v = (-1, -1)\n");
    for (friction, restitution) in [("1/2", "1/2"), ("1/2", "1"), ("3/2", "1/2"), ("3/2", "1")] {
        writeln!(table, "\nmu = {friction}, e = {restitution}").expect("a string takes all");
        let rod = rod(friction, restitution);
        for law in laws() {
            RodRow { table: &mut table, rod: &rod }.visit(law);
        }
    }
    crate::settings().bind(|| insta::assert_snapshot!("rod-tip", table));
}
