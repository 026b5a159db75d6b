//! What the pictures of a scene show, read as their reader reads them.
#![allow(clippy::float_arithmetic, reason = "a picture has a scale")]

use kane_number::System;
use kane_scene::simulate::Encounter;
use kane_scene::{Bounced, Frame, Judged, Known, Mechanics, Model, Side, Strobe, Verdict};

use super::tests::{answer, bounce, judged, model, report, round, shown, world};
use super::*;
use crate::picture::seen::Seen;

type Metres = (f64, f64);

/// One ball of radius 1/2 m, from (0, 1) by (2, 2) to (4, 3), that turns by a quarter each time.
fn strobe() -> Strobe {
    let quarter = std::f64::consts::FRAC_PI_2;
    let frame = |time: f64, centre, angle| Frame { time, bodies: vec![(centre, angle)] };
    Strobe {
        frames: vec![
            frame(0.0, [0.0, 1.0], 0.0),
            frame(0.25, [2.0, 2.0], quarter),
            frame(0.5, [4.0, 3.0], 2.0 * quarter),
        ],
        apart: 0.25,
        shows_impacts: false,
        paths: vec![vec![[0.0, 1.0], [2.0, 2.0], [4.0, 3.0]]],
        is_in_space: false,
        leaving: Vec::new(),
        radii: vec![0.5],
        corners: Vec::new(),
        walls: Vec::new(),
        planes: Vec::new(),
    }
}

fn drawn_motion(strobe: &Strobe) -> String {
    let answer = answer(world(vec![round(20)]));
    motion_picture::motion_picture(&report(&answer), strobe)
}

/// Pixels of a metre, by the bar and what is written above it.
fn pixels(seen: &Seen) -> f64 {
    let bar = seen.lines().iter().find(|line| {
        let ys: Vec<f64> = line.points.iter().map(|at| at.1).collect();
        line.points.len() == 6 && ys.contains(&20.0) && ys.contains(&28.0)
    });
    let bar = &bar.expect("a bar").points;
    let (left, right) = (bar[0].0, bar[5].0);
    let told = ["0.1 m", "0.2 m", "0.5 m", "1 m", "2 m", "5 m", "10 m"];
    let found = told.iter().find_map(|words| Some((words, seen.place(words)?)));
    let (words, (at, _)) = found.expect("a length");
    assert_eq!(at, left, "the length stands at the bar");
    (right - left) / words.trim_end_matches(" m").parse::<f64>().expect("a number")
}

/// How far a place is from another one: to the right and up, to a hundredth of a metre.
fn metres(seen: &Seen, from: (f64, f64), to: (f64, f64)) -> Metres {
    let by = pixels(seen);
    let rounded = |length: f64| (100.0 * length).round() / 100.0 + 0.0;
    (rounded((to.0 - from.0) / by), rounded((from.1 - to.1) / by))
}

#[test]
fn a_body_stands_where_it_is_and_is_as_large_as_it_is() {
    let seen = Seen::of(&drawn_motion(&strobe()));
    let [first, second, last] = seen.circles() else { panic!("three rings") };
    assert_eq!(metres(&seen, first.at, second.at), (2.0, 1.0));
    assert_eq!(metres(&seen, first.at, last.at), (4.0, 2.0));
    assert!((first.radius / pixels(&seen) - 0.5).abs() < 1e-3, "{first:?}");
    // the spokes, from the middle to the right, up and to the left
    let spokes: Vec<Metres> = seen
        .lines()
        .iter()
        .filter(|line| line.points.len() == 2)
        .filter_map(|line| {
            let circle = seen.circles().iter().find(|circle| circle.at == line.points[0])?;
            let spoke = metres(&seen, circle.at, line.points[1]);
            (spoke.0.abs() <= 0.5 && spoke.1.abs() <= 0.5).then_some(spoke)
        })
        .collect();
    assert_eq!(spokes, [(0.5, 0.0), (0.0, 0.5), (-0.5, 0.0)]);
}

#[test]
fn walls_stand_where_they_are() {
    let mut strobe = strobe();
    strobe.walls = vec![
        (Side::Floor, 0.0),
        (Side::Ceiling, 5.0),
        (Side::Left, -3.0),
        (Side::Right, 7.0),
        (Side::Back, 99.0),
    ];
    let seen = Seen::of(&drawn_motion(&strobe));
    let first = seen.circles()[0].at;
    let walls: Vec<[Metres; 2]> = seen
        .lines()
        .iter()
        .filter(|line| line.class == "q line")
        .map(|line| [0, 1].map(|end| metres(&seen, first, line.points[end])))
        .collect();
    let [floor, ceiling, left, right] = walls[..] else { panic!("four walls: {walls:?}") };
    assert_eq!([floor[0].1, floor[1].1], [-1.0, -1.0]);
    assert_eq!([ceiling[0].1, ceiling[1].1], [4.0, 4.0]);
    assert_eq!([left[0].0, left[1].0], [-3.0, -3.0]);
    assert_eq!([right[0].0, right[1].0], [7.0, 7.0]);
    // they bound the room
    assert!(floor[0].0 <= -3.0 && floor[1].0 >= 7.0, "{floor:?}");
    assert!(left[0].1 >= 4.0 && left[1].1 <= -1.0, "{left:?}");
}

#[test]
fn a_plane_goes_through_its_point_in_its_direction() {
    for direction in [[1.0, 1.0], [2.0, -1.0], [0.0, 1.0], [1.0, 0.0]] {
        let mut strobe = strobe();
        strobe.planes = vec![([2.0, 1.0], direction)];
        let seen = Seen::of(&drawn_motion(&strobe));
        let point = seen.circles()[0].at;
        let plane = seen.lines().iter().find(|line| line.class == "q line").expect("a plane");
        // from (2, 1), which is 2 m to the right of the first ball
        for end in &plane.points {
            let (x, y) = metres(&seen, point, *end);
            let beside = (x - 2.0) * direction[1] - y * direction[0];
            assert!(beside.abs() < 0.05, "{direction:?}: {x}, {y}");
        }
        let ends = [plane.points[0], plane.points[1]].map(|end| metres(&seen, point, end));
        let length = (ends[0].0 - ends[1].0).hypot(ends[0].1 - ends[1].1);
        assert!(length > 2.0, "{direction:?}: {ends:?}");
    }
    // what is beside the picture is not drawn
    let mut strobe = strobe();
    strobe.planes = vec![([2.0, -50.0], [1.0, 0.0])];
    let seen = Seen::of(&drawn_motion(&strobe));
    assert!(!seen.lines().iter().any(|line| line.class == "q line"));
}

#[test]
fn a_body_with_corners_is_drawn_by_them_as_it_is_turned() {
    let mut strobe = strobe();
    strobe.corners = vec![[0.5, 0.0], [0.0, 0.25], [-0.5, 0.0]];
    let seen = Seen::of(&drawn_motion(&strobe));
    assert!(seen.circles().is_empty());
    let outlines: Vec<Vec<Metres>> = seen
        .lines()
        .iter()
        .filter(|line| line.points.len() == 4)
        .map(|line| line.points[1..].iter().map(|at| metres(&seen, line.points[0], *at)).collect())
        .collect();
    // from the first corner, at first to the left and up, then turned by a quarter
    assert_eq!(
        outlines,
        [
            [(-0.5, 0.25), (-1.0, 0.0), (0.0, 0.0)],
            [(-0.25, -0.5), (0.0, -1.0), (0.0, 0.0)],
            [(0.5, -0.25), (1.0, 0.0), (0.0, 0.0)],
        ]
    );
}

/// Two balls of which the second rests.
fn two() -> Strobe {
    let mut two = strobe();
    for frame in &mut two.frames {
        frame.bodies.push(([6.0, 1.0], 0.0));
    }
    two.paths.push(vec![[6.0, 1.0]]);
    two.radii.push(0.25);
    two
}

#[test]
fn bodies_bear_their_numbers_and_what_rests_is_drawn_once() {
    let seen = Seen::of(&drawn_motion(&two()));
    assert_eq!(seen.circles().len(), 4);
    let last = seen.circles().last().expect("a ring");
    assert_eq!(metres(&seen, seen.circles()[0].at, last.at), (6.0, 0.0));
    let at = |words: &str| {
        let (x, y) = seen.place(words).expect("a number");
        metres(&seen, seen.circles()[0].at, (x, y - 0.36 * crate::picture::NUMBERS))
    };
    assert_eq!([at("1"), at("2")], [(0.0, 0.0), (6.0, 0.0)]);
    assert!(Seen::of(&drawn_motion(&strobe())).place("1").is_none());
}

#[test]
fn arrows_point_where_bodies_go_and_are_as_long_as_they_are_fast() {
    let mut two = two();
    two.leaving = vec![[3.0, 4.0], [-2.5, 0.0]];
    let seen = Seen::of(&drawn_motion(&two));
    let arrows = |from: (f64, f64), reach: f64| {
        let heads = seen.lines().iter().filter(|line| line.points.len() == 2);
        let shafts = heads.filter(|line| {
            let begin = line.points[0];
            ((begin.0 - from.0).hypot(begin.1 - from.1) - reach).abs() < 0.02
        });
        shafts
            .map(|line| (line.points[1].0 - line.points[0].0, line.points[0].1 - line.points[1].1))
            .collect::<Vec<_>>()
    };
    // of the last position of each
    let (first, second) = (&seen.circles()[2], &seen.circles()[3]);
    let [(x, y)] = arrows(first.at, first.radius + 3.0)[..] else { panic!("one arrow") };
    assert!((x - 18.0).abs() < 0.02 && (y - 24.0).abs() < 0.02, "{x}, {y}");
    let [(x, y)] = arrows(second.at, second.radius + 3.0)[..] else { panic!("one arrow") };
    assert!((x + 15.0).abs() < 0.02 && y.abs() < 0.02, "{x}, {y}");
    // what hardly moves has none
    two.leaving[1] = [-0.25, 0.0];
    let heads = |strobe: &Strobe| {
        let seen = Seen::of(&drawn_motion(strobe));
        seen.lines().iter().filter(|line| line.points.len() == 3).count()
    };
    let still = heads(&two);
    two.leaving[1] = [-0.26, 0.0];
    assert_eq!(heads(&two), still + 1);
}

#[test]
fn of_many_bodies_the_first_and_the_last_position_are_drawn() {
    let mut many = strobe();
    for (n, frame) in many.frames.iter_mut().enumerate() {
        let moved = |k: usize| ([f64::from(u8::try_from(n + k).expect("few")), 1.0], 0.0);
        frame.bodies = (0..5).map(moved).collect();
    }
    many.radii = vec![0.1; 5];
    many.paths = vec![vec![[0.0, 1.0], [6.0, 1.0]]; 5];
    let seen = Seen::of(&drawn_motion(&many));
    let of_first = [&seen.circles()[0], &seen.circles()[5]].map(|circle| circle.at);
    assert_eq!((metres(&seen, of_first[0], of_first[1]), seen.circles().len()), ((2.0, 0.0), 10));
    many.radii.truncate(4);
    assert_eq!(Seen::of(&drawn_motion(&many)).circles().len(), 12);
}

#[test]
fn a_caption_says_what_is_drawn() {
    let says = |strobe: &Strobe, words: &str| {
        let svg = drawn_motion(strobe);
        let told = svg.split_once("<desc>").and_then(|(_, rest)| rest.split_once("</desc>"));
        let told = told.map_or("", |(told, _)| told);
        assert!(told.starts_with(&format!("{words} kane ")), "{told}");
    };
    let later = "later is stronger; the spoke turns with the body.";
    says(&strobe(), &format!("Every 0.25 s, {later}"));
    let impacts = Strobe { shows_impacts: true, ..strobe() };
    says(&impacts, &format!("Every 0.25 s and at each impact, {later}"));
    let space = Strobe { is_in_space: true, ..strobe() };
    says(&space, "Seen along z. Every 0.25 s, later is stronger.");
    let cornered = Strobe { corners: vec![[0.5, 0.0], [0.0, 0.5]], ..strobe() };
    says(&cornered, "Every 0.25 s, later is stronger; the line is the way of the centre.");
    let leaving = Strobe { apart: 0.0, leaving: vec![[1.0, 0.0]], ..strobe() };
    says(&leaving, "The impact, at the start. Arrows: velocities after the last impact.");
    let many = Strobe { radii: vec![0.5; 5], ..strobe() };
    says(&many, "First and last position (full), and the ways between.");
    let four = Strobe { radii: vec![0.5; 4], ..strobe() };
    says(&four, &format!("Every 0.25 s, {later}"));
}

#[test]
fn the_energy_of_each_part_is_a_staircase_of_its_own() {
    let mut answer = answer(world(vec![round(20)]));
    let sum = |time, parts| Bounced { time, parts };
    answer.sums =
        vec![sum(1.0, [-0.5, -0.25, 0.125, 0.0, 0.0]), sum(2.0, [-1.0, -0.5, 0.25, 1.5, -0.75])];
    let svg = ledger_picture(&report(&answer)).expect("a picture");
    let seen = Seen::of(&svg);
    let scales = seen.scales([false, false]);
    // a step at each impact, and on to a while after the last; the sum with the air, which has no curve of its own
    let stairs: Vec<Vec<(String, String)>> = seen
        .lines()
        .iter()
        .map(|line| line.points.iter().map(|at| scales.told(*at)).collect())
        .filter(|points: &Vec<_>| points.len() > 4 && points[0] == ("0".into(), "0".into()))
        .collect();
    let staircase = |first: &str, second: &str| {
        [("0", "0"), ("1", "0"), ("1", first), ("2", first), ("2", second), ("2.12", second)]
            .map(|(x, y)| (x.to_owned(), y.to_owned()))
            .to_vec()
    };
    for (part, (first, second)) in
        [("-0.5", "-1"), ("-0.25", "-0.5"), ("0.13", "0.25"), ("-0.63", "-0.5")].iter().enumerate()
    {
        assert!(stairs.contains(&staircase(first, second)), "{part}: {stairs:#?}");
    }
    let parts = ["normal", "tangential", "rotational", "gravity", "all: kinetic"];
    assert!(parts.iter().all(|part| seen.place(part).is_some()), "{svg}");
    assert!(seen.place("air").is_none());
    // where there is air, it is a part
    let mut of = bounce(Encounter::Wall(0, Side::Floor), round(40), None);
    of.air = Some(shown(112));
    answer.bounces = vec![of];
    let svg = ledger_picture(&report(&answer)).expect("a picture");
    assert!(Seen::of(&svg).place("air").is_some());
    answer.sums.truncate(1);
    answer.sums[0].time = 0.0;
    assert!(ledger_picture(&report(&answer)).is_none());
}

#[test]
fn each_model_with_an_error_stands_at_its_cost() {
    let mut answer = answer(world(vec![round(20)]));
    let at = |mechanics, cost, ratio, verdict| Judged {
        model: Model { mechanics, system: System::F64 },
        cost,
        errors: Vec::new(),
        ratio,
        verdict,
    };
    let missed = || Verdict::Uncertified("why");
    answer.judged = vec![
        at(Mechanics::NormalOnly, 200, Some(0.01), Verdict::Meets),
        Judged { cost: 1000, ratio: Some(0.5), ..judged(Verdict::Meets) },
        at(Mechanics::Chain, 50, Some(30.0), missed()),
        at(Mechanics::Annuli, 70, None, missed()),
    ];
    answer.chosen = Some(model(System::Rational));
    let svg = compare_picture(&report(&answer));
    let seen = Seen::of(&svg);
    let scales = seen.scales([true, true]);
    let marks: Vec<(String, String)> =
        seen.circles().iter().skip(3).map(|circle| scales.told(circle.at)).collect();
    let pair = |x: &str, y: &str| (x.to_owned(), y.to_owned());
    assert_eq!(marks, [pair("200", "0.01"), pair("1000", "0.5"), pair("50", "30")]);
    // the chosen one is a disc, and what is not good enough has no green
    let green = &seen.circles()[1].class;
    let classes: Vec<&str> =
        seen.circles().iter().skip(3).map(|circle| circle.class.as_str()).collect();
    assert_eq!(classes[1], green);
    assert_eq!(classes[0], format!("{green} line"));
    assert!(classes[2].ends_with(" line") && classes[2] != classes[0], "{classes:?}");
    // the tolerance is where the error is the tolerance
    let flat = seen.lines().iter().filter(|line| line.points.len() == 2);
    let levels: Vec<String> = flat
        .filter(|line| line.class == "c1 line")
        .map(|line| scales.told(line.points[1]).1)
        .collect();
    assert_eq!(levels.last().map(String::as_str), Some("1"), "{svg}");
    for name in ["normal-only/f64", "normal-only/rational", "chain/f64"] {
        assert!(seen.place(name).is_some(), "{name}");
    }
    assert!(!svg.contains("estimated"));
    answer.known = Some(Known::Estimated);
    assert!(compare_picture(&report(&answer)).contains("worst error by its tolerance, estimated"));
}

#[test]
fn velocities_and_forces_stand_at_their_time_in_microseconds() {
    use kane_scene::simulate::{ContactTime, Moment};
    let moment = |time: f64, velocities: [f64; 2], force: f64| Moment {
        time,
        velocities: velocities.to_vec(),
        forces: vec![force],
    };
    let contact = ContactTime {
        moments: vec![
            moment(0.0, [2.0, 0.0], 0.0),
            moment(1e-5, [1.0, 1.5], 4000.0),
            moment(2e-5, [-0.5, 2.5], 0.0),
        ],
    };
    let answer = answer(world(vec![round(20)]));
    let svg = contact_picture::contact_picture(&report(&answer), &contact);
    let seen = Seen::of(&svg);
    // the upper panel, whose axes were drawn first
    let scales = seen.scales([false, false]);
    let dots: Vec<(String, String)> =
        seen.circles().iter().take(6).map(|dot| scales.told(dot.at)).collect();
    let pair = |x: &str, y: &str| (x.to_owned(), y.to_owned());
    assert_eq!(
        dots,
        [
            pair("0", "2"),
            pair("10", "1"),
            pair("20", "-0.5"),
            pair("0", "0"),
            pair("10", "1.5"),
            pair("20", "2.5"),
        ]
    );
    let names = ["sphere 1", "sphere 2", "1 on 2", "time since the first touch, µs"];
    assert!(names.iter().all(|name| seen.place(name).is_some()), "{svg}");
    // the force has the colour of the sphere that is pushed, and is at its greatest in the middle
    let classes: Vec<&str> = seen.circles().iter().map(|dot| dot.class.as_str()).collect();
    assert_eq!((classes[3], classes.len()), (classes[6], 9));
    let heights: Vec<f64> = seen.circles()[6..].iter().map(|dot| dot.at.1).collect();
    assert!(heights[1] < heights[0] && heights[0] == heights[2], "{heights:?}");
}

#[test]
fn an_impulse_stands_in_its_plane_and_what_is_beside_the_sheet_is_named() {
    use kane_scene::{Event, ImpulsePlane, PlaneLine};
    let plane = ImpulsePlane {
        frame: [[-2.0, -1.0], [2.0, 3.0]],
        lines: vec![
            (PlaneLine::Cone, [[0.0, 0.0], [1.5, 3.0]]),
            (PlaneLine::Stick, [[-1.0, 3.0], [1.0, -1.0]]),
        ],
        path: vec![
            (Event::Start, [0.0, 0.0]),
            (Event::Stick, [-0.5, 1.0]),
            (Event::End, [0.5, 2.0]),
        ],
        equal_energy: vec![[0.0, 0.0], [1.0, 1.0], [0.0, 2.0]],
        ends: vec![(vec!["near"], [1.0, 2.5]), (vec!["far", "away"], [1.0, 3.5])],
    };
    let svg = drawn_impulse("Made up", "kane", &plane);
    assert!(svg.contains("Outside of the sheet: far, away."), "{svg}");
    let seen = Seen::of(&svg);
    let scales = seen.scales([false, false]);
    let pair = |x: &str, y: &str| (x.to_owned(), y.to_owned());
    // the events, and the ring where the law ends; one ring is in the legend
    let dots: Vec<_> = seen.circles().iter().skip(1).map(|dot| scales.told(dot.at)).collect();
    assert_eq!(dots, [pair("0", "0"), pair("-0.5", "1"), pair("0.5", "2"), pair("1", "2.5")]);
    let lines: Vec<Vec<_>> = seen
        .lines()
        .iter()
        .map(|line| line.points.iter().map(|at| scales.told(*at)).collect())
        .collect();
    let has = |ends: &[(&str, &str)]| {
        let wanted: Vec<_> = ends.iter().map(|(x, y)| pair(x, y)).collect();
        assert!(lines.contains(&wanted), "{ends:?}: {lines:#?}");
    };
    has(&[("0", "0"), ("1.5", "3")]);
    has(&[("-1", "3"), ("1", "-1")]);
    has(&[("0", "0"), ("-0.5", "1"), ("0.5", "2")]);
    has(&[("0", "0"), ("1", "1"), ("0", "2")]);
    // words stand away from the axis of the cone
    let beside = |words: &str| seen.place(words).map(|(x, _)| x).expect(words);
    let at = |index: usize| seen.circles()[index].at.0;
    assert!(beside("sticks") < at(2) && beside("impulse") > at(3), "{svg}");
    let quiet = ImpulsePlane { path: vec![], ends: vec![], ..plane };
    let svg = drawn_impulse("Made up", "kane", &quiet);
    let seen = Seen::of(&svg);
    assert!(
        seen.place("the impulse as it grows").is_none() && seen.place("where laws end").is_none()
    );
    assert!(!svg.contains("Outside of the sheet"), "{svg}");
}
