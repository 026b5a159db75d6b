//! Writes what of the documentation is made from data. Run it, look at the difference, commit it.

use std::error::Error;
use std::fs;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
    for page in kane_pages::pages(root)? {
        let path = root.join(&page.path);
        if fs::read_to_string(&path).is_ok_and(|kept| kept == page.text) {
            continue;
        }
        fs::write(&path, &page.text)?;
        println!("{}", page.path);
    }
    Ok(())
}
