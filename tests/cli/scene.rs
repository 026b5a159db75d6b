//! `kane scene`: models, files, exit codes.

use std::fs;
use std::time::{Duration, Instant};

use crate::{kane, scratch};

#[test]
fn a_scene_is_answered_and_written_in_every_form() {
    let dir = scratch("scene");
    let out = dir.join("out");
    let file = "docs/scenes/backspin.toml";
    let run = kane(&["scene", file, "--compare", "--out", out.to_str().expect("UTF-8")]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(run.stdout.contains("routh-newton/f32: all that is asked for is within its tolerance"));
    assert!(run.stdout.contains(&format!("kane scene {file} --compare")), "{}", run.stdout);
    for ending in
        [".md", ".json", "-motion.svg", "-ledger.svg", "-compare.svg", "-states.csv", "-models.csv"]
    {
        let path = out.join(format!("backspin{ending}"));
        assert!(path.is_file(), "{} is missing", path.display());
    }
    let json = fs::read_to_string(out.join("backspin.json")).expect("it was written");
    let value: serde_json::Value = serde_json::from_str(&json).expect("it is JSON");
    let digest = value["scene"]["sha256"].as_str().expect("it has one").to_owned();
    let printed = std::process::Command::new("sha256sum").arg(file).output().expect("it is there");
    assert!(String::from_utf8_lossy(&printed.stdout).starts_with(&digest), "{digest}");
    assert_eq!(value["scene"]["bodies"][0]["mass_kg"], 0.046);
    assert_eq!(value["scene"]["friction"], 0.6);
    assert_eq!(value["impacts"][0]["who"], serde_json::json!(["body-1", "floor"]));
    assert!(value["impacts"][0]["after"][0]["v_x_m_s"].is_number());
    let states = fs::read_to_string(out.join("backspin-states.csv")).expect("it was written");
    let start = states.lines().nth(1).expect("a row");
    assert!(start.starts_with("start,0,,,body-1,0,"), "{start}");
    assert_eq!(json, kane(&["scene", file, "--compare", "--format", "json"]).stdout);
}

#[test]
fn the_headline_of_one_model_that_was_asked_for_is_about_that_model() {
    for (model, said) in [
        ("whittaker-uncapped", "whittaker-uncapped/f64, the model asked for, is not good enough\n"),
        ("routh-newton/interval", "is not judged: its answers are the middles of intervals\n"),
    ] {
        let run = kane(&["scene", "backspin", "--model", model]);
        assert_eq!(run.code, 1, "{}", run.stderr);
        assert!(run.stdout.contains(said) && !run.stdout.contains("no model"), "{}", run.stdout);
        assert!(!run.stdout.contains("no answer"), "it is shown: {}", run.stdout);
    }
    let help = kane(&["scene", "--help"]).stdout;
    assert!(help.contains("interval"), "what is accepted is told: {help}");
}

#[test]
fn exact_numbers_stand_beside_numbers() {
    let run = kane(&["scene", "docs/scenes/rest.toml", "--format", "json"]);
    let value: serde_json::Value = serde_json::from_str(&run.stdout).expect("it is JSON");
    let end = &value["end"];
    assert_eq!(end["exact"]["time_s"], "21/10");
    assert_eq!(end["time_s"], 2.1);
    assert!(end["bodies"][0]["x_m"].is_number() && end["bodies"][0]["exact"]["x_m"].is_string());
    let rounded = kane(&["scene", "docs/scenes/backspin.toml", "--format", "json"]);
    let value: serde_json::Value = serde_json::from_str(&rounded.stdout).expect("it is JSON");
    assert!(value["end"]["time_s"].is_number() && value["end"]["exact"].is_null());
}

#[test]
fn every_shipped_scene_with_its_pictures_takes_less_than_two_seconds() {
    let out = scratch("scene-all");
    let mut scenes = 0;
    for entry in fs::read_dir("docs/scenes").expect("they are shipped") {
        let path = entry.expect("readable").path();
        let name = path.file_stem().expect("it has a name").to_string_lossy().into_owned();
        let file = path.to_str().expect("UTF-8");
        let timed = || {
            let start = Instant::now();
            let run = kane(&["scene", file, "--out", out.to_str().expect("UTF-8")]);
            assert_eq!(run.code, 0, "{file}: {}", run.stderr);
            start.elapsed()
        };
        // tens of milliseconds; once more, where the machine did something else
        let limit = Duration::from_secs(2);
        assert!(timed() < limit || timed() < limit, "{file}");
        let drawn = |what: &&str| out.join(format!("{name}-{what}.svg")).is_file();
        let pictures: Vec<&str> =
            ["motion", "impulse", "contact"].into_iter().filter(|what| drawn(what)).collect();
        assert_eq!(pictures.len(), 1, "{name}: {pictures:?}");
        assert!(out.join(format!("{name}.html")).is_file(), "{name}");
        scenes += 1;
    }
    assert_eq!(scenes, 20);
}

#[test]
fn another_model_says_by_how_much_it_misses() {
    let run = kane(&["scene", "docs/scenes/backspin.toml", "--model", "whittaker-uncapped"]);
    assert_eq!(run.code, 1, "{}", run.stderr);
    assert!(run.stdout.contains("omega_rad_s off by"), "{}", run.stdout);
    let run = kane(&["scene", "docs/scenes/rod-jam.toml", "--model", "whittaker-uncapped"]);
    assert_eq!(run.code, 3);
    assert!(run.stderr.contains("the contact jams"), "{}", run.stderr);
}

#[test]
fn bad_input_is_shown_with_its_line() {
    let dir = scratch("scene-bad");
    let path = dir.join("bad.toml");
    fs::write(&path, "friction = 0.1\nrestitution = 2\n\n[ask]\nk = 1\n").expect("writable");
    let file = path.to_str().expect("UTF-8");
    for arguments in [
        vec!["scene", file],
        vec!["scene", "no-such-file.toml"],
        vec!["scene", "docs/scenes/rest.toml", "--model", "routh-newto"],
    ] {
        let run = kane(&arguments);
        assert_eq!(run.code, 2, "{arguments:?}");
        assert!(run.stdout.is_empty() && run.stderr.starts_with("error"), "{}", run.stderr);
    }
    assert!(kane(&["scene", file]).stderr.contains("exactly one of"));
    let hint = kane(&["scene", "docs/scenes/rest.toml", "--model", "routh-newto"]).stderr;
    assert!(hint.contains("did you mean `routh-newton`?"), "{hint}");
    let former = kane(&["scene", "docs/scenes/rest.toml", "--model", "coulomb/f32"]);
    assert_eq!(former.code, 2);
    assert!(former.stderr.contains("its law has the id `routh-newton`"), "{}", former.stderr);
}
