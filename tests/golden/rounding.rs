//! The scripts by which Gappa proves bounds on rounding errors.

use std::collections::BTreeSet;
use std::path::Path;

use kane::measure::rounding_bounds;
use kane::report::gappa;

#[test]
fn the_committed_scripts_are_the_program_s() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/rounding");
    let mut names = BTreeSet::from(["README.md".to_owned()]);
    for bound in rounding_bounds() {
        let name = format!("{}.g", bound.name());
        let (path, script) = (folder.join(&name), gappa(&bound));
        if std::env::var_os("KANE_WRITE_DOCS").is_some() {
            std::fs::write(&path, &script).expect("the checkout is writable");
        }
        let kept = std::fs::read_to_string(&path).unwrap_or_default();
        assert!(
            kept == script,
            "docs/rounding/{name} is stale; write it by\n  KANE_WRITE_DOCS=1 cargo test --test golden rounding"
        );
        names.insert(name);
    }
    let files = std::fs::read_dir(&folder).expect("the folder is committed");
    let present = files.map(|file| file.expect("a file").file_name().into_string().expect("UTF-8"));
    assert_eq!(present.collect::<BTreeSet<_>>(), names);
}
