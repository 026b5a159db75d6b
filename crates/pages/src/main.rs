//! Writes what of the documentation is made from data. Run it, look at the difference, commit it.
//!
//! With `--times MACHINE` it first times the methods anew, and keeps that under the machine's name: nothing else that
//! it writes depends on a clock.

use std::error::Error;
use std::fs;
use std::path::Path;

use kane_pages::{TIMES, times_now};

fn main() -> Result<(), Box<dyn Error>> {
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
    let mut arguments = std::env::args().skip(1);
    if arguments.next().as_deref() == Some("--times") {
        let machine = arguments.next().ok_or("--times needs the machine in words")?;
        fs::write(root.join(TIMES), times_now(machine))?;
        println!("{TIMES}");
    }
    for page in kane_pages::pages(root)? {
        let path = root.join(&page.path);
        if fs::read_to_string(&path).is_ok_and(|kept| kept == page.text) {
            continue;
        }
        if let Some(folder) = path.parent() {
            fs::create_dir_all(folder)?;
        }
        fs::write(&path, &page.text)?;
        println!("{}", page.path);
    }
    Ok(())
}
