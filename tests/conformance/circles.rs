//! No circle between the files of a crate: who reads one file reads downwards from there.
//!
//! A file knows another if it imports something that stands there, or names it by its path. Two things
//! are no knowledge: that a folder shows what its files have (`pub use`), and that a file uses what
//! stands at the head of its own folder (`super`).

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use crate::support::root;

/// The circles that are left, each by its files. The list may only get shorter.
const LEFT: [&str; 8] = [
    "audit: argument/expand argument/line argument/orthant",
    "audit: reader/citation reader/tie",
    "impact: bodies/double_pendulum frame law over",
    "judges: coq/prose coq/reify coq/slopes",
    "kernel: check derivative limit model normal state",
    "kernel: poly univariate",
    "measure: axis dyadic",
    "scene: choose impulse_plane picture strobe",
];

/// A file by the path of its module.
type Module = Vec<String>;

/// A crate's files, without comments, texts in quotes and tests.
struct Files(BTreeMap<Module, File>);

struct File {
    code: String,
    /// what it imports: the path, and whether it shows it to others
    imports: Vec<(Vec<String>, bool)>,
}

impl Files {
    fn of(folder: &Path) -> Self {
        let (mut files, mut todo) = (BTreeMap::new(), vec![folder.to_owned()]);
        while let Some(folder_or_file) = todo.pop() {
            if folder_or_file.is_dir() {
                let entries = fs::read_dir(&folder_or_file).expect("the source is there");
                todo.extend(entries.map(|entry| entry.expect("the source is readable").path()));
            } else if folder_or_file.extension().is_some_and(|extension| extension == "rs") {
                let inside = folder_or_file.strip_prefix(folder).expect("it is in the folder");
                let inside = inside.with_extension("");
                let mut module: Module =
                    inside.iter().map(|part| part.to_string_lossy().into_owned()).collect();
                if module.last().is_some_and(|last| ["mod", "lib", "main"].contains(&&**last)) {
                    module.pop();
                }
                let source = fs::read_to_string(&folder_or_file).expect("the source is UTF-8");
                let file = File::of(&code(&source));
                files.entry(module).or_insert(file);
            }
        }
        Self(files)
    }

    /// The file in which a path from `module` ends, if it is one of the crate.
    fn target(&self, module: &Module, path: &[String], depth: usize) -> Option<Module> {
        let first = path.first()?;
        let (mut at, mut rest) = match first.as_str() {
            "crate" => (Module::new(), &path[1..]),
            "self" => (module.clone(), &path[1..]),
            "super" => {
                let above = path.iter().take_while(|part| *part == "super").count();
                (module[..module.len().checked_sub(above)?].to_vec(), &path[above..])
            }
            _ if self.0.contains_key(&child(module, first)) => (module.clone(), path),
            _ => return None,
        };
        while let Some(next) = rest.first().map(|part| child(&at, part)) {
            if !self.0.contains_key(&next) {
                break;
            }
            (at, rest) = (next, &rest[1..]);
        }
        let file = self.0.get(&at)?;
        // what a folder shows of its files stands in the file
        let shown = rest.first().filter(|_| depth < 8).and_then(|name| {
            let mut imports =
                file.imports.iter().filter(|(path, shown)| *shown && path.last() == Some(name));
            imports.next().and_then(|(path, _)| self.target(&at, path, depth + 1))
        });
        Some(shown.unwrap_or(at))
    }

    fn known(&self) -> BTreeMap<&Module, BTreeSet<Module>> {
        let of = |(module, file): (&_, &File)| -> BTreeSet<Module> {
            let imports =
                file.imports.iter().filter(|(_, shown)| !shown).map(|(path, _)| path.clone());
            let targets =
                imports.chain(file.paths()).filter_map(|path| self.target(module, &path, 0));
            targets.filter(|target| !module.starts_with(target)).collect()
        };
        self.0.iter().map(|entry| (entry.0, of(entry))).collect()
    }
}

impl File {
    fn of(code: &str) -> Self {
        let (mut imports, mut after) = (Vec::new(), code);
        let mut code = String::new();
        while let Some(place) = import(after) {
            let (before, found) = after.split_at(place);
            let shown = before.trim_end().ends_with("pub") || before.trim_end().ends_with(')');
            let (text, others) = found.split_once(';').unwrap_or((found, ""));
            for path in paths(text.trim_start_matches("use ")) {
                imports.push((path, shown));
            }
            code.push_str(before);
            after = others;
        }
        code.push_str(after);
        Self { code, imports }
    }

    /// Paths that are written out where they are used.
    fn paths(&self) -> impl Iterator<Item = Vec<String>> {
        let apart = |c: char| !(c.is_alphanumeric() || c == '_' || c == ':');
        self.code
            .split(apart)
            .map(|path| path.trim_matches(':'))
            .filter(|path| path.contains("::"))
            .map(|path| path.split("::").map(str::to_owned).collect())
    }
}

fn child(module: &Module, name: &str) -> Module {
    module.iter().cloned().chain([name.to_owned()]).collect()
}

/// Where the next import begins, at the head of a statement.
fn import(code: &str) -> Option<usize> {
    let mut from = 0;
    loop {
        let at = from + code[from..].find("use ")?;
        let before = code[..at].trim_end();
        if before.is_empty()
            || before.ends_with([';', '}', '{', ']', ')'])
            || before.ends_with("pub")
        {
            return Some(at);
        }
        from = at + 1;
    }
}

/// `a::{b, c::d as e}` as `a::b` and `a::c::d`.
fn paths(tree: &str) -> Vec<Vec<String>> {
    let tree = tree.trim();
    if let Some((head, inside)) = tree.split_once('{') {
        let inside = inside.trim_end().strip_suffix('}').unwrap_or(inside);
        let (mut depth, mut start, mut parts) = (0_u32, 0, Vec::new());
        for (at, c) in inside.char_indices() {
            match c {
                '{' => depth += 1,
                '}' => depth -= 1,
                ',' if depth == 0 => {
                    parts.push(&inside[start..at]);
                    start = at + 1;
                }
                _ => {}
            }
        }
        parts.push(&inside[start..]);
        let parts = parts.into_iter().filter(|part| !part.trim().is_empty());
        return parts.flat_map(|part| paths(&format!("{head}{}", part.trim()))).collect();
    }
    let path = tree.split(" as ").next().unwrap_or_default();
    vec![path.split("::").map(|part| part.trim().to_owned()).filter(|part| part != "*").collect()]
}

/// Source without comments, texts in quotes, and the tests at its end.
fn code(source: &str) -> String {
    let source = source.split("#[cfg(test)]").next().unwrap_or_default();
    let mut out = String::new();
    for line in source.lines() {
        let line = line.split("//").next().unwrap_or_default();
        // every other piece between quotation marks is a text
        out.extend(line.split('"').step_by(2));
        out.push('\n');
    }
    out
}

/// The files that each file leads to, by any number of steps.
fn reached(known: &BTreeMap<&Module, BTreeSet<Module>>, from: &Module) -> BTreeSet<Module> {
    let (mut seen, mut todo) = (BTreeSet::new(), vec![from.clone()]);
    while let Some(module) = todo.pop() {
        for next in known.get(&module).into_iter().flatten() {
            if seen.insert(next.clone()) {
                todo.push(next.clone());
            }
        }
    }
    seen
}

/// The circles of a crate, each as its files.
fn circles(name: &str, folder: &Path) -> BTreeSet<String> {
    let files = Files::of(folder);
    let known = files.known();
    let reached: BTreeMap<&Module, _> =
        known.keys().map(|module| (*module, reached(&known, module))).collect();
    let mut found = BTreeSet::new();
    for (module, there) in &reached {
        let back = |other: &&Module| reached.get(*other).is_some_and(|of| of.contains(*module));
        let circle: Vec<String> = there.iter().filter(back).map(|other| other.join("/")).collect();
        if circle.len() > 1 {
            found.insert(format!("{name}: {}", circle.join(" ")));
        }
    }
    found
}

#[test]
fn files_that_know_each_other_are_known() {
    let mut found = circles("kane", &root().join("src"));
    for entry in fs::read_dir(root().join("crates")).expect("the crates are there") {
        let path = entry.expect("the folder is readable").path();
        let name = path.file_name().expect("a name").to_string_lossy().into_owned();
        found.extend(circles(&name, &path.join("src")));
    }
    let left: BTreeSet<String> = LEFT.iter().map(|&circle| circle.to_owned()).collect();
    let new: Vec<_> = found.difference(&left).collect();
    assert!(new.is_empty(), "new circles between files: {new:#?}");
    let gone: Vec<_> = left.difference(&found).collect();
    assert!(gone.is_empty(), "take these off the list, they are gone: {gone:#?}");
}

/// The check can fail: two files that import each other, one of them by what its folder shows.
#[test]
fn a_planted_circle_is_found() {
    let folder = std::env::temp_dir().join(format!("kane-circles-{}", std::process::id()));
    fs::create_dir_all(folder.join("room")).expect("a scratch folder");
    let write =
        |name: &str, text: &str| fs::write(folder.join(name), text).expect("it is writable");
    write("lib.rs", "mod room;\nmod other;\npub use room::Thing;\n");
    write("room/mod.rs", "mod inner;\npub use inner::Thing;\npub struct Head;\n");
    write(
        "room/inner.rs",
        "use super::Head;\nuse crate::other::Other; // and not crate::Thing\npub struct Thing;\n",
    );
    write("other.rs", "pub struct Other;\n");
    assert_eq!(circles("planted", &folder), BTreeSet::new());
    write("other.rs", "use std::fmt;\nuse crate::{\n    Thing,\n};\npub struct Other;\n");
    let found = circles("planted", &folder);
    fs::remove_dir_all(&folder).expect("it is ours");
    assert_eq!(found, BTreeSet::from(["planted: other room/inner".to_owned()]));
}
