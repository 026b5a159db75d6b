//! The chooser is right: the chosen model meets the tolerance, the next cheaper one misses.

use kane_scene::{Answer, Effort, Mechanics, Model, Scene, Verdict, answer, read};

/// The shipped scenes, and the model that each is answered by.
const SHIPPED: [(&str, &str, &str); 10] = [
    ("paper-sphere", include_str!("../../../../docs/scenes/paper-sphere.toml"), "sliding/f32"),
    ("backspin", include_str!("../../../../docs/scenes/backspin.toml"), "coulomb/f32"),
    ("superball", include_str!("../../../../docs/scenes/superball.toml"), "grip/f64"),
    ("rest", include_str!("../../../../docs/scenes/rest.toml"), "coulomb/rational"),
    ("two-spheres", include_str!("../../../../docs/scenes/two-spheres.toml"), "sliding/f64"),
    ("rod-jam", include_str!("../../../../docs/scenes/rod-jam.toml"), "energetic/f64"),
    ("double-pendulum", include_str!("../../../../docs/scenes/double-pendulum.toml"), "energetic/f32"),
    ("cradle-apart", include_str!("../../../../docs/scenes/cradle-apart.toml"), "normal-only/f32"),
    ("cradle-touching", include_str!("../../../../docs/scenes/cradle-touching.toml"), "chain/f64"),
    ("discs", include_str!("../../../../docs/scenes/discs.toml"), "coulomb/f64"),
];

fn answered(name: &str, text: &str, wanted: Option<Model>) -> (Scene, Answer) {
    let scene = read::scene(name, text).unwrap_or_else(|fault| panic!("{fault}"));
    let answer = answer(&scene, wanted, Effort::Chosen, &mut |_, _| {});
    let answer = answer.unwrap_or_else(|none| panic!("{name}: {none}"));
    (scene, answer)
}

#[test]
fn the_chosen_model_meets_the_tolerance_and_the_next_cheaper_misses() {
    for (name, text, expected) in SHIPPED {
        let (_, answer) = answered(name, text, None);
        let chosen = answer.chosen.unwrap_or_else(|| panic!("{name}: {:#?}", answer.judged));
        println!("{name}: {chosen}\n  {}", answer.reasons.join("\n  "));
        for judged in &answer.judged {
            println!("    {} {} {:?} {:?}", judged.model, judged.cost, judged.ratio, judged.verdict);
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
