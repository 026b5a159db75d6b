//! What the program carries with it, so that neither a site nor a shipped name needs a checkout.

use std::path::Path;

use super::ids::near;

/// A shipped file: its name without an ending, and its text.
pub(super) struct Document {
    pub(super) stem: &'static str,
    pub(super) text: &'static str,
}

/// The shipped file of this name, if a bare word is one and no file of the user's is called so.
pub(super) fn named(word: &Path, among: &'static [Document]) -> Option<&'static Document> {
    let word = word.to_str().filter(|_| !word.exists())?;
    among.iter().find(|document| document.stem == word)
}

/// A hint for a file that is not there: a file beside it with a name like it, or a shipped one.
fn hint(missing: &Path, ending: &str, among: &[Document]) -> Option<String> {
    if missing.exists() {
        return None;
    }
    let wanted = missing.file_stem()?.to_str()?;
    let folder = missing.parent().unwrap_or(Path::new(""));
    let here = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let entries = std::fs::read_dir(here).into_iter().flatten().flatten().map(|e| e.path());
    let beside: Vec<String> = entries
        .filter(|path| path.extension().is_some_and(|it| it == ending))
        .filter_map(|path| Some(path.file_stem()?.to_str()?.to_owned()))
        .collect();
    if let Some(near) = near(wanted, beside.iter().map(String::as_str)).first() {
        let path = folder.join(format!("{near}.{ending}"));
        return Some(format!("did you mean `{}`?", path.display()));
    }
    let shipped = near(wanted, among.iter().map(|document| document.stem));
    match shipped.as_slice() {
        [] => None,
        near => Some(format!("did you mean `{}`, which is shipped?", near.join("` or `"))),
    }
}

/// What to say of a file that cannot be read.
pub(super) fn unreadable(path: &Path, error: &str, ending: &str, among: &[Document]) -> String {
    let hint = hint(path, ending, among).map(|hint| format!("; {hint}")).unwrap_or_default();
    format!("cannot read {}: {error}{hint}", path.display())
}

macro_rules! carried {
    ($folder:literal, $ending:literal: $($stem:literal),* $(,)?) => {
        [$(Document {
            stem: $stem,
            text: include_str!(concat!("../../docs/", $folder, "/", $stem, $ending)),
        }),*]
    };
}

/// The derivations, the paper's first.
pub(super) const DERIVATIONS: [Document; 18] = carried!("derivations", ".md":
    "oblique-collision", "answers-to-the-conditions", "coupled-collision", "spatial-sphere",
    "two-body-collision", "bouncing-ball", "sliding-to-rolling", "physical-pendulum", "kepler",
    "equal-forms", "free-top", "rolling-disc", "painleve-rod", "double-pendulum", "routh-diagram",
    "hertz", "billiard-ball", "collision-chain",
);

/// Collisions that are put to every law.
pub(super) const COLLISIONS: [Document; 4] = carried!("collisions", ".toml":
    "double-pendulum", "ellipse", "rod-tip", "two-spheres",
);

/// Scenes that are answered by the least model.
pub(super) const SCENES: [Document; 20] = carried!("scenes", ".toml":
    "paper-sphere", "alumina", "backspin", "rest", "superball", "two-spheres", "double-pendulum",
    "rod-jam", "cradle-touching", "cradle-apart", "discs", "tennis-clay", "table-tennis",
    "superball-groove", "putt", "squeezed", "dropped-rod", "tumbling-brick", "billiard-cushion",
    "cradle-in-space",
);

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn every_shipped_file_is_carried() {
        let root = concat!(env!("CARGO_MANIFEST_DIR"), "/docs");
        for (folder, ending, carried) in [
            ("derivations", "md", &DERIVATIONS[..]),
            ("collisions", "toml", &COLLISIONS[..]),
            ("scenes", "toml", &SCENES[..]),
        ] {
            let there = std::fs::read_dir(format!("{root}/{folder}")).expect("it is there");
            let paths = there.map(|entry| entry.expect("readable").path());
            let shipped = paths.filter(|path| path.extension().is_some_and(|e| e == ending));
            let stem = |path: std::path::PathBuf| {
                path.file_stem().expect("a name").to_string_lossy().into_owned()
            };
            let shipped: BTreeSet<String> = shipped.map(stem).collect();
            let carried: BTreeSet<String> = carried.iter().map(|d| d.stem.to_owned()).collect();
            assert_eq!(carried, shipped, "{folder}");
        }
    }
}
