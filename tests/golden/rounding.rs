//! The scripts by which Gappa proves bounds on rounding errors.

use std::collections::BTreeSet;
use std::path::Path;

use kane::measure::rounding_bounds;

use crate::assert_kept;

#[test]
fn the_committed_scripts_are_the_program_s() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/rounding");
    let mut names = BTreeSet::from(["README.md".to_owned()]);
    for bound in rounding_bounds() {
        let name = format!("{}.g", bound.name());
        assert_kept(&format!("docs/rounding/{name}"), &bound.gappa());
        names.insert(name);
    }
    let files = std::fs::read_dir(&folder).expect("the folder is committed");
    let present = files.map(|file| file.expect("a file").file_name().into_string().expect("UTF-8"));
    assert_eq!(present.collect::<BTreeSet<_>>(), names);
}
