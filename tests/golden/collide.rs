//! What `kane collide` prints; these tests own `snapshots/collide`.

use std::path::Path;
use std::process::{Command, Stdio};

use kane::collide::{Collision, Question, System, answer};
use kane::impact::bodies::{Motion, Shape, SphereOnPlane};
use kane::impact::laws;
use kane::number::parse;
use kane::report::Page;
use kane::report::collision::sheet;

use crate::schemas::assert_valid;

const EXAMPLE: &str = "--sphere 7/2 --speed 3.9 --angle 20 --mu 0.092 --e 0.98";

/// What the program prints.
fn printed(arguments: &str) -> String {
    let mut command = Command::new(env!("CARGO_BIN_EXE_kane"));
    command.current_dir(env!("CARGO_MANIFEST_DIR")).stdin(Stdio::null());
    let output = command.arg("collide").args(arguments.split(' ')).output();
    let output = output.expect("the program starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("reports are UTF-8")
}

/// Compares with `snapshots/collide/NAME.snap`.
#[track_caller]
fn assert_shown(name: &str, shown: &str) {
    crate::settings().bind(|| insta::assert_snapshot!(name, shown));
}

#[test]
fn all_laws_on_the_example() {
    assert_shown("table", &printed(EXAMPLE));
}

#[test]
fn one_law_with_an_irrational_root() {
    assert_shown("smith-1991", &printed(&format!("{EXAMPLE} --law smith-1991")));
}

#[test]
fn one_law_as_json() {
    let json = printed(&format!("{EXAMPLE} --law walton --format json"));
    assert_valid("collide", &json);
    assert_shown("json", &json);
}

#[test]
fn all_laws_as_markdown() {
    assert_shown("markdown", &printed(&format!("{EXAMPLE} --format markdown")));
}

#[test]
fn the_pendulum_of_the_puzzle() {
    assert_shown("double-pendulum", &printed("docs/collisions/double-pendulum.toml"));
}

/// A hoop whose slip some laws turn into energy.
fn hoop() -> Collision {
    let n = |text| parse(text).expect("a literal");
    let sphere = SphereOnPlane {
        mass: n("1"),
        radius: n("1"),
        inertia: Shape::Hoop.gyration(),
        friction: n("1"),
        restitution: n("1"),
        before: Motion { vx: n("1/2"), vy: n("2"), omega: n("0") },
    };
    let mut question = Question::new(System::Sphere(sphere));
    question.command = "kane collide --body hoop --vx 1/2 --vy -2 --mu 1 --e 1".to_owned();
    answer(&question, laws()).expect("the input is in its domain")
}

#[test]
fn a_narrow_page_gets_blocks_and_red_laws_that_create_energy() {
    let page = Page { width: Some(60), colour: true };
    assert_shown("narrow", &sheet(&hoop()).text(page).replace('\u{1b}', "ESC"));
}

#[test]
fn a_narrow_page_is_not_overrun() {
    for width in [60, 80, 100, 140] {
        let page = Page { width: Some(width), colour: false };
        let shown = sheet(&hoop()).text(page);
        let (body, _command) = shown.rsplit_once("\n\n").expect("the command ends the report");
        for line in body.lines() {
            assert!(line.chars().count() <= width, "{width} columns, but: {line}");
        }
    }
}

#[test]
fn every_example_file_has_a_table() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/collisions");
    let mut count = 0;
    for entry in folder.read_dir().expect("the examples are there") {
        let path = entry.expect("the examples can be listed").path();
        let shown = printed(path.to_str().expect("UTF-8"));
        assert!(shown.contains("18 laws"), "{shown}");
        assert!(!shown.contains("NaN") && !shown.contains("inf"), "{shown}");
        count += 1;
    }
    assert_eq!(count, 4);
}
