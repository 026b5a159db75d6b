//! `kane collide`: exit codes, messages, formats, files.

use std::fs;

use serde_json::Value;

use crate::{kane, scratch};

const EXAMPLE: [&str; 11] = [
    "collide", "--sphere", "7/2", "--speed", "3.9", "--angle", "20", "--mu", "0.092", "--e", "0.98",
];

/// The example with one flag's value exchanged.
fn with(flag: &str, value: &str) -> Vec<String> {
    let mut arguments = EXAMPLE.map(str::to_owned).to_vec();
    match arguments.iter().position(|argument| argument == flag) {
        Some(at) => arguments[at + 1] = value.to_owned(),
        None => arguments.extend([flag.to_owned(), value.to_owned()]),
    }
    arguments
}

fn run(arguments: &[String]) -> crate::Run {
    kane(&arguments.iter().map(String::as_str).collect::<Vec<_>>())
}

#[test]
fn all_laws_answer_in_one_table() {
    let run = kane(&EXAMPLE);
    assert_eq!(run.code, 0, "{}", run.stderr);
    for law in kane::impact::laws() {
        let id = law.info.id;
        let shown = run.stdout.lines().any(|line| line.starts_with(&format!("{id} ")));
        assert_eq!(shown, law.invented().is_empty(), "{id}\n{}", run.stdout);
    }
    assert!(run.stdout.contains("alpha = 0.8758"), "{}", run.stdout);
    assert!(run.stdout.contains("m = 1 kg (default)"), "{}", run.stdout);
    assert!(run.stdout.contains("float pair cos = 0.9396926207859084"), "{}", run.stdout);
}

#[test]
fn each_wrong_value_is_named_with_its_flag_and_domain() {
    for (flag, value, message) in [
        ("--mu", "-1", "--mu is -1, but must be at least 0"),
        ("--mu", "NaN", "--mu cannot be NaN: expected a digit"),
        ("--e", "1.1", "--e is 1.1, but must be from 0 to 1"),
        ("--angle", "90", "--angle is 90, but must be between -90 and 90"),
        ("--speed", "-3", "--speed is -3, but must be at least 0"),
        ("--speed", "1e999999", "--speed cannot be 1e999999: exponent 999999"),
        ("--speed", "1e400", "--speed is 1e400, beyond the range of f64"),
        ("--speed", "1e-400", "--speed is 1e-400, beyond the range of f64"),
        ("--speed", "inf", "--speed cannot be inf"),
        ("--sphere", "1", "--sphere is 1, but must be above 1"),
        ("--sphere", "hoop", "write --body hoop"),
        ("--mass", "0", "--mass is 0, but must be above 0"),
        ("--radius", "-1/2", "--radius is -1/2, but must be above 0"),
        ("--mass", "1/0", "--mass cannot be 1/0: the denominator"),
        ("--body", "hoop", "--sphere and --body"),
        ("--half-tangent", "1/3", "--angle and --half-tangent"),
        ("--vy", "1", "either --speed with its direction, or --vx and --vy"),
        ("--spin", "--law", "--spin has no value: `--law` follows"),
        ("--law", "smith", "did you mean `smith-1991` or `smith-printed`?"),
        ("--law", "waltom", "did you mean `walton`?"),
        ("--param", "walton.beta0", "`walton.beta0` has no value"),
        ("--param", "walton.beta0=2", "walton.beta0 is 2, but must be from 0 to 1"),
        ("--param", "walton.beta=0", "did you mean `walton.beta0`?"),
    ] {
        let run = run(&with(flag, value));
        assert_eq!(run.code, 2, "{flag} {value}: {}", run.stderr);
        assert!(run.stdout.is_empty(), "{flag} {value}: {}", run.stdout);
        assert!(run.stderr.contains(message), "{flag} {value}: {}", run.stderr);
    }
}

#[test]
fn what_is_missing_is_asked_for() {
    for (arguments, message) in [
        (&["collide"][..], "what collides?"),
        (&["collide", "--body", "disc"], "how fast?"),
        (&["collide", "--body", "disc", "--speed", "1"], "--angle is missing"),
        (&["collide", "--body", "disc", "--angle", "1"], "--speed is missing"),
        (&["collide", "--body", "disc", "--vx", "1"], "--vy is missing"),
        (&["collide", "--body", "disc", "--vx", "1", "--vy", "-1"], "--mu is missing"),
        (&["collide", "--body", "disc", "--vy", "-1", "--mu", "1"], "--e is missing"),
        (
            &["collide", "--body", "disc", "--vy", "1", "--mu", "1", "--e", "1"],
            "change the signs of both",
        ),
    ] {
        let run = kane(arguments);
        assert_eq!(run.code, 2, "{arguments:?}");
        assert!(run.stderr.contains(message), "{arguments:?}: {}", run.stderr);
    }
}

#[test]
fn one_law_in_depth_has_all_lanes_and_its_source() {
    let run = run(&with("--law", "smith-1991"));
    assert_eq!(run.code, 0, "{}", run.stderr);
    for part in
        ["8 of 8 exact checks hold", "algebraic", "root", "plain", "enclosure", "C. E. Smith"]
    {
        assert!(run.stdout.contains(part), "{part} is missing from\n{}", run.stdout);
    }
    assert!(!run.stdout.contains("DOES NOT HOLD") && !run.stdout.contains("NaN"), "{}", run.stdout);
}

#[test]
fn inputs_of_a_thousand_digits_do_not_hang() {
    let mu = format!("0.3{}", "1234567".repeat(140));
    let mut arguments = with("--mu", &mu);
    let run_all = run(&arguments);
    assert_eq!(run_all.code, 0, "{}", run_all.stderr);
    assert!(run_all.stdout.contains("no outcome  smith-1991: the outcome is irrational"));
    arguments.extend(["--law", "smith-1991"].map(str::to_owned));
    assert_eq!(run(&arguments).code, 3);
}

#[test]
fn an_exact_direction_gives_short_fractions() {
    let arguments =
        "collide --sphere 7/2 --speed 1 --half-tangent 1/3 --mu 1/2 --e 1 --law wang-su-li";
    let run = kane(&arguments.split(' ').collect::<Vec<_>>());
    assert_eq!(run.code, 0, "{}", run.stderr);
    // v_t = 3/5, a = 4/5: alpha = 7/2*1/2*2*(4/5)/(2*3/5) = 7/3
    let alpha = run.stdout.lines().find(|line| line.starts_with("alpha"));
    assert!(alpha.is_some_and(|line| line.contains(" 7/3 ")), "{}", run.stdout);
    let k = run.stdout.lines().find(|line| line.starts_with("k "));
    assert!(k.is_some_and(|line| line.contains(" -2/5 ")), "{}", run.stdout);
}

#[test]
fn a_law_on_invented_numbers_is_left_out_until_it_is_given_some() {
    let run_all = run(&EXAMPLE.map(str::to_owned));
    assert!(run_all.stdout.contains("their parameters would be invented"), "{}", run_all.stdout);
    let given = run(&with("--param", "tilted-2004.tilt=1/20"));
    let row = |id: &str| given.stdout.lines().any(|line| line.starts_with(id));
    assert!(row("tilted-2004 ") && !row("tilted-2002 ") && !row("saitoh "), "{}", given.stdout);
    let asked = run(&with("--law", "saitoh"));
    assert!(asked.stdout.contains("its default turn is invented"), "{}", asked.stdout);
}

#[test]
fn without_friction_the_slip_stays_and_k_is_1() {
    for (mu, vy) in [("0", "-1"), ("1/2", "0")] {
        let run = kane(&[
            "collide",
            "--sphere",
            "7/2",
            "--vx",
            "1",
            "--vy",
            vy,
            "--mu",
            mu,
            "--e",
            "0.5",
            "--law",
            "routh-newton",
            "--format",
            "json",
        ]);
        let report: Value = serde_json::from_str(&run.stdout).expect("it is JSON");
        let outcome = &report["laws"][0]["outcome"];
        let all = outcome["quantities"].as_array().expect("a list");
        let of = |symbol: &str| {
            all.iter().find(|quantity| quantity["symbol"] == symbol).expect("it is there")
        };
        assert_eq!(of("k")["exact"], "1", "mu = {mu}, vy = {vy}");
        assert!(of("i_x")["exact"].is_null(), "there is no friction to compare with");
        assert!(!outcome["regime"].as_str().expect("a word").contains("grows"), "{outcome}");
    }
}

/// What is out of the range of f64 is no 0, and is not left out.
#[test]
fn what_floats_do_not_reach_is_said() {
    let arguments = ["collide", "--body", "sphere", "--vx", "1e-320", "--vy", "-1e300"];
    let run = kane(&[&arguments[..], &["--mu", "1e5", "--e", "1"]].concat());
    assert!(run.stdout.contains("alpha beyond f64, T- beyond f64"), "{}", run.stdout);
    let row = run.stdout.lines().find(|line| line.starts_with("garwin ")).expect("a row");
    let cells: Vec<&str> = row.split("  ").map(str::trim).filter(|cell| !cell.is_empty()).collect();
    assert_eq!(cells[1..4], ["-1.000", "below f64", "0"], "{row}");
    let row = run.stdout.lines().find(|line| line.starts_with("kane-levinson ")).expect("a row");
    assert!(row.matches("below f64").count() == 2, "{row}");
}

/// The slip may point either way: alpha has its sign, and i_x is that of a forward slip.
#[test]
fn every_law_checks_out_whichever_way_the_contact_slips() {
    for law in kane::impact::laws() {
        for vx in ["1/3", "-1/3"] {
            let arguments =
                ["collide", "--sphere", "7/2", "--vx", vx, "--vy", "-1", "--mu", "1/10"];
            let run = kane(&[&arguments[..], &["--e", "1/2", "--law", law.info.id]].concat());
            assert_eq!(run.code, 0, "{}", run.stdout);
            assert!(!run.stdout.contains("DOES NOT HOLD"), "{}", run.stdout);
        }
    }
}

/// In JSON an exact value is a fraction in full, near the float beside it; what has a root in it has
/// digits alone.
#[test]
fn exact_values_have_one_form() {
    let run = kane(&["collide", "docs/collisions/rod-tip.toml", "--format", "json"]);
    let report: Value = serde_json::from_str(&run.stdout).expect("it is JSON");
    let (mut fractions, mut roots) = (0, 0);
    for law in report["laws"].as_array().expect("a list") {
        for quantity in law["outcome"]["quantities"].as_array().into_iter().flatten() {
            match (quantity["exact"].as_str(), quantity["float"].as_f64()) {
                (Some(exact), Some(float)) => {
                    let exact = kane::number::parse(exact).expect("a fraction");
                    let near: f64 =
                        kane::number::encode(&exact, kane::number::Rounding::NearestEven);
                    // the float is what the law gives in floats: some hundred roundings of 2^-53 each
                    assert!((near - float).abs() <= near.abs() * 2f64.powi(-44), "{quantity}");
                    fractions += 1;
                }
                (None, Some(_)) => {
                    assert!(quantity["digits"].is_string(), "{quantity}");
                    roots += 1;
                }
                (_, None) => {}
            }
        }
    }
    assert!(fractions > 50 && roots > 5, "{fractions} {roots}");
}

#[test]
fn y_points_away_from_the_plane_in_flags_and_files() {
    let dir = scratch("collide-signs");
    let file = |name: &str, body: &str| {
        let path = dir.join(name);
        fs::write(&path, format!("friction = 0.1\nrestitution = 0.5\n{body}")).expect("writable");
        path.to_str().expect("UTF-8").to_owned()
    };
    let sphere = |vy: &str, spin: &str| {
        format!(
            "[sphere]\nmass_kg = 1\nradius_m = 1\nvelocity_m_s = [1, {vy}]\nspin_rad_s = {spin}\n"
        )
    };
    let planar = "[planar.body]\nmass_kg = 1\ninertia_kg_m2 = 0.4\narm_m = [0, -1]\nvelocity_m_s = [1, -2]\nspin_rad_s = 3\n";
    let exact = |arguments: &[&str]| {
        let run = kane(&[arguments, &["--law", "routh-newton", "--format", "json"]].concat());
        let report: Value = serde_json::from_str(&run.stdout).expect(&run.stderr);
        let all = report["laws"][0]["outcome"]["quantities"].as_array().expect("a list").clone();
        ["v_t", "p_t", "v_x", "v_y", "omega"].map(|symbol| {
            let found = all.iter().find(|quantity| quantity["symbol"] == symbol);
            found.expect("it is there")["exact"].as_str().expect("it has a value").to_owned()
        })
    };
    let flags = "collide --body sphere --vx 1 --vy -2 --spin 3 --mu 0.1 --e 0.5";
    let by_flags = exact(&flags.split(' ').collect::<Vec<_>>());
    assert_eq!(by_flags[0], "4", "the slip is v_x + omega*r");
    assert_eq!(by_flags, exact(&["collide", &file("sphere.toml", &sphere("-2", "3"))]));
    assert_eq!(by_flags, exact(&["collide", &file("planar.toml", planar)]));
    // a file from before gets told what changed
    let run = kane(&["collide", &file("old.toml", &sphere("2", "-3"))]);
    assert_eq!(run.code, 2);
    assert!(
        run.stderr.contains("change the signs of both") && run.stderr.contains(":6:"),
        "{}",
        run.stderr
    );
}

#[test]
fn a_parameter_reaches_its_law_and_the_command() {
    let run = run(&with("--param", "walton.beta0=1/8"));
    let walton = run.stdout.lines().find(|line| line.starts_with("walton"));
    assert!(walton.is_some_and(|line| line.contains("-0.1250")), "{}", run.stdout);
    assert!(run.stdout.contains("--param walton.beta0=1/8"), "{}", run.stdout);
}

#[test]
fn a_law_that_creates_energy_is_marked_in_words() {
    let run =
        kane(&"collide --body hoop --vx 1/2 --vy -2 --mu 1 --e 1".split(' ').collect::<Vec<_>>());
    assert_eq!(run.code, 0, "a table is information: {}", run.stderr);
    assert!(run.stdout.contains("whittaker-uncapped"), "{}", run.stdout);
    assert!(run.stdout.contains("creates energy: slide"), "{}", run.stdout);
    assert!(run.stdout.contains("energy is created by  whittaker-uncapped"), "{}", run.stdout);
}

#[test]
fn a_law_without_an_outcome_says_why_and_alone_exits_3() {
    let file = "docs/collisions/double-pendulum.toml";
    let table = kane(&["collide", file]);
    assert_eq!(table.code, 0, "{}", table.stderr);
    assert!(table.stdout.contains("no outcome  keller-printed: the law is printed for contacts"));
    let alone = kane(&["collide", file, "--law", "keller-printed"]);
    assert_eq!(alone.code, 3, "{}", alone.stdout);
    assert!(alone.stdout.contains("keller-printed: no outcome"), "{}", alone.stdout);
}

#[test]
fn nothing_that_is_printed_is_nan() {
    for (vx, vy, mass) in [
        ("0", "0", "1"),
        ("1e308", "-1e308", "1e-300"),
        ("1e-320", "-1e-310", "1e300"),
        ("0", "-1", "1"),
    ] {
        for format in ["text", "json", "markdown"] {
            for law in [None, Some("wang-su-li"), Some("smith-1991")] {
                let mut arguments = vec![
                    "collide", "--body", "sphere", "--vx", vx, "--vy", vy, "--mass", mass, "--mu",
                    "0.1", "--e", "1", "--format", format,
                ];
                arguments.extend(law.iter().flat_map(|law| ["--law", law]));
                let run = kane(&arguments);
                assert_eq!(run.code, 0, "{arguments:?}: {}", run.stderr);
                assert!(!run.stdout.contains("NaN"), "{arguments:?}: {}", run.stdout);
            }
        }
    }
}

#[test]
fn json_has_every_law_and_is_documented() {
    let schema = include_str!("../../docs/collide-format.md");
    let mut undocumented = Vec::new();
    for law in [None, Some("walton")] {
        let mut arguments = with("--format", "json");
        arguments.extend(law.iter().flat_map(|law| ["--law".to_owned(), (*law).to_owned()]));
        let run = run(&arguments);
        let report: Value = serde_json::from_str(&run.stdout).expect("it is JSON");
        assert_eq!(report["schema"]["name"], "kane-collide");
        let version = format!("`version` is `{}`", report["schema"]["version"]);
        assert!(schema.contains(&version), "{version}");
        assert_eq!(report["laws"].as_array().map(Vec::len), Some(law.map_or(18, |_| 1)));
        fields(&report, &mut |field| {
            if !schema.contains(&format!("`{field}`")) {
                undocumented.push(field.to_owned());
            }
        });
    }
    assert!(undocumented.is_empty(), "not in docs/collide-format.md: {undocumented:?}");
}

/// Calls `see` with the name of every field, at any depth.
fn fields(value: &Value, see: &mut impl FnMut(&str)) {
    match value {
        Value::Object(object) => object.iter().for_each(|(name, value)| {
            see(name);
            fields(value, see);
        }),
        Value::Array(array) => array.iter().for_each(|value| fields(value, see)),
        _ => {}
    }
}

#[test]
fn out_writes_every_form() {
    let dir = scratch("collide-out");
    let target = dir.join("new");
    let path = target.to_str().expect("UTF-8");
    let run = kane(&["collide", "docs/collisions/rod-tip.toml", "--out", path]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    for (ending, format) in [("txt", "text"), ("md", "markdown"), ("json", "json")] {
        let written = fs::read_to_string(target.join(format!("rod-tip.{ending}")));
        let shown = kane(&["collide", "docs/collisions/rod-tip.toml", "--format", format]).stdout;
        assert_eq!(written.expect("it was written"), shown, "{format}");
    }
    for (ending, beginning) in [("html", "<!DOCTYPE html>"), ("tex", "\\documentclass")] {
        let written = fs::read_to_string(target.join(format!("rod-tip.{ending}")));
        assert!(written.expect("it was written").starts_with(beginning), "{ending}");
    }
    let count = fs::read_dir(&target).expect("it was made").count();
    let drawn = fs::read_to_string(target.join("rod-tip-impulse.svg")).expect("it was drawn");
    // every law that answers is named in the plane of the impulse, or beyond it
    for law in ["routh-newton", "stronge-1990", "kane-levinson"] {
        assert!(drawn.contains(law), "{law}");
    }
    assert_eq!(count, 6, "no temporary file is left");
}

#[test]
fn a_file_s_fault_is_shown_in_its_line() {
    let dir = scratch("collide-files");
    let good = "friction = 0.3\nrestitution = 0.5\n";
    let rod = "[rod-tip]\nmass_kg = 1\nlength_m = 1\nhalf_tangent = \"1/2\"\n";
    for (name, text, place, message) in [
        ("unknown", format!("{good}colour = 1\n"), ":3:1", "unknown field `colour`"),
        ("missing", format!("{good}{rod}"), ":3:1", "missing field `velocity_m_s`"),
        ("syntax", "friction = = 1\n".to_owned(), ":1:12", ""),
        ("none", good.to_owned(), "none.toml", "exactly one of"),
        ("empty", String::new(), "empty.toml", "the file is empty"),
        (
            "domain",
            format!("friction = -0.3\nrestitution = 0.5\n{rod}velocity_m_s = [0, -1]\n"),
            ":1:12",
            "friction is -0.3, but must be at least 0",
        ),
        (
            "word",
            format!("{good}{rod}velocity_m_s = [\"fast\", -1]\n"),
            ":7:17",
            "velocity_m_s cannot be fast",
        ),
        (
            "nan",
            format!("{good}{rod}velocity_m_s = [nan, -1]\n"),
            ":7:17",
            "velocity_m_s cannot be nan",
        ),
        (
            "apart",
            format!("{good}{rod}velocity_m_s = [0, 1]\n"),
            ":7:1",
            "the bodies move apart: the approach speed is -1",
        ),
    ] {
        let path = dir.join(format!("{name}.toml"));
        fs::write(&path, text).expect("the scratch directory is writable");
        let run = kane(&["collide", path.to_str().expect("UTF-8")]);
        assert_eq!(run.code, 2, "{name}: {}", run.stdout);
        assert!(run.stderr.starts_with("error: "), "{name}: {}", run.stderr);
        assert!(
            run.stderr.contains(message) && run.stderr.contains(place),
            "{name}: {}",
            run.stderr
        );
        if place.starts_with(':') {
            assert!(run.stderr.contains('^'), "{name}: {}", run.stderr);
        }
    }
}

#[test]
fn bodies_that_move_apart_are_told_with_the_flags_that_say_so() {
    let flags = ["--body", "hoop", "--vx", "0", "--vy", "1", "--mu", "0.1", "--e", "1/2"];
    let run = kane(&[&["collide"][..], &flags].concat());
    assert_eq!(run.code, 2, "{}", run.stdout);
    assert!(run.stderr.contains("--vy"), "{}", run.stderr);
}

#[test]
fn a_file_and_flags_are_two_collisions() {
    let run = kane(&["collide", "docs/collisions/ellipse.toml", "--mu", "0.1"]);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("--mu and docs/collisions/ellipse.toml"), "{}", run.stderr);
}

#[test]
fn decimals_in_a_file_are_exact() {
    let dir = scratch("collide-exact");
    let path = dir.join("exact.toml");
    let text = "friction = 0.1\nrestitution = 1\n[sphere]\nmass_kg = 1\nradius_m = 1\nvelocity_m_s = [0.1, -0.3]\n";
    fs::write(&path, text).expect("the scratch directory is writable");
    let run = kane(&["collide", path.to_str().expect("UTF-8"), "--law", "wang-su-li"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    // alpha = 7/2*1/10*2*(3/10)/(2*1/10)
    let alpha = run.stdout.lines().find(|line| line.starts_with("alpha"));
    assert!(alpha.is_some_and(|line| line.contains(" 21/20 ")), "{}", run.stdout);
}

#[test]
fn help_shows_examples_parameters_and_exit_codes() {
    let run = kane(&["collide", "--help"]);
    assert_eq!(run.code, 0);
    for part in [
        "kane collide --sphere 7/2 --speed 3.9 --angle 20 --mu 0.092 --e 0.98",
        "kane collide double-pendulum",
        "walton.beta0 = 11/25",
        "Exit codes:",
    ] {
        assert!(run.stdout.contains(part), "{part} is missing from\n{}", run.stdout);
    }
    for law in kane::impact::laws() {
        for parameter in law.info.parameters {
            let name = format!("{}.{} = {}", law.info.id, parameter.name, parameter.default());
            let line = run.stdout.lines().find(|line| line.trim_start().starts_with(&name));
            let told = line.is_some_and(|line| line.contains(parameter.meaning));
            assert!(told, "{name} is missing from\n{}", run.stdout);
        }
    }
}
