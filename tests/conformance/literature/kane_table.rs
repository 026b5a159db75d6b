//! Kane's double pendulum: what eight laws make of its energy.
//!
//! Two equal rods, m = l = 1, at 20° and 30° from the vertical, u = (−0.1, −0.2) rad/s. Source: T. R.
//! Kane (1984) and T. R. Kane and D. A. Levinson (1985), data as usually quoted in the literature
//! on the puzzle, originals not consulted; the numbers under the laws are this project's own
//! reference values, computed from the laws' closed forms before this code was written.

use kane::impact::bodies::{Direction, DoublePendulum, Swung};
use kane::impact::laws::{
    ChatterjeeRuina, KaneLevinson, Keller1986, RouthNewton, Smith1991, Stronge1990, WangSuLi,
    WhittakerStop, WhittakerUncapped,
};
use kane::impact::{Law, Ratios};
use kane::number::{Number, Rational};

use super::{assert_printed, exact};

fn pendulum(e: f64, mu: f64) -> DoublePendulum<f64> {
    let direction = |degrees: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        Direction { cos, sin }
    };
    DoublePendulum {
        mass: 1.0,
        length: 1.0,
        angles: [direction(20.0), direction(30.0)],
        before: [-0.1, -0.2],
        friction: mu,
        restitution: e,
    }
}

fn swing(law: &Law, e: f64, mu: f64) -> Swung<f64> {
    pendulum(e, mu)
        .collide(law.over())
        .unwrap_or_else(|error| unreachable!("{}: {error}", law.info.id))
}

fn ratio(law: &Law, e: f64, mu: f64) -> f64 {
    swing(law, e, mu).energy_ratio
}

fn ratios(law: &Law, e: f64, mu: f64) -> Ratios<f64> {
    let contact = pendulum(e, mu).contact().expect("a contact");
    swing(law, e, mu).outcome.ratios(&contact).expect("a slip and friction")
}

fn share(e_t: &str) -> Law {
    Law::from(ChatterjeeRuina { restitution: exact(e_t) })
}

#[test]
fn the_contact_is_as_printed() {
    let pendulum = pendulum(0.7, 0.5);
    let contact = pendulum.contact().expect("a contact");
    let w = contact.delassus();
    assert_printed("W_tt", *w.tt(), "2.440338");
    assert_printed("W_tn", *w.tn(), "1.521309");
    assert_printed("W_nn", *w.nn(), "1.009560");
    assert_printed("W_tn/W_tt", w.tn() / w.tt(), "0.6234");
    assert_printed("W_nn/W_tn", w.nn() / w.tn(), "0.6636");
    assert_printed("v_t", *contact.slip(), "-0.267174");
    assert_printed("v_n", -contact.approach(), "-0.134202");
    assert_printed("T", pendulum.kinetic_energy(), "0.02318141");
}

/// e, μ, the branch of Kane and Levinson, and T⁺/T under each law.
const TABLE: [(&str, &str, &str, [&str; 8]); 6] = [
    (
        "0.5",
        "0.1",
        "slide back",
        ["0.7789", "0.6638", "0.6778", "0.6575", "0.6605", "0.6655", "0.6891", "0.6638"],
    ),
    (
        "0.5",
        "0.5",
        "stick",
        ["1.5875", "0.5624", "0.7372", "0.5451", "0.5532", "0.5668", "0.6250", "0.5624"],
    ),
    (
        "0.5",
        "0.7",
        "stick",
        ["1.5875", "0.5358", "1.5875", "0.5169", "0.5258", "0.5405", "0.6027", "0.5358"],
    ),
    (
        "0.7",
        "0.3",
        "slide back",
        ["1.1992", "0.6799", "0.7868", "0.6258", "0.6486", "0.6949", "0.7476", "0.6799"],
    ),
    (
        "0.7",
        "0.5",
        "slide back",
        ["2.7576", "0.6365", "0.9930", "0.5717", "0.6001", "0.6542", "0.7196", "0.6365"],
    ),
    (
        "1.0",
        "0.7",
        "stick",
        ["6.3500", "0.7724", "6.3500", "0.5718", "0.6663", "0.8343", "0.9062", "0.7724"],
    ),
];

#[test]
fn the_energy_ratios_are_met_to_their_printed_digits() {
    for (e, mu, branch, printed) in TABLE {
        let at = format!("e = {e}, μ = {mu}");
        let [e, mu] = [e, mu].map(|x| f64::from_rational(&exact(x)));
        let found = [
            ratio(&Law::from(KaneLevinson), e, mu),
            ratio(&Law::from(WhittakerUncapped), e, mu),
            ratio(&Law::from(RouthNewton), e, mu),
            ratio(&Law::from(Keller1986), e, mu),
            ratio(&Law::from(Stronge1990), e, mu),
            ratio(&Law::from(Smith1991), e, mu),
            ratio(&Law::from(WangSuLi), e, mu),
            ratio(&share("0"), e, mu),
        ];
        let laws = [
            "Kane-Levinson",
            "Whittaker",
            "Routh",
            "Keller",
            "Stronge",
            "Smith",
            "paper",
            "Chatterjee-Ruina",
        ];
        for ((law, found), printed) in laws.iter().zip(found).zip(printed) {
            assert_printed(&format!("{law} at {at}"), found, printed);
        }
        assert_eq!(swing(&Law::from(KaneLevinson), e, mu).outcome.regime, branch, "{at}");
        for e_t in ["1/2", "1"] {
            assert_printed(&format!("e_t = {e_t} at {at}"), ratio(&share(e_t), e, mu), printed[7]);
        }
    }
}

#[test]
fn the_case_of_seven_tenths_and_one_half_in_detail() {
    let (e, mu) = (0.7, 0.5);
    let swung = swing(&Law::from(KaneLevinson), e, mu);
    assert_printed("Kane-Levinson, p_t", swung.outcome.impulse.tangential, "-0.458292");
    assert_printed("Kane-Levinson, p_n", swung.outcome.impulse.normal, "0.916585");
    assert_printed("Kane-Levinson, u1", swung.after[0], "-0.4430");
    assert_printed("Kane-Levinson, u2", swung.after[1], "0.4909");
    assert_printed("Kane-Levinson, ΔT", swung.outcome.work.total(), "0.040744");
    let stick = swing(&Law::from(KaneLevinson), 0.5, 0.5);
    assert_printed("Kane-Levinson at e = 0.5, u1", stick.after[0], "-0.3346");
    assert_printed("Kane-Levinson at e = 0.5, u2", stick.after[1], "0.3631");

    let routh = swing(&Law::from(RouthNewton), e, mu).outcome;
    assert_printed("Routh, p_t", routh.impulse.tangential, "-0.063010");
    assert_printed("Routh, p_n", routh.impulse.normal, "0.320934");
    assert_printed("Routh, slip", routh.slip, "0.0673");

    let approach = *pendulum(e, mu).contact().expect("a contact").approach();
    let keller = swing(&Law::from(Keller1986), e, mu).outcome;
    assert_printed("Keller, p_t", keller.impulse.tangential, "0.033017");
    assert_printed("Keller, p_n", keller.impulse.normal, "0.128879");
    assert_printed("Keller, separation", keller.separation, "0.04614");
    assert_printed("Keller, Newton's e", keller.separation / approach, "0.344");

    let stronge = swing(&Law::from(Stronge1990), e, mu).outcome;
    assert_printed("Stronge, p_t", stronge.impulse.tangential, "0.025207");
    assert_printed("Stronge, p_n", stronge.impulse.normal, "0.144499");
    assert_printed("Stronge, separation", stronge.separation, "0.05003");
    assert_printed("Stronge, Newton's e", stronge.separation / approach, "0.373");

    let paper = ratios(&Law::from(WangSuLi), e, mu);
    assert_printed("the paper's i", paper.impulse, "0.348");
    assert_printed("the paper's k", paper.k, "-0.304");
    let smith = ratios(&Law::from(Smith1991), e, mu);
    assert_printed("Smith's i", smith.impulse, "0.816");
    assert_printed("Smith's k", smith.k, "-0.318");
}

/// The ends of the interval that rounds to a printed threshold: energy falls at the lower end and
/// rises at the upper one, or the other way round would show.
#[track_caller]
fn crosses(printed: &str, gains: impl Fn(f64) -> f64) {
    let places = printed.split_once('.').map_or(0, |(_, digits)| digits.len());
    let half = (0..places).fold(0.5, |unit, _| unit / 10.0);
    let threshold = f64::from_rational(&exact(printed));
    let (below, above) = (gains(threshold - half), gains(threshold + half));
    assert!(below <= 1.0 && above >= 1.0, "{printed}: T⁺/T is {below} below and {above} above");
}

#[test]
fn the_thresholds_of_kane_and_levinson_are_as_printed() {
    // friction large enough to stick
    crosses("0.3968", |e| ratio(&Law::from(KaneLevinson), e, 10.0));
    for (e, printed) in [
        (0.4, "0.302"),
        (0.5, "0.274"),
        (0.6, "0.241"),
        (0.7, "0.201"),
        (0.8, "0.151"),
        (0.9, "0.087"),
    ] {
        crosses(printed, |mu| ratio(&Law::from(KaneLevinson), e, mu));
        let mu = f64::from_rational(&exact(printed));
        assert_eq!(swing(&Law::from(KaneLevinson), e, mu).outcome.regime, "slide back");
    }
    for mu in [1e-6, 1e-3, 0.1] {
        assert!(ratio(&Law::from(KaneLevinson), 1.0, mu) > 1.0, "elastic, μ = {mu}");
    }
    for step in 0..=200 {
        let mu = f64::from(step) / 100.0;
        assert!(ratio(&Law::from(KaneLevinson), 0.3967, mu) <= 1.0, "no gain at μ = {mu}");
    }
}

#[test]
fn the_friction_that_sticks_is_as_printed() {
    for (e, printed) in [(0.5, "0.431"), (0.7, "0.515"), (1.0, "0.558")] {
        let outcome = swing(&Law::from(KaneLevinson), e, 10.0).outcome;
        assert_eq!(outcome.regime, "stick");
        let ratio = outcome.impulse.tangential.abs() / outcome.impulse.normal;
        assert_printed(&format!("the sticking ratio at e = {e}"), ratio, printed);
    }
}

/// The same pendulum with rational directions, half-angles of tangents 3/17 and 4/15 (20.02° and
/// 29.86°): the gain of energy is a fraction that anyone can check.
#[test]
fn the_gain_of_energy_is_an_exact_fraction() {
    let direction = |tangent| Direction::of_half_tangent(&exact(tangent));
    let pendulum = |e| DoublePendulum {
        mass: Rational::one(),
        length: Rational::one(),
        angles: [direction("3/17"), direction("4/15")],
        before: [exact("-1/10"), exact("-1/5")],
        friction: exact("1/2"),
        restitution: exact(e),
    };
    for (e, regime, fraction, printed) in [
        ("7/10", "slide back", "549884011284288952537/195739873092464669800", "2.80926"),
        ("1/2", "stick", "122613978368476809/75165698626188512", "1.63125"),
    ] {
        let swung = pendulum(e).collide(&KaneLevinson).expect("an answer");
        assert_eq!(swung.outcome.regime, regime);
        assert_eq!(swung.energy_ratio, exact(fraction));
        assert!(super::rounds_to(swung.energy_ratio.clone(), printed), "{fraction} is {printed}");
        assert!(swung.energy_ratio > Rational::one(), "this is Kane's puzzle");
    }
}

#[test]
fn what_is_said_of_whittakers_forms_on_kanes_pendulum_holds() {
    // Wang, Su and Li take the form without a stop for Kane's puzzle
    let uncapped = ratio(&Law::from(WhittakerUncapped), 0.5, 0.5);
    assert!((uncapped - 0.5624).abs() < 5e-5, "{uncapped}");
    // the form with a stop asks no cone: without any friction it stops the slip, and gains energy
    let stopped = ratio(&Law::from(WhittakerStop), 0.5, 0.0);
    assert!((stopped - 1.587).abs() < 5e-4, "{stopped}");
    assert!(Law::from(WhittakerStop).info.caveat.is_some());
}
