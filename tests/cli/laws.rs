//! `kane laws`: exit codes, one cell in full, and files.

use std::fs;

use serde_json::Value;

use crate::{kane, scratch};

#[test]
fn decided_cells_exit_0_whatever_is_found() {
    let run = kane(&["laws", "--law", "wang-su-li", "--property", "cone"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(run.stdout.contains("1 law, 1 property: 1 refuted"), "{}", run.stdout);
    let run = kane(&["laws", "--law", "chatterjee-ruina", "--property", "energy"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(run.stdout.contains("1 law, 1 property: 1 proved"), "{}", run.stdout);
}

#[test]
fn laws_and_properties_may_be_repeated_and_keep_their_order() {
    let ids = ["--law", "walton", "--law", "smith-1991", "--property", "C3", "--property", "odd"];
    let run = kane(&[&["laws"], &ids[..]].concat());
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(run.stdout.contains("2 laws, 2 properties: 4 proved"), "{}", run.stdout);
    let at = |id: &str| run.stdout.find(&format!("\n{id} ")).expect("the law has a row");
    assert!(at("smith-1991") < at("walton"));
}

#[test]
fn an_unknown_id_is_bad_input_with_a_suggestion() {
    for (arguments, hint) in [
        (["--law", "wang-su-l"], "no law is called `wang-su-l`; did you mean `wang-su-li`?"),
        (["--property", "energi"], "no property is called `energi`; did you mean `energy`?"),
        (["--explain", "smith-1992:C1"], "did you mean `smith-1991`?"),
        (["--explain", "smith-1991:continuty"], "did you mean `continuity`?"),
        (["--explain", "smith-1991"], "`smith-1991` is not LAW:PROPERTY"),
    ] {
        let run = kane(&[&["laws"], &arguments[..]].concat());
        assert_eq!(run.code, 2, "{arguments:?}");
        assert!(run.stdout.is_empty() && run.stderr.contains(hint), "{}", run.stderr);
    }
}

#[test]
fn alpha_is_not_asked_of_a_law_in_a_frame_of_its_own() {
    let run = kane(&["laws", "--explain", "tilted-2002:C1"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(run.stdout.contains("not applicable: the law's cone and restitution stand about"));
    // the witness is at a slip that leans, and says in which axes it was asked
    let run = kane(&["laws", "--explain", "saitoh:cone-sphere"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(run.stdout.contains("asked in the contact's frame"), "{}", run.stdout);
}

#[test]
fn every_form_is_written_and_the_json_is_the_documented_one() {
    let dir = scratch("laws");
    let target = dir.join("new/matrix");
    let selection = ["laws", "--law", "wang-su-li", "--property", "cone", "--property", "C1"];
    let out = ["--out", target.to_str().expect("UTF-8")];
    let run = kane(&[&selection[..], &out[..]].concat());
    assert_eq!(run.code, 0, "{}", run.stderr);
    for (ending, format) in [("txt", "text"), ("md", "markdown"), ("json", "json")] {
        let written = fs::read_to_string(target.join(format!("laws.{ending}"))).expect(ending);
        assert_eq!(written, kane(&[&selection[..], &["--format", format]].concat()).stdout);
    }

    for (name, beginning) in
        [("laws.html", "<!DOCTYPE html>"), ("matrix.svg", "<svg"), ("matrix.csv", "law,property,")]
    {
        let written = fs::read_to_string(target.join(name)).expect(name);
        assert!(written.starts_with(beginning), "{name}");
    }

    let json = fs::read_to_string(target.join("laws.json")).expect("it was written");
    let value: Value = serde_json::from_str(&json).expect("it is JSON");
    let page = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/laws-schema.md");
    let page = fs::read_to_string(page).expect("the page is there");
    let law = &value["laws"][0];
    for object in [&value, &law["cells"]["cone"], &law["cells"]["cone"]["witness"][0]] {
        for field in object.as_object().expect("an object").keys() {
            assert!(page.contains(&format!("`{field}`")), "{field} is not documented");
        }
    }
    assert_eq!(law["cells"]["cone"]["finding"], "refuted");
    assert_eq!(law["cells"]["C1"]["finding"], "proved");
}
