//! The chooser is right: the chosen model meets the tolerance, the next cheaper one misses.

use kane_scene::{Answer, Effort, Model, Scene, Verdict, answer, read};

/// The shipped scenes, and the model that each is answered by.
const SHIPPED: [(&str, &str, &str); 10] = [
    ("paper-sphere", include_str!("../../../../docs/scenes/paper-sphere.toml"), "sliding/f32"),
    ("backspin", include_str!("../../../../docs/scenes/backspin.toml"), "coulomb/f32"),
    ("superball", include_str!("../../../../docs/scenes/superball.toml"), "grip/f64"),
    ("rest", include_str!("../../../../docs/scenes/rest.toml"), "coulomb/rational"),
    ("two-spheres", include_str!("../../../../docs/scenes/two-spheres.toml"), "coulomb/f64"),
    ("rod-jam", include_str!("../../../../docs/scenes/rod-jam.toml"), "energetic/f64"),
    (
        "double-pendulum",
        include_str!("../../../../docs/scenes/double-pendulum.toml"),
        "energetic/f32",
    ),
    ("cradle-apart", include_str!("../../../../docs/scenes/cradle-apart.toml"), "normal-only/f64"),
    ("cradle-touching", include_str!("../../../../docs/scenes/cradle-touching.toml"), "chain/f64"),
    ("discs", include_str!("../../../../docs/scenes/discs.toml"), "coulomb/f64"),
];

fn answered(name: &str, text: &str, wanted: Option<Model>) -> (Scene, Answer) {
    let scene = read::scene(name, text).expect("the scene is well formed");
    let answer = answer(&scene, wanted, Effort::Chosen, &mut |_, _| {});
    (scene, answer.expect("there is an answer"))
}

#[test]
fn the_chosen_model_meets_the_tolerance_and_the_next_cheaper_misses() {
    for (name, text, expected) in SHIPPED {
        let (_, answer) = answered(name, text, None);
        let chosen = answer.chosen.expect(name);
        println!("{name}: {chosen}\n  {}", answer.reasons.join("\n  "));
        for judged in &answer.judged {
            println!(
                "    {} {} {:?} {:?}",
                judged.model, judged.cost, judged.ratio, judged.verdict
            );
        }
        assert_eq!(chosen.to_string(), expected, "{name}");
        assert_eq!(answer.shown, chosen);
        for line in &answer.lines {
            let error = line.error.expect("a chosen model has a bound");
            assert!(error <= line.tolerance, "{name}: {line:?}");
        }
        let [.., cheaper, last] = &answer.judged[..] else { panic!("{name}: nothing is cheaper") };
        assert_eq!(last.model, chosen);
        assert!(cheaper.cost <= last.cost);
        assert!(
            matches!(cheaper.verdict, Verdict::Misses { .. } | Verdict::Fails(_)),
            "{name}: {cheaper:?}"
        );
    }
}

/// A process with one answer, as a stand-in for those that are plugged in.
struct Fixed;

impl kane_scene::Process for Fixed {
    fn id(&self) -> &'static str {
        "fixed"
    }

    fn answer(&self, alpha: f64, _: f64, _: f64) -> Option<kane_scene::Compliant> {
        let k = -0.25;
        let impulse = (1.0 - k) / (2.0 * alpha);
        Some(kane_scene::Compliant { k, impulse, energy: -impulse * (1.0 + k) / 2.0, error: 1e-3 })
    }
}

#[test]
fn a_process_answers_where_an_elastic_contact_does_not_slide() {
    use kane_impact::{Contact, Delassus};
    use kane_number::{Interval, Number as _};
    use kane_scene::{Elastic, Resolver as _};

    let n = crate::n;
    let contact = |slip: &str| {
        let delassus = Delassus::new(n("7/2"), n("0"), n("1")).unwrap();
        Contact::new(n(slip), n("1"), delassus, n("1/5"), n("9/10")).unwrap()
    };
    let with = Elastic { poisson_ratio: n("3/10"), process: Some(&Fixed) };
    let without = Elastic { process: None, ..with.clone() };
    // α = 7/2·1/5·19/10/(2·slip): 0.3325 slides by the formula, 0.665 takes the process
    for (slip, k) in
        [("2", 1.0 - 2.0 * 0.3325), ("-2", 1.0 - 2.0 * 0.3325), ("1", -0.25), ("-1", -0.25)]
    {
        let outcome = with.resolve(&contact(slip).map(Interval::from_rational)).unwrap();
        let found = outcome.slip / Interval::from_rational(&n(slip));
        assert!((found.midpoint() - k).abs() < 1e-12, "{slip}: {found}");
        assert!(found.width() < 2.1e-3);
        // the impulse is what changes the slip
        let change = outcome.slip - Interval::from_rational(&n(slip));
        let by_impulse = outcome.impulse.tangential * Interval::from_rational(&n("7/2"));
        assert!(change.intersection(&by_impulse).is_some());
        assert_eq!(without.resolve(&contact(slip).map(Interval::from_rational)).is_ok(), k > 0.0);
    }
}

#[test]
fn where_nothing_is_good_enough_the_reason_is_named() {
    // beyond sliding, the compliance of the contact decides
    let steep = SHIPPED[0].1.replacen("value = 3.378", "value = 0.5", 1);
    let scene = read::scene("steep", &steep).unwrap();
    let none = answer(&scene, None, Effort::Chosen, &mut |_, _| {}).unwrap_err();
    assert!(none.reason.contains("tangential compliance decides"), "{none}");
    // an irrational time has no exact answer
    let exact = SHIPPED[1].1.replacen("x_m = 0.2", "time_s = 0", 1);
    let (_, answer) = answered("exact", &exact, None);
    assert_eq!(answer.chosen, None);
    assert!(answer.reasons.iter().any(|said| said.contains("limits the answer")), "{answer:#?}");
}

#[test]
fn another_model_is_answered_with_its_error() {
    let model = "sliding".parse().unwrap();
    let (_, answer) = answered("backspin", SHIPPED[1].1, Some(model));
    assert_eq!((answer.shown, answer.chosen), (model, None));
    assert!(answer.lines.iter().any(|line| line.error.unwrap() > line.tolerance));
    for (bad, message) in [("slidin", "did you mean `sliding`?"), ("coulomb/f65", "number system")]
    {
        let error = bad.parse::<Model>().unwrap_err().to_string();
        assert!(error.contains(message), "{error}");
    }
}
