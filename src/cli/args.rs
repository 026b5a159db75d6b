//! The command line's grammar.

use std::path::PathBuf;

use clap::builder::{PossibleValue, PossibleValuesParser};
use clap::{Args, Parser, Subcommand, ValueEnum};

use super::output::When;
use super::shell_args::{CompletionsArgs, ManArgs};

/// Checks the derivations and the arithmetic of collision laws.
#[derive(Debug, Parser)]
#[command(name = "kane", version, arg_required_else_help = true, after_help = EXIT)]
pub(crate) struct Cli {
    /// Colours: auto (on a terminal, unless NO_COLOR is set), always or never
    #[arg(
        long,
        global = true,
        value_enum,
        value_name = "WHEN",
        default_value_t = When::Auto,
        hide_possible_values = true,
        help_heading = "Everywhere"
    )]
    pub(crate) color: When,

    #[command(subcommand)]
    pub(crate) verb: Verb,
}

const EXIT: &str = "\
Exit codes:
  0  everything is as expected
  1  a claim or a check is not
  2  bad input or usage
  3  nothing could be checked";

const EXAMPLES: &str = "\
Examples:
  kane audit                              the paper, which the program carries with it
  kane audit --only 9                     one statement of it, by its label
  kane audit --explain 16                 its proof or witness, step by step
  kane audit - < notes.md                 a document from standard input
  kane audit notes.md --watch             again whenever it changes
  kane audit notes.md --out reports       writes reports/notes.html, .tex, .md and .json
  kane audit a.md b.md --format json      two documents, for programs
  kane audit --judges coq,z3              what a proof assistant and a solver say, too

A document is Markdown with blocks tagged `kane`. Every claim in it ends proved, refuted,
ill-defined, vacuous, unsupported or undecided; `expect` says what its author thinks.

Exit codes:
  0  everything is as expected
  1  a claim is not, or another judge disagrees
  2  bad input or usage
  3  no document has a claim, or a judge is not installed";

const DRAFT_EXAMPLES: &str = "\
Examples:
  kane draft paper.tex > paper.md         a document to go on from
  kane draft paper.tex > paper.md && kane audit paper.md
                                          what follows from what, as far as the guesses go

Every equation stands in the draft as printed and under its number. Those that can be read are
statements; the others are quoted with the reason, which standard error lists, too. Which of them are
premises, what a claim rests on, and the ranges of symbols are guesses from the words around them.
docs/draft.md says how, and what is read.

Exit codes:
  0  every equation is read
  1  some are not
  2  bad input or usage
  3  there is no displayed equation";

pub(super) const COLLIDE_EXAMPLES: &str = "\
Examples:
  kane collide --sphere 7/2 --speed 3.9 --angle 20 --mu 0.092 --e 0.98
                                    all laws, for a solid sphere at 20° from the normal
  kane collide --body hoop --vx 1/3 --vy -1 --spin 2 --mu 0.1 --e 1/2
                                    another body, exact velocities
  kane collide --sphere 7/2 --speed 3.9 --angle 20 --mu 0.092 --e 0.98 --law smith-1991
                                    one law: every quantity, exactly and in floats
  kane collide --sphere 7/2 --speed 1 --half-tangent 1/3 --mu 0.5 --e 1 --param walton.beta0=0.3
                                    an exact direction, cos = 4/5; a law's own parameter
  kane collide docs/collisions/double-pendulum.toml
                                    other bodies, from a file; see docs/collide-format.md
";

pub(super) const COLLIDE_EXIT: &str = "\
Exit codes:
  0  there is an answer
  1  a check of the law asked for fails
  2  bad input or usage
  3  no law has an outcome";

const CHART_EXAMPLES: &str = "\
Examples:
  kane chart --quick                      a first look, in some seconds
  kane chart --out charts                 also writes charts/chart.html, .svg, .csv and more
  kane chart docs/examples/roots.fpcore   formulas of your own, repaired and in every number system
  kane chart --growth                     how cost grows with rows, bounces, variables and degree
  kane chart --figures --out figures      draws what the laws say: figures/*.svg, data in *.csv

A method is a form of a law in a number system. Its error is that at the worst of some hundred
inputs, alpha from 2^-30 to 2^30, against the exact value; its time is the median of several
rounds in which all methods take turns. A warning says where the clock contradicts the costs that
are counted in docs/data/methods.csv.

With a file: each formula as given, with fused operations, and repaired, in f32, f64, double-double,
intervals and fractions, where these have answers. The inputs are the same for all forms: drawn over
the ranges, and the worst that a search finds. Files are called NAME-prices.

With --growth: what a row costs by the number of rows in a batch; how an exact chain of bounces
grows, and how many digits floats and intervals keep in it; what a claim costs the audit by its
variables and its degree, and where it stays undecided. Files are called growth.

With --figures: k, i_x and the effective friction over alpha under all laws, with measured points and
the elastic half-space; by how much models miss the half-space; where Kane's pendulum gains energy.
Nothing is timed, and the files are the same in every run.";

const STABILITY_EXAMPLES: &str = "\
Examples:
  kane stability                          the paper, and the equal forms that the program knows
  kane stability notes.md                 the formulas of a document of yours
  kane stability docs/examples/roots.fpcore
                                          formulas in FPCore
  kane stability notes.md --range alpha=1/1000..1000 --range e=0..1
                                          over ranges of your own
  kane stability --out maps               also writes maps/oblique-collision-stability.html,
                                          .svg, .csv and more

A formula is evaluated as written, in f32 and in f64, over its domain: one input along the floats of
either sign, two that are not negative on a plane, all others at points that are searched for the
worst. What cannot be evaluated is listed with the reason. A formula fails where it returns NaN, an
infinity, 0 or the wrong sign though the exact value is otherwise, or where more than half of its bits
are wrong. Ranges end at representable numbers.

Where the document leaves an input's range open, it ends at 1e6 in magnitude, and that of a positive
input begins at 1e-6; --range says otherwise, and --full-line goes on to the ends of the format.

For a file of yours, every formula has a rigorous bound on its round-off beside the worst input that was
found, and where digits are lost, equal forms that lose less, proved equal; --out writes the best of
them as Rust, C, Python and FPCore. docs/floats.md says how.

Exit codes:
  0  the formulas are examined, whatever is found
  2  bad input or usage
  3  the document has no formula";

pub(super) const LAWS_EXAMPLES: &str = "\
Examples:
  kane laws                               every law against every property
  kane laws --law smith-1991              one row of it
  kane laws --property energy             one column
  kane laws --explain kane-levinson:energy
                                          the proof or the witness of one cell
  kane laws --out reports                 also writes reports/laws.html, .txt, .md and .json, and
                                          the picture reports/matrix.svg with its data, .csv

A cell is proved, with certificates that the kernel accepted; or refuted, by an exact contact that
it accepted too; or not applicable, or undecided, with the reason. docs/properties.md says what
each property asks.
";

pub(super) const LAWS_EXIT: &str = "\
Exit codes:
  0  every cell is decided, whatever is found
  1  a cell is undecided
  2  bad input or usage";

pub(super) const SCENE_EXAMPLES: &str = "\
Examples:
  kane scene docs/scenes/backspin.toml           the answer by the least model, and why that one
  kane scene docs/scenes/rest.toml --out out     also writes out/rest.html, .json, .md, -motion.svg,
                                                 -ledger.svg, -states.csv and -models.csv
  kane scene docs/scenes/backspin.toml --model whittaker-uncapped
                                                 by another model, with its error
  kane scene docs/scenes/two-spheres.toml --compare
                                                 every model that applies, by cost and error

A scene says what collides, what is asked and how accurately; see docs/scene-format.md.";

pub(super) const SCENE_EXIT: &str = "\
Exit codes:
  0  the model shown is good enough; the report says whether by a bound, as documented, or by an
     estimate
  1  it is not known to be
  2  bad input or usage
  3  it has no answer";

const CHECK_EXAMPLES: &str = "\
Examples:
  kane check impacts.csv                  what the log follows, in a sentence, and every check
  kane check impacts.jsonl --out reports  also writes reports/impacts-check.html, .svg and more
  kane check - < impacts.csv              a log from standard input
  kane check --schema                     the columns, with their units
  kane check log.csv --preset mujoco      columns called qvel[0] before, qvel[1] before, ...
  kane check log.csv --map vx1_pre_m_s=speed_in
                                          a column by another name
  kane check log.csv --row 17             the collision of line 17, for kane collide
  kane check --generate > sweep.csv       impacts for an engine to run, that tell laws apart
  kane check new.csv --baseline old.csv   whether a new version does worse
  kane check log.csv --format junit       every check as a test, for continuous integration

A log has one row an impact: mass, inertia (or radius and shape), arm (or radius), velocity and spin
before and after; mu, e, the time step and more if they are known. See docs/records.md.

Exit codes:
  0  every check holds, or fails as a published law that gives every row has it; with --baseline,
     nothing is worse than before
  1  a check fails, a row is rejected, or units are suspected; with --baseline, something is worse
  2  bad input or usage
  3  no row could be checked";

const SITE_EXAMPLES: &str = "\
Examples:
  kane site --out site                    writes site/index.html and all that it leads to

The shipped derivations are audited, the laws held against every property, the paper's formulas
examined, the shipped collisions and scenes answered, and methods timed, quickly. It takes under a
minute; standard error says what takes how long. The site is read from the disk: no page loads
anything, and all links are relative.

Exit codes:
  0  the site is written, whatever it says
  2  bad input or usage";

#[derive(Debug, Subcommand)]
pub(crate) enum Verb {
    /// Judge every statement of derivation documents
    #[command(after_help = EXAMPLES)]
    Audit(AuditArgs),
    /// Make a draft of a derivation document from a paper in LaTeX or Markdown
    #[command(after_help = DRAFT_EXAMPLES)]
    Draft(DraftArgs),
    /// Hold every law against every property that mechanics asks of it
    Laws(LawsArgs),
    /// Put one collision to every law, exactly and in floats
    Collide(Box<CollideArgs>),
    /// Chart speed against accuracy: what the next digit costs
    #[command(after_help = CHART_EXAMPLES)]
    Chart(ChartArgs),
    /// Find where the formulas of a derivation document fail in floating point
    #[command(after_help = STABILITY_EXAMPLES)]
    Stability(StabilityArgs),
    /// Answer a scene by the least model that is good enough
    Scene(SceneArgs),
    /// Check a log of impacts row by row, and name the law that it follows
    #[command(after_help = CHECK_EXAMPLES)]
    Check(CheckArgs),
    /// Make a site of every report: an index that says what they come to, four pictures, and a page each
    #[command(after_help = SITE_EXAMPLES)]
    Site(SiteArgs),
    /// Answer an editor while a derivation document is written
    #[command(after_help = super::lsp::ABOUT)]
    Lsp(super::lsp::LspArgs),
    /// Print the completions of a shell
    #[command(after_help = super::shell_args::COMPLETIONS)]
    Completions(CompletionsArgs),
    /// Print a manual page, or write all of them
    #[command(after_help = super::shell_args::MAN)]
    Man(ManArgs),
}

/// Another judge of claims.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum JudgeName {
    /// a proof assistant: every certificate as a Coq proof
    Coq,
    /// a solver: every claim's opposite as polynomial conditions
    Z3,
}

#[derive(Args, Debug)]
pub(crate) struct AuditArgs {
    /// Documents to audit, `-` for standard input; a shipped one by its name; without one, the paper on oblique collisions
    #[arg(value_name = "FILE")]
    pub(crate) files: Vec<PathBuf>,

    /// Also write every form of each report, and its claims for Coq and SMT-LIB, into this directory
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,

    /// How to print the report
    #[arg(long, value_enum, default_value_t = AuditFormat::Text)]
    pub(crate) format: AuditFormat,

    /// Put the claims to other judges too, which have to be installed
    #[arg(
        long,
        value_enum,
        value_delimiter = ',',
        value_name = "JUDGE",
        conflicts_with = "explain"
    )]
    pub(crate) judges: Vec<JudgeName>,

    /// Go on without the judges that are not installed
    #[arg(long, requires = "judges")]
    pub(crate) optional: bool,

    /// Show the statement with this label alone; may be repeated
    #[arg(long, value_name = "LABEL")]
    pub(crate) only: Vec<String>,

    /// Coefficient operations that one search may take before its claim is undecided [default: 40000000]
    ///
    /// With fewer, the number of states and of functions that are tried shrinks in the same measure.
    #[arg(long, value_name = "OPERATIONS")]
    pub(crate) budget: Option<u64>,

    /// Multiply every budget, of states, operations, functions and squares, by this number
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=1_000_000))]
    pub(crate) effort: Option<u64>,

    /// Print the proof or the witness of the statement with this label, step by step; may be repeated
    #[arg(long, value_name = "LABEL", conflicts_with_all = ["format", "only", "out"])]
    pub(crate) explain: Vec<String>,

    /// Judge again whenever a file changes, until Ctrl-C or the end of piped input
    #[arg(long)]
    pub(crate) watch: bool,
}

#[derive(Args, Debug)]
pub(crate) struct DraftArgs {
    /// The paper: LaTeX, or Markdown if its name ends in `.md`; `-` for LaTeX from standard input
    #[arg(value_name = "FILE")]
    pub(crate) file: PathBuf,
}

#[derive(Args, Debug)]
pub(crate) struct LawsArgs {
    /// Only the law of this id; may be repeated
    #[arg(long, value_name = "ID")]
    pub(crate) law: Vec<String>,

    /// Only the property of this id; may be repeated
    #[arg(long, value_name = "ID")]
    pub(crate) property: Vec<String>,

    /// How to print the report
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub(crate) format: Format,

    /// Also write every form of the report, and the picture with its data, into this directory
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,

    /// Print the proof or the witness of one cell, step by step
    #[arg(long, value_name = "LAW:PROPERTY", conflicts_with_all = ["format", "law", "property", "out"])]
    pub(crate) explain: Option<String>,
}

#[derive(Args, Debug)]
pub(crate) struct CollideArgs {
    /// A collision in a file, or the name of a shipped one, instead of the flags below
    #[arg(value_name = "FILE.toml")]
    pub(crate) file: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) body: BodyArgs,

    /// Show one law, by its id in the table: every quantity, its errors in floats, source and checks
    #[arg(long, value_name = "ID", help_heading = "Report")]
    pub(crate) law: Option<String>,

    /// Give a law's own parameter another value; may be repeated
    #[arg(long, value_name = "LAW.NAME=VALUE", help_heading = "Report")]
    pub(crate) param: Vec<String>,

    /// How to print the report
    #[arg(long, value_enum, default_value_t = Format::Text, help_heading = "Report")]
    pub(crate) format: Format,

    /// Also write NAME.html, .txt, .md, .tex and .json into this directory
    #[arg(long, value_name = "DIR", help_heading = "Report")]
    pub(crate) out: Option<PathBuf>,
}

/// A round body on a fixed plane. Every value is text here, to be read as an exact number.
#[derive(Args, Debug, Default)]
#[command(next_help_heading = "A round body meets a fixed plane")]
pub(crate) struct BodyArgs {
    /// The mobility ratio j_p = 1 + m*r^2/J, above 1: 7/2 for a solid sphere
    #[arg(long, value_name = "J_P", allow_hyphen_values = true)]
    pub(crate) sphere: Option<String>,

    /// The shape in a word, instead: sphere, hollow-sphere, disc or hoop
    #[arg(long, value_name = "SHAPE")]
    pub(crate) body: Option<String>,

    /// Coulomb's coefficient of friction, at least 0
    #[arg(long, value_name = "MU", allow_hyphen_values = true)]
    pub(crate) mu: Option<String>,

    /// The coefficient of normal restitution, from 0 to 1
    #[arg(long, value_name = "E", allow_hyphen_values = true)]
    pub(crate) e: Option<String>,

    /// The speed of the centre, m/s; with --angle or --half-tangent
    #[arg(long, value_name = "V", allow_hyphen_values = true)]
    pub(crate) speed: Option<String>,

    /// Its direction from the normal, degrees between -90 and 90
    #[arg(long, value_name = "DEG", allow_hyphen_values = true)]
    pub(crate) angle: Option<String>,

    /// The tangent of half that angle, between -1 and 1, for an exact direction
    #[arg(long, value_name = "T", allow_hyphen_values = true)]
    pub(crate) half_tangent: Option<String>,

    /// The velocity along the plane, m/s, instead of a speed [default: 0]
    #[arg(long, value_name = "V", allow_hyphen_values = true)]
    pub(crate) vx: Option<String>,

    /// The velocity away from the plane, m/s, at most 0
    #[arg(long, value_name = "V", allow_hyphen_values = true)]
    pub(crate) vy: Option<String>,

    /// The angular velocity from x to y, rad/s; positive spin moves the contact point along x, so that the slip is vx + spin*radius [default: 0]
    #[arg(long, value_name = "W", allow_hyphen_values = true)]
    pub(crate) spin: Option<String>,

    /// kg [default: 1]
    #[arg(long, value_name = "M", allow_hyphen_values = true)]
    pub(crate) mass: Option<String>,

    /// m [default: 1]
    #[arg(long, value_name = "R", allow_hyphen_values = true)]
    pub(crate) radius: Option<String>,
}

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

    /// Also write NAME-stability.html, .txt, .md, .tex, .json, .csv and .svg into this directory
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,

    /// How to print the report
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub(crate) format: Format,
}

#[derive(Args, Debug)]
pub(crate) struct SceneArgs {
    /// The scene: a file, or the name of a shipped one
    #[arg(value_name = "FILE.toml")]
    pub(crate) file: PathBuf,

    /// Answer by this model instead of the least good one: NAME or NAME/SYSTEM
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

#[derive(Args, Debug)]
pub(crate) struct CheckArgs {
    /// The log, CSV or JSON lines (.jsonl, .ndjson, .json); - for standard input
    #[arg(value_name = "LOG", required_unless_present_any = ["schema", "generate"])]
    pub(crate) log: Option<PathBuf>,

    /// Print the columns of a log, and stop
    #[arg(long, conflicts_with_all = ["log", "generate"])]
    pub(crate) schema: bool,

    /// Print a sweep of impacts that would tell laws apart, as CSV for an engine to run, and stop
    #[arg(long, conflicts_with = "log")]
    pub(crate) generate: bool,

    /// Whose names the columns have, where these say nothing by themselves; --map goes before
    #[arg(long, value_name = "NAME", value_parser = PossibleValuesParser::new(presets()))]
    pub(crate) preset: Option<String>,

    /// What a column of the schema is called in the log; may be repeated
    #[arg(long, value_name = "OURS=THEIRS")]
    pub(crate) map: Vec<String>,

    /// The log is JSON lines, whatever its name
    #[arg(long)]
    pub(crate) jsonl: bool,

    /// In which format the numbers were computed, if they do not tell: f32, f64 or a count of decimals
    #[arg(long, value_name = "FORMAT")]
    pub(crate) float: Option<String>,

    /// How far coordinates reach in the engine's world, in contact arms; 0 if the normal and the arm do not come from positions
    #[arg(long, value_name = "ARMS", default_value_t = kane::records::tolerance::EXTENT)]
    pub(crate) extent: f64,

    /// Print the collision of this line as a file for kane collide, and stop
    #[arg(long, value_name = "LINE")]
    pub(crate) row: Option<u64>,

    /// Compare with an older log: exit code 1 if a check or the law does worse
    #[arg(long, value_name = "OLD")]
    pub(crate) baseline: Option<PathBuf>,

    /// How to print the report
    #[arg(long, value_enum, default_value_t = CheckFormat::Text)]
    pub(crate) format: CheckFormat,

    /// Also write NAME-check.html, .txt, .md, .tex, .json, .svg and .xml (JUnit) into this directory
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
}

/// The names of presets, with whose they are.
fn presets() -> impl Iterator<Item = PossibleValue> {
    kane::records::preset::PRESETS
        .iter()
        .map(|preset| PossibleValue::new(preset.name).help(preset.of))
}

#[derive(Args, Debug)]
pub(crate) struct SiteArgs {
    /// The directory, which is made if need be; nothing in it that kane did not write is replaced
    #[arg(long, value_name = "DIR")]
    pub(crate) out: PathBuf,
}

/// How the report on documents is printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum AuditFormat {
    /// for people: the news, then a line each
    Text,
    /// for programs; the schemas are in docs
    Json,
    /// for the web
    Markdown,
    /// for editors and scanners of code: every claim beside its line, in SARIF 2.1.0
    Sarif,
    /// for a step of a GitHub workflow: what is not proved, beside its line
    Github,
}

/// How the report on a log is printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum CheckFormat {
    /// for people: the news, then a line each
    Text,
    /// for programs; the schemas are in docs
    Json,
    /// for the web
    Markdown,
    /// for continuous integration: each check as a test of JUnit's XML
    Junit,
    /// for editors and scanners of code: every check beside its worst row, in SARIF 2.1.0
    Sarif,
    /// for a step of a GitHub workflow: what fails, beside its row
    Github,
}

/// How a report is printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// for people: the news, then a line each
    Text,
    /// for programs; the schemas are in docs
    Json,
    /// for the web
    Markdown,
}
