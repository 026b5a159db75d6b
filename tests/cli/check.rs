//! `kane check`: logs, forms, exit codes; and an engine written out in full whose log is named.

use std::fmt::Write as _;
use std::fs;
use std::io::Write as _;
use std::path::Path;
use std::process::Stdio;

use crate::{command, finish, kane, scratch};

/// How a solver bounds friction.
#[derive(Clone, Copy, PartialEq)]
enum Bound {
    /// by the normal impulse with restitution
    Whole,
    /// by that of compression: friction is solved first, and restitution is added
    Compression,
}

/// Steps a disc above a plane with sequential impulses until it has left it: an engine in a few
/// lines, which knows no law.
fn bounce(bound: Bound, mu: f64, e: f64, vx: f64, dt: f64) -> [f64; 3] {
    let (mass, inertia, radius) = (1.0, 0.5, 1.0);
    let (mut height, mut v, mut spin) = (radius + 2.5 * dt, [vx, -1.0], 0.0);
    for _ in 0..8 {
        if height + dt * v[1] <= radius && v[1] < 0.0 {
            let approach = -v[1];
            let (mut push, mut rub) = (0.0_f64, 0.0_f64);
            for _ in 0..10 {
                let more = (push + mass * (-v[1])).max(0.0) - push;
                push += more;
                v[1] += more / mass;
                let share = if bound == Bound::Whole { 1.0 + e } else { 1.0 };
                let slip = v[0] + radius * spin;
                let stop = -slip / (1.0 / mass + radius * radius / inertia);
                let more = (rub + stop).clamp(-mu * push * share, mu * push * share) - rub;
                rub += more;
                v[0] += more / mass;
                spin += radius * more / inertia;
            }
            v[1] += e * approach;
        }
        height += dt * v[1];
    }
    [v[0], v[1], spin]
}

fn log(dir: &Path, name: &str, bound: Bound) -> String {
    let mut text = String::from(
        "id,mass,radius,inertia,mu,e,dt,vx_pre,vy_pre,omega_pre,vx_post,vy_post,omega_post\n",
    );
    for e in [0.0, 0.45, 0.9] {
        for slip in 1..30 {
            let (mu, vx, dt) = (0.3, 0.31 * f64::from(slip), 1.0 / 240.0);
            let [x, y, spin] = bounce(bound, mu, e, vx, dt);
            let _ = writeln!(text, "{slip}-{e},1,1,0.5,{mu},{e},{dt},{vx},-1,0,{x},{y},{spin}");
        }
    }
    let path = dir.join(name);
    fs::write(&path, text).expect("the scratch folder is ours");
    path.to_str().expect("UTF-8").to_owned()
}

#[test]
fn an_engine_is_named_by_its_log() {
    let dir = scratch("check-engine");
    let whole = log(&dir, "whole.csv", Bound::Whole);
    let run = kane(&["check", &whole]);
    assert_eq!(run.code, 0, "{}", run.stdout);
    let says = "Restitution as stated; friction is Coulomb's, which stops the slip";
    assert!(run.stdout.contains(says), "{}", run.stdout);
    assert!(run.stdout.contains("one-step law of time-stepping engines"), "{}", run.stdout);

    let first = log(&dir, "first.csv", Bound::Compression);
    let run = kane(&["check", &first]);
    assert_eq!(run.code, 1, "{}", run.stdout);
    for says in ["saturates at mu*p_n/(1 + e)", "solved before", "of 87 impacts slide below the"] {
        assert!(run.stdout.contains(says), "{says}: {}", run.stdout);
    }
    let worse = kane(&["check", &first, "--baseline", &whole]);
    assert_eq!(worse.code, 1, "{}", worse.stdout);
    assert!(worse.stdout.contains("Worse than before."), "{}", worse.stdout);
    assert_eq!(kane(&["check", &whole, "--baseline", &first]).code, 1, "another law of friction");
    assert_eq!(kane(&["check", &whole, "--baseline", &whole]).code, 0);

    let head = dir.join("head.csv");
    let text = fs::read_to_string(&whole).expect("it was written");
    fs::write(&head, text.lines().next().expect("a head")).expect("the scratch folder is ours");
    let head = head.to_str().expect("UTF-8");
    for (new, old) in [(head, &whole[..]), (&whole, head)] {
        let run = kane(&["check", new, "--baseline", old]);
        assert_eq!(run.code, 3, "of nothing nothing is said: {}", run.stdout);
    }
    let out = dir.to_str().expect("UTF-8");
    let run = kane(&["check", &whole, "--baseline", &whole, "--out", out]);
    assert_eq!(run.code, 2, "a comparison writes no files: {}", run.stdout);
}

#[test]
fn without_a_stated_mu_no_law_of_friction_is_named() {
    let dir = scratch("check-unstated");
    let path = log(&dir, "log.csv", Bound::Whole);
    let text = fs::read_to_string(&path).expect("it was written").replacen(",mu,", ",note,", 1);
    fs::write(&path, text).expect("the scratch folder is ours");
    let run = kane(&["check", &path]);
    let sentence = run.stdout.replace('\n', " ");
    let says =
        "friction's law is not told without a stated mu (it is 0.3*p_n where contacts slide on)";
    assert!(run.code == 0 && sentence.contains(says), "{}", run.stdout);
}

/// Every second impact is Coulomb's, and the others have no friction at all.
#[test]
fn laws_that_the_impacts_do_not_tell_apart_are_named_together() {
    let dir = scratch("check-tied");
    let mut text = String::from(
        "mass,radius,inertia,mu,e,vx_pre,vy_pre,omega_pre,vx_post,vy_post,omega_post\n",
    );
    for place in 1..41 {
        let vx = 0.31 * f64::from(place);
        let rub = if place % 2 == 0 { 0.0 } else { -(vx / 3.0).min(0.3 * 1.5) };
        let _ = writeln!(text, "1,1,0.5,0.3,0.5,{vx},-1,0,{},0.5,{}", vx + rub, 2.0 * rub);
    }
    let path = dir.join("log.csv");
    fs::write(&path, text).expect("the scratch folder is ours");
    let run = kane(&["check", path.to_str().expect("UTF-8")]);
    assert_eq!(run.code, 1, "{}", run.stderr);
    let sentence = run.stdout.replace("\n", " ");
    for says in [
        "the nearest",
        "friction is Coulomb's, which stops the slip, to 0.01 of k in 20 of 40 impacts",
        "or is absent, in 20",
    ] {
        assert!(sentence.contains(says), "{says}: {}", run.stdout);
    }
}

#[test]
fn a_worst_row_is_replayed_by_the_command_beside_it() {
    let dir = scratch("check-replay");
    let log = log(&dir, "log.csv", Bound::Compression);
    let run = kane(&["check", &log]);
    let command = run.stdout.lines().find(|line| line.trim().starts_with("kane collide "));
    let command = command.expect("a round body is asked for by flags").trim();
    let arguments: Vec<&str> = command.split_whitespace().skip(1).collect();
    let collided = kane(&arguments);
    assert_eq!(collided.code, 0, "{command}: {}", collided.stderr);
    assert!(collided.stdout.contains("kane-levinson"), "{}", collided.stdout);

    // a spin counts the same way there: the slip is 2 − 1/2
    let head = "mass,radius,inertia,mu,e,vx_pre,vy_pre,omega_pre,vx_post,vy_post,omega_post";
    let spinning = dir.join("spinning.csv");
    fs::write(&spinning, format!("{head}\n1,1,0.5,0.25,0.5,2,-1,-0.5,2,0.25,-0.5\n"))
        .expect("the scratch folder is ours");
    let run = kane(&["check", spinning.to_str().expect("UTF-8")]);
    let command = run.stdout.lines().map(str::trim).find(|line| line.starts_with("kane collide "));
    let arguments: Vec<&str> = command.expect("e is off").split_whitespace().skip(1).collect();
    let collided = kane(&arguments);
    assert!(collided.stdout.contains("v_t = 1.500 m/s"), "{arguments:?}: {}", collided.stdout);

    let row = kane(&["check", &log, "--row", "3"]);
    assert_eq!(row.code, 0, "{}", row.stderr);
    let file = dir.join("row.toml");
    fs::write(&file, &row.stdout).expect("the scratch folder is ours");
    assert_eq!(kane(&["collide", file.to_str().expect("UTF-8")]).code, 0, "{}", row.stdout);
    assert_eq!(kane(&["check", &log, "--row", "1"]).code, 2, "the header is no row");
}

#[test]
fn every_form_is_written_and_two_runs_agree() {
    let dir = scratch("check-forms");
    let log = log(&dir, "log.csv", Bound::Whole);
    let out = dir.join("out");
    let run = kane(&["check", &log, "--out", out.to_str().expect("UTF-8")]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let read = |ending: &str| fs::read_to_string(out.join(format!("log-check.{ending}")));
    assert_eq!(read("txt").expect("it was written"), run.stdout);
    let json = read("json").expect("it was written");
    assert_eq!(json, kane(&["check", &log, "--format", "json"]).stdout);
    assert!(json.contains("\"as_expected\": true"), "{json}");
    assert_eq!(
        read("md").expect("it was written"),
        kane(&["check", &log, "--format", "markdown"]).stdout
    );
    let page = read("html").expect("it was written");
    let drawn = |name: &str| fs::read_to_string(out.join(format!("log-check-{name}.svg")));
    let picture = drawn("k-over-alpha").expect("it was drawn");
    assert!(picture.contains("<title>The tangential velocity ratio") && page.contains("<svg"));
    // what happens in every row needs no picture of where
    assert!(drawn("energy").is_err() && drawn("e-over-phase").is_err());
}

/// How many times a text has a part.
fn count(text: &str, part: &str) -> usize {
    text.matches(part).count()
}

#[test]
fn every_check_is_a_test_for_continuous_integration() {
    let dir = scratch("check-junit");
    let (whole, first) =
        (log(&dir, "whole.csv", Bound::Whole), log(&dir, "first.csv", Bound::Compression));
    let run = kane(&["check", &first, "--format", "junit"]);
    assert_eq!(run.code, 1, "{}", run.stdout);
    // ten checks, the rows and the units; one fails, and two have nothing to ask
    for part in [
        "<testsuites name=\"kane check\" tests=\"12\" failures=\"1\" errors=\"0\">",
        "skipped=\"2\">",
    ] {
        assert!(run.stdout.contains(part), "{part}: {}", run.stdout);
    }
    assert_eq!(count(&run.stdout, "<testcase "), 12);
    assert_eq!((count(&run.stdout, "<failure "), count(&run.stdout, "<skipped/>")), (1, 2));
    let at = run.stdout.find("name=\"sticks: ").expect("it is one of them");
    assert!(run.stdout[at..].contains("<failure message=\"FAILS in "), "{}", run.stdout);
    assert!(run.stdout.contains("mu*p_n/(1 + e)"), "the sentence is there: {}", run.stdout);

    let out = dir.join("out");
    kane(&["check", &first, "--out", out.to_str().expect("UTF-8")]);
    let file = fs::read_to_string(out.join("first-check.xml")).expect("it was written");
    assert_eq!(
        file.strip_suffix(&format!("\n<!-- written by kane {} -->\n", env!("CARGO_PKG_VERSION"))),
        Some(run.stdout.trim_end())
    );
    // a second run knows the file as its own
    let again = kane(&["check", &first, "--out", out.to_str().expect("UTF-8")]);
    assert_eq!((again.code, &*again.stderr), (1, ""));

    let worse = kane(&["check", &first, "--baseline", &whole, "--format", "junit"]);
    assert_eq!(worse.code, 1, "{}", worse.stdout);
    assert!(worse.stdout.contains("name=\"friction: "), "{}", worse.stdout);
    assert!(count(&worse.stdout, "<failure ") >= 2, "{}", worse.stdout);
    let same = kane(&["check", &whole, "--baseline", &whole, "--format", "junit"]);
    assert_eq!((same.code, count(&same.stdout, "<failure ")), (0, 0), "{}", same.stdout);
}

#[test]
fn a_name_that_xml_cannot_bear_is_written_otherwise() {
    let dir = scratch("check-junit-name");
    let log = log(&dir, "a<b>&\"c\u{1}.csv", Bound::Whole);
    let run = kane(&["check", &log, "--format", "junit"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(run.stdout.contains("a&lt;b&gt;&amp;&quot;c\\u{1}.csv"), "{}", run.stdout);
}

#[test]
fn what_cannot_be_checked_ends_with_two_or_three() {
    let dir = scratch("check-bad");
    let write = |name: &str, text: &str| {
        let path = dir.join(name);
        fs::write(&path, text).expect("the scratch folder is ours");
        path.to_str().expect("UTF-8").to_owned()
    };
    let head = "mass,radius,inertia,vx_pre,vy_pre,omega_pre,vx_post,vy_post,omega_post\n";
    for (name, text, says) in [
        ("empty.csv", "", "empty"),
        ("columns.csv", "a,b\n1,2\n", "columns are missing: mass1_kg"),
        ("degrees.csv", &head.replace("omega_pre", "omega_pre_deg_s"), "convert it to SI"),
        ("array.jsonl", "[1]\n", "line 1: no JSON object"),
    ] {
        let run = kane(&["check", &write(name, text)]);
        assert_eq!(run.code, 2, "{name}: {}", run.stdout);
        assert!(run.stderr.contains(says), "{name}: {}", run.stderr);
    }
    let run = kane(&["check", &write("nan.csv", &format!("{head}1,1,0.5,2,-1,0,NaN,0.5,0\n"))]);
    assert_eq!(run.code, 3, "{}", run.stdout);
    assert!(run.stdout.contains("line 2: NaN or infinity in vx1_post_m_s"), "{}", run.stdout);
    assert_eq!(kane(&["check"]).code, 2);
    assert_eq!(kane(&["check", "no-such.csv"]).code, 2);
    assert_eq!(kane(&["check", "Cargo.toml", "--map", "mass1_kg"]).code, 2);
}

#[test]
fn the_schema_and_the_sweep_are_printed() {
    let schema = kane(&["check", "--schema"]);
    assert_eq!(schema.code, 0, "{}", schema.stderr);
    assert!(schema.stdout.contains("omega1_post_rad_s"), "{}", schema.stdout);
    let sweep = kane(&["check", "--generate"]);
    assert_eq!(sweep.code, 0, "{}", sweep.stderr);
    assert!(sweep.stdout.lines().count() > 200, "{}", sweep.stdout);
    // the columns that an engine fills in are empty, and each row says so
    let dir = scratch("check-sweep");
    let file = dir.join("sweep.csv");
    fs::write(&file, &sweep.stdout).expect("the scratch folder is ours");
    let run = kane(&["check", file.to_str().expect("UTF-8")]);
    assert_eq!(run.code, 3, "{}", run.stdout);
    assert!(run.stdout.contains("vx1_post_m_s is empty"), "{}", run.stdout);
    for of_nothing in ["inf", "as the numbers tell", "0 of 0", "Checks"] {
        assert!(!run.stdout.contains(of_nothing), "{of_nothing}: {}", run.stdout);
    }
    let names = "mass1_kg,radius1_m,inertia1_kg_m2,mu,e,vx1_pre_m_s,vy1_pre_m_s,omega1_pre_rad_s,\
                 vx1_post_m_s,vy1_post_m_s,omega1_post_rad_s\n";
    fs::write(&file, names).expect("the scratch folder is ours");
    let run = kane(&["check", file.to_str().expect("UTF-8")]);
    assert_eq!(run.code, 3, "{}", run.stdout);
    assert!(run.stdout.contains("The log has no impacts\n"), "{}", run.stdout);
}

#[test]
fn a_long_headline_is_set_in_lines() {
    let run = kane(&["check", "crates/records/tests/data/mujoco-4.0.0_default.csv"]);
    assert_eq!(run.code, 1, "{}", run.stderr);
    let news = run.stdout.split("\n\n").next().expect("it begins with the news");
    assert!(news.lines().count() > 4, "{news}");
    let widest = news.lines().map(|line| line.chars().count()).max();
    assert!(widest <= Some(100), "{news}");
}

/// A log with the names of an engine is the same log: a preset says what its columns are, and the command that is
/// printed has it.
#[test]
fn a_preset_reads_an_engine_s_own_names() {
    let dir = scratch("check-preset");
    let rows = "1,0.5,1,0.3,0.5,1.5,-1,0,1.05,0.5,0.9\n2,1,1,0.3,0.5,0,-1,0,0,0.5,0\n";
    let plain = "mass,inertia,radius,mu,e,vx_pre,vy_pre,omega_pre,vx_post,vy_post,omega_post\n";
    let theirs = "body_mass,body_inertia[2],geom_size[0],geom_friction[0],e,qvel[0] before,qvel[1] before,\
                  qvel[2] before,qvel[0] after,qvel[1] after,qvel[2] after\n";
    let written = |name: &str, head: &str| {
        let path = dir.join(name);
        std::fs::write(&path, format!("{head}{rows}")).expect("it is writable");
        path.to_str().expect("UTF-8").to_owned()
    };
    let (plain, theirs) = (written("plain.csv", plain), written("theirs.csv", theirs));
    let checks = |arguments: &[&str]| {
        let run = kane(arguments);
        let value: serde_json::Value = serde_json::from_str(&run.stdout).expect("it is JSON");
        (run.code, value["checks"].clone(), value["command"].clone())
    };
    let first = checks(&["check", &plain, "--format", "json"]);
    let second = checks(&["check", &theirs, "--preset", "mujoco", "--format", "json"]);
    assert_eq!((first.0, &first.1), (second.0, &second.1));
    assert!(second.2.as_str().is_some_and(|command| command.contains("--preset mujoco")));
    // without it the columns are missing, and an unknown preset is said with those that there are
    assert_eq!(kane(&["check", &theirs]).code, 2);
    let unknown = kane(&["check", &theirs, "--preset", "havok"]);
    assert!(unknown.code == 2 && unknown.stderr.contains("rapier"), "{}", unknown.stderr);
}

/// A pipe gives what was written so far, which may end within a name.
#[test]
fn a_preset_reads_names_that_come_in_parts() {
    let parts = [
        "body_mass,body_inertia[2],geom_size[0],geom_friction[0],e,qvel[0] bef",
        "ore,qvel[1] before,qvel[2] before,qvel[0] after,qvel[1] after,qvel[2] after\n",
        "2,1,1,0.3,0.5,0,-1,0,0,0.5,0\n",
    ];
    let mut program = command();
    program.args(["check", "-", "--preset", "mujoco"]).stdin(Stdio::piped());
    let mut child =
        program.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("it starts");
    let mut stdin = child.stdin.take().expect("it is piped");
    for part in parts {
        stdin.write_all(part.as_bytes()).expect("the program reads");
        std::thread::sleep(std::time::Duration::from_millis(100));
    }
    drop(stdin);
    let run = finish(child.wait_with_output().expect("it ends"));
    assert_eq!(run.code, 0, "{}{}", run.stdout, run.stderr);
}
