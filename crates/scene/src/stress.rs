//! Where methods fail: a list of hard inputs, each pushed step by step, with the error against the
//! exact or analytic result.
//!
//! The rows are committed in `docs/data/scene-stress.csv` and compared in every run of the tests.

mod kinks;
mod penalty;

use kane_impact::laws::{RouthNewton, WangSuLi, WhittakerUncapped};
use kane_impact::{Law, NumberSystem};
use kane_number::{Lane, Rational, power_of};

use crate::coordinate::Coordinate;
use crate::read;
use crate::resolver::NormalOnly;
use crate::round::Round;
use crate::scene::Setup;
use crate::side::Side;
use crate::simulate::{Budget, Chain, Until, collide_chain, run};
use crate::tip::{Tip, TipBody};
use crate::world::{Wall, World};

/// One measurement.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// What is hard.
    pub case: &'static str,
    /// What is pushed, in words.
    pub pushed: &'static str,
    /// How far.
    pub to: String,
    /// By which method.
    pub method: &'static str,
    /// The error, relative unless the case says otherwise; ∞ where there is no answer.
    pub error: f64,
}

/// All of them, in the order of the table; some are the worst of these laws. Deterministic; some tenths of a second.
#[must_use]
pub fn rows(laws: &[Law]) -> Vec<Row> {
    let mut rows = Vec::new();
    kinks::rows(laws, &mut rows);
    grazing(&mut rows);
    ends_of_restitution(&mut rows);
    jam(&mut rows);
    inertia(&mut rows);
    simultaneous(&mut rows);
    zeno(&mut rows);
    drift(&mut rows);
    reversal(&mut rows);
    penalty::rows(&mut rows);
    rows
}

fn integer(n: i64) -> Rational {
    Rational::from_integer(n.into())
}

fn ratio(a: i64, b: i64) -> Rational {
    Rational::new(a.into(), b.into())
}

/// The relative error, or the absolute one where the exact value is zero.
fn relative<N: Coordinate>(value: Option<&N>, exact: &Rational) -> f64 {
    let Some(value) = value.and_then(Lane::exact) else { return f64::INFINITY };
    let error = num_traits::Signed::abs(&(value - exact));
    let size = num_traits::Signed::abs(exact);
    let zero = Rational::default();
    if size == zero { error.to_f64() } else { (error / size).to_f64() }
}

/// A ball on a floor at 0 with radius 1, J = 2/5·m·r².
fn ball(
    mass: Rational,
    gyration: Rational,
    velocity: [Rational; 2],
    restitution: Rational,
) -> World<Rational> {
    let [vx, vy] = velocity;
    World {
        gravity: integer(10),
        walls: vec![Wall { side: Side::Floor, at: integer(0) }],
        air: None,
        planes: vec![],
        terms: vec![],
        corners: None,
        rolling: integer(0),
        bodies: vec![Round {
            inertia: mass.clone() * gyration,
            mass,
            radius: integer(1),
            position: [integer(0), integer(1)],
            motion: kane_impact::bodies::Motion { vx, vy, omega: integer(0) },
            off_plane: None,
        }],
        friction: ratio(1, 5),
        restitution,
    }
}

/// The body after one impact, in two number systems.
fn once<N: Coordinate + NumberSystem>(
    world: &World<Rational>,
    law: &Law,
) -> (Option<Round<N>>, Option<Round<Rational>>) {
    fn end<N: Coordinate + NumberSystem>(world: &World<N>, law: &Law) -> Option<Round<N>> {
        let end = run(world, law, &Until::Impacts(1), Budget::default(), &mut |_| {}).ok()?;
        end.bodies.into_iter().next()
    }
    (end(&world.map(N::from_rational), law), end(world, law))
}

/// Nearly along the floor: `v_y` = −`v_x`·10^−n, from 84.3° on.
fn grazing(rows: &mut Vec<Row>) {
    for power in [1, 2, 4, 8, 16] {
        let down = -power_of(10, -power);
        let world = ball(ratio(1, 3), ratio(2, 5), [ratio(1, 3), down / integer(3)], ratio(9, 10));
        let (found, exact) = once::<f64>(&world, &Law::from(RouthNewton));
        let Some(exact) = exact else { continue };
        let error = relative(found.as_ref().map(|b| &b.motion.omega), &exact.motion.omega);
        rows.push(Row {
            case: "grazing, error of the spin",
            pushed: "v_y by v_x",
            to: format!("1e-{power}"),
            method: "routh-newton/f64",
            error,
        });
    }
}

/// e = 0 and e = 1, and beside them.
fn ends_of_restitution(rows: &mut Vec<Row>) {
    for (to, e) in [
        ("0", integer(0)),
        ("1e-16", power_of(10, -16)),
        ("1 - 1e-16", integer(1) - power_of(10, -16)),
        ("1", integer(1)),
    ] {
        let world = ball(ratio(1, 3), ratio(2, 5), [ratio(1, 3), ratio(-1, 7)], e);
        let (found, exact) = once::<f64>(&world, &Law::from(RouthNewton));
        let Some(exact) = exact else { continue };
        rows.push(Row {
            case: "restitution, error of v_y",
            pushed: "e",
            to: to.to_owned(),
            method: "routh-newton/f64",
            error: relative(found.as_ref().map(|b| &b.motion.vy), &exact.motion.vy),
        });
    }
}

/// A rod's tip with the friction at which it jams, and a little less: sliding needs an impulse
/// that grows without bound, and then has none; the process has one all the time.
fn jam(rows: &mut Vec<Row>) {
    // cos = 3/5, sin = 4/5: W_nn − μ·W_tn = 1 + 12·x² − μ·12·x·y with x = 3/10, y = 2/5 has its zero
    // at μ = 13/9
    let critical = ratio(13, 9);
    for power in [1, 4, 8, 12] {
        for below in [true, false] {
            let share = if below {
                integer(1) - power_of(10, -power)
            } else {
                integer(1) + power_of(10, -power)
            };
            let tip = Tip {
                body: TipBody::Rod {
                    mass: integer(1),
                    length: integer(1),
                    direction: kane_impact::bodies::Direction {
                        cos: ratio(3, 5),
                        sin: ratio(4, 5),
                    },
                    motion: kane_impact::bodies::Motion {
                        vx: integer(-100_000),
                        vy: integer(-1),
                        omega: integer(0),
                    },
                },
                friction: &critical * share,
                restitution: ratio(1, 2),
            };
            let mut measure = |method, error| {
                rows.push(Row {
                    case: "jam, error of p_n",
                    pushed: "mu from its critical value by",
                    to: format!("{}1e-{power}", if below { "-" } else { "+" }),
                    method,
                    error,
                });
            };
            measure("whittaker-uncapped/f64", tip_error(&tip, &Law::from(WhittakerUncapped)));
            measure("routh-newton/f64", tip_error(&tip, &Law::from(RouthNewton)));
        }
    }
}

fn tip_error(tip: &Tip<Rational>, law: &Law) -> f64 {
    let Ok((exact, _)) = tip.contact() else { return f64::INFINITY };
    let Ok((contact, _)) = tip.map(Lane::to_f64).contact() else { return f64::INFINITY };
    let found = law.over().impulse(&contact).ok().map(|impulse| impulse.normal);
    match law.over().impulse(&exact) {
        Ok(exact) => relative(found.as_ref(), &exact.normal),
        Err(_) => f64::INFINITY,
    }
}

/// J = m·r²·10^−n: the spin of a body without inertia.
fn inertia(rows: &mut Vec<Row>) {
    for power in [2, 8, 16, 100] {
        let world =
            ball(ratio(1, 3), power_of(10, -power), [ratio(1, 3), ratio(-1, 7)], ratio(9, 10));
        for (method, (found, exact)) in [
            ("routh-newton/f64", once::<f64>(&world, &Law::from(RouthNewton))),
            ("wang-su-li/f64", once::<f64>(&world, &Law::from(WangSuLi))),
        ] {
            let Some(exact) = exact else { continue };
            rows.push(Row {
                case: "vanishing inertia, error of the spin",
                pushed: "J by m*r^2",
                to: format!("1e-{power}"),
                method,
                error: relative(found.as_ref().map(|b| &b.motion.omega), &exact.motion.omega),
            });
        }
    }
}

/// Three spheres, the last two nearly touching: one impact after the other against the chain of
/// springs, the greatest difference of a velocity, by the striker's.
fn simultaneous(rows: &mut Vec<Row>) {
    for power in [0, 9, 8, 7, 6, 5, 4, 3] {
        let gap = if power == 0 { 0.0 } else { power_of(10, -power).to_f64() };
        let chain = Chain {
            masses: vec![0.1; 3],
            gaps: vec![0.01, gap],
            velocities: vec![1.0, 0.0, 0.0],
            stiffness: 1e10,
        };
        let error = collide_chain(&chain, 256).map_or(f64::INFINITY, |after| {
            let pairwise = [0.0, 0.0, 1.0];
            let far = after.iter().zip(pairwise).map(|(a, b)| (a - b).abs());
            let far = far.fold(0.0, f64::max);
            // finer than the integration itself errs
            if far < 1e-6 { 1e-6 } else { far }
        });
        let to = if power == 0 { "0".to_owned() } else { format!("1e-{power}") };
        rows.push(Row {
            case: "nearly simultaneous, difference of velocities",
            pushed: "gap, m",
            to,
            method: "normal-only against chain",
            error,
        });
    }
}

/// e close to 1: the time to rest, in closed form and by following a thousand impacts.
fn zeno(rows: &mut Vec<Row>) {
    for power in [1, 2, 4, 8, 12] {
        let e = integer(1) - power_of(10, -power);
        let mut world = ball(integer(1), ratio(2, 5), [integer(0), integer(0)], e);
        world.bodies[0].position[1] = ratio(9, 4);
        let rest = |shown| Budget { shown, ..Budget::default() };
        let Ok(exact) = run(&world, &NormalOnly, &Until::Rest, rest(1), &mut |_| {}) else {
            continue;
        };
        let float = world.map(Lane::to_f64);
        let summed = run(&float, &NormalOnly, &Until::Rest, rest(1), &mut |_| {}).ok();
        let followed = run(&float, &NormalOnly, &Until::Impacts(1_000), rest(1), &mut |_| {}).ok();
        for (method, end) in [("closed form/f64", summed), ("1000 impacts/f64", followed)] {
            rows.push(Row {
                case: "Zeno, error of the time to rest",
                pushed: "1 - e",
                to: format!("1e-{power}"),
                method,
                error: relative(end.as_ref().map(|end| &end.time), &exact.time),
            });
        }
    }
}

/// A ball that rolls and loses nothing: n flights of the same length.
fn drift(rows: &mut Vec<Row>) {
    for power in [2, 4, 6] {
        for (method, error) in [("f32", bounced::<f32>(power)), ("f64", bounced::<f64>(power))] {
            rows.push(Row {
                case: "drift, error of the time",
                pushed: "bounces",
                to: format!("1e{power}"),
                method,
                error,
            });
        }
    }
}

fn bounced<N: Coordinate + NumberSystem>(power: u32) -> f64 {
    let mut world = ball(ratio(1, 3), ratio(2, 5), [ratio(1, 3), ratio(-1, 3)], integer(1));
    world.gravity = ratio(981, 100);
    let count = 10_u64.pow(power);
    let budget = Budget { impacts: count, ..Budget::default() };
    let law = Law::from(RouthNewton);
    let until = Until::Impacts(count);
    let end = run(&world.map(N::from_rational), &law, &until, budget, &mut |_| {}).ok();
    // it starts on the floor, so that the first impact is at once
    let flight = ratio(2, 3) / ratio(981, 100);
    let exact = flight * Rational::from_integer((count - 1).into());
    relative(end.as_ref().map(|end| &end.time), &exact)
}

/// Discs in a box, frictionless and without loss.
pub const DISCS: &str = "
friction = 0
restitution = 1
floor_m = 0
left_m = 0
right_m = 2
ceiling_m = 1

[discs]
columns = 10
rows = 5
mass_kg = 0.01
radius_m = 0.06
spacing_m = 0.2
speed_m_s = 1

[until]
impacts = 1

[ask]
kinetic_energy_j = 0
";

/// The box of discs, in floats.
///
/// # Panics
/// Never: the text is constant and tested.
#[must_use]
pub fn box_of_discs() -> World<f64> {
    let scene = read::scene("discs", DISCS).expect("the text is well formed");
    match scene.nominal() {
        Setup::Bodies(world) => world.map(Lane::to_f64),
        Setup::Tip(_) => unreachable!("the text has discs"),
    }
}

/// How far from their places the bodies are, at worst, after so many impacts and as many back, in
/// metres; ∞ if the motion cannot be followed.
#[must_use]
pub fn there_and_back(world: &World<f64>, impacts: u64) -> f64 {
    let budget = Budget { impacts: u64::MAX, ..Budget::default() };
    let law = NormalOnly;
    let Ok(there) = run(world, &law, &Until::Impacts(impacts), budget, &mut |_| {}) else {
        return f64::INFINITY;
    };
    let mut back = World { bodies: there.bodies, ..world.clone() };
    for body in &mut back.bodies {
        let motion = &mut body.motion;
        (motion.vx, motion.vy, motion.omega) = (-motion.vx, -motion.vy, -motion.omega);
    }
    let Ok(back) = run(&back, &law, &Until::Duration(there.time), budget, &mut |_| {}) else {
        return f64::INFINITY;
    };
    let far = back.bodies.iter().zip(&world.bodies).map(|(a, b)| {
        (a.position[0] - b.position[0]).abs().max((a.position[1] - b.position[1]).abs())
    });
    far.fold(0.0, f64::max)
}

/// Velocities turned round: the error grows by a factor with every collision of a disc.
fn reversal(rows: &mut Vec<Row>) {
    let discs = box_of_discs();
    for each in [1, 2, 4, 6, 8, 10, 14, 18, 24] {
        rows.push(Row {
            case: "reversal of 50 discs, m",
            pushed: "impacts of a disc",
            to: format!("{each}"),
            method: "f64",
            // an impact of two discs counts for both; walls make it a little less
            error: there_and_back(&discs, 25 * each),
        });
    }
}
