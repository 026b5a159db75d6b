//! What pictures show is what the answer says.

use kane_impact::laws;
use kane_scene::{Answer, Effort, Event, Model, Picture, PlaneLine, answer, read};

const ROD: &str = include_str!("../../../../docs/scenes/rod-jam.toml");
const PENDULUM: &str = include_str!("../../../../docs/scenes/double-pendulum.toml");
const CRADLE: &str = include_str!("../../../../docs/scenes/cradle-touching.toml");

fn answered(text: &str, model: Option<&str>) -> Answer {
    let scene = read::scene("scene", text).expect("it is well formed");
    let model = model.map(|model| Model::named(model, laws()).expect("a model"));
    answer(&scene, laws(), model, Effort::Chosen, &mut |_, _| {}).expect("it has an answer")
}

/// The distance of a point from the line through two others, by the size of the frame.
fn off([a, b]: [[f64; 2]; 2], p: [f64; 2], size: f64) -> f64 {
    let (along, to) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
    (along[0] * to[1] - along[1] * to[0]).abs() / (along[0].hypot(along[1]) * size)
}

#[test]
fn the_impulse_grows_along_the_cone_and_the_line_of_no_slip() {
    for (text, friction, events) in [
        (ROD, 2.0, vec![Event::Start, Event::Stick, Event::Compressed, Event::End]),
        (PENDULUM, 0.5, vec![Event::Start, Event::Compressed, Event::Reverse, Event::End]),
    ] {
        let asked = match text.contains("p_n_n_s") {
            true => text.to_owned(),
            false => text.replacen("[ask]", "[ask]\np_n_n_s = 1e-3", 1),
        };
        let answer = answered(&asked, None);
        let Some(Picture::ImpulsePlane(plane)) = &answer.picture else { panic!("a tip") };
        let happened: Vec<Event> = plane.path.iter().map(|(event, _)| *event).collect();
        assert_eq!(happened, events);
        let size = plane.frame[1][1];
        let line = |kind| {
            let found = plane.lines.iter().find(|(line, _)| *line == kind);
            found.expect("it crosses the frame").1
        };
        for (event, p) in &plane.path {
            // some ten roundings of an impulse of the size of the frame
            assert!(p[0].abs() <= friction * p[1] + 1e-14 * size, "{p:?}");
            match event {
                Event::Stick | Event::Reverse => {
                    assert!(off(line(PlaneLine::Stick), *p, size) < 1e-14);
                }
                Event::Compressed => {
                    assert!(off(line(PlaneLine::Compression), *p, size) < 1e-14);
                }
                Event::Start => assert_eq!(*p, [0.0, 0.0]),
                Event::End => {
                    let normal = answer.lines.iter().find(|l| l.quantity.to_string() == "p_n_n_s");
                    let normal = normal.expect("it is asked for");
                    // the model may be in f32
                    assert!((p[1] - normal.value).abs() < 1e-6 * size, "{p:?} {normal:?}");
                }
            }
        }
        for (_, ends) in &plane.lines {
            for (k, end) in ends.iter().flat_map(|end| end.iter().enumerate()) {
                let (low, high) = (plane.frame[0][k], plane.frame[1][k]);
                assert!(*end >= low - 1e-8 * size && *end <= high + 1e-8 * size);
            }
        }
    }
    // of a law that is no process the start and the end alone
    let answer = answered(ROD, Some("normal-only"));
    let Some(Picture::ImpulsePlane(plane)) = &answer.picture else { panic!("a tip") };
    assert_eq!(plane.path.len(), 2);
    assert!(plane.path[1].1[0] == 0.0 && plane.path[1].1[1] > 0.0);
}

#[test]
fn a_law_ends_inside_the_curve_of_equal_energy_unless_it_creates_energy() {
    let mut creates = 0;
    for text in [ROD, PENDULUM] {
        let scene = read::scene("scene", text).expect("it is well formed");
        let kane_scene::Setup::Tip(tip) = scene.nominal() else { panic!("a tip") };
        let (contact, _) = tip.contact().expect("it is a contact");
        let answer = answered(text, None);
        let Some(Picture::ImpulsePlane(plane)) = &answer.picture else { panic!("a tip") };
        let change = |[t, n]: [f64; 2]| {
            let w = contact.delassus();
            let [tt, tn, nn] = [w.tt(), w.tn(), w.nn()].map(kane_number::Lane::to_f64);
            let [slip, a] = [contact.slip(), contact.approach()].map(kane_number::Lane::to_f64);
            slip * t - a * n + (tt * t * t + 2.0 * tn * t * n + nn * n * n) / 2.0
        };
        let size: f64 = plane.equal_energy.iter().map(|p| p[0].hypot(p[1])).fold(0.0, f64::max);
        for point in &plane.equal_energy {
            assert!(change(*point).abs() < 1e-11 * (1.0 + size * size), "{point:?}");
        }
        let mut drawn = 0;
        for law in laws().iter().filter(|law| law.info.parameters.is_empty()) {
            let Ok(outcome) = law.over::<kane_number::Rational>().resolve(&contact) else {
                continue;
            };
            let [t, n] = [&outcome.impulse.tangential, &outcome.impulse.normal]
                .map(kane_number::Lane::to_f64);
            let end = plane.ends.iter().find(|(ids, _)| ids.contains(&law.info.id));
            let (_, [x, y]) = end.expect("every law with an outcome has its end");
            assert!((x - t).abs() + (y - n).abs() < 1e-9, "{}", law.info.id);
            // inside is where energy is lost
            let total = kane_number::Lane::to_f64(&outcome.work.total());
            assert!((change([*x, *y]) - total).abs() < 1e-9, "{}", law.info.id);
            creates += u32::from(total > 1e-9);
            drawn += 1;
        }
        assert!(drawn > 5, "{drawn}");
    }
    assert!(creates > 0, "kane-levinson does in the pendulum");
}

#[test]
fn a_motion_ends_where_it_is_asked_to_and_shows_the_impact() {
    let text = include_str!("../../../../docs/scenes/two-spheres.toml");
    let answer = answered(text, None);
    let Some(Picture::Motion(strobe)) = &answer.picture else { panic!("a motion") };
    let (end, last) = (answer.end.expect("it ends"), strobe.frames.last().expect("frames"));
    assert!((last.time - end.time.value).abs() < 1e-6 && strobe.shows_impacts);
    // the two touch there, and go on as the impact leaves them
    let [a, b] = [0, 1].map(|body| last.bodies[body].0);
    assert!((a[0] - b[0]).hypot(a[1] - b[1]) < strobe.radii.iter().sum::<f64>() + 1e-6);
    for (leaving, body) in strobe.leaving.iter().zip(&end.bodies) {
        assert!((leaving[0] - body.motion.vx.value).abs() < 1e-6);
    }
    assert_eq!(strobe.leaving.len(), 2);
}

#[test]
fn spheres_in_contact_keep_their_momentum_and_end_as_the_answer_says() {
    let answer = answered(CRADLE, None);
    let Some(Picture::ContactTime(contact)) = &answer.picture else { panic!("a chain") };
    let [first, .., last] = &contact.moments[..] else { panic!("moments") };
    assert_eq!((first.time, &first.velocities[..]), (0.0, &[1.0, 0.0, 0.0][..]));
    for (velocity, line) in last.velocities.iter().zip(&answer.lines) {
        // coarser steps than the answer's
        assert!((velocity - line.value).abs() < 1e-4, "{velocity} {line:?}");
    }
    for moment in &contact.moments {
        // equal masses, some hundred steps
        let sum: f64 = moment.velocities.iter().sum();
        assert!((sum - 1.0).abs() < 1e-12);
        assert!(moment.forces.iter().all(|force| *force >= 0.0));
    }
    assert!(contact.moments.windows(2).all(|pair| pair[0].time < pair[1].time));
    assert!(first.forces.iter().chain(&last.forces).all(|force| *force == 0.0));
}
