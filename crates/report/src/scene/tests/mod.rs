//! What the reports say of answers that are made up, in which each number is another one.
#![allow(clippy::float_arithmetic, reason = "numbers are made up")]

use kane_impact::Impulse;
use kane_impact::bodies::{Direction, Ledger, Motion};
use kane_number::{Rational, System};
use kane_scene::simulate::{Bounce, Encounter, End, Ending};
use kane_scene::stress::Row;
use kane_scene::{
    Air, Answer, Corners, Judged, Kind, Known, Line, Mechanics, Model, OffPlane, Place, Plane,
    Quantity, Restitution, Round, Setup, Shown, Side, Spread, Terms, Tip, TipBody, Verdict, Wall,
    World,
};
use num_traits::One as _;
use serde_json::{Value, json};

use super::json::stated_rows;
use super::*;

mod rows;
mod stated;

/// A number and its text, which is another one, so that neither stands for the other.
pub(super) fn shown(n: i32) -> Shown {
    Shown { value: f64::from(n), text: format!("{n}/1") }
}

pub(super) fn round(n: i32) -> Round<Shown> {
    Round {
        mass: shown(n),
        inertia: shown(n + 1),
        radius: shown(n + 2),
        position: [shown(n + 3), shown(n + 4)],
        motion: Motion { vx: shown(n + 5), vy: shown(n + 6), omega: shown(n + 7) },
        off_plane: None,
    }
}

fn in_space(n: i32) -> Round<Shown> {
    let off = OffPlane {
        z: shown(n + 8),
        vz: shown(n + 9),
        omega_x: shown(n + 10),
        omega_y: shown(n + 11),
    };
    Round { off_plane: Some(off), ..round(n) }
}

pub(super) fn world(bodies: Vec<Round<Shown>>) -> World<Shown> {
    World {
        gravity: shown(3),
        air: None,
        walls: Vec::new(),
        planes: Vec::new(),
        bodies,
        corners: None,
        friction: shown(1),
        restitution: shown(2),
        terms: Vec::new(),
        rolling: shown(0),
    }
}

pub(super) fn bounce(
    encounter: Encounter,
    after: Round<Shown>,
    other: Option<Round<Shown>>,
) -> Bounce<Shown> {
    Bounce {
        time: shown(101),
        encounter,
        regime: "stick",
        slip: [shown(102), shown(103)],
        approach: shown(104),
        separation: shown(105),
        impulse: Impulse { tangential: shown(106), normal: shown(107) },
        ledger: Ledger { normal: shown(108), tangential: shown(109), rotational: shown(110) },
        gravity: shown(111),
        air: None,
        axes: None,
        corner: None,
        after: (after, other),
    }
}

fn end(bodies: Vec<Round<Shown>>) -> End<Shown> {
    End { time: shown(200), bodies, impacts: 7, ending: Ending::Duration, turned: None }
}

pub(super) fn model(system: System) -> Model {
    Model { mechanics: Mechanics::NormalOnly, system }
}

/// An answer by normal impulses in fractions.
pub(super) fn answer(world: World<Shown>) -> Answer {
    Answer {
        sha256: "5ce0".to_owned(),
        stated: Setup::Bodies(world),
        lines: Vec::new(),
        known: Some(Known::Exactly),
        judged: Vec::new(),
        chosen: Some(model(System::Rational)),
        wanted: None,
        shown: model(System::Rational),
        reasons: vec!["Because.".to_owned()],
        bounces: Vec::new(),
        sums: Vec::new(),
        end: None,
        start_energy: 2.5,
        picture: None,
    }
}

pub(super) fn report(answer: &Answer) -> SceneReport<'_> {
    SceneReport {
        answer,
        title: "Made up".to_owned(),
        command: "kane scene made-up.toml".to_owned(),
        is_compared: false,
    }
}

fn told(answer: &Answer) -> Value {
    serde_json::from_str(&super::json(&report(answer))).expect("JSON")
}

pub(super) fn judged(verdict: Verdict) -> Judged {
    Judged { model: model(System::Rational), cost: 5, errors: Vec::new(), ratio: None, verdict }
}

fn line(kind: Kind, body: usize) -> Line {
    Line {
        quantity: Quantity { kind, body },
        value: 0.25,
        exact: Some("1/4".to_owned()),
        error: Some(0.0),
        tolerance: 0.5,
        spread: None,
    }
}

#[test]
fn numbers_have_eight_digits_and_no_zeros_behind_them() {
    let cases = [
        (0.0, "0"),
        (-0.0, "0"),
        (1.0, "1"),
        (-2.5, "-2.5"),
        (1.0 / 3.0, "0.33333333"),
        (-2.0 / 3.0, "-0.66666667"),
        (12.345_678_912, "12.345679"),
        (1.234_567_891_2, "1.2345679"),
        (123_456.789, "123456.79"),
        (999_999.0, "999999"),
        (300.0, "300"),
        // below and above these a power of ten is told
        (0.000_1, "0.0001"),
        (0.000_09, "9.00000e-5"),
        (1e6, "1.00000e6"),
        (-1.5e9, "-1.50000e9"),
    ];
    for (value, expected) in cases {
        assert_eq!(number(value), expected);
    }
}

#[test]
fn errors_have_two_digits_and_signs_stay() {
    let cases = [
        (0.0, "0"),
        (0.001_234, "0.0012"),
        (0.012_34, "0.012"),
        (0.123_4, "0.12"),
        (1.234, "1.2"),
        (-1.234, "-1.2"),
        (12.34, "12"),
        (12_345.6, "12346"),
        (100.0, "100"),
        (0.5, "0.5"),
        (0.000_99, "9.9e-4"),
        (1e5, "1.0e5"),
        (-2.5e-7, "-2.5e-7"),
    ];
    for (value, expected) in cases {
        assert_eq!(brief(value), expected);
    }
    assert_eq!([0.0, 0.123_4, -12.0].map(small), ["0", "1.2e-1", "-1.2e1"]);
}

#[test]
fn an_error_is_told_as_surely_as_it_is_known() {
    let told = |size: f64, known| error(Some(size), Some(known));
    for sure in [Known::Exactly, Known::Enclosed] {
        assert_eq!([told(0.0, sure), told(0.25, sure)], ["none", "at most 0.25"]);
    }
    // an estimate of zero is no proof
    let documented = [0.0, 0.25].map(|size| told(size, Known::Documented));
    assert_eq!(documented, ["0, documented", "0.25, documented"]);
    let estimated = [0.0, 0.25].map(|size| told(size, Known::Estimated));
    assert_eq!(estimated, ["0, estimated", "0.25, estimated"]);
    assert_eq!(error(None, Some(Known::Exactly)), "unknown");
    assert_eq!(error(Some(0.0), None), "unknown");
    let spread = |enclosed| Some(Spread { by: 0.5, at_least: 0.1, enclosed });
    assert_eq!(
        [moved(spread(true)), moved(spread(false)), moved(None)],
        ["within ±0.5", "±0.5 at corners", ""]
    );
}

#[test]
fn a_bound_is_never_told_as_less_than_it_is() {
    // 4.44e-15 is more than 4.4e-15
    let size = 4.440_892_098_500_626e-15;
    let told = |known| error(Some(size), Some(known));
    assert_eq!(told(Known::Enclosed), "at most 4.5e-15");
    assert_eq!(told(Known::Documented), "4.5e-15, documented");
    assert_eq!(told(Known::Estimated), "4.4e-15, estimated");
    let spread = |enclosed| Some(Spread { by: 2.31, at_least: 0.1, enclosed });
    assert_eq!([moved(spread(true)), moved(spread(false))], ["within ±2.4", "±2.3 at corners"]);
    // and a tolerance is told as it was stated
    assert_eq!([0.0, 1e-9, 0.05, 20.0].map(in_full), ["0", "1.0e-9", "0.05", "20"]);
    assert_eq!([1.25e-7, 0.001_23, 150.25].map(in_full), ["1.25e-7", "0.00123", "150.25"]);
}

#[test]
fn answers_that_are_rounded_are_said_to_be() {
    let said = |value: f64, exact: Option<&str>| {
        let mut answer = answer(world(vec![round(20)]));
        let exact = exact.map(str::to_owned);
        answer.lines = vec![Line { value, exact, ..line(Kind::K, 0) }];
        let told = sheet(&report(&answer)).text(crate::sheet::Page::default());
        told.contains("Answers are rounded here")
    };
    assert!(said(1.0 / 3.0, None));
    assert!(said(0.1, None), "the float is not a tenth");
    assert!(!said(0.25, None));
    assert!(!said(1.0 / 3.0, Some("1/3")));
    // a fraction that is too long to be shown
    assert!(said(0.25, Some("1000000000000/4000000000001")));
}

#[test]
fn bodies_are_counted_from_one() {
    let (wall, pair) = (Encounter::Wall(1, Side::Left), Encounter::Pair(0, 2));
    assert_eq!(ids(wall), ["body-2", "left"]);
    assert_eq!(ids(pair), ["body-1", "body-3"]);
    assert_eq!([who(wall, 2), who(pair, 3)], ["2, left wall", "1 and 3"]);
    // the only one needs no number
    assert_eq!(who(Encounter::Wall(0, Side::Floor), 1), "floor");
}

#[test]
fn costs_that_are_estimated_are_told_as_such() {
    let of = |mechanics| {
        let model = Model { mechanics, system: System::F64 };
        cost(&Judged { model, cost: 120, errors: vec![], ratio: None, verdict: Verdict::Meets })
    };
    assert_eq!(of(Mechanics::NormalOnly), "120");
    for steps in [Mechanics::Chain, Mechanics::Compliant, Mechanics::Annuli] {
        assert_eq!(of(steps), "about 120");
    }
}

#[test]
fn what_is_said_of_a_model_has_its_reason() {
    let quantity = Quantity { kind: Kind::K, body: 0 };
    let misses = |place| verdict(&Verdict::Misses { quantity, by: 0.125, place }, None);
    assert_eq!(misses(Place::Stated), "k off by 0.12");
    assert_eq!(misses(Place::Corner), "k off by 0.12 within the uncertainty");
    assert_eq!(misses(Place::Near), "k off by 0.12 within 1%");
    let meets = |known| verdict(&Verdict::Meets, known);
    assert_eq!(meets(Some(Known::Exactly)), "good enough");
    assert_eq!(meets(Some(Known::Enclosed)), "good enough");
    assert_eq!(meets(Some(Known::Documented)), "good enough as documented");
    assert_eq!(meets(Some(Known::Estimated)), "good enough by an estimate");
    assert_eq!(verdict(&Verdict::Uncertified("too long"), None), "not certified: too long");
    assert_eq!(verdict(&Verdict::Fails("no root".to_owned()), None), "no answer: no root");
}

#[test]
fn the_headline_says_by_which_model_and_how_surely() {
    let mut answer = answer(world(vec![round(20)]));
    answer.judged = vec![judged(Verdict::Meets)];
    answer.lines = vec![line(Kind::K, 0)];
    let model = "normal-only/rational";
    let one = format!("{model}: what is asked for is within its tolerance");
    assert_eq!(report(&answer).headline(), one);
    answer.known = Some(Known::Estimated);
    assert_eq!(report(&answer).headline(), format!("{one}, by an estimate"));
    answer.known = Some(Known::Documented);
    assert_eq!(report(&answer).headline(), format!("{one}, as documented"));
    answer.known = Some(Known::Exactly);
    // the inputs move it by more than was asked: known of at least so much
    answer.lines[0].spread = Some(Spread { by: 2.0, at_least: 0.75, enclosed: true });
    assert_eq!(report(&answer).headline(), format!("{one}; the inputs leave more open"));
    answer.lines[0].spread = Some(Spread { by: 2.0, at_least: 0.25, enclosed: true });
    answer.lines.push(line(Kind::Energy, 0));
    let all = format!("{model}: all that is asked for is within its tolerance");
    assert_eq!(report(&answer).headline(), all);
}

#[test]
fn a_model_that_is_not_good_enough_is_never_told_as_one_that_is() {
    let mut answer = answer(world(vec![round(20)]));
    let model = "normal-only/rational";
    let quantity = Quantity { kind: Kind::K, body: 0 };
    let misses = Verdict::Misses { quantity, by: 1.0, place: Place::Stated };
    answer.judged = vec![judged(misses)];
    answer.chosen = None;
    answer.wanted = Some(answer.shown);
    let headline = |answer: &Answer| report(answer).headline();
    assert_eq!(headline(&answer), format!("{model}, the model asked for, is not good enough"));
    answer.judged = vec![judged(Verdict::Uncertified("why"))];
    let not_known = format!("{model}, the model asked for, is not known to be good enough");
    assert_eq!(headline(&answer), not_known);
    // that another one is good enough says nothing of this one
    answer.judged = vec![Judged { model: self::model(System::F32), ..judged(Verdict::Meets) }];
    assert_eq!(headline(&answer), not_known);
    let none = format!("no model is known to be good enough; shown is {model}");
    let compared = SceneReport { is_compared: true, ..report(&answer) };
    assert_eq!(compared.headline(), none);
    answer.wanted = None;
    assert_eq!(headline(&answer), none);
    answer.chosen = Some(self::model(System::F32));
    let other = format!("{model} is not known to be good enough; normal-only/f32 is");
    assert_eq!(headline(&answer), other);
}
