//! A law that nobody published, written here alone, and shown by every report that lists laws.

use std::cell::Cell;
use std::sync::LazyLock;

use kane::collide::{Collision, Question, System, answer, in_depth};
use kane::impact::bodies::{Motion, SphereOnPlane};
use kane::impact::{
    Contact, ImpactLaw, Impulse, Lasting, Law, LawInfo, ModelInfo, Regime, laws, set_parameter,
};
use kane::matrix::{Finding, Selection, matrix};
use kane::measure::over_alpha;
use kane::number::{Number, Rational, parse};
use kane::report::matrix::MatrixReport;
use kane::report::scene::SceneReport;
use kane::report::{Page, collision, matrix as matrix_report, scene as scene_report};
use kane::scene::{Effort, Model, model_names, read};

/// Friction at half of its limit, whatever the slip: k = 1 − α.
#[derive(Clone)]
struct MadeUp;

thread_local! {
    /// How often the law was asked for an impulse.
    static ASKED: Cell<u32> = const { Cell::new(0) };
}

impl ImpactLaw for MadeUp {
    const INFO: LawInfo = LawInfo {
        id: "made-up",
        people: "Nobody",
        source: "made up for a test",
        statement: "i_x = 1/2",
        on_a_sphere: &[("", "1 - alpha")],
        gap: Some("no gap is known"),
        model: Some(ModelInfo {
            words: "friction at half of its limit",
            operations: [5; 4],
            lasting: Lasting::Unsummed,
        }),
        ..LawInfo::PLAIN
    };

    fn normal_collision(&self) -> Option<Rational> {
        None
    }

    fn regimes<N: Number>(&self) -> &'static [Regime<Self, N>] {
        const {
            &[Regime {
                name: "half",
                guards: &[],
                root: None,
                impulse: |_, contact: &Contact<N>, _| {
                    ASKED.set(ASKED.get() + 1);
                    let normal = contact.closing() / contact.delassus().nn();
                    let half = contact.friction().clone() / N::one().double();
                    Impulse { tangential: -(half * &normal), normal }
                },
                slip: None,
                work: None,
            }]
        }
    }
}

/// All laws, and this one.
static LAWS: LazyLock<Vec<Law>> = LazyLock::new(|| {
    let mut all = laws().to_vec();
    all.push(Law::new(MadeUp));
    all
});

fn question() -> Question {
    let n = |text| parse(text).expect("a literal");
    Question::new(System::Sphere(SphereOnPlane {
        mass: n("1"),
        radius: n("1"),
        inertia: n("2/5"),
        friction: n("2/7"),
        restitution: n("1"),
        before: Motion { vx: n("1"), vy: n("1"), omega: n("0") },
    }))
}

#[track_caller]
fn shows(forms: &[String]) {
    for (index, form) in forms.iter().enumerate() {
        assert!(form.contains("made-up"), "form {index}:\n{form}");
    }
}

fn forms_of(collision: &Collision) -> [String; 3] {
    [
        collision::sheet(collision).text(Page::default()),
        collision::sheet(collision).markdown(),
        collision::json(collision),
    ]
}

#[test]
fn a_collision_shows_it() {
    let all = answer(&question(), &LAWS).expect("the input is in its domain");
    assert_eq!(all.laws.len(), laws().len() + 1);
    shows(&forms_of(&all));
    let deep = in_depth(&question(), &LAWS[laws().len()]).expect("the input is in its domain");
    assert!(deep.has_outcome() && deep.as_expected(), "{deep:?}");
    shows(&forms_of(&deep));
    let unknown = set_parameter(&mut LAWS.clone(), "made-up.share", &Rational::default());
    assert!(unknown.is_err(), "it has no parameter");
}

/// The exact inputs, the same rounded to floats, plain floats, double-double, and intervals.
#[test]
fn a_collision_is_resolved_once_in_every_number_system() {
    let law = &LAWS[laws().len()];
    let asked = |run: &dyn Fn()| {
        ASKED.set(0);
        run();
        ASKED.get()
    };
    let short = asked(&|| drop(answer(&question(), std::slice::from_ref(law))));
    let deep = asked(&|| drop(in_depth(&question(), law)));
    assert_eq!((short, deep), (1, 5));
}

#[test]
fn the_matrix_shows_it() {
    let selection = Selection {
        laws: Some(vec!["whittaker-uncapped".to_owned(), "made-up".to_owned()]),
        properties: Some(vec!["momentum".to_owned()]),
    };
    let matrix = matrix(&LAWS, &selection, &mut |_, _| {});
    let found: Vec<_> = matrix.rows.iter().map(|row| row.cells[0].finding).collect();
    assert_eq!(found, [Finding::Proved; 2]);
    let report = MatrixReport { matrix: &matrix, command: "kane laws".to_owned() };
    shows(&[
        matrix_report::sheet(&report).text(Page::default()),
        matrix_report::sheet(&report).markdown(),
        matrix_report::json(&report),
        matrix_report::html(&report, ""),
        matrix_report::csv(&report),
        matrix_report::picture(&report),
        matrix_report::explain(&matrix.rows[1], matrix.properties[0], &matrix.rows[1].cells[0]),
    ]);
    assert!(matrix_report::json(&report).contains("\"people\": \"Nobody\""));
}

#[test]
fn the_curves_over_alpha_have_it() {
    let only = [LAWS[0].clone(), LAWS[laws().len()].clone()];
    let curves = over_alpha(&only).curves;
    assert_eq!(curves.iter().flat_map(|curve| &curve.laws).count(), 2);
    assert_eq!(curves[1].laws, ["made-up"]);
}

#[test]
fn a_scene_tries_it() {
    let file = "docs/scenes/backspin.toml";
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
    let text = read::load(&path).expect("the scene is shipped");
    let scene = read::scene(file, &text).expect("it is well formed");
    assert!(model_names(&LAWS).contains(&"made-up"));
    let wanted = Model::named("made-up", &LAWS).expect("it is a model");
    for wanted in [None, Some(wanted)] {
        let answer =
            kane::scene::answer(&scene, &LAWS, wanted, Effort::All, &mut |_, _| {}).unwrap();
        let report = SceneReport {
            answer: &answer,
            title: scene.title.clone(),
            command: format!("kane scene {file} --compare"),
            is_compared: true,
        };
        shows(&[
            scene_report::sheet(&report).text(Page::default()),
            scene_report::sheet(&report).markdown(),
            scene_report::json(&report),
            scene_report::models_csv(&report),
            scene_report::compare_picture(&report),
        ]);
        if wanted.is_some() {
            assert_eq!(answer.shown.to_string(), "made-up/f64");
        }
    }
}
