//! The grammar of `kane chart` and `kane stability`.

use std::path::PathBuf;

use clap::Args;

use super::Format;

pub(super) const CHART_EXAMPLES: &str = "\
Examples:
  kane chart --quick                      a first look, in some seconds
  kane chart --out charts                 also writes charts/chart.html, .svg, .csv and more
  kane chart formulas.fpcore              formulas of your own, repaired and in every number system
  kane chart --growth                     how cost grows with rows, bounces, variables and degree
  kane chart --figures --out figures      draws what the laws say: figures/*.svg, data in *.csv

A method is a form of a law in a number system. Its error is that at the worst of some hundred \
inputs, alpha from 2^-30 to 2^30, against the exact value; its time is the median of several \
rounds in which all methods take turns. A warning says where the clock contradicts the costs that \
are counted in docs/data/methods.csv.

With a file: each formula as given, with fused operations, and repaired, in f32, f64, double-double, \
intervals and fractions, where these have answers. The inputs are the same for all forms: drawn over \
the ranges, and the worst that a search finds. Files are called NAME-prices.

With --growth: what a row costs by the number of rows in a batch; how an exact chain of bounces \
grows, and how many digits floats and intervals keep in it; what a claim costs the audit by its \
variables and its degree, and where it stays undecided. Files are called growth.

With --figures: k, i_x and the effective friction over alpha under all laws, with measured points and \
the elastic half-space; by how much models miss the half-space; where Kane's pendulum gains energy. \
Nothing is timed, and the files are the same in every run.

Exit codes:
  0  the chart or the figures are made, whatever they show
  2  bad input or usage
  3  the file has no formula";

pub(super) const STABILITY_EXAMPLES: &str = "\
Examples:
  kane stability                          the paper, and the equal forms that the program knows
  kane stability notes.md                 the formulas of a document of yours
  kane stability formulas.fpcore          formulas in FPCore
  kane stability notes.md --range u=1/1000..1000 --range e=0..1
                                          over ranges of your own
  kane stability --out maps               also writes maps/oblique-collision-stability.html,
                                          .svg, .csv and more

A formula is evaluated as written, in f32 and in f64, over its domain: one input along the floats of \
either sign, two that are not negative on a plane, all others at points that are searched for the \
worst. What cannot be evaluated is listed with the reason. A formula fails where it returns NaN, an \
infinity, 0 or the wrong sign though the exact value is otherwise, or where more than half of its bits \
are wrong. Ranges end at representable numbers.

Where the document leaves an input's range open, it ends at 1e6 in magnitude, and that of a positive \
input begins at 1e-6; --range says otherwise, and --full-line goes on to the ends of the format.

For a file of yours, every formula has a rigorous bound on its round-off beside the worst input that was \
found, and where digits are lost, equal forms that lose less, proved equal; --out writes the best of \
them as Rust, C, Python and FPCore. docs/floats.md says how.

Exit codes:
  0  the formulas are examined, whatever is found
  2  bad input or usage
  3  the file has no formula";

#[derive(Args, Debug)]
pub(crate) struct ChartArgs {
    /// A document, or FPCore in a file called .fpcore: its formulas and their repairs in every number system;
    /// without one, the paper's forms
    #[arg(value_name = "FILE", conflicts_with_all = ["growth", "figures"])]
    pub(crate) file: Option<PathBuf>,

    /// Examine an input of the file from here to there: alpha=1/1000..1000; may be repeated
    #[arg(long, value_name = "NAME=FROM..TO", allow_hyphen_values = true, requires = "file")]
    pub(crate) range: Vec<String>,

    /// Follow inputs of the file whose range is left open to the least and the greatest float
    #[arg(long, requires = "file")]
    pub(crate) full_line: bool,

    /// Fewer and shorter rounds
    #[arg(long)]
    pub(crate) quick: bool,

    /// How cost grows with size, instead of what the next digit costs
    #[arg(long)]
    pub(crate) growth: bool,

    /// The figures instead: laws over alpha with measured points, model error, Kane's puzzle
    #[arg(long, conflicts_with_all = ["quick", "growth", "format"])]
    pub(crate) figures: bool,

    /// Also write chart.html, .txt, .md, .tex, .json, .csv and .svg into this directory, or NAME-prices.*,
    /// growth.*, or the figures
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,

    /// How to print the table
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub(crate) format: Format,
}

#[derive(Args, Debug)]
pub(crate) struct StabilityArgs {
    /// A document, or FPCore in a file called .fpcore; without one, the paper on oblique collisions
    #[arg(value_name = "FILE")]
    pub(crate) file: Option<PathBuf>,

    /// Examine an input from here to there: alpha=1/1000..1000; may be repeated
    #[arg(long, value_name = "NAME=FROM..TO", allow_hyphen_values = true)]
    pub(crate) range: Vec<String>,

    /// Follow inputs whose range is left open to the least and the greatest float
    #[arg(long)]
    pub(crate) full_line: bool,

    /// Bound errors for inputs that are real numbers, rounded to the format first
    #[arg(long)]
    pub(crate) rounded_inputs: bool,

    /// Also write NAME-stability.html, .txt, .md, .tex, .json and .csv, and as .svg what can be drawn, into this
    /// directory
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,

    /// How to print the report
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub(crate) format: Format,
}
