//! The grammar of `kane scene`.

use std::path::PathBuf;

use clap::Args;

use super::Format;

pub(crate) const SCENE_EXAMPLES: &str = "\
Examples:
  kane scene backspin                     a shipped one: by the least model that will do, and why
  kane scene scene.toml                   one of your own
  kane scene rest --out out               also writes out/rest.html, .json, .md, -motion.svg,
                                          -ledger.svg, -states.csv and -models.csv
  kane scene backspin --model whittaker-uncapped
                                          by another model, with its error
  kane scene two-spheres --compare        every model that applies, by cost and error

A scene says what collides, what is asked and how accurately; see docs/scene-format.md.";

pub(crate) const SCENE_EXIT: &str = "\
Exit codes:
  0  the model shown is good enough; the report says whether by a bound, as documented, or by an
     estimate
  1  it is not known to be
  2  bad input or usage
  3  it has no answer";

#[derive(Args, Debug)]
pub(crate) struct SceneArgs {
    /// The scene: a file, or the name of a shipped one
    #[arg(value_name = "FILE.toml")]
    pub(crate) file: PathBuf,

    /// Answer by this model instead of the least good one: NAME, which is in f64, or NAME/SYSTEM,
    /// with f32, f64, double-double, interval or rational
    #[arg(long, value_name = "MODEL")]
    pub(crate) model: Option<String>,

    /// Try every model that applies, and chart error against cost
    #[arg(long)]
    pub(crate) compare: bool,

    /// Also write the report, the pictures and all states into this directory
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,

    /// How to print the report
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub(crate) format: Format,
}
