//! The files of `--out`: all of them or none, and none in place of what somebody else wrote.
//!
//! A file is written only where there is none yet, or one that this program wrote. It knows its own
//! by the mark that each form has: the program's name and version, in the place where that form has
//! them. Tables have no place for it; theirs is their first line, and that of a figure its size and
//! title. Symbolic links inside the directory are not followed.
//!
//! Each file is written beside its place, in full and to the disk, and only then put there, so that
//! a run that is interrupted leaves the old file or the new one. It may leave a `.NAME.PID.tmp`,
//! which the next run neither reads nor needs. Of two runs into one directory, the last one stays.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::fs::{self, File, Metadata};
use std::io::{self, Write as _};
use std::path::{Component, Path, PathBuf};

use kane::algebra::syntax::printable;
use thiserror::Error;

use super::packed;

/// What is to be written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Written {
    /// where, below the directory; what ends in `.gz` is packed
    pub(super) path: PathBuf,
    pub(super) text: String,
}

/// Why nothing was written.
#[derive(Debug, Error)]
pub(super) enum Refusal {
    #[error("cannot write {}: it is an input", .0.display())]
    Input(PathBuf),
    #[error(
        "cannot write {}: a file is there that kane did not write; move it away, or write elsewhere",
        .0.display()
    )]
    Foreign(PathBuf),
    #[error("cannot write {}: it is a symbolic link", .0.display())]
    Link(PathBuf),
    #[error("cannot write {}: something else is there", .0.display())]
    Occupied(PathBuf),
    #[error("cannot write {}: two reports would go there", .0.display())]
    Twice(PathBuf),
    #[error("cannot write into {}: {}", .0.display(), .1)]
    Failed(PathBuf, io::Error),
}

impl Written {
    pub(super) fn new(path: impl Into<PathBuf>, text: String) -> Self {
        Self { path: path.into(), text: printable(&text).into_owned() }
    }

    /// A picture, or other XML, that does not say in itself where it comes from.
    pub(super) fn picture(path: impl Into<PathBuf>, svg: &str) -> Self {
        Self::new(path, format!("{}\n<!-- {} -->\n", svg.trim_end(), mark()))
    }

    /// A page of the manual, under a comment that says where it comes from.
    pub(super) fn manual(path: impl Into<PathBuf>, roff: &str) -> Self {
        Self::new(path, format!(".\\\" {}\n{roff}", mark()))
    }

    /// A file for a judge, under a comment that says where it comes from.
    pub(super) fn question(path: impl Into<PathBuf>, text: &str) -> Self {
        let path = path.into();
        let first = match ending(&path) {
            "v" => format!("(* {} *)", mark()),
            "rs" | "c" => format!("// {}", mark()),
            "py" | "g" => format!("# {}", mark()),
            "css" | "js" => format!("/* {} */", mark()),
            _ => format!("; {}", mark()),
        };
        Self::new(path, format!("{first}\n{text}"))
    }

    /// What the file holds.
    pub(super) fn bytes(&self) -> Cow<'_, [u8]> {
        match ending(&self.path) {
            "gz" => Cow::Owned(packed::packed(self.text.as_bytes())),
            _ => Cow::Borrowed(self.text.as_bytes()),
        }
    }
}

/// The mark of files that have no other.
fn mark() -> String {
    format!("written by kane {}", env!("CARGO_PKG_VERSION"))
}

/// Writes all files into the directory, which is made if need be, after a look at all places.
///
/// # Errors
/// If one of them may not or cannot be written: then nothing is.
pub(super) fn write(dir: &Path, inputs: &[&Path], files: &[Written]) -> Result<(), Refusal> {
    let inputs: Vec<Metadata> =
        inputs.iter().filter_map(|input| fs::metadata(input).ok()).collect();
    let mut seen = BTreeSet::new();
    for file in files {
        if !seen.insert(&file.path) {
            return Err(Refusal::Twice(dir.join(&file.path)));
        }
        check(dir, &inputs, file)?;
    }
    let failed = |error| Refusal::Failed(dir.to_owned(), error);
    let mut temporary = Vec::new();
    let written = files.iter().try_for_each(|file| {
        let target = dir.join(&file.path);
        fs::create_dir_all(target.parent().unwrap_or(dir))?;
        let (beside, mut new) = beside(&target)?;
        temporary.push((beside, file));
        new.write_all(&file.bytes())?;
        // a disk may say only now that it is full
        new.sync_all()
    });
    let put = written
        .map_err(failed)
        .and_then(|()| temporary.iter().try_for_each(|(new, file)| put(dir, &inputs, new, file)));
    if put.is_err() {
        for (beside, _) in &temporary {
            let _ = fs::remove_file(beside);
        }
    }
    put
}

/// Looks at the directory and at one file of those that will be written, for a run that takes long to make them.
///
/// # Errors
/// If it is no directory and none can be made there, or the file may not be written.
pub(super) fn look(dir: &Path, first: &str) -> Result<(), Refusal> {
    let mut folders = dir.ancestors().filter(|place| !place.as_os_str().is_empty());
    let there = folders.find_map(|place| fs::metadata(place).ok());
    if there.is_some_and(|it| !it.is_dir()) {
        let error = io::Error::from(io::ErrorKind::NotADirectory);
        return Err(Refusal::Failed(dir.to_owned(), error));
    }
    check(dir, &[], &Written::new(first, String::new()))
}

/// A new file for the text until it is complete, which is nobody's and no link.
fn beside(target: &Path) -> io::Result<(PathBuf, File)> {
    let mut tries = 0_u32;
    loop {
        let mut name = std::ffi::OsString::from(".");
        name.push(target.file_name().unwrap_or_default());
        name.push(format!(".{}", std::process::id()));
        if tries > 0 {
            name.push(format!("-{tries}"));
        }
        name.push(".tmp");
        let path = target.with_file_name(name);
        match File::create_new(&path) {
            // left by a run that was interrupted and had this number
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists && tries < 1000 => {
                tries += 1;
            }
            made => return made.map(|file| (path, file)),
        }
    }
}

/// Puts a complete file in its place. What has come there since the look is looked at again: a link
/// of the file system is made only where nothing is.
fn put(dir: &Path, inputs: &[Metadata], new: &Path, file: &Written) -> Result<(), Refusal> {
    let target = dir.join(&file.path);
    if fs::hard_link(new, &target).is_ok() {
        let _ = fs::remove_file(new);
        return Ok(());
    }
    check(dir, inputs, file)?;
    fs::rename(new, &target).map_err(|error| Refusal::Failed(dir.to_owned(), error))
}

/// Whether the file may be written.
fn check(dir: &Path, inputs: &[Metadata], file: &Written) -> Result<(), Refusal> {
    let target = dir.join(&file.path);
    let mut place = dir.to_owned();
    let folders = file.path.parent().map(Path::components).into_iter().flatten();
    for folder in folders.filter(|part| matches!(part, Component::Normal(_))) {
        place.push(folder);
        match found(dir, &place)? {
            None => return Ok(()),
            Some(it) if it.is_symlink() => return Err(Refusal::Link(place)),
            Some(it) if it.is_dir() => {}
            Some(it) if inputs.iter().any(|input| same(input, &it)) => {
                return Err(Refusal::Input(place));
            }
            Some(_) => return Err(Refusal::Occupied(place)),
        }
    }
    // an input through a link is an input, too
    let at_end = fs::metadata(&target).ok();
    if at_end.is_some_and(|it| inputs.iter().any(|input| same(input, &it))) {
        return Err(Refusal::Input(target));
    }
    match found(dir, &target)? {
        None => Ok(()),
        Some(it) if it.is_symlink() => Err(Refusal::Link(target)),
        Some(it) if !it.is_file() => Err(Refusal::Occupied(target)),
        Some(_) => {
            let bytes = fs::read(&target).map_err(|e| Refusal::Failed(dir.to_owned(), e))?;
            if is_own(&file.path, &bytes, &file.text) {
                Ok(())
            } else {
                Err(Refusal::Foreign(target))
            }
        }
    }
}

/// What is at this place, links not followed.
fn found(dir: &Path, place: &Path) -> Result<Option<Metadata>, Refusal> {
    match fs::symlink_metadata(place) {
        Ok(it) => Ok(Some(it)),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(error) => Err(Refusal::Failed(dir.to_owned(), error)),
    }
}

/// Whether both are one file, whatever it is called.
#[cfg(unix)]
fn same(a: &Metadata, b: &Metadata) -> bool {
    use std::os::unix::fs::MetadataExt as _;
    (a.dev(), a.ino()) == (b.dev(), b.ino())
}

/// Whether both may be one file: this system does not say it, so that equal sizes and times have to do.
#[cfg(not(unix))]
fn same(a: &Metadata, b: &Metadata) -> bool {
    a.len() == b.len() && a.modified().ok() == b.modified().ok()
}

fn ending(path: &Path) -> &str {
    path.extension().and_then(|ending| ending.to_str()).unwrap_or_default()
}

/// Whether this program wrote what is there, in whatever version.
fn is_own(path: &Path, there: &[u8], new: &str) -> bool {
    if ending(path) == "gz" {
        let held = packed::unpacked(there);
        return held.is_some_and(|held| is_own(&path.with_extension(""), &held, new));
    }
    let Ok(there) = std::str::from_utf8(there) else { return false };
    let lines = |count| there.lines().take(count).eq(new.lines().take(count));
    let last = there.trim_end().lines().next_back().unwrap_or_default();
    match ending(path) {
        _ if there == new => true,
        "csv" => lines(1),
        "svg" => has_mark(there, ">\nkane ") || has_mark(last, "by kane ") || lines(5),
        "xml" => has_mark(last, "by kane "),
        "md" | "txt" => has_mark(&format!("\n{}", last.trim_start_matches('`')), "\nkane "),
        "html" => {
            has_mark(there, "<meta name=\"generator\" content=\"kane ")
                || has_mark(there, "<meta name=generator content=\"kane ")
        }
        "tex" => has_mark(there, "\\footnotesize kane "),
        // its schema, or the program, is named first
        "json" => there.lines().take(8).any(|line| line.contains("\": \"kane")),
        "1" | "v" | "smt2" | "rs" | "c" | "py" | "fpcore" | "css" | "js" => {
            has_mark(there.lines().next().unwrap_or_default(), "written by kane ")
        }
        _ => false,
    }
}

/// Whether a version follows these words.
fn has_mark(text: &str, words: &str) -> bool {
    let version = |rest: &str| {
        let end = rest.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(rest.len());
        rest.get(..end).is_some_and(|version| version.split('.').count() == 3)
    };
    text.match_indices(words).any(|(at, _)| text.get(at + words.len()..).is_some_and(version))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn own(name: &str, there: &str) -> bool {
        is_own(Path::new(name), there.as_bytes(), "law,finding\n1,2\n")
    }

    fn scratch(name: &str) -> PathBuf {
        let id = std::process::id();
        let dir = std::env::temp_dir().join(format!("kane-delivery-{name}-{id}"));
        let _ = fs::remove_dir_all(&dir);
        fs::create_dir_all(&dir).expect("a scratch directory");
        dir
    }

    #[test]
    fn what_came_between_the_look_and_the_writing_is_not_replaced() {
        let dir = scratch("between");
        let file = Written::new("a.md", "# A\n\nkane 0.1.0, `kane audit`\n".to_owned());
        let target = dir.join("a.md");
        check(&dir, &[], &file).expect("nothing is there");
        fs::write(&target, "mine\n").expect("writable");
        let (new, _) = beside(&target).expect("writable");
        let refused = put(&dir, &[], &new, &file);
        assert!(matches!(refused, Err(Refusal::Foreign(_))), "{refused:?}");
        assert_eq!(fs::read(&target).expect("it is there"), b"mine\n");
        fs::remove_dir_all(&dir).expect("it can be removed");
    }

    #[test]
    fn what_an_interrupted_run_left_is_in_nobody_s_way() {
        let dir = scratch("left");
        let (left, _) = beside(&dir.join("a.md")).expect("writable");
        let text = "# A\n\nkane 0.1.0, `kane audit`\n";
        write(&dir, &[], &[Written::new("a.md", text.to_owned())]).expect("it is written");
        assert_eq!(fs::read_to_string(dir.join("a.md")).expect("it is there"), text);
        assert!(left.exists(), "it may be another run's");
        fs::remove_dir_all(&dir).expect("it can be removed");
    }

    #[test]
    fn what_is_packed_is_known_by_what_it_holds() {
        let ours = packed::packed(b"(* written by kane 0.1.0 *)\n");
        assert!(is_own(Path::new("a.v.gz"), &ours, "new"));
        let theirs = packed::packed(b"Lemma mine : True.\n");
        assert!(!is_own(Path::new("a.v.gz"), &theirs, "new"));
        assert!(!is_own(Path::new("a.v.gz"), b"(* written by kane 0.1.0 *)\n", "new"));
    }

    #[test]
    fn every_form_is_known_by_its_mark_and_by_nothing_less() {
        for (name, there) in [
            ("a.md", "# Audit\n\n---\n\nkane 0.1.0, `kane audit`\n"),
            ("a.md", "# Scene\n\n`kane 0.9.12: kane scene`\n"),
            ("a.txt", "1 claim\n\nkane 0.1.0: kane laws\n"),
            ("a.html", "<head><meta name=\"generator\" content=\"kane 0.1.0\"></head>"),
            ("a.html", "<head><meta name=generator content=\"kane 0.1.0\"></head>"),
            ("a.tex", "\\hrule\n\\footnotesize kane 0.1.0: \\texttt{kane audit}"),
            ("a.json", "{\n  \"schema\": {\n    \"name\": \"kane-audit\",\n"),
            ("a.csv", "law,finding\n3,4\n"),
            ("a.svg", "<svg>\n<text>\nkane 0.1.0: kane laws\n</text>\n</svg>\n"),
            ("a.svg", "<svg>\n</svg>\n<!-- written by kane 0.1.0 -->\n"),
            ("a.xml", "<testsuites>\n</testsuites>\n<!-- written by kane 0.1.0 -->\n"),
            ("a.v", "(* written by kane 0.1.0 *)\n"),
            ("a.smt2", "; written by kane 0.1.0\n(check-sat)\n"),
            ("kane.1", ".\\\" written by kane 0.1.0\n.TH KANE 1\n"),
            ("a.css", "/* written by kane 0.1.0 */\np {}\n"),
        ] {
            assert!(own(name, there), "{name}: {there}");
        }
        for (name, there) in [
            ("a.md", "# Notes\n\nkane 0.1.0, `kane audit` says so.\n\nI do not think so.\n"),
            ("a.md", "# Notes on kane\n\nkane is quick\n"),
            ("a.md", ""),
            ("a.txt", "kane 0.1.0: kane laws\nand more of my own\n"),
            ("a.html", "<p>kane 0.1.0</p>"),
            ("a.tex", "\\documentclass{article}"),
            ("a.json", "{\n  \"name\": \"mine\"\n}"),
            ("a.csv", "time,speed\n"),
            ("a.csv", ""),
            ("a.svg", "<svg>\n</svg>\n"),
            ("a.xml", "<testsuites>\n</testsuites>\n"),
            ("a.v", "Lemma mine : True.\n"),
            ("a.smt2", "(check-sat)\n"),
            ("kane.1", ".TH KANE 1\n"),
            ("a", "kane 0.1.0: kane"),
        ] {
            assert!(!own(name, there), "{name}: {there}");
        }
    }
}
