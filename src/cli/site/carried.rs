//! What the program carries with it, so that a site needs no checkout.

/// A shipped file: its name without an ending, and its text.
pub(super) struct Document {
    pub(super) stem: &'static str,
    pub(super) text: &'static str,
}

macro_rules! carried {
    ($folder:literal, $ending:literal: $($stem:literal),* $(,)?) => {
        [$(Document {
            stem: $stem,
            text: include_str!(concat!("../../../docs/", $folder, "/", $stem, $ending)),
        }),*]
    };
}

/// The derivations, the paper's first.
pub(super) const DERIVATIONS: [Document; 12] = carried!("derivations", ".md":
    "oblique-collision", "answers-to-the-conditions", "coupled-collision", "spatial-sphere",
    "two-body-collision", "bouncing-ball", "sliding-to-rolling", "physical-pendulum", "kepler",
    "equal-forms", "free-top", "rolling-disc",
);

/// Collisions that are put to every law.
pub(super) const COLLISIONS: [Document; 4] = carried!("collisions", ".toml":
    "double-pendulum", "ellipse", "rod-tip", "two-spheres",
);

/// Scenes that are answered by the least model.
pub(super) const SCENES: [Document; 16] = carried!("scenes", ".toml":
    "paper-sphere", "alumina", "backspin", "rest", "superball", "two-spheres", "double-pendulum",
    "rod-jam", "cradle-touching", "cradle-apart", "discs", "tennis-clay", "table-tennis",
    "superball-groove", "putt", "squeezed",
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
