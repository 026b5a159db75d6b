//! `--out` where the disk does not do as it is told: full, read-only, shared, left in the middle.
#![cfg(target_os = "linux")]

use std::collections::BTreeMap;
use std::fs::{self, File};
use std::path::Path;
use std::process::{Command, Stdio};

use crate::{command, document, finish, kane, scratch};

const STATEMENTS: &str = "var x > 0\nclaim a: 1/(1 + x) + 1 > 0\nclaim b: x + x = 2*x";

/// The files below a directory, but for those that are not yet in their place.
fn complete(dir: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut all = BTreeMap::new();
    for entry in fs::read_dir(dir).expect("it is there") {
        let path = entry.expect("readable").path();
        let name = path.file_name().and_then(|name| name.to_str()).expect("UTF-8").to_owned();
        if path.is_dir() {
            let below = complete(&path).into_iter();
            all.extend(below.map(|(file, bytes)| (format!("{name}/{file}"), bytes)));
        } else if !name.ends_with(".tmp") {
            all.insert(name, fs::read(&path).expect("readable"));
        }
    }
    all
}

#[test]
fn a_full_disk_is_an_error_and_what_was_there_stays() {
    let dir = scratch("disk-full");
    let file = document(&dir, "x.md", STATEMENTS);
    let out = dir.join("out");
    let target = out.to_str().expect("UTF-8");
    assert_eq!(kane(&["audit", &file, "--out", target]).code, 0);
    let before = complete(&out);
    // no file may grow beyond some kilobytes: writing fails in the middle, as where a disk is full
    let script = "trap '' XFSZ; ulimit -f 8; exec \"$0\" \"$@\"";
    let run = Command::new("sh")
        .args(["-c", script, env!("CARGO_BIN_EXE_kane"), "audit", &file, "--out", target])
        .output()
        .expect("there is a shell");
    let run = finish(run);
    assert_eq!((run.code, run.stdout.as_str()), (2, ""), "{}", run.stderr);
    assert!(run.stderr.starts_with("error: cannot write into "), "{}", run.stderr);
    assert!(complete(&out) == before, "something was written");
    let left = fs::read_dir(&out).expect("it is there");
    let left = left.filter(|entry| {
        let name = entry.as_ref().expect("readable").file_name();
        name.to_str().expect("UTF-8").ends_with(".tmp")
    });
    assert_eq!(left.count(), 0, "a file that is not complete was left");
}

#[test]
fn a_full_standard_output_is_an_error() {
    let dir = scratch("stdout-full");
    let file = document(&dir, "x.md", STATEMENTS);
    let full = File::options().write(true).open("/dev/full").expect("Linux has it");
    let run = command().args(["audit", &file]).stdout(Stdio::from(full)).output();
    let run = finish(run.expect("the program starts"));
    assert_eq!(run.code, 2);
    assert!(run.stderr.starts_with("error: cannot print: "), "{}", run.stderr);
}

#[test]
fn a_read_only_directory_is_an_error() {
    let dir = scratch("read-only");
    let file = document(&dir, "x.md", STATEMENTS);
    // nobody, not even root, makes files there
    let run = kane(&["audit", &file, "--out", "/proc/self"]);
    assert_eq!((run.code, run.stdout.as_str()), (2, ""), "{}", run.stderr);
    assert!(run.stderr.starts_with("error: cannot write into /proc/self: "), "{}", run.stderr);
}

#[test]
fn a_reader_that_leaves_early_still_gets_its_files() {
    let dir = scratch("pipe");
    let file = document(&dir, "x.md", STATEMENTS);
    let out = dir.join("out");
    let mut child = command()
        .args(["audit", &file, "--out", out.to_str().expect("UTF-8")])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    drop(child.stdout.take());
    let run = finish(child.wait_with_output().expect("it ends"));
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    let other = dir.join("other");
    kane(&["audit", &file, "--out", other.to_str().expect("UTF-8")]);
    assert!(complete(&out) == complete(&other));
}

#[test]
fn runs_into_one_directory_at_a_time_leave_whole_files() {
    let dir = scratch("two-runs");
    let file = document(&dir, "x.md", STATEMENTS);
    let (out, alone) = (dir.join("out"), dir.join("alone"));
    kane(&["audit", &file, "--out", alone.to_str().expect("UTF-8")]);
    let start = |_| {
        let mut run = command();
        run.args(["audit", &file, "--out", out.to_str().expect("UTF-8")]);
        run.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program starts")
    };
    let runs: Vec<_> = (0..4).map(start).collect();
    for run in runs {
        let run = finish(run.wait_with_output().expect("it ends"));
        assert_eq!(run.code, 0, "{}", run.stderr);
    }
    assert!(complete(&out) == complete(&alone));
}

#[test]
fn a_run_that_is_killed_leaves_the_old_file_or_the_new_one() {
    let dir = scratch("killed");
    let file = document(&dir, "x.md", STATEMENTS);
    let (out, new) = (dir.join("out"), dir.join("new"));
    kane(&["audit", &file, "--out", new.to_str().expect("UTF-8")]);
    let new = complete(&new);
    let old = |text: &[u8]| {
        let text = String::from_utf8(text.to_vec()).expect("UTF-8");
        text.replace(env!("CARGO_PKG_VERSION"), "0.0.9").into_bytes()
    };
    let old: BTreeMap<_, _> = new.iter().map(|(name, text)| (name.clone(), old(text))).collect();
    let mut in_the_middle = 0;
    for files in 1..=new.len() {
        let _ = fs::remove_dir_all(&out);
        for (name, text) in &old {
            let path = out.join(name);
            fs::create_dir_all(path.parent().expect("it has one")).expect("writable");
            fs::write(path, text).expect("writable");
        }
        let mut child = command()
            .args(["audit", &file, "--out", out.to_str().expect("UTF-8")])
            .stdout(Stdio::null())
            .spawn()
            .expect("the program starts");
        // until so many files are on their way, or it is over
        let temporary = || {
            let entries = fs::read_dir(&out).expect("it is there").flatten();
            entries.filter(|entry| entry.path().extension().is_some_and(|e| e == "tmp")).count()
        };
        while child.try_wait().expect("it can be asked").is_none() && temporary() < files {}
        let _ = child.kill();
        child.wait().expect("it ends");
        in_the_middle += u32::from(temporary() > 0);
        let there = complete(&out);
        assert_eq!(there.len(), new.len());
        for (name, text) in &there {
            assert!(*text == old[name] || *text == new[name], "{name} is neither");
        }
        // and the next run is not hindered
        let again = kane(&["audit", &file, "--out", out.to_str().expect("UTF-8")]);
        assert_eq!(again.code, 0, "{}", again.stderr);
        assert!(complete(&out) == new);
    }
    assert!(in_the_middle > 0, "no run was killed while it wrote");
}
