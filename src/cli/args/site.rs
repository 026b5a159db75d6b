//! The grammar of `kane site`.

use std::path::PathBuf;

use clap::Args;

pub(super) const SITE_EXAMPLES: &str = "\
Examples:
  kane site --out site                    writes site/index.html and all that it leads to

The shipped derivations are audited, the laws held against every property, the paper's formulas \
examined, the shipped collisions and scenes answered, and methods timed, quickly. It takes under a \
minute; standard error says what takes how long. The site is read from the disk: pages load \
what they share from the folder `shared` beside them and nothing else, and all links are relative.

Exit codes:
  0  the site is written, whatever it says
  2  bad input or usage";

#[derive(Args, Debug)]
pub(crate) struct SiteArgs {
    /// The directory, which is made if need be; nothing in it that kane did not write is replaced
    #[arg(long, value_name = "DIR")]
    pub(crate) out: PathBuf,
}
