//! `--out` writes every form for every document, and over nothing that is not its own.

use std::fs;
use std::path::{Path, PathBuf};

use crate::{document, kane, scratch};

#[test]
fn every_document_becomes_a_file_in_every_form() {
    let dir = scratch("out");
    let one = document(&dir, "one.md", "var x > 0\nclaim a: x > 0");
    let two = document(&dir, "two.md", "var x > 0\nclaim b: x + x = 2*x");
    let reports = dir.join("new/reports");
    let target = reports.to_str().expect("UTF-8");
    let run = kane(&["audit", &one, &two, "--out", target]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(run.stdout.contains("1 claim"), "the report is printed as well: {}", run.stdout);

    let mut names: Vec<_> = fs::read_dir(&reports)
        .expect("the directory was made")
        .map(|entry| entry.expect("readable").file_name().into_string().expect("UTF-8"))
        .collect();
    names.sort();
    assert_eq!(
        names,
        [
            "one",
            "one.cert.json",
            "one.html",
            "one.json",
            "one.md",
            "one.tex",
            "one.v",
            "two",
            "two.cert.json",
            "two.html",
            "two.json",
            "two.md",
            "two.tex",
            "two.v"
        ],
        "and no temporary file is left"
    );

    let question = fs::read_to_string(reports.join("two/b.smt2")).expect("one file a claim");
    assert!(question.ends_with("(check-sat)\n"), "{question}");
    let proof = fs::read_to_string(reports.join("two.v")).expect("it was written");
    assert!(proof.contains("Lemma claim_b :"), "the claim is a lemma");

    let json = fs::read_to_string(reports.join("two.json")).expect("it was written");
    assert_eq!(json, kane(&["audit", &two, "--format", "json"]).stdout);
    let markdown = fs::read_to_string(reports.join("two.md")).expect("it was written");
    assert_eq!(markdown, kane(&["audit", &two, "--format", "markdown"]).stdout);
}

#[test]
fn the_certificates_can_be_had_alone() {
    let dir = scratch("certificates");
    let one = document(&dir, "one.md", "var x > 0\nclaim a: x > 0");
    let two = document(&dir, "two.md", "var x > 0\nclaim b: x + x = 2*x");
    let (all, alone) = (dir.join("all"), dir.join("alone"));
    let audited = |option, target: &Path| {
        let run = kane(&["audit", &one, &two, option, target.to_str().expect("UTF-8")]);
        assert_eq!(run.code, 0, "{}", run.stderr);
        run.stdout
    };
    assert_eq!(audited("--certificates", &alone), audited("--out", &all));
    let files = fs::read_dir(&alone).expect("the directory was made");
    assert_eq!(files.count(), 2, "nothing else is there");
    for name in ["one.cert.json", "two.cert.json"] {
        let held = |of: &Path| fs::read_to_string(of.join(name)).expect("it was written");
        assert_eq!(held(&alone), held(&all), "{name}");
    }
    let both = kane(&["audit", &one, "--certificates", "x", "--out", "y"]);
    assert_eq!(both.code, 2, "--out writes them, too");
}

#[test]
fn the_paper_s_report_has_the_paper_s_name() {
    let dir = scratch("out-paper");
    kane(&["audit", "--out", dir.to_str().expect("UTF-8")]);
    for ending in ["html", "json", "md", "tex"] {
        assert!(dir.join(format!("oblique-collision.{ending}")).is_file(), "{ending}");
    }
    // Coq compiles no file with a hyphen in its name.
    assert!(dir.join("oblique_collision.v").is_file());
}

#[test]
fn two_documents_of_one_name_are_not_written_over_each_other() {
    let dir = scratch("twins");
    fs::create_dir(dir.join("sub")).expect("the scratch directory is writable");
    let one = document(&dir, "same.md", "var x > 0\nclaim a: x > 0");
    let two = document(&dir.join("sub"), "same.md", "var x > 0\nclaim a: x > 0");
    let run = kane(&["audit", &one, &two, "--out", dir.join("out").to_str().expect("UTF-8")]);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("`same`"), "{}", run.stderr);
    assert!(!dir.join("out").exists());
}

#[test]
fn a_directory_that_cannot_be_made_is_an_error() {
    let dir = scratch("blocked");
    let file = document(&dir, "file.md", "var x > 0\nclaim a: x > 0");
    let run = kane(&["audit", &file, "--out", &file]);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("cannot write"), "{}", run.stderr);
}

/// What is below a directory: path and bytes, links as such.
fn contents(dir: &Path) -> Vec<(PathBuf, Vec<u8>)> {
    let mut all = Vec::new();
    for entry in fs::read_dir(dir).expect("it is there") {
        let path = entry.expect("readable").path();
        match path.symlink_metadata().expect("it is there") {
            it if it.is_dir() => all.extend(contents(&path)),
            it if it.is_symlink() => all.push((path, b"a link".to_vec())),
            _ => all.push((path.clone(), fs::read(&path).expect("readable"))),
        }
    }
    all.sort();
    all
}

#[test]
fn an_output_never_replaces_an_input() {
    let dir = scratch("own-input");
    let here = dir.to_str().expect("UTF-8");
    let document = document(&dir, "x.md", "var x > 0\nclaim a: x > 0");
    let scene = dir.join("rest.json");
    fs::copy(concat!(env!("CARGO_MANIFEST_DIR"), "/docs/scenes/rest.toml"), &scene)
        .expect("copied");
    let scene = scene.to_str().expect("UTF-8");
    let collision = dir.join("c.md");
    let shipped = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/collisions/ellipse.toml");
    fs::copy(shipped, &collision).expect("copied");
    let collision = collision.to_str().expect("UTF-8");
    let stability = dir.join("s-stability.md");
    fs::copy(&document, &stability).expect("copied");
    let before = contents(&dir);
    for (arguments, place) in [
        (["audit", &document, "--out", here], "x.md"),
        (["scene", scene, "--out", here], "rest.json"),
        (["collide", collision, "--out", here], "c.md"),
    ] {
        let run = kane(&arguments);
        assert_eq!((run.code, run.stdout.as_str()), (2, ""), "{arguments:?}: {}", run.stderr);
        let wanted = format!("error: cannot write {}: it is an input\n", dir.join(place).display());
        assert_eq!(run.stderr, wanted);
        assert!(contents(&dir) == before, "{arguments:?} wrote something");
    }
    // the same file by another name
    fs::hard_link(&document, dir.join("y.md")).expect("links can be made");
    let run = kane(&["audit", &document, "--out", dir.join("out").to_str().expect("UTF-8")]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    fs::remove_file(dir.join("out/x.md")).expect("it was written");
    fs::hard_link(&document, dir.join("out/x.md")).expect("links can be made");
    let run = kane(&["audit", &document, "--out", dir.join("out").to_str().expect("UTF-8")]);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("it is an input"), "{}", run.stderr);
}

#[test]
fn an_output_never_replaces_what_this_program_did_not_write() {
    let dir = scratch("foreign");
    let document = document(&dir, "x.md", "var x > 0\nclaim a: x > 0");
    for name in ["x.html", "x.md", "x.tex", "x.json", "x.v", "x/a.smt2"] {
        let out = dir.join("out");
        let target = out.to_str().expect("UTF-8");
        fs::create_dir_all(out.join("x")).expect("the scratch directory is writable");
        fs::write(out.join(name), "my notes\n").expect("the scratch directory is writable");
        let before = contents(&out);
        let run = kane(&["audit", &document, "--out", target]);
        assert_eq!((run.code, run.stdout.as_str()), (2, ""), "{name}");
        let place = out.join(name).display().to_string();
        assert!(
            run.stderr.contains(&place) && run.stderr.contains("did not write"),
            "{}",
            run.stderr
        );
        assert!(contents(&out) == before, "{name}: something was written");
        fs::remove_dir_all(&out).expect("it can be removed");
    }
}

#[test]
fn every_verb_knows_its_own_files_and_writes_them_again() {
    let dir = scratch("again");
    let statements = "var x > 0\nclaim a: 1/(1 + x) + 1 > 0";
    let document = document(&dir, "x.md", statements);
    let rest = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/scenes/rest.toml");
    let ellipse = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/collisions/ellipse.toml");
    for (name, arguments) in [
        ("audit", vec!["audit", &document]),
        ("stability", vec!["stability", &document]),
        ("scene", vec!["scene", rest]),
        ("collide", vec!["collide", ellipse]),
        ("laws", vec!["laws", "--law", "wang-su-li", "--property", "C1"]),
        ("figures", vec!["chart", "--figures"]),
    ] {
        let out = dir.join(name);
        let target = out.to_str().expect("UTF-8");
        let arguments = [arguments, vec!["--out", target]].concat();
        let first = kane(&arguments);
        assert_ne!(first.code, 2, "{name}: {}", first.stderr);
        let written = contents(&out);
        assert!(!written.is_empty(), "{name} writes files");
        // what is there is an older version's: the same mark, another text
        for (path, bytes) in &written {
            let text = String::from_utf8(bytes.clone()).expect("UTF-8");
            let older = match path.extension().and_then(|e| e.to_str()) {
                Some("csv") => format!("{text}one more row\n"),
                _ => text.replace(env!("CARGO_PKG_VERSION"), "0.0.9"),
            };
            fs::write(path, older).expect("writable");
        }
        let again = kane(&arguments);
        assert_eq!(again.code, first.code, "{name}: {}", again.stderr);
        assert!(contents(&out) == written, "{name}: not as before");
        // and what has lost its mark is nobody's
        let (path, _) = &written[0];
        fs::write(path, "mine\n").expect("writable");
        let refused = kane(&arguments);
        assert_eq!(refused.code, 2, "{name}: {}", refused.stderr);
        assert_eq!(fs::read(path).expect("it is there"), b"mine\n");
    }
}

#[cfg(unix)]
#[test]
fn links_inside_the_directory_are_not_followed() {
    use std::os::unix::fs::symlink;
    let dir = scratch("links");
    let document = document(&dir, "x.md", "var x > 0\nclaim a: x > 0");
    let elsewhere = dir.join("elsewhere");
    fs::create_dir(&elsewhere).expect("the scratch directory is writable");
    fs::write(elsewhere.join("precious"), "precious\n").expect("writable");
    for (link, to) in [("x.html", "precious"), ("x.json", "missing"), ("x", "")] {
        let out = dir.join("out");
        fs::create_dir_all(&out).expect("the scratch directory is writable");
        symlink(elsewhere.join(to), out.join(link)).expect("links can be made");
        let before = (contents(&out), contents(&elsewhere));
        let run = kane(&["audit", &document, "--out", out.to_str().expect("UTF-8")]);
        assert_eq!(run.code, 2, "{link}");
        assert!(run.stderr.contains("it is a symbolic link"), "{}", run.stderr);
        assert!((contents(&out), contents(&elsewhere)) == before, "{link}: something was written");
        fs::remove_dir_all(&out).expect("it can be removed");
    }
    // a directory that is itself reached through a link is the user's choice
    symlink(&elsewhere, dir.join("named")).expect("links can be made");
    let run = kane(&["audit", &document, "--out", dir.join("named").to_str().expect("UTF-8")]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(elsewhere.join("x.html").is_file());
}
